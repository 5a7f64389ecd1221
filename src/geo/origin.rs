//! `--origin LAT,LON,ALT`.

use super::Geodetic;
use crate::{Error, Result};

/// Decimal degrees and metres above the WGS84 ellipsoid, separated by commas.
///
/// Refuses, naming the part: other than three numbers, not finite, latitude outside ±90, longitude outside ±180,
/// height outside −12 km … +100 km.
pub fn parse_origin(text: &str) -> Result<Geodetic> {
    let bad = |expected: &str, found: &str| {
        Error::usage("--origin")
            .expected(expected)
            .found(format!("`{found}`"))
            .advice("Write latitude,longitude,height, for example --origin 34.5523,-118.4712,740")
    };
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    if parts.len() != 3 {
        return Err(bad("three numbers: latitude,longitude,height", text));
    }
    let number = |i: usize, name: &str, low: f64, high: f64, unit: &str| -> Result<f64> {
        match parts[i].parse::<f64>() {
            Ok(v) if v.is_finite() && (low..=high).contains(&v) => Ok(v),
            _ => Err(bad(&format!("{name} between {low} and {high} {unit}"), parts[i])),
        }
    };
    Ok(Geodetic {
        latitude: number(0, "a latitude", -90.0, 90.0, "degrees")?,
        longitude: number(1, "a longitude", -180.0, 180.0, "degrees")?,
        height: number(2, "a height", -12_000.0, 100_000.0, "metres above the ellipsoid")?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn accepts_what_people_write() {
        let g = parse_origin(" 34.5523, -118.4712 ,740").unwrap();
        assert_eq!((g.latitude, g.longitude, g.height), (34.5523, -118.4712, 740.0));
    }

    #[test]
    fn refuses_and_names_the_part() {
        for (text, part) in [
            ("91,0,0", "`91`"),
            ("NaN,0,0", "`NaN`"),
            ("0,inf,0", "`inf`"),
            ("0,181,0", "`181`"),
            ("0,0,1e9", "`1e9`"),
            ("0,0", "`0,0`"),
            ("", "``"),
            ("a,b,c", "`a`"),
            ("1,2,3,4", "`1,2,3,4`"),
        ] {
            let e = parse_origin(text).unwrap_err();
            assert_eq!(e.kind, crate::Kind::Usage);
            assert!(e.found.contains(part), "{text}: {e}");
        }
    }
}
