//! What training changes, in GPU memory: parameters, moments, cameras.

use bytemuck::{cast_slice, pod_collect_to_vec};
use wgpu::Buffer;

use crate::Result;
use crate::splat::packed::{Core, Packed, Sh};
use crate::splat::render::gpu::kernel::read;
use crate::splat::render::gpu::{Gpu, Scene};
use crate::splat::train::adam::Moments;

/// Planes of vec4 of each buffer in [`Model::planes`], and whether a new Gaussian starts them at zero.
const PLANES: [(u32, bool); 5] = [(3, false), (12, false), (6, true), (12, true), (12, true)];

/// All planes are `capacity` vec4 long.
pub struct Model {
    pub scene: Scene,
    /// Three planes of m as core's, three of v; m of the scales has the steps taken in its fourth number.
    pub core_moments: Buffer,
    pub harmonics_m: Buffer,
    pub harmonics_v: Buffer,
    /// Σ |∂L/∂mean|, pictures seen in.
    pub seen: Buffer,
    pub count: u32,
    pub capacity: u32,
}

impl Model {
    pub fn new(gpu: &Gpu, capacity: u32) -> Result<Model> {
        let scene = Scene::room_for(gpu, capacity)?;
        let bytes = u64::from(capacity) * 16;
        let [core_moments, harmonics_m, harmonics_v] = [6, 12, 12].map(|planes| gpu.buffer("moments", planes * bytes));
        let seen = gpu.buffer("seen", u64::from(capacity) * 8);
        Ok(Model { scene, core_moments, harmonics_m, harmonics_v, seen, count: 0, capacity })
    }

    /// Buffer, number of planes, whether a new Gaussian starts at zero.
    pub fn planes(&self) -> [(&Buffer, u32, bool); 5] {
        let chunk = &self.scene.chunks[0];
        let buffers = [&chunk.core, &chunk.harmonics, &self.core_moments, &self.harmonics_m, &self.harmonics_v];
        std::array::from_fn(|i| (buffers[i], PLANES[i].0, PLANES[i].1))
    }

    /// Bytes of all of it.
    pub fn bytes(&self) -> u64 {
        u64::from(self.capacity) * (45 * 16 + 8)
    }

    /// The same Gaussians with room for more.
    pub fn grown(&self, gpu: &Gpu, capacity: u32) -> Result<Model> {
        let mut next = Model::new(gpu, capacity)?;
        next.count = self.count;
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        for ((from, planes, _), (to, ..)) in self.planes().into_iter().zip(next.planes()) {
            for p in 0..u64::from(planes) {
                let (a, b) = (p * u64::from(self.capacity) * 16, p * u64::from(capacity) * 16);
                encoder.copy_buffer_to_buffer(from, a, to, b, u64::from(self.count) * 16);
            }
        }
        encoder.copy_buffer_to_buffer(&self.seen, 0, &next.seen, 0, u64::from(self.count) * 8);
        gpu.queue.submit([encoder.finish()]);
        gpu.check()?;
        Ok(next)
    }

    pub fn upload(&mut self, gpu: &Gpu, g: &Packed, moments: &Moments, seen: &[[f32; 2]]) -> Result<()> {
        self.count = g.len() as u32;
        let chunk = &self.scene.chunks[0];
        let put = |buffer: &Buffer, plane: u32, value: &dyn Fn(usize) -> [f32; 4]| {
            let values: Vec<[f32; 4]> = (0..g.len()).map(value).collect();
            gpu.queue.write_buffer(buffer, u64::from(plane) * u64::from(self.capacity) * 16, cast_slice(&values));
            // Sends it off, so that the copies waiting in memory stay few.
            gpu.queue.submit([]);
            gpu.wait()
        };
        for p in 0..3 {
            put(&chunk.core, p, &|i| core_plane(&g.core[i], p))?;
            for k in 0..2 {
                put(&self.core_moments, 3 * k + p, &|i| {
                    let mut v = core_plane(&moments.core[i][k as usize], p);
                    if k == 0 && p == 2 {
                        v[3] = moments.steps[i] as f32;
                    }
                    v
                })?;
            }
        }
        for p in 0..12 {
            put(&chunk.harmonics, p, &|i| sh_plane(&g.sh[i], p))?;
            put(&self.harmonics_m, p, &|i| sh_plane(&moments.sh[i][0], p))?;
            put(&self.harmonics_v, p, &|i| sh_plane(&moments.sh[i][1], p))?;
        }
        gpu.queue.write_buffer(&self.seen, 0, cast_slice(seen));
        gpu.check()
    }

    pub fn download(&self, gpu: &Gpu) -> Result<(Packed, Moments, Vec<[f32; 2]>)> {
        let (n, capacity) = (self.count as usize, self.capacity as usize);
        let chunk = &self.scene.chunks[0];
        let planes = |buffer: &Buffer, planes: usize| -> Result<Vec<[f32; 4]>> {
            Ok(pod_collect_to_vec(&read(gpu, buffer, (planes * capacity * 16) as u64)?))
        };
        let core = |v: &[[f32; 4]], first: usize| -> Vec<Core> {
            (0..n)
                .map(|i| {
                    let mut c = [0.0; 16];
                    for p in 0..3 {
                        c[4 * p..4 * p + 4].copy_from_slice(&v[(first + p) * capacity + i]);
                    }
                    c[11] = 0.0;
                    c
                })
                .collect()
        };
        let sh = |v: &[[f32; 4]]| -> Vec<Sh> {
            (0..n)
                .map(|i| {
                    std::array::from_fn(|k| {
                        let f = 3 * (k % 16) + k / 16;
                        v[f / 4 * capacity + i][f % 4]
                    })
                })
                .collect()
        };
        let g = Packed { core: core(&planes(&chunk.core, 3)?, 0), sh: sh(&planes(&chunk.harmonics, 12)?) };
        let cm = planes(&self.core_moments, 6)?;
        let (m, v) = (sh(&planes(&self.harmonics_m, 12)?), sh(&planes(&self.harmonics_v, 12)?));
        let moments = Moments {
            core: core(&cm, 0).into_iter().zip(core(&cm, 3)).map(|(m, v)| [m, v]).collect(),
            sh: m.into_iter().zip(v).map(|(m, v)| [m, v]).collect(),
            steps: (0..n).map(|i| cm[2 * capacity + i][3] as u32).collect(),
        };
        let seen = if n == 0 { Vec::new() } else { pod_collect_to_vec(&read(gpu, &self.seen, n as u64 * 8)?) };
        Ok((g, moments, seen))
    }
}

fn core_plane(c: &Core, plane: u32) -> [f32; 4] {
    let at = 4 * plane as usize;
    let mut v: [f32; 4] = std::array::from_fn(|k| c[at + k]);
    if plane == 2 {
        v[3] = 0.0;
    }
    v
}

/// From channel-major: float 3k + c of the planes is coefficient k of channel c.
fn sh_plane(s: &Sh, plane: u32) -> [f32; 4] {
    std::array::from_fn(|k| {
        let f = 4 * plane as usize + k;
        s[f % 3 * 16 + f / 3]
    })
}
