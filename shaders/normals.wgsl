// Shared: two standard normal numbers (Box–Muller), other ones for every pair of words.

fn normals(at: vec2<u32>) -> vec2<f32> {
    let u = (vec2<f32>(hash(at) >> vec2(8u)) + 0.5) / 16777216.0;
    let radius = sqrt(-2.0 * log(u.x));
    return radius * vec2(cos(6.2831853 * u.y), sin(6.2831853 * u.y));
}
