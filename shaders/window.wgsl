// Shared: the Gaussian window of SSIM, σ 1.5, 11 × 11, as two passes of 11; and a tile with 5 pixels around it.

const REACH: u32 = 5u;
const WIDE: u32 = 26u;
const AREA: u32 = 676u;
const STRIP: u32 = 416u;

fn window(k: u32) -> f32 {
    switch (max(k, 5u) - min(k, 5u)) {
        case 0u: { return 0.26601171; }
        case 1u: { return 0.21300554; }
        case 2u: { return 0.10936069; }
        case 3u: { return 0.036000773; }
        case 4u: { return 0.0075987582; }
        default: { return 0.0010283801; }
    }
}
