//! Checkpoints: a signed statement of how long a ledger was and what stood in it. Kept elsewhere, one shows later that
//! no record up to it was cut off, changed or exchanged; a ledger alone cannot show that about its own end.

use serde::{Deserialize, Serialize};

use super::canonical::{self, Fault};
use super::dsse::{self, Envelope};
use super::keys::SigningKey;
use super::merkle::{self, Frontier, Hash};
use super::record::Sealed;
use super::time;
use crate::{Error, Result};

/// The payload type of a checkpoint's envelope: a checkpoint can never be taken for a record.
pub const PAYLOAD_TYPE: &str = "application/vnd.orb.checkpoint+json";
const SCHEMA: &str = "orb.checkpoint/v1";
const PROOF_SCHEMA: &str = "orb.proof/v1";

/// What a ledger was at one moment.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Checkpoint {
    pub schema: String,
    pub ledger_id: String,
    /// Number of records.
    pub size: u64,
    /// Root of the Merkle tree over their trail hashes, hexadecimal.
    pub root: String,
    /// The last record's trail hash, for comparing by eye.
    pub head: String,
    /// The last record's time, `YYYY-MM-DDTHH:MM:SS.mmmZ`.
    pub utc: String,
}

impl Checkpoint {
    /// The checkpoint of the tree that ends in `last`.
    pub fn of(tree: &Frontier, last: &super::statement::Statement) -> Checkpoint {
        Checkpoint {
            schema: SCHEMA.into(),
            ledger_id: last.predicate.chain.ledger_id.clone(),
            size: tree.size(),
            root: hex::encode(tree.root()),
            head: last.predicate.trail_hash.clone().unwrap_or_default(),
            utc: last.predicate.time.utc.clone(),
        }
    }

    /// # Errors
    /// [`crate::Kind::Environment`] when the key cannot sign.
    pub fn sign(&self, key: &SigningKey) -> Result<Envelope> {
        let payload = canonical::to_vec(self).map_err(|f| Error::usage("checkpoint").found(f.detail().to_owned()))?;
        let signatures = key.signatures(&dsse::pae(PAYLOAD_TYPE, &payload))?;
        Ok(Envelope { payload, payload_type: PAYLOAD_TYPE.into(), signatures })
    }

    /// Reads an envelope's payload; the signature is the caller's to check.
    ///
    /// # Errors
    /// A [`Fault`] naming what is wrong.
    pub fn parse(envelope: &Envelope) -> Result<Checkpoint, Fault> {
        if envelope.payload_type != PAYLOAD_TYPE {
            return Err(Fault::Schema(format!("payload type {:?}, expected {PAYLOAD_TYPE:?}", envelope.payload_type)));
        }
        let json = canonical::parse(&envelope.payload)?;
        let read: Checkpoint = serde_json::from_slice(&envelope.payload).map_err(|e| Fault::Schema(e.to_string()))?;
        if !canonical::is_canonical(&json, &envelope.payload) {
            return Err(Fault::Schema("not the one spelling of this checkpoint".into()));
        }
        if read.schema != SCHEMA {
            return Err(Fault::Schema(format!("schema {:?}, expected {SCHEMA:?}", read.schema)));
        }
        if read.size == 0 || hash(&read.root).is_none() || hash(&read.head).is_none() {
            return Err(Fault::Schema("size, root or head is no checkpoint's".into()));
        }
        if time::parse_utc(&read.utc).is_none() {
            return Err(Fault::Schema(format!("utc {:?}", read.utc)));
        }
        Ok(read)
    }
}

/// That a record stands in a ledger: its place, the nodes beside its way to the root, and the signed root.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Proof {
    schema: String,
    pub index: u64,
    path: Vec<String>,
    checkpoint: String,
}

impl Proof {
    /// The proof of `sealed`, the record that follows those of `before`.
    ///
    /// # Errors
    /// As [`Checkpoint::sign`]; [`crate::Kind::Usage`] when the record carries no trail hash.
    pub fn of_next(before: &Frontier, sealed: &Sealed, key: &SigningKey) -> Result<Proof> {
        let mut tree = before.clone();
        tree.push(record_leaf(&sealed.trail_hash).ok_or_else(|| Error::usage("record").expected("a trail hash"))?);
        let checkpoint = Checkpoint::of(&tree, &sealed.statement).sign(key)?;
        Ok(Proof {
            schema: PROOF_SCHEMA.into(),
            index: before.size(),
            path: before.path_of_next().iter().map(hex::encode).collect(),
            checkpoint: String::from_utf8(checkpoint.to_line()).unwrap_or_default().trim_end().to_owned(),
        })
    }

    /// One line of canonical JSON with a line feed.
    pub fn to_line(&self) -> Vec<u8> {
        // Strings and one integer always serialise.
        let mut line = canonical::to_vec(self).unwrap_or_default();
        line.push(b'\n');
        line
    }

    /// # Errors
    /// A [`Fault`] naming what is wrong.
    pub fn parse(bytes: &[u8]) -> Result<Proof, Fault> {
        let proof: Proof = serde_json::from_slice(bytes).map_err(|e| Fault::Schema(e.to_string()))?;
        if proof.schema != PROOF_SCHEMA || proof.path.len() > 64 || proof.to_line() != bytes {
            return Err(Fault::Schema("not the one spelling of a proof of version 1".into()));
        }
        Ok(proof)
    }

    /// The checkpoint's envelope as one line.
    pub(super) fn checkpoint_line(&self) -> &str {
        &self.checkpoint
    }

    /// The checkpoint's envelope.
    ///
    /// # Errors
    /// A [`Fault`] when it is none.
    pub fn envelope(&self) -> Result<Envelope, Fault> {
        Envelope::parse(self.checkpoint.as_bytes())
    }

    /// The root that the path leads to from a record with this trail hash, in a tree of `size` records.
    pub fn root(&self, trail_hash: &str, size: u64) -> Option<Hash> {
        let path: Vec<Hash> = self.path.iter().map(|p| hash(p)).collect::<Option<_>>()?;
        merkle::root_from_path(record_leaf(trail_hash)?, self.index, size, &path)
    }
}

/// A record's leaf: over the 32 bytes of its trail hash.
pub fn record_leaf(trail_hash: &str) -> Option<Hash> {
    hash(trail_hash).map(|h| merkle::leaf(&h))
}

/// 64 lower-case hexadecimal digits.
pub fn hash(text: &str) -> Option<Hash> {
    let canonical = text.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b));
    let bytes = canonical.then(|| hex::decode(text).ok()).flatten()?;
    bytes.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::keys::Algorithm;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::record::{self, tests::draft};
    use crate::audit::statement::Outcome;

    fn sealed() -> Sealed {
        record::seal(&draft(), Vec::new(), Outcome::Success, None, None, shared_key()).unwrap()
    }

    #[test]
    fn a_proof_leads_to_the_signed_root() {
        let mut before = Frontier::default();
        let sealed = sealed();
        for n in 0..9u8 {
            let proof = Proof::of_next(&before, &sealed, shared_key()).unwrap();
            assert_eq!(Proof::parse(&proof.to_line()).unwrap(), proof);
            let envelope = proof.envelope().unwrap();
            let checkpoint = Checkpoint::parse(&envelope).unwrap();
            assert_eq!((checkpoint.size, proof.index), (u64::from(n) + 1, u64::from(n)));
            assert_eq!(
                shared_key().public().verify(&envelope.pae(), &envelope.signatures[0].sig),
                Ok(Some(Algorithm::Rs256))
            );
            let root = proof.root(&sealed.trail_hash, checkpoint.size).unwrap();
            assert_eq!(hex::encode(root), checkpoint.root);
            let other = proof.root(&"0".repeat(64), checkpoint.size).unwrap();
            assert_ne!(hex::encode(other), checkpoint.root);
            before.push(merkle::leaf(&[n]));
        }
    }

    #[test]
    fn loose_checkpoints_and_proofs_are_refused() {
        let proof = Proof::of_next(&Frontier::default(), &sealed(), shared_key()).unwrap();
        let line = String::from_utf8(proof.to_line()).unwrap();
        for (from, to) in
            [("\"index\":0", "\"index\": 0"), ("/v1", "/v2"), ("{\"checkpoint\"", "{\"a\":1,\"checkpoint\"")]
        {
            assert!(line.contains(from));
            assert!(Proof::parse(line.replacen(from, to, 1).as_bytes()).is_err(), "{to}");
        }
        let good = proof.envelope().unwrap();
        let payload = String::from_utf8(good.payload.clone()).unwrap();
        for (from, to) in
            [("\"size\":1", "\"size\":0"), ("\"size\":1", "\"size\":1,\"x\":1"), ("\"head\":\"", "\"head\":\"A")]
        {
            assert!(payload.contains(from));
            let bad = Envelope { payload: payload.replacen(from, to, 1).into_bytes(), ..good.clone() };
            assert_eq!(Checkpoint::parse(&bad).unwrap_err().code(), "SCHEMA_INVALID", "{to}");
        }
        // A record's envelope is no checkpoint.
        assert!(Checkpoint::parse(&sealed().envelope).is_err());
    }
}
