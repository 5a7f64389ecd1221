//! Which account a client's certificate is bound to, by the SHA-256 of the certificate.

use std::collections::BTreeMap;

use super::Database;
use super::sql::values;
use crate::Result;
use crate::serve::account::{Account, Fingerprint};
use crate::serve::database::sql::unsound;

impl Database {
    /// False where it is bound already.
    ///
    /// # Errors
    /// Environment.
    pub fn bind(&self, certificate: &Fingerprint, account: &str, now: u64) -> Result<bool> {
        let sql = "INSERT INTO certificate (sha256, account, made) VALUES ($1, $2, $3) ON CONFLICT DO NOTHING";
        Ok(self.change(sql, &values![certificate.bytes(), account, now])? > 0)
    }

    /// False where it is not bound to this account.
    ///
    /// # Errors
    /// Environment.
    pub fn unbind(&self, certificate: &Fingerprint, account: &str) -> Result<bool> {
        let sql = "DELETE FROM certificate WHERE sha256 = $1 AND account = $2";
        Ok(self.change(sql, &values![certificate.bytes(), account])? > 0)
    }

    /// The account that a certificate is bound to.
    ///
    /// # Errors
    /// Environment.
    pub fn bound_to(&self, certificate: &Fingerprint) -> Result<Option<Account>> {
        let sql = "SELECT account FROM certificate WHERE sha256 = $1";
        let Some(row) = self.rows(sql, &values![certificate.bytes()])?.into_iter().next() else { return Ok(None) };
        self.account(&row.get::<String>(0)?)
    }

    /// The certificates of every account that has some.
    ///
    /// # Errors
    /// Environment.
    pub fn certificates(&self) -> Result<BTreeMap<String, Vec<Fingerprint>>> {
        let mut all: BTreeMap<String, Vec<Fingerprint>> = BTreeMap::new();
        for row in self.rows("SELECT account, sha256 FROM certificate ORDER BY account, made, sha256", &[])? {
            let bytes: Vec<u8> = row.get(1)?;
            let found = bytes.len();
            let whole = bytes.try_into().map_err(|_| unsound("a certificate's hash", "32 bytes", &found))?;
            all.entry(row.get(0)?).or_default().push(Fingerprint::new(whole));
        }
        Ok(all)
    }
}
