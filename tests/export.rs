//! `orb export` and `orb cdb check` as a user runs them.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

use orb_formats::asset::{EncodedImage, Material, Part};
use orb_formats::{Asset, Mesh, Splats, glb, ply, spz, tiles3d, usdz};

/// One data folder (key, trust, ledger) for the whole test program.
fn data() -> &'static Path {
    static DATA: OnceLock<tempfile::TempDir> = OnceLock::new();
    DATA.get_or_init(|| tempfile::tempdir().unwrap()).path()
}

fn orb(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_orb")).args(args).env("ORB_DATA_DIR", data()).output().unwrap()
}

fn said(out: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr))
}

fn succeeds(args: &[&str]) -> String {
    let out = orb(args);
    assert!(out.status.success(), "{args:?}: {}", said(&out));
    said(&out)
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

/// A ball of splats, 3 m across, standing 10 m east of the origin.
fn ball() -> Splats {
    let count = 4000;
    let point = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f32 / count as f32;
        let (r, phi) = ((1.0 - z * z).sqrt(), i as f32 * 2.399_963);
        [10.0 + 1.5 * r * phi.cos(), 1.5 * r * phi.sin(), 1.5 * z]
    };
    let color = |i: usize| -> [[f32; 3]; 16] {
        std::array::from_fn(|b| if b == 0 { [1.0, (i % 100) as f32 / 100.0 - 0.5, -0.5] } else { [0.0; 3] })
    };
    Splats {
        positions: (0..count).map(point).collect(),
        log_scales: vec![[-2.6; 3]; count],
        rotations: vec![[1.0, 0.0, 0.0, 0.0]; count],
        logit_opacities: vec![6.0; count],
        sh: (0..count).map(color).collect(),
    }
}

const EVERYTHING: &str = "cdb,flt,glb,usdz,tiles3d,ply,spz,splat-glb";

/// Everything, from splats that another program wrote; looked at by several tests.
fn from_splats() -> &'static Path {
    static DONE: OnceLock<tempfile::TempDir> = OnceLock::new();
    let dir = DONE.get_or_init(|| {
        let dir = tempfile::tempdir().unwrap();
        let scene = dir.path().join("ball.ply");
        std::fs::write(&scene, ply::write(&ball(), &["made by hand".into()]).unwrap()).unwrap();
        let out = dir.path().join("out");
        let origin = ["--origin", "34.5523,-118.4712,740", "--heading", "45"];
        let rest = ["--format", EVERYTHING, "-o", text(&out)];
        succeeds(&[&["export", text(&scene)], &origin[..], &rest[..]].concat());
        dir
    });
    dir.path()
}

#[test]
fn splats_become_every_format() {
    let out = from_splats().join("out");
    let read = |name: &str| std::fs::read(out.join(name)).unwrap();
    let (scene, _) = ply::read(&read("scene.ply")).unwrap();
    assert_eq!(scene.positions.len(), 4000);
    // Put onto the ground under its centre.
    let lowest = scene.positions.iter().map(|p| p[2]).fold(f32::INFINITY, f32::min);
    let middle: f32 = scene.positions.iter().map(|p| p[0]).sum::<f32>() / 4000.0;
    assert!(lowest.abs() < 0.3 && middle.abs() < 0.1, "{lowest} {middle}");
    assert_eq!(spz::read(&read("ball.spz"), spz::Axes::RUB).unwrap().0.positions.len(), 4000);
    assert_eq!(glb::read(&read("ball_splats.glb")).unwrap().splats.unwrap().positions.len(), 4000);
    for name in ["ball.glb", "ball_lod1.glb", "tiles3d/lod0.glb", "tiles3d/lod1.glb"] {
        let (low, high) = glb::read(&read(name)).unwrap().parts[0].mesh.bounds().unwrap();
        for axis in 0..3 {
            let across = high[axis] - low[axis];
            assert!((2.7..3.6).contains(&across), "{name} is {across} m across on axis {axis}");
        }
        assert!((0.0..0.1).contains(&low[2]), "{name} stands {} m above the ground", low[2]);
    }
    assert_eq!(usdz::read(&read("ball.usdz")).unwrap().label.place.unwrap().heading, 45.0);
    let tileset = tiles3d::read(&read("tiles3d/tileset.json")).unwrap();
    let errors: Vec<f64> =
        std::iter::successors(Some(&tileset.root), |t| t.children.first()).map(|t| t.geometric_error).collect();
    assert!(errors.len() == 4 && errors[3] == 0.0 && errors.is_sorted_by(|a, b| a >= b), "{errors:?}");
    succeeds(&["audit", "verify", text(&out)]);
    let checked = succeeds(&["cdb", "check", text(&out.join("ball.cdb"))]);
    assert!(checked.contains("pass 12") && !checked.contains("FAIL"), "{checked}");
}

/// The ratified extension, told to readers before they fetch the content.
#[test]
fn splats_become_a_tile() {
    let scene = from_splats().join("ball.ply");
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let place = ["--origin", "34.5523,-118.4712,740", "--format", "tiles3d", "--tiles", "splats"];
    succeeds(&[&["export", text(&scene)], &place[..], &["-o", text(&out)]].concat());
    let tileset = tiles3d::read(&std::fs::read(out.join("tiles3d/tileset.json")).unwrap()).unwrap();
    assert_eq!(tileset.gltf_extensions[0], "KHR_gaussian_splatting");
    assert_eq!((tileset.root.geometric_error, tileset.root.children.len()), (0.0, 0));
    let content = tileset.root.content.unwrap();
    let splats = glb::read(&std::fs::read(out.join("tiles3d").join(content)).unwrap()).unwrap().splats.unwrap();
    assert_eq!(splats.positions.len(), 4000);
    // Y up → Z up: all of the ball, with what its splats reach beyond their centres, lies in the volume.
    let volume = &tileset.root.volume;
    for [x, y, z] in splats.positions {
        for (axis, at) in [x, -z, y].into_iter().enumerate() {
            let (middle, half) = (volume.center[axis], volume.half_axes[axis][axis]);
            assert!((f64::from(at) - middle).abs() + 0.2 < half, "{at} on axis {axis} of {volume:?}");
        }
    }
    succeeds(&["audit", "verify", text(&out)]);
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/truth/play_house/mesh.glb");
    let refused = orb(&[&["export", text(&model)], &place[..], &["-o", text(&dir.path().join("no"))]].concat());
    assert!(said(&refused).contains("without Gaussians"), "{}", said(&refused));
}

#[test]
fn ground_needs_a_store_to_lie_in() {
    let scene = from_splats().join("ball.ply");
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("no");
    let args = ["export", text(&scene), "--origin", "1,2,3", "--format", "glb", "--ground", "-o", text(&out)];
    let refused = orb(&args);
    assert!(refused.status.code() == Some(2) && said(&refused).contains("--format cdb"), "{}", said(&refused));
    assert!(!orb(&[&args[..6], &["cdb", "--ground-image", "x.tif", "-o", text(&out)]].concat()).status.success());
    assert!(!out.exists());
}

#[test]
fn a_marking_changed_inside_is_found_in_every_format() {
    let out = from_splats().join("out");
    let copy = tempfile::tempdir().unwrap();
    let to = copy.path().join("out");
    for name in
        ["ball.glb", "ball.usdz", "ball.spz", "scene.ply", "tiles3d/tileset.json", "ball.flt", "ball_0.rgb.attr"]
    {
        succeeds_to_copy(&out, &to);
        let path = to.join(name);
        let bytes = std::fs::read(&path).unwrap();
        let line = b"CLASSIFICATION: UNCLASSIFIED";
        let found = bytes.windows(line.len()).position(|w| w == line).unwrap_or_else(|| panic!("{name} is not marked"));
        let mut changed = bytes.clone();
        changed[found..found + line.len()].copy_from_slice(b"CLASSIFICATION: TOP SECRET  ");
        std::fs::write(&path, &changed).unwrap();
        let verified = orb(&["audit", "verify", text(&to)]);
        let words = said(&verified);
        assert_eq!(verified.status.code(), Some(1), "{name}: {words}");
        assert!(words.contains("MARKING_INBAND_MISMATCH"), "{name}: {words}");
        assert!(words.contains("OUTPUT_DIGEST") && words.contains(name), "{name}: {words}");
    }
}

fn succeeds_to_copy(from: &Path, to: &Path) {
    let _ = std::fs::remove_dir_all(to);
    assert!(Command::new("cp").arg("-r").args([from, to]).status().unwrap().success());
}

#[test]
fn a_model_of_others_becomes_every_format_with_a_surface() {
    let dir = tempfile::tempdir().unwrap();
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/truth/play_house/mesh.glb");
    let out = dir.path().join("out");
    let formats = "cdb,flt,glb,usdz,tiles3d";
    succeeds(&["export", text(&model), "--origin", "-33.9,151.2,5", "--format", formats, "-o", text(&out)]);
    let bounds = |path: PathBuf| {
        let parts = glb::read(&std::fs::read(path).unwrap()).unwrap().parts;
        let all: Vec<_> = parts.iter().filter_map(|p| p.mesh.bounds()).collect();
        let edge = |k: usize| {
            let low = all.iter().map(|b| b.0[k]).fold(f64::INFINITY, f64::min);
            all.iter().map(|b| b.1[k]).fold(f64::NEG_INFINITY, f64::max) - low
        };
        [edge(0), edge(1), edge(2)]
    };
    let (before, after) = (bounds(model.clone()), bounds(out.join("mesh.glb")));
    assert!((0..3).all(|k| (before[k] - after[k]).abs() < 1e-4), "{before:?} {after:?}");
    succeeds(&["audit", "verify", text(&out)]);
    succeeds(&["cdb", "check", text(&out.join("mesh.cdb"))]);
    // A second model, which is called the same, into the same store.
    let store = out.join("mesh.cdb");
    let (again, second) = (dir.path().join("again"), dir.path().join("mesh.glb"));
    std::fs::write(&second, glb::write(&tent()).unwrap()).unwrap();
    let place = ["--origin", "-33.901,151.2,5", "--lods", "0", "--format", "cdb", "--cdb", text(&store)];
    succeeds(&[&["export", text(&second)], &place[..], &["-o", text(&again)]].concat());
    succeeds(&["cdb", "check", text(&store)]);
    // What Orb wrote knows its place, and its own reader takes it back.
    let third = dir.path().join("third");
    let first = out.join("mesh.glb");
    succeeds(&["export", text(&first), "--format", "flt", "--flt-geometry", "meshes", "-o", text(&third)]);
    assert!(third.join("mesh.flt").metadata().unwrap().len() < out.join("mesh.flt").metadata().unwrap().len());
}

/// A classified scene: its banner in every format, its authority in the record, and no way down.
#[test]
fn a_classified_scene_stays_one_in_every_format() {
    // The user has a ledger, in which refusals are recorded.
    from_splats();
    let dir = tempfile::tempdir().unwrap();
    let banner = "SECRET//ORCON/REL TO USA, AUS, CAN, DEU, ESP, FRA, GBR, ITA, JPN, NLD, NOR, NZL//LIMDIS";
    let scene = dir.path().join("site.ply");
    std::fs::write(&scene, ply::write(&ball(), &[format!("CLASSIFICATION: {banner}")]).unwrap()).unwrap();
    let key = dir.path().join("unit.pem");
    succeeds(&["audit", "keygen", "-o", text(&key)]);
    let out = dir.path().join("out");
    let scene = ["export", text(&scene), "--origin", "34.5523,-118.4712,740", "--format", EVERYTHING];
    let base = [&scene[..], &["--key", text(&key), "-o", text(&out)]].concat();
    let refused = |more: &[&str], code: &str| {
        let done = orb(&[&base[..], more].concat());
        assert_eq!(done.status.code(), Some(4), "{more:?}: {}", said(&done));
        assert!(said(&done).contains(code), "{more:?}: {}", said(&done));
        assert!(!out.exists());
    };
    refused(&[], "AUTHORITY_REQUIRED");
    let by = ["--classified-by", "J. Doe, analyst", "--derived-from", "Guide, Agency, 20240105", "--declassify-on"];
    let block = [&by[..], &["25X1, 20701231"]].concat();
    refused(&[&by[..], &["OADR"]].concat(), "AUTHORITY_INVALID");
    refused(&[&block[..], &["--classification", "SECRET//REL TO USA, AUS, GBR//LIMDIS"]].concat(), "MARKING_DOWNGRADE");
    refused(&[&block[..], &["--classification", "CONFIDENTIAL"]].concat(), "MARKING_DOWNGRADE");
    refused(
        &[&block[..], &["--classification", "TOP SECRET//ORCON/NOFORN//LIMDIS"]].concat(),
        "MARKING_REASON_REQUIRED",
    );
    let events = succeeds(&["audit", "events"]);
    assert!(events.contains("marking.refused") && events.contains("MARKING_DOWNGRADE"), "{events}");

    succeeds(&[&base[..], &block].concat());
    succeeds(&["audit", "verify", text(&out)]);
    let checked = succeeds(&["cdb", "check", text(&out.join("site.cdb"))]);
    assert!(!checked.contains("FAIL"), "{checked}");
    for name in
        ["site.glb", "site.usdz", "site.spz", "scene.ply", "tiles3d/tileset.json", "site.flt", "orb-marking.json"]
    {
        let bytes = std::fs::read(out.join(name)).unwrap();
        assert!(bytes.windows(banner.len()).any(|w| w == banner.as_bytes()), "{name} does not show the banner");
    }
    let shown = succeeds(&["audit", "show", text(&out), "--json"]);
    let record: serde_json::Value = serde_json::from_str(&shown).unwrap();
    let marking = &record["predicate"]["marking"];
    assert_eq!(marking["banner"], banner);
    assert_eq!(marking["authority"]["declassify_on"], "25X1, 20701231");
    assert_eq!(marking["ism"]["nonICmarkings"], serde_json::json!(["DS"]));
    // What was made of it carries it on, and may be raised with a reason.
    let above = dir.path().join("above");
    let ply = out.join("scene.ply");
    let raised = ["--classification", "TOP SECRET//ORCON/NOFORN//LIMDIS", "--raise-reason", "compilation"];
    let again = ["export", text(&ply), "--format", "glb", "--key", text(&key), "-o", text(&above)];
    succeeds(&[&again[..], &block, &raised].concat());
    let shown = succeeds(&["audit", "show", text(&above), "--json"]);
    let record: serde_json::Value = serde_json::from_str(&shown).unwrap();
    assert_eq!(record["predicate"]["marking"]["raised_reason"], "compilation");
    assert_eq!(record["predicate"]["marking"]["inputs_join"], banner);
}

#[test]
fn what_cannot_be_done_is_said() {
    let dir = tempfile::tempdir().unwrap();
    let marked = dir.path().join("marked.ply");
    std::fs::write(&marked, ply::write(&ball(), &["CLASSIFICATION: CUI".into()]).unwrap()).unwrap();
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/truth/shipping_container/mesh.glb");
    let (marked, model) = (text(&marked), text(&model));
    let out = dir.path().join("out");
    let place = ["--origin", "0,0,0"];
    let table: [(&[&str], i32, &str); 7] = [
        (&[marked, "--format", "spz", place[0], place[1]], 4, "--key"),
        (&[marked, "--format", "spz", "--classification", "UNCLASSIFIED", place[0], place[1]], 4, "CUI"),
        (&[model, "--format", "glb"], 2, "--origin"),
        (&[model, "--format", "spz", place[0], place[1]], 2, "without Gaussians"),
        (&[model, "--format", "glb", "--scale", "-1", place[0], place[1]], 2, "--scale"),
        (&["Cargo.toml", "--format", "glb", place[0], place[1]], 2, "PLY or SPZ"),
        (&[model, "--format", "dxf", place[0], place[1]], 2, "dxf"),
    ];
    for (args, code, words) in table {
        let done = orb(&[&["export"], args, &["-o", text(&out)]].concat());
        assert_eq!(done.status.code(), Some(code), "{args:?}: {}", said(&done));
        assert!(said(&done).contains(words), "{args:?}: {}", said(&done));
        assert!(!out.exists());
    }
    let none = orb(&["cdb", "check", text(dir.path())]);
    assert_eq!(none.status.code(), Some(2), "{}", said(&none));
}

/// A store, an incremental version of it, and what cannot be.
#[test]
fn a_store_gets_a_new_version() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    let model = at("mesh.glb");
    std::fs::write(&model, glb::write(&tent()).unwrap()).unwrap();
    let export = |name: &str, place: &str, more: &[&str]| {
        let out = at(name);
        let base = ["export", text(&model), "--origin", place, "--lods", "0", "--format", "cdb", "-o", text(&out)];
        orb(&[&base[..], more].concat())
    };
    let passes = |out: Output| assert!(out.status.success(), "{}", said(&out));
    passes(export("old", "-33.9,151.2,5", &["--as", "gt", "--facc", "AL015/016"]));
    let old = at("old/mesh.cdb");
    let before: Vec<PathBuf> = files(&old);
    passes(export("new", "-33.901,151.2,5", &["--cdb-version-of", text(&old), "--material", "brick:70+glass:30"]));
    let new = at("new/mesh.cdb");
    assert_eq!(files(&old), before);
    let version = std::fs::read_to_string(new.join("Metadata/Version.xml")).unwrap();
    assert!(version.contains("name=\"../../old/mesh.cdb\""), "{version}");
    succeeds(&["audit", "verify", text(&at("new"))]);
    for store in [&old, &new] {
        let checked = succeeds(&["cdb", "check", text(store)]);
        assert!(!checked.contains("FAIL"), "{checked}");
    }
    // The house of the library is used again through the chain.
    passes(export("third", "-33.902,151.2,5", &["--cdb-version-of", text(&new), "--as", "gt", "--facc", "AL015/016"]));
    let third = files(&at("third/mesh.cdb"));
    assert!(!third.iter().any(|p| p.components().any(|c| c.as_os_str() == "500_GTModelGeometry")), "{third:?}");
    let checked = succeeds(&["cdb", "check", text(&at("third/mesh.cdb"))]);
    assert!(!checked.contains("FAIL"), "{checked}");
    let refused: [(&[&str], &str); 6] = [
        (&["--as", "moving"], "--dis"),
        (&["--dis", "1.1.225.1"], "--as moving"),
        (&["--as", "moving", "--dis", "1.1.225"], "1.1.225.1.1.8.0"),
        (&["--as", "moving", "--dis", "1.1.225.99"], "Moving_Model_Codes"),
        (&["--material", "brick:70"], "--material"),
        (&["--cdb", text(&new)], "further version"),
    ];
    for (more, words) in refused {
        let done = export("refused", "-33.9,151.2,5", more);
        assert_eq!(done.status.code(), Some(2), "{more:?}: {}", said(&done));
        assert!(said(&done).contains(words), "{more:?}: {}", said(&done));
        assert!(!at("refused").exists());
    }
}

/// Two slopes, 4 × 6 m and 3 m high: few vertices, so that it is a level of its own.
fn tent() -> Asset {
    let corners =
        [[-2.0, -3.0, 0.0], [2.0, -3.0, 0.0], [2.0, 3.0, 0.0], [-2.0, 3.0, 0.0], [0.0, -3.0, 3.0], [0.0, 3.0, 3.0]];
    let mesh = Mesh {
        positions: corners.to_vec(),
        normals: vec![
            [-0.6, 0.0, 0.8],
            [0.6, 0.0, 0.8],
            [0.6, 0.0, 0.8],
            [-0.6, 0.0, 0.8],
            [0.0, 0.0, 1.0],
            [0.0, 0.0, 1.0],
        ],
        uvs: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.0], [0.5, 1.0]],
        triangles: vec![[1, 2, 5], [1, 5, 4], [3, 0, 4], [3, 4, 5]],
    };
    let mut png = std::io::Cursor::new(Vec::new());
    image::RgbImage::from_pixel(8, 8, image::Rgb([90, 120, 60])).write_to(&mut png, image::ImageFormat::Png).unwrap();
    Asset {
        name: "tent".into(),
        parts: vec![Part { mesh, material: Some(0) }],
        materials: vec![Material { image: Some(0), ..Material::default() }],
        images: vec![EncodedImage { media_type: "image/png".into(), bytes: png.into_inner() }],
        ..Asset::default()
    }
}

fn files(root: &Path) -> Vec<PathBuf> {
    let mut open = vec![root.to_owned()];
    let mut all = Vec::new();
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() { open.push(path) } else { all.push(path) }
        }
    }
    all.sort();
    all
}
