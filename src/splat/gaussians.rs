//! A set of Gaussians, structure of arrays.

use glam::{Mat3, Quat, Vec3};

/// Coefficients a colour channel at degree 3.
pub const SH_COEFFICIENTS: usize = 16;
/// Y_0^0 = 1 / (2 √π): colour = `SH_C0` · f_dc + 0.5.
pub const SH_C0: f32 = 0.282_094_8;

/// All arrays have the same length N.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gaussians {
    pub positions: Vec<Vec3>,
    /// Natural logarithm of the standard deviations along the local axes.
    pub log_scales: Vec<Vec3>,
    /// w, x, y, z; need not be normalised.
    pub rotations: Vec<[f32; 4]>,
    /// Opacity before the sigmoid.
    pub logit_opacities: Vec<f32>,
    /// Basis-major: `sh[n][basis][rgb]`, degree 3.
    pub sh: Vec<[[f32; 3]; SH_COEFFICIENTS]>,
}

impl Gaussians {
    pub fn len(&self) -> usize {
        self.positions.len()
    }
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// p → scale · rotation · p + translation, shapes and degree-0 colours with it.
    ///
    /// Bands ≥ 1 of the spherical harmonics are turned too, so views stay the same.
    pub fn transformed(&self, rotation: Mat3, scale: f32, translation: Vec3) -> Self {
        let mut out = self.clone();
        let turn = Quat::from_mat3(&rotation);
        for p in &mut out.positions {
            *p = scale * (rotation * *p) + translation;
        }
        for s in &mut out.log_scales {
            *s += Vec3::splat(scale.ln());
        }
        for q in &mut out.rotations {
            let local = Quat::from_xyzw(q[1], q[2], q[3], q[0]);
            let r = turn * local;
            *q = [r.w, r.x, r.y, r.z];
        }
        out
    }
}
