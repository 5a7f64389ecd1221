//! A level set of the opacity field: the other way from Gaussians to a surface, kept for comparison with [`super::fuse`]
//! (`orb bench mesh`), which was closer to true meshes (`docs/model.md`).
//!
//! At each sample of a grid the opacities of all Gaussians are added up, Σ oᵢ exp(−½ mᵢ²) with m the Mahalanobis
//! distance; where the sum passes `level` is the surface (after Guédon & Lepetit, "SuGaR", 2024, §4, and Yu et al.,
//! "Gaussian Opacity Fields", 2024, without their ray-wise minimum).

use glam::{Mat3, Quat, Vec3};
use rayon::prelude::*;

use super::fuse::Volume;
use super::{SUBJECT_RADIUS, Surface, clean, extract};
use crate::splat::Gaussians;

/// The best of 0.05, 0.1, 0.15, 0.2, 0.3, 0.6, 1 on the built-in network's Gaussians.
pub const LEVEL: f32 = 0.15;
/// Gaussians reach this many standard deviations.
const REACH: f32 = 3.0;

/// The closed surface at `level`, cleaned as a fused volume is; `voxels` as in [`super::Options`].
pub fn surface(g: &Gaussians, voxels: usize, level: f32) -> Surface {
    let mut volume = field(g, voxels, level);
    clean::fill_cavities(&mut volume);
    clean::keep_what_belongs(&mut volume);
    clean::flatten_ground(&mut volume);
    extract::extract(&volume)
}

fn field(g: &Gaussians, voxels: usize, level: f32) -> Volume {
    let inside = |p: &Vec3| p.length() < SUBJECT_RADIUS;
    let (lo, hi) = g
        .positions
        .iter()
        .filter(|p| inside(p))
        .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(lo, hi), &p| (lo.min(p), hi.max(p)));
    let (lo, hi) = if lo.is_finite() { (lo - 0.05, hi + 0.05) } else { (Vec3::splat(-0.1), Vec3::splat(0.1)) };
    let extent = hi - lo;
    let voxel = ((extent.x * extent.y * extent.z).cbrt() / voxels as f32).max(extent.max_element() / 512.0);
    let dims = (extent / voxel).to_array().map(|e| e.ceil() as usize + 1);
    let mut sums = vec![0f32; dims[0] * dims[1] * dims[2]];
    let slice = dims[0] * dims[1];
    // Each slab of slices is one task's own.
    let slab = 4;
    let rotations: Vec<Mat3> = g
        .rotations
        .iter()
        .map(|q| Mat3::from_quat(Quat::from_xyzw(q[1], q[2], q[3], q[0]).normalize()).transpose())
        .collect();
    sums.par_chunks_mut(slice * slab).enumerate().for_each(|(chunk, sums)| {
        let (z0, z1) = (chunk * slab, (chunk * slab + sums.len() / slice).min(dims[2]));
        for (i, r) in rotations.iter().enumerate() {
            let scale = g.log_scales[i].exp();
            let opacity = 1.0 / (1.0 + (-g.logit_opacities[i]).exp());
            let center = (g.positions[i] - lo) / voxel;
            // Half the box: the norm of each row of R diag(s).
            let half = Vec3::from_array(std::array::from_fn(|k| REACH * (r.col(k) * scale).length() / voxel));
            if !(center.is_finite() && half.is_finite())
                || center.z + half.z < z0 as f32
                || center.z - half.z > z1 as f32
            {
                continue;
            }
            let from = (center - half).ceil().max(Vec3::ZERO);
            let to = (center + half).floor();
            let range = |k: usize| from[k] as usize..((to[k] + 1.0).max(0.0) as usize).min(dims[k]);
            for z in range(2).start.max(z0)..range(2).end.min(z1) {
                for y in range(1) {
                    for x in range(0) {
                        let d = (Vec3::new(x as f32, y as f32, z as f32) - center) * voxel;
                        let m = ((r * d) / scale).length_squared();
                        if m < REACH * REACH {
                            sums[(z - z0) * slice + y * dims[0] + x] += opacity * (-0.5 * m).exp();
                        }
                    }
                }
            }
        }
    });
    let truncation = 3.0 * voxel;
    let rim = |i: usize| {
        let at = [i % dims[0], i / dims[0] % dims[1], i / slice];
        (0..3).any(|k| at[k] == 0 || at[k] + 1 == dims[k])
    };
    let data = sums
        .iter()
        .enumerate()
        .map(|(i, s)| if rim(i) { truncation } else { truncation * (1.0 - s / level).clamp(-1.0, 1.0) })
        .collect();
    Volume { origin: lo, voxel, dims, truncation, data, noise: 0.0 }
}
