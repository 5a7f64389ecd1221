//! The stages with several photos in front: poses → masks → frame → Gaussians → optimisation → the same mesh.

use glam::{DVec3, Vec3};

use super::{Clock, Fitted, GREY, Settings, Symmetry, VIEW, VIEW_SIZE, render_all, uncomposited};
use crate::bench::{Picture, perception};
use crate::geo::similarity::Similarity;
use crate::models::scene::{self, Subject};
use crate::models::splat_prior::{self, OneView};
use crate::models::{Engine, prior};
use crate::photo::{Photo, Plane};
use crate::photos::colmap::is_test;
use crate::photos::crops::{Crop, camera};
use crate::photos::frame::{self, Ground, UpBy};
use crate::photos::{Posed, Poses, start};
use crate::progress::Progress;
use crate::splat::render::Shown;
use crate::splat::{self, Camera, Gaussians, Target};
use crate::views::hull::{Hull, Silhouette};
use crate::{Error, Result, sources, views};

/// Names of the targets in the optimisation's report: `photo NAME` and `held out NAME`.
pub const TRAINED: &str = "photo ";
pub const HELD_OUT: &str = "held out ";

/// Longer side of a photo's piece in training, pixels.
const CROP: usize = 512;
/// As many photos as this, and every eighth is held out.
const ENOUGH: usize = 8;
/// A mask that meets the others' body no better than this shows something else.
const AGREES: f32 = 0.5;
/// From as many photos on, the body that their masks allow is worth starting from.
const ENOUGH_FOR_A_HULL: usize = 5;
/// Degrees: a view of the network further from every photo than this stands in for what no photo shows.
const UNSEEN: f32 = 50.0;
/// Radians a step, for poses that were only searched.
const SEARCHED_POSE_RATE: f32 = 5e-4;
/// Photos that colour and thin parts are taken from, at most.
const PAINTING: usize = 16;

/// What only several photos need to be told.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Poses are refined in training.
    pub refine_poses: bool,
    /// Up in the cameras' world, where the Earth says it.
    pub up: Option<DVec3>,
    /// The poses were searched: focal lengths stand for no lens, and refinement has further to go.
    pub searched: bool,
}

/// What became of a photo.
#[derive(Clone, Debug, PartialEq)]
pub struct Used {
    pub name: String,
    pub role: Role,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Role {
    Trained,
    HeldOut,
    /// And why.
    LeftOut(String),
}

/// Means over the held-out photos' pieces, over mid-grey.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scores {
    pub photos: usize,
    pub psnr: f64,
    /// Of photos large enough for its window.
    pub ssim: f64,
    /// Of the result's silhouettes and the masks.
    pub silhouette_iou: f64,
}

/// What only several photos have.
#[derive(Clone, Debug)]
pub struct Several {
    pub photos: Vec<Used>,
    /// From the cameras' world to the unit frame, f64.
    pub to_unit: Similarity,
    pub up_by: UpBy,
    pub ground: Option<Ground>,
    /// The photo that the frame's +Y and the network's Gaussians are of: its index in the poses.
    pub reference: usize,
    /// Focal length of the reference, pixels of its photo, where the poses are measured ones.
    pub reference_focal: Option<f64>,
    /// How the network's Gaussians meet all masks, after they were brought into the posed frame.
    pub network_iou: f32,
    /// Gaussians from the network, from the masks' common body, from the sparse points.
    pub started_from: [usize; 3],
    pub trained: Scores,
    pub held_out: Scores,
    /// By how much refinement turned the cameras, degrees, and moved them, parts of their distance: largest of each.
    pub refined: Option<(f64, f64)>,
}

/// A photo that passed the mask.
struct Seen {
    index: usize,
    crop: Crop,
}

/// Stages 2 to 4 for the subject of several posed photos. `open` gives the photo of a pose, its rows as the file has them.
/// Returns the reference photo too, without distortion.
///
/// # Errors
/// `Usage` where fewer than two photos show a common subject; as [`super::reconstruct`].
pub fn fit(
    poses: &Poses,
    open: &dyn Fn(&Posed) -> Result<Photo>,
    engine: &dyn Engine,
    fitter: splat::Engine,
    settings: &Settings,
    options: &Options,
    progress: &dyn Progress,
) -> Result<(Photo, Fitted)> {
    let mut clock = Clock::new();
    let Masked { mut seen, best, mut photos } = masked(poses, open, engine, progress)?;
    clock.lap("masks");

    let cameras_up = frame::up_of_cameras(poses.photos.iter().map(|p| p.rotation));
    let Framed { to_unit, up_by, ground } =
        framed(&mut seen, &mut photos, poses, &best, cameras_up, options, settings.seed)?;
    let tested = |s: &Seen| seen.len() >= ENOUGH && is_test(s.index) && s.index != best.index;
    let is_held_out: Vec<bool> = seen.iter().map(tested).collect();
    let cameras: Vec<Camera> = seen.iter().map(|s| s.crop.camera(&to_unit)).collect();
    let training: Vec<Silhouette> = seen
        .iter()
        .zip(&cameras)
        .zip(&is_held_out)
        .filter(|(_, held)| !**held)
        .map(|((s, camera), _)| s.crop.silhouette(*camera))
        .collect();
    clock.lap("frame");
    progress.check()?;

    progress.begin("3D from one view", 0);
    let reference = &poses.photos[best.index];
    let mut one_view =
        splat_prior::one_view(&best.photo.pixels, &best.subject, &*engine.load(prior::SPLAT.verified()?)?)?;
    let posed = square_camera(reference, &best.photo, &one_view, &to_unit);
    let (first, own) = (start::by_camera(&one_view.camera, &posed), one_view.gaussians.len());
    let placed = start::settle(&one_view.gaussians, first, &training);
    let eye = posed.position();
    start::moved(&mut one_view, &placed, posed, (eye.z / eye.length()).clamp(-1.0, 1.0).asin());
    let mean = |g: &Gaussians, all: &[Silhouette]| {
        all.iter().map(|s| start::silhouette_iou(g, s)).sum::<f32>() / all.len().max(1) as f32
    };
    let network_iou = mean(&one_view.gaussians, &training);
    one_view.silhouette_iou = network_iou;
    let (begun, started_from) = beginning(&one_view, network_iou, &training, &poses.points, &to_unit);
    if begun.is_empty() {
        return Err(no_common_subject(format!("nothing of the {own} Gaussians of the network in all of their masks")));
    }
    one_view.gaussians = begun;
    clock.lap("3D from photos");
    progress.check()?;

    progress.begin("six views", 6);
    let six = render_all(&one_view.gaussians, &views::six_views(VIEW_SIZE), progress)?;
    let mut targets: Vec<Target> = seen
        .iter()
        .zip(&cameras)
        .zip(&is_held_out)
        .map(|((s, camera), held)| Target {
            camera: *camera,
            color: s.crop.colour.clone(),
            alpha: s.crop.mask.data.clone(),
            weight: if *held { 0.0 } else { 1.0 },
            refine_pose: options.refine_poses && !held,
            held_back: None,
            shown: Shown::Color,
            name: format!("{}{}", if *held { HELD_OUT } else { TRAINED }, s.crop.name),
        })
        .collect();
    targets.extend(unseen_views(&six, &training).into_iter().map(|(i, (camera, frame))| Target {
        camera: *camera,
        color: uncomposited(frame),
        alpha: frame.alpha.clone(),
        weight: 0.1,
        refine_pose: false,
        held_back: None,
        shown: Shown::Color,
        name: format!("{VIEW} {}", i + 1),
    }));
    let settings = &settings_for(settings, training.len());
    let rate = options.searched.then_some(SEARCHED_POSE_RATE);
    let trained = super::trained(fitter, &one_view.gaussians, &targets, settings, rate, progress)?;
    clock.lap("optimisation");

    let scores = |of_held_out: bool| {
        let rows = seen.iter().zip(&trained.cameras).zip(&is_held_out).filter(|(_, held)| **held == of_held_out);
        score(rows.map(|((s, camera), _)| (&s.crop, *camera)), &trained.gaussians)
    };
    let several = Several {
        to_unit,
        up_by,
        ground,
        reference: best.index,
        reference_focal: (!options.searched).then(|| posed_focal(reference, &best.photo)),
        network_iou,
        started_from,
        trained: scores(false),
        held_out: scores(true),
        refined: options.refine_poses.then(|| moved(&cameras, &trained.cameras)),
        photos: {
            photos.extend(seen.iter().zip(&is_held_out).map(|(s, held)| Used {
                name: s.crop.name.clone(),
                role: if *held { Role::HeldOut } else { Role::Trained },
            }));
            photos.sort_by(|a, b| a.name.cmp(&b.name));
            photos
        },
    };
    let training = seen.into_iter().zip(&trained.cameras).zip(&is_held_out).filter(|(_, held)| !**held);
    let painting: Vec<(Camera, Crop)> = training.map(|((s, camera), _)| (*camera, s.crop)).collect();
    let step = painting.len().div_ceil(PAINTING).max(1);
    let fitted = Fitted {
        subject: best.subject,
        prior: one_view,
        symmetry: Symmetry { fit: None, applied: false },
        six,
        gaussians: trained.gaussians,
        report: trained.report,
        sources: sources::Outcome::default(),
        cameras: trained.cameras,
        mirrored: None,
        painting: painting.into_iter().step_by(step).collect(),
        several: Some(several),
        clock,
    };
    Ok((best.photo, fitted))
}

fn no_common_subject(found: impl Into<String>) -> Error {
    Error::usage("photos").expected("one subject that at least two photos show whole").found(found).advice(
        "The cameras must look at the subject from around it, and each photo must show some background on every side.",
    )
}

struct Masked {
    seen: Vec<Seen>,
    best: Best,
    photos: Vec<Used>,
}

/// The photo that the network lifts to three dimensions.
struct Best {
    index: usize,
    photo: Photo,
    subject: Subject,
    score: f64,
}

/// Every photo's subject, one photo in memory at a time.
fn masked(
    poses: &Poses,
    open: &dyn Fn(&Posed) -> Result<Photo>,
    engine: &dyn Engine,
    progress: &dyn Progress,
) -> Result<Masked> {
    let looked_at = frame::looked_at(&poses.photos, &poses.points)
        .ok_or_else(|| no_common_subject("cameras that look at no common point"))?;
    let graph = engine.load(prior::SCENE.verified()?)?;
    let (mut seen, mut photos, mut best) = (Vec::new(), Vec::new(), None::<Best>);
    progress.begin("masks", poses.photos.len() as u64);
    for (index, posed) in poses.photos.iter().enumerate() {
        progress.check()?;
        let mut leave_out = |why: String| photos.push(Used { name: posed.name.clone(), role: Role::LeftOut(why) });
        let photo = straightened(open(posed)?, posed)?;
        let (w, h) = (f64::from(photo.pixels.width()), f64::from(photo.pixels.height()));
        let at = posed.pixel(looked_at).map(|[x, y]| {
            [x * w / f64::from(posed.camera.width), y * h / f64::from(posed.camera.height)].map(|v| v as f32)
        });
        match at.filter(|[x, y]| (0.0..w as f32).contains(x) && (0.0..h as f32).contains(y)) {
            None => leave_out("its camera does not look at the subject".into()),
            Some(point) => match scene::subject(&photo.pixels, photo.cutout.as_ref(), Some(point), &*graph) {
                Err(e) if e.kind == crate::Kind::Usage => leave_out(e.found),
                Err(e) => return Err(e),
                Ok(subject) => {
                    let crop = Crop::new(posed, &photo.pixels, &subject, CROP);
                    let score = fitness(&crop, &subject, w.max(h));
                    if best.as_ref().is_none_or(|b| score > b.score) {
                        best = Some(Best { index, photo, subject, score });
                    }
                    seen.push(Seen { index, crop });
                }
            },
        }
        progress.step(index as u64 + 1);
    }
    match best {
        Some(best) if seen.len() >= 2 => Ok(Masked { seen, best, photos }),
        _ => Err(no_common_subject(format!(
            "{} such photos of {}{}",
            seen.len(),
            poses.photos.len(),
            match photos.first() {
                Some(Used { name, role: Role::LeftOut(why) }) => format!("; {name}: {why}"),
                _ => String::new(),
            }
        ))),
    }
}

/// More photos take more steps, and more time for them; what the masks took of it does not count.
fn settings_for(settings: &Settings, photos: usize) -> Settings {
    let more = |share: f64, most: f64| (photos as f64 / share).clamp(1.0, most);
    match settings.optimise_within {
        // Somebody named the number of steps, or wants all.
        None => settings.clone(),
        Some(limit) => Settings {
            iterations: (f64::from(settings.iterations) * more(6.0, 6.0)) as u32,
            optimise_within: Some(limit.mul_f64(more(4.0, 8.0))),
            deadline: None,
            ..settings.clone()
        },
    }
}

/// How well a photo suits the network: whole, large, and seen from 15° above, where most of its lessons were.
fn fitness(crop: &Crop, subject: &Subject, longest: f64) -> f64 {
    let whole = if crop.cut_off { 0.2 } else { 1.0 };
    let [x0, y0, x1, y1] = subject.bounds.map(|v| v as f64);
    let large = (x1 - x0).hypot(y1 - y0);
    let off = f64::from(subject.elevation.mean.to_degrees() - 15.0) / 25.0;
    whole * (large * f64::from(subject.scale.0) / longest).min(0.6) * (-off * off).exp()
}

/// Without the lens's distortion; refused where it has another shape than its camera.
fn straightened(photo: Photo, posed: &Posed) -> Result<Photo> {
    let (w, h) = photo.pixels.dimensions();
    let shape = |w: u32, h: u32| f64::from(w) / f64::from(h);
    if (shape(w, h) / shape(posed.camera.width, posed.camera.height) - 1.0).abs() > 0.02 {
        return Err(Error::usage(&photo.name)
            .expected(format!("a photo of the shape of its camera, {} × {}", posed.camera.width, posed.camera.height))
            .found(format!("{w} × {h}"))
            .advice("Give the photos that the poses were computed from, not turned, not cropped."));
    }
    if posed.camera.lens.is_pinhole() {
        return Ok(photo);
    }
    let flat = |c: &image::GrayImage| image::DynamicImage::from(c.clone()).into_rgb8();
    let cutout =
        photo.cutout.as_ref().map(|c| image::DynamicImage::from(posed.camera.undistorted(&flat(c))).into_luma8());
    Ok(Photo { pixels: posed.camera.undistorted(&photo.pixels), cutout, ..photo })
}

struct Framed {
    to_unit: Similarity,
    up_by: UpBy,
    ground: Option<Ground>,
}

/// The unit frame, and the photos whose masks do not fit the others' left out.
fn framed(
    seen: &mut Vec<Seen>,
    photos: &mut Vec<Used>,
    poses: &Poses,
    best: &Best,
    cameras_up: DVec3,
    options: &Options,
    seed: u64,
) -> Result<Framed> {
    let parallel = || no_common_subject("masks that no common body has");
    let reference = &poses.photos[best.index];
    let top = reference.rotation.inverse() * -DVec3::Y;
    let crops = |seen: &[Seen]| seen.iter().map(|s| s.crop.clone()).collect::<Vec<_>>();
    let (middle, radius) = frame::ball(&crops(seen)).ok_or_else(parallel)?;
    let ground = frame::ground(&poses.points, middle, radius, options.up.unwrap_or(cameras_up), seed);
    let (up, up_by) = match (options.up, &ground) {
        (Some(up), _) => (up, UpBy::Georegistration),
        (None, Some(g)) => (g.normal, UpBy::Ground),
        (None, None) => (cameras_up, UpBy::Cameras),
    };
    let frame_of = |middle: DVec3, radius: f64| frame::unit(middle, radius, up, reference.centre(), top);
    let mut to_unit = frame_of(middle, radius);
    // Twice: what the first body makes of the photos decides which of them carve the second.
    for round in 0..2 {
        let silhouettes: Vec<Silhouette> = seen.iter().map(|s| s.crop.silhouette(s.crop.camera(&to_unit))).collect();
        let tolerated = if round == 0 && seen.len() > 3 { 0.3 } else { tolerated(seen.len()) };
        let skin = Hull::carve(&silhouettes, tolerated).skin(&silhouettes);
        if skin.is_empty() {
            return Err(parallel());
        }
        if round == 0 && seen.len() > 3 {
            let fits: Vec<f32> = silhouettes.iter().map(|s| start::silhouette_iou(&skin, s)).collect();
            let mut at = 0;
            seen.retain(|s| {
                at += 1;
                let fit = fits[at - 1];
                let agrees = fit >= AGREES || s.index == best.index;
                if !agrees {
                    let why = format!("its mask meets the others' body to {:.0} %", 100.0 * fit);
                    photos.push(Used { name: s.crop.name.clone(), role: Role::LeftOut(why) });
                }
                agrees
            });
        }
        let (middle, radius) = around(&skin);
        let back = to_unit.inverse();
        // Two or three silhouettes leave long tails: the boxes say the size better.
        let scale = if seen.len() >= ENOUGH_FOR_A_HULL { radius } else { radius.min(1.1) };
        to_unit = frame_of(back.apply(middle.as_dvec3()), f64::from(scale) * back.scale);
    }
    Ok(Framed { to_unit, up_by, ground })
}

/// Share of the masks that may miss a part.
fn tolerated(photos: usize) -> f32 {
    if photos < 6 { 0.0 } else { 0.13 }
}

/// Middle of the box around Gaussians, and how far they reach from it.
fn around(g: &Gaussians) -> (Vec3, f32) {
    let low = g.positions.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = g.positions.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let middle = (low + high) / 2.0;
    (middle, g.positions.iter().map(|p| p.distance(middle)).fold(1e-3, f32::max))
}

fn posed_focal(posed: &Posed, photo: &Photo) -> f64 {
    posed.camera.pinhole()[0] * f64::from(photo.pixels.width()) / f64::from(posed.camera.width)
}

/// The reference's camera of the network's square crop, in the unit frame.
fn square_camera(posed: &Posed, photo: &Photo, view: &OneView, to_unit: &Similarity) -> Camera {
    let [fx, fy, cx, cy] = posed.camera.pinhole();
    let (gx, gy) = (
        f64::from(photo.pixels.width()) / f64::from(posed.camera.width),
        f64::from(photo.pixels.height()) / f64::from(posed.camera.height),
    );
    let size = view.mask.width;
    let k = size as f64 / f64::from(view.crop.width);
    let inside =
        [fx * gx * k, fy * gy * k, (cx * gx - f64::from(view.crop.x)) * k, (cy * gy - f64::from(view.crop.y)) * k];
    camera(inside, (size, size), posed.rotation, posed.translation, to_unit)
}

/// What the optimisation starts from, and how many of it come from network, masks and points.
fn beginning(
    view: &OneView,
    network_iou: f32,
    training: &[Silhouette],
    points: &[(DVec3, [u8; 3])],
    to_unit: &Similarity,
) -> (Gaussians, [usize; 3]) {
    let tolerated = tolerated(training.len());
    let mut g = start::carved(&view.gaussians, training, tolerated);
    // What the masks contradict is no help.
    if network_iou < 0.5 && training.len() >= ENOUGH_FOR_A_HULL {
        g = Gaussians::default();
    }
    let of_network = g.len();
    let (mut of_hull, mut of_points) = (0, 0);
    if training.len() >= ENOUGH_FOR_A_HULL {
        let skin = Hull::carve(training, tolerated).skin(training);
        let more = start::missing(&g, &skin);
        of_hull = more.len();
        g.extend(&more);
    }
    let local: Vec<(Vec3, [u8; 3])> = points
        .iter()
        .map(|(p, color)| (to_unit.apply(*p).as_vec3(), *color))
        .filter(|(p, _)| p.length() < 1.05)
        .collect();
    let local = start::carved(&start::of_points(&local), training, tolerated);
    if !local.is_empty() {
        of_points = local.len();
        g.extend(&local);
    }
    (g, [of_network, of_hull, of_points])
}

type Views<'a> = Vec<(usize, &'a (Camera, splat::Frame))>;

/// Of the six views those that no photo comes near.
fn unseen_views<'a>(six: &'a [(Camera, splat::Frame)], training: &[Silhouette]) -> Views<'a> {
    let away = |c: &Camera| {
        let at = c.position();
        training.iter().map(|s| s.camera.position().angle_between(at).to_degrees()).fold(180.0, f32::min)
    };
    six.iter().enumerate().filter(|(_, (camera, _))| away(camera) > UNSEEN).collect()
}

/// PSNR, SSIM and silhouettes of a result over photos that it was, or was not, trained on.
fn score<'a>(rows: impl Iterator<Item = (&'a Crop, Camera)>, g: &Gaussians) -> Scores {
    let (mut all, mut with_ssim) = (Scores::default(), 0usize);
    for (crop, camera) in rows {
        let seen = splat::render(g, &camera, GREY);
        let over = |(c, a): (&[f32; 3], &f32)| c.map(|v| v * a + 0.5 * (1.0 - a));
        let picture = |pixels: Vec<[f32; 3]>| Picture { width: crop.mask.width, height: crop.mask.height, pixels };
        let truth = picture(crop.colour.iter().zip(&crop.mask.data).map(over).collect());
        let found = picture(seen.color.iter().map(|c| c.map(|v| v.clamp(0.0, 1.0))).collect());
        all.photos += 1;
        all.psnr += perception::psnr(&found.pixels, &truth.pixels);
        if let Some(s) = perception::ssim(&found, &truth) {
            all.ssim += s;
            with_ssim += 1;
        }
        let drawn = Plane { width: crop.mask.width, height: crop.mask.height, data: seen.alpha };
        all.silhouette_iou += iou(&drawn, &crop.mask);
    }
    let n = all.photos.max(1) as f64;
    Scores {
        psnr: all.psnr / n,
        ssim: all.ssim / with_ssim.max(1) as f64,
        silhouette_iou: all.silhouette_iou / n,
        ..all
    }
}

fn iou(a: &Plane, b: &Plane) -> f64 {
    let (mut both, mut either) = (0u32, 0u32);
    for (x, y) in a.data.iter().zip(&b.data) {
        both += u32::from(*x > 0.5 && *y > 0.5);
        either += u32::from(*x > 0.5 || *y > 0.5);
    }
    f64::from(both) / f64::from(either.max(1))
}

/// Largest turn, degrees, and largest shift, parts of the distance, of cameras.
fn moved(before: &[Camera], after: &[Camera]) -> (f64, f64) {
    before.iter().zip(after).fold((0.0, 0.0), |(turn, shift), (a, b)| {
        let (p, q) = (a.position(), b.position());
        (
            f64::max(turn, crate::bench::alignment::rotation_angle(a.rotation, b.rotation)),
            f64::max(shift, f64::from(p.distance(q) / p.length().max(1e-6))),
        )
    })
}
