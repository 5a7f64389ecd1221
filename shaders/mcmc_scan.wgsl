// MCMC, second step: exclusive prefix sums over the blocks, in place, and the totals. One workgroup of 256 threads.

@group(0) @binding(0) var<uniform> mcmc: Mcmc;
@group(0) @binding(1) var<storage, read_write> blocks: array<vec2<u32>>;
// All weights, all dead.
@group(0) @binding(2) var<storage, read_write> totals: array<u32>;

var<workgroup> sums: array<vec2<u32>, 256>;

@compute @workgroup_size(256)
fn main(@builtin(local_invocation_index) lane: u32) {
    let count = (mcmc.gaussians + SCAN_BLOCK - 1u) / SCAN_BLOCK;
    let run = (count + 255u) / 256u;
    let first = min(lane * run, count);
    let end = min(first + run, count);
    var sum = vec2(0u);
    for (var i = first; i < end; i++) {
        sum += blocks[i];
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
    var before = sums[lane] - sum;
    for (var i = first; i < end; i++) {
        let own = blocks[i];
        blocks[i] = before;
        before += own;
    }
    if (lane == 255u) {
        totals[0] = sums[255].x;
        totals[1] = sums[255].y;
    }
}
