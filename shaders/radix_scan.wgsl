// Radix, second step of a pass: one workgroup of 256 threads a digit; exclusive prefix sum of the digit's row of the
// table over the blocks, and the row's total. A short row is summed by one thread.

struct Pass {
    shift: u32,
    slot: u32,
    keep: u32,
    index: u32,
}

@group(0) @binding(0) var<uniform> step: Pass;
@group(0) @binding(1) var<storage, read> counts: array<u32>;
@group(0) @binding(2) var<storage, read_write> table: array<u32>;
@group(0) @binding(3) var<storage, read_write> digit_totals: array<u32, 256>;

const SHORT: u32 = 4u;

var<workgroup> sums: array<u32, 256>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let blocks = (counts[step.slot] + RADIX_BLOCK - 1u) / RADIX_BLOCK;
    let row = group.x * blocks;
    if (blocks <= SHORT) {
        if (lane == 0u) {
            var total = 0u;
            for (var i = 0u; i < blocks; i++) {
                let own = table[row + i];
                table[row + i] = total;
                total += own;
            }
            digit_totals[group.x] = total;
        }
        return;
    }
    // Each thread owns a run of consecutive blocks.
    let run = (blocks + 255u) / 256u;
    let first = min(lane * run, blocks);
    let end = min(first + run, blocks);
    var sum = 0u;
    for (var i = first; i < end; i++) {
        sum += table[row + i];
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
        let own = table[row + i];
        table[row + i] = before;
        before += own;
    }
    if (lane == 255u) {
        digit_totals[group.x] = sums[255];
    }
}
