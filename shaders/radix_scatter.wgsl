// Radix, third step of a pass: every key and value to its place, equal digits in their old order. 256 threads a block
// of 2,048 keys.
//
// Rank: 256 keys at a time, each thread sets its bit in the mask of its digit; the bits below its own are the equal keys
// before it. No subgroup operation, so it is right on any adapter.
// Write: the block is put in order in workgroup memory first, so that neighbouring threads write neighbouring places.

struct Pass {
    shift: u32,
    slot: u32,
    keep: u32,
    index: u32,
}

@group(0) @binding(0) var<uniform> step: Pass;
@group(0) @binding(1) var<storage, read> counts: array<u32>;
@group(0) @binding(2) var<storage, read> table: array<u32>;
@group(0) @binding(3) var<storage, read> digit_totals: array<u32, 256>;
@group(0) @binding(4) var<storage, read> keys_in: array<u32>;
@group(0) @binding(5) var<storage, read> values_in: array<u32>;
@group(0) @binding(6) var<storage, read_write> keys_out: array<u32>;
@group(0) @binding(7) var<storage, read_write> values_out: array<u32>;

// Exclusive prefix sums over the digits: of all keys, and of the block's own.
var<workgroup> sums: array<vec2<u32>, 256>;
// Where the next key of a digit goes in the block, and what to add to get its place among all.
var<workgroup> cursors: array<u32, 256>;
var<workgroup> deltas: array<u32, 256>;
// Ranking: word w of digit d stands at 256 w + d, so that neighbours lie in different banks. Then the sorted block.
var<workgroup> words: array<atomic<u32>, 2048>;

// Key and value.
fn load(at: u32, n: u32) -> vec2<u32> {
    if (at >= n) {
        return vec2(0u);
    }
    if (step.index != 0u) {
        return vec2(keys_in[at], at);
    }
    return vec2(keys_in[at], values_in[at]);
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let n = counts[step.slot];
    let blocks = (n + RADIX_BLOCK - 1u) / RADIX_BLOCK;
    // A dispatch may be larger than the list.
    if (group.x >= blocks) {
        return;
    }
    let first = group.x * RADIX_BLOCK + lane;
    var pairs: array<vec2<u32>, 8>;
    for (var i = 0u; i < RADIX_ITEMS; i++) {
        pairs[i] = load(first + i * 256u, n);
    }
    // The digit's keys in all blocks, in the blocks before this one, and in this one.
    let total = digit_totals[lane];
    let before = table[lane * blocks + group.x];
    var after = total;
    if (group.x + 1u < blocks) {
        after = table[lane * blocks + group.x + 1u];
    }
    let own = vec2(total, after - before);
    sums[lane] = own;
    for (var w = 0u; w < 8u; w++) {
        atomicStore(&words[w * 256u + lane], 0u);
    }
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
    let start = sums[lane] - own;
    cursors[lane] = start.y;
    deltas[lane] = start.x + before - start.y;
    let live_count = sums[255].y;
    workgroupBarrier();

    let word = lane / 32u;
    let bit = lane % 32u;
    var places: array<u32, 8>;
    for (var i = 0u; i < RADIX_ITEMS; i++) {
        let key = pairs[i].x;
        let live = first + i * 256u < n && (step.keep != 0u || key != 0xffffffffu);
        let digit = (key >> step.shift) & 255u;
        if (live) {
            atomicOr(&words[word * 256u + digit], 1u << bit);
        }
        workgroupBarrier();
        var lower = 0u;
        var equal = 0u;
        places[i] = 0xffffffffu;
        if (live) {
            for (var w = 0u; w < 8u; w++) {
                let bits = atomicLoad(&words[w * 256u + digit]);
                let ones = countOneBits(bits);
                equal += ones;
                if (w < word) {
                    lower += ones;
                } else if (w == word) {
                    lower += countOneBits(bits & ((1u << bit) - 1u));
                }
            }
            places[i] = cursors[digit] + lower;
        }
        workgroupBarrier();
        if (live && lower == 0u) {
            cursors[digit] += equal;
            for (var w = 0u; w < 8u; w++) {
                atomicStore(&words[w * 256u + digit], 0u);
            }
        }
        workgroupBarrier();
    }

    for (var i = 0u; i < RADIX_ITEMS; i++) {
        if (places[i] != 0xffffffffu) {
            atomicStore(&words[places[i]], pairs[i].x);
        }
    }
    workgroupBarrier();
    var targets: array<u32, 8>;
    for (var i = 0u; i < RADIX_ITEMS; i++) {
        let at = i * 256u + lane;
        if (at < live_count) {
            let key = atomicLoad(&words[at]);
            targets[i] = deltas[(key >> step.shift) & 255u] + at;
            keys_out[targets[i]] = key;
        }
    }
    workgroupBarrier();
    for (var i = 0u; i < RADIX_ITEMS; i++) {
        if (places[i] != 0xffffffffu) {
            atomicStore(&words[places[i]], pairs[i].y);
        }
    }
    workgroupBarrier();
    for (var i = 0u; i < RADIX_ITEMS; i++) {
        let at = i * 256u + lane;
        if (at < live_count) {
            values_out[targets[i]] = atomicLoad(&words[at]);
        }
    }
}
