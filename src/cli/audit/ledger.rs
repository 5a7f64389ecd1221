//! `orb audit ledger`: verify a ledger, sign a checkpoint of it, archive it, compare folders with it.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};

use super::Outcome;
use crate::audit::disk::Disk;
use crate::audit::events::{self, Happened};
use crate::audit::keys::KeySource;
use crate::audit::ledger_check::{self, LedgerRequest};
use crate::audit::{DataFolder, Ledger, Marking, Policy, SigningKey, TrustStore, allowed, archive, time};
use crate::cli::argv;
use crate::cli::key::KeyArgs;
use crate::{Error, Result};

#[derive(Debug, Args)]
pub struct LedgerArgs {
    #[command(subcommand)]
    pub verb: LedgerVerb,
}

#[derive(Debug, Subcommand)]
pub enum LedgerVerb {
    /// Check every record of a ledger, its chain, and the checkpoints that were kept of it
    Verify(VerifyArgs),
    /// Sign a checkpoint of this user's ledger, to be kept elsewhere: on paper, on another machine
    Checkpoint(CheckpointArgs),
    /// Close this user's ledger and move it away whole; the next record begins a new one
    Archive(ArchiveArgs),
    /// Check that every published folder below some folders stands in the ledger
    Reconcile(ReconcileArgs),
}

#[derive(Debug, Args)]
pub struct VerifyArgs {
    /// The ledger's file or folder; this user's own unless given
    pub ledger: Option<PathBuf>,
    /// A checkpoint that was kept elsewhere (may be given several times)
    #[arg(long, value_name = "FILE")]
    pub checkpoint: Vec<PathBuf>,
    /// Without a checkpoint that covers the last record there is no verdict (exit 3)
    #[arg(long)]
    pub require_anchor: bool,
    /// Trust this public key (PEM) for this run, beside those of the user's trust store
    #[arg(long, value_name = "FILE")]
    pub trust_key: Vec<PathBuf>,
    /// Refuse unless the trust store, with the keys of --trust-key, has this digest: the one that verifications print
    #[arg(long, value_name = "SHA256")]
    pub trust_store: Option<String>,
    /// Refuse records whose clock was not known to agree with UTC (exit 4)
    #[arg(long)]
    pub require_time_sync: bool,
    /// How far a record may be dated before those before it: runs are dated when they begin to write, and several may be at
    /// work at once [default: 600]
    #[arg(long, value_name = "SECONDS")]
    pub time_grace: Option<u32>,
    /// Refuse records made with other network weights than this file lists, a SHA-256 a line (exit 4)
    #[arg(long, value_name = "FILE")]
    pub models: Option<PathBuf>,
    /// Let warnings fail the verification
    #[arg(long)]
    pub strict: bool,
    /// Print the report as one JSON object
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct CheckpointArgs {
    /// The checkpoint's file; it must not exist
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    #[command(flatten)]
    pub key: KeyArgs,
}

#[derive(Debug, Args)]
pub struct ArchiveArgs {
    /// The folder to make; it must not exist
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    #[command(flatten)]
    pub key: KeyArgs,
}

#[derive(Debug, Args)]
pub struct ReconcileArgs {
    /// Folders in which Orb published
    #[arg(required = true)]
    pub folders: Vec<PathBuf>,
    /// The ledger's file or folder; this user's own unless given
    #[arg(long, value_name = "LEDGER")]
    pub ledger: Option<PathBuf>,
    /// Print the report as one JSON object
    #[arg(long)]
    pub json: bool,
}

pub fn run(args: &LedgerArgs, data: &DataFolder) -> Result<Outcome> {
    match &args.verb {
        LedgerVerb::Verify(args) => verify(args, data),
        LedgerVerb::Checkpoint(args) => checkpoint(args, data),
        LedgerVerb::Archive(args) => archive_ledger(args, data),
        LedgerVerb::Reconcile(args) => reconcile(args, data),
    }
}

fn verify(args: &VerifyArgs, data: &DataFolder) -> Result<Outcome> {
    let models = args.models.as_deref().map(allowed::read).transpose()?;
    let report = ledger_check::verify_ledger(&LedgerRequest {
        ledger: &ledger_path(args.ledger.as_deref(), data),
        trust: &TrustStore::load(data, &args.trust_key)?.expect(args.trust_store.as_deref())?,
        checkpoints: &args.checkpoint,
        require_anchor: args.require_anchor,
        now_ms: time::now()?.unix_ms,
        strict: args.strict,
        policy: Policy {
            require_time_sync: args.require_time_sync,
            models: models.as_deref(),
            time_grace_ms: args.time_grace.map(|seconds| u64::from(seconds) * 1000),
            ..Policy::default()
        },
    })?;
    events::log_verdict(data, "orb audit ledger verify", argv::caller(), &report);
    let text = if args.json { format!("{}\n", report.to_json()) } else { report.to_text() };
    Ok(Outcome { text, exit_code: report.exit_code })
}

fn checkpoint(args: &CheckpointArgs, data: &DataFolder) -> Result<Outcome> {
    let key = key("orb audit ledger checkpoint", &args.key, data)?;
    let made = Ledger::at(ledger_path(None, data)).checkpoint()?.ok_or_else(|| {
        Error::incomplete("the ledger")
            .expected("at least one record")
            .found("none")
            .advice("There is nothing to anchor.")
    })?;
    let line = made.sign(&key)?.to_line();
    Disk::default().write_new(&args.output, &line)?;
    let signed = Happened::new("ledger.checkpoint", "orb audit ledger checkpoint", argv::caller());
    events::log(
        data,
        &signed
            .to("key_fingerprint", key.public().fingerprint())
            .to("root", &made.root)
            .to("size", made.size.to_string()),
    )?;
    let text = format!(
        "{}\n  ledger {}, {} records through {}\n  root   {}\n  head   {}\n  Keep it where the ledger's owner cannot \
         change it; the root alone, on paper, serves too.\n",
        args.output.display(),
        made.ledger_id,
        made.size,
        made.utc,
        made.root,
        made.head
    );
    Ok(Outcome { text, exit_code: 0 })
}

fn archive_ledger(args: &ArchiveArgs, data: &DataFolder) -> Result<Outcome> {
    let key = key("orb audit ledger archive", &args.key, data)?;
    let mut random = [0; 10];
    getrandom::fill(&mut random).map_err(|e| Error::environment("random numbers").found(e.to_string()))?;
    let ledger = Ledger::at(ledger_path(None, data));
    let closed = archive::close(ledger, &args.output, &key, argv::caller(), time::now()?, random)?;
    let text = format!(
        "{}\n  ledger {}, closed after {} records\n  The next record begins a new ledger.\n",
        args.output.display(),
        closed.ledger_id,
        closed.size
    );
    Ok(Outcome { text, exit_code: 0 })
}

fn reconcile(args: &ReconcileArgs, data: &DataFolder) -> Result<Outcome> {
    let ledger = ledger_path(args.ledger.as_deref(), data);
    let report = ledger_check::reconcile(&ledger, &args.folders, &TrustStore::load(data, &[])?)?;
    events::log_verdict(data, "orb audit ledger reconcile", argv::caller(), &report);
    let text = if args.json { format!("{}\n", report.to_json()) } else { report.to_text() };
    Ok(Outcome { text, exit_code: report.exit_code })
}

pub(super) fn ledger_path(named: Option<&Path>, data: &DataFolder) -> PathBuf {
    ledger_check::ledger_file(&named.map_or_else(|| data.path().join("ledger"), Path::to_owned))
}

/// The named key, else the user's own.
fn key(command: &str, args: &KeyArgs, data: &DataFolder) -> Result<SigningKey> {
    match args.named() {
        Some(named) => SigningKey::load(named, KeySource::NamedFile),
        None => Ok(events::key_for_run(data, command, &argv::caller(), &Marking::UNCLASSIFIED, None)?.key),
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;
    use crate::audit::publication::tests::publish;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        ledger: LedgerArgs,
    }

    fn orb_audit_ledger(data: &DataFolder, words: &[&str]) -> Result<Outcome> {
        run(&Line::try_parse_from([&["ledger"], words].concat()).unwrap().ledger, data)
    }

    #[test]
    fn checkpoint_verify_reconcile_and_archive() {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let data = DataFolder::at(dir.path().join("data"));
        let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
        let signer = path("out/orb-record.pub.pem");
        let kept = path("kept.json");
        let made = orb_audit_ledger(&data, &["checkpoint", "-o", &kept]).unwrap();
        // The folder's record, and the user's own key made for the checkpoint.
        assert!(made.text.contains("2 records"), "{}", made.text);
        assert_eq!(orb_audit_ledger(&data, &["checkpoint", "-o", &kept]).unwrap_err().expected, "a new file");

        let words = ["verify", "--trust-key", &signer, "--checkpoint", &kept, "--require-anchor", "--json"];
        let report = orb_audit_ledger(&data, &words).unwrap();
        let value: serde_json::Value = serde_json::from_str(&report.text).unwrap();
        assert_eq!((&value["anchored_through"], report.exit_code), (&serde_json::json!(1), 0), "{}", report.text);
        // That it was looked at does not need another checkpoint; that something was made does.
        assert_eq!(orb_audit_ledger(&data, &words).unwrap().exit_code, 0);

        let report = orb_audit_ledger(&data, &["reconcile", &path("")]).unwrap();
        assert!(report.text.contains("1 of 1 published folders") && report.exit_code == 0, "{}", report.text);

        let archive = path("archive");
        let closed = orb_audit_ledger(&data, &["archive", "-o", &archive]).unwrap();
        assert!(closed.text.contains("closed after 7 records"), "{}", closed.text);
        let anchor = path("archive/checkpoint.dsse.json");
        let words = ["verify", &archive, "--trust-key", &signer, "--checkpoint", &anchor, "--require-anchor"];
        let report = orb_audit_ledger(&data, &words).unwrap();
        assert!(report.text.contains("7 records verified, 7 anchored") && report.exit_code == 0, "{}", report.text);
        // A new ledger began with the record of that verification.
        assert!(orb_audit_ledger(&data, &["verify"]).unwrap().text.contains("1 records verified"));
    }
}
