//! Whole runs on the GPU against the CPU's: steps, density control, stopping and going on.

use glam::Vec3;

use super::{gpu, target};
use crate::progress::{Progress, Silent};
use crate::splat::render::gpu::Gpu;
use crate::splat::render::tests::scene;
use crate::splat::render::{Shown, render};
use crate::splat::train::tests::disturbed;
use crate::splat::train::{
    Behind, Checkpoint, Density, Engine, Every, Kept, Options, Saved, Target, advance, train, train_kept,
};
use crate::splat::{Camera, Gaussians};

/// Views of a scene and a disturbed copy to start from.
fn problem(size: u32) -> (Vec<Target>, Gaussians) {
    let truth = scene(150, 0.12, 1);
    let targets = (0..5)
        .map(|i| {
            let a = i as f32 / 5.0 * std::f32::consts::TAU;
            // Two sizes of picture.
            let size = size + 8 * (i % 2);
            let camera = Camera::look_at(Vec3::new(3.0 * a.cos(), 3.0 * a.sin(), 0.8), Vec3::ZERO, 0.7, size);
            let frame = render(&truth, &camera, [0.0; 3]);
            Target {
                camera,
                color: frame.color.iter().zip(&frame.alpha).map(|(c, a)| c.map(|v| v / a.max(1e-3))).collect(),
                alpha: frame.alpha,
                weight: 1.0,
                refine_pose: (i == 2).then_some(1.7),
                fit_exposure: false,
                held_back: None,
                confidence: None,
                shown: Shown::Color,
                name: format!("view {i}"),
            }
        })
        .collect();
    (targets, disturbed(truth))
}

#[test]
fn a_run_follows_the_cpus() {
    let Some(gpu) = gpu() else { return };
    let (targets, start) = problem(48);
    let scaled = Options::scaled(40);
    let o = Options { density: Density { until: 0, ..scaled.density }, pose_from: 5, ..scaled };
    let cpu = train(Engine::Cpu, start.clone(), &targets, &o, &Silent).unwrap();
    let got = train(Engine::Gpu(gpu), start, &targets, &o, &Silent).unwrap();
    assert_eq!(got.report.iterations, 40);
    for (a, b) in cpu.report.targets.iter().zip(&got.report.targets) {
        assert!(b.after.picture > b.before.picture + 1.0, "{b:?}");
        assert!((a.after.picture - b.after.picture).abs() < 0.3, "{a:?} {b:?}");
        assert_eq!(a.turns, b.turns);
    }
    let apart = (cpu.cameras[2].position() - got.cameras[2].position()).length();
    let moved = (cpu.cameras[2].position() - targets[2].camera.position()).length();
    assert!(moved > 1e-4 && apart < 0.2 * moved, "{moved} {apart}");
    assert_eq!(got.cameras[1], targets[1].camera);
}

#[test]
fn exposures_are_found_as_on_the_cpu() {
    let Some(gpu) = gpu() else { return };
    let (mut targets, _) = problem(48);
    let truth = scene(150, 0.12, 1);
    let gains = [1.0, 0.7, 1.2, 0.9, 1.1];
    for (t, gain) in targets.iter_mut().zip(gains) {
        t.color.iter_mut().for_each(|c| *c = [c[0] * gain, c[1] * gain * 0.95, c[2] * gain]);
        (t.fit_exposure, t.refine_pose) = (true, None);
    }
    let scaled = Options::scaled(150);
    let o = Options { density: Density { until: 0, ..scaled.density }, behind: Behind::Fixed([0.0; 3]), ..scaled };
    let [cpu, got] = [Engine::Cpu, Engine::Gpu(gpu)].map(|e| train(e, truth.clone(), &targets, &o, &Silent).unwrap());
    for ((a, b), gain) in cpu.exposures.iter().zip(&got.exposures).zip(gains) {
        for (a, b) in a.as_flattened().iter().zip(b.as_flattened()) {
            assert!((a - b).abs() < 0.02, "{:?} {:?}", cpu.exposures, got.exposures);
        }
        // Red is answered by red, up to what all photos have in common.
        let ratio = a[0][0..3].iter().sum::<f32>() / gain;
        assert!((0.75..1.35).contains(&ratio), "{ratio} {a:?}");
    }
    for t in &got.report.targets {
        assert!(t.after.picture > t.before.picture + 3.0, "{t:?}");
    }
}

#[test]
fn density_grows_prunes_and_resets() {
    let Some(gpu) = gpu() else { return };
    let (targets, start) = problem(48);
    let mut o = Options::scaled(60);
    o.density = Density {
        every: 8,
        from: 8,
        until: 60,
        gradient: 1e-6,
        growth: 0.3,
        max_gaussians: 400,
        reset_every: 20,
        ..o.density
    };
    let one = |threshold| {
        let o = Options { density: Density { gradient: threshold, ..o.density }, ..o };
        train(Engine::Gpu(gpu), start.clone(), &targets, &o, &Silent).unwrap()
    };
    let (a, b) = (one(1e-6), one(1e-6));
    assert_eq!(a.gaussians, b.gaussians, "same bytes");
    assert!(a.report.gaussians_after > 300 && a.report.gaussians_after <= 400, "{}", a.report.gaussians_after);
    let cpu = train(Engine::Cpu, start.clone(), &targets, &o, &Silent).unwrap();
    let (x, y) = (a.report.gaussians_after as f32, cpu.report.gaussians_after as f32);
    assert!((x - y).abs() < 0.1 * y, "{x} {y}");
    assert!(one(1e9).report.gaussians_after <= start.len(), "no one grows");
}

#[test]
fn a_run_taken_up_again_ends_the_same() {
    let Some(gpu) = gpu() else { return };
    let (targets, start) = problem(40);
    let mut o = Options { pose_from: 3, ..Options::scaled(40) };
    o.density = Density { every: 7, from: 7, until: 36, gradient: 1e-6, growth: 0.3, ..o.density };
    for engine in [Engine::Cpu, Engine::Gpu(gpu)] {
        let at = Checkpoint::new(&start, &targets).unwrap();
        let whole = advance(engine, at.clone(), &targets, &o, 40, &Silent).unwrap().checkpoint;
        let mut cut = at;
        for until in [5, 7, 20, 21, 40] {
            cut = advance(engine, cut, &targets, &o, until, &Silent).unwrap().checkpoint;
            assert_eq!(cut.iteration, until);
        }
        assert!(whole.gaussians().len() > start.len());
        assert_eq!(whole, cut);
    }
}

/// Stops the run after so many steps.
struct StoppedAfter(u64, std::sync::atomic::AtomicU64);

impl Progress for StoppedAfter {
    fn begin(&self, _: &'static str, _: u64) {}
    fn step(&self, done: u64) {
        self.1.store(done, std::sync::atomic::Ordering::Relaxed);
    }
    fn cancelled(&self) -> bool {
        self.1.load(std::sync::atomic::Ordering::Relaxed) >= self.0
    }
}

#[test]
fn a_run_stopped_by_the_user_goes_on_from_its_file() {
    let Some(gpu) = gpu() else { return };
    let (targets, start) = problem(40);
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("kept");
    let paper = Options { pose_from: 3, ..Options::scaled(40) };
    let d = Density { every: 7, from: 7, until: 36, gradient: 1e-6, growth: 0.3, ..paper.density };
    let paper = Options { density: d, ..paper };
    let mut mcmc = paper.with_mcmc();
    mcmc.density = Density { every: 7, from: 5, until: 36, growth: 0.2, max_gaussians: 220, ..mcmc.density };
    for (engine, o) in
        [(Engine::Cpu, &paper), (Engine::Cpu, &mcmc), (Engine::Gpu(gpu), &paper), (Engine::Gpu(gpu), &mcmc)]
    {
        let run = |kept: &Kept, progress: &dyn Progress| train_kept(engine, start.clone(), &targets, o, kept, progress);
        let whole = run(&Kept::default(), &Silent).unwrap();
        // Every third step is written; the user stops it twice, the second time after it was taken up.
        let kept = Kept { file: Some(file.clone()), every: Every::Iterations(3), ..Kept::default() };
        let e = run(&kept, &StoppedAfter(10, 0.into())).unwrap_err();
        assert!(e.kind == crate::Kind::Cancelled && e.to_string().contains("--resume"), "{e}");
        let again = || Kept { from: Some(Saved::read(&file).unwrap().into()), ..kept.clone() };
        run(&again(), &StoppedAfter(25, 0.into())).unwrap_err();
        let end = run(&again(), &Silent).unwrap();
        assert_eq!(end.gaussians, whole.gaussians);
        assert_eq!(end.cameras, whole.cameras);
        assert!(end.gaussians.len() > start.len());
        // What is finished is not begun again.
        assert_eq!(run(&again(), &Silent).unwrap().gaussians, whole.gaussians);
    }
    // Of another engine.
    let kept = Kept { from: Some(Saved::read(&file).unwrap().into()), ..Kept::default() };
    let e = train_kept(Engine::Cpu, start, &targets, &mcmc, &kept, &Silent).unwrap_err();
    assert!(e.kind == crate::Kind::Usage && e.to_string().contains("engine"), "{e}");
}

#[test]
fn short_lists_halt_and_go_on() {
    let Some(gpu) = gpu() else { return };
    // 300 Gaussians over all of 600 tiles: more pairs than the first guess.
    let mut g = scene(300, 1.5, 8);
    g.logit_opacities.fill(-3.0);
    let mut t = target(Camera::look_at(Vec3::new(0.0, -4.0, 0.0), Vec3::ZERO, 0.9, 400), 3);
    t.held_back = None;
    t.refine_pose = None;
    let o =
        Options { iterations: 3, density: Density { until: 0, ..Options::default().density }, ..Options::default() };
    let run = |engine| train(engine, g.clone(), std::slice::from_ref(&t), &o, &Silent).unwrap();
    let (a, b) = (run(Engine::Gpu(gpu)), run(Engine::Cpu));
    assert_eq!(a.report.iterations, 3);
    assert!((a.report.targets[0].after.picture - b.report.targets[0].after.picture).abs() < 0.05);
}

#[test]
fn growth_stops_at_what_the_adapter_holds() {
    if gpu().is_none() {
        return;
    }
    let mut small = Gpu::open(true, None).unwrap();
    small.adapter.largest_binding = 192 * 1000;
    let (targets, start) = problem(16);
    let o = Options::scaled(40);
    let density = Density { every: 5, from: 1, until: 40, gradient: 0.0, growth: 1.0, ..o.density };
    let o = Options { density: Density { max_gaussians: 100_000, ..density }, ..o };
    for strategy in [crate::splat::train::Strategy::Paper, crate::splat::train::Strategy::Mcmc] {
        let o = Options { density: Density { strategy, ..o.density }, ..o };
        let got = train(Engine::Gpu(&small), start.clone(), &targets, &o, &Silent).unwrap();
        let n = got.report.gaussians_after;
        assert!((900..=1000).contains(&n), "{n} of at most 1000");
    }
}

#[test]
fn mcmc_grows_to_its_cap_and_learns() {
    let Some(gpu) = gpu() else { return };
    let (targets, mut start) = problem(48);
    start.logit_opacities[..20].fill(-9.0);
    let mut o = Options::scaled(80).with_mcmc();
    o.density = Density { every: 10, from: 5, until: 70, growth: 0.2, max_gaussians: 200, ..o.density };
    // The noise is in proportion: these Gaussians are as large as the subject's parts.
    (o.rates.position, o.rates.position_final) = (1e-5, 1e-6);
    for engine in [Engine::Cpu, Engine::Gpu(gpu)] {
        let one = || train(engine, start.clone(), &targets, &o, &Silent).unwrap();
        let (a, b) = (one(), one());
        assert_eq!(a.gaussians, b.gaussians, "same bytes");
        assert_eq!(a.report.gaussians_after, 200);
        let dead = a.gaussians.logit_opacities.iter().filter(|l| **l < -5.3).count();
        assert!(dead < 20, "{dead} dead");
        for t in &a.report.targets {
            assert!(t.after.picture > t.before.picture, "{t:?}");
        }
    }
}
