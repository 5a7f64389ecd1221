//! `EPSG:code x,y[,z]`. WGS84's own codes are built in; PROJ reads every other, where the machine has it.

use super::Ecef;
use super::datum::AltDatum;
use super::proj::Proj;
use super::utm::Utm;
use super::wgs84::A;
use super::written::{Fault, Written, fault, from_grid, in_range, number};
use crate::{Error, Result};

/// Reads what stands behind `EPSG:`. Numbers in the order of the code's own axes: latitude first for 4326 and 4979.
///
/// # Errors
/// A usage error on `subject` that names the wrong part; a code of another system on a machine without PROJ.
pub(super) fn parse(subject: &str, text: &str) -> Result<Written> {
    let bad = |(expected, found): Fault| {
        Error::usage(subject)
            .expected(expected)
            .found(format!("`{found}`"))
            .advice("Write EPSG:code x,y or EPSG:code x,y,z, for example EPSG:32611 365018,3824380,740")
    };
    let (code, rest) = text.split_once(|c: char| c.is_whitespace() || c == ':').unwrap_or((text, ""));
    let digits = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
    if !code.split('+').all(digits) {
        return Err(bad(fault("a code of digits", code)));
    }
    let words: Vec<&str> = rest.split([',', ' ', '\t']).filter(|w| !w.is_empty()).collect();
    if !(2..=3).contains(&words.len()) {
        return Err(bad(fault("two or three numbers behind the code", rest)));
    }
    let mut v = [0.0; 3];
    let (mut step, mut z_step) = (0f64, 0.0);
    for (i, word) in words.iter().enumerate() {
        let (value, place) = number(word, "a number").map_err(bad)?;
        v[i] = value;
        if i < 2 {
            step = step.max(place);
        } else {
            z_step = place;
        }
    }
    let z = (words.len() == 3).then_some((v[2], z_step / 2.0));
    match code.parse().ok().and_then(|code| built_in(code, v, z, step)) {
        Some(read) => read.and_then(in_range).map_err(bad),
        None => other(subject, code, v, z, step, Proj::find()),
    }
}

/// Codes of WGS84 itself: 4326, 4979, 4978, 3857, UTM, UPS.
fn built_in(code: u32, [x, y, _]: [f64; 3], z: Option<(f64, f64)>, step: f64) -> Option<Result<Written, Fault>> {
    let degrees = |latitude, longitude, datum| {
        Ok(Written {
            latitude,
            longitude,
            height: z.map(|z| z.0),
            height_datum: datum,
            rounding: step / 2.0 * 111_320.0,
            height_rounding: z.map_or(0.0, |z| z.1),
            sigma: None,
            form: "EPSG code",
            proj: None,
        })
    };
    let grid = |zone, north, easting, northing| {
        from_grid(Utm { zone, north, easting, northing }, z, step / 2.0).map(|w| Written { form: "EPSG code", ..w })
    };
    Some(match code {
        4326 => degrees(x, y, None),
        4979 => degrees(x, y, Some(AltDatum::Ellipsoid)),
        4978 => match z {
            None => Err(fault("three geocentric coordinates", format!("{x},{y}"))),
            Some((z, z_rounding)) => {
                let g = Ecef { x, y, z }.to_geodetic();
                Ok(Written {
                    latitude: g.latitude,
                    longitude: g.longitude,
                    height: Some(g.height),
                    height_datum: Some(AltDatum::Ellipsoid),
                    rounding: step / 2.0,
                    height_rounding: z_rounding,
                    sigma: None,
                    form: "EPSG code",
                    proj: None,
                })
            }
        },
        // EPSG Guidance Note 7-2, method 1024: the sphere's Mercator over geodetic latitudes.
        3857 => degrees((y / A).sinh().atan().to_degrees(), (x / A).to_degrees(), None)
            .map(|w| Written { rounding: step / 2.0, ..w }),
        32601..=32660 => grid((code - 32600) as u8, true, x, y),
        32701..=32760 => grid((code - 32700) as u8, false, x, y),
        5041 => grid(0, true, x, y),
        5042 => grid(0, false, x, y),
        // The same projections, northing first.
        32661 => grid(0, true, y, x),
        32761 => grid(0, false, y, x),
        _ => return None,
    })
}

/// A code that is not built in, by the machine's PROJ where it has one.
fn other(
    subject: &str,
    code: &str,
    v: [f64; 3],
    z: Option<(f64, f64)>,
    step: f64,
    proj: Option<Proj>,
) -> Result<Written> {
    let Some(proj) = proj else {
        return Err(Error::usage(subject)
            .expected("a code of WGS84 (4326, 4979, 4978, 3857, 32601 to 32660, 32701 to 32760, 5041, 5042), or PROJ's library on this machine")
            .found(format!("EPSG:{code}, and no PROJ"))
            .advice("Install PROJ (Debian: libproj25 and proj-data), or convert the point first."));
    };
    let refused = |why: String| Error::usage(subject).expected("a point that PROJ can convert").found(why);
    let got = proj.to_wgs84(&format!("EPSG:{code}"), v).map_err(|why| refused(format!("EPSG:{code}: {why}")))?;
    let read = Written {
        latitude: got.latitude,
        longitude: got.longitude,
        height: z.map(|_| got.height),
        height_datum: (z.is_some() && got.vertical).then_some(AltDatum::Ellipsoid),
        rounding: step / 2.0 * got.metres_per_unit,
        height_rounding: z.map_or(0.0, |z| z.1),
        sigma: None,
        form: "EPSG code",
        proj: Some(proj.version()),
    };
    in_range(read).map_err(|(expected, found)| refused(format!("{found}, not {expected}")))
}

#[cfg(test)]
mod tests {
    use super::super::written::parse_point;

    /// `cs2cs -f %.10f EPSG:4979 EPSG:code` (PROJ 9.5.1 by pyproj) of 34.5523 -118.4712 740 and of -85 10 0.
    #[test]
    fn codes_of_wgs84() {
        for text in [
            "EPSG:3857 -13188153.657668,4103205.721807",
            "EPSG:4978 -2507228.233960,-4623280.354253,3597491.503001",
            "EPSG:32611 365018.131461,3824379.671931",
        ] {
            let p = parse_point("p", text).unwrap();
            assert!((p.latitude - 34.5523).abs() < 1e-10 && (p.longitude + 118.4712).abs() < 1e-10, "{text} {p:?}");
        }
        for text in ["EPSG:32761 2547018.745502,2096454.163785", "EPSG:5042 2096454.163785,2547018.745502"] {
            let p = parse_point("p", text).unwrap();
            assert!((p.latitude + 85.0).abs() < 1e-10 && (p.longitude - 10.0).abs() < 1e-9, "{text} {p:?}");
        }
        assert!(parse_point("p", "EPSG:4978 1,2").is_err());
    }

    #[test]
    fn other_codes_are_refused_by_name_where_there_is_no_proj() {
        let e = super::other("--origin", "2056", [2_600_000.0, 1_200_000.0, 0.0], None, 1.0, None).unwrap_err();
        let e = e.to_string();
        assert!(e.contains("EPSG:2056") && e.contains("no PROJ") && e.contains("libproj25"), "{e}");
    }
}
