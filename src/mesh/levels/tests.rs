use super::super::clean::edges_used_twice;
use super::super::scenes::{self, Scene};
use super::super::{FIRM, MEDIAN, build, raster};
use super::*;
use crate::progress::Silent;
use crate::splat::Gaussians;
use crate::splat::render::Drawers;
use glam::{Mat3, Vec2};

fn quick() -> Options {
    Options {
        voxels: 72,
        views: 36,
        view_size: 144,
        color_views: 16,
        color_size: 128,
        texture_size: [256, 128, 64, 64],
        vertex_caps: [3000, 1000, 400, 128],
        background: scenes::BACKGROUND,
        ..Options::default()
    }
}

fn made(scene: &Scene, options: &Options) -> Model {
    build(&|c| scene.render(c), &[], options, &Silent).unwrap()
}

/// Faces by position: seams welded.
fn welded(mesh: &Mesh) -> Vec<[u32; 3]> {
    let mut places: Vec<[u32; 3]> = mesh.positions.iter().map(|p| p.to_array().map(f32::to_bits)).collect();
    let of = places.clone();
    places.sort_unstable();
    places.dedup();
    let find = |i: u32| places.binary_search(&of[i as usize]).unwrap() as u32;
    mesh.triangles.iter().map(|t| t.map(find)).collect()
}

/// What every model must be.
fn check(model: &Model, options: &Options) {
    assert_eq!(model.levels.len(), options.levels);
    assert!(edges_used_twice(&model.surface.triangles));
    for (k, level) in model.levels.iter().enumerate() {
        let m = &level.mesh;
        assert!(m.positions.len() <= options.vertex_caps[k], "level {k}: {}", m.positions.len());
        assert!(m.positions.len() == m.normals.len() && m.positions.len() == m.uvs.len());
        assert!(m.positions.iter().all(|p| p.is_finite()));
        assert!(m.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-3));
        assert!(m.uvs.iter().all(|uv| uv.min_element() >= 0.0 && uv.max_element() <= 1.0));
        let triangles = welded(m);
        assert!(edges_used_twice(&triangles), "level {k} is not closed");
        let mut sorted: Vec<[u32; 3]> = triangles
            .iter()
            .map(|t| {
                let mut t = *t;
                t.sort_unstable();
                t
            })
            .collect();
        sorted.sort_unstable();
        assert!(sorted.windows(2).all(|w| w[0] != w[1]), "level {k} has a triangle twice");
        let surface = Surface { positions: m.positions.clone(), triangles: m.triangles.clone() };
        assert!(surface.volume() > 0.0, "level {k} is inside out");
        assert_eq!(level.texture.dimensions(), (options.texture_size[k], options.texture_size[k]));
        assert!(level.error.is_finite() && level.mean_error <= level.error);
        assert!(k == 0 || level.error_to_coarser > model.levels[k - 1].error_to_coarser);
    }
}

/// (largest distance of the mesh from the scene's surface, largest distance of the scene's surface from the mesh).
fn hausdorff(mesh: &Mesh, scene: &Scene) -> (f32, f32) {
    let off = mesh.positions.iter().map(|p| (scene.distance)(*p).abs()).fold(0.0, f32::max);
    let bvh = Bvh::new(&mesh.positions, &mesh.triangles);
    (off, farthest(&scenes::sampled(scene, 60).positions, &bvh).0)
}

#[test]
fn a_ball_keeps_its_shape_in_all_levels() {
    let (scene, options) = (scenes::sphere(0.8), quick());
    let model = made(&scene, &options);
    check(&model, &options);
    for (level, bound) in model.levels.iter().zip([0.05, 0.05, 0.06, 0.12]) {
        let (off, missing) = hausdorff(&level.mesh, &scene);
        assert!(off < bound && missing < bound, "{off} {missing} for {bound}");
    }
    let volume = model.surface.volume();
    let truth = 4.0 / 3.0 * std::f64::consts::PI * 0.512;
    assert!((volume - truth).abs() < 0.03 * truth, "{volume} for {truth}");
}

#[test]
fn a_coloured_box_has_each_side_in_its_colour() {
    let (scene, options) = (scenes::boxed(0.7, 0.5, 0.3), quick());
    let model = made(&scene, &options);
    check(&model, &options);
    for (k, level) in model.levels.iter().enumerate() {
        let (off, missing) = hausdorff(&level.mesh, &scene);
        assert!(off < 0.035 && missing < 0.035, "level {k}: {off} {missing}");
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                let mut side = Vec3::ZERO;
                side[axis] = sign;
                let camera = Camera::look_at(side * 4.0, Vec3::ZERO, 0.5, 48);
                let picture = raster(&level.mesh, Some(&level.texture), &camera, [128; 3], 1);
                let expected = scenes::by_side(side).map(|c| (c * 255.0) as u8);
                // The middle of the side: well inside its outline.
                for (x, y) in [(24, 24), (21, 22), (27, 26)] {
                    let found = picture.get_pixel(x, y).0;
                    assert!(
                        found.iter().zip(expected).all(|(a, b)| a.abs_diff(b) < 16),
                        "level {k} side {side}: {found:?} for {expected:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_thin_plate_survives_on_both_sides() {
    for thickness in [0.004, 0.03] {
        let (scene, options) = (scenes::plate(thickness), quick());
        let model = made(&scene, &options);
        check(&model, &options);
        let (off, missing) = hausdorff(&model.levels[0].mesh, &scene);
        assert!(off < 0.04 && missing < 0.05, "{thickness}: {off} {missing}");
    }
}

#[test]
fn a_mast_that_only_the_photo_shows_is_put_back() {
    let (bare, rigged, options) = (scenes::boxed(0.6, 0.4, 0.2), scenes::boxed_with_mast(0.6, 0.4, 0.2), quick());
    let photo = Camera::look_at(Vec3::new(3.2, -2.0, 0.2), Vec3::ZERO, 0.5, 256);
    let render = |c: &Camera| if *c == photo { rigged.render(c) } else { bare.render(c) };
    let view = rigged.render(&photo);
    let photos = [PhotoView { mirrored: false, camera: photo, color: &view.color, mask: &view.alpha }];
    let model = build(&render, &photos, &options, &Silent).unwrap();
    check(&model, &options);
    let mast = |m: &Mesh| m.positions.iter().filter(|p| p.z > 0.35).copied().collect::<Vec<Vec3>>();
    let found = mast(&model.levels[0].mesh);
    let top = found.iter().map(|p| p.z).fold(0.0, f32::max);
    assert!(top > 0.55, "{top}");
    // Where it stands, and no thicker than a few samples.
    assert!(found.iter().all(|p| p.truncate().length() < 0.08), "{found:?}");
    // Views that do not know of it alone make a plain box.
    assert!(mast(&made(&bare, &options).levels[0].mesh).is_empty());
}

#[test]
fn a_bar_before_the_subject_that_only_the_photo_shows_is_put_back() {
    let options = quick();
    let [bare, rigged] = [false, true].map(|bar| scenes::boxed_with_arms(0.5, 0.4, 0.25, bar));
    // From +x: the bar's middle hides the box, its ends stand over and under it.
    let photo = Camera::look_at(Vec3::new(3.9, 0.3, 0.1), Vec3::ZERO, 0.52, 256);
    let render = |c: &Camera| if *c == photo { rigged.render(c) } else { bare.render(c) };
    let view = rigged.render(&photo);
    let photos = [PhotoView { mirrored: false, camera: photo, color: &view.color, mask: &view.alpha }];
    let model = build(&render, &photos, &options, &Silent).unwrap();
    check(&model, &options);
    let before = |model: &Model, z: f32| {
        let near = model.surface.positions.iter().filter(|p| (p.z - z).abs() < 0.05);
        near.filter(|p| (p.truncate() - glam::Vec2::new(0.7, 0.0)).length() < 0.07).count()
    };
    // Where it hides the box, at its own distance from it.
    let heights = [-0.05, 0.0, 0.05];
    assert!(heights.iter().all(|z| before(&model, *z) > 4), "{:?}", heights.map(|z| before(&model, z)));
    let without = made(&bare, &options);
    assert!(heights.iter().all(|z| before(&without, *z) == 0), "{:?}", heights.map(|z| before(&without, z)));
}

#[test]
fn a_car_keeps_wheels_mast_and_the_gap_under_it() {
    let (scene, options) = (scenes::car(), quick());
    let model = made(&scene, &options);
    check(&model, &options);
    let (off, missing) = hausdorff(&model.levels[0].mesh, &scene);
    assert!(off < 0.06 && missing < 0.06, "{off} {missing}");
    // Stands flat.
    let low = model.levels[0].mesh.bounds().0.z;
    assert!((low + 0.41).abs() < 0.04, "{low}");
    let on_ground = model.surface.positions.iter().filter(|p| (p.z - low).abs() < 1e-5).count();
    assert!(on_ground > 8, "{on_ground}");
}

#[test]
fn two_balls_stay_and_run_twice_is_the_same() {
    let (scene, options) = (scenes::two_spheres(), quick());
    let model = made(&scene, &options);
    check(&model, &options);
    let (lo, hi) = model.levels[3].mesh.bounds();
    assert!(lo.x < -0.8 && hi.x > 0.8);
    let again = made(&scene, &options);
    for (a, b) in model.levels.iter().zip(&again.levels) {
        assert!(a.mesh == b.mesh && a.texture == b.texture && a.error == b.error);
    }
}

#[test]
fn the_photo_wins_where_it_sees() {
    let (scene, options) = (scenes::boxed(0.6, 0.6, 0.6), quick());
    // From +x, a photo all black: only that side turns black.
    let camera = Camera::look_at(Vec3::X * 3.9, Vec3::ZERO, 0.52, 128);
    let mask = scene.render(&camera).alpha;
    let color = vec![[0.0; 3]; mask.len()];
    let photo = PhotoView { mirrored: false, camera, color: &color, mask: &mask };
    let model = build(&|c| scene.render(c), &[photo], &options, &Silent).unwrap();
    for level in &model.levels {
        assert!(level.seen > 0.1 && level.seen < 0.2, "{}", level.seen);
        let at = |side: Vec3| {
            let camera = Camera::look_at(side * 4.0, Vec3::ZERO, 0.5, 48);
            raster(&level.mesh, Some(&level.texture), &camera, [128; 3], 1).get_pixel(24, 24).0
        };
        assert!(at(Vec3::X).iter().all(|c| *c < 12), "{:?}", at(Vec3::X));
        let other = scenes::by_side(-Vec3::X).map(|c| (c * 255.0) as u8);
        assert!(at(-Vec3::X).iter().zip(other).all(|(a, b)| a.abs_diff(b) < 16));
    }
}

#[test]
fn lattices_fit_small_caps() {
    // Three crossing grids of bars: dozens of handles.
    let bars = |a: f32, b: f32| {
        let near = |v: f32| ((v * 4.0).round() / 4.0).clamp(-0.5, 0.5) - v;
        near(a).abs().max(near(b).abs()) - 0.035
    };
    let scene = Scene {
        distance: Box::new(move |p| {
            let d = bars(p.x, p.y).min(bars(p.y, p.z)).min(bars(p.x, p.z));
            d.max(p.abs().max_element() - 0.54) * 0.9
        }),
        color: Box::new(|_, n| scenes::by_side(n)),
    };
    let options = quick();
    check(&made(&scene, &options), &options);
}

/// Handles that no collapse can close do not take the vertices of what they are on: without other solids to choose from half of
/// this box is lost.
#[test]
fn a_box_with_handles_keeps_its_corners() {
    let boxed = scenes::boxed(0.6, 0.35, 0.3).distance;
    let ring = |p: Vec3| Vec2::new(Vec2::new(p.x, p.z).length() - 0.13, p.y).length() - 0.04;
    let rings: [Vec3; 6] =
        std::array::from_fn(|k| Vec3::new(0.3 * (k % 4) as f32 - 0.45, 0.3 * (k / 4) as f32 - 0.15, 0.31));
    let scene = Scene::new(move |p| rings.iter().map(|r| ring(p - *r)).fold(boxed(p), f32::min));
    let options = quick();
    let model = made(&scene, &options);
    check(&model, &options);
    assert_eq!(handles(&model.surface), 6);
    let volume = |level: &Level| {
        Surface { positions: level.mesh.positions.clone(), triangles: level.mesh.triangles.clone() }.volume()
    };
    let asked = Options { levels: 1, triangles: Some(600), ..quick() };
    let few = made(&scene, &asked).levels[0].mesh.triangles.len();
    assert!(few <= 600 && few > 540, "{few} triangles, handles and all");
    let (finest, coarsest) = (volume(&model.levels[0]), volume(&model.levels[3]));
    assert!(coarsest > 0.85 * finest, "{coarsest} of {finest}");
    assert!(model.levels[3].mean_error < 0.035, "{}", model.levels[3].mean_error);
}

#[test]
fn poor_input_is_an_error_or_a_model_and_never_a_panic() {
    let options = Options { levels: 2, ..quick() };
    let error = build(&|c| scenes::empty().render(c), &[], &options, &Silent).unwrap_err();
    assert!(error.to_string().contains("subject"), "{error}");
    for scene in [scenes::sphere(0.03), scenes::sphere(0.005), scenes::boxed(0.7, 0.7, 0.0005), scenes::sphere(1.05)] {
        match build(&|c| scene.render(c), &[], &options, &Silent) {
            Ok(model) => check(&model, &options),
            Err(error) => assert!(!error.found.is_empty()),
        }
    }
    // Full of NaN; and views of the wrong length.
    let nan = |c: &Camera| {
        let n = (c.width * c.height) as usize;
        View {
            camera: *c,
            color: vec![[f32::NAN; 3]; n],
            alpha: vec![f32::NAN; n],
            depth: vec![f32::NAN; n],
            passing: MEDIAN,
        }
    };
    assert!(build(&nan, &[], &options, &Silent).is_err());
    let short = |c: &Camera| View { camera: *c, color: vec![], alpha: vec![], depth: vec![], passing: MEDIAN };
    assert!(build(&short, &[], &options, &Silent).unwrap_err().found.contains('0'));
    let bad = Options { texture_size: [1000, 512, 256, 128], ..quick() };
    assert!(build(&nan, &[], &bad, &Silent).unwrap_err().subject.contains("texture"));
    let upside = Camera { rotation: Mat3::ZERO, ..Camera::look_at(Vec3::X, Vec3::ZERO, 0.5, 4) };
    let photo = PhotoView { mirrored: false, camera: upside, color: &[[0.0; 3]; 3], mask: &[1.0; 16] };
    assert!(build(&nan, &[photo], &options, &Silent).unwrap_err().subject.contains("photo"));
}

/// A depth error that differs from view to view and from place to place, as soft Gaussians make it.
fn uneven(scene: &Scene, camera: &Camera, size: f32) -> View {
    let mut view = scene.render(camera);
    let seed = camera.position();
    for (i, z) in view.depth.iter_mut().enumerate() {
        let (x, y) = (i as u32 % camera.width, i as u32 / camera.width);
        let (x, y) = (x as f32 / camera.width as f32, y as f32 / camera.width as f32);
        let wave = (25.0 * x + 9.0 * seed.x).sin() * (21.0 * y + 7.0 * seed.y).sin() + (5.0 * seed.z + 3.0 * x).sin();
        if *z > 0.0 {
            *z += size * (wave + 1.0);
        }
    }
    view
}

#[test]
fn views_that_disagree_make_one_smooth_solid() {
    let (scene, options) = (scenes::sphere(0.7), quick());
    let model = build(&|c| uneven(&scene, c, 0.03), &[], &options, &Silent).unwrap();
    check(&model, &options);
    let area = model.surface.area() / (4.0 * std::f64::consts::PI * 0.49);
    assert!((0.9..1.1).contains(&area), "{area}");
    let (off, missing) = hausdorff(&model.levels[0].mesh, &scene);
    assert!(off < 0.09 && missing < 0.09, "{off} {missing}");
    // Euler characteristic 2: one part, no handles.
    let s = &model.surface;
    assert_eq!(s.positions.len() as i64 - s.triangles.len() as i64 / 2, 2);
}

#[test]
fn an_interrupt_stops_it() {
    struct Stopped;
    impl Progress for Stopped {
        fn begin(&self, _: &'static str, _: u64) {}
        fn step(&self, _: u64) {}
        fn cancelled(&self) -> bool {
            true
        }
    }
    let scene = scenes::sphere(0.5);
    let error = build(&|c| scene.render(c), &[], &quick(), &Stopped).unwrap_err();
    assert_eq!(error.kind, crate::Kind::Cancelled);
}

/// Opaque round Gaussians.
fn dots(points: impl Iterator<Item = Vec3>, size: f32) -> Gaussians {
    let positions: Vec<Vec3> = points.collect();
    let n = positions.len();
    Gaussians {
        positions,
        log_scales: vec![Vec3::splat(size.ln()); n],
        rotations: vec![[1.0, 0.0, 0.0, 0.0]; n],
        logit_opacities: vec![6.0; n],
        sh: vec![[[0.2; 3]; 16]; n],
    }
}

fn drawn(g: &Gaussians) -> impl Fn(&Camera) -> View + Sync {
    let drawers = Drawers::with_surface(g, FIRM);
    move |camera| View::drawn(&drawers, camera, scenes::BACKGROUND)
}

#[test]
fn one_gaussian_is_a_ball() {
    let g = dots([Vec3::new(0.1, 0.0, -0.1)].into_iter(), 0.25);
    let options = quick();
    let model = build(&drawn(&g), &[], &options, &Silent).unwrap();
    check(&model, &options);
    let (lo, hi) = model.surface.bounds();
    let size = hi - lo;
    assert!(size.max_element() < 1.3 * size.min_element() && size.min_element() > 0.15, "{size}");
}

#[test]
fn a_plane_of_gaussians_is_a_thin_closed_sheet() {
    let grid = (0..41 * 31).map(|i| Vec3::new((i % 41) as f32 * 0.03 - 0.6, 0.0, (i / 41) as f32 * 0.03 - 0.45));
    let options = quick();
    let model = build(&drawn(&dots(grid, 0.02)), &[], &options, &Silent).unwrap();
    check(&model, &options);
    let (lo, hi) = model.surface.bounds();
    assert!(hi.x - lo.x > 1.1 && hi.z - lo.z > 0.8 && hi.y - lo.y < 0.2, "{lo} {hi}");
}

#[test]
fn a_hollow_shell_of_gaussians_has_no_inner_surface() {
    let shell = super::super::fibonacci_sphere(4000).into_iter().map(|d| 0.7 * d);
    let options = quick();
    let model = build(&drawn(&dots(shell, 0.03)), &[], &options, &Silent).unwrap();
    check(&model, &options);
    let solid = 4.0 / 3.0 * std::f64::consts::PI * 0.343;
    assert!(model.surface.volume() > 0.93 * solid, "{} of {solid}", model.surface.volume());
    assert!(model.surface.positions.iter().all(|p| p.length() > 0.55));
}

#[test]
fn two_parts_of_gaussians_stay_two() {
    let ball = |c: Vec3| super::super::fibonacci_sphere(1500).into_iter().map(move |d| c + 0.3 * d);
    let g = dots(ball(Vec3::new(-0.5, 0.0, 0.0)).chain(ball(Vec3::new(0.5, 0.0, 0.0))), 0.03);
    let options = quick();
    let model = build(&drawn(&g), &[], &options, &Silent).unwrap();
    check(&model, &options);
    let s = &model.surface;
    // Euler characteristic of two balls.
    assert_eq!(s.positions.len() as i64 - s.triangles.len() as i64 / 2, 4);
}

/// A layer of it stops a third of the light: half is stopped by its far side, or by what lies behind it.
#[test]
fn a_faint_part_is_there() {
    let ball = |c: Vec3| super::super::fibonacci_sphere(1500).into_iter().map(move |d| c + 0.3 * d);
    let mut g = dots(ball(Vec3::new(-0.5, 0.0, 0.0)).chain(ball(Vec3::new(0.5, 0.0, 0.0))), 0.03);
    g.logit_opacities[1500..].fill(-2.75);
    let options = quick();
    let model = build(&drawn(&g), &[], &options, &Silent).unwrap();
    check(&model, &options);
    let [solid, faint] = [-1.0f32, 1.0].map(|side| {
        let mut part = model.surface.clone();
        part.triangles.retain(|t| t.iter().all(|&i| model.surface.positions[i as usize].x * side > 0.0));
        part.volume()
    });
    let ball = 4.0 / 3.0 * std::f64::consts::PI * 0.3f64.powi(3);
    assert!(faint > 0.9 * ball && faint < 1.1 * solid, "{faint} of {ball}, {solid} where it is opaque");
}

#[test]
fn a_soft_rim_is_no_surface_and_what_is_faint_throughout_is_one() {
    let camera = crate::views::orbit(0.0, 10.0, crate::views::DISTANCE, 64);
    let one = |opacity: f32, size: f32| {
        let mut g = dots([Vec3::ZERO].into_iter(), size);
        g.logit_opacities[0] = (opacity / (1.0 - opacity)).ln();
        drawn(&g)(&camera)
    };
    let faint = |v: &View| -> Vec<usize> { (0..64 * 64).filter(|&i| (0.3..0.5).contains(&v.alpha[i])).collect() };
    let (sure, unsure) = (one(0.99, 0.12), one(0.45, 0.25));
    let rim = faint(&sure);
    assert!(rim.len() > 20 && rim.iter().all(|&i| !sure.solid(i)), "{} pixels", rim.len());
    assert!((0..64 * 64).filter(|&i| sure.alpha[i] > 0.51).all(|i| sure.solid(i)));
    let all = faint(&unsure);
    let met = all.iter().filter(|&&i| unsure.solid(i)).count();
    assert!(all.len() > 40 && met * 10 > 8 * all.len(), "{met} of {}", all.len());
}

/// As a CDB store takes them: the coarsest level has 128 vertices at most, each finer one four times as many.
#[test]
fn however_few_triangles_are_asked_for_the_coarsest_level_keeps_to_the_coarsest_cap() {
    let scene = scenes::car();
    for (triangles, levels) in [(64, 1), (250, 2), (1000, 3), (2000, 4)] {
        let vertex_caps = Options::sized(Some(triangles), 256).vertex_caps;
        let options = Options { triangles: Some(triangles), vertex_caps, ..quick() };
        let model = made(&scene, &options);
        assert_eq!(model.levels.len(), levels, "{triangles} triangles");
        assert!(model.levels[0].mesh.triangles.len() <= triangles);
        let counts = model.levels.iter().rev().map(|l| l.mesh.positions.len());
        for (i, count) in counts.enumerate() {
            assert!(count <= 128 << (2 * i), "{triangles} triangles: {count} vertices, {i} levels above the coarsest");
        }
    }
}

/// Minutes and gigabytes: `cargo test --release five_million -- --ignored`.
#[test]
#[ignore = "takes minutes"]
fn five_million_gaussians_make_a_model() {
    let shell = super::super::fibonacci_sphere(5_000_000).into_iter().map(|d| d * Vec3::new(0.9, 0.5, 0.4));
    let options = quick();
    let model = build(&drawn(&dots(shell, 0.002)), &[], &options, &Silent).unwrap();
    check(&model, &options);
}

#[test]
fn triangles_are_as_few_as_asked() {
    let scene = scenes::car();
    let options =
        Options { levels: 3, triangles: Some(900), vertex_caps: Options::sized(Some(900), 256).vertex_caps, ..quick() };
    let model = made(&scene, &options);
    check(&model, &options);
    let counts: Vec<usize> = model.levels.iter().map(|l| l.mesh.triangles.len()).collect();
    assert!(counts[0] <= 900 && counts[0] > 700 && counts.windows(2).all(|w| w[1] < w[0]), "{counts:?}");
    let error = build(&|c| scene.render(c), &[], &Options { triangles: Some(3), ..quick() }, &Silent).unwrap_err();
    assert!(error.subject.contains("triangles"), "{error}");
    assert_eq!(Options::sized(Some(40_000), 2048).vertex_caps[0], 30_000);
    assert_eq!(Options::sized(None, 2048).texture_size, [2048, 1024, 512, 256]);
}
