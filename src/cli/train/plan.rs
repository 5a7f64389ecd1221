//! `--plan`: what a run takes, said and not done.

use super::{SceneFormat, Train};
use crate::Result;
use crate::cli::format::TileContent;
use crate::cli::photos::Set;
use crate::photos::{adjust, register};
use crate::pipeline::scene::plan::{self, Job, Meshes};
use crate::pipeline::scene::{Cost, Trial};
use crate::splat;

/// Says what the run takes. `held_out`: one a photo.
///
/// # Errors
/// As [`Set::poses`] and [`plan::speed`].
pub fn said(args: &Train, set: &Set, held_out: &[bool], cost: &Cost, most: usize, engine: splat::Engine) -> Result<u8> {
    let photos = cost.photos.max(1) as f64;
    let job = Job {
        photos: cost.photos,
        pixels: cost.pixels as f64 / photos,
        file_pixels: set.pixels(u32::MAX)? as f64 / photos,
        longest_side: args.size,
        gaussians: most,
        steps: args.iterations as usize,
        trial_steps: trial(args, set, held_out)?,
        blocks: args.large.blocks.map_or(1, |n| n as usize),
        on_gpu: cost.on_gpu,
        store_models: args.format.contains(&SceneFormat::Cdb).then_some(args.models as usize),
        meshes: meshes(args, set, held_out)?,
    };
    let planned = plan::plan(&job, &plan::speed(engine)?);
    let mut words = planned.words(&job);
    if let Some(free) = cost.free.map(|free| (free as f64 * 0.7) as u64).filter(|free| planned.memory > *free) {
        words += &match plan::blocks_within(&Job { blocks: 1, ..job }, free) {
            Some(n) if n > 1 => format!("  this machine has less memory free: --blocks {n} fits it\n"),
            _ => "  this machine has less memory free: choose a smaller --size or --max-gaussians\n".into(),
        };
    }
    crate::cli::write_out(&words);
    Ok(0)
}

/// Steps of a trial of poses, where one is to be made: as the run itself decides it.
fn trial(args: &Train, set: &Set, held_out: &[bool]) -> Result<usize> {
    let is_trained_on = |i: usize| !held_out.get(i).copied().unwrap_or(false);
    let poses = set.poses()?;
    if !args.photos.refine_poses || args.refine_untried || adjust::is_held(poses, is_trained_on) {
        return Ok(0);
    }
    let photos = (0..poses.photos.len()).filter(|i| is_trained_on(*i)).count();
    Ok(Trial::steps(args.iterations as usize, photos).map_or(0, |steps| 2 * steps))
}

/// The meshes that are asked for, where the photos will show ground for them.
fn meshes(args: &Train, set: &Set, held_out: &[bool]) -> Result<Option<Meshes>> {
    if !(args.format.contains(&SceneFormat::Tiles3d) && args.tiles.contains(&TileContent::Mesh)) {
        return Ok(None);
    }
    let fixes = set.fixes()?;
    let (ground, to_unit) =
        plan::ground_seen(set.poses()?, held_out, Set::up(&fixes, args.seed), args.seed, args.size)?;
    let metres = || Some(register::register(&fixes, &to_unit, args.seed)?.to_enu.scale);
    let sample = args.mesh_sample.and_then(|sample| Some((sample / metres()?) as f32));
    Ok(ground.map(|ground| Meshes { ground, sample }))
}
