//! Where the colours of a texture come from, as a picture of the same layout, and that picture for the eye.

use image::{Rgb, RgbImage};

use super::bake::Baked;
use super::fill::pad;

/// Colours that are told apart by the colour-blind too (Okabe and Ito 2008): bluish green, sky blue, orange.
pub const SEEN: [u8; 3] = [0, 158, 115];
pub const MIRRORED: [u8; 3] = [86, 180, 233];
pub const INVENTED: [u8; 3] = [230, 159, 0];

/// How much of the texture's own light and shade stays to be seen.
const SHADE: f32 = 0.5;

/// Shares of what was invented (red), the photo (green) and mirror images of it (blue) in every texel; together 255, but for
/// rounding.
pub fn shares(baked: &Baked) -> RgbImage {
    let mut all: Vec<[f32; 3]> =
        baked.from.iter().map(|[seen, mirrored]| [1.0 - seen - mirrored, *seen, *mirrored]).collect();
    pad(&mut all, |i| baked.from[i][0] >= 0.0, baked.size);
    let size = baked.size as u32;
    RgbImage::from_fn(size, size, |x, y| {
        Rgb(all[y as usize * baked.size + x as usize].map(|v| (v.clamp(0.0, 1.0) * 255.0).round() as u8))
    })
}

/// The shares as colours of [`SEEN`], [`MIRRORED`] and [`INVENTED`], under the texture's light and shade.
pub fn shown(shares: &RgbImage, texture: &RgbImage) -> RgbImage {
    RgbImage::from_fn(shares.width(), shares.height(), |x, y| {
        let (u, v) = (x * texture.width() / shares.width(), y * texture.height() / shares.height());
        let [r, g, b] = texture.get_pixel(u, v).0.map(f32::from);
        let light = 1.0 - SHADE + SHADE * (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255.0;
        let [invented, seen, mirrored] = shares.get_pixel(x, y).0.map(f32::from);
        let sum = (invented + seen + mirrored).max(1.0);
        Rgb(std::array::from_fn(|k| {
            let mixed =
                invented * f32::from(INVENTED[k]) + seen * f32::from(SEEN[k]) + mirrored * f32::from(MIRRORED[k]);
            (light * mixed / sum) as u8
        }))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_drawn_in_their_colours_and_reach_beyond_the_charts() {
        let from = vec![[1.0, 0.0], [0.0, 1.0], [0.0, 0.0], [-1.0; 2]];
        let picture = shares(&Baked { size: 2, color: vec![[0.0; 3]; 4], from });
        let at = |x, y| picture.get_pixel(x, y).0;
        assert_eq!([at(0, 0), at(1, 0), at(0, 1)], [[0, 255, 0], [0, 0, 255], [255, 0, 0]]);
        // A texel that no triangle covers: its neighbours' mean.
        assert_eq!(at(1, 1), [85, 85, 85]);
        let white = shown(&picture, &RgbImage::from_pixel(4, 4, Rgb([255; 3])));
        assert_eq!(
            [white.get_pixel(0, 0).0, white.get_pixel(1, 0).0, white.get_pixel(0, 1).0],
            [SEEN, MIRRORED, INVENTED]
        );
        let black = shown(&picture, &RgbImage::from_pixel(1, 1, Rgb([0; 3])));
        assert!(black.get_pixel(1, 0).0[2] > 70, "what is black keeps a colour");
    }
}
