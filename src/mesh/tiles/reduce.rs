//! Edge collapse by quadric error for pieces of a surface: open at their rim, in regions whose borders stay borders, and with
//! vertices that must not move.
//!
//! [`simplify`](crate::mesh::simplify) takes closed meshes alone and gives levels one after another; quadrics and queue are its own,
//! shared, but what may be collapsed, and where to, is another rule here.
//!
//! A vertex on no rim and no border is free. One in the middle of a rim or border may slide along it, that is, become one with
//! a neighbour on it or meet it half-way. All others are held: where rims and borders meet, and what the caller names.
//! After Garland & Heckbert 1997; topology under the link condition for surfaces with boundary (Dey et al. 1999).

use glam::{DVec3, Vec3};
use std::collections::BTreeMap;

use super::super::simplify::{Candidate, Quadric, Queue};

/// A piece of surface.
pub struct Piece<'a> {
    pub positions: &'a [Vec3],
    pub triangles: &'a [[u32; 3]],
    /// One a triangle: the region that it is in, and stays in.
    pub regions: &'a [u32],
    /// One a vertex: must stay where it is, and stay.
    pub held: &'a [bool],
}

/// How far to go: both are limits.
#[derive(Clone, Copy, Debug)]
pub struct Goal {
    pub vertices: usize,
    /// Root mean square distance, by area, from the planes of the triangles that a vertex stands for.
    pub error: f32,
}

/// What is left of a piece; vertices have the numbers that they had.
pub struct Reduced {
    pub positions: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
    pub regions: Vec<u32>,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Hold {
    Free,
    /// On one rim or border.
    Slides,
    Held,
}

/// Cosine that a face's normal must keep through a collapse.
const TURN: f64 = 0.3;
/// Of the longest edge squared: twice the area of a face that is no needle.
const NEEDLE: f64 = 0.02;

struct Reducer<'a> {
    positions: Vec<DVec3>,
    quadrics: Vec<Quadric>,
    hold: Vec<Hold>,
    faces: Vec<[u32; 3]>,
    alive: Vec<bool>,
    faces_of: Vec<Vec<u32>>,
    stamps: Vec<u32>,
    regions: &'a [u32],
    left: usize,
    queue: Queue,
}

/// Collapses edges, cheapest first, until the goal is met or nothing more can be done.
pub fn reduce(piece: &Piece, goal: Goal) -> Reduced {
    let mut all = Reducer::new(piece);
    let mut before = usize::MAX;
    // What was refused may be possible after others; little comes of more than a few rounds.
    for _ in 0..4 {
        if all.left <= goal.vertices || before.saturating_sub(all.left) < all.left / 50 {
            break;
        }
        before = all.left;
        all.round(goal);
    }
    let kept = (0..all.faces.len()).filter(|f| all.alive[*f]);
    let (triangles, regions) = kept.map(|f| (all.faces[f], piece.regions[f])).unzip();
    Reduced { positions: all.positions.iter().map(|p| p.as_vec3()).collect(), triangles, regions }
}

impl<'a> Reducer<'a> {
    fn new(piece: &Piece<'a>) -> Self {
        let positions: Vec<DVec3> = piece.positions.iter().map(|p| p.as_dvec3()).collect();
        let mut quadrics = vec![Quadric::default(); positions.len()];
        let mut faces_of = vec![Vec::new(); positions.len()];
        let mut edges: BTreeMap<[u32; 2], (u32, u32, bool)> = BTreeMap::new();
        for (f, t) in piece.triangles.iter().enumerate() {
            let [a, b, c] = t.map(|i| positions[i as usize]);
            let normal = (b - a).cross(c - a);
            let area = normal.length() / 2.0;
            for (k, &i) in t.iter().enumerate() {
                faces_of[i as usize].push(f as u32);
                let j = t[(k + 1) % 3];
                let edge = edges.entry([i.min(j), i.max(j)]).or_insert((0, f as u32, false));
                edge.2 |= edge.0 > 0 && piece.regions[edge.1 as usize] != piece.regions[f];
                edge.0 += 1;
                if area > 0.0 {
                    let n = normal / (2.0 * area);
                    let i = i as usize;
                    quadrics[i] = quadrics[i]
                        .plus(&Quadric::plane(n, -n.dot(a), area / 3.0))
                        .plus(&Quadric::point(positions[i], 1e-4 * area / 3.0));
                }
            }
        }
        let mut lines = vec![0u32; positions.len()];
        let mut hold: Vec<Hold> = piece.held.iter().map(|held| if *held { Hold::Held } else { Hold::Free }).collect();
        for ([a, b], (count, face, border)) in edges {
            if count == 2 && !border {
                continue;
            }
            for v in [a, b] {
                lines[v as usize] += 1;
                if count > 2 {
                    hold[v as usize] = Hold::Held;
                }
            }
            if count == 1 {
                // A rim keeps its course: the plane upright on its face.
                let [p, q, r] = piece.triangles[face as usize].map(|i| positions[i as usize]);
                let along = positions[b as usize] - positions[a as usize];
                let upright = along.cross((q - p).cross(r - p)).normalize_or_zero();
                let plane = Quadric::plane(upright, -upright.dot(positions[a as usize]), along.length_squared() / 2.0);
                for v in [a, b] {
                    quadrics[v as usize] = quadrics[v as usize].plus(&plane);
                }
            }
        }
        for (hold, lines) in hold.iter_mut().zip(lines) {
            match lines {
                0 => {}
                2 => *hold = (*hold).max(Hold::Slides),
                _ => *hold = Hold::Held,
            }
        }
        Reducer {
            left: faces_of.iter().filter(|f| !f.is_empty()).count(),
            stamps: vec![0; positions.len()],
            alive: vec![true; piece.triangles.len()],
            faces: piece.triangles.to_vec(),
            positions,
            quadrics,
            hold,
            faces_of,
            regions: piece.regions,
            queue: Queue::default(),
        }
    }

    fn round(&mut self, goal: Goal) {
        let mut queue = Queue::default();
        for f in (0..self.faces.len()).filter(|f| self.alive[*f]) {
            let [a, b, c] = self.faces[f];
            for (a, b) in [(a, b), (b, c), (c, a)] {
                // An edge of the rim has one face only, and that may name it the other way round.
                if (a < b || self.shared(a, b).len() == 1)
                    && let Some(candidate) = self.candidate(a, b)
                {
                    queue.push(candidate);
                }
            }
        }
        self.queue = queue;
        while self.left > goal.vertices {
            let stamps = &self.stamps;
            let fresh = |c: &Candidate| c.1.map(|v| stamps[v as usize]) == c.2;
            let Some((_, [a, b], then)) = self.queue.pop(fresh) else { return };
            if [a, b].map(|v| self.stamps[v as usize]) == then {
                self.collapse(a, b, goal.error);
            }
        }
    }

    /// Faces with both vertices.
    fn shared(&self, a: u32, b: u32) -> Vec<u32> {
        self.faces_of[a as usize].iter().copied().filter(|f| self.faces[*f as usize].contains(&b)).collect()
    }

    /// Whether an edge lies on a rim or a border.
    fn is_line(&self, shared: &[u32]) -> bool {
        match shared {
            [_] => true,
            [f, g] => self.regions[*f as usize] != self.regions[*g as usize],
            _ => false,
        }
    }

    /// Where two vertices become one and what that costs; `None` where they must not.
    fn target(&self, a: u32, b: u32) -> Option<(DVec3, f64)> {
        let (hold_a, hold_b) = (self.hold[a as usize], self.hold[b as usize]);
        let (a, b, quiet) = if hold_a >= hold_b { (a, b, hold_b) } else { (b, a, hold_a) };
        let q = self.quadrics[a as usize].plus(&self.quadrics[b as usize]);
        let (p, other) = (self.positions[a as usize], self.positions[b as usize]);
        let middle = (p + other) / 2.0;
        match (self.hold[a as usize], quiet) {
            (Hold::Free, _) => {
                let best = q.least(middle, 2.0 * p.distance(other));
                Some((best, q.at(best)))
            }
            (_, Hold::Free) => Some((p, q.at(p))),
            _ if quiet == Hold::Held || !self.is_line(&self.shared(a, b)) => None,
            (Hold::Held, _) => Some((p, q.at(p))),
            // Half-way on an upright border is on it, to the bit.
            _ => [p, other, middle].map(|at| (at, q.at(at))).into_iter().min_by(|x, y| x.1.total_cmp(&y.1)),
        }
    }

    fn candidate(&self, a: u32, b: u32) -> Option<Candidate> {
        let (a, b) = (a.min(b), a.max(b));
        let (_, cost) = self.target(a, b)?;
        // No −0.
        Some(((cost + 0.0).to_bits(), [a, b], [a, b].map(|v| self.stamps[v as usize])))
    }

    fn ring(&self, v: u32) -> Vec<u32> {
        let mut out: Vec<u32> =
            self.faces_of[v as usize].iter().flat_map(|f| self.faces[*f as usize]).filter(|i| *i != v).collect();
        out.sort_unstable();
        out.dedup();
        out
    }

    fn collapse(&mut self, a: u32, b: u32, most: f32) {
        // The one that is held more stays.
        let (a, b) = if self.hold[a as usize] >= self.hold[b as usize] { (a, b) } else { (b, a) };
        let shared = self.shared(a, b);
        let (ring_a, ring_b) = (self.ring(a), self.ring(b));
        let common: Vec<u32> = ring_a.iter().copied().filter(|v| ring_b.binary_search(v).is_ok()).collect();
        if !(1..=2).contains(&shared.len()) || common.len() != shared.len() {
            return;
        }
        let Some((target, cost)) = self.target(a, b) else { return };
        let weight = self.quadrics[a as usize].weight + self.quadrics[b as usize].weight;
        if cost > f64::from(most).powi(2) * weight {
            return;
        }
        for &c in &common {
            let faces = self.faces_of[c as usize].len();
            let closed = self.ring(c).len() == faces;
            if faces <= if closed { 3 } else { 1 } {
                return;
            }
            // A line of three edges would become one of two.
            if self.is_line(&self.shared(a, c)) && self.is_line(&self.shared(b, c)) {
                return;
            }
        }
        if !self.stays_upright(a, b, target) || !self.stays_upright(b, a, target) {
            return;
        }
        for f in std::mem::take(&mut self.faces_of[b as usize]) {
            let face = &mut self.faces[f as usize];
            if face.contains(&a) {
                self.alive[f as usize] = false;
                for v in *face {
                    self.faces_of[v as usize].retain(|&g| g != f);
                }
            } else {
                face.iter_mut().filter(|v| **v == b).for_each(|v| *v = a);
                self.faces_of[a as usize].push(f);
            }
        }
        self.positions[a as usize] = target;
        self.quadrics[a as usize] = self.quadrics[a as usize].plus(&self.quadrics[b as usize]);
        self.left -= 1;
        self.stamps[b as usize] = u32::MAX;
        self.stamps[a as usize] += 1;
        for v in self.ring(a) {
            if let Some(candidate) = self.candidate(a, v) {
                self.queue.push(candidate);
            }
        }
    }

    /// No face around `v` but those shared with `other` turns over or becomes a needle when `v` moves to `target`.
    fn stays_upright(&self, v: u32, other: u32, target: DVec3) -> bool {
        self.faces_of[v as usize].iter().all(|&f| {
            let face = self.faces[f as usize];
            if face.contains(&other) {
                return true;
            }
            let old = face.map(|i| self.positions[i as usize]);
            let new = face.map(|i| if i == v { target } else { self.positions[i as usize] });
            let normal = |p: [DVec3; 3]| (p[1] - p[0]).cross(p[2] - p[0]);
            let longest = |p: [DVec3; 3]| (0..3).map(|k| p[k].distance_squared(p[(k + 1) % 3])).fold(0.0, f64::max);
            let (before, after) = (normal(old), normal(new));
            // What is a needle already may stay one.
            let needle = after.length() < NEEDLE * longest(new) && before.length() >= NEEDLE * longest(old);
            !needle && after.dot(before) >= TURN * after.length() * before.length()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wavy sheet of n × n squares in two halves, left and right.
    fn sheet(n: u32) -> (Vec<Vec3>, Vec<[u32; 3]>, Vec<u32>) {
        let at = |x: u32, y: u32| y * (n + 1) + x;
        let place = |i: u32| {
            let (x, y) = ((i % (n + 1)) as f32, (i / (n + 1)) as f32);
            Vec3::new(x, y, (0.3 * x).sin() + (0.2 * y).cos())
        };
        let (mut triangles, mut regions) = (Vec::new(), Vec::new());
        for (y, x) in (0..n).flat_map(|y| (0..n).map(move |x| (y, x))) {
            triangles.push([at(x, y), at(x + 1, y), at(x + 1, y + 1)]);
            triangles.push([at(x, y), at(x + 1, y + 1), at(x, y + 1)]);
            regions.extend([u32::from(x >= n / 2); 2]);
        }
        ((0..(n + 1) * (n + 1)).map(place).collect(), triangles, regions)
    }

    fn edges(triangles: &[[u32; 3]]) -> BTreeMap<[u32; 2], usize> {
        let mut out = BTreeMap::new();
        for t in triangles {
            for k in 0..3 {
                let (a, b) = (t[k], t[(k + 1) % 3]);
                *out.entry([a.min(b), a.max(b)]).or_default() += 1;
            }
        }
        out
    }

    #[test]
    fn a_sheet_keeps_its_rim_its_border_and_what_is_held() {
        let (positions, triangles, regions) = sheet(24);
        let held: Vec<bool> = (0..positions.len()).map(|i| i % 25 == 0).collect();
        let piece = Piece { positions: &positions, triangles: &triangles, regions: &regions, held: &held };
        let few = reduce(&piece, Goal { vertices: 120, error: 1.0 });
        let mut used: Vec<u32> = few.triangles.iter().flatten().copied().collect();
        used.sort_unstable();
        used.dedup();
        assert!(used.len() <= 120, "{}", used.len());
        // All of the left side is held and there, to the bit.
        assert!(
            (0..25).all(|y| used.contains(&(25 * y)) && few.positions[25 * y as usize] == positions[25 * y as usize])
        );
        assert!(edges(&few.triangles).values().all(|n| *n <= 2));
        // The rim is one closed line: as many edges as vertices, each of these on two of them.
        let rim: Vec<[u32; 2]> = edges(&few.triangles).into_iter().filter(|e| e.1 == 1).map(|e| e.0).collect();
        let mut ends: BTreeMap<u32, usize> = BTreeMap::new();
        rim.iter().flatten().for_each(|v| *ends.entry(*v).or_default() += 1);
        assert!(ends.len() == rim.len() && ends.values().all(|n| *n == 2));
        for v in ends.keys() {
            let p = few.positions[*v as usize];
            assert!([p.x, p.y].iter().any(|c| c.abs() < 0.05 || (c - 24.0).abs() < 0.05), "{p}");
        }
        // The border between the halves lies in its plane to the bit, from side to side.
        let side = |region: u32| -> Vec<[u32; 3]> {
            let own = few.triangles.iter().zip(&few.regions).filter(|t| *t.1 == region);
            own.map(|t| *t.0).collect()
        };
        let (left, right) = (edges(&side(0)), edges(&side(1)));
        let border: Vec<&[u32; 2]> = left.keys().filter(|e| right.contains_key(*e)).collect();
        let length: f32 =
            border.iter().map(|e| few.positions[e[0] as usize].y - few.positions[e[1] as usize].y).map(f32::abs).sum();
        assert!((length - 24.0).abs() < 1e-4 && border.len() < 20, "{length} in {}", border.len());
        assert!(border.iter().flat_map(|e| e.iter()).all(|v| few.positions[*v as usize].x == 12.0));
        // Close to where it was.
        let off = used
            .iter()
            .map(|v| few.positions[*v as usize])
            .map(|p| (p.z - (0.3 * p.x).sin() - (0.2 * p.y).cos()).abs());
        assert!(off.fold(0.0, f32::max) < 0.25);
    }

    #[test]
    fn the_error_is_a_limit_too() {
        let (mut positions, triangles, _) = sheet(16);
        positions.iter_mut().for_each(|p| p.z = 0.0);
        let one = vec![0; triangles.len()];
        let free = vec![false; positions.len()];
        let count = |positions: &[Vec3], error| {
            let piece = Piece { positions, triangles: &triangles, regions: &one, held: &free };
            reduce(&piece, Goal { vertices: 0, error }).triangles.len()
        };
        // Flat: next to nothing is left. Rough: nothing goes.
        assert!(count(&positions, 0.2) < 24, "{}", count(&positions, 0.2));
        let rough = |i: usize| (i as f32 * 12.9898).sin() * 43.758;
        positions.iter_mut().enumerate().for_each(|(i, p)| p.z = rough(i).fract());
        assert!(count(&positions, 0.1) > 200, "{}", count(&positions, 0.1));
    }
}
