//! The only door to the user's folders: staged beside the destination, hashed, sealed, and only then renamed.
//!
//! No output appears unless its record stands durably in the ledger. A run that fails, is stopped or is killed leaves
//! the destination as it was; what a killed run leaves beside it is swept by the next.

mod place;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::canonical;
use super::checkpoint::Proof;
use super::disk::{self, Disk};
use super::file_lock::FileLock;
use super::inband;
use super::keys::SigningKey;
use super::ledger::{Ledger, Recorded};
use super::marking::authority::{Authority, Designation};
use super::marking::handling::Handling;
use super::marking::{Ism, Profile};
use super::record::{self, RecordDraft, Sealed};
use super::statement::{Outcome, Subject};
use super::store_merge::PreparedMerge;
use super::time::TimeReading;
use super::trust::CertChain;
use crate::{Error, Result};
use place::{beside, check_free, exchange, lock_dir, parent_and_name, put_in_place, sweep};

/// The record: one DSSE envelope.
pub const RECORD: &str = "orb-record.dsse.json";
/// The bytes that the signature covers, for verification by hand.
pub const RECORD_PAE: &str = "orb-record.pae";
/// The raw signature over them.
pub const RECORD_SIG: &str = "orb-record.sig";
/// The signer's public key. It stands here for convenience; trust comes from elsewhere.
pub const RECORD_KEY: &str = "orb-record.pub.pem";
/// The second signature, where two keys sign.
pub const RECORD_SIG_2: &str = "orb-record.second.sig";
/// The second key.
pub const RECORD_KEY_2: &str = "orb-record.second.pub.pem";
/// That the record stands in the signer's ledger: its place and a signed checkpoint.
pub const RECORD_PROOF: &str = "orb-proof.tlog";
/// The signer's certificates, where the key has some.
pub const RECORD_CHAIN: &str = "orb-record.chain.pem";
/// A time stamp of the record, once one was imported.
pub const RECORD_STAMP: &str = "orb-record.tsr";
/// The marking of everything in the folder, for files whose format has no place for one.
pub const MARKING_SIDECAR: &str = "orb-marking.json";
/// Before the names of subjects that stand in a store and not in the published folder.
pub const STORE_PREFIX: &str = "store:";

/// Written by the seal itself, so they cannot be among the subjects.
pub const SEAL_FILES: [&str; 9] =
    [RECORD, RECORD_PAE, RECORD_SIG, RECORD_KEY, RECORD_SIG_2, RECORD_KEY_2, RECORD_PROOF, RECORD_CHAIN, RECORD_STAMP];

/// Where and as what to publish.
#[derive(Clone, Debug)]
pub struct Destination {
    pub folder: PathBuf,
    /// A folder that Orb published before may be replaced.
    pub replace: bool,
    pub handling: Handling,
    /// Makes the staging folder's name unlike any other's.
    pub nonce: u64,
}

/// `orb-marking.json`.
#[derive(serde::Serialize)]
struct Sidecar<'a> {
    schema: &'a str,
    profile: Profile,
    banner: String,
    ism: Ism,
    #[serde(skip_serializing_if = "Option::is_none")]
    authority: Option<&'a Authority>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cui_block: Option<&'a Designation>,
    applies_to: Vec<&'a str>,
}

/// A folder in the making. Dropped without [`Publication::seal`], nothing of it remains.
#[derive(Debug)]
pub struct Publication {
    destination: PathBuf,
    staging: PathBuf,
    handling: Handling,
    subjects: Vec<Subject>,
    /// Lower-case names of files and folders, against names that differ in case only.
    names: BTreeSet<String>,
    merge: Option<PreparedMerge>,
    /// What may stand at the destination: asked again before the rename.
    replace: bool,
    own: Vec<String>,
    disk: Disk,
    published: bool,
    _lock: Option<FileLock>,
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
    /// When the record was made, and how well that is known.
    pub time: TimeReading,
    /// The fingerprint of the key that the record names first.
    pub signed_by: String,
    /// Those of the keys that sign together with it.
    pub also_signed_by: Vec<String>,
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

    /// Whether a folder may be published there: for work whose marking is known only in the end.
    ///
    /// # Errors
    /// As [`Publication::begin`], but for what takes writing to find out.
    pub fn check(folder: &Path, replace: bool) -> Result<()> {
        let (parent, name) = parent_and_name(folder)?;
        check_free(&parent.join(name), replace, &[])
    }

    /// As [`Publication::begin`], for a folder that the run itself works in until it is published: files of these names may stand
    /// there and go with the folder that is replaced.
    ///
    /// # Errors
    /// As [`Publication::begin`].
    pub fn begin_over(destination: &Destination, own: &[&str]) -> Result<Publication> {
        Publication::staged(destination, Disk::default(), own)
    }

    pub(super) fn begin_with(to: &Destination, disk: Disk) -> Result<Publication> {
        Publication::staged(to, disk, &[])
    }

    fn staged(to: &Destination, disk: Disk, own: &[&str]) -> Result<Publication> {
        let (parent, name) = parent_and_name(&to.folder)?;
        let folder = parent.join(&name);
        let own: Vec<String> = own.iter().map(|name| (*name).to_owned()).collect();
        sweep(&parent, &name, &disk);
        check_free(&folder, to.replace, &own)?;
        let staging = parent.join(beside(&name, &format!("{:016x}", to.nonce)));
        disk.create_dir(&staging).map_err(|mut e| {
            e.subject = folder.display().to_string();
            e.expected = "a place where this user may write".into();
            e.advice("Choose another place with -o. Nothing was published.")
        })?;
        let mut publication = Publication {
            destination: folder,
            staging,
            handling: to.handling.clone(),
            subjects: Vec::new(),
            names: BTreeSet::new(),
            merge: None,
            replace: to.replace,
            own,
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
        let marking = &self.handling.marking;
        if let Some(found) = inband::mismatch(path, bytes, marking) {
            return Err(Error::policy(path)
                .expected(marking.line())
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

    /// Path, media type and role of what was added so far.
    pub fn outputs(&self) -> impl Iterator<Item = (&str, &str, &str)> {
        self.subjects.iter().map(|s| (s.name.as_str(), s.annotations.media_type.as_str(), s.annotations.role.as_str()))
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
    /// [`crate::Kind::Usage`] for a destination that is in use by now; [`crate::Kind::Environment`] for the disk.
    /// The destination and the store are then as they were.
    pub fn seal(mut self, draft: &RecordDraft, key: &SigningKey, ledger: &mut Ledger) -> Result<Published> {
        if draft.handling != self.handling {
            let (of_files, of_record) = (&self.handling.marking, &draft.handling.marking);
            return Err(Error::policy("classification").expected(of_files.banner()).found(of_record.banner()));
        }
        draft.check_marking()?;
        let sidecar = self.sidecar()?;
        self.add(MARKING_SIDECAR, &sidecar, "application/json", "marking")?;
        if key.algorithm().with_sha384() {
            self.add_sha384()?;
        }
        // One order, whatever order the exporters ran in.
        self.subjects.sort_by(|a, b| a.name.cmp(&b.name));
        let subjects = self.subjects.clone();
        let recorded = ledger.append(
            key,
            |next| record::seal(draft, subjects.clone(), Outcome::Success, None, next, key),
            |sealed, proof| self.write_seal(sealed, proof, key),
        )?;
        if let Err(error) = self.publish(&recorded) {
            // The ledger says that the run succeeded: the next record corrects it.
            let mut draft = draft.clone();
            draft.event_random[9] ^= 1;
            let correct = |next| record::seal(&draft, subjects, Outcome::Failure, Some("PUBLISH_FAILED"), next, key);
            let _ = ledger.append(key, correct, |_, _| Ok(()));
            return Err(error);
        }
        Ok(self.into_published(recorded.into_sealed(), draft.time.clone(), key))
    }

    /// A second digest of every file, for who accepts no SHA-256.
    fn add_sha384(&mut self) -> Result<()> {
        for subject in &mut self.subjects {
            let path = match (subject.name.strip_prefix(STORE_PREFIX), &self.merge) {
                (Some(name), Some(merge)) => merge.staged(name),
                _ => self.staging.join(&subject.name),
            };
            subject.digest.sha384 = Some(disk::sha384_file(&path)?);
        }
        Ok(())
    }

    fn write_seal(&self, sealed: &Sealed, proof: &Proof, key: &SigningKey) -> Result<()> {
        let line = sealed.envelope.to_line();
        let proof = proof.to_line();
        let pae = sealed.envelope.pae();
        let pems: Vec<String> = key.all().map(|k| k.public().to_pem()).collect();
        let chain = key.chain().map(CertChain::to_pem);
        let mut files = vec![(RECORD, line.as_slice()), (RECORD_PAE, &pae), (RECORD_PROOF, &proof)];
        files.extend([RECORD_SIG, RECORD_SIG_2].into_iter().zip(sealed.envelope.signatures.iter().map(|s| &s.sig[..])));
        files.extend([RECORD_KEY, RECORD_KEY_2].into_iter().zip(pems.iter().map(String::as_bytes)));
        files.extend(chain.as_ref().map(|pem| (RECORD_CHAIN, pem.as_bytes())));
        for (name, bytes) in files {
            self.disk.write_new(&self.staging.join(name), bytes).map_err(|e| self.in_words(name, e))?;
        }
        for entry in disk::walk(&self.staging)?.iter().filter(|e| e.is_dir) {
            self.disk.sync_dir(&entry.path)?;
        }
        self.disk.sync_dir(&self.staging)
    }

    fn publish(&mut self, recorded: &Recorded) -> Result<()> {
        if let Some(merge) = &mut self.merge {
            merge.apply(recorded, &self.destination)?;
        }
        // Should this or the rename fail, the merge is undone when it is dropped. The run may have been a long one: what was
        // free when it began need not be free now.
        check_free(&self.destination, self.replace, &self.own)?;
        let may_replace = self.replace || !self.own.is_empty();
        let old = put_in_place(&self.staging, &self.destination, may_replace, recorded, &self.disk)?;
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

    fn into_published(self, sealed: Sealed, time: TimeReading, key: &SigningKey) -> Published {
        let chain = &sealed.statement.predicate.chain;
        let mut signers = key.all().map(|k| k.public().fingerprint().to_owned());
        Published {
            folder: self.destination.clone(),
            outputs: sealed.statement.subject.iter().map(output).collect(),
            seq: chain.seq,
            ledger_id: chain.ledger_id.clone(),
            trail_hash: sealed.trail_hash,
            time,
            signed_by: signers.next().unwrap_or_default(),
            also_signed_by: signers.collect(),
        }
    }

    fn sidecar(&self) -> Result<Vec<u8>> {
        let Handling { marking, profile, authority, designation, .. } = &self.handling;
        let mut names: Vec<&str> = self.subjects.iter().map(|s| s.name.as_str()).collect();
        names.sort_unstable();
        let sidecar = Sidecar {
            schema: "orb.marking/v1",
            profile: *profile,
            banner: marking.banner(),
            ism: marking.ism(),
            authority: authority.as_ref(),
            cui_block: designation.as_ref(),
            applies_to: names,
        };
        let mut bytes = canonical::to_vec(&sidecar)
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

#[cfg(test)]
pub(crate) mod tests;
