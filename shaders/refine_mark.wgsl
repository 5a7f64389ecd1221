// Refine, first step: which Gaussians are pulled hard enough. One thread a Gaussian, 256 a workgroup.
//
// keys[i]: sorts the hardest pulled first; CULLED for those that are not.

@group(0) @binding(0) var<uniform> refine: Refine;
@group(0) @binding(1) var<storage, read> seen: array<vec2<f32>>;
@group(0) @binding(2) var<storage, read_write> keys: array<u32>;
@group(0) @binding(3) var<storage, read_write> kinds: array<u32>;
// Candidates, -, -, candidates, -, -, -, Gaussians.
@group(0) @binding(4) var<storage, read_write> counts: array<atomic<u32>>;
@group(0) @binding(5) var<storage, read> core: array<vec4<f32>>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    if (i < refine.gaussians) {
        let pull = seen[i].x / max(seen[i].y, 1.0);
        var key = 0xffffffffu;
        if (finite(pull) && pull > refine.threshold && !keeps_still(core[i], refine.moving)) {
            key = 0x7f800000u - bitcast<u32>(pull);
            atomicAdd(&counts[0], 1u);
        }
        keys[i] = key;
        kinds[i] = STAYS;
    }
}
