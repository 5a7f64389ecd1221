//! Training on the CPU.

use std::time::Instant;

use super::loss::{Loss, Terms, Wanted};
use super::{Advanced, Checkpoint, Options, Seconds, Stop, Strategy, Target};
use super::{adam, density, mcmc, random, update};
use crate::progress::Progress;
use crate::splat::render::Raster;
use crate::splat::render::projection::View;

/// Trains from `at` up to iteration `until`.
pub fn advance(
    at: Checkpoint,
    targets: &[Target],
    options: &Options,
    until: usize,
    progress: &dyn Progress,
) -> Advanced {
    let began = Instant::now();
    let Checkpoint {
        iteration: first,
        mut gaussians,
        mut moments,
        mut statistics,
        mut cameras,
        mut poses,
        mut exposures,
    } = at;
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
            let (width, height) = (t.camera.width as usize, t.camera.height as usize);
            Wanted::new(width, height, &t.color, &t.alpha, t.held_back.as_deref()).weighed(t.confidence.as_deref())
        })
        .collect();
    let mut losses: Vec<((usize, usize), Loss)> = Vec::new();
    for w in &wanted {
        if losses.iter().all(|(size, _)| *size != (w.width, w.height)) {
            losses.push(((w.width, w.height), Loss::new(w.width, w.height)));
        }
    }
    let corrections: Vec<[f32; 2]> = (0..=options.iterations as u32).map(|s| adam::corrections(s.max(1))).collect();
    let mut turns = options.turns(targets);
    for _ in 0..first {
        turns.next();
    }
    seconds.setup = began.elapsed().as_secs_f64();

    let mut stopped = None;
    let mut done = first;
    for iteration in first..until {
        stopped = Stop::wanted(options, progress);
        if stopped.is_some() {
            break;
        }
        let Some(turn) = turns.next() else { break };
        let (target, wanted) = (&targets[turn], &wanted[turn]);
        let Some((_, loss)) = losses.iter_mut().find(|(size, _)| *size == (wanted.width, wanted.height)) else { break };
        let view = View { shown: target.shown, ..View::new(&cameras[turn]) };
        let degree = options.degree(iteration);
        lap();
        raster.bins.build(&gaussians, &view, degree);
        seconds.project += lap();
        raster.forward(&view, None);
        seconds.forward += lap();
        let starts = &raster.bins.starts;
        let drawn = |t: usize| starts[t] < starts[t + 1];
        let terms = Terms {
            background: options.behind(target, iteration),
            lambda: options.lambda_dssim,
            exposure: target.fit_exposure.then_some(&exposures[turn].change),
        };
        loss.evaluate(&raster.tiles, drawn, wanted, terms);
        seconds.loss += lap();
        raster.backward(&loss.tiles);
        seconds.backward += lap();
        let how = update::How {
            degree,
            rates: options.lane_rates(iteration),
            still_rates: options.still_rates(iteration),
            moving: options.moving,
            corrections: &corrections,
            noise: options.noise(iteration),
            regulariser: options.regulariser() / gaussians.len().max(1) as f32,
        };
        let pose_gradient = update::update(&raster, &view, &how, &mut gaussians, &mut moments, &mut statistics);
        if let Some(pivot) = target.refine_pose.filter(|_| iteration >= options.pose_from) {
            poses[turn].step(&mut cameras[turn], pose_gradient, options.rates_at(iteration).pose, pivot);
        }
        if target.fit_exposure {
            let rates = options.rates_at(iteration);
            exposures[turn].step(&loss.exposure, rates.exposure, options.exposure_hold);
        }
        seconds.update += lap();
        done = iteration + 1;
        if options.refines_after(done) {
            let mut random = random::Random::new(options.seed ^ random::hash(done as u64));
            match options.density.strategy {
                Strategy::Paper => density::refine(&mut gaussians, &mut moments, &mut statistics, options, &mut random),
                Strategy::Mcmc => mcmc::relocate(&mut gaussians, &mut moments, &mut statistics, options, &mut random),
            }
        }
        if options.resets_after(done) {
            density::reset_opacity(&mut gaussians, &mut moments, options);
        }
        seconds.density += lap();
        progress.step(done as u64);
    }
    seconds.train = began.elapsed().as_secs_f64() - seconds.setup;
    let checkpoint = Checkpoint { iteration: done, gaussians, moments, statistics, cameras, poses, exposures };
    Advanced { checkpoint, stopped, seconds, peak_bytes: 0 }
}
