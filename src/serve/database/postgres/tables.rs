//! Orb's tables in PostgreSQL, in a schema of their own, made once however many servers begin at the same time.

use postgres::error::SqlState;
use postgres::{Client, GenericClient};

use super::super::VERSION;
use super::{Broken, ORB};

/// Of the first release that knew PostgreSQL.
const FIRST: i64 = 3;

/// The tables, version after version, as SQLite's. Texts are compared byte by byte, as there.
pub(in crate::serve::database) const TABLES: [&str; (VERSION - FIRST + 1) as usize] = [
    "
CREATE TABLE account (
    name TEXT COLLATE \"C\" PRIMARY KEY, roles TEXT NOT NULL, ceiling TEXT NOT NULL, token_sha256 BYTEA NOT NULL,
    token_expires BIGINT NOT NULL, made BIGINT NOT NULL, disabled BIGINT NOT NULL DEFAULT 0,
    failures BIGINT NOT NULL DEFAULT 0, locked_until BIGINT NOT NULL DEFAULT 0, last_used BIGINT
);
CREATE TABLE job (
    number BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY, id TEXT COLLATE \"C\" NOT NULL UNIQUE, account TEXT NOT NULL,
    state TEXT NOT NULL, marking TEXT COLLATE \"C\" NOT NULL, request TEXT NOT NULL, submitted BIGINT NOT NULL,
    started BIGINT, ended BIGINT, attempt BIGINT NOT NULL DEFAULT 0, cancel BIGINT NOT NULL DEFAULT 0,
    bytes BIGINT NOT NULL, stage TEXT, exit_code BIGINT, error TEXT, result TEXT,
    latitude DOUBLE PRECISION, longitude DOUBLE PRECISION, heading DOUBLE PRECISION, folder TEXT NOT NULL
);
CREATE INDEX job_state ON job (state, number);
CREATE INDEX job_marking ON job (marking, number);
CREATE INDEX job_place ON job (number, marking) WHERE latitude IS NOT NULL;
",
    "
CREATE TABLE certificate (
    sha256 BYTEA NOT NULL PRIMARY KEY, account TEXT COLLATE \"C\" NOT NULL, made BIGINT NOT NULL
);
",
];

/// What stops it, beside what a connection can.
pub enum Unfit {
    Broken(Broken),
    /// Tables of a version that this Orb does not know.
    Version(i64),
    /// An encoding that not every text fits in.
    Encoding(String),
}

impl From<postgres::Error> for Unfit {
    fn from(error: postgres::Error) -> Unfit {
        Unfit::Broken(Broken(error))
    }
}

/// The version of the tables that are there: 0 where there are none.
fn found(client: &mut impl GenericClient) -> Result<i64, postgres::Error> {
    match client.query("SELECT number FROM orb.version", &[]) {
        Ok(rows) => Ok(rows.first().map_or(0, |row| row.get(0))),
        Err(e) if [Some(&SqlState::UNDEFINED_TABLE), Some(&SqlState::INVALID_SCHEMA_NAME)].contains(&e.code()) => Ok(0),
        Err(e) => Err(e),
    }
}

/// Makes the tables, or what a version lacks; finds them made, mostly.
pub fn make(client: &mut Client) -> Result<(), Unfit> {
    if found(client)? == VERSION {
        return Ok(());
    }
    let encoding: String = client.query_one("SHOW server_encoding", &[])?.get(0);
    if encoding != "UTF8" {
        return Err(Unfit::Encoding(encoding));
    }
    let has_schema: bool = client.query_one("SELECT to_regnamespace('orb') IS NOT NULL", &[])?.get(0);
    // Whoever comes second waits for this, and finds the work done.
    let mut all = client.transaction()?;
    all.execute("SELECT pg_advisory_xact_lock($1, 0)", &[&ORB])?;
    // A schema that an administrator made is taken as it is: making one needs more rights.
    if !has_schema {
        all.batch_execute("CREATE SCHEMA IF NOT EXISTS orb")?;
    }
    all.batch_execute("CREATE TABLE IF NOT EXISTS version (number BIGINT NOT NULL)")?;
    let from = found(&mut all)?;
    let missing = match from {
        0 => Some(&TABLES[..]),
        known => usize::try_from(known - FIRST + 1).ok().and_then(|n| TABLES.get(n..)),
    };
    let Some(missing) = missing else { return Err(Unfit::Version(from)) };
    if !missing.is_empty() {
        all.batch_execute(&missing.concat())?;
        all.batch_execute(&format!("DELETE FROM version; INSERT INTO version VALUES ({VERSION})"))?;
    }
    Ok(all.commit()?)
}
