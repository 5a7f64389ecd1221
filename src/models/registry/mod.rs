//! The networks that a user imported: where they lie, what they are, whether they are still what was imported.
//!
//! A folder a network, `<data>/models/<id>/`, with its files and `manifest.json`. A run hashes every file that it loads and
//! stops where one changed.

pub mod catalogue;
pub mod family;
mod import;

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::audit::disk::{check_name, hash_file, walk};
use crate::{Error, Result};
use catalogue::DepthKind;
pub use family::{Family, Role, Stage};
pub use import::{Import, Limits, import};

const MANIFEST: &str = "manifest.json";

/// A file of a network.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct File {
    /// Below the network's folder, with `/`.
    pub path: String,
    pub bytes: u64,
    pub sha256: String,
}

/// A graph of a network.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    pub role: Role,
    pub path: String,
}

/// What an imported network is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    pub schema: u32,
    pub id: String,
    pub version: String,
    pub family: Family,
    pub licence: String,
    pub commercial: bool,
    /// Every file's SHA-256 stands in the catalogue; else the user vouched for them with `--allow-unpinned`.
    pub pinned: bool,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth_kind: Option<DepthKind>,
    pub parts: Vec<Part>,
    pub files: Vec<File>,
}

impl Manifest {
    /// One hash for all files: SHA-256 over the lines `<sha256>  <path>\n` in the order of the paths, as `sha256sum`
    /// prints them; for a single file its own.
    pub fn weights_sha256(&self) -> String {
        of_files(self.files.iter().map(|f| (f.path.as_str(), f.sha256.as_str())).collect())
    }

    pub fn bytes(&self) -> u64 {
        self.files.iter().map(|f| f.bytes).sum()
    }

    /// As a record names where the pin comes from.
    pub fn pin_source(&self) -> &'static str {
        if self.pinned { "catalogue" } else { "unverified" }
    }
}

/// As [`Manifest::weights_sha256`], of paths and SHA-256.
fn of_files(mut files: Vec<(&str, &str)>) -> String {
    if let [(_, only)] = files.as_slice() {
        return (*only).to_owned();
    }
    files.sort_unstable();
    let lines: String = files.iter().map(|(path, sha256)| format!("{sha256}  {path}\n")).collect();
    crate::audit::canonical::sha256_hex(lines.as_bytes())
}

/// As [`Manifest::weights_sha256`], of a file, or of a folder of one network as it stands on the disk: as `orb models` keeps
/// it, or as it came.
///
/// # Errors
/// An environment error for what cannot be read.
pub fn weights_sha256(path: &Path) -> Result<String> {
    let hash = |path: &Path| hash_file(path).map(|(_, sha256)| sha256).map_err(|e| Error::io(path, &e));
    if !path.is_dir() {
        return hash(path);
    }
    let files = walk(path)?;
    let files: Vec<(String, String)> = files
        .into_iter()
        .filter(|f| f.is_file && f.name != MANIFEST)
        .map(|f| Ok((f.name, hash(&f.path)?)))
        .collect::<Result<_>>()?;
    Ok(of_files(files.iter().map(|(path, sha256)| (path.as_str(), sha256.as_str())).collect()))
}

/// The folder of imported networks.
#[derive(Clone, Debug)]
pub struct Registry {
    root: PathBuf,
}

impl Registry {
    pub fn at(root: impl Into<PathBuf>) -> Registry {
        Registry { root: root.into() }
    }

    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Every network, by name.
    ///
    /// # Errors
    /// An environment error when the folder cannot be read, an integrity error for a manifest that is not one.
    pub fn list(&self) -> Result<Vec<Manifest>> {
        let entries = match std::fs::read_dir(&self.root) {
            Ok(entries) => entries,
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
            Err(e) => return Err(Error::io(&self.root, &e)),
        };
        let mut names: Vec<String> = entries
            .flatten()
            .filter(|e| e.path().join(MANIFEST).is_file())
            .filter_map(|e| e.file_name().into_string().ok())
            .filter(|n| !n.starts_with('.'))
            .collect();
        names.sort();
        names.iter().map(|n| self.get(n)).collect()
    }

    /// One network.
    ///
    /// # Errors
    /// A usage error when it is not there, an integrity error for a manifest that is not one.
    pub fn get(&self, id: &str) -> Result<Manifest> {
        check_id(id)?;
        let path = self.root.join(id).join(MANIFEST);
        let text = std::fs::read_to_string(&path).map_err(|e| match e.kind() {
            std::io::ErrorKind::NotFound => Error::usage(format!("network {id}"))
                .expected("one that was imported")
                .found(format!("nothing in {}", self.root.display()))
                .advice("`orb models list` shows what is there, `orb models import` adds to it."),
            _ => Error::io(&path, &e),
        })?;
        let damaged = |found: String| {
            Error::integrity(path.display().to_string())
                .expected("the manifest that the import wrote")
                .found(found)
                .advice(format!("Remove the network (`orb models remove {id}`) and import it again."))
        };
        let manifest: Manifest = serde_json::from_str(&text).map_err(|e| damaged(e.to_string()))?;
        let roles_there = |role: &Role| manifest.parts.iter().any(|p| p.role == *role);
        if manifest.id != id || manifest.schema != 1 || !manifest.family.roles().iter().all(roles_there) {
            return Err(damaged("another network, or one without all its parts".into()));
        }
        let inside = |path: &str| check_name(path).is_ok();
        if !manifest.files.iter().all(|f| inside(&f.path))
            || !manifest.parts.iter().all(|p| manifest.files.iter().any(|f| f.path == p.path))
        {
            return Err(damaged("paths that lead out of its folder, or to no file".into()));
        }
        Ok(manifest)
    }

    /// Hashes every file. A network that passed can be loaded.
    ///
    /// # Errors
    /// An integrity error naming the file that is missing or has changed.
    pub fn verified(&self, manifest: &Manifest) -> Result<Network> {
        let folder = self.root.join(&manifest.id);
        for file in &manifest.files {
            let path = folder.join(&file.path);
            let changed = |found: String| {
                Error::integrity(path.display().to_string())
                    .expected(format!("SHA-256 {}, as imported", file.sha256))
                    .found(found)
                    .advice(format!("The weights changed on disk. Import network {} again.", manifest.id))
            };
            let (bytes, sha256) = hash_file(&path).map_err(|e| changed(e.to_string()))?;
            if sha256 != file.sha256 || bytes != file.bytes {
                return Err(changed(format!("MODEL_DIGEST: {sha256}")));
            }
        }
        Ok(Network { manifest: manifest.clone(), folder })
    }

    /// Removes a network. Returns its folder.
    ///
    /// # Errors
    /// As [`Registry::get`]; a damaged manifest does not keep a network from being removed.
    pub fn remove(&self, id: &str) -> Result<PathBuf> {
        if let Err(e) = self.get(id)
            && e.kind != crate::Kind::Integrity
        {
            return Err(e);
        }
        let folder = self.root.join(id);
        std::fs::remove_dir_all(&folder).map_err(|e| Error::io(&folder, &e))?;
        Ok(folder)
    }
}

/// A network whose files were hashed and found as imported.
#[derive(Clone, Debug)]
pub struct Network {
    pub manifest: Manifest,
    folder: PathBuf,
}

impl Network {
    /// Whether there is such a part.
    pub fn has(&self, role: Role) -> bool {
        self.manifest.parts.iter().any(|p| p.role == role)
    }

    /// The file of a part.
    ///
    /// # Errors
    /// An integrity error when the manifest has none: [`Registry::get`] looked, so this does not happen.
    pub fn path(&self, role: Role) -> Result<PathBuf> {
        let part = self.manifest.parts.iter().find(|p| p.role == role).ok_or_else(|| {
            Error::integrity(format!("network {}", self.manifest.id)).expected(format!("a {}", role.name()))
        })?;
        Ok(self.folder.join(&part.path))
    }
}

/// Small letters, digits, `.`, `-`, `_`; 1 to 64; no dot in front.
fn check_id(id: &str) -> Result<()> {
    let good = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'_');
    if id.is_empty() || id.len() > 64 || id.starts_with('.') || !id.bytes().all(good) {
        return Err(Error::usage("network")
            .expected("a name of small letters, digits, `.`, `-` and `_`")
            .found(format!("`{id}`")));
    }
    Ok(())
}

#[cfg(test)]
pub(crate) mod tests;
