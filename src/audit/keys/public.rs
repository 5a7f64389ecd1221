//! Public keys, and the verification of signatures: each by two implementations that share nothing.

use aws_lc_rs::signature::{self, ParsedPublicKey, RsaParameters};
use pkcs8::spki::SubjectPublicKeyInfoRef;
use pkcs8::{ObjectIdentifier, der::Decode as _};

use super::algorithm::Algorithm;
use super::ml_dsa;
use super::second::Second;
use crate::audit::canonical::sha256_hex;
use crate::audit::pem;

pub(super) const PUBLIC_LABEL: &str = "PUBLIC KEY";
/// Accepted sizes of an RSA modulus, bits.
pub(super) const MIN_BITS: usize = 2048;
pub(super) const MAX_BITS: usize = 4096;
const MIN_EXPONENT: u64 = 65_537;
/// Below this an RSA key works, with a warning.
pub const ADVISED_BITS: usize = 3072;
/// rsaEncryption, RFC 8017 appendix A.1.
pub(super) const RSA_ENCRYPTION: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.1.1");
/// id-ml-dsa-87, RFC 9881 §2.
pub(super) const ML_DSA_87: ObjectIdentifier = ObjectIdentifier::new_unwrap("2.16.840.1.101.3.4.3.19");

/// A public key, as SubjectPublicKeyInfo (RFC 5280 §4.1.2.7).
#[derive(Clone, Debug)]
pub struct PublicKey {
    spki: Vec<u8>,
    kind: Kind,
    fingerprint: String,
}

#[derive(Clone, Debug)]
enum Kind {
    Rsa(Box<Rsa>),
    MlDsa87(ml_dsa::Public),
}

/// The same key as both implementations read it.
#[derive(Clone, Debug)]
struct Rsa {
    /// Of aws-lc-rs, for each of [`Algorithm::RSA`].
    first: [ParsedPublicKey; 2],
    second: Second,
}

/// Two keys are the same when their bytes are.
impl PartialEq for PublicKey {
    fn eq(&self, other: &PublicKey) -> bool {
        self.spki == other.spki
    }
}

impl Eq for PublicKey {}

impl PublicKey {
    /// # Errors
    /// Words saying why the key is refused: neither RSA of 2048 to 4096 bits with a public exponent of 65537 or more, nor
    /// ML-DSA-87; or a build that cannot verify ML-DSA.
    pub fn from_spki(spki: &[u8]) -> Result<PublicKey, String> {
        let info = SubjectPublicKeyInfoRef::from_der(spki).map_err(|e| format!("no public key ({e})"))?;
        let kind = match info.algorithm.oid {
            RSA_ENCRYPTION => Kind::Rsa(Box::new(Rsa::from_spki(spki)?)),
            ML_DSA_87 => Kind::MlDsa87(ml_dsa::Public::from_spki(spki)?),
            other => return Err(format!("a key of the algorithm {other}; RSA and ML-DSA-87 are accepted")),
        };
        Ok(PublicKey { spki: spki.to_vec(), kind, fingerprint: sha256_hex(spki) })
    }

    pub fn from_pem(text: &str) -> Result<PublicKey, String> {
        PublicKey::from_spki(&pem::decode(PUBLIC_LABEL, text)?)
    }

    /// One key, or the two of a hybrid signer: RSA, then ML-DSA.
    pub fn all_from_pem(text: &str) -> Result<Vec<PublicKey>, String> {
        let keys: Vec<PublicKey> = pem::blocks(text).into_iter().map(PublicKey::from_pem).collect::<Result<_, _>>()?;
        match &keys[..] {
            [_] => Ok(keys),
            [first, second] if first.rsa_bits().is_some() && second.rsa_bits().is_none() => Ok(keys),
            _ => Err(NO_PAIR.into()),
        }
    }

    pub fn to_pem(&self) -> String {
        pem::encode(PUBLIC_LABEL, &self.spki)
    }

    /// SHA-256 of the SubjectPublicKeyInfo, lower-case hexadecimal; what `openssl pkey -pubin -outform DER | sha256sum`
    /// prints.
    pub fn fingerprint(&self) -> &str {
        &self.fingerprint
    }

    /// Length of an RSA key's modulus.
    pub fn rsa_bits(&self) -> Option<usize> {
        match &self.kind {
            Kind::Rsa(rsa) => Some(rsa.second.bits()),
            Kind::MlDsa87(_) => None,
        }
    }

    /// Shorter than is advised.
    pub fn short_bits(&self) -> Option<usize> {
        self.rsa_bits().filter(|bits| *bits < ADVISED_BITS)
    }

    /// `RSA-3072`, `ML-DSA-87`.
    pub fn kind(&self) -> String {
        self.rsa_bits().map_or_else(|| Algorithm::MlDsa87.name().to_owned(), |bits| format!("RSA-{bits}"))
    }

    /// What a key of this kind can sign by, weakest first.
    pub fn algorithms(&self) -> &'static [Algorithm] {
        match self.kind {
            Kind::Rsa(_) => &Algorithm::RSA,
            Kind::MlDsa87(_) => &[Algorithm::MlDsa87],
        }
    }

    /// True only when two independent implementations, aws-lc-rs and another, both accept the signature.
    /// `Err` when they disagree, which must never happen.
    pub fn verify_by(&self, algorithm: Algorithm, message: &[u8], sig: &[u8]) -> Result<bool, String> {
        let (first, second) = match (&self.kind, algorithm) {
            (Kind::Rsa(rsa), Algorithm::Rs256 | Algorithm::Rs384) => (
                rsa.first[usize::from(algorithm == Algorithm::Rs384)].verify_sig(message, sig).is_ok(),
                rsa.second.verify(algorithm, message, sig),
            ),
            (Kind::MlDsa87(key), Algorithm::MlDsa87) => key.verify(message, sig),
            _ => (false, false),
        };
        if first == second {
            Ok(first)
        } else {
            Err(format!("aws-lc-rs says {first}, the second implementation says {second}"))
        }
    }

    /// The algorithm by which [`PublicKey::verify_by`] accepts the signature: a DSSE envelope does not name it.
    pub fn verify(&self, message: &[u8], sig: &[u8]) -> Result<Option<Algorithm>, String> {
        for algorithm in self.algorithms() {
            if self.verify_by(*algorithm, message, sig)? {
                return Ok(Some(*algorithm));
            }
        }
        Ok(None)
    }

    /// The algorithm of a signature that is good, but by one that proves nothing here: `None` for a bad signature. Only for
    /// words in a finding.
    pub fn refused_algorithm(&self, message: &[u8], sig: &[u8]) -> Option<&'static str> {
        self.rsa_bits()?;
        let known: [(&str, &'static RsaParameters); 5] = [
            ("RSASSA-PKCS1-v1_5 with SHA-1", &signature::RSA_PKCS1_2048_8192_SHA1_FOR_LEGACY_USE_ONLY),
            ("RS512", &signature::RSA_PKCS1_2048_8192_SHA512),
            ("PS256", &signature::RSA_PSS_2048_8192_SHA256),
            ("PS384", &signature::RSA_PSS_2048_8192_SHA384),
            ("PS512", &signature::RSA_PSS_2048_8192_SHA512),
        ];
        let verifies = |parameters: &&'static RsaParameters| {
            ParsedPublicKey::new(*parameters, &self.spki).is_ok_and(|key| key.verify_sig(message, sig).is_ok())
        };
        known.into_iter().find(|(_, parameters)| verifies(parameters)).map(|(name, _)| name)
    }
}

/// Two keys that are no hybrid signer's.
pub(super) const NO_PAIR: &str = "several keys that are not one RSA key and one ML-DSA-87 key after it";

impl Rsa {
    fn from_spki(spki: &[u8]) -> Result<Rsa, String> {
        let second = Second::from_spki(spki)?;
        let (bits, exponent) = (second.bits(), second.exponent());
        if !(MIN_BITS..=MAX_BITS).contains(&bits) {
            return Err(format!("an RSA key of {bits} bits; {MIN_BITS} to {MAX_BITS} are accepted"));
        }
        if exponent < MIN_EXPONENT || exponent % 2 == 0 {
            return Err(format!(
                "an RSA key with the public exponent {exponent}; {MIN_EXPONENT} or more, odd, is accepted"
            ));
        }
        let parse = |algorithm: Algorithm| {
            let parameters = algorithm.rsa_verification().ok_or("not an RSA algorithm")?;
            ParsedPublicKey::new(parameters, spki).map_err(|e| format!("not an RSA public key ({e})"))
        };
        Ok(Rsa { first: [parse(Algorithm::Rs256)?, parse(Algorithm::Rs384)?], second })
    }
}
