//! One solid out of a fused volume: no cavities, no floaters, flat on the ground.
//!
//! All of it happens to the volume, before there is a surface: what is closed there stays closed.

use super::Surface;
use super::fuse::{SHEET, Volume};
use glam::Vec3;
use rayon::prelude::*;

/// Takes the thickness that fusion gave to sheets back off everything thicker than a few voxels.
pub fn thin_thick_parts(volume: &mut Volume) {
    let source = volume.clone();
    let [nx, ny, _] = source.dims;
    let voxel = source.voxel;
    volume.data.par_iter_mut().enumerate().for_each(|(i, value)| {
        if value.abs() > 2.0 * voxel {
            return;
        }
        let p = source.position(i % nx, i / nx % ny, i / (nx * ny));
        let difference = |axis: Vec3| source.sample(p + axis * voxel) - source.sample(p - axis * voxel);
        let gradient = Vec3::new(difference(Vec3::X), difference(Vec3::Y), difference(Vec3::Z));
        let Some(normal) = gradient.try_normalize() else { return };
        let depth = source.sample(p - normal * (*value + 3.0 * voxel)) / -voxel;
        let thick = ((depth - 1.5) / 1.0).clamp(0.0, 1.0);
        *value += SHEET * voxel * thick;
    });
}

/// Everything that the outside cannot reach becomes inside: no inner shells.
pub fn fill_cavities(volume: &mut Volume) {
    let mut reached = vec![false; volume.data.len()];
    let mut stack = vec![0usize];
    reached[0] = true;
    while let Some(i) = stack.pop() {
        neighbours(&volume.dims, i, |j| {
            if !reached[j] && volume.data[j] >= 0.0 {
                reached[j] = true;
                stack.push(j);
            }
        });
    }
    for (value, reached) in volume.data.iter_mut().zip(&reached) {
        if !reached && *value >= 0.0 {
            *value = -value.max(0.5 * volume.voxel);
        }
    }
}

/// Share of the largest part's volume from which a part stands on its own.
const OWN: f64 = 0.02;
/// Share of the largest part's volume from which a part stays when it lies within [`REACH`] voxels of what stays.
const NEAR: f64 = 0.0005;
const REACH: usize = 3;

/// Drops floaters: solid parts that are both small and away from the rest. Returns how many parts stay and go.
pub fn keep_what_belongs(volume: &mut Volume) -> (usize, usize) {
    let parts = solid_parts(volume);
    let largest = parts.iter().map(Vec::len).max().unwrap_or(0) as f64;
    let mut part_of = vec![u32::MAX; volume.data.len()];
    for (k, part) in parts.iter().enumerate() {
        for &i in part {
            part_of[i] = k as u32;
        }
    }
    let mut keep: Vec<bool> = parts.iter().map(|p| p.len() as f64 >= OWN * largest).collect();
    let near_enough = |k: usize| parts[k].len() as f64 >= NEAR * largest && parts[k].len() >= 8;
    let mut round: Vec<usize> = (0..parts.len()).filter(|&k| keep[k]).collect();
    let mut reached = vec![false; volume.data.len()];
    while !round.is_empty() {
        let mut front: Vec<usize> = round.iter().flat_map(|&k| parts[k].iter().copied()).collect();
        round.clear();
        for _ in 0..REACH + 1 {
            let mut next = Vec::new();
            for &i in &front {
                neighbours(&volume.dims, i, |j| {
                    if reached[j] {
                        return;
                    }
                    reached[j] = true;
                    next.push(j);
                    let k = part_of[j] as usize;
                    if k < parts.len() && !keep[k] && near_enough(k) {
                        keep[k] = true;
                        round.push(k);
                    }
                });
            }
            front = next;
        }
    }
    for (part, keep) in parts.iter().zip(&keep) {
        if !keep {
            for &i in part {
                volume.data[i] = volume.data[i].abs().max(0.5 * volume.voxel);
            }
        }
    }
    let kept = keep.iter().filter(|k| **k).count();
    (kept, parts.len() - kept)
}

/// Solid samples, grouped by face adjacency.
fn solid_parts(volume: &Volume) -> Vec<Vec<usize>> {
    let mut seen = vec![false; volume.data.len()];
    let mut parts = Vec::new();
    for start in 0..volume.data.len() {
        if seen[start] || volume.data[start] >= 0.0 {
            continue;
        }
        seen[start] = true;
        let mut part = vec![start];
        let mut at = 0;
        while at < part.len() {
            let i = part[at];
            at += 1;
            neighbours(&volume.dims, i, |j| {
                if !seen[j] && volume.data[j] < 0.0 {
                    seen[j] = true;
                    part.push(j);
                }
            });
        }
        parts.push(part);
    }
    parts
}

/// For a subject that the photo cuts off below: its foot, of which no picture says much, goes straight down as wide as
/// it is a sixth of its height up. What hangs down further than the foot as a whole goes.
pub fn square_foot(volume: &mut Volume) {
    let [nx, ny, nz] = volume.dims;
    let slice = nx * ny;
    let area: Vec<usize> =
        (0..nz).map(|z| volume.data[z * slice..(z + 1) * slice].iter().filter(|d| **d < 0.0).count()).collect();
    let (Some(lowest), Some(highest)) = (area.iter().position(|a| *a > 0), area.iter().rposition(|a| *a > 0)) else {
        return;
    };
    let searched = lowest + (highest - lowest) / 4;
    let widest = area[lowest..=searched].iter().max().copied().unwrap_or(0);
    let foot = (lowest..=searched).find(|z| 3 * area[*z] >= widest).unwrap_or(searched);
    let top = foot + (highest - foot) / 6;
    for z in (foot..top).rev() {
        let (below, above) = volume.data.split_at_mut((z + 1) * slice);
        for (value, above) in below[z * slice..].iter_mut().zip(&above[..slice]) {
            *value = value.min(*above);
        }
    }
    let height = volume.position(0, 0, foot).z - 0.5 * volume.voxel;
    cut_below(volume, height);
}

/// Cuts the lowest band flat, at most two voxels and what the views disagree up, so that the subject stands on a plane. Returns its height.
pub fn flatten_ground(volume: &mut Volume) -> Option<f32> {
    let [nx, ny, nz] = volume.dims;
    let slice = nx * ny;
    let area: Vec<usize> =
        (0..nz).map(|z| volume.data[z * slice..(z + 1) * slice].iter().filter(|d| **d < 0.0).count()).collect();
    let lowest = area.iter().position(|a| *a > 0)?;
    let above = |z: usize| area[z..(z + 4).min(nz)].iter().max().copied().unwrap_or(0);
    let band = 2 + (1.5 * volume.noise / volume.voxel) as usize;
    let last = (lowest + band).min(nz - 1);
    let ground = (lowest..=last).find(|&z| 2 * area[z] >= above(z)).unwrap_or(last);
    if ground == 0 {
        return None;
    }
    // Where the columns that begin at this slice cross zero; most of them reach the plane.
    let mut crossings: Vec<f32> = (ground * slice..(ground + 1) * slice)
        .filter(|&i| volume.data[i] < 0.0)
        .map(|i| {
            let (below, here) = (volume.data[i - slice], volume.data[i]);
            if below < 0.0 { 1.0 } else { (here / (here - below)).clamp(0.0, 1.0) }
        })
        .collect();
    crossings.sort_by(f32::total_cmp);
    let middle = crossings.get(crossings.len() / 2).copied().unwrap_or(0.5).clamp(0.05, 0.95);
    let height = volume.position(0, 0, ground).z - middle * volume.voxel;
    cut_below(volume, height);
    Some(height)
}

/// Everything below `height` becomes outside.
pub fn cut_below(volume: &mut Volume, height: f32) {
    let slice = volume.dims[0] * volume.dims[1];
    for z in 0..volume.dims[2] {
        let cut = height - volume.position(0, 0, z).z;
        for value in &mut volume.data[z * slice..(z + 1) * slice] {
            *value = value.max(cut.min(volume.truncation));
        }
    }
}

fn neighbours(dims: &[usize; 3], i: usize, mut visit: impl FnMut(usize)) {
    let [nx, ny, nz] = *dims;
    // A grid has fewer samples than 2³², and what is no longer is divided in half the time.
    let (row, [across, down]) = (i as u32 / nx as u32, [nx, ny].map(|n| n as u32));
    let (x, y, z) = ((i as u32 % across) as usize, (row % down) as usize, (row / down) as usize);
    if x > 0 {
        visit(i - 1);
    }
    if x + 1 < nx {
        visit(i + 1);
    }
    if y > 0 {
        visit(i - nx);
    }
    if y + 1 < ny {
        visit(i + nx);
    }
    if z > 0 {
        visit(i - nx * ny);
    }
    if z + 1 < nz {
        visit(i + nx * ny);
    }
}

/// Watertight and consistently wound: every directed edge once, and its opposite once.
pub fn edges_used_twice(triangles: &[[u32; 3]]) -> bool {
    let mut edges: Vec<(u32, u32)> =
        triangles.iter().flat_map(|t| [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])]).collect();
    edges.sort_unstable();
    edges.windows(2).all(|w| w[0] != w[1]) && edges.iter().all(|&(a, b)| a != b && edges.binary_search(&(b, a)).is_ok())
}

/// Vertices that no triangle uses go; the rest keep their order.
pub fn without_unused(surface: &Surface) -> Surface {
    let mut new_index = vec![u32::MAX; surface.positions.len()];
    for t in &surface.triangles {
        for &i in t {
            new_index[i as usize] = 0;
        }
    }
    let mut positions = Vec::new();
    for (slot, p) in new_index.iter_mut().zip(&surface.positions) {
        if *slot == 0 {
            *slot = positions.len() as u32;
            positions.push(*p);
        }
    }
    let triangles = surface.triangles.iter().map(|t| t.map(|i| new_index[i as usize])).collect();
    Surface { positions, triangles }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::extract::extract;

    fn volume(f: impl Fn(Vec3) -> f32) -> Volume {
        let n = 48;
        let voxel = 2.0 / (n - 1) as f32;
        let mut v = Volume {
            origin: Vec3::splat(-1.0),
            voxel,
            dims: [n; 3],
            truncation: 0.2,
            data: vec![0.2; n * n * n],
            noise: 0.0,
        };
        for z in 1..n - 1 {
            for y in 1..n - 1 {
                for x in 1..n - 1 {
                    let i = v.index(x, y, z);
                    v.data[i] = f(v.position(x, y, z)).clamp(-0.2, 0.2);
                }
            }
        }
        v
    }

    #[test]
    fn cavities_fill() {
        let mut v = volume(|p| (p.length() - 0.8).max(0.4 - p.length()));
        fill_cavities(&mut v);
        let surface = extract(&v);
        let truth = 4.0 / 3.0 * std::f64::consts::PI * 0.512;
        assert!((surface.volume() - truth).abs() < 0.02 * truth);
        assert!(surface.positions.iter().all(|p| p.length() > 0.7));
    }

    #[test]
    fn specks_go_and_large_or_touching_parts_stay() {
        let ball = |p: Vec3, c: Vec3, r: f32| (p - c).length() - r;
        let mut v = volume(|p| {
            ball(p, Vec3::new(-0.4, 0.0, 0.0), 0.45)
                .min(ball(p, Vec3::new(0.6, 0.0, 0.0), 0.25)) // large: stays
                .min(ball(p, Vec3::new(-0.4, 0.0, 0.57), 0.08)) // small, touching: stays
                .min(ball(p, Vec3::new(0.6, 0.7, 0.7), 0.07)) // a speck far away: goes
        });
        assert_eq!(keep_what_belongs(&mut v), (3, 1));
        let (lo, hi) = extract(&v).bounds();
        assert!(hi.y < 0.5 && hi.z > 0.6 && lo.x < -0.8 && hi.x > 0.8);
    }

    #[test]
    fn a_foot_that_the_photo_cuts_off_is_squared() {
        // A block with a notch out of its foot, a tip that hangs down, and a bay higher up.
        let solid = |p: Vec3| (p.abs() - Vec3::new(0.4, 0.4, 0.7)).max_element();
        let notch = |p: Vec3| ((p - Vec3::new(0.4, 0.0, -0.7)).abs() - Vec3::new(0.3, 0.2, 0.15)).max_element();
        let bay = |p: Vec3| ((p - Vec3::new(0.4, 0.0, 0.1)).abs() - Vec3::new(0.2, 0.2, 0.15)).max_element();
        let tip = |p: Vec3| ((p - Vec3::new(-0.3, 0.0, -0.75)).abs() - Vec3::new(0.08, 0.08, 0.15)).max_element();
        let mut v = volume(|p| solid(p).max(-notch(p)).max(-bay(p)).min(tip(p)));
        let bay_before = v.data[v.index(36, 20, 22)];
        square_foot(&mut v);
        assert_eq!(v.data[v.index(36, 20, 22)], bay_before);
        let surface = extract(&v);
        let low = surface.bounds().0.z;
        assert!((low + 0.7).abs() < 1.6 * v.voxel, "{low}");
        // All of the block's outline stands on the ground.
        let area = |z: f32| {
            (0..v.data.len())
                .filter(|i| {
                    v.data[*i] < 0.0 && (v.position(0, 0, i / (v.dims[0] * v.dims[1])).z - z).abs() < 0.5 * v.voxel
                })
                .count()
        };
        assert_eq!(area(-0.62), area(-0.46));
        square_foot(&mut volume(|_| 0.2));
    }

    #[test]
    fn ground_is_flat_and_at_most_two_voxels_up() {
        for (shape, low) in [(0, -0.6), (1, -0.5)] {
            let mut v = volume(|p| match shape {
                0 => p.length() - 0.6,
                _ => (p.abs() - Vec3::splat(0.5)).max_element() + 0.01 * (37.0 * p.x).sin(),
            });
            let height = flatten_ground(&mut v).unwrap();
            assert!(height > low - 0.02 && height < low + 2.6 * v.voxel, "{height}");
            let surface = extract(&v);
            let flat = surface.positions.iter().filter(|p| (p.z - height).abs() < 0.03 * v.voxel).count();
            assert!(surface.positions.iter().all(|p| p.z > height - 0.03 * v.voxel));
            assert!(flat > 20, "{flat}");
            assert!(edges_used_twice(&surface.triangles));
        }
    }
}
