use std::io::ErrorKind;
use std::path::Path;

use super::*;
use crate::Kind;
use crate::audit::Marking;
use crate::audit::TrustStore;
use crate::audit::data_folder::DataFolder;
use crate::audit::disk::fault::Plan;
use crate::audit::keys::KeySource;
use crate::audit::keys::tests::shared_key;
use crate::audit::ledger_check::reconcile;
use crate::audit::record::tests::draft;
use crate::audit::store_merge::{lock_store, merge_into_store};
use crate::audit::verify::{Request, verify};

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

/// Two runs to one place that was free when both began, and a folder that its user made during a run: what stands there at
/// the end stays, as nobody agreed to its replacement.
#[test]
fn a_destination_that_fills_up_during_the_run() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let begin = |nonce: u64, replace: bool| {
        let to = Destination { nonce, replace, ..destination(&out) };
        let mut publication = Publication::begin(&to).unwrap();
        fill(&mut publication).unwrap();
        publication
    };
    let seal = |publication: Publication| publication.seal(&draft(), shared_key(), &mut ledger(dir.path()));
    let (first, second, third) = (begin(7, false), begin(8, false), begin(9, true));
    seal(first).unwrap();
    let record = fs::read(out.join(RECORD)).unwrap();
    let error = seal(second).unwrap_err();
    assert_eq!((error.kind, error.found.as_str()), (Kind::Usage, "an earlier result of Orb"));
    assert_eq!(fs::read(out.join(RECORD)).unwrap(), record);
    assert_eq!(
        ledger(dir.path()).read_chain().unwrap()[2].predicate.event.error_code.as_deref(),
        Some("PUBLISH_FAILED")
    );
    // Replacing is agreed to, but not what Orb did not write.
    fs::write(out.join("thesis.txt"), "mine").unwrap();
    assert!(seal(third).unwrap_err().found.contains("thesis.txt"));
    fs::remove_dir_all(&out).unwrap();
    let fourth = begin(10, false);
    fs::create_dir(&out).unwrap();
    fs::write(out.join("thesis.txt"), "mine").unwrap();
    assert_eq!(seal(fourth).unwrap_err().kind, Kind::Usage);
    assert_eq!(fs::read(out.join("thesis.txt")).unwrap(), b"mine");
    assert_eq!(names(dir.path()), ["out", "out/thesis.txt"], "nothing is left beside it");
    // An empty folder gives way.
    fs::remove_file(out.join("thesis.txt")).unwrap();
    seal(begin(11, false)).unwrap();
    assert!(out.join("scene.ply").is_file());
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

/// Starts this test program again for one ignored test, in which the process kills itself at disk operation `at`. True when
/// it was killed.
#[cfg(unix)]
fn killed_at(test: &str, dir: &Path, at: u64) -> bool {
    use std::os::unix::process::ExitStatusExt as _;
    let name = format!("audit::publication::tests::{test}");
    let done = std::process::Command::new(std::env::current_exe().unwrap())
        .args(["--exact", &name, "--ignored", "--test-threads=1"])
        .env("ORB_TEST_KILL_DIR", dir)
        .env("ORB_TEST_KILL_AT", at.to_string())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&done.stdout);
    assert!(done.status.signal() == Some(libc::SIGKILL) || said.contains("1 passed"), "operation {at}: {said}");
    !done.status.success()
}

/// In the process to be killed: where it works, its key, its disk.
#[cfg(unix)]
fn to_be_killed() -> Option<(PathBuf, SigningKey, Disk)> {
    let dir = PathBuf::from(std::env::var_os("ORB_TEST_KILL_DIR")?);
    let at = std::env::var("ORB_TEST_KILL_AT").unwrap().parse().unwrap();
    let key = SigningKey::load(&dir.join("data/key.pem"), KeySource::NamedFile).unwrap();
    Some((dir, key, Disk { fault: Some(Plan::killing(at)) }))
}

#[cfg(unix)]
#[test]
#[ignore = "runs in a process of its own, which is killed"]
fn a_publication_to_be_killed() {
    let Some((dir, key, disk)) = to_be_killed() else { return };
    let to = Destination { replace: true, ..destination(&dir.join("out")) };
    let mut publication = Publication::begin_with(&to, disk.clone()).unwrap();
    publication.add("a/new.bin", b"new", "application/octet-stream", "x").unwrap();
    let lock = crate::audit::store_merge::lock_with(&dir.join("store"), disk.clone()).unwrap();
    publication.merge(merge_into_store(lock, &merge_files(), &[]).unwrap()).unwrap();
    let mut ledger = ledger(&dir).with_disk(disk);
    publication.seal(&later(1), &key, &mut ledger).unwrap();
}

/// Another run, a minute later.
#[cfg(unix)]
fn later(n: u8) -> RecordDraft {
    let mut draft = draft();
    draft.time.unix_ms += 60_000 * u64::from(n);
    draft.time.since_boot.as_mut().unwrap().milliseconds += 60_000 * u64::from(n);
    draft.event_random[0] = n;
    draft
}

#[cfg(unix)]
fn keep_key(dir: &Path) {
    shared_key().save(&dir.join("data/key.pem"), None).unwrap();
}

/// SIGKILL at every operation of a publication into a folder and a store: record, ledger, head, proof, both renames. What the
/// next run finds is the old result or the new one, whole, and the store that belongs to it.
#[cfg(unix)]
#[test]
fn a_kill_at_every_operation() {
    let (mut olds, mut news) = (0, 0);
    for at in 0.. {
        let dir = tempfile::tempdir().unwrap();
        let dir = dir.path();
        publish(dir);
        keep_key(dir);
        let (out, store) = (dir.join("out"), dir.join("store"));
        fs::create_dir(&store).unwrap();
        fs::write(store.join("there.txt"), "old").unwrap();
        let killed = killed_at("a_publication_to_be_killed", dir, at);

        // What a next run does before anything else.
        drop(Publication::begin(&Destination { replace: true, nonce: 8, ..destination(&out) }).unwrap());
        crate::audit::recover(&store).unwrap();
        assert!(!names(dir).iter().any(|n| n.contains(".orb")), "operation {at}: {:?}", names(dir));
        let is_new = out.join("a/new.bin").exists();
        assert_eq!(fs::read(store.join("there.txt")).unwrap() == b"new", is_new, "operation {at}");
        assert_eq!(store.join("added/too.txt").exists(), is_new, "operation {at}");
        let mut trust = TrustStore::default();
        trust.insert(shared_key().public().clone());
        let request = Request { store: Some(&store), ..Request::new(&out, &trust, 1_763_700_000_000) };
        let report = verify(&request).unwrap();
        assert_eq!(report.exit_code, 0, "operation {at}: {}", report.to_text());

        let mut ledger = ledger(dir);
        let append = |ledger: &mut Ledger| {
            let make = |next| record::seal(&later(2), Vec::new(), Outcome::Failure, None, next, shared_key());
            ledger.append(shared_key(), make, |_, _| Ok(())).unwrap();
        };
        append(&mut ledger);
        let chain = ledger.read_chain().unwrap();
        assert!(chain.len() == 3 || (chain.len() == 2 && !is_new), "operation {at}: {} records", chain.len());
        assert!(chain.iter().any(|s| s.predicate.trail_hash == report.trail_hash));
        let report = reconcile(ledger.path(), &[dir.to_owned()], &trust).unwrap();
        assert_eq!(report.exit_code, 0, "operation {at}: {}", report.to_text());
        *if is_new { &mut news } else { &mut olds } += 1;
        if !killed {
            break;
        }
    }
    assert!(olds > 30 && news > 3, "{olds} {news}");
}

#[cfg(unix)]
#[test]
#[ignore = "runs in a process of its own, which is killed"]
fn an_archive_to_be_killed() {
    let Some((dir, key, disk)) = to_be_killed() else { return };
    let ledger = ledger(&dir).with_disk(disk);
    crate::audit::archive::close(ledger, &dir.join("archive"), &key, later(1).invocation, later(1).time, [9; 10])
        .unwrap();
}

/// SIGKILL at every operation of closing a ledger: it stands whole at the old place or at the new one, and a next run goes on.
#[cfg(unix)]
#[test]
fn a_kill_at_every_operation_of_an_archive() {
    for at in 0.. {
        let dir = tempfile::tempdir().unwrap();
        let dir = dir.path();
        publish(dir);
        keep_key(dir);
        let killed = killed_at("an_archive_to_be_killed", dir, at);
        let mut ledger = ledger(dir);
        let archived = dir.join("archive/orb-ledger.jsonl");
        assert!(ledger.path().is_file() != archived.is_file(), "operation {at}");
        let before = if archived.is_file() { Ledger::at(archived).read_chain().unwrap().len() } else { 0 };
        let make = |next| record::seal(&later(2), Vec::new(), Outcome::Success, None, next, shared_key());
        ledger.append(shared_key(), make, |_, _| Ok(())).unwrap();
        let now = ledger.read_chain().unwrap().len();
        assert!(
            if before > 0 { (before, now) == (2, 1) } else { now == 2 || now == 3 },
            "operation {at}: {before} {now}"
        );
        if !killed {
            assert!(at > 8, "{at} operations");
            break;
        }
    }
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

#[test]
fn a_folder_that_the_run_works_in_becomes_the_published_one() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("part");
    std::fs::create_dir(&out).unwrap();
    std::fs::write(out.join("a.part"), b"made").unwrap();
    let own = ["a.part", "run.ckpt"];
    let to = destination(&out);
    assert!(Publication::begin(&to).is_err(), "a folder with other files");
    let begun = Publication::begin_over(&to, &own).unwrap();
    assert!(out.join("a.part").is_file(), "it is there until the seal");
    drop(begun);
    std::fs::write(out.join("b"), b"another's").unwrap();
    let refused = Publication::begin_over(&to, &own).unwrap_err().to_string();
    assert!(refused.contains("other files"), "{refused}");
    // Over an earlier result, beside which the run keeps what is its own.
    std::fs::remove_dir_all(&out).unwrap();
    let sealed = |replace: bool| {
        let to = Destination { replace, ..destination(&out) };
        let mut publication = Publication::begin_over(&to, &own).unwrap();
        publication.add("a.part", b"made", "application/octet-stream", "part").unwrap();
        let _ = std::fs::create_dir(&out);
        std::fs::write(out.join("run.ckpt"), b"half").unwrap();
        publication.seal(&draft(), shared_key(), &mut ledger(dir.path())).unwrap();
        assert!(out.join(RECORD).is_file() && !out.join("run.ckpt").exists());
    };
    sealed(false);
    sealed(true);
}
