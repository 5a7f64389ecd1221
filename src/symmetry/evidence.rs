//! What a plane of symmetry is judged by: what the photo saw, and the shape as far as it is known.

use glam::Vec3;

use crate::mesh::fibonacci_sphere;
use crate::splat::{self, Camera, Gaussians};
use crate::views;

/// Pixels across the photo for the search.
const SIZE: usize = 128;
const AROUND: usize = 14;
const AROUND_SIZE: u32 = 56;

/// The photo's crop.
#[derive(Clone, Copy, Debug)]
pub struct Seen<'a> {
    pub camera: Camera,
    /// sRGB 0..1, row-major, as large as the camera's picture.
    pub color: &'a [[f32; 3]],
    /// 1 on the subject.
    pub mask: &'a [f32],
}

/// Made ready for the search.
pub(super) struct Evidence {
    pub camera: Camera,
    /// Camera z of the surface; 0 off the subject.
    pub depth: Vec<f32>,
    /// Pixels to the subject's mask; 0 on it.
    pub outside: Vec<f32>,
    pub color: Vec<[f32; 3]>,
    /// Surface points that the photo sees, with their colours.
    pub points: Vec<(Vec3, [f32; 3])>,
    /// Surface points from all sides.
    pub shape: Vec<Vec3>,
    pub field: Field,
    pub extents: Extents,
}

impl Evidence {
    /// None when too little of the subject is solid.
    pub fn new(g: &Gaussians, seen: &Seen) -> Option<Self> {
        let size = SIZE.min(seen.camera.width as usize);
        let camera = seen.camera.resized(size as u32, size as u32);
        let frame = splat::render(g, &camera, [0.5; 3]);
        let mask = shrunk(&seen.mask.iter().map(|m| [*m]).collect::<Vec<_>>(), seen.camera.width as usize, size);
        let color = shrunk(seen.color, seen.camera.width as usize, size);
        let solid = |i: usize| mask[i][0] > 0.5 && frame.alpha[i] > 0.5 && frame.median_depth[i] > 0.0;
        let depth: Vec<f32> = (0..size * size).map(|i| if solid(i) { frame.median_depth[i] } else { 0.0 }).collect();
        let on: Vec<bool> = mask.iter().map(|m| m[0] > 0.5).collect();
        let points: Vec<(Vec3, [f32; 3])> = (0..size * size)
            .filter(|&i| depth[i] > 0.0 && (i % size + i / size).is_multiple_of(2))
            .map(|i| (lifted(&camera, i, depth[i]), color[i]))
            .collect();
        let mut shape = Vec::new();
        for direction in fibonacci_sphere(AROUND) {
            let camera = Camera::look_at(direction * views::DISTANCE, Vec3::ZERO, views::FOV, AROUND_SIZE);
            let frame = splat::render(g, &camera, [0.5; 3]);
            let solid = |i: &usize| frame.alpha[*i] > 0.5 && frame.median_depth[*i] > 0.0;
            shape.extend((0..frame.alpha.len()).filter(solid).map(|i| lifted(&camera, i, frame.median_depth[i])));
        }
        shape.retain(|p| p.length() < 1.5);
        let enough = points.len() >= 100 && shape.len() >= 200;
        enough.then(|| Evidence {
            camera,
            depth,
            outside: distance_outside(&on, size),
            color,
            points,
            field: Field::new(&shape),
            extents: Extents::new(&shape),
            shape,
        })
    }
}

/// How far points reach along a direction, but for the fiftieth of them at either end.
pub(super) fn extent(points: &[Vec3], along: Vec3) -> f32 {
    let mut at: Vec<f32> = points.iter().map(|p| p.dot(along)).collect();
    at.sort_by(f32::total_cmp);
    let few = at.len() / 50;
    at[at.len() - 1 - few] - at[few]
}

/// How far a shape reaches along level directions, every three degrees of half a turn.
pub(super) struct Extents([f32; 60]);

impl Extents {
    fn new(points: &[Vec3]) -> Self {
        Extents(std::array::from_fn(|k| {
            let (sin, cos) = (3.0 * k as f32).to_radians().sin_cos();
            extent(points, Vec3::new(cos, sin, 0.0)).max(1e-3)
        }))
    }

    /// Along the direction nearest to `v`.
    pub fn along(&self, v: Vec3) -> f32 {
        let heading = v.y.atan2(v.x).to_degrees().rem_euclid(180.0);
        self.0[(heading / 3.0).round() as usize % 60]
    }
}

/// Pixel `i` at camera depth `z` in the world.
pub(super) fn lifted(camera: &Camera, i: usize, z: f32) -> Vec3 {
    let (x, y) = (i % camera.width as usize, i / camera.width as usize);
    let at = Vec3::new((x as f32 + 0.5 - camera.cx) / camera.fx, (y as f32 + 0.5 - camera.cy) / camera.fy, 1.0) * z;
    camera.rotation.transpose() * (at - camera.translation)
}

/// Pixel column, row and camera depth of a point.
pub(super) fn projected(camera: &Camera, p: Vec3) -> Vec3 {
    let q = camera.rotation * p + camera.translation;
    let z = q.z.max(1e-3);
    Vec3::new(camera.fx * q.x / z + camera.cx, camera.fy * q.y / z + camera.cy, q.z)
}

/// A square picture to `to` pixels across, each the mean of those under it.
fn shrunk<const N: usize>(picture: &[[f32; N]], from: usize, to: usize) -> Vec<[f32; N]> {
    let edge = |k: usize| k * from / to;
    (0..to * to)
        .map(|i| {
            let (x, y) = (i % to, i / to);
            let mut sum = [0.0; N];
            let mut count = 0.0;
            for row in edge(y)..edge(y + 1) {
                for pixel in &picture[row * from + edge(x)..row * from + edge(x + 1)] {
                    sum.iter_mut().zip(pixel).for_each(|(s, v)| *s += v);
                    count += 1.0;
                }
            }
            sum.map(|s| s / f32::max(count, 1.0))
        })
        .collect()
}

/// Steps and diagonal steps, two sweeps (Borgefors 1986).
fn distance_outside(on: &[bool], size: usize) -> Vec<f32> {
    let mut d: Vec<f32> = on.iter().map(|on| if *on { 0.0 } else { 1e6 }).collect();
    let mut sweep = |i: usize, steps: [(isize, isize); 4]| {
        let (x, y) = ((i % size) as isize, (i / size) as isize);
        for (dx, dy) in steps {
            let (u, v) = (x + dx, y + dy);
            if u >= 0 && v >= 0 && u < size as isize && v < size as isize {
                let step = if dx != 0 && dy != 0 { std::f32::consts::SQRT_2 } else { 1.0 };
                d[i] = d[i].min(d[v as usize * size + u as usize] + step);
            }
        }
    };
    (0..size * size).for_each(|i| sweep(i, [(-1, 0), (0, -1), (-1, -1), (1, -1)]));
    (0..size * size).rev().for_each(|i| sweep(i, [(1, 0), (0, 1), (1, 1), (-1, 1)]));
    d
}

/// Distance to the nearest of a set of points, on a grid over the unit frame.
pub(super) struct Field {
    cells: Vec<f32>,
}

impl Field {
    const N: usize = 80;
    const HALF: f32 = 1.5;
    /// Beyond this all is equally far.
    pub const FAR: f32 = 0.3;

    /// Each cell takes over the nearest point of the neighbours that were swept before it (Danielsson 1980).
    pub fn new(points: &[Vec3]) -> Self {
        const NONE: u32 = u32::MAX;
        let n = Self::N;
        let size = 2.0 * Self::HALF / n as f32;
        let centre = |at: [usize; 3]| Vec3::from_array(at.map(|v| (v as f32 + 0.5) * size - Self::HALF));
        let index = |at: [usize; 3]| (at[2] * n + at[1]) * n + at[0];
        let away = |nearest: u32, at: [usize; 3]| match points.get(nearest as usize) {
            Some(p) => p.distance_squared(centre(at)),
            None => f32::INFINITY,
        };
        let mut nearest = vec![NONE; n * n * n];
        for (k, &p) in points.iter().enumerate() {
            let at = Self::place(p).map(|v| (v.max(0.0) as usize).min(n - 1));
            if away(k as u32, at) < away(nearest[index(at)], at) {
                nearest[index(at)] = k as u32;
            }
        }
        // Steps to the 13 neighbours that a sweep has passed already.
        let before: Vec<[isize; 3]> = (0..13).map(|k: isize| [k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1]).collect();
        let mut sweep = |i: usize, sign: isize| {
            let at = [i % n, i / n % n, i / (n * n)];
            let mut least = away(nearest[i], at);
            for step in &before {
                let to: [usize; 3] = std::array::from_fn(|k| at[k].wrapping_add_signed(sign * step[k]));
                let other = if to.iter().all(|v| *v < n) { nearest[index(to)] } else { NONE };
                if other != NONE && other != nearest[i] && away(other, at) < least {
                    (nearest[i], least) = (other, away(other, at));
                }
            }
        };
        for _ in 0..2 {
            (0..n * n * n).for_each(|i| sweep(i, 1));
            (0..n * n * n).rev().for_each(|i| sweep(i, -1));
        }
        let at = |i: usize| [i % n, i / n % n, i / (n * n)];
        Field { cells: (0..n * n * n).map(|i| away(nearest[i], at(i)).sqrt().min(Self::FAR)).collect() }
    }

    fn place(p: Vec3) -> [f32; 3] {
        ((p + Self::HALF) / (2.0 * Self::HALF) * Self::N as f32).to_array()
    }

    /// Trilinear.
    pub fn at(&self, p: Vec3) -> f32 {
        let n = Self::N;
        let q = Self::place(p).map(|v| v - 0.5);
        if !q.iter().all(|v| *v >= 0.0 && *v < (n - 1) as f32) {
            return Self::FAR;
        }
        let low = q.map(|v| v as usize);
        let t: [f32; 3] = std::array::from_fn(|k| q[k] - low[k] as f32);
        let [across, down, up] = t.map(|t| [1.0 - t, t]);
        let mut sum = 0.0;
        for (k, up) in up.into_iter().enumerate() {
            for (j, down) in down.into_iter().enumerate() {
                let row = &self.cells[((low[2] + k) * n + low[1] + j) * n + low[0]..][..2];
                sum += across[0] * down * up * row[0];
                sum += across[1] * down * up * row[1];
            }
        }
        sum
    }
}
