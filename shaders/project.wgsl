// Project: one thread a Gaussian of one chunk, 256 a workgroup.
//
// In:  core (planes of vec4: position + logit opacity, quaternion w x y z, log scales), harmonics (12 planes of vec4).
// Out: splats (at the Gaussian's own place), depth key (bits of z, CULLED where it cannot be seen), number of tiles;
//      totals: Gaussians seen, and pairs as 256·high + low, which cannot overflow.
//
// The ellipse is geometry.wgsl's; the colour is Σ b_k(d) · sh_k + ½, clamped at 0, d from the eye to the Gaussian, or the
// normal where that is wanted: the shortest axis (of equal ones the first) in camera space, towards the camera.

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> chunk: Chunk;
@group(0) @binding(2) var<storage, read> core: array<vec4<f32>>;
@group(0) @binding(3) var<storage, read> harmonics: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> splats: array<Splat>;
@group(0) @binding(5) var<storage, read_write> keys: array<u32>;
@group(0) @binding(6) var<storage, read_write> touched: array<u32>;
// Seen, pairs low, pairs high.
@group(0) @binding(7) var<storage, read_write> totals: array<atomic<u32>>;

var<workgroup> seen: atomic<u32>;
var<workgroup> pairs: atomic<u32>;

// Number of tiles; 0 where the Gaussian cannot be seen.
fn project(i: u32) -> u32 {
    let c0 = core[i];
    let g = geometry(c0, core[chunk.stride + i], core[2u * chunk.stride + i].xyz);
    if (!g.sound) {
        return 0u;
    }
    let extent = max(2.0 * log(g.opacity * 255.0), 0.0);
    let half = sqrt(extent * g.spread);
    let top = f32(view.band.x * TILE);
    let bottom = f32(min(view.band.y * TILE, view.size.y));
    if (!(g.mean.x + half.x > 0.0 && g.mean.x - half.x < f32(view.size.x) && g.mean.y + half.y > top
        && g.mean.y - half.y < bottom)) {
        return 0u;
    }
    const LOG2_E = 1.442695;
    let place = vec4(g.mean, half);
    let form =
        vec4(-0.5 * LOG2_E * g.conic.x, -LOG2_E * g.conic.y, -0.5 * LOG2_E * g.conic.z, log2(g.opacity));
    let rows = tile_rows(place, view);
    var tiles = 0u;
    for (var row = rows.x; row < rows.y; row++) {
        let span = tile_span(place, form, row, view);
        tiles += span.y - span.x;
    }
    if (tiles == 0u) {
        return 0u;
    }
    var sh: array<vec4<f32>, 12>;
    let planes = planes_of(u32(view.eye.w));
    for (var j = 0u; j < 12u; j++) {
        sh[j] = vec4(0.0);
        if (j < planes) {
            sh[j] = harmonics[j * chunk.stride + i];
        }
    }
    cut(&sh, u32(view.eye.w));
    let d = c0.xyz - view.eye.xyz;
    let rgb = shade(d / max(length(d), 1e-20), &sh) + 0.5;
    if (!finite(rgb.x + rgb.y + rgb.z)) {
        return 0u;
    }
    var tint = max(rgb, vec3(0.0));
    if (view.background.w != 0.0) {
        tint = normal(g, shortest(core[2u * chunk.stride + i].xyz)).xyz;
    }
    splats[i] = Splat(place, form, vec4(tint, g.point.z));
    keys[chunk.first + i] = bitcast<u32>(g.point.z);
    return tiles;
}

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    if (lane == 0u) {
        atomicStore(&seen, 0u);
        atomicStore(&pairs, 0u);
    }
    workgroupBarrier();
    if (id.x < chunk.count) {
        let tiles = project(id.x);
        touched[chunk.first + id.x] = tiles;
        if (tiles == 0u) {
            keys[chunk.first + id.x] = CULLED;
        } else {
            atomicAdd(&seen, 1u);
            atomicAdd(&pairs, tiles);
        }
    }
    workgroupBarrier();
    if (lane == 0u) {
        let sum = atomicLoad(&pairs);
        atomicAdd(&totals[0], atomicLoad(&seen));
        atomicAdd(&totals[1], sum & 255u);
        atomicAdd(&totals[2], sum >> 8u);
    }
}
