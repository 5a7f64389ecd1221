//! The public keys whose signatures count: `trust/` in the user's data folder, and those named on the command line.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::canonical::sha256_hex;
use super::data_folder::DataFolder;
use super::disk::{self, Disk};
use super::keys::PublicKey;
use super::pem;
use crate::{Error, Result};

/// Keys by fingerprint. A key that a record brings along is never looked at.
#[derive(Clone, Debug, Default)]
pub struct TrustStore {
    keys: BTreeMap<String, PublicKey>,
}

impl TrustStore {
    /// Reads the user's trusted keys and `named` ones. No data folder is made.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `ALG_REFUSED`, for a file that is not an acceptable public key: a store that can only
    /// half be read is not used.
    pub fn load(data: &DataFolder, named: &[PathBuf]) -> Result<TrustStore> {
        let folder = data.path().join("trust");
        let mut paths = Vec::new();
        if folder.is_dir() {
            for entry in fs::read_dir(&folder).map_err(|e| Error::io(&folder, &e))? {
                let path = entry.map_err(|e| Error::io(&folder, &e))?.path();
                if path.extension().is_some_and(|e| e == "pem") {
                    paths.push(path);
                }
            }
        }
        let mut store = TrustStore::default();
        for path in paths.iter().chain(named) {
            store.insert(read_public(path)?);
        }
        Ok(store)
    }

    pub fn insert(&mut self, key: PublicKey) {
        self.keys.insert(key.fingerprint().to_owned(), key);
    }

    pub fn get(&self, fingerprint: &str) -> Option<&PublicKey> {
        self.keys.get(fingerprint)
    }

    pub fn is_empty(&self) -> bool {
        self.keys.is_empty()
    }

    /// SHA-256 over the sorted fingerprints, a line each: a store that was changed shows.
    pub fn sha256(&self) -> String {
        let lines: String = self.keys.keys().map(|k| format!("{k}\n")).collect();
        sha256_hex(lines.as_bytes())
    }
}

fn read_public(path: &Path) -> Result<PublicKey> {
    let bytes = disk::read_limited(path, pem::MAX_BYTES)?;
    let text = String::from_utf8_lossy(&bytes);
    PublicKey::from_pem(&text).map_err(|found| {
        Error::policy(path.display().to_string())
            .expected("an RSA public key in PEM form")
            .found(format!("ALG_REFUSED: {found}"))
            .advice("`openssl pkey -in KEY.pem -pubout` writes the public half of a key.")
    })
}

/// Trusts a public key from now on.
pub(super) fn add(data: &DataFolder, key: &PublicKey) -> Result<()> {
    let folder = data.subfolder("trust")?;
    let path = folder.join(format!("{}.pem", key.fingerprint()));
    // What is there under this name must be this key, or the store would not load.
    if path.exists() {
        return Ok(());
    }
    // Written under another name first, so that a second run never reads half a key.
    let thread = format!("{:?}", std::thread::current().id()).replace(['(', ')'], "-");
    let draft = folder.join(format!(".{}.{}.{thread}", key.fingerprint(), std::process::id()));
    let disk = Disk::default();
    disk.write_new(&draft, key.to_pem().as_bytes())?;
    disk.rename(&draft, &path).inspect_err(|_| {
        let _ = fs::remove_file(&draft);
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::keys::tests::{other_key, shared_key};

    #[test]
    fn own_and_named_keys() {
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path().join("data"));
        let empty = TrustStore::load(&data, &[]).unwrap();
        assert!(empty.is_empty() && !data.path().exists());

        add(&data, shared_key().public()).unwrap();
        add(&data, shared_key().public()).unwrap();
        let store = TrustStore::load(&data, &[]).unwrap();
        assert_eq!(store.get(shared_key().public().fingerprint()), Some(shared_key().public()));
        assert_eq!(store.get(other_key().public().fingerprint()), None);
        assert_ne!(store.sha256(), empty.sha256());

        let named = dir.path().join("other.pem");
        fs::write(&named, other_key().public().to_pem()).unwrap();
        let both = TrustStore::load(&data, std::slice::from_ref(&named)).unwrap();
        assert!(both.get(other_key().public().fingerprint()).is_some());

        fs::write(&named, "not a key").unwrap();
        let error = TrustStore::load(&data, &[named]).unwrap_err();
        assert!(error.found.contains("ALG_REFUSED"), "{error}");
    }
}
