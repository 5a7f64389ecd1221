// Shared: one round of 3D Gaussian Splatting as Markov Chain Monte Carlo (Kheradmand et al. 2024): dead Gaussians move to
// live ones, drawn in proportion to their opacity, and a few more join them.

struct Mcmc {
    gaussians: u32,
    stride: u32,
    // How many join.
    added: u32,
    // A weight of opacity 1; the sum of all weights fits a word.
    unit: u32,
    // A Gaussian no more opaque than this is dead.
    faintest: f32,
    pad0: u32,
    pad1: u32,
    pad2: u32,
    seed: vec4<u32>,
    // Outside, one is neither dead nor copied.
    moving: Region,
}

fn opaque(logit: f32) -> f32 {
    return 1.0 / (1.0 + exp(-clamp(logit, -80.0, 80.0)));
}
