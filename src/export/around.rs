//! Terrain that is known around a surface, and how much it counts: all where it goes on, nothing where it ends.

use glam::Vec2;
use rayon::prelude::*;

use super::OnEarth;
use crate::pipeline::scene::ground::Surface;

/// Cells of the grid of holes along the way over which terrain goes to nothing.
const CELLS: usize = 16;
/// So many cells before a hole it counts for nothing: between two cells holes are not known better.
const BEFORE: f32 = 1.5;

/// What is known around a surface. Over a band before its end, as wide as the surface's own, what it says goes over into what
/// would stand there without it; so where it ends within the surface or close to it there is no step.
pub struct Around<'a> {
    height: &'a dyn Fn(f64, f64) -> Option<f64>,
    depth: &'a dyn Fn(f64, f64) -> f64,
    earth: &'a OnEarth<'a>,
    /// Metres.
    width: f64,
    holes: Option<Holes>,
    /// Whether it ends where the surface has a share.
    pub ends: bool,
}

/// Where nothing is known although its file goes on: shares on a grid over a surface and a band around that.
struct Holes {
    from: Vec2,
    cell: f32,
    columns: usize,
    shares: Vec<f32>,
    /// Where the surface has a share, and beyond that the way over which holes no longer count.
    bounds: [Vec2; 2],
    width: f32,
}

impl<'a> Around<'a> {
    /// `height`: metres above the ellipsoid at a latitude and longitude, where it is known; `depth`: how many metres inside the edge
    /// of its file a place lies, less than nothing outside.
    pub fn new(
        surface: &Surface,
        earth: &'a OnEarth<'a>,
        height: &'a dyn Fn(f64, f64) -> Option<f64>,
        depth: &'a dyn Fn(f64, f64) -> f64,
    ) -> Around<'a> {
        let width = f64::from(surface.band) * earth.registration.to_enu.scale;
        let mut around = Around { height, depth, earth, width, holes: None, ends: false };
        around.holes = Holes::find(surface, |p| {
            let place = earth.place(p.as_dvec2().extend(surface.height(p).into()));
            depth(place.latitude, place.longitude) < 0.0 || height(place.latitude, place.longitude).is_some()
        });
        let [low, high] = surface.bounds();
        let across = (high - low) / (4 * CELLS) as f32;
        around.ends = (0..=4 * CELLS).any(|y| {
            (0..=4 * CELLS).any(|x| {
                let p = low + across * Vec2::new(x as f32, y as f32);
                let place = earth.place(p.as_dvec2().extend(surface.height(p).into()));
                let whole = around.at(place.latitude, place.longitude).is_some_and(|(_, share)| share >= 1.0);
                surface.share(p) > 0.0 && !whole
            })
        });
        around
    }

    /// The height at a latitude and longitude, and from 1 to 0 how much it counts.
    pub fn at(&self, latitude: f64, longitude: f64) -> Option<(f64, f64)> {
        let height = (self.height)(latitude, longitude)?;
        let share = smooth((self.depth)(latitude, longitude) / self.width);
        let Some(holes) = &self.holes else { return Some((height, share)) };
        let place = crate::geo::Geodetic { latitude, longitude, height };
        Some((height, share * f64::from(holes.share(self.earth.unit(place).truncate().as_vec2()))))
    }
}

/// From 0 to 1, level at both ends.
fn smooth(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

impl Holes {
    /// `None` where there are none.
    fn find(surface: &Surface, known: impl Fn(Vec2) -> bool) -> Option<Holes> {
        let (bounds, width) = (surface.bounds(), surface.band);
        let cell = width / CELLS as f32;
        let from = bounds[0] - width;
        let [columns, rows] = ((bounds[1] - bounds[0] + 2.0 * width) / cell).to_array().map(|n| n.ceil() as usize + 1);
        let at = |i: usize| from + cell * Vec2::new((i % columns) as f32, (i / columns) as f32);
        let holes: Vec<bool> = (0..columns * rows).map(|i| !known(at(i))).collect();
        if !holes.contains(&true) {
            return None;
        }
        let reach = CELLS + BEFORE.ceil() as usize;
        let is_hole = |u: usize, v: usize| holes[v * columns + u];
        let share = |i: usize| {
            let (x, y) = (i % columns, i / columns);
            let mut nearest = f32::INFINITY;
            for v in y.saturating_sub(reach)..=(y + reach).min(rows - 1) {
                for u in (x.saturating_sub(reach)..=(x + reach).min(columns - 1)).filter(|u| is_hole(*u, v)) {
                    nearest = nearest.min((u as f32 - x as f32).hypot(v as f32 - y as f32));
                }
            }
            smooth(f64::from((nearest - BEFORE) / CELLS as f32)) as f32
        };
        let shares = (0..columns * rows).into_par_iter().map(share).collect();
        Some(Holes { from, cell, columns, shares, bounds, width })
    }

    fn share(&self, p: Vec2) -> f32 {
        let outside = (self.bounds[0] - p).max(p - self.bounds[1]).max(Vec2::ZERO).length();
        let counts = 1.0 - (outside / self.width).min(1.0);
        if counts == 0.0 {
            return 1.0;
        }
        let rows = self.shares.len() / self.columns;
        let q =
            ((p - self.from) / self.cell).clamp(Vec2::ZERO, Vec2::new(self.columns as f32 - 1.0, rows as f32 - 1.0));
        let (i, j) = (q.x as usize, q.y as usize);
        let at = |i: usize, j: usize| self.shares[j.min(rows - 1) * self.columns + i.min(self.columns - 1)];
        let along = |j: usize| at(i, j) * (1.0 - q.x.fract()) + at(i + 1, j) * q.x.fract();
        let share = along(j) * (1.0 - q.y.fract()) + along(j + 1) * q.y.fract();
        1.0 - (1.0 - share) * counts
    }
}
