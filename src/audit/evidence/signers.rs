//! Who signed, with what, and until when that is good.

use std::collections::BTreeSet;

use super::{Block, Cell, Evidence, Section, spans, table};
use crate::audit::statement::{Actor, Statement};
use crate::audit::time;
use crate::audit::trust::Validity;

const DAY_MS: u64 = 86_400_000;

pub(super) fn signers(records: &[Statement]) -> Section {
    let mut rows: Vec<Vec<String>> = records
        .iter()
        .map(|s| {
            let (a, c) = (&s.predicate.actor, &s.predicate.crypto);
            let fips = if c.fips_mode { "on" } else { "off" };
            vec![
                fingerprints(a),
                algorithms(a),
                a.key_source.clone(),
                format!("{} {}", c.provider, c.provider_version),
                fips.into(),
                c.module_certificate_claim.clone().unwrap_or("none".into()),
            ]
        })
        .collect();
    rows.sort();
    rows.dedup();
    let head = vec!["Key (SPKI SHA-256)", "Algorithm", "From", "Module", "FIPS mode", "Certificate claimed"];
    let mut section = table("Keys and cryptography", head, rows);
    if !section.blocks.is_empty() {
        section.blocks.push(Block::Text(
            "A key in a file gives integrity. It binds a person only as far as the organisation's custody of that file \
             does; shared, it is no evidence of who signed."
                .into(),
        ));
    }
    section
}

/// Of all who signed.
pub(super) fn fingerprints(actor: &Actor) -> String {
    let others = actor.co_signers.iter().flatten().map(|other| other.key_fingerprint.as_str());
    std::iter::once(actor.key_fingerprint.as_str()).chain(others).collect::<Vec<_>>().join(" ")
}

pub(super) fn algorithms(actor: &Actor) -> String {
    let others = actor.co_signers.iter().flatten().map(|other| other.algorithm.as_str());
    std::iter::once(actor.algorithm.as_str()).chain(others).collect::<Vec<_>>().join(" and ")
}

/// Something that is good until a day.
struct Ending {
    what: &'static str,
    whose: String,
    /// Milliseconds since 1970; `None` where nothing ends it.
    until_ms: Option<u64>,
    from_ms: Option<u64>,
    records: Vec<u64>,
    id: String,
}

/// Until when the certificates and the trust in keys reach by which the records were signed, the first to end first.
pub(super) fn endings(evidence: &Evidence<'_>, records: &[Statement]) -> Section {
    let mut all = certificates(evidence, records);
    for (key, entry) in evidence.trust.keys() {
        let signed = |s: &&Statement| {
            let others = s.predicate.actor.co_signers.iter().flatten().map(|other| other.key_fingerprint.as_str());
            others.chain([s.predicate.actor.key_fingerprint.as_str()]).any(|f| f == key.fingerprint())
        };
        let records: Vec<u64> = records.iter().filter(signed).map(|s| s.predicate.chain.seq).collect();
        if records.is_empty() {
            continue;
        }
        let ms = |text: &Option<String>| text.as_deref().and_then(time::parse_utc);
        let revoked = entry.revoked.as_ref().and_then(|r| time::parse_utc(&r.from));
        let what = if revoked.is_some() { "trust in a key, revoked" } else { "trust in a key" };
        let until_ms = [ms(&entry.not_after), revoked].into_iter().flatten().min();
        let whose = entry.name.clone().unwrap_or("not stated".into());
        let (from_ms, id) = (ms(&entry.not_before), key.fingerprint().to_owned());
        all.push(Ending { what, whose, until_ms, from_ms, records, id });
    }
    all.sort_by(|a, b| {
        (a.until_ms.unwrap_or(u64::MAX), a.what, &a.id).cmp(&(b.until_ms.unwrap_or(u64::MAX), b.what, &b.id))
    });
    let rows = all
        .iter()
        .map(|e| {
            let day = |ms: Option<u64>| ms.map_or("not stated".into(), time::format_utc);
            vec![
                e.what.into(),
                e.whose.clone().into(),
                day(e.from_ms).into(),
                day(e.until_ms).into(),
                left(e.until_ms, evidence.as_of_ms).into(),
                Cell::about("", spans(e.records.iter().copied())),
                e.id.clone().into(),
            ]
        })
        .collect();
    let head = vec!["What", "Whose", "From", "Until", "At this report", "Signed records", "SHA-256"];
    let mut section = table::<Cell>("Until when", head, rows);
    if !section.blocks.is_empty() {
        section.blocks.push(Block::Text(
            "What was signed before an end stays good: verification judges a signature by the time that its record states, or \
             that a time stamp proves. After it, nothing more can be signed by that certificate or key."
                .into(),
        ));
    }
    section
}

/// The certificates that the records name, and the authorities that are trusted to vouch for them.
fn certificates(evidence: &Evidence<'_>, records: &[Statement]) -> Vec<Ending> {
    let ending = |what: &'static str, v: Validity, records: Vec<u64>| Ending {
        what,
        whose: v.subject,
        until_ms: Some(v.not_after_ms),
        from_ms: Some(v.not_before_ms),
        records,
        id: v.sha256,
    };
    let (mut all, mut seen) = (Vec::new(), BTreeSet::new());
    for (i, validity) in evidence.chains.iter().flat_map(|chain| chain.validities().into_iter().enumerate()) {
        let names =
            |s: &&Statement| s.predicate.actor.cert_chain_sha256.iter().flatten().any(|d| *d == validity.sha256);
        let named: Vec<u64> = records.iter().filter(names).map(|s| s.predicate.chain.seq).collect();
        // One that no signed record names is only a file that lies there.
        if !named.is_empty() && seen.insert(validity.sha256.clone()) {
            all.push(ending(if i == 0 { "signer's certificate" } else { "certificate above it" }, validity, named));
        }
    }
    if !all.is_empty() {
        let authorities = evidence.trust.authorities().filter_map(|a| a.validity());
        all.extend(authorities.map(|v| ending("authority, trusted here", v, Vec::new())));
    }
    all
}

/// How far an end is from the report's own time, in whole days.
fn left(until_ms: Option<u64>, as_of_ms: u64) -> String {
    let days = |ms: u64| match ms / DAY_MS {
        0 => "less than a day".to_owned(),
        1 => "1 day".to_owned(),
        n => format!("{n} days"),
    };
    match until_ms {
        None => "no end is stated".into(),
        Some(end) if end >= as_of_ms => format!("{} left", days(end - as_of_ms)),
        Some(end) => format!("ended {} before", days(as_of_ms - end)),
    }
}
