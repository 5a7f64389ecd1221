//! A model of others as the finest level: coarser ones are made from pictures of it, as the main job makes its own.

use glam::{Vec2, Vec3};

use super::{PlacedLevel, ToMetres};
use crate::mesh::distance::{Bvh, farthest, samples};
use crate::mesh::raster::visibility;
use crate::mesh::{self, Mesh};
use crate::progress::Progress;
use crate::splat::Camera;
use crate::{Error, Result};

/// Most vertices and the texture's side of levels that can be made, finest first; a CDB wants 128 in the coarsest.
const CAPS: [usize; 4] = [8192, 2048, 512, 128];
const SIZES: [u32; 4] = [1024, 512, 256, 128];
/// Points at which distances between levels are taken.
const POINTS: usize = 20_000;
/// Each coarser level's size at least so many times the finer one's: CDB wants them to differ.
const GROWTH: f64 = 1.01;

/// The level and at most `count` coarser ones, each a quarter of the vertices; none below 128 vertices.
///
/// # Errors
/// As [`mesh::build`].
pub fn with_coarser(finest: PlacedLevel, count: usize, progress: &dyn Progress) -> Result<Vec<PlacedLevel>> {
    let fewer = CAPS.iter().filter(|cap| **cap < finest.mesh.positions.len()).count().min(count);
    if fewer == 0 {
        return Ok(vec![finest]);
    }
    let (low, high) = finest.mesh.bounds().ok_or_else(|| Error::usage("model").found("no vertices"))?;
    let centre: [f64; 3] = std::array::from_fn(|i| (low[i] + high[i]) / 2.0);
    let radius = (0..3).map(|i| (high[i] - low[i]).powi(2)).sum::<f64>().sqrt() / 2.0 * 1.05;
    if !(radius.is_finite() && radius > 0.0) {
        return Err(Error::usage("model").expected("a body").found(format!("a radius of {radius} m")));
    }
    // Into the unit sphere.
    let unit = |p: &[f64; 3]| Vec3::from_array(std::array::from_fn(|i| ((p[i] - centre[i]) / radius) as f32));
    let model = Mesh {
        positions: finest.mesh.positions.iter().map(unit).collect(),
        normals: finest.mesh.normals.iter().map(|n| Vec3::from_array(*n)).collect(),
        uvs: finest.mesh.uvs.iter().map(|t| Vec2::from_array(*t)).collect(),
        triangles: finest.mesh.triangles.clone(),
    };
    let render = |camera: &Camera| {
        let seen = visibility(&model.positions, &model.triangles, camera);
        let picture = mesh::raster(&model, Some(&finest.texture), camera, [128; 3], 1);
        mesh::View {
            camera: *camera,
            color: picture.pixels().map(|p| p.0.map(|c| f32::from(c) / 255.0)).collect(),
            alpha: seen.triangle.iter().map(|t| if *t == u32::MAX { 0.0 } else { 1.0 }).collect(),
            depth: seen.depth,
            passing: mesh::MEDIAN,
        }
    };
    let first = CAPS.len() - fewer;
    let mut options = mesh::Options { levels: fewer, background: [128.0 / 255.0; 3], ..Default::default() };
    options.vertex_caps[..fewer].copy_from_slice(&CAPS[first..]);
    options.texture_size[..fewer].copy_from_slice(&SIZES[first..]);
    let made = mesh::build(&render, &[], &options, progress)?;

    // Measured against the model itself, not against what was fused from its pictures.
    let own = Bvh::new(&model.positions, &model.triangles);
    let own_points = samples(&model.positions, &model.triangles, POINTS);
    let apart: Vec<f64> = made
        .levels
        .iter()
        .map(|l| {
            let bvh = Bvh::new(&l.mesh.positions, &l.mesh.triangles);
            let there = farthest(&own_points, &bvh).0;
            let back = farthest(&samples(&l.mesh.positions, &l.mesh.triangles, POINTS), &own).0;
            f64::from(there.max(back)) * radius
        })
        .collect();
    let to_metres = ToMetres { base: Vec3::ZERO, scale: radius as f32 };
    let mut levels = vec![PlacedLevel { significant_size: apart[0], ..finest }];
    for (mut level, error) in to_metres.levels(&made.levels).into_iter().zip(apart) {
        for p in &mut level.mesh.positions {
            *p = std::array::from_fn(|i| p[i] + centre[i]);
        }
        let finer = &levels[levels.len() - 1];
        level.error = error.max(finer.error);
        level.significant_size = level.significant_size.max(finer.significant_size * GROWTH);
        levels.push(level);
    }
    Ok(levels)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Silent;
    use image::RgbImage;

    /// A box of 3 × 2 × 1 m on the ground, each side a grid of quads; its left half red, its right half blue.
    fn block(n: u32) -> PlacedLevel {
        let mut mesh = orb_formats::Mesh::default();
        let size = [3.0, 2.0, 1.0];
        for axis in 0..3 {
            for side in [-1.0, 1.0] {
                let (u, v) =
                    if side > 0.0 { ((axis + 1) % 3, (axis + 2) % 3) } else { ((axis + 2) % 3, (axis + 1) % 3) };
                let first = mesh.positions.len() as u32;
                for j in 0..=n {
                    for i in 0..=n {
                        let mut p = [0.0; 3];
                        p[axis] = side * size[axis] / 2.0;
                        p[u] = (f64::from(i) / f64::from(n) - 0.5) * size[u];
                        p[v] = (f64::from(j) / f64::from(n) - 0.5) * size[v];
                        let mut normal = [0.0; 3];
                        normal[axis] = side as f32;
                        mesh.uvs.push([if p[0] < 0.0 { 0.25 } else { 0.75 }, 0.5]);
                        p[2] += 0.5;
                        mesh.positions.push(p);
                        mesh.normals.push(normal);
                    }
                }
                for j in 0..n {
                    for i in 0..n {
                        let at = |i: u32, j: u32| first + j * (n + 1) + i;
                        mesh.triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                        mesh.triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
                    }
                }
            }
        }
        let texture = RgbImage::from_fn(2, 2, |x, _| image::Rgb(if x == 0 { [220, 20, 20] } else { [20, 20, 220] }));
        PlacedLevel { mesh, texture, details: mesh::Details::default(), error: 0.0, significant_size: 14f64.sqrt() }
    }

    #[test]
    fn coarser_levels_keep_place_shape_and_colour() {
        let levels = with_coarser(block(12), 4, &Silent).unwrap();
        let counts: Vec<usize> = levels.iter().map(|l| l.mesh.positions.len()).collect();
        assert_eq!((levels.len(), counts[0]), (3, 1014), "{counts:?}");
        assert!(counts[1] <= 512 && counts[2] <= 128, "{counts:?}");
        for pair in levels.windows(2) {
            assert!(pair[0].significant_size < pair[1].significant_size && pair[0].error <= pair[1].error);
        }
        let coarsest = &levels[2];
        assert!(coarsest.error < 0.3, "{} m off", coarsest.error);
        let (low, high) = coarsest.mesh.bounds().unwrap();
        for (axis, size) in [3.0, 2.0, 1.0].into_iter().enumerate() {
            assert!((high[axis] - low[axis] - size).abs() < 0.3, "{low:?} {high:?}");
        }
        // Which colour each vertex has in its own texture.
        let (w, h) = coarsest.texture.dimensions();
        let (mut right, mut all) = (0, 0);
        for (p, uv) in coarsest.mesh.positions.iter().zip(&coarsest.mesh.uvs).filter(|(p, _)| p[0].abs() > 0.5) {
            let x = ((uv[0] * w as f32) as u32).min(w - 1);
            let y = (((1.0 - uv[1]) * h as f32) as u32).min(h - 1);
            let [red, _, blue] = coarsest.texture.get_pixel(x, y).0;
            all += 1;
            right += i32::from((p[0] < 0.0) == (red > blue));
        }
        assert!(f64::from(right) > 0.9 * f64::from(all), "{right} of {all}");
    }

    #[test]
    fn small_models_stay_alone() {
        assert_eq!(with_coarser(block(2), 4, &Silent).unwrap().len(), 1);
        assert_eq!(with_coarser(block(12), 0, &Silent).unwrap().len(), 1);
    }
}
