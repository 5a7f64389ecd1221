//! What a verification found: findings, one verdict, the exit code, as text and as JSON.

use std::fmt::Write as _;

use serde::Serialize;

use super::trust::TrustStore;
use crate::Kind;

pub const SCHEMA: &str = "orb.verify/v1";

/// The worst finding decides; later is worse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    Pass,
    /// Something needed for a verdict is missing.
    Incomplete,
    /// A policy refuses to judge or to accept.
    Refused,
    /// Something is not what the record says.
    Fail,
}

impl Verdict {
    pub fn exit_code(self) -> u8 {
        match self {
            Verdict::Pass => 0,
            Verdict::Fail => Kind::Integrity.exit_code(),
            Verdict::Incomplete => Kind::Incomplete.exit_code(),
            Verdict::Refused => Kind::Policy.exit_code(),
        }
    }
}

/// Worst first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    Error,
    Warning,
    /// Worth knowing; says what was not checked.
    Note,
}

impl Severity {
    pub fn name(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
        }
    }
}

/// One thing that was found. Codes are never reused for another meaning.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Finding {
    pub code: &'static str,
    pub severity: Severity,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seq: Option<u64>,
    /// The file, or the field of the record.
    pub subject: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    pub expected: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    pub actual: String,
    /// Controls of NIST SP 800-53 that the finding is evidence about.
    pub controls: &'static [&'static str],
    #[serde(skip_serializing_if = "String::is_empty")]
    pub hint: String,
    #[serde(skip)]
    pub verdict: Verdict,
}

impl Finding {
    /// A finding whose severity and verdict follow from its code.
    pub fn new(code: &'static str, subject: impl Into<String>) -> Finding {
        let (severity, verdict) = weight(code);
        Finding {
            code,
            severity,
            seq: None,
            subject: subject.into(),
            expected: String::new(),
            actual: String::new(),
            controls: controls(code),
            hint: hint(code).to_owned(),
            verdict,
        }
    }
    pub fn expected(mut self, text: impl Into<String>) -> Finding {
        self.expected = text.into();
        self
    }
    pub fn actual(mut self, text: impl Into<String>) -> Finding {
        self.actual = text.into();
        self
    }
}

fn weight(code: &str) -> (Severity, Verdict) {
    match code {
        "INPUT_MISSING" | "STORE_NOT_CHECKED" | "TIME_UNSYNCED" | "TAIL_UNANCHORED" | "LEDGER_OPEN"
        | "FOLDER_NOT_FOUND" | "KEY_REVOKED_LATER" | "CERT_REVOKED_LATER" | "TIME_STAMPED" => {
            (Severity::Note, Verdict::Pass)
        }
        "OUTPUT_EXTRA"
        | "KEY_SHORT"
        | "TIME_STAMP_UNTRUSTED"
        | "SEAL_FILE_MISSING"
        | "PROOF_MISSING"
        | "INCOMPLETE_APPEND"
        | "TIME_STEPPED" => (Severity::Warning, Verdict::Pass),
        "RECORD_MISSING" | "TRUST_STORE_EMPTY" | "ANCHOR_REQUIRED" => (Severity::Error, Verdict::Incomplete),
        "ALG_REFUSED" | "MARKING_UNSUPPORTED" | "KEY_SCOPE" | "MODEL_NOT_ALLOWED" => {
            (Severity::Error, Verdict::Refused)
        }
        _ => (Severity::Error, Verdict::Fail),
    }
}

fn controls(code: &str) -> &'static [&'static str] {
    match code {
        "OUTPUT_DIGEST" | "OUTPUT_MISSING" | "OUTPUT_EXTRA" | "INPUT_DIGEST" | "INPUT_MISSING" | "MODEL_DIGEST"
        | "MODEL_NOT_ALLOWED" | "PROGRAM_DIGEST" | "STORE_NOT_CHECKED" => &["si-7", "si-7.1"],
        "SIG_INVALID" | "SIGNATURE_MISSING" | "KEY_UNTRUSTED" | "SIGNER_MISMATCH" | "TRUST_STORE_EMPTY"
        | "KEY_EXPIRED" | "KEY_REVOKED" | "KEY_REVOKED_LATER" | "KEY_SCOPE" | "CERT_EXPIRED" | "CERT_REVOKED"
        | "CERT_REVOKED_LATER" | "CERT_UNTRUSTED" => &["au-9.3", "au-10"],
        "ALG_REFUSED" | "KEY_SHORT" => &["sc-13"],
        "TIME_STAMPED"
        | "TIME_STAMP_UNTRUSTED"
        | "TIME_STAMP_INVALID"
        | "TIME_FUTURE"
        | "TIME_UNSYNCED"
        | "TIME_ROLLBACK"
        | "TIME_STEPPED" => &["au-8"],
        "MARKING_DOWNGRADE" | "MARKING_INBAND_MISMATCH" | "MARKING_UNSUPPORTED" => &["mp-3", "ac-16"],
        "SCHEMA_INVALID" | "TYPE_UNSUPPORTED" | "RECORD_MISSING" => &["au-3", "au-12"],
        _ => &["au-9.3"],
    }
}

fn hint(code: &str) -> &'static str {
    match code {
        "OUTPUT_DIGEST" => "The file is not the one that was sealed. Take it from its source again.",
        "OUTPUT_MISSING" => "The folder is not whole. Take it from its source again.",
        "OUTPUT_EXTRA" => "The file is not covered by the seal. Nothing here vouches for it.",
        "INPUT_DIGEST" => "The result was not made from this file.",
        "INPUT_MISSING" => "Give the file with --input to check it.",
        "STORE_NOT_CHECKED" => "Give the store's root with --store to check it.",
        "KEY_UNTRUSTED" => {
            "Get the signer's public key from the signer, not from this folder, and name it with --trust-key."
        }
        "TRUST_STORE_EMPTY" => {
            "No key is trusted here, so nobody's signature counts. Get the signer's public key from the signer, not from \
             this folder, and name it with --trust-key."
        }
        "SIG_INVALID" => "The record was changed after it was signed.",
        "SIGNATURE_MISSING" => {
            "One of two keys that only count together did not sign, or its signature was taken away."
        }
        "SIGNER_MISMATCH" => "The record names another key than the one that signed it.",
        "NOT_CANONICAL" => "The same words in another spelling: the file was rewritten after it was signed.",
        "TRAIL_HASH_MISMATCH" => "The record was changed after it was sealed.",
        "SEAL_FILE_MISMATCH" => "Verification by hand would use this file. Trust the record, not this file.",
        "SEAL_FILE_MISSING" => "Only verification by hand needs this file.",
        "RECORD_MISSING" => "Without its record nothing is known about a folder.",
        "PATH_REFUSED" => "Orb publishes plain files only; links and names that leave the folder are never followed.",
        "MARKING_INBAND_MISMATCH" => "Handle the file at the higher of both markings until its owner has looked at it.",
        "MARKING_DOWNGRADE" => "Handle the folder at the inputs' marking until its owner has looked at it.",
        "TIME_STAMPED" => "Somebody else says that the record stood then.",
        "TIME_STAMP_UNTRUSTED" => "Add the certificate of its authority: orb audit key trust add FILE.",
        "TIME_STAMP_INVALID" => "The time stamp is of another record or was changed: it shows nothing.",
        "TIME_FUTURE" => "One of the two clocks is wrong.",
        "TIME_UNSYNCED" => "The signer's clock was not known to agree with UTC.",
        "TAIL_UNANCHORED" => "A signature shows who and what, not that no later record was cut off.",
        "PROOF_MISSING" => "Only the ledger shows that the record stands in it.",
        "PROOF_INVALID" => "The file beside the record does not show that the record stands in its signer's ledger.",
        "SEQ_GAP" => "A record was removed, moved or added.",
        "CHAIN_BROKEN" => "The record before this one is not the one that this record was made after.",
        "REPLAY" => "The same event stands twice.",
        "TIME_ROLLBACK" => "The clock was set back between two records, or one of them states a wrong time.",
        "TIME_STEPPED" => {
            "The clock was set forward between two records, or the machine was halted meanwhile: those before it may be dated too \
             early."
        }
        "TRUNCATED" => "Records were cut off the end. Look for a copy that is longer.",
        "HEAD_FORK" => {
            "A checkpoint was signed over other records than these: the ledger was rewritten by someone who holds its key."
        }
        "INCOMPLETE_APPEND" => {
            "A run was killed while it wrote. Nothing was published with it; the next run sets it aside."
        }
        "LEDGER_OPEN" => "The ledger goes on; its last record is no `ledger.close`.",
        "ANCHOR_REQUIRED" => "Name a checkpoint that was kept elsewhere with --checkpoint.",
        "FOLDER_NOT_FOUND" => "The ledger has a record whose folder is not among those that were given.",
        "TOO_MANY_FINDINGS" => "What is wrong is wrong throughout; the rest is not listed.",
        "KEY_EXPIRED" => "The key was not to be trusted at the time that the record states.",
        "KEY_REVOKED" => "The signature counts only with a time stamp from before the revocation.",
        "KEY_REVOKED_LATER" | "CERT_REVOKED_LATER" => "It was signed before; what the key signs now counts no more.",
        "KEY_SCOPE" => "The trust store limits what this key may sign.",
        "CERT_EXPIRED" => "A certificate was not valid at the time that the record states.",
        "CERT_REVOKED" => "The authority had taken the certificate back.",
        "CERT_UNTRUSTED" => {
            "Get the authority's certificate from the authority and add it: orb audit key trust add FILE."
        }
        "MODEL_DIGEST" => "The result was not made with these weights, or they were exchanged since.",
        "PROGRAM_DIGEST" => "The result was not made by this program, or it was exchanged since.",
        "MODEL_NOT_ALLOWED" => "The result was made with weights that your list does not hold.",
        "KEY_SHORT" => "3072 bits or more are advised.",
        _ => "",
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    pub records: u64,
    pub outputs_listed: u64,
    pub outputs_verified: u64,
    pub inputs_listed: u64,
    pub inputs_verified: u64,
    pub errors: u64,
    pub warnings: u64,
    pub notes: u64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Range {
    pub first: u64,
    pub last: u64,
}

/// The result of one verification. Facts of the record stand in it only when its signature is good.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Report {
    pub schema: &'static str,
    pub verdict: Verdict,
    pub exit_code: u8,
    pub ledger_id: Option<String>,
    pub range: Option<Range>,
    /// The last record that a checkpoint kept elsewhere covers.
    pub anchored_through: Option<u64>,
    pub trust_store_sha256: String,
    pub signed_by: Option<String>,
    /// The other keys whose signatures are good.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub also_signed_by: Vec<String>,
    pub trail_hash: Option<String>,
    pub time: Option<String>,
    pub counts: Counts,
    pub findings: Vec<Finding>,
    pub marking: Option<String>,
}

impl Report {
    /// A report that has found nothing yet.
    pub(super) fn new(trust: &TrustStore) -> Report {
        Report {
            schema: SCHEMA,
            verdict: Verdict::Pass,
            exit_code: 0,
            ledger_id: None,
            range: None,
            anchored_through: None,
            trust_store_sha256: trust.sha256(),
            signed_by: None,
            also_signed_by: Vec::new(),
            trail_hash: None,
            time: None,
            counts: Counts::default(),
            findings: Vec::new(),
            marking: None,
        }
    }

    /// Orders the findings, counts them and draws the verdict. `strict` makes warnings count.
    pub(super) fn conclude(&mut self, strict: bool) {
        for finding in &mut self.findings {
            if self.counts.records == 1 {
                finding.seq = self.range.map(|r| r.first);
            }
            if strict && finding.severity == Severity::Warning {
                finding.severity = Severity::Error;
                finding.verdict = Verdict::Fail;
            }
        }
        self.findings.sort_by(|a, b| (a.seq, a.code, &a.subject).cmp(&(b.seq, b.code, &b.subject)));
        self.findings.dedup();
        let count = |severity| self.findings.iter().filter(|f| f.severity == severity).count() as u64;
        (self.counts.errors, self.counts.warnings, self.counts.notes) =
            (count(Severity::Error), count(Severity::Warning), count(Severity::Note));
        self.verdict = self.findings.iter().map(|f| f.verdict).max().unwrap_or(Verdict::Pass);
        self.exit_code = self.verdict.exit_code();
    }

    /// The verdict in words.
    pub(super) fn sentence(&self) -> String {
        let c = &self.counts;
        match self.verdict {
            Verdict::Pass => format!("PASS: {}", self.what_passed()),
            Verdict::Incomplete => "INCOMPLETE: something needed for a verdict is missing".to_owned(),
            Verdict::Refused => "REFUSED: policy does not accept this record".to_owned(),
            Verdict::Fail => {
                format!(
                    "FAIL: {} {} what the record says",
                    c.errors,
                    if c.errors == 1 { "thing is not" } else { "things are not" }
                )
            }
        }
    }

    /// The verdict sentence of a pass: of a folder, of a ledger, of folders against a ledger.
    fn what_passed(&self) -> String {
        let c = &self.counts;
        match (self.range, c.outputs_listed) {
            (Some(_), 1..) => format!(
                "the signature is good and {} of {} outputs are what was sealed",
                c.outputs_verified, c.outputs_listed
            ),
            (Some(range), 0) => format!(
                "{} records verified, {} anchored",
                c.records,
                self.anchored_through.map_or(0, |a| a + 1 - range.first)
            ),
            (None, _) => {
                format!("{} of {} published folders stand in the ledger", c.outputs_verified, c.outputs_listed)
            }
        }
    }

    /// One line of JSON.
    pub fn to_json(&self) -> String {
        // Strings, integers and lists of them always serialise.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// For a person: banner, verdict, facts, findings, banner.
    pub fn to_text(&self) -> String {
        let mut out = String::new();
        let c = &self.counts;
        let banner = self.marking.as_deref().map(|m| format!("{m}\n")).unwrap_or_default();
        out.push_str(&banner);
        let _ = writeln!(out, "{}. Evidence only, not an authorisation.", self.sentence());
        for fingerprint in self.signed_by.iter().chain(&self.also_signed_by) {
            let _ = writeln!(out, "  {:<12}{fingerprint}", "signed by");
        }
        for (name, value) in [("trail hash", &self.trail_hash), ("time", &self.time), ("ledger", &self.ledger_id)] {
            if let Some(value) = value {
                let _ = writeln!(out, "  {name:<12}{value}");
            }
        }
        match (self.range, self.anchored_through) {
            (None, _) => {}
            (Some(range), _) if c.outputs_listed > 0 => {
                let _ = writeln!(out, "  {:<12}{}, tail unanchored", "record", range.first);
            }
            (Some(range), None) => {
                let _ = writeln!(out, "  {:<12}{} to {}, none anchored", "records", range.first, range.last);
            }
            (Some(range), Some(anchored)) => {
                let _ = writeln!(
                    out,
                    "  {:<12}{} to {}, anchored through {anchored}, {} after it not",
                    "records",
                    range.first,
                    range.last,
                    range.last.saturating_sub(anchored)
                );
            }
        }
        let _ = writeln!(out, "  {:<12}{}", "trust store", self.trust_store_sha256);
        for severity in [Severity::Error, Severity::Warning, Severity::Note] {
            for finding in self.findings.iter().filter(|f| f.severity == severity) {
                let _ = write!(out, "{finding}");
            }
        }
        out.push_str(&banner);
        out
    }
}

impl std::fmt::Display for Finding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(f, "{} {}: {}", self.severity.name(), self.code, self.subject)?;
        for (name, value) in [("expected", &self.expected), ("found", &self.actual)] {
            if !value.is_empty() {
                writeln!(f, "    {name:<9}{value}")?;
            }
        }
        if self.hint.is_empty() { Ok(()) } else { writeln!(f, "    {}", self.hint) }
    }
}
