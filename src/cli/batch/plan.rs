//! What a batch will do, decided once and kept in its folder: every task and every later run reads the same.
//!
//! ```text
//! OUTPUT/NAME/              what a row published
//! OUTPUT/store.cdb/         the one store
//! OUTPUT/joined/NNNN/       the record of each shard's joining it
//! OUTPUT/.batch/plan.json   this
//! OUTPUT/.batch/NNNN/       a shard: its rows, its store, how it ended, its log
//! ```

use std::fs::File;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::BatchArgs;
use super::shard::{Row, Shard, shards};
use crate::audit::canonical::sha256_hex;
use crate::audit::disk::{self, Disk};
use crate::audit::file_lock::FileLock;
use crate::audit::{DataFolder, time};
use crate::cli::format::{Format, StoreKind};
use crate::cli::geo::manifest::{self, Line};
use crate::cli::geo::{self, GeoArgs, options};
use crate::photo;
use crate::{Error, Result};

const SCHEMA: &str = "orb.batch/v1";
const LARGEST: u64 = 256 << 20;
/// Degrees of latitude, 11 km: further than a subject may stand from its camera, or its terrain reach.
const REACH: f64 = 0.1;
/// What a batch decides itself.
const OWN: [&str; 9] = [
    "--manifest",
    "--output",
    "--cdb",
    "--cdb-version-of",
    "--replace",
    "--json",
    "--checkpoint",
    "--resume",
    "--as-of",
];

/// A row that came to nothing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Failed {
    /// Of the manifest.
    pub line: usize,
    pub words: String,
}

/// How a shard ended.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    pub published: usize,
    pub already: usize,
    pub failed: Vec<Failed>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    schema: String,
    pub output: PathBuf,
    pub manifest: PathBuf,
    pub manifest_sha256: String,
    /// Of `orb geo`, for every row.
    pub options: Vec<String>,
    pub iterations: u32,
    pub threads: u32,
    /// The time that files carry.
    pub as_of: String,
    /// Keys and ledger.
    pub data: PathBuf,
    /// Rows go into a CDB store.
    pub store: bool,
    pub shards: Vec<Shard>,
    /// Rows that cannot be run.
    pub refused: Vec<Failed>,
}

impl Plan {
    /// Makes the plan and its folder, or takes up the one that is there.
    ///
    /// # Errors
    /// Usage: a manifest or options that cannot be read, a folder with another batch. Environment.
    pub fn make(args: &BatchArgs, manifest: &Path) -> Result<Plan> {
        let absolute = |path: &Path| std::path::absolute(path).map_err(|e| Error::io(path, &e));
        let manifest = absolute(manifest)?;
        let stem = manifest.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let output = absolute(args.output.as_deref().unwrap_or(Path::new(&stem)))?;
        let geo = geo_options(&args.geo)?;
        let (text, lines) = manifest::read(&manifest)?;
        let as_of = match &args.as_of {
            Some(text) => time::parse_utc(text).map(|_| text.clone()).ok_or_else(|| {
                Error::usage("--as-of").expected("a time as 2026-01-31T12:00:00.000Z").found(text.clone())
            })?,
            None => time::now()?.utc(),
        };
        let (shards, refused) = divide(&manifest, &geo, &lines);
        let beside = manifest.parent().unwrap_or(Path::new(""));
        let several = lines.iter().filter_map(Line::photo).any(|p| beside.join(p).is_dir());
        let fresh = Plan {
            schema: SCHEMA.into(),
            manifest_sha256: sha256_hex(text.as_bytes()),
            iterations: geo.effort.steps(several, args.threads as usize, false),
            threads: args.threads,
            as_of,
            data: DataFolder::from_environment(|name| std::env::var_os(name))?.path().to_owned(),
            store: geo.format.contains(&Format::Cdb),
            options: args.geo.clone(),
            shards,
            refused,
            output,
            manifest,
        };
        if !fresh.work().join("plan.json").exists() {
            Disk::default().create_dir_all(&fresh.work())?;
            fresh.put("plan.json", &fresh)?;
            return Ok(fresh);
        }
        let kept = Plan::read(&fresh.output)?;
        let as_of = if args.as_of.is_some() { fresh.as_of.clone() } else { kept.as_of.clone() };
        // Rows may have become usable since: a photo that was missing.
        let same = Plan { as_of, refused: kept.refused.clone(), shards: kept.shards.clone(), ..fresh.clone() };
        if same != kept {
            return Err(Error::usage(kept.output.display().to_string())
                .expected("the batch that was begun there: the same manifest, options, threads and time")
                .found("another")
                .advice("Give the command that began it, or another folder with -o."));
        }
        // A shard's store is its number's: it stays only while its rows do.
        if !kept.shards.iter().all(|old| fresh.shards.contains(old)) {
            return Err(Error::usage(kept.output.display().to_string())
                .expected("rows that fit the shards of before")
                .found("rows that could not be placed then, and belong to them now")
                .advice("Begin anew in another folder with -o."));
        }
        let new = fresh.shards.into_iter().filter(|shard| !kept.shards.contains(shard));
        let shards = kept.shards.iter().cloned().chain(new).collect();
        let grown = Plan { shards, refused: fresh.refused, ..kept };
        grown.put("plan.json", &grown)?;
        Ok(grown)
    }

    /// The plan in a batch's folder.
    ///
    /// # Errors
    /// Environment; usage for what is none.
    pub fn read(output: &Path) -> Result<Plan> {
        let path = std::path::absolute(output).map_err(|e| Error::io(output, &e))?.join(".batch/plan.json");
        let bytes = disk::read_limited(&path, LARGEST)?;
        let wrong = |found: String| Error::usage(path.display().to_string()).expected("a batch's plan").found(found);
        let plan: Plan = serde_json::from_slice(&bytes).map_err(|e| wrong(e.to_string()))?;
        if plan.schema == SCHEMA { Ok(plan) } else { Err(wrong(plan.schema)) }
    }

    pub fn work(&self) -> PathBuf {
        self.output.join(".batch")
    }

    pub fn shard(&self, number: usize) -> PathBuf {
        self.work().join(format!("{number:04}"))
    }

    pub fn lines(&self) -> usize {
        self.shards.iter().map(|s| s.lines.len()).sum::<usize>() + self.refused.len()
    }

    /// Held by the one that leads the batch.
    ///
    /// # Errors
    /// Environment, where another does.
    pub fn lock(&self) -> Result<FileLock> {
        let path = self.work().join("lock");
        let file = File::options().create(true).append(true).open(&path).map_err(|e| Error::io(&path, &e))?;
        FileLock::try_take(file).map_err(|e| {
            Error::environment(path.display().to_string())
                .expected("nobody else at this batch")
                .found(e.to_string())
                .advice("Wait for the other one, or end it.")
        })
    }

    /// How a shard's last run ended; `None` where it has not, or was killed.
    pub fn outcome(&self, number: usize) -> Option<Outcome> {
        let bytes = disk::read_limited(&self.shard(number).join("outcome.json"), LARGEST).ok()?;
        serde_json::from_slice(&bytes).ok()
    }

    /// Before a run: how the last one ended says nothing any more.
    ///
    /// # Errors
    /// Environment.
    pub fn forget(&self, numbers: &[usize]) -> Result<()> {
        for number in numbers {
            let path = self.shard(*number).join("outcome.json");
            if path.exists() {
                Disk::default().remove_file(&path)?;
            }
        }
        Ok(())
    }

    /// Writes a file of the batch's own folder, whole or not at all.
    ///
    /// # Errors
    /// Environment.
    pub fn put(&self, name: &str, value: &impl Serialize) -> Result<()> {
        let text = serde_json::to_vec_pretty(value).map_err(|e| Error::environment(name).found(e.to_string()))?;
        self.put_bytes(name, &text).map(drop)
    }

    /// As [`Plan::put`]; its path.
    ///
    /// # Errors
    /// Environment.
    pub fn put_bytes(&self, name: &str, bytes: &[u8]) -> Result<PathBuf> {
        let (disk, path) = (Disk::default(), self.work().join(name));
        let draft = path.with_extension("draft");
        if draft.exists() {
            disk.remove_file(&draft)?;
        }
        if let Some(folder) = path.parent() {
            disk.create_dir_all(folder)?;
        }
        disk.write_new(&draft, bytes)?;
        disk.rename(&draft, &path)?;
        Ok(path)
    }
}

/// The options of all rows, without those that a batch decides.
fn geo_options(given: &[String]) -> Result<GeoArgs> {
    let is_own = |word: &String| {
        let name = word.split('=').next().unwrap_or_default();
        OWN.contains(&name) || word.starts_with("-o")
    };
    if let Some(word) = given.iter().find(|word| is_own(word)) {
        return Err(Error::usage("the options behind --")
            .expected("options of orb geo that say what is made, not where")
            .found(word.clone()));
    }
    crate::cli::geo_args("photo.jpg", given)
}

/// Shards, and rows that cannot be run.
fn divide(manifest: &Path, geo: &GeoArgs, lines: &[Line]) -> (Vec<Shard>, Vec<Failed>) {
    let base = manifest.parent().unwrap_or(Path::new(""));
    let in_store = geo.format.contains(&Format::Cdb);
    let (mut rows, mut refused, mut names) = (Vec::new(), Vec::new(), Vec::new());
    for line in lines {
        let row = name(line, &mut names).and_then(|()| row(line, geo, base));
        match row {
            Ok(row) => rows.push(row),
            Err(e) => refused.push(Failed { line: line.number, words: e.to_string() }),
        }
    }
    let shards = match in_store {
        true => shards(&rows),
        // Nothing is shared: a row alone.
        false => rows.iter().flat_map(|row| shards(&[*row])).collect(),
    };
    (shards, refused)
}

fn name(line: &Line, taken: &mut Vec<(String, usize)>) -> Result<()> {
    let Some(name) = line.name() else { return Ok(()) };
    if let Some((_, earlier)) = taken.iter().find(|(n, _)| *n == name) {
        return Err(Error::usage("name")
            .expected("a name of its own")
            .found(format!("`{name}`, which line {earlier} has"))
            .advice("Fill the column `name`."));
    }
    taken.push((name, line.number));
    Ok(())
}

fn row(line: &Line, geo: &GeoArgs, base: &Path) -> Result<Row> {
    let mut own = geo.clone();
    let photo = base.join(line.apply(&mut own)?);
    own.photos.check(photo.is_dir())?;
    let wanted = options::wanted(&own.place, &own.size)?;
    let exif = if wanted.origin.is_some() {
        photo::Exif::default()
    } else {
        if photo.is_dir() {
            return Err(Error::usage("origin")
                .expected("a place, by which rows are kept apart")
                .found("a folder of photos without one"));
        }
        let limits = photo::Limits::default();
        let bytes = geo::read_photo(&photo, limits.file_bytes)?;
        photo::metadata(&photo.display().to_string(), &bytes, &limits)?.0
    };
    let (latitude, longitude, of_camera) = wanted.roughly(&exif)?;
    let far = of_camera || own.write.ground.ground;
    let shared = own.write.kind != StoreKind::Gs;
    Ok(Row { line: line.number, latitude, longitude, reach: if far { REACH } else { 0.0 }, shared })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_that_no_run_would_take_are_refused_before_the_work() {
        let dir = tempfile::tempdir().unwrap();
        let manifest = dir.path().join("site.csv");
        std::fs::write(
            &manifest,
            "photo,name,origin,pitch\na.jpg,level,\"34.55,-118.47,740\",-30\na.jpg,over,\"34.55,-118.47,740\",91\n\
             .,several,\"34.55,-118.47,740\",-30\n",
        )
        .unwrap();
        let (_, lines) = manifest::read(&manifest).unwrap();
        let (shards, refused) = divide(&manifest, &geo_options(&[]).unwrap(), &lines);
        assert_eq!(shards.len(), 1);
        // A pitch of one camera that cannot be, and one of many cameras.
        assert_eq!(refused.iter().map(|f| f.line).collect::<Vec<_>>(), [3, 4]);
        assert!(refused.iter().all(|f| f.words.contains("--pitch")), "{}", refused[1].words);
    }
}
