//! What a system made of a scene: Orb's own published folder, or anyone's PLY, SPZ or GLB, with what they say of it.

use std::path::{Path, PathBuf};

use glam::Vec3;
use image::RgbImage;
use serde::Deserialize;

use super::Picture;
use super::efficiency;
use crate::export::import::{self, SplatAxes};
use crate::mesh::color::{to_linear, to_srgb};
use crate::mesh::{self, View};
use crate::splat::{self, Camera, Gaussians, cameras};
use crate::{Error, Result};

/// Which coordinates a result is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Frame {
    /// The scene's own: nothing is moved.
    Scene,
    /// Orb's subject frame: Z up, +Y where the photo's camera looked. Turned about the vertical, scaled and shifted onto
    /// the truth before it is compared.
    Subject,
    /// Z up, turned anyhow: as `Subject`, from eight headings.
    Free,
}

/// One result, its lengths as they stand in its files.
#[derive(Clone, Debug)]
pub struct Submission {
    pub frame: Frame,
    pub splats: Option<Gaussians>,
    pub mesh: Option<(mesh::Mesh, RgbImage)>,
    /// Height of the ground it stands on, where it is known.
    pub ground: Option<f32>,
    /// Cameras that the system worked out, by the names of the scene's views; in the result's frame.
    pub cameras: Vec<(String, Camera)>,
    /// Frames of a flight that the system drew itself, in their order.
    pub frames: Vec<(String, Camera, Picture)>,
    /// What its maker measured.
    pub seconds: Option<f64>,
    pub peak_memory_bytes: Option<f64>,
    /// Whether it was made without a network, where that is proved.
    pub offline: Option<bool>,
    pub files: Vec<FileFact>,
    /// What was read: name and bytes.
    pub inputs: Vec<(String, Vec<u8>)>,
}

/// A file of a result.
#[derive(Clone, Debug, PartialEq)]
pub struct FileFact {
    pub name: String,
    pub bytes: u64,
    /// None: of a format that is not checked.
    pub finding: Option<efficiency::Finding>,
}

/// `result.json`; all of it may be left out.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Said {
    frame: Option<Frame>,
    splats: Option<PathBuf>,
    mesh: Option<PathBuf>,
    axes: Option<Axes>,
    ground: Option<f32>,
    cameras: Option<PathBuf>,
    frames: Option<PathBuf>,
    seconds: Option<f64>,
    peak_memory_bytes: Option<f64>,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Axes {
    ZUp,
    YUp,
    YDown,
}

/// The result of a scene in a folder of results: `NAME/`, `NAME.ply`, `NAME.spz` or `NAME.glb`.
pub fn find(results: &Path, scene: &str) -> Option<PathBuf> {
    let at = |ending: &str| results.join(format!("{scene}{ending}"));
    let folder = at("");
    if folder.is_dir() {
        return Some(folder);
    }
    [".ply", ".spz", ".glb"].into_iter().map(at).find(|p| p.is_file())
}

/// Reads one result: a file, or a folder with splats (`scene.ply`, else the first PLY or SPZ) and a model (the first GLB
/// that is no coarser level), or what its `result.json` names.
///
/// # Errors
/// Usage, naming the file, where nothing is there or cannot be read.
pub fn read(path: &Path) -> Result<Submission> {
    let folder = if path.is_dir() { path } else { path.parent().unwrap_or(Path::new(".")) };
    let mut inputs = Vec::new();
    let mut load = |file: &Path| -> Result<Vec<u8>> {
        let bytes = std::fs::read(file).map_err(|e| Error::io(file, &e))?;
        inputs.push((file.file_name().unwrap_or_default().to_string_lossy().into_owned(), bytes.clone()));
        Ok(bytes)
    };
    let list = folder.join("result.json");
    let said = if path.is_dir() && list.is_file() {
        serde_json::from_slice::<Said>(&load(&list)?).map_err(|e| {
            Error::usage(list.display().to_string()).expected("what docs/orb-bench.md lists").found(e.to_string())
        })?
    } else {
        Said::default()
    };
    let (splats, mesh) = if path.is_dir() {
        let names = names(folder)?;
        let ends = |e: &str| names.iter().find(|n| n.ends_with(e) && !n.contains("_lod") && *n != "network.ply");
        let splats = names.iter().find(|n| *n == "scene.ply").or(ends(".ply")).or(ends(".spz"));
        let given = said.splats.is_some() || said.mesh.is_some();
        let choose = |own: &Option<PathBuf>, found: Option<&String>| match (own, given) {
            (Some(p), _) => Some(folder.join(p)),
            (None, true) => None,
            (None, false) => found.map(|n| folder.join(n)),
        };
        (choose(&said.splats, splats), choose(&said.mesh, ends(".glb")))
    } else if path.extension().is_some_and(|e| e == "glb") {
        (None, Some(path.to_owned()))
    } else {
        (Some(path.to_owned()), None)
    };
    let axes = said.axes.map(|a| match a {
        Axes::ZUp => SplatAxes::ZUp,
        Axes::YUp => SplatAxes::YUp,
        Axes::YDown => SplatAxes::YDown,
    });
    // What lies in the scene's own frame lies as it is.
    let in_scene = said.frame.is_none_or(|f| f == Frame::Scene);
    let axes = axes.or(in_scene.then_some(SplatAxes::ZUp));
    let mut out = Submission {
        frame: Frame::Scene,
        splats: None,
        mesh: None,
        ground: said.ground,
        cameras: Vec::new(),
        frames: Vec::new(),
        seconds: said.seconds,
        peak_memory_bytes: said.peak_memory_bytes,
        offline: None,
        files: facts(path)?,
        inputs: Vec::new(),
    };
    let mut is_orbs = false;
    for file in [splats, mesh].into_iter().flatten() {
        let bytes = load(&file)?;
        let imported = import::read(&file.display().to_string(), &bytes, axes)?;
        is_orbs |= imported.is_orbs;
        out.splats = out.splats.or(imported.gaussians);
        if let Some(level) = imported.levels.into_iter().next() {
            out.mesh = out.mesh.or(Some((plain(&level.mesh), level.texture)));
        }
    }
    out.frame = said.frame.unwrap_or(if is_orbs { Frame::Subject } else { Frame::Scene });
    if is_orbs {
        out.ground = out.ground.or(Some(0.0));
    }
    if let Some(list) = &said.cameras {
        let list = folder.join(list);
        out.cameras = cameras::parse(&list, &load(&list)?)?;
    }
    let frames = said
        .frames
        .map(|f| folder.join(f))
        .or(Some(folder.join("frames.json")).filter(|f| f.is_file() && path.is_dir()));
    if let Some(list) = frames {
        out.frames = drawn(&list, &load(&list)?)?;
    }
    if out.splats.is_none() && out.mesh.is_none() && out.frames.is_empty() {
        return Err(Error::usage(path.display().to_string())
            .expected("splats (PLY, SPZ), a model (GLB) or frames (frames.json)")
            .found("none"));
    }
    out.inputs = inputs;
    Ok(out)
}

/// Pictures of a list such as `orb render` writes.
fn drawn(list: &Path, bytes: &[u8]) -> Result<Vec<(String, Camera, Picture)>> {
    let json: serde_json::Value = serde_json::from_slice(bytes)
        .map_err(|e| Error::usage(list.display().to_string()).expected("JSON").found(e.to_string()))?;
    let entries = json["cameras"].as_array().or(json["views"].as_array()).cloned().unwrap_or_default();
    let folder = list.parent().unwrap_or(Path::new("."));
    let one = |((name, camera), entry): ((String, Camera), serde_json::Value)| {
        let file = folder.join(entry["file"].as_str().map_or(format!("{name}.png"), str::to_owned));
        let picture = image::open(&file)
            .map_err(|e| Error::usage(file.display().to_string()).expected("a picture").found(e.to_string()))?;
        let camera = camera.resized(picture.width(), picture.height());
        Ok((name, camera, Picture::of_rgba(&picture.into_rgba8(), super::evaluate::BEHIND)))
    };
    cameras::parse(list, bytes)?.into_iter().zip(entries).map(one).collect()
}

fn names(folder: &Path) -> Result<Vec<String>> {
    let entries = std::fs::read_dir(folder).map_err(|e| Error::io(folder, &e))?;
    let mut names: Vec<String> = entries
        .filter_map(|e| e.ok())
        .filter(|e| e.path().is_file())
        .map(|e| e.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    Ok(names)
}

/// Size of every deliverable, and what its format's rules say of it; the seal's own files and notes do not count.
fn facts(path: &Path) -> Result<Vec<FileFact>> {
    let files: Vec<PathBuf> =
        if path.is_dir() { names(path)?.into_iter().map(|n| path.join(n)).collect() } else { vec![path.to_owned()] };
    let mut out = Vec::new();
    for file in files {
        let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if !efficiency::is_model(&name) {
            continue;
        }
        let bytes = std::fs::read(&file).map_err(|e| Error::io(&file, &e))?;
        out.push(FileFact { bytes: bytes.len() as u64, finding: efficiency::finding(&name, &bytes), name });
    }
    Ok(out)
}

fn plain(m: &orb_formats::Mesh) -> mesh::Mesh {
    mesh::Mesh {
        positions: m.positions.iter().map(|p| Vec3::from_array(p.map(|v| v as f32))).collect(),
        normals: m.normals.iter().map(|n| Vec3::from_array(*n)).collect(),
        uvs: m.uvs.iter().map(|t| glam::Vec2::from_array(*t)).collect(),
        triangles: m.triangles.clone(),
    }
}

/// What is drawn of a result.
#[derive(Clone, Copy)]
pub enum Appearance<'a> {
    Splats(&'a Gaussians),
    Mesh(&'a mesh::Mesh, &'a RgbImage),
}

impl Appearance<'_> {
    /// A picture over `behind`, with alpha and depth.
    pub fn draw(&self, camera: &Camera, behind: [f32; 3]) -> View {
        match self {
            Appearance::Splats(g) => {
                let frame = splat::render(g, camera, behind);
                let color = frame.color.into_iter().map(|c| c.map(|v| v.clamp(0.0, 1.0))).collect();
                View { camera: *camera, color, alpha: frame.alpha, depth: frame.median_depth, passing: mesh::MEDIAN }
            }
            Appearance::Mesh(mesh, texture) => {
                let (color, alpha) = straight(mesh, texture, camera);
                let over = |(c, a): (&[f32; 3], &f32)| std::array::from_fn(|k| c[k] * a + behind[k] * (1.0 - a));
                let color = color.iter().zip(&alpha).map(over).collect();
                let depth = mesh::raster::visibility(&mesh.positions, &mesh.triangles, camera).depth;
                View { camera: *camera, color, alpha, depth, passing: mesh::MEDIAN }
            }
        }
    }
}

/// A mesh's colours, what is behind it taken out, and its cover; 2 × 2 samples a pixel.
pub fn straight(mesh: &mesh::Mesh, texture: &RgbImage, camera: &Camera) -> (Vec<[f32; 3]>, Vec<f32>) {
    const FINER: u32 = 2;
    let picture = mesh::raster(mesh, Some(texture), camera, [0; 3], FINER);
    let fine = camera.resized(camera.width * FINER, camera.height * FINER);
    let seen = mesh::raster::visibility(&mesh.positions, &mesh.triangles, &fine);
    let mut alpha = vec![0.0; (camera.width * camera.height) as usize];
    for i in (0..seen.triangle.len()).filter(|i| seen.triangle[*i] != u32::MAX) {
        let (x, y) = (i % seen.width / FINER as usize, i / seen.width / FINER as usize);
        alpha[y * camera.width as usize + x] += 1.0 / (FINER * FINER) as f32;
    }
    // Light was added up where it is linear.
    let own = |(p, a): (&image::Rgb<u8>, &f32)| match *a {
        a if a > 0.0 => p.0.map(|v| to_srgb((to_linear(f32::from(v) / 255.0) / a).min(1.0))),
        _ => [0.0; 3],
    };
    (picture.pixels().zip(&alpha).map(own).collect(), alpha)
}
