//! Makes the corpus.

use std::fs;
use std::path::Path;

use serde_json::json;

use super::folders::{FOLDERS, PHOTO, TRUSTED, VERIFIED_OTHERWISE, signed_under_certificates};
use super::ledgers::{Keeps, LEDGERS};
use super::{Case, Kind, corpus};
use super::{clocks, fields, remains, suites};
use crate::audit::dsse::PAYLOAD_TYPE;
use crate::audit::keys::tests::{other_key, shared_key};
use crate::audit::keys::{Bits, KeySource, SigningKey};
use crate::audit::ledger::Ledger;
use crate::audit::ledger_check::tests::ledger;
use crate::audit::publication::tests::publish;
use crate::audit::verify::tests::forge;
use crate::audit::{canonical, disk};

#[expect(clippy::too_many_arguments, reason = "a line of a table")]
pub(super) fn case(
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
        notes: Vec::new(),
        exit_code,
        needs: Vec::new(),
    }
}

pub(super) fn copy_folder(from: &Path, to: &Path) {
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
    for part in ["folder", "ledger", "reconcile"] {
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
        let unseen =
            if expect.is_empty() && keeps == Keeps::Nothing { vec!["TAIL_UNANCHORED".into()] } else { Vec::new() };
        let case = case(name, Kind::Ledger, change, &TRUSTED, beside, &[], expect, exit_code);
        cases.push(Case { notes: unseen, ..case });
    }
    // Of these there is no file.
    let deleted = "the whole ledger removed";
    let kept = "the whole ledger removed; a checkpoint was kept";
    cases.push(case("deleted", Kind::Ledger, kept, &TRUSTED, &["kept.dsse.json"], &[], &["TRUNCATED"], 1));
    cases.push(case("deleted-unseen", Kind::Ledger, deleted, &TRUSTED, &[], &[], &["RECORD_MISSING"], 3));
    clocks::make(&root, &mut cases);
    fields::make(&root, &mut cases);
    suites::make(&root, &mut cases);
    remains::make(&root, &mut cases);
    write_cases(&root, &cases);
    assert_eq!(PAYLOAD_TYPE, "application/vnd.in-toto+json");
}

pub(super) fn write_cases(root: &Path, cases: &[Case]) {
    let mut text = serde_json::to_string_pretty(cases).unwrap();
    text.push('\n');
    fs::write(root.join("cases.json"), text).unwrap();
}
