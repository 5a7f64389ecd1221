//! The only door to the user's folders: staged beside the destination, hashed, sealed, and only then renamed.
//!
//! No output appears unless its record stands durably in the ledger. A run that fails, is stopped or is killed leaves
//! the destination as it was; what a killed run leaves beside it is swept by the next.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::canonical::{self, Json};
use super::disk::{self, Disk};
use super::dsse::{Envelope, MAX_ENVELOPE_BYTES};
use super::inband;
use super::keys::SigningKey;
use super::ledger::Ledger;
use super::marking::Marking;
use super::record::{self, RecordDraft, Sealed};
use super::statement::{Outcome, Statement, Subject};
use super::store_merge::PreparedMerge;
use crate::{Error, Result};

/// The record: one DSSE envelope.
pub const RECORD: &str = "orb-record.dsse.json";
/// The bytes that the signature covers, for verification by hand.
pub const RECORD_PAE: &str = "orb-record.pae";
/// The raw signature over them.
pub const RECORD_SIG: &str = "orb-record.sig";
/// The signer's public key. It stands here for convenience; trust comes from elsewhere.
pub const RECORD_KEY: &str = "orb-record.pub.pem";
/// The marking of everything in the folder, for files whose format has no place for one.
pub const MARKING_SIDECAR: &str = "orb-marking.json";
/// Before the names of subjects that stand in a store and not in the published folder.
pub const STORE_PREFIX: &str = "store:";

/// Written by the seal itself, so they cannot be among the subjects.
pub const SEAL_FILES: [&str; 4] = [RECORD, RECORD_PAE, RECORD_SIG, RECORD_KEY];

/// Where and as what to publish.
#[derive(Clone, Debug)]
pub struct Destination {
    pub folder: PathBuf,
    /// A folder that Orb published before may be replaced.
    pub replace: bool,
    pub marking: Marking,
    /// Makes the staging folder's name unlike any other's.
    pub nonce: u64,
}

/// A folder in the making. Dropped without [`Publication::seal`], nothing of it remains.
#[derive(Debug)]
pub struct Publication {
    destination: PathBuf,
    staging: PathBuf,
    marking: Marking,
    subjects: Vec<Subject>,
    /// Lower-case names of files and folders, against names that differ in case only.
    names: BTreeSet<String>,
    merge: Option<PreparedMerge>,
    disk: Disk,
    published: bool,
    _lock: Option<File>,
}

/// A published folder.
#[derive(Clone, Debug)]
pub struct Published {
    pub folder: PathBuf,
    /// Every subject of the record.
    pub outputs: Vec<Output>,
    pub seq: u64,
    pub ledger_id: String,
    pub trail_hash: String,
    /// The signing key's fingerprint.
    pub signed_by: String,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    pub path: String,
    pub media_type: String,
    pub role: String,
    pub bytes: u64,
    pub sha256: String,
}

impl Publication {
    /// Checks the destination and makes the staging folder beside it. Call it before any work.
    ///
    /// # Errors
    /// [`crate::Kind::Usage`] for a destination that is in use; [`crate::Kind::Environment`] when its parent is
    /// missing or not writable.
    pub fn begin(destination: &Destination) -> Result<Publication> {
        Publication::begin_with(destination, Disk::default())
    }

    pub(super) fn begin_with(to: &Destination, disk: Disk) -> Result<Publication> {
        let absolute = std::path::absolute(&to.folder).map_err(|e| Error::io(&to.folder, &e))?;
        let (Some(parent), Some(name)) = (absolute.parent(), absolute.file_name()) else {
            return Err(Error::usage(to.folder.display().to_string())
                .expected("the name of a new folder")
                .advice("Choose another place with -o."));
        };
        let parent = parent.canonicalize().map_err(|e| {
            Error::io(parent, &e)
                .expected("an existing folder to publish in")
                .advice("Make it first, or choose another place with -o.")
        })?;
        let folder = parent.join(name);
        sweep(&parent, name, &disk);
        check_free(&folder, to.replace)?;
        let staging = parent.join(beside(name, &format!("{:016x}", to.nonce)));
        disk.create_dir(&staging).map_err(|mut e| {
            e.expected = "a folder where this user may write".into();
            e.advice("Choose another place with -o. Nothing was published.")
        })?;
        let mut publication = Publication {
            destination: folder,
            staging,
            marking: to.marking,
            subjects: Vec::new(),
            names: BTreeSet::new(),
            merge: None,
            disk,
            published: false,
            _lock: None,
        };
        publication._lock = lock_dir(&publication.staging).map_err(|e| Error::io(&publication.staging, &e))?;
        Ok(publication)
    }

    /// Adds one file: written durably, hashed on the way, listed in the record.
    ///
    /// # Errors
    /// [`crate::Kind::Usage`], `PATH_REFUSED`, for a name that leaves the folder or is taken;
    /// [`crate::Kind::Policy`], `MARKING_INBAND_MISMATCH`, for a file that carries another marking inside, or none where
    /// its format has a place for it; [`crate::Kind::Environment`] when it cannot be written.
    pub fn add(&mut self, path: &str, bytes: &[u8], media_type: &'static str, role: &str) -> Result<()> {
        if let Some(found) = inband::mismatch(path, bytes, self.marking) {
            return Err(Error::policy(path)
                .expected(self.marking.line())
                .found(format!("MARKING_INBAND_MISMATCH: {found}"))
                .advice("Nothing was published."));
        }
        if SEAL_FILES.contains(&path) {
            return Err(refused(path, "a name that the seal uses"));
        }
        self.take_name(path)?;
        if let Some((folder, _)) = path.rsplit_once('/') {
            self.make_folder(folder)?;
        }
        let sha256 = self.disk.write_new(&self.staging.join(path), bytes).map_err(|e| self.in_words(path, e))?;
        self.subjects.push(record::subject(path.to_owned(), sha256, bytes.len() as u64, media_type, role));
        Ok(())
    }

    /// Adds a folder that may stay empty.
    ///
    /// # Errors
    /// As [`Publication::add`].
    pub fn add_folder(&mut self, path: &str) -> Result<()> {
        disk::check_name(path).map_err(|found| refused(path, &found))?;
        self.make_folder(path)
    }

    /// Commits a merge into a store together with this folder: both happen or neither.
    ///
    /// # Errors
    /// [`crate::Kind::Usage`] when there is one already.
    pub fn merge(&mut self, merge: PreparedMerge) -> Result<()> {
        if self.merge.is_some() {
            return Err(Error::usage(merge.root().display().to_string()).expected("one store for each run"));
        }
        self.subjects.extend_from_slice(merge.subjects());
        self.merge = Some(merge);
        Ok(())
    }

    /// Bytes written so far.
    pub fn size(&self) -> u64 {
        self.subjects.iter().filter_map(|s| s.annotations.size.parse::<u64>().ok()).sum()
    }

    /// Seals and publishes: record and signature into the staging folder, the record into the ledger, the store merge,
    /// and last the rename.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`] for a marking below an input's; [`crate::Kind::Integrity`] for a broken ledger;
    /// [`crate::Kind::Environment`] for the disk. The destination and the store are then as they were.
    pub fn seal(mut self, draft: &RecordDraft, key: &SigningKey, ledger: &mut Ledger) -> Result<Published> {
        if draft.marking != self.marking {
            return Err(Error::policy("classification").expected(self.marking.banner()).found(draft.marking.banner()));
        }
        draft.check_marking()?;
        let sidecar = self.sidecar()?;
        self.add(MARKING_SIDECAR, &sidecar, "application/json", "marking")?;
        // One order, whatever order the exporters ran in.
        self.subjects.sort_by(|a, b| a.name.cmp(&b.name));
        let subjects = self.subjects.clone();
        let sealed = ledger.append(|next| {
            let sealed = record::seal(draft, subjects.clone(), Outcome::Success, None, next, key)?;
            self.write_seal(&sealed, key)?;
            Ok(sealed)
        })?;
        if let Err(error) = self.publish() {
            // The ledger says that the run succeeded: the next record corrects it.
            let mut draft = draft.clone();
            draft.event_random[9] ^= 1;
            let _ = ledger
                .append(|next| record::seal(&draft, subjects, Outcome::Failure, Some("PUBLISH_FAILED"), next, key));
            return Err(error);
        }
        Ok(self.into_published(sealed, key))
    }

    fn write_seal(&self, sealed: &Sealed, key: &SigningKey) -> Result<()> {
        let line = sealed.envelope.to_line();
        let pae = sealed.envelope.pae();
        let sig = sealed.envelope.signatures.first().map(|s| s.sig.as_slice()).unwrap_or_default();
        let pem = key.public().to_pem();
        for (name, bytes) in
            [(RECORD, line.as_slice()), (RECORD_PAE, &pae), (RECORD_SIG, sig), (RECORD_KEY, pem.as_bytes())]
        {
            self.disk.write_new(&self.staging.join(name), bytes).map_err(|e| self.in_words(name, e))?;
        }
        for entry in disk::walk(&self.staging)?.iter().filter(|e| e.is_dir) {
            self.disk.sync_dir(&entry.path)?;
        }
        self.disk.sync_dir(&self.staging)
    }

    fn publish(&mut self) -> Result<()> {
        if let Some(merge) = &mut self.merge {
            merge.apply()?;
        }
        // Should the rename fail, the merge is undone when it is dropped.
        let old = put_in_place(&self.staging, &self.destination, &self.disk)?;
        self.published = true;
        if let Some(parent) = self.destination.parent() {
            let _ = self.disk.sync_dir(parent);
        }
        if let Some(merge) = &mut self.merge
            && let Err(error) = merge.finish()
        {
            self.unpublish(old);
            return Err(error);
        }
        if let Some(old) = old {
            // The new folder stands; what is left of the old one is swept by the next run.
            let _ = self.disk.remove_dir_all(&old);
        }
        Ok(())
    }

    /// Takes a folder back whose store merge could not be finished.
    fn unpublish(&mut self, old: Option<PathBuf>) {
        let taken_back = match &old {
            // The two were exchanged: the old folder stands under the staging name.
            Some(old) if *old == self.staging => exchange(&self.staging, &self.destination, &self.disk),
            _ => self.disk.rename(&self.destination, &self.staging).map(|()| true),
        };
        if let Ok(true) = taken_back {
            self.published = false;
            if let Some(old) = old.filter(|old| *old != self.staging) {
                let _ = self.disk.rename(&old, &self.destination);
            }
        }
    }

    fn into_published(self, sealed: Sealed, key: &SigningKey) -> Published {
        let chain = &sealed.statement.predicate.chain;
        Published {
            folder: self.destination.clone(),
            outputs: sealed.statement.subject.iter().map(output).collect(),
            seq: chain.seq,
            ledger_id: chain.ledger_id.clone(),
            trail_hash: sealed.trail_hash,
            signed_by: key.public().fingerprint().to_owned(),
        }
    }

    fn sidecar(&self) -> Result<Vec<u8>> {
        let text = |t: &str| Json::Text(t.to_owned());
        let map = |entries: Vec<(&str, Json)>| Json::Map(entries.into_iter().map(|(k, v)| (k.to_owned(), v)).collect());
        let mut names: Vec<&str> = self.subjects.iter().map(|s| s.name.as_str()).collect();
        names.sort_unstable();
        let value = map(vec![
            ("schema", text("orb.marking/v1")),
            ("banner", text(self.marking.banner())),
            ("ism", map(vec![("classification", text(self.marking.ism_classification()))])),
            ("applies_to", Json::List(names.into_iter().map(text).collect())),
        ]);
        let mut bytes = canonical::to_vec(&value)
            .map_err(|f| Error::usage(MARKING_SIDECAR).found(format!("{}: {}", f.code(), f.detail())))?;
        bytes.push(b'\n');
        Ok(bytes)
    }

    /// Takes the name of a new file and of the folders above it.
    fn take_name(&mut self, path: &str) -> Result<()> {
        disk::check_name(path).map_err(|found| refused(path, &found))?;
        if !self.names.insert(path.to_lowercase()) {
            return Err(refused(path, "a name that is taken; letter case makes no difference"));
        }
        Ok(())
    }

    fn make_folder(&mut self, path: &str) -> Result<()> {
        let full = self.staging.join(path);
        if !full.is_dir() {
            self.disk.create_dir_all(&full).map_err(|e| self.in_words(path, e))?;
        }
        Ok(())
    }

    /// Names the file where the user will look for it, and not in the staging folder.
    fn in_words(&self, path: &str, mut error: Error) -> Error {
        error.subject = self.destination.join(path).display().to_string();
        error
    }
}

impl Drop for Publication {
    fn drop(&mut self) {
        if !self.published {
            // Not through the faults of a test: a process that lives cleans up.
            let _ = fs::remove_dir_all(&self.staging);
        }
    }
}

fn output(subject: &Subject) -> Output {
    Output {
        path: subject.name.clone(),
        media_type: subject.annotations.media_type.clone(),
        role: subject.annotations.role.clone(),
        bytes: subject.annotations.size.parse().unwrap_or_default(),
        sha256: subject.digest.sha256.clone(),
    }
}

fn refused(path: &str, found: &str) -> Error {
    Error::usage(path).expected("a name inside the published folder").found(format!("PATH_REFUSED: {found}"))
}

/// `.<name>.orb-<suffix>`, beside the destination.
fn beside(name: &std::ffi::OsStr, suffix: &str) -> OsString {
    let mut out = OsString::from(".");
    out.push(name);
    out.push(".orb-");
    out.push(suffix);
    out
}

/// Refuses a destination that is not free, and in it files that Orb did not write.
fn check_free(folder: &Path, replace: bool) -> Result<()> {
    let in_use = |found: &str, advice: &str| {
        Error::usage(folder.display().to_string()).expected("a new or empty folder").found(found).advice(advice)
    };
    let metadata = match fs::symlink_metadata(folder) {
        Err(e) if e.kind() == ErrorKind::NotFound => return Ok(()),
        other => other.map_err(|e| Error::io(folder, &e))?,
    };
    if !metadata.is_dir() {
        return Err(in_use("a file or a link", "Choose another place with -o."));
    }
    let entries = disk::walk(folder)?;
    if entries.is_empty() {
        return Ok(());
    }
    let record_path = folder.join(RECORD);
    if !record_path.is_file() {
        return Err(in_use(
            "a folder with other files",
            "Choose another place with -o: Orb replaces only what it made.",
        ));
    }
    if !replace {
        return Err(in_use(
            "an earlier result of Orb",
            "Choose another place with -o, or allow it to be replaced with --force.",
        ));
    }
    let listed = listed_names(&record_path)?;
    match entries.iter().find(|e| !e.is_dir && !listed.contains(&e.name)) {
        None => Ok(()),
        Some(foreign) => Err(in_use(
            &format!("{}, which Orb did not write", foreign.name),
            "Move it away first: replacing the folder would lose it.",
        )),
    }
}

fn listed_names(record_path: &Path) -> Result<BTreeSet<String>> {
    let bytes = disk::read_limited(record_path, MAX_ENVELOPE_BYTES as u64)?;
    let statement = Envelope::parse(&bytes).and_then(|e| Statement::parse(&e.payload)).map_err(|fault| {
        Error::usage(record_path.display().to_string())
            .expected("the record of an earlier result")
            .found(format!("{}: {}", fault.code(), fault.detail()))
            .advice("Choose another place with -o.")
    })?;
    let names = statement.0.subject.into_iter().map(|s| s.name);
    Ok(names.chain(SEAL_FILES.map(str::to_owned)).collect())
}

/// Renames the staging folder to its destination; an older folder that stood there is returned under its new name.
fn put_in_place(staging: &Path, destination: &Path, disk: &Disk) -> Result<Option<PathBuf>> {
    if fs::symlink_metadata(destination).is_err() {
        return disk.rename(staging, destination).map(|()| None);
    }
    if exchange(staging, destination, disk)? {
        return Ok(Some(staging.to_path_buf()));
    }
    let old = staging.with_extension(format!("{}-old", staging.extension().unwrap_or_default().to_string_lossy()));
    disk.rename(destination, &old)?;
    if let Err(error) = disk.rename(staging, destination) {
        let _ = fs::rename(&old, destination);
        return Err(error);
    }
    Ok(Some(old))
}

/// Swaps two folders in one step; false where the system or its file system cannot.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
fn exchange(a: &Path, b: &Path, disk: &Disk) -> Result<bool> {
    use std::ffi::CString;
    use std::os::unix::ffi::OsStrExt as _;
    disk.sync_dir(a.parent().unwrap_or(a))?;
    let (Ok(from), Ok(to)) = (CString::new(a.as_os_str().as_bytes()), CString::new(b.as_os_str().as_bytes())) else {
        return Ok(false);
    };
    // SAFETY: both pointers are to NUL-terminated strings that outlive the call; the paths are absolute, so the
    // folder descriptors are not used.
    let result =
        unsafe { libc::renameat2(libc::AT_FDCWD, from.as_ptr(), libc::AT_FDCWD, to.as_ptr(), libc::RENAME_EXCHANGE) };
    Ok(result == 0)
}

#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
fn exchange(_: &Path, _: &Path, _: &Disk) -> Result<bool> {
    Ok(false)
}

/// Shows other runs that this staging folder is alive.
#[cfg(unix)]
fn lock_dir(path: &Path) -> std::io::Result<Option<File>> {
    let file = File::open(path)?;
    // A file system without locks: nothing is swept there either.
    Ok(file.try_lock().is_ok().then_some(file))
}

#[cfg(not(unix))]
fn lock_dir(_: &Path) -> std::io::Result<Option<File>> {
    Ok(None)
}

/// Sweeps what killed runs left beside this destination; an older result that a kill left aside is put back.
#[cfg(unix)]
fn sweep(parent: &Path, name: &std::ffi::OsStr, disk: &Disk) {
    let prefix = beside(name, "");
    let Ok(entries) = fs::read_dir(parent) else { return };
    for entry in entries.flatten() {
        let file_name = entry.file_name();
        let suffix = match file_name.as_encoded_bytes().strip_prefix(prefix.as_encoded_bytes()) {
            Some(suffix) => suffix,
            None => continue,
        };
        let (digits, rest) = suffix.split_at(suffix.len().min(16));
        let ours =
            digits.len() == 16 && digits.iter().all(u8::is_ascii_hexdigit) && (rest.is_empty() || rest == b"-old");
        if !ours || !entry.file_type().is_ok_and(|t| t.is_dir()) {
            continue;
        }
        let path = entry.path();
        let Ok(Some(_dead)) = lock_dir(&path) else { continue };
        let destination = parent.join(name);
        if rest == b"-old" && fs::symlink_metadata(&destination).is_err() {
            let _ = disk.rename(&path, &destination);
        } else {
            let _ = disk.remove_dir_all(&path);
        }
    }
}

#[cfg(not(unix))]
fn sweep(_: &Path, _: &std::ffi::OsStr, _: &Disk) {}

#[cfg(test)]
pub(crate) mod tests {
    use super::super::data_folder::DataFolder;
    use super::super::disk::fault::Plan;
    use super::super::keys::tests::shared_key;
    use super::super::record::tests::draft;
    use super::super::store_merge::{lock_store, merge_into_store};
    use super::*;
    use crate::Kind;

    pub(crate) fn destination(folder: &Path) -> Destination {
        Destination { folder: folder.into(), replace: false, marking: Marking::Unclassified, nonce: 7 }
    }

    pub(crate) fn ply() -> Vec<u8> {
        format!("ply\ncomment {}\nend_header\n\x01\x02\x03", Marking::Unclassified.line()).into_bytes()
    }

    pub(crate) fn fill(publication: &mut Publication) -> Result<()> {
        publication.add("scene.ply", &ply(), "application/octet-stream", "splats")?;
        publication.add("van.cdb/Tiles/N34/points.dbf", b"dbf bytes", "application/octet-stream", "cdb")?;
        publication.add_folder("van.cdb/Metadata/Stylesheet")
    }

    /// Publishes three files into `dir/out`, with the ledger in `dir/data`.
    pub(crate) fn publish(dir: &Path) -> Published {
        let mut publication = Publication::begin(&destination(&dir.join("out"))).unwrap();
        fill(&mut publication).unwrap();
        publication.seal(&draft(), shared_key(), &mut ledger(dir)).unwrap()
    }

    pub(crate) fn ledger(dir: &Path) -> Ledger {
        Ledger::open(&DataFolder::at(dir.join("data"))).unwrap()
    }

    fn names(dir: &Path) -> Vec<String> {
        disk::walk(dir).unwrap().into_iter().map(|e| e.name).filter(|n| !n.starts_with("data")).collect()
    }

    #[test]
    fn a_published_folder() {
        let dir = tempfile::tempdir().unwrap();
        let published = publish(dir.path());
        assert_eq!(published.folder, dir.path().canonicalize().unwrap().join("out"));
        assert_eq!(
            names(dir.path()),
            [
                "out",
                "out/orb-marking.json",
                "out/orb-record.dsse.json",
                "out/orb-record.pae",
                "out/orb-record.pub.pem",
                "out/orb-record.sig",
                "out/scene.ply",
                "out/van.cdb",
                "out/van.cdb/Metadata",
                "out/van.cdb/Metadata/Stylesheet",
                "out/van.cdb/Tiles",
                "out/van.cdb/Tiles/N34",
                "out/van.cdb/Tiles/N34/points.dbf",
            ]
        );
        let paths: Vec<&str> = published.outputs.iter().map(|o| o.path.as_str()).collect();
        assert_eq!(paths, ["orb-marking.json", "scene.ply", "van.cdb/Tiles/N34/points.dbf"]);
        assert_eq!(published.outputs[1].sha256, canonical::sha256_hex(&ply()));
        assert_eq!(published.outputs[1].bytes, ply().len() as u64);
        let records = ledger(dir.path()).read_chain().unwrap();
        assert_eq!(records.len(), 1);
        assert_eq!(records[0].predicate.trail_hash.as_ref(), Some(&published.trail_hash));
        let line = fs::read(dir.path().join("out").join(RECORD)).unwrap();
        assert_eq!(fs::read(ledger(dir.path()).path()).unwrap(), line);
    }

    #[test]
    fn nothing_remains_of_what_is_not_sealed() {
        let dir = tempfile::tempdir().unwrap();
        let mut publication = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
        fill(&mut publication).unwrap();
        assert_eq!(names(dir.path())[0], ".out.orb-0000000000000007");
        drop(publication);
        assert!(names(dir.path()).is_empty());
    }

    #[test]
    fn destinations_in_use() {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("out");
        let refuse =
            |replace: bool| Publication::begin(&Destination { replace, ..destination(&out) }).map(drop).unwrap_err();
        fs::write(&out, "file").unwrap();
        assert_eq!(refuse(true).kind, Kind::Usage);
        fs::remove_file(&out).unwrap();
        fs::create_dir(&out).unwrap();
        fs::write(out.join("thesis.txt"), "mine").unwrap();
        assert_eq!(refuse(true).kind, Kind::Usage);
        fs::remove_file(out.join("thesis.txt")).unwrap();
        // An empty folder is fine.
        publish(dir.path());
        assert!(refuse(false).advice.contains("--force"));
        fs::write(out.join("van.cdb/notes.txt"), "mine").unwrap();
        assert!(refuse(true).found.contains("van.cdb/notes.txt"));
        assert_eq!(fs::read(out.join("van.cdb/notes.txt")).unwrap(), b"mine");
        let missing = Publication::begin(&destination(&dir.path().join("a/b"))).unwrap_err();
        assert_eq!(missing.kind, Kind::Environment);
        assert_eq!(Publication::begin(&destination(Path::new("/"))).unwrap_err().kind, Kind::Usage);
    }

    #[test]
    fn an_earlier_result_is_replaced_whole() {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let again = Destination { replace: true, ..destination(&dir.path().join("out")) };
        let mut publication = Publication::begin(&again).unwrap();
        publication.add("only.bin", b"1", "application/octet-stream", "x").unwrap();
        publication.seal(&draft(), shared_key(), &mut ledger(dir.path())).unwrap();
        assert!(!dir.path().join("out/scene.ply").exists());
        assert_eq!(fs::read(dir.path().join("out/only.bin")).unwrap(), b"1");
        assert!(names(dir.path()).iter().all(|n| n.starts_with("out")), "{:?}", names(dir.path()));
        assert_eq!(ledger(dir.path()).read_chain().unwrap().len(), 2);
    }

    #[test]
    fn names_that_are_refused() {
        let dir = tempfile::tempdir().unwrap();
        let mut publication = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
        fill(&mut publication).unwrap();
        for path in ["../x", "/x", "a\\b", "scene.ply", "Scene.PLY", RECORD, RECORD_PAE, "a:b", ""] {
            let error = publication.add(path, &ply(), "x", "x").unwrap_err();
            assert!(error.found.contains("PATH_REFUSED"), "{path}: {error}");
        }
        assert!(publication.add_folder("../x").is_err());
    }

    #[test]
    fn a_file_with_another_marking_is_not_published() {
        let dir = tempfile::tempdir().unwrap();
        let to = Destination { marking: Marking::Secret, ..destination(&dir.path().join("out")) };
        let mut publication = Publication::begin(&to).unwrap();
        let error = publication.add("scene.ply", &ply(), "x", "x").unwrap_err();
        assert_eq!(error.kind, Kind::Policy);
        assert!(error.found.contains("MARKING_INBAND_MISMATCH"));
        let error = publication.add("scene.ply", b"ply\nend_header\n", "x", "x").unwrap_err();
        assert!(error.found.contains("no marking inside"));
        let error = publication.seal(&draft(), shared_key(), &mut ledger(dir.path())).unwrap_err();
        assert_eq!(error.kind, Kind::Policy);
        assert!(names(dir.path()).is_empty());
    }

    fn merge_files() -> [orb_formats::File; 2] {
        let file = |path: &str| orb_formats::File {
            path: path.into(),
            bytes: b"new".to_vec(),
            media_type: "application/octet-stream",
        };
        [file("there.txt"), file("added/too.txt")]
    }

    fn snapshot(dir: &Path) -> Vec<(String, Vec<u8>)> {
        let entries = disk::walk(dir).unwrap();
        entries
            .into_iter()
            .filter(|e| !e.name.starts_with("data") && !e.name.contains(".orb"))
            .map(|e| (e.name, if e.is_file { fs::read(e.path).unwrap() } else { Vec::new() }))
            .collect()
    }

    /// The earlier result, the store and the new result, with a failure at every operation of the publication.
    #[test]
    fn a_failure_leaves_destination_and_store_as_they_were() {
        let mut failures = 0;
        for at in 0.. {
            let dir = tempfile::tempdir().unwrap();
            publish(dir.path());
            fs::create_dir(dir.path().join("store")).unwrap();
            fs::write(dir.path().join("store/there.txt"), "old").unwrap();
            let before = snapshot(dir.path());
            let plan = Plan::new(at, false, ErrorKind::StorageFull);
            let run = || {
                let to = Destination { replace: true, ..destination(&dir.path().join("out")) };
                let mut publication = Publication::begin_with(&to, Disk { fault: Some(plan.clone()) })?;
                publication.add("a/new.bin", b"new", "application/octet-stream", "x")?;
                let lock = lock_store(&dir.path().join("store"))?;
                publication.merge(merge_into_store(lock, &merge_files(), &[])?)?;
                publication.seal(&draft(), shared_key(), &mut ledger(dir.path()))
            };
            let result = run();
            let after = snapshot(dir.path());
            match result {
                Err(error) => {
                    failures += 1;
                    assert_eq!(error.kind, Kind::Environment, "{error}");
                    assert_eq!(after, before, "operation {at}");
                    assert!(!names(dir.path()).iter().any(|n| n.contains(".orb")), "operation {at}");
                }
                Ok(_) => {
                    assert_eq!(fs::read(dir.path().join("out/a/new.bin")).unwrap(), b"new");
                    assert_eq!(fs::read(dir.path().join("store/there.txt")).unwrap(), b"new");
                    assert!(!dir.path().join("out/scene.ply").exists());
                }
            }
            ledger(dir.path()).read_chain().unwrap();
            if !plan.was_hit() {
                break;
            }
        }
        assert!(failures >= 8, "{failures}");
    }

    #[test]
    fn a_store_that_fails_takes_the_folder_with_it() {
        let dir = tempfile::tempdir().unwrap();
        fs::create_dir(dir.path().join("store")).unwrap();
        let mut publication = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
        fill(&mut publication).unwrap();
        let lock = lock_store(&dir.path().join("store")).unwrap();
        publication.merge(merge_into_store(lock, &merge_files(), &[]).unwrap()).unwrap();
        // Something takes the place of a file to be added.
        fs::create_dir_all(dir.path().join("store/added/too.txt/in-the-way")).unwrap();
        let error = publication.seal(&draft(), shared_key(), &mut ledger(dir.path())).unwrap_err();
        assert_eq!(error.kind, Kind::Environment);
        assert!(!dir.path().join("out").exists());
        assert!(!dir.path().join("store/there.txt").exists());
        // The ledger says what became of the run.
        let records = ledger(dir.path()).read_chain().unwrap();
        assert_eq!(records.len(), 2);
        assert_eq!(records[1].predicate.event.outcome, Outcome::Failure);
        assert_eq!(records[1].predicate.event.error_code.as_deref(), Some("PUBLISH_FAILED"));
        assert_ne!(records[0].predicate.event.id, records[1].predicate.event.id);
    }

    #[test]
    fn a_broken_ledger_publishes_nothing() {
        let dir = tempfile::tempdir().unwrap();
        let ledger_path = ledger(dir.path()).path().to_path_buf();
        fs::write(&ledger_path, "not a record\n").unwrap();
        let mut publication = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
        fill(&mut publication).unwrap();
        let error = publication.seal(&draft(), shared_key(), &mut ledger(dir.path())).unwrap_err();
        assert_eq!(error.kind, Kind::Integrity);
        assert!(names(dir.path()).is_empty());
    }

    #[cfg(unix)]
    #[test]
    fn killed_runs_are_swept_and_living_ones_are_not() {
        let dir = tempfile::tempdir().unwrap();
        let dead = dir.path().join(".out.orb-00000000000000aa");
        fs::create_dir(&dead).unwrap();
        fs::write(dead.join("half"), "x").unwrap();
        let mine = dir.path().join(".out.orb-notes");
        fs::create_dir(&mine).unwrap();
        let living = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
        assert!(!dead.exists() && mine.exists());
        let second = Publication::begin(&Destination { nonce: 8, ..destination(&dir.path().join("out")) }).unwrap();
        assert!(living.staging.exists() && second.staging.exists());
        drop((living, second));
        // An earlier result set aside by a kill between two renames comes back.
        publish(dir.path());
        fs::rename(dir.path().join("out"), dir.path().join(".out.orb-00000000000000bb-old")).unwrap();
        let error = Publication::begin(&destination(&dir.path().join("out"))).unwrap_err();
        assert!(error.found.contains("earlier result"));
        assert!(dir.path().join("out/scene.ply").exists());
    }

    #[cfg(unix)]
    #[test]
    fn a_folder_that_cannot_be_written() {
        use std::os::unix::fs::PermissionsExt as _;
        let dir = tempfile::tempdir().unwrap();
        fs::set_permissions(dir.path(), fs::Permissions::from_mode(0o555)).unwrap();
        // The superuser writes everywhere.
        if fs::write(dir.path().join("probe"), "").is_err() {
            let error = Publication::begin(&destination(&dir.path().join("out"))).unwrap_err();
            assert_eq!(error.kind, Kind::Environment);
            assert!(error.advice.contains("-o"));
        }
        fs::set_permissions(dir.path(), fs::Permissions::from_mode(0o755)).unwrap();
    }
}
