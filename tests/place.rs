//! Where `orb geo` puts a model: photos whose tags are made here, terrain, batches, small tools. The binary as a user runs it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

use exif::experimental::Writer;
use exif::{Field, In, Rational, Tag, Value};
use orb::geo::{Geodetic, geoid, magnetic};

fn data() -> &'static Path {
    crate::audit::pair()
}

fn orb(args: &[&str]) -> Command {
    let mut c = Command::new(env!("CARGO_BIN_EXE_orb"));
    c.args(args).env("ORB_DATA_DIR", data());
    c
}

fn text(out: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr))
}

fn ratio(v: f64) -> Rational {
    Rational { num: (v * 1e6).round() as u32, denom: 1_000_000 }
}

/// The sample's pixels under an EXIF block and an XMP packet made here.
pub fn photo(folder: &Path, tags: &[(Tag, Value)], xmp: Option<&str>) -> PathBuf {
    let jpeg = std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/smart_car.jpg")).unwrap();
    let upright = [(Tag::Orientation, Value::Short(vec![1]))];
    let fields: Vec<Field> = upright
        .iter()
        .chain(tags)
        .map(|(tag, value)| Field { tag: *tag, ifd_num: In::PRIMARY, value: value.clone() })
        .collect();
    let mut writer = Writer::new();
    fields.iter().for_each(|f| writer.push_field(f));
    let mut block = std::io::Cursor::new(Vec::new());
    writer.write(&mut block, true).unwrap();
    let segment = |head: &[u8], body: &[u8]| {
        let length = (head.len() + body.len() + 2) as u16;
        [&[0xff, 0xe1][..], &length.to_be_bytes(), head, body].concat()
    };
    let mut bytes = jpeg[..2].to_vec();
    bytes.extend(segment(b"Exif\0\0", &block.into_inner()));
    if let Some(description) = xmp {
        let packet = format!(
            "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\
             {description}</rdf:RDF></x:xmpmeta>"
        );
        bytes.extend(segment(b"http://ns.adobe.com/xap/1.0/\0", packet.as_bytes()));
    }
    bytes.extend(&jpeg[2..]);
    let path = folder.join("car.jpg");
    std::fs::write(&path, bytes).unwrap();
    path
}

const LATITUDE: f64 = 34.5523;
const LONGITUDE: f64 = -118.4712;

/// A position 740 m above the sea.
fn fix() -> Vec<(Tag, Value)> {
    let ascii = |t: &str| Value::Ascii(vec![t.into()]);
    vec![
        (Tag::GPSLatitudeRef, ascii("N")),
        (Tag::GPSLatitude, Value::Rational(vec![ratio(LATITUDE), ratio(0.0), ratio(0.0)])),
        (Tag::GPSLongitudeRef, ascii("W")),
        (Tag::GPSLongitude, Value::Rational(vec![ratio(-LONGITUDE), ratio(0.0), ratio(0.0)])),
        (Tag::GPSAltitude, Value::Rational(vec![ratio(740.0)])),
        (Tag::GPSHPositioningError, Value::Rational(vec![ratio(4.7)])),
        (Tag::DateTimeOriginal, ascii("2026:03:04 05:06:07")),
    ]
}

/// The subject of the sample, told: where it is put does not depend on who found it.
fn mask() -> &'static str {
    static FILE: OnceLock<(tempfile::TempDir, String)> = OnceLock::new();
    let made = || {
        let dir = tempfile::tempdir().unwrap();
        let truth = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/truth/smart_car/mask.png");
        let truth = image::open(truth).unwrap().into_rgba8();
        let path = dir.path().join("mask.png");
        image::GrayImage::from_fn(truth.width(), truth.height(), |x, y| image::Luma([truth.get_pixel(x, y).0[3]]))
            .save(&path)
            .unwrap();
        let path = path.to_str().unwrap().to_owned();
        (dir, path)
    };
    &FILE.get_or_init(made).1
}

/// The JSON object of a run, and its folder.
fn run(photo: &Path, args: &[&str]) -> (serde_json::Value, PathBuf) {
    let out = photo.with_file_name("out");
    let done =
        orb(&["geo", "--iterations", "2", "--format", "ply", "--json", "--replace", "-o", out.to_str().unwrap()])
            .args(crate::SMALL)
            .args(["--mask", mask()])
            .arg(photo)
            .args(args)
            .output()
            .unwrap();
    assert!(done.status.success(), "{}", text(&done));
    (serde_json::from_slice(&done.stdout).unwrap(), out)
}

/// The parameters in a run's record.
fn recorded(folder: &Path) -> serde_json::Value {
    use base64::Engine;
    let envelope: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.join("orb-record.dsse.json")).unwrap()).unwrap();
    let payload = base64::engine::general_purpose::STANDARD.decode(envelope["payload"].as_str().unwrap()).unwrap();
    let statement: serde_json::Value = serde_json::from_slice(&payload).unwrap();
    statement["predicate"]["params"].clone()
}

fn at(run: &serde_json::Value) -> Geodetic {
    let g = |name: &str| run["georeference"][name].as_f64().unwrap();
    Geodetic { latitude: g("latitude"), longitude: g("longitude"), height: g("ellipsoidal_height_m") }
}

#[test]
fn the_subject_lies_before_the_camera_of_the_photo() {
    let dir = tempfile::tempdir().unwrap();
    let mut tags = fix();
    tags.push((Tag::GPSImgDirectionRef, Value::Ascii(vec!["M".into()])));
    tags.push((Tag::GPSImgDirection, Value::Rational(vec![ratio(78.0)])));
    tags.push((Tag::FocalLengthIn35mmFilm, Value::Short(vec![28])));
    let photo = photo(dir.path(), &tags, None);
    let (json, folder) = run(&photo, &["--distance", "20"]);
    let sea = geoid::undulation(LATITUDE, LONGITUDE);
    let camera = Geodetic { latitude: LATITUDE, longitude: LONGITUDE, height: 740.0 + sea };
    let declination = magnetic::field(camera, 2026.0 + 62.0 / 365.0).declination;
    assert!((10.0..14.0).contains(&declination));
    let enu = camera.local(at(&json).to_ecef());
    // The subject stands in the picture's middle to some degrees, and some of the 20 m are height.
    let bearing = enu.east.atan2(enu.north).to_degrees();
    assert!((bearing - 78.0 - declination).abs() < 10.0, "{bearing}");
    let heading = json["georeference"]["heading_deg"].as_f64().unwrap();
    assert!((heading - bearing).abs() < 1e-3, "{heading} {bearing}");
    assert!((14.0..20.1).contains(&enu.east.hypot(enu.north)) && (-14.0..0.0).contains(&enu.up), "{enu:?}");
    assert_eq!(json["georeference"]["heading_source"], "exif-magnetic-wmm2025");
    assert_eq!(json["scale"]["source"], "distance-exif-focal");
    let sigma = |name: &str| json["georeference"][name].as_f64().unwrap();
    assert!(sigma("horizontal_sigma_m") > 4.7 && sigma("vertical_sigma_m") > 9.4 && sigma("heading_sigma_deg") > 5.0);

    // The same numbers in the record and the sidecars.
    let pose: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.join("car.geopose.json")).unwrap()).unwrap();
    assert_eq!(pose["position"]["lat"].as_f64(), Some(at(&json).latitude));
    assert!((pose["uncertainty"]["horizontal_m"].as_f64().unwrap() - sigma("horizontal_sigma_m")).abs() < 1e-4);
    let params = recorded(&folder);
    assert_eq!(params["latitude"].as_str().unwrap().parse::<f64>().unwrap(), at(&json).latitude);
    let spread: f64 = params["horizontal_sigma_m"].as_str().unwrap().parse().unwrap();
    assert!((spread - sigma("horizontal_sigma_m")).abs() < 1e-4);
    assert!(params["georeference"].as_str().unwrap().contains("WMM2025"));
}

#[test]
fn a_drone_knows_more() {
    let dir = tempfile::tempdir().unwrap();
    let xmp = "<rdf:Description xmlns:drone-dji=\"http://www.dji.com/drone-dji/1.0/\" drone-dji:GimbalYawDegree=\"-90.0\" \
               drone-dji:GimbalPitchDegree=\"-30.0\" drone-dji:RelativeAltitude=\"+40.0\" drone-dji:RtkStdLat=\"0.02\" \
               drone-dji:RtkStdLon=\"0.02\" drone-dji:RtkStdHgt=\"0.04\"/>";
    let drone = photo(dir.path(), &fix(), Some(xmp));
    let (json, folder) = run(&drone, &[]);
    let elevation = |folder: &Path| recorded(folder)["elevation_deg"].as_str().unwrap().parse::<f64>().unwrap();
    let told = elevation(&folder);
    assert_eq!(json["georeference"]["heading_source"], "gimbal");
    assert!(json["scale"]["words"].as_str().unwrap().contains("40 m above take-off"), "{json}");
    let camera =
        Geodetic { latitude: LATITUDE, longitude: LONGITUDE, height: 740.0 + geoid::undulation(LATITUDE, LONGITUDE) };
    let enu = camera.local(at(&json).to_ecef());
    assert!((enu.up + 40.0).abs() < 0.1, "{enu:?}");
    // 30° down over 40 m: 69 m to the west; less, for the subject stands below the middle of the picture.
    assert!((-95.0..-30.0).contains(&enu.east), "{enu:?}");

    // What the gimbal says of the view counts for the model, too: the car is seen from higher up than without.
    let (_, folder) = by_hand();
    assert!(told > elevation(folder) + 3.0, "{told}, {}", elevation(folder));
    // As a word of the user's does, which is less exact: the network, which sees the car from lower down, has more say.
    let (_, folder) = told_everything();
    assert!((0.5..4.0).contains(&(told - elevation(folder))), "{told}, {}", elevation(folder));
    assert_eq!(recorded(folder)["pitch_given_deg"], "-30");
}

/// A photo of no drone, said to be of its subject's place.
fn by_hand() -> &'static (serde_json::Value, PathBuf) {
    static DONE: OnceLock<Kept> = OnceLock::new();
    let args = ["--origin-is", "subject", "--heading", "270"];
    &DONE.get_or_init(|| keep(&args)).1
}

/// Of which the user says all that there is to say; signed by `audit::pair`.
pub fn told_everything() -> &'static (serde_json::Value, PathBuf) {
    static DONE: OnceLock<Kept> = OnceLock::new();
    let key = crate::audit::pair().join("pair.pem");
    let place = ["--origin", "11SLU 65018 24379, 740", "--alt-datum", "msl", "--length", "2.5"];
    let args = [&place[..], &["--heading", "270", "--pitch", "-30", "--key", key.to_str().unwrap()]].concat();
    &DONE.get_or_init(|| keep(&args)).1
}

/// A run that several tests look at, and what it lies in.
type Kept = (tempfile::TempDir, (serde_json::Value, PathBuf));

fn keep(args: &[&str]) -> Kept {
    let dir = tempfile::tempdir().unwrap();
    let done = run(&photo(dir.path(), &fix(), None), args);
    (dir, done)
}

#[test]
fn origins_heights_and_their_datums() {
    let (json, _) = told_everything();
    let truth = orb::geo::parse_point("p", "11SLU 65018 24379").unwrap();
    let here = at(json);
    assert!((here.latitude - truth.latitude).abs() < 1e-12 && (here.longitude - truth.longitude).abs() < 1e-12);
    assert!((here.height - 740.0 - geoid::undulation(here.latitude, here.longitude)).abs() < 1e-9);
    assert_eq!(json["scale"]["source"], "known-length");
    // A photo's own position may be the subject's.
    let (json, _) = by_hand();
    assert!((at(json).latitude - LATITUDE).abs() < 1e-9 && (at(json).longitude - LONGITUDE).abs() < 1e-9);
}

#[test]
fn no_place_is_refused_before_the_work() {
    let dir = tempfile::tempdir().unwrap();
    let bare = photo(dir.path(), &[], None);
    let refuse = |photo: &Path, args: &[&str], words: &str| {
        let out = dir.path().join("out");
        let done = orb(&["geo", "-o", out.to_str().unwrap()]).arg(photo).args(args).output().unwrap();
        let said = text(&done);
        assert_eq!(done.status.code(), Some(2), "{args:?}: {said}");
        assert!(said.contains(words), "{args:?}: «{words}» in {said}");
        assert!(!out.exists());
    };
    refuse(&bare, &[], "without a GPS position");
    refuse(&bare, &["--origin", "34.5,-118.4"], "a height");
    refuse(&bare, &["--origin", "34.5,-118.4,740", "--alt-datum", "ground"], "--dem");
    refuse(&bare, &["--origin", "11S 365018 3824380 740"], "`11S`");
    refuse(&bare, &["--origin", "EPSG:999999 1,2,3"], "EPSG:999999");
    refuse(&bare, &["--origin", "34.5,-118.4,740", "--distance", "-1"], "--distance");
    let mut foreign = fix();
    foreign.push((Tag::GPSMapDatum, Value::Ascii(vec!["TOKYO".into()])));
    let foreign = photo(dir.path(), &foreign, None);
    refuse(&foreign, &[], "TOKYO");
    let mut flat = fix();
    flat.retain(|(t, _)| *t != Tag::GPSAltitude);
    let flat = photo(dir.path(), &flat, None);
    refuse(&flat, &[], "no altitude");
}

/// A terrain by GDAL: a slope of one in ten to the east.
fn slope(folder: &Path) -> Option<PathBuf> {
    let (grid, tif) = (folder.join("slope.asc"), folder.join("slope.tif"));
    let row: Vec<String> = (0..40).map(|i| format!("{}", 700.0 + f64::from(i))).collect();
    let mut text =
        "ncols 40\nnrows 40\nxllcorner 364818\nyllcorner 3824180\ncellsize 10\nNODATA_value -9999\n".to_owned();
    (0..40).for_each(|_| text += &(row.join(" ") + "\n"));
    std::fs::write(&grid, text).unwrap();
    let made = Command::new("gdal_translate")
        .args(["-q", "-a_srs", "EPSG:32611", "-ot", "Float32", "-co", "COMPRESS=DEFLATE", "-co", "TILED=YES"])
        .args([&grid, &tif])
        .status();
    match made {
        Ok(status) if status.success() => Some(tif),
        _ => {
            assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "cannot run: gdal_translate is not installed");
            eprintln!("skipped: gdal_translate is not installed");
            None
        }
    }
}

#[test]
fn a_model_stands_on_its_terrain() {
    let dir = tempfile::tempdir().unwrap();
    let Some(tif) = slope(dir.path()) else { return };
    let tif = tif.to_str().unwrap();
    let bare = photo(dir.path(), &[], None);
    let place = ["--origin", "34.5523,-118.4712", "--dem", tif, "--dem-datum", "ellipsoid", "--length", "10"];
    let (mean, _) = run(&bare, &place);
    // The origin lies 200.1 m east of the terrain's edge: 700 m + 0.1 (200.1 − 5).
    assert!((at(&mean).height - 719.51).abs() < 0.12, "{mean}");
    let (lowest, _) = run(&bare, &[&place[..], &["--dem-fit", "min"]].concat());
    let below = at(&mean).height - at(&lowest).height;
    assert!((0.15..0.75).contains(&below), "{below}");
    let (bent, folder) = run(&bare, &[&place[..], &["--dem-fit", "conform", "--format", "flt"]].concat());
    assert!((at(&bent).height - at(&mean).height).abs() < 1e-3);
    let flt = orb_formats::openflight::read(&std::fs::read(folder.join("car.flt")).unwrap()).unwrap();
    let finest = &flt.levels.last().unwrap().mesh;
    let lowest_at = |east: bool| {
        let side = finest.positions.iter().filter(|p| (p[0] > 0.0) == east && p[0].abs() > 1.0);
        side.map(|p| p[2]).fold(f64::INFINITY, f64::min)
    };
    assert!(lowest_at(true) - lowest_at(false) > 0.1, "the base does not follow the slope");

    let far = orb(&["geo", "--origin", "34.6,-118.4712", "--dem", tif]).arg(&bare).output().unwrap();
    assert_eq!(far.status.code(), Some(2), "{}", text(&far));
    assert!(text(&far).contains("slope.tif") && text(&far).contains("does not cover"), "{}", text(&far));
}

#[test]
fn a_batch_goes_on_past_bad_lines_and_can_be_resumed() {
    let dir = tempfile::tempdir().unwrap();
    photo(dir.path(), &fix(), None);
    let manifest = dir.path().join("all.csv");
    let header = "photo,name,origin,heading,length\n";
    let good = "car.jpg,first,\"34.5523,-118.4712,740\",45,2.5\ncar.jpg,second,\"34.5524,-118.4712,740\",,2.5\n";
    let bad = "gone.jpg,third,\"1,2,3\",,\ncar.jpg,fourth,\"91,0,0\",,\ncar.jpg,first,\"1,2,3\",,\ncar.jpg,fifth\n";
    std::fs::write(&manifest, format!("{header}{good}{bad}")).unwrap();
    let out = dir.path().join("out");
    let batch = || {
        let run = orb(&["geo", "--iterations", "2", "-o", out.to_str().unwrap(), "--manifest"])
            .arg(&manifest)
            .args(crate::SMALL)
            .args(["--mask", mask()])
            .output();
        run.unwrap()
    };
    let done = batch();
    let said = text(&done);
    assert_eq!(done.status.code(), Some(3), "{said}");
    assert!(said.contains("6 lines: 2 published, 0 published already, 4 failed (lines 4, 5, 6, 7)"), "{said}");
    for words in ["gone.jpg", "`91`", "line 2 has", "2 cells for 5 columns"] {
        assert!(said.contains(words), "«{words}» in {said}");
    }
    let store = out.join("store.cdb");
    let listed = Command::new("grep").args(["-rla", "second"]).arg(&store).output().unwrap();
    assert!(!listed.stdout.is_empty(), "the second model is not in the store");
    for name in ["first", "second"] {
        let verified = orb(&["audit", "verify"]).arg(out.join(name)).output().unwrap();
        assert_ne!(verified.status.code(), Some(1), "{}", text(&verified));
    }
    // Again: nothing is made twice; a mended line is made, a changed one is refused.
    let mended = good.replace(",45,", ",46,") + "car.jpg,third,\"34.5525,-118.4712,740\",,2.5\n";
    std::fs::write(&manifest, format!("{header}{mended}")).unwrap();
    let again = batch();
    let said = text(&again);
    assert_eq!(again.status.code(), Some(3), "{said}");
    assert!(said.contains("3 lines: 1 published, 1 published already, 1 failed (lines 2)"), "{said}");
    assert!(said.contains("before this line changed"), "{said}");
}

#[test]
fn small_tools() {
    let ask = |args: &[&str]| {
        let out = orb(&["geo"]).args(args).output().unwrap();
        (out.status.code(), text(&out))
    };
    let (code, said) = ask(&["convert", "34.5523,-118.4712,740"]);
    assert_eq!(code, Some(0), "{said}");
    for words in ["11SLU6501824379", "34°33'08.28000\"N", "11 north 365018.131 3824379.672", "above the sea"] {
        assert!(said.contains(words), "«{words}» in {said}");
    }
    let (code, said) = ask(&["convert", "-34.5 118.4", "--to", "mgrs"]);
    assert_eq!((code, said.lines().count()), (Some(0), 1), "{said}");
    let (code, said) = ask(&["convert", "34.5523,-118.4712,740", "--json"]);
    assert_eq!(code, Some(0));
    let json: serde_json::Value = serde_json::from_str(&said).unwrap();
    assert_eq!(json["utm"]["zone"], 11);
    let (code, said) = ask(&["distance", "34.5523,-118.4712", "51.5,-0.12"]);
    assert!(code == Some(0) && said.contains("8743333.3594 m"), "{said}");
    let (code, said) = ask(&["footprint", "34.5523,-118.4712", "--width", "10", "--depth", "4", "--heading", "30"]);
    assert!(code == Some(0) && said.contains("Polygon"), "{said}");
    let (code, said) = ask(&["convert", "91,0"]);
    assert!(code == Some(2) && said.contains("`91`"), "{said}");
    // swisstopo's example, by the machine's PROJ; where there is none, its name and what to do are said.
    let (code, said) = ask(&["convert", "EPSG:2056 2700000,1100000", "--json"]);
    if code == Some(0) {
        let json: serde_json::Value = serde_json::from_str(&said).unwrap();
        let off =
            [json["latitude"].as_f64().unwrap() - 46.044_130_6, json["longitude"].as_f64().unwrap() - 8.730_497_2];
        assert!(off.iter().all(|degrees| degrees.abs() < 2e-5), "{said}");
        assert!(json["written_as"].as_str().unwrap().starts_with("EPSG code (PROJ "), "{said}");
    } else {
        let required = std::env::var_os("ORB_REQUIRE_CLIENTS").is_some_and(|v| v == "1");
        assert!(!required && code == Some(2) && said.contains("no PROJ") && said.contains("libproj25"), "{said}");
    }
}
