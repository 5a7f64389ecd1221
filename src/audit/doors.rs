//! No way around the ledger: a search of the source for everything that changes a disk. Whoever adds a place has to name it
//! here, with what it writes; outputs go through [`super::Publication`], whose last step takes a
//! [`super::ledger::Recorded`], which only an append to the ledger makes.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::disk;

/// Words that change a disk.
const DOORS: [&str; 24] = [
    "fs::write",
    "File::create",
    "File::options",
    "OpenOptions",
    "fs::rename",
    "fs::copy",
    "hard_link",
    "symlink(",
    "fs::create_dir",
    "DirBuilder",
    "fs::remove_",
    "set_len(",
    "set_permissions",
    "renameat2",
    "persist(",
    ".save(",
    ".save_with_format(",
    "save_buffer",
    "to_file(",
    "Disk::default",
    "Disk {",
    ".write_new(",
    "whole_file::write",
    "Connection::open",
];

/// Who may, and what it is that they write. None but the first three touches a published folder or a store.
const KEEPERS: [(&str, &str); 39] = [
    ("src/audit/publication.rs", "outputs, staged; the door itself"),
    ("src/audit/publication/place.rs", "outputs, put in place once their record stands"),
    ("src/audit/store_merge.rs", "files of a store, put in place once their record stands"),
    ("src/audit/archive.rs", "a closed ledger's checkpoint"),
    ("src/audit/data_folder.rs", "the user's own folder"),
    ("src/audit/disk.rs", "what the others ask for"),
    ("src/audit/keys/file.rs", "keys"),
    ("src/audit/keys/for_run.rs", "the user's own key"),
    ("src/audit/ledger.rs", "the ledger"),
    ("src/audit/ledger/head.rs", "the ledger's head"),
    ("src/audit/ledger/lines.rs", "the ledger: half a line, set aside"),
    ("src/audit/trust.rs", "the trust store"),
    ("src/cli/audit/export.rs", "a verified record for other systems"),
    ("src/cli/audit/ledger.rs", "a checkpoint to be kept elsewhere"),
    ("src/cli/audit/report.rs", "what a verification found"),
    ("src/cli/audit/timestamp.rs", "a request for a time stamp, and the token beside a record"),
    ("src/cli/batch/join.rs", "the empty folders that joined stores and their records are published in"),
    ("src/cli/batch/plan.rs", "a batch's own folder: its plan, how shards ended"),
    ("src/cli/batch/task.rs", "a batch's own folder: a shard's lock and log"),
    ("src/cli/bench/run.rs", "the empty folders that the runs to be scored publish in, and their end"),
    ("src/cli/geo/manifest.rs", "the empty folder that results of many photos are published in"),
    ("src/cli/train/parts.rs", "the empty folder that parts of a scene are published in"),
    ("src/memory.rs", "the kernel's counter of this process's memory"),
    ("src/models/engine/ort.rs", "the folder of TensorRT's engines"),
    ("src/models/registry/import.rs", "imported networks"),
    ("src/models/registry/import/gather.rs", "imported networks, staged"),
    ("src/models/registry/mod.rs", "imported networks, removed"),
    ("src/models/zero123/cache.rs", "views already made"),
    ("src/pipeline/scene/blocks.rs", "the checkpoint of a part of a scene, gone when the part stands"),
    ("src/pipeline/scene/blocks/part.rs", "parts of a scene that is trained in blocks"),
    ("src/photos/sfm.rs", "COLMAP's work folder, its own and gone afterwards"),
    ("src/serve/api/form.rs", "the files of a submission, in the server's own folder"),
    ("src/serve/api/submit.rs", "the same, named"),
    ("src/serve/database/sqlite.rs", "the server's accounts and jobs"),
    (
        "src/serve/place.rs",
        "the server's own folder and its name: photos come and go, what runs publish in it goes with its job",
    ),
    ("src/splat/render/gpu/cache.rs", "compiled shaders"),
    ("src/splat/render/gpu/device.rs", "compiled shaders"),
    ("src/splat/train/checkpoint.rs", "a fit that goes on later"),
    ("src/view/open.rs", "the page that leads the user's browser to the viewer, gone when the viewer ends"),
];

/// Files written for `--checkpoint`, caches and the like, aside and whole.
const WHOLE_FILE: &str = "src/whole_file.rs";

/// The source without its tests.
fn shipped(text: &str) -> String {
    let mut out = String::new();
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        let next = lines.peek().map_or("", |l| l.trim_start());
        if line == "#[cfg(test)]" && next.contains("mod ") && next.ends_with('{') {
            break;
        }
        let code = line.split_once("//").map_or(line, |(code, _)| code);
        out.push_str(code);
        out.push('\n');
    }
    out
}

#[test]
fn only_these_files_change_a_disk() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for folder in ["src", "formats/src"] {
        for entry in disk::walk(&root.join(folder)).unwrap() {
            let name = format!("{folder}/{}", entry.name);
            let is_test = ["/tests", "/suite_tests.rs", "/tamper_corpus", "/doors.rs"].iter().any(|t| name.contains(t));
            if !name.ends_with(".rs") || is_test {
                continue;
            }
            let text = shipped(&fs::read_to_string(&entry.path).unwrap());
            for (number, line) in text.lines().enumerate() {
                if let Some(door) = DOORS.iter().find(|door| line.contains(*door)) {
                    found.entry(name.clone()).or_default().push(format!("{name}:{}: {door}", number + 1));
                }
            }
        }
    }
    let keepers: Vec<&str> = KEEPERS.iter().map(|(name, _)| *name).chain([WHOLE_FILE]).collect();
    let strangers: Vec<&String> =
        found.iter().filter(|(name, _)| !keepers.contains(&name.as_str())).flat_map(|(_, lines)| lines).collect();
    assert!(strangers.is_empty(), "these change a disk and are not among the keepers: {strangers:#?}");
    let idle: Vec<&&str> = keepers.iter().filter(|name| !found.contains_key(**name)).collect();
    assert!(idle.is_empty(), "these are keepers and change nothing: {idle:#?}");
}

/// The last step of a publication and of a merge can be taken in one place each, by who shows that the record stands.
#[test]
fn the_last_step_wants_a_record() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/audit");
    let mut makers = Vec::new();
    for entry in disk::walk(&root).unwrap() {
        if !entry.name.ends_with(".rs") || entry.name.ends_with("doors.rs") {
            continue;
        }
        let text = shipped(&fs::read_to_string(&entry.path).unwrap());
        makers.extend(text.matches("Recorded(").map(|_| entry.name.clone()));
    }
    // Its definition, and the end of an append.
    assert_eq!(makers, ["ledger.rs", "ledger.rs"]);
    let text = shipped(&fs::read_to_string(root.join("ledger.rs")).unwrap());
    let (_, append) = text.split_once("fn append_to(").unwrap();
    let (written, made) = (append.find("self.disk.append(").unwrap(), append.find("Recorded(sealed)").unwrap());
    assert!(written < made);
}
