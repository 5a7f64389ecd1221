//! `orb bench`: Orb-Bench, and how fast this machine is.

mod list;
pub mod make;
pub mod mesh;
mod nerf;
mod reconstruct;
pub mod run;
mod scene;
pub mod speed;
pub mod train;

use std::sync::atomic::AtomicBool;

use clap::{Args, Subcommand};

use super::bar::Bar;
use crate::Result;

#[derive(Args, Debug)]
#[command(args_conflicts_with_subcommands = true, arg_required_else_help = true)]
pub struct BenchArgs {
    /// Print the thirty metrics of Orb-Bench.
    #[arg(long)]
    pub list: bool,
    /// One JSON object instead of lines.
    #[arg(long, requires = "list")]
    pub json: bool,
    #[command(subcommand)]
    pub verb: Option<BenchVerb>,
}

#[derive(Subcommand, Debug)]
pub enum BenchVerb {
    /// Score results, Orb's own or anyone's, over scenes: seven domains, thirty metrics.
    Run(Box<run::Run>),
    /// Make scenes whose truth is known.
    Make(Box<make::Make>),
    /// How fast splats are drawn.
    Speed(speed::Speed),
    /// How true models are whose subjects' meshes are known.
    Mesh(mesh::MeshBench),
    /// How fast splats are fitted to pictures, and how well.
    Train(train::Train),
}

/// What a failed run is called in the ledger; none for measurements that publish nothing.
pub fn command(args: &BenchArgs) -> Option<&'static str> {
    match &args.verb {
        Some(BenchVerb::Run(run)) if run.output.is_some() => Some("orb bench run"),
        Some(BenchVerb::Make(_)) => Some("orb bench make"),
        _ => None,
    }
}

/// Runs the verb. `stop` is set by the interrupt handler.
///
/// # Errors
/// As the verbs.
pub fn run(args: &BenchArgs, stop: &AtomicBool) -> Result<u8> {
    let mut say = |line: &str| eprintln!("orb: {line}");
    let measured = |quiet: bool, measure: &mut dyn FnMut(&Bar) -> Result<String>| {
        let bar = Bar::new(stop, quiet);
        let done = measure(&bar);
        bar.finish();
        done.map(|text| crate::cli::write_out(&text))
    };
    match &args.verb {
        None => crate::cli::write_out(&list::run(args.json)),
        Some(BenchVerb::Run(args)) => return run::publish(args, stop),
        Some(BenchVerb::Make(args)) => return make::publish(args, stop),
        Some(BenchVerb::Speed(args)) => measured(false, &mut |bar| speed::run(args, bar, &mut say))?,
        Some(BenchVerb::Mesh(args)) => measured(args.json, &mut |bar| mesh::run(args, bar))?,
        Some(BenchVerb::Train(args)) => measured(false, &mut |bar| train::run(args, bar, &mut say))?,
    }
    Ok(0)
}
