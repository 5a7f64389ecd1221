//! `preview.png`: what went in, what the networks saw, what came out, on one sheet.

use font8x8::{BASIC_FONTS, UnicodeFonts};
use image::{GrayImage, Rgb, RgbImage, imageops};
use rayon::prelude::*;

use crate::photo::Plane;

/// A picture with the words under it.
pub struct Tile {
    pub image: RgbImage,
    pub caption: String,
}

const WIDTH: u32 = 1536;
const CAPTION: u32 = 24;
const BANNER: u32 = 32;
const PAPER: Rgb<u8> = Rgb([245, 245, 243]);
const INK: Rgb<u8> = Rgb([40, 40, 44]);

/// Rows of tiles, all tiles of a row as wide as the sheet allows, the banner above and below.
pub fn sheet(rows: &[Vec<Tile>], banner: &str) -> RgbImage {
    let heights: Vec<u32> = rows.iter().map(|row| WIDTH / row.len().max(1) as u32 + CAPTION).collect();
    let mut sheet = RgbImage::from_pixel(WIDTH, heights.iter().sum::<u32>() + 2 * BANNER, PAPER);
    let mut top = BANNER;
    for (row, height) in rows.iter().zip(&heights) {
        let side = WIDTH / row.len().max(1) as u32;
        let fitted: Vec<RgbImage> = row.par_iter().map(|tile| fit(&tile.image, side - 8)).collect();
        for (i, (tile, fitted)) in row.iter().zip(&fitted).enumerate() {
            let left = i as u32 * side;
            let (dx, dy) = ((side - fitted.width()) / 2, (side - fitted.height()) / 2);
            imageops::replace(&mut sheet, fitted, (left + dx).into(), (top + dy).into());
            text(&mut sheet, &tile.caption, left + 6, top + side, 2);
        }
        top += height;
    }
    let centre = (WIDTH / 2).saturating_sub(banner.len() as u32 * 8 * 3 / 2);
    text(&mut sheet, banner, centre, 4, 3);
    text(&mut sheet, banner, centre, top + 4, 3);
    sheet
}

/// The picture of a sheet's first tile, as it was put there; `None` for what is no sheet. A sheet begins with three tiles.
pub fn first_tile(sheet: &RgbImage) -> Option<RgbImage> {
    let side = WIDTH / 3;
    if sheet.width() != WIDTH || sheet.height() < BANNER + side {
        return None;
    }
    let tile = imageops::crop_imm(sheet, 0, BANNER, side, side).to_image();
    let drawn = tile.enumerate_pixels().filter(|(_, _, p)| **p != PAPER).map(|(x, y, _)| (x, y));
    let (mut low, mut high) = ((side, side), (0, 0));
    for (x, y) in drawn {
        low = (low.0.min(x), low.1.min(y));
        high = (high.0.max(x + 1), high.1.max(y + 1));
    }
    let found = low.0 < high.0 && low.1 < high.1;
    found.then(|| imageops::crop_imm(&tile, low.0, low.1, high.0 - low.0, high.1 - low.1).to_image())
}

/// Mask over the photo: what is not the subject goes dark.
pub fn masked(photo: &RgbImage, mask: &Plane) -> RgbImage {
    RgbImage::from_fn(photo.width(), photo.height(), |x, y| {
        let m = mask.at(
            (x as usize * mask.width / photo.width() as usize).min(mask.width - 1),
            (y as usize * mask.height / photo.height() as usize).min(mask.height - 1),
        );
        let p = photo.get_pixel(x, y).0;
        Rgb(p.map(|c| (f32::from(c) * (0.15 + 0.85 * m)) as u8))
    })
}

/// Dark blue at 0, bright yellow at 1: five stops of viridis.
pub fn ramp(t: f32) -> [f32; 3] {
    const STOPS: [[f32; 3]; 5] =
        [[68.0, 1.0, 84.0], [59.0, 82.0, 139.0], [33.0, 145.0, 140.0], [94.0, 201.0, 98.0], [253.0, 231.0, 37.0]];
    let t = t.clamp(0.0, 1.0) * 3.999;
    let (i, f) = (t as usize, t.fract());
    std::array::from_fn(|c| STOPS[i][c] * (1.0 - f) + STOPS[i + 1][c] * f)
}

/// The error that [`error_colours`] shows brightest, of 255.
pub const LARGEST_ERROR: u8 = 64;

/// Errors in eight bits: none is dark violet, [`LARGEST_ERROR`] and more bright yellow.
pub fn error_colours(errors: &GrayImage) -> RgbImage {
    let colour = |e: u8| ramp(f32::from(e) / f32::from(LARGEST_ERROR)).map(|c| c as u8);
    RgbImage::from_fn(errors.width(), errors.height(), |x, y| Rgb(colour(errors.get_pixel(x, y).0[0])))
}

/// Near is bright yellow, far is dark blue; where the mask is 0, paper.
pub fn depth_colours(depth: &Plane, mask: &Plane) -> RgbImage {
    RgbImage::from_fn(depth.width as u32, depth.height as u32, |x, y| {
        let (x, y) = (x as usize, y as usize);
        let m = mask.at(
            (x * mask.width / depth.width).min(mask.width - 1),
            (y * mask.height / depth.height).min(mask.height - 1),
        );
        let colour = ramp(depth.at(x, y));
        Rgb(std::array::from_fn(|c| (colour[c] * m + f32::from(PAPER.0[c]) * (1.0 - m)) as u8))
    })
}

/// Colours 0..1, row-major, to eight bits.
pub fn from_floats(width: usize, height: usize, colours: &[[f32; 3]]) -> RgbImage {
    RgbImage::from_fn(width as u32, height as u32, |x, y| {
        Rgb(colours[y as usize * width + x as usize].map(|c| (c.clamp(0.0, 1.0) * 255.0 + 0.5) as u8))
    })
}

fn fit(image: &RgbImage, side: u32) -> RgbImage {
    let scale = (f64::from(side) / f64::from(image.width().max(image.height()))).min(4.0);
    let size = |n: u32| ((f64::from(n) * scale).round() as u32).clamp(1, side);
    let (w, h) = (size(image.width()), size(image.height()));
    if scale > 1.0 {
        imageops::resize(image, w, h, imageops::FilterType::CatmullRom)
    } else {
        imageops::thumbnail(image, w, h)
    }
}

fn text(sheet: &mut RgbImage, words: &str, left: u32, top: u32, scale: u32) {
    for (i, c) in words.chars().enumerate() {
        let Some(glyph) = BASIC_FONTS.get(c) else { continue };
        for (row, bits) in glyph.iter().enumerate() {
            for column in (0..8).filter(|b| bits >> b & 1 == 1) {
                for (dx, dy) in (0..scale).flat_map(|a| (0..scale).map(move |b| (a, b))) {
                    let x = left + (i as u32 * 8 + column) * scale + dx;
                    let y = top + row as u32 * scale + dy;
                    if x < sheet.width() && y < sheet.height() {
                        sheet.put_pixel(x, y, INK);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_go_from_dark_to_bright_and_no_further() {
        let errors = GrayImage::from_fn(4, 1, |x, _| image::Luma([[0, 32, LARGEST_ERROR, 255][x as usize]]));
        let shown = error_colours(&errors);
        let light = |x: u32| shown.get_pixel(x, 0).0.iter().map(|c| u32::from(*c)).sum::<u32>();
        assert_eq!(shown.get_pixel(0, 0).0, ramp(0.0).map(|c| c as u8));
        assert!(light(0) < light(1) && light(1) < light(2) && light(2) == light(3));
    }

    #[test]
    fn sheet_shows_the_banner_and_keeps_its_tiles() {
        let red = RgbImage::from_pixel(64, 32, Rgb([200, 10, 10]));
        let row = |n: usize| (0..n).map(|i| Tile { image: red.clone(), caption: format!("tile {i}") }).collect();
        let image = sheet(&[row(3), row(6)], "SECRET");
        assert_eq!(image.dimensions(), (1536, 512 + 256 + 48 + 64));
        assert_eq!(image.get_pixel(256, 32 + 256).0, [200, 10, 10]);
        assert!(image.enumerate_pixels().any(|(_, y, p)| y < 32 && p.0 == INK.0), "no banner drawn");
        let first = first_tile(&image).unwrap();
        // Four times as large at most.
        assert_eq!(first.dimensions(), (256, 128));
        assert!(first.pixels().all(|p| p.0 == [200, 10, 10]));
        assert!(first_tile(&red).is_none() && first_tile(&RgbImage::from_pixel(WIDTH, 600, PAPER)).is_none());
    }
}
