// Self-test of subgroups: one workgroup of 256 threads.
//
// Every thread writes: lanes before it that hold an odd value (by exclusive sum), the sum of lane numbers over the
// subgroup, the subgroup's size, and the place that subgroup and lane give it (must be a permutation of 0..256).

@group(0) @binding(0) var<storage, read_write> out: array<vec4<u32>, 256>;

@compute @workgroup_size(256)
fn main(
    @builtin(subgroup_id) subgroup: u32,
    @builtin(subgroup_size) lanes: u32,
    @builtin(subgroup_invocation_id) lane: u32,
    @builtin(local_invocation_index) index: u32,
) {
    let before = subgroupExclusiveAdd(lane & 1u);
    let sum = subgroupAdd(lane);
    out[index] = vec4(before, sum, lanes, subgroup * lanes + lane);
}
