//! The lowest and the highest terrain of each cell (dataset 002, MinMaxElevation), for lines of sight.
//!
//! Source: OGC CDB 1.x Volume 1, "MinElevation and MaxElevation Components" (Requirement 94): a grid of cells, not of posts,
//! with the lowest and the highest altitude of a cell's area. Levels −10 to 0 belong to every geocell that has terrain; finer
//! ones are left to the maker, and not made here: a tile of them takes 8 MiB.

use std::collections::BTreeMap;

use super::{heights, imagery_grid, place_in_parent, side};
use crate::cdb::geocell::{Geocell, Tile, rows};
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
        let [south, west, north, east] = tile.bounds();
        let (middle, half) = ((west + east) / 2.0, (north - south) / 2.0);
        // 180° is the west of the first cell.
        let longitude = if east >= 180.0 { middle + (east - west) - 360.0 } else { middle + (east - west) };
        let beside = Tile::containing(north - half, longitude, tile.lod).ok().and_then(|t| terrain.get(&t));
        let post = |column: usize, row: usize| match column < n {
            true => own[row * n + column],
            false => beside.and_then(|r| r.get(row * n)).copied().unwrap_or(own[row * n + n - 1]),
        };
        for row in 0..n {
            // Rows count from the north: those above the first are of other tiles.
            let north = row.saturating_sub(1);
            for column in 0..n {
                let corners = [(column, row), (column + 1, row), (column, north), (column + 1, north)];
                for height in corners.map(|(column, row)| post(column, row)) {
                    self.add(row * n + column, height, height);
                }
            }
        }
        if let Ok(above) = Tile::containing(north + half, middle, tile.lod) {
            self.widen_north(tile, above, terrain);
        }
    }

    /// The first row, by the last posts of the tiles above, which are of another width where geocells change theirs: all from
    /// the one at or before a cell's western edge to the one at or after its eastern edge.
    fn widen_north(&mut self, tile: Tile, above: Tile, terrain: &BTreeMap<Tile, Vec<f32>>) {
        let (n, across) = (side(tile.lod) as usize, rows(tile.lod) as usize);
        // Posts are counted from 180° west.
        let [own_width, width] = [tile, above].map(|t| t.cell.width().unsigned_abs() as usize);
        let first = ((tile.cell.west + 180).unsigned_abs() as usize / own_width * across + tile.right as usize) * n;
        let around = 360 / width * across * n;
        for column in 0..n {
            let (from, to) = (first + column, first + column + 1);
            for post in from * own_width / width..=(to * own_width).div_ceil(width) {
                let post = post % around;
                let cell = Geocell { west: (post / (across * n) * width) as i32 - 180, ..above.cell };
                let there = Tile { cell, right: (post / n % across) as u32, ..above };
                if let Some(height) = terrain.get(&there).and_then(|r| r.get((n - 1) * n + post % n)) {
                    self.add(column, *height, *height);
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
