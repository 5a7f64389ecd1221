//! Accounts and jobs: in SQLite, in a file of the server's own folder, or in PostgreSQL.
//!
//! [`Sql`] is all that the two differ in. What is said to them stands once, in [`accounts`], [`certificates`],
//! [`jobs`] and [`places`].

mod accounts;
mod certificates;
mod jobs;
mod places;
pub mod postgres;
mod sql;
mod sqlite;
#[cfg(test)]
mod tests;

pub use accounts::Checked;
pub use jobs::{Ended, Job, New, Selection, State};
pub use places::{Placed, Stands};
pub use sql::SUBJECT;

use std::path::Path;

use crate::Result;
use sql::{Row, Sql, Value, Way};

/// The tables' version.
const VERSION: i64 = 4;

/// Jobs and accounts.
pub struct Database {
    sql: Box<dyn Sql>,
    /// The folder whose jobs are this server's to run, by [`crate::serve::place::Place::name`]: in a file there is no other.
    folder: String,
}

impl Database {
    /// A file of SQLite's: opened or made.
    ///
    /// # Errors
    /// Environment; one that a later version of Orb wrote is left alone.
    pub fn file(path: &Path) -> Result<Database> {
        Ok(Database { sql: Box::new(sqlite::Sqlite::open(path)?), folder: String::new() })
    }

    /// A database of a PostgreSQL server's: Orb's tables are made where there are none.
    ///
    /// # Errors
    /// As [`postgres::Postgres::open`].
    pub fn at(address: postgres::Address, folder: String) -> Result<Database> {
        Ok(Database { sql: Box::new(postgres::Postgres::open(address, &folder)?), folder })
    }

    /// From now on this is the only server that takes this folder's jobs.
    ///
    /// # Errors
    /// Environment, where another one is.
    pub fn hold(&self) -> Result<()> {
        self.sql.hold()
    }

    /// Whether it can be asked now.
    pub fn answers(&self) -> bool {
        self.sql.rows(Way::Read, "SELECT number FROM job LIMIT 1", &[]).is_ok()
    }

    fn rows(&self, sql: &str, values: &[Value]) -> Result<Vec<Row>> {
        self.sql.rows(Way::Read, sql, values)
    }

    /// How many rows it changed.
    pub(in crate::serve) fn change(&self, sql: &str, values: &[Value]) -> Result<u64> {
        self.sql.change(Way::Change, sql, values)
    }
}
