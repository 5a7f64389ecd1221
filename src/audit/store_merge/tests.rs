use std::collections::BTreeMap;
use std::io::ErrorKind;

use super::*;
use crate::audit::disk::fault::Plan;
use crate::audit::ledger::tests::recorded;

/// Paths and bytes; folders end in `/`.
type Tree = BTreeMap<String, Vec<u8>>;

fn tree(root: &Path) -> Tree {
    disk::walk(root)
        .unwrap()
        .into_iter()
        .filter(|e| !e.name.starts_with(".orb-merge"))
        .map(|e| if e.is_dir { (format!("{}/", e.name), Vec::new()) } else { (e.name, fs::read(&e.path).unwrap()) })
        .collect()
}

fn file(path: &str, text: &str) -> orb_formats::File {
    orb_formats::File { path: path.into(), bytes: text.into(), media_type: "application/octet-stream" }
}

fn store(root: &Path) {
    fs::create_dir_all(root.join("Tiles/N34")).unwrap();
    fs::create_dir_all(root.join("Metadata")).unwrap();
    fs::write(root.join("Metadata/Version.xml"), "old version").unwrap();
    fs::write(root.join("Tiles/N34/points.dbf"), "old points").unwrap();
    fs::write(root.join("Tiles/N34/other.zip"), "other").unwrap();
}

fn change() -> (Vec<orb_formats::File>, Vec<String>) {
    let files = vec![
        file("Tiles/N34/points.dbf", "new points"),
        file("Tiles/N34/W119/model.flt", "model"),
        file("Tiles/N34/W119/U0/texture.rgb", "texture"),
        file("root.txt", "root"),
    ];
    (files, vec!["Metadata/Stylesheet".into(), "Tiles/N34".into()])
}

fn merge_with(root: &Path, disk: Disk) -> Result<()> {
    let (files, folders) = change();
    merge_into_store(lock_with(root, disk)?, &files, &folders)?.commit()
}

#[test]
fn a_merge_keeps_what_is_there() {
    let dir = tempfile::tempdir().unwrap();
    store(dir.path());
    let mut expected = tree(dir.path());
    merge_with(dir.path(), Disk::default()).unwrap();
    for name in ["Metadata/Stylesheet/", "Tiles/N34/W119/", "Tiles/N34/W119/U0/"] {
        expected.insert(name.into(), Vec::new());
    }
    for file in change().0 {
        expected.insert(file.path, file.bytes);
    }
    assert_eq!(tree(dir.path()), expected);
    assert!(!dir.path().join(WORK).exists() && !dir.path().join(DONE).exists());
}

/// Every operation fails once, alone (a full disk) and with all that follow (a kill).
#[test]
fn old_or_new_never_a_mix() {
    let reference = tempfile::tempdir().unwrap();
    store(reference.path());
    let old = tree(reference.path());
    merge_with(reference.path(), Disk::default()).unwrap();
    let new = tree(reference.path());

    let (mut olds, mut news) = (0, 0);
    for crash in [false, true] {
        for at in 0.. {
            let dir = tempfile::tempdir().unwrap();
            store(dir.path());
            let plan = Plan::new(at, crash, ErrorKind::StorageFull);
            let result = merge_with(dir.path(), Disk { fault: Some(plan.clone()) });
            if !plan.was_hit() {
                assert!(result.is_ok());
                break;
            }
            if !crash {
                let expected = if result.is_ok() { &new } else { &old };
                // Without the sweep of a next run: the journal's folder may stay, the store must not change.
                assert_eq!(&tree(dir.path()), expected, "failure at {at}");
            }
            recover(dir.path()).unwrap();
            let found = tree(dir.path());
            assert!(found == if result.is_ok() { new.clone() } else { old.clone() }, "operation {at}: {found:?}");
            assert!(!dir.path().join(WORK).exists() && !dir.path().join(DONE).exists());
            if found == old {
                olds += 1
            } else {
                news += 1
            }
            // And the store can be written again.
            merge_with(dir.path(), Disk::default()).unwrap();
            assert_eq!(tree(dir.path()), new);
        }
    }
    assert!(olds > 40 && news > 0, "{olds} {news}");
}

/// A kill, then a kill at every step of the recovery.
#[test]
fn a_killed_recovery_is_continued() {
    let reference = tempfile::tempdir().unwrap();
    store(reference.path());
    let old = tree(reference.path());
    for first in [24, 26, 28, 30] {
        for second in 0.. {
            let dir = tempfile::tempdir().unwrap();
            store(dir.path());
            let plan = Plan::new(first, true, ErrorKind::Other);
            assert!(merge_with(dir.path(), Disk { fault: Some(plan) }).is_err());
            let plan = Plan::new(second, true, ErrorKind::Other);
            let _ = lock_with(dir.path(), Disk { fault: Some(plan.clone()) });
            recover(dir.path()).unwrap();
            assert_eq!(tree(dir.path()), old, "{first} {second}");
            if !plan.was_hit() {
                break;
            }
        }
    }
}

#[test]
fn dropped_or_rolled_back_means_untouched() {
    let dir = tempfile::tempdir().unwrap();
    store(dir.path());
    let old = tree(dir.path());
    let (files, folders) = change();
    drop(merge_into_store(lock_store(dir.path()).unwrap(), &files, &folders).unwrap());
    assert_eq!(tree(dir.path()), old);
    let mut merge = merge_into_store(lock_store(dir.path()).unwrap(), &files, &folders).unwrap();
    assert_eq!(merge.subjects().len(), 4);
    merge.apply(recorded(), Path::new("/nowhere")).unwrap();
    assert_ne!(tree(dir.path()), old);
    merge.rollback().unwrap();
    assert_eq!(tree(dir.path()), old);
    assert!(!dir.path().join(WORK).exists());
}

#[test]
fn one_writer_at_a_time() {
    let dir = tempfile::tempdir().unwrap();
    let first = lock_store(dir.path()).unwrap();
    assert_eq!(lock_store(dir.path()).unwrap_err().kind, Kind::Environment);
    drop(first);
    lock_store(dir.path()).unwrap();
}

#[test]
fn paths_that_leave_the_store() {
    let dir = tempfile::tempdir().unwrap();
    store(dir.path());
    let before = tree(dir.path());
    for path in ["../x", "/x", "a/../../x", "Metadata", "Metadata/Version.xml/x", ""] {
        let error = merge_into_store(lock_store(dir.path()).unwrap(), &[file(path, "")], &[]).unwrap_err();
        assert!(error.found.contains("PATH_REFUSED"), "{path}: {error}");
    }
    let twice = [file("a", "1"), file("A", "2")];
    assert!(merge_into_store(lock_store(dir.path()).unwrap(), &twice, &[]).is_err());
    #[cfg(unix)]
    {
        let outside = tempfile::tempdir().unwrap();
        std::os::unix::fs::symlink(outside.path(), dir.path().join("link")).unwrap();
        let error = merge_into_store(lock_store(dir.path()).unwrap(), &[file("link/x", "")], &[]).unwrap_err();
        assert!(error.found.contains("PATH_REFUSED"));
        fs::remove_file(dir.path().join("link")).unwrap();
        assert_eq!(outside.path().read_dir().unwrap().count(), 0);
    }
    assert_eq!(tree(dir.path()), before);
    let error = lock_store(&dir.path().join("Metadata/Version.xml")).unwrap_err();
    assert_eq!(error.kind, Kind::Usage);
}
