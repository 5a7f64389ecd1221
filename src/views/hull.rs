//! The visual hull of silhouettes: the largest body that all of them allow.
//!
//! A. Laurentini, "The visual hull concept for silhouette-based image understanding", PAMI 1994.

use glam::Vec3;
use rayon::prelude::*;

use super::six_views;
use super::tile::View;
use crate::photo::Plane;
use crate::splat::{Camera, Gaussians, SH_C0};

/// Cells along an edge of the grid.
const CELLS: usize = 72;
/// An edge of a cell.
pub const CELL: f32 = 2.0 * REACH / CELLS as f32;
/// Half the grid's edge: what a view at distance 4 with 30° shows.
const REACH: f32 = 1.1;

/// What one camera says of the body.
#[derive(Clone, Copy)]
pub struct Silhouette<'a> {
    pub camera: Camera,
    /// The camera's picture, row-major.
    pub colour: &'a [[f32; 3]],
    /// Subject, 0..1, a value a pixel.
    pub mask: &'a Plane,
    /// Left, top, right and bottom of what is known, in the picture's pixels: there is nothing of the subject between the
    /// picture and this, and nothing is known further out.
    pub known: [f32; 4],
}

impl Silhouette<'_> {
    /// Whether a point may belong to the body; `None` where this camera says nothing of it.
    pub fn allows(&self, p: Vec3) -> Option<bool> {
        if let Some((x, y)) = pixel(&self.camera, p) {
            return Some(self.mask.at(x, y) > 0.5);
        }
        let c = &self.camera;
        let q = c.rotation * p + c.translation;
        let (x, y) = (c.fx * q.x / q.z + c.cx, c.fy * q.y / q.z + c.cy);
        let [left, top, right, bottom] = self.known;
        (q.z > 0.0 && x >= left && y >= top && x < right && y < bottom).then_some(false)
    }
}

/// Silhouettes of six views; nothing of the subject lies outside them.
fn of_views<'a>(views: &'a [View]) -> Vec<Silhouette<'a>> {
    const ALL: [f32; 4] = [f32::NEG_INFINITY, f32::NEG_INFINITY, f32::INFINITY, f32::INFINITY];
    let cameras = six_views(views.first().map_or(320, |v| v.alpha.width as u32));
    let one = |(camera, v): (Camera, &'a View)| Silhouette { camera, colour: &v.colour, mask: &v.alpha, known: ALL };
    cameras.into_iter().zip(views).map(one).collect()
}

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
        Hull::carve(&of_views(views), 0.0)
    }

    /// Of the cells that two cameras at least see, and that all but this share of them allow.
    pub fn carve(silhouettes: &[Silhouette], tolerated: f32) -> Hull {
        let allowed = |i: usize| {
            let p = centre(i);
            let (seen, refused) = silhouettes
                .iter()
                .filter_map(|s| s.allows(p))
                .fold((0, 0), |(seen, refused), allows| (seen + 1, refused + u32::from(!allows)));
            seen >= 2 && refused as f32 <= tolerated * seen as f32
        };
        Hull { full: (0..CELLS.pow(3)).into_par_iter().map(allowed).collect() }
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
        self.skin(&of_views(views))
    }

    /// The same of any silhouettes.
    pub fn skin(&self, silhouettes: &[Silhouette]) -> Gaussians {
        let neighbour = |i: usize, axis: usize, forward: bool| {
            let stride = CELLS.pow(axis as u32);
            let k = i / stride % CELLS;
            let inside = if forward { k + 1 < CELLS } else { k > 0 };
            inside && self.full[if forward { i + stride } else { i - stride }]
        };
        let mut g = Gaussians::default();
        for i in (0..self.full.len()).filter(|i| self.full[*i]) {
            let sides: [[bool; 2]; 3] = std::array::from_fn(|a| [neighbour(i, a, false), neighbour(i, a, true)]);
            if sides.iter().flatten().all(|full| *full) {
                continue;
            }
            let outwards = sides.map(|[before, after]| f32::from(u8::from(before)) - f32::from(u8::from(after)));
            let p = centre(i);
            let normal = Vec3::from_array(outwards).normalize_or(p.normalize_or_zero());
            let facing = |c: &Camera| (c.position() - p).normalize().dot(normal);
            let showing = silhouettes.iter().filter(|s| s.allows(p) == Some(true));
            let best = showing.max_by(|a, b| facing(&a.camera).total_cmp(&facing(&b.camera)));
            let colour = best.and_then(|s| pixel(&s.camera, p).map(|(x, y)| s.colour[y * s.mask.width + x]));
            g.positions.push(p);
            g.log_scales.push(Vec3::splat((0.6 * CELL).ln()));
            g.rotations.push([1.0, 0.0, 0.0, 0.0]);
            g.logit_opacities.push(2.0);
            let mut sh = [[0.0; 3]; 16];
            sh[0] = colour.unwrap_or([0.5; 3]).map(|v| (v - 0.5) / SH_C0);
            g.sh.push(sh);
        }
        g
    }
}
