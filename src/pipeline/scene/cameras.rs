//! Poses that are learnt with the scene: where their cameras turn, in which frame they end, how far they came, and photos held out
//! seen from where the finished Gaussians say they were taken.

use glam::{DQuat, DVec3, Mat3, Quat};

use crate::geo::similarity::Similarity;
use crate::photos::reprojection::{self, Pose, Reprojection};
use crate::photos::{Poses, adjust};
use crate::progress::Progress;
use crate::splat::train::{Behind, Density, Rates, Strategy, Trained, train};
use crate::splat::{self, Camera, Gaussians, Target};
use crate::{Result, splat::Engine};

use super::begin::pixel;

/// What refining has made of the poses.
#[derive(Clone, Debug)]
pub struct Refined {
    /// In the poses' own world, one a photo; those held out as they were.
    pub poses: Vec<Pose>,
    /// The sparse points under them.
    pub points: Vec<DVec3>,
    /// From the poses as given to those above.
    pub moved: Moved,
    /// Of that the adjustment by common points, where there was one, and training from there.
    pub by_points: Option<Moved>,
    pub by_photos: Moved,
}

/// How far poses came: median and largest over the photos trained on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moved {
    /// Degrees.
    pub turned: [f64; 2],
    /// Parts of the depth of what the camera looks at.
    pub shifted: [f64; 2],
}

impl Moved {
    /// From where to where; `depths`: of what each camera looks at, in the poses' own world, where it counts.
    fn of(before: &[Pose], after: &[Pose], depths: &[Option<f64>]) -> Moved {
        let eye = |(r, t): &Pose| -(r.inverse() * *t);
        let counted = || before.iter().zip(after).zip(depths).filter_map(|((a, b), d)| Some((a, b, (*d)?)));
        let middle_and_most = |mut all: Vec<f64>| {
            all.sort_by(f64::total_cmp);
            [all.get(all.len() / 2), all.last()].map(|v| v.copied().unwrap_or(0.0))
        };
        Moved {
            turned: middle_and_most(counted().map(|(a, b, _)| a.0.angle_between(b.0).to_degrees()).collect()),
            shifted: middle_and_most(counted().map(|(a, b, d)| eye(a).distance(eye(b)) / d.max(1e-9)).collect()),
        }
    }
}

/// Over the photos trained on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    pub before: Option<Reprojection>,
    /// Where poses were refined.
    pub after: Option<Reprojection>,
}

/// Fewer points in a picture say nothing of how far away things are.
const POINTS: usize = 10;

/// How far before each camera things are: the median depth of the points in its picture; without such the origin's distance.
pub fn depths(poses: &Poses, to_unit: &Similarity, cameras: &[Camera]) -> Vec<f32> {
    let points: Vec<_> = poses.points.iter().map(|(p, _)| to_unit.apply(*p).as_vec3()).collect();
    let of = |c: &Camera| {
        let seen = points.iter().filter(|p| pixel(c, **p).is_some());
        let mut depths: Vec<f32> = seen.map(|p| (c.rotation * *p + c.translation).z).collect();
        depths.sort_by(f32::total_cmp);
        if depths.len() < POINTS { c.translation.length() } else { depths[depths.len() / 2] }
    };
    cameras.iter().map(of).collect()
}

/// What takes all poses best from where they are to where they were: nothing in the photos says where the whole is, so that it
/// drifts. The turn is the mean of all cameras' (of their quaternions), scale and shift are the least squares of their eyes. `None`
/// where all stand at one place.
pub fn gauge(now: &[Pose], before: &[Pose]) -> Option<Similarity> {
    let turns: Vec<DQuat> = now.iter().zip(before).map(|(a, b)| b.0.inverse() * a.0).collect();
    let first = *turns.first()?;
    // A rotation is two quaternions.
    let alike = |q: &DQuat| if q.dot(first) < 0.0 { -*q } else { *q };
    let rotation = turns.iter().map(alike).fold(DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0), |sum, q| sum + q).normalize();
    let eyes = |all: &[Pose]| -> Vec<DVec3> { all.iter().map(|(r, t)| -(r.inverse() * *t)).collect() };
    let (now, before) = (eyes(now), eyes(before));
    let middle = |all: &[DVec3]| all.iter().sum::<DVec3>() / all.len() as f64;
    let (from, to) = (middle(&now), middle(&before));
    let (mut along, mut square) = (0.0, 0.0);
    for (a, b) in now.iter().zip(&before) {
        let p = rotation * (*a - from);
        along += p.dot(*b - to);
        square += p.length_squared();
    }
    let scale = along / square;
    let by = Similarity { scale, rotation, translation: to - scale * (rotation * from) };
    (scale.is_finite() && scale > 0.0 && rotation.is_finite()).then_some(by)
}

/// The pose where the world has gone through `by`: it sees the same, lengths in the camera grow as in the world.
pub fn carried((rotation, translation): &Pose, by: &Similarity) -> Pose {
    let rotation = (*rotation * by.rotation.inverse()).normalize();
    (rotation, by.scale * *translation - rotation * by.translation)
}

fn pose(c: &Camera) -> Pose {
    (Quat::from_mat3(&c.rotation).as_dquat().normalize(), c.translation.as_dvec3())
}

/// The poses bundle-adjusted, points with them, and how many photos that moved, where the photos' points hold them together; those
/// held out as they were. The world stays where it is.
pub fn adjusted(poses: &Poses, moves: impl Fn(usize) -> bool) -> Option<(Poses, usize)> {
    let found = adjust::adjusted(poses, &moves)?;
    let moves = |i: usize| found.moved[i];
    let of = |all: &mut dyn Iterator<Item = Pose>| -> Vec<Pose> {
        all.enumerate().filter(|(i, _)| moves(*i)).map(|(_, p)| p).collect()
    };
    let given = of(&mut poses.photos.iter().map(|p| (p.rotation, p.translation)));
    let back = gauge(&of(&mut found.poses.iter().copied()), &given)?;
    let mut out = poses.clone();
    for (i, p) in out.photos.iter_mut().enumerate().filter(|(i, _)| moves(*i)) {
        (p.rotation, p.translation) = carried(&found.poses[i], &back);
    }
    out.points.iter_mut().zip(&found.points).for_each(|(p, at)| p.0 = back.apply(*at));
    Some((out, given.len()))
}

/// How far off poses may still be after their adjustment, radians: three times what a photo of n points is known to where one of them is
/// off by σ, σ / √n. Training that takes them further follows Gaussians that are not yet right, and at a smaller size than the points
/// were found at it knows less than they do. `None` where no two photos show the same point.
pub fn uncertainty(adjusted: &Poses, counts: impl Fn(usize) -> bool) -> Option<f32> {
    let counted: Vec<usize> = (0..adjusted.photos.len()).filter(|i| counts(*i)).collect();
    let poses: Vec<Pose> = adjusted.photos.iter().map(|p| (p.rotation, p.translation)).collect();
    let points: Vec<DVec3> = adjusted.points.iter().map(|p| p.0).collect();
    let error = reprojection::error(adjusted, &poses, &points, &counts)?;
    let [each, points] = [counted.len(), error.observations].map(|n| n.max(1) as f64);
    let focal = counted.iter().map(|i| adjusted.photos[*i].camera.pinhole()[0]).sum::<f64>() / each;
    Some((3.0 * error.median / focal.max(1.0) / (points / each).sqrt()) as f32)
}

/// A camera of the unit frame in the poses' own world.
pub fn in_world(c: &Camera, to_unit: &Similarity) -> Pose {
    carried(&pose(c), &to_unit.inverse())
}

/// Takes back the drift of a scene whose poses were refined; what refining made of them. `given`: before anything moved them;
/// `begun`: those that training began with.
pub fn settled(
    trained: &mut Trained,
    targets: &[Target],
    given: &Poses,
    begun: &Poses,
    to_unit: &Similarity,
) -> Refined {
    let is_refined = |i: usize| targets[i].refine_pose.is_some();
    let moving: Vec<usize> = (0..targets.len()).filter(|i| is_refined(*i)).collect();
    let now: Vec<Pose> = moving.iter().map(|i| pose(&trained.cameras[*i])).collect();
    let before: Vec<Pose> = moving.iter().map(|i| pose(&targets[*i].camera)).collect();
    if let Some(back) = gauge(&now, &before) {
        let turn = Mat3::from_quat(back.rotation.as_quat());
        trained.gaussians = trained.gaussians.transformed(turn, back.scale as f32, back.translation.as_vec3());
        for (i, p) in moving.iter().zip(&now) {
            let (rotation, translation) = carried(p, &back);
            let c = &mut trained.cameras[*i];
            (c.rotation, c.translation) = (Mat3::from_quat(rotation.as_quat()), translation.as_vec3());
        }
    }
    let of = |all: &Poses| -> Vec<Pose> { all.photos.iter().map(|p| (p.rotation, p.translation)).collect() };
    let (given, start) = (of(given), of(begun));
    let after = |(i, p): (usize, &Pose)| if is_refined(i) { in_world(&trained.cameras[i], to_unit) } else { *p };
    let poses: Vec<Pose> = given.iter().enumerate().map(after).collect();
    let depths: Vec<Option<f64>> =
        targets.iter().map(|t| t.refine_pose.map(|depth| f64::from(depth) / to_unit.scale)).collect();
    Refined {
        moved: Moved::of(&given, &poses, &depths),
        by_points: (given != start).then(|| Moved::of(&given, &start, &depths)),
        by_photos: Moved::of(&start, &poses, &depths),
        points: reprojection::placed_under(begun, &poses, is_refined),
        poses,
    }
}

/// Reprojection errors over the photos for which `counts` holds. `given`: before anything moved.
pub fn errors(given: &Poses, refined: Option<&Refined>, counts: impl Fn(usize) -> bool) -> Errors {
    let poses: Vec<Pose> = given.photos.iter().map(|p| (p.rotation, p.translation)).collect();
    let before = reprojection::placed_under(given, &poses, &counts);
    Errors {
        before: reprojection::error(given, &poses, &before, &counts),
        after: refined.and_then(|r| reprojection::error(given, &r.poses, &r.points, &counts)),
    }
}

/// Steps for each photo held out, and how long the first and the last are, radians.
const STEPS: usize = 120;
const RATE: f32 = 2e-3;
const RATE_SHARE: f32 = 0.005;

/// Cameras of photos held out where they meet the Gaussians best, which stand still (as Lin et al. 2021 measure poses that were
/// learnt): what a photo's own pose is off by is not held against the scene.
///
/// # Errors
/// As [`train`].
pub fn fitted(
    engine: Engine,
    g: &Gaussians,
    held_out: &[Target],
    depths: &[f32],
    behind: [f32; 3],
    seed: u64,
    progress: &dyn Progress,
) -> Result<Vec<Camera>> {
    let turning = |(t, depth): (&Target, &f32)| Target { weight: 1.0, refine_pose: Some(*depth), ..t.clone() };
    let targets: Vec<Target> = held_out.iter().zip(depths).map(turning).collect();
    // Steps fall from their first length to their last: nothing is too little a length for it.
    let nothing = 1e-30;
    let plain = splat::Options::default();
    let options = splat::Options {
        iterations: STEPS * targets.len(),
        seed,
        rates: Rates {
            position: nothing,
            position_final: nothing,
            opacity: 0.0,
            rotation: 0.0,
            scale: 0.0,
            color: 0.0,
            harmonics: 0.0,
            pose: RATE,
            pose_share: RATE_SHARE,
            ..plain.rates
        },
        scene_extent: 1.0,
        first_degree: 3,
        density: Density { strategy: Strategy::Paper, until: 0, reset_every: 0, ..plain.density },
        pose_from: 0,
        behind: Behind::Fixed(behind),
        shuffled: true,
        ..plain
    };
    Ok(train(engine, g.clone(), &targets, &options, progress)?.cameras)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn a_drift_of_all_is_taken_back_and_pictures_stay() {
        let before: Vec<Pose> = (0..5)
            .map(|k| {
                let a = k as f32 * 1.1;
                let eye = Vec3::new(a.cos(), a.sin(), 0.4 + 0.1 * k as f32);
                pose(&Camera::look_at(eye, Vec3::new(0.1, 0.0, 0.0), 1.0, 64))
            })
            .collect();
        let by = Similarity {
            scale: 1.03,
            rotation: DQuat::from_scaled_axis(DVec3::new(0.02, -0.01, 0.05)),
            translation: DVec3::new(0.03, 0.0, -0.02),
        };
        let now: Vec<Pose> = before.iter().map(|c| carried(c, &by)).collect();
        // A point goes with its camera, to the same place in the picture.
        let p = DVec3::new(0.2, -0.1, 0.05);
        let seen = |(r, t): &Pose, p: DVec3| {
            let q = *r * p + *t;
            q.truncate() / q.z
        };
        assert!(seen(&before[1], p).distance(seen(&now[1], by.apply(p))) < 1e-6);
        let back = gauge(&now, &before).unwrap();
        for (c, b) in now.iter().zip(&before) {
            let c = carried(c, &back);
            assert!(c.1.distance(b.1) < 1e-6 && c.0.angle_between(b.0) < 1e-6, "{c:?} {b:?}");
        }
        assert!(gauge(&before[..1], &before[..1]).is_none() && gauge(&[], &[]).is_none());
    }

    #[test]
    fn a_camera_finds_back_into_the_poses_own_world() {
        let to_unit =
            Similarity { scale: 0.05, rotation: DQuat::from_rotation_x(0.7), translation: DVec3::new(3.0, -1.0, 0.5) };
        let (rotation, translation) = (DQuat::from_rotation_y(0.3), DVec3::new(4.0, 5.0, 60.0));
        let c = crate::photos::crops::camera([50.0, 50.0, 32.0, 32.0], (64, 64), rotation, translation, &to_unit);
        let (r, t) = in_world(&c, &to_unit);
        assert!(r.angle_between(rotation) < 1e-6 && t.distance(translation) < 1e-4, "{r} {t}");
    }
}
