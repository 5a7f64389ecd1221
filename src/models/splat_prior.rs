//! 3D from one view: the network that lifts the cropped subject to Gaussians.
//!
//! Canonical camera: OpenCV axes, 3.9 from the centre of the subject's bounding sphere of radius 1, 30° field of view.
//! **Subject unit frame**, in which everything here is handed on: the same unit, origin at the sphere's centre, right-
//! handed, Z up, +Y where the camera pointed (horizontally), +X to the photo's right.

use super::align::fit_intrinsics;
use super::scene::{Angle, Subject};
use super::{Graph, Port, Tensor, check_contract, take};
use crate::photo::{Edge, Pinhole, Plane};
use crate::splat::{Camera, Gaussians, SH_C0};
use crate::{Error, Result};
use glam::Vec3;
use image::RgbImage;

mod window;
pub use window::{Aim, Turned, Window};

/// Of the network's square input.
const SIZE: usize = 256;
/// Of the square grid that the Gaussians lie on, two a cell.
const GRID: usize = 128;
const COUNT: usize = 2 * GRID * GRID;
/// The subject's bounding box takes this part of the crop's side.
pub const FILL: f32 = 0.88;
/// Eye to the subject's centre, in bounding-sphere radii.
pub const DISTANCE: f32 = 3.9;
/// Field of view, radians.
pub const FOV: f32 = std::f32::consts::PI / 6.0;
/// Standard deviation that each Gaussian of the network is widened by, so that fine pictures have no gaps between them: a quarter of
/// what the pictures blurred Gaussians with that version 0.6 learned by, √0.3 pixels (Kerbl et al. 2023) of 128 over [`FOV`], at
/// [`DISTANCE`]. Networks since 0.7 learn by pictures true to size; of 0.9, 18 objects, 24 views, silhouette IoU and PSNR with none of it
/// are 0.812 and 20.83 dB, with a quarter 0.813 and 20.83, half 0.812 and 20.79, all 0.807 and 20.59; meshes are closer with a quarter than with half (Ch 1.41 and 1.42 %).
const BLUR: f32 = 0.25 * 0.5477 * 2.0 * DISTANCE * 0.267_949 / GRID as f32;
/// What the network's spread counts times: it learned what to expect on its own generator's objects. So much, [`OneView::seen_from`] errs
/// by 0.98 of what it expects, in the mean of 72 photos of the development set, half of them from the air.
const OVERCONFIDENT: f32 = 1.8;
/// From here on the camera looks down from the air, radians: SceneNet learned up to 54°, so tells that it does but not how steeply.
const FROM_THE_AIR: f32 = 0.7;
/// From here on down the camera looks up at what flies, radians: SceneNet learned down to −17°.
const FROM_BELOW: f32 = -0.25;
/// Output with the colour error to be expected of each Gaussian.
const ERROR: &str = "error";
/// The crop is handed on at no more than this.
const LARGEST_CROP: usize = 512;

/// The subject in three dimensions, with the photo that it came from.
#[derive(Clone, Debug)]
pub struct OneView {
    /// Subject unit frame.
    pub gaussians: Gaussians,
    /// One a Gaussian: the colour error to be expected where a view from anywhere shows it, sRGB 0..1; the mean absolute
    /// difference of the channels. `None` where nobody says.
    pub expected_errors: Option<Vec<f32>>,
    /// Of the camera above the horizon, radians, as the network drew what it saw: by it the Gaussians stand upright.
    pub elevation: f32,
    /// The same as all that was seen lets expect. Shape and `elevation` go together right or wrong, so only what places the camera
    /// goes by this: outdoors its mean error is 1.1° for 2.8° (18 photos of the development set).
    pub seen_from: Angle,
    /// The camera that took `colour`: where the network sees it, focal length and principal point fitted to the mask.
    pub camera: Camera,
    /// How well the Gaussians' silhouette meets the mask under `camera`: intersection over union.
    pub silhouette_iou: f32,
    pub crop: Window,
    /// sRGB 0..1 of the crop, row-major, as the photo shows it (not composited); the size of `mask`.
    pub colour: Vec<[f32; 3]>,
    /// Subject, 0..1; square, between 128² and 512².
    pub mask: Plane,
}

/// What is known of the camera that took the photo, beside what the photo shows; by default nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Taken {
    /// Of the camera above the horizon, where it was measured: counts in place of what the subject's surroundings say.
    pub elevation: Option<Angle>,
    pub lens: Option<Pinhole>,
    /// By which the photo is drawn as a camera sees it that looks straight at the subject. `None`: it is taken as it is.
    pub aim: Option<Aim>,
}

/// Runs the network on the subject, and where it says that its camera did not look straight at it, on what one sees that does. What is
/// known of how the photo was `taken` is told to it.
///
/// # Errors
/// An environment error when the graph is not the network expected; a usage error when it sees nothing solid.
pub fn one_view(photo: &RgbImage, subject: &Subject, taken: &Taken, graph: &dyn Graph) -> Result<OneView> {
    let mut wanted = vec![
        Port::new("position", &[1, COUNT, 3]),
        Port::new("scale", &[1, COUNT, 3]),
        Port::new("rotation", &[1, COUNT, 4]),
        Port::any("opacity"),
        Port::new("color", &[1, COUNT, 3]),
        Port::new("elevation", &[1, 2]),
        Port::new("camera", &[1, 4]),
    ];
    // Networks up to 0.7 do not say how wrong they are.
    let says_error = graph.outputs().iter().any(|p| p.name == ERROR);
    wanted.extend(says_error.then(|| Port::new(ERROR, &[1, COUNT])));
    check_contract(
        "splat network",
        graph,
        &[Port::new("rgba", &[1, 4, SIZE, SIZE]), Port::new("hint", &[1, 3])],
        &wanted,
    )?;
    // The crop has no horizon and no ground: what saw them says how the camera looks. Nor does it say how near the camera stood: the
    // same crop is what a long lens saw of a long subject.
    let told = taken.elevation.unwrap_or(subject.elevation);
    let answer = |crop: &Window| {
        let tangent = taken.lens.map_or(0.0, |lens| crop.half_angle(&lens));
        let hint = Tensor::new(&[1, 3], vec![told.mean, told.spread, tangent])?;
        let mut outputs = graph.run(&[("rgba", &network_input(photo, subject, crop)?), ("hint", &hint)])?;
        let stands = take(&mut outputs, "camera", 4)?;
        let own = take(&mut outputs, "elevation", 2)?;
        Ok((outputs, stands, Angle { mean: own[0], spread: OVERCONFIDENT * own[1] }))
    };
    let joined = |own: Angle| match taken.elevation {
        Some(measured) => confirmed(measured, own),
        // It was taught to trust hints less than they deserve at the height of eyes.
        None => agreed(own, subject.elevation),
    };
    let mut crop = taken.aim.map_or_else(|| Window::around(subject), |aim| Window::straight(subject, &aim, told.mean));
    let (mut outputs, mut stands, mut own) = answer(&crop)?;
    let corrected = |aim: Aim| crop.corrected(subject, &aim, joined(own).mean, subjects_middle(&stands));
    if let Some(better) = taken.aim.and_then(corrected) {
        crop = better;
        (outputs, stands, own) = answer(&crop)?;
    }
    let canonical = Canonical {
        position: take(&mut outputs, "position", 3 * COUNT)?,
        scale: take(&mut outputs, "scale", 3 * COUNT)?,
        rotation: take(&mut outputs, "rotation", 4 * COUNT)?,
        opacity: take(&mut outputs, "opacity", COUNT)?,
        color: take(&mut outputs, "color", 3 * COUNT)?,
    };
    let errors = match says_error {
        true => Some(canonical.of_drawn(&take(&mut outputs, ERROR, COUNT)?)),
        false => None,
    };
    // Trained on −69° to 89°; beyond that the guess is no better than the bound.
    let bound = |e: f32| e.clamp(-1.25, 1.55);
    let elevation = bound(own.mean);
    let seen_from = joined(own);
    let seen_from = Angle { mean: bound(seen_from.mean), ..seen_from };
    let gaussians = canonical.to_subject_frame(elevation);
    if gaussians.is_empty() {
        return Err(Error::usage("photo")
            .expected("a subject with a solid shape")
            .found("nothing that the network could lift to three dimensions")
            .advice("Use a sharper photo with the whole subject in view."));
    }
    let size = (crop.rect.width.round() as usize).clamp(GRID, LARGEST_CROP);
    let mask = crop.plane(&subject.mask, subject.scale, size, Edge::Zero);
    let (camera, silhouette_iou) = fit_intrinsics(&gaussians, &crop_camera(elevation, &stands, size as u32), &mask);
    let colour = crop.colour(photo, size);
    Ok(OneView { gaussians, expected_errors: errors, elevation, seen_from, camera, silhouette_iou, crop, colour, mask })
}

/// The elevation by SplatNet's own word and SceneNet's, which counts where it knows such photos.
fn agreed(own: Angle, scene: Angle) -> Angle {
    if (FROM_BELOW..FROM_THE_AIR).contains(&own.mean) { own.joined(scene) } else { own }
}

/// What was measured of the elevation and SplatNet's own word, weighed by precision, but no further from what was measured than twice its
/// expected error: who measures is seldom wrong by more, and a network that is sure of itself may be.
fn confirmed(measured: Angle, own: Angle) -> Angle {
    let joined = own.joined(measured);
    let off = 2.0 * measured.spread;
    let mean = joined.mean.clamp(measured.mean - off, measured.mean + off);
    Angle { mean, spread: if mean == joined.mean { joined.spread } else { measured.spread } }
}

/// The camera of the training views in the subject unit frame: `elevation` in radians, looking at the origin.
pub fn canonical_camera(elevation: f32, size: u32) -> Camera {
    Camera::look_at(eye(elevation, DISTANCE), Vec3::ZERO, FOV, size)
}

fn eye(elevation: f32, distance: f32) -> Vec3 {
    distance * Vec3::new(0.0, -elevation.cos(), elevation.sin())
}

/// The photo's camera as the network sees it: it looks as the canonical one does, from its own distance, and the crop is a
/// part of its picture.
///
/// `stands` (`crop_rays` in `prior/nets.py`): log of half the crop's width at the subject's centre over what the
/// canonical camera sees there; the crop's middle there, right and down; log of the camera's inverse distance over the
/// canonical one's.
fn crop_camera(elevation: f32, stands: &[f32], size: u32) -> Camera {
    let distance = DISTANCE * (-stands[3].clamp(-1.5, 1.5)).exp();
    let half = DISTANCE * (FOV / 2.0).tan() * stands[0].exp();
    let pixels = size as f32 / 2.0 / half;
    let focal = distance * pixels;
    let camera = Camera::look_at(eye(elevation, distance), Vec3::ZERO, FOV, size);
    let middle = |aside: f32| size as f32 / 2.0 - aside * pixels;
    Camera { fx: focal, fy: focal, cx: middle(stands[1]), cy: middle(stands[2]), ..camera }
}

/// Where in the crop the network's own axis, and so the subject's middle, is: right and down, in halves of the crop's side.
fn subjects_middle(stands: &[f32]) -> [f32; 2] {
    let half = DISTANCE * (FOV / 2.0).tan() * stands[0].exp();
    [-stands[1] / half, -stands[2] / half]
}

/// Planes red, green, blue on grey 0.5, and the mask.
fn network_input(photo: &RgbImage, subject: &Subject, crop: &Window) -> Result<Tensor> {
    let mask = crop.plane(&subject.mask, subject.scale, SIZE, Edge::Zero);
    let colour = crop.colour(photo, SIZE);
    let mut data = vec![0.0; 4 * SIZE * SIZE];
    for (i, (pixel, &alpha)) in colour.iter().zip(&mask.data).enumerate() {
        for (c, value) in pixel.iter().enumerate() {
            data[c * SIZE * SIZE + i] = value * alpha + 0.5 * (1.0 - alpha);
        }
        data[3 * SIZE * SIZE + i] = alpha;
    }
    Tensor::new(&[1, 4, SIZE, SIZE], data)
}

/// As the network gives them: flat rows, canonical camera.
struct Canonical {
    position: Vec<f32>,
    scale: Vec<f32>,
    rotation: Vec<f32>,
    opacity: Vec<f32>,
    color: Vec<f32>,
}

impl Canonical {
    /// Index and opacity of those that are more than all but clear.
    fn drawn(&self) -> impl Iterator<Item = (usize, f32)> {
        self.opacity.iter().copied().enumerate().filter(|(_, opacity)| *opacity >= 1.0 / 255.0)
    }

    /// One number a Gaussian, 0..1, of those that [`Self::to_subject_frame`] keeps.
    fn of_drawn(&self, values: &[f32]) -> Vec<f32> {
        self.drawn().map(|(i, _)| values[i].clamp(0.0, 1.0)).collect()
    }

    /// Camera to subject: p = Rᵀ (p_camera − t), since p_camera = R p + t. What is all but clear is left out.
    fn to_subject_frame(&self, elevation: f32) -> Gaussians {
        let mut g = Gaussians::default();
        let triple = |v: &[f32], i: usize| Vec3::from_slice(&v[3 * i..3 * i + 3]);
        for (i, opacity) in self.drawn() {
            let opacity = opacity.min(0.999);
            g.positions.push(triple(&self.position, i));
            g.log_scales.push(triple(&self.scale, i).map(|s| s.hypot(BLUR).ln()));
            let q = &self.rotation[4 * i..4 * i + 4];
            g.rotations.push([q[0], q[1], q[2], q[3]]);
            g.logit_opacities.push((opacity / (1.0 - opacity)).ln());
            let mut sh = [[0.0; 3]; 16];
            sh[0] = ((triple(&self.color, i) - 0.5) / SH_C0).to_array();
            g.sh.push(sh);
        }
        let camera = canonical_camera(elevation, GRID as u32);
        g.transformed(camera.rotation.transpose(), 1.0, camera.position())
    }
}

#[cfg(test)]
mod tests;
