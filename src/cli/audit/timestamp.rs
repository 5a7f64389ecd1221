//! `orb audit timestamp`: ask a time stamping authority for its word, by files, and put its answer beside a record.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};

use super::Outcome;
use crate::audit::disk::{self, Disk};
use crate::audit::dsse::MAX_ENVELOPE_BYTES;
use crate::audit::events::{self, Happened};
use crate::audit::publication::{RECORD, RECORD_STAMP};
use crate::audit::timestamp::{self, Refused};
use crate::audit::{DataFolder, TrustStore, time, verify};
use crate::cli::argv;
use crate::{Error, Result};

#[derive(Debug, Args)]
pub struct TimestampArgs {
    #[command(subcommand)]
    pub verb: TimestampVerb,
}

#[derive(Debug, Subcommand)]
pub enum TimestampVerb {
    /// Write a request (RFC 3161) for a time stamp of a folder's record, to be carried to an authority
    Request(RequestArgs),
    /// Check the authority's answer and put it beside the record
    Import(ImportArgs),
}

#[derive(Debug, Args)]
pub struct RequestArgs {
    /// The folder that Orb published
    pub folder: PathBuf,
    /// The request's file; it must not exist
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

#[derive(Debug, Args)]
pub struct ImportArgs {
    /// The folder that Orb published
    pub folder: PathBuf,
    /// The response or the token, DER
    pub token: PathBuf,
}

pub fn run(args: &TimestampArgs, data: &DataFolder) -> Result<Outcome> {
    match &args.verb {
        TimestampVerb::Request(args) => request(args),
        TimestampVerb::Import(args) => import(args, data),
    }
}

/// The bytes that are stamped: the envelope, so that the signature is covered too.
fn record(folder: &Path) -> Result<Vec<u8>> {
    verify::read_record(folder)?;
    disk::read_limited(&folder.join(RECORD), MAX_ENVELOPE_BYTES as u64)
}

fn request(args: &RequestArgs) -> Result<Outcome> {
    let mut nonce = [0; 8];
    getrandom::fill(&mut nonce).map_err(|e| Error::environment("random numbers").found(e.to_string()))?;
    let request = timestamp::request(&record(&args.folder)?, nonce)
        .map_err(|found| Error::usage(args.folder.display().to_string()).found(found))?;
    Disk::default().write_new(&args.output, &request)?;
    let text = format!(
        "{}\n  Carry it to a time stamping authority (application/timestamp-query), and its answer back:\n  \
         orb audit timestamp import {} ANSWER.tsr\n",
        args.output.display(),
        args.folder.display()
    );
    Ok(Outcome { text, exit_code: 0 })
}

fn import(args: &ImportArgs, data: &DataFolder) -> Result<Outcome> {
    let token = disk::read_limited(&args.token, timestamp::MAX_BYTES)?;
    let trust = TrustStore::load(data, &[])?;
    let (_, statement) = verify::read_record(&args.folder)?;
    let stamp = timestamp::check(&token, &record(&args.folder)?, &trust).map_err(|refused| {
        let subject = args.token.display().to_string();
        match refused {
            Refused::Untrusted(why) => Error::policy(subject)
                .expected("a time stamp by an authority that is trusted here")
                .found(format!("TIME_STAMP_UNTRUSTED: {why}"))
                .advice("Add the authority's certificate first: orb audit key trust add FILE."),
            Refused::Invalid(why) => Error::integrity(subject)
                .expected("a time stamp of this folder's record")
                .found(format!("TIME_STAMP_INVALID: {why}")),
        }
    })?;
    let path = args.folder.join(RECORD_STAMP);
    Disk::default().write_new(&path, &token)?;
    let utc = time::format_utc(stamp.not_after_ms);
    let imported = Happened::new("record.timestamp", "orb audit timestamp import", argv::caller());
    let trail_hash = statement.predicate.trail_hash.unwrap_or_default();
    events::log(data, &imported.to("trail_hash", trail_hash).to("not_after", &utc).to("authority", &stamp.authority))?;
    Ok(Outcome { text: format!("{}\n  not after {utc}, says {}\n", path.display(), stamp.authority), exit_code: 0 })
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::publication::tests::publish;
    use crate::audit::trust::tests::{Pki, store_with};
    use crate::audit::{by_hand, ledger_check};

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        timestamp: TimestampArgs,
    }

    /// The whole way, with an authority of OpenSSL's on this machine: request, answer, import, verification with Orb, and
    /// the printed command without it.
    #[test]
    fn request_answer_import_verify() {
        let Some(pki) = Pki::new() else { return };
        pki.sign("tsa", "issuing", "tsa", "20240101000000Z", "20340101000000Z");
        publish(pki.dir.path());
        let data = DataFolder::at(pki.path("data"));
        let path = |name: &str| pki.path(name).to_str().unwrap().to_owned();
        let run =
            |words: &[&str]| run(&Line::try_parse_from([&["timestamp"], words].concat()).unwrap().timestamp, &data);
        let (out, tsq, tsr) = (path("out"), path("r.tsq"), path("r.tsr"));
        run(&["request", &out, "-o", &tsq]).unwrap();
        pki.openssl(&["ts", "-reply", "-config", "ca.cnf", "-section", "t", "-queryfile", "r.tsq", "-out", "r.tsr"]);

        let refused = run(&["import", &out, &tsr]).unwrap_err();
        assert!(refused.found.contains("TIME_STAMP_UNTRUSTED") && !pki.path("out").join(RECORD_STAMP).exists());
        let mut trust = store_with(&pki, &[]);
        trust.insert(shared_key().public().clone());
        let imported = run(&["import", &out, &tsr]).unwrap();
        assert!(imported.text.contains("not after") && imported.text.contains("CN=Test tsa"), "{}", imported.text);
        assert_eq!(run(&["import", &out, &tsr]).unwrap_err().expected, "a new file", "never over another");
        let report = verify::verify(&verify::Request::new(&pki.path("out"), &trust, 1_763_700_000_000)).unwrap();
        assert!(
            report.exit_code == 0 && report.findings.iter().any(|f| f.code == "TIME_STAMPED"),
            "{}",
            report.to_text()
        );
        let ledger = ledger_check::ledger_file(&data.path().join("ledger"));
        assert!(events::list(&ledger).unwrap().contains("record.timestamp   success authority=CN=Test tsa"));

        let commands = by_hand::openssl_commands(&pki.path("out"), by_hand::Beside::default()).unwrap();
        let commands = commands.replace("TSA-AUTHORITY.pem", &path("root.pem"));
        let done = std::process::Command::new("bash").args(["-ec", &commands]).output().unwrap();
        let said = String::from_utf8_lossy(&done.stdout).into_owned() + &String::from_utf8_lossy(&done.stderr);
        assert!(done.status.success() && said.contains("Verification: OK"), "{said}");
    }
}
