//! What a run takes, said before it begins: memory, time, disk, from the number of photos, their size, the Gaussians, the
//! steps and the blocks. What is assumed is named here; nothing is asked of a machine but its speed.

mod meshes;

use super::blocks::coarse_side;
use super::cost::{Cost, gib};
use crate::Result;
use crate::progress::Silent;
use crate::splat::render::Shown;
use crate::splat::train::random::Random;
use crate::splat::{self, Camera, Engine, Gaussians, Target};
use glam::Vec3;

pub use meshes::{Meshes, ground as ground_seen};

/// What is to be done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Job {
    pub photos: usize,
    /// Of one photo in training, and as its file has it; means.
    pub pixels: f64,
    pub file_pixels: f64,
    /// The longer side of a photo in training.
    pub longest_side: u32,
    /// At most, in one training.
    pub gaussians: usize,
    /// Of each training: one, or the coarse one and one a block.
    pub steps: usize,
    /// Of the two trainings together by which it is tried whether photos alone can refine poses; 0 where nothing is tried.
    pub trial_steps: usize,
    /// 1: the scene as a whole.
    pub blocks: usize,
    pub on_gpu: bool,
    /// Where a CDB store is made: models in it at most.
    pub store_models: Option<usize>,
    /// Where meshes of the whole scene are made.
    pub meshes: Option<Meshes>,
}

/// Seconds of this machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speed {
    /// Of one step of training: always, for every pixel of the photo, for every Gaussian.
    pub step: f64,
    pub pixel: f64,
    pub gaussian: f64,
    /// For every pixel of a file that is read.
    pub read: f64,
    /// Threads that work at once.
    pub cores: usize,
}

/// A block's photos: so many times what its part of the ground has of them (assumed: an oblique photo shows several cells).
const SHOWN_IN: f64 = 4.0;
/// The mean number of Gaussians over a training that grows, of those at its end (assumed).
const MEAN: f64 = 0.8;
/// Drawing a photo to measure it, of a step's time for its pixels and Gaussians (assumed).
const DRAWN: f64 = 0.4;
/// Seconds to read and straighten a pixel of a file: measured, 40 PNG files of 800 × 600 in 0.69 s.
const READ: f64 = 3.6e-8;
/// Bytes of one Gaussian: in a checkpoint (the numbers and two moments of each), in a part, in scene.ply and scene.spz.
const CHECKPOINT: u64 = 780;
const PART: u64 = 256;
const PUBLISHED: u64 = 248 + 20;

/// A CDB store at most: tiles of the finest level, a third of them for the levels above and one for each above those, of terrain
/// (measured: 4.2 MB each, as they are not compressed) and of imagery (measured: up to 0.1 MB, assumed: 1 MB, as photos have
/// more in them).
const STORE_TILES: u64 = 36 * 4 / 3 + 20;
const STORE_TILE: u64 = 4_200_000 + 1_000_000;
/// Memory of a tile while it is made, and of what is written.
const STORE_TILE_MADE: u64 = 12 << 20;
/// Bytes of a model in it (measured: 10 MB for three), and seconds: of a model, and of a tile (measured on two cores: three
/// models and 46 tiles in 8 s).
const STORE_MODEL: u64 = 3_400_000;
const STORE_SECONDS: [f64; 2] = [2.0, 0.05];

/// What it takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Trainings one after another.
    pub trainings: usize,
    /// Photos in memory at a time.
    pub photos_at_a_time: usize,
    /// Bytes.
    pub memory: u64,
    pub gpu_memory: u64,
    pub disk: u64,
    pub seconds: f64,
    /// Of a block, where the scene is cut.
    pub seconds_of_a_block: f64,
    /// Of a trial of poses.
    pub seconds_of_a_trial: f64,
    /// At the end, at most.
    pub gaussians: usize,
    /// Of the disk, at most: the CDB store's, the meshes'.
    pub store: u64,
    pub meshes: u64,
    /// Tiles of the finest level of them.
    pub tiles: usize,
}

/// What a job takes at a speed.
pub fn plan(job: &Job, speed: &Speed) -> Plan {
    let plan = with_store(job, trained(job, speed));
    let Some(meshes) = &job.meshes else { return plan };
    let taken = meshes.taken(job.photos, job.pixels, plan.gaussians, plan.memory, speed);
    // One after the other.
    Plan {
        memory: plan.memory.max(taken.memory),
        disk: plan.disk + taken.disk,
        seconds: plan.seconds + taken.seconds,
        meshes: taken.disk,
        tiles: taken.tiles,
        ..plan
    }
}

fn with_store(job: &Job, plan: Plan) -> Plan {
    let Some(models) = job.store_models else { return plan };
    let store = STORE_TILES * STORE_TILE + models as u64 * STORE_MODEL;
    // After the training, whose photos are gone; the store is written from memory.
    let after = plan.gaussians as u64 * 3 * PART + STORE_TILES * STORE_TILE_MADE + store;
    Plan {
        memory: plan.memory.max(after),
        disk: plan.disk + store,
        seconds: plan.seconds + models as f64 * STORE_SECONDS[0] + 2.0 * STORE_TILES as f64 * STORE_SECONDS[1],
        store,
        ..plan
    }
}

/// Without a store and meshes.
fn trained(job: &Job, speed: &Speed) -> Plan {
    let blocks = job.blocks.max(1);
    let cost = |photos: f64, pixels: f64| Cost {
        photos: photos as usize,
        pixels: (photos * pixels) as u64,
        on_gpu: job.on_gpu,
        free: None,
    };
    let bytes = |c: &Cost, g: usize| c.of_photos() + c.of_gaussians(g);
    let step = |pixels: f64, g: f64| speed.step + speed.pixel * pixels + speed.gaussian * MEAN * g;
    let (n, g) = (job.photos as f64, job.gaussians as f64);
    let (steps, read) = (job.steps as f64, speed.read * job.file_pixels);
    let measuring = |g: f64| n * (read + DRAWN * (speed.pixel * job.pixels + speed.gaussian * g));
    if blocks == 1 {
        // Both trainings of a trial are measured before and after; files are read once for all.
        let trial = match job.trial_steps {
            0 => 0.0,
            steps => steps as f64 * step(job.pixels, g) + 4.0 * (measuring(g) - n * read),
        };
        let c = cost(n, job.pixels);
        return Plan {
            trainings: 1,
            photos_at_a_time: job.photos,
            memory: bytes(&c, job.gaussians),
            gpu_memory: c.on_the_gpu(job.gaussians),
            disk: job.gaussians as u64 * PUBLISHED,
            seconds: n * read + trial + steps * step(job.pixels, g) + measuring(g),
            seconds_of_a_block: 0.0,
            seconds_of_a_trial: trial,
            gaussians: job.gaussians,
            store: 0,
            meshes: 0,
            tiles: 0,
        };
    }
    let shrink = f64::from(coarse_side(job.longest_side, blocks)) / f64::from(job.longest_side.max(1));
    let coarse_pixels = job.pixels * shrink * shrink;
    let own = (n * SHOWN_IN / blocks as f64).min(n).max(n.min(2.0)).ceil();
    let (coarse, block) = (cost(n, coarse_pixels), cost(own, job.pixels));
    // The coarse scene has half; what is outside a block's cell stays as it was there.
    let half = job.gaussians / 2;
    let outside = (half as f64 * (SHOWN_IN - 1.0).min(blocks as f64 - 1.0) / blocks as f64) as usize;
    let end = half.max((job.gaussians - outside.min(job.gaussians)) * blocks);
    let seconds_of_a_block = own * read + steps * step(job.pixels, g);
    let coarse_seconds = n * read + steps * step(coarse_pixels, g / 2.0);
    let held = end as u64 * 256;
    Plan {
        trainings: blocks + 1,
        photos_at_a_time: own as usize,
        memory: bytes(&coarse, half).max(bytes(&block, job.gaussians)).max(2 * held),
        gpu_memory: coarse.on_the_gpu(half).max(block.on_the_gpu(job.gaussians)),
        disk: end as u64 * (PUBLISHED + PART) + half as u64 * PART + job.gaussians as u64 * CHECKPOINT,
        seconds: coarse_seconds + blocks as f64 * seconds_of_a_block + measuring(end as f64),
        seconds_of_a_block,
        seconds_of_a_trial: 0.0,
        gaussians: end,
        store: 0,
        meshes: 0,
        tiles: 0,
    }
}

/// The fewest blocks with which a job fits so much memory; `None` where none do: the coarse scene's photos alone are too many.
pub fn blocks_within(job: &Job, bytes: u64) -> Option<usize> {
    let still = Speed { step: 0.0, pixel: 0.0, gaussian: 0.0, read: 0.0, cores: 1 };
    let fits = |blocks: usize| plan(&Job { blocks, ..*job }, &still).memory <= bytes;
    [1].into_iter().chain((1..14).map(|k| 1usize << k)).find(|b| fits(*b))
}

/// Measures a machine: a few steps on three small scenes of ground.
///
/// # Errors
/// Environment from the GPU.
pub fn speed(engine: Engine) -> Result<Speed> {
    const STEPS: usize = 12;
    let seconds = |side: u32, count: usize| -> Result<f64> {
        let (g, target) = ground(side, count);
        let options = splat::Options { iterations: STEPS, ..splat::Options::scaled(STEPS) };
        let done = splat::train::train(engine, g, &[target], &options, &Silent)?;
        Ok(done.report.seconds.train / STEPS as f64)
    };
    // The first makes what later ones find made.
    seconds(64, 1000)?;
    let (small, wide, full) = (seconds(128, 4000)?, seconds(384, 4000)?, seconds(128, 40_000)?);
    let pixel = ((wide - small) / f64::from(384 * 384 - 128 * 128)).max(1e-10);
    let gaussian = ((full - small) / 36_000.0).max(1e-10);
    let step = (small - pixel * f64::from(128 * 128) - gaussian * 4000.0).max(0.0);
    Ok(Speed { step, pixel, gaussian, read: READ, cores: rayon::current_num_threads() })
}

/// Gaussians on ground side by side, and a picture of it.
fn ground(side: u32, count: usize) -> (Gaussians, Target) {
    let mut random = Random::new(7);
    let mut g = Gaussians::default();
    let wide = (4.0 / count as f32).sqrt();
    for _ in 0..count {
        let mut one = || random.uniform();
        g.positions.push(Vec3::new(2.0 * one() - 1.0, 2.0 * one() - 1.0, 0.2 * one()));
        g.log_scales.push(Vec3::splat((0.6 * wide).ln()));
        g.rotations.push([1.0, 0.0, 0.0, 0.0]);
        g.logit_opacities.push(0.5);
        g.sh.push(super::begin::flat([one(), one(), one()]));
    }
    let camera = Camera::look_at(Vec3::new(0.0, -1.6, 1.0), Vec3::ZERO, 1.0, side);
    let pixels = (side * side) as usize;
    let target = Target {
        camera,
        color: (0..pixels).map(|_| [random.uniform(); 3]).collect(),
        alpha: vec![1.0; pixels],
        weight: 1.0,
        refine_pose: None,
        fit_exposure: false,
        held_back: None,
        confidence: None,
        shown: Shown::Color,
        name: "a probe".into(),
    };
    (g, target)
}

fn time(seconds: f64) -> String {
    match seconds {
        s if s < 120.0 => format!("{s:.0} s"),
        s if s < 7200.0 => format!("{:.0} min", s / 60.0),
        s if s < 172_800.0 => format!("{:.1} h", s / 3600.0),
        s => format!("{:.1} days", s / 86_400.0),
    }
}

impl Plan {
    /// For a person.
    pub fn words(&self, job: &Job) -> String {
        let mut out = format!(
            "{} photos of {:.2} megapixels, {} steps, at most {} Gaussians in memory\n",
            job.photos,
            job.pixels / 1e6,
            job.steps,
            job.gaussians
        );
        let gpu =
            if self.gpu_memory > 0 { format!(", and {} of the GPU's", gib(self.gpu_memory)) } else { String::new() };
        out += &format!("  memory  about {}{gpu}, {} photos at a time\n", gib(self.memory), self.photos_at_a_time);
        out += &format!("  time    about {} on this machine", time(self.seconds));
        if self.seconds_of_a_trial > 0.0 {
            out += &format!(", of it {} at most to try whether poses can be refined", time(self.seconds_of_a_trial));
        }
        if job.blocks > 1 {
            out += &format!(": the coarse scene, then {} blocks of {}", job.blocks, time(self.seconds_of_a_block));
        }
        out += &format!("\n  disk    about {}", gib(self.disk));
        if let Some(models) = job.store_models {
            out += &format!(", of it {} at most for the CDB store with up to {models} models", gib(self.store));
        }
        if job.meshes.is_some() {
            let of_it = if job.store_models.is_some() { " and" } else { ", of it" };
            out += &format!("{of_it} about {} for meshes in {} tiles and coarser ones", gib(self.meshes), self.tiles);
        }
        out.push('\n');
        out + &format!("  result  at most {} Gaussians\n", self.gaussians)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPEED: Speed = Speed { step: 1e-3, pixel: 1e-7, gaussian: 3e-7, read: READ, cores: 2 };

    fn job(photos: usize, blocks: usize) -> Job {
        Job {
            photos,
            pixels: 1600.0 * 1200.0,
            file_pixels: 4000.0 * 3000.0,
            longest_side: 1600,
            gaussians: 1_000_000,
            steps: 30_000,
            trial_steps: 0,
            blocks,
            on_gpu: false,
            store_models: None,
            meshes: None,
        }
    }

    /// What grows with what, up to 10,000 photos.
    #[test]
    fn memory_grows_with_photos_as_a_whole_and_not_in_blocks_that_grow_with_them() {
        let whole = |n| plan(&job(n, 1), &SPEED);
        let cut = |n| plan(&job(n, n / 100), &SPEED);
        let of_photos = |p: Plan| p.memory as f64 - 2600.0 * 1e6;
        // As a whole: memory of the photos in proportion; time grows only by reading and measuring.
        assert!((of_photos(whole(10_000)) / of_photos(whole(1000)) - 10.0).abs() < 0.01);
        assert!(whole(10_000).memory > 600 << 30 && whole(10_000).seconds < 2.0 * whole(1000).seconds);
        // A hundred photos a block: memory hardly grows from 500 to 10,000, time and disk in proportion.
        let (few, many) = (cut(500), cut(10_000));
        assert!(many.memory < 2 * few.memory, "{few:?} {many:?}");
        assert!(many.memory < 64 << 30 && many.photos_at_a_time == 400);
        let ratio = |a: f64, b: f64| b / a;
        assert!((10.0..22.0).contains(&ratio(few.seconds, many.seconds)), "{few:?} {many:?}");
        assert!((15.0..30.0).contains(&ratio(few.disk as f64, many.disk as f64)), "{few:?} {many:?}");
        // A block's own time does not grow.
        assert!((ratio(few.seconds_of_a_block, many.seconds_of_a_block) - 1.0).abs() < 0.01);
        // Time in proportion to steps, memory to Gaussians.
        let twice = plan(&Job { steps: 60_000, ..job(1000, 1) }, &SPEED);
        assert!((1.8..2.01).contains(&(twice.seconds / whole(1000).seconds)));
        let fewer = plan(&Job { gaussians: 100_000, ..job(1000, 1) }, &SPEED);
        assert_eq!(whole(1000).memory - fewer.memory, 900_000 * 2600);
    }

    #[test]
    fn a_store_takes_disk_and_time_by_its_models_and_is_named() {
        let with = |models| plan(&Job { store_models: Some(models), ..job(40, 1) }, &SPEED);
        let without = plan(&job(40, 1), &SPEED);
        let [few, many] = [with(0), with(32)];
        assert_eq!(few.disk - without.disk, few.store);
        assert!((200 << 20..1 << 30).contains(&few.store), "{few:?}");
        assert_eq!(many.store - few.store, 32 * STORE_MODEL);
        assert!(many.seconds - few.seconds > 32.0 && few.seconds > without.seconds && many.memory >= without.memory);
        let words = many.words(&Job { store_models: Some(32), ..job(40, 1) });
        assert!(words.contains("CDB store with up to 32 models"), "{words}");
        assert!(!without.words(&job(40, 1)).contains("CDB"));
    }

    #[test]
    fn a_trial_of_poses_takes_time_by_its_steps_and_is_named() {
        let with = |trial_steps| plan(&Job { trial_steps, ..job(400, 1) }, &SPEED);
        let [none, some, twice] = [0, 15_000, 30_000].map(with);
        assert!((none.seconds + some.seconds_of_a_trial - some.seconds).abs() < 1e-6 && none.memory == some.memory);
        // As a training of as many steps, and what four measurements take.
        let of_steps = plan(&Job { steps: 45_000, ..job(400, 1) }, &SPEED).seconds - none.seconds;
        let measured = some.seconds_of_a_trial - of_steps;
        assert!((twice.seconds_of_a_trial - 2.0 * of_steps - measured).abs() < 1e-6);
        assert!(measured > 0.0 && measured < 0.2 * of_steps, "{measured} {of_steps}");
        assert!(some.words(&Job { trial_steps: 15_000, ..job(400, 1) }).contains("whether poses can be refined"));
        assert!(!none.words(&job(400, 1)).contains("refined"));
    }

    #[test]
    fn blocks_are_as_many_as_the_memory_asks_for() {
        assert_eq!(blocks_within(&job(40, 1), 16 << 30), Some(1));
        let many = blocks_within(&job(10_000, 1), 64 << 30).unwrap();
        assert!((16..=256).contains(&many), "{many}");
        assert!(plan(&job(10_000, many), &SPEED).memory <= 64 << 30);
        assert!(plan(&job(10_000, many / 2), &SPEED).memory > 64 << 30);
        assert_eq!(blocks_within(&job(10_000, 1), 1 << 30), None);
    }

    #[test]
    fn a_machines_speed_is_measured_and_words_name_everything() {
        let s = speed(Engine::Cpu).unwrap();
        assert!(s.pixel > 1e-10 && s.gaussian > 1e-10 && s.step < 1.0, "{s:?}");
        let j = job(400, 8);
        let words = plan(&j, &s).words(&j);
        for part in ["400 photos", "memory", "time", "8 blocks", "disk", "at most"] {
            assert!(words.contains(part), "{words}");
        }
        assert_eq!([time(5.0), time(600.0), time(9000.0), time(1e6)], ["5 s", "10 min", "2.5 h", "11.6 days"]);
    }
}
