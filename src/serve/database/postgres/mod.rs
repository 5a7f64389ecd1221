//! PostgreSQL, for accounts and jobs that are kept on a server of the user's.
//!
//! One connection, used by one thread at a time, as SQLite's. A broken one is made anew: what only reads is asked again,
//! what changes something is not said twice. Each server holds a lock on its folder's name for as long as its connection
//! stands, so that a copy of the folder does not run the same jobs.

mod address;
mod tables;
mod tls;

pub use address::{Address, OPTION};
#[cfg(test)]
pub(super) use tables::TABLES;

use std::collections::HashMap;
use std::error::Error as _;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use postgres::error::SqlState;
use postgres::types::{ToSql, Type};
use postgres::{Client, NoTls, Statement};
use sha2::{Digest as _, Sha256};

use super::VERSION;
use super::sql::{Row, SUBJECT, Sql, Value, Way};
use crate::serve::lock;
use crate::{Error, Result};
use tables::Unfit;

/// Orb's advisory locks: `orb` in ASCII, beside a number of what they are for. Folders have 64-bit ones.
const ORB: i32 = 0x006f_7262;
/// For a connection that broke to be made anew, and for another server's lock to go; then whoever waits is told.
const PATIENCE: Duration = Duration::from_secs(5);
const PAUSE: Duration = Duration::from_millis(100);
/// Who comes so soon after a failure gets its words, and does not try again.
const STALE: Duration = Duration::from_millis(500);
/// Statements that are kept prepared: their number grows with that of markings.
const MOST_PREPARED: usize = 200;

/// Nothing waits for ever; what is committed is on the disk; texts are found by their own schema alone.
const SETTINGS: &str = "
SET search_path = orb; SET statement_timeout = '30s'; SET lock_timeout = '10s';
SET idle_in_transaction_session_timeout = '30s'; SET default_transaction_isolation = 'read committed';
SET tcp_keepalives_idle = 10; SET tcp_keepalives_interval = 5; SET tcp_keepalives_count = 3;
SELECT set_config('synchronous_commit', 'on', false) WHERE current_setting('synchronous_commit') = 'off';
";

/// An error of the client's.
pub struct Broken(postgres::Error);

impl Broken {
    /// It is the connection that failed: another may work.
    fn is_connection(&self) -> bool {
        let lost = [SqlState::ADMIN_SHUTDOWN, SqlState::CRASH_SHUTDOWN, SqlState::CANNOT_CONNECT_NOW];
        match self.0.code() {
            Some(code) => lost.contains(code) || code.code().starts_with("08"),
            None => self.0.is_closed() || self.0.source().is_some_and(|e| e.is::<std::io::Error>()),
        }
    }

    /// It is the statement, which another version of the tables does not know as it was prepared; it did nothing.
    fn is_stale(&self) -> bool {
        let stale = [SqlState::FEATURE_NOT_SUPPORTED, SqlState::INVALID_SQL_STATEMENT_NAME];
        self.0.code().is_some_and(|code| stale.contains(code))
    }

    fn words(&self) -> String {
        match self.0.as_db_error() {
            Some(e) => {
                let more = [e.detail(), e.hint()].into_iter().flatten().map(|words| format!("; {words}"));
                format!("{} (SQLSTATE {}){}", e.message(), e.code().code(), more.collect::<String>())
            }
            None => {
                let mut words = self.0.to_string();
                let mut next = self.0.source();
                while let Some(cause) = next {
                    words.push_str(&format!(": {cause}"));
                    next = cause.source();
                }
                words
            }
        }
    }

    fn advice(&self) -> String {
        match self.0.code() {
            Some(&SqlState::INVALID_PASSWORD | &SqlState::INVALID_AUTHORIZATION_SPECIFICATION) => {
                "Check the user in --database, the password that --database-password names, and pg_hba.conf.".into()
            }
            Some(&SqlState::INVALID_CATALOG_NAME) => "`createdb NAME` makes it.".into(),
            Some(&SqlState::INSUFFICIENT_PRIVILEGE) => {
                "Orb needs a schema of its own: CREATE SCHEMA orb AUTHORIZATION its user.".into()
            }
            None if self.words().contains("password missing") => {
                "Say where the password is by --database-password file:PATH or env:NAME, or by ORB_DATABASE_PASSWORD."
                    .into()
            }
            None => "Is the server running there, and does it listen? `psql` with the same address says more.".into(),
            _ => String::new(),
        }
    }
}

struct Session {
    client: Client,
    prepared: HashMap<String, Statement>,
}

#[derive(Default)]
struct State {
    session: Option<Session>,
    /// When it last could not be reached, and why.
    down: Option<(Instant, Error)>,
}

pub struct Postgres {
    address: Address,
    /// Of the folder.
    lock: i64,
    held: AtomicBool,
    state: Mutex<State>,
}

impl Postgres {
    /// Connects, and makes the tables where there are none.
    ///
    /// # Errors
    /// Environment: no such server, user, database or right; tables of a later version, which are left alone.
    pub fn open(address: Address, folder: &str) -> Result<Postgres> {
        let hash: [u8; 32] = Sha256::digest(folder.as_bytes()).into();
        let lock = i64::from_be_bytes(std::array::from_fn(|i| hash[i]));
        let state = Mutex::default();
        let postgres = Postgres { address, lock, held: AtomicBool::new(false), state };
        lock_state(&postgres).session = Some(postgres.connect()?);
        Ok(postgres)
    }

    fn error(&self) -> Error {
        Error::environment(format!("{SUBJECT}, PostgreSQL {}", self.address.words()))
    }

    fn failed(&self, broken: &Broken) -> Error {
        self.error().found(broken.words()).advice(broken.advice())
    }

    fn connect(&self) -> Result<Session> {
        let config = &self.address.config;
        let connected = match &self.address.tls {
            None => config.connect(NoTls),
            Some(tls) => config.connect(tls.clone()),
        };
        let failed = |e| self.failed(&Broken(e));
        let mut client = connected.map_err(failed)?;
        client.batch_execute(SETTINGS).map_err(failed)?;
        tables::make(&mut client).map_err(|unfit| match unfit {
            Unfit::Broken(e) => self.failed(&e),
            Unfit::Version(found) => self
                .error()
                .expected(format!("tables of version {VERSION}"))
                .found(format!("version {found}"))
                .advice("A later Orb wrote them: use that one."),
            Unfit::Encoding(found) => self
                .error()
                .expected("a database of the encoding UTF8")
                .found(found)
                .advice("`createdb --encoding UTF8 --template template0 NAME` makes one."),
        })?;
        if self.held.load(Ordering::Relaxed) {
            self.take_lock(&mut client)?;
        }
        Ok(Session { client, prepared: HashMap::new() })
    }

    fn take_lock(&self, client: &mut Client) -> Result<()> {
        let got = client.query_one("SELECT pg_try_advisory_lock($1)", &[&self.lock]);
        match got.map_err(|e| self.failed(&Broken(e)))?.get(0) {
            true => Ok(()),
            false => Err(self
                .error()
                .expected("no other server with this folder's name")
                .found("one that holds its lock")
                .advice(
                    "End the other one. If it was cut off from the database, its lock goes after half a minute. If this folder \
                     is a copy of its, remove the file serve/name from the copy: the jobs stay with the original.",
                )),
        }
    }

    /// A session that stands. For what cannot be said twice it is asked first.
    fn ready<'a>(&self, state: &'a mut State, way: Way) -> Result<&'a mut Session> {
        let stands =
            |s: &mut Session| !s.client.is_closed() && (way == Way::Read || s.client.is_valid(PATIENCE).is_ok());
        if !state.session.as_mut().is_some_and(stands) {
            state.session = None;
            let patience = match &state.down {
                Some((when, error)) if when.elapsed() < STALE => return Err(error.clone()),
                Some(_) => Duration::ZERO,
                None => PATIENCE,
            };
            let begun = Instant::now();
            loop {
                match self.connect() {
                    Ok(session) => {
                        *state = State { session: Some(session), down: None };
                        break;
                    }
                    Err(_) if begun.elapsed() < patience => std::thread::sleep(PAUSE),
                    Err(e) => {
                        state.down = Some((Instant::now(), e.clone()));
                        return Err(e);
                    }
                }
            }
        }
        state.session.as_mut().ok_or_else(|| self.error().found("no connection"))
    }

    fn with<T>(&self, way: Way, work: impl Fn(&mut Session) -> Result<T, Broken>) -> Result<T> {
        let mut state = lock_state(self);
        match work(self.ready(&mut state, way)?) {
            Ok(done) => Ok(done),
            Err(e) if e.is_stale() || e.is_connection() && way == Way::Read => {
                state.session = None;
                work(self.ready(&mut state, way)?).map_err(|e| self.failed(&e))
            }
            Err(e) if e.is_connection() => {
                state.session = None;
                Err(self.failed(&e).advice("The connection broke: whether this was still written is not known."))
            }
            Err(e) => Err(self.failed(&e)),
        }
    }
}

fn lock_state(postgres: &Postgres) -> std::sync::MutexGuard<'_, State> {
    lock(&postgres.state)
}

impl Session {
    fn prepare(&mut self, sql: &str, values: &[Value]) -> Result<Statement, postgres::Error> {
        if let Some(statement) = self.prepared.get(sql) {
            return Ok(statement.clone());
        }
        let types: Vec<Type> = values.iter().map(type_of).collect();
        let statement = self.client.prepare_typed(sql, &types)?;
        if self.prepared.len() >= MOST_PREPARED {
            self.prepared.clear();
        }
        self.prepared.insert(sql.to_owned(), statement.clone());
        Ok(statement)
    }
}

fn type_of(value: &Value) -> Type {
    match value {
        Value::Int(_) | Value::NoInt => Type::INT8,
        Value::Real(_) => Type::FLOAT8,
        Value::Text(_) | Value::NoText => Type::TEXT,
        Value::Blob(_) => Type::BYTEA,
    }
}

/// A value for the client. PostgreSQL's texts have no NUL in them.
fn sent(value: &Value) -> Box<dyn ToSql + Sync> {
    match value {
        Value::Int(v) => Box::new(*v),
        Value::Real(v) => Box::new(*v),
        Value::Text(v) => Box::new(v.replace('\0', "\u{fffd}")),
        Value::Blob(v) => Box::new(v.clone()),
        Value::NoInt => Box::new(None::<i64>),
        Value::NoText => Box::new(None::<String>),
    }
}

fn read(row: &postgres::Row) -> Result<Row, postgres::Error> {
    let value = |(i, column): (usize, &postgres::Column)| {
        let kind = column.type_();
        Ok(match () {
            () if *kind == Type::INT8 => row.try_get::<_, Option<i64>>(i)?.map_or(Value::NoInt, Value::Int),
            () if *kind == Type::FLOAT8 => row.try_get::<_, Option<f64>>(i)?.map_or(Value::NoText, Value::Real),
            () if *kind == Type::BYTEA => row.try_get::<_, Option<Vec<u8>>>(i)?.map_or(Value::NoText, Value::Blob),
            // Of any other type: an error, since it is none of ours.
            () => row.try_get::<_, Option<String>>(i)?.map_or(Value::NoText, Value::Text),
        })
    };
    row.columns().iter().enumerate().map(value).collect::<Result<_, _>>().map(Row)
}

/// One statement by itself, or after a lock that the others of its kind wait for.
fn say<T>(
    session: &mut Session,
    way: Way,
    sql: &str,
    values: &[Value],
    ask: impl Fn(&mut dyn Ask, &Statement, &[&(dyn ToSql + Sync)]) -> Result<T, postgres::Error>,
) -> Result<T, Broken> {
    let mut all = || {
        let statement = session.prepare(sql, values)?;
        let owned: Vec<_> = values.iter().map(sent).collect();
        let values: Vec<&(dyn ToSql + Sync)> = owned.iter().map(|v| &**v).collect();
        if way != Way::ChangeAlone {
            return ask(&mut session.client, &statement, &values);
        }
        let mut alone = session.client.transaction()?;
        alone.execute("SELECT pg_advisory_xact_lock($1, 1)", &[&ORB])?;
        let out = ask(&mut alone, &statement, &values)?;
        alone.commit()?;
        Ok(out)
    };
    all().map_err(Broken)
}

/// A client, or a transaction of its.
trait Ask {
    fn rows(&mut self, s: &Statement, values: &[&(dyn ToSql + Sync)]) -> Result<Vec<postgres::Row>, postgres::Error>;
    fn change(&mut self, s: &Statement, values: &[&(dyn ToSql + Sync)]) -> Result<u64, postgres::Error>;
}

impl<C: postgres::GenericClient> Ask for C {
    fn rows(&mut self, s: &Statement, values: &[&(dyn ToSql + Sync)]) -> Result<Vec<postgres::Row>, postgres::Error> {
        self.query(s, values)
    }

    fn change(&mut self, s: &Statement, values: &[&(dyn ToSql + Sync)]) -> Result<u64, postgres::Error> {
        self.execute(s, values)
    }
}

impl Sql for Postgres {
    fn rows(&self, way: Way, sql: &str, values: &[Value]) -> Result<Vec<Row>> {
        let ask = |session: &mut Session| {
            say(session, way, sql, values, |c, s, v| c.rows(s, v)?.iter().map(read).collect::<Result<_, _>>())
        };
        self.with(way, ask)
    }

    fn change(&self, way: Way, sql: &str, values: &[Value]) -> Result<u64> {
        self.with(way, |session| say(session, way, sql, values, |c, s, v| c.change(s, v)))
    }

    fn for_one(&self) -> &'static str {
        "FOR UPDATE SKIP LOCKED"
    }

    fn hold(&self) -> Result<()> {
        let begun = Instant::now();
        loop {
            let mut state = lock_state(self);
            let taken = self.ready(&mut state, Way::Change).and_then(|s| self.take_lock(&mut s.client));
            match taken {
                Ok(()) => {
                    self.held.store(true, Ordering::Relaxed);
                    return Ok(());
                }
                // One that was killed a moment ago is let go of soon.
                Err(_) if begun.elapsed() < PATIENCE => drop(state),
                Err(e) => return Err(e),
            }
            std::thread::sleep(PAUSE);
        }
    }
}
