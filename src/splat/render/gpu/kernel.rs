//! Compiling kernels, binding buffers to them, reading buffers back.

use std::sync::mpsc;
use std::time::Duration;

use wgpu::{BindGroup, Buffer, BufferAddress, ComputePass, ComputePipeline};

use super::device::Gpu;
use crate::{Error, Result};

/// What stands at one binding; bindings are numbered in the order given.
#[derive(Clone, Copy)]
pub enum Binding<'a> {
    Whole(&'a Buffer),
    /// Buffer, offset, bytes.
    Part(&'a Buffer, u64, u64),
}

/// Compiles the entry point `main`; a kernel that does not compile shows in [`Gpu::check`].
pub fn compile(gpu: &Gpu, label: &str, source: &str, constants: &[(&str, f64)]) -> ComputePipeline {
    let descriptor =
        wgpu::ShaderModuleDescriptor { label: Some(label), source: wgpu::ShaderSource::Wgsl(source.into()) };
    let checks = wgpu::ShaderRuntimeChecks { force_loop_bounding: false, ..wgpu::ShaderRuntimeChecks::checked() };
    // SAFETY: without loop bounding an endless loop is undefined behaviour. Every loop in shaders/ counts an integer
    // up to a bound that does not change inside it. Bounds checks stay on.
    let module = unsafe { gpu.device.create_shader_module_trusted(descriptor, checks) };
    gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(label),
        layout: None,
        module: &module,
        entry_point: Some("main"),
        compilation_options: wgpu::PipelineCompilationOptions {
            constants,
            // Every kernel writes workgroup memory before it reads it.
            zero_initialize_workgroup_memory: false,
        },
        cache: gpu.kept.as_ref().map(|k| &k.cache),
    })
}

/// Binds to group `index` of the kernel.
pub fn group(gpu: &Gpu, kernel: &ComputePipeline, index: u32, bindings: &[Binding]) -> BindGroup {
    let entries: Vec<_> = bindings
        .iter()
        .enumerate()
        .map(|(i, b)| wgpu::BindGroupEntry {
            binding: i as u32,
            resource: wgpu::BindingResource::Buffer(match b {
                Binding::Whole(buffer) => buffer.as_entire_buffer_binding(),
                Binding::Part(buffer, offset, size) => {
                    wgpu::BufferBinding { buffer, offset: *offset, size: wgpu::BufferSize::new(*size) }
                }
            }),
        })
        .collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &kernel.get_bind_group_layout(index),
        entries: &entries,
    })
}

/// How many workgroups.
#[derive(Clone, Debug)]
pub enum Size {
    Direct(u32, u32),
    /// Three words at this byte offset.
    Indirect(Buffer, BufferAddress),
}

/// A kernel with all that it needs to run.
pub struct Step {
    pub kernel: ComputePipeline,
    pub groups: Vec<BindGroup>,
    pub size: Size,
}

impl Step {
    fn bind(&self, pass: &mut ComputePass) {
        pass.set_pipeline(&self.kernel);
        for (i, g) in self.groups.iter().enumerate() {
            pass.set_bind_group(i as u32, g, &[]);
        }
    }

    /// With so many workgroups instead of its own number.
    pub fn record_sized(&self, pass: &mut ComputePass, groups: (u32, u32)) {
        self.bind(pass);
        pass.dispatch_workgroups(groups.0, groups.1, 1);
    }

    pub fn record(&self, pass: &mut ComputePass) {
        self.bind(pass);
        match &self.size {
            Size::Direct(x, y) => pass.dispatch_workgroups(*x, *y, 1),
            Size::Indirect(buffer, offset) => pass.dispatch_workgroups_indirect(buffer, *offset),
        }
    }
}

/// The first `bytes` of a buffer, once everything submitted before is done.
pub fn read(gpu: &Gpu, buffer: &Buffer, bytes: u64) -> Result<Vec<u8>> {
    let staging = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("read back"),
        size: bytes.next_multiple_of(4),
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    encoder.copy_buffer_to_buffer(buffer, 0, &staging, 0, bytes.next_multiple_of(4));
    gpu.queue.submit([encoder.finish()]);
    let (say, hear) = mpsc::channel();
    staging.map_async(wgpu::MapMode::Read, .., move |r| {
        // The receiver is gone only if waiting failed, which is reported there.
        let _ = say.send(r);
    });
    gpu.wait()?;
    let failed = |found: String| Error::environment(gpu.adapter.name.clone()).expected("a read back").found(found);
    // Another thread's wait may be what calls back, a moment after ours has ended.
    match hear.recv_timeout(Duration::from_secs(60)) {
        Ok(Ok(())) => {}
        Ok(Err(e)) => return Err(failed(e.to_string())),
        Err(e) => return Err(failed(e.to_string())),
    }
    let view = staging.get_mapped_range(..).map_err(|e| failed(e.to_string()))?;
    Ok(view[..bytes as usize].to_vec())
}
