//! Similarities in three dimensions, f64, and the one that maps points best onto others.

use glam::{DMat3, DQuat, DVec3};

/// p → scale · rotation · p + translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Similarity {
    pub scale: f64,
    pub rotation: DQuat,
    pub translation: DVec3,
}

impl Similarity {
    pub const IDENTITY: Similarity = Similarity { scale: 1.0, rotation: DQuat::IDENTITY, translation: DVec3::ZERO };

    pub fn apply(&self, p: DVec3) -> DVec3 {
        self.scale * (self.rotation * p) + self.translation
    }

    #[must_use]
    pub fn inverse(&self) -> Similarity {
        let rotation = self.rotation.inverse();
        let scale = self.scale.recip();
        Similarity { scale, rotation, translation: -scale * (rotation * self.translation) }
    }

    /// First `self`, then `next`.
    #[must_use]
    pub fn then(&self, next: &Similarity) -> Similarity {
        Similarity {
            scale: self.scale * next.scale,
            rotation: (next.rotation * self.rotation).normalize(),
            translation: next.apply(self.translation),
        }
    }
}

/// As records have it: every digit of an f64.
impl std::fmt::Display for Similarity {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (DQuat { x, y, z, w }, t) = (self.rotation, self.translation);
        write!(f, "scale {} rotation xyzw {x} {y} {z} {w} translation {} {} {}", self.scale, t.x, t.y, t.z)
    }
}

/// A point in both frames, and one standard deviation of where `to` says it is, per axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    pub from: DVec3,
    pub to: DVec3,
    pub sigma: f64,
}

/// What a fit may turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Any rotation: three points that are not in a line at least.
    Free,
    /// About Z alone, +Z being up in both frames: two points that are not above each other at least.
    AboutUp,
}

/// The similarity of the least weighted squares (S. Umeyama, "Least-squares estimation of transformation parameters between
/// two point patterns", PAMI 1991, eqs. 40–42; about Z alone the rotation is the angle of Σ w (x + iy)* (u + iv)).
/// `None` where the points leave it open.
pub fn fit(pairs: &[Pair], turn: Turn) -> Option<Similarity> {
    let weight = |p: &Pair| p.sigma.max(1e-9).powi(-2);
    let total: f64 = pairs.iter().map(weight).sum();
    if pairs.len() < 2 || !total.is_finite() {
        return None;
    }
    let mean = |of: fn(&Pair) -> DVec3| pairs.iter().map(|p| weight(p) * of(p)).sum::<DVec3>() / total;
    let (from, to) = (mean(|p| p.from), mean(|p| p.to));
    let spread: f64 = pairs.iter().map(|p| weight(p) * (p.from - from).length_squared()).sum::<f64>() / total;
    if spread.is_nan() || spread <= 1e-18 {
        return None;
    }
    // Σ = mean (to − to̅)(from − from̅)ᵀ.
    let mut covariance = DMat3::ZERO;
    for p in pairs {
        let (a, b) = (p.from - from, p.to - to);
        covariance += DMat3::from_cols(b * a.x, b * a.y, b * a.z) * (weight(p) / total);
    }
    let rotation = match turn {
        Turn::Free => nearest_rotation(covariance)?,
        Turn::AboutUp => {
            let cos = covariance.x_axis.x + covariance.y_axis.y;
            let sin = covariance.x_axis.y - covariance.y_axis.x;
            let flat: f64 = pairs.iter().map(|p| weight(p) * (p.from - from).truncate().length_squared()).sum();
            if flat / total < 1e-6 * spread || sin.hypot(cos) < 1e-12 * spread {
                return None;
            }
            DQuat::from_rotation_z(sin.atan2(cos))
        }
    };
    let along: f64 = pairs.iter().map(|p| weight(p) * (p.to - to).dot(rotation * (p.from - from))).sum::<f64>() / total;
    let scale = along / spread;
    (scale.is_finite() && scale > 0.0).then(|| Similarity {
        scale,
        rotation,
        translation: to - scale * (rotation * from),
    })
}

/// The rotation R with the largest trace of Rᵀ M: of the quaternion that is the eigenvector of the largest eigenvalue of
/// Horn's matrix (B. K. P. Horn, "Closed-form solution of absolute orientation using unit quaternions", JOSA A 1987, eq. 34).
/// `None` where the two largest are alike: the points lie on a line.
fn nearest_rotation(m: DMat3) -> Option<DQuat> {
    // S = Σ a bᵀ in Horn's words: rows from, columns to.
    let s = |i: usize, j: usize| m.col(i)[j];
    let n = [
        [s(0, 0) + s(1, 1) + s(2, 2), s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0)],
        [s(1, 2) - s(2, 1), s(0, 0) - s(1, 1) - s(2, 2), s(0, 1) + s(1, 0), s(2, 0) + s(0, 2)],
        [s(2, 0) - s(0, 2), s(0, 1) + s(1, 0), s(1, 1) - s(0, 0) - s(2, 2), s(1, 2) + s(2, 1)],
        [s(0, 1) - s(1, 0), s(2, 0) + s(0, 2), s(1, 2) + s(2, 1), s(2, 2) - s(0, 0) - s(1, 1)],
    ];
    let (values, vectors) = symmetric_eigen(n);
    let mut order = [0, 1, 2, 3];
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    let [best, second, ..] = order;
    if values[best] - values[second] < 1e-9 * values[best].abs().max(1e-300) {
        return None;
    }
    let [w, x, y, z] = std::array::from_fn(|i| vectors[i][best]);
    Some(DQuat::from_xyzw(x, y, z, w).normalize())
}

/// Eigenvalues and eigenvectors (columns) of a symmetric matrix, by Jacobi's rotations (Golub and Van Loan 2013, §8.5).
pub fn symmetric_eigen<const N: usize>(mut a: [[f64; N]; N]) -> ([f64; N], [[f64; N]; N]) {
    let mut v: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    for _ in 0..60 {
        let off: f64 = (0..N).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| a[i][j] * a[i][j]).sum();
        let size: f64 = a.iter().flatten().map(|x| x * x).sum();
        if off <= 1e-32 * size {
            break;
        }
        for p in 0..N {
            for q in p + 1..N {
                if a[p][q] == 0.0 {
                    continue;
                }
                let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
                let t = if theta == 0.0 { 1.0 } else { t };
                let c = (t * t + 1.0).sqrt().recip();
                let s = t * c;
                for row in &mut a {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
                let (rp, rq) = (a[p], a[q]);
                a[p] = std::array::from_fn(|k| c * rp[k] - s * rq[k]);
                a[q] = std::array::from_fn(|k| s * rp[k] + c * rq[k]);
                for row in &mut v {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
            }
        }
    }
    (std::array::from_fn(|i| a[i][i]), v)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn truth() -> Similarity {
        Similarity {
            scale: 3.7,
            rotation: DQuat::from_euler(glam::EulerRot::ZYX, 2.1, -0.4, 0.9),
            translation: DVec3::new(1e5, -3e4, 250.0),
        }
    }

    fn points() -> Vec<DVec3> {
        (0..9u32)
            .map(|i| DVec3::new((f64::from(i) * 1.3).sin() * 4.0, f64::from(i) - 4.0, f64::from(i * i % 7)))
            .collect()
    }

    fn pairs(by: &Similarity) -> Vec<Pair> {
        points().into_iter().map(|p| Pair { from: p, to: by.apply(p), sigma: 1.0 + p.x.abs() }).collect()
    }

    #[test]
    fn the_similarity_is_found_again() {
        let t = truth();
        let found = fit(&pairs(&t), Turn::Free).unwrap();
        assert!((found.scale - t.scale).abs() < 1e-9 && found.rotation.angle_between(t.rotation) < 1e-7);
        assert!(points().iter().all(|p| found.apply(*p).distance(t.apply(*p)) < 1e-7));
        let upright = Similarity { rotation: DQuat::from_rotation_z(-2.9), ..t };
        let found = fit(&pairs(&upright), Turn::AboutUp).unwrap();
        assert!(points().iter().all(|p| found.apply(*p).distance(upright.apply(*p)) < 1e-7));
        let back = t.then(&t.inverse());
        assert!((back.scale - 1.0).abs() < 1e-12 && back.translation.length() < 1e-6);
    }

    #[test]
    fn points_that_leave_it_open_give_nothing() {
        let line: Vec<Pair> = (0..5)
            .map(|i| DVec3::new(f64::from(i), 0.0, 0.0))
            .map(|p| Pair { from: p, to: 2.0 * p, sigma: 1.0 })
            .collect();
        assert!(fit(&line, Turn::Free).is_none());
        assert!((fit(&line, Turn::AboutUp).unwrap().scale - 2.0).abs() < 1e-9);
        let tower: Vec<Pair> =
            (0..5).map(|i| DVec3::new(0.0, 0.0, f64::from(i))).map(|p| Pair { from: p, to: p, sigma: 1.0 }).collect();
        assert!(fit(&tower, Turn::AboutUp).is_none());
        assert!(fit(&line[..1], Turn::AboutUp).is_none());
    }
}
