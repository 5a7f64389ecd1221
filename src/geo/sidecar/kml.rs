//! The footprint for Google Earth and its like: OGC KML 2.3 (12-007r2).
//!
//! As a file of its own a footprint raised to the model's height; as the document of a KMZ the model itself, in COLLADA.

use orb_formats::xml::escape;

use super::super::geoid::undulation;
use super::Georeference;

/// The footprint's solid.
pub(super) fn write(g: &Georeference) -> String {
    let top = above_sea(g) + g.size[2];
    let polygon = |ring: &Vec<[f64; 2]>| {
        let corners: Vec<String> = ring.iter().map(|[x, y]| format!("{x},{y},{top:.3}")).collect();
        format!(
            "<Polygon><extrude>1</extrude><altitudeMode>absolute</altitudeMode><outerBoundaryIs><LinearRing><coordinates>{}\
             </coordinates></LinearRing></outerBoundaryIs></Polygon>",
            corners.join(" ")
        )
    };
    let polygons: String = g.footprint.rings().iter().map(polygon).collect();
    document(g, &format!("<MultiGeometry>{polygons}</MultiGeometry>"))
}

/// The model that lies at `path` in the KMZ, its frame that of the subject: KML turns a model's +Y to the heading.
pub(super) fn with_model(g: &Georeference, path: &str) -> String {
    let o = &g.placement.origin;
    let model = format!(
        "<Model><altitudeMode>absolute</altitudeMode><Location><longitude>{}</longitude><latitude>{}</latitude>\
         <altitude>{:.6}</altitude></Location><Orientation><heading>{}</heading><tilt>0</tilt><roll>0</roll></Orientation>\
         <Scale><x>1</x><y>1</y><z>1</z></Scale><Link><href>{}</href></Link></Model>",
        o.longitude,
        o.latitude,
        above_sea(g),
        g.placement.heading,
        escape(path)
    );
    document(g, &model)
}

/// Absolute altitudes of KML are above the EGM96 geoid.
fn above_sea(g: &Georeference) -> f64 {
    let o = &g.placement.origin;
    o.height - undulation(o.latitude, o.longitude)
}

fn document(g: &Georeference, geometry: &str) -> String {
    let (o, sea) = (&g.placement.origin, above_sea(g));
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
         <ExtendedData>{data}</ExtendedData>{geometry}</Placemark></Document></kml>\n",
        banner = escape(&g.banner),
        lon = o.longitude,
        lat = o.latitude,
        heading = g.placement.heading,
        range = 4.0 * g.size[0].hypot(g.size[1]).hypot(g.size[2]),
    )
}
