// MCMC, first step: weights of live Gaussians and number of dead ones in each block of 1,024. 256 threads a block.

@group(0) @binding(0) var<uniform> mcmc: Mcmc;
@group(0) @binding(1) var<storage, read> core: array<vec4<f32>>;
// Weight, dead.
@group(0) @binding(2) var<storage, read_write> blocks: array<vec2<u32>>;
@group(0) @binding(3) var<storage, read_write> chosen: array<u32>;

var<workgroup> weight: atomic<u32>;
var<workgroup> dead: atomic<u32>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    if (lane == 0u) {
        atomicStore(&weight, 0u);
        atomicStore(&dead, 0u);
    }
    workgroupBarrier();
    var own = vec2(0u);
    for (var k = 0u; k < SCAN_ITEMS; k++) {
        let i = group.x * SCAN_BLOCK + k * 256u + lane;
        if (i < mcmc.gaussians) {
            own += share(core[i]);
            chosen[i] = 0u;
        }
    }
    atomicAdd(&weight, own.x);
    atomicAdd(&dead, own.y);
    workgroupBarrier();
    if (lane == 0u) {
        blocks[group.x] = vec2(atomicLoad(&weight), atomicLoad(&dead));
    }
}
