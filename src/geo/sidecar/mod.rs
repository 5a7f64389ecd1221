//! What geospatial programs read beside a model: pose, footprint, map, catalogue entry, metadata.
//!
//! Plain values in, bytes out; no clock and no disk. Each carries the marking and the deviations.

mod geojson;
mod geopose;
mod iso19115;
mod kml;
mod stac;
#[cfg(test)]
mod tests;

use super::footprint::Footprint;
use super::{Placement, Uncertainty};

/// What the sidecars tell.
#[derive(Clone, Debug)]
pub struct Georeference {
    /// The model's stem.
    pub name: String,
    /// The banner: `UNCLASSIFIED`.
    pub banner: String,
    /// `YYYY-MM-DDTHH:MM:SS.mmmZ`.
    pub utc: String,
    pub placement: Placement,
    pub uncertainty: Uncertainty,
    pub footprint: Footprint,
    /// Across (x), deep (y), high (z), metres.
    pub size: [f64; 3],
    /// How position, heading and scale were found, a sentence each.
    pub lineage: Vec<String>,
    /// What lies beside the sidecars.
    pub assets: Vec<Asset>,
}

/// A file of the published folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Asset {
    pub path: String,
    pub media_type: String,
    pub role: String,
}

/// A sidecar's name, bytes and media type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sidecar {
    pub path: String,
    pub bytes: Vec<u8>,
    pub media_type: &'static str,
}

/// All of them; the catalogue entry lists the others.
pub fn all(g: &Georeference) -> Vec<Sidecar> {
    let named = |suffix: &str, media_type, text: String| Sidecar {
        path: format!("{}.{suffix}", g.name),
        bytes: text.into_bytes(),
        media_type,
    };
    let mut out = vec![
        named("geopose.json", "application/json", geopose::write(g)),
        named("footprint.geojson", "application/geo+json", geojson::write(g)),
        named("kml", "application/vnd.google-earth.kml+xml", kml::write(g)),
        named("iso19115.xml", "application/xml", iso19115::write(g)),
    ];
    let beside: Vec<Asset> = out
        .iter()
        .map(|s| Asset { path: s.path.clone(), media_type: s.media_type.into(), role: "metadata".into() })
        .collect();
    out.push(named("stac.json", "application/geo+json", stac::write(g, &beside)));
    out
}

/// The document of a KMZ that shows the model at `path` inside it.
pub fn kml_with_model(g: &Georeference, path: &str) -> String {
    kml::with_model(g, path)
}

/// Pretty JSON with a final newline; keys in alphabetical order, as `serde_json` keeps them.
fn pretty(value: &serde_json::Value) -> String {
    format!("{value:#}\n")
}

/// The deviations as every JSON sidecar names them.
fn deviations(u: &Uncertainty) -> serde_json::Value {
    serde_json::json!({
        "standard_deviations": 1,
        "horizontal_m": rounded(u.horizontal, 4),
        "vertical_m": rounded(u.vertical, 4),
        "heading_deg": rounded(u.heading, 3),
        "scale_percent": rounded(u.scale * 100.0, 3),
    })
}

/// Deviations need no more places.
fn rounded(value: f64, places: i32) -> f64 {
    let unit = 10f64.powi(places);
    (value * unit).round() / unit
}

/// RFC 7946 geometry of the footprint: one polygon, or two where the antimeridian cuts it.
pub fn geometry(footprint: &Footprint) -> serde_json::Value {
    let rings = footprint.rings();
    match &rings[..] {
        [one] => serde_json::json!({"type": "Polygon", "coordinates": [one]}),
        several => {
            let polygons: Vec<_> = several.iter().map(|r| serde_json::json!([r])).collect();
            serde_json::json!({"type": "MultiPolygon", "coordinates": polygons})
        }
    }
}

/// West, south, east, north; west is the larger where the antimeridian lies between (RFC 7946, section 5.2).
pub fn bounds(footprint: &Footprint) -> [f64; 4] {
    let rings = footprint.rings();
    let all = rings.iter().flatten();
    let south = all.clone().map(|p| p[1]).fold(f64::INFINITY, f64::min);
    let north = all.clone().map(|p| p[1]).fold(f64::NEG_INFINITY, f64::max);
    let span = |east_half: Option<bool>| {
        all.clone()
            .map(|p| p[0])
            .filter(|&x| east_half.is_none_or(|e| (x > 0.0) == e))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)))
    };
    if rings.len() == 2 {
        [span(Some(true)).0, south, span(Some(false)).1, north]
    } else {
        let (west, east) = span(None);
        [west, south, east, north]
    }
}
