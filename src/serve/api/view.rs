//! The viewer of a job's scene: the page of `orb view`, for whom the job may be shown.

use std::sync::Arc;

use axum::Router;
use axum::extract::{Path, Request, State};
use axum::response::{IntoResponse as _, Response};
use axum::routing::get;
use tower::ServiceExt as _;

use super::{Answer, Caller, blocking};
use crate::serve::Server;
use crate::serve::refusal::Refusal;
use crate::serve::role::Right;
use crate::view::server::scene_routes;

pub fn routes() -> Router<Arc<Server>> {
    Router::new().route("/view/{id}/", get(page)).route("/view/{id}/{part}", get(part))
}

async fn page(state: State<Arc<Server>>, caller: Caller, Path(id): Path<String>, request: Request) -> Answer<Response> {
    scene(state, caller, id, request).await
}

async fn part(
    state: State<Arc<Server>>,
    caller: Caller,
    Path((id, _)): Path<(String, String)>,
    request: Request,
) -> Answer<Response> {
    scene(state, caller, id, request).await
}

async fn scene(State(server): State<Arc<Server>>, caller: Caller, id: String, request: Request) -> Answer<Response> {
    let site = blocking(&server, move |server| {
        let job = caller.job(server, &id, Right::Scenes)?;
        let folder = super::files::folder(server, &job)?;
        let name = job.request.name.unwrap_or_else(|| "model".into());
        Ok(server.viewers.open(&job.id, &name, &folder)?)
    })
    .await?;
    let viewer = scene_routes("/view/{id}").fallback(async || Refusal::not_found()).with_state(site);
    match viewer.oneshot(request).await {
        Ok(answer) => Ok(answer.into_response()),
        Err(never) => match never {},
    }
}
