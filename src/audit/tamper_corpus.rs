//! The tamper corpus under `tests/vectors/tamper`: published folders and ledgers, changed in every way that a record is
//! meant to show, each with the codes that a verification must report. Others can run it: `cases.json` says how.
//!
//! `cargo test make_the_tamper_corpus -- --ignored` makes it anew, with new keys.

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::dsse::{Envelope, PAYLOAD_TYPE};
use super::keys::tests::{other_key, shared_key};
use super::keys::{Bits, KeySource, PublicKey, SigningKey};
use super::ledger::Ledger;
use super::ledger_check::tests::{forged, ledger};
use super::ledger_check::{LedgerRequest, verify_ledger};
use super::publication::tests::publish;
use super::publication::{RECORD, RECORD_PROOF};
use super::report::{Report, Severity};
use super::trust::TrustStore;
use super::verify::tests::{forge, payload, sign_payload};
use super::verify::{Request, verify};
use super::{Policy, canonical, disk};

/// Any time after the corpus's records.
const NOW_MS: u64 = 1_763_700_000_000;

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    /// The folder below `folder/` or `ledger/`.
    name: String,
    kind: Kind,
    /// What was done.
    change: String,
    /// Public keys to trust.
    trust: Vec<String>,
    /// Checkpoints kept elsewhere, or inputs to compare.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    beside: Vec<String>,
    /// Codes that must be among the errors and warnings; none for a pass.
    expect: Vec<String>,
    exit_code: u8,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Folder,
    Ledger,
}

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/vectors/tamper")
}

fn run(root: &Path, case: &Case) -> Report {
    let mut trust = TrustStore::default();
    for name in &case.trust {
        trust.insert(PublicKey::from_pem(&fs::read_to_string(root.join(name)).unwrap()).unwrap());
    }
    let beside: Vec<PathBuf> = case.beside.iter().map(|name| root.join(name)).collect();
    match case.kind {
        Kind::Folder => {
            let folder = root.join("folder").join(&case.name);
            let request = Request {
                folder: &folder,
                trust: &trust,
                inputs: &beside,
                store: None,
                now_ms: NOW_MS,
                strict: false,
                policy: Policy::default(),
            };
            verify(&request).unwrap()
        }
        Kind::Ledger => verify_ledger(&LedgerRequest {
            ledger: &root.join("ledger").join(&case.name).join("orb-ledger.jsonl"),
            trust: &trust,
            checkpoints: &beside,
            require_anchor: false,
            now_ms: NOW_MS,
            strict: false,
            policy: Policy::default(),
        })
        .unwrap(),
    }
}

#[test]
fn every_change_in_the_corpus_is_reported() {
    let root = corpus();
    let cases: Vec<Case> = serde_json::from_slice(&fs::read(root.join("cases.json")).unwrap()).unwrap();
    assert!(cases.len() >= 30);
    for case in &cases {
        let report = run(&root, case);
        let codes: Vec<&str> =
            report.findings.iter().filter(|f| f.severity != Severity::Note).map(|f| f.code).collect();
        assert_eq!(report.exit_code, case.exit_code, "{}: {}", case.name, report.to_text());
        for code in &case.expect {
            assert!(codes.contains(&code.as_str()), "{}: {code} in {codes:?}", case.name);
        }
        assert_eq!(codes.is_empty(), case.expect.is_empty(), "{}: {codes:?}", case.name);
    }
}

/// Changes that only an unsigned record can have: the payload inside the envelope, its signature left.
fn unsigned(folder: &Path, change: impl FnOnce(&mut Envelope)) {
    let path = folder.join(RECORD);
    let mut envelope = Envelope::parse(&fs::read(&path).unwrap()).unwrap();
    change(&mut envelope);
    fs::write(path, envelope.to_line()).unwrap();
}

fn edited(envelope: &mut Envelope, rehash: bool, change: impl FnOnce(&mut Value)) {
    let mut value: Value = serde_json::from_slice(&envelope.payload).unwrap();
    change(&mut value);
    if rehash {
        value["predicate"].as_object_mut().unwrap().remove("trail_hash");
        let hash = canonical::sha256_hex(&serde_json_canonicalizer::to_vec(&value).unwrap());
        value["predicate"]["trail_hash"] = json!(hash);
    }
    envelope.payload = serde_json_canonicalizer::to_vec(&value).unwrap();
}

fn text_of(folder: &Path) -> String {
    String::from_utf8(serde_json_canonicalizer::to_vec(&payload(folder)).unwrap()).unwrap()
}

type Folder<'a> = (&'a str, &'a str, &'a [&'a str], u8, fn(&Path, &SigningKey));

/// Name, what was done, what must be reported, the exit code, and the doing.
const FOLDERS: [Folder<'_>; 23] = [
    ("good", "nothing", &[], 0, |_, _| {}),
    ("field-edited", "a parameter, the signature left", &["SIG_INVALID", "TRAIL_HASH_MISMATCH"], 1, |f, _| {
        unsigned(f, |e| edited(e, false, |v| v["predicate"]["params"]["seed"] = json!(8)));
    }),
    ("field-edited-and-rehashed", "a parameter and the trail hash, no key", &["SIG_INVALID"], 1, |f, _| {
        unsigned(f, |e| edited(e, true, |v| v["predicate"]["params"]["seed"] = json!(8)));
    }),
    ("respelled", "the same words, indented", &["SIG_INVALID", "NOT_CANONICAL"], 1, |f, _| {
        unsigned(f, |e| {
            let value: Value = serde_json::from_slice(&e.payload).unwrap();
            e.payload = serde_json::to_vec_pretty(&value).unwrap();
        });
    }),
    ("payload-type", "another payload type", &["TYPE_UNSUPPORTED", "SIG_INVALID"], 1, |f, _| {
        unsigned(f, |e| e.payload_type = "application/json".into());
    }),
    ("key-twice", "a key twice, properly signed", &["SCHEMA_INVALID"], 1, |f, _| {
        let text = text_of(f).replacen("\"seed\":7", "\"seed\":7,\"seed\":8", 1);
        sign_payload(f, text.as_bytes(), shared_key().public().fingerprint(), shared_key());
    }),
    ("unknown-key", "a key that no reader knows, properly signed", &["SCHEMA_INVALID"], 1, |f, _| {
        forge(f, shared_key(), |v| v["predicate"]["also"] = json!("yes"));
    }),
    ("integer-too-large", "2^53 as a parameter, properly signed", &["SCHEMA_INVALID"], 1, |f, _| {
        let text = text_of(f).replacen("\"seed\":7", "\"seed\":9007199254740992", 1);
        sign_payload(f, text.as_bytes(), shared_key().public().fingerprint(), shared_key());
    }),
    ("fraction", "a fraction as a parameter, properly signed", &["SCHEMA_INVALID"], 1, |f, _| {
        let text = text_of(f).replacen("\"seed\":7", "\"seed\":7.5", 1);
        sign_payload(f, text.as_bytes(), shared_key().public().fingerprint(), shared_key());
    }),
    ("too-deep", "200 lists in one another, properly signed", &["LIMIT_EXCEEDED"], 1, |f, _| {
        let text = format!("{}{}", "[".repeat(200), "]".repeat(200));
        sign_payload(f, text.as_bytes(), shared_key().public().fingerprint(), shared_key());
    }),
    ("output-replaced", "an output's last byte", &["OUTPUT_DIGEST"], 1, |f, _| {
        let mut bytes = fs::read(f.join("scene.ply")).unwrap();
        *bytes.last_mut().unwrap() ^= 1;
        fs::write(f.join("scene.ply"), bytes).unwrap();
    }),
    ("output-removed", "an output removed", &["OUTPUT_MISSING"], 1, |f, _| {
        fs::remove_file(f.join("scene.ply")).unwrap();
    }),
    ("output-added", "a file that the record does not list", &["OUTPUT_EXTRA"], 0, |f, _| {
        fs::write(f.join("extra.bin"), b"extra").unwrap();
    }),
    ("unknown-signer", "signed again by an unknown key", &["KEY_UNTRUSTED"], 1, |f, unknown| {
        forge(f, unknown, |v| v["predicate"]["actor"]["key_fingerprint"] = json!(unknown.public().fingerprint()));
    }),
    ("other-signer", "signed again by another trusted key", &["SIGNER_MISMATCH"], 1, |f, _| {
        forge(f, other_key(), |_| {});
    }),
    ("wrong-keyid", "one key's name on another's signature", &["SIG_INVALID"], 1, |f, unknown| {
        sign_payload(f, text_of(f).as_bytes(), shared_key().public().fingerprint(), unknown);
    }),
    ("algorithm", "another algorithm's name, properly signed", &["ALG_REFUSED"], 4, |f, _| {
        forge(f, shared_key(), |v| v["predicate"]["actor"]["algorithm"] = json!("RS1"));
    }),
    ("marking-lowered", "an input above the product, properly signed", &["MARKING_DOWNGRADE"], 1, |f, _| {
        forge(f, shared_key(), |v| v["predicate"]["inputs"][0]["marking"] = json!("SECRET"));
    }),
    ("marking-edited", "the banner, the signature left", &["SIG_INVALID"], 1, |f, _| {
        unsigned(f, |e| edited(e, true, |v| v["predicate"]["marking"]["banner"] = json!("CUI")));
    }),
    ("marking-inside", "the banner inside an output", &["OUTPUT_DIGEST", "MARKING_INBAND_MISMATCH"], 1, |f, _| {
        let bytes = fs::read(f.join("scene.ply")).unwrap();
        let text = String::from_utf8_lossy(&bytes).replacen("UNCLASSIFIED", "UNCLASSIFIEB", 1);
        fs::write(f.join("scene.ply"), text).unwrap();
    }),
    ("name-leaves-the-folder", "an output's name with .., properly signed", &["PATH_REFUSED"], 1, |f, _| {
        forge(f, shared_key(), |v| v["subject"][1]["name"] = json!("../good/scene.ply"));
    }),
    ("other-proof", "another record's proof", &["PROOF_INVALID"], 1, |f, _| {
        let good = fs::read(f.join(RECORD_PROOF)).unwrap();
        let text = String::from_utf8(good).unwrap().replacen("\"index\":0", "\"index\":1", 1);
        fs::write(f.join(RECORD_PROOF), text).unwrap();
    }),
    ("record-removed", "the record removed", &["RECORD_MISSING"], 3, |f, _| {
        fs::remove_file(f.join(RECORD)).unwrap();
    }),
];

type LedgerCase<'a> = (&'a str, &'a str, &'a [&'a str], u8, fn(&[String]) -> String, Keeps);

/// What is left of the checkpoints of the ledger as it was.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Keeps {
    Nothing,
    Head,
    Elsewhere,
}

/// Name, what was done, what must be reported, the exit code, the lines that are left, and the checkpoints.
const LEDGERS: [LedgerCase<'_>; 13] = [
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

fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in disk::walk(from).unwrap() {
        let place = to.join(&entry.name);
        if entry.is_dir {
            fs::create_dir_all(place).unwrap();
        } else {
            fs::copy(entry.path, place).unwrap();
        }
    }
}

#[test]
#[ignore = "writes the corpus anew"]
fn make_the_tamper_corpus() {
    let root = corpus();
    for part in ["folder", "ledger"] {
        let _ = fs::remove_dir_all(root.join(part));
        fs::create_dir_all(root.join(part)).unwrap();
    }
    let unknown = SigningKey::generate(KeySource::NamedFile, Bits::default()).unwrap();
    fs::write(root.join("trusted.pub.pem"), shared_key().public().to_pem()).unwrap();
    fs::write(root.join("also-trusted.pub.pem"), other_key().public().to_pem()).unwrap();
    fs::write(root.join("photo.jpg"), b"photo").unwrap();
    fs::write(root.join("other-photo.jpg"), b"another photo").unwrap();
    let case = |name: &str, kind, change: &str, expect: &[&str], exit_code| Case {
        name: name.into(),
        kind,
        change: change.into(),
        trust: vec!["trusted.pub.pem".into(), "also-trusted.pub.pem".into()],
        beside: Vec::new(),
        expect: expect.iter().map(|code| (*code).to_owned()).collect(),
        exit_code,
    };
    let mut cases = Vec::new();
    let dir = tempfile::tempdir().unwrap();
    publish(dir.path());
    for (name, change, expect, exit_code, act) in FOLDERS {
        let folder = root.join("folder").join(name);
        copy_folder(&dir.path().join("out"), &folder);
        act(&folder, &unknown);
        let mut case = case(name, Kind::Folder, change, expect, exit_code);
        case.beside = vec!["photo.jpg".into()];
        cases.push(case);
    }
    copy_folder(&dir.path().join("out"), &root.join("folder/another-photo"));
    let mut photo = case("another-photo", Kind::Folder, "made from another photo", &["INPUT_DIGEST"], 1);
    photo.beside = vec!["other-photo.jpg".into()];
    cases.push(photo);
    copy_folder(&dir.path().join("out"), &root.join("folder/nobody-trusted"));
    let mut nobody = case("nobody-trusted", Kind::Folder, "no key is trusted", &["TRUST_STORE_EMPTY"], 3);
    nobody.trust.clear();
    cases.push(nobody);

    let (_dir, path) = ledger(4);
    let lines: Vec<String> = fs::read_to_string(&path).unwrap().lines().map(|l| format!("{l}\n")).collect();
    let checkpoint = Ledger::at(path.clone()).checkpoint().unwrap().unwrap().sign(shared_key()).unwrap();
    fs::write(root.join("kept.dsse.json"), checkpoint.to_line()).unwrap();
    for (name, change, expect, exit_code, text, keeps) in LEDGERS {
        let folder = root.join("ledger").join(name);
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("orb-ledger.jsonl"), text(&lines)).unwrap();
        if keeps == Keeps::Head {
            fs::copy(path.with_file_name("head.json"), folder.join("head.json")).unwrap();
        }
        let mut case = case(name, Kind::Ledger, change, expect, exit_code);
        if keeps == Keeps::Elsewhere {
            case.beside = vec!["kept.dsse.json".into()];
        }
        cases.push(case);
    }
    let mut text = serde_json::to_string_pretty(&cases).unwrap();
    text.push('\n');
    fs::write(root.join("cases.json"), text).unwrap();
    assert_eq!(PAYLOAD_TYPE, "application/vnd.in-toto+json");
}
