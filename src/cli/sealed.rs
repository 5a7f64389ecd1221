//! What every verb that publishes does alike: key, staging folder, record, ledger.

use std::collections::BTreeMap;
use std::path::Path;

use super::argv;
use super::key::KeyArgs;
use super::marking::MarkingArgs;
use crate::audit::marking::handling::Handling;
use crate::audit::statement::{Input, Model, Param};
use crate::audit::{DataFolder, Destination, Ledger, Publication, Published, RecordDraft, SigningKey};
use crate::audit::{TimeReading, events, time};
use crate::{Error, Result};

/// What every verb that publishes can be told.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct PublishArgs {
    /// Replace a folder that Orb published earlier.
    #[arg(long)]
    pub replace: bool,
    #[command(flatten)]
    pub marking: MarkingArgs,
    #[command(flatten)]
    pub key: KeyArgs,
    /// No progress, no summary.
    #[arg(short, long)]
    pub quiet: bool,
}

/// A run that may publish, from its first check to its seal. Dropped before that, nothing of it remains.
pub struct SealedRun {
    command: &'static str,
    data: DataFolder,
    key: SigningKey,
    handling: Handling,
    event_random: [u8; 10],
    ntp_server: Option<String>,
    pub publication: Publication,
}

/// What the run did.
pub struct Evidence {
    pub event_type: &'static str,
    pub time: TimeReading,
    pub inputs: Vec<Input>,
    pub models: Vec<Model>,
    pub params: BTreeMap<String, Param>,
}

impl SealedRun {
    /// Finds or makes the key for `command`, checks the output folder, begins to stage. Call it before any work.
    ///
    /// # Errors
    /// As [`events::key_for_run`] and [`Publication::begin`].
    pub fn begin(command: &'static str, folder: &Path, handling: Handling, args: &PublishArgs) -> Result<SealedRun> {
        let data = DataFolder::from_environment(|name| std::env::var_os(name))?;
        SealedRun::begin_in(data, command, folder, handling, args)
    }

    /// As [`SealedRun::begin`], in place of a folder that the run itself works in: see [`Publication::begin_over`].
    ///
    /// # Errors
    /// As [`SealedRun::begin`].
    pub fn begin_over(
        command: &'static str,
        folder: &Path,
        own: &[&str],
        handling: Handling,
        args: &PublishArgs,
    ) -> Result<SealedRun> {
        let data = DataFolder::from_environment(|name| std::env::var_os(name))?;
        SealedRun::staged(data, command, folder, handling, args, own)
    }

    /// As [`SealedRun::begin`], with the user's data folder.
    ///
    /// # Errors
    /// As [`SealedRun::begin`].
    pub fn begin_in(
        data: DataFolder,
        command: &'static str,
        folder: &Path,
        handling: Handling,
        args: &PublishArgs,
    ) -> Result<SealedRun> {
        SealedRun::staged(data, command, folder, handling, args, &[])
    }

    fn staged(
        data: DataFolder,
        command: &'static str,
        folder: &Path,
        handling: Handling,
        args: &PublishArgs,
        own: &[&str],
    ) -> Result<SealedRun> {
        let ntp_server = args.key.ntp_server.clone();
        let key = events::key_for_run(&data, command, &argv::caller(), &handling.marking, args.key.named())?;
        if let Some(warning) = &key.warning {
            eprintln!("orb: warning: {warning}");
        }
        if key.created && !args.quiet {
            let fingerprint = key.key.public().fingerprint();
            eprintln!("orb: made a signing key in {}, fingerprint {fingerprint}", data.path().display());
        }
        let random = |bytes: &mut [u8]| {
            getrandom::fill(bytes).map_err(|e| Error::environment("random numbers").found(e.to_string()))
        };
        let (mut event_random, mut nonce) = ([0; 10], [0; 8]);
        random(&mut event_random)?;
        random(&mut nonce)?;
        let nonce = u64::from_le_bytes(nonce);
        let destination =
            Destination { folder: folder.to_owned(), replace: args.replace, handling: handling.clone(), nonce };
        let publication = Publication::begin_over(&destination, own)?;
        Ok(SealedRun { command, data, key: key.key, handling, event_random, ntp_server, publication })
    }

    /// Signs, appends to the ledger, publishes.
    ///
    /// # Errors
    /// As [`Publication::seal`].
    pub fn seal(self, evidence: Evidence) -> Result<Published> {
        let Evidence { event_type, time, inputs, models, params } = evidence;
        let time = match &self.ntp_server {
            None => time,
            // Asked now, for when the record is made; the run began a while ago.
            Some(server) => time::ask_server(server, time::now()?)?,
        };
        let draft = RecordDraft {
            inputs,
            models,
            params,
            ..RecordDraft::event(event_type, self.command, argv::caller(), time, self.event_random, self.handling)
        };
        let mut ledger = Ledger::open(&self.data)?;
        self.publication.seal(&draft, &self.key, &mut ledger)
    }
}
