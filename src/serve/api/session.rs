//! Signing in and out: a browser's session in place of the token.

use std::sync::Arc;

use axum::Json;
use axum::extract::State;
use axum::extract::rejection::JsonRejection;
use axum::http::header::SET_COOKIE;
use axum::http::{HeaderMap, StatusCode};
use axum::response::{IntoResponse as _, Response};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::caller::{Peer, by_certificate, by_token};
use super::{Answer, Caller, Guarded, Refused, blocking, given};
use crate::serve::Server;
use crate::serve::refusal::Refusal;
use crate::serve::role::Role;
use crate::serve::session::LONGEST;

pub const COOKIE: &str = "orb_session";
/// Browsers take a cookie of this name from this server alone, under TLS, for all of it.
const ENCRYPTED_COOKIE: &str = "__Host-orb_session";

pub fn cookie_name(server: &Server) -> &'static str {
    if server.encrypted { ENCRYPTED_COOKIE } else { COOKIE }
}

fn cookie(server: &Server, value: &str, seconds: u64) -> String {
    let secure = if server.encrypted { "; Secure" } else { "" };
    format!("{}={value}; Path=/; HttpOnly; SameSite=Strict; Max-Age={seconds}{secure}", cookie_name(server))
}

/// By a token, or by the certificate that the connection came with.
#[derive(Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct SignIn {
    /// As `orb serve account add` printed it. None: by the certificate.
    #[serde(default)]
    token: Option<String>,
}

/// Who is signed in.
#[derive(Serialize, ToSchema)]
pub struct Session {
    account: String,
    roles: Vec<Role>,
    /// Highest marking that is taken in from it and shown to it.
    ceiling: String,
    /// For the header `X-Orb-Csrf` of requests that change something; none without a session.
    csrf: Option<String>,
}

impl Session {
    fn of(caller: Caller) -> Session {
        let Caller { name, roles, ceiling, csrf, .. } = caller;
        Session { account: name, roles: roles.iter().collect(), ceiling: ceiling.banner(), csrf }
    }
}

/// Sign in: a session in a cookie
#[utoipa::path(post, path = "/api/v1/session", tag = "session", security(()), request_body = SignIn, responses(
    (status = 200, body = Session), (status = 401, body = Refusal), (status = 422, body = Refusal), Guarded
))]
pub async fn begin(
    State(server): State<Arc<Server>>,
    peer: Peer,
    body: Result<Json<SignIn>, JsonRejection>,
) -> Answer<Response> {
    let SignIn { token } = given(body)?;
    let (cookie, session) = blocking(&server, move |server| {
        let mut caller = match token {
            Some(token) => by_token(server, &token)?,
            None => by_certificate(server, peer.0)?,
        };
        server.recorder.act("session.begin", &[("account", &caller.name)])?;
        let begun = server.sessions.begin(&caller.name, caller.by.clone(), server.now())?;
        caller.csrf = Some(begun.csrf);
        Ok((cookie(server, &begun.id, LONGEST / 1000), Session::of(caller)))
    })
    .await?;
    Ok(([(SET_COOKIE, cookie)], Json(session)).into_response())
}

/// Who is signed in
#[utoipa::path(get, path = "/api/v1/session", tag = "session", security(("token" = []), ("session" = [])),
    responses((status = 200, body = Session), Refused))]
pub async fn show(caller: Caller) -> Json<Session> {
    Json(Session::of(caller))
}

/// Sign out
#[utoipa::path(delete, path = "/api/v1/session", tag = "session", security(("token" = []), ("session" = [])),
    responses((status = 204), Refused))]
pub async fn end(State(server): State<Arc<Server>>, caller: Caller, headers: HeaderMap) -> Answer<Response> {
    let name = cookie_name(&server);
    let cookies = headers.get_all("cookie").iter().filter_map(|v| v.to_str().ok()).flat_map(|v| v.split(';'));
    for id in cookies.filter_map(|c| c.trim().strip_prefix(name)?.strip_prefix('=')) {
        server.sessions.end(id);
    }
    let gone = cookie(&server, "", 0);
    blocking(&server, move |server| Ok(server.recorder.act("session.end", &[("account", &caller.name)])?)).await?;
    Ok((StatusCode::NO_CONTENT, [(SET_COOKIE, gone)]).into_response())
}
