//! What happens when: step sizes, harmonics, density control, and which target's turn it is.

use std::time::Instant;

use super::Target;
use super::adam::LaneRates;
use super::loss::Background;
use super::random::{Random, hash};
use crate::splat::render::Shown;

/// Adam's step sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates {
    /// Times the scene's extent; falls exponentially to `position_final`.
    pub position: f32,
    pub position_final: f32,
    pub opacity: f32,
    pub rotation: f32,
    pub scale: f32,
    /// Degree 0.
    pub color: f32,
    /// Degrees 1 to 3.
    pub harmonics: f32,
    /// Radians.
    pub pose: f32,
    /// The pose's falls exponentially to this share of itself.
    pub pose_share: f32,
    /// Of a photo's exposure; falls exponentially to `exposure_final`.
    pub exposure: f32,
    pub exposure_final: f32,
    /// All but the position's, the pose's and the exposure's fall exponentially to this share of themselves.
    pub final_share: f32,
}

/// How the number of Gaussians is controlled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Strategy {
    /// Clone, split, prune, reset (Kerbl et al. 2023).
    #[default]
    Paper,
    /// Move the dead, add a few, disturb the faint (Kheradmand et al. 2024): never more than the cap.
    Mcmc,
}

/// Density control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Density {
    pub strategy: Strategy,
    pub every: usize,
    pub from: usize,
    pub until: usize,
    /// Mean |∂L/∂mean| in normalised device units above which a Gaussian is cloned or split.
    pub gradient: f32,
    /// Times the scene's extent: larger ones are split, smaller ones cloned.
    pub split_scale: f32,
    pub prune_opacity: f32,
    /// At most this share of the Gaussians is cloned or split in one round, or is added by MCMC.
    pub growth: f32,
    pub max_gaussians: usize,
    /// Opacities are brought down this often; 0: never.
    pub reset_every: usize,
}

/// An upright box within a ball about the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    pub radius: f32,
    /// x and y.
    pub low: [f32; 2],
    pub high: [f32; 2],
}

impl Region {
    /// Its square is finite.
    const FAR: f32 = 1e19;
    pub const EVERYWHERE: Region = Region { radius: Self::FAR, low: [-Self::FAR; 2], high: [Self::FAR; 2] };

    #[inline(always)]
    pub fn holds(&self, p: [f32; 3]) -> bool {
        p[0] * p[0] + p[1] * p[1] + p[2] * p[2] <= self.radius * self.radius
            && (0..2).all(|k| p[k] >= self.low[k] && p[k] <= self.high[k])
    }

    /// As shaders/region.wgsl has it.
    pub(super) fn words(&self) -> [[f32; 4]; 2] {
        let [a, b] = [self.low, self.high];
        [[a[0], a[1], b[0], b[1]], [self.radius * self.radius, 0.0, 0.0, 0.0]]
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    pub iterations: usize,
    /// Share of 1 − SSIM in the loss.
    pub lambda_dssim: f32,
    pub seed: u64,
    pub rates: Rates,
    /// Size of the scene: 1.1 times the cameras' distance in gsplat.
    pub scene_extent: f32,
    /// Degree of harmonics at the start.
    pub first_degree: usize,
    /// One more degree of harmonics every so many iterations.
    pub sh_degree_every: usize,
    pub density: Density,
    /// Gaussians outside keep their number, places and shapes; their colours and opacities are learnt.
    pub moving: Region,
    /// Poses are refined from this iteration on.
    pub pose_from: usize,
    /// Weight of an exposure's squared distance from none in the loss.
    pub exposure_hold: f32,
    /// Targets with any weight have their turns in a new order each round, all alike; else in proportion to their weights.
    pub shuffled: bool,
    /// What lies behind the subject in the loss.
    pub behind: Behind,
    /// Stop here even if iterations are left. A run that this stops depends on the machine's speed.
    pub deadline: Option<Instant>,
}

impl Default for Options {
    /// The 7,000 iterations of Kerbl et al. 2023, with gsplat 1.6's step sizes.
    fn default() -> Self {
        Options {
            iterations: 7000,
            lambda_dssim: 0.2,
            seed: 0,
            rates: Rates {
                position: 1.6e-4,
                position_final: 1.6e-6,
                opacity: 5e-2,
                rotation: 1e-3,
                scale: 5e-3,
                color: 2.5e-3,
                harmonics: 2.5e-3 / 20.0,
                pose: 1e-4,
                pose_share: 1.0,
                exposure: 1e-2,
                exposure_final: 1e-3,
                final_share: 1.0,
            },
            scene_extent: 4.3,
            first_degree: 0,
            sh_degree_every: 1000,
            density: Density {
                strategy: Strategy::Paper,
                every: 100,
                from: 500,
                until: 15_000,
                gradient: 2e-4,
                split_scale: 0.01,
                prune_opacity: 0.005,
                growth: 1.0,
                max_gaussians: 1_000_000,
                reset_every: 3000,
            },
            moving: Region::EVERYWHERE,
            pose_from: 500,
            exposure_hold: 1e-2,
            shuffled: false,
            behind: Behind::Changing,
            deadline: None,
        }
    }
}

/// What lies behind the subject in the loss.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Behind {
    /// Black, white, grey and noise in turn: the loss sees alpha.
    Changing,
    /// For pictures without alpha: always this colour.
    Fixed([f32; 3]),
}

/// Step sizes of one iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RatesNow {
    pub position: f32,
    pub opacity: f32,
    pub rotation: f32,
    pub scale: f32,
    pub color: f32,
    pub harmonics: f32,
    pub pose: f32,
    pub exposure: f32,
}

impl Options {
    /// The default schedule squeezed into `iterations`, for Gaussians that are about right at the start.
    ///
    /// A short run has no time to recover from an opacity reset, so there is none; growth is capped at 32,768.
    pub fn scaled(iterations: usize) -> Self {
        let full = Options::default();
        if iterations >= full.iterations {
            return Options { iterations, ..full };
        }
        let squeeze = |at: usize| (at * iterations).div_ceil(full.iterations).max(1);
        // Fewer steps have to be longer ones, and must come to rest. The factors were found by trial on 600
        // iterations from the built-in network's Gaussians; they fade in between 7,000 and 600.
        let share = ((full.iterations as f32 / iterations.max(1) as f32).ln() / (7000f32 / 600.0).ln()).min(1.0);
        let longer = |rate: f32, factor: f32| rate * factor.powf(share);
        let r = full.rates;
        let rates = Rates {
            position: longer(r.position, 2.0),
            position_final: longer(r.position_final, 2.0),
            opacity: longer(r.opacity, 0.5),
            rotation: longer(r.rotation, 10.0),
            scale: longer(r.scale, 5.0),
            color: longer(r.color, 2.0),
            harmonics: longer(r.harmonics, 8.0),
            pose: r.pose,
            pose_share: r.pose_share,
            exposure: r.exposure,
            exposure_final: r.exposure_final,
            final_share: longer(r.final_share, 0.1),
        };
        Options {
            iterations,
            rates,
            sh_degree_every: squeeze(full.sh_degree_every),
            density: Density {
                // Each target must have had a few turns before its statistics say anything.
                every: (iterations / 20).max(20),
                from: squeeze(full.density.from).max(20),
                // What grows late has no time to settle.
                until: iterations * 3 / 5,
                // Found by trial like the step sizes: the network's splats are several photo pixels wide, and a
                // Gaussian that only the photo pulls at has a small mean over all views.
                gradient: 4e-5,
                split_scale: 0.002,
                growth: 0.5,
                max_gaussians: 32_768,
                reset_every: 0,
                ..full.density
            },
            pose_from: squeeze(full.pose_from),
            ..full
        }
    }

    /// Whose turns they are.
    pub(super) fn turns(&self, targets: &[Target]) -> Turns {
        let turns = Turns::new(targets.iter().map(|t| t.weight));
        if self.shuffled { turns.shuffled(self.seed) } else { turns }
    }

    pub(super) fn degree(&self, iteration: usize) -> usize {
        (self.first_degree + iteration / self.sh_degree_every.max(1)).min(3)
    }

    /// The same with MCMC in place of the paper's density control, with gsplat's numbers.
    pub fn with_mcmc(self) -> Self {
        let density = Density { strategy: Strategy::Mcmc, growth: 0.05, until: 25_000, reset_every: 0, ..self.density };
        Options { density, ..self }
    }

    /// MCMC's noise in one iteration: its factor and its seed. 0: none.
    pub(super) fn noise(&self, iteration: usize) -> (f32, u64) {
        match self.density.strategy {
            Strategy::Paper => (0.0, 0),
            Strategy::Mcmc => {
                let seed = hash(self.seed ^ hash(!(iteration as u64)));
                (super::mcmc::NOISE * self.rates_at(iteration).position, seed)
            }
        }
    }

    /// Weight of mean opacity and mean scale in the loss.
    pub(super) fn regulariser(&self) -> f32 {
        if self.density.strategy == Strategy::Mcmc { super::mcmc::REGULARISER } else { 0.0 }
    }

    /// Whether density control is due when so many iterations are done.
    pub(super) fn refines_after(&self, done: usize) -> bool {
        let d = &self.density;
        done > d.from && done < d.until && done.is_multiple_of(d.every.max(1))
    }

    pub(super) fn resets_after(&self, done: usize) -> bool {
        let d = &self.density;
        // What a reset takes has to be won back in the iterations that are left.
        let left = self.iterations.saturating_sub(done);
        d.reset_every > 0 && done < d.until && done.is_multiple_of(d.reset_every) && left > d.reset_every
    }

    /// The first number of iterations above `done` after which anything but iterations is due.
    pub(super) fn next_event(&self, done: usize) -> usize {
        (done + 1..self.iterations).find(|i| self.refines_after(*i) || self.resets_after(*i)).unwrap_or(self.iterations)
    }

    pub(super) fn lane_rates(&self, iteration: usize) -> LaneRates {
        let r = self.rates_at(iteration);
        LaneRates::new(r.position, r.opacity, r.rotation, r.scale, r.color, r.harmonics)
    }

    /// Of those that keep their places and shapes: opacity and mean colour. The sky is seen from nearly one direction, so that
    /// its harmonics would be learned from nothing and show themselves in photos that look elsewhere.
    pub(super) fn still_rates(&self, iteration: usize) -> LaneRates {
        let r = self.rates_at(iteration);
        LaneRates::new(0.0, r.opacity, 0.0, 0.0, r.color, 0.0)
    }

    pub(super) fn rates_at(&self, iteration: usize) -> RatesNow {
        let r = &self.rates;
        let t = iteration as f32 / self.iterations.max(1) as f32;
        let falling = |from: f32, to: f32| (from.ln() * (1.0 - t) + to.ln() * t).exp();
        let position = falling(r.position, r.position_final);
        let exposure = falling(r.exposure, r.exposure_final);
        let pose = r.pose * r.pose_share.powf(t);
        let [opacity, rotation, scale, color, harmonics] =
            [r.opacity, r.rotation, r.scale, r.color, r.harmonics].map(|rate| rate * r.final_share.powf(t));
        RatesNow { position: position * self.scene_extent, opacity, rotation, scale, color, harmonics, pose, exposure }
    }

    /// What lies behind the subject in this target's turn: nothing, where normals are shown.
    pub(super) fn behind(&self, target: &Target, iteration: usize) -> Background {
        match target.shown {
            Shown::Color => self.background(iteration),
            Shown::Normals => Background::Flat([0.0; 3]),
        }
    }

    /// Where it changes: black, white, grey and noise in turn, in an order that the seed picks.
    fn background(&self, iteration: usize) -> Background {
        if let Behind::Fixed(color) = self.behind {
            return Background::Flat(color);
        }
        let h = hash(self.seed ^ hash(iteration as u64));
        match h % 4 {
            0 => Background::Flat([0.0; 3]),
            1 => Background::Flat([1.0; 3]),
            2 => Background::Flat([0.5; 3]),
            _ => Background::Noise(h),
        }
    }
}

/// Whose turn it is: smooth weighted round robin. Each target comes up in proportion to its weight, evenly spread. Or
/// round after round, each in an order of its own.
pub struct Turns {
    weights: Vec<f32>,
    credit: Vec<f32>,
    shuffle: Option<Shuffle>,
}

struct Shuffle {
    random: Random,
    /// What is left of the round, last first.
    left: Vec<usize>,
}

impl Turns {
    pub fn new(weights: impl Iterator<Item = f32>) -> Self {
        let weights: Vec<f32> = weights.map(|w| if w.is_finite() { w.max(0.0) } else { 0.0 }).collect();
        Turns { credit: vec![0.0; weights.len()], weights, shuffle: None }
    }

    /// Every target with any weight once a round, in an order that the seed picks.
    fn shuffled(self, seed: u64) -> Self {
        Turns { shuffle: Some(Shuffle { random: Random::new(seed ^ 0x7475_726e), left: Vec::new() }), ..self }
    }

    /// None when no target has any weight.
    pub fn next(&mut self) -> Option<usize> {
        let total: f32 = self.weights.iter().sum();
        if total <= 0.0 {
            return None;
        }
        if let Some(s) = &mut self.shuffle {
            if s.left.is_empty() {
                s.left = (0..self.weights.len()).filter(|i| self.weights[*i] > 0.0).collect();
                // Fisher and Yates.
                for i in (1..s.left.len()).rev() {
                    s.left.swap(i, (s.random.next() % (i as u64 + 1)) as usize);
                }
            }
            return s.left.pop();
        }
        for (c, w) in self.credit.iter_mut().zip(&self.weights) {
            *c += w;
        }
        let mut best = None::<usize>;
        for i in 0..self.credit.len() {
            if self.weights[i] > 0.0 && best.is_none_or(|b| self.credit[i] > self.credit[b]) {
                best = Some(i);
            }
        }
        if let Some(b) = best {
            self.credit[b] -= total;
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_follow_the_weights() {
        let mut turns = Turns::new([6.0, 1.0, 1.0, 0.0].into_iter());
        let mut counts = [0; 4];
        for _ in 0..80 {
            counts[turns.next().unwrap()] += 1;
        }
        assert_eq!(counts, [60, 10, 10, 0]);
        assert_eq!(Turns::new([0.0].into_iter()).next(), None);
    }

    #[test]
    fn shuffled_rounds_have_everyone_once() {
        let round = |turns: &mut Turns| -> Vec<usize> { (0..5).map(|_| turns.next().unwrap()).collect() };
        let mut turns = Turns::new([1.0, 0.3, 0.0, 1.0, 2.0, 1.0].into_iter()).shuffled(4);
        let rounds: Vec<Vec<usize>> = (0..8).map(|_| round(&mut turns)).collect();
        for r in &rounds {
            let mut all = r.clone();
            all.sort_unstable();
            assert_eq!(all, [0, 1, 3, 4, 5]);
        }
        assert!(rounds.iter().any(|r| *r != rounds[0]));
        assert_eq!(Turns::new([0.0].into_iter()).shuffled(1).next(), None);
    }

    #[test]
    fn a_short_run_keeps_the_order_of_events() {
        for n in [10, 300, 1000, 6999] {
            let o = Options::scaled(n);
            assert!(o.sh_degree_every >= 1 && o.density.every >= 1 && o.density.reset_every == 0);
            assert_eq!(o.degree(n), 3);
            let (short, full) = (o.rates, Options::default().rates);
            assert!(short.scale > full.scale && short.final_share < 1.0);
        }
        assert_eq!(Options::scaled(7000), Options::default());
        let last = Options::default().lane_rates(7000).core[0];
        assert!((last - 1.6e-6 * 4.3).abs() < 1e-9);
    }
}
