//! `orb serve`: jobs for several people, kept on this machine.
//!
//! The way of a job: [`api`] takes it in (who may, [`account`], [`role`], [`session`]; what, [`submission`]), [`database`]
//! keeps it, [`runner`] runs `orb geo` as a process of its own in the job's folder, [`live`] says how far it is, [`files`]
//! hands out what was published. [`recorder`] writes what has to be answered for into the ledger.

pub mod account;
pub mod administration;
pub mod api;
pub mod clients;
pub mod database;
pub mod files;
pub mod live;
pub mod place;
pub mod recorder;
pub mod refusal;
pub mod revocation;
pub mod role;
pub mod runner;
pub mod session;
pub mod submission;
#[cfg(test)]
mod tests;
pub mod tls;
pub mod viewers;

use std::sync::{Arc, Mutex};

use tokio::sync::Semaphore;

use crate::audit::{Marking, Trail};
use database::Database;
use live::Live;
use place::Place;
use recorder::Recorder;
use session::Sessions;
use viewers::Viewers;

/// Milliseconds since 1970.
pub type Clock = Arc<dyn Fn() -> u64 + Send + Sync>;

/// What a server takes at most.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Jobs that wait.
    pub queue: u64,
    /// Jobs of one account that wait or run.
    pub queue_each: u64,
    /// Bytes of one photo.
    pub upload: u64,
    /// Bytes of one submission.
    pub submission: u64,
    /// Pixels of one photo.
    pub pixels: u64,
    /// Photos of one submission.
    pub photos: usize,
    /// Bytes of all jobs together.
    pub stored: u64,
    /// Starts of one job: it is put back when the server or the run was killed.
    pub attempts: u32,
    /// Seconds that a run may take.
    pub seconds: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            queue: 1000,
            queue_each: 1000,
            upload: 64 << 20,
            submission: 512 << 20,
            pixels: 100_000_000,
            photos: 100,
            stored: 20 << 30,
            attempts: 3,
            seconds: 3600,
        }
    }
}

/// All that the routes and the runner know.
pub struct Server {
    pub database: Database,
    pub place: Place,
    pub sessions: Sessions,
    pub live: Live,
    pub recorder: Recorder,
    /// What was read of the recorder's ledger.
    pub trail: Mutex<Trail>,
    pub viewers: Viewers,
    pub limits: Limits,
    /// Nothing above it is taken in or shown.
    pub ceiling: Marking,
    /// What is marked above UNCLASSIFIED can be signed.
    pub has_key: bool,
    /// Names that this server is called by, beside `localhost` and addresses.
    pub names: Vec<String>,
    /// Cookies travel under TLS alone.
    pub encrypted: bool,
    /// It is this server itself that speaks it.
    pub tls: bool,
    pub clock: Clock,
    pub counts: api::metrics::Counts,
    /// Submissions being taken in, downloads and streams of events under way, verifications.
    pub uploads: Arc<Semaphore>,
    pub downloads: Arc<Semaphore>,
    pub streams: Arc<Semaphore>,
    pub checks: Arc<Semaphore>,
}

impl Server {
    pub fn now(&self) -> u64 {
        (self.clock)()
    }
}

/// This many random bytes.
///
/// # Errors
/// Environment, without random numbers.
pub(crate) fn random<const N: usize>() -> crate::Result<[u8; N]> {
    let mut bytes = [0; N];
    getrandom::fill(&mut bytes).map_err(|e| crate::Error::environment("random numbers").found(e.to_string()))?;
    Ok(bytes)
}

/// As [`std::sync::Mutex::lock`]; what a panicking thread left is whole, since every change of ours is one assignment or
/// one transaction.
pub(crate) fn lock<T>(mutex: &std::sync::Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}
