//! A network's relative inverse depth brought to the scale of the prior's surface, and the surface moved to it.
//!
//! 1/z = a·d + b along each ray, a and b by iteratively reweighted least squares with Tukey's biweight (Beaton and Tukey
//! 1974; scale by the median absolute deviation), so that what one of the two sees wrongly has no say.

use crate::models::splat_prior::OneView;
use crate::photo::{Plane, Rect, sample_plane};
use crate::splat::{self, Camera};

/// Of the picture that both are compared on.
const GRID: u32 = 128;
/// No Gaussian moves farther, in radii of the subject.
const FARTHEST: f32 = 0.15;
/// Half the thickness of what counts as the front surface, in radii of the subject.
const SURFACE: f32 = 0.12;
/// Below this correlation on the inliers the two see different things: nothing is moved.
const LEAST_CORRELATION: f64 = 0.5;
/// Pixels that must be sure for the two to be compared at all.
const FEWEST: usize = 200;
/// Pixels from the mask's edge, where networks smear foreground into background.
const EDGE: usize = 3;

/// How the depths met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// 1/z = gain · d + shift, z in radii of the subject from the camera.
    pub gain: f64,
    pub shift: f64,
    /// Share of the pixels that have a say in it.
    pub inliers: f64,
    /// Of d and 1/z on them.
    pub correlation: f64,
    /// Gaussians that were moved.
    pub moved: usize,
}

/// The subject's front surface in metres, by a metric network.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Front {
    /// Median depth, metres along the optical axis.
    pub metres: f64,
    /// How far that surface lies before the subject's middle, in radii of the subject.
    pub before_middle: f64,
}

/// The prior's surface and the network's plane on one grid.
struct Compared {
    camera: Camera,
    seen: splat::Frame,
    d: Plane,
    /// Depth along the photo's optical axis, which `d` is of, over that along the camera's.
    deeper: Vec<f32>,
    /// Pixels on the subject, away from its edge.
    sure: Vec<bool>,
}

fn compare(view: &OneView, depth: &Plane, scale: (f32, f32)) -> Compared {
    let camera = view.camera.resized(GRID, GRID);
    let seen = splat::render(&view.gaussians, &camera, [0.0; 3]);
    let size = GRID as usize;
    let d = view.crop.plane(depth, scale, size, crate::photo::Edge::Clamp);
    let deeper: Vec<f32> = (0..size * size).map(|i| view.crop.deeper(i % size, i / size, size)).collect();
    let whole = Rect { x: 0.0, y: 0.0, width: view.mask.width as f32, height: view.mask.height as f32 };
    let mask = sample_plane(&view.mask, whole, size, size, crate::photo::Edge::Clamp);
    let sure = crate::models::region::eroded(size, size, EDGE, |i| mask.data[i] > 0.8 && seen.median_depth[i] > 0.0);
    Compared { camera, seen, d, deeper, sure }
}

/// Where a metric network sees the front of the subject; `depth`, `scale` as for [`move_front`], `range` the plane's 0 and 1
/// in 1 / metres. None where too few pixels are sure.
pub fn front(view: &OneView, depth: &Plane, scale: (f32, f32), range: (f32, f32)) -> Option<Front> {
    let Compared { camera, seen, d, deeper, sure } = compare(view, depth, scale);
    let metres = |i: usize| f64::from((range.0 + d.data[i] * (range.1 - range.0)) * deeper[i]).recip();
    let sure: Vec<usize> = (0..sure.len()).filter(|&i| sure[i] && metres(i).is_finite()).collect();
    if sure.len() < FEWEST {
        return None;
    }
    let median = |value: &dyn Fn(usize) -> f64| {
        let mut all: Vec<f64> = sure.iter().map(|&i| value(i)).collect();
        let middle = all.len() / 2;
        *all.select_nth_unstable_by(middle, f64::total_cmp).1
    };
    let middle = f64::from(camera.translation.z);
    let found = Front { metres: median(&metres), before_middle: median(&|i| middle - f64::from(seen.median_depth[i])) };
    (found.metres > 0.0).then_some(found)
}

/// Moves the front of the prior's Gaussians along the photo's rays to the depth network's surface.
///
/// `depth` is relative inverse depth over the whole photo; `scale`, photo pixels for one of its pixels. Returns none, and moves
/// nothing, where the two do not agree enough to be compared.
pub fn move_front(view: &mut OneView, depth: &Plane, scale: (f32, f32)) -> Option<Fit> {
    let Compared { camera, seen, d, deeper, sure } = compare(view, depth, scale);
    let size = GRID as usize;
    let pairs: Vec<(f64, f64)> = (0..size * size)
        .filter(|&i| sure[i])
        .map(|i| (f64::from(d.data[i]), 1.0 / f64::from(deeper[i] * seen.median_depth[i])))
        .collect();
    let mut fit = robust_line(&pairs)?;

    // Where each sure pixel's surface should go, smoothed so that noise in neither becomes relief.
    let shift = |i: usize| {
        let inverse = fit.gain * f64::from(d.data[i]) + fit.shift;
        let z = if inverse > 1e-3 { (1.0 / inverse) as f32 / deeper[i] } else { f32::INFINITY };
        (z - seen.median_depth[i]).clamp(-FARTHEST, FARTHEST)
    };
    let weight = crate::models::guided::box_mean(size, size, 2, |i| f32::from(u8::from(sure[i])));
    let sum = crate::models::guided::box_mean(size, size, 2, |i| if sure[i] { shift(i) } else { 0.0 });
    let g = &mut view.gaussians;
    let back = camera.rotation.transpose();
    for i in 0..g.len() {
        let p = camera.rotation * g.positions[i] + camera.translation;
        let (x, y) = (camera.fx * p.x / p.z + camera.cx, camera.fy * p.y / p.z + camera.cy);
        if p.z <= 0.0 || !(0.0..GRID as f32).contains(&x) || !(0.0..GRID as f32).contains(&y) {
            continue;
        }
        let at = y as usize * size + x as usize;
        let surface = seen.median_depth[at];
        // The fade keeps the skin behind the surface in one piece with it.
        let near = 1.0 - ((p.z - surface).abs() / SURFACE).min(1.0);
        if surface <= 0.0 || near <= 0.0 || weight.data[at] < 0.1 {
            continue;
        }
        let fade = weight.data[at].min(1.0) * (2.0 * near).min(1.0);
        let factor = 1.0 + fade * sum.data[at] / weight.data[at] / p.z;
        g.positions[i] = back * (p * factor - camera.translation);
        g.log_scales[i] += glam::Vec3::splat(factor.ln());
        fit.moved += 1;
    }
    Some(fit)
}

/// y = gain · x + shift; none where the pairs are few, flat, or disagree.
fn robust_line(pairs: &[(f64, f64)]) -> Option<Fit> {
    if pairs.len() < FEWEST {
        return None;
    }
    let mut weights = vec![1.0; pairs.len()];
    // Least absolute deviations first: from plain least squares the biweight can end between the crowd and its outliers.
    for _ in 0..20 {
        let (line, _) = least_squares(pairs, &weights)?;
        let residual = |(x, y): &(f64, f64)| (y - line.0 * x - line.1).abs();
        weights.iter_mut().zip(pairs).for_each(|(w, p)| *w = 1.0 / residual(p).max(1e-6));
    }
    for _ in 0..15 {
        let (line, _) = least_squares(pairs, &weights)?;
        let mut residuals: Vec<f64> = pairs.iter().map(|(x, y)| (y - line.0 * x - line.1).abs()).collect();
        for (w, r) in weights.iter_mut().zip(&residuals) {
            *w = *r;
        }
        let middle = residuals.len() / 2;
        let median = *residuals.select_nth_unstable_by(middle, f64::total_cmp).1;
        // 4.685 deviations keep 95% of the efficiency on normal noise.
        let reach = (4.685 * 1.4826 * median).max(1e-9);
        weights.iter_mut().for_each(|w| *w = (1.0 - (*w / reach).powi(2)).max(0.0).powi(2));
    }
    let ((gain, shift), correlation) = least_squares(pairs, &weights)?;
    let inliers = weights.iter().filter(|w| **w > 0.1).count() as f64 / pairs.len() as f64;
    (gain > 0.0 && correlation >= LEAST_CORRELATION && inliers >= 0.5).then_some(Fit {
        gain,
        shift,
        inliers,
        correlation,
        moved: 0,
    })
}

/// Slope, intercept and correlation.
fn least_squares(pairs: &[(f64, f64)], weights: &[f64]) -> Option<((f64, f64), f64)> {
    let mut s = [0.0; 6];
    for (&(x, y), &w) in pairs.iter().zip(weights) {
        [w, w * x, w * y, w * x * x, w * x * y, w * y * y].iter().zip(&mut s).for_each(|(v, s)| *s += v);
    }
    let [n, x, y, xx, xy, yy] = s;
    let (vx, vy, cov) = (xx - x * x / n, yy - y * y / n, xy - x * y / n);
    if n <= 0.0 || vx <= 1e-12 * n || vy <= 0.0 {
        return None;
    }
    let gain = cov / vx;
    Some(((gain, (y - gain * x) / n), cov / (vx * vy).sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::splat_prior::canonical_camera;
    use crate::splat::Gaussians;
    use glam::Vec3;

    /// A sheet of Gaussians facing the camera; `bulge(x, z)` says how far it comes to the eye.
    fn sheet(bulge: impl Fn(f32, f32) -> f32) -> Gaussians {
        let mut g = Gaussians::default();
        for i in 0..60 {
            for j in 0..60 {
                let (x, z) = ((i as f32 - 29.5) / 40.0, (j as f32 - 29.5) / 40.0);
                g.positions.push(Vec3::new(x, -bulge(x, z), z));
                g.log_scales.push(Vec3::splat(0.02f32.ln()));
                g.rotations.push([1.0, 0.0, 0.0, 0.0]);
                g.logit_opacities.push(3.0);
                g.sh.push(Default::default());
            }
        }
        g
    }

    fn view(gaussians: Gaussians) -> OneView {
        let camera = canonical_camera(0.0, 128);
        let mask = crate::models::align::silhouette(&gaussians, &camera);
        OneView {
            expected_errors: None,
            gaussians,
            elevation: 0.0,
            camera,
            seen_from: crate::models::scene::Angle { mean: 0.0, spread: 0.05 },
            silhouette_iou: 1.0,
            crop: crate::models::splat_prior::Window {
                rect: Rect { x: 10.0, y: 20.0, width: 128.0, height: 128.0 },
                turned: None,
            },
            colour: vec![[0.5; 3]; 128 * 128],
            mask,
        }
    }

    /// What a depth network would say of the sheet: affine to 1/z, on a photo of 150 × 160 at half its size.
    fn network(truth: &Gaussians, camera: &Camera) -> Plane {
        let seen = crate::splat::render(truth, camera, [0.0; 3]);
        let z = Plane { width: 128, height: 128, data: seen.median_depth };
        let rect = Rect { x: -10.0, y: -20.0, width: 150.0, height: 160.0 };
        let mut out = sample_plane(&z, rect, 75, 80, crate::photo::Edge::Clamp);
        out.data.iter_mut().for_each(|v| *v = if *v > 2.0 { 5.0 / *v - 0.9 } else { 0.0 });
        out
    }

    fn off(g: &Gaussians, bulge: impl Fn(f32, f32) -> f32) -> f32 {
        let inner = g.positions.iter().filter(|p| p.x.abs() < 0.5 && p.z.abs() < 0.5);
        let (sum, n) = inner.fold((0.0, 0), |(s, n), p| (s + (-p.y - bulge(p.x, p.z)).abs(), n + 1));
        sum / n as f32
    }

    #[test]
    fn a_wrong_front_moves_to_the_networks_surface() {
        let truth = |x: f32, z: f32| 0.25 * x + 0.1 * (4.0 * z).cos();
        let guess = |x: f32, _: f32| 0.25 * x;
        let camera = canonical_camera(0.0, 128);
        let depth = network(&sheet(truth), &camera);
        let mut view = view(sheet(guess));
        let before = off(&view.gaussians, truth);
        let fit = move_front(&mut view, &depth, (2.0, 2.0)).unwrap();
        let after = off(&view.gaussians, truth);
        assert!(fit.inliers > 0.5 && fit.correlation > 0.6 && fit.moved > 2000, "{fit:?}");
        assert!(after < 0.5 * before, "{before} → {after} by {fit:?}");
    }

    #[test]
    fn a_network_that_sees_something_else_moves_nothing() {
        let mut random = crate::splat::train::random::Random::new(3);
        let noise = Plane { width: 75, height: 80, data: (0..75 * 80).map(|_| random.uniform()).collect() };
        let mut view = view(sheet(|x, _| 0.25 * x));
        let before = view.gaussians.clone();
        assert_eq!(move_front(&mut view, &noise, (2.0, 2.0)), None);
        assert_eq!(view.gaussians, before);
    }

    #[test]
    fn a_metric_network_says_how_far_the_front_is() {
        let flat = sheet(|_, _| 0.2);
        let camera = canonical_camera(0.0, 128);
        let seen = crate::splat::render(&flat, &camera, [0.0; 3]);
        // Ten metres a radius, as inverse depth between 1/100 and 1 per metre.
        let z = Plane { width: 128, height: 128, data: seen.median_depth };
        let rect = Rect { x: -10.0, y: -20.0, width: 150.0, height: 160.0 };
        let mut plane = sample_plane(&z, rect, 75, 80, crate::photo::Edge::Clamp);
        plane.data.iter_mut().for_each(|v| *v = if *v > 2.0 { (0.1 / *v - 0.01) / 0.99 } else { 0.0 });
        let found = front(&view(flat), &plane, (2.0, 2.0), (0.01, 1.0)).unwrap();
        let middle = f64::from(camera.translation.z);
        assert!((found.before_middle - 0.2).abs() < 0.03, "{found:?}");
        assert!((found.metres / (10.0 * (middle - found.before_middle)) - 1.0).abs() < 1e-3, "{found:?}");
        let mut small = view(sheet(|_, _| 0.0));
        small.mask.data.fill(0.0);
        assert_eq!(front(&small, &plane, (2.0, 2.0), (0.01, 1.0)), None);
    }

    #[test]
    fn a_third_of_outliers_has_no_say() {
        let pairs: Vec<(f64, f64)> = (0..900)
            .map(|i| {
                let x = f64::from(i) / 900.0;
                (x, if i % 3 == 0 { 9.0 - x } else { 0.2 * x + 0.1 + 1e-4 * (f64::from(i) * 1.7).sin() })
            })
            .collect();
        let fit = robust_line(&pairs).unwrap();
        assert!((fit.gain - 0.2).abs() < 1e-3 && (fit.shift - 0.1).abs() < 1e-3, "{fit:?}");
        assert!((fit.inliers - 2.0 / 3.0).abs() < 0.05);
        assert!(robust_line(&pairs[..100]).is_none());
    }
}
