//! OGC GeoPose 1.0 (21-056r11), Basic-Quaternion: where the model's frame lies and how it is turned.

use super::{Georeference, deviations, pretty};

/// The inner frame is the model's (x to its right, y ahead, z up), the outer one east, north, up at the position. A
/// heading turns clockwise seen from above, hence about the up axis by its negative: q = (0, 0, sin(−h/2), cos(h/2)).
pub(super) fn write(g: &Georeference) -> String {
    let half = (g.placement.heading / 2.0).to_radians();
    // q and −q are one rotation; w is kept positive.
    let sign = if half.cos() < 0.0 { -1.0 } else { 1.0 };
    let o = &g.placement.origin;
    pretty(&serde_json::json!({
        "position": {"lat": o.latitude, "lon": o.longitude, "h": o.height},
        "quaternion": {"x": 0.0, "y": 0.0, "z": 0.0 - sign * half.sin(), "w": sign * half.cos()},
        "uncertainty": deviations(&g.uncertainty),
        "marking": g.banner,
    }))
}
