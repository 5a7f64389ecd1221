//! What stands where: published models by the geocells of a CDB store.

use std::collections::BTreeMap;
use std::sync::Arc;

use axum::Json;
use axum::extract::rejection::QueryRejection;
use axum::extract::{Query, State};
use orb_formats::cdb::geocell::Geocell;
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};

use super::{Answer, Caller, Refused, asked, blocking};
use crate::serve::Server;
use crate::serve::database::Placed;
use crate::serve::refusal::Refusal;
use crate::serve::role::Right;

const MOST: u32 = 1000;

#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub struct Wanted {
    /// Only jobs with lower numbers: the next page.
    before: Option<i64>,
    #[param(minimum = 1, maximum = 1000, default = 1000)]
    limit: Option<u32>,
}

/// A published model and its place.
#[derive(Serialize, ToSchema)]
pub struct Standing {
    /// Of the job.
    id: String,
    number: i64,
    name: Option<String>,
    account: String,
    marking: String,
    /// WGS 84, degrees.
    latitude: f64,
    longitude: f64,
    /// Where the camera looked: degrees clockwise from true north.
    heading: f64,
}

/// A cell of one degree of latitude, as CDB stores have them.
#[derive(Serialize, ToSchema)]
#[schema(as = Geocell)]
pub struct Cell {
    /// `N34W119`: its south-western corner.
    name: String,
    south: i32,
    west: i32,
    /// Degrees of longitude: 1, and more towards the poles.
    width: i32,
    /// Newest first.
    models: Vec<Standing>,
}

/// Geocells in which something stands.
#[derive(Serialize, ToSchema)]
pub struct Geocells {
    /// By their corners, from the south-west.
    geocells: Vec<Cell>,
    /// For the next page; none after the last.
    before: Option<i64>,
}

/// What was published where, by geocell: the newest jobs that this account may look at
#[utoipa::path(get, path = "/api/v1/geocells", tag = "results", params(Wanted), security(("token" = []), ("session" = [])),
    responses((status = 200, body = Geocells), Refused))]
pub async fn list(
    State(server): State<Arc<Server>>,
    caller: Caller,
    query: Result<Query<Wanted>, QueryRejection>,
) -> Answer<Json<Geocells>> {
    caller.need(&server, Right::Scenes)?;
    let wanted = asked(query)?;
    let limit = wanted.limit.unwrap_or(MOST);
    if !(1..=MOST).contains(&limit) {
        return Err(Refusal::unusable(format!("limit: expected 1 to {MOST}, found {limit}")));
    }
    blocking(&server, move |server| {
        let mut markings = server.database.markings()?;
        markings.retain(|m| caller.may_see(server, m));
        let placed = server.database.placed(&markings, wanted.before, limit)?;
        let before = placed.last().map(|p| p.number).filter(|_| placed.len() == limit as usize);
        Ok(Json(Geocells { geocells: by_cell(placed), before }))
    })
    .await
}

fn by_cell(placed: Vec<Placed>) -> Vec<Cell> {
    let mut cells: BTreeMap<Geocell, Vec<Standing>> = BTreeMap::new();
    for p in placed {
        // What was published has a place on the Earth.
        let Ok(cell) = Geocell::containing(p.stands.latitude, p.stands.longitude) else { continue };
        cells.entry(cell).or_default().push(Standing {
            id: p.id,
            number: p.number,
            name: p.name,
            account: p.account,
            marking: p.marking,
            latitude: p.stands.latitude,
            longitude: p.stands.longitude,
            heading: p.stands.heading,
        });
    }
    let cell = |(c, models): (Geocell, Vec<Standing>)| Cell {
        name: format!("{}{}", c.latitude_name(), c.longitude_name()),
        south: c.south,
        west: c.west,
        width: c.width(),
        models,
    };
    cells.into_iter().map(cell).collect()
}
