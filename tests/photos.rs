//! `orb geo` and `orb reconstruct` of a folder of photos, from the outside, on photos whose truth is known.

use std::path::Path;

use crate::sets::{Bench, json};
use serde_json::Value;

fn record(folder: &Path) -> Value {
    let envelope = json(&folder.join("orb-record.dsse.json"));
    use base64::Engine;
    let payload = base64::engine::general_purpose::STANDARD.decode(envelope["payload"].as_str().unwrap()).unwrap();
    serde_json::from_slice(&payload).unwrap()
}

/// The model stands where the truth says, so many metres off across and up at most, by the photos' own place.
fn stands(told: &Value, truth: &Value, [across, up]: [f64; 2]) {
    let g = &told["georeference"];
    let off = |name: &str, metres: f64| (g[name].as_f64().unwrap() - truth[name].as_f64().unwrap()) * metres;
    let found = off("latitude", 111_200.0).hypot(off("longitude", 74_300.0));
    assert!(found < across && off("ellipsoidal_height_m", 1.0).abs() < up, "{g}");
    let sources = [&g["heading_source"], &told["scale"]["source"]];
    assert_eq!(sources, ["georegistration"; 2]);
}

/// Metres of a unit of the world that the poses are in.
fn metres_of_the_world(told: &Value, predicate: &Value) -> f64 {
    let said = predicate["params"]["world_to_unit"].as_str().unwrap();
    let unit: f64 = said.split_whitespace().nth(1).unwrap().parse().unwrap();
    told["scale"]["metres_per_unit"].as_f64().unwrap() * unit
}

#[test]
fn posed_photos_become_a_model_at_their_place_on_the_earth() {
    let b = Bench::new("2", "9", "256", &["--gps-noise", "0.2"]);
    let photos = b.text("sets/01_van/photos");
    let made =
        ["geo", &photos, "--format", "glb", "--iterations", "60", "--lods", "1", "--texture", "256", "--device", "cpu"];
    let told: Value = serde_json::from_str(&b.good(&[&made[..], &["--json", "-o", "van"]].concat())).unwrap();
    b.good(&["audit", "verify", "van"]);
    let truth = json(&b.at("sets/01_van/truth/cameras.json"));
    // GPS of 0.2 m in nine photos, and a mesh whose middle is a little off.
    stands(&told, &truth, [0.5, 0.8]);
    // The reference looks along +Y: its true bearing is that of its axis to the origin, turned by the set's heading.
    let p = &record(&b.at("van"))["predicate"];
    let params = &p["params"];
    let reference = params["reference_photo"].as_str().unwrap().trim_end_matches(".png").to_owned();
    let view = truth["views"].as_array().unwrap().iter().find(|v| v["name"] == reference.as_str()).unwrap();
    let row = |i: usize, k: usize| view["w2c_opencv"][i][k].as_f64().unwrap();
    let eye = |k: usize| -(0..3).map(|i| row(i, k) * row(i, 3)).sum::<f64>();
    let bearing = (-eye(0)).atan2(-eye(1)).to_degrees() + truth["heading_deg"].as_f64().unwrap();
    let turned = (told["georeference"]["heading_deg"].as_f64().unwrap() - bearing + 540.0).rem_euclid(360.0) - 180.0;
    assert!(turned.abs() < 4.0, "{turned}");
    // The size: one unit of COLMAP's world is 2.70 m.
    let metres = metres_of_the_world(&told, p);
    let ratio = metres / truth["metres_per_world_unit"].as_f64().unwrap();
    assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
    // Every photo and every file of poses is an input, by its hash; two photos of nine are held out.
    let inputs = p["inputs"].as_array().unwrap();
    assert_eq!(inputs.iter().filter(|i| i["role"] == "photo").count(), 9);
    assert_eq!(inputs.iter().filter(|i| i["role"] == "poses").count(), 3);
    let several = &told["several_photos"];
    let (trained, held_out) = (&several["trained_on"], &several["held_out"]);
    assert!(held_out["photos"].as_u64().unwrap() >= 1, "{several}");
    assert!(trained["psnr_db"].as_f64().unwrap() > 25.0 && held_out["psnr_db"].as_f64().unwrap() > 20.0, "{several}");
    assert!(held_out["silhouette_iou"].as_f64().unwrap() > 0.85, "{several}");

    // Without poses, with what only one photo can use, one photo in a folder.
    let alone = b.text("alone");
    std::fs::create_dir(&alone).unwrap();
    for i in 1..7 {
        let name = format!("{i:02}.png");
        std::fs::copy(b.at("sets/01_van/photos").join(&name), b.at("alone").join(&name)).unwrap();
    }
    assert!(b.refused(&["geo", &alone]).contains("poses of the photos"));
    assert!(b.refused(&["geo", &photos, "--mask", "x.png"]).contains("--mask"));
    assert!(b.refused(&["geo", &photos, "--pitch", "-30"]).contains("--pitch"));
    assert!(b.refused(&["reconstruct", &photos, "--pitch", "-30"]).contains("--pitch"));
    assert!(b.refused(&["geo", &photos, "--focal", "26"]).contains("--focal"));
    assert!(b.refused(&["geo", &b.text("alone/01.png"), "--poses", "x"]).contains("--poses"));
    for i in 2..7 {
        std::fs::remove_file(b.at("alone").join(format!("{i:02}.png"))).unwrap();
    }
    assert!(b.refused(&["reconstruct", &alone]).contains("at least two photos"));
}

/// Cut-outs and Nerfstudio's file of the truth's cameras, in a world that is turned, moved and three times too small, and pixels of
/// five points of the van whose place is known.
fn nerf_with_control(b: &Bench, to: &Path) {
    use glam::{DMat3, DMat4, DQuat, DVec3, DVec4};
    use orb::geo::{Geodetic, HeadingSource, Placement};
    let truth = json(&b.at("sets/01_van/truth/cameras.json"));
    let number = |name: &str| truth[name].as_f64().unwrap();
    let origin = Geodetic {
        latitude: number("latitude"),
        longitude: number("longitude"),
        height: number("ellipsoidal_height_m"),
    };
    let van = Placement { origin, heading: number("heading_deg"), heading_source: HeadingSource::Given };
    let size: Vec<f64> = serde_json::from_value(truth["size_m"].clone()).unwrap();
    let (turn, scale, shift) =
        (DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 0.5).normalize(), 1.1), 0.37, DVec3::new(5.0, -3.0, 2.0));
    std::fs::create_dir_all(to.join("images")).unwrap();
    let (mut frames, mut lines) = (Vec::new(), vec!["point,latitude,longitude,height,photo,x,y,sigma".to_owned()]);
    let (mut file, corners) = (
        serde_json::json!({}),
        [[0.5, 0.5, 0.0], [-0.5, 0.5, 0.0], [0.5, -0.5, 0.0], [-0.5, -0.5, 1.0], [0.0, 0.0, 1.0]],
    );
    for view in truth["views"].as_array().unwrap() {
        let rows: [[f64; 4]; 4] = serde_json::from_value(view["w2c_opencv"].clone()).unwrap();
        let w2c = DMat4::from_cols_array_2d(&rows).transpose();
        let c2w = w2c.inverse();
        let axes = DMat3::from_quat(turn) * DMat3::from_mat4(c2w) * DMat3::from_diagonal(DVec3::new(1.0, -1.0, -1.0));
        let at = scale * (turn * c2w.w_axis.truncate()) + shift;
        let name = format!("{}.png", view["name"].as_str().unwrap());
        let row = |i: usize| DVec4::new(axes.col(0)[i], axes.col(1)[i], axes.col(2)[i], at[i]).to_array();
        frames.push(serde_json::json!({
            "file_path": format!("images/{name}"), "transform_matrix": [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]],
        }));
        // Anew, cut out, and without the place that the made photo carries.
        let open = |folder: &str| image::open(b.at("sets/01_van").join(folder).join(&name)).unwrap();
        let (mut photo, mask) = (open("photos").into_rgba8(), open("truth/masks").into_luma8());
        photo.pixels_mut().zip(mask.pixels()).for_each(|(p, m)| p.0[3] = m.0[0]);
        photo.save(to.join("images").join(&name)).unwrap();
        let of = |name: &str| view[name].as_f64().unwrap();
        file = serde_json::json!({ "fl_x": of("fx"), "fl_y": of("fy"), "cx": of("cx"), "cy": of("cy"), "w": of("width"), "h": of("height") });
        for (i, corner) in corners.iter().enumerate() {
            let p = DVec3::new(corner[0] * size[0], corner[1] * size[1], corner[2] * size[2]);
            let (g, q) = (van.to_geodetic(p.to_array()), w2c.transform_point3(p));
            let (x, y) = (of("fx") * q.x / q.z + of("cx"), of("fy") * q.y / q.z + of("cy"));
            lines.push(format!("P{i},{:.9},{:.9},{:.4},{name},{x:.2},{y:.2},0.02", g.latitude, g.longitude, g.height));
        }
    }
    file["frames"] = frames.into();
    std::fs::write(to.join("transforms.json"), file.to_string()).unwrap();
    std::fs::write(to.join("control.csv"), lines.join("\n")).unwrap();
}

#[test]
fn control_points_place_photos_that_know_nothing_of_the_earth() {
    let b = Bench::new("2", "6", "256", &[]);
    nerf_with_control(&b, &b.at("nerf"));
    let (images, poses, control) = (b.text("nerf/images"), b.text("nerf/transforms.json"), b.text("nerf/control.csv"));
    let made = [
        "geo",
        &images,
        "--poses",
        &poses,
        "--format",
        "glb",
        "--iterations",
        "20",
        "--lods",
        "1",
        "--texture",
        "256",
        "--device",
        "cpu",
    ];
    assert!(b.refused(&[&made[..], &["-o", "no"]].concat()).contains("--origin"), "no control points, no place");
    let all = std::fs::read_to_string(&control).unwrap();
    let one: Vec<&str> = all.lines().filter(|l| l.starts_with("point") || l.starts_with("P0")).collect();
    std::fs::write(b.at("one.csv"), one.join("\n")).unwrap();
    let refused = b.refused(&[&made[..], &["-o", "no", "--gcp", &b.text("one.csv")]].concat());
    assert!(refused.contains("two control points or more"), "{refused}");

    let told: Value =
        serde_json::from_str(&b.good(&[&made[..], &["--gcp", &control, "--json", "-o", "van"]].concat())).unwrap();
    b.good(&["audit", "verify", "van"]);
    let truth = json(&b.at("sets/01_van/truth/cameras.json"));
    stands(&told, &truth, [0.4, 0.3]);
    // The world is 0.37 of the truth's metres.
    let p = &record(&b.at("van"))["predicate"];
    let metres = metres_of_the_world(&told, p);
    assert!((metres * 0.37 - 1.0).abs() < 0.005, "{metres}");
    let roles: Vec<&str> = p["inputs"].as_array().unwrap().iter().map(|i| i["role"].as_str().unwrap()).collect();
    assert!(roles.contains(&"control-points") && roles.contains(&"poses"), "{roles:?}");
}
