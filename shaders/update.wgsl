// Update: from the pairs' gradients to moved Gaussians in one pass: sum, differentiate the projection, Adam (Kingma and
// Ba 2015). One thread a Gaussian, 256 a workgroup. A Gaussian that no pixel depends on keeps still.
//
//   m ← β₁ m + (1 − β₁) g,  v ← β₂ v + (1 − β₂) g²,  p ← p − rate · m c₁ / (√(v c₂) + ε),  cᵢ = 1 / (1 − βᵢᵗ)

@group(0) @binding(8) var<storage, read_write> core: array<vec4<f32>>;
@group(0) @binding(9) var<storage, read_write> harmonics: array<vec4<f32>>;
// Three planes of m as core's, then three of v. Where m of the log scales has its fourth number, a Gaussian's steps stand.
@group(0) @binding(10) var<storage, read_write> core_moments: array<vec4<f32>>;
@group(0) @binding(11) var<storage, read_write> harmonics_m: array<vec4<f32>>;
@group(0) @binding(12) var<storage, read_write> harmonics_v: array<vec4<f32>>;
// Σ |∂L/∂mean| in normalised device units, and in how many pictures each was seen.
@group(0) @binding(13) var<storage, read_write> seen: array<vec2<f32>>;
// c₁, c₂ by t.
@group(0) @binding(14) var<storage, read> corrections: array<vec2<f32>>;

const BETA1: f32 = 0.9;
const BETA2: f32 = 0.999;
const EPSILON: f32 = 1e-15;

fn change(m: vec4<f32>, v: vec4<f32>, rate: vec4<f32>, c: vec2<f32>) -> vec4<f32> {
    return rate * (m * c.x) / (sqrt(v * c.y) + EPSILON);
}

fn step_core(at: u32, value: vec4<f32>, gradient: vec4<f32>, rate: vec4<f32>, c: vec2<f32>) -> vec4<f32> {
    let second = at + 3u * chunk.stride;
    let m = BETA1 * core_moments[at] + (1.0 - BETA1) * gradient;
    let v = BETA2 * core_moments[second] + (1.0 - BETA2) * gradient * gradient;
    core_moments[at] = m;
    core_moments[second] = v;
    let moved = value - change(m, v, rate, c);
    core[at] = moved;
    return moved;
}

// MCMC's noise (Kheradmand et al. 2024): along the Gaussian's own shape, the fainter the harder.
fn disturbed(i: u32, place: vec4<f32>, form: vec4<f32>, size: vec3<f32>) -> vec4<f32> {
    let o = 1.0 / (1.0 + exp(-clamp(place.w, -80.0, 80.0)));
    let gate = 1.0 / (1.0 + exp(100.0 * (o - 0.005)));
    let n = vec3(normals(now.more_words.xy ^ vec2(i, 0u)), normals(now.more_words.xy ^ vec2(i, 1u)).x);
    let r = turn(form * inverseSqrt(dot(form, form)));
    let push = now.more_rates.w * gate * (r * (exp(2.0 * size) * (n * r)));
    if (finite(dot(push, vec3(1.0)))) {
        return place + vec4(push, 0.0);
    }
    return place;
}

fn step_harmonics(at: u32, value: vec4<f32>, gradient: vec4<f32>, rate: vec4<f32>, c: vec2<f32>) {
    let m = BETA1 * harmonics_m[at] + (1.0 - BETA1) * gradient;
    let v = BETA2 * harmonics_v[at] + (1.0 - BETA2) * gradient * gradient;
    harmonics_m[at] = m;
    harmonics_v[at] = v;
    harmonics[at] = value - change(m, v, rate, c);
}

@compute @workgroup_size(256)
fn main(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let up = collect(id.x, lane);
    var shift = vec3(0.0);
    var turn = vec3(0.0);
    if (id.x < chunk.count) {
        let i = id.x;
        let some = up[0] != 0.0 || up[1] != 0.0 || up[2] != 0.0 || up[3] != 0.0 || up[4] != 0.0 || up[5] != 0.0
            || up[6] != 0.0 || up[7] != 0.0 || up[8] != 0.0;
        if (some) {
            let stride = chunk.stride;
            let degree = u32(view.eye.w);
            let planes = planes_of(degree);
            let c0 = core[i];
            let q0 = core[stride + i];
            let s0 = core[2u * stride + i];
            var sh: array<vec4<f32>, 12>;
            for (var j = 0u; j < 12u; j++) {
                sh[j] = vec4(0.0);
                if (j < planes) {
                    sh[j] = harmonics[j * stride + i];
                }
            }
            var counted = sh;
            cut(&counted, degree);
            let g = project_backward(c0, q0, s0.xyz, &counted, up);
            if (g.sound) {
                shift = g.shift;
                turn = g.turn;
                let pull = g.mean * vec2<f32>(view.size.xy) * 0.5;
                seen[i] += vec2(length(pull), 1.0);
                let t = core_moments[2u * stride + i].w + 1.0;
                let c = corrections[min(u32(t), arrayLength(&corrections) - 1u)];
                // MCMC's regularisers: L += rate · (mean opacity) + rate · (mean scale).
                let o = 1.0 / (1.0 + exp(-c0.w));
                let share = 1.0 / f32(chunk.count);
                let opacity = g.opacity + now.loss.z * share * o * (1.0 - o);
                let scale = g.scale + now.loss.w * share / 3.0 * exp(s0.xyz);
                let still = keeps_still(c0, now.moving);
                let r = select(now.rates, vec4(0.0, now.rates.y, 0.0, 0.0), still);
                let place = step_core(i, c0, vec4(g.position, opacity), vec4(r.xxx, r.y), c);
                let form = step_core(stride + i, q0, g.rotation, vec4(r.z), c);
                let size = step_core(2u * stride + i, s0, vec4(scale, 0.0), vec4(r.www, 0.0), c);
                if (now.more_rates.w != 0.0 && !still) {
                    core[i] = disturbed(i, place, form, size.xyz);
                }
                core_moments[2u * stride + i].w = t;
                let flat_ = now.more_rates.x;
                let more = select(now.more_rates.y, 0.0, still);
                let v = g.color;
                // Normals say nothing of colours.
                for (var m = 0u; m < 4u && view.background.w == 0.0; m++) {
                    let b = g.basis[m];
                    let at = 3u * m * stride + i;
                    if (3u * m < planes) {
                        let rate = select(vec4(more), vec4(flat_, flat_, flat_, more), m == 0u);
                        step_harmonics(at, sh[3u * m], vec4(v * b.x, v.x * b.y), rate, c);
                    }
                    if (3u * m + 1u < planes) {
                        step_harmonics(at + stride, sh[3u * m + 1u], vec4(v.yz * b.y, v.xy * b.z), vec4(more), c);
                        step_harmonics(at + 2u * stride, sh[3u * m + 2u], vec4(v.z * b.z, v * b.w), vec4(more), c);
                    }
                }
            }
        }
    }
    sum_pose(group.x, lane, shift, turn);
}
