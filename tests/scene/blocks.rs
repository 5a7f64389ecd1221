//! `--plan`, and blocks that several runs train.

use sha2::Digest;

use super::*;

#[test]
fn a_plan_is_said_and_blocks_of_several_runs_are_put_together() {
    let b = Bench::new("1", "12", "96", &["--site"]);
    let set = b.text("sets/00_site");
    let train =
        |more: &[&str]| b.good(&[&["train", &set, "--blocks", "2", "--parts", "parts"], &BRIEF[..6], more].concat());
    let plan = train(&["--plan"]);
    assert!(plan.contains("12 photos") && plan.contains("memory") && plan.contains("2 blocks"), "{plan}");
    assert!(!plan.contains("meshes"), "{plan}");
    let plan = train(&["--plan", "--format", "tiles3d", "--tiles", "mesh"]);
    assert!(plan.contains("of it about") && plan.contains("for meshes in"), "{plan}");
    assert_eq!(train(&["--block", "2", "-o", "none"]), "");
    assert!(b.at("parts/coarse/gaussians.part").is_file() && b.at("parts/block_002/gaussians.part").is_file());
    assert!(!b.at("parts/block_001").exists() && !b.at("none").exists());
    // Each has a record of its own, of the photos and of what it began with.
    for (part, photos) in [("coarse", "coarse"), ("block_002", "block 2 of 2")] {
        let (folder, p) = (format!("parts/{part}"), predicate(&b.at(&format!("parts/{part}"))));
        b.good(&["audit", "verify", &folder]);
        assert_eq!((p["event"]["type"].clone(), p["params"]["part"].clone()), ("scene.block".into(), photos.into()));
        assert!(p["params"]["poses_sha256"].as_str().unwrap().len() == 64 && p["params"]["seed"] == "0", "{p}");
        let roles = |role: &str| p["inputs"].as_array().unwrap().iter().filter(|i| i["role"] == role).count();
        let from = usize::from(part != "coarse");
        assert_eq!((roles("photo"), roles("poses"), roles("part"), roles("record")), (12, 3, from, from));
        assert!(!b.at(&folder).join("run.ckpt").exists());
    }
    let sha = |file: &str| hex::encode(sha2::Sha256::digest(std::fs::read(b.at(file)).unwrap()));
    let of_block = sha("parts/block_002/orb-record.dsse.json");
    // Nothing is trained or sealed anew.
    train(&["--block", "2", "-o", "none"]);
    assert_eq!(sha("parts/block_002/orb-record.dsse.json"), of_block);
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
    // The whole names what it was put together of, and its report shows it; what it trained itself is no input.
    let p = predicate(&b.at("out"));
    let inputs = p["inputs"].as_array().unwrap();
    let of = |name: &str| inputs.iter().find(|i| i["name"] == name).map(|i| i["sha256"].as_str().unwrap().to_owned());
    assert_eq!(of("block_002/orb-record.dsse.json"), Some(of_block));
    assert_eq!(of("block_002/gaussians.part"), Some(sha("parts/block_002/gaussians.part")));
    assert!(of("coarse/orb-record.dsse.json").is_some() && of("block_001/gaussians.part").is_none());
    assert_eq!(p["params"]["parts_run"], predicate(&b.at("parts/block_002"))["params"]["parts_run"]);
    assert_eq!(
        (p["params"]["parts_verified"].clone(), p["params"]["parts_not_verified"].clone()),
        (2.into(), 0.into())
    );
    b.good(&["audit", "report", "out", "--format", "markdown", "-o", "report.md"]);
    let report = std::fs::read_to_string(b.at("report.md")).unwrap();
    assert!(report.contains("block_002/") && report.contains("record"), "{report}");
    // A part that is not its record's is refused.
    let kept = std::fs::read(b.at("parts/coarse/gaussians.part")).unwrap();
    std::fs::copy(b.at("parts/block_002/gaussians.part"), b.at("parts/coarse/gaussians.part")).unwrap();
    let changed = b.orb(&[&["train", &set, "--blocks", "2", "--parts", "parts", "-o", "no"], &BRIEF[..6]].concat());
    let said = String::from_utf8_lossy(&changed.stderr).into_owned();
    assert!(changed.status.code() == Some(1) && said.contains("as its record says"), "{said}");
    std::fs::write(b.at("parts/coarse/gaussians.part"), kept).unwrap();
    // So is one whose record says something else than what was signed, as `orb audit verify` finds it.
    let whole = std::fs::read(b.at("parts/block_002/orb-record.dsse.json")).unwrap();
    let other = std::fs::read(b.at("parts/coarse/orb-record.dsse.json")).unwrap();
    let signature = |bytes: &[u8]| -> String {
        let envelope: Value = serde_json::from_slice(bytes).unwrap();
        envelope["signatures"][0]["sig"].as_str().unwrap().to_owned()
    };
    let forged = String::from_utf8(whole.clone()).unwrap().replace(&signature(&whole), &signature(&other));
    std::fs::write(b.at("parts/block_002/orb-record.dsse.json"), forged).unwrap();
    let again = [&["train", &set, "--blocks", "2", "--parts", "parts", "-o", "no"], &BRIEF[..6]].concat();
    let forged = b.orb(&again);
    let said = String::from_utf8_lossy(&forged.stderr).into_owned();
    assert!(forged.status.code() == Some(1) && said.contains("SIG_INVALID") && !b.at("no").exists(), "{said}");
    std::fs::write(b.at("parts/block_002/orb-record.dsse.json"), whole).unwrap();
    // Of somebody whom nobody here vouches for it is said.
    let stranger = Command::new(env!("CARGO_BIN_EXE_orb"))
        .args(&again[..again.len()])
        .arg("--plan")
        .env("ORB_DATA_DIR", b.at("elsewhere"))
        .current_dir(b.at("."))
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&stranger.stderr).into_owned();
    assert!(stranger.status.success() && said.contains("not verified") && said.contains("TRUST"), "{said}");
    // Another seed is another run.
    let args = [&["train", &set, "--blocks", "2", "--parts", "parts", "--seed", "1", "-o", "no"], &BRIEF[..6]].concat();
    assert!(b.refused(&args).contains("--parts"));
    assert!(b.refused(&["train", &set, "--block", "1"]).contains("--blocks"));
    assert!(b.refused(&["train", &set, "--blocks", "2", "--exposure"]).contains("as a whole"));
}
