//! Poses that are off, refined in training.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use glam::DQuat;

use super::*;
use crate::photos::Observation;
use crate::splat::train::Saved;
use crate::splat::train::random::Random;

/// Every camera turned about its eye, and its eye moved by parts of its distance; both in standard deviations along each axis.
fn off(poses: &Poses, turn: f64, shift: f64) -> Poses {
    let mut random = Random::new(11);
    let mut normal = move || f64::from(random.normal());
    let mut out = poses.clone();
    for p in &mut out.photos {
        let far = p.translation.length();
        let eye = p.centre() + DVec3::new(normal(), normal(), normal()) * shift * far;
        p.rotation = DQuat::from_scaled_axis(DVec3::new(normal(), normal(), normal()) * turn) * p.rotation;
        p.translation = -(p.rotation * eye);
    }
    out
}

/// Trained with poses that are half a degree off; `observed`: with what the photos show of the points.
fn trained_off(refine: bool, observed: bool) -> (Scene, Poses) {
    with_source(&SITE, false, |source| {
        let mut poses = off(source.poses, 0.008, 0.004);
        if observed {
            // Where the truth puts them, to a third of a pixel.
            let mut random = Random::new(12);
            let mut normal = move || f64::from(random.normal()) * 0.3;
            for (photo, p) in source.poses.photos.iter().enumerate() {
                for (point, (at, _)) in source.poses.points.iter().enumerate().step_by(9) {
                    let seen = p.pixel(*at).filter(|[x, y]| *x > 0.0 && *y > 0.0 && *x < 96.0 && *y < 72.0);
                    let at = seen.map(|[x, y]| [x + normal(), y + normal()]);
                    poses.observations.extend(at.map(|at| Observation { photo, point, at }));
                }
            }
        }
        let source = Source { poses: &poses, ..*source };
        let options = Options { refine_poses: refine, fit_held_out: true, ..brief() };
        (fit(&source, splat::Engine::Cpu, &options, None, &Silent).unwrap(), poses)
    })
}

#[test]
fn poses_that_are_off_are_found_in_training() {
    let (plain, _) = trained_off(false, false);
    let (refined, given) = trained_off(true, false);
    let fitted = |s: &Scene| s.held_out_fitted.unwrap();
    assert!(fitted(&refined).psnr > fitted(&plain).psnr + 1.0, "{:?} {:?}", fitted(&refined), fitted(&plain));
    assert!(refined.trained.psnr > plain.trained.psnr + 0.5, "{:?} {:?}", refined.trained, plain.trained);
    // A photo's own pose is not held against the scene.
    assert!(fitted(&plain).psnr > plain.held_out.psnr, "{:?} {:?}", fitted(&plain), plain.held_out);
    assert!(plain.refined.is_none() && refined.reprojection == Errors::default());
    // The whole stays where it was, those held out exactly.
    let r = refined.refined.unwrap();
    let (most, shift) = (r.moved.turned[1], r.moved.shifted[1]);
    assert!(most > 0.2 && most < 5.0 && shift < 0.2 && r.moved.turned[0] < most, "{:?}", r.moved);
    assert!(r.by_points.is_none() && r.by_photos == r.moved);
    let refining = refined.refining.unwrap();
    assert!(refining.trial().unwrap().gain > 0.5 && refining.common.points == 0, "{refining:?}");
    assert_eq!(r.poses[8], (given.photos[8].rotation, given.photos[8].translation));
    let eye = |(q, t): &(DQuat, DVec3)| -(q.inverse() * *t);
    let mean = |all: &mut dyn Iterator<Item = DVec3>| all.sum::<DVec3>() / 21.0;
    let trained = |i: &usize| !i.is_multiple_of(8);
    let before = mean(&mut (0..24).filter(trained).map(|i| given.photos[i].centre()));
    let after = mean(&mut (0..24).filter(trained).map(|i| eye(&r.poses[i])));
    assert!(before.distance(after) < 1e-3 * given.photos[0].translation.length(), "{before} {after}");
}

#[test]
fn what_photos_show_of_points_puts_poses_right_before_training() {
    let (s, given) = trained_off(true, true);
    let (before, after) = (s.reprojection.before.unwrap(), s.reprojection.after.unwrap());
    assert!(before.observations == after.observations && before.median > 2.0 * after.median, "{before:?} {after:?}");
    // A third of a pixel along both axes is in the observations.
    assert!(after.rms < 0.6, "{after:?}");
    let truth = &*BRIEF;
    let psnr = s.held_out_fitted.unwrap().psnr;
    assert!(psnr > truth.held_out.psnr - 0.7, "{psnr} {:?}", truth.held_out);
    let r = s.refined.unwrap();
    assert_eq!(r.points.len(), given.points.len());
    // The points did nearly all of it.
    let (by_points, by_photos) = (r.by_points.unwrap(), r.by_photos);
    assert!(by_points.turned[0] > 5.0 * by_photos.turned[0], "{by_points:?} {by_photos:?}");
    assert!(matches!(s.refining.unwrap().by, By::Points { photos: 21 }), "{:?}", s.refining);
}

#[test]
fn poses_that_are_right_are_left_alone_where_photos_alone_would_say() {
    let options = Options { refine_poses: true, ..brief() };
    let s = trained(&SITE, &options, false);
    assert!(matches!(s.refining.unwrap().by, By::Nothing(Some(_))) && s.refined.is_none(), "{:?}", s.refining);
    // The scene is the one that it would have been.
    assert!(s.gaussians == BRIEF.gaussians && s.cameras == BRIEF.cameras);
    // Eight points in common are not enough, nor is a run that gives each photo one step.
    let few = with_source(&SITE, false, |source| {
        let mut poses = source.poses.clone();
        for (point, photo) in (0..8).flat_map(|point| (1..4).map(move |photo| (point, photo))) {
            let at = poses.photos[photo].pixel(poses.points[point].0);
            poses.observations.extend(at.map(|at| Observation { photo, point, at }));
        }
        let options = Options { iterations: 100, ..options.clone() };
        fit(&Source { poses: &poses, ..*source }, splat::Engine::Cpu, &options, None, &Silent).unwrap()
    });
    let refining = few.refining.unwrap();
    assert!(refining.by == By::Nothing(None) && refining.common.points > 0, "{refining:?}");
    assert!(refining.words().contains("too few for an adjustment") && few.refined.is_none());
}

/// Hears what stages begin, and stops the training after so many steps.
struct Heard {
    stages: Mutex<Vec<&'static str>>,
    stop: Option<u64>,
    stopped: AtomicBool,
}

impl Heard {
    fn until(stop: Option<u64>) -> Heard {
        Heard { stages: Mutex::default(), stop, stopped: AtomicBool::new(false) }
    }

    fn has(&self, stage: &'static str) -> bool {
        self.stages.lock().unwrap().contains(&stage)
    }
}

impl Progress for Heard {
    fn begin(&self, stage: &'static str, _: u64) {
        self.stages.lock().unwrap().push(stage);
    }
    fn step(&self, done: u64) {
        if self.has("optimise Gaussians") && self.stop.is_some_and(|stop| done >= stop) {
            self.stopped.store(true, Relaxed);
        }
    }
    fn cancelled(&self) -> bool {
        self.stopped.load(Relaxed)
    }
}

#[test]
fn a_run_that_goes_on_knows_what_its_trial_found() {
    const TRIAL: &str = "trying to refine poses";
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("run");
    // Poses that are right, which the trial leaves alone, and poses that are off, which it finds can be refined.
    for (turn, refines) in [(0.0, false), (0.02, true)] {
        let run = |kept: Kept, progress: &dyn Progress| {
            let options = Options { refine_poses: true, iterations: 400, max_gaussians: 9000, kept, ..brief() };
            with_source(&SITE, false, |source| {
                let poses = off(source.poses, turn, turn / 2.0);
                fit(&Source { poses: &poses, ..*source }, splat::Engine::Cpu, &options, None, progress)
            })
        };
        let whole = run(Kept::default(), &Silent).unwrap();
        let kept = Kept { file: Some(file.clone()), ..Kept::default() };
        let first = Heard::until(Some(150));
        let e = run(kept.clone(), &first).map(|_| ()).unwrap_err();
        assert!(e.kind == crate::Kind::Cancelled && first.has(TRIAL), "{e}");
        let second = Heard::until(None);
        let from = Some(Saved::read(&file).unwrap().into());
        let end = run(Kept { from, ..kept }, &second).unwrap();
        assert!(!second.has(TRIAL) && second.has("optimise Gaussians"));
        assert!(end.gaussians == whole.gaussians && end.cameras == whole.cameras);
        assert_eq!(end.refining, whole.refining);
        let verdict = end.refining.unwrap();
        assert_eq!(verdict.moved(), refines, "{verdict:?}");
        assert!(verdict.trial().is_some() && !end.timings.iter().any(|t| t.stage == "trial of poses"));
    }
}
