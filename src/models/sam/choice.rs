//! Which of the masks is the subject.
//!
//! A click has several right answers: the whole, a part, a part of the part. The network's best score is often a part. A
//! subject for a model is one whole thing that holds together, with background around it; these count beside the score.

use super::{Candidate, FRAME, Fit, LOW};
use crate::models::region::{Region, regions};

/// Share of the photo below which a mask is a speck, and above which it is the scene.
const SPECK: f32 = 0.004;
const SCENE: f32 = 0.92;
/// A mask gains by its size up to this share.
const LARGE: f32 = 0.15;
const SIZE_WEIGHT: f32 = 0.25;
const BORDER_WEIGHT: f32 = 0.8;
const PIECES_WEIGHT: f32 = 0.5;

/// What a mask looks like on the grid that the photo covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shape {
    /// Of the photo.
    pub share: f32,
    /// Of the photo's border that is mask.
    pub border: f32,
    /// Of the mask that is not in its largest region.
    pub loose: f32,
}

/// The part of the low grid with photo on it.
fn grid(fit: Fit) -> (usize, usize) {
    let cells = |v: f32| ((v * LOW as f32 / FRAME as f32).round() as usize).clamp(1, LOW);
    (cells(fit.covered[0]), cells(fit.covered[1]))
}

fn inside(candidate: &Candidate, fit: Fit) -> (usize, usize, Vec<bool>) {
    let (w, h) = grid(fit);
    let cells = (0..w * h).map(|i| candidate.logits.at(i % w, i / w) > 0.0).collect();
    (w, h, cells)
}

pub(super) fn shape(candidate: &Candidate, fit: Fit) -> Shape {
    let (w, h, cells) = inside(candidate, fit);
    let (_, found) = regions(w, h, |i| cells[i], |_| 0.0);
    let area: usize = found.iter().map(|r: &Region| r.pixels).sum();
    let largest = found.iter().map(|r| r.pixels).max().unwrap_or(0);
    let on_border = |i: &usize| i.is_multiple_of(w) || i / w == 0 || i % w + 1 == w || i / w + 1 == h;
    let (border, covered) = (0..w * h).filter(on_border).fold((0, 0), |(n, c), i| (n + 1, c + usize::from(cells[i])));
    Shape {
        share: area as f32 / (w * h) as f32,
        border: covered as f32 / border.max(1) as f32,
        loose: if area == 0 { 1.0 } else { 1.0 - largest as f32 / area as f32 },
    }
}

fn merit(candidate: &Candidate, fit: Fit) -> Option<f32> {
    let s = shape(candidate, fit);
    if s.share < SPECK || s.share > SCENE || !candidate.score.is_finite() {
        return None;
    }
    let size = (s.share / LARGE).min(1.0);
    Some(candidate.score + SIZE_WEIGHT * size - BORDER_WEIGHT * s.border - PIECES_WEIGHT * s.loose)
}

/// Of the best by score, area, border contact and connectedness; none where all are specks or the whole scene.
pub(super) fn best(candidates: &[Candidate], fit: Fit) -> Option<usize> {
    let mut best: Option<(usize, f32)> = None;
    for (i, candidate) in candidates.iter().enumerate() {
        if let Some(m) = merit(candidate, fit)
            && best.is_none_or(|(_, b)| m > b)
        {
            best = Some((i, m));
        }
    }
    best.map(|(i, _)| i)
}

/// Intersection over union.
fn overlap(a: &Candidate, b: &Candidate, fit: Fit) -> f32 {
    let ((_, _, a), (_, _, b)) = (inside(a, fit), inside(b, fit));
    let (both, either) =
        a.iter().zip(&b).fold((0, 0), |(n, m), (a, b)| (n + usize::from(*a && *b), m + usize::from(*a || *b)));
    both as f32 / either.max(1) as f32
}

/// The candidate that shows the same thing as `earlier`; none where none does.
pub(super) fn most_like<'a>(candidates: &'a [Candidate], earlier: &Candidate, fit: Fit) -> Option<&'a Candidate> {
    let alike = candidates.iter().map(|c| (c, overlap(c, earlier, fit)));
    alike.filter(|(_, o)| *o > 0.6).max_by(|a, b| a.1.total_cmp(&b.1)).map(|(c, _)| c)
}
