//! The tamper corpus under `tests/vectors/tamper`: published folders and ledgers, changed in every way that a record is
//! meant to show, each with the codes that a verification must report. Others can run it: `cases.json` says how.
//!
//! `cargo test make_the_tamper_corpus -- --ignored` makes it anew, with new keys.

// Made where every algorithm is known; run everywhere.
#[cfg(not(feature = "fips"))]
mod clocks;
#[cfg(not(feature = "fips"))]
mod fields;
#[cfg(not(feature = "fips"))]
mod folders;
#[cfg(not(feature = "fips"))]
mod ledgers;
#[cfg(not(feature = "fips"))]
mod make;
#[cfg(not(feature = "fips"))]
mod remains;
mod rows;
#[cfg(not(feature = "fips"))]
mod suites;

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::ledger_check::{LedgerRequest, reconcile, verify_ledger};
use super::report::{Finding, Report, Severity};
use super::trust::{self, Entry, TrustStore};
use super::verify::{Request, verify};
use super::{DataFolder, Policy, allowed};

/// Any time after the corpus's records.
const NOW_MS: u64 = 1_763_700_000_000;

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    /// The folder below `folder/` or `ledger/`; for a reconciliation the ledger below `reconcile/`.
    name: String,
    kind: Kind,
    /// What was done.
    change: String,
    /// Public keys, authorities' certificates and revocation lists to trust.
    trust: Vec<String>,
    /// Checkpoints kept elsewhere, inputs to compare, or the published folders that are left.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    beside: Vec<String>,
    /// Further options of the verification, as the command line has them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    options: Vec<String>,
    /// Codes that must be among the errors and warnings; none for a pass.
    expect: Vec<String>,
    /// Codes that must be among the notes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    exit_code: u8,
    /// Algorithms that a verifier has to know for this; one that does not must refuse (`ALG_REFUSED`).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    needs: Vec<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Folder,
    Ledger,
    Reconcile,
}

impl Kind {
    /// Where the cases of this kind stand.
    fn folder(self) -> &'static str {
        match self {
            Kind::Folder => "folder",
            Kind::Ledger => "ledger",
            Kind::Reconcile => "reconcile",
        }
    }
}

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/vectors/tamper")
}

/// What a verification gives: the codes of its errors and warnings, those of its notes, its exit code, its words.
struct Judged {
    codes: Vec<String>,
    notes: Vec<String>,
    exit_code: u8,
    words: String,
}

fn run(root: &Path, case: &Case) -> Judged {
    judge(root, case).map_or_else(
        |error| {
            let code = error.found.split(':').next().unwrap_or_default().to_owned();
            let words = error.to_string();
            Judged { codes: vec![code], notes: Vec::new(), exit_code: error.kind.exit_code(), words }
        },
        |report| {
            let (notes, codes): (Vec<_>, Vec<_>) = report.findings.iter().partition(|f| f.severity == Severity::Note);
            let names = |found: Vec<&Finding>| found.into_iter().map(|f| f.code.to_owned()).collect();
            let words = report.to_text();
            Judged { codes: names(codes), notes: names(notes), exit_code: report.exit_code, words }
        },
    )
}

fn judge(root: &Path, case: &Case) -> crate::Result<Report> {
    let dir = tempfile::tempdir().unwrap();
    let data = DataFolder::at(dir.path());
    let entry = Entry { schema: trust::SCHEMA.into(), ..Entry::default() };
    for name in &case.trust {
        trust::add_file(&data, &root.join(name), &entry)?;
    }
    let value = |name: &str| case.options.iter().position(|o| o == name).map(|at| case.options[at + 1].as_str());
    let has = |name: &str| case.options.iter().any(|o| o == name);
    let trust = TrustStore::load(&data, &[])?.expect(value("--trust-store"))?;
    let models: Option<Vec<String>> = value("--models").map(|name| allowed::read(&root.join(name))).transpose()?;
    let policy = Policy {
        require_time_sync: has("--require-time-sync"),
        require_inputs: has("--require-inputs"),
        models: models.as_deref(),
        time_grace_ms: value("--time-grace").map(|seconds| seconds.parse::<u64>().unwrap() * 1000),
    };
    let beside: Vec<PathBuf> = case.beside.iter().map(|name| root.join(name)).collect();
    let weights: Vec<PathBuf> = value("--weights").map(|name| root.join(name)).into_iter().collect();
    let program = value("--program").map(|name| root.join(name));
    match case.kind {
        Kind::Folder => {
            let folder = root.join(case.kind.folder()).join(&case.name);
            let request = Request::new(&folder, &trust, NOW_MS);
            verify(&Request { inputs: &beside, weights: &weights, program: program.as_deref(), policy, ..request })
        }
        Kind::Ledger => verify_ledger(&LedgerRequest {
            ledger: &root.join(case.kind.folder()).join(&case.name).join("orb-ledger.jsonl"),
            trust: &trust,
            checkpoints: &beside,
            require_anchor: false,
            now_ms: NOW_MS,
            strict: false,
            policy,
        }),
        Kind::Reconcile => {
            reconcile(&root.join(case.kind.folder()).join(&case.name).join("orb-ledger.jsonl"), &beside, &trust)
        }
    }
}

fn cases(root: &Path) -> Vec<Case> {
    serde_json::from_slice(&fs::read(root.join("cases.json")).unwrap()).unwrap()
}

#[test]
fn every_change_in_the_corpus_is_reported() {
    let root = corpus();
    let cases = cases(&root);
    assert!(cases.len() >= 90, "{}", cases.len());
    for case in &cases {
        let Judged { codes, notes, exit_code, words } = run(&root, case);
        if cfg!(feature = "fips") && !case.needs.is_empty() {
            assert_eq!((codes, exit_code), (vec!["ALG_REFUSED".into()], 4), "{}: {words}", case.name);
            continue;
        }
        assert_eq!(exit_code, case.exit_code, "{}: {words}", case.name);
        for code in &case.expect {
            assert!(codes.contains(code), "{}: {code} in {codes:?}", case.name);
        }
        for code in &case.notes {
            assert!(notes.contains(code), "{}: {code} in {notes:?}", case.name);
        }
        assert_eq!(codes.is_empty(), case.expect.is_empty(), "{}: {codes:?}", case.name);
    }
}
