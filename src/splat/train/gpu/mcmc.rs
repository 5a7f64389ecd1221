//! One round of MCMC on the GPU, nothing read back: shaders/mcmc*.wgsl.

use bytemuck::{Pod, Zeroable};

use super::density::{bound, direct, submit};
use super::run::Run;
use super::table::halves;
use crate::Result;
use crate::splat::render::gpu::SCAN_BLOCK;
use crate::splat::render::gpu::kernel::Size;
use crate::splat::train::random::hash;
use crate::splat::train::{Options, mcmc};

/// shaders/mcmc.wgsl.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct Mcmc {
    gaussians: u32,
    stride: u32,
    added: u32,
    unit: u32,
    faintest: f32,
    pad: [u32; 3],
    seed: [u32; 4],
    moving: [[f32; 4]; 2],
}

pub fn relocate(run: &mut Run, options: &Options) -> Result<()> {
    let n = run.model.count;
    let after = mcmc::grown(n as usize, &options.density) as u32;
    if after > run.model.capacity {
        run.make_capacity(after, options)?;
    }
    let gpu = run.gpu;
    let [low, high] = halves(hash(options.seed ^ hash(run.done as u64)));
    let uniform = gpu.uniform(&Mcmc {
        gaussians: n,
        stride: run.model.capacity,
        added: after - n,
        unit: (u32::MAX / n.max(1)).min(65_535),
        faintest: options.density.prune_opacity,
        pad: [0; 3],
        seed: [low, high, 0, 0],
        moving: options.moving.words(),
    });
    let words = |label: &str, count: u32| gpu.buffer(label, 4 * u64::from(count));
    let block_count = n.div_ceil(SCAN_BLOCK);
    let blocks = words("blocks", 2 * block_count);
    let [chosen, running, dead] = ["chosen", "running", "dead"].map(|l| words(l, n));
    // Everyone dead at once, and the added.
    let drawn = words("drawn", after);
    let totals = words("totals", 2);
    let (k, m) = (&run.kernels, &run.model);
    let chunk = &m.scene.chunks[0];
    let over_blocks = Size::Direct(block_count.max(1), 1);
    submit(
        gpu,
        &[
            bound(gpu, &k.mcmc_count, &[&uniform, &chunk.core, &blocks, &chosen], over_blocks.clone()),
            bound(gpu, &k.mcmc_scan, &[&uniform, &blocks, &totals], Size::Direct(1, 1)),
            bound(gpu, &k.mcmc_place, &[&uniform, &chunk.core, &blocks, &running, &dead], over_blocks),
            bound(gpu, &k.mcmc_draw, &[&uniform, &totals, &running, &chosen, &drawn], direct(after)),
            bound(
                gpu,
                &k.mcmc_share_out,
                &[&uniform, &chosen, &chunk.core, &m.core_moments, &m.harmonics_m, &m.harmonics_v],
                direct(n),
            ),
            bound(
                gpu,
                &k.mcmc_copy,
                &[
                    &uniform,
                    &totals,
                    &dead,
                    &drawn,
                    &chunk.core,
                    &chunk.harmonics,
                    &m.core_moments,
                    &m.harmonics_m,
                    &m.harmonics_v,
                ],
                direct(after),
            ),
        ],
    );
    run.resized(after);
    gpu.check()
}
