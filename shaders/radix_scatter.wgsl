// Radix, third step of a pass: every key and value to its place, equal digits in their old order. 256 threads a block
// of 4,096 keys.
//
// 256 keys at a time: each thread sets its bit in the mask of its digit; the bits below its own are the equal keys
// before it. No subgroup operation, so it is right on any adapter.

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

var<workgroup> offsets: array<u32, 256>;
// Word w of digit d stands at 256 w + d: neighbours in different banks.
var<workgroup> masks: array<atomic<u32>, 2048>;

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
    let total = digit_totals[lane];
    offsets[lane] = total;
    for (var w = 0u; w < 8u; w++) {
        atomicStore(&masks[w * 256u + lane], 0u);
    }
    workgroupBarrier();
    for (var reach = 1u; reach < 256u; reach <<= 1u) {
        var add = 0u;
        if (lane >= reach) {
            add = offsets[lane - reach];
        }
        workgroupBarrier();
        offsets[lane] += add;
        workgroupBarrier();
    }
    offsets[lane] = offsets[lane] - total + table[lane * blocks + group.x];
    let word = lane / 32u;
    let bit = lane % 32u;
    var at = group.x * RADIX_BLOCK + lane;
    var ahead = load(at, n);
    for (var i = 0u; i < RADIX_ITEMS; i++) {
        let key = ahead.x;
        let value = ahead.y;
        let live = at < n && (step.keep != 0u || key != 0xffffffffu);
        at += 256u;
        // The next pair is on its way while this one is ranked.
        if (i + 1u < RADIX_ITEMS) {
            ahead = load(at, n);
        }
        let digit = (key >> step.shift) & 255u;
        if (live) {
            atomicOr(&masks[word * 256u + digit], 1u << bit);
        }
        workgroupBarrier();
        var before = 0u;
        var equal = 0u;
        if (live) {
            for (var w = 0u; w < 8u; w++) {
                let bits = atomicLoad(&masks[w * 256u + digit]);
                let ones = countOneBits(bits);
                equal += ones;
                if (w < word) {
                    before += ones;
                } else if (w == word) {
                    before += countOneBits(bits & ((1u << bit) - 1u));
                }
            }
            let to = offsets[digit] + before;
            keys_out[to] = key;
            values_out[to] = value;
        }
        workgroupBarrier();
        if (live && before == 0u) {
            offsets[digit] += equal;
            for (var w = 0u; w < 8u; w++) {
                atomicStore(&masks[w * 256u + digit], 0u);
            }
        }
        workgroupBarrier();
    }
}
