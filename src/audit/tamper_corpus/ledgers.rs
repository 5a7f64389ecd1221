//! Ledgers, changed.

use serde_json::json;

use super::folders::edited;
use crate::audit::dsse::Envelope;
use crate::audit::keys::tests::shared_key;
use crate::audit::keys::{Bits, KeySource, SigningKey};
use crate::audit::ledger_check::tests::forged;

pub(super) type LedgerCase<'a> = (&'a str, &'a str, &'a [&'a str], u8, fn(&[String]) -> String, Keeps);

/// What is left of the checkpoints of the ledger as it was.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Keeps {
    Nothing,
    Head,
    Elsewhere,
}

/// Name, what was done, what must be reported, the exit code, the lines that are left, and the checkpoints.
pub(super) const LEDGERS: [LedgerCase<'_>; 14] = [
    ("good", "nothing", &[], 0, |l| l.concat(), Keeps::Elsewhere),
    (
        "middle-removed",
        "the second record removed",
        &["SEQ_GAP", "CHAIN_BROKEN"],
        1,
        |l| pick(l, &[0, 2, 3]),
        Keeps::Nothing,
    ),
    ("reordered", "two records exchanged", &["SEQ_GAP", "CHAIN_BROKEN"], 1, |l| pick(l, &[0, 2, 1, 3]), Keeps::Nothing),
    (
        "tail-cut",
        "the last record removed; a checkpoint was kept",
        &["TRUNCATED"],
        1,
        |l| l[..3].concat(),
        Keeps::Elsewhere,
    ),
    (
        "tail-cut-head-left",
        "the last record removed, the head forgotten",
        &["TRUNCATED"],
        1,
        |l| l[..3].concat(),
        Keeps::Head,
    ),
    (
        "tail-cut-unseen",
        "the last record removed, nothing kept: it verifies, unanchored",
        &[],
        0,
        |l| l[..3].concat(),
        Keeps::Nothing,
    ),
    (
        "rewritten",
        "the last record made anew by the key's holder",
        &["HEAD_FORK"],
        1,
        |l| {
            [&l[..3], &[forged(&l[3], shared_key(), |v| v["predicate"]["params"]["seed"] = json!(8))]].concat().concat()
        },
        Keeps::Elsewhere,
    ),
    (
        "half-a-line",
        "the last line cut by a crash",
        &["INCOMPLETE_APPEND"],
        0,
        |l| l[..3].concat() + &l[3][..900],
        Keeps::Nothing,
    ),
    (
        "replayed",
        "an old record again at the end",
        &["REPLAY", "SEQ_GAP", "CHAIN_BROKEN"],
        1,
        |l| pick(l, &[0, 1, 2, 3, 1]),
        Keeps::Nothing,
    ),
    (
        "foreign",
        "a record of another ledger",
        &["LEDGER_ID"],
        1,
        |l| {
            l[..3].concat()
                + &forged(&l[3], shared_key(), |v| v["predicate"]["chain"]["ledger_id"] = json!("0123456789abcdef"))
        },
        Keeps::Nothing,
    ),
    (
        "clock-set-back",
        "a day earlier than the record before, properly signed",
        &["TIME_ROLLBACK"],
        1,
        |l| {
            l[..3].concat()
                + &forged(&l[3], shared_key(), |v| v["predicate"]["time"]["utc"] = json!("2025-11-20T01:29:42.120Z"))
        },
        Keeps::Nothing,
    ),
    (
        "field-edited",
        "one letter of one record",
        &["SIG_INVALID"],
        1,
        |l| {
            let mut second = l[1].clone().into_bytes();
            second[900] = if second[900] == b'A' { b'B' } else { b'A' };
            [l[0].clone(), String::from_utf8(second).unwrap(), l[2].clone(), l[3].clone()].concat()
        },
        Keeps::Nothing,
    ),
    (
        "field-edited-and-rehashed",
        "a parameter of the second record and its trail hash, no key",
        &["SIG_INVALID", "CHAIN_BROKEN"],
        1,
        |l| {
            let mut envelope = Envelope::parse(l[1].as_bytes()).unwrap();
            edited(&mut envelope, true, |v| v["predicate"]["params"]["seed"] = json!(8));
            [l[0].clone(), String::from_utf8(envelope.to_line()).unwrap(), l[2..].concat()].concat()
        },
        Keeps::Nothing,
    ),
    (
        "unknown-signer",
        "a record signed by an unknown key",
        &["KEY_UNTRUSTED"],
        1,
        |l| {
            let stranger = SigningKey::generate(KeySource::NamedFile, Bits::default()).unwrap();
            l[..3].concat() + &forged(&l[3], &stranger, |_| {})
        },
        Keeps::Nothing,
    ),
];

fn pick(lines: &[String], order: &[usize]) -> String {
    order.iter().map(|i| lines[*i].as_str()).collect()
}
