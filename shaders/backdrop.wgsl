// Shared: what lies behind the subject at a pixel: a flat colour, or noise, the same as on the CPU.

fn backdrop(step: Step, pixel: vec2<u32>) -> vec3<f32> {
    if (step.background.w == 0.0) {
        return step.background.xyz;
    }
    let h = hash(step.words.xy ^ pixel);
    let bits = vec3(h.x, (h.x >> 20u) | (h.y << 12u), h.y >> 8u) & vec3(0xfffffu);
    return vec3<f32>(bits) / 1048575.0;
}
