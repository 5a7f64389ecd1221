//! Fits Gaussians to pictures: Kerbl et al. 2023, §5, on the CPU or on the GPU.

mod adam;
mod checkpoint;
mod cpu;
mod density;
pub mod exposure;
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

pub use checkpoint::{Checkpoint, Every, Kept, Saved};
pub use quality::Quality;
pub use schedule::{Behind, Density, Options, Rates, Region, Strategy};

use super::render::gpu::Gpu;
use super::render::{Raster, Shown};
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
    /// Whether the camera's pose is learnt: how far before it the point lies about which the pose is turned, and which is what its
    /// shifts count in. 0: it turns about the eye, shifts count in its distance from the origin.
    pub refine_pose: Option<f32>,
    /// Whether an [`exposure`] of this picture is learnt: for photos of automatic cameras.
    pub fit_exposure: bool,
    /// Pixels never trained on: in the loss the render itself, held fixed, stands there.
    pub held_back: Option<Vec<bool>>,
    /// How much each pixel counts in the loss, beside the others of all targets: finite, 0 or more, 1 in the mean. `None`: 1
    /// everywhere.
    pub confidence: Option<Vec<f32>>,
    /// What `color` is: of normals, unit vectors as [`super::render::normals`] draws them.
    pub shown: Shown,
    pub name: String,
}

/// What training gives back.
#[derive(Clone, Debug)]
pub struct Trained {
    pub gaussians: Gaussians,
    /// One a target, in order; refined where asked.
    pub cameras: Vec<Camera>,
    /// One a target, in order; [`exposure::NONE`] where none was asked for.
    pub exposures: Vec<exposure::Change>,
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

impl Seconds {
    pub(crate) fn plus(&self, b: &Seconds) -> Seconds {
        Seconds {
            setup: self.setup + b.setup,
            train: self.train + b.train,
            project: self.project + b.project,
            forward: self.forward + b.forward,
            loss: self.loss + b.loss,
            backward: self.backward + b.backward,
            update: self.update + b.update,
            density: self.density + b.density,
            measure: self.measure + b.measure,
        }
    }
}

/// Where training runs.
#[derive(Clone, Copy)]
pub enum Engine<'a> {
    Cpu,
    Gpu(&'a Gpu),
}

impl Engine<'_> {
    /// As reports name it.
    pub fn name(&self) -> String {
        match self {
            Engine::Cpu => "cpu".into(),
            Engine::Gpu(gpu) => format!("gpu {} ({})", gpu.adapter.name, gpu.adapter.backend),
        }
    }
}

/// What ended a part of a run before its time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// [`Options::deadline`].
    Deadline,
    /// The user.
    Interrupt,
}

impl Stop {
    /// Whether to stop now.
    fn wanted(options: &Options, progress: &dyn Progress) -> Option<Stop> {
        match options.deadline {
            _ if progress.cancelled() => Some(Stop::Interrupt),
            Some(end) if Instant::now() >= end => Some(Stop::Deadline),
            _ => None,
        }
    }
}

/// What [`advance`] gives back.
#[derive(Clone, Debug)]
pub struct Advanced {
    pub checkpoint: Checkpoint,
    pub stopped: Option<Stop>,
    pub seconds: Seconds,
    /// Most bytes of GPU buffers at one time; 0 on the CPU.
    pub peak_bytes: u64,
}

/// Trains from `at` up to iteration `until` of the schedule in `options`. A run that the user stops is handed back as far
/// as it came.
///
/// # Errors
/// Environment from the GPU.
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
        return Ok(Advanced { checkpoint: at, stopped: None, seconds: Seconds::default(), peak_bytes: 0 });
    }
    match engine {
        Engine::Cpu => Ok(cpu::advance(at, targets, options, until, progress)),
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
    train_kept(engine, g, targets, options, &Kept::default(), progress)
}

/// As [`train`], kept in a file and taken up from one as `kept` says: the result is the same to the byte.
///
/// # Errors
/// As [`train`]; a checkpoint of another run; a file that cannot be written.
pub fn train_kept(
    engine: Engine,
    g: Gaussians,
    targets: &[Target],
    options: &Options,
    kept: &Kept,
    progress: &dyn Progress,
) -> Result<Trained> {
    let start = Checkpoint::new(&g, targets)?;
    drop(g);
    let gaussians_before = start.gaussians.len();
    let mut raster = Raster::default();
    let clock = Instant::now();
    let before = quality::measure(&mut raster, &start, targets, options.behind);
    let mut measured = clock.elapsed();
    progress.begin("optimise Gaussians", options.iterations as u64);
    let done = in_parts(engine, start, targets, options, kept, progress)?;
    let end = done.checkpoint;
    let clock = Instant::now();
    let after = quality::measure(&mut raster, &end, targets, options.behind);
    measured += clock.elapsed();
    let mut turns = options.turns(targets);
    let mut taken = vec![0; targets.len()];
    for turn in (0..end.iteration).map_while(|_| turns.next()) {
        taken[turn] += 1;
    }
    let report = Report {
        iterations: end.iteration,
        stopped_by_deadline: done.stopped == Some(Stop::Deadline),
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
        device: engine.name(),
    };
    let exposures = end.exposures.iter().map(|e| e.change).collect();
    Ok(Trained { gaussians: end.gaussians.unpack(), cameras: end.cameras, exposures, report })
}

/// The whole run, a checkpoint at the end of each part.
fn in_parts(
    engine: Engine,
    start: Checkpoint,
    targets: &[Target],
    options: &Options,
    kept: &Kept,
    progress: &dyn Progress,
) -> Result<Advanced> {
    let named =
        (kept.file.is_some() || kept.from.is_some()).then(|| checkpoint::Run::new(engine, &start, targets, options));
    let at = match (&kept.from, &named) {
        (Some(saved), Some(run)) => saved.resume(run)?,
        _ => start,
    };
    let mut all = Advanced { checkpoint: at, stopped: None, seconds: Seconds::default(), peak_bytes: 0 };
    let mut last = None;
    loop {
        let from = all.checkpoint.iteration;
        let until = match &kept.file {
            Some(_) => kept.every.until(from, last),
            None => options.iterations,
        };
        let clock = Instant::now();
        let part = advance(engine, all.checkpoint, targets, options, until, progress)?;
        all.seconds = all.seconds.plus(&part.seconds);
        all.peak_bytes = all.peak_bytes.max(part.peak_bytes);
        (all.checkpoint, all.stopped) = (part.checkpoint, part.stopped);
        last = Some((all.checkpoint.iteration - from, clock.elapsed().as_secs_f64()));
        if let (Some(file), Some(run)) = (&kept.file, &named) {
            Saved::new(run, options.iterations, &all.checkpoint, &kept.beside).write(file)?;
        }
        if all.stopped == Some(Stop::Interrupt) {
            let stopped = Error::cancelled();
            return Err(match &kept.file {
                None => stopped,
                Some(file) => stopped.advice(format!(
                    "Nothing was published. --resume {} goes on from step {}.",
                    file.display(),
                    all.checkpoint.iteration
                )),
            });
        }
        // No target has a turn left, or all is done.
        if all.stopped.is_some() || all.checkpoint.iteration < until || until >= options.iterations {
            return Ok(all);
        }
    }
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
            ("weights of pixels", t.confidence.as_ref().map_or(pixels, Vec::len)),
        ] {
            if found != pixels || pixels == 0 {
                let expected = format!("{} × {} {what}", t.camera.width, t.camera.height);
                return Err(Error::usage(format!("target {}", t.name)).expected(expected).found(found.to_string()));
            }
        }
        if let Some(bad) = t.confidence.iter().flatten().find(|w| !w.is_finite() || **w < 0.0) {
            return Err(Error::usage(format!("target {}", t.name))
                .expected("weights of pixels of 0 or more")
                .found(bad.to_string()));
        }
    }
    Ok(())
}
