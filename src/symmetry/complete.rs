//! What a plane of symmetry gives: Gaussians for the far side, and the photo from the other side.

use glam::Vec3;

use super::evidence::{lifted, projected};
use super::{Plane, Seen, flipped};
use crate::splat::{self, Camera, Gaussians};

/// Behind the seen surface by more than this, nothing was seen.
const BEHIND: f32 = 0.06;

/// A point that the photo sees claims this many pixels around it.
const SLACK: isize = 3;

/// The photo as a camera on the other side of the plane would have taken it.
#[derive(Clone, Debug)]
pub struct MirroredPhoto {
    pub camera: Camera,
    /// sRGB 0..1.
    pub color: Vec<[f32; 3]>,
    pub mask: Vec<f32>,
    /// Pixels of which the photo itself knows better: it sees their surface, or something where the mirror image has
    /// nothing.
    pub seen_directly: Vec<bool>,
}

/// The near half as it is, the far half where the photo saw it, and the near half mirrored where it did not.
pub fn complete(g: &Gaussians, seen: &Seen, plane: &Plane) -> Gaussians {
    let surface = Surface::new(g, seen);
    let near = |i: usize| plane.distance(g.positions[i]) >= 0.0;
    let mut out = g.filtered(|i| near(i) || surface.behind(g.positions[i]) <= BEHIND);
    let half = g.filtered(near);
    let mirrored = plane.gaussians(&half);
    out.extend(&mirrored.filtered(|i| surface.behind(mirrored.positions[i]) > BEHIND));
    out
}

/// `g`: what the depth of the photo's pixels is taken from.
pub fn mirrored_photo(g: &Gaussians, seen: &Seen, plane: &Plane) -> MirroredPhoto {
    let surface = Surface::new(g, seen);
    let width = seen.camera.width as usize;
    let seen_directly: Vec<bool> = (0..seen.mask.len())
        .map(|i| {
            let z = surface.depth[i];
            z > 0.0 && {
                let mirrored = plane.reflect(lifted(&seen.camera, i, z));
                surface.behind(mirrored) <= BEHIND
            }
        })
        .collect();
    let camera = plane.camera(&seen.camera);
    let mask = flipped(seen.mask, width);
    let mut seen_directly = flipped(&seen_directly, width);
    // Where the photo shows something that its mirror image lacks, the mirror image must not take it away.
    for (i, &z) in surface.depth.iter().enumerate().filter(|(_, z)| **z > 0.0) {
        let at = projected(&camera, lifted(&seen.camera, i, z));
        let (x, y) = (at.x as isize, at.y as isize);
        for (u, v) in (-SLACK..=SLACK).flat_map(|a| (-SLACK..=SLACK).map(move |b| (x + a, y + b))) {
            if u >= 0 && v >= 0 && u < width as isize && v < camera.height as isize {
                let j = v as usize * width + u as usize;
                seen_directly[j] |= mask[j] < 0.5;
            }
        }
    }
    MirroredPhoto { camera, color: flipped(seen.color, width), mask, seen_directly }
}

/// What the photo's camera sees of the Gaussians.
struct Surface {
    camera: Camera,
    /// 0 where there is none.
    depth: Vec<f32>,
}

impl Surface {
    fn new(g: &Gaussians, seen: &Seen) -> Self {
        let frame = splat::render(g, &seen.camera, [0.5; 3]);
        let solid = |i: usize| frame.alpha[i] > 0.5 && seen.mask[i] > 0.5;
        let depth = (0..seen.mask.len()).map(|i| if solid(i) { frame.median_depth[i] } else { 0.0 }).collect();
        Surface { camera: seen.camera, depth }
    }

    /// How far behind the seen surface a point lies; negative before it; −∞ where the photo looks past the subject.
    fn behind(&self, p: Vec3) -> f32 {
        let at = projected(&self.camera, p);
        let (w, h) = (self.camera.width as f32, self.camera.height as f32);
        if !(at.x >= 0.0 && at.y >= 0.0 && at.x < w && at.y < h) {
            return f32::NEG_INFINITY;
        }
        match self.depth[at.y as usize * self.camera.width as usize + at.x as usize] {
            z if z > 0.0 => at.z - z,
            _ => f32::NEG_INFINITY,
        }
    }
}
