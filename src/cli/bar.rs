//! Progress on a terminal: the stage's name, how far, time left.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::progress::Progress;

/// Draws on standard error, and only where that is a terminal; `stop` is set by the interrupt handler.
pub struct Bar<'a> {
    stop: &'a AtomicBool,
    quiet: bool,
    current: Mutex<Option<ProgressBar>>,
}

impl<'a> Bar<'a> {
    pub fn new(stop: &'a AtomicBool, quiet: bool) -> Self {
        Bar { stop, quiet, current: Mutex::new(None) }
    }

    pub fn finish(&self) {
        if let Some(bar) = self.lock().take() {
            bar.finish_and_clear();
        }
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Option<ProgressBar>> {
        self.current.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

impl Progress for Bar<'_> {
    fn begin(&self, stage: &'static str, steps: u64) {
        self.finish();
        if self.quiet {
            return;
        }
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
        bar.enable_steady_tick(std::time::Duration::from_millis(200));
        *self.lock() = Some(bar);
    }

    fn step(&self, done: u64) {
        if let Some(bar) = self.lock().as_ref() {
            bar.set_position(done);
        }
    }

    fn cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
