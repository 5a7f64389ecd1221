//! What is said of a trusted key or authority: from when to when, up to which marking, and since when no more.

use serde::{Deserialize, Serialize};

use crate::audit::marking::Marking;
use crate::audit::time;
use crate::{Error, Result};

pub const SCHEMA: &str = "orb.trust/v1";

/// `FINGERPRINT.json`, beside the key or the certificate. Without one, everything is allowed.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    pub schema: String,
    /// Whose key it is, in the words of who trusts it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Records dated before are refused. `YYYY-MM-DDTHH:MM:SS.mmmZ`, as all times here.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub not_before: Option<String>,
    /// Records dated after are refused.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub not_after: Option<String>,
    /// The highest marking that the key may sign.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_marking: Option<String>,
    /// Of an authority: the extended key usage that a signer's certificate must have where it has any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub eku: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub revoked: Option<Revocation>,
    /// Fingerprint of the key that has to sign too: of a hybrid signer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub with: Option<String>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Revocation {
    pub from: String,
    pub reason: Reason,
}

/// Why a key is no longer trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Reason {
    /// Others may have it, so its own word about when it signed is worth nothing.
    Compromise,
    /// Another key took its place.
    Superseded,
    /// Its holder signs no more.
    Ceased,
}

/// Why a signature that is good does not count, or what to know about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Objection {
    pub code: &'static str,
    pub expected: String,
    pub actual: String,
}

impl Objection {
    pub fn new(code: &'static str, expected: impl Into<String>, actual: impl Into<String>) -> Objection {
        Objection { code, expected: expected.into(), actual: actual.into() }
    }
}

/// When something was signed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signed {
    /// By the record's own word, milliseconds since 1970.
    pub stated_ms: u64,
    /// Not after this, by the word of a trusted time stamp.
    pub proven_ms: Option<u64>,
}

impl Signed {
    /// What a revocation from `from_ms` on means for it. One for compromise leaves only signatures that a time stamp
    /// proves to be older: whoever has the key can date as they like (RFC 5280 §5.3.1, keyCompromise).
    pub fn against(self, from_ms: u64, compromised: bool, revoked: &'static str, later: &'static str) -> Objection {
        let from = format!("signed before {}", time::format_utc(from_ms));
        let proven = self.proven_ms.is_some_and(|t| t < from_ms);
        let stated = time::format_utc(self.stated_ms);
        if self.stated_ms < from_ms && (proven || !compromised) {
            Objection::new(later, from, stated)
        } else if self.stated_ms < from_ms {
            Objection::new(revoked, format!("{from}, by a time stamp"), format!("{stated} by its own word"))
        } else {
            Objection::new(revoked, from, stated)
        }
    }
}

impl Entry {
    /// # Errors
    /// [`crate::Kind::Usage`] for a time or a marking that is none.
    pub fn check(&self, subject: &str) -> Result<()> {
        let times = [&self.not_before, &self.not_after, &self.revoked.as_ref().map(|r| r.from.clone())];
        for text in times.into_iter().flatten() {
            if time::parse_utc(text).is_none() {
                return Err(Error::usage(subject)
                    .expected("a time like 2026-11-21T08:00:00.000Z")
                    .found(format!("{text:?}")));
            }
        }
        if self.schema != SCHEMA {
            return Err(Error::usage(subject).expected(SCHEMA).found(format!("schema {:?}", self.schema)));
        }
        if self.with.as_ref().is_some_and(|f| f.len() != 64 || !f.bytes().all(|b| b.is_ascii_hexdigit())) {
            return Err(Error::usage(subject).expected("a key's fingerprint").found(format!("{:?}", self.with)));
        }
        self.max_marking.as_deref().map_or(Ok(()), |banner| Marking::parse(banner).map(drop))
    }

    /// What stands against a signature made then, on something marked so.
    pub fn judge(&self, signed: Signed, marking: Option<&Marking>) -> Vec<Objection> {
        let mut out = Vec::new();
        let at = time::format_utc(signed.stated_ms);
        let bound = |text: &Option<String>| text.as_deref().and_then(time::parse_utc);
        if bound(&self.not_before).is_some_and(|t| signed.stated_ms < t) {
            out.push(Objection::new("KEY_EXPIRED", format!("from {}", self.not_before.as_deref().unwrap_or("")), &at));
        }
        if bound(&self.not_after).is_some_and(|t| signed.stated_ms > t) {
            out.push(Objection::new("KEY_EXPIRED", format!("until {}", self.not_after.as_deref().unwrap_or("")), &at));
        }
        if let Some(Revocation { from, reason }) = &self.revoked
            && let Some(from_ms) = time::parse_utc(from)
        {
            let compromised = *reason == Reason::Compromise;
            out.push(signed.against(from_ms, compromised, "KEY_REVOKED", "KEY_REVOKED_LATER"));
        }
        let ceiling = self.max_marking.as_deref().and_then(|banner| Marking::parse(banner).ok());
        if let (Some(ceiling), Some(marking)) = (ceiling, marking)
            && !ceiling.covers(marking)
        {
            out.push(Objection::new("KEY_SCOPE", format!("at most {}", ceiling.banner()), marking.banner()));
        }
        out
    }
}
