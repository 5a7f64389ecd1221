use serde_json::{Value, json};
use tempfile::TempDir;

use super::*;
use crate::audit::dsse::{self, Signature};
use crate::audit::keys::SigningKey;
use crate::audit::keys::tests::{other_key, shared_key};
use crate::audit::publication::tests::publish;
use crate::audit::record::{self, tests::draft};
use crate::audit::report::{Severity, Verdict};
use crate::audit::statement::Outcome;
use crate::audit::{Ledger, canonical};

pub(crate) const NOW_MS: u64 = 1_763_700_000_000;

/// Record `n`, a second after the one before.
fn append(ledger: &mut Ledger, n: u8) {
    let mut d = draft();
    d.time.unix_ms += 1000 * u64::from(n);
    d.time.since_boot.as_mut().unwrap().milliseconds += 1000 * u64::from(n);
    d.event_random = [n; 10];
    let seal = |place| record::seal(&d, Vec::new(), Outcome::Success, None, place, shared_key());
    ledger.append(shared_key(), seal, |_, _| Ok(())).unwrap();
}

/// A ledger of `n` records in a folder of its own.
pub(crate) fn ledger(n: u8) -> (TempDir, PathBuf) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("orb-ledger.jsonl");
    let mut ledger = Ledger::at(path.clone());
    (0..n).for_each(|i| append(&mut ledger, i));
    (dir, path)
}

fn trust() -> TrustStore {
    let mut trust = TrustStore::default();
    trust.insert(shared_key().public().clone());
    trust
}

fn check_with(path: &Path, checkpoints: &[PathBuf], require_anchor: bool) -> Report {
    let trust = trust();
    let request = LedgerRequest {
        ledger: path,
        trust: &trust,
        checkpoints,
        require_anchor,
        now_ms: NOW_MS,
        strict: false,
        policy: Policy::default(),
    };
    verify_ledger(&request).unwrap()
}

fn codes(report: &Report) -> Vec<&'static str> {
    report.findings.iter().filter(|f| f.severity != Severity::Note).map(|f| f.code).collect()
}

fn lines(path: &Path) -> Vec<String> {
    fs::read_to_string(path).unwrap().lines().map(|l| format!("{l}\n")).collect()
}

fn checkpoint(path: &Path, name: &str) -> PathBuf {
    let file = path.with_file_name(name);
    let checkpoint = Ledger::at(path.to_owned()).checkpoint().unwrap().unwrap();
    fs::write(&file, checkpoint.sign(shared_key()).unwrap().to_line()).unwrap();
    file
}

/// The line with its record changed and signed again by `key`, which the change may name.
pub(crate) fn forged(line: &str, key: &SigningKey, change: impl FnOnce(&mut Value)) -> String {
    let envelope = Envelope::parse(line.as_bytes()).unwrap();
    let mut value: Value = serde_json::from_slice(&envelope.payload).unwrap();
    change(&mut value);
    value["predicate"].as_object_mut().unwrap().remove("trail_hash");
    let hash = canonical::sha256_hex(&serde_json_canonicalizer::to_vec(&value).unwrap());
    value["predicate"]["trail_hash"] = json!(hash);
    let payload = serde_json_canonicalizer::to_vec(&value).unwrap();
    let sig = key.sign(&dsse::pae(PAYLOAD_TYPE, &payload)).unwrap();
    let signatures = vec![Signature { keyid: key.public().fingerprint().into(), sig }];
    let envelope = Envelope { payload, payload_type: PAYLOAD_TYPE.into(), signatures };
    String::from_utf8(envelope.to_line()).unwrap()
}

#[test]
fn a_good_ledger() {
    let (_dir, path) = ledger(5);
    let report = check_with(&path, &[], false);
    assert_eq!((codes(&report), report.exit_code), (vec![], 0), "{}", report.to_text());
    assert_eq!((report.range, report.anchored_through), (Some(Range { first: 0, last: 4 }), None));
    assert!(report.to_text().contains("PASS: 5 records verified, 0 anchored. Evidence only"), "{}", report.to_text());
    assert_eq!(check_with(&path, &[], true).verdict, Verdict::Incomplete);

    let kept = checkpoint(&path, "kept.dsse.json");
    append(&mut Ledger::at(path.clone()), 5);
    let report = check_with(&path, std::slice::from_ref(&kept), false);
    assert_eq!((codes(&report), report.anchored_through), (vec![], Some(4)), "{}", report.to_text());
    assert!(report.to_text().contains("6 records verified, 5 anchored"), "{}", report.to_text());
    assert!(report.findings.iter().any(|f| f.code == "TAIL_UNANCHORED"));
    assert_eq!(check_with(&path, std::slice::from_ref(&kept), true).exit_code, 3);
    let all = checkpoint(&path, "all.dsse.json");
    let report = check_with(&path, &[kept, all], true);
    assert_eq!((report.exit_code, report.anchored_through), (0, Some(5)));
    assert!(!report.findings.iter().any(|f| f.code == "TAIL_UNANCHORED"));
}

#[test]
fn a_cut_tail_is_seen_by_whoever_kept_a_checkpoint() {
    let (_dir, path) = ledger(4);
    let kept = checkpoint(&path, "kept.dsse.json");
    let all = lines(&path);
    fs::write(&path, all[..3].concat()).unwrap();
    // The head that stands beside it knows.
    assert_eq!(codes(&check_with(&path, &[], false)), ["TRUNCATED"]);
    // Whoever cuts both is found out by the checkpoint alone.
    fs::remove_file(path.with_file_name("head.json")).unwrap();
    let report = check_with(&path, &[], false);
    assert_eq!((codes(&report), report.anchored_through), (vec![], None));
    assert!(report.findings.iter().any(|f| f.code == "TAIL_UNANCHORED"));
    let report = check_with(&path, &[kept], false);
    assert_eq!((codes(&report), report.exit_code), (vec!["TRUNCATED"], 1));
    fs::remove_file(&path).unwrap();
    assert_eq!(
        verify_ledger(&LedgerRequest {
            ledger: &path,
            trust: &trust(),
            checkpoints: &[],
            require_anchor: false,
            now_ms: NOW_MS,
            strict: false,
            policy: Policy::default()
        })
        .unwrap_err()
        .kind,
        crate::Kind::Incomplete
    );
}

/// Without a head and a checkpoint nothing tells of the records that were there, but no verdict is a good one.
#[test]
fn an_emptied_ledger_has_no_verdict() {
    let (_dir, path) = ledger(3);
    let kept = checkpoint(&path, "kept.dsse.json");
    fs::write(&path, "").unwrap();
    fs::remove_file(path.with_file_name("head.json")).unwrap();
    let report = check_with(&path, &[], false);
    assert_eq!((codes(&report), report.exit_code), (vec!["RECORD_MISSING"], 3), "{}", report.to_text());
    let report = check_with(&path, &[], true);
    assert_eq!((codes(&report), report.exit_code), (vec!["ANCHOR_REQUIRED", "RECORD_MISSING"], 3));
    assert_eq!(codes(&check_with(&path, &[kept], false)), ["TRUNCATED"]);
    // Half a record is none.
    fs::write(&path, "{\"payload").unwrap();
    let report = check_with(&path, &[], false);
    assert_eq!((codes(&report), report.exit_code), (vec!["INCOMPLETE_APPEND", "RECORD_MISSING"], 3));
}

#[test]
fn a_rewrite_by_the_key_holder_is_a_fork() {
    let (_dir, path) = ledger(3);
    let kept = checkpoint(&path, "kept.dsse.json");
    let mut all = lines(&path);
    all[2] = forged(&all[2], shared_key(), |v| v["predicate"]["params"]["seed"] = json!(8));
    fs::write(&path, all.concat()).unwrap();
    fs::remove_file(path.with_file_name("head.json")).unwrap();
    assert_eq!(codes(&check_with(&path, &[], false)), [""; 0], "as long as before, every link good");
    assert_eq!(codes(&check_with(&path, &[kept], false)), ["HEAD_FORK"]);
}

#[test]
fn removed_moved_repeated_and_foreign_records() {
    let (_dir, path) = ledger(4);
    let all = lines(&path);
    let (_dir2, other) = ledger(1);
    let mut d = draft();
    d.event_random = [99; 10];
    let foreign = record::seal(&d, Vec::new(), Outcome::Success, None, None, shared_key()).unwrap();
    let foreign = String::from_utf8(foreign.envelope.to_line()).unwrap();
    assert_eq!(lines(&other)[0], all[0], "the same draft gives the same record");
    let pick = |order: &[usize]| order.iter().map(|i| all[*i].as_str()).collect::<String>();
    for (case, text, expected) in [
        ("middle removed", pick(&[0, 1, 3]), &["SEQ_GAP", "CHAIN_BROKEN"][..]),
        ("first removed", pick(&[1, 2, 3]), &["CHAIN_BROKEN"]),
        ("two exchanged", pick(&[0, 2, 1, 3]), &["SEQ_GAP", "CHAIN_BROKEN"]),
        ("one repeated", pick(&[0, 1, 2, 3, 1]), &["REPLAY", "SEQ_GAP", "CHAIN_BROKEN"]),
        ("another ledger's", pick(&[0, 1]) + &foreign, &["LEDGER_ID"]),
    ] {
        fs::write(&path, text).unwrap();
        let report = check_with(&path, &[], false);
        for code in expected {
            assert!(codes(&report).contains(code), "{case}: {code} in {}", report.to_text());
        }
        assert_eq!(report.exit_code, 1, "{case}");
    }
}

#[test]
fn changed_and_forged_records() {
    type Change = fn(&mut Value);
    let (_dir, path) = ledger(3);
    let all = lines(&path);
    let cases: [(&[&str], Change); 5] = [
        (&["TIME_ROLLBACK"], |v| v["predicate"]["time"]["utc"] = json!("2025-11-20T01:29:42.120Z")),
        (&["TIME_FUTURE", "TIME_STEPPED"], |v| v["predicate"]["time"]["utc"] = json!("2026-11-21T09:29:42.120Z")),
        (&["MARKING_DOWNGRADE"], |v| v["predicate"]["inputs"][0]["marking"] = json!("SECRET")),
        (&["ALG_REFUSED"], |v| v["predicate"]["actor"]["algorithm"] = json!("RS1")),
        (&["SCHEMA_INVALID"], |v| v["predicate"]["extra"] = json!(1)),
    ];
    for (expected, change) in cases {
        let text = [&all[..2], &[forged(&all[2], shared_key(), change)]].concat().concat();
        fs::write(&path, text).unwrap();
        let _ = fs::remove_file(path.with_file_name("head.json"));
        assert_eq!(codes(&check_with(&path, &[], false)), expected);
    }
    // A changed byte, and another's signature.
    let mut changed = all.concat().into_bytes();
    let at = all[0].len() + 500;
    changed[at] = if changed[at] == b'A' { b'B' } else { b'A' };
    fs::write(&path, changed).unwrap();
    let report = check_with(&path, &[], false);
    assert!(codes(&report).contains(&"SIG_INVALID"), "{}", report.to_text());
    assert_eq!(report.findings.iter().find(|f| f.code == "SIG_INVALID").unwrap().seq, Some(1));
    assert_eq!((report.trail_hash, report.time, report.marking), (None, None, None));
    fs::write(&path, [all[0].clone(), forged(&all[1], other_key(), |_| {})].concat()).unwrap();
    assert!(codes(&check_with(&path, &[], false)).contains(&"KEY_UNTRUSTED"));
}

#[test]
fn a_crash_is_not_tampering() {
    let (_dir, path) = ledger(3);
    let all = lines(&path);
    let _ = fs::remove_file(path.with_file_name("head.json"));
    fs::write(&path, [&all[0], &all[1], &all[2][..700]].concat()).unwrap();
    let report = check_with(&path, &[], false);
    assert_eq!((codes(&report), report.exit_code), (vec!["INCOMPLETE_APPEND"], 0));
    assert_eq!(report.counts.records, 2);
}

#[test]
fn findings_are_bounded() {
    let (_dir, path) = ledger(1);
    fs::write(&path, "{}\n".repeat(5000)).unwrap();
    let report = check_with(&path, &[], false);
    assert_eq!(report.findings.iter().filter(|f| f.code == "SCHEMA_INVALID").count(), MAX_FINDINGS);
    assert!(codes(&report).contains(&"TOO_MANY_FINDINGS"));
}

#[test]
fn published_folders_stand_in_the_ledger() {
    let dir = tempfile::tempdir().unwrap();
    publish(dir.path());
    let ledger = dir.path().join("data/ledger/orb-ledger.jsonl");
    let roots = [dir.path().to_owned()];
    let report = reconcile(&ledger, &roots, &trust()).unwrap();
    assert_eq!((codes(&report), report.counts.outputs_verified), (vec![], 1), "{}", report.to_text());
    assert!(report.to_text().contains("1 of 1 published folders"));
    let (_other, empty) = super::tests::ledger(1);
    let report = reconcile(&empty, &roots, &trust()).unwrap();
    assert_eq!((codes(&report), report.exit_code), (vec!["RECORD_MISSING"], 1));
    assert!(report.findings[0].actual == "1 records without it", "{}", report.to_text());
    let report = reconcile(&ledger, &[dir.path().join("data")], &trust()).unwrap();
    assert_eq!(report.findings[0].code, "FOLDER_NOT_FOUND");
    assert_eq!(report.exit_code, 0);

    // Emptied, and removed: the folder that is left shows that there was a record.
    let hash = report.findings[0].subject.clone();
    fs::write(&ledger, "").unwrap();
    for (left, words) in [("emptied", "0 records without it"), ("removed", "no ledger")] {
        let report = reconcile(&ledger, &roots, &trust()).unwrap();
        assert_eq!((codes(&report), report.exit_code), (vec!["RECORD_MISSING"], 1), "{left}");
        let found = &report.findings[0];
        assert!(found.actual == words && found.expected.starts_with("record 0 of ledger "), "{}", report.to_text());
        assert!(found.expected.ends_with(&hash) && found.subject.ends_with("out"), "{}", report.to_text());
        let _ = fs::remove_file(&ledger);
    }
    let error = reconcile(&ledger, &[dir.path().join("data")], &trust()).unwrap_err();
    assert_eq!(error.kind, crate::Kind::Incomplete, "neither a ledger nor a folder: {error}");
}

/// `cargo test --release --lib a_hundred_thousand -- --ignored --nocapture` prints how long a
/// hundred thousand records take to verify, how much memory, and what one more costs at the end of a long ledger.
#[test]
#[ignore = "signs 100,000 records: two minutes"]
fn a_hundred_thousand_records() {
    use std::io::Write as _;
    use std::time::Instant;
    const RECORDS: u64 = 100_000;
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("orb-ledger.jsonl");
    let mut file = std::io::BufWriter::new(fs::File::create(&path).unwrap());
    let mut next = None;
    let mut compose = |n: u64| {
        let mut d = draft();
        d.time.unix_ms += n;
        d.time.since_boot.as_mut().unwrap().milliseconds += n;
        d.event_random[..8].copy_from_slice(&n.to_be_bytes());
        let record = record::compose(&d, Vec::new(), Outcome::Success, None, next.take(), shared_key()).unwrap();
        let chain = record.statement.predicate.chain.clone();
        next = Some(crate::audit::statement::Chain { seq: n + 1, prev: record.trail_hash.clone(), ..chain });
        record
    };
    // A record names the one before it by its trail hash, not its signature: the slow part runs on all processors.
    for first in (0..RECORDS).step_by(1000) {
        let batch: Vec<_> = (first..first + 1000).map(&mut compose).collect();
        let lines: Vec<_> = batch.into_par_iter().map(|r| r.sign(shared_key()).unwrap().envelope.to_line()).collect();
        lines.iter().for_each(|line| file.write_all(line).unwrap());
    }
    file.flush().unwrap();
    let bytes = fs::metadata(&path).unwrap().len();
    // VmHWM: the most that this process ever held.
    let peak = || {
        let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
        let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:").map(str::to_owned)).unwrap_or_default();
        line.trim().trim_end_matches(" kB").parse::<u64>().unwrap_or(0)
    };
    // Seconds of all processors: what other programs take does not count.
    let cpu = || {
        let stat = fs::read_to_string("/proc/self/stat").unwrap_or_default();
        let after_name = stat.rsplit(')').next().unwrap_or_default().to_owned();
        let ticks: u64 = after_name.split_whitespace().skip(11).take(2).filter_map(|t| t.parse::<u64>().ok()).sum();
        ticks as f64 / 100.0
    };
    let (before, began, cpu_before) = (peak(), Instant::now(), cpu());
    let report = check_with(&path, &[], false);
    let (took, grown) = (began.elapsed().as_secs_f64(), peak().saturating_sub(before));
    assert_eq!((report.counts.records, codes(&report)), (RECORDS, vec![]));
    println!(
        "{RECORDS} records, {} MiB: verified in {took:.1} s ({:.1} s of processors), {} MiB more memory",
        bytes >> 20,
        cpu() - cpu_before,
        grown >> 10
    );
    assert!(grown < 64 << 10, "{grown} KiB");

    let mut ledger = Ledger::at(path);
    append(&mut ledger, 200);
    let began = Instant::now();
    (0..20).for_each(|i| append(&mut ledger, 201 + i));
    let long = began.elapsed().as_secs_f64() / 20.0;
    let (_short_dir, short) = self::ledger(2);
    let mut short = Ledger::at(short);
    let began = Instant::now();
    (0..20).for_each(|i| append(&mut short, 201 + i));
    let short = began.elapsed().as_secs_f64() / 20.0;
    println!("appending: {:.1} ms after 2 records, {:.1} ms after {RECORDS}", 1e3 * short, 1e3 * long);
    assert!(long < 3.0 * short + 0.01);
}
