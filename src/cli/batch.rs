//! `orb batch`: a manifest of photos over the cores of one machine, or over the nodes of a Slurm cluster.
//!
//! Rows go into shards that share no geocell ([`shard`]); each shard is one `orb geo --manifest` into a store of its own
//! ([`task`]), run here or by Slurm ([`engine`]); then the shards' stores become one ([`join`]). What a row published is known
//! by its record: running the same command again does what is missing.

mod engine;
mod join;
mod plan;
mod shard;
mod task;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::{Args, ValueEnum};

use crate::{Error, Kind, Result};
use plan::Plan;

/// Who runs the shards.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Engine {
    /// This machine
    Local,
    /// A job array, by sbatch
    Slurm,
}

/// Many photos into one store, several at once, on this machine or by Slurm; the same command again goes on. Options of `orb
/// geo` for all rows stand behind `--`.
#[derive(Args, Clone, Debug)]
pub struct BatchArgs {
    /// A CSV file as of `orb geo --manifest`: a row a photo, its first line names the columns.
    #[arg(long, value_name = "FILE", required_unless_present = "run_shard")]
    manifest: Option<PathBuf>,

    #[arg(long, value_enum, default_value = "local")]
    engine: Engine,

    /// Folder of the results: a published folder a row, and store.cdb. Default: the manifest's name without its extension.
    #[arg(short = 'o', long, value_name = "DIR")]
    output: Option<PathBuf>,

    /// Shards at once.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=4096))]
    jobs: u32,

    /// Threads of each; results may depend on it, so it stays what it was at first.
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: u32,

    /// How often what failed is run again.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(0..=10))]
    retries: u32,

    /// The time that files carry, such as 2026-01-31T12:00:00.000Z. Default: when the batch was begun.
    #[arg(long, value_name = "UTC")]
    as_of: Option<String>,

    /// An option for sbatch, such as --sbatch=--partition=gpu (may be given several times).
    #[arg(long = "sbatch", value_name = "OPTION", allow_hyphen_values = true)]
    sbatch: Vec<String>,

    /// One JSON object on standard output.
    #[arg(long)]
    json: bool,

    /// Run one shard of a batch that was begun: what the job array does.
    #[arg(long, hide = true, value_name = "N", requires = "output")]
    run_shard: Option<usize>,

    /// Options of orb geo, for every row: `-- --format cdb,glb --quality draft`.
    #[arg(last = true, value_name = "OPTIONS")]
    geo: Vec<String>,
}

/// Runs the verb. `stop` is set by the interrupt handler.
///
/// # Errors
/// A manifest or option that cannot be used, another batch in the folder, an interrupt, the engine. Rows that fail alone end in
/// exit code 3.
pub fn run(args: &BatchArgs, stop: &AtomicBool) -> Result<u8> {
    if let (Some(number), Some(output)) = (args.run_shard, &args.output) {
        let plan = Plan::read(output)?;
        let done = task::run(&plan, number, stop)?;
        return Ok(if done.failed.is_empty() { 0 } else { Kind::Incomplete.exit_code() });
    }
    let manifest = args.manifest.as_ref().ok_or_else(|| Error::usage("--manifest").expected("a file").found("none"))?;
    let plan = Plan::make(args, manifest)?;
    let _only = plan.lock()?;
    let mut open: Vec<usize> = (0..plan.shards.len()).collect();
    for attempt in 0..=args.retries {
        if open.is_empty() {
            break;
        }
        if attempt > 0 {
            eprintln!("orb: {} shards again, attempt {}", open.len(), attempt + 1);
        }
        plan.forget(&open)?;
        match args.engine {
            Engine::Local => engine::local(&plan, &open, args.jobs, stop)?,
            Engine::Slurm => engine::slurm(&plan, &open, args, stop)?,
        }
        open.retain(|number| plan.outcome(*number).is_none_or(|o| !o.failed.is_empty()));
    }
    let joined = join::run(&plan)?;
    report(args, &plan, joined.as_deref())
}

fn report(args: &BatchArgs, plan: &Plan, store: Option<&std::path::Path>) -> Result<u8> {
    let (mut published, mut already, mut failed) = (0, 0, plan.refused.clone());
    for (number, shard) in plan.shards.iter().enumerate() {
        match plan.outcome(number) {
            Some(outcome) => {
                published += outcome.published;
                already += outcome.already;
                failed.extend(outcome.failed);
            }
            None => {
                let words = "the shard ended without a word: see its log";
                failed.extend(shard.lines.iter().map(|l| plan::Failed { line: *l, words: words.into() }));
            }
        }
    }
    failed.sort_by_key(|f| f.line);
    if args.json {
        let object = serde_json::json!({
            "lines": plan.lines(), "shards": plan.shards.len(), "published": published, "already": already,
            "failed": failed, "store": store.map(|s| s.display().to_string()), "as_of": plan.as_of,
        });
        super::write_out(&format!("{object}\n"));
    } else {
        for f in &failed {
            eprintln!("orb: {}:{}: {}", plan.manifest.display(), f.line, f.words);
        }
        let store = store.map(|s| format!("; store {}", s.display())).unwrap_or_default();
        super::write_out(&format!(
            "{} rows in {} shards: {published} published, {already} published already, {} failed{store}\n",
            plan.lines(),
            plan.shards.len(),
            failed.len()
        ));
    }
    Ok(if failed.is_empty() { 0 } else { Kind::Incomplete.exit_code() })
}
