//! What is to be reconstructed, and what is known of the truth: four layouts of a folder.
//!
//! * `scene.json` or `cameras.json`: Orb's own (`docs/orb-bench.md`), such as `samples/truth`;
//! * `transforms_test.json` or `transforms.json`: NeRF's synthetic scenes (Mildenhall et al. 2020);
//! * `sparse/0` beside `images`: COLMAP's, such as Mip-NeRF 360 and Tanks and Temples.

use std::path::{Path, PathBuf};

use image::RgbaImage;
use serde::Deserialize;
use serde_json::Value;

use super::truth;
use crate::mesh::Surface;
use crate::photos::{colmap, transforms};
use crate::splat::{Camera, cameras};
use crate::{Error, Result};

/// A scene; lengths in metres where it comes from Orb's own layout.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    pub name: String,
    pub folder: PathBuf,
    /// What a single-photo system is given.
    pub photo: Option<Photo>,
    /// True pictures that nobody was given.
    pub tests: Vec<View>,
    /// Pictures that a system of several photos was given.
    pub training: Vec<View>,
    /// The true surface, Z up.
    pub surface: Option<Surface>,
    /// Height of the ground.
    pub ground: f32,
    /// Least and most of the longest side that things of this class have, metres.
    pub sizes: Option<[f64; 2]>,
    /// One thing to look at from around, not surroundings to look out at.
    pub is_object: bool,
}

#[derive(Clone, Debug)]
pub struct Photo {
    pub file: PathBuf,
    pub camera: Camera,
    /// White, or opaque, on the subject.
    pub mask: Option<PathBuf>,
}

/// A picture and its camera.
#[derive(Clone, Debug)]
pub struct View {
    pub name: String,
    pub camera: Camera,
    pub file: PathBuf,
    /// How the picture is to be straightened first.
    pub lens: Option<colmap::Camera>,
}

impl View {
    /// The picture, straightened, at most `most` pixels a side, and its camera.
    ///
    /// # Errors
    /// Usage, naming the file, for what is no picture or not of the camera's shape.
    pub fn load(&self, most: u32) -> Result<(RgbaImage, Camera)> {
        let shown = self.file.display().to_string();
        let picture =
            image::open(&self.file).map_err(|e| Error::usage(&shown).expected("a picture").found(e.to_string()))?;
        let (w, h) = (picture.width(), picture.height());
        let shape = |w: u32, h: u32| f64::from(w) / f64::from(h);
        let wanted = shape(self.camera.width, self.camera.height);
        if (shape(w, h) / wanted - 1.0).abs() > 0.02 {
            return Err(Error::usage(shown)
                .expected(format!(
                    "a picture of the shape of its camera, {} × {}",
                    self.camera.width, self.camera.height
                ))
                .found(format!("{w} × {h}")));
        }
        let picture = match &self.lens {
            Some(lens) if !lens.lens.is_pinhole() => {
                image::DynamicImage::ImageRgb8(lens.undistorted(&picture.into_rgb8())).into_rgba8()
            }
            _ => picture.into_rgba8(),
        };
        let larger = w.max(h);
        let (w, h) = if larger <= most { (w, h) } else { (w * most / larger, h * most / larger) };
        let (w, h) = (w.max(1), h.max(1));
        let picture = if picture.dimensions() == (w, h) { picture } else { image::imageops::thumbnail(&picture, w, h) };
        Ok((picture, self.camera.resized(w, h)))
    }
}

/// Reads a scene, whichever layout it has.
///
/// # Errors
/// Usage, naming the file, for a folder of another kind and for files that cannot be read.
pub fn read(folder: &Path) -> Result<Scene> {
    let name = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let name = name.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let base = Scene { name, folder: folder.to_owned(), is_object: true, ..Scene::default() };
    for list in ["scene.json", "cameras.json"] {
        let path = folder.join(list);
        if path.is_file() {
            return own(base, &path);
        }
    }
    for list in ["transforms_test.json", "transforms.json"] {
        let path = folder.join(list);
        if path.is_file() {
            let all = transforms(&path)?;
            let is_test = list == "transforms_test.json";
            let (tests, training) = if is_test { (all, Vec::new()) } else { every_eighth(all) };
            let path = folder.join("transforms_train.json");
            let training = if is_test && path.is_file() { transforms(&path)? } else { training };
            return Ok(Scene { tests, training, ..base });
        }
    }
    for model in ["sparse/0", "sparse"] {
        let model = folder.join(model);
        if ["cameras.bin", "cameras.txt"].iter().any(|f| model.join(f).is_file()) {
            let (tests, training) = every_eighth(colmap_views(&model, &folder.join("images"))?);
            return Ok(Scene { tests, training, is_object: false, ..base });
        }
    }
    Err(Error::usage(folder.display().to_string())
        .expected("scene.json, cameras.json, transforms.json or COLMAP's sparse/0")
        .found("none of them")
        .advice("`orb bench make` writes scenes; docs/orb-bench.md has the layout."))
}

/// Every eighth view, by name, is held back; those, then the others.
fn every_eighth(mut all: Vec<View>) -> (Vec<View>, Vec<View>) {
    all.sort_by(|a, b| a.name.cmp(&b.name));
    let (tests, training): (Vec<_>, Vec<_>) = all.into_iter().enumerate().partition(|(i, _)| colmap::is_test(*i));
    let plain = |v: Vec<(usize, View)>| v.into_iter().map(|(_, v)| v).collect();
    (plain(tests), plain(training))
}

/// What of `scene.json` is no camera.
#[derive(Deserialize)]
struct Facts {
    name: Option<String>,
    mesh: Option<String>,
    #[serde(default)]
    ground: f32,
    size_range_m: Option<[f64; 2]>,
}

fn own(base: Scene, path: &Path) -> Result<Scene> {
    let shown = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|e| Error::io(path, &e))?;
    let wrong = |expected: &str, found: String| Error::usage(&shown).expected(expected).found(found);
    let json: Value = serde_json::from_slice(&bytes).map_err(|e| wrong("JSON", e.to_string()))?;
    let facts: Facts = Facts::deserialize(&json).map_err(|e| wrong("the facts of a scene", e.to_string()))?;
    if let Some([least, most]) = facts.size_range_m
        && !(0.0 < least && least <= most && most.is_finite())
    {
        return Err(wrong("size_range_m of two lengths, the smaller first", format!("{least}, {most}")));
    }
    let mut scene = Scene { ground: facts.ground, sizes: facts.size_range_m, ..base };
    scene.name = facts.name.unwrap_or(scene.name);
    let (mut photos, mut mask) = (Vec::new(), None);
    let listed = json["views"].as_array().cloned().unwrap_or_default();
    for ((name, camera), v) in cameras::parse(path, &bytes)?.into_iter().zip(listed) {
        let file = v["file"].as_str().ok_or_else(|| wrong("a file for every view", format!("none for {name}")))?;
        let view = View { file: scene.folder.join(file), camera, lens: None, name };
        match v["group"].as_str() {
            Some("photo") if view.name == "mask" => mask = Some(view.file),
            Some("photo") => photos.push(view),
            Some("test" | "gt") => scene.tests.push(view),
            Some("train") => scene.training.push(view),
            _ => {}
        }
    }
    // Of several photos the one in its surroundings is the harder one.
    let photo = photos.iter().position(|v| v.name == "outdoor").or(photos.len().checked_sub(1));
    scene.photo = photo.map(|i| Photo { file: photos[i].file.clone(), camera: photos[i].camera, mask });
    let mesh = scene.folder.join(facts.mesh.as_deref().unwrap_or("mesh.glb"));
    if facts.mesh.is_some() || mesh.is_file() {
        let bytes = std::fs::read(&mesh).map_err(|e| Error::io(&mesh, &e))?;
        let surface = truth::glb(&bytes).filter(|s| !s.triangles.is_empty());
        scene.surface = Some(surface.ok_or_else(|| {
            Error::usage(mesh.display().to_string()).expected("triangles in binary glTF").found("none")
        })?);
    }
    Ok(scene)
}

/// The views of one of NeRF's lists.
///
/// # Errors
/// As [`transforms::read`].
pub fn transforms(list: &Path) -> Result<Vec<View>> {
    let view = |l: transforms::Listed| View {
        camera: l.camera.posed(l.rotation, l.translation),
        name: l.name,
        file: l.file,
        lens: Some(l.camera),
    };
    Ok(transforms::read(list)?.into_iter().map(view).collect())
}

fn colmap_views(model: &Path, pictures: &Path) -> Result<Vec<View>> {
    let model = colmap::read(model)?;
    let view = |i: &colmap::Image| {
        let camera = model.cameras.get(&i.camera)?;
        let lens = Some(camera.clone());
        Some(View { name: i.name.clone(), camera: i.pinhole(camera), file: pictures.join(&i.name), lens })
    };
    Ok(model.images.iter().filter_map(view).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn the_samples_of_this_repository_are_scenes() {
        let scene = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/truth/smart_car")).unwrap();
        let photo = scene.photo.unwrap();
        assert!(photo.file.ends_with("smart_car.jpg") && photo.mask.unwrap().ends_with("mask.png"));
        assert!(scene.surface.is_some() && scene.is_object && scene.tests.is_empty());
        assert_eq!(scene.name, "smart_car");
        let e = read(Path::new(env!("CARGO_MANIFEST_DIR"))).unwrap_err().to_string();
        assert!(e.contains("scene.json"), "{e}");
    }

    #[test]
    fn lists_of_nerf_and_of_colmap_hold_every_eighth_back() {
        let folder = tempfile::tempdir().unwrap();
        let frames: Vec<String> = (0..9)
            .map(|i| {
                image::RgbaImage::from_pixel(4, 4, image::Rgba([255, 0, 0, 128]))
                    .save(folder.path().join(format!("a{i}.png")))
                    .unwrap();
                format!(
                    r#"{{"file_path": "./a{i}", "transform_matrix": [[1,0,0,{i}],[0,0,-1,-3],[0,1,0,0],[0,0,0,1]]}}"#
                )
            })
            .collect();
        let text = format!(r#"{{"camera_angle_x": 1.5707963267948966, "frames": [{}]}}"#, frames.join(","));
        std::fs::write(folder.path().join("transforms.json"), &text).unwrap();
        let scene = read(folder.path()).unwrap();
        let names: Vec<&str> = scene.tests.iter().map(|v| v.name.as_str()).collect();
        assert_eq!((names, scene.training.len()), (vec!["./a0", "./a8"], 7));
        let (picture, camera) = scene.tests[1].load(2).unwrap();
        assert_eq!((picture.dimensions(), camera.width, camera.fx), ((2, 2), 2, 1.0));
        assert!((camera.position() - Vec3::new(8.0, -3.0, 0.0)).length() < 1e-6);
        assert!((camera.rotation * Vec3::Y - Vec3::Z).length() < 1e-6, "forward");

        let model = folder.path().join("c/sparse/0");
        std::fs::create_dir_all(&model).unwrap();
        std::fs::create_dir_all(folder.path().join("c/images")).unwrap();
        std::fs::copy(folder.path().join("a1.png"), folder.path().join("c/images/x.png")).unwrap();
        std::fs::write(model.join("cameras.txt"), "1 SIMPLE_RADIAL 4 4 4 2 2 0.01\n").unwrap();
        std::fs::write(model.join("images.txt"), "7 1 0 0 0 0 0 5 1 x.png\n\n").unwrap();
        std::fs::write(model.join("points3D.txt"), "").unwrap();
        let scene = read(&folder.path().join("c")).unwrap();
        assert!(!scene.is_object && scene.tests[0].name == "x.png");
        assert_eq!(scene.tests[0].load(64).unwrap().0.dimensions(), (4, 4));
    }
}
