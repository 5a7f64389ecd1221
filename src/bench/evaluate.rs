//! One scene and one result → a value for every metric that can be measured, and pictures to look at.
//!
//! Everything is compared in the result's unit frame: its bounding sphere of radius 1 about the origin, Z up.

use std::collections::BTreeMap;
use std::time::Duration;

use glam::{Mat3, Vec3};
use image::RgbImage;
use rayon::prelude::*;

use super::catalogue::METRICS;
use super::scene::{Photo, Scene, View as TrueView};
use super::score::Values;
use super::submission::{Frame, Submission};
use super::surfaces::{self, Shape, Similarity};
use super::unit::{Unit, placed};
use super::{Picture, alignment, consistency, efficiency, geometry, perception, physics, temporal};
use crate::mesh::{self, Surface, View};
use crate::models::Graph;
use crate::progress::Progress;
use crate::splat::Camera;
use crate::{Result, views};

/// Behind objects, as NeRF's authors have it.
pub const BEHIND: [f32; 3] = [1.0; 3];
/// Behind surroundings.
const DARK: [f32; 3] = [0.0; 3];
/// Pixels across the pictures of SC and TC.
const SIZE: u32 = 192;
/// Cells along the longest side for the volumes.
const CELLS: usize = 48;
/// Pictures of a scene in the report.
const SHOWN: usize = 3;

/// What is brought to the measuring.
pub struct Tools<'a> {
    pub lpips: Option<&'a dyn Graph>,
    pub clip: Option<&'a dyn Graph>,
    /// Most pixels a side of the true pictures; larger ones are made smaller.
    pub most_pixels: u32,
    /// How long pictures are drawn for the speed; none: it is not measured.
    pub draw_for: Option<Duration>,
}

/// A true picture, the result's and their difference.
#[derive(Clone, Debug)]
pub struct Compared {
    pub name: String,
    pub truth: RgbImage,
    pub found: RgbImage,
    pub error: RgbImage,
}

/// What was measured of one scene.
#[derive(Clone, Debug, Default)]
pub struct Evaluation {
    pub scene: String,
    pub values: Values,
    /// Why a metric was not measured.
    pub missing: BTreeMap<&'static str, String>,
    pub pictures: Vec<Compared>,
    pub photo: Option<RgbImage>,
}

impl Evaluation {
    fn set(&mut self, id: &'static str, values: Option<Vec<f64>>, otherwise: &str) {
        debug_assert!(METRICS.iter().any(|m| m.id == id));
        match values.filter(|v| v.iter().all(|v| v.is_finite())) {
            Some(values) => drop(self.values.insert(id, values)),
            None => drop(self.missing.insert(id, otherwise.to_owned())),
        }
    }
}

/// Measures everything that these inputs allow.
///
/// # Errors
/// Usage for pictures that cannot be read; what a graph says; `Cancelled`.
pub fn evaluate(scene: &Scene, result: &Submission, tools: &Tools, progress: &dyn Progress) -> Result<Evaluation> {
    let mut out = Evaluation { scene: scene.name.clone(), ..Evaluation::default() };
    let unit = Unit::new(result, scene.is_object)?;
    let (place, turned) = placed(scene, result, &unit);
    progress.check()?;
    let true_shape = scene.surface.as_ref().map(|s| Shape::of_surface(&place.surface(s)));

    perceptual(scene, result, &unit, &place, tools, &mut out)?;
    progress.check()?;
    geometric(scene, &unit, &place, true_shape.as_ref(), turned.as_ref(), &mut out);
    progress.check()?;
    flights(scene, result, &unit, &place, &mut out);
    progress.check()?;
    physical(scene, result, &unit, &mut out);
    progress.check()?;
    asked_for(scene, result, &unit, &place, turned.as_ref(), tools, &mut out)?;
    efficient(scene, result, &unit, &place, tools, &mut out);
    Ok(out)
}

/// PQ, and of SC what needs true pictures.
fn perceptual(
    scene: &Scene,
    result: &Submission,
    unit: &Unit,
    place: &Similarity,
    tools: &Tools,
    out: &mut Evaluation,
) -> Result<()> {
    let behind = if scene.is_object { BEHIND } else { DARK };
    let appearance = unit.appearance();
    let mut pairs: Vec<(String, Picture, Picture, View, Vec<f32>)> = Vec::new();
    for view in &scene.tests {
        let (rgba, camera) = view.load(tools.most_pixels)?;
        let truth = Picture::of_rgba(&rgba, behind);
        let drawn =
            result.frames.iter().find(|f| f.0 == view.name && f.2.width == truth.width && f.2.height == truth.height);
        let shown = appearance.map(|a| a.draw(&place.camera(&camera), behind));
        let Some(shown) = shown.or_else(|| drawn.map(|d| opaque(&camera, &d.2))) else { continue };
        let found = drawn.map_or_else(|| Picture::new(truth.width, truth.height, shown.color.clone()), |d| d.2.clone());
        let alpha = rgba.pixels().map(|p| f32::from(p.0[3]) / 255.0).collect();
        pairs.push((view.name.clone(), truth, found, shown, alpha));
    }
    let none = "no true pictures that were held back";
    type One = [Option<Vec<f64>>; 6];
    let measured: Vec<One> = pairs
        .par_iter()
        .map(|(_, truth, found, shown, alpha)| {
            let both = perception::ssim(found, truth).zip(perception::ms_ssim(found, truth));
            let subject = |i: usize| alpha[i] > 0.5 || shown.alpha[i] > 0.5;
            [
                Some(vec![perception::psnr(&found.pixels, &truth.pixels)]),
                both.map(|(a, b)| vec![a, b]),
                perception::delta_e_2000(&found.pixels, &truth.pixels, subject).map(|v| vec![v]),
                perception::sharpness_ratio(found, truth).map(|v| vec![v]),
                consistency::reprojection_error(found, truth).map(|v| vec![v]),
                consistency::silhouette_iou(&shown.alpha, alpha).map(|v| vec![v]),
            ]
        })
        .collect();
    let ids =
        ["psnr", "ssim_ms_ssim", "delta_e_2000", "sharpness_ratio", "reprojection_error", "silhouette_consistency"];
    for (k, id) in ids.into_iter().enumerate() {
        out.set(id, mean(measured.iter().filter_map(|m| m[k].clone())), none);
    }
    if pairs.iter().all(|p| p.4.iter().all(|a| *a > 0.99)) {
        out.values.remove("silhouette_consistency");
        out.missing.insert("silhouette_consistency", "no true silhouettes: the pictures are opaque".into());
    }
    match tools.lpips {
        Some(graph) => {
            let scores: Vec<Vec<f64>> =
                pairs.iter().map(|p| Ok(vec![perception::lpips(&p.2, &p.1, graph)?])).collect::<Result<_>>()?;
            out.set("lpips", mean(scores.into_iter()), none);
        }
        None => out.set("lpips", None, "no weights: name them with --lpips"),
    }
    let step = pairs.len().div_ceil(SHOWN).max(1);
    for (name, truth, found, ..) in pairs.iter().step_by(step) {
        out.pictures.push(Compared {
            name: name.clone(),
            truth: truth.to_rgb(),
            found: found.to_rgb(),
            error: error_map(found, truth),
        });
    }
    Ok(())
}

/// A picture that covers everything and has no depth.
fn opaque(camera: &Camera, picture: &Picture) -> View {
    let n = picture.pixels.len();
    View {
        camera: *camera,
        color: picture.pixels.clone(),
        alpha: vec![1.0; n],
        depth: vec![0.0; n],
        passing: mesh::MEDIAN,
    }
}

/// White for equal, through yellow and red to black for a mean difference of half the full scale and more.
fn error_map(found: &Picture, truth: &Picture) -> RgbImage {
    let of = |(a, b): (&[f32; 3], &[f32; 3])| {
        let e = (2.0 * (0..3).map(|k| (a[k] - b[k]).abs()).sum::<f32>() / 3.0).min(1.0);
        let e = e.sqrt();
        [(3.0 - 3.0 * e).min(1.0), (2.0 - 3.0 * e).clamp(0.0, 1.0), (1.0 - 3.0 * e).clamp(0.0, 1.0)]
    };
    let pixels: Vec<[f32; 3]> = found.pixels.iter().zip(&truth.pixels).map(of).collect();
    Picture::new(found.width, found.height, pixels).to_rgb()
}

/// Means, measure by measure.
fn mean(values: impl Iterator<Item = Vec<f64>>) -> Option<Vec<f64>> {
    let all: Vec<Vec<f64>> = values.collect();
    let width = all.first()?.len();
    Some((0..width).map(|k| all.iter().map(|v| v[k]).sum::<f64>() / all.len() as f64).collect())
}

fn geometric(
    scene: &Scene,
    unit: &Unit,
    place: &Similarity,
    true_shape: Option<&Shape>,
    turned: Option<&Similarity>,
    out: &mut Evaluation,
) {
    let ids =
        ["chamfer", "f_score_1_2_percent", "normal_consistency", "depth_abs_rel_delta", "volume_iou", "scale_error"];
    let (Some(truth), Some(true_shape), Some(shape), Some(surface)) =
        (&scene.surface, true_shape, &unit.shape, &unit.surface)
    else {
        let why = if scene.surface.is_none() { "no true mesh" } else { "no surface in the result" };
        ids.into_iter().for_each(|id| out.set(id, None, why));
        return;
    };
    let moved = place.surface(truth);
    let (low, high) = moved.bounds();
    let scores = surfaces::scores(shape, true_shape, low.distance(high));
    out.set("chamfer", Some(vec![f64::from(scores.chamfer) * 100.0]), "");
    out.set("f_score_1_2_percent", Some(scores.f.map(f64::from).to_vec()), "");
    out.set("normal_consistency", shape.normal_consistency(true_shape).map(|v| vec![v]), "no normals");
    let (own_low, own_high) = surface.bounds();
    let around = (low.min(own_low) - 0.02, high.max(own_high) + 0.02);
    out.set("volume_iou", shape.volume_iou(true_shape, around, CELLS).map(|v| vec![v]), "no volume");
    // Between the cameras that neither was made from.
    let depth = |s: &Surface, c: &Camera| mesh::raster::visibility(&s.positions, &s.triangles, c).depth;
    let cameras = (0..12).map(|k| views::orbit(30.0 * k as f32, [20.0, -5.0, 45.0][k % 3], views::DISTANCE, SIZE));
    let errors = cameras.filter_map(|c| geometry::depth_errors(&depth(surface, &c), &depth(&moved, &c)));
    out.set("depth_abs_rel_delta", mean(errors.map(|(a, d)| vec![a, d])), "no pixel shows both");
    // Unit lengths per true length, times the result's lengths per unit length.
    let ratio = turned.map(|s| f64::from(s.scale() * unit.radius));
    out.set("scale_error", ratio.map(|r| vec![geometry::scale_error(r)]), "the truth was not found in the result");
}

/// A slow flight in small steps, and pictures a third of a right angle apart; SC without truth, and TC.
fn flights(scene: &Scene, result: &Submission, unit: &Unit, place: &Similarity, out: &mut Evaluation) {
    let behind = if scene.is_object { BEHIND } else { DARK };
    let Some(appearance) = unit.appearance() else {
        for id in ["photometric_consistency", "depth_consistency"] {
            out.set(id, None, "frames alone have no depth");
        }
        let frames: Vec<Picture> = result.frames.iter().map(|f| f.2.clone()).collect();
        return coherent(
            &frames,
            &frames.iter().map(|f| vec![true; f.pixels.len()]).collect::<Vec<_>>(),
            result,
            None,
            out,
        );
    };
    let draw = |c: &Camera| appearance.draw(c, behind);
    let (around, slow): (Vec<Camera>, Vec<Camera>) = if scene.is_object {
        let at = |azimuth: f32, elevation: f32| views::orbit(azimuth, elevation, views::DISTANCE, SIZE);
        let around = (0..12).map(|k| at(30.0 * k as f32, if k % 2 == 0 { 15.0 } else { 30.0 })).collect();
        // A third of a degree moves what is nearest by a third of a pixel.
        (
            around,
            (0..2).flat_map(|arc| (0..8).map(move |k| at(60.0 + 150.0 * arc as f32 + k as f32 / 3.0, 20.0))).collect(),
        )
    } else {
        let mut all: Vec<&TrueView> = scene.tests.iter().chain(&scene.training).collect();
        all.sort_by(|a, b| a.name.cmp(&b.name));
        let step = all.len().div_ceil(24).max(1);
        let camera = |v: &&TrueView| {
            let c = &v.camera;
            let larger = c.width.max(c.height);
            let [width, height] = [c.width, c.height].map(|side| (side * SIZE / larger).max(1));
            place.camera(&c.resized(width, height))
        };
        (all.iter().step_by(step).map(camera).collect(), Vec::new())
    };
    let seen: Vec<View> = around.iter().map(draw).collect();
    // Of surroundings the depths themselves say how large is small.
    let radius = if scene.is_object { 1.0 } else { median_depth(&seen) };
    let pairs = (0..seen.len()).filter(|i| scene.is_object || i + 1 < seen.len());
    let warped: Vec<consistency::Warped> = pairs
        .flat_map(|i| {
            let (a, b) = (&seen[i], &seen[(i + 1) % seen.len()]);
            [consistency::warp(a, b, radius), consistency::warp(b, a, radius)]
        })
        .flatten()
        .collect();
    let none = "no two pictures that show the same points";
    out.set("photometric_consistency", mean(warped.iter().map(|w| vec![w.color])), none);
    out.set("depth_consistency", mean(warped.iter().map(|w| vec![w.depth])), none);
    // The way back to the first picture, drawn again.
    let again = seen.first().map(|first| {
        let back = draw(&first.camera);
        let picture = |v: &View| Picture::new(v.camera.width as usize, v.camera.height as usize, v.color.clone());
        temporal::loop_closure(&picture(first), &picture(&back))
    });
    if !result.frames.is_empty() {
        let frames: Vec<Picture> = result.frames.iter().map(|f| f.2.clone()).collect();
        let all = frames.iter().map(|f| vec![true; f.pixels.len()]).collect::<Vec<_>>();
        return coherent(&frames, &all, result, again, out);
    }
    let shown: Vec<View> = slow.iter().map(draw).collect();
    let measures: Vec<Vec<f64>> = shown
        .chunks(8)
        .filter_map(|arc| {
            let frames: Vec<Picture> =
                arc.iter().map(|v| Picture::new(SIZE as usize, SIZE as usize, v.color.clone())).collect();
            let subject: Vec<Vec<bool>> = arc.iter().map(|v| v.alpha.iter().map(|a| *a > 0.5).collect()).collect();
            Some(vec![temporal::smoothness(&frames, &subject)?, temporal::flicker(&frames, &subject)?])
        })
        .collect();
    out.set("smoothness_flicker", mean(measures.into_iter()), "no even flight through these surroundings");
    out.set("loop_closure", again.map(|v| vec![v]), "nothing to return to");
}

/// TC of frames that the system drew itself.
fn coherent(frames: &[Picture], subject: &[Vec<bool>], result: &Submission, again: Option<f64>, out: &mut Evaluation) {
    let both = temporal::smoothness(frames, subject).zip(temporal::flicker(frames, subject));
    out.set("smoothness_flicker", both.map(|(a, b)| vec![a, b]), "fewer than three frames of one size");
    // Two frames of one pose, as far apart in time as there are.
    let same = |a: &Camera, b: &Camera| {
        let near = (a.translation - b.translation).length() <= 1e-3 * a.translation.length().max(1.0);
        near && alignment::rotation_angle(a.rotation, b.rotation) < 0.1
    };
    let n = result.frames.len();
    let pair = (2..n)
        .rev()
        .find_map(|d| (0..n - d).find(|i| same(&result.frames[*i].1, &result.frames[i + d].1)).map(|i| (i, i + d)));
    let closed =
        pair.filter(|_| temporal::same_size(frames)).map(|(i, j)| temporal::loop_closure(&frames[i], &frames[j]));
    out.set("loop_closure", closed.or(again).map(|v| vec![v]), "no frame returns to an earlier pose");
}

fn median_depth(views: &[View]) -> f32 {
    let mut all: Vec<f32> = views.iter().flat_map(|v| v.depth.iter().copied().filter(|z| *z > 0.0)).collect();
    all.sort_by(f32::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(1.0)
}

fn physical(scene: &Scene, result: &Submission, unit: &Unit, out: &mut Evaluation) {
    let ids = ["gravity_adherence", "ground_penetration_gap", "static_stability", "watertightness", "plausible_scale"];
    let Some(surface) = &unit.surface else {
        let why = if scene.is_object { "no surface in the result" } else { "surroundings, not a thing" };
        ids.into_iter().for_each(|id| out.set(id, None, why));
        return;
    };
    let standing = physics::stand(surface);
    let no_engine = "nothing to simulate, or a program without its physics engine";
    out.set("gravity_adherence", standing.map(|s| vec![s.tilt]), no_engine);
    out.set("static_stability", standing.map(|s| vec![s.tipping]), no_engine);
    let ground = result.ground.or((result.frame == Frame::Scene).then_some(scene.ground));
    let contact = ground.and_then(|g| physics::ground_contact(surface, (g - unit.centre.z) / unit.radius));
    out.set("ground_penetration_gap", contact.map(|c| c.to_vec()), "the result does not say where its ground is");
    let own = unit.mesh.is_some();
    let tight = physics::watertightness(surface).filter(|_| own);
    out.set("watertightness", tight.map(|v| vec![v]), "splats have no surface of their own");
    let (low, high) = surface.bounds();
    let longest = f64::from((high - low).max_element() * unit.radius);
    let sizes = scene.sizes.map(|s| vec![physics::plausible_scale(longest, s)]);
    out.set("plausible_scale", sizes, "the scene does not say how large such things are");
}

fn asked_for(
    scene: &Scene,
    result: &Submission,
    unit: &Unit,
    place: &Similarity,
    turned: Option<&Similarity>,
    tools: &Tools,
    out: &mut Evaluation,
) -> Result<()> {
    let photo = match &scene.photo {
        Some(p) => {
            let view = TrueView { name: "photo".into(), camera: p.camera, file: p.file.clone(), lens: None };
            let (picture, camera) = view.load(tools.most_pixels)?;
            Some((p, image::DynamicImage::ImageRgba8(picture).into_rgb8(), camera))
        }
        None => None,
    };
    let shown = photo.as_ref().zip(unit.appearance()).map(|((_, _, c), a)| a.draw(&place.camera(c), BEHIND));
    let known = result.frame == Frame::Scene || turned.is_some();
    let mut iou = None;
    if let (Some((Photo { mask: Some(mask), .. }, _, camera)), Some(shown), true) = (&photo, &shown, known) {
        let view = TrueView { name: "mask".into(), camera: *camera, file: mask.clone(), lens: None };
        let (picture, size) = view.load(tools.most_pixels)?;
        if (size.width, size.height) == (camera.width, camera.height) {
            let has_alpha = picture.pixels().any(|p| p.0[3] < 255);
            let level = |p: &image::Rgba<u8>| f32::from(if has_alpha { p.0[3] } else { p.0[1] }) / 255.0;
            iou = alignment::mask_iou(&shown.alpha, &picture.pixels().map(level).collect::<Vec<f32>>());
        }
    }
    out.set("mask_alignment", iou.map(|v| vec![v]), "no mask of the photo, or no pose of the result");

    // Cameras of the result by the names of the scene's; for results in the subject frame its +Y is such a claim.
    let mut asked: Vec<(&str, &Camera)> =
        scene.tests.iter().chain(&scene.training).map(|v| (v.name.as_str(), &v.camera)).collect();
    asked.extend(photo.as_ref().map(|(p, ..)| ("photo", &p.camera)));
    let given = result.cameras.iter().map(|(n, c)| (n, c)).chain(result.frames.iter().map(|f| (&f.0, &f.1)));
    let mut angles: Vec<f64> = given
        .filter_map(|(name, c)| {
            let (_, wanted) = asked.iter().find(|(n, _)| n == name)?;
            // The wanted camera in the result's frame.
            Some(alignment::rotation_angle(place.camera(wanted).rotation, c.rotation))
        })
        .collect();
    if let (true, Frame::Subject, Some((p, ..)), Some(t)) = (angles.is_empty(), result.frame, &photo, turned) {
        let forward = t.turn() * p.camera.rotation.row(2);
        angles.push(f64::from(Vec3::new(forward.x, forward.y, 0.0).angle_between(Vec3::Y).to_degrees()));
    }
    let trajectory = mean(angles.into_iter().map(|a| vec![a]));
    out.set("trajectory_adherence", trajectory, "the result names no cameras");

    let clip = match (tools.clip, &photo, unit.appearance()) {
        (None, ..) => Err("no CLIP is imported; name its image encoder with --clip"),
        (_, None, _) => Err("no photo to compare with"),
        (_, _, None) => Err("nothing to draw"),
        (Some(graph), Some((_, photo, camera)), Some(appearance)) => {
            let wanted = alignment::clip_embedding(photo, graph)?;
            // From the photo's side and 45° to its left and right.
            let mut sum = 0.0;
            for turn in [0f32, 45.0, -45.0] {
                let c = place.camera(camera);
                let turned = Mat3::from_rotation_z(turn.to_radians());
                let c = Camera { rotation: c.rotation * turned, ..c };
                let view = appearance.draw(&c, BEHIND);
                let picture = Picture::new(c.width as usize, c.height as usize, view.color).to_rgb();
                sum += alignment::cosine(&wanted, &alignment::clip_embedding(&picture, graph)?) / 3.0;
            }
            Ok(vec![sum])
        }
    };
    out.set("clip_score", clip.clone().ok(), clip.err().unwrap_or_default());
    out.photo = photo.map(|(_, p, _)| p);
    Ok(())
}

fn efficient(scene: &Scene, result: &Submission, unit: &Unit, place: &Similarity, tools: &Tools, out: &mut Evaluation) {
    let camera = if scene.is_object {
        Some(views::orbit(30.0, 20.0, views::DISTANCE, 1080))
    } else {
        scene.tests.first().map(|v| place.camera(&v.camera))
    };
    let fps = match (unit.appearance(), camera, tools.draw_for) {
        (Some(a), Some(c), Some(long)) => Some(vec![efficiency::pictures_a_second(a, &c, long)]),
        _ => None,
    };
    out.set("fps_1080p", fps, "speed was not asked for");
    let largest = result.files.iter().map(|f| f.bytes as f64).fold(0.0, f64::max) / f64::from(1 << 20);
    let both = result.peak_memory_bytes.filter(|_| largest > 0.0).map(|m| vec![m / f64::from(1 << 20), largest]);
    out.set("peak_memory_file_size", both, "its maker does not say how much memory it took");
    out.set("wall_time", result.seconds.map(|s| vec![s]), "its maker does not say how long it took");
    out.set(
        "ddil",
        result.offline.map(|o| vec![f64::from(u8::from(o))]),
        "only runs that Orb starts itself are watched",
    );
    let checked: Vec<f64> = result
        .files
        .iter()
        .filter_map(|f| f.finding.as_ref())
        .map(|f| f64::from(u8::from(*f == efficiency::Finding::Sound)))
        .collect();
    out.set("export_conformance", mean(checked.into_iter().map(|v| vec![v])), "no file of a format that is checked");
}
