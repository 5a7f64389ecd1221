//! A set of Gaussians, structure of arrays.

use glam::{Mat3, Quat, Vec3};

use super::sh_rotation;

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
        let bands = sh_rotation::Bands::new(rotation);
        for sh in &mut out.sh {
            bands.turn(sh);
        }
        out
    }

    /// Those for which `keep(index)` holds, in order.
    pub fn filtered(&self, keep: impl Fn(usize) -> bool) -> Self {
        let kept: Vec<usize> = (0..self.len()).filter(|i| keep(*i)).collect();
        Gaussians {
            positions: kept.iter().map(|i| self.positions[*i]).collect(),
            log_scales: kept.iter().map(|i| self.log_scales[*i]).collect(),
            rotations: kept.iter().map(|i| self.rotations[*i]).collect(),
            logit_opacities: kept.iter().map(|i| self.logit_opacities[*i]).collect(),
            sh: kept.iter().map(|i| self.sh[*i]).collect(),
        }
    }

    /// Those at least this opaque (0..1) and with finite parameters only.
    pub fn pruned(&self, min_opacity: f32) -> Self {
        let least = (min_opacity / (1.0 - min_opacity)).ln();
        self.filtered(|i| {
            let finite = self.positions[i].is_finite()
                && self.log_scales[i].is_finite()
                && self.rotations[i].iter().all(|v| v.is_finite())
                && self.sh[i].iter().flatten().all(|v| v.is_finite());
            finite && self.logit_opacities[i] >= least
        })
    }

    /// `other` added at the end.
    pub fn extend(&mut self, other: &Gaussians) {
        self.positions.extend_from_slice(&other.positions);
        self.log_scales.extend_from_slice(&other.log_scales);
        self.rotations.extend_from_slice(&other.rotations);
        self.logit_opacities.extend_from_slice(&other.logit_opacities);
        self.sh.extend_from_slice(&other.sh);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splat::render::tests::{camera, scene};
    use crate::splat::{Camera, render};

    #[test]
    fn a_turned_scene_looks_the_same_from_a_turned_camera() {
        let g = scene(120, 0.08, 3);
        let c = camera(60, 50);
        let turn = Mat3::from_quat(Quat::from_euler(glam::EulerRot::ZYX, 0.7, -1.1, 2.3));
        let (scale, shift) = (1.7, Vec3::new(3.0, -2.0, 0.5));
        let turned = g.transformed(turn, scale, shift);
        // p' = s R p + t, so s (W p + w) = W Rᵀ p' − W Rᵀ t + s w.
        let rotation = c.rotation * turn.transpose();
        let moved = Camera { rotation, translation: c.translation * scale - rotation * shift, ..c };
        let (a, b) = (render(&g, &c, [0.1; 3]), render(&turned, &moved, [0.1; 3]));
        let worst = a.color.iter().zip(&b.color).flat_map(|(a, b)| (0..3).map(|k| (a[k] - b[k]).abs()));
        // One skipped contribution of 1/255 may fall the other way.
        assert!(worst.fold(0.0, f32::max) < 4.5e-3);
        let mean: f32 = a.color.iter().zip(&b.color).map(|(a, b)| (a[0] - b[0]).abs()).sum::<f32>() / 3000.0;
        assert!(mean < 1e-5, "{mean}");
    }

    #[test]
    fn filter_and_extend_undo_each_other() {
        let g = scene(10, 0.1, 4);
        let mut joined = g.filtered(|i| i < 4);
        joined.extend(&g.filtered(|i| i >= 4));
        assert_eq!(joined, g);
        let mut faint = g.clone();
        faint.logit_opacities[3] = -9.0;
        faint.positions[5].x = f32::NAN;
        assert_eq!(faint.pruned(0.005).len(), g.pruned(0.005).len() - 2);
    }
}
