use std::io::ErrorKind;
use std::path::Path;

use super::*;
use crate::Kind;
use crate::audit::Marking;
use crate::audit::data_folder::DataFolder;
use crate::audit::disk::fault::Plan;
use crate::audit::keys::tests::shared_key;
use crate::audit::record::tests::draft;
use crate::audit::store_merge::{lock_store, merge_into_store};

pub(crate) fn destination(folder: &Path) -> Destination {
    Destination { folder: folder.into(), replace: false, handling: Marking::UNCLASSIFIED.into(), nonce: 7 }
}

pub(crate) fn ply() -> Vec<u8> {
    format!("ply\ncomment {}\nend_header\n\x01\x02\x03", Marking::UNCLASSIFIED.line()).into_bytes()
}

pub(crate) fn fill(publication: &mut Publication) -> Result<()> {
    publication.add("scene.ply", &ply(), "application/octet-stream", "splats")?;
    publication.add("van.cdb/Tiles/N34/points.dbf", b"dbf bytes", "application/octet-stream", "cdb")?;
    publication.add_folder("van.cdb/Metadata/Stylesheet")
}

/// Publishes three files into `dir/out`, with the ledger in `dir/data`.
pub(crate) fn publish(dir: &Path) -> Published {
    let mut publication = Publication::begin(&destination(&dir.join("out"))).unwrap();
    fill(&mut publication).unwrap();
    publication.seal(&draft(), shared_key(), &mut ledger(dir)).unwrap()
}

pub(crate) fn ledger(dir: &Path) -> Ledger {
    Ledger::open(&DataFolder::at(dir.join("data"))).unwrap()
}

fn names(dir: &Path) -> Vec<String> {
    disk::walk(dir).unwrap().into_iter().map(|e| e.name).filter(|n| !n.starts_with("data")).collect()
}

#[test]
fn a_published_folder() {
    let dir = tempfile::tempdir().unwrap();
    let published = publish(dir.path());
    assert_eq!(published.folder, dir.path().canonicalize().unwrap().join("out"));
    assert_eq!(
        names(dir.path()),
        [
            "out",
            "out/orb-marking.json",
            "out/orb-proof.tlog",
            "out/orb-record.dsse.json",
            "out/orb-record.pae",
            "out/orb-record.pub.pem",
            "out/orb-record.sig",
            "out/scene.ply",
            "out/van.cdb",
            "out/van.cdb/Metadata",
            "out/van.cdb/Metadata/Stylesheet",
            "out/van.cdb/Tiles",
            "out/van.cdb/Tiles/N34",
            "out/van.cdb/Tiles/N34/points.dbf",
        ]
    );
    let paths: Vec<&str> = published.outputs.iter().map(|o| o.path.as_str()).collect();
    assert_eq!(paths, ["orb-marking.json", "scene.ply", "van.cdb/Tiles/N34/points.dbf"]);
    assert_eq!(published.outputs[1].sha256, canonical::sha256_hex(&ply()));
    assert_eq!(published.outputs[1].bytes, ply().len() as u64);
    let records = ledger(dir.path()).read_chain().unwrap();
    assert_eq!(records.len(), 1);
    assert_eq!(records[0].predicate.trail_hash.as_ref(), Some(&published.trail_hash));
    let line = fs::read(dir.path().join("out").join(RECORD)).unwrap();
    assert_eq!(fs::read(ledger(dir.path()).path()).unwrap(), line);
}

#[test]
fn nothing_remains_of_what_is_not_sealed() {
    let dir = tempfile::tempdir().unwrap();
    let mut publication = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
    fill(&mut publication).unwrap();
    assert_eq!(names(dir.path())[0], ".out.orb-0000000000000007");
    drop(publication);
    assert!(names(dir.path()).is_empty());
}

#[test]
fn destinations_in_use() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let refuse =
        |replace: bool| Publication::begin(&Destination { replace, ..destination(&out) }).map(drop).unwrap_err();
    fs::write(&out, "file").unwrap();
    assert_eq!(refuse(true).kind, Kind::Usage);
    fs::remove_file(&out).unwrap();
    fs::create_dir(&out).unwrap();
    fs::write(out.join("thesis.txt"), "mine").unwrap();
    assert_eq!(refuse(true).kind, Kind::Usage);
    fs::remove_file(out.join("thesis.txt")).unwrap();
    // An empty folder is fine.
    publish(dir.path());
    assert!(refuse(false).advice.contains("--replace"));
    fs::write(out.join("van.cdb/notes.txt"), "mine").unwrap();
    assert!(refuse(true).found.contains("van.cdb/notes.txt"));
    assert_eq!(fs::read(out.join("van.cdb/notes.txt")).unwrap(), b"mine");
    let missing = Publication::begin(&destination(&dir.path().join("a/b"))).unwrap_err();
    assert_eq!(missing.kind, Kind::Environment);
    assert_eq!(Publication::begin(&destination(Path::new("/"))).unwrap_err().kind, Kind::Usage);
}

#[test]
fn an_earlier_result_is_replaced_whole() {
    let dir = tempfile::tempdir().unwrap();
    publish(dir.path());
    let again = Destination { replace: true, ..destination(&dir.path().join("out")) };
    let mut publication = Publication::begin(&again).unwrap();
    publication.add("only.bin", b"1", "application/octet-stream", "x").unwrap();
    publication.seal(&draft(), shared_key(), &mut ledger(dir.path())).unwrap();
    assert!(!dir.path().join("out/scene.ply").exists());
    assert_eq!(fs::read(dir.path().join("out/only.bin")).unwrap(), b"1");
    assert!(names(dir.path()).iter().all(|n| n.starts_with("out")), "{:?}", names(dir.path()));
    assert_eq!(ledger(dir.path()).read_chain().unwrap().len(), 2);
}

#[test]
fn names_that_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let mut publication = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
    fill(&mut publication).unwrap();
    for path in ["../x", "/x", "a\\b", "scene.ply", "Scene.PLY", RECORD, RECORD_PAE, "a:b", ""] {
        let error = publication.add(path, &ply(), "x", "x").unwrap_err();
        assert!(error.found.contains("PATH_REFUSED"), "{path}: {error}");
    }
    assert!(publication.add_folder("../x").is_err());
}

#[test]
fn a_file_with_another_marking_is_not_published() {
    let dir = tempfile::tempdir().unwrap();
    let to = Destination { handling: Marking::SECRET.into(), ..destination(&dir.path().join("out")) };
    let mut publication = Publication::begin(&to).unwrap();
    let error = publication.add("scene.ply", &ply(), "x", "x").unwrap_err();
    assert_eq!(error.kind, Kind::Policy);
    assert!(error.found.contains("MARKING_INBAND_MISMATCH"));
    let error = publication.add("scene.ply", b"ply\nend_header\n", "x", "x").unwrap_err();
    assert!(error.found.contains("no marking inside"));
    let error = publication.seal(&draft(), shared_key(), &mut ledger(dir.path())).unwrap_err();
    assert_eq!(error.kind, Kind::Policy);
    assert!(names(dir.path()).is_empty());
}

fn merge_files() -> [orb_formats::File; 2] {
    let file = |path: &str| orb_formats::File {
        path: path.into(),
        bytes: b"new".to_vec(),
        media_type: "application/octet-stream",
    };
    [file("there.txt"), file("added/too.txt")]
}

fn snapshot(dir: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = disk::walk(dir).unwrap();
    entries
        .into_iter()
        .filter(|e| !e.name.starts_with("data") && !e.name.contains(".orb"))
        .map(|e| (e.name, if e.is_file { fs::read(e.path).unwrap() } else { Vec::new() }))
        .collect()
}

/// The earlier result, the store and the new result, with a failure at every operation of the publication.
#[test]
fn a_failure_leaves_destination_and_store_as_they_were() {
    let mut failures = 0;
    for at in 0.. {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        fs::create_dir(dir.path().join("store")).unwrap();
        fs::write(dir.path().join("store/there.txt"), "old").unwrap();
        let before = snapshot(dir.path());
        let plan = Plan::new(at, false, ErrorKind::StorageFull);
        let run = || {
            let to = Destination { replace: true, ..destination(&dir.path().join("out")) };
            let mut publication = Publication::begin_with(&to, Disk { fault: Some(plan.clone()) })?;
            publication.add("a/new.bin", b"new", "application/octet-stream", "x")?;
            let lock = lock_store(&dir.path().join("store"))?;
            publication.merge(merge_into_store(lock, &merge_files(), &[])?)?;
            publication.seal(&draft(), shared_key(), &mut ledger(dir.path()))
        };
        let result = run();
        let after = snapshot(dir.path());
        match result {
            Err(error) => {
                failures += 1;
                assert_eq!(error.kind, Kind::Environment, "{error}");
                assert_eq!(after, before, "operation {at}");
                assert!(!names(dir.path()).iter().any(|n| n.contains(".orb")), "operation {at}");
            }
            Ok(_) => {
                assert_eq!(fs::read(dir.path().join("out/a/new.bin")).unwrap(), b"new");
                assert_eq!(fs::read(dir.path().join("store/there.txt")).unwrap(), b"new");
                assert!(!dir.path().join("out/scene.ply").exists());
            }
        }
        ledger(dir.path()).read_chain().unwrap();
        if !plan.was_hit() {
            break;
        }
    }
    assert!(failures >= 8, "{failures}");
}

#[test]
fn a_store_that_fails_takes_the_folder_with_it() {
    let dir = tempfile::tempdir().unwrap();
    fs::create_dir(dir.path().join("store")).unwrap();
    let mut publication = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
    fill(&mut publication).unwrap();
    let lock = lock_store(&dir.path().join("store")).unwrap();
    publication.merge(merge_into_store(lock, &merge_files(), &[]).unwrap()).unwrap();
    // Something takes the place of a file to be added.
    fs::create_dir_all(dir.path().join("store/added/too.txt/in-the-way")).unwrap();
    let error = publication.seal(&draft(), shared_key(), &mut ledger(dir.path())).unwrap_err();
    assert_eq!(error.kind, Kind::Environment);
    assert!(!dir.path().join("out").exists());
    assert!(!dir.path().join("store/there.txt").exists());
    // The ledger says what became of the run.
    let records = ledger(dir.path()).read_chain().unwrap();
    assert_eq!(records.len(), 2);
    assert_eq!(records[1].predicate.event.outcome, Outcome::Failure);
    assert_eq!(records[1].predicate.event.error_code.as_deref(), Some("PUBLISH_FAILED"));
    assert_ne!(records[0].predicate.event.id, records[1].predicate.event.id);
}

#[test]
fn a_broken_ledger_publishes_nothing() {
    let dir = tempfile::tempdir().unwrap();
    let ledger_path = ledger(dir.path()).path().to_path_buf();
    fs::write(&ledger_path, "not a record\n").unwrap();
    let mut publication = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
    fill(&mut publication).unwrap();
    let error = publication.seal(&draft(), shared_key(), &mut ledger(dir.path())).unwrap_err();
    assert_eq!(error.kind, Kind::Integrity);
    assert!(names(dir.path()).is_empty());
}

#[cfg(unix)]
#[test]
fn killed_runs_are_swept_and_living_ones_are_not() {
    let dir = tempfile::tempdir().unwrap();
    let dead = dir.path().join(".out.orb-00000000000000aa");
    fs::create_dir(&dead).unwrap();
    fs::write(dead.join("half"), "x").unwrap();
    let mine = dir.path().join(".out.orb-notes");
    fs::create_dir(&mine).unwrap();
    let living = Publication::begin(&destination(&dir.path().join("out"))).unwrap();
    assert!(!dead.exists() && mine.exists());
    let second = Publication::begin(&Destination { nonce: 8, ..destination(&dir.path().join("out")) }).unwrap();
    assert!(living.staging.exists() && second.staging.exists());
    drop((living, second));
    // An earlier result set aside by a kill between two renames comes back.
    publish(dir.path());
    fs::rename(dir.path().join("out"), dir.path().join(".out.orb-00000000000000bb-old")).unwrap();
    let error = Publication::begin(&destination(&dir.path().join("out"))).unwrap_err();
    assert!(error.found.contains("earlier result"));
    assert!(dir.path().join("out/scene.ply").exists());
}

#[cfg(unix)]
#[test]
fn a_folder_that_cannot_be_written() {
    use std::os::unix::fs::PermissionsExt as _;
    let dir = tempfile::tempdir().unwrap();
    fs::set_permissions(dir.path(), fs::Permissions::from_mode(0o555)).unwrap();
    // The superuser writes everywhere.
    if fs::write(dir.path().join("probe"), "").is_err() {
        let error = Publication::begin(&destination(&dir.path().join("out"))).unwrap_err();
        assert_eq!(error.kind, Kind::Environment);
        assert!(error.advice.contains("-o"));
    }
    fs::set_permissions(dir.path(), fs::Permissions::from_mode(0o755)).unwrap();
}
