//! Colours for what no view sees and what no triangle covers.

use glam::Vec3;
use rayon::prelude::*;

/// Colours (or ratios of colour) around known points: a coarse grid, filled outward.
pub struct Surroundings {
    cells: Vec<[f32; 3]>,
}

impl Surroundings {
    const N: usize = 40;
    const HALF: f32 = 1.1;

    fn cell(p: Vec3) -> usize {
        let q = ((p + Vec3::splat(Self::HALF)) / (2.0 * Self::HALF) * Self::N as f32)
            .clamp(Vec3::ZERO, Vec3::splat(Self::N as f32 - 1.0));
        (q.z as usize * Self::N + q.y as usize) * Self::N + q.x as usize
    }

    /// What is known, and outward from it the neighbours' mean times `keep` from cell to cell.
    pub fn new(known: impl Iterator<Item = (Vec3, [f32; 3])>, keep: f32) -> Self {
        let n = Self::N;
        let mut sums = vec![[0f64; 4]; n * n * n];
        for (p, color) in known {
            let sum = &mut sums[Self::cell(p)];
            for (s, c) in sum.iter_mut().zip(color) {
                *s += c as f64;
            }
            sum[3] += 1.0;
        }
        let mut cells: Vec<Option<[f32; 3]>> =
            sums.iter().map(|s| (s[3] > 0.0).then(|| [s[0], s[1], s[2]].map(|c| (c / s[3]) as f32))).collect();
        let mut front: Vec<usize> = (0..cells.len()).filter(|&i| cells[i].is_some()).collect();
        while !front.is_empty() {
            let mut next = std::collections::BTreeMap::<usize, ([f32; 3], f32)>::new();
            for &i in &front {
                let Some(color) = cells[i] else { continue };
                let at = [i % n, i / n % n, i / (n * n)];
                for (axis, stride) in [(0, 1), (1, n), (2, n * n)] {
                    let below = (at[axis] > 0).then(|| i - stride);
                    let above = (at[axis] + 1 < n).then_some(i + stride);
                    for j in [below, above].into_iter().flatten().filter(|&j| cells[j].is_none()) {
                        let sum = next.entry(j).or_default();
                        for (s, c) in sum.0.iter_mut().zip(color) {
                            *s += c;
                        }
                        sum.1 += 1.0;
                    }
                }
            }
            front = next.keys().copied().collect();
            for (i, (color, count)) in next {
                cells[i] = Some(color.map(|c| keep * c / count));
            }
        }
        Surroundings { cells: cells.into_iter().map(|c| c.unwrap_or_default()).collect() }
    }

    /// Trilinear between cell centres.
    pub fn at(&self, p: Vec3) -> [f32; 3] {
        let n = Self::N;
        let q = (p + Vec3::splat(Self::HALF)) / (2.0 * Self::HALF) * n as f32 - Vec3::splat(0.5);
        let q = q.clamp(Vec3::ZERO, Vec3::splat(n as f32 - 1.001));
        let low = [q.x as usize, q.y as usize, q.z as usize];
        let t = q - Vec3::new(low[0] as f32, low[1] as f32, low[2] as f32);
        let mut sum = [0f32; 3];
        for corner in 0..8 {
            let up = [corner & 1, corner >> 1 & 1, corner >> 2];
            let share: f32 = (0..3).map(|k| if up[k] == 1 { t[k] } else { 1.0 - t[k] }).product();
            let cell = ((low[2] + up[2]) * n + low[1] + up[1]) * n + low[0] + up[0];
            for (s, c) in sum.iter_mut().zip(self.cells[cell]) {
                *s += share * c;
            }
        }
        sum
    }
}

/// Colours for texels that no triangle covers: neighbours first, then ever larger blocks' means, so that
/// neither bilinear lookups nor smaller pictures of the texture pick up anything foreign.
pub fn pad(color: &mut [[f32; 3]], covered: impl Fn(usize) -> bool, size: usize) {
    let mut known: Vec<bool> = (0..color.len()).map(covered).collect();
    for _ in 0..3 {
        let fresh: Vec<(usize, [f32; 3])> = (0..size * size)
            .into_par_iter()
            .filter(|&i| !known[i])
            .filter_map(|i| {
                let (x, y) = (i % size, i / size);
                let (mut sum, mut count) = ([0f32; 3], 0f32);
                for y in y.saturating_sub(1)..(y + 2).min(size) {
                    for x in x.saturating_sub(1)..(x + 2).min(size) {
                        if known[y * size + x] {
                            for (s, c) in sum.iter_mut().zip(color[y * size + x]) {
                                *s += c;
                            }
                            count += 1.0;
                        }
                    }
                }
                (count > 0.0).then(|| (i, sum.map(|s| s / count)))
            })
            .collect();
        for (i, c) in fresh {
            color[i] = c;
            known[i] = true;
        }
    }
    fill_from_blocks(color, &known, size);
}

fn fill_from_blocks(color: &mut [[f32; 3]], known: &[bool], size: usize) {
    if size < 2 || known.iter().all(|k| *k) {
        return;
    }
    let half = size / 2;
    let mut small = vec![[0f32; 3]; half * half];
    let mut small_known = vec![false; half * half];
    for i in 0..half * half {
        let (x, y) = (i % half * 2, i / half * 2);
        let mut count = 0.0;
        for j in [y * size + x, y * size + x + 1, (y + 1) * size + x, (y + 1) * size + x + 1] {
            if known[j] {
                for (s, c) in small[i].iter_mut().zip(color[j]) {
                    *s += c;
                }
                count += 1.0;
            }
        }
        if count > 0.0 {
            small[i] = small[i].map(|s| s / count);
            small_known[i] = true;
        }
    }
    fill_from_blocks(&mut small, &small_known, half);
    for (i, c) in color.iter_mut().enumerate() {
        if !known[i] {
            *c = small[i / size / 2 * half + i % size / 2];
        }
    }
}
