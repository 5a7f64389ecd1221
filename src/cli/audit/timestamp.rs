//! `orb audit timestamp`: ask a time stamping authority for its word, by files, and put its answer beside a record.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};

use super::Outcome;
use crate::audit::disk::{self, Disk};
use crate::audit::dsse::MAX_ENVELOPE_BYTES;
use crate::audit::publication::{RECORD, RECORD_STAMP};
use crate::audit::timestamp::{self, Refused};
use crate::audit::{DataFolder, TrustStore, time, verify};
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
    Ok(Outcome { text: format!("{}\n  not after {utc}, says {}\n", path.display(), stamp.authority), exit_code: 0 })
}
