//! Charts: groups of faces that look one way, each laid flat.
//!
//! Faces are merged greedily (hierarchical face clustering, Garland, Willmott & Heckbert 2001) by how far their normals
//! spread and how ragged the outline gets. A chart whose flat picture overlaps itself is cut in two.

use super::relax::relax;
use super::smooth::{corner_angle, turn_out, vertex_normals};
use super::{Mesh, Surface, cross};
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

/// Faces that are laid flat together.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    pub faces: Vec<u32>,
    /// Flat coordinates (scene units, y down) of each face's corners; as long as `faces`, corner at (0, 0) or beyond.
    pub corners: Vec<[Vec2; 3]>,
    /// Width and height of the flat picture.
    pub size: Vec2,
}

/// How far a chart may bend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bend {
    /// Mean cosine between a chart's faces and its axis must not fall below 1 − `spread`.
    spread: f32,
    /// No face leans further from its chart's axis than this cosine.
    lean: f32,
    /// Charts smaller than this share of the area may bend further to find a home.
    small: f32,
    small_spread: f32,
    small_lean: f32,
}

/// For meshes of thousands of vertices: hardly any stretch.
pub const FLAT: Bend = Bend { spread: 0.18, lean: 0.3, small: 0.004, small_spread: 0.45, small_lean: 0.1 };
/// For meshes of few vertices, which seams would eat up: up to half a ball in one chart.
pub const ROUND: Bend = Bend { spread: 0.42, lean: 0.12, small: 0.03, small_spread: 0.6, small_lean: 0.03 };

/// Raggedness beside spread.
const OUTLINE: f32 = 0.01;

struct Cluster {
    normal: Vec3,
    area: f32,
    outline: f32,
    faces: Vec<u32>,
    /// Length of the border shared with each neighbour.
    shared: BTreeMap<u32, f32>,
    stamp: u32,
}

/// A chart number for each face, 0..n without gaps.
fn cluster(surface: &Surface, bend: &Bend) -> Vec<u32> {
    let mut clusters = faces_as_clusters(surface);
    let total: f32 = clusters.iter().map(|c| c.area).sum();
    let unit_normals: Vec<Vec3> =
        surface.triangles.iter().map(|t| cross(&surface.positions, t).normalize_or_zero()).collect();
    for small_only in [false, true] {
        let (spread, lean) = if small_only { (bend.small_spread, bend.small_lean) } else { (bend.spread, bend.lean) };
        let allowed = |a: &Cluster, b: &Cluster| {
            let normal = a.normal + b.normal;
            let area = a.area + b.area;
            if small_only && a.area.min(b.area) > bend.small * total {
                return false;
            }
            let Some(axis) = normal.try_normalize() else { return false };
            normal.length() >= (1.0 - spread) * area
                && a.faces.iter().chain(&b.faces).all(|&f| {
                    let n = unit_normals[f as usize];
                    n == Vec3::ZERO || n.dot(axis) >= lean
                })
        };
        merge_all(&mut clusters, allowed);
    }
    let mut chart_of = vec![0; surface.triangles.len()];
    for (chart, c) in clusters.iter().filter(|c| !c.faces.is_empty()).enumerate() {
        for &f in &c.faces {
            chart_of[f as usize] = chart as u32;
        }
    }
    chart_of
}

fn faces_as_clusters(surface: &Surface) -> Vec<Cluster> {
    let p = &surface.positions;
    let mut clusters: Vec<Cluster> = surface
        .triangles
        .iter()
        .enumerate()
        .map(|(f, t)| {
            let n = cross(p, t) / 2.0;
            Cluster {
                normal: n,
                area: n.length(),
                outline: 0.0,
                faces: vec![f as u32],
                shared: BTreeMap::new(),
                stamp: 0,
            }
        })
        .collect();
    let mut edges: Vec<([u32; 2], u32)> = Vec::with_capacity(clusters.len() * 3);
    for (f, t) in surface.triangles.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (t[k], t[(k + 1) % 3]);
            clusters[f].outline += p[a as usize].distance(p[b as usize]);
            edges.push(([a.min(b), a.max(b)], f as u32));
        }
    }
    edges.sort_unstable();
    for pair in edges.chunk_by(|x, y| x.0 == y.0) {
        if let [(e, f), (_, g)] = pair {
            let length = p[e[0] as usize].distance(p[e[1] as usize]);
            *clusters[*f as usize].shared.entry(*g).or_default() += length;
            *clusters[*g as usize].shared.entry(*f).or_default() += length;
        }
    }
    clusters
}

fn merge_cost(a: &Cluster, b: &Cluster, shared: f32) -> f32 {
    let area = (a.area + b.area).max(1e-12);
    let spread = 1.0 - (a.normal + b.normal).length() / area;
    let outline = (a.outline + b.outline - 2.0 * shared).max(0.0);
    spread + OUTLINE * (outline * outline / (4.0 * std::f32::consts::PI * area)).min(20.0)
}

fn merge_all(clusters: &mut [Cluster], allowed: impl Fn(&Cluster, &Cluster) -> bool) {
    // Costs are never negative, so their bits sort as they do.
    let entry = |clusters: &[Cluster], a: u32, b: u32, shared: f32| {
        let (a, b) = (a.min(b), a.max(b));
        let (ca, cb) = (&clusters[a as usize], &clusters[b as usize]);
        let cost = merge_cost(ca, cb, shared).max(0.0);
        Reverse((cost.to_bits(), a, b, ca.stamp, cb.stamp))
    };
    let mut heap = BinaryHeap::new();
    for a in 0..clusters.len() as u32 {
        for (&b, &shared) in clusters[a as usize].shared.range(a + 1..) {
            heap.push(entry(clusters, a, b, shared));
        }
    }
    while let Some(Reverse((_, a, b, stamp_a, stamp_b))) = heap.pop() {
        let (ca, cb) = (&clusters[a as usize], &clusters[b as usize]);
        if ca.stamp != stamp_a || cb.stamp != stamp_b || ca.faces.is_empty() || cb.faces.is_empty() {
            continue;
        }
        if !allowed(ca, cb) {
            continue;
        }
        let (keep, gone) = if ca.faces.len() >= cb.faces.len() { (a, b) } else { (b, a) };
        let old = std::mem::replace(
            &mut clusters[gone as usize],
            Cluster {
                normal: Vec3::ZERO,
                area: 0.0,
                outline: 0.0,
                faces: Vec::new(),
                shared: BTreeMap::new(),
                stamp: u32::MAX,
            },
        );
        let kept = &mut clusters[keep as usize];
        let border = kept.shared.remove(&gone).unwrap_or(0.0);
        kept.normal += old.normal;
        kept.area += old.area;
        kept.outline += old.outline - 2.0 * border;
        kept.faces.extend(old.faces);
        kept.stamp += 1;
        for (other, length) in old.shared {
            if other == keep {
                continue;
            }
            *clusters[keep as usize].shared.entry(other).or_default() += length;
            let neighbour = &mut clusters[other as usize].shared;
            neighbour.remove(&gone);
            *neighbour.entry(keep).or_default() += length;
        }
        for (&other, &shared) in &clusters[keep as usize].shared {
            heap.push(entry(clusters, keep, other, shared));
        }
    }
}

/// Cuts a closed or open surface into charts that do not overlap themselves when laid flat.
///
/// `resolution`: about how many texels the whole area will get; how fine overlaps are looked for.
pub fn charts(surface: &Surface, bend: &Bend, resolution: f32) -> Vec<Chart> {
    let chart_of = cluster(surface, bend);
    let count = chart_of.iter().max().map_or(0, |m| *m as usize + 1);
    let mut groups = vec![Vec::new(); count];
    for (f, &c) in chart_of.iter().enumerate() {
        groups[c as usize].push(f as u32);
    }
    let texel = (surface.area() as f32 / resolution.max(1.0)).sqrt().max(1e-9);
    let mut result: Vec<Chart> =
        groups.into_par_iter().flat_map_iter(|faces| flattened(surface, faces, texel)).collect();
    result.sort_by_key(|c| c.faces.iter().min().copied());
    result
}

/// One group of faces as a chart, or as several where it would cover itself.
fn flattened(surface: &Surface, faces: Vec<u32>, texel: f32) -> Vec<Chart> {
    let mut groups = vec![faces];
    let mut result = Vec::new();
    while let Some(mut faces) = groups.pop() {
        faces.sort_unstable();
        let projected = project(surface, &faces);
        let relaxed = relax(surface, &faces, &projected).map(|flat| boxed(&faces, flat));
        if let Some(chart) = relaxed.filter(|c| overlap(c, texel).is_none()) {
            result.push(chart);
            continue;
        }
        let chart = boxed(&faces, projected);
        match overlap(&chart, texel) {
            Some(sides) => groups.extend(cut(surface, &chart, sides)),
            None => result.push(chart),
        }
    }
    result
}

/// Each face's corners seen along the mean normal.
fn project(surface: &Surface, faces: &[u32]) -> Vec<[Vec2; 3]> {
    let sum: Vec3 = faces.iter().map(|&f| cross(&surface.positions, &surface.triangles[f as usize])).sum();
    let axis = sum.try_normalize().unwrap_or(Vec3::Z);
    let (right, up) = axis.any_orthonormal_pair();
    let flat = |i: u32| {
        let p = surface.positions[i as usize];
        Vec2::new(p.dot(right), p.dot(up))
    };
    faces.iter().map(|&f| surface.triangles[f as usize].map(flat)).collect()
}

/// Shifts and turns a flat picture into its smallest upright box.
fn boxed(faces: &[u32], flat: Vec<[Vec2; 3]>) -> Chart {
    let bounds = |angle: f32| {
        let r = Vec2::from_angle(angle);
        let points = flat.iter().flatten().map(move |p| r.rotate(*p));
        points.fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(lo, hi), p| (lo.min(p), hi.max(p)))
    };
    let area = |angle: f32| {
        let (lo, hi) = bounds(angle);
        (hi - lo).element_product()
    };
    let angles = (0..18).map(|k| k as f32 * 5f32.to_radians());
    let angle = angles.min_by(|a, b| area(*a).total_cmp(&area(*b))).unwrap_or(0.0);
    let (lo, hi) = bounds(angle);
    let r = Vec2::from_angle(angle);
    let corners = flat.iter().map(|t| t.map(|p| r.rotate(p) - lo)).collect();
    Chart { faces: faces.to_vec(), corners, size: hi - lo }
}

/// Faces (by place in the chart) that cover the same spot, as two sides; None when there are none.
fn overlap(chart: &Chart, texel: f32) -> Option<[Vec<usize>; 2]> {
    let (w, h) = ((chart.size.x / texel) as usize + 2, (chart.size.y / texel) as usize + 2);
    let mut owner = vec![u32::MAX; w * h];
    let (mut first, mut second) = (Vec::new(), Vec::new());
    for (k, t) in chart.corners.iter().enumerate() {
        let t = t.map(|p| p / texel);
        cells_inside(t, w, h, 0.05, |x, y| {
            let slot = &mut owner[y * w + x];
            if *slot == u32::MAX {
                *slot = k as u32;
            } else {
                first.push(*slot as usize);
                second.push(k);
            }
        });
    }
    (!first.is_empty()).then_some([first, second])
}

/// Calls `visit` for each cell whose centre lies inside the triangle by more than `margin` (negative: outside by less).
pub fn cells_inside(t: [Vec2; 3], w: usize, h: usize, margin: f32, mut visit: impl FnMut(usize, usize)) {
    let [a, b, c] = t;
    let area = (b - a).perp_dot(c - a);
    if area.abs() < 1e-12 {
        return;
    }
    let grow = Vec2::splat((-margin).max(0.0));
    let lo = a.min(b).min(c) - grow;
    let hi = a.max(b).max(c) + grow;
    let first = |v: f32| (v - 0.5).ceil().max(0.0) as usize;
    let last = |v: f32, n: usize| ((v - 0.5).floor() + 1.0).clamp(0.0, n as f32) as usize;
    let edges = [(a, b), (b, c), (c, a)].map(|(p, q)| {
        let d = (q - p) * area.signum();
        let n = Vec2::new(-d.y, d.x) / d.length().max(1e-20);
        (n, -n.dot(p) - margin)
    });
    for y in first(lo.y)..last(hi.y, h) {
        for x in first(lo.x)..last(hi.x, w) {
            let p = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
            if edges.iter().all(|(n, d)| n.dot(p) + d >= 0.0) {
                visit(x, y);
            }
        }
    }
}

/// Two charts' faces out of one: each face goes to the side it is fewer steps from.
fn cut(surface: &Surface, chart: &Chart, sides: [Vec<usize>; 2]) -> [Vec<u32>; 2] {
    let mut edges: Vec<([u32; 2], usize)> = Vec::new();
    for (k, &f) in chart.faces.iter().enumerate() {
        let t = surface.triangles[f as usize];
        for j in 0..3 {
            let (a, b) = (t[j], t[(j + 1) % 3]);
            edges.push(([a.min(b), a.max(b)], k));
        }
    }
    edges.sort_unstable();
    let mut neighbours = vec![Vec::new(); chart.faces.len()];
    for pair in edges.windows(2) {
        if pair[0].0 == pair[1].0 {
            neighbours[pair[0].1].push(pair[1].1);
            neighbours[pair[1].1].push(pair[0].1);
        }
    }
    let mut side_of = vec![usize::MAX; chart.faces.len()];
    let mut queue = std::collections::VecDeque::new();
    // One seed a side at least, the rest of the conflict as it comes.
    for k in 0..sides[0].len() {
        for (side, list) in sides.iter().enumerate() {
            if side_of[list[k]] == usize::MAX {
                side_of[list[k]] = side;
                queue.push_back(list[k]);
            }
        }
    }
    while let Some(k) = queue.pop_front() {
        for &n in &neighbours[k] {
            if side_of[n] == usize::MAX {
                side_of[n] = side_of[k];
                queue.push_back(n);
            }
        }
    }
    let mut result = [Vec::new(), Vec::new()];
    for (k, &f) in chart.faces.iter().enumerate() {
        result[usize::from(side_of[k] == 1)].push(f);
    }
    result
}

/// How many vertices the charts' seams leave: distinct (vertex, chart).
pub fn split_count(surface: &Surface, charts: &[Chart]) -> usize {
    charts
        .iter()
        .map(|c| {
            let mut used: Vec<u32> = c.faces.iter().flat_map(|&f| surface.triangles[f as usize]).collect();
            used.sort_unstable();
            used.dedup();
            used.len()
        })
        .sum()
}

/// A textured mesh: vertices split at seams only, and normals smooth but across seams that are creases.
///
/// `uv[c][k]`: the corners' texture coordinates of chart c's k-th face.
pub fn assemble(surface: &Surface, charts: &[Chart], uv: &[Vec<[Vec2; 3]>]) -> Mesh {
    /// Beyond this angle (cosine of 35°) between a chart's own normal and the whole ring's, a seam is a crease.
    const CREASE: f32 = 0.82;
    let p = &surface.positions;
    let whole = vertex_normals(p, &surface.triangles);
    let mut mesh = Mesh { triangles: vec![[0; 3]; surface.triangles.len()], ..Mesh::default() };
    let mut vertex_of = vec![u32::MAX; p.len()];
    for (chart, uv) in charts.iter().zip(uv) {
        let first = mesh.positions.len();
        let mut used = Vec::new();
        for (&f, corners) in chart.faces.iter().zip(uv) {
            let t = surface.triangles[f as usize];
            let n = cross(p, &t).normalize_or_zero();
            for k in 0..3 {
                let slot = &mut vertex_of[t[k] as usize];
                if *slot == u32::MAX {
                    *slot = mesh.positions.len() as u32;
                    used.push(t[k]);
                    mesh.positions.push(p[t[k] as usize]);
                    mesh.normals.push(Vec3::ZERO);
                    mesh.uvs.push(corners[k]);
                }
                mesh.triangles[f as usize][k] = *slot;
                mesh.normals[*slot as usize] += n * corner_angle(p, &t, k);
            }
        }
        for (normal, &i) in mesh.normals[first..].iter_mut().zip(&used) {
            let own = normal.try_normalize().unwrap_or(whole[i as usize]);
            *normal = if own.dot(whole[i as usize]) >= CREASE { whole[i as usize] } else { own };
            vertex_of[i as usize] = u32::MAX;
        }
    }
    turn_out(&mesh.positions, &mesh.triangles, &mut mesh.normals);
    mesh
}

#[cfg(test)]
mod tests {
    use super::super::scenes;
    use super::*;

    #[test]
    fn a_box_has_six_charts_and_a_ball_few() {
        let boxed = scenes::sampled(&scenes::boxed(0.6, 0.4, 0.3), 32);
        let count = charts(&boxed, &FLAT, 4e5).len();
        assert!((6..=8).contains(&count), "{count}");
        let ball = scenes::sampled(&scenes::sphere(0.8), 32);
        let count = charts(&ball, &FLAT, 4e5).len();
        assert!((4..=24).contains(&count), "{count}");
    }

    #[test]
    fn every_face_is_in_one_chart_and_none_overlaps() {
        let car = scenes::sampled(&scenes::car(), 64);
        let charts = charts(&car, &FLAT, 4e5);
        let mut faces: Vec<u32> = charts.iter().flat_map(|c| c.faces.clone()).collect();
        faces.sort_unstable();
        assert_eq!(faces, (0..car.triangles.len() as u32).collect::<Vec<_>>());
        for c in &charts {
            // Where more than a full turn of faces meets, they may overlap by less than a texel.
            assert!(overlap(c, 0.004).is_none_or(|[cells, _]| cells.len() < 4));
        }
    }
}
