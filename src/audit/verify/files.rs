//! What a record lists against what lies on the disk: outputs, inputs, weights and the program.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use super::Request;
use crate::audit::disk;
use crate::audit::inband;
use crate::audit::marking::Marking;
use crate::audit::publication::{SEAL_FILES, STORE_PREFIX};
use crate::audit::record;
use crate::audit::report::{Counts, Finding, Severity, Verdict};
use crate::audit::statement::{Statement, Subject};
use crate::{Error, Result};

/// Files beyond this size are hashed, but not searched for a marking.
const MAX_INBAND_BYTES: u64 = 1 << 30;

/// What the record lists against what lies on the disk, and how much of it was there to be checked.
pub fn check_files(request: &Request<'_>, statement: &Statement, found: &mut Vec<Finding>) -> Result<Counts> {
    let marking = statement.marking();
    let marking = marking.as_ref();
    let mut counts = Counts {
        outputs_listed: statement.subject.len() as u64,
        inputs_listed: statement.predicate.inputs.len() as u64,
        ..Counts::default()
    };
    let mut store_unchecked = 0u64;
    for subject in &statement.subject {
        let (root, name) = match subject.name.strip_prefix(STORE_PREFIX) {
            None => (request.folder, subject.name.as_str()),
            Some(name) => match request.store {
                Some(store) => (store, name),
                None => {
                    store_unchecked += 1;
                    continue;
                }
            },
        };
        let before = found.len();
        check_output(root, name, subject, marking, found)?;
        counts.outputs_verified += u64::from(found.len() == before);
    }
    if store_unchecked > 0 {
        found.push(Finding::new("STORE_NOT_CHECKED", "store").actual(format!("{store_unchecked} files not checked")));
    }
    check_extras(request.folder, statement, found)?;
    counts.inputs_verified = check_inputs(request, statement, found)?;
    check_weights(request.weights, statement, found)?;
    check_program(request.program, statement, found)?;
    Ok(counts)
}

fn check_output(
    root: &Path,
    name: &str,
    subject: &Subject,
    marking: Option<&Marking>,
    found: &mut Vec<Finding>,
) -> Result<()> {
    if let Err(why) = disk::check_name(name) {
        found.push(Finding::new("PATH_REFUSED", record::printable(&subject.name)).actual(why));
        return Ok(());
    }
    // Every folder on the way, so that no link is followed.
    for (end, _) in name.match_indices('/') {
        if fs::symlink_metadata(root.join(&name[..end])).is_ok_and(|m| !m.is_dir()) {
            found.push(Finding::new("PATH_REFUSED", &subject.name).expected("folders and a plain file"));
            return Ok(());
        }
    }
    let path = root.join(name);
    let size = match fs::symlink_metadata(&path) {
        Err(_) => {
            found.push(Finding::new("OUTPUT_MISSING", &subject.name).expected(&subject.digest.sha256));
            return Ok(());
        }
        Ok(metadata) if !metadata.is_file() => {
            found.push(Finding::new("PATH_REFUSED", &subject.name).expected("a plain file"));
            return Ok(());
        }
        Ok(metadata) => metadata.len(),
    };
    if size.to_string() != subject.annotations.size {
        found.push(
            Finding::new("OUTPUT_DIGEST", &subject.name)
                .expected(format!("{} bytes", subject.annotations.size))
                .actual(format!("{size} bytes")),
        );
    } else {
        let (_, sha256) = disk::hash_file(&path).map_err(|e| Error::io(&path, &e))?;
        if sha256 != subject.digest.sha256 {
            found.push(Finding::new("OUTPUT_DIGEST", &subject.name).expected(&subject.digest.sha256).actual(sha256));
        } else if let Some(expected) = &subject.digest.sha384 {
            let sha384 = disk::sha384_file(&path)?;
            if sha384 != *expected {
                found.push(Finding::new("OUTPUT_DIGEST", &subject.name).expected(expected).actual(sha384));
            }
        }
    }
    if let Some(marking) = marking
        && inband::has_carrier(name)
        && size <= MAX_INBAND_BYTES
    {
        let bytes = disk::read_limited(&path, MAX_INBAND_BYTES)?;
        let shared = subject.name.starts_with(STORE_PREFIX);
        let compare = if shared { inband::mismatch_in_store } else { inband::mismatch };
        if let Some(actual) = compare(name, &bytes, marking) {
            found.push(Finding::new("MARKING_INBAND_MISMATCH", &subject.name).expected(marking.line()).actual(actual));
        }
    }
    Ok(())
}

/// Files that the record does not list.
fn check_extras(folder: &Path, statement: &Statement, found: &mut Vec<Finding>) -> Result<()> {
    let listed: BTreeSet<&str> = statement.subject.iter().map(|s| s.name.as_str()).chain(SEAL_FILES).collect();
    for entry in disk::walk(folder)? {
        if entry.is_dir {
            continue;
        }
        if !entry.is_file {
            found.push(Finding::new("PATH_REFUSED", record::printable(&entry.name)).expected("a plain file"));
        } else if !listed.contains(entry.name.as_str()) {
            found.push(Finding::new("OUTPUT_EXTRA", record::printable(&entry.name)));
        }
    }
    Ok(())
}

/// How many of the record's inputs are among the files given.
fn check_inputs(request: &Request<'_>, statement: &Statement, found: &mut Vec<Finding>) -> Result<u64> {
    let inputs = &statement.predicate.inputs;
    let mut by_hash: BTreeMap<&str, bool> = inputs.iter().map(|i| (i.sha256.as_str(), false)).collect();
    for path in request.inputs {
        let (_, sha256) = disk::hash_file(path).map_err(|e| Error::io(path, &e))?;
        match by_hash.get_mut(sha256.as_str()) {
            Some(seen) => *seen = true,
            None => {
                let expected: Vec<String> = inputs.iter().map(|i| format!("{} {}", i.sha256, i.name)).collect();
                found.push(
                    Finding::new("INPUT_DIGEST", path.display().to_string())
                        .expected(expected.join(", "))
                        .actual(sha256),
                );
            }
        }
    }
    let checked = |sha256: &str| by_hash.get(sha256).copied().unwrap_or(false);
    for input in inputs.iter().filter(|i| !checked(&i.sha256)) {
        let mut finding = Finding::new("INPUT_MISSING", &input.name).expected(&input.sha256).actual("not checked");
        if request.policy.require_inputs {
            (finding.severity, finding.verdict) = (Severity::Error, Verdict::Incomplete);
        }
        found.push(finding);
    }
    Ok(inputs.iter().filter(|i| checked(&i.sha256)).count() as u64)
}

/// Weights that the record does not name.
fn check_weights(paths: &[PathBuf], statement: &Statement, found: &mut Vec<Finding>) -> Result<()> {
    let pins: Vec<&str> = statement.predicate.models.iter().filter_map(|m| m.weights_sha256.as_deref()).collect();
    for path in paths {
        let sha256 = crate::models::registry::weights_sha256(path)?;
        if !pins.contains(&sha256.as_str()) {
            let finding = Finding::new("MODEL_DIGEST", path.display().to_string());
            found.push(finding.expected(pins.join(", ")).actual(sha256));
        }
    }
    Ok(())
}

/// Another program than the record names, or a record that names none.
fn check_program(path: Option<&Path>, statement: &Statement, found: &mut Vec<Finding>) -> Result<()> {
    let Some(path) = path else { return Ok(()) };
    let (_, sha256) = disk::hash_file(path).map_err(|e| Error::io(path, &e))?;
    let recorded = statement.predicate.tool.binary_sha256.as_deref();
    if recorded != Some(sha256.as_str()) {
        let finding = Finding::new("PROGRAM_DIGEST", path.display().to_string());
        found.push(finding.expected(recorded.unwrap_or("a record that names its program")).actual(sha256));
    }
    Ok(())
}
