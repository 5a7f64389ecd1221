//! Photos on the Earth: the similarity from their cameras' world to east, north, up, from the positions that the cameras wrote
//! and from ground control points; f64 throughout.
//!
//! Surveyed points decide where the scene stands, however many receivers say otherwise: what these are off by together is found
//! first and taken out ([`robust::receivers_off`]). Then outliers are named and least squares fitted over the rest ([`robust`]).

mod robust;

use glam::{DMat3, DVec3};

use crate::geo::similarity::{Pair, Similarity, Turn, symmetric_eigen};
use crate::geo::{Enu, Geodetic};

/// A point of the cameras' world with its place on the Earth.
#[derive(Clone, Debug, PartialEq)]
pub struct Fix {
    /// The photo's, or the control point's.
    pub name: String,
    pub at: DVec3,
    pub place: Geodetic,
    /// One standard deviation, metres.
    pub horizontal: f64,
    pub vertical: f64,
    /// Surveyed, not of the camera's receiver.
    pub control: bool,
}

/// How far the fit misses a fix: east, north, up, metres.
#[derive(Clone, Debug, PartialEq)]
pub struct Residual {
    pub name: String,
    pub enu: DVec3,
    pub control: bool,
    pub outlier: bool,
}

/// A frame on the Earth.
#[derive(Clone, Debug, PartialEq)]
pub struct Registration {
    /// From that frame (Z up) to east, north, up of `origin`, metres.
    pub to_enu: Similarity,
    pub origin: Geodetic,
    /// Of receivers without `receivers_off`.
    pub residuals: Vec<Residual>,
    /// How far the receivers' places lie from the control points together: east, north, up, metres. `None` without both.
    pub receivers_off: Option<DVec3>,
    /// One standard deviation: relative; degrees.
    pub scale_sigma: f64,
    pub heading_sigma: f64,
    /// What all fixes may be off together, metres: across, up.
    common: [f64; 2],
    /// Of the fit about `middle`, metres.
    middle: DVec3,
    middle_sigma: [f64; 2],
}

/// The part of a receiver's stated deviation that all photos of a flight share; the fit cannot see it. Assumed.
const COMMON: f64 = 0.5;
/// Many fixes are not believed to be better than this part of what they say.
const BELIEVED: f64 = 0.1;

/// The fixes in east, north, up of the median place.
struct Local {
    origin: Geodetic,
    pairs: Vec<Pair>,
}

fn local(fixes: &[Fix], to: &Similarity) -> Option<Local> {
    let median = |of: fn(&Fix) -> f64| {
        let mut all: Vec<f64> = fixes.iter().map(of).collect();
        all.sort_by(f64::total_cmp);
        all.get(all.len() / 2).copied()
    };
    let (lat, lon) = (median(|f| f.place.latitude)?, median(|f| f.place.longitude)?);
    let origin = Geodetic { latitude: lat, longitude: lon, height: median(|f| f.place.height)? };
    let frame = origin.frame();
    let pairs = fixes
        .iter()
        .map(|f| {
            let e = frame.to_enu(f.place.to_ecef());
            let sigma = ((2.0 * f.horizontal.powi(2) + f.vertical.powi(2)) / 3.0).sqrt();
            Pair { from: to.apply(f.at), to: DVec3::new(e.east, e.north, e.up), sigma }
        })
        .collect();
    Some(Local { origin, pairs })
}

/// Covariance of (shift, log scale, turn about x, y, z) of a fit about the middle of its fixes, in the order of the unknowns
/// that `turn` has; metres, one, radians.
struct Known {
    middle: DVec3,
    shift: [f64; 2],
    scale: f64,
    turn: DVec3,
}

fn known(fixes: &[Fix], pairs: &[Pair], s: &Similarity, kept: &[bool], turn: Turn) -> Known {
    let rows: Vec<(DVec3, DVec3, &Fix)> = pairs
        .iter()
        .zip(fixes)
        .zip(kept)
        .filter(|(_, k)| **k)
        .map(|((p, f), _)| (s.apply(p.from), s.apply(p.from) - p.to, f))
        .collect();
    let n = rows.len().max(1) as f64;
    let middle = rows.iter().map(|r| r.0).sum::<DVec3>() / n;
    let reach = (rows.iter().map(|r| r.0.distance_squared(middle)).sum::<f64>() / n).sqrt().max(1e-9);
    // Lengths in `reach`, so that all unknowns are alike.
    let mut normal = [[0.0; 7]; 7];
    let mut square = 0.0;
    for (at, off, f) in &rows {
        let d = (*at - middle) / reach;
        let lines = [
            ([1.0, 0.0, 0.0, d.x, 0.0, d.z, -d.y], f.horizontal / reach, off.x / reach),
            ([0.0, 1.0, 0.0, d.y, -d.z, 0.0, d.x], f.horizontal / reach, off.y / reach),
            ([0.0, 0.0, 1.0, d.z, d.y, -d.x, 0.0], f.vertical / reach, off.z / reach),
        ];
        for (j, sigma, r) in lines {
            let w = sigma.max(1e-9).powi(-2);
            square += w * r * r;
            for a in 0..7 {
                for b in 0..7 {
                    normal[a][b] += w * j[a] * j[b];
                }
            }
        }
    }
    let (unknowns, held): (f64, &[usize]) = if turn == Turn::Free { (7.0, &[]) } else { (5.0, &[4, 5]) };
    for &a in held {
        // Not turned about x and y.
        normal.iter_mut().for_each(|row| row[a] = 0.0);
        normal[a] = std::array::from_fn(|b| if a == b { 1e30 } else { 0.0 });
    }
    let (values, vectors) = symmetric_eigen(normal);
    let variance = |i: usize| (0..7).map(|k| vectors[i][k].powi(2) / values[k].max(1e-12)).sum::<f64>();
    // Many residuals know their own size; few are believed only where they are larger than was said.
    let free = 3.0 * n - unknowns;
    let unit = if free > 0.0 { square / free } else { 1.0 };
    let factor = if free < 9.0 { unit.max(1.0) } else { unit.max(BELIEVED.powi(2)) };
    let sigma = |i: usize| (variance(i) * factor).sqrt();
    Known {
        middle,
        shift: [sigma(0).hypot(sigma(1)) / std::f64::consts::SQRT_2 * reach, sigma(2) * reach],
        scale: sigma(3),
        turn: DVec3::new(sigma(4), sigma(5), sigma(6)),
    }
}

/// Up in the cameras' world and its standard deviation, degrees, where the fixes leave it no choice.
pub fn up(fixes: &[Fix], seed: u64) -> Option<(DVec3, f64)> {
    let mut l = local(fixes, &Similarity::IDENTITY)?;
    robust::receivers_off(fixes, &mut l.pairs, Turn::Free, seed);
    let (s, kept) = robust::fit(fixes, &l.pairs, Turn::Free, seed)?;
    if kept.iter().filter(|k| **k).count() < 4 {
        return None;
    }
    let k = known(fixes, &l.pairs, &s, &kept, Turn::Free);
    Some((s.rotation.inverse() * DVec3::Z, k.turn.x.hypot(k.turn.y).to_degrees()))
}

/// A frame with Z up, to which `to` leads from the cameras' world, on the Earth. `None` where the fixes leave scale or
/// heading open.
pub fn register(fixes: &[Fix], to: &Similarity, seed: u64) -> Option<Registration> {
    let mut l = local(fixes, to)?;
    let receivers_off = robust::receivers_off(fixes, &mut l.pairs, Turn::AboutUp, seed);
    let (to_enu, kept) = robust::fit(fixes, &l.pairs, Turn::AboutUp, seed)?;
    let k = known(fixes, &l.pairs, &to_enu, &kept, Turn::AboutUp);
    let residual = |((f, p), kept): ((&Fix, &Pair), &bool)| Residual {
        name: f.name.clone(),
        enu: to_enu.apply(p.from) - p.to,
        control: f.control,
        outlier: !kept,
    };
    // What a receiver is off all flight long; surveyed points have no such part.
    let inliers = || fixes.iter().zip(&kept).filter(|(_, k)| **k).map(|(f, _)| f);
    let by_receiver = inliers().all(|f| !f.control);
    let mean = |of: fn(&Fix) -> f64| inliers().map(of).sum::<f64>() / inliers().count().max(1) as f64;
    let common =
        if by_receiver { [mean(|f| f.horizontal), mean(|f| f.vertical)].map(|v| COMMON * v) } else { [0.0; 2] };
    Some(Registration {
        residuals: fixes.iter().zip(&l.pairs).zip(&kept).map(residual).collect(),
        receivers_off,
        to_enu,
        origin: l.origin,
        scale_sigma: k.scale,
        heading_sigma: k.turn.z.to_degrees(),
        common,
        middle: k.middle,
        middle_sigma: k.shift,
    })
}

impl Registration {
    /// Bearing of the frame's +Y, degrees clockwise from north, [0, 360).
    pub fn heading(&self) -> f64 {
        let y = self.to_enu.rotation * DVec3::Y;
        y.x.atan2(y.y).to_degrees().rem_euclid(360.0)
    }

    pub fn place(&self, p: DVec3) -> Geodetic {
        let at = self.to_enu.apply(p);
        self.origin.offset(Enu { east: at.x, north: at.y, up: at.z })
    }

    /// One standard deviation of that place, metres: across in any direction, up.
    pub fn sigma(&self, p: DVec3) -> [f64; 2] {
        let d = self.to_enu.apply(p) - self.middle;
        let across = d.truncate().length();
        // Scale moves it along, heading across: the mean of both over the directions.
        let turned = across * self.scale_sigma.hypot(self.heading_sigma.to_radians()) / std::f64::consts::SQRT_2;
        [
            self.middle_sigma[0].hypot(turned).hypot(self.common[0]),
            self.middle_sigma[1].hypot(d.z * self.scale_sigma).hypot(self.common[1]),
        ]
    }

    /// Root mean square of the residuals that count, metres: across, up.
    pub fn rms(&self) -> [f64; 2] {
        let kept: Vec<&Residual> = self.residuals.iter().filter(|r| !r.outlier).collect();
        let mean =
            |of: fn(&Residual) -> f64| (kept.iter().map(|r| of(r)).sum::<f64>() / kept.len().max(1) as f64).sqrt();
        [mean(|r| r.enu.truncate().length_squared()), mean(|r| r.enu.z * r.enu.z)]
    }

    /// What to tell the user where receivers and control points contradict each other by more than receivers are off, `deviations`
    /// of the fixes' own.
    pub fn contradiction(&self, fixes: &[Fix]) -> Option<String> {
        let off = self.receivers_off?;
        let receivers = || fixes.iter().filter(|f| !f.control);
        let most = |of: fn(&Fix) -> f64| receivers().map(of).fold(0.0, f64::max) * robust::OUTLIER;
        let (across, up) = (off.truncate().length(), off.z);
        (across > most(|f| f.horizontal) || up.abs() > most(|f| f.vertical)).then(|| {
            format!(
                "the photos' own places lie {across:.1} m beside and {up:+.1} m above the control points together; the control \
                 points are followed. Are heights of one kind above the ellipsoid and of the other above the geoid?"
            )
        })
    }

    pub fn outliers(&self) -> impl Iterator<Item = &Residual> {
        self.residuals.iter().filter(|r| r.outlier)
    }

    /// From the cameras' world to east, north, up: rows of a matrix of three by four, f64.
    pub fn matrix(&self, to: &Similarity) -> [[f64; 4]; 3] {
        let all = to.then(&self.to_enu);
        let turn = DMat3::from_quat(all.rotation) * all.scale;
        std::array::from_fn(|i| [turn.col(0)[i], turn.col(1)[i], turn.col(2)[i], all.translation[i]])
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;
    use crate::splat::train::random::Random;
    use glam::DQuat;

    /// Cameras around a point, their places with independent noise; the true similarity from the world to ENU of `home`.
    pub fn flight(n: u32, noise: [f64; 2], seed: u64) -> (Vec<Fix>, Similarity, Geodetic) {
        let home = Geodetic { latitude: 48.2, longitude: 11.6, height: 560.0 };
        let truth = Similarity {
            scale: 7.5,
            rotation: DQuat::from_rotation_z(0.8) * DQuat::from_euler(glam::EulerRot::XYZ, 2.0, -0.7, 0.3),
            translation: DVec3::new(12.0, -40.0, 6.0),
        };
        let back = truth.inverse();
        let mut random = Random::new(seed);
        let mut normal = |s: f64| s * f64::from(random.normal());
        let fixes = (0..n)
            .map(|i| {
                let a = f64::from(i) * 2.4;
                let at = DVec3::new(30.0 * a.cos(), 30.0 * a.sin(), 12.0 + 3.0 * f64::from(i % 4));
                let off = DVec3::new(normal(noise[0]), normal(noise[0]), normal(noise[1]));
                let seen = at + off;
                let place = home.offset(Enu { east: seen.x, north: seen.y, up: seen.z });
                let name = format!("{i:02}.jpg");
                Fix { name, at: back.apply(at), place, horizontal: 5.0, vertical: 10.0, control: false }
            })
            .collect();
        (fixes, truth, home)
    }

    /// The frame of the truth's world turned upright: what the pipeline's unit frame is.
    fn upright(truth: &Similarity) -> Similarity {
        Similarity {
            scale: 0.3,
            rotation: DQuat::from_rotation_z(-1.0) * truth.rotation,
            translation: DVec3::new(1.0, 2.0, 3.0),
        }
    }

    #[test]
    fn without_noise_everything_is_exact() {
        let (fixes, truth, home) = flight(8, [0.0; 2], 1);
        let to = upright(&truth);
        let r = register(&fixes, &to, 3).unwrap();
        let p = DVec3::new(0.4, -0.3, 0.2);
        let found = r.place(to.apply(p));
        let want = truth.apply(p);
        let off = home.local(found.to_ecef());
        assert!((off.east - want.x).hypot(off.north - want.y) < 1e-3 && (off.up - want.z).abs() < 1e-3, "{off:?}");
        // Curvature over thirty metres.
        assert!(r.outliers().count() == 0 && r.rms()[0] < 1e-4);
        assert!((r.to_enu.scale * to.scale / truth.scale - 1.0).abs() < 1e-6);
        let (up, sigma) = up(&fixes, 3).unwrap();
        assert!(up.angle_between(truth.rotation.inverse() * DVec3::Z).to_degrees() < 0.01 && sigma < 5.0, "{sigma}");
    }

    #[test]
    fn errors_are_as_large_as_is_said_and_outliers_are_named() {
        let mut in_sigmas = Vec::new();
        let mut scales = Vec::new();
        for seed in 0..40 {
            let (mut fixes, truth, home) = flight(16, [1.5, 3.0], 100 + seed);
            // A photo whose receiver had no fix, and one that kept an old one.
            fixes[3].place = fixes[3].place.offset(Enu { east: 60.0, north: -25.0, up: 0.0 });
            fixes[9].place = fixes[0].place;
            let to = upright(&truth);
            let r = register(&fixes, &to, 3).unwrap();
            let named: Vec<&str> = r.outliers().map(|o| o.name.as_str()).collect();
            assert!(named.contains(&"03.jpg") && named.contains(&"09.jpg") && named.len() <= 4, "{named:?}");
            let middle = truth.inverse().apply(DVec3::new(0.0, 0.0, 1.0));
            let off = home.local(r.place(to.apply(middle)).to_ecef());
            let sigma = r.sigma(to.apply(middle));
            // The receiver's common part is not in this noise.
            assert!(sigma[0] > 2.5 && sigma[0] < 4.5, "{sigma:?}");
            in_sigmas.push(off.east / r.middle_sigma[0]);
            in_sigmas.push(off.north / r.middle_sigma[0]);
            scales.push((r.to_enu.scale * to.scale / truth.scale - 1.0) / r.scale_sigma);
        }
        let rms = |v: &[f64]| (v.iter().map(|x| x * x).sum::<f64>() / v.len() as f64).sqrt();
        assert!((0.6..1.5).contains(&rms(&in_sigmas)), "{}", rms(&in_sigmas));
        assert!((0.6..1.6).contains(&rms(&scales)), "{}", rms(&scales));
    }

    /// Surveyed points on the ground among the cameras.
    fn surveyed(n: u32, truth: &Similarity, home: &Geodetic) -> Vec<Fix> {
        (0..n)
            .map(|i| {
                let at =
                    DVec3::new(f64::from(i * 17 % 31) - 15.0, f64::from(i * 11 % 23) - 11.0, 0.5 * f64::from(i % 3));
                let place = home.offset(Enu { east: at.x, north: at.y, up: at.z });
                let at = truth.inverse().apply(at);
                Fix { name: format!("P{i}"), at, place, horizontal: 0.02, vertical: 0.03, control: true }
            })
            .collect()
    }

    #[test]
    fn surveyed_points_decide_however_many_receivers_say_otherwise() {
        for points in [1, 2, 3, 4, 6] {
            let (mut fixes, truth, home) = flight(40, [1.5, 3.0], 7);
            // Heights above the geoid, taken for heights above the ellipsoid.
            for f in &mut fixes {
                f.place.height -= 100.0;
            }
            fixes.extend(surveyed(points, &truth, &home));
            let to = upright(&truth);
            let r = register(&fixes, &to, 3).unwrap();
            assert_eq!(r.outliers().count(), 0, "{points}: {:?}", r.outliers().collect::<Vec<_>>());
            let off = r.receivers_off.unwrap();
            assert!((off.z + 100.0).abs() < 3.0 && off.truncate().length() < 2.0, "{points}: {off:?}");
            assert!(r.contradiction(&fixes).unwrap().contains("-"), "{points}");
            let point = fixes.iter().find(|f| f.control).unwrap();
            let miss = home.local(r.place(to.apply(point.at)).to_ecef()).up - home.local(point.place.to_ecef()).up;
            assert!(miss.abs() < 0.05, "{points}: {miss}");
            assert!(r.sigma(to.apply(point.at))[1] < 0.5, "{points}: {:?}", r.sigma(to.apply(point.at)));
        }
        let (mut fixes, truth, home) = flight(16, [1.5, 3.0], 7);
        fixes.extend(surveyed(5, &truth, &home));
        let r = register(&fixes, &upright(&truth), 3).unwrap();
        assert!(r.contradiction(&fixes).is_none() && r.outliers().count() == 0);
    }

    #[test]
    fn a_surveyed_point_that_the_others_contradict_is_named() {
        let (mut fixes, truth, home) = flight(16, [1.5, 3.0], 9);
        let mut points = surveyed(6, &truth, &home);
        points[2].place = points[2].place.offset(Enu { east: 4.0, north: 0.0, up: 1.0 });
        fixes.extend(points);
        let to = upright(&truth);
        let r = register(&fixes, &to, 3).unwrap();
        assert_eq!(r.outliers().map(|o| o.name.as_str()).collect::<Vec<_>>(), ["P2"]);
        let miss = home.local(r.place(to.apply(fixes[16].at)).to_ecef());
        let want = home.local(fixes[16].place.to_ecef());
        assert!((miss.east - want.east).hypot(miss.north - want.north) < 0.1, "{miss:?} {want:?}");
    }

    #[test]
    fn what_the_fixes_leave_open_is_not_made_up() {
        let (fixes, truth, _) = flight(1, [0.0; 2], 1);
        assert!(register(&fixes, &upright(&truth), 3).is_none());
        let (mut fixes, truth, _) = flight(5, [0.0; 2], 1);
        for f in &mut fixes {
            f.at = fixes_at(&truth);
        }
        assert!(register(&fixes, &upright(&truth), 3).is_none());
        assert!(up(&fixes[..3], 3).is_none());
    }

    fn fixes_at(truth: &Similarity) -> DVec3 {
        truth.inverse().apply(DVec3::new(3.0, 4.0, 5.0))
    }
}
