// Shared: one Gaussian's records (see records.wgsl) added up in a fixed order, a Gaussian a thread; those of more than
// LARGE tiles by the whole workgroup.

const LARGE: u32 = 64u;

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> chunk: Chunk;
@group(0) @binding(2) var<uniform> now: Step;
@group(0) @binding(3) var<storage, read> counts: array<u32>;
@group(0) @binding(4) var<storage, read> touched: array<u32>;
@group(0) @binding(5) var<storage, read> starts: array<u32>;
@group(0) @binding(6) var<storage, read> records: array<f32>;

// Thread, first record, number of records.
var<workgroup> large: array<vec3<u32>, 256>;
var<workgroup> large_count: atomic<u32>;
var<workgroup> sums: array<f32, 2304>;

fn collect(i: u32, lane: u32) -> array<f32, 9> {
    var up = array<f32, 9>();
    var first = 0u;
    var many = 0u;
    // Where the pairs did not fit, nothing was drawn.
    if (i < chunk.count && counts[5] == 0u) {
        first = starts[i];
        many = touched[i];
    }
    if (lane == 0u) {
        atomicStore(&large_count, 0u);
    }
    workgroupBarrier();
    if (many > LARGE) {
        large[atomicAdd(&large_count, 1u)] = vec3(lane, first, many);
    } else {
        for (var k = 0u; k < many; k++) {
            for (var f = 0u; f < RECORD; f++) {
                up[f] += records[(first + k) * RECORD + f];
            }
        }
    }
    workgroupBarrier();
    let number = atomicLoad(&large_count);
    for (var l = 0u; l < number; l++) {
        let one = large[l];
        var own = array<f32, 9>();
        for (var k = lane; k < one.z; k += 256u) {
            for (var f = 0u; f < RECORD; f++) {
                own[f] += records[(one.y + k) * RECORD + f];
            }
        }
        for (var f = 0u; f < RECORD; f++) {
            sums[f * 256u + lane] = own[f];
        }
        workgroupBarrier();
        for (var half = 128u; half > 0u; half >>= 1u) {
            if (lane < half) {
                for (var f = 0u; f < RECORD; f++) {
                    sums[f * 256u + lane] += sums[f * 256u + lane + half];
                }
            }
            workgroupBarrier();
        }
        if (lane == one.x) {
            for (var f = 0u; f < RECORD; f++) {
                up[f] = sums[f * 256u];
            }
        }
        workgroupBarrier();
    }
    return up;
}
