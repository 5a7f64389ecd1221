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
        let nearest = sheet.nearest_solid(volume);
        sheet.hit = (0..width * height).into_par_iter().map(|i| sheet.first_hit(volume, i, nearest[i])).collect();
        let room = sheet.room();
        let deepest = sheet.deepest_around();
        // Mostly nothing near is behind.
        let front = |i: usize| match deepest[i] > sheet.depth[i] + BEHIND {
            true => sheet.room_before(i),
            false => room[i],
        };
        let front: Vec<f32> = (0..width * height).into_par_iter().map(front).collect();
        sheet.before = (0..width * height).into_par_iter().map(|i| sheet.stands_before(i, &front)).collect();
        let apart = |i: usize| if sheet.before[i] { front[i] } else { room[i] };
        sheet.room = (0..width * height).map(apart).collect();
        sheet
    }

    fn place(&self, i: usize, z: f32) -> Vec3 {
        let c = &self.view.camera;
        let at = Vec2::new((i % self.width) as f32 + 0.5 - c.cx, (i / self.width) as f32 + 0.5 - c.cy);
        let p = Vec3::new(at.x / c.fx, at.y / c.fy, 1.0) * z;
        c.rotation.transpose() * (p - c.translation)
    }

    /// Of every pixel a camera z that nothing solid along its ray is nearer than; infinite where there is none.
    ///
    /// A sample is negative only where one of the eight that it lies between is: each block of those that has one is drawn as the
    /// box around its projection.
    fn nearest_solid(&self, volume: &Volume) -> Vec<f32> {
        /// Samples along a block's sides.
        const BLOCK: usize = 4;
        /// What rounding may make of a projection, pixels, and of a depth, sides of the volume's cells.
        const ROUNDING: f32 = 0.1;
        let c = &self.view.camera;
        let mut nearest = vec![f32::INFINITY; self.width * self.height];
        let [nx, ny, nz] = volume.dims;
        let starts = |n: usize| (0..n.saturating_sub(1)).step_by(BLOCK);
        for (z, y, x) in starts(nz).flat_map(|z| starts(ny).flat_map(move |y| starts(nx).map(move |x| (z, y, x)))) {
            let ends = [(x + BLOCK).min(nx - 1), (y + BLOCK).min(ny - 1), (z + BLOCK).min(nz - 1)];
            let rows = (z..=ends[2]).flat_map(|z| (y..=ends[1]).map(move |y| (y, z)));
            let mut rows = rows.map(|(y, z)| &volume.data[volume.index(x, y, z)..=volume.index(ends[0], y, z)]);
            if !rows.any(|row| row.iter().any(|d| *d < 0.0)) {
                continue;
            }
            let (mut lo, mut hi) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            for corner in 0..8 {
                let at = |k: usize, from: usize| if corner >> k & 1 == 0 { from } else { ends[k] };
                let p = c.rotation * volume.position(at(0, x), at(1, y), at(2, z)) + c.translation;
                if p.z <= 0.01 {
                    return vec![f32::NEG_INFINITY; self.width * self.height];
                }
                let q = Vec3::new(c.fx * p.x / p.z + c.cx, c.fy * p.y / p.z + c.cy, p.z);
                (lo, hi) = (lo.min(q), hi.max(q));
            }
            let pixels = |lo: f32, hi: f32, n: usize| {
                let end = ((hi + 0.5 + ROUNDING).max(0.0) as usize).min(n);
                ((lo - 0.5 - ROUNDING).max(0.0) as usize).min(end)..end
            };
            for row in pixels(lo.y, hi.y, self.height) {
                let columns = pixels(lo.x, hi.x, self.width);
                let line = &mut nearest[row * self.width..][columns];
                line.iter_mut().for_each(|z| *z = z.min(lo.z - ROUNDING * volume.voxel));
            }
        }
        nearest
    }

    /// The first sample along the ray that is solid. None is where the ray is nearer than `nearest`.
    fn first_hit(&self, volume: &Volume, i: usize, nearest: f32) -> f32 {
        if self.depth[i] <= 0.0 {
            return 0.0;
        }
        let middle = self.view.camera.translation.z;
        let (from, to) = (middle - SUBJECT_RADIUS, middle + SUBJECT_RADIUS);
        let steps = ((to - from) / (0.7 * volume.voxel)).ceil() as usize;
        // One less, as what rounds down may be rounded itself.
        let first = ((nearest - from) / (to - from) * steps as f32).clamp(0.0, steps as f32 + 2.0) as usize;
        let mut depths = (first.saturating_sub(1)..=steps).map(|k| from + (to - from) * k as f32 / steps as f32);
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

    /// Of every pixel the distance to the nearest off the subject, up to `reach`: along its row first, then over the rows.
    fn room(&self) -> Vec<f32> {
        let (width, reach) = (self.width.max(1), self.reach.ceil() as usize);
        // Columns to the nearest, squared; none within reach is further than any.
        let mut aside = vec![f32::INFINITY; self.depth.len()];
        aside.par_chunks_mut(width).zip(self.depth.par_chunks(width)).for_each(|(aside, depth)| {
            let mut line = |columns: &mut dyn Iterator<Item = usize>| {
                let mut away = usize::MAX;
                for x in columns {
                    away = if depth[x] <= 0.0 { 0 } else { away.saturating_add(1) };
                    if away <= reach {
                        aside[x] = aside[x].min((away * away) as f32);
                    }
                }
            };
            line(&mut (0..depth.len()));
            line(&mut (0..depth.len()).rev());
        });
        let room = |i: usize| {
            if self.depth[i] <= 0.0 {
                return 0.0;
            }
            let (x, y) = (i % width, i / width);
            let rows = y.saturating_sub(reach)..(y + reach + 1).min(self.height);
            let squares = rows.map(|row| aside[row * width + x] + (row.abs_diff(y) * row.abs_diff(y)) as f32);
            (squares.fold(f32::INFINITY, f32::min).sqrt() - 0.5).min(self.reach)
        };
        (0..self.depth.len()).into_par_iter().map(room).collect()
    }

    /// Of every pixel the largest depth in its window as large as `reach`.
    fn deepest_around(&self) -> Vec<f32> {
        let (width, reach) = (self.width.max(1), self.reach.ceil() as usize);
        let mut aside = vec![0f32; self.depth.len()];
        aside.par_chunks_mut(width).zip(self.depth.par_chunks(width)).for_each(|(aside, depth)| {
            for (x, deepest) in aside.iter_mut().enumerate() {
                let window = &depth[x.saturating_sub(reach)..(x + reach + 1).min(depth.len())];
                *deepest = window.iter().copied().fold(0.0, f32::max);
            }
        });
        let mut deepest = vec![0f32; self.depth.len()];
        deepest.par_chunks_mut(width).enumerate().for_each(|(y, deepest)| {
            for row in y.saturating_sub(reach)..(y + reach + 1).min(self.height) {
                for (deepest, aside) in deepest.iter_mut().zip(&aside[row * width..]) {
                    *deepest = deepest.max(*aside);
                }
            }
        });
        deepest
    }

    /// Distance from a pixel to the nearest off the subject, or deeper by more than [`BEHIND`], up to `reach`.
    fn room_before(&self, i: usize) -> f32 {
        if self.depth[i] <= 0.0 {
            return 0.0;
        }
        let off = self
            .window(i, self.reach.ceil() as usize)
            .filter(|&j| self.depth[j] <= 0.0 || self.depth[j] > self.depth[i] + BEHIND);
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

#[cfg(test)]
mod tests {
    use super::super::depth_map::DepthMap;
    use super::super::fuse::fuse;
    use super::super::scenes;
    use super::*;

    #[test]
    fn what_is_left_out_of_a_search_is_not_there() {
        let maps: Vec<DepthMap> = scenes::depth_cameras(30, 96)
            .iter()
            .map(|c| DepthMap::new(&scenes::boxed(0.5, 0.4, 0.3).render(c)))
            .collect();
        let volume = fuse(&maps, 48).unwrap();
        let camera = scenes::depth_cameras(7, 128)[3];
        // Not what the volume is of: rays meet it, miss it, and pass beside what is shown.
        let view = scenes::two_spheres().render(&camera);
        let mask: Vec<f32> = (0..128 * 128).map(|i| if i % 37 > 1 { 1.0 } else { 0.0 }).collect();
        let sheet = Sheet::new(&volume, &view, &mask);
        let (nearest, room, deepest) = (sheet.nearest_solid(&volume), sheet.room(), sheet.deepest_around());
        let (mut met, mut missed) = (0, 0);
        for i in (0..mask.len()).filter(|i| sheet.depth[*i] > 0.0) {
            let hit = sheet.first_hit(&volume, i, f32::NEG_INFINITY);
            assert_eq!(sheet.first_hit(&volume, i, nearest[i]), hit, "pixel {i}");
            if hit > 0.0 {
                met += 1
            } else {
                missed += 1
            }
            let window = || sheet.window(i, sheet.reach.ceil() as usize);
            let off = window().filter(|j| sheet.depth[*j] <= 0.0).map(|j| sheet.offset(i, j).length() - 0.5);
            assert_eq!(room[i], off.fold(sheet.reach, f32::min), "pixel {i}");
            assert_eq!(deepest[i], window().map(|j| sheet.depth[j]).fold(0.0, f32::max), "pixel {i}");
        }
        assert!(met > 100 && missed > 100, "{met} {missed}");
    }
}
