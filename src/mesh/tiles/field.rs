//! The signed distance of a whole scene, a tile at a time, on one lattice that all tiles share.
//!
//! A sample's value follows from the views and from its place on the lattice alone, whichever tile asks: views are summed in
//! their order, in bricks of the lattice, and a tile is made with a brick more on each side than it has, further than the
//! smoothing reaches. So the samples that two tiles share are the same to the bit, and so is the surface between them.
//!
//! As [`fuse`](crate::mesh::fuse), but for a scene: nothing is made thicker, since the ground has one side; what no view
//! reaches is inside only below what some view sees.

use glam::{Vec2, Vec3};
use rayon::prelude::*;

use super::super::depth_map::{DepthMap, disagreement};
use super::super::extract::extract_cells;
use super::super::fuse::{Fused, Volume, Whole, blur};
use super::super::{AT_A_TIME, Surface, View, rendered};
use super::cache::Cache;
use crate::Result;
use crate::progress::Progress;
use crate::splat::Camera;

/// Samples along a brick, across; up, a brick is as high as the lattice is in parts of so many.
pub const BRICK: usize = 8;
/// Rounds of smoothing at most: each reaches a sample further, and a brick lies around a tile.
const ROUNDS: usize = 6;
/// Views that are asked how far they disagree.
const ASKED: usize = 24;
/// Memory for depth maps that may be wanted again.
const KEPT: usize = 512 << 20;

/// Where samples lie: origin + voxel · index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    pub origin: Vec3,
    pub voxel: f32,
    /// Samples along the axes.
    pub dims: [usize; 3],
    /// Cells along a tile, a multiple of [`BRICK`].
    pub tile: usize,
}

impl Lattice {
    /// Tiles along x and y.
    pub fn tiles(&self) -> [usize; 2] {
        [0, 1].map(|k| (self.dims[k] - 1) / self.tile)
    }

    pub fn position(&self, [x, y, z]: [usize; 3]) -> Vec3 {
        self.origin + self.voxel * Vec3::new(x as f32, y as f32, z as f32)
    }

    /// Middle of a column of cells.
    fn middle(&self, x: usize, y: usize) -> Vec2 {
        self.origin.truncate() + self.voxel * (Vec2::new(x as f32, y as f32) + 0.5)
    }
}

/// A vertex of the unsimplified surface, the same in every tile: its edge of the lattice.
pub type Key = u64;

/// The surface of one tile before simplification.
pub struct Raw {
    pub surface: Surface,
    /// One a vertex, of those that lie on the tile's border; there neighbours have the same.
    pub keys: Vec<Option<Key>>,
}

/// The views of a scene, made ready for fusion when they are asked for.
pub struct Field<'a> {
    pub lattice: Lattice,
    render: &'a (dyn Fn(&Camera) -> View + Sync),
    cameras: Vec<Camera>,
    kept: Cache<DepthMap>,
    /// An empty volume over all of the lattice.
    grid: Volume,
    softening: f32,
    rounds: usize,
}

impl<'a> Field<'a> {
    /// `pixel`: what a pixel of `cameras` covers of the ground; pictures are made no finer than samples need.
    pub fn new(
        render: &'a (dyn Fn(&Camera) -> View + Sync),
        cameras: &[Camera],
        lattice: Lattice,
        pixel: f32,
    ) -> Result<Field<'a>> {
        let cameras: Vec<Camera> = cameras.iter().map(|c| smaller(c, pixel / (0.7 * lattice.voxel))).collect();
        let asked: Vec<Camera> = cameras.iter().step_by(cameras.len().div_ceil(ASKED).max(1)).copied().collect();
        let mut maps = Vec::with_capacity(asked.len());
        for some in asked.chunks(AT_A_TIME) {
            maps.extend(some.par_iter().map(|c| Ok(DepthMap::new(&rendered(render, c)?))).collect::<Result<Vec<_>>>()?);
        }
        let noise = disagreement(&maps);
        let Lattice { origin, voxel, dims, .. } = lattice;
        let truncation = (4.0 * voxel).max(3.0 * noise);
        let rounds = (2.0 * (noise / voxel).powi(2)).round().clamp(1.0, ROUNDS as f32) as usize;
        let grid = Volume { origin, voxel, dims, truncation, data: Vec::new(), noise };
        let softening = (0.5 * voxel).max(2.0 * noise);
        Ok(Field { lattice, render, cameras, kept: Cache::new(KEPT), grid, softening, rounds })
    }

    /// How far views disagree.
    pub fn noise(&self) -> f32 {
        self.grid.noise
    }

    /// The surface in the columns of a tile that are `inside`.
    pub fn tile(&self, at: [usize; 2], inside: &dyn Fn(Vec2) -> bool, progress: &dyn Progress) -> Result<Raw> {
        let Lattice { tile, dims, .. } = self.lattice;
        // Samples from the brick before the tile to the one after it, where the lattice has them.
        let from = at.map(|k| (k * tile).saturating_sub(BRICK));
        let to: [usize; 2] = std::array::from_fn(|k| ((at[k] + 1) * tile + BRICK).min(dims[k]));
        let volume = self.fused(from, to, progress)?;
        let first = [at[0] * tile, at[1] * tile];
        let cells: [std::ops::Range<usize>; 2] =
            std::array::from_fn(|k| first[k] - from[k]..(first[k] + tile).min(dims[k] - 1) - from[k]);
        let wanted = |x: usize, y: usize| inside(self.lattice.middle(from[0] + x, from[1] + y));
        let global = |[x, y, z]: [usize; 3]| [from[0] + x, from[1] + y, z];
        let [xs, ys] = cells;
        let (surface, edges) =
            extract_cells(&volume, [xs, ys, 0..dims[2] - 1], wanted, |p| self.lattice.position(global(p)));
        let on_border = |p: [usize; 3], axis: usize| (0..2).any(|k| axis != k && p[k].is_multiple_of(tile));
        let key = |([x, y, z], axis): ([usize; 3], usize)| {
            let p = global([x, y, z]);
            on_border(p, axis).then(|| (((p[2] * dims[1] + p[1]) * dims[0] + p[0]) * 3 + axis) as Key)
        };
        Ok(Raw { surface, keys: edges.into_iter().map(key).collect() })
    }

    /// Samples `from..to` across, all of them up.
    fn fused(&self, from: [usize; 2], to: [usize; 2], progress: &dyn Progress) -> Result<Volume> {
        let [nx, ny, nz] = [to[0] - from[0], to[1] - from[1], self.lattice.dims[2]];
        let mut sums = vec![[0f32; 2]; nx * ny * nz];
        let seeing: Vec<usize> = (0..self.cameras.len()).filter(|i| self.may_see(*i, from, to)).collect();
        for some in seeing.chunks(AT_A_TIME) {
            progress.check()?;
            let map = |i: &usize| {
                self.kept.get(*i, || {
                    let map = DepthMap::new(&rendered(self.render, &self.cameras[*i])?);
                    let bytes = 16 * map.texels.len();
                    Ok((map, bytes))
                })
            };
            for map in some.par_iter().map(map).collect::<Result<Vec<_>>>()? {
                let view = Fused::new(&map, &self.grid, self.softening, 0.0);
                sums.par_chunks_mut(nx * ny * BRICK).enumerate().for_each(|(k, slices)| {
                    self.add(&view, [from[0], from[1], k * BRICK], [to[0], to[1], nz.min((k + 1) * BRICK)], slices);
                });
            }
        }
        let mut volume = Volume {
            origin: self.lattice.position([from[0], from[1], 0]),
            dims: [nx, ny, nz],
            data: vec![0.0; nx * ny * nz],
            ..self.grid.clone()
        };
        self.settle(&sums, &mut volume);
        drop(sums);
        for _ in 0..self.rounds {
            blur(&mut volume);
        }
        // Nothing is open below or above.
        let (layer, truncation) = (nx * ny, volume.truncation);
        volume.data[..layer].fill(-truncation);
        volume.data[layer * (nz - 1)..].fill(truncation);
        Ok(volume)
    }

    /// Whether a view may have something to say of a column: its picture may hold some of the corners' box.
    fn may_see(&self, camera: usize, from: [usize; 2], to: [usize; 2]) -> bool {
        let c = &self.cameras[camera];
        let corner = |k: usize| {
            let at = |axis: usize| if k >> axis & 1 == 0 { from[axis] } else { to[axis] };
            let z = if k >> 2 == 0 { 0 } else { self.lattice.dims[2] };
            c.rotation * self.lattice.position([at(0), at(1), z]) + c.translation
        };
        let corners: [Vec3; 8] = std::array::from_fn(corner);
        // Wholly on the outer side of one of the picture's planes.
        let (w, h) = (c.width as f32, c.height as f32);
        let outside: [&dyn Fn(&Vec3) -> bool; 5] = [
            &|p| p.z <= 0.0,
            &|p| c.fx * p.x + c.cx * p.z < -1e-3,
            &|p| c.fx * p.x + (c.cx - w) * p.z > 1e-3,
            &|p| c.fy * p.y + c.cy * p.z < -1e-3,
            &|p| c.fy * p.y + (c.cy - h) * p.z > 1e-3,
        ];
        !outside.iter().any(|out| corners.iter().all(out))
    }

    /// Adds what a view says of a slab of bricks, whose lower corner and end are given.
    fn add(&self, view: &Fused, low: [usize; 3], high: [usize; 3], sums: &mut [[f32; 2]]) {
        let [nx, ny] = [high[0] - low[0], high[1] - low[1]];
        for y in (low[1]..high[1]).step_by(BRICK) {
            for x in (low[0]..high[0]).step_by(BRICK) {
                let (right, back) = ((x + BRICK).min(high[0]), (y + BRICK).min(high[1]));
                let whole = view.of_block(&self.grid, &[x..right, y..back, low[2]..high[2]]);
                for z in low[2]..high[2] {
                    for row in y..back {
                        let start = ((z - low[2]) * ny + row - low[1]) * nx + x - low[0];
                        let sums = &mut sums[start..start + right - x];
                        match whole {
                            Whole::Nothing => {}
                            Whole::Same([sum, weight]) => {
                                sums.iter_mut().for_each(|s| *s = [s[0] + sum, s[1] + weight]);
                            }
                            Whole::Mixed => view.accumulate(&self.grid, x, [row, z], sums),
                        }
                    }
                }
            }
        }
    }

    /// Distances from sums, column by column from above: what no view reaches is air until one is reached.
    fn settle(&self, sums: &[[f32; 2]], volume: &mut Volume) {
        let (layer, truncation) = (volume.dims[0] * volume.dims[1], volume.truncation);
        let mut reached = vec![false; layer];
        for (values, sums) in volume.data.chunks_exact_mut(layer).zip(sums.chunks_exact(layer)).rev() {
            for ((value, [sum, weight]), reached) in values.iter_mut().zip(sums).zip(&mut reached) {
                *reached |= *weight > 0.0;
                *value = match (*weight > 0.0, *reached) {
                    (true, _) => (sum / weight).clamp(-truncation, truncation),
                    (false, true) => -truncation,
                    (false, false) => truncation,
                };
            }
        }
    }
}

/// A camera with a picture that is `by` times as wide, no wider than it is.
pub fn smaller(c: &Camera, by: f32) -> Camera {
    if by >= 1.0 {
        return *c;
    }
    let side = |n: u32| ((n as f32 * by).round() as u32).max(16).min(n);
    c.resized(side(c.width), side(c.height))
}
