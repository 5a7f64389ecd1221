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
    let dir = tempfile::tempdir().unwrap();
    // South-western hemisphere and a heading: signs that the README's command does not meet.
    let made = Command::new(env!("CARGO_BIN_EXE_orb"))
        .args(["geo", "--origin", "-54.8019,-68.3030,12.5", "--heading", "200", "--iterations", "4"])
        .args(["--format", "cdb,flt,glb,usdz,tiles3d,spz,splat-glb", "--length", "6.06", "-o"])
        .arg(dir.path().join("out"))
        .arg(root.join("samples/shipping_container.jpg"))
        .env("ORB_DATA_DIR", dir.path().join("data"))
        .output()
        .unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let read = Command::new(root.join("tests/clients/check_folder.sh")).arg(dir.path().join("out")).output().unwrap();
    let said = format!("{}{}", String::from_utf8_lossy(&read.stdout), String::from_utf8_lossy(&read.stderr));
    assert!(read.status.success(), "{said}");
}
