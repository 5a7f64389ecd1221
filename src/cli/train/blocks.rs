//! `--blocks`: a large scene cut into blocks, and `--plan`: what a run takes.

use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use super::parts::{self, Standing};
use crate::cli::photos::{Set, line_of};
use crate::pipeline::scene::{self, Blocks};
use crate::splat::train::Kept;
use crate::{Error, Result};

#[derive(Clone, Debug, Default, clap::Args)]
pub struct BlocksArgs {
    /// Cut the ground into so many overlapping blocks, trained one after another from the photos that show them.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=10_000), help_heading = "Large scenes")]
    pub blocks: Option<u32>,
    /// Folder where the coarse scene and every block are kept, each in a folder of its own: a run that was stopped goes on from
    /// them, to the same bytes. Default: the output's name and .parts.
    #[arg(long, value_name = "DIR", requires = "blocks", help_heading = "Large scenes")]
    pub parts: Option<PathBuf>,
    /// Train this block alone, from 1, and the coarse scene where --parts has none yet, each with a record in its folder; nothing is
    /// published. On several machines: the coarse scene first, copied to each.
    #[arg(long, value_name = "I", requires = "blocks", value_parser = clap::value_parser!(u32).range(1..), help_heading = "Large scenes")]
    pub block: Option<u32>,
    /// Say what the run takes in memory, time and disk, and end.
    #[arg(long, help_heading = "Large scenes")]
    pub plan: bool,
}

impl BlocksArgs {
    /// Where the parts are kept.
    pub fn folder(&self, output: &Path) -> PathBuf {
        self.parts.clone().unwrap_or_else(|| {
            let mut name = output.file_name().unwrap_or_default().to_os_string();
            name.push(".parts");
            output.with_file_name(name)
        })
    }

    /// The parts that stand there before the run.
    ///
    /// # Errors
    /// As [`parts::standing`].
    pub fn standing(&self, output: &Path) -> Result<Vec<Standing>> {
        self.blocks.map_or(Ok(Vec::new()), |n| parts::standing(&self.folder(output), n as usize))
    }

    /// How the scene is cut, where it is.
    ///
    /// # Errors
    /// As [`Set::poses`]; usage for a checkpoint's options, which a run in blocks has no use for.
    pub fn open(
        &self,
        set: &Set,
        options: &scene::Options,
        held_out: &[bool],
        output: &Path,
    ) -> Result<Option<Blocks>> {
        let Some(count) = self.blocks else { return Ok(None) };
        if options.kept.file.is_some() || options.kept.from.is_some() {
            return Err(Error::usage("--checkpoint and --resume")
                .expected("a scene trained as a whole")
                .found("--blocks")
                .advice("A run in blocks keeps its checkpoints in --parts and goes on from there by itself."));
        }
        Ok(Some(Blocks {
            count: count as usize,
            folder: self.folder(output),
            only: self.block.map(|i| i as usize - 1),
            run: run(set, options, held_out, count)?,
        }))
    }
}

/// SHA-256 of what parts of one run have in common: photos, masks, poses, options.
fn run(set: &Set, options: &scene::Options, held_out: &[bool], count: u32) -> Result<String> {
    let mut all = Sha256::new();
    all.update(env!("CARGO_PKG_VERSION"));
    set.inputs().iter().for_each(|i| all.update(format!("{} {} {}\n", i.name, i.role, i.sha256)));
    set.poses()?.photos.iter().for_each(|p| all.update(line_of(p)));
    let options = scene::Options { kept: Kept::default(), ..options.clone() };
    all.update(format!("{options:?} {held_out:?} {count}"));
    Ok(hex::encode(all.finalize()))
}
