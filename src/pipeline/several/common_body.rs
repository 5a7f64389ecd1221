//! What the photos show together: a mask of each, the frame around their common body, and who does not fit.

use glam::{DVec3, Vec3};

use super::{ENOUGH_FOR_A_HULL, Options, Role, Used, no_common_subject, tolerated};
use crate::geo::similarity::Similarity;
use crate::models::Engine;
use crate::models::scene::{self, Subject};
use crate::photo::Photo;
use crate::photos::crops::Crop;
use crate::photos::frame::{self, Ground, UpBy};
use crate::photos::{Posed, Poses, start};
use crate::progress::Progress;
use crate::splat::Gaussians;
use crate::views::hull::{Hull, Silhouette};
use crate::{Error, Result};

/// Longer side of a photo's piece in training, pixels.
const CROP: usize = 512;
/// A mask that meets the others' body no better than this shows something else.
const AGREES: f32 = 0.5;

/// A photo that passed the mask.
pub struct Seen {
    pub index: usize,
    pub crop: Crop,
}

pub struct Masked {
    pub seen: Vec<Seen>,
    pub best: Best,
    pub photos: Vec<Used>,
}

/// The photo that the network lifts to three dimensions.
pub struct Best {
    pub index: usize,
    pub photo: Photo,
    pub subject: Subject,
    pub score: f64,
}

/// Every photo's subject, one photo in memory at a time.
pub fn masked(
    poses: &Poses,
    open: &dyn Fn(&Posed) -> Result<Photo>,
    engine: &dyn Engine,
    progress: &dyn Progress,
) -> Result<Masked> {
    let looked_at = frame::looked_at(&poses.photos, &poses.points)
        .ok_or_else(|| no_common_subject("cameras that look at no common point"))?;
    let networks = scene::Networks::built_in(engine)?;
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
            Some(point) => match scene::subject(&photo.pixels, photo.cutout.as_ref(), Some(point), &networks) {
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

/// How well a photo suits the network: whole, large, and seen from 15° above, where most of its lessons were.
fn fitness(crop: &Crop, subject: &Subject, longest: f64) -> f64 {
    let whole = if crop.cut_off { 0.2 } else { 1.0 };
    let [x0, y0, x1, y1] = subject.bounds.map(|v| v as f64);
    let large = (x1 - x0).hypot(y1 - y0);
    let off = f64::from(subject.elevation.mean.to_degrees() - 15.0) / 25.0;
    whole * (large * f64::from(subject.scale.0) / longest).min(0.6) * (-off * off).exp()
}

/// Without the lens's distortion; refused where it has another shape than its camera.
pub fn straightened(photo: Photo, posed: &Posed) -> Result<Photo> {
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

pub struct Framed {
    pub to_unit: Similarity,
    pub up_by: UpBy,
    pub ground: Option<Ground>,
}

/// The unit frame, and the photos whose masks do not fit the others' left out.
pub fn framed(
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

/// Middle of the box around Gaussians, and how far they reach from it.
fn around(g: &Gaussians) -> (Vec3, f32) {
    let low = g.positions.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = g.positions.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let middle = (low + high) / 2.0;
    (middle, g.positions.iter().map(|p| p.distance(middle)).fold(1e-3, f32::max))
}
