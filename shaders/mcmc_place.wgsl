// MCMC, third step: the weights' running sum and the list of the dead. 256 threads a block of 1,024 Gaussians, four each.

@group(0) @binding(0) var<uniform> mcmc: Mcmc;
@group(0) @binding(1) var<storage, read> core: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read> blocks: array<vec2<u32>>;
// Σ of the weights up to and with each Gaussian's.
@group(0) @binding(3) var<storage, read_write> running: array<u32>;
@group(0) @binding(4) var<storage, read_write> dead: array<u32>;

var<workgroup> sums: array<vec2<u32>, 256>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let first = group.x * SCAN_BLOCK + lane * SCAN_ITEMS;
    var own: array<vec2<u32>, 4>;
    var sum = vec2(0u);
    for (var k = 0u; k < SCAN_ITEMS; k++) {
        own[k] = vec2(0u);
        if (first + k < mcmc.gaussians) {
            own[k] = share(core[first + k]);
        }
        sum += own[k];
    }
    sums[lane] = sum;
    workgroupBarrier();
    for (var reach = 1u; reach < 256u; reach <<= 1u) {
        var add = vec2(0u);
        if (lane >= reach) {
            add = sums[lane - reach];
        }
        workgroupBarrier();
        sums[lane] += add;
        workgroupBarrier();
    }
    var at = blocks[group.x] + sums[lane] - sum;
    for (var k = 0u; k < SCAN_ITEMS; k++) {
        if (first + k < mcmc.gaussians) {
            if (own[k].y != 0u) {
                dead[at.y] = first + k;
            }
            at += own[k];
            running[first + k] = at.x;
        }
    }
}
