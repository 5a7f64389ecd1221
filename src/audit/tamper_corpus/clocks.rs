//! Ledgers whose two clocks, the one that can be set and the one that runs since the machine's start, do not agree.

use std::fs;
use std::path::Path;

use super::make::{case, write_cases};
use super::{Case, Kind, corpus};
use crate::audit::RecordDraft;
use crate::audit::keys::{Bits, KeySource, SigningKey};
use crate::audit::ledger::Ledger;
use crate::audit::record::{self, tests::draft};
use crate::audit::statement::Outcome;

const KEY: &str = "clocks.pub.pem";
const HOUR_MS: i64 = 3_600_000;

/// Name, what the second record says, how much later it is by both clocks, on the same start of the machine or another, the
/// options, what must be reported, the exit code.
type Clocks<'a> = (&'a str, &'a str, [i64; 2], bool, &'a [&'a str], &'a [&'a str], u8);

const CLOCKS: [Clocks<'_>; 6] = [
    ("clocks-agree", "an hour later by both clocks", [HOUR_MS; 2], true, &[], &[], 0),
    (
        "clock-set-back-meanwhile",
        "an hour later by the clock, three by the one that nobody can set",
        [HOUR_MS, 3 * HOUR_MS],
        true,
        &[],
        &["TIME_ROLLBACK"],
        1,
    ),
    (
        "clock-set-forward",
        "three hours later by the clock, one by the one that nobody can set",
        [3 * HOUR_MS, HOUR_MS],
        true,
        &[],
        &["TIME_STEPPED"],
        0,
    ),
    (
        "clock-of-the-start-set-back",
        "an hour later, but an hour earlier since the start",
        [HOUR_MS, -HOUR_MS],
        true,
        &[],
        &["TIME_ROLLBACK", "TIME_STEPPED"],
        1,
    ),
    ("started-again", "an hour later, soon after the machine started again", [HOUR_MS, -HOUR_MS], false, &[], &[], 0),
    (
        "out-of-order",
        "a minute earlier by both clocks, and no grace for runs at once",
        [-60_000; 2],
        true,
        &["--time-grace", "0"],
        &["TIME_ROLLBACK"],
        1,
    ),
];

fn later(by: [i64; 2], same_start: bool) -> RecordDraft {
    let mut draft = draft();
    draft.event_random[0] = 1;
    draft.time.unix_ms = draft.time.unix_ms.checked_add_signed(by[0]).unwrap();
    let since_boot = draft.time.since_boot.as_mut().unwrap();
    since_boot.milliseconds = since_boot.milliseconds.checked_add_signed(by[1]).unwrap();
    if !same_start {
        since_boot.boot_id = since_boot.boot_id.replace('b', "c");
    }
    draft
}

pub(super) fn make(root: &Path, cases: &mut Vec<Case>) {
    let key = SigningKey::generate(KeySource::NamedFile, Bits::default()).unwrap();
    fs::write(root.join(KEY), key.public().to_pem()).unwrap();
    for (name, change, by, same_start, options, expect, exit_code) in CLOCKS {
        let folder = root.join("ledger").join(name);
        fs::create_dir_all(&folder).unwrap();
        let mut ledger = Ledger::at(folder.join("orb-ledger.jsonl"));
        for draft in [draft(), later(by, same_start)] {
            let seal = |next| record::seal(&draft, Vec::new(), Outcome::Success, None, next, &key);
            ledger.append(&key, seal, |_, _| Ok(())).unwrap();
        }
        fs::remove_file(folder.join("head.json")).unwrap();
        cases.push(case(name, Kind::Ledger, change, &[KEY], &[], options, expect, exit_code));
    }
}

#[test]
#[ignore = "writes a part of the corpus anew"]
fn make_the_clocks_of_the_tamper_corpus() {
    let root = corpus();
    let mut cases = super::cases(&root);
    cases.retain(|case| CLOCKS.iter().all(|clocks| clocks.0 != case.name));
    for (name, ..) in CLOCKS {
        let _ = fs::remove_dir_all(root.join("ledger").join(name));
    }
    make(&root, &mut cases);
    write_cases(&root, &cases);
}
