//! Coordinates as people write them: decimal degrees, degrees-minutes-seconds, UTM, UPS, MGRS, EPSG codes, `geo:` URIs.

use super::datum::AltDatum;
use super::utm::Utm;
use super::{angle, epsg, mgrs};
use crate::{Error, Result};

/// A point as it was written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Written {
    /// Degrees, WGS84.
    pub latitude: f64,
    pub longitude: f64,
    /// Metres, above what the writer says.
    pub height: Option<f64>,
    /// What the form itself says of the height: geocentric coordinates are ellipsoidal.
    pub height_datum: Option<AltDatum>,
    /// Half of the last place that was written, metres on the ground.
    pub rounding: f64,
    /// Half of the last place of the height, metres.
    pub height_rounding: f64,
    /// One standard deviation, metres, where the form has a place for it.
    pub sigma: Option<f64>,
    pub form: &'static str,
    /// The version of PROJ that converted it, where Orb did not itself.
    pub proj: Option<[i32; 3]>,
}

impl Written {
    /// How it was read, in words.
    pub fn read_as(&self) -> String {
        match self.proj {
            None => self.form.to_owned(),
            Some([major, minor, patch]) => format!("{} (PROJ {major}.{minor}.{patch})", self.form),
        }
    }
}

/// Metres a degree of latitude, for roundings.
const DEGREE: f64 = 111_320.0;
const FORMS: &str = "Write 34.5523,-118.4712,740 or 34°33'08\"N 118°28'16\"W 740 or 11SLU6501824379,740 or \
                     11 north 365018 3824380 740 or EPSG:32611 365018,3824380,740 or geo:34.5523,-118.4712,740";

/// Reads a point with or without a height.
///
/// # Errors
/// A usage error on `subject` (the option, or the file and line) that names the wrong part.
pub fn parse_point(subject: &str, text: &str) -> Result<Written> {
    let bad =
        |(expected, found): Fault| Error::usage(subject).expected(expected).found(format!("`{found}`")).advice(FORMS);
    let trimmed = text.trim();
    let lower = trimmed.to_ascii_lowercase();
    let read = if let Some(rest) = lower.strip_prefix("geo:") {
        geo_uri(rest)
    } else if lower.starts_with("epsg:") {
        return epsg::parse(subject, trimmed[5..].trim());
    } else if looks_like_mgrs(trimmed) {
        military(trimmed)
    } else if let Some(read) = utm(&lower) {
        read
    } else {
        degrees(trimmed)
    };
    let point = read.map_err(bad)?;
    in_range(point).map_err(bad)
}

/// What was expected, and the part that was found in its place.
pub(super) type Fault = (String, String);

pub(super) fn fault(expected: impl Into<String>, found: impl Into<String>) -> Fault {
    (expected.into(), found.into())
}

pub(super) fn in_range(p: Written) -> Result<Written, Fault> {
    let outside = |v: f64, low: f64, high: f64| !(v.is_finite() && (low..=high).contains(&v));
    if outside(p.latitude, -90.0, 90.0) {
        return Err(fault("a latitude between -90 and 90 degrees", p.latitude.to_string()));
    }
    if outside(p.longitude, -180.0, 180.0) {
        return Err(fault("a longitude between -180 and 180 degrees", p.longitude.to_string()));
    }
    match p.height {
        Some(h) if outside(h, -12_000.0, 100_000.0) => {
            Err(fault("a height between -12000 and 100000 metres", h.to_string()))
        }
        _ => Ok(p),
    }
}

/// A finite decimal number and the size of its last place.
pub(super) fn number(text: &str, what: &str) -> Result<(f64, f64), Fault> {
    let text = text.trim();
    let plain = text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+' | b'e' | b'E'));
    match text.parse::<f64>() {
        Ok(v) if plain && v.is_finite() => {
            let mantissa = text.split(['e', 'E']).next().unwrap_or(text);
            let decimals = mantissa.split_once('.').map_or(0, |(_, d)| d.len().min(15));
            Ok((v, 10f64.powi(-(decimals as i32))))
        }
        _ => Err(fault(what, text)),
    }
}

/// Metres and half of their last place.
fn height(text: &str) -> Result<(f64, f64), Fault> {
    let bare = text.trim().strip_suffix(['m', 'M']).unwrap_or(text);
    number(bare, "a height in metres").map(|(v, step)| (v, step / 2.0))
}

/// One to three letters after at most two digits, before any comma: no angle is written so.
fn looks_like_mgrs(text: &str) -> bool {
    let head: Vec<u8> =
        text.split(',').next().unwrap_or_default().bytes().filter(|b| !b.is_ascii_whitespace()).collect();
    let digits = head.iter().take_while(|b| b.is_ascii_digit()).count();
    let letters = head[digits..].iter().take_while(|b| b.is_ascii_alphabetic()).count();
    let rest = &head[digits + letters..];
    digits <= 2
        && letters == 3
        && !rest.is_empty()
        && rest.iter().all(u8::is_ascii_alphanumeric)
        && !matches!(&head[digits..digits + letters].to_ascii_lowercase()[..], b"ups" | b"utm")
}

fn military(text: &str) -> Result<Written, Fault> {
    let (reference, up) = match text.split_once(',') {
        Some((r, h)) => (r, Some(height(h)?)),
        None => (text, None),
    };
    let square = mgrs::parse(reference).map_err(|said| fault("an MGRS reference", reference.trim()).named(said))?;
    let (latitude, longitude) = square.centre.to_degrees();
    Ok(Written {
        latitude,
        longitude,
        height: up.map(|h| h.0),
        height_datum: None,
        rounding: square.side / 2.0,
        height_rounding: up.map_or(0.0, |h| h.1),
        sigma: None,
        form: "MGRS",
        proj: None,
    })
}

/// Puts the part's own sentence into the expectation.
trait Named {
    fn named(self, said: String) -> Fault;
}

impl Named for Fault {
    fn named(self, said: String) -> Fault {
        (format!("{} ({said})", self.0), self.1)
    }
}

/// `11 north E N [H]`, `11N E N [H]`, `UTM 11C …`, `UPS south E N [H]`; `None` when it is none of these.
fn utm(lower: &str) -> Option<Result<Written, Fault>> {
    let words: Vec<&str> = lower.split([' ', '\t', ',', ';']).filter(|w| !w.is_empty()).collect();
    let said_so = matches!(words.first(), Some(&("utm" | "ups")));
    let polar = words.first() == Some(&"ups");
    let words = &words[usize::from(said_so)..];
    let zone_word = words.first()?;
    let digits = zone_word.bytes().take_while(u8::is_ascii_digit).count();
    let (zone_text, glued) = zone_word.split_at(digits);
    let (letter, rest) = match (glued, words.get(1)) {
        ("", Some(next)) => (*next, &words[2..]),
        (glued, _) => (glued, &words[1..]),
    };
    // Without the word, two numbers of grid size must follow: `34 N 118 W` are degrees.
    let sized = rest.len() >= 2 && rest[..2].iter().all(|w| w.parse::<f64>().is_ok_and(|v| v.abs() >= 10_000.0));
    let letters = !letter.is_empty() && letter.bytes().all(|b| b.is_ascii_alphabetic());
    if !(said_so || (sized && letters && digits > 0)) {
        return None;
    }
    Some(utm_words(polar, zone_text, letter, rest))
}

fn utm_words(polar: bool, zone_text: &str, letter: &str, rest: &[&str]) -> Result<Written, Fault> {
    let zone: u8 = match zone_text.parse() {
        _ if polar && zone_text.is_empty() => 0,
        Ok(zone @ 1..=60) if !polar => zone,
        _ => return Err(fault("a UTM zone between 1 and 60", zone_text)),
    };
    let north = match letter {
        "n" | "north" => true,
        "south" => false,
        "s" if polar => false,
        // Band S is in the north, the hemisphere S is not: a guess would be wrong by thousands of kilometres.
        "s" => {
            return Err(fault("`north` or `south` written out, for S is a northern band too", format!("{zone_text}S")));
        }
        band if band.len() == 1 && !polar && super::utm::BANDS.contains(&band.as_bytes()[0].to_ascii_uppercase()) => {
            band.as_bytes()[0] >= b'n'
        }
        _ => return Err(fault("north, south or a latitude band from C to X", letter)),
    };
    let (easting, step) = number(rest.first().unwrap_or(&""), "an easting in metres")?;
    let (northing, _) = number(rest.get(1).unwrap_or(&""), "a northing in metres")?;
    let up = rest.get(2).map(|h| height(h)).transpose()?;
    if let Some(more) = rest.get(3) {
        return Err(fault("nothing after the height", *more));
    }
    from_grid(Utm { zone, north, easting, northing }, up, step / 2.0)
}

/// A point of the grids, its ranges checked.
pub(super) fn from_grid(at: Utm, height: Option<(f64, f64)>, rounding: f64) -> Result<Written, Fault> {
    if let Some(why) = at.fault() {
        let (found, expected) = why.split_once(": ").unwrap_or(("", &why));
        return Err(fault(format!("a point of the grid ({expected})"), found));
    }
    let (latitude, longitude) = at.to_degrees();
    let form = if at.zone == 0 { "UPS" } else { "UTM" };
    let (height, height_rounding) = (height.map(|h| h.0), height.map_or(0.0, |h| h.1));
    Ok(Written {
        latitude,
        longitude,
        height,
        height_datum: None,
        rounding,
        height_rounding,
        sigma: None,
        form,
        proj: None,
    })
}

/// RFC 5870: `lat,lon[,alt][;crs=wgs84][;u=metres][;…]`; the altitude is WGS84's own, above the ellipsoid.
fn geo_uri(rest: &str) -> Result<Written, Fault> {
    let mut parts = rest.split(';');
    let coordinates: Vec<&str> = parts.next().unwrap_or_default().split(',').collect();
    if !(2..=3).contains(&coordinates.len()) {
        return Err(fault("geo:latitude,longitude or geo:latitude,longitude,height", format!("geo:{rest}")));
    }
    let mut sigma = None;
    for parameter in parts {
        match parameter.split_once('=') {
            Some(("crs", "wgs84")) => {}
            Some(("crs", other)) => return Err(fault("crs=wgs84", other)),
            Some(("u", metres)) => {
                let (u, _) = number(metres, "an uncertainty in metres")?;
                if u < 0.0 {
                    return Err(fault("an uncertainty of 0 metres or more", metres));
                }
                sigma = Some(u);
            }
            // RFC 5870, section 3.4.3: unknown parameters are for others.
            _ => {}
        }
    }
    let (latitude, step) = number(coordinates[0], "a latitude")?;
    let (longitude, _) = number(coordinates[1], "a longitude")?;
    let up = coordinates.get(2).map(|h| height(h)).transpose()?;
    Ok(Written {
        latitude,
        longitude,
        height: up.map(|h| h.0),
        height_datum: up.map(|_| AltDatum::Ellipsoid),
        rounding: step / 2.0 * DEGREE,
        height_rounding: up.map_or(0.0, |h| h.1),
        sigma,
        form: "geo URI",
        proj: None,
    })
}

fn degrees(text: &str) -> Result<Written, Fault> {
    let parts = angle::split(text).ok_or_else(|| fault("latitude,longitude,height", text))?;
    let (first, second) = (angle::read(parts[0])?, angle::read(parts[1])?);
    let (latitude, longitude) = match (first.axis, second.axis) {
        (Some(angle::Axis::Longitude), Some(angle::Axis::Latitude)) => (second, first),
        (Some(angle::Axis::Longitude), _) => return Err(fault("a latitude (N or S)", parts[0].trim())),
        (_, Some(angle::Axis::Latitude)) => return Err(fault("a longitude (E or W)", parts[1].trim())),
        _ => (first, second),
    };
    for (a, limit, what) in [(&latitude, 90, "latitude"), (&longitude, 180, "longitude")] {
        if a.degrees.abs() > f64::from(limit) {
            return Err(fault(format!("a {what} between -{limit} and {limit} degrees"), a.text));
        }
    }
    let up = parts.get(2).map(|h| height(h)).transpose()?;
    Ok(Written {
        latitude: latitude.degrees,
        longitude: longitude.degrees,
        height: up.map(|h| h.0),
        height_rounding: up.map_or(0.0, |h| h.1),
        height_datum: None,
        rounding: latitude.step.max(longitude.step * latitude.degrees.to_radians().cos()) / 2.0 * DEGREE,
        sigma: None,
        form: if latitude.sexagesimal || longitude.sexagesimal { "degrees, minutes, seconds" } else { "degrees" },
        proj: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(text: &str) -> Written {
        parse_point("--origin", text).unwrap_or_else(|e| panic!("{text}: {e}"))
    }

    #[test]
    fn one_place_in_every_form() {
        for text in [
            "34.5523,-118.4712,740",
            " 34.5523, -118.4712 ,740",
            "34.5523 -118.4712 740",
            "34.5523N 118.4712W 740m",
            "118.4712° W, 34.5523° N, 740",
            "34°33'08.28\"N 118°28'16.32\"W 740",
            "34 33 08.28 N, 118 28 16.32 W, 740",
            "34:33:08.28, -118:28:16.32, 740",
            "N34d33'08.28\" W118d28'16.32\" 740",
            "34° 33.138′ N, 118° 28.272′ W, 740",
            "34°33′08.28″ -118°28′16.32″ 740",
            "geo:34.5523,-118.4712,740",
            "GEO:34.5523,-118.4712,740;crs=wgs84;u=3;x=y",
            "EPSG:4326 34.5523,-118.4712,740",
            "epsg:4979 34.5523 -118.4712 740",
        ] {
            let p = point(text);
            assert!((p.latitude - 34.5523).abs() < 1e-9 && (p.longitude + 118.4712).abs() < 1e-9, "{text}: {p:?}");
            assert_eq!(p.height, Some(740.0), "{text}");
        }
        // GeoConvert -u -p 3, -m -p 3 (GeographicLib 2.1.2) of 34.5523 -118.4712.
        for text in [
            "11 north 365018.131 3824379.672 740",
            "11N 365018.131 3824379.672, 740",
            "UTM 11T 365018.131 3824379.672 740",
            "EPSG:32611 365018.131,3824379.672,740",
            "11SLU 65018131 24379671, 740",
        ] {
            let p = point(text);
            assert!((p.latitude - 34.5523).abs() < 2e-8 && (p.longitude + 118.4712).abs() < 2e-8, "{text}: {p:?}");
            assert_eq!(p.height, Some(740.0), "{text}");
        }
        assert_eq!(point("geo:1,2,3;u=3").sigma, Some(3.0));
        assert_eq!(point("geo:1,2,3").height_datum, Some(AltDatum::Ellipsoid));
        assert_eq!(point("34.5,-118").height, None);
    }

    #[test]
    fn the_last_place_written_is_known() {
        assert!((point("34.55,-118.47,0").rounding - 0.005 * DEGREE).abs() < 1e-6);
        assert!((point("34°33'08\"N 118°28'16\"W 0").rounding - 0.5 / 3600.0 * DEGREE).abs() < 1e-6);
        assert_eq!(point("11SLU6521,740").rounding, 500.0);
        assert_eq!(point("11 north 365021.0 3823926.0").rounding, 0.05);
    }

    #[test]
    fn refuses_and_names_the_part() {
        for (text, part) in [
            ("91,0,0", "`91`"),
            ("NaN,0,0", "`NaN`"),
            ("0,inf,0", "`inf`"),
            ("0,181,0", "`181`"),
            ("0,0,1e9", "`1000000000`"),
            ("0,0,x", "`x`"),
            ("0", "`0`"),
            ("", "``"),
            ("a,b,c", "`a`"),
            ("1,2,3,4", "`1,2,3,4`"),
            ("34°61'N 118°W 0", "`61`"),
            ("34°33'61\"N 118°W 0", "`61`"),
            ("34.5°33'N 118°W 0", "`34.5`"),
            ("-34N 118W 0", "`-34N`"),
            ("34N 118N 0", "`118N`"),
            ("34X 118W 0", "`X`"),
            ("11S 365018 3824380 740", "`11S`"),
            ("61 north 365018 3824380", "`61`"),
            ("11 north 36502100 3823926", "easting 36502100"),
            ("11 north 365018 382438000", "northing 382438000"),
            ("utm 11 north 365021", "``"),
            ("11SLW12341234", "`W`"),
            ("11SLU123,5", "`123`"),
            ("99SLU1234,5", "`99`"),
            ("geo:34.5", "geo:34.5"),
            ("geo:91,0", "`91`"),
            ("geo:1,2;crs=mars", "`mars`"),
            ("geo:1,2;u=-1", "`-1`"),
            ("EPSG:x 1,2", "`x`"),
            ("EPSG:32661 1", "`1`"),
            ("EPSG:32661 1,b", "`b`"),
        ] {
            let e = parse_point("--origin", text).unwrap_err();
            assert_eq!(e.kind, crate::Kind::Usage);
            assert!(e.to_string().contains(part), "{text}: {e}");
        }
    }
}
