//! Photos as training wants them: straightened, made smaller, masked, with their cameras in the unit frame.

use image::{DynamicImage, GrayImage, RgbImage, imageops};

use super::{Options, Source, cameras};
use crate::geo::similarity::Similarity;
use crate::photo::Photo;
use crate::photos::Posed;
use crate::photos::crops::camera;
use crate::pipeline::several::straightened;
use crate::progress::Progress;
use crate::splat::render::Shown;
use crate::splat::{Camera, Target};
use crate::{Error, Result};

/// All photos of a set.
pub struct Pictures {
    /// One a photo, in order; those held out have no weight.
    pub targets: Vec<Target>,
    /// Whether any photo has an alpha channel that cuts something out.
    pub alpha: bool,
}

impl Pictures {
    /// How many are trained on.
    ///
    /// # Errors
    /// Usage for fewer than two.
    pub fn trained_on(&self) -> Result<usize> {
        match self.targets.iter().filter(|t| t.weight > 0.0).count() {
            n @ 0..2 => Err(Error::usage("photos")
                .expected("at least two photos to train on")
                .found(n.to_string())
                .advice("Hold fewer out: --test-every 0 holds none.")),
            n => Ok(n),
        }
    }
}

/// The camera of a photo made no longer than `longest` pixels a side, in the unit frame.
pub fn camera_of(posed: &Posed, to_unit: &Similarity, longest: u32) -> Camera {
    sized(posed, to_unit, made_smaller(posed.camera.width, posed.camera.height, longest))
}

/// The camera of a picture of `size` pixels of what the photo shows, in the unit frame.
fn sized(posed: &Posed, to_unit: &Similarity, size: [u32; 2]) -> Camera {
    let (w, h) = (posed.camera.width, posed.camera.height);
    let [fx, fy, cx, cy] = posed.camera.pinhole();
    let (gx, gy) = (f64::from(size[0]) / f64::from(w), f64::from(size[1]) / f64::from(h));
    let inside = [fx * gx, fy * gy, cx * gx, cy * gy];
    camera(inside, (size[0] as usize, size[1] as usize), posed.rotation, posed.translation, to_unit)
}

fn made_smaller(w: u32, h: u32, longest: u32) -> [u32; 2] {
    let shrink = (f64::from(longest) / f64::from(w.max(h))).min(1.0);
    [w, h].map(|v| ((f64::from(v) * shrink).round() as u32).max(1))
}

/// Reads all photos, one at full size in memory at a time.
///
/// # Errors
/// As the source; usage for a mask of another shape than its photo.
pub fn read(source: &Source, to_unit: &Similarity, options: &Options, progress: &dyn Progress) -> Result<Pictures> {
    let photos = &source.poses.photos;
    progress.begin("photos", photos.len() as u64);
    let mut pictures = Pictures { targets: Vec::with_capacity(photos.len()), alpha: false };
    for (i, posed) in photos.iter().enumerate() {
        progress.check()?;
        let photo = (source.open)(posed)?;
        let mask = (source.mask)(i)?;
        let held_out = source.held_out.get(i).copied().unwrap_or(false);
        let (target, alpha) = one(photo, mask, posed, to_unit, options.longest_side)?;
        pictures.alpha |= alpha;
        pictures.targets.push(Target {
            weight: if held_out { 0.0 } else { 1.0 },
            fit_exposure: options.exposure && !held_out,
            ..target
        });
        progress.step(i as u64 + 1);
    }
    if options.refine_poses {
        let cameras: Vec<Camera> = pictures.targets.iter().map(|t| t.camera).collect();
        let depths = cameras::depths(source.poses, to_unit, &cameras);
        for (t, depth) in pictures.targets.iter_mut().zip(depths).filter(|(t, _)| t.weight > 0.0) {
            t.refine_pose = Some(depth);
        }
    }
    Ok(pictures)
}

/// One photo, and whether its alpha cuts something out.
fn one(
    photo: Photo,
    mask: Option<GrayImage>,
    posed: &Posed,
    to_unit: &Similarity,
    longest: u32,
) -> Result<(Target, bool)> {
    let (w, h) = photo.pixels.dimensions();
    if let Some(m) = mask.as_ref().filter(|m| m.dimensions() != (w, h)) {
        return Err(Error::usage(format!("the mask of {}", posed.name))
            .expected(format!("{w} × {h}, as the photo"))
            .found(format!("{} × {}", m.width(), m.height())));
    }
    let bent = !posed.camera.lens.is_pinhole();
    let photo = straightened(photo, posed)?;
    // What a straightened photo does not show is masked.
    let usable = match (mask, bent) {
        (None, false) => None,
        (mask, bent) => {
            let mask = mask.unwrap_or_else(|| GrayImage::from_pixel(w, h, image::Luma([255])));
            let rgb = DynamicImage::from(mask).into_rgb8();
            Some(if bent { posed.camera.undistorted(&rgb) } else { rgb })
        }
    };
    let size = made_smaller(w, h, longest);
    let small = |image: &RgbImage| match size == [w, h] {
        true => image.clone(),
        false => imageops::thumbnail(image, size[0], size[1]),
    };
    let pixels = small(&photo.pixels);
    let alpha: Option<Vec<f32>> = photo.cutout.map(|a| {
        let a = if size == [w, h] { a } else { imageops::thumbnail(&a, size[0], size[1]) };
        a.pixels().map(|p| f32::from(p.0[0]) / 255.0).collect()
    });
    let held_back = usable.map(|m| small(&m).pixels().map(|p| p.0[0] < 128).collect());
    // The photo was put over white: straight colours again.
    let straight = |(p, a): (&image::Rgb<u8>, f32)| {
        p.0.map(|v| {
            let over = f32::from(v) / 255.0;
            if a > 0.0 { ((over - (1.0 - a)) / a).clamp(0.0, 1.0) } else { 0.0 }
        })
    };
    let of = |i: usize| alpha.as_ref().map_or(1.0, |a| a[i]);
    let color = pixels.pixels().enumerate().map(|(i, p)| straight((p, of(i)))).collect();
    let cut_out = alpha.is_some();
    let target = Target {
        // Of the photo's own size: photos may be smaller than their calibrated cameras.
        camera: sized(posed, to_unit, size),
        color,
        alpha: alpha.unwrap_or_else(|| vec![1.0; (size[0] * size[1]) as usize]),
        weight: 1.0,
        refine_pose: None,
        fit_exposure: false,
        held_back,
        confidence: None,
        shown: Shown::Color,
        name: posed.name.clone(),
    };
    Ok((target, cut_out))
}
