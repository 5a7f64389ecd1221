//! Front-to-back compositing of one tile, a row of lanes at a time (Kerbl et al. 2023, Eq. 3).

use super::binning::{Splat, TILE};
use super::projection::{MAX_ALPHA, MIN_ALPHA, MIN_TRANSMITTANCE};
use crate::splat::simd::{Kernel, Simd};

pub const PIXELS: usize = TILE * TILE;
/// After this many splats a tile looks whether all its pixels are finished.
const CHECK: usize = 16;

/// The transmittance at which half the light is stopped.
pub const MEDIAN: f32 = 0.5;

/// Where along a ray the surface is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceDepth {
    /// The transmittance at whose passing the ray meets it: ½, or more, for what stops less than half the light.
    pub passing: f32,
    /// Where the transmittance passes ½ no more than this further away, the surface is there: scene units along the camera's axis.
    pub settling: f32,
}

impl SurfaceDepth {
    /// The median depth.
    pub const MEDIAN: SurfaceDepth = SurfaceDepth { passing: MEDIAN, settling: 0.0 };
}

/// One tile's pixels, row by row.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct TilePixels {
    /// Transmittance left; negative once the pixel was finished early.
    pub transmittance: [f32; PIXELS],
    /// Σ w·rgb, without the background.
    pub color: [[f32; PIXELS]; 3],
    /// How much of the tile's list was looked at.
    pub used: usize,
}

impl Default for TilePixels {
    fn default() -> Self {
        TilePixels { transmittance: [1.0; PIXELS], color: [[0.0; PIXELS]; 3], used: 0 }
    }
}

/// Σ w·z and the depth of the [`SurfaceDepth`] that [`Forward`] is told.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct TileDepth {
    pub expected: [f32; PIXELS],
    pub surface: [f32; PIXELS],
}

impl Default for TileDepth {
    fn default() -> Self {
        TileDepth { expected: [0.0; PIXELS], surface: [0.0; PIXELS] }
    }
}

/// log₂ of the faintest alpha that is drawn.
pub fn threshold() -> f32 {
    MIN_ALPHA.log2()
}

/// The rows of the tile, `y0` the top one's pixel index, whose centres lie within `s.half[1]` of the splat.
#[inline(always)]
pub fn row_range(s: &Splat, y0: f32) -> (usize, usize) {
    let first = (s.y - s.half[1] - 0.51 - y0).ceil().max(0.0);
    let end = (s.y + s.half[1] + 0.51 - y0).floor().min(TILE as f32);
    (first as usize, end.max(0.0) as usize)
}

/// Whether the splat reaches the pixels `x0..x0 + width`.
#[inline(always)]
pub fn reaches(s: &Splat, x0: f32, width: usize) -> bool {
    s.x + s.half[0] + 0.01 >= x0 + 0.5 && s.x - s.half[0] - 0.01 <= x0 + width as f32 - 0.5
}

/// Draws `list` into the tile whose first pixel is (x0, y0).
pub struct Forward<'a> {
    pub splats: &'a [Splat],
    pub list: &'a [u32],
    pub x0: usize,
    pub y0: usize,
    pub pixels: &'a mut TilePixels,
    pub depth: Option<(&'a mut TileDepth, SurfaceDepth)>,
}

impl Kernel for Forward<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        self.pixels.transmittance.fill(1.0);
        self.pixels.color.iter_mut().for_each(|c| c.fill(0.0));
        match self.depth {
            None => {
                let none = (&mut TileDepth::default(), SurfaceDepth::MEDIAN);
                draw::<S, false>(s, self.splats, self.list, (self.x0, self.y0), self.pixels, none)
            }
            Some((depth, surface)) => {
                depth.expected.fill(0.0);
                depth.surface.fill(0.0);
                draw::<S, true>(s, self.splats, self.list, (self.x0, self.y0), self.pixels, (depth, surface))
            }
        }
    }
}

#[inline(always)]
fn draw<S: Simd, const DEPTH: bool>(
    s: S,
    splats: &[Splat],
    list: &[u32],
    (x0, y0): (usize, usize),
    pixels: &mut TilePixels,
    (depth, surface): (&mut TileDepth, SurfaceDepth),
) {
    let mut lanes = [0.0f32; TILE];
    for (i, x) in lanes.iter_mut().enumerate() {
        *x = (x0 + i) as f32 + 0.5;
    }
    let (threshold, zero) = (s.splat(threshold()), s.splat(0.0));
    let (most, least) = (s.splat(MAX_ALPHA), s.splat(MIN_TRANSMITTANCE));
    let (passing, half, settling) = (s.splat(surface.passing), s.splat(MEDIAN), s.splat(surface.settling));
    let TilePixels { transmittance, color: [red, green, blue], used } = pixels;
    *used = list.len();
    for (i, rank) in list.iter().enumerate() {
        if i % CHECK == 0 && i > 0 && finished(s, transmittance) {
            *used = i;
            break;
        }
        let g = &splats[*rank as usize];
        let (first, end) = row_range(g, y0 as f32);
        let (r, gr, b, z) = (s.splat(g.color[0]), s.splat(g.color[1]), s.splat(g.color[2]), s.splat(g.depth));
        for group in 0..TILE / S::LANES {
            let column = group * S::LANES;
            if S::LANES < TILE && !reaches(g, (x0 + column) as f32, S::LANES) {
                continue;
            }
            let dx = s.sub(s.load(&lanes[column..]), s.splat(g.x));
            let bx = s.mul(s.splat(g.b), dx);
            let ax = s.fma(s.mul(s.splat(g.a), dx), dx, s.splat(g.level));
            for row in first..end {
                // The mask changes nothing; it shows the compiler that no index can be out of bounds.
                let at = (row * TILE + column) & (PIXELS - S::LANES);
                let dy = (y0 + row) as f32 + 0.5 - g.y;
                let exponent = s.fma(s.splat(dy), s.fma(s.splat(g.c), s.splat(dy), bx), ax);
                let t = s.load(&transmittance[at..]);
                let hit = s.and(s.ge(exponent, threshold), s.gt(t, zero));
                if !s.any(hit) {
                    continue;
                }
                let alpha = s.min(s.exp2(exponent), most);
                let w = s.mul(alpha, t);
                let next = s.sub(t, w);
                let go = s.and(hit, s.gt(next, least));
                let w = s.select(go, w, zero);
                s.store(s.select(go, next, s.select(hit, s.sub(zero, t), t)), &mut transmittance[at..]);
                s.store(s.fma(w, r, s.load(&red[at..])), &mut red[at..]);
                s.store(s.fma(w, gr, s.load(&green[at..])), &mut green[at..]);
                s.store(s.fma(w, b, s.load(&blue[at..])), &mut blue[at..]);
                if DEPTH {
                    s.store(s.fma(w, z, s.load(&depth.expected[at..])), &mut depth.expected[at..]);
                    let passes = |least| s.and(s.and(go, s.gt(t, least)), s.ge(least, next));
                    let met = s.select(passes(passing), z, s.load(&depth.surface[at..]));
                    let settled = s.and(passes(half), s.ge(s.add(met, settling), z));
                    s.store(s.select(settled, z, met), &mut depth.surface[at..]);
                }
            }
        }
    }
}

#[inline(always)]
pub fn finished<S: Simd>(s: S, transmittance: &[f32; PIXELS]) -> bool {
    let zero = s.splat(0.0);
    for at in (0..PIXELS).step_by(S::LANES) {
        if s.any(s.gt(s.load(&transmittance[at..]), zero)) {
            return false;
        }
    }
    true
}
