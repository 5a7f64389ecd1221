//! A whole scene from posed photos: poses → pictures → Gaussians to begin with → training → how well it meets photos that
//! it never saw (Kerbl et al. 2023). No mask of a subject, no network, no mesh.

mod begin;
pub mod blocks;
pub mod bodies;
mod brightness;
mod cameras;
pub mod cost;
pub mod ground;
pub mod nadir;
mod pictures;
pub mod plan;
mod refining;
mod score;
mod sky;
#[cfg(test)]
mod tests;

use glam::{DQuat, DVec3};

use super::{Clock, Timing};
use crate::geo::similarity::Similarity;
use crate::models::Graph;
use crate::photo::Photo;
use crate::photos::frame::{self, Ground, UpBy};
use crate::photos::{Posed, Poses, adjust};
use crate::progress::Progress;
use crate::splat::render::Drawers;
use crate::splat::train::exposure::{Change, NONE};
use crate::splat::train::{Behind, Density, Kept, Rates, Region, train_kept};
use crate::splat::{self, Camera, Gaussians, Report, Target};
use crate::{Error, Result};

pub use crate::splat::train::Strategy;
pub use begin::From;
pub use blocks::Blocks;
pub use cameras::{Errors, Moved, Refined};
pub use cost::Cost;
pub use pictures::Pictures;
pub use refining::{By, Refining, Trial};
pub use score::{Role, Scores, View};

/// What stands behind all Gaussians.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Background {
    /// White where the photos have alpha, as NeRF's synthetic sets are measured; else black.
    #[default]
    Auto,
    Color([f32; 3]),
    /// Another at every step: where the photos have alpha, so do the Gaussians.
    Changing,
}

/// Whether far Gaussians stand for the sky.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sky {
    /// Where the photos show one.
    #[default]
    Auto,
    On,
    Off,
}

/// What training is told.
#[derive(Clone, Debug)]
pub struct Options {
    pub iterations: usize,
    pub strategy: Strategy,
    pub max_gaussians: usize,
    /// Longer side of a photo in training, pixels; larger ones are made smaller.
    pub longest_side: u32,
    /// Gaussians to begin with where there are no points.
    pub random_points: usize,
    /// Each photo's exposure is learnt.
    pub exposure: bool,
    pub refine_poses: bool,
    /// By the photos alone without a trial, where the points are too few.
    pub refine_untried: bool,
    /// Photos held out are measured a second time, their poses fitted to the Gaussians; where poses are refined, always.
    pub fit_held_out: bool,
    pub background: Background,
    pub sky: Sky,
    /// Up in the cameras' world, where the Earth says it.
    pub up: Option<DVec3>,
    pub seed: u64,
    pub kept: Kept,
}

impl Default for Options {
    /// Kerbl et al. 2023 with the numbers of gsplat 1.5's trainer.
    fn default() -> Self {
        Options {
            iterations: 30_000,
            strategy: Strategy::Paper,
            max_gaussians: 1_000_000,
            longest_side: 1600,
            random_points: 100_000,
            exposure: false,
            refine_poses: false,
            refine_untried: false,
            fit_held_out: false,
            background: Background::Auto,
            sky: Sky::Auto,
            up: None,
            seed: 0,
            kept: Kept::default(),
        }
    }
}

/// A trained scene. Lengths in its unit: the cameras' median distance from what they look at.
pub struct Scene {
    /// In the unit frame: Z up, +Y where the first photo looks.
    pub gaussians: Gaussians,
    /// How many of them are the sky's; they come last.
    pub sky: usize,
    /// One a photo, in order; refined where asked.
    pub cameras: Vec<Camera>,
    /// One a photo, in order.
    pub exposures: Vec<Change>,
    /// From the cameras' world to the unit frame, f64.
    pub to_unit: Similarity,
    pub up_by: UpBy,
    pub ground: Option<Ground>,
    pub begun_from: begin::From,
    pub views: Vec<View>,
    pub trained: Scores,
    pub held_out: Scores,
    /// The same with poses fitted to the Gaussians, where asked.
    pub held_out_fitted: Option<Scores>,
    /// Where it was asked for: by what poses were refined, or why not.
    pub refining: Option<Refining>,
    /// Where poses were refined.
    pub refined: Option<Refined>,
    pub reprojection: Errors,
    pub behind: [f32; 3],
    pub report: Report,
    pub timings: Vec<Timing>,
}

/// Photos as the files have them, and what of them is to be looked at.
pub struct Source<'a> {
    pub poses: &'a Poses,
    /// One a photo: measured, never trained on.
    pub held_out: &'a [bool],
    /// The photo of a pose, its rows as the file has them.
    pub open: &'a dyn Fn(&Posed) -> Result<Photo>,
    /// Its mask, 0 where it is not to be looked at.
    pub mask: &'a dyn Fn(usize) -> Result<Option<image::GrayImage>>,
}

/// From the cameras' world to the unit frame: what the photos look at in the middle, the cameras' median distance from it 1.
///
/// # Errors
/// Usage where all cameras stand at one place.
pub fn unit_frame(poses: &Poses, up: Option<DVec3>, seed: u64) -> Result<(Similarity, UpBy, Option<Ground>)> {
    let photos = &poses.photos;
    let centres: Vec<DVec3> = photos.iter().map(Posed::centre).collect();
    let mean = centres.iter().sum::<DVec3>() / centres.len().max(1) as f64;
    let spread = centres.iter().map(|c| c.distance(mean)).fold(0.0, f64::max);
    let near = |at: &DVec3| at.distance(mean) < 20.0 * spread;
    let middle = frame::looked_at(photos, &poses.points).filter(near).unwrap_or(mean);
    let mut distances: Vec<f64> = centres.iter().map(|c| c.distance(middle)).collect();
    distances.sort_by(f64::total_cmp);
    let radius = distances.get(distances.len() / 2).copied().unwrap_or(0.0).max(0.05 * spread);
    if !(radius.is_finite() && radius > 0.0) {
        return Err(Error::usage("photos").expected("cameras at different places").found("all at one place"));
    }
    let cameras_up = frame::up_of_cameras(photos.iter().map(|p| p.rotation));
    let ground = frame::ground(&poses.points, middle, radius, up.unwrap_or(cameras_up), seed);
    let (up, by) = match (up, &ground) {
        (Some(up), _) => (up, UpBy::Georegistration),
        (None, Some(g)) => (g.normal, UpBy::Ground),
        (None, None) => (cameras_up, UpBy::Cameras),
    };
    let first = photos.first().map_or((mean, DQuat::IDENTITY), |p| (p.centre(), p.rotation));
    Ok((frame::unit(middle, radius, up, first.0, first.1.inverse() * -DVec3::Y), by, ground))
}

/// Trains and measures. `lpips`: the network of that measure, where there is one.
///
/// # Errors
/// Usage for fewer than two photos to train on and for photos of another shape than their cameras; as [`train_kept`].
pub fn fit(
    source: &Source,
    fitter: splat::Engine,
    options: &Options,
    lpips: Option<&dyn Graph>,
    progress: &dyn Progress,
) -> Result<Scene> {
    let mut clock = Clock::new();
    let (to_unit, up_by, ground) = unit_frame(source.poses, options.up, options.seed)?;
    // What the photos' points say of poses comes first: it is exact where they have points, and training goes on from there.
    let given = source.poses;
    let is_held_out = |i: usize| source.held_out.get(i).copied().unwrap_or(false);
    let adjusted = match options.refine_poses {
        true => {
            progress.begin("adjusting poses", 0);
            cameras::adjusted(given, |i| !is_held_out(i))
        }
        false => None,
    };
    let source = &Source { poses: adjusted.as_ref().map_or(given, |(all, _)| all), ..*source };
    let mut pictures = pictures::read(source, &to_unit, options, progress)?;
    clock.lap("photos");
    let training = pictures.trained_on()?;
    let extent = extent(pictures.targets.iter().map(|t| t.camera.position()));
    let Begun { start, from: begun_from, behind } =
        begin(source.poses, &to_unit, &pictures, extent, options, options.max_gaussians)?;
    clock.lap("first Gaussians");
    progress.check()?;

    let planned = |steps: usize| {
        schedule(&Options { iterations: steps, ..options.clone() }, extent, behind, training, begun_from)
    };
    let found = options.kept.from.as_ref().and_then(|saved| Trial::from_numbers(saved.beside()));
    let by = match &adjusted {
        _ if !options.refine_poses => None,
        Some((_, photos)) => Some(By::Points { photos: *photos }),
        None if options.refine_untried => Some(By::Untried),
        None => Some(refining::tried(fitter, &start, &mut pictures, options.iterations, planned, found, progress)?),
    };
    let refining = by.map(|by| Refining { common: adjust::common(given, |i| !is_held_out(i)), by });
    let trial = refining.as_ref().and_then(Refining::trial);
    if trial.is_some() && found.is_none() {
        clock.lap("trial of poses");
    }
    let kept = Kept { beside: trial.map(Trial::numbers).unwrap_or_default(), ..options.kept.clone() };
    let mut schedule = planned(options.iterations);
    if let Some(off) = adjusted.as_ref().and_then(|(all, _)| cameras::uncertainty(all, |i| !is_held_out(i))) {
        schedule.rates.pose = schedule.rates.pose.min(pose_rate(off, schedule.iterations, training));
    }
    let mut trained = train_kept(fitter, start, &pictures.targets, &schedule, &kept, progress)?;
    let learnt: Vec<bool> = pictures.targets.iter().map(|t| t.fit_exposure).collect();
    brightness::settle(&mut trained.gaussians, &mut trained.exposures, &learnt);
    let refined = refining
        .filter(Refining::moved)
        .map(|_| cameras::settled(&mut trained, &pictures.targets, given, source.poses, &to_unit));
    let is_trained_on: Vec<bool> = pictures.targets.iter().map(|t| t.weight > 0.0).collect();
    let reprojection = cameras::errors(given, refined.as_ref(), |i| is_trained_on[i]);
    clock.lap("optimisation");

    progress.begin("measuring", pictures.targets.len() as u64);
    let drawers = Drawers::new(&trained.gaussians);
    let (cameras, exposures) = (&trained.cameras, &trained.exposures);
    let again = (options.refine_poses || options.fit_held_out).then(|| {
        let held_out = |t: &&Target| t.weight <= 0.0;
        pictures.targets.iter().filter(held_out).cloned().collect::<Vec<Target>>()
    });
    let views = score::views(pictures.targets, &drawers, cameras, exposures, behind, lpips, progress)?;
    let held_out_fitted = match again {
        Some(targets) if !targets.is_empty() => {
            let given: Vec<Camera> = targets.iter().map(|t| t.camera).collect();
            let depths = cameras::depths(source.poses, &to_unit, &given);
            let cameras =
                cameras::fitted(fitter, &trained.gaussians, &targets, &depths, behind, options.seed, progress)?;
            let exposures = vec![NONE; targets.len()];
            let views = score::views(targets, &drawers, &cameras, &exposures, behind, lpips, progress)?;
            Some(Scores::mean(views.iter().map(|v| &v.scores)))
        }
        _ => None,
    };
    drop(drawers);
    clock.lap("measuring");
    let of = |role: Role| Scores::mean(views.iter().filter(|v| v.role == role).map(|v| &v.scores));
    let (measured_trained, measured_held_out) = (of(Role::Trained), of(Role::HeldOut));
    let (gaussians, sky) = sky::last(trained.gaussians, extent);
    Ok(Scene {
        gaussians,
        sky,
        cameras: trained.cameras,
        exposures: trained.exposures,
        to_unit,
        up_by,
        ground,
        begun_from,
        views,
        trained: measured_trained,
        held_out: measured_held_out,
        held_out_fitted,
        refining,
        refined,
        reprojection,
        behind,
        report: trained.report,
        timings: clock.timings,
    })
}

/// What training begins with.
struct Begun {
    /// The sky's last.
    start: Gaussians,
    from: begin::From,
    /// What stands behind all Gaussians.
    behind: [f32; 3],
}

/// `sky_of`: the sky may be its part of so many.
fn begin(
    poses: &Poses,
    to_unit: &Similarity,
    pictures: &Pictures,
    extent: f32,
    options: &Options,
    sky_of: usize,
) -> Result<Begun> {
    let behind = match options.background {
        Background::Color(c) => c,
        Background::Auto if pictures.alpha => [1.0; 3],
        Background::Auto => [0.0; 3],
        Background::Changing => [0.5; 3],
    };
    let seen = || sky::seen(&pictures.targets, extent, sky_of);
    let sky = match options.sky {
        Sky::Off => None,
        Sky::Auto if pictures.alpha => None,
        Sky::Auto => seen().filter(sky::is_plain),
        Sky::On => seen(),
    };
    let sky = sky.map(|s| s.gaussians).unwrap_or_default();
    let room = options.max_gaussians.saturating_sub(sky.len());
    let (mut start, from) = begin::gaussians(poses, to_unit, pictures, extent, room, options)?;
    let sky_count = sky.len().min(options.max_gaussians.saturating_sub(start.len()));
    start.extend(&sky.filtered(|i| i < sky_count));
    Ok(Begun { start, from, behind })
}

/// Size of the scene as gsplat has it: 1.1 times the farthest camera's distance from the cameras' middle.
fn extent(eyes: impl Iterator<Item = glam::Vec3> + Clone) -> f32 {
    let count = eyes.clone().count().max(1);
    let middle = eyes.clone().sum::<glam::Vec3>() / count as f32;
    1.1 * eyes.map(|p| p.distance(middle)).fold(1e-3, f32::max)
}

/// How far a pose may go in all its steps, radians, and how long a step is at most and at least.
const POSES_REACH: f32 = 0.04;
const POSE_STEPS: [f32; 2] = [2e-4, 4e-3];
/// The last step as a part of the first.
const LAST_POSE_STEP: f32 = 0.01;

/// The first step of poses that may go `reach` (radians) in all their steps: the mean of steps that fall exponentially is
/// (1 − share) / ln(1 / share) of the first.
fn pose_rate(reach: f32, iterations: usize, photos: usize) -> f32 {
    let turns = iterations as f32 / photos.max(1) as f32;
    reach / turns.max(1.0) * LAST_POSE_STEP.recip().ln()
}

/// The schedule of 30,000 iterations; a shorter run ends its growing half-way and begins it earlier.
pub fn schedule(options: &Options, extent: f32, behind: [f32; 3], photos: usize, from: From) -> splat::Options {
    let full = splat::Options::default();
    let n = options.iterations;
    // A photo has few turns in a short run, and Adam goes no further than its rate in each.
    let turns = n as f32 / photos.max(1) as f32;
    let hurry = (300.0 / turns.max(1.0)).clamp(1.0, 4.0);
    // From random places longer steps fit the photos trained on by what floats before them.
    let longer = if matches!(from, From::Random(_)) { 1.0 } else { hurry };
    let rates = full.rates;
    let density = Density {
        // Before it counts, every photo has had a turn.
        from: full.density.from.min(n / 20).max(photos.min(n / 20)),
        until: full.density.until.min(n / 2),
        every: full.density.every.min((n / 150).max(20)),
        max_gaussians: options.max_gaussians,
        ..full.density
    };
    let plain = splat::Options {
        iterations: n,
        seed: options.seed,
        scene_extent: extent,
        moving: Region { radius: sky::beyond(extent), ..Region::EVERYWHERE },
        sh_degree_every: full.sh_degree_every.min((n / 10).max(1)),
        density,
        pose_from: full.pose_from.min(n / 10),
        behind: if options.background == Background::Changing { Behind::Changing } else { Behind::Fixed(behind) },
        shuffled: true,
        // Opacities settle soonest: faster, they only waver.
        rates: Rates {
            position: longer * rates.position,
            position_final: longer * rates.position_final,
            rotation: longer * rates.rotation,
            scale: longer * rates.scale,
            color: longer.sqrt() * rates.color,
            harmonics: longer * rates.harmonics,
            exposure: hurry * rates.exposure,
            pose: pose_rate(POSES_REACH, n, photos).clamp(POSE_STEPS[0], POSE_STEPS[1]),
            pose_share: LAST_POSE_STEP,
            ..rates
        },
        ..full
    };
    match options.strategy {
        Strategy::Paper => plain,
        Strategy::Mcmc => {
            let mcmc = plain.with_mcmc();
            splat::Options { density: Density { until: mcmc.density.until.min(n * 5 / 6), ..mcmc.density }, ..mcmc }
        }
    }
}
