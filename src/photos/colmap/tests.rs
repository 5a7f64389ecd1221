use std::path::PathBuf;

use super::*;

/// A model that COLMAP itself wrote (`tests/data/colmap/make_model.py`).
fn folder(kind: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/colmap").join(kind)
}

#[test]
fn text_and_binary_are_one_model() {
    let (text, binary) = (read(&folder("text")).unwrap(), read(&folder("binary")).unwrap());
    assert_eq!((text.cameras.len(), text.images.len(), text.points.len()), (12, 12, 1));
    assert_eq!(text.cameras, binary.cameras);
    for (a, b) in text.images.iter().zip(&binary.images) {
        assert_eq!((a.id, a.camera, &a.name, &a.observations), (b.id, b.camera, &b.name, &b.observations));
        assert!(a.rotation.angle_between(b.rotation) < 1e-7 && a.translation.distance(b.translation) < 1e-9);
    }
    let (a, b) = (&text.points[0], &binary.points[0]);
    assert_eq!((a.id, a.color, &a.track), (b.id, b.color, &b.track));
    assert_eq!((a.position, a.track.len()), (DVec3::new(0.5, -1.5, 4.0), 2));
    // Its own number is in its name, with a space before it.
    let one = text.images.iter().find(|i| i.name == "shots/simple_pinhole 1.jpg").unwrap();
    assert_eq!(one.observations, [([10.5, 20.25], Some(1)), ([30.0, 40.0], None)]);
    let turned = one.rotation * DVec3::Z;
    assert!((turned - DVec3::new(0.3f64.sin(), 0.0, 0.3f64.cos())).length() < 1e-9, "{turned}");
    let pinhole = one.pinhole(&text.cameras[&1]);
    assert_eq!((pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy, pinhole.width), (500.0, 500.0, 320.0, 240.0, 640));
}

#[test]
fn every_lens_puts_points_where_colmap_does() {
    let said: serde_json::Value = serde_json::from_slice(&std::fs::read(folder("projections.json")).unwrap()).unwrap();
    let pair = |v: &serde_json::Value| [v[0].as_f64().unwrap(), v[1].as_f64().unwrap()];
    let model = read(&folder("text")).unwrap();
    for camera in model.cameras.values() {
        let pixels = said["pixels"][camera.lens.name()].as_array().unwrap();
        for (ray, pixel) in said["rays"].as_array().unwrap().iter().zip(pixels) {
            let (found, expected) = (camera.project(pair(ray)), pair(pixel));
            let off = (found[0] - expected[0]).hypot(found[1] - expected[1]);
            assert!(off < 1e-6, "{}: {found:?} for {expected:?}", camera.lens.name());
        }
    }
}

#[test]
fn undistorted_pictures_show_what_a_pinhole_sees() {
    // A picture whose value is the undistorted x itself: distort a ramp, straighten it, and find the ramp.
    let camera = Camera { lens: Lens::Radial, width: 64, height: 48, parameters: vec![60.0, 32.0, 24.0, 0.15, 0.02] };
    let inverse = |x: f64, y: f64| {
        let (mut u, mut v) = ((x - 32.0) / 60.0, (y - 24.0) / 60.0);
        for _ in 0..50 {
            let p = camera.project([u, v]);
            (u, v) = (u + (x - p[0]) / 60.0, v + (y - p[1]) / 60.0);
        }
        u * 60.0 + 32.0
    };
    let bent = image::RgbImage::from_fn(64, 48, |x, y| {
        image::Rgb([(inverse(f64::from(x) + 0.5, f64::from(y) + 0.5) * 3.0) as u8; 3])
    });
    let straight = camera.undistorted(&bent);
    for x in 12..52 {
        let (found, expected) = (f64::from(straight.get_pixel(x, 30).0[0]), (f64::from(x) + 0.5) * 3.0);
        assert!((found - expected).abs() < 2.0, "{x}: {found} for {expected}");
    }
}

#[test]
fn faults_are_named_with_file_and_place() {
    let said = |cameras: &str, images: &str, points: &str| {
        let f = tempfile::tempdir().unwrap();
        for (name, text) in [("cameras", cameras), ("images", images), ("points3D", points)] {
            std::fs::write(f.path().join(format!("{name}.txt")), text).unwrap();
        }
        read(f.path()).map_or_else(|e| e.to_string(), |_| "read".into())
    };
    let camera = "# a comment\n1 PINHOLE 4 4 4 4 2 2\n";
    let image = "1 1 0 0 0 0 0 0 1 a b.png\n\n";
    assert_eq!(said(camera, image, ""), "read");
    for (cameras, images, points, expected) in [
        ("1 PINHOLE 4 4 4 4 2", image, "", "cameras.txt, line 1: expected the 4 parameters fx fy cx cy"),
        ("1 PINHOLE 4 4 4 4 2 2 9", image, "", "found more"),
        ("\n1 LENS 4 4 4 4 2 2", image, "", "line 2: expected one of SIMPLE_PINHOLE"),
        ("1 PINHOLE 4 4 -4 4 2 2", image, "", "focal lengths above 0"),
        ("1 PINHOLE 0 4 4 4 2 2", image, "", "width and height"),
        (camera, "1 1 0 0 0 0 0 0 2 a.png\n\n", "", "found camera 2"),
        (camera, "1 2 0 0 0 0 0 0 1 a.png\n\n", "", "images.txt, line 1: expected a unit quaternion"),
        (camera, "1 1 0 0 0 0 0 0 1\n\n", "", "a picture's name"),
        (camera, "1 1 0 0 0 0 0 0 1 a.png\n5 6\n", "", "images.txt, line 2: expected a point's number"),
        (camera, image, "1 0 0 0 1 2 300 0\n", "points3D.txt, line 1: expected a colour"),
        (camera, image, "1 0 0 nan 1 2 3 0\n", "a finite position"),
    ] {
        let found = said(cameras, images, points);
        assert!(found.contains(expected), "{found}\nshould say {expected}");
    }
    let e = read(Path::new("/nowhere")).unwrap_err().to_string();
    assert!(e.contains("cameras.bin or cameras.txt"), "{e}");
}

#[test]
fn cut_binary_files_are_refused_wherever_they_are_cut() {
    for (name, read_it) in [
        ("cameras.bin", (|f, b| binary::cameras(f, b).map(drop)) as fn(&str, &[u8]) -> Result<()>),
        ("images.bin", |f, b| binary::images(f, b).map(drop)),
        ("points3D.bin", |f, b| binary::points(f, b).map(drop)),
    ] {
        let bytes = std::fs::read(folder("binary").join(name)).unwrap();
        read_it(name, &bytes).unwrap();
        for n in 0..bytes.len() {
            let e = read_it(name, &bytes[..n]).unwrap_err().to_string();
            assert!(e.contains(&format!("{name}, byte ")), "{e}");
        }
        let e = read_it(name, &[&bytes[..], &[0]].concat()).unwrap_err().to_string();
        assert!(e.contains("1 more bytes"), "{e}");
        let mut many = bytes.clone();
        many[7] = 0x7f;
        assert!(read_it(name, &many).unwrap_err().to_string().contains("fit in the file"));
    }
}

#[test]
fn every_eighth_is_held_back() {
    let held: Vec<usize> = (0..20).filter(|i| is_test(*i)).collect();
    assert_eq!(held, [0, 8, 16]);
}

#[test]
fn what_is_written_reads_back() {
    let poses = crate::photos::poses::of_model(&folder("text")).unwrap();
    assert!(!poses.observations.is_empty());
    // Every pose a little elsewhere.
    let at: Vec<(DQuat, DVec3)> =
        poses.photos.iter().map(|p| (DQuat::from_rotation_x(0.1) * p.rotation, p.translation + DVec3::X)).collect();
    let points: Vec<DVec3> = poses.points.iter().map(|p| p.0).collect();
    let out = tempfile::tempdir().unwrap();
    for (name, text) in written(&poses, &at, &points) {
        std::fs::write(out.path().join(name), text).unwrap();
    }
    let back = crate::photos::poses::of_model(out.path()).unwrap();
    assert_eq!((&back.points, &back.observations), (&poses.points, &poses.observations));
    for (k, (a, b)) in back.photos.iter().zip(&poses.photos).enumerate() {
        assert_eq!((&a.name, &a.camera), (&b.name, &b.camera));
        assert!(a.rotation.angle_between(at[k].0) < 1e-7 && a.translation == at[k].1);
    }
}
