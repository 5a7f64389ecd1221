//! Folders whose record says of its program and its call what it must not.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use super::folders::{PHOTO, edited, unsigned};
use super::make::{case, copy_folder, write_cases};
use super::{Case, Kind, corpus};
use crate::audit::keys::{Bits, KeySource, SigningKey};
use crate::audit::ledger::Ledger;
use crate::audit::publication::Publication;
use crate::audit::publication::tests::{destination, fill};
use crate::audit::record::tests::draft;
use crate::audit::verify::tests::forge;

const KEY: &str = "fields.pub.pem";
/// The program of the records, and another one.
const PROGRAMS: [(&str, &[u8]); 2] = [("program.bin", b"orb"), ("other-program.bin", b"another orb")];

/// How the record comes to be another one.
enum How {
    Untouched,
    Unsigned(fn(&mut Value)),
    Signed(fn(&mut Value)),
}

/// Name, what was done, how, the options, what must be reported, the exit code.
type Fields<'a> = (&'a str, &'a str, How, &'a [&'a str], &'a [&'a str], u8);

const FIELDS: [Fields<'_>; 7] = [
    ("program-as-used", "nothing", How::Untouched, &["--program", PROGRAMS[0].0], &[], 0),
    ("program-swapped", "another program", How::Untouched, &["--program", PROGRAMS[1].0], &["PROGRAM_DIGEST"], 1),
    (
        "program-edited",
        "the program's digest, the signature left",
        How::Unsigned(|v| v["predicate"]["tool"]["binary_sha256"] = json!("0".repeat(64))),
        &[],
        &["SIG_INVALID", "TRAIL_HASH_MISMATCH"],
        1,
    ),
    (
        "operator-edited",
        "the operator's stated name, the signature left",
        How::Unsigned(|v| v["predicate"]["actor"]["display"] = json!("John Doe")),
        &[],
        &["SIG_INVALID", "TRAIL_HASH_MISMATCH"],
        1,
    ),
    (
        "certificate-made-up",
        "a certificate of a module that did not run in FIPS mode, properly signed",
        How::Signed(|v| v["predicate"]["crypto"]["module_certificate_claim"] = json!("CMVP #5314")),
        &[],
        &["SCHEMA_INVALID"],
        1,
    ),
    (
        "path-in-the-command-line",
        "an absolute path in the command line, properly signed",
        How::Signed(|v| v["predicate"]["source"]["argv_redacted"][2] = json!("/home/jane/van.jpg")),
        &[],
        &["SCHEMA_INVALID"],
        1,
    ),
    (
        "no-commit",
        "a branch's name for a commit, properly signed",
        How::Signed(|v| v["predicate"]["tool"]["git_commit"] = json!("main")),
        &[],
        &["SCHEMA_INVALID"],
        1,
    ),
];

pub(super) fn make(root: &Path, cases: &mut Vec<Case>) {
    let key = SigningKey::generate(KeySource::NamedFile, Bits::default()).unwrap();
    fs::write(root.join(KEY), key.public().to_pem()).unwrap();
    for (name, bytes) in PROGRAMS {
        fs::write(root.join(name), bytes).unwrap();
    }
    let dir = tempfile::tempdir().unwrap();
    let mut publication = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
    fill(&mut publication).unwrap();
    publication.seal(&draft(), &key, &mut Ledger::at(dir.path().join("orb-ledger.jsonl"))).unwrap();
    for (name, change, how, options, expect, exit_code) in FIELDS {
        let folder = root.join("folder").join(name);
        copy_folder(&dir.path().join("out"), &folder);
        match how {
            How::Untouched => {}
            How::Unsigned(act) => unsigned(&folder, |envelope| edited(envelope, false, act)),
            How::Signed(act) => forge(&folder, &key, act),
        }
        cases.push(case(name, Kind::Folder, change, &[KEY], PHOTO, options, expect, exit_code));
    }
}

#[test]
#[ignore = "writes a part of the corpus anew"]
fn make_the_fields_of_the_tamper_corpus() {
    let root = corpus();
    let mut cases = super::cases(&root);
    cases.retain(|case| FIELDS.iter().all(|fields| fields.0 != case.name));
    for (name, ..) in FIELDS {
        let _ = fs::remove_dir_all(root.join("folder").join(name));
    }
    make(&root, &mut cases);
    write_cases(&root, &cases);
}
