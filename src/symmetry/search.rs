//! The best vertical plane: a grid over heading and offset, then a closer look around the best few.

use glam::Vec3;
use rayon::prelude::*;

use super::evidence::{Evidence, Field, extent, projected};
use super::middle::centred;
use super::{Plane, Seen, Use, flipped};
use crate::splat::{self, Gaussians};

/// How well a subject meets its mirror image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    pub plane: Plane,
    /// Mean distance between the mirrored shape and the shape, in bounding-sphere radii.
    pub shape: f32,
    /// Share of the seen surface whose mirror image would lie in front of what the photo shows, or beside it.
    pub contradicted: f32,
    /// Mean colour difference (sRGB 0..1, a channel) where the photo sees a point and its mirror image, over the same
    /// between points taken at random. Below 1: mirrored points look alike. 1 where there are too few.
    pub color: f32,
    /// Share of the seen surface whose mirror image the photo sees too, far enough from the plane to say anything.
    pub pairs: f32,
    /// Share of the seen surface whose mirror image the photo does not see.
    pub hidden: f32,
    /// Intersection over union of the mirrored mask and the shape's silhouette from the mirrored camera.
    pub silhouette: f32,
    /// How far the shape reaches along the plane's normal, over how far along the plane, both level.
    pub elongation: f32,
    /// Share of the seen surface whose mirror image lies further than [`STRAY`] from the shape.
    pub stray: f32,
}

impl Fit {
    /// 0 where there is nothing to say: shape and contradictions raise it, colours that are alike lower it.
    fn misfit(&self) -> f32 {
        let color = (self.color - 1.0) * (self.pairs / 0.15).min(1.0);
        self.askew() + 0.7 * color
    }

    /// How badly the shape meets itself, colours aside. On ribs, bricks and windows colours are alike at many places, and on
    /// a plain wall everywhere; where exactly a plane lies, the shape knows better.
    fn askew(&self) -> f32 {
        (self.shape - SAMPLED) / 0.1 + 2.0 * self.contradicted
    }

    /// What is minimised: of planes that fit alike, the one that gives more of the unseen side.
    fn cost(&self) -> f32 {
        self.misfit() - 0.4 * self.hidden
    }

    /// The same where the photo has nothing to say: most bodies with a long side are alike on both sides of their length.
    fn cost_by_length(&self) -> f32 {
        self.cost() + 0.2 * self.elongation.max(1e-3).ln()
    }

    /// Good enough to be used unasked, and worth it.
    pub fn convinces(&self) -> bool {
        self.gives() && self.misfit() < 0.05 && !self.swaps_unlike_ends()
    }

    /// Across a length the plane says that both ends are alike. Wool and fur are alike in colour everywhere; but a head meets
    /// nothing at the other end.
    fn swaps_unlike_ends(&self) -> bool {
        self.elongation > 1.3 && self.stray > 0.01
    }

    /// Whether nothing speaks against it. Of what is photographed from the side the photo shows no two points that are each
    /// other's mirror image, so that nothing can speak for it: most bodies with a long side are alike on both. Where much of what
    /// was seen meets nothing, a nose and two paws stand at a back.
    pub fn plausible(&self) -> bool {
        self.gives() && self.askew() < 0.45 && self.elongation < 1.2 && self.stray < 0.15
    }

    /// The same of the plane at right angles to another one. Cab and tail of a lorry that is one white wall are alike in colour;
    /// that a back is like its front the shape has to say as well.
    fn convinces_across(&self) -> bool {
        self.convinces() && self.plausible_across()
    }

    /// Whether nothing speaks against it at right angles to another one. That a back is like its front is said more rarely.
    fn plausible_across(&self) -> bool {
        self.askew() < 0.2 && self.silhouette > 0.6
    }

    fn gives(&self) -> bool {
        self.hidden > 0.1 && self.silhouette > 0.6
    }
}

/// So far the samples of a surface lie from the samples of the same surface, about (forklift, container, car, bear: 0.006 to
/// 0.011 more than where all that share a cell of 0.05 counted as one).
const SAMPLED: f32 = 0.01;
/// A surface point within this of the seen depth is the seen one.
const SAME: f32 = 0.08;
/// Beyond this a mirrored point meets nothing; bounding-sphere radii.
const STRAY: f32 = 0.1;

/// Why a plane is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// The subject meets its mirror image well enough.
    Evident,
    /// Nothing speaks against it.
    Assumed,
    /// The user wants it.
    Asked,
}

impl Basis {
    pub fn label(self) -> &'static str {
        match self {
            Basis::Evident => "evident",
            Basis::Assumed => "assumed",
            Basis::Asked => "asked",
        }
    }
}

/// A plane, and why it is used; None where it is not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// What it was chosen and judged by, where the shape alone has it.
    pub fit: Fit,
    /// Where it is used: moved along its normal to the middle of what the subject looks like.
    pub plane: Plane,
    pub basis: Option<Basis>,
}

impl Found {
    pub fn used(&self) -> bool {
        self.basis.is_some()
    }
}

/// The planes that are to be used, in their order.
pub fn used(found: &[Found]) -> Vec<Plane> {
    found.iter().filter(|f| f.used()).map(|f| f.plane).collect()
}

/// Whether a plane that is used was assumed.
pub fn assumed(found: &[Found]) -> bool {
    found.iter().any(|f| f.basis == Some(Basis::Assumed))
}

/// The best plane, and where that one is used or fits about as well the best at right angles to it. Empty where nothing is looked for, or too
/// little is solid to judge.
///
/// `g`: in the unit frame, Z up.
pub fn find(g: &Gaussians, seen: &Seen, wanted: Use) -> Vec<Found> {
    if wanted == Use::Off {
        return Vec::new();
    }
    let Some(evidence) = Evidence::new(g, seen) else { return Vec::new() };
    let variation = variation(&evidence);
    let with_silhouette = |fit: Fit| Fit { silhouette: silhouette(g, seen, &fit.plane), ..fit };
    let Some(first) = best(&evidence, variation, with_silhouette) else { return Vec::new() };
    let basis = match wanted {
        _ if first.convinces() => Some(Basis::Evident),
        Use::On | Use::Two => Some(Basis::Asked),
        Use::Auto if first.plausible() => Some(Basis::Assumed),
        _ => None,
    };
    let found = |fit: Fit, basis: Option<Basis>| {
        let plane = if basis.is_some() { centred(g, fit.plane) } else { fit.plane };
        Found { fit, plane, basis }
    };
    let mut all = vec![found(first, basis)];
    // A plane that the photo looks along gives nothing; one across it may all the same.
    if (basis.is_some() || first.plausible_across())
        && let Some(second) = across(&evidence, variation, &first.plane).map(with_silhouette)
    {
        let basis = match wanted {
            Use::Auto | Use::Evident | Use::Two if all[0].used() && second.convinces_across() => Some(Basis::Evident),
            Use::Two => Some(Basis::Asked),
            Use::Auto if second.plausible_across() && second.gives() && is_tower(&evidence, &first.plane) => {
                Some(Basis::Assumed)
            }
            _ => None,
        };
        all.push(found(second, basis));
    }
    all
}

/// The best plane by all that the photo and the shape say; where that does not convince, the best with the subject's length.
fn best(evidence: &Evidence, variation: f32, with_silhouette: impl Fn(Fit) -> Fit) -> Option<Fit> {
    let score = |heading: f32, offset: f32| judge(evidence, variation, plane(evidence, heading, offset));
    let coarse: Vec<(Fit, f32, f32)> = (0..60 * 31)
        .into_par_iter()
        .map(|k| {
            let (heading, offset) = ((k % 60) as f32 * 3.0, (k / 60) as f32 * 0.03 - 0.45);
            (score(heading, offset), heading, offset)
        })
        .collect();
    let seen = best_by(&coarse, &score, Fit::cost).map(&with_silhouette)?;
    if seen.convinces() {
        return Some(seen);
    }
    best_by(&coarse, &score, Fit::cost_by_length).map(with_silhouette)
}

/// A closer look around the best few of a grid (fit, heading, offset).
fn best_by(coarse: &[(Fit, f32, f32)], score: &impl Fn(f32, f32) -> Fit, cost: fn(&Fit) -> f32) -> Option<Fit> {
    let costs: Vec<(f32, f32, f32)> = coarse.iter().map(|(fit, h, o)| (cost(fit), *h, *o)).collect();
    let mut order: Vec<usize> = (0..costs.len()).collect();
    order.sort_by(|a, b| costs[*a].0.total_cmp(&costs[*b].0).then(a.cmp(b)));
    let apart = |a: &(f32, f32, f32), b: &(f32, f32, f32)| {
        let turn = (a.1 - b.1).abs();
        turn.min(180.0 - turn) > 15.0 || (a.2 - b.2).abs() > 0.15
    };
    let mut best: Vec<(f32, f32, f32)> = Vec::new();
    for k in order {
        if best.iter().all(|b| apart(b, &costs[k])) {
            best.push(costs[k]);
        }
        if best.len() == 4 {
            break;
        }
    }
    let refined: Vec<_> = best.into_iter().map(|start| closer(start, &|h, o| cost(&score(h, o)))).collect();
    let (_, heading, offset) = refined.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
    let start = (score(heading, offset).askew(), heading, offset);
    let (_, heading, offset) = closer(start, &|h, o| score(h, o).askew());
    Some(score(heading, offset))
}

/// Whether the subject stands upright on a footprint about as long as wide: towers, mills and silos have no front.
fn is_tower(evidence: &Evidence, first: &Plane) -> bool {
    let extent = |along: Vec3| extent(&evidence.shape, along);
    let (wide, deep, high) = (extent(first.normal), extent(first.normal.cross(Vec3::Z)), extent(Vec3::Z));
    high > 1.2 * wide.max(deep) && wide.max(deep) < 1.3 * wide.min(deep)
}

/// The best at right angles to `first`: how far off the middle is all there is to find.
fn across(evidence: &Evidence, variation: f32, first: &Plane) -> Option<Fit> {
    let heading = first.normal.y.atan2(first.normal.x).to_degrees() + 90.0;
    (-90..=90)
        .into_par_iter()
        .map(|k| judge(evidence, variation, plane(evidence, heading, k as f32 * 0.005)))
        .min_by(|a, b| a.askew().total_cmp(&b.askew()))
}

/// Steps of heading and offset, halved when none helps.
fn closer(mut at: (f32, f32, f32), cost: &impl Fn(f32, f32) -> f32) -> (f32, f32, f32) {
    let (mut turn, mut shift) = (1.5, 0.015);
    for _ in 0..24 {
        let tries = [(turn, 0.0), (-turn, 0.0), (0.0, shift), (0.0, -shift)];
        let next = tries
            .map(|(t, s)| (cost(at.1 + t, at.2 + s), at.1 + t, at.2 + s))
            .into_iter()
            .min_by(|a, b| a.0.total_cmp(&b.0));
        match next {
            Some(next) if next.0 < at.0 => at = next,
            _ => (turn, shift) = (turn / 2.0, shift / 2.0),
        }
        if turn < 0.1 {
            break;
        }
    }
    at
}

/// Vertical, its normal's heading counter-clockwise from +X in degrees, turned towards the camera.
fn plane(evidence: &Evidence, heading: f32, offset: f32) -> Plane {
    let (sin, cos) = heading.to_radians().sin_cos();
    let plane = Plane { normal: Vec3::new(cos, sin, 0.0), offset };
    if plane.distance(evidence.camera.position()) >= 0.0 {
        plane
    } else {
        Plane { normal: -plane.normal, offset: -offset }
    }
}

/// Mean colour difference between seen points taken at random.
fn variation(evidence: &Evidence) -> f32 {
    let points = &evidence.points;
    let n = points.len();
    let other = |i: usize| (i * 7919 + n / 2) % n;
    let sum: f32 = (0..n).map(|i| difference(points[i].1, points[other(i)].1)).sum();
    (sum / n as f32).max(0.01)
}

fn difference(a: [f32; 3], b: [f32; 3]) -> f32 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum::<f32>() / 3.0
}

fn judge(evidence: &Evidence, variation: f32, plane: Plane) -> Fit {
    let shape: f32 =
        evidence.shape.iter().step_by(2).map(|p| evidence.field.at(plane.reflect(*p)).min(Field::FAR)).sum();
    let shape = shape / evidence.shape.len().div_ceil(2) as f32;
    let size = evidence.camera.width as usize;
    let (mut contradicted, mut pairs, mut hidden, mut color, mut stray) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for &(p, c) in &evidence.points {
        let image = plane.reflect(p);
        stray += f32::from(u8::from(evidence.field.at(image) > STRAY));
        let at = projected(&evidence.camera, image);
        if !(at.x >= 0.0 && at.y >= 0.0 && at.x < size as f32 && at.y < size as f32) {
            contradicted += 1.0;
            continue;
        }
        let i = at.y as usize * size + at.x as usize;
        if evidence.outside[i] > 0.0 {
            contradicted += (evidence.outside[i] / 6.0).min(1.0);
            continue;
        }
        if evidence.depth[i] <= 0.0 {
            continue;
        }
        let behind = at.z - evidence.depth[i];
        if behind > SAME {
            hidden += 1.0;
        } else if behind < -SAME {
            contradicted += ((-behind - SAME) / 0.15).min(1.0);
        } else if plane.distance(p).abs() > 0.06 {
            pairs += 1.0;
            color += difference(c, evidence.color[i]) / variation;
        }
    }
    let all = evidence.points.len() as f32;
    Fit {
        plane,
        shape,
        contradicted: contradicted / all,
        color: if pairs > 20.0 { color / pairs } else { 1.0 },
        pairs: pairs / all,
        hidden: hidden / all,
        silhouette: 0.0,
        elongation: evidence.extents.along(plane.normal) / evidence.extents.along(plane.normal.cross(Vec3::Z)),
        stray: stray / all,
    }
}

/// How well the subject meets its mirror image at one plane; `None` where too little is solid to judge.
#[cfg(test)]
pub(super) fn fit(g: &Gaussians, seen: &Seen, plane: Plane) -> Option<Fit> {
    let evidence = Evidence::new(g, seen)?;
    Some(Fit { silhouette: silhouette(g, seen, &plane), ..judge(&evidence, variation(&evidence), plane) })
}

fn silhouette(g: &Gaussians, seen: &Seen, plane: &Plane) -> f32 {
    let frame = splat::render(g, &plane.camera(&seen.camera), [0.5; 3]);
    let mask = flipped(seen.mask, seen.camera.width as usize);
    let (mut both, mut either) = (0u32, 0u32);
    for (a, m) in frame.alpha.iter().zip(&mask) {
        let (a, m) = (*a > 0.5, *m > 0.5);
        both += u32::from(a && m);
        either += u32::from(a || m);
    }
    both as f32 / either.max(1) as f32
}
