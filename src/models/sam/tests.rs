//! Coordinates, choice and refinement, on the contract stub and on decoders made here.

use std::cell::RefCell;
use std::sync::{Arc, Mutex};

use super::choice::{best, most_like, shape};
use super::*;
use crate::models::registry::tests::stub;
use crate::models::{Engine as _, Port, Rten, Tensor};
use crate::progress::Silent;

fn photo(w: u32, h: u32) -> RgbImage {
    RgbImage::from_fn(w, h, |x, y| image::Rgb([x as u8, y as u8, 90]))
}

fn point(x: f32, y: f32) -> Prompt {
    Prompt { points: vec![[x, y]], ..Prompt::default() }
}

/// Logits of a disc, in pixels of the 1024² frame.
fn disc(centre: [f32; 2], radius: f32) -> Plane {
    let at = |i: usize| (i as f32 + 0.5) * 4.0;
    let d = |i: usize| ((at(i % LOW) - centre[0]).powi(2) + (at(i / LOW) - centre[1]).powi(2)).sqrt();
    Plane { width: LOW, height: LOW, data: (0..LOW * LOW).map(|i| (radius - d(i)) * 0.1).collect() }
}

/// Centre and area of a mask, in its pixels.
fn moments(mask: &GrayImage) -> ([f32; 2], f32) {
    let (mut x, mut y, mut n) = (0.0, 0.0, 0.0);
    for (i, j, _) in mask.enumerate_pixels().filter(|(.., v)| v.0[0] > 127) {
        (x, y, n) = (x + i as f32 + 0.5, y + j as f32 + 0.5, n + 1.0);
    }
    ([x / n, y / n], n)
}

#[test]
fn the_stubs_disc_is_around_the_click_in_photo_pixels() {
    let opened = RefCell::new(Vec::new());
    let mut open = |role: Role| {
        opened.borrow_mut().push(role);
        Rten.load_file(&stub(if role == Role::Encoder { "sam2_encoder.onnx" } else { "sam2_decoder.onnx" }))
    };
    // The middle disc scores best: radius 300 of 1024, squashed to the photo: 234 across, 176 down.
    let found = segment(&photo(800, 600), &point(360.0, 330.0), Family::Sam2Samexporter, &mut open, &Silent).unwrap();
    let (centre, area) = moments(&found.mask);
    assert!((centre[0] - 360.0).abs() < 2.0 && (centre[1] - 330.0).abs() < 2.0, "{centre:?}");
    let ellipse = std::f32::consts::PI * 234.4 * 175.8;
    assert!((area / ellipse - 1.0).abs() < 0.02, "{area} {ellipse}");
    assert!(found.refined && (found.score - 0.9).abs() < 1e-6);
    assert_eq!(*opened.borrow(), [Role::Encoder, Role::Decoder]);
    // Nothing said: the centre.
    let centred = segment(&photo(300, 500), &Prompt::default(), Family::Sam2Samexporter, &mut open, &Silent).unwrap();
    let (centre, _) = moments(&centred.mask);
    assert!((centre[0] - 150.0).abs() < 1.0 && (centre[1] - 250.0).abs() < 1.5, "{centre:?}");
}

/// What a decoder was fed, the latest last.
type Fed = Arc<Mutex<Vec<Vec<(String, Tensor)>>>>;

/// A decoder made here: gives these masks whatever it is asked, and remembers what it was fed.
struct Made {
    inputs: Vec<Port>,
    outputs: Vec<(String, Tensor)>,
    fed: Fed,
}

impl Graph for Made {
    fn inputs(&self) -> Vec<Port> {
        self.inputs.clone()
    }
    fn outputs(&self) -> Vec<Port> {
        self.outputs.iter().map(|(n, _)| Port::any(n)).collect()
    }
    fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
        self.fed.lock().unwrap().push(inputs.iter().map(|(n, t)| ((*n).to_owned(), (*t).clone())).collect());
        Ok(self.outputs.clone())
    }
}

fn run_made(
    family: Family,
    picture: &RgbImage,
    prompt: &Prompt,
    encoder: Port,
    inputs: Vec<Port>,
    outputs: Vec<(&str, Tensor)>,
) -> (Result<Found>, Vec<Vec<(String, Tensor)>>) {
    let fed: Fed = Arc::default();
    let outputs: Vec<(String, Tensor)> = outputs.into_iter().map(|(n, t)| (n.to_owned(), t)).collect();
    let embedding = vec![("image_embeddings".to_owned(), Tensor::new(&[1], vec![0.5]).unwrap())];
    let mut open = |role: Role| -> Result<Box<dyn Graph>> {
        Ok(Box::new(match role {
            Role::Encoder => Made { inputs: vec![encoder.clone()], outputs: embedding.clone(), fed: fed.clone() },
            _ => Made { inputs: inputs.clone(), outputs: outputs.clone(), fed: fed.clone() },
        }))
    };
    let found = segment(picture, prompt, family, &mut open, &Silent);
    let all = fed.lock().unwrap().clone();
    (found, all)
}

fn near(fed: &[(String, Tensor)], name: &str, wanted: &[f32]) {
    let data = &get(fed, name).data;
    let same = data.len() == wanted.len() && data.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-2);
    assert!(same, "{name}: {data:?}, not {wanted:?}");
}

fn get<'a>(fed: &'a [(String, Tensor)], name: &str) -> &'a Tensor {
    &fed.iter().find(|(n, _)| n == name).unwrap_or_else(|| panic!("{name} was not fed")).1
}

#[test]
fn sam1_keeps_the_aspect_pads_and_appends_a_point() {
    // 800 × 400: scale 1.28, the photo covers 1024 × 512 of the frame.
    let low = disc([512.0, 256.0], 128.0);
    let full = |m: &Plane| m.data.clone();
    let names = ["image_embeddings", "point_coords", "point_labels", "mask_input", "has_mask_input", "orig_im_size"];
    let outputs = |low: &Plane| {
        vec![
            ("masks", Tensor::new(&[1, 1, 2, 2], vec![1.0; 4]).unwrap()),
            ("iou_predictions", Tensor::new(&[1, 1], vec![0.8]).unwrap()),
            ("low_res_masks", Tensor::new(&[1, 1, LOW, LOW], full(low)).unwrap()),
        ]
    };
    let inputs: Vec<Port> = names.iter().map(|n| Port::any(n)).collect();
    let hwc = Port::free("input_image", &[None, None, Some(3)]);
    let (found, fed) =
        run_made(Family::Sam1, &photo(800, 400), &point(400.0, 200.0), hwc, inputs.clone(), outputs(&low));
    let image = get(&fed[0], "input_image");
    assert_eq!(image.shape, [512, 1024, 3]);
    assert!(image.data.iter().copied().fold(0.0, f32::max) > 100.0, "0..255");
    near(&fed[1], "point_coords", &[512.0, 256.0, 0.0, 0.0]);
    assert_eq!(get(&fed[1], "point_labels").data, [1.0, -1.0]);
    assert_eq!(get(&fed[1], "orig_im_size").data, [400.0, 800.0]);
    assert_eq!(get(&fed[1], "has_mask_input").data, [0.0]);
    // The second pass is fed the chosen logits.
    assert_eq!(get(&fed[2], "has_mask_input").data, [1.0]);
    assert_eq!(get(&fed[2], "mask_input").data, low.data);
    let (centre, area) = moments(&found.unwrap().mask);
    assert!((centre[0] - 400.0).abs() < 1.0 && (centre[1] - 200.0).abs() < 1.0, "{centre:?}");
    assert!((area / (std::f32::consts::PI * 10_000.0) - 1.0).abs() < 0.03, "{area}");

    // With a box: its corners, no padding point; the other encoder gets planes, zero where padded.
    let planes = Port::new("input_image", &[1, 3, 1024, 1024]);
    let boxed = Prompt { bounds: Some([100.0, 50.0, 700.0, 350.0]), ..Prompt::default() };
    let (_, fed) = run_made(Family::Sam1, &photo(800, 400), &boxed, planes, inputs, outputs(&low));
    assert_eq!(get(&fed[1], "point_labels").data, [2.0, 3.0]);
    near(&fed[1], "point_coords", &[128.0, 64.0, 896.0, 448.0]);
    let image = get(&fed[0], "input_image");
    assert!(image.data[1024 * 512..1024 * 1024].iter().all(|v| *v == 0.0) && image.data[0] != 0.0);
}

#[test]
fn transformers_exports_get_points_and_boxes_apart() {
    let masks = [disc([256.0, 512.0], 60.0), disc([256.0, 512.0], 150.0), disc([256.0, 512.0], 800.0)];
    let outputs = || {
        let data: Vec<f32> = masks.iter().flat_map(|m| m.data.clone()).collect();
        vec![
            ("iou_scores", Tensor::new(&[1, 1, 3], vec![0.9, 0.88, 0.7]).unwrap()),
            ("pred_masks", Tensor::new(&[1, 1, 3, LOW, LOW], data).unwrap()),
        ]
    };
    let ports = |names: &[&str]| names.iter().map(|n| Port::any(n)).collect::<Vec<_>>();
    let encoder = Port::new("pixel_values", &[1, 3, 1024, 1024]);
    let mut prompt = Prompt { not: vec![[10.0, 10.0]], ..point(100.0, 100.0) };
    let all = ports(&["image_embeddings", "input_points", "input_labels", "input_boxes"]);
    let family = Family::Sam2Transformers;
    let (found, fed) = run_made(family, &photo(400, 200), &prompt, encoder.clone(), all.clone(), outputs());
    assert_eq!(get(&fed[1], "input_points").shape, [1, 1, 2, 2]);
    near(&fed[1], "input_points", &[256.0, 512.0, 25.6, 51.2]);
    assert_eq!(get(&fed[1], "input_labels").data, [1.0, 0.0]);
    assert_eq!(get(&fed[1], "input_boxes").shape, [1, 0, 4]);
    // Such an export takes no masks: one pass. The whole is chosen before its part, which scores a little more.
    let found = found.unwrap();
    assert!(fed.len() == 2 && !found.refined && found.score == 0.88);
    prompt.bounds = Some([50.0, 20.0, 350.0, 180.0]);
    let (_, fed) = run_made(family, &photo(400, 200), &prompt, encoder.clone(), all, outputs());
    near(&fed[1], "input_boxes", &[128.0, 102.4, 896.0, 921.6]);
    let points_only = ports(&["image_embeddings", "input_points", "input_labels"]);
    let (found, _) = run_made(family, &photo(400, 200), &prompt, encoder, points_only, outputs());
    assert!(found.unwrap_err().found.contains("points only"));
}

#[test]
fn choice_weighs_score_size_border_and_pieces() {
    let fit = Fit::of(Family::Sam2Samexporter, 500, 500);
    let of = |logits: Plane, score: f32| Candidate { logits, score };
    let centre = [512.0, 512.0];
    let two = |a: Plane, b: Plane| Plane { data: a.data.iter().zip(&b.data).map(|(a, b)| a.max(*b)).collect(), ..a };
    // A part scores best, the whole is taken; the scene is not, whatever it scores.
    let nested = [of(disc(centre, 90.0), 0.95), of(disc(centre, 300.0), 0.9), of(disc(centre, 2000.0), 0.99)];
    assert_eq!(best(&nested, fit), Some(1));
    // Two things are worse than one.
    let pieces = two(disc([250.0, 512.0], 150.0), disc([774.0, 512.0], 150.0));
    assert!((shape(&of(pieces.clone(), 0.0), fit).loose - 0.5).abs() < 0.01);
    assert_eq!(best(&[of(pieces, 0.9), of(disc(centre, 200.0), 0.8)], fit), Some(1));
    // What runs out of the frame is rather ground than subject.
    assert_eq!(best(&[of(disc([512.0, 1100.0], 500.0), 0.95), of(disc(centre, 200.0), 0.85)], fit), Some(1));
    assert_eq!(best(&[of(disc(centre, 5.0), 0.9)], fit), None);
    assert_eq!(best(&[of(disc(centre, 200.0), f32::NAN)], fit), None);
    let same = most_like(&nested, &of(disc(centre, 280.0), 0.0), fit).unwrap();
    assert_eq!(same.score, 0.9);
    assert_eq!(most_like(&nested[..1], &of(disc(centre, 280.0), 0.0), fit), None);
}

#[test]
fn places_outside_the_photo_are_refused() {
    for prompt in [
        point(-1.0, 5.0),
        point(5.0, 401.0),
        Prompt { bounds: Some([5.0, 5.0, 900.0, 20.0]), ..Prompt::default() },
        Prompt { bounds: Some([50.0, 5.0, 40.0, 20.0]), ..Prompt::default() },
        point(f32::NAN, 0.0),
    ] {
        assert_eq!(prompt.on(800, 400).unwrap_err().kind, crate::Kind::Usage, "{prompt:?}");
    }
}
