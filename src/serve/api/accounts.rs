//! Accounts, for administrators.

use std::sync::Arc;

use axum::Json;
use axum::extract::rejection::JsonRejection;
use axum::extract::{Path, State};
use axum::http::StatusCode;
use axum::response::{IntoResponse as _, Response};
use clap::ValueEnum as _;
use serde::{Deserialize, Deserializer, Serialize};
use utoipa::ToSchema;
use utoipa::openapi::RefOr;
use utoipa::openapi::schema::{ArrayBuilder, ObjectBuilder, OneOfBuilder, Schema, Type};

use super::{Answer, Caller, Refused, blocking, given};
use crate::audit::Marking;
use crate::serve::Server;
use crate::serve::account::{Fingerprint, Told};
use crate::serve::administration::{By, TOKEN_DAYS};
use crate::serve::refusal::Refusal;
use crate::serve::role::{Right, Role};

#[derive(Serialize, ToSchema)]
pub struct Accounts {
    accounts: Vec<Told>,
}

/// An account that is to be.
#[derive(Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct NewAccount {
    #[schema(pattern = "^[a-z][a-z0-9-]{0,31}$")]
    name: String,
    /// Admin and auditor stand alone.
    #[schema(schema_with = roles_schema)]
    roles: Vec<Role>,
    /// Highest marking that it takes part in, the server's at most.
    #[schema(example = "UNCLASSIFIED", pattern = "^[A-Z][A-Z0-9 ,/-]{0,199}$")]
    ceiling: String,
    /// That its token is good for.
    #[serde(default, deserialize_with = "whole")]
    #[schema(minimum = 1, maximum = 3650)]
    days: Option<u32>,
}

/// JSON Schema knows no difference between 30 and 30.0.
fn whole<'de, D: Deserializer<'de>>(from: D) -> Result<Option<u32>, D::Error> {
    let Some(number) = Option::<f64>::deserialize(from)? else { return Ok(None) };
    match number.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&number) {
        true => Ok(Some(number as u32)),
        false => Err(serde::de::Error::custom(format!("days: expected a whole number, found {number}"))),
    }
}

/// As [`crate::serve::role::Roles`] takes them: those that stand alone, or any of the others.
fn roles_schema() -> RefOr<Schema> {
    let of = |roles: Vec<Role>, most: Option<usize>| {
        let one = ObjectBuilder::new().schema_type(Type::String).enum_values(Some(roles.into_iter().map(Role::name)));
        ArrayBuilder::new().items(one).min_items(Some(1)).max_items(most)
    };
    let (alone, others) = Role::value_variants().iter().copied().partition(|r: &Role| r.stands_alone());
    OneOfBuilder::new().item(of(alone, Some(1))).item(of(others, None)).into()
}

/// Shown this once.
#[derive(Serialize, ToSchema)]
pub struct Token {
    account: String,
    token: String,
}

/// Does something in the caller's name. Waits for the disk.
async fn by<T: Send + 'static>(
    server: Arc<Server>,
    caller: Caller,
    act: impl FnOnce(&Server, &By<'_>, &Caller) -> Answer<T> + Send + 'static,
) -> Answer<T> {
    blocking(&server, move |server| {
        caller.need(server, Right::Accounts)?;
        let (database, recorder) = (&server.database, &server.recorder);
        act(server, &By { database, recorder, actor: Some(&caller.name), now: server.now() }, &caller)
    })
    .await
}

/// All accounts, with when they were last used
#[utoipa::path(get, path = "/api/v1/accounts", tag = "accounts", security(("token" = []), ("session" = [])),
    responses((status = 200, body = Accounts), Refused))]
pub async fn list(State(server): State<Arc<Server>>, caller: Caller) -> Answer<Json<Accounts>> {
    by(server, caller, |server, by, _| {
        let certificates = server.database.certificates()?;
        let of = |name: &str| certificates.get(name).map_or(&[][..], Vec::as_slice);
        let accounts = server.database.accounts()?.iter().map(|a| a.told(of(&a.name), by.now)).collect();
        Ok(Json(Accounts { accounts }))
    })
    .await
}

fn days(given: Option<u32>) -> Answer<u32> {
    let days = given.unwrap_or(TOKEN_DAYS);
    match (1..=3650).contains(&days) {
        true => Ok(days),
        false => Err(Refusal::unusable(format!("days: expected 1 to 3650, found {days}"))),
    }
}

/// Make an account; its token is in the answer and nowhere else
#[utoipa::path(post, path = "/api/v1/accounts", tag = "accounts", request_body = NewAccount,
    security(("token" = []), ("session" = [])), responses((status = 201, body = Token), Refused))]
pub async fn add(
    State(server): State<Arc<Server>>,
    caller: Caller,
    body: Result<Json<NewAccount>, JsonRejection>,
) -> Answer<Response> {
    // Who may not make accounts is not told what one is made of.
    caller.need(&server, Right::Accounts)?;
    let new = given(body)?;
    let days = days(new.days)?;
    by(server, caller, move |server, by, _| {
        let ceiling = Marking::parse(&new.ceiling)?;
        if !server.ceiling.covers(&ceiling) {
            let words = format!("ceiling: expected at most the server's, {}", server.ceiling);
            return Err(Refusal::new(StatusCode::FORBIDDEN, "ABOVE_SERVER_CEILING", words));
        }
        if server.database.account(&new.name)?.is_some() {
            return Err(Refusal::conflict("name: an account has it"));
        }
        let token = by.add(&new.name, new.roles.try_into()?, ceiling, days)?;
        Ok((StatusCode::CREATED, Json(Token { account: new.name, token: token.to_string() })).into_response())
    })
    .await
}

fn there(server: &Server, name: &str) -> Answer<()> {
    server.database.account(name)?.map(drop).ok_or_else(Refusal::not_found)
}

/// Disable an account: its token and its sessions are no longer good
#[utoipa::path(post, path = "/api/v1/accounts/{name}/disable", tag = "accounts", params(("name" = String, Path)),
    security(("token" = []), ("session" = [])), responses((status = 204), Refused))]
pub async fn disable(
    State(server): State<Arc<Server>>,
    caller: Caller,
    Path(name): Path<String>,
) -> Answer<StatusCode> {
    by(server, caller, move |server, by, caller| {
        there(server, &name)?;
        if name == caller.name {
            return Err(Refusal::conflict("nobody disables the account that he uses"));
        }
        by.disable(&name, true)?;
        server.sessions.end_all_of(&name);
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}

/// Enable an account again, and unlock it
#[utoipa::path(post, path = "/api/v1/accounts/{name}/enable", tag = "accounts", params(("name" = String, Path)),
    security(("token" = []), ("session" = [])), responses((status = 204), Refused))]
pub async fn enable(State(server): State<Arc<Server>>, caller: Caller, Path(name): Path<String>) -> Answer<StatusCode> {
    by(server, caller, move |server, by, _| {
        there(server, &name)?;
        by.disable(&name, false)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}

/// Another token for an account; the one before is no longer good
#[utoipa::path(post, path = "/api/v1/accounts/{name}/token", tag = "accounts", params(("name" = String, Path)),
    security(("token" = []), ("session" = [])), responses((status = 201, body = Token), Refused))]
pub async fn renew(State(server): State<Arc<Server>>, caller: Caller, Path(name): Path<String>) -> Answer<Response> {
    by(server, caller, move |server, by, _| {
        there(server, &name)?;
        let token = by.renew(&name, TOKEN_DAYS)?;
        server.sessions.end_all_of(&name);
        Ok((StatusCode::CREATED, Json(Token { account: name, token: token.to_string() })).into_response())
    })
    .await
}

/// A client certificate that is to be an account's.
#[derive(Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct NewCertificate {
    /// SHA-256 of the certificate (DER), as `openssl x509 -noout -fingerprint -sha256` prints it.
    #[schema(pattern = "^([0-9A-Fa-f]{2}:?){31}[0-9A-Fa-f]{2}$")]
    sha256: String,
}

/// Bind a client certificate to an account: who comes with it is this account
#[utoipa::path(post, path = "/api/v1/accounts/{name}/certificates", tag = "accounts", params(("name" = String, Path)),
    request_body = NewCertificate, security(("token" = []), ("session" = [])), responses((status = 204), Refused))]
pub async fn bind(
    State(server): State<Arc<Server>>,
    caller: Caller,
    Path(name): Path<String>,
    body: Result<Json<NewCertificate>, JsonRejection>,
) -> Answer<StatusCode> {
    caller.need(&server, Right::Accounts)?;
    let certificate: Fingerprint = given(body)?.sha256.parse()?;
    by(server, caller, move |server, by, _| {
        there(server, &name)?;
        if server.database.bound_to(&certificate)?.is_some() {
            return Err(Refusal::conflict("sha256: an account has this certificate"));
        }
        by.bind(&name, &certificate)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}

/// Take a client certificate from an account: its sessions are over
#[utoipa::path(delete, path = "/api/v1/accounts/{name}/certificates/{sha256}", tag = "accounts",
    params(("name" = String, Path), ("sha256" = String, Path)), security(("token" = []), ("session" = [])),
    responses((status = 204), Refused))]
pub async fn unbind(
    State(server): State<Arc<Server>>,
    caller: Caller,
    Path((name, sha256)): Path<(String, String)>,
) -> Answer<StatusCode> {
    by(server, caller, move |server, by, _| {
        // What is no fingerprint is bound to nobody.
        let certificate: Fingerprint = sha256.parse().map_err(|_| Refusal::not_found())?;
        if server.database.bound_to(&certificate)?.is_none_or(|account| account.name != name) {
            return Err(Refusal::not_found());
        }
        by.unbind(&name, &certificate)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}
