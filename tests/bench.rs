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

/// Opaque balls of many colours, the same from everywhere.
fn balls() -> Vec<u8> {
    let n = 120;
    let turn = |i: usize, by: f32| (i as f32 * by).sin();
    let splats = orb_formats::ply::Splats {
        positions: (0..n).map(|i| [turn(i, 1.3), 0.6 * turn(i, 2.7), 0.8 * turn(i, 4.1)]).collect(),
        log_scales: (0..n).map(|i| [-2.4 + 0.3 * turn(i, 3.3); 3]).collect(),
        rotations: vec![[1.0, 0.0, 0.0, 0.0]; n],
        logit_opacities: vec![7.0; n],
        sh: (0..n)
            .map(|i| {
                std::array::from_fn(|k| if k == 0 { [1.7, 5.9, 3.7].map(|by| 1.5 * turn(i, by)) } else { [0.0; 3] })
            })
            .collect(),
    };
    orb_formats::ply::write(&splats, &[]).unwrap()
}

/// Cameras around, OpenCV's axes: rows of the rotation, and where each stands.
fn around(count: usize) -> Vec<([[f64; 3]; 3], [f64; 3])> {
    let one = |i: usize| {
        let (a, up) = (std::f64::consts::TAU * i as f64 / count as f64, 0.35f64);
        let at = [4.0 * up.cos() * a.cos(), 4.0 * up.cos() * a.sin(), 4.0 * up.sin()];
        let forward = at.map(|v| -v / 4.0);
        let right = [-a.sin(), a.cos(), 0.0];
        let cross = |p: [f64; 3], q: [f64; 3]| {
            [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
        };
        ([right, cross(forward, right), forward], at)
    };
    (0..count).map(one).collect()
}

/// w, x, y, z of a rotation by its rows.
fn quaternion(r: [[f64; 3]; 3]) -> [f64; 4] {
    let m = glam::DMat3::from_cols_array_2d(&r).transpose();
    let q = glam::DQuat::from_mat3(&m);
    [q.w, q.x, q.y, q.z]
}

/// One set of pictures in the layouts of NeRF's synthetic scenes and of COLMAP; a splat in the scenes' own frame, as other
/// programs train it, scores as the pictures' equal in both, and moved a little it does not.
#[test]
fn posed_pictures_of_others_are_read_as_they_mean_it() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let text = |name: &str| at(name).to_string_lossy().into_owned();
    let data = at("data");
    std::fs::write(at("balls.ply"), balls()).unwrap();
    let (size, focal) = (96, 130.0);
    let cameras = around(9);
    let shift = |(r, at): &([[f64; 3]; 3], [f64; 3])| r.map(|row| -(0..3).map(|k| row[k] * at[k]).sum::<f64>());
    let list: Vec<Value> = cameras
        .iter()
        .enumerate()
        .map(|(i, c)| {
            let t = shift(c);
            let rows: Vec<Vec<f64>> = (0..3).map(|k| [&c.0[k][..], &[t[k]]].concat()).collect();
            serde_json::json!({"name": format!("{i:04}"), "width": size, "height": size, "fx": focal, "fy": focal,
                "cx": size as f64 / 2.0, "cy": size as f64 / 2.0, "world_to_camera": rows})
        })
        .collect();
    std::fs::write(at("cameras.json"), serde_json::json!({"cameras": list}).to_string()).unwrap();
    for (scene, background) in [("nerf", "1,1,1"), ("colmap", "0,0,0")] {
        let pictures = if scene == "nerf" { "nerf" } else { "colmap/images" };
        std::fs::create_dir_all(at(pictures).parent().unwrap()).unwrap();
        let draw =
            ["render", &text("balls.ply"), "--camera", &text("cameras.json"), "-o", &text(pictures)].map(String::from);
        let more = ["--background", background, "--device", "cpu", "--quiet"].map(String::from);
        let words: Vec<&str> = draw.iter().chain(&more).map(String::as_str).collect();
        good(&orb(&data, &words));
    }
    // NeRF's: camera→world, x right, y up, z backwards.
    let frames: Vec<Value> = cameras
        .iter()
        .enumerate()
        .map(|(i, (r, at))| {
            let mut m: Vec<Vec<f64>> = (0..3).map(|k| vec![r[0][k], -r[1][k], -r[2][k], at[k]]).collect();
            m.push(vec![0.0, 0.0, 0.0, 1.0]);
            serde_json::json!({"file_path": format!("./{i:04}"), "transform_matrix": m})
        })
        .collect();
    let angle = 2.0 * (f64::from(size) / 2.0 / focal).atan();
    let list = serde_json::json!({"camera_angle_x": angle, "frames": frames}).to_string();
    std::fs::write(at("nerf/transforms_test.json"), list).unwrap();
    // COLMAP's: world→camera as a quaternion and a shift.
    std::fs::create_dir_all(at("colmap/sparse/0")).unwrap();
    let c = f64::from(size) / 2.0;
    std::fs::write(at("colmap/sparse/0/cameras.txt"), format!("1 PINHOLE {size} {size} {focal} {focal} {c} {c}\n"))
        .unwrap();
    let images: String = cameras
        .iter()
        .enumerate()
        .map(|(i, camera)| {
            let ([w, x, y, z], [a, b, c]) = (quaternion(camera.0), shift(camera));
            format!("{} {w} {x} {y} {z} {a} {b} {c} 1 {i:04}.png\n\n", i + 1)
        })
        .collect();
    std::fs::write(at("colmap/sparse/0/images.txt"), images).unwrap();
    std::fs::write(at("colmap/sparse/0/points3D.txt"), "").unwrap();

    let psnr = |results: &str| {
        let scenes = [text("nerf"), text("colmap")];
        let run = ["bench", "run", &scenes[0], &scenes[1], "--results", &text(results), "--no-speed", "--json"];
        let told: Value = serde_json::from_str(&good(&orb(&data, &run))).unwrap();
        [0, 1].map(|i| told["scenes"][i]["values"]["psnr"]["PSNR"].as_f64().unwrap_or_else(|| panic!("{told}")))
    };
    std::fs::create_dir(at("exact")).unwrap();
    std::fs::create_dir(at("moved")).unwrap();
    for scene in ["nerf", "colmap"] {
        std::fs::copy(at("balls.ply"), at("exact").join(format!("{scene}.ply"))).unwrap();
        let mut moved = orb_formats::ply::read(&balls()).unwrap().0;
        moved.positions.iter_mut().for_each(|p| p[0] += 0.03);
        std::fs::write(at("moved").join(format!("{scene}.ply")), orb_formats::ply::write(&moved, &[]).unwrap())
            .unwrap();
    }
    let (exact, moved) = (psnr("exact"), psnr("moved"));
    // Eight bits a channel leave 59 dB.
    assert!(exact.iter().all(|v| *v > 50.0), "{exact:?}");
    assert!(moved.iter().all(|v| *v < 35.0), "{moved:?}");
}
