// Shared: one round of density control (Kerbl et al. 2023, §5.2): clone small Gaussians and split large ones where the
// picture pulls hardest at their place, drop those that have faded.

struct Refine {
    gaussians: u32,
    stride: u32,
    // At most so many are cloned or split.
    most: u32,
    // How many there will be; known once they are counted.
    after: u32,
    // Mean |∂L/∂mean| above which one grows, size above which it is split, logit opacity below which it goes.
    threshold: f32,
    split_size: f32,
    faintest: f32,
    // Logit that no opacity exceeds after a reset.
    ceiling: f32,
    seed: vec4<u32>,
    moving: Region,
}

// What becomes of a Gaussian.
const STAYS: u32 = 0u;
const CLONED: u32 = 1u;
const SPLIT: u32 = 2u;
// Bits of a source: the Gaussian is new; it is half of a split one.
const NEW: u32 = 0x80000000u;
const HALF: u32 = 0x40000000u;
const SOURCE: u32 = 0x3fffffffu;
