//! Where a server keeps what: one folder, names in it made by the server alone.
//!
//! ```text
//! DIR/serve/serve.sqlite       accounts and jobs
//! DIR/serve/serve.lock         one server at a time
//! DIR/serve/name               what the folder is called in a database that is elsewhere
//! DIR/serve/incoming/ID/       a submission that is being taken in
//! DIR/serve/jobs/ID/in/        its photo; several in in/set/NAME/, with in/poses/ and in/gcp.csv
//! DIR/serve/jobs/ID/run-N/out/ what its N-th run published: there whole or not at all
//! ```

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use super::random;
use crate::audit::DataFolder;
use crate::audit::disk;
use crate::audit::file_lock::FileLock;
use crate::{Error, Result};

#[derive(Clone, Debug)]
pub struct Place {
    root: PathBuf,
}

/// 128 random bits, as hexadecimal digits: the only names of jobs.
pub fn is_id(text: &str) -> bool {
    text.len() == 32 && text.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b))
}

impl Place {
    /// Makes the folders that are missing.
    ///
    /// # Errors
    /// Environment.
    pub fn open(data: &DataFolder) -> Result<Place> {
        let root = data.subfolder("serve")?;
        for name in ["jobs", "incoming"] {
            make(&root.join(name))?;
        }
        Ok(Place { root })
    }

    /// Held as long as the value lives: two servers in one folder would run each other's jobs.
    ///
    /// # Errors
    /// Environment, where another one runs.
    pub fn lock(&self) -> Result<FileLock> {
        let path = self.root.join("serve.lock");
        let file = File::options().create(true).append(true).open(&path).map_err(|e| Error::io(&path, &e))?;
        FileLock::try_take(file).map_err(|e| {
            Error::environment(path.display().to_string())
                .expected("no other server in this folder")
                .found(e.to_string())
                .advice("End the other one, or give this one a folder of its own with --data.")
        })
    }

    /// The folder's own name, by which a database that is elsewhere knows whose jobs are whose: given once, kept when the
    /// folder is moved.
    ///
    /// # Errors
    /// Environment; usage where something else stands in the file.
    pub fn name(&self) -> Result<String> {
        let path = self.root.join("name");
        if !path.exists() {
            let draft = path.with_extension("new");
            let disk = disk::Disk::default();
            if draft.exists() {
                disk.remove_file(&draft)?;
            }
            disk.write_new(&draft, hex::encode(random::<16>()?).as_bytes())?;
            disk.rename(&draft, &path)?;
            disk.sync_dir(&self.root)?;
        }
        let text = fs::read_to_string(&path).map_err(|e| Error::io(&path, &e))?;
        let name = text.trim();
        match is_id(name) {
            true => Ok(name.to_owned()),
            false => Err(Error::usage(path.display().to_string())
                .expected("32 hexadecimal digits")
                .found(format!("{:?}", name.chars().take(40).collect::<String>()))
                .advice("Put back what stood there: a new name would be another folder's, without these jobs.")),
        }
    }

    pub fn database(&self) -> PathBuf {
        self.root.join("serve.sqlite")
    }

    pub fn incoming(&self, id: &str) -> PathBuf {
        self.root.join("incoming").join(id)
    }

    pub fn job(&self, id: &str) -> PathBuf {
        self.root.join("jobs").join(id)
    }

    pub fn run(&self, id: &str, attempt: u32) -> PathBuf {
        self.job(id).join(run_name(attempt))
    }

    /// Whole, once it is there.
    pub fn published(&self, id: &str, attempt: u32) -> PathBuf {
        self.run(id, attempt).join("out")
    }

    /// An empty folder for a submission.
    ///
    /// # Errors
    /// Environment.
    pub fn begin_incoming(&self, id: &str) -> Result<PathBuf> {
        let folder = self.incoming(id);
        make(&folder)?;
        Ok(folder)
    }

    /// What was taken in becomes a job's, durably.
    ///
    /// # Errors
    /// Environment.
    pub fn accept(&self, id: &str) -> Result<()> {
        let (from, to) = (self.incoming(id), self.job(id));
        let disk = disk::Disk::default();
        for folder in disk::walk(&from)?.into_iter().filter(|e| e.is_dir) {
            disk.sync_dir(&folder.path)?;
        }
        disk.sync_dir(&from)?;
        disk.rename(&from, &to)?;
        disk.sync_dir(&self.root.join("jobs"))
    }

    /// The empty folder of a run; what an earlier one of this number left is gone.
    ///
    /// # Errors
    /// Environment.
    pub fn begin_run(&self, id: &str, attempt: u32) -> Result<PathBuf> {
        let folder = self.run(id, attempt);
        remove(&folder)?;
        make(&folder)?;
        Ok(folder)
    }

    /// # Errors
    /// Environment.
    pub fn remove_run(&self, id: &str, attempt: u32) -> Result<()> {
        remove(&self.run(id, attempt))
    }

    /// # Errors
    /// Environment.
    pub fn remove_incoming(&self, id: &str) -> Result<()> {
        remove(&self.incoming(id))
    }

    /// # Errors
    /// Environment.
    pub fn remove_job(&self, id: &str) -> Result<()> {
        remove(&self.incoming(id))?;
        remove(&self.job(id))
    }

    /// Removes what no job is known of: submissions that were broken off, deletions that were.
    ///
    /// # Errors
    /// Environment.
    pub fn sweep(&self, is_known: impl Fn(&str) -> bool) -> Result<()> {
        for (folder, keeps) in [("incoming", false), ("jobs", true)] {
            let folder = self.root.join(folder);
            for entry in fs::read_dir(&folder).map_err(|e| Error::io(&folder, &e))? {
                let entry = entry.map_err(|e| Error::io(&folder, &e))?;
                let name = entry.file_name().to_string_lossy().into_owned();
                // Nothing but what a server made.
                if is_id(&name) && !(keeps && is_known(&name)) {
                    remove(&entry.path())?;
                }
            }
        }
        Ok(())
    }
}

/// Of a job's N-th run, below the job's folder.
pub fn run_name(attempt: u32) -> String {
    format!("run-{attempt}")
}

/// Bytes of the files below a folder; what cannot be read counts nothing.
pub fn size(folder: &Path) -> u64 {
    let entries = disk::walk(folder).unwrap_or_default();
    entries.iter().filter(|e| e.is_file).filter_map(|e| fs::metadata(&e.path).ok()).map(|m| m.len()).sum()
}

fn make(folder: &Path) -> Result<()> {
    disk::Disk::default().create_dir_all(folder)
}

fn remove(folder: &Path) -> Result<()> {
    disk::Disk::default().remove_dir_all(folder)
}
