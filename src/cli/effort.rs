//! How long a reconstruction works: a quality or a number of steps, as steps of the optimisation and limits of time.

use std::time::{Duration, Instant};

use clap::{Args, ValueEnum};

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Quality {
    /// A look at the result, sooner.
    Draft,
    Standard,
    /// As long as it takes.
    High,
}

#[derive(Args, Clone, Debug)]
pub struct EffortArgs {
    #[arg(long, value_enum, default_value = "standard")]
    pub quality: Quality,

    /// Optimisation steps, in place of what the quality and this machine's cores suggest.
    #[arg(long, value_name = "N")]
    pub iterations: Option<u32>,
}

/// What keeps a run inside its time.
#[derive(Clone, Copy)]
pub struct Limits {
    /// For the optimisation; decides the number of steps beforehand.
    pub optimise: Duration,
    /// End of the optimisation: for machines that slow down on the way.
    pub deadline: Instant,
}

impl EffortArgs {
    /// Optimisation steps wanted for one photo or `several`, on a GPU or on so many threads. Where they fit the time, like machines
    /// do the same number, and two runs are alike.
    pub fn steps(&self, several: bool, threads: usize, gpu: bool) -> u32 {
        if let Some(steps) = self.iterations {
            return steps;
        }
        // Of one photo twice as many show what was held back better by a quarter of a decibel, on a GPU hardly (docs/performance.md, One photo).
        let share = if gpu { 4.0 } else { (threads as f64 / 2.0).clamp(0.5, 8.0) };
        match (self.quality, several || gpu) {
            (Quality::Draft, false) => 150,
            (Quality::Draft, true) => (250.0 * share) as u32,
            (Quality::Standard, false) => 450,
            (Quality::Standard, true) => (900.0 * share) as u32,
            (Quality::High, _) => 7000,
        }
    }

    /// Of a run that began at `started`. Who names a number of steps gets them, however long they take.
    pub fn limits(&self, started: Instant) -> Option<Limits> {
        let (optimise, whole) = match (self.iterations, self.quality) {
            (Some(_), _) | (None, Quality::High) => return None,
            (None, Quality::Draft) => (10, 20),
            (None, Quality::Standard) => (28, 40),
        };
        Some(Limits { optimise: Duration::from_secs(optimise), deadline: started + Duration::from_secs(whole) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(quality: Quality) -> EffortArgs {
        EffortArgs { quality, iterations: None }
    }

    #[test]
    fn one_photo_takes_as_many_steps_on_any_processor_and_several_more() {
        let standard = of(Quality::Standard);
        for threads in [1, 2, 16] {
            assert_eq!(standard.steps(false, threads, false), 450);
        }
        assert_eq!(standard.steps(true, 2, false), 900);
        assert_eq!(standard.steps(true, 16, false), 7200);
        assert_eq!(standard.steps(false, 2, true), 3600);
        let steps = |quality| of(quality).steps(false, 2, false);
        assert!(steps(Quality::Draft) < steps(Quality::Standard) && steps(Quality::Standard) < steps(Quality::High));
    }

    #[test]
    fn a_number_of_steps_is_kept_to_without_a_limit_and_high_quality_has_none() {
        let now = Instant::now();
        let named = EffortArgs { iterations: Some(30), ..of(Quality::Draft) };
        assert_eq!(named.steps(true, 16, true), 30);
        assert!(named.limits(now).is_none() && of(Quality::High).limits(now).is_none());
        let (draft, standard) = (of(Quality::Draft).limits(now).unwrap(), of(Quality::Standard).limits(now).unwrap());
        assert!(draft.optimise < standard.optimise && draft.deadline < standard.deadline);
        assert!(now + standard.optimise < standard.deadline);
    }
}
