//! What a level's triangles lost, as textures: normals of the surface before simplification in the level's tangent space,
//! and ambient occlusion.

use super::bake::texels;
use super::distance::{Bvh, barycentric_3d};
use super::fill::pad;
use super::raster::visibility;
use super::smooth::vertex_normals;
use super::{Details, Mesh, Options, Surface, cross, surrounding_cameras};
use glam::Vec3;
use image::{GrayImage, Luma, Rgb, RgbImage};
use rayon::prelude::*;

/// Directions from which light may come, and pixels across a view from each.
const LIGHTS: usize = 96;
const VIEW_SIZE: u32 = 256;
/// A texel's surface lies no further away, scene units; beyond it the nearest that looks any way is taken.
const NEAR: f32 = 0.3;

/// The surface before simplification, ready to be asked.
pub struct Fine<'a> {
    surface: &'a Surface,
    bvh: Bvh,
    normals: Vec<Vec3>,
    /// How much of the light from all around arrives at each vertex, 0..1; empty when nobody asks.
    open: Vec<f32>,
}

impl<'a> Fine<'a> {
    pub fn new(surface: &'a Surface, options: &Options) -> Self {
        let normals = vertex_normals(&surface.positions, &surface.triangles);
        let open = if options.occlusion { openness(surface, &normals) } else { Vec::new() };
        Fine { surface, bvh: Bvh::new(&surface.positions, &surface.triangles), normals, open }
    }

    /// Normal and openness at the point closest to `p` that looks the way of `normal`.
    fn at(&self, p: Vec3, normal: Vec3) -> Option<(Vec3, f32)> {
        let Surface { positions, triangles } = self.surface;
        let looks_alike = |t: u32| cross(positions, &triangles[t as usize]).dot(normal) > 0.0;
        let found =
            self.bvh.closest(p, NEAR, looks_alike).or_else(|| self.bvh.closest(p, f32::MAX.sqrt(), |_| true))?;
        let t = triangles[found.triangle as usize].map(|i| i as usize);
        let w = barycentric_3d(found.point, t.map(|i| positions[i])).to_array();
        let there: Vec3 = (0..3).map(|k| w[k] * self.normals[t[k]]).sum();
        let open = if self.open.is_empty() { 1.0 } else { (0..3).map(|k| w[k] * self.open[t[k]]).sum() };
        Some((there.try_normalize()?, open))
    }
}

/// The share of light from evenly around that arrives at each vertex, by the cosine law; nothing stands around it, the ground
/// neither.
fn openness(surface: &Surface, normals: &[Vec3]) -> Vec<f32> {
    let mut sums = vec![[0f32; 2]; surface.positions.len()];
    for camera in surrounding_cameras(LIGHTS, VIEW_SIZE) {
        let seen = visibility(&surface.positions, &surface.triangles, &camera);
        let eye = camera.position();
        sums.par_iter_mut().zip(&surface.positions).zip(normals).for_each(|((sum, p), n)| {
            let straight = n.dot((eye - *p).normalize_or_zero());
            if straight <= 0.0 {
                return;
            }
            let q = camera.rotation * *p + camera.translation;
            let (u, v) = (camera.fx * q.x / q.z + camera.cx, camera.fy * q.y / q.z + camera.cy);
            sum[1] += straight;
            let inside = u >= 0.0 && v >= 0.0 && u < VIEW_SIZE as f32 && v < VIEW_SIZE as f32;
            let depth = if inside { seen.depth[v as usize * seen.width + u as usize] } else { 0.0 };
            let slope = (1.0 - straight * straight).max(0.0).sqrt() / straight;
            let slack = 2.5 * q.z / camera.fx * (1.0 + slope.min(5.0));
            if depth == 0.0 || q.z <= depth + slack {
                sum[0] += straight;
            }
        });
    }
    sums.iter().map(|s| if s[1] > 0.0 { s[0] / s[1] } else { 1.0 }).collect()
}

/// The textures that `options` asks for, `size` texels square, for a level.
pub fn details(level: &Mesh, size: u32, fine: &Fine, options: &Options) -> Details {
    let tangents = tangents(level);
    let n = size as usize;
    let mut normals = vec![[0.0, 0.0, 1.0]; n * n];
    let mut open = vec![[1.0; 3]; n * n];
    let mut covered = vec![false; n * n];
    let found: Vec<(usize, [f32; 3], f32)> = texels(level, n)
        .par_iter()
        .filter_map(|texel| {
            let (there, open) = fine.at(texel.position, texel.normal)?;
            let corners = level.triangles[texel.triangle as usize].map(|i| tangents[i as usize]);
            let along: Vec3 = (0..3).map(|k| texel.weights[k] * corners[k].0).sum();
            let normal = texel.normal;
            let right = (along - along.dot(normal) * normal).try_normalize()?;
            let up = corners[0].1 * normal.cross(right);
            let local = Vec3::new(there.dot(right), there.dot(up), there.dot(normal).max(0.1)).normalize();
            Some((texel.index as usize, local.to_array(), open))
        })
        .collect();
    for (i, local, light) in found {
        (normals[i], open[i], covered[i]) = (local, [light; 3], true);
    }
    let byte = |v: f32| (v.clamp(0.0, 1.0) * 255.0).round() as u8;
    let at = |x: u32, y: u32| y as usize * n + x as usize;
    Details {
        normals: options.normal_map.then(|| {
            pad(&mut normals, |i| covered[i], n);
            RgbImage::from_fn(size, size, |x, y| {
                let v = Vec3::from_array(normals[at(x, y)]).try_normalize().unwrap_or(Vec3::Z);
                Rgb((v * 0.5 + 0.5).to_array().map(byte))
            })
        }),
        occlusion: options.occlusion.then(|| {
            pad(&mut open, |i| covered[i], n);
            GrayImage::from_fn(size, size, |x, y| Luma([byte(open[at(x, y)][0])]))
        }),
    }
}

/// As the files have them: tangent and the sign of the third axis.
fn tangents(level: &Mesh) -> Vec<(Vec3, f32)> {
    let mesh = orb_formats::Mesh {
        positions: level.positions.iter().map(|p| p.as_dvec3().to_array()).collect(),
        normals: level.normals.iter().map(|n| n.to_array()).collect(),
        uvs: level.uvs.iter().map(|t| t.to_array()).collect(),
        triangles: level.triangles.clone(),
    };
    mesh.tangents().iter().map(|&[x, y, z, sign]| (Vec3::new(x, y, z), sign)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::{pack, scenes, unwrap};
    use super::*;

    const BOTH: Options = Options {
        cut_off_below: false,
        normal_map: true,
        occlusion: true,
        voxels: 72,
        levels: 1,
        vertex_caps: [8192, 2048, 512, 128],
        triangles: None,
        texture_size: [256, 128, 64, 64],
        views: 36,
        view_size: 144,
        color_views: 16,
        color_size: 128,
        background: [0.5; 3],
    };

    fn unwrapped(surface: &Surface, size: u32) -> Mesh {
        let charts = unwrap::charts(surface, &unwrap::FLAT, 4e5);
        let atlas = pack::pack(&charts, size).unwrap();
        unwrap::assemble(surface, &charts, &atlas.uv)
    }

    #[test]
    fn a_coarse_ball_shades_like_the_rippled_one_that_it_comes_from() {
        let mut fine = scenes::sampled(&scenes::sphere(0.8), 64);
        fine.positions.iter_mut().for_each(|p| *p *= 1.0 + 0.02 * (14.0 * p.x).sin() * (11.0 * p.z).cos());
        let mut coarse = super::super::simplify::Simplifier::new(&fine);
        assert!(coarse.reduce_to(120));
        let level = unwrapped(&coarse.surface(), 256);
        let asked = Fine::new(&fine, &BOTH);
        let found = details(&level, 256, &asked, &BOTH);
        let (normals, occlusion) = (found.normals.unwrap(), found.occlusion.unwrap());
        let tangents = tangents(&level);
        let (mut with, mut without, mut light, mut count) = (0.0, 0.0, 0.0, 0.0);
        for t in texels(&level, 256) {
            let (x, y) = (t.index % 256, t.index / 256);
            let v = Vec3::from_array(normals.get_pixel(x, y).0.map(|c| f32::from(c) / 127.5 - 1.0));
            let corners = level.triangles[t.triangle as usize].map(|i| tangents[i as usize]);
            let along: Vec3 = (0..3).map(|k| t.weights[k] * corners[k].0).sum();
            let right = (along - along.dot(t.normal) * t.normal).normalize();
            let shaded = v.x * right + v.y * corners[0].1 * t.normal.cross(right) + v.z * t.normal;
            let truth = asked.at(t.position, t.normal).unwrap().0;
            with += shaded.angle_between(truth);
            without += t.normal.angle_between(truth);
            count += 1.0;
            light += f32::from(occlusion.get_pixel(x, y).0[0]) / 255.0;
        }
        // Ripples hide little of a ball's light.
        assert!(light / count > 0.9, "{}", light / count);
        assert!(with < 0.3 * without && with / count < 0.03, "{} of {}", with / count, without / count);
    }

    #[test]
    fn between_two_plates_it_is_dark() {
        let plates = scenes::sampled(&scenes::two_plates(0.16), 96);
        let fine = Fine::new(&plates, &BOTH);
        let between = fine.at(Vec3::new(0.0, 0.08, 0.0), Vec3::NEG_Y).unwrap().1;
        let outside = fine.at(Vec3::new(0.0, 0.16, 0.0), Vec3::Y).unwrap().1;
        assert!(between < 0.35 && outside > 0.97, "{between} {outside}");
    }
}
