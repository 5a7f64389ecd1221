//! Adding files to an existing CDB store, all or nothing.
//!
//! New files are written into `.orb-merge/new` inside the store, so that every rename stays on one file system. Then a
//! journal names what will happen, and only then are originals moved to `.orb-merge/old` and new files into place. The
//! rename of `.orb-merge` to `.orb-merge-done` is the moment from which the new store counts. A run that is killed
//! before it leaves a journal, and the next one undoes what it says, unless the folder that belongs to it was published: an
//! old store or a new one, never a mix.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::disk::{self, Disk};
use super::file_lock::FileLock;
use super::ledger::Recorded;
use super::record;
use super::statement::Subject;
use crate::{Error, Kind, Result};

const WORK: &str = ".orb-merge";
const DONE: &str = ".orb-merge-done";
const JOURNAL: &str = "journal.json";
const SCHEMA: &str = "orb.store-merge/v1";

/// A store that no other run of Orb writes to while this value lives. Read the store after taking it.
#[derive(Debug)]
pub struct StoreLock {
    root: PathBuf,
    disk: Disk,
    _lock: FileLock,
}

/// Takes the store for one writer and undoes what a killed run left.
///
/// # Errors
/// [`Kind::Usage`] when `root` is no folder; [`Kind::Environment`] when another run writes to it, or it cannot be
/// written.
pub fn lock_store(root: &Path) -> Result<StoreLock> {
    lock_with(root, Disk::default())
}

pub(super) fn lock_with(root: &Path, disk: Disk) -> Result<StoreLock> {
    let root = root.canonicalize().map_err(|e| Error::io(root, &e))?;
    if !root.is_dir() {
        return Err(Error::usage(root.display().to_string())
            .expected("the root folder of a CDB store")
            .found("a file"));
    }
    let lock = open_for_lock(&root).map_err(|e| Error::io(&root, &e))?;
    let lock = FileLock::try_take(lock).map_err(|error| match error {
        fs::TryLockError::WouldBlock => Error::environment(root.display().to_string())
            .expected("one writer at a time")
            .found("another run of Orb that writes to this store")
            .advice("Wait for it to end. The store was not touched."),
        fs::TryLockError::Error(e) => Error::io(&root, &e),
    })?;
    recover_locked(&root, &disk)?;
    Ok(StoreLock { root, disk, _lock: lock })
}

/// The folder itself is locked: nothing is left behind in the store.
#[cfg(unix)]
fn open_for_lock(root: &Path) -> std::io::Result<File> {
    File::open(root)
}

/// Where folders cannot be opened, a file beside the store is locked and stays.
#[cfg(not(unix))]
fn open_for_lock(root: &Path) -> std::io::Result<File> {
    let name = format!(".{}.orb-lock", root.file_name().unwrap_or_default().to_string_lossy());
    fs::OpenOptions::new().create(true).append(true).open(root.with_file_name(name))
}

/// Undoes what a killed run left in a store; nothing when there is nothing.
///
/// # Errors
/// As [`lock_store`].
pub fn recover(root: &Path) -> Result<()> {
    lock_store(root).map(drop)
}

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Journal {
    schema: String,
    /// Files that stood there before.
    replaced: Vec<String>,
    /// Files that did not.
    added: Vec<String>,
    /// Folders to make, outer ones first.
    folders: Vec<String>,
    /// What is published together with the merge, once that is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    with: Option<With>,
}

/// The folder that is published with a merge: where its record stands, the merge counts.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct With {
    folder: String,
    trail_hash: String,
}

impl With {
    fn is_published(&self) -> bool {
        let record = super::verify::read_record(Path::new(&self.folder));
        record.is_ok_and(|(_, statement)| statement.predicate.trail_hash.as_ref() == Some(&self.trail_hash))
    }
}

/// New files, staged and checked; the store is as it was. Dropping it leaves the store so.
#[derive(Debug)]
pub struct PreparedMerge {
    lock: StoreLock,
    journal: Journal,
    subjects: Vec<Subject>,
    state: State,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Staged,
    Applied,
    Finished,
}

/// Stages files and folders for a store, paths relative to its root.
///
/// # Errors
/// [`Kind::Usage`], `PATH_REFUSED`, for a path that leaves the store or meets a link or something that is no file;
/// [`Kind::Environment`] when the disk is full or the store cannot be written.
pub fn merge_into_store(lock: StoreLock, files: &[orb_formats::File], folders: &[String]) -> Result<PreparedMerge> {
    let journal = plan(&lock.root, files, folders)?;
    let mut merge = PreparedMerge { lock, journal, subjects: Vec::new(), state: State::Staged };
    let PreparedMerge { lock: StoreLock { root, disk, .. }, subjects, .. } = &mut merge;
    let work = root.join(WORK);
    disk.create_dir(&work)
        .map_err(|e| e.expected("a store where this user may write").advice("The store was not touched."))?;
    for sub in ["new", "old"] {
        disk.create_dir(&work.join(sub))?;
    }
    for file in files {
        let path = work.join("new").join(&file.path);
        for sub in ["new", "old"] {
            if let Some(folder) = work.join(sub).join(&file.path).parent()
                && !folder.is_dir()
            {
                disk.create_dir_all(folder)?;
            }
        }
        let sha256 = disk.write_new(&path, &file.bytes)?;
        let name = format!("{}{}", super::publication::STORE_PREFIX, file.path);
        subjects.push(record::subject(name, sha256, file.bytes.len() as u64, file.media_type, "store"));
    }
    Ok(merge)
}

fn plan(root: &Path, files: &[orb_formats::File], folders: &[String]) -> Result<Journal> {
    let refused = |name: &str, found: String| {
        Error::usage(root.join(name).display().to_string())
            .expected("a path inside the store")
            .found(format!("PATH_REFUSED: {found}"))
            .advice("The store was not touched.")
    };
    let mut journal =
        Journal { schema: SCHEMA.into(), replaced: Vec::new(), added: Vec::new(), folders: Vec::new(), with: None };
    let mut seen = BTreeSet::new();
    let mut new_folders = BTreeSet::new();
    let parents = files.iter().filter_map(|f| f.path.rsplit_once('/').map(|(parent, _)| parent));
    for folder in folders.iter().map(String::as_str).chain(parents) {
        disk::check_name(folder).map_err(|found| refused(folder, found))?;
        // Every folder on the way down, so that no link is followed.
        for (end, _) in folder.match_indices('/').chain([(folder.len(), "")]) {
            let part = &folder[..end];
            match fs::symlink_metadata(root.join(part)) {
                Ok(metadata) if metadata.is_dir() => {}
                Ok(_) => return Err(refused(part, "a link or a file where a folder belongs".into())),
                Err(_) => {
                    new_folders.insert(part.to_owned());
                }
            }
        }
    }
    for file in files {
        disk::check_name(&file.path).map_err(|found| refused(&file.path, found))?;
        if !seen.insert(file.path.to_lowercase()) {
            return Err(refused(&file.path, "the same name twice".into()));
        }
        match fs::symlink_metadata(root.join(&file.path)) {
            Ok(metadata) if metadata.is_file() => journal.replaced.push(file.path.clone()),
            Ok(_) => return Err(refused(&file.path, "a link or a folder where a file belongs".into())),
            Err(_) => journal.added.push(file.path.clone()),
        }
    }
    // Sorted: an outer folder comes before those in it.
    journal.folders = new_folders.into_iter().collect();
    Ok(journal)
}

impl PreparedMerge {
    pub fn root(&self) -> &Path {
        &self.lock.root
    }

    /// The staged files as a record lists them: `store:` and the path in the store.
    pub fn subjects(&self) -> &[Subject] {
        &self.subjects
    }

    /// Where a new file waits.
    pub(super) fn staged(&self, name: &str) -> PathBuf {
        self.lock.root.join(WORK).join("new").join(name)
    }

    /// Puts the new files into place, undoably, once their record stands. `folder` will be published with them: a run that
    /// is killed after that has merged, one that is killed before has not.
    ///
    /// # Errors
    /// [`Kind::Environment`]; the store is then as it was, or will be after [`recover`].
    pub(super) fn apply(&mut self, recorded: &Recorded, folder: &Path) -> Result<()> {
        self.journal.with =
            Some(With { folder: folder.to_string_lossy().into_owned(), trail_hash: recorded.trail_hash.clone() });
        let result = self.try_apply();
        if result.is_err() {
            // Should this fail too, the journal stays and the next run undoes it.
            let _ = self.undo();
        }
        result.map_err(|e| if e.advice.is_empty() { e.advice("The store is as it was.") } else { e })
    }

    fn try_apply(&mut self) -> Result<()> {
        let StoreLock { root, disk, .. } = &self.lock;
        let work = root.join(WORK);
        let text =
            serde_json::to_vec_pretty(&self.journal).map_err(|e| Error::environment(JOURNAL).found(e.to_string()))?;
        let draft = work.join("journal.draft");
        disk.write_new(&draft, &text)?;
        disk.rename(&draft, &work.join(JOURNAL))?;
        disk.sync_dir(&work)?;
        disk.sync_dir(root)?;
        self.state = State::Applied;
        for folder in &self.journal.folders {
            disk.create_dir(&root.join(folder))?;
        }
        for name in &self.journal.replaced {
            disk.rename(&root.join(name), &work.join("old").join(name))?;
            disk.rename(&work.join("new").join(name), &root.join(name))?;
        }
        for name in &self.journal.added {
            disk.rename(&work.join("new").join(name), &root.join(name))?;
        }
        sync_touched(root, &self.journal, disk)
    }

    /// The point of no return: from here the new store counts.
    ///
    /// # Errors
    /// [`Kind::Environment`]; the store is then as it was, or will be after [`recover`].
    pub(super) fn finish(&mut self) -> Result<()> {
        let StoreLock { root, disk, .. } = &self.lock;
        let counted = disk.rename(&root.join(WORK), &root.join(DONE));
        if let Err(error) = counted {
            let _ = self.undo();
            return Err(error);
        }
        self.state = State::Finished;
        // Leftovers are swept by the next run.
        let _ = disk.sync_dir(root).and_then(|()| disk.remove_dir_all(&root.join(DONE)));
        Ok(())
    }

    #[cfg(test)]
    fn commit(mut self) -> Result<()> {
        self.apply(super::ledger::tests::recorded(), Path::new("/nowhere"))?;
        self.finish()
    }

    #[cfg(test)]
    fn rollback(mut self) -> Result<()> {
        self.undo()
    }

    fn undo(&mut self) -> Result<()> {
        if self.state != State::Finished {
            undo_locked(&self.lock.root, &self.lock.disk, |_| false)?;
            self.state = State::Finished;
        }
        Ok(())
    }
}

impl Drop for PreparedMerge {
    fn drop(&mut self) {
        let _ = self.undo();
    }
}

/// Undoes what a killed run left, unless its folder was published: then the merge had been done too.
fn recover_locked(root: &Path, disk: &Disk) -> Result<()> {
    undo_locked(root, disk, |journal| journal.with.as_ref().is_some_and(With::is_published))
}

/// Undoes by the journal, if there is one that does not count, and sweeps. Every step may already have happened: a run killed
/// here is continued by the next.
fn undo_locked(root: &Path, disk: &Disk, counts: impl FnOnce(&Journal) -> bool) -> Result<()> {
    let (work, done) = (root.join(WORK), root.join(DONE));
    if fs::symlink_metadata(&done).is_ok() {
        disk.remove_dir_all(&done)?;
    }
    if fs::symlink_metadata(&work).is_err() {
        return Ok(());
    }
    if let Some(journal) = read_journal(&work)?.filter(|journal| !counts(journal)) {
        for name in &journal.added {
            // A staged file is at one place or the other.
            let (new, target) = (work.join("new").join(name), root.join(name));
            if !exists(&new) && exists(&target) {
                disk.remove_file(&target)?;
            }
        }
        for name in &journal.replaced {
            let old = work.join("old").join(name);
            if exists(&old) {
                disk.rename(&old, &root.join(name))?;
            }
        }
        for folder in journal.folders.iter().rev() {
            let path = root.join(folder);
            // Somebody else's file in it keeps it.
            if path.read_dir().is_ok_and(|mut entries| entries.next().is_none()) {
                disk.remove_dir(&path)?;
            }
        }
        sync_touched(root, &journal, disk)?;
    }
    // In one step, so that a journal is never seen beside half of its folder.
    disk.rename(&work, &done)?;
    disk.sync_dir(root)?;
    disk.remove_dir_all(&done)
}

fn read_journal(work: &Path) -> Result<Option<Journal>> {
    let path = work.join(JOURNAL);
    if !exists(&path) {
        return Ok(None);
    }
    let unreadable = |found: String| {
        Error::new(Kind::Environment, path.display().to_string())
            .expected("the journal of a merge that did not end")
            .found(found)
            .advice(format!("Originals are in {}; move them back by hand.", work.join("old").display()))
    };
    let bytes = disk::read_limited(&path, 1 << 28)?;
    let journal: Journal = serde_json::from_slice(&bytes).map_err(|e| unreadable(e.to_string()))?;
    for name in journal.replaced.iter().chain(&journal.added).chain(&journal.folders) {
        disk::check_name(name).map_err(|found| unreadable(format!("PATH_REFUSED: {found}")))?;
    }
    if journal.schema != SCHEMA {
        return Err(unreadable(journal.schema));
    }
    Ok(Some(journal))
}

fn exists(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}

/// Makes the names durable in every folder that a merge changes.
fn sync_touched(root: &Path, journal: &Journal, disk: &Disk) -> Result<()> {
    let names = journal.replaced.iter().chain(&journal.added).chain(&journal.folders);
    let folders: BTreeSet<PathBuf> = names.filter_map(|name| root.join(name).parent().map(Path::to_path_buf)).collect();
    for folder in folders.iter().filter(|f| f.is_dir()) {
        disk.sync_dir(folder)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests;
