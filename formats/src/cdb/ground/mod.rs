//! The ground under a model: terrain and imagery tiles, flat where the model stands. Or a patch of ground that was measured.
//!
//! Source: OGC CDB 1.x Volume 1, "Tiled raster datasets": elevation (dataset 001) is sampled at posts on the tile's west
//! and south edges (Requirements 85, 86), imagery (004) at the centres of its pixels (Requirement 87); a tile has
//! 1024² samples, 2^(LOD + 10) squared below LOD 0, and is never partly filled; every coarser tile to LOD −10 exists.
//!
//! With the terrain come the lowest and highest values of its coarser levels (002, Requirement 94).
//!
//! Heights are metres above the ellipsoid. Around the flat part the ground goes over, over twice its radius, into what the
//! store holds, or else what the caller knows, or else stays as high as the model.

mod extremes;
mod grid;
mod imagery;
mod patch;

use std::collections::{BTreeMap, BTreeSet};

use super::geocell::{DEGREE, LODS, Tile};
use super::names::{self, Dataset, ELEVATION, IMAGERY};
use super::store::{self, Store};
use crate::geotiff::{self, Samples};
use crate::{Error, File, Result};
pub use extremes::{HIGHEST, LOWEST};
pub use grid::{elevation_grid, imagery_grid, side};
pub use patch::{Patch, add_patch, level_of, tiles_within};

/// Primary terrain elevation, and yearly visible imagery.
pub const SELECTOR: (u16, u16) = (1, 1);
/// Posts across the flat part's radius, at least.
const POSTS: f64 = 4.0;
/// Where the ground is as it was again, in radii of the flat part.
const BLEND: f64 = 3.0;

/// What is known of the Earth at a latitude and longitude; `None` where it is not.
pub type Known<'a, T> = &'a mut dyn FnMut(f64, f64) -> Option<T>;

/// The ground that a model asks for.
pub struct Ground<'a> {
    /// The model's place, WGS 84 degrees, and its height, metres above the ellipsoid.
    pub latitude: f64,
    pub longitude: f64,
    pub height: f64,
    /// Metres about the place that are flat.
    pub radius: f64,
    /// Heights above the ellipsoid, which win over what the store holds.
    pub terrain: Option<Known<'a, f64>>,
    /// Colours of sRGB.
    pub colors: Option<Known<'a, [u8; 3]>>,
    pub marking: &'a str,
}

/// What adding ground comes to.
#[derive(Clone, Debug, PartialEq)]
pub struct AddedGround {
    /// New or replaced files, paths relative to the CDB root, sorted.
    pub files: Vec<File>,
    /// The finest level.
    pub lod: i8,
    /// What the user should know, as sentences.
    pub notes: Vec<String>,
}

/// Makes the tiles of a place, from the level whose posts show the flat part up to LOD −10.
///
/// Imagery of a geocell that has some is left as it is.
///
/// # Errors
/// [`Error::Unsupported`] for numbers that make no sense, and for elevation of the store that cannot be read.
pub fn add_ground(store: &dyn Store, mut ground: Ground) -> Result<AddedGround> {
    let refuse = |what: String| Err(Error::Unsupported { format: "CDB ground", what });
    if !ground.height.is_finite() || ground.height.abs() > 100_000.0 {
        return refuse(format!("a height of {} m", ground.height));
    }
    if !(0.01..=20_000.0).contains(&ground.radius) {
        return refuse(format!("a flat part of {} m; expected 1 cm to 20 km", ground.radius));
    }
    let lod = level_of(ground.radius / POSTS);
    let tiles = touched(&ground, lod)?;
    let mut notes = Vec::new();
    let (place, radius) = ((ground.latitude, ground.longitude, ground.height), ground.radius);
    let has_terrain = ground.terrain.is_some();
    let mut shape = |latitude: f64, longitude: f64, there: f64| flattened(place, radius, latitude, longitude, there);
    let mut known = ground.terrain.take();
    let mut all_of_it = |a: f64, b: f64| known.as_mut().and_then(|of| of(a, b)).map(|height| (height, 1.0));
    let mut terrain = Terrain {
        tiles: &tiles,
        level: ground.height,
        known: if has_terrain { Some(&mut all_of_it) } else { None },
        fades: false,
        shape: &mut shape,
        marking: ground.marking,
    };
    let mut files = elevation(store, &mut terrain, &mut notes)?;
    files.extend(imagery(store, &tiles, ground.colors.take(), ground.marking, &mut notes)?);
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(AddedGround { files, lod, notes })
}

/// The tiles of a level and all above it; none where the store has imagery.
fn imagery(
    store: &dyn Store,
    tiles: &BTreeSet<Tile>,
    colors: Option<Known<[u8; 3]>>,
    marking: &str,
    notes: &mut Vec<String>,
) -> Result<Vec<File>> {
    let coarsest = |tile: Tile| Tile { lod: *LODS.start(), up: 0, right: 0, ..tile };
    let mut held = None;
    for tile in tiles.iter().map(|t| coarsest(*t)).collect::<BTreeSet<_>>() {
        let path = names::path(tile, IMAGERY, SELECTOR, "jp2");
        if store::exists(store, &path)? {
            held = Some(path);
        }
    }
    match held {
        Some(path) => {
            notes.push(format!("The store has imagery here ({path}): it is left as it is."));
            Ok(Vec::new())
        }
        None => imagery::tiles(colors, tiles, marking),
    }
}

/// The tiles of a level that the changed ground reaches into.
fn touched(ground: &Ground, lod: i8) -> Result<BTreeSet<Tile>> {
    let north = BLEND * ground.radius / DEGREE;
    let east = north / ground.latitude.to_radians().cos().max(1e-3);
    // The place itself must be one on the Earth; what reaches over a pole or the date line is brought back.
    let mut tiles = BTreeSet::from([Tile::containing(ground.latitude, ground.longitude, lod)?]);
    for (a, b) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
        let latitude = (ground.latitude + a * north).clamp(-90.0, 90.0);
        let longitude = ground.longitude + b * east;
        let wrapped =
            if (-180.0..=180.0).contains(&longitude) { longitude } else { longitude - 360.0 * longitude.signum() };
        tiles.insert(Tile::containing(latitude, wrapped, lod)?);
    }
    Ok(tiles)
}

/// Tiles of a level and all above them, coarsest first.
fn pyramid(finest: &BTreeSet<Tile>) -> Vec<Tile> {
    let mut all = finest.clone();
    for tile in finest {
        all.extend(std::iter::successors(tile.parent(), |t| t.parent()));
    }
    let mut all: Vec<Tile> = all.into_iter().collect();
    all.sort_by_key(|t| t.lod);
    all
}

/// What terrain is made of.
struct Terrain<'a, 'k, 's> {
    /// Of the finest level.
    tiles: &'a BTreeSet<Tile>,
    /// Height of what is not known otherwise.
    level: f64,
    /// Wins over what the store holds, by its share.
    known: Option<Known<'k, (f64, f64)>>,
    /// Whether its share goes to nothing where it ends: finer levels then begin without it, so that its share counts once. Else they
    /// begin with what it says in the coarser ones, over the width of a few posts of each.
    fades: bool,
    /// Latitude, longitude, the height there → the height in the finest level.
    shape: &'s mut dyn FnMut(f64, f64, f64) -> f64,
    marking: &'a str,
}

fn elevation(store: &dyn Store, terrain: &mut Terrain, notes: &mut Vec<String>) -> Result<Vec<File>> {
    let order = pyramid(terrain.tiles);
    let mut rasters: BTreeMap<Tile, Vec<f32>> = BTreeMap::new();
    // Without what is known otherwise, of the level above.
    let mut bare: BTreeMap<Tile, Vec<f32>> = BTreeMap::new();
    let mut held = false;
    for &tile in &order {
        let stored = stored(store, tile)?;
        held |= stored.is_some();
        let parent = tile.parent().and_then(|p| bare.get(&p).or_else(|| rasters.get(&p)));
        let side = side(tile.lod) as usize;
        let mut heights = match (stored, parent) {
            (Some(heights), _) => heights,
            (None, Some(parent)) => finer(parent, tile),
            (None, None) => vec![terrain.level as f32; side * side],
        };
        let grid = elevation_grid(tile);
        if let Some(known) = &mut terrain.known {
            if terrain.fades {
                bare.retain(|of, _| of.lod >= tile.lod - 1);
                bare.insert(tile, heights.clone());
            }
            for (i, height) in heights.iter_mut().enumerate() {
                let (latitude, longitude) = grid::at(&grid, i % side, i / side);
                if let Some((h, share)) = known(latitude, longitude) {
                    let there = f64::from(*height);
                    *height = (there + (h - there) * share.clamp(0.0, 1.0)) as f32;
                }
            }
        }
        if terrain.tiles.contains(&tile) {
            for (i, height) in heights.iter_mut().enumerate() {
                let (latitude, longitude) = grid::at(&grid, i % side, i / side);
                *height = (terrain.shape)(latitude, longitude, f64::from(*height)) as f32;
            }
        }
        rasters.insert(tile, heights);
    }
    if !held && terrain.known.is_none() {
        notes.push(format!(
            "No terrain is known around it: its geocell is level, {:.2} m above the ellipsoid (invented).",
            terrain.level
        ));
    }
    // From the finest up, so that coarse posts are the fine ones at the same place.
    for &tile in order.iter().rev() {
        let Some(parent) = tile.parent() else { continue };
        let fine = rasters[&tile].clone();
        if let Some(coarse) = rasters.get_mut(&parent) {
            coarser(&fine, tile, coarse);
        }
    }
    let (mut files, without) = extremes::tiles(store, &rasters, terrain.marking)?;
    if let Some(path) = without {
        notes.push(format!("The store's terrain has no lowest and highest values ({path}): none are added."));
    }
    for (tile, heights) in rasters {
        let side = side(tile.lod);
        let bytes = geotiff::write(side, side, &heights, &elevation_grid(tile), terrain.marking)?;
        let path = names::path(tile, ELEVATION, SELECTOR, "tif");
        files.push(File { path, bytes, media_type: "image/tiff; application=geotiff" });
    }
    Ok(files)
}

/// Level about a place, and smoothly back to what was there.
fn flattened(place: (f64, f64, f64), radius: f64, latitude: f64, longitude: f64, there: f64) -> f64 {
    let east = (longitude - place.1 + 540.0).rem_euclid(360.0) - 180.0;
    let metres_east = DEGREE * place.0.to_radians().cos();
    let distance = (east * metres_east).hypot((latitude - place.0) * DEGREE);
    let t = ((distance / radius - 1.0) / (BLEND - 1.0)).clamp(0.0, 1.0);
    let share = t * t * (3.0 - 2.0 * t);
    place.2 + (there - place.2) * share
}

/// Where a tile's south-west post lies in its parent: column from the west, row from the south.
fn place_in_parent(tile: Tile) -> (usize, usize) {
    let half = side(tile.lod - 1) as usize / 2;
    let shift = |n: u32| if tile.lod > 0 { (n & 1) as usize * half } else { 0 };
    (shift(tile.right), shift(tile.up))
}

/// A tile's posts between those of its parent. Beyond the parent's last posts, which are its neighbours' first, the last
/// ones count.
fn finer(parent: &[f32], tile: Tile) -> Vec<f32> {
    let (n, from) = (side(tile.lod) as usize, side(tile.lod - 1) as usize);
    let (left, bottom) = place_in_parent(tile);
    let at = |x: usize, y: usize| parent[(from - 1 - y.min(from - 1)) * from + x.min(from - 1)];
    let mut out = Vec::with_capacity(n * n);
    for row in 0..n {
        let y = n - 1 - row;
        for x in 0..n {
            let (px, py) = (left + x / 2, bottom + y / 2);
            let (dx, dy) = (x & 1, y & 1);
            out.push((at(px, py) + at(px + dx, py) + at(px, py + dy) + at(px + dx, py + dy)) / 4.0);
        }
    }
    out
}

/// Puts every second post of a tile into its parent.
fn coarser(fine: &[f32], tile: Tile, parent: &mut [f32]) {
    let (n, into) = (side(tile.lod) as usize, side(tile.lod - 1) as usize);
    let (left, bottom) = place_in_parent(tile);
    for y in (0..n).step_by(2) {
        for x in (0..n).step_by(2) {
            parent[(into - 1 - bottom - y / 2) * into + left + x / 2] = fine[(n - 1 - y) * n + x];
        }
    }
}

/// The heights of a tile of the store.
fn stored(store: &dyn Store, tile: Tile) -> Result<Option<Vec<f32>>> {
    heights(store, tile, ELEVATION, SELECTOR)
}

/// Metres of a tile of terrain, or of its lowest or highest, row by row from the north-west; none where the store has no
/// such tile.
///
/// # Errors
/// [`Error::Unsupported`] for one that cannot be read, has another size than its level, or a number that is none.
pub fn heights(store: &dyn Store, tile: Tile, dataset: Dataset, selector: (u16, u16)) -> Result<Option<Vec<f32>>> {
    let path = names::path(tile, dataset, selector, "tif");
    let Some(bytes) = store::read(store, &path)? else { return Ok(None) };
    let raster = geotiff::read(&bytes).map_err(|e| store::unreadable(&path, &e))?;
    let side = side(tile.lod);
    if (raster.width, raster.height) != (side, side) {
        let what = format!("{} × {} posts, where its level has {side} × {side}", raster.width, raster.height);
        return Err(store::unreadable(&path, &what));
    }
    // A second band holds the kind of mesh, which a flat part does not change.
    let bands = raster.bands;
    let first = |i: usize| i * bands;
    let count = side as usize * side as usize;
    let heights: Vec<f32> = match raster.samples {
        Samples::Floats(v) => (0..count).map(|i| v[first(i)]).collect(),
        Samples::Integers(v) => {
            let unit = 2f64.powi(-i32::from(tile.lod.max(0)));
            (0..count).map(|i| (f64::from(v[first(i)]) * unit) as f32).collect()
        }
        Samples::Bytes(_) => return Err(store::unreadable(&path, &"unsigned bytes for heights")),
    };
    match heights.iter().find(|h| !h.is_finite()) {
        Some(h) => Err(store::unreadable(&path, &format!("a height of {h}"))),
        None => Ok(Some(heights)),
    }
}

#[cfg(test)]
mod tests;
