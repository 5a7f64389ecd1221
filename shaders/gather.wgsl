// Gather: one plane of parameters in the order of the next list. One thread a Gaussian, 256 a workgroup.

struct Plane {
    // Gaussians of the next list.
    count: u32,
    // Where the plane begins.
    start: u32,
    // 1: a new Gaussian gets zeros.
    fresh: u32,
    pad: u32,
}

@group(0) @binding(0) var<uniform> plane: Plane;
@group(0) @binding(1) var<storage, read> sources: array<u32>;
@group(0) @binding(2) var<storage, read> values: array<vec4<f32>>;
@group(0) @binding(3) var<storage, read_write> out: array<vec4<f32>>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < plane.count) {
        let source = sources[id.x];
        var v = vec4(0.0);
        if (plane.fresh == 0u || (source & 0x80000000u) == 0u) {
            v = values[plane.start + (source & 0x3fffffffu)];
        }
        out[id.x] = v;
    }
}
