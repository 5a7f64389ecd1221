//! `head.json`: where a ledger ended after the last append.

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::audit::canonical;
use crate::audit::checkpoint::{self, Checkpoint, Proof};
use crate::audit::disk::{self, Disk};
use crate::audit::dsse::{Envelope, MAX_ENVELOPE_BYTES};
use crate::audit::merkle::Frontier;
use crate::{Error, Result};

const SCHEMA: &str = "orb.head/v1";

/// The tree's right edge and the file's length, with the checkpoint that signs the tree's root.
#[derive(Debug)]
pub(super) struct Head {
    pub tree: Frontier,
    pub bytes: u64,
    checkpoint: Envelope,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Wire {
    schema: String,
    bytes: u64,
    peaks: Vec<String>,
    /// The envelope, as one line.
    checkpoint: String,
}

impl Head {
    pub fn of(tree: &Frontier, bytes: u64, proof: &Proof) -> HeadToSave {
        let peaks = tree.peaks().iter().map(hex::encode).collect();
        let checkpoint = proof.checkpoint_line().to_owned();
        HeadToSave(Wire { schema: SCHEMA.into(), bytes, peaks, checkpoint })
    }

    /// `None` where there is none yet.
    ///
    /// # Errors
    /// [`crate::Kind::Integrity`] when it is not what [`HeadToSave::save`] wrote: it is written whole or not at all.
    pub fn load(path: &Path) -> Result<Option<Head>> {
        if !path.exists() {
            return Ok(None);
        }
        let bytes = disk::read_limited(path, 2 * MAX_ENVELOPE_BYTES as u64)?;
        let head = read(&bytes).map_err(|found| {
            Error::integrity(path.display().to_string())
                .expected("the head of the ledger beside it")
                .found(found)
                .advice(
                    "The file was changed outside Orb, so nothing was published. Keep it for whoever looks into it, and \
                     move its folder away to begin a new ledger.",
                )
        })?;
        Ok(Some(head))
    }

    /// The signed checkpoint of the ledger's end.
    pub fn checkpoint(&self) -> &Envelope {
        &self.checkpoint
    }
}

/// The checkpoint of the `head.json` beside `ledger`, if it stands there and is one.
pub(in crate::audit) fn checkpoint_beside(ledger: &Path) -> Result<Option<Envelope>> {
    Ok(Head::load(&ledger.with_file_name("head.json"))?.map(|head| head.checkpoint().clone()))
}

pub(super) struct HeadToSave(Wire);

impl HeadToSave {
    /// Replaces the file, whole or not at all. The caller holds the ledger's lock.
    pub fn save(&self, path: &Path, disk: &Disk) -> Result<()> {
        let mut text = canonical::to_vec(&self.0).unwrap_or_default();
        text.push(b'\n');
        let draft = path.with_extension("json.new");
        // What a killed run left.
        let _ = std::fs::remove_file(&draft);
        disk.write_new(&draft, &text)?;
        disk.rename(&draft, path)?;
        path.parent().map_or(Ok(()), |folder| disk.sync_dir(folder))
    }
}

fn read(bytes: &[u8]) -> Result<Head, String> {
    let wire: Wire = serde_json::from_slice(bytes).map_err(|e| e.to_string())?;
    if wire.schema != SCHEMA {
        return Err(format!("schema {:?}", wire.schema));
    }
    let checkpoint = Envelope::parse(wire.checkpoint.as_bytes()).map_err(|f| f.detail().to_owned())?;
    let stated = Checkpoint::parse(&checkpoint).map_err(|f| f.detail().to_owned())?;
    let peaks: Option<Vec<_>> = wire.peaks.iter().map(|p| checkpoint::hash(p)).collect();
    let tree = peaks.and_then(|peaks| Frontier::from_parts(stated.size, peaks)).ok_or("peaks that fit no tree")?;
    if hex::encode(tree.root()) != stated.root {
        return Err("HEAD_FORK: peaks that do not lead to the signed root".into());
    }
    Ok(Head { tree, bytes: wire.bytes, checkpoint })
}
