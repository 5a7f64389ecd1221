//! Accounts and jobs in SQLite: in WAL mode with full synchronisation, what was answered for survives a loss of power.

mod accounts;
mod jobs;
mod places;

pub use accounts::Checked;
pub use jobs::{Ended, Job, New, Selection, State};
pub use places::{Placed, Stands};

use std::path::Path;
use std::sync::{Mutex, MutexGuard};
use std::time::Duration;

use rusqlite::Connection;

use super::lock;
use crate::{Error, Result};

/// The tables' version, in SQLite's own field for it.
const VERSION: i64 = 2;
const TABLES: &str = "
CREATE TABLE account (
    name TEXT PRIMARY KEY, roles TEXT NOT NULL, ceiling TEXT NOT NULL, token_sha256 BLOB NOT NULL,
    token_expires INTEGER NOT NULL, made INTEGER NOT NULL, disabled INTEGER NOT NULL DEFAULT 0,
    failures INTEGER NOT NULL DEFAULT 0, locked_until INTEGER NOT NULL DEFAULT 0, last_used INTEGER
) STRICT;
CREATE TABLE job (
    number INTEGER PRIMARY KEY AUTOINCREMENT, id TEXT NOT NULL UNIQUE, account TEXT NOT NULL, state TEXT NOT NULL,
    marking TEXT NOT NULL, request TEXT NOT NULL, submitted INTEGER NOT NULL, started INTEGER, ended INTEGER,
    attempt INTEGER NOT NULL DEFAULT 0, cancel INTEGER NOT NULL DEFAULT 0, bytes INTEGER NOT NULL, stage TEXT,
    exit_code INTEGER, error TEXT, result TEXT
) STRICT;
CREATE INDEX job_state ON job (state, number);
CREATE INDEX job_marking ON job (marking, number);
";

/// One connection, used by one thread at a time.
pub struct Database(Mutex<Connection>);

pub(super) fn failed(error: rusqlite::Error) -> Error {
    Error::environment("the database of jobs and accounts").found(error.to_string())
}

impl Database {
    /// Opens or makes it.
    ///
    /// # Errors
    /// Environment; one that a later version of Orb wrote is left alone.
    pub fn open(path: &Path) -> Result<Database> {
        make_private(path)?;
        let connection = Connection::open(path).map_err(failed)?;
        let set = |connection: &Connection| {
            connection.busy_timeout(Duration::from_secs(10))?;
            connection.pragma_update(None, "journal_mode", "WAL")?;
            connection.pragma_update(None, "synchronous", "FULL")?;
            // Texts in the file cannot run code of the schema's.
            connection.pragma_update(None, "trusted_schema", false)?;
            connection.pragma_query_value(None, "user_version", |row| row.get::<_, i64>(0))
        };
        let make = |tables: &[&str]| {
            let whole = format!("BEGIN IMMEDIATE; {} PRAGMA user_version = {VERSION}; COMMIT;", tables.concat());
            connection.execute_batch(&whole).map_err(failed)
        };
        match set(&connection).map_err(failed)? {
            VERSION => {}
            1 => make(&[places::TABLES])?,
            0 => make(&[TABLES, places::TABLES])?,
            other => {
                return Err(Error::environment(path.display().to_string())
                    .expected(format!("tables of version {VERSION}"))
                    .found(format!("version {other}"))
                    .advice("A later Orb wrote them: use that one."));
            }
        }
        Ok(Database(Mutex::new(connection)))
    }

    fn connection(&self) -> MutexGuard<'_, Connection> {
        lock(&self.0)
    }
}

/// SQLite gives its other files the database's own permissions.
fn make_private(path: &Path) -> Result<()> {
    let mut options = std::fs::OpenOptions::new();
    options.create(true).append(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt as _;
        options.mode(0o600);
    }
    options.open(path).map(drop).map_err(|e| Error::io(path, &e))
}
