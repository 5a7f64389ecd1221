//! Fits Gaussians to pictures: Kerbl et al. 2023, §5, on the CPU or on the GPU.

mod adam;
mod cpu;
mod density;
pub mod gpu;
mod loss;
mod mcmc;
mod pose;
mod quality;
pub(crate) mod random;
mod schedule;
#[cfg(test)]
mod tests;
mod update;

use std::time::Instant;

pub use quality::Quality;
pub use schedule::{Behind, Density, Options, Rates, Strategy};

use super::packed::Packed;
use super::render::Raster;
use super::render::gpu::Gpu;
use super::{Camera, Gaussians};
use crate::progress::Progress;
use crate::{Error, Result};

/// A picture to be matched.
#[derive(Clone, Debug)]
pub struct Target {
    pub camera: Camera,
    /// Straight colour (not multiplied by alpha), rows from the top, width·height of the camera.
    pub color: Vec<[f32; 3]>,
    /// The subject's mask, 0..1: outside it the picture must be empty.
    pub alpha: Vec<f32>,
    /// How often this target has its turn, relative to the others. 0: measured, never trained on.
    pub weight: f32,
    pub refine_pose: bool,
    /// Pixels never trained on: in the loss the render itself, held fixed, stands there.
    pub held_back: Option<Vec<bool>>,
    pub name: String,
}

/// What training gives back.
#[derive(Clone, Debug)]
pub struct Trained {
    pub gaussians: Gaussians,
    /// One a target, in order; refined where asked.
    pub cameras: Vec<Camera>,
    pub report: Report,
}

#[derive(Clone, Debug, Default)]
pub struct Report {
    pub iterations: usize,
    pub stopped_by_deadline: bool,
    pub gaussians_before: usize,
    pub gaussians_after: usize,
    pub targets: Vec<TargetReport>,
    pub seconds: Seconds,
    /// Most bytes of GPU buffers at one time; 0 on the CPU.
    pub peak_bytes: u64,
    /// "cpu", or "gpu" with the adapter's name.
    pub device: String,
}

#[derive(Clone, Debug)]
pub struct TargetReport {
    pub name: String,
    pub before: Quality,
    pub after: Quality,
    pub turns: usize,
}

/// Wall-clock time a phase.
#[derive(Clone, Copy, Debug, Default)]
pub struct Seconds {
    /// Upload and kernels' compilation on the GPU, layouts on the CPU.
    pub setup: f64,
    /// All iterations and density control. What follows up to `update` is known on the CPU alone.
    pub train: f64,
    /// Projection, sorting, binning.
    pub project: f64,
    pub forward: f64,
    pub loss: f64,
    pub backward: f64,
    /// Projection's gradient and Adam.
    pub update: f64,
    pub density: f64,
    /// Quality before and after.
    pub measure: f64,
}

/// Where training runs.
#[derive(Clone, Copy)]
pub enum Engine<'a> {
    Cpu,
    Gpu(&'a Gpu),
}

/// All that goes on from one iteration to the next: a run that is taken up again from one ends as if it had never
/// stopped, on the same engine.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// Iterations done.
    pub iteration: usize,
    gaussians: Packed,
    moments: adam::Moments,
    statistics: density::Statistics,
    /// One a target, in order.
    pub cameras: Vec<Camera>,
    poses: Vec<pose::Pose>,
}

impl Checkpoint {
    /// Before the first iteration.
    ///
    /// # Errors
    /// Usage: parameter arrays of different lengths; a target whose buffers do not fit its camera.
    pub fn new(g: &Gaussians, targets: &[Target]) -> Result<Checkpoint> {
        check(g, targets)?;
        let gaussians = Packed::pack(g);
        Ok(Checkpoint {
            iteration: 0,
            moments: adam::Moments::new(&gaussians),
            statistics: density::Statistics::new(gaussians.len()),
            cameras: targets.iter().map(|t| t.camera).collect(),
            poses: vec![pose::Pose::default(); targets.len()],
            gaussians,
        })
    }

    pub fn gaussians(&self) -> Gaussians {
        self.gaussians.unpack()
    }
}

/// What [`advance`] gives back.
#[derive(Clone, Debug)]
pub struct Advanced {
    pub checkpoint: Checkpoint,
    pub stopped_by_deadline: bool,
    pub seconds: Seconds,
    /// Most bytes of GPU buffers at one time; 0 on the CPU.
    pub peak_bytes: u64,
}

/// Trains from `at` up to iteration `until` of the schedule in `options`.
///
/// # Errors
/// The user's interrupt; environment from the GPU.
pub fn advance(
    engine: Engine,
    at: Checkpoint,
    targets: &[Target],
    options: &Options,
    until: usize,
    progress: &dyn Progress,
) -> Result<Advanced> {
    let until = until.min(options.iterations);
    if at.gaussians.len() == 0 {
        return Ok(Advanced { checkpoint: at, stopped_by_deadline: false, seconds: Seconds::default(), peak_bytes: 0 });
    }
    match engine {
        Engine::Cpu => cpu::advance(at, targets, options, until, progress),
        Engine::Gpu(gpu) => gpu::advance(gpu, at, targets, options, until, progress),
    }
}

/// Optimises `g` on `targets`. The same input gives the same bytes on the same engine, whatever the number of threads,
/// unless [`Options::deadline`] ends the run.
///
/// # Errors
/// A target whose buffers do not fit its camera; the user's interrupt; environment from the GPU.
pub fn train(
    engine: Engine,
    g: Gaussians,
    targets: &[Target],
    options: &Options,
    progress: &dyn Progress,
) -> Result<Trained> {
    let start = Checkpoint::new(&g, targets)?;
    drop(g);
    let gaussians_before = start.gaussians.len();
    let mut raster = Raster::default();
    let clock = Instant::now();
    let before = quality::measure(&mut raster, &start.gaussians, &start.cameras, targets, options.behind);
    let mut measured = clock.elapsed();
    progress.begin("optimise Gaussians", options.iterations as u64);
    let done = advance(engine, start, targets, options, options.iterations, progress)?;
    let end = done.checkpoint;
    let clock = Instant::now();
    let after = quality::measure(&mut raster, &end.gaussians, &end.cameras, targets, options.behind);
    measured += clock.elapsed();
    let mut turns = schedule::Turns::new(targets.iter().map(|t| t.weight));
    let mut taken = vec![0; targets.len()];
    for turn in (0..end.iteration).map_while(|_| turns.next()) {
        taken[turn] += 1;
    }
    let report = Report {
        iterations: end.iteration,
        stopped_by_deadline: done.stopped_by_deadline,
        gaussians_before,
        gaussians_after: end.gaussians.len(),
        targets: targets
            .iter()
            .zip(before.into_iter().zip(after))
            .zip(taken)
            .map(|((t, (before, after)), turns)| TargetReport { name: t.name.clone(), before, after, turns })
            .collect(),
        seconds: Seconds { measure: measured.as_secs_f64(), ..done.seconds },
        peak_bytes: done.peak_bytes,
        device: match engine {
            Engine::Cpu => "cpu".into(),
            Engine::Gpu(gpu) => format!("gpu {} ({})", gpu.adapter.name, gpu.adapter.backend),
        },
    };
    Ok(Trained { gaussians: end.gaussians.unpack(), cameras: end.cameras, report })
}

/// How many iterations of [`Options::scaled`] this machine does in `seconds` on this input: tries a few and measures.
///
/// A multiple of 50 from 50 to 7,000, so that like machines agree. A run with the number found here is reproducible; one
/// that a deadline cuts off is not.
///
/// # Errors
/// As [`train`].
pub fn iterations_within(
    engine: Engine,
    g: &Gaussians,
    targets: &[Target],
    seconds: f64,
    progress: &dyn Progress,
) -> Result<usize> {
    const TRIED: usize = 14;
    /// Iterations get dearer while the Gaussians multiply.
    const GROWTH: f64 = 1.3;
    let quiet = Muted(progress);
    let s = train(engine, g.clone(), targets, &Options::scaled(TRIED), &quiet)?.report.seconds;
    let each = GROWTH * s.train / TRIED as f64;
    Ok(((seconds / each.max(1e-6) / 50.0) as usize * 50).clamp(50, 7000))
}

/// Passes the interrupt on and shows nothing.
struct Muted<'a>(&'a dyn Progress);

impl Progress for Muted<'_> {
    fn begin(&self, _: &'static str, _: u64) {}
    fn step(&self, _: u64) {}
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}

fn check(g: &Gaussians, targets: &[Target]) -> Result<()> {
    let n = g.len();
    if [g.log_scales.len(), g.rotations.len(), g.logit_opacities.len(), g.sh.len()].iter().any(|l| *l != n) {
        return Err(Error::usage("Gaussians")
            .expected(format!("{n} of every parameter"))
            .found("arrays of other lengths"));
    }
    for t in targets {
        let pixels = t.camera.width as usize * t.camera.height as usize;
        for (what, found) in [
            ("colours", t.color.len()),
            ("alphas", t.alpha.len()),
            ("held-back flags", t.held_back.as_ref().map_or(pixels, Vec::len)),
        ] {
            if found != pixels || pixels == 0 {
                let expected = format!("{} × {} {what}", t.camera.width, t.camera.height);
                return Err(Error::usage(format!("target {}", t.name)).expected(expected).found(found.to_string()));
            }
        }
    }
    Ok(())
}
