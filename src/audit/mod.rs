//! Marking, record, seal, verification, and the only door to the user's folders.
//!
//! A run hands its outputs to a [`Publication`], one by one, and what it knows about itself as a [`RecordDraft`];
//! sealing hashes, signs, appends to the ledger and publishes. [`verify`] checks a published folder offline. What
//! comes out is evidence for an assessment, never the assessment.

pub mod allowed;
pub mod archive;
pub mod by_hand;
pub mod canonical;
pub mod checkpoint;
pub mod data_folder;
pub(crate) mod disk;
#[cfg(test)]
mod doors;
pub mod dsse;
pub mod events;
pub mod evidence;
pub mod file_lock;
pub mod inband;
pub mod interchange;
pub mod invocation;
pub mod keys;
pub mod ledger;
pub mod ledger_check;
pub mod marking;
pub mod merkle;
pub(crate) mod pem;
pub mod program;
pub mod publication;
pub mod record;
mod record_check;
pub mod report;
pub mod sbom;
pub mod statement;
pub mod store_merge;
#[cfg(test)]
mod tamper_corpus;
pub mod time;
pub mod timestamp;
pub mod trust;
pub mod verify;

pub use data_folder::DataFolder;
pub use keys::{KeyForRun, SigningKey};
pub use ledger::{Ledger, Trail};
pub use marking::Marking;
pub use publication::{Destination, Publication, Published};
pub use record::RecordDraft;
pub use record_check::Policy;
pub use store_merge::{PreparedMerge, StoreLock, lock_store, merge_into_store, recover};
pub use time::TimeReading;
pub use trust::TrustStore;
