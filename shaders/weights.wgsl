// Shared: how much a pixel counts in the loss. `wanted` has the weights after its `count` pixels, four in one.

fn weight_of(pixel: u32, count: u32) -> f32 {
    if (now.more_words.w == 0u) {
        return 1.0;
    }
    let four = wanted[count + pixel / 4u];
    return four[pixel % 4u];
}
