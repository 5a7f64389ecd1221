//! 3D from one view: the network that lifts the cropped subject to Gaussians.
//!
//! Canonical camera: OpenCV axes, 3.9 from the centre of the subject's bounding sphere of radius 1, 30° field of view.
//! **Subject unit frame**, in which everything here is handed on: the same unit, origin at the sphere's centre, right-
//! handed, Z up, +Y where the camera pointed (horizontally), +X to the photo's right.

use super::align::fit_intrinsics;
use super::scene::{Elevation, Subject};
use super::{Graph, Port, Tensor, check_contract, take};
use crate::photo::{Edge, Plane, Rect, sample_colour, sample_plane};
use crate::splat::{Camera, Gaussians, SH_C0};
use crate::{Error, Result};
use glam::Vec3;
use image::RgbImage;

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
    pub seen_from: Elevation,
    /// The camera that took `colour`: where the network sees it, focal length and principal point fitted to the mask.
    pub camera: Camera,
    /// How well the Gaussians' silhouette meets the mask under `camera`: intersection over union.
    pub silhouette_iou: f32,
    /// The square crop, in photo pixels.
    pub crop: Rect,
    /// sRGB 0..1 of the crop, row-major, as the photo shows it (not composited); the size of `mask`.
    pub colour: Vec<[f32; 3]>,
    /// Subject, 0..1; square, between 128² and 512².
    pub mask: Plane,
}

/// Runs the network on the crop around the subject. What `measured` the elevation is told to it in place of the subject's.
///
/// # Errors
/// An environment error when the graph is not the network expected; a usage error when it sees nothing solid.
pub fn one_view(
    photo: &RgbImage,
    subject: &Subject,
    measured: Option<Elevation>,
    graph: &dyn Graph,
) -> Result<OneView> {
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
        &[Port::new("rgba", &[1, 4, SIZE, SIZE]), Port::new("hint", &[1, 2])],
        &wanted,
    )?;
    let crop = crop_around(subject);
    let rgba = network_input(photo, subject, crop)?;
    // The crop has no horizon and no ground: what saw them says how the camera looks.
    let told = measured.unwrap_or(subject.elevation);
    let hint = Tensor::new(&[1, 2], vec![told.mean, told.spread])?;
    let mut outputs = graph.run(&[("rgba", &rgba), ("hint", &hint)])?;
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
    let own = take(&mut outputs, "elevation", 2)?;
    let own = Elevation { mean: own[0], spread: OVERCONFIDENT * own[1] };
    let stands = take(&mut outputs, "camera", 4)?;
    // Trained on −69° to 89°; beyond that the guess is no better than the bound.
    let bound = |e: f32| e.clamp(-1.25, 1.55);
    let elevation = bound(own.mean);
    // It was taught to trust hints less than they deserve at the height of eyes.
    let seen_from = match measured {
        Some(measured) => confirmed(measured, own),
        None => agreed(own, subject.elevation),
    };
    let seen_from = Elevation { mean: bound(seen_from.mean), ..seen_from };
    let gaussians = canonical.to_subject_frame(elevation);
    if gaussians.is_empty() {
        return Err(Error::usage("photo")
            .expected("a subject with a solid shape")
            .found("nothing that the network could lift to three dimensions")
            .advice("Use a sharper photo with the whole subject in view."));
    }
    let size = (crop.width.round() as usize).clamp(GRID, LARGEST_CROP);
    let mask = crop_mask(subject, crop, size);
    let (camera, silhouette_iou) = fit_intrinsics(&gaussians, &crop_camera(elevation, &stands, size as u32), &mask);
    let colour = sample_colour(photo, crop, size, size, Edge::Clamp);
    Ok(OneView { gaussians, expected_errors: errors, elevation, seen_from, camera, silhouette_iou, crop, colour, mask })
}

/// The elevation by SplatNet's own word and SceneNet's, which counts where it knows such photos.
fn agreed(own: Elevation, scene: Elevation) -> Elevation {
    if (FROM_BELOW..FROM_THE_AIR).contains(&own.mean) { own.joined(scene) } else { own }
}

/// What was measured of the elevation and SplatNet's own word, weighed by precision, but no further from what was measured than twice its
/// expected error: who measures is seldom wrong by more, and a network that is sure of itself may be.
fn confirmed(measured: Elevation, own: Elevation) -> Elevation {
    let joined = own.joined(measured);
    let off = 2.0 * measured.spread;
    let mean = joined.mean.clamp(measured.mean - off, measured.mean + off);
    Elevation { mean, spread: if mean == joined.mean { joined.spread } else { measured.spread } }
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

/// The square, in photo pixels, that the subject's box fills to [`FILL`]; it may reach outside the photo.
pub fn crop_around(subject: &Subject) -> Rect {
    let [x0, y0, x1, y1] = subject.bounds.map(|v| v as f32);
    let (sx, sy) = subject.scale;
    let side = ((x1 - x0) * sx).max((y1 - y0) * sy) / FILL;
    Rect { x: (x0 + x1) / 2.0 * sx - side / 2.0, y: (y0 + y1) / 2.0 * sy - side / 2.0, width: side, height: side }
}

fn crop_mask(subject: &Subject, crop: Rect, size: usize) -> Plane {
    let (sx, sy) = subject.scale;
    let rect = Rect { x: crop.x / sx, y: crop.y / sy, width: crop.width / sx, height: crop.height / sy };
    sample_plane(&subject.mask, rect, size, size, Edge::Zero)
}

/// Planes red, green, blue on grey 0.5, and the mask.
fn network_input(photo: &RgbImage, subject: &Subject, crop: Rect) -> Result<Tensor> {
    let mask = crop_mask(subject, crop, SIZE);
    let colour = sample_colour(photo, crop, SIZE, SIZE, Edge::Clamp);
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
mod tests {
    use super::*;

    fn single(position: [f32; 3], rotation: [f32; 4], opacity: f32) -> Canonical {
        Canonical {
            position: position.to_vec(),
            scale: vec![0.1, 0.02, 0.03],
            rotation: rotation.to_vec(),
            opacity: vec![opacity],
            color: vec![0.25, 0.5, 1.0],
        }
    }

    fn lifted(position: [f32; 3], elevation: f32) -> Vec3 {
        single(position, [1.0, 0.0, 0.0, 0.0], 0.5).to_subject_frame(elevation).positions[0]
    }

    #[test]
    fn the_canonical_centre_is_the_origin() {
        for degrees in [-10.0f32, 0.0, 25.0, 60.0] {
            assert!(lifted([0.0, 0.0, DISTANCE], degrees.to_radians()).length() < 1e-5);
        }
    }

    #[test]
    fn who_never_saw_such_a_photo_is_not_asked_for_its_elevation() {
        let level = Elevation { mean: 0.1, spread: 0.05 };
        let own = |degrees: f32| Elevation { mean: degrees.to_radians(), spread: 0.1 };
        for degrees in [-60.0, -20.0, 45.0, 80.0] {
            assert_eq!(agreed(own(degrees), level), own(degrees), "{degrees}");
        }
        for degrees in [-10.0, 0.0, 30.0] {
            assert_eq!(agreed(own(degrees), level), own(degrees).joined(level), "{degrees}");
        }
    }

    #[test]
    fn what_was_measured_counts_by_how_well_it_is_known() {
        let said = |mean: f32, spread: f32| Elevation { mean, spread };
        let (gimbal, guessed, sure) = (said(0.5, 0.03), said(0.5, 0.2), said(0.2, 0.02));
        let both = confirmed(gimbal, said(0.48, 0.03));
        assert!((both.mean - 0.49).abs() < 1e-6 && both.spread == 0.03, "{both:?}");
        // A network that contradicts it does not carry it away,
        assert_eq!(confirmed(gimbal, sure), said(0.5 - 2.0 * 0.03, 0.03));
        // but does where next to nothing was measured.
        assert_eq!(confirmed(guessed, sure), sure.joined(guessed));
        assert!((confirmed(guessed, sure).mean - 0.2).abs() < 0.01);
    }

    #[test]
    fn axes_are_those_of_the_subject_frame() {
        let e = 0.4f32;
        let right = lifted([1.0, 0.0, DISTANCE], e);
        assert!((right - Vec3::X).length() < 1e-5, "photo's right is +X: {right}");
        let forward = lifted([0.0, 0.0, DISTANCE + 1.0], e);
        assert!((forward - Vec3::new(0.0, e.cos(), -e.sin())).length() < 1e-5, "forward projects on +Y: {forward}");
        let up = lifted([0.0, -1.0, DISTANCE], e);
        assert!(up.z > 0.9 * e.cos() && up.x.abs() < 1e-6, "up is up: {up}");
        let eye = lifted([0.0, 0.0, 0.0], e);
        assert!((eye - DISTANCE * Vec3::new(0.0, -e.cos(), e.sin())).length() < 1e-5);
    }

    #[test]
    fn projection_by_the_camera_undoes_the_change_of_frame() {
        let (e, p) = (0.3, Vec3::new(0.4, -0.2, 4.3));
        let camera = canonical_camera(e, 128);
        let back = camera.rotation * lifted(p.to_array(), e) + camera.translation;
        assert!((back - p).length() < 1e-5);
        // 30° across: at the distance of the centre the frame's edge lies at 3.9 · tan 15°.
        let edge = camera.fx * (DISTANCE * 15f32.to_radians().tan()) / DISTANCE + camera.cx;
        assert!((edge - 128.0).abs() < 1e-3);
    }

    #[test]
    fn axes_of_a_gaussian_turn_with_the_frame() {
        let e = 0.5f32;
        // Longest along the canonical x turned by 90° about z: along the camera's down.
        let half = std::f32::consts::FRAC_1_SQRT_2;
        let g = single([0.0, 0.0, DISTANCE], [half, 0.0, 0.0, half], 0.5).to_subject_frame(e);
        let [w, x, y, z] = g.rotations[0];
        let long = glam::Quat::from_xyzw(x, y, z, w) * Vec3::X;
        let down = canonical_camera(e, 8).rotation.transpose() * Vec3::Y;
        assert!((long - down).length() < 1e-5, "{long} {down}");
        assert!((g.log_scales[0] - Vec3::new(0.1, 0.02, 0.03).map(|s| s.hypot(BLUR).ln())).length() < 1e-5);
        assert!((4.0 * BLUR - 0.3f32.sqrt() * 2.0 * DISTANCE * (FOV / 2.0).tan() / GRID as f32).abs() < 1e-6);
    }

    #[test]
    fn the_crops_camera_sees_what_lies_on_its_rays() {
        // `crop_rays` of a pixel: ((x, y) · half + middle) · (1 + nearness · (depth − 3.9)).
        let (e, stands, depth) = (0.3f32, [-0.4f32, 0.1, -0.2, 0.5], 3.4f32);
        let half = DISTANCE * (FOV / 2.0).tan() * stands[0].exp();
        let spread = 1.0 + stands[3].exp() / DISTANCE * (depth - DISTANCE);
        let beside = [(0.5 * half + stands[1]) * spread, (-0.25 * half + stands[2]) * spread];
        let point = single([beside[0], beside[1], depth], [1.0, 0.0, 0.0, 0.0], 0.5).to_subject_frame(e).positions[0];
        let camera = crop_camera(e, &stands, 200);
        let seen = camera.rotation * point + camera.translation;
        let (x, y) = (camera.fx * seen.x / seen.z + camera.cx, camera.fy * seen.y / seen.z + camera.cy);
        assert!((x - 150.0).abs() < 1e-2 && (y - 75.0).abs() < 1e-2, "{x} {y}");
        let (canonical, same) = (canonical_camera(e, 200), crop_camera(e, &[0.0; 4], 200));
        assert!((canonical.fx - same.fx).abs() < 1e-2 && (canonical.translation - same.translation).length() < 1e-5);
    }

    #[test]
    fn colour_and_opacity_survive() {
        let g = single([0.0, 0.0, 4.0], [1.0, 0.0, 0.0, 0.0], 0.7).to_subject_frame(0.0);
        let shown = g.sh[0][0].map(|v| SH_C0 * v + 0.5);
        assert!(shown.iter().zip([0.25, 0.5, 1.0]).all(|(a, b)| (a - b).abs() < 1e-6));
        assert!((1.0 / (1.0 + (-g.logit_opacities[0]).exp()) - 0.7).abs() < 1e-6);
        assert!(single([0.0; 3], [1.0, 0.0, 0.0, 0.0], 0.003).to_subject_frame(0.0).is_empty());
        let solid = single([0.0; 3], [1.0, 0.0, 0.0, 0.0], 1.0).to_subject_frame(0.0);
        assert!(solid.logit_opacities[0].is_finite());
    }

    #[test]
    fn the_crop_holds_the_box_at_its_fill() {
        let subject = Subject {
            mask: Plane::new(100, 50, 0.0),
            depth: Plane::new(100, 50, 0.0),
            bounds: [20, 10, 60, 30],
            scale: (4.0, 4.0),
            from_cutout: false,
            expected_iou: None,
            elevation: Elevation { mean: 0.2, spread: 0.05 },
        };
        let crop = crop_around(&subject);
        assert!((crop.width * FILL - 160.0).abs() < 1e-3 && crop.width == crop.height);
        assert!((crop.x + crop.width / 2.0 - 160.0).abs() < 1e-3 && (crop.y + crop.height / 2.0 - 80.0).abs() < 1e-3);
    }

    /// A flat square of Gaussians before the camera, the first half of them clear; the outputs that are named, and the elevation
    /// that it says, ± 0.05, both beyond what it is told.
    struct Flat(Vec<Port>, f32);

    impl Graph for Flat {
        fn inputs(&self) -> Vec<Port> {
            vec![Port::new("rgba", &[1, 4, SIZE, SIZE]), Port::new("hint", &[1, 2])]
        }
        fn outputs(&self) -> Vec<Port> {
            self.0.clone()
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            let hint = &inputs[1].1.data;
            let at = |i: usize| [(i % GRID) as f32 / 128.0 - 0.5, (i / GRID % GRID) as f32 / 128.0 - 0.5, DISTANCE];
            let values = |name: &str| -> Vec<f32> {
                match name {
                    "position" => (0..COUNT).flat_map(at).collect(),
                    "scale" => vec![0.01; 3 * COUNT],
                    "rotation" => (0..COUNT).flat_map(|_| [1.0, 0.0, 0.0, 0.0]).collect(),
                    "opacity" => (0..COUNT).map(|i| if i < COUNT / 2 { 0.001 } else { 0.9 }).collect(),
                    "color" => vec![0.5; 3 * COUNT],
                    "elevation" => vec![self.1 + hint[0], 0.05 + hint[1]],
                    "camera" => vec![0.0; 4],
                    _ => (0..COUNT).map(|i| 1.5 * i as f32 / COUNT as f32).collect(),
                }
            };
            self.0
                .iter()
                .map(|p| {
                    let data = values(&p.name);
                    Ok((p.name.clone(), Tensor::new(&[data.len()], data)?))
                })
                .collect()
        }
    }

    #[test]
    fn expected_errors_are_read_where_the_network_has_them() {
        let subject = Subject {
            mask: Plane::new(64, 64, 1.0),
            depth: Plane::new(64, 64, 0.0),
            bounds: [0, 0, 64, 64],
            scale: (2.0, 2.0),
            from_cutout: false,
            expected_iou: None,
            elevation: Elevation { mean: 0.2, spread: 0.05 },
        };
        let photo = RgbImage::new(128, 128);
        let mut ports: Vec<Port> = [("position", 3), ("scale", 3), ("rotation", 4), ("color", 3)]
            .map(|(name, width)| Port::new(name, &[1, COUNT, width]))
            .to_vec();
        ports.extend([Port::any("opacity"), Port::new("elevation", &[1, 2]), Port::new("camera", &[1, 4])]);
        let without = one_view(&photo, &subject, None, &Flat(ports.clone(), 0.2)).unwrap();
        assert_eq!(without.expected_errors, None);

        let with = |shape: &[usize]| Flat([ports.clone(), vec![Port::new(ERROR, shape)]].concat(), 0.2);
        let view = one_view(&photo, &subject, None, &with(&[1, COUNT])).unwrap();
        let errors = view.expected_errors.unwrap();
        assert_eq!((errors.len(), view.gaussians.len()), (COUNT / 2, COUNT / 2));
        // Those that are drawn, in their order, within 0..1.
        assert_eq!(
            [errors[0], errors[1], errors[COUNT / 2 - 1]],
            [0.75, 1.5 * (COUNT / 2 + 1) as f32 / COUNT as f32, 1.0]
        );
        assert_eq!(view.gaussians, without.gaussians);
        let refused = one_view(&photo, &subject, None, &with(&[1, COUNT, 3])).unwrap_err();
        assert!(
            refused.kind == crate::Kind::Environment && refused.to_string().contains("- output error"),
            "{refused}"
        );
    }

    #[test]
    fn the_network_is_told_of_the_elevation_and_its_answer_counts() {
        let subject = Subject {
            mask: Plane::new(64, 64, 1.0),
            depth: Plane::new(64, 64, 0.0),
            bounds: [0, 0, 64, 64],
            scale: (1.0, 1.0),
            from_cutout: false,
            expected_iou: None,
            elevation: Elevation { mean: 0.4, spread: 0.1 },
        };
        let ports = [("position", 3), ("scale", 3), ("rotation", 4), ("color", 3)];
        let mut ports = ports.map(|(name, width)| Port::new(name, &[1, COUNT, width])).to_vec();
        ports.extend([Port::any("opacity"), Port::new("elevation", &[1, 2]), Port::new("camera", &[1, 4])]);
        // `Flat` adds what it was told to what it says: 0.6 ± 0.27, and 0.4 ± 0.1.
        let view = one_view(&RgbImage::new(64, 64), &subject, None, &Flat(ports.clone(), 0.2)).unwrap();
        let weight = (0.1 / 0.27_f32).powi(2);
        assert!((view.elevation - 0.6).abs() < 1e-6, "{}", view.elevation);
        assert!((view.seen_from.mean - (0.4 + 0.6 * weight) / (1.0 + weight)).abs() < 1e-6, "{:?}", view.seen_from);
        assert_eq!(view.seen_from.spread, 0.1);
        // What was measured is told in place of it, and counts by how well it is known: 0.3 ± 0.18 and 0.1 ± 0.05.
        let measured = Elevation { mean: 0.1, spread: 0.05 };
        let view = one_view(&RgbImage::new(64, 64), &subject, Some(measured), &Flat(ports.clone(), 0.2)).unwrap();
        assert!((view.elevation - 0.3).abs() < 1e-6, "{}", view.elevation);
        let weight = (0.05 / 0.18_f32).powi(2);
        assert!((view.seen_from.mean - (0.1 + 0.3 * weight) / (1.0 + weight)).abs() < 1e-6, "{:?}", view.seen_from);
        assert_eq!(view.seen_from.spread, 0.05);
        // From the air its own counts alone.
        let view = one_view(&RgbImage::new(64, 64), &subject, None, &Flat(ports.clone(), 0.8)).unwrap();
        assert!((view.elevation - 1.2).abs() < 1e-6 && view.seen_from.mean == view.elevation, "{:?}", view.seen_from);
        assert!((view.seen_from.spread - 0.15 * OVERCONFIDENT).abs() < 1e-6, "{:?}", view.seen_from);
        let view = one_view(&RgbImage::new(64, 64), &subject, None, &Flat(ports, 3.0)).unwrap();
        assert_eq!(view.seen_from.mean, 1.55);
        assert_eq!(view.elevation, 1.55);
    }

    #[test]
    fn the_network_lifts_the_container_and_its_camera_shows_the_photo_again() {
        use crate::models::{Rten, prior, scene};
        let bytes = include_bytes!("../../tests/data/container.jpg");
        let photo = crate::photo::decode("container.jpg", bytes, &Default::default()).unwrap();
        let networks = scene::Networks::built_in(&Rten).unwrap();
        let subject = scene::subject(&photo.pixels, None, None, &networks).unwrap();
        let graph = prior::SPLAT.loaded(&Rten).unwrap();
        let view = one_view(&photo.pixels, &subject, None, &*graph).unwrap();
        assert!(
            (view.elevation.to_degrees() - 15.0).abs() < 6.0,
            "taken from 15°, guessed {}",
            view.elevation.to_degrees()
        );
        assert!(view.silhouette_iou > 0.9, "{}", view.silhouette_iou);
        assert_eq!((view.camera.width as usize, view.colour.len()), (view.mask.width, view.mask.data.len()));
        let seen = crate::splat::render(&view.gaussians, &view.camera, [0.5; 3]);
        let mut squares = 0.0;
        for (i, shown) in seen.color.iter().enumerate() {
            let a = view.mask.data[i];
            squares +=
                (0..3).map(|c| f64::from(shown[c] - (view.colour[i][c] * a + 0.5 * (1.0 - a))).powi(2)).sum::<f64>();
        }
        let psnr = -10.0 * (squares / (3 * seen.color.len()) as f64).log10();
        assert!(psnr > 18.0, "{psnr} dB");
        // Its bounding sphere is the unit, give or take; nothing lies under the far horizon.
        let inside = view.gaussians.positions.iter().filter(|p| p.length() < 1.3).count();
        assert!(inside as f32 > 0.95 * view.gaussians.len() as f32);
    }
}
