//! How far off the middle a plane lies, by pictures of the subject and of its mirror image.
//!
//! Surfaces do not tell it: the near side, which the photo shows, is solid, the far side more or less fog, and what counts as
//! fog's surface (half of the light gone) lies deeper than its silhouette has it. Planes that the shape chose stood 0.02 of the
//! bounding sphere's radius too near to the camera, so that a completed car was 0.05 too narrow.

use rayon::prelude::*;

use super::{Plane, flipped};
use crate::splat::render::Drawers;
use crate::splat::{Camera, Frame, Gaussians};
use crate::views;

/// Pictures all around, from this far above the horizon (degrees), of so many pixels.
const PICTURES: usize = 8;
const ELEVATION: f32 = 20.0;
const SIZE: u32 = 64;
/// Steps along the normal, bounding-sphere radii: the first one, and where halving ends.
const FIRST: f32 = 0.02;
const LAST: f32 = 0.0025;
/// A plane is moved by no more than so many of the first steps.
const MOST: usize = 5;

/// `plane` moved along its normal to where the subject's mirror image looks most like the subject.
pub(super) fn centred(g: &Gaussians, plane: Plane) -> Plane {
    let turn = 360.0 / PICTURES as f32;
    let cameras: Vec<Camera> =
        (0..PICTURES).map(|k| views::orbit(turn * k as f32, ELEVATION, views::DISTANCE, SIZE)).collect();
    let drawers = Drawers::new(g);
    let drawn = |camera: &Camera| drawers.render(camera, [0.0; 3]);
    let shown: Vec<Frame> = cameras.par_iter().map(drawn).collect();
    let unlike = |offset: f32| -> f32 {
        let moved = Plane { offset, ..plane };
        let each: Vec<f32> =
            cameras.par_iter().zip(&shown).map(|(c, shown)| difference(shown, &drawn(&moved.camera(c)))).collect();
        each.iter().sum()
    };
    let (mut best, mut step) = ((unlike(plane.offset), plane.offset), FIRST);
    while step >= LAST {
        let next = [-step, step].map(|s| best.1 + s).map(|offset| (unlike(offset), offset));
        let next = if next[0].0 < next[1].0 { next[0] } else { next[1] };
        let near = (next.1 - plane.offset).abs() < (MOST as f32 + 0.5) * FIRST;
        if next.0 < best.0 && near {
            best = next;
        } else {
            step /= 2.0;
        }
    }
    Plane { offset: best.1, ..plane }
}

/// Of a picture and a mirrored camera's: squares of coverage and of colours on black.
fn difference(shown: &Frame, mirrored: &Frame) -> f32 {
    let (alpha, color) = (flipped(&mirrored.alpha, SIZE as usize), flipped(&mirrored.color, SIZE as usize));
    let square = |a: f32, b: f32| (a - b) * (a - b);
    let coverage: f32 = shown.alpha.iter().zip(&alpha).map(|(a, b)| square(*a, *b)).sum();
    let colours = shown.color.iter().zip(&color).flat_map(|(a, b)| a.iter().zip(b));
    coverage + colours.map(|(a, b)| square(*a, *b)).sum::<f32>() / 3.0
}
