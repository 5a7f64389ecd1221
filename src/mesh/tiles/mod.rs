//! A whole scene as textured meshes in tiles and levels of detail, whose borders are the same to the bit.
//!
//! depth from the scene's cameras → [`field`] (signed distance on one lattice, tile by tile) → [`shared`] (tiles that share
//! vertices, simplified; coarser levels) → [`skin`] (texture).
//!
//! What grows with what: a tile's samples are in memory at a time (20 bytes each, tiles' area times the scene's height); pictures
//! up to a fixed 512 MiB, made anew when they are wanted again; of the surface what simplification leaves of it (about 210
//! bytes a vertex while levels are made, 95 after: measured), as a whole. There is no grid over everything.
//!
//! Frame: the scene's, Z up; lengths in its unit.

mod cache;
mod field;
mod reduce;
mod shared;
mod skin;
#[cfg(test)]
mod tests;

use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::collections::{BTreeMap, HashMap};

use super::distance::{Bvh, farthest, samples};
use super::smooth::vertex_normals;
use super::{Mesh, Surface, View};
use crate::progress::Progress;
use crate::splat::Camera;
use crate::{Error, Result};
use field::{BRICK, Field, Lattice};
use image::RgbImage;
use shared::{Growing, Shared, inner};
use skin::Pictures;

pub use shared::At;

/// What is to be made.
pub struct Scene<'a> {
    /// Draws the scene without its sky, in the colours that cameras see on average, over black.
    pub render: &'a (dyn Fn(&Camera) -> View + Sync),
    pub cameras: &'a [Camera],
    /// Whether a place of the ground plane belongs to it.
    pub inside: &'a (dyn Fn(Vec2) -> bool + Sync),
    /// Around all of it.
    pub low: Vec3,
    pub high: Vec3,
    /// What a pixel of the cameras covers.
    pub pixel: f32,
}

/// How it is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Distance of samples; `None`: two pixels, or more where the views disagree by more.
    pub voxel: Option<f32>,
    /// Samples along a tile of the finest level, a multiple of 8.
    pub tile: usize,
    /// By how much simplification of the finest level may change the surface (root mean square), in voxels.
    pub error: f32,
}

impl Default for Options {
    fn default() -> Self {
        Options { voxel: None, tile: 192, error: 0.25 }
    }
}

/// Samples in all, as if the lattice were made at once: beyond that a wrong unit is likelier than a large scene.
const MOST_SAMPLES: f64 = 1e12;
/// Voxels' areas that a part of the surface has at least.
const LEAST_PART: f32 = 600.0;
/// Points of a raw tile that distances are taken to.
const POINTS: usize = 6000;
/// And of a tile of any level.
const MOST_POINTS: usize = 40_000;

/// A tile of one level.
pub struct Tile {
    pub mesh: Mesh,
    pub texture: RgbImage,
    /// Largest distance, either way, between this tile and the surface before simplification.
    pub error: f32,
    /// Edge of a texel on the surface.
    pub texel: f32,
}

/// The surface in levels, finest first.
pub struct Tiled {
    levels: Vec<Shared>,
    points: BTreeMap<At, Vec<Vec3>>,
    /// Of vertices on borders of the finest level.
    normals: HashMap<[u32; 3], Vec3>,
    pub voxel: f32,
    pub noise: f32,
    /// Edge of a tile of the finest level.
    pub side: f32,
    /// Triangles before simplification.
    pub raw: usize,
}

/// The surface of a scene; textures are made tile by tile, by [`Tiled::skinned`].
///
/// # Errors
/// Usage for voxels out of range and where nothing is seen; `Cancelled`.
pub fn surface(scene: &Scene, options: &Options, progress: &dyn Progress) -> Result<Tiled> {
    let tile = options.tile.max(2 * BRICK).next_multiple_of(BRICK);
    let lattice = |voxel: f32| -> Result<Lattice> {
        let extent = ((scene.high - scene.low) / voxel).ceil();
        let samples = extent.as_dvec3().element_product();
        if !(voxel > 0.0 && samples > 0.0 && samples < MOST_SAMPLES) {
            let found = format!("{voxel} units, {samples:.0} samples in all");
            return Err(Error::usage("distance of the mesh's samples")
                .expected("a length that fits the scene")
                .found(found));
        }
        let across = |e: f32| (e as usize).div_ceil(tile).max(1) * tile + 1;
        Ok(Lattice {
            origin: scene.low,
            voxel,
            dims: [across(extent.x), across(extent.y), extent.z as usize + 4],
            tile,
        })
    };
    progress.begin("surface", 0);
    let least = 2.0 * scene.pixel;
    let mut voxel = options.voxel.unwrap_or(least);
    let mut field = Field::new(scene.render, scene.cameras, lattice(voxel)?, scene.pixel)?;
    if options.voxel.is_none() && 0.6 * field.noise() > 1.05 * voxel {
        voxel = 0.6 * field.noise();
        field = Field::new(scene.render, scene.cameras, lattice(voxel)?, scene.pixel)?;
    }
    let [columns, rows] = field.lattice.tiles();
    // Neighbours one after another in two directions: pictures are wanted again soon.
    let mut all: Vec<At> = (0..rows).flat_map(|y| (0..columns).map(move |x| [x, y])).collect();
    all.sort_by_key(|at| interleaved(*at));
    let (mut growing, mut points, mut raw_triangles) = (Growing::default(), BTreeMap::new(), 0);
    progress.begin("surface", all.len() as u64);
    let error = options.error * voxel;
    for (done, some) in all.chunks(2).enumerate() {
        let raw = some.iter().map(|at| field.tile(*at, scene.inside, progress)).collect::<Result<Vec<_>>>()?;
        let simple: Vec<_> = raw.par_iter().map(|r| inner(r, error)).collect();
        for ((at, raw), simple) in some.iter().zip(&raw).zip(simple) {
            let Surface { positions, triangles } = &raw.surface;
            raw_triangles += triangles.len();
            points.insert(*at, samples(positions, triangles, POINTS));
            growing.add(*at, simple);
        }
        progress.step((2 * done + some.len()) as u64);
    }
    if growing.differ > 0 {
        return Err(Error::environment("meshes of tiles")
            .expected("borders of neighbours that are the same to the bit")
            .found(format!("{} vertices that differ", growing.differ)));
    }
    let noise = field.noise();
    drop(field);
    progress.begin("levels", 0);
    let finest = growing.finished(error, LEAST_PART * voxel * voxel, progress)?;
    if finest.tiles.is_empty() {
        return Err(Error::usage("mesh").expected("a scene with a surface").found("nothing opaque in any view"));
    }
    let normals = normals(&finest);
    let mut levels = vec![finest];
    while let Some(last) = levels.last().filter(|l| l.tiles.len() > 1 || l.tiles.keys().any(|at| *at != [0, 0])) {
        progress.check()?;
        let coarser = last.coarser();
        levels.push(coarser);
    }
    let side = tile as f32 * voxel;
    Ok(Tiled { levels, points, normals, voxel, noise, side, raw: raw_triangles })
}

/// Bits of column and row in turn: Morton's order.
fn interleaved(at: At) -> u64 {
    (0..32)
        .fold(0, |z, bit| z | ((at[0] as u64 >> bit & 1) << (2 * bit)) | ((at[1] as u64 >> bit & 1) << (2 * bit + 1)))
}

fn bits(p: Vec3) -> [u32; 3] {
    p.to_array().map(f32::to_bits)
}

/// Normals of vertices on borders, from the tiles on all sides.
fn normals(finest: &Shared) -> HashMap<[u32; 3], Vec3> {
    let all: Vec<[u32; 3]> = finest.tiles.values().flatten().copied().collect();
    let normals = vertex_normals(&finest.positions, &all);
    let on_border = finest.borders();
    let border = (0..normals.len()).filter(|v| on_border[*v]);
    border.map(|v| (bits(finest.positions[v]), normals[v])).collect()
}

impl Tiled {
    /// Finest first.
    pub fn levels(&self) -> usize {
        self.levels.len()
    }

    /// The tiles of a level.
    pub fn tiles(&self, level: usize) -> impl Iterator<Item = At> + '_ {
        self.levels.get(level).into_iter().flat_map(|l| l.tiles.keys().copied())
    }

    /// Triangles of a level.
    pub fn triangles(&self, level: usize) -> usize {
        self.levels.get(level).map_or(0, |l| l.tiles.values().map(Vec::len).sum())
    }

    /// Makes the textures of all tiles and hands them over, coarsest level first: `take` is told level and place.
    ///
    /// # Errors
    /// Those of `take`, and `Cancelled`.
    pub fn skinned(
        &self,
        scene: &Scene,
        progress: &dyn Progress,
        take: &mut dyn FnMut(usize, At, Tile) -> Result<()>,
    ) -> Result<()> {
        let count: usize = (0..self.levels()).map(|l| self.tiles(l).count()).sum();
        progress.begin("tiles", count as u64);
        let slack = 2.0 * self.voxel + 2.0 * self.noise;
        let mut done = 0;
        for level in (0..self.levels()).rev() {
            let wider = (1u64 << level) as f32;
            let pictures = Pictures::new(scene.render, scene.cameras, wider.recip(), slack);
            let mut tiles: Vec<At> = self.tiles(level).collect();
            tiles.sort_by_key(|at| interleaved(*at));
            for at in tiles {
                let (surface, _) = self.levels[level].tile(&at);
                let skinned = pictures.skin(&surface, wider * scene.pixel, progress)?;
                let mut mesh = skinned.mesh;
                for (p, n) in mesh.positions.iter().zip(&mut mesh.normals) {
                    *n = self.normals.get(&bits(*p)).copied().unwrap_or(*n);
                }
                let error = self.error(level, &at, &surface);
                take(level, at, Tile { mesh, texture: skinned.texture, error, texel: skinned.texel })?;
                done += 1;
                progress.step(done);
            }
        }
        Ok(())
    }

    /// Largest distance, either way, between a tile and what it stands for: the points of the raw surface, and the finest
    /// level's triangles.
    fn error(&self, level: usize, at: &At, surface: &Surface) -> f32 {
        let bvh = Bvh::new(&surface.positions, &surface.triangles);
        let below = self.points.iter().filter(|p| p.0.map(|k| k >> level) == *at);
        let own = self.levels[0].below(at, level);
        let fine = Bvh::new(&own.positions, &own.triangles);
        let all: Vec<Vec3> = below.flat_map(|p| p.1.iter().copied()).collect();
        // What was dropped as too small is no error of the simplification.
        let near: Vec<Vec3> = all.iter().step_by(all.len().div_ceil(MOST_POINTS).max(1)).copied().collect();
        let near: Vec<Vec3> = near.into_par_iter().filter(|p| fine.distance(*p) < 4.0 * self.voxel).collect();
        let there = farthest(&near, &bvh).0;
        let back = farthest(&samples(&surface.positions, &surface.triangles, MOST_POINTS), &fine).0;
        there.max(back)
    }
}
