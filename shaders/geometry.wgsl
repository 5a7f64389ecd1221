// Shared: one Gaussian onto the picture plane, EWA splatting (Zwicker et al. 2001) as in Kerbl et al. 2023, §4:
// Σ' = N Nᵀ + 0.3 I with N = J W R S.
//
// Its determinant is |n₀ × n₁|² + ε (|n₀|² + |n₁|²) + ε²: nothing cancels, however thin the Gaussian.

struct Geometry {
    // In front of the camera and finite.
    sound: bool,
    // Camera space.
    point: vec3<f32>,
    opacity: f32,
    quaternion: vec4<f32>,
    inverse_norm: f32,
    scale: vec3<f32>,
    // Rows of W · R · diag(scale).
    ax: vec3<f32>,
    ay: vec3<f32>,
    az: vec3<f32>,
    // x/z and y/z, and the same held inside the limits.
    raw: vec2<f32>,
    held: vec2<f32>,
    n0: vec3<f32>,
    n1: vec3<f32>,
    mean: vec2<f32>,
    // Diagonal of Σ'.
    spread: vec2<f32>,
    conic: vec3<f32>,
}

// From position + logit opacity, quaternion, log scales.
fn geometry(c0: vec4<f32>, q0: vec4<f32>, s0: vec3<f32>) -> Geometry {
    var g: Geometry;
    g.sound = false;
    if (!(finite(c0.x) && finite(c0.y) && finite(c0.z) && c0.w == c0.w && (bitcast<u32>(c0.w) & 0x7fffffffu) <= 0x7f800000u)) {
        return g;
    }
    let p = c0.xyz;
    g.point = vec3(dot(view.row0.xyz, p), dot(view.row1.xyz, p), dot(view.row2.xyz, p))
        + vec3(view.row0.w, view.row1.w, view.row2.w);
    let z = g.point.z;
    // Beyond ±80 the sigmoid is 0 or 1 in single precision.
    g.opacity = 1.0 / (1.0 + exp(-clamp(c0.w, -80.0, 80.0)));
    if (!(finite(z) && z > NEAR && z < 1e10 && g.opacity >= MIN_ALPHA)) {
        return g;
    }
    g.inverse_norm = inverseSqrt(dot(q0, q0));
    g.quaternion = q0 * g.inverse_norm;
    g.scale = exp(s0);
    let r = turn(g.quaternion);
    let m0 = g.scale.x * r[0];
    let m1 = g.scale.y * r[1];
    let m2 = g.scale.z * r[2];
    g.ax = vec3(dot(view.row0.xyz, m0), dot(view.row0.xyz, m1), dot(view.row0.xyz, m2));
    g.ay = vec3(dot(view.row1.xyz, m0), dot(view.row1.xyz, m1), dot(view.row1.xyz, m2));
    g.az = vec3(dot(view.row2.xyz, m0), dot(view.row2.xyz, m1), dot(view.row2.xyz, m2));
    let iz = 1.0 / z;
    g.raw = g.point.xy * iz;
    g.held = vec2(min(max(g.raw.x, view.limits.x), view.limits.y), min(max(g.raw.y, view.limits.z), view.limits.w));
    g.n0 = view.lens.x * iz * (g.ax - g.held.x * g.az);
    g.n1 = view.lens.y * iz * (g.ay - g.held.y * g.az);
    let xx = dot(g.n0, g.n0);
    let xy = dot(g.n0, g.n1);
    let yy = dot(g.n1, g.n1);
    let area = cross(g.n0, g.n1);
    let det = dot(area, area) + LOW_PASS * (xx + yy) + LOW_PASS * LOW_PASS;
    let inverse = 1.0 / det;
    g.mean = view.lens.xy * g.raw + view.lens.zw;
    g.spread = vec2(xx, yy) + LOW_PASS;
    g.conic = vec3(g.spread.y, -xy, g.spread.x) * inverse;
    g.sound = finite(det) && det < 1e36 && inverse > 0.0 && finite(g.mean.x) && finite(g.mean.y)
        && finite(g.inverse_norm) && abs(g.mean.x + g.mean.y) < 1e9 && g.inverse_norm < 1e18;
    return g;
}

// Number of the shortest axis, of equal ones the first.
fn shortest(log_scales: vec3<f32>) -> u32 {
    var least = select(0u, 1u, log_scales.y < log_scales.x);
    if (log_scales.z < min(log_scales.x, log_scales.y)) {
        least = 2u;
    }
    return least;
}

// That axis in camera space, towards the camera; w: 1, or −1 where it was turned round.
fn normal(g: Geometry, axis: u32) -> vec4<f32> {
    let r = turn(g.quaternion);
    var a = r[0];
    if (axis == 1u) {
        a = r[1];
    } else if (axis == 2u) {
        a = r[2];
    }
    let n = vec3(dot(view.row0.xyz, a), dot(view.row1.xyz, a), dot(view.row2.xyz, a));
    let facing = select(1.0, -1.0, dot(n, g.point) > 0.0);
    return vec4(facing * n, facing);
}
