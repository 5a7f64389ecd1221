//! Checks a published folder against its record, offline, and collects everything that it finds.
//!
//! The record's bytes are believed only after a trusted key has verified them. When none has, they still serve to
//! locate what was changed, but none of their words are reported as facts.

mod files;

use std::fs;
use std::path::{Path, PathBuf};

use super::canonical::Fault;
use super::checkpoint::{Checkpoint, Proof};
use super::disk;
use super::dsse::{Envelope, MAX_ENVELOPE_BYTES, PAYLOAD_TYPE};
use super::keys::PublicKey;
use super::pem;
use super::publication::{
    RECORD, RECORD_CHAIN, RECORD_KEY, RECORD_KEY_2, RECORD_PAE, RECORD_PROOF, RECORD_SIG, RECORD_SIG_2, RECORD_STAMP,
};
use super::record_check::{Policy, check_fields, check_policy, check_signatures, own_signer, read_statement};
use super::report::{Finding, Range, Report, Severity, Verdict};
use super::statement::Statement;
use super::time;
use super::timestamp::{self, Refused};
use super::trust::{CertChain, TrustStore};
use crate::{Error, Result};

/// What to verify, and against what.
#[derive(Debug)]
pub struct Request<'a> {
    pub folder: &'a Path,
    pub trust: &'a TrustStore,
    /// Files that the run is said to have read.
    pub inputs: &'a [PathBuf],
    /// Network weights that the run is said to have used: files, or folders of one network each.
    pub weights: &'a [PathBuf],
    /// The program that the run is said to have been: `orb` itself, as a file.
    pub program: Option<&'a Path>,
    /// The root of the store that the run merged into.
    pub store: Option<&'a Path>,
    /// This machine's time, milliseconds since 1970.
    pub now_ms: u64,
    /// Warnings count as errors.
    pub strict: bool,
    pub policy: Policy<'a>,
}

impl<'a> Request<'a> {
    /// The folder alone, without a policy.
    pub fn new(folder: &'a Path, trust: &'a TrustStore, now_ms: u64) -> Request<'a> {
        let (inputs, weights, program, store, policy) = (&[], &[], None, None, Policy::default());
        Request { folder, trust, inputs, weights, program, store, now_ms, strict: false, policy }
    }
}

/// Verifies a published folder.
///
/// # Errors
/// [`crate::Kind::Usage`] when `folder` is no folder, [`crate::Kind::Environment`] when something in it cannot be
/// read. Everything else is a finding.
pub fn verify(request: &Request<'_>) -> Result<Report> {
    let metadata = fs::metadata(request.folder).map_err(|e| Error::io(request.folder, &e))?;
    if !metadata.is_dir() {
        return Err(Error::usage(request.folder.display().to_string()).expected("a published folder").found("a file"));
    }
    let mut found = Vec::new();
    let mut report = Report::new(request.trust);
    if let Some(envelope) = read_envelope(request.folder, &mut found)? {
        let trust = &with_chain(request, &mut found)?;
        let signers = check_signatures(&envelope, trust, RECORD, &mut found);
        let stamp = check_stamp(request, &mut found)?;
        let statement = read_statement(&envelope, RECORD, &mut found);
        let is_pair = statement.as_ref().is_some_and(|s| s.predicate.actor.co_signers.is_some());
        check_seal_files(request.folder, &envelope, is_pair, &mut found)?;
        if let Some(statement) = statement {
            check_chain_file(request.folder, &statement, &mut found)?;
            check_fields(&statement, trust, &signers, stamp, request.now_ms, &mut found);
            if request.policy.require_time_sync {
                // Said once, as what it is under this policy.
                found.retain(|f| f.code != "TIME_UNSYNCED");
            }
            check_policy(&statement, request.policy, &mut found);
            check_proof(request, trust, &statement, &mut found)?;
            report.counts = files::check_files(request, &statement, &mut found)?;
            report.counts.records = 1;
            if let Some(signer) = own_signer(&signers, &statement) {
                found.push(Finding::new("TAIL_UNANCHORED", RECORD));
                let p = &statement.predicate;
                report.ledger_id = Some(p.chain.ledger_id.clone());
                report.range = Some(Range { first: p.chain.seq, last: p.chain.seq });
                let own = signer.key.fingerprint();
                let others = signers.iter().map(|s| s.key.fingerprint()).filter(|f| *f != own);
                report.also_signed_by = others.map(str::to_owned).collect();
                report.signed_by = Some(own.to_owned());
                report.trail_hash.clone_from(&p.trail_hash);
                report.time = Some(p.time.utc.clone());
                report.marking = Some(p.marking.banner.clone());
            }
        }
    }
    report.findings = found;
    report.conclude(request.strict);
    Ok(report)
}

/// Reads a folder's record for showing, without a judgement.
///
/// # Errors
/// [`crate::Kind::Incomplete`] without a record, [`crate::Kind::Integrity`] when it is not one.
pub fn read_record(folder: &Path) -> Result<(Envelope, Statement)> {
    let path = folder.join(RECORD);
    if !path.is_file() {
        return Err(Error::incomplete(path.display().to_string())
            .expected("the record of a published folder")
            .found("RECORD_MISSING: nothing")
            .advice("Name the folder that Orb published, not one above or below it."));
    }
    let bytes = disk::read_limited(&path, MAX_ENVELOPE_BYTES as u64)?;
    let not_a_record = |f: Fault| {
        Error::integrity(path.display().to_string()).expected("a record").found(format!("{}: {}", f.code(), f.detail()))
    };
    let envelope = Envelope::parse(&bytes).map_err(not_a_record)?;
    let (statement, _) = Statement::parse(&envelope.payload).map_err(not_a_record)?;
    Ok((envelope, statement))
}

/// Refuses a record that is not the one that was verified: it was read apart, and its file may have been exchanged between.
///
/// # Errors
/// [`crate::Kind::Integrity`].
pub fn check_same(folder: &Path, report: &Report, envelope: &Envelope) -> Result<()> {
    // Of a record that no trusted key signed, nothing was said.
    let Some(verified) = &report.trail_hash else { return Ok(()) };
    let same = Statement::parse_and_hash(&envelope.payload).is_ok_and(|(statement, _, computed)| {
        let is_right = computed == *verified || report.findings.iter().any(|f| f.code == "TRAIL_HASH_MISMATCH");
        statement.predicate.trail_hash.as_ref() == Some(verified) && is_right
    });
    if same { Ok(()) } else { Err(changed(&folder.join(RECORD), verified)) }
}

/// What was read is not what was verified a moment before.
pub fn changed(path: &Path, trail_hash: &str) -> Error {
    Error::integrity(path.display().to_string())
        .expected(format!("the record with the trail hash {trail_hash}, which was verified"))
        .found("another one: it was changed while it was read")
        .advice("Run the command again when nothing else writes there.")
}

fn read_envelope(folder: &Path, found: &mut Vec<Finding>) -> Result<Option<Envelope>> {
    let path = folder.join(RECORD);
    match fs::symlink_metadata(&path) {
        Err(_) => {
            found.push(Finding::new("RECORD_MISSING", RECORD));
            return Ok(None);
        }
        Ok(metadata) if !metadata.is_file() => {
            found.push(Finding::new("PATH_REFUSED", RECORD).expected("a plain file"));
            return Ok(None);
        }
        Ok(metadata) if metadata.len() > MAX_ENVELOPE_BYTES as u64 => {
            found.push(
                Finding::new("LIMIT_EXCEEDED", RECORD)
                    .expected(format!("at most {MAX_ENVELOPE_BYTES} bytes"))
                    .actual(format!("{} bytes", metadata.len())),
            );
            return Ok(None);
        }
        Ok(_) => {}
    }
    let bytes = disk::read_limited(&path, MAX_ENVELOPE_BYTES as u64)?;
    let envelope = match Envelope::parse(&bytes) {
        Ok(envelope) => envelope,
        Err(fault) => {
            found.push(Finding::new(fault.code(), RECORD).expected("a DSSE envelope").actual(fault.detail()));
            return Ok(None);
        }
    };
    if envelope.to_line() != bytes {
        found.push(Finding::new("NOT_CANONICAL", RECORD).expected("the one spelling of this envelope"));
    }
    if envelope.payload_type != PAYLOAD_TYPE {
        found.push(Finding::new("TYPE_UNSUPPORTED", RECORD).expected(PAYLOAD_TYPE).actual(&envelope.payload_type));
    }
    Ok(Some(envelope))
}

/// The trust store, and the key of the certificates in the folder if one of its authorities answers for it.
fn with_chain(request: &Request<'_>, found: &mut Vec<Finding>) -> Result<TrustStore> {
    let mut trust = request.trust.clone();
    let path = request.folder.join(RECORD_CHAIN);
    // The walk over the folder reports a link.
    if !fs::symlink_metadata(&path).is_ok_and(|m| m.is_file() && m.len() <= pem::MAX_BYTES) {
        return Ok(trust);
    }
    let bytes = disk::read_limited(&path, pem::MAX_BYTES)?;
    let presented = CertChain::from_pem(&String::from_utf8_lossy(&bytes)).and_then(|chain| trust.present(chain));
    // Who trusts no authority judges by the key alone.
    if let Err(why) = presented
        && trust.authorities().next().is_some()
    {
        found.push(Finding::new("CERT_UNTRUSTED", RECORD_CHAIN).expected("a path to a trusted authority").actual(why));
    }
    Ok(trust)
}

/// Not after when the record stood, by the word of a time stamp beside it.
fn check_stamp(request: &Request<'_>, found: &mut Vec<Finding>) -> Result<Option<u64>> {
    let (path, record) = (request.folder.join(RECORD_STAMP), request.folder.join(RECORD));
    match fs::symlink_metadata(&path) {
        Ok(metadata) if metadata.is_file() => {}
        // None, or a link that the walk over the folder reports.
        _ => return Ok(None),
    }
    let token = disk::read_limited(&path, timestamp::MAX_BYTES)?;
    let record = disk::read_limited(&record, MAX_ENVELOPE_BYTES as u64)?;
    match timestamp::check(&token, &record, request.trust) {
        Ok(stamp) => {
            let words = format!("not after {}, says {}", time::format_utc(stamp.not_after_ms), stamp.authority);
            found.push(Finding::new("TIME_STAMPED", RECORD_STAMP).actual(words));
            Ok(Some(stamp.not_after_ms))
        }
        Err(refused) => {
            let (code, why) = match refused {
                Refused::Untrusted(why) => ("TIME_STAMP_UNTRUSTED", why),
                Refused::Invalid(why) => ("TIME_STAMP_INVALID", why),
            };
            found.push(Finding::new(code, RECORD_STAMP).expected("a time stamp of this record").actual(why));
            Ok(None)
        }
    }
}

/// The files for verification by hand must say the same as the record.
fn check_seal_files(folder: &Path, envelope: &Envelope, is_pair: bool, found: &mut Vec<Finding>) -> Result<()> {
    let keyids: Vec<&str> = envelope.signatures.iter().map(|s| s.keyid.as_str()).collect();
    let same_key = |bytes: &[u8]| {
        let text = std::str::from_utf8(bytes).unwrap_or_default();
        PublicKey::from_pem(text).is_ok_and(|key| key.to_pem() == text && keyids.contains(&key.fingerprint()))
    };
    let same_sig = |at: usize, bytes: &[u8]| envelope.signatures.get(at).is_some_and(|s| s.sig == bytes);
    for name in [RECORD_PAE, RECORD_SIG, RECORD_KEY, RECORD_SIG_2, RECORD_KEY_2] {
        let path = folder.join(name);
        match fs::symlink_metadata(&path) {
            Err(_) if !is_pair && [RECORD_SIG_2, RECORD_KEY_2].contains(&name) => continue,
            Err(_) => {
                found.push(Finding::new("SEAL_FILE_MISSING", name));
                continue;
            }
            // The walk over the folder reports it.
            Ok(metadata) if !metadata.is_file() => continue,
            Ok(_) => {}
        }
        let limit = if [RECORD_KEY, RECORD_KEY_2].contains(&name) { pem::MAX_BYTES } else { MAX_ENVELOPE_BYTES as u64 };
        let size = fs::metadata(&path).map_err(|e| Error::io(&path, &e))?.len();
        let same = size <= limit && {
            let bytes = disk::read_limited(&path, limit)?;
            match name {
                RECORD_PAE => bytes == envelope.pae(),
                RECORD_SIG => same_sig(0, &bytes),
                RECORD_SIG_2 => same_sig(1, &bytes),
                _ => same_key(&bytes),
            }
        };
        if !same {
            found.push(Finding::new("SEAL_FILE_MISMATCH", name).expected(format!("the same as in {RECORD}")));
        }
    }
    Ok(())
}

/// The certificates beside the record must be those whose digests it states, also for who trusts the key itself: others read
/// in them whose it is.
fn check_chain_file(folder: &Path, statement: &Statement, found: &mut Vec<Finding>) -> Result<()> {
    let path = folder.join(RECORD_CHAIN);
    let stated = statement.predicate.actor.cert_chain_sha256.as_ref();
    let metadata = match (fs::symlink_metadata(&path), stated) {
        (Err(_), None) => return Ok(()),
        (Err(_), Some(stated)) => {
            let mut finding = Finding::new("SEAL_FILE_MISSING", RECORD_CHAIN).expected(stated.join(" "));
            (finding.severity, finding.verdict) = (Severity::Error, Verdict::Incomplete);
            finding.hint =
                "The record names these certificates as its signer's. Take them from its source again.".into();
            found.push(finding);
            return Ok(());
        }
        // The walk over the folder reports it.
        (Ok(metadata), _) if !metadata.is_file() => return Ok(()),
        (Ok(metadata), _) => metadata,
    };
    let text = match metadata.len() {
        0..=pem::MAX_BYTES => disk::read_limited(&path, pem::MAX_BYTES)?,
        _ => Vec::new(),
    };
    let text = String::from_utf8_lossy(&text);
    let same = CertChain::from_pem(&text).is_ok_and(|c| c.to_pem() == text && Some(&c.sha256()) == stated);
    if !same {
        let stated = stated.map_or_else(|| String::from("no certificates"), |s| s.join(" "));
        found.push(Finding::new("SEAL_FILE_MISMATCH", RECORD_CHAIN).expected(format!("{stated}, as in {RECORD}")));
    }
    Ok(())
}

/// The proof that the record stands in its ledger, where there is one.
fn check_proof(
    request: &Request<'_>,
    trust: &TrustStore,
    statement: &Statement,
    found: &mut Vec<Finding>,
) -> Result<()> {
    let path = request.folder.join(RECORD_PROOF);
    match fs::symlink_metadata(&path) {
        Err(_) => found.push(Finding::new("PROOF_MISSING", RECORD_PROOF)),
        Ok(metadata) if metadata.is_file() && metadata.len() <= MAX_ENVELOPE_BYTES as u64 => {
            let bytes = disk::read_limited(&path, MAX_ENVELOPE_BYTES as u64)?;
            if let Err(why) = prove(&bytes, trust, statement, found) {
                found.push(
                    Finding::new("PROOF_INVALID", RECORD_PROOF)
                        .expected("the record's place in its ledger")
                        .actual(why),
                );
            }
        }
        // The walk over the folder reports a link.
        Ok(_) => found.push(Finding::new("PROOF_INVALID", RECORD_PROOF).expected("a small plain file")),
    }
    Ok(())
}

fn prove(bytes: &[u8], trust: &TrustStore, statement: &Statement, found: &mut Vec<Finding>) -> Result<(), String> {
    let words = |fault: Fault| fault.detail().to_owned();
    let proof = Proof::parse(bytes).map_err(words)?;
    let envelope = proof.envelope().map_err(words)?;
    let checkpoint = Checkpoint::parse(&envelope).map_err(words)?;
    // Where no key is trusted, the record's own signature says so.
    if !trust.is_empty() {
        check_signatures(&envelope, trust, RECORD_PROOF, found);
    }
    let p = &statement.predicate;
    if checkpoint.ledger_id != p.chain.ledger_id || proof.index != p.chain.seq {
        return Err(format!("record {} of ledger {}", proof.index, checkpoint.ledger_id));
    }
    let root = proof.root(p.trail_hash.as_deref().unwrap_or_default(), checkpoint.size);
    if root.map(hex::encode).as_deref() != Some(checkpoint.root.as_str()) {
        return Err("another record's path, or another tree's root".into());
    }
    Ok(())
}

#[cfg(test)]
pub(crate) mod tests;
