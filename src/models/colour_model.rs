//! What colours the subject and its surroundings have, learnt from the mask itself.
//!
//! One step of the iteration in C. Rother, V. Kolmogorov, A. Blake, "GrabCut", SIGGRAPH 2004, with histograms in place of
//! mixtures and the network's odds in place of a graph cut: where the network doubts, and close to the edge it drew, colour decides; what it
//! is sure of stays.

use super::guided::box_mean;
use super::region::{Bounds, dilated, eroded};
use crate::photo::Plane;

const BINS: usize = 20;
/// No colour speaks louder than e³ to 1.
const LOUDEST: f32 = 3.0;
/// Power of the odds: makes the mask decide where both together still waver, without moving its line of one half.
const CRISP: i32 = 3;
/// Above this the network's word stands.
const SURE: f32 = 0.8;

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

/// How the colours near a subject tell it from its surroundings.
pub struct Evidence {
    /// Natural logarithm of the odds that each pixel's colour is the subject's, at most 3 either way.
    pub log_odds: Plane,
    /// How far the two colour distributions differ: the Kullback–Leibler divergence in nats, 0 for no difference.
    pub divergence: f32,
}

/// Learns both colour distributions where the mask is surest, in the box `near`, and asks them about each pixel.
/// `guide` is sRGB 0..1 of the mask's size.
pub fn evidence(guide: &[[f32; 3]], mask: &Plane, near: Bounds) -> Evidence {
    let (w, h) = (mask.width, mask.height);
    let [x0, y0, x1, y1] = near;
    let weighted = |weight: fn(f32) -> f32| {
        let pixels = (y0..y1).flat_map(|y| (x0..x1).map(move |x| y * w + x));
        Histogram::new(pixels.map(|i| (guide[i], weight(mask.data[i].clamp(0.01, 0.99)))))
    };
    let inside = weighted(|v| v * v);
    let outside = weighted(|v| (1.0 - v) * (1.0 - v));
    let ratio = |b: usize| ((inside.0[b] + 1e-6) / (outside.0[b] + 1e-6)).ln();
    let table: Vec<f32> = (0..BINS * BINS * BINS).map(|b| ratio(b).clamp(-LOUDEST, LOUDEST)).collect();
    let log_odds = box_mean(w, h, (w.max(h) / 500).max(1), &|i| table[bin(guide[i])]);
    Evidence { log_odds, divergence: (0..table.len()).map(|b| inside.0[b] * ratio(b)).sum() }
}

/// Multiplies the mask's odds by the colour's and cubes them, in the band where the mask may move: within `reach` pixels of the line of
/// one half, and where the mask itself doubts (0.1..0.9). Elsewhere in the box `near` the mask becomes 1 or 0. What it is
/// sure of, more than `margin` pixels deep, stays; returns that core. Outside `near` the mask becomes 0.
pub fn refine(log_odds: &Plane, mask: &mut Plane, near: Bounds, reach: usize, margin: usize) -> Vec<bool> {
    let (w, h) = (mask.width, mask.height);
    let [x0, y0, x1, y1] = near;
    let core = eroded(w, h, margin, |i| mask.data[i] > SURE);
    let deep = eroded(w, h, reach, |i| mask.data[i] > 0.5);
    let close = dilated(w, h, reach, |i| mask.data[i] > 0.5);
    for (i, v) in mask.data.iter_mut().enumerate() {
        let doubtful = (0.1..0.9).contains(v) || close[i] != deep[i];
        *v = if !(x0..x1).contains(&(i % w)) || !(y0..y1).contains(&(i / w)) {
            0.0
        } else if core[i] {
            1.0
        } else if doubtful {
            let p = v.clamp(0.01, 0.99);
            let odds = (p / (1.0 - p) * log_odds.data[i].exp()).powi(CRISP);
            odds / (1.0 + odds)
        } else {
            f32::from(u8::from(*v > 0.5))
        };
    }
    core
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
        let found = evidence(&guide, &mask, [5, 5, 55, 55]);
        assert!(found.divergence > 1.0, "{}", found.divergence);
        refine(&found.log_odds, &mut mask, [5, 5, 55, 55], 3, 1);
        assert!(mask.at(36, 30) > 0.7 && mask.at(25, 43) < 0.3 && mask.at(25, 30) > 0.95 && mask.at(2, 2) == 0.0);
    }

    #[test]
    fn colour_bites_nothing_off_what_the_mask_is_sure_of() {
        // A red square with a grey roof, on grey: the roof has the ground's colour.
        let w = 60;
        let inside = |x: usize, y: usize| (20..40).contains(&x) && (20..40).contains(&y);
        let guide: Vec<[f32; 3]> = (0..w * w)
            .map(|i| if inside(i % w, i / w) && i / w >= 28 { [0.8, 0.1, 0.1] } else { [0.5, 0.5, 0.5] })
            .collect();
        let data = (0..w * w).map(|i| if inside(i % w, i / w) { 0.85 } else { 0.05 }).collect();
        let mut mask = Plane { width: w, height: w, data };
        let found = evidence(&guide, &mask, [10, 10, 50, 50]);
        let core = refine(&found.log_odds, &mut mask, [10, 10, 50, 50], 2, 1);
        for (i, v) in mask.data.iter().enumerate() {
            let (x, y) = (i % w, i / w);
            let deep = (21..39).contains(&x) && (21..39).contains(&y);
            assert_eq!(core[i], deep, "{x},{y}");
            assert!(!deep || *v == 1.0, "{x},{y}: {v}");
            assert!(inside(x, y) || *v < 0.2, "{x},{y}: {v}");
        }
    }

    #[test]
    fn one_colour_tells_nothing() {
        let mut mask = Plane::new(30, 30, 0.2);
        (0..900).filter(|i| i % 30 > 9 && i % 30 < 20).for_each(|i| mask.data[i] = 0.9);
        let found = evidence(&[[0.3; 3]; 900], &mask, [0, 0, 30, 30]);
        assert!(found.divergence.abs() < 1e-4 && found.log_odds.data.iter().all(|v| v.abs() < 1e-3));
        mask.data.iter_mut().for_each(|v| *v = v.clamp(0.15, 0.85));
        let before = mask.clone();
        refine(&found.log_odds, &mut mask, [0, 0, 30, 30], 2, 10);
        let crisper = |a: f32, b: f32| if b > 0.5 { a > 0.99 } else { a < 0.02 };
        assert!(mask.data.iter().zip(&before.data).all(|(a, b)| crisper(*a, *b)));
    }
}
