//! Edge collapse by quadric error (Garland & Heckbert, "Surface Simplification Using Quadric Error Metrics", 1997).
//!
//! Each collapse keeps a closed mesh a closed manifold: it is done only under the link condition (Dey et al. 1999), when
//! no face turns over, and a vertex goes to where the summed quadric is least. One run from the finest surface gives all
//! levels in turn.

use super::Surface;
use super::clean::without_unused;
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Σ w (n·p + d)² as p'Ap + 2b'p + c.
#[derive(Clone, Copy, Default)]
pub(super) struct Quadric {
    a: [f64; 6], // xx xy xz yy yz zz
    b: DVec3,
    c: f64,
    pub(super) weight: f64,
}

impl Quadric {
    pub(super) fn plane(n: DVec3, d: f64, w: f64) -> Self {
        Quadric {
            a: [n.x * n.x, n.x * n.y, n.x * n.z, n.y * n.y, n.y * n.z, n.z * n.z].map(|v| v * w),
            b: n * (d * w),
            c: d * d * w,
            weight: w,
        }
    }
    /// Distance to a point: keeps vertices spread where planes say nothing.
    pub(super) fn point(p: DVec3, w: f64) -> Self {
        Quadric { a: [w, 0.0, 0.0, w, 0.0, w], b: -p * w, c: p.length_squared() * w, weight: 0.0 }
    }
    pub(super) fn plus(mut self, o: &Quadric) -> Self {
        for (a, b) in self.a.iter_mut().zip(o.a) {
            *a += b;
        }
        self.b += o.b;
        self.c += o.c;
        self.weight += o.weight;
        self
    }
    fn matrix(&self) -> DMat3 {
        let [xx, xy, xz, yy, yz, zz] = self.a;
        DMat3::from_cols(DVec3::new(xx, xy, xz), DVec3::new(xy, yy, yz), DVec3::new(xz, yz, zz))
    }
    pub(super) fn at(&self, p: DVec3) -> f64 {
        (p.dot(self.matrix() * p) + 2.0 * self.b.dot(p) + self.c).max(0.0)
    }
    /// The least point, held to within `reach` of `near`.
    pub(super) fn least(&self, near: DVec3, reach: f64) -> DVec3 {
        let trace = self.a[0] + self.a[3] + self.a[5];
        let hold = 1e-3 * trace + 1e-30;
        let m = self.matrix() + DMat3::from_diagonal(DVec3::splat(hold));
        let p = m.inverse() * (near * hold - self.b);
        if p.is_finite() && p.distance(near) <= reach { p } else { near }
    }
}

/// An edge: its cost, a non-negative number's bits (which sort as it does), its vertices and how often each had moved.
pub(super) type Candidate = (u64, [u32; 2], [u32; 2]);

/// Candidates, cheapest first. What costs `bound` or more is not sorted before its time: most of it never is.
#[derive(Default)]
pub(super) struct Queue {
    near: BinaryHeap<Reverse<Candidate>>,
    far: Vec<Candidate>,
    bound: u64,
}

impl Queue {
    pub(super) fn push(&mut self, candidate: Candidate) {
        match candidate.0 < self.bound {
            true => self.near.push(Reverse(candidate)),
            false => self.far.push(candidate),
        }
    }

    /// `valid`: whether a candidate still means anything; others may be left out.
    pub(super) fn pop(&mut self, valid: impl Fn(&Candidate) -> bool) -> Option<Candidate> {
        /// Sorted at a time.
        const SOME: usize = 4096;
        if self.near.is_empty() {
            self.far.retain(valid);
            let some = self.far.len().min(SOME.max(self.far.len() / 16));
            if some > 0 {
                let (_, last, _) = self.far.select_nth_unstable(some - 1);
                self.bound = last.0.saturating_add(1);
            }
            // Of candidates that cost the same as the last one, all.
            let bound = self.bound;
            let near: Vec<Reverse<Candidate>> = self.far.extract_if(.., |c| c.0 < bound).map(Reverse).collect();
            self.near = near.into();
        }
        self.near.pop().map(|Reverse(candidate)| candidate)
    }
}

/// A closed mesh being simplified; each call of [`reduce_to`](Simplifier::reduce_to) goes on from the last.
pub struct Simplifier {
    positions: Vec<DVec3>,
    quadrics: Vec<Quadric>,
    faces: Vec<[u32; 3]>,
    alive: Vec<bool>,
    faces_of: Vec<Vec<u32>>,
    stamps: Vec<u32>,
    vertices_left: usize,
    queue: Queue,
    /// Kept from collapse to collapse.
    rings: [Vec<u32>; 2],
    /// Cosine that a face's normal must keep through a collapse.
    turn: f64,
}

impl Simplifier {
    /// `surface` must be closed: every edge used by exactly two triangles.
    pub fn new(surface: &Surface) -> Self {
        let surface = without_unused(surface);
        let positions: Vec<DVec3> = surface.positions.iter().map(|p| p.as_dvec3()).collect();
        let mut quadrics = vec![Quadric::default(); positions.len()];
        let mut faces_of = vec![Vec::new(); positions.len()];
        for (f, t) in surface.triangles.iter().enumerate() {
            let [a, b, c] = t.map(|i| positions[i as usize]);
            let n = (b - a).cross(c - a);
            let area = n.length() / 2.0;
            for &i in t {
                faces_of[i as usize].push(f as u32);
                if area > 0.0 {
                    let n = n / (2.0 * area);
                    let i = i as usize;
                    quadrics[i] = quadrics[i]
                        .plus(&Quadric::plane(n, -n.dot(a), area / 3.0))
                        .plus(&Quadric::point(positions[i], 1e-4 * area / 3.0));
                }
            }
        }
        let mut simplifier = Simplifier {
            vertices_left: positions.len(),
            stamps: vec![0; positions.len()],
            alive: vec![true; surface.triangles.len()],
            faces: surface.triangles,
            positions,
            quadrics,
            faces_of,
            queue: Queue::default(),
            rings: Default::default(),
            turn: 0.2,
        };
        simplifier.refill();
        simplifier
    }

    pub fn vertices_left(&self) -> usize {
        self.vertices_left
    }

    fn refill(&mut self) {
        let now = &*self;
        let alive = (0..now.faces.len()).into_par_iter().filter(|f| now.alive[*f]);
        let far = alive.flat_map_iter(|f| {
            let [a, b, c] = now.faces[f];
            [(a, b), (b, c), (c, a)].into_iter().filter(|(a, b)| a < b).map(|(a, b)| now.candidate(a, b))
        });
        self.queue = Queue { far: far.collect(), ..Queue::default() };
    }

    fn candidate(&self, a: u32, b: u32) -> Candidate {
        let (a, b) = (a.min(b), a.max(b));
        let (_, cost) = self.target(a as usize, b as usize);
        // No −0.
        ((cost + 0.0).to_bits(), [a, b], [self.stamps[a as usize], self.stamps[b as usize]])
    }

    /// Where two vertices become one, and what that costs.
    fn target(&self, a: usize, b: usize) -> (DVec3, f64) {
        let q = self.quadrics[a].plus(&self.quadrics[b]);
        let (pa, pb) = (self.positions[a], self.positions[b]);
        let middle = (pa + pb) / 2.0;
        let best = q.least(middle, 2.0 * pa.distance(pb));
        (best, q.at(best))
    }

    /// Collapses edges until at most `vertices` are left; false when no collapse is possible any more before that.
    pub fn reduce_to(&mut self, vertices: usize) -> bool {
        let mut collapsed_since_refill = true;
        while self.vertices_left > vertices {
            let stamps = &self.stamps;
            let fresh = |c: &Candidate| c.1.map(|v| stamps[v as usize]) == c.2;
            let Some((_, vertices, stamps_then)) = self.queue.pop(fresh) else {
                // What was refused may be possible now; then with less care about turning faces; then never.
                if !collapsed_since_refill {
                    if self.turn < 0.0 {
                        return false;
                    }
                    self.turn -= 0.25;
                }
                collapsed_since_refill = false;
                self.refill();
                continue;
            };
            let [a, b] = vertices.map(|v| v as usize);
            if [self.stamps[a], self.stamps[b]] != stamps_then {
                continue;
            }
            collapsed_since_refill |= self.collapse(a, b);
        }
        true
    }

    fn ring(&self, v: usize, out: &mut Vec<u32>) {
        out.clear();
        for i in self.faces_of[v].iter().flat_map(|f| self.faces[*f as usize]) {
            // Few enough for a look at each: every one is met twice.
            if i as usize != v && !out.contains(&i) {
                out.push(i);
            }
        }
        out.sort_unstable();
    }

    fn collapse(&mut self, a: usize, b: usize) -> bool {
        let mut rings = std::mem::take(&mut self.rings);
        let collapsed = self.collapse_between(a, b, &mut rings);
        self.rings = rings;
        collapsed
    }

    /// `rings`: room for the vertices around either.
    fn collapse_between(&mut self, a: usize, b: usize, [ring_a, ring_b]: &mut [Vec<u32>; 2]) -> bool {
        self.ring(a, ring_a);
        if ring_a.binary_search(&(b as u32)).is_err() {
            return false;
        }
        self.ring(b, ring_b);
        let mut common = ring_a.iter().filter(|v| ring_b.binary_search(v).is_ok());
        let (two, more) = ([common.next(), common.next()], common.next());
        let [Some(&left), Some(&right)] = two else { return false };
        if more.is_some() || [left, right].iter().any(|&v| self.faces_of[v as usize].len() <= 3) {
            return false;
        }
        let (target, _) = self.target(a, b);
        if !self.stays_upright(a, b, target) || !self.stays_upright(b, a, target) {
            return false;
        }
        for f in std::mem::take(&mut self.faces_of[b]) {
            let face = &mut self.faces[f as usize];
            if face.contains(&(a as u32)) {
                self.alive[f as usize] = false;
                for v in *face {
                    self.faces_of[v as usize].retain(|&g| g != f);
                }
            } else {
                for v in face.iter_mut() {
                    if *v as usize == b {
                        *v = a as u32;
                    }
                }
                self.faces_of[a].push(f);
            }
        }
        self.positions[a] = target;
        self.quadrics[a] = self.quadrics[a].plus(&self.quadrics[b]);
        self.vertices_left -= 1;
        self.stamps[b] = u32::MAX;
        self.stamps[a] += 1;
        self.ring(a, ring_a);
        for &v in &*ring_a {
            let candidate = self.candidate(a as u32, v);
            self.queue.push(candidate);
        }
        true
    }

    /// No face around `v` but those shared with `other` turns over or becomes a needle when `v` moves to `target`.
    fn stays_upright(&self, v: usize, other: usize, target: DVec3) -> bool {
        self.faces_of[v].iter().all(|&f| {
            let face = self.faces[f as usize];
            if face.contains(&(other as u32)) {
                return true;
            }
            let old = face.map(|i| self.positions[i as usize]);
            let new = face.map(|i| if i as usize == v { target } else { self.positions[i as usize] });
            let normal = |p: [DVec3; 3]| (p[1] - p[0]).cross(p[2] - p[0]);
            let (before, after) = (normal(old), normal(new));
            let longest = (0..3).map(|k| new[k].distance_squared(new[(k + 1) % 3])).fold(0.0, f64::max);
            let needle = after.length() < 0.02 * longest;
            !needle && after.dot(before) >= self.turn * after.length() * before.length()
        })
    }

    /// Drops the connected part with the least volume; false when there is only one.
    pub fn drop_smallest_part(&mut self) -> bool {
        let mut part_of = vec![u32::MAX; self.positions.len()];
        let mut volumes: Vec<f64> = Vec::new();
        for start in 0..self.positions.len() {
            if part_of[start] != u32::MAX || self.faces_of[start].is_empty() {
                continue;
            }
            let part = volumes.len() as u32;
            let mut volume = 0.0;
            let mut stack = vec![start];
            part_of[start] = part;
            while let Some(v) = stack.pop() {
                for &f in &self.faces_of[v] {
                    let face = self.faces[f as usize];
                    let [p, q, r] = face.map(|i| self.positions[i as usize]);
                    volume += p.dot(q.cross(r)) / 18.0;
                    for i in face.map(|i| i as usize) {
                        if part_of[i] == u32::MAX {
                            part_of[i] = part;
                            stack.push(i);
                        }
                    }
                }
            }
            volumes.push(volume);
        }
        if volumes.len() < 2 {
            return false;
        }
        let smallest = (0..volumes.len()).min_by(|&i, &j| volumes[i].total_cmp(&volumes[j])).unwrap_or(0) as u32;
        for (v, part) in part_of.iter().enumerate() {
            if *part == smallest {
                for f in std::mem::take(&mut self.faces_of[v]) {
                    self.alive[f as usize] = false;
                }
                self.stamps[v] = u32::MAX;
                self.vertices_left -= 1;
            }
        }
        self.turn = 0.2;
        true
    }

    /// The mesh as it is now.
    pub fn surface(&self) -> Surface {
        without_unused(&Surface {
            positions: self.positions.iter().map(|p| p.as_vec3()).collect(),
            triangles: (0..self.faces.len()).filter(|&f| self.alive[f]).map(|f| self.faces[f]).collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::clean::edges_used_twice;
    use super::super::distance::Bvh;
    use super::super::scenes;
    use super::*;

    #[test]
    fn a_box_keeps_its_corners_down_to_few_vertices() {
        let surface = scenes::sampled(&scenes::boxed(0.6, 0.4, 0.3), 40);
        let mut simplifier = Simplifier::new(&surface);
        for target in [1000, 200, 40] {
            assert!(simplifier.reduce_to(target));
            let small = simplifier.surface();
            assert_eq!(small.positions.len(), target);
            assert!(edges_used_twice(&small.triangles));
            assert!(small.volume() > 0.0);
            let bvh = Bvh::new(&small.positions, &small.triangles);
            for p in &surface.positions {
                assert!(bvh.distance(*p) < 0.03, "{target}: {p} {}", bvh.distance(*p));
            }
        }
    }

    #[test]
    fn parts_drop_smallest_first_and_the_end_is_said() {
        let surface = scenes::sampled(&scenes::two_spheres(), 48);
        let mut simplifier = Simplifier::new(&surface);
        assert!(!simplifier.reduce_to(6));
        assert_eq!(simplifier.vertices_left(), 8);
        assert!(simplifier.drop_smallest_part());
        assert!(!simplifier.drop_smallest_part());
        let left = simplifier.surface();
        assert_eq!(left.positions.len(), 4);
        assert!(edges_used_twice(&left.triangles));
        assert!(left.positions.iter().all(|p| p.x < 0.2));
    }
}
