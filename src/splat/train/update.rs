//! From intersections' gradients to moved Gaussians, in one pass: sum, differentiate the projection, step.

use rayon::prelude::*;

use super::adam::{LaneRates, Moments, step};
use super::density::Statistics;
use super::density::is_still;
use super::mcmc;
use super::random::hash;
use super::schedule::Region;
use crate::splat::packed::{Core, OPACITY, Packed, SCALE, Sh};
use crate::splat::render::Raster;
use crate::splat::render::projection::{Shown, View, backward};
use crate::splat::simd::{Kernel, Simd, dispatch};

/// Gaussians a parallel job; fixed, so that sums do not depend on the number of threads.
const CHUNK: usize = 512;

/// One iteration's numbers.
pub struct How<'a> {
    pub degree: usize,
    pub rates: LaneRates,
    /// Those of Gaussians outside `moving`.
    pub still_rates: LaneRates,
    pub moving: Region,
    /// Adam's, by the step.
    pub corrections: &'a [[f32; 2]],
    /// MCMC's: factor and seed.
    pub noise: (f32, u64),
    /// MCMC's, a Gaussian.
    pub regulariser: f32,
}

struct Chunk<'a> {
    raster: &'a Raster,
    view: &'a View,
    how: &'a How<'a>,
    start: usize,
    core: &'a mut [Core],
    sh: &'a mut [Sh],
    core_moments: &'a mut [[Core; 2]],
    sh_moments: &'a mut [[Sh; 2]],
    steps: &'a mut [u32],
    seen: &'a mut [[f32; 2]],
}

impl Kernel for Chunk<'_> {
    /// The chunk's pose gradient.
    type Output = [f32; 6];
    #[inline(always)]
    fn run<S: Simd>(self, s: S) -> [f32; 6] {
        let mut pose = [0.0f32; 6];
        let half = [self.view.width as f32 * 0.5, self.view.height as f32 * 0.5];
        for i in 0..self.core.len() {
            let Some(up) = self.raster.gradient_of(self.start + i) else { continue };
            let how = self.how;
            let Some(mut g) = backward(&self.core[i], &self.sh[i], self.view, how.degree, &up) else { continue };
            if !g.core.iter().chain(&up.color).fold(0.0, |a, b| a + b).is_finite() {
                continue;
            }
            for (sum, p) in pose.iter_mut().zip(g.pose) {
                *sum += p;
            }
            let (x, y) = (g.mean[0] * half[0], g.mean[1] * half[1]);
            self.seen[i][0] += (x * x + y * y).sqrt();
            self.seen[i][1] += 1.0;
            self.steps[i] += 1;
            let correction = how.corrections[(self.steps[i] as usize).min(how.corrections.len() - 1)];
            if how.regulariser > 0.0 {
                let o = 1.0 / (1.0 + (-self.core[i][OPACITY]).exp());
                g.core[OPACITY] += how.regulariser * o * (1.0 - o);
                for k in SCALE..SCALE + 3 {
                    g.core[k] += how.regulariser / 3.0 * self.core[i][k].exp();
                }
            }
            let still = is_still(&self.core[i], &how.moving);
            let rates = if still { &how.still_rates } else { &how.rates };
            let [m, v] = &mut self.core_moments[i];
            step(s, &mut self.core[i], (m, v), &g.core, &rates.core, correction);
            if self.view.shown == Shown::Color {
                let [m, v] = &mut self.sh_moments[i];
                step(s, &mut self.sh[i], (m, v), &g.sh, &rates.sh, correction);
            }
            if how.noise.0 > 0.0 && !still {
                mcmc::disturb(&mut self.core[i], how.noise.0, how.noise.1 ^ hash((self.start + i) as u64));
            }
        }
        pose
    }
}

/// Steps every Gaussian that the last backward pass reached; gives the gradient of the camera's pose.
pub fn update(
    raster: &Raster,
    view: &View,
    how: &How,
    gaussians: &mut Packed,
    moments: &mut Moments,
    statistics: &mut Statistics,
) -> [f32; 6] {
    let poses: Vec<[f32; 6]> = gaussians
        .core
        .par_chunks_mut(CHUNK)
        .zip(gaussians.sh.par_chunks_mut(CHUNK))
        .zip(moments.core.par_chunks_mut(CHUNK).zip(moments.sh.par_chunks_mut(CHUNK)))
        .zip(moments.steps.par_chunks_mut(CHUNK).zip(statistics.seen.par_chunks_mut(CHUNK)))
        .enumerate()
        .map(|(c, (((core, sh), (core_moments, sh_moments)), (steps, seen)))| {
            let start = c * CHUNK;
            dispatch(Chunk { raster, view, how, start, core, sh, core_moments, sh_moments, steps, seen })
        })
        .collect();
    poses.iter().fold([0.0; 6], |sum, p| std::array::from_fn(|i| sum[i] + p[i]))
}
