//! Folders and programs for tests with outside readers.

#![allow(dead_code)] // no test program uses all of it

use std::path::{Path, PathBuf};
use std::process::Command;

/// A fresh folder for one test, removed at its end.
pub struct Folder(pub PathBuf);

impl Folder {
    pub fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("orb-formats-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Standard output and error of a program run in a folder, `None` where it is not installed.
pub fn run(program: &str, arguments: &[&str], folder: &Path) -> Option<String> {
    let output = Command::new(program).args(arguments).current_dir(folder).env("OSG_NOTIFY_LEVEL", "INFO").output();
    match output {
        Ok(output) => {
            let text = [output.stdout, output.stderr].concat();
            let text = String::from_utf8_lossy(&text).into_owned();
            assert!(output.status.success(), "{program} {arguments:?}: {text}");
            Some(text)
        }
        Err(error) => {
            let required = std::env::var_os("ORB_REQUIRE_CLIENTS").is_some_and(|v| v == "1");
            assert!(!required, "{program} is required: {error}");
            println!("skipped: {program} is not installed ({error})");
            None
        }
    }
}

/// Skips with a printed reason; fails under ORB_REQUIRE_CLIENTS=1.
pub fn missing(what: &str) {
    let required = std::env::var_os("ORB_REQUIRE_CLIENTS").is_some_and(|v| v == "1");
    assert!(!required, "{what} is required");
    println!("skipped: {what} is missing");
}

/// The folder of a package below one of NODE_PATH's.
pub fn node_package(name: &str) -> Option<PathBuf> {
    let folders = std::env::var_os("NODE_PATH").unwrap_or_default();
    let found = std::env::split_paths(&folders).map(|f| f.join(name)).find(|p| p.join("package.json").is_file());
    if found.is_none() {
        missing(&format!("the npm package {name} on NODE_PATH"));
    }
    found
}

/// A script of `tests/clients`.
pub fn script(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/clients").join(name).to_str().unwrap().to_owned()
}
