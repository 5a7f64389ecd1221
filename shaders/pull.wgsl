// Shared: one pixel's walk front to back, the way back of pixels.wgsl.
//
// With v = ∂L/∂colour and v_T = ∂L/∂(final transmittance), what is still to come from behind,
// S_i = Σ_{j>i} w_j (c_j·v) + T_final v_T, needs one number a pixel: it starts as C·v + T_final v_T and loses w_i (c_i·v)
// at each splat, and ∂L/∂α_i = T_i (c_i·v) − S_i / (1 − α_i).

struct Walk {
    transmittance: f32,
    // S
    behind: f32,
    open: bool,
    v: vec3<f32>,
}

// What one splat gets of one pixel: g = ∂L/∂(ln α), and w. Both 0 where it is not drawn.
struct Share {
    g: f32,
    w: f32,
}

fn exponent(d: vec2<f32>, form: vec4<f32>) -> f32 {
    return fma(d.y, fma(form.z, d.y, form.y * d.x), fma(form.x * d.x, d.x, form.w));
}

// For e ≥ MIN_LEVEL and an open pixel.
fn walk(p: ptr<function, Walk>, e: f32, tint: vec3<f32>) -> Share {
    let raw = exp2(e);
    let alpha = min(raw, MAX_ALPHA);
    let w = alpha * (*p).transmittance;
    let next = (*p).transmittance - w;
    if (!(next > MIN_TRANSMITTANCE)) {
        (*p).open = false;
        return Share(0.0, 0.0);
    }
    let cv = dot(tint, (*p).v);
    (*p).behind -= w * cv;
    // A saturated alpha no longer depends on shape or opacity.
    let g = select(0.0, alpha * ((*p).transmittance * cv - (*p).behind / (1.0 - alpha)), raw <= MAX_ALPHA);
    (*p).transmittance = next;
    return Share(g, w);
}
