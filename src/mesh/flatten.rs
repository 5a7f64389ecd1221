//! Waves out of what should be flat, edges kept: bilateral filtering of face normals (Zheng, Fu, Au & Tai, "Bilateral
//! Normal Filtering for Mesh Denoising", 2011), vertices following (Sun, Rosin, Martin & Langbein 2007).

use super::{Surface, cross};
use glam::Vec3;
use rayon::prelude::*;

/// Normals that differ by this much (a chord of the unit sphere) hardly pull at each other.
const EDGE: f32 = 0.35;
const VERTEX_ROUNDS: usize = 12;

/// `rounds` of filtering; no vertex moves further than `limit`; what lies at z = `ground` stays there.
pub fn flatten(surface: &mut Surface, rounds: usize, limit: f32, ground: Option<f32>) {
    let edge = super::knob("EDGE", EDGE);
    let faces = &surface.triangles;
    let start = surface.positions.clone();
    let neighbours = across_edges(faces);
    let areas: Vec<f32> = faces.iter().map(|t| cross(&start, t).length() / 2.0).collect();
    let mut normals: Vec<Vec3> = faces.iter().map(|t| cross(&start, t).normalize_or_zero()).collect();
    for _ in 0..rounds {
        normals = (0..faces.len())
            .into_par_iter()
            .map(|f| {
                let n = normals[f];
                let mut sum = n * areas[f];
                for &g in &neighbours[f] {
                    let m = normals[g as usize];
                    let apart = (m - n).length_squared() / (2.0 * edge * edge);
                    sum += m * areas[g as usize] * (-apart).exp();
                }
                sum.try_normalize().unwrap_or(n)
            })
            .collect();
    }
    let mut faces_of = vec![Vec::new(); start.len()];
    for (f, t) in faces.iter().enumerate() {
        for &v in t {
            faces_of[v as usize].push(f as u32);
        }
    }
    for _ in 0..VERTEX_ROUNDS {
        let from = surface.positions.clone();
        let centers: Vec<Vec3> =
            faces.par_iter().map(|t| t.iter().map(|&i| from[i as usize]).sum::<Vec3>() / 3.0).collect();
        surface.positions.par_iter_mut().enumerate().for_each(|(v, p)| {
            let around = &faces_of[v];
            if around.is_empty() {
                return;
            }
            let pull: Vec3 = around
                .iter()
                .map(|&f| normals[f as usize] * normals[f as usize].dot(centers[f as usize] - *p))
                .sum::<Vec3>()
                / around.len() as f32;
            let mut moved = start[v] + (*p + pull - start[v]).clamp_length_max(limit);
            if let Some(g) = ground {
                moved.z = if start[v].z <= g { g } else { moved.z.max(g) };
            }
            *p = moved;
        });
    }
}

/// The faces across each face's edges.
fn across_edges(faces: &[[u32; 3]]) -> Vec<Vec<u32>> {
    let mut edges: Vec<([u32; 2], u32)> = Vec::with_capacity(faces.len() * 3);
    for (f, t) in faces.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (t[k], t[(k + 1) % 3]);
            edges.push(([a.min(b), a.max(b)], f as u32));
        }
    }
    edges.par_sort_unstable();
    let mut out = vec![Vec::with_capacity(3); faces.len()];
    for pair in edges.chunk_by(|a, b| a.0 == b.0) {
        if let [(_, f), (_, g)] = pair {
            out[*f as usize].push(*g);
            out[*g as usize].push(*f);
        }
    }
    out
}
