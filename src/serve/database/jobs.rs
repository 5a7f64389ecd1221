//! Jobs in the database. Every change of state is one statement that says from which state: what happens at once, happens once.

use std::collections::BTreeMap;

use rusqlite::{OptionalExtension as _, Row, params, params_from_iter, types::Value};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::accounts::int;
use super::{Database, failed};
use crate::Result;
use crate::serve::Limits;
use crate::serve::submission::Submission;

/// Where a job is. The last four are ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum State {
    Queued,
    Running,
    Done,
    /// The run ended with an error.
    Failed,
    /// The run was refused by policy.
    Refused,
    Cancelled,
}

impl State {
    pub const ALL: [State; 6] =
        [State::Queued, State::Running, State::Done, State::Failed, State::Refused, State::Cancelled];

    pub fn name(self) -> &'static str {
        match self {
            State::Queued => "queued",
            State::Running => "running",
            State::Done => "done",
            State::Failed => "failed",
            State::Refused => "refused",
            State::Cancelled => "cancelled",
        }
    }

    pub fn is_end(self) -> bool {
        !matches!(self, State::Queued | State::Running)
    }
}

#[derive(Clone, Debug)]
pub struct Job {
    /// Counts up: the order in which jobs run.
    pub number: i64,
    pub id: String,
    pub account: String,
    pub state: State,
    pub marking: String,
    pub request: Submission,
    /// Milliseconds since 1970, as the other times.
    pub submitted: u64,
    pub started: Option<u64>,
    pub ended: Option<u64>,
    /// The run that goes on or went last, from 1.
    pub attempt: u32,
    pub cancel: bool,
    /// On the disk.
    pub bytes: u64,
    pub stage: Option<String>,
    pub exit_code: Option<i32>,
    pub error: Option<String>,
    /// What the run said of itself.
    pub result: Option<serde_json::Value>,
}

/// A job before it has a place in the queue.
#[derive(Clone, Copy, Debug)]
pub struct New<'a> {
    pub id: &'a str,
    pub account: &'a str,
    pub marking: &'a str,
    pub request: &'a Submission,
    pub submitted: u64,
    pub bytes: u64,
}

/// How a run ended.
#[derive(Clone, Debug)]
pub struct Ended {
    pub state: State,
    pub exit_code: Option<i32>,
    pub error: Option<String>,
    pub result: Option<serde_json::Value>,
    /// The product's own, where there is one.
    pub marking: Option<String>,
    pub bytes: u64,
}

/// Which jobs to list.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    pub state: Option<State>,
    /// Only lower numbers.
    pub before: Option<i64>,
    pub at_most: u32,
}

const COLUMNS: &str = "number, id, account, state, marking, request, submitted, started, ended, attempt, cancel, bytes, \
                       stage, exit_code, error, result";

fn job(row: &Row<'_>) -> rusqlite::Result<Job> {
    fn unsound(error: impl std::error::Error + Send + Sync + 'static) -> rusqlite::Error {
        rusqlite::Error::FromSqlConversionFailure(0, rusqlite::types::Type::Text, Box::new(error))
    }
    let time = |i: usize| row.get::<_, Option<i64>>(i).map(|t| t.map(i64::unsigned_abs));
    let state: String = row.get(3)?;
    Ok(Job {
        number: row.get(0)?,
        id: row.get(1)?,
        account: row.get(2)?,
        state: serde_json::from_value(state.into()).map_err(unsound)?,
        marking: row.get(4)?,
        request: serde_json::from_str(&row.get::<_, String>(5)?).map_err(unsound)?,
        submitted: time(6)?.unwrap_or_default(),
        started: time(7)?,
        ended: time(8)?,
        attempt: row.get(9)?,
        cancel: row.get(10)?,
        bytes: row.get::<_, i64>(11)?.unsigned_abs(),
        stage: row.get(12)?,
        exit_code: row.get(13)?,
        error: row.get(14)?,
        result: row.get::<_, Option<String>>(15)?.map(|t| serde_json::from_str(&t)).transpose().map_err(unsound)?,
    })
}

fn text(value: &impl Serialize) -> String {
    // Plain values with text keys always serialise.
    serde_json::to_string(value).unwrap_or_default()
}

impl Database {
    /// A new job at the end of the queue; false, and none, where a limit is reached.
    ///
    /// # Errors
    /// Environment.
    pub fn add_job(&self, job: &New<'_>, limits: &Limits) -> Result<bool> {
        let added = self
            .connection()
            .execute(
                "INSERT INTO job (id, account, state, marking, request, submitted, bytes)
                 SELECT ?1, ?2, 'queued', ?3, ?4, ?5, ?6
                 WHERE (SELECT count(*) FROM job WHERE state IN ('queued', 'running')) < ?7
                 AND (SELECT count(*) FROM job WHERE state IN ('queued', 'running') AND account = ?2) < ?8
                 AND (SELECT coalesce(sum(bytes), 0) FROM job) + ?6 <= ?9",
                params![
                    job.id,
                    job.account,
                    job.marking,
                    text(job.request),
                    int(job.submitted),
                    int(job.bytes),
                    int(limits.queue),
                    int(limits.queue_each),
                    int(limits.stored)
                ],
            )
            .map_err(failed)?;
        Ok(added > 0)
    }

    /// # Errors
    /// Environment.
    pub fn job(&self, id: &str) -> Result<Option<Job>> {
        let connection = self.connection();
        let mut statement =
            connection.prepare_cached(&format!("SELECT {COLUMNS} FROM job WHERE id = ?1")).map_err(failed)?;
        statement.query_row([id], job).optional().map_err(failed)
    }

    /// Newest first, those marked with one of `markings` only.
    ///
    /// # Errors
    /// Environment.
    pub fn jobs(&self, wanted: &Selection, markings: &[String]) -> Result<Vec<Job>> {
        let places = vec!["?"; markings.len()].join(",");
        let mut sql = format!("SELECT {COLUMNS} FROM job WHERE marking IN ({places})");
        let mut values: Vec<Value> = markings.iter().cloned().map(Value::Text).collect();
        if let Some(state) = wanted.state {
            sql.push_str(" AND state = ?");
            values.push(Value::Text(state.name().to_owned()));
        }
        if let Some(before) = wanted.before {
            sql.push_str(" AND number < ?");
            values.push(Value::Integer(before));
        }
        sql.push_str(" ORDER BY number DESC LIMIT ?");
        values.push(Value::Integer(wanted.at_most.into()));
        let connection = self.connection();
        let mut statement = connection.prepare_cached(&sql).map_err(failed)?;
        let rows = statement.query_map(params_from_iter(values), job).map_err(failed)?;
        rows.collect::<rusqlite::Result<_>>().map_err(failed)
    }

    /// Every marking that some job has.
    ///
    /// # Errors
    /// Environment.
    pub fn markings(&self) -> Result<Vec<String>> {
        let connection = self.connection();
        // One step of the index for each marking, not one for each job.
        let sql = "WITH RECURSIVE m(x) AS (SELECT min(marking) FROM job UNION ALL
                   SELECT (SELECT min(marking) FROM job WHERE marking > x) FROM m WHERE x IS NOT NULL)
                   SELECT x FROM m WHERE x IS NOT NULL";
        let mut statement = connection.prepare_cached(sql).map_err(failed)?;
        let rows = statement.query_map([], |row| row.get(0)).map_err(failed)?;
        rows.collect::<rusqlite::Result<_>>().map_err(failed)
    }

    /// How many jobs wait before this one.
    ///
    /// # Errors
    /// Environment.
    pub fn waiting_before(&self, number: i64) -> Result<u64> {
        self.count("SELECT count(*) FROM job WHERE state = 'queued' AND number < ?1", params![number])
    }

    /// Jobs that wait or run: of all, and of one account.
    ///
    /// # Errors
    /// Environment.
    pub fn unfinished(&self, account: &str) -> Result<(u64, u64)> {
        let all = self.count("SELECT count(*) FROM job WHERE state IN ('queued', 'running')", [])?;
        let own =
            self.count("SELECT count(*) FROM job WHERE state IN ('queued', 'running') AND account = ?1", [account])?;
        Ok((all, own))
    }

    /// Bytes of all jobs together.
    ///
    /// # Errors
    /// Environment.
    pub fn stored(&self) -> Result<u64> {
        self.count("SELECT coalesce(sum(bytes), 0) FROM job", [])
    }

    /// # Errors
    /// Environment.
    pub fn count_by_state(&self) -> Result<BTreeMap<State, u64>> {
        let one = |s: &State| Ok((*s, self.count("SELECT count(*) FROM job WHERE state = ?1", [s.name()])?));
        State::ALL.iter().map(one).collect()
    }

    fn count(&self, sql: &str, params: impl rusqlite::Params) -> Result<u64> {
        let connection = self.connection();
        let mut statement = connection.prepare_cached(sql).map_err(failed)?;
        statement.query_row(params, |row| row.get::<_, i64>(0)).map(i64::unsigned_abs).map_err(failed)
    }

    /// The job that has waited longest, now running, its attempts one more.
    ///
    /// # Errors
    /// Environment.
    pub fn take(&self, now: u64) -> Result<Option<Job>> {
        let sql = format!(
            "UPDATE job SET state = 'running', attempt = attempt + 1, started = ?1, ended = NULL, stage = NULL
             WHERE number = (SELECT min(number) FROM job WHERE state = 'queued') RETURNING {COLUMNS}"
        );
        let connection = self.connection();
        let mut statement = connection.prepare_cached(&sql).map_err(failed)?;
        statement.query_row([int(now)], job).optional().map_err(failed)
    }

    /// # Errors
    /// Environment.
    pub fn running(&self) -> Result<Vec<Job>> {
        let connection = self.connection();
        let sql = format!("SELECT {COLUMNS} FROM job WHERE state = 'running' ORDER BY number");
        let mut statement = connection.prepare(&sql).map_err(failed)?;
        let rows = statement.query_map([], job).map_err(failed)?;
        rows.collect::<rusqlite::Result<_>>().map_err(failed)
    }

    /// # Errors
    /// Environment.
    pub fn set_stage(&self, id: &str, stage: &str) -> Result<()> {
        let sql = "UPDATE job SET stage = ?2 WHERE id = ?1 AND state = 'running'";
        self.connection().execute(sql, [id, stage]).map(drop).map_err(failed)
    }

    /// A running job ends.
    ///
    /// # Errors
    /// Environment.
    pub fn end(&self, id: &str, ended: &Ended, now: u64) -> Result<()> {
        let result = ended.result.as_ref().map(text);
        self.connection()
            .execute(
                "UPDATE job SET state = ?2, exit_code = ?3, error = ?4, result = ?5, marking = coalesce(?6, marking), bytes = ?7,
                 ended = ?8, stage = NULL WHERE id = ?1 AND state = 'running'",
                params![id, ended.state.name(), ended.exit_code, ended.error, result, ended.marking, int(ended.bytes), int(now)],
            )
            .map(drop)
            .map_err(failed)
    }

    /// A running job waits again, at its old place; `uncounted` where the server was ended in order.
    ///
    /// # Errors
    /// Environment.
    pub fn put_back(&self, id: &str, uncounted: bool) -> Result<()> {
        let sql = "UPDATE job SET state = 'queued', attempt = attempt - ?2, started = NULL, stage = NULL
                   WHERE id = ?1 AND state = 'running'";
        self.connection().execute(sql, params![id, i64::from(uncounted)]).map(drop).map_err(failed)
    }

    /// A waiting job is cancelled; of a running one it is noted that it is to be. The state before, if it was one of them.
    ///
    /// # Errors
    /// Environment.
    pub fn cancel(&self, id: &str, now: u64) -> Result<Option<State>> {
        let connection = self.connection();
        let waiting = "UPDATE job SET state = 'cancelled', cancel = 1, ended = ?2 WHERE id = ?1 AND state = 'queued'";
        if connection.execute(waiting, params![id, int(now)]).map_err(failed)? > 0 {
            return Ok(Some(State::Queued));
        }
        let running = "UPDATE job SET cancel = 1 WHERE id = ?1 AND state = 'running'";
        Ok((connection.execute(running, [id]).map_err(failed)? > 0).then_some(State::Running))
    }

    /// False for a job that runs, or is none. A waiting one does not run any more.
    ///
    /// # Errors
    /// Environment.
    pub fn remove_job(&self, id: &str) -> Result<bool> {
        let sql = "DELETE FROM job WHERE id = ?1 AND state <> 'running'";
        Ok(self.connection().execute(sql, [id]).map_err(failed)? > 0)
    }
}
