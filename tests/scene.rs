//! `orb train` from the outside, on made places whose truth is known.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

struct Bench {
    folder: tempfile::TempDir,
}

impl Bench {
    fn new(photos: &str, size: &str, more: &[&str]) -> Bench {
        let b = Bench { folder: tempfile::tempdir().unwrap() };
        let sets = b.text("sets");
        let args = ["bench", "make", "-o", &sets, "--scenes", "1", "--photos", photos, "--size", size, "--quiet"];
        b.good(&[&args[..], more].concat());
        b
    }
    fn at(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }
    fn text(&self, name: &str) -> String {
        self.at(name).to_string_lossy().into_owned()
    }
    fn orb(&self, args: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_orb"))
            .args(args)
            .env("ORB_DATA_DIR", self.at("data"))
            .current_dir(self.folder.path())
            .output()
            .unwrap()
    }
    fn good(&self, args: &[&str]) -> String {
        let o = self.orb(args);
        assert!(o.status.success(), "{args:?}: {}", String::from_utf8_lossy(&o.stderr));
        String::from_utf8_lossy(&o.stdout).into_owned()
    }
    fn refused(&self, args: &[&str]) -> String {
        let o = self.orb(args);
        assert_eq!(o.status.code(), Some(2), "{args:?}: {}", String::from_utf8_lossy(&o.stderr));
        String::from_utf8_lossy(&o.stderr).into_owned()
    }
}

fn json(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

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
    let b = Bench::new("12", "96", &["--site", "--moving", "--gps-noise", "0.2"]);
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

#[test]
fn the_table_is_printed_runs_go_on_and_options_are_judged() {
    let b = Bench::new("10", "64", &["--nerf"]);
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
    assert!(b.refused(&["train", "nowhere"]).contains("nowhere"));
    assert!(!b.at("00_container_nerf_scene").exists());
}
