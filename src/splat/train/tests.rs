use std::time::{Duration, Instant};

use glam::Vec3;

use super::*;
use crate::progress::Silent;
use crate::splat::packed::Packed;
use crate::splat::render;
use crate::splat::render::tests::scene;

/// A ring of views of `g`, `size` pixels across.
fn views(g: &Gaussians, count: usize, size: u32) -> Vec<Target> {
    (0..count)
        .map(|i| {
            let a = i as f32 / count as f32 * std::f32::consts::TAU;
            let camera = Camera::look_at(Vec3::new(3.0 * a.cos(), 3.0 * a.sin(), 0.8), Vec3::ZERO, 0.7, size);
            let frame = render(g, &camera, [0.0; 3]);
            Target {
                camera,
                color: frame.color.iter().zip(&frame.alpha).map(|(c, a)| c.map(|v| v / a.max(1e-3))).collect(),
                alpha: frame.alpha,
                weight: 1.0,
                refine_pose: None,
                fit_exposure: false,
                held_back: None,
                confidence: None,
                shown: Shown::Color,
                name: format!("view {i}"),
            }
        })
        .collect()
}

/// The scene, its views, and a disturbed copy to start from.
fn problem() -> (Vec<Target>, Gaussians) {
    let truth = scene(150, 0.12, 1);
    let targets = views(&truth, 5, 48);
    (targets, disturbed(truth))
}

/// What training starts from where the truth is known.
pub(super) fn disturbed(mut g: Gaussians) -> Gaussians {
    let mut r = random::Random::new(8);
    for i in 0..g.len() {
        g.positions[i] += Vec3::new(r.normal(), r.normal(), r.normal()) * 0.03;
        g.log_scales[i] += Vec3::splat(0.2 * r.normal());
        g.sh[i][0] = g.sh[i][0].map(|c| 0.5 * c + 0.2 * r.normal());
        g.logit_opacities[i] += 0.5 * r.normal();
    }
    g
}

/// The paper's step sizes and no growth: what a toy scene of true Gaussians needs.
fn gentle(iterations: usize) -> Options {
    let scaled = Options::scaled(iterations);
    let density = Density { until: 0, ..scaled.density };
    Options { rates: Options::default().rates, density, pose_from: 0, ..scaled }
}

#[test]
fn training_raises_quality_also_where_it_was_not_trained() {
    let (mut targets, start) = problem();
    targets[4].weight = 0.0;
    let mut held = vec![false; 48 * 48];
    held[20 * 48..24 * 48].fill(true);
    targets[0].held_back = Some(held);
    let options = gentle(160);
    let trained = train(Engine::Cpu, start, &targets, &options, &Silent).unwrap();
    let r = &trained.report;
    assert_eq!(r.iterations, 160);
    for t in &r.targets[..4] {
        assert!(t.after.picture > t.before.picture + 6.0, "{t:?}");
    }
    assert!(r.targets[0].after.held_back.unwrap() > r.targets[0].before.held_back.unwrap() + 2.0, "{:?}", r.targets[0]);
    assert_eq!(r.targets[4].turns, 0);
    assert!(r.targets[4].after.picture > r.targets[4].before.picture + 2.0, "{:?}", r.targets[4]);
}

#[test]
fn a_wrong_pose_is_found_again() {
    let truth = scene(150, 0.12, 1);
    let mut targets = views(&truth, 3, 48);
    let right = targets[0].camera;
    let wrong = pose::moved(&right, [0.03, -0.02, 0.0, 0.004, 0.0, 0.02], 0.0);
    targets[0].camera = wrong;
    targets[0].refine_pose = Some(0.0);
    let mut options = gentle(150);
    options.rates.pose = 1e-3;
    let trained = train(Engine::Cpu, truth, &targets, &options, &Silent).unwrap();
    let apart = |c: &Camera| (c.position() - right.position()).length();
    assert!(apart(&trained.cameras[0]) < 0.6 * apart(&wrong), "{} {}", apart(&trained.cameras[0]), apart(&wrong));
    assert_eq!(trained.cameras[1], targets[1].camera);
}

#[test]
fn same_seed_same_bytes_whatever_the_threads() {
    let (targets, start) = problem();
    let mut options = Options { pose_from: 3, ..Options::scaled(40) };
    options.density = Density { every: 8, from: 8, until: 40, gradient: 1e-6, growth: 0.3, ..options.density };
    let run = |threads, seed| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let options = Options { seed, ..options };
        pool.install(|| train(Engine::Cpu, start.clone(), &targets, &options, &Silent).unwrap())
    };
    let (a, b, c, other) = (run(1, 7), run(2, 7), run(2, 7), run(2, 8));
    assert!(a.report.gaussians_after > a.report.gaussians_before);
    assert_eq!(a.gaussians, b.gaussians);
    assert_eq!(b.gaussians, c.gaussians);
    assert_eq!(a.cameras, b.cameras);
    assert_ne!(a.gaussians, other.gaussians);
}

#[test]
fn held_back_pixels_are_never_looked_at() {
    let (mut targets, start) = problem();
    let held: Vec<bool> = (0..48 * 48).map(|i| i % 48 > 24).collect();
    targets[0].held_back = Some(held.clone());
    let options = Options::scaled(20);
    let a = train(Engine::Cpu, start.clone(), &targets, &options, &Silent).unwrap();
    for (i, h) in held.iter().enumerate() {
        if *h {
            targets[0].color[i] = [1.0, 0.0, 0.3];
            targets[0].alpha[i] = 0.7;
        }
    }
    let b = train(Engine::Cpu, start, &targets, &options, &Silent).unwrap();
    assert_eq!(a.gaussians, b.gaussians);
}

#[test]
fn a_pixel_that_counts_less_is_met_less() {
    // Two pictures that contradict each other from the same place: who counts more is heard, pixel by pixel.
    let (targets, start) = problem();
    let mut red = targets[0].clone();
    red.color.fill([1.0, 0.0, 0.0]);
    let left = |i: usize| i % 48 < 24;
    let weights = |own: f32| (0..48 * 48).map(|i| if left(i) { own } else { 2.0 - own }).collect();
    let mut pair = [targets[0].clone(), red];
    pair[0].confidence = Some(weights(1.8));
    pair[1].confidence = Some(weights(0.2));
    let mut options = gentle(120);
    options.rates.color = 0.05;
    let g = train(Engine::Cpu, start, &pair, &options, &Silent).unwrap().gaussians;
    let seen = render(&g, &pair[0].camera, [0.0; 3]);
    let off = |t: &Target, of_left: bool| -> f32 {
        let pixels = (0..48 * 48).filter(|i| left(*i) == of_left && t.alpha[*i] > 0.5);
        pixels.map(|i| (seen.color[i][1] - t.alpha[i] * t.color[i][1]).abs()).sum()
    };
    assert!(off(&pair[0], true) < 0.7 * off(&pair[1], true), "{} {}", off(&pair[0], true), off(&pair[1], true));
    assert!(off(&pair[1], false) < 0.7 * off(&pair[0], false), "{} {}", off(&pair[1], false), off(&pair[0], false));
}

#[test]
fn deadline_interrupt_and_wrong_sizes() {
    let (mut targets, start) = problem();
    let options = Options { deadline: Some(Instant::now() - Duration::from_millis(1)), ..Options::scaled(50) };
    let late = train(Engine::Cpu, start.clone(), &targets, &options, &Silent).unwrap();
    assert!(late.report.stopped_by_deadline && late.report.iterations == 0);
    assert_eq!(late.gaussians, start);

    struct Stop;
    impl Progress for Stop {
        fn begin(&self, _: &'static str, _: u64) {}
        fn step(&self, _: u64) {}
        fn cancelled(&self) -> bool {
            true
        }
    }
    let stopped = train(Engine::Cpu, start.clone(), &targets, &Options::scaled(50), &Stop).unwrap_err();
    assert_eq!(stopped.kind, crate::Kind::Cancelled);
    targets[3].confidence = Some(vec![f32::NAN; 48 * 48]);
    let weights = train(Engine::Cpu, start.clone(), &targets, &Options::scaled(50), &Silent).unwrap_err();
    assert!(weights.to_string().contains("view 3") && weights.to_string().contains("NaN"), "{weights}");
    targets[2].alpha.pop();
    let wrong = train(Engine::Cpu, start, &targets, &Options::scaled(50), &Silent).unwrap_err();
    assert!(wrong.to_string().contains("view 2") && wrong.to_string().contains("48 × 48"), "{wrong}");
}

#[test]
fn density_clones_splits_and_prunes() {
    let mut packed = Packed::pack(&scene(4, 0.1, 2));
    let mut moments = adam::Moments::new(&packed);
    let mut statistics = density::Statistics::new(4);
    for core in &mut packed.core {
        core[crate::splat::packed::OPACITY] = 1.0;
    }
    packed.core[0][8..11].fill(-6.0); // small and pulled: cloned
    packed.core[1][8..11].fill(-1.0); // large and pulled: split
    packed.core[2][3] = -8.0; // faint: pruned
    statistics.seen = vec![[1.0, 1.0], [3.0, 2.0], [0.0, 1.0], [1e-9, 1.0]];
    let before = packed.clone();
    let mut random = random::Random::new(1);
    let d = Density { max_gaussians: 10, ..Options::default().density };
    let o = Options { density: d, scene_extent: 4.0, ..Options::default() };
    density::refine(&mut packed, &mut moments, &mut statistics, &o, &mut random);
    // 0 and its clone, 3, the halves of 1; 1 itself and 2 are gone. The hardest pulled grows first.
    assert_eq!(packed.len(), 5);
    assert_eq!((packed.core[0], packed.core[1]), (before.core[0], before.core[3]));
    assert!((packed.core[2][8] - (before.core[1][8] - 1.6f32.ln())).abs() < 1e-6);
    assert_eq!(packed.core[4], before.core[0]);
    assert_eq!((moments.steps.len(), statistics.seen.len(), packed.sh.len()), (5, 5, 5));
}

#[test]
fn outside_its_region_nothing_moves_multiplies_or_fades() {
    let region = Region { radius: 100.0, low: [-0.5; 2], high: [0.5; 2] };
    let (mut packed, mut seen) = (Packed::pack(&scene(6, 0.1, 2)), Vec::new());
    for (i, core) in packed.core.iter_mut().enumerate() {
        core[crate::splat::packed::POSITION..][..3].fill([0.0, 200.0, 0.6][i % 3]);
        core[crate::splat::packed::OPACITY] = if i < 3 { 3.0 } else { -9.0 };
        seen.push([1.0f32, 1.0]);
    }
    let before = packed.clone();
    for strategy in [Strategy::Paper, Strategy::Mcmc] {
        let mut packed = before.clone();
        let mut moments = adam::Moments::new(&packed);
        let mut statistics = density::Statistics { seen: seen.clone() };
        let d = Density { strategy, max_gaussians: 10, growth: 0.5, ..Options::default().density };
        let o = Options { density: d, moving: region, ..Options::default() };
        let mut random = random::Random::new(1);
        match strategy {
            Strategy::Paper => density::refine(&mut packed, &mut moments, &mut statistics, &o, &mut random),
            Strategy::Mcmc => mcmc::relocate(&mut packed, &mut moments, &mut statistics, &o, &mut random),
        }
        density::reset_opacity(&mut packed, &mut moments, &o);
        // Those within have grown, or been split, and lost opacity; the dead one is gone or has moved.
        assert!(packed.core.iter().filter(|c| region.holds([c[0], c[1], c[2]])).count() >= 2);
        assert_ne!(packed.core[0], before.core[0]);
        for i in [1, 2, 4, 5] {
            assert_eq!(packed.core.iter().filter(|c| **c == before.core[i]).count(), 1, "{strategy:?} {i}");
        }
    }
    // A whole run: places and shapes stay, colours do not.
    let (targets, start) = problem();
    let nowhere = Region { radius: 0.0, ..Region::EVERYWHERE };
    for strategy in [Strategy::Paper, Strategy::Mcmc] {
        let o = Options { moving: nowhere, ..Options::scaled(60) };
        let o = if strategy == Strategy::Mcmc { o.with_mcmc() } else { o };
        let done = train(Engine::Cpu, start.clone(), &targets, &o, &Silent).unwrap();
        assert_eq!(done.gaussians.positions, start.positions);
        assert_eq!((&done.gaussians.log_scales, &done.gaussians.rotations), (&start.log_scales, &start.rotations));
        // The mean colour alone: the same from everywhere.
        let (sh, before) = (&done.gaussians.sh, &start.sh);
        assert!(
            sh.iter().zip(before).any(|(a, b)| a[0] != b[0]) && sh.iter().zip(before).all(|(a, b)| a[1..] == b[1..])
        );
    }
}

#[test]
fn more_time_allows_more_iterations() {
    let (targets, start) = problem();
    assert_eq!(iterations_within(Engine::Cpu, &start, &targets, 0.0, &Silent).unwrap(), 50);
    let n = iterations_within(Engine::Cpu, &start, &targets, 1e6, &Silent).unwrap();
    assert_eq!(n, 7000);
}
