//! The interface for programs and the page's own: routes, and the guard before all of them.
//!
//! The routes and the OpenAPI document come from the same list, so that neither has what the other has not.

pub mod accounts;
mod caller;
mod events;
pub mod files;
mod form;
mod geocells;
pub mod guard;
pub mod jobs;
pub mod metrics;
mod page;
mod session;
mod submit;
mod view;

use std::sync::Arc;

use axum::extract::rejection::{JsonRejection, QueryRejection};
use axum::extract::{DefaultBodyLimit, Query};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse as _, Response};
use axum::routing::get;
use axum::{Json, Router, middleware};
use utoipa::openapi::security::{ApiKey, ApiKeyValue, HttpAuthScheme, HttpBuilder, SecurityScheme};
use utoipa::{IntoResponses, Modify, OpenApi};
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use super::Server;
use super::refusal::Refusal;
pub use caller::{Caller, Peer};

pub type Answer<T> = Result<T, Refusal>;

/// A submission's fields beside its photos, and what frames them, bytes.
const FORM: u64 = 64 << 10;

#[derive(OpenApi)]
#[openapi(
    info(
        title = "Orb",
        description = "One photo becomes a placed, marked, sealed 3D model. Every request but those for `health`, \
                       this document and a session needs an account's token, as `Authorization: Bearer orb_…`, a client \
                       certificate that is bound to one, as `Authorization: Certificate`, or a session's cookie; with the cookie, a request that changes something needs the session's `csrf` \
                       in the header `X-Orb-Csrf`. What is marked above an account's ceiling does not exist for it."
    ),
    modifiers(&Security)
)]
struct Document;

struct Security;

impl Modify for Security {
    fn modify(&self, document: &mut utoipa::openapi::OpenApi) {
        let components = document.components.get_or_insert_default();
        let bearer = HttpBuilder::new().scheme(HttpAuthScheme::Bearer).build();
        components.add_security_scheme("token", SecurityScheme::Http(bearer));
        let cookie = ApiKey::Cookie(ApiKeyValue::new(session::COOKIE));
        components.add_security_scheme("session", SecurityScheme::ApiKey(cookie));
    }
}

/// What every route behind an account may answer instead.
#[derive(IntoResponses)]
#[allow(dead_code, reason = "read by the document alone")]
enum Refused {
    /// No account, or a token that is wrong, expired, disabled or locked
    #[response(status = 401)]
    NotSignedIn(Refusal),
    /// Not with this account's roles or ceiling, or refused by policy
    #[response(status = 403)]
    Forbidden(Refusal),
    /// Not there, or above the account's ceiling
    #[response(status = 404)]
    NotFound(Refusal),
    /// Not in this state
    #[response(status = 409)]
    Conflict(Refusal),
    /// The request did not come in time
    #[response(status = 408)]
    TooSlow(Refusal),
    /// Over a limit
    #[response(status = 413)]
    TooLarge(Refusal),
    /// An address of more than 1,024 bytes
    #[response(status = 414)]
    AddressTooLong(Refusal),
    /// By a name that is not this server's
    #[response(status = 421)]
    NotMyName(Refusal),
    /// Not what is expected
    #[response(status = 422)]
    Unusable(Refusal),
    /// Later
    #[response(status = 503)]
    Busy(Refusal),
}

/// What the guard may answer where no account is asked for.
#[derive(IntoResponses)]
#[allow(dead_code, reason = "read by the document alone")]
enum Guarded {
    /// From another server's page
    #[response(status = 403)]
    Elsewhere(Refusal),
    /// The request did not come in time
    #[response(status = 408)]
    TooSlow(Refusal),
    /// Over a limit
    #[response(status = 413)]
    TooLarge(Refusal),
    /// An address of more than 1,024 bytes
    #[response(status = 414)]
    AddressTooLong(Refusal),
    /// By a name that is not this server's
    #[response(status = 421)]
    NotMyName(Refusal),
}

/// Every route of the interface, with its part of the document.
fn interface() -> OpenApiRouter<Arc<Server>> {
    OpenApiRouter::with_openapi(Document::openapi())
        .routes(routes!(health))
        .routes(routes!(session::begin, session::show, session::end))
        .routes(routes!(jobs::list, submit::submit))
        .routes(routes!(jobs::show, jobs::remove))
        .routes(routes!(jobs::watch))
        .routes(routes!(jobs::cancel))
        .routes(routes!(jobs::verify))
        .routes(routes!(files::list))
        .routes(routes!(files::one))
        .routes(routes!(files::archive))
        .routes(routes!(files::record))
        .routes(routes!(geocells::list))
        .routes(routes!(accounts::list, accounts::add))
        .routes(routes!(accounts::disable))
        .routes(routes!(accounts::enable))
        .routes(routes!(accounts::renew))
        .routes(routes!(accounts::bind))
        .routes(routes!(accounts::unbind))
        .routes(routes!(events::list))
        .routes(routes!(metrics::show))
}

/// The OpenAPI document.
pub fn document() -> utoipa::openapi::OpenApi {
    in_openapis_words(interface().split_for_parts().1)
}

/// The router's `{*name}`, which takes slashes too, is `{name}` in OpenAPI.
fn in_openapis_words(mut document: utoipa::openapi::OpenApi) -> utoipa::openapi::OpenApi {
    let paths = std::mem::take(&mut document.paths.paths);
    document.paths.paths = paths.into_iter().map(|(path, item)| (path.replace("{*", "{"), item)).collect();
    document
}

pub fn router(server: Arc<Server>) -> Router {
    let (interface, document) = interface().split_for_parts();
    // Of plain values: it always serialises.
    let document = axum::body::Bytes::from(in_openapis_words(document).to_json().unwrap_or_default());
    let limit = usize::try_from(server.limits.submission.max(server.limits.upload) + FORM).unwrap_or(usize::MAX);
    interface
        .route("/openapi.json", get(async || ([(header::CONTENT_TYPE, "application/json")], document)))
        .merge(page::routes())
        .merge(view::routes())
        .fallback(async || Refusal::not_found())
        .layer(DefaultBodyLimit::max(limit))
        .layer(middleware::from_fn_with_state(Arc::clone(&server), guard::guard))
        .with_state(server)
}

/// Whether the server answers, and nothing else
#[utoipa::path(get, path = "/health", tag = "server", security(()),
    responses((status = 200, body = String, content_type = "text/plain"), Guarded))]
async fn health() -> Response {
    (StatusCode::OK, "ok\n").into_response()
}

/// Runs what waits for the disk beside the thread that answers.
async fn blocking<T: Send + 'static>(
    server: &Arc<Server>,
    work: impl FnOnce(&Arc<Server>) -> Answer<T> + Send + 'static,
) -> Answer<T> {
    let server = Arc::clone(server);
    let done = tokio::task::spawn_blocking(move || work(&server)).await;
    done.unwrap_or_else(|_| Err(Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, "INTERNAL", "the server stumbled")))
}

fn given<T>(body: Result<Json<T>, JsonRejection>) -> Answer<T> {
    body.map(|Json(value)| value).map_err(|e| Refusal::unusable(e.body_text()))
}

fn asked<T>(query: Result<Query<T>, QueryRejection>) -> Answer<T> {
    query.map(|Query(value)| value).map_err(|e| Refusal::unusable(e.body_text()))
}
