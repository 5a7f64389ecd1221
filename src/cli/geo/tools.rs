//! `orb geo convert`, `distance`, `footprint`: one look at coordinates without a photo.

use std::fmt::Write;

use clap::{Args, Subcommand, ValueEnum};

use super::options::Datum;
use crate::geo::{
    self, AltDatum, Geodetic, HeadingSource, Placement, Utm, Written, footprint, geoid, magnetic, mgrs, to_ellipsoid,
};
use crate::{Error, Result};

#[derive(Subcommand, Clone, Debug)]
pub enum Tool {
    /// Write a point in every form.
    Convert(Convert),
    /// Measure the shortest line between two points.
    Distance(Distance),
    /// Outline a rectangle on the ground as GeoJSON.
    Footprint(Footprint),
}

#[derive(Args, Clone, Debug)]
pub struct Convert {
    /// Decimal degrees, degrees-minutes-seconds, MGRS, UTM, `EPSG:code x,y[,z]` or a geo: URI, with or without a height.
    #[arg(value_name = "POINT", allow_hyphen_values = true)]
    point: String,
    /// What the height is above.
    #[arg(long, value_enum, default_value = "ellipsoid")]
    alt_datum: Datum,
    /// One form alone.
    #[arg(long, value_enum)]
    to: Option<Form>,
    /// One JSON object on standard output.
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Form {
    Degrees,
    Dms,
    Utm,
    Mgrs,
    Ecef,
    Geo,
}

#[derive(Args, Clone, Debug)]
pub struct Distance {
    #[arg(value_name = "FROM", allow_hyphen_values = true)]
    from: String,
    #[arg(value_name = "TO", allow_hyphen_values = true)]
    to: String,
    #[arg(long)]
    json: bool,
}

#[derive(Args, Clone, Debug)]
pub struct Footprint {
    /// The middle of the rectangle.
    #[arg(value_name = "POINT", allow_hyphen_values = true)]
    point: String,
    /// Bearing of its depth, degrees clockwise from true north.
    #[arg(long, value_name = "DEG", default_value_t = 0.0, allow_negative_numbers = true)]
    heading: f64,
    /// Metres across.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    width: f64,
    /// Metres along the heading.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    depth: f64,
}

/// What to print.
///
/// # Errors
/// Usage errors that name the wrong part of a point.
pub fn run(tool: &Tool, year: f64) -> Result<String> {
    match tool {
        Tool::Convert(c) => convert(c, year),
        Tool::Distance(d) => distance(d),
        Tool::Footprint(f) => outline(f),
    }
}

fn convert(c: &Convert, year: f64) -> Result<String> {
    let written = geo::parse_point("POINT", &c.point)?;
    let datum = match (written.height_datum, c.alt_datum) {
        (Some(own), _) => own,
        (None, Datum::Ellipsoid) => AltDatum::Ellipsoid,
        (None, Datum::Msl) => AltDatum::Msl,
        (None, Datum::Ground) => {
            return Err(Error::usage("--alt-datum")
                .expected("ellipsoid or msl")
                .found("`ground`: there is no terrain here"));
        }
    };
    let (latitude, longitude) = (written.latitude, written.longitude);
    let height = written.height.map(|h| to_ellipsoid((latitude, longitude), h, 0.0, datum, None)).transpose()?;
    let up = height.map(|h| h.ellipsoidal);
    let at = Geodetic { latitude, longitude, height: up.unwrap_or(0.0) };
    let ecef = at.to_ecef();
    let behind = up.map_or(String::new(), |h| format!(",{}", metres(h)));
    let degrees = format!("{},{}{behind}", degrees(latitude), degrees(longitude));
    let dms = format!("{} {}{}", sexagesimal(latitude, "NS"), sexagesimal(longitude, "EW"), behind.replace(',', " "));
    let utm = Utm::of(latitude, longitude).to_string() + &behind.replace(',', " ");
    let grid = mgrs::format(latitude, longitude, 5) + &behind;
    let uri = format!("geo:{degrees}");
    let geocentric = format!("{:.4},{:.4},{:.4}", ecef.x, ecef.y, ecef.z);
    let undulation = geoid::undulation(latitude, longitude);
    let declination = magnetic::field(at, year).declination;
    if c.json {
        let u = Utm::of(latitude, longitude);
        return Ok(format!(
            "{}\n",
            serde_json::json!({
                "latitude": latitude, "longitude": longitude, "ellipsoidal_height_m": up, "dms": dms,
                "utm": {"zone": u.zone, "north": u.north, "easting": u.easting, "northing": u.northing},
                "mgrs": grid, "geo": uri, "ecef": up.map(|_| [ecef.x, ecef.y, ecef.z]),
                "geoid_egm96_m": undulation, "msl_height_m": up.map(|h| h - undulation), "declination_deg": declination,
                "written_as": written.read_as(), "rounding_m": written.rounding,
            })
        ));
    }
    let one = |form| match form {
        Form::Degrees => degrees.clone(),
        Form::Dms => dms.clone(),
        Form::Utm => utm.clone(),
        Form::Mgrs => grid.clone(),
        Form::Ecef => geocentric.clone(),
        Form::Geo => uri.clone(),
    };
    if let Some(form) = c.to {
        if form == Form::Ecef && up.is_none() {
            return Err(Error::usage("POINT").expected("a height behind the position").found("none"));
        }
        return Ok(one(form) + "\n");
    }
    let mut out = String::new();
    let mut line = |name: &str, words: String| _ = writeln!(out, "{name:<12} {words}");
    line("degrees", one(Form::Degrees));
    line("dms", one(Form::Dms));
    line("utm", one(Form::Utm));
    line("mgrs", one(Form::Mgrs));
    line("geo", one(Form::Geo));
    if let Some(h) = up {
        line("ecef", one(Form::Ecef));
        line("height", format!("{} m above the ellipsoid, {} m above the sea", metres(h), metres(h - undulation)));
    }
    line("geoid", format!("{} m above the ellipsoid (EGM96)", metres(undulation)));
    line("declination", format!("{declination:.2}° (WMM2025, {year:.1})"));
    line("read as", format!("{}, its last place worth {} m", written.read_as(), rounding(&written)));
    Ok(out)
}

/// Half a last place to its whole.
fn rounding(written: &Written) -> String {
    let whole = 2.0 * written.rounding;
    if whole >= 0.01 { format!("{whole:.2}") } else { format!("{whole:.1e}") }
}

/// Ten places: ten micrometres.
fn degrees(v: f64) -> String {
    trimmed(format!("{v:.10}"))
}

fn metres(v: f64) -> String {
    trimmed(format!("{v:.4}"))
}

fn trimmed(text: String) -> String {
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if matches!(short, "-0" | "") { "0".into() } else { short.into() }
}

/// `34°33'08.28000"N`; seconds to a third of a millimetre.
fn sexagesimal(v: f64, letters: &str) -> String {
    // Rounded as a whole, so that no 60 seconds appear.
    let units = (v.abs() * 3600.0 * 1e5).round() as u64;
    let (seconds, rest) = (units % 6_000_000, units / 6_000_000);
    let letter = if v < 0.0 { &letters[1..] } else { &letters[..1] };
    format!("{}°{:02}'{:02}.{:05}\"{letter}", rest / 60, rest % 60, seconds / 100_000, seconds % 100_000)
}

fn distance(d: &Distance) -> Result<String> {
    let (a, b) = (geo::parse_point("FROM", &d.from)?, geo::parse_point("TO", &d.to)?);
    let (metres, start, end) = footprint::geodesic((a.latitude, a.longitude), (b.latitude, b.longitude));
    let straight = a.height.zip(b.height).map(|(ha, hb)| {
        let at = |w: &Written, height| Geodetic { latitude: w.latitude, longitude: w.longitude, height }.to_ecef();
        let (p, q) = (at(&a, ha), at(&b, hb));
        (p.x - q.x).hypot(p.y - q.y).hypot(p.z - q.z)
    });
    if d.json {
        return Ok(format!(
            "{}\n",
            serde_json::json!({"distance_m": metres, "bearing_deg": start, "bearing_at_end_deg": end, "straight_m": straight})
        ));
    }
    let mut out = format!(
        "distance     {metres:.4} m on the ellipsoid\nbearing      {start:.8}° at the start, {end:.8}° at the end\n"
    );
    if let Some(s) = straight {
        out += &format!("straight     {s:.4} m\n");
    }
    Ok(out)
}

fn outline(f: &Footprint) -> Result<String> {
    let at = geo::parse_point("POINT", &f.point)?;
    for (name, v) in [("--width", f.width), ("--depth", f.depth)] {
        if !(v.is_finite() && v > 0.0 && v < 10_000.0) {
            return Err(Error::usage(name).expected("metres between 0 and 10,000").found(v.to_string()));
        }
    }
    if !f.heading.is_finite() {
        return Err(Error::usage("--heading").expected("degrees").found(f.heading.to_string()));
    }
    let origin = Geodetic { latitude: at.latitude, longitude: at.longitude, height: at.height.unwrap_or(0.0) };
    let placement = Placement { origin, heading: f.heading.rem_euclid(360.0), heading_source: HeadingSource::Given };
    let (x, y) = (f.width / 2.0, f.depth / 2.0);
    let corners = [[-x, -y, 0.0], [x, -y, 0.0], [x, y, 0.0], [-x, y, 0.0]];
    let ring = footprint::of(corners.into_iter(), &placement);
    let properties =
        serde_json::json!({"area_m2": ring.area, "perimeter_m": ring.perimeter, "heading_deg": placement.heading});
    let feature = serde_json::json!({
        "type": "Feature", "geometry": geo::sidecar::geometry(&ring), "bbox": geo::sidecar::bounds(&ring), "properties": properties,
    });
    Ok(format!("{feature:#}\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn convert_one(point: &str, to: Form) -> String {
        let c = Convert { point: point.into(), alt_datum: Datum::Ellipsoid, to: Some(to), json: false };
        convert(&c, 2026.0).unwrap().trim().to_owned()
    }

    #[test]
    fn every_form_reads_back() {
        for text in [
            "34.5523,-118.4712,740",
            "-0.000001,179.9999999,-12",
            "-85,10,2800",
            "89.99999999,0,0",
            "59.99999999999,-59.9999999999,1",
        ] {
            let truth = geo::parse_point("p", text).unwrap();
            for (form, off) in [
                (Form::Degrees, 2e-5),
                (Form::Dms, 4e-4),
                (Form::Utm, 1e-3),
                (Form::Ecef, 2e-4),
                (Form::Geo, 2e-5),
                (Form::Mgrs, 1.5),
            ] {
                let written = convert_one(text, form);
                let prefix = if form == Form::Ecef { "EPSG:4978 " } else { "" };
                let read =
                    geo::parse_point("p", &format!("{prefix}{written}")).unwrap_or_else(|e| panic!("{written}: {e}"));
                let (metres, _, _) =
                    footprint::geodesic((truth.latitude, truth.longitude), (read.latitude, read.longitude));
                assert!(metres < off, "{text} {form:?}: {written} is {metres} m off");
                assert!((read.height.unwrap() - truth.height.unwrap()).abs() < 1e-3);
            }
        }
        assert_eq!(convert_one("34.5523,-118.4712,740", Form::Dms), "34°33'08.28000\"N 118°28'16.32000\"W 740");
    }

    #[test]
    fn distances_and_outlines() {
        let said =
            distance(&Distance { from: "34.5523,-118.4712,740".into(), to: "51.5,-0.12,20".into(), json: false })
                .unwrap();
        assert!(said.contains("8743333.3594 m") && said.contains("34.00830511°"), "{said}");
        let f = Footprint { point: "34.5523,-118.4712".into(), heading: 30.0, width: 10.0, depth: 4.0 };
        let read: serde_json::Value = serde_json::from_str(&outline(&f).unwrap()).unwrap();
        assert!((read["properties"]["area_m2"].as_f64().unwrap() - 40.0).abs() < 1e-2);
        assert!(outline(&Footprint { width: -1.0, ..f }).is_err());
    }
}
