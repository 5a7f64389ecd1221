// Project: one thread a Gaussian of one chunk, 256 a workgroup.
//
// In:  core (planes of vec4: position + logit opacity, quaternion w x y z, log scales), harmonics (12 planes of vec4).
// Out: splats (at the Gaussian's own place), depth key (bits of z, CULLED where it cannot be seen), number of tiles;
//      totals: Gaussians seen, and pairs as 256·high + low, which cannot overflow.
//
// EWA splatting (Zwicker et al. 2001) as in Kerbl et al. 2023, §4: Σ' = J W R S Sᵀ Rᵀ Wᵀ Jᵀ + 0.3 I.
// Its determinant is |n₀ × n₁|² + ε (|n₀|² + |n₁|²) + ε² with N = J W R S: nothing cancels, however thin the Gaussian.

struct Chunk {
    // The first Gaussian of the chunk in the scene, and how many it holds.
    first: u32,
    count: u32,
    pad0: u32,
    pad1: u32,
}

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
    let q0 = core[chunk.count + i];
    let s0 = core[2u * chunk.count + i];
    if (!(finite(c0.x) && finite(c0.y) && finite(c0.z) && c0.w == c0.w && (bitcast<u32>(c0.w) & 0x7fffffffu) <= 0x7f800000u)) {
        return 0u;
    }
    let p = c0.xyz;
    let point = vec3(dot(view.row0.xyz, p), dot(view.row1.xyz, p), dot(view.row2.xyz, p))
        + vec3(view.row0.w, view.row1.w, view.row2.w);
    let z = point.z;
    // Beyond ±80 the sigmoid is 0 or 1 in single precision.
    let opacity = 1.0 / (1.0 + exp(-clamp(c0.w, -80.0, 80.0)));
    if (!(finite(z) && z > NEAR && z < 1e10 && opacity >= MIN_ALPHA)) {
        return 0u;
    }
    let iq = inverseSqrt(dot(q0, q0));
    let q = q0 * iq;
    let w = q.x;
    let x = q.y;
    let y = q.z;
    let k = q.w;
    let scale = exp(s0.xyz);
    // Columns of R · diag(scale).
    let m0 = scale.x * vec3(1.0 - 2.0 * (y * y + k * k), 2.0 * (x * y + w * k), 2.0 * (x * k - w * y));
    let m1 = scale.y * vec3(2.0 * (x * y - w * k), 1.0 - 2.0 * (x * x + k * k), 2.0 * (y * k + w * x));
    let m2 = scale.z * vec3(2.0 * (x * k + w * y), 2.0 * (y * k - w * x), 1.0 - 2.0 * (x * x + y * y));
    let ax = vec3(dot(view.row0.xyz, m0), dot(view.row0.xyz, m1), dot(view.row0.xyz, m2));
    let ay = vec3(dot(view.row1.xyz, m0), dot(view.row1.xyz, m1), dot(view.row1.xyz, m2));
    let az = vec3(dot(view.row2.xyz, m0), dot(view.row2.xyz, m1), dot(view.row2.xyz, m2));
    let iz = 1.0 / z;
    let raw = point.xy * iz;
    let t = vec2(min(max(raw.x, view.limits.x), view.limits.y), min(max(raw.y, view.limits.z), view.limits.w));
    let n0 = view.lens.x * iz * (ax - t.x * az);
    let n1 = view.lens.y * iz * (ay - t.y * az);
    let xx = dot(n0, n0);
    let xy = dot(n0, n1);
    let yy = dot(n1, n1);
    let area = cross(n0, n1);
    let det = dot(area, area) + LOW_PASS * (xx + yy) + LOW_PASS * LOW_PASS;
    let inverse = 1.0 / det;
    let mean = view.lens.xy * raw + view.lens.zw;
    let sound = finite(det) && det < 1e36 && inverse > 0.0 && finite(mean.x) && finite(mean.y) && finite(iq)
        && abs(mean.x + mean.y) < 1e9 && iq < 1e18;
    if (!sound) {
        return 0u;
    }
    let conic = vec3(yy + LOW_PASS, -xy, xx + LOW_PASS) * inverse;
    let extent = max(2.0 * log(opacity * 255.0), 0.0);
    let half = sqrt(extent * vec2(xx + LOW_PASS, yy + LOW_PASS));
    let top = f32(view.band.x * TILE);
    let bottom = f32(min(view.band.y * TILE, view.size.y));
    if (!(mean.x + half.x > 0.0 && mean.x - half.x < f32(view.size.x) && mean.y + half.y > top
        && mean.y - half.y < bottom)) {
        return 0u;
    }
    const LOG2_E = 1.442695;
    let place = vec4(mean, half);
    let form = vec4(-0.5 * LOG2_E * conic.x, -LOG2_E * conic.y, -0.5 * LOG2_E * conic.z, log2(opacity));
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
    for (var j = 0u; j < 12u; j++) {
        sh[j] = harmonics[j * chunk.count + i];
    }
    let d = p - view.eye.xyz;
    let rgb = shade(d / max(length(d), 1e-20), &sh) + 0.5;
    if (!finite(rgb.x + rgb.y + rgb.z)) {
        return 0u;
    }
    splats[i] = Splat(place, form, vec4(max(rgb, vec3(0.0)), z));
    keys[chunk.first + i] = bitcast<u32>(z);
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
