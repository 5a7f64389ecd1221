//! The photo as the encoders want it, and what they make of it.

use image::RgbImage;

use super::{FRAME, Fit};
use crate::models::registry::Family;
use crate::models::{Graph, Tensor, picture};
use crate::photo::{Edge, Rect, sample_colour};
use crate::{Error, Result};

/// The encoder's outputs by name; the decoder's inputs of the same names.
pub type Embedding = Vec<(String, Tensor)>;

pub fn embed(photo: &RgbImage, family: Family, fit: Fit, graph: &dyn Graph) -> Result<Embedding> {
    let input = graph
        .inputs()
        .into_iter()
        .next()
        .ok_or_else(|| Error::environment("the mask network's encoder").expected("an input").found("none"))?;
    let whole = Rect { x: 0.0, y: 0.0, width: photo.width() as f32, height: photo.height() as f32 };
    let covered = fit.covered.map(|v| (v.round() as usize).clamp(1, FRAME));
    let pixels = sample_colour(photo, whole, covered[0], covered[1], Edge::Clamp);
    let rank = input.shape.as_ref().map_or(4, Vec::len);
    let image = if family == Family::Sam1 && rank == 3 {
        // Rows, columns, channels, 0..255: the graph does the rest.
        let data = pixels.iter().flatten().map(|v| v * 255.0).collect();
        Tensor::new(&[covered[1], covered[0], 3], data)?
    } else {
        picture::planes(&pixels, covered, [FRAME, FRAME], picture::IMAGENET)?
    };
    graph.run(&[(input.name.as_str(), &image)])
}
