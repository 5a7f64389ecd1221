//! Folders signed by ML-DSA-87, and by an RSA and an ML-DSA-87 key together, changed.

use std::fs;
use std::path::Path;

use serde_json::json;

use super::folders::{PHOTO, countersign, edited, unsigned};
use super::make::{case, copy_folder, write_cases};
use super::{Case, Kind, corpus};
use crate::audit::keys::tests::other_key;
use crate::audit::keys::{Bits, KeySource, SigningKey, Suite};
use crate::audit::ledger::Ledger;
use crate::audit::publication::Publication;
use crate::audit::publication::tests::{destination, fill};
use crate::audit::record::tests::draft;
use crate::audit::verify::tests::forge;

/// The signer, and somebody else with such keys.
struct Keys {
    signer: SigningKey,
    stranger: SigningKey,
}

impl Keys {
    fn new(suite: Suite) -> Keys {
        let key = || SigningKey::generate_for(suite, KeySource::NamedFile, Bits::default()).unwrap();
        Keys { signer: key(), stranger: key() }
    }
}

type Folder<'a> = (&'a str, &'a str, &'a str, &'a [&'a str], u8, fn(&Path, &Keys));

const CNSA2: &str = "cnsa2.pub.pem";
const HYBRID: &str = "hybrid.pub.pem";
const HYBRID_RSA: &str = "hybrid-rsa-alone.pub.pem";

/// Name, what was done, whom to trust, what must be reported, the exit code, and the doing.
const BY_ML_DSA: [Folder<'_>; 5] = [
    ("cnsa2-good", "nothing", CNSA2, &[], 0, |_, _| {}),
    (
        "cnsa2-field-edited",
        "a parameter, the signature left",
        CNSA2,
        &["SIG_INVALID", "TRAIL_HASH_MISMATCH"],
        1,
        |f, _| {
            unsigned(f, |e| edited(e, false, |v| v["predicate"]["params"]["seed"] = json!(8)));
        },
    ),
    ("cnsa2-signature-edited", "one bit of the signature", CNSA2, &["SIG_INVALID"], 1, |f, _| {
        unsigned(f, |e| e.signatures[0].sig[2000] ^= 1);
    }),
    ("cnsa2-rsa-instead", "an RSA key's signature under the ML-DSA key's name", CNSA2, &["SIG_INVALID"], 1, |f, k| {
        unsigned(f, |e| {
            e.signatures.clear();
            countersign(e, other_key(), k.signer.public().fingerprint());
        });
    }),
    ("cnsa2-algorithm", "another algorithm's name, properly signed", CNSA2, &["ALG_REFUSED"], 4, |f, k| {
        forge(f, &k.signer, |v| v["predicate"]["actor"]["algorithm"] = json!("RS384"));
    }),
];

/// The same, of two keys that sign together.
const BY_BOTH: [Folder<'_>; 7] = [
    ("hybrid-good", "nothing", HYBRID, &[], 0, |_, _| {}),
    ("hybrid-one-trusted", "nothing; only the RSA key is trusted", HYBRID_RSA, &["KEY_UNTRUSTED"], 1, |_, _| {}),
    ("hybrid-first-removed", "the RSA signature removed", HYBRID, &["SIGNATURE_MISSING"], 1, |f, _| {
        unsigned(f, |e| drop(e.signatures.remove(0)));
    }),
    ("hybrid-second-removed", "the ML-DSA signature removed", HYBRID, &["SIGNATURE_MISSING"], 1, |f, _| {
        unsigned(f, |e| drop(e.signatures.remove(1)));
    }),
    (
        "hybrid-second-wrong",
        "another ML-DSA key's signature under the second key's name",
        HYBRID,
        &["SIG_INVALID"],
        1,
        {
            |f, k| {
                let (own, other) = (k.signer.partner().unwrap(), k.stranger.partner().unwrap());
                unsigned(f, |e| {
                    e.signatures.truncate(1);
                    countersign(e, other, own.public().fingerprint());
                });
            }
        },
    ),
    ("hybrid-rsa-twice", "the RSA key's signature twice, once under the second's name", HYBRID, &["SIG_INVALID"], 1, {
        |f, k| {
            let own = k.signer.partner().unwrap().public().fingerprint();
            unsigned(f, |e| {
                e.signatures.truncate(1);
                countersign(e, &k.signer, own);
            });
        }
    }),
    (
        "hybrid-rsa-alone",
        "made anew by who has the RSA key only, without a word of the other",
        HYBRID,
        &["SIGNATURE_MISSING"],
        1,
        |f, k| forge(f, &k.signer, |v| drop(v["predicate"]["actor"].as_object_mut().unwrap().remove("co_signers"))),
    ),
];

pub(super) fn make(root: &Path, cases: &mut Vec<Case>) {
    for (suite, folders) in [(Suite::Cnsa2, &BY_ML_DSA[..]), (Suite::Hybrid, &BY_BOTH)] {
        let keys = Keys::new(suite);
        let pems = |keys: &SigningKey| keys.all().map(|k| k.public().to_pem()).collect::<String>();
        let name = if suite == Suite::Cnsa2 { CNSA2 } else { HYBRID };
        fs::write(root.join(name), pems(&keys.signer)).unwrap();
        if suite == Suite::Hybrid {
            fs::write(root.join(HYBRID_RSA), keys.signer.public().to_pem()).unwrap();
        }
        let dir = tempfile::tempdir().unwrap();
        let mut publication = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
        fill(&mut publication).unwrap();
        publication.seal(&draft(), &keys.signer, &mut Ledger::at(dir.path().join("orb-ledger.jsonl"))).unwrap();
        for (name, change, trust, expect, exit_code, act) in folders {
            let folder = root.join("folder").join(name);
            copy_folder(&dir.path().join("out"), &folder);
            act(&folder, &keys);
            let case = case(name, Kind::Folder, change, &[trust], PHOTO, &[], expect, *exit_code);
            let needs = if *trust == HYBRID_RSA { Vec::new() } else { vec!["ML-DSA-87".into()] };
            cases.push(Case { needs, ..case });
        }
    }
}

#[test]
#[ignore = "writes a part of the corpus anew"]
fn make_the_suites_of_the_tamper_corpus() {
    let root = corpus();
    let mut cases = super::cases(&root);
    let is_ours = |name: &str| BY_ML_DSA.iter().chain(&BY_BOTH).any(|f| f.0 == name);
    cases.retain(|c| !is_ours(&c.name));
    for (name, ..) in BY_ML_DSA.iter().chain(&BY_BOTH) {
        let _ = fs::remove_dir_all(root.join("folder").join(name));
    }
    make(&root, &mut cases);
    write_cases(&root, &cases);
}
