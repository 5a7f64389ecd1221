//! The main job as a user runs it: the binary, real photos, real folders.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// South-western hemisphere, and a heading for the container: signs that the README's command does not meet.
const ORIGIN: &str = "-54.8019,-68.3030,12.5";
const OF_THE_CONTAINER: [&str; 6] = ["--heading", "200", "--length", "6.06", "--seed", "5"];

fn samples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("samples")
}

/// One data folder (key, trust, ledger) for the whole test program.
fn data() -> &'static Path {
    static DATA: OnceLock<tempfile::TempDir> = OnceLock::new();
    DATA.get_or_init(|| tempfile::tempdir().unwrap()).path()
}

fn orb(args: &[&str]) -> Command {
    let mut c = Command::new(env!("CARGO_BIN_EXE_orb"));
    c.args(args).env("ORB_DATA_DIR", data());
    c
}

fn geo(photo: &Path, more: &[&str]) -> Command {
    let mut c = orb(&["geo", "--origin", ORIGIN, "--iterations", "4"]);
    c.arg(photo).args(more);
    c
}

fn text(out: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr))
}

/// Every path below `folder`, hidden ones too.
fn tree(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut all = Vec::new();
    let mut stack = vec![folder.to_owned()];
    while let Some(next) = stack.pop() {
        let Ok(entries) = std::fs::read_dir(&next) else { continue };
        for entry in entries.flatten() {
            let path = entry.path();
            if path.is_dir() {
                all.push((path.clone(), Vec::new()));
                stack.push(path);
            } else {
                all.push((path.clone(), std::fs::read(&path).unwrap()));
            }
        }
    }
    all.sort();
    all
}

/// Runs with a photo of these bytes in an empty folder; asserts the code and that nothing but the photo is left.
fn refuses(name: &str, bytes: &[u8], more: &[&str], code: i32, words: &str) {
    let dir = tempfile::tempdir().unwrap();
    let photo = dir.path().join(name);
    std::fs::write(&photo, bytes).unwrap();
    let out = dir.path().join("out");
    let mut args = vec!["-o", out.to_str().unwrap()];
    args.extend(more);
    let done = geo(&photo, &args).output().unwrap();
    let said = text(&done);
    assert_eq!(done.status.code(), Some(code), "{said}");
    assert!(said.contains(words), "expected «{words}» in: {said}");
    assert_eq!(tree(dir.path()).len(), 1, "left behind: {:?}", tree(dir.path()));
}

/// A container in every format, published once: looked at by outside readers too.
pub fn container() -> &'static Path {
    static DONE: OnceLock<(tempfile::TempDir, PathBuf)> = OnceLock::new();
    let (_, out) = DONE.get_or_init(|| {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("out");
        let formats = ["--format", "cdb,flt,glb,usdz,tiles3d,spz,splat-glb", "-o", out.to_str().unwrap()];
        let done = geo(&samples().join("shipping_container.jpg"), &[&OF_THE_CONTAINER[..], &formats].concat()).output();
        let done = done.unwrap();
        assert!(done.status.success(), "{}", text(&done));
        (dir, out)
    });
    out
}

/// A folder published once, looked at by many tests.
fn published() -> &'static Path {
    static DONE: OnceLock<tempfile::TempDir> = OnceLock::new();
    DONE.get_or_init(|| {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("out");
        // More triangles than a CDB model's finest level may have.
        let more = ["--format", "cdb,flt", "--triangles", "40000", "--stages", "-o", out.to_str().unwrap()];
        let done = geo(&samples().join("smart_car.jpg"), &more).output().unwrap();
        assert!(done.status.success(), "{}", text(&done));
        dir
    })
    .path()
}

#[test]
fn publishes_verifies_and_leaves_no_staging() {
    let top: Vec<String> =
        std::fs::read_dir(published()).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    assert_eq!(top, ["out"]);
    let out = published().join("out");
    for name in
        ["scene.ply", "preview.png", "orb-record.dsse.json", "smart_car.flt", "smart_car.cdb/Metadata/Version.xml"]
    {
        assert!(out.join(name).is_file(), "{name} is missing");
    }
    let verified = orb(&["audit", "verify"]).arg(&out).output().unwrap();
    assert!(verified.status.success(), "{}", text(&verified));
}

#[test]
fn stages_hand_over_the_mask_and_the_networks_gaussians() {
    let out = published().join("out");
    let mask = image::open(out.join("mask.png")).unwrap().into_luma8();
    let truth = image::open(samples().join("truth/smart_car/mask.png")).unwrap().into_rgba8();
    assert_eq!(mask.dimensions(), truth.dimensions());
    let pixels = mask.pixels().zip(truth.pixels()).map(|(a, b)| (a.0[0] > 127, b.0[3] > 127));
    let (both, any) = pixels.fold((0, 0), |(n, u), (a, b)| (n + u32::from(a && b), u + u32::from(a || b)));
    assert!(f64::from(both) > 0.9 * f64::from(any), "{both} of {any}");
    let read = |name: &str| orb_formats::ply::read(&std::fs::read(out.join(name)).unwrap()).unwrap();
    let ((before, comments), (after, after_comments)) = (read("network.ply"), read("scene.ply"));
    assert_eq!(comments, after_comments, "one frame for both");
    assert!(comments.iter().any(|c| c.starts_with("unit frame: centre ")), "{comments:?}");
    let middle = |s: &orb_formats::ply::Splats| {
        let n = s.positions.len() as f64;
        [0, 1, 2].map(|k| s.positions.iter().map(|p| f64::from(p[k])).sum::<f64>() / n)
    };
    let (a, b) = (middle(&before), middle(&after));
    assert!((0..3).all(|k| (a[k] - b[k]).abs() < 0.3), "{a:?} {b:?} metres");
}

#[test]
fn the_provenance_of_the_texture_lies_beside_the_model() {
    let out = published().join("out");
    let shares = image::open(out.join("texture_provenance.png")).unwrap().into_rgb8();
    assert!(shares.width() == shares.height() && shares.width() >= 512, "{:?}", shares.dimensions());
    let mut most = [0usize; 3];
    for pixel in shares.pixels() {
        let sum: i32 = pixel.0.iter().map(|v| i32::from(*v)).sum();
        assert!((sum - 255).abs() <= 2, "{:?} is not a whole", pixel.0);
        most[(0..3).max_by_key(|k| pixel.0[*k]).unwrap()] += 1;
    }
    // A car from the front and one side: the photo, its mirror image and the back each have their part.
    let all = (shares.width() * shares.height()) as usize;
    assert!(most.iter().all(|n| n * 10 > all), "invented, seen, mirrored: {most:?} of {all}");
    let params = params(&out);
    let number = |name: &str| params[name].as_str().unwrap().parse::<f64>().unwrap();
    let seen = number("texture_seen");
    // The picture also has the texels between the charts, in the colours of those beside them.
    assert!((seen - most[1] as f64 / all as f64).abs() < 0.12, "{seen} by the record, {most:?} of {all}");
    // The plane that was mirrored at, by all that it was judged by: it lies along the car, and each side meets the other.
    assert_eq!(params["symmetry_basis"], "evident");
    assert!((0.3..1.0).contains(&number("symmetry_extent_across_over_along")), "{params}");
    assert!((0.0..0.01).contains(&number("symmetry_far_from_its_image")), "{params}");
    // The far side's surface lies too deep: the plane goes away from the camera, by centimetres where that side is fog
    // (SplatNet 0.9), by less the firmer it is (0.14: 0.4 cm), or not at all (with DetailNet 0.5's mask). The container's does.
    assert!((-0.15..=0.0).contains(&number("symmetry_moved_m")), "{params}");
}

/// What the record of a published folder says of how it was made.
fn params(out: &Path) -> serde_json::Value {
    let shown = orb(&["audit", "show", "--json"]).arg(out).output().unwrap();
    let mut record: serde_json::Value = serde_json::from_slice(&shown.stdout).unwrap();
    record["predicate"]["params"].take()
}

/// A network may say how far its colours are off; 0.7 as it first came did not.
#[test]
fn the_expected_error_lies_beside_the_model_where_the_network_says_it() {
    use orb::models::{Engine, Rten, prior};
    let graph = Rten.load(prior::SPLAT.verified().unwrap()).unwrap();
    let says = graph.outputs().iter().any(|p| p.name == "error");
    let out = published().join("out");
    let picture = out.join("texture_expected_error.png");
    assert_eq!(picture.is_file(), says);
    let mean = params(&out)["expected_colour_error"].as_str().map(|v| v.parse::<f64>().unwrap());
    assert_eq!(mean.is_some(), says);
    if let Some(mean) = mean {
        let errors = image::open(picture).unwrap().into_luma8();
        let on_model = errors.pixels().map(|p| f64::from(p.0[0])).sum::<f64>() / errors.pixels().len() as f64 / 255.0;
        // Other sides and the texels between the charts count in the picture.
        assert!(mean > 0.01 && mean < 0.5 && (on_model / mean - 1.0).abs() < 0.5, "{mean}, {on_model} on the model");
    }
}

/// `orb reconstruct`, which has no place to be told: how the camera looked it can be told all the same, and what lens it had the
/// photo says.
#[test]
fn gaussians_alone_are_published_as_seen_from_where_the_camera_looked() {
    let dir = tempfile::tempdir().unwrap();
    let made_of = |photo: &Path, name: &str, more: &[&str]| {
        let out = dir.path().join(name);
        let mut run = orb(&["reconstruct", "--iterations", "0", "--quiet", "-o"]);
        let done = run.arg(&out).arg(photo).args(more).output().unwrap();
        assert!(done.status.success(), "{}", text(&done));
        out
    };
    let made = |name: &str, more: &[&str]| made_of(&samples().join("smart_car.jpg"), name, more);
    let (seen, told) = (made("seen", &[]), made("told", &["--pitch", "-30"]));
    let files: Vec<String> = tree(&told).iter().map(|(p, _)| p.file_name().unwrap().to_str().unwrap().into()).collect();
    assert!(files.iter().all(|f| f.starts_with("orb-") || ["scene.ply", "preview.png"].contains(&&**f)), "{files:?}");
    let verified = orb(&["audit", "verify"]).arg(&told).output().unwrap();
    assert!(verified.status.success(), "{}", text(&verified));
    assert_eq!(params(&told)["pitch_given_deg"], "-30");
    assert!(params(&seen)["pitch_given_deg"].is_null());
    // What it is told counts.
    let scene = |out: &Path| std::fs::read(out.join("scene.ply")).unwrap();
    assert_ne!(scene(&seen), scene(&told));
    let lens = (exif::Tag::FocalLengthIn35mmFilm, exif::Value::Short(vec![90]));
    let long = made_of(&crate::place::photo(dir.path(), &[lens], None), "long", &[]);
    assert_ne!(scene(&seen), scene(&long));
    let said = made("said", &["--focal", "90"]);
    assert!(scene(&said) == scene(&long) && params(&said)["focal_given_35mm"] == "90");
    let refused = orb(&["reconstruct", "--pitch", "-91"]).arg(samples().join("smart_car.jpg")).output().unwrap();
    assert!(refused.status.code() == Some(2) && text(&refused).contains("--pitch"), "{}", text(&refused));
}

#[test]
fn one_changed_byte_anywhere_is_found_and_named() {
    let copy = tempfile::tempdir().unwrap();
    let out = published().join("out");
    for (path, bytes) in tree(&out) {
        let to = copy.path().join(path.strip_prefix(&out).unwrap());
        if path.is_dir() {
            std::fs::create_dir_all(&to).unwrap();
        } else {
            std::fs::create_dir_all(to.parent().unwrap()).unwrap();
            std::fs::write(&to, bytes).unwrap();
        }
    }
    let files: Vec<_> = tree(copy.path()).into_iter().filter(|(p, _)| p.is_file()).collect();
    assert!(files.len() > 50);
    // Every kind of file and every seventh of the many tiles.
    for (i, (path, bytes)) in files.iter().enumerate() {
        if path.components().count() > copy.path().components().count() + 2 && i % 7 != 0 {
            continue;
        }
        let mut changed = bytes.clone();
        let middle = changed.len() / 2;
        match changed.get_mut(middle) {
            Some(byte) => *byte ^= 1,
            None => changed.push(0),
        }
        std::fs::write(path, &changed).unwrap();
        let verified = orb(&["audit", "verify"]).arg(copy.path()).output().unwrap();
        std::fs::write(path, bytes).unwrap();
        let said = text(&verified);
        assert_eq!(verified.status.code(), Some(1), "{}: {said}", path.display());
        let name = path.file_name().unwrap().to_str().unwrap();
        assert!(said.contains(name), "{name} is not named in: {said}");
    }
}

#[test]
fn refuses_what_is_no_photo() {
    refuses("notes.jpg", b"these are words, not pixels", &[], 2, "notes.jpg");
    refuses("empty.jpg", b"", &[], 2, "empty.jpg");
    let jpeg = std::fs::read(samples().join("smart_car.jpg")).unwrap();
    refuses("cut.jpg", &jpeg[..jpeg.len() / 2], &[], 2, "cut.jpg");
}

#[test]
fn refuses_photos_without_a_subject() {
    let png = |w: u32, h: u32| {
        let mut bytes = std::io::Cursor::new(Vec::new());
        image::RgbImage::from_pixel(w, h, image::Rgb([255; 3])).write_to(&mut bytes, image::ImageFormat::Png).unwrap();
        bytes.into_inner()
    };
    refuses("dot.png", &png(1, 1), &[], 2, "dot.png");
    refuses("white.png", &png(640, 480), &[], 2, "no subject");
}

#[test]
fn refuses_wrong_arguments() {
    let jpeg = std::fs::read(samples().join("smart_car.jpg")).unwrap();
    for (args, words) in [
        (["--origin", "91,0,0"], "latitude"),
        (["--origin", "NaN,0,0"], "NaN"),
        (["--heading", "inf"], "--heading"),
        (["--pitch", "91"], "--pitch"),
        (["--focal", "0"], "--focal"),
        (["--height", "-2"], "--height"),
        (["--facc", "nothing"], "--facc"),
        (["--format", "step"], "step"),
    ] {
        refuses("car.jpg", &jpeg, &args, 2, words);
    }
    refuses("car.jpg", &jpeg, &["--classification", "TOP SECRET//SI"], 4, "MARKING_UNSUPPORTED");
    refuses("car.jpg", &jpeg, &["--classification", "SECRET"], 4, "--key");
}

#[test]
fn a_folder_that_cannot_be_written_is_said_before_the_work() {
    let began = Instant::now();
    let done = geo(&samples().join("smart_car.jpg"), &["-o", "/proc/orb-out"]).output().unwrap();
    assert_eq!(done.status.code(), Some(5), "{}", text(&done));
    assert!(text(&done).contains("/proc"), "{}", text(&done));
    assert!(began.elapsed() < Duration::from_secs(10));
}

#[test]
fn a_folder_that_is_in_use_is_left_alone() {
    let dir = tempfile::tempdir().unwrap();
    let mine = dir.path().join("mine.txt");
    std::fs::write(&mine, "mine").unwrap();
    let done =
        geo(&samples().join("smart_car.jpg"), &["-o", dir.path().to_str().unwrap(), "--replace"]).output().unwrap();
    assert_eq!(done.status.code(), Some(2), "{}", text(&done));
    assert_eq!(tree(dir.path()), [(mine, b"mine".to_vec())]);
}

/// A disk of 1 MiB: needs a mount of its own, so Linux and root; says so where it cannot run.
#[test]
fn a_full_disk_is_an_error_that_leaves_nothing() {
    let dir = tempfile::tempdir().unwrap();
    let script = format!(
        "mount -t tmpfs -o size=1m tmpfs {0} || exit 77; {1} geo --origin {ORIGIN} --iterations 4 {3} {2} -o {0}/out; code=$?; ls -A {0} | wc -l; exit $code",
        dir.path().display(),
        env!("CARGO_BIN_EXE_orb"),
        samples().join("smart_car.jpg").display(),
        crate::SMALL.join(" "),
    );
    let Ok(done) = Command::new("unshare").args(["-m", "sh", "-c", &script]).env("ORB_DATA_DIR", data()).output()
    else {
        return skip("no unshare");
    };
    if matches!(done.status.code(), Some(77 | 1)) && !text(&done).contains("orb:") {
        return skip(&text(&done));
    }
    assert_eq!(done.status.code(), Some(5), "{}", text(&done));
    assert!(text(&done).contains("out/"), "the file is not named: {}", text(&done));
    assert_eq!(String::from_utf8_lossy(&done.stdout).lines().last(), Some("0"), "{}", text(&done));
}

fn skip(reason: &str) {
    assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "cannot run: {reason}");
    eprintln!("skipped: {reason}");
}

/// Interrupts at several moments of a run: every one ends with 130 and an empty folder.
#[cfg(unix)]
#[test]
fn an_interrupt_leaves_nothing() {
    let mut stopped = 0;
    for wait in [200, 900, 2500, 5000, 9000] {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("out");
        let mut child = orb(&["geo", "--origin", ORIGIN, "--iterations", "100000", "-q"])
            .arg(samples().join("smart_car.jpg"))
            .args(["-o", out.to_str().unwrap()])
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(wait));
        let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        assert!(sent.success());
        let began = Instant::now();
        let status = loop {
            match child.try_wait().unwrap() {
                Some(status) => break status,
                None if began.elapsed() > Duration::from_secs(60) => {
                    panic!("still running a minute after the interrupt")
                }
                None => std::thread::sleep(Duration::from_millis(50)),
            }
        };
        assert!(tree(dir.path()).is_empty(), "after {wait} ms: {:?}", tree(dir.path()));
        // An interrupt before the handler stands ends the program the system's way, with as little left.
        stopped += usize::from(status.code() == Some(130));
    }
    assert!(stopped >= 3);
}

#[test]
fn a_second_model_joins_a_store_with_the_bytes_it_has_alone_and_a_failure_leaves_it_alone() {
    let dir = tempfile::tempdir().unwrap();
    let store = dir.path().join("store");
    let from = published().join("out/smart_car.cdb");
    for (path, bytes) in tree(&from) {
        let to = store.join(path.strip_prefix(&from).unwrap());
        if path.is_dir() {
            std::fs::create_dir_all(&to).unwrap();
        } else {
            std::fs::create_dir_all(to.parent().unwrap()).unwrap();
            std::fs::write(&to, bytes).unwrap();
        }
    }
    let before = tree(&store);
    let args = [&OF_THE_CONTAINER[..], &["--cdb", store.to_str().unwrap(), "-o"]].concat();
    let bad = dir.path().join("bad.jpg");
    std::fs::write(&bad, b"words").unwrap();
    let out = dir.path().join("bad");
    let failed = geo(&bad, &args).arg(&out).output().unwrap();
    assert_eq!(failed.status.code(), Some(2));
    assert_eq!(tree(&store), before);

    let out = dir.path().join("out");
    let done = geo(&samples().join("shipping_container.jpg"), &args).arg(&out).output().unwrap();
    assert!(done.status.success(), "{}", text(&done));
    let after = tree(&store);
    for (path, _) in &before {
        assert!(after.iter().any(|(p, _)| p == path), "{} is gone", path.display());
    }
    let named = |name: &str| after.iter().any(|(p, b)| p.extension().is_some_and(|e| e == "dbf") && contains(b, name));
    assert!(named("smart_car") && named("shipping_container"));
    let verified = orb(&["audit", "verify"]).arg(&out).output().unwrap();
    assert_ne!(verified.status.code(), Some(1), "{}", text(&verified));
    // The same photo, place and seed as where it was published alone. The store's tables carry the day; what is free of the
    // clock must be equal.
    let read = |out: &Path| ["scene.ply", "preview.png"].map(|name| std::fs::read(out.join(name)).unwrap());
    assert!(read(&out) == read(container()));
    for out in [&*out, container()] {
        // Of the planes that it was mirrored at none came nearer to the camera, and one went away from it.
        let params = params(out);
        let moved = ["symmetry_moved_m", "symmetry_second_moved_m"]
            .map(|plane| params[plane].as_str().unwrap().parse::<f64>().unwrap());
        assert!(moved.iter().all(|m| (-0.15..=0.0).contains(m)), "{params}");
        assert!(moved.iter().any(|m| *m < -0.001), "{params}");
    }
}

fn contains(bytes: &[u8], needle: &str) -> bool {
    bytes.windows(needle.len()).any(|w| w == needle.as_bytes())
}

#[test]
fn pictures_of_a_published_scene_are_sealed_and_never_marked_lower() {
    let dir = tempfile::tempdir().unwrap();
    let scene = published().join("out/scene.ply");
    let out = dir.path().join("pictures");
    let render = |scene: &Path, out: &Path, more: &[&str]| {
        let mut c = orb(&["render", "--turntable", "2", "--size", "64", "--depth", "--device", "cpu", "-o"]);
        c.arg(out).arg(scene).args(more).output().unwrap()
    };
    let done = render(&scene, &out, &[]);
    assert!(done.status.success(), "{}", text(&done));
    for name in ["0000.png", "0001_depth.png", "frames.json", "orb-record.dsse.json"] {
        assert!(out.join(name).is_file(), "{name} is missing");
    }
    let verified = orb(&["audit", "verify"]).arg(&out).output().unwrap();
    assert!(verified.status.success(), "{}", text(&verified));

    let secret = dir.path().join("secret.ply");
    let bytes = std::fs::read(&scene).unwrap();
    let at = bytes.windows(12).position(|w| w == b"UNCLASSIFIED").unwrap();
    std::fs::write(&secret, [&bytes[..at], b"SECRET", &bytes[at + 12..]].concat()).unwrap();
    let lower = render(&secret, &dir.path().join("lower"), &["--classification", "UNCLASSIFIED"]);
    assert_eq!(lower.status.code(), Some(4), "{}", text(&lower));
    assert!(!dir.path().join("lower").exists());
}
