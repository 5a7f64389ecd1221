//! Resampling with the right prefilter: any rectangle of a picture to any size.

use super::Plane;
use rayon::prelude::*;

/// In pixels of the source, corners at integers; may reach outside the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    pub x: f32,
    pub y: f32,
    pub width: f32,
    pub height: f32,
}

/// What lies outside the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edge {
    /// The nearest pixel of the border.
    Clamp,
    /// The picture mirrored about its border.
    Mirror,
    Zero,
}

impl Edge {
    fn index(self, i: i64, len: usize) -> Option<usize> {
        let n = len as i64;
        match self {
            _ if (0..n).contains(&i) => Some(i as usize),
            Edge::Clamp => Some(i.clamp(0, n - 1) as usize),
            Edge::Mirror => {
                let k = i.rem_euclid(2 * n);
                Some(if k < n { k } else { 2 * n - 1 - k } as usize)
            }
            Edge::Zero => None,
        }
    }
}

/// For each output sample the source samples that it takes and their weights.
///
/// Catmull-Rom (Keys 1981, a = −1/2), stretched by the ratio where the picture shrinks, so that nothing aliases.
fn taps(start: f32, extent: f32, out: usize, len: usize, edge: Edge) -> Vec<Vec<(usize, f32)>> {
    let step = f64::from(extent) / out as f64;
    let stretch = step.max(1.0);
    (0..out)
        .map(|i| {
            let centre = f64::from(start) + (i as f64 + 0.5) * step;
            let first = (centre - 2.0 * stretch - 0.5).ceil() as i64;
            let last = (centre + 2.0 * stretch - 0.5).floor() as i64;
            let weights: Vec<(i64, f64)> =
                (first..=last).map(|j| (j, catmull_rom((j as f64 + 0.5 - centre) / stretch))).collect();
            let sum: f64 = weights.iter().map(|w| w.1).sum();
            weights.iter().filter_map(|&(j, w)| Some((edge.index(j, len)?, (w / sum) as f32))).collect()
        })
        .collect()
}

fn catmull_rom(x: f64) -> f64 {
    let x = x.abs();
    if x < 1.0 {
        (1.5 * x - 2.5) * x * x + 1.0
    } else if x < 2.0 {
        ((-0.5 * x + 2.5) * x - 4.0) * x + 2.0
    } else {
        0.0
    }
}

/// Separable: columns shrink first, only on the rows that are needed.
fn separable<const C: usize>(
    size: (usize, usize),
    at: impl Fn(usize, usize) -> [f32; C] + Sync,
    rect: Rect,
    out: (usize, usize),
    edge: Edge,
) -> Vec<[f32; C]> {
    let columns = taps(rect.x, rect.width, out.0, size.0, edge);
    let rows = taps(rect.y, rect.height, out.1, size.1, edge);
    let used = rows.iter().flatten().map(|t| t.0);
    let (low, high) = (used.clone().min().unwrap_or(0), used.max().map_or(0, |m| m + 1));
    let mut narrow = vec![[0.0f32; C]; (high - low) * out.0];
    narrow.par_chunks_mut(out.0).enumerate().for_each(|(row, line)| {
        for (value, taps) in line.iter_mut().zip(&columns) {
            for &(x, weight) in taps {
                let pixel = at(x, low + row);
                (0..C).for_each(|c| value[c] += weight * pixel[c]);
            }
        }
    });
    let mut result = vec![[0.0f32; C]; out.0 * out.1];
    result.par_chunks_mut(out.0).zip(&rows).for_each(|(line, taps)| {
        for &(y, weight) in taps {
            for (value, pixel) in line.iter_mut().zip(&narrow[(y - low) * out.0..]) {
                (0..C).for_each(|c| value[c] += weight * pixel[c]);
            }
        }
    });
    result
}

/// sRGB 0..1, row-major, `width` × `height` samples of `rect`.
pub fn sample_colour(picture: &image::RgbImage, rect: Rect, width: usize, height: usize, edge: Edge) -> Vec<[f32; 3]> {
    let size = (picture.width() as usize, picture.height() as usize);
    let raw = picture.as_raw();
    let at = |x: usize, y: usize| {
        let i = 3 * (y * size.0 + x);
        [f32::from(raw[i]), f32::from(raw[i + 1]), f32::from(raw[i + 2])]
    };
    let mut out = separable(size, at, rect, (width, height), edge);
    out.iter_mut().flatten().for_each(|v| *v = (*v / 255.0).clamp(0.0, 1.0));
    out
}

/// Values are clamped to the range of the source, so that a mask stays a mask.
pub fn sample_plane(plane: &Plane, rect: Rect, width: usize, height: usize, edge: Edge) -> Plane {
    let size = (plane.width, plane.height);
    let mut low = plane.data.iter().copied().fold(f32::INFINITY, f32::min);
    let mut high = plane.data.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    if edge == Edge::Zero {
        (low, high) = (low.min(0.0), high.max(0.0));
    }
    let data = separable(size, |x, y| [plane.at(x, y)], rect, (width, height), edge)
        .into_iter()
        .map(|[v]| v.max(low).min(high))
        .collect();
    Plane { width, height, data }
}

/// `size` × `size` samples of a picture of `width` × `height`, each where `at` says that its middle lies, in pixels of the picture with
/// corners at integers; outside of it as its border.
///
/// Catmull-Rom as [`sample_plane`], not stretched: the picture is to be about as fine as the samples.
pub fn sampled_at<const C: usize>(
    picture: &[[f32; C]],
    (width, height): (usize, usize),
    size: usize,
    at: impl Fn(usize, usize) -> [f32; 2] + Sync,
) -> Vec<[f32; C]> {
    let near = |i: f32, len: usize| {
        let first = (i - 0.5).floor();
        [-1.0, 0.0, 1.0, 2.0f32].map(|k| {
            let weight = catmull_rom(f64::from(first + k + 0.5 - i)) as f32;
            ((first + k).clamp(0.0, (len - 1) as f32) as usize, weight)
        })
    };
    let mut out = vec![[0.0; C]; size * size];
    out.par_chunks_mut(size).enumerate().for_each(|(y, line)| {
        for (x, value) in line.iter_mut().enumerate() {
            let [across, down] = at(x, y);
            let columns = near(across, width);
            for (row, by) in near(down, height) {
                for (column, weight) in columns {
                    let pixel = picture[row * width + column];
                    (0..C).for_each(|c| value[c] += by * weight * pixel[c]);
                }
            }
        }
    });
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramp(width: usize, height: usize) -> Plane {
        let data = (0..width * height).map(|i| (i % width) as f32 + 0.5 + 2.0 * (i / width) as f32).collect();
        Plane { width, height, data }
    }

    #[test]
    fn weights_sum_to_one_inside() {
        for (start, extent, out) in [(0.0, 40.0, 7), (3.3, 10.5, 64), (-5.0, 60.0, 13)] {
            for line in taps(start, extent, out, 40, Edge::Mirror) {
                assert!((line.iter().map(|t| t.1).sum::<f32>() - 1.0).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn a_ramp_is_sampled_at_the_right_places() {
        let source = ramp(64, 48);
        for size in [8usize, 20, 50] {
            let rect = Rect { x: 20.25, y: 16.5, width: 16.0, height: 12.0 };
            let out = sample_plane(&source, rect, size, size, Edge::Clamp);
            for (x, y) in [(0, 0), (size - 1, 0), (size / 2, size - 1)] {
                let want = rect.x
                    + (x as f32 + 0.5) * rect.width / size as f32
                    + 2.0 * (rect.y + (y as f32 + 0.5) * rect.height / size as f32 - 0.5);
                // Off a whole ratio the stretched kernel keeps a ramp only to a few hundredths of a pixel.
                assert!((out.at(x, y) - want).abs() < 0.06, "{size}: {} {want}", out.at(x, y));
            }
        }
    }

    #[test]
    fn same_size_is_the_same_picture() {
        let source = ramp(9, 7);
        let out = sample_plane(&source, Rect { x: 0.0, y: 0.0, width: 9.0, height: 7.0 }, 9, 7, Edge::Zero);
        assert!(source.data.iter().zip(&out.data).all(|(a, b)| (a - b).abs() < 1e-5));
    }

    #[test]
    fn stripes_finer_than_the_output_become_grey() {
        let stripes = Plane { width: 256, height: 16, data: (0..256 * 16).map(|i| (i % 2) as f32).collect() };
        let out = sample_plane(&stripes, Rect { x: 0.0, y: 0.0, width: 256.0, height: 16.0 }, 32, 2, Edge::Mirror);
        // The mirrored border doubles a stripe; it is left out.
        assert!((2..30).all(|x| (out.at(x, 0) - 0.5).abs() < 1e-3), "{:?}", out.data);
    }

    #[test]
    fn outside_is_what_the_edge_says() {
        let source = Plane::new(8, 8, 1.0);
        let rect = Rect { x: -8.0, y: 0.0, width: 16.0, height: 8.0 };
        let zero = sample_plane(&source, rect, 16, 8, Edge::Zero);
        assert!(zero.at(2, 4) == 0.0 && (zero.at(12, 4) - 1.0).abs() < 1e-5);
        assert!(sample_plane(&source, rect, 16, 8, Edge::Mirror).data.iter().all(|v| (v - 1.0).abs() < 1e-5));
    }
}
