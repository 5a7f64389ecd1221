// Self-test of native float atomics: as selftest.wgsl, with atomicAdd on f32.

@group(0) @binding(0) var<storage, read_write> out: array<atomic<f32>, 8>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    atomicAdd(&out[id.x % 8u], f32(id.x % 4u + 1u));
}
