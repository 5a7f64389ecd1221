// The loss's gradient: a workgroup of 256 threads a tile of 16×16 pixels, one pixel a thread, a channel at a time.
//
// L = a Σ w|x − y| + b Σ w SSIM (b < 0), w a pixel's weight. With W the window, ∂Σ w SSIM/∂x = W w∂μ + 2x W w∂q + y W w∂r, from
// ssim.wgsl's planes.
// Out: ∂L/∂(Σ w rgb) and, x being Σ w rgb + T·background, ∂L/∂T = Σ_c background_c ∂L/∂x_c.
// Under an exposure the loss sees x' = M x + b: with v = ∂L/∂x', ∂L/∂x = Mᵀ v, ∂L/∂M = Σ v xᵀ, ∂L/∂b = Σ v.

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> now: Step;
@group(0) @binding(2) var<storage, read> picture: array<vec4<f32>>;
@group(0) @binding(3) var<storage, read> wanted: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read> partials: array<f32>;
@group(0) @binding(5) var<storage, read_write> pulls: array<vec4<f32>>;
@group(0) @binding(6) var<storage, read> exposures: array<Exposure>;
// Three rows a tile: Σ v_i (x, 1); written only where there is an exposure.
@group(0) @binding(7) var<storage, read_write> tile_changes: array<vec4<f32>>;

// Three maps one after the other.
var<workgroup> maps: array<f32, 3u * AREA>;
var<workgroup> rows: array<f32, 3u * STRIP>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let corner = vec2<i32>(group.xy * TILE) - i32(REACH);
    let mine = vec2(lane % TILE, lane / TILE);
    let pixel = group.xy * TILE + mine;
    let inside = pixel.x < view.size.x && pixel.y < view.size.y;
    let plane = view.size.x * view.size.y;
    let here = pixel.y * view.size.x + pixel.x;
    var drawn = vec4(0.0);
    var want = vec4(-1.0);
    var behind = vec3(0.0);
    if (inside) {
        drawn = picture[here];
        want = wanted[here];
        behind = backdrop(now, pixel);
    }
    let plain = drawn.xyz + (1.0 - drawn.w) * behind;
    let exposed = now.exposure.x != 0.0;
    var x = plain;
    if (exposed) {
        for (var i = 0u; i < 3u; i++) {
            x[i] = dot(exposures[now.words.z].change[i], vec4(plain, 1.0));
        }
    }
    let y = select(want.xyz + (1.0 - want.w) * behind, x, want.w < 0.0);
    var similar = vec3(0.0);
    // Without SSIM in the loss, its kernel did not run.
    if (now.loss.y != 0.0) {
        for (var channel = 0u; channel < 3u; channel++) {
            for (var i = lane; i < AREA; i += 256u) {
                let at = corner + vec2(i32(i % WIDE), i32(i / WIDE));
                let there = all(at >= vec2(0)) && all(at < vec2<i32>(view.size.xy));
                let j = channel * plane + u32(at.y) * view.size.x + u32(at.x);
                for (var map = 0u; map < 3u; map++) {
                    maps[map * AREA + i] = 0.0;
                    if (there) {
                        maps[map * AREA + i] = partials[3u * map * plane + j];
                    }
                }
            }
            workgroupBarrier();
            for (var i = lane; i < STRIP; i += 256u) {
                let from_ = i / TILE * WIDE + i % TILE;
                var sum = vec3(0.0);
                for (var k = 0u; k < 11u; k++) {
                    sum += window(k) * vec3(maps[from_ + k], maps[AREA + from_ + k], maps[2u * AREA + from_ + k]);
                }
                rows[i] = sum.x;
                rows[STRIP + i] = sum.y;
                rows[2u * STRIP + i] = sum.z;
            }
            workgroupBarrier();
            var m = vec3(0.0);
            for (var k = 0u; k < 11u; k++) {
                let at = (mine.y + k) * TILE + mine.x;
                m += window(k) * vec3(rows[at], rows[STRIP + at], rows[2u * STRIP + at]);
            }
            similar[channel] = m.x + 2.0 * x[channel] * m.y + y[channel] * m.z;
            workgroupBarrier();
        }
    }
    var v = vec3(0.0);
    if (inside && want.w >= 0.0) {
        v = now.loss.x * weight_of(here, plane) * sign(x - y) + now.loss.y * similar;
    }
    var pull = v;
    if (exposed) {
        pull = vec3(0.0);
        for (var i = 0u; i < 3u; i++) {
            pull += v[i] * exposures[now.words.z].change[i].xyz;
        }
        // A row at a time, as four planes of 256 in the maps' place.
        for (var i = 0u; i < 3u; i++) {
            let own = v[i] * vec4(plain, 1.0);
            for (var k = 0u; k < 4u; k++) {
                maps[256u * k + lane] = own[k];
            }
            workgroupBarrier();
            for (var half = 128u; half > 0u; half >>= 1u) {
                if (lane < half) {
                    for (var k = 0u; k < 4u; k++) {
                        maps[256u * k + lane] += maps[256u * k + lane + half];
                    }
                }
                workgroupBarrier();
            }
            if (lane == 0u) {
                tile_changes[3u * (group.y * view.size.z + group.x) + i] =
                    vec4(maps[0], maps[256], maps[512], maps[768]);
            }
            workgroupBarrier();
        }
    }
    if (inside) {
        pulls[here] = vec4(pull, dot(pull, behind));
    }
}
