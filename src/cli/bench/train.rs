//! `orb bench train`: iterations a second, and what they reach.

use std::path::PathBuf;

use glam::{Quat, Vec3};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use super::{nerf, scene};
use crate::cli::checkpoint::CheckpointArgs;
use crate::cli::device::Device;
use crate::cli::render;
use crate::progress::Progress;
use crate::splat::render::Shown;
use crate::splat::render::gpu::Gpu;
use crate::splat::train::gpu::measure;
use crate::splat::train::{Behind, Checkpoint, advance};
use crate::splat::{self, Camera, Engine, Gaussians, Options, SH_COEFFICIENTS, Target, cameras};
use crate::{Error, Result};

/// Measure training speed: on pictures with poses, or on pictures that are drawn of a splat.
#[derive(Clone, Debug, clap::Args)]
pub struct Train {
    /// NeRF's list of pictures; without one, pictures of a splat.
    pub transforms: Option<PathBuf>,
    /// Points to start from (PLY), with a list.
    #[arg(long, value_name = "POINTS.ply", requires = "transforms")]
    pub start: Option<PathBuf>,
    /// With a list: every so-many-th picture is measured, not trained on.
    #[arg(long, default_value_t = 6, value_name = "N")]
    pub hold_out: usize,
    /// The splat (PLY); without one, a made one of 300,000 Gaussians.
    #[arg(long, value_name = "SCENE.ply", conflicts_with = "transforms")]
    pub scene: Option<PathBuf>,
    /// Its cameras (JSON), of which --views are taken, evenly.
    #[arg(long, value_name = "CAMERAS.json", conflicts_with = "transforms")]
    pub camera: Option<PathBuf>,
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub views: u32,
    /// Pixels across a drawn picture.
    #[arg(long, default_value_t = 320, value_parser = clap::value_parser!(u32).range(16..=4096))]
    pub size: u32,
    /// Gaussians to start from: that many of the splat's places, disturbed.
    #[arg(long, default_value_t = 20_000)]
    pub gaussians: u32,
    #[arg(long, default_value_t = 7000, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub iterations: u32,
    /// Most Gaussians. Default: a million of a splat, a third more than the points of a list.
    #[arg(long)]
    pub most: Option<usize>,
    /// Mean pull in normalised device units above which a Gaussian grows. Default: the schedule's.
    #[arg(long, value_name = "PULL")]
    pub gradient: Option<f32>,
    /// No growing after so many iterations. Default: the schedule's.
    #[arg(long, value_name = "N")]
    pub until: Option<usize>,
    /// Share of the position's first step size that is left at the end. Default: the schedule's.
    #[arg(long, value_name = "SHARE")]
    pub last_position: Option<f32>,
    /// MCMC in place of the paper's clone, split and prune.
    #[arg(long)]
    pub mcmc: bool,
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
    #[arg(long, value_enum, default_value_t)]
    pub device: Device,
    /// Also what each stage of an iteration takes on the GPU, ten times along the way.
    #[arg(long, conflicts_with_all = ["checkpoint", "resume"])]
    pub stages: bool,
    #[command(flatten)]
    pub kept: CheckpointArgs,
    /// One JSON object instead of lines.
    #[arg(long)]
    pub json: bool,
}

/// Trains and measures; what is to be printed on stdout. `say` gets one line on the device.
///
/// Errors: usage for files that cannot be read; environment from the GPU.
pub fn run(args: &Train, progress: &dyn Progress, say: &mut dyn FnMut(&str)) -> Result<String> {
    let kept = args.kept.open()?;
    let gpu = args.device.open(say)?;
    let (targets, mut start, mut options) = match &args.transforms {
        Some(list) => pictures(args, list)?,
        None => drawn(args)?,
    };
    options.seed = args.seed;
    if let Some(gradient) = args.gradient {
        options.density.gradient = gradient;
    }
    if let Some(until) = args.until {
        options.density.until = until;
    }
    if let Some(share) = args.last_position {
        options.rates.position_final = share.max(1e-6) * options.rates.position;
    }
    if args.mcmc {
        options = options.with_mcmc();
    }
    if let Some(most) = args.most {
        options.density.max_gaussians = most;
    }
    if args.mcmc {
        // As gsplat starts it.
        start.logit_opacities.fill(0.0);
    }
    let engine = gpu.as_ref().map_or(Engine::Cpu, Engine::Gpu);
    let stages = match gpu.as_ref().filter(|_| args.stages) {
        Some(gpu) => Some(stages(gpu, &start, &targets, &options, progress)?),
        None => None,
    };
    let trained = splat::train::train_kept(engine, start, &targets, &options, &kept, progress)?;
    let r = &trained.report;
    let mean = |held: bool| {
        let of: Vec<f32> = r
            .targets
            .iter()
            .zip(&targets)
            .filter(|(_, t)| (t.weight == 0.0) == held)
            .map(|(r, _)| r.after.picture)
            .collect();
        (!of.is_empty()).then(|| of.iter().sum::<f32>() / of.len() as f32)
    };
    let speed = r.iterations as f64 / r.seconds.train.max(1e-9);
    let device = gpu.as_ref().map_or("CPU".to_owned(), |g| format!("{} ({})", g.adapter.name, g.adapter.backend));
    let result = json!({
        "device": device, "iterations": r.iterations, "train_s": r.seconds.train, "setup_s": r.seconds.setup,
        "density_s": r.seconds.density, "iterations_per_s": speed,
        "gaussians_start": r.gaussians_before, "gaussians_end": r.gaussians_after,
        "train_psnr_db": mean(false), "held_out_psnr_db": mean(true), "gpu_peak_mib": r.peak_bytes >> 20,
        "sha256": hash(&trained.gaussians), "stages": stages,
    });
    if args.json {
        return Ok(format!("{result}\n"));
    }
    let stages = stages.map_or_else(String::new, |s| table(&s));
    let db = |v: Option<f32>| v.map_or("–".to_owned(), |v| format!("{v:.2} dB"));
    Ok(format!(
        "device      {device}\ntraining    {} iterations in {:.2} s, {speed:.1} a second; {:.2} s before the first\n\
         Gaussians   {} → {}\nPSNR        {} on the {} pictures trained on, {} on those held out\n\
         GPU memory  {} MiB\nresult      SHA-256 {}\n{stages}",
        r.iterations,
        r.seconds.train,
        r.seconds.setup,
        r.gaussians_before,
        r.gaussians_after,
        db(mean(false)),
        targets.iter().filter(|t| t.weight > 0.0).count(),
        db(mean(true)),
        r.peak_bytes >> 20,
        hash(&trained.gaussians),
    ))
}

/// The same run in ten parts; at the end of each the mean time of its iterations and the GPU's time of every stage.
fn stages(
    gpu: &Gpu,
    start: &Gaussians,
    targets: &[Target],
    options: &Options,
    progress: &dyn Progress,
) -> Result<Vec<Value>> {
    const PARTS: usize = 10;
    let mut at = Checkpoint::new(start, targets)?;
    let mut rows = Vec::new();
    for part in 1..=PARTS {
        let before = at.iteration;
        let done = advance(Engine::Gpu(gpu), at, targets, options, options.iterations * part / PARTS, progress)?;
        progress.check()?;
        at = done.checkpoint;
        let times = measure::training(gpu, &at, targets, options)?;
        let named: serde_json::Map<String, Value> =
            measure::stages().zip(times.iter().flatten()).map(|(n, ms)| (n.to_owned(), (*ms).into())).collect();
        rows.push(json!({
            "iterations": at.iteration, "gaussians": at.gaussians().len(),
            "wall_ms": done.seconds.train * 1e3 / (at.iteration - before).max(1) as f64,
            "density_ms": done.seconds.density * 1e3 / (at.iteration - before).max(1) as f64,
            "stages_ms": named,
        }));
    }
    Ok(rows)
}

fn table(rows: &[Value]) -> String {
    let mut out = "\n| iterations | Gaussians | wall ms | density ms |".to_owned();
    measure::stages().for_each(|s| out += &format!(" {s} |"));
    out += "\n|---|---|---|---|";
    measure::stages().for_each(|_| out += "---|");
    let ms = |v: &Value| v.as_f64().map_or("–".to_owned(), |v| format!("{v:.3}"));
    for r in rows {
        let (wall, density) = (ms(&r["wall_ms"]), ms(&r["density_ms"]));
        out += &format!("\n| {} | {} | {wall} | {density} |", r["iterations"], r["gaussians"]);
        measure::stages().for_each(|s| out += &format!(" {} |", ms(&r["stages_ms"][s])));
    }
    out + "\n"
}

/// Of all parameters' bytes: equal only for equal results.
fn hash(g: &Gaussians) -> String {
    let mut h = Sha256::new();
    g.positions.iter().chain(&g.log_scales).for_each(|v| h.update(bytemuck::bytes_of(&v.to_array())));
    h.update(bytemuck::cast_slice(&g.rotations));
    h.update(bytemuck::cast_slice(&g.logit_opacities));
    g.sh.iter().for_each(|s| h.update(bytemuck::cast_slice(s)));
    hex::encode(h.finalize())
}

fn pictures(args: &Train, list: &std::path::Path) -> Result<(Vec<Target>, Gaussians, Options)> {
    let (mut targets, alpha) = nerf::targets(list)?;
    if args.hold_out > 0 {
        targets.iter_mut().step_by(args.hold_out).for_each(|t| t.weight = 0.0);
    }
    let points = match &args.start {
        Some(path) => nerf::points(path)?,
        None => {
            return Err(Error::usage("--start").expected("points to start from").found("none"));
        }
    };
    let middle = targets.iter().map(|t| t.camera.position()).sum::<Vec3>() / targets.len() as f32;
    let far = targets.iter().map(|t| t.camera.position().distance(middle)).fold(0.0, f32::max);
    let start = nerf::gaussians(points);
    let mut options = Options { scene_extent: 1.1 * far, ..Options::scaled(args.iterations as usize) };
    options.density.max_gaussians = start.len() * 4 / 3;
    if !alpha {
        options.behind = Behind::Fixed([0.0; 3]);
    }
    Ok((targets, start, options))
}

/// Pictures of a splat over black, and Gaussians at some of its places, disturbed: the paper's small case.
fn drawn(args: &Train) -> Result<(Vec<Target>, Gaussians, Options)> {
    let truth = match &args.scene {
        Some(path) => render::load(path)?,
        None => scene::gaussians(300_000),
    };
    let listed: Vec<Camera> = match &args.camera {
        Some(path) => {
            let bytes = std::fs::read(path).map_err(|e| Error::io(path, &e))?;
            cameras::parse(path, &bytes)?.into_iter().map(|c| c.1).collect()
        }
        None if args.scene.is_some() => cameras::turntable(&truth, 24, 1080).into_iter().map(|c| c.1).collect(),
        None => scene::cameras(),
    };
    let views = args.views as usize;
    if listed.is_empty() {
        return Err(Error::usage("--camera").expected("at least one camera").found("none"));
    }
    let half = args.size as f32 / 2.0;
    let focal = half / 25f32.to_radians().tan();
    let targets = (0..views)
        .map(|i| {
            let from = listed[i * listed.len() / views];
            let camera =
                Camera { width: args.size, height: args.size, fx: focal, fy: focal, cx: half, cy: half, ..from };
            let frame = splat::render(&truth, &camera, [0.0; 3]);
            Target {
                camera,
                alpha: vec![1.0; frame.color.len()],
                color: frame.color,
                weight: 1.0,
                refine_pose: None,
                fit_exposure: false,
                held_back: None,
                confidence: None,
                shown: Shown::Color,
                name: format!("view {i}"),
            }
        })
        .collect();
    let mut r = scene::Random::new(args.seed);
    let n = (args.gaussians as usize).min(truth.len());
    // A seeded shuffle's first n.
    let mut order: Vec<usize> = (0..truth.len()).collect();
    for i in 0..n {
        let other = i + (r.bits() % (truth.len() - i) as u64) as usize;
        order.swap(i, other);
    }
    let mut vector = |deviation: f32| Vec3::from_array(std::array::from_fn(|_| r.normal(0.0, deviation)));
    let positions = order[..n].iter().map(|i| truth.positions[*i] + vector(0.02)).collect();
    let rotations = (0..n)
        .map(|_| {
            let q = Quat::from_scaled_axis(vector(1.5));
            [q.w, q.x, q.y, q.z]
        })
        .collect();
    let start = Gaussians {
        positions,
        log_scales: vec![Vec3::splat(0.05f32.ln()); n],
        rotations,
        logit_opacities: vec![-2.2; n],
        sh: vec![[[0.0; 3]; SH_COEFFICIENTS]; n],
    };
    let mut options = Options {
        iterations: args.iterations as usize,
        scene_extent: 5.0,
        behind: Behind::Fixed([0.0; 3]),
        ..Options::default()
    };
    // Found by trial on this scene: places must keep moving while Gaussians multiply, and settle at the end.
    options.rates.position_final = 0.1 * options.rates.position;
    options.density.gradient = 1e-4;
    options.density.until = options.iterations * 6 / 7;
    Ok((targets, start, options))
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::progress::Silent;

    /// The user stops it after three steps.
    struct Stopped(std::sync::atomic::AtomicUsize);

    impl Progress for Stopped {
        fn begin(&self, _: &'static str, _: u64) {}
        fn step(&self, done: u64) {
            self.0.store(done as usize, std::sync::atomic::Ordering::Relaxed);
        }
        fn cancelled(&self) -> bool {
            self.0.load(std::sync::atomic::Ordering::Relaxed) >= 3
        }
    }

    #[test]
    fn trains_and_says_what_it_reached() {
        let folder = tempfile::tempdir().unwrap();
        let args = Train {
            transforms: None,
            start: None,
            hold_out: 6,
            scene: None,
            camera: None,
            views: 2,
            size: 32,
            gaussians: 200,
            iterations: 5,
            most: Some(300),
            gradient: None,
            until: None,
            last_position: None,
            mcmc: false,
            seed: 3,
            device: Device::Cpu,
            stages: false,
            kept: CheckpointArgs { checkpoint_every: Some(2), ..Default::default() },
            json: true,
        };
        let one = |args: &Train| -> Value { serde_json::from_str(&run(args, &Silent, &mut |_| {}).unwrap()).unwrap() };
        let a = one(&args);
        assert_eq!((&a["iterations"], &a["gaussians_start"]), (&json!(5), &json!(200)));
        // The same of a scene from a file, a hundredth of the built-in one.
        let scene = folder.path().join("scene.ply");
        let (world, marking) = (crate::geo::similarity::Similarity::IDENTITY, crate::audit::Marking::UNCLASSIFIED);
        let file = crate::export::posed_ply(&scene::gaussians(3000), &world, &marking).unwrap();
        std::fs::write(&scene, file.bytes).unwrap();
        let args = Train { scene: Some(scene), ..args };
        let a = one(&args);
        assert_eq!((&a["iterations"], &a["gaussians_start"]), (&json!(5), &json!(200)));
        assert_eq!(a["sha256"], one(&args)["sha256"]);
        assert_ne!(a["sha256"], one(&Train { seed: 4, ..args.clone() })["sha256"]);
        // Taken up from half-way, under the same options only.
        let file = folder.path().join("run.ckpt");
        let stopped = Stopped(std::sync::atomic::AtomicUsize::new(0));
        let kept = CheckpointArgs { checkpoint: Some(file.clone()), ..args.kept.clone() };
        let e = run(&Train { kept, ..args.clone() }, &stopped, &mut |_| {}).unwrap_err();
        assert!(e.kind == crate::Kind::Cancelled && e.to_string().contains("goes on from step 3"), "{e}");
        let kept = CheckpointArgs { resume: Some(file.clone()), ..args.kept.clone() };
        assert_eq!(one(&Train { kept: kept.clone(), ..args.clone() })["sha256"], a["sha256"]);
        let other = Train { kept, seed: 4, ..args.clone() };
        let e = run(&other, &Silent, &mut |_| {}).unwrap_err().to_string();
        assert!(e.contains("--resume") && e.contains("first Gaussians"), "{e}");
        let list = folder.path().join("none.json");
        let e = run(&Train { transforms: Some(list), ..args }, &Silent, &mut |_| {}).unwrap_err();
        assert!(e.to_string().contains("none.json"), "{e}");
    }
}
