//! A mixture of Gaussians over colours: how often each colour occurs.
//!
//! It begins with parts that are split where they spread most, across their longest axis (M. T. Orchard, C. A. Bouman, "Color Quantization
//! of Images", IEEE Transactions on Signal Processing 39(12), 1991), and is then fitted by expectation maximisation (A. P. Dempster,
//! N. M. Laird, D. B. Rubin 1977). Nothing is drawn by chance.

/// Parts at most.
const PARTS: usize = 8;
/// Colours that a part is learned from, at least.
const COLOURS_A_PART: usize = 64;
/// Rounds of expectation maximisation.
const ROUNDS: usize = 6;
/// Added to every variance, of sRGB 0..1: three steps of 255.
const LEAST_VARIANCE: f64 = 10.0 / (255.0 * 255.0);

type Colour = [f32; 3];

/// Densities over sRGB 0..1.
pub struct Mixture(Vec<Part>);

struct Part {
    /// ln of the part's share, less half the ln of its covariance's determinant.
    constant: f32,
    mean: Colour,
    /// The covariance's inverse: xx, xy, xz, yy, yz, zz.
    inverse: [f32; 6],
}

/// Sums over colours, each with a weight.
#[derive(Clone, Copy, Default)]
struct Moments {
    weight: f64,
    first: [f64; 3],
    second: [f64; 6],
}

const PAIRS: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];

impl Moments {
    fn add(&mut self, colour: Colour, weight: f64) {
        let c = colour.map(f64::from);
        self.weight += weight;
        for (sum, v) in self.first.iter_mut().zip(c) {
            *sum += weight * v;
        }
        for (sum, (a, b)) in self.second.iter_mut().zip(PAIRS) {
            *sum += weight * c[a] * c[b];
        }
    }

    fn of(colours: impl Iterator<Item = Colour>) -> Self {
        let mut moments = Self::default();
        colours.for_each(|colour| moments.add(colour, 1.0));
        moments
    }

    fn mean(&self) -> [f64; 3] {
        self.first.map(|v| v / self.weight.max(1e-9))
    }

    fn covariance(&self) -> [f64; 6] {
        let mean = self.mean();
        std::array::from_fn(|k| {
            let (a, b) = PAIRS[k];
            self.second[k] / self.weight.max(1e-9) - mean[a] * mean[b] + if a == b { LEAST_VARIANCE } else { 0.0 }
        })
    }

    /// The longest axis of the covariance and the variance along it: power iteration.
    fn longest_axis(&self) -> ([f64; 3], f64) {
        let [xx, xy, xz, yy, yz, zz] = self.covariance();
        let times = |v: [f64; 3]| {
            [xx * v[0] + xy * v[1] + xz * v[2], xy * v[0] + yy * v[1] + yz * v[2], xz * v[0] + yz * v[1] + zz * v[2]]
        };
        let length = |v: [f64; 3]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
        // Not square to any axis that colours are likely to spread along.
        let mut axis = [0.6, 0.64, 0.48];
        for _ in 0..20 {
            let next = times(axis);
            axis = next.map(|v| v / length(next).max(1e-12));
        }
        (axis, length(times(axis)))
    }

    fn part(&self, all: f64) -> Part {
        let [xx, xy, xz, yy, yz, zz] = self.covariance();
        let (a, b, d) = (yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy);
        let determinant = (xx * a + xy * b + xz * d).max(1e-30);
        let inverse = [a, b, d, xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy];
        Part {
            constant: ((self.weight / all).max(1e-9).ln() - 0.5 * determinant.ln()) as f32,
            mean: self.mean().map(|v| v as f32),
            inverse: inverse.map(|v| (v / determinant) as f32),
        }
    }
}

impl Part {
    /// ln of its share times its density, but for a constant that all parts have.
    fn log_density(&self, colour: Colour) -> f32 {
        let [x, y, z] = std::array::from_fn(|c| colour[c] - self.mean[c]);
        let [xx, xy, xz, yy, yz, zz] = self.inverse;
        self.constant - 0.5 * (xx * x * x + yy * y * y + zz * z * z) - (xy * x * y + xz * x * z + yz * y * z)
    }
}

impl Mixture {
    /// Fitted to `colours`, of which there is at least one.
    pub fn fitted(colours: &[Colour]) -> Self {
        let mut label = vec![0usize; colours.len()];
        let parts = (colours.len() / COLOURS_A_PART).clamp(1, PARTS);
        let in_part = |label: &[usize], part: usize| {
            Moments::of(colours.iter().zip(label).filter(|(_, l)| **l == part).map(|(colour, _)| *colour))
        };
        let mut moments = vec![in_part(&label, 0)];
        while moments.len() < parts {
            // Of a few colours there is nothing to be told apart.
            let spread = |m: &Moments| if m.weight < 2.0 { 0.0 } else { m.weight * m.longest_axis().1 };
            let widest =
                (0..moments.len()).fold(0, |a, b| if spread(&moments[b]) > spread(&moments[a]) { b } else { a });
            let (axis, mean) = (moments[widest].longest_axis().0, moments[widest].mean());
            for (colour, l) in colours.iter().zip(&mut label).filter(|(_, l)| **l == widest) {
                let along: f64 = (0..3).map(|c| axis[c] * (f64::from(colour[c]) - mean[c])).sum();
                if along > 0.0 {
                    *l = moments.len();
                }
            }
            let new = in_part(&label, moments.len());
            moments[widest] = in_part(&label, widest);
            moments.push(new);
        }
        let all = colours.len() as f64;
        let mut mixture = Self(moments.iter().map(|m| m.part(all)).collect());
        for _ in 0..ROUNDS {
            let mut sums = vec![Moments::default(); parts];
            for colour in colours {
                let densities: [f32; PARTS] =
                    std::array::from_fn(|k| mixture.0.get(k).map_or(f32::NEG_INFINITY, |p| p.log_density(*colour)));
                let largest = densities.iter().copied().fold(f32::NEG_INFINITY, f32::max);
                let shares = densities.map(|v| (v - largest).exp());
                let sum: f32 = shares.iter().sum();
                for (sums, share) in sums.iter_mut().zip(shares) {
                    sums.add(*colour, f64::from(share / sum));
                }
            }
            mixture = Self(sums.iter().map(|m| m.part(all)).collect());
        }
        mixture
    }

    /// Natural logarithm of a colour's density, but for a constant that all mixtures have.
    pub fn log_density(&self, colour: Colour) -> f32 {
        let densities: [f32; PARTS] =
            std::array::from_fn(|k| self.0.get(k).map_or(f32::NEG_INFINITY, |p| p.log_density(colour)));
        let largest = densities.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        largest + densities.iter().map(|v| (v - largest).exp()).sum::<f32>().ln()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A triangular noise around `middle`, the same every time.
    fn around(middle: Colour, width: f32, count: usize) -> Vec<Colour> {
        let noise = |i: usize, c: usize| {
            let at =
                |k: usize| ((i * 3 + c) as f64 * 0.618_033_988_75 + k as f64 * 0.414_213_56 + i as f64 * 0.1).fract();
            (at(0) + at(1) - 1.0) as f32 * width
        };
        (0..count).map(|i| std::array::from_fn(|c| middle[c] + noise(i, c))).collect()
    }

    #[test]
    fn two_colours_are_both_likely_and_what_lies_between_is_not() {
        let (red, blue) = ([0.8, 0.1, 0.1], [0.1, 0.1, 0.9]);
        let mixture = Mixture::fitted(&[around(red, 0.05, 3000), around(blue, 0.05, 1000)].concat());
        let between = mixture.log_density([0.45, 0.1, 0.5]);
        assert!(mixture.log_density(red) > between + 20.0 && mixture.log_density(blue) > between + 20.0);
        // Three times as many, as widely spread.
        let odds = mixture.log_density(red) - mixture.log_density(blue);
        assert!((odds - 3f32.ln()).abs() < 0.5, "{odds}");
    }

    #[test]
    fn one_part_is_the_gaussian_of_its_moments() {
        let colours = around([0.5, 0.4, 0.3], 0.3, 100);
        let mixture = Mixture::fitted(&colours);
        assert_eq!(mixture.0.len(), 1);
        let moments = Moments::of(colours.iter().copied());
        let ([xx, .., zz], mean) = (moments.covariance(), moments.mean());
        let part = &mixture.0[0];
        assert!((0..3).all(|c| (f64::from(part.mean[c]) - mean[c]).abs() < 1e-5));
        // Along an axis that is next to square to the others the density falls by half a nat at one standard deviation.
        for (c, variance) in [(0, xx), (2, zz)] {
            let mut there = part.mean;
            there[c] += (1.0 / part.inverse[if c == 0 { 0 } else { 5 }]).sqrt();
            let fall = mixture.log_density(part.mean) - mixture.log_density(there);
            assert!(
                (fall - 0.5).abs() < 1e-3
                    && f64::from(1.0 / part.inverse[if c == 0 { 0 } else { 5 }]) <= variance * 1.001
            );
        }
    }

    #[test]
    fn one_colour_and_few_colours_are_no_fault() {
        for count in [1, 2, 5000] {
            let mixture = Mixture::fitted(&vec![[0.3, 0.3, 0.3]; count]);
            assert!(mixture.log_density([0.3; 3]).is_finite());
            assert!(mixture.log_density([0.3; 3]) > mixture.log_density([0.4; 3]) + 10.0);
        }
    }
}
