//! What SQLite and PostgreSQL have in common: one text of SQL for both, its parameters `$1`, `$2`, …, values in and out.
//!
//! Tables, and what takes a row for one server alone, differ: those stand with the database that they are for.

use crate::{Error, Result};

/// The name of it all in errors.
pub const SUBJECT: &str = "the database of jobs and accounts";

/// A value of a column or of a parameter. What is absent has a type in PostgreSQL too.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Int(i64),
    Real(f64),
    Text(String),
    Blob(Vec<u8>),
    NoInt,
    NoText,
}

/// What a statement is, and so what may be done when the connection breaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Changes nothing: it may be asked again.
    Read,
    /// Changes something: whether it did is not known when the connection breaks, so it is not said again.
    Change,
    /// As that, and no other one of these at the same time: it counts before it changes.
    ChangeAlone,
}

/// A database that speaks SQL.
pub trait Sql: Send + Sync {
    /// The rows that a statement gives.
    ///
    /// # Errors
    /// Environment.
    fn rows(&self, way: Way, sql: &str, values: &[Value]) -> Result<Vec<Row>>;

    /// How many rows a statement changed.
    ///
    /// # Errors
    /// Environment.
    fn change(&self, way: Way, sql: &str, values: &[Value]) -> Result<u64>;

    /// After a `SELECT` of one row that is going to be changed: no other server gets that row meanwhile, and none waits.
    fn for_one(&self) -> &'static str;

    /// From now on this is the only server of a folder, also after a broken connection.
    ///
    /// # Errors
    /// Environment, where another one is.
    fn hold(&self) -> Result<()>;
}

/// The columns of one row, in the order of the `SELECT`.
#[derive(Clone, Debug)]
pub struct Row(pub Vec<Value>);

/// A value as the type that is wanted; `None` for one of another type.
pub trait FromValue: Sized {
    const NAME: &'static str;
    fn from_value(value: &Value) -> Option<Self>;
}

impl Row {
    /// # Errors
    /// Environment: the column is of another type, or does not fit.
    pub fn get<T: FromValue>(&self, column: usize) -> Result<T> {
        let found = self.0.get(column);
        found.and_then(T::from_value).ok_or_else(|| unsound(&format!("column {column} of a row"), T::NAME, &found))
    }
}

/// What stands in a table and cannot have been written by Orb.
pub fn unsound(what: &str, expected: &str, found: &dyn std::fmt::Debug) -> Error {
    Error::environment(SUBJECT)
        .expected(format!("{expected} as {what}"))
        .found(format!("{found:?}"))
        .advice("Something else than Orb changed its tables.")
}

impl FromValue for i64 {
    const NAME: &'static str = "a whole number";
    fn from_value(value: &Value) -> Option<i64> {
        if let Value::Int(v) = value { Some(*v) } else { None }
    }
}

impl FromValue for u64 {
    const NAME: &'static str = "a number from 0";
    fn from_value(value: &Value) -> Option<u64> {
        i64::from_value(value)?.try_into().ok()
    }
}

impl FromValue for u32 {
    const NAME: &'static str = "a number from 0 to 2^32 - 1";
    fn from_value(value: &Value) -> Option<u32> {
        i64::from_value(value)?.try_into().ok()
    }
}

impl FromValue for i32 {
    const NAME: &'static str = "a number of 32 bits";
    fn from_value(value: &Value) -> Option<i32> {
        i64::from_value(value)?.try_into().ok()
    }
}

impl FromValue for bool {
    const NAME: &'static str = "0 or 1";
    fn from_value(value: &Value) -> Option<bool> {
        match i64::from_value(value)? {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }
}

impl FromValue for f64 {
    const NAME: &'static str = "a number";
    fn from_value(value: &Value) -> Option<f64> {
        if let Value::Real(v) = value { Some(*v) } else { None }
    }
}

impl FromValue for String {
    const NAME: &'static str = "a text";
    fn from_value(value: &Value) -> Option<String> {
        if let Value::Text(v) = value { Some(v.clone()) } else { None }
    }
}

impl FromValue for Vec<u8> {
    const NAME: &'static str = "bytes";
    fn from_value(value: &Value) -> Option<Vec<u8>> {
        if let Value::Blob(v) = value { Some(v.clone()) } else { None }
    }
}

impl<T: FromValue> FromValue for Option<T> {
    const NAME: &'static str = T::NAME;
    fn from_value(value: &Value) -> Option<Option<T>> {
        match value {
            Value::NoInt | Value::NoText => Some(None),
            present => T::from_value(present).map(Some),
        }
    }
}

impl From<i64> for Value {
    fn from(v: i64) -> Value {
        Value::Int(v)
    }
}

/// Columns have a sign; times and bytes are far below its limit.
impl From<u64> for Value {
    fn from(v: u64) -> Value {
        Value::Int(i64::try_from(v).unwrap_or(i64::MAX))
    }
}

impl From<u32> for Value {
    fn from(v: u32) -> Value {
        Value::Int(v.into())
    }
}

impl From<bool> for Value {
    fn from(v: bool) -> Value {
        Value::Int(v.into())
    }
}

impl From<f64> for Value {
    fn from(v: f64) -> Value {
        Value::Real(v)
    }
}

impl From<&str> for Value {
    fn from(v: &str) -> Value {
        Value::Text(v.to_owned())
    }
}

impl From<String> for Value {
    fn from(v: String) -> Value {
        Value::Text(v)
    }
}

impl From<&[u8]> for Value {
    fn from(v: &[u8]) -> Value {
        Value::Blob(v.to_vec())
    }
}

impl From<Option<i32>> for Value {
    fn from(v: Option<i32>) -> Value {
        v.map_or(Value::NoInt, |v| Value::Int(v.into()))
    }
}

impl From<Option<String>> for Value {
    fn from(v: Option<String>) -> Value {
        v.map_or(Value::NoText, Value::Text)
    }
}

/// Parameters of a statement: `values![name, now]` are its `$1` and `$2`.
macro_rules! values {
    ($($value:expr),* $(,)?) => { [$($crate::serve::database::sql::Value::from($value)),*] };
}
pub(super) use values;

/// `$3,$4,$5`: places of `count` parameters from `first` on.
pub fn places(first: usize, count: usize) -> String {
    (first..first + count).map(|i| format!("${i}")).collect::<Vec<_>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_of_the_type_that_is_asked_for() {
        let row = Row(vec![Value::Int(-1), Value::NoText, Value::Text("x".into()), Value::Int(1)]);
        assert_eq!((row.get::<i64>(0).unwrap(), row.get::<bool>(3).unwrap()), (-1, true));
        assert_eq!(row.get::<Option<i64>>(1).unwrap(), None);
        assert_eq!(row.get::<Option<String>>(2).unwrap().as_deref(), Some("x"));
        assert!(row.get::<u64>(0).is_err() && row.get::<bool>(0).is_err() && row.get::<i64>(2).is_err());
        assert!(row.get::<i64>(9).is_err() && row.get::<String>(1).is_err());
        assert_eq!(places(3, 3), "$3,$4,$5");
        assert_eq!(places(1, 0), "");
        let [a, b] = values!["x", u64::MAX];
        assert_eq!((a, b), (Value::Text("x".into()), Value::Int(i64::MAX)));
    }
}
