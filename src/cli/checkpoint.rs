//! `--checkpoint` and `--resume`: an optimisation that can be stopped and taken up again.

use std::path::PathBuf;
use std::sync::Arc;

use crate::Result;
use crate::splat::train::{Every, Kept, Saved};

#[derive(Clone, Debug, Default, clap::Args)]
pub struct CheckpointArgs {
    /// Keep the optimisation in this file, again and again, at its end and when Ctrl-C stops it.
    #[arg(long, value_name = "FILE")]
    pub checkpoint: Option<PathBuf>,
    /// Steps between two checkpoints. Default: as many as take about a minute.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub checkpoint_every: Option<u32>,
    /// Go on from a checkpoint of the same run: the result is the same to the byte. Kept in the same file unless
    /// --checkpoint names another.
    #[arg(long, value_name = "FILE")]
    pub resume: Option<PathBuf>,
}

impl CheckpointArgs {
    /// Reads what is to be gone on from.
    ///
    /// Errors: the file cannot be read, is no checkpoint, or is damaged.
    pub fn open(&self) -> Result<Kept> {
        Ok(Kept {
            file: self.checkpoint.clone().or_else(|| self.resume.clone()),
            every: self.checkpoint_every.map_or(Every::default(), |n| Every::Iterations(n as usize)),
            from: self.resume.as_deref().map(Saved::read).transpose()?.map(Arc::new),
            ..Kept::default()
        })
    }
}
