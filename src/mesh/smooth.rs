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

/// Bends unit normals until no triangle turns its back to the sum of its corners', the least for each triangle in turn (projections
/// onto half-spaces, Agmon 1954). A surface that simplification has folded has such triangles; readers of OpenFlight take
/// them for wound the wrong way round. Normals of meshes without any stay as they are, bit for bit. Where two triangles ask
/// for what cannot be, it ends after [`ROUNDS`].
pub fn turn_out(positions: &[Vec3], triangles: &[[u32; 3]], normals: &mut [Vec3]) {
    /// What the sum's part along the triangle's normal becomes, before the normals are of length 1 again.
    const ENOUGH: f32 = 0.1;
    const ROUNDS: usize = 50;
    for _ in 0..ROUNDS {
        let mut bent = false;
        for t in triangles {
            let Some(n) = cross(positions, t).try_normalize() else { continue };
            let along: f32 = t.iter().map(|i| normals[*i as usize].dot(n)).sum();
            if along > 0.0 {
                continue;
            }
            for i in t {
                let normal = &mut normals[*i as usize];
                *normal = (*normal + n * ((ENOUGH - along) / 3.0)).try_normalize().unwrap_or(n);
            }
            bent = true;
        }
        if !bent {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The least part of a triangle's corner normals along its own.
    fn worst(positions: &[Vec3], triangles: &[[u32; 3]], normals: &[Vec3]) -> f32 {
        let along = |t: &[u32; 3]| -> f32 {
            let n = cross(positions, t).normalize();
            t.iter().map(|i| normals[*i as usize].dot(n)).sum()
        };
        triangles.iter().map(along).fold(f32::MAX, f32::min)
    }

    #[test]
    fn a_folded_triangle_faces_as_its_corners_do() {
        // A flat fan about the first corner, whose last triangle is folded under it.
        let positions: Vec<Vec3> =
            [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 1.0, 0.0], [-1.0, 0.3, 0.0], [0.2, 0.9, -0.05]]
                .map(Vec3::from)
                .to_vec();
        let flat = [[0, 1, 2], [0, 2, 3]];
        let mut normals = vertex_normals(&positions, &flat);
        let before = normals.clone();
        turn_out(&positions, &flat, &mut normals);
        assert_eq!(normals, before, "nothing to bend");
        let folded = [[0, 1, 2], [0, 2, 3], [0, 3, 4]];
        let mut normals = vec![Vec3::Z; 5];
        assert!(worst(&positions, &folded, &normals) < 0.0, "it is folded");
        turn_out(&positions, &folded, &mut normals);
        assert!(worst(&positions, &folded, &normals) > 0.0);
        assert!(normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-5));
    }
}
