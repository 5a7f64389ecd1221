//! The destination of a publication: is it free, may it be replaced, and the rename itself.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::{RECORD, SEAL_FILES};
use crate::audit::disk::{self, Disk};
use crate::audit::dsse::{Envelope, MAX_ENVELOPE_BYTES};
use crate::audit::file_lock::FileLock;
use crate::audit::ledger::Recorded;
use crate::audit::statement::Statement;
use crate::{Error, Result};

/// `.<name>.orb-<suffix>`, beside the destination.
pub(super) fn beside(name: &std::ffi::OsStr, suffix: &str) -> OsString {
    let mut out = OsString::from(".");
    out.push(name);
    out.push(".orb-");
    out.push(suffix);
    out
}

/// The folder that a new one will lie in, whole, and its name.
pub(super) fn parent_and_name(folder: &Path) -> Result<(PathBuf, OsString)> {
    let absolute = std::path::absolute(folder).map_err(|e| Error::io(folder, &e))?;
    let (Some(parent), Some(name)) = (absolute.parent(), absolute.file_name()) else {
        return Err(Error::usage(folder.display().to_string())
            .expected("the name of a new folder")
            .advice("Choose another place with -o."));
    };
    let parent = parent.canonicalize().map_err(|e| {
        Error::io(parent, &e)
            .expected("an existing folder to publish in")
            .advice("Make it first, or choose another place with -o.")
    })?;
    Ok((parent, name.to_owned()))
}

/// Refuses a destination that is not free, and in it files that Orb did not write. Those of the names in `own` are the run's.
pub(super) fn check_free(folder: &Path, replace: bool, own: &[String]) -> Result<()> {
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
    if entries.iter().all(|e| !e.is_dir && own.contains(&e.name)) {
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
            "Choose another place with -o, or allow it to be replaced with --replace.",
        ));
    }
    let listed = listed_names(&record_path)?;
    match entries.iter().find(|e| !e.is_dir && !listed.contains(&e.name) && !own.contains(&e.name)) {
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

/// Renames the staging folder to its destination, once its record stands; an older folder that stood there is returned under
/// its new name. Unless one may be replaced, only nothing and an empty folder give way.
pub(super) fn put_in_place(
    staging: &Path,
    destination: &Path,
    may_replace: bool,
    _recorded: &Recorded,
    disk: &Disk,
) -> Result<Option<PathBuf>> {
    // POSIX: a renamed folder takes the place of an empty one, and of no other that appeared since it was looked for.
    if fs::symlink_metadata(destination).is_err() || (cfg!(unix) && !may_replace) {
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
pub(super) fn exchange(a: &Path, b: &Path, disk: &Disk) -> Result<bool> {
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
pub(super) fn exchange(_: &Path, _: &Path, _: &Disk) -> Result<bool> {
    Ok(false)
}

/// Shows other runs that this staging folder is alive.
#[cfg(unix)]
pub(super) fn lock_dir(path: &Path) -> std::io::Result<Option<FileLock>> {
    let file = File::open(path)?;
    // A file system without locks: nothing is swept there either.
    Ok(FileLock::try_take(file).ok())
}

#[cfg(not(unix))]
pub(super) fn lock_dir(_: &Path) -> std::io::Result<Option<FileLock>> {
    Ok(None)
}

/// Sweeps what killed runs left beside this destination; an older result that a kill left aside is put back.
#[cfg(unix)]
pub(super) fn sweep(parent: &Path, name: &std::ffi::OsStr, disk: &Disk) {
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
pub(super) fn sweep(_: &Path, _: &std::ffi::OsStr, _: &Disk) {}
