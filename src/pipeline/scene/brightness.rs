//! How bright a scene itself is, where every photo has an exposure of its own: as the photos are on average.
//!
//! Gaussians under M·(C·x + d) + b look as Gaussians under M·x + b do whose colours were C·x + d: pictures leave the common
//! part open. Here it goes into the Gaussians, so that a photo's map says only how it differs from the others.

use glam::{DMat3, DVec3};

use crate::splat::Gaussians;
use crate::splat::train::exposure::Change;

fn parts(m: &Change) -> (DMat3, DVec3) {
    let row = |i: usize| DVec3::new(m[i][0].into(), m[i][1].into(), m[i][2].into());
    let shift = DVec3::new(m[0][3].into(), m[1][3].into(), m[2][3].into());
    (DMat3::from_cols(row(0), row(1), row(2)).transpose(), shift)
}

fn change(m: DMat3, b: DVec3) -> Change {
    std::array::from_fn(|i| [m.col(0)[i] as f32, m.col(1)[i] as f32, m.col(2)[i] as f32, b[i] as f32])
}

/// Takes the mean map of the photos `learnt` out of all maps and into the colours. Nothing happens where there is none, or
/// where it cannot be undone.
pub fn settle(g: &mut Gaussians, exposures: &mut [Change], learnt: &[bool]) {
    let (mut matrix, mut shift, mut n) = (DMat3::ZERO, DVec3::ZERO, 0.0);
    for (m, b) in exposures.iter().zip(learnt).filter(|(_, learnt)| **learnt).map(|(e, _)| parts(e)) {
        matrix += m;
        shift += b;
        n += 1.0;
    }
    if n == 0.0 {
        return;
    }
    (matrix, shift) = (matrix * (1.0 / n), shift / n);
    if !(matrix.determinant() > 0.01 && shift.is_finite()) {
        return;
    }
    let inverse = matrix.inverse();
    for e in exposures.iter_mut().zip(learnt).filter(|(_, learnt)| **learnt).map(|(e, _)| e) {
        // e(x) = own(mean(x)).
        let (m, b) = parts(e);
        let own = m * inverse;
        *e = change(own, b - own * shift);
    }
    for sh in &mut g.sh {
        for (k, coefficient) in sh.iter_mut().enumerate() {
            let c = DVec3::new(coefficient[0].into(), coefficient[1].into(), coefficient[2].into());
            // The colour is ½ and the sum of the harmonics.
            let rest = if k == 0 {
                (matrix * DVec3::splat(0.5) + shift - DVec3::splat(0.5)) / f64::from(crate::splat::SH_C0)
            } else {
                DVec3::ZERO
            };
            *coefficient = (matrix * c + rest).as_vec3().to_array();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splat::render;
    use crate::splat::render::tests::{camera, scene};
    use crate::splat::train::exposure::{NONE, applied};

    #[test]
    fn pictures_stay_and_the_mean_photo_has_no_map() {
        let mut g = scene(80, 0.2, 5);
        // Bright enough that nothing is clamped at black.
        g.sh.iter_mut().for_each(|s| s[0] = [0.6, 0.4, 0.8]);
        g.sh.iter_mut().flat_map(|s| s[1..].iter_mut()).for_each(|c| *c = c.map(|v| 0.05 * v));
        let before = g.clone();
        let first: Vec<Change> = vec![
            [[1.3, 0.05, 0.0, 0.01], [0.0, 1.2, 0.02, 0.0], [0.01, 0.0, 1.4, -0.01]],
            [[1.1, 0.0, 0.03, 0.02], [0.05, 1.0, 0.0, 0.01], [0.0, 0.02, 1.2, 0.0]],
            NONE,
        ];
        let mut maps = first.clone();
        settle(&mut g, &mut maps, &[true, true, false]);
        assert_eq!(maps[2], NONE);
        let c = camera(40, 30);
        let (a, b) = (render(&before, &c, [0.0; 3]), render(&g, &c, [0.0; 3]));
        for i in (0..a.color.len()).filter(|i| a.alpha[*i] > 0.97) {
            for k in 0..2 {
                let (x, y) = (applied(&first[k], a.color[i]), applied(&maps[k], b.color[i]));
                // The background behind what is left is not changed.
                assert!((0..3).all(|c| (x[c] - y[c]).abs() < 0.02), "{x:?} {y:?}");
            }
        }
        for i in 0..3 {
            for k in 0..4 {
                let mean = (maps[0][i][k] + maps[1][i][k]) / 2.0;
                assert!((mean - NONE[i][k]).abs() < 1e-4, "{maps:?}");
            }
        }
    }
}
