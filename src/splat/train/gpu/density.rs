//! Density control on the GPU, between batches of iterations: shaders/refine*.wgsl.

use bytemuck::{Pod, Zeroable, pod_read_unaligned};
use wgpu::{Buffer, ComputePipeline};

use super::mcmc;
use super::run::Run;
use super::table::halves;
use crate::Result;
use crate::splat::render::gpu::kernel::{Binding, Size, Step, group, read};
use crate::splat::render::gpu::sort::{self, First, Request};
use crate::splat::render::gpu::{Gpu, SCAN_BLOCK};
use crate::splat::train::random::hash;
use crate::splat::train::{Options, Strategy};

/// shaders/refine.wgsl.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct Refine {
    gaussians: u32,
    stride: u32,
    most: u32,
    after: u32,
    threshold: f32,
    split_size: f32,
    faintest: f32,
    ceiling: f32,
    seed: [u32; 4],
    moving: [[f32; 4]; 2],
}

fn logit(p: f32) -> f32 {
    (p / (1.0 - p)).ln()
}

/// What is due after the iterations done.
pub fn control(run: &mut Run, options: &Options) -> Result<()> {
    if options.refines_after(run.done) {
        match options.density.strategy {
            Strategy::Paper => refine(run, options)?,
            Strategy::Mcmc => mcmc::relocate(run, options)?,
        }
    }
    if options.resets_after(run.done) {
        let parameters = run.gpu.uniform(&parameters(run, options));
        let buffers = [&parameters, &run.model.scene.chunks[0].core, &run.model.core_moments];
        submit(run.gpu, &[bound(run.gpu, &run.kernels.opacity_reset, &buffers, direct(run.model.count))]);
    }
    run.gpu.check()
}

fn parameters(run: &Run, options: &Options) -> Refine {
    let (d, n) = (&options.density, run.model.count);
    let room = d.max_gaussians.saturating_sub(n as usize);
    Refine {
        gaussians: n,
        stride: run.model.capacity,
        most: room.min((n as f32 * d.growth) as usize) as u32,
        after: 0,
        threshold: d.gradient,
        split_size: d.split_scale * options.scene_extent,
        faintest: logit(d.prune_opacity),
        ceiling: logit(2.0 * d.prune_opacity),
        seed: {
            let [a, b] = halves(hash(options.seed ^ hash(run.done as u64)));
            [a, b, 0, 0]
        },
        moving: options.moving.words(),
    }
}

pub fn direct(threads: u32) -> Size {
    Size::Direct(threads.div_ceil(256).max(1), 1)
}

pub fn bound(gpu: &Gpu, kernel: &ComputePipeline, buffers: &[&Buffer], size: Size) -> Step {
    let bindings: Vec<_> = buffers.iter().map(|b| Binding::Whole(b)).collect();
    Step { kernel: kernel.clone(), groups: vec![group(gpu, kernel, 0, &bindings)], size }
}

pub fn submit(gpu: &Gpu, steps: &[Step]) {
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        steps.iter().for_each(|s| s.record(&mut pass));
    }
    gpu.queue.submit([encoder.finish()]);
}

fn refine(run: &mut Run, options: &Options) -> Result<()> {
    let gpu = run.gpu;
    let n = run.model.count;
    let mut numbers = parameters(run, options);
    let uniform = gpu.uniform(&numbers);
    // Every Gaussian and, at most, each once more.
    let most = u64::from(n) + u64::from(numbers.most.min(n));
    let words = |label: &str, count: u64| gpu.buffer(label, 4 * count);
    let [keys_a, keys_b, order_a, order_b, kinds] =
        ["keys", "keys", "order", "order", "kinds"].map(|l| words(l, n.into()));
    let [counts, items] = ["counts", "items"].map(|l| words(l, 8));
    let dispatches = words("dispatches", 12);
    let table = gpu.buffer("radix table", sort::table_bytes(n.into()));
    let digits = words("radix digits", 256);
    let block_sums = words("block sums", most.div_ceil(SCAN_BLOCK.into()));
    // A split leaves two and takes one away.
    let sources = words("sources", most);
    gpu.queue.write_buffer(&counts, 28, &n.to_le_bytes());
    let k = &run.kernels;
    let core = &run.model.scene.chunks[0].core;
    let indirect = |i: u64| Size::Indirect(dispatches.clone(), 12 * i);
    let by_pull = run.kernels.radix.prepare(
        gpu,
        &Request {
            keys: [&keys_a, &keys_b],
            values: [&order_a, &order_b],
            counts: &counts,
            slot: 3,
            size: indirect(0),
            table: &table,
            digits: &digits,
            bits: 31,
            first: Some(First { slot: 7, size: Size::Direct(n.div_ceil(sort::BLOCK).max(1), 1) }),
        },
    );
    let order = if sort::passes(31).is_multiple_of(2) { &order_a } else { &order_b };
    let before = [
        bound(gpu, &k.refine_mark, &[&uniform, &run.model.seen, &keys_a, &kinds, &counts, core], direct(n)),
        bound(gpu, &k.refine_plan, &[&uniform, &counts, &items, &dispatches], Size::Direct(1, 1)),
    ];
    let after = [
        bound(gpu, &k.refine_choose, &[&uniform, &items, order, core, &kinds], indirect(1)),
        bound(gpu, &k.refine_count, &[&uniform, &items, order, core, &kinds, &block_sums], indirect(2)),
        bound(gpu, &k.scan_blocks, &[&items, &block_sums], Size::Direct(1, 1)),
        bound(gpu, &k.refine_place, &[&uniform, &items, order, core, &kinds, &block_sums, &sources], indirect(2)),
    ];
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        before.iter().for_each(|s| s.record(&mut pass));
        by_pull.record(&mut pass);
        after.iter().for_each(|s| s.record(&mut pass));
    }
    gpu.queue.submit([encoder.finish()]);
    let after: u32 = pod_read_unaligned(&read(gpu, &items, 4)?);
    if after > run.model.capacity {
        run.make_capacity(after, options)?;
    }

    numbers.after = after;
    numbers.stride = run.model.capacity;
    gpu.queue.write_buffer(&uniform, 0, bytemuck::bytes_of(&numbers));
    if after > 0 {
        rearrange(run, &sources, after);
        let core = &run.model.scene.chunks[0].core;
        submit(gpu, &[bound(gpu, &run.kernels.refine_split, &[&uniform, &sources, core], direct(after))]);
    }
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    encoder.clear_buffer(&run.model.seen, 0, None);
    gpu.queue.submit([encoder.finish()]);
    run.resized(after);
    Ok(())
}

/// Every plane in the order of `sources`, by way of a plane beside them.
fn rearrange(run: &Run, sources: &Buffer, after: u32) {
    let gpu = run.gpu;
    let stride = run.model.capacity;
    let beside = gpu.buffer("plane", 16 * u64::from(after));
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    for (buffer, planes, fresh) in run.model.planes() {
        for p in 0..planes {
            let plane = gpu.uniform(&[after, p * stride, u32::from(fresh), 0]);
            let step = bound(gpu, &run.kernels.gather, &[&plane, sources, buffer, &beside], direct(after));
            step.record(&mut encoder.begin_compute_pass(&Default::default()));
            let to = 16 * u64::from(p) * u64::from(stride);
            encoder.copy_buffer_to_buffer(&beside, 0, buffer, to, 16 * u64::from(after));
        }
    }
    gpu.queue.submit([encoder.finish()]);
}
