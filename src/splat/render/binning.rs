//! Which splats touch which tile, front to back: radix sort by depth, then a counting sort into tiles with the exact
//! test of an ellipse against a row of tiles.

use std::ops::Range;

use rayon::prelude::*;

use super::projection::{Geometry, NEAR, Shown, View, color};
use crate::splat::packed::Packed;
use crate::splat::simd::{Kernel, Simd, dispatch};

/// Pixels along a tile's side.
pub const TILE: usize = 16;
/// Gaussians a parallel job; fixed, so that no result depends on the number of threads.
const CHUNK: usize = 512;
const CULLED: u32 = u32::MAX;
/// Intersections that are listed at a time: 8 bytes each, 1 GiB in all; 36 more each on the way back, 4.5 GiB. A picture of more
/// is drawn in bands of tiles.
const MOST_PAIRS: u64 = 1 << 27;

/// One splat as the rasteriser reads it: log₂ α = a dx² + b dx dy + c dy² + level.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub struct Splat {
    pub x: f32,
    pub y: f32,
    pub a: f32,
    pub b: f32,
    pub c: f32,
    pub level: f32,
    pub color: [f32; 3],
    pub depth: f32,
    /// Half the size of the box around the ellipse α = 1/255.
    pub half: [f32; 2],
}

/// Tiles `first..end` of tile row `row` are touched by the splat of depth rank `rank`.
#[derive(Clone, Copy)]
struct Span {
    rank: u32,
    row: u16,
    first: u16,
    end: u16,
}

/// Splats in depth order and the list of each tile. Buffers are kept from call to call.
#[derive(Default)]
pub struct Bins {
    pub tiles_x: usize,
    pub tiles_y: usize,
    /// By depth rank.
    pub splats: Vec<Splat>,
    /// Depth rank of each Gaussian, `None` coded as `u32::MAX`.
    ranks: Vec<u32>,
    /// Gaussian of each rank.
    order: Vec<(u32, u32)>,
    scratch: Vec<(u32, u32)>,
    projected: Vec<(Splat, Bounds)>,
    spans: Vec<Vec<Span>>,
    /// Splats that touch each tile.
    counts: Vec<u32>,
    /// Tiles whose intersections are listed together: all of them, or as many as the limit allows; at least one.
    bands: Vec<Range<usize>>,
    /// Intersections of rank r are numbered `slots[r]..slots[r + 1]`.
    slots: Vec<u32>,
    /// Where in `list` each intersection stands.
    places: Vec<u32>,
    /// Of the tiles of the band that is listed; of no others. Tile t's splats are `list[starts[t]..starts[t + 1]]`, ranks ascending.
    pub starts: Vec<u32>,
    pub list: Vec<u32>,
}

/// What the tile test needs beyond the splat.
#[derive(Clone, Copy, Default)]
struct Bounds {
    conic: [f32; 3],
    covariance: [f32; 2],
    inverse_determinant: f32,
    level: f32,
}

struct Project<'a> {
    gaussians: &'a Packed,
    view: &'a View,
    degree: usize,
    start: usize,
    out: &'a mut [(Splat, Bounds)],
    ranks: &'a mut [u32],
}

impl Kernel for Project<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        const LOG2_E: f32 = std::f32::consts::LOG2_E;
        for (i, (out, rank)) in self.out.iter_mut().zip(self.ranks).enumerate() {
            let core = &self.gaussians.core[self.start + i];
            *rank = CULLED;
            let Some(g) = Geometry::new(core, self.view) else { continue };
            let (half, level) = g.extent();
            let (x, y) = (g.mean[0], g.mean[1]);
            let seen = x + half[0] > 0.0
                && x - half[0] < self.view.width as f32
                && y + half[1] > 0.0
                && y - half[1] < self.view.height as f32;
            if !seen {
                continue;
            }
            let (rgb, ..) = color(core, &self.gaussians.sh[self.start + i], self.view, self.degree);
            if !(rgb[0] + rgb[1] + rgb[2]).is_finite() {
                continue;
            }
            let tint = match self.view.shown {
                Shown::Color => rgb.map(|v| v.max(0.0)),
                Shown::Normals => g.normal(core, self.view).0,
            };
            *rank = g.depth().to_bits();
            let [a, b, c] = g.conic;
            *out = (
                Splat {
                    x,
                    y,
                    a: -0.5 * LOG2_E * a,
                    b: -LOG2_E * b,
                    c: -0.5 * LOG2_E * c,
                    level: g.opacity.log2(),
                    color: tint,
                    depth: g.depth(),
                    half,
                },
                Bounds {
                    conic: g.conic,
                    covariance: [g.covariance[0], g.covariance[1]],
                    inverse_determinant: a / g.covariance[2],
                    level,
                },
            );
        }
    }
}

struct Gather<'a> {
    projected: &'a [(Splat, Bounds)],
    tiles: (usize, usize),
    start: usize,
    splats: &'a mut [Splat],
    order: &'a [(u32, u32)],
    spans: &'a mut Vec<Span>,
}

impl Kernel for Gather<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        self.spans.clear();
        for (i, (splat, o)) in self.splats.iter_mut().zip(self.order).enumerate() {
            let (s, bounds) = &self.projected[o.1 as usize];
            *splat = *s;
            rows(s, bounds, self.tiles, (self.start + i) as u32, self.spans);
        }
    }
}

impl Bins {
    /// Projects, sorts and bins. Harmonics above `degree` count as 0.
    pub fn build(&mut self, gaussians: &Packed, view: &View, degree: usize) {
        self.build_within(gaussians, view, degree, MOST_PAIRS);
    }

    /// The same, with at most `most` intersections listed at a time, or those of one tile.
    pub fn build_within(&mut self, gaussians: &Packed, view: &View, degree: usize, most: u64) {
        let n = gaussians.len();
        self.tiles_x = view.width.div_ceil(TILE);
        self.tiles_y = view.height.div_ceil(TILE);
        self.projected.resize(n, Default::default());
        self.ranks.resize(n, CULLED);
        self.projected
            .par_chunks_mut(CHUNK)
            .zip(self.ranks.par_chunks_mut(CHUNK))
            .enumerate()
            .for_each(|(c, (out, ranks))| dispatch(Project { gaussians, view, degree, start: c * CHUNK, out, ranks }));
        self.sort();
        self.gather();
        self.count(most);
        if self.bands.len() == 1 {
            self.place(0);
        }
    }

    /// Into how many bands the picture is cut. Those of several are listed by [`Bins::place`] when they are wanted.
    pub fn bands(&self) -> usize {
        self.bands.len()
    }

    /// The tiles of a band.
    pub fn band(&self, band: usize) -> Range<usize> {
        self.bands[band].clone()
    }

    /// Stable radix sort by depth; `ranks` holds the depth's bits on the way in, ranks on the way out.
    fn sort(&mut self) {
        // Bits of a positive float order as the float does. Above NEAR, so the sign and the low exponents are known.
        let base = NEAR.to_bits();
        self.order.clear();
        let depths = self.ranks.iter().enumerate().filter(|(_, d)| **d != CULLED);
        self.order.extend(depths.map(|(i, d)| (d.wrapping_sub(base), i as u32)));
        let largest = self.order.iter().map(|o| o.0).max().unwrap_or(0);
        self.scratch.resize(self.order.len(), (0, 0));
        let mut shift = 0;
        while shift < 32 && largest >> shift != 0 {
            let mut counts = [0u32; 2048];
            for o in &self.order {
                counts[(o.0 >> shift) as usize & 2047] += 1;
            }
            let mut sum = 0;
            for c in &mut counts {
                sum += std::mem::replace(c, sum);
            }
            for o in &self.order {
                let c = &mut counts[(o.0 >> shift) as usize & 2047];
                self.scratch[*c as usize] = *o;
                *c += 1;
            }
            std::mem::swap(&mut self.order, &mut self.scratch);
            shift += 11;
        }
        for (rank, o) in self.order.iter().enumerate() {
            self.ranks[o.1 as usize] = rank as u32;
        }
    }

    /// Splats in depth order, and the tiles that each one touches.
    fn gather(&mut self) {
        let n = self.order.len();
        self.splats.resize(n, Splat::default());
        let chunks = n.div_ceil(CHUNK);
        if self.spans.len() < chunks {
            self.spans.resize_with(chunks, Vec::new);
        }
        for spans in &mut self.spans[chunks..] {
            spans.clear();
        }
        let (projected, tiles) = (&self.projected, (self.tiles_x, self.tiles_y));
        self.splats
            .par_chunks_mut(CHUNK)
            .zip(self.order.par_chunks(CHUNK))
            .zip(self.spans.par_iter_mut())
            .enumerate()
            .for_each(|(chunk, ((splats, order), spans))| {
                dispatch(Gather { projected, tiles, start: chunk * CHUNK, splats, order, spans });
            });
    }

    /// Counts what touches each tile, and cuts the picture into bands.
    fn count(&mut self, most: u64) {
        let tiles = self.tiles_x * self.tiles_y;
        self.counts.clear();
        self.counts.resize(tiles, 0);
        for s in self.spans.iter().flatten() {
            let row = s.row as usize * self.tiles_x;
            for t in s.first as usize..s.end as usize {
                self.counts[row + t] += 1;
            }
        }
        self.bands.clear();
        let (mut first, mut pairs) = (0, 0);
        for (t, count) in self.counts.iter().enumerate() {
            // Whoever has nothing fits in.
            if *count > 0 && t > first && pairs + u64::from(*count) > most {
                self.bands.push(first..t);
                (first, pairs) = (t, 0);
            }
            pairs += u64::from(*count);
        }
        self.bands.push(first..tiles);
    }

    /// `starts` of the lists of a band; those of tiles without any elsewhere.
    fn begin(&mut self, listed: impl Fn(usize, u32) -> u32) {
        self.starts.clear();
        self.starts.push(0);
        let mut sum = 0;
        for (t, count) in self.counts.iter().enumerate() {
            sum += listed(t, *count);
            self.starts.push(sum);
        }
    }

    /// Leaves in `starts` only which tiles anything touches: the lists of several bands are not there together.
    pub fn mark(&mut self) {
        self.begin(|_, count| count.min(1));
    }

    /// Counting sort of a band's intersections into tiles; ranks ascend in each because they are met in order.
    pub fn place(&mut self, band: usize) {
        let tiles = self.tiles_x * self.tiles_y;
        let band = self.band(band);
        self.begin(|t, count| if band.contains(&t) { count } else { 0 });
        let total = self.starts[tiles] as usize;
        self.list.resize(total, 0);
        self.places.resize(total, 0);
        self.slots.clear();
        // Cursors run in `starts` itself, one entry up: afterwards starts[t] is again where tile t begins.
        let mut k = 0;
        for s in self.spans.iter().flatten() {
            while self.slots.len() <= s.rank as usize {
                self.slots.push(k as u32);
            }
            let row = s.row as usize * self.tiles_x;
            for t in (row + s.first as usize).max(band.start)..(row + s.end as usize).min(band.end) {
                let place = self.starts[t];
                self.starts[t] += 1;
                self.list[place as usize] = s.rank;
                self.places[k] = place;
                k += 1;
            }
        }
        while self.slots.len() <= self.splats.len() {
            self.slots.push(k as u32);
        }
        self.starts.copy_within(0..tiles, 1);
        self.starts[0] = 0;
    }

    /// Depth rank of one Gaussian, if it is drawn.
    #[inline]
    pub fn rank_of(&self, gaussian: usize) -> Option<usize> {
        Some(self.ranks[gaussian]).filter(|r| *r != CULLED).map(|r| r as usize)
    }

    /// The places in `list` of the intersections of a depth rank, in a fixed order.
    #[inline]
    pub fn places_of(&self, rank: usize) -> &[u32] {
        &self.places[self.slots[rank] as usize..self.slots[rank + 1] as usize]
    }
}

/// For every tile row that the ellipse reaches, the tiles whose pixel centres it can hold.
#[inline(always)]
fn rows(s: &Splat, b: &Bounds, (tiles_x, tiles_y): (usize, usize), rank: u32, out: &mut Vec<Span>) {
    const T: f32 = TILE as f32;
    // Rounding must not lose a pixel that the exact ellipse holds.
    let slack = 0.01 + 1e-5 * (s.half[0] + s.half[1]);
    let (half_w, half_h) = (s.half[0] + slack, s.half[1] + slack);
    // Pixel centres stand at i + 0.5.
    let tile = |v: f32, limit: usize| (v / T).floor().clamp(0.0, limit as f32) as usize;
    let row_first = tile((s.y - half_h - 0.5).ceil(), tiles_y);
    let row_end = tile(s.y + half_h - 0.5 + T, tiles_y);
    // The ellipse's rightmost point lies this far below its centre, the leftmost as far above.
    let lean = b.covariance[1] / b.covariance[0] * s.half[0];
    let reach = |dy: f32| (b.conic[0] * b.level - dy * dy * b.inverse_determinant).max(0.0).sqrt();
    for row in row_first..row_end {
        let top = (row * TILE) as f32 + 0.5 - s.y;
        let (top, bottom) = (top.max(-s.half[1]), (top + T - 1.0).min(s.half[1]));
        let (mut left, mut right) = (-half_w, half_w);
        if top <= bottom {
            let at = lean.clamp(top, bottom);
            right = right.min((-b.conic[1] * at + reach(at)) / b.conic[0] + slack);
            let at = (-lean).clamp(top, bottom);
            left = left.max((-b.conic[1] * at - reach(at)) / b.conic[0] - slack);
        }
        let first = tile((s.x + left - 0.5).ceil(), tiles_x);
        let end = tile(s.x + right - 0.5 + T, tiles_x);
        if first < end {
            out.push(Span { rank, row: row as u16, first: first as u16, end: end as u16 });
        }
    }
}
