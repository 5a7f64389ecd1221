//! A scene from straight above, every place under its own pixel: what maps and terrain are covered with.
//!
//! Colours are those that the photos' cameras see on average: harmonics say nothing of a direction that no camera looked in,
//! and seldom one looks straight down. Places that nothing covers get the colours around them. Unit frame, Z up.

use glam::{Mat3, Vec2, Vec3};
use rayon::prelude::*;

use super::begin::sees;
use super::ground;
use crate::splat::render::{Drawer, sh};
use crate::splat::{Camera, Gaussians, SH_C0, SH_COEFFICIENTS};

/// Pixels across a piece that is drawn at a time.
const PIECE: u32 = 1024;
/// How far above a piece its camera stands, in widths of the piece: what rises by a tenth of the width is off by a
/// 40,000th of it.
const ABOVE: f32 = 2000.0;
/// Pixels that are less covered get the colours around them.
const COVERED: f32 = 0.5;
/// Cameras that are asked for a colour, at most.
const ASKED: usize = 64;

/// A picture from above.
#[derive(Clone, Debug)]
pub struct Nadir {
    /// Row by row from the greatest y.
    pub pixels: Vec<[u8; 3]>,
    pub width: usize,
    /// Least x and greatest y.
    pub corner: Vec2,
    pub pixel: f32,
    /// Share of the pixels that something covers.
    pub covered: f32,
}

impl Nadir {
    /// Draws what lies between `low` and `high`, pixels of such a size. `g`: their colours as [`as_seen`] makes them.
    pub fn of(g: &Gaussians, [low, high]: [Vec2; 2], pixel: f32) -> Nadir {
        let size = ((high - low) / pixel).ceil().max(Vec2::ONE);
        let (width, height) = (size.x as usize, size.y as usize);
        let corner = Vec2::new(low.x, low.y + height as f32 * pixel);
        let mut drawer = Drawer::new(g);
        drawer.depth = false;
        let mut colors = [(); 3].map(|()| vec![0.0f32; width * height]);
        let mut known = vec![false; width * height];
        for top in (0..height).step_by(PIECE as usize) {
            for left in (0..width).step_by(PIECE as usize) {
                let camera = above(corner + pixel * Vec2::new(left as f32, -(top as f32)), pixel);
                let frame = drawer.render(&camera, [0.0; 3]);
                for y in 0..(height - top).min(PIECE as usize) {
                    for x in 0..(width - left).min(PIECE as usize) {
                        let (from, to) = (y * PIECE as usize + x, (top + y) * width + left + x);
                        if frame.alpha[from] >= COVERED {
                            known[to] = true;
                            (0..3).for_each(|k| colors[k][to] = frame.color[from][k] / frame.alpha[from]);
                        }
                    }
                }
            }
        }
        colors.par_iter_mut().for_each(|channel| ground::fill(channel, &known, width));
        let byte = |v: f32| (v.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        Nadir {
            pixels: (0..width * height).map(|i| [0, 1, 2].map(|k| byte(colors[k][i]))).collect(),
            width,
            corner,
            pixel,
            covered: known.iter().filter(|k| **k).count() as f32 / known.len() as f32,
        }
    }

    /// Between the pixels' middles, bilinear; at the edge beyond it.
    pub fn color(&self, p: Vec2) -> [u8; 3] {
        let height = self.pixels.len() / self.width;
        let at = Vec2::new(p.x - self.corner.x, self.corner.y - p.y) / self.pixel - 0.5;
        let at = at.clamp(Vec2::ZERO, Vec2::new((self.width - 1) as f32, (height - 1) as f32));
        let (x, y, a, b) = (at.x as usize, at.y as usize, at.x.fract(), at.y.fract());
        let of =
            |x: usize, y: usize| self.pixels[y.min(height - 1) * self.width + x.min(self.width - 1)].map(f32::from);
        let corners = [of(x, y), of(x + 1, y), of(x, y + 1), of(x + 1, y + 1)];
        let weights = [(1.0 - a) * (1.0 - b), a * (1.0 - b), (1.0 - a) * b, a * b];
        std::array::from_fn(|k| (0..4).map(|i| weights[i] * corners[i][k]).sum::<f32>().round() as u8)
    }
}

/// A camera so far above a square piece that all its rays are upright. `corner`: least x and greatest y.
fn above(corner: Vec2, pixel: f32) -> Camera {
    let size = PIECE as f32;
    let width = size * pixel;
    let middle = corner + Vec2::new(0.5, -0.5) * width;
    // x right, y down the picture, which is south, z down.
    let rotation = Mat3::from_diagonal(Vec3::new(1.0, -1.0, -1.0));
    let eye = middle.extend(ABOVE * width);
    Camera {
        width: PIECE,
        height: PIECE,
        fx: ABOVE * size,
        fy: ABOVE * size,
        cx: size / 2.0,
        cy: size / 2.0,
        rotation,
        translation: -(rotation * eye),
    }
}

/// The same Gaussians, from all sides in the mean colour that cameras see on them, nearer ones counting more.
pub fn as_seen(g: &Gaussians, cameras: &[Camera]) -> Gaussians {
    let step = cameras.len().div_ceil(ASKED).max(1);
    let asked: Vec<(&Camera, Vec3)> = cameras.iter().step_by(step).map(|c| (c, c.position())).collect();
    let color = |i: usize| {
        let p = g.positions[i];
        let (mut mean, mut total) = ([0.0; SH_COEFFICIENTS], 0.0);
        for (camera, eye) in &asked {
            if sees(camera, p) {
                let weight = 1.0 / (p - *eye).length_squared().max(1e-6);
                let basis = sh::basis((p - *eye).normalize_or_zero().to_array(), 3);
                mean.iter_mut().zip(basis).for_each(|(m, b)| *m += weight * b);
                total += weight;
            }
        }
        let mut out = [[0.0; 3]; SH_COEFFICIENTS];
        if total > 0.0 {
            for k in 0..3 {
                out[0][k] = mean.iter().zip(&g.sh[i]).map(|(m, s)| m * s[k]).sum::<f32>() / total / SH_C0;
            }
        } else {
            out[0] = g.sh[i][0];
        }
        out
    };
    let sh = (0..g.len()).into_par_iter().map(color).collect();
    Gaussians { sh, ..g.clone() }
}
