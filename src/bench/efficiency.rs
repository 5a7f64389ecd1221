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

/// Reads a file back by its format's rules; None for formats that are not checked, and for what a format has and its reader
/// does not read.
pub fn finding(name: &str, bytes: &[u8]) -> Option<Finding> {
    match name.rsplit('.').next().unwrap_or_default() {
        "ply" => of_reader(ply::read(bytes)),
        "spz" => of_reader(spz::read(bytes, Axes::RUB)),
        "glb" => of_reader(glb::read(bytes)),
        "usdz" => of_reader(usdz::read(bytes)),
        "flt" => Some(openflight::check(bytes).into_iter().next().map_or(Finding::Sound, Finding::Broken)),
        "json" if name == "tileset.json" => of_reader(tiles3d::read(bytes)),
        _ => None,
    }
}

fn of_reader<T>(read: orb_formats::Result<T>) -> Option<Finding> {
    match read {
        Ok(_) => Some(Finding::Sound),
        // The reader's limit says nothing against the file.
        Err(orb_formats::Error::Unsupported { .. }) => None,
        Err(e) => Some(Finding::Broken(e.to_string())),
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

    #[test]
    fn what_a_reader_does_not_read_is_not_broken() {
        let mesh = orb_formats::Mesh {
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            normals: vec![[0.0, 0.0, 1.0]; 3],
            uvs: vec![[0.0; 2]; 3],
            triangles: vec![[0, 1, 2]],
        };
        let parts = vec![orb_formats::asset::Part { mesh, material: None }];
        let mut bytes = usdz::write(&orb_formats::Asset { parts, ..Default::default() }).unwrap();
        assert_eq!(finding("a.usdz", &bytes), Some(Finding::Sound));
        assert!(matches!(finding("a.usdz", &bytes[..bytes.len() / 2]), Some(Finding::Broken(_))));
        // A root layer of text, by its name in the header and the directory.
        let name = b"model.usdc";
        let at: Vec<usize> = (0..bytes.len()).filter(|i| bytes[*i..].starts_with(name)).collect();
        assert_eq!(at.len(), 2);
        at.into_iter().for_each(|i| bytes[i + name.len() - 1] = b'a');
        assert_eq!(finding("a.usdz", &bytes), None);
    }
}
