//! The sampler: noise to six views, the photo's own features at hand in every attention.

use image::{Rgb, RgbImage};

use super::condition::{self, Condition, LATENT};
use super::{Prompt, scheduler};
use crate::models::registry::Role;
use crate::models::registry::family::{CONTROLS, REFERENCES, control_name, reference_name};
use crate::models::{Graph, Port, Tensor, take};
use crate::progress::Progress;
use crate::splat::train::random::Random;
use crate::{Error, Result};

/// Pixels of the tile: two views across, three down.
pub const TILE: (u32, u32) = (640, 960);
/// Of the latents that become the tile.
const SAMPLE: [usize; 4] = [1, 4, 120, 80];
/// The VAE's factor, and how Zero123++ shifts and scales around it.
const VAE_FACTOR: f32 = 0.18215;

/// What decides a tile, besides the picture and the weights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// 28 for objects in general, 75 for faces and fine detail.
    pub steps: usize,
    pub guidance: f32,
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { steps: 28, guidance: 4.0, seed: 0 }
    }
}

/// Six views on grey, 640 × 960, of the subject in a square picture on grey (127); or, led by such a tile, the normals of its
/// views as [`crate::views::tile::normals`] reads them: the same sampler, with the ControlNet beside the UNet.
///
/// `open` loads a graph when its turn comes; each is gone before the next, but the ControlNet, which stands beside the reading half of
/// the UNet. What the writing half says does not depend on the views: it is asked for several steps ahead, so that the two
/// halves are never loaded together.
///
/// # Errors
/// Environment for a graph that does not do what its contract says, `Cancelled`.
pub fn six_views(
    picture: &RgbImage,
    led_by: Option<&RgbImage>,
    prompt: &Prompt,
    open: &mut dyn FnMut(Role) -> Result<Box<dyn Graph>>,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<RgbImage> {
    // Drawn in a fixed order: the same seed, the same noise.
    let mut random = Random::new(settings.seed);
    let with = condition::embedding(picture, prompt, &*open(Role::ClipVision)?)?;
    let without = Tensor::new(&with.shape, prompt.empty.clone())?;
    progress.check()?;
    let (seen, grey) = {
        let encoder = open(Role::VaeEncoder)?;
        (condition::latents(picture, &*encoder, &mut random)?, condition::grey_latents(&*encoder, &mut random)?)
    };
    progress.check()?;
    let led_by = led_by.map(condition::between_ones).transpose()?;
    let branches = [Condition { text: without, latents: grey }, Condition { text: with, latents: seen }];
    let latents = denoise(open, led_by.as_ref(), &branches, settings, &mut random, progress)?;
    let decoder = open(Role::VaeDecoder)?;
    decode(latents, &*decoder)
}

/// Steps that the writing half of the UNet is ahead of the reading one at most. What it says fills 92 MB a step.
const STEPS_AHEAD: usize = 16;
/// What both branches of a step count in the progress, written and read: 0.8 and 2.6 TFLOP each.
const SHARES: [u64; 2] = [1, 3];

/// One step, all of its noise drawn.
struct Step {
    timestep: Tensor,
    sigma: f32,
    next: f32,
    /// Both branches' latents of the photo, as noisy as the sample.
    conditions: [Tensor; 2],
    noise: Vec<f32>,
}

/// Inputs of the UNet by name.
type Features = Vec<(String, Tensor)>;

/// The writing half of the UNet: the photo's noisy latents → the inputs of its sixteen self-attentions.
fn written(write: &dyn Graph, condition: &Tensor, text: &Tensor, timestep: &Tensor) -> Result<Features> {
    let written = write.run(&[("cond_sample", condition), ("timestep", timestep), ("encoder_hidden_states", text)])?;
    match (0..REFERENCES.len()).map(reference_name).find(|name| !written.iter().any(|(n, _)| n == name)) {
        Some(name) => {
            Err(Error::environment("the UNet's writing half").expected(format!("an output {name}")).found("none"))
        }
        None => Ok(written),
    }
}

/// The reading half of the UNet, with the ControlNet where there is one.
struct Reading<'a> {
    /// Noisy tile and what was written → v.
    read: Box<dyn Graph>,
    control: Option<Control<'a>>,
    /// What it adds to its own features where no ControlNet says more; none where it takes nothing.
    nothing: Features,
}

/// A second network beside the UNet's way down that looks at a picture.
struct Control<'a> {
    /// Noisy tile and picture → what is added to the UNet's features.
    graph: Box<dyn Graph>,
    /// [1, 3, 960, 640], −1 to 1.
    picture: &'a Tensor,
}

impl Control<'_> {
    fn added(&self, sample: &Tensor, text: &Tensor, timestep: &Tensor) -> Result<Features> {
        self.graph.run(&[
            ("sample", sample),
            ("timestep", timestep),
            ("encoder_hidden_states", text),
            ("control", self.picture),
        ])
    }
}

impl<'a> Reading<'a> {
    fn new(read: Box<dyn Graph>, control: Option<Control<'a>>) -> Result<Reading<'a>> {
        let takes_control = read.inputs().iter().any(|p| p.name == control_name(0));
        let zeros = |(i, [c, h, w]): (usize, [usize; 3])| {
            Ok((control_name(i), Tensor::new(&[1, c, h, w], vec![0.0; c * h * w])?))
        };
        let nothing = match takes_control && control.is_none() {
            true => CONTROLS.into_iter().enumerate().map(zeros).collect::<Result<_>>()?,
            false => Vec::new(),
        };
        Ok(Reading { read, control, nothing })
    }

    /// v of one branch.
    fn v(&self, sample: &Tensor, references: &Features, text: &Tensor, timestep: &Tensor) -> Result<Vec<f32>> {
        let led = match &self.control {
            Some(control) => control.added(sample, text, timestep)?,
            None => Vec::new(),
        };
        let mut fed: Vec<(&str, &Tensor)> =
            vec![("sample", sample), ("timestep", timestep), ("encoder_hidden_states", text)];
        fed.extend(references.iter().chain(&led).chain(&self.nothing).map(|(n, t)| (n.as_str(), t)));
        let mut out = self.read.run(&fed)?;
        take(&mut out, "v_prediction", SAMPLE.iter().product())
    }
}

/// Branches: without the photo, with it.
fn denoise(
    open: &mut dyn FnMut(Role) -> Result<Box<dyn Graph>>,
    led_by: Option<&Tensor>,
    branches: &[Condition; 2],
    settings: &Settings,
    random: &mut Random,
    progress: &dyn Progress,
) -> Result<Vec<f32>> {
    let schedule = scheduler::Schedule::new(settings.steps);
    let count: usize = SAMPLE.iter().product();
    let mut x: Vec<f32> = (0..count).map(|_| schedule.first_sigma() * random.normal()).collect();
    // The noise of a step's conditions comes before its own.
    let mut step = |(&time, sigmas): (&f32, &[f32])| {
        let [sigma, next] = [sigmas[0], sigmas[1]];
        let mut condition = |branch: &Condition| {
            let noise: Vec<f32> = branch.latents.iter().map(|_| random.normal()).collect();
            Tensor::new(&LATENT, scheduler::noised(&branch.latents, &noise, sigma))
        };
        let conditions = [condition(&branches[0])?, condition(&branches[1])?];
        let noise = (0..count).map(|_| random.normal()).collect();
        Ok(Step { timestep: Tensor::new(&[1], vec![time])?, sigma, next, conditions, noise })
    };
    let steps: Vec<Step> =
        schedule.timesteps.iter().zip(schedule.sigmas.windows(2)).map(&mut step).collect::<Result<_>>()?;

    let what = if led_by.is_some() { "normals, by diffusion" } else { "six views, by diffusion" };
    progress.begin(what, SHARES.iter().sum::<u64>() * steps.len() as u64);
    let mut done = 0;
    let batches = steps.len().div_ceil(STEPS_AHEAD).max(1);
    for batch in steps.chunks(steps.len().div_ceil(batches).max(1)) {
        let mut references: Vec<[Features; 2]> = Vec::with_capacity(batch.len());
        {
            let write = open(Role::UnetWrite)?;
            for step in batch {
                progress.check()?;
                let of = |i: usize| written(&*write, &step.conditions[i], &branches[i].text, &step.timestep);
                references.push([of(0)?, of(1)?]);
                done += SHARES[0];
                progress.step(done);
            }
        }
        let control = match led_by {
            Some(picture) => Some(Control { graph: open(Role::ControlNet)?, picture }),
            None => None,
        };
        let reading = Reading::new(open(Role::UnetRead)?, control)?;
        for (step, references) in batch.iter().zip(references) {
            let sample = Tensor::new(&SAMPLE, scheduler::scaled(&x, step.sigma))?;
            let mut v = Vec::with_capacity(2);
            for (branch, references) in branches.iter().zip(&references) {
                progress.check()?;
                v.push(reading.v(&sample, references, &branch.text, &step.timestep)?);
            }
            let v = scheduler::guided(&v[0], &v[1], settings.guidance);
            scheduler::step(&mut x, &v, &step.noise, step.sigma, step.next);
            done += SHARES[1];
            progress.step(done);
        }
    }
    Ok(x)
}

/// The VAE's output is in the picture scale of Zero123++: ×0.8 / 0.5, then to 0..1.
fn decode(latents: Vec<f32>, decoder: &dyn Graph) -> Result<RgbImage> {
    let scaled = latents.into_iter().map(|v| (v / 0.75 + 0.22) / VAE_FACTOR).collect();
    let name = decoder.inputs().first().map_or("latent_sample".to_owned(), |p: &Port| p.name.clone());
    let mut out = decoder.run(&[(name.as_str(), &Tensor::new(&SAMPLE, scaled)?)])?;
    let pixels = (TILE.0 * TILE.1) as usize;
    let data = take(&mut out, "sample", 3 * pixels)?;
    Ok(RgbImage::from_fn(TILE.0, TILE.1, |x, y| {
        let i = (y * TILE.0 + x) as usize;
        Rgb(std::array::from_fn(|c| {
            let v = data[c * pixels + i] * 0.8 / 0.5 / 2.0 + 0.5;
            (v.clamp(0.0, 1.0) * 255.0).round() as u8
        }))
    }))
}

#[cfg(test)]
mod tests {
    use std::sync::{Arc, Mutex};

    use super::*;
    use crate::models::registry::tests::stub;
    use crate::models::{Engine as _, Rten};
    use crate::progress::Silent;

    fn open(role: Role) -> Result<Box<dyn Graph>> {
        Rten.load_file(&stub(&format!("{}.onnx", role.name())))
    }

    fn prompt() -> Prompt {
        Prompt { empty: vec![0.1; 77 * 1024], ramp: (0..77).map(|i| i as f32 / 77.0).collect() }
    }

    fn picture() -> RgbImage {
        RgbImage::from_fn(320, 320, |x, y| Rgb([x as u8, y as u8, 60]))
    }

    #[test]
    fn the_stubs_make_a_tile_the_same_for_the_same_seed() {
        let settings = Settings { steps: 3, ..Settings::default() };
        let tile = |seed| {
            let settings = Settings { seed, ..settings };
            six_views(&picture(), None, &prompt(), &mut open, &settings, &Silent).unwrap()
        };
        let first = tile(7);
        assert_eq!(first.dimensions(), TILE);
        assert!(first == tile(7) && first != tile(8));
    }

    /// v = sample / 2 + 0.001 · (mean text + time + Σ mean refs), as the reading stub computes; refs carry what was written.
    #[derive(Default)]
    struct Listening(Mutex<Vec<(f32, f32, f32)>>);
    impl Graph for Arc<Listening> {
        fn inputs(&self) -> Vec<Port> {
            vec![]
        }
        fn outputs(&self) -> Vec<Port> {
            vec![]
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            let get = |name: &str| inputs.iter().find(|(n, _)| *n == name).unwrap().1;
            let references = inputs.iter().filter(|(n, _)| n.starts_with("ref_")).count();
            assert_eq!((references, get("sample").shape.as_slice()), (16, &SAMPLE[..]));
            let (time, text, reference) =
                (get("timestep").data[0], get("encoder_hidden_states").data[0], get("ref_15").data[0]);
            self.0.lock().unwrap().push((time, text, reference));
            // The branch with the photo (text 2) says 1, the one without says 0.25.
            let v = if text == 2.0 { 1.0 } else { 0.25 };
            Ok(vec![("v_prediction".into(), Tensor::new(&SAMPLE, vec![v; SAMPLE.iter().product()])?)])
        }
    }

    /// Gives the first number of its latents as every reference.
    struct Writing;
    impl Graph for Writing {
        fn inputs(&self) -> Vec<Port> {
            vec![]
        }
        fn outputs(&self) -> Vec<Port> {
            vec![]
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            let value = inputs[0].1.data[0];
            assert_eq!((inputs[0].0, inputs[0].1.shape.as_slice()), ("cond_sample", &LATENT[..]));
            (0..16).map(|i| Ok((reference_name(i), Tensor::new(&[1, 1, 1], vec![value])?))).collect()
        }
    }

    /// With the same noise and guidance 3 between those two: v = 0.25 + 3 · 0.75 = 2.5 everywhere.
    fn by_hand(steps: usize, seed: u64) -> Vec<f32> {
        let mut random = Random::new(seed);
        let total: usize = SAMPLE.iter().product();
        let schedule = scheduler::Schedule::new(steps);
        let mut x: Vec<f32> = (0..total).map(|_| schedule.first_sigma() * random.normal()).collect();
        for s in schedule.sigmas.windows(2) {
            for _ in 0..2 * LATENT.iter().product::<usize>() {
                random.normal();
            }
            let noise: Vec<f32> = (0..total).map(|_| random.normal()).collect();
            scheduler::step(&mut x, &vec![2.5; total], &noise, s[0], s[1]);
        }
        x
    }

    #[test]
    fn both_branches_read_their_own_references_and_guidance_mixes_them() {
        let reading = Arc::new(Listening::default());
        let mut open = |role| -> Result<Box<dyn Graph>> {
            Ok(if role == Role::UnetWrite { Box::new(Writing) } else { Box::new(reading.clone()) })
        };
        let count: usize = LATENT.iter().product();
        let branch = |text: f32, latent: f32| Condition {
            text: Tensor::new(&[1, 1, 1], vec![text]).unwrap(),
            latents: vec![latent; count],
        };
        let settings = Settings { steps: 2, guidance: 3.0, seed: 5 };
        let made =
            denoise(&mut open, None, &[branch(1.0, 0.0), branch(2.0, 100.0)], &settings, &mut Random::new(5), &Silent)
                .unwrap();
        let seen = reading.0.lock().unwrap();
        let order: Vec<(f32, f32)> = seen.iter().map(|s| (s.0, s.1)).collect();
        assert_eq!(order, [(999.0, 1.0), (999.0, 2.0), (499.0, 1.0), (499.0, 2.0)]);
        // At the least noise the condition shines through: 100 against 0, both with noise of deviation < 1.
        assert!(seen[3].2 > 10.0 && seen[2].2.abs() < 5.0, "{seen:?}");
        assert!(made == by_hand(2, 5));
    }

    /// The stubs: v = … + 0.01 · Σ mean control_i, and each of the thirteen controls carries the mean of its picture.
    #[test]
    fn normals_are_led_by_the_colours_and_colours_by_nothing() {
        let controlled = |role| match role {
            Role::UnetRead => Rten.load_file(&stub("unet_read_controlled.onnx")),
            other => open(other),
        };
        let time = Tensor::new(&[1], vec![3.0]).unwrap();
        let text = Tensor::new(&[1, 77, 1024], vec![0.0; 77 * 1024]).unwrap();
        let v = |control: Option<u8>| {
            let picture = |level| condition::between_ones(&RgbImage::from_pixel(TILE.0, TILE.1, Rgb([level; 3])));
            let picture = control.map(|l| picture(l).unwrap());
            let control = picture.as_ref().map(|p| Control { graph: open(Role::ControlNet).unwrap(), picture: p });
            let reading = Reading::new(controlled(Role::UnetRead).unwrap(), control).unwrap();
            let sample = Tensor::new(&SAMPLE, vec![0.0; SAMPLE.iter().product()]).unwrap();
            let condition = Tensor::new(&LATENT, vec![0.0; LATENT.iter().product()]).unwrap();
            let references = written(&*controlled(Role::UnetWrite).unwrap(), &condition, &text, &time).unwrap();
            reading.v(&sample, &references, &text, &time).unwrap()[0]
        };
        let plain = v(None);
        // 0.001 · the time, once read and sixteen times written with nothing.
        assert!((plain - 0.003).abs() < 1e-5, "{plain}");
        for (level, mean) in [(255, 1.0), (0, -1.0)] {
            let led = v(Some(level));
            assert!((led - plain - 0.13 * mean).abs() < 1e-4, "{level}: {led} beside {plain}");
        }

        let settings = Settings { steps: 2, ..Settings::default() };
        let tile = six_views(&picture(), None, &prompt(), &mut { controlled }, &settings, &Silent).unwrap();
        assert!(
            tile == six_views(&picture(), None, &prompt(), &mut open, &settings, &Silent).unwrap(),
            "zeros change nothing"
        );
        let normals = |tile: &RgbImage| {
            six_views(&picture(), Some(tile), &prompt(), &mut { controlled }, &settings, &Silent).unwrap()
        };
        let white = RgbImage::from_pixel(TILE.0, TILE.1, Rgb([255; 3]));
        assert!(normals(&tile) != tile && normals(&tile) != normals(&white) && normals(&white) == normals(&white));
    }

    /// What `open` gave and what of it is still held.
    #[derive(Default)]
    struct Held {
        opened: Vec<Role>,
        now: Vec<Role>,
    }

    /// A graph that takes itself off the list when it goes.
    struct Watched(Role, Box<dyn Graph>, Arc<Mutex<Held>>);
    impl Graph for Watched {
        fn inputs(&self) -> Vec<Port> {
            self.1.inputs()
        }
        fn outputs(&self) -> Vec<Port> {
            self.1.outputs()
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            self.1.run(inputs)
        }
    }
    impl Drop for Watched {
        fn drop(&mut self) {
            self.2.lock().unwrap().now.retain(|role| *role != self.0);
        }
    }

    #[test]
    fn one_graph_is_held_at_a_time_and_the_result_does_not_tell() {
        let held = Arc::new(Mutex::new(Held::default()));
        let reading = Arc::new(Listening::default());
        let mut open = |role| -> Result<Box<dyn Graph>> {
            let mut list = held.lock().unwrap();
            assert!(list.now.is_empty(), "{:?} beside {role:?}", list.now);
            list.opened.push(role);
            list.now.push(role);
            let graph: Box<dyn Graph> =
                if role == Role::UnetWrite { Box::new(Writing) } else { Box::new(reading.clone()) };
            Ok(Box::new(Watched(role, graph, held.clone())))
        };
        let steps = STEPS_AHEAD + 1;
        let branch = |text: f32| Condition {
            text: Tensor::new(&[1, 1, 1], vec![text]).unwrap(),
            latents: vec![0.0; LATENT.iter().product()],
        };
        let settings = Settings { steps, guidance: 3.0, seed: 5 };
        let branches = [branch(1.0), branch(2.0)];
        let made = denoise(&mut open, None, &branches, &settings, &mut Random::new(5), &Silent).unwrap();
        assert_eq!(held.lock().unwrap().opened, [Role::UnetWrite, Role::UnetRead, Role::UnetWrite, Role::UnetRead]);
        assert!(made == by_hand(steps, 5));
        // What each step reads is what was written for it: noise of its own, at its own level.
        let mut random = Random::new(5);
        let schedule = scheduler::Schedule::new(steps);
        let mut draw = |count: usize| (0..count).map(|_| random.normal()).collect::<Vec<f32>>();
        draw(SAMPLE.iter().product());
        let seen = reading.0.lock().unwrap();
        for (i, sigma) in schedule.sigmas[..steps].iter().enumerate() {
            for branch in 0..2 {
                let noise = draw(LATENT.iter().product());
                assert_eq!(seen[2 * i + branch].2, scheduler::noised(&[0.0], &noise[..1], *sigma)[0], "step {i}");
            }
            draw(SAMPLE.iter().product());
        }
    }

    #[test]
    fn latents_and_pictures_are_scaled_both_ways() {
        // 0.75 · (0.18215 · z − 0.22) comes out as z, and z as z · 0.8 + 0.5.
        struct Same;
        impl Graph for Same {
            fn inputs(&self) -> Vec<Port> {
                vec![Port::any("latent_sample")]
            }
            fn outputs(&self) -> Vec<Port> {
                vec![]
            }
            fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
                let z = inputs[0].1.data[0];
                assert!((z - 0.3).abs() < 1e-5, "{z}");
                Ok(vec![("sample".into(), Tensor::new(&[1, 3, 960, 640], vec![z; 3 * 960 * 640])?)])
            }
        }
        let tile = decode(vec![0.75 * (VAE_FACTOR * 0.3 - 0.22); SAMPLE.iter().product()], &Same).unwrap();
        assert_eq!(tile.get_pixel(639, 959).0, [(0.74f32 * 255.0).round() as u8; 3]);
    }
}
