//! X.509: certificates that a signer brings along, and the authorities that this user trusts. Paths are built and checked
//! offline by `rustls-webpki` (RFC 5280 §6), as of the time of signing.

use std::time::Duration;

use aws_lc_rs::signature::{self, UnparsedPublicKey, VerificationAlgorithm};
use pkcs8::der::{Decode as _, Encode as _};
use rustls_pki_types::{
    AlgorithmIdentifier, CertificateDer, InvalidSignature, SignatureVerificationAlgorithm, UnixTime, alg_id,
};
use webpki::{
    BorrowedCertRevocationList, CertRevocationList, EndEntityCert, ExtendedKeyUsageValidator, KeyPurposeIdIter,
    RevocationOptionsBuilder, RevocationReason, UnknownStatusPolicy, anchor_from_trusted_cert,
};
use x509_cert::Certificate;
use x509_cert::ext::pkix::{BasicConstraints, ExtendedKeyUsage, KeyUsage, KeyUsages};

use super::entry::{Entry, Objection, Signed};
use crate::audit::canonical::sha256_hex;
use crate::audit::keys::PublicKey;
use crate::audit::marking::Marking;
use crate::audit::pem;
use crate::audit::time;

pub const CERTIFICATE: &str = "CERTIFICATE";
pub const CRL: &str = "X509 CRL";
/// Most certificates of a chain, the signer's own among them.
const MAX_CHAIN: usize = 8;
/// id-kp-documentSigning, RFC 9336.
const DOCUMENT_SIGNING: &str = "1.3.6.1.5.5.7.3.36";
/// id-kp-timeStamping, RFC 3161 §2.3.
const TIME_STAMPING: &str = "1.3.6.1.5.5.7.3.8";
/// anyExtendedKeyUsage, RFC 5280 §4.2.1.12.
const ANY_USAGE: &str = "2.5.29.37.0";

/// A signer's certificate and those between it and an authority, leaf first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CertChain {
    der: Vec<Vec<u8>>,
    key: PublicKey,
    subject: String,
    /// The common name, else the whole subject.
    operator: String,
    /// Extended key usages; none when the certificate leaves it open.
    usages: Vec<String>,
    not_before_ms: u64,
}

impl CertChain {
    /// # Errors
    /// Words saying what is wrong.
    pub fn from_pem(text: &str) -> Result<CertChain, String> {
        CertChain::from_der(pem::decode_all(CERTIFICATE, text)?)
    }

    fn from_der(der: Vec<Vec<u8>>) -> Result<CertChain, String> {
        if der.is_empty() || der.len() > MAX_CHAIN {
            return Err(format!("{} certificates; 1 to {MAX_CHAIN} are accepted", der.len()));
        }
        let leaf = parse(&der[0])?;
        let tbs = &leaf.tbs_certificate;
        if is_authority(&leaf) {
            return Err("the first certificate is an authority's, not a signer's".into());
        }
        // RFC 5280 §4.2.1.3: without the extension every usage is allowed.
        let signs = |usage: KeyUsage| {
            usage.0.contains(KeyUsages::DigitalSignature) || usage.0.contains(KeyUsages::NonRepudiation)
        };
        if !tbs.get::<KeyUsage>().map_err(|e| e.to_string())?.is_none_or(|(_, usage)| signs(usage)) {
            return Err("the certificate's key usage is neither digitalSignature nor nonRepudiation".into());
        }
        let key = PublicKey::from_spki(&tbs.subject_public_key_info.to_der().map_err(|e| e.to_string())?)?;
        let subject = tbs.subject.to_string();
        let operator = common_name(&leaf).unwrap_or_else(|| subject.clone());
        let not_before_ms = tbs.validity.not_before.to_unix_duration().as_millis() as u64;
        let usages = usages(&leaf)?;
        Ok(CertChain { der, key, subject, operator, usages, not_before_ms })
    }

    pub fn to_pem(&self) -> String {
        self.der.iter().map(|der| pem::encode(CERTIFICATE, der)).collect()
    }

    /// SHA-256 of each certificate, leaf first.
    pub fn sha256(&self) -> Vec<String> {
        self.der.iter().map(|der| sha256_hex(der)).collect()
    }

    pub fn key(&self) -> &PublicKey {
        &self.key
    }

    /// The signer's name, RFC 4514.
    pub fn subject(&self) -> &str {
        &self.subject
    }

    pub fn operator(&self) -> &str {
        &self.operator
    }

    /// What each certificate says of itself, leaf first.
    pub fn validities(&self) -> Vec<Validity> {
        self.der.iter().filter_map(|der| Validity::of(der).ok()).collect()
    }
}

/// Whose certificate it is, and from when to when it is good.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Validity {
    /// RFC 4514.
    pub subject: String,
    pub sha256: String,
    /// Milliseconds since 1970; both ends belong to it (RFC 5280 §4.1.2.5).
    pub not_before_ms: u64,
    pub not_after_ms: u64,
}

impl Validity {
    fn of(der: &[u8]) -> Result<Validity, String> {
        let tbs = parse(der)?.tbs_certificate;
        let ms = |t: x509_cert::time::Time| u64::try_from(t.to_unix_duration().as_millis()).unwrap_or(u64::MAX);
        Ok(Validity {
            subject: tbs.subject.to_string(),
            sha256: sha256_hex(der),
            not_before_ms: ms(tbs.validity.not_before),
            not_after_ms: ms(tbs.validity.not_after),
        })
    }
}

/// An authority that is trusted to say whose key it is.
#[derive(Clone, Debug)]
pub struct Authority {
    pub der: Vec<u8>,
    pub subject: String,
    pub entry: Entry,
}

impl Authority {
    /// # Errors
    /// Words saying why the certificate is no authority's.
    pub fn from_pem(text: &str, entry: Entry) -> Result<Authority, String> {
        let der = pem::decode(CERTIFICATE, text)?;
        let certificate = parse(&der)?;
        if !is_authority(&certificate) {
            return Err("a certificate that is no authority's".into());
        }
        anchor_from_trusted_cert(&CertificateDer::from(der.as_slice())).map_err(|e| e.to_string())?;
        Ok(Authority { subject: certificate.tbs_certificate.subject.to_string(), der, entry })
    }

    pub fn sha256(&self) -> String {
        sha256_hex(&self.der)
    }

    /// What the certificate says of itself; `None` for one that cannot be read.
    pub fn validity(&self) -> Option<Validity> {
        Validity::of(&self.der).ok()
    }
}

/// A revocation list that can be read, of DER bytes.
///
/// # Errors
/// Words saying that it cannot.
pub fn check_crl(der: &[u8]) -> Result<(), String> {
    BorrowedCertRevocationList::from_der(der).map(drop).map_err(|e| e.to_string())
}

/// Whether some path leads from the chain to an authority, at a time when the signer's certificate is valid; else why not.
pub fn leads_to(authorities: &[Authority], chain: &CertChain) -> Result<(), String> {
    path(authorities, chain, chain.not_before_ms, &[]).map(drop).map_err(|e| e.to_string())
}

/// What stands against a signature made then by the chain's key, on something marked so. The limits of every authority that
/// answers for the key are its limits.
pub fn judge(
    authorities: &[Authority],
    crls: &[Vec<u8>],
    chain: &CertChain,
    signed: Signed,
    marking: Option<&Marking>,
) -> Vec<Objection> {
    let at = time::format_utc(signed.stated_ms);
    let refused =
        |why: &Refusal| vec![Objection::new(why.code(), format!("a path that holds at {at}"), why.to_string())];
    let limits = |answering: &[&Authority]| {
        let each = answering.iter().map(|authority| authority.entry.judge(signed, marking));
        each.flatten().collect::<Vec<Objection>>()
    };
    let lists: Vec<CertRevocationList<'_>> =
        crls.iter().filter_map(|der| BorrowedCertRevocationList::from_der(der).ok()).map(Into::into).collect();
    let lists: Vec<&CertRevocationList<'_>> = lists.iter().collect();
    match path(authorities, chain, signed.stated_ms, &lists) {
        Ok(answering) => limits(&answering),
        // webpki refuses whenever it happened; the date decides.
        Err(revoked @ Refusal::Path(webpki::Error::CertRevoked)) => {
            let answering = match path(authorities, chain, signed.stated_ms, &[]) {
                Ok(answering) => answering,
                Err(why) => return refused(&why),
            };
            let mut found: Vec<Objection> = revocations(chain, &lists)
                .into_iter()
                .map(|(from_ms, compromised)| {
                    signed.against(from_ms, compromised, "CERT_REVOKED", "CERT_REVOKED_LATER")
                })
                .collect();
            if found.is_empty() {
                return refused(&revoked);
            }
            found.extend(limits(&answering));
            found
        }
        Err(why) => refused(&why),
    }
}

/// Whether the first of these certificates (DER) is a time stamping authority's at that time; else why not.
pub fn check_time_stamping(
    authorities: &[Authority],
    crls: &[Vec<u8>],
    der: &[Vec<u8>],
    at_ms: u64,
) -> Result<(), String> {
    let usages = usages(&parse(der.first().ok_or("no certificate")?)?)?;
    // RFC 3161 §2.3: this usage and no other.
    if usages != [TIME_STAMPING] {
        return Err(format!("extended key usage {:?}, not {TIME_STAMPING} alone", usages.join(" ")));
    }
    let lists: Vec<CertRevocationList<'_>> =
        crls.iter().filter_map(|der| BorrowedCertRevocationList::from_der(der).ok()).map(Into::into).collect();
    let lists: Vec<&CertRevocationList<'_>> = lists.iter().collect();
    path_for(authorities, der, &usages, Some(TIME_STAMPING), at_ms, &lists).map(drop).map_err(|e| e.to_string())
}

/// Verifies a signature by the first certificate's key over a digest of so many bits: the certificate's subject.
pub fn check_signature(der: &[Vec<u8>], message: &[u8], sig: &[u8], digest_bits: usize) -> Result<String, String> {
    let first = der.first().ok_or("no certificate")?;
    let leaf = CertificateDer::from(first.as_slice());
    let leaf = EndEntityCert::try_from(&leaf).map_err(|e| e.to_string())?;
    let fitting = ALGORITHMS.iter().zip(DIGEST_BITS).filter(|(_, bits)| *bits == digest_bits);
    if !fitting.map(|(algorithm, _)| *algorithm).any(|a| leaf.verify_signature(a, message, sig).is_ok()) {
        return Err("a signature that is not good".into());
    }
    Ok(parse(first)?.tbs_certificate.subject.to_string())
}

/// Why a chain leads to no authority.
#[derive(Debug)]
enum Refusal {
    Path(webpki::Error),
    /// The extended key usages of the signer's certificate, and the one that is asked for.
    Usage(String, String),
}

impl Refusal {
    fn code(&self) -> &'static str {
        match self {
            Refusal::Path(webpki::Error::CertExpired { .. } | webpki::Error::CertNotValidYet { .. }) => "CERT_EXPIRED",
            Refusal::Path(webpki::Error::CertRevoked) => "CERT_REVOKED",
            _ => "CERT_UNTRUSTED",
        }
    }
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Refusal::Path(error) => write!(f, "{error}"),
            Refusal::Usage(found, wanted) => write!(f, "extended key usage {found}, not {wanted}"),
        }
    }
}

fn path<'a>(
    authorities: &'a [Authority],
    chain: &CertChain,
    at_ms: u64,
    crls: &[&CertRevocationList<'_>],
) -> Result<Vec<&'a Authority>, Refusal> {
    path_for(authorities, &chain.der, &chain.usages, None, at_ms, crls)
}

/// Every authority that answers for the first certificate, at least one.
///
/// `usage`: the one that is asked for, in place of what each authority asks for.
fn path_for<'a>(
    authorities: &'a [Authority],
    der: &[Vec<u8>],
    usages: &[String],
    usage: Option<&str>,
    at_ms: u64,
    crls: &[&CertRevocationList<'_>],
) -> Result<Vec<&'a Authority>, Refusal> {
    let at = UnixTime::since_unix_epoch(Duration::from_millis(at_ms));
    let certificates: Vec<CertificateDer<'_>> = der.iter().map(|d| CertificateDer::from(d.as_slice())).collect();
    let mut last = Refusal::Path(webpki::Error::UnknownIssuer);
    let Some((leaf, between)) = certificates.split_first() else { return Err(last) };
    let leaf = EndEntityCert::try_from(leaf).map_err(Refusal::Path)?;
    let mut answering = Vec::new();
    for authority in authorities {
        let der = CertificateDer::from(authority.der.as_slice());
        let anchor = anchor_from_trusted_cert(&der).map_err(Refusal::Path)?;
        // No lists, no options.
        let revocation = RevocationOptionsBuilder::new(crls).ok();
        let revocation = revocation.map(|b| b.with_status_policy(UnknownStatusPolicy::Allow).build());
        let wanted = usage.or(authority.entry.eku.as_deref()).unwrap_or(DOCUMENT_SIGNING);
        match leaf.verify_for_usage(&ALGORITHMS, &[anchor], between, at, AnyUsage, revocation, None) {
            Ok(_) if usages.is_empty() || usages.iter().any(|u| u == wanted || u == ANY_USAGE) => {
                answering.push(authority);
            }
            Ok(_) => last = Refusal::Usage(usages.join(" "), wanted.to_owned()),
            Err(webpki::Error::UnknownIssuer) => {}
            Err(other) => last = Refusal::Path(other),
        }
    }
    if answering.is_empty() { Err(last) } else { Ok(answering) }
}

/// When each revoked certificate of the chain was revoked, and whether for a compromise.
fn revocations(chain: &CertChain, crls: &[&CertRevocationList<'_>]) -> Vec<(u64, bool)> {
    let mut out = Vec::new();
    for certificate in chain.der.iter().filter_map(|der| parse(der).ok()) {
        let tbs = &certificate.tbs_certificate;
        let Ok(issuer) = tbs.issuer.to_der() else { continue };
        // webpki gives the issuer without its outer tag and length.
        for list in crls.iter().filter(|l| issuer.ends_with(l.issuer())) {
            if let Ok(Some(entry)) = list.find_serial(tbs.serial_number.as_bytes()) {
                use RevocationReason::{AaCompromise, CaCompromise, KeyCompromise};
                let compromised = matches!(entry.reason_code, Some(KeyCompromise | CaCompromise | AaCompromise));
                let since = entry.invalidity_date.map_or(entry.revocation_date, |d| d.min(entry.revocation_date));
                out.push((since.as_secs() * 1000, compromised));
            }
        }
    }
    out
}

/// Usages are looked at beside the path: each authority has its own rule.
struct AnyUsage;

impl ExtendedKeyUsageValidator for AnyUsage {
    fn validate(&self, _: KeyPurposeIdIter<'_, '_>) -> Result<(), webpki::Error> {
        Ok(())
    }
}

fn parse(der: &[u8]) -> Result<Certificate, String> {
    Certificate::from_der(der).map_err(|e| format!("a damaged certificate ({e})"))
}

/// Extended key usages; none when the certificate leaves it open.
fn usages(certificate: &Certificate) -> Result<Vec<String>, String> {
    let found = certificate.tbs_certificate.get::<ExtendedKeyUsage>().map_err(|e| e.to_string())?;
    Ok(found.map_or(Vec::new(), |(_, usages)| usages.0.iter().map(ToString::to_string).collect()))
}

fn is_authority(certificate: &Certificate) -> bool {
    certificate.tbs_certificate.get::<BasicConstraints>().is_ok_and(|found| found.is_some_and(|(_, c)| c.ca))
}

fn common_name(certificate: &Certificate) -> Option<String> {
    use pkcs8::der::asn1::{PrintableStringRef, Utf8StringRef};
    let attributes = certificate.tbs_certificate.subject.0.iter().flat_map(|rdn| rdn.0.iter());
    let value = &attributes.into_iter().find(|a| a.oid == COMMON_NAME)?.value;
    let text = value.decode_as::<Utf8StringRef<'_>>().map(|s| s.as_str().to_owned());
    text.or_else(|_| value.decode_as::<PrintableStringRef<'_>>().map(|s| s.as_str().to_owned())).ok()
}

/// id-at-commonName.
const COMMON_NAME: pkcs8::ObjectIdentifier = pkcs8::ObjectIdentifier::new_unwrap("2.5.4.3");

/// An algorithm that authorities sign by, carried out by aws-lc-rs.
#[derive(Debug)]
struct ByAwsLc {
    key: AlgorithmIdentifier,
    signature: AlgorithmIdentifier,
    verification: &'static dyn VerificationAlgorithm,
}

impl SignatureVerificationAlgorithm for ByAwsLc {
    fn verify_signature(&self, key: &[u8], message: &[u8], sig: &[u8]) -> Result<(), InvalidSignature> {
        UnparsedPublicKey::new(self.verification, key).verify(message, sig).map_err(|_| InvalidSignature)
    }
    fn public_key_alg_id(&self) -> AlgorithmIdentifier {
        self.key
    }
    fn signature_alg_id(&self) -> AlgorithmIdentifier {
        self.signature
    }
}

macro_rules! by_aws_lc {
    ($key:ident, $signature:ident, $verification:ident) => {
        &ByAwsLc { key: alg_id::$key, signature: alg_id::$signature, verification: &signature::$verification }
    };
}

/// RSA, the two curves of public key infrastructures, and ML-DSA-87 where the build has it; nothing with SHA-1.
static ALGORITHMS: [&dyn SignatureVerificationAlgorithm; if cfg!(feature = "fips") { 5 } else { 6 }] = [
    by_aws_lc!(RSA_ENCRYPTION, RSA_PKCS1_SHA256, RSA_PKCS1_2048_8192_SHA256),
    by_aws_lc!(RSA_ENCRYPTION, RSA_PKCS1_SHA384, RSA_PKCS1_2048_8192_SHA384),
    by_aws_lc!(RSA_ENCRYPTION, RSA_PKCS1_SHA512, RSA_PKCS1_2048_8192_SHA512),
    by_aws_lc!(ECDSA_P256, ECDSA_SHA256, ECDSA_P256_SHA256_ASN1),
    by_aws_lc!(ECDSA_P384, ECDSA_SHA384, ECDSA_P384_SHA384_ASN1),
    #[cfg(not(feature = "fips"))]
    by_aws_lc!(ML_DSA_87, ML_DSA_87, ML_DSA_87),
];
/// The digest of each of them, bits.
const DIGEST_BITS: [usize; 5] = [256, 384, 512, 256, 384];
