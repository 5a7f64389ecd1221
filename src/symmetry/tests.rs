use super::*;
use crate::splat::{SH_C0, render};
use crate::views;
use glam::Mat3;

const GREY: [f32; 3] = [0.5; 3];

/// Small round Gaussians over the sides of a box, coloured by where they are.
fn boxed(low: Vec3, high: Vec3, color: impl Fn(Vec3) -> [f32; 3]) -> Gaussians {
    const STEP: f32 = 0.035;
    let mut g = Gaussians::default();
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let count = |k: usize| ((high[k] - low[k]) / STEP).ceil() as usize;
        for side in [low[axis], high[axis]] {
            for (i, j) in (0..=count(u)).flat_map(|i| (0..=count(v)).map(move |j| (i, j))) {
                let mut p = Vec3::ZERO;
                p[axis] = side;
                p[u] = low[u] + (high[u] - low[u]) * i as f32 / count(u) as f32;
                p[v] = low[v] + (high[v] - low[v]) * j as f32 / count(v) as f32;
                g.positions.push(p);
                g.log_scales.push(Vec3::splat(0.02f32.ln()));
                g.rotations.push([1.0, 0.0, 0.0, 0.0]);
                g.logit_opacities.push(5.0);
                let mut sh = [[0.0; 3]; 16];
                sh[0] = color(p).map(|c| (c - 0.5) / SH_C0);
                g.sh.push(sh);
            }
        }
    }
    g
}

/// Bonnet, cabin and stripes; alike on both sides of y = 0, front towards −x.
fn van(color: impl Fn(Vec3) -> [f32; 3]) -> Gaussians {
    let mut g = boxed(Vec3::new(-0.8, -0.35, -0.4), Vec3::new(0.8, 0.35, 0.0), &color);
    g.extend(&boxed(Vec3::new(-0.3, -0.35, 0.0), Vec3::new(0.8, 0.35, 0.4), &color));
    g
}

fn stripes(p: Vec3) -> [f32; 3] {
    let band = ((p.x * 6.0).floor() as i32).rem_euclid(3);
    match band {
        0 => [0.8, 0.2, 0.2],
        1 => [0.2, 0.7, 0.3],
        _ => [0.9, 0.9, 0.8 - p.z],
    }
}

/// The scene turned and shifted, a photo of it, and the plane y = 0 after that.
struct Case {
    g: Gaussians,
    camera: Camera,
    color: Vec<[f32; 3]>,
    mask: Vec<f32>,
    truth: Plane,
}

impl Case {
    fn new(g: Gaussians) -> Self {
        let turn = Mat3::from_rotation_z(0.9);
        let shift = Vec3::new(0.05, -0.04, 0.0);
        let g = g.transformed(turn, 1.0, shift);
        let camera = views::orbit(0.0, 15.0, views::DISTANCE, 192);
        let frame = render(&g, &camera, GREY);
        let normal = turn * Vec3::Y;
        let truth = Plane { normal, offset: normal.dot(shift) };
        Case { g, camera, color: frame.color, mask: frame.alpha, truth }
    }

    fn seen(&self) -> Seen<'_> {
        Seen { camera: self.camera, color: &self.color, mask: &self.mask }
    }
}

#[test]
fn mirrored_gaussians_look_flipped_from_the_mirrored_camera() {
    let mut g = van(stripes);
    // Shapes and harmonics that a mirror changes.
    for (i, sh) in g.sh.iter_mut().enumerate() {
        for (basis, value) in sh.iter_mut().enumerate().skip(1) {
            *value = [0.05 * ((i + basis) as f32).sin(), 0.03, -0.02];
        }
        g.log_scales[i].x += 0.5;
        g.rotations[i] = [0.9, 0.3, -0.2, (i % 5) as f32 * 0.1];
    }
    let camera = Camera { cx: 60.0, ..views::orbit(20.0, 25.0, 4.0, 128) };
    let plane = Plane { normal: Vec3::new(0.6, 0.8, 0.0), offset: 0.13 };
    let (a, b) = (render(&g, &camera, GREY), render(&plane.gaussians(&g), &plane.camera(&camera), GREY));
    let back = flipped(&b.color, 128);
    let mean: f32 = a.color.iter().zip(&back).map(|(a, b)| (a[0] - b[0]).abs()).sum::<f32>() / a.color.len() as f32;
    assert!(mean < 2e-4, "{mean}");
    assert!((plane.camera(&camera).rotation.determinant() - 1.0).abs() < 1e-5);
    let there = plane.reflect(Vec3::new(0.3, -0.2, 0.7));
    assert!((plane.reflect(there) - Vec3::new(0.3, -0.2, 0.7)).length() < 1e-6);
}

#[test]
fn the_plane_of_a_van_is_found() {
    let case = Case::new(van(stripes));
    let found = find(&case.g, &case.seen(), Use::Auto);
    let fit = found[0].fit;
    let lean = fit.plane.normal.dot(case.truth.normal).abs().min(1.0).acos().to_degrees();
    assert!(lean < 1.5, "{lean}° off: {fit:?}");
    let offset = fit.plane.offset * fit.plane.normal.dot(case.truth.normal).signum();
    assert!((offset - case.truth.offset).abs() < 0.02, "{offset} for {}", case.truth.offset);
    assert!(found[0].used(), "{fit:?}");
    // Bonnet and cabin: front and back are not alike.
    assert!(found[1..].iter().all(|f| !f.used()), "{found:?}");
    assert!(find(&case.g, &case.seen(), Use::Two).iter().all(|f| f.used()));
    assert!(find(&case.g, &case.seen(), Use::Off).is_empty());
    assert!(fit.plane.distance(case.camera.position()) > 0.0);
}

#[test]
fn a_back_is_not_like_the_front_for_being_of_one_colour() {
    let white = |p: Vec3| [0.9, 0.9, 0.8 - 0.5 * p.z];
    let mut lorry = boxed(Vec3::new(-0.8, -0.65, -0.4), Vec3::new(0.55, 0.65, 0.3), white);
    lorry.extend(&boxed(Vec3::new(0.55, -0.65, -0.25), Vec3::new(0.8, 0.65, 0.15), white));
    let case = Case::new(lorry);
    let across = find(&case.g, &case.seen(), Use::Auto)[1];
    assert!(across.fit.convinces(), "{across:?}");
    assert!(!across.used(), "{across:?}");
}

#[test]
fn what_is_not_symmetric_does_not_convince() {
    let mut crooked = van(|p| if p.y > 0.0 { stripes(p) } else { [0.1, 0.1, 0.4 + 0.3 * p.x] });
    crooked.extend(&boxed(Vec3::new(-0.7, -0.9, -0.4), Vec3::new(-0.3, -0.35, 0.7), |_| [0.9, 0.8, 0.1]));
    crooked.extend(&boxed(Vec3::new(0.5, 0.35, -0.4), Vec3::new(0.8, 0.8, -0.2), |_| [0.1, 0.8, 0.9]));
    let case = Case::new(crooked);
    let found = find(&case.g, &case.seen(), Use::Auto);
    assert!(found.iter().all(|f| !f.used()), "{found:?}");
    let nothing = Seen { mask: &vec![0.0; case.mask.len()], ..case.seen() };
    assert!(find(&case.g, &nothing, Use::On).is_empty());
}

#[test]
fn a_far_side_that_lies_too_deep_does_not_move_the_plane() {
    // As the surface of fog does; from the sides the van is as wide as ever.
    let case = Case::new(van(stripes));
    let toward = case.truth.distance(case.camera.position()).signum();
    let truth = Plane { normal: case.truth.normal * toward, offset: case.truth.offset * toward };
    let along = truth.normal.cross(Vec3::Z);
    let mut dented = case.g.clone();
    for p in &mut dented.positions {
        if truth.distance(*p) < -0.33 && (-0.36..0.36).contains(&p.z) && along.dot(*p).abs() < 0.7 {
            *p += 0.06 * truth.normal;
        }
    }
    let by = |off: f32| Plane { offset: truth.offset + off, ..truth };
    let shape = |off: f32| search::fit(&dented, &case.seen(), by(off)).unwrap().shape;
    assert!(shape(0.02) < 0.95 * shape(0.0), "the shape tells it: {} {}", shape(0.02), shape(0.0));
    for off in [0.03, -0.03] {
        let left = middle::centred(&dented, by(off)).offset - truth.offset;
        assert!(left.abs() < 0.006, "{left} from {off}");
    }
    let found = find(&dented, &case.seen(), Use::Auto)[0];
    let off = |plane: Plane| plane.offset - truth.offset;
    assert!(found.used() && off(found.fit.plane) > 0.01 && off(found.plane).abs() < 0.008, "{found:?}");
}

/// Seen square to its long side, so that no two of the points it shows are each other's mirror image.
fn broadside(g: Gaussians) -> Case {
    let camera = views::orbit(0.0, 0.0, views::DISTANCE, 192);
    let toward = Vec3::new(camera.position().x, camera.position().y, 0.0).normalize();
    let turn = Mat3::from_rotation_z(toward.y.atan2(toward.x) - std::f32::consts::FRAC_PI_2);
    let g = g.transformed(turn, 1.0, Vec3::ZERO);
    let frame = render(&g, &camera, GREY);
    Case { g, camera, color: frame.color, mask: frame.alpha, truth: Plane { normal: turn * Vec3::Y, offset: 0.0 } }
}

#[test]
fn the_plane_of_what_is_seen_from_the_side_is_assumed() {
    // The far side invented in another colour than the near one's.
    let case = broadside(van(|p| if p.y < -0.3 { [0.5; 3] } else { stripes(p) }));
    let found = find(&case.g, &case.seen(), Use::Auto);
    assert_eq!(found[0].basis, Some(Basis::Assumed), "{found:?}");
    let lean = found[0].fit.plane.normal.dot(case.truth.normal).abs().min(1.0).acos().to_degrees();
    assert!(lean < 2.0, "{lean}° off: {found:?}");
    assert!(found[1..].iter().all(|f| !f.used()), "{found:?}");
    assert!(find(&case.g, &case.seen(), Use::Evident).iter().all(|f| !f.used()));
}

#[test]
fn the_back_of_a_tower_is_assumed_to_be_its_front() {
    let bands = |p: Vec3| if p.y < -0.1 { [0.5; 3] } else { stripes(Vec3::new(2.0 * p.z, p.y, p.x)) };
    let mut g = boxed(Vec3::new(-0.3, -0.3, -0.8), Vec3::new(0.3, 0.3, 0.5), bands);
    g.extend(&boxed(Vec3::new(-0.2, -0.2, 0.5), Vec3::new(0.2, 0.2, 0.8), bands));
    let tower = broadside(g);
    let found = find(&tower.g, &tower.seen(), Use::Auto);
    let gives_the_back = |f: &Found| f.used() && f.fit.plane.normal.dot(tower.truth.normal).abs() > 0.9;
    assert!(found.iter().any(gives_the_back), "{found:?}");
}

#[test]
fn the_far_side_is_given_by_the_near_one() {
    // The far side invented in one dull colour.
    let true_case = Case::new(van(stripes));
    let dull = true_case.g.clone();
    let toward = true_case.truth.distance(true_case.camera.position()).signum();
    let plane = Plane { normal: true_case.truth.normal * toward, offset: true_case.truth.offset * toward };
    let mut invented = dull;
    for i in 0..invented.len() {
        if plane.distance(invented.positions[i]) < -0.3 {
            invented.sh[i][0] = [0.0; 3];
        }
    }
    let seen = true_case.seen();
    let completed = complete(&invented, &seen, &[plane]).gaussians;
    // From the other side.
    let other = plane.camera(&true_case.camera);
    let truth = render(&true_case.g, &other, GREY);
    let error = |g: &Gaussians| {
        let shown = render(g, &other, GREY);
        let pairs = shown.color.iter().zip(&truth.color);
        pairs.map(|(a, b)| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f32>()).sum::<f32>()
    };
    assert!(error(&completed) < 0.1 * error(&invented), "{} {}", error(&completed), error(&invented));
    // The photo's own side stays as it was.
    let front = render(&completed, &true_case.camera, GREY);
    let change: f32 = front.color.iter().zip(&true_case.color).map(|(a, b)| (a[0] - b[0]).abs()).sum::<f32>()
        / front.color.len() as f32;
    assert!(change < 0.01, "{change}");

    let photo = &complete(&true_case.g, &seen, &[plane]).photos[0];
    assert_eq!(photo.camera, other);
    let known = photo.seen_directly.iter().zip(&photo.mask).filter(|(s, m)| **s && **m > 0.5).count();
    let all = photo.mask.iter().filter(|m| **m > 0.5).count();
    // Front and roof are seen directly, the flank is not.
    assert!((0.1..0.8).contains(&(known as f32 / all as f32)), "{known} of {all}");
}

/// Alike on both sides of two planes, front and back, left and right.
#[test]
fn what_is_alike_front_and_back_is_known_from_all_sides() {
    let hut = |dull: bool| {
        let color = move |p: Vec3| match (dull && p.x + p.y > 0.3, p.z > 0.35) {
            (true, _) => [0.5; 3],
            (_, true) => [0.3, 0.3, 0.6],
            _ => stripes(Vec3::new((p.x.abs() - p.y.abs()) + 2.0, 0.0, p.z)),
        };
        let mut g = boxed(Vec3::new(-0.8, -0.4, -0.4), Vec3::new(0.8, 0.4, 0.2), color);
        g.extend(&boxed(Vec3::new(-0.5, -0.2, 0.2), Vec3::new(0.5, 0.2, 0.5), color));
        g
    };
    let case = Case::new(hut(false));
    let found = find(&case.g, &case.seen(), Use::Auto);
    assert!(found.len() == 2 && found.iter().all(|f| f.used()), "{found:?}");
    let across = found[0].fit.plane.normal.dot(found[1].fit.plane.normal);
    assert!(across.abs() < 1e-3, "{across}");

    let invented = Case::new(hut(true)).g;
    let completed = complete(&invented, &case.seen(), &used(&found));
    assert_eq!(completed.photos.len(), 3);
    let of = |g: &Gaussians, i: usize| (g.positions[i], g.sh[i][0], g.logit_opacities[i]);
    let (own, images): (Vec<_>, Vec<_>) = completed.origins.iter().enumerate().partition(|(_, o)| !o.mirrored);
    assert_eq!(own.len() + images.len(), completed.gaussians.len());
    assert!(own.iter().all(|(i, o)| of(&completed.gaussians, *i) == of(&invented, o.of)));
    for (i, origin) in &images {
        let (at, color, opacity) = of(&completed.gaussians, *i);
        let (from, its_color, its_opacity) = of(&invented, origin.of);
        let planes = used(&found);
        let places = [planes[0].reflect(from), planes[1].reflect(from), planes[0].reflect(planes[1].reflect(from))];
        assert!(places.iter().any(|p| p.distance(at) < 1e-4) && (color, opacity) == (its_color, its_opacity));
    }
    assert!(images.len() > 100, "{}", images.len());
    let error = |g: &Gaussians, camera: &Camera| {
        let (shown, truth) = (render(g, camera, GREY), render(&case.g, camera, GREY));
        let pairs = shown.color.iter().zip(&truth.color);
        pairs.map(|(a, b)| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f32>()).sum::<f32>()
    };
    for photo in &completed.photos {
        let (before, after) = (error(&invented, &photo.camera), error(&completed.gaussians, &photo.camera));
        assert!(after < 0.35 * before || before < 5.0, "{before} to {after}");
        // What the mirrored picture shows is what is there.
        let truth = render(&case.g, &photo.camera, GREY);
        let shown = photo.color.iter().zip(&truth.color).zip(&photo.mask).filter(|(_, m)| **m > 0.9);
        let off: Vec<f32> = shown.map(|((a, b), _)| (0..3).map(|k| (a[k] - b[k]).abs()).sum::<f32>() / 3.0).collect();
        assert!(off.iter().sum::<f32>() / (off.len() as f32) < 0.06);
    }
}

/// A body of one colour with a head at one end, as `van` lies.
fn animal() -> Gaussians {
    let mut g = boxed(Vec3::new(-0.5, -0.22, -0.3), Vec3::new(0.75, 0.22, 0.15), wool);
    g.extend(&boxed(Vec3::new(-0.85, -0.14, 0.1), Vec3::new(-0.5, 0.14, 0.5), wool));
    g
}

fn wool(_: Vec3) -> [f32; 3] {
    [0.85, 0.83, 0.78]
}

#[test]
fn a_plane_across_the_length_is_refused_where_a_head_would_meet_nothing() {
    let fit = |g: Gaussians, heading: f32| {
        let case = Case::new(g);
        let normal = Mat3::from_rotation_z(heading) * case.truth.normal;
        let middle = Vec3::new(0.05, -0.04, 0.0);
        search::fit(&case.g, &case.seen(), Plane { normal, offset: normal.dot(middle) }).unwrap()
    };
    let across = fit(animal(), std::f32::consts::FRAC_PI_2);
    assert!(across.elongation > 1.5 && across.stray > 0.02 && !across.convinces() && !across.plausible(), "{across:?}");
    let along = fit(animal(), 0.0);
    assert!(along.elongation < 0.6 && along.stray < 0.01, "{along:?}");
    // Both ends of a plain box are alike.
    let boxes = fit(boxed(Vec3::new(-0.8, -0.35, -0.4), Vec3::new(0.8, 0.35, 0.2), wool), std::f32::consts::FRAC_PI_2);
    assert!(boxes.elongation > 1.5 && boxes.stray < 0.01, "{boxes:?}");
}

#[test]
fn what_is_photographed_from_the_side_is_mirrored_along_its_length() {
    let case = broadside(animal());
    let found = find(&case.g, &case.seen(), Use::Auto);
    let plane = used(&found)[0];
    assert!(plane.normal.dot(case.truth.normal).abs() > 0.97, "{found:?}");
    assert!(
        (plane.offset - case.truth.offset * plane.normal.dot(case.truth.normal).signum()).abs() < 0.06,
        "{found:?}"
    );
}
