//! The tamper corpus under `tests/vectors/tamper`: published folders and ledgers, changed in every way that a record is
//! meant to show, each with the codes that a verification must report. Others can run it: `cases.json` says how.
//!
//! `cargo test make_the_tamper_corpus -- --ignored` makes it anew, with new keys.

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::dsse::{Envelope, PAYLOAD_TYPE, Signature};
use super::keys::tests::{other_key, shared_key};
use super::keys::{Bits, KeySource, SigningKey};
use super::ledger::Ledger;
use super::ledger_check::tests::{forged, ledger};
use super::ledger_check::{LedgerRequest, verify_ledger};
use super::publication::tests::{destination, fill, publish};
use super::publication::{Publication, RECORD, RECORD_PAE, RECORD_PROOF, RECORD_SIG};
use super::record::tests::draft;
use super::report::{Report, Severity};
use super::trust::tests::Pki;
use super::trust::{self, Entry, TrustStore};
use super::verify::tests::{forge, payload, sign_payload};
use super::verify::{Request, verify};
use super::{DataFolder, Policy, canonical, disk};

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
    /// Public keys, authorities' certificates and revocation lists to trust.
    trust: Vec<String>,
    /// Checkpoints kept elsewhere, or inputs to compare.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    beside: Vec<String>,
    /// Further options of the verification, as the command line has them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    options: Vec<String>,
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

/// What a verification gives: the codes of its errors and warnings, its exit code, its words.
fn run(root: &Path, case: &Case) -> (Vec<String>, u8, String) {
    judge(root, case).map_or_else(
        |error| {
            let code = error.found.split(':').next().unwrap_or_default().to_owned();
            (vec![code], error.kind.exit_code(), error.to_string())
        },
        |report| {
            let weighty = report.findings.iter().filter(|f| f.severity != Severity::Note);
            (weighty.map(|f| f.code.to_owned()).collect(), report.exit_code, report.to_text())
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
    let models: Option<Vec<String>> =
        value("--models").map(|name| fs::read_to_string(root.join(name)).unwrap().lines().map(str::to_owned).collect());
    let policy = Policy {
        require_time_sync: has("--require-time-sync"),
        require_inputs: has("--require-inputs"),
        models: models.as_deref(),
    };
    let beside: Vec<PathBuf> = case.beside.iter().map(|name| root.join(name)).collect();
    let weights: Vec<PathBuf> = value("--weights").map(|name| root.join(name)).into_iter().collect();
    match case.kind {
        Kind::Folder => {
            let folder = root.join("folder").join(&case.name);
            verify(&Request { inputs: &beside, weights: &weights, policy, ..Request::new(&folder, &trust, NOW_MS) })
        }
        Kind::Ledger => verify_ledger(&LedgerRequest {
            ledger: &root.join("ledger").join(&case.name).join("orb-ledger.jsonl"),
            trust: &trust,
            checkpoints: &beside,
            require_anchor: false,
            now_ms: NOW_MS,
            strict: false,
            policy,
        }),
    }
}

#[test]
fn every_change_in_the_corpus_is_reported() {
    let root = corpus();
    let cases: Vec<Case> = serde_json::from_slice(&fs::read(root.join("cases.json")).unwrap()).unwrap();
    assert!(cases.len() >= 50, "{}", cases.len());
    for case in &cases {
        let (codes, exit_code, words) = run(&root, case);
        assert_eq!(exit_code, case.exit_code, "{}: {words}", case.name);
        for code in &case.expect {
            assert!(codes.contains(code), "{}: {code} in {codes:?}", case.name);
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
const FOLDERS: [Folder<'_>; 29] = [
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
    ("name-from-the-root", "an absolute name of an output, properly signed", &["PATH_REFUSED"], 1, |f, _| {
        forge(f, shared_key(), |v| v["subject"][1]["name"] = json!("/scene.ply"));
    }),
    ("countersigned", "a second good signature, by another trusted key", &[], 0, |f, _| {
        unsigned(f, |e| countersign(e, other_key(), other_key().public().fingerprint()));
    }),
    ("one-of-two-wrong", "a second signature that is bad", &["SIG_INVALID"], 1, |f, unknown| {
        unsigned(f, |e| countersign(e, unknown, other_key().public().fingerprint()));
    }),
    ("one-of-two-unknown", "a second signature, by an unknown key", &["KEY_UNTRUSTED"], 1, |f, unknown| {
        unsigned(f, |e| countersign(e, unknown, unknown.public().fingerprint()));
    }),
    ("sha-1", "signed with SHA-1 by the trusted key", &["ALG_REFUSED"], 4, |f, _| {
        sign_by_openssl(f, &["-sha1"]);
    }),
    ("other-padding", "signed with the padding of PSS by the trusted key", &["ALG_REFUSED"], 4, |f, _| {
        sign_by_openssl(f, &["-sha256", "-sigopt", "rsa_padding_mode:pss", "-sigopt", "rsa_pss_saltlen:digest"]);
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

fn countersign(envelope: &mut Envelope, key: &SigningKey, keyid: &str) {
    let sig = key.sign(&envelope.pae()).unwrap();
    envelope.signatures.push(Signature { keyid: keyid.into(), sig });
}

/// The trusted key's signature, made another way.
fn sign_by_openssl(folder: &Path, how: &[&str]) {
    let dir = tempfile::tempdir().unwrap();
    let (key, sig) = (dir.path().join("key.pem"), dir.path().join("sig"));
    shared_key().save(&key, None).unwrap();
    let mut openssl = std::process::Command::new("openssl");
    openssl.arg("dgst").args(how).arg("-sign").arg(&key).arg("-out").arg(&sig).arg(folder.join(RECORD_PAE));
    assert!(openssl.status().unwrap().success());
    let sig = fs::read(sig).unwrap();
    fs::write(folder.join(RECORD_SIG), &sig).unwrap();
    unsigned(folder, |e| e.signatures[0].sig = sig);
}

type Extra<'a> = (&'a str, &'a str, &'a [&'a str], &'a [&'a str], &'a [&'a str], &'a [&'a str], u8);

const TRUSTED: [&str; 2] = ["trusted.pub.pem", "also-trusted.pub.pem"];
const PHOTO: &[&str] = &["photo.jpg"];
const NO_STORE: &str = "0000000000000000000000000000000000000000000000000000000000000000";

/// Folders as published, each verified in another way: name, what is another, whom to trust, the inputs given, options, what
/// must be reported, the exit code.
const VERIFIED_OTHERWISE: [Extra<'_>; 9] = [
    ("another-photo", "made from another photo", &TRUSTED, &["other-photo.jpg"], &[], &["INPUT_DIGEST"], 1),
    ("photo-removed", "the photo is gone", &TRUSTED, &[], &["--require-inputs"], &["INPUT_MISSING"], 3),
    ("nobody-trusted", "no key is trusted", &[], PHOTO, &[], &["TRUST_STORE_EMPTY"], 3),
    ("short-key", "a key of 1024 bits is to be trusted", &["short.pub.pem"], PHOTO, &[], &["ALG_REFUSED"], 4),
    (
        "exponent-3",
        "a key with the exponent 3 is to be trusted",
        &["exponent-3.pub.pem"],
        PHOTO,
        &[],
        &["ALG_REFUSED"],
        4,
    ),
    (
        "trust-store-swapped",
        "another trust store than the one that was pinned",
        &TRUSTED,
        PHOTO,
        &["--trust-store", NO_STORE],
        &["TRUST_STORE_CHANGED"],
        4,
    ),
    ("weights-as-used", "nothing", &TRUSTED, PHOTO, &["--weights", "weights.bin"], &[], 0),
    ("weights-swapped", "other weights", &TRUSTED, PHOTO, &["--weights", "other-weights.bin"], &["MODEL_DIGEST"], 1),
    (
        "weights-not-allowed",
        "weights that are not on the list",
        &TRUSTED,
        PHOTO,
        &["--models", "allowed.txt"],
        &["MODEL_NOT_ALLOWED"],
        4,
    ),
];

/// Folders signed under certificates of OpenSSL's making: one that had expired, one that was revoked from before on, and a
/// good one.
fn signed_under_certificates(root: &Path, cases: &mut Vec<Case>) {
    let all = [
        ("certificate-good", "nothing", "20280101000000Z", None, &[][..], 0),
        ("certificate-expired", "a certificate that had expired", "20250601000000Z", None, &["CERT_EXPIRED"][..], 1),
        (
            "certificate-revoked",
            "a certificate revoked because of a compromise before",
            "20280101000000Z",
            Some("20250901000000Z"),
            &["CERT_REVOKED"],
            1,
        ),
    ];
    for (name, change, until, compromised, expect, exit_code) in all {
        let pki = Pki::new().unwrap();
        pki.sign("leaf", "issuing", "leaf", "20250101000000Z", until);
        fs::write(pki.path("chain.pem"), pki.chain()).unwrap();
        let key = SigningKey::load(&pki.path("leaf.key"), KeySource::NamedFile).unwrap();
        let key = key.with_chain(&pki.path("chain.pem")).unwrap();
        let mut publication = Publication::begin(&destination(&pki.path("out"))).unwrap();
        fill(&mut publication).unwrap();
        publication.seal(&draft(), &key, &mut Ledger::at(pki.path("orb-ledger.jsonl"))).unwrap();
        copy_folder(&pki.path("out"), &root.join("folder").join(name));
        let authority = format!("{name}-authority.pem");
        fs::copy(pki.path("root.pem"), root.join(&authority)).unwrap();
        let mut trust = vec![authority];
        if let Some(time) = compromised {
            let list = format!("{name}.crl.pem");
            fs::copy(pki.revoke(Some(time)), root.join(&list)).unwrap();
            trust.push(list);
        }
        let trust: Vec<&str> = trust.iter().map(String::as_str).collect();
        cases.push(case(name, Kind::Folder, change, &trust, PHOTO, &[], expect, exit_code));
    }
}

#[expect(clippy::too_many_arguments, reason = "a line of a table")]
fn case(
    name: &str,
    kind: Kind,
    change: &str,
    trust: &[&str],
    beside: &[&str],
    options: &[&str],
    expect: &[&str],
    exit_code: u8,
) -> Case {
    let owned = |words: &[&str]| words.iter().map(|w| (*w).to_owned()).collect();
    Case {
        name: name.into(),
        kind,
        change: change.into(),
        trust: owned(trust),
        beside: owned(beside),
        options: owned(options),
        expect: owned(expect),
        exit_code,
    }
}

type LedgerCase<'a> = (&'a str, &'a str, &'a [&'a str], u8, fn(&[String]) -> String, Keeps);

/// What is left of the checkpoints of the ledger as it was.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Keeps {
    Nothing,
    Head,
    Elsewhere,
}

/// Name, what was done, what must be reported, the exit code, the lines that are left, and the checkpoints.
const LEDGERS: [LedgerCase<'_>; 14] = [
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
    for name in ["cases.json", "kept.dsse.json"] {
        let _ = fs::remove_file(root.join(name));
    }
    let unknown = SigningKey::generate(KeySource::NamedFile, Bits::default()).unwrap();
    fs::write(root.join("trusted.pub.pem"), shared_key().public().to_pem()).unwrap();
    fs::write(root.join("also-trusted.pub.pem"), other_key().public().to_pem()).unwrap();
    fs::write(root.join("photo.jpg"), b"photo").unwrap();
    fs::write(root.join("other-photo.jpg"), b"another photo").unwrap();
    fs::write(root.join("weights.bin"), b"w").unwrap();
    fs::write(root.join("other-weights.bin"), b"v").unwrap();
    fs::write(root.join("allowed.txt"), format!("{}\n", canonical::sha256_hex(b"v"))).unwrap();
    let openssl = |args: &[&str]| {
        assert!(std::process::Command::new("openssl").args(args).current_dir(&root).status().unwrap().success());
    };
    for (name, bits, exponent) in [("short", "1024", "65537"), ("exponent-3", "3072", "3")] {
        let (bits, exponent) = (format!("rsa_keygen_bits:{bits}"), format!("rsa_keygen_pubexp:{exponent}"));
        openssl(&["genpkey", "-algorithm", "RSA", "-pkeyopt", &bits, "-pkeyopt", &exponent, "-out", "private.pem"]);
        openssl(&["pkey", "-in", "private.pem", "-pubout", "-out", &format!("{name}.pub.pem")]);
        fs::remove_file(root.join("private.pem")).unwrap();
    }
    let mut cases = Vec::new();
    let dir = tempfile::tempdir().unwrap();
    publish(dir.path());
    let copied = |name: &str| {
        let folder = root.join("folder").join(name);
        copy_folder(&dir.path().join("out"), &folder);
        folder
    };
    for (name, change, expect, exit_code, act) in FOLDERS {
        act(&copied(name), &unknown);
        cases.push(case(name, Kind::Folder, change, &TRUSTED, PHOTO, &[], expect, exit_code));
    }
    for (name, change, trust, beside, options, expect, exit_code) in VERIFIED_OTHERWISE {
        copied(name);
        cases.push(case(name, Kind::Folder, change, trust, beside, options, expect, exit_code));
    }
    let name = "clock-unsynchronised";
    forge(&copied(name), shared_key(), |v| v["predicate"]["time"]["sync_status"] = json!("unsynchronised"));
    let change = "a clock that was not known to be right, properly signed";
    let options = &["--require-time-sync"];
    cases.push(case(name, Kind::Folder, change, &TRUSTED, PHOTO, options, &["TIME_UNSYNCED"], 4));
    signed_under_certificates(&root, &mut cases);

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
        let beside: &[&str] = if keeps == Keeps::Elsewhere { &["kept.dsse.json"] } else { &[] };
        cases.push(case(name, Kind::Ledger, change, &TRUSTED, beside, &[], expect, exit_code));
    }
    // Of these there is no file.
    let deleted = "the whole ledger removed";
    let kept = "the whole ledger removed; a checkpoint was kept";
    cases.push(case("deleted", Kind::Ledger, kept, &TRUSTED, &["kept.dsse.json"], &[], &["TRUNCATED"], 1));
    cases.push(case("deleted-unseen", Kind::Ledger, deleted, &TRUSTED, &[], &[], &["RECORD_MISSING"], 3));
    let mut text = serde_json::to_string_pretty(&cases).unwrap();
    text.push('\n');
    fs::write(root.join("cases.json"), text).unwrap();
    assert_eq!(PAYLOAD_TYPE, "application/vnd.in-toto+json");
}
