//! The surface of a scene in tiles, levels of detail and all: tiles share the vertices on their borders.
//!
//! Raw tiles → each simplified but for its border → borders, two neighbours at a time → four tiles to one, again and again, the
//! border as it is. A border that was simplified once is the same line in all levels, so tiles of different levels meet
//! without a gap, too: no skirts. When it lies inside a coarser tile it is simplified with it.

use glam::Vec3;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::super::Surface;
use super::field::{Key, Raw};
use super::reduce::{Goal, Piece, Reduced, reduce};
use crate::Result;
use crate::progress::Progress;

/// A tile's column and row.
pub type At = [usize; 2];

/// A level of the surface; vertices have the same numbers in all levels.
#[derive(Clone, Default)]
pub struct Shared {
    pub positions: Vec<Vec3>,
    pub tiles: BTreeMap<At, Vec<[u32; 3]>>,
}

/// Raw tiles as they come, each simplified at once.
#[derive(Default)]
pub struct Growing {
    shared: Shared,
    of_key: HashMap<Key, u32>,
    /// Border vertices that two tiles place differently: none, or the lattice is not shared.
    pub differ: usize,
}

/// Simplifies a raw tile but for its border.
pub fn inner(raw: &Raw, error: f32) -> (Reduced, Vec<Option<Key>>) {
    let held: Vec<bool> = raw.keys.iter().map(Option::is_some).collect();
    let regions = vec![0; raw.surface.triangles.len()];
    let Surface { positions, triangles } = &raw.surface;
    let piece = Piece { positions, triangles, regions: &regions, held: &held };
    (reduce(&piece, Goal { vertices: 0, error }), raw.keys.clone())
}

impl Growing {
    pub fn add(&mut self, at: At, (tile, keys): (Reduced, Vec<Option<Key>>)) {
        let mut number = vec![u32::MAX; keys.len()];
        let mut triangles = tile.triangles;
        for v in triangles.iter_mut().flatten() {
            let local = *v as usize;
            if number[local] == u32::MAX {
                let all = &mut self.shared.positions;
                let p = tile.positions[local];
                let new = all.len() as u32;
                let found = keys[local].map_or(new, |key| *self.of_key.entry(key).or_insert(new));
                match all.get(found as usize) {
                    None => all.push(p),
                    Some(q) => {
                        self.differ += usize::from(q.to_array().map(f32::to_bits) != p.to_array().map(f32::to_bits))
                    }
                }
                number[local] = found;
            }
            *v = number[local];
        }
        if !triangles.is_empty() {
            self.shared.tiles.insert(at, triangles);
        }
    }

    /// Borders simplified, then once more what is between them; parts of less than `least` area are gone, and hollows.
    pub fn finished(self, error: f32, least: f32, progress: &dyn Progress) -> Result<Shared> {
        let mut shared = self.shared;
        drop(self.of_key);
        for (step, odd) in [([1, 0], 0), ([1, 0], 1), ([0, 1], 0), ([0, 1], 1)] {
            progress.check()?;
            let along = usize::from(step[0] == 0);
            let pairs: Vec<Vec<At>> = shared
                .tiles
                .keys()
                .filter(|at| at[along] % 2 == odd)
                .map(|at| vec![*at, [at[0] + step[0], at[1] + step[1]]])
                .filter(|pair| shared.tiles.contains_key(&pair[1]))
                .collect();
            shared.reduce_groups(&pairs, error);
        }
        let alone: Vec<Vec<At>> = shared.tiles.keys().map(|at| vec![*at]).collect();
        shared.reduce_groups(&alone, error);
        shared.drop_small(least);
        shared.compact();
        Ok(shared)
    }
}

impl Shared {
    /// How many tiles use each vertex, in groups of tiles as `group` says.
    fn users(&self, group: impl Fn(At) -> At) -> Vec<u8> {
        let mut last = vec![None; self.positions.len()];
        let mut users = vec![0u8; self.positions.len()];
        let mut by_group: BTreeMap<At, Vec<At>> = BTreeMap::new();
        self.tiles.keys().for_each(|at| by_group.entry(group(*at)).or_default().push(*at));
        for (g, members) in by_group {
            for v in members.iter().flat_map(|at| self.tiles[at].iter().flatten()) {
                let v = *v as usize;
                if last[v] != Some(g) {
                    (last[v], users[v]) = (Some(g), users[v].saturating_add(1));
                }
            }
        }
        users
    }

    /// Vertices that two tiles have.
    pub fn borders(&self) -> Vec<bool> {
        self.users(|at| at).into_iter().map(|n| n > 1).collect()
    }

    /// Simplifies groups of tiles that have no tile in common, each by itself: held is what other tiles have too.
    fn reduce_groups(&mut self, groups: &[Vec<At>], error: f32) {
        let users = self.users(|at| at);
        let done: Vec<_> = groups
            .par_iter()
            .map(|group| {
                let mut local = Local::default();
                let mut regions = Vec::new();
                for (k, at) in group.iter().enumerate() {
                    local.add(&self.tiles[at]);
                    regions.resize(local.triangles.len(), k as u32);
                }
                // Of this group's tiles, how many use a vertex: another one does where more do.
                let mut own = vec![0u8; local.numbers.len()];
                for k in 0..group.len() as u32 {
                    let of: BTreeSet<u32> =
                        local.triangles.iter().zip(&regions).filter(|t| *t.1 == k).flat_map(|t| *t.0).collect();
                    of.iter().for_each(|v| own[*v as usize] += 1);
                }
                let held: Vec<bool> =
                    local.numbers.iter().zip(&own).map(|(v, own)| users[*v as usize] > *own).collect();
                let positions = local.positions(&self.positions);
                let piece =
                    Piece { positions: &positions, triangles: &local.triangles, regions: &regions, held: &held };
                let mut reduced = reduce(&piece, Goal { vertices: 0, error });
                local.globally(&mut reduced.triangles);
                (local.numbers, reduced)
            })
            .collect();
        for (group, (numbers, reduced)) in groups.iter().zip(done) {
            for (v, p) in numbers.iter().zip(&reduced.positions) {
                self.positions[*v as usize] = *p;
            }
            for (k, at) in group.iter().enumerate() {
                let own = reduced.triangles.iter().zip(&reduced.regions).filter(|t| *t.1 == k as u32);
                self.tiles.insert(*at, own.map(|t| *t.0).collect());
            }
        }
    }

    /// The next coarser level: four tiles become one of a quarter of their vertices, what another tile has too as it is.
    pub fn coarser(&self) -> Shared {
        let parent = |at: At| at.map(|k| k / 2);
        let users = self.users(parent);
        let mut groups: BTreeMap<At, Vec<At>> = BTreeMap::new();
        self.tiles.keys().for_each(|at| groups.entry(parent(*at)).or_default().push(*at));
        let groups: Vec<(At, Vec<At>)> = groups.into_iter().collect();
        let done: Vec<_> = groups
            .par_iter()
            .map(|(_, members)| {
                let mut local = Local::default();
                members.iter().for_each(|at| local.add(&self.tiles[at]));
                let held: Vec<bool> = local.numbers.iter().map(|v| users[*v as usize] > 1).collect();
                let (regions, positions) = (vec![0; local.triangles.len()], local.positions(&self.positions));
                let piece =
                    Piece { positions: &positions, triangles: &local.triangles, regions: &regions, held: &held };
                let free = held.iter().filter(|h| !**h).count();
                let goal = Goal { vertices: (held.len() - free + free / 4).max(FEWEST), error: f32::INFINITY };
                let mut reduced = reduce(&piece, goal);
                local.globally(&mut reduced.triangles);
                (local.numbers, reduced)
            })
            .collect();
        let mut out = Shared { positions: self.positions.clone(), tiles: BTreeMap::new() };
        for ((at, _), (numbers, reduced)) in groups.into_iter().zip(done) {
            for (v, p) in numbers.iter().zip(&reduced.positions) {
                out.positions[*v as usize] = *p;
            }
            out.tiles.insert(at, reduced.triangles);
        }
        out
    }

    /// A tile's surface by itself, and its vertices' numbers.
    pub fn tile(&self, at: &At) -> (Surface, Vec<u32>) {
        let mut local = Local::default();
        if let Some(triangles) = self.tiles.get(at) {
            local.add(triangles);
        }
        (Surface { positions: local.positions(&self.positions), triangles: local.triangles }, local.numbers)
    }

    /// The surface of all tiles below a coarser level's tile.
    pub fn below(&self, at: &At, levels: usize) -> Surface {
        let mut local = Local::default();
        for (_, triangles) in self.tiles.iter().filter(|t| t.0.map(|k| k >> levels) == *at) {
            local.add(triangles);
        }
        Surface { positions: local.positions(&self.positions), triangles: local.triangles }
    }

    /// Takes away parts of little area, and hollows: closed parts whose inside is air.
    fn drop_small(&mut self, least: f32) {
        let mut parent: Vec<u32> = (0..self.positions.len() as u32).collect();
        fn root(parent: &mut [u32], mut v: u32) -> u32 {
            while parent[v as usize] != v {
                parent[v as usize] = parent[parent[v as usize] as usize];
                v = parent[v as usize];
            }
            v
        }
        for t in self.tiles.values().flatten() {
            for v in &t[1..] {
                let (a, b) = (root(&mut parent, t[0]), root(&mut parent, *v));
                parent[a.max(b) as usize] = a.min(b);
            }
        }
        let mut sums: BTreeMap<u32, [f64; 2]> = BTreeMap::new();
        for t in self.tiles.values().flatten() {
            let [p, q, r] = t.map(|v| self.positions[v as usize].as_dvec3());
            let sum = sums.entry(root(&mut parent, t[0])).or_default();
            sum[0] += (q - p).cross(r - p).length() / 2.0;
            sum[1] += p.dot(q.cross(r)) / 6.0;
        }
        let largest = sums.values().map(|s| s[0]).fold(0.0, f64::max);
        let mut closed: BTreeMap<u32, bool> = BTreeMap::new();
        let mut edges: BTreeMap<[u32; 2], u8> = BTreeMap::new();
        for t in self.tiles.values().flatten() {
            for k in 0..3 {
                let (a, b) = (t[k], t[(k + 1) % 3]);
                *edges.entry([a.min(b), a.max(b)]).or_default() += 1;
            }
        }
        for ([a, _], count) in edges {
            *closed.entry(root(&mut parent, a)).or_insert(true) &= count == 2;
        }
        let keep = |part: u32| {
            let [area, volume] = sums[&part];
            let hollow = closed.get(&part) == Some(&true) && volume <= 0.0;
            area >= largest || (area >= f64::from(least) && !hollow)
        };
        for triangles in self.tiles.values_mut() {
            triangles.retain(|t| keep(root(&mut parent, t[0])));
        }
        self.tiles.retain(|_, triangles| !triangles.is_empty());
    }

    /// Numbers without gaps.
    fn compact(&mut self) {
        let mut number = vec![u32::MAX; self.positions.len()];
        let mut positions = Vec::new();
        for v in self.tiles.values_mut().flatten().flatten() {
            let new = &mut number[*v as usize];
            if *new == u32::MAX {
                *new = positions.len() as u32;
                positions.push(self.positions[*v as usize]);
            }
            *v = *new;
        }
        self.positions = positions;
    }
}

/// A coarse tile has so many vertices at least, if it can.
const FEWEST: usize = 64;

/// Triangles with numbers of their own.
#[derive(Default)]
struct Local {
    triangles: Vec<[u32; 3]>,
    /// One a vertex: its number in the whole.
    numbers: Vec<u32>,
    of: HashMap<u32, u32>,
}

impl Local {
    fn add(&mut self, triangles: &[[u32; 3]]) {
        for t in triangles {
            self.triangles.push(t.map(|v| {
                *self.of.entry(v).or_insert_with(|| {
                    self.numbers.push(v);
                    self.numbers.len() as u32 - 1
                })
            }));
        }
    }

    fn positions(&self, all: &[Vec3]) -> Vec<Vec3> {
        self.numbers.iter().map(|v| all[*v as usize]).collect()
    }

    fn globally(&self, triangles: &mut [[u32; 3]]) {
        triangles.iter_mut().flatten().for_each(|v| *v = self.numbers[*v as usize]);
    }
}
