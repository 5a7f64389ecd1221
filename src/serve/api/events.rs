//! The ledger's events, for auditors.

use std::sync::Arc;

use axum::Json;
use axum::extract::rejection::QueryRejection;
use axum::extract::{Query, State};
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};

use super::{Answer, Caller, Refused, asked, blocking};
use crate::audit::Ledger;
use crate::audit::statement::{Outcome, Param};
use crate::serve::refusal::Refusal;
use crate::serve::role::Right;
use crate::serve::{Server, lock};

const MOST: u32 = 1000;
/// Largest whole number that every reader of JSON has (RFC 8259 §6).
const LAST: u64 = (1 << 53) - 1;

#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub struct Wanted {
    /// Only records with this number and later ones.
    #[param(minimum = 0, maximum = 9007199254740991_i64)]
    from: Option<u64>,
    #[param(minimum = 1, maximum = 1000, default = 1000)]
    limit: Option<u32>,
}

/// A record of the ledger, in short.
#[derive(Serialize, ToSchema)]
pub struct Event {
    number: u64,
    utc: String,
    kind: String,
    success: bool,
    code: Option<String>,
    /// What made it: `orb geo`, `orb serve`.
    command: String,
    operator: Option<String>,
    /// Of events without outputs: what they happened to.
    #[schema(value_type = Object)]
    about: std::collections::BTreeMap<String, Param>,
}

#[derive(Serialize, ToSchema)]
pub struct Events {
    events: Vec<Event>,
}

/// Events of the ledger, oldest first; the chain is checked on the way, the signatures are not
#[utoipa::path(get, path = "/api/v1/events", tag = "records", params(Wanted), security(("token" = []), ("session" = [])),
    responses((status = 200, body = Events), Refused))]
pub async fn list(
    State(server): State<Arc<Server>>,
    caller: Caller,
    query: Result<Query<Wanted>, QueryRejection>,
) -> Answer<Json<Events>> {
    caller.need(&server, Right::Events)?;
    let wanted = asked(query)?;
    let limit = wanted.limit.unwrap_or(MOST);
    if !(1..=MOST).contains(&limit) {
        return Err(Refusal::unusable(format!("limit: expected 1 to {MOST}, found {limit}")));
    }
    if let Some(from) = wanted.from.filter(|from| *from > LAST) {
        return Err(Refusal::unusable(format!("from: expected at most {LAST}, found {from}")));
    }
    let busy = |_| Refusal::busy("the ledger is being read");
    let place = Arc::clone(&server.checks).try_acquire_owned().map_err(busy)?;
    blocking(&server, move |server| {
        let _place = place;
        let ledger = Ledger::open(server.recorder.data())?;
        // Records of scenes are as their scenes: nothing of those that this account may not see.
        let may_see = |marking: &str| caller.may_see(server, marking);
        let shown = lock(&server.trail).read(&ledger, wanted.from.unwrap_or(0), limit as usize, may_see)?;
        let event = |s: crate::audit::statement::Statement| {
            let p = s.predicate;
            let about = if p.event.kind.starts_with("scene.") { Default::default() } else { p.params };
            Event {
                number: p.chain.seq,
                utc: p.time.utc,
                success: p.event.outcome == Outcome::Success,
                code: p.event.error_code,
                kind: p.event.kind,
                command: p.source.command,
                operator: p.actor.display,
                about,
            }
        };
        Ok(Json(Events { events: shown.into_iter().map(event).collect() }))
    })
    .await
}
