//! The user's ledger: every record that this user's Orb made, one envelope a line, each naming the one before.
//!
//! Beside it stands `head.json`, the signed checkpoint of its end with the right edge of its Merkle tree: appending
//! reads that and the last line, not the whole file, and a ledger whose end was cut off no longer fits it. Whoever can
//! write both files can still cut both: only a checkpoint kept elsewhere shows that.

mod head;

use std::fs::{File, OpenOptions};
use std::io::{BufRead as _, BufReader, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

use super::checkpoint::{self, Proof};
use super::data_folder::DataFolder;
use super::disk::{self, Disk};
use super::dsse::{Envelope, MAX_ENVELOPE_BYTES};
use super::keys::SigningKey;
use super::merkle::Frontier;
use super::record::Sealed;
use super::statement::{Chain, GENESIS, Statement};
use crate::{Error, Result};
use head::Head;
pub(super) use head::checkpoint_beside;

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
pub(super) fn chains_beside(ledger: &Path) -> PathBuf {
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

/// Reads one line with its line feed into `line`; false at the end of the file. A line longer than any record ends at
/// that length, so that it is found to be none.
pub(super) fn read_line_limited(reader: &mut impl std::io::BufRead, line: &mut Vec<u8>) -> std::io::Result<bool> {
    line.clear();
    reader.take(MAX_ENVELOPE_BYTES as u64 + 2).read_until(b'\n', line)?;
    Ok(!line.is_empty())
}

/// The line that ends just before `end`.
fn line_before(file: &mut File, end: u64) -> std::io::Result<Vec<u8>> {
    let bytes = tail(file, end)?;
    let body = bytes.strip_suffix(b"\n").unwrap_or(&bytes);
    let start = body.iter().rposition(|b| *b == b'\n').map_or(0, |i| i + 1);
    Ok(bytes[start..].to_vec())
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

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::Kind;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::record::{self, tests::draft};
    use crate::audit::statement::Outcome;

    fn append(ledger: &mut Ledger) -> Result<Recorded> {
        let seal = |place| record::seal(&draft(), Vec::new(), Outcome::Success, None, place, shared_key());
        ledger.append(shared_key(), seal, |_, _| Ok(()))
    }

    /// Some record that stands in some ledger.
    pub(crate) fn recorded() -> &'static Recorded {
        static RECORDED: std::sync::OnceLock<Recorded> = std::sync::OnceLock::new();
        RECORDED.get_or_init(|| {
            let dir = tempfile::tempdir().unwrap();
            append(&mut Ledger::open(&DataFolder::at(dir.path())).unwrap()).unwrap()
        })
    }

    #[test]
    fn each_record_names_the_one_before() {
        let dir = tempfile::tempdir().unwrap();
        let mut ledger = Ledger::open(&DataFolder::at(dir.path())).unwrap();
        let made: Vec<Recorded> = (0..3).map(|_| append(&mut ledger).unwrap()).collect();
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
                // Of the records that are gone from the file now.
                std::fs::remove_file(ledger.path().with_file_name("head.json")).unwrap();
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

    /// A kill at every step of an append, then a run that goes on: no record is lost that was acknowledged, none
    /// stands there in half, and the head is right again.
    #[test]
    fn a_kill_at_every_step() {
        use crate::audit::disk::fault::Plan;
        for crash_at in 0.. {
            let dir = tempfile::tempdir().unwrap();
            let data = DataFolder::at(dir.path());
            let mut ledger = Ledger::open(&data).unwrap();
            append(&mut ledger).unwrap();
            append(&mut ledger).unwrap();
            let plan = Plan::new(crash_at, true, std::io::ErrorKind::Other);
            let mut failing = ledger.clone().with_disk(Disk { fault: Some(plan.clone()) });
            let acknowledged = append(&mut failing).is_ok();
            append(&mut ledger).unwrap();
            let records = ledger.read_chain().unwrap();
            let last = records.last().unwrap().predicate.chain.seq;
            assert_eq!(last + 1, records.len() as u64);
            assert!(records.len() >= 3 + usize::from(acknowledged), "crash at {crash_at}");
            let checkpoint = ledger.checkpoint().unwrap().unwrap();
            assert_eq!(checkpoint.size, records.len() as u64);
            let mut tree = Frontier::default();
            for record in &records {
                tree.push(checkpoint::record_leaf(record.predicate.trail_hash.as_ref().unwrap()).unwrap());
            }
            assert_eq!(checkpoint.root, hex::encode(tree.root()));
            if !plan.was_hit() {
                assert!(crash_at > 4, "the append has several steps");
                break;
            }
        }
    }

    #[test]
    fn an_append_reads_the_head_and_not_the_file() {
        let dir = tempfile::tempdir().unwrap();
        let mut ledger = Ledger::open(&DataFolder::at(dir.path())).unwrap();
        for _ in 0..4 {
            append(&mut ledger).unwrap();
        }
        // Whatever the first lines hold, only verification looks at them again.
        let mut bytes = std::fs::read(ledger.path()).unwrap();
        bytes[..100].fill(b'x');
        std::fs::write(ledger.path(), &bytes).unwrap();
        assert_eq!(append(&mut ledger).unwrap().statement.predicate.chain.seq, 4);
        // Without its head the whole file is read, and is found to be changed.
        std::fs::remove_file(ledger.path().with_file_name("head.json")).unwrap();
        assert_eq!(append(&mut ledger).unwrap_err().kind, Kind::Integrity);
    }

    #[test]
    fn a_cut_or_exchanged_end_is_refused() {
        let dir = tempfile::tempdir().unwrap();
        let mut ledger = Ledger::open(&DataFolder::at(dir.path())).unwrap();
        for _ in 0..3 {
            append(&mut ledger).unwrap();
        }
        let good = std::fs::read(ledger.path()).unwrap();
        let first = good.iter().position(|b| *b == b'\n').unwrap() + 1;
        std::fs::write(ledger.path(), &good[..first]).unwrap();
        let error = append(&mut ledger).unwrap_err();
        assert!(error.kind == Kind::Integrity && error.found.contains("TRUNCATED"), "{error}");
        assert_eq!(std::fs::read(ledger.path()).unwrap(), good[..first], "left as it was");
        std::fs::write(ledger.path(), &good).unwrap();
        append(&mut ledger).unwrap();
        let head = ledger.path().with_file_name("head.json");
        let text = std::fs::read_to_string(&head).unwrap();
        std::fs::write(&head, text.replacen("\"peaks\":[\"", "\"peaks\":[\"0", 1)).unwrap();
        assert_eq!(append(&mut ledger).unwrap_err().kind, Kind::Integrity);
    }
}
