//! What other programs make of our models and splats: the Khronos glTF validator, OpenUSD's checkers, splat-transform.
//!
//! Packages of npm are looked for on NODE_PATH, OpenUSD in the Python that ORB_PYTHON names (else `python3`).

use orb_formats::asset::{EncodedImage, Material, Part};
use orb_formats::spz::{self, Axes, Version};
use orb_formats::{Asset, Label, Mesh, Place, Splats, glb, ply, usdz};
use std::path::Path;
use std::process::Command;

mod common;
use common::{Folder, missing, node_package, run, script};

/// A column with a normal to each side; 70,000 vertices where `long`, more than two bytes count.
fn column(long: bool) -> Mesh {
    let sides = if long { 35_000 } else { 24 };
    let mut mesh = Mesh::default();
    for i in 0..=sides {
        let (sin, cos) = (i as f64 / f64::from(sides) * std::f64::consts::TAU).sin_cos();
        for z in [0.0, 2.0] {
            mesh.positions.push([cos, sin, z]);
            mesh.normals.push([cos as f32, sin as f32, 0.0]);
            mesh.uvs.push([i as f32 / sides as f32, z as f32 / 2.0]);
        }
    }
    let sides = sides as u32;
    mesh.triangles = (0..sides).flat_map(|i| [[2 * i, 2 * i + 2, 2 * i + 3], [2 * i, 2 * i + 3, 2 * i + 1]]).collect();
    mesh
}

/// One white pixel.
const PNG: [u8; 67] = [
    137, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13, 73, 72, 68, 82, 0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0, 58, 126, 155,
    85, 0, 0, 0, 10, 73, 68, 65, 84, 8, 215, 99, 248, 15, 0, 1, 1, 1, 0, 27, 182, 238, 86, 0, 0, 0, 0, 73, 69, 78, 68,
    174, 66, 96, 130,
];

fn asset(long: bool) -> Asset {
    let place = Place { latitude: 34.5523, longitude: -118.4712, height: 740.0, heading: 12.5 };
    let mut plain = column(false);
    plain.positions.iter_mut().for_each(|p| p[0] += 3.0);
    Asset {
        name: "column".into(),
        parts: vec![Part { mesh: column(long), material: Some(0) }, Part { mesh: plain, material: Some(1) }],
        materials: vec![
            Material {
                name: "photo".into(),
                image: Some(0),
                normal_image: Some(1),
                occlusion_image: Some(2),
                ..Material::default()
            },
            Material { name: "red".into(), base_color: [1.0, 0.1, 0.1, 1.0], metallic: 0.5, ..Material::default() },
        ],
        images: vec![EncodedImage { media_type: "image/png".into(), bytes: PNG.to_vec() }; 3],
        splats: None,
        label: Label { marking: "CLASSIFICATION: UNCLASSIFIED".into(), place: Some(place) },
    }
}

fn splats(count: usize, degree: u32) -> Splats {
    let mut state = 1u32;
    let mut next = move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 / (1 << 24) as f32
    };
    let mut out = Splats::default();
    for _ in 0..count {
        out.positions.push([0; 3].map(|_| next() * 8.0 - 4.0));
        out.log_scales.push([0; 3].map(|_| next() * 4.0 - 6.0));
        let q = [0; 4].map(|_| next() * 2.0 - 1.0);
        let length = q.iter().map(|x| x * x).sum::<f32>().sqrt();
        out.rotations.push(q.map(|x| x / length));
        out.logit_opacities.push(next() * 8.0 - 4.0);
        let bases = ((degree + 1) * (degree + 1)) as usize;
        out.sh.push(std::array::from_fn(|b| if b < bases { [0; 3].map(|_| next() * 1.6 - 0.8) } else { [0.0; 3] }));
    }
    out
}

#[test]
fn the_khronos_validator_finds_nothing() {
    if node_package("gltf-validator").is_none() {
        return;
    }
    let folder = Folder::new("gltf");
    for (name, asset) in [("short.glb", asset(false)), ("long.glb", asset(true))] {
        std::fs::write(folder.0.join(name), glb::write(&asset).unwrap()).unwrap();
        let Some(said) = run("node", &[&script("gltf_validate.cjs"), name], &folder.0) else { return };
        assert!(said.contains("errors 0 warnings 0 infos 0 hints 0"), "{said}");
    }
}

/// What meshoptimizer's own decoder unfolds is, value for value, what our reader unfolds; and the validator finds nothing in
/// either file.
#[test]
fn meshoptimizer_unfolds_the_same() {
    let packages = ["gltf-validator", "@gltf-transform/core", "@gltf-transform/extensions", "meshoptimizer"];
    if packages.into_iter().any(|name| node_package(name).is_none()) {
        return;
    }
    let folder = Folder::new("meshopt");
    for (long, vertices) in [(false, 50), (true, 70_002)] {
        let packed = glb::write_as(&asset(long), glb::Compression::Meshopt).unwrap();
        std::fs::write(folder.0.join("packed.glb"), &packed).unwrap();
        let Some(said) = run("node", &[&script("gltf_unfold.cjs"), "packed.glb", "plain.glb"], &folder.0) else {
            return;
        };
        assert!(said.contains("EXT_meshopt_compression") && said.contains(&format!("vertices {vertices}")), "{said}");
        let plain = std::fs::read(folder.0.join("plain.glb")).unwrap();
        assert!(!plain.windows(11).any(|w| w == b"EXT_meshopt"), "compressed still");
        let (ours, theirs) = (glb::read(&packed).unwrap(), glb::read(&plain).unwrap());
        assert_eq!(ours.parts.len(), theirs.parts.len());
        for (a, b) in ours.parts.iter().zip(&theirs.parts) {
            assert_eq!(a.mesh, b.mesh);
        }
        // Of what it does not unfold it looks at the rest.
        for (file, nothing) in
            [("packed.glb", "errors 0 warnings 0 infos 0 hints 0"), ("plain.glb", "errors 0 warnings 0")]
        {
            let said = run("node", &[&script("gltf_validate.cjs"), file], &folder.0).unwrap();
            assert!(said.contains(nothing), "{said}");
        }
    }
}

#[test]
fn openusd_opens_packages_under_arkits_rules() {
    let folder = Folder::new("usdz");
    std::fs::write(folder.0.join("column.usdz"), usdz::write(&asset(false)).unwrap()).unwrap();
    let python = std::env::var("ORB_PYTHON").unwrap_or_else(|_| "python3".into());
    let has_usd = Command::new(&python).args(["-c", "import pxr.UsdGeom"]).output().is_ok_and(|o| o.status.success());
    if !has_usd {
        return missing("OpenUSD (pip install usd-core==25.5) in ORB_PYTHON");
    }
    let Some(said) = run(&python, &[&script("usdz_check.py"), "column.usdz"], &folder.0) else { return };
    assert!(said.contains("column.usdz OK"), "{said}");
    for part in
        ["up Y", "mpu 1.0", "default /Model", "meshes 2", "triangles 96", "CLASSIFICATION: UNCLASSIFIED", "34.5523"]
    {
        assert!(said.contains(part), "{part:?} is missing from {said}");
    }
}

/// The field beside the meshes, value for value; ARKit's rules do not know it, OpenUSD's own since 26.03 do.
#[test]
fn openusd_reads_the_field_of_gaussians() {
    let folder = Folder::new("usdz-field");
    let field = splats(500, 2);
    let whole = Asset { splats: Some(field.clone()), ..asset(false) };
    std::fs::write(folder.0.join("field.usdz"), usdz::write(&whole).unwrap()).unwrap();
    let python = std::env::var("ORB_PYTHON").unwrap_or_else(|_| "python3".into());
    let version = Command::new(&python).args(["-c", "from pxr import Usd; print(*Usd.GetVersion())"]).output();
    let Some(version) = version.ok().filter(|o| o.status.success()) else {
        return missing("OpenUSD (pip install usd-core) in ORB_PYTHON");
    };
    let output = Command::new(&python)
        .args([&script("usdz_check.py"), "field.usdz"])
        .current_dir(&folder.0)
        .output()
        .expect("the Python that answered before");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(said.contains("meshes 2") && said.contains("splats 500 degree 2 coefficients 4500 last"), "{said}");
    let line = said.lines().find(|l| l.contains(" last ")).unwrap();
    let found: Vec<f32> = line.split(" last ").nth(1).unwrap().split(' ').map(|x| x.parse().unwrap()).collect();
    let mut expected = field.positions[499].to_vec();
    expected.extend(field.log_scales[499].map(f32::exp));
    expected.extend(field.rotations[499]);
    expected.push(1.0 / (1.0 + (-field.logit_opacities[499]).exp()));
    expected.extend(field.sh[499][8]);
    assert_eq!(found.len(), expected.len(), "{line}");
    assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-5), "{found:?} {expected:?}");
    // Version 0.26.3 and later have the schema.
    if String::from_utf8_lossy(&version.stdout).split(' ').nth(1).and_then(|m| m.parse().ok()) >= Some(26) {
        assert!(line.contains("schema UsdVolParticleField3DGaussianSplat"), "{line}");
        assert!(said.contains("field.usdz OK"), "{said}");
    }
}

/// Runs splat-transform; `None` where it is missing.
fn splat_transform(arguments: &[&str], folder: &Path) -> Option<()> {
    let package = node_package("@playcanvas/splat-transform")?;
    let program = package.join("bin/cli.mjs");
    run("node", &[&[program.to_str()?], arguments].concat(), folder).map(drop)
}

fn worst<const N: usize>(a: &[[f32; N]], b: &[[f32; N]]) -> f32 {
    assert_eq!(a.len(), b.len());
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

/// A splat's covariance: R S Sᵀ Rᵀ.
fn shape(s: &Splats, i: usize) -> [f32; 9] {
    let [w, x, y, z] = s.rotations[i];
    let r = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ];
    let v = s.log_scales[i].map(|l| (2.0 * l).exp());
    std::array::from_fn(|k| (0..3).map(|j| r[k / 3][j] * v[j] * r[k % 3][j]).sum())
}

/// Equal up to the sign of quaternions and a float's rounding; opacities where both are away from the ends.
fn assert_same(a: &Splats, b: &Splats, tolerance: f32) {
    assert!(worst(&a.positions, &b.positions) < tolerance, "positions {}", worst(&a.positions, &b.positions));
    assert!(worst(&a.log_scales, &b.log_scales) < tolerance.max(1e-5));
    // Several quaternions stand for one ellipsoid: their axes may point either way.
    for i in 0..a.positions.len() {
        let (a, b) = (shape(a, i), shape(b, i));
        let size = a.iter().fold(0.0f32, |m, x| m.max(x.abs()));
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-3 * size), "{a:?} {b:?}");
    }
    for (a, b) in a.logit_opacities.iter().zip(&b.logit_opacities) {
        assert!((a - b).abs() < 1e-2 || a.abs().min(b.abs()) > 5.0, "{a} {b}");
    }
    let colors = |s: &Splats| s.sh.iter().flatten().copied().collect::<Vec<_>>();
    assert!(worst(&colors(a), &colors(b)) < tolerance.max(1e-5), "harmonics {}", worst(&colors(a), &colors(b)));
}

#[test]
fn splat_transform_reads_our_spz() {
    let folder = Folder::new("spz");
    for version in [Version::V2, Version::V3, Version::V4] {
        for degree in [0, 1, 2, 3] {
            let options = spz::Options { version, comment: "CLASSIFICATION: CUI".into(), ..spz::Options::default() };
            let ours = spz::write(&splats(200, degree), &options).unwrap();
            std::fs::write(folder.0.join("ours.spz"), &ours).unwrap();
            if splat_transform(&["-q", "-w", "ours.spz", "back.ply"], &folder.0).is_none() {
                return;
            }
            // Its PLY files have y down and z forward, as 3DGS writes them.
            let (back, _) = ply::read(&std::fs::read(folder.0.join("back.ply")).unwrap()).unwrap();
            let (expected, _) = spz::read(&ours, Axes::RDF).unwrap();
            assert_same(&back, &expected, 1e-5);
        }
    }
}

#[test]
fn we_read_splat_transforms_spz_and_glb() {
    let folder = Folder::new("theirs");
    let scene = splats(200, 3);
    std::fs::write(folder.0.join("scene.ply"), ply::write(&scene, &[]).unwrap()).unwrap();
    for (version, expected) in [("3", Version::V3), ("4", Version::V4)] {
        let arguments = ["-q", "-w", "--spz-version", version, "scene.ply", "theirs.spz"];
        if splat_transform(&arguments, &folder.0).is_none() {
            return;
        }
        let (back, info) = spz::read(&std::fs::read(folder.0.join("theirs.spz")).unwrap(), Axes::RDF).unwrap();
        assert_eq!((info.version, info.degree), (expected, 3));
        assert!(worst(&back.positions, &scene.positions) < 1.0 / 8192.0 + 1e-6);
        assert!(worst(&back.sh.as_flattened()[16..], &scene.sh.as_flattened()[16..]) < 0.07 + 1.0 / 76.5);
    }
    splat_transform(&["-q", "-w", "scene.ply", "theirs.glb"], &folder.0).unwrap();
    let back = glb::read(&std::fs::read(folder.0.join("theirs.glb")).unwrap()).unwrap().splats.unwrap();
    // It lets z face forward in glTF: half a turn about the vertical from ours.
    let theirs = Axes { right: false, up: true, back: false };
    let flipped = spz::flipped(&scene, Axes::RDF, theirs);
    assert_same(&back, &flipped, 1e-5);
    // And ours holds the same accessors.
    let ours = glb::read(&glb::write(&Asset { splats: Some(flipped), ..Asset::default() }).unwrap()).unwrap();
    assert_same(&ours.splats.unwrap(), &back, 1e-5);
}

#[test]
fn we_read_the_compressed_ply_of_splat_transform() {
    let folder = Folder::new("compressed");
    for degree in [0, 3] {
        let scene = splats(700, degree);
        std::fs::write(folder.0.join("scene.ply"), ply::write(&scene, &[]).unwrap()).unwrap();
        let compress = ["-q", "-w", "scene.ply", "scene.compressed.ply"];
        if splat_transform(&compress, &folder.0).is_none() {
            return;
        }
        // What it unpacks itself is what we must unpack.
        splat_transform(&["-q", "-w", "scene.compressed.ply", "unpacked.ply"], &folder.0).unwrap();
        let read = |name: &str| ply::read(&std::fs::read(folder.0.join(name)).unwrap()).unwrap().0;
        assert_eq!(read("scene.compressed.ply").positions.len(), 700);
        assert_same(&read("scene.compressed.ply"), &read("unpacked.ply"), 1e-4);
    }
}
