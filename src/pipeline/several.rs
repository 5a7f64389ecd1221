//! The stages with several photos in front: poses → masks → frame → Gaussians → optimisation → the same mesh.

use glam::{DQuat, DVec2, DVec3, Vec3};

use super::optimise::{trained, uncomposited};
use super::{Clock, Fitted, GREY, Settings, VIEW, VIEW_SIZE, render_all};
use crate::bench::{Picture, perception};
use crate::geo::similarity::Similarity;
use crate::models::splat_prior::{self, Aim, OneView, Taken};
use crate::models::{Engine, prior};
use crate::photo::{Photo, Pinhole, silhouette_iou};
use crate::photos::colmap::is_test;
use crate::photos::crops::{Crop, camera};
use crate::photos::frame::{self, Ground, UpBy};
use crate::photos::{Posed, Poses, start};
use crate::progress::Progress;
use crate::splat::render::Shown;
use crate::splat::{self, Camera, Gaussians, Target};
use crate::views::hull::{Hull, Silhouette};
use crate::{Error, Result, sources, views};

mod common_body;
pub(super) use common_body::straightened;
use common_body::{Framed, Masked, Seen, framed, masked};

/// Names of the targets in the optimisation's report: `photo NAME` and `held out NAME`.
pub const TRAINED: &str = "photo ";
pub const HELD_OUT: &str = "held out ";

/// As many photos as this, and every eighth is held out.
const ENOUGH: usize = 8;
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
    let lens = posed_lens(reference, &best.photo);
    let reference_focal = (!options.searched).then_some(lens.focal.x);
    let taken = match options.searched {
        // Its lens stands for none.
        true => Taken { lens: best.photo.pinhole(), ..Taken::default() },
        false => {
            let down = reference.rotation * (to_unit.rotation.inverse() * -DVec3::Z);
            let aim = Aim { lens, lens_assumed: false, down: Some(down), roll: 0.0 };
            Taken { lens: Some(lens), elevation: None, aim: Some(aim) }
        }
    };
    let mut one_view =
        splat_prior::one_view(&best.photo.pixels, &best.subject, &taken, &*prior::SPLAT.loaded(engine)?)?;
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
    // Nobody says how far those from masks and points are off.
    one_view.expected_errors = None;
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
            refine_pose: (options.refine_poses && !held).then_some(0.0),
            fit_exposure: false,
            held_back: None,
            confidence: None,
            shown: Shown::Color,
            name: format!("{}{}", if *held { HELD_OUT } else { TRAINED }, s.crop.name),
        })
        .collect();
    targets.extend(unseen_views(&six, &training).into_iter().map(|(i, (camera, frame))| Target {
        camera: *camera,
        color: uncomposited(frame),
        alpha: frame.alpha.clone(),
        weight: 0.1,
        refine_pose: None,
        fit_exposure: false,
        held_back: None,
        confidence: None,
        shown: Shown::Color,
        name: format!("{VIEW} {}", i + 1),
    }));
    let settings = &settings_for(settings, training.len());
    let rate = options.searched.then_some(SEARCHED_POSE_RATE);
    let trained = trained(fitter, &one_view.gaussians, &targets, settings, rate, progress)?;
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
        reference_focal,
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
        symmetry: Vec::new(),
        six,
        gaussians: trained.gaussians,
        report: trained.report,
        expected_error: None,
        sources: sources::Outcome::default(),
        cameras: trained.cameras,
        mirrored: Vec::new(),
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

/// Share of the masks that may miss a part.
fn tolerated(photos: usize) -> f32 {
    if photos < 6 { 0.0 } else { 0.13 }
}

/// The lens of a posed photo, in pixels of the photo that is there.
fn posed_lens(posed: &Posed, photo: &Photo) -> Pinhole {
    let [fx, fy, cx, cy] = posed.camera.pinhole();
    let (width, height) = photo.pixels.dimensions();
    let (gx, gy) =
        (f64::from(width) / f64::from(posed.camera.width), f64::from(height) / f64::from(posed.camera.height));
    Pinhole { focal: DVec2::new(fx * gx, fy * gy), middle: DVec2::new(cx * gx, cy * gy) }
}

/// The reference's camera of the network's square crop, in the unit frame.
fn square_camera(posed: &Posed, photo: &Photo, view: &OneView, to_unit: &Similarity) -> Camera {
    let Pinhole { focal, middle } = posed_lens(posed, photo);
    let size = view.mask.width;
    let rect = view.crop.rect;
    let k = size as f64 / f64::from(rect.width);
    let inside = [focal.x * k, focal.y * k, (middle.x - f64::from(rect.x)) * k, (middle.y - f64::from(rect.y)) * k];
    let turn = view.crop.turned.map_or(DQuat::IDENTITY, |t| DQuat::from_mat3(&t.to_photo.transpose()));
    camera(inside, (size, size), turn * posed.rotation, turn * posed.translation, to_unit)
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
        all.silhouette_iou += silhouette_iou(&seen.alpha, &crop.mask.data).unwrap_or(0.0);
    }
    let n = all.photos.max(1) as f64;
    Scores {
        psnr: all.psnr / n,
        ssim: all.ssim / with_ssim.max(1) as f64,
        silhouette_iou: all.silhouette_iou / n,
        ..all
    }
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
