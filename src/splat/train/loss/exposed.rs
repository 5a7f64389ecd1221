//! The loss under a photo's exposure, and the way back through it.

use super::{Background, Wanted};
use crate::splat::render::binning::TILE;
use crate::splat::render::raster_backward::TileLoss;
use crate::splat::render::raster_forward::TilePixels;
use crate::splat::simd::{Kernel, Simd};
use crate::splat::train::exposure::Change;

/// Lanes of colours under a map.
#[inline(always)]
pub fn exposed<S: Simd>(s: S, m: &Change, x: [S::F; 3]) -> [S::F; 3] {
    let mut out = [s.splat(0.0); 3];
    for (out, row) in out.iter_mut().zip(m) {
        *out = s.splat(row[3]);
        for k in 0..3 {
            *out = s.fma(s.splat(row[k]), x[k], *out);
        }
    }
    out
}

/// The way back of an exposure over a row of tiles: v = ∂L/∂x' becomes Mᵀv in place; Σ v xᵀ and Σ v come out.
pub struct Unexposed<'a> {
    pub rendered: &'a [TilePixels],
    pub wanted: &'a Wanted,
    pub background: Background,
    pub exposure: &'a Change,
    pub row: usize,
    pub tiles: &'a mut [TileLoss],
}

impl Kernel for Unexposed<'_> {
    type Output = [[f64; 4]; 3];
    #[inline(always)]
    fn run<S: Simd>(self, s: S) -> [[f64; 4]; 3] {
        let w = self.wanted;
        let zero = s.splat(0.0);
        let mut total = [[0.0f64; 4]; 3];
        for j in 0..TILE.min(w.height - self.row * TILE) {
            let y = self.row * TILE + j;
            let mut sums = [[zero; 4]; 3];
            for (t, tile) in self.tiles.iter_mut().enumerate() {
                let drawn = &self.rendered[self.row * w.tiles_x + t];
                let behind = self.background.tile_row(y, t * TILE);
                for lane in (0..TILE).step_by(S::LANES) {
                    let at = j * TILE + lane;
                    let through = s.load(&drawn.transmittance[at..]);
                    let through = s.select(s.gt(through, zero), through, s.sub(zero, through));
                    let (mut x, mut v) = ([zero; 3], [zero; 3]);
                    for c in 0..3 {
                        x[c] = s.fma(through, s.load(&behind[c][lane..]), s.load(&drawn.color[c][at..]));
                        v[c] = s.load(&tile.color[c][at..]);
                    }
                    for i in 0..3 {
                        for k in 0..3 {
                            sums[i][k] = s.fma(v[i], x[k], sums[i][k]);
                        }
                        sums[i][3] = s.add(sums[i][3], v[i]);
                    }
                    let mut of_transmittance = zero;
                    for (k, behind) in behind.iter().enumerate() {
                        let mut pull = zero;
                        for (row, v) in self.exposure.iter().zip(v) {
                            pull = s.fma(s.splat(row[k]), v, pull);
                        }
                        s.store(pull, &mut tile.color[k][at..]);
                        of_transmittance = s.fma(pull, s.load(&behind[lane..]), of_transmittance);
                    }
                    s.store(of_transmittance, &mut tile.transmittance[at..]);
                }
            }
            for i in 0..3 {
                for k in 0..4 {
                    total[i][k] += s.sum(sums[i][k]) as f64;
                }
            }
        }
        total
    }
}
