//! What is done to accounts, by the command line or by an administrator: recorded first, then done.

use zeroize::Zeroizing;

use super::account::{Account, Fingerprint, check_name, new_token};
use super::database::Database;
use super::recorder::Recorder;
use super::role::Roles;
use crate::audit::Marking;
use crate::{Error, Result};

/// Milliseconds of a day.
const DAY: u64 = 24 * 3600 * 1000;
/// Days that a token is good for.
pub const TOKEN_DAYS: u32 = 365;

/// Who does it: an account, or nobody but the user of this machine.
pub struct By<'a> {
    pub database: &'a Database,
    pub recorder: &'a Recorder,
    pub actor: Option<&'a str>,
    pub now: u64,
}

impl By<'_> {
    fn record(&self, kind: &'static str, account: &str, about: &[(&str, &str)]) -> Result<()> {
        let actor = self.actor.map(|name| ("by", name));
        let all: Vec<(&str, &str)> =
            [("account", account)].into_iter().chain(actor).chain(about.iter().copied()).collect();
        self.recorder.act(kind, &all)
    }

    /// A new account; its token, which nobody can show again.
    ///
    /// # Errors
    /// Usage: a name that is none, or is taken. As [`Recorder::act`].
    pub fn add(&self, name: &str, roles: Roles, ceiling: Marking, days: u32) -> Result<Zeroizing<String>> {
        check_name(name)?;
        if self.database.account(name)?.is_some() {
            return Err(Error::usage("account").expected("a name that is not taken").found(name.to_owned()));
        }
        let (token, token_sha256) = new_token(name)?;
        self.record("account.add", name, &[("roles", &roles.text()), ("ceiling", &ceiling.banner())])?;
        self.database.add_account(&Account {
            name: name.to_owned(),
            roles,
            ceiling,
            token_sha256,
            token_expires: self.now + u64::from(days) * DAY,
            made: self.now,
            disabled: false,
            failures: 0,
            locked_until: 0,
            last_used: None,
        })?;
        Ok(token)
    }

    /// Another token; the one before is no longer good.
    ///
    /// # Errors
    /// Usage, without such an account. As [`Recorder::act`].
    pub fn renew(&self, name: &str, days: u32) -> Result<Zeroizing<String>> {
        self.there(name)?;
        let (token, token_sha256) = new_token(name)?;
        self.record("account.change", name, &[("change", "token")])?;
        self.database.set_token(name, &token_sha256, self.now + u64::from(days) * DAY)?;
        Ok(token)
    }

    /// Or enabled again, and unlocked.
    ///
    /// # Errors
    /// Usage, without such an account. As [`Recorder::act`].
    pub fn disable(&self, name: &str, disabled: bool) -> Result<()> {
        self.there(name)?;
        self.record("account.change", name, &[("change", if disabled { "disabled" } else { "enabled" })])?;
        self.database.set_disabled(name, disabled).map(drop)
    }

    /// Whoever comes with this certificate is this account from now on.
    ///
    /// # Errors
    /// Usage, without such an account, or where the certificate is bound already. As [`Recorder::act`].
    pub fn bind(&self, name: &str, certificate: &Fingerprint) -> Result<()> {
        self.there(name)?;
        let taken = || {
            Error::usage("certificate")
                .expected("one that is bound to nobody")
                .found(certificate.to_string())
                .advice("`orb serve account list --json` says whose it is; unbind it there first.")
        };
        if self.database.bound_to(certificate)?.is_some() {
            return Err(taken());
        }
        let sha256 = certificate.to_string();
        self.record("account.change", name, &[("change", "bound"), ("certificate_sha256", &sha256)])?;
        match self.database.bind(certificate, name, self.now)? {
            true => Ok(()),
            false => Err(taken()),
        }
    }

    /// It is nobody's any more.
    ///
    /// # Errors
    /// Usage, where it is not bound to this account. As [`Recorder::act`].
    pub fn unbind(&self, name: &str, certificate: &Fingerprint) -> Result<()> {
        self.there(name)?;
        if self.database.bound_to(certificate)?.is_none_or(|a| a.name != name) {
            return Err(Error::usage("certificate")
                .expected(format!("one that is bound to {name}"))
                .found(certificate.to_string()));
        }
        let sha256 = certificate.to_string();
        self.record("account.change", name, &[("change", "unbound"), ("certificate_sha256", &sha256)])?;
        self.database.unbind(certificate, name).map(drop)
    }

    fn there(&self, name: &str) -> Result<()> {
        match self.database.account(name)? {
            Some(_) => Ok(()),
            None => Err(Error::usage("account").expected("the name of an account").found(format!("{name:?}"))),
        }
    }
}
