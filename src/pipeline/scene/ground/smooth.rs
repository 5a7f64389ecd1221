//! Noise taken out of a grid of heights: each becomes that of the plane that fits those around it best (locally weighted
//! regression with bisquare weights, Cleveland 1979), so that slopes stay and single wrong heights do not count.

use glam::{DMat3, DVec3};
use rayon::prelude::*;

/// Cells to each side that a plane is fitted to.
const AROUND: usize = 3;
/// Planes fitted to one cell: the first to all alike, the others without what lies far off the one before.
const FITS: usize = 3;
/// A residual counts nothing beyond so many medians of all.
const OFF: f64 = 6.0;
/// Fewer known heights say nothing of a plane.
const LEAST: usize = 6;

/// `heights` in rows of `side`, of which those `known` are looked at and changed.
pub fn smoothed(heights: &[f32], known: &[bool], side: usize) -> Vec<f32> {
    let at = |i: usize| {
        if !known[i] {
            return heights[i];
        }
        let (x, y) = (i % side, i / side);
        let mut around: Vec<(DVec3, f64)> = Vec::with_capacity((2 * AROUND + 1).pow(2));
        for v in y.saturating_sub(AROUND)..=(y + AROUND).min(heights.len() / side - 1) {
            for u in x.saturating_sub(AROUND)..=(x + AROUND).min(side - 1) {
                if known[v * side + u] {
                    let off = DVec3::new(1.0, u as f64 - x as f64, v as f64 - y as f64);
                    around.push((off, f64::from(heights[v * side + u])));
                }
            }
        }
        plane(&around).map_or(heights[i], |p| p.x as f32)
    };
    (0..heights.len()).into_par_iter().map(at).collect()
}

/// Height in the middle and its rise a cell along x and y; `None` where the points tell no plane.
fn plane(around: &[(DVec3, f64)]) -> Option<DVec3> {
    if around.len() < LEAST {
        return None;
    }
    let near = |p: &DVec3| {
        let d = p.y.hypot(p.z) / (AROUND as f64 + 1.0);
        (1.0 - (d * d * d).min(1.0)).powi(3)
    };
    let mut weights: Vec<f64> = around.iter().map(|(p, _)| near(p)).collect();
    let mut found = None;
    for _ in 0..FITS {
        let (mut normal, mut right) = (DMat3::ZERO, DVec3::ZERO);
        for ((p, h), w) in around.iter().zip(&weights) {
            normal += DMat3::from_cols(*p * p.x, *p * p.y, *p * p.z) * *w;
            right += *p * (h * w);
        }
        if normal.determinant().abs() < 1e-6 {
            break;
        }
        let fit = normal.inverse() * right;
        let off: Vec<f64> = around.iter().map(|(p, h)| (h - fit.dot(*p)).abs()).collect();
        let mut sorted = off.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        let most = OFF * sorted[sorted.len() / 2];
        found = Some(fit);
        if most <= 0.0 {
            break;
        }
        weights =
            around.iter().zip(off).map(|((p, _), r)| near(p) * (1.0 - (r / most).min(1.0).powi(2)).powi(2)).collect();
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splat::train::random::Random;

    #[test]
    fn slopes_stay_and_noise_and_single_wrong_heights_go() {
        let side = 24;
        let slope = |i: usize| 0.3 * (i % side) as f32 - 0.2 * (i / side) as f32 + 5.0;
        let exact: Vec<f32> = (0..side * side).map(slope).collect();
        let known = vec![true; exact.len()];
        let same = smoothed(&exact, &known, side);
        assert!(same.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 1e-4));
        let mut random = Random::new(5);
        let mut noisy: Vec<f32> = exact.iter().map(|h| h + 0.2 * random.normal()).collect();
        noisy[10 * side + 10] += 30.0;
        noisy[0] -= 30.0;
        let off = |h: &[f32]| {
            let inner =
                (0..h.len()).filter(|i| (3..side - 3).contains(&(i % side)) && (3..side - 3).contains(&(i / side)));
            let squares: Vec<f32> = inner.map(|i| (h[i] - exact[i]).powi(2)).collect();
            (squares.iter().sum::<f32>() / squares.len() as f32).sqrt()
        };
        let after = smoothed(&noisy, &known, side);
        assert!(off(&noisy) > 1.0 && off(&after) < 0.07, "{} {}", off(&noisy), off(&after));
        // What is not known stays and is not looked at.
        let half: Vec<bool> = (0..known.len()).map(|i| i % side < 12).collect();
        let mut broken = noisy.clone();
        (0..broken.len()).filter(|i| !half[*i]).for_each(|i| broken[i] = f32::NAN);
        let after = smoothed(&broken, &half, side);
        assert!(after.iter().zip(&half).all(|(h, known)| h.is_finite() == *known));
        // Alone it says nothing of what is around it.
        let mut one = vec![false; known.len()];
        one[30] = true;
        assert_eq!(smoothed(&noisy, &one, side), noisy);
    }
}
