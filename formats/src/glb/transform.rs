//! Transformations of nodes.

use super::json::Node;
use crate::mesh::{cross, dot};

/// Columns of a 4 × 4 matrix without its last row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform([[f64; 3]; 4]);

impl Transform {
    pub const NONE: Self = Self([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]]);

    pub fn of(node: &Node) -> Self {
        if let Some(m) = node.matrix {
            return Self(std::array::from_fn(|c| std::array::from_fn(|r| m[c * 4 + r])));
        }
        let [x, y, z, w] = node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]);
        let s = node.scale.unwrap_or([1.0; 3]);
        let axes = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)],
            [2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)],
            [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)],
        ];
        let scaled = |i: usize| axes[i].map(|a| a * s[i]);
        Self([scaled(0), scaled(1), scaled(2), node.translation.unwrap_or([0.0; 3])])
    }

    /// This one first, then `outer`.
    pub fn then(&self, outer: &Self) -> Self {
        let [x, y, z, t] = self.0;
        Self([outer.vector(x), outer.vector(y), outer.vector(z), outer.point(t)])
    }

    pub fn vector(&self, p: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|r| (0..3).map(|c| self.0[c][r] * p[c]).sum())
    }

    pub fn point(&self, p: [f64; 3]) -> [f64; 3] {
        let v = self.vector(p);
        std::array::from_fn(|i| v[i] + self.0[3][i])
    }

    pub fn mirrors(&self) -> bool {
        let [x, y, z, _] = self.0;
        dot(cross(x, y), z) < 0.0
    }

    /// Through the cofactors, to length 1; up where there is no direction.
    pub fn normal(&self, n: [f64; 3]) -> [f64; 3] {
        let [x, y, z, _] = self.0;
        let cofactors = [cross(y, z), cross(z, x), cross(x, y)];
        let sign = if self.mirrors() { -1.0 } else { 1.0 };
        let v: [f64; 3] = std::array::from_fn(|r| sign * (0..3).map(|c| cofactors[c][r] * n[c]).sum::<f64>());
        let length = dot(v, v).sqrt();
        if length > 1e-30 && length.is_finite() { v.map(|a| a / length) } else { [0.0, 1.0, 0.0] }
    }
}
