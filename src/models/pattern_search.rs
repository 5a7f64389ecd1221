//! Pattern search (R. Hooke and T. A. Jeeves, "Direct search solution of numerical and statistical problems", JACM 1961): for
//! costs of a few numbers that have no derivative.

/// From `start` towards a smaller cost, one number after the other, a step up or down; steps are halved where none helps, until
/// they are `finest` of the first ones. What must not be has an infinite cost. Returns the best numbers and their cost.
pub fn pattern_search<const N: usize>(
    start: [f32; N],
    steps: [f32; N],
    finest: f32,
    cost: impl Fn([f32; N]) -> f64,
) -> ([f32; N], f64) {
    let (mut best, mut least, mut share) = (start, cost(start), 1.0);
    while share > finest {
        let mut moved = false;
        for axis in 0..N {
            for sign in [share, -share] {
                let mut trial = best;
                trial[axis] += sign * steps[axis];
                let value = cost(trial);
                if value < least {
                    (best, least, moved) = (trial, value, true);
                    break;
                }
            }
        }
        if !moved {
            share *= 0.5;
        }
    }
    (best, least)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_a_valley_is_found_and_a_fence_is_kept() {
        let valley = |t: [f32; 2]| f64::from((t[0] - 3.0).powi(2) + 2.0 * (t[1] + 1.0 + 0.3 * t[0]).powi(2));
        let (at, cost) = pattern_search([0.0; 2], [1.0, 2.0], 1e-3, valley);
        assert!((at[0] - 3.0).abs() < 0.01 && (at[1] + 1.9).abs() < 0.01 && cost < 1e-4, "{at:?} {cost}");
        let fenced = |t: [f32; 2]| if t[0] > 2.0 { f64::INFINITY } else { valley(t) };
        let (at, _) = pattern_search([0.0; 2], [1.0, 2.0], 1e-3, fenced);
        assert!(at[0] <= 2.0 && at[0] > 1.99, "{at:?}");
    }
}
