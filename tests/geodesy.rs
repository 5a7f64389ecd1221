//! Geodesy against GeographicLib's programs, 100,000 points at a time.

use std::io::Write;
use std::process::{Command, Stdio};

use orb::geo::{Ecef, Enu, Geodetic, Utm, mgrs};

const POINTS: usize = 100_000;

/// A seeded row of numbers in [0, 1): SplitMix64 (Steele, Lea and Flood 2014).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Poles and their surroundings, the equator, the antimeridian, zone and band borders, below ground, 1,000 km up, and
/// random points in between.
fn points() -> Vec<Geodetic> {
    let latitudes = [
        -90.0,
        -89.999_999_9,
        -80.0,
        -79.999,
        -45.0,
        -1e-7,
        0.0,
        1e-7,
        56.0,
        63.9,
        72.0,
        83.999,
        84.0,
        89.999_999_9,
        90.0,
    ];
    let longitudes = [-180.0, -179.999_999_9, -174.0, -90.0, -1e-7, 0.0, 2.999, 3.0, 9.0, 42.0, 90.0, 179.999_999_9];
    let heights = [-10_994.0, -400.0, 0.0, 8_849.0, 1_000_000.0];
    let mut all = Vec::new();
    for latitude in latitudes {
        for longitude in longitudes {
            all.extend(heights.map(|height| Geodetic { latitude, longitude, height }));
        }
    }
    let mut numbers = Numbers(8);
    while all.len() < POINTS {
        let i = all.len();
        // Every eighth point near a pole, every eighth near the antimeridian, the rest uniform on the sphere.
        let latitude = if i % 8 == 0 {
            (90.0 - 10f64.powf(numbers.between(-9.0, 1.0))).copysign(numbers.next() - 0.5)
        } else {
            numbers.between(-1.0, 1.0).asin().to_degrees()
        };
        let longitude = if i % 8 == 1 {
            (180.0 - 10f64.powf(numbers.between(-9.0, 0.0))).copysign(numbers.next() - 0.5)
        } else {
            numbers.between(-180.0, 180.0)
        };
        let height = if i % 2 == 0 { numbers.between(-11_000.0, 9_000.0) } else { numbers.between(0.0, 1_000_000.0) };
        all.push(Geodetic { latitude, longitude, height });
    }
    all
}

/// What the program answers, line by line; `None` where it is not installed and not required.
fn ask(program: &str, args: &[&str], lines: String) -> Option<Vec<String>> {
    let child = Command::new(program).args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
    let Ok(mut child) = child else {
        assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "cannot run: {program} is not installed");
        eprintln!("skipped: {program} is not installed (apt-get install geographiclib-tools)");
        return None;
    };
    let mut input = child.stdin.take().unwrap();
    let writer = std::thread::spawn(move || input.write_all(lines.as_bytes()).unwrap());
    let out = child.wait_with_output().unwrap();
    writer.join().unwrap();
    let text = String::from_utf8(out.stdout).unwrap();
    Some(text.lines().map(str::to_owned).collect())
}

fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace().map(|w| w.parse().unwrap_or_else(|_| panic!("{line}"))).collect()
}

fn lines(rows: impl Iterator<Item = String>) -> String {
    rows.map(|r| r + "\n").collect()
}

/// Written as text with so many digits that reading gives the same number back.
fn exact(v: f64) -> String {
    format!("{v:.17}")
}

/// Metres, not less, between two points of which the second is latitude, longitude and height. A degree is 111.7 km and,
/// 1,000 km up, 1.16 times that.
fn apart(a: Geodetic, b: &[f64]) -> f64 {
    let east = orb::geo::normalised_longitude(a.longitude - b[1]) * b[0].to_radians().cos();
    ((a.latitude - b[0]) * 111_700.0).hypot(east * 111_700.0 * 1.16).hypot(a.height - b[2])
}

#[test]
fn earth_centred_coordinates_agree() {
    let all = points();
    let asked = lines(all.iter().map(|g| [g.latitude, g.longitude, g.height].map(exact).join(" ")));
    let Some(answers) = ask("CartConvert", &["-p", "10"], asked) else { return };
    assert_eq!(answers.len(), all.len());
    let mut worst = 0f64;
    for (g, line) in all.iter().zip(&answers) {
        let (ours, theirs) = (g.to_ecef(), numbers(line));
        let off = (ours.x - theirs[0]).hypot(ours.y - theirs[1]).hypot(ours.z - theirs[2]);
        worst = worst.max(off);
        assert!(off < 1e-8, "{g:?}: {off} m");
    }
    eprintln!("geodetic -> earth-centred: {} points, at most {worst:.2e} m apart", all.len());
}

#[test]
fn geodetic_coordinates_agree() {
    let all: Vec<Ecef> = points().iter().map(|g| g.to_ecef()).collect();
    let asked = lines(all.iter().map(|e| [e.x, e.y, e.z].map(exact).join(" ")));
    let Some(answers) = ask("CartConvert", &["-r", "-p", "10"], asked) else { return };
    let mut worst = 0f64;
    for (e, line) in all.iter().zip(&answers) {
        let off = apart(e.to_geodetic(), &numbers(line));
        worst = worst.max(off);
        assert!(off < 1e-8, "{e:?}: {off} m");
    }
    eprintln!("earth-centred -> geodetic: {} points, at most {worst:.2e} m apart", all.len());
}

/// Around origins of every kind, near them and on the far side of the Earth, there and back.
#[test]
fn local_coordinates_agree_both_ways() {
    let origins = [
        (34.5523, -118.4712, 740.0),
        (90.0, 0.0, 0.0),
        (-90.0, 42.0, 2_800.0),
        (0.0, 180.0, -400.0),
        (0.0, 0.0, 0.0),
        (-17.7, -179.999_999_9, -10_994.0),
        (51.5, 1e-9, 1_000_000.0),
        (-89.999_999_9, -90.0, 8_849.0),
    ];
    let all = points();
    let (mut worst, mut reverse, mut at) = (0f64, 0f64, Numbers(3));
    for (n, (latitude, longitude, height)) in origins.into_iter().enumerate() {
        let origin = Geodetic { latitude, longitude, height };
        let frame = origin.frame();
        // Half of them within 50 km.
        let share: Vec<Geodetic> = (n..POINTS)
            .step_by(origins.len())
            .map(|i| {
                let near =
                    Enu { east: at.between(-5e4, 5e4), north: at.between(-5e4, 5e4), up: at.between(-500.0, 5_000.0) };
                if i / origins.len() % 2 == 0 { all[i] } else { origin.offset(near) }
            })
            .collect();
        let place = [latitude, longitude, height].map(exact);
        let args = ["-l", &place[0], &place[1], &place[2], "-p", "10"];
        let asked = lines(share.iter().map(|g| [g.latitude, g.longitude, g.height].map(exact).join(" ")));
        let Some(answers) = ask("CartConvert", &args, asked) else { return };
        let mut locals = Vec::new();
        for (g, line) in share.iter().zip(&answers) {
            let (ours, theirs) = (frame.to_enu(g.to_ecef()), numbers(line));
            let off = (ours.east - theirs[0]).hypot(ours.north - theirs[1]).hypot(ours.up - theirs[2]);
            worst = worst.max(off);
            assert!(off < 1e-8, "{origin:?} {g:?}: {off} m");
            locals.push(ours);
        }
        let asked = lines(locals.iter().map(|e| [e.east, e.north, e.up].map(exact).join(" ")));
        let answers = ask("CartConvert", &[&["-r"], &args[..]].concat(), asked).unwrap();
        for (e, line) in locals.iter().zip(&answers) {
            let off = apart(origin.offset(*e), &numbers(line));
            reverse = reverse.max(off);
            assert!(off < 1e-8, "{origin:?} {e:?}: {off} m");
        }
    }
    eprintln!("geodetic -> east, north, up: {POINTS} points, at most {worst:.2e} m apart");
    eprintln!("east, north, up -> geodetic: {POINTS} points, at most {reverse:.2e} m apart");
}

#[test]
fn utm_and_ups_agree_both_ways() {
    let all = points();
    let asked = lines(all.iter().map(|g| [g.latitude, g.longitude].map(exact).join(" ")));
    let Some(answers) = ask("GeoConvert", &["-u", "-p", "9"], asked) else { return };
    let (mut worst, mut reverse) = (0f64, String::new());
    let mut grid = Vec::new();
    for (g, line) in all.iter().zip(&answers) {
        let ours = Utm::of(g.latitude, g.longitude);
        let (name, rest) = line.split_once(' ').unwrap();
        let hemisphere = if ours.north { "n" } else { "s" };
        let expected = if ours.zone == 0 { hemisphere.to_owned() } else { format!("{:02}{hemisphere}", ours.zone) };
        assert_eq!(name, expected, "{g:?}: {line}");
        let theirs = numbers(rest);
        let off = (ours.easting - theirs[0]).hypot(ours.northing - theirs[1]);
        worst = worst.max(off);
        assert!(off < 1e-8, "{g:?}: {off} m, {ours:?}, {line}");
        reverse += &format!("{name} {} {}\n", exact(ours.easting), exact(ours.northing));
        grid.push(ours);
    }
    eprintln!("geodetic -> UTM and UPS: {} points, at most {worst:.2e} m apart", all.len());
    let answers = ask("GeoConvert", &["-g", "-p", "9"], reverse).unwrap();
    worst = 0.0;
    for (u, line) in grid.iter().zip(&answers) {
        let (ours, theirs) = (u.to_degrees(), numbers(line));
        let east = orb::geo::normalised_longitude(ours.1 - theirs[1]) * theirs[0].to_radians().cos();
        let off = (ours.0 - theirs[0]).hypot(east) * 111_700.0;
        worst = worst.max(off);
        assert!(off < 1e-8, "{u:?}: {off} m: {ours:?} {line}");
    }
    eprintln!("UTM and UPS -> geodetic: {} points, at most {worst:.2e} m apart", all.len());
}

#[test]
fn military_grid_references_agree_both_ways() {
    let all = points();
    let asked = lines(all.iter().map(|g| [g.latitude, g.longitude].map(exact).join(" ")));
    let Some(answers) = ask("GeoConvert", &["-m", "-p", "0"], asked) else { return };
    let references = lines(answers.iter().cloned());
    let centres = ask("GeoConvert", &["-u", "-p", "9"], references).unwrap();
    let mut worst = 0f64;
    for ((g, line), centre) in all.iter().zip(&answers).zip(&centres) {
        assert_eq!(&mgrs::format(g.latitude, g.longitude, 5), line, "{g:?}");
        let read = mgrs::parse(line).unwrap_or_else(|e| panic!("{line}: {e}"));
        let theirs = numbers(centre.split_once(' ').unwrap().1);
        let off = (read.centre.easting - theirs[0]).hypot(read.centre.northing - theirs[1]);
        worst = worst.max(off);
        assert!(off < 1e-8, "{line}: {read:?} against {centre}");
    }
    eprintln!("MGRS -> UTM and UPS: {} references, at most {worst:.2e} m apart", all.len());
}
