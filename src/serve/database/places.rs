//! Where models stand that jobs have published.

use super::sql::{places, values};
use super::{Database, jobs};
use crate::Result;

/// A place on the ellipsoid and where the model's +Y looks, degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stands {
    pub latitude: f64,
    pub longitude: f64,
    pub heading: f64,
}

/// A job that published a placed model.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    pub number: i64,
    pub id: String,
    pub name: Option<String>,
    pub account: String,
    pub marking: String,
    pub stands: Stands,
}

impl Database {
    /// # Errors
    /// Environment.
    pub fn set_place(&self, id: &str, stands: Stands) -> Result<()> {
        let sql = "UPDATE job SET latitude = $2, longitude = $3, heading = $4 WHERE id = $1";
        self.change(sql, &values![id, stands.latitude, stands.longitude, stands.heading]).map(drop)
    }

    /// Newest first, those marked with one of `markings` only, and with lower numbers than `before`.
    ///
    /// # Errors
    /// Environment.
    pub fn placed(&self, markings: &[String], before: Option<i64>, at_most: u32) -> Result<Vec<Placed>> {
        if markings.is_empty() {
            return Ok(Vec::new());
        }
        let sql = format!(
            "SELECT number, id, request, account, marking, latitude, longitude, heading FROM job
             WHERE latitude IS NOT NULL AND state = 'done' AND marking IN ({}) AND number < $1 ORDER BY number DESC LIMIT $2",
            places(3, markings.len())
        );
        let mut values = values![before.unwrap_or(i64::MAX), at_most].to_vec();
        values.extend(markings.iter().cloned().map(Into::into));
        let placed = |row: super::Row| {
            Ok(Placed {
                number: row.get(0)?,
                id: row.get(1)?,
                name: jobs::request(&row.get::<String>(2)?)?.name,
                account: row.get(3)?,
                marking: row.get(4)?,
                stands: Stands { latitude: row.get(5)?, longitude: row.get(6)?, heading: row.get(7)? },
            })
        };
        self.rows(&sql, &values)?.into_iter().map(placed).collect()
    }
}
