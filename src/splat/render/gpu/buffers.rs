//! A scene in GPU memory, cut so that no binding is larger than the adapter allows.

use wgpu::Buffer;

use super::device::Gpu;
use super::plan::SCAN_BLOCK;
use crate::splat::Gaussians;
use crate::{Error, Result};

/// Bytes of one Gaussian's harmonics: 48 floats.
const HARMONICS: u64 = 192;
/// Bytes of one projected Gaussian.
pub const SPLAT: u64 = 48;
/// Bindings for projected Gaussians that the kernels have.
pub const PARTS: usize = 8;
/// Workgroups of one dimension of a dispatch, on every adapter.
pub const MOST_GROUPS: u32 = 65_535;

/// Gaussians `first..first + count`.
pub struct Chunk {
    pub first: u32,
    pub count: u32,
    /// Three planes of vec4: position + logit opacity, quaternion, log scales.
    pub core: Buffer,
    /// Twelve planes of vec4: coefficient k of the channels at floats 3k, 3k + 1, 3k + 2.
    pub harmonics: Buffer,
    /// first, count, stride of the planes.
    pub place: Buffer,
}

/// Gaussians in GPU memory.
pub struct Scene {
    /// Different for every upload to a device, so that a plan knows its own scene.
    pub(super) id: u64,
    pub(in crate::splat) chunks: Vec<Chunk>,
    pub(super) count: u32,
    /// Projected Gaussians that one binding holds: a whole number of chunks.
    pub(super) part: u32,
}

impl Scene {
    /// Uploads all parameters, degree-3 harmonics included.
    ///
    /// Errors: environment, when the scene is larger than the adapter's bindings or memory can take.
    pub fn upload(gpu: &Gpu, g: &Gaussians) -> Result<Scene> {
        Self::upload_limited(gpu, g, gpu.adapter.largest_binding)
    }

    /// As [`Scene::upload`], with bindings of at most `limit` bytes.
    pub fn upload_limited(gpu: &Gpu, g: &Gaussians, limit: u64) -> Result<Scene> {
        let limit = limit.min(gpu.adapter.largest_binding);
        // A multiple of 256 keeps every chunk's offset aligned.
        let most = (limit / HARMONICS / 256 * 256).clamp(256, MOST_GROUPS as u64 * 256) as usize;
        let part = most as u64 * (limit / SPLAT / most as u64).max(1);
        // Keys and values of the sorts are one word a Gaussian; one dispatch must reach all of them.
        let room = (part * PARTS as u64).min(limit / 4).min(u64::from(MOST_GROUPS * SCAN_BLOCK));
        if g.len() as u64 > room {
            return Err(Error::environment(gpu.adapter.name.clone())
                .expected(format!("at most {room} Gaussians, from a binding limit of {limit} bytes"))
                .found(format!("{} Gaussians", g.len()))
                .advice("Choose --device cpu, or an adapter with larger bindings."));
        }
        let mut chunks = Vec::new();
        for first in (0..g.len()).step_by(most) {
            chunks.push(upload(gpu, g, first, (g.len() - first).min(most))?);
        }
        Ok(Scene { id: gpu.next_scene(), chunks, count: g.len() as u32, part: part.min(u32::MAX as u64) as u32 })
    }

    /// Room for `capacity` Gaussians in one chunk, whose kernels are told on the GPU how many there are.
    ///
    /// Errors: environment, when a binding cannot hold so many.
    pub(in crate::splat) fn room_for(gpu: &Gpu, capacity: u32) -> Result<Scene> {
        let limit = gpu.adapter.largest_binding;
        let most = Self::most_in_one_chunk(gpu);
        if capacity > most {
            return Err(Error::environment(gpu.adapter.name.clone())
                .expected(format!("at most {most} Gaussians in training, from a binding limit of {limit} bytes"))
                .found(format!("{capacity}"))
                .advice("Choose --device cpu, or fewer Gaussians."));
        }
        let core = gpu.buffer("core", u64::from(capacity) * 48);
        let harmonics = gpu.buffer("harmonics", u64::from(capacity) * HARMONICS);
        let place = gpu.uniform(&[0, capacity, capacity, 0]);
        let chunk = Chunk { first: 0, count: capacity, core, harmonics, place };
        let part = (limit / SPLAT / 256 * 256).min(u32::MAX.into()) as u32;
        Ok(Scene { id: gpu.next_scene(), chunks: vec![chunk], count: capacity, part })
    }

    /// Gaussians whose harmonics one binding holds and one dispatch reaches.
    pub(in crate::splat) fn most_in_one_chunk(gpu: &Gpu) -> u32 {
        (gpu.adapter.largest_binding / HARMONICS).min(u64::from(MOST_GROUPS) * 256) as u32
    }

    pub(in crate::splat) fn part(&self) -> u32 {
        self.part
    }

    pub fn len(&self) -> usize {
        self.count as usize
    }
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// How many bindings the projected Gaussians need.
    pub(in crate::splat) fn parts(&self) -> usize {
        (self.count.max(1)).div_ceil(self.part) as usize
    }
}

fn upload(gpu: &Gpu, g: &Gaussians, first: usize, count: usize) -> Result<Chunk> {
    let range = first..first + count;
    let core = gpu.buffer("core", count as u64 * 48);
    let harmonics = gpu.buffer("harmonics", count as u64 * HARMONICS);
    let mut plane: Vec<[f32; 4]> = Vec::with_capacity(count);
    let mut put = |buffer: &Buffer, index: usize, value: &dyn Fn(usize) -> [f32; 4]| -> Result<()> {
        plane.clear();
        plane.extend(range.clone().map(value));
        gpu.queue.write_buffer(buffer, (index * count * 16) as u64, bytemuck::cast_slice(&plane));
        // Sends it off, so that the copies waiting in memory stay few.
        gpu.queue.submit([]);
        gpu.wait()
    };
    put(&core, 0, &|i| g.positions[i].extend(g.logit_opacities[i]).to_array())?;
    put(&core, 1, &|i| g.rotations[i])?;
    put(&core, 2, &|i| g.log_scales[i].extend(0.0).to_array())?;
    for j in 0..12 {
        put(&harmonics, j, &|i| std::array::from_fn(|k| g.sh[i].as_flattened()[4 * j + k]))?;
    }
    let place = gpu.uniform(&[first as u32, count as u32, count as u32, 0]);
    Ok(Chunk { first: first as u32, count: count as u32, core, harmonics, place })
}
