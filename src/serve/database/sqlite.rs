//! SQLite, in a file of the server's folder: in WAL mode with full synchronisation, what was answered for survives a loss of
//! power.

use std::path::Path;
use std::sync::Mutex;
use std::time::Duration;

use rusqlite::types::ValueRef;
use rusqlite::{Connection, Statement, ToSql};

use super::VERSION;
use super::sql::{Row, SUBJECT, Sql, Value, Way};
use crate::serve::lock;
use crate::{Error, Result};

/// The tables, version after version: each makes what the one before had into its own.
pub(super) const TABLES: [&str; VERSION as usize] = [
    "
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
",
    // Where models stand; of jobs that are done already, from what their runs said.
    "
ALTER TABLE job ADD COLUMN latitude REAL;
ALTER TABLE job ADD COLUMN longitude REAL;
ALTER TABLE job ADD COLUMN heading REAL;
CREATE INDEX job_place ON job (number, marking) WHERE latitude IS NOT NULL;
UPDATE job SET latitude = json_extract(result, '$.georeference.latitude'),
    longitude = json_extract(result, '$.georeference.longitude'), heading = json_extract(result, '$.georeference.heading_deg')
WHERE state = 'done' AND json_type(result, '$.georeference.latitude') IS NOT NULL;
",
    // Whose folder a job's files are in: here always the one that this file stands in.
    "
ALTER TABLE job ADD COLUMN folder TEXT NOT NULL DEFAULT '';
",
    // Whose certificate is whose.
    "
CREATE TABLE certificate (sha256 BLOB NOT NULL PRIMARY KEY, account TEXT NOT NULL, made INTEGER NOT NULL) STRICT;
",
];

/// One connection, used by one thread at a time.
pub struct Sqlite(Mutex<Connection>);

fn failed(error: rusqlite::Error) -> Error {
    Error::environment(SUBJECT).found(error.to_string())
}

impl Sqlite {
    /// Opens or makes it, and brings an older one up to this version.
    ///
    /// # Errors
    /// Environment; one that a later version of Orb wrote is left alone.
    pub fn open(path: &Path) -> Result<Sqlite> {
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
        let found = set(&connection).map_err(failed)?;
        let missing = usize::try_from(found).ok().and_then(|n| TABLES.get(n..)).ok_or_else(|| {
            Error::environment(path.display().to_string())
                .expected(format!("tables of version {VERSION}"))
                .found(format!("version {found}"))
                .advice("A later Orb wrote them: use that one.")
        })?;
        if !missing.is_empty() {
            let whole = format!("BEGIN IMMEDIATE; {} PRAGMA user_version = {VERSION}; COMMIT;", missing.concat());
            connection.execute_batch(&whole).map_err(failed)?;
        }
        Ok(Sqlite(Mutex::new(connection)))
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

/// To SQLite `$1` is a name.
fn bind(statement: &mut Statement<'_>, values: &[Value]) -> rusqlite::Result<()> {
    for (i, value) in values.iter().enumerate() {
        let Some(index) = statement.parameter_index(&format!("${}", i + 1))? else { continue };
        let value: &dyn ToSql = match value {
            Value::Int(v) => v,
            Value::Real(v) => v,
            Value::Text(v) => v,
            Value::Blob(v) => v,
            Value::NoInt | Value::NoText => &rusqlite::types::Null,
        };
        statement.raw_bind_parameter(index, value)?;
    }
    Ok(())
}

fn read(row: &rusqlite::Row<'_>, columns: usize) -> rusqlite::Result<Row> {
    let value = |i| {
        Ok(match row.get_ref(i)? {
            ValueRef::Null => Value::NoText,
            ValueRef::Integer(v) => Value::Int(v),
            ValueRef::Real(v) => Value::Real(v),
            text @ ValueRef::Text(_) => Value::Text(text.as_str()?.to_owned()),
            ValueRef::Blob(v) => Value::Blob(v.to_vec()),
        })
    };
    (0..columns).map(value).collect::<rusqlite::Result<_>>().map(Row)
}

impl Sql for Sqlite {
    fn rows(&self, _: Way, sql: &str, values: &[Value]) -> Result<Vec<Row>> {
        let connection = lock(&self.0);
        let all = || {
            let mut statement = connection.prepare_cached(sql)?;
            bind(&mut statement, values)?;
            let columns = statement.column_count();
            let mut found = statement.raw_query();
            let mut out = Vec::new();
            while let Some(row) = found.next()? {
                out.push(read(row, columns)?);
            }
            Ok(out)
        };
        all().map_err(failed)
    }

    fn change(&self, _: Way, sql: &str, values: &[Value]) -> Result<u64> {
        let connection = lock(&self.0);
        let all = || {
            let mut statement = connection.prepare_cached(sql)?;
            bind(&mut statement, values)?;
            statement.raw_execute()
        };
        all().map(|n| n as u64).map_err(failed)
    }

    /// One statement at a time changes a file.
    fn for_one(&self) -> &'static str {
        ""
    }

    /// The lock of the folder that the file stands in says so already.
    fn hold(&self) -> Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Database, Stands};
    use super::*;

    #[test]
    fn places_of_an_older_database_are_taken_over() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("old.sqlite");
        let old = Connection::open(&path).unwrap();
        old.execute_batch(&format!("{} PRAGMA user_version = 1;", TABLES[0])).unwrap();
        for (id, state, result) in [
            ("a", "done", r#"{"georeference":{"latitude":34,"longitude":-118.5,"heading_deg":90.5}}"#),
            ("b", "done", "null"),
            ("c", "queued", "null"),
        ] {
            let sql = "INSERT INTO job (id, account, state, marking, request, submitted, bytes, result)
                       VALUES (?1, 'jane', ?2, 'CUI', '{\"name\":\"van\"}', 0, 0, ?3)";
            old.execute(sql, [id, state, result]).unwrap();
        }
        drop(old);
        let new = Database::file(&path).unwrap();
        let of = |markings: &[&str], before| {
            let markings: Vec<String> = markings.iter().map(|m| (*m).to_owned()).collect();
            new.placed(&markings, before, 10).unwrap()
        };
        let [placed] = &of(&["CUI"], None)[..] else { panic!("{:?}", of(&["CUI"], None)) };
        assert_eq!((placed.id.as_str(), placed.name.as_deref()), ("a", Some("van")));
        assert_eq!(placed.stands, Stands { latitude: 34.0, longitude: -118.5, heading: 90.5 });
        assert_eq!(of(&["SECRET"], None), []);
        assert_eq!(of(&["CUI"], Some(1)), []);
        assert_eq!(new.take(1).unwrap().unwrap().id, "c", "what waited is still this server's");
        drop(new);
        assert!(Database::file(&path).is_ok(), "and once only");
    }

    #[test]
    fn tables_of_a_later_version_are_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("new.sqlite");
        drop(Database::file(&path).unwrap());
        Connection::open(&path).unwrap().pragma_update(None, "user_version", VERSION + 1).unwrap();
        let words = Database::file(&path).err().unwrap().to_string();
        assert!(words.contains(&format!("found version {}", VERSION + 1)) && words.contains("later Orb"), "{words}");
    }
}
