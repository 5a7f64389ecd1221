//! Published folders, changed.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use super::make::{case, copy_folder};
use super::{Case, Kind};
use crate::audit::canonical;
use crate::audit::dsse::{Envelope, Signature};
use crate::audit::keys::tests::{other_key, shared_key};
use crate::audit::keys::{KeySource, SigningKey};
use crate::audit::ledger::Ledger;
use crate::audit::publication::tests::{destination, fill};
use crate::audit::publication::{Publication, RECORD, RECORD_PAE, RECORD_PROOF, RECORD_SIG};
use crate::audit::record::tests::draft;
use crate::audit::trust::tests::Pki;
use crate::audit::verify::tests::{forge, payload, sign_payload};

/// Changes that only an unsigned record can have: the payload inside the envelope, its signature left.
pub(super) fn unsigned(folder: &Path, change: impl FnOnce(&mut Envelope)) {
    let path = folder.join(RECORD);
    let mut envelope = Envelope::parse(&fs::read(&path).unwrap()).unwrap();
    change(&mut envelope);
    fs::write(path, envelope.to_line()).unwrap();
}

pub(super) fn edited(envelope: &mut Envelope, rehash: bool, change: impl FnOnce(&mut Value)) {
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

pub(super) type Folder<'a> = (&'a str, &'a str, &'a [&'a str], u8, fn(&Path, &SigningKey));

/// Name, what was done, what must be reported, the exit code, and the doing.
pub(super) const FOLDERS: [Folder<'_>; 29] = [
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

pub(super) fn countersign(envelope: &mut Envelope, key: &SigningKey, keyid: &str) {
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

pub(super) type Extra<'a> = (&'a str, &'a str, &'a [&'a str], &'a [&'a str], &'a [&'a str], &'a [&'a str], u8);

pub(super) const TRUSTED: [&str; 2] = ["trusted.pub.pem", "also-trusted.pub.pem"];
pub(super) const PHOTO: &[&str] = &["photo.jpg"];
const NO_STORE: &str = "0000000000000000000000000000000000000000000000000000000000000000";

/// Folders as published, each verified in another way: name, what is another, whom to trust, the inputs given, options, what
/// must be reported, the exit code.
pub(super) const VERIFIED_OTHERWISE: [Extra<'_>; 9] = [
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
pub(super) fn signed_under_certificates(root: &Path, cases: &mut Vec<Case>) {
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
