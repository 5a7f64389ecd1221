//! `orb train` from the outside, on made places whose truth is known.

mod sets;

use std::path::Path;
use std::process::Command;

use orb_formats::cdb::geocell::Tile;
use orb_formats::cdb::names;
use serde_json::Value;
use sets::{Bench, json};

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
    assert!(b.refused(&["train", "nowhere"]).contains("nowhere"));
    assert!(!b.at("00_container_nerf_scene").exists());
}

#[test]
fn a_plan_is_said_and_blocks_of_several_runs_are_put_together() {
    let b = Bench::new("1", "12", "96", &["--site"]);
    let set = b.text("sets/00_site");
    let train =
        |more: &[&str]| b.good(&[&["train", &set, "--blocks", "2", "--parts", "parts"], &BRIEF[..6], more].concat());
    let plan = train(&["--plan"]);
    assert!(plan.contains("12 photos") && plan.contains("memory") && plan.contains("2 blocks"), "{plan}");
    assert_eq!(train(&["--block", "2", "-o", "none"]), "");
    assert!(b.at("parts/coarse/gaussians.part").is_file() && b.at("parts/block_002/gaussians.part").is_file());
    assert!(!b.at("parts/block_001").exists() && !b.at("none").exists());
    let told: Value = serde_json::from_str(&train(&["-o", "out", "--json", "--split-ground"])).unwrap();
    assert_eq!((&told["iterations"], &told["held_out"]["photos"]), (&180.into(), &2.into()));
    let count = |file: &str| -> u64 {
        let head = comments(&b.at("out").join(file));
        head.lines().find_map(|l| l.strip_prefix("element vertex ")).unwrap().trim().parse().unwrap()
    };
    // Together all but the sky.
    let near = told["gaussians"]["end"].as_u64().unwrap() - told["gaussians"]["sky"].as_u64().unwrap();
    assert!(count("ground.ply") > 100 && count("objects.ply") > 100);
    assert_eq!(count("ground.ply") + count("objects.ply"), near);
    b.good(&["audit", "verify", "out"]);
    // Another seed is another run.
    let args = [&["train", &set, "--blocks", "2", "--parts", "parts", "--seed", "1", "-o", "no"], &BRIEF[..6]].concat();
    assert!(b.refused(&args).contains("--parts"));
    assert!(b.refused(&["train", &set, "--block", "1"]).contains("--blocks"));
    assert!(b.refused(&["train", &set, "--blocks", "2", "--exposure"]).contains("as a whole"));
}

#[test]
fn refined_poses_are_published_and_taken_again() {
    let b = Bench::new("1", "12", "96", &["--site", "--gps-noise", "0.2"]);
    let set = b.text("sets/00_site");
    let told: Value = serde_json::from_str(
        &b.good(&[&["train", &set, "-o", "out", "--json", "--refine-poses", "--sky", "off"], &BRIEF[..]].concat()),
    )
    .unwrap();
    let moved = &told["poses_refined"];
    assert!(moved["most_deg"].as_f64().unwrap() > 0.0 && moved["most_shift"].as_f64().unwrap() < 0.2, "{moved}");
    assert!(told["held_out_poses_fitted"]["psnr_db"].as_f64().unwrap() > 10.0);
    // The model has no observations.
    assert!(told["reprojection"]["before"].is_null() && told["reprojection"]["after"].is_null());
    assert!(b.at("out/sparse/0/images.txt").is_file());
    b.good(&["audit", "verify", "out"]);
    let again: Value = serde_json::from_str(
        &b.good(
            &[
                &["train", &set, "-o", "again", "--json", "--poses", &b.text("out/sparse/0"), "--sky", "off"],
                &BRIEF[..],
            ]
            .concat(),
        ),
    )
    .unwrap();
    assert!(again["held_out_poses_fitted"].is_null() && again["trained_on"]["photos"] == 10, "{again}");
}
