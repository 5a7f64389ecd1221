//! Made sets of photos whose truth is known, and `orb` run on them from the outside.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

/// A folder with made sets of photos in `sets`, and what is made of them.
pub struct Bench {
    folder: tempfile::TempDir,
}

impl Bench {
    /// So many sets of photos, so many pixels across, with GPS and, if nothing is said, COLMAP's poses.
    pub fn new(scenes: &str, photos: &str, size: &str, more: &[&str]) -> Bench {
        let b = Bench { folder: tempfile::tempdir().unwrap() };
        let sets = b.text("sets");
        let args = ["bench", "make", "-o", &sets, "--scenes", scenes, "--photos", photos, "--size", size, "--quiet"];
        b.good(&[&args[..], more].concat());
        b
    }
    pub fn at(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }
    pub fn text(&self, name: &str) -> String {
        self.at(name).to_string_lossy().into_owned()
    }
    pub fn orb(&self, args: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_orb"))
            .args(args)
            .env("ORB_DATA_DIR", self.at("data"))
            .current_dir(self.folder.path())
            .output()
            .unwrap()
    }
    pub fn good(&self, args: &[&str]) -> String {
        let o = self.orb(args);
        let said = String::from_utf8_lossy(&o.stdout).into_owned();
        assert!(o.status.success(), "{args:?}: {said}{}", String::from_utf8_lossy(&o.stderr));
        said
    }
    pub fn refused(&self, args: &[&str]) -> String {
        let o = self.orb(args);
        assert_eq!(o.status.code(), Some(2), "{args:?}: {}", String::from_utf8_lossy(&o.stderr));
        String::from_utf8_lossy(&o.stderr).into_owned()
    }
}

pub fn json(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}
