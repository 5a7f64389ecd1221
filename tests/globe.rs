//! 3D Tiles on CesiumJS' globe, in a browser without a screen and without network: at the right place, the right way round.
//!
//! `ORB_DRAWN_PICTURES=DIR` keeps what was compared, side by side.

use std::path::{Path, PathBuf};
use std::process::Command;

use glam::{Vec2, Vec3};
use image::{Rgb, RgbImage};
use orb::mesh::{Mesh, raster};
use orb::splat::Camera;
use orb_formats::{glb, tiles3d};

const PLACE: (f64, f64, f64) = (43.6532, -79.3832, 76.0);
const HEADING: f64 = 130.0;
/// Share of the silhouettes' union that both cover, at least. Cesium's picture is smoothed.
const LEAST_OVERLAP: f64 = 0.9;

/// The folder of a package below one of NODE_PATH's.
fn has_package(name: &str) -> bool {
    let folders = std::env::var_os("NODE_PATH").unwrap_or_default();
    std::env::split_paths(&folders).any(|f| f.join(name).join("package.json").is_file())
}

/// What the tile's finest content looks like from where `cesium_check.cjs` puts its camera: it looks to the bearing of 30°,
/// 25° downwards, from three radii away, 60° from rim to rim.
fn silhouette(folder: &Path, radius: f64, heading: f64) -> Vec<bool> {
    let tileset = tiles3d::read(&std::fs::read(folder.join("tileset.json")).unwrap()).unwrap();
    let asset = glb::read(&std::fs::read(folder.join("lod0.glb")).unwrap()).unwrap();
    let (sin, cos) = heading.to_radians().sin_cos();
    let turn = |[x, y, z]: [f64; 3]| Vec3::new((x * cos + y * sin) as f32, (y * cos - x * sin) as f32, z as f32);
    let part = &asset.parts[0].mesh;
    let mesh = Mesh {
        positions: part.positions.iter().map(|p| turn(*p)).collect(),
        normals: part.normals.iter().map(|n| turn(n.map(f64::from))).collect(),
        uvs: part.uvs.iter().map(|t| Vec2::from_array(*t)).collect(),
        triangles: part.triangles.clone(),
    };
    let (bearing, pitch) = (30f64.to_radians(), 25f64.to_radians());
    let back =
        [-pitch.cos() * bearing.sin(), -pitch.cos() * bearing.cos(), pitch.sin()].map(|c| (3.0 * radius * c) as f32);
    let centre = turn(tileset.root.volume.center);
    let square = Camera::look_at(centre + Vec3::from_array(back), centre, 60f32.to_radians(), 640);
    let camera = Camera { height: 480, cy: 240.0, ..square };
    raster::visibility(&mesh.positions, &mesh.triangles, &camera).triangle.iter().map(|t| *t != u32::MAX).collect()
}

#[test]
fn cesium_shows_the_model_at_its_place() {
    if !(has_package("cesium") && has_package("puppeteer-core") && Path::new("/usr/bin/chromium").exists()) {
        let required = std::env::var_os("ORB_REQUIRE_CLIENTS").is_some();
        assert!(!required, "npm's cesium and puppeteer-core on NODE_PATH, and Chromium, are required");
        return eprintln!("skipped: npm's cesium and puppeteer-core on NODE_PATH, or Chromium, are missing");
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let made = Command::new(env!("CARGO_BIN_EXE_orb"))
        .args(["export", root.join("samples/truth/play_house/mesh.glb").to_str().unwrap(), "--lods", "2"])
        .args(["--origin", &format!("{},{},{}", PLACE.0, PLACE.1, PLACE.2), "--heading", &HEADING.to_string()])
        .args(["--format", "tiles3d", "-o", out.to_str().unwrap()])
        .env("ORB_DATA_DIR", dir.path().join("data"))
        .output()
        .unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let (tiles, shot) = (out.join("tiles3d"), dir.path().join("globe.png"));
    let seen = Command::new("node")
        .arg(root.join("tests/clients/cesium_check.cjs"))
        .args([&tiles.join("tileset.json"), &shot])
        .output()
        .unwrap();
    let said = format!("{}{}", String::from_utf8_lossy(&seen.stdout), String::from_utf8_lossy(&seen.stderr));
    assert!(seen.status.success(), "{said}");
    let value: serde_json::Value = serde_json::from_str(said.lines().last().unwrap()).unwrap();
    assert_eq!((&value["loaded"], &value["picked"]), (&true.into(), &true.into()), "{said}");
    // Its middle stands over the place: a tenth of a metre is 1e-6 degrees.
    let number = |i: usize| value["center"][i].as_f64().unwrap();
    assert!((number(0) - PLACE.0).abs() < 5e-6 && (number(1) - PLACE.1).abs() < 5e-6, "{said}");
    assert!((0.5..5.0).contains(&(number(2) - PLACE.2)), "{said}");

    let picture = image::open(&shot).unwrap().to_rgb8();
    let bare = *picture.get_pixel(600, 20);
    // The words at the foot of the page are not the model's.
    let inside = |i: usize| i / 640 < 440;
    let drawn: Vec<bool> = picture.pixels().map(|p| p.0.iter().zip(bare.0).any(|(a, b)| a.abs_diff(b) > 14)).collect();
    let overlap = |ours: &[bool]| {
        let count = |f: fn(bool, bool) -> bool| (0..drawn.len()).filter(|&i| inside(i) && f(drawn[i], ours[i])).count();
        count(|a, b| a && b) as f64 / count(|a, b| a || b).max(1) as f64
    };
    let ours = silhouette(&tiles, value["radius"].as_f64().unwrap(), HEADING);
    if let Some(folder) = std::env::var_os("ORB_DRAWN_PICTURES").map(PathBuf::from) {
        std::fs::create_dir_all(&folder).unwrap();
        let sheet = RgbImage::from_fn(1280, 480, |x, y| match x.checked_sub(640) {
            None => *picture.get_pixel(x, y),
            Some(x) => Rgb([if ours[(y * 640 + x) as usize] { 200 } else { 20 }; 3]),
        });
        sheet.save(folder.join("globe.png")).unwrap();
    }
    let right = overlap(&ours);
    println!("overlap {right}");
    assert!(right >= LEAST_OVERLAP, "the silhouettes share {right}");
    // Turned another way it is another shape.
    for wrong in [0.0, HEADING + 180.0, -HEADING, HEADING + 20.0] {
        let shared = overlap(&silhouette(&tiles, value["radius"].as_f64().unwrap(), wrong));
        assert!(shared < LEAST_OVERLAP - 0.1, "a heading of {wrong} passes: {shared}");
    }
}
