//! The lowest and the highest terrain of each cell (dataset 002, MinMaxElevation), for lines of sight.
//!
//! Source: OGC CDB 1.x Volume 1, "MinElevation and MaxElevation Components" (Requirement 94): a grid of cells, not of posts,
//! with the lowest and the highest altitude of a cell's area. Levels −10 to 0 belong to every geocell that has terrain; finer
//! ones are left to the maker, and not made here: a tile of them takes 8 MiB.

use std::collections::BTreeMap;

use super::{heights, imagery_grid, place_in_parent, side};
use crate::cdb::geocell::Tile;
use crate::cdb::names::{self, ELEVATION, MIN_MAX_ELEVATION};
use crate::cdb::store::{self, Store};
use crate::{File, Result, geotiff};

/// Components: the lowest, the highest.
pub const LOWEST: (u16, u16) = (1, 1);
pub const HIGHEST: (u16, u16) = (1, 2);
/// The finest level that is written.
const FINEST: i8 = 0;

/// Cells of a tile, row by row from the north-west, as terrain has its posts.
struct Extremes {
    lowest: Vec<f32>,
    highest: Vec<f32>,
}

/// The files for the terrain of whole pyramids. Where the store has extremes already they stay inside the new ones.
///
/// Of a geocell whose terrain has no extremes none are made, as its other tiles are not looked through: the answer's second
/// part names what is missing.
pub fn tiles(
    store: &dyn Store,
    terrain: &BTreeMap<Tile, Vec<f32>>,
    marking: &str,
) -> Result<(Vec<File>, Option<String>)> {
    let coarsest = |tile: &Tile| std::iter::successors(Some(*tile), |t| t.parent()).last().unwrap_or(*tile);
    let mut all: BTreeMap<Tile, Extremes> = BTreeMap::new();
    let mut order: Vec<&Tile> = terrain.keys().collect();
    order.sort_by_key(|t| std::cmp::Reverse(t.lod));
    let (mut files, mut without) = (Vec::new(), None);
    for &tile in order {
        let mut cells = all.remove(&tile).unwrap_or_else(|| Extremes::none(tile));
        cells.widen(tile, terrain);
        if tile.lod <= FINEST {
            let root = coarsest(&tile);
            let has = |dataset, selector| store::exists(store, &names::path(root, dataset, selector, "tif"));
            if has(ELEVATION, super::SELECTOR)? && !has(MIN_MAX_ELEVATION, LOWEST)? {
                without = Some(names::path(root, MIN_MAX_ELEVATION, LOWEST, "tif"));
            } else {
                cells.join(store, tile)?;
                for (selector, values) in [(LOWEST, &cells.lowest), (HIGHEST, &cells.highest)] {
                    let bytes = geotiff::write(side(tile.lod), side(tile.lod), values, &imagery_grid(tile), marking)?;
                    let path = names::path(tile, MIN_MAX_ELEVATION, selector, "tif");
                    files.push(File { path, bytes, media_type: "image/tiff; application=geotiff" });
                }
            }
        }
        if let Some(parent) = tile.parent() {
            all.entry(parent).or_insert_with(|| Extremes::none(parent)).take_finer(&cells, tile);
        }
    }
    Ok((files, without))
}

impl Extremes {
    fn none(tile: Tile) -> Self {
        let cells = side(tile.lod) as usize * side(tile.lod) as usize;
        Extremes { lowest: vec![f32::INFINITY; cells], highest: vec![f32::NEG_INFINITY; cells] }
    }

    fn add(&mut self, cell: usize, low: f32, high: f32) {
        self.lowest[cell] = self.lowest[cell].min(low);
        self.highest[cell] = self.highest[cell].max(high);
    }

    /// By the four posts about each cell, between which the ground is a plane or two. Posts beyond the tile are those of the
    /// neighbours, where there are any.
    fn widen(&mut self, tile: Tile, terrain: &BTreeMap<Tile, Vec<f32>>) {
        let n = side(tile.lod) as usize;
        let Some(own) = terrain.get(&tile) else { return };
        let [_, west, north, east] = tile.bounds();
        let middle = |latitude: f64, longitude: f64| Tile::containing(latitude, longitude, tile.lod).ok();
        let (half_up, half_right) = ((north - tile.bounds()[0]) / 2.0, (east - west) / 2.0);
        let of = |up: bool, right: bool| {
            let latitude = if up { north + half_up } else { north - half_up };
            let longitude = if right { east + half_right } else { east - half_right };
            middle(latitude, longitude).and_then(|t| terrain.get(&t))
        };
        let (above, beside, across) = (of(true, false), of(false, true), of(true, true));
        // Rows count from the north: the row above the first is the last of the tile above.
        let post = |column: usize, row: Option<usize>| {
            let (raster, row, inside) = match (row, column < n) {
                (Some(row), true) => (Some(own), row, own[row * n + column]),
                (Some(row), false) => (beside, row, own[row * n + n - 1]),
                (None, true) => (above, n - 1, own[column]),
                (None, false) => (across, n - 1, own[n - 1]),
            };
            raster.and_then(|r| r.get(row * n + column % n)).copied().unwrap_or(inside)
        };
        for row in 0..n {
            let north = row.checked_sub(1);
            for column in 0..n {
                let corners = [(column, Some(row)), (column + 1, Some(row)), (column, north), (column + 1, north)];
                for height in corners.map(|(column, row)| post(column, row)) {
                    self.add(row * n + column, height, height);
                }
            }
        }
    }

    /// What four cells of a finer tile hold, in the one that covers them.
    fn take_finer(&mut self, finer: &Extremes, tile: Tile) {
        let (n, into) = (side(tile.lod) as usize, side(tile.lod - 1) as usize);
        let (left, bottom) = place_in_parent(tile);
        for row in 0..n {
            let to = (into - 1 - bottom - (n - 1 - row) / 2) * into + left;
            for column in 0..n {
                let from = row * n + column;
                self.add(to + column / 2, finer.lowest[from], finer.highest[from]);
            }
        }
    }

    /// What the store says of the same tile.
    fn join(&mut self, store: &dyn Store, tile: Tile) -> Result<()> {
        let low = heights(store, tile, MIN_MAX_ELEVATION, LOWEST)?;
        let high = heights(store, tile, MIN_MAX_ELEVATION, HIGHEST)?;
        if let (Some(low), Some(high)) = (low, high) {
            (0..low.len()).for_each(|cell| self.add(cell, low[cell], high[cell]));
        }
        Ok(())
    }
}
