//! The ground as a surface: heights on a regular grid, where photos saw it.
//!
//! Ground Gaussians → in each cell the median of their heights there, weighted by how much of them is there → cells that
//! enough photos see and whose Gaussians agree → of their parts those that belong together ([`parts`]) → their convex outline →
//! noise taken out → holes inside it as a membrane.
//! Unit frame, Z up.

use glam::{Mat3, Quat, Vec2, Vec3};
use rayon::prelude::*;

use super::super::begin::sees;
use super::{Terrain, membrane, parts, smooth};
use crate::geo::convex_hull;
use crate::splat::{Camera, Gaussians};

/// Photos that a place must be in.
const PHOTOS: usize = 3;
/// And not farther from them than so many times the distance within which photos have a quarter of what they see, in the
/// median.
pub(super) const FAR: f32 = 1.5;
/// Nor flatter: sine of the elevation.
const LEAST_SINE: f32 = 0.08;
/// Gaussians that photos are asked for, at most.
const ASKED: usize = 5000;
/// Cells along one of the ground's filter: a Gaussian is wider than its middle.
const FINER: usize = 2;
/// Fainter Gaussians do not count.
const OPAQUE: f32 = 0.1;
/// A Gaussian speaks of cells whose middles are no more of its standard deviations away,
const REACH: f32 = 2.0;
/// and no more cells.
const MOST_CELLS: f32 = 12.0;
/// Of all weight in a cell that makes it known.
const ENOUGH: f32 = 0.3;
/// Half of a cell's Gaussians, by weight, lie no farther apart in height than so many times what the best quarter of the cells
/// keeps to; asked where a cell has so many, for what is so around it, so many cells to each side.
const AGREE: f32 = 2.5;
const SEVERAL: usize = 3;
const AROUND: usize = 2;
/// Steepest ground: rise over run.
const STEEPEST: f32 = 0.5;
/// Width of the band around the outline in which the ground goes over into what is around, in radii of a circle of the same
/// area; and in cells at least.
const BAND: f32 = 0.25;
const BAND_CELLS: f32 = 8.0;

/// Heights of the ground inside a convex outline.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Row by row from the least y.
    heights: Vec<f32>,
    /// Cells that photos saw; the others are filled in.
    known: Vec<bool>,
    columns: usize,
    /// The first cell's lower corner.
    from: Vec2,
    pub cell: f32,
    /// Counter-clockwise.
    pub outline: Vec<Vec2>,
    /// Beyond the outline.
    pub band: f32,
    /// Cells inside the outline: with Gaussians of their own, and all.
    pub measured: usize,
    pub inside: usize,
    /// What a pixel of the nearest photo covers there, across the line of sight: the median over the cells.
    pub pixel: f32,
}

/// By how much ground that photos saw lies above terrain that is known otherwise, over its cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Against {
    pub median: f32,
    pub quartiles: [f32; 2],
}

impl Surface {
    /// `ground` and `terrain`: as [`super::separated`] found them; `cameras`: of the photos trained on. `None` where no place
    /// is seen well enough.
    pub fn of(g: &Gaussians, ground: &[bool], terrain: &Terrain, cameras: &[Camera]) -> Option<Surface> {
        let side = FINER * terrain.side;
        let mut all = Surface {
            heights: Vec::new(),
            known: Vec::new(),
            columns: side,
            from: Vec2::splat(terrain.from),
            cell: terrain.cell / FINER as f32,
            outline: Vec::new(),
            band: 0.0,
            measured: 0,
            inside: 0,
            pixel: 0.0,
        };
        let cells = all.cells(g, ground, terrain.step);
        let own: Vec<Option<f32>> = cells.iter().map(|c| c.map(|c| c.height)).collect();
        let far = FAR * working_distance(cameras, g, ground);
        let seen: Vec<Option<f32>> = (0..side * side)
            .into_par_iter()
            .map(|i| own[i].and_then(|h| pixel(cameras, all.middle(i).extend(h), far)))
            .collect();
        let agree = agreeing(&cells, side, &seen, terrain.step);
        let mut known: Vec<bool> = seen.iter().zip(agree).map(|(s, agree)| s.is_some() && agree).collect();
        parts::keep_near(&mut known, side, all.cell);
        let points = (0..known.len()).filter(|i| known[*i]).map(|i| all.middle(i).as_dvec2().to_array()).collect();
        all.outline = convex_hull(points).into_iter().map(|p| Vec2::new(p[0] as f32, p[1] as f32)).collect();
        let radius = (area(&all.outline) / std::f32::consts::PI).sqrt();
        if all.outline.len() < 3 || radius < 2.0 * all.cell {
            return None;
        }
        all.band = (BAND * radius).max(BAND_CELLS * all.cell);
        let inside: Vec<bool> = (0..own.len()).map(|i| all.beyond(all.middle(i)).0 == 0.0).collect();
        // What is known just outside holds the edge, too.
        let measured: Vec<f32> = own.iter().map(|h| h.unwrap_or(0.0)).collect();
        all.heights = smooth::smoothed(&measured, &known, side);
        membrane::fill(&mut all.heights, &known, side);
        all.inside = inside.iter().filter(|i| **i).count();
        all.measured = inside.iter().zip(&known).filter(|(i, k)| **i && **k).count();
        all.pixel = quantile(seen.iter().zip(&known).filter(|(_, k)| **k).filter_map(|(p, _)| *p).collect(), 2)?;
        all.known = known;
        Some(all)
    }

    /// Lets terrain that is known otherwise say what lies where no photo saw the ground: its shape there, moved up or down by what
    /// the two differ by around, filled in as a membrane. `terrain`: its height at a place whose height here is given, and from 1 to 0
    /// how much it counts. `None` where it says nothing of the ground that was seen; nothing changes then.
    pub fn fill_with(&mut self, terrain: impl Fn(Vec2, f32) -> Option<(f32, f32)>) -> Option<Against> {
        let near = |i: &usize| self.beyond(self.middle(*i)).0 <= 2.0 * self.cell;
        let cells: Vec<usize> = (0..self.heights.len()).filter(near).collect();
        let there: Vec<(usize, (f32, f32))> =
            cells.iter().filter_map(|i| Some((*i, terrain(self.middle(*i), self.heights[*i])?))).collect();
        let (mut off, mut known) = (vec![0.0; self.heights.len()], vec![false; self.heights.len()]);
        for (i, (z, _)) in there.iter().filter(|(i, _)| self.known[*i]) {
            (off[*i], known[*i]) = (self.heights[*i] - z, true);
        }
        let mut all: Vec<f32> = (0..off.len()).filter(|i| known[*i]).map(|i| off[i]).collect();
        all.sort_unstable_by(f32::total_cmp);
        let at = |share: f64| all.get((share * all.len() as f64) as usize).copied();
        let against = Against { median: at(0.5)?, quartiles: [at(0.25)?, at(0.75)?] };
        membrane::fill(&mut off, &known, self.columns);
        for (i, (z, share)) in there.iter().filter(|(i, _)| !self.known[*i]) {
            self.heights[*i] += (z + off[*i] - self.heights[*i]) * share;
        }
        Some(against)
    }

    fn middle(&self, i: usize) -> Vec2 {
        self.from + self.cell * (Vec2::new((i % self.columns) as f32, (i / self.columns) as f32) + 0.5)
    }

    /// Between the cells' middles, bilinear; outside the outline as at its nearest point.
    pub fn height(&self, p: Vec2) -> f32 {
        let rows = self.heights.len() / self.columns;
        let p = (self.beyond(p).1 - self.from) / self.cell - 0.5;
        let p = p.clamp(Vec2::ZERO, Vec2::new((self.columns - 1) as f32, (rows - 1) as f32));
        let (i, j) = (p.x as usize, p.y as usize);
        let at = |i: usize, j: usize| self.heights[j.min(rows - 1) * self.columns + i.min(self.columns - 1)];
        let along = |j: usize| at(i, j) * (1.0 - p.x.fract()) + at(i + 1, j) * p.x.fract();
        along(j) * (1.0 - p.y.fract()) + along(j + 1) * p.y.fract()
    }

    /// 1 inside the outline, smoothly to 0 over the band around it.
    pub fn share(&self, p: Vec2) -> f32 {
        let t = (self.beyond(p).0 / self.band).min(1.0);
        1.0 - t * t * (3.0 - 2.0 * t)
    }

    /// Whether a place lies inside the outline.
    pub fn holds(&self, p: Vec2) -> bool {
        self.beyond(p).0 == 0.0
    }

    /// The outline's point that is nearest; inside, the place itself.
    pub fn nearest(&self, p: Vec2) -> Vec2 {
        self.beyond(p).1
    }

    /// Lowest and highest inside the outline.
    pub fn heights(&self) -> [f32; 2] {
        let inside = (0..self.heights.len()).filter(|i| self.holds(self.middle(*i))).map(|i| self.heights[i]);
        inside.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], h| [low.min(h), high.max(h)])
    }

    /// Mean height along the outline.
    pub fn height_of_edge(&self) -> f32 {
        let (mut sum, mut length) = (0.0, 0.0);
        for (a, b) in edges(&self.outline) {
            let steps = ((b - a).length() / self.cell).ceil().max(1.0) as usize;
            for k in 0..steps {
                sum += self.height(a.lerp(b, (k as f32 + 0.5) / steps as f32)) * (b - a).length() / steps as f32;
            }
            length += (b - a).length();
        }
        sum / length
    }

    /// Around everything that has a share: least and greatest x and y.
    pub fn bounds(&self) -> [Vec2; 2] {
        let low = self.outline.iter().copied().reduce(Vec2::min).unwrap_or_default();
        let high = self.outline.iter().copied().reduce(Vec2::max).unwrap_or_default();
        [low - self.band, high + self.band]
    }

    /// Of the outline.
    pub fn area(&self) -> f32 {
        area(&self.outline)
    }

    /// How far a point lies outside the outline, and the outline's point that is nearest; inside, 0 and itself.
    fn beyond(&self, p: Vec2) -> (f32, Vec2) {
        if edges(&self.outline).all(|(a, b)| (b - a).perp_dot(p - a) >= 0.0) {
            return (0.0, p);
        }
        let nearest = edges(&self.outline).map(|(a, b)| {
            let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            a + t * (b - a)
        });
        let nearest = nearest.min_by(|a, b| a.distance_squared(p).total_cmp(&b.distance_squared(p))).unwrap_or(p);
        (nearest.distance(p), nearest)
    }

    /// Of each cell the weighted median of the Gaussians' heights at its middle.
    fn cells(&self, g: &Gaussians, ground: &[bool], step: f32) -> Vec<Option<Cell>> {
        let side = self.columns;
        let mut cells: Vec<Vec<(f32, f32)>> = vec![Vec::new(); side * side];
        let least = (OPAQUE / (1.0 - OPAQUE)).ln();
        for i in (0..g.len()).filter(|i| ground[*i] && g.logit_opacities[*i] > least) {
            let Some(flat) = Flat::of(g, i) else { continue };
            let opacity = 1.0 / (1.0 + (-g.logit_opacities[i]).exp());
            // What stands upright says little of a height.
            let sure = opacity / (1.0 + (flat.thick / step).powi(2));
            let around = (REACH * flat.reach).min(MOST_CELLS * self.cell).max(0.5 * self.cell);
            let low = ((flat.at.truncate() - around - self.from) / self.cell).floor().max(Vec2::ZERO);
            let high = ((flat.at.truncate() + around - self.from) / self.cell).floor();
            for y in low.y as usize..=(high.y.max(0.0) as usize).min(side - 1) {
                for x in low.x as usize..=(high.x.max(0.0) as usize).min(side - 1) {
                    let off = self.middle(y * side + x) - flat.at.truncate();
                    let near = flat.square(off, self.cell);
                    if near < REACH * REACH {
                        let z = flat.at.z + flat.slope.dot(off);
                        cells[y * side + x].push((z, sure * (-0.5 * near).exp()));
                    }
                }
            }
        }
        cells.into_par_iter().map(Cell::of).collect()
    }
}

/// A Gaussian as a piece of ground.
struct Flat {
    at: Vec3,
    /// Of its middle plane: rise along x and y.
    slope: Vec2,
    /// Standard deviation about that plane, along z.
    thick: f32,
    /// Largest standard deviation across.
    reach: f32,
    /// Covariance across: xx, xy, yy.
    across: [f32; 3],
}

impl Flat {
    fn of(g: &Gaussians, i: usize) -> Option<Flat> {
        let [w, x, y, z] = g.rotations[i];
        let turn = Mat3::from_quat(Quat::from_xyzw(x, y, z, w).normalize());
        let axes = turn * Mat3::from_diagonal(g.log_scales[i].exp());
        let c = axes * axes.transpose();
        let (xx, xy, yy, zz) = (c.x_axis.x, c.x_axis.y, c.y_axis.y, c.z_axis.z);
        let (xz, yz) = (c.x_axis.z, c.y_axis.z);
        let determinant = xx * yy - xy * xy;
        if !(g.positions[i].is_finite() && determinant > 0.0 && zz.is_finite()) {
            return None;
        }
        // The mean height under a vertical line is that of the regression plane.
        let full = Vec2::new(yy * xz - xy * yz, xx * yz - xy * xz) / determinant;
        let slope = if full.length() <= STEEPEST { full } else { Vec2::ZERO };
        let thick = (zz - 2.0 * slope.dot(Vec2::new(xz, yz))
            + slope.x * slope.x * xx
            + 2.0 * slope.x * slope.y * xy
            + slope.y * slope.y * yy)
            .max(0.0)
            .sqrt();
        Some(Flat { at: g.positions[i], slope, thick, reach: xx.max(yy).sqrt(), across: [xx, xy, yy] })
    }

    /// Squared distance in standard deviations, each no less than half a cell.
    fn square(&self, off: Vec2, cell: f32) -> f32 {
        let least = 0.25 * cell * cell;
        let [xx, xy, yy] = [self.across[0] + least, self.across[1], self.across[2] + least];
        (yy * off.x * off.x - 2.0 * xy * off.x * off.y + xx * off.y * off.y) / (xx * yy - xy * xy)
    }
}

/// What a cell's Gaussians say.
#[derive(Clone, Copy, Debug)]
struct Cell {
    height: f32,
    /// From the lower to the upper quarter of their heights, by weight, where there are several.
    spread: Option<f32>,
}

impl Cell {
    /// Of heights and weights; `None` where all together weigh too little.
    fn of(mut all: Vec<(f32, f32)>) -> Option<Cell> {
        let total: f32 = all.iter().map(|v| v.1).sum();
        if total < ENOUGH {
            return None;
        }
        all.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let at = |share: f32| {
            let mut below = 0.0;
            let found = all.iter().find(|(_, w)| {
                below += w;
                below >= share * total
            });
            found.or(all.last()).map(|v| v.0)
        };
        let spread = (all.len() >= SEVERAL).then(|| Some(at(0.75)? - at(0.25)?)).flatten();
        Some(Cell { height: at(0.5)?, spread })
    }
}

/// The value that a `share`-th part lies below.
pub(super) fn quantile(mut all: Vec<f32>, share: usize) -> Option<f32> {
    all.sort_unstable_by(f32::total_cmp);
    all.get(all.len() / share).copied()
}

/// Where the Gaussians of a cell and those around it say the same, as far as they do elsewhere.
fn agreeing(cells: &[Option<Cell>], side: usize, seen: &[Option<f32>], step: f32) -> Vec<bool> {
    let spread = |i: usize| cells[i].and_then(|c| c.spread);
    let around: Vec<Option<f32>> = (0..cells.len())
        .into_par_iter()
        .map(|i| {
            seen[i]?;
            let (x, y) = (i % side, i / side);
            let rows = y.saturating_sub(AROUND)..=(y + AROUND).min(side - 1);
            let columns = x.saturating_sub(AROUND)..=(x + AROUND).min(side - 1);
            quantile(rows.flat_map(|v| columns.clone().map(move |u| v * side + u)).filter_map(spread).collect(), 2)
        })
        .collect();
    let usual = quantile(around.iter().flatten().copied().collect(), 4).unwrap_or(0.0);
    let most = (AGREE * usual).max(0.5 * step);
    around.into_iter().map(|spread| spread.is_some_and(|s| s <= most)).collect()
}

/// How far photos are from the nearest quarter of the ground's Gaussians in them: the median over the photos. There are more
/// where more is seen.
fn working_distance(cameras: &[Camera], g: &Gaussians, ground: &[bool]) -> f32 {
    distance(cameras, (0..g.len()).filter(|i| ground[*i]).map(|i| g.positions[i]).collect())
}

pub(super) fn distance(cameras: &[Camera], own: Vec<Vec3>) -> f32 {
    let asked = own.iter().step_by(own.len().div_ceil(ASKED).max(1));
    let distances = |c: &Camera| quantile(asked.clone().filter_map(|p| seen_from(c, *p)).collect(), 4);
    quantile(cameras.iter().filter_map(distances).collect(), 2).unwrap_or(1.0)
}

/// The distance of a point that a camera has in its picture.
fn seen_from(c: &Camera, p: Vec3) -> Option<f32> {
    sees(c, p).then(|| p.distance(c.position()))
}

/// What a pixel of the nearest photo covers at a place that enough photos see.
pub(super) fn pixel(cameras: &[Camera], p: Vec3, far: f32) -> Option<f32> {
    let sees = |c: &Camera| {
        let up = c.position().z - p.z;
        seen_from(c, p).filter(|d| *d <= far && up >= LEAST_SINE * d).map(|d| d / c.fx)
    };
    let seen: Vec<f32> = cameras.iter().filter_map(sees).collect();
    (seen.len() >= PHOTOS).then(|| seen.into_iter().fold(f32::INFINITY, f32::min))
}

pub(super) fn edges(outline: &[Vec2]) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
    (0..outline.len()).map(|i| (outline[i], outline[(i + 1) % outline.len()]))
}

pub(super) fn area(outline: &[Vec2]) -> f32 {
    edges(outline).map(|(a, b)| a.perp_dot(b)).sum::<f32>() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pipeline::scene::ground::tests::{boxes, hill, place};
    use crate::pipeline::scene::ground::{Filter, separated};
    use crate::views;

    /// Hills with boxes on them, seen by photos from all around.
    #[test]
    fn hills_are_measured_where_photos_see_them_and_go_over_into_nothing() {
        let (points, _) = place();
        let n = points.len();
        let g = Gaussians {
            positions: points,
            log_scales: vec![Vec3::splat(-4.6); n],
            rotations: vec![[1.0, 0.0, 0.0, 0.0]; n],
            logit_opacities: vec![2.0; n],
            sh: vec![[[0.0; 3]; 16]; n],
        };
        let camera = |k: usize| Camera::look_at(views::eye(30.0 * k as f32, 40.0, 1.2), Vec3::ZERO, 0.5, 400);
        let cameras: Vec<Camera> = (0..12).map(camera).collect();
        let (terrain, ground) = separated(&g, n, &Filter::default()).unwrap();
        let s = Surface::of(&g, &ground, &terrain, &cameras).unwrap();
        assert!(s.outline.len() > 8 && s.measured < s.inside && 10 * s.measured > 8 * s.inside);
        assert!((0.5..3.0).contains(&s.area()), "{}", s.area());
        // A pixel of 400 across 29 degrees, nearly one away.
        assert!((0.5..1.5).contains(&(s.pixel / (1.0 / 783.0))), "{}", s.pixel);
        let boxes = boxes();
        let (mut open, mut below, mut outside) = (Vec::new(), Vec::new(), 0);
        for k in 0..200 * 200 {
            let p = Vec2::new((k % 200) as f32, (k / 200) as f32) * 0.02 - 2.0;
            let off = s.height(p) - hill(p.x, p.y);
            let on = boxes.iter().any(|b| (p.x - b[0]).abs() < b[2] + s.cell && (p.y - b[1]).abs() < b[3] + s.cell);
            match s.share(p) {
                share if share < 1.0 => outside += u32::from(share == 0.0),
                _ if on => below.push(off),
                _ => open.push(off),
            }
        }
        let rms = |v: &[f32]| (v.iter().map(|x| x * x).sum::<f32>() / v.len() as f32).sqrt();
        let most = below.iter().copied().fold(f32::MIN, f32::max);
        eprintln!("open ground {:.4}, below boxes {:.4}, {most:.4} at most", rms(&open), rms(&below));
        assert!(open.len() > 1000 && below.len() > 30 && outside > 1000, "{} {} {outside}", open.len(), below.len());
        assert!(rms(&open) < 0.002, "{}", rms(&open));
        // The boxes are 0.05 to 0.09 high.
        assert!(rms(&below) < 0.01 && most < 0.03, "{} {most}", rms(&below));
        // The edge: all, half, none; the height of its nearest point.
        let [low, high] = s.bounds();
        let (edge, out) = (s.outline[0], (s.outline[0] - (low + high) / 2.0).normalize());
        assert!(s.share(edge - 0.01 * out) == 1.0 && s.share(edge + 2.0 * s.band * out) == 0.0);
        let half = s.share(edge + 0.5 * s.band * out);
        assert!((0.2..0.9).contains(&half), "{half}");
        assert!((s.height(edge + out) - s.height(edge)).abs() < 0.05);
        assert!(Surface::of(&g, &ground, &terrain, &cameras[..2]).is_none(), "two photos are not enough");
    }

    /// A slope in two halves with a tenth of the cameras' distance between them, and a speck of ground far off.
    #[test]
    fn two_halves_are_one_ground_with_what_is_between_them_and_a_far_speck_is_none() {
        let slope = |x: f32, y: f32| 0.1 * x + 0.05 * y;
        let grid = (0..400 * 400).map(|k| ((k % 400) as f32 / 200.0 - 1.0, (k / 400) as f32 / 200.0 - 1.0));
        let (gap, speck) = (|x: f32| x.abs() < 0.05, |x: f32, y: f32| x.abs() < 0.012 && (y - 0.7).abs() < 0.012);
        let ground = |x: f32, y: f32| (x.abs() < 0.5 && y.abs() < 0.3 && !gap(x)) || speck(x, y);
        let points: Vec<Vec3> = grid.filter(|p| ground(p.0, p.1)).map(|(x, y)| Vec3::new(x, y, slope(x, y))).collect();
        let n = points.len();
        let g = Gaussians {
            positions: points,
            log_scales: vec![Vec3::splat(-5.3); n],
            rotations: vec![[1.0, 0.0, 0.0, 0.0]; n],
            logit_opacities: vec![2.0; n],
            sh: vec![[[0.0; 3]; 16]; n],
        };
        let camera = |k: usize| Camera::look_at(views::eye(30.0 * k as f32, 50.0, 1.2), Vec3::ZERO, 1.2, 400);
        let cameras: Vec<Camera> = (0..12).map(camera).collect();
        let (terrain, is_ground) = separated(&g, n, &Filter::default()).unwrap();
        assert!(is_ground.iter().all(|v| *v));
        let s = Surface::of(&g, &is_ground, &terrain, &cameras).unwrap();
        // Several cells are between the halves.
        assert!(0.1 > 6.0 * s.cell, "{}", s.cell);
        let at = |x: f32, y: f32| Vec2::new(x, y);
        let known =
            |p: Vec2| s.known[((p - s.from) / s.cell).floor().as_usizevec2().dot(glam::USizeVec2::new(1, s.columns))];
        assert!(known(at(-0.3, 0.1)) && known(at(0.3, 0.1)) && !known(at(0.0, 0.1)) && !known(at(0.0, 0.7)));
        assert!(s.holds(at(-0.48, 0.0)) && s.holds(at(0.48, 0.0)) && s.holds(at(0.0, 0.0)) && !s.holds(at(0.0, 0.5)));
        for k in 0..100 {
            let p = at(0.0095 * k as f32 - 0.47, 0.05);
            let off = s.height(p) - slope(p.x, p.y);
            // From side to side of the gap it rises by 0.01.
            assert!(s.share(p) == 1.0 && off.abs() < 0.003, "{p}: {off}");
        }
    }
}
