//! Bundle adjustment: poses and points where the photos show the points best (Triggs et al. 2000), lenses as they are.
//!
//! Levenberg–Marquardt over both. Points are eliminated from each step's normal equations (Schur complement, Brown 1958), what is
//! left is solved by conjugate gradients that never form it (Agarwal et al. 2010), so that memory grows with the observations and
//! not with the square of the photos. Observations that are off count less (Huber 1964), beyond twice the median error of each step.

mod solve;

use std::collections::BTreeMap;

use glam::{DMat3, DQuat, DVec2, DVec3};
use rayon::prelude::*;

use self::solve::{Six, cholesky, conjugate_gradients, solved};
use super::reprojection::{self, Pose, View};
use super::{Observation, Poses};

/// Poses and points after the adjustment.
#[derive(Clone, Debug)]
pub struct Adjusted {
    /// One a photo; those that were not to move, or that show too few points, as they were.
    pub poses: Vec<Pose>,
    /// One a photo.
    pub moved: Vec<bool>,
    /// One a point; those seen by fewer than two of the photos as they were.
    pub points: Vec<DVec3>,
}

const STEPS: usize = 60;
/// A gain of less than this part of the cost ends it.
const ENOUGH: f64 = 1e-7;
/// Points whose sums one task makes.
const CHUNK: usize = 2048;

/// Where one photo shows a point: the photo among those that move.
struct Sight<'a> {
    camera: usize,
    observation: &'a Observation,
}

/// Of one observation: ∂²/∂pose∂point, weighted.
struct Mixed {
    camera: usize,
    block: [DVec3; 6],
}

/// Of one point: its observations, its own normal matrix and gradient.
struct OfPoint {
    mixed: Vec<Mixed>,
    normal: DMat3,
    gradient: DVec3,
}

/// The normal equations at one place.
struct Normal {
    points: Vec<OfPoint>,
    cameras: Vec<([Six; 6], Six)>,
}

/// A photo that shows fewer common points stays where it is: then it is their noise that moves it. Seven photos of some twenty each
/// went away from true poses by a degree in the median.
const LEAST_POINTS: usize = 30;
/// Photos that share fewer points do not hold each other. Of groups that nothing holds together each would turn, shift and scale by
/// itself: the largest is adjusted.
const LINK: usize = 8;
/// So many observed numbers for each of a pose's, beside what the points' own places take of them: with no more than one the noise of
/// each goes into the poses whole.
const SPARE: usize = 2;

/// What photos show of points that others of them show too.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Common {
    pub observations: usize,
    pub points: usize,
}

/// Of the photos for which `counts` holds.
pub fn common(all: &Poses, counts: impl Fn(usize) -> bool) -> Common {
    let seen = sights(all, &(0..all.photos.len()).filter(|i| counts(*i)).collect::<Vec<_>>());
    Common { observations: seen.iter().map(Vec::len).sum(), points: seen.iter().filter(|s| !s.is_empty()).count() }
}

/// By point: which of some photos show it. Those that one alone shows are left out.
fn sights<'a>(all: &'a Poses, photos: &[usize]) -> Vec<Vec<Sight<'a>>> {
    let mut number = vec![None; all.photos.len()];
    photos.iter().enumerate().for_each(|(k, i)| number[*i] = Some(k));
    let mut seen: Vec<Vec<Sight>> = all.points.iter().map(|_| Vec::new()).collect();
    for observation in &all.observations {
        let Some(camera) = number[observation.photo] else { continue };
        let photo = &all.photos[observation.photo];
        // What lies behind its camera says nothing.
        let view = View::new(observation, &photo.camera, &(photo.rotation, photo.translation));
        if view.error(all.points[observation.point].0).is_some() {
            seen[observation.point].push(Sight { camera, observation });
        }
    }
    seen.iter_mut().filter(|s| s.len() < 2).for_each(Vec::clear);
    seen
}

/// Which of so many photos belong to the largest group of those that share enough points one with the next; of groups as large, the
/// first.
fn largest_group(seen: &[Vec<Sight>], count: usize) -> Vec<bool> {
    let mut shared: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for sights in seen {
        for (k, a) in sights.iter().enumerate() {
            for b in &sights[k + 1..] {
                *shared.entry((a.camera.min(b.camera), a.camera.max(b.camera))).or_default() += 1;
            }
        }
    }
    let mut group: Vec<usize> = (0..count).collect();
    fn root(group: &[usize], mut i: usize) -> usize {
        while group[i] != i {
            i = group[i];
        }
        i
    }
    for ((a, b), _) in shared.iter().filter(|(_, n)| **n >= LINK) {
        let (a, b) = (root(&group, *a), root(&group, *b));
        group[a.max(b)] = a.min(b);
    }
    let roots: Vec<usize> = (0..count).map(|i| root(&group, i)).collect();
    let mut sizes = vec![0usize; count];
    roots.iter().for_each(|r| sizes[*r] += 1);
    let largest = (0..count).max_by_key(|r| (sizes[*r], std::cmp::Reverse(*r)));
    roots.into_iter().map(|r| Some(r) == largest).collect()
}

/// Whether the photos for which `moves` holds show enough of common points that [`adjusted`] adjusts some of them.
pub fn is_held(all: &Poses, moves: impl Fn(usize) -> bool) -> bool {
    held(all, moves).is_some()
}

/// Those of the photos for which `moves` holds that common points hold, and by point which of them show it.
fn held(all: &Poses, moves: impl Fn(usize) -> bool) -> Option<(Vec<usize>, Vec<Vec<Sight<'_>>>)> {
    let mut moving: Vec<usize> = (0..all.photos.len()).filter(|i| moves(*i)).collect();
    let seen = loop {
        let seen = sights(all, &moving);
        let mut shown = vec![0; moving.len()];
        seen.iter().flatten().for_each(|s| shown[s.camera] += 1);
        let group = largest_group(&seen, moving.len());
        let mut enough = shown.iter().zip(group).map(|(n, held)| *n >= LEAST_POINTS && held);
        let before = moving.len();
        moving.retain(|_| enough.next() == Some(true));
        // What those that are left out showed no longer counts as shown twice.
        if moving.len() == before {
            break seen;
        }
    };
    let count: usize = seen.iter().map(Vec::len).sum();
    let placed = seen.iter().filter(|s| !s.is_empty()).count();
    let enough = moving.len() >= 2 && 2 * count >= SPARE * 6 * moving.len() + 3 * placed;
    enough.then_some((moving, seen))
}

/// Adjusts the photos for which `moves` holds and that show enough points which others of them show too. `None` where those are too
/// few to hold the poses.
pub fn adjusted(all: &Poses, moves: impl Fn(usize) -> bool) -> Option<Adjusted> {
    let (moving, seen) = held(all, moves)?;
    let given = |i: usize| (all.photos[i].rotation, all.photos[i].translation);
    let mut run = Run {
        all,
        seen,
        cameras: moving.iter().map(|i| given(*i)).collect(),
        points: all.points.iter().map(|p| p.0).collect(),
    };
    // Points first: what they are off by is not the poses'.
    run.place();
    run.adjust();
    let mut poses: Vec<Pose> = (0..all.photos.len()).map(given).collect();
    let mut moved = vec![false; poses.len()];
    for (i, c) in moving.iter().zip(&run.cameras) {
        (poses[*i], moved[*i]) = (*c, true);
    }
    Some(Adjusted { poses, moved, points: run.points })
}

struct Run<'a> {
    all: &'a Poses,
    /// By point.
    seen: Vec<Vec<Sight<'a>>>,
    cameras: Vec<Pose>,
    points: Vec<DVec3>,
}

impl Run<'_> {
    fn view(&self, s: &Sight, cameras: &[Pose]) -> View<'_> {
        View::new(s.observation, &self.all.photos[s.observation.photo].camera, &cameras[s.camera])
    }

    fn place(&mut self) {
        let placed = |(p, seen): (&DVec3, &Vec<Sight>)| {
            let views: Vec<View> = seen.iter().map(|s| self.view(s, &self.cameras)).collect();
            reprojection::placed(*p, &views)
        };
        self.points = self.points.par_iter().zip(&self.seen).map(placed).collect();
    }

    /// Lengths of all errors, `None` where a point has come behind a camera.
    fn errors(&self, cameras: &[Pose], points: &[DVec3]) -> Option<Vec<f64>> {
        let of = |(p, seen): (&DVec3, &Vec<Sight>)| -> Option<Vec<f64>> {
            seen.iter().map(|s| Some(self.view(s, cameras).error(*p)?.length())).collect()
        };
        let each: Option<Vec<Vec<f64>>> = points.par_iter().zip(&self.seen).map(of).collect();
        Some(each?.concat())
    }

    fn adjust(&mut self) {
        let Some(mut errors) = self.errors(&self.cameras, &self.points) else { return };
        let mut damping = 1e-4;
        for _ in 0..STEPS {
            let mut sorted = errors.clone();
            sorted.sort_by(f64::total_cmp);
            let bound = (2.0 * sorted[sorted.len() / 2]).max(1e-9);
            let now = cost(&errors, bound);
            let normal = self.normal(bound);
            let mut better = None;
            while better.is_none() && damping < 1e8 {
                let (cameras, points) = self.stepped(&normal, damping);
                let next = self.errors(&cameras, &points).filter(|e| cost(e, bound) < now);
                damping *= if next.is_some() { 0.1 } else { 10.0 };
                better = next.map(|e| (cameras, points, e));
            }
            let Some((cameras, points, next)) = better else { return };
            let gained = now - cost(&next, bound);
            (self.cameras, self.points, errors) = (cameras, points, next);
            damping = damping.max(1e-10);
            if gained < ENOUGH * now {
                return;
            }
        }
    }

    fn normal(&self, bound: f64) -> Normal {
        let one = |(p, seen): (&DVec3, &Vec<Sight>)| {
            let mut of = OfPoint { mixed: Vec::with_capacity(seen.len()), normal: DMat3::ZERO, gradient: DVec3::ZERO };
            let mut own = Vec::with_capacity(seen.len());
            for s in seen {
                let Some((e, by_place, by_pose)) = self.view(s, &self.cameras).by_pose(*p) else { continue };
                let weight = (bound / e.length().max(1e-300)).min(1.0);
                let [px, py] = rows(&by_place);
                let outer = |a: DVec3| DMat3::from_cols(a * a.x, a * a.y, a * a.z);
                of.normal += (outer(px) + outer(py)) * weight;
                of.gradient += (px * e.x + py * e.y) * weight;
                let block = by_pose.map(|c| (px * c.x + py * c.y) * weight);
                of.mixed.push(Mixed { camera: s.camera, block });
                let square = by_pose.map(|a| by_pose.map(|b| weight * a.dot(b)));
                own.push((s.camera, square, by_pose.map(|c| weight * c.dot(e))));
            }
            (of, own)
        };
        let mut cameras = vec![([[0.0; 6]; 6], [0.0; 6]); self.cameras.len()];
        let mut points = Vec::with_capacity(self.points.len());
        for (of, own) in self.points.par_iter().zip(&self.seen).map(one).collect::<Vec<_>>() {
            for (c, square, gradient) in own {
                let (sum, g) = &mut cameras[c];
                for k in 0..6 {
                    g[k] += gradient[k];
                    (0..6).for_each(|l| sum[k][l] += square[k][l]);
                }
            }
            points.push(of);
        }
        Normal { points, cameras }
    }

    /// Poses and points after one damped step.
    fn stepped(&self, normal: &Normal, damping: f64) -> (Vec<Pose>, Vec<DVec3>) {
        let held = |m: DMat3| {
            let diagonal = DVec3::new(m.x_axis.x, m.y_axis.y, m.z_axis.z);
            (m + DMat3::from_diagonal(diagonal * damping + DVec3::splat(1e-12))).inverse()
        };
        let inverses: Vec<DMat3> = normal.points.iter().map(|p| held(p.normal)).collect();
        let own: Vec<[Six; 6]> = normal
            .cameras
            .iter()
            .map(|(m, _)| {
                let mut m = *m;
                (0..6).for_each(|k| m[k][k] += damping * m[k][k] + 1e-12);
                m
            })
            .collect();
        let over_points = |add: &(dyn Fn(&OfPoint, &DMat3, &mut [Six]) + Sync)| -> Vec<Six> {
            let parts: Vec<Vec<Six>> = normal
                .points
                .par_chunks(CHUNK)
                .zip(inverses.par_chunks(CHUNK))
                .map(|(points, inverses)| {
                    let mut sums = vec![[0.0; 6]; own.len()];
                    points.iter().zip(inverses).for_each(|(p, i)| add(p, i, &mut sums));
                    sums
                })
                .collect();
            let mut all = vec![[0.0; 6]; own.len()];
            for part in parts {
                all.as_flattened_mut().iter_mut().zip(part.as_flattened()).for_each(|(a, b)| *a += b);
            }
            all
        };
        let spread = |p: &OfPoint, v: DVec3, sums: &mut [Six]| {
            for m in &p.mixed {
                (0..6).for_each(|k| sums[m.camera][k] += m.block[k].dot(v));
            }
        };
        let gathered = |p: &OfPoint, x: &[Six]| -> DVec3 {
            p.mixed.iter().map(|m| (0..6).map(|k| m.block[k] * x[m.camera][k]).sum::<DVec3>()).sum()
        };
        // (C − E P⁻¹ Eᵀ) x = −(c − E P⁻¹ p).
        let through = over_points(&|p, inverse, sums| spread(p, *inverse * p.gradient, sums));
        let right: Vec<Six> =
            normal.cameras.iter().zip(&through).map(|((_, g), t)| std::array::from_fn(|k| t[k] - g[k])).collect();
        let times = |x: &[Six]| -> Vec<Six> {
            let through = over_points(&|p, inverse, sums| spread(p, *inverse * gathered(p, x), sums));
            let row = |(i, t): (usize, Six)| {
                std::array::from_fn(|k| (0..6).map(|l| own[i][k][l] * x[i][l]).sum::<f64>() - t[k])
            };
            through.into_iter().enumerate().map(row).collect()
        };
        // Each camera's own block of it, factored.
        let mut blocks = own.clone();
        for (p, inverse) in normal.points.iter().zip(&inverses) {
            for m in &p.mixed {
                for (row, own) in blocks[m.camera].iter_mut().zip(&m.block) {
                    let through = *inverse * *own;
                    row.iter_mut().zip(&m.block).for_each(|(sum, b)| *sum -= through.dot(*b));
                }
            }
        }
        let factors: Vec<Option<[Six; 6]>> = blocks.iter().map(cholesky).collect();
        let eased = |r: &[Six]| -> Vec<Six> {
            r.iter().zip(&factors).map(|(r, f)| f.as_ref().map_or(*r, |f| solved(f, r))).collect()
        };
        let turn = conjugate_gradients(&right, times, eased);
        let cameras = self.cameras.iter().zip(&turn).map(|(c, by)| moved(c, by)).collect();
        let points = self
            .points
            .iter()
            .zip(normal.points.iter().zip(&inverses))
            .map(|(at, (p, inverse))| *at - *inverse * (p.gradient + gathered(p, &turn)))
            .collect();
        (cameras, points)
    }
}

/// Rows of a matrix given by its columns.
fn rows(columns: &[DVec2; 3]) -> [DVec3; 2] {
    [0, 1].map(|k| DVec3::new(columns[0][k], columns[1][k], columns[2][k]))
}

/// p' = exp(ω)·p + v after the pose.
fn moved((rotation, translation): &Pose, by: &Six) -> Pose {
    let turn = DQuat::from_scaled_axis(DVec3::new(by[3], by[4], by[5]));
    ((turn * *rotation).normalize(), turn * *translation + DVec3::new(by[0], by[1], by[2]))
}

/// Huber's.
fn cost(errors: &[f64], bound: f64) -> f64 {
    errors.iter().map(|e| if *e <= bound { e * e } else { bound * (2.0 * e - bound) }).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::photos::reprojection::tests::{error, poses, set};
    use crate::splat::train::random::Random;

    /// Turns and shifts every pose, as a receiver and a compass would.
    fn disturbed(mut all: Poses) -> Poses {
        let mut random = Random::new(8);
        let mut normal = move || f64::from(random.normal());
        for p in &mut all.photos {
            let by: Six = std::array::from_fn(|k| normal() * if k < 3 { 0.03 } else { 0.01 });
            (p.rotation, p.translation) = moved(&(p.rotation, p.translation), &by);
        }
        all
    }

    #[test]
    fn poses_that_are_off_come_back_up_to_where_the_world_lies() {
        let truth = set(0.0);
        let off = disturbed(truth.clone());
        let before = error(&off, &poses(&off), |_| true).unwrap();
        assert!(before.rms > 1.0, "{before:?}");
        let found = adjusted(&off, |_| true).unwrap();
        let after = error(&off, &found.poses, |_| true).unwrap();
        assert!(after.rms < 1e-3, "{after:?}");
        // Angles between cameras do not depend on the world's frame.
        for k in 1..6 {
            let between = |p: &[Pose]| p[0].0 * p[k].0.inverse();
            let apart = between(&found.poses).angle_between(between(&poses(&truth)));
            assert!(apart < 1e-4, "{k}: {apart}");
        }
    }

    #[test]
    fn noise_stays_and_gross_errors_count_little() {
        let mut all = set(0.3);
        let clean = error(&all, &poses(&all), |_| true).unwrap();
        for o in all.observations.iter_mut().step_by(31) {
            o.at[0] += 40.0;
        }
        let truth = all.clone();
        let found = adjusted(&disturbed(all), |_| true).unwrap();
        let after = error(&truth, &found.poses, |_| true).unwrap();
        assert!(after.median < 1.3 * clean.median, "{after:?} {clean:?}");
        for k in 1..6 {
            let between = |p: &[Pose]| p[0].0 * p[k].0.inverse();
            let apart = between(&found.poses).angle_between(between(&poses(&truth)));
            // By noise alone one or two thousandths; gross errors that count in full would make it a hundredth, by estimate.
            assert!(apart < 5e-3, "{k}: {apart}");
        }
    }

    #[test]
    fn only_what_may_move_moves_and_too_little_is_refused() {
        let all = disturbed(set(0.0));
        let found = adjusted(&all, |k| k != 4).unwrap();
        assert_eq!(found.poses[4], poses(&all)[4]);
        assert_ne!(found.poses[3], poses(&all)[3]);
        assert!(adjusted(&all, |k| k == 4).is_none());
        let mut few = all.clone();
        few.observations.truncate(8);
        assert!(adjusted(&few, |_| true).is_none());
        assert_eq!(common(&all, |_| true), Common { observations: 480, points: 80 });
        assert_eq!(common(&all, |k| k == 4), Common::default());
    }

    #[test]
    fn a_photo_of_few_common_points_stays_and_few_points_move_none() {
        let all = disturbed(set(0.3));
        let of = |keep: &dyn Fn(&Observation) -> bool| {
            let mut some = all.clone();
            some.observations.retain(keep);
            some
        };
        // One photo shows seven points that others show, the others all.
        let one = of(&|o| o.photo != 2 || o.point < 7);
        let found = adjusted(&one, |_| true).unwrap();
        assert_eq!(found.moved, [true, true, false, true, true, true]);
        assert_eq!(found.poses[2], poses(&all)[2]);
        // Six photos of 29 points, all of them in all photos: numbers enough, but too few in each.
        assert!(adjusted(&of(&|o| o.point < 29), |_| true).is_none());
        assert!(adjusted(&of(&|o| o.point < 30), |_| true).is_some());
        // Two groups that have nothing in common but seven points.
        let two = of(&|o| o.point < 7 || (o.point < 40) == (o.photo < 4));
        let found = adjusted(&two, |_| true).unwrap();
        assert_eq!(found.moved, [true, true, true, true, false, false]);
        // A chain, ten points a pair: no photo shows enough.
        let chain = of(&|o| o.point / 10 == o.photo || o.point / 10 + 1 == o.photo);
        assert_eq!(common(&chain, |_| true).points, 50);
        assert!(adjusted(&chain, |_| true).is_none());
    }
}
