// MCMC, fifth step: a Gaussian drawn m times and its copies together look as it did alone (Kheradmand et al. 2024,
// Eq. 9). One thread a Gaussian, 256 a workgroup.
//
// With n = m + 1: o' = 1 − (1 − o)^(1/n), scale' = scale · o / Σ_{i=1..n} Σ_{k<i} C(i−1, k) (−1)^k o'^(k+1) / √(k+1).
// Adam forgets.

@group(0) @binding(0) var<uniform> mcmc: Mcmc;
@group(0) @binding(1) var<storage, read> chosen: array<u32>;
@group(0) @binding(2) var<storage, read_write> core: array<vec4<f32>>;
@group(0) @binding(3) var<storage, read_write> core_moments: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> harmonics_m: array<vec4<f32>>;
@group(0) @binding(5) var<storage, read_write> harmonics_v: array<vec4<f32>>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    if (i >= mcmc.gaussians || chosen[i] == 0u) {
        return;
    }
    let n = min(chosen[i] + 1u, 51u);
    let o = opaque(core[i].w);
    let next = clamp(1.0 - pow(1.0 - o, 1.0 / f32(n)), mcmc.faintest, 0.999999);
    var sum = 0.0;
    for (var j = 1u; j <= n; j++) {
        // C(j−1, k) (−1)^k o'^(k+1)
        var term = next;
        for (var k = 0u; k < j; k++) {
            sum += term / sqrt(f32(k + 1u));
            term *= -next * f32(j - 1u - k) / f32(k + 1u);
        }
    }
    core[i].w = log(next / (1.0 - next));
    core[2u * mcmc.stride + i] += vec4(vec3(log(o / sum)), 0.0);
    for (var p = 0u; p < 12u; p++) {
        if (p < 6u) {
            core_moments[p * mcmc.stride + i] = vec4(0.0);
        }
        harmonics_m[p * mcmc.stride + i] = vec4(0.0);
        harmonics_v[p * mcmc.stride + i] = vec4(0.0);
    }
}
