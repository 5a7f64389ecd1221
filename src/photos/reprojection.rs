//! How far from where the photos show them points fall under given poses: the reprojection error (Hartley and Zisserman 2004, §12).
//!
//! Poses are compared by it fairly only where each has the points that suit it: so the points are placed anew under them, each where
//! its squared errors are least, and an error is left that only other poses could lessen.

use glam::{DMat3, DQuat, DVec2, DVec3};
use rayon::prelude::*;

use super::colmap::Camera;
use super::{Observation, Poses};

/// World→camera, OpenCV axes.
pub type Pose = (DQuat, DVec3);

/// Of all observations that count, pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reprojection {
    /// Of points that two photos or more show in front of them.
    pub observations: usize,
    pub points: usize,
    pub rms: f64,
    pub median: f64,
}

/// Steps towards a point's place, each of them tried with more damping where it does not help.
const STEPS: usize = 20;

/// Observations of the photos for which `counts` holds, by point.
fn by_point(all: &Poses, counts: impl Fn(usize) -> bool) -> Vec<Vec<&Observation>> {
    let mut seen: Vec<Vec<&Observation>> = vec![Vec::new(); all.points.len()];
    all.observations.iter().filter(|o| counts(o.photo)).for_each(|o| seen[o.point].push(o));
    seen
}

fn views<'a>(all: &'a Poses, poses: &[Pose], seen: &[&Observation]) -> Vec<View<'a>> {
    seen.iter().map(|o| View::new(o, &all.photos[o.photo].camera, &poses[o.photo])).collect()
}

/// The points placed anew under `poses`, one a photo, by what the photos for which `counts` holds show of them; the others stay.
pub fn placed_under(all: &Poses, poses: &[Pose], counts: impl Fn(usize) -> bool) -> Vec<DVec3> {
    let seen = by_point(all, counts);
    all.points.par_iter().zip(&seen).map(|(p, seen)| placed(p.0, &views(all, poses, seen))).collect()
}

/// The error of `poses`, one a photo, and `points` over the photos for which `counts` holds. `None` where no two of them show the
/// same point.
pub fn error(all: &Poses, poses: &[Pose], points: &[DVec3], counts: impl Fn(usize) -> bool) -> Option<Reprojection> {
    let of_point = |(at, seen): (&DVec3, &Vec<&Observation>)| -> Vec<f64> {
        let errors: Vec<f64> = views(all, poses, seen).iter().filter_map(|v| Some(v.error(*at)?.length())).collect();
        if errors.len() < 2 { Vec::new() } else { errors }
    };
    let each: Vec<Vec<f64>> = points.par_iter().zip(&by_point(all, counts)).map(of_point).collect();
    let points = each.iter().filter(|e| !e.is_empty()).count();
    let mut errors: Vec<f64> = each.concat();
    if errors.is_empty() {
        return None;
    }
    errors.sort_by(f64::total_cmp);
    let squares: f64 = errors.iter().map(|e| e * e).sum();
    Some(Reprojection {
        observations: errors.len(),
        points,
        rms: (squares / errors.len() as f64).sqrt(),
        median: errors[errors.len() / 2],
    })
}

/// One photo's view of a point.
pub(super) struct View<'a> {
    at: DVec2,
    camera: &'a Camera,
    rotation: DMat3,
    translation: DVec3,
}

impl<'a> View<'a> {
    pub fn new(o: &Observation, camera: &'a Camera, pose: &Pose) -> Self {
        View { at: DVec2::from_array(o.at), camera, rotation: DMat3::from_quat(pose.0), translation: pose.1 }
    }

    /// Pixels from where the photo shows it to where it falls; `None` behind the camera.
    pub fn error(&self, p: DVec3) -> Option<DVec2> {
        let q = self.rotation * p + self.translation;
        (q.z > 1e-9).then(|| DVec2::from_array(self.camera.project([q.x / q.z, q.y / q.z])) - self.at)
    }

    /// The error and its derivatives by the point's three coordinates.
    fn linear(&self, p: DVec3) -> Option<(DVec2, [DVec2; 3])> {
        let (error, _, by) = self.by_camera(p)?;
        Some((error, [self.rotation.x_axis, self.rotation.y_axis, self.rotation.z_axis].map(by)))
    }

    /// The same, and its derivatives by shift and rotation vector of p' = exp(ω)·p + v after the pose.
    pub fn by_pose(&self, p: DVec3) -> Option<(DVec2, [DVec2; 3], [DVec2; 6])> {
        let (error, q, by) = self.by_camera(p)?;
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let place = [self.rotation.x_axis, self.rotation.y_axis, self.rotation.z_axis].map(&by);
        let pose = std::array::from_fn(|k| by(if k < 3 { axes[k] } else { axes[k - 3].cross(q) }));
        Some((error, place, pose))
    }

    /// The error, the point in the camera, and what the error changes by as it moves there.
    fn by_camera(&self, p: DVec3) -> Option<(DVec2, DVec3, impl Fn(DVec3) -> DVec2)> {
        let error = self.error(p)?;
        let q = self.rotation * p + self.translation;
        let (u, v) = (q.x / q.z, q.y / q.z);
        // Lenses have no derivative of their own here: differences, a hundred-thousandth of a focal length wide.
        let h = 1e-5;
        let project = |u: f64, v: f64| DVec2::from_array(self.camera.project([u, v]));
        let by_u = (project(u + h, v) - project(u - h, v)) / (2.0 * h);
        let by_v = (project(u, v + h) - project(u, v - h)) / (2.0 * h);
        let by = move |along: DVec3| by_u * (along.x - u * along.z) / q.z + by_v * (along.y - v * along.z) / q.z;
        Some((error, q, by))
    }
}

/// Where the squared errors are least, from a place near it (Levenberg 1944, Marquardt 1963).
pub(super) fn placed(start: DVec3, views: &[View]) -> DVec3 {
    let cost = |p: DVec3| -> f64 {
        // A place behind a camera is none.
        views.iter().map(|v| v.error(p).map_or(f64::INFINITY, |e| e.length_squared())).sum()
    };
    let (mut p, mut damping) = (start, 1e-3);
    let mut now = cost(p);
    if views.len() < 2 || !now.is_finite() {
        return p;
    }
    for _ in 0..STEPS {
        let (mut normal, mut right) = (DMat3::ZERO, DVec3::ZERO);
        for (e, j) in views.iter().filter_map(|v| v.linear(p)) {
            let [x, y] = [0, 1].map(|k| DVec3::new(j[0][k], j[1][k], j[2][k]));
            normal += DMat3::from_cols(x * x.x + y * y.x, x * x.y + y * y.y, x * x.z + y * y.z);
            right -= x * e.x + y * e.y;
        }
        let diagonal = DVec3::new(normal.x_axis.x, normal.y_axis.y, normal.z_axis.z);
        let step = (normal + DMat3::from_diagonal(diagonal * damping + DVec3::splat(1e-12))).inverse() * right;
        let next = if step.is_finite() { cost(p + step) } else { f64::INFINITY };
        if next < now {
            let gained = now - next;
            (p, now, damping) = (p + step, next, damping * 0.1);
            if gained < 1e-9 * now {
                break;
            }
        } else {
            damping *= 10.0;
        }
    }
    p
}

#[cfg(test)]
pub(super) mod tests {
    use super::{Pose, Poses, Reprojection, placed_under};
    use glam::{DQuat, DVec3};

    use crate::photos::colmap::Camera;
    use crate::photos::colmap::Lens;
    use crate::photos::{Observation, Posed};
    use crate::splat::train::random::Random;

    /// Six cameras on an arc, bent lenses, 80 points; photos show each where it is, `noise` pixels off.
    pub fn set(noise: f64) -> Poses {
        let mut random = Random::new(3);
        let mut normal = move || f64::from(random.normal());
        let camera =
            Camera { lens: Lens::SimpleRadial, width: 640, height: 480, parameters: vec![500.0, 320.0, 240.0, -0.05] };
        let photos: Vec<Posed> = (0..6)
            .map(|k| Posed {
                name: format!("{k}"),
                file: Default::default(),
                camera: camera.clone(),
                rotation: DQuat::from_rotation_y(0.25 * f64::from(k) - 0.6),
                translation: DVec3::new(0.0, 0.1 * f64::from(k), 6.0),
            })
            .collect();
        let points: Vec<(DVec3, [u8; 3])> =
            (0..80).map(|_| (DVec3::new(normal(), normal(), normal()) * 0.6, [0; 3])).collect();
        let mut observations = Vec::new();
        for (photo, p) in photos.iter().enumerate() {
            for (point, (at, _)) in points.iter().enumerate() {
                let q = p.rotation * *at + p.translation;
                let [x, y] = camera.project([q.x / q.z, q.y / q.z]);
                observations.push(Observation { photo, point, at: [x + noise * normal(), y + noise * normal()] });
            }
        }
        Poses { photos, points, observations, source: String::new(), files: Vec::new(), notes: Vec::new() }
    }

    /// Of points placed anew.
    pub fn error(all: &Poses, poses: &[Pose], counts: impl Fn(usize) -> bool) -> Option<Reprojection> {
        super::error(all, poses, &placed_under(all, poses, &counts), &counts)
    }

    pub fn poses(all: &Poses) -> Vec<Pose> {
        all.photos.iter().map(|p| (p.rotation, p.translation)).collect()
    }

    #[test]
    fn true_poses_have_no_error_and_points_find_their_places() {
        let mut all = set(0.0);
        let truth = all.points.clone();
        for (k, p) in all.points.iter_mut().enumerate() {
            p.0 += DVec3::new(0.1, -0.05, 0.2) * (k % 3) as f64;
        }
        let e = error(&all, &poses(&all), |_| true).unwrap();
        assert!(e.rms < 1e-6 && e.observations == 480 && e.points == 80, "{e:?}");
        // Of one photo alone nothing can be said; nor where none is shown twice.
        assert_eq!(error(&all, &poses(&all), |k| k == 2), None);
        all.observations.clear();
        assert_eq!(error(&Poses { points: truth, ..all.clone() }, &poses(&all), |_| true), None);
    }

    #[test]
    fn the_error_is_what_the_observations_are_off_by_and_more_where_poses_are() {
        let all = set(0.5);
        let e = error(&all, &poses(&all), |_| true).unwrap();
        // Three of twelve numbers a point go into its place: the rest have 0.5 √(2 · 9/12) left.
        assert!((e.rms - 0.5 * 1.5f64.sqrt()).abs() < 0.03 && e.median < e.rms, "{e:?}");
        let mut wrong = poses(&all);
        // About its eye: five pixels.
        let turn = DQuat::from_rotation_x(0.01);
        wrong[2] = (turn * wrong[2].0, turn * wrong[2].1);
        let w = error(&all, &wrong, |_| true).unwrap();
        assert!(w.rms > 2.0 * e.rms, "{w:?}");
        // The photo that is off does not count.
        let without = error(&all, &wrong, |k| k != 2).unwrap();
        assert!((without.rms - e.rms).abs() < 0.05 && without.observations == 400, "{without:?}");
    }

    #[test]
    fn another_world_changes_nothing() {
        let all = set(0.5);
        let before = error(&all, &poses(&all), |_| true).unwrap();
        let turn = DQuat::from_rotation_z(1.0);
        let mut other = all.clone();
        other.points.iter_mut().for_each(|p| p.0 = 3.0 * (turn * p.0) + DVec3::X);
        let moved: Vec<Pose> = poses(&all)
            .into_iter()
            .map(|(r, t)| (r * turn.inverse(), 3.0 * t - r * turn.inverse() * DVec3::X))
            .collect();
        let after = error(&other, &moved, |_| true).unwrap();
        assert!((before.rms - after.rms).abs() < 1e-6 && (before.median - after.median).abs() < 1e-6);
    }
}
