//! `orb audit report`: a verification as a document.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::Outcome;
use super::ledger::{ledger_path, new_file};
use crate::audit::evidence::{Evidence, to_html, to_markdown};
use crate::audit::ledger_check::{LedgerRequest, verify_ledger};
use crate::audit::verify::{Request, read_record, verify};
use crate::audit::{DataFolder, Ledger, TrustStore, time};
use crate::{Error, Result};

#[derive(Debug, Args)]
pub struct ReportArgs {
    /// The folder that Orb published; this user's ledger unless given
    pub folder: Option<PathBuf>,
    /// The report's file; it must not exist
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// The report's form
    #[arg(long, value_enum, default_value_t = Form::Html)]
    pub format: Form,
    /// Also check that the result was made from this file (may be given several times)
    #[arg(long, value_name = "FILE")]
    pub input: Vec<PathBuf>,
    /// A checkpoint of the ledger that was kept elsewhere (may be given several times)
    #[arg(long, value_name = "FILE")]
    pub checkpoint: Vec<PathBuf>,
    /// Trust this public key (PEM) for this run, beside those of the user's trust store
    #[arg(long, value_name = "FILE")]
    pub trust_key: Vec<PathBuf>,
    /// Date the report YYYY-MM-DDTHH:MM:SS.mmmZ and judge times by that, so that it can be made again byte for byte
    #[arg(long, value_name = "UTC")]
    pub as_of: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Form {
    Html,
    Markdown,
    Json,
}

/// Writes the report. The exit code is the verification's.
pub fn run(args: &ReportArgs, data: &DataFolder) -> Result<Outcome> {
    let as_of_ms = match &args.as_of {
        None => time::now()?.unix_ms,
        Some(text) => time::parse_utc(text).ok_or_else(|| {
            Error::usage("--as-of").expected("a time like 2026-11-21T08:00:00.000Z").found(format!("{text:?}"))
        })?,
    };
    let trust = &TrustStore::load(data, &args.trust_key)?;
    let (report, records) = match &args.folder {
        Some(folder) => {
            let request = Request { folder, trust, inputs: &args.input, store: None, now_ms: as_of_ms, strict: false };
            (verify(&request)?, vec![read_record(folder)?.1])
        }
        None => {
            let ledger = ledger_path(None, data);
            let request = LedgerRequest {
                ledger: &ledger,
                trust,
                checkpoints: &args.checkpoint,
                require_anchor: false,
                now_ms: as_of_ms,
                strict: false,
            };
            // A chain that is broken has no facts to show beside its findings.
            (verify_ledger(&request)?, Ledger::at(ledger).read_chain().unwrap_or_default())
        }
    };
    let evidence = Evidence { report: &report, records: &records, folder: args.folder.as_deref(), as_of_ms };
    let text = match args.format {
        Form::Html => to_html(&evidence)?,
        Form::Markdown => to_markdown(&evidence)?,
        Form::Json => format!("{}\n", report.to_json()),
    };
    new_file(&args.output, text.as_bytes())?;
    Ok(Outcome { text: format!("{}\n", args.output.display()), exit_code: report.exit_code })
}
