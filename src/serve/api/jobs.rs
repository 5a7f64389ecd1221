//! Jobs: list, state, events as they happen, cancel, delete, verify.

use std::convert::Infallible;
use std::pin::Pin;
use std::sync::Arc;
use std::time::Duration;

use axum::Json;
use axum::extract::rejection::QueryRejection;
use axum::extract::{Path, Query, State};
use axum::http::{StatusCode, header};
use axum::response::sse::{Event, KeepAlive, Sse};
use axum::response::{IntoResponse as _, Response};
use futures_util::Stream;
use futures_util::stream::unfold;
use serde::{Deserialize, Serialize};
use tokio::sync::OwnedSemaphorePermit;
use tokio::sync::watch::Receiver;
use tokio::time::{Instant, timeout_at};
use utoipa::{IntoParams, ToSchema};

use super::files::job_is_here;
use super::{Answer, Caller, Refused, asked, blocking};
use crate::audit::time::format_utc;
use crate::audit::{TrustStore, verify};
use crate::serve::Server;
use crate::serve::database::{Job, Selection, State as JobState};
use crate::serve::live::Progress;
use crate::serve::refusal::Refusal;
use crate::serve::role::Right;
use crate::serve::submission::Submission;

const LISTED: u32 = 50;
const MOST_LISTED: u32 = 200;
/// A stream of events ends after this, and a browser opens it again: who may no longer watch is found out by then.
const STREAM: Duration = Duration::from_secs(300);
const KEEP_ALIVE: Duration = Duration::from_secs(15);
/// Between two looks at a job that another server of the same database runs.
const ELSEWHERE: Duration = Duration::from_secs(2);
/// Between two events of one stream.
const PAUSE: Duration = Duration::from_millis(200);

/// A job as it is told.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
#[schema(as = Job)]
pub struct Told {
    pub id: String,
    /// Counts up: the order in which jobs run.
    pub number: i64,
    pub name: Option<String>,
    /// Who submitted it.
    pub account: String,
    pub state: JobState,
    pub marking: String,
    /// UTC, as all times.
    pub submitted: String,
    pub started: Option<String>,
    pub ended: Option<String>,
    /// The run that goes on or went last, from 1.
    pub attempt: u32,
    /// It runs, and was told to stop.
    pub cancelling: bool,
    pub progress: Option<Progress>,
    /// What went wrong, in words.
    pub error: Option<String>,
    /// Of `orb geo`.
    pub exit_code: Option<i32>,
    /// On the server's disk.
    pub bytes: u64,
    pub request: Submission,
}

/// A job with what its run said of itself.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
#[schema(as = JobInFull)]
pub struct InFull {
    #[serde(flatten)]
    pub job: Told,
    /// Jobs that wait before this one; none where it does not wait.
    pub waiting_before: Option<u64>,
    /// The object of `orb geo --json`.
    #[schema(value_type = Option<Object>)]
    pub result: Option<serde_json::Value>,
}

/// One of a stream of server-sent events.
#[derive(ToSchema)]
#[allow(dead_code, reason = "read by the document alone")]
struct Happened {
    /// `job`
    event: String,
    /// A job in full, as JSON.
    data: String,
}

pub fn told(server: &Server, job: Job) -> Told {
    let live = server.live.progress_of(&job.id).filter(|_| job.state == JobState::Running);
    let stage = job.stage.map(|stage| Progress { stage, fraction: None, seconds_left: None });
    Told {
        name: job.request.name.clone(),
        number: job.number,
        account: job.account,
        state: job.state,
        marking: job.marking,
        submitted: format_utc(job.submitted),
        started: job.started.map(format_utc),
        ended: job.ended.map(format_utc),
        attempt: job.attempt,
        cancelling: job.cancel && job.state == JobState::Running,
        progress: live.or(stage),
        error: job.error,
        exit_code: job.exit_code,
        bytes: job.bytes,
        request: job.request,
        id: job.id,
    }
}

fn in_full(server: &Server, mut job: Job) -> Answer<InFull> {
    let waits = job.state == JobState::Queued;
    let waiting_before = if waits { Some(server.database.waiting_before(job.number)?) } else { None };
    let result = job.result.take();
    Ok(InFull { job: told(server, job), waiting_before, result })
}

#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub struct Wanted {
    state: Option<JobState>,
    /// Only lower numbers: the next page.
    before: Option<i64>,
    #[param(minimum = 1, maximum = 200, default = 50)]
    limit: Option<u32>,
}

/// Jobs that this account may know of.
#[derive(Serialize, ToSchema)]
pub struct Jobs {
    /// Newest first.
    jobs: Vec<Told>,
}

/// Jobs, newest first
#[utoipa::path(get, path = "/api/v1/jobs", tag = "jobs", params(Wanted), security(("token" = []), ("session" = [])),
    responses((status = 200, body = Jobs), Refused))]
pub async fn list(
    State(server): State<Arc<Server>>,
    caller: Caller,
    query: Result<Query<Wanted>, QueryRejection>,
) -> Answer<Json<Jobs>> {
    let wanted = asked(query)?;
    let limit = wanted.limit.unwrap_or(LISTED);
    if !(1..=MOST_LISTED).contains(&limit) {
        return Err(Refusal::unusable(format!("limit: expected 1 to {MOST_LISTED}, found {limit}")));
    }
    let selection = Selection { state: wanted.state, before: wanted.before, at_most: limit };
    blocking(&server, move |server| {
        caller.need(server, Right::Records)?;
        let mut markings = server.database.markings()?;
        markings.retain(|m| caller.may_see(server, m));
        let jobs = server.database.jobs(&selection, &markings)?;
        Ok(Json(Jobs { jobs: jobs.into_iter().map(|job| told(server, job)).collect() }))
    })
    .await
}

/// A job
#[utoipa::path(get, path = "/api/v1/jobs/{id}", tag = "jobs", params(("id" = String, Path)),
    security(("token" = []), ("session" = [])), responses((status = 200, body = InFull), Refused))]
pub async fn show(State(server): State<Arc<Server>>, caller: Caller, Path(id): Path<String>) -> Answer<Json<InFull>> {
    blocking(&server, move |server| in_full(server, caller.job(server, &id, Right::Records)?).map(Json)).await
}

/// A job as it goes on: server-sent events named `job`, each a job in full, until its end
#[utoipa::path(get, path = "/api/v1/jobs/{id}/events", tag = "jobs", params(("id" = String, Path)),
    security(("token" = []), ("session" = [])),
    responses((status = 200, body = Happened, content_type = "text/event-stream"), Refused))]
pub async fn watch(State(server): State<Arc<Server>>, caller: Caller, Path(id): Path<String>) -> Answer<Response> {
    let busy = || Refusal::busy("too many jobs are watched at once");
    let place = Arc::clone(&server.streams).try_acquire_owned().map_err(|_| busy())?;
    let bell = server.live.listen();
    let asked = id.clone();
    let watcher = caller.clone();
    let here = blocking(&server, move |server| Ok(watcher.job(server, &asked, Right::Records)?.here)).await?;
    let until = Instant::now() + STREAM;
    let watch = Watch { server, caller, id, bell, last: None, until, here, done: false, _place: place };
    let events: Pin<Box<dyn Stream<Item = Result<Event, Infallible>> + Send>> =
        Box::pin(unfold(watch, |mut watch| async move { watch.next().await.map(|event| (Ok(event), watch)) }));
    let sse = Sse::new(events).keep_alive(KeepAlive::new().interval(KEEP_ALIVE));
    Ok(([(header::HeaderName::from_static("x-accel-buffering"), "no")], sse).into_response())
}

/// A client that watches a job.
struct Watch {
    server: Arc<Server>,
    caller: Caller,
    id: String,
    bell: Receiver<u64>,
    last: Option<InFull>,
    until: Instant,
    here: bool,
    done: bool,
    _place: OwnedSemaphorePermit,
}

impl Watch {
    /// The next event; `None` after the job's end.
    async fn next(&mut self) -> Option<Event> {
        while !self.done {
            self.bell.mark_unchanged();
            let (caller, id) = (self.caller.clone(), self.id.clone());
            let job = blocking(&self.server, move |server| in_full(server, caller.job(server, &id, Right::Records)?));
            let Ok(job) = job.await else { return None };
            self.done = job.job.state.is_end();
            if self.last.as_ref() != Some(&job) {
                let event = Event::default().event("job").json_data(&job).ok()?;
                self.last = Some(job);
                return Some(event);
            }
            tokio::time::sleep(PAUSE).await;
            // Of a job of another server's no bell rings here.
            let look = if self.here { self.until } else { self.until.min(Instant::now() + ELSEWHERE) };
            let rung = timeout_at(look, self.bell.changed()).await;
            if matches!(rung, Ok(Err(_))) || Instant::now() >= self.until {
                return None;
            }
        }
        None
    }
}

/// Only who submitted a job ends it.
fn own_job(server: &Server, caller: &Caller, id: &str) -> Answer<Job> {
    let job = caller.job(server, id, Right::Submit)?;
    if job.account != caller.name {
        server.recorder.refused(&caller.name, "NOT_OWN_JOB", server.now());
        return Err(Refusal::forbidden("another account submitted this job"));
    }
    Ok(job)
}

/// Cancel a job that waits or runs
#[utoipa::path(post, path = "/api/v1/jobs/{id}/cancel", tag = "jobs", params(("id" = String, Path)),
    security(("token" = []), ("session" = [])), responses((status = 202, body = InFull), Refused))]
pub async fn cancel(State(server): State<Arc<Server>>, caller: Caller, Path(id): Path<String>) -> Answer<Response> {
    blocking(&server, move |server| {
        let job = own_job(server, &caller, &id)?;
        if job.state.is_end() {
            return Err(Refusal::conflict(format!("the job is {}", job.state.name())));
        }
        server.recorder.act("job.cancel", &[("account", &caller.name), ("job", &id)])?;
        if server.database.cancel(&id, server.now())? == Some(JobState::Running) {
            server.live.cancel(&id);
        }
        server.live.ring();
        let job = caller.job(server, &id, Right::Submit)?;
        Ok((StatusCode::ACCEPTED, Json(in_full(server, job)?)).into_response())
    })
    .await
}

/// Delete a job that does not run, with everything that it published
#[utoipa::path(delete, path = "/api/v1/jobs/{id}", tag = "jobs", params(("id" = String, Path)),
    security(("token" = []), ("session" = [])), responses((status = 204), Refused))]
pub async fn remove(State(server): State<Arc<Server>>, caller: Caller, Path(id): Path<String>) -> Answer<StatusCode> {
    blocking(&server, move |server| {
        let job = own_job(server, &caller, &id)?;
        job_is_here(&job)?;
        let runs = || Refusal::conflict("the job runs: cancel it first");
        if job.state == JobState::Running {
            return Err(runs());
        }
        server.recorder.act("job.delete", &[("account", &caller.name), ("job", &id)])?;
        if !server.database.remove_job(&id)? {
            return Err(runs());
        }
        server.viewers.close(&id);
        // What cannot be removed now is at the next start.
        if let Err(e) = server.place.remove_job(&id) {
            eprintln!("orb: warning: {e}");
        }
        server.live.ring();
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}

/// Verify what a job published, as `orb audit verify --json` does; the verdict is an event of the ledger
#[utoipa::path(post, path = "/api/v1/jobs/{id}/verify", tag = "records", params(("id" = String, Path)),
    security(("token" = []), ("session" = [])), responses((status = 200, body = Object), Refused))]
pub async fn verify(State(server): State<Arc<Server>>, caller: Caller, Path(id): Path<String>) -> Answer<Response> {
    let busy = || Refusal::busy("another verification is under way");
    let place = Arc::clone(&server.checks).try_acquire_owned().map_err(|_| busy())?;
    let report = blocking(&server, move |server| {
        let _place = place;
        let job = caller.job(server, &id, Right::Records)?;
        let folder = super::files::folder(server, &job)?;
        let inputs: Vec<_> = job.request.inputs().iter().map(|i| server.place.job(&id).join(i)).collect();
        let data = server.recorder.data();
        let trust = TrustStore::load(data, &[])?;
        let request = verify::Request { inputs: &inputs, ..verify::Request::new(&folder, &trust, server.now()) };
        let report = verify::verify(&request)?;
        server.recorder.verdict(&report);
        Ok(report.to_json())
    })
    .await?;
    Ok(([(header::CONTENT_TYPE, "application/json")], report).into_response())
}
