//! What the sampler is told about the photo: CLIP's embedding in the prompt, the VAE's latents in the attention.

use image::RgbImage;

use super::Prompt;
use super::prompt::{TOKENS, WIDTH};
use crate::models::picture::{self, Normalise};
use crate::models::{Graph, Port, Tensor, take};
use crate::photo::{Edge, Rect, sample_colour};
use crate::splat::train::random::Random;
use crate::{Error, Result};

/// Of the photo's latents.
pub const LATENT: [usize; 4] = [1, 4, 64, 64];
/// Side of the VAE's picture.
const VAE_SIDE: usize = 512;
/// Side of CLIP's picture.
const CLIP_SIDE: usize = 224;
/// (x − 0.5) / 0.8: Zero123++ shows its VAE less contrast than Stable Diffusion does.
const VAE: Normalise = Normalise { mean: [0.5; 3], deviation: [0.8; 3] };

/// (x − 0.5) / 0.5: as the ControlNet sees its picture.
const CONTROL: Normalise = Normalise { mean: [0.5; 3], deviation: [0.5; 3] };

/// One branch of the guidance.
pub struct Condition {
    /// 1 × 77 × 1024.
    pub text: Tensor,
    /// 4 × 64 × 64, without noise.
    pub latents: Vec<f32>,
}

fn resized(picture: &RgbImage, side: usize) -> Vec<[f32; 3]> {
    let whole = Rect { x: 0.0, y: 0.0, width: picture.width() as f32, height: picture.height() as f32 };
    sample_colour(picture, whole, side, side, Edge::Clamp)
}

fn first_input(graph: &dyn Graph, usual: &str) -> String {
    graph.inputs().first().map_or(usual.to_owned(), |p: &Port| p.name.clone())
}

/// The prompt of the branch with the photo: what the text encoder says to "", plus CLIP's embedding of the picture times the
/// ramp, token by token.
pub fn embedding(picture: &RgbImage, prompt: &Prompt, clip: &dyn Graph) -> Result<Tensor> {
    let side = [CLIP_SIDE; 2];
    let image = picture::planes(&resized(picture, CLIP_SIDE), side, side, picture::CLIP)?;
    let mut out = clip.run(&[(first_input(clip, "pixel_values").as_str(), &image)])?;
    let embeds = take(&mut out, "image_embeds", WIDTH)?;
    let mut text = prompt.empty.clone();
    for (token, ramp) in text.chunks_exact_mut(WIDTH).zip(&prompt.ramp) {
        token.iter_mut().zip(&embeds).for_each(|(t, e)| *t += ramp * e);
    }
    Tensor::new(&[1, TOKENS, WIDTH], text)
}

/// A picture of its own size, −1 to 1, colour by colour.
pub fn between_ones(picture: &RgbImage) -> Result<Tensor> {
    let pixels: Vec<[f32; 3]> = picture.pixels().map(|p| p.0.map(|v| f32::from(v) / 255.0)).collect();
    let size = [picture.width() as usize, picture.height() as usize];
    picture::planes(&pixels, size, size, CONTROL)
}

/// A sample of the VAE's distribution over the picture's latents; no factor of 0.18215 here.
pub fn latents(picture: &RgbImage, vae: &dyn Graph, random: &mut Random) -> Result<Vec<f32>> {
    let side = [VAE_SIDE; 2];
    sampled(&picture::planes(&resized(picture, VAE_SIDE), side, side, VAE)?, vae, random)
}

/// The same of nothing to see: zeros, mid-grey.
pub fn grey_latents(vae: &dyn Graph, random: &mut Random) -> Result<Vec<f32>> {
    sampled(&Tensor::new(&[1, 3, VAE_SIDE, VAE_SIDE], vec![0.0; 3 * VAE_SIDE * VAE_SIDE])?, vae, random)
}

/// mean + exp(log variance / 2) · noise, the log variance held to −30..20.
fn sampled(image: &Tensor, vae: &dyn Graph, random: &mut Random) -> Result<Vec<f32>> {
    let count: usize = LATENT.iter().product();
    let mut out = vae.run(&[(first_input(vae, "sample").as_str(), image)])?;
    let parameters = take(&mut out, "latent_parameters", 2 * count)?;
    let (mean, variance) = parameters.split_at_checked(count).ok_or_else(|| Error::environment("VAE"))?;
    let deviation = |v: &f32| (v.clamp(-30.0, 20.0) / 2.0).exp();
    Ok(mean.iter().zip(variance).map(|(m, v)| m + deviation(v) * random.normal()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gives what it is made with; checks the picture's middle.
    struct Fixed(&'static str, Vec<f32>, [f32; 3]);
    impl Graph for Fixed {
        fn inputs(&self) -> Vec<Port> {
            vec![Port::any("picture")]
        }
        fn outputs(&self) -> Vec<Port> {
            vec![]
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            let t = inputs[0].1;
            let plane = t.shape[2] * t.shape[3];
            for c in 0..3 {
                let v = t.data[c * plane + plane / 2 + t.shape[3] / 2];
                assert!((v - self.2[c]).abs() < 1e-3, "{c}: {v}");
            }
            Ok(vec![(self.0.into(), Tensor::new(&[self.1.len()], self.1.clone())?)])
        }
    }

    fn orange() -> RgbImage {
        RgbImage::from_pixel(400, 400, image::Rgb([255, 102, 0]))
    }

    #[test]
    fn the_embedding_is_added_by_the_ramp() {
        let prompt = Prompt { empty: vec![0.5; TOKENS * WIDTH], ramp: (0..TOKENS).map(|i| i as f32).collect() };
        let seen = [(1.0 - 0.48145) / 0.26863, (0.4 - 0.45783) / 0.26130, -0.40821 / 0.27578];
        let clip = Fixed("image_embeds", (0..WIDTH).map(|i| i as f32).collect(), seen);
        let text = embedding(&orange(), &prompt, &clip).unwrap();
        assert_eq!(text.shape, [1, 77, 1024]);
        for (token, i) in [(0, 5), (3, 7), (76, 1023)] {
            assert_eq!(text.data[token * WIDTH + i], 0.5 + (token * i) as f32);
        }
    }

    #[test]
    fn latents_are_drawn_around_their_mean() {
        let n: usize = LATENT.iter().product();
        // Deviation 2 in the upper half of the channels' parameters.
        let parameters: Vec<f32> = (0..2 * n).map(|i| if i < n { 3.0 } else { 4f32.ln() }).collect();
        let vae = Fixed("latent_parameters", parameters, [0.625, -0.125, -0.625]);
        let drawn = latents(&orange(), &vae, &mut Random::new(1)).unwrap();
        let mean = drawn.iter().sum::<f32>() / n as f32;
        let deviation = (drawn.iter().map(|v| (v - mean).powi(2)).sum::<f32>() / n as f32).sqrt();
        assert!((mean - 3.0).abs() < 0.06 && (deviation - 2.0).abs() < 0.06, "{mean} {deviation}");
        let still: Vec<f32> = (0..2 * n).map(|i| if i < n { 1.5 } else { -99.0 }).collect();
        let grey = Fixed("latent_parameters", still, [0.0; 3]);
        assert!(grey_latents(&grey, &mut Random::new(1)).unwrap().iter().all(|v| (v - 1.5).abs() < 1e-5));
    }
}
