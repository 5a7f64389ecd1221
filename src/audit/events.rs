//! Events that are records without outputs: failed and refused runs, verifications, keys, imported networks, the end of a
//! ledger (NIST SP 800-53 AU-2, AU-12).

use std::collections::BTreeMap;
use std::path::Path;

use serde::Serialize;

use super::data_folder::DataFolder;
use super::invocation::Invocation;
use super::keys::{self, Named, SigningKey};
use super::ledger::Ledger;
use super::marking::Marking;
use super::record::{self, RecordDraft};
use super::report::Report;
use super::statement::{Model, Outcome, Param, Statement};
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

/// Every kind of event, in the order of their names. All of them are always on. Which key was used stands in each record:
/// the one that signed it.
pub const EVENT_TYPES: [EventType; 33] = [
    event("access.refused", "orb serve refused somebody, so many times in a minute", "attempts are seen"),
    event("account.add", "an account of orb serve was made", "who may do what, and since when"),
    event(
        "account.change",
        "an account was disabled, enabled or given another token",
        "since when an account is no more",
    ),
    event("account.lock", "an account was locked after wrong tokens", "attempts to guess a token are seen"),
    event("bench.make", "orb bench make published", "what results are measured against"),
    event("bench.run", "orb bench run published", "what was measured of which results"),
    event("job.cancel", "an account of orb serve cancelled its job", "why a job has no result"),
    event("job.delete", "an account of orb serve deleted its job and its results", "since when results are gone"),
    event("key.generate", "a key was made: by orb audit keygen, or the user's own", "who can sign, and since when"),
    event("key.revoke", "orb audit key trust revoke", "since when a key counts no more"),
    event(
        "key.trust",
        "a key, an authority or a revocation list was added, also by signing with a key for the first time",
        "whose signatures count",
    ),
    event("ledger.checkpoint", "orb audit ledger checkpoint signed one", "a key was used beside the ledger"),
    event("ledger.close", "orb audit ledger archive", "a ledger that ends on purpose differs from one that was cut"),
    event(
        "marking.refused",
        "a run was refused because of a marking: unknown, or below an input's",
        "attempts to lower a marking are seen",
    ),
    event("model.import", "orb models import took a network in", "which weights came when, by whose word"),
    event("model.remove", "orb models remove", "since when a network is gone"),
    event("record.timestamp", "orb audit timestamp import put a time stamp beside a record", "what time is proven"),
    event("report.publish", "orb audit report --sign published", "who vouches for which verdict"),
    event("run.failed", "a run ended without a result", "failures are events too"),
    event("run.refused", "policy refused a run: a key, an algorithm, a pin", "attempts are seen"),
    event("scene.block", "orb train --block trained one block of a scene, or its coarse scene", MADE),
    event("scene.export", "orb export published", MADE),
    event("scene.generate", "orb geo published", MADE),
    event("scene.reconstruct", "orb reconstruct published", MADE),
    event("scene.render", "orb render published", MADE),
    event("scene.train", "orb train published", MADE),
    event(
        "serve.revocation",
        "orb serve read changed revocation lists, or did not take them",
        "since when which certificates are no longer good",
    ),
    event("serve.start", "orb serve began to listen", "since when others could reach what is here"),
    event("serve.stop", "orb serve ended", "until when they could"),
    event("session.begin", "an account signed in", "who was there"),
    event("session.end", "an account signed out", "until when"),
    event("store.join", "orb batch joined what its shards wrote into one store", MADE),
    event(
        "verify.run",
        "orb audit verify, report, export, ledger verify or ledger reconcile gave a verdict",
        "that checks were made, and what they gave",
    ),
];

const MADE: &str = "what was made of what, by whom";

const fn event(name: &'static str, when: &'static str, why: &'static str) -> EventType {
    EventType { name, when, why }
}

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

/// Something that happened without outputs.
#[derive(Clone, Debug)]
pub struct Happened<'a> {
    /// One of [`EVENT_TYPES`].
    pub kind: &'static str,
    /// The verb: `orb audit keygen`.
    pub command: &'a str,
    pub by: Invocation,
    pub outcome: Outcome,
    pub code: Option<&'a str>,
    /// What it happened to: fingerprints, digests, verdicts. No path: folders tell about people, not about data.
    pub params: BTreeMap<String, Param>,
    pub models: Vec<Model>,
    /// Looking at a result leaves no traces in the home folder of a user who has none yet.
    pub begins_a_ledger: bool,
}

impl<'a> Happened<'a> {
    pub fn new(kind: &'static str, command: &'a str, by: Invocation) -> Happened<'a> {
        Happened {
            kind,
            command,
            by,
            outcome: Outcome::Success,
            code: None,
            params: BTreeMap::new(),
            models: Vec::new(),
            begins_a_ledger: true,
        }
    }

    pub fn failed(self, code: Option<&'a str>) -> Happened<'a> {
        Happened { outcome: Outcome::Failure, code, ..self }
    }

    pub fn to(mut self, name: &str, value: impl Into<String>) -> Happened<'a> {
        self.params.insert(name.into(), Param::Text(record::printable(&value.into())));
        self
    }
}

/// Appends an event to this user's ledger, signed by this user's own key. A user who has neither gets them, unless the event
/// does not begin a ledger.
///
/// # Errors
/// As [`Ledger::append`].
pub fn log(data: &DataFolder, happened: &Happened<'_>) -> Result<()> {
    if !happened.begins_a_ledger && !keys::has_own(data) {
        return Ok(());
    }
    append(data, &own_key(data, happened.command, &happened.by)?, happened)
}

/// The user's own key. That it is made is an event.
fn own_key(data: &DataFolder, command: &str, by: &Invocation) -> Result<SigningKey> {
    let (key, created) = keys::own(data)?;
    if created {
        append(data, &key, &about_key("key.generate", command, by.clone(), &key))?;
    }
    Ok(key)
}

/// The verdict of a verification, as [`log`]; that it cannot be recorded changes nothing about it.
pub fn log_verdict(data: &DataFolder, command: &str, by: Invocation, report: &Report) {
    let found = report.findings.iter().find(|f| f.verdict == report.verdict).map(|f| f.code);
    let mut happened = Happened { begins_a_ledger: false, ..Happened::new("verify.run", command, by) };
    if report.exit_code != 0 {
        happened = happened.failed(found);
    }
    // Words of records that no trusted key signed are in no report.
    for (name, value) in [("ledger_id", &report.ledger_id), ("trail_hash", &report.trail_hash)] {
        if let Some(value) = value {
            happened = happened.to(name, value);
        }
    }
    if let Err(e) = log(data, &happened) {
        eprintln!("orb: warning: the verification was not recorded: {e}");
    }
}

/// The key for a run, as [`keys::for_marking`]; a key that is made or trusted by this is an event.
///
/// # Errors
/// As [`keys::for_marking`] and [`Ledger::append`].
pub fn key_for_run(
    data: &DataFolder,
    command: &str,
    by: &Invocation,
    marking: &Marking,
    named: Option<Named<'_>>,
) -> Result<keys::KeyForRun> {
    let run = keys::for_marking(data, marking, named)?;
    if run.created {
        append(data, &run.key, &about_key("key.generate", command, by.clone(), &run.key))?;
        return Ok(run);
    }
    // Who signs with a named key has events too, and their key is their own.
    let own = own_key(data, command, by)?;
    if run.newly_trusted {
        append(data, &own, &about_key("key.trust", command, by.clone(), &run.key))?;
    }
    Ok(run)
}

/// An event that a key is the subject of, or both of a hybrid signer.
pub fn about_key<'a>(kind: &'static str, command: &'a str, by: Invocation, key: &SigningKey) -> Happened<'a> {
    let happened = Happened::new(kind, command, by).to("key_fingerprint", key.public().fingerprint());
    match key.partner() {
        None => happened,
        Some(other) => happened.to("second_key_fingerprint", other.public().fingerprint()),
    }
}

fn append(data: &DataFolder, key: &SigningKey, happened: &Happened<'_>) -> Result<()> {
    let Happened { kind, command, outcome, code, .. } = *happened;
    let mut random = [0; 10];
    getrandom::fill(&mut random).map_err(|e| Error::environment("random numbers").found(e.to_string()))?;
    let draft = RecordDraft {
        params: happened.params.clone(),
        models: happened.models.clone(),
        ..RecordDraft::event(kind, command, happened.by.clone(), time::now()?, random, Marking::UNCLASSIFIED.into())
    };
    Ledger::open(data)?
        .append(key, |next| record::seal(&draft, Vec::new(), outcome, code, next, key), |_, _| Ok(()))
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
        let about = if p.event.kind.starts_with("scene.") { String::new() } else { about(&p.params, &p.models) };
        out.push_str(&format!("{:>6}  {}  {:<18} {outcome}{code}{about}\n", p.chain.seq, p.time.utc, p.event.kind));
    }
    Ok(out)
}

/// What an event happened to, in a few words.
fn about(params: &BTreeMap<String, Param>, models: &[Model]) -> String {
    let text = |value: &Param| match value {
        Param::Text(text) => text.clone(),
        Param::Int(n) => n.to_string(),
        Param::Bool(b) => b.to_string(),
    };
    let of_params = params.iter().map(|(name, value)| format!(" {name}={:.16}", text(value)));
    let of_models = models.iter().map(|m| format!(" {}={:.16}", m.id, m.weights_sha256.as_deref().unwrap_or_default()));
    of_params.chain(of_models).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::record::tests::draft;

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
    fn events_join_the_chain() {
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path().join("data"));
        // Who only looks leaves no trace.
        let looked =
            Happened { begins_a_ledger: false, ..Happened::new("verify.run", "orb audit verify", draft().invocation) };
        log(&data, &looked).unwrap();
        assert!(!data.path().exists());
        log(&data, &Happened::new("run.failed", "orb geo", draft().invocation).failed(Some("CANCELLED"))).unwrap();
        log(&data, &looked.to("trail_hash", "ab\n")).unwrap();
        let ledger = Ledger::open(&data).unwrap();
        let text = list(ledger.path()).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines.len() == 3 && lines[0].contains("key.generate       success key_fingerprint="), "{text}");
        assert!(lines[1].ends_with("run.failed         failure CANCELLED"), "{text}");
        assert!(lines[2].ends_with("verify.run         success trail_hash=ab\u{fffd}"), "{text}");
        let made = &ledger.read_chain().unwrap()[0].predicate;
        assert_eq!(made.params["key_fingerprint"], Param::Text(made.actor.key_fingerprint.clone()));
    }

    /// Who signs with a named key only has events too, and the first use of that key is one.
    #[test]
    fn a_user_of_a_named_key() {
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path().join("data"));
        let path = dir.path().join("unit.pem");
        shared_key().save(&path, None).unwrap();
        let named = || Some(Named::from(&path));
        key_for_run(&data, "orb geo", &draft().invocation, &Marking::SECRET, named()).unwrap();
        key_for_run(&data, "orb geo", &draft().invocation, &Marking::SECRET, named()).unwrap();
        let chain = Ledger::open(&data).unwrap().read_chain().unwrap();
        let kinds: Vec<&str> = chain.iter().map(|s| s.predicate.event.kind.as_str()).collect();
        assert_eq!(kinds, ["key.generate", "key.trust"]);
        assert_eq!(
            chain[1].predicate.params["key_fingerprint"],
            Param::Text(shared_key().public().fingerprint().into())
        );
    }

    /// Every kind that the source names is listed, and every kind that is listed is used.
    #[test]
    fn the_list_is_whole() {
        assert!(EVENT_TYPES.is_sorted_by_key(|e| e.name));
        let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let mut text = String::new();
        for entry in crate::audit::disk::walk(&src).unwrap() {
            if entry.is_file && entry.name.ends_with(".rs") && entry.name != "audit/events.rs" {
                text.push_str(&std::fs::read_to_string(entry.path).unwrap());
            }
        }
        for before in ["event_type: \"", "Happened::new(\""] {
            for (at, _) in text.match_indices(before) {
                let name = text[at + before.len()..].split('"').next().unwrap();
                assert!(EVENT_TYPES.iter().any(|e| e.name == name), "{name} is not listed");
            }
        }
        // These are made here.
        let here = ["key.generate", "marking.refused", "run.failed", "run.refused", "verify.run"];
        for EventType { name, .. } in EVENT_TYPES {
            assert!(here.contains(&name) || text.contains(&format!("\"{name}\"")), "{name} never happens");
        }
    }
}
