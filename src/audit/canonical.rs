//! Canonical JSON (RFC 8785) within the limits of a record: integers up to 2^53 − 1, no fractions, no null, no key
//! twice, no control characters, so that one meaning has one spelling and no reader sees another value.

use std::collections::BTreeMap;
use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error as _, MapAccess, SeqAccess, Visitor};
use serde::{Serialize, Serializer};
use sha2::{Digest, Sha256};

/// Largest canonical document, bytes.
pub const MAX_BYTES: usize = 1 << 20;
/// Deepest nesting of lists and maps.
pub const MAX_DEPTH: usize = 16;
/// Largest integer that every JSON reader holds exactly: 2^53 − 1.
pub const MAX_INTEGER: i64 = (1 << 53) - 1;

/// Why bytes are not an acceptable document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Too big or too deep: `LIMIT_EXCEEDED`.
    Limit(String),
    /// Not JSON, or a value that a record cannot hold: `SCHEMA_INVALID`.
    Schema(String),
}

impl Fault {
    pub fn code(&self) -> &'static str {
        match self {
            Fault::Limit(_) => "LIMIT_EXCEEDED",
            Fault::Schema(_) => "SCHEMA_INVALID",
        }
    }
    pub fn detail(&self) -> &str {
        match self {
            Fault::Limit(text) | Fault::Schema(text) => text,
        }
    }
}

/// A JSON value that a record can hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Json {
    Bool(bool),
    Int(i64),
    Text(String),
    List(Vec<Json>),
    Map(BTreeMap<String, Json>),
}

impl Json {
    /// The one spelling. RFC 8785 asks for more than `serde_json` does in two things only: the order of keys, which a
    /// sorted map of ASCII names has, and the form of fractions, of which there are none.
    pub fn to_bytes(&self) -> Vec<u8> {
        // A tree of strings, integers and truth values always serialises.
        serde_json::to_vec(self).unwrap_or_default()
    }
}

impl Serialize for Json {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Json::Bool(value) => serializer.serialize_bool(*value),
            Json::Int(value) => serializer.serialize_i64(*value),
            Json::Text(value) => serializer.serialize_str(value),
            Json::List(value) => value.serialize(serializer),
            Json::Map(value) => value.serialize(serializer),
        }
    }
}

/// Writes the canonical form, having checked it against the limits above.
///
/// # Errors
/// A [`Fault`] naming the value that a record cannot hold.
pub fn to_vec<T: Serialize>(value: &T) -> Result<Vec<u8>, Fault> {
    let bytes = serde_json::to_vec(value).map_err(|e| Fault::Schema(e.to_string()))?;
    Ok(parse(&bytes)?.to_bytes())
}

/// Reads any JSON spelling of a value that a record can hold.
///
/// # Errors
/// A [`Fault`] for everything else.
pub fn parse(bytes: &[u8]) -> Result<Json, Fault> {
    if bytes.len() > MAX_BYTES {
        return Err(Fault::Limit(format!("{} bytes, at most {MAX_BYTES} are read", bytes.len())));
    }
    let mut reader = serde_json::Deserializer::from_slice(bytes);
    let value = Value { depth: 0 }.deserialize(&mut reader).and_then(|value| reader.end().map(|()| value));
    value.map_err(|error| {
        let text = error.to_string();
        if text.contains(TOO_DEEP) { Fault::Limit(text) } else { Fault::Schema(text) }
    })
}

/// True when `bytes` are the one canonical spelling of `value`.
pub fn is_canonical(value: &Json, bytes: &[u8]) -> bool {
    value.to_bytes() == bytes
}

/// SHA-256, lower-case hexadecimal.
pub fn sha256_hex(bytes: &[u8]) -> String {
    hex::encode(Sha256::digest(bytes))
}

const TOO_DEEP: &str = "nested deeper than 16 levels";

struct Value {
    depth: usize,
}

impl<'de> DeserializeSeed<'de> for Value {
    type Value = Json;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Json, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Value {
    type Value = Json;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a string, an integer within 2^53 - 1, true, false, a list or a map")
    }
    fn visit_bool<E>(self, value: bool) -> Result<Json, E> {
        Ok(Json::Bool(value))
    }
    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<Json, E> {
        if (-MAX_INTEGER..=MAX_INTEGER).contains(&value) {
            Ok(Json::Int(value))
        } else {
            Err(E::custom(format!("integer {value} is beyond 2^53 - 1")))
        }
    }
    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<Json, E> {
        let value = i64::try_from(value).map_err(|_| E::custom(format!("integer {value} is beyond 2^53 - 1")))?;
        self.visit_i64(value)
    }
    fn visit_str<E: serde::de::Error>(self, value: &str) -> Result<Json, E> {
        if value.chars().any(char::is_control) {
            return Err(E::custom("a string holds a control character"));
        }
        Ok(Json::Text(value.to_owned()))
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Json, A::Error> {
        let depth = deeper(self.depth)?;
        let mut list = Vec::new();
        while let Some(item) = items.next_element_seed(Value { depth })? {
            list.push(item);
        }
        Ok(Json::List(list))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Json, A::Error> {
        let depth = deeper(self.depth)?;
        let mut map = BTreeMap::new();
        while let Some(key) = entries.next_key::<String>()? {
            if !key.bytes().all(|b| b.is_ascii_graphic()) {
                return Err(A::Error::custom(format!("key {key:?} is not printable ASCII")));
            }
            let value = entries.next_value_seed(Value { depth })?;
            if map.contains_key(&key) {
                return Err(A::Error::custom(format!("key {key:?} stands twice")));
            }
            map.insert(key, value);
        }
        Ok(Json::Map(map))
    }
}

fn deeper<E: serde::de::Error>(depth: usize) -> Result<usize, E> {
    if depth >= MAX_DEPTH { Err(E::custom(TOO_DEEP)) } else { Ok(depth + 1) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(text: &str) -> Fault {
        parse(text.as_bytes()).expect_err(text)
    }

    /// RFC 8785 §3.2.3 (sorting by UTF-16 code units) and §3.2.2.2 (string escapes): the library that the spelling is compared with.
    #[test]
    fn rfc_8785_examples() {
        let sorted = serde_json_canonicalizer::pipe(
            "{\"\\u20ac\":\"Euro Sign\",\"\\r\":\"Carriage Return\",\"\\ufb33\":\"Hebrew Letter Dalet With Dagesh\",\"1\":\"One\",\"\\ud83d\\ude00\":\"Emoji: Grinning Face\",\"\\u0080\":\"Control\",\"\\u00f6\":\"Latin Small Letter O With Diaeresis\"}",
        )
        .unwrap();
        let expected = "{\"\\r\":\"Carriage Return\",\"1\":\"One\",\"\u{80}\":\"Control\",\"\u{f6}\":\"Latin Small Letter O With Diaeresis\",\"\u{20ac}\":\"Euro Sign\",\"\u{1f600}\":\"Emoji: Grinning Face\",\"\u{fb33}\":\"Hebrew Letter Dalet With Dagesh\"}";
        assert_eq!(sorted, expected);
        let escaped =
            serde_json_canonicalizer::pipe(r#"{"string":"\u20ac$\u000F\u000aA'\u0042\u0022\u005c\\\"\/"}"#).unwrap();
        assert_eq!(escaped, "{\"string\":\"€$\\u000f\\nA'B\\\"\\\\\\\\\\\"/\"}");
        let literals = serde_json_canonicalizer::pipe("{ \"literals\": [null, true, false] }").unwrap();
        assert_eq!(literals, r#"{"literals":[null,true,false]}"#);
    }

    #[test]
    fn one_meaning_has_one_spelling() {
        let canonical = br#"{"a":[1,true,"x"],"b":{"c":-9007199254740991}}"#;
        let value = parse(canonical).unwrap();
        assert!(is_canonical(&value, canonical));
        assert_eq!(to_vec(&value).unwrap(), canonical);
        for other in [
            r#"{"b":{"c":-9007199254740991},"a":[1,true,"x"]}"#,
            r#"{"a": [1,true,"x"],"b":{"c":-9007199254740991}}"#,
            r#"{"a":[1,true,"\u0078"],"b":{"c":-9007199254740991}}"#,
            "{\"a\":[1,true,\"x\"],\"b\":{\"c\":-9007199254740991}}\n",
        ] {
            let same = parse(other.as_bytes()).unwrap();
            assert_eq!(same, value);
            assert!(!is_canonical(&same, other.as_bytes()));
        }
    }

    fn any_value() -> impl proptest::strategy::Strategy<Value = Json> {
        use proptest::prelude::*;
        let leaf = prop_oneof![
            any::<bool>().prop_map(Json::Bool),
            (-MAX_INTEGER..=MAX_INTEGER).prop_map(Json::Int),
            "\\PC*".prop_map(Json::Text),
            r#"[ -~\u{80}-\u{ff}\u{2028}\u{1f600}"\\/]*"#.prop_map(Json::Text),
        ];
        leaf.prop_recursive(4, 32, 5, |inner| {
            prop_oneof![
                prop::collection::vec(inner.clone(), 0..5).prop_map(Json::List),
                prop::collection::btree_map("[!-~]{1,6}", inner, 0..5).prop_map(Json::Map),
            ]
        })
    }

    proptest::proptest! {
        /// Against a library that the RFC's own collection names.
        #[test]
        fn spelled_as_rfc_8785_does(value in any_value()) {
            proptest::prop_assert_eq!(value.to_bytes(), serde_json_canonicalizer::to_vec(&value).unwrap());
        }
    }

    #[test]
    fn what_a_record_cannot_hold() {
        assert_eq!(fault("9007199254740992").code(), "SCHEMA_INVALID");
        assert_eq!(fault("-9007199254740992").code(), "SCHEMA_INVALID");
        assert_eq!(fault("18446744073709551616").code(), "SCHEMA_INVALID");
        for text in
            ["1.0", "1e3", "-0", "null", "", "{", "[1,]", "{\"a\":1}x", "\"\\n\"", "{\"é\":1}", "{\"\":1, \"a b\":1}"]
        {
            assert_eq!(fault(text).code(), "SCHEMA_INVALID", "{text}");
        }
        assert!(fault(r#"{"a":1,"a":1}"#).detail().contains("twice"));
        assert!(parse(b"\"\xff\"").is_err());
        assert!(parse(b"\xef\xbb\xbf{}").is_err(), "byte order mark");
    }

    #[test]
    fn limits() {
        let nested = |n: usize| format!("{}{}", "[".repeat(n), "]".repeat(n));
        assert!(parse(nested(MAX_DEPTH).as_bytes()).is_ok());
        assert_eq!(fault(&nested(MAX_DEPTH + 1)).code(), "LIMIT_EXCEEDED");
        assert!(parse(nested(100_000).as_bytes()).is_err());
        assert_eq!(fault(&format!("\"{}\"", "x".repeat(MAX_BYTES))).code(), "LIMIT_EXCEEDED");
    }

    #[test]
    fn sha256_of_nothing() {
        // FIPS 180-4 example values, NIST: the empty message and "abc".
        assert_eq!(sha256_hex(b""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        assert_eq!(sha256_hex(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }
}
