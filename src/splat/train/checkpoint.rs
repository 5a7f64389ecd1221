//! What a run goes on from, in memory and in a file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use bytemuck::{bytes_of, cast_slice};
use glam::{Mat3, Vec3};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::adam::Moments;
use super::density::Statistics;
use super::exposure::Exposure;
use super::pose::Pose;
use super::{Engine, Options, Target, check};
use crate::splat::packed::{Core, Packed, Sh};
use crate::splat::render::Shown;
use crate::splat::{Camera, Gaussians};
use crate::whole_file::{self, Found};
use crate::{Error, Result};

/// All that goes on from one iteration to the next: a run that is taken up again from one ends as if it had never
/// stopped, on the same engine. Random numbers depend on the seed and the iteration alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// Iterations done.
    pub iteration: usize,
    pub(super) gaussians: Packed,
    pub(super) moments: Moments,
    pub(super) statistics: Statistics,
    /// One a target, in order.
    pub cameras: Vec<Camera>,
    pub(super) poses: Vec<Pose>,
    pub(super) exposures: Vec<Exposure>,
}

impl Checkpoint {
    /// Before the first iteration.
    ///
    /// # Errors
    /// Usage: parameter arrays of different lengths; a target whose buffers do not fit its camera.
    pub fn new(g: &Gaussians, targets: &[Target]) -> Result<Checkpoint> {
        check(g, targets)?;
        let gaussians = Packed::pack(g);
        Ok(Checkpoint {
            iteration: 0,
            moments: Moments::new(&gaussians),
            statistics: Statistics::new(gaussians.len()),
            cameras: targets.iter().map(|t| t.camera).collect(),
            poses: vec![Pose::default(); targets.len()],
            exposures: vec![Exposure::default(); targets.len()],
            gaussians,
        })
    }

    pub fn gaussians(&self) -> Gaussians {
        self.gaussians.unpack()
    }
}

/// When a run is written to its file, besides its end and when the user stops it. What comes out does not depend on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Every {
    Iterations(usize),
    /// About so many: the next part's length is guessed from the last one's speed.
    Seconds(f64),
}

impl Default for Every {
    fn default() -> Every {
        Every::Seconds(60.0)
    }
}

/// Iterations of the first part, by which the speed is found out; and how many times longer the next part may be.
const FIRST: usize = 100;
const LONGER: usize = 10;

impl Every {
    /// Up to which iteration the next part goes, after one of `last` iterations in `seconds`.
    pub(super) fn until(self, from: usize, last: Option<(usize, f64)>) -> usize {
        match (self, last) {
            (Every::Iterations(n), _) => (from / n.max(1) + 1) * n.max(1),
            (Every::Seconds(_), None) => from + FIRST,
            (Every::Seconds(goal), Some((iterations, seconds))) => {
                let fit = iterations as f64 * goal / seconds.max(1e-6);
                from + (fit as usize).clamp(1, LONGER * iterations.max(1))
            }
        }
    }
}

/// How a run is kept in a file, and what it goes on from.
#[derive(Clone, Debug, Default)]
pub struct Kept {
    pub file: Option<PathBuf>,
    pub every: Every,
    pub from: Option<Arc<Saved>>,
    /// Numbers of the caller's that stand in the file beside it, for a run that goes on from it: [`Saved::beside`].
    pub beside: Vec<u64>,
}

/// A checkpoint as it stands in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Saved {
    /// Iterations of the whole run.
    pub iterations: usize,
    run: Run,
    checkpoint: Checkpoint,
    beside: Vec<u64>,
}

/// What must be the same for a run to go on: SHA-256 of each, and where it ran.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Run {
    engine: String,
    pictures: String,
    start: String,
    schedule: String,
}

const KIND: &[u8; 8] = b"orbckpt2";

/// What stands before the numbers.
#[derive(Serialize, Deserialize)]
struct Head {
    version: String,
    iterations: usize,
    iteration: usize,
    gaussians: usize,
    cameras: usize,
    run: Run,
    #[serde(default)]
    beside: Vec<u64>,
}

/// A camera in the file: width and height, then fx fy cx cy, the rotation's columns, the translation.
type CameraWords = ([u32; 2], [f32; 16]);

/// Bytes of one Gaussian: parameters, both moments, steps, statistics.
const EACH: usize = 3 * (16 + 48) * 4 + 4 + 8;
/// Bytes of one camera: itself, its pose's moments, its photo's exposure.
const EACH_CAMERA: usize = 2 * 4 + 16 * 4 + 16 * 4 + 40 * 4;

impl Run {
    pub fn new(engine: Engine, start: &Checkpoint, targets: &[Target], options: &Options) -> Run {
        let mut pictures = Sha256::new();
        for t in targets {
            let (size, words) = camera_words(&t.camera);
            pictures.update(cast_slice(&size));
            pictures.update(cast_slice(&words));
            pictures.update(cast_slice(&t.color));
            pictures.update(cast_slice(&t.alpha));
            pictures.update(t.weight.to_le_bytes());
            let flags = [t.refine_pose.is_some(), t.held_back.is_some(), t.shown == Shown::Normals, t.fit_exposure];
            pictures.update(flags.map(u8::from));
            pictures.update(t.refine_pose.unwrap_or_default().to_le_bytes());
            t.held_back.iter().flatten().for_each(|h| pictures.update([u8::from(*h)]));
            t.confidence.iter().for_each(|c| pictures.update(cast_slice(c)));
        }
        let mut gaussians = Sha256::new();
        gaussians.update(cast_slice(&start.gaussians.core));
        gaussians.update(cast_slice(&start.gaussians.sh));
        // Every number is written so that it reads back the same.
        let schedule = format!("{:?}", Options { deadline: None, ..*options });
        Run {
            engine: engine.name(),
            pictures: hex::encode(pictures.finalize()),
            start: hex::encode(gaussians.finalize()),
            schedule: hex::encode(Sha256::digest(schedule)),
        }
    }
}

impl Saved {
    pub(super) fn new(run: &Run, iterations: usize, checkpoint: &Checkpoint, beside: &[u64]) -> Saved {
        Saved { iterations, run: run.clone(), checkpoint: checkpoint.clone(), beside: beside.to_vec() }
    }

    /// What the run that wrote it kept beside it ([`Kept::beside`]); none where it kept nothing.
    pub fn beside(&self) -> &[u64] {
        &self.beside
    }

    /// Reads a file written by [`Saved::write`].
    ///
    /// # Errors
    /// Environment: it cannot be read. Usage: it is no checkpoint. Integrity: it is cut off or changed.
    pub fn read(path: &Path) -> Result<Saved> {
        let name = path.display().to_string();
        match whole_file::read(path, KIND).map_err(|e| Error::io(path, &e))? {
            Found::Other => Err(Error::usage(name)
                .expected("a checkpoint of an optimisation by this version of orb")
                .found("another file")
                .advice("Name the file that --checkpoint was given.")),
            Found::Damaged => Err(Error::integrity(name)
                .expected("a checkpoint as it was written")
                .found("one that is cut off or changed")
                .advice("Take an older copy, or begin without --resume.")),
            Found::Whole(bytes) => Saved::parse(&bytes).ok_or_else(|| {
                Error::integrity(name)
                    .expected("a checkpoint as this version writes it")
                    .found("other contents")
                    .advice("Begin without --resume.")
            }),
        }
    }

    /// # Errors
    /// Environment: it cannot be written; an older file then still stands.
    pub fn write(&self, path: &Path) -> Result<()> {
        whole_file::write(path, KIND, &self.bytes()).map_err(|e| {
            Error::io(path, &e).expected("room for a checkpoint").advice("Choose another place with --checkpoint.")
        })
    }

    /// The checkpoint, if it belongs to this run.
    pub(super) fn resume(&self, run: &Run) -> Result<Checkpoint> {
        let pairs = [
            ("engine", &self.run.engine, &run.engine),
            ("pictures", &self.run.pictures, &run.pictures),
            ("first Gaussians", &self.run.start, &run.start),
            ("schedule, options or seed", &self.run.schedule, &run.schedule),
        ];
        match pairs.iter().find(|(_, saved, now)| saved != now) {
            None => Ok(self.checkpoint.clone()),
            Some((what, saved, now)) => Err(Error::usage("--resume")
                .expected(format!("a checkpoint of this run; its {what}: {now}"))
                .found(saved.as_str())
                .advice("Give the same input and options as the run that was stopped, or begin without --resume.")),
        }
    }

    fn bytes(&self) -> Vec<u8> {
        let c = &self.checkpoint;
        let head = Head {
            version: env!("CARGO_PKG_VERSION").into(),
            iterations: self.iterations,
            iteration: c.iteration,
            gaussians: c.gaussians.len(),
            cameras: c.cameras.len(),
            run: self.run.clone(),
            beside: self.beside.clone(),
        };
        // Plain numbers and strings: this cannot fail.
        let head = serde_json::to_vec(&head).unwrap_or_default();
        let mut out = Vec::with_capacity(4 + head.len() + EACH * c.gaussians.len() + EACH_CAMERA * c.cameras.len());
        out.extend((head.len() as u32).to_le_bytes());
        out.extend(head);
        out.extend_from_slice(cast_slice(&c.gaussians.core));
        out.extend_from_slice(cast_slice(&c.gaussians.sh));
        out.extend_from_slice(cast_slice(&c.moments.core));
        out.extend_from_slice(cast_slice(&c.moments.sh));
        out.extend_from_slice(cast_slice(&c.moments.steps));
        out.extend_from_slice(cast_slice(&c.statistics.seen));
        for ((camera, pose), exposure) in c.cameras.iter().zip(&c.poses).zip(&c.exposures) {
            let (size, words) = camera_words(camera);
            out.extend_from_slice(bytes_of(&size));
            out.extend_from_slice(bytes_of(&words));
            out.extend_from_slice(bytes_of(&pose.words()));
            out.extend_from_slice(cast_slice(&exposure.words()));
        }
        out
    }

    fn parse(bytes: &[u8]) -> Option<Saved> {
        let (length, rest) = bytes.split_first_chunk()?;
        let (head, rest) = rest.split_at_checked(u32::from_le_bytes(*length) as usize)?;
        let head: Head = serde_json::from_slice(head).ok()?;
        let (n, cameras) = (head.gaussians, head.cameras);
        if n.checked_mul(EACH)?.checked_add(cameras.checked_mul(EACH_CAMERA)?)? != rest.len() {
            return None;
        }
        let mut rest = rest;
        let mut take = |count: usize| {
            let (part, later) = rest.split_at(count);
            rest = later;
            part
        };
        let core: Vec<Core> = bytemuck::pod_collect_to_vec(take(64 * n));
        let sh: Vec<Sh> = bytemuck::pod_collect_to_vec(take(192 * n));
        let moments = Moments {
            core: bytemuck::pod_collect_to_vec(take(128 * n)),
            sh: bytemuck::pod_collect_to_vec(take(384 * n)),
            steps: bytemuck::pod_collect_to_vec(take(4 * n)),
        };
        let statistics = Statistics { seen: bytemuck::pod_collect_to_vec(take(8 * n)) };
        let (mut views, mut poses, mut exposures) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..cameras {
            let size = bytemuck::pod_read_unaligned(take(8));
            views.push(camera_from((size, bytemuck::pod_read_unaligned(take(64)))));
            poses.push(Pose::from_words(&bytemuck::pod_read_unaligned(take(64))));
            let words: Vec<f32> = bytemuck::pod_collect_to_vec(take(160));
            exposures.push(Exposure::from_words(&words.try_into().ok()?));
        }
        let gaussians = Packed { core, sh };
        let checkpoint =
            Checkpoint { iteration: head.iteration, gaussians, moments, statistics, cameras: views, poses, exposures };
        Some(Saved { iterations: head.iterations, run: head.run, checkpoint, beside: head.beside })
    }
}

fn camera_words(c: &Camera) -> CameraWords {
    let mut words = [0.0; 16];
    words[..4].copy_from_slice(&[c.fx, c.fy, c.cx, c.cy]);
    words[4..13].copy_from_slice(&c.rotation.to_cols_array());
    words[13..].copy_from_slice(&c.translation.to_array());
    ([c.width, c.height], words)
}

fn camera_from(([width, height], w): CameraWords) -> Camera {
    Camera {
        width,
        height,
        fx: w[0],
        fy: w[1],
        cx: w[2],
        cy: w[3],
        rotation: Mat3::from_cols_slice(&w[4..13]),
        translation: Vec3::from_slice(&w[13..]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kind;
    use crate::splat::render::tests::{camera, scene};

    fn saved() -> (Saved, Vec<Target>, Options) {
        let camera = camera(8, 6);
        let target = Target {
            camera,
            color: vec![[0.5; 3]; 48],
            alpha: vec![1.0; 48],
            weight: 1.0,
            refine_pose: Some(0.0),
            fit_exposure: true,
            held_back: Some(vec![false; 48]),
            confidence: None,
            shown: Shown::Color,
            name: "picture".into(),
        };
        let targets = vec![target];
        let mut c = Checkpoint::new(&scene(5, 0.1, 1), &targets).unwrap();
        let options = Options::scaled(70);
        let run = Run::new(Engine::Cpu, &c, &targets, &options);
        c.iteration = 30;
        c.moments.core[2][1][7] = -0.25;
        c.moments.sh[4][0][47] = 1e-30;
        c.moments.steps[3] = 29;
        c.statistics.seen[1] = [0.5, 3.0];
        c.cameras[0].translation.y += 0.125;
        c.exposures[0].step(&[[0.1; 4]; 3], 0.25, 0.0);
        c.poses[0] = Pose::from_words(&std::array::from_fn(|k| if k % 4 == 3 { 0.0 } else { k as f32 }));
        (Saved::new(&run, 70, &c, &[7, u64::MAX]), targets, options)
    }

    #[test]
    fn parts_take_the_time_that_is_asked_for() {
        assert_eq!(Every::Iterations(20).until(45, None), 60);
        assert_eq!(Every::Iterations(0).until(45, Some((1, 1.0))), 46);
        let minute = Every::Seconds(60.0);
        assert_eq!(minute.until(0, None), FIRST);
        // Ten times as many at most; then by the speed; one at least.
        assert_eq!(minute.until(100, Some((100, 0.1))), 1100);
        assert_eq!(minute.until(100, Some((100, 120.0))), 150);
        assert_eq!(minute.until(100, Some((100, 1e9))), 101);
        assert_eq!(minute.until(100, Some((0, 0.0))), 101);
    }

    #[test]
    fn a_file_gives_back_what_was_written() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("run");
        let (saved, targets, options) = saved();
        saved.write(&path).unwrap();
        let read = Saved::read(&path).unwrap();
        assert_eq!(read, saved);
        assert_eq!(read.beside(), [7, u64::MAX]);
        let start = Checkpoint::new(&scene(5, 0.1, 1), &targets).unwrap();
        let now = |targets: &[Target], o: &Options| Run::new(Engine::Cpu, &start, targets, o);
        // A deadline is no part of what the run is.
        let late = Options { deadline: Some(std::time::Instant::now()), ..options };
        assert_eq!(read.resume(&now(&targets, &late)).unwrap(), saved.checkpoint);
        let mut other = targets.clone();
        other[0].color[7][1] += 0.1;
        let e = read.resume(&now(&other, &options)).unwrap_err();
        assert!(e.kind == Kind::Usage && e.to_string().contains("pictures"), "{e}");
        let e = read.resume(&now(&targets, &Options { seed: 1, ..options })).unwrap_err();
        assert!(e.kind == Kind::Usage && e.to_string().contains("seed"), "{e}");
    }

    #[test]
    fn other_and_damaged_files_are_named() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("run");
        let kind = || {
            let e = Saved::read(&path).unwrap_err();
            assert!(e.to_string().contains("run"), "{e}");
            e.kind
        };
        assert_eq!(kind(), Kind::Environment);
        std::fs::write(&path, b"ply\nformat ascii 1.0\n").unwrap();
        assert_eq!(kind(), Kind::Usage);
        saved().0.write(&path).unwrap();
        let whole = std::fs::read(&path).unwrap();
        for cut in [9, 60, whole.len() - 1] {
            std::fs::write(&path, &whole[..cut]).unwrap();
            assert_eq!(kind(), Kind::Integrity);
        }
        let mut changed = whole.clone();
        changed[500] ^= 4;
        std::fs::write(&path, &changed).unwrap();
        assert_eq!(kind(), Kind::Integrity);
        // Whole, but with more Gaussians in its head than stand in it.
        let bytes = saved().0.bytes();
        let text = String::from_utf8_lossy(&bytes[..400]).into_owned();
        assert!(text.contains("\"gaussians\":5,"));
        let at = text.find("\"gaussians\":5,").unwrap() + 12;
        let mut more = bytes;
        more[at] = b'9';
        whole_file::write(&path, KIND, &more).unwrap();
        assert_eq!(kind(), Kind::Integrity);
        whole_file::write(&path, KIND, b"").unwrap();
        assert_eq!(kind(), Kind::Integrity);
    }
}
