//! A patch of ground that was measured: heights and colours inside an area, going over into what is around.

use std::collections::BTreeSet;

use super::{AddedGround, Known, Terrain, elevation, imagery, side};
use crate::cdb::geocell::{DEGREE, Tile};
use crate::cdb::store::Store;
use crate::{Error, Result};

/// Finest level of ground: posts every 2.7 cm.
const FINEST: i8 = 12;
/// Most tiles of one level.
const MOST_TILES: usize = 1024;
/// Samples beyond the patch that its own level still has, so that clients interpolate between samples of one level there.
const BEYOND: f64 = 2.0;
/// Degrees that step over a tile's edge: a micrometre.
const OVER: f64 = 1e-11;

/// Ground that was measured.
pub struct Patch<'a> {
    /// South, west, north, east, WGS 84 degrees, around everything that changes; east beyond 180 where it goes over the date
    /// line.
    pub bounds: [f64; 4],
    /// Finest levels of the terrain and of the imagery.
    pub lods: [i8; 2],
    /// Metres above the ellipsoid, and the share that they have against what was there: from 1 to 0.
    pub heights: Known<'a, (f64, f64)>,
    /// Colours of sRGB; grey elsewhere.
    pub colors: Known<'a, [u8; 3]>,
    /// Height of what nobody knows.
    pub level: f64,
    /// Heights around it, above the ellipsoid, and the share that they have against what the store holds: from 1 to 0 where what is
    /// known ends.
    pub terrain: Option<Known<'a, (f64, f64)>>,
    pub marking: &'a str,
}

/// The first level from 0 whose samples are no farther apart, metres along a meridian; 12 at most.
pub fn level_of(spacing: f64) -> i8 {
    (0..FINEST).find(|&lod| DEGREE / 1024.0 / 2f64.powi(lod.into()) <= spacing).unwrap_or(FINEST)
}

/// The tiles of a level that bounds reach into.
///
/// # Errors
/// [`Error::Unsupported`] for bounds that are none, and for more than 1,024 tiles.
pub fn tiles_within(bounds: [f64; 4], lod: i8) -> Result<BTreeSet<Tile>> {
    let refuse = |what: String| Err(Error::Unsupported { format: "CDB ground", what });
    let [south, west, north, east] = bounds;
    let good = -90.0 <= south && south <= north && north <= 90.0 && west <= east && east - west < 360.0;
    if !good || !(-180.0..=180.0).contains(&west) {
        return refuse(format!("bounds of {south} to {north} and {west} to {east} degrees"));
    }
    let mut tiles = BTreeSet::new();
    let mut latitude = south;
    loop {
        let mut longitude = west;
        loop {
            let on_earth = if longitude < 180.0 { longitude } else { longitude - 360.0 };
            let tile = Tile::containing(latitude, on_earth, lod)?;
            tiles.insert(tile);
            if tiles.len() > MOST_TILES {
                return refuse(format!("more than {MOST_TILES} tiles of level {lod}; choose a coarser one"));
            }
            longitude += tile.bounds()[3] - on_earth + OVER;
            if longitude > east {
                break;
            }
        }
        latitude = Tile::containing(latitude, west, lod)?.bounds()[2] + OVER;
        if latitude > north {
            return Ok(tiles);
        }
    }
}

/// Makes the tiles that a patch reaches into, from its finest levels up to LOD −10, with lowest and highest values.
///
/// Imagery of a geocell that has some is left as it is.
///
/// # Errors
/// As [`tiles_within`]; [`Error::Unsupported`] for a level that is no number, and for elevation of the store that cannot be
/// read.
pub fn add_patch(store: &dyn Store, patch: Patch) -> Result<AddedGround> {
    let Patch { bounds, lods: [posts, pixels], heights, colors, level, terrain, marking } = patch;
    if !level.is_finite() || level.abs() > 100_000.0 {
        return Err(Error::Unsupported { format: "CDB ground", what: format!("a level of {level} m") });
    }
    let inside = |latitude: f64, longitude: f64| {
        let east = (longitude - bounds[1]).rem_euclid(360.0);
        (bounds[0]..=bounds[2]).contains(&latitude) && east <= bounds[3] - bounds[1]
    };
    let mut notes = Vec::new();
    let tiles = tiles_within(beyond(bounds, posts), posts)?;
    let mut shape = |latitude: f64, longitude: f64, there: f64| {
        let own = if inside(latitude, longitude) { heights(latitude, longitude) } else { None };
        own.map_or(there, |(height, share)| there + (height - there) * share.clamp(0.0, 1.0))
    };
    let mut made = Terrain { tiles: &tiles, level, known: terrain, fades: true, shape: &mut shape, marking };
    let mut files = elevation(store, &mut made, &mut notes)?;
    let tiles = tiles_within(beyond(bounds, pixels), pixels)?;
    let mut seen =
        |latitude: f64, longitude: f64| if inside(latitude, longitude) { colors(latitude, longitude) } else { None };
    files.extend(imagery(store, &tiles, Some(&mut seen), marking, &mut notes)?);
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(AddedGround { files, lod: posts, notes })
}

/// Bounds with a few samples of a level around them.
fn beyond([south, west, north, east]: [f64; 4], lod: i8) -> [f64; 4] {
    let step = BEYOND / f64::from(side(lod)) / 2f64.powi(lod.max(0).into());
    // Tiles away from the equator are wider.
    let across = Tile::containing(south, west, 0).map_or(1.0, |t| f64::from(t.cell.width())) * step;
    let begun = west - across;
    let begun = if begun < -180.0 { begun + 360.0 } else { begun };
    [(south - step).max(-90.0), begun, (north + step).min(90.0), begun + (east - west) + 2.0 * across]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cdb::ground::{SELECTOR, elevation_grid, grid, heights};
    use crate::cdb::names::{self, ELEVATION, IMAGERY};
    use crate::cdb::{self, Empty, Memory};

    const MIDDLE: (f64, f64) = (50.0, 12.0);
    const REACH: f64 = 400.0;

    fn wavy(latitude: f64, longitude: f64) -> f64 {
        500.0 + 20.0 * (latitude * 3000.0).sin() + 15.0 * (longitude * 2500.0).cos()
    }

    /// 1 up to half the reach, 0 from the reach.
    fn share(latitude: f64, longitude: f64) -> f64 {
        let east = (longitude - MIDDLE.1) * DEGREE * MIDDLE.0.to_radians().cos();
        (2.0 - 2.0 * east.hypot((latitude - MIDDLE.0) * DEGREE) / REACH).clamp(0.0, 1.0)
    }

    fn made(store: &dyn Store) -> AddedGround {
        let north = REACH / DEGREE;
        let east = north / MIDDLE.0.to_radians().cos();
        add_patch(
            store,
            Patch {
                bounds: [MIDDLE.0 - north, MIDDLE.1 - east, MIDDLE.0 + north, MIDDLE.1 + east],
                lods: [6, 7],
                heights: &mut |a, b| Some((wavy(a, b), share(a, b))),
                colors: &mut |a, b| (share(a, b) > 0.0).then_some([200, 100, 50]),
                level: 510.0,
                terrain: None,
                marking: "CLASSIFICATION: UNCLASSIFIED",
            },
        )
        .unwrap()
    }

    /// Four geocells meet here, those in the north twice as wide: every tile has its part, and none knows of a border.
    #[test]
    fn a_patch_over_the_corner_of_four_geocells_has_no_seam() {
        let added = made(&Empty);
        assert!(added.notes[0].contains("invented"), "{:?}", added.notes);
        let mut store = Memory::default();
        store.write(added.files);
        let broken: Vec<_> = cdb::check(&store).unwrap().into_iter().filter(|f| f.rule == 13).collect();
        assert_eq!(broken, []);
        // Every post of every tile of the finest level, by its own place.
        let tiles: Vec<Tile> = (0..4)
            .map(|k| {
                let off = |up: bool| if up { 1e-6 } else { -1e-6 };
                Tile::containing(MIDDLE.0 + off(k & 1 == 0), MIDDLE.1 + off(k & 2 == 0), 6).unwrap()
            })
            .collect();
        let cells: BTreeSet<_> = tiles.iter().map(|t| t.cell).collect();
        assert_eq!(cells.len(), 4);
        let mut changed = 0;
        for tile in &tiles {
            let (grid, all) = (elevation_grid(*tile), heights(&store, *tile, ELEVATION, SELECTOR).unwrap().unwrap());
            for (i, height) in all.iter().enumerate() {
                let (a, b) = grid::at(&grid, i % 1024, i / 1024);
                let expected = 510.0 + (wavy(a, b) - 510.0) * share(a, b);
                assert!((f64::from(*height) - expected).abs() < 1e-3, "{tile:?} {a} {b}: {height} {expected}");
                changed += usize::from(share(a, b) > 0.0);
            }
        }
        assert!(changed > 100_000, "{changed}");
        // Posts of the coarser levels are the fine ones at the same place.
        let south_west = Tile::containing(MIDDLE.0 - 1e-6, MIDDLE.1 - 1e-6, 6).unwrap();
        for tile in std::iter::successors(south_west.parent(), |t| t.parent()).take(3) {
            let (grid, all) = (elevation_grid(tile), heights(&store, tile, ELEVATION, SELECTOR).unwrap().unwrap());
            let (a, b) = grid::at(&grid, 1023, 0);
            let expected = 510.0 + (wavy(a, b) - 510.0) * share(a, b);
            assert!((f64::from(all[1023]) - expected).abs() < 1e-3, "{tile:?}");
        }
        let picture = |lod| names::path(Tile::containing(50.0001, 12.0001, lod).unwrap(), IMAGERY, SELECTOR, "jp2");
        assert!(store.files.contains_key(&picture(7)) && !store.files.contains_key(&picture(8)));
    }

    #[test]
    fn tiles_are_found_over_the_date_line_and_refused_where_bounds_are_none() {
        let tiles = tiles_within([-16.52, 179.99, -16.48, 180.01], 6).unwrap();
        let west: BTreeSet<i32> = tiles.iter().map(|t| t.cell.west).collect();
        assert_eq!(west, BTreeSet::from([-180, 179]));
        assert_eq!(tiles, tiles_within(beyond([-16.52, 179.99, -16.48, 180.01], 12), 6).unwrap());
        // Each tile is reached, and no other: four of 1/64 degree up, two across on each side.
        assert_eq!(tiles.len(), 4 * 2, "{tiles:?}");
        for bad in [[2.0, 0.0, 1.0, 1.0], [0.0, 1.0, 1.0, 0.0], [f64::NAN; 4], [0.0, -200.0, 1.0, -190.0]] {
            assert!(tiles_within(bad, 6).is_err(), "{bad:?}");
        }
        assert!(tiles_within([0.0, 0.0, 1.0, 1.0], 8).unwrap_err().to_string().contains("choose a coarser one"));
        assert_eq!([level_of(0.1), level_of(0.30), level_of(1e-3), level_of(500.0)], [11, 9, 12, 0]);
    }
}
