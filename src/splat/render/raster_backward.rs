//! Gradients of one tile: the same walk as forward, front to back.
//!
//! With v = ∂L/∂colour and v_T = ∂L/∂T of the final transmittance at a pixel, the light still to come from behind,
//! S_i = Σ_{j>i} w_j (c_j·v) + T_final·v_T, needs one number a pixel: it starts as C·v + T_final·v_T and loses
//! w_i (c_i·v) at each splat, and ∂L/∂α_i = T_i (c_i·v) − S_i / (1 − α_i).

use super::binning::{Splat, TILE};
use super::projection::{MAX_ALPHA, MIN_TRANSMITTANCE, SplatGradient};
use super::raster_forward::{PIXELS, TilePixels, reaches, row_range, threshold};
use crate::splat::simd::{Kernel, Simd};

/// What the loss says about one tile.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct TileLoss {
    /// ∂L/∂(Σ w·rgb)
    pub color: [[f32; PIXELS]; 3],
    /// ∂L/∂(final transmittance)
    pub transmittance: [f32; PIXELS],
}

impl Default for TileLoss {
    fn default() -> Self {
        TileLoss { color: [[0.0; PIXELS]; 3], transmittance: [0.0; PIXELS] }
    }
}

/// One entry of `out` for each of `list`: the sum over this tile's pixels.
pub struct Backward<'a> {
    pub splats: &'a [Splat],
    pub list: &'a [u32],
    pub x0: usize,
    pub y0: usize,
    pub pixels: &'a TilePixels,
    pub loss: &'a TileLoss,
    pub out: &'a mut [SplatGradient],
}

#[repr(C, align(64))]
struct Aligned([f32; PIXELS]);

impl Kernel for Backward<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let (used, unused) = self.out.split_at_mut(self.pixels.used);
        unused.fill(SplatGradient::default());
        let (x0, y0) = (self.x0, self.y0);
        let mut lanes = [0.0f32; TILE];
        for (i, x) in lanes.iter_mut().enumerate() {
            *x = (x0 + i) as f32 + 0.5;
        }
        let mut transmittance = Aligned([1.0; PIXELS]);
        let mut behind = Aligned([0.0; PIXELS]);
        let (transmittance, behind) = (&mut transmittance.0, &mut behind.0);
        let [vr, vg, vb] = &self.loss.color;
        let [cr, cg, cb] = &self.pixels.color;
        for at in (0..PIXELS).step_by(S::LANES) {
            let t = s.load(&self.pixels.transmittance[at..]);
            let t = s.select(s.gt(t, s.splat(0.0)), t, s.sub(s.splat(0.0), t));
            let mut sum = s.mul(t, s.load(&self.loss.transmittance[at..]));
            for (c, v) in [(cr, vr), (cg, vg), (cb, vb)] {
                sum = s.fma(s.load(&c[at..]), s.load(&v[at..]), sum);
            }
            s.store(sum, &mut behind[at..]);
        }
        let (threshold, zero, one) = (s.splat(threshold()), s.splat(0.0), s.splat(1.0));
        let (most, least) = (s.splat(MAX_ALPHA), s.splat(MIN_TRANSMITTANCE));
        for (rank, out) in self.list.iter().zip(used) {
            let g = &self.splats[*rank as usize];
            let (first, end) = row_range(g, y0 as f32);
            let (r, gr, b) = (s.splat(g.color[0]), s.splat(g.color[1]), s.splat(g.color[2]));
            let mut touched = false;
            let [mut sr, mut sg, mut sb] = [zero; 3];
            let [mut s0, mut sx, mut sy, mut sxx, mut sxy, mut syy] = [zero; 6];
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
                    let dy = s.splat(dy);
                    let exponent = s.fma(dy, s.fma(s.splat(g.c), dy, bx), ax);
                    let t = s.load(&transmittance[at..]);
                    let hit = s.and(s.ge(exponent, threshold), s.gt(t, zero));
                    if !s.any(hit) {
                        continue;
                    }
                    touched = true;
                    let raw = s.exp2(exponent);
                    let alpha = s.min(raw, most);
                    let w = s.mul(alpha, t);
                    let next = s.sub(t, w);
                    let go = s.and(hit, s.gt(next, least));
                    let w = s.select(go, w, zero);
                    s.store(s.select(go, next, s.select(hit, s.sub(zero, t), t)), &mut transmittance[at..]);
                    let (pr, pg, pb) = (s.load(&vr[at..]), s.load(&vg[at..]), s.load(&vb[at..]));
                    sr = s.fma(w, pr, sr);
                    sg = s.fma(w, pg, sg);
                    sb = s.fma(w, pb, sb);
                    let cv = s.fma(b, pb, s.fma(gr, pg, s.mul(r, pr)));
                    let rest = s.fnma(cv, w, s.load(&behind[at..]));
                    s.store(rest, &mut behind[at..]);
                    // A saturated alpha no longer depends on shape or opacity.
                    let d_alpha = s.fnma(rest, s.reciprocal(s.sub(one, alpha)), s.mul(t, cv));
                    let d = s.select(s.and(go, s.ge(most, raw)), s.mul(d_alpha, alpha), zero);
                    let d_x = s.mul(d, dx);
                    let d_y = s.mul(d, dy);
                    s0 = s.add(s0, d);
                    sx = s.add(sx, d_x);
                    sy = s.add(sy, d_y);
                    sxx = s.fma(d_x, dx, sxx);
                    sxy = s.fma(d_x, dy, sxy);
                    syy = s.fma(d_y, dy, syy);
                }
            }
            *out = if touched {
                SplatGradient {
                    g: s.sum(s0),
                    x: s.sum(sx),
                    y: s.sum(sy),
                    xx: s.sum(sxx),
                    xy: s.sum(sxy),
                    yy: s.sum(syy),
                    color: [s.sum(sr), s.sum(sg), s.sum(sb)],
                }
            } else {
                SplatGradient::default()
            };
        }
    }
}
