//! Pictures as networks want them: planes of normalised numbers.

use super::Tensor;
use crate::Result;

/// (value − mean) / deviation, a number a channel.
#[derive(Clone, Copy, Debug)]
pub struct Normalise {
    pub mean: [f32; 3],
    pub deviation: [f32; 3],
}

/// Of ImageNet: SAM, Depth Anything.
pub const IMAGENET: Normalise = Normalise { mean: [0.485, 0.456, 0.406], deviation: [0.229, 0.224, 0.225] };
/// Of CLIP.
pub const CLIP: Normalise =
    Normalise { mean: [0.481_454_66, 0.457_827_5, 0.408_210_73], deviation: [0.268_629_54, 0.261_302_6, 0.275_777_1] };

/// Pixels 0..1, row-major, width × height, to a tensor 1 × 3 × H × W; a frame larger than the picture is padded with 0 after
/// normalising, on the right and below.
///
/// # Errors
/// None where the pixels fit their size.
pub fn planes(
    pixels: &[[f32; 3]],
    [width, height]: [usize; 2],
    [frame_width, frame_height]: [usize; 2],
    by: Normalise,
) -> Result<Tensor> {
    let mut data = vec![0.0; 3 * frame_width * frame_height];
    for (c, plane) in data.chunks_exact_mut(frame_width * frame_height).enumerate() {
        for (row, line) in pixels.chunks_exact(width).take(height).zip(plane.chunks_exact_mut(frame_width)) {
            for (pixel, value) in row.iter().zip(line) {
                *value = (pixel[c] - by.mean[c]) / by.deviation[c];
            }
        }
    }
    Tensor::new(&[1, 3, frame_height, frame_width], data)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn channels_are_normalised_and_the_rest_is_zero() {
        let by = Normalise { mean: [0.5, 0.0, 0.25], deviation: [0.5, 1.0, 0.25] };
        let t = planes(&[[1.0, 0.5, 0.0], [0.5, 0.25, 0.5]], [2, 1], [3, 2], by).unwrap();
        assert_eq!(t.shape, [1, 3, 2, 3]);
        assert_eq!(t.data[..6], [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(t.data[6..8], [0.5, 0.25]);
        assert_eq!(t.data[12..14], [-1.0, 1.0]);
    }
}
