//! Rule 13: elevation, its lowest and highest values, and imagery.

use std::collections::BTreeSet;

use super::Findings;
use crate::Result;
use crate::cdb::geocell::Tile;
use crate::cdb::ground::{HIGHEST, LOWEST, SELECTOR, elevation_grid, heights, imagery_grid, side};
use crate::cdb::names::{self, Dataset, ELEVATION, IMAGERY, MIN_MAX_ELEVATION, TileFile};
use crate::cdb::store::{self, Store};
use crate::geotiff::{self, Grid, Samples};
use crate::jp2;

/// Of a sample's spacing: how far a georeference may lie beside the tile.
const TOLERANCE: f64 = 0.01;

pub fn check(store: &dyn Store, files: &[(String, TileFile)], findings: &mut Findings) -> Result<()> {
    for (dataset, extension) in [(ELEVATION, "tif"), (MIN_MAX_ELEVATION, "tif"), (IMAGERY, "jp2")] {
        let own = || files.iter().filter(move |(_, f)| f.dataset == dataset);
        let tiles: BTreeSet<Tile> = own().filter(|(_, f)| f.selector == SELECTOR).map(|(_, f)| f.tile).collect();
        for (path, file) in own() {
            if file.extension != extension {
                continue;
            }
            let missing = file.tile.parent().filter(|p| file.selector == SELECTOR && !tiles.contains(p));
            if let Some(parent) = missing {
                let parent = names::path(parent, dataset, SELECTOR, extension);
                findings.add(13, path, format!("the coarser tile {parent} is missing"));
            }
            let Some(bytes) = store::read(store, path)? else { continue };
            let fault = match dataset {
                ELEVATION => elevation(&bytes, file.tile),
                MIN_MAX_ELEVATION => extremes(store, &bytes, file),
                _ => imagery(&bytes, file.tile),
            };
            if let Err(text) = fault {
                findings.add(13, path, text);
            }
        }
    }
    Ok(())
}

/// Whether rule 13 speaks of a path.
pub fn is_ground(path: &str) -> bool {
    let of = |d: Dataset| path.starts_with("Tiles/") && path.split('/').nth(3) == Some(d.name);
    of(ELEVATION) || of(MIN_MAX_ELEVATION) || of(IMAGERY)
}

fn elevation(bytes: &[u8], tile: Tile) -> Result<(), String> {
    raster(bytes, tile, 2, elevation_grid(tile))
}

/// Requirement 94; the lowest value of a cell lies below its highest and below the post at its south-west corner, and so on.
fn extremes(store: &dyn Store, bytes: &[u8], file: &TileFile) -> Result<(), String> {
    let tile = file.tile;
    raster(bytes, tile, 1, imagery_grid(tile))?;
    let other = match file.selector {
        LOWEST => HIGHEST,
        HIGHEST => LOWEST,
        (s, t) => return Err(format!("component S{s:03}_T{t:03}, expected S001_T001 (lowest) or S001_T002 (highest)")),
    };
    let read = |dataset, selector| heights(store, tile, dataset, selector).map_err(|e| e.to_string());
    let own = read(MIN_MAX_ELEVATION, file.selector)?.unwrap_or_default();
    let Some(other) = read(MIN_MAX_ELEVATION, other)? else {
        let path = names::path(tile, MIN_MAX_ELEVATION, other, "tif");
        return Err(format!("its other half {path} is missing"));
    };
    // Integers of either may be rounded.
    let step = 2f32.powi(-i32::from(tile.lod.max(0)));
    let (sign, word) = if file.selector == LOWEST { (1.0, "below") } else { (-1.0, "above") };
    let posts = read(ELEVATION, SELECTOR)?.unwrap_or_default();
    for (cell, value) in own.iter().enumerate() {
        for bound in other.get(cell).into_iter().chain(posts.get(cell)) {
            if (value - bound) * sign > step {
                let n = side(tile.lod) as usize;
                let (column, row) = (cell % n, cell / n);
                return Err(format!("{value} m at column {column}, row {row}, expected {word} {bound} m"));
            }
        }
    }
    Ok(())
}

fn raster(bytes: &[u8], tile: Tile, most: usize, grid: Grid) -> Result<(), String> {
    let raster = geotiff::read(bytes).map_err(|e| e.to_string())?;
    sides(raster.width, raster.height, tile)?;
    if !(1..=most).contains(&raster.bands) {
        let kinds = if most == 1 { "heights alone" } else { "heights and perhaps the kind of mesh" };
        return Err(format!("{} bands, expected {kinds}", raster.bands));
    }
    match &raster.samples {
        Samples::Bytes(_) => return Err("unsigned bytes, expected floats or signed integers".into()),
        Samples::Floats(v) if v.iter().any(|h| !h.is_finite()) => return Err("heights that are no numbers".into()),
        _ => {}
    }
    raster.grid.map_or(Ok(()), |found| place(found, grid))
}

fn imagery(bytes: &[u8], tile: Tile) -> Result<(), String> {
    let header = jp2::header(bytes).map_err(|e| e.to_string())?;
    sides(header.width, header.height, tile)?;
    if !matches!(header.bits[..], [8] | [8, 8, 8]) {
        return Err(format!("components of {:?} bits, expected one or three of 8, unsigned", header.bits));
    }
    let geotiff = header.geotiff.as_deref().map(geotiff::grid).transpose().map_err(|e| e.to_string())?;
    geotiff.flatten().map_or(Ok(()), |grid| place(grid, imagery_grid(tile)))
}

fn sides(width: u32, height: u32, tile: Tile) -> Result<(), String> {
    let side = side(tile.lod);
    let right = (width, height) == (side, side);
    if right { Ok(()) } else { Err(format!("{width} × {height} samples, LOD {} has {side} × {side}", tile.lod)) }
}

/// Readers go by the name; a georeference that says something else misleads other programs. Posts may also be told as areas
/// about them.
fn place(found: Grid, expected: Grid) -> Result<(), String> {
    let half = |g: Grid| if g.posts { 0.5 } else { 0.0 };
    let corner = |g: Grid| (g.west - half(g) * g.step_x, g.north + half(g) * g.step_y);
    let ((west, north), (x, y)) = (corner(found), corner(expected));
    let close = |a: f64, b: f64, step: f64| (a - b).abs() <= TOLERANCE * step;
    let steps =
        close(found.step_x, expected.step_x, expected.step_x) && close(found.step_y, expected.step_y, expected.step_y);
    if steps && close(west, x, expected.step_x) && close(north, y, expected.step_y) {
        return Ok(());
    }
    Err(format!(
        "it says that it lies at {west:.9}, {north:.9} with steps of {:.3e} and {:.3e} degrees; its name says {x:.9}, {y:.9} \
         with {:.3e} and {:.3e}",
        found.step_x, found.step_y, expected.step_x, expected.step_y
    ))
}
