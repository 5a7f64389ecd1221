//! Hands the page's address to the user's browser.
//!
//! Not as an argument, which every user of the machine can read: as a file of this user's own that leads there.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use crate::audit::DataFolder;
use crate::{Error, Result};

/// The file, gone when this is dropped.
pub struct Opened {
    file: PathBuf,
    /// The program that was asked to open it.
    opener: Option<Child>,
}

impl Drop for Opened {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.file);
        if let Some(opener) = &mut self.opener {
            let _ = opener.try_wait();
        }
    }
}

/// Opens `address` in the browser that this user has chosen.
///
/// # Errors
/// Environment, when the file cannot be written or nothing opens it.
pub fn in_browser(address: &str, data: &DataFolder) -> Result<Opened> {
    let path = data.subfolder("view")?.join(format!("{}.html", std::process::id()));
    // Of a process that had this number before.
    let _ = std::fs::remove_file(&path);
    write(&path, address).map_err(|e| Error::io(&path, &e))?;
    let mut opened = Opened { file: path, opener: None };
    let program = if cfg!(target_os = "macos") {
        "open"
    } else if cfg!(windows) {
        "explorer"
    } else {
        "xdg-open"
    };
    let child = Command::new(program)
        .arg(&opened.file)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .map_err(|e| Error::environment(program).found(e.to_string()))?;
    opened.opener = Some(child);
    Ok(opened)
}

fn write(path: &Path, address: &str) -> std::io::Result<()> {
    let mut options = std::fs::OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt as _;
        options.mode(0o600);
    }
    let mut file = options.open(path)?;
    writeln!(
        file,
        "<!doctype html><meta charset=utf-8><meta name=referrer content=no-referrer>\
         <meta http-equiv=refresh content=\"0;url={address}\"><title>Orb</title><a href=\"{address}\">Orb's viewer</a>"
    )
}
