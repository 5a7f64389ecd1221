//! Signed distance fusion of depth maps from all sides.
//!
//! After Curless & Levoy, "A Volumetric Method for Building Complex Models from Range Images" (1996): each view says how
//! far a voxel lies in front of (+) or behind (−) the surface along its ray. Three things differ from the plain weighted
//! mean, all so that thin parts live and skirts do not:
//! * distances are perpendicular to the local surface, and a view counts by how close to the surface it puts the voxel,
//!   so that the far side of a thin plate does not outvote the near side;
//! * a voxel that views see through is carved by the share of such views, not by one;
//! * what no view reaches is inside, so that surfaces close.
//!
//! How far the views disagree is measured first: it sets how fine the grid is and how much it is smoothed.

use super::SUBJECT_RADIUS;
use super::depth_map::{DepthMap, disagreement};
use crate::splat::simd::{Kernel, Simd, dispatch_eight};
use crate::{Error, Result};
use glam::Vec3;
use rayon::prelude::*;

/// Samples of a signed distance on a regular grid, x fastest; negative inside, clamped to ± `truncation`.
#[derive(Clone, Debug)]
pub struct Volume {
    /// Position of sample (0, 0, 0).
    pub origin: Vec3,
    pub voxel: f32,
    pub dims: [usize; 3],
    pub truncation: f32,
    pub data: Vec<f32>,
    /// How far the views that it was fused from disagree about the surface.
    pub noise: f32,
}

impl Volume {
    pub fn index(&self, x: usize, y: usize, z: usize) -> usize {
        (z * self.dims[1] + y) * self.dims[0] + x
    }

    pub fn position(&self, x: usize, y: usize, z: usize) -> Vec3 {
        self.origin + self.voxel * Vec3::new(x as f32, y as f32, z as f32)
    }

    /// Distance from the sums of weighted distances and weights.
    fn value(&self, [sum, weight]: [f32; 2], x: usize, y: usize, z: usize) -> f32 {
        if self.position(x, y, z).length() > SUBJECT_RADIUS {
            return self.truncation;
        }
        if weight > 0.0 { (sum / weight).clamp(-self.truncation, self.truncation) } else { -self.truncation }
    }

    /// Trilinear; `truncation` outside the grid.
    pub fn sample(&self, p: Vec3) -> f32 {
        let q = (p - self.origin) / self.voxel;
        let top = Vec3::new(self.dims[0] as f32, self.dims[1] as f32, self.dims[2] as f32) - Vec3::splat(1.001);
        if !(q.cmpge(Vec3::ZERO).all() && q.cmple(top).all()) {
            return self.truncation;
        }
        let f = q.floor();
        let t = q - f;
        let (x, y, z) = (f.x as usize, f.y as usize, f.z as usize);
        let i = self.index(x, y, z);
        let (sy, sz) = (self.dims[0], self.dims[0] * self.dims[1]);
        let d = &self.data;
        let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
        let row = |i: usize| mix(d[i], d[i + 1], t.x);
        mix(mix(row(i), row(i + sy), t.y), mix(row(i + sz), row(i + sz + sy), t.y), t.z)
    }

    /// Half the resolution; each sample the smallest of the eight it replaces, so that thin parts stay and gaps close.
    pub fn coarser(&self) -> Volume {
        let dims = self.dims.map(|n| n.div_ceil(2) + 2);
        let voxel = self.voxel * 2.0;
        let truncation = self.truncation.max(3.0 * voxel);
        let mut data = vec![truncation; dims[0] * dims[1] * dims[2]];
        for z in 1..dims[2] - 1 {
            for y in 1..dims[1] - 1 {
                for x in 1..dims[0] - 1 {
                    let mut least = truncation;
                    for corner in 0..8 {
                        let c =
                            [2 * (x - 1) + (corner & 1), 2 * (y - 1) + (corner >> 1 & 1), 2 * (z - 1) + (corner >> 2)];
                        if (0..3).all(|k| c[k] < self.dims[k]) {
                            least = least.min(self.data[self.index(c[0], c[1], c[2])]);
                        }
                    }
                    data[(z * dims[1] + y) * dims[0] + x] = least;
                }
            }
        }
        Volume { origin: self.origin - Vec3::splat(1.5 * self.voxel), voxel, dims, truncation, data, noise: self.noise }
    }
}

/// Views from below this sine of elevation carve with less trust: nobody saw the underside.
const BELOW: f32 = -0.3;

/// Views that see through a voxel count this much beside one that sees the surface half a voxel away.
const SEEN_THROUGH: f32 = 0.3;
/// So little each view counts that has the voxel hidden far behind a surface: two in fifty are stopped from drilling.
const HIDDEN: f32 = 0.012;
/// A soft surface's median depth lies inside its outline: this many times the views' disagreement further in. 0, 1, 2 gave
/// outlines of 0.42–0.87, 0.66–0.92, 0.95–1.01 of the rendered area.
const SOFT: f32 = 2.0;
/// Half the thickness that a sheet without thickness gets, in voxels.
pub const SHEET: f32 = 0.5;

/// Depth maps to a signed distance volume of at most about `voxels`³ samples around what they show.
///
/// Errors: `Usage` when no view shows anything.
pub fn fuse(maps: &[DepthMap], voxels: usize) -> Result<Volume> {
    let (lo, hi) = maps
        .par_iter()
        .map(|m| m.points().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(lo, hi), p| (lo.min(p), hi.max(p))))
        .reduce(|| (Vec3::INFINITY, Vec3::NEG_INFINITY), |a, b| (a.0.min(b.0), a.1.max(b.1)));
    if !(lo.is_finite() && hi.is_finite()) {
        return Err(Error::usage("mesh")
            .expected("a subject visible from around")
            .found("nothing opaque in any view")
            .advice("Use a photo with one clear subject in the middle."));
    }
    let extent = (hi - lo).max(Vec3::splat(0.02));
    let pixel = maps.iter().map(|m| super::VIEW_DISTANCE / m.camera.fx).fold(0.0, f32::max);
    let cube_root = (extent.x * extent.y * extent.z).cbrt();
    let noise = disagreement(maps);
    // Not finer than the depth maps and their noise, not coarser than the same count over the whole unit cube.
    let voxel = (cube_root / voxels as f32)
        .max(0.95 * pixel)
        .max(0.6 * noise)
        .min(2.2 / voxels as f32)
        .max(extent.max_element() / 512.0);
    let truncation = (4.0 * voxel).max(0.04).max(3.0 * noise);
    // Where views agree the nearest surface decides; where they do not, their mean.
    let softening = (0.5 * voxel).max(2.0 * noise);
    let margin = 2.5 * voxel;
    let origin = lo - Vec3::splat(margin);
    let dims = (extent + Vec3::splat(2.0 * margin)).to_array().map(|e| (e / voxel).ceil() as usize + 1);
    let mut volume =
        Volume { origin, voxel, dims, truncation, data: vec![truncation; dims[0] * dims[1] * dims[2]], noise };
    let grid = Volume { data: Vec::new(), ..volume.clone() };
    let sheet = SHEET * grid.voxel + SOFT * grid.noise;
    let views: Vec<Fused> = maps.iter().map(|m| Fused::new(m, &grid, softening, sheet)).collect();
    volume.data.par_chunks_mut(dims[0] * dims[1] * SLAB).enumerate().for_each(|(k, slices)| {
        fuse_slab(&views, &grid, k * SLAB, slices);
    });
    // Gauss-like smoothing as wide as the noise: one round of [1 2 1] / 4 has a variance of half a voxel².
    let rounds = (2.0 * (noise / voxel).powi(2)).round().min(6.0) as usize;
    for _ in 0..rounds {
        smooth(&mut volume);
    }
    Ok(volume)
}

/// One round of [1 2 1] / 4 along each axis; the rim is outside.
fn smooth(volume: &mut Volume) {
    blur(volume);
    let [nx, ny, nz] = volume.dims;
    let truncation = volume.truncation;
    volume.data.par_iter_mut().enumerate().for_each(|(i, value)| {
        let at = [i % nx, i / nx % ny, i / (nx * ny)];
        if (0..3).any(|k| at[k] == 0 || at[k] + 1 == [nx, ny, nz][k]) {
            *value = truncation;
        }
    });
}

/// One round of [1 2 1] / 4 along each axis, which the rim stays out of: each round reaches one sample further.
pub(super) fn blur(volume: &mut Volume) {
    let [nx, ny, nz] = volume.dims;
    for (stride, count, axis) in [(1, nx, 0), (nx, ny, 1), (nx * ny, nz, 2)] {
        let from = volume.data.clone();
        volume.data.par_chunks_mut(nx).enumerate().for_each(|(row, line)| {
            let own = &from[row * nx..(row + 1) * nx];
            let at = [1, row % ny, row / ny][axis];
            if axis == 0 {
                for (value, near) in line.iter_mut().skip(1).zip(own.windows(3)) {
                    *value = 0.25 * (near[0] + near[2]) + 0.5 * near[1];
                }
            } else if at > 0 && at + 1 < count {
                let (before, after) = (&from[row * nx - stride..], &from[row * nx + stride..]);
                for (((value, own), before), after) in line.iter_mut().zip(own).zip(before).zip(after) {
                    *value = 0.25 * (before + after) + 0.5 * own;
                }
            }
        });
    }
}

/// Samples along the sides of the blocks that a view is asked about as a whole: across, and up.
const BLOCK: usize = 8;
const SLAB: usize = 4;

/// Slices of samples from `bottom` on. The grid's rim stays outside, so that every surface is closed.
fn fuse_slab(views: &[Fused], grid: &Volume, bottom: usize, slices: &mut [f32]) {
    let [nx, ny, nz] = grid.dims;
    let inner = |from: usize, size: usize, n: usize| from.max(1)..(from + size).min(n.saturating_sub(1));
    let zs = inner(bottom, SLAB, nz);
    let mut sums = Vec::with_capacity(BLOCK * BLOCK * SLAB);
    for (y, x) in (0..ny).step_by(BLOCK).flat_map(|y| (0..nx).step_by(BLOCK).map(move |x| (y, x))) {
        let block = [inner(x, BLOCK, nx), inner(y, BLOCK, ny), zs.clone()];
        let rows = || block[2].clone().flat_map(|z| block[1].clone().map(move |y| (y, z)));
        let width = block[0].len();
        if width == 0 {
            continue;
        }
        sums.clear();
        sums.resize(width * rows().count(), [0f32; 2]);
        for view in views {
            match view.of_block(grid, &block) {
                Whole::Nothing => {}
                Whole::Same([sum, weight]) => sums.iter_mut().for_each(|s| *s = [s[0] + sum, s[1] + weight]),
                Whole::Mixed => {
                    for ((y, z), sums) in rows().zip(sums.chunks_exact_mut(width)) {
                        view.accumulate(grid, block[0].start, [y, z], sums);
                    }
                }
            }
        }
        for ((y, z), sums) in rows().zip(sums.chunks_exact(width)) {
            let row = ((z - bottom) * ny + y) * nx;
            for (x, sums) in block[0].clone().zip(sums) {
                slices[row + x] = grid.value(*sums, x, y, z);
            }
        }
    }
}

/// What one view says of a whole block of samples.
pub(super) enum Whole {
    /// It lies outside the picture.
    Nothing,
    /// Of each sample the same: weighted distance, and weight.
    Same([f32; 2]),
    Mixed,
}

/// Pixels along the sides of the squares that bounds are kept for.
const SQUARE: usize = 4;

/// A view that is being fused.
pub(super) struct Fused<'a> {
    map: &'a DepthMap,
    softening: f32,
    /// Weight of seeing through.
    through: f32,
    sheet: f32,
    across: usize,
    /// Of each square: what is nearer than the first lies in front of the surface, or is seen through, by more than the
    /// truncation; what is further away than the second lies behind it by more.
    bounds: Vec<[f32; 2]>,
}

impl<'a> Fused<'a> {
    /// `sheet`: by how much a surface is moved towards the view, half of what one without thickness gets.
    pub(super) fn new(map: &'a DepthMap, grid: &Volume, softening: f32, sheet: f32) -> Self {
        /// What rounding may make of depths, scene units.
        const ROUNDING: f32 = 1e-4;
        let c = &map.camera;
        let through = SEEN_THROUGH * if c.position().z < BELOW * c.position().length() { 0.5 } else { 1.0 };
        let bounds_of = |t: &[f32; 4]| {
            if t[0] == 0.0 {
                return [if t[3] == 1.0 { f32::INFINITY } else { f32::NEG_INFINITY }, f32::INFINITY];
            }
            let slope = (t[1].abs() + t[2].abs()) / 2.0 + ROUNDING;
            [t[0] - slope - (grid.truncation + sheet) / t[3], t[0] + slope + (grid.truncation - sheet).max(0.0) / t[3]]
        };
        let (width, height) = (c.width as usize, c.height as usize);
        let across = width.div_ceil(SQUARE);
        let mut bounds = vec![[f32::INFINITY, f32::NEG_INFINITY]; across * height.div_ceil(SQUARE)];
        for (i, t) in map.texels.iter().enumerate() {
            let (x, y) = (i % width, i / width);
            let ([near, far], square) = (bounds_of(t), &mut bounds[y / SQUARE * across + x / SQUARE]);
            *square = [square[0].min(near), square[1].max(far)];
        }
        Fused { map, softening, through, sheet, across, bounds }
    }

    /// The block's projection lies in the box around those of its corners.
    pub(super) fn of_block(&self, grid: &Volume, block: &[std::ops::Range<usize>; 3]) -> Whole {
        /// Pixels that rounding may move a projection.
        const ROUNDING: f32 = 0.01;
        let c = &self.map.camera;
        let (mut lo, mut hi) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for corner in 0..8 {
            let at = |k: usize| if corner >> k & 1 == 0 { block[k].start } else { block[k].end - 1 };
            let p = c.rotation * grid.position(at(0), at(1), at(2)) + c.translation;
            if p.z <= 0.01 {
                return Whole::Mixed;
            }
            let q = Vec3::new(c.fx * p.x / p.z + c.cx, c.fy * p.y / p.z + c.cy, p.z);
            (lo, hi) = (lo.min(q), hi.max(q));
        }
        let (width, height) = (c.width as f32, c.height as f32);
        if hi.x < -ROUNDING || hi.y < -ROUNDING || lo.x > width + ROUNDING || lo.y > height + ROUNDING {
            return Whole::Nothing;
        }
        if lo.x < ROUNDING || lo.y < ROUNDING || hi.x + ROUNDING >= width || hi.y + ROUNDING >= height {
            return Whole::Mixed;
        }
        // With what was asked above, of the same sums, none lies beyond the picture.
        let squares = |lo: f32, hi: f32| (lo - ROUNDING) as usize / SQUARE..=(hi + ROUNDING) as usize / SQUARE;
        let (mut front, mut behind) = (true, true);
        for y in squares(lo.y, hi.y) {
            for x in squares(lo.x, hi.x) {
                let [near, far] = self.bounds[y * self.across + x];
                front &= hi.z < near;
                behind &= lo.z > far;
            }
            if !front && !behind {
                return Whole::Mixed;
            }
        }
        match front {
            true => Whole::Same([self.through * grid.truncation, self.through]),
            false => Whole::Same([-HIDDEN * grid.truncation, HIDDEN]),
        }
    }

    /// Adds what the view says of a row of samples from `x` on.
    pub(super) fn accumulate(&self, grid: &Volume, x: usize, [y, z]: [usize; 2], sums: &mut [[f32; 2]]) {
        let rotation = &self.map.camera.rotation;
        let start = *rotation * grid.position(0, y, z) + self.map.camera.translation;
        let step = rotation.x_axis * grid.voxel;
        dispatch_eight(Row { view: self, truncation: grid.truncation, start, step, x, sums });
    }
}

/// A row of samples in the camera's coordinates, the `x`th and those after it; the 0th is at `start`.
struct Row<'a> {
    view: &'a Fused<'a>,
    truncation: f32,
    start: Vec3,
    step: Vec3,
    x: usize,
    sums: &'a mut [[f32; 2]],
}

impl Kernel for Row<'_> {
    type Output = ();

    /// [`DepthMap::distance`] of many points, to the bit, and what it weighs.
    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        /// No fewer than lanes.
        const MOST: usize = 16;
        let Row { view: Fused { map, softening, through, sheet, .. }, start, step, x, sums, .. } = self;
        let c = &map.camera;
        let zero = s.splat(0.0);
        let (truncation, behind) = (s.splat(self.truncation), s.splat(-self.truncation));
        let (softening, through, hidden) = (s.splat(*softening), s.splat(*through), s.splat(HIDDEN));
        let ramp: [f32; MOST] = std::array::from_fn(|i| i as f32);
        let along = |at: S::F, axis: usize| s.add(s.splat(start[axis]), s.mul(s.splat(step[axis]), at));
        for (k, sums) in sums.chunks_mut(S::LANES).enumerate() {
            let at = s.add(s.splat((x + k * S::LANES) as f32), s.load(&ramp));
            let pz = along(at, 2);
            let inverse = s.div(s.splat(1.0), pz);
            let pixel = |axis: usize, focal: f32, middle: f32| {
                s.add(s.mul(s.mul(s.splat(focal), along(at, axis)), inverse), s.splat(middle))
            };
            let (u, v) = (pixel(0, c.fx, c.cx), pixel(1, c.fy, c.cy));
            let within = |a: S::F, size: u32| s.and(s.ge(a, zero), s.gt(s.splat(size as f32), a));
            let inside = s.and(s.gt(pz, s.splat(1e-3)), s.and(within(u, c.width), within(v, c.height)));
            if !s.any(inside) {
                continue;
            }
            let (u, v) = (s.select(inside, u, zero), s.select(inside, v, zero));
            let (mut columns, mut rows) = ([0; MOST], [0; MOST]);
            s.whole(u, &mut columns);
            s.whole(v, &mut rows);
            let texels: [u32; MOST] = std::array::from_fn(|i| rows[i] as u32 * c.width + columns[i] as u32);
            let off = |a: S::F, whole: &[i32; MOST]| {
                let whole = whole.map(|w| w as f32);
                s.sub(s.sub(a, s.load(&whole)), s.splat(0.5))
            };
            let [depth, across, down, straight] = s.gather(&map.texels, &texels);
            let surface = s.add(s.add(depth, s.mul(across, off(u, &columns))), s.mul(down, off(v, &rows)));
            let d = s.sub(s.mul(s.sub(surface, pz), straight), s.splat(*sheet));
            let away = s.select(s.ge(d, zero), d, s.sub(zero, d));
            let near = s.div(softening, s.add(away, softening));
            let weight = s.mul(s.mul(s.mul(s.mul(s.splat(4.0), near), near), straight), straight);
            let pick =
                |far: S::M, to: (S::F, S::F), or: (S::F, S::F)| (s.select(far, to.0, or.0), s.select(far, to.1, or.1));
            let seen = pick(s.gt(behind, d), (behind, hidden), (d, weight));
            let seen = pick(s.gt(d, truncation), (truncation, through), seen);
            let nothing = (truncation, s.mul(through, straight));
            let (distance, weight) = pick(s.gt(depth, zero), seen, nothing);
            let weight = s.select(inside, weight, zero);
            let (mut products, mut weights) = ([0.0; MOST], [0.0; MOST]);
            s.store(s.mul(weight, distance), &mut products);
            s.store(weight, &mut weights);
            for (sum, (product, weight)) in sums.iter_mut().zip(products.iter().zip(&weights)) {
                sum[0] += product;
                sum[1] += weight;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::scenes;
    use super::*;

    fn fused(scene: &scenes::Scene) -> Volume {
        let maps: Vec<DepthMap> =
            scenes::depth_cameras(40, 160).iter().map(|c| DepthMap::new(&scene.render(c))).collect();
        fuse(&maps, 64).unwrap()
    }

    #[test]
    fn the_zero_surface_of_a_ball_is_where_the_ball_is() {
        let volume = fused(&scenes::sphere(0.7));
        let voxel = volume.voxel;
        for direction in super::super::fibonacci_sphere(100) {
            let at = |r: f32| volume.sample(direction * r);
            assert!(at(0.7 - 1.5 * voxel) < 0.0 && at(0.7 + 1.5 * voxel + SHEET * voxel) > 0.0);
            let (mut inside, mut outside) = (0.6, 0.8);
            while outside - inside > 1e-4 {
                let middle = (inside + outside) / 2.0;
                if at(middle) < 0.0 { inside = middle } else { outside = middle }
            }
            let truth = 0.7 + SHEET * voxel;
            assert!((inside - truth).abs() < 0.6 * voxel, "{inside} for {truth}, voxel {voxel}");
        }
        assert!(volume.sample(Vec3::ZERO) < 0.0);
    }

    /// 255.99 is no further out than 256 - 0.01, and with 0.01 more it is 256.
    #[test]
    fn a_sample_at_the_last_hundredth_of_a_picture_is_in_no_square_beyond_it() {
        let grid = fused(&scenes::sphere(0.7));
        let mut camera = scenes::depth_cameras(1, 256)[0];
        camera.rotation = glam::Mat3::IDENTITY;
        camera.translation = Vec3::Z - grid.position(1, 1, 1);
        for (cx, cy) in [(100.0, 255.99), (255.99, 100.0), (255.99, 255.99), (0.01, 0.01)] {
            (camera.cx, camera.cy) = (cx, cy);
            let map = DepthMap::new(&scenes::empty().render(&camera));
            let view = Fused::new(&map, &grid, 0.01, 0.0);
            let near_the_rim = matches!(view.of_block(&grid, &[1..2, 1..2, 1..2]), Whole::Mixed | Whole::Same(_));
            assert!(near_the_rim, "{cx}, {cy}");
        }
    }

    #[test]
    fn rows_of_samples_say_what_single_points_do() {
        let grid = fused(&scenes::sphere(0.7));
        let mut shown = [0; 4];
        for camera in scenes::depth_cameras(6, 96) {
            let map = DepthMap::new(&scenes::plate(0.2).render(&camera));
            let view = Fused::new(&map, &grid, 0.02, 0.004);
            for (y, z) in (0..grid.dims[1]).step_by(3).flat_map(|y| (0..grid.dims[2]).step_by(5).map(move |z| (y, z))) {
                let mut sums = vec![[0f32; 2]; grid.dims[0] - 1];
                view.accumulate(&grid, 1, [y, z], &mut sums);
                let start = camera.rotation * grid.position(0, y, z) + camera.translation;
                for (x, sum) in (1..).zip(sums) {
                    let point = start + camera.rotation.x_axis * grid.voxel * x as f32;
                    let (kind, distance, weight) = match (map.distance(point), map.texel(point)) {
                        (None, None) => (0, 0.0, 0.0),
                        (None, Some((t, _))) => (1, grid.truncation, view.through * t[3]),
                        (Some((d, straight)), _) => {
                            let d = d - view.sheet;
                            let near = view.softening / (d.abs() + view.softening);
                            match d.clamp(-grid.truncation, grid.truncation) {
                                far if far < d => (1, far, view.through),
                                far if far > d => (2, far, HIDDEN),
                                _ => (3, d, 4.0 * near * near * straight * straight),
                            }
                        }
                    };
                    shown[kind] += 1;
                    assert_eq!(sum, [weight * distance, weight], "{x} {y} {z}");
                }
            }
        }
        assert!(shown[1..].iter().all(|n| *n > 100), "{shown:?}");
    }

    #[test]
    fn a_sheet_has_an_inside() {
        let volume = fused(&scenes::plate(0.004));
        let inside = volume.data.iter().filter(|d| **d < 0.0).count();
        let whole = (1.2 * 0.8 / (volume.voxel * volume.voxel)) as usize;
        assert!(inside > whole * 8 / 10, "{inside} of {whole}");
    }

    #[test]
    fn nothing_visible_is_an_error() {
        let maps: Vec<DepthMap> =
            scenes::depth_cameras(8, 32).iter().map(|c| DepthMap::new(&scenes::empty().render(c))).collect();
        assert!(fuse(&maps, 32).unwrap_err().found.contains("nothing"));
    }
}
