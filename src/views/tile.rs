//! A tile of six views, two across and three down, cut into pictures with a matte.

use image::{Rgb, RgbImage, RgbaImage};

use super::six_views;
use crate::photo::Plane;
use crate::splat::{Camera, Frame};
use crate::{Error, Result};

/// Pixels of a tile: width, height.
pub const SIZE: (u32, u32) = (640, 960);
/// Side of a view.
const SIDE: u32 = 320;
/// Less of the background's colour than this, 0..255 a channel, is background where it meets the border.
const BACKGROUND: f32 = 14.0;
/// So much more, and it is all subject.
const FRINGE: f32 = 24.0;

/// A view of the tile.
#[derive(Clone, Debug)]
pub struct View {
    /// sRGB 0..1, straight: the background taken out where there is enough of the subject to tell.
    pub colour: Vec<[f32; 3]>,
    /// Subject, 0..1.
    pub alpha: Plane,
}

/// Six views in the order of their azimuths: row by row, left before right.
///
/// An alpha channel that cuts something out is the matte; else what has the border's colour, from the border inwards, is
/// background (Zero123++ draws on grey, its derivatives on white).
///
/// # Errors
/// A usage error for another size, or a view with nothing on it.
pub fn cut(tile: &RgbaImage) -> Result<Vec<View>> {
    if tile.dimensions() != SIZE {
        return Err(Error::usage("six views")
            .expected(format!("a tile of {} × {} pixels: two views across, three down", SIZE.0, SIZE.1))
            .found(format!("{} × {}", tile.width(), tile.height())));
    }
    let has_alpha = tile.pixels().any(|p| p.0[3] < 128);
    (0..6)
        .map(|i| {
            let part = image::imageops::crop_imm(tile, i % 2 * SIDE, i / 2 * SIDE, SIDE, SIDE).to_image();
            let view =
                if has_alpha { by_alpha(&part) } else { by_border(&image::DynamicImage::from(part).into_rgb8()) };
            let covered = view.alpha.data.iter().filter(|a| **a > 0.5).count();
            if covered < 100 || covered as f32 > 0.97 * (SIDE * SIDE) as f32 {
                return Err(Error::usage("six views")
                    .expected("a subject on an even background in each view")
                    .found(format!("view {}: {covered} pixels of a subject", i + 1)));
            }
            Ok(view)
        })
        .collect()
}

/// Normals of the six views from a tile of pictures of them, each a unit vector in its camera's space (x right, y down,
/// z forward): −1 to 1 as 0 to 255, x right, y up, z towards the camera. 0 where nothing is shown: Zero123++'s own
/// rule is a length under 0.2.
///
/// # Errors
/// A usage error for another size, or a view with no normals.
pub fn normals(tile: &RgbImage) -> Result<Vec<Vec<[f32; 3]>>> {
    if tile.dimensions() != SIZE {
        return Err(Error::usage("normals of the six views")
            .expected(format!("a tile of {} × {} pixels: two views across, three down", SIZE.0, SIZE.1))
            .found(format!("{} × {}", tile.width(), tile.height())));
    }
    let unit = |p: &Rgb<u8>| {
        let [r, g, b] = p.0.map(|v| (f32::from(v) - 127.5) / 127.5);
        let n = glam::Vec3::new(r, -g, -b);
        if n.length() < 0.2 { [0.0; 3] } else { n.normalize().to_array() }
    };
    (0..6)
        .map(|i| {
            let part = image::imageops::crop_imm(tile, i % 2 * SIDE, i / 2 * SIDE, SIDE, SIDE).to_image();
            let all: Vec<[f32; 3]> = part.pixels().map(unit).collect();
            // A surface that is seen faces the camera.
            let facing = all.iter().filter(|n| n[2] < 0.0).count();
            if facing < 100 {
                return Err(Error::usage("normals of the six views")
                    .expected("a subject's normals in each view, blue where it faces the camera")
                    .found(format!("view {}: {facing} pixels that face it", i + 1)));
            }
            Ok(all)
        })
        .collect()
}

fn by_alpha(part: &RgbaImage) -> View {
    let colour = part.pixels().map(|p| [p.0[0], p.0[1], p.0[2]].map(|v| f32::from(v) / 255.0)).collect();
    let data = part.pixels().map(|p| f32::from(p.0[3]) / 255.0).collect();
    View { colour, alpha: Plane { width: SIDE as usize, height: SIDE as usize, data } }
}

fn by_border(part: &RgbImage) -> View {
    let (side, n) = (SIDE as usize, (SIDE * SIDE) as usize);
    let on_border = |i: usize| i.is_multiple_of(side) || i / side == 0 || i % side + 1 == side || i / side + 1 == side;
    let pixel = |i: usize| part.get_pixel((i % side) as u32, (i / side) as u32).0.map(f32::from);
    let ground: [f32; 3] = std::array::from_fn(|c| {
        let mut values: Vec<f32> = (0..n).filter(|i| on_border(*i)).map(|i| pixel(i)[c]).collect();
        let middle = values.len() / 2;
        *values.select_nth_unstable_by(middle, f32::total_cmp).1
    });
    let far = |i: usize| pixel(i).iter().zip(ground).map(|(v, g)| (v - g).abs()).fold(0.0, f32::max);
    // What looks like the ground and is joined to the border.
    let (labels, found) = crate::models::region::regions(side, side, |i| far(i) < BACKGROUND, |_| 0.0);
    let outside = |i: usize| labels[i] != 0 && found[labels[i] as usize - 1].touches_border;
    let mut alpha = vec![1.0f32; n];
    for (i, a) in alpha.iter_mut().enumerate() {
        if outside(i) {
            *a = 0.0;
            continue;
        }
        // Next to the ground a pixel may be a mixture of both.
        let (x, y) = (i % side, i / side);
        let near = (x > 0 && outside(i - 1))
            || (x + 1 < side && outside(i + 1))
            || (y > 0 && outside(i - side))
            || (y + 1 < side && outside(i + side));
        if near {
            *a = ((far(i) - BACKGROUND / 2.0) / FRINGE).clamp(0.0, 1.0);
        }
    }
    let straight = |i: usize| {
        let (p, a) = (pixel(i), alpha[i]);
        let own = |c: usize| if a < 0.05 { ground[c] } else { ((p[c] - (1.0 - a) * ground[c]) / a).clamp(0.0, 255.0) };
        std::array::from_fn(|c| own(c) / 255.0)
    };
    let colour = (0..n).map(straight).collect();
    View { colour, alpha: Plane { width: side, height: side, data: alpha } }
}

/// The views as the optimisation wants them: with the paper's cameras, over grey.
pub fn framed(views: &[View], grey: [f32; 3]) -> Vec<(Camera, Frame)> {
    let frame = |view: &View| {
        let over = |(c, &a): (&[f32; 3], &f32)| std::array::from_fn(|k| c[k] * a + (1.0 - a) * grey[k]);
        Frame {
            width: view.alpha.width,
            height: view.alpha.height,
            color: view.colour.iter().zip(&view.alpha.data).map(over).collect(),
            alpha: view.alpha.data.clone(),
            depth: vec![0.0; view.alpha.data.len()],
            median_depth: vec![0.0; view.alpha.data.len()],
        }
    };
    six_views(SIDE).into_iter().zip(views).map(|(camera, view)| (camera, frame(view))).collect()
}

/// Opaque.
pub fn with_alpha(tile: &RgbImage) -> RgbaImage {
    RgbaImage::from_fn(tile.width(), tile.height(), |x, y| {
        let Rgb([r, g, b]) = *tile.get_pixel(x, y);
        image::Rgba([r, g, b, 255])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disc a view, each with its own colour and place, on `ground`.
    fn tile(ground: [u8; 3]) -> RgbImage {
        RgbImage::from_fn(SIZE.0, SIZE.1, |x, y| {
            let i = x / SIDE + 2 * (y / SIDE);
            let (dx, dy) = ((x % SIDE) as f32 - 160.0, (y % SIDE) as f32 - 100.0 - 20.0 * i as f32);
            Rgb(if dx * dx + dy * dy < 2500.0 { [200, 30 * i as u8, 20] } else { ground })
        })
    }

    #[test]
    fn views_come_row_by_row_with_their_matte() {
        for ground in [[127; 3], [255; 3]] {
            let views = cut(&with_alpha(&tile(ground))).unwrap();
            assert_eq!(views.len(), 6);
            for (i, view) in views.iter().enumerate() {
                let middle = (100 + 20 * i) * 320 + 160;
                assert_eq!(view.colour[middle].map(|v| (v * 255.0).round() as u8), [200, 30 * i as u8, 20]);
                let area: f32 = view.alpha.data.iter().sum();
                assert!((area / (std::f32::consts::PI * 2500.0) - 1.0).abs() < 0.03, "{area}");
                assert_eq!(view.alpha.at(2, 2), 0.0);
            }
            let framed = framed(&views, [0.5; 3]);
            assert_eq!(framed[0].1.color[0], [0.5; 3]);
            assert!((framed[5].0.position() - six_views(320)[5].position()).length() < 1e-6);
        }
    }

    #[test]
    fn grey_inside_the_subject_stays_subject() {
        let mut tile = tile([127; 3]);
        for x in 150..170 {
            for y in 90..110 {
                tile.put_pixel(x, y, Rgb([127; 3]));
            }
        }
        assert_eq!(cut(&with_alpha(&tile)).unwrap()[0].alpha.at(160, 100), 1.0);
    }

    #[test]
    fn an_alpha_channel_is_the_matte() {
        let mut tile = with_alpha(&tile([127; 3]));
        for p in tile.pixels_mut() {
            p.0[3] = if p.0[0] == 200 { 255 } else { 0 };
        }
        let views = cut(&tile).unwrap();
        assert!(views[3].alpha.at(160, 160) == 1.0 && views[3].alpha.at(0, 0) == 0.0);
    }

    #[test]
    fn normals_are_read_in_camera_space() {
        let mut tile = RgbImage::from_pixel(SIZE.0, SIZE.1, Rgb([128, 128, 255]));
        tile.put_pixel(330, 5, Rgb([255, 128, 128]));
        tile.put_pixel(331, 5, Rgb([128, 255, 128]));
        tile.put_pixel(332, 5, Rgb([127, 128, 130]));
        let views = normals(&tile).unwrap();
        let near = |at: usize, want: [f32; 3]| views[1][at].iter().zip(want).all(|(a, b)| (a - b).abs() < 0.02);
        assert!(near(0, [0.0, 0.0, -1.0]) && near(5 * 320 + 10, [1.0, 0.0, 0.0]));
        assert!(near(5 * 320 + 11, [0.0, -1.0, 0.0]) && views[1][5 * 320 + 12] == [0.0; 3]);
        assert!(normals(&RgbImage::new(320, 320)).unwrap_err().found.contains("320 × 320"));
        let grey = RgbImage::from_pixel(SIZE.0, SIZE.1, Rgb([128; 3]));
        assert!(normals(&grey).unwrap_err().found.contains("view 1"));
    }

    #[test]
    fn other_sizes_and_empty_views_are_refused() {
        assert!(cut(&RgbaImage::new(960, 640)).unwrap_err().found.contains("960 × 640"));
        let empty = RgbaImage::from_pixel(SIZE.0, SIZE.1, image::Rgba([127, 127, 127, 255]));
        assert!(cut(&empty).unwrap_err().found.contains("view 1"));
    }
}
