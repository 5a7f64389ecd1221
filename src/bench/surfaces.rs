//! What can be seen of surfaces from around them, how far two lie apart, and how one is moved onto another.

use glam::{Mat3, Vec3};
use rayon::prelude::*;

use crate::mesh::distance::Bvh;
use crate::mesh::raster::visibility;
use crate::mesh::{Surface, cross, surrounding_cameras};
use crate::splat::Camera;

/// What of a surface can be seen from around it.
pub struct Shape {
    pub points: Vec<Vec3>,
    /// The triangles that the points lie on; none for a shape of depth maps.
    owners: Vec<u32>,
    corners: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    bvh: Bvh,
    /// Depth from [`surrounding_cameras`], camera z, 0 for nothing; a moved shape has none.
    depths: Vec<Vec<f32>>,
}

const VIEWS: usize = 32;
const VIEW_SIZE: u32 = 128;
const POINTS: usize = 20_000;

impl Shape {
    /// Of triangles: points and triangles seen from around; what lies inside does not count.
    pub fn of_surface(surface: &Surface) -> Self {
        let mut used = vec![false; surface.triangles.len()];
        let mut points = Vec::new();
        let mut depths = Vec::new();
        for camera in surrounding_cameras(VIEWS, VIEW_SIZE) {
            let seen = visibility(&surface.positions, &surface.triangles, &camera);
            for (i, &t) in seen.triangle.iter().enumerate().filter(|(_, t)| **t != u32::MAX) {
                used[t as usize] = true;
                points.push((lifted(&camera, i, seen.depth[i]), t));
            }
            depths.push(seen.depth);
        }
        let mut renumbered = vec![0; used.len()];
        let mut triangles = Vec::new();
        for t in (0..used.len()).filter(|t| used[*t]) {
            renumbered[t] = triangles.len() as u32;
            triangles.push(surface.triangles[t]);
        }
        let points = fewer(points);
        Shape {
            owners: points.iter().map(|(_, t)| renumbered[*t as usize]).collect(),
            points: points.into_iter().map(|(p, _)| p).collect(),
            bvh: Bvh::new(&surface.positions, &triangles),
            corners: surface.positions.clone(),
            triangles,
            depths,
        }
    }

    /// Of depth maps, `depth(camera)` in camera z, 0 for nothing.
    pub fn of_depth(depth: impl Fn(&Camera) -> Vec<f32> + Sync) -> Self {
        let cameras = surrounding_cameras(VIEWS, VIEW_SIZE);
        let depths: Vec<Vec<f32>> = cameras.iter().map(depth).collect();
        let points: Vec<Vec3> = cameras
            .iter()
            .zip(&depths)
            .flat_map(|(camera, depth)| {
                let found = depth.iter().enumerate().filter(|(_, z)| **z > 0.0);
                found.map(|(i, z)| lifted(camera, i, *z)).collect::<Vec<Vec3>>()
            })
            .filter(|p| p.length() < 1.3)
            .collect();
        let triangles: Vec<[u32; 3]> = (0..points.len() as u32).map(|i| [i; 3]).collect();
        let bvh = Bvh::new(&points, &triangles);
        Shape { bvh, points: fewer(points.clone()), owners: Vec::new(), corners: points, triangles, depths }
    }

    /// The mean cosine between the normals at this shape's points and those at the closest points of the other, both as
    /// their triangles are wound. None for shapes without triangles.
    fn normals_towards(&self, other: &Shape) -> Option<f64> {
        let normal = |s: &Shape, t: u32| cross(&s.corners, &s.triangles[t as usize]).normalize_or_zero();
        let near = |(p, own): (&Vec3, &u32)| {
            let there = other.bvh.closest(*p, f32::MAX.sqrt(), |_| true)?;
            Some(f64::from(normal(self, *own).dot(normal(other, there.triangle))))
        };
        let cosines: Vec<f64> = self.points.par_iter().zip(&self.owners).filter_map(near).collect();
        (!cosines.is_empty() && !other.owners.is_empty()).then(|| cosines.iter().sum::<f64>() / cosines.len() as f64)
    }

    /// Mean of both directions' [`Self::normals_towards`] (Mescheder et al. 2019, without their absolute value).
    pub fn normal_consistency(&self, other: &Shape) -> Option<f64> {
        Some((self.normals_towards(other)? + other.normals_towards(self)?) / 2.0)
    }

    /// Whether a point is inside what no camera around sees past: space carving (Kutulakos and Seitz 2000). What a shape
    /// holds inside does not matter, nor whether it is closed.
    fn holds(&self, cameras: &[Camera], p: Vec3) -> bool {
        cameras.iter().zip(&self.depths).all(|(camera, depth)| {
            let q = camera.rotation * p + camera.translation;
            let (x, y) = (camera.fx * q.x / q.z + camera.cx, camera.fy * q.y / q.z + camera.cy);
            if !(q.z > 0.0 && x >= 0.0 && y >= 0.0 && x < camera.width as f32 && y < camera.height as f32) {
                return true;
            }
            let z = depth[y as usize * camera.width as usize + x as usize];
            z > 0.0 && q.z >= z
        })
    }

    /// Shared over joint volume of two shapes' insides, on a grid of so many cells along the longest side of `low` to
    /// `high`. None where neither has an inside.
    pub fn volume_iou(&self, other: &Shape, (low, high): (Vec3, Vec3), cells: usize) -> Option<f64> {
        let cameras = surrounding_cameras(VIEWS, VIEW_SIZE);
        let step = (high - low).max_element() / cells as f32;
        if step.is_nan() || step <= 0.0 {
            return None;
        }
        let n = ((high - low) / step).ceil().max(Vec3::ONE).as_uvec3();
        let count = n.x * n.y * n.z;
        let one = |i: u32| {
            let at = glam::UVec3::new(i % n.x, i / n.x % n.y, i / (n.x * n.y)).as_vec3() + 0.5;
            let p = low + at * step;
            let (a, b) = (self.holds(&cameras, p), other.holds(&cameras, p));
            (u32::from(a && b), u32::from(a || b))
        };
        let (both, either) = (0..count).into_par_iter().map(one).reduce(|| (0, 0), |a, b| (a.0 + b.0, a.1 + b.1));
        (either > 0).then(|| f64::from(both) / f64::from(either))
    }

    fn moved(&self, place: &Similarity) -> Self {
        let corners: Vec<Vec3> = self.corners.iter().map(|p| place.point(*p)).collect();
        Shape {
            points: self.points.iter().map(|p| place.point(*p)).collect(),
            owners: self.owners.clone(),
            bvh: Bvh::new(&corners, &self.triangles),
            corners,
            triangles: self.triangles.clone(),
            depths: Vec::new(),
        }
    }

    fn distances(&self, points: &[Vec3]) -> Vec<f32> {
        points.par_iter().map(|p| self.bvh.distance(*p)).collect()
    }
}

fn fewer<T>(points: Vec<T>) -> Vec<T> {
    let step = points.len().div_ceil(POINTS).max(1);
    points.into_iter().step_by(step).collect()
}

fn lifted(camera: &Camera, i: usize, z: f32) -> Vec3 {
    let (x, y) = (i % camera.width as usize, i / camera.width as usize);
    let at = Vec3::new((x as f32 + 0.5 - camera.cx) / camera.fx, (y as f32 + 0.5 - camera.cy) / camera.fy, 1.0) * z;
    camera.rotation.transpose() * (at - camera.translation)
}

/// Of two surfaces; all in shares of the truth's bounding-box diagonal.
#[derive(Clone, Copy, Debug)]
pub struct Scores {
    /// Mean of both directions' mean distances.
    pub chamfer: f32,
    /// Harmonic mean of the shares of points within 1% of the other surface, and within 2%.
    pub f: [f32; 2],
}

pub fn scores(found: &Shape, truth: &Shape, diagonal: f32) -> Scores {
    let (there, back) = (truth.distances(&found.points), found.distances(&truth.points));
    let mean = |d: &[f32]| d.iter().sum::<f32>() / d.len().max(1) as f32;
    let within = |d: &[f32], limit: f32| d.iter().filter(|v| **v < limit).count() as f32 / d.len().max(1) as f32;
    let f = [0.01, 0.02].map(|share| {
        let (a, b) = (within(&there, share * diagonal), within(&back, share * diagonal));
        2.0 * a * b / (a + b).max(1e-9)
    });
    Scores { chamfer: (mean(&there) + mean(&back)) / 2.0 / diagonal, f }
}

/// p → scale · turn · p + shift.
#[derive(Clone, Copy, Debug)]
pub struct Similarity {
    turn: Mat3,
    scale: f32,
    shift: Vec3,
}

impl Similarity {
    pub fn new(turn: Mat3, scale: f32, shift: Vec3) -> Self {
        Similarity { turn, scale, shift }
    }

    pub fn scale(&self) -> f32 {
        self.scale
    }

    pub fn turn(&self) -> Mat3 {
        self.turn
    }

    pub fn point(&self, p: Vec3) -> Vec3 {
        self.scale * (self.turn * p) + self.shift
    }

    pub fn surface(&self, s: &Surface) -> Surface {
        Surface { positions: s.positions.iter().map(|p| self.point(*p)).collect(), triangles: s.triangles.clone() }
    }

    /// The camera that sees the moved as `c` sees what was not.
    pub fn camera(&self, c: &Camera) -> Camera {
        let rotation = c.rotation * self.turn.transpose();
        Camera { rotation, translation: self.scale * c.translation - rotation * self.shift, ..*c }
    }

    fn then(&self, turn: Mat3, scale: f32, shift: Vec3) -> Self {
        Similarity { turn: turn * self.turn, scale: scale * self.scale, shift: scale * (turn * self.shift) + shift }
    }
}

/// What moves the truth onto what was found: a turn about the vertical, one scale, a shift; in the end the 80% of closest
/// pairs decide.
///
/// A reconstruction from one photo has no scale and a guessed camera, so this much is given to it.
pub fn aligned(truth: &Surface, forward: Vec3, found: &Shape) -> Similarity {
    // The subject frame's +Y is where the camera looked.
    let turn = Mat3::from_cols(Vec3::new(forward.y, forward.x, 0.0), Vec3::new(-forward.x, forward.y, 0.0), Vec3::Z);
    let bounds = |points: &[Vec3]| {
        points.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(lo, hi), &p| (lo.min(p), hi.max(p)))
    };
    let start = Similarity { turn, scale: 1.0, shift: Vec3::ZERO };
    let ((lo, hi), (low, high)) = (start.surface(truth).bounds(), bounds(&found.points));
    let scale = high.distance(low) / hi.distance(lo).max(1e-6);
    let start = start.then(Mat3::IDENTITY, scale, (low + high) / 2.0 - scale * (lo + hi) / 2.0);
    // What is seen of it from around does not change with small moves.
    let placed = Shape::of_surface(&start.surface(truth));
    let mut move_on = Similarity { turn: Mat3::IDENTITY, scale: 1.0, shift: Vec3::ZERO };
    let mut all_pairs = true;
    for _ in 0..300 {
        let shape = placed.moved(&move_on);
        let mut pairs: Vec<(Vec3, Vec3)> = Vec::new();
        let step = |n: usize| n.div_ceil(2500).max(1);
        for p in shape.points.iter().step_by(step(shape.points.len())) {
            pairs.extend(found.bvh.closest(*p, 10.0, |_| true).map(|c| (*p, c.point)));
        }
        for p in found.points.iter().step_by(step(found.points.len())) {
            pairs.extend(shape.bvh.closest(*p, 10.0, |_| true).map(|c| (c.point, *p)));
        }
        pairs.sort_by(|a, b| a.0.distance_squared(a.1).total_cmp(&b.0.distance_squared(b.1)));
        // The furthest pairs are what turns and scales a coarse start right; only then can they be told from parts that
        // one of the two does not have.
        if !all_pairs {
            pairs.truncate(pairs.len() * 4 / 5);
        }
        let n = pairs.len().max(1) as f32;
        let (a, b) = pairs.iter().fold((Vec3::ZERO, Vec3::ZERO), |(a, b), p| (a + p.0 / n, b + p.1 / n));
        let (mut cos, mut sin, mut square, mut up) = (0.0, 0.0, 0.0, 0.0);
        for (p, q) in &pairs {
            let (p, q) = (*p - a, *q - b);
            cos += p.x * q.x + p.y * q.y;
            sin += p.x * q.y - p.y * q.x;
            up += p.z * q.z;
            square += p.length_squared();
        }
        let flat = cos.hypot(sin);
        let turn = Mat3::from_rotation_z(sin.atan2(cos));
        let scale = (flat + up) / square.max(1e-9);
        move_on = move_on.then(turn, scale, b - scale * (turn * a));
        if sin.atan2(cos).abs() < 5e-5 && (scale - 1.0).abs() < 5e-5 {
            if !all_pairs {
                break;
            }
            all_pairs = false;
        }
    }
    start.then(move_on.turn, move_on.scale, move_on.shift)
}

#[cfg(test)]
pub mod tests {
    use super::*;

    pub fn block(size: Vec3) -> Surface {
        let positions =
            (0..8).map(|k| size * (Vec3::new((k & 1) as f32, (k >> 1 & 1) as f32, (k >> 2) as f32) - 0.5)).collect();
        let triangles = [
            [0, 2, 1],
            [1, 2, 3],
            [4, 5, 6],
            [5, 7, 6],
            [0, 1, 4],
            [1, 5, 4],
            [2, 6, 3],
            [3, 6, 7],
            [0, 4, 2],
            [2, 4, 6],
            [1, 3, 5],
            [3, 7, 5],
        ];
        Surface { positions, triangles: triangles.to_vec() }
    }

    #[test]
    fn a_block_moved_away_is_found_again() {
        let here = block(Vec3::new(1.2, 0.7, 0.5));
        let angle = 0.6f32;
        let away = Surface {
            positions: here.positions.iter().map(|p| 3.0 * (Mat3::from_rotation_z(angle) * *p) + Vec3::X).collect(),
            triangles: here.triangles.clone(),
        };
        let found = Shape::of_surface(&here);
        // Told the camera's direction to within 8°.
        let forward = Mat3::from_rotation_z(angle + 0.14) * Vec3::Y;
        let back = aligned(&away, forward, &found).surface(&away);
        let s = scores(&found, &Shape::of_surface(&back), 1.5);
        assert!(s.chamfer < 2e-3 && s.f[0] > 0.99, "{s:?}");
        // Two faces are 0.025 too far out: more than 1% of the diagonal, less than 2%.
        let larger = Shape::of_surface(&block(Vec3::new(1.25, 0.7, 0.5)));
        let s = scores(&larger, &found, 1.5);
        assert!(s.f[0] < 0.9 && s.f[1] > 0.99, "{s:?}");
    }

    #[test]
    fn volumes_and_normals_of_blocks_are_their_own() {
        let (size, larger) = (Vec3::new(1.2, 0.7, 0.5), Vec3::new(1.2, 0.7, 1.0));
        let (a, b) = (Shape::of_surface(&block(size)), Shape::of_surface(&block(larger)));
        let around = (-larger / 2.0 - 0.02, larger / 2.0 + 0.02);
        assert!((a.volume_iou(&a, around, 48).unwrap() - 1.0).abs() < 1e-9);
        let iou = a.volume_iou(&b, around, 48).unwrap();
        assert!((iou - 0.5).abs() < 0.03, "{iou}");
        assert!((a.normal_consistency(&a).unwrap() - 1.0).abs() < 1e-3);
        let mut inside_out = block(size);
        inside_out.triangles.iter_mut().for_each(|t| t.swap(0, 1));
        let turned = Shape::of_surface(&inside_out).normal_consistency(&a).unwrap();
        assert!((turned + 1.0).abs() < 1e-3, "{turned}");
        assert!((Shape::of_surface(&inside_out).volume_iou(&a, around, 48).unwrap() - 1.0).abs() < 1e-9);
        assert_eq!(Shape::of_depth(|c| vec![0.0; (c.width * c.height) as usize]).normal_consistency(&a), None);
    }
}
