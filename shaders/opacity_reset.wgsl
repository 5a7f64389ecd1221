// Opacity reset (Kerbl et al. 2023, §5.2): no opacity stays above the ceiling, and Adam forgets. One thread a Gaussian,
// 256 a workgroup.

@group(0) @binding(0) var<uniform> refine: Refine;
@group(0) @binding(1) var<storage, read_write> core: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read_write> core_moments: array<vec4<f32>>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < refine.gaussians && !keeps_still(core[id.x], refine.moving)) {
        core[id.x].w = min(core[id.x].w, refine.ceiling);
        core_moments[id.x].w = 0.0;
        core_moments[3u * refine.stride + id.x].w = 0.0;
    }
}
