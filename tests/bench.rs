//! `orb bench` from the outside: make scenes, score results of someone, read what was published.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn orb(data: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_orb")).args(args).env("ORB_DATA_DIR", data).output().unwrap()
}

fn good(output: &Output) -> String {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn anyones_results_are_scored_over_made_scenes_and_published_sealed() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let text = |name: &str| at(name).to_string_lossy().into_owned();
    let data = at("data");
    let (scenes, theirs, report) = (text("scenes"), text("theirs"), text("report"));
    let small = ["--scenes", "2", "--size", "96", "--views", "3", "--view-size", "96"];
    good(&orb(&data, &[&["bench", "make", "-o", &scenes, "--quiet"][..], &small].concat()));
    good(&orb(&data, &["audit", "verify", &scenes]));
    // Someone's results: of the first scene the truth, of the second nothing.
    std::fs::create_dir(at("theirs")).unwrap();
    std::fs::copy(at("scenes/00_container/mesh.glb"), at("theirs/00_container.glb")).unwrap();
    let run = ["bench", "run", &scenes, "--results", &theirs, "--no-speed"];
    let told = good(&orb(&data, &[&run[..], &["--json", "--system", "the truth", "-o", &report]].concat()));
    let told: Value = serde_json::from_str(&told).unwrap();
    assert_eq!((&told["system"], &told["marking"]), (&"the truth".into(), &"UNCLASSIFIED".into()));
    let total = told["scores"]["total"].as_f64().unwrap();
    let coverage = told["scores"]["coverage_percent"].as_f64().unwrap();
    assert!(total > 99.0 && (30.0..50.0).contains(&coverage), "{total} over {coverage} %: half of the scenes");
    assert_eq!(told["scenes"][1]["not_measured"]["psnr"], "no result for this scene");
    good(&orb(&data, &["audit", "verify", &report]));
    let page = std::fs::read_to_string(at("report/report.html")).unwrap();
    assert!(page.contains("<svg") && page.contains("UNCLASSIFIED") && !page.contains("://"));
    let rows = good(&orb(&data, &[&run[..], &["--csv"]].concat()));
    assert!(rows.lines().count() > 60 && rows.starts_with("marking,system,scene"), "{rows}");
    let table = good(&orb(&data, &run));
    assert!(table.contains("not measured") && table.contains("coverage"), "{table}");
    // What they hold is never marked below.
    let secret = orb(&data, &[&run[..], &["--classification", "NONSENSE"]].concat());
    assert!(!secret.status.success());
}

#[test]
fn the_metrics_are_listed() {
    let folder = tempfile::tempdir().unwrap();
    let listed: Value = serde_json::from_str(&good(&orb(folder.path(), &["bench", "--list", "--json"]))).unwrap();
    assert_eq!(listed["metrics"].as_array().unwrap().len(), 30);
    assert!(good(&orb(folder.path(), &["bench", "--list"])).contains("chamfer"));
    for wrong in [&["bench"][..], &["bench", "--json"], &["bench", "run"], &["bench", "--list", "speed"]] {
        assert_eq!(orb(folder.path(), wrong).status.code(), Some(2), "{wrong:?}");
    }
    // Where nothing can be published nothing is measured: told of before the scenes that do not exist either.
    let taken = folder.path().join("taken");
    std::fs::create_dir(&taken).unwrap();
    std::fs::write(taken.join("notes.txt"), "the user's").unwrap();
    let e = orb(folder.path(), &["bench", "run", "/nowhere", "-o", &taken.to_string_lossy()]);
    assert!(String::from_utf8_lossy(&e.stderr).contains("taken") && !e.status.success());
    let e = orb(folder.path(), &["bench", "run", "/nowhere"]);
    assert!(String::from_utf8_lossy(&e.stderr).contains("/nowhere") && !e.status.success());
}
