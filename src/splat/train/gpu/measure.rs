//! How long one forward and backward pass takes, without a step.

use std::time::Instant;

use bytemuck::{Zeroable, pod_collect_to_vec};
use wgpu::BufferUsages;

use super::iteration::{BACK_STAGES, Gradients, Picture};
use super::run::{Run, pixels};
use super::table::{self, Step};
use crate::Result;
use crate::splat::packed::Packed;
use crate::splat::render::gpu::kernel::read;
use crate::splat::render::gpu::{Gpu, STAGES};
use crate::splat::train::{Checkpoint, Options, Target, adam, density, exposure, pose};
use crate::splat::{Camera, Gaussians};

const ALL: usize = STAGES.len() + BACK_STAGES.len();

/// Names of a pass's stages.
pub fn stages() -> impl Iterator<Item = &'static str> {
    STAGES.into_iter().chain(BACK_STAGES)
}

/// Milliseconds of one picture forward and backward: medians.
#[derive(Clone, Debug)]
pub struct Passes {
    pub wall: f64,
    /// By timestamp queries, where the adapter has them: each stage, and the sum.
    pub stages: Option<Vec<f64>>,
    pub gpu: Option<f64>,
    pub peak_bytes: u64,
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// Colour with degree-3 harmonics, |x − y| against one picture (all cameras must have the same size), gradients of every
/// parameter written to memory.
///
/// Errors: environment from the GPU.
pub fn forward_backward(
    gpu: &Gpu,
    g: &Gaussians,
    cameras: &[Camera],
    target: &[[f32; 3]],
    rounds: usize,
) -> Result<Passes> {
    let n = g.len();
    let at = Checkpoint {
        iteration: 0,
        gaussians: Packed::pack(g),
        moments: adam::Moments { core: vec![[[0.0; 16]; 2]; n], sh: vec![[[0.0; 48]; 2]; n], steps: vec![0; n] },
        statistics: density::Statistics::new(n),
        cameras: cameras.to_vec(),
        poses: vec![pose::Pose::default(); cameras.len()],
        exposures: vec![exposure::Exposure::default(); cameras.len()],
    };
    let out = Gradients {
        core: gpu.buffer("gradient", 48 * n as u64),
        harmonics: gpu.buffer("gradient", 192 * n as u64),
        mean: gpu.buffer("gradient", 8 * n as u64),
    };
    let (width, height) = (cameras[0].width, cameras[0].height);
    let wanted: Vec<[f32; 4]> = target.iter().map(|c| [c[0], c[1], c[2], 1.0]).collect();
    let buffer = gpu.buffer("target", 16 * wanted.len() as u64);
    gpu.queue.write_buffer(&buffer, 0, bytemuck::cast_slice(&wanted));
    let pictures: Vec<_> = cameras.iter().map(|_| Picture { width, height, wanted: buffer.clone() }).collect();
    let pixels = pixels(gpu, &pictures);
    let steps: Vec<Step> = (0..cameras.len() as u32)
        .map(|i| Step {
            loss: [1.0 / (3 * width * height) as f32, 0.0, 0.0, 0.0],
            words: [0, 0, i, 3],
            ..Step::zeroed()
        })
        .collect();
    let mut options = Options::default();
    options.density.until = 0;
    let mut run = Run::with(gpu, &at, pictures, steps, table::corrections(1), &options, pixels, Some(&out))?;
    drop(at);
    run.settle(Some(&out))?;
    let mut walls = Vec::new();
    for _ in 0..rounds.max(1) {
        let start = Instant::now();
        run.once()?;
        walls.push(start.elapsed().as_secs_f64() * 1e3 / cameras.len() as f64);
    }
    let times = if gpu.abilities.timestamps { Some(timed(&run)?) } else { None };
    Ok(Passes {
        wall: median(walls),
        gpu: times.as_ref().map(|t| t.iter().sum()),
        stages: times,
        // What the step would need besides is there too, but not used; and all cameras share one target.
        peak_bytes: (run.peak + 248 * n as u64)
            .saturating_sub(480 * n as u64 + 16 * u64::from(width) * u64::from(height) * (cameras.len() as u64 - 1)),
    })
}

/// GPU milliseconds of each of [`stages`] in one iteration of training from `at`: medians of one turn of every target.
/// None where the adapter has no timestamps.
///
/// Errors: environment from the GPU.
pub fn training(gpu: &Gpu, at: &Checkpoint, targets: &[Target], options: &Options) -> Result<Option<Vec<f64>>> {
    if !gpu.abilities.timestamps {
        return Ok(None);
    }
    let pictures: Vec<_> = targets.iter().map(|t| Picture::upload(gpu, t)).collect();
    let pixels = pixels(gpu, &pictures);
    let mut steps = table::steps(targets, options);
    let measured = (3 * targets.len()).min(steps.len());
    steps.drain(..at.iteration.min(steps.len() - measured));
    steps.truncate(measured);
    let corrections = table::corrections(options.iterations);
    let mut run = Run::with(gpu, at, pictures, steps, corrections, options, pixels, None)?;
    run.settle(None)?;
    Ok(Some(timed(&run)?))
}

/// Medians over the cameras.
fn timed(run: &Run) -> Result<Vec<f64>> {
    let gpu = run.gpu;
    let set = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
        label: Some("stages"),
        ty: wgpu::QueryType::Timestamp,
        count: 2 * ALL as u32,
    });
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("stages"),
        size: 16 * ALL as u64,
        usage: BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    });
    let mut all: Vec<Vec<f64>> = vec![Vec::new(); ALL];
    run.rewind();
    for step in &run.steps {
        let target = step.words[2] as usize;
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        run.iteration.begin(&mut encoder.begin_compute_pass(&Default::default()));
        for stage in 0..ALL {
            let timestamp_writes = Some(wgpu::ComputePassTimestampWrites {
                query_set: &set,
                beginning_of_pass_write_index: Some(2 * stage as u32),
                end_of_pass_write_index: Some(2 * stage as u32 + 1),
            });
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor { label: None, timestamp_writes });
            run.iteration.stage(stage, &mut pass, target, &run.fixed.pictures[target], step);
        }
        encoder.resolve_query_set(&set, 0..2 * ALL as u32, &buffer, 0);
        gpu.queue.submit([encoder.finish()]);
        let ticks: Vec<u64> = pod_collect_to_vec(&read(gpu, &buffer, 16 * ALL as u64)?);
        let unit = f64::from(gpu.queue.get_timestamp_period()) * 1e-6;
        for (stage, times) in all.iter_mut().enumerate() {
            times.push(ticks[2 * stage + 1].wrapping_sub(ticks[2 * stage]) as f64 * unit);
        }
    }
    Ok(all.into_iter().map(median).collect())
}
