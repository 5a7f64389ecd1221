//! Gaussians to begin with: the sparse points, as wide as their neighbours are away; without points, at random places that
//! the photos see.

use glam::{DVec3, Vec3};
use rayon::prelude::*;

use super::{Options, Pictures, Strategy};
use crate::geo::similarity::Similarity;
use crate::photos::Poses;
use crate::splat::train::random::Random;
use crate::splat::{Camera, Gaussians, SH_C0, SH_COEFFICIENTS};
use crate::{Error, Result};

/// What the first Gaussians were made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum From {
    Points(usize),
    Random(usize),
}

/// gsplat's: half the side of the cube of random places, in extents.
const AROUND: f32 = 3.0;
/// The same for a cut-out thing that the cameras look at, in their median distance: 3DGS's 1.3 for cameras at 4.03.
const AROUND_A_THING: f32 = 0.33;

/// At most `room` of them.
///
/// # Errors
/// Usage where no photo sees any of them.
pub fn gaussians(
    poses: &Poses,
    to_unit: &Similarity,
    pictures: &Pictures,
    extent: f32,
    room: usize,
    options: &Options,
) -> Result<(Gaussians, From)> {
    let local = |(p, color): &(DVec3, [u8; 3])| (to_unit.apply(*p).as_vec3(), color.map(|v| f32::from(v) / 255.0));
    let mut points: Vec<(Vec3, [f32; 3])> = poses
        .points
        .iter()
        .map(local)
        .filter(|(p, _)| p.is_finite() && p.length() < super::sky::beyond(extent))
        .collect();
    let mut random = Random::new(options.seed ^ 0x706f_696e);
    let is_random = points.is_empty();
    if is_random {
        let half = if pictures.alpha { AROUND_A_THING } else { AROUND * extent };
        let mut unit = || random.uniform();
        let mut vector = || Vec3::new(unit(), unit(), unit());
        points =
            (0..options.random_points).map(|_| ((vector() * 2.0 - Vec3::ONE) * half, vector().to_array())).collect();
        let cameras: Vec<Camera> = pictures.targets.iter().filter(|t| t.weight > 0.0).map(|t| t.camera).collect();
        let seen: Vec<bool> = points.par_iter().map(|(p, _)| cameras.iter().any(|c| sees(c, *p))).collect();
        let mut at = seen.iter();
        points.retain(|_| *at.next().unwrap_or(&false));
        if points.is_empty() {
            return Err(Error::usage("photos")
                .expected("cameras that see the space around what they look at")
                .found("none that sees any of it"));
        }
    }
    let points = thinned(&points, room);
    let n = points.len();
    let places: Vec<Vec3> = points.iter().map(|p| p.0).collect();
    let (opacity, share) = match options.strategy {
        Strategy::Paper => (0.1f32, 1.0f32),
        // As gsplat begins it.
        Strategy::Mcmc => (0.5, 0.1),
    };
    let spacing = spacing(&places);
    let g = Gaussians {
        log_scales: spacing.iter().map(|s| Vec3::splat((s.clamp(1e-5, extent) * share).ln())).collect(),
        rotations: vec![[1.0, 0.0, 0.0, 0.0]; n],
        logit_opacities: vec![(opacity / (1.0 - opacity)).ln(); n],
        sh: points.iter().map(|(_, color)| flat(*color)).collect(),
        positions: places,
    };
    Ok((g, if is_random { From::Random(n) } else { From::Points(n) }))
}

/// All of them, or `room` of them evenly.
fn thinned<T: Copy>(all: &[T], room: usize) -> Vec<T> {
    let n = all.len().min(room);
    (0..n).map(|i| all[i * all.len() / n]).collect()
}

/// The same colour from everywhere.
pub fn flat(color: [f32; 3]) -> [[f32; 3]; SH_COEFFICIENTS] {
    let mut sh = [[0.0; 3]; SH_COEFFICIENTS];
    sh[0] = color.map(|v| (v - 0.5) / SH_C0);
    sh
}

/// Whether a point is in front of a camera and in its picture.
pub fn sees(c: &Camera, p: Vec3) -> bool {
    pixel(c, p).is_some()
}

/// Whether it is in front of a camera and in its picture or up to a fifth of one beside it: something wide may reach in.
pub fn nearly_sees(c: &Camera, p: Vec3) -> bool {
    let q = c.rotation * p + c.translation;
    let (x, y) = (c.fx * q.x / q.z + c.cx, c.fy * q.y / q.z + c.cy);
    let (w, h) = (c.width as f32, c.height as f32);
    q.z > 0.01 && (-0.2 * w..1.2 * w).contains(&x) && (-0.2 * h..1.2 * h).contains(&y)
}

/// Where a point falls in the picture.
pub fn pixel(c: &Camera, p: Vec3) -> Option<[f32; 2]> {
    let q = c.rotation * p + c.translation;
    let at = [c.fx * q.x / q.z + c.cx, c.fy * q.y / q.z + c.cy];
    let inside = q.z > 0.01 && (0.0..c.width as f32).contains(&at[0]) && (0.0..c.height as f32).contains(&at[1]);
    inside.then_some(at)
}

/// Root of the mean squared distance to the three nearest others, as 3DGS has it. 0 for a point alone.
pub fn spacing(points: &[Vec3]) -> Vec<f32> {
    let tree = Tree::new(points);
    (0..points.len())
        .into_par_iter()
        .map(|i| {
            let near = tree.nearest(points, i);
            let known: Vec<f32> = near.into_iter().filter(|d| d.is_finite()).collect();
            (known.iter().sum::<f32>() / known.len().max(1) as f32).sqrt()
        })
        .collect()
}

/// A k-d tree (Bentley 1975): each part split along its longest side at its middle.
struct Tree {
    order: Vec<usize>,
    nodes: Vec<Node>,
}

enum Node {
    /// Points from..to of the order.
    Leaf(usize, usize),
    /// Axis, where it is split, and the node of what lies above; that of what lies below comes next.
    Split(usize, f32, usize),
}

/// Points that are looked through one by one.
const LEAF: usize = 12;

impl Tree {
    fn new(points: &[Vec3]) -> Tree {
        let mut tree = Tree { order: (0..points.len()).collect(), nodes: Vec::new() };
        tree.build(points, 0, points.len());
        tree
    }

    fn build(&mut self, points: &[Vec3], from: usize, to: usize) -> usize {
        let node = self.nodes.len();
        self.nodes.push(Node::Leaf(from, to));
        if to - from > LEAF {
            let part = &mut self.order[from..to];
            let (low, high) = part
                .iter()
                .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(l, h), i| (l.min(points[*i]), h.max(points[*i])));
            let size = high - low;
            let axis = if size.x >= size.y.max(size.z) { 0 } else { 1 + usize::from(size.z > size.y) };
            let middle = part.len() / 2;
            part.select_nth_unstable_by(middle, |a, b| points[*a][axis].total_cmp(&points[*b][axis]).then(a.cmp(b)));
            let at = points[part[middle]][axis];
            self.build(points, from, from + middle);
            let above = self.build(points, from + middle, to);
            self.nodes[node] = Node::Split(axis, at, above);
        }
        node
    }

    /// Squared distances to the three nearest others.
    fn nearest(&self, points: &[Vec3], of: usize) -> [f32; 3] {
        let mut near = [f32::INFINITY; 3];
        self.search(points, of, 0, &mut near);
        near
    }

    fn search(&self, points: &[Vec3], of: usize, node: usize, near: &mut [f32; 3]) {
        match self.nodes[node] {
            Node::Leaf(from, to) => {
                for j in self.order[from..to].iter().filter(|j| **j != of) {
                    let d = points[*j].distance_squared(points[of]);
                    if d < near[2] {
                        near[2] = d;
                        near.sort_unstable_by(f32::total_cmp);
                    }
                }
            }
            Node::Split(axis, at, above) => {
                let off = points[of][axis] - at;
                let (first, second) = if off < 0.0 { (node + 1, above) } else { (above, node + 1) };
                self.search(points, of, first, near);
                if off * off <= near[2] {
                    self.search(points, of, second, near);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn too_many_points_become_as_many_as_there_is_room_for() {
        let all: Vec<usize> = (0..12_040).collect();
        assert_eq!(thinned(&all, 20_000), all);
        let some = thinned(&all, 12_000);
        assert_eq!(some.len(), 12_000);
        // Evenly, each at most once, first and last parts alike.
        assert!(some.windows(2).all(|w| (1..=2).contains(&(w[1] - w[0]))) && some[6000] == 6020);
        assert!(thinned(&all, 0).is_empty());
    }

    #[test]
    fn neighbours_are_those_that_looking_at_all_finds() {
        let mut random = Random::new(4);
        for n in [1usize, 2, 3, 13, 400] {
            let mut points: Vec<Vec3> =
                (0..n).map(|_| Vec3::new(random.uniform(), 5.0 * random.uniform(), random.uniform())).collect();
            // Some twice.
            for i in 0..n / 5 {
                points[n - 1 - i] = points[i];
            }
            let found = spacing(&points);
            for i in 0..n {
                let mut all: Vec<f32> =
                    (0..n).filter(|j| *j != i).map(|j| points[j].distance_squared(points[i])).collect();
                all.sort_by(f32::total_cmp);
                all.truncate(3);
                let expected = (all.iter().sum::<f32>() / all.len().max(1) as f32).sqrt();
                assert!((found[i] - expected).abs() < 1e-6, "{n} {i}: {} {expected}", found[i]);
            }
        }
    }
}
