// Shared: what a Gaussian adds to the weights, and 1 if it is dead. One that is not a number is dead.

fn share(core: vec4<f32>) -> vec2<u32> {
    let logit = core.w;
    if (keeps_still(core, mcmc.moving)) {
        return vec2(0u);
    }
    if (logit == logit && (bitcast<u32>(logit) & 0x7fffffffu) <= 0x7f800000u) {
        let o = opaque(logit);
        if (o > mcmc.faintest) {
            return vec2(max(u32(o * f32(mcmc.unit)), 1u), 0u);
        }
    }
    return vec2(0u, 1u);
}
