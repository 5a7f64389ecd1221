//! Closing a ledger: its last record says so, then the whole of it moves away. Nothing is ever pruned.

use std::path::Path;

use super::checkpoint::Checkpoint;
use super::disk::Disk;
use super::invocation::Invocation;
use super::keys::SigningKey;
use super::ledger::Ledger;
use super::ledger_check::CLOSE_EVENT;
use super::marking::Marking;
use super::record::{self, RecordDraft};
use super::statement::Outcome;
use super::time::TimeReading;
use crate::{Error, Result};

/// The checkpoint of the closed ledger, beside it.
pub const CHECKPOINT: &str = "checkpoint.dsse.json";

/// Appends a `ledger.close` record and moves the ledger, with a signed checkpoint of its end, to the new `folder`.
///
/// # Errors
/// [`crate::Kind::Incomplete`] when there is nothing to close; [`crate::Kind::Usage`] when `folder` exists; else as
/// [`Ledger::append`].
pub fn close(
    ledger: Ledger,
    folder: &Path,
    key: &SigningKey,
    by: Invocation,
    time: TimeReading,
    random: [u8; 10],
) -> Result<Checkpoint> {
    if std::fs::symlink_metadata(folder).is_ok() {
        return Err(Error::usage(folder.display().to_string()).expected("a new folder").found("something that exists"));
    }
    let draft =
        RecordDraft::event(CLOSE_EVENT, "orb audit ledger archive", by, time, random, Marking::UNCLASSIFIED.into());
    let seal = |next| record::seal(&draft, Vec::new(), Outcome::Success, None, next, key);
    let checkpoint = ledger.close_into(folder, key, seal)?;
    Disk::default().write_new(&folder.join(CHECKPOINT), &checkpoint.sign(key)?.to_line())?;
    Ok(checkpoint)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kind;
    use crate::audit::DataFolder;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::record::tests::draft;

    #[test]
    fn a_closed_ledger_and_the_one_after_it() {
        let dir = tempfile::tempdir().unwrap();
        let open = || Ledger::open(&DataFolder::at(dir.path().join("data"))).unwrap();
        let folder = dir.path().join("2025");
        let close = || close(open(), &folder, shared_key(), draft().invocation, draft().time, [1; 10]);
        assert_eq!(close().unwrap_err().kind, Kind::Incomplete);
        let append = || {
            let seal = |next| record::seal(&draft(), Vec::new(), Outcome::Success, None, next, shared_key());
            open().append(shared_key(), seal, |_, _| Ok(())).unwrap()
        };
        append();
        append();
        let checkpoint = close().unwrap();
        assert_eq!(checkpoint.size, 3);
        let old = Ledger::at(folder.join("orb-ledger.jsonl")).read_chain().unwrap();
        assert_eq!(old.last().unwrap().predicate.event.kind, CLOSE_EVENT);
        assert!(folder.join(CHECKPOINT).is_file() && folder.join("head.json").is_file());
        let first = append();
        assert_eq!(first.statement.predicate.chain.seq, 0);
        assert_eq!(close().unwrap_err().kind, Kind::Usage, "an archive is never overwritten");
        assert_eq!(open().read_chain().unwrap().len(), 1, "and nothing was closed");
    }
}
