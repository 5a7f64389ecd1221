//! Imagery tiles: what is known of the ground's colours, grey elsewhere.

use std::collections::{BTreeMap, BTreeSet};

use super::{Known, SELECTOR, grid, imagery_grid, place_in_parent, pyramid, side};
use crate::cdb::geocell::Tile;
use crate::cdb::names::{self, IMAGERY};
use crate::cdb::texture;
use crate::{File, Image, Result, jp2};

/// Half intensity: the standard's default of imagery (Default_VSTI_Y_Mono, 0.5).
const UNKNOWN: [u8; 3] = [128; 3];

/// The tiles of a level and of all above it.
pub fn tiles(mut colors: Option<Known<[u8; 3]>>, finest: &BTreeSet<Tile>, marking: &str) -> Result<Vec<File>> {
    let order = pyramid(finest);
    let mut images: BTreeMap<Tile, Image> = BTreeMap::new();
    for &tile in order.iter().rev() {
        let n = side(tile.lod);
        let mut image = Image { width: n, height: n, channels: 3, pixels: UNKNOWN.repeat((n * n) as usize) };
        if let Some(known) = &mut colors {
            let grid = imagery_grid(tile);
            for (i, pixel) in image.pixels.chunks_exact_mut(3).enumerate() {
                let (latitude, longitude) = grid::at(&grid, i % n as usize, i / n as usize);
                if let Some(color) = known(latitude, longitude) {
                    pixel.copy_from_slice(&color);
                }
            }
        }
        images.insert(tile, image);
    }
    // Finer tiles, where there are any, know the mean of their pixels better than one look at it.
    for &tile in order.iter().rev() {
        let Some(parent) = tile.parent() else { continue };
        let half = texture::half(&images[&tile]);
        if let Some(coarse) = images.get_mut(&parent) {
            paste(&half, tile, coarse);
        }
    }
    let text = if marking.is_empty() { String::new() } else { format!("{marking}\n") };
    let written = images.into_iter().map(|(tile, image)| {
        let bytes = jp2::write(&image, Some(&imagery_grid(tile)), &text)?;
        Ok(File { path: names::path(tile, IMAGERY, SELECTOR, "jp2"), bytes, media_type: "image/jp2" })
    });
    written.collect()
}

/// A tile's halved image into its quarter of the parent, or all of it.
fn paste(half: &Image, tile: Tile, parent: &mut Image) {
    let (left, bottom) = place_in_parent(tile);
    let (n, into) = (half.width as usize, parent.width as usize);
    let top = into - bottom - n;
    for y in 0..n {
        let to = 3 * ((top + y) * into + left);
        parent.pixels[to..to + 3 * n].copy_from_slice(&half.pixels[3 * y * n..3 * (y + 1) * n]);
    }
}
