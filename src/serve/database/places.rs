//! Where models stand that jobs have published.

use rusqlite::{params, params_from_iter, types::Value};

use super::{Database, failed};
use crate::Result;

/// Columns of version 2; of jobs that are done already, from what their runs said.
pub(super) const TABLES: &str = "
ALTER TABLE job ADD COLUMN latitude REAL;
ALTER TABLE job ADD COLUMN longitude REAL;
ALTER TABLE job ADD COLUMN heading REAL;
CREATE INDEX job_place ON job (number, marking) WHERE latitude IS NOT NULL;
UPDATE job SET latitude = json_extract(result, '$.georeference.latitude'),
    longitude = json_extract(result, '$.georeference.longitude'), heading = json_extract(result, '$.georeference.heading_deg')
WHERE state = 'done' AND json_type(result, '$.georeference.latitude') IS NOT NULL;
";

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
        let sql = "UPDATE job SET latitude = ?2, longitude = ?3, heading = ?4 WHERE id = ?1";
        let values = params![id, stands.latitude, stands.longitude, stands.heading];
        self.connection().execute(sql, values).map(drop).map_err(failed)
    }

    /// Newest first, those marked with one of `markings` only, and with lower numbers than `before`.
    ///
    /// # Errors
    /// Environment.
    pub fn placed(&self, markings: &[String], before: Option<i64>, at_most: u32) -> Result<Vec<Placed>> {
        let places = vec!["?"; markings.len()].join(",");
        let sql = format!(
            "SELECT number, id, json_extract(request, '$.name'), account, marking, latitude, longitude, heading FROM job
             WHERE latitude IS NOT NULL AND state = 'done' AND marking IN ({places}) AND number < ? ORDER BY number DESC LIMIT ?"
        );
        let values = markings.iter().cloned().map(Value::Text);
        let values = values.chain([Value::Integer(before.unwrap_or(i64::MAX)), Value::Integer(at_most.into())]);
        let connection = self.connection();
        let mut statement = connection.prepare_cached(&sql).map_err(failed)?;
        let rows = statement
            .query_map(params_from_iter(values), |row| {
                Ok(Placed {
                    number: row.get(0)?,
                    id: row.get(1)?,
                    name: row.get(2)?,
                    account: row.get(3)?,
                    marking: row.get(4)?,
                    stands: Stands { latitude: row.get(5)?, longitude: row.get(6)?, heading: row.get(7)? },
                })
            })
            .map_err(failed)?;
        rows.collect::<rusqlite::Result<_>>().map_err(failed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_of_an_older_database_are_taken_over() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("old.sqlite");
        let old = rusqlite::Connection::open(&path).unwrap();
        old.execute_batch(&format!("{} PRAGMA user_version = 1;", super::super::TABLES)).unwrap();
        for (id, state, result) in [
            ("a", "done", r#"{"georeference":{"latitude":34,"longitude":-118.5,"heading_deg":90.5}}"#),
            ("b", "done", "null"),
            ("c", "queued", "null"),
        ] {
            let sql = "INSERT INTO job (id, account, state, marking, request, submitted, bytes, result)
                       VALUES (?1, 'jane', ?2, 'CUI', '{\"name\":\"van\"}', 0, 0, ?3)";
            old.execute(sql, [id, state, result]).unwrap();
        }
        drop(old);
        let new = Database::open(&path).unwrap();
        let of = |markings: &[&str], before| {
            let markings: Vec<String> = markings.iter().map(|m| (*m).to_owned()).collect();
            new.placed(&markings, before, 10).unwrap()
        };
        let [placed] = &of(&["CUI"], None)[..] else { panic!("{:?}", of(&["CUI"], None)) };
        assert_eq!((placed.id.as_str(), placed.name.as_deref()), ("a", Some("van")));
        assert_eq!(placed.stands, Stands { latitude: 34.0, longitude: -118.5, heading: 90.5 });
        assert_eq!(of(&["SECRET"], None), []);
        assert_eq!(of(&["CUI"], Some(1)), []);
        drop(new);
        assert!(Database::open(&path).is_ok(), "and once only");
    }
}
