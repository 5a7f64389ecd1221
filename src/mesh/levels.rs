//! All of it in order: volume, surface, levels.

use super::bake::{bake, transfer};
use super::depth_map::DepthMap;
use super::detail::{Fine, details};
use super::distance::{Bvh, farthest, samples};
use super::extract::extract;
use super::flatten::{Flattening, flatten};
use super::fuse::{Volume, fuse};
use super::simplify::Simplifier;
use super::smooth::{taubin, vertex_normals};
use super::unwrap::{Chart, FLAT, ROUND, assemble, charts, split_count};
use super::{
    AT_A_TIME, Level, Mesh, Model, Options, PhotoView, Surface, View, clean, pack, provenance, rendered,
    surrounding_cameras, thin,
};
use crate::progress::Progress;
use crate::splat::Camera;
use crate::{Error, Result};
use glam::Vec3;
use rayon::prelude::*;
use std::ops::Range;

pub(super) fn build(
    render: &(dyn Fn(&Camera) -> View + Sync),
    photos: &[PhotoView],
    options: &Options,
    progress: &dyn Progress,
) -> Result<Model> {
    progress.begin("fuse", options.views as u64);
    let volume = solid(render, photos, options, progress)?;
    progress.begin("simplify", options.levels as u64);
    let surface = closed_surface(&volume);
    if surface.triangles.len() < 4 || surface.volume() <= 0.0 {
        return Err(Error::usage("mesh")
            .expected("a solid subject")
            .found("less than one volume sample of it")
            .advice("Use a photo in which the subject is larger or less transparent."));
    }
    let meshes = simplified(&volume, &surface, options, progress)?;
    progress.begin("texture", options.color_views as u64);
    let sizes = &options.texture_size;
    let finest = &meshes[0];
    let bvhs: Vec<Bvh> = meshes.iter().map(|m| Bvh::new(&m.positions, &m.triangles)).collect();
    let baked = bake(finest, sizes[0], render, photos, options, progress)?;
    let mut textures = Vec::new();
    for (mesh, &size) in meshes.iter().zip(sizes) {
        progress.check()?;
        textures.push(match textures.is_empty() {
            true => (baked.image(), baked.shares()),
            false => {
                let coarse = transfer(mesh, size, finest, &bvhs[0], &baked);
                (coarse.image(), coarse.shares())
            }
        });
    }
    let fine = (options.normal_map || options.occlusion).then(|| Fine::new(&surface, options));
    let mut extras = Vec::new();
    for (mesh, &size) in meshes.iter().zip(sizes) {
        progress.check()?;
        extras.push(fine.as_ref().map(|f| details(mesh, size, f, options)).unwrap_or_default());
    }
    drop(fine);
    let errors = errors(&surface, &meshes, &bvhs);
    let levels = meshes
        .into_iter()
        .zip(textures)
        .zip(errors)
        .zip(extras)
        .map(|(((mesh, (texture, [seen, mirrored])), ([error, mean_error], error_to_coarser)), details)| Level {
            mesh,
            texture,
            details,
            error,
            mean_error,
            error_to_coarser,
            seen,
            mirrored,
        })
        .collect();
    Ok(Model { levels, provenance: provenance::shares(&baked), surface })
}

/// One solid without cavities and floaters, and where it stands.
struct Solid {
    volume: Volume,
    ground: Option<f32>,
    /// The same without the thin parts that [`thin`] put back, where it did: for levels of so few vertices that they cost too
    /// much.
    without: Option<Volume>,
}

fn solid(
    render: &(dyn Fn(&Camera) -> View + Sync),
    photos: &[PhotoView],
    options: &Options,
    progress: &dyn Progress,
) -> Result<Solid> {
    let cameras = surrounding_cameras(options.views, options.view_size);
    let mut maps = Vec::with_capacity(options.views + photos.len());
    for cameras in cameras.chunks(AT_A_TIME) {
        progress.check()?;
        let map = |camera: &Camera| Ok(DepthMap::new(&rendered(render, camera)?));
        maps.extend(cameras.par_iter().map(map).collect::<Result<Vec<DepthMap>>>()?);
        progress.step(maps.len() as u64);
    }
    // The photos' own views: they make room in the grid for what only they show.
    let shown = photos.iter().map(|p| rendered(render, &p.camera)).collect::<Result<Vec<View>>>()?;
    maps.par_extend(shown.par_iter().map(DepthMap::new));
    let mut volume = fuse(&maps, options.voxels)?;
    drop(maps);
    progress.check()?;
    clean::thin_thick_parts(&mut volume);
    let mut without = volume.clone();
    let restored = photos.iter().zip(&shown).map(|(p, v)| thin::restore(&mut volume, v, p.mask)).sum::<usize>();
    let one_solid = |volume: &mut Volume| {
        clean::fill_cavities(volume);
        clean::keep_what_belongs(volume);
        if options.cut_off_below {
            clean::square_foot(volume);
        }
    };
    if restored == 0 {
        one_solid(&mut volume);
        let ground = clean::flatten_ground(&mut volume);
        return Ok(Solid { volume, ground, without: None });
    }
    rayon::join(|| one_solid(&mut volume), || one_solid(&mut without));
    let ground = clean::flatten_ground(&mut volume);
    Ok(Solid { volume, ground, without: Some(without) })
}

fn closed_surface(solid: &Solid) -> Surface {
    let mut surface = extract(&solid.volume);
    let Volume { voxel, noise, .. } = solid.volume;
    // More where the views disagree.
    let rounds = (6.0 + 8.0 * noise / voxel).min(30.0) as usize;
    if let Some(ground) = solid.ground {
        let (lo, hi) = surface.bounds();
        stand_on(&mut surface, ground, 0.5 * voxel, voxel.max(noise.min(0.03 * (hi.z - lo.z))));
    }
    taubin(&mut surface, rounds, (0.7 * voxel).max(noise), solid.ground);
    // The views' disagreement is also how wrong the surface may be: no vertex goes further than twice that.
    let limit = 2.0 * noise.max(0.3 * voxel);
    flatten(&mut surface, &Flattening { limit, ..Flattening::default() }, solid.ground);
    surface
}

/// Vertices of a level that still shows anything.
const FEWEST: usize = 24;

/// Level by level, each from the finest surface, unwrapped, none over its cap.
fn simplified(solid: &Solid, surface: &Surface, options: &Options, progress: &dyn Progress) -> Result<Vec<Mesh>> {
    // With few triangles asked for, coarse levels would be next to nothing. One there must be that the coarsest cap has room for, seams
    // and all: they make up to four of a vertex.
    let room = options.vertex_caps[options.levels - 1] / 4;
    let worth = |level: &usize| *level == 0 || options.target(*level) >= FEWEST || options.target(*level - 1) > room;
    let levels = (0..options.levels).take_while(worth).count();
    let mut kept = options.clone();
    kept.vertex_caps.rotate_left(options.levels - levels);
    let mut meshes = from_level(0..levels, Simplifier::new(surface), None, (solid, surface), &kept, progress)?;
    meshes.reverse();
    Ok(meshes)
}

/// The levels, coarsest first. While one is packed, the next is already being made.
fn from_level(
    mut levels: Range<usize>,
    mut simplifier: Simplifier,
    mut coarser: Option<Solid>,
    (solid, finest): (&Solid, &Surface),
    options: &Options,
    progress: &dyn Progress,
) -> Result<Vec<Mesh>> {
    let Some(level) = levels.next() else { return Ok(Vec::new()) };
    progress.check()?;
    let size = options.texture_size[level];
    let texels = 0.65 * (size as f32).powi(2);
    let caps = Caps {
        vertices: options.vertex_caps[level],
        triangles: options.triangles.filter(|_| level == 0).unwrap_or(usize::MAX),
        target: options.target(level).max(FEWEST),
    };
    let (surface, charts) = fit_best(&mut simplifier, caps, texels, solid, &mut coarser, finest)?;
    let packed = || Ok(assemble(&surface, &charts, &pack::pack(&charts, size)?.uv));
    let next = || from_level(levels, simplifier, coarser, (solid, finest), options, progress);
    let (mesh, rest) = rayon::join(packed, next);
    let (mesh, mut meshes) = (mesh?, rest?);
    meshes.push(mesh);
    progress.step(level as u64 + 1);
    Ok(meshes)
}

/// What a level may have: vertices, seams counted, and triangles; and how many vertices of the closed surface are tried first.
#[derive(Clone, Copy)]
struct Caps {
    vertices: usize,
    triangles: usize,
    target: usize,
}

/// The solid without its thin parts; where it has none, at half the resolution, in which small holes and handles have closed.
/// `None` where next to nothing would be left.
fn plainer(solid: &Solid) -> Option<Solid> {
    let volume = solid.without.clone().unwrap_or_else(|| solid.volume.coarser());
    if volume.dims.iter().all(|n| *n <= 6) {
        return None;
    }
    let mut plain = Solid { volume, ground: solid.ground, without: None };
    clean::fill_cavities(&mut plain.volume);
    if let Some(ground) = plain.ground {
        clean::cut_below(&mut plain.volume, ground);
    }
    Some(plain)
}

/// Vertices that a shape should have for each of its handles, or they take what the rest of it needs: no collapse may close one,
/// so that a car whose mirrors leave a gap lost its roof to them.
const A_HANDLE: usize = 24;
/// How often a plainer solid is tried.
const TRIES: usize = 3;

/// Handles of a closed surface in one piece, by its Euler characteristic: 2 − 2 g = V − E + F. Of several pieces less.
fn handles(surface: &Surface) -> usize {
    let (v, f) = (surface.positions.len() as isize, surface.triangles.len() as isize);
    usize::try_from(1 - (v - f / 2) / 2).unwrap_or(0)
}

/// As [`fit`]. Where handles starve the rest, plainer solids are tried, and what lies nearest to the finest surface in the mean is kept.
fn fit_best(
    simplifier: &mut Simplifier,
    caps: Caps,
    texels: f32,
    solid: &Solid,
    coarser: &mut Option<Solid>,
    finest: &Surface,
) -> Result<(Surface, Vec<Chart>)> {
    let starved = |s: &Surface| s.positions.len() < A_HANDLE * handles(s);
    let mut best = fit(simplifier, caps, texels, solid, coarser)?;
    if !starved(&best.0) {
        return Ok(best);
    }
    let whole = Bvh::new(&finest.positions, &finest.triangles);
    let points = samples(&finest.positions, &finest.triangles, MOST);
    let off = |s: &Surface| {
        let there = farthest(&samples(&s.positions, &s.triangles, MOST), &whole).1;
        there + farthest(&points, &Bvh::new(&s.positions, &s.triangles)).1
    };
    let mut least = off(&best.0);
    let mut next = plainer(coarser.as_ref().unwrap_or(solid));
    for _ in 0..TRIES {
        let Some(plain) = next.take() else { break };
        let surface = closed_surface(&plain);
        if surface.triangles.len() < 4 {
            break;
        }
        let mut tried = Simplifier::new(&surface);
        let mut of = Some(plain);
        let Ok(made) = fit(&mut tried, caps, texels, solid, &mut of) else { break };
        if starved(&made.0) {
            next = of.as_ref().and_then(plainer);
        }
        let error = off(&made.0);
        if error < least {
            (least, best, *simplifier, *coarser) = (error, made, tried, of);
        }
    }
    Ok(best)
}

/// Points that distances between two surfaces are measured at, of each.
const MOST: usize = 30_000;

/// Simplifies until what the seams make of the vertices, and the triangles, fit the caps.
fn fit(
    simplifier: &mut Simplifier,
    caps: Caps,
    texels: f32,
    solid: &Solid,
    coarser: &mut Option<Solid>,
) -> Result<(Surface, Vec<Chart>)> {
    let cap = caps.vertices;
    let mut target = simplifier.vertices_left().min(caps.target);
    loop {
        if !simplifier.reduce_to(target)
            && simplifier.vertices_left() > target.max(4)
            && !simplifier.drop_smallest_part()
        {
            // Too many holes and handles for so few vertices.
            let half = plainer(coarser.as_ref().unwrap_or(solid)).map(|half| (closed_surface(&half), half));
            // What is one layer thick may be gone.
            let Some((surface, half)) = half.filter(|(surface, _)| surface.triangles.len() >= 4) else {
                return Err(Error::usage("mesh")
                    .expected(format!("a shape that {cap} vertices can hold"))
                    .found(format!("{} vertices that cannot be fewer", simplifier.vertices_left())));
            };
            *simplifier = Simplifier::new(&surface);
            *coarser = Some(half);
        }
        if simplifier.vertices_left() > target.max(4) {
            continue;
        }
        let mut surface = simplifier.surface();
        if let Some(ground) = solid.ground {
            let voxel = solid.volume.voxel;
            stand_on(&mut surface, ground, 0.5 * voxel, voxel);
        }
        let charts = charts(&surface, if cap > 1024 { &FLAT } else { &ROUND }, texels);
        let count = split_count(&surface, &charts);
        // Every handle adds four triangles to those that as many vertices have without it.
        let triangles = surface.triangles.len();
        if count <= cap && triangles <= caps.triangles {
            return Ok((surface, charts));
        }
        let (left, over) = (simplifier.vertices_left(), triangles.saturating_sub(caps.triangles));
        target = (left * cap / count).min(left.saturating_sub(over.div_ceil(2))).min(left - 1);
        if target < 4 {
            return Err(Error::usage("vertex cap").expected("room for the seams").found(format!("{cap} vertices")));
        }
    }
}

/// What is lower than `near` over the ground goes onto it, and what faces down lower than `undersides`.
fn stand_on(surface: &mut Surface, ground: f32, near: f32, undersides: f32) {
    let normals = vertex_normals(&surface.positions, &surface.triangles);
    for (p, n) in surface.positions.iter_mut().zip(normals) {
        if p.z < ground + near || (n.z < -0.6 && p.z < ground + undersides) {
            p.z = ground;
        }
    }
}

/// (to the surface: largest and mean; to the next coarser level) of each level.
fn errors(surface: &Surface, meshes: &[Mesh], bvhs: &[Bvh]) -> Vec<([f32; 2], f32)> {
    let all = |m: &Mesh| samples(&m.positions, &m.triangles, MOST);
    let whole = Bvh::new(&surface.positions, &surface.triangles);
    let whole_samples = samples(&surface.positions, &surface.triangles, MOST);
    let points: Vec<Vec<Vec3>> = meshes.iter().map(all).collect();
    let mut result: Vec<([f32; 2], f32)> = (0..meshes.len())
        .map(|k| {
            let (there, back) = (farthest(&points[k], &whole), farthest(&whole_samples, &bvhs[k]));
            let coarser = match meshes.get(k + 1) {
                Some(_) => farthest(&points[k], &bvhs[k + 1]).0.max(farthest(&points[k + 1], &bvhs[k]).0),
                None => {
                    let (lo, hi) = meshes[k].bounds();
                    lo.distance(hi)
                }
            };
            ([there.0.max(back.0), (there.1 + back.1) / 2.0], coarser)
        })
        .collect();
    // A switch from level to level needs sizes that grow.
    for k in 1..result.len() {
        result[k].1 = result[k].1.max(1.05 * result[k - 1].1).max(1e-6);
    }
    result
}

#[cfg(test)]
mod tests;
