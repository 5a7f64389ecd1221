//! Corners of a known box through every georeferenced format, read back by programs that are not ours.

use std::path::{Path, PathBuf};
use std::process::Command;

use glam::{Vec2, Vec3};
use orb::audit::Marking;
use orb::export::{self, Labels, ToMetres};
use orb::geo::sidecar::{self, Georeference};
use orb::geo::{Ecef, Geodetic, HeadingSource, Placement, Uncertainty, footprint};
use orb::mesh::{Level, Mesh};
use orb::splat::Gaussians;
use orb_formats::cdb;
use orb_formats::openflight::Geometry;

/// Metres a unit of the box.
const SCALE: f64 = 4.2;

/// A box of 0.5 × 1.0 × 0.35 units beside the unit frame's middle: 2.1 × 4.2 × 1.47 m, six faces of their own vertices.
fn solid() -> Level {
    let (low, high) = (Vec3::new(-0.2, -0.4, -0.1), Vec3::new(0.3, 0.6, 0.25));
    let mut mesh = Mesh { positions: vec![], normals: vec![], uvs: vec![], triangles: vec![] };
    for axis in 0..3 {
        for side in [0, 1] {
            let first = mesh.positions.len() as u32;
            let normal =
                Vec3::from_array(std::array::from_fn(|k| if k == axis { 2.0 * side as f32 - 1.0 } else { 0.0 }));
            for (u, v) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
                let mut at = [0; 3];
                (at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3]) = (side, u, v);
                mesh.positions
                    .push(Vec3::from_array(std::array::from_fn(|k| if at[k] == 1 { high[k] } else { low[k] })));
                mesh.normals.push(normal);
                mesh.uvs.push(Vec2::new(u as f32, v as f32));
            }
            let turn = |[a, b, c]: [u32; 3]| if side == 1 { [a, b, c] } else { [a, c, b] };
            mesh.triangles.extend([[0, 1, 2], [0, 2, 3]].map(|t| turn(t.map(|i| first + i))));
        }
    }
    let texture = image::RgbImage::from_fn(8, 8, |x, y| image::Rgb([(x * 30) as u8, (y * 30) as u8, 90]));
    Level {
        mesh,
        texture,
        details: Default::default(),
        error: 0.0,
        mean_error: 0.0,
        error_to_coarser: 1.2,
        seen: 1.0,
        mirrored: 0.0,
    }
}

/// The eight corners in the subject frame, metres: the origin lies under the middle of the box.
fn corners() -> Vec<[f64; 3]> {
    let (x, y, z) = (0.25 * SCALE, 0.5 * SCALE, 0.35 * SCALE);
    let mut all = Vec::new();
    for up in [0.0, z] {
        all.extend([[-x, -y, up], [x, -y, up], [x, y, up], [-x, y, up]]);
    }
    all
}

fn labels() -> Labels {
    Labels {
        stem: "box".into(),
        marking: Marking::UNCLASSIFIED,
        utc: "2026-11-21T04:05:06.789Z".into(),
        heading_source: "given",
        scale_source: "known-length",
    }
}

fn places() -> [Placement; 4] {
    let at = |latitude, longitude, height, heading| Placement {
        origin: Geodetic { latitude, longitude, height },
        heading,
        heading_source: HeadingSource::Given,
    };
    [
        at(34.5523, -118.4712, 740.0, 213.5),
        at(-77.85, 166.6667, 24.25, 10.0),
        at(0.0001, 179.999_97, -12.5, 90.0),
        at(51.501_364, -0.141_89, 60.0, 0.0),
    ]
}

/// What a program prints; `None` where it is not installed and not required.
fn ask(program: &str, args: &[&str], input: &str) -> Option<String> {
    use std::io::Write;
    let child = Command::new(program)
        .args(args)
        .stdin(std::process::Stdio::piped())
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn();
    let Ok(mut child) = child else {
        assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "cannot run: {program} is not installed");
        eprintln!("skipped: {program} is not installed");
        return None;
    };
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    let out = child.wait_with_output().unwrap();
    Some(format!("{}{}", String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr)))
}

fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace().filter_map(|w| w.parse().ok()).collect()
}

/// Vertices that OpenSceneGraph reads from an OpenFlight file, each once.
fn vertices(flt: &Path) -> Option<Vec<[f64; 3]>> {
    let text = flt.with_extension("osgt");
    ask("osgconv", &[flt.to_str().unwrap(), text.to_str().unwrap()], "")?;
    let scene =
        std::fs::read_to_string(&text).unwrap_or_else(|e| panic!("osgconv did not read {}: {e}", flt.display()));
    let mut all: Vec<[f64; 3]> = Vec::new();
    for block in scene.split("VertexArray TRUE {").skip(1) {
        let body = block.split("vector ").nth(1).unwrap_or_default();
        for line in body.lines().skip(1).take_while(|l| !l.contains('}')) {
            if let [x, y, z] = numbers(line)[..] {
                let near = |p: &[f64; 3]| (p[0] - x).abs() + (p[1] - y).abs() + (p[2] - z).abs() < 1e-4;
                if !all.iter().any(near) {
                    all.push([x, y, z]);
                }
            }
        }
    }
    Some(all)
}

/// East, north, up of a point to earth-centred coordinates, by GeographicLib.
fn ecef_by_cartconvert(origin: (f64, f64, f64), enu: &[[f64; 3]]) -> Option<Vec<Ecef>> {
    let (lat, lon, h) = (format!("{:.15}", origin.0), format!("{:.15}", origin.1), format!("{:.6}", origin.2));
    let rows: String = enu.iter().map(|p| format!("{} {} {}\n", p[0], p[1], p[2])).collect();
    let geodetic = ask("CartConvert", &["-r", "-l", &lat, &lon, &h, "-p", "9"], &rows)?;
    let geocentric = ask("CartConvert", &["-p", "9"], &geodetic)?;
    Some(geocentric.lines().map(numbers).map(|v| Ecef { x: v[0], y: v[1], z: v[2] }).collect())
}

/// Every true corner has a read one within a millimetre, and the other way round.
fn same_corners(what: &str, placement: &Placement, read: &[Ecef]) {
    assert_eq!(read.len(), 8, "{what}: {read:?}");
    let truth: Vec<Ecef> = corners().iter().map(|c| placement.to_ecef(*c)).collect();
    let apart = |a: &Ecef, b: &Ecef| (a.x - b.x).hypot(a.y - b.y).hypot(a.z - b.z);
    let mut worst = 0f64;
    for (some, others) in [(&truth[..], read), (read, &truth[..])] {
        for p in some {
            worst = worst.max(others.iter().map(|q| apart(p, q)).fold(f64::INFINITY, f64::min));
        }
    }
    assert!(worst < 1e-3, "{what}: a corner is {worst} m off");
    eprintln!("{what} at {:?}: corners within {:.1e} m", placement.origin, worst);
}

fn write(folder: &Path, files: &[orb_formats::File]) {
    for file in files {
        let to = folder.join(&file.path);
        std::fs::create_dir_all(to.parent().unwrap()).unwrap();
        std::fs::write(to, &file.bytes).unwrap();
    }
}

fn georeference(level: &Level, to_metres: &ToMetres, placement: Placement) -> Georeference {
    Georeference {
        name: "box".into(),
        banner: "UNCLASSIFIED".into(),
        utc: labels().utc,
        placement,
        uncertainty: Uncertainty { horizontal: 1.0, vertical: 2.0, heading: 3.0, scale: 0.04 },
        footprint: footprint::of(level.mesh.positions.iter().map(|p| to_metres.point(*p)), &placement),
        size: [0.5 * SCALE, SCALE, 0.35 * SCALE],
        lineage: vec!["A test.".into()],
        assets: vec![],
    }
}

/// Points of the model's frame to the Earth by what the GeoPose sidecar says, turned by its quaternion alone.
fn by_geopose(folder: &Path, georeference: &Georeference, points: &[[f64; 3]]) -> Option<Vec<Ecef>> {
    let written = sidecar::all(georeference);
    written.iter().for_each(|s| std::fs::write(folder.join(&s.path), &s.bytes).unwrap());
    let pose: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.join("box.geopose.json")).unwrap()).unwrap();
    let v = |a: &str, b: &str| pose[a][b].as_f64().unwrap();
    let [x, y, z, w] = ["x", "y", "z", "w"].map(|k| v("quaternion", k));
    let q = glam::DQuat::from_xyzw(x, y, z, w);
    let enu: Vec<[f64; 3]> = points.iter().map(|p| (q * glam::DVec3::from_array(*p)).to_array()).collect();
    ecef_by_cartconvert((v("position", "lat"), v("position", "lon"), v("position", "h")), &enu)
}

/// The same by a place that a file itself names.
fn by_place([latitude, longitude, height, heading]: [f64; 4], points: &[[f64; 3]]) -> Option<Vec<Ecef>> {
    let (sin, cos) = heading.to_radians().sin_cos();
    let turned: Vec<[f64; 3]> =
        points.iter().map(|p| [p[0] * cos + p[1] * sin, -p[0] * sin + p[1] * cos, p[2]]).collect();
    ecef_by_cartconvert((latitude, longitude, height), &turned)
}

#[test]
fn openflight_corners() {
    let level = solid();
    let to_metres = ToMetres::new(&level.mesh, SCALE);
    for placement in places() {
        let dir = tempfile::tempdir().unwrap();
        let files =
            export::flt(&to_metres.levels(std::slice::from_ref(&level)), Geometry::Faces, &placement, &labels())
                .unwrap();
        write(dir.path(), &files);
        // The header has a place for latitude and longitude but none for a height, and OpenSceneGraph skips it: those of
        // the format come from Orb's own reader, the height from the placement.
        let header = orb_formats::openflight::read(&files[0].bytes).unwrap();
        let (lat, lon) = header.origin.unwrap();
        let Some(read) = vertices(&dir.path().join("box.flt")) else { return };
        let Some(ecef) = ecef_by_cartconvert((lat, lon, placement.origin.height), &read) else { return };
        same_corners("OpenFlight", &placement, &ecef);
    }
}

fn find(folder: &Path, suffix: &str, into: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        let path = entry.path();
        if path.is_dir() {
            find(&path, suffix, into);
        } else if path.to_string_lossy().ends_with(suffix) {
            into.push(path);
        }
    }
}

#[test]
fn store_corners() {
    let level = solid();
    let to_metres = ToMetres::new(&level.mesh, SCALE);
    for placement in places() {
        let dir = tempfile::tempdir().unwrap();
        let model = export::cdb_model(
            &to_metres.levels(std::slice::from_ref(&level)),
            &placement,
            &labels(),
            &export::Catalogue::default(),
        );
        write(dir.path(), &cdb::add_model(&cdb::Empty, &model).unwrap().files);
        let (mut archives, mut shapes, mut flights) = (vec![], vec![], vec![]);
        find(dir.path(), ".zip", &mut archives);
        for archive in &archives {
            let folder = archive.parent().unwrap().to_str().unwrap();
            if ask("unzip", &["-oq", archive.to_str().unwrap(), "-d", folder], "").is_none() {
                return;
            }
        }
        // Place and bearing by GDAL.
        find(dir.path(), ".shp", &mut shapes);
        let mut origin = None;
        for shape in shapes {
            let Some(said) = ask("ogrinfo", &["-al", shape.to_str().unwrap()], "") else { return };
            let Some(point) = said.lines().find_map(|l| l.trim().strip_prefix("POINT ZM (")) else { continue };
            let table = said.lines().find_map(|l| l.trim().strip_prefix("AO1 (Real) = "));
            origin = Some((numbers(point.trim_end_matches(')')), table.and_then(|t| t.trim().parse::<f64>().ok())));
        }
        let (point, heading) = origin.expect("a point feature");
        let heading = heading.expect("AO1");
        find(dir.path(), ".flt", &mut flights);
        let mut seen = 0;
        for flight in &flights {
            let Some(read) = vertices(flight) else { return };
            if read.is_empty() {
                continue;
            }
            let Some(ecef) = by_place([point[1], point[0], point[2], heading], &read) else { return };
            same_corners("CDB", &placement, &ecef);
            seen += 1;
        }
        assert!(seen > 0, "no geometry among {flights:?}");
    }
}

/// GDAL reads the outline and the map, xmllint the metadata; the pose's corners are turned by the quaternion alone.
#[test]
fn sidecars_corners() {
    let level = solid();
    let to_metres = ToMetres::new(&level.mesh, SCALE);
    for placement in places() {
        let dir = tempfile::tempdir().unwrap();
        let Some(ecef) = by_geopose(dir.path(), &georeference(&level, &to_metres, placement), &corners()) else {
            return;
        };
        same_corners("GeoPose", &placement, &ecef);
        let file = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();

        for name in ["box.footprint.geojson", "box.kml", "box.stac.json"] {
            let Some(said) = ask("ogrinfo", &["-al", &file(name)], "") else { return };
            assert!(!said.contains("ERROR") && said.contains("Feature Count: 1"), "{name}: {said}");
            let ring = said.lines().find(|l| l.contains("POLYGON")).unwrap_or_else(|| panic!("{name}: {said}"));
            let read: Vec<[f64; 2]> = ring
                .split([',', '('])
                .map(|p| numbers(p.trim_end_matches(')')))
                .filter(|p| p.len() >= 2)
                .map(|p| [p[0], p[1]])
                .collect();
            // Of a polygon that the antimeridian cuts, the points on it are new ones.
            for c in &corners()[..4] {
                let truth = placement.to_geodetic(*c);
                let off = |p: &[f64; 2]| footprint::geodesic((truth.latitude, truth.longitude), (p[1], p[0])).0;
                let nearest = read.iter().map(off).fold(f64::INFINITY, f64::min);
                assert!(nearest < 1e-3, "{name}: corner {nearest} m off: {read:?}");
            }
        }
        for name in ["box.kml", "box.iso19115.xml"] {
            let Some(said) = ask("xmllint", &["--noout", &file(name)], "") else { return };
            assert_eq!(said, "", "{name}");
        }
    }
}

/// Each point once, of formats that have Y up: (x, y, z) there is (x, −z, y) here.
fn from_y_up(rows: impl Iterator<Item = Vec<f64>>) -> Vec<[f64; 3]> {
    let mut all: Vec<[f64; 3]> = Vec::new();
    for v in rows {
        let p = [v[0], -v[2], v[1]];
        if !all.iter().any(|q| (0..3).all(|i| (p[i] - q[i]).abs() < 1e-3)) {
            all.push(p);
        }
    }
    all
}

/// Vertices by assimp, whose OBJ has Y up: it turns a COLLADA model's Z up.
fn vertices_by_assimp(model: &Path) -> Option<Vec<[f64; 3]>> {
    let obj = model.with_extension("obj");
    let said = ask("assimp", &["export", model.to_str().unwrap(), obj.to_str().unwrap()], "")?;
    let text = std::fs::read_to_string(&obj).unwrap_or_else(|e| panic!("assimp: {e}: {said}"));
    Some(from_y_up(text.lines().filter_map(|l| l.strip_prefix("v ")).map(numbers)))
}

#[test]
fn gltf_corners_with_their_geopose() {
    let level = solid();
    let to_metres = ToMetres::new(&level.mesh, SCALE);
    for placement in places() {
        let dir = tempfile::tempdir().unwrap();
        write(
            dir.path(),
            &export::glb(
                &to_metres.levels(std::slice::from_ref(&level)),
                orb_formats::glb::Compression::None,
                &placement,
                &labels(),
            )
            .unwrap(),
        );
        let Some(read) = vertices_by_assimp(&dir.path().join("box.glb")) else { return };
        let known = georeference(&level, &to_metres, placement);
        let Some(ecef) = by_geopose(dir.path(), &known, &read) else { return };
        same_corners("GLB", &placement, &ecef);
    }
}

/// The content by assimp, turned from Y up to Z up as the specification has it (section 3.3), then the root's transform.
#[test]
fn tiles_corners() {
    let level = solid();
    let to_metres = ToMetres::new(&level.mesh, SCALE);
    for placement in places() {
        let dir = tempfile::tempdir().unwrap();
        let levels = to_metres.levels(std::slice::from_ref(&level));
        write(dir.path(), &export::tiles3d(&levels, &placement, &labels()).unwrap());
        let tileset: serde_json::Value =
            serde_json::from_slice(&std::fs::read(dir.path().join("tiles3d/tileset.json")).unwrap()).unwrap();
        let transform: Vec<f64> = serde_json::from_value(tileset["root"]["transform"].clone()).unwrap();
        let m = glam::DMat4::from_cols_slice(&transform);
        let content = tileset["root"]["content"]["uri"].as_str().unwrap();
        let Some(read) = vertices_by_assimp(&dir.path().join("tiles3d").join(content)) else { return };
        let on_earth = |p: &[f64; 3]| m.transform_point3(glam::DVec3::from_array(*p));
        let ecef: Vec<Ecef> = read.iter().map(on_earth).map(|p| Ecef { x: p.x, y: p.y, z: p.z }).collect();
        same_corners("3D Tiles", &placement, &ecef);
    }
}

/// Points and place by OpenUSD.
#[test]
fn usdz_corners() {
    let Some(python) = std::env::var_os("ORB_PYTHON") else {
        assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "ORB_PYTHON does not name a Python with OpenUSD");
        return eprintln!("skipped: ORB_PYTHON does not name a Python with OpenUSD");
    };
    let level = solid();
    let to_metres = ToMetres::new(&level.mesh, SCALE);
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/clients/usdz_points.py");
    for placement in places() {
        let dir = tempfile::tempdir().unwrap();
        let file = export::usdz(&to_metres.levels(std::slice::from_ref(&level)), None, &placement, &labels()).unwrap();
        write(dir.path(), &[file]);
        let package = dir.path().join("box.usdz");
        let said = ask(python.to_str().unwrap(), &[script, package.to_str().unwrap()], "").unwrap();
        let rows =
            |word: &str| -> Vec<Vec<f64>> { said.lines().filter_map(|l| l.strip_prefix(word)).map(numbers).collect() };
        let place: [f64; 4] = rows("place ").concat().try_into().unwrap_or_else(|_| panic!("{said}"));
        let Some(ecef) = by_place(place, &from_y_up(rows("point ").into_iter())) else { return };
        same_corners("USDZ", &placement, &ecef);
    }
}

/// Gaussians at the corners, by splat-transform: of the PLY at the place in its header, of SPZ by the GeoPose.
#[test]
fn gaussians_corners() {
    let modules = std::env::var_os("NODE_PATH").map(PathBuf::from);
    let Some(reader) = modules.map(|m| m.join("@playcanvas/splat-transform/bin/cli.mjs")).filter(|p| p.is_file())
    else {
        assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "no splat-transform on NODE_PATH");
        return eprintln!("skipped: no splat-transform on NODE_PATH");
    };
    let read = |file: &Path| -> Option<Vec<Vec<f64>>> {
        let csv = file.with_extension("csv");
        let args = [&reader, file, &csv].map(|p| p.to_str().unwrap());
        let said = ask("node", &args, "")?;
        let text = std::fs::read_to_string(&csv).unwrap_or_else(|e| panic!("splat-transform: {e}: {said}"));
        assert!(text.starts_with("x,y,z,"), "{text}");
        let row = |l: &str| l.split(',').take(3).map(|v| v.parse().unwrap()).collect();
        Some(text.lines().skip(1).map(row).collect())
    };
    let level = solid();
    let to_metres = ToMetres::new(&level.mesh, SCALE);
    let mut g = Gaussians::default();
    for [x, y, z] in corners() {
        g.positions.push(Vec3::new(x as f32, y as f32, z as f32));
        g.log_scales.push(Vec3::splat(-3.0));
        g.rotations.push([1.0, 0.0, 0.0, 0.0]);
        g.logit_opacities.push(2.0);
        g.sh.push(Default::default());
    }
    for placement in places() {
        let dir = tempfile::tempdir().unwrap();
        write(dir.path(), &[export::scene_ply(&g, &placement, &labels()).unwrap()]);
        let ply = dir.path().join("scene.ply");
        let header = String::from_utf8_lossy(&std::fs::read(&ply).unwrap()).into_owned();
        let words = |start: &str| header.lines().find_map(|l| l.strip_prefix(start)).map(numbers).unwrap();
        let (origin, heading) = (words("comment origin WGS84 "), words("comment heading of +Y ")[0]);
        let Some(points) = read(&ply) else { return };
        let points: Vec<[f64; 3]> = points.iter().map(|p| [p[0], p[1], p[2]]).collect();
        let Some(ecef) = by_place([origin[0], origin[1], origin[2], heading], &points) else { return };
        same_corners("PLY", &placement, &ecef);

        write(dir.path(), &[export::spz(&g, &labels(), orb_formats::spz::Version::V3).unwrap()]);
        // The reader hands on Y down, Z forward.
        let points = read(&dir.path().join("box.spz")).unwrap().into_iter().map(|p| vec![p[0], -p[1], -p[2]]);
        let known = georeference(&level, &to_metres, placement);
        let ecef = by_geopose(dir.path(), &known, &from_y_up(points)).unwrap();
        same_corners("SPZ", &placement, &ecef);

        write(dir.path(), &[export::splat_glb(&g, &placement, &labels()).unwrap()]);
        let points = vertices_by_assimp(&dir.path().join("box_splats.glb")).unwrap();
        same_corners("splat GLB", &placement, &by_geopose(dir.path(), &known, &points).unwrap());
    }
}

#[test]
fn google_earth_corners() {
    let level = solid();
    let to_metres = ToMetres::new(&level.mesh, SCALE);
    for placement in places() {
        let dir = tempfile::tempdir().unwrap();
        let document = sidecar::kml_with_model(&georeference(&level, &to_metres, placement), "models/box.dae");
        let packed = export::kmz(&level, &to_metres, &document, &labels()).unwrap();
        write(dir.path(), &[packed]);
        let archive = dir.path().join("box.kmz");
        if ask("unzip", &["-oq", archive.to_str().unwrap(), "-d", dir.path().to_str().unwrap()], "").is_none() {
            return;
        }
        let Some(read) = vertices_by_assimp(&dir.path().join("models/box.dae")) else { return };
        // Readers of KML take the model's X east, Y north, Z up and turn it clockwise by the heading.
        let kml = std::fs::read_to_string(dir.path().join("doc.kml")).unwrap();
        let value = |name: &str| -> f64 {
            let model = &kml[kml.find("<Model>").unwrap()..];
            let text = model.split(&format!("<{name}>")).nth(1).unwrap().split('<').next().unwrap();
            text.parse().unwrap()
        };
        let (lat, lon) = (value("latitude"), value("longitude"));
        let height = value("altitude") + orb::geo::geoid::undulation(lat, lon);
        let Some(ecef) = by_place([lat, lon, height, value("heading")], &read) else { return };
        same_corners("KMZ", &placement, &ecef);
    }
}
