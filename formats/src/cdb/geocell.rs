//! Geocells and tiles: which folder and file a point of the Earth belongs to.
//!
//! Source: OGC CDB 1.x Volume 1, "General Data Representation" (tile grid, Table 2-4) and "Geocell directories"
//! (Requirements 65–67, Table 3-29).

use crate::{Error, Result};

/// Coarsest and finest level of detail.
pub const LODS: std::ops::RangeInclusive<i8> = -10..=23;
/// Length of one degree at the equator, metres, as the standard rounds it.
pub const DEGREE: f64 = 111_319.0;

/// A cell of one degree of latitude by [`Geocell::width`] degrees of longitude, named by its south-west corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Geocell {
    /// Degrees, −90 … 89.
    pub south: i32,
    /// Degrees, −180 … 179, a multiple of the width from −180.
    pub west: i32,
}

/// One tile of a geocell at one level of detail.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Tile {
    pub cell: Geocell,
    /// −10 … 23.
    pub lod: i8,
    /// Row from the south, 0 at negative levels.
    pub up: u32,
    /// Column from the west, 0 at negative levels.
    pub right: u32,
}

impl Geocell {
    /// The geocell of a point, WGS 84 degrees. The north pole belongs to the cell below it, 180° east to −180°.
    ///
    /// # Errors
    /// [`Error::Unsupported`] outside ±90 and ±180 degrees and for NaN.
    pub fn containing(latitude: f64, longitude: f64) -> Result<Geocell> {
        if !(-90.0..=90.0).contains(&latitude) {
            return refuse(format!("latitude {latitude} is not within -90..90 degrees"));
        }
        if !(-180.0..=180.0).contains(&longitude) {
            return refuse(format!("longitude {longitude} is not within -180..180 degrees"));
        }
        let south = (latitude.floor() as i32).min(89);
        let longitude = if longitude == 180.0 { -180.0 } else { longitude };
        let width = width(south);
        let column = ((longitude + 180.0) / f64::from(width)).floor() as i32;
        Ok(Geocell { south, west: column.min(360 / width - 1) * width - 180 })
    }

    /// Width in degrees of longitude: 1 near the equator, 12 at the poles (Requirement 66).
    pub fn width(self) -> i32 {
        width(self.south)
    }

    /// `N34`, `S06`.
    pub fn latitude_name(self) -> String {
        format!("{}{:02}", if self.south >= 0 { 'N' } else { 'S' }, self.south.abs())
    }

    /// `W119`, `E045`.
    pub fn longitude_name(self) -> String {
        format!("{}{:03}", if self.west >= 0 { 'E' } else { 'W' }, self.west.abs())
    }

    /// The cell of two folder names; `None` unless they are exactly the names of a cell.
    pub fn from_names(latitude: &str, longitude: &str) -> Option<Geocell> {
        let number = |text: &str, plus: char, minus: char| {
            let n: i32 = text.get(1..)?.parse().ok()?;
            match text.chars().next() {
                Some(c) if c == plus => Some(n),
                Some(c) if c == minus => n.checked_neg(),
                _ => None,
            }
        };
        let cell = Geocell { south: number(latitude, 'N', 'S')?, west: number(longitude, 'E', 'W')? };
        let known = (-90..90).contains(&cell.south)
            && (-180..180).contains(&cell.west)
            && (cell.west + 180) % cell.width() == 0
            && cell.latitude_name() == latitude
            && cell.longitude_name() == longitude;
        known.then_some(cell)
    }
}

impl Tile {
    /// The tile of a point at a level of detail.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a point off the Earth or a level outside −10 … 23.
    pub fn containing(latitude: f64, longitude: f64, lod: i8) -> Result<Tile> {
        if !LODS.contains(&lod) {
            return refuse(format!("level of detail {lod} is not within -10..23"));
        }
        let cell = Geocell::containing(latitude, longitude)?;
        let longitude = if longitude == 180.0 { -180.0 } else { longitude };
        let rows = rows(lod);
        // The difference to the corner first: it is exact, so no digit of the point is lost to the product.
        let index = |fraction: f64| ((fraction * f64::from(rows)).floor() as u32).min(rows - 1);
        let up = index(latitude - f64::from(cell.south));
        let right = index((longitude - f64::from(cell.west)) / f64::from(cell.width()));
        Ok(Tile { cell, lod, up, right })
    }

    /// Whether the point lies in this tile; its south and west edges belong to it.
    pub fn contains(self, latitude: f64, longitude: f64) -> bool {
        Tile::containing(latitude, longitude, self.lod) == Ok(self)
    }

    /// Extent in degrees: south, west, north, east.
    pub fn bounds(self) -> [f64; 4] {
        let rows = f64::from(rows(self.lod));
        let (height, width) = (1.0 / rows, f64::from(self.cell.width()) / rows);
        let south = f64::from(self.cell.south) + f64::from(self.up) * height;
        let west = f64::from(self.cell.west) + f64::from(self.right) * width;
        [south, west, south + height, west + width]
    }

    /// The shorter side of the tile at a latitude, metres.
    pub fn shorter_side(self, latitude: f64) -> f64 {
        let east_west = f64::from(self.cell.width()) * latitude.to_radians().cos();
        DEGREE / f64::from(rows(self.lod)) * east_west.clamp(0.0, 1.0)
    }

    /// The tile one level coarser that holds this one; `None` at −10.
    pub fn parent(self) -> Option<Tile> {
        let lod = self.lod - 1;
        let shift = u32::from(self.lod > 0);
        LODS.contains(&lod).then_some(Tile { lod, up: self.up >> shift, right: self.right >> shift, ..self })
    }
}

/// Rows, and columns, of a geocell at a level: 2^LOD, one at negative levels.
pub fn rows(lod: i8) -> u32 {
    1 << lod.clamp(0, 23)
}

fn width(south: i32) -> i32 {
    match if south >= 0 { south } else { -(south + 1) } {
        89.. => 12,
        80.. => 6,
        75.. => 4,
        70.. => 3,
        50.. => 2,
        _ => 1,
    }
}

fn refuse<T>(what: String) -> Result<T> {
    Err(Error::Unsupported { format: "CDB geocell", what })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(latitude: f64, longitude: f64, lod: i8) -> (String, String, u32, u32) {
        let t = Tile::containing(latitude, longitude, lod).unwrap();
        (t.cell.latitude_name(), t.cell.longitude_name(), t.up, t.right)
    }

    #[test]
    fn known_points_fall_into_known_tiles() {
        // Latitude, longitude, cell, (level, row, column)…: worked with independent readers.
        type Row = (f64, f64, &'static str, &'static str, &'static [(i8, u32, u32)]);
        let table: [Row; 6] = [
            (34.5523, -118.4712, "N34", "W119", &[(1, 1, 1), (2, 2, 2), (4, 8, 8), (7, 70, 67), (10, 565, 541)]),
            (62.3, -160.4, "N62", "W162", &[(4, 4, 12), (7, 38, 102), (10, 307, 819)]),
            (-5.2, 45.2, "S06", "E045", &[(2, 3, 0), (4, 12, 3), (7, 102, 25)]),
            (48.8584, 2.2945, "N48", "E002", &[(4, 13, 4), (7, 109, 37), (10, 879, 301)]),
            (51.5007, -0.1246, "N51", "W002", &[(4, 8, 15), (7, 64, 120), (10, 512, 960)]),
            (-33.8568, 151.2153, "S34", "E151", &[(4, 2, 3), (7, 18, 27), (10, 146, 220)]),
        ];
        for (latitude, longitude, south, west, tiles) in table {
            for &(lod, up, right) in tiles {
                assert_eq!(at(latitude, longitude, lod), (south.into(), west.into(), up, right));
            }
        }
    }

    #[test]
    fn zones_change_width_at_their_edges() {
        for (latitude, width) in [
            (0.0, 1),
            (49.999, 1),
            (50.0, 2),
            (69.999, 2),
            (70.0, 3),
            (75.0, 4),
            (80.0, 6),
            (88.999, 6),
            (89.0, 12),
            (90.0, 12),
            (-50.0, 1),
            (-50.001, 2),
            (-70.0, 2),
            (-70.001, 3),
            (-75.001, 4),
            (-80.001, 6),
            (-89.0, 6),
            (-89.001, 12),
            (-90.0, 12),
        ] {
            assert_eq!(Geocell::containing(latitude, 0.0).unwrap().width(), width, "latitude {latitude}");
        }
    }

    #[test]
    fn poles_and_the_date_line_belong_to_a_cell() {
        assert_eq!(at(90.0, 179.999, 2), ("N89".into(), "E168".into(), 3, 3));
        assert_eq!(at(-90.0, 180.0, 3), ("S90".into(), "W180".into(), 0, 0));
        assert_eq!(at(-0.5, 179.5, -10), ("S01".into(), "E179".into(), 0, 0));
        let last = f64::from_bits(35.0f64.to_bits() - 1);
        assert_eq!(Tile::containing(last, 0.0, 23).unwrap().up, (1 << 23) - 1);
    }

    #[test]
    fn what_is_not_on_the_earth_is_refused() {
        for (latitude, longitude) in [(91.0, 0.0), (f64::NAN, 0.0), (0.0, 180.1), (0.0, f64::NAN), (f64::INFINITY, 0.0)]
        {
            assert!(Tile::containing(latitude, longitude, 0).is_err());
        }
        assert!(Tile::containing(0.0, 0.0, 24).is_err());
        assert!(Tile::containing(0.0, 0.0, -11).is_err());
    }

    #[test]
    fn cell_names_read_back() {
        for south in -90..90 {
            for west in (-180..180).step_by(width(south) as usize) {
                let cell = Geocell { south, west };
                assert_eq!(Geocell::from_names(&cell.latitude_name(), &cell.longitude_name()), Some(cell));
            }
        }
        for (latitude, longitude) in [
            ("N62", "W161"),
            ("N5", "E001"),
            ("S00", "E001"),
            ("X10", "E001"),
            ("N10", "W000"),
            ("N90", "E000"),
            ("", "é1"),
            ("S-2147483648", "E001"),
        ] {
            assert_eq!(Geocell::from_names(latitude, longitude), None, "{latitude} {longitude}");
        }
    }

    #[test]
    fn parents_hold_their_children() {
        let (latitude, longitude) = (62.345, -160.4);
        for lod in -9..=23 {
            let tile = Tile::containing(latitude, longitude, lod).unwrap();
            assert_eq!(tile.parent(), Some(Tile::containing(latitude, longitude, lod - 1).unwrap()));
            let [south, west, north, east] = tile.bounds();
            assert!(south <= latitude && latitude < north && west <= longitude && longitude < east);
        }
        assert_eq!(Tile::containing(latitude, longitude, -10).unwrap().parent(), None);
    }

    #[test]
    fn the_shorter_side_shrinks_with_the_meridians() {
        let side = |latitude: f64, lod| Tile::containing(latitude, 0.5, lod).unwrap().shorter_side(latitude);
        assert!((side(0.0, 0) - 111_319.0).abs() < 1e-9);
        assert!((side(60.0, 0) - 111_319.0).abs() < 1e-6, "2 degrees wide at cos 0.5: {}", side(60.0, 0));
        assert!((side(45.0, 4) - 111_319.0 / 16.0 * 45f64.to_radians().cos()).abs() < 1e-9);
        assert!(side(90.0, 0) < 1e-6);
    }
}
