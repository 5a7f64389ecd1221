//! Where a seventh silhouette was taken from, by its consistency with the hull of six.
//!
//! A hull is wider than its body between the views, so a picture of the body does not simply look like the hull. But carved
//! by the right seventh silhouette the hull still fills all six others, and fills the seventh; from a wrong pose it loses
//! parts that a view shows, or leaves parts of the seventh empty. Silhouettes alone trade elevation against zoom: on a plain
//! box of a truck, with a guess 15° to 22° off, the elevation came out within 2° to 7° (C. Hernández, F. Schmitt and R. Cipolla, "Silhouette
//! coherence for camera calibration under circular motion", PAMI 2007).

use glam::Vec3;
use rayon::prelude::*;

use super::hull::{Hull, pixel};
use super::six_views;
use crate::models::splat_prior::canonical_camera;
use crate::photo::Plane;
use crate::splat::Camera;

/// Side of the six pictures that are compared, and of the photo's; a cell of the hull covers a pixel of either.
const SIX: usize = 48;
const PHOTO: usize = 48;
/// Degrees that are searched.
const RANGE: (f32, f32) = (-20.0, 60.0);
/// Where searches begin, beside the guess.
const STARTS: [f32; 4] = [-5.0, 10.0, 25.0, 45.0];
/// Cost of a degree away from the guess: decides only where the silhouettes do not.
const GUESS: f32 = 0.0002;

/// Degrees above the horizon; logarithm of the zoom; shift right and down in sides of the photo's square.
type Pose = [f32; 4];

/// A pose that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Consistent {
    pub camera: Camera,
    /// Radians above the horizon.
    pub elevation: f32,
    /// Share of the photo's silhouette that the hull fills.
    pub filled: f32,
    /// Share of the six silhouettes that the hull, carved by the photo's, still fills.
    pub kept: f32,
}

/// The canonical camera of a pose, `size` pixels across.
fn camera(pose: Pose, size: u32) -> Camera {
    let [degrees, zoom, right, down] = pose;
    let c = canonical_camera(degrees.to_radians(), size);
    let (by, side) = (zoom.exp(), size as f32);
    Camera { fx: c.fx * by, fy: c.fy * by, cx: c.cx + right * side, cy: c.cy + down * side, ..c }
}

/// The hull's cells and, for each, its pixel in every view.
struct Body {
    cells: Vec<Vec3>,
    pixels: Vec<[u16; 6]>,
    /// Pixels of each view that the whole hull fills.
    filled: [usize; 6],
    /// Of the photo, and how many.
    mask: Vec<bool>,
    area: usize,
}

impl Body {
    fn new(hull: &Hull, mask: &Plane) -> Body {
        let cameras = six_views(SIX as u32);
        let cells = hull.cells();
        let at = |p: Vec3| cameras.map(|c| pixel(&c, p).map_or(0, |(x, y)| (y * SIX + x) as u16));
        let pixels: Vec<[u16; 6]> = cells.iter().map(|p| at(*p)).collect();
        let coarse = |i: usize| {
            let of = |k: usize, side: usize| (2 * k + 1) * side / (2 * PHOTO);
            mask.at(of(i % PHOTO, mask.width), of(i / PHOTO, mask.height)) > 0.5
        };
        let mask: Vec<bool> = (0..PHOTO * PHOTO).map(coarse).collect();
        let area = mask.iter().filter(|m| **m).count();
        let mut body = Body { cells, pixels, filled: [1; 6], mask, area };
        body.filled = body.marks(|_| true).map(|n| n.max(1));
        body
    }

    /// Pixels of each view that the kept cells fill.
    fn marks(&self, keep: impl Fn(usize) -> bool) -> [usize; 6] {
        let mut seen = vec![0u8; SIX * SIX];
        for (i, pixels) in self.pixels.iter().enumerate() {
            if keep(i) {
                pixels.iter().enumerate().for_each(|(view, p)| seen[usize::from(*p)] |= 1 << view);
            }
        }
        std::array::from_fn(|view| seen.iter().filter(|s| **s >> view & 1 == 1).count())
    }

    /// Share of the photo's silhouette filled, mean share of the six kept.
    fn shares(&self, pose: Pose) -> (f32, f32) {
        let camera = camera(pose, PHOTO as u32);
        let hit: Vec<Option<usize>> = self
            .cells
            .iter()
            .map(|p| pixel(&camera, *p).map(|(x, y)| y * PHOTO + x).filter(|i| self.mask[*i]))
            .collect();
        let mut seen = vec![false; PHOTO * PHOTO];
        hit.iter().flatten().for_each(|i| seen[*i] = true);
        let filled = seen.iter().filter(|s| **s).count() as f32 / self.area.max(1) as f32;
        let marks = self.marks(|i| hit[i].is_some());
        let kept = marks.iter().zip(self.filled).map(|(n, all)| *n as f32 / all as f32).sum::<f32>() / 6.0;
        (filled, kept)
    }

    fn cost(&self, pose: Pose, guess: f32) -> f32 {
        if !(RANGE.0..=RANGE.1).contains(&pose[0]) || pose[1].abs() > 0.9 {
            return f32::INFINITY;
        }
        let (filled, kept) = self.shares(pose);
        2.0 - filled - kept + GUESS * (pose[0] - guess).abs()
    }

    /// Zoom and shift under which the hull's height and middle are the mask's.
    fn start(&self, degrees: f32) -> Pose {
        let camera = camera([degrees, 0.0, 0.0, 0.0], PHOTO as u32);
        let of = |points: &mut dyn Iterator<Item = (f32, f32)>| {
            points.fold([f32::MAX, f32::MAX, f32::MIN, f32::MIN], |b, (x, y)| {
                [b[0].min(x), b[1].min(y), b[2].max(x), b[3].max(y)]
            })
        };
        let seen = of(&mut self.cells.iter().filter_map(|p| pixel(&camera, *p)).map(|(x, y)| (x as f32, y as f32)));
        let inside = (0..PHOTO * PHOTO).filter(|i| self.mask[*i]);
        let want = of(&mut inside.map(|i| ((i % PHOTO) as f32, (i / PHOTO) as f32)));
        let side = PHOTO as f32;
        let zoom = ((want[3] - want[1] + 1.0) / (seen[3] - seen[1] + 1.0)).clamp(0.5, 2.0);
        // The picture grows about the principal point.
        let middle = |b: [f32; 4], k: usize| (b[k] + b[k + 2] + 1.0) / 2.0 - side / 2.0;
        let shift = |k: usize| (middle(want, k) - zoom * middle(seen, k)) / side;
        [degrees, zoom.ln(), shift(0), shift(1)]
    }
}

/// The pose of the photo: a pattern search (Hooke and Jeeves 1961) from several elevations. None where mask or hull is empty.
pub fn find(hull: &Hull, mask: &Plane, guess: f32) -> Option<Consistent> {
    let body = Body::new(hull, mask);
    if body.cells.is_empty() || body.area == 0 {
        return None;
    }
    let guess = guess.to_degrees();
    let search = |degrees: f32| {
        let mut best = body.start(degrees);
        let mut least = body.cost(best, guess);
        let mut step = [6.0, 0.12, 0.04, 0.04];
        while step[0] > 0.5 {
            let mut moved = false;
            for axis in 0..4 {
                for sign in [1.0, -1.0] {
                    let mut trial = best;
                    trial[axis] += sign * step[axis];
                    let cost = body.cost(trial, guess);
                    if cost < least {
                        (best, least, moved) = (trial, cost, true);
                    }
                }
            }
            if !moved {
                step.iter_mut().for_each(|s| *s *= 0.5);
            }
        }
        (least, best)
    };
    let mut starts = vec![guess.clamp(RANGE.0, RANGE.1)];
    starts.extend(STARTS);
    // In order, so that the number of threads decides nothing.
    let all: Vec<(f32, Pose)> = starts.into_par_iter().map(search).collect();
    let (_, pose) = all.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
    let (filled, kept) = body.shares(pose);
    Some(Consistent { camera: camera(pose, mask.width as u32), elevation: pose[0].to_radians(), filled, kept })
}
