// Shared: the camera of one band of the picture, and the projected Gaussian.
//
// A band is a run of tile rows; a picture is one band unless its lists would not fit a binding.

struct View {
    // World→camera: three rows of rotation, translation in w.
    row0: vec4<f32>,
    row1: vec4<f32>,
    row2: vec4<f32>,
    // Where it stands; w: the degree of harmonics that count.
    eye: vec4<f32>,
    // fx, fy, cx, cy in pixels.
    lens: vec4<f32>,
    // x/z and y/z are held inside (x, y) and (z, w) for the Jacobian alone.
    limits: vec4<f32>,
    // w: 1 where normals take the colours' place.
    background: vec4<f32>,
    // Picture width and height in pixels, then in tiles.
    size: vec4<u32>,
    // First tile row, end tile row, Gaussians in the scene, room for (tile, Gaussian) pairs.
    band: vec4<u32>,
}

// log₂ α(p) = a dx² + b dx dy + c dy² + level, (dx, dy) = p − mean.
struct Splat {
    // Mean and half the size of the box around the ellipse α = 1/255.
    place: vec4<f32>,
    // a, b, c, level.
    form: vec4<f32>,
    // r, g, b, camera-space depth.
    tint: vec4<f32>,
}

const TILE: u32 = 16u;
const NEAR: f32 = 0.01;
const LOW_PASS: f32 = 0.3;
const MIN_ALPHA: f32 = 0.003921569;
// log₂(1/255)
const MIN_LEVEL: f32 = -7.9943533;
const MAX_ALPHA: f32 = 0.99;
const MIN_TRANSMITTANCE: f32 = 1e-4;
const CULLED: u32 = 0xffffffffu;

// Integer test: shader compilers may assume that floats are finite.
fn finite(v: f32) -> bool {
    return (bitcast<u32>(v) & 0x7f800000u) != 0x7f800000u;
}
