//! Accounts in the database.

use rusqlite::{OptionalExtension as _, Row, params};

use super::{Database, failed};
use crate::audit::Marking;
use crate::serve::account::{Account, LOCKED_FOR, MOST_FAILURES, is_same};
use crate::{Error, Result};

/// Between two notes of when an account was last used, milliseconds.
const NOTED_EVERY: u64 = 60_000;
const COLUMNS: &str =
    "name, roles, ceiling, token_sha256, token_expires, made, disabled, failures, locked_until, last_used";

/// What came of a token.
#[derive(Debug)]
pub enum Checked {
    Good(Box<Account>),
    /// No such account.
    Unknown,
    /// Not its token.
    Wrong,
    /// As that, and now the account is locked.
    NowLocked,
    Locked,
    Disabled,
    Expired,
}

fn account(row: &Row<'_>) -> rusqlite::Result<Account> {
    fn sound<T>(value: Result<T>) -> rusqlite::Result<T> {
        value.map_err(|e| rusqlite::Error::FromSqlConversionFailure(0, rusqlite::types::Type::Text, Box::new(e)))
    }
    Ok(Account {
        name: row.get(0)?,
        roles: sound(row.get::<_, String>(1)?.parse())?,
        ceiling: sound(Marking::parse(&row.get::<_, String>(2)?))?,
        token_sha256: row.get(3)?,
        token_expires: row.get::<_, i64>(4)?.unsigned_abs(),
        made: row.get::<_, i64>(5)?.unsigned_abs(),
        disabled: row.get(6)?,
        failures: row.get(7)?,
        locked_until: row.get::<_, i64>(8)?.unsigned_abs(),
        last_used: row.get::<_, Option<i64>>(9)?.map(i64::unsigned_abs),
    })
}

/// SQLite's integers have a sign; times are far below its limit.
pub(super) fn int(value: u64) -> i64 {
    i64::try_from(value).unwrap_or(i64::MAX)
}

impl Database {
    /// # Errors
    /// Usage, where the name is taken; environment.
    pub fn add_account(&self, a: &Account) -> Result<()> {
        let added = self
            .connection()
            .execute(
                "INSERT INTO account (name, roles, ceiling, token_sha256, token_expires, made) VALUES (?1, ?2, ?3, ?4, ?5, ?6)
                 ON CONFLICT DO NOTHING",
                params![a.name, a.roles.text(), a.ceiling.banner(), a.token_sha256, int(a.token_expires), int(a.made)],
            )
            .map_err(failed)?;
        match added {
            0 => Err(Error::usage("account").expected("a name that is not taken").found(a.name.clone())),
            _ => Ok(()),
        }
    }

    /// # Errors
    /// Environment.
    pub fn account(&self, name: &str) -> Result<Option<Account>> {
        let sql = format!("SELECT {COLUMNS} FROM account WHERE name = ?1");
        let connection = self.connection();
        let mut statement = connection.prepare_cached(&sql).map_err(failed)?;
        statement.query_row([name], account).optional().map_err(failed)
    }

    /// By name.
    ///
    /// # Errors
    /// Environment.
    pub fn accounts(&self) -> Result<Vec<Account>> {
        let connection = self.connection();
        let mut statement =
            connection.prepare(&format!("SELECT {COLUMNS} FROM account ORDER BY name")).map_err(failed)?;
        let rows = statement.query_map([], account).map_err(failed)?;
        rows.collect::<rusqlite::Result<_>>().map_err(failed)
    }

    /// False where there is no such account. Enabling it takes a lock off it too.
    ///
    /// # Errors
    /// Environment.
    pub fn set_disabled(&self, name: &str, disabled: bool) -> Result<bool> {
        let sql = "UPDATE account SET disabled = ?2, failures = 0, locked_until = 0 WHERE name = ?1";
        Ok(self.connection().execute(sql, params![name, disabled]).map_err(failed)? > 0)
    }

    /// False where there is no such account.
    ///
    /// # Errors
    /// Environment.
    pub fn set_token(&self, name: &str, token_sha256: &[u8], expires: u64) -> Result<bool> {
        let sql =
            "UPDATE account SET token_sha256 = ?2, token_expires = ?3, failures = 0, locked_until = 0 WHERE name = ?1";
        Ok(self.connection().execute(sql, params![name, token_sha256, int(expires)]).map_err(failed)? > 0)
    }

    /// Judges a token, counts failures, notes the use.
    ///
    /// # Errors
    /// Environment.
    pub fn check_token(&self, name: &str, secret_sha256: &[u8], now: u64) -> Result<Checked> {
        let Some(account) = self.account(name)? else { return Ok(Checked::Unknown) };
        if account.locked_until > now {
            return Ok(Checked::Locked);
        }
        if !is_same(&account.token_sha256, secret_sha256) {
            let failures = account.failures + 1;
            let locks = failures >= MOST_FAILURES;
            let (kept, until) = if locks { (0, now + LOCKED_FOR) } else { (failures, 0) };
            let sql = "UPDATE account SET failures = ?2, locked_until = ?3 WHERE name = ?1";
            self.connection().execute(sql, params![name, kept, int(until)]).map_err(failed)?;
            return Ok(if locks { Checked::NowLocked } else { Checked::Wrong });
        }
        self.judge(account, now)
    }

    /// An account whose token or session was good: disabled, expired or not.
    ///
    /// # Errors
    /// Environment.
    pub fn judge(&self, account: Account, now: u64) -> Result<Checked> {
        if account.disabled {
            return Ok(Checked::Disabled);
        }
        if account.token_expires <= now {
            return Ok(Checked::Expired);
        }
        let noted = account.last_used.is_some_and(|last| now.saturating_sub(last) < NOTED_EVERY);
        if !noted || account.failures > 0 {
            let sql = "UPDATE account SET failures = 0, last_used = ?2 WHERE name = ?1";
            self.connection().execute(sql, params![account.name, int(now)]).map_err(failed)?;
        }
        Ok(Checked::Good(Box::new(account)))
    }
}
