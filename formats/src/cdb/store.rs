//! Where a CDB's files come from.

use std::collections::BTreeMap;
use std::io;

use crate::{Error, File, Result};

/// An existing CDB. Paths are relative to its root, `/` between folders.
pub trait Store {
    /// A file's bytes; `None` when there is no such file.
    fn read(&self, path: &str) -> io::Result<Option<Vec<u8>>>;

    /// Whether there is such a file, be it one of zero bytes, which stands for a deleted one.
    fn exists(&self, path: &str) -> io::Result<bool> {
        Ok(self.size(path)?.is_some())
    }

    /// Bytes of a file; `None` when there is no such file.
    fn size(&self, path: &str) -> io::Result<Option<u64>> {
        Ok(self.read(path)?.map(|bytes| bytes.len() as u64))
    }
}

/// A CDB whose files can be listed.
pub trait ListableStore: Store {
    /// The paths of all files.
    fn list(&self) -> io::Result<Vec<String>>;
}

/// No store yet: the first model makes one.
#[derive(Clone, Copy, Debug, Default)]
pub struct Empty;

impl Store for Empty {
    fn read(&self, _: &str) -> io::Result<Option<Vec<u8>>> {
        Ok(None)
    }
}

/// Several versions as one store: what the first has counts before the same path of the next.
///
/// Source: OGC CDB 1.x Volume 1, §3.2 "Versioning". The Metadata of a version is its own.
pub struct Versions<'a> {
    /// Newest first.
    stores: Vec<&'a dyn Store>,
}

impl<'a> Versions<'a> {
    pub fn new(stores: Vec<&'a dyn Store>) -> Self {
        Versions { stores }
    }

    fn of(&self, path: &str) -> &[&'a dyn Store] {
        if path.starts_with("Metadata/") { &self.stores[..self.stores.len().min(1)] } else { &self.stores }
    }
}

impl Store for Versions<'_> {
    fn read(&self, path: &str) -> io::Result<Option<Vec<u8>>> {
        for store in self.of(path) {
            if let Some(bytes) = store.read(path)? {
                return Ok(Some(bytes));
            }
        }
        Ok(None)
    }

    fn exists(&self, path: &str) -> io::Result<bool> {
        for store in self.of(path) {
            if store.exists(path)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn size(&self, path: &str) -> io::Result<Option<u64>> {
        for store in self.of(path) {
            if let Some(size) = store.size(path)? {
                return Ok(Some(size));
            }
        }
        Ok(None)
    }
}

/// A store in memory.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Memory {
    pub files: BTreeMap<String, Vec<u8>>,
}

impl Memory {
    /// Takes files in, replacing older ones of the same path.
    pub fn write(&mut self, files: impl IntoIterator<Item = File>) {
        self.files.extend(files.into_iter().map(|f| (f.path, f.bytes)));
    }
}

impl Store for Memory {
    fn read(&self, path: &str) -> io::Result<Option<Vec<u8>>> {
        Ok(self.files.get(path).cloned())
    }

    fn exists(&self, path: &str) -> io::Result<bool> {
        Ok(self.files.contains_key(path))
    }

    fn size(&self, path: &str) -> io::Result<Option<u64>> {
        Ok(self.files.get(path).map(|bytes| bytes.len() as u64))
    }
}

impl ListableStore for Memory {
    fn list(&self) -> io::Result<Vec<String>> {
        Ok(self.files.keys().cloned().collect())
    }
}

/// Reads a file; one of zero bytes means "deleted" in a CDB.
pub fn read(store: &dyn Store, path: &str) -> Result<Option<Vec<u8>>> {
    Ok(store.read(path).map_err(|e| unreadable(path, &e))?.filter(|b| !b.is_empty()))
}

/// Reads a text file.
pub fn read_text(store: &dyn Store, path: &str) -> Result<Option<String>> {
    let Some(bytes) = read(store, path)? else { return Ok(None) };
    String::from_utf8(bytes).map(Some).map_err(|e| unreadable(path, &e))
}

/// Whether [`read`] would find a file: one of zero bytes was deleted.
pub fn exists(store: &dyn Store, path: &str) -> Result<bool> {
    // A store may have to read a file to tell its size.
    let there = || -> io::Result<bool> { Ok(store.exists(path)? && store.size(path)?.is_some_and(|size| size > 0)) };
    there().map_err(|e| unreadable(path, &e))
}

/// The error of a file that stands in the way.
pub fn unreadable(path: &str, reason: &dyn std::fmt::Display) -> Error {
    Error::Unsupported { format: "CDB store", what: format!("{path} cannot be read: {reason}") }
}
