//! One iteration's kernels, bound to their buffers, in the order they run.

use bytemuck::{Pod, Zeroable};
use wgpu::{BindGroup, Buffer, ComputePass, ComputePipeline};

use super::kernels::Kernels;
use super::model::Model;
use super::table::Step as Numbers;
use crate::splat::render::gpu::kernel::{Binding, Size, Step, group};
use crate::splat::render::gpu::plan::{Kernels as Drawing, Plan, Shape, TILE, WayBack};
use crate::splat::render::gpu::{Gpu, PARTS, STAGES};
use crate::splat::train::Target;

/// Where the run stands; shaders/training.wgsl.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct State {
    pub iteration: u32,
    pub halted: u32,
    pub most_pairs: u32,
    pub gaussians: u32,
    pub room: u32,
    pub stride: u32,
    pub pad: [u32; 2],
}

/// A target's picture in GPU memory.
pub struct Picture {
    pub width: u32,
    pub height: u32,
    /// Colour times alpha; alpha, or −1 − alpha where held back. After them how much each pixel counts, four in one, where that is
    /// not 1 everywhere.
    pub wanted: Buffer,
}

impl Picture {
    pub fn upload(gpu: &Gpu, t: &Target) -> Picture {
        let pixel = |i: usize| {
            let (c, a) = (t.color[i], t.alpha[i]);
            let held = t.held_back.as_ref().is_some_and(|h| h[i]);
            [c[0] * a, c[1] * a, c[2] * a, if held { -1.0 - a } else { a }]
        };
        let weights = t.confidence.iter().flat_map(|c| c.chunks(4));
        let four = |c: &[f32]| std::array::from_fn(|k| c.get(k).copied().unwrap_or_default());
        let values: Vec<[f32; 4]> = (0..t.color.len()).map(pixel).chain(weights.map(four)).collect();
        let wanted = gpu.buffer("target", values.len() as u64 * 16);
        gpu.queue.write_buffer(&wanted, 0, bytemuck::cast_slice(&values));
        Picture { width: t.camera.width, height: t.camera.height, wanted }
    }
}

/// Buffers that outlive a change of the lists' room or the Gaussians' number.
pub struct Fixed {
    pub state: Buffer,
    pub steps: Buffer,
    pub corrections: Buffer,
    pub cameras: Buffer,
    pub poses: Buffer,
    /// One a target; shaders/exposure.wgsl.
    pub exposures: Buffer,
    /// The step under way.
    pub now: Buffer,
    pub pictures: Vec<Picture>,
}

/// Gradients of all parameters, planes as the parameters'.
pub struct Gradients {
    pub core: Buffer,
    pub harmonics: Buffer,
    pub mean: Buffer,
}

/// What ends an iteration.
pub enum Finish<'a> {
    /// Adam.
    Update,
    /// The gradients themselves.
    Gradient(&'a Gradients),
}

/// Everything bound.
pub struct Iteration {
    pub plan: Plan,
    /// Translation and rotation, a workgroup of the update.
    #[cfg(test)]
    pub pose_partials: Buffer,
    /// Σ|x − y| and Σ(1 − SSIM) a tile.
    #[cfg(test)]
    pub sums: Buffer,
    /// Three rows a tile of ∂L/∂exposure.
    #[cfg(test)]
    pub tile_changes: Buffer,
    /// ∂L/∂(Σ w rgb), ∂L/∂(final transmittance) a pixel.
    #[cfg(test)]
    pub pulls: Buffer,
    pub bytes: u64,
    begin: Step,
    ssim: Kernel,
    loss_gradient: Kernel,
    raster_backward: Step,
    finish: Step,
    exposure: Step,
    end: Step,
}

/// A kernel with one bind group a target.
struct Kernel {
    pipeline: ComputePipeline,
    groups: Vec<BindGroup>,
}

impl Kernel {
    fn record(&self, pass: &mut ComputePass, target: usize, size: (u32, u32)) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.groups[target], &[]);
        pass.dispatch_workgroups(size.0, size.1, 1);
    }
}

/// Kernels of [`Iteration::record`], in order: drawing's, then these.
pub const BACK_STAGES: [&str; 3] = ["loss", "raster backward", "update"];

impl Iteration {
    pub fn new(
        gpu: &Gpu,
        drawing: &mut Drawing,
        kernels: &Kernels,
        model: &Model,
        fixed: &Fixed,
        room: u32,
        finish: Finish,
    ) -> Option<Iteration> {
        use Binding::Whole;
        let width = fixed.pictures.iter().map(|p| p.width).max()?;
        let height = fixed.pictures.iter().map(|p| p.height).max()?;
        let shape = Shape {
            width,
            height,
            room,
            band: height.div_ceil(TILE),
            depth: false,
            subgroups: gpu.abilities.subgroups,
            training: true,
        };
        let plan = Plan::new(gpu, drawing, &model.scene, shape);
        let WayBack { touched, starts, gaussians, places, records, splats } = plan.way_back.as_ref()?;
        let chunk = &model.scene.chunks[0];
        let pixels = u64::from(width) * u64::from(height);
        let tiles = u64::from(width.div_ceil(TILE) * height.div_ceil(TILE));
        let groups = model.capacity.div_ceil(256).max(1);
        let partials = gpu.buffer("ssim", 36 * pixels);
        let pulls = gpu.buffer("pulls", 16 * pixels);
        let sums = gpu.buffer("loss", 8 * tiles);
        let pose_partials = gpu.buffer("pose", 32 * u64::from(groups));
        let tile_changes = gpu.buffer("exposure", 48 * tiles);
        let step = |kernel: &ComputePipeline, buffers: &[&Buffer], size: Size| {
            let bindings: Vec<_> = buffers.iter().map(|b| Whole(b)).collect();
            Step { kernel: kernel.clone(), groups: vec![group(gpu, kernel, 0, &bindings)], size }
        };
        let per_target = |kernel: &ComputePipeline, last: &[&Buffer]| {
            let one = |p: &Picture| {
                let fixed = [&plan.view, &fixed.now, &plan.picture, &p.wanted];
                let bindings: Vec<_> = fixed.into_iter().chain(last.iter().copied()).map(Whole).collect();
                group(gpu, kernel, 0, &bindings)
            };
            Kernel { pipeline: kernel.clone(), groups: fixed.pictures.iter().map(one).collect() }
        };
        let begin = step(
            &kernels.begin,
            &[
                &fixed.state,
                &fixed.steps,
                &fixed.cameras,
                &fixed.now,
                &plan.view,
                &chunk.place,
                &plan.counts,
                &plan.ranges,
            ],
            Size::Direct(tiles.div_ceil(256) as u32, 1),
        );
        let mut raster_backward = step(
            &kernels.raster_backward,
            &[&plan.view, &plan.ranges, gaussians, places, &plan.picture, &pulls, records],
            Size::Direct(1, 1),
        );
        let all: Vec<_> = (0..PARTS).map(|p| Whole(splats.get(p).unwrap_or(&splats[0]))).collect();
        raster_backward.groups.push(group(gpu, &kernels.raster_backward, 1, &all));
        let collected = [
            &plan.view,
            &chunk.place,
            &fixed.now,
            &plan.counts,
            touched,
            starts,
            records,
            &pose_partials,
            &chunk.core,
            &chunk.harmonics,
        ];
        let (kernel, rest) = match finish {
            Finish::Update => (
                &kernels.update,
                vec![&model.core_moments, &model.harmonics_m, &model.harmonics_v, &model.seen, &fixed.corrections],
            ),
            Finish::Gradient(g) => (&kernels.gradient, vec![&g.core, &g.harmonics, &g.mean]),
        };
        let buffers: Vec<_> = collected.into_iter().chain(rest).collect();
        let finish = step(kernel, &buffers, Size::Direct(groups, 1));
        let end = step(
            &kernels.end,
            &[&fixed.state, &fixed.now, &plan.counts, &pose_partials, &fixed.cameras, &fixed.poses, &fixed.corrections],
            Size::Direct(1, 1),
        );
        let exposure = step(
            &kernels.exposure_step,
            &[&fixed.state, &plan.view, &fixed.now, &plan.counts, &tile_changes, &fixed.exposures, &fixed.corrections],
            Size::Direct(1, 1),
        );
        let ssim = per_target(&kernels.ssim, &[&partials, &sums, &fixed.exposures]);
        let loss_gradient = per_target(&kernels.loss_gradient, &[&partials, &pulls, &fixed.exposures, &tile_changes]);
        let bytes = plan.bytes + 52 * pixels + 56 * tiles + 32 * u64::from(groups);
        Some(Iteration {
            plan,
            #[cfg(test)]
            pose_partials,
            #[cfg(test)]
            sums,
            #[cfg(test)]
            tile_changes,
            #[cfg(test)]
            pulls,
            bytes,
            begin,
            ssim,
            loss_gradient,
            raster_backward,
            finish,
            exposure,
            end,
        })
    }

    pub fn begin(&self, pass: &mut ComputePass) {
        self.begin.record(pass);
    }

    /// Stages of drawing, then [`BACK_STAGES`]; `target` is the number of the target whose turn it is.
    pub fn stage(&self, stage: usize, pass: &mut ComputePass, target: usize, picture: &Picture, numbers: &Numbers) {
        let size = (picture.width.div_ceil(TILE), picture.height.div_ceil(TILE));
        let raster = STAGES.len() - 1;
        match stage {
            s if s < raster => self.plan.record(s, pass),
            s if s == raster => self.plan.record_raster(pass, size),
            s if s == raster + 1 => {
                if numbers.loss[1] != 0.0 {
                    self.ssim.record(pass, target, size);
                }
                self.loss_gradient.record(pass, target, size);
            }
            s if s == raster + 2 => self.raster_backward.record_sized(pass, size),
            _ => {
                self.finish.record(pass);
                if numbers.exposure[0] != 0.0 {
                    self.exposure.record(pass);
                }
                self.end.record(pass);
            }
        }
    }

    /// The whole iteration.
    pub fn record(&self, pass: &mut ComputePass, target: usize, picture: &Picture, numbers: &Numbers) {
        self.begin(pass);
        for stage in 0..STAGES.len() + BACK_STAGES.len() {
            self.stage(stage, pass, target, picture, numbers);
        }
    }
}
