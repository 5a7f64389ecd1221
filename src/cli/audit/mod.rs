//! `orb audit`: verify a published folder, show its record, make a key, look after the ledger.

mod export;
mod ledger;
mod report;
mod timestamp;
mod trust;

use std::path::PathBuf;

use clap::{Args, Subcommand};

use crate::audit::by_hand;
use crate::audit::keys::{self, Algorithm, Bits, Passphrase, Suite};
use crate::audit::report::Verdict;
use crate::audit::sbom;
use crate::audit::statement::RECORD_SCHEMA;
use crate::audit::verify::{self, Request};
use crate::audit::{DataFolder, Policy, TrustStore, time};
use crate::audit::{allowed, events};
use crate::cli::argv;
use crate::cli::key::PassphraseSource;
use crate::{Error, Result};

#[derive(Debug, Args)]
pub struct AuditArgs {
    #[command(subcommand)]
    pub verb: AuditVerb,
}

#[derive(Debug, Subcommand)]
pub enum AuditVerb {
    /// Check a published folder against its record, offline
    Verify(VerifyArgs),
    /// Print the record of a published folder
    Show(ShowArgs),
    /// Make a signing key: FILE (private, mode 0600) and FILE.pub.pem
    Keygen(KeygenArgs),
    /// Say whose signatures count: trust add, list, revoke
    Key(trust::KeyVerbArgs),
    /// Ask an authority for a time stamp of a record, by files, and import its answer
    Timestamp(timestamp::TimestampArgs),
    /// Verify, checkpoint, archive and reconcile the ledger of all records
    Ledger(ledger::LedgerArgs),
    /// Write what a verification found, for a compliance officer
    Report(Box<report::ReportArgs>),
    /// Write a verified record for another system: OSCAL, SLSA, Civium
    Export(export::ExportArgs),
    /// Print the JSON Schema of a record
    Schema,
    /// Print what this program is built from (CycloneDX 1.5); records state its digest
    Sbom,
    /// List the kinds of events that are recorded, and the records of the ledger
    Events(EventsArgs),
}

impl AuditArgs {
    /// What records call it when it fails; `None` for what only shows.
    pub fn recorded_as(&self) -> Option<&'static str> {
        match &self.verb {
            AuditVerb::Verify(_) => Some("orb audit verify"),
            AuditVerb::Keygen(_) => Some("orb audit keygen"),
            AuditVerb::Key(_) => Some("orb audit key"),
            AuditVerb::Timestamp(_) => Some("orb audit timestamp"),
            AuditVerb::Ledger(_) => Some("orb audit ledger"),
            AuditVerb::Report(_) => Some("orb audit report"),
            AuditVerb::Export(_) => Some("orb audit export"),
            AuditVerb::Show(_) | AuditVerb::Schema | AuditVerb::Sbom | AuditVerb::Events(_) => None,
        }
    }
}

#[derive(Debug, Args)]
pub struct VerifyArgs {
    /// The folder that Orb published
    pub folder: PathBuf,
    /// Also check that the result was made from this file (may be given several times)
    #[arg(long, value_name = "FILE")]
    pub input: Vec<PathBuf>,
    /// Give no verdict (exit 3) unless every input that the record names was compared with an --input
    #[arg(long)]
    pub require_inputs: bool,
    /// Also check that the result was made with these network weights: a file, or a network's folder (may be given several
    /// times)
    #[arg(long, value_name = "FILE|FOLDER")]
    pub weights: Vec<PathBuf>,
    /// Also check that the result was made by this program: an orb, as a file
    #[arg(long, value_name = "FILE")]
    pub program: Option<PathBuf>,
    /// Also check the files merged into this CDB store
    #[arg(long, value_name = "FOLDER")]
    pub store: Option<PathBuf>,
    /// Trust this public key (PEM) for this run, beside those of the user's trust store
    #[arg(long, value_name = "FILE")]
    pub trust_key: Vec<PathBuf>,
    /// Refuse unless the trust store, with the keys of --trust-key, has this digest: the one that verifications print
    #[arg(long, value_name = "SHA256")]
    pub trust_store: Option<String>,
    /// Refuse records whose clock was not known to agree with UTC (exit 4)
    #[arg(long)]
    pub require_time_sync: bool,
    /// Refuse records made with other network weights than this file lists, a SHA-256 a line (exit 4)
    #[arg(long, value_name = "FILE")]
    pub models: Option<PathBuf>,
    /// Let warnings, such as unlisted files, fail the verification
    #[arg(long)]
    pub strict: bool,
    /// Print the report as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Print the openssl and sha256sum commands that repeat the checks without Orb, and check nothing
    #[arg(long)]
    pub print_openssl: bool,
}

#[derive(Debug, Args)]
pub struct ShowArgs {
    /// The folder that Orb published
    pub folder: PathBuf,
    /// Trust this public key (PEM) for this run, beside those of the user's trust store
    #[arg(long, value_name = "FILE")]
    pub trust_key: Vec<PathBuf>,
    /// Print the record alone, as the JSON that was signed
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct EventsArgs {
    /// Print the kinds of events as JSON, and no records
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct KeygenArgs {
    /// The private key's file; it must not exist
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// What the key is for: RSA (default, cnsa1), ML-DSA-87 (cnsa2), or an RSA and an ML-DSA-87 key in one file, which sign
    /// together (hybrid)
    #[arg(long, value_enum, default_value_t)]
    pub profile: Suite,
    /// Length of the RSA key's modulus [default: 3072]
    #[arg(long, value_enum)]
    pub bits: Option<Bits>,
    /// Encrypt the private key; where the passphrase is: file:PATH (its first line), env:NAME, or prompt
    #[arg(long, value_name = "SOURCE")]
    pub passphrase: Option<PassphraseSource>,
}

/// What a verb prints on standard output, and how it ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outcome {
    pub text: String,
    pub exit_code: u8,
}

/// Runs a verb.
///
/// # Errors
/// Where no report could be made; a report with findings is an [`Outcome`] with its exit code.
pub fn run(args: &AuditArgs, data: &DataFolder) -> Result<Outcome> {
    match &args.verb {
        AuditVerb::Verify(args) => verify(args, data),
        AuditVerb::Show(args) => show(args, data),
        AuditVerb::Keygen(args) => keygen(args, data),
        AuditVerb::Key(args) => trust::run(args, data),
        AuditVerb::Timestamp(args) => timestamp::run(args, data),
        AuditVerb::Report(args) => report::run(args, data),
        AuditVerb::Export(args) => export::run(args, data),
        AuditVerb::Events(args) => list_events(args, data),
        AuditVerb::Sbom => Ok(Outcome { text: sbom::cyclonedx(), exit_code: 0 }),
        AuditVerb::Schema => Ok(Outcome { text: RECORD_SCHEMA.into(), exit_code: 0 }),
        AuditVerb::Ledger(args) => ledger::run(args, data),
    }
}

pub fn verify(args: &VerifyArgs, data: &DataFolder) -> Result<Outcome> {
    if args.print_openssl {
        let beside = by_hand::Beside { inputs: &args.input, store: args.store.as_deref() };
        return Ok(Outcome { text: by_hand::openssl_commands(&args.folder, beside)?, exit_code: 0 });
    }
    let trust = TrustStore::load(data, &args.trust_key)?.expect(args.trust_store.as_deref())?;
    let models = args.models.as_deref().map(allowed::read).transpose()?;
    let report = verify::verify(&Request {
        inputs: &args.input,
        weights: &args.weights,
        program: args.program.as_deref(),
        store: args.store.as_deref(),
        strict: args.strict,
        policy: Policy {
            require_time_sync: args.require_time_sync,
            models: models.as_deref(),
            require_inputs: args.require_inputs,
            time_grace_ms: None,
        },
        ..Request::new(&args.folder, &trust, time::now()?.unix_ms)
    })?;
    let text = if args.json { format!("{}\n", report.to_json()) } else { report.to_text() };
    events::log_verdict(data, "orb audit verify", argv::caller(), &report);
    Ok(Outcome { text, exit_code: report.exit_code })
}

/// The record, and whether it can be believed. The exit code is the verification's: what is shown may be forged.
pub fn show(args: &ShowArgs, data: &DataFolder) -> Result<Outcome> {
    let (envelope, statement) = verify::read_record(&args.folder)?;
    let json = statement
        .to_json()
        .map_err(|f| Error::integrity(args.folder.display().to_string()).found(f.detail().to_owned()))?;
    let trust = TrustStore::load(data, &args.trust_key)?;
    let report = verify::verify(&Request::new(&args.folder, &trust, time::now()?.unix_ms))?;
    verify::check_same(&args.folder, &report, &envelope)?;
    let unserialisable = |e: serde_json::Error| Error::integrity("record").found(e.to_string());
    let text = if args.json {
        format!("{}\n", serde_json::to_string(&json).map_err(unserialisable)?)
    } else {
        let banner = &statement.predicate.marking.banner;
        let trusted = match report.verdict {
            Verdict::Pass => "Verified: signed by a trusted key, and every output is what was sealed.",
            _ => "NOT VERIFIED: what follows is what the file says. See `orb audit verify`.",
        };
        let body = serde_json::to_string_pretty(&json).map_err(unserialisable)?;
        format!("{banner}\n{trusted}\n{body}\n{banner}\n")
    };
    Ok(Outcome { text, exit_code: report.exit_code })
}

/// What is recorded, and what was.
pub fn list_events(args: &EventsArgs, data: &DataFolder) -> Result<Outcome> {
    if args.json {
        let json =
            serde_json::to_string(&events::EVENT_TYPES[..]).map_err(|e| Error::usage("events").found(e.to_string()))?;
        return Ok(Outcome { text: format!("{json}\n"), exit_code: 0 });
    }
    let mut text = String::from("Recorded, always:\n");
    for kind in events::EVENT_TYPES {
        text.push_str(&format!("  {:<18} {}; {}\n", kind.name, kind.when, kind.why));
    }
    let ledger = data.path().join("ledger/orb-ledger.jsonl");
    if ledger.is_file() {
        text.push_str(&format!("\n{}:\n{}", ledger.display(), events::list(&ledger)?));
    }
    Ok(Outcome { text, exit_code: 0 })
}

pub fn keygen(args: &KeygenArgs, data: &DataFolder) -> Result<Outcome> {
    if args.bits.is_some() && !args.profile.has_rsa() {
        return Err(Error::usage("--bits")
            .expected("a profile with an RSA key")
            .found("--profile cnsa2, whose key has one length"));
    }
    let passphrase = args.passphrase.as_ref().map(Passphrase::read).transpose()?;
    let passphrase = passphrase.as_ref().map(|p| p.as_str());
    let key = keys::keygen(&args.output, args.profile, args.bits.unwrap_or_default(), passphrase)?;
    events::log(data, &events::about_key("key.generate", "orb audit keygen", argv::caller(), &key))?;
    let mut text = format!("{}\n", args.output.display());
    for key in key.all() {
        let (public, algorithm) = (key.public(), key.algorithm().name());
        let kind = if public.kind() == algorithm { public.kind() } else { format!("{}, {algorithm}", public.kind()) };
        text.push_str(&format!("  {kind}, SPKI SHA-256 {}\n", public.fingerprint()));
    }
    // A file of one RSA key does not say how it signs.
    if key.partner().is_none() && key.algorithm() == Algorithm::Rs384 {
        text.push_str("  Sign with --sign-algorithm RS384.\n");
    }
    text.push_str("  Keep the private key; give the .pub.pem beside it to whoever verifies.\n");
    Ok(Outcome { text, exit_code: 0 })
}

#[cfg(test)]
mod tests {
    use std::fs;

    use clap::Parser;

    use super::*;
    use crate::Kind;
    use crate::audit::publication::tests::publish;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        audit: AuditArgs,
    }

    fn orb_audit(data: &DataFolder, words: &[&str]) -> Result<Outcome> {
        let line = Line::try_parse_from([&["audit"], words].concat()).unwrap();
        run(&line.audit, data)
    }

    #[test]
    fn make_a_key_verify_and_show() {
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path().join("elsewhere"));
        let published = publish(dir.path());
        let out = published.folder.to_str().unwrap();
        let key = dir.path().join("signer.pem");
        fs::copy(published.folder.join("orb-record.pub.pem"), &key).unwrap();
        let key = key.to_str().unwrap();

        // The test's record is dated; no machine's clock stands before it.
        let stranger = orb_audit(&data, &["verify", out]).unwrap();
        assert_eq!(stranger.exit_code, 3);
        assert!(stranger.text.contains("TRUST_STORE_EMPTY"));
        assert!(!data.path().exists());
        let shown = orb_audit(&data, &["show", out]).unwrap();
        assert!(shown.text.contains("NOT VERIFIED") && shown.exit_code == 3);

        let report = orb_audit(&data, &["verify", out, "--trust-key", key, "--json"]).unwrap();
        let value: serde_json::Value = serde_json::from_str(&report.text).unwrap();
        assert_eq!(value["signed_by"], published.signed_by.as_str());
        assert_eq!(value["exit_code"], report.exit_code);

        let json = orb_audit(&data, &["show", out, "--trust-key", key, "--json"]).unwrap();
        let value: serde_json::Value = serde_json::from_str(&json.text).unwrap();
        assert_eq!(value["predicate"]["trail_hash"], published.trail_hash.as_str());

        let by_hand = orb_audit(&data, &["verify", out, "--print-openssl"]).unwrap();
        assert!(by_hand.text.contains("openssl dgst -sha256 -verify"));

        let new = dir.path().join("unit.pem");
        let made = orb_audit(&data, &["keygen", "-o", new.to_str().unwrap()]).unwrap();
        assert!(made.text.contains("RSA-3072") && new.exists() && dir.path().join("unit.pub.pem").exists());
        let again = orb_audit(&data, &["keygen", "-o", new.to_str().unwrap()]).unwrap_err();
        assert_eq!(again.kind, Kind::Usage);
    }

    #[test]
    fn a_key_for_each_profile() {
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path().join("elsewhere"));
        let make = |profile: &str, more: &[&str]| {
            let path = dir.path().join(format!("{profile}.pem"));
            orb_audit(&data, &[&["keygen", "--profile", profile, "-o", path.to_str().unwrap()], more].concat())
        };
        let cnsa1 = make("cnsa1", &["--bits", "4096"]).unwrap().text;
        assert!(cnsa1.contains("RSA-4096, RS384") && cnsa1.contains("--sign-algorithm RS384"), "{cnsa1}");
        assert_eq!(make("cnsa2", &["--bits", "3072"]).unwrap_err().kind, Kind::Usage);
        if cfg!(feature = "fips") {
            assert!(make("cnsa2", &[]).unwrap_err().found.contains("FIPS module"));
            return;
        }
        let cnsa2 = make("cnsa2", &[]).unwrap().text;
        assert!(cnsa2.contains("  ML-DSA-87, SPKI SHA-256 ") && !cnsa2.contains("RSA"), "{cnsa2}");
        let hybrid = make("hybrid", &[]).unwrap().text;
        assert!(hybrid.contains("RSA-3072, RS384") && hybrid.contains("ML-DSA-87, SPKI"), "{hybrid}");
        let public = dir.path().join("hybrid.pub.pem");
        let added = orb_audit(&data, &["key", "trust", "add", public.to_str().unwrap(), "--name", "Jane"]).unwrap();
        assert!(added.text.contains("two keys that count together only"), "{}", added.text);
        let listed = orb_audit(&data, &["key", "trust", "list"]).unwrap().text;
        assert!(listed.matches("only with").count() == 2 && listed.matches("Jane").count() == 2, "{listed}");
    }

    #[test]
    fn trust_list_and_revoke() {
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path().join("elsewhere"));
        let published = publish(dir.path());
        let out = published.folder.to_str().unwrap();
        let key = published.folder.join("orb-record.pub.pem");
        let trust = |words: &[&str]| orb_audit(&data, &[&["key", "trust"], words].concat());
        let verified = || orb_audit(&data, &["verify", out]).unwrap();
        assert_eq!(verified().exit_code, 3);
        let added = trust(&["add", key.to_str().unwrap(), "--name", "Jane", "--max-marking", "CUI"]).unwrap();
        assert!(added.text.contains(&published.signed_by), "{}", added.text);
        assert_eq!(verified().exit_code, 0, "{}", verified().text);
        let listed = trust(&["list"]).unwrap().text;
        assert!(listed.contains("name       Jane") && listed.contains("up to      CUI"), "{listed}");
        let json: serde_json::Value = serde_json::from_str(&trust(&["list", "--json"]).unwrap().text).unwrap();
        let pinned = json["trust_store_sha256"].as_str().unwrap();
        assert_eq!(orb_audit(&data, &["verify", out, "--trust-store", pinned]).unwrap().exit_code, 0);

        // The record is of November 2025.
        let revoke = |from: &str, reason: &str| {
            trust(&["revoke", &published.signed_by, "--reason", reason, "--from", from]).map(|_| verified())
        };
        let later = revoke("2026-01-01T00:00:00.000Z", "superseded").unwrap();
        assert!(later.exit_code == 0 && later.text.contains("KEY_REVOKED_LATER"), "{}", later.text);
        let stolen = revoke("2026-01-01T00:00:00.000Z", "compromise").unwrap();
        assert!(stolen.exit_code == 1 && stolen.text.contains("KEY_REVOKED"), "{}", stolen.text);
        assert_eq!(revoke("yesterday", "ceased").unwrap_err().kind, Kind::Usage);
        // Nothing makes a compromise less, and what was refused is not told as done.
        let told = || crate::audit::events::list(&data.path().join("ledger/orb-ledger.jsonl")).unwrap();
        let before = told().matches("key.revoke ").count();
        assert_eq!(revoke("2025-10-01T00:00:00.000Z", "superseded").unwrap_err().kind, Kind::Usage);
        assert_eq!(verified().exit_code, 1);
        assert!(trust(&["revoke", &"0".repeat(64), "--reason", "ceased"]).is_err());
        assert_eq!(told().matches("key.revoke ").count(), before);
        let changed = orb_audit(&data, &["verify", out, "--trust-store", pinned]).unwrap_err();
        assert!(changed.found.contains("TRUST_STORE_CHANGED"), "{changed}");
    }
}
