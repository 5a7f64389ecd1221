// Refine, third step: clone or split. One thread a Gaussian that grows, 256 a workgroup.

@group(0) @binding(0) var<uniform> refine: Refine;
@group(0) @binding(1) var<storage, read> items: array<u32>;
@group(0) @binding(2) var<storage, read> order: array<u32>;
@group(0) @binding(3) var<storage, read> core: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> kinds: array<u32>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < items[4]) {
        let i = order[id.x];
        let s = exp(core[2u * refine.stride + i].xyz);
        kinds[i] = select(CLONED, SPLIT, max(max(s.x, s.y), s.z) > refine.split_size);
    }
}
