//! The Dead Simple Signing Envelope, DSSE 1.0.2: a signature over type and bytes, so that nothing has to be
//! canonicalised before it is trusted.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::{Deserialize, Serialize};

use super::canonical::{self, Fault};

/// The payload type of in-toto statements.
pub const PAYLOAD_TYPE: &str = "application/vnd.in-toto+json";
/// Largest envelope that is read, bytes: a record of the largest size in base64, and its signatures.
pub const MAX_ENVELOPE_BYTES: usize = canonical::MAX_BYTES / 3 * 4 + (1 << 16);
/// Most signatures that are read.
pub const MAX_SIGNATURES: usize = 8;

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// Says which key to try. Not covered by the signature: never a reason to trust.
    pub keyid: String,
    pub sig: Vec<u8>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Envelope {
    pub payload: Vec<u8>,
    pub payload_type: String,
    pub signatures: Vec<Signature>,
}

/// The bytes that are signed: DSSE protocol, "PAE(type, body)".
pub fn pae(payload_type: &str, payload: &[u8]) -> Vec<u8> {
    let mut out = format!("DSSEv1 {} {payload_type} {} ", payload_type.len(), payload.len()).into_bytes();
    out.extend_from_slice(payload);
    out
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Wire {
    payload: String,
    #[serde(rename = "payloadType")]
    payload_type: String,
    signatures: Vec<WireSignature>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WireSignature {
    keyid: String,
    sig: String,
}

impl Envelope {
    /// One line of canonical JSON with a line feed: what stands beside the outputs and in the ledger.
    pub fn to_line(&self) -> Vec<u8> {
        let wire = Wire {
            payload: STANDARD.encode(&self.payload),
            payload_type: self.payload_type.clone(),
            signatures: self
                .signatures
                .iter()
                .map(|s| WireSignature { keyid: s.keyid.clone(), sig: STANDARD.encode(&s.sig) })
                .collect(),
        };
        // Its fields stand in RFC 8785's order, and a struct of strings always serialises.
        let mut line = serde_json::to_vec(&wire).unwrap_or_default();
        line.push(b'\n');
        line
    }

    /// Reads an envelope in any JSON spelling; unknown and repeated fields and loose base64 are refused.
    ///
    /// # Errors
    /// A [`Fault`] saying what is wrong.
    pub fn parse(bytes: &[u8]) -> Result<Envelope, Fault> {
        if bytes.len() > MAX_ENVELOPE_BYTES {
            return Err(Fault::Limit(format!("{} bytes, at most {MAX_ENVELOPE_BYTES} are read", bytes.len())));
        }
        let wire: Wire = serde_json::from_slice(bytes).map_err(|e| Fault::Schema(e.to_string()))?;
        if wire.signatures.is_empty() {
            return Err(Fault::Schema("no signature".into()));
        }
        if wire.signatures.len() > MAX_SIGNATURES {
            return Err(Fault::Limit(format!("{} signatures, at most {MAX_SIGNATURES}", wire.signatures.len())));
        }
        let decode = |what: &str, text: &str| {
            STANDARD.decode(text).map_err(|e| Fault::Schema(format!("{what} is not strict base64: {e}")))
        };
        Ok(Envelope {
            payload: decode("payload", &wire.payload)?,
            payload_type: wire.payload_type,
            signatures: wire
                .signatures
                .into_iter()
                .map(|s| Ok(Signature { sig: decode("sig", &s.sig)?, keyid: s.keyid }))
                .collect::<Result<_, Fault>>()?,
        })
    }

    /// The bytes that the signatures cover.
    pub fn pae(&self) -> Vec<u8> {
        pae(&self.payload_type, &self.payload)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The test vector of the DSSE protocol's own description.
    #[test]
    fn published_pae() {
        assert_eq!(
            pae("http://example.com/HelloWorld", b"hello world"),
            b"DSSEv1 29 http://example.com/HelloWorld 11 hello world"
        );
        assert_eq!(pae("", b""), b"DSSEv1 0  0 ");
    }

    /// The same description's envelope, its ECDSA signature taken as bytes.
    #[test]
    fn published_envelope_is_read() {
        let text = r#"{"payload":"aGVsbG8gd29ybGQ=","payloadType":"http://example.com/HelloWorld","signatures":[{"keyid":"66301bbf","sig":"A3JqsQGtVsJ2O2xqrI5IcnXip5GToJ3F+FnZ+O88SjtR6rDAajabZKciJTfUiHqJPcIAriEGAHTVeCUjW2JIZA=="}]}"#;
        let envelope = Envelope::parse(text.as_bytes()).unwrap();
        assert_eq!(envelope.payload, b"hello world");
        assert_eq!(envelope.signatures[0].sig.len(), 64);
        assert_eq!(envelope.to_line(), format!("{text}\n").into_bytes());
    }

    #[test]
    fn loose_envelopes_are_refused() {
        let good = Envelope {
            payload: b"x".to_vec(),
            payload_type: PAYLOAD_TYPE.into(),
            signatures: vec![Signature { keyid: "k".into(), sig: vec![1, 2, 3] }],
        };
        let line = String::from_utf8(good.to_line()).unwrap();
        assert_eq!(Envelope::parse(line.as_bytes()).unwrap(), good);
        for (from, to) in [
            ("{\"payload\":", "{\"extra\":1,\"payload\":"),
            ("{\"payload\":", "{\"payload\":\"eQ==\",\"payload\":"),
            ("eA==", "eA="),
            ("eA==", "eB=="), // stray bits after the last byte
            ("eA==", "e A=="),
            ("eA==", "eA==\\n"),
            ("{\"keyid\":\"k\",\"sig\":\"AQID\"}", ""),
            ("{\"keyid\":\"k\",\"sig\":\"AQID\"}", "{\"keyid\":\"k\",\"sig\":\"AQID\",\"x\":\"\"}"),
            ("{\"keyid\":\"k\",\"sig\":\"AQID\"}", "{\"sig\":\"AQID\"}"),
        ] {
            assert!(line.contains(from));
            assert!(Envelope::parse(line.replacen(from, to, 1).as_bytes()).is_err(), "{to}");
        }
        let many = Envelope { signatures: vec![good.signatures[0].clone(); MAX_SIGNATURES + 1], ..good };
        assert_eq!(Envelope::parse(&many.to_line()).unwrap_err().code(), "LIMIT_EXCEEDED");
        assert_eq!(Envelope::parse(&vec![b' '; MAX_ENVELOPE_BYTES + 1]).unwrap_err().code(), "LIMIT_EXCEEDED");
    }
}
