//! The checks of one record, wherever it stands: beside its outputs or in a ledger.

use super::dsse::Envelope;
use super::keys::{ADVISED_BITS, ALGORITHM, PublicKey};
use super::marking::{Ism, Marking};
use super::record;
use super::report::Finding;
use super::statement::{GENESIS, Statement};
use super::time::{self, SyncStatus};
use super::trust::TrustStore;

/// How far a record's time may lie ahead of this machine's clock, milliseconds.
const FUTURE_SKEW_MS: u64 = 5 * 60 * 1000;

/// The key that verified; every signature must be good.
///
/// `subject` names the record in findings.
pub(super) fn check_signatures<'a>(
    envelope: &Envelope,
    trust: &'a TrustStore,
    subject: &str,
    found: &mut Vec<Finding>,
) -> Option<&'a PublicKey> {
    let message = envelope.pae();
    let mut signer = None;
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
            Ok(true) => signer = Some(key),
            Ok(false) => {
                found.push(
                    Finding::new("SIG_INVALID", subject).expected(format!("a signature by {}", key.fingerprint())),
                );
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
    signer.filter(|_| all_good)
}

/// The record's fields, strictly read.
pub(super) fn read_statement(envelope: &Envelope, subject: &str, found: &mut Vec<Finding>) -> Option<Statement> {
    match Statement::parse(&envelope.payload) {
        Ok((statement, canonical)) => {
            if !canonical {
                found.push(Finding::new("NOT_CANONICAL", subject).expected("the one spelling of this record"));
            }
            Some(statement)
        }
        Err(fault) => {
            found.push(Finding::new(fault.code(), subject).expected("a record of version 1").actual(fault.detail()));
            None
        }
    }
}

/// What a record says about itself: its trail hash, its signer, its place in the chain, its time, its marking.
pub(super) fn check_fields(
    statement: &Statement,
    signer: Option<&PublicKey>,
    now_ms: u64,
    subject: &str,
    found: &mut Vec<Finding>,
) {
    let p = &statement.predicate;
    let trail_hash = statement.trail_hash().unwrap_or_default();
    if p.trail_hash.as_deref() != Some(trail_hash.as_str()) {
        let stated = p.trail_hash.clone().unwrap_or_default();
        found.push(Finding::new("TRAIL_HASH_MISMATCH", subject).expected(trail_hash).actual(stated));
    }
    if p.actor.algorithm != ALGORITHM {
        found.push(Finding::new("ALG_REFUSED", "actor.algorithm").expected(ALGORITHM).actual(&p.actor.algorithm));
    }
    if let Some(signer) = signer {
        if p.actor.key_fingerprint != signer.fingerprint() {
            found.push(
                Finding::new("SIGNER_MISMATCH", "actor.key_fingerprint")
                    .expected(signer.fingerprint())
                    .actual(&p.actor.key_fingerprint),
            );
        }
        if signer.bits() < ADVISED_BITS {
            found.push(Finding::new("KEY_SHORT", "signing key").actual(format!("{} bits", signer.bits())));
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
    let Ok(marking) = Marking::parse(&block.banner) else {
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
        match Marking::parse(text) {
            Err(_) => found.push(unsupported("inputs.marking", text)),
            Ok(input) if !marking.covers(&input) => found.push(
                Finding::new("MARKING_DOWNGRADE", "marking.banner").expected(input.banner()).actual(marking.banner()),
            ),
            Ok(_) => {}
        }
    }
}
