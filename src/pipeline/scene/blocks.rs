//! A large scene in blocks: first the whole of it coarsely, from small photos; then block by block of the ground from the
//! photos that show it, at full size; then the blocks put together, each cut to its own cell (Liu et al. 2024, CityGaussian;
//! Lin et al. 2024, VastGaussian). No more than one block's photos lie in memory at a time.
//!
//! A block begins with the coarse scene. What lies outside its cell and the overlap with its neighbours keeps its place and
//! shape, and pixels that show it are not trained on: neighbours that meet were both trained on the photos' view of the seam.
//! The sky is trained in all of them and is their mean.

pub mod cells;
mod part;

use std::fs;
use std::path::{Path, PathBuf};

use cells::Cell;
use part::Part;
pub use part::{Head, head};

use super::{
    Begun, Clock, Drawers, From, NONE, Options, Pictures, Report, Role, Scene, Scores, Source, View, begin, cameras,
    extent, pictures, schedule, score, sky, unit_frame,
};
use crate::bench::Picture;
use crate::geo::similarity::Similarity;
use crate::models::Graph;
use crate::photos::Poses;
use crate::progress::Progress;
use crate::splat::train::{Kept, Region, Saved, train_kept};
use crate::splat::{self, Camera, Gaussians};
use crate::{Error, Result};

/// The folder of the coarse scene, and the files in it and in that of each block.
pub const COARSE: &str = "coarse";
pub const PART_FILE: &str = "gaussians.part";
pub const CHECKPOINT_FILE: &str = "run.ckpt";

/// The folder of a block, from 0.
pub fn name(block: usize) -> String {
    format!("block_{:03}", block + 1)
}

/// The coarse scene has at most this part of the Gaussians that one training may have.
const COARSE_PART: usize = 2;
/// Photos that are read at a time to be measured.
const PORTION: usize = 32;

/// How a scene is cut, and where its parts are kept.
#[derive(Clone, Debug)]
pub struct Blocks {
    pub count: usize,
    /// Parts that stand there are not trained again.
    pub folder: PathBuf,
    /// Only this block, from 0; what is needed for it, and nothing put together.
    pub only: Option<usize>,
    /// SHA-256 of what must be the same for parts to belong together.
    pub run: String,
}

/// What there was to do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Made {
    /// Parts that were trained, and those that stood there.
    pub trained: usize,
    pub found: usize,
}

/// The longer side of photos for the coarse scene: all of them together have about as many pixels as one block's.
pub fn coarse_side(longest: u32, count: usize) -> u32 {
    ((f64::from(longest) / (count.max(1) as f64).sqrt()).round() as u32).clamp(16.min(longest), longest)
}

struct Run<'a> {
    source: &'a Source<'a>,
    fitter: splat::Engine<'a>,
    options: &'a Options,
    blocks: &'a Blocks,
    to_unit: Similarity,
    extent: f32,
    /// One a photo at full size.
    cameras: Vec<Camera>,
    progress: &'a dyn Progress,
}

/// As [`super::fit`], in blocks; no scene where only one block was asked for. `tell` hears what is done.
///
/// # Errors
/// As [`super::fit`]; a part of another run or one that cannot be read or written; usage for exposures and refined poses,
/// which blocks would each learn for themselves.
pub fn fit(
    source: &Source,
    fitter: splat::Engine,
    options: &Options,
    blocks: &Blocks,
    lpips: Option<&dyn Graph>,
    progress: &dyn Progress,
    tell: &mut dyn FnMut(String),
) -> Result<(Option<Scene>, Made)> {
    for (option, given) in [("--exposure", options.exposure), ("--refine-poses", options.refine_poses)] {
        if given {
            return Err(Error::usage(option).expected("a scene trained as a whole").found("--blocks"));
        }
    }
    if let Some(i) = blocks.only.filter(|i| *i >= blocks.count) {
        return Err(Error::usage("--block").expected(format!("1 to {}", blocks.count)).found((i + 1).to_string()));
    }
    let mut clock = Clock::new();
    let (to_unit, up_by, ground) = unit_frame(source.poses, options.up, options.seed)?;
    let cameras: Vec<Camera> =
        source.poses.photos.iter().map(|p| pictures::camera_of(p, &to_unit, options.longest_side)).collect();
    let extent = extent(cameras.iter().map(Camera::position));
    let run = Run { source, fitter, options, blocks, to_unit, extent, cameras, progress };
    let mut made = Made::default();
    let mut seconds = splat::train::Seconds::default();
    let mut peak_bytes = 0;
    let mut count = |ran: Option<Report>| match ran {
        None => made.found += 1,
        Some(r) => {
            made.trained += 1;
            seconds = seconds.plus(&r.seconds);
            peak_bytes = peak_bytes.max(r.peak_bytes);
        }
    };
    tell(format!("the whole scene, coarsely: photos of {} pixels", coarse_side(options.longest_side, blocks.count)));
    let (coarse, ran) = run.coarse()?;
    count(ran);
    clock.lap("coarse scene");
    let near = coarse.gaussians.len() - coarse.head.sky;
    let (cells, overlap) = cells::cells(&coarse.gaussians.positions[..near], blocks.count);
    let grown: Vec<Cell> = cells.iter().map(|c| c.grown(overlap)).collect();
    let mut shares = None;
    let mut parts = Vec::new();
    for (i, cell) in cells.iter().enumerate().filter(|(i, _)| blocks.only.is_none_or(|only| only == *i)) {
        progress.check()?;
        let path = run.file(&name(i));
        let what = format!("block {} of {}", i + 1, blocks.count);
        let part = match Part::read(&path, &blocks.run, &what)? {
            Some(part) => {
                tell(format!("{what}: stands in {}", path.display()));
                count(None);
                part
            }
            None => {
                let shares = shares.get_or_insert_with(|| cells::shares(&coarse.gaussians, &run.cameras, &grown));
                let usable: Vec<bool> = (0..run.cameras.len()).map(|k| !run.is_held_out(k)).collect();
                let chosen = cells::photos_of(i, shares, &usable);
                tell(format!("{what}: {} of {} photos show it", chosen.len(), run.cameras.len()));
                let (part, ran) = run.block(&what, &path, &coarse, cell, &grown[i], &chosen)?;
                count(Some(ran));
                part
            }
        };
        if blocks.only.is_none() {
            parts.push(part);
        }
    }
    clock.lap("blocks");
    if blocks.only.is_some() {
        return Ok((None, made));
    }
    let mut gaussians = Gaussians::default();
    let own = |p: &Part| p.gaussians.len() - p.head.sky;
    parts.iter().for_each(|p| gaussians.extend(&p.gaussians.filtered(|i| i < own(p))));
    let skies: Vec<Gaussians> = parts.iter().map(|p| p.gaussians.filtered(|i| i >= own(p))).collect();
    gaussians.extend(&mean_sky(&coarse.gaussians.filtered(|i| i >= near), &skies));
    let steps = coarse.head.steps + parts.iter().map(|p| p.head.steps).sum::<usize>();
    let views = run.measure(&gaussians, coarse.head.behind, lpips)?;
    clock.lap("measuring");
    let of = |role: Role| Scores::mean(views.iter().filter(|v| v.role == role).map(|v| &v.scores));
    let (trained, held_out) = (of(Role::Trained), of(Role::HeldOut));
    let report = Report {
        iterations: steps,
        gaussians_before: coarse.head.begun,
        gaussians_after: gaussians.len(),
        seconds,
        peak_bytes,
        device: fitter.name(),
        ..Report::default()
    };
    let scene = Scene {
        gaussians,
        sky: coarse.head.sky,
        exposures: vec![NONE; run.cameras.len()],
        cameras: run.cameras,
        to_unit,
        up_by,
        ground,
        begun_from: coarse.head.begun_from(),
        views,
        trained,
        held_out,
        held_out_fitted: None,
        refining: None,
        refined: None,
        // Blocks leave poses as they are.
        reprojection: cameras::errors(source.poses, None, |i| !source.held_out.get(i).copied().unwrap_or(false)),
        behind: coarse.head.behind,
        report,
        timings: clock.timings,
    };
    Ok((Some(scene), made))
}

/// Each Gaussian of the sky as the mean of the blocks that trained it; as it was where none did.
fn mean_sky(before: &Gaussians, blocks: &[Gaussians]) -> Gaussians {
    let mut out = before.clone();
    let blocks: Vec<&Gaussians> = blocks.iter().filter(|b| b.len() == before.len()).collect();
    for i in 0..before.len() {
        let is_trained = |b: &&&Gaussians| {
            b.sh[i] != before.sh[i] || b.logit_opacities[i].to_bits() != before.logit_opacities[i].to_bits()
        };
        let trained: Vec<&&Gaussians> = blocks.iter().filter(is_trained).collect();
        if trained.is_empty() {
            continue;
        }
        let n = trained.len() as f32;
        out.logit_opacities[i] = trained.iter().map(|b| b.logit_opacities[i]).sum::<f32>() / n;
        for (k, color) in out.sh[i].iter_mut().enumerate() {
            *color = std::array::from_fn(|c| trained.iter().map(|b| b.sh[i][k][c]).sum::<f32>() / n);
        }
    }
    out
}

impl Run<'_> {
    fn file(&self, name: &str) -> PathBuf {
        self.blocks.folder.join(name).join(PART_FILE)
    }

    fn is_held_out(&self, photo: usize) -> bool {
        self.source.held_out.get(photo).copied().unwrap_or(false)
    }

    /// Kept beside the part; a run that was stopped goes on.
    fn kept(&self, part: &Path) -> Result<(Kept, PathBuf)> {
        let file = part.with_file_name(CHECKPOINT_FILE);
        let from = if file.exists() { Some(Saved::read(&file)?.into()) } else { None };
        let kept = Kept { file: Some(file.clone()), every: self.options.kept.every, from, ..Kept::default() };
        Ok((kept, file))
    }

    /// Some photos of the set as a set of its own.
    fn pictures(&self, chosen: &[usize], longest: u32) -> Result<Pictures> {
        let poses = Poses {
            photos: chosen.iter().map(|i| self.source.poses.photos[*i].clone()).collect(),
            points: Vec::new(),
            observations: Vec::new(),
            source: String::new(),
            files: Vec::new(),
            notes: Vec::new(),
        };
        let held_out: Vec<bool> = chosen.iter().map(|i| self.is_held_out(*i)).collect();
        let mask = |i: usize| (self.source.mask)(chosen[i]);
        let source = Source { poses: &poses, held_out: &held_out, open: self.source.open, mask: &mask };
        let options = Options { longest_side: longest, ..self.options.clone() };
        pictures::read(&source, &self.to_unit, &options, self.progress)
    }

    fn write(&self, part: Part, path: &Path, checkpoint: &Path) -> Result<Part> {
        part.write(path)?;
        // The part is whole: what led to it is no use any more. One that cannot be removed does no harm.
        let _ = fs::remove_file(checkpoint);
        Ok(part)
    }

    fn coarse(&self) -> Result<(Part, Option<Report>)> {
        let path = self.file(COARSE);
        if let Some(part) = Part::read(&path, &self.blocks.run, COARSE)? {
            return Ok((part, None));
        }
        let options = Options {
            longest_side: coarse_side(self.options.longest_side, self.blocks.count),
            max_gaussians: (self.options.max_gaussians / COARSE_PART).max(100),
            ..self.options.clone()
        };
        let all: Vec<usize> = (0..self.cameras.len()).collect();
        let pictures = self.pictures(&all, options.longest_side)?;
        let photos = pictures.trained_on()?;
        let Begun { start, from, behind } =
            begin(self.source.poses, &self.to_unit, &pictures, self.extent, &options, self.options.max_gaussians)?;
        let schedule = schedule(&options, self.extent, behind, photos, from);
        let (kept, checkpoint) = self.kept(&path)?;
        let begun = start.len();
        let done = train_kept(self.fitter, start, &pictures.targets, &schedule, &kept, self.progress)?;
        let (gaussians, sky) = sky::last(done.gaussians, self.extent);
        let head = Head {
            run: self.blocks.run.clone(),
            what: COARSE.into(),
            gaussians: gaussians.len(),
            sky,
            photos,
            steps: done.report.iterations,
            begun,
            random: matches!(from, From::Random(_)),
            behind,
        };
        Ok((self.write(Part { head, gaussians }, &path, &checkpoint)?, Some(done.report)))
    }

    fn block(
        &self,
        what: &str,
        path: &Path,
        coarse: &Part,
        cell: &Cell,
        grown: &Cell,
        chosen: &[usize],
    ) -> Result<(Part, Report)> {
        let far = sky::beyond(self.extent);
        let head = |g: &Gaussians, steps: usize, begun: usize| Head {
            run: self.blocks.run.clone(),
            what: what.into(),
            gaussians: g.len(),
            sky: coarse.head.sky,
            photos: chosen.len(),
            steps,
            begun,
            random: coarse.head.random,
            behind: coarse.head.behind,
        };
        // Its own ground, then the whole sky.
        let own = |g: &Gaussians| {
            let is_sky = |p: glam::Vec3| p.length() > far;
            let mut out = g.filtered(|i| !is_sky(g.positions[i]) && cell.holds(g.positions[i]));
            out.extend(&g.filtered(|i| is_sky(g.positions[i])));
            out
        };
        if chosen.len() < 2 {
            // Nothing says more of it than the coarse scene.
            let gaussians = own(&coarse.gaussians);
            let part = Part { head: head(&gaussians, 0, gaussians.len()), gaussians };
            part.write(path)?;
            return Ok((part, Report::default()));
        }
        let mut pictures = self.pictures(chosen, self.options.longest_side)?;
        let drawers = Drawers::new(&coarse.gaussians);
        for t in &mut pictures.targets {
            let surface = cells::surface(&drawers, &t.camera);
            let held = t.held_back.get_or_insert_with(|| vec![false; surface.len()]);
            for (held, at) in held.iter_mut().zip(&surface) {
                *held |= at.is_some_and(|p| p.length() <= far && !grown.holds(p));
            }
        }
        drop(drawers);
        let seen = |p: glam::Vec3| {
            p.length() > far || grown.holds(p) || pictures.targets.iter().any(|t| begin::nearly_sees(&t.camera, p))
        };
        let g = &coarse.gaussians;
        let start = g.filtered(|i| seen(g.positions[i]));
        let plain = schedule(self.options, self.extent, coarse.head.behind, chosen.len(), coarse.head.begun_from());
        let moving = Region { radius: far, low: grown.low, high: grown.high };
        let schedule = splat::Options { first_degree: 3, moving, ..plain };
        let (kept, checkpoint) = self.kept(path)?;
        let begun = start.len();
        let done = train_kept(self.fitter, start, &pictures.targets, &schedule, &kept, self.progress)?;
        let gaussians = own(&done.gaussians);
        let part = Part { head: head(&gaussians, done.report.iterations, begun), gaussians };
        Ok((self.write(part, path, &checkpoint)?, done.report))
    }

    /// Every photo, some at a time; only of those held out the pictures are kept.
    fn measure(&self, g: &Gaussians, behind: [f32; 3], lpips: Option<&dyn Graph>) -> Result<Vec<View>> {
        let drawers = Drawers::new(g);
        let all: Vec<usize> = (0..self.cameras.len()).collect();
        let any_held_out = all.iter().any(|i| self.is_held_out(*i));
        let mut views = Vec::with_capacity(all.len());
        for some in all.chunks(PORTION) {
            let targets = self.pictures(some, self.options.longest_side)?.targets;
            let cameras: Vec<Camera> = targets.iter().map(|t| t.camera).collect();
            let exposures = vec![NONE; some.len()];
            let mut measured = score::views(targets, &drawers, &cameras, &exposures, behind, lpips, self.progress)?;
            for v in measured.iter_mut().filter(|v| any_held_out && v.role == Role::Trained) {
                (v.truth, v.found) = (Picture::new(0, 0, Vec::new()), Picture::new(0, 0, Vec::new()));
            }
            views.extend(measured);
        }
        Ok(views)
    }
}
