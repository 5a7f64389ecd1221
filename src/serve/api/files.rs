//! What a job published, over the wire.

use std::path::PathBuf;
use std::sync::Arc;

use axum::Json;
use axum::extract::{Path, State};
use axum::http::{HeaderName, StatusCode, header};
use axum::response::{IntoResponse as _, Response};
use serde::Serialize;
use utoipa::ToSchema;

use super::{Answer, Caller, Refused, blocking};
use crate::serve::Server;
use crate::serve::database::{Job, State as JobState};
use crate::serve::files::{self, Listed};
use crate::serve::refusal::Refusal;
use crate::serve::role::Right;

const RECORD: &str = "orb-record.dsse.json";
const MARKING: HeaderName = HeaderName::from_static("x-orb-marking");

/// Where a job's results are.
///
/// # Errors
/// 409 for a job that has none, or has them elsewhere.
pub fn folder(server: &Server, job: &Job) -> Answer<PathBuf> {
    job_is_here(job)?;
    match job.state {
        JobState::Done => Ok(server.place.published(&job.id, job.attempt)),
        other => Err(Refusal::conflict(format!("the job is {} and has published nothing", other.name()))),
    }
}

/// Refuses what needs a job's files where another server of the same database has them.
///
/// # Errors
/// 409.
pub fn job_is_here(job: &Job) -> Answer<()> {
    match job.here {
        true => Ok(()),
        false => Err(Refusal::conflict("another server has the files of this job: it was submitted there")),
    }
}

/// What a job published.
#[derive(Serialize, ToSchema)]
pub struct Files {
    marking: String,
    /// By name.
    files: Vec<Listed>,
}

/// The files that a job published
#[utoipa::path(get, path = "/api/v1/jobs/{id}/files", tag = "results", params(("id" = String, Path)),
    security(("token" = []), ("session" = [])), responses((status = 200, body = Files), Refused))]
pub async fn list(State(server): State<Arc<Server>>, caller: Caller, Path(id): Path<String>) -> Answer<Json<Files>> {
    blocking(&server, move |server| {
        let job = caller.job(server, &id, Right::Scenes)?;
        Ok(Json(Files { files: files::list(&folder(server, &job)?)?, marking: job.marking }))
    })
    .await
}

/// One of these files, by its name in the list
#[utoipa::path(get, path = "/api/v1/jobs/{id}/files/{*name}", tag = "results",
    params(("id" = String, Path), ("name" = String, Path)), security(("token" = []), ("session" = [])),
    responses((status = 200, body = Vec<u8>, content_type = "*/*"), Refused))]
pub async fn one(
    State(server): State<Arc<Server>>,
    caller: Caller,
    Path((id, name)): Path<(String, String)>,
) -> Answer<Response> {
    send(server, caller, id, name, Right::Scenes).await
}

/// The signed record of a job
#[utoipa::path(get, path = "/api/v1/jobs/{id}/record", tag = "records", params(("id" = String, Path)),
    security(("token" = []), ("session" = [])), responses((status = 200, body = Object), Refused))]
pub async fn record(State(server): State<Arc<Server>>, caller: Caller, Path(id): Path<String>) -> Answer<Response> {
    send(server, caller, id, RECORD.into(), Right::Records).await
}

fn place(server: &Server) -> Answer<tokio::sync::OwnedSemaphorePermit> {
    let busy = |_| Refusal::busy("too many files are being sent");
    Arc::clone(&server.downloads).try_acquire_owned().map_err(busy)
}

async fn send(server: Arc<Server>, caller: Caller, id: String, name: String, right: Right) -> Answer<Response> {
    let place = place(&server)?;
    blocking(&server, move |server| {
        let job = caller.job(server, &id, right)?;
        // The name is looked for among names, never made a path of.
        let mut listed = files::list(&folder(server, &job)?)?.into_iter();
        let file = listed.find(|f| f.name == name).ok_or_else(Refusal::not_found)?;
        let shown = file.media_type == "image/png" || file.media_type == "application/json";
        let headers = [
            (header::CONTENT_TYPE, file.media_type.to_owned()),
            (header::CONTENT_LENGTH, file.bytes.to_string()),
            (header::CONTENT_DISPOSITION, disposition(file.name.rsplit('/').next().unwrap_or_default(), shown)),
            (MARKING, job.marking),
        ];
        Ok((StatusCode::OK, headers, files::send(&file.path, place)?).into_response())
    })
    .await
}

/// Plain characters only: what else a name may hold is told by the list.
fn disposition(name: &str, shown: bool) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || "._-".contains(c) { c } else { '_' };
    let kind = if shown { "inline" } else { "attachment" };
    format!("{kind}; filename=\"{}\"", name.chars().map(plain).collect::<String>())
}

/// Everything that a job published, its record among it, as one ZIP archive
#[utoipa::path(get, path = "/api/v1/jobs/{id}/archive.zip", tag = "results", params(("id" = String, Path)),
    security(("token" = []), ("session" = [])),
    responses((status = 200, body = Vec<u8>, content_type = "application/zip"), Refused))]
pub async fn archive(State(server): State<Arc<Server>>, caller: Caller, Path(id): Path<String>) -> Answer<Response> {
    let place = place(&server)?;
    blocking(&server, move |server| {
        let job = caller.job(server, &id, Right::Scenes)?;
        let listed = files::list(&folder(server, &job)?)?;
        let name = job.request.name.unwrap_or_else(|| "model".into());
        let headers = [
            (header::CONTENT_TYPE, "application/zip".to_owned()),
            (header::CONTENT_DISPOSITION, disposition(&format!("{name}.zip"), false)),
            (MARKING, job.marking.clone()),
        ];
        Ok((headers, files::send_archive(listed, name, job.marking, place)).into_response())
    })
    .await
}
