use super::*;
use crate::Kind;
use crate::audit::canonical;
use crate::audit::keys::Algorithm;
use crate::audit::keys::tests::shared_key;
use crate::audit::time::{SinceBoot, Source, SyncStatus};

const MACHINE_ID: &str = "3d1219c7c4c5404aaa1f6d2a48adfda4";

pub(crate) fn draft() -> RecordDraft {
    RecordDraft {
        event_type: "scene.generate".into(),
        time: TimeReading {
            unix_ms: 1_763_688_582_120,
            source: Source::Kernel,
            sync_status: SyncStatus::Synchronised,
            offset_us: Some(-310),
            max_error_us: Some(1900),
            stratum: None,
            reference: None,
            since_boot: Some(SinceBoot {
                boot_id: "bfbaf76d-3eb4-472a-b7e1-82de74e141d9".into(),
                milliseconds: 5_000_000,
            }),
        },
        event_random: [0xcd; 10],
        invocation: Invocation {
            interface: Default::default(),
            operator_id: "jane".into(),
            machine_id: Some(MACHINE_ID.into()),
            container: Some("podman".into()),
            cwd_rel: Some("vans".into()),
            request_id: Some("01234567-89ab-8def-8123-456789abcdef".into()),
            argv_redacted: Some(["orb", "geo", "--seed", "7"].map(str::to_owned).to_vec()),
            hostname: Some("unit-7".into()),
            display: Some("Jane Doe".into()),
            role: Some("modeller".into()),
            retention_hint: Some("P6Y".into()),
        },
        command: "orb geo".into(),
        inputs: vec![input("van.jpg", b"photo", "image/jpeg", "photo", None)],
        models: vec![model("scene", "1", &sha256_hex(b"w"), 1, "rten"), model_not_used("colmap")],
        params: BTreeMap::from([
            ("seed".into(), Param::Int(7)),
            ("scale_m".into(), Param::Text("1.25".into())),
            ("refined".into(), Param::Bool(true)),
        ]),
        tool: Tool {
            name: "orb".into(),
            version: "0.1.0".into(),
            git_commit: Some("0a".repeat(20)),
            dirty: Some(false),
            binary_sha256: Some(sha256_hex(b"orb")),
            ..Tool::default()
        },
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
        r#""container":"podman","host_id":""#,
        r#""boot_id":"bfbaf76d-3eb4-472a-b7e1-82de74e141d9""#,
        r#""monotonic_ms":5000000"#,
        r#""source":{"argv_redacted":["orb","geo","--seed","7"],"command":"orb geo","cwd_rel":"vans","interface":"cli","request_id":"01234567-89ab-8def-8123-456789abcdef"}"#,
        r#""hostname":"unit-7""#,
        r#""display":"Jane Doe""#,
        r#""role":"modeller""#,
        r#""retention_hint":"P6Y""#,
        r#""dirty":false"#,
        r#""schema_minor":6"#,
    ] {
        assert!(text.contains(part), "{part} in {text}");
    }
    assert!(!text.contains("null") && !text.contains(MACHINE_ID));
    let p = &sealed.statement.predicate;
    assert_eq!(p.place.host_id, Some(host_id(MACHINE_ID, &p.chain.ledger_id)));
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
    use crate::audit::marking::register::CountryRegister;
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
        register: Some(CountryRegister { sha256: sha256_hex(b"QQQ\n"), codes: vec!["QQQ".into()] }),
        ..Marking::parse("TOP SECRET//ORCON/REL TO USA, GBR//LIMDIS").unwrap().into()
    };
    for d in [draft(), full.clone()] {
        assert!(fits(&schema, &value(&d)));
    }
    #[cfg(not(feature = "fips"))]
    {
        use crate::audit::keys::suite_tests::pair;
        let by_both = seal(&draft(), subjects(), Outcome::Success, None, None, pair()).unwrap();
        let mut value: serde_json::Value = serde_json::from_slice(&by_both.envelope.payload).unwrap();
        assert!(fits(&schema, &value));
        assert_eq!(value["predicate"]["actor"]["co_signers"][0]["algorithm"], "ML-DSA-87");
        value["predicate"]["actor"]["co_signers"][0]["also"] = "x".into();
        assert!(!fits(&schema, &value));
        assert!(Statement::parse(&canonical::to_vec(&value).unwrap()).is_err());
    }
    let changes: [fn(&mut serde_json::Value); 12] = [
        |v| v["predicate"]["marking"]["country_register"]["name"] = "x".into(),
        |v| v["predicate"]["marking"]["country_register"]["codes"] = "QQQ".into(),
        |v| drop(v["predicate"]["marking"]["country_register"].as_object_mut().unwrap().remove("sha256")),
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
    // Words of the same spelling elsewhere are not it.
    let mut d = draft();
    let words = format!("\",\"trail_hash\":\"{}", "0".repeat(64));
    d.params.insert("trail_hash".into(), Param::Text(words.clone()));
    d.invocation.container = Some(words);
    let sealed = sealed(&d).unwrap();
    let (.., as_read) = Statement::parse_and_hash(&sealed.envelope.payload).unwrap();
    assert_eq!(as_read, sealed.trail_hash);
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
    let mut d = draft();
    d.invocation.role = Some("x".repeat(257));
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
        ("\"schema_minor\":6", "\"schema_minor\":-1"),
        ("\"outcome\":\"success\"", "\"outcome\":\"maybe\""),
        ("\"seq\":0", "\"seq\":\"0\""),
        ("T01:29:42.120Z", "T01:29:42Z"),
        ("orb.audit/v1", "orb.audit/v2"),
        ("\"size\":\"3\"", "\"size\":\"03\""),
        ("\"cwd_rel\":\"vans\"", "\"cwd_rel\":\"/home/jane/vans\""),
        ("\"cwd_rel\":\"vans\"", "\"cwd_rel\":\"C:/vans\""),
        ("\"--seed\"", "\"/home/jane/van.jpg\""),
        ("\"--seed\"", "\"C:/van.jpg\""),
        ("\"dirty\":false", "\"dirty\":\"no\""),
        ("\"git_commit\":\"", "\"git_commit\":\"main"),
        ("\"binary_sha256\":\"", "\"binary_sha256\":\"0"),
        ("\"boot_id\":\"bf", "\"boot_id\":\"BF"),
        (",\"monotonic_ms\":5000000", ""),
        ("\"monotonic_ms\":5000000", "\"monotonic_ms\":-1"),
        ("\"host_id\":\"", "\"host_id\":\"0"),
        ("\"source\":\"kernel\"", "\"source\":\"kernel\",\"stratum\":0"),
        ("\"source\":\"kernel\"", "\"source\":\"kernel\",\"stratum\":16"),
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

/// What older programs wrote stays readable: every field of a later minor version may be absent.
#[test]
fn records_of_older_minor_versions() {
    let mut value: serde_json::Value = serde_json::from_slice(&sealed(&draft()).unwrap().envelope.payload).unwrap();
    let p = &mut value["predicate"];
    p["schema_minor"] = 0.into();
    for (of, names) in [
        ("time", &["boot_id", "monotonic_ms"][..]),
        ("where", &["host_id", "container"]),
        ("source", &["cwd_rel", "request_id"]),
        ("actor", &["display", "role"]),
        ("tool", &["dirty"]),
    ] {
        for name in names {
            assert!(p[of].as_object_mut().unwrap().remove(*name).is_some(), "{name}");
        }
    }
    assert!(p.as_object_mut().unwrap().remove("retention_hint").is_some());
    let (old, _) = Statement::parse(&canonical::to_vec(&value).unwrap()).unwrap();
    assert_eq!((old.predicate.schema_minor, old.predicate.time.boot_id), (0, None));
    let schema: serde_json::Value = serde_json::from_str(crate::audit::statement::RECORD_SCHEMA).unwrap();
    assert!(fits(&schema, &value));
}
