//! `orb train` from the outside, on made places whose truth is known.

mod blocks;
mod poses;

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use crate::sets::{Bench, json};
use orb::geo::{Ecef, Geodetic, HeadingSource, Placement, convex_hull};
use orb_formats::cdb::geocell::Tile;
use orb_formats::cdb::names;
use orb_formats::{geotiff, glb, tiles3d};
use serde_json::Value;

fn predicate(folder: &Path) -> Value {
    use base64::Engine;
    let envelope = json(&folder.join("orb-record.dsse.json"));
    let payload = base64::engine::general_purpose::STANDARD.decode(envelope["payload"].as_str().unwrap()).unwrap();
    serde_json::from_slice::<Value>(&payload).unwrap()["predicate"].clone()
}

fn comments(ply: &Path) -> String {
    let bytes = std::fs::read(ply).unwrap();
    let end = bytes.windows(11).position(|w| w == b"end_header\n").unwrap();
    String::from_utf8_lossy(&bytes[..end]).into_owned()
}

const BRIEF: [&str; 8] =
    ["--iterations", "60", "--max-gaussians", "4000", "--device", "cpu", "--checkpoint-every", "20"];

#[test]
fn a_folder_of_photos_becomes_a_scene_at_its_place_on_the_earth() {
    let b = Bench::new("1", "12", "96", &["--site", "--moving", "--gps-noise", "0.2"]);
    let set = b.text("sets/00_site");
    let told: Value = serde_json::from_str(&b.good(
        &[&["train", &set, "-o", "out", "--json", "--exposure", "--format", "spz,tiles3d"], &BRIEF[..]].concat(),
    ))
    .unwrap();
    let out = b.at("out");
    for file in ["scene.ply", "scene.spz", "tiles3d/tileset.json", "preview.png", "orb-record.dsse.json"] {
        assert!(out.join(file).is_file(), "{file}");
    }
    assert_eq!((&told["held_out"]["photos"], &told["trained_on"]["photos"]), (&2.into(), &10.into()));
    assert!(told["trained_on"]["psnr_db"].as_f64().unwrap() > 12.0 && told["held_out"]["ssim"].as_f64().unwrap() > 0.1);
    assert!(told["held_out"]["psnr_fitted_db"].as_f64().is_some() && told["held_out"]["lpips"].is_null());
    assert!(told["gaussians"]["end"].as_u64().unwrap() <= 4000);
    assert_eq!(told["photos"].as_array().unwrap().len(), 12);
    // In metres, where the truth is; half a metre of GPS noise and a frame of whole photos.
    let truth = json(&b.at("sets/00_site/truth/cameras.json"));
    let g = &told["georeference"];
    let off = |name: &str, metres: f64| (g[name].as_f64().unwrap() - truth[name].as_f64().unwrap()) * metres;
    let apart = off("latitude", 111_200.0).hypot(off("longitude", 74_300.0));
    // The origin is what the photos look at, not the truth's own.
    let radius = truth["radius_m"].as_f64().unwrap();
    assert!(apart < 0.3 * radius && off("ellipsoidal_height_m", 1.0).abs() < 1.0, "{apart} {g}");
    let unit: f64 = told["world_to_unit"].as_str().unwrap().split_whitespace().nth(1).unwrap().parse().unwrap();
    let metres = g["metres_per_unit"].as_f64().unwrap() * unit;
    assert!((metres / truth["metres_per_world_unit"].as_f64().unwrap() - 1.0).abs() < 0.03, "{metres}");
    let head = comments(&out.join("scene.ply"));
    assert!(head.contains("origin WGS84 latitude 48.1") && head.contains("georegistration"), "{head}");

    let p = predicate(&out);
    assert_eq!(p["event"]["type"], "scene.train");
    // Twelve photos, twelve masks, three files of poses.
    let roles = |role: &str| p["inputs"].as_array().unwrap().iter().filter(|i| i["role"] == role).count();
    assert_eq!((roles("photo"), roles("mask"), roles("poses")), (12, 12, 3));
    let said = |name: &str| p["params"][name].clone();
    assert_eq!(
        (said("strategy"), said("exposure_compensated"), said("iterations_run")),
        ("default".into(), true.into(), 60.into())
    );
    assert!(said("unit_to_enu").as_str().unwrap().contains("about 48.") && said("held_out_psnr_db").is_string());
    b.good(&["audit", "verify", "out"]);
}

/// Value of a raster at a latitude and longitude, as GDAL finds it; `None` where GDAL is not installed.
fn gdal_value(file: &Path, latitude: f64, longitude: f64) -> Option<Vec<f64>> {
    let place = [longitude.to_string(), latitude.to_string()];
    let run = Command::new("gdallocationinfo").args(["-valonly", "-wgs84"]).arg(file).args(place).output();
    let Ok(done) = run else {
        assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "cannot run: gdallocationinfo is not installed");
        eprintln!("skipped: gdallocationinfo is not installed");
        return None;
    };
    let text = String::from_utf8_lossy(&done.stdout).into_owned();
    Some(text.split_whitespace().map(|v| v.parse().unwrap()).collect())
}

#[test]
fn a_scene_becomes_a_store_of_terrain_imagery_and_models() {
    let b = Bench::new("1", "24", "96", &["--site", "--gps-noise", "0.2"]);
    let set = b.text("sets/00_site");
    let run =
        ["--iterations", "400", "--max-gaussians", "12000", "--device", "cpu", "--format", "cdb", "--models", "1"];
    let told: Value =
        serde_json::from_str(&b.good(&[&["train", &set, "-o", "out", "--json"], &run[..]].concat())).unwrap();
    let store = b.at("out/scene.cdb");
    let check = b.good(&["cdb", "check", &b.text("out/scene.cdb")]);
    assert!(check.contains("pass 13") && check.contains("pass  6") && !check.contains("FAIL"), "{check}");
    let said = &told["store"];
    assert_eq!(said["models"], 1, "{said}");
    let lod = |name: &str| said[name].as_i64().unwrap() as i8;
    let truth = json(&b.at("sets/00_site/truth/cameras.json"));
    let of = |name: &str| truth[name].as_f64().unwrap();
    // Around what stands in the middle; single places may lie on something else.
    let mut colored = 0;
    for k in 0..8 {
        let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 8.0).sin_cos();
        let (latitude, longitude) = (of("latitude") + 14.0 * cos / 111_200.0, of("longitude") + 14.0 * sin / 74_300.0);
        let value = |dataset, lod, extension| {
            let tile = Tile::containing(latitude, longitude, lod).unwrap();
            gdal_value(&store.join(names::path(tile, dataset, (1, 1), extension)), latitude, longitude)
        };
        if let Some(height) = value(names::ELEVATION, lod("terrain_lod"), "tif") {
            assert!((height[0] - of("ellipsoidal_height_m")).abs() < 1.2, "place {k}: {height:?}");
        }
        // Grass and earth: no blue, and not the grey of what is not known.
        let color = value(names::IMAGERY, lod("imagery_lod"), "jp2").unwrap_or(vec![0.0, 99.0, 0.0]);
        assert_eq!(color.len(), 3);
        colored += u32::from(color[2] < color[1] - 8.0);
    }
    assert!(colored >= 5, "{colored} of 8");
    // Far away the terrain is what is said to be invented.
    let (latitude, longitude) = (of("latitude").floor() + 0.9, of("longitude").floor() + 0.2);
    let coarse = names::path(Tile::containing(latitude, longitude, 0).unwrap(), names::ELEVATION, (1, 1), "tif");
    if let Some(around) = gdal_value(&store.join(coarse), latitude, longitude) {
        assert!((around[0] - said["around_ellipsoidal_height_m"].as_f64().unwrap()).abs() < 1e-3, "{around:?}");
    }
    let p = predicate(&b.at("out"));
    assert_eq!(
        (p["params"]["models"].clone(), p["params"]["terrain_lod"].clone()),
        (1.into(), said["terrain_lod"].clone())
    );
    b.good(&["audit", "verify", "out"]);
}

/// Of each tile of a level: triangles as the bits of their corners, and in metres from the truth's origin, Z up.
struct Drawn {
    corners: Vec<[[u32; 3]; 3]>,
    places: Vec<[[f64; 3]; 3]>,
}

fn drawn(folder: &Path, level: usize, transform: [f64; 16], truth: &Value) -> Vec<Drawn> {
    let of = |name: &str| truth[name].as_f64().unwrap();
    let origin = Geodetic { latitude: of("latitude"), longitude: of("longitude"), height: of("ellipsoidal_height_m") };
    let frame = origin.frame();
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|f| f.unwrap().path()).collect();
    files.retain(|f| f.file_name().unwrap().to_string_lossy().starts_with(&format!("l{level}_")));
    files.sort();
    let one = |file: &std::path::PathBuf| {
        let mesh = glb::read(&std::fs::read(file).unwrap()).unwrap().parts.remove(0).mesh;
        let place = |v: u32| {
            let p = mesh.positions[v as usize];
            let [x, y, z] =
                [0, 1, 2].map(|i| (0..3).map(|k| transform[4 * k + i] * p[k]).sum::<f64>() + transform[12 + i]);
            let enu = frame.to_enu(Ecef { x, y, z });
            [enu.east, enu.north, enu.up]
        };
        let bits = |v: u32| mesh.positions[v as usize].map(|c| (c as f32).to_bits());
        Drawn {
            corners: mesh.triangles.iter().map(|t| t.map(bits)).collect(),
            places: mesh.triangles.iter().map(|t| t.map(place)).collect(),
        }
    };
    files.iter().map(one).collect()
}

#[test]
fn a_scene_becomes_meshes_in_tiles_that_meet_to_the_bit() {
    let b = Bench::new("1", "24", "96", &["--site", "--gps-noise", "0"]);
    let set = b.text("sets/00_site");
    let run = ["--iterations", "400", "--max-gaussians", "12000", "--device", "cpu", "--format", "tiles3d"];
    let told: Value = serde_json::from_str(&b.good(
        &[&["train", &set, "-o", "out", "--json", "--tiles", "splats,mesh", "--mesh-sample", "0.2"], &run[..]].concat(),
    ))
    .unwrap();
    let folder = b.at("out/tiles3d-mesh");
    assert!(b.at("out/tiles3d/tileset.json").is_file());
    let tileset = tiles3d::read(&std::fs::read(folder.join("tileset.json")).unwrap()).unwrap();
    let said = told["meshes"]["levels"].as_array().unwrap();
    assert!(said.len() >= 2 && said[0]["tiles"].as_u64().unwrap() >= 4, "{said:?}");
    // Errors shrink towards the leaves, which have none; a volume holds those below.
    fn tree(tile: &tiles3d::Tile, out: &mut usize) {
        *out += 1;
        assert_eq!(tile.children.is_empty(), tile.geometric_error == 0.0);
        for c in &tile.children {
            assert!(c.geometric_error < tile.geometric_error);
            for i in 0..3 {
                let half = |t: &tiles3d::Tile| t.volume.half_axes[i][i];
                assert!((c.volume.center[i] - tile.volume.center[i]).abs() <= half(tile) - half(c) + 0.1);
            }
            tree(c, out);
        }
    }
    let mut tiles = 0;
    tree(&tileset.root, &mut tiles);
    assert_eq!(tiles as u64, said.iter().map(|l| l["tiles"].as_u64().unwrap()).sum::<u64>());

    let truth = json(&b.at("sets/00_site/truth/cameras.json"));
    for level in 0..said.len() {
        let all = drawn(&folder, level, tileset.root.transform.unwrap(), &truth);
        let mut edges: BTreeMap<[[u32; 3]; 2], (usize, [f64; 2])> = BTreeMap::new();
        for (bits, place) in all.iter().flat_map(|t| t.corners.iter().zip(&t.places)) {
            for k in 0..3 {
                let (a, b) = (bits[k], bits[(k + 1) % 3]);
                let at = [0, 1].map(|i| (place[k][i] + place[(k + 1) % 3][i]) / 2.0);
                edges.entry([a.min(b), a.max(b)]).or_insert((0, at)).0 += 1;
            }
        }
        assert!(edges.values().all(|e| e.0 <= 2));
        let hull = convex_hull(edges.values().map(|e| e.1).collect());
        let depth = |p: [f64; 2]| {
            let sides = hull.iter().zip(hull.iter().cycle().skip(1));
            sides
                .map(|(a, b)| {
                    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
                    ((p[1] - a[1]) * dx - (p[0] - a[0]) * dy) / dx.hypot(dy)
                })
                .fold(f64::INFINITY, f64::min)
        };
        let open: Vec<f64> = edges.values().filter(|e| e.0 == 1).map(|e| depth(e.1)).collect();
        let deepest = open.iter().copied().fold(0.0, f64::max);
        assert!(open.len() > 10 && deepest < 1.0, "level {level}: an open edge {deepest} m inside the rim");
        // Open ground lies where the truth has it: at its origin's height.
        let (mut squares, mut area) = (0.0, 0.0);
        for t in all.iter().flat_map(|t| &t.places) {
            let d = |k: usize| [0, 1, 2].map(|i| t[k][i] - t[0][i]);
            let (e, f) = (d(1), d(2));
            let upward = e[0] * f[1] - e[1] * f[0];
            let (x, y) = (e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2]);
            let up = (t[0][2] + t[1][2] + t[2][2]) / 3.0;
            if upward > 0.8 * x.hypot(y).hypot(upward) && up.abs() < 1.5 && t[0][0].hypot(t[0][1]) < 28.0 {
                (squares, area) = (squares + upward * up * up, area + upward);
            }
        }
        let off = (squares / area).sqrt();
        assert!(area / 2.0 > 1000.0 && off < 0.45, "level {level}: {off} m over {} m²", area / 2.0);
    }
    // The Khronos validator, where it is installed: npm's gltf-validator on NODE_PATH.
    if std::env::var_os("NODE_PATH").is_some() {
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/clients/gltf_validate.cjs");
        let files = std::fs::read_dir(&folder).unwrap().map(|f| f.unwrap().path());
        let files = files.filter(|f| f.extension().is_some_and(|e| e == "glb"));
        let read = Command::new("node").arg(script).args(files).output().unwrap();
        let words = String::from_utf8_lossy(&read.stdout).into_owned();
        let clean = words.matches("errors 0 warnings 0 infos 0 hints 0").count();
        assert!(read.status.success() && clean == tiles, "{words}{}", String::from_utf8_lossy(&read.stderr));
    } else {
        assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "cannot run: NODE_PATH is not set");
        eprintln!("skipped: gltf-validator, as NODE_PATH is not set");
    }
    assert!(predicate(&b.at("out"))["params"]["mesh_triangles"].as_u64().unwrap() > 500);
    b.good(&["audit", "verify", "out"]);
}

/// Control points on the ground of a made site.
fn control(b: &Bench, set: &str) -> String {
    let truth = json(&b.at(set).join("truth/cameras.json"));
    let of = |v: &Value, name: &str| v[name].as_f64().unwrap();
    let placement = Placement {
        origin: Geodetic {
            latitude: of(&truth, "latitude"),
            longitude: of(&truth, "longitude"),
            height: of(&truth, "ellipsoidal_height_m"),
        },
        heading: of(&truth, "heading_deg"),
        heading_source: HeadingSource::Given,
    };
    let mut lines = vec!["point,latitude,longitude,height,photo,x,y".to_owned()];
    for (i, p) in [[12.0, 0.0], [-9.0, 11.0], [-8.0, -12.0], [7.0, 9.0], [0.0, -14.0]].into_iter().enumerate() {
        let p = [p[0], p[1], 0.0];
        let g = placement.to_geodetic(p);
        for view in truth["views"].as_array().unwrap() {
            let c = &view["camera"];
            let q: Vec<f64> = (0..3)
                .map(|r| (0..3).map(|k| c["w2c_opencv"][r][k].as_f64().unwrap() * p[k]).sum::<f64>())
                .zip(0..)
                .map(|(v, r): (f64, usize)| v + c["w2c_opencv"][r][3].as_f64().unwrap())
                .collect();
            let (x, y) = (of(c, "fx") * q[0] / q[2] + of(c, "cx"), of(c, "fy") * q[1] / q[2] + of(c, "cy"));
            if q[2] > 0.0 && (0.0..of(c, "width")).contains(&x) && (0.0..of(c, "height")).contains(&y) {
                let name = Path::new(c["file"].as_str().unwrap()).file_name().unwrap().to_string_lossy().into_owned();
                let [latitude, longitude, height] = [g.latitude, g.longitude, g.height];
                lines.push(format!("P{i},{latitude:.9},{longitude:.9},{height:.4},{name},{x:.2},{y:.2}"));
            }
        }
    }
    std::fs::write(b.at("control.csv"), lines.join("\n")).unwrap();
    b.text("control.csv")
}

#[test]
fn a_scene_in_blocks_with_control_points_goes_into_a_store_that_is_there() {
    let b = Bench::new("1", "16", "96", &["--site", "--gps-noise", "5"]);
    let (set, gcp) = (b.text("sets/00_site"), control(&b, "sets/00_site"));
    // A store with a house in the same geocell.
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/truth/play_house/mesh.glb");
    let place = ["--origin", "48.1371,11.5835,565", "--format", "cdb", "-o", "first"];
    b.good(&[&["export", model.to_str().unwrap()], &place[..]].concat());
    let store = b.text("store.cdb");
    std::fs::rename(b.at("first/mesh.cdb"), &store).unwrap();
    let list = || -> Vec<std::path::PathBuf> {
        let (mut open, mut all) = (vec![b.at("store.cdb")], Vec::new());
        while let Some(folder) = open.pop() {
            for entry in std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
                if entry.is_dir() { open.push(entry) } else { all.push(entry) }
            }
        }
        all.sort();
        all
    };
    let before = list();
    let version = std::fs::read(b.at("store.cdb/Metadata/Version.xml")).unwrap();
    let train = [
        &["train", &set, "--blocks", "2", "--parts", "parts", "--gcp", &gcp, "--format", "cdb", "--models", "2"],
        &["--iterations", "200", "--max-gaussians", "8000", "--device", "cpu"][..],
    ]
    .concat();
    let plan = b.good(&[&train[..], &["--plan"]].concat());
    assert!(plan.contains("CDB store with up to 2 models"), "{plan}");
    assert!(b.refused(&["train", &set, "--cdb", &store]).contains("--format cdb"));
    let nowhere = b.orb(&[&train[..], &["--cdb", &b.text("nowhere.cdb")]].concat());
    assert!(!nowhere.status.success() && String::from_utf8_lossy(&nowhere.stderr).contains("nowhere.cdb"));
    assert!(!b.at("parts").exists(), "refused before training");
    let told: Value =
        serde_json::from_str(&b.good(&[&train[..], &["-o", "out", "--json", "--cdb", &store]].concat())).unwrap();
    assert!(!b.at("out/scene.cdb").exists() && told["store"]["place"].as_str().unwrap().ends_with("store.cdb"));
    let check = b.good(&["cdb", "check", &store]);
    assert!(check.contains("pass 13") && !check.contains("FAIL"), "{check}");
    let after = list();
    assert!(before.iter().all(|f| after.contains(f)) && after.len() > before.len() + 20, "{} files", after.len());
    assert_eq!(std::fs::read(b.at("store.cdb/Metadata/Version.xml")).unwrap(), version);
    // The control points were taken: the photos' GPS alone says no more than a metre and a half.
    assert!(told["georeference"]["horizontal_sigma_m"].as_f64().unwrap() < 0.3, "{}", told["georeference"]);
    let truth = json(&b.at("sets/00_site/truth/cameras.json"));
    let of = |name: &str| truth[name].as_f64().unwrap();
    let lod = told["store"]["terrain_lod"].as_i64().unwrap() as i8;
    let (latitude, longitude) = (of("latitude") + 14.0 / 111_200.0, of("longitude"));
    let tile = Tile::containing(latitude, longitude, lod).unwrap();
    let file = b.at("store.cdb").join(names::path(tile, names::ELEVATION, (1, 1), "tif"));
    if let Some(height) = gdal_value(&file, latitude, longitude) {
        assert!((height[0] - of("ellipsoidal_height_m")).abs() < 1.5, "{height:?}");
    }
    b.good(&["audit", "verify", "out"]);
    // The same scene once more, from its parts, as a store of its own, in terrain that is known: a plane five metres below it.
    let plane = |latitude: f64, longitude: f64| {
        of("ellipsoidal_height_m") - 5.0 + 200.0 * (latitude - of("latitude")) + 100.0 * (longitude - of("longitude"))
    };
    let terrain = |name: &str, off: f64| {
        let (side, step) = (200u32, 1e-4);
        let (west, north) = (of("longitude") - 0.01, of("latitude") + 0.01 + off);
        let grid = geotiff::Grid { west, north, step_x: step, step_y: step, posts: false };
        let middle = |k: u32| (f64::from(k) + 0.5) * step;
        let heights: Vec<f32> =
            (0..side * side).map(|i| plane(north - middle(i / side), west + middle(i % side)) as f32).collect();
        std::fs::write(b.at(name), geotiff::write(side, side, &heights, &grid, "").unwrap()).unwrap();
        b.text(name)
    };
    let run = |file: String| {
        let more = ["-o", "own", "--json", "--ground-dem", &file, "--ground-dem-datum", "ellipsoid"];
        b.orb(&[&train[..], &more].concat())
    };
    let far = run(terrain("far.tif", 1.0));
    let said = String::from_utf8_lossy(&far.stderr).into_owned();
    assert!(far.status.code() == Some(2) && said.contains("far.tif") && said.contains("--ground-dem"), "{said}");
    let done = run(terrain("hills.tif", 0.0));
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let told: Value = serde_json::from_slice(&done.stdout).unwrap();
    assert!(!b.good(&["cdb", "check", &b.text("own/scene.cdb")]).contains("FAIL"));
    let above = &told["store"]["around"];
    assert!(
        (above["ground_above_it_m"].as_f64().unwrap() - 5.0).abs() < 1.5 && above["file"] == "hills.tif",
        "{above}"
    );
    let p = predicate(&b.at("own"));
    assert!(p["inputs"].as_array().unwrap().iter().any(|i| i["role"] == "terrain" && i["name"] == "hills.tif"));
    assert_eq!(p["params"]["terrain_around_from"], "hills.tif");
    let (latitude, longitude) = (of("latitude") + 0.006, of("longitude") + 0.006);
    let coarse = names::path(Tile::containing(latitude, longitude, 0).unwrap(), names::ELEVATION, (1, 1), "tif");
    if let Some(height) = gdal_value(&b.at("own/scene.cdb").join(coarse), latitude, longitude) {
        // A post is 108 m from the next.
        assert!((height[0] - plane(latitude, longitude)).abs() < 0.3, "{height:?}");
    }
}

#[test]
fn the_table_is_printed_runs_go_on_and_options_are_judged() {
    let b = Bench::new("1", "10", "64", &["--nerf"]);
    let set = b.text("sets/00_container_nerf");
    let args = |out: &'static str, more: &[&'static str]| -> Vec<String> {
        let words = ["train", &set, "-o", out, "--init-points", "500", "--strategy", "mcmc"];
        words.iter().chain(&BRIEF).chain(more).map(|w| (*w).to_owned()).collect()
    };
    let run = |a: &[String]| b.good(&a.iter().map(String::as_str).collect::<Vec<_>>());
    let text = run(&args("whole", &[]));
    let row = text.lines().find(|l| l.starts_with("held out")).unwrap();
    assert!(text.contains("PSNR dB") && row.split_whitespace().nth(2) == Some("2"), "{text}");
    assert!(text.contains("random places") && !b.at("whole/masks").exists());
    let head = comments(&b.at("whole/scene.ply"));
    assert!(head.contains("not placed") && head.contains("from the poses' world"), "{head}");
    // Taken up from a file of the same run, the result is the same.
    run(&args("kept", &["--checkpoint", "run.ckpt"]));
    run(&args("again", &["--resume", "run.ckpt"]));
    let bytes = |out: &str| std::fs::read(b.at(out).join("scene.ply")).unwrap();
    assert!(bytes("whole") == bytes("kept") && bytes("whole") == bytes("again"));
    // All photos are trained on where none is to be held out, but for the layout's own.
    let empty = b.text("empty");
    std::fs::create_dir(&empty).unwrap();
    assert!(b.refused(&["train", &empty]).contains("transforms_train.json"));
    assert!(b.refused(&["train", &set, "--background", "green"]).contains("random"));
    assert!(b.refused(&["train", &set, "--masks", &empty]).contains("masks by the photos' names"));
    assert!(b.refused(&["train", &set, "--format", "tiles3d"]).contains("place on the Earth"));
    assert!(b.refused(&["train", &set, "--format", "spz,cdb"]).contains("--format cdb"));
    assert!(b.refused(&["train", &set, "--mesh-sample", "0"]).contains("metres"));
    assert!(b.refused(&["train", "nowhere"]).contains("nowhere"));
    assert!(!b.at("00_container_nerf_scene").exists());
}
