//! How far things are, by Depth Anything 1, 2 or 3.
//!
//! L. Yang et al., "Depth Anything V2", NeurIPS 2024. The network gives relative inverse depth (or, some exports of version
//! 3, depth), up to a scale and a shift; [`fit`] finds both against the surface of the built-in prior. The metric variants
//! give metres, and so the model's scale too.

pub mod fit;

use image::RgbImage;

use super::registry::catalogue::DepthKind;
use super::{Graph, picture};
use crate::photo::{Edge, Plane, Rect, sample_colour, sample_plane};
use crate::{Error, Result};

/// Of the transformer's patches.
const PATCH: usize = 14;
/// The shorter side that the network was trained with.
const SHORT: usize = 518;
/// The longer side at most: memory grows with its square.
const LONGEST: usize = 1036;

/// What a network says of a photo.
#[derive(Clone, Debug)]
pub struct Seen {
    /// Relative inverse depth: (d − min) / (max − min), the paper's Eq. 1; 1 is nearest.
    pub inverse: Plane,
    /// min and max of a metric network, 1 / metres.
    pub metric: Option<(f32, f32)>,
}

/// Inverse depth of the whole photo at `size` (width, height).
///
/// # Errors
/// An environment error when the graph's output is no plane, is flat or not finite.
pub fn inverse_depth(photo: &RgbImage, kind: DepthKind, graph: &dyn Graph, size: (usize, usize)) -> Result<Seen> {
    let wrong = |found: String| Error::environment("the depth network").expected("a plane of depths").found(found);
    let input = graph.inputs().into_iter().next().ok_or_else(|| wrong("no input".into()))?;
    let fixed = |back: usize| {
        let shape = input.shape.as_ref()?;
        shape.len().checked_sub(back).and_then(|i| shape[i]).filter(|n| *n > 0)
    };
    let (w, h) = input_size(photo.dimensions(), fixed(1), fixed(2));
    let whole = Rect { x: 0.0, y: 0.0, width: photo.width() as f32, height: photo.height() as f32 };
    let image = picture::planes(&sample_colour(photo, whole, w, h, Edge::Clamp), [w, h], [w, h], picture::IMAGENET)?;
    let outputs = graph.run(&[(input.name.as_str(), &image)])?;
    let named = outputs.iter().find(|(n, _)| n == "predicted_depth" || n == "depth").or(outputs.first());
    let (_, out) = named.ok_or_else(|| wrong("no output".into()))?;
    let [.., height, width] = out.shape[..] else { return Err(wrong(format!("{:?}", out.shape))) };
    if out.data.len() != width * height || !out.data.iter().all(|v| v.is_finite()) {
        return Err(wrong(format!("{:?}, or numbers that are not finite", out.shape)));
    }
    let data = match kind {
        DepthKind::Disparity => out.data.clone(),
        DepthKind::Depth | DepthKind::Metric => {
            let farthest = out.data.iter().copied().fold(0.0, f32::max);
            out.data.iter().map(|z| 1.0 / z.max(1e-4 * farthest.max(1e-4))).collect()
        }
    };
    let (low, high) = range(&data);
    if high - low < 1e-6 * high.abs().max(1e-6) {
        return Err(wrong(format!("the same depth everywhere: {low}")));
    }
    let plane = Plane { width, height, data };
    let all = Rect { x: 0.0, y: 0.0, width: width as f32, height: height as f32 };
    let mut depth = sample_plane(&plane, all, size.0, size.1, Edge::Clamp);
    let (low, high) = range(&depth.data);
    depth.data.iter_mut().for_each(|v| *v = (*v - low) / (high - low));
    Ok(Seen { inverse: depth, metric: (kind == DepthKind::Metric).then_some((low, high)) })
}

fn range(data: &[f32]) -> (f32, f32) {
    data.iter().fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)))
}

/// What the graph fixes, else the photo's aspect with the shorter side at 518, both sides multiples of 14.
fn input_size((w, h): (u32, u32), fixed_width: Option<usize>, fixed_height: Option<usize>) -> (usize, usize) {
    let (w, h) = (w as f32, h as f32);
    let scale = (SHORT as f32 / w.min(h)).min(LONGEST as f32 / w.max(h));
    let side = |v: f32| ((v * scale / PATCH as f32).round() as usize).max(1) * PATCH;
    (fixed_width.unwrap_or(side(w)), fixed_height.unwrap_or(side(h)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::registry::tests::stub;
    use crate::models::{Engine as _, Port, Rten, Tensor};

    /// Gives what it is made with, of whatever shape.
    struct Fixed(Vec<usize>, Vec<f32>);
    impl Graph for Fixed {
        fn inputs(&self) -> Vec<Port> {
            vec![Port::free("image", &[None, Some(3), None, None])]
        }
        fn outputs(&self) -> Vec<Port> {
            vec![Port::any("depth")]
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            assert_eq!((inputs[0].0, &inputs[0].1.shape[..2]), ("image", &[1, 3][..]));
            Ok(vec![("depth".into(), Tensor::new(&self.0, self.1.clone())?)])
        }
    }

    #[test]
    fn the_photos_aspect_is_kept_in_whole_patches() {
        assert_eq!(input_size((1920, 1080), None, None), (924, 518));
        assert_eq!(input_size((500, 500), None, None), (518, 518));
        assert_eq!(input_size((100, 4000), None, None), (28, 1036));
        assert_eq!(input_size((1920, 1080), Some(518), Some(252)), (518, 252));
    }

    #[test]
    fn the_stub_sees_bright_as_near_from_0_to_1() {
        let photo = RgbImage::from_fn(120, 90, |x, _| image::Rgb(if x > 60 { [220; 3] } else { [30; 3] }));
        let graph = Rten.load_file(&stub("depth_anything_v2.onnx")).unwrap();
        let depth = inverse_depth(&photo, DepthKind::Disparity, &*graph, (60, 45)).unwrap().inverse;
        assert_eq!((depth.width, depth.height, range(&depth.data)), (60, 45, (0.0, 1.0)));
        // The stub blurs over 7 pixels of 518 and darkens at its border.
        assert!(depth.at(45, 22) > 0.85 && depth.at(15, 22) < depth.at(45, 22) - 0.5);
        let far = inverse_depth(&photo, DepthKind::Depth, &*graph, (60, 45)).unwrap();
        assert!(far.inverse.at(45, 22) < far.inverse.at(15, 22), "depth grows where disparity shrinks");
        assert_eq!(far.metric, None);
    }

    #[test]
    fn a_metric_networks_metres_come_back_from_its_range() {
        let photo = RgbImage::new(64, 64);
        let metres: Vec<f32> = (0..12).map(|v| 2.0 + v as f32).collect();
        let seen = inverse_depth(&photo, DepthKind::Metric, &Fixed(vec![1, 3, 4], metres.clone()), (4, 3)).unwrap();
        let (low, high) = seen.metric.unwrap();
        for (i, z) in metres.iter().enumerate() {
            let back = 1.0 / (low + seen.inverse.data[i] * (high - low));
            assert!((back / z - 1.0).abs() < 1e-5, "{back} {z}");
        }
    }

    #[test]
    fn outputs_of_either_rank_are_taken_and_bad_ones_refused() {
        let photo = RgbImage::new(64, 64);
        let ramp: Vec<f32> = (0..12).map(|v| v as f32).collect();
        for shape in [vec![1, 3, 4], vec![1, 1, 3, 4]] {
            let depth = inverse_depth(&photo, DepthKind::Disparity, &Fixed(shape, ramp.clone()), (4, 3)).unwrap();
            assert!(depth.inverse.at(0, 0) == 0.0 && depth.inverse.at(3, 2) == 1.0);
        }
        let refused = |shape: &[usize], data: Vec<f32>| {
            inverse_depth(&photo, DepthKind::Disparity, &Fixed(shape.to_vec(), data), (4, 3)).unwrap_err().found
        };
        assert!(refused(&[1, 3, 4], vec![2.0; 12]).contains("the same depth everywhere"));
        assert!(refused(&[1, 1, 4], vec![1.0, f32::NAN, 0.0, 3.0]).contains("not finite"));
        assert!(refused(&[2, 1, 4], vec![1.0; 8]).contains("[2, 1, 4]"));
    }
}
