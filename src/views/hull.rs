//! The visual hull of six views: the largest body that all six silhouettes allow, as Gaussians on its surface.
//!
//! A. Laurentini, "The visual hull concept for silhouette-based image understanding", PAMI 1994.

use glam::Vec3;

use super::six_views;
use super::tile::View;
use crate::splat::{Camera, Gaussians, SH_C0};

/// Cells along an edge of the grid.
const CELLS: usize = 72;
/// Half the grid's edge: what a view at distance 4 with 30° shows.
const REACH: f32 = 1.1;

/// Position of a cell's centre.
fn centre(i: usize) -> Vec3 {
    let [x, y, z] = [i % CELLS, i / CELLS % CELLS, i / CELLS / CELLS];
    let at = |k: usize| ((k as f32 + 0.5) / CELLS as f32 * 2.0 - 1.0) * REACH;
    Vec3::new(at(x), at(y), at(z))
}

/// Pixel of a point, where it is in the picture.
fn pixel(camera: &Camera, p: Vec3) -> Option<usize> {
    let q = camera.rotation * p + camera.translation;
    let (x, y) = (camera.fx * q.x / q.z + camera.cx, camera.fy * q.y / q.z + camera.cy);
    let inside = q.z > 0.0 && x >= 0.0 && y >= 0.0 && x < camera.width as f32 && y < camera.height as f32;
    inside.then(|| y as usize * camera.width as usize + x as usize)
}

/// The hull's surface; empty where the silhouettes have nothing in common.
///
/// A cell's colour is that of the view that looks at it most squarely, by the hull's own normal.
pub fn hull(views: &[View]) -> Gaussians {
    let cameras = six_views(views.first().map_or(320, |v| v.alpha.width as u32));
    let full: Vec<bool> = (0..CELLS.pow(3))
        .map(|i| {
            let p = centre(i);
            cameras.iter().zip(views).all(|(c, v)| pixel(c, p).is_some_and(|k| v.alpha.data[k] > 0.5))
        })
        .collect();
    let at = |i: usize, axis: usize, forward: bool| {
        let (stride, k) = (CELLS.pow(axis as u32), i / CELLS.pow(axis as u32) % CELLS);
        let inside = if forward { k + 1 < CELLS } else { k > 0 };
        inside && full[if forward { i + stride } else { i - stride }]
    };
    let mut g = Gaussians::default();
    let size = 2.0 * REACH / CELLS as f32;
    for i in (0..full.len()).filter(|i| full[*i]) {
        let normal: [f32; 3] =
            std::array::from_fn(|a| f32::from(u8::from(at(i, a, false))) - f32::from(u8::from(at(i, a, true))));
        let open = (0..3).any(|a| !at(i, a, true) || !at(i, a, false));
        if !open {
            continue;
        }
        let (p, normal) = (centre(i), Vec3::from_array(normal).normalize_or(centre(i).normalize_or_zero()));
        let facing = |c: &Camera| (c.position() - p).normalize().dot(normal);
        let best = cameras.iter().zip(views).max_by(|a, b| facing(a.0).total_cmp(&facing(b.0)));
        let colour = best.and_then(|(c, v)| pixel(c, p).map(|k| v.colour[k])).unwrap_or([0.5; 3]);
        g.positions.push(p);
        g.log_scales.push(Vec3::splat((0.6 * size).ln()));
        g.rotations.push([1.0, 0.0, 0.0, 0.0]);
        g.logit_opacities.push(2.0);
        let mut sh = [[0.0; 3]; 16];
        sh[0] = colour.map(|v| (v - 0.5) / SH_C0);
        g.sh.push(sh);
    }
    g
}
