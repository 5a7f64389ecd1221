//! `orb bench speed`: pictures a second, by the clock on the wall and by the GPU's own.

use std::path::PathBuf;
use std::time::Instant;

use serde_json::{Value, json};

use super::scene;
use crate::cli::device::Device;
use crate::cli::render;
use crate::progress::Progress;
use crate::splat::render::gpu::{Gpu, Renderer, STAGES, Scene, Timing};
use crate::splat::train::gpu::measure::{self, forward_backward};
use crate::splat::{self, Camera, Gaussians, cameras};
use crate::{Error, Result};

/// Measure rendering speed.
#[derive(Clone, Debug, clap::Args)]
pub struct Speed {
    /// Scenes (PLY); without any, made ones.
    pub scenes: Vec<PathBuf>,
    /// Camera list (JSON); without one, 24 cameras at 1920×1080: on a ring around a made scene, or a turntable.
    #[arg(long, value_name = "CAMERAS.json")]
    pub camera: Option<PathBuf>,
    /// Gaussians of the made scenes.
    #[arg(long, value_delimiter = ',', default_values_t = [300_000, 1_000_000])]
    pub gaussians: Vec<u32>,
    /// Pictures of each measurement, rounded up to whole rounds of the cameras.
    #[arg(long, default_value_t = 96, value_parser = clap::value_parser!(u32).range(1..=2000))]
    pub pictures: u32,
    /// Compute depth too, not colour and alpha alone.
    #[arg(long)]
    pub depth: bool,
    #[arg(long, value_enum, default_value_t)]
    pub device: Device,
    /// One JSON object instead of a table.
    #[arg(long)]
    pub json: bool,
}

/// Measures every scene; what is to be printed on stdout. `say` gets one line on the device.
///
/// Errors: usage for scenes or cameras that cannot be read; environment from the GPU.
pub fn run(args: &Speed, progress: &dyn Progress, say: &mut dyn FnMut(&str)) -> Result<String> {
    let listed = match &args.camera {
        None => None,
        Some(path) => Some(cameras::parse(path, &std::fs::read(path).map_err(|e| Error::io(path, &e))?)?),
    };
    let start = Instant::now();
    let gpu = args.device.open(say)?;
    let mut renderer = gpu.as_ref().map(Renderer::new).transpose()?;
    let opened = start.elapsed().as_secs_f64();
    if let Some(r) = &mut renderer {
        r.depth = args.depth;
    }
    let made = args.scenes.is_empty();
    let count = if made { args.gaussians.len() } else { args.scenes.len() };
    progress.begin("bench", count as u64);
    let mut rows = Vec::new();
    for i in 0..count {
        progress.check()?;
        let (name, g) = if made {
            (format!("made, {}", args.gaussians[i]), scene::gaussians(args.gaussians[i] as usize))
        } else {
            (args.scenes[i].display().to_string(), render::load(&args.scenes[i])?)
        };
        let views: Vec<Camera> = match &listed {
            Some(list) => list.iter().map(|c| c.1).collect(),
            None if made => scene::cameras(),
            None => {
                let turn = cameras::turntable(&g, 24, 1080);
                turn.into_iter().map(|c| Camera { width: 1920, cx: 960.0, ..c.1 }).collect()
            }
        };
        if views.is_empty() {
            return Err(Error::usage("--camera").expected("at least one camera").found("none"));
        }
        rows.push(match (&gpu, &mut renderer) {
            (Some(gpu), Some(renderer)) => on_gpu(&name, gpu, renderer, &g, &views, args.pictures as usize)?,
            _ => on_cpu(&name, &g, &views, args.pictures as usize, progress)?,
        });
        progress.step(i as u64 + 1);
    }
    let device = gpu.as_ref().map_or("CPU".to_owned(), |g| format!("{} ({})", g.adapter.name, g.adapter.backend));
    let startup = gpu.is_some().then_some(opened);
    let result = json!({ "device": device, "startup_s": startup, "render": rows });
    Ok(if args.json { format!("{result}\n") } else { table(&result) })
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

fn on_gpu(
    name: &str,
    gpu: &Gpu,
    renderer: &mut Renderer,
    g: &Gaussians,
    views: &[Camera],
    pictures: usize,
) -> Result<Value> {
    let uploaded = Scene::upload(gpu, g)?;
    // Until the lists hold every view; clocks and caches warm up meanwhile.
    let counted = loop {
        for view in views {
            renderer.draw(&uploaded, view, [0.0; 3])?;
        }
        let counted = renderer.settle()?;
        if counted.iter().all(|c| c.drawn) {
            break counted;
        }
    };
    // Whole rounds of the views, each submitted without waiting: the middle one is what the machine sustains.
    let (mut walls, mut recorded) = (Vec::new(), Vec::new());
    for _ in 0..pictures.div_ceil(views.len()) {
        let start = Instant::now();
        for view in views {
            renderer.draw(&uploaded, view, [0.0; 3])?;
        }
        recorded.push(start.elapsed().as_secs_f64() / views.len() as f64);
        if renderer.settle()?.iter().any(|c| !c.drawn) {
            return Err(Error::environment(name).expected("every picture drawn").found("lists too short"));
        }
        walls.push(start.elapsed().as_secs_f64() / views.len() as f64);
    }
    let wall = median(walls);
    let mut times: Vec<Timing> = Vec::new();
    for i in 0..pictures {
        times.extend(renderer.time(&uploaded, &views[i % views.len()], [0.0; 3])?);
    }
    let stages: serde_json::Map<String, Value> = STAGES
        .iter()
        .enumerate()
        .map(|(s, n)| ((*n).to_owned(), median(times.iter().map(|t| t.stages[s]).collect()).into()))
        .collect();
    let timed = !times.is_empty();
    let target = renderer.render(&uploaded, &views[0], [0.0; 3])?.color;
    drop(uploaded);
    let same_size = views.iter().all(|v| (v.width, v.height) == (views[0].width, views[0].height));
    let back =
        if same_size { forward_backward(gpu, g, views, &target, pictures.div_ceil(views.len())).ok() } else { None };
    let back = back.map(|b| {
        let stages: serde_json::Map<String, Value> = measure::stages()
            .zip(b.stages.iter().flatten())
            .map(|(name, ms)| (name.to_owned(), (*ms).into()))
            .collect();
        json!({ "wall_ms": b.wall, "gpu_ms": b.gpu, "stages_ms": stages, "memory_mib": b.peak_bytes >> 20 })
    });
    Ok(json!({
        "scene": name, "gaussians": g.len(),
        "width": views[0].width, "height": views[0].height,
        "wall_ms": wall * 1e3, "fps": 1.0 / wall,
        "record_ms": median(recorded) * 1e3,
        "gpu_ms": timed.then(|| median(times.iter().map(|t| t.total).collect())),
        "stages_ms": timed.then_some(stages),
        "seen": median(counted.iter().map(|c| f64::from(c.seen)).collect()),
        "pairs": median(counted.iter().map(|c| f64::from(c.pairs)).collect()),
        "lists_mib": renderer.bytes() >> 20,
        "forward_backward": back,
    }))
}

fn on_cpu(name: &str, g: &Gaussians, views: &[Camera], pictures: usize, progress: &dyn Progress) -> Result<Value> {
    let mut times = Vec::new();
    let start = Instant::now();
    for i in 0..pictures {
        progress.check()?;
        let one = Instant::now();
        splat::render(g, &views[i % views.len()], [0.0; 3]);
        times.push(one.elapsed().as_secs_f64() * 1e3);
        // A slow machine need not draw them all.
        if start.elapsed().as_secs() >= 10 {
            break;
        }
    }
    let ms = median(times);
    Ok(json!({
        "scene": name, "gaussians": g.len(), "width": views[0].width, "height": views[0].height,
        "wall_ms": ms, "fps": 1e3 / ms,
    }))
}

fn table(result: &Value) -> String {
    let mut out = format!("device: {}", result["device"].as_str().unwrap_or(""));
    if let Some(s) = result["startup_s"].as_f64() {
        out += &format!(", opened in {s:.2} s");
    }
    out += "\n\n| scene | Gaussians | picture | pictures/s | wall ms | GPU ms | forward + backward, wall ms |";
    STAGES.iter().for_each(|s| out += &format!(" {s} |"));
    out += "\n|---|---|---|---|---|---|---|";
    STAGES.iter().for_each(|_| out += "---|");
    let ms = |v: &Value| v.as_f64().map_or("–".to_owned(), |v| format!("{v:.3}"));
    for r in result["render"].as_array().into_iter().flatten() {
        out += &format!(
            "\n| {} | {} | {}×{} | {:.0} | {} | {} | {} |",
            r["scene"].as_str().unwrap_or(""),
            r["gaussians"],
            r["width"],
            r["height"],
            r["fps"].as_f64().unwrap_or(0.0),
            ms(&r["wall_ms"]),
            ms(&r["gpu_ms"]),
            ms(&r["forward_backward"]["wall_ms"]),
        );
        STAGES.iter().for_each(|s| out += &format!(" {} |", ms(&r["stages_ms"][*s])));
    }
    out + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Silent;

    #[test]
    fn measures_and_prints() {
        let args = Speed {
            scenes: Vec::new(),
            camera: None,
            gaussians: vec![500],
            pictures: 1,
            depth: false,
            device: Device::Cpu,
            json: false,
        };
        let text = run(&args, &Silent, &mut |_| {}).unwrap();
        assert!(text.contains("| made, 500 | 500 | 1920×1080 |"), "{text}");
        let text = run(&Speed { json: true, ..args }, &Silent, &mut |_| {}).unwrap();
        let value: Value = serde_json::from_str(&text).unwrap();
        assert!(value["render"][0]["fps"].as_f64().unwrap() > 0.0);
    }

    #[test]
    fn made_scenes_are_the_same_every_time() {
        let g = scene::gaussians(1000);
        assert_eq!(g, scene::gaussians(1000));
        assert!(g.positions.iter().all(|p| p.is_finite()));
    }
}
