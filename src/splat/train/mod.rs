//! Fits Gaussians to pictures: Kerbl et al. 2023, §5, on the CPU.

mod adam;
mod density;
mod loss;
mod pose;
mod quality;
pub(crate) mod random;
mod schedule;
#[cfg(test)]
mod tests;
mod update;

use std::time::Instant;

pub use quality::Quality;
pub use schedule::{Density, Options, Rates};

use super::packed::Packed;
use super::render::Raster;
use super::render::projection::View;
use super::{Camera, Gaussians};
use crate::progress::Progress;
use crate::{Error, Result};
use loss::{Loss, Wanted};

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

/// Optimises `g` on `targets`. The same input gives the same bytes whatever the number of threads, unless
/// [`Options::deadline`] ends the run.
///
/// # Errors
/// A target whose buffers do not fit its camera; nothing to train; the user's interrupt.
pub fn train(g: Gaussians, targets: &[Target], options: &Options, progress: &dyn Progress) -> Result<Trained> {
    check(&g, targets)?;
    let mut gaussians = Packed::pack(&g);
    drop(g);
    let mut cameras: Vec<Camera> = targets.iter().map(|t| t.camera).collect();
    let mut raster = Raster::default();
    let mut seconds = Seconds::default();
    let mut clock = Instant::now();
    let mut lap = move || {
        let now = Instant::now();
        (now - std::mem::replace(&mut clock, now)).as_secs_f64()
    };

    let wanted: Vec<Wanted> = targets
        .iter()
        .map(|t| {
            Wanted::new(t.camera.width as usize, t.camera.height as usize, &t.color, &t.alpha, t.held_back.as_deref())
        })
        .collect();
    let mut losses: Vec<((usize, usize), Loss)> = Vec::new();
    for w in &wanted {
        if losses.iter().all(|(size, _)| *size != (w.width, w.height)) {
            losses.push(((w.width, w.height), Loss::new(w.width, w.height)));
        }
    }
    let before = quality::measure(&mut raster, &gaussians, &cameras, targets);
    seconds.measure += lap();

    let mut moments = adam::Moments::new(&gaussians);
    let mut statistics = density::Statistics::new(gaussians.len());
    let mut poses = vec![pose::Pose::default(); targets.len()];
    let corrections: Vec<[f32; 2]> = (0..=options.iterations as u32).map(|s| adam::corrections(s.max(1))).collect();
    let mut turns = schedule::Turns::new(targets.iter().map(|t| t.weight));
    let mut taken = vec![0; targets.len()];
    let mut random = random::Random::new(options.seed);
    let mut report = Report { gaussians_before: gaussians.len(), ..Default::default() };

    progress.begin("optimise Gaussians", options.iterations as u64);
    for iteration in 0..options.iterations {
        progress.check()?;
        if options.deadline.is_some_and(|d| Instant::now() >= d) {
            report.stopped_by_deadline = true;
            break;
        }
        let Some(turn) = turns.next() else { break };
        taken[turn] += 1;
        let (target, wanted) = (&targets[turn], &wanted[turn]);
        let Some((_, loss)) = losses.iter_mut().find(|(size, _)| *size == (wanted.width, wanted.height)) else { break };
        let view = View::new(&cameras[turn]);
        let degree = options.degree(iteration);
        lap();
        raster.bins.build(&gaussians, &view, degree);
        seconds.project += lap();
        raster.forward(&view, None);
        seconds.forward += lap();
        let starts = &raster.bins.starts;
        let drawn = |t: usize| starts[t] < starts[t + 1];
        loss.evaluate(&raster.tiles, drawn, wanted, options.background(iteration), options.lambda_dssim, 1.0);
        seconds.loss += lap();
        raster.backward(&loss.tiles);
        seconds.backward += lap();
        let rates = options.lane_rates(iteration);
        let pose_gradient =
            update::update(&raster, &view, degree, &rates, &corrections, &mut gaussians, &mut moments, &mut statistics);
        if target.refine_pose && iteration >= options.pose_from {
            let distance = cameras[turn].translation.length();
            poses[turn].step(&mut cameras[turn], pose_gradient, options.rates.pose, distance);
        }
        seconds.update += lap();
        let (done, d) = (iteration + 1, &options.density);
        if done > d.from && done < d.until && done.is_multiple_of(d.every.max(1)) {
            density::refine(&mut gaussians, &mut moments, &mut statistics, d, options.scene_extent, &mut random);
        }
        if d.reset_every > 0 && done < d.until && done.is_multiple_of(d.reset_every) {
            density::reset_opacity(&mut gaussians, &mut moments, d.prune_opacity);
        }
        seconds.density += lap();
        report.iterations = done;
        progress.step(done as u64);
    }

    lap();
    let after = quality::measure(&mut raster, &gaussians, &cameras, targets);
    seconds.measure += lap();
    report.gaussians_after = gaussians.len();
    report.seconds = seconds;
    report.targets = targets
        .iter()
        .zip(before.into_iter().zip(after))
        .zip(taken)
        .map(|((t, (before, after)), turns)| TargetReport { name: t.name.clone(), before, after, turns })
        .collect();
    Ok(Trained { gaussians: gaussians.unpack(), cameras, report })
}

/// How many iterations of [`Options::scaled`] this machine does in `seconds` on this input: tries a few and measures.
///
/// A multiple of 50 from 50 to 7,000, so that like machines agree. A run with the number found here is reproducible; one
/// that a deadline cuts off is not.
///
/// # Errors
/// As [`train`].
pub fn iterations_within(g: &Gaussians, targets: &[Target], seconds: f64, progress: &dyn Progress) -> Result<usize> {
    const TRIED: usize = 14;
    /// Iterations get dearer while the Gaussians multiply.
    const GROWTH: f64 = 1.3;
    let quiet = Muted(progress);
    let s = train(g.clone(), targets, &Options::scaled(TRIED), &quiet)?.report.seconds;
    let each = GROWTH * (s.project + s.forward + s.loss + s.backward + s.update) / TRIED as f64;
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
