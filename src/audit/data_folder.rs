//! The user's own folder: keys, trusted public keys, the ledger.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{Error, Result};

/// Made when first needed, readable by its user only.
#[derive(Clone, Debug)]
pub struct DataFolder {
    path: PathBuf,
}

impl DataFolder {
    pub fn at(path: impl Into<PathBuf>) -> DataFolder {
        DataFolder { path: path.into() }
    }

    /// `$ORB_DATA_DIR`, else the platform's place: `$XDG_DATA_HOME/orb` or `~/.local/share/orb`; on macOS
    /// `~/Library/Application Support/orb`; on Windows `%LOCALAPPDATA%\orb`. `var` looks up the environment.
    ///
    /// # Errors
    /// [`crate::Kind::Environment`] when nothing says where the user lives.
    pub fn from_environment(var: impl Fn(&str) -> Option<OsString>) -> Result<DataFolder> {
        let path = |name: &str| var(name).filter(|v| !v.is_empty()).map(PathBuf::from);
        // The XDG base directory specification: a relative path is invalid and ignored.
        let absolute = |name: &str| path(name).filter(|p| p.is_absolute());
        let found = match path("ORB_DATA_DIR") {
            Some(path) => Some(std::path::absolute(&path).map_err(|e| Error::io(&path, &e))?),
            None if cfg!(windows) => absolute("LOCALAPPDATA").map(|p| p.join("orb")),
            None if cfg!(target_os = "macos") => absolute("HOME").map(|p| p.join("Library/Application Support/orb")),
            None => absolute("XDG_DATA_HOME")
                .or_else(|| absolute("HOME").map(|p| p.join(".local/share")))
                .map(|p| p.join("orb")),
        };
        found.map(DataFolder::at).ok_or_else(|| {
            Error::environment("the user's data folder")
                .expected("a home folder in the environment")
                .found("none")
                .advice("Set ORB_DATA_DIR to a folder of yours: Orb keeps its signing key and its ledger there.")
        })
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// A folder below it, made if missing.
    ///
    /// # Errors
    /// [`crate::Kind::Environment`] when it cannot be made.
    pub(crate) fn subfolder(&self, name: &str) -> Result<PathBuf> {
        let path = self.path.join(name);
        let mut builder = fs::DirBuilder::new();
        builder.recursive(true);
        #[cfg(unix)]
        {
            use std::os::unix::fs::DirBuilderExt as _;
            builder.mode(0o700);
        }
        builder.create(&path).map_err(|e| {
            Error::io(&path, &e)
                .expected("a folder for the signing key and the ledger")
                .advice("Set ORB_DATA_DIR to a folder where this user may write. Nothing was published.")
        })?;
        Ok(path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(vars: &[(&str, &str)]) -> Option<PathBuf> {
        let look_up = |name: &str| vars.iter().find(|(n, _)| *n == name).map(|(_, v)| OsString::from(v));
        DataFolder::from_environment(look_up).ok().map(|d| d.path)
    }

    #[cfg(all(unix, not(target_os = "macos")))]
    #[test]
    fn where_it_is() {
        assert_eq!(at(&[("ORB_DATA_DIR", "/o"), ("XDG_DATA_HOME", "/x"), ("HOME", "/h")]), Some("/o".into()));
        assert_eq!(at(&[("XDG_DATA_HOME", "/x"), ("HOME", "/h")]), Some("/x/orb".into()));
        assert_eq!(at(&[("XDG_DATA_HOME", "x"), ("HOME", "/h")]), Some("/h/.local/share/orb".into()));
        assert_eq!(at(&[("ORB_DATA_DIR", ""), ("HOME", "/h")]), Some("/h/.local/share/orb".into()));
        assert_eq!(at(&[]), None);
    }

    #[cfg(unix)]
    #[test]
    fn only_its_user_can_enter() {
        use std::os::unix::fs::PermissionsExt as _;
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path().join("a/b"));
        let keys = data.subfolder("keys").unwrap();
        for path in [data.path(), &keys] {
            assert_eq!(fs::metadata(path).unwrap().permissions().mode() & 0o777, 0o700);
        }
        assert!(at(&[("ORB_DATA_DIR", "/o")]).is_some());
    }
}
