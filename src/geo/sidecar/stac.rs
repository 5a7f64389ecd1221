//! A catalogue entry: STAC item 1.0.0.

use serde_json::{Map, Value, json};

use super::{Asset, Georeference, bounds, deviations, geometry, pretty};

/// `beside` are the other sidecars.
pub(super) fn write(g: &Georeference, beside: &[Asset]) -> String {
    let mut assets = Map::new();
    for asset in g.assets.iter().chain(beside) {
        let role = match asset.role.as_str() {
            "preview" => "overview",
            "metadata" => "metadata",
            _ => "data",
        };
        let value = json!({"href": format!("./{}", asset.path), "type": asset.media_type, "roles": [role]});
        assets.insert(asset.path.clone(), value);
    }
    let o = &g.placement.origin;
    let item: Value = json!({
        "type": "Feature",
        "stac_version": "1.0.0",
        "stac_extensions": [],
        "id": g.name,
        "geometry": geometry(&g.footprint),
        "bbox": bounds(&g.footprint),
        "properties": {
            "datetime": g.utc,
            "created": g.utc,
            "title": g.name,
            "description": g.lineage.join(" "),
            "orb:marking": g.banner,
            "orb:ellipsoidal_height_m": o.height,
            "orb:heading_deg": g.placement.heading,
            "orb:uncertainty": deviations(&g.uncertainty),
        },
        "links": [],
        "assets": assets,
    });
    pretty(&item)
}
