//! `orb audit report`: a verification as a document.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::Outcome;
use super::ledger::ledger_path;
use crate::audit::disk::Disk;
use crate::audit::evidence::{Evidence, to_html, to_markdown};
use crate::audit::ledger_check::{LedgerRequest, verify_ledger};
use crate::audit::verify::{Request, read_record, verify};
use crate::audit::{DataFolder, Ledger, Policy, TrustStore, events, time};
use crate::cli::argv;
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
            let request = Request { inputs: &args.input, ..Request::new(folder, trust, as_of_ms) };
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
                policy: Policy::default(),
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
    Disk::default().write_new(&args.output, text.as_bytes())?;
    events::log_verdict(data, "orb audit report", argv::caller(), &report);
    Ok(Outcome { text: format!("{}\n", args.output.display()), exit_code: report.exit_code })
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::super::export::{self, ExportArgs};
    use super::*;
    use crate::audit::publication::tests::publish;

    #[derive(Parser)]
    struct Report {
        #[command(flatten)]
        args: ReportArgs,
    }

    #[derive(Parser)]
    struct Export {
        #[command(flatten)]
        args: ExportArgs,
    }

    #[test]
    fn a_folder_and_a_ledger_as_documents_and_exports() {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let data = DataFolder::at(dir.path().join("data"));
        let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
        let (out, key) = (path("out"), path("out/orb-record.pub.pem"));
        let report = |file: &str, more: &[&str]| {
            let file = path(file);
            let words = [&["report", "-o", &file, "--trust-key", &key], more].concat();
            run(&Report::try_parse_from(words).unwrap().args, &data)
                .map(|done| (done, std::fs::read_to_string(file).unwrap()))
        };
        let as_of = ["--as-of", "2026-01-01T00:00:00.000Z"];
        let (done, html) = report("a.html", &[&[out.as_str()], &as_of[..]].concat()).unwrap();
        assert!(done.exit_code == 0 && html.contains("Verify again, without Orb"), "{}", done.text);
        let (_, again) = report("b.html", &[&[out.as_str()], &as_of[..]].concat()).unwrap();
        assert_eq!(html, again);
        let (done, text) = report("ledger.md", &["--format", "markdown"]).unwrap();
        assert!(done.exit_code == 0 && text.contains("1 records verified"), "{text}");
        assert_eq!(report("a.html", &[&out]).unwrap_err().expected, "a new file");
        assert_eq!(report("c.html", &["--as-of", "today"]).unwrap_err().kind, crate::Kind::Usage);

        let export = |system: &str| {
            let file = path(&format!("{system}.json"));
            let words = ["export", &out, "--for", system, "-o", &file, "--trust-key", &key];
            let done = export::run(&Export::try_parse_from(words).unwrap().args, &data).unwrap();
            (done.exit_code, std::fs::read_to_string(file).ok())
        };
        for system in ["oscal", "slsa", "civium"] {
            let (code, text) = export(system);
            assert_eq!(code, 0);
            serde_json::from_str::<serde_json::Value>(&text.unwrap()).unwrap();
            std::fs::remove_file(path(&format!("{system}.json"))).unwrap();
        }
        std::fs::write(dir.path().join("out/scene.ply"), "changed").unwrap();
        assert_eq!(export("oscal"), (1, None), "nothing is exported that does not verify");
    }
}
