//! Whose signatures count: `trust/` in the user's data folder, and the keys named on the command line.
//!
//! `FINGERPRINT.pem` is a public key, `ca/SHA256.pem` an authority's certificate, `crl/SHA256.pem` a revocation list;
//! beside a key or an authority may stand what is said of it, `.json` ([`Entry`]).

mod chain;
mod entry;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::canonical::{self, sha256_hex};
use super::data_folder::DataFolder;
use super::disk::{self, Disk};
use super::keys::{PublicKey, SigningKey};
use super::marking::Marking;
use super::pem;
use crate::{Error, Result};
pub use chain::{Authority, CertChain, Validity};
pub use entry::{Entry, Objection, Reason, Revocation, SCHEMA, Signed};

/// Largest revocation list that is read, bytes.
const MAX_CRL_BYTES: u64 = 32 << 20;

/// Keys by fingerprint, and authorities that say whose a key is. A bare key that a record brings along is never looked at.
#[derive(Clone, Debug, Default)]
pub struct TrustStore {
    keys: BTreeMap<String, (PublicKey, Entry)>,
    authorities: BTreeMap<String, Authority>,
    /// DER, by digest.
    crls: BTreeMap<String, Vec<u8>>,
    /// Chains that were brought along and lead to an authority, by the key's fingerprint.
    presented: BTreeMap<String, CertChain>,
}

/// Something that was taken into the trust store.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Added {
    Key(String),
    /// The two keys of a hybrid signer, which only count together.
    Pair(String, String),
    Authority(String),
    Crl(String),
}

impl TrustStore {
    /// Reads the user's trust store and `named` public keys. No data folder is made.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `ALG_REFUSED` or `TRUST_STORE_DAMAGED`, for a file that is not what it should be: a store
    /// that can only half be read is not used.
    pub fn load(data: &DataFolder, named: &[PathBuf]) -> Result<TrustStore> {
        let folder = data.path().join("trust");
        let mut store = TrustStore::default();
        for path in pem_files(&folder)? {
            for key in read_public(&path)? {
                store.keys.insert(key.fingerprint().to_owned(), (key, read_entry(&path)?));
            }
        }
        for path in pem_files(&folder.join("ca"))? {
            let authority = Authority::from_pem(&read_text(&path, pem::MAX_BYTES)?, read_entry(&path)?)
                .map_err(|found| damaged(&path, &found))?;
            store.authorities.insert(authority.sha256(), authority);
        }
        for path in pem_files(&folder.join("crl"))? {
            let der = read_crl(&path)?;
            store.crls.insert(sha256_hex(&der), der);
        }
        for path in named {
            for (key, entry) in together(read_public(path)?, &Entry::default()) {
                store.keys.entry(key.fingerprint().to_owned()).or_insert((key, entry));
            }
        }
        Ok(store)
    }

    /// The same store, if it is the one that its user wrote down.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `TRUST_STORE_CHANGED`.
    pub fn expect(self, sha256: Option<&str>) -> Result<TrustStore> {
        match sha256 {
            Some(expected) if expected != self.sha256() => Err(Error::policy("trust store")
                .expected(expected)
                .found(format!("TRUST_STORE_CHANGED: {}", self.sha256()))
                .advice("`orb audit key trust list` says what is in it. Keys named with --trust-key are part of it.")),
            _ => Ok(self),
        }
    }

    /// Trusts a key for everything; what is already said of it stays said.
    pub fn insert(&mut self, key: PublicKey) {
        self.keys.entry(key.fingerprint().to_owned()).or_insert((key, Entry::default()));
    }

    /// The key of this fingerprint, if it is trusted or an authority answers for it.
    pub fn get(&self, fingerprint: &str) -> Option<&PublicKey> {
        let own = self.keys.get(fingerprint).map(|(key, _)| key);
        own.or_else(|| self.presented.get(fingerprint).map(CertChain::key))
    }

    /// Looks at a chain that came with a signature; from then on its key is known. One that leads to no authority here is
    /// not.
    ///
    /// # Errors
    /// Words saying why not.
    pub fn present(&mut self, chain: CertChain) -> Result<(), String> {
        let authorities: Vec<Authority> = self.authorities.values().cloned().collect();
        chain::leads_to(&authorities, &chain)?;
        self.presented.insert(chain.key().fingerprint().to_owned(), chain);
        Ok(())
    }

    /// The chain by which a key is trusted; `None` for a key that is trusted itself.
    pub fn chain_of(&self, fingerprint: &str) -> Option<&CertChain> {
        if self.keys.contains_key(fingerprint) { None } else { self.presented.get(fingerprint) }
    }

    /// What stands against a good signature by this key, made then, on something marked so.
    pub fn judge(&self, fingerprint: &str, signed: Signed, marking: Option<&Marking>) -> Vec<Objection> {
        match (self.keys.get(fingerprint), self.presented.get(fingerprint)) {
            (Some((_, entry)), _) => entry.judge(signed, marking),
            (None, Some(chain)) => {
                let authorities: Vec<Authority> = self.authorities.values().cloned().collect();
                let crls: Vec<Vec<u8>> = self.crls.values().cloned().collect();
                chain::judge(&authorities, &crls, chain, signed, marking)
            }
            (None, None) => Vec::new(),
        }
    }

    /// Checks a time stamping authority's signature at a time: who it is (RFC 4514).
    ///
    /// # Errors
    /// Words saying why it does not count.
    pub(super) fn check_time_stamping(
        &self,
        chain: &[Vec<u8>],
        at_ms: u64,
        message: &[u8],
        sig: &[u8],
        digest_bits: usize,
    ) -> Result<String, String> {
        let authorities: Vec<Authority> = self.authorities.values().cloned().collect();
        let crls: Vec<Vec<u8>> = self.crls.values().cloned().collect();
        chain::check_time_stamping(&authorities, &crls, chain, at_ms)?;
        chain::check_signature(chain, message, sig, digest_bits)
    }

    /// The key without whose signature one by this key does not count.
    pub fn partner_of(&self, fingerprint: &str) -> Option<&str> {
        self.keys.get(fingerprint).and_then(|(_, entry)| entry.with.as_deref())
    }

    /// Nobody is trusted.
    pub fn is_empty(&self) -> bool {
        self.keys.is_empty() && self.authorities.is_empty()
    }

    /// The trusted keys and what is said of each.
    pub fn keys(&self) -> impl Iterator<Item = (&PublicKey, &Entry)> {
        self.keys.values().map(|(key, entry)| (key, entry))
    }

    pub fn authorities(&self) -> impl Iterator<Item = &Authority> {
        self.authorities.values()
    }

    /// SHA-256 of each revocation list.
    pub fn crls(&self) -> impl Iterator<Item = &str> {
        self.crls.keys().map(String::as_str)
    }

    /// SHA-256 over a line for each key, authority and list, sorted, with what is said of it: a store that was changed
    /// shows.
    pub fn sha256(&self) -> String {
        let said = |entry: &Entry| match entry {
            entry if *entry == Entry::default() => String::new(),
            entry => format!(" {}", String::from_utf8_lossy(&canonical::to_vec(entry).unwrap_or_default())),
        };
        let keys = self.keys.iter().map(|(k, (_, entry))| format!("{k}{}\n", said(entry)));
        let authorities = self.authorities.iter().map(|(k, a)| format!("ca {k}{}\n", said(&a.entry)));
        let crls = self.crls.keys().map(|k| format!("crl {k}\n"));
        sha256_hex(keys.chain(authorities).chain(crls).collect::<String>().as_bytes())
    }
}

/// The chains of certificates in a folder that need not exist, by the names of their files: of a published folder, or of
/// those beside a ledger. What is no chain is passed over: the verification says so.
///
/// # Errors
/// [`crate::Kind::Environment`] when the folder cannot be read.
pub fn chains_in(folder: &Path) -> Result<Vec<CertChain>> {
    let mut chains = Vec::new();
    for path in pem_files(folder)?.iter().filter(|path| fs::metadata(path).is_ok_and(|m| m.len() <= pem::MAX_BYTES)) {
        chains.extend(CertChain::from_pem(&read_text(path, pem::MAX_BYTES)?).ok());
    }
    Ok(chains)
}

/// Every `.pem` of a folder that need not exist, sorted.
fn pem_files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut paths = Vec::new();
    if folder.is_dir() {
        for entry in fs::read_dir(folder).map_err(|e| Error::io(folder, &e))? {
            let path = entry.map_err(|e| Error::io(folder, &e))?.path();
            if path.extension().is_some_and(|e| e == "pem") {
                paths.push(path);
            }
        }
    }
    paths.sort();
    Ok(paths)
}

fn read_text(path: &Path, limit: u64) -> Result<String> {
    Ok(String::from_utf8_lossy(&disk::read_limited(path, limit)?).into_owned())
}

fn damaged(path: &Path, found: &str) -> Error {
    Error::policy(path.display().to_string())
        .expected("a file that `orb audit key trust add` wrote")
        .found(format!("TRUST_STORE_DAMAGED: {found}"))
        .advice("Take it away and add the key again.")
}

fn read_entry(pem: &Path) -> Result<Entry> {
    let path = pem.with_extension("json");
    if !path.exists() {
        return Ok(Entry::default());
    }
    let entry: Entry = serde_json::from_slice(&disk::read_limited(&path, pem::MAX_BYTES)?)
        .map_err(|e| damaged(&path, &e.to_string()))?;
    entry.check(&path.display().to_string()).map_err(|e| damaged(&path, &e.found))?;
    Ok(entry)
}

fn read_crl(path: &Path) -> Result<Vec<u8>> {
    let der = pem::decode(chain::CRL, &read_text(path, MAX_CRL_BYTES)?).map_err(|found| damaged(path, &found))?;
    chain::check_crl(&der).map_err(|found| damaged(path, &found))?;
    Ok(der)
}

/// One key, or the two of a hybrid signer.
fn read_public(path: &Path) -> Result<Vec<PublicKey>> {
    PublicKey::all_from_pem(&read_text(path, pem::MAX_BYTES)?).map_err(|found| {
        Error::policy(path.display().to_string())
            .expected("a public key in PEM form: RSA, ML-DSA-87, or one of each")
            .found(format!("ALG_REFUSED: {found}"))
            .advice("`openssl pkey -in KEY.pem -pubout` writes the public half of a key.")
    })
}

/// What is said of each key: of two, that they count together only.
fn together(keys: Vec<PublicKey>, entry: &Entry) -> Vec<(PublicKey, Entry)> {
    let [first, second] = &keys[..] else { return keys.into_iter().map(|key| (key, entry.clone())).collect() };
    let with = |other: &PublicKey| Entry {
        schema: SCHEMA.into(),
        with: Some(other.fingerprint().to_owned()),
        ..entry.clone()
    };
    vec![(first.clone(), with(second)), (second.clone(), with(first))]
}

/// Trusts a signer's public key from now on, or both of them; false when they were known already.
pub(super) fn add(data: &DataFolder, key: &SigningKey) -> Result<bool> {
    let folder = data.subfolder("trust")?;
    let keys = key.all().map(|k| k.public().clone()).collect();
    let mut added = false;
    for (key, entry) in together(keys, &Entry::default()) {
        let path = folder.join(format!("{}.pem", key.fingerprint()));
        // What is there under this name must be this key, or the store would not load.
        if path.exists() {
            continue;
        }
        if entry != Entry::default() {
            write_entry(&path, &entry)?;
        }
        write_whole(&path, key.to_pem().as_bytes())?;
        added = true;
    }
    Ok(added)
}

/// Takes a public key, an authority's certificate or a revocation list (PEM) into the user's trust store, with what is said
/// of it; what was said before is replaced, but a revocation stays.
///
/// # Errors
/// [`crate::Kind::Policy`] for a file that is none of them; [`crate::Kind::Usage`] for an entry that says nothing
/// possible; [`crate::Kind::Environment`] when it cannot be written.
pub fn add_file(data: &DataFolder, file: &Path, entry: &Entry) -> Result<Added> {
    entry.check(&file.display().to_string())?;
    let text = read_text(file, MAX_CRL_BYTES)?;
    let refused = |found: String| {
        Error::policy(file.display().to_string())
            .expected("a public key, an authority's certificate or a revocation list, in PEM form")
            .found(format!("ALG_REFUSED: {found}"))
            .advice(
                "A signer's own certificate is not added: its authority's is, and the chain travels with the record.",
            )
    };
    let begins = |label: &str| text.trim_start().starts_with(&format!("-----BEGIN {label}-----"));
    if begins(chain::CRL) {
        let der = pem::decode(chain::CRL, &text).map_err(refused)?;
        chain::check_crl(&der).map_err(refused)?;
        let sha256 = sha256_hex(&der);
        let folder = data.subfolder("trust")?.join("crl");
        make_folder(&folder)?;
        write_whole(&folder.join(format!("{sha256}.pem")), pem::encode(chain::CRL, &der).as_bytes())?;
        return Ok(Added::Crl(sha256));
    }
    let folder = data.subfolder("trust")?;
    if begins(chain::CERTIFICATE) {
        let authority = Authority::from_pem(&text, entry.clone()).map_err(refused)?;
        let clean = pem::encode(chain::CERTIFICATE, &authority.der);
        write_with_words(&folder.join("ca"), &authority.sha256(), &clean, entry)?;
        return Ok(Added::Authority(authority.sha256()));
    }
    let keys = together(PublicKey::all_from_pem(&text).map_err(refused)?, entry);
    for (key, entry) in &keys {
        write_with_words(&folder, key.fingerprint(), &key.to_pem(), entry)?;
    }
    let mut names = keys.into_iter().map(|(key, _)| key.fingerprint().to_owned());
    let first = names.next().unwrap_or_default();
    Ok(match names.next() {
        None => Added::Key(first),
        Some(second) => Added::Pair(first, second),
    })
}

fn write_with_words(folder: &Path, name: &str, pem: &str, entry: &Entry) -> Result<()> {
    make_folder(folder)?;
    let path = folder.join(format!("{name}.pem"));
    let revoked = if path.exists() { read_entry(&path)?.revoked } else { None };
    // The words first: there is no moment in which a key is trusted for more than was said.
    write_entry(&path, &Entry { revoked, ..entry.clone() })?;
    write_whole(&path, pem.as_bytes())
}

/// Whether [`revoke`] may do so, for who has to tell of it before.
///
/// # Errors
/// As [`revoke`], but for the writing.
pub fn check_revoke(data: &DataFolder, fingerprint: &str, revocation: &Revocation) -> Result<()> {
    revoked(data, fingerprint, revocation).map(drop)
}

/// No longer trusts a key, from a time on.
///
/// # Errors
/// [`crate::Kind::Usage`] for a key that the store does not hold, or one that is revoked already from an earlier time or for
/// a compromise, and now for less; [`crate::Kind::Environment`] when it cannot be written.
pub fn revoke(data: &DataFolder, fingerprint: &str, revocation: Revocation) -> Result<()> {
    let (path, entry) = revoked(data, fingerprint, &revocation)?;
    write_entry(&path, &entry)
}

/// Where the key stands, and what is then said of it.
fn revoked(data: &DataFolder, fingerprint: &str, revocation: &Revocation) -> Result<(PathBuf, Entry)> {
    let path = data.path().join("trust").join(format!("{fingerprint}.pem"));
    let known = fingerprint.bytes().all(|b| b.is_ascii_hexdigit()) && path.is_file();
    if !known {
        return Err(Error::usage(fingerprint)
            .expected("the fingerprint of a trusted key")
            .found("none of them")
            .advice("`orb audit key trust list` shows them. An authority revokes by a list: add that."));
    }
    let mut entry = read_entry(&path)?;
    entry.schema = SCHEMA.into();
    if let Some(before) = &entry.revoked
        && before.from < revocation.from
    {
        return Err(Error::usage(fingerprint)
            .expected(format!("a time not after {}", before.from))
            .found(&revocation.from)
            .advice("The key is revoked since then; a revocation is not taken back."));
    }
    // A milder one would let count again what only a time stamp can prove to be older.
    if entry.revoked.as_ref().is_some_and(|before| before.reason == Reason::Compromise)
        && revocation.reason != Reason::Compromise
    {
        return Err(Error::usage(fingerprint)
            .expected("the reason compromise, for which the key is revoked already")
            .found(format!("{:?}", revocation.reason).to_lowercase())
            .advice("A compromise is not taken back; it can only be dated earlier."));
    }
    entry.revoked = Some(revocation.clone());
    entry.check(fingerprint)?;
    Ok((path, entry))
}

fn make_folder(path: &Path) -> Result<()> {
    fs::create_dir_all(path).map_err(|e| Error::io(path, &e))
}

fn write_entry(pem: &Path, entry: &Entry) -> Result<()> {
    let bytes = canonical::to_vec(entry).map_err(|f| Error::usage("trust entry").found(f.detail().to_owned()))?;
    write_whole(&pem.with_extension("json"), &bytes)
}

/// Written under another name first, so that a second run never reads half a file.
fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let thread = format!("{:?}", std::thread::current().id()).replace(['(', ')'], "-");
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let draft = path.with_file_name(format!(".{name}.{}.{thread}", std::process::id()));
    let disk = Disk::default();
    disk.write_new(&draft, bytes)?;
    disk.rename(&draft, path).inspect_err(|_| {
        let _ = fs::remove_file(&draft);
    })
}

#[cfg(test)]
pub(crate) mod tests;
