//! Who refines the poses: what photos show of common points where that is enough, else the photos alone, where a trial says that they
//! can; else nobody.
//!
//! Training moves a camera by Adam, whose steps are as long where the picture says nothing as where it says much. From poses that are
//! right it therefore takes them away from the truth by a part of a pixel, without the pictures getting any worse for it: the
//! Gaussians go with the cameras. What tells the two apart is by how much photos are met better than with the poses as given.

use super::{Pictures, train_kept};
use crate::Result;
use crate::photos::adjust::Common;
use crate::progress::Progress;
use crate::splat::train::Kept;
use crate::splat::{self, Gaussians, Target};

/// What became of the wish that poses be refined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refining {
    /// What the photos trained on show in common.
    pub common: Common,
    pub by: By,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum By {
    /// Bundle adjustment, which moved so many photos; then training, as far as that leaves poses unknown.
    Points { photos: usize },
    /// Training alone.
    Photos(Trial),
    /// The same, without a trial.
    Untried,
    /// Poses stay as given: the trial, where the steps were enough for one.
    Nothing(Option<Trial>),
}

/// Two short trainings, one with the poses as given and one that refines them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    pub steps: usize,
    /// PSNR that the photos trained on gained by refining, dB: mean, and standard error of it over the photos.
    pub gain: f64,
    pub error: f64,
}

/// A quarter of the run's steps, but no more turns a photo than show it, and no fewer than move a pose at all.
const PART: usize = 4;
const MOST_TURNS: usize = 25;
const LEAST_TURNS: usize = 4;
/// A mean gain of no more than this, dB, or than two standard errors, is none. On made photos that began at their true poses it
/// was 0.1 at most.
const GAIN: f64 = 0.3;

impl Trial {
    /// Steps of each of the two, where so many are to be made on so many photos.
    pub fn steps(iterations: usize, photos: usize) -> Option<usize> {
        let steps = (iterations / PART).min(MOST_TURNS * photos);
        (steps >= LEAST_TURNS * photos).then_some(steps)
    }

    /// As a run's checkpoint keeps it, so that a run that goes on from there need not try again.
    pub(super) fn numbers(&self) -> Vec<u64> {
        vec![self.steps as u64, self.gain.to_bits(), self.error.to_bits()]
    }

    /// `None` where a checkpoint keeps none: of a run that refined no poses, or that had nothing to try.
    pub(super) fn from_numbers(numbers: &[u64]) -> Option<Trial> {
        let [steps, gain, error] = *numbers else { return None };
        Some(Trial { steps: steps as usize, gain: f64::from_bits(gain), error: f64::from_bits(error) })
    }

    fn of(steps: usize, gains: &[f64]) -> Trial {
        let n = gains.len().max(1) as f64;
        let gain = gains.iter().sum::<f64>() / n;
        let squares: f64 = gains.iter().map(|g| (g - gain).powi(2)).sum();
        Trial { steps, gain, error: (squares / (n - 1.0).max(1.0) / n).sqrt() }
    }

    fn verdict(self) -> By {
        if self.is_gain() { By::Photos(self) } else { By::Nothing(Some(self)) }
    }

    fn is_gain(&self) -> bool {
        self.gain > GAIN.max(2.0 * self.error)
    }
}

/// Tries whether the photos alone can refine the poses; `pictures` are left to be trained on as that says. `schedule`: of so many
/// steps. `known`: what the run that this one goes on from found; then nothing is tried.
///
/// # Errors
/// As [`train_kept`].
pub fn tried(
    fitter: splat::Engine,
    start: &Gaussians,
    pictures: &mut Pictures,
    iterations: usize,
    schedule: impl Fn(usize) -> splat::Options,
    known: Option<Trial>,
    progress: &dyn Progress,
) -> Result<By> {
    let is_trained_on: Vec<bool> = pictures.targets.iter().map(|t| t.weight > 0.0).collect();
    let photos = is_trained_on.iter().filter(|t| **t).count();
    let still = |targets: &mut [Target]| targets.iter_mut().for_each(|t| t.refine_pose = None);
    let Some(steps) = Trial::steps(iterations, photos) else {
        still(&mut pictures.targets);
        return Ok(By::Nothing(None));
    };
    if let Some(trial) = known {
        if !trial.is_gain() {
            still(&mut pictures.targets);
        }
        return Ok(trial.verdict());
    }
    let options = schedule(steps);
    let psnr = |targets: &[Target], before: usize| -> Result<Vec<f64>> {
        let part = PartOf { progress, before: before as u64 };
        let done = train_kept(fitter, start.clone(), targets, &options, &Kept::default(), &part)?;
        let of = done.report.targets.iter().zip(&is_trained_on).filter(|(_, counts)| **counts);
        Ok(of.map(|(t, _)| f64::from(t.after.picture)).collect())
    };
    progress.begin("trying to refine poses", 2 * steps as u64);
    let refined = psnr(&pictures.targets, 0)?;
    let pivots: Vec<Option<f32>> = pictures.targets.iter().map(|t| t.refine_pose).collect();
    still(&mut pictures.targets);
    let given = psnr(&pictures.targets, steps)?;
    let gains: Vec<f64> = refined.iter().zip(&given).map(|(r, g)| r - g).collect();
    let trial = Trial::of(steps, &gains);
    if trial.is_gain() {
        pictures.targets.iter_mut().zip(pivots).for_each(|(t, pivot)| t.refine_pose = pivot);
    }
    Ok(trial.verdict())
}

/// One of several trainings that are one stage.
struct PartOf<'a> {
    progress: &'a dyn Progress,
    before: u64,
}

impl Progress for PartOf<'_> {
    fn begin(&self, _: &'static str, _: u64) {}
    fn step(&self, done: u64) {
        self.progress.step(self.before + done);
    }
    fn cancelled(&self) -> bool {
        self.progress.cancelled()
    }
}

impl Refining {
    /// Whether poses were moved at all.
    pub fn moved(&self) -> bool {
        !matches!(self.by, By::Nothing(_))
    }

    /// For a person: what was done, or not, and why.
    pub fn words(&self) -> String {
        let Common { observations, points } = self.common;
        let few = match points {
            0 => "the poses come without points that photos have in common".to_owned(),
            _ => format!("{observations} observations of {points} common points are too few for an adjustment"),
        };
        let tried = |t: &Trial| {
            format!("in a trial of {} steps they were met {:+.2} ± {:.2} dB closer", t.steps, t.gain, t.error)
        };
        match &self.by {
            By::Points { photos } => {
                format!("{photos} photos by {observations} observations of {points} common points, then by the photos")
            }
            By::Untried => format!("by the photos alone, untried; {few}"),
            By::Photos(t) => format!("by the photos alone, as {few}; {}", tried(t)),
            By::Nothing(Some(t)) => {
                format!("poses stay as given: {few}, and the photos alone do not say better ones; {}", tried(t))
            }
            By::Nothing(None) => {
                format!("poses stay as given: {few}, and these are too few steps to learn poses from the photos alone")
            }
        }
    }

    /// One word for programs.
    pub fn by(&self) -> &'static str {
        match self.by {
            By::Points { .. } => "points",
            By::Photos(_) | By::Untried => "photos",
            By::Nothing(_) => "nothing",
        }
    }

    pub fn trial(&self) -> Option<&Trial> {
        match &self.by {
            By::Photos(t) | By::Nothing(Some(t)) => Some(t),
            By::Points { .. } | By::Untried | By::Nothing(None) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gain_is_one_that_is_large_and_sure() {
        let sure = Trial::of(100, &[0.5, 0.6, 0.4, 0.5]);
        assert!((sure.gain - 0.5).abs() < 1e-9 && (sure.error - 0.0408).abs() < 1e-3 && sure.is_gain(), "{sure:?}");
        // Of no photo's own, of hardly any, of one photo among many that lose.
        assert!(!Trial::of(100, &[]).is_gain() && !Trial::of(100, &[0.2, 0.2, 0.2]).is_gain());
        assert!(!Trial::of(100, &[-0.3, -0.2, 4.0, -0.4, -0.2]).is_gain());
        // In a checkpoint and back, to the bit.
        assert_eq!(Trial::from_numbers(&sure.numbers()), Some(sure));
        assert_eq!((Trial::from_numbers(&[]), sure.verdict()), (None, By::Photos(sure)));
        assert_eq!([100, 400, 1500, 30_000].map(|n| Trial::steps(n, 21)), [None, Some(100), Some(375), Some(525)]);
        let words = |by, points| Refining { common: Common { observations: 2 * points, points }, by }.words();
        assert!(words(By::Nothing(Some(sure)), 8).contains("16 observations of 8 common points are too few"));
        assert!(words(By::Nothing(None), 0).contains("too few steps") && words(By::Photos(sure), 0).contains("+0.50"));
    }
}
