//! Ledgers that are gone while the folders that they recorded are left; and folders with a link, with a record that is too
//! large, and with a marking below their input's.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use super::folders::{PHOTO, edited, unsigned};
use super::make::{case, copy_folder, write_cases};
use super::{Case, Kind, corpus};
use crate::audit::RecordDraft;
use crate::audit::keys::{Bits, KeySource, SigningKey};
use crate::audit::ledger::Ledger;
use crate::audit::marking::Marking;
use crate::audit::marking::handling::Handling;
use crate::audit::publication::tests::destination;
use crate::audit::publication::{Destination, Publication, RECORD_PAE};
use crate::audit::record::tests::draft;
use crate::audit::verify::tests::{payload, sign_payload};

const KEY: &str = "remains.pub.pem";
/// The folder that is left, unchanged.
const LEFT: &str = "remains";

type Folder<'a> = (&'a str, &'a str, &'a [&'a str], fn(&Path, &SigningKey));

/// Name, what was done, what must be reported, and the doing.
const FOLDERS: [Folder<'_>; 4] = [
    (LEFT, "nothing", &[], |_, _| {}),
    ("output-linked", "an output that is a link to the same bytes elsewhere", &["PATH_REFUSED"], |f, _| {
        fs::remove_file(f.join("scene.ply")).unwrap();
        #[cfg(unix)]
        std::os::unix::fs::symlink(Path::new("..").join(LEFT).join("scene.ply"), f.join("scene.ply")).unwrap();
    }),
    ("too-large", "a note of more than a mebibyte, properly signed", &["LIMIT_EXCEEDED"], |f, key| {
        let mut value = payload(f);
        value["predicate"]["notes"] = json!("x".repeat(1 << 20));
        let bytes = serde_json_canonicalizer::to_vec(&value).unwrap();
        sign_payload(f, &bytes, key.public().fingerprint(), key);
        // Only what is done by hand needs it.
        fs::remove_file(f.join(RECORD_PAE)).unwrap();
    }),
    (
        "marking-lowered-unsigned",
        "a marking below the input's, the signature left",
        &["SIG_INVALID", "TRAIL_HASH_MISMATCH", "MARKING_DOWNGRADE"],
        |f, _| {
            unsigned(f, |e| {
                edited(e, false, |v| {
                    let block: &mut Value = &mut v["predicate"]["marking"];
                    block["banner"] = json!(Marking::UNCLASSIFIED.banner());
                    block["ism"] = serde_json::to_value(Marking::UNCLASSIFIED.ism()).unwrap();
                });
            });
        },
    ),
];

/// Name, what was done, what must be reported, and what is left of the ledger, given it and another one; without any there
/// is no file.
type Remains<'a> = (&'a str, &'a str, &'a [&'a str], fn(&str, &str) -> Option<String>);

const LEDGERS: [Remains<'_>; 4] = [
    ("whole", "nothing", &[], |ledger, _| Some(ledger.into())),
    ("deleted", "the whole ledger removed; a folder that it recorded is left", &["RECORD_MISSING"], |_, _| None),
    ("emptied", "all records removed; a folder that they recorded is left", &["RECORD_MISSING"], |_, _| {
        Some(String::new())
    }),
    (
        "begun-again",
        "the ledger removed and another one begun; a folder that the first recorded is left",
        &["RECORD_MISSING"],
        |_, other| Some(other.into()),
    ),
];

/// A folder made from an input that is CUI, and so is itself; its ledger.
fn publish(dir: &Path, key: &SigningKey, name: &str) -> String {
    let cui = Marking::parse("CUI").unwrap();
    let handling = Handling::from(cui.clone());
    let mut draft = RecordDraft { handling: handling.clone(), ..draft() };
    draft.inputs[0].marking = Some(cui.banner());
    draft.command = name.into();
    let to = Destination { handling, ..destination(&dir.join(name)) };
    let mut publication = Publication::begin(&to).unwrap();
    let ply = format!("ply\ncomment {}\nend_header\n\x01\x02\x03", cui.line());
    publication.add("scene.ply", ply.as_bytes(), "application/octet-stream", "splats").unwrap();
    let ledger = dir.join(format!("{name} ledger")).join("orb-ledger.jsonl");
    fs::create_dir(ledger.parent().unwrap()).unwrap();
    publication.seal(&draft, key, &mut Ledger::at(ledger.clone())).unwrap();
    fs::read_to_string(ledger).unwrap()
}

pub(super) fn make(root: &Path, cases: &mut Vec<Case>) {
    let key = SigningKey::generate(KeySource::NamedFile, Bits::default()).unwrap();
    fs::write(root.join(KEY), key.public().to_pem()).unwrap();
    let dir = tempfile::tempdir().unwrap();
    let (ledger, other) = (publish(dir.path(), &key, "orb geo"), publish(dir.path(), &key, "orb export"));
    for (name, change, expect, act) in FOLDERS {
        let folder = root.join("folder").join(name);
        copy_folder(&dir.path().join("orb geo"), &folder);
        act(&folder, &key);
        let exit_code = u8::from(!expect.is_empty());
        cases.push(case(name, Kind::Folder, change, &[KEY], PHOTO, &[], expect, exit_code));
    }
    for (name, change, expect, left) in LEDGERS {
        if let Some(text) = left(&ledger, &other) {
            let folder = root.join("reconcile").join(name);
            fs::create_dir_all(&folder).unwrap();
            fs::write(folder.join("orb-ledger.jsonl"), text).unwrap();
        }
        let folder = format!("folder/{LEFT}");
        let exit_code = u8::from(!expect.is_empty());
        cases.push(case(name, Kind::Reconcile, change, &[KEY], &[&folder], &[], expect, exit_code));
    }
}

#[test]
#[ignore = "writes a part of the corpus anew"]
fn make_the_remains_of_the_tamper_corpus() {
    let root = corpus();
    let mut cases = super::cases(&root);
    let is_ours = |c: &Case| c.kind == Kind::Reconcile || FOLDERS.iter().any(|f| f.0 == c.name);
    cases.retain(|case| !is_ours(case));
    for (name, ..) in FOLDERS {
        let _ = fs::remove_dir_all(root.join("folder").join(name));
    }
    let _ = fs::remove_dir_all(root.join("reconcile"));
    make(&root, &mut cases);
    write_cases(&root, &cases);
}
