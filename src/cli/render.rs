//! `orb render SCENE.ply`: pictures of a splat from given cameras or from all around.

use std::collections::BTreeMap;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use image::{ExtendedColorType, ImageEncoder};
use serde_json::json;

use super::bar::Bar;
use super::device::Device;
use super::marking;
use super::sealed::{Evidence, PublishArgs, SealedRun};
use crate::audit::inband;
use crate::audit::statement::Param;
use crate::audit::{record, time};
use crate::export::import::gaussians;
use crate::progress::Progress;
use crate::splat::cameras;
use crate::splat::render::gpu::{Renderer, Scene};
use crate::splat::render::{self, Frame};
use crate::splat::{Camera, Gaussians};
use crate::{Error, Result};

/// Draw a splat (PLY) from cameras.
#[derive(Clone, Debug, clap::Args)]
pub struct Render {
    /// A 3D Gaussian Splatting scene.
    pub scene: PathBuf,
    /// Camera list (JSON): "cameras" with world_to_camera, or "views" with w2c_opencv.
    #[arg(long, value_name = "CAMERAS.json", required_unless_present = "turntable", conflicts_with = "turntable")]
    pub camera: Option<PathBuf>,
    /// So many cameras in a circle around the scene.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=3600))]
    pub turntable: Option<u32>,
    /// Folder for the pictures.
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Pixels across a turntable picture.
    #[arg(long, default_value_t = 1024, value_parser = clap::value_parser!(u32).range(1..=8192))]
    pub size: u32,
    /// Also write the depth as a 16-bit PNG; frames.json says how many scene units a step is.
    #[arg(long)]
    pub depth: bool,
    /// Also write the surface's normals as a PNG: x right, y up, z towards the camera, −1 to 1 as 0 to 255.
    #[arg(long)]
    pub normals: bool,
    /// Red, green and blue behind the scene, 0 to 1.
    #[arg(long, value_name = "R,G,B", value_delimiter = ',', default_values_t = [0.0, 0.0, 0.0])]
    pub background: Vec<f32>,
    #[arg(long, value_enum, default_value_t)]
    pub device: Device,
    #[command(flatten)]
    pub publish: PublishArgs,
}

/// Draws and publishes: every picture marked, all of them in a signed record. `stop` is set by the interrupt handler.
pub fn publish(args: &Render, stop: &AtomicBool) -> Result<u8> {
    let bytes = std::fs::read(&args.scene).map_err(|e| Error::io(&args.scene, &e))?;
    let name = args.scene.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let own = marking::carried(&name, &bytes)?;
    let handling = args.publish.marking.decide(std::slice::from_ref(&own), &time::now()?.utc())?;
    let product = handling.marking.clone();
    let input = record::input(&name, &bytes, "application/ply", "scene", own);
    let mut sealed = SealedRun::begin("orb render", &args.output, handling, &args.publish)?;
    let bar = Bar::new(stop, args.publish.quiet);
    let mut say = |line: &str| {
        if !args.publish.quiet {
            eprintln!("orb: {line}");
        }
    };
    let mut put = |file: &str, bytes: &[u8]| {
        if file.ends_with(".png") {
            sealed.publication.add(file, &inband::mark_png(bytes, &product), "image/png", "picture")
        } else {
            sealed.publication.add(file, bytes, "application/json", "cameras")
        }
    };
    run(args, &bar, &mut say, &mut put)?;
    let published = sealed.seal(Evidence {
        event_type: "scene.render",
        time: time::now()?,
        inputs: vec![input],
        models: Vec::new(),
        params: BTreeMap::from([
            ("depth".into(), Param::Bool(args.depth)),
            ("normals".into(), Param::Bool(args.normals)),
        ]),
    })?;
    bar.finish();
    if !args.publish.quiet {
        println!("{}\n{} files in {}", product.banner(), published.outputs.len(), published.folder.display());
    }
    Ok(0)
}

/// Draws every picture and hands each file (name relative to the output folder, bytes) to `put`; last frames.json.
///
/// Errors: usage for a scene or camera list that cannot be used; environment from the GPU; what `put` returns.
pub fn run(
    args: &Render,
    progress: &dyn Progress,
    say: &mut dyn FnMut(&str),
    put: &mut dyn FnMut(&str, &[u8]) -> Result<()>,
) -> Result<()> {
    let background = <[f32; 3]>::try_from(args.background.as_slice())
        .ok()
        .filter(|b| b.iter().all(|v| (0.0..=1.0).contains(v)))
        .ok_or_else(|| Error::usage("--background").expected("three numbers from 0 to 1"))?;
    let scene = load(&args.scene)?;
    let cameras = match (&args.camera, args.turntable) {
        (Some(path), _) => cameras::parse(path, &std::fs::read(path).map_err(|e| Error::io(path, &e))?)?,
        (None, Some(n)) => cameras::turntable(&scene, n as usize, args.size),
        (None, None) => return Err(Error::usage("render").expected("--camera or --turntable").found("neither")),
    };
    let gpu = args.device.open(say)?;
    let mut drawer = match &gpu {
        Some(gpu) => Some((Scene::upload(gpu, &scene)?, Renderer::new(gpu)?)),
        None => None,
    };
    let mut frames = Vec::new();
    progress.begin("render", cameras.len() as u64);
    for (i, (name, camera)) in cameras.iter().enumerate() {
        progress.check()?;
        let frame = match &mut drawer {
            Some((uploaded, renderer)) => renderer.render(uploaded, camera, background)?,
            None => render::render(&scene, camera, background),
        };
        let mut entry = write(name, camera, &frame, args.depth, put)?;
        if args.normals {
            let normals = match &mut drawer {
                Some((uploaded, renderer)) => renderer.normals(uploaded, camera)?,
                None => render::normals(&scene, camera),
            };
            let file = format!("{name}_normals.png");
            let bytes: Vec<u8> =
                normals.iter().flat_map(|n| [n[0], -n[1], -n[2]].map(|v| (v * 127.5 + 128.0) as u8)).collect();
            put(&file, &png(&frame, &bytes, ExtendedColorType::Rgb8)?)?;
            entry["normals_file"] = file.into();
        }
        frames.push(entry);
        progress.step(i as u64 + 1);
    }
    let list =
        json!({ "convention": "OpenCV: x right, y down, z forward; row-major world_to_camera", "cameras": frames });
    let mut text =
        serde_json::to_vec_pretty(&list).map_err(|e| Error::environment("frames.json").found(e.to_string()))?;
    text.push(b'\n');
    put("frames.json", &text)
}

/// A PLY file as Gaussians.
pub fn load(path: &Path) -> Result<Gaussians> {
    let bytes = std::fs::read(path).map_err(|e| Error::io(path, &e))?;
    let (splats, _) = orb_formats::ply::read(&bytes)
        .map_err(|e| Error::usage(path.display().to_string()).expected("a splat in PLY").found(e.to_string()))?;
    Ok(gaussians(splats))
}

/// Writes one picture; its entry in frames.json.
fn write(
    name: &str,
    camera: &Camera,
    frame: &Frame,
    depth: bool,
    put: &mut dyn FnMut(&str, &[u8]) -> Result<()>,
) -> Result<serde_json::Value> {
    let file = format!("{name}.png");
    let bytes: Vec<u8> = frame.color.iter().flatten().map(|v| (v.clamp(0.0, 1.0) * 255.0 + 0.5) as u8).collect();
    put(&file, &png(frame, &bytes, ExtendedColorType::Rgb8)?)?;
    let rows: Vec<Vec<f32>> = (0..4)
        .map(|i| match i {
            3 => vec![0.0, 0.0, 0.0, 1.0],
            i => camera.rotation.row(i).extend(camera.translation[i]).to_array().to_vec(),
        })
        .collect();
    let mut entry = json!({
        "name": name, "file": file, "width": camera.width, "height": camera.height,
        "fx": camera.fx, "fy": camera.fy, "cx": camera.cx, "cy": camera.cy, "world_to_camera": rows,
    });
    if depth {
        let file = format!("{name}_depth.png");
        let most = frame.depth.iter().copied().fold(0.0f32, f32::max);
        let unit = if most > 0.0 { most / 65_535.0 } else { 1.0 };
        // The PNG encoder takes native byte order and writes big-endian.
        let steps: Vec<u16> = frame.depth.iter().map(|z| (z / unit + 0.5) as u16).collect();
        put(&file, &png(frame, bytemuck::cast_slice(&steps), ExtendedColorType::L16)?)?;
        entry["depth_file"] = file.into();
        entry["depth_unit"] = f64::from(unit).into();
    }
    Ok(entry)
}

fn png(frame: &Frame, pixels: &[u8], color: ExtendedColorType) -> Result<Vec<u8>> {
    let mut out = Cursor::new(Vec::new());
    image::codecs::png::PngEncoder::new(&mut out)
        .write_image(pixels, frame.width as u32, frame.height as u32, color)
        .map_err(|e| Error::environment("PNG").found(e.to_string()))?;
    Ok(out.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Silent;

    fn one_ball(folder: &Path) -> PathBuf {
        let splats = orb_formats::ply::Splats {
            positions: vec![[0.0; 3]; 2],
            log_scales: vec![[-1.5, -1.5, -1.6]; 2],
            rotations: vec![[1.0, 0.0, 0.0, 0.0]; 2],
            logit_opacities: vec![6.0; 2],
            sh: vec![std::array::from_fn(|k| if k == 0 { [1.5, 0.0, -1.5] } else { [0.0; 3] }); 2],
        };
        let path = folder.join("ball.ply");
        std::fs::write(&path, orb_formats::ply::write(&splats, &[]).unwrap()).unwrap();
        path
    }

    fn list_of(files: &BTreeMap<String, Vec<u8>>) -> serde_json::Value {
        serde_json::from_slice(&files["frames.json"]).unwrap()
    }

    #[test]
    fn writes_pictures_depth_and_normals() {
        let folder = tempfile::tempdir().unwrap();
        let args = Render {
            scene: one_ball(folder.path()),
            camera: None,
            turntable: Some(2),
            output: folder.path().into(),
            size: 32,
            depth: true,
            normals: true,
            background: vec![0.0; 3],
            device: Device::Cpu,
            publish: PublishArgs { quiet: true, ..PublishArgs::default() },
        };
        let mut files = BTreeMap::new();
        let mut put = |name: &str, bytes: &[u8]| {
            files.insert(name.to_owned(), bytes.to_vec());
            Ok(())
        };
        run(&args, &Silent, &mut |_| {}, &mut put).unwrap();
        let names: Vec<_> = files.keys().cloned().collect();
        let per_view = ["", "_depth", "_normals"];
        let want: Vec<_> = (0..2).flat_map(|i| per_view.map(|s| format!("000{i}{s}.png"))).collect();
        assert_eq!(names, [&want[..], &["frames.json".into()]].concat());
        assert_eq!(list_of(&files)["cameras"][0]["normals_file"], "0000_normals.png");
        // The discs lie in the ground plane, the camera stands above it: up is towards the camera and the top.
        let normals = image::load_from_memory(&files["0000_normals.png"]).unwrap().into_rgb8();
        let [x, y, z] = normals.get_pixel(16, 16).0;
        assert!((126..=130).contains(&x) && y > 136 && z > 136, "{x} {y} {z}");
        assert_eq!(normals.get_pixel(0, 0).0, [128; 3], "nothing drawn");
        let list = list_of(&files);
        let cameras = cameras::parse(Path::new("frames.json"), &files["frames.json"]).unwrap();
        let depth = image::load_from_memory(&files["0001_depth.png"]).unwrap().into_luma16();
        let unit = list["cameras"][1]["depth_unit"].as_f64().unwrap();
        let got = f64::from(depth.get_pixel(16, 16)[0]) * unit;
        let want = f64::from(cameras[1].1.position().length());
        assert!((got - want).abs() < 1e-3 * want, "{got} {want}");
        let color = image::load_from_memory(&files["0000.png"]).unwrap().into_rgb8();
        let [r, g, b] = color.get_pixel(16, 16).0;
        assert!(r > 200 && (100..150).contains(&g) && b < 40, "{r} {g} {b}");
    }

    #[test]
    fn a_scene_that_is_none_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.ply");
        std::fs::write(&path, b"ply\nnothing").unwrap();
        let e = load(&path).unwrap_err();
        assert!(e.kind == crate::Kind::Usage && e.to_string().contains("x.ply"), "{e}");
    }
}
