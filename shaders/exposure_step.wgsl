// Exposure's step: the tiles' sums added in a fixed order, what holds it near none, Adam (Kingma and Ba 2015). One
// workgroup of 256 threads.
//
//   L += hold · (|M − I|² + |b|²)

@group(0) @binding(0) var<storage, read> state: State;
@group(0) @binding(1) var<uniform> view: View;
@group(0) @binding(2) var<uniform> now: Step;
@group(0) @binding(3) var<storage, read> counts: array<u32>;
// Three rows a tile: Σ v_i (x, 1).
@group(0) @binding(4) var<storage, read> tile_changes: array<vec4<f32>>;
@group(0) @binding(5) var<storage, read_write> exposures: array<Exposure>;
@group(0) @binding(6) var<storage, read> corrections: array<vec2<f32>>;

var<workgroup> sums: array<vec4<f32>, 768>;

@compute @workgroup_size(256)
fn main(@builtin(local_invocation_index) lane: u32) {
    let tiles = view.size.z * view.size.w;
    var own = array<vec4<f32>, 3>();
    for (var t = lane; t < tiles; t += 256u) {
        for (var i = 0u; i < 3u; i++) {
            own[i] += tile_changes[3u * t + i];
        }
    }
    for (var i = 0u; i < 3u; i++) {
        sums[256u * i + lane] = own[i];
    }
    workgroupBarrier();
    for (var half = 128u; half > 0u; half >>= 1u) {
        if (lane < half) {
            for (var i = 0u; i < 3u; i++) {
                sums[256u * i + lane] += sums[256u * i + lane + half];
            }
        }
        workgroupBarrier();
    }
    let total = sums[0] + sums[256] + sums[512];
    // Nothing was drawn where the run is halted or the pairs did not fit.
    if (lane == 0u && state.halted == 0u && counts[5] == 0u && finite(dot(total, vec4(1.0)))) {
        var e = exposures[now.words.z];
        let steps = e.steps.x + 1.0;
        let c = corrections[min(u32(steps), arrayLength(&corrections) - 1u)];
        for (var i = 0u; i < 3u; i++) {
            var none = vec4(0.0);
            none[i] = 1.0;
            let g = sums[256u * i] + 2.0 * now.exposure.y * (e.change[i] - none);
            e.first[i] = 0.9 * e.first[i] + 0.1 * g;
            e.second[i] = 0.999 * e.second[i] + 0.001 * g * g;
            e.change[i] -= now.exposure.x * e.first[i] * c.x / (sqrt(e.second[i] * c.y) + 1e-15);
        }
        e.steps.x = steps;
        exposures[now.words.z] = e;
    }
}
