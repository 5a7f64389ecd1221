//! Which key a run signs with, and whether it may.

use std::fs::{self, OpenOptions};
use std::path::Path;

use super::algorithm::{Bits, Suite};
use super::file::public_path;
use super::{ADVISED_BITS, KeySource, Named, SigningKey};
use crate::audit::data_folder::DataFolder;
use crate::audit::disk::Disk;
use crate::audit::marking::Marking;
use crate::audit::time;
use crate::audit::trust::{self, Signed, TrustStore};
use crate::{Error, Kind, Result};

/// The user's own key, in the data folder's `keys`.
const OWN_KEY: &str = "orb-signing.pem";

/// A key for a run, and what the user should be told about it.
#[derive(Debug)]
pub struct KeyForRun {
    pub key: SigningKey,
    /// This run made it.
    pub created: bool,
    /// It was in no trust store of this user before.
    pub newly_trusted: bool,
    pub warning: Option<String>,
}

/// The key for a product of this marking: the named file, or below CUI the user's own, made on the first run.
///
/// Its public half is trusted from then on by this user, unless certificates came with it: then their authority has to be.
/// Two first runs at once make one key.
///
/// # Errors
/// [`Kind::Policy`], `KEY_REQUIRED`, for CUI and above without a named key, `KEY_REVOKED`, `KEY_EXPIRED`, `KEY_SCOPE`,
/// `CERT_EXPIRED`, `CERT_REVOKED` for one that this user's trust store objects to; else as [`SigningKey::load`].
pub fn for_marking(data: &DataFolder, marking: &Marking, named: Option<Named<'_>>) -> Result<KeyForRun> {
    let (key, created) = match named {
        Some(named) => (SigningKey::load(named, KeySource::NamedFile)?, false),
        None if marking.needs_named_key() => {
            return Err(Error::policy("--key")
                .expected(format!("a signing key named for a product marked {marking}"))
                .found("KEY_REQUIRED: none")
                .advice("Name one with --key FILE; `orb audit keygen -o FILE` makes one."));
        }
        None => own_key(data)?,
    };
    let newly_trusted = key.chain().is_none() && trust::add(data, &key)?;
    check_standing(data, &key, marking)?;
    let warning = key
        .public()
        .short_bits()
        .map(|bits| format!("the signing key has {bits} bits; {ADVISED_BITS} or more are advised"));
    Ok(KeyForRun { key, created, newly_trusted, warning })
}

/// A key that this user's own trust store objects to signs nothing.
fn check_standing(data: &DataFolder, key: &SigningKey, marking: &Marking) -> Result<()> {
    let signed = Signed { stated_ms: time::now()?.unix_ms, proven_ms: None };
    let mut store = TrustStore::load(data, &[])?;
    if let Some(chain) = key.chain() {
        // Where no authority is trusted, others judge.
        let _ = store.present(chain.clone());
    }
    let objections = key.all().flat_map(|k| store.judge(k.public().fingerprint(), signed, Some(marking)));
    match objections.into_iter().find(|o| !o.code.ends_with("_LATER")) {
        None => Ok(()),
        Some(o) => Err(Error::policy("--key")
            .expected(o.expected)
            .found(format!("{}: {}", o.code, o.actual))
            .advice("Sign with another key; `orb audit key trust list` says what is said of each.")),
    }
}

/// The user's own key, made and trusted if there is none; true when it was made.
///
/// # Errors
/// As [`SigningKey::load`].
pub(in crate::audit) fn own(data: &DataFolder) -> Result<(SigningKey, bool)> {
    let (key, created) = own_key(data)?;
    if created {
        trust::add(data, &key)?;
    }
    Ok((key, created))
}

/// Whether the user has an own key already.
pub(in crate::audit) fn has_own(data: &DataFolder) -> bool {
    data.path().join("keys").join(OWN_KEY).is_file()
}

fn own_key(data: &DataFolder) -> Result<(SigningKey, bool)> {
    let folder = data.subfolder("keys")?;
    let path = folder.join(OWN_KEY);
    let lock_path = folder.join("lock");
    let lock = OpenOptions::new().create(true).append(true).open(&lock_path).map_err(|e| Error::io(&lock_path, &e))?;
    // Held until the file is closed: a second first run waits here and then finds the key.
    lock.lock().map_err(|e| Error::io(&lock_path, &e))?;
    if fs::symlink_metadata(&path).is_ok() {
        return Ok((SigningKey::load(&path, KeySource::UserData)?, false));
    }
    let key = SigningKey::generate(KeySource::UserData, Bits::default())?;
    // A kill between the two files leaves a public key without its private half: it is worth nothing.
    let _ = fs::remove_file(public_path(&path));
    key.save(&path, None)?;
    Disk::default().sync_dir(&folder)?;
    Ok((key, true))
}

/// Makes a key file on request.
///
/// # Errors
/// As [`SigningKey::generate_for`] and [`SigningKey::save`].
pub fn keygen(path: &Path, suite: Suite, bits: Bits, passphrase: Option<&str>) -> Result<SigningKey> {
    if path.file_name().is_none() {
        return Err(Error::new(Kind::Usage, path.display().to_string()).expected("the name of a new file"));
    }
    let key = SigningKey::generate_for(suite, KeySource::NamedFile, bits)?;
    key.save(path, passphrase)?;
    Ok(key)
}
