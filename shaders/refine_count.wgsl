// Refine, fourth step: Gaussians that come of each block of 1,024 items. 256 threads a block.

@group(0) @binding(0) var<uniform> refine: Refine;
@group(0) @binding(1) var<storage, read> items: array<u32>;
@group(0) @binding(2) var<storage, read> order: array<u32>;
@group(0) @binding(3) var<storage, read> core: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read> kinds: array<u32>;
@group(0) @binding(5) var<storage, read_write> block_sums: array<u32>;

var<workgroup> sum: atomic<u32>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    if (lane == 0u) {
        atomicStore(&sum, 0u);
    }
    workgroupBarrier();
    var own = 0u;
    for (var k = 0u; k < SCAN_ITEMS; k++) {
        own += offspring(group.x * SCAN_BLOCK + k * 256u + lane, items[3]).x;
    }
    atomicAdd(&sum, own);
    workgroupBarrier();
    if (lane == 0u) {
        block_sums[group.x] = atomicLoad(&sum);
    }
}
