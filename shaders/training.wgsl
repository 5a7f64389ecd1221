// Shared: what one iteration of training needs beyond the camera, and where the run stands.

// Written by the CPU for all iterations before the first.
struct Step {
    // Step sizes of position (times the scene's extent), opacity, rotation, log scale.
    rates: vec4<f32>,
    // Step sizes of degree 0, of the degrees above, of the camera's pose in radians (0: it stands still); the factor of
    // MCMC's noise.
    more_rates: vec4<f32>,
    // What lies behind the subject; w = 1: noise instead.
    background: vec4<f32>,
    // Rates of |x − y| and of SSIM in the loss; of opacity and of scale as such (MCMC).
    loss: vec4<f32>,
    // Seed of the background's noise (low, high), number of the target, degree of harmonics.
    words: vec4<u32>,
    // Seed of MCMC's noise; 1 where the target is a picture of normals; 1 where its pixels have weights.
    more_words: vec4<u32>,
    // Of the photo's exposure: step size (0: it has none), weight of its distance from none; how far before the camera the point
    // lies about which its pose is turned.
    exposure: vec4<f32>,
    moving: Region,
}

struct State {
    // Iterations done.
    iteration: u32,
    // 1: an iteration's pairs did not fit. It and all after it changed nothing; the caller makes room and goes on.
    halted: u32,
    // Pairs that the largest iteration wanted.
    most_pairs: u32,
    // The caller's: Gaussians, room for pairs, planes' stride.
    gaussians: u32,
    room: u32,
    stride: u32,
    pad0: u32,
    pad1: u32,
}
