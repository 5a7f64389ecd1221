// Shared: the 16 real spherical harmonics to degree 3 as 3D Gaussian Splatting stores them (Kerbl et al. 2023; signs
// with the Condon–Shortley phase). `at(k)` of the caller's coefficients is summed as Σ b_k(d) · sh_k.

// Coefficient k of the three channels stands at floats 3k, 3k+1, 3k+2 of the Gaussian's twelve vec4.
fn shade(d: vec3<f32>, s: ptr<function, array<vec4<f32>, 12>>) -> vec3<f32> {
    let x = d.x;
    let y = d.y;
    let z = d.z;
    let xx = x * x;
    let yy = y * y;
    let zz = z * z;
    var c = 0.28209479 * (*s)[0].xyz;
    c += -0.4886025 * y * vec3((*s)[0].w, (*s)[1].xy);
    c += 0.4886025 * z * vec3((*s)[1].zw, (*s)[2].x);
    c += -0.4886025 * x * (*s)[2].yzw;
    c += 1.0925484 * x * y * (*s)[3].xyz;
    c += -1.0925484 * y * z * vec3((*s)[3].w, (*s)[4].xy);
    c += 0.31539157 * (2.0 * zz - xx - yy) * vec3((*s)[4].zw, (*s)[5].x);
    c += -1.0925484 * x * z * (*s)[5].yzw;
    c += 0.5462742 * (xx - yy) * (*s)[6].xyz;
    c += -0.5900436 * y * (3.0 * xx - yy) * vec3((*s)[6].w, (*s)[7].xy);
    c += 2.8906114 * x * y * z * vec3((*s)[7].zw, (*s)[8].x);
    c += -0.4570458 * y * (4.0 * zz - xx - yy) * (*s)[8].yzw;
    c += 0.37317633 * z * (2.0 * zz - 3.0 * xx - 3.0 * yy) * (*s)[9].xyz;
    c += -0.4570458 * x * (4.0 * zz - xx - yy) * vec3((*s)[9].w, (*s)[10].xy);
    c += 1.4453057 * z * (xx - yy) * vec3((*s)[10].zw, (*s)[11].x);
    c += -0.5900436 * x * (xx - 3.0 * yy) * (*s)[11].yzw;
    return c;
}

// How many of the twelve vec4 hold coefficients up to a degree.
fn planes_of(degree: u32) -> u32 {
    return (3u * (degree + 1u) * (degree + 1u) + 3u) / 4u;
}

// Coefficients above the degree that share a vec4 with those below count as 0.
fn cut(s: ptr<function, array<vec4<f32>, 12>>, degree: u32) {
    if (degree == 0u) {
        (*s)[0].w = 0.0;
    }
    if (degree == 2u) {
        (*s)[6].w = 0.0;
    }
}
