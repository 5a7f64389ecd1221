use serde_json::{Value, json};
use tempfile::TempDir;

use super::*;
use crate::Kind;
use crate::audit::dsse::{self, Signature};
use crate::audit::keys::SigningKey;
use crate::audit::keys::tests::{other_key, shared_key};
use crate::audit::merkle::{self, Frontier};
use crate::audit::publication::MARKING_SIDECAR;
use crate::audit::publication::tests::{destination, fill, ledger, ply, publish};
use crate::audit::record::{Sealed, tests::draft};
use crate::audit::report::{Severity, Verdict};
use crate::audit::store_merge::{lock_store, merge_into_store};
use crate::audit::{Publication, canonical};

const NOW_MS: u64 = 1_763_688_582_120;

fn trusting(keys: &[&SigningKey]) -> TrustStore {
    let mut store = TrustStore::default();
    for key in keys {
        store.insert(key.public().clone());
    }
    store
}

fn request<'a>(folder: &'a Path, trust: &'a TrustStore) -> Request<'a> {
    Request::new(folder, trust, NOW_MS)
}

/// A folder published with the shared key, in `dir/out`.
fn published() -> (TempDir, PathBuf) {
    let dir = tempfile::tempdir().unwrap();
    publish(dir.path());
    let out = dir.path().join("out");
    (dir, out)
}

fn check(folder: &Path) -> Report {
    verify(&request(folder, &trusting(&[shared_key()]))).unwrap()
}

fn codes(report: &Report) -> Vec<&'static str> {
    report.findings.iter().filter(|f| f.severity != Severity::Note).map(|f| f.code).collect()
}

/// Writes `payload` as a record that `key` signed, with everything beside it.
pub(crate) fn sign_payload(folder: &Path, payload: &[u8], keyid: &str, key: &SigningKey) {
    let pae = dsse::pae(PAYLOAD_TYPE, payload);
    let sig = key.sign(&pae).unwrap();
    let signatures = vec![Signature { keyid: keyid.into(), sig: sig.clone() }];
    let envelope = Envelope { payload: payload.into(), payload_type: PAYLOAD_TYPE.into(), signatures };
    fs::write(folder.join(RECORD), envelope.to_line()).unwrap();
    fs::write(folder.join(RECORD_PAE), pae).unwrap();
    fs::write(folder.join(RECORD_SIG), sig).unwrap();
    fs::write(folder.join(RECORD_KEY), key.public().to_pem()).unwrap();
    fs::remove_file(folder.join(RECORD_PROOF)).unwrap();
    if let Ok((statement, _)) = Statement::parse(payload) {
        // A proof that fits what the record states, as its ledger's owner could make.
        let mut before = Frontier::default();
        (0..statement.predicate.chain.seq).for_each(|i| before.push(merkle::leaf(&i.to_be_bytes())));
        let trail_hash = statement.predicate.trail_hash.clone().unwrap();
        let proof = Proof::of_next(&before, &Sealed { statement, envelope, trail_hash }, key).unwrap();
        fs::write(folder.join(RECORD_PROOF), proof.to_line()).unwrap();
    } else {
        fs::write(folder.join(RECORD_PROOF), "").unwrap();
    }
}

pub(crate) fn payload(folder: &Path) -> Value {
    let bytes = fs::read(folder.join(RECORD)).unwrap();
    serde_json::from_slice(&Envelope::parse(&bytes).unwrap().payload).unwrap()
}

/// Changes the record and signs it again properly: what the holder of the key could do.
pub(crate) fn forge(folder: &Path, key: &SigningKey, change: impl FnOnce(&mut Value)) {
    let mut value = payload(folder);
    change(&mut value);
    let predicate = value["predicate"].as_object_mut().unwrap();
    predicate.remove("trail_hash");
    let trail_hash = canonical::sha256_hex(&serde_json_canonicalizer::to_vec(&value).unwrap());
    value["predicate"]["trail_hash"] = json!(trail_hash);
    let bytes = serde_json_canonicalizer::to_vec(&value).unwrap();
    sign_payload(folder, &bytes, key.public().fingerprint(), key);
}

#[test]
fn what_was_published_verifies() {
    let (_dir, out) = published();
    let report = check(&out);
    assert_eq!((report.verdict, report.exit_code), (Verdict::Pass, 0), "{}", report.to_text());
    assert_eq!(codes(&report), [""; 0]);
    let c = report.counts;
    assert_eq!((c.outputs_listed, c.outputs_verified, c.inputs_listed, c.inputs_verified), (3, 3, 1, 0));
    let text = report.to_text();
    assert!(text.starts_with("UNCLASSIFIED\nPASS: ") && text.ends_with("UNCLASSIFIED\n"), "{text}");
    assert!(text.contains("not an authorisation") && text.contains("tail unanchored"));
}

#[test]
fn the_report_as_json() {
    let (dir, out) = published();
    let photo = dir.path().join("van.jpg");
    fs::write(&photo, b"photo").unwrap();
    let trust = trusting(&[shared_key()]);
    let mut r = request(&out, &trust);
    let inputs = [photo];
    r.inputs = &inputs;
    let value: Value = serde_json::from_str(&verify(&r).unwrap().to_json()).unwrap();
    assert_eq!(value["schema"], "orb.verify/v1");
    assert_eq!(value["verdict"], "pass");
    assert_eq!(value["exit_code"], 0);
    assert_eq!(value["range"], json!({"first": 0, "last": 0}));
    assert_eq!(value["anchored_through"], Value::Null);
    assert_eq!(value["marking"], "UNCLASSIFIED");
    assert_eq!(value["counts"]["inputs_verified"], 1);
    assert_eq!(value["findings"][0]["code"], "TAIL_UNANCHORED");
    assert_eq!(value["findings"][0]["severity"], "note");
    assert!(value["trust_store_sha256"].as_str().unwrap().len() == 64);
}

/// A record that is read apart from its verification has to be the same one.
#[test]
fn a_record_exchanged_after_its_verification() {
    let (_dir, out) = published();
    let report = check(&out);
    check_same(&out, &report, &read_record(&out).unwrap().0).unwrap();
    let stated = report.trail_hash.clone().unwrap();
    forge(&out, shared_key(), |v| v["predicate"]["params"] = json!({"seed": 8}));
    let error = check_same(&out, &report, &read_record(&out).unwrap().0).unwrap_err();
    assert!(error.kind == Kind::Integrity && error.found.contains("changed while it was read"), "{error}");
    // The verified one's trail hash on other words.
    let mut value = payload(&out);
    value["predicate"]["trail_hash"] = json!(stated);
    sign_payload(&out, &serde_json_canonicalizer::to_vec(&value).unwrap(), "nobody", other_key());
    assert!(check_same(&out, &report, &read_record(&out).unwrap().0).is_err());
    // Nothing was said of it, so there is nothing to compare.
    let unknown = verify(&request(&out, &TrustStore::default())).unwrap();
    check_same(&out, &unknown, &read_record(&out).unwrap().0).unwrap();
}

/// Certificates beside a record that names none.
#[test]
fn certificates_of_nobody() {
    let (_dir, out) = published();
    fs::write(out.join(RECORD_CHAIN), "-----BEGIN CERTIFICATE-----\nAAAA\n-----END CERTIFICATE-----\n").unwrap();
    assert_eq!((codes(&check(&out)), check(&out).exit_code), (vec!["SEAL_FILE_MISMATCH"], 1));
}

/// One changed byte anywhere: exit 1, and a finding that names the file.
#[test]
fn one_changed_byte_is_found_in_every_file() {
    let (_dir, out) = published();
    let mut regions = 0;
    for entry in disk::walk(&out).unwrap().into_iter().filter(|e| e.is_file) {
        let good = fs::read(&entry.path).unwrap();
        // All of the small files, the ends of each, and steps through the large ones.
        let step = good.len().div_ceil(30);
        let places = (0..good.len()).step_by(step).chain([good.len() - 1, good.len() / 2]);
        for at in places {
            for mask in [0x01, 0x20] {
                let mut bad = good.clone();
                bad[at] ^= mask;
                fs::write(&entry.path, &bad).unwrap();
                let report = check(&out);
                let place = format!("{} byte {at} ^ {mask:#x}", entry.name);
                assert_eq!(report.exit_code, 1, "{place}");
                assert!(
                    report.findings.iter().any(|f| f.subject == entry.name && f.severity == Severity::Error),
                    "{place}: {}",
                    report.to_text()
                );
                regions += 1;
            }
        }
        for bad in [&good[..good.len() - 1], &[], &[good.as_slice(), b"\n"].concat()] {
            fs::write(&entry.path, bad).unwrap();
            let report = check(&out);
            assert_eq!(report.exit_code, 1, "{}", entry.name);
            assert!(report.findings.iter().any(|f| f.subject == entry.name), "{}", entry.name);
        }
        fs::write(&entry.path, &good).unwrap();
    }
    assert!(regions > 300);
    assert_eq!(check(&out).exit_code, 0);
}

#[test]
fn facts_of_an_unverified_record_are_not_reported() {
    let (_dir, out) = published();
    sign_payload(&out, &serde_json_canonicalizer::to_vec(&payload(&out)).unwrap(), "nobody", other_key());
    fs::write(out.join("scene.ply"), "changed").unwrap();
    let report = check(&out);
    assert_eq!(report.exit_code, 1);
    assert_eq!((report.marking, report.signed_by, report.range, report.time), (None, None, None, None));
    // But the change is located.
    assert!(report.findings.iter().any(|f| f.code == "OUTPUT_DIGEST" && f.subject == "scene.ply"));
}

#[test]
fn who_signed() {
    let (_dir, out) = published();
    // By a key that is not trusted.
    forge(&out, other_key(), |v| {
        v["predicate"]["actor"]["key_fingerprint"] = json!(other_key().public().fingerprint())
    });
    let report = check(&out);
    assert!(codes(&report).contains(&"KEY_UNTRUSTED"), "{:?}", codes(&report));
    assert_eq!(report.exit_code, 1);
    // The same once it is trusted, but for the ledger that the first key began.
    let both = trusting(&[shared_key(), other_key()]);
    assert_eq!(codes(&verify(&request(&out, &both)).unwrap()), ["LEDGER_ID"]);
    // By another trusted key than the record names.
    let (_dir, out) = published();
    forge(&out, other_key(), |_| {});
    assert_eq!(codes(&verify(&request(&out, &both)).unwrap()), ["SIGNER_MISMATCH"]);
    // The name of one key on the signature of another.
    let (_dir, out) = published();
    let bytes = serde_json_canonicalizer::to_vec(&payload(&out)).unwrap();
    sign_payload(&out, &bytes, shared_key().public().fingerprint(), other_key());
    assert!(codes(&verify(&request(&out, &both)).unwrap()).contains(&"SIG_INVALID"));
}

#[test]
fn without_trust_there_is_no_verdict() {
    let (_dir, out) = published();
    let nobody = TrustStore::default();
    let report = verify(&request(&out, &nobody)).unwrap();
    assert_eq!((report.verdict, report.exit_code), (Verdict::Incomplete, 3));
    assert_eq!(codes(&report), ["TRUST_STORE_EMPTY"]);
    fs::write(out.join("scene.ply"), "changed").unwrap();
    assert_eq!(verify(&request(&out, &nobody)).unwrap().exit_code, 1);
}

#[test]
fn properly_signed_lies() {
    type Change = fn(&mut Value);
    let cases: [(&str, Change); 14] = [
        ("MARKING_DOWNGRADE", |v| v["predicate"]["inputs"][0]["marking"] = json!("SECRET")),
        ("MARKING_DOWNGRADE", |v| v["predicate"]["marking"]["inputs_join"] = json!("CUI")),
        ("MARKING_INBAND_MISMATCH", |v| v["predicate"]["marking"]["banner"] = json!("SECRET")),
        ("MARKING_UNSUPPORTED", |v| v["predicate"]["marking"]["banner"] = json!("SECRET//SI")),
        ("TIME_FUTURE", |v| v["predicate"]["time"]["utc"] = json!("2025-11-21T01:34:42.121Z")),
        ("ALG_REFUSED", |v| v["predicate"]["actor"]["algorithm"] = json!("RS1")),
        ("CHAIN_BROKEN", |v| v["predicate"]["chain"]["seq"] = json!(3)),
        ("LEDGER_ID", |v| v["predicate"]["chain"]["ledger_id"] = json!("0123456789abcdef")),
        ("SCHEMA_INVALID", |v| v["predicate"]["surprise"] = json!(1)),
        ("SCHEMA_INVALID", |v| v["predicate"]["schema"] = json!("orb.audit/v2")),
        ("PATH_REFUSED", |v| v["subject"][1]["name"] = json!("../scene.ply")),
        ("PATH_REFUSED", |v| v["subject"][1]["name"] = json!("/etc/passwd")),
        ("OUTPUT_MISSING", |v| v["subject"][1]["name"] = json!("other.ply")),
        ("OUTPUT_DIGEST", |v| v["subject"][1]["annotations"]["size"] = json!("1")),
    ];
    for (code, change) in cases {
        let (_dir, out) = published();
        forge(&out, shared_key(), change);
        let report = check(&out);
        assert!(codes(&report).contains(&code), "{code}: {}", report.to_text());
        assert!(!codes(&report).contains(&"SIG_INVALID"));
        let expected = if ["ALG_REFUSED"].contains(&code) { 4 } else { report.exit_code };
        assert_eq!(report.exit_code, expected);
        assert_ne!(report.exit_code, 0);
    }
    // Within the tolerated skew.
    let (_dir, out) = published();
    forge(&out, shared_key(), |v| v["predicate"]["time"]["utc"] = json!("2025-11-21T01:34:42.120Z"));
    assert_eq!(check(&out).exit_code, 0);
}

#[test]
fn properly_signed_bytes_that_are_no_record() {
    let (_dir, out) = published();
    let good = payload(&out);
    let fingerprint = shared_key().public().fingerprint();
    let pretty = serde_json::to_vec_pretty(&good).unwrap();
    let text = good.to_string();
    let seed_twice = text.replacen("\"seed\":7", "\"seed\":7,\"seed\":8", 1);
    let wrong_hash = {
        let mut value = good.clone();
        value["predicate"]["trail_hash"] = json!("0".repeat(64));
        serde_json_canonicalizer::to_vec(&value).unwrap()
    };
    let deep = format!("{}{}", "[".repeat(200), "]".repeat(200));
    for (code, bytes) in [
        ("NOT_CANONICAL", pretty.as_slice()),
        ("SCHEMA_INVALID", seed_twice.as_bytes()),
        ("SCHEMA_INVALID", b"{}"),
        ("SCHEMA_INVALID", b""),
        ("TRAIL_HASH_MISMATCH", &wrong_hash),
        ("LIMIT_EXCEEDED", deep.as_bytes()),
    ] {
        sign_payload(&out, bytes, fingerprint, shared_key());
        let report = check(&out);
        assert_eq!(codes(&report), [code]);
        assert_eq!(report.exit_code, 1);
    }
    // Another payload type, properly signed.
    let pae = dsse::pae("text/plain", text.as_bytes());
    let sig = shared_key().sign(&pae).unwrap();
    let envelope = Envelope {
        payload: text.into_bytes(),
        payload_type: "text/plain".into(),
        signatures: vec![Signature { keyid: fingerprint.into(), sig }],
    };
    fs::write(out.join(RECORD), envelope.to_line()).unwrap();
    assert!(codes(&check(&out)).contains(&"TYPE_UNSUPPORTED"));
}

#[test]
fn missing_and_added_files() {
    let (_dir, out) = published();
    fs::write(out.join("van.cdb/extra.flt"), "x").unwrap();
    let report = check(&out);
    assert_eq!((codes(&report), report.exit_code), (vec!["OUTPUT_EXTRA"], 0));
    let trust = trusting(&[shared_key()]);
    let strict = verify(&Request { strict: true, ..request(&out, &trust) }).unwrap();
    assert_eq!(strict.exit_code, 1);
    fs::remove_file(out.join("van.cdb/extra.flt")).unwrap();

    let proof = fs::read(out.join(RECORD_PROOF)).unwrap();
    fs::remove_file(out.join(RECORD_PROOF)).unwrap();
    assert_eq!(codes(&check(&out)), ["PROOF_MISSING"]);
    // Another record's proof: signed by the same key, and no proof of this one.
    let (_other_dir, other) = published();
    forge(&other, shared_key(), |v| v["predicate"]["params"]["seed"] = json!(8));
    fs::copy(other.join(RECORD_PROOF), out.join(RECORD_PROOF)).unwrap();
    assert_eq!(codes(&check(&out)), ["PROOF_INVALID"]);
    fs::write(out.join(RECORD_PROOF), proof).unwrap();
    assert_eq!(codes(&check(&out)), [""; 0]);

    fs::remove_file(out.join(RECORD_SIG)).unwrap();
    assert_eq!(codes(&check(&out)), ["SEAL_FILE_MISSING"]);
    fs::remove_file(out.join(MARKING_SIDECAR)).unwrap();
    let report = check(&out);
    assert!(codes(&report).contains(&"OUTPUT_MISSING"));
    assert_eq!(report.exit_code, 1);

    fs::remove_file(out.join(RECORD)).unwrap();
    let report = check(&out);
    assert_eq!((codes(&report), report.exit_code), (vec!["RECORD_MISSING"], 3));
    let nothing = verify(&request(&out.join("no such folder"), &trust)).unwrap_err();
    assert_eq!(nothing.kind, Kind::Environment);
    assert_eq!(verify(&request(&out.join("scene.ply"), &trust)).unwrap_err().kind, Kind::Usage);
}

#[cfg(unix)]
#[test]
fn links_are_not_followed() {
    use std::os::unix::fs::symlink;
    let (dir, out) = published();
    // The same bytes behind a link.
    fs::write(dir.path().join("outside.ply"), ply()).unwrap();
    fs::remove_file(out.join("scene.ply")).unwrap();
    symlink(dir.path().join("outside.ply"), out.join("scene.ply")).unwrap();
    let report = check(&out);
    assert_eq!((codes(&report), report.exit_code), (vec!["PATH_REFUSED"], 1));
    // A folder behind a link.
    let (dir, out) = published();
    fs::rename(out.join("van.cdb"), dir.path().join("moved")).unwrap();
    symlink(dir.path().join("moved"), out.join("van.cdb")).unwrap();
    assert!(codes(&check(&out)).contains(&"PATH_REFUSED"));
    // The record itself.
    fs::rename(out.join(RECORD), dir.path().join("record")).unwrap();
    symlink(dir.path().join("record"), out.join(RECORD)).unwrap();
    assert_eq!(codes(&check(&out)), ["PATH_REFUSED"]);
}

#[test]
fn another_photo() {
    let (dir, out) = published();
    let trust = trusting(&[shared_key()]);
    let other = dir.path().join("other.jpg");
    fs::write(&other, b"another photo").unwrap();
    let inputs = [other];
    let report = verify(&Request { inputs: &inputs, ..request(&out, &trust) }).unwrap();
    assert_eq!((codes(&report), report.exit_code), (vec!["INPUT_DIGEST"], 1));
    assert!(report.findings[0].subject.ends_with("other.jpg"));
    // Without a file to compare: said, not failed.
    let report = check(&out);
    assert!(report.findings.iter().any(|f| f.code == "INPUT_MISSING" && f.subject == "van.jpg"));
}

#[test]
fn files_in_a_store() {
    let dir = tempfile::tempdir().unwrap();
    let store = dir.path().join("store");
    fs::create_dir(&store).unwrap();
    let file = orb_formats::File {
        path: "Tiles/points.dbf".into(),
        bytes: b"points".to_vec(),
        media_type: "application/octet-stream",
    };
    let out = dir.path().join("out");
    let mut publication = Publication::begin(&destination(&out)).unwrap();
    fill(&mut publication).unwrap();
    publication.merge(merge_into_store(lock_store(&store).unwrap(), &[file], &[]).unwrap()).unwrap();
    publication.seal(&draft(), shared_key(), &mut ledger(dir.path())).unwrap();

    let trust = trusting(&[shared_key()]);
    let report = check(&out);
    assert_eq!(report.exit_code, 0);
    assert!(report.findings.iter().any(|f| f.code == "STORE_NOT_CHECKED"));
    let with_store = || verify(&Request { store: Some(&store), ..request(&out, &trust) }).unwrap();
    assert_eq!((with_store().exit_code, with_store().counts.outputs_verified), (0, 4));
    fs::write(store.join("Tiles/points.dbf"), b"pointz").unwrap();
    assert_eq!(codes(&with_store()), ["OUTPUT_DIGEST"]);
    assert!(with_store().findings.iter().any(|f| f.subject == "store:Tiles/points.dbf"));
}

#[test]
fn a_verifier_may_ask_for_more() {
    let (_dir, out) = published();
    let trust = trusting(&[shared_key()]);
    let with = |policy| verify(&Request { policy, ..request(&out, &trust) }).unwrap();
    let weights = canonical::sha256_hex(b"w");
    let (listed, other) = ([weights.clone()], [canonical::sha256_hex(b"other")]);
    let strict = Policy { require_time_sync: true, models: Some(&listed), ..Policy::default() };
    assert_eq!((with(strict).exit_code, codes(&with(strict))), (0, vec![]));
    let refused = with(Policy { models: Some(&other), ..strict });
    assert_eq!((refused.exit_code, codes(&refused)), (4, vec!["MODEL_NOT_ALLOWED"]));
    forge(&out, shared_key(), |v| v["predicate"]["time"]["sync_status"] = json!("unsynchronised"));
    assert_eq!(check(&out).exit_code, 0);
    assert_eq!((with(strict).exit_code, codes(&with(strict))), (4, vec!["TIME_UNSYNCED"]));
}

#[test]
fn a_second_digest_where_the_algorithm_asks_for_it() {
    let dir = tempfile::tempdir().unwrap();
    let (out, store) = (dir.path().join("out"), dir.path().join("store"));
    let path = dir.path().join("unit.pem");
    shared_key().save(&path, None).unwrap();
    let key = SigningKey::load(&path, crate::audit::keys::KeySource::NamedFile).unwrap();
    let key = key.with_algorithm(crate::audit::keys::Algorithm::Rs384).unwrap();
    fs::create_dir(&store).unwrap();
    let mut publication = Publication::begin(&destination(&out)).unwrap();
    fill(&mut publication).unwrap();
    let file = orb_formats::File { path: "a.txt".into(), bytes: b"a".to_vec(), media_type: "text/plain" };
    publication.merge(merge_into_store(lock_store(&store).unwrap(), &[file], &[]).unwrap()).unwrap();
    publication.seal(&draft(), &key, &mut ledger(dir.path())).unwrap();
    let trust = trusting(&[shared_key()]);
    let with_store = || verify(&Request { store: Some(&store), ..request(&out, &trust) }).unwrap();
    let report = with_store();
    assert_eq!((codes(&report), report.exit_code), (vec![], 0), "{}", report.to_text());
    let (_, statement) = read_record(&out).unwrap();
    let stored = statement.subject.iter().find(|s| s.name == "store:a.txt").unwrap();
    // FIPS 180-4, SHA-384 of "a".
    let known = "54a59b9f22b0b80880d8427e548b7c23abd873486e1f035dce9cd697e85175033caa88e6d57bc35efae0b5afd3145f31";
    assert_eq!(stored.digest.sha384.as_deref(), Some(known));
    assert!(statement.subject.iter().all(|s| s.digest.sha384.is_some()));
    forge(&out, &key, |v| v["subject"][0]["digest"]["sha384"] = json!(known));
    assert_eq!(codes(&with_store()), ["OUTPUT_DIGEST"]);
    forge(&out, &key, |v| v["subject"][0]["digest"]["sha384"] = json!("54a5"));
    assert_eq!(codes(&with_store())[0], "SCHEMA_INVALID");
}

#[cfg(not(feature = "fips"))]
#[test]
fn signed_by_two_keys() {
    use crate::audit::keys::suite_tests::pair;
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let mut publication = Publication::begin(&destination(&out)).unwrap();
    fill(&mut publication).unwrap();
    publication.seal(&draft(), pair(), &mut ledger(dir.path())).unwrap();
    let data = crate::audit::DataFolder::at(dir.path().join("trusting"));
    assert!(crate::audit::trust::add(&data, pair()).unwrap());
    let trust = TrustStore::load(&data, &[]).unwrap();
    let report = || verify(&request(&out, &trust)).unwrap();
    assert_eq!((codes(&report()), report().exit_code), (vec![], 0), "{}", report().to_text());
    let names: Vec<&str> = pair().all().map(|k| k.public().fingerprint()).collect();
    assert_eq!((report().signed_by.as_deref(), report().also_signed_by), (Some(names[0]), vec![names[1].to_owned()]));
    let (_, statement) = read_record(&out).unwrap();
    assert!(statement.subject.iter().all(|s| s.digest.sha384.is_some()));
    let by_hand = crate::audit::by_hand::openssl_commands(&out, Default::default()).unwrap();
    for line in [
        "openssl dgst -sha384 -verify orb-record.pub.pem -signature orb-record.sig orb-record.pae",
        "openssl pkeyutl -verify -pubin -inkey orb-record.second.pub.pem -rawin -in orb-record.pae -sigfile orb-record.second.sig",
    ] {
        assert!(by_hand.contains(line), "{by_hand}");
    }
    for name in [RECORD_SIG_2, RECORD_KEY_2] {
        let good = fs::read(out.join(name)).unwrap();
        fs::write(out.join(name), b"other").unwrap();
        assert_eq!(codes(&report()), ["SEAL_FILE_MISMATCH"]);
        fs::remove_file(out.join(name)).unwrap();
        assert_eq!(codes(&report()), ["SEAL_FILE_MISSING"]);
        fs::write(out.join(name), good).unwrap();
    }
    // A proof that only one of them signed.
    let proof = String::from_utf8(fs::read(out.join(RECORD_PROOF)).unwrap()).unwrap();
    let mut checkpoint = Proof::parse(proof.as_bytes()).unwrap().envelope().unwrap();
    let whole = String::from_utf8(checkpoint.to_line()).unwrap();
    checkpoint.signatures.truncate(1);
    let cut = String::from_utf8(checkpoint.to_line()).unwrap();
    let spelled = |line: &str| serde_json::to_string(line.trim_end()).unwrap();
    assert!(proof.contains(&spelled(&whole)));
    fs::write(out.join(RECORD_PROOF), proof.replace(&spelled(&whole), &spelled(&cut))).unwrap();
    assert_eq!(codes(&report()), ["SIGNATURE_MISSING"]);
}
