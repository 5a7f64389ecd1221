//! UTM and UPS: zone, hemisphere, easting, northing (NGA.SIG.0012, "The Universal Grids").

use super::transverse_mercator::{ups_forward, ups_reverse, utm_forward, utm_reverse};

/// A point of the universal grids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Utm {
    /// 1 to 60; 0 is UPS.
    pub zone: u8,
    /// Hemisphere: decides the false northing, and the pole of UPS.
    pub north: bool,
    /// Metres, false origin included.
    pub easting: f64,
    pub northing: f64,
}

/// Letters of the latitude bands from 80° S, eight degrees each, X twelve.
pub(super) const BANDS: &[u8; 20] = b"CDEFGHJKLMNPQRSTUVWX";

const UTM_EAST: f64 = 500_000.0;
const UTM_SOUTH: f64 = 10_000_000.0;
const UPS_FALSE: f64 = 2_000_000.0;

/// Index into [`BANDS`]; latitudes of UPS give the nearest band.
pub(super) fn band(latitude: f64) -> usize {
    ((latitude + 80.0) / 8.0).floor().clamp(0.0, 19.0) as usize
}

/// To [−180, 180).
pub fn normalised_longitude(longitude: f64) -> f64 {
    if (-180.0..180.0).contains(&longitude) { longitude } else { (longitude + 180.0).rem_euclid(360.0) - 180.0 }
}

/// The zone that the grids prescribe, 0 for UPS: six degrees wide but for south-western Norway and Svalbard.
pub fn standard_zone(latitude: f64, longitude: f64) -> u8 {
    if !(-80.0..84.0).contains(&latitude) {
        return 0;
    }
    let degree = normalised_longitude(longitude).floor() as i32;
    let zone = (degree + 186) / 6;
    let zone = match BANDS[band(latitude)] {
        b'V' if zone == 31 && degree >= 3 => 32,
        b'X' if (0..42).contains(&degree) => 2 * ((degree + 183) / 12) + 1,
        _ => zone,
    };
    zone as u8
}

fn central_meridian(zone: u8) -> f64 {
    6.0 * f64::from(zone) - 183.0
}

/// Degrees that a longitude in [−180, 180) lies east of a meridian of whole degrees, in [−180, 180]. Whole turns are taken
/// from the longitude before the meridian is: it keeps every bit then, where a difference of 350° has lost one.
fn east_of(meridian: f64, longitude: f64) -> f64 {
    let turn = if longitude - meridian > 180.0 {
        -360.0
    } else if longitude - meridian < -180.0 {
        360.0
    } else {
        0.0
    };
    longitude + turn - meridian
}

/// The longitude in [−180, 180) so many degrees east of a meridian, rounded once where both lie within a turn.
fn shifted(meridian: f64, off: f64) -> f64 {
    let turn = if meridian + off < -180.0 {
        360.0
    } else if meridian + off >= 180.0 {
        -360.0
    } else {
        0.0
    };
    normalised_longitude(meridian + turn + off)
}

impl Utm {
    /// In the standard zone.
    pub fn of(latitude: f64, longitude: f64) -> Utm {
        Self::in_zone(latitude, longitude, standard_zone(latitude, longitude))
    }

    /// In a given zone (0: UPS of the point's hemisphere).
    pub fn in_zone(latitude: f64, longitude: f64, zone: u8) -> Utm {
        // A negative zero is south, as is every latitude below the equator.
        let north = latitude.is_sign_positive() || latitude == 0.0;
        if zone == 0 {
            let (x, y) = ups_forward(north, latitude, longitude);
            return Utm { zone, north, easting: x + UPS_FALSE, northing: y + UPS_FALSE };
        }
        let (x, y) = utm_forward(latitude, east_of(central_meridian(zone), normalised_longitude(longitude)));
        Utm { zone, north, easting: x + UTM_EAST, northing: if north { y } else { y + UTM_SOUTH } }
    }

    /// Latitude and longitude, degrees; longitude in [−180, 180).
    pub fn to_degrees(self) -> (f64, f64) {
        if self.zone == 0 {
            return ups_reverse(self.north, self.easting - UPS_FALSE, self.northing - UPS_FALSE);
        }
        let y = if self.north { self.northing } else { self.northing - UTM_SOUTH };
        let (latitude, off) = utm_reverse(self.easting - UTM_EAST, y);
        (latitude, shifted(central_meridian(self.zone), off))
    }

    /// Why this is no point of the grids; `None` when it is one. Limits are those of MGRS, with a square to spare.
    pub fn fault(&self) -> Option<String> {
        let outside = |value: f64, low: f64, high: f64| !(low..=high).contains(&value);
        let (east, north) = match (self.zone, self.north) {
            (0, true) => ((1_200_000.0, 2_800_000.0), (1_200_000.0, 2_800_000.0)),
            (0, false) => ((700_000.0, 3_300_000.0), (700_000.0, 3_300_000.0)),
            (1..=60, true) => ((0.0, 1_000_000.0), (-9_100_000.0, 9_600_000.0)),
            (1..=60, false) => ((0.0, 1_000_000.0), (900_000.0, 19_600_000.0)),
            _ => return Some(format!("zone {}: zones are 1 to 60", self.zone)),
        };
        if outside(self.easting, east.0, east.1) {
            return Some(format!("easting {}: between {} and {} m here", self.easting, east.0, east.1));
        }
        outside(self.northing, north.0, north.1)
            .then(|| format!("northing {}: between {} and {} m here", self.northing, north.0, north.1))
    }
}

impl std::fmt::Display for Utm {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let hemisphere = if self.north { "north" } else { "south" };
        match self.zone {
            0 => write!(f, "UPS {hemisphere} {:.3} {:.3}", self.easting, self.northing),
            zone => write!(f, "{zone} {hemisphere} {:.3} {:.3}", self.easting, self.northing),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn zones_with_their_exceptions() {
        for (lat, lon, zone) in [
            (0.0, -180.0, 1),
            (0.0, 180.0, 1),
            (0.0, 179.999, 60),
            (60.0, 4.0, 32),
            (60.0, 2.9, 31),
            (75.0, 8.0, 31),
            (75.0, 9.0, 33),
            (75.0, 41.9, 37),
            (75.0, 42.0, 38),
            (84.0, 0.0, 0),
            (83.9, 0.0, 31),
            (-80.0, 0.0, 31),
            (-80.1, 0.0, 0),
        ] {
            assert_eq!(standard_zone(lat, lon), zone, "{lat} {lon}");
        }
    }

    /// Metres between two points in degrees, on a sphere: enough for nanometres.
    fn apart(a: (f64, f64), b: (f64, f64)) -> f64 {
        let east = normalised_longitude(a.1 - b.1) * a.0.to_radians().cos();
        (a.0 - b.0).hypot(east) * 111_320.0
    }

    proptest! {
        /// The last place of a northing of 10,000 km is 2 nm, that of a longitude of 180° is 3 nm.
        #[test]
        fn round_trip(lat in -90.0..=90.0f64, lon in -180.0..180.0f64) {
            let off = apart((lat, lon), Utm::of(lat, lon).to_degrees());
            prop_assert!(off < 5e-9, "{off}");
        }

        #[test]
        fn round_trip_in_a_neighbouring_zone(lat in -80.0..84.0f64, off in -9.0..9.0f64, zone in 1u8..=60) {
            let lon = normalised_longitude(central_meridian(zone) + off);
            let off = apart((lat, lon), Utm::in_zone(lat, lon, zone).to_degrees());
            prop_assert!(off < 5e-9, "{off}");
        }
    }
}
