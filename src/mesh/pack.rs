//! Charts into one square texture: their true outlines, bottom-left first fit, the largest scale that fits; then each
//! chart grows into the room that is left around it.

use super::unwrap::{Chart, cells_inside};
use crate::{Error, Result};
use glam::Vec2;
use rayon::prelude::*;
use std::cmp::Reverse;

/// Texels kept free around each chart; two neighbours are twice as far apart.
pub const PADDING: f32 = 1.5;

/// A chart may grow by this factor at most once all are placed, in steps of [`GROWTH_STEP`]: texels stay alike in size.
const GROWTH: f32 = 1.5;
const GROWTH_STEP: f32 = 1.025;
/// How far charts may move aside while they grow, in cells.
const AWAY: usize = 8;

/// Where each chart lies.
#[derive(Clone, Debug, PartialEq)]
pub struct Atlas {
    /// Texture coordinates of each chart's faces' corners: 0..1, origin lower left, v up.
    pub uv: Vec<Vec<[Vec2; 3]>>,
    /// Texels along one scene unit, at least; no chart has more than half as many again.
    pub scale: f32,
}

/// Rows of bits, 64 cells a word.
struct Bits {
    width: usize,
    height: usize,
    words: usize,
    rows: Vec<u64>,
}

impl Bits {
    fn new(width: usize, height: usize) -> Self {
        let words = width.div_ceil(64);
        Bits { width, height, words, rows: vec![0; words * height] }
    }
    fn set(&mut self, x: usize, y: usize) {
        self.rows[y * self.words + x / 64] |= 1 << (x % 64);
    }
    fn count(&self) -> usize {
        self.rows.iter().map(|w| w.count_ones() as usize).sum()
    }
    /// The last cell of row `y` taken both here and by `other`'s row `oy` shifted right by `x`.
    fn last_clash(&self, y: usize, other: &Bits, oy: usize, x: usize) -> Option<usize> {
        let row = &self.rows[y * self.words..(y + 1) * self.words];
        let shape = &other.rows[oy * other.words..(oy + 1) * other.words];
        let (skip, bit) = (x / 64, x % 64);
        for w in (0..=other.words).rev() {
            let Some(taken) = row.get(w + skip) else { continue };
            let low = if w < other.words { shape[w] << bit } else { 0 };
            let high = if w > 0 && bit > 0 { shape[w - 1] >> (64 - bit) } else { 0 };
            let clash = taken & (low | high);
            if clash != 0 {
                return Some((w + skip) * 64 + 63 - clash.leading_zeros() as usize);
            }
        }
        None
    }
    /// Takes the cells of `shape` at (x, y), or gives them back if they are taken.
    fn toggle(&mut self, shape: &Bits, x: usize, y: usize) {
        let (skip, bit) = (x / 64, x % 64);
        for oy in 0..shape.height {
            let row = &mut self.rows[(y + oy) * self.words..(y + oy + 1) * self.words];
            for (w, word) in shape.rows[oy * shape.words..(oy + 1) * shape.words].iter().enumerate() {
                row[skip + w] ^= word << bit;
                if bit > 0 && word >> (64 - bit) != 0 {
                    row[skip + w + 1] ^= word >> (64 - bit);
                }
            }
        }
    }
    /// Where the run of taken cells of row `y` that cell `x` is in starts.
    fn start_of_run(&self, x: usize, y: usize) -> usize {
        let row = &self.rows[y * self.words..(y + 1) * self.words];
        let mut start = x;
        // Cells 0..=start % 64 of the word, shifted to its top.
        loop {
            let ones = (row[start / 64] << (63 - start % 64)).leading_ones() as usize;
            if ones <= start % 64 || start < 64 {
                return start + 1 - ones;
            }
            start -= ones;
            if row[start / 64] >> 63 == 0 {
                return start + 1;
            }
        }
    }
    fn free(&self, shape: &Bits, x: usize, y: usize) -> bool {
        (0..shape.height).all(|oy| self.last_clash(y + oy, shape, oy, x).is_none())
    }
    /// The longest run of cells in row `y` that are all taken, or all free.
    fn longest_run(&self, y: usize, taken: bool) -> usize {
        let row = &self.rows[y * self.words..(y + 1) * self.words];
        let (mut longest, mut run) = (0, 0);
        for (w, word) in row.iter().enumerate() {
            let cells = (self.width - w * 64).min(64);
            let word = if taken { *word } else { !word };
            let mut at = 0;
            while at < cells {
                let rest = word >> at;
                if rest & 1 == 0 {
                    (run, at) = (0, at + (rest.trailing_zeros() as usize).min(64 - at));
                } else {
                    let more = (rest.trailing_ones() as usize).min(cells - at);
                    (run, at) = (run + more, at + more);
                    longest = longest.max(run);
                }
            }
        }
        longest
    }
}

/// A chart's outline.
struct Shape {
    bits: Bits,
    /// Its rows, those with the longest runs of cells first: they clash soonest, and lead furthest on.
    order: Vec<u32>,
    /// The longest run of cells of each row.
    runs: Vec<u32>,
}

impl Shape {
    fn new(bits: Bits) -> Self {
        let runs: Vec<u32> = (0..bits.height).map(|y| bits.longest_run(y, true) as u32).collect();
        let mut order: Vec<u32> = (0..bits.height as u32).collect();
        order.sort_by_key(|y| (Reverse(runs[*y as usize]), *y));
        Shape { bits, order, runs }
    }
}

/// A texture being filled.
struct Filling {
    taken: Bits,
    /// The longest run of free cells of each row.
    room: Vec<u32>,
}

impl Filling {
    fn new(cells: usize) -> Self {
        Filling { taken: Bits::new(cells, cells), room: vec![cells as u32; cells] }
    }

    fn put(&mut self, shape: &Bits, x: usize, y: usize) {
        self.taken.toggle(shape, x, y);
        for y in y..y + shape.height {
            self.room[y] = self.taken.longest_run(y, false) as u32;
        }
    }

    /// The lowest, then leftmost place where `shape` fits and ends at row `below` or before.
    fn place(&self, shape: &Shape, below: usize) -> Option<(usize, usize)> {
        let (bits, taken) = (&shape.bits, &self.taken);
        if bits.width > taken.width || bits.height > taken.height.min(below) {
            return None;
        }
        for y in 0..=taken.height.min(below) - bits.height {
            if shape.runs.iter().zip(&self.room[y..]).any(|(run, room)| run > room) {
                continue;
            }
            let mut x = 0;
            'next: while x + bits.width <= taken.width {
                for oy in shape.order.iter().map(|oy| *oy as usize) {
                    if let Some(last) = taken.last_clash(y + oy, bits, oy, x) {
                        // Until the run of cells that hit it has passed, nothing can fit.
                        x = last - bits.start_of_run(last - x, oy) + 1;
                        continue 'next;
                    }
                }
                return Some((x, y));
            }
        }
        None
    }
}

/// Packs `charts` into a texture of `size`² texels.
///
/// Errors: `Usage` when there are more charts than the texture has room for.
pub fn pack(charts: &[Chart], size: u32) -> Result<Atlas> {
    let cell = (size / 256).max(1) as f32;
    let area: f32 =
        charts.iter().flat_map(|c| &c.corners).map(|t| (t[1] - t[0]).perp_dot(t[2] - t[0]).abs() / 2.0).sum();
    let whole = (size as f32).powi(2) / area.max(1e-12);
    // Fill shares: the largest that fits, to within two hundredths; a long strip alone in its texture may need a small one.
    let (mut fits, mut fails) = (None, 0.97f32);
    let mut low = 0.0f32;
    let mut fill = 0.68f32;
    for round in 1..=40 {
        let scale = (whole * fill).sqrt();
        match place_all(charts, size, cell, scale) {
            Some(places) => {
                fits = Some((scale, places));
                low = fill;
            }
            None => fails = fill,
        }
        if fits.is_some() && (fails - low < 0.02 || round >= 12) {
            break;
        }
        fill = if fits.is_some() { (low + fails) / 2.0 } else { fails * 0.7 };
    }
    let Some((scale, places)) = fits else {
        return Err(Error::usage("texture")
            .expected(format!("room for {} charts", charts.len()))
            .found(format!("{size} × {size} texels"))
            .advice("Use a larger texture or fewer levels of detail."));
    };
    let finer = (cell / 4.0).max(1.0);
    let times = (cell / finer) as usize;
    let places = places.into_iter().map(|p| Place { x: p.x * times, y: p.y * times, ..p }).collect();
    let uv = charts
        .iter()
        .zip(grown(charts, places, size, finer, scale))
        .map(|(chart, place)| {
            let at = Vec2::new(place.x as f32, place.y as f32) * finer + Vec2::splat(PADDING);
            let to_uv = |p: Vec2| {
                let p = place.turn.of(p, chart.size);
                let p = (p * scale * place.growth + at) / size as f32;
                Vec2::new(p.x, 1.0 - p.y)
            };
            chart.corners.iter().map(|t| t.map(to_uv)).collect()
        })
        .collect();
    Ok(Atlas { uv, scale })
}

#[derive(Clone, Copy, Default)]
struct Place {
    /// Cells.
    x: usize,
    y: usize,
    turn: Turn,
    /// Of the common scale.
    growth: f32,
}

/// One of the eight ways to lay an upright box onto a grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Turn {
    /// Left and right, top and bottom, then x and y are exchanged.
    x: bool,
    y: bool,
    axes: bool,
}

impl Turn {
    /// The first two are upright and lying.
    fn nth(k: usize) -> Self {
        Turn { axes: k & 1 == 1, x: k & 2 == 2, y: k & 4 == 4 }
    }

    /// Where a point of a box of this size comes to lie.
    fn of(self, p: Vec2, size: Vec2) -> Vec2 {
        let p = Vec2::new(if self.x { size.x - p.x } else { p.x }, if self.y { size.y - p.y } else { p.y });
        if self.axes { Vec2::new(p.y, p.x) } else { p }
    }
}

/// Largest first by different notions of large, then slightly shuffled: a bad start rarely stays bad in all of them.
fn orders(shapes: &[&Bits]) -> Vec<Vec<usize>> {
    let mut state = 0x2545_f491_u32;
    (0..12)
        .map(|attempt| {
            let mut order: Vec<(f32, usize)> = shapes
                .iter()
                .enumerate()
                .map(|(i, s)| {
                    let (w, h) = (s.width as f32, s.height as f32);
                    let large = match attempt % 4 {
                        0 => w.max(h),
                        1 => (w * h).sqrt(),
                        2 => w.min(h),
                        _ => w + h,
                    };
                    state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    let noise = if attempt < 4 { 0.0 } else { (state >> 8) as f32 / (1 << 24) as f32 };
                    (large * (1.0 + 0.5 * noise), i)
                })
                .collect();
            order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
            order.into_iter().map(|(_, i)| i).collect()
        })
        .collect()
}

fn place_all(charts: &[Chart], size: u32, cell: f32, scale: f32) -> Option<Vec<Place>> {
    // With many charts the other ways hardly help and cost most.
    let ways = if charts.len() <= 64 { 8 } else { 2 };
    let shape = |c: &Chart, k: usize| Shape::new(outline(c, Turn::nth(k), scale, cell));
    let shapes: Vec<Vec<Shape>> = charts.par_iter().map(|c| (0..ways).map(|k| shape(c, k)).collect()).collect();
    let upright: Vec<&Bits> = shapes.iter().map(|s| &s[0].bits).collect();
    let cells = (size as f32 / cell) as usize;
    if upright.iter().map(|s| s.count()).sum::<usize>() > cells * cells {
        return None;
    }
    orders(&upright).par_iter().find_map_first(|order| place_in_order(&shapes, order, cells))
}

fn place_in_order(shapes: &[Vec<Shape>], order: &[usize], cells: usize) -> Option<Vec<Place>> {
    let mut atlas = Filling::new(cells);
    let mut places = vec![Place::default(); shapes.len()];
    for &i in order {
        // The way that ends lowest, then leftmost.
        let mut best: Option<(usize, usize, usize)> = None;
        for (k, shape) in shapes[i].iter().enumerate() {
            if let Some((x, y)) = atlas.place(shape, best.map_or(cells, |b| b.0)) {
                let found = (y + shape.bits.height, x, k);
                best = Some(best.map_or(found, |b| b.min(found)));
            }
        }
        let (top, x, k) = best?;
        let shape = &shapes[i][k].bits;
        let y = top - shape.height;
        atlas.put(shape, x, y);
        places[i] = Place { x, y, turn: Turn::nth(k), growth: 1.0 };
    }
    Some(places)
}

/// Each chart as large as the room around it allows, a step at a time and in turn, so that none takes it all. On finer cells
/// of `cell` texels than the charts were placed on, which gives them the edges of their cells too.
fn grown(charts: &[Chart], mut places: Vec<Place>, size: u32, cell: f32, scale: f32) -> Vec<Place> {
    let cells = (size as f32 / cell) as usize;
    let mut atlas = Bits::new(cells, cells);
    let mut shapes: Vec<Bits> =
        charts.iter().zip(&places).map(|(chart, place)| outline(chart, place.turn, scale, cell)).collect();
    for (shape, place) in shapes.iter().zip(&places) {
        atlas.toggle(shape, place.x, place.y);
    }
    let mut growing: Vec<usize> = (0..charts.len()).collect();
    while !growing.is_empty() {
        let step = |i: usize| {
            let growth = places[i].growth * GROWTH_STEP;
            (growth <= GROWTH).then(|| (growth, outline(&charts[i], places[i].turn, scale * growth, cell)))
        };
        let larger: Vec<Option<(f32, Bits)>> = growing.par_iter().map(|i| step(*i)).collect();
        let mut still = Vec::with_capacity(growing.len());
        for (i, larger) in growing.into_iter().zip(larger) {
            let Some((growth, larger)) = larger else { continue };
            let place = places[i];
            atlas.toggle(&shapes[i], place.x, place.y);
            let room = nearby(&place, &shapes[i], &larger, cells).find(|&(x, y)| atlas.free(&larger, x, y));
            if let Some((x, y)) = room {
                shapes[i] = larger;
                places[i] = Place { x, y, growth, ..place };
                still.push(i);
            }
            atlas.toggle(&shapes[i], places[i].x, places[i].y);
        }
        growing = still;
    }
    places
}

/// Places for a `larger` outline that reach over the old one's box, or lie at most [`AWAY`] cells beside it.
fn nearby(place: &Place, old: &Bits, larger: &Bits, cells: usize) -> impl Iterator<Item = (usize, usize)> {
    let starts = |at: usize, old: usize, new: usize| {
        let slack = new.saturating_sub(old) + AWAY;
        at.saturating_sub(slack)..=(at + AWAY).min(cells.saturating_sub(new))
    };
    let across = starts(place.x, old.width, larger.width);
    let fits = larger.width <= cells && larger.height <= cells;
    starts(place.y, old.height, larger.height)
        .flat_map(move |y| across.clone().map(move |x| (x, y)))
        .filter(move |_| fits)
}

/// Cells that a chart and its padding touch.
fn outline(chart: &Chart, turn: Turn, scale: f32, cell: f32) -> Bits {
    let border = Vec2::splat(PADDING);
    let size = if turn.axes { Vec2::new(chart.size.y, chart.size.x) } else { chart.size };
    let extent = (size * scale + 2.0 * border) / cell;
    let (w, h) = (extent.x.ceil().max(1.0) as usize, extent.y.ceil().max(1.0) as usize);
    let mut bits = Bits::new(w, h);
    let reach = PADDING / cell + std::f32::consts::FRAC_1_SQRT_2;
    for t in &chart.corners {
        let t = t.map(|p| (turn.of(p, chart.size) * scale + border) / cell);
        cells_inside(t, w, h, -reach, |x, y| bits.set(x, y));
        // A face that is a line when flat covers no cell centre, but its corners need room.
        for p in t {
            bits.set((p.x as usize).min(w - 1), (p.y as usize).min(h - 1));
        }
    }
    bits
}

#[cfg(test)]
mod tests {
    use super::super::{scenes, unwrap};
    use super::*;

    #[test]
    fn charts_fit_apart_and_use_the_texture() {
        for (scene, least) in [(scenes::boxed(0.6, 0.4, 0.3), 0.6), (scenes::car(), 0.55), (scenes::sphere(0.9), 0.6)] {
            let surface = scenes::sampled(&scene, 48);
            let charts = unwrap::charts(&surface, &unwrap::FLAT, 4e5);
            for size in [128u32, 512, 1024] {
                let atlas = pack(&charts, size).unwrap();
                let n = size as usize;
                let mut owner = vec![u32::MAX; n * n];
                for (c, faces) in atlas.uv.iter().enumerate() {
                    for t in faces {
                        assert!(t.iter().all(|p| p.min_element() > 0.0 && p.max_element() < 1.0));
                        let t = t.map(|p| Vec2::new(p.x, 1.0 - p.y) * size as f32);
                        cells_inside(t, n, n, -1.0, |x, y| {
                            let slot = &mut owner[y * n + x];
                            assert!(*slot == u32::MAX || *slot == c as u32, "charts closer than 2 texels");
                            *slot = c as u32;
                        });
                    }
                }
                let area: f32 =
                    atlas.uv.iter().flatten().map(|t| (t[1] - t[0]).perp_dot(t[2] - t[0]).abs() / 2.0).sum();
                assert!(size < 512 || area >= least, "{area} of {size}² for {} charts", charts.len());
            }
        }
    }

    #[test]
    fn a_strip_alone_in_its_texture_fits() {
        let (far, side) = (Vec2::new(200.0, 0.0), Vec2::Y);
        let corners = vec![[Vec2::ZERO, far, side], [far, far + side, side]];
        let atlas = pack(&[Chart { faces: vec![0, 1], corners, size: far + side }], 64).unwrap();
        assert!(atlas.uv[0].iter().flatten().all(|p| p.cmpge(Vec2::ZERO).all() && p.cmple(Vec2::ONE).all()));
        assert!(atlas.scale > 0.2, "{} texels a unit of 200, of 64", atlas.scale);
    }

    #[test]
    fn more_charts_than_room_is_an_error() {
        let one = Chart { faces: vec![0], corners: vec![[Vec2::ZERO, Vec2::X, Vec2::Y]], size: Vec2::ONE };
        let error = pack(&vec![one; 400], 16).unwrap_err();
        assert!(error.found.contains("16"));
    }
}
