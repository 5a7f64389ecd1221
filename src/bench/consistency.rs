//! SC, spatial consistency: whether pictures from different sides show one and the same thing, and show it where it is.

use glam::{Vec2, Vec3};

use super::Picture;
use crate::mesh::View;
pub use crate::photo::silhouette_iou;

/// Opaque enough to have a depth.
const SOLID: f32 = 0.9;
/// In radii: further behind than this is hidden, further before counts as so much.
const HIDDEN: f32 = 0.1;
/// In radii: depths that agree this well show the same point.
const SAME: f32 = 0.02;

/// What is left after each pixel of one view is looked up in another.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Warped {
    /// Mean absolute difference of the colours of points that both views see, share of full scale.
    pub color: f64,
    /// Mean absolute difference of depths, of points that the other view does not hide, % of the subject's radius.
    pub depth: f64,
    pub pixels: usize,
}

/// Looks the pixels of `from` up in `to`; `radius` is the subject's, in scene units. None where they share too little:
/// fewer than 20 pixels.
pub fn warp(from: &View, to: &View, radius: f32) -> Option<Warped> {
    let (a, b) = (&from.camera, &to.camera);
    let back = a.rotation.transpose();
    let (mut color, mut colors, mut depth, mut depths) = (0.0, 0usize, 0.0, 0usize);
    for (i, z) in from.depth.iter().enumerate().filter(|(i, z)| **z > 0.0 && from.alpha[*i] > SOLID) {
        let (x, y) = (i % a.width as usize, i / a.width as usize);
        let ray = Vec3::new((x as f32 + 0.5 - a.cx) / a.fx, (y as f32 + 0.5 - a.cy) / a.fy, 1.0);
        let q = b.rotation * (back * (ray * *z - a.translation)) + b.translation;
        let at = Vec2::new(b.fx * q.x / q.z + b.cx, b.fy * q.y / q.z + b.cy);
        let Some((corners, weights)) = around(to, at).filter(|_| q.z > 0.0) else { continue };
        if !corners.iter().all(|c| to.alpha[*c] > SOLID && to.depth[*c] > 0.0) {
            continue;
        }
        let zs = corners.map(|c| to.depth[c]);
        let spread = zs.iter().copied().fold(f32::MIN, f32::max) - zs.iter().copied().fold(f32::MAX, f32::min);
        // Across an edge the mean of depths is nobody's depth.
        if spread > HIDDEN * radius {
            continue;
        }
        let there: f32 = zs.iter().zip(weights).map(|(z, w)| z * w).sum();
        if q.z > there + HIDDEN * radius {
            continue;
        }
        let off = (q.z - there).abs().min(HIDDEN * radius);
        depth += f64::from(100.0 * off / radius);
        depths += 1;
        if off <= SAME * radius {
            let shown: [f32; 3] =
                std::array::from_fn(|k| corners.iter().zip(weights).map(|(c, w)| to.color[*c][k] * w).sum());
            color += (0..3).map(|k| f64::from((shown[k] - from.color[i][k]).abs())).sum::<f64>() / 3.0;
            colors += 1;
        }
    }
    (depths >= 20).then(|| Warped {
        // No point that both see: as bad as can be.
        color: if colors > 0 { color / colors as f64 } else { 1.0 },
        depth: depth / depths as f64,
        pixels: depths,
    })
}

/// The four pixels around a place and their bilinear weights; None at the rim and beyond.
fn around(view: &View, at: Vec2) -> Option<([usize; 4], [f32; 4])> {
    let (w, h) = (view.camera.width as usize, view.camera.height as usize);
    let p = at - 0.5;
    if !(p.x >= 0.0 && p.y >= 0.0 && p.x < (w - 1) as f32 && p.y < (h - 1) as f32) {
        return None;
    }
    let (x, y) = (p.x as usize, p.y as usize);
    let (u, v) = (p.x - x as f32, p.y - y as f32);
    let i = y * w + x;
    Some(([i, i + 1, i + w, i + w + 1], [(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v]))
}

/// Half of the window that corners are matched by, how far they are looked for, and how alike (ZNCC) they must be.
const PATCH: i32 = 4;
pub const SEARCH: i32 = 8;
const ALIKE: f32 = 0.6;
const MOST_CORNERS: usize = 150;

/// How far, in pixels, what the true picture shows at its corners lies from where the other shows it: Shi and Tomasi's
/// corners (1994), the best zero-mean normalised cross-correlation of 9 × 9 windows within [`SEARCH`] pixels, parabolas
/// between pixels; what is not found again counts as [`SEARCH`]. The mean over the corners; None below ten of them.
pub fn reprojection_error(found: &Picture, truth: &Picture) -> Option<f64> {
    let (a, b) = (truth.luma(), found.luma());
    let (w, h) = (truth.width as i32, truth.height as i32);
    let corners = corners(&a, w, h);
    if corners.len() < 10 {
        return None;
    }
    let far = |(x, y): &(i32, i32)| -> f64 {
        let patch = window(&a, w, *x, *y);
        let score = |dx: i32, dy: i32| -> f32 {
            let (x, y) = (x + dx, y + dy);
            let inside = x >= PATCH && y >= PATCH && x < w - PATCH && y < h - PATCH;
            if inside { zncc(&patch, &window(&b, w, x, y)) } else { -1.0 }
        };
        let mut best = (score(0, 0), 0, 0);
        for dy in -SEARCH..=SEARCH {
            for dx in -SEARCH..=SEARCH {
                let s = score(dx, dy);
                if s > best.0 {
                    best = (s, dx, dy);
                }
            }
        }
        let (s, dx, dy) = best;
        if s < ALIKE {
            return f64::from(SEARCH);
        }
        let between = |less: f32, more: f32| {
            let bend = less - 2.0 * s + more;
            if s > 0.9999 || bend >= -1e-6 { 0.0 } else { (0.5 * (less - more) / bend).clamp(-0.5, 0.5) }
        };
        let (u, v) = (between(score(dx - 1, dy), score(dx + 1, dy)), between(score(dx, dy - 1), score(dx, dy + 1)));
        f64::from((dx as f32 + u).hypot(dy as f32 + v)).min(f64::from(SEARCH))
    };
    Some(corners.iter().map(far).sum::<f64>() / corners.len() as f64)
}

/// The luma in a window, its mean taken out, and its norm.
fn window(luma: &[f32], width: i32, x: i32, y: i32) -> ([f32; 81], f32) {
    let mut out = [0.0; 81];
    for (i, v) in out.iter_mut().enumerate() {
        let (dx, dy) = (i as i32 % 9 - PATCH, i as i32 / 9 - PATCH);
        *v = luma[((y + dy) * width + x + dx) as usize];
    }
    let mean = out.iter().sum::<f32>() / 81.0;
    out.iter_mut().for_each(|v| *v -= mean);
    let norm = out.iter().map(|v| v * v).sum::<f32>().sqrt();
    (out, norm)
}

fn zncc(a: &([f32; 81], f32), b: &([f32; 81], f32)) -> f32 {
    let product: f32 = a.0.iter().zip(&b.0).map(|(x, y)| x * y).sum();
    product / (a.1 * b.1).max(1e-6)
}

/// Where the smaller eigenvalue of the 5 × 5 structure tensor is largest, strongest first, 5 pixels apart.
fn corners(luma: &[f32], w: i32, h: i32) -> Vec<(i32, i32)> {
    let at = |x: i32, y: i32| luma[(y * w + x) as usize];
    let mut strength = vec![0f32; luma.len()];
    let rim = PATCH + 3;
    for y in rim..h - rim {
        for x in rim..w - rim {
            let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
            for (dx, dy) in (-2..=2).flat_map(|dy| (-2..=2).map(move |dx| (x + dx, y + dy))) {
                let (gx, gy) = (at(dx + 1, dy) - at(dx - 1, dy), at(dx, dy + 1) - at(dx, dy - 1));
                (xx, xy, yy) = (xx + gx * gx, xy + gx * gy, yy + gy * gy);
            }
            let half: f32 = (xx + yy) / 2.0;
            strength[(y * w + x) as usize] = half - ((xx - yy) / 2.0).hypot(xy);
        }
    }
    let most = strength.iter().copied().fold(0.0, f32::max);
    let mut order: Vec<usize> = (0..strength.len()).filter(|i| strength[*i] > 0.02 * most + 1e-4).collect();
    order.sort_by(|i, j| strength[*j].total_cmp(&strength[*i]).then(i.cmp(j)));
    let mut chosen: Vec<(i32, i32)> = Vec::new();
    for i in order {
        let (x, y) = (i as i32 % w, i as i32 / w);
        if chosen.iter().all(|(u, v)| (u - x).abs().max((v - y).abs()) >= 5) {
            chosen.push((x, y));
            if chosen.len() == MOST_CORNERS {
                break;
            }
        }
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splat::Camera;

    fn noise(size: usize) -> Picture {
        let value = |x: usize, y: usize| {
            let h = (x as u32).wrapping_mul(0x9e37_79b9) ^ (y as u32).wrapping_mul(0x85eb_ca6b);
            f32::from((h.wrapping_mul(0xc2b2_ae35) >> 24) as u8) / 255.0
        };
        let pixels = (0..size * size).map(|i| [value(i % size / 3, i / size / 3); 3]).collect();
        Picture::new(size, size, pixels)
    }

    #[test]
    fn a_shift_is_its_own_length() {
        let p = noise(96);
        assert_eq!(reprojection_error(&p, &p), Some(0.0));
        let shifted = |d: usize| {
            let pixels = (0..96usize * 96).map(|i| p.pixels[i / 96 * 96 + (i % 96).saturating_sub(d)]).collect();
            reprojection_error(&Picture::new(96, 96, pixels), &p).unwrap()
        };
        assert!((shifted(3) - 3.0).abs() < 0.15 && shifted(14) > 5.0, "{} {}", shifted(3), shifted(14));
        assert_eq!(reprojection_error(&p, &Picture::new(96, 96, vec![[0.5; 3]; 96 * 96])), None);
    }

    /// A wall at z = 4, coloured by where it is; the second camera stands 0.4 to the right.
    fn wall(moved: f32, off: f32, tint: f32) -> View {
        let camera = Camera {
            width: 64,
            height: 64,
            fx: 64.0,
            fy: 64.0,
            cx: 32.0,
            cy: 32.0,
            rotation: glam::Mat3::IDENTITY,
            translation: Vec3::new(-moved, 0.0, 0.0),
        };
        let color = |i: usize| {
            let x = (i as f32 % 64.0 + 0.5 - 32.0) / 64.0 * 4.0 + moved;
            [0.5 + 0.1 * x + tint; 3]
        };
        View {
            camera,
            color: (0..64 * 64).map(color).collect(),
            alpha: vec![1.0; 64 * 64],
            depth: vec![4.0 + off; 64 * 64],
            passing: crate::mesh::MEDIAN,
        }
    }

    #[test]
    fn one_wall_agrees_with_itself_and_not_with_another() {
        let same = warp(&wall(0.0, 0.0, 0.0), &wall(0.4, 0.0, 0.0), 1.0).unwrap();
        assert!(same.color < 1e-5 && same.depth < 1e-4, "{same:?}");
        let tinted = warp(&wall(0.0, 0.0, 0.0), &wall(0.4, 0.0, 0.1), 1.0).unwrap();
        assert!((tinted.color - 0.1).abs() < 1e-4 && tinted.depth < 1e-4, "{tinted:?}");
        let nearer = warp(&wall(0.0, -0.05, 0.0), &wall(0.4, 0.0, 0.0), 1.0).unwrap();
        assert!((nearer.depth - 5.0).abs() < 0.01 && nearer.color == 1.0, "{nearer:?}");
        assert_eq!(warp(&wall(0.0, 0.5, 0.0), &wall(0.4, 0.0, 0.0), 1.0), None, "all hidden");
        assert_eq!(silhouette_iou(&[1.0, 1.0, 0.0, 0.0], &[0.0, 1.0, 1.0, 0.0]), Some(1.0 / 3.0));
        assert_eq!(silhouette_iou(&[0.0], &[0.2]), None);
    }
}
