//! The GPU renderer against the CPU renderer. Without an adapter each test says so and passes; under
//! ORB_REQUIRE_CLIENTS=1 a missing adapter fails.

use std::sync::LazyLock;

use glam::Vec3;
use orb::splat::render::gpu::{Gpu, Renderer, Scene, sort_pairs};
use orb::splat::render::{Frame, normals, render, to_bytes};
use orb::splat::{Camera, Gaussians, SH_COEFFICIENTS};
use proptest::prelude::*;

/// One device for all tests: opening one takes longer than most of them.
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

/// SplitMix64: the same scenes on every machine.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.bits() >> 40) as f32 / (1u64 << 24) as f32
    }
    fn vector(&mut self, half: f32) -> Vec3 {
        Vec3::new(self.between(-half, half), self.between(-half, half), self.between(-half, half))
    }
}

/// Gaussians in a cube of half-side 1.5, standard deviations between e^low and e^high.
fn scene(n: usize, low: f32, high: f32, seed: u64) -> Gaussians {
    let r = &mut Random(seed);
    Gaussians {
        positions: (0..n).map(|_| r.vector(1.5)).collect(),
        log_scales: (0..n).map(|_| Vec3::splat((low + high) / 2.0) + r.vector((high - low) / 2.0)).collect(),
        rotations: (0..n).map(|_| std::array::from_fn(|_| r.between(-1.0, 1.0))).collect(),
        logit_opacities: (0..n).map(|_| r.between(-4.0, 5.0)).collect(),
        sh: (0..n)
            .map(|_| {
                std::array::from_fn::<_, SH_COEFFICIENTS, _>(|k| {
                    std::array::from_fn(|_| r.between(-1.0, 1.0) * if k == 0 { 1.5 } else { 0.2 })
                })
            })
            .collect(),
    }
}

fn camera(width: u32, height: u32, seed: u64) -> Camera {
    let r = &mut Random(seed ^ 0xca3e);
    let eye = Vec3::new(r.between(-1.0, 1.0), r.between(-1.0, 1.0), r.between(-0.5, 0.8)).normalize() * 4.0;
    Camera::look_at(eye, r.vector(0.3), 0.9, width).resized(width, height)
}

/// Every value within 1e-4 of the CPU's, but for the few pixels where rounding decides whether a contribution of about
/// 1/255 is drawn, or which Gaussian is the one in the middle.
fn compare(got: &Frame, want: &Frame, what: &str) {
    assert_eq!((got.width, got.height), (want.width, want.height), "{what}");
    let pixels = got.alpha.len();
    let (mut off, mut off_median) = (0, 0);
    for i in 0..pixels {
        let numbers = |f: &Frame| [f.color[i][0], f.color[i][1], f.color[i][2], f.alpha[i]];
        let mut worst = 0f32;
        for (a, b) in numbers(got).into_iter().zip(numbers(want)) {
            assert!(a.is_finite() && b.is_finite(), "{what}: pixel {i}: {a} {b}");
            worst = worst.max((a - b).abs() / b.abs().max(1.0));
        }
        // A skipped contribution: 1/255 of a colour, which the harmonics keep below about 4.
        assert!(worst < 0.02, "{what}: pixel ({}, {}) is {worst} off", i % got.width, i / got.width);
        let depth = (got.depth[i] - want.depth[i]).abs() / want.depth[i].max(1.0);
        off += usize::from(worst > 1e-4 || (depth > 1e-4 && want.alpha[i] > 0.02));
        off_median +=
            usize::from((got.median_depth[i] - want.median_depth[i]).abs() > 1e-4 * want.median_depth[i].max(1.0));
    }
    assert!(off * 2000 <= pixels, "{what}: {off} of {pixels} pixels are more than 1e-4 off");
    assert!(off_median * 500 <= pixels, "{what}: {off_median} of {pixels} median depths differ");
}

/// Unit vectors within 1e-3 where the pixel is not faint, but for the few where rounding decides which way one faces.
fn compare_normals(got: &[[f32; 3]], want: &[[f32; 3]], alpha: &[f32], what: &str) {
    let apart = |a: &[f32; 3], b: &[f32; 3]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(got.iter().flatten().all(|v| v.is_finite()), "{what}: normals");
    let off = got.iter().zip(want).zip(alpha).filter(|((a, b), alpha)| **alpha > 0.05 && apart(a, b) > 1e-3).count();
    assert!(off * 200 <= got.len(), "{what}: {off} of {} normals differ", got.len());
}

fn both(gpu: &Gpu, g: &Gaussians, camera: &Camera, background: [f32; 3], what: &str) -> Frame {
    let want = render(g, camera, background);
    let uploaded = Scene::upload(gpu, g).unwrap();
    let mut renderer = Renderer::new(gpu).unwrap();
    let got = renderer.render(&uploaded, camera, background).unwrap();
    compare(&got, &want, what);
    let want_normals = normals(g, camera);
    compare_normals(&renderer.normals(&uploaded, camera).unwrap(), &want_normals, &want.alpha, what);
    if renderer.subgroups {
        renderer.subgroups = false;
        compare(&renderer.render(&uploaded, camera, background).unwrap(), &want, &format!("{what}, no subgroups"));
    }
    got
}

#[test]
fn sort_is_stable_and_agrees_with_the_standard_library() {
    let Some(gpu) = gpu() else { return };
    let r = &mut Random(3);
    for (n, bits) in [
        (0, 32),
        (1, 8),
        (255, 13),
        (256, 1),
        (257, 32),
        (2047, 9),
        (2048, 16),
        (2049, 31),
        (4095, 9),
        (4096, 16),
        (4097, 31),
        (70_001, 32),
        (1_100_000, 13),
    ] {
        let mask = if bits == 32 { u32::MAX } else { (1 << bits) - 1 };
        let keys: Vec<u32> = (0..n).map(|_| r.bits() as u32 & mask).collect();
        let values: Vec<u32> = (0..n as u32).collect();
        let mut want: Vec<(u32, u32)> = keys.iter().copied().zip(values.iter().copied()).collect();
        want.sort_by_key(|p| p.0);
        let (k, v) = sort_pairs(gpu, &keys, &values, bits).unwrap();
        assert!(k.into_iter().zip(v).eq(want), "{n} keys of {bits} bits");
    }
}

#[test]
fn what_the_driver_offers_passes_its_self_test() {
    let Some(gpu) = gpu() else { return };
    assert!(gpu.notes.is_empty(), "{:?}", gpu.notes);
    assert!(gpu.abilities.swap_atomics);
    assert_eq!(gpu.abilities.subgroups, gpu.abilities.lanes > 1);
}

#[test]
fn pictures_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (i, (n, low, high, w, h)) in [
        (0, -3.0, -2.0, 40, 24),
        (1, -2.0, -1.0, 16, 16),
        (300, -4.0, -1.5, 130, 75),
        (3000, -5.0, -2.5, 200, 120),
        (20_000, -6.0, -4.0, 320, 320),
    ]
    .into_iter()
    .enumerate()
    {
        let seed = i as u64;
        let got =
            both(gpu, &scene(n, low, high, seed), &camera(w, h, seed), [0.2, 0.4, 0.9], &format!("{n} Gaussians"));
        if n >= 300 {
            let drawn = got.alpha.iter().filter(|a| **a > 0.5).count();
            assert!(drawn * 4 > got.alpha.len(), "{n} Gaussians cover {drawn} pixels: too few to compare");
        }
    }
}

#[test]
fn off_centre_principal_points_and_long_lenses() {
    let Some(gpu) = gpu() else { return };
    let g = scene(2000, -4.0, -2.0, 9);
    for (i, (cx, cy, f)) in [(-20.0, 10.0, 1.0), (150.0, 130.0, 0.6), (64.0, 300.0, 2.5)].into_iter().enumerate() {
        let mut c = camera(128, 96, i as u64);
        (c.cx, c.cy, c.fx, c.fy) = (cx, cy, c.fx * f, c.fy * f * 1.1);
        both(gpu, &g, &c, [0.0; 3], &format!("principal point ({cx}, {cy})"));
    }
}

#[test]
fn gaussians_around_and_behind_the_camera() {
    let Some(gpu) = gpu() else { return };
    let g = scene(3000, -4.0, -1.0, 4);
    let inside = Camera::look_at(Vec3::new(0.1, -0.2, 0.05), Vec3::new(1.0, 0.3, 0.2), 1.4, 160);
    both(gpu, &g, &inside, [0.1; 3], "camera inside");
    let away = Camera::look_at(Vec3::new(0.0, -5.0, 0.0), Vec3::new(0.0, -9.0, 0.0), 0.8, 64);
    let got = both(gpu, &g, &away, [0.3; 3], "all behind");
    assert!(got.alpha.iter().all(|a| *a == 0.0), "what is behind the camera is not drawn");
}

#[test]
fn huge_and_needle_thin_gaussians() {
    let Some(gpu) = gpu() else { return };
    let mut g = scene(400, -3.0, -2.0, 5);
    for i in 0..40 {
        g.log_scales[i] = Vec3::new(3.0 + i as f32 * 0.1, 2.0, 2.5);
        g.logit_opacities[i] = -2.0;
        // Longer needles, and a ten-thousandth of log₂ α is no longer in single precision: dx² / σ² cancels.
        g.log_scales[i + 40] = Vec3::new(-1.5, -9.0, -9.0);
        g.log_scales[i + 80] = Vec3::new(-12.0, -12.0, -12.0);
    }
    both(gpu, &g, &camera(300, 200, 5), [1.0; 3], "huge and thin");
}

#[test]
fn values_that_are_not_finite_are_left_out() {
    let Some(gpu) = gpu() else { return };
    let mut g = scene(600, -4.0, -2.0, 6);
    for (i, bad) in
        [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN_POSITIVE / 4.0].into_iter().enumerate()
    {
        let at = 10 * i;
        g.positions[at].y = bad;
        g.log_scales[at + 1].x = bad;
        g.rotations[at + 2][1] = bad;
        g.logit_opacities[at + 3] = bad;
        g.sh[at + 4][7][1] = bad;
        g.sh[at + 5][0][2] = bad;
        g.rotations[at + 6] = [0.0; 4];
        g.log_scales[at + 7] = Vec3::splat(bad);
    }
    both(gpu, &g, &camera(150, 100, 6), [0.5; 3], "not finite");
}

#[test]
fn small_bindings_and_short_lists_change_nothing() {
    let Some(gpu) = gpu() else { return };
    let (g, c) = (scene(6000, -4.5, -2.5, 7), camera(320, 240, 7));
    let want = render(&g, &c, [0.2; 3]);
    // 256 KiB a binding: chunks of 1,280 Gaussians, parts of 5,120.
    let small = Scene::upload_limited(gpu, &g, 256 << 10).unwrap();
    let whole = Scene::upload(gpu, &g).unwrap();
    let mut renderer = Renderer::new(gpu).unwrap();
    compare(&renderer.render(&small, &c, [0.2; 3]).unwrap(), &want, "small bindings");
    let one = renderer.render(&whole, &c, [0.2; 3]).unwrap();
    compare(&one, &want, "whole");
    let e = Scene::upload_limited(gpu, &g, 4096).err().unwrap();
    assert!(e.to_string().contains("6000 Gaussians"), "{e}");
    // Lists too short for the picture: cut into bands, again and again, until each fits.
    renderer.limit_pairs(9000);
    let cut = renderer.render(&whole, &c, [0.2; 3]).unwrap();
    assert_eq!(cut, one, "a picture in bands is the same picture");
    renderer.limit_pairs(10);
    let e = renderer.render(&whole, &c, [0.2; 3]).unwrap_err();
    assert!(e.to_string().contains("at most 10"), "{e}");
}

#[test]
fn overflow_is_reported_and_repaired() {
    let Some(gpu) = gpu() else { return };
    // 500 Gaussians over all 1,200 tiles: far beyond the first guess.
    let mut g = scene(500, 0.0, 0.5, 8);
    g.logit_opacities.fill(-3.0);
    let c = camera(640, 480, 8);
    let uploaded = Scene::upload(gpu, &g).unwrap();
    let mut renderer = Renderer::new(gpu).unwrap();
    renderer.draw(&uploaded, &c, [0.0; 3]).unwrap();
    let first = renderer.settle().unwrap();
    assert!(first.len() == 1 && !first[0].drawn && first[0].pairs > 66_536, "{first:?}");
    renderer.draw(&uploaded, &c, [0.0; 3]).unwrap();
    let second = renderer.settle().unwrap();
    assert!(second[0].drawn && second[0].pairs == first[0].pairs, "{second:?}");
    compare(&renderer.frame().unwrap(), &render(&g, &c, [0.0; 3]), "after overflow");
}

#[test]
fn same_bytes_every_time() {
    let Some(gpu) = gpu() else { return };
    let mut g = scene(5000, -4.0, -2.0, 11);
    // Equal depths: only the order of the input may decide.
    for p in &mut g.positions[..2500] {
        p.x = 0.25;
    }
    let c = Camera::look_at(Vec3::new(-4.0, 0.0, 0.0), Vec3::ZERO, 0.8, 200);
    let uploaded = Scene::upload(gpu, &g).unwrap();
    let first = Renderer::new(gpu).unwrap().render(&uploaded, &c, [0.0; 3]).unwrap();
    for _ in 0..3 {
        assert_eq!(first, Renderer::new(gpu).unwrap().render(&uploaded, &c, [0.0; 3]).unwrap());
    }
}

/// Some of the Gaussians not finite, some behind the camera, one over all of the picture.
/// A quarter of what is read back: the same bytes as the CPU makes of the floats, for sizes that fill no workgroup and after
/// larger and smaller pictures.
#[test]
fn bytes_are_those_of_the_floats() {
    let Some(gpu) = gpu() else { return };
    let g = scene(3000, -4.0, -1.5, 91);
    let uploaded = Scene::upload(gpu, &g).unwrap();
    let mut renderer = Renderer::new(gpu).unwrap();
    for (i, (width, height)) in [(200, 150), (17, 5), (333, 77), (1, 1)].into_iter().enumerate() {
        let camera = camera(width, height, 70 + i as u64);
        let bytes = renderer.render_bytes(&uploaded, &camera).unwrap();
        let frame = renderer.render(&uploaded, &camera, [0.0; 3]).unwrap();
        assert_eq!(bytes, to_bytes(&frame.color, &frame.alpha), "{width} × {height}");
        assert!(width < 100 || bytes.iter().any(|b| b[3] == 255) && bytes.iter().any(|b| (1..255).contains(&b[3])));
    }
    // Every value that decides, and beyond the ends.
    let at = |v: f32| to_bytes(&[[v; 3]], &[v])[0];
    for k in 0..256u32 {
        let edge = k as f32 / 256.0;
        assert_eq!((at(edge)[0], at(f32::next_down(edge))[0]), (k as u8, k.saturating_sub(1) as u8));
    }
    assert_eq!((at(1.0), at(1.5), at(-0.5)), ([255; 4], [255; 4], [0; 4]));
}

fn with_oddities(mut g: Gaussians, camera: &Camera, seed: u64) -> Gaussians {
    let r = &mut Random(seed ^ 0x0dd);
    if g.is_empty() {
        return g;
    }
    let behind = camera.position() - camera.rotation.row(2);
    for _ in 0..g.len().div_ceil(20) {
        let i = r.bits() as usize % g.len();
        let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, 1e-42][r.bits() as usize % 5];
        match r.bits() % 7 {
            0 => g.positions[i][(seed % 3) as usize] = bad,
            1 => g.log_scales[i][(seed % 3) as usize] = bad,
            2 => g.rotations[i][(seed % 4) as usize] = bad,
            3 => g.logit_opacities[i] = bad,
            4 => g.sh[i][(seed % 16) as usize][1] = bad,
            5 => g.rotations[i] = [0.0; 4],
            _ => g.positions[i] = behind + r.vector(0.2),
        }
    }
    let huge = r.bits() as usize % g.len();
    g.log_scales[huge] = Vec3::new(3.0, 2.5, 2.0);
    g.logit_opacities[huge] = -2.0;
    g
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, failure_persistence: None, ..Default::default() })]
    #[test]
    fn any_scene_matches(
        seed: u64, n in 0usize..2000, low in -7.0f32..-2.0, spread in 0.1f32..3.0, w in 1u32..150, h in 1u32..150,
        right in -0.8f32..0.8, down in -0.8f32..0.8, odd: bool,
    ) {
        if let Some(gpu) = gpu() {
            let mut c = camera(w, h, seed);
            c.cx += right * w as f32;
            c.cy += down * h as f32;
            let g = scene(n, low, low + spread, seed);
            let g = if odd { with_oddities(g, &c, seed) } else { g };
            both(gpu, &g, &c, [0.3, 0.1, 0.0], &format!("seed {seed}"));
        }
    }
}
