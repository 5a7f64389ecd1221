//! Submits iterations and watches them.

use std::collections::VecDeque;
use std::sync::mpsc;
use std::time::{Duration, Instant};

use bytemuck::{Zeroable, bytes_of, cast_slice, pod_read_unaligned};
use wgpu::{Buffer, BufferUsages, PollType, SubmissionIndex};

use super::density;
use super::iteration::{Finish, Fixed, Gradients, Iteration, Picture, State};
use super::kernels::Kernels;
use super::model::Model;
use super::table::{self, Step};
use crate::progress::Progress;
use crate::splat::Camera;
use crate::splat::render::gpu::kernel::read;
use crate::splat::render::gpu::plan::{Kernels as Drawing, RECORD, TILE, View};
use crate::splat::render::gpu::{Gpu, MOST_GROUPS, Scene};
use crate::splat::train::exposure::Exposure;
use crate::splat::train::pose::Pose;
use crate::splat::train::{Advanced, Checkpoint, Density, Options, Stop, Target};
use crate::{Error, Result};

/// Iterations a submission.
const BATCH: usize = 16;
/// Submissions on their way.
const AHEAD: usize = 3;
const STATE: u64 = size_of::<State>() as u64;

/// Tiles of a picture below which the way back has too few workgroups for a large GPU.
const FEW_TILES: u32 = 1024;

/// Pixels a thread on the rasteriser's way back: the fewer lanes add up, the more each should bring; where tiles are
/// few and their lists long, more threads a tile are worth more (docs/performance.md).
pub fn pixels(gpu: &Gpu, pictures: &[Picture]) -> u32 {
    let tiles = pictures.iter().map(|p| p.width.div_ceil(TILE) * p.height.div_ceil(TILE)).max().unwrap_or(0);
    match gpu.abilities.lanes {
        ..16 => 4,
        _ if tiles < FEW_TILES => 1,
        _ => 2,
    }
}

pub struct Run<'a> {
    pub gpu: &'a Gpu,
    drawing: Drawing,
    pub kernels: Kernels,
    pub model: Model,
    pub fixed: Fixed,
    pub iteration: Iteration,
    pub steps: Vec<Step>,
    pub done: usize,
    room: u64,
    /// Most bytes of buffers at one time.
    pub peak: u64,
}

/// A submission on its way.
struct Sent {
    end: usize,
    index: SubmissionIndex,
    state: Buffer,
    mapped: mpsc::Receiver<Result<(), wgpu::BufferAsyncError>>,
}

/// Pairs that one binding holds and one dispatch reaches.
fn most_pairs(gpu: &Gpu) -> u64 {
    (gpu.adapter.largest_binding / (4 * RECORD)).min(u64::from(MOST_GROUPS) * 2048).min(u32::MAX.into())
}

impl<'a> Run<'a> {
    pub fn new(gpu: &'a Gpu, at: &Checkpoint, targets: &[Target], options: &Options) -> Result<Self> {
        let pictures: Vec<_> = targets.iter().map(|t| Picture::upload(gpu, t)).collect();
        let pixels = pixels(gpu, &pictures);
        let (steps, corrections) = (table::steps(targets, options), table::corrections(options.iterations));
        Self::with(gpu, at, pictures, steps, corrections, options, pixels, None)
    }

    /// `gradients`: written in place of Adam's step.
    #[expect(clippy::too_many_arguments)]
    pub fn with(
        gpu: &'a Gpu,
        at: &Checkpoint,
        pictures: Vec<Picture>,
        steps: Vec<Step>,
        corrections: Vec<[f32; 2]>,
        options: &Options,
        pixels: u32,
        gradients: Option<&Gradients>,
    ) -> Result<Self> {
        let count = at.gaussians.len() as u32;
        let capacity = room_for(gpu, count, count, options);
        let mut model = Model::new(gpu, capacity)?;
        model.upload(gpu, &at.gaussians, &at.moments, &at.statistics.seen)?;
        let cameras: Vec<View> = at.cameras.iter().map(view).collect();
        let poses: Vec<[f32; 16]> = at.poses.iter().map(Pose::words).collect();
        let exposures: Vec<[f32; 40]> = at.exposures.iter().map(Exposure::words).collect();
        let put = |label: &str, bytes: &[u8]| {
            let buffer = gpu.buffer(label, bytes.len() as u64);
            gpu.queue.write_buffer(&buffer, 0, bytes);
            buffer
        };
        let fixed = Fixed {
            state: gpu.buffer("state", STATE),
            steps: put("steps", cast_slice(&steps)),
            corrections: put("corrections", cast_slice(&corrections)),
            cameras: put("cameras", cast_slice(&cameras)),
            poses: put("poses", cast_slice(&poses)),
            exposures: put("exposures", cast_slice(&exposures)),
            now: gpu.uniform(&Step::zeroed()),
            pictures,
        };
        gpu.wait()?;
        let mut drawing = Drawing::new(gpu);
        let kernels = Kernels::new(gpu, model.scene.parts(), model.scene.part(), pixels);
        let room = (8 * u64::from(count) + 65_536).min(most_pairs(gpu));
        let finish = gradients.map_or(Finish::Update, Finish::Gradient);
        let iteration = Iteration::new(gpu, &mut drawing, &kernels, &model, &fixed, room as u32, finish);
        gpu.check()?;
        let iteration = iteration.ok_or_else(|| Error::usage("training").expected("a target").found("none"))?;
        let mut run = Run { gpu, drawing, kernels, model, fixed, iteration, steps, done: at.iteration, room, peak: 0 };
        run.stand();
        Ok(run)
    }

    /// Once through all steps, from the first.
    pub fn once(&self) -> Result<State> {
        self.rewind();
        self.receive(&self.send(0, self.steps.len()))
    }

    /// Through all steps, with longer lists until they hold every one.
    pub fn settle(&mut self, gradients: Option<&Gradients>) -> Result<()> {
        loop {
            let state = self.once()?;
            if state.halted == 0 {
                return Ok(());
            }
            self.make_room(state.most_pairs.into(), gradients)?;
        }
    }

    pub fn rewind(&self) {
        self.gpu.queue.write_buffer(&self.fixed.state, 0, bytes_of(&self.state(0)));
    }

    fn state(&self, iteration: u32) -> State {
        State {
            iteration,
            gaussians: self.model.count,
            room: self.room as u32,
            stride: self.model.capacity,
            ..State::zeroed()
        }
    }

    /// Tells the GPU where the run stands.
    fn stand(&mut self) {
        let pictures: u64 = self.fixed.pictures.iter().map(|p| 16 * u64::from(p.width) * u64::from(p.height)).sum();
        let steps = self.steps.len() as u64 * size_of::<Step>() as u64;
        self.peak = self.peak.max(self.model.bytes() + self.iteration.bytes + pictures + steps);
        self.gpu.queue.write_buffer(&self.fixed.state, 0, bytes_of(&self.state(self.done as u32)));
    }

    /// Binds anew, after the model or the room changed.
    fn bind(&mut self, gradients: Option<&Gradients>) -> Result<()> {
        let finish = gradients.map_or(Finish::Update, Finish::Gradient);
        let Run { gpu, drawing, kernels, model, fixed, .. } = self;
        let next = Iteration::new(gpu, drawing, kernels, model, fixed, self.room as u32, finish);
        self.gpu.check()?;
        self.iteration = next.ok_or_else(|| Error::usage("training").expected("a target").found("none"))?;
        self.stand();
        Ok(())
    }

    /// The Gaussians changed in number, or where they stand.
    pub fn resized(&mut self, count: u32) {
        self.model.count = count;
        self.stand();
    }

    /// Iterations up to `end`. False: stopped before by `stop`.
    pub fn iterate(&mut self, end: usize, progress: &dyn Progress, stop: &dyn Fn() -> bool) -> Result<bool> {
        let mut sent = self.done;
        let mut waiting: VecDeque<Sent> = VecDeque::new();
        loop {
            while sent < end && waiting.len() < AHEAD && !stop() {
                let to = (sent + BATCH).min(end);
                waiting.push_back(self.send(sent, to));
                sent = to;
            }
            let Some(next) = waiting.pop_front() else { return Ok(self.done == end) };
            let state = self.receive(&next)?;
            self.done = state.iteration as usize;
            progress.step(self.done as u64);
            if state.halted != 0 {
                // What was sent after it changed nothing.
                for later in waiting.drain(..) {
                    self.receive(&later)?;
                }
                self.make_room(state.most_pairs.into(), None)?;
                sent = self.done;
            } else if self.done != next.end {
                return Err(Error::environment(self.gpu.adapter.name.clone())
                    .expected(format!("{} iterations", next.end))
                    .found(self.done.to_string()));
            }
        }
    }

    fn send(&self, from: usize, to: usize) -> Sent {
        let gpu = self.gpu;
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            for step in &self.steps[from..to] {
                let target = step.words[2] as usize;
                self.iteration.record(&mut pass, target, &self.fixed.pictures[target], step);
            }
        }
        let state = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("state"),
            size: STATE,
            usage: BufferUsages::MAP_READ | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        encoder.copy_buffer_to_buffer(&self.fixed.state, 0, &state, 0, STATE);
        let index = gpu.queue.submit([encoder.finish()]);
        let (say, mapped) = mpsc::channel();
        state.map_async(wgpu::MapMode::Read, .., move |r| {
            // The receiver is gone only if the run failed.
            let _ = say.send(r);
        });
        Sent { end: to, index, state, mapped }
    }

    fn receive(&self, sent: &Sent) -> Result<State> {
        let gpu = self.gpu;
        let failed = |found: String| Error::environment(gpu.adapter.name.clone()).expected("a state").found(found);
        let timeout = Some(Duration::from_secs(600));
        let wait = PollType::Wait { submission_index: Some(sent.index.clone()), timeout };
        let done = gpu.device.poll(wait);
        gpu.check()?;
        done.map_err(|e| failed(e.to_string()))?;
        match sent.mapped.recv_timeout(Duration::from_secs(60)) {
            Ok(Ok(())) => {}
            Ok(Err(e)) => return Err(failed(e.to_string())),
            Err(e) => return Err(failed(e.to_string())),
        }
        let view = sent.state.get_mapped_range(..).map_err(|e| failed(e.to_string()))?;
        Ok(pod_read_unaligned(&view[..STATE as usize]))
    }

    /// Lists for `wanted` pairs and some more.
    fn make_room(&mut self, wanted: u64, gradients: Option<&Gradients>) -> Result<()> {
        let most = most_pairs(self.gpu);
        if wanted > most {
            return Err(Error::environment(self.gpu.adapter.name.clone())
                .expected(format!("at most {most} pairs of tile and Gaussian in training"))
                .found(wanted.to_string())
                .advice("Choose --device cpu, smaller pictures or fewer Gaussians."));
        }
        self.room = (wanted * 3 / 2).min(most);
        self.bind(gradients)
    }

    /// Room for `count` Gaussians and some more.
    pub fn make_capacity(&mut self, count: u32, options: &Options) -> Result<()> {
        let capacity = room_for(self.gpu, count, self.model.count, options);
        self.model = self.model.grown(self.gpu, capacity.max(count))?;
        self.bind(None)
    }

    pub fn checkpoint(&self, intrinsics: &[Camera]) -> Result<Checkpoint> {
        let (gaussians, moments, seen) = self.model.download(self.gpu)?;
        let views = read(self.gpu, &self.fixed.cameras, (intrinsics.len() * size_of::<View>()) as u64)?;
        let views: Vec<View> = bytemuck::pod_collect_to_vec(&views);
        let poses = read(self.gpu, &self.fixed.poses, 64 * intrinsics.len() as u64)?;
        let poses: Vec<[f32; 16]> = bytemuck::pod_collect_to_vec(&poses);
        let exposures = read(self.gpu, &self.fixed.exposures, 160 * intrinsics.len() as u64)?;
        let exposures: Vec<f32> = bytemuck::pod_collect_to_vec(&exposures);
        let (exposures, _) = exposures.as_chunks::<40>();
        Ok(Checkpoint {
            iteration: self.done,
            gaussians,
            moments,
            statistics: crate::splat::train::density::Statistics { seen },
            cameras: intrinsics.iter().zip(&views).map(|(c, v)| v.moved(c)).collect(),
            poses: poses.iter().map(Pose::from_words).collect(),
            exposures: exposures.iter().map(Exposure::from_words).collect(),
        })
    }
}

/// Room for Gaussians: what is needed and what may soon come, never above the cap.
fn room_for(gpu: &Gpu, needed: u32, now: u32, options: &Options) -> u32 {
    let cap = options.density.max_gaussians.min(Scene::most_in_one_chunk(gpu) as usize) as u32;
    let grown = if options.density.until > 0 { needed.saturating_add(needed.max(now) / 2).max(16_384) } else { needed };
    grown.min(cap).max(needed).max(1)
}

fn view(c: &Camera) -> View {
    View::new(c, [0.0; 3], [0, c.height.div_ceil(TILE)], 0, 0)
}

/// Trains from `at` up to iteration `until`.
///
/// Errors: environment, when the adapter fails or is too small.
pub fn advance(
    gpu: &Gpu,
    at: Checkpoint,
    targets: &[Target],
    options: &Options,
    until: usize,
    progress: &dyn Progress,
) -> Result<Advanced> {
    // Growth stops at what the adapter's bindings hold.
    let most = Scene::most_in_one_chunk(gpu) as usize;
    let density = Density { max_gaussians: options.density.max_gaussians.min(most), ..options.density };
    let options = &Options { density, ..*options };
    let cameras = at.cameras.clone();
    let began = Instant::now();
    let mut run = Run::new(gpu, &at, targets, options)?;
    drop(at);
    let setup = began.elapsed().as_secs_f64();
    let stop = || Stop::wanted(options, progress);
    let end = until.min(run.steps.len());
    let mut density = 0.0;
    let mut stopped = None;
    while run.done < end {
        let event = options.next_event(run.done).min(end);
        if !run.iterate(event, progress, &|| stop().is_some())? {
            // A deadline that is past stays past, and so does an interrupt.
            stopped = stop();
            break;
        }
        let clock = Instant::now();
        density::control(&mut run, options)?;
        density += clock.elapsed().as_secs_f64();
    }
    gpu.wait()?;
    let trained = began.elapsed().as_secs_f64() - setup;
    let checkpoint = run.checkpoint(&cameras)?;
    Ok(Advanced {
        checkpoint,
        stopped,
        seconds: crate::splat::train::Seconds { setup, train: trained, density, ..Default::default() },
        peak_bytes: run.peak,
    })
}
