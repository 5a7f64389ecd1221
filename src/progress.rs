//! How long work says how far it is and learns that it must stop.

use crate::{Error, Result};

/// Handed down to every stage that takes longer than a second.
pub trait Progress: Sync {
    /// A stage of `steps` equal steps begins; 0 when unknown.
    fn begin(&self, stage: &'static str, steps: u64);
    /// `done` steps of the current stage are behind us.
    fn step(&self, done: u64);
    /// True once the user asked to stop.
    fn cancelled(&self) -> bool;
    /// For `?` in loops: an error once the user asked to stop.
    fn check(&self) -> Result<()> {
        if self.cancelled() { Err(Error::cancelled()) } else { Ok(()) }
    }
}

/// Says nothing, never stops: for tests and the library's simplest callers.
pub struct Silent;

impl Progress for Silent {
    fn begin(&self, _: &'static str, _: u64) {}
    fn step(&self, _: u64) {}
    fn cancelled(&self) -> bool {
        false
    }
}
