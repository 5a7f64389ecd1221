//! The footprint as GeoJSON (RFC 7946).

use super::{Georeference, bounds, deviations, geometry, pretty, rounded};

pub(super) fn write(g: &Georeference) -> String {
    let o = &g.placement.origin;
    let (corner_horizontal, _) = g.uncertainty.at(g.size[0].hypot(g.size[1]) / 2.0, 0.0);
    pretty(&serde_json::json!({
        "type": "FeatureCollection",
        "bbox": bounds(&g.footprint),
        "features": [{
            "type": "Feature",
            "geometry": geometry(&g.footprint),
            "properties": {
                "name": g.name,
                "marking": g.banner,
                "made": g.utc,
                "latitude": o.latitude,
                "longitude": o.longitude,
                "ellipsoidal_height_m": o.height,
                "heading_deg": g.placement.heading,
                "width_m": rounded(g.size[0], 3),
                "depth_m": rounded(g.size[1], 3),
                "height_m": rounded(g.size[2], 3),
                "area_m2": rounded(g.footprint.area, 3),
                "perimeter_m": rounded(g.footprint.perimeter, 3),
                "corner_sigma_m": rounded(corner_horizontal, 4),
                "uncertainty": deviations(&g.uncertainty),
            },
        }],
    }))
}
