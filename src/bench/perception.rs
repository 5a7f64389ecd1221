//! PQ, perceptual quality: one picture against the true one, both sRGB 0..1 and of the same size.

use super::Picture;
use crate::mesh::color::to_linear;
use crate::models::{Graph, Tensor};
use crate::{Error, Result};

/// What equal pictures get, in place of infinity.
pub const MOST_DECIBELS: f64 = 100.0;

/// 10 log₁₀ (1 / mean squared error), dB, over all pixels and channels; at most [`MOST_DECIBELS`].
pub fn psnr(a: &[[f32; 3]], b: &[[f32; 3]]) -> f64 {
    let square = |(x, y): (&[f32; 3], &[f32; 3])| -> f64 { (0..3).map(|k| f64::from(x[k] - y[k]).powi(2)).sum() };
    let mean = a.iter().zip(b).map(square).sum::<f64>() / (3 * a.len().max(1)) as f64;
    if mean > 0.0 { (-10.0 * mean.log10()).min(MOST_DECIBELS) } else { MOST_DECIBELS }
}

/// Half of SSIM's window of 11, and its Gaussian's deviation.
const REACH: usize = 5;
const SIGMA: f64 = 1.5;
const C1: f64 = 0.01 * 0.01;
const C2: f64 = 0.03 * 0.03;

/// A channel, rows from the top.
#[derive(Clone)]
struct Plane {
    width: usize,
    height: usize,
    data: Vec<f64>,
}

impl Plane {
    fn product(&self, other: &Plane) -> Plane {
        Plane { data: self.data.iter().zip(&other.data).map(|(a, b)| a * b).collect(), ..*self }
    }

    /// Filtered by the window where it lies inside the picture: `REACH` smaller on every side.
    fn filtered(&self) -> Plane {
        let mut taps = [0.0; 2 * REACH + 1];
        for (i, t) in taps.iter_mut().enumerate() {
            let d = i as f64 - REACH as f64;
            *t = (-d * d / (2.0 * SIGMA * SIGMA)).exp();
        }
        let sum: f64 = taps.iter().sum();
        taps.iter_mut().for_each(|t| *t /= sum);
        let (width, height) = (self.width - 2 * REACH, self.height - 2 * REACH);
        let mut across = vec![0.0; width * self.height];
        for (out, row) in across.chunks_exact_mut(width).zip(self.data.chunks_exact(self.width)) {
            for (k, t) in taps.iter().enumerate() {
                out.iter_mut().zip(&row[k..]).for_each(|(o, v)| *o += t * v);
            }
        }
        let mut data = vec![0.0; width * height];
        for (y, out) in data.chunks_exact_mut(width).enumerate() {
            for (k, t) in taps.iter().enumerate() {
                let row = &across[(y + k) * width..(y + k + 1) * width];
                out.iter_mut().zip(row).for_each(|(o, v)| *o += t * v);
            }
        }
        Plane { width, height, data }
    }

    /// Means of 2 × 2 pixels.
    fn halved(&self) -> Plane {
        let (width, height) = (self.width / 2, self.height / 2);
        let at = |x: usize, y: usize| self.data[y * self.width + x];
        let data = (0..width * height)
            .map(|i| {
                let (x, y) = (i % width * 2, i / width * 2);
                (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) / 4.0
            })
            .collect();
        Plane { width, height, data }
    }
}

fn channels(p: &Picture) -> [Plane; 3] {
    std::array::from_fn(|k| Plane {
        width: p.width,
        height: p.height,
        data: p.pixels.iter().map(|v| f64::from(v[k])).collect(),
    })
}

/// Means of SSIM and of its contrast-structure part over one channel.
fn similarity(a: &Plane, b: &Plane) -> (f64, f64) {
    let (ma, mb) = (a.filtered(), b.filtered());
    let (aa, bb, ab) = (a.product(a).filtered(), b.product(b).filtered(), a.product(b).filtered());
    let (mut whole, mut structure) = (0.0, 0.0);
    for i in 0..ma.data.len() {
        let (x, y) = (ma.data[i], mb.data[i]);
        let (vx, vy, c) = (aa.data[i] - x * x, bb.data[i] - y * y, ab.data[i] - x * y);
        let s = (2.0 * c + C2) / (vx + vy + C2);
        structure += s;
        whole += s * (2.0 * x * y + C1) / (x * x + y * y + C1);
    }
    let n = ma.data.len().max(1) as f64;
    (whole / n, structure / n)
}

/// Structural similarity (Wang et al. 2004, eq. 13): 11 × 11 Gaussian window of σ 1.5, weighted covariances, the mean
/// over the windows that lie inside the picture and over the three channels. None below 11 pixels a side.
pub fn ssim(a: &Picture, b: &Picture) -> Option<f64> {
    let fits = a.width.min(a.height) > 2 * REACH && (a.width, a.height) == (b.width, b.height);
    fits.then(|| channels(a).iter().zip(&channels(b)).map(|(a, b)| similarity(a, b).0).sum::<f64>() / 3.0)
}

/// Weights of the scales (Wang et al. 2003).
const SCALES: [f64; 5] = [0.0448, 0.2856, 0.3001, 0.2363, 0.1333];

/// Multi-scale structural similarity (Wang et al. 2003, eq. 7) of the same windows, the mean over the channels: five
/// scales, each half the size of the one before. Pictures below 176 pixels a side have fewer, their weights made to add
/// up to one again; None below 11.
pub fn ms_ssim(a: &Picture, b: &Picture) -> Option<f64> {
    ssim(a, b)?;
    let least = a.width.min(a.height);
    let scales = (0..SCALES.len()).take_while(|s| least >> s > 2 * REACH).count();
    // The authors' five add up to 1.0001 and stand as they are.
    let sum: f64 = if scales == SCALES.len() { 1.0 } else { SCALES[..scales].iter().sum() };
    let mut total = 0.0;
    for (mut a, mut b) in channels(a).into_iter().zip(channels(b)) {
        let mut product = 1.0;
        for (s, weight) in SCALES[..scales].iter().enumerate() {
            let (whole, structure) = similarity(&a, &b);
            let term = if s + 1 == scales { whole } else { structure };
            // Anticorrelated pictures: a power of a negative number is none.
            product *= term.max(0.0).powf(weight / sum);
            (a, b) = (a.halved(), b.halved());
        }
        total += product / 3.0;
    }
    Some(total)
}

/// CIE 1976 L*a*b* of an sRGB colour under D65 (IEC 61966-2-1; CIE 15).
pub fn lab(c: [f32; 3]) -> [f64; 3] {
    const TO_XYZ: [[f64; 3]; 3] = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]];
    const WHITE: [f64; 3] = [0.950_455_927_051_672, 1.0, 1.089_057_750_759_878];
    let linear = c.map(|v| f64::from(to_linear(v.clamp(0.0, 1.0))));
    let [x, y, z] = std::array::from_fn(|i| {
        let t = (0..3).map(|k| TO_XYZ[i][k] * linear[k]).sum::<f64>() / WHITE[i];
        if t > 216.0 / 24389.0 { t.cbrt() } else { (24389.0 / 27.0 * t + 16.0) / 116.0 }
    });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// The colour difference CIEDE2000 of two L*a*b* colours (Sharma et al. 2005, eqs. 2–22), all parametric factors 1.
pub fn ciede2000(p: [f64; 3], q: [f64; 3]) -> f64 {
    let mean_c = (p[1].hypot(p[2]) + q[1].hypot(q[2])) / 2.0;
    let seventh = |c: f64| (c.powi(7) / (c.powi(7) + 25f64.powi(7))).sqrt();
    let g = 0.5 * (1.0 - seventh(mean_c));
    let polar = |v: [f64; 3]| {
        let a = (1.0 + g) * v[1];
        let hue = if a == 0.0 && v[2] == 0.0 { 0.0 } else { v[2].atan2(a).to_degrees().rem_euclid(360.0) };
        (a.hypot(v[2]), hue)
    };
    let ((c1, h1), (c2, h2)) = (polar(p), polar(q));
    let (dl, dc) = (q[0] - p[0], c2 - c1);
    let grey = c1 * c2 == 0.0;
    let turn = match h2 - h1 {
        _ if grey => 0.0,
        d if d > 180.0 => d - 360.0,
        d if d < -180.0 => d + 360.0,
        d => d,
    };
    let dh = 2.0 * (c1 * c2).sqrt() * (turn.to_radians() / 2.0).sin();
    let (l, c) = ((p[0] + q[0]) / 2.0, (c1 + c2) / 2.0);
    let h = match h1 + h2 {
        sum if grey => sum,
        sum if (h1 - h2).abs() <= 180.0 => sum / 2.0,
        sum if sum < 360.0 => (sum + 360.0) / 2.0,
        sum => (sum - 360.0) / 2.0,
    };
    let cos = |degrees: f64| degrees.to_radians().cos();
    let t = 1.0 - 0.17 * cos(h - 30.0) + 0.24 * cos(2.0 * h) + 0.32 * cos(3.0 * h + 6.0) - 0.20 * cos(4.0 * h - 63.0);
    let around = 30.0 * (-((h - 275.0) / 25.0).powi(2)).exp();
    let turned = -(2.0 * around.to_radians()).sin() * 2.0 * seventh(c);
    let from_grey = (l - 50.0).powi(2);
    let sl = 1.0 + 0.015 * from_grey / (20.0 + from_grey).sqrt();
    let (sc, sh) = (1.0 + 0.045 * c, 1.0 + 0.015 * c * t);
    let (l, c, h) = (dl / sl, dc / sc, dh / sh);
    (l * l + c * c + h * h + turned * c * h).max(0.0).sqrt()
}

/// The mean of [`ciede2000`] over the pixels that `counted`; None where there are none.
pub fn delta_e_2000(a: &[[f32; 3]], b: &[[f32; 3]], counted: impl Fn(usize) -> bool) -> Option<f64> {
    let (mut sum, mut n) = (0.0, 0usize);
    for (i, (x, y)) in a.iter().zip(b).enumerate().filter(|(i, _)| counted(*i)) {
        debug_assert!(i < a.len());
        sum += if x == y { 0.0 } else { ciede2000(lab(*x), lab(*y)) };
        n += 1;
    }
    (n > 0).then(|| sum / n as f64)
}

/// Variance of the Laplacian [0 1 0; 1 −4 1; 0 1 0] of the luma, inside the picture (Pech-Pacheco et al. 2000).
pub fn sharpness(p: &Picture) -> f64 {
    let luma = p.luma();
    let at = |x: usize, y: usize| f64::from(luma[y * p.width + x]);
    let (mut sum, mut squares, mut n) = (0.0, 0.0, 0.0);
    for y in 1..p.height.saturating_sub(1) {
        for x in 1..p.width.saturating_sub(1) {
            let v = at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1) - 4.0 * at(x, y);
            (sum, squares, n) = (sum + v, squares + v * v, n + 1.0);
        }
    }
    if n > 0.0 { (squares / n - (sum / n).powi(2)).max(0.0) } else { 0.0 }
}

/// The smaller of both pictures' [`sharpness`] over the larger: 1 for equally sharp ones, less for a blurred and for a
/// noisy one. None where the true picture has no edge.
pub fn sharpness_ratio(found: &Picture, truth: &Picture) -> Option<f64> {
    let (a, b) = (sharpness(found), sharpness(truth));
    (b > 0.0).then(|| (a / b).min(b / a.max(1e-300)))
}

/// Learned perceptual distance (Zhang et al. 2018) by a graph with the inputs `ref` and `dist`, 1 × 3 × height × width,
/// normalised as ImageNet's networks want it, and the one number `score` as output.
///
/// # Errors
/// As the graph; environment where it answers something else.
pub fn lpips(found: &Picture, truth: &Picture, graph: &dyn Graph) -> Result<f64> {
    const MEAN: [f32; 3] = [0.485, 0.456, 0.406];
    const DEVIATION: [f32; 3] = [0.229, 0.224, 0.225];
    let planes = |p: &Picture| {
        let one = |k: usize| p.pixels.iter().map(move |v| (v[k].clamp(0.0, 1.0) - MEAN[k]) / DEVIATION[k]);
        Tensor::new(&[1, 3, p.height, p.width], (0..3).flat_map(one).collect())
    };
    let (truth, found) = (planes(truth)?, planes(found)?);
    let out = graph.run(&[("ref", &truth), ("dist", &found)])?;
    match out.first().map(|(_, t)| t.data.as_slice()) {
        Some([score]) if score.is_finite() => Ok(f64::from(*score)),
        other => Err(Error::environment("--lpips")
            .expected("one number")
            .found(other.map_or("no output".into(), |d| format!("{} numbers", d.len())))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Waves and a step, different in every channel.
    pub fn pattern(size: usize) -> Picture {
        let at = |i: usize| {
            let (x, y) = ((i % size) as f32, (i / size) as f32);
            let wave = 0.5 + 0.3 * (0.35 * x).sin() * (0.21 * y).cos();
            let step = if x > y { 0.15 } else { 0.0 };
            [wave + step, 0.8 * wave + 0.1, 1.0 - wave]
        };
        Picture::new(size, size, (0..size * size).map(at).collect())
    }

    #[test]
    fn equal_pictures_are_perfect() {
        let p = pattern(192);
        assert_eq!(psnr(&p.pixels, &p.pixels), MOST_DECIBELS);
        assert!((ssim(&p, &p).unwrap() - 1.0).abs() < 1e-12 && (ms_ssim(&p, &p).unwrap() - 1.0).abs() < 1e-12);
        assert_eq!((delta_e_2000(&p.pixels, &p.pixels, |_| true), sharpness_ratio(&p, &p)), (Some(0.0), Some(1.0)));
        let small = pattern(10);
        assert_eq!((ssim(&small, &small), ms_ssim(&small, &small)), (None, None));
        assert!((ms_ssim(&pattern(40), &pattern(40)).unwrap() - 1.0).abs() < 1e-12, "fewer scales");
    }

    #[test]
    fn a_constant_error_has_its_closed_form() {
        let p = pattern(64);
        let lighter: Vec<[f32; 3]> = p.pixels.iter().map(|c| c.map(|v| v + 0.1)).collect();
        assert!((psnr(&p.pixels, &lighter) - 20.0).abs() < 1e-5);
        let flat = |v: f32| Picture::new(32, 32, vec![[v; 3]; 1024]);
        let expected = (2.0 * 0.4 * 0.6 + C1) / (0.4f64.powi(2) + 0.6f64.powi(2) + C1);
        assert!((ssim(&flat(0.4), &flat(0.6)).unwrap() - expected).abs() < 1e-6);
        assert_eq!(sharpness_ratio(&flat(0.4), &flat(0.4)), None);
    }

    /// Pairs of Sharma et al. 2005, table 1: those where hue means and rotations go wrong.
    #[test]
    fn ciede2000_is_sharmas() {
        for (p, q, expected) in [
            ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
            ([50.0, -1.3802, -84.2814], [50.0, 0.0, -82.7485], 1.0000),
            ([50.0, 0.0, 0.0], [50.0, -1.0, 2.0], 2.3669),
            ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0009], 7.1792),
            ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0011], 7.2195),
            ([50.0, -0.0010, 2.4900], [50.0, 0.0011, -2.4900], 4.7461),
            ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
            ([60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644),
            ([22.7233, 20.0904, -46.6940], [23.0331, 14.9730, -42.5619], 2.0373),
            ([2.0776, 0.0795, -1.1350], [0.9033, -0.0636, -0.5514], 0.9082),
        ] {
            let (found, back) = (ciede2000(p, q), ciede2000(q, p));
            assert!((found - expected).abs() < 5e-5 && (found - back).abs() < 1e-9, "{found} for {expected}");
        }
    }
}
