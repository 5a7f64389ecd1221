//! Files that are read whole or not at all: a kind of eight bytes, the SHA-256 of the contents, the contents.

use std::fs::{self, DirBuilder, File};
use std::io::{Result, Write as _};
use std::path::Path;

use sha2::{Digest, Sha256};

const HEAD: usize = 8 + 32;

/// What was found.
#[derive(Debug, PartialEq, Eq)]
pub enum Found {
    Whole(Vec<u8>),
    /// It does not begin with the kind asked for.
    Other,
    /// Cut off or changed.
    Damaged,
}

/// Reads a file of this kind.
///
/// # Errors
/// It cannot be read at all.
pub fn read(path: &Path, kind: &[u8; 8]) -> Result<Found> {
    Ok(of(fs::read(path)?, kind))
}

/// The same of a file's bytes.
pub fn of(mut bytes: Vec<u8>, kind: &[u8; 8]) -> Found {
    if bytes.get(..8) != Some(kind) {
        return Found::Other;
    }
    match bytes.split_at_checked(HEAD) {
        Some((head, contents)) if head[8..] == Sha256::digest(contents)[..] => {}
        _ => return Found::Damaged,
    }
    bytes.drain(..HEAD);
    Found::Whole(bytes)
}

/// Writes it aside and then puts it in place, durably: who reads finds the old one or the new one. The folder is made
/// if missing, for its user alone.
///
/// # Errors
/// What the disk says; an old file then still stands.
pub fn write(path: &Path, kind: &[u8; 8], contents: &[u8]) -> Result<()> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::DirBuilderExt as _;
        builder.mode(0o700);
    }
    builder.create(folder)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let aside = folder.join(format!(".{name}.{}", std::process::id()));
    let put = || {
        let mut file = File::create(&aside)?;
        file.write_all(kind)?;
        file.write_all(&Sha256::digest(contents))?;
        file.write_all(contents)?;
        file.sync_all()?;
        fs::rename(&aside, path)
    };
    put().inspect_err(|_| {
        // What stands half-written is no use.
        let _ = fs::remove_file(&aside);
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_written_is_read_and_nothing_else() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("new").join("file");
        assert!(read(&path, b"orb-test").is_err());
        write(&path, b"orb-test", b"old").unwrap();
        write(&path, b"orb-test", b"contents").unwrap();
        assert_eq!(read(&path, b"orb-test").unwrap(), Found::Whole(b"contents".to_vec()));
        assert_eq!(read(&path, b"orb-none").unwrap(), Found::Other);
        assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1, "nothing left aside");
        let whole = fs::read(&path).unwrap();
        for i in 0..whole.len() {
            let mut changed = whole.clone();
            changed[i] ^= 1;
            assert_eq!(of(changed, b"orb-test"), if i < 8 { Found::Other } else { Found::Damaged });
            assert_eq!(of(whole[..i].to_vec(), b"orb-test"), if i < 8 { Found::Other } else { Found::Damaged });
        }
        assert!(write(&dir.path().join("new"), b"orb-test", b"a folder stands there").is_err());
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
    }
}
