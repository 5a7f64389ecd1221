use super::*;
use crate::photo::Rect;

/// Of a photo whose pixels are `scale` times as fine as the mask's.
fn subject(mask: Plane, bounds: crate::models::region::Bounds, scale: f32, elevation: Angle) -> Subject {
    Subject {
        depth: Plane::new(mask.width, mask.height, 0.0),
        mask,
        bounds,
        scale: (scale, scale),
        from_cutout: false,
        expected_iou: None,
        elevation,
        roll: 0.0,
    }
}

/// What the network says, but for the error.
fn ports() -> Vec<Port> {
    let mut ports = [("position", 3), ("scale", 3), ("rotation", 4), ("color", 3)]
        .map(|(name, width)| Port::new(name, &[1, COUNT, width]))
        .to_vec();
    ports.extend([Port::any("opacity"), Port::new("elevation", &[1, 2]), Port::new("camera", &[1, 4])]);
    ports
}

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
    let level = Angle { mean: 0.1, spread: 0.05 };
    let own = |degrees: f32| Angle { mean: degrees.to_radians(), spread: 0.1 };
    for degrees in [-60.0, -20.0, 45.0, 80.0] {
        assert_eq!(agreed(own(degrees), level), own(degrees), "{degrees}");
    }
    for degrees in [-10.0, 0.0, 30.0] {
        assert_eq!(agreed(own(degrees), level), own(degrees).joined(level), "{degrees}");
    }
}

#[test]
fn what_was_measured_counts_by_how_well_it_is_known() {
    let said = |mean: f32, spread: f32| Angle { mean, spread };
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
    let subject = subject(Plane::new(100, 50, 0.0), [20, 10, 60, 30], 4.0, Angle { mean: 0.2, spread: 0.05 });
    let crop = Window::around(&subject).rect;
    assert!((crop.width * FILL - 160.0).abs() < 1e-3 && crop.width == crop.height);
    assert!((crop.x + crop.width / 2.0 - 160.0).abs() < 1e-3 && (crop.y + crop.height / 2.0 - 80.0).abs() < 1e-3);
}

/// A flat square of Gaussians before the camera, the first half of them clear; the outputs that are named, and the elevation
/// that it says, ± 0.05, both beyond what it is told.
struct Flat(Vec<Port>, f32);

impl Graph for Flat {
    fn inputs(&self) -> Vec<Port> {
        vec![Port::new("rgba", &[1, 4, SIZE, SIZE]), Port::new("hint", &[1, 3])]
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
    let subject = subject(Plane::new(64, 64, 1.0), [0, 0, 64, 64], 2.0, Angle { mean: 0.2, spread: 0.05 });
    let photo = RgbImage::new(128, 128);
    let without = one_view(&photo, &subject, &Taken::default(), &Flat(ports(), 0.2)).unwrap();
    assert_eq!(without.expected_errors, None);

    let with = |shape: &[usize]| Flat([ports(), vec![Port::new(ERROR, shape)]].concat(), 0.2);
    let view = one_view(&photo, &subject, &Taken::default(), &with(&[1, COUNT])).unwrap();
    let errors = view.expected_errors.unwrap();
    assert_eq!((errors.len(), view.gaussians.len()), (COUNT / 2, COUNT / 2));
    // Those that are drawn, in their order, within 0..1.
    assert_eq!([errors[0], errors[1], errors[COUNT / 2 - 1]], [0.75, 1.5 * (COUNT / 2 + 1) as f32 / COUNT as f32, 1.0]);
    assert_eq!(view.gaussians, without.gaussians);
    let refused = one_view(&photo, &subject, &Taken::default(), &with(&[1, COUNT, 3])).unwrap_err();
    assert!(refused.kind == crate::Kind::Environment && refused.to_string().contains("- output error"), "{refused}");
}

#[test]
fn the_network_is_told_of_the_elevation_and_its_answer_counts() {
    let subject = subject(Plane::new(64, 64, 1.0), [0, 0, 64, 64], 1.0, Angle { mean: 0.4, spread: 0.1 });
    // `Flat` adds what it was told to what it says: 0.6 ± 0.27, and 0.4 ± 0.1.
    let view = one_view(&RgbImage::new(64, 64), &subject, &Taken::default(), &Flat(ports(), 0.2)).unwrap();
    let weight = (0.1 / 0.27_f32).powi(2);
    assert!((view.elevation - 0.6).abs() < 1e-6, "{}", view.elevation);
    assert!((view.seen_from.mean - (0.4 + 0.6 * weight) / (1.0 + weight)).abs() < 1e-6, "{:?}", view.seen_from);
    assert_eq!(view.seen_from.spread, 0.1);
    // What was measured is told in place of it, and counts by how well it is known: 0.3 ± 0.18 and 0.1 ± 0.05.
    let measured = Angle { mean: 0.1, spread: 0.05 };
    let view = one_view(
        &RgbImage::new(64, 64),
        &subject,
        &Taken { elevation: Some(measured), ..Taken::default() },
        &Flat(ports(), 0.2),
    )
    .unwrap();
    assert!((view.elevation - 0.3).abs() < 1e-6, "{}", view.elevation);
    let weight = (0.05 / 0.18_f32).powi(2);
    assert!((view.seen_from.mean - (0.1 + 0.3 * weight) / (1.0 + weight)).abs() < 1e-6, "{:?}", view.seen_from);
    assert_eq!(view.seen_from.spread, 0.05);
    // From the air its own counts alone.
    let view = one_view(&RgbImage::new(64, 64), &subject, &Taken::default(), &Flat(ports(), 0.8)).unwrap();
    assert!((view.elevation - 1.2).abs() < 1e-6 && view.seen_from.mean == view.elevation, "{:?}", view.seen_from);
    assert!((view.seen_from.spread - 0.15 * OVERCONFIDENT).abs() < 1e-6, "{:?}", view.seen_from);
    let view = one_view(&RgbImage::new(64, 64), &subject, &Taken::default(), &Flat(ports(), 3.0)).unwrap();
    assert_eq!(view.seen_from.mean, 1.55);
    assert_eq!(view.elevation, 1.55);
}

#[test]
fn the_network_is_told_what_angle_the_crop_spans() {
    let lens = Pinhole::centred(1000.0, (1000, 1000));
    let at =
        |x: f32| Window { rect: Rect { x, y: 400.0, width: 200.0, height: 200.0 }, turned: None }.half_angle(&lens);
    assert!((at(400.0) - 0.1).abs() < 1e-6, "{}", at(400.0));
    // 0.5 beside the axis: between what the rays to its sides and to its top and bottom span there.
    let (left, right) = (0.4_f32.atan(), 0.6_f32.atan());
    let along = ((right - left) / 2.0).tan();
    let across = (100.0 / 1000_f32.hypot(500.0)).atan().tan();
    assert!(along < at(900.0) && at(900.0) < across, "{along} {} {across}", at(900.0));
    assert!((at(900.0) / (along * across).sqrt() - 1.0).abs() < 0.01);

    /// Keeps what it was told.
    struct Told(std::sync::Mutex<Vec<f32>>, Flat);
    impl Graph for Told {
        fn inputs(&self) -> Vec<Port> {
            self.1.inputs()
        }
        fn outputs(&self) -> Vec<Port> {
            self.1.outputs()
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            *self.0.lock().unwrap() = inputs[1].1.data.clone();
            self.1.run(inputs)
        }
    }
    let subject = subject(Plane::new(64, 64, 1.0), [0, 0, 64, 64], 1.0, Angle { mean: 0.4, spread: 0.1 });
    let told = |focal: Option<f64>| {
        let graph = Told(std::sync::Mutex::default(), Flat(ports(), 0.2));
        one_view(
            &RgbImage::new(64, 64),
            &subject,
            &Taken { lens: focal.map(|f| Pinhole::centred(f, (64, 64))), ..Taken::default() },
            &graph,
        )
        .unwrap();
        graph.0.into_inner().unwrap()
    };
    assert_eq!(told(None), [0.4, 0.1, 0.0]);
    let lens = told(Some(100.0));
    assert!(lens[..2] == [0.4, 0.1] && (lens[2] - 32.0 / FILL / 100.0).abs() < 1e-6, "{lens:?}");
}

#[test]
fn who_looked_past_its_subject_looks_again() {
    /// Says of each picture that the subject's middle is to the right of its own by a quarter of its side.
    struct Past(Flat, std::sync::Mutex<Vec<Vec<f32>>>);
    impl Graph for Past {
        fn inputs(&self) -> Vec<Port> {
            self.0.inputs()
        }
        fn outputs(&self) -> Vec<Port> {
            self.0.outputs()
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            self.1.lock().unwrap().push(inputs[0].1.data.clone());
            let mut out = self.0.run(inputs)?;
            let camera = &mut out.iter_mut().find(|(name, _)| name == "camera").unwrap().1;
            camera.data[1] = -0.5 * DISTANCE * (FOV / 2.0).tan();
            Ok(out)
        }
    }
    let mut mask = Plane::new(64, 64, 0.0);
    (24..40).for_each(|y| (44..60).for_each(|x| mask.data[64 * y + x] = 1.0));
    let subject = subject(mask, [44, 24, 60, 40], 1.0, Angle { mean: 0.4, spread: 0.1 });
    let photo = RgbImage::from_fn(64, 64, |x, y| image::Rgb([4 * x as u8, 4 * y as u8, 90]));
    let lens = Pinhole::centred(64.0, (64, 64));
    let made = |aim| {
        let graph = Past(Flat(ports(), 0.0), std::sync::Mutex::default());
        let view = one_view(&photo, &subject, &Taken { aim, ..Taken::default() }, &graph).unwrap();
        (view, graph.1.into_inner().unwrap())
    };
    let (as_it_is, once) = made(None);
    assert!(as_it_is.crop == Window::around(&subject) && once.len() == 1);
    let aim = Aim { lens, lens_assumed: false, down: None, roll: 0.0 };
    let (turned, looks) = made(Some(aim));
    assert!(looks.len() == 2 && looks[0] != once[0] && looks[0] != looks[1]);
    let first = Window::straight(&subject, &aim, 0.4);
    let axis = |w: Window| w.turned.unwrap().to_photo.z_axis;
    assert!(axis(turned.crop).x > axis(first).x + 0.02, "{} {}", axis(turned.crop), axis(first));
}

#[test]
fn the_network_lifts_the_container_and_its_camera_shows_the_photo_again() {
    use crate::models::{Rten, prior, scene};
    let (photo, subject) = &*scene::tests::CONTAINER;
    let graph = prior::SPLAT.loaded(&Rten).unwrap();
    let view = one_view(photo, subject, &Taken::default(), &*graph).unwrap();
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
        squares += (0..3).map(|c| f64::from(shown[c] - (view.colour[i][c] * a + 0.5 * (1.0 - a))).powi(2)).sum::<f64>();
    }
    let psnr = -10.0 * (squares / (3 * seen.color.len()) as f64).log10();
    assert!(psnr > 18.0, "{psnr} dB");
    // Its bounding sphere is the unit, give or take; nothing lies under the far horizon.
    let inside = view.gaussians.positions.iter().filter(|p| p.length() < 1.3).count();
    assert!(inside as f32 > 0.95 * view.gaussians.len() as f32);
}
