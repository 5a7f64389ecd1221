//! Key files: PKCS#8 in PEM form (RFC 7468 §10, §11), one key, or the two of a hybrid signer; encrypted or not; for their
//! owner's eyes only.

use std::fs::{self, File, OpenOptions};
use std::io::Write as _;
use std::path::{Path, PathBuf};

use aws_lc_rs::encoding::{AsDer as _, Pkcs8V1Der};
use aws_lc_rs::rsa::KeyPair;
use pkcs8::PrivateKeyInfo;
use zeroize::Zeroizing;

use super::public::{MAX_BITS, MIN_BITS, ML_DSA_87, NO_PAIR};
use super::{Holder, KeySource, Passphrase, SigningKey, encrypted, ml_dsa};
use crate::audit::disk::{self, Disk};
use crate::audit::pem;
use crate::{Error, Result};

pub(super) const PRIVATE_LABEL: &str = "PRIVATE KEY";

/// The bytes of a file that only its owner can read, 64 KiB at most.
///
/// # Errors
/// [`crate::Kind::Policy`], `KEY_PERMISSIONS`; [`crate::Kind::Environment`] when it cannot be read;
/// [`crate::Kind::Usage`] when it is too large.
pub fn private_file(path: &Path) -> Result<Zeroizing<Vec<u8>>> {
    let metadata = fs::metadata(path).map_err(|e| Error::io(path, &e))?;
    check_private(path, &metadata)?;
    Ok(Zeroizing::new(disk::read_limited(path, pem::MAX_BYTES)?))
}

/// The first line of a file that only its owner can read.
///
/// # Errors
/// As [`private_file`]; [`crate::Kind::Usage`] when it is no text.
pub fn passphrase_file(path: &Path) -> Result<Zeroizing<String>> {
    let bytes = private_file(path)?;
    let text = std::str::from_utf8(&bytes).map_err(|_| Error::usage(path.display().to_string()).expected("text"))?;
    Ok(Zeroizing::new(text.lines().next().unwrap_or_default().to_owned()))
}

/// The key of a file, or the two.
pub(super) fn load(path: &Path, passphrase: Option<&dyn Passphrase>, source: KeySource) -> Result<SigningKey> {
    let subject = path.display().to_string();
    let metadata = fs::metadata(path)
        .map_err(|e| Error::io(path, &e).advice("`orb audit keygen -o FILE` makes a key; name it with --key FILE."))?;
    if !metadata.is_file() {
        return Err(Error::usage(subject).expected("a PEM file").found("something else"));
    }
    check_private(path, &metadata)?;
    let bytes = Zeroizing::new(disk::read_limited(path, pem::MAX_BYTES)?);
    let text = std::str::from_utf8(&bytes).map_err(|_| not_a_key(path, "bytes that are not text".into()))?;
    // Asked for once, however many keys it opens.
    let mut words: Option<Zeroizing<String>> = None;
    let mut keys = Vec::new();
    let blocks = pem::blocks(text);
    if blocks.len() > 2 {
        return Err(not_a_key(path, NO_PAIR.into()));
    }
    for block in blocks {
        let der = if block.contains(encrypted::LABEL) {
            if words.is_none() {
                words = Some(ask(path, passphrase)?);
            }
            let sealed = pem::decode(encrypted::LABEL, block).map_err(|found| not_a_key(path, found))?;
            let opened = encrypted::decrypt(&sealed, words.as_deref().map_or("", String::as_str)).map_err(|found| {
                Error::policy(path.display().to_string())
                    .expected("the passphrase that opens the key")
                    .found(format!("PASSPHRASE_REFUSED: {found}"))
            })?;
            Zeroizing::new(opened.as_bytes().to_vec())
        } else {
            Zeroizing::new(pem::decode(PRIVATE_LABEL, block).map_err(|found| not_a_key(path, found))?)
        };
        let holder = from_pkcs8(&der).map_err(|found| {
            Error::policy(&subject)
                .expected(format!("an RSA key of {MIN_BITS} to {MAX_BITS} bits, or an ML-DSA-87 key"))
                .found(format!("ALG_REFUSED: {found}"))
        })?;
        let refused = |found: String| Error::policy(&subject).found(format!("ALG_REFUSED: {found}"));
        keys.push(SigningKey::new(holder, source).map_err(refused)?);
    }
    SigningKey::of_one_or_two(keys).map_err(|found| not_a_key(path, found))
}

fn not_a_key(path: &Path, found: String) -> Error {
    Error::usage(path.display().to_string())
        .expected("a private key in PKCS#8 PEM form")
        .found(found)
        .advice("`openssl pkcs8 -topk8 -v2 aes-256-cbc -in OLD.pem -out NEW.pem` converts other forms.")
}

fn ask(path: &Path, passphrase: Option<&dyn Passphrase>) -> Result<Zeroizing<String>> {
    let passphrase = passphrase.ok_or_else(|| {
        Error::policy(path.display().to_string())
            .expected("a passphrase for an encrypted key")
            .found("PASSPHRASE_REQUIRED: none")
            .advice("Say where it is with --key-passphrase file:PATH, env:NAME or prompt.")
    })?;
    passphrase.read()
}

fn from_pkcs8(der: &[u8]) -> std::result::Result<Holder, String> {
    let algorithm = PrivateKeyInfo::try_from(der).map(|info| info.algorithm.oid).ok();
    if algorithm == Some(ML_DSA_87) {
        return ml_dsa::Pair::from_pkcs8(der).map(Holder::MlDsa87);
    }
    KeyPair::from_pkcs8(der).map(Holder::Rsa).map_err(|e| e.to_string())
}

fn to_pkcs8(holder: &Holder) -> std::result::Result<Zeroizing<Vec<u8>>, String> {
    match holder {
        Holder::Rsa(pair) => {
            let der: Pkcs8V1Der<'_> = pair.as_der().map_err(|_| "the key cannot be encoded")?;
            Ok(Zeroizing::new(der.as_ref().to_vec()))
        }
        Holder::MlDsa87(pair) => pair.to_pkcs8(),
        Holder::Token(_) => Err("a key in a token, which it never leaves".into()),
    }
}

/// Writes the private key or keys (mode 0600 from the file's creation), under a passphrase if one is given, and beside it
/// `FILE.pub.pem`. Never over a file.
pub(super) fn save(key: &SigningKey, path: &Path, passphrase: Option<&str>) -> Result<()> {
    let public_path = public_path(path);
    for path in [path, &public_path] {
        if fs::symlink_metadata(path).is_ok() {
            return Err(Error::usage(path.display().to_string())
                .expected("a new file")
                .found("an existing one")
                .advice("A key is never overwritten: what it signed could no longer be verified."));
        }
    }
    let (mut text, mut public) = (Zeroizing::new(String::new()), String::new());
    for key in key.all() {
        let der = to_pkcs8(&key.holder).map_err(|found| Error::usage(path.display().to_string()).found(found))?;
        text.push_str(&match passphrase {
            None => Zeroizing::new(pem::encode(PRIVATE_LABEL, &der)),
            Some(words) => Zeroizing::new(pem::encode(encrypted::LABEL, encrypted::encrypt(&der, words)?.as_bytes())),
        });
        public.push_str(&key.public().to_pem());
    }
    write_private(path, text.as_bytes())?;
    let written = Disk::default().write_new(&public_path, public.as_bytes());
    if let Err(error) = written {
        // Half a key pair would stand in the way of the next attempt.
        let _ = fs::remove_file(path);
        return Err(error);
    }
    Ok(())
}

pub(super) fn public_path(path: &Path) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    path.with_file_name(format!("{stem}.pub.pem"))
}

/// The file has its mode from its creation: there is no moment in which others could open it.
pub(super) fn write_private(path: &Path, bytes: &[u8]) -> Result<()> {
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt as _;
        options.mode(0o600);
    }
    let write = |file: &mut File| file.write_all(bytes).and_then(|()| file.sync_all());
    let mut file = options.open(path).map_err(|e| disk::write_error(path, bytes.len(), &e))?;
    write(&mut file).map_err(|e| {
        let _ = fs::remove_file(path);
        disk::write_error(path, bytes.len(), &e)
    })
}

#[cfg(unix)]
fn check_private(path: &Path, metadata: &fs::Metadata) -> Result<()> {
    use std::os::unix::fs::PermissionsExt as _;
    let mode = metadata.permissions().mode() & 0o777;
    if mode & 0o077 == 0 {
        return Ok(());
    }
    Err(Error::policy(path.display().to_string())
        .expected("a private key that only its owner can read (mode 0600)")
        .found(format!("KEY_PERMISSIONS: mode {mode:04o}"))
        .advice(format!("If nobody else has read it: chmod 600 {}. Otherwise make a new key.", path.display())))
}

/// Elsewhere the profile folder's own access rules apply; they cannot be read without more libraries.
#[cfg(not(unix))]
fn check_private(_: &Path, _: &fs::Metadata) -> Result<()> {
    Ok(())
}
