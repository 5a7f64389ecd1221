//! `orb models`, `orb doctor` and the networks in `orb geo`, as a user runs them, on the contract stubs.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

use serde_json::Value;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn stub(name: &str) -> PathBuf {
    root().join("tests/data/contracts").join(name)
}

/// A user's machine: a data folder, and no ONNX Runtime but what a test names.
pub struct Machine(tempfile::TempDir);

impl Machine {
    fn new() -> Machine {
        Machine(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn orb(&self, args: &[&str], more: &[PathBuf]) -> Output {
        let mut c = Command::new(env!("CARGO_BIN_EXE_orb"));
        c.args(args).args(more).env("ORB_DATA_DIR", self.path("data")).current_dir(self.0.path());
        c.env_remove("ORB_MODELS_DIR")
            .env_remove("ORT_DYLIB_PATH")
            .env_remove("VIRTUAL_ENV")
            .env_remove("CONDA_PREFIX");
        c.output().unwrap()
    }

    fn import(&self, args: &[&str], files: &[&str]) -> Output {
        let files: Vec<PathBuf> = files.iter().map(|f| stub(f)).collect();
        self.orb(&[&["models", "import", "--engine", "rten"], args].concat(), &files)
    }
}

fn text(out: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr))
}

fn ends(out: &Output, code: i32, words: &[&str]) {
    let said = text(out);
    assert_eq!(out.status.code(), Some(code), "{said}");
    for word in words {
        assert!(said.contains(word), "expected «{word}» in: {said}");
    }
}

/// The container's, where the mask is nothing that a test is about.
const MASK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/container_mask.png");
const TRUST: [&str; 2] = ["--allow-unpinned", "--accept-licence"];

#[test]
fn networks_are_imported_listed_shown_verified_and_removed() {
    let m = Machine::new();
    ends(&m.orb(&["models", "list"], &[]), 0, &["no network was imported"]);
    ends(&m.import(&[], &["depth_anything_v2.onnx"]), 4, &["--allow-unpinned"]);
    ends(&m.import(&["--allow-unpinned"], &["depth_anything_v2.onnx"]), 4, &["--accept-licence"]);
    ends(&m.import(&TRUST, &["sam2_encoder.onnx"]), 2, &["decoder"]);
    ends(&m.import(&TRUST, &["vectors.json"]), 2, &[".onnx"]);
    ends(&m.import(&TRUST, &["depth_anything_v2.onnx"]), 0, &["depth-anything", "unverified"]);
    ends(&m.import(&TRUST, &["depth_anything_v2.onnx"]), 2, &["--replace"]);
    ends(&m.orb(&["models", "list", "--known"], &[]), 0, &["depth-anything", "zero123pp-v1.2", "no commercial use"]);
    let shown = m.orb(&["models", "show", "depth-anything", "--json"], &[]);
    let manifest: Value = serde_json::from_slice(&shown.stdout).unwrap();
    assert_eq!(manifest["depth_kind"], "disparity");
    ends(&m.orb(&["models", "verify"], &[]), 0, &["as imported"]);
    let weights = m.path("data/models/depth-anything/depth_anything_v2.onnx");
    let mut bytes = std::fs::read(&weights).unwrap();
    bytes[600] ^= 1;
    std::fs::write(&weights, bytes).unwrap();
    ends(&m.orb(&["models", "verify"], &[]), 1, &["changed on disk"]);
    // A run that would use them stops before anything is published.
    let photo = root().join("tests/data/container.jpg");
    let out = m.path("out");
    let args = ["geo", "--origin", "1,2,3", "--engine", "rten", "-o", out.to_str().unwrap()];
    ends(&m.orb(&args, std::slice::from_ref(&photo)), 1, &["changed on disk"]);
    assert!(!out.exists());
    ends(&m.orb(&["models", "remove", "depth-anything"], &[]), 0, &["removed"]);
    ends(&m.orb(&["models", "remove", "depth-anything"], &[]), 2, &["depth-anything"]);
}

/// The stub says 5 m and what the picture's brightness adds. Beside it a network for six views, which is not used.
#[test]
fn a_metric_depth_network_gives_the_scale_and_one_that_takes_long_is_not_used() {
    let m = Machine::new();
    ends(&m.import(&[&TRUST[..], &["--depth-kind", "metric"]].concat(), &["depth_anything_v2.onnx"]), 0, &[]);
    import_zero123(&m);
    let (photo, out) = (root().join("tests/data/container.jpg"), m.path("out"));
    let args = ["geo", "--origin", "1,2,3", "--iterations", "2", "--engine", "rten", "--format", "ply", "--json"];
    let run = |more: &[&str]| -> Output {
        let done = m.orb(
            &[&args[..], &crate::SMALL, &["--mask", MASK, "--replace", "-o", out.to_str().unwrap()], more].concat(),
            std::slice::from_ref(&photo),
        );
        assert!(done.status.success(), "{}", text(&done));
        done
    };
    let json = |done: &Output| -> Value { serde_json::from_slice(&done.stdout).unwrap() };
    let done = run(&[]);
    // On the CPU a network that takes long is used only when it is named.
    ends(&done, 0, &["zero123pp-v1.2 is not used: without a GPU"]);
    let alone = json(&done);
    assert_eq!(alone["scale"]["source"], "metric-depth-assumed-focal");
    let words = alone["scale"]["words"].as_str().unwrap();
    let metres: f64 = words.strip_prefix("front ").and_then(|w| w.split(' ').next()).unwrap().parse().unwrap();
    assert!((3.0..8.0).contains(&metres) && words.contains("by a metric depth network"), "{words}");
    // Beside a dimension that is known it has a say, a small one.
    let both = json(&run(&["--length", "6.06"]));
    assert_eq!(both["scale"]["source"], "known-length");
    assert!(both["scale"]["words"].as_str().unwrap().contains("; front "), "{both}");
}

/// A ball on grey from six sides, each a little different in colour.
fn ball() -> image::RgbImage {
    image::RgbImage::from_fn(640, 960, |x, y| {
        let (dx, dy) = ((x % 320) as f32 - 159.5, (y % 320) as f32 - 159.5);
        let d = (dx * dx + dy * dy).sqrt();
        let shade = 60 + (x / 320 * 20 + y / 320 * 30) as u8;
        image::Rgb(if d < 100.0 { [200 - (d / 2.0) as u8, shade, 40] } else { [127; 3] })
    })
}

/// The ball's normals: x right, y up, z towards the camera.
fn ball_normals() -> image::RgbImage {
    image::RgbImage::from_fn(640, 960, |x, y| {
        let (dx, dy) = (((x % 320) as f32 - 159.5) / 100.0, ((y % 320) as f32 - 159.5) / 100.0);
        let under = 1.0 - dx * dx - dy * dy;
        let n = if under > 0.0 { [dx, -dy, under.sqrt()] } else { [0.0; 3] };
        image::Rgb(n.map(|v| (v * 127.5 + 128.0) as u8))
    })
}

#[test]
fn a_run_with_networks_and_views_says_and_pins_what_ran() {
    let m = Machine::new();
    ends(
        &m.import(&["--allow-unpinned", "--as", "depth-anything-v2-small"], &["depth_anything_v2.onnx"]),
        0,
        &["Apache-2.0"],
    );
    ends(&m.import(&TRUST, &["sam2_encoder.onnx", "sam2_decoder.onnx"]), 0, &["sam2-samexporter"]);
    ball().save(m.path("views.png")).unwrap();
    let (photo, out) = (root().join("tests/data/container.jpg"), m.path("out"));
    let mut args =
        vec!["geo", "--origin", "1,2,3", "--iterations", "4", "--engine", "rten", "-o", out.to_str().unwrap()];
    ball_normals().save(m.path("normals.png")).unwrap();
    args.extend([
        "--point",
        "256,240",
        "--views",
        "views.png",
        "--normals",
        "normals.png",
        "--height",
        "2",
        "--verbose",
    ]);
    args.extend(crate::SMALL);
    let done = m.orb(&args, std::slice::from_ref(&photo));
    ends(
        &done,
        0,
        &["sam2-samexporter (rten 0.27)", "mask score 0.90, refined", "six views from a file", "at most during depth"],
    );
    let record = m.orb(&["audit", "show"], std::slice::from_ref(&out));
    let said = text(&record);
    let words =
        ["sam2-samexporter", "depth-anything-v2-small", "unverified", "views.png", "normals.png", "orb-splat-core"];
    for words in words {
        assert!(said.contains(words), "{words} in {said}");
    }
    let shown = m.orb(&["audit", "show", "--json"], std::slice::from_ref(&out));
    let statement: Value = serde_json::from_slice(&shown.stdout).unwrap();
    let models = statement["predicate"]["models"].as_array().unwrap();
    let of = |id: &str| models.iter().find(|m| m["id"] == id).unwrap_or_else(|| panic!("{id} in {models:?}"));
    assert_eq!(of("depth-anything-v2-small")["licence"], "Apache-2.0");
    assert_eq!(of("depth-anything-v2-small")["pin_source"], "unverified");
    assert_eq!(of("sam2-samexporter")["weights_sha256"].as_str().unwrap().len(), 64);
    for id in ["zero123pp", "gsplat", "colmap"] {
        assert_eq!(of(id)["status"], "not-used");
    }
    assert!(models.iter().all(|m| m["id"] != "sam2" && m["id"] != "depth-anything-v2"));
    ends(&m.orb(&["audit", "verify"], std::slice::from_ref(&out)), 0, &[]);
}

#[test]
fn options_that_cannot_be_met_are_refused_and_publish_nothing() {
    let m = Machine::new();
    let (photo, out) = (root().join("tests/data/container.jpg"), m.path("out"));
    let run = |more: &[&str]| {
        let args = [&["geo", "--origin", "1,2,3", "--iterations", "4", "-o", out.to_str().unwrap()], more].concat();
        let done = m.orb(&args, std::slice::from_ref(&photo));
        assert!(!out.exists());
        done
    };
    ball().save(m.path("views.png")).unwrap();
    image::GrayImage::new(80, 80).save(m.path("black.png")).unwrap();
    std::fs::write(m.path("text.onnx"), "words").unwrap();
    ends(&run(&["--box", "1,1,200,200"]), 2, &["an imported mask network"]);
    ends(&run(&["--point", "10,10", "--point", "30,30"]), 2, &["an imported mask network"]);
    ends(&run(&["--point", "10"]), 2, &["X,Y"]);
    ends(&run(&["--point", "9999,1"]), 2, &["512 × 512"]);
    ends(&run(&["--box", "1,2,3"]), 2, &["X0,Y0,X1,Y1"]);
    ends(&run(&["--mask", "black.png"]), 2, &["nothing white"]);
    ends(&run(&["--mask", "views.png"]), 2, &["640 × 960"]);
    ends(&run(&["--mask", "absent.png"]), 5, &["absent.png"]);
    ends(&run(&["--views", "black.png"]), 2, &["640 × 960"]);
    ends(&run(&["--views", "views.png", "--normals", "black.png"]), 2, &["normals", "640 × 960"]);
    ends(&run(&["--normals", "views.png"]), 2, &["--views"]);
    ends(&run(&["--networks", "sam2-tiny"]), 2, &["sam2-tiny"]);
    ends(&run(&["--engine", "rten", "--provider", "cuda"]), 2, &["--engine ort"]);
    ends(&run(&["--onnxruntime", "text.onnx", "--engine", "ort"]), 5, &["no ONNX Runtime 1"]);
    ends(&run(&["--mask", "black.png", "--point", "1,1"]), 2, &["cannot be used with"]);
}

/// What a run with a mask of one's own said to a person, whose machine and which folder; signed by `audit::pair`.
pub fn by_a_mask() -> &'static (Output, Machine, PathBuf) {
    static DONE: OnceLock<(Output, Machine, PathBuf)> = OnceLock::new();
    let made = || {
        let m = Machine::new();
        let (photo, out) = (root().join("tests/data/container.jpg"), m.path("out"));
        let key = crate::audit::pair().join("pair.pem");
        let mut args = vec!["geo", "--origin", "1,2,3", "--iterations", "4", "-o", out.to_str().unwrap()];
        args.extend(["--key", key.to_str().unwrap(), "--mask", MASK]);
        args.extend(crate::SMALL);
        let done = m.orb(&args, std::slice::from_ref(&photo));
        ends(&done, 0, &[]);
        (done, m, out)
    };
    DONE.get_or_init(made)
}

#[test]
fn a_mask_of_ones_own_takes_the_networks_place() {
    let (done, m, out) = by_a_mask();
    ends(done, 0, &["mask from a file"]);
    ends(&m.orb(&["audit", "show"], std::slice::from_ref(out)), 0, &["container_mask.png"]);
}

#[test]
fn the_doctor_says_what_is_there_and_what_is_missing() {
    let m = Machine::new();
    ends(
        &m.orb(&["doctor"], &[]),
        0,
        &["rten 0.27", "none imported for the mask", "signing key", "clock", "free", "proj "],
    );
    // It changes nothing: no key is made.
    assert!(!m.path("data/keys").exists());
    ends(&m.import(&TRUST, &["depth_anything_v2.onnx"]), 0, &[]);
    ends(&m.orb(&["audit", "events"], &[]), 0, &["key.generate", "model.import       success", "depth"]);
    let ledger = std::fs::read(m.path("data/ledger/orb-ledger.jsonl")).unwrap();
    let done = m.orb(&["doctor", "--json"], &[]);
    let object: Value = serde_json::from_slice(&done.stdout).unwrap();
    let findings = object["findings"].as_array().unwrap();
    let of = |topic: &str| findings.iter().filter(|f| f["topic"] == topic).collect::<Vec<_>>();
    assert!(
        of("network").iter().any(|f| f["state"] == "good" && f["found"].as_str().unwrap().contains("depth-anything"))
    );
    assert_eq!(of("network").iter().filter(|f| f["state"] == "note").count(), 2);
    // A runtime that was named and is none: a problem, and the exit code says so.
    std::fs::write(m.path("libonnxruntime.so"), "words").unwrap();
    ends(&m.orb(&["doctor", "--onnxruntime", "libonnxruntime.so"], &[]), 5, &["PROBLEM", "no ONNX Runtime 1"]);
    assert_eq!(std::fs::read(m.path("data/ledger/orb-ledger.jsonl")).unwrap(), ledger, "nothing was recorded");
}

/// The stubs of a network for six views, first without what it is prompted with.
fn import_zero123(m: &Machine) {
    let folder = m.path("zero");
    std::fs::create_dir(&folder).unwrap();
    for name in ["clip_vision", "vae_encoder", "unet_write", "unet_read", "vae_decoder"] {
        std::fs::copy(stub(&format!("{name}.onnx")), folder.join(format!("{name}.onnx"))).unwrap();
    }
    let import = [&["models", "import", "--engine", "rten", "--as", "zero123pp-v1.2"], &TRUST[..]].concat();
    ends(&m.orb(&import, std::slice::from_ref(&folder)), 2, &["prompt"]);
    let (first, last) = (77 * 1024 * 4, 77 * 1024 * 4 + 77 * 4);
    let header = format!(
        r#"{{"prompt_embeds":{{"dtype":"F32","shape":[77,1024],"data_offsets":[0,{first}]}},"ramp":{{"dtype":"F32","shape":[77],"data_offsets":[{first},{last}]}}}}"#
    );
    let mut prompt = (header.len() as u64).to_le_bytes().to_vec();
    prompt.extend(header.bytes());
    prompt.resize(prompt.len() + last, 0);
    std::fs::write(folder.join("prompt.safetensors"), prompt).unwrap();
    ends(&m.orb(&import, std::slice::from_ref(&folder)), 0, &["zero123pp-v1.2", "read it before commercial use"]);
}

#[test]
fn six_views_that_a_network_draws_badly_are_refused() {
    let m = Machine::new();
    import_zero123(&m);
    let (photo, out) = (root().join("tests/data/container.jpg"), m.path("out"));
    let args = ["geo", "--origin", "1,2,3", "--iterations", "4", "--engine", "rten", "--mask", MASK, "-o"];
    let named = ["--networks", "zero123pp-v1.2", "--diffusion-steps", "2"];
    // Named, it is used without a GPU too. The stubs draw no subject, and that is noticed.
    let done =
        m.orb(&[&args[..], &[out.to_str().unwrap()], &crate::SMALL, &named].concat(), std::slice::from_ref(&photo));
    ends(&done, 2, &["a subject on an even background"]);
    assert!(!out.exists());
}
