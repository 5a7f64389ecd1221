//! Drawing pictures: records a plan's kernels, watches that its lists were long enough, reads the result back.

use wgpu::{Buffer, BufferUsages};

use super::buffers::{MOST_GROUPS, Scene};
use super::bytes::ToBytes;
use super::device::Gpu;
use super::kernel::read;
use super::plan::{ALL, COUNTS, Kernels, Plan, RANGE_BLOCK, Shape, TILE, View};
use crate::splat::Camera;
use crate::splat::render::{Frame, Shown, unit};
use crate::{Error, Result};

/// The stages of a picture, in order.
pub const STAGES: [&str; 6] = ["project", "sort by depth", "pairs", "sort by tile", "ranges", "raster"];
/// Bands that may be drawn before [`Renderer::settle`] must look at them.
const LOG: u64 = 4096;
/// Room for pairs over what was last wanted.
const SLACK: f64 = 1.25;

/// GPU time of one picture, milliseconds, by timestamp queries.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Timing {
    pub stages: [f64; STAGES.len()],
    /// From the first stage's start to the last one's end.
    pub total: f64,
}

/// What one picture needed, as the GPU counted it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counted {
    /// Gaussians in the picture.
    pub seen: u32,
    /// (tile, Gaussian) pairs; u32::MAX when more.
    pub pairs: u32,
    /// Whether the lists held them. If not, nothing was drawn.
    pub drawn: bool,
}

/// Draws scenes on one GPU. Lists are kept from picture to picture and grow when a picture did not fit.
pub struct Renderer<'a> {
    pub(super) gpu: &'a Gpu,
    kernels: Kernels,
    /// Compiled when it is first asked for.
    pub(super) to_bytes: Option<ToBytes>,
    plan: Option<Plan>,
    /// Number of pairs the last overflow asked for.
    room: u64,
    /// Into how many bands the picture is cut.
    bands: u32,
    /// Largest list of pairs, in pairs.
    most: u64,
    log: Buffer,
    logged: u64,
    queries: Option<(wgpu::QuerySet, Buffer)>,
    /// Colour only: no depth is computed.
    pub depth: bool,
    /// False keeps to kernels without subgroup operations.
    pub subgroups: bool,
}

/// Pairs that one binding holds and one dispatch reaches.
fn most_pairs(gpu: &Gpu) -> u64 {
    (gpu.adapter.largest_binding / 4).min(u64::from(MOST_GROUPS * RANGE_BLOCK))
}

impl<'a> Renderer<'a> {
    pub fn new(gpu: &'a Gpu) -> Result<Self> {
        let queries = gpu.abilities.timestamps.then(|| {
            let set = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("stages"),
                ty: wgpu::QueryType::Timestamp,
                count: 2 * STAGES.len() as u32,
            });
            let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("stages"),
                size: 16 * STAGES.len() as u64,
                usage: BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            });
            (set, buffer)
        });
        let renderer = Renderer {
            kernels: Kernels::new(gpu),
            to_bytes: None,
            plan: None,
            room: 0,
            bands: 1,
            most: most_pairs(gpu),
            log: gpu.buffer("log", LOG * COUNTS * 4),
            logged: 0,
            queries,
            depth: true,
            subgroups: gpu.abilities.subgroups,
            gpu,
        };
        gpu.check()?;
        Ok(renderer)
    }

    /// Allows lists of at most `pairs` pairs, below what the adapter could bind: larger pictures are cut into bands.
    pub fn limit_pairs(&mut self, pairs: u64) {
        self.most = pairs.min(most_pairs(self.gpu));
        self.plan = None;
    }

    /// Bytes of the lists and the picture, without the scene.
    pub fn bytes(&self) -> u64 {
        self.plan.as_ref().map_or(0, |p| p.bytes)
    }

    /// Draws one picture and reads it back; draws again with longer lists until they hold it.
    ///
    /// The same picture as [`super::super::render`] with the same background.
    /// Errors: usage for a camera without pixels; environment when the adapter fails or is too small.
    pub fn render(&mut self, scene: &Scene, camera: &Camera, background: [f32; 3]) -> Result<Frame> {
        self.draw_until_drawn(scene, camera, background)?;
        self.frame()
    }

    /// Draws with longer lists until they hold the picture.
    pub(super) fn draw_until_drawn(&mut self, scene: &Scene, camera: &Camera, background: [f32; 3]) -> Result<()> {
        loop {
            self.draw(scene, camera, background)?;
            if self.settle()?.iter().all(|c| c.drawn) {
                return Ok(());
            }
        }
    }

    /// The floats of the picture drawn last, on the GPU, and how many pixels there are.
    pub(super) fn picture(&self) -> Option<(&Buffer, u32)> {
        self.plan.as_ref().map(|p| (&p.picture, p.shape.width * p.shape.height))
    }

    /// The surface's normal at every pixel; the same as [`super::super::normals`].
    ///
    /// Errors: as [`Renderer::render`].
    pub fn normals(&mut self, scene: &Scene, camera: &Camera) -> Result<Vec<[f32; 3]>> {
        loop {
            self.submit(scene, camera, [0.0; 3], Shown::Normals, false)?;
            if self.settle()?.iter().all(|c| c.drawn) {
                break;
            }
        }
        let frame = self.frame()?;
        Ok(unit(&frame.color, &frame.alpha))
    }

    /// Submits one picture and does not wait. Before its result is used, [`Renderer::settle`] must say that it was
    /// drawn. All pictures of one renderer are drawn into the same memory, one after the other.
    pub fn draw(&mut self, scene: &Scene, camera: &Camera, background: [f32; 3]) -> Result<()> {
        self.submit(scene, camera, background, Shown::Color, false)
    }

    /// Draws one picture and waits for its times. None where the adapter has no timestamps or did not draw it.
    pub fn time(&mut self, scene: &Scene, camera: &Camera, background: [f32; 3]) -> Result<Option<Timing>> {
        self.settle()?;
        self.submit(scene, camera, background, Shown::Color, true)?;
        let Some((_, buffer)) = self.queries.as_ref().filter(|_| self.bands == 1) else { return Ok(None) };
        let ticks: Vec<u64> = bytemuck::pod_collect_to_vec(&read(self.gpu, buffer, 16 * STAGES.len() as u64)?);
        if !self.settle()?.iter().all(|c| c.drawn) {
            return Ok(None);
        }
        let ms = |a: u64, b: u64| b.wrapping_sub(a) as f64 * f64::from(self.gpu.queue.get_timestamp_period()) * 1e-6;
        let stages = std::array::from_fn(|s| ms(ticks[2 * s], ticks[2 * s + 1]));
        Ok(Some(Timing { stages, total: ms(ticks[0], ticks[2 * STAGES.len() - 1]) }))
    }

    /// Waits for all pictures submitted since the last call: what each band of each needed, in order. Where one was
    /// not drawn, the lists are longer from here on.
    pub fn settle(&mut self) -> Result<Vec<Counted>> {
        if self.logged == 0 {
            return Ok(Vec::new());
        }
        let bytes = read(self.gpu, &self.log, self.logged * COUNTS * 4)?;
        self.logged = 0;
        let words: Vec<[u32; COUNTS as usize]> = bytemuck::pod_collect_to_vec(&bytes);
        let counted: Vec<_> = words.iter().map(|w| Counted { seen: w[0], pairs: w[6], drawn: w[5] == 0 }).collect();
        if let Some(wanted) = counted.iter().filter(|c| !c.drawn).map(|c| c.pairs).max() {
            self.grow(wanted)?;
        }
        Ok(counted)
    }

    /// Makes room for `wanted` pairs, in one band or in several.
    fn grow(&mut self, wanted: u32) -> Result<()> {
        let Some(shape) = self.plan.as_ref().map(|p| p.shape) else { return Ok(()) };
        self.plan = None;
        if u64::from(wanted) <= self.most {
            self.room = ((f64::from(wanted) * SLACK) as u64).min(self.most);
        } else if shape.band > 1 {
            self.room = self.most;
            self.bands *= 2;
        } else {
            return Err(Error::environment(self.gpu.adapter.name.clone())
                .expected(format!("at most {} Gaussians over tiles in one row of tiles", self.most))
                .found(format!("{wanted}"))
                .advice("Choose --device cpu, or a narrower picture."));
        }
        Ok(())
    }

    fn shape(&self, scene: &Scene, camera: &Camera) -> Shape {
        let rows = camera.height.div_ceil(TILE);
        // Before anything was counted: a few tiles a Gaussian.
        let guess = 2 * u64::from(scene.count) + 65_536;
        Shape {
            width: camera.width,
            height: camera.height,
            room: self.room.max(guess).min(self.most).min(u32::MAX.into()) as u32,
            band: rows.div_ceil(self.bands),
            depth: self.depth,
            subgroups: self.subgroups && self.gpu.abilities.subgroups,
            training: false,
        }
    }

    fn submit(
        &mut self,
        scene: &Scene,
        camera: &Camera,
        background: [f32; 3],
        shown: Shown,
        timed: bool,
    ) -> Result<()> {
        let pixels = u64::from(camera.width) * u64::from(camera.height);
        if pixels == 0 {
            return Err(Error::usage("camera").expected("at least one pixel").found("none"));
        }
        if pixels * 16 > self.gpu.adapter.largest_binding || camera.width.div_ceil(TILE) > MOST_GROUPS {
            return Err(Error::environment(self.gpu.adapter.name.clone())
                .expected(format!("at most {} pixels a picture", self.gpu.adapter.largest_binding / 16))
                .found(format!("{} × {}", camera.width, camera.height))
                .advice("Choose a smaller picture or --device cpu."));
        }
        let shape = self.shape(scene, camera);
        let rows = camera.height.div_ceil(TILE);
        if self.logged + u64::from(self.bands) > LOG {
            return Err(Error::usage("draw").expected("settle() at least every 4,096 pictures").found("none"));
        }
        let plan = match self.plan.take() {
            Some(plan) if plan.shape == shape && plan.scene == scene.id => plan,
            _ => {
                let plan = Plan::new(self.gpu, &mut self.kernels, scene, shape);
                self.gpu.check()?;
                plan
            }
        };
        let gpu = self.gpu;
        for first in (0..rows).step_by(shape.band as usize) {
            let end = (first + shape.band).min(rows);
            let view = View::new(camera, background, [first, end], scene.count, shape.room);
            let view = if shown == Shown::Normals { view.of_normals() } else { view };
            gpu.queue.write_buffer(&plan.view, 0, bytemuck::bytes_of(&view));
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            encoder.clear_buffer(&plan.counts, 0, Some(4 * ALL));
            encoder.clear_buffer(&plan.ranges, 0, None);
            let queries = self.queries.as_ref().filter(|_| timed);
            for stage in 0..STAGES.len() {
                let timestamp_writes = queries.map(|(query_set, _)| wgpu::ComputePassTimestampWrites {
                    query_set,
                    beginning_of_pass_write_index: Some(2 * stage as u32),
                    end_of_pass_write_index: Some(2 * stage as u32 + 1),
                });
                let mut pass =
                    encoder.begin_compute_pass(&wgpu::ComputePassDescriptor { label: None, timestamp_writes });
                plan.record(stage, &mut pass);
            }
            if let Some((set, buffer)) = queries {
                encoder.resolve_query_set(set, 0..2 * STAGES.len() as u32, buffer, 0);
            }
            encoder.copy_buffer_to_buffer(&plan.counts, 0, &self.log, self.logged * COUNTS * 4, COUNTS * 4);
            self.logged += 1;
            gpu.queue.submit([encoder.finish()]);
        }
        self.plan = Some(plan);
        gpu.check()
    }

    /// The picture drawn last.
    pub fn frame(&self) -> Result<Frame> {
        let Some(plan) = &self.plan else {
            return Err(Error::usage("picture").expected("a drawn picture").found("none"));
        };
        let pixels = plan.shape.width as usize * plan.shape.height as usize;
        let bytes = read(self.gpu, &plan.picture, 16 * pixels as u64)?;
        let rgba: &[[f32; 4]] = bytemuck::cast_slice(&bytes);
        let depths = if self.depth { read(self.gpu, &plan.depths, 8 * pixels as u64)? } else { vec![0; 8 * pixels] };
        let depths: &[[f32; 2]] = bytemuck::cast_slice(&depths);
        Ok(Frame {
            width: plan.shape.width as usize,
            height: plan.shape.height as usize,
            color: rgba.iter().map(|p| [p[0], p[1], p[2]]).collect(),
            alpha: rgba.iter().map(|p| p[3]).collect(),
            depth: depths.iter().map(|d| d[0]).collect(),
            median_depth: depths.iter().map(|d| d[1]).collect(),
        })
    }
}
