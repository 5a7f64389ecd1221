//! Pictures read back as bytes: a quarter of the floats.

use wgpu::{Buffer, ComputePipeline};

use super::buffers::{MOST_GROUPS, Scene};
use super::device::Gpu;
use super::forward::Renderer;
use super::kernel::{Binding, Size, Step, compile, group, read};
use crate::splat::Camera;
use crate::{Error, Result};

/// Pixels of a workgroup; shaders/bytes.wgsl.
const GROUP: u32 = 256;

/// The kernel, and what it writes into.
pub struct ToBytes {
    kernel: ComputePipeline,
    /// For so many pixels.
    out: Option<(u32, Buffer)>,
}

impl ToBytes {
    pub fn new(gpu: &Gpu) -> ToBytes {
        ToBytes { kernel: compile(gpu, "bytes", include_str!("../../../../shaders/bytes.wgsl"), &[]), out: None }
    }

    /// The bytes of `pixels` pixels of a picture of floats.
    fn of(&mut self, gpu: &Gpu, picture: &Buffer, pixels: u32) -> Result<Vec<[u8; 4]>> {
        if pixels.div_ceil(GROUP) > MOST_GROUPS {
            return Err(Error::environment(gpu.adapter.name.clone())
                .expected(format!("at most {} pixels a picture", MOST_GROUPS * GROUP))
                .found(pixels.to_string()));
        }
        let out = match self.out.take().filter(|(room, _)| *room >= pixels) {
            Some(kept) => kept,
            None => (pixels, gpu.buffer("bytes", 4 * u64::from(pixels))),
        };
        let size = gpu.uniform(&[pixels, 0, 0, 0]);
        let bindings = [&size, picture, &out.1].map(Binding::Whole);
        let step = Step {
            kernel: self.kernel.clone(),
            groups: vec![group(gpu, &self.kernel, 0, &bindings)],
            size: Size::Direct(pixels.div_ceil(GROUP), 1),
        };
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        step.record(&mut encoder.begin_compute_pass(&Default::default()));
        gpu.queue.submit([encoder.finish()]);
        let read = read(gpu, &out.1, 4 * u64::from(pixels))?;
        self.out = Some(out);
        Ok(bytemuck::pod_collect_to_vec(&read))
    }
}

impl Renderer<'_> {
    /// Draws one picture over nothing, its colours times their α, and reads it back as bytes: those that
    /// [`super::super::to_bytes`] makes of [`Renderer::render`]'s.
    ///
    /// Errors: as [`Renderer::render`].
    pub fn render_bytes(&mut self, scene: &Scene, camera: &Camera) -> Result<Vec<[u8; 4]>> {
        self.draw_until_drawn(scene, camera, [0.0; 3])?;
        let gpu = self.gpu;
        let mut to_bytes = self.to_bytes.take().unwrap_or_else(|| ToBytes::new(gpu));
        let Some((picture, pixels)) = self.picture() else {
            return Err(Error::usage("picture").expected("a drawn picture").found("none"));
        };
        let bytes = to_bytes.of(gpu, picture, pixels);
        self.to_bytes = Some(to_bytes);
        bytes
    }
}
