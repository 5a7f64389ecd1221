//! Thin parts that the photo shows and the fusion lost: masts, bars, legs, railings.
//!
//! Around the subject every view but the photo's is invented, and a bar whose depth they do not agree on is carved away by
//! those that see past it. The photo's own silhouette does not lie: where a ray through it meets nothing solid, a tube is
//! put back along the medial axis of what is missing (Blum 1967), as deep as it is wide, at the depth that the Gaussians
//! have there. So is a narrow part that the Gaussians' depth sets off from what is behind it, where the ray meets only that.

use super::fuse::Volume;
use super::{SUBJECT_RADIUS, View};
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// A tube is at most so thick, half, in scene units; what is wider becomes a sheet of this thickness.
const THICKEST: f32 = 0.03;
/// Depths that differ so much are not of one surface, scene units.
const BEHIND: f32 = 0.08;
/// How firmly a pixel's own depth holds it, beside the firmness of neighbours: it gives way within about thirty pixels.
const LOOSE: f32 = 1e-3;
/// The same where the Gaussians' depth itself tells a part from what it stands before.
const FIRM: f32 = 0.1;
/// Of reweighting, and steps of conjugate gradients in each.
const ROUNDS: usize = 5;
const STEPS: usize = 300;
/// More of the silhouette than this missing is no thin part but a scene that the fusion did not understand.
const MOST: f32 = 0.4;

/// Makes solid what `view`, from the photo's camera, shows inside `mask` (1 on the subject, 0 off it; a value a pixel) and
/// `volume` lacks. Returns how many balls it took.
pub fn restore(volume: &mut Volume, view: &View, mask: &[f32]) -> usize {
    let sheet = Sheet::new(volume, view, mask);
    let shown = sheet.depth.iter().filter(|d| **d > 0.0).count();
    let lost = (0..sheet.depth.len()).filter(|&i| sheet.depth[i] > 0.0 && sheet.hit[i] <= 0.0).count();
    if lost as f32 > MOST * shown as f32 {
        return 0;
    }
    let axis = sheet.axis();
    let focal = view.camera.fx;
    for &(i, depth) in &axis {
        let radius = (sheet.room[i] * depth / focal).max(volume.voxel);
        stamp(volume, sheet.place(i, depth + radius), radius);
    }
    axis.len()
}

/// What the photo's camera shows, and where the volume has nothing for it.
struct Sheet<'a> {
    view: &'a View,
    width: usize,
    height: usize,
    /// Camera z; 0 off the subject.
    depth: Vec<f32>,
    /// Camera z of the first solid thing along the ray; 0 where there is none, and off the subject.
    hit: Vec<f32>,
    /// Distance to the nearest pixel of something else, pixels; up to `reach`.
    room: Vec<f32>,
    /// A narrow part, solid on neither side, before something solid that is not it.
    before: Vec<bool>,
    reach: f32,
}

impl<'a> Sheet<'a> {
    fn new(volume: &Volume, view: &'a View, mask: &[f32]) -> Self {
        let camera = &view.camera;
        let (width, height) = (camera.width as usize, camera.height as usize);
        let shown = |i: usize| mask[i] >= 0.5 && view.solid(i);
        let depth: Vec<f32> = (0..width * height).map(|i| if shown(i) { view.depth[i] } else { 0.0 }).collect();
        let nearest = depth.iter().filter(|d| **d > 0.0).fold(f32::INFINITY, |a, b| a.min(*b));
        let reach = (THICKEST * camera.fx.max(camera.fy) / nearest.max(0.1)).clamp(1.0, 40.0);
        let mut sheet =
            Sheet { view, width, height, depth, hit: Vec::new(), room: Vec::new(), before: Vec::new(), reach };
        sheet.hit = (0..width * height).into_par_iter().map(|i| sheet.first_hit(volume, i)).collect();
        let front: Vec<f32> = (0..width * height).into_par_iter().map(|i| sheet.room_around(i, BEHIND)).collect();
        sheet.before = (0..width * height).into_par_iter().map(|i| sheet.stands_before(i, &front)).collect();
        let apart = |i: usize| if sheet.before[i] { front[i] } else { sheet.room_around(i, f32::INFINITY) };
        sheet.room = (0..width * height).into_par_iter().map(apart).collect();
        sheet
    }

    fn place(&self, i: usize, z: f32) -> Vec3 {
        let c = &self.view.camera;
        let at = Vec2::new((i % self.width) as f32 + 0.5 - c.cx, (i / self.width) as f32 + 0.5 - c.cy);
        let p = Vec3::new(at.x / c.fx, at.y / c.fy, 1.0) * z;
        c.rotation.transpose() * (p - c.translation)
    }

    fn first_hit(&self, volume: &Volume, i: usize) -> f32 {
        if self.depth[i] <= 0.0 {
            return 0.0;
        }
        let middle = self.view.camera.translation.z;
        let (from, to) = (middle - SUBJECT_RADIUS, middle + SUBJECT_RADIUS);
        let steps = ((to - from) / (0.7 * volume.voxel)).ceil() as usize;
        let mut depths = (0..=steps).map(|k| from + (to - from) * k as f32 / steps as f32);
        depths.find(|&z| volume.sample(self.place(i, z)) < 0.0).unwrap_or(0.0)
    }

    /// On the subject, and nothing solid along the whole ray, or only what the part stands before.
    fn lost(&self, i: usize) -> bool {
        self.depth[i] > 0.0 && (self.hit[i] <= 0.0 || self.before[i])
    }

    /// Whether a pixel shows a part too narrow for a disc of `reach`, in `front` of what the volume has there. `front`: the
    /// distance to the nearest pixel off the subject or behind.
    fn stands_before(&self, i: usize, front: &[f32]) -> bool {
        let (depth, hit) = (self.depth[i], self.hit[i]);
        if depth <= 0.0 || hit <= 0.0 || hit < depth + BEHIND || front[i] >= self.reach {
            return false;
        }
        let wide = |j: usize| front[j] >= self.reach - 0.5 && (self.depth[j] - depth).abs() < BEHIND;
        !self.window(i, self.reach.ceil() as usize).any(wide)
    }

    /// Pixels of the square around one.
    fn window(&self, i: usize, reach: usize) -> impl Iterator<Item = usize> + use<> {
        let (width, x, y) = (self.width, i % self.width, i / self.width);
        let columns = x.saturating_sub(reach)..(x + reach + 1).min(width);
        let rows = y.saturating_sub(reach)..(y + reach + 1).min(self.height);
        rows.flat_map(move |y| columns.clone().map(move |x| y * width + x))
    }

    fn offset(&self, i: usize, j: usize) -> Vec2 {
        let at = |i: usize| Vec2::new((i % self.width) as f32, (i / self.width) as f32);
        at(j) - at(i)
    }

    /// Distance from a pixel to the nearest off the subject, or deeper by more than `behind`.
    fn room_around(&self, i: usize, behind: f32) -> f32 {
        if self.depth[i] <= 0.0 {
            return 0.0;
        }
        let off = self
            .window(i, self.reach.ceil() as usize)
            .filter(|&j| self.depth[j] <= 0.0 || self.depth[j] > self.depth[i] + behind);
        off.map(|j| self.offset(i, j).length() - 0.5).fold(self.reach, f32::min)
    }

    /// Lost pixels whose discs no neighbour's disc covers, with their depths.
    fn axis(&self) -> Vec<(usize, f32)> {
        let covered = |i: usize| {
            self.window(i, 2).any(|j| j != i && self.room[j] > self.room[i] + 0.75 * self.offset(i, j).length())
        };
        let depths = self.stretched();
        depths.into_par_iter().filter(|&(i, _)| !covered(i)).collect()
    }

    /// Depths of the lost pixels: a membrane in inverse depth, in which a straight line in space is straight, held by what is
    /// solid beside it and, loosely, by the Gaussians' own depth. Both pulls are robust (Geman and McClure 1987): a body behind
    /// a bar does not bend it.
    fn stretched(&self) -> Vec<(usize, f32)> {
        let lost: Vec<usize> = (0..self.depth.len()).filter(|&i| self.lost(i)).collect();
        let own: Vec<f32> = lost.iter().map(|&i| 1.0 / self.depth[i]).collect();
        let neighbours: Vec<Vec<usize>> =
            lost.par_iter().map(|&i| self.window(i, 1).filter_map(|j| lost.binary_search(&j).ok()).collect()).collect();
        let holds: Vec<Vec<f32>> = lost
            .par_iter()
            .map(|&i| {
                // What a part stands before does not hold it.
                let deepest = if self.before[i] { self.depth[i] + BEHIND } else { f32::INFINITY };
                let solid = |j: &usize| self.hit[*j] > 0.0 && self.hit[*j] < deepest && !self.before[*j];
                self.window(i, 2).filter(solid).map(|j| 1.0 / self.hit[j]).collect()
            })
            .collect();
        let mut found = own.clone();
        for _ in 0..ROUNDS {
            let pull = |k: usize, to: f32, strength: f32| {
                let scale = BEHIND * found[k] * found[k];
                strength / (1.0 + ((to - found[k]) / scale).powi(2)).powi(2)
            };
            // Of each pixel: the sum of its pulls, and of these times where they pull to.
            let pulls: Vec<(f32, f32)> = (0..lost.len())
                .into_par_iter()
                .map(|k| {
                    let firm = if self.before[lost[k]] { FIRM } else { LOOSE };
                    let own = std::iter::once((pull(k, own[k], firm), own[k]));
                    let held = holds[k].iter().map(|&to| (pull(k, to, 0.5), to));
                    own.chain(held).fold((0.0, 0.0), |sum, (w, to)| (sum.0 + w, sum.1 + w * to))
                })
                .collect();
            found = membrane(found.clone(), &neighbours, &pulls);
        }
        lost.into_iter().zip(found).filter(|(_, v)| v.is_finite() && *v > 0.0).map(|(i, v)| (i, 1.0 / v)).collect()
    }
}

/// Least Σ (x_i − x_j)² over neighbours + Σ (weight · x² − 2 · target · x) by conjugate gradients from `x`.
fn membrane(mut x: Vec<f32>, neighbours: &[Vec<usize>], pulls: &[(f32, f32)]) -> Vec<f32> {
    let apply = |v: &[f32]| -> Vec<f32> {
        let row = |k: usize| pulls[k].0 * v[k] + neighbours[k].iter().map(|&j| v[k] - v[j]).sum::<f32>();
        (0..v.len()).into_par_iter().map(row).collect()
    };
    let dot = |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| (a * b) as f64).sum::<f64>();
    let mut residual: Vec<f32> = apply(&x).iter().zip(pulls).map(|(a, p)| p.1 - a).collect();
    let mut direction = residual.clone();
    let mut size = dot(&residual, &residual);
    let enough = 1e-12 * x.len() as f64;
    for _ in 0..STEPS {
        if size <= enough {
            break;
        }
        let along = apply(&direction);
        let step = (size / dot(&direction, &along).max(f64::MIN_POSITIVE)) as f32;
        for k in 0..x.len() {
            x[k] += step * direction[k];
            residual[k] -= step * along[k];
        }
        let next = dot(&residual, &residual);
        let turn = (next / size) as f32;
        for (d, r) in direction.iter_mut().zip(&residual) {
            *d = r + turn * *d;
        }
        size = next;
    }
    x
}

/// The union of a ball with what is solid.
fn stamp(volume: &mut Volume, centre: Vec3, radius: f32) {
    let reach = radius + 2.0 * volume.voxel;
    let cell = |p: f32, origin: f32, n: usize| ((p - origin) / volume.voxel).clamp(1.0, (n - 2) as f32) as usize;
    let (lo, hi) = (centre - Vec3::splat(reach), centre + Vec3::splat(reach));
    let range = |k: usize| {
        let n = volume.dims[k];
        cell(lo[k], volume.origin[k], n)..=cell(hi[k], volume.origin[k], n)
    };
    let [xs, ys, zs] = [range(0), range(1), range(2)];
    for z in zs {
        for y in ys.clone() {
            for x in xs.clone() {
                let i = volume.index(x, y, z);
                let d = volume.position(x, y, z).distance(centre) - radius;
                volume.data[i] = volume.data[i].min(d.max(-volume.truncation));
            }
        }
    }
}
