//! Outside readers on everything that the main job publishes: `tests/clients/README.md` says which and how.

use std::path::Path;
use std::process::Command;

/// Skips with a printed reason; under `ORB_REQUIRE_CLIENTS=1` a missing reader fails.
fn have_readers() -> bool {
    let missing: Vec<&str> = ["osgconv", "ogrinfo", "iinfo", "openssl", "unzip", "g++", "python3"]
        .into_iter()
        .filter(|tool| {
            Command::new("sh")
                .args(["-c", &format!("command -v {tool}")])
                .output()
                .map_or(true, |o| !o.status.success())
        })
        .collect();
    if missing.is_empty() {
        return true;
    }
    assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "missing readers: {missing:?}");
    eprintln!("skipped: missing readers {missing:?}");
    false
}

#[test]
fn outside_readers_open_a_published_folder() {
    if !have_readers() {
        return;
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = Command::new(root.join("tests/clients/check_folder.sh")).arg(crate::geo::container()).output().unwrap();
    let said = format!("{}{}", String::from_utf8_lossy(&read.stdout), String::from_utf8_lossy(&read.stderr));
    assert!(read.status.success(), "{said}");
}

/// Models of the libraries, placed by features: read as they lie, external references and texture paths followed.
#[test]
fn outside_readers_open_model_libraries() {
    if !have_readers() {
        return;
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let run = |program: &str, args: &[&str]| {
        let done = Command::new(program).args(args).env("ORB_DATA_DIR", dir.path().join("data")).output().unwrap();
        let said = format!("{}{}", String::from_utf8_lossy(&done.stdout), String::from_utf8_lossy(&done.stderr));
        assert!(done.status.success(), "{program} {args:?}: {said}");
        said
    };
    let (orb, out_name) = (env!("CARGO_BIN_EXE_orb"), out.to_str().unwrap());
    let model = root.join("samples/truth/play_house/mesh.glb");
    let export = |place: &str, more: &[&str]| {
        let base = ["export", model.to_str().unwrap(), "--origin", place, "--format", "cdb"];
        run(orb, &[&base[..], more].concat())
    };
    let moving = ["--as", "moving", "--dis", "1.1.225.27.1", "--material", "paint/metal-steel"];
    export("-54.8019,-68.3030,12.5", &[&moving[..], &["-o", out_name]].concat());
    let store = out.join("mesh.cdb");
    run("sh", &["-c", &format!("{} {out_name}", root.join("tests/clients/check_folder.sh").display())]);
    // A building of the library and a second car into the same store; then the store alone is read again.
    let more = dir.path().join("more");
    let into = ["--cdb", store.to_str().unwrap(), "-o", more.to_str().unwrap()];
    export("-54.8020,-68.3040,12.5", &[&["--as", "gt", "--facc", "AL015/016"][..], &into].concat());
    run(orb, &["audit", "verify", more.to_str().unwrap(), "--store", store.to_str().unwrap()]);
    let second = dir.path().join("second");
    let into = ["--cdb", store.to_str().unwrap(), "-o", second.to_str().unwrap()];
    export("-54.8021,-68.3040,12.5", &[&moving[..], &into].concat());
    let checked = run(orb, &["cdb", "check", store.to_str().unwrap()]);
    assert!(!checked.contains("FAIL"), "{checked}");
    let find = |name: &str| {
        let found = run("find", &[store.to_str().unwrap(), "-name", name]);
        found.lines().max().unwrap_or_else(|| panic!("no {name}")).to_owned()
    };
    let scene = dir.path().join("scene.osgt");
    let said = run("osgconv", &[&find("D500*.flt"), scene.to_str().unwrap()]);
    assert!(!said.contains("an't find") && !said.contains("Unknown record"), "{said}");
    let text = std::fs::read_to_string(&scene).unwrap();
    assert!(text.matches("osg::Geometry").count() >= 4, "the levels behind the external references");
    let features = run("ogrinfo", &["-al", &find("*_D101_S003_T001_L0*.shp")]);
    assert!(features.contains("MMDC (String) = 1_1_225_27_1_0_0"), "{features}");
}
