//! The command line: one file a verb.

pub mod argv;
pub mod audit;
mod bar;
mod batch;
pub mod bench;
mod cdb;
pub mod checkpoint;
pub mod device;
pub mod doctor;
pub mod effort;
pub mod export;
mod format;
pub mod geo;
mod ground;
pub mod key;
mod marking;
pub mod models;
mod networks;
mod photos;
pub mod reconstruct;
pub mod render;
mod sealed;
#[cfg(feature = "serve")]
pub mod serve;
mod summary;
pub mod train;
#[cfg(feature = "view")]
pub mod view;

#[cfg(feature = "serve")]
pub(crate) use format::safe_stem;

use std::io::Write as _;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::{Parser, Subcommand};

use crate::audit::DataFolder;
use crate::audit::events::{self, Happened};

/// One photo becomes a 3D model that a simulator loads at the right place on the Earth, with a marking, a signed
/// record and no network.
#[derive(Parser)]
#[command(name = "orb", version, max_term_width = 100, after_help = ENVIRONMENT)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

const ENVIRONMENT: &str = "\
Environment:
  ORB_DATA_DIR         Folder of key, ledger, trust store, networks
  ORB_MODELS_DIR       Folder of networks
  ORB_OPERATOR_NAME    For records, as stated: who works
  ORB_OPERATOR_ROLE    For records, as stated: what they act as
  ORB_RETENTION        For records: how long they are to be kept
  ORB_RECORD_HOSTNAME  1: records name the machine";

#[derive(Subcommand)]
enum Verb {
    /// Turn a photo into a placed, marked, sealed model.
    Geo(Box<geo::GeoArgs>),
    /// Turn a photo into Gaussians alone: neither meshed nor placed.
    Reconstruct(reconstruct::Reconstruct),
    /// Train a scene of Gaussians on a folder of posed photos.
    Train(Box<train::Train>),
    /// Turn a splat or a model into the other formats, placed, marked, sealed.
    Export(Box<export::ExportArgs>),
    /// Turn many photos into one store, several at once, here or by Slurm.
    Batch(Box<batch::BatchArgs>),
    /// Look a CDB store over, whoever wrote it.
    Cdb(cdb::CdbArgs),
    /// Draw a splat (PLY) from cameras, on the GPU where there is one.
    Render(render::Render),
    /// Look at a scene in a browser: a page on a local port.
    #[cfg(feature = "view")]
    View(view::View),
    /// Serve jobs to several people: a page and an interface for programs on a port.
    #[cfg(feature = "serve")]
    Serve(Box<serve::ServeArgs>),
    /// Score reconstructions by Orb-Bench; measure this machine.
    Bench(bench::BenchArgs),
    /// Import networks, list, check and remove them. Nothing is downloaded.
    Models(models::ModelsArgs),
    /// Say what this machine has and lacks, a line each with what to do.
    Doctor(doctor::DoctorArgs),
    /// Verify and show records, make keys.
    Audit(audit::AuditArgs),
}

/// Parses the arguments, runs the verb, prints an error to standard error, gives the exit code.
pub fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(e) => {
            let _ = e.print();
            return ExitCode::from(if e.use_stderr() { 2 } else { 0 });
        }
    };
    // Set by Ctrl-C and by a termination request; long work looks at it between steps.
    let stop = Arc::new(AtomicBool::new(false));
    let handler = Arc::clone(&stop);
    // Without a handler Ctrl-C still ends the program, but a staging folder could stay behind.
    if let Err(e) = ctrlc::set_handler(move || handler.store(true, Ordering::Relaxed)) {
        eprintln!("orb: warning: no interrupt handler: {e}");
    }
    let command = match &cli.verb {
        Verb::Geo(_) => Some("orb geo"),
        Verb::Batch(_) => Some("orb batch"),
        Verb::Reconstruct(_) => Some("orb reconstruct"),
        Verb::Train(_) => Some("orb train"),
        Verb::Render(_) => Some("orb render"),
        Verb::Export(_) => Some("orb export"),
        Verb::Models(_) => Some("orb models"),
        Verb::Audit(args) => args.recorded_as(),
        Verb::Bench(args) => bench::command(args),
        Verb::Cdb(_) | Verb::Doctor(_) => None,
        #[cfg(feature = "view")]
        Verb::View(_) => None,
        #[cfg(feature = "serve")]
        Verb::Serve(_) => Some("orb serve"),
    };
    if let Verb::Geo(args) = &cli.verb
        && args.stop_with_stdin
    {
        let stop = Arc::clone(&stop);
        std::thread::spawn(move || {
            let _ = std::io::copy(&mut std::io::stdin(), &mut std::io::sink());
            stop.store(true, Ordering::Relaxed);
        });
    }
    let done = match cli.verb {
        Verb::Geo(args) => geo::run(&args, &stop),
        Verb::Batch(args) => batch::run(&args, &stop),
        Verb::Reconstruct(args) => reconstruct::run(&args, &stop),
        Verb::Train(args) => train::run(&args, &stop),
        Verb::Export(args) => export::run(&args, &stop),
        Verb::Cdb(args) => cdb::run(&args).map(show),
        Verb::Render(args) => render::publish(&args, &stop),
        #[cfg(feature = "view")]
        Verb::View(args) => view::run(&args, &stop),
        #[cfg(feature = "serve")]
        Verb::Serve(args) => serve::run(&args, &stop),
        Verb::Bench(args) => bench::run(&args, &stop),
        Verb::Models(args) => DataFolder::from_environment(|name| std::env::var_os(name))
            .and_then(|data| models::run(&args, &data))
            .map(show),
        Verb::Doctor(args) => DataFolder::from_environment(|name| std::env::var_os(name))
            .and_then(|data| doctor::run(&args, &data))
            .map(show),
        Verb::Audit(args) => DataFolder::from_environment(|name| std::env::var_os(name))
            .and_then(|data| audit::run(&args, &data))
            .map(show),
    };
    match done {
        Ok(code) => ExitCode::from(code),
        Err(e) => {
            eprintln!("orb: {e}");
            if let Some(command) = command {
                record_failure(command, &e);
            }
            ExitCode::from(e.kind.exit_code())
        }
    }
}

/// The command line `orb geo INPUT OPTIONS` as it is understood.
///
/// # Errors
/// Usage, with clap's own words.
pub(crate) fn geo_args(input: &str, options: &[String]) -> crate::Result<geo::GeoArgs> {
    let line = ["orb", "geo", input].into_iter().chain(options.iter().map(String::as_str));
    match Cli::try_parse_from(line) {
        Ok(Cli { verb: Verb::Geo(args) }) => Ok(*args),
        Ok(_) => Err(crate::Error::usage("options").expected("options of orb geo").found("another verb")),
        Err(e) => Err(crate::Error::usage("options").found(e.to_string())),
    }
}

/// A failed run is an event too. What went wrong with recording it never hides what went wrong with the run.
fn record_failure(command: &str, error: &crate::Error) {
    let Some((kind, code)) = events::of_failure(error) else { return };
    // A verification that could not even begin leaves no more traces than one that could.
    let begins_a_ledger = !command.starts_with("orb audit");
    let happened = Happened { begins_a_ledger, ..Happened::new(kind, command, argv::caller()).failed(Some(&code)) };
    let recorded =
        DataFolder::from_environment(|name| std::env::var_os(name)).and_then(|data| events::log(&data, &happened));
    if let Err(e) = recorded {
        eprintln!("orb: warning: the failure was not recorded: {e}");
    }
}

fn show(outcome: audit::Outcome) -> u8 {
    write_out(&outcome.text);
    outcome.exit_code
}

/// To standard output. Who stops reading, as `head` does, has read enough: that changes nothing of what was done.
pub(crate) fn write_out(text: &str) {
    let mut out = std::io::stdout().lock();
    if let Err(e) = out.write_all(text.as_bytes()).and_then(|()| out.flush())
        && e.kind() != std::io::ErrorKind::BrokenPipe
    {
        eprintln!("orb: warning: standard output: {e}");
    }
}
