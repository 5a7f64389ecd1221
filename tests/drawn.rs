//! An OpenFlight model as OpenSceneGraph draws it, against our own picture of the same surface from the same eye.
//!
//! The surface is read from the GLB that the same command wrote, so that both writers must agree; every comparison is
//! also made with files that are wrong on purpose, which must fail it.
//!
//! `ORB_DRAWN_PICTURES=DIR` keeps what was compared, side by side.

use std::path::{Path, PathBuf};
use std::process::Command;

use glam::{Vec2, Vec3};
use image::{Rgb, RgbImage, RgbaImage};
use orb::mesh::{Mesh, raster};
use orb::splat::Camera;
use orb_formats::{glb, openflight, sgi};

const HEADING: f64 = 200.0;
/// Share of the silhouettes' union that both cover, at least. 512² pixels; two rasterisers differ by the rim.
const LEAST_OVERLAP: f64 = 0.995;
/// Mean difference of a colour channel where both drew, of 255, at most.
const MOST_DIFFERENCE: f64 = 4.5;

/// What two pictures have in common.
#[derive(Clone, Copy, Debug)]
struct Likeness {
    /// Intersection over union of the silhouettes.
    overlap: f64,
    /// Mean absolute difference a channel over the intersection, of 255.
    difference: f64,
}

impl Likeness {
    fn is_close(self) -> bool {
        self.overlap >= LEAST_OVERLAP && self.difference <= MOST_DIFFERENCE
    }

    /// `background` is what our picture has where nothing is.
    fn of(theirs: &RgbaImage, ours: &RgbImage, covered: &[bool]) -> Likeness {
        let (mut both, mut either, mut sum) = (0u32, 0u32, 0u64);
        for ((their, our), &covered) in theirs.pixels().zip(ours.pixels()).zip(covered) {
            let drawn = their.0[3] > 127;
            either += u32::from(drawn || covered);
            if drawn && covered {
                both += 1;
                sum += (0..3).map(|k| u64::from(their.0[k].abs_diff(our.0[k]))).sum::<u64>();
            }
        }
        Likeness {
            overlap: f64::from(both) / f64::from(either.max(1)),
            difference: sum as f64 / f64::from(3 * both.max(1)),
        }
    }
}

/// One level's surface in the frame of the OpenFlight file: x east, y north.
struct Surface {
    mesh: Mesh,
    texture: RgbImage,
}

impl Surface {
    fn read(path: &Path) -> Surface {
        let asset = glb::read(&std::fs::read(path).unwrap()).unwrap();
        let part = &asset.parts[0].mesh;
        let (sin, cos) = HEADING.to_radians().sin_cos();
        let turn = |[x, y, z]: [f64; 3]| Vec3::new((x * cos + y * sin) as f32, (y * cos - x * sin) as f32, z as f32);
        let image = image::load_from_memory(&asset.images[0].bytes).unwrap();
        Surface {
            mesh: Mesh {
                positions: part.positions.iter().map(|p| turn(*p)).collect(),
                normals: part.normals.iter().map(|n| turn(n.map(f64::from))).collect(),
                uvs: part.uvs.iter().map(|t| Vec2::from_array(*t)).collect(),
                triangles: part.triangles.clone(),
            },
            texture: image.to_rgb8(),
        }
    }

    /// Seen from where OpenSceneGraph's eye was, about its centre, so that far eyes lose no digits.
    fn draw(&self, eye: &Eye) -> (RgbImage, Vec<bool>) {
        let mut mesh = self.mesh.clone();
        let centre = Vec3::from_array(eye.centre.map(|c| c as f32));
        mesh.positions.iter_mut().for_each(|p| *p -= centre);
        let from = Vec3::from_array(std::array::from_fn(|k| (eye.at[k] - eye.centre[k]) as f32));
        let camera = Camera::look_at(from, Vec3::ZERO, eye.view.to_radians() as f32, 512);
        let picture = raster(&mesh, Some(&self.texture), &camera, [255, 255, 255], 2);
        let seen = raster::visibility(&mesh.positions, &mesh.triangles, &camera);
        (picture, seen.triangle.iter().map(|t| *t != u32::MAX).collect())
    }
}

/// What `osgcheck` says of its camera.
#[derive(Debug)]
struct Eye {
    at: [f64; 3],
    centre: [f64; 3],
    /// Degrees from rim to rim.
    view: f64,
}

impl Eye {
    fn read(said: &str) -> Eye {
        let line = said.lines().find_map(|l| l.trim().strip_prefix("camera eye ")).unwrap_or_else(|| panic!("{said}"));
        let n: Vec<f64> = line.split_whitespace().filter_map(|w| w.parse().ok()).collect();
        Eye { at: [n[0], n[1], n[2]], centre: [n[3], n[4], n[5]], view: n[6] }
    }
}

/// Where to look from: azimuth and elevation in degrees, metres (0: near).
#[derive(Clone, Copy, Debug)]
struct View(f64, f64, f64);

/// The program that draws, and a folder for what it draws, with an empty one to draw from.
struct Osg {
    program: PathBuf,
    folder: tempfile::TempDir,
}

impl Osg {
    /// `None` where it cannot be built or shown, which `ORB_REQUIRE_CLIENTS` forbids.
    fn build() -> Option<Osg> {
        let folder = tempfile::tempdir().unwrap();
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/clients/osgcheck.cpp");
        let libraries = ["osg", "osgDB", "osgViewer", "osgUtil", "osgGA", "OpenThreads"].map(|l| format!("-l{l}"));
        let (program, built) = match std::env::var_os("ORB_OSGCHECK") {
            Some(built) => (built.into(), true),
            None => {
                let program = folder.path().join("osgcheck");
                let mut build = Command::new("g++");
                build.args(["-O1", "-o"]).arg(&program).arg(source).args(libraries);
                (program, build.output().is_ok_and(|o| o.status.success()))
            }
        };
        let shown = Command::new("xvfb-run").arg("--help").output().is_ok();
        if !(built && shown) {
            assert!(
                std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(),
                "OpenSceneGraph's headers and xvfb-run are required"
            );
            eprintln!("skipped: OpenSceneGraph's headers or xvfb-run are missing");
            return None;
        }
        std::fs::create_dir(folder.path().join("empty")).unwrap();
        Some(Osg { program, folder })
    }

    fn draw(&self, flt: &Path, View(azimuth, elevation, metres): View, unlit: bool) -> (RgbaImage, Eye) {
        let picture = self.folder.path().join("picture.png");
        let _ = std::fs::remove_file(&picture);
        let numbers = [azimuth, elevation, metres].map(|n| n.to_string());
        let mut command = Command::new("xvfb-run");
        command.arg("-a").arg(&self.program).args([flt, &picture]).args(numbers);
        let out =
            command.args(unlit.then_some("unlit")).current_dir(self.folder.path().join("empty")).output().unwrap();
        let said = format!("{}{}", String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr));
        let image = image::open(&picture).unwrap_or_else(|e| panic!("{e}: {said}"));
        (image.to_rgba8(), Eye::read(&said))
    }
}

/// Both pictures side by side, for people.
fn keep(name: &str, theirs: &RgbaImage, ours: &RgbImage) {
    let Some(folder) = std::env::var_os("ORB_DRAWN_PICTURES").map(PathBuf::from) else { return };
    std::fs::create_dir_all(&folder).unwrap();
    let sheet = RgbImage::from_fn(1024, 512, |x, y| match x.checked_sub(512) {
        Some(x) => *ours.get_pixel(x, y),
        None => {
            let p = theirs.get_pixel(x, y).0;
            if p[3] > 127 { Rgb([p[0], p[1], p[2]]) } else { Rgb([255; 3]) }
        }
    });
    sheet.save(folder.join(format!("{name}.png"))).unwrap();
}

/// A change that makes a model wrong.
type Wrong = fn(&mut orb_formats::Mesh);

#[test]
fn openscenegraph_draws_what_we_draw() {
    let Some(osg) = Osg::build() else { return };
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/truth/forklift/mesh.glb");
    let made = Command::new(env!("CARGO_BIN_EXE_orb"))
        .args(["export", model.to_str().unwrap(), "--origin", "-54.8019,-68.3030,12.5", "--heading"])
        .args([&HEADING.to_string(), "--lods", "3", "--format", "flt,glb", "-o"])
        .arg(&out)
        .env("ORB_DATA_DIR", dir.path().join("data"))
        .output()
        .unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let flt = out.join("mesh.flt");
    let file = openflight::read(&std::fs::read(&flt).unwrap()).unwrap();
    assert_eq!(file.levels.len(), 4);
    // Finest first, as the GLBs are named.
    let surfaces: Vec<Surface> = ["mesh.glb", "mesh_lod1.glb", "mesh_lod2.glb", "mesh_lod3.glb"]
        .map(|name| Surface::read(&out.join(name)))
        .into();
    let compare = |name: &str, flt: &Path, surface: &Surface, view: View| {
        let (theirs, eye) = osg.draw(flt, view, true);
        let (ours, covered) = surface.draw(&eye);
        keep(name, &theirs, &ours);
        let likeness = Likeness::of(&theirs, &ours, &covered);
        println!("{name}: {likeness:?}");
        likeness
    };

    // From three sides near by, then every level at a distance where it is the one that shows.
    for (i, view) in [View(-50.0, 20.0, 0.0), View(75.0, 10.0, 0.0), View(200.0, 55.0, 0.0)].into_iter().enumerate() {
        let likeness = compare(&format!("near_{i}"), &flt, &surfaces[0], view);
        assert!(likeness.is_close(), "{view:?}: {likeness:?}");
    }
    // The file has the coarsest first. A tenth of each range blends in viewers that blend.
    let distances: Vec<f64> = file
        .levels
        .iter()
        .rev()
        .map(|l| l.switch_out + 0.5 * (l.switch_in.min(4.0 * l.switch_out.max(10.0)) - l.switch_out))
        .collect();
    assert!(distances.is_sorted(), "{distances:?}");
    for (i, surface) in surfaces.iter().enumerate() {
        let likeness = compare(&format!("level_{i}"), &flt, surface, View(-50.0, 20.0, distances[i]));
        assert!(likeness.is_close(), "level {i} at {} m: {likeness:?}", distances[i]);
    }
    which_level_shows(&osg, &out, &file, &distances);

    // Lit by a lamp at the eye, what faces it is nearly as bright as the texture: normals point outwards, and the
    // material is no black.
    let brightness = |i: &RgbaImage| {
        let drawn = i.pixels().filter(|p| p.0[3] > 127);
        drawn.map(|p| p.0[..3].iter().map(|c| f64::from(*c)).sum::<f64>()).sum::<f64>()
    };
    let view = View(-50.0, 20.0, 0.0);
    let plain = brightness(&osg.draw(&flt, view, true).0);
    let lit = brightness(&osg.draw(&flt, view, false).0) / plain;
    assert!((0.5..=1.05).contains(&lit), "a lit picture is {lit} as bright as the texture");

    // What must not pass: the files wrong on purpose.
    let rewritten = |name: &str, change: &dyn Fn(&mut openflight::Model)| {
        let mut wrong = file.clone();
        change(&mut wrong);
        let path = out.join(name);
        std::fs::write(&path, openflight::write(&wrong).unwrap()).unwrap();
        path
    };
    let wrongs: [(&str, Wrong); 4] = [
        ("axes", |m| m.positions.iter_mut().for_each(|p| (p[1], p[2]) = (-p[2], p[1]))),
        ("mirrored", |m| {
            m.positions.iter_mut().for_each(|p| p[0] = -p[0]);
            m.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }),
        ("turned", |m| m.positions.iter_mut().for_each(|p| (p[0], p[1]) = (-p[0], -p[1]))),
        ("flipped", |m| m.uvs.iter_mut().for_each(|t| t[1] = 1.0 - t[1])),
    ];
    for (name, wrong) in wrongs {
        let path = rewritten("wrong.flt", &|m| m.levels.iter_mut().for_each(|l| wrong(&mut l.mesh)));
        let likeness = compare(name, &path, &surfaces[0], view);
        assert!(!likeness.is_close(), "a model with {name} passes: {likeness:?}");
    }
    for (i, surface) in surfaces.iter().enumerate() {
        let path = rewritten("missing.flt", &|m| drop(m.levels.remove(m.levels.len() - 1 - i)));
        let likeness = compare(&format!("missing_{i}"), &path, surface, View(-50.0, 20.0, distances[i]));
        assert!(!likeness.is_close(), "without level {i} the model passes: {likeness:?}");
    }
    let inward = rewritten("inward.flt", &|m| {
        m.levels.iter_mut().flat_map(|l| &mut l.mesh.normals).for_each(|n| *n = n.map(|c| -c));
    });
    let dark = brightness(&osg.draw(&inward, view, false).0) / plain;
    assert!(dark < 0.4, "with normals turned inwards it is {dark} as bright");
}

/// Paints every level in a colour of its own, and looks which one is seen at each distance.
fn which_level_shows(osg: &Osg, out: &Path, file: &openflight::Model, distances: &[f64]) {
    let folder = out.join("painted");
    std::fs::create_dir(&folder).unwrap();
    std::fs::copy(out.join("mesh.flt"), folder.join("mesh.flt")).unwrap();
    let paint = [[250, 20, 20], [20, 250, 20], [20, 20, 250], [250, 250, 20]];
    for (level, paint) in file.levels.iter().rev().zip(paint) {
        let name = &file.textures[level.texture.unwrap()];
        let image = orb_formats::Image { width: 256, height: 256, channels: 3, pixels: paint.repeat(1 << 16) };
        std::fs::write(folder.join(name), sgi::write(&image, "", true).unwrap()).unwrap();
        std::fs::copy(out.join(format!("{name}.attr")), folder.join(format!("{name}.attr"))).unwrap();
    }
    for (i, metres) in distances.iter().enumerate() {
        let (picture, _) = osg.draw(&folder.join("mesh.flt"), View(-50.0, 20.0, *metres), true);
        let drawn: Vec<_> = picture.pixels().filter(|p| p.0[3] == 255).collect();
        let right = drawn.iter().filter(|p| p.0[..3].iter().zip(paint[i]).all(|(a, b)| a.abs_diff(b) < 8)).count();
        assert!(
            drawn.len() > 2000 && right * 100 > drawn.len() * 95,
            "level {i} at {metres} m: {right} of {}",
            drawn.len()
        );
    }
}
