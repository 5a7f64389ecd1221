// Radix, first step of a pass: how often each of 256 digits occurs in each block of 2,048 keys. 256 threads a block.
//
// table[digit · blocks + block] = number of keys of the block whose digit it is. Keys CULLED count only if `keep` is set.

struct Pass {
    shift: u32,
    // Where in `counts` the number of keys stands.
    slot: u32,
    // 0: keys equal to CULLED are left out.
    keep: u32,
    // 1: values are the keys' own indices.
    index: u32,
}

@group(0) @binding(0) var<uniform> step: Pass;
@group(0) @binding(1) var<storage, read> counts: array<u32>;
@group(0) @binding(2) var<storage, read> keys: array<u32>;
@group(0) @binding(3) var<storage, read_write> table: array<u32>;

var<workgroup> digits: array<atomic<u32>, 256>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let n = counts[step.slot];
    atomicStore(&digits[lane], 0u);
    workgroupBarrier();
    for (var i = 0u; i < RADIX_ITEMS; i++) {
        let at = group.x * RADIX_BLOCK + i * 256u + lane;
        if (at < n) {
            let key = keys[at];
            if (step.keep != 0u || key != 0xffffffffu) {
                atomicAdd(&digits[(key >> step.shift) & 255u], 1u);
            }
        }
    }
    workgroupBarrier();
    let blocks = (n + RADIX_BLOCK - 1u) / RADIX_BLOCK;
    // A dispatch may be larger than the list.
    if (group.x < blocks) {
        table[lane * blocks + group.x] = atomicLoad(&digits[lane]);
    }
}
