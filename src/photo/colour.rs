//! Colours of a photo whose ICC profile says that they are not sRGB: Display P3 of phones, Adobe RGB of cameras.

use image::RgbImage;
use moxcms::{ColorProfile, DataColorSpace, Layout, TransformOptions};

/// Levels by which a profile may move colours and still be one of sRGB: makers round its curve and its primaries each in their own way.
const SAME: u8 = 2;
/// Of each channel, how many levels are tried for that.
const TRIED: u32 = 6;

/// Turns colours by `profile` to sRGB, in place, by the perceptual intent. A profile that is damaged, of another kind than RGB, or one of
/// sRGB leaves them as they are: a photo is not refused for its profile.
pub(super) fn to_srgb(pixels: &mut RgbImage, profile: &[u8]) {
    let Ok(from) = ColorProfile::new_from_slice(profile) else { return };
    if from.color_space != DataColorSpace::Rgb {
        return;
    }
    let to = ColorProfile::new_srgb();
    let Ok(transform) = from.create_transform_8bit(Layout::Rgb, &to, Layout::Rgb, TransformOptions::default()) else {
        return;
    };
    let turned = |colours: &[u8]| {
        let mut made = vec![0; colours.len()];
        transform.transform(colours, &mut made).ok().map(|()| made)
    };
    let level = |i: u32| (i % TRIED * 255 / (TRIED - 1)) as u8;
    let grid: Vec<u8> =
        (0..TRIED.pow(3)).flat_map(|i| [level(i), level(i / TRIED), level(i / TRIED / TRIED)]).collect();
    let moved = turned(&grid).is_some_and(|made| made.iter().zip(&grid).any(|(a, b)| a.abs_diff(*b) > SAME));
    if moved && let Some(made) = turned(pixels.as_raw()) {
        pixels.copy_from_slice(&made);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::Rgb;

    fn turned(colour: [u8; 3], profile: &[u8]) -> [u8; 3] {
        let mut pixels = RgbImage::from_pixel(3, 2, Rgb(colour));
        to_srgb(&mut pixels, profile);
        assert!(pixels.pixels().all(|p| *p == pixels[(0, 0)]));
        pixels[(0, 0)].0
    }

    #[test]
    fn wide_gamuts_become_srgb() {
        let near = |a: [u8; 3], b: [u8; 3]| a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 1);
        let p3 = ColorProfile::new_display_p3().encode().unwrap();
        // By the matrices of CSS Color 4, section 18, and sRGB's curve: 161.8, 99.1, 72.0.
        assert_eq!(turned([128; 3], &p3), [128; 3]);
        assert!(near(turned([153, 102, 77], &p3), [162, 99, 72]), "{:?}", turned([153, 102, 77], &p3));
        // What sRGB cannot show is cut off.
        assert_eq!(turned([255, 0, 0], &p3), [255, 0, 0]);
        // By the primaries and the gamma of Adobe RGB (1998), sections 4.3.1 and 4.3.4: 66.0, 151.4, 73.8.
        let adobe = ColorProfile::new_adobe_rgb().encode().unwrap();
        assert!(near(turned([100, 150, 80], &adobe), [66, 151, 74]), "{:?}", turned([100, 150, 80], &adobe));
    }

    #[test]
    fn other_profiles_leave_colours_as_they_are() {
        let colour = [200, 30, 90];
        assert_eq!(turned(colour, &ColorProfile::new_srgb().encode().unwrap()), colour);
        assert_eq!(turned(colour, &ColorProfile::new_gray_with_gamma(2.2).encode().unwrap()), colour);
        let p3 = ColorProfile::new_display_p3().encode().unwrap();
        for cut in [0, 1, 127, 128, 200, p3.len() / 2] {
            assert_eq!(turned(colour, &p3[..cut]), colour, "{cut}");
        }
        assert_eq!(turned(colour, b"no profile at all"), colour);
    }

    #[test]
    fn damaged_profiles_stop_nothing() {
        let whole = [ColorProfile::new_display_p3(), ColorProfile::new_adobe_rgb()].map(|p| p.encode().unwrap());
        let mut state = 1u32;
        let mut random = |below: usize| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as usize % below
        };
        for i in 0..2000 {
            let mut profile = whole[i % 2].clone();
            for _ in 0..=random(4) {
                let at = random(profile.len());
                profile[at] = random(256) as u8;
            }
            profile.truncate(profile.len() - random(2) * random(profile.len()));
            turned([200, 30, 90], &profile);
        }
    }
}
