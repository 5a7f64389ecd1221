//! Progress on a terminal: the stage's name, how far, time left. Or the same for a program, a line each time.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::progress::Progress;

/// How progress is said on standard error.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Say {
    /// A bar, where standard error is a terminal
    #[default]
    Bar,
    /// A line of JSON at most five times a second: stage, fraction of it, seconds left of it
    Json,
}

/// Between two lines of JSON of one stage.
const PAUSE: Duration = Duration::from_millis(200);

/// Draws on standard error, and only where that is a terminal; `stop` is set by the interrupt handler.
pub struct Bar<'a> {
    stop: &'a AtomicBool,
    shown: Shown,
}

enum Shown {
    Nothing,
    Bar(Mutex<Option<ProgressBar>>),
    Lines(Mutex<Option<Stage>>),
}

struct Stage {
    name: &'static str,
    steps: u64,
    began: Instant,
    said: Instant,
}

impl Stage {
    fn say(&self, done: u64) {
        let fraction = (self.steps > 0).then(|| (done as f64 / self.steps as f64).clamp(0.0, 1.0));
        let left = fraction.filter(|f| *f > 0.0).map(|f| self.began.elapsed().as_secs_f64() * (1.0 - f) / f);
        let rounded = |v: Option<f64>| v.map(|v| (v * 1e3).round() / 1e3);
        let line = serde_json::json!({
            "progress": {"stage": self.name, "fraction": rounded(fraction), "seconds_left": rounded(left)}
        });
        eprintln!("{line}");
    }
}

impl<'a> Bar<'a> {
    pub fn new(stop: &'a AtomicBool, quiet: bool) -> Self {
        Bar { stop, shown: if quiet { Shown::Nothing } else { Shown::Bar(Mutex::default()) } }
    }

    /// As `say` wants it; `quiet` silences bars alone, since lines are asked for.
    pub fn saying(say: Say, stop: &'a AtomicBool, quiet: bool) -> Self {
        match say {
            Say::Bar => Bar::new(stop, quiet),
            Say::Json => Bar { stop, shown: Shown::Lines(Mutex::default()) },
        }
    }

    pub fn finish(&self) {
        if let Shown::Bar(current) = &self.shown
            && let Some(bar) = lock(current).take()
        {
            bar.finish_and_clear();
        }
    }
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}

fn bar(stage: &'static str, steps: u64) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(steps), ProgressDrawTarget::stderr());
    let template = if steps == 0 {
        "{spinner} {msg:<28} {elapsed}"
    } else {
        "{spinner} {msg:<28} [{bar:30}] {pos}/{len}  {eta} left"
    };
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style.progress_chars("=> "));
    }
    bar.set_message(stage);
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

impl Progress for Bar<'_> {
    fn begin(&self, stage: &'static str, steps: u64) {
        self.finish();
        match &self.shown {
            Shown::Nothing => {}
            Shown::Bar(current) => *lock(current) = Some(bar(stage, steps)),
            Shown::Lines(current) => {
                let now = Instant::now();
                let stage = Stage { name: stage, steps, began: now, said: now };
                stage.say(0);
                *lock(current) = Some(stage);
            }
        }
    }

    fn step(&self, done: u64) {
        match &self.shown {
            Shown::Nothing => {}
            Shown::Bar(current) => {
                if let Some(bar) = lock(current).as_ref() {
                    bar.set_position(done);
                }
            }
            Shown::Lines(current) => {
                if let Some(stage) = lock(current).as_mut().filter(|s| s.said.elapsed() >= PAUSE) {
                    stage.said = Instant::now();
                    stage.say(done);
                }
            }
        }
    }

    fn cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
