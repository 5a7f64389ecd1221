// Shared: the way back of geometry.wgsl and harmonics.wgsl, from the sums over a Gaussian's pixels (records.wgsl) to its
// parameters. The formulas are those of the CPU's `projection::backward`.

// b_k(d), four to a vec4, 0 above the degree.
fn basis(d: vec3<f32>, degree: u32) -> array<vec4<f32>, 4> {
    let x = d.x;
    let y = d.y;
    let z = d.z;
    let xx = x * x;
    let yy = y * y;
    let zz = z * z;
    var b = array<vec4<f32>, 4>();
    b[0].x = 0.28209479;
    if (degree > 0u) {
        b[0] = vec4(0.28209479, -0.4886025 * y, 0.4886025 * z, -0.4886025 * x);
    }
    if (degree > 1u) {
        b[1] = vec4(1.0925484 * x * y, -1.0925484 * y * z, 0.31539157 * (2.0 * zz - xx - yy), -1.0925484 * x * z);
        b[2].x = 0.5462742 * (xx - yy);
    }
    if (degree > 2u) {
        b[2] = vec4(b[2].x, -0.5900436 * y * (3.0 * xx - yy), 2.8906114 * x * y * z, -0.4570458 * y * (4.0 * zz - xx - yy));
        b[3] = vec4(
            0.37317633 * z * (2.0 * zz - 3.0 * xx - 3.0 * yy),
            -0.4570458 * x * (4.0 * zz - xx - yy),
            1.4453057 * z * (xx - yy),
            -0.5900436 * x * (xx - 3.0 * yy),
        );
    }
    return b;
}

// Σ_k w_k ∇b_k(d).
fn basis_gradient(d: vec3<f32>, w: array<vec4<f32>, 4>, degree: u32) -> vec3<f32> {
    let x = d.x;
    let y = d.y;
    let z = d.z;
    if (degree == 0u) {
        return vec3(0.0);
    }
    var g = 0.4886025 * vec3(-w[0].w, -w[0].y, w[0].z);
    if (degree > 1u) {
        g += vec3(
            1.0925484 * (y * w[1].x - z * w[1].w) - 0.63078314 * x * w[1].z + 1.0925484 * x * w[2].x,
            1.0925484 * (x * w[1].x - z * w[1].y) - 0.63078314 * y * w[1].z - 1.0925484 * y * w[2].x,
            -1.0925484 * (y * w[1].y + x * w[1].w) + 1.26156628 * z * w[1].z,
        );
    }
    if (degree > 2u) {
        let xx = x * x;
        let yy = y * y;
        let zz = z * z;
        g.x += -3.5402616 * x * y * w[2].y + 2.8906114 * y * z * w[2].z + 0.9140916 * x * y * w[2].w
            - 2.23905798 * x * z * w[3].x - 0.4570458 * (4.0 * zz - 3.0 * xx - yy) * w[3].y
            + 2.8906114 * x * z * w[3].z - 1.7701308 * (xx - yy) * w[3].w;
        g.y += -1.7701308 * (xx - yy) * w[2].y + 2.8906114 * x * z * w[2].z
            - 0.4570458 * (4.0 * zz - xx - 3.0 * yy) * w[2].w - 2.23905798 * y * z * w[3].x
            + 0.9140916 * x * y * w[3].y - 2.8906114 * y * z * w[3].z + 3.5402616 * x * y * w[3].w;
        g.z += 2.8906114 * x * y * w[2].z - 3.6563664 * y * z * w[2].w
            + 0.37317633 * (6.0 * zz - 3.0 * xx - 3.0 * yy) * w[3].x - 3.6563664 * x * z * w[3].y
            + 1.4453057 * (xx - yy) * w[3].z;
    }
    return g;
}

struct Gradient {
    // False where nothing is to be learnt from it.
    sound: bool,
    position: vec3<f32>,
    // Of the logit.
    opacity: f32,
    rotation: vec4<f32>,
    // Of the logarithms.
    scale: vec3<f32>,
    // ∂L/∂rgb after the clamp at 0, and b_k: their product is the harmonics' gradient.
    color: vec3<f32>,
    basis: array<vec4<f32>, 4>,
    // ∂L/∂(mean in pixels).
    mean: vec2<f32>,
    // Of a left-multiplied increment of the world→camera pose: translation, rotation vector.
    shift: vec3<f32>,
    turn: vec3<f32>,
}

fn project_backward(
    c0: vec4<f32>,
    q0: vec4<f32>,
    s0: vec3<f32>,
    s: ptr<function, array<vec4<f32>, 12>>,
    up: array<f32, 9>,
) -> Gradient {
    var out: Gradient;
    out.sound = false;
    let degree = u32(view.eye.w);
    let g = geometry(c0, q0, s0);
    let some = up[0] != 0.0 || up[1] != 0.0 || up[2] != 0.0 || up[3] != 0.0 || up[4] != 0.0 || up[5] != 0.0
        || up[6] != 0.0 || up[7] != 0.0 || up[8] != 0.0;
    if (!g.sound || !some) {
        return out;
    }

    // Colour: the clamp at 0 lets no gradient through below it.
    var d = c0.xyz - view.eye.xyz;
    let inverse_distance = 1.0 / max(length(d), 1e-20);
    d *= inverse_distance;
    let rgb = shade(d, s) + 0.5;
    let tint = vec3(up[6], up[7], up[8]);
    let of_normals = view.background.w != 0.0;
    let v = select(vec3(0.0), tint, (rgb > vec3(0.0)) & vec3(!of_normals));
    out.color = v;
    out.basis = basis(d, degree);
    var weights: array<vec4<f32>, 4>;
    for (var m = 0u; m < 4u; m++) {
        let a = (*s)[3u * m];
        let b = (*s)[3u * m + 1u];
        let c = (*s)[3u * m + 2u];
        weights[m] = vec4(dot(v, a.xyz), dot(v, vec3(a.w, b.xy)), dot(v, vec3(b.zw, c.x)), dot(v, c.yzw));
    }
    let along = basis_gradient(d, weights, degree);
    let direction = (along - dot(along, d) * d) * inverse_distance;

    // α = o · exp(−½ (a dx² + 2 b dx dy + c dy²)).
    out.opacity = up[0] * (1.0 - g.opacity);
    let a = g.conic.x;
    let b = g.conic.y;
    let c = g.conic.z;
    out.mean = vec2(a * up[1] + b * up[2], b * up[1] + c * up[2]);
    // ∂L/∂conic as a symmetric matrix, then ∂L/∂Σ' = −P V P.
    let va = -0.5 * up[3];
    let vb = -0.5 * up[4];
    let vc = -0.5 * up[5];
    let ta = a * va + b * vb;
    let tb = a * vb + b * vc;
    let tc = b * va + c * vb;
    let td = b * vb + c * vc;
    let ga = -(ta * a + tb * b);
    let gb = -(ta * b + tb * c);
    let gc = -(tc * b + td * c);
    let dn0 = 2.0 * (ga * g.n0 + gb * g.n1);
    let dn1 = 2.0 * (gb * g.n0 + gc * g.n1);

    // N = J · axes with J = [[jx, 0, −jx·tan₀], [0, jy, −jy·tan₁]].
    let iz = 1.0 / g.point.z;
    let jx = view.lens.x * iz;
    let jy = view.lens.y * iz;
    let dax = jx * dn0;
    let day = jy * dn1;
    let daz = -jx * g.held.x * dn0 - jy * g.held.y * dn1;
    let dj00 = dot(dn0, g.ax);
    let dj02 = dot(dn0, g.az);
    let dj11 = dot(dn1, g.ay);
    let dj12 = dot(dn1, g.az);
    // The mean is never clamped.
    var dp = vec3(
        jx * out.mean.x,
        jy * out.mean.y,
        -(jx * g.raw.x * out.mean.x + jy * g.raw.y * out.mean.y) - (jx * dj00 + jy * dj11) * iz,
    );
    // J02 = −fx·tan/z: with tan = x/z inside the limits, a constant outside.
    if (g.held.x == g.raw.x) {
        dp.x -= jx * iz * dj02;
        dp.z += 2.0 * jx * iz * g.held.x * dj02;
    } else {
        dp.z += jx * iz * g.held.x * dj02;
    }
    if (g.held.y == g.raw.y) {
        dp.y -= jy * iz * dj12;
        dp.z += 2.0 * jy * iz * g.held.y * dj12;
    } else {
        dp.z += jy * iz * g.held.y * dj12;
    }
    let w0 = view.row0.xyz;
    let w1 = view.row1.xyz;
    let w2 = view.row2.xyz;
    out.position = dp.x * w0 + dp.y * w1 + dp.z * w2 + direction;

    // axes = W · R · diag(scale); column j of ∂L/∂(R · diag(scale)) is Wᵀ · (dax, day, daz)_j.
    let r = turn(g.quaternion);
    let dm0 = dax.x * w0 + day.x * w1 + daz.x * w2;
    let dm1 = dax.y * w0 + day.y * w1 + daz.y * w2;
    let dm2 = dax.z * w0 + day.z * w1 + daz.z * w2;
    out.scale = vec3(dot(r[0], dm0), dot(r[1], dm1), dot(r[2], dm2)) * g.scale;
    var r0 = dm0 * g.scale.x;
    var r1 = dm1 * g.scale.y;
    var r2 = dm2 * g.scale.z;
    var n = vec4(0.0);
    if (of_normals) {
        // n = ± W · R's column.
        let axis = shortest(s0);
        n = normal(g, axis);
        let world = n.w * (tint.x * w0 + tint.y * w1 + tint.z * w2);
        if (axis == 0u) {
            r0 += world;
        } else if (axis == 1u) {
            r1 += world;
        } else {
            r2 += world;
        }
    }
    let u = g.quaternion;
    // r0.y is ∂L/∂R₁₀ and so on: columns first.
    let q = 2.0 * vec4(
        u.w * (r0.y - r1.x) + u.z * (r2.x - r0.z) + u.y * (r1.z - r2.y),
        u.z * (r1.x + r0.y) + u.w * (r2.x + r0.z) - 2.0 * u.y * (r1.y + r2.z) + u.x * (r1.z - r2.y),
        u.y * (r1.x + r0.y) + u.w * (r2.y + r1.z) - 2.0 * u.z * (r0.x + r2.z) + u.x * (r2.x - r0.z),
        u.y * (r2.x + r0.z) + u.z * (r2.y + r1.z) - 2.0 * u.w * (r0.x + r1.y) + u.x * (r0.y - r1.x),
    );
    out.rotation = (q - dot(q, u) * u) * g.inverse_norm;

    // Pose: p' = ω × p + v, axes' = ω × axes, n' = ω × n, and the eye moves by −Wᵀ v.
    out.shift = dp + vec3(dot(w0, direction), dot(w1, direction), dot(w2, direction));
    out.turn = cross(g.point, dp) + cross(n.xyz, tint) + cross(vec3(g.ax.x, g.ay.x, g.az.x), vec3(dax.x, day.x, daz.x))
        + cross(vec3(g.ax.y, g.ay.y, g.az.y), vec3(dax.y, day.y, daz.y))
        + cross(vec3(g.ax.z, g.ay.z, g.az.z), vec3(dax.z, day.z, daz.z));
    let sum = dot(out.position, vec3(1.0)) + out.opacity + dot(out.rotation, vec4(1.0)) + dot(out.scale, vec3(1.0))
        + up[6] + up[7] + up[8];
    out.sound = finite(sum);
    return out;
}
