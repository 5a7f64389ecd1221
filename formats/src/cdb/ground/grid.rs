//! Where the samples of a raster tile lie.

use crate::cdb::geocell::Tile;
use crate::geotiff::Grid;

/// Samples along a tile's side.
pub fn side(lod: i8) -> u32 {
    if lod >= 0 { 1024 } else { 1 << (10 + lod.max(-10)) }
}

/// Posts on the west and south edges (Requirements 85, 86).
pub fn elevation_grid(tile: Tile) -> Grid {
    let grid = imagery_grid(tile);
    Grid { north: grid.north - grid.step_y, posts: true, ..grid }
}

/// Pixels that fill the tile (Requirement 87).
pub fn imagery_grid(tile: Tile) -> Grid {
    let ([south, west, north, east], n) = (tile.bounds(), f64::from(side(tile.lod)));
    Grid { west, north, step_x: (east - west) / n, step_y: (north - south) / n, posts: false }
}

/// Latitude and longitude of a sample: a post itself, or a pixel's centre.
pub fn at(grid: &Grid, column: usize, row: usize) -> (f64, f64) {
    let middle = if grid.posts { 0.0 } else { 0.5 };
    (grid.north - (row as f64 + middle) * grid.step_y, grid.west + (column as f64 + middle) * grid.step_x)
}
