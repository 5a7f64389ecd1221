//! The few operations that change a disk, each with an error that names the path, and each able to fail in a test.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write as _};
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256, Sha384};

use crate::{Error, Result};

/// The door to the file system. In tests it can be told to fail at the n-th operation.
#[derive(Clone, Debug, Default)]
pub(crate) struct Disk {
    #[cfg(test)]
    pub fault: Option<std::sync::Arc<fault::Plan>>,
}

impl Disk {
    #[cfg(not(test))]
    fn step(&self) -> io::Result<()> {
        Ok(())
    }
    #[cfg(test)]
    fn step(&self) -> io::Result<()> {
        self.fault.as_ref().map_or(Ok(()), |plan| plan.step(|| {}))
    }

    pub fn create_dir(&self, path: &Path) -> Result<()> {
        self.step().and_then(|()| fs::create_dir(path)).map_err(|e| Error::io(path, &e))
    }

    /// Also the missing folders above it.
    pub fn create_dir_all(&self, path: &Path) -> Result<()> {
        self.step().and_then(|()| fs::create_dir_all(path)).map_err(|e| Error::io(path, &e))
    }

    /// Writes a new file durably and returns its SHA-256, taken from what was handed to the system.
    pub fn write_new(&self, path: &Path, bytes: &[u8]) -> Result<String> {
        let write = || {
            self.step()?;
            let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
            let mut hash = Sha256::new();
            for chunk in bytes.chunks(1 << 20) {
                file.write_all(chunk)?;
                hash.update(chunk);
            }
            file.sync_all()?;
            Ok(hex::encode(hash.finalize()))
        };
        write().map_err(|e: io::Error| write_error(path, bytes.len(), &e))
    }

    /// Appends to an open file, durably. In a test the write can fail half-way.
    pub fn append(&self, file: &mut File, bytes: &[u8]) -> io::Result<()> {
        #[cfg(test)]
        self.fault.as_ref().map_or(Ok(()), |plan| plan.step(|| drop(file.write_all(&bytes[..bytes.len() / 2]))))?;
        file.write_all(bytes)?;
        self.step()?;
        file.sync_all()
    }

    pub fn rename(&self, from: &Path, to: &Path) -> Result<()> {
        self.step().and_then(|()| fs::rename(from, to)).map_err(|e| {
            let mut error = Error::io(to, &e);
            error.expected = format!("to be replaced by {}", from.display());
            error
        })
    }

    pub fn remove_file(&self, path: &Path) -> Result<()> {
        self.step().and_then(|()| fs::remove_file(path)).map_err(|e| Error::io(path, &e))
    }

    pub fn remove_dir(&self, path: &Path) -> Result<()> {
        self.step().and_then(|()| fs::remove_dir(path)).map_err(|e| Error::io(path, &e))
    }

    /// Nothing there is as good as removed.
    pub fn remove_dir_all(&self, path: &Path) -> Result<()> {
        match self.step().and_then(|()| fs::remove_dir_all(path)) {
            Err(e) if e.kind() != ErrorKind::NotFound => Err(Error::io(path, &e)),
            _ => Ok(()),
        }
    }

    /// Makes the names in a folder durable.
    pub fn sync_dir(&self, path: &Path) -> Result<()> {
        self.step().and_then(|()| sync_dir(path)).map_err(|e| Error::io(path, &e))
    }
}

#[cfg(unix)]
fn sync_dir(path: &Path) -> io::Result<()> {
    File::open(path)?.sync_all()
}

/// Elsewhere a folder cannot be opened as a file, and the system orders its names itself.
#[cfg(not(unix))]
fn sync_dir(_: &Path) -> io::Result<()> {
    Ok(())
}

/// An error of writing `length` bytes to `path`; a full disk says how much was needed.
pub(crate) fn write_error(path: &Path, length: usize, error: &io::Error) -> Error {
    match error.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::FileTooLarge => Error::io(path, error)
            .expected(format!("room for {length} more bytes"))
            .advice("Free some space or choose another place with -o. Nothing was published."),
        ErrorKind::AlreadyExists => Error::io(path, error).expected("a new file"),
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => Error::io(path, error)
            .expected("a place where this user may write")
            .advice("Choose another place with -o. Nothing was published."),
        _ => Error::io(path, error),
    }
}

/// Reads a whole file of at most `limit` bytes.
pub(crate) fn read_limited(path: &Path, limit: u64) -> Result<Vec<u8>> {
    use std::io::Read as _;
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(limit + 1).read_to_end(&mut bytes));
    read.map_err(|e| Error::io(path, &e))?;
    if bytes.len() as u64 > limit {
        return Err(Error::usage(path.display().to_string())
            .expected(format!("at most {limit} bytes"))
            .found("a larger file"));
    }
    Ok(bytes)
}

/// Size and SHA-256 of a file, read in pieces.
pub(crate) fn hash_file(path: &Path) -> io::Result<(u64, String)> {
    digest_file::<Sha256>(path)
}

/// SHA-384 of a file, which profiles beyond the default one state beside SHA-256.
pub(crate) fn sha384_file(path: &Path) -> Result<String> {
    digest_file::<Sha384>(path).map(|(_, sha384)| sha384).map_err(|e| Error::io(path, &e))
}

fn digest_file<D: Digest>(path: &Path) -> io::Result<(u64, String)> {
    use std::io::Read as _;
    let mut file = File::open(path)?;
    let (mut hash, mut size, mut buffer) = (D::new(), 0, vec![0; 1 << 16]);
    loop {
        let n = file.read(&mut buffer)?;
        if n == 0 {
            return Ok((size, hex::encode(hash.finalize())));
        }
        hash.update(&buffer[..n]);
        size += n as u64;
    }
}

/// Every folder and file below `root`, `/` between the parts, sorted; links are listed, never followed.
pub(crate) fn walk(root: &Path) -> Result<Vec<Entry>> {
    let mut out = Vec::new();
    let mut open = vec![(root.to_path_buf(), String::new())];
    while let Some((folder, prefix)) = open.pop() {
        let entries = fs::read_dir(&folder).map_err(|e| Error::io(&folder, &e))?;
        for entry in entries {
            let entry = entry.map_err(|e| Error::io(&folder, &e))?;
            let kind = entry.file_type().map_err(|e| Error::io(&entry.path(), &e))?;
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if kind.is_dir() {
                open.push((entry.path(), format!("{name}/")));
            }
            out.push(Entry { name, path: entry.path(), is_file: kind.is_file(), is_dir: kind.is_dir() });
            if out.len() > MAX_ENTRIES {
                return Err(Error::usage(root.display().to_string())
                    .expected(format!("at most {MAX_ENTRIES} files"))
                    .found("more: LIMIT_EXCEEDED"));
            }
        }
    }
    out.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(out)
}

/// More than any published folder holds.
const MAX_ENTRIES: usize = 100_000;

pub(crate) struct Entry {
    pub name: String,
    pub path: PathBuf,
    pub is_file: bool,
    pub is_dir: bool,
}

/// Checks a relative name: parts divided by `/`, none empty, `.` or `..`, nothing that a file system somewhere reads
/// as a drive, a stream, a wildcard or a separator. `Err` says why it is refused.
pub(crate) fn check_name(name: &str) -> Result<(), String> {
    if name.is_empty() || name.len() > 1024 {
        return Err("an empty or very long name".into());
    }
    for part in name.split('/') {
        match part {
            "" => return Err("an absolute path or an empty part".into()),
            "." | ".." => return Err(format!("a part {part:?}")),
            _ if part.len() > 255 => return Err("a part longer than 255 bytes".into()),
            _ if part.ends_with([' ', '.']) => return Err("a part that ends in a space or a full stop".into()),
            _ => {}
        }
        if let Some(c) = part.chars().find(|c| c.is_control() || r#"\:*?"<>|"#.contains(*c)) {
            return Err(format!("the character {c:?}"));
        }
    }
    Ok(())
}

#[cfg(test)]
pub(crate) mod fault {
    use std::io;
    use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

    /// Fails the operation number `at` (from 0), and with `crash` every later one too, as after a kill; with `kill` the
    /// process gets the signal that no process can catch.
    #[derive(Debug)]
    pub struct Plan {
        pub at: u64,
        pub crash: bool,
        pub kill: bool,
        pub kind: io::ErrorKind,
        done: AtomicU64,
        pub hit: AtomicBool,
    }

    impl Plan {
        pub fn new(at: u64, crash: bool, kind: io::ErrorKind) -> std::sync::Arc<Plan> {
            Plan { at, crash, kill: false, kind, done: AtomicU64::new(0), hit: AtomicBool::new(false) }.into()
        }
        pub fn killing(at: u64) -> std::sync::Arc<Plan> {
            let (kind, done, hit) = (io::ErrorKind::Other, AtomicU64::new(0), AtomicBool::new(false));
            Plan { at, crash: true, kill: true, kind, done, hit }.into()
        }
        /// `half`: what the operation has done when it fails.
        pub fn step(&self, half: impl FnOnce()) -> io::Result<()> {
            let n = self.done.fetch_add(1, Ordering::SeqCst);
            if n == self.at || (self.crash && n > self.at) {
                if n == self.at {
                    half();
                }
                #[cfg(unix)]
                if self.kill {
                    // SAFETY: two system calls without pointers; the second does not return.
                    unsafe { libc::kill(libc::getpid(), libc::SIGKILL) };
                }
                self.hit.store(true, Ordering::SeqCst);
                return Err(self.kind.into());
            }
            Ok(())
        }
        pub fn was_hit(&self) -> bool {
            self.hit.load(Ordering::SeqCst)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_stay_inside() {
        for name in ["a", "a/b.c", "X.cdb/Tiles/N34/W119/D300_S001_T001_L00_U0_R0.zip", "été/façade.ply"] {
            assert_eq!(check_name(name), Ok(()), "{name}");
        }
        for name in
            ["", "/a", "a/", "a//b", ".", "..", "a/../b", "./a", "C:/a", "a\\b", "a:b", "a\nb", "a\0", "a.", "a ", "a*"]
        {
            assert!(check_name(name).is_err(), "{name:?}");
        }
        assert!(check_name(&"x".repeat(256)).is_err());
    }

    #[test]
    fn a_full_disk_says_how_much_was_needed() {
        let dir = tempfile::tempdir().unwrap();
        let disk = Disk { fault: Some(fault::Plan::new(0, false, ErrorKind::StorageFull)) };
        let error = disk.write_new(&dir.path().join("x.bin"), &[0; 1234]).unwrap_err();
        assert_eq!(error.kind, crate::Kind::Environment);
        assert!(error.subject.ends_with("x.bin") && error.expected.contains("1234"), "{error}");
    }

    #[test]
    fn writing_hashes_what_was_written() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a");
        let bytes: Vec<u8> = (0..3_000_000u32).map(|i| (i * 7) as u8).collect();
        let hash = Disk::default().write_new(&path, &bytes).unwrap();
        assert_eq!(hash_file(&path).unwrap(), (3_000_000, hash));
        assert!(Disk::default().write_new(&path, b"again").is_err(), "never over an existing file");
    }
}
