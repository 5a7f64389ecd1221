//! From what a run knows about itself to a signed record.

use std::collections::BTreeMap;

use super::canonical::{Fault, sha256_hex};
use super::dsse::{Envelope, PAYLOAD_TYPE};
use super::invocation::{Invocation, host_id};
use super::keys::SigningKey;
use super::marking::Marking;
use super::marking::handling::{Handling, check_not_below};
use super::statement::{
    Actor, Annotations, Chain, CoSigner, Crypto, Digests, Event, EventSource, Input, MarkingBlock, Model, Outcome,
    Param, Place, Predicate, STATEMENT_TYPE, Statement, Subject, Time, Tool,
};
use super::statement::{PREDICATE_TYPE, SCHEMA, SCHEMA_MINOR};
use super::time::TimeReading;
use super::trust::CertChain;
use crate::{Error, Result};

/// What the pipeline hands over: everything in a record that is not an output, a place in the chain, or the key.
#[derive(Clone, Debug)]
pub struct RecordDraft {
    /// `scene.generate`, `scene.export`, …
    pub event_type: String,
    pub time: TimeReading,
    /// Ten random bytes for the event's UUID.
    pub event_random: [u8; 10],
    pub invocation: Invocation,
    /// The verb: `orb geo`.
    pub command: String,
    pub inputs: Vec<Input>,
    pub models: Vec<Model>,
    pub params: BTreeMap<String, Param>,
    pub tool: Tool,
    pub handling: Handling,
    pub notes: Option<String>,
}

impl RecordDraft {
    /// Of something that happened without inputs and outputs.
    pub fn event(
        kind: &str,
        command: &str,
        invocation: Invocation,
        time: TimeReading,
        random: [u8; 10],
        handling: Handling,
    ) -> RecordDraft {
        RecordDraft {
            event_type: kind.into(),
            time,
            event_random: random,
            invocation,
            command: command.into(),
            inputs: Vec::new(),
            models: Vec::new(),
            params: BTreeMap::new(),
            tool: Tool::of_this_binary(),
            handling,
            notes: None,
        }
    }

    /// The join of the inputs' markings; `None` when no input carries one.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `MARKING_UNSUPPORTED`, for an input's marking that is not understood.
    pub fn inputs_join(&self) -> Result<Option<Marking>> {
        let mut join: Option<Marking> = None;
        for banner in self.inputs.iter().filter_map(|i| i.marking.as_deref()) {
            let level = Marking::read(banner)?;
            join = Some(join.map_or_else(|| level.clone(), |j| j.join(&level)));
        }
        Ok(join)
    }

    /// Refuses a product marked below what went into it. Cheap: call it before the work, not only after.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `MARKING_DOWNGRADE`.
    pub fn check_marking(&self) -> Result<()> {
        self.inputs_join()?.map_or(Ok(()), |join| check_not_below(&self.handling.marking, &join))
    }
}

/// A record at its place in the ledger.
#[derive(Clone, Debug)]
pub struct Sealed {
    pub statement: Statement,
    pub envelope: Envelope,
    pub trail_hash: String,
}

/// Where the next record stands: `None` begins a ledger.
pub type Next = Option<Chain>;

/// A record whose bytes stand, for one key to sign.
#[derive(Clone, Debug)]
pub struct Unsigned {
    pub statement: Statement,
    pub trail_hash: String,
    payload: Vec<u8>,
}

impl Unsigned {
    /// # Errors
    /// As [`SigningKey::sign`].
    pub fn sign(self, key: &SigningKey) -> Result<Sealed> {
        let signatures = key.signatures(&super::dsse::pae(PAYLOAD_TYPE, &self.payload))?;
        let envelope = Envelope { payload: self.payload, payload_type: PAYLOAD_TYPE.into(), signatures };
        Ok(Sealed { statement: self.statement, envelope, trail_hash: self.trail_hash })
    }
}

/// Builds the statement, its trail hash, and the signature over its canonical bytes.
///
/// # Errors
/// [`crate::Kind::Usage`] for a value that cannot stand in a record, [`crate::Kind::Policy`] for a lowered marking.
pub fn seal(
    draft: &RecordDraft,
    subject: Vec<Subject>,
    outcome: Outcome,
    error_code: Option<&str>,
    place: Next,
    key: &SigningKey,
) -> Result<Sealed> {
    compose(draft, subject, outcome, error_code, place, key)?.sign(key)
}

/// The record that `key` is to sign.
///
/// # Errors
/// As [`seal`].
pub fn compose(
    draft: &RecordDraft,
    subject: Vec<Subject>,
    outcome: Outcome,
    error_code: Option<&str>,
    place: Next,
    key: &SigningKey,
) -> Result<Unsigned> {
    draft.check_marking()?;
    let id = uuid_v7(draft.time.unix_ms, draft.event_random);
    let fingerprint = key.public().fingerprint().to_owned();
    let Handling { marking, profile, raised_reason, authority, designation, register } = draft.handling.clone();
    let chain = place.unwrap_or_else(|| Chain {
        ledger_id: ledger_id(&id, &fingerprint),
        seq: 0,
        prev: super::statement::GENESIS.to_owned(),
    });
    let by = &draft.invocation;
    let mut statement = Statement {
        statement_type: STATEMENT_TYPE.into(),
        subject,
        predicate_type: PREDICATE_TYPE.into(),
        predicate: Predicate {
            schema: SCHEMA.into(),
            schema_minor: SCHEMA_MINOR,
            event: Event { id, kind: draft.event_type.clone(), outcome, error_code: error_code.map(str::to_owned) },
            time: Time::of(&draft.time),
            place: Place {
                os: std::env::consts::OS.into(),
                arch: std::env::consts::ARCH.into(),
                hostname: by.hostname.clone(),
                host_id: by.machine_id.as_deref().map(|id| host_id(id, &chain.ledger_id)),
                container: by.container.clone(),
            },
            chain,
            actor: Actor {
                display: by.display.clone(),
                role: by.role.clone(),
                operator_id: key.chain().map_or_else(|| by.operator_id.clone(), |c| printable(c.operator())),
                auth: if key.chain().is_some() { "pki" } else { "os-user" }.into(),
                key_fingerprint: fingerprint.clone(),
                algorithm: key.algorithm().name().into(),
                key_source: key.source().name().into(),
                cert_chain_sha256: key.chain().map(CertChain::sha256),
                co_signers: key.partner().map(|other| vec![CoSigner::of(other)]),
            },
            source: EventSource {
                command: draft.command.clone(),
                interface: by.interface.name().into(),
                argv_redacted: by.argv_redacted.clone(),
                cwd_rel: by.cwd_rel.clone(),
                request_id: by.request_id.clone(),
            },
            inputs: draft.inputs.clone(),
            models: draft.models.clone(),
            params: draft.params.clone(),
            tool: draft.tool.clone(),
            crypto: Crypto::of_this_binary(),
            marking: MarkingBlock {
                profile,
                banner: marking.banner(),
                ism: marking.ism(),
                inputs_join: draft.inputs_join()?.map(|m| m.banner()),
                raised_reason,
                authority,
                cui_block: designation,
                country_register: register,
            },
            retention_hint: by.retention_hint.clone(),
            notes: draft.notes.clone(),
            trail_hash: None,
        },
    };
    let trail_hash = statement.trail_hash().map_err(|f| not_recordable(&f))?;
    statement.predicate.trail_hash = Some(trail_hash.clone());
    let payload = statement.to_payload().map_err(|f| not_recordable(&f))?;
    // The reader's own rules, so that no record is written that verification would refuse.
    Statement::parse(&payload).map_err(|f| not_recordable(&f))?;
    Ok(Unsigned { statement, trail_hash, payload })
}

/// A ledger's name, sixteen hexadecimal digits: made from its first event and the key that signed it.
pub fn ledger_id(event_id: &str, key_fingerprint: &str) -> String {
    sha256_hex(format!("orb.ledger/v1\n{event_id}\n{key_fingerprint}\n").as_bytes())[..16].to_owned()
}

fn not_recordable(fault: &Fault) -> Error {
    Error::usage("record")
        .expected("values that a record can hold")
        .found(format!("{}: {}", fault.code(), fault.detail()))
        .advice("Nothing was published.")
}

/// One input, hashed. `name` is the file's own name: folders tell about people, not about data.
pub fn input(name: &str, bytes: &[u8], media_type: &str, role: &str, marking: Option<Marking>) -> Input {
    Input {
        name: printable(name),
        sha256: sha256_hex(bytes),
        size: bytes.len() as u64,
        media_type: media_type.into(),
        role: role.into(),
        marking: marking.map(|m| m.banner()),
    }
}

/// A network that ran, pinned by the SHA-256 of its weights.
pub fn model(id: &str, version: &str, weights_sha256: &str, weights_size: u64, runtime: &str) -> Model {
    Model {
        id: id.into(),
        status: None,
        version: Some(version.into()),
        weights_sha256: Some(weights_sha256.into()),
        weights_size: Some(weights_size),
        licence: None,
        runtime: Some(runtime.into()),
        pin_source: Some("built-in".into()),
    }
}

/// A stage that this run did without.
pub fn model_not_used(id: &str) -> Model {
    Model {
        id: id.into(),
        status: Some("not-used".into()),
        version: None,
        weights_sha256: None,
        weights_size: None,
        licence: None,
        runtime: None,
        pin_source: None,
    }
}

/// Control characters, which a record cannot hold, replaced.
pub fn printable(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect()
}

/// One output as the record lists it.
pub fn subject(name: String, sha256: String, size: u64, media_type: &str, role: &str) -> Subject {
    Subject {
        name,
        digest: Digests { sha256, sha384: None },
        annotations: Annotations { media_type: media_type.into(), role: role.into(), size: size.to_string() },
    }
}

/// UUID version 7, RFC 9562 §5.7: 48 bits of milliseconds, then 74 random bits around version and variant.
pub fn uuid_v7(unix_ms: u64, random: [u8; 10]) -> String {
    let mut b = [0; 16];
    b[..6].copy_from_slice(&unix_ms.to_be_bytes()[2..]);
    b[6..].copy_from_slice(&random);
    uuid(b, 7)
}

/// The bytes as a UUID of a version (RFC 9562 §4): six of their bits give way to version and variant.
pub(super) fn uuid(mut b: [u8; 16], version: u8) -> String {
    b[6] = version << 4 | (b[6] & 0x0f);
    b[8] = 0x80 | (b[8] & 0x3f);
    let h = hex::encode(b);
    format!("{}-{}-{}-{}-{}", &h[..8], &h[8..12], &h[12..16], &h[16..20], &h[20..])
}

#[cfg(test)]
pub(crate) mod tests;
