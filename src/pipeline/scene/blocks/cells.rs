//! Cells of the ground and the photos that show them.

use glam::Vec3;
use rayon::prelude::*;

use crate::splat::render::Drawers;
use crate::splat::{Camera, Gaussians};

/// A cell's neighbours' ground that is trained with it, in sides of a cell.
const OVERLAP: f32 = 0.1;
/// A photo is of a cell if at least this part of its pixels shows the cell and its overlap.
const SHOWN: f32 = 0.03;
/// Pixels across the pictures by which that is found out.
const SMALL: u32 = 96;
/// What is farther out says nothing of the cells' size: quantiles of x and of y.
const TAIL: f32 = 0.05;
/// As far as anything is.
const FAR: f32 = 1e19;

/// An upright column over a rectangle of the ground: low ≤ p < high in x and y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    pub low: [f32; 2],
    pub high: [f32; 2],
}

impl Cell {
    pub const ALL: Cell = Cell { low: [-FAR; 2], high: [FAR; 2] };

    pub fn holds(&self, p: Vec3) -> bool {
        (0..2).all(|k| p[k] >= self.low[k] && p[k] < self.high[k])
    }

    /// Larger on all sides.
    pub fn grown(&self, by: f32) -> Cell {
        Cell { low: self.low.map(|v| (v - by).max(-FAR)), high: self.high.map(|v| (v + by).min(FAR)) }
    }
}

/// Where most of the points lie: the tails cut off, low and high.
fn middle(points: &[Vec3]) -> [[f32; 2]; 2] {
    let mut out = [[0.0; 2]; 2];
    for k in 0..2 {
        let mut of: Vec<f32> = points.iter().map(|p| p[k]).collect();
        of.sort_unstable_by(f32::total_cmp);
        let at = |share: f32| of.get((share * of.len().saturating_sub(1) as f32) as usize).copied().unwrap_or(0.0);
        (out[0][k], out[1][k]) = (at(TAIL), at(1.0 - TAIL));
    }
    out
}

/// `count` cells that together are the whole plane, each with about as many of the points: cut in two across the longer side
/// until there are enough. And how far each reaches into its neighbours.
pub fn cells(points: &[Vec3], count: usize) -> (Vec<Cell>, f32) {
    let finite: Vec<Vec3> = points.iter().filter(|p| p.is_finite()).copied().collect();
    let [low, high] = middle(&finite);
    let side = ((high[0] - low[0]) * (high[1] - low[1]) / count.max(1) as f32).sqrt();
    let mut out = Vec::with_capacity(count);
    cut(finite, Cell::ALL, count.max(1), &mut out);
    (out, OVERLAP * side)
}

fn cut(mut points: Vec<Vec3>, cell: Cell, count: usize, out: &mut Vec<Cell>) {
    if count == 1 {
        out.push(cell);
        return;
    }
    let [low, high] = middle(&points);
    let axis = usize::from(high[1] - low[1] > high[0] - low[0]);
    points.sort_unstable_by(|a, b| a[axis].total_cmp(&b[axis]));
    let first = count / 2;
    // Clones of one place fall to one side.
    let at = points.get(points.len() * first / count).map_or(0.5 * (low[axis] + high[axis]), |p| p[axis]);
    let from = points.partition_point(|p| p[axis] < at);
    let above = points.split_off(from);
    let (mut a, mut b) = (cell, cell);
    (a.high[axis], b.low[axis]) = (at, at);
    cut(points, a, first, out);
    cut(above, b, count - first, out);
}

/// Where each pixel's surface lies; `None` where nothing is opaque.
pub fn surface(drawers: &Drawers, camera: &Camera) -> Vec<Option<Vec3>> {
    let frame = drawers.render(camera, [0.0; 3]);
    let (eye, back) = (camera.position(), camera.rotation.transpose());
    let at = |i: usize| {
        let (x, y) = ((i % frame.width) as f32 + 0.5, (i / frame.width) as f32 + 0.5);
        let z = frame.median_depth[i];
        (z > 0.0).then(|| eye + back * (Vec3::new((x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, 1.0) * z))
    };
    (0..frame.median_depth.len()).map(at).collect()
}

/// For each photo, the part of its pixels that shows each cell, by the surfaces of `g`.
pub fn shares(g: &Gaussians, cameras: &[Camera], cells: &[Cell]) -> Vec<Vec<f32>> {
    let drawers = Drawers::new(g);
    cameras
        .par_iter()
        .map(|c| {
            let small = c.resized(SMALL, (SMALL * c.height).div_ceil(c.width.max(1)).max(1));
            let seen = surface(&drawers, &small);
            let of = |cell: &Cell| seen.iter().flatten().filter(|p| cell.holds(**p)).count() as f32;
            cells.iter().map(|cell| of(cell) / seen.len().max(1) as f32).collect()
        })
        .collect()
}

/// The photos of a cell: those that show enough of it, else the two that show most of it; none where none shows any.
/// `usable`: those that may be trained on.
pub fn photos_of(cell: usize, shares: &[Vec<f32>], usable: &[bool]) -> Vec<usize> {
    let share = |i: &usize| shares[*i][cell];
    let mut all: Vec<usize> = (0..shares.len()).filter(|i| usable[*i] && share(i) > 0.0).collect();
    let enough: Vec<usize> = all.iter().filter(|i| share(i) >= SHOWN).copied().collect();
    if enough.len() >= 2 {
        return enough;
    }
    all.sort_by(|a, b| share(b).total_cmp(&share(a)).then(a.cmp(b)));
    all.truncate(2);
    all.sort_unstable();
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splat::train::random::Random;

    fn points(n: usize) -> Vec<Vec3> {
        let mut r = Random::new(3);
        (0..n).map(|_| Vec3::new(4.0 * r.normal(), r.normal(), r.uniform())).collect()
    }

    #[test]
    fn every_place_lies_in_one_cell_and_cells_are_about_as_full() {
        let all = points(4000);
        for count in [1, 2, 3, 4, 7, 16] {
            let (cells, overlap) = cells(&all, count);
            assert_eq!(cells.len(), count);
            assert!(overlap > 0.0 && overlap < 1.3, "{overlap}");
            let far = [Vec3::splat(1e6), Vec3::new(-1e9, 3.0, 0.0)];
            for p in all.iter().chain(&far) {
                assert_eq!(cells.iter().filter(|c| c.holds(*p)).count(), 1, "{p}");
            }
            for c in &cells {
                let own = all.iter().filter(|p| c.holds(**p)).count();
                assert!(own.abs_diff(all.len() / count) < 20, "{own} of {count}");
                assert!(all.iter().all(|p| !c.holds(*p) || c.grown(overlap).holds(*p)));
            }
        }
        // The same place many times: still cells, some empty.
        let (same, _) = cells(&[Vec3::ONE; 50], 4);
        assert_eq!(same.iter().filter(|c| c.holds(Vec3::ONE)).count(), 1);
        assert_eq!(cells(&[], 3).0.len(), 3);
    }

    #[test]
    fn a_cell_has_the_photos_that_show_it() {
        let shares = [vec![0.5, 0.0], vec![0.2, 0.01], vec![0.0, 0.02], vec![0.9, 0.9]];
        assert_eq!(photos_of(0, &shares, &[true; 4]), [0, 1, 3]);
        assert_eq!(photos_of(1, &shares, &[true; 4]), [2, 3]);
        assert_eq!(photos_of(1, &shares, &[true, true, true, false]), [1, 2]);
        assert_eq!(photos_of(1, &shares[..1], &[true]), [0usize; 0]);
    }

    #[test]
    fn what_a_camera_shows_lies_where_it_is() {
        use crate::splat::SH_COEFFICIENTS;
        // A wall of discs at y = 2, from x = -2 to 2.
        let mut g = Gaussians::default();
        for i in 0..41 {
            for k in 0..41 {
                g.positions.push(Vec3::new(i as f32 * 0.1 - 2.0, 2.0, k as f32 * 0.1 - 2.0));
                g.log_scales.push(Vec3::new(0.1, 0.01, 0.1).map(f32::ln));
                g.rotations.push([1.0, 0.0, 0.0, 0.0]);
                g.logit_opacities.push(5.0);
                g.sh.push([[0.0; 3]; SH_COEFFICIENTS]);
            }
        }
        let camera = Camera::look_at(Vec3::ZERO, Vec3::Y, 0.8, 64);
        let seen = surface(&Drawers::new(&g), &camera);
        assert!(seen.iter().all(|p| p.is_some_and(|p| (p.y - 2.0).abs() < 0.05)));
        // The left half of the picture is the wall's left half.
        let left = Cell { low: [-9.0, -9.0], high: [0.0, 9.0] };
        let shares = shares(&g, &[camera], &[left, left.grown(100.0), Cell::ALL]);
        assert!((shares[0][0] - 0.5).abs() < 0.03 && shares[0][1] > 0.99 && shares[0][2] > 0.99, "{shares:?}");
    }
}
