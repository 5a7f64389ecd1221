//! Guided filter with a colour guide: a coarse mask takes on the picture's edges.
//!
//! K. He, J. Sun, X. Tang, "Guided Image Filtering", IEEE TPAMI 35(6), 2013, Eq. 19–21.

use crate::photo::Plane;
use rayon::prelude::*;

/// `guide` is sRGB 0..1 of the plane's size; `radius` in pixels; `eps` is the variance below which the guide counts as
/// flat. The result is not clamped.
pub fn guided_filter(guide: &[[f32; 3]], input: &Plane, radius: usize, eps: f32) -> Plane {
    let (w, h) = (input.width, input.height);
    assert_eq!(guide.len(), w * h, "guide and input differ in size");
    let colour: Vec<Plane> = (0..3).map(|c| box_mean(w, h, radius, |i| guide[i][c])).collect();
    let plain = box_mean(w, h, radius, |i| input.data[i]);
    let cross: Vec<Plane> = (0..3).map(|c| box_mean(w, h, radius, |i| guide[i][c] * input.data[i])).collect();
    const PAIRS: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    let square: Vec<Plane> =
        PAIRS.iter().map(|&(a, b)| box_mean(w, h, radius, |i| guide[i][a] * guide[i][b])).collect();

    let coefficients: Vec<[f32; 4]> = (0..w * h)
        .into_par_iter()
        .map(|i| {
            let m = [colour[0].data[i], colour[1].data[i], colour[2].data[i]];
            let s: [f32; 6] = std::array::from_fn(|k| {
                let (a, b) = PAIRS[k];
                square[k].data[i] - m[a] * m[b] + if a == b { eps } else { 0.0 }
            });
            let c: [f32; 3] = std::array::from_fn(|k| cross[k].data[i] - m[k] * plain.data[i]);
            let a = solve_symmetric(s, c);
            [a[0], a[1], a[2], plain.data[i] - a[0] * m[0] - a[1] * m[1] - a[2] * m[2]]
        })
        .collect();
    let smooth: Vec<Plane> = (0..4).map(|k| box_mean(w, h, radius, |i| coefficients[i][k])).collect();
    let data = (0..w * h)
        .into_par_iter()
        .map(|i| (0..3).map(|c| smooth[c].data[i] * guide[i][c]).sum::<f32>() + smooth[3].data[i])
        .collect();
    Plane { width: w, height: h, data }
}

/// S a = c for a symmetric positive definite S, upper triangle by rows: Cramer's rule.
fn solve_symmetric([xx, xy, xz, yy, yz, zz]: [f32; 6], c: [f32; 3]) -> [f32; 3] {
    let (a, b, d) = (yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy);
    let (e, f, g) = (xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy);
    let inverse = 1.0 / (xx * a + xy * b + xz * d);
    [
        inverse * (a * c[0] + b * c[1] + d * c[2]),
        inverse * (b * c[0] + e * c[1] + f * c[2]),
        inverse * (d * c[0] + f * c[1] + g * c[2]),
    ]
}

/// Mean over the (2r + 1)² window, cut at the border. Sums run in f64 so that they do not drift.
pub(super) fn box_mean(w: usize, h: usize, radius: usize, value: impl Fn(usize) -> f32 + Sync) -> Plane {
    let mut rows = vec![0.0f32; w * h];
    rows.par_chunks_mut(w).enumerate().for_each(|(y, out)| {
        let at = |x: usize| f64::from(value(y * w + x));
        let mut sum: f64 = (0..radius.min(w)).map(at).sum();
        for (x, out) in out.iter_mut().enumerate() {
            if x + radius < w {
                sum += at(x + radius);
            }
            if x > radius {
                sum -= at(x - radius - 1);
            }
            let count = (x + radius).min(w - 1) + 1 - x.saturating_sub(radius);
            *out = (sum / count as f64) as f32;
        }
    });
    // Bands of rows, each with its own start, so that the sums do not depend on the number of threads.
    const BAND: usize = 64;
    let mut data = vec![0.0f32; w * h];
    data.par_chunks_mut(w * BAND).enumerate().for_each(|(band, out)| {
        let top = band * BAND;
        let mut sum = vec![0.0f64; w];
        let add = |sum: &mut [f64], y: usize, sign: f64| {
            sum.iter_mut().zip(&rows[y * w..]).for_each(|(s, v)| *s += sign * f64::from(*v));
        };
        (top.saturating_sub(radius)..(top + radius).min(h)).for_each(|y| add(&mut sum, y, 1.0));
        for (dy, line) in out.chunks_mut(w).enumerate() {
            let y = top + dy;
            if y + radius < h {
                add(&mut sum, y + radius, 1.0);
            }
            if dy > 0 && y > radius {
                add(&mut sum, y - radius - 1, -1.0);
            }
            let count = ((y + radius).min(h - 1) + 1 - y.saturating_sub(radius)) as f64;
            line.iter_mut().zip(&sum).for_each(|(v, s)| *v = (s / count) as f32);
        }
    });
    Plane { width: w, height: h, data }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn box_mean_is_the_mean() {
        let (w, h, r) = (23, 150, 4);
        let value = |i: usize| ((i * 7919) % 101) as f32;
        let fast = box_mean(w, h, r, value);
        for (x, y) in [(0usize, 0usize), (22, 149), (11, 63), (11, 64), (11, 65), (3, 128), (22, 70usize)] {
            let (mut sum, mut count) = (0.0, 0);
            for yy in y.saturating_sub(r)..=(y + r).min(h - 1) {
                for xx in x.saturating_sub(r)..=(x + r).min(w - 1) {
                    sum += value(yy * w + xx);
                    count += 1;
                }
            }
            assert!((fast.at(x, y) - sum / count as f32).abs() < 1e-2, "at {x},{y}");
        }
    }

    #[test]
    fn a_constant_stays() {
        let guide: Vec<[f32; 3]> = (0..400).map(|i| [(i % 20) as f32 / 20.0, 0.3, (i / 20) as f32 / 20.0]).collect();
        let out = guided_filter(&guide, &Plane::new(20, 20, 0.7), 3, 1e-3);
        assert!(out.data.iter().all(|v| (v - 0.7).abs() < 1e-4));
    }

    #[test]
    fn a_flat_guide_only_blurs() {
        let mut spot = Plane::new(31, 31, 0.0);
        spot.data[15 * 31 + 15] = 1.0;
        let out = guided_filter(&[[0.5; 3]; 31 * 31], &spot, 2, 1e-3);
        assert!((out.data.iter().sum::<f32>() - 1.0).abs() < 1e-3 && out.at(15, 15) < 0.05);
    }

    #[test]
    fn a_blurred_step_moves_to_the_edge_of_the_guide() {
        let (w, edge) = (64, 37);
        let guide: Vec<[f32; 3]> =
            (0..w * w).map(|i| if i % w < edge { [0.2, 0.5, 0.1] } else { [0.7, 0.4, 0.3] }).collect();
        // The mask's own edge is five pixels off and ten wide.
        let ramp = |x: usize| ((x as f32 - 27.0) / 10.0).clamp(0.0, 1.0);
        let mask = Plane { width: w, height: w, data: (0..w * w).map(|i| ramp(i % w)).collect() };
        let out = guided_filter(&guide, &mask, 12, 1e-4);
        let jump = out.at(edge, 32) - out.at(edge - 1, 32);
        assert!(jump > 0.5 && out.at(edge - 8, 32) < 0.4, "{jump}");
    }
}
