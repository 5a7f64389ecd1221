//! Poses that are off, refined in training.

use glam::DQuat;

use super::*;
use crate::photos::Observation;
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
    assert!(r.turned > 0.2 && r.turned < 5.0 && r.shifted < 0.2, "{} {}", r.turned, r.shifted);
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
    assert_eq!(s.refined.unwrap().points.len(), given.points.len());
}
