//! The checks of one record, wherever it stands: beside its outputs or in a ledger.

use super::dsse::Envelope;
use super::keys::{Algorithm, PublicKey};
use super::marking::{Ism, Marking};
use super::record;
use super::report::{Finding, Severity, Verdict};
use super::statement::{GENESIS, Statement};
use super::time::{self, SyncStatus};
use super::trust::{Signed, TrustStore};

/// How far a record's time may lie ahead of this machine's clock, milliseconds.
const FUTURE_SKEW_MS: u64 = 5 * 60 * 1000;

/// What a verifier asks for beyond a record that is whole.
#[derive(Clone, Copy, Debug, Default)]
pub struct Policy<'a> {
    /// Refuse a record whose clock was not known to agree with UTC.
    pub require_time_sync: bool,
    /// SHA-256 of the only weights that may have been used.
    pub models: Option<&'a [String]>,
    /// No verdict while an input was not compared.
    pub require_inputs: bool,
    /// In place of [`super::ledger_check::TIME_GRACE_MS`].
    pub time_grace_ms: Option<u64>,
}

/// A record against a policy: `TIME_UNSYNCED` as an error, `MODEL_NOT_ALLOWED`.
pub(super) fn check_policy(statement: &Statement, policy: Policy<'_>, found: &mut Vec<Finding>) {
    let p = &statement.predicate;
    if policy.require_time_sync && p.time.sync_status != SyncStatus::Synchronised {
        let mut finding = Finding::new("TIME_UNSYNCED", "time.sync_status").expected("a synchronised clock");
        (finding.severity, finding.verdict) = (Severity::Error, Verdict::Refused);
        found.push(finding);
    }
    let Some(allowed) = policy.models else { return };
    for model in &p.models {
        if let Some(sha256) = model.weights_sha256.as_ref().filter(|s| !allowed.contains(s)) {
            found.push(
                Finding::new("MODEL_NOT_ALLOWED", format!("models.{}", model.id))
                    .expected("weights of the list")
                    .actual(sha256),
            );
        }
    }
}

/// Who signed, and how.
#[derive(Clone, Copy, Debug)]
pub(super) struct Signer<'a> {
    pub key: &'a PublicKey,
    pub algorithm: Algorithm,
}

/// The keys that verified, in the order of their signatures; none unless every signature is good.
///
/// `subject` names the record in findings.
pub(super) fn check_signatures<'a>(
    envelope: &Envelope,
    trust: &'a TrustStore,
    subject: &str,
    found: &mut Vec<Finding>,
) -> Vec<Signer<'a>> {
    let message = envelope.pae();
    let mut signers = Vec::new();
    let mut all_good = true;
    for signature in &envelope.signatures {
        let Some(key) = trust.get(&signature.keyid) else {
            let code = if trust.is_empty() { "TRUST_STORE_EMPTY" } else { "KEY_UNTRUSTED" };
            found.push(
                Finding::new(code, subject)
                    .expected("a signature by a trusted key")
                    .actual(record::printable(&signature.keyid)),
            );
            all_good = false;
            continue;
        };
        match key.verify(&message, &signature.sig) {
            Ok(Some(algorithm)) => signers.push(Signer { key, algorithm }),
            Ok(None) => {
                found.push(match key.refused_algorithm(&message, &signature.sig) {
                    Some(refused) => Finding::new("ALG_REFUSED", subject)
                        .expected(key.algorithms().iter().map(|a| a.name()).collect::<Vec<_>>().join(" or "))
                        .actual(refused),
                    None => {
                        Finding::new("SIG_INVALID", subject).expected(format!("a signature by {}", key.fingerprint()))
                    }
                });
                all_good = false;
            }
            Err(disagreement) => {
                found.push(
                    Finding::new("SIG_INVALID", subject)
                        .expected("two implementations that agree")
                        .actual(disagreement),
                );
                all_good = false;
            }
        }
    }
    for wanted in signers.iter().filter_map(|s| trust.partner_of(s.key.fingerprint())) {
        if envelope.signatures.iter().all(|s| s.keyid != wanted) {
            found.push(Finding::new("SIGNATURE_MISSING", subject).expected(format!("a signature by {wanted} too")));
            all_good = false;
        }
    }
    if all_good { signers } else { Vec::new() }
}

/// The signer that the record itself names, else the first.
pub(super) fn own_signer<'a>(signers: &[Signer<'a>], statement: &Statement) -> Option<Signer<'a>> {
    let named = &statement.predicate.actor.key_fingerprint;
    signers.iter().find(|s| s.key.fingerprint() == named).or(signers.first()).copied()
}

/// The record's fields, strictly read; its trail hash is what it should be.
pub(super) fn read_statement(envelope: &Envelope, subject: &str, found: &mut Vec<Finding>) -> Option<Statement> {
    match Statement::parse_and_hash(&envelope.payload) {
        Ok((statement, canonical, trail_hash)) => {
            if !canonical {
                found.push(Finding::new("NOT_CANONICAL", subject).expected("the one spelling of this record"));
            }
            let stated = statement.predicate.trail_hash.as_deref().unwrap_or_default();
            if stated != trail_hash {
                found.push(Finding::new("TRAIL_HASH_MISMATCH", subject).expected(trail_hash).actual(stated));
            }
            Some(statement)
        }
        Err(fault) => {
            found.push(Finding::new(fault.code(), subject).expected("a record of version 1").actual(fault.detail()));
            None
        }
    }
}

/// What the trust store has against a signature that is good; true when it may count.
pub(super) fn check_standing(
    trust: &TrustStore,
    signer: Signer<'_>,
    signed: Signed,
    marking: Option<&Marking>,
    subject: &str,
    found: &mut Vec<Finding>,
) -> bool {
    let objections = trust.judge(signer.key.fingerprint(), signed, marking);
    let stands = objections.iter().all(|o| o.code.ends_with("_LATER"));
    found.extend(objections.into_iter().map(|o| Finding::new(o.code, subject).expected(o.expected).actual(o.actual)));
    stands
}

/// What a record says about itself: its signer, its place in the chain, its time, its marking.
pub(super) fn check_fields(
    statement: &Statement,
    trust: &TrustStore,
    signers: &[Signer<'_>],
    proven_ms: Option<u64>,
    now_ms: u64,
    found: &mut Vec<Finding>,
) {
    let p = &statement.predicate;
    let signer = own_signer(signers, statement);
    let acceptable = |a: &&Algorithm| signer.is_none_or(|s| s.algorithm == **a);
    let names: Vec<&str> = Algorithm::ALL.iter().filter(acceptable).map(|a| a.name()).collect();
    if !names.contains(&p.actor.algorithm.as_str()) {
        found.push(
            Finding::new("ALG_REFUSED", "actor.algorithm").expected(names.join(" or ")).actual(&p.actor.algorithm),
        );
    }
    let signed = Signed { stated_ms: time::parse_utc(&p.time.utc).unwrap_or_default(), proven_ms };
    for who in signers {
        check_standing(trust, *who, signed, statement.marking().as_ref(), "signing key", found);
    }
    if let Some(Signer { key: signer, .. }) = signer {
        if let Some(chain) = trust.chain_of(signer.fingerprint()) {
            let stated = p.actor.cert_chain_sha256.clone().unwrap_or_default();
            if stated != chain.sha256() {
                found.push(
                    Finding::new("SIGNER_MISMATCH", "actor.cert_chain_sha256")
                        .expected(chain.sha256().join(" "))
                        .actual(stated.join(" ")),
                );
            }
            if p.actor.auth != "pki" || p.actor.operator_id != record::printable(chain.operator()) {
                found.push(
                    Finding::new("SIGNER_MISMATCH", "actor.operator_id")
                        .expected(format!("{} (pki)", chain.operator()))
                        .actual(format!("{} ({})", p.actor.operator_id, p.actor.auth)),
                );
            }
        }
        if p.actor.key_fingerprint != signer.fingerprint() {
            found.push(
                Finding::new("SIGNER_MISMATCH", "actor.key_fingerprint")
                    .expected(signer.fingerprint())
                    .actual(&p.actor.key_fingerprint),
            );
        }
        if let Some(bits) = signer.short_bits() {
            found.push(Finding::new("KEY_SHORT", "signing key").actual(format!("{bits} bits")));
        }
        for other in p.actor.co_signers.iter().flatten() {
            let signed =
                |s: &Signer<'_>| s.key.fingerprint() == other.key_fingerprint && s.algorithm.name() == other.algorithm;
            if !signers.iter().any(signed) {
                found.push(
                    Finding::new("SIGNATURE_MISSING", "actor.co_signers")
                        .expected(format!("a signature by {} ({})", other.key_fingerprint, other.algorithm)),
                );
            }
        }
    }
    if (p.chain.seq == 0) != (p.chain.prev == GENESIS) {
        found.push(Finding::new("CHAIN_BROKEN", "chain.prev").actual(format!("{} at {}", p.chain.prev, p.chain.seq)));
    }
    if p.chain.seq == 0 {
        let expected = record::ledger_id(&p.event.id, &p.actor.key_fingerprint);
        if p.chain.ledger_id != expected {
            found.push(Finding::new("LEDGER_ID", "chain.ledger_id").expected(expected).actual(&p.chain.ledger_id));
        }
    }
    if time::parse_utc(&p.time.utc).is_none_or(|t| t > now_ms.saturating_add(FUTURE_SKEW_MS)) {
        found.push(
            Finding::new("TIME_FUTURE", "time.utc")
                .expected(format!("not after {}", time::format_utc(now_ms)))
                .actual(&p.time.utc),
        );
    }
    if let (Some(proven), Some(stated)) = (proven_ms, time::parse_utc(&p.time.utc))
        && stated > proven.saturating_add(FUTURE_SKEW_MS)
    {
        found.push(
            Finding::new("TIME_FUTURE", "time.utc")
                .expected(format!("not after its time stamp, {}", time::format_utc(proven)))
                .actual(&p.time.utc),
        );
    }
    if p.time.sync_status != SyncStatus::Synchronised {
        found.push(Finding::new("TIME_UNSYNCED", "time.sync_status").actual(match p.time.sync_status {
            SyncStatus::Unsynchronised => "unsynchronised",
            _ => "unknown",
        }));
    }
    check_marking(statement, found);
}

fn check_marking(statement: &Statement, found: &mut Vec<Finding>) {
    let block = &statement.predicate.marking;
    let unsupported = |field: &str, text: &str| Finding::new("MARKING_UNSUPPORTED", field).actual(text);
    // Codes beyond Orb's own lists are as the record says that its operator's register has them.
    let known = |m: &Marking| {
        m.unlisted_codes().iter().all(|code| block.country_register.as_ref().is_some_and(|r| r.has(code)))
    };
    let read = |text: &str| Marking::read(text).ok().filter(|m| known(m));
    let Some(marking) = read(&block.banner) else {
        found.push(unsupported("marking.banner", &block.banner));
        return;
    };
    if block.ism != marking.ism() {
        let words = |ism: &Ism| serde_json::to_string(ism).unwrap_or_default();
        found.push(
            Finding::new("MARKING_INBAND_MISMATCH", "marking.ism")
                .expected(words(&marking.ism()))
                .actual(words(&block.ism)),
        );
    }
    let sources =
        statement.predicate.inputs.iter().filter_map(|i| i.marking.as_deref()).chain(block.inputs_join.as_deref());
    for text in sources {
        match read(text) {
            None => found.push(unsupported("inputs.marking", text)),
            Some(input) if !marking.covers(&input) => found.push(
                Finding::new("MARKING_DOWNGRADE", "marking.banner").expected(input.banner()).actual(marking.banner()),
            ),
            Some(_) => {}
        }
    }
}
