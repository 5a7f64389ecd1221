// Refine, fifth step: whence each Gaussian of the next list comes. 256 threads a block of 1,024 items, four each.

@group(0) @binding(0) var<uniform> refine: Refine;
// Word 0: out, how many there will be.
@group(0) @binding(1) var<storage, read_write> items: array<u32>;
@group(0) @binding(2) var<storage, read> order: array<u32>;
@group(0) @binding(3) var<storage, read> core: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read> kinds: array<u32>;
@group(0) @binding(5) var<storage, read> block_sums: array<u32>;
@group(0) @binding(6) var<storage, read_write> sources: array<u32>;

var<workgroup> sums: array<u32, 256>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let count = items[3];
    let first = group.x * SCAN_BLOCK + lane * SCAN_ITEMS;
    var own: array<vec2<u32>, 4>;
    var sum = 0u;
    for (var k = 0u; k < SCAN_ITEMS; k++) {
        own[k] = offspring(first + k, count);
        sum += own[k].x;
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
    var at = block_sums[group.x] + sums[lane] - sum;
    for (var k = 0u; k < SCAN_ITEMS; k++) {
        for (var c = 0u; c < own[k].x; c++) {
            sources[at] = own[k].y;
            at++;
        }
        if (first + k + 1u == count) {
            items[0] = at;
        }
    }
}
