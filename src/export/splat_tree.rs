//! A scene of Gaussians as 3D Tiles: a tree of cubes, each with Gaussians that stand for what is in it, the coarser the larger
//! the cube; children replace their parent.
//!
//! A cube of more Gaussians than a tile may have is cut into eight. Its own tile is made of its children's: Gaussians of one
//! cell of a grid become one of the same mean, covariance and colour (moments weighted by opacity and area), as opaque as
//! they cover its area together. Its geometric error is the cell's edge: nothing smaller is told apart.

use std::collections::BTreeMap;

use glam::{Mat3, Quat, Vec3};
use orb_formats::tiles3d::{self, Tile, Tileset, Volume};
use orb_formats::{File, glb};
use rayon::prelude::*;

use super::model::to_earth;
use super::scene::{splat_asset, y_up};
use super::{Labels, format_error, label};
use crate::Result;
use crate::geo::Placement;
use crate::geo::similarity::symmetric_eigen;
use crate::splat::Gaussians;

/// Most Gaussians of one tile.
pub const TILE: usize = 40_000;
/// Cubes within cubes at most: many Gaussians at one place cannot be cut apart.
const DEEPEST: usize = 12;

/// A node of the tree.
struct Node {
    gaussians: Gaussians,
    error: f64,
    children: Vec<Node>,
}

/// `tiles3d/tileset.json` and one GLB a tile, at their place on the Earth. Lengths in metres.
///
/// # Errors
/// As the writers.
pub fn splat_tree(g: &Gaussians, most: usize, placement: &Placement, labels: &Labels) -> Result<Vec<File>> {
    let low = g.positions.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = g.positions.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let edge = (high - low).max_element().max(1e-3);
    let tree = node(g.clone(), low, edge, most.max(16), DEEPEST);
    let mut files = Vec::new();
    let (mut root, ..) = write(&tree, "t", placement, labels, &mut files)?;
    root.transform = Some(to_earth(placement));
    let size = f64::from(edge) * 3f64.sqrt();
    let gltf_extensions = vec!["KHR_gaussian_splatting".into(), "KHR_xmp_json_ld".into()];
    let tileset = Tileset {
        geometric_error: size.max(root.geometric_error),
        root,
        gltf_extensions,
        label: label(placement, labels),
    };
    let bytes = tiles3d::write(&tileset).map_err(format_error)?;
    files.insert(0, File { path: "tiles3d/tileset.json".into(), bytes, media_type: "application/json" });
    Ok(files)
}

fn node(g: Gaussians, low: Vec3, edge: f32, most: usize, depth: usize) -> Node {
    if g.len() <= most || depth == 0 {
        return Node { gaussians: g, error: 0.0, children: Vec::new() };
    }
    let half = edge / 2.0;
    let octant = |p: Vec3| {
        let d = p - low;
        usize::from(d.x >= half) | usize::from(d.y >= half) << 1 | usize::from(d.z >= half) << 2
    };
    let parts: Vec<(usize, Gaussians)> = (0..8)
        .into_par_iter()
        .map(|o| (o, g.filtered(|i| octant(g.positions[i]) == o)))
        .filter(|(_, part)| !part.is_empty())
        .collect();
    drop(g);
    let children: Vec<Node> = parts
        .into_par_iter()
        .map(|(o, part)| {
            let corner = low + half * Vec3::new((o & 1) as f32, (o >> 1 & 1) as f32, (o >> 2 & 1) as f32);
            node(part, corner, half, most, depth - 1)
        })
        .collect();
    let mut all = Gaussians::default();
    children.iter().for_each(|c| all.extend(&c.gaussians));
    let finest = children.iter().map(|c| c.error).fold(0.0, f64::max);
    let mut cell = (edge / 256.0).max(1.2 * finest as f32);
    let mut coarse = merged(&all, low, cell);
    while coarse.len() > most && cell < edge {
        cell *= 1.3;
        coarse = merged(&all, low, cell);
    }
    Node { gaussians: coarse, error: f64::from(cell), children }
}

/// One Gaussian for those of each cell; those wider than a cell stay as they are.
fn merged(g: &Gaussians, low: Vec3, cell: f32) -> Gaussians {
    let mut cells: BTreeMap<[i32; 3], Vec<usize>> = BTreeMap::new();
    let mut out = Gaussians::default();
    let mut kept = vec![false; g.len()];
    for (i, p) in g.positions.iter().enumerate() {
        if g.log_scales[i].max_element().exp() > cell {
            kept[i] = true;
        } else {
            cells.entry(((*p - low) / cell).floor().to_array().map(|v| v as i32)).or_default().push(i);
        }
    }
    for members in cells.values() {
        if let [one] = members[..] {
            kept[one] = true;
        }
    }
    out.extend(&g.filtered(|i| kept[i]));
    let groups: Vec<&Vec<usize>> = cells.values().filter(|m| m.len() > 1).collect();
    let made: Vec<Gaussians> = groups.par_iter().map(|members| one_of(g, members)).collect();
    made.iter().for_each(|m| out.extend(m));
    out
}

/// What a Gaussian covers of a picture, up to a factor: its two longest axes.
fn area(log_scale: Vec3) -> f64 {
    let mut s = log_scale.to_array().map(|v| f64::from(v).exp());
    s.sort_by(f64::total_cmp);
    s[1] * s[2]
}

fn one_of(g: &Gaussians, members: &[usize]) -> Gaussians {
    let opacity = |i: usize| 1.0 / (1.0 + f64::from(-g.logit_opacities[i]).exp());
    let weight: Vec<f64> = members.iter().map(|i| (opacity(*i) * area(g.log_scales[*i])).max(1e-20)).collect();
    let total: f64 = weight.iter().sum();
    let mean = members.iter().zip(&weight).map(|(i, w)| g.positions[*i].as_dvec3() * *w).sum::<glam::DVec3>() / total;
    let mut covariance = [[0.0f64; 3]; 3];
    let mut sh = [[0.0f64; 3]; 16];
    for (i, w) in members.iter().zip(&weight) {
        let q = g.rotations[*i];
        let axes = Mat3::from_quat(Quat::from_xyzw(q[1], q[2], q[3], q[0]).normalize()).as_dmat3();
        let s = g.log_scales[*i].as_dvec3().to_array().map(|v| (2.0 * v).exp());
        let d = (g.positions[*i].as_dvec3() - mean).to_array();
        for a in 0..3 {
            for b in 0..3 {
                let own: f64 = (0..3).map(|k| axes.col(k)[a] * axes.col(k)[b] * s[k]).sum();
                covariance[a][b] += w / total * (own + d[a] * d[b]);
            }
        }
        for (sum, coefficient) in sh.iter_mut().zip(&g.sh[*i]) {
            (0..3).for_each(|c| sum[c] += w / total * f64::from(coefficient[c]));
        }
    }
    let (values, vectors) = symmetric_eigen(covariance);
    let column = |k: usize| Vec3::new(vectors[0][k] as f32, vectors[1][k] as f32, vectors[2][k] as f32);
    let mut turn = Mat3::from_cols(column(0), column(1), column(2));
    if turn.determinant() < 0.0 {
        turn.z_axis = -turn.z_axis;
    }
    let q = Quat::from_mat3(&turn).normalize();
    let log_scale = Vec3::from_array(values.map(|v| 0.5 * v.max(1e-20).ln() as f32));
    let covers = (total / area(log_scale)).clamp(0.005, 0.99);
    Gaussians {
        positions: vec![mean.as_vec3()],
        log_scales: vec![log_scale],
        rotations: vec![[q.w, q.x, q.y, q.z]],
        logit_opacities: vec![(covers / (1.0 - covers)).ln() as f32],
        sh: vec![sh.map(|c| c.map(|v| v as f32))],
    }
}

/// The tile of a node, and its bounds: three standard deviations are drawn, and a tile's volume holds its children's.
fn write(
    n: &Node,
    name: &str,
    placement: &Placement,
    labels: &Labels,
    files: &mut Vec<File>,
) -> Result<(Tile, [f64; 3], [f64; 3])> {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for (p, s) in n.gaussians.positions.iter().zip(&n.gaussians.log_scales) {
        let reach = 3.0 * f64::from(s.max_element().exp());
        for (axis, at) in p.as_dvec3().to_array().into_iter().enumerate() {
            low[axis] = low[axis].min(at - reach);
            high[axis] = high[axis].max(at + reach);
        }
    }
    let content = format!("{name}.glb");
    let bytes = glb::write(&splat_asset(&y_up(&n.gaussians), placement, labels)).map_err(format_error)?;
    files.push(File { path: format!("tiles3d/{content}"), bytes, media_type: "model/gltf-binary" });
    let mut children = Vec::new();
    for (k, child) in n.children.iter().enumerate() {
        let (tile, l, h) = write(child, &format!("{name}{k}"), placement, labels, files)?;
        (0..3).for_each(|i| (low[i], high[i]) = (low[i].min(l[i]), high[i].max(h[i])));
        children.push(tile);
    }
    let volume = Volume::around(low, high);
    let tile = Tile { transform: None, volume, geometric_error: n.error, content: Some(content), children };
    Ok((tile, low, high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::Marking;
    use crate::bench::perception::psnr;
    use crate::geo::{Geodetic, HeadingSource};
    use crate::splat::train::random::Random;
    use crate::splat::{Camera, SH_C0, render};

    /// A wavy sheet of small discs, in stripes.
    fn sheet(n: usize) -> Gaussians {
        let mut r = Random::new(3);
        let mut g = Gaussians::default();
        for _ in 0..n {
            let (x, y) = (20.0 * r.uniform() - 10.0, 20.0 * r.uniform() - 10.0);
            g.positions.push(Vec3::new(x, y, 0.5 * (0.4 * x).sin()));
            g.log_scales.push(Vec3::new(0.12f32.ln(), 0.12f32.ln(), 0.02f32.ln()));
            g.rotations.push([1.0, 0.0, 0.0, 0.0]);
            g.logit_opacities.push(1.5);
            let mut sh = [[0.0; 3]; 16];
            let light = if (x / 4.0).rem_euclid(1.0) < 0.5 { 0.2 } else { 0.7 };
            sh[0] = [(light - 0.5) / SH_C0, (0.3 - 0.5) / SH_C0, (0.6 - 0.5) / SH_C0];
            g.sh.push(sh);
        }
        g
    }

    fn levels(n: &Node, depth: usize, out: &mut Vec<(usize, usize, bool)>) {
        out.push((depth, n.gaussians.len(), n.children.is_empty()));
        for c in &n.children {
            assert!(c.error < n.error, "{} {}", c.error, n.error);
            levels(c, depth + 1, out);
        }
    }

    #[test]
    fn coarser_tiles_look_alike_from_afar_and_nothing_is_lost_in_the_leaves() {
        let g = sheet(30_000);
        let low = Vec3::new(-10.0, -10.0, -1.0);
        let tree = node(g.clone(), low, 20.0, 3000, DEEPEST);
        let mut all = Vec::new();
        levels(&tree, 0, &mut all);
        assert!(all.iter().all(|(_, count, _)| *count <= 3000) && all.len() > 10, "{all:?}");
        assert_eq!(all.iter().filter(|l| l.2).map(|l| l.1).sum::<usize>(), g.len());
        // Drawn where the cell's edge is a pixel and a half.
        let distance = 1.5f64.recip() * tree.error * 64.0 / (0.5f64).tan() / 2.0;
        let camera = Camera::look_at(Vec3::new(0.3, -0.8, 1.0) * distance.max(25.0) as f32, Vec3::ZERO, 1.0, 64);
        let (fine, coarse) = (render(&g, &camera, [0.0; 3]), render(&tree.gaussians, &camera, [0.0; 3]));
        let close = psnr(&fine.color, &coarse.color);
        assert!(close > 26.0, "{close} dB from {distance} m, {} Gaussians", tree.gaussians.len());
    }

    #[test]
    fn the_tree_is_written_and_read_back() {
        let placement = Placement {
            origin: Geodetic { latitude: 48.0, longitude: 11.0, height: 500.0 },
            heading: 30.0,
            heading_source: HeadingSource::Georegistration,
        };
        let labels = Labels {
            stem: "scene".into(),
            marking: Marking::UNCLASSIFIED,
            utc: "2026-11-22T00:00:00.000Z".into(),
            heading_source: "georegistration",
            scale_source: "georegistration",
        };
        let files = splat_tree(&sheet(2000), 400, &placement, &labels).unwrap();
        let read = tiles3d::read(&files[0].bytes).unwrap();
        fn count(t: &Tile) -> usize {
            1 + t.children.iter().map(count).sum::<usize>()
        }
        assert_eq!(count(&read.root), files.len() - 1);
        assert!(read.root.children.len() > 1 && read.root.geometric_error > 0.0 && read.root.transform.is_some());
        let inside = |a: &Tile, b: &Tile| {
            (0..3).all(|i| {
                let half = |t: &Tile| t.volume.half_axes[i][i];
                (b.volume.center[i] - a.volume.center[i]).abs() <= half(a) - half(b) + 0.1
            })
        };
        assert!(read.root.children.iter().all(|c| inside(&read.root, c)));
        // One Gaussian for many has their moments.
        let g = sheet(50);
        let one = one_of(&g, &(0..50).collect::<Vec<_>>());
        let mean = g.positions.iter().sum::<Vec3>() / 50.0;
        assert!(one.positions[0].distance(mean) < 1e-3);
        assert!(splat_tree(&sheet(1), 400, &placement, &labels).unwrap().len() == 2);
    }
}
