//! What one view says of a point: how far in front of the surface it lies, or that there is nothing; and how far views
//! disagree.

use super::{SUBJECT_RADIUS, View};
use crate::splat::Camera;
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// One view made ready for fusion.
pub struct DepthMap {
    pub(super) camera: Camera,
    /// z > 0: surface `[z, ∂z/∂u, ∂z/∂v, c]`, c = perpendicular over z-distance; z = 0: `[0, 0, 0, trust]` of seeing through.
    pub(super) texels: Vec<[f32; 4]>,
}

impl DepthMap {
    pub fn new(view: &View) -> Self {
        let camera = view.camera;
        let (w, h) = (camera.width as usize, camera.height as usize);
        let solid = |i: usize| view.solid(i);
        let texels = (0..w * h)
            .map(|i| {
                if !solid(i) {
                    // Half stopped says nothing either way: thin parts look like that.
                    return [0.0, 0.0, 0.0, ((0.35 - view.firmness(i)) / 0.25).clamp(0.0, 1.0)];
                }
                let (x, y) = (i % w, i / w);
                let z = view.depth[i];
                // The smaller of the one-sided differences: the other may reach across an edge.
                let slope = |before: Option<usize>, after: Option<usize>| {
                    let a = before.filter(|&j| solid(j)).map(|j| z - view.depth[j]);
                    let b = after.filter(|&j| solid(j)).map(|j| view.depth[j] - z);
                    match (a, b) {
                        (Some(a), Some(b)) => Some(if a.abs() < b.abs() { a } else { b }),
                        (a, b) => a.or(b),
                    }
                };
                let limit = 4.0 * z / camera.fx.max(camera.fy);
                let zu = slope((x > 0).then(|| i.wrapping_sub(1)), (x + 1 < w).then_some(i + 1));
                let zv = slope((y > 0).then(|| i.wrapping_sub(w)), (y + 1 < h).then_some(i + w));
                match (zu, zv) {
                    (Some(zu), Some(zv)) if zu.abs() < limit && zv.abs() < limit => {
                        let px = (x as f32 + 0.5 - camera.cx) / camera.fx;
                        let py = (y as f32 + 0.5 - camera.cy) / camera.fy;
                        // |∇(Z − z(u, v))| at the surface point, u = fx X / Z + cx.
                        let gx = -zu * camera.fx / z;
                        let gy = -zv * camera.fy / z;
                        let gz = 1.0 - gx * px - gy * py;
                        [z, zu, zv, (gx * gx + gy * gy + gz * gz).sqrt().recip().clamp(0.2, 1.0)]
                    }
                    _ => [z, 0.0, 0.0, 0.3],
                }
            })
            .collect();
        DepthMap { camera, texels }
    }

    /// The texel that shows a point in the camera's coordinates, and how far from its middle, pixels; None outside the picture.
    pub(super) fn texel(&self, p: Vec3) -> Option<(&[f32; 4], Vec2)> {
        let c = &self.camera;
        if p.z <= 1e-3 {
            return None;
        }
        let inverse = 1.0 / p.z;
        let (u, v) = (c.fx * p.x * inverse + c.cx, c.fy * p.y * inverse + c.cy);
        if !(u >= 0.0 && v >= 0.0 && u < c.width as f32 && v < c.height as f32) {
            return None;
        }
        // Casts, not floor(): that is a call on plain x86-64.
        let (column, row) = (u as u32, v as u32);
        let off = Vec2::new(u - column as f32 - 0.5, v - row as f32 - 0.5);
        Some((&self.texels[(row * c.width + column) as usize], off))
    }

    /// How far in front of the surface a point in the camera's coordinates lies, perpendicular to it, and how straight the view
    /// is, like a cosine; None where the view shows no surface.
    pub(super) fn distance(&self, p: Vec3) -> Option<(f32, f32)> {
        let (t, off) = self.texel(p)?;
        let surface = t[0] + t[1] * off.x + t[2] * off.y;
        (t[0] != 0.0).then_some(((surface - p.z) * t[3], t[3]))
    }

    /// Surface points and their outward normals.
    pub(super) fn oriented_points(&self) -> impl Iterator<Item = (Vec3, Vec3)> + '_ {
        let c = &self.camera;
        let inverse = c.rotation.transpose();
        self.texels.iter().enumerate().filter(|(_, t)| t[0] > 0.0 && t[3] > 0.4).map(move |(i, t)| {
            let (x, y) = (i % c.width as usize, i / c.width as usize);
            let q = Vec3::new((x as f32 + 0.5 - c.cx) / c.fx, (y as f32 + 0.5 - c.cy) / c.fy, 1.0);
            let (gx, gy) = (-t[1] * c.fx / t[0], -t[2] * c.fy / t[0]);
            let away = Vec3::new(gx, gy, 1.0 - gx * q.x - gy * q.y);
            (inverse * (q * t[0] - c.translation), -(inverse * away).normalize_or_zero())
        })
    }

    /// Every pixel's surface point that lies where all views look.
    pub(super) fn points(&self) -> impl Iterator<Item = Vec3> + '_ {
        let c = &self.camera;
        let inverse = c.rotation.transpose();
        self.texels.iter().enumerate().filter(|(_, t)| t[0] > 0.0).filter_map(move |(i, t)| {
            let (x, y) = (i % c.width as usize, i / c.width as usize);
            let p = Vec3::new((x as f32 + 0.5 - c.cx) / c.fx, (y as f32 + 0.5 - c.cy) / c.fy, 1.0) * t[0];
            let p = inverse * (p - c.translation);
            (p.length() < SUBJECT_RADIUS).then_some(p)
        })
    }
}

/// How far views disagree about the surface: the scale (1.48 · median) of the distance from one view's surface points to
/// what other views that look straight at them see.
pub(super) fn disagreement(maps: &[DepthMap]) -> f32 {
    /// Disagreement beyond this is another surface.
    const OTHER: f32 = 0.15;
    let mut distances: Vec<f32> = (0..maps.len())
        .into_par_iter()
        .flat_map_iter(|m| {
            let points: Vec<(Vec3, Vec3)> = maps[m].oriented_points().step_by(61).collect();
            let others = (1..maps.len()).step_by(5).map(move |k| &maps[(m + k) % maps.len()]);
            others.flat_map(move |other| {
                points
                    .iter()
                    .filter(|(p, n)| n.dot((other.camera.position() - *p).normalize_or_zero()) > 0.5)
                    .filter_map(|(p, _)| other.distance(other.camera.rotation * *p + other.camera.translation))
                    .filter_map(|(d, straight)| (straight > 0.4).then_some(d.abs()))
                    .filter(|d| *d < OTHER)
                    .collect::<Vec<f32>>()
            })
        })
        .collect();
    if distances.is_empty() {
        return 0.0;
    }
    let half = distances.len() / 2;
    let (_, median, _) = distances.select_nth_unstable_by(half, f32::total_cmp);
    1.48 * *median
}
