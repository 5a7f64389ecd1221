//! An indexed triangle mesh: what the geometry formats write and read.

use crate::splats::whole;
use crate::{Error, Result};

const FORMAT: &str = "mesh";

/// An indexed triangle mesh with one normal and one texture coordinate a vertex.
///
/// Positions are metres, Z up; normals are unit vectors; texture coordinates have their origin at the lower-left corner
/// of the image, v up; triangles are counter-clockwise seen from the front. The three vertex arrays have one length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    pub positions: Vec<[f64; 3]>,
    pub normals: Vec<[f32; 3]>,
    pub uvs: Vec<[f32; 2]>,
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The smallest axis-aligned box (min, max) around all vertices, `None` without any.
    pub fn bounds(&self) -> Option<([f64; 3], [f64; 3])> {
        let first = *self.positions.first()?;
        Some(self.positions.iter().fold((first, first), |(lo, hi), p| {
            (std::array::from_fn(|a| lo[a].min(p[a])), std::array::from_fn(|a| hi[a].max(p[a])))
        }))
    }

    /// Checks what every writer relies on: arrays of one length, finite numbers, indices in range.
    ///
    /// # Errors
    /// [`Error::Unsupported`] naming the first vertex or triangle that breaks the rule.
    pub fn validate(&self) -> Result<()> {
        let refuse = |what: String| Err(Error::Unsupported { format: FORMAT, what });
        let count = self.positions.len();
        if self.normals.len() != count || self.uvs.len() != count {
            return refuse(format!(
                "one normal and one texture coordinate a vertex are needed, found {count} positions, {} normals, {} \
                 texture coordinates",
                self.normals.len(),
                self.uvs.len()
            ));
        }
        // All at once first: most meshes have nothing to name.
        let finite = self.positions.as_flattened().iter().fold(true, |all, x| all & x.is_finite())
            & whole(self.normals.as_flattened())
            & whole(self.uvs.as_flattened());
        let highest = self.triangles.as_flattened().iter().copied().max();
        if finite && highest.is_none_or(|v| (v as usize) < count) {
            return Ok(());
        }
        if let Some(i) = self.positions.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
            return refuse(format!("position {i} is not finite: {:?}", self.positions[i]));
        }
        if let Some(i) = self.normals.iter().position(|n| !n.iter().all(|x| x.is_finite())) {
            return refuse(format!("normal {i} is not finite: {:?}", self.normals[i]));
        }
        if let Some(i) = self.uvs.iter().position(|uv| !uv.iter().all(|x| x.is_finite())) {
            return refuse(format!("texture coordinate {i} is not finite: {:?}", self.uvs[i]));
        }
        if let Some(i) = self.triangles.iter().position(|t| t.iter().any(|&v| v as usize >= count)) {
            return refuse(format!("triangle {i} names vertices {:?}, but there are only {count}", self.triangles[i]));
        }
        Ok(())
    }

    /// Where u grows, at right angles to each vertex's normal, length 1; then the sign that makes cross(normal, tangent)
    /// point where v grows. The area-weighted mean of the triangles around the vertex.
    pub fn tangents(&self) -> Vec<[f32; 4]> {
        let mut sums = vec![[[0.0f64; 3]; 2]; self.positions.len()];
        for t in &self.triangles {
            let [a, b, c] = t.map(|v| self.positions[v as usize]);
            let [p, q, r] = t.map(|v| self.uvs[v as usize].map(f64::from));
            let (e, f): ([f64; 3], [f64; 3]) =
                (std::array::from_fn(|i| b[i] - a[i]), std::array::from_fn(|i| c[i] - a[i]));
            let (du, dv) = ([q[0] - p[0], r[0] - p[0]], [q[1] - p[1], r[1] - p[1]]);
            let turned = (du[0] * dv[1] - du[1] * dv[0]).signum();
            // The gradients of position by u and v, times the triangle's area in the texture.
            let by_u: [f64; 3] = std::array::from_fn(|i| turned * (e[i] * dv[1] - f[i] * dv[0]));
            let by_v: [f64; 3] = std::array::from_fn(|i| turned * (f[i] * du[0] - e[i] * du[1]));
            let area = dot(face_normal([a, b, c]), face_normal([a, b, c])).sqrt();
            for v in t {
                for (sum, by) in sums[*v as usize].iter_mut().zip([by_u, by_v]) {
                    let along = unit(by);
                    if dot(by, by) > 0.0 {
                        *sum = std::array::from_fn(|i| sum[i] + area * f64::from(along[i]));
                    }
                }
            }
        }
        let one = |([by_u, by_v], normal): (&[[f64; 3]; 2], &[f32; 3])| {
            let n = normal.map(f64::from);
            let flat = |v: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| v[i] - dot(v, n) * n[i]) };
            let mut along = flat(*by_u);
            if dot(along, along) < 1e-24 {
                along = flat(if n[0].abs() < 0.9 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] });
            }
            let sign = if dot(cross(n, along), *by_v) < 0.0 { -1.0 } else { 1.0 };
            let [x, y, z] = unit(along);
            [x, y, z, sign]
        };
        sums.iter().zip(&self.normals).map(one).collect()
    }
}

/// The area-weighted mean of the triangles around each vertex, length 1; up where there is no direction.
pub fn smooth_normals(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Vec<[f32; 3]> {
    let mut sums = vec![[0.0; 3]; positions.len()];
    for t in triangles {
        let normal = face_normal(t.map(|v| positions[v as usize]));
        for v in t {
            let sum: &mut [f64; 3] = &mut sums[*v as usize];
            *sum = std::array::from_fn(|c| sum[c] + normal[c]);
        }
    }
    sums.into_iter().map(unit).collect()
}

/// The normal of a counter-clockwise triangle, as long as twice its area.
pub fn face_normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let edge = |to: [f64; 3]| std::array::from_fn(|i| to[i] - a[i]);
    cross(edge(b), edge(c))
}

/// The unit vector, or up where there is no direction.
pub fn unit(v: [f64; 3]) -> [f32; 3] {
    let length = dot(v, v).sqrt();
    if length > 0.0 && length.is_finite() { v.map(|x| (x / length) as f32) } else { [0.0, 0.0, 1.0] }
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> Mesh {
        Mesh {
            positions: vec![[0.0, 0.0, 0.0], [2.0, 0.0, -1.0], [0.0, 3.0, 0.5]],
            normals: vec![[0.0, 0.0, 1.0]; 3],
            uvs: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2]],
        }
    }

    #[test]
    fn tangents_point_where_u_grows_and_their_sign_where_v_does() {
        let flat = Mesh {
            positions: vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]],
            normals: vec![[0.0, 0.0, 1.0]; 3],
            uvs: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2]],
        };
        assert_eq!(flat.tangents(), [[1.0, 0.0, 0.0, 1.0]; 3]);
        // u and v exchanged: mirrored in the texture.
        let mirrored = Mesh { uvs: vec![[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]], ..flat.clone() };
        assert_eq!(mirrored.tangents(), [[0.0, 1.0, 0.0, -1.0]; 3]);
        // No area in the texture: some direction along the surface.
        let none = Mesh { uvs: vec![[0.5; 2]; 3], ..flat };
        assert!(none.tangents().iter().all(|t| t[2] == 0.0 && (t[0].hypot(t[1]) - 1.0).abs() < 1e-6));
    }

    #[test]
    fn bounds_enclose_every_vertex() {
        assert_eq!(Mesh::default().bounds(), None);
        assert_eq!(triangle().bounds(), Some(([0.0, 0.0, -1.0], [2.0, 3.0, 0.5])));
    }

    #[test]
    fn validation_names_the_fault() {
        assert_eq!(triangle().validate(), Ok(()));
        let mut m = triangle();
        m.triangles.push([0, 1, 3]);
        assert!(m.validate().unwrap_err().to_string().contains("triangle 1 names vertices [0, 1, 3]"));
        let mut m = triangle();
        m.positions[2][1] = f64::NAN;
        assert!(m.validate().unwrap_err().to_string().contains("position 2 is not finite"));
        let mut m = triangle();
        m.normals[1][0] = f32::INFINITY;
        assert!(m.validate().unwrap_err().to_string().contains("normal 1 is not finite"));
        let mut m = triangle();
        m.uvs[0][0] = f32::NAN;
        assert!(m.validate().unwrap_err().to_string().contains("texture coordinate 0 is not finite"));
        let mut m = triangle();
        m.uvs.pop();
        assert!(m.validate().unwrap_err().to_string().contains("3 positions, 3 normals, 2 texture"));
    }
}
