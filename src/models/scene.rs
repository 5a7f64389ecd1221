//! The subject's mask and depth, from the network for scenes.
//!
//! The network looks at the whole photo once ([`looks`]), then three times at the square around what it found, with room around it: 2.2
//! times the subject; tighter squares lost parts. The second look is shown the point that lies deepest in the first look's mask, so that what stands beside the
//! subject stays out, and averaged with the first. A second network draws that mask finely, [`detail`]. Then the colours of
//! subject and surroundings decide where the networks doubt ([`colour_model`]), and the edges of the photo at working resolution lead the mask's own
//! ([`guided_filter`]), but never into what they are sure of.

use super::colour_model;
use super::guided::guided_filter;
use super::region::{Bounds, bounds, deepest, eroded, fill_holes, grown, keep_central};
use super::{Engine, Graph, Port, check_contract, prior};
use crate::photo::{Edge, Plane, Rect, sample_colour, sample_plane};
use crate::{Error, Result};
use image::{GrayImage, RgbImage};
use rayon::prelude::*;

mod detail;
mod looks;
use looks::Canvas;

/// Of the network's square input and outputs.
const SIZE: usize = 256;
/// The longer side of the planes handed on, pixels.
const WORKING_SIDE: u32 = 1536;
/// The longer side of what is cut by colours, pixels.
const CUT_SIDE: usize = 768;
/// Above this the fine mask's core is the subject's, whatever the photo's edges say.
const CORE_FROM: f32 = 0.8;
/// How deep inside its edge the network's confident mask is beyond doubt, in longest sides of the subject's box.
const CORE: f32 = 0.01;
/// A subject's least share of the photo.
const SMALLEST: f64 = 0.002;
/// Share of the photo's border that a subject may cover.
const CUT_OFF: f64 = 0.4;
/// Nats between the colours of subject and surroundings below which there is no subject: noise reaches 0.01, on the smallest subjects 0.02.
const INDISTINCT: f32 = 0.03;

/// What stands in the middle of the photo.
#[derive(Clone, Debug)]
pub struct Subject {
    /// 0..1, soft at the edge; the photo's aspect at working resolution (longer side at most 1536).
    pub mask: Plane,
    /// Relative inverse depth of the whole photo, 1 nearest, 0 farthest: (d − min) / (max − min), the paper's Eq. 1.
    /// Same size as `mask`.
    pub depth: Plane,
    /// Of `mask` > 0.5, in pixels of `mask`.
    pub bounds: Bounds,
    /// Photo pixels for one mask pixel, horizontally and vertically.
    pub scale: (f32, f32),
    /// The photo's own alpha gave the mask.
    pub from_cutout: bool,
    /// Of the mask with the subject, as the network's probabilities let expect: [`expected_iou`]. `None` for a cut-out.
    pub expected_iou: Option<f32>,
    /// Of the camera above the subject's centre, as the surroundings tell it or a gimbal measured it.
    pub elevation: Angle,
    /// Of the camera about its axis, as the surroundings tell it, radians: by so much the lower ends of plumb lines that the axis meets lean
    /// to the right. 0 where they tell nothing.
    pub roll: f32,
}

impl Subject {
    /// Whether the photo ends before the subject does.
    pub fn cut_off_below(&self) -> bool {
        reaches_the_last_row(&self.mask)
    }

    /// Whether the photo's left, right or upper border runs through the subject, so that the middle of what is seen is not the
    /// subject's own. A foot that is cut off changes nothing of that.
    pub fn seen_in_part(&self) -> bool {
        crossed_beside_or_above(&self.mask, self.bounds)
    }
}

/// On the first row, or the first or last column, for more than a third of what the bounds measure there.
fn crossed_beside_or_above(mask: &Plane, [x0, y0, x1, y1]: Bounds) -> bool {
    let on = |x: usize, y: usize| mask.at(x, y) > 0.5;
    let column = |x: usize| (y0..y1).filter(|y| on(x, *y)).count();
    let above = (x0..x1).filter(|x| on(*x, 0)).count();
    3 * above > x1 - x0 || [0, mask.width - 1].into_iter().any(|x| 3 * column(x) > y1 - y0)
}

/// On the last row at least half as wide as anywhere in the lowest tenth, and more than a twentieth of the picture there.
fn reaches_the_last_row(mask: &Plane) -> bool {
    let Plane { width, height, .. } = *mask;
    let wide = |y: usize| (0..width).filter(|x| mask.at(*x, y) > 0.5).count();
    let widest = (height - height.div_ceil(10)..height).map(wide).max().unwrap_or(0);
    20 * widest > width && 2 * wide(height - 1) >= widest
}

/// A camera's elevation above the horizon or its roll, as a network guesses it or somebody measures it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle {
    /// Radians.
    pub mean: f32,
    /// The error's expected magnitude, radians: the scale of a Laplace distribution.
    pub spread: f32,
}

impl Angle {
    /// Both guesses as one: the mean weighed by precision, 1 / spread². Errors of guesses on one photo go together, so
    /// the spread stays that of the better one.
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        let precision = |e: Self| e.spread.max(1e-3).powi(-2);
        let (a, b) = (precision(self), precision(other));
        Self { mean: (a * self.mean + b * other.mean) / (a + b), spread: self.spread.min(other.spread) }
    }
}

/// What tells subjects and depth.
pub struct Networks {
    /// For the whole scene.
    pub scene: Box<dyn Graph>,
    /// For the mask's details.
    pub detail: Box<dyn Graph>,
}

impl Networks {
    /// Those in the program.
    ///
    /// # Errors
    /// Integrity, where their weights are not the pinned ones; as the engine.
    pub fn built_in(engine: &dyn Engine) -> Result<Self> {
        let (scene, detail) = rayon::join(|| prior::SCENE.loaded(engine), || prior::DETAIL.loaded(engine));
        Ok(Self { scene: scene?, detail: detail? })
    }
}

/// What the networks saw. What is left to do needs them no more.
pub struct Looked {
    /// The photo at working resolution, as bytes and as sRGB 0..1.
    working: RgbImage,
    guide: Vec<[f32; 3]>,
    /// Photo pixels for one of them, horizontally and vertically.
    scale: (f32, f32),
    /// Where the subject is looked for, shares of the frame, and whether only there.
    focus: [f32; 2],
    central: bool,
    /// As all looks have it, or the cut-out's.
    mask: Plane,
    /// The same finely drawn, and the pixels of it that one of the network's covers. `None` for a cut-out.
    drawn: Option<(Plane, f32)>,
    depth: Plane,
    elevation: Angle,
    roll: f32,
}

/// [`looked`] at, and what [`Looked::subject`] makes of it.
///
/// # Errors
/// As both.
pub fn subject(
    photo: &RgbImage,
    cutout: Option<&GrayImage>,
    point: Option<[f32; 2]>,
    networks: &Networks,
) -> Result<Subject> {
    looked(photo, cutout, point, networks)?.subject()
}

/// Tells the subject from the rest and how far things are, as the networks see it.
///
/// `cutout`, of the photo's size, replaces the network's mask. `point`, in pixels of the photo, lies on the subject;
/// without either the subject is what stands in the middle.
///
/// # Errors
/// A usage error when nothing stands out at the centre, or when the subject leaves no background at all.
pub fn looked(
    photo: &RgbImage,
    cutout: Option<&GrayImage>,
    point: Option<[f32; 2]>,
    networks: &Networks,
) -> Result<Looked> {
    let graph = &*networks.scene;
    detail::check(&*networks.detail)?;
    check_contract(
        "scene network",
        graph,
        &[Port::new("image", &[1, 4, SIZE, SIZE])],
        &[
            Port::new("mask", &[1, 1, SIZE, SIZE]),
            Port::new("inverse_depth", &[1, 1, SIZE, SIZE]),
            Port::new("elevation", &[1, 2]),
            Port::new("roll", &[1, 2]),
        ],
    )?;
    if contrast(photo) < 0.01 {
        return Err(no_subject("one even colour"));
    }
    let (pw, ph) = photo.dimensions();
    let shrink = (WORKING_SIDE as f32 / pw.max(ph) as f32).min(1.0);
    let (w, h) = (((pw as f32 * shrink).round() as usize).max(1), ((ph as f32 * shrink).round() as usize).max(1));
    let whole = Rect { x: 0.0, y: 0.0, width: pw as f32, height: ph as f32 };
    let guide = sample_colour(photo, whole, w, h, Edge::Clamp);
    let mut working = RgbImage::new(w as u32, h as u32);
    working.par_chunks_exact_mut(3 * w).zip(guide.par_chunks_exact(w)).for_each(|(line, colours)| {
        line.iter_mut().zip(colours.as_flattened()).for_each(|(byte, v)| *byte = (v * 255.0).round() as u8);
    });
    let canvas = Canvas { photo, working: &working, whole, width: w, height: h };
    let on_photo = |[x, y]: [f32; 2]| [x * pw as f32 / w as f32, y * ph as f32 / h as f32];
    let cut = cutout.map(|alpha| {
        let data = alpha.as_raw().iter().map(|&v| f32::from(v) / 255.0).collect();
        sample_plane(&Plane { width: pw as usize, height: ph as usize, data }, whole, w, h, Edge::Clamp)
    });
    // A cut-out says what the subject is, wherever that stands.
    let point = point.or_else(|| deepest(cut.as_ref()?, 0.5).map(on_photo));
    let focus = point.map_or([0.5; 2], |[x, y]| [x / pw as f32, y / ph as f32]);
    let fringe = w.max(h) / 170 + 1;

    let first = canvas.glance(point, graph)?;
    let mut mask = first.mask;
    keep_central(&mut mask, 0.35, fringe, focus);
    let mut depth = first.depth;
    let (mut elevation, mut roll) = (first.elevation, None);
    if let Some(found) = bounds(cut.as_ref().unwrap_or(&mask), 0.5) {
        let rect = canvas.around(found);
        let inside = deepest(&mask, 0.5).map(on_photo);
        let second = canvas.look(rect.unwrap_or(whole), point.or(inside), graph)?;
        for (a, b) in mask.data.iter_mut().zip(&second.mask.data) {
            *a = 0.4 * *a + 0.6 * b;
        }
        keep_central(&mut mask, 0.35, fringe, focus);
        elevation = mean(&[elevation, second.elevation]);
        match rect {
            Some(rect) => canvas.refine_depth(&mut depth, &second.depth, rect),
            None => (depth, roll) = (second.depth, Some(second.roll)),
        }
    }
    let roll = looks::evident(roll.map_or_else(|| canvas.roll(point, graph), Ok)?);
    let central = point.is_none();
    let drawn = match cut {
        Some(alpha) => {
            mask = alpha;
            None
        }
        None => {
            let rough = check(&mask, central)?;
            let (mut drawn, pixel) = detail::drawn(&canvas, &mask, rough, &*networks.detail)?;
            keep_central(&mut drawn, 0.35, fringe, focus);
            Some((drawn, pixel))
        }
    };
    let scale = (pw as f32 / w as f32, ph as f32 / h as f32);
    Ok(Looked { working, guide, scale, focus, central, mask, drawn, depth, elevation, roll })
}

impl Looked {
    /// The mask as colours and edges leave it, and the depth from 0 to 1.
    ///
    /// # Errors
    /// As [`looked`].
    pub fn subject(mut self) -> Result<Subject> {
        let (from_cutout, mut expected) = (self.drawn.is_none(), None);
        if let Some((drawn, pixel)) = self.drawn.take() {
            let finished = |rough: &Plane, pixel: f32| -> Result<Plane> {
                let found = check(rough, self.central)?;
                let mask = correct(&self.working, &self.guide, rough, found, pixel, self.focus)?;
                check(&mask, self.central)?;
                Ok(mask)
            };
            // Where the fine mask is no subject any more the rough one stays.
            let longest = self.mask.width.max(self.mask.height);
            let mask = finished(&drawn, pixel).or_else(|_| finished(&self.mask, longest as f32 / SIZE as f32))?;
            // The fine mask is surer of itself than it is right; what four looks agree on says more.
            expected = Some(expected_iou(&self.mask, &mask));
            self.mask = mask;
        }
        normalise(&mut self.depth);
        let bounds = check(&self.mask, self.central)?;
        Ok(Subject {
            mask: self.mask,
            depth: self.depth,
            bounds,
            scale: self.scale,
            from_cutout,
            expected_iou: expected,
            elevation: self.elevation,
            roll: self.roll,
        })
    }
}

/// Below this the mask is said to be doubtful. Of 28 real photographs with masks checked by hand it is so for thirteen, whose masks have
/// an IoU of 0.73 to 0.96; of the other 15 masks none is below 0.92.
pub const DOUBTFUL: f32 = 0.87;

/// The IoU of `mask` > 0.5 with a subject that takes each pixel with its probability: Σ p m / Σ (p + m − p m).
pub fn expected_iou(probability: &Plane, mask: &Plane) -> f32 {
    let (mut both, mut any) = (0f64, 0f64);
    for (p, m) in probability.data.iter().zip(&mask.data) {
        let (p, m) = (f64::from(p.clamp(0.0, 1.0)), f64::from(u8::from(*m > 0.5)));
        both += p * m;
        any += p + m - p * m;
    }
    (both / any.max(1e-9)) as f32
}

/// The mask as colours and edges correct it where the networks doubt.
fn correct(
    working: &RgbImage,
    guide: &[[f32; 3]],
    mask: &Plane,
    rough: Bounds,
    pixel: f32,
    focus: [f32; 2],
) -> Result<Plane> {
    let (w, h) = (mask.width, mask.height);
    let size = (rough[2] - rough[0]).max(rough[3] - rough[1]);
    let (small, colours) = smaller(working, mask);
    let step = |v: usize| v * small.width / w;
    let near = grown(rough.map(step), step(size / 4), small.width, small.height);
    let told = colour_model::evidence(&colours, &small, near);
    if told.divergence < INDISTINCT {
        return Err(no_subject("what is at the centre looks like what surrounds it"));
    }
    let cut = colour_model::cut(&colours, &told.log_odds, &small, near);
    let mut subject = sample_plane(&cut, whole_of(&cut), w, h, Edge::Clamp);
    let area = subject.data.iter().filter(|v| **v > 0.5).count();
    fill_holes(&mut subject, area / 300, mask);
    // Two pixels of what the network saw.
    let radius = ((2.0 * pixel) as usize).max(2);
    let mut subject = guided_filter(guide, &subject, radius, 1e-4);
    let core = eroded(w, h, ((CORE * size as f32) as usize).max(2), |i| mask.data[i] > CORE_FROM);
    subject.data.iter_mut().zip(&core).for_each(|(v, sure)| *v = if *sure { 1.0 } else { sharpen(*v) });
    keep_central(&mut subject, 0.35, radius, focus);
    Ok(subject)
}

/// The mask and the photo at the size at which they are cut, longer side at most [`CUT_SIDE`].
fn smaller(working: &RgbImage, mask: &Plane) -> (Plane, Vec<[f32; 3]>) {
    let shrink = (CUT_SIDE as f32 / mask.width.max(mask.height) as f32).min(1.0);
    let side = |v: usize| ((v as f32 * shrink).round() as usize).max(1);
    let (w, h) = (side(mask.width), side(mask.height));
    let small = sample_plane(mask, whole_of(mask), w, h, Edge::Clamp);
    (small, sample_colour(working, whole_of(mask), w, h, Edge::Clamp))
}

fn whole_of(plane: &Plane) -> Rect {
    Rect { x: 0.0, y: 0.0, width: plane.width as f32, height: plane.height as f32 }
}

/// Of guesses by one network.
fn mean(guesses: &[Angle]) -> Angle {
    let of = |value: fn(&Angle) -> f32| guesses.iter().map(value).sum::<f32>() / guesses.len() as f32;
    Angle { mean: of(|e| e.mean), spread: of(|e| e.spread) }
}

/// Takes the filter's faint halo to 0 and its fill to 1; one half stays.
fn sharpen(v: f32) -> f32 {
    let t = ((v - 0.2) / 0.6).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Standard deviation of luma over a coarse grid, 0..1.
fn contrast(photo: &RgbImage) -> f64 {
    let step = ((photo.width().max(photo.height()) / 256).max(1)) as usize;
    let mut sums = (0.0, 0.0, 0.0);
    for y in (0..photo.height()).step_by(step) {
        for x in (0..photo.width()).step_by(step) {
            let [r, g, b] = photo.get_pixel(x, y).0.map(|v| f64::from(v) / 255.0);
            let luma = 0.299 * r + 0.587 * g + 0.114 * b + 0.2 * (r - b);
            sums = (sums.0 + 1.0, sums.1 + luma, sums.2 + luma * luma);
        }
    }
    (sums.2 / sums.0 - (sums.1 / sums.0).powi(2)).max(0.0).sqrt()
}

fn no_subject(why: &str) -> Error {
    Error::usage("photo").expected("a subject that stands out at the centre").found(format!("no subject: {why}")).advice(
        "No subject found at the centre of the photo. Take the picture so that one object stands whole in the middle \
         with some background on every side, or crop the photo around it.",
    )
}

/// The mask must be one thing with background around it, and near the centre where `central`.
fn check(mask: &Plane, central: bool) -> Result<Bounds> {
    let pixels = mask.data.iter().filter(|v| **v > 0.5).count() as f64;
    let share = pixels / mask.data.len() as f64;
    let Some(b) = bounds(mask, 0.5).filter(|_| share >= SMALLEST) else {
        return Err(no_subject("nothing large enough stands out"));
    };
    if share > 0.95 {
        return Err(no_subject("what is at the centre fills the whole frame"));
    }
    let border = |x: usize, y: usize| x == 0 || y == 0 || x + 1 == mask.width || y + 1 == mask.height;
    let edge = mask.data.iter().enumerate().filter(|(i, _)| border(i % mask.width, i / mask.width));
    let (covered, all) = edge.fold((0.0, 0.0), |(c, n), (_, v)| (c + f64::from(u8::from(*v > 0.5)), n + 1.0));
    if covered > CUT_OFF * all {
        return Err(no_subject("what is at the centre leaves the frame on several sides"));
    }
    let (w, h) = (mask.width as f32, mask.height as f32);
    let reaches_centre =
        (b[0] as f32) < 0.65 * w && b[2] as f32 > 0.35 * w && (b[1] as f32) < 0.65 * h && b[3] as f32 > 0.35 * h;
    if central && !reaches_centre {
        return Err(no_subject("what stands out is at the border"));
    }
    Ok(b)
}

/// To 0..1 over the whole plane: the paper's Eq. 1.
fn normalise(depth: &mut Plane) {
    let low = depth.data.iter().copied().fold(f32::INFINITY, f32::min);
    let high = depth.data.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    let scale = 1.0 / (high - low).max(1e-6);
    depth.data.iter_mut().for_each(|v| *v = (*v - low) * scale);
}

#[cfg(test)]
pub(super) mod tests;
