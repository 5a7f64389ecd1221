//! Voxel stairs out (Taubin, "A Signal Processing Approach to Fair Surface Design", 1995), and vertex normals.

use super::{Surface, cross};
use glam::Vec3;
use rayon::prelude::*;

/// Vertices around each vertex, in one array.
pub struct Adjacency {
    start: Vec<u32>,
    list: Vec<u32>,
}

impl Adjacency {
    /// Of a closed mesh: each directed edge names one neighbour.
    pub fn new(vertices: usize, triangles: &[[u32; 3]]) -> Self {
        let mut start = vec![0u32; vertices + 1];
        for &i in triangles.iter().flatten() {
            start[i as usize + 1] += 1;
        }
        for i in 0..vertices {
            start[i + 1] += start[i];
        }
        let mut at = start.clone();
        let mut list = vec![0; triangles.len() * 3];
        for t in triangles {
            for k in 0..3 {
                let slot = &mut at[t[k] as usize];
                list[*slot as usize] = t[(k + 1) % 3];
                *slot += 1;
            }
        }
        Adjacency { start, list }
    }

    pub fn around(&self, vertex: usize) -> &[u32] {
        &self.list[self.start[vertex] as usize..self.start[vertex + 1] as usize]
    }
}

/// Taubin's λ|μ smoothing, `rounds` of both; no vertex moves further than `limit`; what lies on the plane z = `ground`
/// or below stays or comes onto it.
pub fn taubin(surface: &mut Surface, rounds: usize, limit: f32, ground: Option<f32>) {
    const LAMBDA: f32 = 0.5;
    const MU: f32 = -0.53;
    let adjacency = Adjacency::new(surface.positions.len(), &surface.triangles);
    let start = surface.positions.clone();
    let on_ground = |p: Vec3| ground.is_some_and(|g| p.z <= g);
    let mut from = start.clone();
    for round in 0..2 * rounds {
        let factor = if round % 2 == 0 { LAMBDA } else { MU };
        let to = from
            .par_iter()
            .enumerate()
            .map(|(i, &p)| {
                let around = adjacency.around(i);
                if around.is_empty() {
                    return p;
                }
                let mean = around.iter().map(|&j| from[j as usize]).sum::<Vec3>() / around.len() as f32;
                let moved = p + factor * (mean - p);
                let mut moved = start[i] + (moved - start[i]).clamp_length_max(limit);
                if let Some(g) = ground {
                    moved.z = if on_ground(start[i]) { g } else { moved.z.max(g) };
                }
                moved
            })
            .collect();
        from = to;
    }
    surface.positions = from;
}

/// Unit normals a vertex, each face weighted by its angle there (Thürmer & Wüthrich 1998).
pub fn vertex_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; positions.len()];
    for t in triangles {
        let Some(n) = cross(positions, t).try_normalize() else { continue };
        for k in 0..3 {
            normals[t[k] as usize] += n * corner_angle(positions, t, k);
        }
    }
    normals.iter().map(|n| n.try_normalize().unwrap_or(Vec3::Z)).collect()
}

/// Angle (radians) of triangle `t` at its corner `k`.
pub fn corner_angle(positions: &[Vec3], t: &[u32; 3], k: usize) -> f32 {
    let [p, a, b] = [t[k], t[(k + 1) % 3], t[(k + 2) % 3]].map(|i| positions[i as usize]);
    let (u, v) = (a - p, b - p);
    u.cross(v).length().atan2(u.dot(v))
}
