//! Pictures to take colours from: what they see of a point, and how far they may be trusted.

use super::bake::Texel;
use super::color::Linear;
use super::raster::Seen;
use super::{PhotoView, View};
use crate::models::region::dilated;
use crate::splat::Camera;
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// A picture to take colours from, ready to be asked.
pub struct Source {
    camera: Camera,
    eye: Vec3,
    /// Linear light.
    color: Vec<[f32; 3]>,
    /// How far each pixel may be trusted, 0..1.
    trust: Vec<f32>,
    /// The nearest surface around each pixel.
    nearest: Vec<f32>,
    /// How far behind it a point may lie and still be seen, beside what pixels and slopes make.
    slack: f32,
}

impl Source {
    /// Bytes of memory.
    pub fn bytes(&self) -> usize {
        20 * self.color.len()
    }

    /// How far the camera is away.
    pub fn distance(&self, p: Vec3) -> f32 {
        self.eye.distance(p)
    }

    /// Position in the picture and cosine of the view on `texel`; None when it is hidden or looks away.
    pub fn sees(&self, texel: &Texel) -> Option<(Vec2, f32)> {
        let c = &self.camera;
        let p = c.rotation * texel.position + c.translation;
        let to_eye = (self.eye - texel.position).normalize_or_zero();
        // Bumps of single faces say little; the smooth normal alone would let back sides in.
        let straight = if texel.face.dot(to_eye) > 0.05 { (texel.face + texel.normal).dot(to_eye) / 2.0 } else { 0.0 };
        if straight < 0.1 || p.z <= 0.01 {
            return None;
        }
        let at = Vec2::new(c.fx * p.x / p.z + c.cx, c.fy * p.y / p.z + c.cy);
        if !(at.x >= 1.0 && at.y >= 1.0 && at.x < c.width as f32 - 1.0 && at.y < c.height as f32 - 1.0) {
            return None;
        }
        let nearest = self.nearest[at.y as usize * c.width as usize + at.x as usize];
        let pixel = p.z / c.fx;
        let slope = (1.0 - straight * straight).sqrt() / straight;
        let tolerance = 2.5 * pixel * (1.0 + slope.min(5.0)) + self.slack;
        (nearest > 0.0 && p.z <= nearest + tolerance).then_some((at, straight))
    }

    /// Bilinear colour and trust.
    pub fn at(&self, at: Vec2) -> ([f32; 3], f32) {
        let w = self.camera.width as usize;
        let q = at - Vec2::splat(0.5);
        let (x, y) = (q.x as usize, q.y as usize);
        let (tx, ty) = (q.x - x as f32, q.y - y as f32);
        let i = y * w + x;
        let mut color = [0f32; 3];
        let (mut sum, mut trust) = (0f32, 0f32);
        for (j, share) in
            [(i, (1.0 - tx) * (1.0 - ty)), (i + 1, tx * (1.0 - ty)), (i + w, (1.0 - tx) * ty), (i + w + 1, tx * ty)]
        {
            // What is not trusted gives no colour.
            let k = share * (self.trust[j] + 1e-6);
            for (c, v) in color.iter_mut().zip(self.color[j]) {
                *c += k * v;
            }
            sum += k;
            trust += share * self.trust[j];
        }
        (color.map(|c| c / sum.max(1e-12)), trust)
    }
}

/// The least of what is there (> 0) in the square of `reach` pixels around each pixel; 0 where there is none.
fn nearest_around(depth: &[f32], width: usize, height: usize, reach: usize) -> Vec<f32> {
    let mut rows = vec![0f32; depth.len()];
    rows.par_chunks_mut(width.max(1)).zip(depth.par_chunks(width.max(1))).for_each(|(out, row)| {
        for (x, out) in out.iter_mut().enumerate() {
            let window = &row[x.saturating_sub(reach)..(x + reach + 1).min(width)];
            *out = window.iter().filter(|d| **d > 0.0).copied().fold(f32::INFINITY, f32::min);
        }
    });
    let mut result = vec![f32::INFINITY; depth.len()];
    result.par_chunks_mut(width.max(1)).enumerate().for_each(|(y, out)| {
        for row in y.saturating_sub(reach)..(y + reach + 1).min(height) {
            for (out, least) in out.iter_mut().zip(&rows[row * width..]) {
                *out = out.min(*least);
            }
        }
        out.iter_mut().filter(|d| d.is_infinite()).for_each(|d| *d = 0.0);
    });
    result
}

/// Trust in a rendered colour by how much of it is there, 0..1.
fn firm(view: &View, pixel: usize) -> f32 {
    ((view.firmness(pixel) - 0.5) / 0.45).clamp(0.0, 1.0).powi(2)
}

/// A rendered view over the mesh that it is asked about.
pub fn rendered_source(view: &View, mesh_seen: &Seen, background: [f32; 3], linear: &Linear) -> Source {
    let (w, h) = (mesh_seen.width, mesh_seen.height);
    let solid = |i: usize| view.solid(i);
    // Both the mesh and what was rendered may hide a point.
    let depth: Vec<f32> = (0..w * h)
        .map(|i| match (mesh_seen.depth[i], solid(i)) {
            (m, true) if m > 0.0 => m.min(view.depth[i]),
            (m, _) => m,
        })
        .collect();
    let trust = (0..w * h)
        .map(|i| {
            if !solid(i) || mesh_seen.depth[i] <= 0.0 {
                return 0.0;
            }
            let behind = (view.depth[i] - mesh_seen.depth[i]) / 0.08;
            firm(view, i) * (1.0 - behind).clamp(0.02, 1.0)
        })
        .collect();
    let nearest = nearest_around(&depth, w, h, 1);
    let color = (0..w * h)
        .map(|i| {
            // What is not beside anything trusted is never asked for.
            if nearest[i] <= 0.0 {
                return [0.0; 3];
            }
            let a = view.alpha[i].clamp(1.0 - view.passing, 1.0);
            std::array::from_fn(|k| linear.of((view.color[i][k] - (1.0 - a) * background[k]) / a))
        })
        .collect();
    let eye = view.camera.position();
    Source { camera: view.camera, eye, color, trust, nearest, slack: 0.006 }
}

/// A rendered view by its own depth: for meshes that are made piece by piece, where what hides a point may be another piece's.
///
/// `slack`: how far behind what was rendered a point may lie, beside what pixels and slopes make.
pub fn view_source(view: &View, background: [f32; 3], slack: f32, linear: &Linear) -> Source {
    let (w, h) = (view.camera.width as usize, view.camera.height as usize);
    let solid = |i: usize| view.solid(i);
    let depth: Vec<f32> = (0..w * h).map(|i| if solid(i) { view.depth[i] } else { 0.0 }).collect();
    let trust = |i: usize| if solid(i) { firm(view, i) } else { 0.0 };
    let color = |i: usize| {
        let a = view.alpha[i].clamp(1.0 - view.passing, 1.0);
        std::array::from_fn(|k| linear.of((view.color[i][k] - (1.0 - a) * background[k]) / a))
    };
    Source {
        camera: view.camera,
        eye: view.camera.position(),
        color: (0..w * h).map(color).collect(),
        trust: (0..w * h).map(trust).collect(),
        nearest: nearest_around(&depth, w, h, 1),
        slack,
    }
}

/// The photo over the mesh that it is asked about.
pub fn photo_source(photo: &PhotoView, mesh_seen: &Seen, linear: &Linear) -> Source {
    let (w, h) = (mesh_seen.width, mesh_seen.height);
    let reach = (w / 170).max(1);
    let trust = edge_trust(photo.mask, w, h, 2 * reach);
    let color = photo.color.iter().map(|c| c.map(|v| linear.of(v))).collect();
    Source {
        camera: photo.camera,
        eye: photo.camera.position(),
        color,
        trust,
        nearest: nearest_around(&mesh_seen.depth, w, h, reach),
        // What hides so little is a bump that should not be there.
        slack: 0.03,
    }
}

/// Trust in each pixel of a cut-out: none at its edge, which is mixed with what is behind, full `reach` pixels inside it or,
/// in parts narrower than that, on their middle line.
fn edge_trust(mask: &[f32], width: usize, height: usize, reach: usize) -> Vec<f32> {
    /// Pixels whose middle is so near the edge hold something of the background.
    const MIXED: f32 = 0.75;
    let off: Vec<bool> = mask.iter().map(|m| *m < 0.5 || m.is_nan()).collect();
    let beside = dilated(width, height, reach, |i| off[i]);
    let around = |i: usize| {
        let (x, y) = (i % width, i / width);
        let columns = x.saturating_sub(reach)..(x + reach + 1).min(width);
        let rows = y.saturating_sub(reach)..(y + reach + 1).min(height);
        rows.flat_map(move |v| {
            columns.clone().map(move |u| (v * width + u, (u.abs_diff(x) as f32).hypot(v.abs_diff(y) as f32)))
        })
    };
    let to_edge: Vec<f32> = (0..mask.len())
        .into_par_iter()
        .map(|i| {
            if off[i] {
                0.0
            } else if !beside[i] {
                reach as f32
            } else {
                around(i).filter(|(j, _)| off[*j]).map(|(_, d)| d - 0.5).fold(reach as f32, f32::min)
            }
        })
        .collect();
    (0..mask.len())
        .into_par_iter()
        .map(|i| {
            if to_edge[i] <= MIXED {
                return 0.0;
            }
            // As far from the edge as one gets without leaving the disc that reaches it.
            let most = match to_edge[i] >= reach as f32 {
                true => reach as f32,
                false => around(i).filter(|(_, d)| *d <= to_edge[i] + 1.5).map(|(j, _)| to_edge[j]).fold(0.0, f32::max),
            };
            ((to_edge[i] - MIXED) / (most.min(reach as f32) - MIXED).max(MIXED)).clamp(0.0, 1.0)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_are_trusted_in_their_middle_and_edges_never() {
        // 64 × 48: a bar four pixels wide, and a block.
        let (w, h) = (64usize, 48usize);
        let on = |x: usize| (8..12).contains(&x) || (24..56).contains(&x);
        let mask: Vec<f32> = (0..w * h).map(|i| if on(i % w) { 1.0 } else { 0.0 }).collect();
        let trust = edge_trust(&mask, w, h, 6);
        let row: Vec<f32> = trust[24 * w..25 * w].to_vec();
        assert!((0..w).filter(|x| !on(*x)).all(|x| row[x] == 0.0));
        assert_eq!([row[8], row[11], row[24], row[55]], [0.0; 4]);
        assert!(row[9] > 0.9 && row[10] > 0.9, "{row:?}");
        // In the block it grows over the whole reach.
        assert!(row[26] > 0.0 && row[26] < 0.5 && row[26] < row[28] && row[31] == 1.0 && row[40] == 1.0, "{row:?}");
    }
}
