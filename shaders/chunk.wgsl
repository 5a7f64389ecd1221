// Shared: which Gaussians a kernel works on.

struct Chunk {
    // The first one's number in the scene, how many, and how far the planes of their parameters are apart.
    first: u32,
    count: u32,
    stride: u32,
    pad: u32,
}
