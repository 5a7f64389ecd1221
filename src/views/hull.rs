//! The visual hull of six views: the largest body that all six silhouettes allow.
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

/// A body of cells.
pub struct Hull {
    full: Vec<bool>,
}

/// Position of a cell's centre.
fn centre(i: usize) -> Vec3 {
    let [x, y, z] = [i % CELLS, i / CELLS % CELLS, i / CELLS / CELLS];
    let at = |k: usize| ((k as f32 + 0.5) / CELLS as f32 * 2.0 - 1.0) * REACH;
    Vec3::new(at(x), at(y), at(z))
}

/// Pixel of a point, where it is in the picture: column, row.
pub fn pixel(camera: &Camera, p: Vec3) -> Option<(usize, usize)> {
    let q = camera.rotation * p + camera.translation;
    let (x, y) = (camera.fx * q.x / q.z + camera.cx, camera.fy * q.y / q.z + camera.cy);
    let inside = q.z > 0.0 && x >= 0.0 && y >= 0.0 && x < camera.width as f32 && y < camera.height as f32;
    inside.then_some((x as usize, y as usize))
}

impl Hull {
    /// Of six views; empty where their silhouettes have nothing in common.
    pub fn of(views: &[View]) -> Hull {
        let cameras = six_views(views.first().map_or(320, |v| v.alpha.width as u32));
        let allowed =
            |p: Vec3| cameras.iter().zip(views).all(|(c, v)| pixel(c, p).is_some_and(|(x, y)| v.alpha.at(x, y) > 0.5));
        Hull { full: (0..CELLS.pow(3)).map(|i| allowed(centre(i))).collect() }
    }

    /// Centres of its cells.
    pub fn cells(&self) -> Vec<Vec3> {
        (0..self.full.len()).filter(|i| self.full[*i]).map(centre).collect()
    }

    /// Without the cells that `keep` refuses.
    pub fn carved(&self, keep: impl Fn(Vec3) -> bool) -> Hull {
        Hull { full: self.full.iter().enumerate().map(|(i, full)| *full && keep(centre(i))).collect() }
    }

    /// Its surface as Gaussians; a cell's colour is that of the view that looks at it most squarely, by the hull's own normal.
    pub fn surface(&self, views: &[View]) -> Gaussians {
        let cameras = six_views(views.first().map_or(320, |v| v.alpha.width as u32));
        let neighbour = |i: usize, axis: usize, forward: bool| {
            let stride = CELLS.pow(axis as u32);
            let k = i / stride % CELLS;
            let inside = if forward { k + 1 < CELLS } else { k > 0 };
            inside && self.full[if forward { i + stride } else { i - stride }]
        };
        let mut g = Gaussians::default();
        let size = 2.0 * REACH / CELLS as f32;
        for i in (0..self.full.len()).filter(|i| self.full[*i]) {
            let sides: [[bool; 2]; 3] = std::array::from_fn(|a| [neighbour(i, a, false), neighbour(i, a, true)]);
            if sides.iter().flatten().all(|full| *full) {
                continue;
            }
            let outwards = sides.map(|[before, after]| f32::from(u8::from(before)) - f32::from(u8::from(after)));
            let p = centre(i);
            let normal = Vec3::from_array(outwards).normalize_or(p.normalize_or_zero());
            let facing = |c: &Camera| (c.position() - p).normalize().dot(normal);
            let best = cameras.iter().zip(views).max_by(|a, b| facing(a.0).total_cmp(&facing(b.0)));
            let colour = best.and_then(|(c, v)| pixel(c, p).map(|(x, y)| v.colour[y * v.alpha.width + x]));
            g.positions.push(p);
            g.log_scales.push(Vec3::splat((0.6 * size).ln()));
            g.rotations.push([1.0, 0.0, 0.0, 0.0]);
            g.logit_opacities.push(2.0);
            let mut sh = [[0.0; 3]; 16];
            sh[0] = colour.unwrap_or([0.5; 3]).map(|v| (v - 0.5) / SH_C0);
            g.sh.push(sh);
        }
        g
    }
}
