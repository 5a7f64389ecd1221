//! The kinds of tampering that a verification is asked to show, each with what it must report, and the cases that show it.

use std::collections::BTreeSet;

use super::{cases, corpus};

/// What was done; the codes that must be reported, by all the cases together; the cases, with what they change before the
/// slash. Where a code is one of two that may be reported, the cases show which.
const ROWS: [(&str, &[&str], &[&str]); 28] = [
    ("edit any field", &["SIG_INVALID", "TRAIL_HASH_MISMATCH"], &["folder/field-edited", "ledger/field-edited"]),
    (
        "edit and recompute the trail hash, without the key: the next record's link breaks",
        &["SIG_INVALID", "CHAIN_BROKEN"],
        &["folder/field-edited-and-rehashed", "ledger/field-edited-and-rehashed"],
    ),
    ("the same meaning in other bytes", &["SIG_INVALID", "NOT_CANONICAL"], &["folder/respelled"]),
    ("another payload type", &["TYPE_UNSUPPORTED", "SIG_INVALID"], &["folder/payload-type"]),
    (
        "a key twice, or one that nobody knows, properly signed",
        &["SCHEMA_INVALID"],
        &["folder/key-twice", "folder/unknown-key"],
    ),
    ("a middle record removed", &["SEQ_GAP", "CHAIN_BROKEN"], &["ledger/middle-removed"]),
    ("records exchanged", &["SEQ_GAP", "CHAIN_BROKEN"], &["ledger/reordered"]),
    (
        "the tail cut: seen by who holds a head, and said to be unanchored without one",
        &["TRUNCATED", "TAIL_UNANCHORED"],
        &["ledger/tail-cut", "ledger/tail-cut-head-left", "ledger/tail-cut-unseen"],
    ),
    (
        "the whole ledger removed",
        &["TRUNCATED", "RECORD_MISSING"],
        &["ledger/deleted", "ledger/deleted-unseen", "reconcile/deleted", "reconcile/emptied", "reconcile/begun-again"],
    ),
    ("a rewrite of the same length by the key's holder", &["HEAD_FORK"], &["ledger/rewritten"]),
    ("half a last line", &["INCOMPLETE_APPEND"], &["ledger/half-a-line"]),
    (
        "an output replaced or removed",
        &["OUTPUT_DIGEST", "OUTPUT_MISSING"],
        &["folder/output-replaced", "folder/output-removed"],
    ),
    (
        "an input replaced or removed",
        &["INPUT_DIGEST", "INPUT_MISSING"],
        &["folder/another-photo", "folder/photo-removed"],
    ),
    (
        "weights swapped",
        &["MODEL_DIGEST", "MODEL_NOT_ALLOWED"],
        &["folder/weights-swapped", "folder/weights-not-allowed"],
    ),
    ("signed again by an unknown key", &["KEY_UNTRUSTED"], &["folder/unknown-signer", "ledger/unknown-signer"]),
    ("signed again by another trusted key", &["SIGNER_MISMATCH"], &["folder/other-signer"]),
    ("the key's name points to another key", &["SIG_INVALID"], &["folder/wrong-keyid"]),
    (
        "a weak key, the exponent 3, SHA-1, another padding",
        &["ALG_REFUSED"],
        &["folder/short-key", "folder/exponent-3", "folder/sha-1", "folder/other-padding"],
    ),
    (
        "a certificate expired or revoked when it signed",
        &["CERT_EXPIRED", "CERT_REVOKED"],
        &["folder/certificate-expired", "folder/certificate-revoked"],
    ),
    ("an old record again", &["REPLAY", "SEQ_GAP", "CHAIN_BROKEN"], &["ledger/replayed"]),
    ("a record of another ledger", &["LEDGER_ID"], &["ledger/foreign"]),
    (
        "the clock set back, properly signed",
        &["TIME_ROLLBACK"],
        &["ledger/clock-set-back", "ledger/clock-set-back-meanwhile"],
    ),
    ("a clock not synchronised, under a policy", &["TIME_UNSYNCED"], &["folder/clock-unsynchronised"]),
    ("a lower marking, properly signed", &["MARKING_DOWNGRADE"], &["folder/marking-lowered"]),
    (
        "a lower marking, the signature left",
        &["SIG_INVALID", "MARKING_DOWNGRADE"],
        &["folder/marking-edited", "folder/marking-lowered-unsigned"],
    ),
    ("the banner inside an output", &["OUTPUT_DIGEST", "MARKING_INBAND_MISMATCH"], &["folder/marking-inside"]),
    ("another trust store", &["TRUST_STORE_CHANGED"], &["folder/trust-store-swapped"]),
    (
        "a link, `..`, an absolute name; a record too deep, too large",
        &["PATH_REFUSED", "LIMIT_EXCEEDED"],
        &[
            "folder/output-linked",
            "folder/name-leaves-the-folder",
            "folder/name-from-the-root",
            "folder/too-deep",
            "folder/too-large",
        ],
    ),
];

/// Row by row: its cases are in the corpus, and together they expect every code of it. That each case reports what it
/// expects is the test of the corpus.
#[test]
fn every_kind_of_tampering_has_its_cases() {
    let cases = cases(&corpus());
    for (row, codes, names) in ROWS {
        let mut expected = BTreeSet::new();
        for name in names {
            let of_that_name = |kind: &str, case: &str| name.split_once('/') == Some((kind, case));
            let found = cases.iter().find(|c| of_that_name(c.kind.folder(), &c.name));
            let case = found.unwrap_or_else(|| panic!("{row}: no case {name}"));
            expected.extend(case.expect.iter().chain(&case.notes).map(String::as_str));
            assert!(codes.iter().any(|c| case.expect.iter().chain(&case.notes).any(|e| e == c)), "{row}: {name}");
        }
        for code in codes {
            assert!(expected.contains(code), "{row}: {code} in none of {names:?}");
        }
    }
}
