//! Analytic scenes for tests: signed distance functions, ray-marched.

use super::fuse::Volume;
use super::{MEDIAN, Surface, View, extract};
use crate::splat::Camera;
use glam::{Vec2, Vec3};
use rayon::prelude::*;

type Distance = Box<dyn Fn(Vec3) -> f32 + Sync>;
type Color = Box<dyn Fn(Vec3, Vec3) -> [f32; 3] + Sync>;

pub struct Scene {
    pub distance: Distance,
    /// sRGB from position and normal.
    pub color: Color,
}

pub const BACKGROUND: [f32; 3] = [0.5; 3];

impl Scene {
    pub fn new(distance: impl Fn(Vec3) -> f32 + Sync + 'static) -> Self {
        Scene { distance: Box::new(distance), color: Box::new(|_, n| by_side(n)) }
    }

    pub fn normal(&self, p: Vec3) -> Vec3 {
        let e = 1e-3;
        let d = |a: Vec3| (self.distance)(p + a * e) - (self.distance)(p - a * e);
        Vec3::new(d(Vec3::X), d(Vec3::Y), d(Vec3::Z)).normalize_or_zero()
    }

    /// Where a ray hits, as distance along it.
    fn march(&self, eye: Vec3, direction: Vec3) -> Option<f32> {
        let mut t = (eye.length() - 1.3).max(0.0);
        let end = eye.length() + 1.3;
        for _ in 0..160 {
            let d = (self.distance)(eye + direction * t);
            if d < 4e-4 {
                return Some(t);
            }
            t += d;
            if t > end {
                return None;
            }
        }
        None
    }

    pub fn render(&self, camera: &Camera) -> View {
        let (w, h) = (camera.width as usize, camera.height as usize);
        let eye = camera.position();
        let pixels: Vec<([f32; 3], f32, f32)> = (0..w * h)
            .into_par_iter()
            .map(|i| {
                let x = ((i % w) as f32 + 0.5 - camera.cx) / camera.fx;
                let y = ((i / w) as f32 + 0.5 - camera.cy) / camera.fy;
                let along = Vec3::new(x, y, 1.0).normalize();
                let direction = camera.rotation.transpose() * along;
                match self.march(eye, direction) {
                    Some(t) => {
                        let p = eye + direction * t;
                        ((self.color)(p, self.normal(p)), 1.0, t * along.z)
                    }
                    None => (BACKGROUND, 0.0, 0.0),
                }
            })
            .collect();
        View {
            camera: *camera,
            color: pixels.iter().map(|p| p.0).collect(),
            alpha: pixels.iter().map(|p| p.1).collect(),
            depth: pixels.iter().map(|p| p.2).collect(),
            passing: MEDIAN,
        }
    }
}

/// +x red, −x cyan, +y green, −y magenta, +z blue, −z yellow.
pub fn by_side(n: Vec3) -> [f32; 3] {
    let a = n.abs();
    let (k, positive) = if a.x >= a.y && a.x >= a.z {
        (0, n.x > 0.0)
    } else if a.y >= a.z {
        (1, n.y > 0.0)
    } else {
        (2, n.z > 0.0)
    };
    std::array::from_fn(|i| if (i == k) == positive { 0.9 } else { 0.1 })
}

pub fn depth_cameras(count: usize, size: u32) -> Vec<Camera> {
    super::surrounding_cameras(count, size)
}

/// The scene's own surface from samples of its function, `n` along each axis.
pub fn sampled(scene: &Scene, n: usize) -> Surface {
    let voxel = 2.2 / (n - 1) as f32;
    let mut v = Volume {
        origin: Vec3::splat(-1.1),
        voxel,
        dims: [n; 3],
        truncation: 1.0,
        data: vec![1.0; n * n * n],
        noise: 0.0,
    };
    for z in 1..n - 1 {
        for y in 1..n - 1 {
            for x in 1..n - 1 {
                let i = v.index(x, y, z);
                v.data[i] = (scene.distance)(v.position(x, y, z));
            }
        }
    }
    extract::extract(&v)
}

fn box_distance(p: Vec3, half: Vec3) -> f32 {
    let q = p.abs() - half;
    q.max(Vec3::ZERO).length() + q.max_element().min(0.0)
}

/// Axis along y.
fn cylinder_distance(p: Vec3, radius: f32, half: f32) -> f32 {
    let d = Vec2::new(Vec2::new(p.x, p.z).length() - radius, p.y.abs() - half);
    d.max(Vec2::ZERO).length() + d.max_element().min(0.0)
}

pub fn empty() -> Scene {
    Scene::new(|_| 10.0)
}

pub fn sphere(radius: f32) -> Scene {
    Scene::new(move |p| p.length() - radius)
}

pub fn boxed(x: f32, y: f32, z: f32) -> Scene {
    Scene::new(move |p| box_distance(p, Vec3::new(x, y, z)))
}

/// A box with a thin mast in the middle of its top, up to z = 0.6.
pub fn boxed_with_mast(x: f32, y: f32, z: f32) -> Scene {
    Scene::new(move |p| {
        let mast = box_distance(p - Vec3::new(0.0, 0.0, z / 2.0 + 0.3), Vec3::new(0.015, 0.015, 0.3 - z / 2.0));
        box_distance(p, Vec3::new(x, y, z)).min(mast)
    })
}

/// A box with two arms at its side +x, which hold a thin upright bar before it, or nothing.
pub fn boxed_with_arms(x: f32, y: f32, z: f32, bar: bool) -> Scene {
    Scene::new(move |p| {
        let arm = |at: f32| box_distance(p - Vec3::new(x + 0.1, 0.0, at), Vec3::new(0.1, 0.04, 0.03));
        let held = box_distance(p - Vec3::new(x + 0.2, 0.0, 0.0), Vec3::new(0.015, 0.015, 1.6 * z));
        let bare = box_distance(p, Vec3::new(x, y, z)).min(arm(0.7 * z)).min(arm(-0.7 * z));
        if bar { bare.min(held) } else { bare }
    })
}

/// 1.2 × 0.8, upright, facing y.
pub fn plate(thickness: f32) -> Scene {
    Scene::new(move |p| box_distance(p, Vec3::new(0.6, thickness / 2.0, 0.4)))
}

/// Two upright plates 1.2 × 0.8 and 0.06 thick, facing each other over a gap along y.
pub fn two_plates(gap: f32) -> Scene {
    Scene::new(move |p| {
        let plate =
            |side: f32| box_distance(p - Vec3::new(0.0, side * (gap / 2.0 + 0.03), 0.0), Vec3::new(0.6, 0.03, 0.4));
        plate(1.0).min(plate(-1.0))
    })
}

pub fn two_spheres() -> Scene {
    Scene::new(|p| ((p - Vec3::new(-0.4, 0.0, 0.0)).length() - 0.5).min((p - Vec3::new(0.6, 0.0, 0.0)).length() - 0.3))
}

/// Body, cabin, four wheels, a mast and a thin spoiler; front at +x.
pub fn car() -> Scene {
    Scene::new(|p| {
        let body = box_distance(p - Vec3::new(0.0, 0.0, -0.05), Vec3::new(0.8, 0.33, 0.14)) - 0.02;
        let cabin = box_distance(p - Vec3::new(-0.1, 0.0, 0.2), Vec3::new(0.4, 0.28, 0.15)) - 0.02;
        let mast = box_distance(p - Vec3::new(-0.7, 0.2, 0.25), Vec3::new(0.014, 0.014, 0.25));
        let spoiler = box_distance(p - Vec3::new(-0.75, 0.0, 0.22), Vec3::new(0.1, 0.3, 0.012));
        let post = box_distance(p - Vec3::new(-0.75, 0.0, 0.15), Vec3::new(0.03, 0.02, 0.08));
        let wheel = |x: f32, y: f32| cylinder_distance(p - Vec3::new(x, y, -0.25), 0.16, 0.06);
        let wheels = wheel(0.5, 0.3).min(wheel(0.5, -0.3)).min(wheel(-0.5, 0.3)).min(wheel(-0.5, -0.3));
        body.min(cabin).min(mast).min(spoiler).min(post).min(wheels)
    })
}
