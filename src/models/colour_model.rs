//! What colours the subject and its surroundings have, learnt from the mask itself, and the cut between both that they tell.
//!
//! One step of the iteration in C. Rother, V. Kolmogorov, A. Blake, "GrabCut", SIGGRAPH 2004, with
//! the network's odds beside the colours': where the network doubts colour decides, and the cut likes to run where
//! neighbours are unlike; what the network is sure of stays.

use super::graph_cut::Grid;
use super::mixture::Mixture;
use super::region::Bounds;
use crate::photo::Plane;
use rayon::prelude::*;

/// Colours that either mixture is learned from, about.
const LEARNED_FROM: usize = 20_000;
/// No colour speaks louder than e⁸ to 1.
const LOUDEST: f32 = 8.0;
// What follows was chosen on 18 ray-traced photos in two lights and on 28 real ones; with 1 to 3 for the network, 0.25 to 1 in doubt and 3 to 10 for
// what is alike, one at a time, mean IoUs move by less than 0.003.

/// How much the network's odds count beside those of colours.
const NETWORK: f32 = 1.5;
/// What pixels have for them that neither the network nor their colours speak for or against, nats.
const IN_DOUBT: f32 = 0.5;
/// Above this the network's word stands for the subject, and below the other against it.
const SURE: f32 = 0.75;
const SURELY_NOT: f32 = 0.05;
/// What it costs to cut between neighbours of the same colour, nats.
const LIKE: f32 = 4.0;
/// Of a nat, what a whole number of the cut stands for.
const UNIT: f32 = 1.0 / 4096.0;
/// More than all that speaks against it, nats.
const CERTAIN: f32 = 1e4;

/// How the colours near a subject tell it from its surroundings.
pub struct Evidence {
    /// Natural logarithm of the odds that each pixel's colour is the subject's, at most 8 either way; 0 outside the box.
    pub log_odds: Plane,
    /// How far the two colour distributions differ: the Kullback–Leibler divergence in nats, 0 for no difference.
    pub divergence: f32,
}

/// Learns both colour distributions on either side of the mask's line of one half, in the box `near`, and asks them about each pixel of it.
/// `guide` is sRGB 0..1 of the mask's size.
pub fn evidence(guide: &[[f32; 3]], mask: &Plane, near: Bounds) -> Evidence {
    let (w, h) = (mask.width, mask.height);
    let [x0, y0, x1, y1] = near;
    let of = |subject: bool| -> Vec<[f32; 3]> {
        let pixels = (y0..y1).flat_map(|y| (x0..x1).map(move |x| y * w + x));
        pixels.filter(|i| (mask.data[*i] > 0.5) == subject).map(|i| guide[i]).collect()
    };
    let learned = |colours: &[[f32; 3]]| -> Vec<[f32; 3]> {
        colours.iter().copied().step_by(colours.len().div_ceil(LEARNED_FROM).max(1)).collect()
    };
    let (inside, outside) = (learned(&of(true)), learned(&of(false)));
    if inside.is_empty() || outside.is_empty() {
        return Evidence { log_odds: Plane::new(w, h, 0.0), divergence: 0.0 };
    }
    let (subject, rest) = rayon::join(|| Mixture::fitted(&inside), || Mixture::fitted(&outside));
    let odds = |colour: &[f32; 3]| (subject.log_density(*colour) - rest.log_density(*colour)).clamp(-LOUDEST, LOUDEST);
    let divergence = inside.iter().map(odds).sum::<f32>() / inside.len() as f32;
    let mut log_odds = Plane::new(w, h, 0.0);
    log_odds.data.par_chunks_mut(w).zip(guide.par_chunks(w)).take(y1).skip(y0).for_each(|(line, guide)| {
        line[x0..x1].iter_mut().zip(&guide[x0..x1]).for_each(|(line, colour)| *line = odds(colour));
    });
    Evidence { log_odds, divergence }
}

/// The subject as network and colours see it together, in the box `near`: 1 or 0; outside it 0. The least cut
/// ([`super::graph_cut`]) of the network's odds ([`NETWORK`] times) and the colours', with what it costs to part neighbours falling from [`LIKE`] with
/// their distance of colour, exp(−d² / 2⟨d²⟩), and that between corners by √2 (GrabCut's Eq. 4 and 11).
pub fn cut(guide: &[[f32; 3]], log_odds: &Plane, mask: &Plane, near: Bounds) -> Plane {
    let [x0, y0, x1, y1] = near;
    let (w, h) = (x1 - x0, y1 - y0);
    let pixel = |i: usize| (y0 + i / w) * mask.width + x0 + i % w;
    let whole = |nats: f32| (nats / UNIT) as i32;
    let opinion = |i: usize| {
        let p = mask.data[pixel(i)];
        let likely = p.clamp(0.01, 0.99);
        whole(match p {
            p if p > SURE => CERTAIN,
            p if p < SURELY_NOT => -CERTAIN,
            _ => NETWORK * (likely / (1.0 - likely)).ln() + log_odds.data[pixel(i)] + IN_DOUBT,
        })
    };
    let apart = |i: usize, j: usize| {
        let (a, b) = (guide[pixel(i)], guide[pixel(j)]);
        (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f32>()
    };
    let right = (0..w * h).filter(|i| i % w + 1 < w).map(|i| f64::from(apart(i, i + 1)));
    let below = (0..w * h.saturating_sub(1)).map(|i| f64::from(apart(i, i + w)));
    let (sum, pairs) = right.chain(below).fold((0.0, 0.0), |(sum, pairs), d| (sum + d, pairs + 1.0));
    let usual = (sum / f64::max(pairs, 1.0)).max(1e-9) as f32;
    let parted = |i: usize, j: usize| {
        let aslant = i % w != j % w && i / w != j / w;
        whole(LIKE * (-apart(i, j) / (2.0 * usual)).exp() * if aslant { 0.5f32.sqrt() } else { 1.0 })
    };
    let subject = Grid::new(w, h, opinion).joined(parted).cut();
    let mut plane = Plane::new(mask.width, mask.height, 0.0);
    for (i, inside) in subject.into_iter().enumerate() {
        plane.data[pixel(i)] = f32::from(u8::from(inside));
    }
    plane
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
        // Of 320 pixels above one half 200 are red, of the other 2,180 as many.
        let expected = 200.0 / 320.0 * (2180f32 / 320.0).ln() + 120.0 / 320.0 * (120f32 / 320.0 * 2180.0 / 1980.0).ln();
        assert!((found.divergence - expected).abs() < 0.05, "{} for {expected}", found.divergence);
        let cut = cut(&guide, &found.log_odds, &mask, [5, 5, 55, 55]);
        assert!((0..w * w).all(|i| cut.data[i] == f32::from(u8::from(red(i % w, i / w)))));
    }

    #[test]
    fn colour_bites_nothing_off_what_the_mask_is_sure_of() {
        // A red square with a grey roof, on grey: the roof has the ground's colour.
        let w = 60;
        let inside = |x: usize, y: usize| (20..40).contains(&x) && (20..40).contains(&y);
        let guide: Vec<[f32; 3]> = (0..w * w)
            .map(|i| if inside(i % w, i / w) && i / w >= 28 { [0.8, 0.1, 0.1] } else { [0.5, 0.5, 0.5] })
            .collect();
        let data = (0..w * w).map(|i| if inside(i % w, i / w) { 0.85 } else { 0.04 }).collect();
        let mask = Plane { width: w, height: w, data };
        let found = evidence(&guide, &mask, [10, 10, 50, 50]);
        let cut = cut(&guide, &found.log_odds, &mask, [10, 10, 50, 50]);
        assert!((0..w * w).all(|i| cut.data[i] == f32::from(u8::from(inside(i % w, i / w)))));
    }

    #[test]
    fn a_part_that_the_network_doubts_goes_with_what_it_is_like() {
        // A dark animal on straw, with a head of its own colour that the network holds for less likely than not.
        let w = 80;
        let body = |x: usize, y: usize| (20..50).contains(&x) && (30..60).contains(&y);
        let head = |x: usize, y: usize| (50..62).contains(&x) && (20..40).contains(&y);
        let guide: Vec<[f32; 3]> = (0..w * w)
            .map(|i| if body(i % w, i / w) || head(i % w, i / w) { [0.2, 0.15, 0.1] } else { [0.7, 0.6, 0.4] })
            .collect();
        let probability = |x, y| {
            if body(x, y) {
                0.9
            } else if head(x, y) {
                0.35
            } else {
                0.1
            }
        };
        let mask = Plane { width: w, height: w, data: (0..w * w).map(|i| probability(i % w, i / w)).collect() };
        let found = evidence(&guide, &mask, [5, 5, 75, 75]);
        let cut = cut(&guide, &found.log_odds, &mask, [5, 5, 75, 75]);
        assert!((0..w * w).all(|i| (cut.data[i] == 1.0) == (body(i % w, i / w) || head(i % w, i / w))));
    }

    #[test]
    fn one_colour_tells_nothing() {
        let mut mask = Plane::new(30, 30, 0.2);
        (0..900).filter(|i| i % 30 > 9 && i % 30 < 20).for_each(|i| mask.data[i] = 0.9);
        let found = evidence(&[[0.3; 3]; 900], &mask, [0, 0, 30, 30]);
        assert!(found.divergence.abs() < 1e-4 && found.log_odds.data.iter().all(|v| v.abs() < 1e-3));
        let cut = cut(&[[0.3; 3]; 900], &found.log_odds, &mask, [0, 0, 30, 30]);
        assert!((0..900).all(|i| (cut.data[i] > 0.5) == (mask.data[i] > 0.5)));
    }
}
