//! What colours the subject and its surroundings have, learnt from the mask itself.
//!
//! One step of the iteration in C. Rother, V. Kolmogorov, A. Blake, "GrabCut", SIGGRAPH 2004, with histograms in place of
//! mixtures and the network's odds in place of a graph cut: where both looks of the network disagree, colour decides.

use super::guided::box_mean;
use super::region::Bounds;
use crate::photo::Plane;
use rayon::prelude::*;

const BINS: usize = 20;
/// No colour speaks louder than e³ to 1.
const LOUDEST: f32 = 3.0;

/// Probability of each colour bin.
struct Histogram(Vec<f32>);

impl Histogram {
    fn new(pixels: impl Iterator<Item = ([f32; 3], f32)>) -> Self {
        let mut counts = vec![0.0f64; BINS * BINS * BINS];
        pixels.for_each(|(colour, weight)| counts[bin(colour)] += f64::from(weight));
        for stride in [1, BINS, BINS * BINS] {
            counts = blurred(&counts, stride);
        }
        let sum: f64 = counts.iter().sum::<f64>().max(1e-12);
        Histogram(counts.iter().map(|v| (v / sum) as f32).collect())
    }
}

fn bin(colour: [f32; 3]) -> usize {
    colour.iter().fold(0, |i, v| i * BINS + ((v * BINS as f32) as usize).min(BINS - 1))
}

/// Binomial, σ = 1 bin, along one axis.
fn blurred(counts: &[f64], stride: usize) -> Vec<f64> {
    const WEIGHTS: [f64; 5] = [1.0 / 16.0, 4.0 / 16.0, 6.0 / 16.0, 4.0 / 16.0, 1.0 / 16.0];
    let near = |i: usize, k: usize| {
        let position = (i / stride % BINS) as i64;
        let to = (position + k as i64 - 2).clamp(0, BINS as i64 - 1);
        (i as i64 + (to - position) * stride as i64) as usize
    };
    (0..counts.len()).map(|i| (0..5).map(|k| WEIGHTS[k] * counts[near(i, k)]).sum()).collect()
}

/// Multiplies the mask's odds by subject-to-surroundings likelihood of each pixel's colour, in the box grown by a
/// quarter; outside it the mask becomes 0. `guide` is sRGB 0..1 of the mask's size.
///
/// Returns how far the two colour distributions differ: the Kullback–Leibler divergence in nats, 0 for no difference.
pub fn refine(guide: &[[f32; 3]], mask: &mut Plane, subject: Bounds) -> f32 {
    let [x0, y0, x1, y1] = subject;
    let (w, h) = (mask.width, mask.height);
    let grow = (x1 - x0).max(y1 - y0) / 4;
    let (left, right) = (x0.saturating_sub(grow), (x1 + grow).min(w));
    let (top, bottom) = (y0.saturating_sub(grow), (y1 + grow).min(h));
    let near = |i: usize| (left..right).contains(&(i % w)) && (top..bottom).contains(&(i / w));
    let weighted = |weight: fn(f32) -> f32| {
        (0..w * h).filter(|&i| near(i)).map(|i| (guide[i], weight(mask.data[i].clamp(0.01, 0.99)))).collect::<Vec<_>>()
    };
    let inside = Histogram::new(weighted(|v| v * v).into_iter());
    let outside = Histogram::new(weighted(|v| (1.0 - v) * (1.0 - v)).into_iter());
    let ratio = |b: usize| ((inside.0[b] + 1e-6) / (outside.0[b] + 1e-6)).ln();
    let table: Vec<f32> = (0..BINS * BINS * BINS).map(|b| ratio(b).clamp(-LOUDEST, LOUDEST)).collect();
    let smooth = box_mean(w, h, (w.max(h) / 500).max(1), &|i| table[bin(guide[i])]);
    mask.data.par_iter_mut().enumerate().for_each(|(i, v)| {
        let p = v.clamp(0.01, 0.99);
        let odds = p / (1.0 - p) * smooth.data[i].exp();
        *v = if near(i) { odds / (1.0 + odds) } else { 0.0 };
    });
    (0..table.len()).map(|b| inside.0[b] * ratio(b)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colour_decides_where_the_mask_doubts() {
        // A red square on grey; the mask is sure of the left half only and leaks to the ground below.
        let (w, square) = (60, 20..40);
        let red = |x: usize, y: usize| square.contains(&x) && square.contains(&y);
        let guide: Vec<[f32; 3]> =
            (0..w * w).map(|i| if red(i % w, i / w) { [0.8, 0.1, 0.1] } else { [0.5, 0.5, 0.5] }).collect();
        let mut mask = Plane::new(w, w, 0.02);
        for y in 20..46 {
            for x in 20..40 {
                mask.data[y * w + x] = if y >= 40 {
                    0.55
                } else if x < 30 {
                    0.95
                } else {
                    0.4
                };
            }
        }
        let divergence = refine(&guide, &mut mask, [20, 20, 40, 46]);
        assert!(divergence > 1.0, "{divergence}");
        assert!(mask.at(36, 30) > 0.7 && mask.at(25, 43) < 0.3 && mask.at(25, 30) > 0.95 && mask.at(2, 2) == 0.0);
    }

    #[test]
    fn one_colour_tells_nothing() {
        let mut mask = Plane::new(30, 30, 0.2);
        (0..900).filter(|i| i % 30 > 9 && i % 30 < 20).for_each(|i| mask.data[i] = 0.9);
        let before = mask.clone();
        let divergence = refine(&[[0.3; 3]; 900], &mut mask, [0, 0, 30, 30]);
        assert!(divergence.abs() < 1e-4);
        assert!(mask.data.iter().zip(&before.data).all(|(a, b)| (a - b).abs() < 0.02));
    }
}
