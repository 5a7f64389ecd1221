//! `orb cdb check`: a CDB store against the rules that can be checked without its simulator.

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use orb_formats::cdb::{self, ListableStore, Store, Verdict};
use serde_json::json;

use super::audit::Outcome;
use crate::export::format_error;
use crate::{Error, Result};

#[derive(Debug, Args)]
pub struct CdbArgs {
    #[command(subcommand)]
    pub verb: CdbVerb,
}

#[derive(Debug, Subcommand)]
pub enum CdbVerb {
    /// Say of every rule whether the store passes it, breaks it, or has nothing that it speaks of
    Check(CheckArgs),
}

#[derive(Debug, Args)]
pub struct CheckArgs {
    /// The root of a store: the folder that holds Metadata and Tiles. The versions that it continues are read with it
    pub root: PathBuf,
    /// One JSON object on standard output
    #[arg(long)]
    pub json: bool,
}

/// Runs the verb: exit code 1 where a rule is broken.
///
/// # Errors
/// Usage for a folder that is no store, environment for one that cannot be read.
pub fn run(args: &CdbArgs) -> Result<Outcome> {
    let CdbVerb::Check(args) = &args.verb;
    let chain = Chain(Folder::with_previous(&args.root)?);
    let report = cdb::report(&chain).map_err(format_error)?;
    let broken = report.rules.iter().any(|r| matches!(r.verdict, Verdict::Fail(_)));
    let text = if args.json { json_text(&report) } else { plain_text(&report) };
    Ok(Outcome { text, exit_code: u8::from(broken) })
}

fn plain_text(report: &cdb::Report) -> String {
    let mut out = format!("{} files\n", report.files);
    for rule in &report.rules {
        let (word, detail) = match &rule.verdict {
            Verdict::Pass => ("pass", String::new()),
            Verdict::NotApplicable(why) => ("n/a ", format!(" ({why})")),
            Verdict::Fail(findings) => ("FAIL", format!(" ({} findings)", findings.len())),
        };
        let tests = match rule.abstract_tests {
            "" => String::new(),
            numbers => format!("; abstract tests {numbers}"),
        };
        out += &format!("{word} {:2} {} [{}{tests}]{detail}\n", rule.number, rule.title, rule.source);
        if let Verdict::Fail(findings) = &rule.verdict {
            for f in findings {
                out += &format!("        {}: {}\n", f.path, f.text);
            }
        }
    }
    out
}

fn json_text(report: &cdb::Report) -> String {
    let rules: Vec<_> = report
        .rules
        .iter()
        .map(|r| {
            let (verdict, why, findings) = match &r.verdict {
                Verdict::Pass => ("pass", None, Vec::new()),
                Verdict::NotApplicable(why) => ("not applicable", Some(*why), Vec::new()),
                Verdict::Fail(all) => {
                    ("fail", None, all.iter().map(|f| json!({"path": f.path, "text": f.text})).collect())
                }
            };
            json!({"rule": r.number, "title": r.title, "source": r.source, "abstract_tests": r.abstract_tests, "verdict": verdict, "why": why,
                   "findings": findings})
        })
        .collect();
    format!("{}\n", json!({"schema": "orb.cdb-check/v1", "files": report.files, "rules": rules}))
}

/// A store in a folder.
pub struct Folder {
    pub root: PathBuf,
}

impl Folder {
    /// A store and the versions that it continues, newest first, at absolute roots.
    ///
    /// # Errors
    /// Usage for a folder that is no store, and for a chain that is longer than the standard has it or does not end.
    pub fn with_previous(root: &Path) -> Result<Vec<Folder>> {
        let mut folders = vec![Folder::open(root)?];
        while let Some(previous) = cdb::previous_version(&folders[folders.len() - 1]).map_err(format_error)? {
            if folders.len() == cdb::MAX_VERSIONS {
                return Err(Error::usage(root.display().to_string())
                    .expected(format!("a chain of at most {} versions", cdb::MAX_VERSIONS))
                    .found("a longer one"));
            }
            let from = &folders[folders.len() - 1].root;
            folders.push(Folder::open(&from.join(previous.replace('\\', "/")))?);
        }
        Ok(folders)
    }

    fn open(root: &Path) -> Result<Folder> {
        let name = || root.display().to_string();
        if !root.is_dir() {
            return Err(Error::usage(name()).expected("the root folder of a CDB store"));
        }
        if !root.join("Metadata").is_dir() && !root.join("Tiles").is_dir() {
            return Err(Error::usage(name()).expected("a folder with Metadata or Tiles in it").found("neither"));
        }
        let root = root.canonicalize().map_err(|e| Error::io(root, &e))?;
        Ok(Folder { root })
    }

    /// The paths of all files.
    fn list(&self) -> io::Result<Vec<String>> {
        let mut found = Vec::new();
        let mut open = vec![(self.root.clone(), String::new())];
        while let Some((folder, prefix)) = open.pop() {
            for entry in std::fs::read_dir(&folder)? {
                let entry = entry?;
                let name = entry.file_name().into_string().map_err(|n| {
                    io::Error::new(io::ErrorKind::InvalidData, format!("the name {n:?} in {prefix} is no Unicode"))
                })?;
                let path = format!("{prefix}{name}");
                // Links are not followed: a store is its own files.
                if entry.file_type()?.is_dir() {
                    open.push((entry.path(), format!("{path}/")));
                } else if entry.file_type()?.is_file() {
                    found.push(path);
                }
            }
        }
        Ok(found)
    }
}

impl Store for Folder {
    fn read(&self, path: &str) -> io::Result<Option<Vec<u8>>> {
        match std::fs::read(self.root.join(path)) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(e) if matches!(e.kind(), io::ErrorKind::NotFound | io::ErrorKind::IsADirectory) => Ok(None),
            Err(e) => Err(e),
        }
    }

    fn exists(&self, path: &str) -> io::Result<bool> {
        Ok(self.root.join(path).is_file())
    }

    fn size(&self, path: &str) -> io::Result<Option<u64>> {
        match std::fs::metadata(self.root.join(path)) {
            Ok(there) => Ok(there.is_file().then_some(there.len())),
            Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(e) => Err(e),
        }
    }
}

/// The versions of a store, newest first, as their readers see them: one store.
struct Chain(Vec<Folder>);

impl Chain {
    fn versions(&self) -> cdb::Versions<'_> {
        cdb::Versions::new(self.0.iter().map(|f| f as &dyn Store).collect())
    }
}

impl Store for Chain {
    fn read(&self, path: &str) -> io::Result<Option<Vec<u8>>> {
        self.versions().read(path)
    }

    fn exists(&self, path: &str) -> io::Result<bool> {
        self.versions().exists(path)
    }

    fn size(&self, path: &str) -> io::Result<Option<u64>> {
        self.versions().size(path)
    }
}

impl ListableStore for Chain {
    fn list(&self) -> io::Result<Vec<String>> {
        let mut all = BTreeSet::new();
        for (i, folder) in self.0.iter().enumerate() {
            // The Metadata of a version are its own.
            all.extend(folder.list()?.into_iter().filter(|p| i == 0 || !p.starts_with("Metadata/")));
        }
        Ok(all.into_iter().collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use orb_formats::{Image, Mesh};

    fn store(root: &Path) {
        let mesh = Mesh {
            positions: vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 2.0]],
            normals: vec![[0.0, 0.0, 1.0]; 4],
            uvs: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
        };
        let texture = Image { width: 4, height: 4, channels: 3, pixels: vec![90; 48] };
        let model = cdb::Model {
            kind: cdb::Kind::Geospecific,
            material: cdb::Material::assumed("UA005"),
            name: "crate".into(),
            facc: "UA005".into(),
            fsc: 0,
            latitude: 34.5523,
            longitude: -118.4712,
            height: 740.0,
            heading: 30.0,
            levels: vec![cdb::Level { mesh, significant_size: 3.0, texture }],
            marking: "CLASSIFICATION: UNCLASSIFIED".into(),
            date: "Mon Jan  1 00:00:00 2024".into(),
            dbf_date: (2024, 1, 1),
            comment: "made by Orb".into(),
        };
        let added = cdb::add_model(&cdb::Empty, &model).unwrap();
        for folder in &added.folders {
            std::fs::create_dir_all(root.join(folder)).unwrap();
        }
        for file in &added.files {
            let path = root.join(&file.path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, &file.bytes).unwrap();
        }
    }

    fn check(root: &Path, json: bool) -> Result<Outcome> {
        run(&CdbArgs { verb: CdbVerb::Check(CheckArgs { root: root.into(), json }) })
    }

    #[test]
    fn a_store_passes_and_a_damaged_one_fails_by_rule() {
        let dir = tempfile::tempdir().unwrap();
        store(dir.path());
        let good = check(dir.path(), false).unwrap();
        assert_eq!(good.exit_code, 0, "{}", good.text);
        assert!(good.text.contains("pass  3 ") && !good.text.contains("FAIL"), "{}", good.text);
        std::fs::write(dir.path().join("Metadata/Version.xml"), "<Version/>").unwrap();
        let bad = check(dir.path(), true).unwrap();
        let value: serde_json::Value = serde_json::from_str(&bad.text).unwrap();
        let rules = value["rules"].as_array().unwrap();
        let verdict = |n: u64| rules.iter().find(|r| r["rule"] == n).unwrap()["verdict"].as_str().unwrap();
        assert_eq!((bad.exit_code, verdict(12), verdict(1)), (1, "fail", "pass"));
        assert!(check(&dir.path().join("Metadata"), false).is_err());
    }
}
