//! A stable radix sort of u32 keys with u32 values. The number of keys lies in GPU memory; nothing is read back.
//!
//! Eight bits a pass, three kernels a pass: count the digits of each block, prefix sums over the blocks, scatter.

use wgpu::{Buffer, ComputePass, ComputePipeline};

use super::device::Gpu;
use super::kernel::{Binding, Size, Step, compile, group, read};
use crate::Result;

/// Keys that one workgroup takes on, as in shaders/blocks.wgsl.
pub const BLOCK: u32 = 2048;

/// The compiled kernels.
pub struct Radix {
    count: ComputePipeline,
    scan: ComputePipeline,
    scatter: ComputePipeline,
}

/// Keys equal to u32::MAX may be left out by the first pass, which then takes the keys' indices as values.
pub struct First {
    /// Where the number of keys before leaving out stands in `counts`.
    pub slot: u32,
    /// Workgroups for that many.
    pub size: Size,
}

/// What is sorted and where: keys and values start in `[0]` and end in `[passes % 2]`.
pub struct Request<'a> {
    pub keys: [&'a Buffer; 2],
    pub values: [&'a Buffer; 2],
    /// Words; `slot` says which is the number of keys.
    pub counts: &'a Buffer,
    pub slot: u32,
    /// Workgroups for that many keys: ⌈n / BLOCK⌉.
    pub size: Size,
    /// At least [`table_bytes`] of the most keys.
    pub table: &'a Buffer,
    /// 1,024 bytes.
    pub digits: &'a Buffer,
    /// Only this many low bits of the keys differ.
    pub bits: u32,
    pub first: Option<First>,
}

/// Bytes of the table for at most `keys` keys.
pub fn table_bytes(keys: u64) -> u64 {
    keys.div_ceil(BLOCK as u64).max(1) * 256 * 4
}

/// Passes for keys of so many bits.
pub fn passes(bits: u32) -> usize {
    bits.div_ceil(8).max(1) as usize
}

/// A sort that only waits to be recorded.
pub struct Sort {
    steps: Vec<Step>,
}

impl Sort {
    pub fn record(&self, pass: &mut ComputePass) {
        self.steps.iter().for_each(|s| s.record(pass));
    }
}

macro_rules! source {
    ($name:literal) => {
        concat!(
            include_str!("../../../../shaders/blocks.wgsl"),
            include_str!(concat!("../../../../shaders/", $name, ".wgsl"))
        )
    };
}

impl Radix {
    pub fn new(gpu: &Gpu) -> Radix {
        Radix {
            count: compile(gpu, "radix_count", source!("radix_count"), &[]),
            scan: compile(gpu, "radix_scan", source!("radix_scan"), &[]),
            scatter: compile(gpu, "radix_scatter", source!("radix_scatter"), &[]),
        }
    }

    pub fn prepare(&self, gpu: &Gpu, r: &Request) -> Sort {
        use Binding::Whole;
        let mut steps = Vec::new();
        for p in 0..passes(r.bits) {
            let (from, to) = (p % 2, 1 - p % 2);
            let (slot, size, leaves_out) = match &r.first {
                Some(first) if p == 0 => (first.slot, &first.size, true),
                _ => (r.slot, &r.size, false),
            };
            // shift, slot, keep, values are indices.
            let step = gpu.uniform(&[8 * p as u32, slot, u32::from(!leaves_out), u32::from(leaves_out)]);
            let mut add = |kernel: &ComputePipeline, size: &Size, bindings: &[Binding]| {
                let groups = vec![group(gpu, kernel, 0, bindings)];
                steps.push(Step { kernel: kernel.clone(), groups, size: size.clone() });
            };
            let (s, c, t, d) = (Whole(&step), Whole(r.counts), Whole(r.table), Whole(r.digits));
            add(&self.count, size, &[s, c, Whole(r.keys[from]), t]);
            let (s, c, t) = (Whole(&step), Whole(r.counts), Whole(r.table));
            add(&self.scan, &Size::Direct(256, 1), &[s, c, t, d]);
            let (s, c, t, d) = (Whole(&step), Whole(r.counts), Whole(r.table), Whole(r.digits));
            let lists = [r.keys[from], r.values[from], r.keys[to], r.values[to]].map(Whole);
            add(&self.scatter, size, &[s, c, t, d].into_iter().chain(lists).collect::<Vec<_>>());
        }
        Sort { steps }
    }
}

/// Sorts pairs by the low `bits` bits of their keys on the GPU, equal keys in their old order, and reads them back.
pub fn sort_pairs(gpu: &Gpu, keys: &[u32], values: &[u32], bits: u32) -> Result<(Vec<u32>, Vec<u32>)> {
    assert_eq!(keys.len(), values.len(), "one value a key");
    let n = keys.len() as u32;
    let bytes = u64::from(n) * 4;
    let [k0, k1, v0, v1] = ["keys", "keys", "values", "values"].map(|label| gpu.buffer(label, bytes));
    let (counts, digits) = (gpu.buffer("counts", 16), gpu.buffer("digits", 1024));
    let table = gpu.buffer("table", table_bytes(n.into()));
    gpu.queue.write_buffer(&k0, 0, bytemuck::cast_slice(keys));
    gpu.queue.write_buffer(&v0, 0, bytemuck::cast_slice(values));
    gpu.queue.write_buffer(&counts, 0, bytemuck::bytes_of(&n));
    let sort = Radix::new(gpu).prepare(
        gpu,
        &Request {
            keys: [&k0, &k1],
            values: [&v0, &v1],
            counts: &counts,
            slot: 0,
            size: Size::Direct(n.div_ceil(BLOCK), 1),
            table: &table,
            digits: &digits,
            bits,
            first: None,
        },
    );
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    sort.record(&mut encoder.begin_compute_pass(&Default::default()));
    gpu.queue.submit([encoder.finish()]);
    let (keys, values) = if passes(bits).is_multiple_of(2) { (&k0, &v0) } else { (&k1, &v1) };
    let words = |b: &Buffer| read(gpu, b, bytes).map(|bytes| bytemuck::pod_collect_to_vec(&bytes));
    if n == 0 { Ok(Default::default()) } else { Ok((words(keys)?, words(values)?)) }
}
