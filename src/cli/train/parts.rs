//! The folders of `--parts` as evidence: the record of each part that was trained alone, and what the run that puts them together
//! says of them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::{Train, told};
use crate::audit::marking::handling::Handling;
use crate::audit::publication::RECORD;
use crate::audit::report::Verdict;
use crate::audit::statement::{Input, Param};
use crate::audit::verify::Request;
use crate::audit::{DataFolder, Marking, TrustStore, record, time, verify};
use crate::cli::photos::Set;
use crate::cli::sealed::{Evidence, SealedRun};
use crate::pipeline::scene::blocks::{self, PART_FILE};
use crate::pipeline::scene::{self, Blocks};
use crate::{Error, Result};

/// What of a part's folder the run itself writes before it is sealed.
const OWN: [&str; 2] = [PART_FILE, blocks::CHECKPOINT_FILE];
const COMMAND: &str = "orb train";

/// A part that stood there before the run.
pub struct Standing {
    /// Of its folder.
    pub name: String,
    /// The part and, where it was trained alone, its record.
    pub inputs: Vec<Input>,
    /// What its record says that it is marked.
    pub marking: Option<Marking>,
    /// Why nobody can say who sealed it, where it has a record: as `orb audit verify` finds it.
    pub doubt: Option<String>,
}

/// The parts of a run in `count` blocks that stand in a folder.
///
/// # Errors
/// Environment for what cannot be read; integrity for a part that is not the one of the record beside it, and for a folder that
/// `orb audit verify` finds changed.
pub fn standing(folder: &Path, count: usize) -> Result<Vec<Standing>> {
    let names = std::iter::once(blocks::COARSE.to_owned()).chain((0..count).map(blocks::name));
    let mut out = Vec::new();
    for name in names.filter(|name| folder.join(name).join(PART_FILE).is_file()) {
        let at = folder.join(&name);
        let file = at.join(PART_FILE);
        let bytes = std::fs::read(&file).map_err(|e| Error::io(&file, &e))?;
        let input = |file: &str, bytes: &[u8], kind: &str, role: &str, marking: &Option<Marking>| {
            record::input(&format!("{name}/{file}"), bytes, kind, role, marking.clone())
        };
        if !at.join(RECORD).is_file() {
            let inputs = vec![input(PART_FILE, &bytes, "application/octet-stream", "part", &None)];
            out.push(Standing { name, inputs, marking: None, doubt: None });
            continue;
        }
        let (_, statement) = verify::read_record(&at)?;
        let marking = Some(Marking::read(&statement.predicate.marking.banner)?);
        let part = input(PART_FILE, &bytes, "application/octet-stream", "part", &marking);
        let sealed = statement.subject.iter().find(|s| s.name == PART_FILE).map(|s| s.digest.sha256.as_str());
        if sealed != Some(part.sha256.as_str()) {
            return Err(Error::integrity(file.display().to_string())
                .expected(format!("SHA-256 {} as its record says", sealed.unwrap_or("of a part")))
                .found(part.sha256)
                .advice("See `orb audit verify` on its folder. Remove the folder: it is trained again."));
        }
        let record = at.join(RECORD);
        let bytes = std::fs::read(&record).map_err(|e| Error::io(&record, &e))?;
        let beside = input(RECORD, &bytes, "application/json", "record", &None);
        let doubt = doubt(&at)?;
        out.push(Standing { name, inputs: vec![part, beside], marking, doubt });
    }
    Ok(out)
}

/// Verifies a part's folder as `orb audit verify` does, with the keys that this user trusts. What keeps it from passing where nothing
/// was changed: a signer that nobody vouches for, a record that is not whole.
///
/// # Errors
/// Integrity for what is not as its record says; environment for what cannot be read.
fn doubt(at: &Path) -> Result<Option<String>> {
    let data = DataFolder::from_environment(|name| std::env::var_os(name))?;
    let trust = TrustStore::load(&data, &[])?;
    let report = verify::verify(&Request::new(at, &trust, time::now()?.unix_ms))?;
    let worst = || report.findings.iter().filter(|f| f.verdict == report.verdict);
    let codes: Vec<String> = worst().map(|f| format!("{} of {}", f.code, f.subject)).collect();
    let found = format!("{}. {}", codes.join(", "), worst().next().map_or("", |f| f.hint.as_str()));
    match report.verdict {
        Verdict::Pass => Ok(None),
        Verdict::Fail => Err(Error::integrity(at.display().to_string())
            .expected("a part's folder as it was sealed")
            .found(found.trim_end().to_owned())
            .advice("See `orb audit verify` on it. Remove the folder: it is trained again.")),
        Verdict::Incomplete | Verdict::Refused => {
            Ok(Some(format!("{} is not verified: {}", at.display(), found.trim_end())))
        }
    }
}

/// How many of the parts that stood there have a record that is verified, and how many one that nobody can verify here.
pub fn verified(standing: &[Standing]) -> Vec<(String, Param)> {
    let sealed = || standing.iter().filter(|p| p.inputs.len() > 1);
    let doubted = sealed().filter(|p| p.doubt.is_some()).count();
    vec![
        ("parts_verified".into(), Param::Int((sealed().count() - doubted) as i64)),
        ("parts_not_verified".into(), Param::Int(doubted as i64)),
    ]
}

/// Parts that this run will train and seal, each in its own folder: with `--block`.
pub struct Sealing {
    folder: PathBuf,
    parts: Vec<(String, SealedRun)>,
}

impl Sealing {
    /// Finds the key and begins to stage for the parts that do not stand yet. Call it before any work.
    ///
    /// # Errors
    /// As [`SealedRun::begin`]; environment where the folder cannot be made.
    pub fn begin(
        args: &Train,
        folder: &Path,
        block: usize,
        standing: &[Standing],
        handling: &Handling,
    ) -> Result<Sealing> {
        std::fs::create_dir_all(folder).map_err(|e| Error::io(folder, &e))?;
        let names = [blocks::COARSE.to_owned(), blocks::name(block)];
        let missing = names.into_iter().filter(|name| standing.iter().all(|s| s.name != *name));
        let begun = missing.map(|name| {
            let run = SealedRun::begin_over(COMMAND, &folder.join(&name), &OWN, handling.clone(), &args.publish)?;
            Ok((name, run))
        });
        Ok(Sealing { folder: folder.to_owned(), parts: begun.collect::<Result<_>>()? })
    }

    /// Seals them; says the folders.
    ///
    /// # Errors
    /// As [`SealedRun::seal`]; what cannot be read.
    pub fn seal(
        self,
        args: &Train,
        set: &Set,
        options: &scene::Options,
        cut: &Blocks,
        device: &str,
    ) -> Result<Vec<PathBuf>> {
        let mut sealed = Vec::new();
        for (name, mut run) in self.parts {
            let file = self.folder.join(&name).join(PART_FILE);
            let bytes = std::fs::read(&file).map_err(|e| Error::io(&file, &e))?;
            run.publication.add(PART_FILE, &bytes, "application/octet-stream", "part")?;
            let head = blocks::head(&bytes).ok_or_else(|| {
                Error::integrity(file.display().to_string()).expected("a part of a scene").found("another file")
            })?;
            // A block begins with the coarse scene, which has been sealed before it.
            let from: Vec<Input> = match name == blocks::COARSE {
                true => Vec::new(),
                false => standing(&self.folder, 0)?.into_iter().flat_map(|s| s.inputs).collect(),
            };
            let text = |v: String| Param::Text(v);
            let own = [
                ("part", text(head.what.clone())),
                ("photos_trained_on", Param::Int(head.photos as i64)),
                ("iterations_run", Param::Int(head.steps as i64)),
                ("gaussians", Param::Int(head.gaussians as i64)),
                ("gaussians_of_the_sky", Param::Int(head.sky as i64)),
                ("device", text(device.to_owned())),
            ];
            let params: BTreeMap<String, Param> = told::settings(args, options, set)
                .into_iter()
                .chain(of_run(cut))
                .chain(own.map(|(name, v)| (name.to_owned(), v)))
                .collect();
            let evidence = Evidence {
                event_type: "scene.block",
                time: time::now()?,
                inputs: set.inputs().iter().cloned().chain(from).collect(),
                models: told::models(device, set.colmap()),
                params,
            };
            sealed.push(run.seal(evidence)?.folder);
        }
        Ok(sealed)
    }
}

/// What parts of one run have in common.
pub fn of_run(cut: &Blocks) -> Vec<(String, Param)> {
    vec![("blocks".into(), Param::Int(cut.count as i64)), ("parts_run".into(), Param::Text(cut.run.clone()))]
}
