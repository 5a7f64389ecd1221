//! What stands on the ground, body by body: Gaussians that are no ground, seen from above, as cells that touch.
//!
//! Unit frame, Z up.

use std::collections::{BTreeMap, BTreeSet};

use glam::Vec2;

use super::ground::Surface;
use crate::splat::Gaussians;

/// Fainter Gaussians do not make a body.
const OPAQUE: f32 = 0.3;
/// Gaussians that a cell of a body has at least, and the body.
const A_CELL: usize = 2;
const A_BODY: usize = 40;
/// What begins higher above the ground, in parts of its own height, hangs in the air.
const HANGS: f32 = 0.35;
/// Heights are quantiles: single Gaussians fly about.
const LOW: f32 = 0.02;
const HIGH: f32 = 0.98;

/// A body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Its Gaussians.
    pub members: Vec<usize>,
    /// Middle of the rectangle around it.
    pub middle: Vec2,
    /// Above the ground.
    pub height: f32,
    /// Gaussians of the ground in the cells that it covers: nothing else can be seen there.
    pub feet: Vec<usize>,
}

fn cell_of(p: Vec2, surface: &Surface) -> [i32; 2] {
    (p / surface.cell).floor().as_ivec2().to_array()
}

/// The ground's Gaussians without the feet of bodies.
pub fn cleared(ground: &[bool], bodies: &[Body]) -> Vec<bool> {
    let mut out = ground.to_vec();
    bodies.iter().flat_map(|b| &b.feet).for_each(|i| out[*i] = false);
    out
}

/// Bodies at least so high that stand inside the surface's outline with all they have; largest first, by the area of the
/// ground that they cover and their height. `near`: the first so many Gaussians are not the sky's.
pub fn of(g: &Gaussians, near: usize, ground: &[bool], surface: &Surface, least_height: f32) -> Vec<Body> {
    let logit = (OPAQUE / (1.0 - OPAQUE)).ln();
    let mut cells: BTreeMap<[i32; 2], Vec<usize>> = BTreeMap::new();
    let mut feet: BTreeMap<[i32; 2], Vec<usize>> = BTreeMap::new();
    for i in (0..near).filter(|i| g.positions[*i].is_finite()) {
        let of = if ground[i] { &mut feet } else { &mut cells };
        of.entry(cell_of(g.positions[i].truncate(), surface)).or_default().push(i);
    }
    let solid = |members: &[usize]| members.iter().filter(|i| g.logit_opacities[**i] > logit).count() >= A_CELL;
    let mut open: Vec<[i32; 2]> = cells.iter().filter(|(_, m)| solid(m)).map(|(c, _)| *c).collect();
    let mut left: BTreeSet<[i32; 2]> = open.iter().copied().collect();
    let mut bodies = Vec::new();
    open.reverse();
    while let Some(start) = open.pop() {
        if !left.remove(&start) {
            continue;
        }
        let (mut part, mut next) = (vec![start], vec![start]);
        while let Some([x, y]) = next.pop() {
            for at in (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [x + dx, y + dy])) {
                if left.remove(&at) {
                    part.push(at);
                    next.push(at);
                }
            }
        }
        let mut members: Vec<usize> = part.iter().flat_map(|c| &cells[c]).copied().collect();
        members.sort_unstable();
        let size = part.len() as f32;
        let feet = part.iter().filter_map(|c| feet.get(c)).flatten().copied().collect();
        let body = body(g, members, feet, surface, logit);
        if let Some(body) = body.filter(|b| b.height >= least_height) {
            bodies.push((size * body.height, body));
        }
    }
    bodies.sort_by(|a, b| b.0.total_cmp(&a.0));
    bodies.into_iter().map(|b| b.1).collect()
}

/// `None` for what hangs in the air, is next to nothing, or goes beyond the outline.
fn body(g: &Gaussians, members: Vec<usize>, feet: Vec<usize>, surface: &Surface, logit: f32) -> Option<Body> {
    let sure: Vec<_> = members.iter().filter(|i| g.logit_opacities[**i] > logit).map(|i| g.positions[*i]).collect();
    if sure.len() < A_BODY {
        return None;
    }
    let mut up: Vec<f32> = sure.iter().map(|p| p.z - surface.height(p.truncate())).collect();
    up.sort_unstable_by(f32::total_cmp);
    let at = |q: f32| up[((q * up.len() as f32) as usize).min(up.len() - 1)];
    let (low, high) = (at(LOW), at(HIGH));
    let first = sure[0].truncate();
    let (least, most) = sure.iter().fold((first, first), |(l, h), p| (l.min(p.truncate()), h.max(p.truncate())));
    let corners = [least, most, Vec2::new(least.x, most.y), Vec2::new(most.x, least.y)];
    let stands = high > 0.0 && low < HANGS * high && corners.iter().all(|c| surface.share(*c) == 1.0);
    stands.then_some(Body { members, middle: (least + most) / 2.0, height: high, feet })
}
