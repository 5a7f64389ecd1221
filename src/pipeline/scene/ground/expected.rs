//! What of the ground photos will show, told from their poses alone: for plans.

use glam::{Vec2, Vec3};
use rayon::prelude::*;

use super::parts::keep_near;
use super::surface::{FAR, area, distance, edges, pixel, quantile};
use crate::geo::convex_hull;
use crate::splat::Camera;

/// What of level ground photos will show, told before there is a scene, by the same rules.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expected {
    /// Of the outline, and its extent along x and y.
    pub area: f32,
    pub size: Vec2,
    pub pixel: f32,
    /// Lowest and highest of what stands in it.
    pub heights: [f32; 2],
}

/// Cells along the side of the square that is looked through, and half its side.
const LOOKED: usize = 240;
const REACHED: f32 = 3.0;
/// Height of things, where no points say it.
const THINGS: f32 = 0.25;
/// Of the points in the outline, so many at each end are taken for wrong.
const WRONG: f32 = 0.005;

/// `points`: of the photos, where there are any; `level`: the ground's height. `None` where no place is seen well enough.
pub fn expected(cameras: &[Camera], points: &[Vec3], level: f32) -> Option<Expected> {
    let cell = 2.0 * REACHED / LOOKED as f32;
    let at = |i: usize| (Vec2::new((i % LOOKED) as f32, (i / LOOKED) as f32) + 0.5) * cell - REACHED;
    let level_ground = || (0..LOOKED * LOOKED).map(|i| at(i).extend(level)).collect::<Vec<_>>();
    let near = |p: &Vec3| p.truncate().abs().max_element() < REACHED;
    let inside: Vec<Vec3> = points.iter().copied().filter(near).collect();
    let far = FAR * distance(cameras, if inside.is_empty() { level_ground() } else { inside.clone() });
    let seen: Vec<Option<f32>> = level_ground().par_iter().map(|p| pixel(cameras, *p, far)).collect();
    let mut known: Vec<bool> = seen.iter().map(Option::is_some).collect();
    keep_near(&mut known, LOOKED, cell);
    let places = (0..known.len()).filter(|i| known[*i]).map(|i| at(i).as_dvec2().to_array()).collect();
    let outline: Vec<Vec2> = convex_hull(places).into_iter().map(|p| Vec2::new(p[0] as f32, p[1] as f32)).collect();
    if outline.len() < 3 {
        return None;
    }
    let low = outline.iter().copied().reduce(Vec2::min)?;
    let high = outline.iter().copied().reduce(Vec2::max)?;
    let holds = |p: Vec2| edges(&outline).all(|(a, b)| (b - a).perp_dot(p - a) >= 0.0);
    let mut z: Vec<f32> = inside.iter().filter(|p| holds(p.truncate())).map(|p| p.z).collect();
    z.sort_unstable_by(f32::total_cmp);
    let of = |share: f32| z.get((share * z.len() as f32) as usize).copied();
    Some(Expected {
        area: area(&outline),
        size: high - low,
        pixel: quantile(seen.iter().zip(&known).filter(|(_, k)| **k).filter_map(|(p, _)| *p).collect(), 2)?,
        heights: [of(WRONG).unwrap_or(level).min(level), of(1.0 - WRONG).unwrap_or(level + THINGS).max(level)],
    })
}
