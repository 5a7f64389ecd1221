//! Rule 13: elevation and imagery.

use std::collections::BTreeSet;

use super::Findings;
use crate::Result;
use crate::cdb::geocell::Tile;
use crate::cdb::ground::{SELECTOR, elevation_grid, imagery_grid, side};
use crate::cdb::names::{self, Dataset, ELEVATION, IMAGERY, TileFile};
use crate::cdb::store::{self, Store};
use crate::geotiff::{self, Grid, Samples};
use crate::jp2;

/// Of a sample's spacing: how far a georeference may lie beside the tile.
const TOLERANCE: f64 = 0.01;

pub fn check(store: &dyn Store, files: &[(String, TileFile)], findings: &mut Findings) -> Result<()> {
    for (dataset, extension) in [(ELEVATION, "tif"), (IMAGERY, "jp2")] {
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
            let fault = if dataset == ELEVATION { elevation(&bytes, file.tile) } else { imagery(&bytes, file.tile) };
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
    of(ELEVATION) || of(IMAGERY)
}

fn elevation(bytes: &[u8], tile: Tile) -> Result<(), String> {
    let raster = geotiff::read(bytes).map_err(|e| e.to_string())?;
    sides(raster.width, raster.height, tile)?;
    if !(1..=2).contains(&raster.bands) {
        return Err(format!("{} bands, expected heights and perhaps the kind of mesh", raster.bands));
    }
    match &raster.samples {
        Samples::Bytes(_) => return Err("unsigned bytes, expected floats or signed integers".into()),
        Samples::Floats(v) if v.iter().any(|h| !h.is_finite()) => return Err("heights that are no numbers".into()),
        _ => {}
    }
    raster.grid.map_or(Ok(()), |grid| place(grid, elevation_grid(tile)))
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
