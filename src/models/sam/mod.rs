//! The subject's mask by Segment Anything: SAM 2 and 2.1 in both published export styles, SAM 1 and MobileSAM.
//!
//! A. Kirillov et al., "Segment Anything", ICCV 2023; N. Ravi et al., "SAM 2: Segment Anything in Images and Videos",
//! 2024. The encoder sees the photo once; the decoder is asked twice: with the prompt, then with the prompt and the
//! logits of the mask that was chosen.

mod choice;
mod decoder;
mod encoder;
#[cfg(test)]
mod tests;

use image::{GrayImage, RgbImage};

use super::Graph;
use super::registry::{Family, Role};
use crate::models::region::regions;
use crate::photo::Plane;
use crate::progress::Progress;
use crate::{Error, Result};

/// Side of a low-resolution mask.
const LOW: usize = 256;
/// Side of the encoder's picture.
const FRAME: usize = 1024;

/// Where the subject is, in pixels of the photo from its upper left corner.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Prompt {
    /// On the subject. Empty, and no box: the centre of the photo.
    pub points: Vec<[f32; 2]>,
    /// On what is not the subject.
    pub not: Vec<[f32; 2]>,
    /// Around it: left, top, right, bottom.
    pub bounds: Option<[f32; 4]>,
}

impl Prompt {
    /// Checks it against a photo and puts the centre in where nothing was said.
    ///
    /// # Errors
    /// A usage error for a point or a box outside the photo.
    pub fn on(&self, width: u32, height: u32) -> Result<Prompt> {
        let inside = |&[x, y]: &[f32; 2]| (0.0..=width as f32).contains(&x) && (0.0..=height as f32).contains(&y);
        let corners = self.bounds.map(|[a, b, c, d]| [[a, b], [c, d]]);
        let outside = self.points.iter().chain(&self.not).chain(corners.iter().flatten()).find(|p| !inside(p));
        if let Some([x, y]) = outside {
            return Err(Error::usage("the subject's place")
                .expected(format!("pixels of a photo of {width} × {height}"))
                .found(format!("{x},{y}")));
        }
        if let Some(b) = self.bounds.filter(|b| b[2] - b[0] < 2.0 || b[3] - b[1] < 2.0) {
            return Err(Error::usage("--box").expected("left,top,right,bottom").found(format!("{b:?}")));
        }
        let mut out = self.clone();
        if out.points.is_empty() && out.bounds.is_none() {
            out.points.push([width as f32 / 2.0, height as f32 / 2.0]);
        }
        Ok(out)
    }
}

/// How the photo lies in the encoder's picture.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Fit {
    /// Photo pixels → pixels of the 1024² frame.
    scale: [f32; 2],
    /// Part of the frame that the photo covers, in pixels of the frame.
    covered: [f32; 2],
}

impl Fit {
    /// SAM 2 squashes; SAM 1 keeps the aspect, longest side 1024, and pads on the right and below.
    fn of(family: Family, width: u32, height: u32) -> Fit {
        let (w, h, frame) = (width as f32, height as f32, FRAME as f32);
        let scale = match family {
            Family::Sam1 => [frame / w.max(h); 2],
            _ => [frame / w, frame / h],
        };
        Fit { scale, covered: [w * scale[0], h * scale[1]] }
    }

    fn to_frame(self, [x, y]: [f32; 2]) -> [f32; 2] {
        [x * self.scale[0], y * self.scale[1]]
    }
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Found {
    /// Of the photo's size, 0..255, soft at the edge.
    pub mask: GrayImage,
    /// What the network thinks of its mask: the predicted intersection over union.
    pub score: f32,
    /// The second pass agreed with the first and took its place.
    pub refined: bool,
}

/// A mask as the decoder gives it.
#[derive(Clone, Debug, PartialEq)]
struct Candidate {
    /// Logits, 256², over the whole frame.
    logits: Plane,
    score: f32,
}

/// Finds the subject. `open` loads a part when its turn comes; the encoder is gone before the decoder.
///
/// # Errors
/// Usage for a prompt outside the photo or a mask without a subject, environment for a graph that does not fit.
pub fn segment(
    photo: &RgbImage,
    prompt: &Prompt,
    family: Family,
    open: &mut dyn FnMut(Role) -> Result<Box<dyn Graph>>,
    progress: &dyn Progress,
) -> Result<Found> {
    let prompt = prompt.on(photo.width(), photo.height())?;
    let fit = Fit::of(family, photo.width(), photo.height());
    let embedding = encoder::embed(photo, family, fit, &*open(Role::Encoder)?)?;
    progress.check()?;
    let decoder = decoder::Decoder::new(family, open(Role::Decoder)?, embedding, fit, photo.dimensions())?;
    let first = decoder.masks(&prompt, None)?;
    let chosen = choice::best(&first, fit).ok_or_else(no_mask)?;
    let mut found = first[chosen].clone();
    let mut refined = false;
    if decoder.takes_masks() {
        let second = decoder.masks(&prompt, Some(&found.logits))?;
        // Not another thing, and not one that the network itself likes clearly less.
        if let Some(better) = choice::most_like(&second, &found, fit).filter(|c| c.score >= found.score - 0.1) {
            (found, refined) = (better.clone(), true);
        }
    }
    let mask = full_size(&found.logits, fit, photo.dimensions(), &prompt.points);
    if mask.iter().all(|v| *v < 128) {
        return Err(no_mask());
    }
    Ok(Found { mask, score: found.score, refined })
}

fn no_mask() -> Error {
    Error::usage("photo")
        .expected("a subject at the point or in the box given")
        .found("no mask that holds together")
        .advice("Say where the subject is: --point X,Y (repeatable) or --box X0,Y0,X1,Y1, or bring a --mask.")
}

/// Bilinear, half-pixel centres, then the logistic function: 0.5 where the logit is 0. Regions without one of the points, or
/// without the largest part where there are no points, are left out.
fn full_size(logits: &Plane, fit: Fit, (width, height): (u32, u32), points: &[[f32; 2]]) -> GrayImage {
    let (w, h) = (width as usize, height as usize);
    let low = |photo: usize, axis: usize| {
        let p = (photo as f32 + 0.5) * fit.scale[axis] * LOW as f32 / FRAME as f32 - 0.5;
        let last = (fit.covered[axis] * LOW as f32 / FRAME as f32).ceil() as usize - 1;
        let i = (p.floor().max(0.0) as usize).min(last);
        (i, (i + 1).min(last), (p - i as f32).clamp(0.0, 1.0))
    };
    let columns: Vec<_> = (0..w).map(|x| low(x, 0)).collect();
    let mut values = Vec::with_capacity(w * h);
    for y in 0..h {
        let (y0, y1, ty) = low(y, 1);
        for &(x0, x1, tx) in &columns {
            let row = |y: usize| logits.at(x0, y) * (1.0 - tx) + logits.at(x1, y) * tx;
            values.push(row(y0) * (1.0 - ty) + row(y1) * ty);
        }
    }
    let (labels, found) = regions(w, h, |i| values[i] > 0.0, |_| 0.0);
    let at = |[x, y]: &[f32; 2]| labels[(*y as usize).min(h - 1) * w + (*x as usize).min(w - 1)];
    let mut kept: Vec<u32> = points.iter().map(at).filter(|l| *l != 0).collect();
    if kept.is_empty() {
        kept.extend((1..).zip(&found).max_by_key(|(_, r)| r.pixels).map(|(l, _)| l));
    }
    let mut inside: Vec<bool> = labels.iter().map(|l| *l != 0 && kept.contains(l)).collect();
    // The soft fringe around what is kept.
    let reach = (w.max(h) / LOW).max(1);
    inside = crate::models::region::dilated(w, h, reach, |i| inside[i]);
    GrayImage::from_fn(width, height, |x, y| {
        let i = y as usize * w + x as usize;
        let v = if inside[i] { 1.0 / (1.0 + (-values[i]).exp()) } else { 0.0 };
        image::Luma([(v * 255.0).round() as u8])
    })
}
