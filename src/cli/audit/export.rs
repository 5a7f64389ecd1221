//! `orb audit export`: a verified record in the words of other systems.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::Outcome;
use crate::audit::disk::Disk;
use crate::audit::interchange::{civium, oscal, slsa};
use crate::audit::report::Verdict;
use crate::audit::verify::{Request, check_same, read_record, verify};
use crate::audit::{DataFolder, TrustStore, events, time};
use crate::cli::argv;
use crate::{Error, Result};

#[derive(Debug, Args)]
pub struct ExportArgs {
    /// The folder that Orb published
    pub folder: PathBuf,
    /// The system to write for
    #[arg(long = "for", value_enum)]
    pub system: System,
    /// The file to write; it must not exist
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// Trust this public key (PEM) for this run, beside those of the user's trust store
    #[arg(long, value_name = "FILE")]
    pub trust_key: Vec<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum System {
    /// NIST OSCAL assessment results
    Oscal,
    /// SLSA provenance v1
    Slsa,
    /// An entry and an evidence object for a Civium audit service
    Civium,
}

/// Writes the file when the folder verifies, and nothing when it does not.
pub fn run(args: &ExportArgs, data: &DataFolder) -> Result<Outcome> {
    let trust = &TrustStore::load(data, &args.trust_key)?;
    let now_ms = time::now()?.unix_ms;
    let report = verify(&Request::new(&args.folder, trust, now_ms))?;
    events::log_verdict(data, "orb audit export", argv::caller(), &report);
    if report.verdict != Verdict::Pass {
        return Ok(Outcome { text: report.to_text(), exit_code: report.exit_code });
    }
    let (envelope, statement) = read_record(&args.folder)?;
    check_same(&args.folder, &report, &envelope)?;
    let value = match args.system {
        System::Oscal => oscal::assessment_results(&report, &statement, &time::format_utc(now_ms)),
        System::Slsa => slsa::provenance(&statement),
        System::Civium => {
            let signature = envelope.signatures.first().map(|s| s.sig.as_slice()).unwrap_or_default();
            civium::entry(&statement, signature, &oscal::CONTROLS)
        }
    };
    let mut text = serde_json::to_string_pretty(&value).map_err(|e| Error::usage("export").found(e.to_string()))?;
    text.push('\n');
    Disk::default().write_new(&args.output, text.as_bytes())?;
    Ok(Outcome { text: format!("{}\n", args.output.display()), exit_code: 0 })
}
