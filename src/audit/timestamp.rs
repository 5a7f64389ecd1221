//! Time stamps of RFC 3161: somebody else's signed word that a record stood at a time. Requests and tokens travel as files;
//! nothing is sent.

use cms::cert::CertificateChoices;
use cms::content_info::ContentInfo;
use cms::signed_data::{SignedData, SignerIdentifier, SignerInfo};
use pkcs8::ObjectIdentifier;
use pkcs8::der::asn1::{Int, Null, OctetString};
use pkcs8::der::{Any, Decode as _, Encode as _};
use pkcs8::spki::AlgorithmIdentifier;
use sha2::{Digest as _, Sha256, Sha384, Sha512};
use x509_tsp::{MessageImprint, TimeStampReq, TimeStampResp, TspVersion, TstInfo};

use super::trust::TrustStore;

/// Largest token that is read, bytes.
pub const MAX_BYTES: u64 = 256 * 1024;
const SHA_256: ObjectIdentifier = ObjectIdentifier::new_unwrap("2.16.840.1.101.3.4.2.1");
const SHA_384: ObjectIdentifier = ObjectIdentifier::new_unwrap("2.16.840.1.101.3.4.2.2");
const SHA_512: ObjectIdentifier = ObjectIdentifier::new_unwrap("2.16.840.1.101.3.4.2.3");
/// id-signedData, RFC 5652 §5.1.
const SIGNED_DATA: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.7.2");
/// id-ct-TSTInfo, RFC 3161 §2.4.2.
const TST_INFO: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.9.16.1.4");
/// Attributes of RFC 5652 §11 and RFC 5816 §2.2.
const CONTENT_TYPE: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.9.3");
const MESSAGE_DIGEST: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.9.4");
const SIGNING_CERTIFICATE_V2: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.9.16.2.47");

/// What a token says, once it is believed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stamp {
    /// The latest time that it allows: its own and its accuracy. Milliseconds since 1970.
    pub not_after_ms: u64,
    /// Who says so, RFC 4514.
    pub authority: String,
}

/// Why a token is not believed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// Nobody who is trusted answers for its signer.
    Untrusted(String),
    /// It is damaged, of something else, or of no use.
    Invalid(String),
}

/// A request for a time stamp of `message` (RFC 3161 §2.4.1), DER, what `openssl ts -query -data FILE -sha256 -cert` writes.
///
/// # Errors
/// Words, when it cannot be encoded.
pub fn request(message: &[u8], nonce: [u8; 8]) -> Result<Vec<u8>, String> {
    // A positive integer in its shortest form.
    let mut nonce = nonce;
    nonce[0] = nonce[0] & 0x7f | 0x40;
    let words = |e: pkcs8::der::Error| e.to_string();
    let request = TimeStampReq {
        version: TspVersion::V1,
        message_imprint: MessageImprint {
            hash_algorithm: AlgorithmIdentifier { oid: SHA_256, parameters: Some(Any::from(Null)) },
            hashed_message: OctetString::new(Sha256::digest(message).to_vec()).map_err(words)?,
        },
        req_policy: None,
        nonce: Some(Int::new(&nonce).map_err(words)?),
        cert_req: true,
        extensions: None,
    };
    request.to_der().map_err(words)
}

/// Checks a token, or the response that holds one, DER: of this message, signed by a time stamping authority for which one
/// of the trust store's authorities answers at the token's own time.
///
/// # Errors
/// [`Refused`].
pub fn check(token: &[u8], message: &[u8], trust: &TrustStore) -> Result<Stamp, Refused> {
    let (signed, info, content) = parse(token).map_err(Refused::Invalid)?;
    let imprint = &info.message_imprint;
    if imprint.hash_algorithm.oid != SHA_256 || imprint.hashed_message.as_bytes() != Sha256::digest(message).as_slice()
    {
        return Err(Refused::Invalid("a time stamp of something else".into()));
    }
    let certificates = certificates(&signed).map_err(Refused::Invalid)?;
    let signer = only_signer(&signed).map_err(Refused::Invalid)?;
    let chain = chain_of(signer, certificates).map_err(Refused::Invalid)?;
    let attributes = check_attributes(signer, &content, &chain[0]).map_err(Refused::Invalid)?;
    let time_ms = u64::try_from(info.gen_time.to_unix_duration().as_millis()).unwrap_or(u64::MAX);
    let authority = trust
        .check_time_stamping(&chain, time_ms, &attributes, signer.signature.as_bytes(), digest_name(signer))
        .map_err(|why| if why.contains("UnknownIssuer") { Refused::Untrusted(why) } else { Refused::Invalid(why) })?;
    let accuracy = info.accuracy.as_ref().map_or(0, |a| {
        let millis = a.millis.map_or(0, |ms| u64::from(ms.unsigned_abs()));
        a.seconds.unwrap_or(0).saturating_mul(1000).saturating_add(millis + u64::from(a.micros.is_some()))
    });
    Ok(Stamp { not_after_ms: time_ms.saturating_add(accuracy), authority })
}

fn parse(token: &[u8]) -> Result<(SignedData, TstInfo, Vec<u8>), String> {
    let damaged = |e: pkcs8::der::Error| format!("a damaged time stamp ({e})");
    let content = match ContentInfo::from_der(token) {
        Ok(content) => content,
        Err(_) => TimeStampResp::from_der(token)
            .map_err(damaged)?
            .time_stamp_token
            .ok_or("a response without a time stamp: the authority refused")?,
    };
    if content.content_type != SIGNED_DATA {
        return Err(format!("content of type {}, not signed data", content.content_type));
    }
    let signed: SignedData = content.content.decode_as().map_err(damaged)?;
    let inner = &signed.encap_content_info;
    if inner.econtent_type != TST_INFO {
        return Err(format!("signed content of type {}, not a time stamp", inner.econtent_type));
    }
    let bytes: OctetString =
        inner.econtent.as_ref().ok_or("a time stamp without content")?.decode_as().map_err(damaged)?;
    let info = TstInfo::from_der(bytes.as_bytes()).map_err(damaged)?;
    Ok((signed.clone(), info, bytes.into_bytes()))
}

fn certificates(signed: &SignedData) -> Result<Vec<x509_cert::Certificate>, String> {
    let all = signed.certificates.as_ref().ok_or("a time stamp without certificates: request them (certReq)")?;
    Ok(all
        .0
        .iter()
        .filter_map(|choice| match choice {
            CertificateChoices::Certificate(certificate) => Some(certificate.clone()),
            _ => None,
        })
        .collect())
}

fn only_signer(signed: &SignedData) -> Result<&SignerInfo, String> {
    match signed.signer_infos.0.as_slice() {
        [one] => Ok(one),
        // RFC 3161 §2.4.2.
        several => Err(format!("{} signers; a time stamp has one", several.len())),
    }
}

/// The signer's certificate, then the others.
fn chain_of(signer: &SignerInfo, certificates: Vec<x509_cert::Certificate>) -> Result<Vec<Vec<u8>>, String> {
    let SignerIdentifier::IssuerAndSerialNumber(id) = &signer.sid else {
        return Err("a signer that is not named by issuer and number".into());
    };
    let (mut own, others): (Vec<_>, Vec<_>) = certificates
        .into_iter()
        .partition(|c| c.tbs_certificate.issuer == id.issuer && c.tbs_certificate.serial_number == id.serial_number);
    own.extend(others);
    if own.is_empty() || own.len() > 8 {
        return Err(format!("{} certificates; 1 to 8 are accepted", own.len()));
    }
    own.iter().map(|c| c.to_der().map_err(|e| e.to_string())).collect()
}

/// The signed attributes' bytes, once they name this content and this certificate.
fn check_attributes(signer: &SignerInfo, content: &[u8], certificate: &[u8]) -> Result<Vec<u8>, String> {
    let attributes = signer.signed_attrs.as_ref().ok_or("no signed attributes")?;
    let value = |oid: ObjectIdentifier| {
        let mut found = attributes.iter().filter(|a| a.oid == oid);
        match (found.next(), found.next()) {
            (Some(attribute), None) if attribute.values.len() == 1 => Ok(attribute.values.as_slice()[0].clone()),
            _ => Err(format!("attribute {oid} stands not once")),
        }
    };
    let words = |e: pkcs8::der::Error| e.to_string();
    if value(CONTENT_TYPE)?.decode_as::<ObjectIdentifier>().map_err(words)? != TST_INFO {
        return Err("signed attributes of another content".into());
    }
    let digest: Vec<u8> = match signer.digest_alg.oid {
        SHA_256 => Sha256::digest(content).to_vec(),
        SHA_384 => Sha384::digest(content).to_vec(),
        SHA_512 => Sha512::digest(content).to_vec(),
        other => return Err(format!("the digest {other}")),
    };
    if value(MESSAGE_DIGEST)?.decode_as::<OctetString>().map_err(words)?.as_bytes() != digest {
        return Err("signed attributes of another time".into());
    }
    // SigningCertificateV2 { certs { ESSCertIDv2 { hashAlgorithm DEFAULT sha256, certHash, … }, … }, … }.
    let first = |any: &Any| any.decode_as::<Vec<Any>>().ok();
    if !attributes.iter().any(|a| a.oid == SIGNING_CERTIFICATE_V2) {
        return Err("its signer is not named by SHA-256 or more (RFC 5816): ask the authority for ESSCertIDv2".into());
    }
    let id = first(&value(SIGNING_CERTIFICATE_V2)?)
        .and_then(|v| v.first().and_then(first))
        .and_then(|v| v.first().and_then(first));
    let hash = id.unwrap_or_default().iter().find_map(|part| part.decode_as::<OctetString>().ok());
    let hash = hash.ok_or("no digest of the signer's certificate")?;
    let expected = match hash.as_bytes().len() {
        32 => Sha256::digest(certificate).to_vec(),
        48 => Sha384::digest(certificate).to_vec(),
        _ => Sha512::digest(certificate).to_vec(),
    };
    if hash.as_bytes() != expected {
        return Err("signed under another certificate".into());
    }
    attributes.to_der().map_err(words)
}

/// The digest that the signature is over, by its length in bits.
fn digest_name(signer: &SignerInfo) -> usize {
    match signer.digest_alg.oid {
        SHA_384 => 384,
        SHA_512 => 512,
        _ => 256,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::trust::tests::{Pki, store_with};

    #[test]
    fn a_request_that_openssl_reads_and_a_token_that_it_gives() {
        let Some(pki) = Pki::new() else { return };
        pki.sign("tsa", "issuing", "tsa", "20240101000000Z", "20340101000000Z");
        let trust = store_with(&pki, &[]);
        let tsq = request(b"record", [0xff; 8]).unwrap();
        std::fs::write(pki.path("r.tsq"), &tsq).unwrap();
        pki.openssl(&["ts", "-reply", "-config", "ca.cnf", "-section", "t", "-queryfile", "r.tsq", "-out", "r.tsr"]);
        let token = std::fs::read(pki.path("r.tsr")).unwrap();
        let stamp = check(&token, b"record", &trust).unwrap();
        assert_eq!(stamp.authority, "CN=Test tsa");
        let now = crate::audit::time::now().unwrap().unix_ms;
        assert!(stamp.not_after_ms.abs_diff(now) < 60_000, "{stamp:?} {now}");

        assert!(matches!(check(&token, b"another", &trust), Err(Refused::Invalid(_))));
        assert!(matches!(check(&token, b"record", &TrustStore::default()), Err(Refused::Untrusted(_))));
        assert!(check(&token[..token.len() - 1], b"record", &trust).is_err());
        // Any changed byte of time, attributes or signature.
        let from = token.windows(4).rposition(|w| w == &Sha256::digest(b"record")[..4]).unwrap();
        for at in (from..token.len()).step_by(7) {
            let mut bad = token.clone();
            bad[at] ^= 1;
            if let Ok(same) = check(&bad, b"record", &trust) {
                // Bytes of certificates that nothing depends on, such as those of an authority that is known anyway.
                assert_eq!(same, stamp, "byte {at}");
            }
        }
        // A signer's certificate is for documents, not for time.
        std::fs::copy(pki.path("leaf.pem"), pki.path("tsa.pem")).unwrap();
        pki.sign("tsa", "issuing", "leaf", "20240101000000Z", "20340101000000Z");
        let done = std::process::Command::new("openssl")
            .args(["ts", "-reply", "-config", "ca.cnf", "-section", "t", "-queryfile", "r.tsq", "-out", "w.tsr"])
            .current_dir(pki.dir.path())
            .output()
            .unwrap();
        if done.status.success() {
            let token = std::fs::read(pki.path("w.tsr")).unwrap();
            assert!(matches!(check(&token, b"record", &trust), Err(Refused::Invalid(_))));
        }
    }
    #[test]
    fn beside_a_record() {
        use crate::audit::by_hand;
        use crate::audit::keys::tests::shared_key;
        use crate::audit::publication::tests::publish;
        use crate::audit::publication::{RECORD, RECORD_STAMP};
        use crate::audit::verify::{Request, verify};
        let Some(pki) = Pki::new() else { return };
        pki.sign("tsa", "issuing", "tsa", "20240101000000Z", "20340101000000Z");
        publish(pki.dir.path());
        let out = pki.path("out");
        let stamp = |message: &[u8]| {
            std::fs::write(pki.path("r.tsq"), request(message, [1; 8]).unwrap()).unwrap();
            pki.openssl(&[
                "ts",
                "-reply",
                "-config",
                "ca.cnf",
                "-section",
                "t",
                "-queryfile",
                "r.tsq",
                "-out",
                "r.tsr",
            ]);
            std::fs::copy(pki.path("r.tsr"), out.join(RECORD_STAMP)).unwrap();
        };
        let check = |mut trust: TrustStore| {
            trust.insert(shared_key().public().clone());
            let report = verify(&Request::new(&out, &trust, 1_763_700_000_000)).unwrap();
            (report.exit_code, report.findings.iter().map(|f| f.code).collect::<Vec<_>>())
        };
        let record = std::fs::read(out.join(RECORD)).unwrap();
        stamp(&record);
        let (code, found) = check(store_with(&pki, &[]));
        assert!(code == 0 && found.contains(&"TIME_STAMPED"), "{found:?}");
        let (code, found) = check(TrustStore::default());
        assert!(code == 0 && found.contains(&"TIME_STAMP_UNTRUSTED"), "{found:?}");
        let commands = by_hand::openssl_commands(&out, by_hand::Beside::default()).unwrap();
        assert!(commands.contains("openssl ts -verify"), "{commands}");
        stamp(b"another record");
        let (code, found) = check(store_with(&pki, &[]));
        assert!(code == 1 && found.contains(&"TIME_STAMP_INVALID"), "{found:?}");
    }
}
