//! Who asks. No route that needs this is reached without it.

use std::sync::Arc;

use axum::extract::FromRequestParts;
use axum::http::header::{AUTHORIZATION, COOKIE};
use axum::http::request::Parts;

use super::guard::changes;
use super::{Answer, blocking, session};
use crate::audit::Marking;
use crate::serve::Server;
use crate::serve::account::{Account, Fingerprint, is_same, read_token};
use crate::serve::database::{Checked, Job};
use crate::serve::place::is_id;
use crate::serve::refusal::Refusal;
use crate::serve::role::{Right, Roles};
use crate::serve::session::Proof;

/// Longest token, and longest name of a session.
const LONGEST: usize = 128;
/// In `Authorization`: by the connection's certificate.
const BY_CERTIFICATE: &[u8] = b"Certificate";
const CSRF: &str = "x-orb-csrf";

/// An account that asks, and the session's secret if it is a session.
#[derive(Clone, Debug)]
pub struct Caller {
    pub name: String,
    pub roles: Roles,
    pub ceiling: Marking,
    pub csrf: Option<String>,
    /// What it was known by.
    pub by: Proof,
}

/// What a connection's handshake verified: the client's certificate, where one was asked for.
#[derive(Clone, Copy, Debug, Default)]
pub struct Peer(pub Option<Fingerprint>);

impl<S: Sync> FromRequestParts<S> for Peer {
    type Rejection = std::convert::Infallible;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Peer, Self::Rejection> {
        Ok(parts.extensions.get().copied().unwrap_or_default())
    }
}

impl FromRequestParts<Arc<Server>> for Caller {
    type Rejection = Refusal;

    async fn from_request_parts(parts: &mut Parts, server: &Arc<Server>) -> Answer<Caller> {
        let Peer(certificate) = parts.extensions.get().copied().unwrap_or_default();
        if let Some(value) = parts.headers.get(AUTHORIZATION) {
            // Said, not taken from the connection unasked: a page of another server's cannot send this header.
            if value.as_bytes() == BY_CERTIFICATE {
                return blocking(server, move |server| by_certificate(server, certificate)).await;
            }
            let token =
                value.to_str().ok().and_then(|v| v.strip_prefix("Bearer ")).ok_or_else(Refusal::unknown)?.to_owned();
            return blocking(server, move |server| by_token(server, &token)).await;
        }
        let mut cookies =
            parts.headers.get_all(COOKIE).iter().filter_map(|v| v.to_str().ok()).flat_map(|v| v.split(';'));
        let name = session::cookie_name(server);
        let id = cookies.find_map(|c| c.trim().strip_prefix(name)?.strip_prefix('='));
        let id = id.filter(|id| id.len() <= LONGEST).ok_or_else(Refusal::unknown)?.to_owned();
        let must_show = changes(&parts.method);
        let shown = parts.headers.get(CSRF).and_then(|v| v.to_str().ok()).map(str::to_owned);
        blocking(server, move |server| {
            let now = server.now();
            let known = server.sessions.find(&id, now).ok_or_else(Refusal::unknown)?;
            if must_show && !shown.is_some_and(|s| known.has_csrf(&s)) {
                server.recorder.refused(&known.account, "CSRF", now);
                return Err(Refusal::forbidden("the header X-Orb-Csrf does not hold the session's secret"));
            }
            let over = || {
                server.sessions.end(&id);
                Refusal::unknown()
            };
            let csrf = Some(known.csrf().to_owned());
            let checked = match &known.by {
                Proof::Token(sha256) => {
                    let account = server.database.account(&known.account)?.ok_or_else(Refusal::unknown)?;
                    if !is_same(&account.token_sha256, sha256) {
                        return Err(over());
                    }
                    server.database.judge(account, now)?
                }
                // By another connection, without it or with another: a cookie that was carried off. The session goes on.
                Proof::Certificate(own) if certificate != Some(*own) => {
                    server.recorder.refused(&known.account, "CERTIFICATE_OTHER", now);
                    return Err(Refusal::unknown());
                }
                Proof::Certificate(own) => match server.database.check_certificate(own, now)? {
                    Some((name, checked)) if name == known.account => checked,
                    _ => return Err(over()),
                },
            };
            settle(server, &known.account, checked, csrf, known.by)
        })
        .await
    }
}

/// Who holds this token.
///
/// # Errors
/// 401, the same whatever is wrong.
pub fn by_token(server: &Arc<Server>, token: &str) -> Answer<Caller> {
    let read = if token.len() <= LONGEST { read_token(token) } else { None };
    let Some((name, sha256)) = read else {
        server.recorder.refused("", "TOKEN_UNREADABLE", server.now());
        return Err(Refusal::unknown());
    };
    let checked = server.database.check_token(name, &sha256, server.now())?;
    settle(server, name, checked, None, Proof::Token(sha256))
}

/// Whose certificate this is.
///
/// # Errors
/// 401, the same whatever is wrong.
pub fn by_certificate(server: &Arc<Server>, certificate: Option<Fingerprint>) -> Answer<Caller> {
    let Some(certificate) = certificate else { return Err(Refusal::unknown()) };
    match server.database.check_certificate(&certificate, server.now())? {
        Some((name, checked)) => settle(server, &name, checked, None, Proof::Certificate(certificate)),
        None => {
            server.recorder.refused("", "CERTIFICATE_UNKNOWN", server.now());
            Err(Refusal::unknown())
        }
    }
}

fn settle(server: &Server, name: &str, checked: Checked, csrf: Option<String>, by: Proof) -> Answer<Caller> {
    let (name, code) = match checked {
        Checked::Good(account) => {
            let Account { name, roles, ceiling, .. } = *account;
            return Ok(Caller { name, roles, ceiling, csrf, by });
        }
        // Names that were guessed are not written down.
        Checked::Unknown => ("", "ACCOUNT_UNKNOWN"),
        Checked::Wrong => (name, "TOKEN_WRONG"),
        Checked::NowLocked => {
            server.sessions.end_all_of(name);
            server.recorder.act("account.lock", &[("account", name)])?;
            (name, "TOKEN_WRONG")
        }
        Checked::Locked => (name, "ACCOUNT_LOCKED"),
        Checked::Disabled => (name, "ACCOUNT_DISABLED"),
        Checked::Expired => (name, "TOKEN_EXPIRED"),
    };
    server.recorder.refused(name, code, server.now());
    Err(Refusal::unknown())
}

impl Caller {
    /// Refuses what the account's roles do not allow.
    ///
    /// # Errors
    /// 403, recorded.
    pub fn need(&self, server: &Server, right: Right) -> Answer<()> {
        if self.roles.allow(right) {
            return Ok(());
        }
        server.recorder.refused(&self.name, "ROLE", server.now());
        Err(Refusal::forbidden(format!("the roles of this account ({}) do not allow it", self.roles.text())))
    }

    /// Whether what is marked so may be shown to it.
    pub fn may_see(&self, server: &Server, marking: &str) -> bool {
        Marking::read(marking).is_ok_and(|m| self.ceiling.covers(&m) && server.ceiling.covers(&m))
    }

    /// A job that this account may know of. Waits for the disk.
    ///
    /// # Errors
    /// 404 also for what is above its ceiling; that is recorded.
    pub fn job(&self, server: &Server, id: &str, right: Right) -> Answer<Job> {
        self.need(server, right)?;
        if !is_id(id) {
            return Err(Refusal::not_found());
        }
        let job = server.database.job(id)?.ok_or_else(Refusal::not_found)?;
        if !self.may_see(server, &job.marking) {
            server.recorder.refused(&self.name, "ABOVE_CEILING", server.now());
            return Err(Refusal::not_found());
        }
        Ok(job)
    }
}
