//! Values of programs that know nothing of Orb; and a table: what is perfect scores so, what is spoilt loses where it
//! should and nowhere else.

use std::path::{Path, PathBuf};

use glam::{Mat3, Vec3};

use super::catalogue::{METRICS, metric};
use super::evaluate::{Evaluation, Tools, evaluate};
use super::scene::{self, Scene};
use super::submission::{self, Frame, Submission};
use super::surfaces::{Shape, scores, tests::block};
use super::{Picture, alignment, make, perception};
use crate::audit::Marking;
use crate::mesh::Surface;
use crate::models::{Engine, Rten};
use crate::progress::Silent;

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/bench").join(name)
}

fn said() -> serde_json::Value {
    serde_json::from_slice(&std::fs::read(data("values.json")).unwrap()).unwrap()
}

fn pictures() -> [Picture; 2] {
    ["reference.png", "distorted.png"].map(|f| Picture::of_rgb(&image::open(data(f)).unwrap().into_rgb8()))
}

#[test]
fn pictures_score_as_scikit_image_idiff_and_colour_science_say() {
    let (said, [truth, found]) = (said(), pictures());
    let near = |name: &str, found: f64, within: f64| {
        let expected = said[name].as_f64().unwrap();
        assert!((found - expected).abs() < within, "{name}: {found}, expected {expected}");
    };
    let psnr = perception::psnr(&found.pixels, &truth.pixels);
    near("psnr", psnr, 1e-5);
    near("psnr_idiff", psnr, 1e-3);
    near("ssim", perception::ssim(&found, &truth).unwrap(), 1e-6);
    near("ms_ssim", perception::ms_ssim(&found, &truth).unwrap(), 1e-6);
    // Its matrix from sRGB to XYZ has more digits.
    near("delta_e_2000", perception::delta_e_2000(&found.pixels, &truth.pixels, |_| true).unwrap(), 5e-3);
}

/// With the weights that the values were made with, which are no part of this repository.
#[test]
fn lpips_is_what_onnx_runtime_says() {
    let Some(file) = std::env::var_os("ORB_LPIPS") else {
        eprintln!("skipped: ORB_LPIPS names no LPIPS network (tests/data/bench/make_values.py)");
        return;
    };
    let [truth, found] = pictures();
    let graph = Rten.load(&std::fs::read(file).unwrap()).unwrap();
    let expected = said()["lpips"]["score"].as_f64().unwrap();
    let score = perception::lpips(&found, &truth, &*graph).unwrap();
    assert!((score - expected).abs() < 1e-3, "{score}, expected {expected}");
    assert!(perception::lpips(&truth, &truth, &*graph).unwrap().abs() < 1e-6);
}

/// A network of CLIP's ports with random weights, prepared pictures and all (`make_clip.py`).
#[test]
fn clip_sees_what_its_own_processor_shows_it() {
    let said = &said()["clip"];
    let graph = Rten.load(&std::fs::read(data("clip.onnx")).unwrap()).unwrap();
    let [a, b] = ["reference.png", "distorted.png"].map(|f| image::open(data(f)).unwrap().into_rgb8());
    let mut wide = image::RgbImage::from_pixel(400, 192, image::Rgb([200, 30, 30]));
    image::imageops::replace(&mut wide, &b, 104, 0);
    let [a, b, wide] = [&a, &b, &wide].map(|p| alignment::clip_embedding(p, &*graph).unwrap());
    for (k, expected) in said["embedding"].as_array().unwrap().iter().enumerate() {
        assert!((a[k] - expected.as_f64().unwrap()).abs() < 3e-3, "{a:?}, expected {said}");
    }
    for (other, name) in [(&b, "cosine"), (&wide, "cosine_wide")] {
        let (found, expected) = (alignment::cosine(&a, other), said[name].as_f64().unwrap());
        assert!((found - expected).abs() < 2e-3, "{name}: {found}, expected {expected}");
    }
}

/// Samples there are even over the surface, here they are what cameras around see: within a twentieth.
#[test]
fn surfaces_score_as_trimesh_says() {
    let said = &said()["boxes"];
    let moved = block(Vec3::new(1.26, 0.66, 0.52));
    let other =
        Surface { positions: moved.positions.iter().map(|p| *p + Vec3::new(0.01, 0.0, 0.02)).collect(), ..moved };
    let truth = block(Vec3::new(1.2, 0.7, 0.5));
    let (a, b) = (Shape::of_surface(&other), Shape::of_surface(&truth));
    let s = scores(&a, &b, Vec3::new(1.2, 0.7, 0.5).length());
    for (name, found) in [("chamfer_percent", 100.0 * s.chamfer), ("f1", s.f[0]), ("f2", s.f[1])] {
        let expected = said[name].as_f64().unwrap();
        assert!((f64::from(found) / expected - 1.0).abs() < 0.05, "{name}: {found}, expected {expected}");
    }
    let around = (Vec3::splat(-0.7), Vec3::splat(0.7));
    let (iou, expected) = (a.volume_iou(&b, around, 96).unwrap(), said["volume_iou"].as_f64().unwrap());
    assert!((iou - expected).abs() < 0.02, "{iou}, expected {expected}");
}

/// A made van and, as a result, the truth itself.
fn perfect(folder: &Path) -> (Scene, Submission) {
    let options = make::Options { seed: 3, photo: 160, views: 6, view: 160 };
    let (name, files) = make::scene(1, &options, &Marking::UNCLASSIFIED).unwrap();
    for f in files {
        let path = folder.join(&f.path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, f.bytes).unwrap();
    }
    let scene = scene::read(&folder.join(&name)).unwrap();
    let mut result = submission::read(&folder.join(&name).join("mesh.glb")).unwrap();
    result.frame = Frame::Subject;
    result.ground = Some(0.0);
    (result.seconds, result.peak_memory_bytes, result.offline) = (Some(20.0), Some(5e8), Some(true));
    (scene, result)
}

fn run(scene: &Scene, result: &Submission) -> Evaluation {
    let tools = Tools { lpips: None, clip: None, most_pixels: 800, draw_for: None };
    evaluate(scene, result, &tools, &Silent).unwrap()
}

fn score(e: &Evaluation, id: &str) -> Option<f64> {
    e.values.get(id).map(|v| metric(id).unwrap().score(v))
}

fn moved(s: &Submission, place: impl Fn(Vec3) -> Vec3) -> Submission {
    let mut out = s.clone();
    let (mesh, _) = out.mesh.as_mut().unwrap();
    mesh.positions.iter_mut().for_each(|p| *p = place(*p));
    out
}

fn with_triangles(s: &Submission, change: impl Fn(&mut Vec<[u32; 3]>, &[Vec3])) -> Submission {
    let mut out = s.clone();
    let (mesh, _) = out.mesh.as_mut().unwrap();
    change(&mut mesh.triangles, &mesh.positions);
    out
}

fn blurred(s: &Submission) -> Submission {
    let mut out = s.clone();
    let (_, texture) = out.mesh.as_mut().unwrap();
    *texture = image::imageops::blur(texture, 5.0);
    out
}

/// Blocks in the air beside the thing, as far across as a twentieth of it.
fn with_floaters(s: &Submission) -> Submission {
    let mut out = s.clone();
    let (mesh, _) = out.mesh.as_mut().unwrap();
    let (low, high) = mesh.bounds();
    for k in 0..6 {
        let start = mesh.positions.len() as u32;
        let b = block(Vec3::splat(0.06 * (high - low).max_element()));
        let at = Mat3::from_rotation_z(k as f32) * Vec3::new(0.55 * (high - low).max_element(), 0.0, 0.0)
            + Vec3::Z * high.z * (0.3 + 0.1 * k as f32);
        mesh.positions.extend(b.positions.iter().map(|p| *p + at));
        mesh.normals.extend(b.positions.iter().map(|p| p.normalize()));
        mesh.uvs.extend(b.positions.iter().map(|_| glam::Vec2::splat(0.5)));
        mesh.triangles.extend(b.triangles.iter().map(|t| t.map(|i| i + start)));
    }
    out
}

#[test]
fn what_is_spoilt_loses_where_it_should_and_nowhere_else() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, truth) = perfect(folder.path());
    let best = run(&scene, &truth);
    let unmeasured: Vec<&str> = METRICS.iter().map(|m| m.id).filter(|id| !best.values.contains_key(id)).collect();
    assert_eq!(unmeasured, ["lpips", "clip_score", "fps_1080p"], "{:?}", best.missing);
    let lost: Vec<_> = best.values.iter().filter(|(id, _)| score(&best, id) < Some(0.995)).collect();
    assert!(lost.is_empty(), "the truth itself: {lost:?}");
    let (_, high) = truth.mesh.as_ref().map_or((Vec3::ZERO, Vec3::ZERO), |m| m.0.bounds());
    let tilt = Mat3::from_rotation_x(12f32.to_radians());
    let tilted = moved(&truth, |p| tilt * p);
    let low = tilted.mesh.as_ref().map_or(0.0, |m| m.0.bounds().0.z);
    let quarter = Mat3::from_rotation_z(0.25);
    // What falls; what may, as the alignment and the drawing move a little with it; everything else stays.
    let table: [(&str, Submission, &str, &str); 9] = [
        ("blur", blurred(&truth), "psnr ssim_ms_ssim delta_e_2000 sharpness_ratio reprojection_error", ""),
        (
            "shift",
            moved(&Submission { frame: Frame::Scene, ..truth.clone() }, |p| p + Vec3::X * 0.3),
            "psnr ssim_ms_ssim delta_e_2000 chamfer f_score_1_2_percent depth_abs_rel_delta volume_iou reprojection_error \
             silhouette_consistency mask_alignment normal_consistency",
            "sharpness_ratio",
        ),
        // Who looks in sees the far side's own colours.
        (
            "hole",
            with_triangles(&truth, without_the_largest_face),
            "watertightness volume_iou chamfer f_score_1_2_percent normal_consistency",
            "delta_e_2000",
        ),
        (
            "floaters",
            with_floaters(&truth),
            "psnr ssim_ms_ssim delta_e_2000 sharpness_ratio chamfer f_score_1_2_percent silhouette_consistency \
             reprojection_error mask_alignment",
            "normal_consistency",
        ),
        ("scale × 1.1", moved(&truth, |p| p * 1.1), "scale_error", ""),
        (
            "flipped normals",
            with_triangles(&truth, |t, _| t.iter_mut().for_each(|t| t.swap(0, 1))),
            "normal_consistency",
            "",
        ),
        (
            "tilted on the ground",
            moved(&tilted, |p| p - Vec3::Z * low),
            "gravity_adherence static_stability psnr ssim_ms_ssim delta_e_2000 chamfer f_score_1_2_percent volume_iou \
             silhouette_consistency mask_alignment normal_consistency depth_abs_rel_delta reprojection_error sharpness_ratio",
            "scale_error",
        ),
        ("sunk into the ground", moved(&truth, |p| p - Vec3::Z * 0.1 * high.z), "ground_penetration_gap", ""),
        ("turned", moved(&truth, |p| quarter * p), "trajectory_adherence", ""),
    ];
    let mut wrong = Vec::new();
    for (what, result, falls, may) in table {
        let spoilt = run(&scene, &result);
        let lists = |list: &str, id: &str| list.split_whitespace().any(|l| l == id);
        let mut fallen = Vec::new();
        for id in best.values.keys() {
            // Only results in the subject frame claim a heading.
            let Some(after) = score(&spoilt, id) else {
                assert!(what == "shift" && *id == "trajectory_adherence", "{what}: {id} is not measured");
                continue;
            };
            let drop = score(&best, id).unwrap_or(0.0) - after;
            if drop > 0.005 {
                fallen.push(format!("{id} by {drop:.3}"));
            }
            if lists(falls, id) && drop < 0.01 {
                wrong.push(format!("{what}: {id} should fall, and falls by {drop:.4}"));
            }
            if !lists(falls, id) && !lists(may, id) && drop > 0.008 {
                wrong.push(format!("{what}: {id} should stay, and falls by {drop:.4}"));
            }
        }
        eprintln!("{what}: {}", fallen.join(", "));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The face that the largest triangle is part of.
fn without_the_largest_face(triangles: &mut Vec<[u32; 3]>, at: &[Vec3]) {
    let normal = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| at[i as usize]);
        (b - a).cross(c - a)
    };
    let largest = triangles.iter().max_by(|a, b| normal(a).length().total_cmp(&normal(b).length())).copied();
    let Some(largest) = largest else { return };
    let n = normal(&largest).normalize();
    let offset = n.dot(at[largest[0] as usize]);
    let inside = |t: &[u32; 3]| normal(t).normalize().dot(n) > 0.99 && (n.dot(at[t[0] as usize]) - offset).abs() < 1e-3;
    triangles.retain(|t| !inside(t));
}
