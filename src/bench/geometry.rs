//! GF, geometric fidelity: what [`super::surfaces`] does not measure.

/// Depth against the true depth, both camera z in the same unit and 0 for nothing, over the pixels that both show
/// (Eigen et al. 2014): mean |z − z*| / z*, and the share of pixels where max(z / z*, z* / z) is 1.25 or more.
/// None where no pixel shows both.
pub fn depth_errors(found: &[f32], truth: &[f32]) -> Option<(f64, f64)> {
    let (mut relative, mut off, mut n) = (0.0, 0.0, 0.0);
    for (z, t) in found.iter().zip(truth).filter(|(z, t)| **z > 0.0 && **t > 0.0) {
        let (z, t) = (f64::from(*z), f64::from(*t));
        relative += (z - t).abs() / t;
        off += f64::from(u8::from((z / t).max(t / z) >= 1.25));
        n += 1.0;
    }
    (n > 0.0).then(|| (relative / n, off / n))
}

/// How much too large or too small, per cent: 10 for 1.1 and for 1 / 1.1. `ratio`: found over true size.
pub fn scale_error(ratio: f64) -> f64 {
    100.0 * (ratio.ln().abs().exp() - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depths_and_scales_by_hand() {
        let (relative, off) = depth_errors(&[1.1, 2.0, 0.0, 5.0, 3.0], &[1.0, 2.0, 4.0, 4.0, 0.0]).unwrap();
        assert!((relative - (0.1 + 0.25) / 3.0).abs() < 1e-6 && (off - 1.0 / 3.0).abs() < 1e-9);
        assert_eq!(depth_errors(&[0.0], &[1.0]), None);
        assert!((scale_error(1.1) - 10.0).abs() < 1e-9 && (scale_error(1.0 / 1.1) - 10.0).abs() < 1e-9);
    }
}
