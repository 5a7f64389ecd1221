use orb_formats::xml;
use serde_json::Value;

use super::*;
use crate::geo::{Enu, Geodetic, HeadingSource, footprint};

/// Corners of a box in the subject frame, metres.
const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -2.0, 0.0],
    [1.0, -2.0, 0.0],
    [1.0, 2.0, 0.0],
    [-1.0, 2.0, 0.0],
    [-1.0, -2.0, 1.5],
    [1.0, -2.0, 1.5],
    [1.0, 2.0, 1.5],
    [-1.0, 2.0, 1.5],
];

fn georeference(longitude: f64) -> Georeference {
    let origin = Geodetic { latitude: 34.5523, longitude, height: 740.0 };
    let placement = Placement { origin, heading: 213.5, heading_source: HeadingSource::Given };
    Georeference {
        name: "van".into(),
        banner: "SECRET".into(),
        utc: "2026-11-21T04:05:06.789Z".into(),
        placement,
        uncertainty: Uncertainty { horizontal: 3.21, vertical: 4.5, heading: 2.0, scale: 0.13 },
        footprint: footprint::of(CORNERS.into_iter(), &placement),
        size: [2.0, 4.0, 1.5],
        lineage: vec!["Position: <given> & \"quoted\".".into(), "Heading: given.".into()],
        assets: vec![Asset {
            path: "van.flt".into(),
            media_type: "application/x-openflight".into(),
            role: "model".into(),
        }],
    }
}

fn named(suffix: &str, longitude: f64) -> String {
    let all = all(&georeference(longitude));
    String::from_utf8(all.into_iter().find(|s| s.path.ends_with(suffix)).unwrap().bytes).unwrap()
}

fn json(suffix: &str, longitude: f64) -> Value {
    serde_json::from_str(&named(suffix, longitude)).unwrap()
}

/// Rotates with the pose's quaternion into east, north, up, as a reader of the pose would.
#[test]
fn the_pose_puts_corners_where_the_placement_does() {
    let pose = json("geopose.json", -118.4712);
    let q = |k: &str| pose["quaternion"][k].as_f64().unwrap();
    let (x, y, z, w) = (q("x"), q("y"), q("z"), q("w"));
    assert!((x * x + y * y + z * z + w * w - 1.0).abs() < 1e-12 && w >= 0.0);
    let p = |k: &str| pose["position"][k].as_f64().unwrap();
    let origin = Geodetic { latitude: p("lat"), longitude: p("lon"), height: p("h") };
    let placement = georeference(-118.4712).placement;
    for corner in CORNERS {
        let v = glam::DQuat::from_xyzw(x, y, z, w) * glam::DVec3::from_array(corner);
        let read = origin.offset(Enu { east: v.x, north: v.y, up: v.z }).to_ecef();
        let truth = placement.to_ecef(corner);
        assert!((read.x - truth.x).hypot(read.y - truth.y).hypot(read.z - truth.z) < 1e-6);
    }
}

#[test]
fn footprints_are_rings_against_the_clock() {
    let read = json("footprint.geojson", -118.4712);
    let geometry = &read["features"][0]["geometry"];
    assert_eq!(geometry["type"], "Polygon");
    let ring: Vec<[f64; 2]> = serde_json::from_value(geometry["coordinates"][0].clone()).unwrap();
    assert_eq!((ring.len(), ring.first()), (5, ring.last()));
    let twice_area: f64 = ring.windows(2).map(|w| w[0][0] * w[1][1] - w[1][0] * w[0][1]).sum();
    assert!(twice_area > 0.0);
    let area = read["features"][0]["properties"]["area_m2"].as_f64().unwrap();
    assert!((area - 8.0).abs() < 2e-3, "{area}");
    assert_eq!(json("footprint.geojson", 180.0)["features"][0]["geometry"]["type"], "MultiPolygon");
    let bbox = &json("footprint.geojson", 180.0)["bbox"];
    assert!(bbox[0].as_f64() > Some(179.0) && bbox[2].as_f64() < Some(-179.0));
}

#[test]
fn deviations_and_marking_stand_in_every_sidecar() {
    for sidecar in all(&georeference(-118.4712)) {
        let text = String::from_utf8(sidecar.bytes).unwrap();
        assert!(text.contains("SECRET") && text.contains("3.21") && text.contains("4.5"), "{}", sidecar.path);
    }
}

#[test]
fn xml_is_well_formed_and_classified() {
    for suffix in ["kml", "iso19115.xml"] {
        for longitude in [-118.4712, 180.0] {
            let text = named(suffix, longitude);
            let root = xml::parse(&text).unwrap();
            assert!(matches!(root.local_name(), "kml" | "MD_Metadata"));
        }
    }
    let metadata = named("iso19115.xml", -118.4712);
    assert!(metadata.contains("codeListValue=\"secret\"") && metadata.contains("&lt;given&gt; &amp;"));
    // KML's altitudes are above the geoid: some 34 m more here than above the ellipsoid.
    let top = 741.5 - crate::geo::geoid::undulation(34.5523, -118.4712);
    assert!(named("kml", -118.4712).contains(&format!(",{top:.3}")));
}

#[test]
fn the_catalogue_entry_lists_what_is_there() {
    let item = json("stac.json", -118.4712);
    assert_eq!(item["assets"]["van.flt"]["roles"][0], "data");
    assert_eq!(item["assets"]["van.kml"]["href"], "./van.kml");
    assert_eq!(item["bbox"].as_array().unwrap().len(), 4);
}
