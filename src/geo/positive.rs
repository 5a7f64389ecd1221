//! A length that was measured with an error that is not small beside it, and is known to be above zero.

/// Of what was measured as below zero by more deviations than this the measurement is not believed.
const BELIEVED: f64 = 2.0;
/// Share of a normal law below its mean plus one deviation.
const ONE_ABOVE: f64 = 0.841_344_746;

/// The law of a length x that is normal with its measurement's mean and deviation, x > 0 given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Positive {
    pub median: f64,
    /// Of its logarithm: half of what lies between the quantiles of one deviation. The relative deviation where that is small.
    pub sigma: f64,
}

impl Positive {
    /// `None` where the measurement is more than two deviations below zero, or no number.
    pub fn measured(mean: f64, sigma: f64) -> Option<Self> {
        if !(mean.is_finite() && sigma.is_finite() && sigma > 0.0 && mean > -BELIEVED * sigma) {
            return None;
        }
        let quantile = |share| mean + sigma * upper(share * above(-mean / sigma));
        let (low, high) = (quantile(ONE_ABOVE), quantile(1.0 - ONE_ABOVE));
        Some(Self { median: quantile(0.5), sigma: (high / low).ln() / 2.0 })
    }
}

/// Share of the standard normal law above x.
fn above(x: f64) -> f64 {
    0.5 * libm::erfc(x / std::f64::consts::SQRT_2)
}

/// The x above which that share of the standard normal law lies; by bisection, to 1e-12 between ±40.
fn upper(share: f64) -> f64 {
    let (mut low, mut high) = (-40.0, 40.0);
    for _ in 0..64 {
        let middle = 0.5 * (low + high);
        if above(middle) > share { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_good_measurement_stays_as_it_is() {
        let x = Positive::measured(10.0, 0.1).unwrap();
        assert!((x.median - 10.0).abs() < 1e-9 && (x.sigma - 0.01).abs() < 1e-5, "{x:?}");
    }

    /// By the half-normal law: its median is 0.674490, its quantiles of 15.87 and 84.13 % are 0.200173 and 1.409610.
    #[test]
    fn zero_with_an_error_is_half_a_normal_law() {
        let x = Positive::measured(0.0, 1.0).unwrap();
        assert!((x.median - 0.674_490).abs() < 1e-6, "{x:?}");
        assert!((x.sigma - (1.409_610f64 / 0.200_173).ln() / 2.0).abs() < 1e-5, "{x:?}");
    }

    #[test]
    fn less_than_nothing_is_little_and_uncertain_and_at_last_not_believed() {
        let laws: Vec<Positive> = [3.0, 1.0, 0.0, -1.0, -1.9].map(|m| Positive::measured(m, 1.0).unwrap()).to_vec();
        assert!(laws.windows(2).all(|w| w[1].median < w[0].median && w[1].sigma > w[0].sigma), "{laws:?}");
        assert!(laws.iter().all(|x| x.median > 0.0));
        assert_eq!(Positive::measured(-2.1, 1.0), None);
        assert_eq!(Positive::measured(f64::NAN, 1.0), None);
        assert_eq!(Positive::measured(1.0, 0.0), None);
    }
}
