//! Published folders against the ledger that their records say they stand in.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::{open, read_line_limited};
use crate::audit::disk;
use crate::audit::dsse::Envelope;
use crate::audit::publication::RECORD;
use crate::audit::report::{Finding, Report, Verdict};
use crate::audit::statement::{Outcome, Statement};
use crate::audit::trust::TrustStore;
use crate::audit::verify::read_record;
use crate::{Error, Result};

/// What the folder's own words cannot tell.
const LOST: &str = "The record of this folder is not in the ledger: the ledger, or the end of it, was removed, or another \
                    ledger holds it. Look for a copy that is longer.";

/// The folders below `roots` that Orb published, against the ledger: every record must stand in it (`RECORD_MISSING`), also
/// when nothing of the ledger is left.
///
/// # Errors
/// [`crate::Kind::Incomplete`] when there is neither a ledger nor a published folder, [`crate::Kind::Environment`] when
/// something cannot be read. Everything else is a finding.
pub fn reconcile(ledger: &Path, roots: &[PathBuf], trust: &TrustStore) -> Result<Report> {
    let mut report = Report::new(trust);
    let is_there = ledger.is_file();
    let Records { all, mut published } = if is_there { read(ledger, &mut report)? } else { Records::default() };
    for root in roots {
        for entry in disk::walk(root)?.iter().filter(|e| e.is_file) {
            let folder = match entry.path.file_name() {
                Some(name) if name == RECORD => entry.path.parent().unwrap_or(root),
                _ => continue,
            };
            let subject = folder.display().to_string();
            report.counts.outputs_listed += 1;
            let (hash, place) = match read_record(folder).map(|(_, s)| (s.trail_hash(), s.predicate.chain)) {
                Ok((Ok(hash), place)) => (hash, place),
                Ok((Err(fault), _)) => {
                    report.findings.push(Finding::new(fault.code(), subject).actual(fault.detail()));
                    continue;
                }
                Err(error) => {
                    report.findings.push(Finding::new("SCHEMA_INVALID", subject).actual(error.found));
                    continue;
                }
            };
            if all.contains(&hash) {
                report.counts.outputs_verified += 1;
                published.remove(&hash);
                continue;
            }
            let left = if is_there { format!("{} records without it", all.len()) } else { "no ledger".into() };
            let mut finding = Finding::new("RECORD_MISSING", subject)
                .expected(format!("record {} of ledger {}, {hash}", place.seq, place.ledger_id))
                .actual(left);
            // The folder shows that there was a record: more than a verdict that has to wait.
            (finding.verdict, finding.hint) = (Verdict::Fail, LOST.into());
            report.findings.push(finding);
        }
    }
    if !is_there && report.counts.outputs_listed == 0 {
        open(ledger)?;
    }
    for hash in published {
        report.findings.push(Finding::new("FOLDER_NOT_FOUND", hash));
    }
    report.conclude(false);
    Ok(report)
}

/// Trail hashes of a ledger.
#[derive(Default)]
struct Records {
    all: BTreeSet<String>,
    /// Of those that have outputs.
    published: BTreeSet<String>,
}

fn read(ledger: &Path, report: &mut Report) -> Result<Records> {
    let mut records = Records::default();
    let mut reader = open(ledger)?;
    let mut line = Vec::new();
    while read_line_limited(&mut reader, &mut line).map_err(|e| Error::io(ledger, &e))? {
        let Ok(envelope) = Envelope::parse(&line) else { continue };
        let Ok((statement, _)) = Statement::parse(&envelope.payload) else { continue };
        let Ok(hash) = statement.trail_hash() else { continue };
        report.ledger_id = Some(statement.predicate.chain.ledger_id.clone());
        report.counts.records += 1;
        if !statement.subject.is_empty() && statement.predicate.event.outcome == Outcome::Success {
            records.published.insert(hash.clone());
        }
        records.all.insert(hash);
    }
    Ok(records)
}
