//! The whole schedule as the kernels read it: shaders/training.wgsl.

use crate::splat::render::Shown;
use crate::splat::train::Options;
use crate::splat::train::loss::Background;
use crate::splat::train::{Target, adam};

#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Step {
    pub rates: [f32; 4],
    pub more_rates: [f32; 4],
    pub background: [f32; 4],
    pub loss: [f32; 4],
    pub words: [u32; 4],
    pub more_words: [u32; 4],
    pub exposure: [f32; 4],
    pub moving: [[f32; 4]; 2],
}

pub fn halves(v: u64) -> [u32; 2] {
    [v as u32, (v >> 32) as u32]
}

/// One step an iteration, until no target has a turn.
pub fn steps(targets: &[Target], options: &Options) -> Vec<Step> {
    let mut turns = options.turns(targets);
    (0..options.iterations)
        .map_while(|iteration| {
            let turn = turns.next()?;
            let (target, r) = (&targets[turn], options.rates_at(iteration));
            let pose = if target.refine_pose.is_some() && iteration >= options.pose_from { r.pose } else { 0.0 };
            let exposure = if target.fit_exposure { [r.exposure, options.exposure_hold] } else { [0.0; 2] };
            let (background, seed) = match options.behind(target, iteration) {
                Background::Flat([r, g, b]) => ([r, g, b, 0.0], [0, 0]),
                Background::Noise(seed) => ([0.0, 0.0, 0.0, 1.0], halves(seed)),
            };
            let share = 1.0 / (3 * target.camera.width * target.camera.height) as f32;
            let lambda = options.lambda_dssim;
            let (noise, noise_seed) = options.noise(iteration);
            let [low, high] = halves(noise_seed);
            Some(Step {
                rates: [r.position, r.opacity, r.rotation, r.scale],
                more_rates: [r.color, r.harmonics, pose, noise],
                background,
                loss: [(1.0 - lambda) * share, -lambda * share, options.regulariser(), options.regulariser()],
                words: [seed[0], seed[1], turn as u32, options.degree(iteration) as u32],
                more_words: [
                    low,
                    high,
                    u32::from(target.shown == Shown::Normals),
                    u32::from(target.confidence.is_some()),
                ],
                exposure: [exposure[0], exposure[1], target.refine_pose.unwrap_or_default(), 0.0],
                moving: options.moving.words(),
            })
        })
        .collect()
}

/// c₁ and c₂ of Adam by the step, up to the last.
pub fn corrections(iterations: usize) -> Vec<[f32; 2]> {
    (0..=iterations as u32).map(|s| adam::corrections(s.max(1))).collect()
}
