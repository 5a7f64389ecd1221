// Scan, second step: exclusive prefix sum of the blocks' pairs, in place. One workgroup of 256 threads.

@group(0) @binding(0) var<storage, read> counts: array<u32>;
@group(0) @binding(1) var<storage, read_write> block_sums: array<u32>;

var<workgroup> sums: array<u32, 256>;

@compute @workgroup_size(256)
fn main(@builtin(local_invocation_index) lane: u32) {
    let blocks = (counts[3] + SCAN_BLOCK - 1u) / SCAN_BLOCK;
    let run = (blocks + 255u) / 256u;
    let first = min(lane * run, blocks);
    let end = min(first + run, blocks);
    var sum = 0u;
    for (var i = first; i < end; i++) {
        sum += block_sums[i];
    }
    sums[lane] = sum;
    workgroupBarrier();
    for (var reach = 1u; reach < 256u; reach <<= 1u) {
        var add = 0u;
        if (lane >= reach) {
            add = sums[lane - reach];
        }
        workgroupBarrier();
        sums[lane] += add;
        workgroupBarrier();
    }
    var before = sums[lane] - sum;
    for (var i = first; i < end; i++) {
        let own = block_sums[i];
        block_sums[i] = before;
        before += own;
    }
}
