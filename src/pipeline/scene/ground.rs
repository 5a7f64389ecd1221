//! Which Gaussians are ground and which stand on it: the simple morphological filter (Pingel, Clarke and McBride 2013, "An
//! improved simple morphological filter for the terrain classification of airborne LIDAR data") over the Gaussians' heights.
//!
//! Low heights on a grid → openings (Zhang et al. 2003) with windows from one cell to the largest thing's size; what falls by
//! more than the slope explains is no ground → the ground's heights there from around → a Gaussian that lies close to them is
//! ground. Lengths in the unit of the Gaussians, Z up.

mod expected;
mod membrane;
mod parts;
mod smooth;
mod surface;

use glam::Vec3;

use crate::splat::Gaussians;
pub use expected::{Expected, expected};
pub use membrane::fill;
pub use surface::{Against, Surface};

/// Half the width of the widest thing that is told from the ground, in the unit frame: cameras stand at a distance of 1.
const WIDEST: f32 = 0.25;

/// How ground is told from what stands on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filter {
    /// Side of a cell, at least; wider where Gaussians are few.
    pub cell: f32,
    /// Half the width of the widest thing that may stand on the ground.
    pub widest: f32,
    /// The steepest ground: rise over run.
    pub slope: f32,
    /// A Gaussian higher above the ground is none; more where the ground's own Gaussians scatter more.
    pub step: f32,
    /// Ground is looked for up to this distance from the middle, along x and y.
    pub reach: f32,
}

impl Default for Filter {
    /// For the unit frame: cameras stand at a distance of 1 from what they look at (all found by trial on made places).
    fn default() -> Self {
        Filter { cell: 0.015, widest: WIDEST, slope: 0.2, step: 0.008, reach: 3.0 }
    }
}

/// Fainter Gaussians say nothing of where the ground is.
const OPAQUE: f32 = 0.3;
/// The height of a cell: this quantile of its Gaussians', so that those below the ground, which photos hardly tell from it, do
/// not count.
const LOW: f32 = 0.5;
/// Gaussians that a cell should have in the middle of the scene.
const A_CELL: f32 = 4.0;
/// What scatters so many standard deviations is still the same.
const SCATTER: f32 = 2.5;
/// A cell so many times what ground scatters below what is around it is a hole or a floater.
const HOLE: f32 = 2.0;
/// A median of absolute deviations as a standard deviation.
const MAD: f32 = 1.4826;
/// Ground farther out is less sure, in steps a unit of distance.
const FARTHER: f32 = 2.0;

/// Heights of the ground, row by row from the least y.
#[derive(Clone, Debug, PartialEq)]
pub struct Terrain {
    pub heights: Vec<f32>,
    /// Cells along x and along y.
    pub side: usize,
    pub cell: f32,
    /// Of the first cell's lower corner, x and y.
    pub from: f32,
    /// By which the heights of neighbouring cells of ground may differ.
    pub step: f32,
}

impl Terrain {
    /// Between the cells' centres, bilinear; as at the border outside.
    pub fn height(&self, x: f32, y: f32) -> f32 {
        let last = (self.side - 1) as f32;
        let at = |v: f32| ((v - self.from) / self.cell - 0.5).clamp(0.0, last);
        let (u, v) = (at(x), at(y));
        let (i, j) = (u as usize, v as usize);
        let (a, b) = (u - i as f32, v - j as f32);
        let of = |i: usize, j: usize| self.heights[j.min(self.side - 1) * self.side + i.min(self.side - 1)];
        let along = |j: usize| of(i, j) * (1.0 - a) + of(i + 1, j) * a;
        along(j) * (1.0 - b) + along(j + 1) * b
    }
}

/// The ground, and for every Gaussian whether it is of it. `None` where too few are opaque to say. `near`: the first so many are
/// not the sky's.
pub fn separated(g: &Gaussians, near: usize, filter: &Filter) -> Option<(Terrain, Vec<bool>)> {
    let logit = (OPAQUE / (1.0 - OPAQUE)).ln();
    let inside = |p: Vec3| p.is_finite() && p.x.abs() < filter.reach && p.y.abs() < filter.reach;
    let sure: Vec<Vec3> =
        (0..near).filter(|i| g.logit_opacities[*i] > logit).map(|i| g.positions[i]).filter(|p| inside(*p)).collect();
    let terrain = terrain(&sure, filter)?;
    // How the ground's own scatter about it.
    let off = sure.iter().map(|p| (p.z - terrain.height(p.x, p.y)).abs()).filter(|off| *off < 4.0 * terrain.step);
    let step = filter.step.max(SCATTER * MAD * median(off.collect()));
    let is_ground = |i: usize| {
        let p = g.positions[i];
        let out = (p.truncate().abs().max_element() - 1.0).max(0.0);
        i < near && p.is_finite() && p.z - terrain.height(p.x, p.y) < step * (1.0 + FARTHER * out)
    };
    let ground = (0..g.len()).map(is_ground).collect();
    Some((terrain, ground))
}

/// The ground below points. `None` for fewer than a hundred.
pub fn terrain(points: &[Vec3], filter: &Filter) -> Option<Terrain> {
    if points.len() < 100 {
        return None;
    }
    let third = filter.reach / 3.0;
    let central = points.iter().filter(|p| p.x.abs() < third && p.y.abs() < third).count().max(1);
    let cell = filter.cell.max((A_CELL / central as f32).sqrt() * 2.0 * third).min(filter.widest);
    let side = ((2.0 * filter.reach / cell).ceil() as usize).clamp(8, 2048);
    let from = -0.5 * side as f32 * cell;
    let mut cells: Vec<Vec<f32>> = vec![Vec::new(); side * side];
    for p in points {
        let at = |v: f32| (((v - from) / cell) as usize).min(side - 1);
        cells[at(p.y) * side + at(p.x)].push(p.z);
    }
    let low = |mut c: Vec<f32>| {
        c.sort_unstable_by(f32::total_cmp);
        c.get((LOW * c.len() as f32) as usize).copied()
    };
    let mut heights: Vec<Option<f32>> = cells.into_iter().map(low).collect();
    let around: Vec<Option<[f32; 2]>> = (0..heights.len()).map(|i| neighbours(&heights, side, i)).collect();
    let off = heights.iter().zip(&around).filter_map(|(h, a)| Some(((*h)? - (*a)?[1]).abs()));
    let step = filter.step.max(SCATTER * MAD * median(off.collect()));
    // Next to a house most of what is around is the house: the low ones count.
    for (h, around) in heights.iter_mut().zip(&around) {
        *h = h.filter(|h| around.is_none_or(|a| a[0] - *h < HOLE * step));
    }
    let surface = filled(&heights, side);
    // Openings with wider and wider windows: what is narrower than the window falls to the ground beside it.
    let mut is_ground: Vec<bool> = heights.iter().map(Option::is_some).collect();
    let mut last = surface.clone();
    for window in windows((filter.widest / cell).ceil() as usize) {
        let opened = dilated(&eroded(&last, side, window), side, window);
        let most = filter.slope * window as f32 * cell;
        for i in 0..surface.len() {
            is_ground[i] &= last[i] - opened[i] <= most.max(step);
        }
        last = opened;
    }
    let kept: Vec<Option<f32>> = heights.iter().zip(&is_ground).map(|(h, g)| h.filter(|_| *g)).collect();
    if kept.iter().flatten().count() < 16 {
        return None;
    }
    Some(Terrain { heights: smoothed(&filled(&kept, side), side), side, cell, from, step })
}

/// Half widths in cells, each half as wide again as the last, up to the widest.
fn windows(widest: usize) -> Vec<usize> {
    let mut out = vec![1];
    while let Some(last) = out.last().copied().filter(|l| *l < widest) {
        out.push((last + last.div_ceil(2)).min(widest));
    }
    out
}

/// Lower quarter and median of the cells around a cell, itself too; `None` where none is known.
fn neighbours(heights: &[Option<f32>], side: usize, i: usize) -> Option<[f32; 2]> {
    let (x, y) = (i % side, i / side);
    let mut around = Vec::with_capacity(49);
    for v in y.saturating_sub(3)..=(y + 3).min(side - 1) {
        around.extend(heights[v * side + x.saturating_sub(3)..=v * side + (x + 3).min(side - 1)].iter().flatten());
    }
    around.sort_unstable_by(f32::total_cmp);
    Some([*around.get(around.len() / 4)?, *around.get(around.len() / 2)?])
}

/// 0 of none.
fn median(mut all: Vec<f32>) -> f32 {
    all.sort_unstable_by(f32::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(0.0)
}

/// Where nothing is known, what is around: means of coarser and coarser grids (Gortler et al. 1996, pull and push).
fn filled(heights: &[Option<f32>], side: usize) -> Vec<f32> {
    if side == 1 {
        return vec![heights[0].unwrap_or(0.0)];
    }
    if heights.iter().all(Option::is_some) {
        return heights.iter().flatten().copied().collect();
    }
    let half = side.div_ceil(2);
    let coarse: Vec<Option<f32>> = (0..half * half)
        .map(|i| {
            let (x, y) = (2 * (i % half), 2 * (i / half));
            let of = |u: usize, v: usize| (u < side && v < side).then(|| heights[v * side + u]).flatten();
            let known: Vec<f32> =
                [of(x, y), of(x + 1, y), of(x, y + 1), of(x + 1, y + 1)].into_iter().flatten().collect();
            (!known.is_empty()).then(|| known.iter().sum::<f32>() / known.len() as f32)
        })
        .collect();
    let below = filled(&coarse, half);
    heights.iter().enumerate().map(|(i, h)| h.unwrap_or(below[i / side / 2 * half + i % side / 2])).collect()
}

fn eroded(h: &[f32], side: usize, window: usize) -> Vec<f32> {
    along_both(h, side, window, f32::min)
}

fn dilated(h: &[f32], side: usize, window: usize) -> Vec<f32> {
    along_both(h, side, window, f32::max)
}

/// The extreme of a square window of 2 window + 1 cells, first along x, then along y.
fn along_both(h: &[f32], side: usize, window: usize, pick: fn(f32, f32) -> f32) -> Vec<f32> {
    let pass = |h: &[f32], at: &dyn Fn(usize, usize) -> usize| {
        let mut out = vec![0.0; h.len()];
        for line in 0..side {
            for k in 0..side {
                let range = k.saturating_sub(window)..=(k + window).min(side - 1);
                out[at(line, k)] = range.map(|j| h[at(line, j)]).reduce(pick).unwrap_or(0.0);
            }
        }
        out
    };
    pass(&pass(h, &|y, x| y * side + x), &|x, y| y * side + x)
}

/// Means of three by three cells.
fn smoothed(h: &[f32], side: usize) -> Vec<f32> {
    (0..h.len())
        .map(|i| {
            let (x, y) = (i % side, i / side);
            let (mut sum, mut count) = (0.0, 0);
            for v in y.saturating_sub(1)..=(y + 1).min(side - 1) {
                for u in x.saturating_sub(1)..=(x + 1).min(side - 1) {
                    sum += h[v * side + u];
                    count += 1;
                }
            }
            sum / count as f32
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splat::train::random::Random;

    pub fn hill(x: f32, y: f32) -> f32 {
        0.08 * (1.3 * x).sin() * (0.9 * y + 0.4).cos() + 0.03 * x
    }

    /// Middle, half sizes and height of the boxes of [`place`].
    pub fn boxes() -> Vec<[f32; 5]> {
        let one = |k: usize| {
            let (sin, cos) = (k as f32 * 0.7).sin_cos();
            let far = 0.4 + 0.12 * k as f32;
            [far * cos, far * sin, 0.05 + 0.01 * k as f32, 0.04 + 0.015 * (k % 4) as f32, 0.05 + 0.02 * (k % 3) as f32]
        };
        (0..12).map(one).collect()
    }

    /// Points of hilly ground with boxes on it, a few of them floating below and above; with the truth.
    pub fn place() -> (Vec<Vec3>, Vec<bool>) {
        let mut r = Random::new(5);
        let boxes = boxes();
        let (mut points, mut truth) = (Vec::new(), Vec::new());
        for _ in 0..60_000 {
            let (x, y) = (4.0 * r.uniform() - 2.0, 4.0 * r.uniform() - 2.0);
            let within = boxes.iter().find(|b| (x - b[0]).abs() < b[2] && (y - b[1]).abs() < b[3]);
            let noise = 0.0015 * r.normal();
            match within {
                // The photos see its roof and its walls, not the ground below.
                Some(b) => {
                    let up = if r.uniform() < 0.5 { b[4] } else { b[4] * (0.25 + 0.75 * r.uniform()) };
                    points.push(Vec3::new(x, y, hill(b[0], b[1]) + up + noise));
                    truth.push(false);
                }
                None => {
                    points.push(Vec3::new(x, y, hill(x, y) + noise));
                    truth.push(true);
                }
            }
        }
        for k in 0..300 {
            let z = if k % 3 == 0 { -0.2 } else { 0.5 };
            points.push(Vec3::new(4.0 * r.uniform() - 2.0, 4.0 * r.uniform() - 2.0, z * (0.5 + r.uniform())));
            truth.push(k % 3 == 0);
        }
        (points, truth)
    }

    #[test]
    fn hills_are_ground_and_boxes_are_not() {
        let (points, truth) = place();
        let n = points.len();
        let g = Gaussians {
            positions: points,
            log_scales: vec![Vec3::splat(-4.0); n],
            rotations: vec![[1.0, 0.0, 0.0, 0.0]; n],
            logit_opacities: vec![2.0; n],
            sh: vec![[[0.0; 3]; 16]; n],
        };
        let (terrain, ground) = separated(&g, n, &Filter::default()).unwrap();
        let (mut both, mut either) = (0, 0);
        for (found, known) in ground.iter().zip(&truth).take(60_000) {
            both += u32::from(*found && *known);
            either += u32::from(*found || *known);
        }
        let iou = f64::from(both) / f64::from(either);
        assert!(iou > 0.97, "{iou}");
        let off = |k: usize| {
            let (x, y) = ((k % 37) as f32 * 0.1 - 1.8, (k / 37) as f32 * 0.1 - 1.8);
            (terrain.height(x, y) - hill(x, y)).abs()
        };
        let mut all: Vec<f32> = (0..37 * 37).map(off).collect();
        all.sort_by(f32::total_cmp);
        assert!(all[all.len() * 9 / 10] < 0.006, "{}", all[all.len() * 9 / 10]);
        // The sky's are no ground, nor is anything without enough to go by.
        assert!(!separated(&g, n - 300, &Filter::default()).unwrap().1[n - 300..].iter().any(|v| *v));
        assert!(separated(&g.filtered(|i| i < 50), 50, &Filter::default()).is_none());
    }

    #[test]
    fn windows_grow_to_the_widest_and_openings_take_what_is_narrower() {
        assert_eq!(windows(1), [1]);
        assert_eq!(windows(10), [1, 2, 3, 5, 8, 10]);
        let mut h = vec![0.0; 20 * 20];
        (0..3).for_each(|k| h[205 + k] = 1.0);
        assert!(dilated(&eroded(&h, 20, 2), 20, 2).iter().all(|v| *v == 0.0));
        h.iter_mut().skip(200).for_each(|v| *v = 1.0);
        assert_eq!(dilated(&eroded(&h, 20, 2), 20, 2), h);
        let some: Vec<Option<f32>> = (0..25).map(|i| (i == 7).then_some(3.0)).collect();
        assert_eq!(filled(&some, 5), [3.0; 25]);
    }
}
