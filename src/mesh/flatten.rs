//! Bumps out, edges kept: face normals are filtered, then vertices follow them.
//!
//! Sun, Rosin, Martin & Langbein, "Fast and Effective Feature-Preserving Mesh Denoising" (2007): a normal becomes the mean
//! of those around it that lean less than a limit away, the nearer to it the more they count (equation 5); a vertex moves
//! along the filtered normals of its faces onto their planes (equation 8).

use super::{Surface, cross};
use crate::splat::simd::{Kernel, Simd, dispatch};
use glam::Vec3;
use rayon::prelude::*;

/// How far and how often.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flattening {
    /// Rounds over the normals: a bump of a few times their square root of faces across goes.
    pub normal_rounds: usize,
    /// Cosine of the angle from which two normals belong to different sides of an edge.
    pub edge: f32,
    pub vertex_rounds: usize,
    /// No vertex moves further, scene units.
    pub limit: f32,
}

impl Default for Flattening {
    /// For surfaces out of a grid: 63° make an edge.
    fn default() -> Self {
        Flattening { normal_rounds: 50, edge: 0.45, vertex_rounds: 20, limit: 0.05 }
    }
}

/// Flattens a closed surface; what lies on the plane z = `ground` stays, and nothing goes below it.
pub fn flatten(surface: &mut Surface, how: &Flattening, ground: Option<f32>) {
    let faces = &surface.triangles;
    let around = Around::new(surface.positions.len(), faces);
    let normals = filtered(surface, &around, how);
    let start = surface.positions.clone();
    let on_ground = |p: Vec3| ground.is_some_and(|g| p.z <= g);
    for _ in 0..how.vertex_rounds {
        let from = &surface.positions;
        let middles: Vec<Vec3> =
            faces.par_iter().map(|t| t.iter().map(|&i| from[i as usize]).sum::<Vec3>() / 3.0).collect();
        let moved: Vec<Vec3> = (0..from.len())
            .into_par_iter()
            .map(|v| {
                let list = around.faces(v as u32);
                if list.is_empty() || on_ground(start[v]) {
                    return from[v];
                }
                let pull = |f: &u32| normals[*f as usize] * normals[*f as usize].dot(middles[*f as usize] - from[v]);
                let to = from[v] + list.iter().map(pull).sum::<Vec3>() / list.len() as f32;
                let mut to = start[v] + (to - start[v]).clamp_length_max(how.limit);
                if let Some(g) = ground {
                    to.z = to.z.max(g);
                }
                to
            })
            .collect();
        surface.positions = moved;
    }
}

/// Faces whose normals are filtered side by side.
const SIDE: usize = 16;
/// Of [`SIDE`] faces the numbers of all that touch a corner of theirs, corner by corner; a column a face.
type Beside = Vec<[u32; SIDE]>;

/// The faces' normals after all rounds.
fn filtered(surface: &Surface, around: &Around, how: &Flattening) -> Vec<Vec3> {
    let faces = &surface.triangles;
    // Who has fewer faces around than those beside it counts the one after the last, which has no area.
    let none = faces.len() as u32;
    let beside = |faces: &[[u32; 3]]| -> Beside {
        let list = |t: &[u32; 3]| t.map(|v| around.faces(v));
        let rows = faces.iter().map(|t| list(t).iter().map(|l| l.len()).sum()).max().unwrap_or(0);
        let mut beside = vec![[none; SIDE]; rows];
        for (column, t) in faces.iter().enumerate() {
            for (row, face) in beside.iter_mut().zip(list(t).into_iter().flatten()) {
                row[column] = *face;
            }
        }
        beside
    };
    let beside: Vec<Beside> = faces.par_chunks(SIDE).map(beside).collect();
    // Side by side with the area, so that a face is one place in memory.
    let sized = |t: &[u32; 3]| {
        let n = cross(&surface.positions, t);
        n.normalize_or_zero().extend(n.length()).to_array()
    };
    let mut from: Vec<[f32; 4]> = faces.par_iter().map(sized).collect();
    from.push([0.0; 4]);
    let mut to = from.clone();
    for _ in 0..how.normal_rounds {
        to[..faces.len()]
            .par_chunks_mut(SIDE)
            .zip(&beside)
            .enumerate()
            .with_min_len(64)
            .for_each(|(k, (to, beside))| dispatch(Means { from: &from, beside, first: k * SIDE, edge: how.edge, to }));
        std::mem::swap(&mut from, &mut to);
    }
    from.pop();
    from.into_iter().map(|[x, y, z, _]| Vec3::new(x, y, z)).collect()
}

/// One round over the normals of at most [`SIDE`] faces from `first` on. Terms are added face by face in the order of `beside`,
/// so that no result depends on the number of lanes.
struct Means<'a> {
    from: &'a [[f32; 4]],
    beside: &'a Beside,
    first: usize,
    edge: f32,
    to: &'a mut [[f32; 4]],
}

impl Kernel for Means<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let Means { from, beside, first, edge, to } = self;
        let (zero, edge) = (s.splat(0.0), s.splat(edge));
        for (part, to) in to.chunks_mut(S::LANES).enumerate() {
            let lanes = part * S::LANES..(part + 1) * S::LANES;
            let last = from.len() - 1;
            let own: [u32; SIDE] = std::array::from_fn(|i| (first + lanes.start + i).min(last) as u32);
            let [x, y, z, _] = s.gather(from, &own);
            let mut sum = [zero; 3];
            for row in beside {
                let [nx, ny, nz, area] = s.gather(from, &row[lanes.clone()]);
                let cosine = s.add(s.add(s.mul(x, nx), s.mul(y, ny)), s.mul(z, nz));
                let alike = s.sub(cosine, edge);
                let alike = s.select(s.gt(alike, zero), alike, zero);
                let weight = s.mul(s.mul(area, alike), alike);
                for (sum, n) in sum.iter_mut().zip([nx, ny, nz]) {
                    *sum = s.add(*sum, s.mul(weight, n));
                }
            }
            let mut sums = [[0.0; SIDE]; 3];
            for (sum, to) in sum.into_iter().zip(&mut sums) {
                s.store(sum, to);
            }
            for (i, to) in to.iter_mut().enumerate() {
                if let Some(n) = Vec3::new(sums[0][i], sums[1][i], sums[2][i]).try_normalize() {
                    to[..3].copy_from_slice(&n.to_array());
                } else {
                    *to = from[own[i] as usize];
                }
            }
        }
    }
}

/// Faces at each vertex, in one array.
struct Around {
    start: Vec<u32>,
    list: Vec<u32>,
}

impl Around {
    fn new(vertices: usize, faces: &[[u32; 3]]) -> Self {
        let mut start = vec![0u32; vertices + 1];
        for &v in faces.iter().flatten() {
            start[v as usize + 1] += 1;
        }
        for v in 0..vertices {
            start[v + 1] += start[v];
        }
        let (mut at, mut list) = (start.clone(), vec![0; faces.len() * 3]);
        for (f, t) in faces.iter().enumerate() {
            for &v in t {
                list[at[v as usize] as usize] = f as u32;
                at[v as usize] += 1;
            }
        }
        Around { start, list }
    }

    fn faces(&self, vertex: u32) -> &[u32] {
        &self.list[self.start[vertex as usize] as usize..self.start[vertex as usize + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::super::scenes;
    use super::*;

    #[test]
    fn bumps_go_and_edges_stay() {
        let half = Vec3::new(0.7, 0.5, 0.3);
        let mut surface = scenes::sampled(&scenes::boxed(half.x, half.y, half.z), 64);
        // Waves of 0.015 on every side, eight samples long.
        for p in &mut surface.positions {
            let wave = 0.015 * ((23.0 * p.x).sin() * (21.0 * p.y).cos() + (24.0 * p.z).sin()) / 2.0;
            *p += wave * (*p / half).normalize_or_zero();
        }
        // Inside the sides, well away from their edges: how far normals lean, and how far points lie off.
        let bumps = |s: &Surface| {
            let (mut lean, mut off, mut count) = (0.0, 0.0, 0.0);
            for t in &s.triangles {
                let p = t.iter().map(|&i| s.positions[i as usize]).sum::<Vec3>() / 3.0;
                let n = cross(&s.positions, t).normalize_or_zero();
                let inside = (p.abs() / half).to_array();
                if let Some(k) = (0..3).find(|&k| (0..3).all(|j| j == k || inside[j] < 0.8) && inside[k] > 0.8) {
                    lean += n.to_array()[k].abs().min(1.0).acos();
                    off += (p.abs() - half).to_array()[k].abs();
                    count += 1.0;
                }
            }
            (lean / count, off / count)
        };
        let (before, volume) = (bumps(&surface), surface.volume());
        flatten(&mut surface, &Flattening::default(), None);
        let after = bumps(&surface);
        assert!(after.0 < 0.6 * before.0 && after.1 < before.1, "{after:?} of {before:?}");
        assert!((surface.volume() - volume).abs() < 0.01 * volume);
        // The eight corners are still there.
        for k in 0..8 {
            let corner = half * Vec3::new((k & 1) as f32, (k >> 1 & 1) as f32, (k >> 2) as f32).map(|v| 2.0 * v - 1.0);
            let nearest = surface.positions.iter().map(|p| p.distance(corner)).fold(1.0, f32::min);
            assert!(nearest < 0.04, "{nearest} at {corner}");
        }
    }

    #[test]
    fn what_stands_stays_on_the_ground() {
        let mut surface = scenes::sampled(&scenes::sphere(0.8), 40);
        let ground = -0.5;
        surface.positions.iter_mut().for_each(|p| p.z = p.z.max(ground));
        let flat = |s: &Surface| s.positions.iter().filter(|p| p.z == ground).count();
        let before = flat(&surface);
        flatten(&mut surface, &Flattening::default(), Some(ground));
        assert!(flat(&surface) >= before && surface.positions.iter().all(|p| p.z >= ground));
    }
}
