//! Jobs in the database. Every change of state is one statement that says from which state: what happens at once, happens once.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::Database;
use super::sql::{Row, Value, Way, places, unsound, values};
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
    /// Its files are in this server's folder, and so is its run.
    pub here: bool,
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
                       stage, exit_code, error, result, folder";

pub(super) fn request(text: &str) -> Result<Submission> {
    serde_json::from_str(text)
        .map_err(|e| unsound("what a job was asked to do", "JSON of a submission", &e.to_string()))
}

fn text(value: &impl Serialize) -> String {
    // Plain values with text keys always serialise.
    serde_json::to_string(value).unwrap_or_default()
}

impl Database {
    fn job_of(&self, row: &Row) -> Result<Job> {
        let state: String = row.get(3)?;
        let result: Option<String> = row.get(15)?;
        let result = result.map(|text| serde_json::from_str(&text)).transpose();
        Ok(Job {
            number: row.get(0)?,
            id: row.get(1)?,
            account: row.get(2)?,
            state: State::ALL
                .into_iter()
                .find(|s| s.name() == state)
                .ok_or_else(|| unsound("a job's state", "one of Orb's", &state))?,
            marking: row.get(4)?,
            request: request(&row.get::<String>(5)?)?,
            submitted: row.get(6)?,
            started: row.get(7)?,
            ended: row.get(8)?,
            attempt: row.get(9)?,
            cancel: row.get(10)?,
            bytes: row.get(11)?,
            stage: row.get(12)?,
            exit_code: row.get(13)?,
            error: row.get(14)?,
            result: result.map_err(|e| unsound("what a run said", "JSON", &e.to_string()))?,
            here: row.get::<String>(16)? == self.folder,
        })
    }

    /// A new job at the end of the queue; false, and none, where a limit is reached.
    ///
    /// # Errors
    /// Environment.
    pub fn add_job(&self, job: &New<'_>, limits: &Limits) -> Result<bool> {
        let sql = "INSERT INTO job (id, account, state, marking, request, submitted, bytes, folder)
                   SELECT $1, $2, 'queued', $3, $4, $5, $6, $10
                   WHERE (SELECT count(*) FROM job WHERE state IN ('queued', 'running') AND folder = $10) < $7
                   AND (SELECT count(*) FROM job WHERE state IN ('queued', 'running') AND folder = $10 AND account = $2) < $8
                   AND (SELECT coalesce(sum(bytes), 0) FROM job WHERE folder = $10) + $6 <= $9";
        let (request, folder) = (text(job.request), self.folder.as_str());
        let (waiting, each, stored) = (limits.queue, limits.queue_each, limits.stored);
        let values =
            values![job.id, job.account, job.marking, request, job.submitted, job.bytes, waiting, each, stored, folder];
        Ok(self.sql.change(Way::ChangeAlone, sql, &values)? > 0)
    }

    /// # Errors
    /// Environment.
    pub fn job(&self, id: &str) -> Result<Option<Job>> {
        let sql = format!("SELECT {COLUMNS} FROM job WHERE id = $1");
        self.rows(&sql, &values![id])?.first().map(|row| self.job_of(row)).transpose()
    }

    /// Newest first, those marked with one of `markings` only.
    ///
    /// # Errors
    /// Environment.
    pub fn jobs(&self, wanted: &Selection, markings: &[String]) -> Result<Vec<Job>> {
        if markings.is_empty() {
            return Ok(Vec::new());
        }
        let mut sql = format!("SELECT {COLUMNS} FROM job WHERE marking IN ({})", places(1, markings.len()));
        let mut values: Vec<Value> = markings.iter().cloned().map(Value::Text).collect();
        let mut add = |words: &str, value: Value| {
            values.push(value);
            sql.push_str(&format!(" {words} ${}", values.len()));
        };
        if let Some(state) = wanted.state {
            add("AND state =", state.name().into());
        }
        if let Some(before) = wanted.before {
            add("AND number <", before.into());
        }
        add("ORDER BY number DESC LIMIT", wanted.at_most.into());
        self.rows(&sql, &values)?.iter().map(|row| self.job_of(row)).collect()
    }

    /// Every marking that some job has.
    ///
    /// # Errors
    /// Environment.
    pub fn markings(&self) -> Result<Vec<String>> {
        // One step of the index for each marking, not one for each job.
        let sql = "WITH RECURSIVE m(x) AS (SELECT min(marking) FROM job UNION ALL
                   SELECT (SELECT min(marking) FROM job WHERE marking > x) FROM m WHERE x IS NOT NULL)
                   SELECT x FROM m WHERE x IS NOT NULL";
        self.rows(sql, &[])?.iter().map(|row| row.get(0)).collect()
    }

    /// How many jobs of its server's wait before this one.
    ///
    /// # Errors
    /// Environment.
    pub fn waiting_before(&self, number: i64) -> Result<u64> {
        let sql = "SELECT count(*) FROM job WHERE state = 'queued' AND number < $1
                   AND folder = (SELECT folder FROM job WHERE number = $1)";
        self.count(sql, &values![number])
    }

    /// Jobs of this server's that wait or run: of all, and of one account.
    ///
    /// # Errors
    /// Environment.
    pub fn unfinished(&self, account: &str) -> Result<(u64, u64)> {
        let all = "SELECT count(*) FROM job WHERE state IN ('queued', 'running') AND folder = $1";
        let own = format!("{all} AND account = $2");
        let values = values![self.folder.as_str(), account];
        Ok((self.count(all, &values[..1])?, self.count(&own, &values)?))
    }

    /// Bytes of all jobs in this server's folder together.
    ///
    /// # Errors
    /// Environment.
    pub fn stored(&self) -> Result<u64> {
        let sql = "SELECT CAST(coalesce(sum(bytes), 0) AS BIGINT) FROM job WHERE folder = $1";
        self.count(sql, &values![self.folder.as_str()])
    }

    /// # Errors
    /// Environment.
    pub fn count_by_state(&self) -> Result<BTreeMap<State, u64>> {
        let one = |s: &State| Ok((*s, self.count("SELECT count(*) FROM job WHERE state = $1", &values![s.name()])?));
        State::ALL.iter().map(one).collect()
    }

    fn count(&self, sql: &str, values: &[Value]) -> Result<u64> {
        self.rows(sql, values)?.first().map_or(Ok(0), |row| row.get(0))
    }

    /// The job of this server's folder that has waited longest, now running, its attempts one more. Nobody else gets it.
    ///
    /// # Errors
    /// Environment: a job may be running that nobody runs ([`crate::serve::runner::recover`]).
    pub fn take(&self, now: u64) -> Result<Option<Job>> {
        let sql = format!(
            "UPDATE job SET state = 'running', attempt = attempt + 1, started = $1, ended = NULL, stage = NULL
             WHERE number = (SELECT number FROM job WHERE state = 'queued' AND folder = $2 ORDER BY number LIMIT 1 {})
             RETURNING {COLUMNS}",
            self.sql.for_one()
        );
        let taken = self.sql.rows(Way::Change, &sql, &values![now, self.folder.as_str()])?;
        taken.first().map(|row| self.job_of(row)).transpose()
    }

    /// Jobs of this server's folder.
    ///
    /// # Errors
    /// Environment.
    pub fn running(&self) -> Result<Vec<Job>> {
        let sql = format!("SELECT {COLUMNS} FROM job WHERE state = 'running' AND folder = $1 ORDER BY number");
        self.rows(&sql, &values![self.folder.as_str()])?.iter().map(|row| self.job_of(row)).collect()
    }

    /// # Errors
    /// Environment.
    pub fn set_stage(&self, id: &str, stage: &str) -> Result<()> {
        let sql = "UPDATE job SET stage = $2 WHERE id = $1 AND state = 'running'";
        self.change(sql, &values![id, stage]).map(drop)
    }

    /// A running job ends.
    ///
    /// # Errors
    /// Environment.
    pub fn end(&self, id: &str, ended: &Ended, now: u64) -> Result<()> {
        let sql = "UPDATE job SET state = $2, exit_code = $3, error = $4, result = $5, marking = coalesce($6, marking),
                   bytes = $7, ended = $8, stage = NULL WHERE id = $1 AND state = 'running'";
        let (error, marking) = (ended.error.clone(), ended.marking.clone());
        let result = ended.result.as_ref().map(text);
        let values = values![id, ended.state.name(), ended.exit_code, error, result, marking, ended.bytes, now];
        self.change(sql, &values).map(drop)
    }

    /// A running job waits again, at its old place; `uncounted` where the server was ended in order.
    ///
    /// # Errors
    /// Environment.
    pub fn put_back(&self, id: &str, uncounted: bool) -> Result<()> {
        let sql = "UPDATE job SET state = 'queued', attempt = attempt - $2, started = NULL, stage = NULL
                   WHERE id = $1 AND state = 'running'";
        self.change(sql, &values![id, uncounted]).map(drop)
    }

    /// A waiting job is cancelled; of a running one it is noted that it is to be. The state before, if it was one of them.
    ///
    /// # Errors
    /// Environment.
    pub fn cancel(&self, id: &str, now: u64) -> Result<Option<State>> {
        let waiting = "UPDATE job SET state = 'cancelled', cancel = 1, ended = $2 WHERE id = $1 AND state = 'queued'";
        if self.change(waiting, &values![id, now])? > 0 {
            return Ok(Some(State::Queued));
        }
        let running = "UPDATE job SET cancel = 1 WHERE id = $1 AND state = 'running'";
        Ok((self.change(running, &values![id])? > 0).then_some(State::Running))
    }

    /// Whether a running job is to be cancelled, whichever server was told so.
    ///
    /// # Errors
    /// Environment.
    pub fn is_cancelled(&self, id: &str) -> Result<bool> {
        Ok(self.count("SELECT cancel FROM job WHERE id = $1", &values![id])? > 0)
    }

    /// False for a job that runs, or is none. A waiting one does not run any more.
    ///
    /// # Errors
    /// Environment.
    pub fn remove_job(&self, id: &str) -> Result<bool> {
        Ok(self.change("DELETE FROM job WHERE id = $1 AND state <> 'running'", &values![id])? > 0)
    }
}
