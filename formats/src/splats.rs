//! Gaussian splats: what PLY, SPZ and glTF write and read.

use crate::{Error, Result};

/// Spherical-harmonic coefficients of a colour channel up to a degree: (degree + 1)².
pub const BASES: [usize; 4] = [1, 4, 9, 16];

/// Gaussian splats, a structure of arrays of one length.
///
/// Positions are metres; scales natural logarithms of metres; rotations quaternions w first; opacities logits; `sh` the
/// spherical-harmonic coefficients, basis by basis (degree 0 first), each RGB.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Splats {
    pub positions: Vec<[f32; 3]>,
    pub log_scales: Vec<[f32; 3]>,
    pub rotations: Vec<[f32; 4]>,
    pub logit_opacities: Vec<f32>,
    pub sh: Vec<[[f32; 3]; 16]>,
}

impl Splats {
    /// The lowest degree, 0 to 3, that holds every coefficient that is not 0.
    pub fn degree(&self) -> usize {
        let used = |sh: &[[f32; 3]; 16]| sh.iter().rposition(|rgb| *rgb != [0.0; 3]).unwrap_or(0);
        let highest = self.sh.iter().map(used).max().unwrap_or(0);
        BASES.iter().position(|&b| highest < b).unwrap_or(3)
    }

    /// Checks what every writer relies on: arrays of one length, finite numbers.
    ///
    /// # Errors
    /// [`Error::Unsupported`] naming the lengths or the first splat that breaks the rule.
    pub fn validate(&self, format: &'static str) -> Result<()> {
        self.check_lengths(format)?;
        self.check_finite(format)
    }

    /// The first half of [`Splats::validate`].
    pub(crate) fn check_lengths(&self, format: &'static str) -> Result<()> {
        let count = self.positions.len();
        let lengths = [self.log_scales.len(), self.rotations.len(), self.logit_opacities.len(), self.sh.len()];
        if lengths.iter().any(|&l| l != count) {
            return Err(Error::unsupported(
                format,
                format!(
                    "the arrays of splats must have one length, found {count} positions and {} scales, {} rotations, \
                     {} opacities, {} colours",
                    lengths[0], lengths[1], lengths[2], lengths[3]
                ),
            ));
        }
        Ok(())
    }

    /// The second half of [`Splats::validate`]: the lengths have been checked.
    pub(crate) fn check_finite(&self, format: &'static str) -> Result<()> {
        let count = self.positions.len();
        let shapes = [self.positions.as_flattened(), self.log_scales.as_flattened(), self.rotations.as_flattened()];
        if shapes.iter().all(|s| whole(s))
            && whole(&self.logit_opacities)
            && whole(self.sh.as_flattened().as_flattened())
        {
            return Ok(());
        }
        let finite = |i: &usize| {
            let shape = self.positions[*i].iter().chain(&self.log_scales[*i]).chain(&self.rotations[*i]);
            let rest = self.sh[*i].iter().flatten().chain([&self.logit_opacities[*i]]);
            shape.chain(rest).all(|x| x.is_finite())
        };
        match (0..count).find(|i| !finite(i)) {
            Some(i) => Err(Error::unsupported(format, format!("splat {i} of {count} has a value that is not finite"))),
            None => Ok(()),
        }
    }
}

/// Whether all values are finite numbers.
pub(crate) fn whole(values: &[f32]) -> bool {
    values.iter().fold(true, |all, x| all & x.is_finite())
}

/// The logistic function: logit → opacity.
pub fn sigmoid(x: f32) -> f32 {
    1.0 / (1.0 + (-x).exp())
}

/// Opacity → logit, the ends kept finite: no further than ±`limit`.
pub fn logit(opacity: f32, limit: f32) -> f32 {
    (opacity / (1.0 - opacity)).ln().clamp(-limit, limit)
}

/// A quaternion of length 1; none where it has no direction.
pub fn unit(q: [f32; 4]) -> Option<[f32; 4]> {
    let length = q.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>().sqrt();
    (length > 1e-20 && length.is_finite()).then(|| q.map(|x| (f64::from(x) / length) as f32))
}
