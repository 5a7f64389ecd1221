//! `--refine-poses`.

use super::*;

/// Turns every camera of a COLMAP model in text by about a degree, each about another axis.
fn disturbed(model: &Path) {
    let file = model.join("images.txt");
    let turned = |(i, line): (usize, &str)| {
        let mut words: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
        if words.len() == 10 {
            let k = 2 + i % 3;
            words[k] = (words[k].parse::<f64>().unwrap() + if i % 4 < 2 { 0.009 } else { -0.009 }).to_string();
        }
        words.join(" ")
    };
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(file, text.lines().enumerate().map(turned).collect::<Vec<_>>().join("\n") + "\n").unwrap();
}

#[test]
fn refined_poses_are_published_and_taken_again() {
    let b = Bench::new("1", "12", "96", &["--site", "--gps-noise", "0.2"]);
    let set = b.text("sets/00_site");
    let run = |out: &str, steps: &str, more: &[&str]| -> (Value, String) {
        let run =
            ["train", &set, "-o", out, "--json", "--sky", "off", "--iterations", steps, "--max-gaussians", "4000"];
        let done = b.orb(&[&run[..], &["--device", "cpu"], more].concat());
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        (serde_json::from_slice(&done.stdout).unwrap(), String::from_utf8_lossy(&done.stderr).into_owned())
    };
    // Poses that are right, and too few steps to find others: they stay, and it is said.
    let (told, said) = run("right", "60", &["--refine-poses"]);
    assert!(told["refining"]["by"] == "nothing" && told["refining"]["trial"].is_null(), "{}", told["refining"]);
    assert!(said.contains("warning: --refine-poses: poses stay as given") && !b.at("right/sparse").exists(), "{said}");
    let p = predicate(&b.at("right"));
    assert_eq!(
        (p["params"]["poses_refined"].clone(), p["params"]["poses_refined_by"].clone()),
        (false.into(), "nothing".into())
    );

    disturbed(&b.at("sets/00_site/sparse/0"));
    let (told, said) = run("out", "300", &["--refine-poses", "--refine-untried"]);
    let refining = &told["refining"];
    assert!(refining["by"] == "photos" && refining["trial"].is_null(), "{refining}");
    let moved = &refining["moved"]["all"];
    assert!(moved["most_deg"].as_f64().unwrap() > 0.2 && moved["most_shift"].as_f64().unwrap() < 0.2, "{moved}");
    assert!(moved["median_deg"].as_f64() < moved["most_deg"].as_f64() && !said.contains("stay as given"), "{said}");
    assert!(told["held_out_poses_fitted"]["psnr_db"].as_f64().unwrap() > 10.0);
    // The model has no observations.
    assert!(told["reprojection"]["before"].is_null() && told["reprojection"]["after"].is_null());
    let p = predicate(&b.at("out"));
    assert!(p["params"]["poses_refined"] == true && p["params"]["poses_refined_median_deg"].is_string());
    assert!(b.at("out/sparse/0/images.txt").is_file());
    b.good(&["audit", "verify", "out"]);
    let (again, _) = run("again", "60", &["--poses", &b.text("out/sparse/0")]);
    assert!(again["held_out_poses_fitted"].is_null() && again["trained_on"]["photos"] == 10, "{again}");
    assert!(again["refining"].is_null());
}
