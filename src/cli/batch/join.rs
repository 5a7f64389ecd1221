//! The shards' stores become one: what a shard wrote lies in its own geocells alone, so nothing is written over that another
//! shard has. Each joining is a record of its own, together with the files or not at all.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use orb_formats::File;
use serde_json::json;

use super::plan::Plan;
use super::shard::Shard;
use crate::audit::canonical::sha256_hex;
use crate::audit::disk::{self, Disk};
use crate::audit::publication::RECORD;
use crate::audit::statement::{Input, Param, Statement};
use crate::audit::store_merge::{lock_store, merge_into_store};
use crate::audit::{DataFolder, Marking, record, time, verify};
use crate::cli::geo_args;
use crate::cli::sealed::{Evidence, SealedRun};
use crate::{Error, Result};

/// Largest file of a store, bytes.
const LARGEST: u64 = 1 << 30;
/// The record's parameter that tells which contents of a shard's store were joined.
const CONTENTS: &str = "shard_store_sha256";

/// Joins every shard that has a store; `None` without one. In the order of the shards, so that the first store's Metadata are
/// the one's.
///
/// # Errors
/// Integrity where a shard wrote outside its geocells; as [`merge_into_store`] and sealing.
pub fn run(plan: &Plan) -> Result<Option<PathBuf>> {
    let stores: Vec<usize> =
        (0..plan.shards.len()).filter(|n| plan.shard(*n).join("store.cdb/Metadata").is_dir()).collect();
    if stores.is_empty() {
        return Ok(None);
    }
    let one = plan.output.join("store.cdb");
    Disk::default().create_dir_all(&one)?;
    for number in stores {
        join(plan, number, &one)?;
    }
    Ok(Some(one))
}

fn join(plan: &Plan, number: usize, one: &Path) -> Result<()> {
    let shard = &plan.shards[number];
    let from = plan.shard(number).join("store.cdb");
    // What a killed run left half there is undone first.
    drop(lock_store(&from)?);
    let entries = disk::walk(&from)?;
    let mut hashes = BTreeMap::new();
    for e in entries.iter().filter(|e| e.is_file) {
        check_place(shard, &e.name, &from)?;
        hashes.insert(e.name.clone(), disk::hash_file(&e.path).map_err(|error| Error::io(&e.path, &error))?.1);
    }
    let listing: String = hashes.iter().map(|(name, sha256)| format!("{sha256}  {name}\n")).collect();
    let contents = sha256_hex(listing.as_bytes());
    let folder = plan.output.join("joined").join(format!("{number:04}"));
    let (mut files, folders) = what_is_new(one, &entries, &hashes)?;
    if joined_before(&folder).is_some_and(|before| before == contents) {
        // What the one store has of it and is another by now was changed there since: it stays. What it lacks was lost.
        files.retain(|f| !one.join(&f.path).exists());
        if files.is_empty() && folders.is_empty() {
            return Ok(());
        }
    }
    let (inputs, rows) = records(plan, shard)?;
    let mut args = geo_args("photo.jpg", &plan.options)?;
    args.publish.replace = folder.is_dir();
    args.publish.quiet = true;
    let carried =
        inputs.iter().map(|i| i.marking.as_deref().map(Marking::parse).transpose()).collect::<Result<Vec<_>>>()?;
    let handling = args.publish.marking.decide(&carried, &time::now()?.utc())?;
    Disk::default().create_dir_all(&plan.output.join("joined"))?;
    let data = DataFolder::at(&plan.data);
    let mut run = SealedRun::begin_in(data, "orb batch", &folder, handling.clone(), &args.publish)?;
    let said = json!({
        "schema": "orb.batch-join/v1", "marking": handling.marking.banner(), "cells": shard.cells, "rows": rows,
        "store_files": hashes,
    });
    let said = serde_json::to_vec_pretty(&said).map_err(|e| Error::environment("the joining").found(e.to_string()))?;
    run.publication.add("shard.json", &said, "application/json", "listing")?;
    run.publication.merge(merge_into_store(lock_store(one)?, &files, &folders)?)?;
    let text = |v: String| Param::Text(v);
    let params = BTreeMap::from([
        (CONTENTS.to_owned(), text(contents)),
        ("geocells".to_owned(), text(shard.cells.join(" "))),
        ("manifest_sha256".to_owned(), text(plan.manifest_sha256.clone())),
        ("files_as_of".to_owned(), text(plan.as_of.clone())),
    ]);
    run.seal(Evidence { event_type: "store.join", time: time::now()?, inputs, models: Vec::new(), params }).map(drop)
}

/// Tiles are of the shard's geocells; libraries are of the one shard that has them; Metadata are everyone's.
fn check_place(shard: &Shard, name: &str, store: &Path) -> Result<()> {
    let parts: Vec<&str> = name.split('/').collect();
    let own = match parts.as_slice() {
        ["Metadata", ..] => true,
        ["Tiles", latitude, longitude, ..] => shard.cells.contains(&format!("{latitude}{longitude}")),
        ["GTModel" | "MModel", ..] => shard.shared,
        _ => false,
    };
    match own {
        true => Ok(()),
        false => Err(Error::integrity(store.join(name).display().to_string())
            .expected(format!("files in the shard's own geocells: {}", shard.cells.join(" ")))
            .found("one elsewhere")
            .advice("Nothing of this shard was joined.")),
    }
}

fn statement(folder: &Path) -> Option<Statement> {
    verify::read_record(folder).ok().map(|(_, statement)| statement)
}

fn joined_before(folder: &Path) -> Option<String> {
    match statement(folder)?.predicate.params.get(CONTENTS)? {
        Param::Text(text) => Some(text.clone()),
        _ => None,
    }
}

/// The records of what the shard's rows published, as inputs; and the rows by name.
fn records(plan: &Plan, shard: &Shard) -> Result<(Vec<Input>, Vec<serde_json::Value>)> {
    let (_, lines) = crate::cli::geo::manifest::read(&plan.manifest)?;
    let of_shard: BTreeSet<usize> = shard.lines.iter().copied().collect();
    let (mut inputs, mut rows) = (Vec::new(), Vec::new());
    for line in lines.iter().filter(|l| of_shard.contains(&l.number)) {
        let Some(name) = line.name() else { continue };
        let folder = plan.output.join(&name);
        // A row that failed is not in the store.
        let Some(statement) = statement(&folder) else { continue };
        let bytes = disk::read_limited(&folder.join(RECORD), LARGEST)?;
        let input =
            record::input(&format!("{name}/{RECORD}"), &bytes, "application/json", "record", statement.marking());
        rows.push(json!({"line": line.number, "name": name, "record_sha256": input.sha256}));
        inputs.push(input);
    }
    Ok((inputs, rows))
}

/// Files that the one store does not have so; Metadata that it has stay as they are.
fn what_is_new(
    one: &Path,
    entries: &[disk::Entry],
    hashes: &BTreeMap<String, String>,
) -> Result<(Vec<File>, Vec<String>)> {
    let mut files = Vec::new();
    for e in entries.iter().filter(|e| e.is_file) {
        let there = one.join(&e.name);
        let is_same = || disk::hash_file(&there).is_ok_and(|(_, sha256)| hashes.get(&e.name) == Some(&sha256));
        if there.is_file() && (e.name.starts_with("Metadata/") || is_same()) {
            continue;
        }
        let bytes = disk::read_limited(&e.path, LARGEST)?;
        files.push(File { path: e.name.clone(), bytes, media_type: media_type(&e.name) });
    }
    let folders = entries.iter().filter(|e| e.is_dir && !one.join(&e.name).is_dir()).map(|e| e.name.clone()).collect();
    Ok((files, folders))
}

/// As the store's own writers have them.
fn media_type(name: &str) -> &'static str {
    match name.rsplit('.').next().unwrap_or_default() {
        "xml" | "xsd" => "application/xml",
        "zip" => "application/zip",
        "tif" => "image/tiff",
        "jp2" => "image/jp2",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::keys::tests::shared_key;

    #[test]
    fn what_the_joined_store_lost_comes_back() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        shared_key()
            .save(&DataFolder::at(at("data")).subfolder("keys").unwrap().join("orb-signing.pem"), None)
            .unwrap();
        std::fs::write(at("rows.csv"), "photo\n").unwrap();
        let plan: Plan = serde_json::from_value(json!({
            "schema": "", "output": at("out"), "manifest": at("rows.csv"), "manifest_sha256": "", "options": [],
            "iterations": 1, "threads": 1, "as_of": "", "data": at("data"), "store": true, "refused": [],
            "shards": [{"lines": [2], "cells": ["N34W119"], "shared": false}],
        }))
        .unwrap();
        let [tile, other] = ["Tiles/N34/W119/a.zip", "Tiles/N34/W119/b.zip"];
        for name in ["Metadata/Version.xml", tile, other] {
            let path = plan.shard(0).join("store.cdb").join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, name).unwrap();
        }
        let one = run(&plan).unwrap().unwrap();
        let text = |name: &str| std::fs::read_to_string(one.join(name)).unwrap_or_default();
        let record = || std::fs::read(plan.output.join("joined/0000").join(RECORD)).unwrap();
        assert_eq!(text(tile), tile);
        // Once more: as it was.
        let before = record();
        run(&plan).unwrap();
        assert_eq!(record(), before);
        // What was changed there since stays, and what was lost comes back beside it.
        std::fs::write(one.join(tile), "changed").unwrap();
        run(&plan).unwrap();
        assert_eq!((text(tile).as_str(), record()), ("changed", before));
        std::fs::remove_file(one.join(other)).unwrap();
        run(&plan).unwrap();
        assert_eq!((text(tile).as_str(), text(other).as_str()), ("changed", other));
        std::fs::remove_dir_all(&one).unwrap();
        run(&plan).unwrap();
        assert_eq!((text(tile).as_str(), text(other).as_str()), (tile, other));
    }

    #[test]
    fn a_shard_writes_into_its_own_cells() {
        let shard = |shared| Shard { lines: vec![2], cells: vec!["N34W119".into()], shared };
        for (name, alone, shared) in [
            ("Metadata/Version.xml", true, true),
            ("Tiles/N34/W119/100_GSFeature/x.dbf", true, true),
            ("Tiles/N35/W119/100_GSFeature/x.dbf", false, false),
            ("GTModel/x.zip", false, true),
            ("notes.txt", false, false),
            ("Tiles", false, false),
        ] {
            let fits = |shared| check_place(&shard(shared), name, Path::new("s")).is_ok();
            assert_eq!((fits(false), fits(true)), (alone, shared), "{name}");
        }
    }
}
