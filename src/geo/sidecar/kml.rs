//! The footprint for Google Earth and its like: OGC KML 2.3 (12-007r2).
//!
//! A footprint raised to the model's height, no model: KML shows COLLADA only, which Orb does not write.

use orb_formats::xml::escape;

use super::super::geoid::undulation;
use super::Georeference;

/// Absolute altitudes of KML are above the EGM96 geoid, hence the undulation.
pub(super) fn write(g: &Georeference) -> String {
    let o = &g.placement.origin;
    let sea = o.height - undulation(o.latitude, o.longitude);
    let top = sea + g.size[2];
    let polygon = |ring: &Vec<[f64; 2]>| {
        let corners: Vec<String> = ring.iter().map(|[x, y]| format!("{x},{y},{top:.3}")).collect();
        format!(
            "<Polygon><extrude>1</extrude><altitudeMode>absolute</altitudeMode><outerBoundaryIs><LinearRing><coordinates>{}\
             </coordinates></LinearRing></outerBoundaryIs></Polygon>",
            corners.join(" ")
        )
    };
    let polygons: String = g.footprint.rings().iter().map(polygon).collect();
    let u = &g.uncertainty;
    let data: String = [
        ("marking", g.banner.clone()),
        ("ellipsoidal_height_m", o.height.to_string()),
        ("height_above_egm96_m", format!("{sea:.3}")),
        ("heading_deg", g.placement.heading.to_string()),
        ("model_height_m", format!("{:.3}", g.size[2])),
        ("horizontal_sigma_m", format!("{:.4}", u.horizontal)),
        ("vertical_sigma_m", format!("{:.4}", u.vertical)),
        ("heading_sigma_deg", format!("{:.3}", u.heading)),
        ("scale_sigma_percent", format!("{:.3}", u.scale * 100.0)),
    ]
    .iter()
    .map(|(name, value)| format!("<Data name=\"{name}\"><value>{}</value></Data>", escape(value)))
    .collect();
    let name = escape(&g.name);
    let lineage = escape(&g.lineage.join("\n"));
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><name>{name}</name>\
         <description>{banner}</description><Placemark><name>{name}</name><description>{banner}\n{lineage}</description>\
         <LookAt><longitude>{lon}</longitude><latitude>{lat}</latitude><altitude>{sea:.3}</altitude><heading>{heading}</heading>\
         <tilt>60</tilt><range>{range:.1}</range><altitudeMode>absolute</altitudeMode></LookAt>\
         <ExtendedData>{data}</ExtendedData><MultiGeometry>{polygons}</MultiGeometry></Placemark></Document></kml>\n",
        banner = escape(&g.banner),
        lon = o.longitude,
        lat = o.latitude,
        heading = g.placement.heading,
        range = 4.0 * g.size[0].hypot(g.size[1]).hypot(g.size[2]),
    )
}
