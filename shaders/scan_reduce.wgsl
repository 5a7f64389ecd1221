// Scan, first step: pairs of each block of 1,024 Gaussians in depth order. 256 threads a block.

@group(0) @binding(0) var<storage, read> counts: array<u32>;
@group(0) @binding(1) var<storage, read> order: array<u32>;
@group(0) @binding(2) var<storage, read> touched: array<u32>;
@group(0) @binding(3) var<storage, read_write> block_sums: array<u32>;

var<workgroup> sum: atomic<u32>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let n = counts[3];
    if (lane == 0u) {
        atomicStore(&sum, 0u);
    }
    workgroupBarrier();
    var own = 0u;
    for (var i = 0u; i < SCAN_ITEMS; i++) {
        let rank = group.x * SCAN_BLOCK + i * 256u + lane;
        if (rank < n) {
            own += touched[order[rank]];
        }
    }
    atomicAdd(&sum, own);
    workgroupBarrier();
    if (lane == 0u) {
        block_sums[group.x] = atomicLoad(&sum);
    }
}
