//! How one photo's colours differ from the scene's: brightness, tint and offset, as an affine map, learnt beside the
//! Gaussians (the `exposure` of Kerbl et al.'s code since 2024; Rematas et al. 2022, §3.2).
//!
//!   x' = M x + b,   L += hold · (|M − I|² + |b|²)
//!
//! The second term decides what the pictures leave open: Gaussians twice as bright under maps of half the brightness.

use super::adam::{BETA1, BETA2};

/// A row a channel: three numbers of M, then b.
pub type Change = [[f32; 4]; 3];

/// Nothing changes.
pub const NONE: Change = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];

/// One photo's map and Adam's memory of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure {
    pub change: Change,
    moments: [Change; 2],
    steps: i32,
}

impl Default for Exposure {
    fn default() -> Self {
        Exposure { change: NONE, moments: [[[0.0; 4]; 3]; 2], steps: 0 }
    }
}

/// A colour under a map.
#[inline(always)]
pub fn applied(m: &Change, x: [f32; 3]) -> [f32; 3] {
    let row = |r: &[f32; 4]| r[0] * x[0] + r[1] * x[1] + r[2] * x[2] + r[3];
    [row(&m[0]), row(&m[1]), row(&m[2])]
}

impl Exposure {
    /// As shaders/exposure.wgsl has it: the map, first and second moments, then the steps.
    pub fn words(&self) -> [f32; 40] {
        let mut out = [0.0; 40];
        for (part, rows) in [self.change, self.moments[0], self.moments[1]].iter().enumerate() {
            out[12 * part..12 * part + 12].copy_from_slice(rows.as_flattened());
        }
        out[36] = self.steps as f32;
        out
    }

    pub fn from_words(words: &[f32; 40]) -> Exposure {
        let part = |p: usize| std::array::from_fn(|i| std::array::from_fn(|k| words[12 * p + 4 * i + k]));
        Exposure { change: part(0), moments: [part(1), part(2)], steps: words[36] as i32 }
    }

    /// One step of Adam against `gradient`, the pictures' own part of it. One that is not finite changes nothing.
    pub fn step(&mut self, gradient: &Change, rate: f32, hold: f32) {
        if !gradient.as_flattened().iter().sum::<f32>().is_finite() {
            return;
        }
        self.steps += 1;
        let corrections = [1.0 - BETA1.powi(self.steps), 1.0 - BETA2.powi(self.steps)];
        for i in 0..3 {
            for k in 0..4 {
                let g = gradient[i][k] + 2.0 * hold * (self.change[i][k] - NONE[i][k]);
                let [m, v] = &mut self.moments;
                m[i][k] = BETA1 * m[i][k] + (1.0 - BETA1) * g;
                v[i][k] = BETA2 * v[i][k] + (1.0 - BETA2) * g * g;
                self.change[i][k] -= rate * m[i][k] / corrections[0] / ((v[i][k] / corrections[1]).sqrt() + 1e-15);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_hold_everything_and_steps_find_the_map() {
        let truth: Change = [[1.3, 0.05, 0.0, -0.02], [0.0, 0.8, 0.02, 0.03], [0.01, 0.0, 1.1, 0.0]];
        let mut e = Exposure::default();
        // Least squares of |M x − truth x|² over the corners of a cube.
        for step in 0..2000 {
            let mut gradient: Change = [[0.0; 4]; 3];
            for corner in 0..8 {
                let x = [0, 1, 2].map(|k| 0.2 + 0.6 * (corner >> k & 1) as f32);
                let (a, b) = (applied(&e.change, x), applied(&truth, x));
                for i in 0..3 {
                    for k in 0..3 {
                        gradient[i][k] += 2.0 * (a[i] - b[i]) * x[k] / 8.0;
                    }
                    gradient[i][3] += 2.0 * (a[i] - b[i]) / 8.0;
                }
            }
            e.step(&gradient, if step < 1000 { 0.01 } else { 0.001 }, 0.0);
        }
        let worst = e.change.as_flattened().iter().zip(truth.as_flattened()).map(|(a, b)| (a - b).abs());
        assert!(worst.fold(0.0, f32::max) < 2e-3, "{:?}", e.change);
        assert_eq!(Exposure::from_words(&e.words()), e);
        let before = e;
        e.step(&[[f32::NAN; 4]; 3], 0.01, 0.0);
        assert_eq!(e, before);
        // Where the pictures say nothing it comes back to none.
        for _ in 0..2000 {
            e.step(&[[0.0; 4]; 3], 0.002, 0.01);
        }
        assert!((e.change[0][0] - 1.0).abs() < 0.02, "{:?}", e.change);
    }
}
