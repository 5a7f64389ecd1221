//! CA, controllability and alignment: whether the result is what was asked for.

use glam::Mat3;
use image::RgbImage;

use crate::models::picture::{self, Normalise};
use crate::models::{Graph, Tensor};
use crate::photo::{Edge, Rect, sample_colour};
use crate::{Error, Result};

pub use super::consistency::silhouette_iou as mask_iou;

/// The angle between two rotations, degrees: 2 asin(‖A − B‖ / 2√2), which is exact for small angles too.
pub fn rotation_angle(a: Mat3, b: Mat3) -> f64 {
    let d = (a - b).to_cols_array().iter().map(|v| f64::from(*v).powi(2)).sum::<f64>().sqrt();
    2.0 * (d / 8f64.sqrt()).clamp(0.0, 1.0).asin().to_degrees()
}

/// A picture in CLIP's space (Radford et al. 2021), by an image encoder with the input 1 × 3 × 224 × 224, normalised as
/// CLIP's, and the output `image_embeds`, or one output: unit length. The network sees the middle square.
///
/// # Errors
/// As the graph; environment where it answers something else.
pub fn clip_embedding(image: &RgbImage, graph: &dyn Graph) -> Result<Vec<f64>> {
    const SIDE: usize = 224;
    const CLIP: Normalise = picture::CLIP;
    let (w, h) = (image.width() as f32, image.height() as f32);
    let side = w.min(h);
    let middle = Rect { x: (w - side) / 2.0, y: (h - side) / 2.0, width: side, height: side };
    let pixels = sample_colour(image, middle, SIDE, SIDE, Edge::Clamp);
    let input: Tensor = picture::planes(&pixels, [SIDE; 2], [SIDE; 2], CLIP)?;
    let name = graph.inputs().first().map_or("pixel_values".to_owned(), |p| p.name.clone());
    let out = graph.run(&[(name.as_str(), &input)])?;
    let embedding = out.iter().find(|(n, _)| n == "image_embeds").or(out.first());
    let values = embedding.map(|(_, t)| t.data.iter().map(|v| f64::from(*v)).collect::<Vec<f64>>()).unwrap_or_default();
    let length = values.iter().map(|v| v * v).sum::<f64>().sqrt();
    if !(length.is_finite() && length > 0.0) {
        return Err(Error::environment("--clip").expected("an embedding").found(format!("a length of {length}")));
    }
    Ok(values.iter().map(|v| v / length).collect())
}

/// The cosine of two embeddings of unit length.
pub fn cosine(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_exact_however_small() {
        for degrees in [0.0f64, 0.01, 1.0, 40.0, 90.0, 179.0] {
            let turned =
                Mat3::from_axis_angle(glam::Vec3::new(1.0, 2.0, -0.5).normalize(), degrees.to_radians() as f32);
            let found = rotation_angle(turned * Mat3::from_rotation_x(0.3), Mat3::from_rotation_x(0.3));
            assert!((found - degrees).abs() < 0.02, "{found} for {degrees}");
        }
    }
}
