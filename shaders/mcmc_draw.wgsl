// MCMC, fourth step: for every dead and every added Gaussian, a live one drawn in proportion to its opacity. One thread
// each, 256 a workgroup.

@group(0) @binding(0) var<uniform> mcmc: Mcmc;
@group(0) @binding(1) var<storage, read> totals: array<u32>;
@group(0) @binding(2) var<storage, read> running: array<u32>;
// How often each was drawn.
@group(0) @binding(3) var<storage, read_write> chosen: array<atomic<u32>>;
@group(0) @binding(4) var<storage, read_write> drawn: array<u32>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < totals[1] + mcmc.added && totals[0] > 0u) {
        let at = product(hash(mcmc.seed.xy ^ vec2(id.x, 0u)).y, totals[0]).y;
        // The first whose running sum is above.
        var low = 0u;
        var high = mcmc.gaussians - 1u;
        for (var k = 0u; k < 32u; k++) {
            if (low < high) {
                let middle = (low + high) / 2u;
                if (running[middle] > at) {
                    high = middle;
                } else {
                    low = middle + 1u;
                }
            }
        }
        drawn[id.x] = low;
        atomicAdd(&chosen[low], 1u);
    }
}
