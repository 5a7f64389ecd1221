//! EE, efficiency and edge readiness: what a result costs, and whether others can read it.

use std::time::{Duration, Instant};

use orb_formats::spz::Axes;
use orb_formats::{glb, openflight, ply, spz, tiles3d, usdz};

use super::submission::Appearance;
use crate::splat::Camera;

/// What a format's rules say of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    Sound,
    /// The first thing that is wrong.
    Broken(String),
}

/// Whether a name is a model's: what is shipped, not what tells about it.
pub fn is_model(name: &str) -> bool {
    let ending = name.rsplit('.').next().unwrap_or_default();
    ["ply", "spz", "glb", "usdz", "flt", "kmz"].contains(&ending) && name != "network.ply"
}

/// Reads a file back by its format's rules; None for formats that are not checked.
pub fn finding(name: &str, bytes: &[u8]) -> Option<Finding> {
    let of = |e: Option<String>| Some(e.map_or(Finding::Sound, Finding::Broken));
    match name.rsplit('.').next().unwrap_or_default() {
        "ply" => of(ply::read(bytes).err().map(|e| e.to_string())),
        "spz" => of(spz::read(bytes, Axes::RUB).err().map(|e| e.to_string())),
        "glb" => of(glb::read(bytes).err().map(|e| e.to_string())),
        "usdz" => of(usdz::read(bytes).err().map(|e| e.to_string())),
        "flt" => of(openflight::check(bytes).into_iter().next()),
        "json" if name == "tileset.json" => of(tiles3d::read(bytes).err().map(|e| e.to_string())),
        _ => None,
    }
}

/// Pictures a second of 1920 × 1080, drawn one after the other on this machine's CPU for `long`, at least two, the first
/// left out. `camera` says from where.
pub fn pictures_a_second(appearance: Appearance, camera: &Camera, long: Duration) -> f64 {
    // As high, wider.
    let tall = camera.resized(1080 * camera.width / camera.height.max(1), 1080);
    let wide = Camera { width: 1920, cx: tall.cx + (1920.0 - tall.width as f32) / 2.0, ..tall };
    let draw = || match appearance {
        // What a viewer draws: colours alone.
        Appearance::Mesh(mesh, texture) => drop(crate::mesh::raster(mesh, Some(texture), &wide, [255; 3], 1)),
        Appearance::Splats(g) => drop(crate::splat::render(g, &wide, [1.0; 3])),
    };
    draw();
    let start = Instant::now();
    let mut count = 0u32;
    while count < 1 || start.elapsed() < long {
        draw();
        count += 1;
    }
    f64::from(count) / start.elapsed().as_secs_f64().max(1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn broken_files_are_found() {
        assert!(matches!(finding("a.glb", b"glTF"), Some(Finding::Broken(_))));
        assert!(matches!(finding("a.flt", &[0; 8]), Some(Finding::Broken(_))));
        assert_eq!(finding("notes.txt", b""), None);
        assert!(is_model("a.b.glb") && !is_model("preview.png") && !is_model("network.ply"));
    }
}
