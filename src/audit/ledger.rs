//! The user's ledger: every record that this user's Orb made, one envelope a line, each naming the one before.
//!
//! A chain alone cannot show that its tail was cut: only a copy of its head kept elsewhere can.

use std::fs::{File, OpenOptions};
use std::io::{Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

use super::data_folder::DataFolder;
use super::disk::{self, Disk};
use super::dsse::{Envelope, MAX_ENVELOPE_BYTES};
use super::record::Sealed;
use super::statement::{Chain, Statement};
use crate::{Error, Result};

/// An append-only file of records.
#[derive(Clone, Debug)]
pub struct Ledger {
    path: PathBuf,
    disk: Disk,
}

impl Ledger {
    /// Opens `ledger/orb-ledger.jsonl` of the user's data folder, making the folder.
    ///
    /// # Errors
    /// [`crate::Kind::Environment`] when the folder cannot be made.
    pub fn open(data: &DataFolder) -> Result<Ledger> {
        Ok(Ledger { path: data.subfolder("ledger")?.join("orb-ledger.jsonl"), disk: Disk::default() })
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Appends the record that `make` builds for the next place in the chain. When this returns, the record is on
    /// the disk. Other runs wait meanwhile.
    ///
    /// # Errors
    /// [`crate::Kind::Integrity`] when the ledger's last line is not a record: nothing is appended to a broken chain.
    pub fn append(&mut self, make: impl FnOnce(Option<Chain>) -> Result<Sealed>) -> Result<Sealed> {
        let path = &self.path;
        let io = |e: std::io::Error| Error::io(path, &e);
        let existed = path.exists();
        let mut options = OpenOptions::new();
        options.read(true).append(true).create(true);
        #[cfg(unix)]
        {
            use std::os::unix::fs::OpenOptionsExt as _;
            options.mode(0o600);
        }
        let mut file = options.open(path).map_err(io)?;
        // Released when the file is closed, also by a kill.
        file.lock().map_err(io)?;
        set_partial_line_aside(&mut file, path)?;
        let next = match last_line(&mut file).map_err(io)? {
            None => None,
            Some(line) => Some(self.after(&line)?),
        };
        let sealed = make(next)?;
        let line = sealed.envelope.to_line();
        let length = file.metadata().map_err(io)?.len();
        let written = file.write_all(&line).and_then(|()| file.sync_all());
        if let Err(error) = written {
            // Half a line must not stand before the next record.
            let _ = file.set_len(length);
            return Err(disk::write_error(path, line.len(), &error));
        }
        if !existed && let Some(folder) = path.parent() {
            self.disk.sync_dir(folder)?;
        }
        Ok(sealed)
    }

    /// The place after the record on `line`.
    fn after(&self, line: &[u8]) -> Result<Chain> {
        let broken = |found: String| {
            Error::integrity(self.path.display().to_string())
                .expected("a record on the ledger's last line")
                .found(found)
                .advice(
                    "The ledger was changed outside Orb, so nothing was published. Keep the file for whoever looks \
                     into it, and move it away to begin a new ledger.",
                )
        };
        let envelope = Envelope::parse(line).map_err(|f| broken(format!("{}: {}", f.code(), f.detail())))?;
        let (statement, canonical) =
            Statement::parse(&envelope.payload).map_err(|f| broken(format!("{}: {}", f.code(), f.detail())))?;
        let trail_hash = statement.trail_hash().map_err(|f| broken(f.detail().to_owned()))?;
        if !canonical || statement.predicate.trail_hash.as_ref() != Some(&trail_hash) {
            return Err(broken("TRAIL_HASH_MISMATCH".into()));
        }
        let chain = statement.predicate.chain;
        Ok(Chain { ledger_id: chain.ledger_id, seq: chain.seq + 1, prev: trail_hash })
    }

    /// All records in order: for tests and for tools that look at the whole chain.
    ///
    /// # Errors
    /// [`crate::Kind::Integrity`] at the first line that does not follow from the one before.
    pub fn read_chain(&self) -> Result<Vec<Statement>> {
        let bytes = std::fs::read(&self.path).map_err(|e| Error::io(&self.path, &e))?;
        let mut records: Vec<Statement> = Vec::new();
        let mut expected: Option<Chain> = None;
        for (number, line) in bytes.split_inclusive(|b| *b == b'\n').enumerate() {
            let next = self.after(line)?;
            let envelope = Envelope::parse(line).map_err(|f| Error::integrity(f.detail()))?;
            let (statement, _) = Statement::parse(&envelope.payload).map_err(|f| Error::integrity(f.detail()))?;
            let found = &statement.predicate.chain;
            let wrong = match &expected {
                None => (found.seq != 0 || found.prev != super::statement::GENESIS).then_some("CHAIN_BROKEN"),
                Some(e) if found.ledger_id != e.ledger_id => Some("LEDGER_ID"),
                Some(e) if found.seq != e.seq => Some("SEQ_GAP"),
                Some(e) if found.prev != e.prev => Some("CHAIN_BROKEN"),
                Some(_) => None,
            };
            if let Some(code) = wrong {
                return Err(Error::integrity(self.path.display().to_string())
                    .expected("each record to follow the one before")
                    .found(format!("{code} at line {}", number + 1)));
            }
            records.push(statement);
            expected = Some(next);
        }
        Ok(records)
    }
}

/// A line without its end was never acknowledged and nothing was published with it: a crash, not tampering. It is
/// moved to `orb-ledger.incomplete`, not thrown away.
fn set_partial_line_aside(file: &mut File, path: &Path) -> Result<()> {
    let io = |e: std::io::Error| Error::io(path, &e);
    let length = file.metadata().map_err(io)?.len();
    let tail = tail(file, length).map_err(io)?;
    let keep = tail.iter().rposition(|b| *b == b'\n').map_or(0, |i| i + 1);
    let partial = &tail[keep..];
    if partial.is_empty() {
        return Ok(());
    }
    if keep == 0 && length > tail.len() as u64 {
        return Err(Error::integrity(path.display().to_string()).found("LIMIT_EXCEEDED: a line longer than any record"));
    }
    let aside_path = path.with_extension("incomplete");
    let mut aside =
        OpenOptions::new().create(true).append(true).open(&aside_path).map_err(|e| Error::io(&aside_path, &e))?;
    aside
        .write_all(partial)
        .and_then(|()| aside.write_all(b"\n"))
        .and_then(|()| aside.sync_all())
        .map_err(|e| Error::io(&aside_path, &e))?;
    file.set_len(length - partial.len() as u64).and_then(|()| file.sync_all()).map_err(io)
}

/// The last bytes of the file: enough for the longest line, the end of the one before, and a partial one.
fn tail(file: &mut File, length: u64) -> std::io::Result<Vec<u8>> {
    let window = (MAX_ENVELOPE_BYTES as u64 + 2).min(length);
    file.seek(SeekFrom::Start(length - window))?;
    let mut bytes = Vec::new();
    (&mut *file).take(window).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn last_line(file: &mut File) -> std::io::Result<Option<Vec<u8>>> {
    let length = file.metadata()?.len();
    let bytes = tail(file, length)?;
    let Some(body) = bytes.strip_suffix(b"\n") else { return Ok(None) };
    let start = body.iter().rposition(|b| *b == b'\n').map_or(0, |i| i + 1);
    Ok(Some(body[start..].to_vec()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kind;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::record::{self, tests::draft};
    use crate::audit::statement::Outcome;

    fn append(ledger: &mut Ledger) -> Result<Sealed> {
        ledger.append(|place| record::seal(&draft(), Vec::new(), Outcome::Success, None, place, shared_key()))
    }

    #[test]
    fn each_record_names_the_one_before() {
        let dir = tempfile::tempdir().unwrap();
        let mut ledger = Ledger::open(&DataFolder::at(dir.path())).unwrap();
        let made: Vec<Sealed> = (0..3).map(|_| append(&mut ledger).unwrap()).collect();
        for (i, pair) in made.windows(2).enumerate() {
            let chain = &pair[1].statement.predicate.chain;
            assert_eq!(chain.seq, i as u64 + 1);
            assert_eq!(chain.prev, pair[0].trail_hash);
            assert_eq!(chain.ledger_id, pair[0].statement.predicate.chain.ledger_id);
        }
        assert_eq!(ledger.read_chain().unwrap().len(), 3);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            assert_eq!(std::fs::metadata(ledger.path()).unwrap().permissions().mode() & 0o777, 0o600);
        }
    }

    #[test]
    fn two_runs_at_once_share_one_chain() {
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path());
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    let mut ledger = Ledger::open(&data).unwrap();
                    for _ in 0..4 {
                        append(&mut ledger).unwrap();
                    }
                });
            }
        });
        assert_eq!(Ledger::open(&data).unwrap().read_chain().unwrap().len(), 16);
    }

    #[test]
    fn a_half_written_line_is_set_aside() {
        let dir = tempfile::tempdir().unwrap();
        let mut ledger = Ledger::open(&DataFolder::at(dir.path())).unwrap();
        append(&mut ledger).unwrap();
        let whole = std::fs::read(ledger.path()).unwrap();
        for cut in [whole.len() - 1, whole.len() / 2, 1] {
            for before in [&whole[..], &[]] {
                std::fs::write(ledger.path(), [before, &whole[..cut]].concat()).unwrap();
                append(&mut ledger).unwrap();
                let records = ledger.read_chain().unwrap();
                assert_eq!(records.len(), usize::from(!before.is_empty()) + 1);
            }
        }
        let aside = std::fs::read(ledger.path().with_extension("incomplete")).unwrap();
        assert_eq!(aside.iter().filter(|b| **b == b'\n').count(), 6);
    }

    #[test]
    fn nothing_is_appended_to_a_changed_ledger() {
        let dir = tempfile::tempdir().unwrap();
        let mut ledger = Ledger::open(&DataFolder::at(dir.path())).unwrap();
        append(&mut ledger).unwrap();
        append(&mut ledger).unwrap();
        let good = std::fs::read_to_string(ledger.path()).unwrap();
        let lines: Vec<&str> = good.lines().collect();
        // The payload's base64 is changed inside the last line.
        let mut bad = good.clone().into_bytes();
        let at = lines[0].len() + 1 + 400;
        bad[at] = if bad[at] == b'A' { b'B' } else { b'A' };
        std::fs::write(ledger.path(), &bad).unwrap();
        assert_eq!(append(&mut ledger).unwrap_err().kind, Kind::Integrity);
        assert_eq!(std::fs::read(ledger.path()).unwrap(), bad, "left as it was");
        // The first record deleted, and the order turned round.
        for text in [format!("{}\n", lines[1]), format!("{}\n{}\n", lines[1], lines[0])] {
            std::fs::write(ledger.path(), text).unwrap();
            assert_eq!(ledger.read_chain().unwrap_err().kind, Kind::Integrity);
        }
    }
}
