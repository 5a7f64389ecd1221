// SSIM forward: a workgroup of 256 threads a tile of 16×16 pixels, one pixel a thread, a channel at a time.
//
// x is the render over the background, under the photo's exposure where it has one, y the target over the same; where the target is held back, y = x. With the
// filtered maps μx, μy, q = x² + y², r = x·y (Wang et al. 2004; only σx² + σy² enters):
//   SSIM = (2 μx μy + C1)(2 (r − μx μy) + C2) / ((μx² + μy² + C1)(q − μx² − μy² + C2)), zero outside the picture.
// Out: ∂SSIM/∂μx, ∂SSIM/∂q, ∂SSIM/∂r at every pixel, nine planes; Σ|x − y| and Σ(1 − SSIM) of every tile; all times the
// pixel's weight.

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> now: Step;
// Σ w rgb over black, alpha.
@group(0) @binding(2) var<storage, read> picture: array<vec4<f32>>;
// Colour times alpha; alpha, or −1 − alpha where held back. Then the pixels' weights, where they have any: weights.wgsl.
@group(0) @binding(3) var<storage, read> wanted: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> partials: array<f32>;
@group(0) @binding(5) var<storage, read_write> sums: array<vec2<f32>>;
@group(0) @binding(6) var<storage, read> exposures: array<Exposure>;

const C1: f32 = 1e-4;
const C2: f32 = 9e-4;

var<workgroup> xs: array<f32, AREA>;
var<workgroup> ys: array<f32, AREA>;
// Filtered along the rows: x, y, x² + y², x·y.
var<workgroup> rows: array<vec4<f32>, STRIP>;
var<workgroup> totals: array<vec2<f32>, 256>;

fn pair(at: vec2<i32>, channel: u32) -> vec2<f32> {
    if (any(at < vec2(0)) || any(at >= vec2<i32>(view.size.xy))) {
        return vec2(0.0);
    }
    let i = u32(at.y) * view.size.x + u32(at.x);
    let backs = backdrop(now, vec2<u32>(at));
    let behind = backs[channel];
    let drawn = picture[i];
    var x = drawn[channel] + (1.0 - drawn.w) * behind;
    if (now.exposure.x != 0.0) {
        x = dot(exposures[now.words.z].change[channel], vec4(drawn.xyz + (1.0 - drawn.w) * backs, 1.0));
    }
    let want = wanted[i];
    if (want.w < 0.0) {
        return vec2(x, x);
    }
    return vec2(x, want[channel] + (1.0 - want.w) * behind);
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let corner = vec2<i32>(group.xy * TILE) - i32(REACH);
    let mine = vec2(lane % TILE, lane / TILE);
    let pixel = group.xy * TILE + mine;
    let inside = pixel.x < view.size.x && pixel.y < view.size.y;
    let plane = view.size.x * view.size.y;
    var total = vec2(0.0);
    for (var channel = 0u; channel < 3u; channel++) {
        for (var i = lane; i < AREA; i += 256u) {
            let v = pair(corner + vec2(i32(i % WIDE), i32(i / WIDE)), channel);
            xs[i] = v.x;
            ys[i] = v.y;
        }
        workgroupBarrier();
        for (var i = lane; i < STRIP; i += 256u) {
            let from_ = i / TILE * WIDE + i % TILE;
            var sum = vec4(0.0);
            for (var k = 0u; k < 11u; k++) {
                let x = xs[from_ + k];
                let y = ys[from_ + k];
                sum += window(k) * vec4(x, y, x * x + y * y, x * y);
            }
            rows[i] = sum;
        }
        workgroupBarrier();
        var m = vec4(0.0);
        for (var k = 0u; k < 11u; k++) {
            m += window(k) * rows[(mine.y + k) * TILE + mine.x];
        }
        let both = m.x * m.y;
        let squares = m.x * m.x + m.y * m.y;
        let a1 = 2.0 * both + C1;
        let a2 = 2.0 * (m.w - both) + C2;
        let b1 = squares + C1;
        let b2 = m.z - squares + C2;
        let inverse = 1.0 / (b1 * b2);
        let ssim = a1 * a2 * inverse;
        if (inside) {
            let i = pixel.y * view.size.x + pixel.x;
            let i1 = inverse * b2;
            let i2 = inverse * b1;
            let weight = weight_of(i, plane);
            partials[channel * plane + i] = weight * (2.0 * m.y * (a2 - a1) * inverse - 2.0 * m.x * ssim * (i1 - i2));
            partials[(3u + channel) * plane + i] = weight * (-ssim * i2);
            partials[(6u + channel) * plane + i] = weight * (2.0 * a1 * inverse);
            let centre = (mine.y + REACH) * WIDE + mine.x + REACH;
            total += weight * vec2(abs(xs[centre] - ys[centre]), 1.0 - ssim);
        }
        workgroupBarrier();
    }
    totals[lane] = total;
    workgroupBarrier();
    for (var half = 128u; half > 0u; half >>= 1u) {
        if (lane < half) {
            totals[lane] += totals[lane + half];
        }
        workgroupBarrier();
    }
    if (lane == 0u) {
        sums[group.y * view.size.z + group.x] = totals[0];
    }
}
