//! `orb reconstruct`: one photo becomes Gaussians, marked and sealed; no mesh, no place on the Earth.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use super::bar::Bar;
use super::checkpoint::CheckpointArgs;
use super::device::Device;
use super::effort::EffortArgs;
use super::geo;
use super::photos::{Front, PhotosArgs};
use super::sealed::{Evidence, PublishArgs, SealedRun};
use crate::audit::statement::Param;
use crate::audit::time;
use crate::pipeline::Settings;
use crate::progress::Progress;
use crate::sources::Sources;
use crate::symmetry::Use;
use crate::{Result, export, splat};

/// Turn a photo into Gaussians alone: neither meshed nor placed.
#[derive(Clone, Debug, clap::Args)]
pub struct Reconstruct {
    /// The photo: JPEG, HEIC, PNG, WebP or TIFF, the subject in the middle; or a folder of photos of one subject.
    pub photo: PathBuf,
    #[command(flatten)]
    pub photos: PhotosArgs,
    /// Folder to publish; must not exist yet. Default: the photo's name without its extension.
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub publish: PublishArgs,
    #[command(flatten)]
    pub effort: EffortArgs,
    #[arg(long, value_enum, default_value_t)]
    pub device: Device,
    /// Same photo, options, seed and machine: same bytes.
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
    #[command(flatten)]
    pub kept: CheckpointArgs,
}

/// Runs the verb. `stop` is set by the interrupt handler.
///
/// Errors: as `orb geo`.
pub fn run(args: &Reconstruct, stop: &AtomicBool) -> Result<u8> {
    let started = Instant::now();
    let mut front = Front::open(&args.photo, &args.photos)?;
    let kept = args.kept.open()?;
    let handling = args.publish.marking.decide(front.carried(), &time::now()?.utc())?;
    let product = handling.marking.clone();
    let stem = geo::stem_of(&args.photo);
    let output = args.output.clone().unwrap_or_else(|| geo::default_output(&args.photo, &stem));
    let mut sealed = SealedRun::begin("orb reconstruct", &output, handling, &args.publish)?;
    let gpu = args.device.open_quietly(&mut |line| {
        if !args.publish.quiet {
            eprintln!("orb: {line}");
        }
    })?;
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let several = front.one().is_none();
    let limits = args.effort.limits(started);
    let settings = Settings {
        iterations: args.effort.steps(several, threads, gpu.is_some()),
        optimise_within: limits.map(|l| l.optimise),
        deadline: limits.map(|l| l.deadline),
        seed: args.seed,
        pitch: args.photos.pitch,
        levels: 1,
        triangles: None,
        in_store: false,
        texture: 1024,
        normal_map: false,
        occlusion: false,
        symmetry: Use::Auto,
        kept,
    };
    let bar = Bar::new(stop, args.publish.quiet);
    let fitter = gpu.as_ref().map_or(splat::Engine::Cpu, splat::Engine::Gpu);
    front.pose(&args.photos, &bar)?;
    let fixes = front.fixes(None)?;
    let (photo, done) = front.fit(&Sources::default(), &args.photos, &fixes, fitter, &settings, &bar)?;
    bar.begin("writing and sealing", 0);
    let scene = export::unit_ply(&done.gaussians, &product)?;
    sealed.publication.add(&scene.path, &scene.bytes, scene.media_type, "gaussians")?;
    let preview = export::fitted_png(&photo.pixels, &done, &product)?;
    sealed.publication.add("preview.png", &preview, "image/png", "preview")?;
    bar.check()?;
    let report = &done.report;
    let published = sealed.seal(Evidence {
        event_type: "scene.reconstruct",
        time: time::now()?,
        inputs: front.inputs().to_vec(),
        models: geo::recorded::models(&done.sources, &report.device, front.colmap()),
        params: BTreeMap::from([
            ("seed".into(), Param::Text(args.seed.to_string())),
            ("device".into(), Param::Text(report.device.clone())),
            ("iterations_planned".into(), Param::Int(settings.iterations.into())),
            ("iterations_run".into(), Param::Int(report.iterations as i64)),
            ("stopped_by_time".into(), Param::Bool(report.stopped_by_deadline)),
        ])
        .into_iter()
        .chain(args.photos.params())
        .chain(front.params(done.several.as_ref()))
        .collect(),
    })?;
    bar.finish();
    if !args.publish.quiet {
        let stages: Vec<String> =
            done.timings().iter().map(|t| format!("{} {:.1} s", t.stage, t.time.as_secs_f64())).collect();
        println!(
            "marking      {}\npublished    {}\nGaussians    {} after {} steps on {}\nstages       {}\nused         {:.1} s",
            product.banner(),
            published.folder.display(),
            done.gaussians.len(),
            report.iterations,
            report.device,
            stages.join(", "),
            started.elapsed().as_secs_f64(),
        );
        for (name, words) in front.lines(done.several.as_ref()) {
            println!("{name:<12} {words}");
        }
    }
    Ok(0)
}
