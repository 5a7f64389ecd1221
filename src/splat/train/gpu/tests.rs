//! The GPU's gradients against the CPU's and against finite differences in f64.
//! Without an adapter each test says so and passes; under ORB_REQUIRE_CLIENTS=1 a missing adapter fails.

mod runs;

use std::sync::LazyLock;

use glam::Vec3;

use super::iteration::{Gradients, Picture};
use super::run::Run;
use super::table;
use crate::progress::Silent;
use crate::splat::packed::{Core, Packed, Sh};
use crate::splat::render::Shown;
use crate::splat::render::gpu::kernel::read;
use crate::splat::render::gpu::{Gpu, STAGES};
use crate::splat::render::projection::{View, backward};
use crate::splat::render::reference::{self, Pose, parameters};
use crate::splat::render::tests::{camera, scene};
use crate::splat::render::{self, Raster, render};
use crate::splat::train::exposure::{Change, Exposure};
use crate::splat::train::loss::{Loss, Terms, Wanted};
use crate::splat::train::random::Random;
use crate::splat::train::{Behind, Checkpoint, Density, Engine, Options, Target, train};
use crate::splat::{Camera, Gaussians};

fn gpu() -> Option<&'static Gpu> {
    static GPU: LazyLock<Option<Gpu>> = LazyLock::new(|| match Gpu::open(true, None) {
        Ok(gpu) => Some(gpu),
        Err(e) if std::env::var_os("ORB_REQUIRE_CLIENTS").is_some_and(|v| v == "1") => panic!("{e}"),
        Err(e) => {
            eprintln!("skipped: {e}");
            None
        }
    });
    GPU.as_ref()
}

#[derive(Debug)]
struct All {
    core: Vec<Core>,
    sh: Vec<Sh>,
    pose: [f32; 6],
    /// Σ|x − y| and Σ(1 − SSIM).
    sums: [f32; 2],
    exposure: Change,
}

/// An exposure that is not none, where the target has one.
fn begun(target: &Target) -> Exposure {
    let mut e = Exposure::default();
    if target.fit_exposure {
        e.change = [[1.2, 0.05, -0.1, 0.03], [0.02, 0.8, 0.0, -0.05], [-0.04, 0.1, 1.1, 0.02]];
    }
    e
}

/// One forward and backward pass. `pulls`: the loss's gradient at every pixel in place of the loss's own.
fn on_gpu(
    gpu: &Gpu,
    g: &Gaussians,
    target: &Target,
    options: &Options,
    pixels: u32,
    pulls: Option<&[[f32; 4]]>,
) -> All {
    let targets = std::slice::from_ref(target);
    let mut at = Checkpoint::new(g, targets).unwrap();
    at.exposures[0] = begun(target);
    let n = g.len() as u64;
    let out = Gradients {
        core: gpu.buffer("core", 48 * (n + 32_768)),
        harmonics: gpu.buffer("sh", 192 * (n + 32_768)),
        mean: gpu.buffer("mean", 8 * (n + 32_768)),
    };
    let pictures = targets.iter().map(|t| Picture::upload(gpu, t)).collect();
    let steps = table::steps(targets, options);
    let run = Run::with(gpu, &at, pictures, steps, table::corrections(1), options, pixels, Some(&out)).unwrap();
    let (i, picture, numbers) = (&run.iteration, &run.fixed.pictures[0], &run.steps[0]);
    let last = STAGES.len() + 1;
    let stages = |list: &[usize], first: bool| {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            if first {
                i.begin(&mut pass);
            }
            for s in list {
                i.stage(*s, &mut pass, 0, picture, numbers);
            }
        }
        gpu.queue.submit([encoder.finish()]);
    };
    let all: Vec<usize> = (0..last).collect();
    stages(&all, true);
    if let Some(p) = pulls {
        gpu.queue.write_buffer(&i.pulls, 0, bytemuck::cast_slice(p));
    }
    stages(&[last, last + 1], false);
    gpu.check().unwrap();
    let counts: Vec<u32> = bytemuck::pod_collect_to_vec(&read(gpu, &i.plan.counts, 32).unwrap());
    assert_eq!(counts[5], 0, "lists too short for a test");
    let vectors = |b: &wgpu::Buffer, planes: usize| -> Vec<[f32; 4]> {
        bytemuck::pod_collect_to_vec(&read(gpu, b, planes as u64 * run.model.capacity as u64 * 16).unwrap())
    };
    let stride = run.model.capacity as usize;
    let (core, sh) = (vectors(&out.core, 3), vectors(&out.harmonics, 12));
    let groups = run.model.capacity.div_ceil(256) as usize;
    let partials: Vec<[f32; 4]> =
        bytemuck::pod_collect_to_vec(&read(gpu, &i.pose_partials, groups as u64 * 32).unwrap());
    let tiles = picture.width.div_ceil(16) * picture.height.div_ceil(16);
    let sums: Vec<[f32; 2]> = bytemuck::pod_collect_to_vec(&read(gpu, &i.sums, 8 * u64::from(tiles)).unwrap());
    let changes: Vec<[f32; 4]> =
        bytemuck::pod_collect_to_vec(&read(gpu, &i.tile_changes, 48 * u64::from(tiles)).unwrap());
    let used = g.len().div_ceil(256);
    All {
        core: (0..g.len())
            .map(|i| std::array::from_fn(|k| if k < 11 { core[k / 4 * stride + i][k % 4] } else { 0.0 }))
            .collect(),
        sh: (0..g.len())
            .map(|i| {
                std::array::from_fn(|k| {
                    let f = 3 * (k % 16) + k / 16;
                    sh[f / 4 * stride + i][f % 4]
                })
            })
            .collect(),
        pose: std::array::from_fn(|k| (0..used).map(|w| partials[2 * w + k / 3][k % 3]).sum()),
        sums: std::array::from_fn(|k| sums.iter().map(|s| s[k]).sum()),
        exposure: std::array::from_fn(|i| {
            std::array::from_fn(|k| changes.iter().skip(i).step_by(3).map(|c| c[k]).sum())
        }),
    }
}

/// The same on the CPU, and the loss.
fn on_cpu(g: &Gaussians, target: &Target, options: &Options) -> (All, f64) {
    let packed = Packed::pack(g);
    let view = View { shown: target.shown, ..View::new(&target.camera) };
    let degree = options.degree(0);
    let (w, h) = (target.camera.width as usize, target.camera.height as usize);
    let mut raster = Raster::default();
    raster.bins.build(&packed, &view, degree);
    raster.forward(&view, None);
    let wanted = Wanted::new(w, h, &target.color, &target.alpha, target.held_back.as_deref())
        .weighed(target.confidence.as_deref());
    let mut loss = Loss::new(w, h);
    let exposure = begun(target).change;
    let terms = Terms {
        background: options.behind(target, 0),
        lambda: options.lambda_dssim,
        exposure: target.fit_exposure.then_some(&exposure),
    };
    let value = loss.evaluate(&raster.tiles, |_| true, &wanted, terms);
    raster.backward(&loss.tiles);
    let mut all = All { core: Vec::new(), sh: Vec::new(), pose: [0.0; 6], sums: [0.0; 2], exposure: loss.exposure };
    for i in 0..g.len() {
        let gradient =
            raster.gradient_of(i).and_then(|up| backward(&packed.core[i], &packed.sh[i], &view, degree, &up));
        let finite = gradient.filter(|g| g.core.iter().sum::<f32>().is_finite());
        match finite {
            None => {
                all.core.push([0.0; 16]);
                all.sh.push([0.0; 48]);
            }
            Some(g) => {
                all.core.push(g.core);
                all.sh.push(g.sh);
                for k in 0..6 {
                    all.pose[k] += g.pose[k];
                }
            }
        }
    }
    (all, value)
}

/// Equal to within 0.2 % of the largest of their kind, but for the few that stand where rounding decides whether a
/// contribution of 1/255 is drawn.
fn same(got: &All, want: &All, what: &str) {
    let kinds = [(0, 3, "position"), (3, 4, "opacity"), (4, 8, "rotation"), (8, 11, "scale")];
    let n = want.core.len();
    for (first, end, name) in kinds {
        let largest = want.core.iter().flat_map(|c| &c[first..end]).fold(0f32, |a, b| a.max(b.abs()));
        let off = |i: usize| !(first..end).all(|k| (got.core[i][k] - want.core[i][k]).abs() <= 2e-3 * largest + 1e-9);
        let bad: Vec<usize> = (0..n).filter(|i| off(*i)).collect();
        assert!(bad.len() * 100 <= n, "{what}: {name} of {bad:?}: {:?} {:?}", got.core[bad[0]], want.core[bad[0]]);
        assert!(largest > 0.0 || n < 3, "{what}: no {name}");
    }
    let largest = want.sh.iter().flatten().fold(0f32, |a, b| a.max(b.abs()));
    let bad: Vec<usize> =
        (0..n).filter(|i| !(0..48).all(|k| (got.sh[*i][k] - want.sh[*i][k]).abs() <= 2e-3 * largest + 1e-9)).collect();
    assert!(bad.len() * 100 <= n, "{what}: harmonics of {bad:?}");
    let pose = want.pose.iter().fold(0f32, |a, b| a.max(b.abs()));
    for k in 0..6 {
        assert!(
            (got.pose[k] - want.pose[k]).abs() <= 5e-3 * pose + 1e-7,
            "{what}: pose {:?} {:?}",
            got.pose,
            want.pose
        );
    }
}

/// A target unlike the scene, partly transparent, partly held back.
fn target(camera: Camera, seed: u64) -> Target {
    let n = (camera.width * camera.height) as usize;
    let other = render(&scene(60, 0.15, seed + 77), &camera, [0.0; 3]);
    Target {
        camera,
        color: other.color.iter().zip(&other.alpha).map(|(c, a)| c.map(|v| v / a.max(1e-2))).collect(),
        alpha: other.alpha,
        weight: 1.0,
        refine_pose: Some(0.0),
        fit_exposure: false,
        held_back: Some((0..n).map(|i| i % 97 < 5).collect()),
        confidence: None,
        shown: Shown::Color,
        name: "test".into(),
    }
}

fn options(degree: usize, behind: Behind) -> Options {
    Options { iterations: 1, first_degree: degree, pose_from: 0, behind, ..Options::default() }
}

#[test]
fn gradients_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (seed, n, size, w, h) in
        [(1, 300, 0.06, 93, 70), (2, 40, 0.3, 64, 64), (3, 3000, 0.015, 150, 100), (4, 1, 0.3, 17, 5)]
    {
        let g = scene(n, size, seed);
        let t = target(camera(w, h), seed);
        let o = Options { seed, ..options(if seed == 2 { 1 } else { 3 }, Behind::Changing) };
        let (want, value) = on_cpu(&g, &t, &o);
        for pixels in [0, 1, 2, 4] {
            let got = on_gpu(gpu, &g, &t, &o, pixels, None);
            same(&got, &want, &format!("scene {seed}, {pixels} pixels a thread"));
            let loss = (0.8 * got.sums[0] + 0.2 * got.sums[1]) as f64 / (3 * w * h) as f64;
            assert!((loss - value).abs() < 1e-4 * value + 1e-6, "loss {loss} {value}");
        }
    }
}

#[test]
fn gradients_of_any_scene_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for seed in 0..10 {
        let mut r = Random::new(900 + seed);
        let mut between = |low: f32, high: f32| low + (high - low) * r.uniform();
        let (n, size) = (between(100.0, 500.0) as usize, between(0.02, 0.3));
        let (w, h) = (between(2.0, 120.0) as u32, between(2.0, 120.0) as u32);
        let mut c = camera(w, h);
        c.cx += between(-0.5, 0.5) * w as f32;
        c.cy += between(-0.5, 0.5) * h as f32;
        let mut g = scene(n, size, seed);
        g.positions[n / 2].y = f32::NAN;
        g.log_scales[n / 3].x = f32::INFINITY;
        g.positions[n / 4] = c.position() - c.rotation.row(2);
        (g.log_scales[n / 5], g.logit_opacities[n / 5]) = (Vec3::splat(1.5), -2.0);
        let t = target(c, seed);
        let o = options(3, Behind::Changing);
        let (want, _) = on_cpu(&g, &t, &o);
        let pixels = [0, 1, 2, 4][seed as usize % 4];
        same(&on_gpu(gpu, &g, &t, &o, pixels, None), &want, &format!("seed {seed}, {w} × {h}, {n} Gaussians"));
    }
}

#[test]
fn gradients_of_normals_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (seed, n, size, w, h) in [(1, 300, 0.06, 93, 70), (2, 120, 0.2, 64, 64)] {
        let g = scene(n, size, seed);
        let c = camera(w, h);
        let other = scene(60, 0.15, seed + 77);
        let t = Target { shown: Shown::Normals, color: render::normals(&other, &c), ..target(c, seed) };
        let o = options(3, Behind::Changing);
        let (want, value) = on_cpu(&g, &t, &o);
        assert!(want.sh.iter().flatten().all(|v| *v == 0.0));
        for pixels in [0, 1, 2, 4] {
            let got = on_gpu(gpu, &g, &t, &o, pixels, None);
            same(&got, &want, &format!("normals {seed}, {pixels} pixels a thread"));
            let loss = (0.8 * got.sums[0] + 0.2 * got.sums[1]) as f64 / (3 * w * h) as f64;
            assert!((loss - value).abs() < 1e-4 * value + 1e-6, "loss {loss} {value}");
        }
    }
}

/// Discs over a ball of radius 0.8.
fn ball(tilt: f32) -> Gaussians {
    let mut r = Random::new(5);
    let mut g = Gaussians::default();
    for _ in 0..500 {
        let out = Vec3::new(r.normal(), r.normal(), r.normal()).normalize();
        let aside = Vec3::new(r.normal(), r.normal(), r.normal()) * tilt;
        let q = glam::Quat::from_rotation_arc(Vec3::Z, (out + aside).normalize());
        g.positions.push(0.8 * out);
        g.log_scales.push(Vec3::new(0.08f32.ln(), 0.08f32.ln(), 0.02f32.ln()));
        g.rotations.push([q.w, q.x, q.y, q.z]);
        g.logit_opacities.push(3.0);
        g.sh.push(std::array::from_fn(|k| if k == 0 { [0.4, 0.1, -0.2] } else { [0.0; 3] }));
    }
    g
}

#[test]
fn pictures_of_normals_turn_the_surface() {
    let Some(gpu) = gpu() else { return };
    let (truth, start) = (ball(0.0), ball(0.5));
    let view = |a: f32| Camera::look_at(Vec3::new(3.0 * a.cos(), 3.0 * a.sin(), 0.8), Vec3::ZERO, 0.7, 48);
    let targets: Vec<Target> = (0..10)
        .map(|i| {
            let camera = view(i as f32 % 5.0 / 5.0 * std::f32::consts::TAU);
            let frame = render(&truth, &camera, [0.0; 3]);
            let shown = if i < 5 { Shown::Color } else { Shown::Normals };
            let color = match shown {
                Shown::Color => frame.color.iter().zip(&frame.alpha).map(|(c, a)| c.map(|v| v / a.max(1e-3))).collect(),
                Shown::Normals => render::normals(&truth, &camera),
            };
            Target {
                camera,
                color,
                alpha: frame.alpha,
                shown,
                held_back: None,
                confidence: None,
                refine_pose: None,
                fit_exposure: false,
                ..target(camera, 1)
            }
        })
        .collect();
    let scaled = Options::scaled(150);
    let o = Options { density: Density { until: 0, ..scaled.density }, ..scaled };
    // Mean angle to the truth from where no picture was taken, radians.
    let off = |g: &Gaussians| {
        let camera = view(0.6);
        let (a, b) = (render::normals(g, &camera), render::normals(&truth, &camera));
        let angles = a.iter().zip(&b).filter(|(_, b)| **b != [0.0; 3]);
        let angles: Vec<f32> =
            angles.map(|(a, b)| Vec3::from(*a).dot(Vec3::from(*b)).clamp(-1.0, 1.0).acos()).collect();
        angles.iter().sum::<f32>() / angles.len() as f32
    };
    for engine in [Engine::Cpu, Engine::Gpu(gpu)] {
        let run = |targets: &[Target]| train(engine, start.clone(), targets, &o, &Silent).unwrap();
        let (with, without) = (run(&targets), run(&targets[..5]));
        let (a, b) = (off(&with.gaussians), off(&without.gaussians));
        assert!(a < 0.6 * b && a < 0.3 * off(&start), "{a} with normals, {b} without, {} before", off(&start));
        let normals = &with.report.targets[7];
        assert!(normals.after.picture > normals.before.picture + 3.0, "{normals:?}");
    }
}

#[test]
fn gradients_under_an_exposure_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (seed, w, h) in [(1, 93, 70), (2, 64, 64), (3, 17, 5)] {
        let g = scene(200, 0.08, seed);
        let t = Target { fit_exposure: true, ..target(camera(w, h), seed) };
        let o = options(3, if seed == 2 { Behind::Fixed([0.2, 0.5, 0.9]) } else { Behind::Changing });
        let (want, value) = on_cpu(&g, &t, &o);
        let got = on_gpu(gpu, &g, &t, &o, 2, None);
        same(&got, &want, &format!("exposure {seed}"));
        let loss = (0.8 * got.sums[0] + 0.2 * got.sums[1]) as f64 / (3 * w * h) as f64;
        assert!((loss - value).abs() < 1e-4 * value + 1e-6, "loss {loss} {value}");
        let largest = want.exposure.as_flattened().iter().fold(0f32, |a, b| a.max(b.abs()));
        for (a, b) in got.exposure.as_flattened().iter().zip(want.exposure.as_flattened()) {
            assert!((a - b).abs() < 2e-3 * largest, "{:?} {:?}", got.exposure, want.exposure);
        }
        assert!(largest > 1e-3, "{largest}");
    }
}

#[test]
fn gradients_with_a_weight_a_pixel_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (seed, w, h) in [(1, 93, 70), (2, 64, 64), (3, 17, 5)] {
        let g = scene(200, 0.08, seed);
        let mut r = Random::new(seed);
        let weights = (0..w * h).map(|i| if i % 5 == 0 { 0.0 } else { 2.0 * r.uniform() }).collect();
        let plain = target(camera(w, h), seed);
        let t = Target { confidence: Some(weights), ..plain.clone() };
        let o = options(3, Behind::Changing);
        let (want, value) = on_cpu(&g, &t, &o);
        let got = on_gpu(gpu, &g, &t, &o, 2, None);
        same(&got, &want, &format!("weights {seed}"));
        let loss = (0.8 * got.sums[0] + 0.2 * got.sums[1]) as f64 / (3 * w * h) as f64;
        assert!((loss - value).abs() < 1e-4 * value + 1e-6, "loss {loss} {value}");
        assert!((value - on_cpu(&g, &plain, &o).1).abs() > 1e-3 * value, "weights change nothing");
    }
}

#[test]
fn degrees_of_harmonics_grow() {
    let Some(gpu) = gpu() else { return };
    let g = scene(100, 0.1, 12);
    let t = target(camera(48, 40), 5);
    for degree in 0..4 {
        let o = options(degree, Behind::Fixed([0.3, 0.9, 0.1]));
        let (want, _) = on_cpu(&g, &t, &o);
        same(&on_gpu(gpu, &g, &t, &o, 2, None), &want, &format!("degree {degree}"));
    }
}

#[test]
fn gaussians_behind_huge_and_not_finite_get_no_gradient() {
    let Some(gpu) = gpu() else { return };
    let mut g = scene(200, 0.08, 6);
    g.positions[0] = Vec3::new(4.0, -8.0, 3.0); // behind
    g.positions[1].x = f32::NAN;
    g.positions[2].y = f32::INFINITY;
    g.log_scales[3].z = f32::NAN;
    g.log_scales[4] = Vec3::splat(90.0);
    g.rotations[5] = [0.0; 4];
    g.rotations[6][2] = f32::INFINITY;
    g.logit_opacities[7] = f32::NAN;
    g.sh[8][3][1] = f32::NAN;
    g.log_scales[9] = Vec3::splat(2.0); // over every tile
    g.log_scales[10] = Vec3::new(1.0, -6.0, -6.0);
    g.logit_opacities[9] = -2.0;
    let t = target(camera(200, 150), 6);
    let o = options(3, Behind::Changing);
    let (want, _) = on_cpu(&g, &t, &o);
    for pixels in [0, 2] {
        let got = on_gpu(gpu, &g, &t, &o, pixels, None);
        same(&got, &want, "odd Gaussians");
        for i in 0..9 {
            assert!(got.core[i].iter().chain(&got.sh[i]).all(|v| *v == 0.0), "{i}: {:?}", got.core[i]);
        }
    }
}

#[test]
fn gradients_match_finite_differences() {
    let Some(gpu) = gpu() else { return };
    for seed in 0..3 {
        let camera = camera(35, 28);
        let mut g = scene(9, 0.2, 100 + seed);
        g.logit_opacities[0] = 7.0; // saturates at its centre
        g.positions[1] = Vec3::new(-0.9, -0.6, 0.7); // near the edge or outside: the Jacobian's clamp
        g.log_scales[1] = Vec3::splat(-0.3);
        g.sh[2][0] = [-1.9, 0.3, -1.6]; // under the colour clamp
        let mut r = Random::new(seed);
        // The loss: fixed random weights on colour and final transmittance.
        let weights: Vec<[f32; 4]> = (0..35 * 28).map(|_| std::array::from_fn(|_| r.uniform() - 0.3)).collect();
        let mut t = target(camera, seed);
        t.held_back = None;
        let got = on_gpu(gpu, &g, &t, &options(3, Behind::Fixed([0.0; 3])), 2, Some(&weights));
        let base = parameters(&g);
        let value = |p: &[reference::Parameters], by: [f64; 6]| -> f64 {
            let pixels = reference::render(p, &camera, &Pose::new(&camera, by));
            let one = |(p, v): (&reference::Pixel, &[f32; 4])| {
                (0..3).map(|c| p.color[c] * v[c] as f64).sum::<f64>() + p.transmittance * v[3] as f64
            };
            pixels.iter().zip(&weights).map(one).sum()
        };
        let eps = 1e-8;
        let close = |got: f32, expected: f64, what: String| {
            let allowed = 0.01 * expected.abs() + 2e-3;
            assert!(
                (got as f64 - expected).abs() < allowed,
                "scene {seed}, {what}: {got}, differences give {expected}"
            );
        };
        for i in 0..g.len() {
            for k in 0..59 {
                let (mut a, mut b) = (base.clone(), base.clone());
                a[i][k] += eps;
                b[i][k] -= eps;
                let expected = (value(&a, [0.0; 6]) - value(&b, [0.0; 6])) / (2.0 * eps);
                let got = if k < 11 { got.core[i][k] } else { got.sh[i][k - 11] };
                close(got, expected, format!("Gaussian {i} parameter {k}"));
            }
        }
        for k in 0..6 {
            let mut by = [0.0; 6];
            by[k] = eps;
            let up = value(&base, by);
            by[k] = -eps;
            close(got.pose[k], (up - value(&base, by)) / (2.0 * eps), format!("pose {k}"));
        }
    }
}
