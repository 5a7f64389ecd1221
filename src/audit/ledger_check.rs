//! Checks a ledger from its first record to its last, offline, and says how much of it is anchored: covered by a
//! checkpoint that was kept elsewhere. Records are read in batches, so memory does not grow with the ledger, but for
//! the 16 bytes of each event's identity and the clocks of each start of the machine.

mod boots;
mod reconcile;

use std::collections::HashSet;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::checkpoint::{self, Checkpoint};
use super::disk;
use super::dsse::{Envelope, MAX_ENVELOPE_BYTES, PAYLOAD_TYPE};
use super::ledger::{self, read_line_limited};
use super::marking::Marking;
use super::merkle::Frontier;
use super::pem;
use super::record_check::{
    Policy, Signer, check_fields, check_policy, check_signatures, check_standing, read_statement,
};
use super::report::{Finding, Range, Report, Severity};
use super::statement::Statement;
use super::time;
use super::trust::{CertChain, Signed, TrustStore};
use crate::{Error, Result};
use boots::Boots;
pub use reconcile::reconcile;

/// Records that are read and checked at a time.
const BATCH: usize = 256;
/// Findings beyond this number are not kept.
const MAX_FINDINGS: usize = 1000;
/// How far a record may be dated before the one before it: a run is dated when it begins and takes its place when it
/// ends, and two may run at once.
pub const TIME_GRACE_MS: u64 = 10 * 60 * 1000;
/// Events that may stand after the last checkpoint: they vouch for nothing but that somebody looked.
const LOOKS: [&str; 2] = ["verify.run", "ledger.checkpoint"];
/// The event that ends a ledger.
pub const CLOSE_EVENT: &str = "ledger.close";

/// Which ledger to verify, and against what.
#[derive(Debug)]
pub struct LedgerRequest<'a> {
    pub ledger: &'a Path,
    pub trust: &'a TrustStore,
    /// Checkpoints that were kept elsewhere.
    pub checkpoints: &'a [PathBuf],
    /// Without a checkpoint that covers the last record there is no verdict. What only tells of checks that followed may stand
    /// after it: verifying a ledger adds to it.
    pub require_anchor: bool,
    /// This machine's time, milliseconds since 1970.
    pub now_ms: u64,
    /// Warnings count as errors.
    pub strict: bool,
    pub policy: Policy<'a>,
}

/// Verifies a ledger.
///
/// # Errors
/// [`crate::Kind::Incomplete`] when there is none, [`crate::Kind::Environment`] when it cannot be read. Everything
/// else is a finding.
pub fn verify_ledger(request: &LedgerRequest<'_>) -> Result<Report> {
    let trust = &with_chains(request)?;
    let mut walk = Walk::new(request, trust)?;
    if !request.ledger.exists() && !walk.anchors.is_empty() {
        // Nothing is left, but a checkpoint knows of records.
        return Ok(walk.finish());
    }
    let mut reader = open(request.ledger)?;
    let mut lines: Vec<Vec<u8>> = Vec::new();
    loop {
        let mut line = Vec::new();
        let more = read_line_limited(&mut reader, &mut line).map_err(|e| Error::io(request.ledger, &e))?;
        let whole = line.ends_with(b"\n");
        if more && whole {
            lines.push(line);
        }
        if lines.len() == BATCH || !more || !whole {
            let checked: Vec<Checked> = lines.par_iter().map(|line| check_line(line, request, trust)).collect();
            for record in checked {
                walk.step(record);
            }
            lines.clear();
        }
        if more && !whole {
            walk.find(Finding::new("INCOMPLETE_APPEND", "the last line"));
        }
        if !more || !whole {
            return Ok(walk.finish());
        }
    }
}

fn open(ledger: &Path) -> Result<BufReader<File>> {
    if !ledger.is_file() {
        return Err(Error::incomplete(ledger.display().to_string())
            .expected("a ledger")
            .found("RECORD_MISSING: nothing")
            .advice("The ledger of this user stands in the data folder, ledger/orb-ledger.jsonl."));
    }
    Ok(BufReader::with_capacity(1 << 20, File::open(ledger).map_err(|e| Error::io(ledger, &e))?))
}

/// The trust store, and the keys of the certificates beside the ledger for which one of its authorities answers. One that
/// leads nowhere shows where its key signed: as not trusted.
fn with_chains(request: &LedgerRequest<'_>) -> Result<TrustStore> {
    let mut trust = request.trust.clone();
    let folder = ledger::chains_beside(request.ledger);
    if folder.is_dir() {
        for entry in disk::walk(&folder)?.iter().filter(|e| e.is_file) {
            let text = disk::read_limited(&entry.path, pem::MAX_BYTES)?;
            if let Ok(chain) = CertChain::from_pem(&String::from_utf8_lossy(&text)) {
                let _ = trust.present(chain);
            }
        }
    }
    Ok(trust)
}

/// What can be said about a line alone.
struct Checked {
    statement: Option<Statement>,
    /// By trusted keys, all of them.
    is_signed: bool,
    found: Vec<Finding>,
}

fn check_line(line: &[u8], request: &LedgerRequest<'_>, trust: &TrustStore) -> Checked {
    let mut found = Vec::new();
    let subject = "record";
    let envelope = match Envelope::parse(line) {
        Ok(envelope) => envelope,
        Err(fault) => {
            found.push(Finding::new(fault.code(), subject).expected("a DSSE envelope").actual(fault.detail()));
            return Checked { statement: None, is_signed: false, found };
        }
    };
    if envelope.to_line() != line {
        found.push(Finding::new("NOT_CANONICAL", subject).expected("the one spelling of this envelope"));
    }
    if envelope.payload_type != PAYLOAD_TYPE {
        found.push(Finding::new("TYPE_UNSUPPORTED", subject).expected(PAYLOAD_TYPE).actual(&envelope.payload_type));
    }
    let signers = check_signatures(&envelope, trust, subject, &mut found);
    let statement = read_statement(&envelope, subject, &mut found);
    if let Some(statement) = &statement {
        check_policy(statement, request.policy, &mut found);
        check_fields(statement, trust, &signers, None, request.now_ms, &mut found);
    }
    // True of most ledgers and said once, in the records themselves.
    found.retain(|f| f.code != "TIME_UNSYNCED" || f.severity != Severity::Note);
    Checked { statement, is_signed: !signers.is_empty(), found }
}

/// The walk along the chain.
struct Walk<'a> {
    request: &'a LedgerRequest<'a>,
    trust: &'a TrustStore,
    report: Report,
    tree: Frontier,
    before: Option<Statement>,
    /// The last record that is none of [`LOOKS`].
    last_to_anchor: Option<u64>,
    before_ms: u64,
    boots: Boots,
    events: HashSet<u128>,
    anchors: Vec<Anchor>,
    marking: Option<Marking>,
    /// Every record so far is signed by a trusted key.
    all_signed: bool,
    line: u64,
}

/// A checkpoint to compare with.
struct Anchor {
    name: String,
    checkpoint: Checkpoint,
    /// Kept elsewhere: the ledger's own head stands where the ledger stands.
    kept_elsewhere: bool,
}

impl<'a> Walk<'a> {
    fn new(request: &'a LedgerRequest<'a>, trust: &'a TrustStore) -> Result<Walk<'a>> {
        let mut walk = Walk {
            request,
            trust,
            report: Report::new(request.trust),
            tree: Frontier::default(),
            before: None,
            last_to_anchor: None,
            before_ms: 0,
            boots: Boots::default(),
            events: HashSet::new(),
            anchors: Vec::new(),
            marking: None,
            all_signed: true,
            line: 0,
        };
        match ledger::checkpoint_beside(request.ledger) {
            Ok(Some(envelope)) => walk.take_anchor("head.json".into(), &envelope, false),
            Ok(None) => {}
            Err(error) => walk.find(Finding::new("HEAD_FORK", "head.json").actual(error.found)),
        }
        for path in request.checkpoints {
            let name = path.display().to_string();
            let bytes = disk::read_limited(path, MAX_ENVELOPE_BYTES as u64)?;
            match Envelope::parse(&bytes) {
                Ok(envelope) => walk.take_anchor(name, &envelope, true),
                Err(fault) => {
                    walk.find(Finding::new(fault.code(), name).expected("a checkpoint").actual(fault.detail()))
                }
            }
        }
        Ok(walk)
    }

    fn take_anchor(&mut self, name: String, envelope: &Envelope, kept_elsewhere: bool) {
        let mut found = Vec::new();
        let signers = check_signatures(envelope, self.trust, &name, &mut found);
        match Checkpoint::parse(envelope) {
            Ok(checkpoint) if !signers.is_empty() => {
                let signed =
                    Signed { stated_ms: time::parse_utc(&checkpoint.utc).unwrap_or_default(), proven_ms: None };
                let stand = |s: &Signer<'_>, found: &mut _| check_standing(self.trust, *s, signed, None, &name, found);
                if signers.iter().all(|s| stand(s, &mut found)) {
                    self.anchors.push(Anchor { name, checkpoint, kept_elsewhere });
                }
            }
            Ok(_) => {}
            Err(fault) => found.push(Finding::new(fault.code(), name).expected("a checkpoint").actual(fault.detail())),
        }
        for finding in found {
            self.find(finding);
        }
    }

    fn find(&mut self, mut finding: Finding) {
        finding.seq = finding.seq.or(self.line.checked_sub(1));
        match self.report.findings.len() {
            n if n < MAX_FINDINGS => self.report.findings.push(finding),
            MAX_FINDINGS => self.report.findings.push(Finding::new("TOO_MANY_FINDINGS", "ledger")),
            _ => {}
        }
    }

    fn step(&mut self, record: Checked) {
        self.line += 1;
        self.report.counts.records += 1;
        for finding in record.found {
            self.find(finding);
        }
        self.all_signed &= record.is_signed;
        let Some(statement) = record.statement else { return };
        let p = &statement.predicate;
        if let Some(code) = ledger::follows(self.before.as_ref(), &statement) {
            let expected = self.before.as_ref().map_or(0, |b| b.predicate.chain.seq + 1);
            self.find(
                Finding::new(code, "chain")
                    .expected(format!("record {expected}"))
                    .actual(format!("record {} after {}", p.chain.seq, p.chain.prev)),
            );
            if code == "SEQ_GAP"
                && self.before.as_ref().is_some_and(|b| b.predicate.trail_hash.as_ref() != Some(&p.chain.prev))
            {
                self.find(Finding::new("CHAIN_BROKEN", "chain.prev").actual(&p.chain.prev));
            }
        }
        if !self.events.insert(event_identity(&p.event.id)) {
            self.find(Finding::new("REPLAY", "event.id").actual(&p.event.id));
        }
        let at = time::parse_utc(&p.time.utc).unwrap_or_default();
        let grace_ms = self.request.policy.time_grace_ms.unwrap_or(TIME_GRACE_MS);
        let is_before = at.saturating_add(grace_ms) < self.before_ms;
        if is_before {
            self.find(
                Finding::new("TIME_ROLLBACK", "time.utc")
                    .expected(format!("not before {}", time::format_utc(self.before_ms)))
                    .actual(&p.time.utc),
            );
        }
        self.before_ms = self.before_ms.max(at);
        for finding in self.boots.step(&p.time, grace_ms) {
            // Seen by the dates alone, and told above.
            if !(is_before && finding.code == "TIME_ROLLBACK" && finding.subject == "time.utc") {
                self.find(finding);
            }
        }
        if let Some(leaf) = p.trail_hash.as_deref().and_then(checkpoint::record_leaf) {
            self.tree.push(leaf);
        }
        self.compare_with_anchors(&p.chain.ledger_id, p.chain.seq);
        if let Some(m) = statement.marking() {
            self.marking = Some(self.marking.take().map_or_else(|| m.clone(), |j| j.join(&m)));
        }
        if !LOOKS.contains(&p.event.kind.as_str()) {
            self.last_to_anchor = Some(p.chain.seq);
        }
        self.before = Some(statement);
    }

    fn compare_with_anchors(&mut self, ledger_id: &str, seq: u64) {
        let (size, root) = (self.tree.size(), || hex::encode(self.tree.root()));
        let mut found = Vec::new();
        for anchor in self.anchors.iter().filter(|a| a.checkpoint.size == size) {
            if anchor.checkpoint.ledger_id != ledger_id {
                found.push(
                    Finding::new("LEDGER_ID", &anchor.name).expected(ledger_id).actual(&anchor.checkpoint.ledger_id),
                );
            } else if anchor.checkpoint.root != root() {
                found.push(Finding::new("HEAD_FORK", &anchor.name).expected(&anchor.checkpoint.root).actual(root()));
            } else if anchor.kept_elsewhere {
                self.report.anchored_through = Some(seq);
            }
        }
        for finding in found {
            self.find(finding);
        }
    }

    fn finish(mut self) -> Report {
        let cut: Vec<Finding> = self
            .anchors
            .iter()
            .filter(|a| a.checkpoint.size > self.tree.size())
            .map(|a| {
                Finding::new("TRUNCATED", &a.name)
                    .expected(format!("{} records", a.checkpoint.size))
                    .actual(format!("{} records", self.tree.size()))
            })
            .collect();
        let was_cut = !cut.is_empty();
        for finding in cut {
            self.find(finding);
        }
        if self.report.counts.records == 0 {
            // Also of a ledger whose first record could not be written: it shows as little as none.
            if !was_cut {
                let mut finding =
                    Finding::new("RECORD_MISSING", "ledger").expected("at least one record").actual("none");
                finding.hint = "Nothing is known from a ledger without records. Look for a copy that has them.".into();
                self.find(finding);
            }
            if self.request.require_anchor {
                self.find(Finding::new("ANCHOR_REQUIRED", "ledger"));
            }
        }
        let last = self.before.as_ref().map(|b| b.predicate.chain.seq);
        if let Some(before) = &self.before {
            self.report.ledger_id = Some(before.predicate.chain.ledger_id.clone());
            self.report.range = Some(Range { first: 0, last: before.predicate.chain.seq });
            self.report.trail_hash.clone_from(&before.predicate.trail_hash);
            self.report.time = Some(before.predicate.time.utc.clone());
            if before.predicate.event.kind != CLOSE_EVENT {
                self.find(Finding::new("LEDGER_OPEN", "ledger"));
            }
        }
        if !self.all_signed {
            // Unverified words are no facts.
            self.report.trail_hash = None;
            self.report.time = None;
        }
        self.report.marking = self.marking.take().filter(|_| self.all_signed).map(|m| m.banner());
        if self.report.anchored_through != last {
            self.find(Finding::new("TAIL_UNANCHORED", "ledger"));
            if self.request.require_anchor && self.report.anchored_through < self.last_to_anchor {
                self.find(Finding::new("ANCHOR_REQUIRED", "ledger"));
            }
        }
        self.report.conclude(self.request.strict);
        self.report
    }
}

/// The 128 bits of a UUID; other text by its first bits.
fn event_identity(id: &str) -> u128 {
    let digits: String = id.chars().filter(char::is_ascii_hexdigit).collect();
    u128::from_str_radix(&digits, 16).unwrap_or_else(|_| {
        let hash = super::merkle::leaf(id.as_bytes());
        u128::from_be_bytes(hash[..16].try_into().unwrap_or_default())
    })
}

/// Reads where a ledger stands that is named as a file or as its folder.
pub fn ledger_file(path: &Path) -> PathBuf {
    if fs::metadata(path).is_ok_and(|m| m.is_dir()) { path.join("orb-ledger.jsonl") } else { path.to_owned() }
}

#[cfg(test)]
pub(super) mod tests;
