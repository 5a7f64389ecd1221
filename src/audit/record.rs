//! From what a run knows about itself to a signed record.

use std::collections::BTreeMap;

use super::canonical::{Fault, sha256_hex};
use super::dsse::{Envelope, PAYLOAD_TYPE, Signature};
use super::keys::SigningKey;
use super::marking::Marking;
use super::marking::handling::{Handling, check_not_below};
use super::statement::{
    Actor, Annotations, Chain, Crypto, Digests, Event, EventSource, Input, MarkingBlock, Model, Outcome, Param, Place,
    Predicate, STATEMENT_TYPE, Statement, Subject, Time, Tool,
};
use super::statement::{PREDICATE_TYPE, SCHEMA};
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
    /// The operating system's name of the user; see [`operator_from`].
    pub operator_id: String,
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
    /// Of something that happened without inputs and outputs, by this program for this user.
    pub fn event(kind: &str, command: &str, time: TimeReading, random: [u8; 10], handling: Handling) -> RecordDraft {
        RecordDraft {
            event_type: kind.into(),
            time,
            event_random: random,
            operator_id: operator_from(|name| std::env::var(name).ok()),
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
            let level = Marking::parse(banner)?;
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
        let sig = key.sign(&super::dsse::pae(PAYLOAD_TYPE, &self.payload))?;
        let envelope = Envelope {
            payload: self.payload,
            payload_type: PAYLOAD_TYPE.into(),
            signatures: vec![Signature { keyid: key.public().fingerprint().to_owned(), sig }],
        };
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
    let Handling { marking, profile, raised_reason, authority, designation } = draft.handling.clone();
    let chain = place.unwrap_or_else(|| Chain {
        ledger_id: ledger_id(&id, &fingerprint),
        seq: 0,
        prev: super::statement::GENESIS.to_owned(),
    });
    let mut statement = Statement {
        statement_type: STATEMENT_TYPE.into(),
        subject,
        predicate_type: PREDICATE_TYPE.into(),
        predicate: Predicate {
            schema: SCHEMA.into(),
            schema_minor: match () {
                () if key.chain().is_some() || draft.tool.sbom_sha256.is_some() => 2,
                () => u32::from(authority.is_some() || designation.is_some()),
            },
            event: Event { id, kind: draft.event_type.clone(), outcome, error_code: error_code.map(str::to_owned) },
            chain,
            time: Time {
                utc: draft.time.utc(),
                source: draft.time.source,
                sync_status: draft.time.sync_status,
                offset_us: draft.time.offset_us,
                max_error_us: draft.time.max_error_us,
            },
            place: Place { os: std::env::consts::OS.into(), arch: std::env::consts::ARCH.into(), hostname: None },
            actor: Actor {
                operator_id: key.chain().map_or_else(|| draft.operator_id.clone(), |c| printable(c.operator())),
                auth: if key.chain().is_some() { "pki" } else { "os-user" }.into(),
                key_fingerprint: fingerprint.clone(),
                algorithm: key.algorithm().name().into(),
                key_source: key.source().name().into(),
                cert_chain_sha256: key.chain().map(CertChain::sha256),
            },
            source: EventSource { command: draft.command.clone(), interface: "cli".into(), argv_redacted: None },
            inputs: draft.inputs.clone(),
            models: draft.models.clone(),
            params: draft.params.clone(),
            tool: draft.tool.clone(),
            crypto: Crypto {
                provider: "aws-lc-rs".into(),
                provider_version: format!("AWS-LC {}", aws_lc_rs::awslc_version()),
                fips_mode: aws_lc_rs::try_fips_mode().is_ok(),
            },
            marking: MarkingBlock {
                profile,
                banner: marking.banner(),
                ism: marking.ism(),
                inputs_join: draft.inputs_join()?.map(|m| m.banner()),
                raised_reason,
                authority,
                cui_block: designation,
            },
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

/// The user's name as the environment gives it; `unknown` when it does not.
pub fn operator_from(var: impl Fn(&str) -> Option<String>) -> String {
    let name = ["USER", "LOGNAME", "USERNAME"].into_iter().find_map(|n| var(n).filter(|v| !v.trim().is_empty()));
    printable(name.as_deref().unwrap_or("unknown"))
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
    b[6] = 0x70 | (b[6] & 0x0f);
    b[8] = 0x80 | (b[8] & 0x3f);
    let h = hex::encode(b);
    format!("{}-{}-{}-{}-{}", &h[..8], &h[8..12], &h[12..16], &h[16..20], &h[20..])
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::Kind;
    use crate::audit::keys::Algorithm;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::time::{Source, SyncStatus};

    pub(crate) fn draft() -> RecordDraft {
        RecordDraft {
            event_type: "scene.generate".into(),
            time: TimeReading {
                unix_ms: 1_763_688_582_120,
                source: Source::Kernel,
                sync_status: SyncStatus::Synchronised,
                offset_us: Some(-310),
                max_error_us: Some(1900),
            },
            event_random: [0xcd; 10],
            operator_id: "jane".into(),
            command: "orb geo".into(),
            inputs: vec![input("van.jpg", b"photo", "image/jpeg", "photo", None)],
            models: vec![model("scene", "1", &sha256_hex(b"w"), 1, "rten"), model_not_used("colmap")],
            params: BTreeMap::from([
                ("seed".into(), Param::Int(7)),
                ("scale_m".into(), Param::Text("1.25".into())),
                ("refined".into(), Param::Bool(true)),
            ]),
            tool: Tool { name: "orb".into(), version: "0.1.0".into(), ..Tool::default() },
            handling: Marking::UNCLASSIFIED.into(),
            notes: None,
        }
    }

    fn subjects() -> Vec<Subject> {
        vec![subject("scene.ply".into(), sha256_hex(b"ply"), 3, "application/octet-stream", "splats")]
    }

    fn sealed(draft: &RecordDraft) -> Result<Sealed> {
        seal(draft, subjects(), Outcome::Success, None, None, shared_key())
    }

    #[test]
    fn a_sealed_record_reads_back() {
        let sealed = sealed(&draft()).unwrap();
        let (statement, canonical) = Statement::parse(&sealed.envelope.payload).unwrap();
        assert!(canonical);
        assert_eq!(statement, sealed.statement);
        assert_eq!(statement.trail_hash().unwrap(), sealed.trail_hash);
        assert_eq!(statement.predicate.chain.prev, "0".repeat(64));
        assert_eq!(statement.predicate.chain.seq, 0);
        assert_eq!(statement.predicate.crypto.fips_mode, cfg!(feature = "fips"));
        let sig = &sealed.envelope.signatures[0];
        assert_eq!(sig.keyid, shared_key().public().fingerprint());
        assert_eq!(shared_key().public().verify(&sealed.envelope.pae(), &sig.sig), Ok(Some(Algorithm::Rs256)));
        let text = String::from_utf8(sealed.envelope.payload.clone()).unwrap();
        for part in [
            r#""_type":"https://in-toto.io/Statement/v1""#,
            r#""utc":"2025-11-21T01:29:42.120Z""#,
            r#""sync_status":"synchronised""#,
            r#"{"id":"colmap","status":"not-used"}"#,
            r#""params":{"refined":true,"scale_m":"1.25","seed":7}"#,
            r#""where":{"arch""#,
        ] {
            assert!(text.contains(part), "{part} in {text}");
        }
        assert!(!text.contains("null"));
    }

    /// The words of JSON Schema that say which members there are and of what type; patterns are for
    /// `tests/clients/check_sidecars.py`.
    fn fits(schema: &serde_json::Value, value: &serde_json::Value) -> bool {
        use serde_json::Value;
        let is_type = |name: &str| match name {
            "object" => value.is_object(),
            "array" => value.is_array(),
            "string" => value.is_string(),
            "integer" => value.is_i64() || value.is_u64(),
            "boolean" => value.is_boolean(),
            other => panic!("type {other}"),
        };
        let properties = schema["properties"].as_object();
        let members_fit = |(name, member): (&String, &Value)| match properties.and_then(|p| p.get(name)) {
            Some(known) => fits(known, member),
            None => match &schema["additionalProperties"] {
                Value::Object(_) => fits(&schema["additionalProperties"], member),
                other => *other != Value::Bool(false),
            },
        };
        schema["type"].as_str().is_none_or(is_type)
            && schema.get("const").is_none_or(|c| c == value)
            && schema["enum"].as_array().is_none_or(|all| all.contains(value))
            && schema["anyOf"].as_array().is_none_or(|all| all.iter().any(|s| fits(s, value)))
            && schema["required"].as_array().is_none_or(|all| all.iter().all(|n| !value[n.as_str().unwrap()].is_null()))
            && value.as_object().is_none_or(|o| o.iter().all(members_fit))
            && value.as_array().is_none_or(|a| a.iter().all(|v| fits(&schema["items"], v)))
    }

    /// What Orb writes is valid by the published schema, what the strict reader refuses is not.
    #[test]
    fn records_follow_the_published_schema() {
        use crate::audit::marking::authority::Authority;
        let schema: serde_json::Value = serde_json::from_str(crate::audit::statement::RECORD_SCHEMA).unwrap();
        let value = |d: &RecordDraft| -> serde_json::Value {
            serde_json::from_slice(&sealed(d).unwrap().envelope.payload).unwrap()
        };
        let mut full = draft();
        full.notes = Some("a note".into());
        full.inputs[0].marking = Some("SECRET//REL TO USA, GBR".into());
        full.handling = Handling {
            authority: Some(Authority {
                classified_by: "J. Doe, analyst".into(),
                derived_from: "Multiple Sources".into(),
                declassify_on: "20400101".into(),
                date_of_origin: "20261121".into(),
                sources: vec!["A".into(), "B".into()],
            }),
            raised_reason: Some("compilation".into()),
            ..Marking::parse("TOP SECRET//ORCON/REL TO USA, GBR//LIMDIS").unwrap().into()
        };
        for d in [draft(), full.clone()] {
            assert!(fits(&schema, &value(&d)));
        }
        let changes: [fn(&mut serde_json::Value); 9] = [
            |v| v["extra"] = 1.into(),
            |v| v["predicate"]["extra"] = 1.into(),
            |v| v["predicate"]["marking"]["authority"]["reason"] = "1.4(c)".into(),
            |v| v["predicate"]["params"]["seed"] = 7.5.into(),
            |v| v["predicate"]["params"]["seed"] = serde_json::Value::Null,
            |v| v["predicate"]["chain"]["seq"] = "0".into(),
            |v| v["predicate"]["event"]["outcome"] = "maybe".into(),
            |v| v["predicate"]["schema"] = "orb.audit/v2".into(),
            |v| drop(v["predicate"].as_object_mut().unwrap().remove("marking")),
        ];
        for (i, change) in changes.iter().enumerate() {
            let mut v = value(&full);
            change(&mut v);
            assert!(!fits(&schema, &v), "change {i}");
            let bytes = crate::audit::canonical::to_vec(&v).unwrap_or_else(|_| v.to_string().into_bytes());
            assert!(Statement::parse(&bytes).is_err(), "change {i}");
        }
    }

    #[test]
    fn the_same_run_gives_the_same_record() {
        let (a, b) = (sealed(&draft()).unwrap(), sealed(&draft()).unwrap());
        assert_eq!(a.envelope.to_line(), b.envelope.to_line());
    }

    #[test]
    fn the_trail_hash_follows_its_rule_outside_this_code() {
        let sealed = sealed(&draft()).unwrap();
        let mut value: serde_json::Value = serde_json::from_slice(&sealed.envelope.payload).unwrap();
        value["predicate"].as_object_mut().unwrap().remove("trail_hash");
        // Without fractions and with ASCII keys, serde_json's own compact form with sorted keys is canonical.
        assert_eq!(sha256_hex(value.to_string().as_bytes()), sealed.trail_hash);
    }

    #[test]
    fn a_product_is_not_marked_below_its_inputs() {
        let mut d = draft();
        d.inputs[0].marking = Some("CUI".into());
        let error = sealed(&d).unwrap_err();
        assert_eq!(error.kind, Kind::Policy);
        assert!(error.found.contains("MARKING_DOWNGRADE"));
        d.handling.marking = Marking::SECRET;
        let s = sealed(&d).unwrap();
        assert_eq!(s.statement.predicate.marking.inputs_join.as_deref(), Some("CUI"));
        assert_eq!(s.statement.predicate.marking.ism.classification, "S");
        d.inputs[0].marking = Some("COSMIC TOP SECRET".into());
        assert!(sealed(&d).unwrap_err().found.contains("MARKING_UNSUPPORTED"));
    }

    #[test]
    fn values_that_a_record_cannot_hold() {
        let mut d = draft();
        d.params.insert("big".into(), Param::Int(1 << 53));
        assert_eq!(sealed(&d).unwrap_err().kind, Kind::Usage);
        let mut d = draft();
        d.notes = Some("x".repeat(1025));
        assert_eq!(sealed(&d).unwrap_err().kind, Kind::Usage);
        let mut d = draft();
        d.notes = Some("two\nlines".into());
        assert_eq!(sealed(&d).unwrap_err().kind, Kind::Usage);
        assert_eq!(input("a\nb.jpg", b"", "", "", None).name, "a\u{fffd}b.jpg");
    }

    #[test]
    fn unknown_and_repeated_fields_are_refused() {
        let payload = String::from_utf8(sealed(&draft()).unwrap().envelope.payload).unwrap();
        for (from, to) in [
            ("\"schema\":", "\"aaa\":1,\"schema\":"),
            ("\"seed\":7", "\"seed\":7,\"seed\":8"),
            ("\"seed\":7", "\"seed\":7.0"),
            ("\"seed\":7", "\"seed\":null"),
            ("\"schema_minor\":0", "\"schema_minor\":-1"),
            ("\"outcome\":\"success\"", "\"outcome\":\"maybe\""),
            ("\"seq\":0", "\"seq\":\"0\""),
            ("T01:29:42.120Z", "T01:29:42Z"),
            ("orb.audit/v1", "orb.audit/v2"),
            ("\"size\":\"3\"", "\"size\":\"03\""),
        ] {
            assert!(payload.contains(from), "{from}");
            let changed = payload.replacen(from, to, 1);
            assert_eq!(Statement::parse(changed.as_bytes()).unwrap_err().code(), "SCHEMA_INVALID", "{to}");
        }
    }

    /// The example of RFC 9562, appendix A.6: 2022-02-22T19:22:22Z.
    #[test]
    fn published_uuid_v7() {
        let random = [0x0c, 0xc3, 0x18, 0xc4, 0xdc, 0x0c, 0x0c, 0x07, 0x39, 0x8f];
        assert_eq!(uuid_v7(0x017F_22E2_79B0, random), "017f22e2-79b0-7cc3-98c4-dc0c0c07398f");
    }

    #[test]
    fn who_ran_it() {
        assert_eq!(operator_from(|n| (n == "LOGNAME").then(|| "jane".into())), "jane");
        assert_eq!(operator_from(|_| None), "unknown");
    }
}
