//! What planes of symmetry give: Gaussians for the far side, and the photo from the other side.

use glam::Vec3;

use super::evidence::{lifted, projected};
use super::{Plane, Seen, flipped};
use crate::splat::{self, Camera, Gaussians};

/// Behind the seen surface by more than this, nothing was seen.
const BEHIND: f32 = 0.06;

/// A point that the photo sees claims this many pixels around it.
const SLACK: isize = 3;

/// The photo as a camera on the other side of a plane would have taken it; with a second plane also that picture mirrored.
#[derive(Clone, Debug)]
pub struct MirroredPhoto {
    pub camera: Camera,
    /// sRGB 0..1.
    pub color: Vec<[f32; 3]>,
    pub mask: Vec<f32>,
    /// Pixels of which the photo itself, or a picture mirrored at an earlier plane, knows better: it sees their surface, or
    /// something where the mirror image has nothing.
    pub seen_directly: Vec<bool>,
}

impl MirroredPhoto {
    fn seen(&self) -> Seen<'_> {
        Seen { camera: self.camera, color: &self.color, mask: &self.mask }
    }
}

/// Where a Gaussian comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Origin {
    /// Index of the one that it is, or is a mirror image of, among those that were completed.
    pub of: usize,
    pub mirrored: bool,
}

/// A subject with its unseen sides.
#[derive(Clone, Debug)]
pub struct Completed {
    pub gaussians: Gaussians,
    /// One a Gaussian.
    pub origins: Vec<Origin>,
    /// One for one plane, three for two.
    pub photos: Vec<MirroredPhoto>,
}

/// The unseen side from the seen one at one plane after the other; each takes what the planes before it gave for seen.
///
/// Of the Gaussians the near half stays as it is, the far half where something saw it; elsewhere the near half takes its
/// place, mirrored.
pub fn complete(g: &Gaussians, seen: &Seen, planes: &[Plane]) -> Completed {
    let own = |of| Origin { of, mirrored: false };
    let mut all = Completed { gaussians: g.clone(), origins: (0..g.len()).map(own).collect(), photos: Vec::new() };
    for plane in planes {
        let known: Vec<Seen> = std::iter::once(*seen).chain(all.photos.iter().map(MirroredPhoto::seen)).collect();
        let surfaces: Vec<Surface> = known.iter().map(|s| Surface::new(&all.gaussians, s)).collect();
        let mirrored: Vec<MirroredPhoto> =
            known.iter().enumerate().map(|(k, s)| mirrored_photo(s, plane, &surfaces, k)).collect();
        (all.gaussians, all.origins) = with_far_side(&all.gaussians, &all.origins, plane, &surfaces);
        all.photos.extend(mirrored);
    }
    all
}

fn with_far_side(g: &Gaussians, origins: &[Origin], plane: &Plane, surfaces: &[Surface]) -> (Gaussians, Vec<Origin>) {
    let near = |i: &usize| plane.distance(g.positions[*i]) >= 0.0;
    let kept: Vec<bool> = (0..g.len()).map(|i| near(&i) || seen_of(surfaces, g.positions[i])).collect();
    let half: Vec<usize> = (0..g.len()).filter(near).collect();
    let mirrored = plane.gaussians(&g.filtered(|i| near(&i)));
    let unseen: Vec<bool> = mirrored.positions.iter().map(|p| !seen_of(surfaces, *p)).collect();
    let mut out = g.filtered(|i| kept[i]);
    out.extend(&mirrored.filtered(|i| unseen[i]));
    let own = (0..g.len()).filter(|i| kept[*i]).map(|i| origins[i]);
    let images = half.iter().zip(&unseen).filter(|(_, unseen)| **unseen);
    let images = images.map(|(i, _)| Origin { mirrored: true, ..origins[*i] });
    (out, own.chain(images).collect())
}

/// Whether one of the pictures saw a point, or past it.
fn seen_of(surfaces: &[Surface], p: Vec3) -> bool {
    surfaces.iter().any(|s| s.behind(p) <= BEHIND)
}

/// `surfaces[of]` is what `seen` shows.
fn mirrored_photo(seen: &Seen, plane: &Plane, surfaces: &[Surface], of: usize) -> MirroredPhoto {
    let width = seen.camera.width as usize;
    let seen_directly: Vec<bool> = (0..seen.mask.len())
        .map(|i| {
            let z = surfaces[of].depth[i];
            z > 0.0 && seen_of(surfaces, plane.reflect(lifted(&seen.camera, i, z)))
        })
        .collect();
    let camera = plane.camera(&seen.camera);
    let mask = flipped(seen.mask, width);
    let mut seen_directly = flipped(&seen_directly, width);
    // Where another picture shows something that this mirror image lacks, the mirror image must not take it away.
    for (surface, i) in surfaces.iter().flat_map(|s| (0..s.depth.len()).map(move |i| (s, i))) {
        let z = surface.depth[i];
        if z <= 0.0 {
            continue;
        }
        let at = projected(&camera, lifted(&surface.camera, i, z));
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

/// What a picture's camera sees of the Gaussians.
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

    /// How far behind the seen surface a point lies; negative before it; −∞ where the picture looks past the subject.
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
