//! Choosing an adapter, opening it, and testing that it computes what it promises.

use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::task::{Context, Poll, Waker};
use std::time::Duration;

use wgpu::{Features, PollType};

use super::cache::Kept;
use super::kernel::{Binding, compile, read};
use crate::{Error, Result};

/// One adapter as its driver describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Adapter {
    pub name: String,
    /// "Vulkan", "Metal" or "DX12".
    pub backend: String,
    pub driver: String,
    /// False for a software implementation such as lavapipe.
    pub hardware: bool,
    /// Bytes that one binding of a storage buffer may show to a kernel.
    pub largest_binding: u64,
    pub largest_buffer: u64,
    /// Bytes of memory that a workgroup shares.
    pub workgroup_memory: u32,
}

/// What the adapter was seen to do right, not what it says it can.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Abilities {
    /// Subgroup sums, scans and barriers, with lanes in the order of the workgroup's threads.
    pub subgroups: bool,
    /// Lanes of a subgroup; 1 without subgroups.
    pub lanes: u32,
    /// `atomicAdd` on f32.
    pub float_atomics: bool,
    /// Compare-and-swap on the bits of an f32.
    pub swap_atomics: bool,
    pub timestamps: bool,
    pub pipeline_cache: bool,
}

/// An opened, tested adapter.
pub struct Gpu {
    pub(in crate::splat) device: wgpu::Device,
    pub(in crate::splat) queue: wgpu::Queue,
    pub adapter: Adapter,
    pub abilities: Abilities,
    /// Why an ability that the driver offers is not used: its self-test was refused or came out wrong.
    pub notes: Vec<String>,
    /// The first error that no call returned.
    failure: Arc<Mutex<Option<String>>>,
    scenes: AtomicU64,
    pub(super) kept: Option<Kept>,
}

impl Drop for Gpu {
    fn drop(&mut self) {
        if let Some(kept) = &self.kept {
            kept.save();
        }
    }
}

/// wgpu's native futures are ready when they are first asked.
fn ready<T>(future: impl Future<Output = T>) -> T {
    let mut future = std::pin::pin!(future);
    let mut context = Context::from_waker(Waker::noop());
    loop {
        if let Poll::Ready(value) = future.as_mut().poll(&mut context) {
            return value;
        }
        std::thread::yield_now();
    }
}

fn found() -> Vec<(wgpu::Adapter, Adapter)> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    // GL lists the same hardware again with fewer abilities.
    descriptor.backends = wgpu::Backends::VULKAN | wgpu::Backends::METAL | wgpu::Backends::DX12;
    // Indirect sizes come from our own kernels, within the limits: no second dispatch to check each of them.
    descriptor.flags = wgpu::InstanceFlags::empty();
    let instance = wgpu::Instance::new(descriptor);
    let mut all: Vec<_> = ready(instance.enumerate_adapters(wgpu::Backends::all()))
        .into_iter()
        .map(|a| {
            let (info, limits) = (a.get_info(), a.limits());
            let described = Adapter {
                name: info.name,
                backend: match info.backend {
                    wgpu::Backend::Vulkan => "Vulkan".into(),
                    wgpu::Backend::Metal => "Metal".into(),
                    wgpu::Backend::Dx12 => "DX12".into(),
                    other => format!("{other:?}"),
                },
                driver: format!("{} {}", info.driver, info.driver_info).trim().to_owned(),
                hardware: info.device_type != wgpu::DeviceType::Cpu,
                largest_binding: limits.max_storage_buffer_binding_size.min(limits.max_buffer_size),
                largest_buffer: limits.max_buffer_size,
                workgroup_memory: limits.max_compute_workgroup_storage_size,
            };
            let rank = match info.device_type {
                wgpu::DeviceType::DiscreteGpu => 0,
                wgpu::DeviceType::IntegratedGpu => 1,
                wgpu::DeviceType::VirtualGpu => 2,
                wgpu::DeviceType::Other => 3,
                wgpu::DeviceType::Cpu => 4,
            };
            (rank, a, described)
        })
        .collect();
    // Stable: among equals the driver's order stands.
    all.sort_by_key(|(rank, ..)| *rank);
    all.into_iter().map(|(_, a, d)| (a, d)).collect()
}

/// Every adapter that could be opened, the best first. Empty where there is no driver.
pub fn adapters() -> Vec<Adapter> {
    found().into_iter().map(|(_, d)| d).collect()
}

impl Gpu {
    /// Opens the best adapter; with `software` also a software implementation, where there is nothing better.
    /// `kernels`: a folder where compiled kernels are kept from run to run.
    ///
    /// Errors: environment, when no adapter is offered, none opens, or the one that opens fails its self-test.
    pub fn open(software: bool, kernels: Option<&Path>) -> Result<Gpu> {
        let all = found();
        let names: Vec<String> = all.iter().map(|(_, d)| format!("{} ({})", d.name, d.backend)).collect();
        let Some((adapter, described)) = all.into_iter().find(|(_, d)| software || d.hardware) else {
            return Err(Error::environment("GPU")
                .expected("an adapter with Vulkan, Metal or DX12")
                .found(if names.is_empty() { "none".into() } else { names.join(", ") })
                .advice("Install the graphics driver, or choose --device cpu."));
        };
        let offered = adapter.features();
        let wanted = Features::SUBGROUP
            | Features::SUBGROUP_BARRIER
            | Features::SHADER_FLOAT32_ATOMIC
            | Features::TIMESTAMP_QUERY
            | Features::PIPELINE_CACHE;
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("orb"),
            required_features: offered & wanted,
            required_limits: adapter.limits(),
            ..Default::default()
        };
        let (device, queue) = ready(adapter.request_device(&descriptor))
            .map_err(|e| Error::environment(described.name.clone()).expected("a device").found(e.to_string()))?;
        let failure = Arc::new(Mutex::new(None));
        let slot = failure.clone();
        device.on_uncaptured_error(Arc::new(move |e: wgpu::Error| {
            let mut first = slot.lock().unwrap_or_else(|p| p.into_inner());
            first.get_or_insert_with(|| e.to_string());
        }));
        let abilities = Abilities {
            subgroups: false,
            lanes: 1,
            float_atomics: false,
            swap_atomics: false,
            timestamps: offered.contains(Features::TIMESTAMP_QUERY),
            pipeline_cache: offered.contains(Features::PIPELINE_CACHE),
        };
        let kept = kernels.filter(|_| abilities.pipeline_cache).map(|f| Kept::open(&device, &adapter.get_info(), f));
        let mut gpu = Gpu {
            device,
            queue,
            adapter: described,
            abilities,
            notes: Vec::new(),
            failure,
            scenes: AtomicU64::new(0),
            kept,
        };
        gpu.test(offered)?;
        Ok(gpu)
    }

    /// Errors that no call returned: out of memory, a lost device, a kernel that does not compile.
    pub fn check(&self) -> Result<()> {
        let found = self.failure.lock().unwrap_or_else(|p| p.into_inner()).take();
        match found {
            None => Ok(()),
            Some(text) => Err(Error::environment(self.adapter.name.clone())
                .found(text)
                .advice("Choose --device cpu, a smaller picture or fewer Gaussians.")),
        }
    }

    /// Waits until everything submitted is done.
    pub fn wait(&self) -> Result<()> {
        // A hung driver must not hang the program for ever.
        let wait = PollType::Wait { submission_index: None, timeout: Some(Duration::from_secs(600)) };
        let done = self.device.poll(wait);
        self.check()?;
        done.map(|_| ()).map_err(|e| Error::environment(self.adapter.name.clone()).found(e.to_string()))
    }

    /// A number for one more scene.
    pub(super) fn next_scene(&self) -> u64 {
        self.scenes.fetch_add(1, Ordering::Relaxed)
    }

    /// Fills in the abilities. An adapter that fails even the plainest kernel is no use: an error.
    fn test(&mut self, offered: Features) -> Result<()> {
        self.abilities.swap_atomics = self.sums(include_str!("../../../../shaders/selftest.wgsl"))?;
        if !self.abilities.swap_atomics {
            self.notes.push("compare-and-swap atomics give wrong sums".into());
        }
        if offered.contains(Features::SHADER_FLOAT32_ATOMIC) {
            match self.sums(include_str!("../../../../shaders/selftest_float.wgsl")) {
                Ok(right) => self.abilities.float_atomics = right,
                Err(e) => self.notes.push(e.to_string()),
            }
            if !self.abilities.float_atomics {
                self.notes.push("native float atomics are not used".into());
            }
        }
        if offered.contains(Features::SUBGROUP | Features::SUBGROUP_BARRIER) {
            match self.lanes() {
                Ok(lanes) => self.abilities.lanes = lanes,
                Err(e) => self.notes.push(e.to_string()),
            }
            self.abilities.subgroups = self.abilities.lanes > 1;
            if !self.abilities.subgroups {
                self.notes.push("subgroups are not used".into());
            }
        }
        self.check()
    }

    /// Whether the kernel's eight sums are right: thread i of 16,384 adds i % 4 + 1 to place i % 8.
    fn sums(&self, source: &str) -> Result<bool> {
        let out = self.run_test(source, 8 * 4)?;
        let expected: Vec<f32> = (0..8).map(|k| 2048.0 * (k % 4 + 1) as f32).collect();
        Ok(bytemuck::pod_collect_to_vec::<u8, f32>(&out) == expected)
    }

    /// Lanes of a subgroup, or 1 where subgroups do not do as they should.
    fn lanes(&self) -> Result<u32> {
        let bytes = self.run_test(include_str!("../../../../shaders/selftest_subgroup.wgsl"), 256 * 16)?;
        let out: Vec<[u32; 4]> = bytemuck::pod_collect_to_vec(&bytes);
        let lanes = out[0][2];
        // The rasteriser's blocks are powers of two and a whole number of them a tile.
        if !(lanes.is_power_of_two() && (2..=128).contains(&lanes)) {
            return Ok(1);
        }
        let mut met = [false; 256];
        let right = out.iter().all(|o| {
            let [before, sum, size, place] = *o;
            let lane = place % lanes;
            let first = place < 256 && !std::mem::replace(&mut met[place as usize], true);
            first && size == lanes && before == lane / 2 && sum == lanes * (lanes - 1) / 2
        });
        Ok(if right { lanes } else { 1 })
    }

    /// One dispatch of a self-test.
    fn run_test(&self, source: &str, bytes: u64) -> Result<Vec<u8>> {
        let out = self.buffer("self-test", bytes);
        let pipeline = compile(self, "self-test", source, &[]);
        let group = super::kernel::group(self, &pipeline, 0, &[Binding::Whole(&out)]);
        let mut encoder = self.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.dispatch_workgroups(if bytes == 32 { 64 } else { 1 }, 1, 1);
        }
        self.queue.submit([encoder.finish()]);
        read(self, &out, bytes)
    }

    /// A storage buffer that kernels and copies may read and write.
    pub(in crate::splat) fn buffer(&self, label: &str, bytes: u64) -> wgpu::Buffer {
        use wgpu::BufferUsages as U;
        self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            // A binding of no bytes is not allowed.
            size: bytes.max(16).next_multiple_of(16),
            usage: U::STORAGE | U::COPY_SRC | U::COPY_DST | U::INDIRECT,
            mapped_at_creation: false,
        })
    }

    /// A small uniform buffer with its first contents.
    pub(in crate::splat) fn uniform<T: bytemuck::Pod>(&self, value: &T) -> wgpu::Buffer {
        use wgpu::BufferUsages as U;
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("uniform"),
            size: size_of::<T>() as u64,
            usage: U::UNIFORM | U::STORAGE | U::COPY_DST | U::COPY_SRC,
            mapped_at_creation: false,
        });
        self.queue.write_buffer(&buffer, 0, bytemuck::bytes_of(value));
        buffer
    }
}
