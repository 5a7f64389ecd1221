//! The decoders of the three families behind one face: a prompt in, candidate masks out.

use super::encoder::Embedding;
use super::{Candidate, FRAME, Fit, LOW, Prompt};
use crate::models::registry::Family;
use crate::models::{Graph, Port, Tensor};
use crate::photo::{Edge, Plane, Rect, sample_plane};
use crate::{Error, Result};

pub struct Decoder {
    family: Family,
    graph: Box<dyn Graph>,
    inputs: Vec<Port>,
    embedding: Embedding,
    fit: Fit,
    /// Width and height of the photo.
    photo: (u32, u32),
}

impl Decoder {
    pub fn new(
        family: Family,
        graph: Box<dyn Graph>,
        embedding: Embedding,
        fit: Fit,
        photo: (u32, u32),
    ) -> Result<Decoder> {
        let inputs = graph.inputs();
        // Some encoders give more than their decoder wants.
        let embedding: Embedding =
            embedding.into_iter().filter(|(name, _)| inputs.iter().any(|p| p.name == *name)).collect();
        if embedding.is_empty() {
            return Err(Error::environment("the mask network's decoder")
                .expected("inputs named as its encoder's outputs")
                .found(inputs.iter().map(Port::to_string).collect::<Vec<_>>().join(", ")));
        }
        Ok(Decoder { family, graph, inputs, embedding, fit, photo })
    }

    fn has(&self, name: &str) -> bool {
        self.inputs.iter().any(|p| p.name == name)
    }

    /// Logits of an earlier pass can be fed.
    pub fn takes_masks(&self) -> bool {
        self.has("mask_input") || self.has("input_masks")
    }

    /// Every mask with its score, in the network's order.
    pub fn masks(&self, prompt: &Prompt, earlier: Option<&Plane>) -> Result<Vec<Candidate>> {
        let mut fed: Vec<(&str, Tensor)> = match self.family {
            Family::Sam2Transformers => self.transformers_prompt(prompt)?,
            _ => self.classic_prompt(prompt)?,
        };
        let (mask, flag) =
            if self.has("input_masks") { ("input_masks", "has_mask_input") } else { ("mask_input", "has_mask_input") };
        if self.has(mask) {
            let logits = earlier.map_or_else(|| vec![0.0; LOW * LOW], |p| p.data.clone());
            fed.push((mask, Tensor::new(&[1, 1, LOW, LOW], logits)?));
        }
        if self.has(flag) {
            fed.push((flag, Tensor::new(&[1], vec![f32::from(u8::from(earlier.is_some()))])?));
        }
        if self.has("orig_im_size") {
            let (w, h) = self.photo;
            fed.push(("orig_im_size", Tensor::new(&[2], vec![h as f32, w as f32])?));
        }
        let mut all: Vec<(&str, &Tensor)> = self.embedding.iter().map(|(n, t)| (n.as_str(), t)).collect();
        all.extend(fed.iter().map(|(n, t)| (*n, t)));
        self.candidates(&self.graph.run(&all)?)
    }

    /// Points, box corners and labels in one list; SAM 1 wants a padding point where there is no box.
    fn classic_prompt(&self, prompt: &Prompt) -> Result<Vec<(&'static str, Tensor)>> {
        let (mut points, mut labels) = self.listed(prompt);
        if let Some([x0, y0, x1, y1]) = prompt.bounds {
            points.extend([self.fit.to_frame([x0, y0]), self.fit.to_frame([x1, y1])]);
            labels.extend([2.0, 3.0]);
        } else if self.family == Family::Sam1 {
            points.push([0.0, 0.0]);
            labels.push(-1.0);
        }
        let n = labels.len();
        Ok(vec![
            ("point_coords", Tensor::new(&[1, n, 2], points.into_flattened())?),
            ("point_labels", Tensor::new(&[1, n], labels)?),
        ])
    }

    /// Points and boxes apart; an export without boxes cannot be given one.
    fn transformers_prompt(&self, prompt: &Prompt) -> Result<Vec<(&'static str, Tensor)>> {
        let (points, labels) = self.listed(prompt);
        let n = labels.len();
        let mut out = vec![
            ("input_points", Tensor::new(&[1, 1, n, 2], points.into_flattened())?),
            ("input_labels", Tensor::new(&[1, 1, n], labels)?),
        ];
        let corners: Vec<f32> = prompt.bounds.map_or(vec![], |[a, b, c, d]| {
            [self.fit.to_frame([a, b]), self.fit.to_frame([c, d])].as_flattened().to_vec()
        });
        if self.has("input_boxes") {
            out.push(("input_boxes", Tensor::new(&[1, corners.len() / 4, 4], corners)?));
        } else if !corners.is_empty() {
            return Err(Error::usage("--box")
                .expected("a mask network whose decoder takes boxes")
                .found("an export with points only")
                .advice("Use --point, or import an export with the input `input_boxes`."));
        }
        Ok(out)
    }

    fn listed(&self, prompt: &Prompt) -> (Vec<[f32; 2]>, Vec<f32>) {
        let on = prompt.points.iter().map(|p| (self.fit.to_frame(*p), 1.0));
        let off = prompt.not.iter().map(|p| (self.fit.to_frame(*p), 0.0));
        on.chain(off).unzip()
    }

    /// Low-resolution logits over the whole frame, whatever the export gives.
    fn candidates(&self, outputs: &[(String, Tensor)]) -> Result<Vec<Candidate>> {
        let get = |names: [&str; 3]| {
            names.iter().find_map(|n| outputs.iter().find(|(name, _)| name == n)).map(|(_, t)| t).ok_or_else(|| {
                Error::environment("the mask network's decoder")
                    .expected(format!("an output named {}", names.join(" or ")))
                    .found(outputs.iter().map(|(n, _)| n.as_str()).collect::<Vec<_>>().join(", "))
            })
        };
        let scores = get(["iou_predictions", "iou_scores", "iou_predictions"])?;
        let masks = get(["low_res_masks", "pred_masks", "masks"])?;
        let (&[.., count, h, w], n) = (masks.shape.as_slice(), scores.data.len()) else {
            return Err(Error::environment("the mask network's decoder").expected("planes of logits"));
        };
        if count != n || n * h * w == 0 || masks.data.len() != n * h * w || !masks.data.iter().all(|v| v.is_finite()) {
            return Err(Error::environment("the mask network's decoder")
                .expected("a finite plane of logits a score")
                .found(format!("masks {:?}, scores {:?}", masks.shape, scores.shape)));
        }
        let planes = masks.data.chunks_exact(h * w).zip(&scores.data);
        Ok(planes
            .map(|(data, &score)| {
                let plane = Plane { width: w, height: h, data: data.to_vec() };
                Candidate { logits: self.low(plane), score }
            })
            .collect())
    }

    /// Exports that give masks of the photo's size give them without the frame's padding.
    fn low(&self, plane: Plane) -> Plane {
        if (plane.width, plane.height) == (LOW, LOW) {
            return plane;
        }
        let whole = Rect {
            x: 0.0,
            y: 0.0,
            width: plane.width as f32 * FRAME as f32 / self.fit.covered[0],
            height: plane.height as f32 * FRAME as f32 / self.fit.covered[1],
        };
        sample_plane(&plane, whole, LOW, LOW, Edge::Clamp)
    }
}
