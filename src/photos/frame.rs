//! The subject's frame in the cameras' world: its middle and size from the silhouettes, up from how the cameras were held and
//! from the ground's points.

use glam::{DMat3, DQuat, DVec3};

use super::Posed;
use super::crops::Crop;
use crate::geo::similarity::{Similarity, symmetric_eigen};
use crate::splat::train::random::Random;

/// Where up comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpBy {
    /// The cameras' positions on the Earth.
    Georegistration,
    /// A plane through the points under the subject.
    Ground,
    /// Cameras are held level: their own x axes lie in one plane.
    Cameras,
}

impl UpBy {
    pub fn label(self) -> &'static str {
        match self {
            UpBy::Georegistration => "georegistration",
            UpBy::Ground => "plane through the ground's points",
            UpBy::Cameras => "cameras held level",
        }
    }
}

/// The point nearest to lines, each through a place along a unit direction, of the least squares of the distances. `None`
/// where they are all but parallel.
pub fn nearest_to_lines(lines: impl Iterator<Item = (DVec3, DVec3)>) -> Option<DVec3> {
    let (mut a, mut b, mut n) = (DMat3::ZERO, DVec3::ZERO, 0.0);
    for (through, along) in lines {
        let across = DMat3::IDENTITY - DMat3::from_cols(along * along.x, along * along.y, along * along.z);
        a += across;
        b += across * through;
        n += 1.0;
    }
    // The smallest eigenvalue of the mean is the mean squared sine to the lines' common direction.
    let (values, _) = symmetric_eigen([0, 1, 2].map(|i| [0, 1, 2].map(|j| a.col(j)[i] / f64::max(n, 1.0))));
    let least = values.into_iter().fold(f64::INFINITY, f64::min);
    (least > 0.003).then(|| a.inverse() * b)
}

/// What the photos look at: the point nearest to their optical axes; where those are parallel, the points' middle.
pub fn looked_at(photos: &[Posed], points: &[(DVec3, [u8; 3])]) -> Option<DVec3> {
    let axis = |p: &Posed| (p.centre(), p.rotation.inverse() * DVec3::Z);
    let in_front = |at: DVec3| {
        let n = photos.iter().filter(|p| p.pixel(at).is_some()).count();
        2 * n > photos.len()
    };
    nearest_to_lines(photos.iter().map(axis)).filter(|p| in_front(*p)).or_else(|| {
        let median = |k: usize| {
            let mut all: Vec<f64> = points.iter().map(|(p, _)| p[k]).collect();
            all.sort_by(f64::total_cmp);
            all.get(all.len() / 2).copied()
        };
        Some(DVec3::new(median(0)?, median(1)?, median(2)?)).filter(|p| in_front(*p))
    })
}

/// Up as the cameras were held: across all their x axes (level cameras have theirs in the horizontal plane), on the side of
/// their own tops; where all look the same way, those tops' mean. Unit length.
pub fn up_of_cameras(rotations: impl Iterator<Item = DQuat> + Clone) -> DVec3 {
    let mut across = [[0.0; 3]; 3];
    let mut tops = DVec3::ZERO;
    let mut n = 0.0;
    for r in rotations {
        let x = r.inverse() * DVec3::X;
        tops -= r.inverse() * DVec3::Y;
        n += 1.0;
        for i in 0..3 {
            for j in 0..3 {
                across[i][j] += x[i] * x[j];
            }
        }
    }
    let (values, vectors) = symmetric_eigen(across);
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let tops = tops.normalize_or(DVec3::Z);
    let axis = DVec3::from_array(std::array::from_fn(|i| vectors[i][order[0]])).normalize_or(tops);
    let axis = if axis.dot(tops) < 0.0 { -axis } else { axis };
    // The second: how far the x axes spread within their plane.
    if values[order[1]] < 0.02 * n || axis.dot(tops) < 0.3 { tops } else { axis }
}

/// A plane of the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// Unit length, up.
    pub normal: DVec3,
    /// normal · p of its points.
    pub height: f64,
    /// Points within 2 % of the radius, and all that were looked at.
    pub on_it: usize,
    pub of: usize,
}

/// The plane that holds most of the points around a subject (RANSAC, Fischler and Bolles 1981; then least squares), where
/// it is plain: a third of the points at least, within 20° of `up`, and hardly anything below.
pub fn ground(points: &[(DVec3, [u8; 3])], middle: DVec3, radius: f64, up: DVec3, seed: u64) -> Option<Ground> {
    let near: Vec<DVec3> = points.iter().map(|(p, _)| *p).filter(|p| p.distance(middle) < 5.0 * radius).collect();
    if near.len() < 50 {
        return None;
    }
    let slack = 0.02 * radius;
    let mut random = Random::new(seed);
    let mut pick = || near[(random.next() % near.len() as u64) as usize];
    let on = |normal: DVec3, height: f64| near.iter().filter(move |p| (normal.dot(**p) - height).abs() < slack);
    let mut best: Option<(usize, DVec3, f64)> = None;
    for _ in 0..400 {
        let (a, b, c) = (pick(), pick(), pick());
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let normal = if normal.dot(up) < 0.0 { -normal } else { normal };
        if normal.dot(up) < 20f64.to_radians().cos() {
            continue;
        }
        let count = on(normal, normal.dot(a)).count();
        if best.is_none_or(|(most, ..)| count > most) {
            best = Some((count, normal, normal.dot(a)));
        }
    }
    let (_, mut normal, mut height) = best?;
    for _ in 0..3 {
        let inliers: Vec<DVec3> = on(normal, height).copied().collect();
        let mean = inliers.iter().sum::<DVec3>() / inliers.len().max(1) as f64;
        let mut scatter = [[0.0; 3]; 3];
        for p in &inliers {
            let d = *p - mean;
            (0..3).for_each(|i| (0..3).for_each(|j| scatter[i][j] += d[i] * d[j]));
        }
        let (values, vectors) = symmetric_eigen(scatter);
        let least = (0..3).min_by(|a, b| values[*a].total_cmp(&values[*b]))?;
        let fitted = DVec3::from_array(std::array::from_fn(|i| vectors[i][least])).normalize_or_zero();
        normal = if fitted.dot(up) < 0.0 { -fitted } else { fitted };
        height = normal.dot(mean);
    }
    let on_it = on(normal, height).count();
    let below = near.iter().filter(|p| normal.dot(**p) < height - 3.0 * slack).count();
    let plain = 3 * on_it >= near.len() && 10 * below < near.len() && normal.dot(up) > 20f64.to_radians().cos();
    plain.then_some(Ground { normal, height, on_it, of: near.len() })
}

/// Middle and radius of a ball around the subject, from its boxes in the crops. `None` where the rays do not meet.
pub fn ball(crops: &[Crop]) -> Option<(DVec3, f64)> {
    let whole: Vec<&Crop> = crops.iter().filter(|c| !c.cut_off).collect();
    let used: Vec<&Crop> = if whole.len() >= 2 { whole } else { crops.iter().collect() };
    let middle_of = |c: &Crop| [(c.bounds[0] + c.bounds[2]) / 2.0, (c.bounds[1] + c.bounds[3]) / 2.0];
    let middle = nearest_to_lines(used.iter().map(|c| (c.centre(), c.ray(middle_of(c)))))?;
    let mut radii: Vec<f64> = used
        .iter()
        .map(|c| {
            let half = (c.bounds[2] - c.bounds[0]).hypot(c.bounds[3] - c.bounds[1]) / 2.0;
            half / c.inside[0] * c.centre().distance(middle)
        })
        .collect();
    radii.sort_by(f64::total_cmp);
    let radius = radii.get(radii.len() * 3 / 4).copied()?;
    (radius.is_finite() && radius > 0.0).then_some((middle, radius))
}

/// World → the unit frame: `radius` becomes 1, `middle` the origin, `up` +Z, and +Y points where a camera at `eye` looks at
/// the middle, horizontally; one that looks straight down, where its top points.
pub fn unit(middle: DVec3, radius: f64, up: DVec3, eye: DVec3, top: DVec3) -> Similarity {
    let flat = |v: DVec3| v - up * up.dot(v);
    let ahead = flat(middle - eye);
    let ahead = if ahead.length() < 0.05 * middle.distance(eye) { flat(top) } else { ahead };
    let y = ahead.try_normalize().unwrap_or_else(|| up.any_orthonormal_vector());
    let x = y.cross(up);
    let rotation = DQuat::from_mat3(&DMat3::from_cols(x, y, up).transpose()).normalize();
    let scale = radius.recip();
    Similarity { scale, rotation, translation: -scale * (rotation * middle) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Level cameras around a point, the world turned by `turn`.
    fn around(turn: DQuat, middle: DVec3) -> Vec<(DQuat, DVec3)> {
        (0..8)
            .map(|i| {
                let a = f64::from(i) * 0.8;
                let eye = 6.0 * DVec3::new(a.cos(), a.sin(), 0.3 + 0.1 * f64::from(i % 3));
                let c = crate::splat::Camera::look_at(eye.as_vec3(), glam::Vec3::ZERO, 0.6, 64);
                let rotation = DQuat::from_mat3(&DMat3::from_cols_array(&c.rotation.to_cols_array().map(f64::from)));
                (rotation.normalize() * turn.inverse(), turn * eye + middle)
            })
            .collect()
    }

    #[test]
    fn up_and_middle_come_from_the_cameras() {
        let turn = DQuat::from_euler(glam::EulerRot::XYZ, 1.1, 0.4, -2.0);
        let middle = DVec3::new(30.0, -20.0, 11.0);
        let cameras = around(turn, middle);
        let up = up_of_cameras(cameras.iter().map(|c| c.0));
        assert!(up.angle_between(turn * DVec3::Z) < 1e-5, "{up}");
        let found = nearest_to_lines(cameras.iter().map(|(r, c)| (*c, r.inverse() * DVec3::Z))).unwrap();
        assert!(found.distance(middle) < 1e-4, "{found}");
        // One alone, and parallel ones, meet nowhere.
        assert!(nearest_to_lines(cameras[..1].iter().map(|(r, c)| (*c, r.inverse() * DVec3::Z))).is_none());
        let to = unit(middle, 2.0, up, cameras[0].1, turn * DVec3::Z);
        let eye = to.apply(cameras[0].1);
        assert!(to.apply(middle).length() < 1e-9 && eye.x.abs() < 1e-5 && eye.y < -2.0 && eye.z > 0.5, "{eye}");
    }

    #[test]
    fn the_ground_is_found_under_clutter_and_not_in_a_cloud() {
        let turn = DQuat::from_euler(glam::EulerRot::XYZ, 0.3, -0.8, 0.2);
        let up = turn * DVec3::Z;
        let mut random = Random::new(3);
        let mut spread = |n: usize, flat: bool| -> Vec<(DVec3, [u8; 3])> {
            (0..n)
                .map(|_| {
                    let mut v = || f64::from(random.uniform()) * 6.0 - 3.0;
                    let (x, y, z) = (v(), v(), v());
                    let z = if flat { -1.0 + 0.003 * z } else { z.abs() - 1.0 };
                    (turn * DVec3::new(x, y, z), [0; 3])
                })
                .collect()
        };
        let mut points = spread(200, true);
        points.extend(spread(120, false));
        let tilted = DQuat::from_axis_angle(turn * DVec3::X, 0.1) * up;
        let g = ground(&points, DVec3::ZERO, 1.0, tilted, 7).unwrap();
        assert!(g.normal.angle_between(up).to_degrees() < 0.3 && (g.height + 1.0).abs() < 0.01, "{g:?}");
        assert!(ground(&spread(300, false), DVec3::ZERO, 1.0, up, 7).is_none());
        assert!(ground(&points[..20], DVec3::ZERO, 1.0, up, 7).is_none());
    }
}
