//! The user's ledger: every record that this user's Orb made, one envelope a line, each naming the one before.
//!
//! Beside it stands `head.json`, the signed checkpoint of its end with the right edge of its Merkle tree: appending
//! reads that and the last line, not the whole file, and a ledger whose end was cut off no longer fits it. Whoever can
//! write both files can still cut both: only a checkpoint kept elsewhere shows that.

mod head;
mod lines;
mod trail;

use std::fs::{File, OpenOptions};
use std::io::{BufReader, Seek as _, SeekFrom};
use std::path::{Path, PathBuf};

use super::checkpoint::{self, Proof};
use super::data_folder::DataFolder;
use super::disk::{self, Disk};
use super::dsse::Envelope;
use super::keys::SigningKey;
use super::merkle::Frontier;
use super::record::Sealed;
use super::statement::{Chain, GENESIS, Statement};
use crate::{Error, Result};
use head::Head;
pub(super) use head::checkpoint_beside;
pub(super) use lines::read_line_limited;
use lines::{line_before, set_partial_line_aside};
pub use trail::Trail;

/// An append-only file of records.
#[derive(Clone, Debug)]
pub struct Ledger {
    path: PathBuf,
    disk: Disk,
}

/// A record that stands durably in a ledger. Only an append makes one, and without one nothing is published: see
/// [`super::Publication::seal`].
#[derive(Clone, Debug)]
pub struct Recorded(Sealed);

impl Recorded {
    pub fn into_sealed(self) -> Sealed {
        self.0
    }
}

impl std::ops::Deref for Recorded {
    type Target = Sealed;
    fn deref(&self) -> &Sealed {
        &self.0
    }
}

/// Where a ledger ends: what the next record follows.
#[derive(Debug)]
struct End {
    tree: Frontier,
    /// The last record, if there is one.
    last: Option<Statement>,
    /// The file's length, bytes.
    bytes: u64,
}

/// A ledger's file, locked, and where it ends.
struct Opened {
    existed: bool,
    file: File,
    end: End,
}

impl Ledger {
    /// Opens `ledger/orb-ledger.jsonl` of the user's data folder, making the folder.
    ///
    /// # Errors
    /// [`crate::Kind::Environment`] when the folder cannot be made.
    pub fn open(data: &DataFolder) -> Result<Ledger> {
        Ok(Ledger::at(data.subfolder("ledger")?.join("orb-ledger.jsonl")))
    }

    /// The ledger in this file, which need not exist.
    pub fn at(path: PathBuf) -> Ledger {
        Ledger { path, disk: Disk::default() }
    }

    #[cfg(test)]
    pub(super) fn with_disk(self, disk: Disk) -> Ledger {
        Ledger { disk, ..self }
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Appends the record that `make` builds for the next place in the chain. `stage` gets it together with the proof
    /// that it stands in the ledger, before it does: what `stage` cannot write is not appended. When this returns, the
    /// record is on the disk. Other runs wait meanwhile.
    ///
    /// # Errors
    /// [`crate::Kind::Integrity`] when the ledger does not end as it did: nothing is appended to a broken chain.
    pub fn append(
        &mut self,
        key: &SigningKey,
        make: impl FnOnce(Option<Chain>) -> Result<Sealed>,
        stage: impl FnOnce(&Sealed, &Proof) -> Result<()>,
    ) -> Result<Recorded> {
        let opened = self.open_at_end()?;
        self.append_to(opened, key, make, stage).map(|(sealed, _)| sealed)
    }

    /// Waits for its turn and finds the end. The lock goes with the file.
    fn open_at_end(&self) -> Result<Opened> {
        let existed = self.path.exists();
        let mut file = self.open_locked()?;
        set_partial_line_aside(&mut file, &self.path)?;
        let end = self.end(&mut file)?;
        Ok(Opened { existed, file, end })
    }

    /// The record, and the ledger as it ends now, still locked.
    fn append_to(
        &self,
        Opened { existed, mut file, end }: Opened,
        key: &SigningKey,
        make: impl FnOnce(Option<Chain>) -> Result<Sealed>,
        stage: impl FnOnce(&Sealed, &Proof) -> Result<()>,
    ) -> Result<(Recorded, Opened)> {
        let next = end.last.as_ref().map(chain_after).transpose().map_err(|why| self.broken(why))?;
        let sealed = make(next)?;
        self.keep_chain(key)?;
        let proof = Proof::of_next(&end.tree, &sealed, key)?;
        stage(&sealed, &proof)?;
        let line = sealed.envelope.to_line();
        if let Err(error) = self.disk.append(&mut file, &line) {
            // Half a line must not stand before the next record.
            let _ = file.set_len(end.bytes);
            return Err(disk::write_error(&self.path, line.len(), &error));
        }
        if !existed && let Some(folder) = self.path.parent() {
            self.disk.sync_dir(folder)?;
        }
        // The record stands. A head that lags behind is brought up by the next append.
        let (mut tree, bytes) = (end.tree, end.bytes + line.len() as u64);
        if let Some(leaf) = checkpoint::record_leaf(&sealed.trail_hash) {
            tree.push(leaf);
            let _ = Head::of(&tree, bytes, &proof).save(&self.head_path(), &self.disk);
        }
        let end = End { tree, last: Some(sealed.statement.clone()), bytes };
        Ok((Recorded(sealed), Opened { existed: true, file, end }))
    }

    /// A checkpoint of the ledger as it stands, for keeping elsewhere; `None` for a ledger without records.
    ///
    /// # Errors
    /// As [`Ledger::append`].
    pub fn checkpoint(&self) -> Result<Option<checkpoint::Checkpoint>> {
        if !self.path.exists() {
            return Ok(None);
        }
        let Opened { end, .. } = self.open_at_end()?;
        Ok(end.last.map(|last| checkpoint::Checkpoint::of(&end.tree, &last)))
    }

    /// Appends the last record that `make` builds and moves the ledger and its head into `folder`, which must be new: under
    /// one lock, so that no record comes between. The next record begins a new ledger.
    ///
    /// # Errors
    /// [`crate::Kind::Incomplete`] without a record to close; [`crate::Kind::Environment`] when the files cannot be moved;
    /// else as [`Ledger::append`].
    pub(super) fn close_into(
        &self,
        folder: &Path,
        key: &SigningKey,
        make: impl FnOnce(Option<Chain>) -> Result<Sealed>,
    ) -> Result<checkpoint::Checkpoint> {
        let nothing = || {
            Error::incomplete(self.path.display().to_string())
                .expected("a ledger with at least one record")
                .found("none")
                .advice("There is nothing to archive.")
        };
        if !self.path.exists() {
            return Err(nothing());
        }
        let opened = self.open_at_end()?;
        if opened.end.last.is_none() {
            return Err(nothing());
        }
        // Before the record: where nothing can be moved to, nothing is closed.
        self.disk.create_dir(folder)?;
        let (closed, locked) = self.append_to(opened, key, make, |_, _| Ok(())).inspect_err(|_| {
            let _ = self.disk.remove_dir(folder);
        })?;
        let moved = folder.join(self.path.file_name().unwrap_or_default());
        // The head first: a kill between the two leaves a ledger without a head, which the next append makes anew.
        if self.head_path().exists() {
            self.disk.rename(&self.head_path(), &folder.join("head.json"))?;
        }
        let chains = chains_beside(&self.path);
        if chains.is_dir() {
            self.disk.rename(&chains, &folder.join("chains"))?;
        }
        self.disk.rename(&self.path, &moved)?;
        for folder in [Some(folder), self.path.parent()].into_iter().flatten() {
            self.disk.sync_dir(folder)?;
        }
        Ok(checkpoint::Checkpoint::of(&locked.end.tree, &closed.statement))
    }

    /// The certificates of the key, beside the ledger: what it signs here is verified from here.
    fn keep_chain(&self, key: &SigningKey) -> Result<()> {
        let Some(chain) = key.chain() else { return Ok(()) };
        let folder = chains_beside(&self.path);
        let path = folder.join(format!("{}.pem", chain.sha256().concat().get(..64).unwrap_or_default()));
        if path.is_file() {
            return Ok(());
        }
        self.disk.create_dir_all(&folder)?;
        // What a killed run left.
        let draft = path.with_extension("new");
        let _ = std::fs::remove_file(&draft);
        self.disk.write_new(&draft, chain.to_pem().as_bytes())?;
        self.disk.rename(&draft, &path)
    }

    fn head_path(&self) -> PathBuf {
        self.path.with_file_name("head.json")
    }

    fn open_locked(&self) -> Result<File> {
        let io = |e: std::io::Error| Error::io(&self.path, &e);
        let mut options = OpenOptions::new();
        options.read(true).append(true).create(true);
        #[cfg(unix)]
        {
            use std::os::unix::fs::OpenOptionsExt as _;
            options.mode(0o600);
        }
        loop {
            let file = options.open(&self.path).map_err(io)?;
            // Released when the file is closed, also by a kill.
            file.lock().map_err(io)?;
            // While this run waited, another may have archived the file: then the lock is on the wrong one.
            if is_still_at(&file, &self.path) {
                return Ok(file);
            }
        }
    }

    /// Where the file ends, from its head and the lines that the head does not know yet.
    fn end(&self, file: &mut File) -> Result<End> {
        let io = |e: std::io::Error| Error::io(&self.path, &e);
        let bytes = file.metadata().map_err(io)?.len();
        let (mut tree, from) = match Head::load(&self.head_path())? {
            None => (Frontier::default(), 0),
            Some(head) if head.bytes > bytes => {
                return Err(self.broken(format!(
                    "TRUNCATED: {bytes} bytes, but its head knows {} records in {} bytes",
                    head.tree.size(),
                    head.bytes
                )));
            }
            Some(head) => (head.tree, head.bytes),
        };
        let known = tree.size();
        let mut last = None;
        if from > 0 {
            let line = line_before(file, from).map_err(io)?;
            let statement = self.read_line(&line)?;
            if statement.predicate.chain.seq + 1 != known {
                return Err(self.broken("HEAD_FORK: the head's last record is another one".into()));
            }
            last = Some(statement);
        }
        file.seek(SeekFrom::Start(from)).map_err(io)?;
        let mut reader = BufReader::new(&mut *file);
        let mut line = Vec::new();
        while read_line_limited(&mut reader, &mut line).map_err(io)? {
            let statement = self.read_line(&line)?;
            self.check_follows(last.as_ref(), &statement)?;
            let leaf = statement.predicate.trail_hash.as_deref().and_then(checkpoint::record_leaf);
            tree.push(leaf.ok_or_else(|| self.broken("a record without a trail hash".into()))?);
            last = Some(statement);
        }
        Ok(End { tree, last, bytes })
    }

    /// The record on `line`, its trail hash and its spelling checked.
    fn read_line(&self, line: &[u8]) -> Result<Statement> {
        let envelope = Envelope::parse(line).map_err(|f| self.broken(format!("{}: {}", f.code(), f.detail())))?;
        let (statement, canonical, trail_hash) = Statement::parse_and_hash(&envelope.payload)
            .map_err(|f| self.broken(format!("{}: {}", f.code(), f.detail())))?;
        if !canonical || statement.predicate.trail_hash.as_ref() != Some(&trail_hash) {
            return Err(self.broken("TRAIL_HASH_MISMATCH".into()));
        }
        Ok(statement)
    }

    fn check_follows(&self, before: Option<&Statement>, after: &Statement) -> Result<()> {
        match follows(before, after) {
            None => Ok(()),
            Some(code) => Err(self.broken(format!("{code} at record {}", after.predicate.chain.seq))),
        }
    }

    fn broken(&self, found: String) -> Error {
        Error::integrity(self.path.display().to_string())
            .expected("a chain of records that ends as it did after the last run")
            .found(found)
            .advice(
                "The ledger was changed outside Orb, so nothing was published. Keep the file for whoever looks into it, \
                 and move its folder away to begin a new ledger. `orb audit ledger verify` says more.",
            )
    }

    /// All records in order, for tools that look at a whole chain in memory.
    ///
    /// # Errors
    /// [`crate::Kind::Integrity`] at the first line that does not follow from the one before.
    pub fn read_chain(&self) -> Result<Vec<Statement>> {
        let bytes = std::fs::read(&self.path).map_err(|e| Error::io(&self.path, &e))?;
        let mut records: Vec<Statement> = Vec::new();
        for line in bytes.split_inclusive(|b| *b == b'\n') {
            let statement = self.read_line(line)?;
            self.check_follows(records.last(), &statement)?;
            records.push(statement);
        }
        Ok(records)
    }
}

/// Where the certificates stand of those who signed a ledger.
pub fn chains_beside(ledger: &Path) -> PathBuf {
    ledger.with_file_name("chains")
}

/// How `after` fails to be the record that follows `before`; `None` when it is.
pub(super) fn follows(before: Option<&Statement>, after: &Statement) -> Option<&'static str> {
    let found = &after.predicate.chain;
    let Some(before) = before else {
        return (found.seq != 0 || found.prev != GENESIS).then_some("CHAIN_BROKEN");
    };
    let chain = &before.predicate.chain;
    if found.ledger_id != chain.ledger_id {
        Some("LEDGER_ID")
    } else if found.seq != chain.seq + 1 {
        Some("SEQ_GAP")
    } else {
        (before.predicate.trail_hash.as_ref() != Some(&found.prev)).then_some("CHAIN_BROKEN")
    }
}

fn chain_after(last: &Statement) -> Result<Chain, String> {
    let chain = &last.predicate.chain;
    let prev = last.predicate.trail_hash.clone().ok_or("a record without a trail hash")?;
    Ok(Chain { ledger_id: chain.ledger_id.clone(), seq: chain.seq + 1, prev })
}

#[cfg(unix)]
fn is_still_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    let same = |a: std::fs::Metadata, b: std::fs::Metadata| (a.dev(), a.ino()) == (b.dev(), b.ino());
    file.metadata().is_ok_and(|a| std::fs::metadata(path).is_ok_and(|b| same(a, b)))
}

/// Elsewhere a file that is open cannot be moved away.
#[cfg(not(unix))]
fn is_still_at(_: &File, _: &Path) -> bool {
    true
}

#[cfg(test)]
pub(crate) mod tests;
