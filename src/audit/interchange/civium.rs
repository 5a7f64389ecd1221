//! Bodies for a Civium audit service: an entry to post, and an evidence object. Made for carrying over by hand; nothing
//! is sent.

use serde_json::{Value, json};

use crate::audit::canonical::sha256_hex;
use crate::audit::statement::Statement;

/// Strings and integers only, so that both hash rules (RFC 8785 and Python's `json.dumps`) are easy to follow.
pub fn entry(statement: &Statement, signature: &[u8], control_ids: &[&str]) -> Value {
    let p = &statement.predicate;
    let trail_hash = p.trail_hash.clone().unwrap_or_default();
    let data = json!({
        "record_uri": format!("urn:orb:record:{}:{}", p.chain.ledger_id, p.chain.seq),
        "trail_hash": trail_hash,
        "marking": p.marking.banner,
        "outputs": statement.subject.iter().map(|s| format!("{} {}", s.digest.sha256, s.name)).collect::<Vec<_>>(),
    });
    let data_hash = sha256_hex(python_json(&data).as_bytes());
    json!({
        "entry": {"entity_id": format!("orb:{}", p.chain.ledger_id), "action": "scene_generated", "data": data},
        "expected_data_hash": data_hash,
        "evidence": {
            "evidence_type": "attestation",
            "content_hash": trail_hash,
            "signature": hex::encode(signature),
            "requirement_ids": control_ids,
        },
    })
}

/// `json.dumps(value, sort_keys=True)` of Python: a space after each comma and colon, other than ASCII escaped.
fn python_json(value: &Value) -> String {
    match value {
        Value::Array(items) => format!("[{}]", items.iter().map(python_json).collect::<Vec<_>>().join(", ")),
        Value::Object(map) => {
            // Python sorts keys by code point, as the order of UTF-8 bytes does.
            let mut entries: Vec<(&String, &Value)> = map.iter().collect();
            entries.sort_by_key(|(key, _)| key.as_str());
            let parts: Vec<String> = entries
                .into_iter()
                .map(|(key, value)| format!("{}: {}", python_text(key), python_json(value)))
                .collect();
            format!("{{{}}}", parts.join(", "))
        }
        Value::String(text) => python_text(text),
        other => other.to_string(),
    }
}

fn python_text(text: &str) -> String {
    let mut out = String::from("\"");
    for unit in text.encode_utf16() {
        match unit {
            0x22 => out.push_str("\\\""),
            0x5c => out.push_str("\\\\"),
            0x0a => out.push_str("\\n"),
            0x0d => out.push_str("\\r"),
            0x09 => out.push_str("\\t"),
            0x08 => out.push_str("\\b"),
            0x0c => out.push_str("\\f"),
            0x20..0x7f => out.push(char::from(unit as u8)),
            _ => out.push_str(&format!("\\u{unit:04x}")),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::record::{self, tests::draft};
    use crate::audit::statement::Outcome;

    /// Hashed by Python itself: `hashlib.sha256(json.dumps(x, sort_keys=True).encode()).hexdigest()`.
    #[test]
    fn the_hash_that_python_gives() {
        let value = json!({"trail_hash": "ab", "scene": "é-1", "n": 1, "f": 1.0});
        let hash = "836ece910bd06476b37da0cf7d5ccbaf4c1d33d74fc1df171644d8c5e5fb7b7f";
        assert_eq!(sha256_hex(python_json(&value).as_bytes()), hash);
        assert_eq!(
            python_json(&json!({"b": ["😀\"\\\u{7f}\n"], "a": {}})),
            r#"{"a": {}, "b": ["\ud83d\ude00\"\\\u007f\n"]}"#
        );
    }

    #[test]
    fn an_entry_of_strings() {
        let sealed = record::seal(&draft(), Vec::new(), Outcome::Success, None, None, shared_key()).unwrap();
        let value = entry(&sealed.statement, &sealed.envelope.signatures[0].sig, &["au-10"]);
        assert_eq!(value["evidence"]["content_hash"], sealed.trail_hash.as_str());
        assert_eq!(value["entry"]["data"]["marking"], "UNCLASSIFIED");
        assert_eq!(value["expected_data_hash"].as_str().unwrap().len(), 64);
    }
}
