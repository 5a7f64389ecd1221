//! Marching cubes (Lorensen & Cline 1987) with its table derived, not typed.
//!
//! On each cube face the crossings are joined around runs of inside corners, so an ambiguous face always separates its
//! inside corners: neighbours agree, and the surface is a closed manifold when the grid's rim is outside.

use super::Surface;
use super::fuse::Volume;
use glam::Vec3;
use std::ops::Range;

/// Corner k of a cube: x = k & 1, y = k >> 1 & 1, z = k >> 2.
/// Edges as (lower corner, axis).
const EDGES: [(usize, usize); 12] =
    [(0, 0), (2, 0), (4, 0), (6, 0), (0, 1), (1, 1), (4, 1), (5, 1), (0, 2), (1, 2), (2, 2), (3, 2)];

/// Corners of each face, counter-clockwise seen from outside the cube.
const FACES: [[usize; 4]; 6] = [
    [0, 4, 6, 2], // -x
    [1, 3, 7, 5], // +x
    [0, 1, 5, 4], // -y
    [2, 6, 7, 3], // +y
    [0, 2, 3, 1], // -z
    [4, 5, 7, 6], // +z
];

fn edge_between(a: usize, b: usize) -> usize {
    let (low, axis) = (a.min(b), (a ^ b).trailing_zeros() as usize);
    EDGES.iter().position(|e| *e == (low, axis)).unwrap_or(0)
}

/// True when both edges lie on one face of the cube.
fn same_face(a: usize, b: usize) -> bool {
    let on = |edge: usize, face: &[usize; 4]| {
        let (low, axis) = EDGES[edge];
        face.contains(&low) && face.contains(&(low | 1 << axis))
    };
    FACES.iter().any(|f| on(a, f) && on(b, f))
}

/// Triangles of edge numbers for each of the 256 sets of inside corners.
fn table() -> Vec<Vec<[usize; 3]>> {
    (0..256usize).map(triangles_of_case).collect()
}

fn loops_of_case(inside: usize) -> Vec<Vec<usize>> {
    let is_inside = |corner: usize| inside >> corner & 1 == 1;
    let mut next = [usize::MAX; 12];
    for face in &FACES {
        for k in 0..4 {
            // From an edge that enters the inside, walk to the edge that leaves it.
            if is_inside(face[k]) || !is_inside(face[(k + 1) % 4]) {
                continue;
            }
            let enter = edge_between(face[k], face[(k + 1) % 4]);
            let mut j = (k + 1) % 4;
            while is_inside(face[(j + 1) % 4]) {
                j = (j + 1) % 4;
            }
            next[enter] = edge_between(face[j], face[(j + 1) % 4]);
        }
    }
    let mut loops = Vec::new();
    let mut used = [false; 12];
    for start in 0..12 {
        if next[start] == usize::MAX || used[start] {
            continue;
        }
        let mut round = Vec::new();
        let mut edge = start;
        while !used[edge] {
            used[edge] = true;
            round.push(edge);
            edge = next[edge];
        }
        loops.push(round);
    }
    loops
}

fn triangles_of_case(inside: usize) -> Vec<[usize; 3]> {
    loops_of_case(inside).iter().flat_map(|l| triangulate(l).unwrap_or_else(|| fan(l))).collect()
}

fn fan(polygon: &[usize]) -> Vec<[usize; 3]> {
    (1..polygon.len() - 1).map(|k| [polygon[0], polygon[k], polygon[k + 1]]).collect()
}

/// A triangulation whose diagonals stay inside the cube: one on a face might be drawn by the neighbour too.
fn triangulate(polygon: &[usize]) -> Option<Vec<[usize; 3]>> {
    let n = polygon.len();
    if n == 3 {
        return Some(vec![[polygon[0], polygon[1], polygon[2]]]);
    }
    for k in 0..n {
        let (a, b, c) = (polygon[(k + n - 1) % n], polygon[k], polygon[(k + 1) % n]);
        if same_face(a, c) {
            continue;
        }
        let rest: Vec<usize> = polygon.iter().copied().filter(|e| *e != b).collect();
        if let Some(mut triangles) = triangulate(&rest) {
            triangles.push([a, b, c]);
            return Some(triangles);
        }
    }
    None
}

/// The zero surface, counter-clockwise seen from outside (positive side); closed when the grid's rim is positive.
pub fn extract(volume: &Volume) -> Surface {
    let [nx, ny, nz] = volume.dims;
    if nx < 2 || ny < 2 || nz < 2 {
        return Surface::default();
    }
    extract_cells(volume, [0..nx - 1, 0..ny - 1, 0..nz - 1], |_, _| true, |at| volume.position(at[0], at[1], at[2])).0
}

/// The part of the surface that lies in a range of the grid's cells, of columns that `wanted` lets by; open where they end. With
/// it, each vertex's edge of the grid: the sample at its lower end and its axis.
///
/// `position`: of a sample. A vertex follows from the two samples of its edge and from where they lie, nothing else.
pub fn extract_cells(
    volume: &Volume,
    [xs, ys, zs]: [Range<usize>; 3],
    wanted: impl Fn(usize, usize) -> bool,
    position: impl Fn([usize; 3]) -> Vec3,
) -> (Surface, Vec<([usize; 3], usize)>) {
    let table = table();
    let [nx, ny, _] = volume.dims;
    let data = &volume.data;
    let corner_offset: [usize; 8] = std::array::from_fn(|k| volume.index(k & 1, k >> 1 & 1, k >> 2));
    let edge_offset: [usize; 12] = std::array::from_fn(|e| corner_offset[EDGES[e].0]);
    let axis_offset = [corner_offset[1], corner_offset[2], corner_offset[4]];
    let mut vertex_of_edge = vec![u32::MAX; data.len() * 3];
    let mut surface = Surface::default();
    let mut edges = Vec::new();
    for z in zs {
        for y in ys.clone() {
            for x in xs.clone().filter(|x| wanted(*x, y)) {
                let base = volume.index(x, y, z);
                let case = (0..8).fold(0, |case, k| case | usize::from(data[base + corner_offset[k]] < 0.0) << k);
                for triangle in &table[case] {
                    surface.triangles.push(triangle.map(|e| {
                        let axis = EDGES[e].1;
                        let low = base + edge_offset[e];
                        let slot = &mut vertex_of_edge[low * 3 + axis];
                        if *slot == u32::MAX {
                            *slot = surface.positions.len() as u32;
                            let (a, b) = (data[low], data[low + axis_offset[axis]]);
                            // Away from the ends: no slivers, no two vertices in one place.
                            let t = (a / (a - b)).clamp(0.02, 0.98);
                            let at = [low % nx, low / nx % ny, low / (nx * ny)];
                            let mut p = position(at);
                            p[axis] += t * volume.voxel;
                            surface.positions.push(p);
                            edges.push((at, axis));
                        }
                        *slot
                    }));
                }
            }
        }
    }
    (surface, edges)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::clean::edges_used_twice;

    fn volume(n: usize, f: impl Fn(Vec3) -> f32) -> Volume {
        let voxel = 2.0 / (n - 1) as f32;
        let mut v = Volume {
            origin: Vec3::splat(-1.0),
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
                    v.data[i] = f(v.position(x, y, z));
                }
            }
        }
        v
    }

    #[test]
    fn every_case_triangulates_inside_the_cube() {
        for case in 0..256 {
            for polygon in loops_of_case(case) {
                assert!((3..=12).contains(&polygon.len()));
                assert!(triangulate(&polygon).is_some(), "case {case}: {polygon:?}");
            }
        }
    }

    #[test]
    fn sphere_is_closed_and_outward() {
        let surface = extract(&volume(40, |p| p.length() - 0.7));
        assert!(edges_used_twice(&surface.triangles));
        let truth = 4.0 / 3.0 * std::f64::consts::PI * 0.343;
        assert!((surface.volume() - truth).abs() < 0.01 * truth, "{}", surface.volume());
    }

    #[test]
    fn noise_is_closed_too() {
        let mut state = 1u32;
        let surface = extract(&volume(24, |_| 0.0));
        assert!(surface.triangles.is_empty());
        let mut noise = volume(24, |_| 0.0);
        for z in 1..23 {
            for y in 1..23 {
                for x in 1..23 {
                    state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    let i = noise.index(x, y, z);
                    noise.data[i] = (state >> 8) as f32 / (1 << 23) as f32 - 1.0;
                }
            }
        }
        let surface = extract(&noise);
        assert!(surface.triangles.len() > 1000);
        assert!(edges_used_twice(&surface.triangles));
        assert!(surface.volume() > 0.0);
    }
}
