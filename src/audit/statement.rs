//! The record's fields as they stand in the file: an in-toto Statement v1 with Orb's own predicate.
//!
//! Unknown fields are refused: what is not understood cannot be vouched for. What is absent is left out, never null.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use super::canonical::{self, Fault, Json};
use super::keys::SigningKey;
use super::marking::Marking;
use super::marking::authority::{Authority, Designation};
use super::marking::register::CountryRegister;
pub use super::marking::{Ism, Profile};
pub use super::program::{Crypto, Tool};
use super::time;
use super::time::{Source, SyncStatus, TimeReading};

/// in-toto Attestation Framework, Statement v1.
pub const STATEMENT_TYPE: &str = "https://in-toto.io/Statement/v1";
/// A name, not an address: `.invalid` belongs to nobody (RFC 2606), and nothing is ever fetched.
pub const PREDICATE_TYPE: &str = "https://orb.invalid/orb/audit-record/v1";
pub const SCHEMA: &str = "orb.audit/v1";
/// Of the records that this program writes. It reads those of every minor version: later ones only add fields.
pub const SCHEMA_MINOR: u32 = 6;
/// JSON Schema (draft 2020-12) of a record's payload.
pub const RECORD_SCHEMA: &str = include_str!("../../docs/record.schema.json");
/// `chain.prev` of a ledger's first record.
pub const GENESIS: &str = "0000000000000000000000000000000000000000000000000000000000000000";

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Statement {
    #[serde(rename = "_type")]
    pub statement_type: String,
    pub subject: Vec<Subject>,
    #[serde(rename = "predicateType")]
    pub predicate_type: String,
    pub predicate: Predicate,
}

/// One output.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Subject {
    /// Relative to the folder of the record, `/` between the parts; after `store:` relative to the root of a store
    /// that the run merged into.
    pub name: String,
    pub digest: Digests,
    pub annotations: Annotations,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Digests {
    pub sha256: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sha384: Option<String>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Annotations {
    pub media_type: String,
    pub role: String,
    /// Bytes, as decimal digits.
    pub size: String,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Predicate {
    pub schema: String,
    pub schema_minor: u32,
    pub event: Event,
    pub chain: Chain,
    pub time: Time,
    #[serde(rename = "where")]
    pub place: Place,
    pub actor: Actor,
    pub source: EventSource,
    pub inputs: Vec<Input>,
    pub models: Vec<Model>,
    pub params: BTreeMap<String, Param>,
    pub tool: Tool,
    pub crypto: Crypto,
    pub marking: MarkingBlock,
    /// How long the record is to be kept, in the words of who says so; since minor version 5.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub retention_hint: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub notes: Option<String>,
    /// SHA-256 of the canonical statement without this field.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub trail_hash: Option<String>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Event {
    /// UUID version 7 (RFC 9562 §5.7).
    pub id: String,
    #[serde(rename = "type")]
    pub kind: String,
    pub outcome: Outcome,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error_code: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    Success,
    Failure,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Chain {
    /// Sixteen hexadecimal digits, made from the first record's event and key.
    pub ledger_id: String,
    pub seq: u64,
    /// The predecessor's trail hash.
    pub prev: String,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Time {
    pub utc: String,
    pub source: Source,
    pub sync_status: SyncStatus,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub offset_us: Option<i64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_error_us: Option<i64>,
    /// Of the server that was asked; this and the following since minor version 4.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stratum: Option<u8>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reference: Option<String>,
    /// The kernel's random name of the machine's start. Never without `monotonic_ms`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub boot_id: Option<String>,
    /// Milliseconds since then, on a clock that nobody can set.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub monotonic_ms: Option<u64>,
}

impl Time {
    pub fn of(reading: &TimeReading) -> Time {
        let since_boot = reading.since_boot.as_ref();
        Time {
            utc: reading.utc(),
            source: reading.source,
            sync_status: reading.sync_status,
            offset_us: reading.offset_us,
            max_error_us: reading.max_error_us,
            stratum: reading.stratum,
            reference: reading.reference.clone(),
            boot_id: since_boot.map(|b| b.boot_id.clone()),
            monotonic_ms: since_boot.map(|b| b.milliseconds),
        }
    }

    fn check(&self) -> Result<(), String> {
        if time::parse_utc(&self.utc).is_none() {
            return Err(format!("time.utc {:?}: expected YYYY-MM-DDTHH:MM:SS.mmmZ", self.utc));
        }
        if let Some(n) = self.stratum.filter(|n| !(1..=15).contains(n)) {
            return Err(format!("time.stratum {n}: expected 1 to 15"));
        }
        match (&self.boot_id, self.monotonic_ms) {
            (None, None) => Ok(()),
            (Some(id), Some(_)) if time::is_boot_id(id) => Ok(()),
            (Some(id), Some(_)) => {
                Err(format!("time.boot_id {id:?}: expected lower-case hexadecimal digits as of a UUID"))
            }
            _ => Err("time.boot_id and time.monotonic_ms: expected both or neither".into()),
        }
    }
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Place {
    pub os: String,
    pub arch: String,
    /// Only where the user asked for it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hostname: Option<String>,
    /// SHA-256 that tells the machines of one ledger apart and says nothing else about them; since minor version 4.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub host_id: Option<String>,
    /// What runs the container, where it was in one; since minor version 4.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub container: Option<String>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Actor {
    pub operator_id: String,
    /// Who vouches for `operator_id`: `os-user` is the name that the operating system gave, no more; `pki` is the name in
    /// the signer's certificate.
    pub auth: String,
    /// The operator's name for people to read, as stated, where it was; nobody vouches for it; since minor version 5.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub display: Option<String>,
    /// What the operator acted as, as stated, where it was; nobody vouches for it; since minor version 5.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub role: Option<String>,
    pub key_fingerprint: String,
    pub algorithm: String,
    pub key_source: String,
    /// SHA-256 of the signer's certificate and of those between it and an authority; since minor version 2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cert_chain_sha256: Option<Vec<String>>,
    /// Who else signed, where one signature is not enough: all of theirs are required; since minor version 3.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub co_signers: Option<Vec<CoSigner>>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoSigner {
    pub key_fingerprint: String,
    pub algorithm: String,
}

impl CoSigner {
    pub fn of(key: &SigningKey) -> CoSigner {
        CoSigner { key_fingerprint: key.public().fingerprint().into(), algorithm: key.algorithm().name().into() }
    }
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EventSource {
    pub command: String,
    pub interface: String,
    /// The command line as it was understood; what it says in free words is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub argv_redacted: Option<Vec<String>>,
    /// The working folder as seen from the user's home folder, where it is below; since minor version 4.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cwd_rel: Option<String>,
    /// The same in every record of one call; since minor version 4.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub request_id: Option<String>,
}

impl EventSource {
    fn check(&self) -> Result<(), String> {
        // As a record's own system spells a root: `/x`, `\\x`, `C:x`.
        let is_absolute = |path: &str| path.starts_with(['/', '\\']) || path.get(1..2) == Some(":");
        if let Some(path) = self.cwd_rel.as_ref().filter(|path| is_absolute(path)) {
            return Err(format!("source.cwd_rel {path:?}: expected a relative path"));
        }
        match self.argv_redacted.iter().flatten().find(|word| is_absolute(word)) {
            Some(word) => Err(format!("source.argv_redacted {word:?}: expected no absolute path")),
            None => Ok(()),
        }
    }
}

/// Something that the run read.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Input {
    pub name: String,
    pub sha256: String,
    pub size: u64,
    pub media_type: String,
    pub role: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub marking: Option<String>,
}

/// A network or an algorithm of the run, pinned by its weights; a stage that did not run says `not-used` and nothing
/// else.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Model {
    pub id: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub status: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub version: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weights_sha256: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weights_size: Option<u64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub licence: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub runtime: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pin_source: Option<String>,
}

/// A parameter; fractions are written as decimal text, so that they have one spelling.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Param {
    Bool(bool),
    Int(i64),
    Text(String),
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MarkingBlock {
    pub profile: Profile,
    pub banner: String,
    pub ism: Ism,
    /// The join of the inputs' markings, where any of them is marked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inputs_join: Option<String>,
    /// Why the product is marked above its inputs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub raised_reason: Option<String>,
    /// Of classified work; since minor version 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub authority: Option<Authority>,
    /// Designation indicator block of CUI; since minor version 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cui_block: Option<Designation>,
    /// Country codes of the markings here that Orb does not list, and the digest of the operator's register that does; since
    /// minor version 6.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub country_register: Option<CountryRegister>,
}

impl Statement {
    /// Reads a payload: the strict form, the typed form, then the values.
    ///
    /// The second value is false when the bytes are not the canonical spelling.
    ///
    /// # Errors
    /// A [`Fault`] naming the first thing that is wrong.
    pub fn parse(payload: &[u8]) -> Result<(Statement, bool), Fault> {
        Statement::parse_and_hash(payload).map(|(statement, canonical, _)| (statement, canonical))
    }

    /// As [`Statement::parse`], and the trail hash that the payload should state.
    ///
    /// # Errors
    /// As [`Statement::parse`].
    pub fn parse_and_hash(payload: &[u8]) -> Result<(Statement, bool, String), Fault> {
        let mut json = canonical::parse(payload)?;
        let statement: Statement = serde_json::from_slice(payload).map_err(|error| Fault::Schema(error.to_string()))?;
        statement.check_values().map_err(Fault::Schema)?;
        let canonical = canonical::is_canonical(&json, payload);
        if canonical && let Some([before, after]) = around_trail_hash(payload) {
            return Ok((
                statement,
                canonical,
                hex::encode(Sha256::new().chain_update(before).chain_update(after).finalize()),
            ));
        }
        if let Json::Map(all) = &mut json
            && let Some(Json::Map(predicate)) = all.get_mut("predicate")
        {
            predicate.remove("trail_hash");
        }
        Ok((statement, canonical, canonical::sha256_hex(&json.to_bytes())))
    }

    /// The bytes that are signed.
    ///
    /// # Errors
    /// A [`Fault`] when a value cannot stand in a record.
    pub fn to_payload(&self) -> Result<Vec<u8>, Fault> {
        canonical::to_vec(self)
    }

    /// SHA-256 of the canonical statement without `predicate.trail_hash`, hexadecimal.
    ///
    /// # Errors
    /// As [`Statement::to_payload`].
    pub fn trail_hash(&self) -> Result<String, Fault> {
        let mut bare = self.clone();
        bare.predicate.trail_hash = None;
        Ok(canonical::sha256_hex(&bare.to_payload()?))
    }

    /// The marking of the product.
    pub fn marking(&self) -> Option<Marking> {
        Marking::read(&self.predicate.marking.banner).ok()
    }

    fn check_values(&self) -> Result<(), String> {
        let p = &self.predicate;
        same("_type", STATEMENT_TYPE, &self.statement_type)?;
        same("predicateType", PREDICATE_TYPE, &self.predicate_type)?;
        same("schema", SCHEMA, &p.schema)?;
        for subject in &self.subject {
            hex("subject.digest.sha256", &subject.digest.sha256, 64)?;
            if let Some(sha384) = &subject.digest.sha384 {
                hex("subject.digest.sha384", sha384, 96)?;
            }
            if subject.annotations.size.parse::<u64>().ok().map(|n| n.to_string()).as_ref()
                != Some(&subject.annotations.size)
            {
                return Err(format!("subject {:?}: size {:?}", subject.name, subject.annotations.size));
            }
        }
        let mut names: Vec<&str> = self.subject.iter().map(|s| s.name.as_str()).collect();
        names.sort_unstable();
        if let Some(pair) = names.windows(2).find(|w| w[0] == w[1]) {
            return Err(format!("subject {:?} stands twice", pair[0]));
        }
        hex("chain.ledger_id", &p.chain.ledger_id, 16)?;
        hex("chain.prev", &p.chain.prev, 64)?;
        hex("trail_hash", p.trail_hash.as_deref().unwrap_or_default(), 64)?;
        if let Some(register) = &p.marking.country_register {
            hex("marking.country_register.sha256", &register.sha256, 64)?;
            register.check()?;
        }
        for sha256 in p.actor.cert_chain_sha256.iter().flatten() {
            hex("actor.cert_chain_sha256", sha256, 64)?;
        }
        hex("actor.key_fingerprint", &p.actor.key_fingerprint, 64)?;
        for other in p.actor.co_signers.iter().flatten() {
            hex("actor.co_signers.key_fingerprint", &other.key_fingerprint, 64)?;
        }
        p.time.check()?;
        p.source.check()?;
        if let Some(host_id) = &p.place.host_id {
            hex("where.host_id", host_id, 64)?;
        }
        p.tool.check()?;
        p.crypto.check()?;
        for (name, words) in [
            ("where.hostname", &p.place.hostname),
            ("actor.display", &p.actor.display),
            ("actor.role", &p.actor.role),
            ("retention_hint", &p.retention_hint),
        ] {
            if words.as_ref().is_some_and(|w| w.len() > 256) {
                return Err(format!("{name}: at most 256 bytes"));
            }
        }
        for input in &p.inputs {
            hex("inputs.sha256", &input.sha256, 64)?;
        }
        for sha256 in p.models.iter().filter_map(|m| m.weights_sha256.as_deref()) {
            hex("models.weights_sha256", sha256, 64)?;
        }
        if p.notes.as_ref().is_some_and(|n| n.len() > 1024) {
            return Err("notes: at most 1024 bytes".into());
        }
        Ok(())
    }

    /// The value tree, for showing.
    ///
    /// # Errors
    /// As [`Statement::to_payload`].
    pub fn to_json(&self) -> Result<Json, Fault> {
        canonical::parse(&self.to_payload()?)
    }
}

/// The bytes of a canonical record before and after its trail hash: as they would be without it.
///
/// Quotes inside of text are escaped, so these bytes are a member's name wherever they stand; the predicate's stands last, as
/// nothing after it in the order of RFC 8785 has one of that name.
fn around_trail_hash(payload: &[u8]) -> Option<[&[u8]; 2]> {
    const NAME: &[u8] = br#","trail_hash":""#;
    let at = payload.windows(NAME.len()).rposition(|w| w == NAME)?;
    let after = at + NAME.len() + 64 + 1;
    Some([payload.get(..at)?, payload.get(after..)?])
}

fn same(field: &str, expected: &str, found: &str) -> Result<(), String> {
    if found == expected { Ok(()) } else { Err(format!("{field}: expected {expected:?}, found {found:?}")) }
}

pub(super) fn hex(field: &str, text: &str, digits: usize) -> Result<(), String> {
    if text.len() == digits && text.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b)) {
        Ok(())
    } else {
        Err(format!("{field}: expected {digits} lower-case hexadecimal digits, found {text:?}"))
    }
}
