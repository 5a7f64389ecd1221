//! (1 − λ)·L1 + λ·(1 − SSIM), each pixel by its weight, forward and backward in two passes over the picture.
//!
//! SSIM (Wang et al. 2004): 11×11 Gaussian window, σ 1.5, zero outside the picture, C1 = 0.01², C2 = 0.03². Only
//! σx² + σy² enters, so four filtered maps are enough: x, y, x² + y², x·y.

mod exposed;

use rayon::prelude::*;

use exposed::{Unexposed, exposed};

use super::exposure::Change;
use super::random::hash;
use crate::splat::render::binning::TILE;
use crate::splat::render::raster_backward::TileLoss;
use crate::splat::render::raster_forward::TilePixels;
use crate::splat::simd::{Kernel, Simd, dispatch};

const C1: f32 = 1e-4;
const C2: f32 = 9e-4;
/// Half the window.
const REACH: usize = 5;
/// Rows of zeros above and below, columns left and right.
const PAD_ROWS: usize = 8;
const PAD: usize = 16;
/// Gaussian of σ 1.5 on −5..=5, normalised: the centre and the five to one side.
const WINDOW: [f32; 6] = [0.266_011_7, 0.213_005_54, 0.109_360_69, 0.036_000_773, 0.007_598_758, 0.001_028_38];

/// What lies behind the subject in one iteration. A changing background makes the loss see alpha.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Background {
    Flat([f32; 3]),
    /// Uniform noise, another at every pixel.
    Noise(u64),
}

impl Background {
    #[inline(always)]
    fn tile_row(self, y: usize, x0: usize) -> [[f32; TILE]; 3] {
        match self {
            Background::Flat(c) => c.map(|v| [v; TILE]),
            Background::Noise(seed) => {
                let mut out = [[0.0; TILE]; 3];
                for i in 0..TILE {
                    let h = hash(seed ^ ((y as u64) << 32 | (x0 + i) as u64));
                    for (c, line) in out.iter_mut().enumerate() {
                        line[i] = ((h >> (20 * c)) & 0xf_ffff) as f32 / 1_048_575.0;
                    }
                }
                out
            }
        }
    }
}

/// A target laid out for the loss: lines of red, green, blue (times alpha), alpha, and 1 where held back.
pub struct Wanted {
    pub width: usize,
    pub height: usize,
    wide: usize,
    tiles_x: usize,
    tiles_y: usize,
    lines: Vec<f32>,
    /// How much each pixel counts, lines as wide; none: 1 everywhere.
    weights: Option<Vec<f32>>,
    /// Tiles with any alpha.
    occupied: Vec<bool>,
}

impl Wanted {
    /// `color` is straight (not multiplied by alpha), both rows from the top.
    pub fn new(width: usize, height: usize, color: &[[f32; 3]], alpha: &[f32], held_back: Option<&[bool]>) -> Self {
        let (tiles_x, tiles_y) = (width.div_ceil(TILE), height.div_ceil(TILE));
        let wide = tiles_x * TILE;
        let mut lines = vec![0.0; 5 * wide * height];
        let mut occupied = vec![false; tiles_x * tiles_y];
        for y in 0..height {
            for x in 0..width {
                let i = y * width + x;
                let at = y * 5 * wide + x;
                for c in 0..3 {
                    lines[at + c * wide] = color[i][c] * alpha[i];
                }
                lines[at + 3 * wide] = alpha[i];
                lines[at + 4 * wide] = if held_back.is_some_and(|h| h[i]) { 1.0 } else { 0.0 };
                occupied[y / TILE * tiles_x + x / TILE] |= alpha[i] > 0.0;
            }
        }
        Wanted { width, height, wide, tiles_x, tiles_y, lines, weights: None, occupied }
    }

    /// The same with how much each pixel counts in the loss, rows from the top.
    pub fn weighed(mut self, weights: Option<&[f32]>) -> Self {
        self.weights = weights.map(|weights| {
            let mut lines = vec![0.0; self.wide * self.height];
            for (line, row) in lines.chunks_exact_mut(self.wide).zip(weights.chunks_exact(self.width)) {
                line[..self.width].copy_from_slice(row);
            }
            lines
        });
        self
    }

    /// The weights of row `y`.
    #[inline(always)]
    fn weights_of(&self, y: usize) -> Option<&[f32]> {
        self.weights.as_ref().map(|w| &w[y * self.wide..(y + 1) * self.wide])
    }
}

/// Buffers for pictures of one size.
pub struct Loss {
    stride: usize,
    /// Lines of x (red, green, blue) and y (the same), padded.
    pictures: Vec<f32>,
    /// Lines of ∂SSIM/∂μx, ∂SSIM/∂(x² + y²), ∂SSIM/∂(xy), three channels each, padded.
    partials: Vec<f32>,
    pub tiles: Vec<TileLoss>,
    /// Tile columns first..end of each tile row in which anything can differ.
    active: Vec<(usize, usize)>,
    /// Σ |x − y| and Σ (1 − SSIM) of each row.
    sums: Vec<[f64; 2]>,
    /// The loss's gradient with respect to the photo's exposure; 0 where it has none.
    pub exposure: Change,
}

/// What the loss is told beside both pictures.
#[derive(Clone, Copy)]
pub struct Terms<'a> {
    pub background: Background,
    /// Share of 1 − SSIM.
    pub lambda: f32,
    /// What the photo's exposure makes of the render, background and all.
    pub exposure: Option<&'a Change>,
}

impl Loss {
    pub fn new(width: usize, height: usize) -> Self {
        let (tiles_x, tiles_y) = (width.div_ceil(TILE), height.div_ceil(TILE));
        let stride = tiles_x * TILE + 2 * PAD;
        let rows = tiles_y * TILE + 2 * PAD_ROWS;
        Loss {
            stride,
            pictures: vec![0.0; 6 * stride * rows],
            partials: vec![0.0; 9 * stride * rows],
            tiles: vec![TileLoss::default(); tiles_x * tiles_y],
            active: vec![(0, 0); tiles_y],
            sums: vec![[0.0; 2]; tiles_y * TILE],
            exposure: [[0.0; 4]; 3],
        }
    }

    /// The loss, and in `tiles` its gradient with respect to what the rasteriser made. `drawn(t)`: tile t has splats.
    pub fn evaluate(
        &mut self,
        rendered: &[TilePixels],
        drawn: impl Fn(usize) -> bool,
        wanted: &Wanted,
        terms: Terms,
    ) -> f64 {
        let Terms { background, lambda, exposure } = terms;
        let (stride, tiles_x) = (self.stride, wanted.tiles_x);
        for row in 0..wanted.tiles_y {
            // An exposure changes what is empty too.
            let busy = |t: &usize| exposure.is_some() || wanted.occupied[row * tiles_x + t] || drawn(row * tiles_x + t);
            self.active[row] = match ((0..tiles_x).find(busy), (0..tiles_x).rfind(busy)) {
                (Some(first), Some(last)) => (first, last + 1),
                _ => (0, 0),
            };
        }
        let body = 6 * stride * PAD_ROWS..6 * stride * (PAD_ROWS + wanted.tiles_y * TILE);
        self.pictures[body].par_chunks_mut(6 * stride * TILE).enumerate().for_each(|(row, lines)| {
            dispatch(Compose { rendered, wanted, background, exposure, row, stride, lines });
        });

        // One row's SSIM sees 5 rows and columns around it: the active tiles of the neighbouring tile rows, one wider.
        let around: Vec<(usize, usize)> = (0..wanted.tiles_y)
            .map(|row| {
                let near = &self.active[row.saturating_sub(1)..(row + 2).min(wanted.tiles_y)];
                let spans = near.iter().filter(|s| s.0 < s.1);
                spans
                    .copied()
                    .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
                    .map_or((0, 0), |(a, b)| (a.saturating_sub(1), (b + 1).min(tiles_x)))
            })
            .collect();
        let pictures = &self.pictures;
        let body = 9 * stride * PAD_ROWS..9 * stride * (PAD_ROWS + wanted.tiles_y * TILE);
        self.partials[body].par_chunks_mut(9 * stride * TILE).zip(self.sums.par_chunks_mut(TILE)).enumerate().for_each(
            |(row, (partials, sums))| {
                let span = around[row];
                dispatch(Ssim { pictures, wanted, row, span, stride, partials, sums });
            },
        );

        let scale = 1.0 / (3 * wanted.width * wanted.height) as f32;
        let (partials, active) = (&self.partials, &self.active);
        let mut changes = vec![[[0.0f64; 4]; 3]; wanted.tiles_y];
        self.tiles.par_chunks_mut(tiles_x).zip(&mut changes).enumerate().for_each(|(row, (tiles, change))| {
            let span = active[row];
            let rates = [(1.0 - lambda) * scale, -lambda * scale];
            dispatch(Gradient { pictures, partials, wanted, background, row, span, stride, rates, tiles: &mut *tiles });
            if let Some(exposure) = exposure {
                *change = dispatch(Unexposed { rendered, wanted, background, exposure, row, tiles });
            }
        });
        let rows = |i: usize, k: usize| changes.iter().map(|c| c[i][k]).sum::<f64>() as f32;
        self.exposure = std::array::from_fn(|i| std::array::from_fn(|k| rows(i, k)));

        let sums = self.sums.iter().fold([0.0; 2], |a, b| [a[0] + b[0], a[1] + b[1]]);
        ((1.0 - lambda) as f64 * sums[0] + lambda as f64 * sums[1]) * scale as f64
    }
}

struct Compose<'a> {
    rendered: &'a [TilePixels],
    wanted: &'a Wanted,
    background: Background,
    exposure: Option<&'a Change>,
    row: usize,
    stride: usize,
    lines: &'a mut [f32],
}

impl Kernel for Compose<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let w = self.wanted;
        let one = s.splat(1.0);
        for (j, line) in self.lines.chunks_exact_mut(6 * self.stride).enumerate() {
            let y = self.row * TILE + j;
            if y >= w.height {
                break;
            }
            let target = &w.lines[y * 5 * w.wide..(y + 1) * 5 * w.wide];
            for t in 0..w.tiles_x {
                let tile = &self.rendered[self.row * w.tiles_x + t];
                let behind = self.background.tile_row(y, t * TILE);
                for at in (0..TILE).step_by(S::LANES) {
                    let x = t * TILE + at;
                    let through = s.load(&tile.transmittance[j * TILE + at..]);
                    let through = s.select(s.gt(through, s.splat(0.0)), through, s.sub(s.splat(0.0), through));
                    let open = s.sub(one, s.load(&target[3 * w.wide + x..]));
                    let held = s.gt(s.load(&target[4 * w.wide + x..]), s.splat(0.0));
                    let mut rendered = [s.splat(0.0); 3];
                    for c in 0..3 {
                        let b = s.load(&behind[c][at..]);
                        rendered[c] = s.fma(through, b, s.load(&tile.color[c][j * TILE + at..]));
                    }
                    if let Some(m) = self.exposure {
                        rendered = exposed(s, m, rendered);
                    }
                    for c in 0..3 {
                        let b = s.load(&behind[c][at..]);
                        let wanted = s.fma(open, b, s.load(&target[c * w.wide + x..]));
                        s.store(rendered[c], &mut line[c * self.stride + PAD + x..]);
                        s.store(s.select(held, rendered[c], wanted), &mut line[(3 + c) * self.stride + PAD + x..]);
                    }
                }
            }
            for c in 0..6 {
                line[c * self.stride + PAD + w.width..(c + 1) * self.stride - PAD].fill(0.0);
            }
        }
    }
}

/// The window applied along a line at `at`.
#[inline(always)]
fn along<S: Simd>(s: S, line: &[f32], at: usize) -> S::F {
    let mut sum = s.mul(s.splat(WINDOW[0]), s.load(&line[at..]));
    for (k, w) in WINDOW.iter().enumerate().skip(1) {
        sum = s.fma(s.splat(*w), s.add(s.load(&line[at - k..]), s.load(&line[at + k..])), sum);
    }
    sum
}

struct Ssim<'a> {
    pictures: &'a [f32],
    wanted: &'a Wanted,
    row: usize,
    /// Tile columns.
    span: (usize, usize),
    stride: usize,
    partials: &'a mut [f32],
    sums: &'a mut [[f64; 2]],
}

impl Kernel for Ssim<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        self.sums.fill([0.0; 2]);
        let (first, end) = (self.span.0 * TILE, self.span.1 * TILE);
        if first == end {
            return;
        }
        let (stride, step) = (self.stride, 6 * self.stride);
        let (one, two, zero) = (s.splat(1.0), s.splat(2.0), s.splat(0.0));
        let (c1, c2) = (s.splat(C1), s.splat(C2));
        // Filtered down the columns: x, y, x² + y², x·y.
        let mut column = vec![0.0f32; 4 * stride];
        for (j, partials) in self.partials.chunks_exact_mut(9 * stride).enumerate() {
            let y = self.row * TILE + j;
            if y >= self.wanted.height {
                break;
            }
            let top = (PAD_ROWS + y - REACH) * step;
            let weights = self.wanted.weights_of(y);
            let (mut l1, mut lost) = (0.0f64, 0.0f64);
            for c in 0..3 {
                // From PAD before the span to PAD after it: every tap along the row is there.
                for at in (first..end + 2 * PAD).step_by(S::LANES) {
                    let [mut mx, mut my, mut q, mut r] = [zero; 4];
                    for k in 0..2 * REACH + 1 {
                        let w = s.splat(WINDOW[k.abs_diff(REACH)]);
                        let base = top + k * step + c * stride + at;
                        let (x, y) = (s.load(&self.pictures[base..]), s.load(&self.pictures[base + 3 * stride..]));
                        mx = s.fma(w, x, mx);
                        my = s.fma(w, y, my);
                        q = s.fma(w, s.fma(x, x, s.mul(y, y)), q);
                        r = s.fma(w, s.mul(x, y), r);
                    }
                    s.store(mx, &mut column[at..]);
                    s.store(my, &mut column[stride + at..]);
                    s.store(q, &mut column[2 * stride + at..]);
                    s.store(r, &mut column[3 * stride + at..]);
                }
                let (cx, cy, cq, cr) = (&column[..], &column[stride..], &column[2 * stride..], &column[3 * stride..]);
                let here = (PAD_ROWS + y) * step + c * stride;
                let (mut row_l1, mut row_lost) = (zero, zero);
                for x in (first..end).step_by(S::LANES) {
                    let at = PAD + x;
                    let (mx, my, q, r) = (along(s, cx, at), along(s, cy, at), along(s, cq, at), along(s, cr, at));
                    let m = s.mul(mx, my);
                    let squares = s.fma(mx, mx, s.mul(my, my));
                    let a1 = s.fma(two, m, c1);
                    let a2 = s.fma(two, s.sub(r, m), c2);
                    let b1 = s.add(squares, c1);
                    let b2 = s.add(s.sub(q, squares), c2);
                    let inverse = s.div(one, s.mul(b1, b2));
                    let (i1, i2) = (s.mul(inverse, b2), s.mul(inverse, b1));
                    let ssim = s.mul(s.mul(a1, a2), inverse);
                    let d_mu = s.sub(
                        s.mul(s.mul(two, my), s.mul(s.sub(a2, a1), inverse)),
                        s.mul(s.mul(two, mx), s.mul(ssim, s.sub(i1, i2))),
                    );
                    let d_q = s.sub(zero, s.mul(ssim, i2));
                    let d_r = s.mul(s.mul(two, a1), inverse);
                    let weight = match weights {
                        Some(w) => s.load(&w[x..]),
                        None => one,
                    };
                    s.store(s.mul(weight, d_mu), &mut partials[c * stride + at..]);
                    s.store(s.mul(weight, d_q), &mut partials[(3 + c) * stride + at..]);
                    s.store(s.mul(weight, d_r), &mut partials[(6 + c) * stride + at..]);
                    let (px, py) =
                        (s.load(&self.pictures[here + at..]), s.load(&self.pictures[here + 3 * stride + at..]));
                    let d = s.sub(px, py);
                    row_l1 = s.fma(weight, s.select(s.gt(d, zero), d, s.sub(zero, d)), row_l1);
                    let loss = s.mul(weight, s.sub(one, ssim));
                    // Columns past the picture are zeros, whose SSIM is not counted.
                    if x + S::LANES <= self.wanted.width {
                        row_lost = s.add(row_lost, loss);
                    } else {
                        let mut tail = [0.0f32; 16];
                        s.store(loss, &mut tail);
                        lost += tail[..self.wanted.width.saturating_sub(x).min(S::LANES)].iter().sum::<f32>() as f64;
                    }
                }
                l1 += s.sum(row_l1) as f64;
                lost += s.sum(row_lost) as f64;
                for k in [c, 3 + c, 6 + c] {
                    partials[k * stride + PAD + self.wanted.width..(k + 1) * stride].fill(0.0);
                }
            }
            self.sums[j] = [l1, lost];
        }
    }
}

struct Gradient<'a> {
    pictures: &'a [f32],
    partials: &'a [f32],
    wanted: &'a Wanted,
    background: Background,
    row: usize,
    span: (usize, usize),
    stride: usize,
    /// Of |x − y| and of SSIM.
    rates: [f32; 2],
    tiles: &'a mut [TileLoss],
}

impl Kernel for Gradient<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let (first, end) = (self.span.0 * TILE, self.span.1 * TILE);
        let w = self.wanted;
        let stride = self.stride;
        let mut column = vec![0.0f32; 3 * stride];
        let (zero, two) = (s.splat(0.0), s.splat(2.0));
        let (absolute, similarity) = (s.splat(self.rates[0]), s.splat(self.rates[1]));
        for j in 0..TILE {
            let y = self.row * TILE + j;
            if y >= w.height {
                // Rows below the picture.
                for tile in &mut self.tiles[self.span.0..self.span.1] {
                    let rest = j * TILE..;
                    tile.transmittance[rest.clone()].fill(0.0);
                    tile.color.iter_mut().for_each(|c| c[rest.clone()].fill(0.0));
                }
                break;
            }
            for t in self.span.0..self.span.1 {
                self.tiles[t].transmittance[j * TILE..(j + 1) * TILE].fill(0.0);
            }
            let top = (PAD_ROWS + y - REACH) * 9 * stride;
            for c in 0..3 {
                for at in (first..end + 2 * PAD).step_by(S::LANES) {
                    let mut sum = [zero; 3];
                    for k in 0..2 * REACH + 1 {
                        let weight = s.splat(WINDOW[k.abs_diff(REACH)]);
                        let base = top + k * 9 * stride + c * stride + at;
                        for (m, sum) in sum.iter_mut().enumerate() {
                            *sum = s.fma(weight, s.load(&self.partials[base + m * 3 * stride..]), *sum);
                        }
                    }
                    for (m, sum) in sum.iter().enumerate() {
                        s.store(*sum, &mut column[m * stride + at..]);
                    }
                }
                let here = (PAD_ROWS + y) * 6 * stride + c * stride + PAD;
                let held = y * 5 * w.wide + 4 * w.wide;
                let weights = w.weights_of(y);
                for t in self.span.0..self.span.1 {
                    let behind = self.background.tile_row(y, t * TILE)[c];
                    let tile = &mut self.tiles[t];
                    for lane in (0..TILE).step_by(S::LANES) {
                        let x = t * TILE + lane;
                        // No closure: one that is not inlined would lose the instruction set.
                        let d_mu = along(s, &column, PAD + x);
                        let d_q = along(s, &column[stride..], PAD + x);
                        let d_r = along(s, &column[2 * stride..], PAD + x);
                        let px = s.load(&self.pictures[here + x..]);
                        let py = s.load(&self.pictures[here + 3 * stride + x..]);
                        let ssim = s.fma(py, d_r, s.fma(s.mul(two, px), d_q, d_mu));
                        let sign =
                            s.select(s.gt(px, py), absolute, s.select(s.gt(py, px), s.sub(zero, absolute), zero));
                        let sign = match weights {
                            Some(w) => s.mul(s.load(&w[x..]), sign),
                            None => sign,
                        };
                        let v = s.fma(similarity, ssim, sign);
                        let free = s.ge(zero, s.load(&w.lines[held + x..]));
                        let v = s.select(free, v, zero);
                        let at = j * TILE + lane;
                        s.store(v, &mut tile.color[c][at..]);
                        let sum = s.fma(v, s.load(&behind[lane..]), s.load(&tile.transmittance[at..]));
                        s.store(sum, &mut tile.transmittance[at..]);
                    }
                }
                if w.width < end {
                    // Columns right of the picture.
                    let tile = &mut self.tiles[w.tiles_x - 1];
                    let rest = j * TILE + w.width % TILE..(j + 1) * TILE;
                    tile.color[c][rest.clone()].fill(0.0);
                    tile.transmittance[rest].fill(0.0);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
