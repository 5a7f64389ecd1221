//! The kernels of training, compiled.

use wgpu::ComputePipeline;

use crate::splat::render::gpu::Gpu;
use crate::splat::render::gpu::kernel::compile;
use crate::splat::render::gpu::sort::Radix;

macro_rules! sources {
    ($($name:literal),*) => { concat!($(include_str!(concat!("../../../../shaders/", $name, ".wgsl"))),*) };
}

pub struct Kernels {
    pub radix: Radix,
    pub begin: ComputePipeline,
    pub ssim: ComputePipeline,
    pub loss_gradient: ComputePipeline,
    pub raster_backward: ComputePipeline,
    pub update: ComputePipeline,
    pub gradient: ComputePipeline,
    pub end: ComputePipeline,
    pub exposure_step: ComputePipeline,
    pub refine_mark: ComputePipeline,
    pub refine_plan: ComputePipeline,
    pub refine_choose: ComputePipeline,
    pub refine_count: ComputePipeline,
    pub scan_blocks: ComputePipeline,
    pub refine_place: ComputePipeline,
    pub gather: ComputePipeline,
    pub refine_split: ComputePipeline,
    pub opacity_reset: ComputePipeline,
    pub mcmc_count: ComputePipeline,
    pub mcmc_scan: ComputePipeline,
    pub mcmc_place: ComputePipeline,
    pub mcmc_draw: ComputePipeline,
    pub mcmc_share_out: ComputePipeline,
    pub mcmc_copy: ComputePipeline,
}

/// How the rasteriser's way back is cut: pixels a thread, or None where only the kernel without subgroups will do.
fn pixels_a_thread(gpu: &Gpu, wanted: u32) -> Option<u32> {
    let lanes = gpu.abilities.lanes;
    let memory = |pixels: u32| {
        let groups = 256 / pixels / lanes;
        // Sums of nine and a list for 32 splats a subgroup, the splats, the rest.
        groups * (32 * 10 + 1) * 4 + 32 * 52 + 16
    };
    let mut pixels = wanted.clamp(1, 256 / lanes.max(1));
    // A batch of 32 splats is fetched by one thread each.
    while gpu.abilities.subgroups && pixels * lanes.max(32) <= 256 {
        if memory(pixels) <= gpu.adapter.workgroup_memory {
            return Some(pixels);
        }
        pixels *= 2;
    }
    None
}

impl Kernels {
    /// `parts`, `part`: how the projected Gaussians are split over bindings. `pixels`: pixels a thread on the
    /// rasteriser's way back, where there are subgroups; 0 does without subgroups.
    pub fn new(gpu: &Gpu, parts: usize, part: u32, pixels: u32) -> Kernels {
        let split = [("PARTS", parts as f64), ("PART", f64::from(part))];
        let raster_backward = match pixels_a_thread(gpu, pixels).filter(|_| pixels > 0) {
            Some(pixels) => {
                let lanes = gpu.abilities.lanes;
                let threads = 256 / pixels;
                let groups = threads / lanes;
                let head = format!(
                    "const PIXELS: u32 = {pixels}u;\nconst THREADS: u32 = {threads}u;\nconst GROUPS: u32 = {groups}u;\n\
                     const LANES: u32 = {lanes}u;\n"
                );
                let source = sources!("view", "splats", "pixels", "records", "pull", "raster_backward_subgroup");
                compile(gpu, "raster_backward_subgroup", &(head + source), &split)
            }
            None => {
                let source = sources!("view", "splats", "records", "pull", "raster_backward_shared");
                compile(gpu, "raster_backward_shared", source, &split)
            }
        };
        let plain = |label: &str, source: &str| compile(gpu, label, source, &[]);
        Kernels {
            radix: Radix::new(gpu),
            begin: plain("begin", sources!("view", "region", "training", "chunk", "begin")),
            ssim: plain(
                "ssim",
                sources!("view", "region", "training", "exposure", "hash", "backdrop", "window", "weights", "ssim"),
            ),
            loss_gradient: plain(
                "loss_gradient",
                sources!(
                    "view",
                    "region",
                    "training",
                    "exposure",
                    "hash",
                    "backdrop",
                    "window",
                    "weights",
                    "loss_gradient"
                ),
            ),
            raster_backward,
            update: plain(
                "update",
                sources!(
                    "view",
                    "region",
                    "training",
                    "chunk",
                    "rotation",
                    "geometry",
                    "harmonics",
                    "records",
                    "project_backward",
                    "collect",
                    "hash",
                    "normals",
                    "pose_sum",
                    "update"
                ),
            ),
            gradient: plain(
                "gradient",
                sources!(
                    "view",
                    "region",
                    "training",
                    "chunk",
                    "rotation",
                    "geometry",
                    "harmonics",
                    "records",
                    "project_backward",
                    "collect",
                    "pose_sum",
                    "gradient"
                ),
            ),
            end: plain("end", sources!("view", "region", "training", "end")),
            exposure_step: plain("exposure_step", sources!("view", "region", "training", "exposure", "exposure_step")),
            refine_mark: plain("refine_mark", sources!("view", "region", "refine", "refine_mark")),
            refine_plan: plain("refine_plan", sources!("blocks", "region", "refine", "refine_plan")),
            refine_choose: plain("refine_choose", sources!("region", "refine", "refine_choose")),
            refine_count: plain("refine_count", sources!("blocks", "region", "refine", "refine_items", "refine_count")),
            scan_blocks: plain("scan_blocks", sources!("blocks", "scan_blocks")),
            refine_place: plain("refine_place", sources!("blocks", "region", "refine", "refine_items", "refine_place")),
            gather: plain("gather", sources!("gather")),
            refine_split: plain(
                "refine_split",
                sources!("region", "refine", "rotation", "hash", "normals", "refine_split"),
            ),
            opacity_reset: plain("opacity_reset", sources!("region", "refine", "opacity_reset")),
            mcmc_count: plain("mcmc_count", sources!("blocks", "region", "mcmc", "mcmc_share", "mcmc_count")),
            mcmc_scan: plain("mcmc_scan", sources!("blocks", "region", "mcmc", "mcmc_scan")),
            mcmc_place: plain("mcmc_place", sources!("blocks", "region", "mcmc", "mcmc_share", "mcmc_place")),
            mcmc_draw: plain("mcmc_draw", sources!("region", "mcmc", "hash", "mcmc_draw")),
            mcmc_share_out: plain("mcmc_share_out", sources!("region", "mcmc", "mcmc_share_out")),
            mcmc_copy: plain("mcmc_copy", sources!("region", "mcmc", "mcmc_copy")),
        }
    }
}
