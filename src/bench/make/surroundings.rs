//! Ground, a soft shadow and sky behind a thing that was drawn with clear surroundings.

use glam::{Vec2, Vec3};
use image::{Rgb, RgbImage, RgbaImage};

use super::parts::smooth_noise;
use crate::mesh::Mesh;
use crate::splat::Camera;
use crate::splat::train::random::Random;

/// The ground's two colours.
const GROUNDS: [[[f32; 3]; 2]; 4] = [
    [[0.46, 0.45, 0.43], [0.54, 0.53, 0.51]],
    [[0.55, 0.47, 0.35], [0.66, 0.58, 0.45]],
    [[0.34, 0.42, 0.24], [0.44, 0.50, 0.30]],
    [[0.60, 0.59, 0.57], [0.52, 0.52, 0.52]],
];

/// `grain`: how much the ground's brightness varies from stone to stone, parts of itself; 0: smooth.
pub fn behind(cut: &RgbaImage, camera: &Camera, mesh: &Mesh, random: &mut Random, grain: f32) -> RgbImage {
    let ground = GROUNDS[((random.uniform() * 4.0) as usize).min(3)];
    let seed = (random.uniform() * 1e6) as u32;
    let (low, high) = mesh.bounds();
    let size = (high - low).max_element();
    let feet = footprint(mesh);
    let (eye, back) = (camera.position(), camera.rotation.transpose());
    RgbImage::from_fn(cut.width(), cut.height(), |x, y| {
        let ray =
            back * Vec3::new((x as f32 + 0.5 - camera.cx) / camera.fx, (y as f32 + 0.5 - camera.cy) / camera.fy, 1.0);
        let c = if ray.z < -1e-4 {
            let p = (eye - ray * (eye.z / ray.z)).truncate();
            let far = p.distance(eye.truncate());
            let q = p / size;
            let t = 0.6 * smooth_noise(q * 9.0, seed) + 0.4 * smooth_noise(q * 40.0, seed + 1);
            // Ground far away is all one.
            let near = (4.0 * size / far.max(1e-3)).min(1.0);
            let t = 0.5 + (t - 0.5) * near;
            let stones = match grain > 0.0 {
                true => smooth_noise(q * 23.0, seed + 2) + smooth_noise(q * 61.0, seed + 3) - 1.0,
                false => 0.0,
            };
            let d = outside(&feet, p) / (0.10 * size);
            let shadow = 1.0 - 0.55 * (-d * d).exp();
            std::array::from_fn(|k| {
                (ground[0][k] * (1.0 - t) + ground[1][k] * t) * shadow * (1.0 + grain * near * stones)
            })
        } else {
            let t = (ray.normalize().z * 2.5).clamp(0.0, 1.0);
            [0.86 - 0.34 * t, 0.89 - 0.22 * t, 0.92 - 0.06 * t]
        };
        let p = cut.get_pixel(x, y).0;
        let a = f32::from(p[3]) / 255.0;
        Rgb(std::array::from_fn(|k| (f32::from(p[k]) * a + 255.0 * c[k] * (1.0 - a) + 0.5) as u8))
    })
}

/// What of the thing is near the ground: places whose surroundings lie in its shadow.
fn footprint(mesh: &Mesh) -> Vec<[Vec2; 2]> {
    let (low, high) = mesh.bounds();
    let limit = low.z + 0.35 * (high.z - low.z);
    let mut edges = Vec::new();
    for t in &mesh.triangles {
        let corners = t.map(|i| mesh.positions[i as usize]);
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            if corners[a].z.max(corners[b].z) < limit {
                edges.push([corners[a].truncate(), corners[b].truncate()]);
            }
        }
    }
    edges
}

/// Distance from the nearest of the edges.
fn outside(edges: &[[Vec2; 2]], p: Vec2) -> f32 {
    let one = |[a, b]: &[Vec2; 2]| {
        let t = ((p - *a).dot(*b - *a) / (*b - *a).length_squared().max(1e-12)).clamp(0.0, 1.0);
        p.distance_squared(*a + t * (*b - *a))
    };
    edges.iter().map(one).fold(f32::INFINITY, f32::min).sqrt()
}
