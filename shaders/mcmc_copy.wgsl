// MCMC, last step: the dead and the added become copies of those drawn for them. One thread each, 256 a workgroup.

@group(0) @binding(0) var<uniform> mcmc: Mcmc;
@group(0) @binding(1) var<storage, read> totals: array<u32>;
@group(0) @binding(2) var<storage, read> dead: array<u32>;
@group(0) @binding(3) var<storage, read> drawn: array<u32>;
@group(0) @binding(4) var<storage, read_write> core: array<vec4<f32>>;
@group(0) @binding(5) var<storage, read_write> harmonics: array<vec4<f32>>;
@group(0) @binding(6) var<storage, read_write> core_moments: array<vec4<f32>>;
@group(0) @binding(7) var<storage, read_write> harmonics_m: array<vec4<f32>>;
@group(0) @binding(8) var<storage, read_write> harmonics_v: array<vec4<f32>>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let gone = totals[1];
    if (id.x >= gone + mcmc.added || totals[0] == 0u) {
        return;
    }
    var to = mcmc.gaussians + id.x - gone;
    if (id.x < gone) {
        to = dead[id.x];
    }
    let source = drawn[id.x];
    for (var p = 0u; p < 12u; p++) {
        let at = p * mcmc.stride;
        if (p < 3u) {
            core[at + to] = core[at + source];
        }
        if (p < 6u) {
            core_moments[at + to] = vec4(0.0);
        }
        harmonics[at + to] = harmonics[at + source];
        harmonics_m[at + to] = vec4(0.0);
        harmonics_v[at + to] = vec4(0.0);
    }
}
