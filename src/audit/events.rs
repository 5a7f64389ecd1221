//! Events that are records without outputs: failed and refused runs, verifications, new keys, the end of a ledger
//! (NIST SP 800-53 AU-2, AU-12).

use std::path::Path;

use serde::Serialize;

use super::data_folder::DataFolder;
use super::keys::{KeySource, SigningKey};
use super::ledger::Ledger;
use super::marking::Marking;
use super::record::{self, RecordDraft};
use super::statement::{Outcome, Statement};
use super::time;
use crate::{Error, Kind, Result};

/// A kind of event that Orb can record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct EventType {
    pub name: &'static str,
    pub when: &'static str,
    /// Why it is worth a record.
    pub why: &'static str,
}

/// Every kind of event, in the order of their names. All of them are always on.
pub const EVENT_TYPES: [EventType; 10] = [
    EventType {
        name: "key.generate",
        when: "orb audit keygen made a key and this user has a ledger",
        why: "who can sign, and since when",
    },
    EventType {
        name: "key.revoke",
        when: "orb audit key trust revoke and this user has a ledger",
        why: "since when a key counts no more",
    },
    EventType {
        name: "key.trust",
        when: "orb audit key trust add and this user has a ledger",
        why: "whose signatures count",
    },
    EventType {
        name: "ledger.close",
        when: "orb audit ledger archive",
        why: "a ledger that ends on purpose differs from one that was cut",
    },
    EventType {
        name: "marking.refused",
        when: "a run was refused because of a marking: unknown, or below an input's",
        why: "attempts to lower a marking are seen",
    },
    EventType { name: "run.failed", when: "a run ended without a result", why: "failures are events too" },
    EventType {
        name: "run.refused",
        when: "policy refused a run: a key, an algorithm, a pin",
        why: "attempts are seen",
    },
    EventType { name: "scene.generate", when: "orb geo published", why: "what was made of what, by whom" },
    EventType { name: "scene.render", when: "orb render published", why: "what was made of what, by whom" },
    EventType {
        name: "verify.run",
        when: "orb audit verify gave a verdict",
        why: "that checks were made, and what they gave",
    },
];

/// The kind of event that a failed run is, and its code: the error's own, else its kind's. `None` for wrong arguments:
/// no run began.
pub fn of_failure(error: &Error) -> Option<(&'static str, String)> {
    let own = error.found.split(':').next().unwrap_or_default();
    let is_code = own.contains('_') && own.bytes().all(|b| b.is_ascii_uppercase() || b == b'_' || b.is_ascii_digit());
    let kind = match error.kind {
        Kind::Usage => return None,
        Kind::Policy if is_code && own.starts_with("MARKING_") => "marking.refused",
        Kind::Policy => "run.refused",
        _ => "run.failed",
    };
    let code = if is_code { own.to_owned() } else { format!("{:?}", error.kind).to_uppercase() };
    Some((kind, code))
}

/// Appends an event to this user's ledger, signed by this user's key; does nothing for a user who has none yet, so
/// that looking at a result leaves no traces in a home folder.
///
/// # Errors
/// As [`Ledger::append`].
pub fn log(data: &DataFolder, kind: &str, command: &str, outcome: Outcome, code: Option<&str>) -> Result<()> {
    let path = data.path().join("keys/orb-signing.pem");
    if !path.is_file() {
        return Ok(());
    }
    let key = SigningKey::load(&path, KeySource::UserData)?;
    let mut random = [0; 10];
    getrandom::fill(&mut random).map_err(|e| Error::environment("random numbers").found(e.to_string()))?;
    let draft = RecordDraft::event(kind, command, time::now()?, random, Marking::UNCLASSIFIED.into());
    Ledger::open(data)?
        .append(&key, |next| record::seal(&draft, Vec::new(), outcome, code, next, &key), |_, _| Ok(()))
        .map(drop)
}

/// The records of a ledger, one line each: number, time, event, outcome.
///
/// # Errors
/// As [`Ledger::read_chain`].
pub fn list(ledger: &Path) -> Result<String> {
    let mut out = String::new();
    for Statement { predicate: p, .. } in Ledger::at(ledger.to_owned()).read_chain()? {
        let outcome = match p.event.outcome {
            Outcome::Success => "success",
            Outcome::Failure => "failure",
        };
        let code = p.event.error_code.map(|c| format!(" {c}")).unwrap_or_default();
        out.push_str(&format!("{:>6}  {}  {:<18} {outcome}{code}\n", p.chain.seq, p.time.utc, p.event.kind));
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::keys;

    #[test]
    fn failures_and_their_codes() {
        let of = |e: Error| of_failure(&e);
        assert_eq!(of(Error::usage("--origin").found("latitude 91")), None);
        let policy = |found: &str| Error::policy("classification").found(found);
        assert_eq!(of(policy("MARKING_DOWNGRADE: CUI")), Some(("marking.refused", "MARKING_DOWNGRADE".into())));
        assert_eq!(of(policy("KEY_REQUIRED: none")), Some(("run.refused", "KEY_REQUIRED".into())));
        assert_eq!(of(Error::environment("x").found("No space left")), Some(("run.failed", "ENVIRONMENT".into())));
        assert_eq!(of(Error::cancelled()), Some(("run.failed", "CANCELLED".into())));
    }

    #[test]
    fn events_join_the_chain_of_a_user_who_has_one() {
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path().join("data"));
        let event = || log(&data, "run.failed", "orb geo", Outcome::Failure, Some("CANCELLED"));
        event().unwrap();
        assert!(!data.path().exists());
        keys::for_marking(&data, &Marking::UNCLASSIFIED, None).unwrap();
        event().unwrap();
        event().unwrap();
        let text = list(Ledger::open(&data).unwrap().path()).unwrap();
        assert_eq!(text.lines().filter(|l| l.ends_with("run.failed         failure CANCELLED")).count(), 2, "{text}");
        assert!(EVENT_TYPES.is_sorted_by_key(|e| e.name));
    }
}
