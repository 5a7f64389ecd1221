//! Accounts in the database.

use super::Database;
use super::sql::{Row, Way, unsound, values};
use crate::audit::Marking;
use crate::serve::account::{Account, Fingerprint, LOCKED_FOR, MOST_FAILURES, is_same};
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

fn account(row: &Row) -> Result<Account> {
    let (roles, ceiling): (String, String) = (row.get(1)?, row.get(2)?);
    Ok(Account {
        name: row.get(0)?,
        roles: roles.parse().map_err(|_| unsound("an account's roles", "names of roles", &roles))?,
        ceiling: Marking::parse(&ceiling).map_err(|_| unsound("an account's ceiling", "a marking", &ceiling))?,
        token_sha256: row.get(3)?,
        token_expires: row.get(4)?,
        made: row.get(5)?,
        disabled: row.get(6)?,
        failures: row.get(7)?,
        locked_until: row.get(8)?,
        last_used: row.get(9)?,
    })
}

impl Database {
    /// # Errors
    /// Usage, where the name is taken; environment.
    pub fn add_account(&self, a: &Account) -> Result<()> {
        let sql = "INSERT INTO account (name, roles, ceiling, token_sha256, token_expires, made)
                   VALUES ($1, $2, $3, $4, $5, $6) ON CONFLICT DO NOTHING";
        let (roles, ceiling, token) = (a.roles.text(), a.ceiling.banner(), a.token_sha256.as_slice());
        match self.change(sql, &values![a.name.as_str(), roles, ceiling, token, a.token_expires, a.made])? {
            0 => Err(Error::usage("account").expected("a name that is not taken").found(a.name.clone())),
            _ => Ok(()),
        }
    }

    /// # Errors
    /// Environment.
    pub fn account(&self, name: &str) -> Result<Option<Account>> {
        let sql = format!("SELECT {COLUMNS} FROM account WHERE name = $1");
        self.rows(&sql, &values![name])?.first().map(account).transpose()
    }

    /// By name.
    ///
    /// # Errors
    /// Environment.
    pub fn accounts(&self) -> Result<Vec<Account>> {
        self.rows(&format!("SELECT {COLUMNS} FROM account ORDER BY name"), &[])?.iter().map(account).collect()
    }

    /// False where there is no such account. Enabling it takes a lock off it too.
    ///
    /// # Errors
    /// Environment.
    pub fn set_disabled(&self, name: &str, disabled: bool) -> Result<bool> {
        let sql = "UPDATE account SET disabled = $2, failures = 0, locked_until = 0 WHERE name = $1";
        Ok(self.change(sql, &values![name, disabled])? > 0)
    }

    /// False where there is no such account.
    ///
    /// # Errors
    /// Environment.
    pub fn set_token(&self, name: &str, token_sha256: &[u8], expires: u64) -> Result<bool> {
        let sql =
            "UPDATE account SET token_sha256 = $2, token_expires = $3, failures = 0, locked_until = 0 WHERE name = $1";
        Ok(self.change(sql, &values![name, token_sha256, expires])? > 0)
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
            return self.count_failure(name, now);
        }
        self.judge(account, now)
    }

    /// Judges who came by a certificate, and notes the use. `None` for one that is bound to nobody.
    ///
    /// # Errors
    /// Environment.
    pub fn check_certificate(&self, certificate: &Fingerprint, now: u64) -> Result<Option<(String, Checked)>> {
        let Some(account) = self.bound_to(certificate)? else { return Ok(None) };
        let name = account.name.clone();
        // Its token may have expired: the certificate has a time of its own. A lock holds for both.
        let checked = match () {
            () if account.locked_until > now => Checked::Locked,
            () if account.disabled => Checked::Disabled,
            () => self.note_use(account, now)?,
        };
        Ok(Some((name, checked)))
    }

    /// One wrong token more: in one statement, so that servers that share accounts count together.
    fn count_failure(&self, name: &str, now: u64) -> Result<Checked> {
        let sql = "UPDATE account SET failures = CASE WHEN failures + 1 >= $2 THEN 0 ELSE failures + 1 END,
                   locked_until = CASE WHEN failures + 1 >= $2 THEN $3 ELSE 0 END
                   WHERE name = $1 AND locked_until <= $4 RETURNING locked_until";
        let values = values![name, MOST_FAILURES, now + LOCKED_FOR, now];
        match self.sql.rows(Way::Change, sql, &values)?.first() {
            // Another request locked it meanwhile.
            None => Ok(Checked::Locked),
            Some(row) if row.get::<u64>(0)? > now => Ok(Checked::NowLocked),
            Some(_) => Ok(Checked::Wrong),
        }
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
        self.note_use(account, now)
    }

    fn note_use(&self, account: Account, now: u64) -> Result<Checked> {
        let noted = account.last_used.is_some_and(|last| now.saturating_sub(last) < NOTED_EVERY);
        if !noted || account.failures > 0 {
            let sql = "UPDATE account SET failures = 0, last_used = $2 WHERE name = $1";
            self.change(sql, &values![account.name.as_str(), now])?;
        }
        Ok(Checked::Good(Box::new(account)))
    }
}
