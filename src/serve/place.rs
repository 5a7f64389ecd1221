//! Where a server keeps what: one folder, names in it made by the server alone.
//!
//! ```text
//! DIR/serve/serve.sqlite       accounts and jobs
//! DIR/serve/serve.lock         one server at a time
//! DIR/serve/name               what the folder is called in a database that is elsewhere
//! DIR/serve/database           which database knows the folder's jobs
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

/// What is said of the database that lies in the folder, and of any that does not.
pub const SQLITE: &str = "SQLite";
pub const POSTGRES: &str = "PostgreSQL";

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
            self.write_once(&path, &hex::encode(random::<16>()?))?;
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

    /// Refuses every database but the one that knows this folder's jobs: to another they are all unknown. `home`: which it
    /// is, without who asks it.
    ///
    /// # Errors
    /// Usage for another database than before; environment.
    pub fn check_database(&self, home: &str) -> Result<()> {
        let Some(before) = self.home()? else { return Ok(()) };
        // Of a folder that is older than its note no more may be known.
        if before == home || (before == POSTGRES && home.starts_with(POSTGRES)) {
            return Ok(());
        }
        let note = self.note();
        Err(Error::usage("--database")
            .expected(format!("the database of this folder's jobs, {before}"))
            .found(home)
            .advice(format!(
                "Name that one by --database or ORB_DATABASE (for SQLite: neither), or give another folder with --data. \
                 Where it is the same one, moved or called otherwise, write {home} into {}.",
                note.display()
            )))
    }

    /// Notes which database knows this folder's jobs, unless that is noted.
    ///
    /// # Errors
    /// Environment.
    pub fn keep_database(&self, home: &str) -> Result<()> {
        let note = self.note();
        if note.exists() { Ok(()) } else { self.write_once(&note, home) }
    }

    fn note(&self) -> PathBuf {
        self.root.join("database")
    }

    /// As it is noted; of a folder with jobs that is older than such notes, by what else lies in it.
    fn home(&self) -> Result<Option<String>> {
        let note = self.note();
        match fs::read_to_string(&note) {
            Ok(text) => return Ok(Some(text.trim().to_owned())),
            Err(e) if e.kind() != std::io::ErrorKind::NotFound => return Err(Error::io(&note, &e)),
            Err(_) => {}
        }
        let jobs = self.root.join("jobs");
        let mut inside = fs::read_dir(&jobs).map_err(|e| Error::io(&jobs, &e))?.flatten();
        if !inside.any(|e| is_id(&e.file_name().to_string_lossy())) {
            return Ok(None);
        }
        Ok(match (self.database().exists(), self.root.join("name").exists()) {
            (true, false) => Some(SQLITE.to_owned()),
            (false, true) => Some(POSTGRES.to_owned()),
            _ => None,
        })
    }

    /// A small file of the folder's own, whole or not at all.
    fn write_once(&self, path: &Path, text: &str) -> Result<()> {
        let (draft, disk) = (path.with_extension("new"), disk::Disk::default());
        if draft.exists() {
            disk.remove_file(&draft)?;
        }
        disk.write_new(&draft, text.as_bytes())?;
        disk.rename(&draft, path)?;
        disk.sync_dir(&self.root)
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
        let (job, leaving) = (self.job(id), self.incoming(id));
        remove(&leaving)?;
        if job.exists() {
            // Where nothing is kept: what is broken off halfway is gone at the next start.
            disk::Disk::default().rename(&job, &leaving)?;
        }
        remove(&leaving)
    }

    /// Removes what no job is known of: submissions that were broken off, deletions that were. What holds something published
    /// stays: a database that does not know it may be the wrong one, or an older one put back.
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
                if !is_id(&name) || (keeps && is_known(&name)) {
                    continue;
                }
                if keeps && has_published(&entry.path()) {
                    eprintln!(
                        "orb: warning: {}: no job of the database has this folder, and results are in it: it is kept",
                        entry.path().display()
                    );
                    continue;
                }
                remove(&entry.path())?;
            }
        }
        Ok(())
    }
}

/// Of a job's N-th run, below the job's folder.
pub fn run_name(attempt: u32) -> String {
    format!("run-{attempt}")
}

/// Whether a run of a job published; what cannot be read may have.
fn has_published(job: &Path) -> bool {
    let of_run = |name: &str| name.strip_prefix("run-").is_some_and(|n| n.parse::<u32>().is_ok());
    match fs::read_dir(job) {
        Ok(mut all) => all.any(|e| {
            e.map_or(true, |e| {
                of_run(&e.file_name().to_string_lossy()) && e.path().join("out").symlink_metadata().is_ok()
            })
        }),
        Err(_) => true,
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_has_one_database() {
        let folder = tempfile::tempdir().unwrap();
        let open = |name: &str| Place::open(&DataFolder::at(folder.path().join(name))).unwrap();
        let [here, there] = [SQLITE, "PostgreSQL \"orb\" at db.example port 5432"];
        let place = open("new");
        for home in [here, there] {
            place.check_database(home).unwrap();
        }
        place.keep_database(there).unwrap();
        place.check_database(there).unwrap();
        let refused = place.check_database(here).unwrap_err();
        assert_eq!(refused.kind, crate::Kind::Usage);
        let words = refused.to_string();
        assert!(words.contains("db.example") && words.contains("ORB_DATABASE"), "{words}");
        assert!(words.contains(&place.note().display().to_string()), "{words}");
        place.keep_database(here).unwrap();
        assert!(place.check_database(here).is_err(), "what is noted stays");
        // Folders that are older than the note: by their jobs and what lies beside them.
        for (name, file, own, other) in [("a", "serve.sqlite", here, there), ("b", "name", there, here)] {
            let place = open(name);
            fs::write(place.root.join(file), "").unwrap();
            place.check_database(other).unwrap();
            fs::create_dir(place.job(&"a".repeat(32))).unwrap();
            place.check_database(own).unwrap();
            assert!(place.check_database(other).is_err(), "{name}");
        }
    }

    #[test]
    fn a_removed_job_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let place = Place::open(&DataFolder::at(folder.path().join("data"))).unwrap();
        let id = "a".repeat(32);
        fs::create_dir_all(place.published(&id, 1)).unwrap();
        // An earlier removal was broken off.
        fs::create_dir_all(place.incoming(&id).join("in")).unwrap();
        place.remove_job(&id).unwrap();
        assert!(!place.job(&id).exists() && !place.incoming(&id).exists());
        place.remove_job(&id).unwrap();
    }
}
