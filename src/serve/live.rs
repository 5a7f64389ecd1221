//! What changes too often for the disk: how far the running job is, and a bell that rings whenever anything changes.

use std::sync::{Condvar, Mutex};
use std::time::Duration;

use serde::{Deserialize, Serialize};
use tokio::sync::watch;
use utoipa::ToSchema;

use super::lock;

/// Where a run is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Progress {
    pub stage: String,
    /// Of the stage, 0 to 1; none while unknown.
    pub fraction: Option<f64>,
    /// Of the stage.
    pub seconds_left: Option<f64>,
}

#[derive(Clone, Debug)]
pub struct Running {
    pub id: String,
    pub progress: Option<Progress>,
    pub cancelled: bool,
}

pub struct Live {
    bell: watch::Sender<u64>,
    running: Mutex<Option<Running>>,
    /// Something may be there to run.
    work: (Mutex<bool>, Condvar),
}

impl Default for Live {
    fn default() -> Self {
        Live { bell: watch::channel(0).0, running: Mutex::new(None), work: (Mutex::new(true), Condvar::new()) }
    }
}

impl Live {
    /// Something has changed.
    pub fn ring(&self) {
        self.bell.send_modify(|n| *n = n.wrapping_add(1));
    }

    pub fn listen(&self) -> watch::Receiver<u64> {
        self.bell.subscribe()
    }

    pub fn begin(&self, id: &str) {
        *lock(&self.running) = Some(Running { id: id.to_owned(), progress: None, cancelled: false });
        self.ring();
    }

    pub fn end(&self) {
        *lock(&self.running) = None;
        self.ring();
    }

    pub fn progress(&self, progress: Progress) {
        if let Some(running) = lock(&self.running).as_mut() {
            running.progress = Some(progress);
        }
        self.ring();
    }

    pub fn progress_of(&self, id: &str) -> Option<Progress> {
        lock(&self.running).as_ref().filter(|r| r.id == id).and_then(|r| r.progress.clone())
    }

    /// Tells the run to stop; false where it is not this one that runs.
    pub fn cancel(&self, id: &str) -> bool {
        let mut running = lock(&self.running);
        let Some(running) = running.as_mut().filter(|r| r.id == id) else { return false };
        running.cancelled = true;
        true
    }

    pub fn is_cancelled(&self) -> bool {
        lock(&self.running).as_ref().is_some_and(|r| r.cancelled)
    }

    /// Wakes the runner.
    pub fn call(&self) {
        *lock(&self.work.0) = true;
        self.work.1.notify_all();
    }

    /// Returns when called, and every so often.
    pub fn wait_for_work(&self, at_most: Duration) {
        let guard = lock(&self.work.0);
        let waited = self.work.1.wait_timeout_while(guard, at_most, |called| !*called);
        let (mut called, _) = waited.unwrap_or_else(std::sync::PoisonError::into_inner);
        *called = false;
    }
}
