//! GeoTIFF's keys: from degrees to the terrain's pixels.

use std::io::{Read, Seek};

use tiff::decoder::Decoder;
use tiff::tags::Tag;

use super::super::datum::AltDatum;
use super::super::utm::{Utm, normalised_longitude};

/// The systems that a terrain may be in.
#[derive(Clone, Copy, Debug, PartialEq)]
enum System {
    /// Degrees.
    Geographic,
    /// UTM zone, 0 for UPS, of the north or south.
    Grid { zone: u8, north: bool },
}

pub(in crate::geo) struct Keys {
    system: System,
    /// Pixel corner → model: x = m[0] c + m[1] r + m[2], y = m[3] c + m[4] r + m[5].
    to_model: [f64; 6],
    /// A value belongs to the pixel's middle, not to its corner.
    area: bool,
    pub datum: AltDatum,
    pub metres_per_unit: f64,
}

/// What was expected and found.
type Fault = (String, String);

impl Keys {
    pub(in crate::geo) fn read<R: Read + Seek>(decoder: &mut Decoder<R>) -> Result<Keys, Fault> {
        let fault = |expected: &str, found: String| (expected.to_owned(), found);
        let directory = decoder
            .get_tag_u16_vec(Tag::GeoKeyDirectoryTag)
            .map_err(|_| fault("a georeferenced TIFF", "no GeoKeyDirectory".into()))?;
        // Four shorts a key behind four of header; only values held in place (location 0) matter here.
        let key = |id: u16| directory.chunks_exact(4).skip(1).find(|k| k[0] == id && k[1] == 0).map(|k| k[3]);
        let system = match (key(1024), key(2048), key(3072)) {
            (Some(2), Some(code), _) => {
                geographic(code).ok_or_else(|| fault("a terrain in WGS84, NAD83 or ETRS89", format!("EPSG:{code}")))?
            }
            (Some(1), _, Some(code)) => {
                projected(code).ok_or_else(|| fault("a terrain in degrees, UTM or UPS", format!("EPSG:{code}")))?
            }
            other => return Err(fault("a terrain in degrees, UTM or UPS", format!("GeoTIFF keys {other:?}"))),
        };
        let to_model = match (
            transformation(decoder),
            decoder.get_tag_f64_vec(Tag::ModelPixelScaleTag),
            decoder.get_tag_f64_vec(Tag::ModelTiepointTag),
        ) {
            (Some(m), _, _) => m,
            (None, Ok(scale), Ok(tie)) if scale.len() >= 2 && tie.len() >= 6 => {
                [scale[0], 0.0, tie[3] - tie[0] * scale[0], 0.0, -scale[1], tie[4] + tie[1] * scale[1]]
            }
            _ => return Err(fault("a georeferenced TIFF", "no pixel scale and tie point".into())),
        };
        let [a, b, _, d, e, _] = to_model;
        if !to_model.iter().all(|v| v.is_finite()) || (a * e - b * d).abs() < 1e-18 {
            return Err(fault("a pixel scale that is not zero", format!("{to_model:?}")));
        }
        let metres_per_unit = match key(4099) {
            None | Some(9001 | 0) => 1.0,
            Some(9002) => 0.3048,
            Some(9003) => 1200.0 / 3937.0,
            Some(other) => return Err(fault("heights in metres or feet", format!("unit EPSG:{other}"))),
        };
        let datum = match key(4096) {
            // WGS84's ellipsoid, and geographic systems of three dimensions.
            Some(5030 | 4979 | 4326) => AltDatum::Ellipsoid,
            // EGM96, EGM2008, NAVD88 and what is not said: mean sea level, within a metre or so.
            _ => AltDatum::Msl,
        };
        Ok(Keys { system, to_model, area: key(1025) != Some(2), datum, metres_per_unit })
    }

    /// Column and row of a point, whole numbers at the posts; `None` where the system has no such point.
    pub(in crate::geo) fn pixel(&self, latitude: f64, longitude: f64) -> Option<(f64, f64)> {
        let [a, b, c, d, e, f] = self.to_model;
        let invert = |x: f64, y: f64| {
            let (x, y, determinant) = (x - c, y - f, a * e - b * d);
            ((e * x - b * y) / determinant, (a * y - d * x) / determinant)
        };
        let (column, row) = match self.system {
            System::Geographic => {
                // The turn of longitude that lies nearest behind the file's western edge.
                let west = c.min(c + a * 1e-9);
                invert(west + (longitude - west).rem_euclid(360.0), latitude)
            }
            System::Grid { zone, north } => {
                if zone > 0 && normalised_longitude(longitude - (6.0 * f64::from(zone) - 183.0)).abs() > 30.0 {
                    return None;
                }
                let mut at = Utm::in_zone(latitude, longitude, zone);
                if at.north != north {
                    if zone == 0 {
                        return None;
                    }
                    at.northing += if north { -10_000_000.0 } else { 10_000_000.0 };
                }
                invert(at.easting, at.northing)
            }
        };
        let half = if self.area { 0.5 } else { 0.0 };
        Some((column - half, row - half))
    }
}

/// WGS84, NAD83, ETRS89 and the GRS80 systems like them: within two metres of each other, less than a post's spacing.
fn geographic(code: u16) -> Option<System> {
    matches!(code, 4326 | 4979 | 4269 | 4258 | 4283 | 7844 | 4617 | 6318 | 4148).then_some(System::Geographic)
}

fn projected(code: u16) -> Option<System> {
    let grid = |zone: u16, north| Some(System::Grid { zone: zone as u8, north });
    match code {
        32601..=32660 => grid(code - 32600, true),
        32701..=32760 => grid(code - 32700, false),
        // NAD83, NAD83(2011) and ETRS89.
        26901..=26923 => grid(code - 26900, true),
        6330..=6348 => grid(code - 6329, true),
        25828..=25838 => grid(code - 25800, true),
        5041 | 32661 => grid(0, true),
        5042 | 32761 => grid(0, false),
        _ => None,
    }
}

/// The 4 × 4 matrix of a rotated raster.
fn transformation<R: Read + Seek>(decoder: &mut Decoder<R>) -> Option<[f64; 6]> {
    let m = decoder.get_tag_f64_vec(Tag::ModelTransformationTag).ok()?;
    (m.len() == 16).then(|| [m[0], m[1], m[3], m[4], m[5], m[7]])
}
