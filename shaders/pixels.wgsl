// Shared: one pixel's compositing, front to back (Kerbl et al. 2023, Eq. 3).

override DEPTH: bool = true;

struct Pixel {
    color: vec3<f32>,
    transmittance: f32,
    // Σ w z, and z where the transmittance passes ½.
    depth: vec2<f32>,
    open: bool,
}

// The splat at `place`, `form`, `tint` over the pixel centre `at`.
fn blend(p: ptr<function, Pixel>, at: vec2<f32>, mean: vec2<f32>, form: vec4<f32>, tint: vec4<f32>) {
    let d = at - mean;
    let e = fma(d.y, fma(form.z, d.y, form.y * d.x), fma(form.x * d.x, d.x, form.w));
    if (e >= MIN_LEVEL && (*p).open) {
        let w = min(exp2(e), MAX_ALPHA) * (*p).transmittance;
        let next = (*p).transmittance - w;
        if (next > MIN_TRANSMITTANCE) {
            (*p).color += w * tint.xyz;
            if (DEPTH) {
                (*p).depth.x += w * tint.w;
                if ((*p).transmittance > 0.5 && next <= 0.5) {
                    (*p).depth.y = tint.w;
                }
            }
            (*p).transmittance = next;
        } else {
            (*p).open = false;
        }
    }
}

// Spreads the even bits of a Morton code's index inside a 16×16 tile.
fn morton(i: u32) -> vec2<u32> {
    let x = (i & 1u) | ((i >> 1u) & 2u) | ((i >> 2u) & 4u) | ((i >> 3u) & 8u);
    let j = i >> 1u;
    let y = (j & 1u) | ((j >> 1u) & 2u) | ((j >> 2u) & 4u) | ((j >> 3u) & 8u);
    return vec2(x, y);
}
