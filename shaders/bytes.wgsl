// Bytes: a picture of four floats a pixel as four bytes, a quarter of what is read back. 256 threads, a pixel each.
//
// b_c = min(⌊256 · clamp(v_c, 0, 1)⌋, 255) for c = r, g, b, α; a word is Σ_c b_c · 256^c. A product with 256 is exact, so the
// bytes are the same wherever they are made.

// x: pixels.
@group(0) @binding(0) var<uniform> size: vec4<u32>;
@group(0) @binding(1) var<storage, read> picture: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read_write> bytes: array<u32>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= size.x) {
        return;
    }
    let b = min(vec4<u32>(clamp(picture[id.x], vec4(0.0), vec4(1.0)) * 256.0), vec4(255u));
    bytes[id.x] = b.x | (b.y << 8u) | (b.z << 16u) | (b.w << 24u);
}
