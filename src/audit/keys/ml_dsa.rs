//! ML-DSA-87 (FIPS 204), pure, with an empty context: signed and verified by aws-lc-rs, verified again by RustCrypto's
//! `ml-dsa`, which shares nothing with it. Public keys and private ones, as a seed, stand in files as RFC 9881 says.

use aws_lc_rs::encoding::{AsDer as _, PublicKeyX509Der};
use aws_lc_rs::signature::{self, KeyPair as _, ParsedPublicKey, PqdsaKeyPair};
use ml_dsa::signature::Verifier as _;
use ml_dsa::{EncodedVerifyingKey, MlDsa87, Signature, VerifyingKey};
use pkcs8::der::Decode as _;
use pkcs8::spki::SubjectPublicKeyInfoRef;
use zeroize::Zeroizing;

/// A key as both implementations read it.
#[derive(Clone, Debug)]
pub(super) struct Public {
    first: ParsedPublicKey,
    second: Box<VerifyingKey<MlDsa87>>,
}

impl Public {
    /// # Errors
    /// Words saying why the bytes are no ML-DSA-87 key.
    pub fn from_spki(spki: &[u8]) -> Result<Public, String> {
        let none = |e: &dyn std::fmt::Display| format!("not an ML-DSA-87 public key ({e})");
        let info = SubjectPublicKeyInfoRef::from_der(spki).map_err(|e| none(&e))?;
        // RFC 9881 §2: parameters are absent.
        if info.algorithm.parameters.is_some() {
            return Err(none(&"parameters"));
        }
        let bytes = info.subject_public_key.as_bytes().ok_or_else(|| none(&"bits that are no bytes"))?;
        let encoded =
            EncodedVerifyingKey::<MlDsa87>::try_from(bytes).map_err(|_| none(&format!("{} bytes", bytes.len())))?;
        let first = ParsedPublicKey::new(&signature::ML_DSA_87, spki).map_err(|e| none(&e))?;
        Ok(Public { first, second: Box::new(VerifyingKey::decode(&encoded)) })
    }

    /// What each implementation says of the signature.
    pub fn verify(&self, message: &[u8], sig: &[u8]) -> (bool, bool) {
        let second = Signature::<MlDsa87>::try_from(sig).is_ok_and(|sig| self.second.verify(message, &sig).is_ok());
        (self.first.verify_sig(message, sig).is_ok(), second)
    }
}

/// A key pair.
pub(super) struct Pair(PqdsaKeyPair);

impl Pair {
    /// # Errors
    /// Words, when the library fails.
    pub fn generate() -> Result<Pair, String> {
        PqdsaKeyPair::generate(&signature::ML_DSA_87_SIGNING).map(Pair).map_err(|_| "the library failed".into())
    }

    /// # Errors
    /// Words saying why the bytes are no ML-DSA-87 key.
    pub fn from_pkcs8(der: &[u8]) -> Result<Pair, String> {
        PqdsaKeyPair::from_pkcs8(&signature::ML_DSA_87_SIGNING, der).map(Pair).map_err(|e| e.to_string())
    }

    /// # Errors
    /// Words, for a key that was read without its seed.
    pub fn to_pkcs8(&self) -> Result<Zeroizing<Vec<u8>>, String> {
        let der = self.0.to_pkcs8v1().map_err(|_| "a key without its seed")?;
        Ok(Zeroizing::new(der.as_ref().to_vec()))
    }

    /// # Errors
    /// Words, when the library fails.
    pub fn spki(&self) -> Result<Vec<u8>, String> {
        let der: PublicKeyX509Der<'_> = self.0.public_key().as_der().map_err(|_| "the library failed")?;
        Ok(der.as_ref().to_vec())
    }

    /// Hedged (FIPS 204 §3.4): another signature every time.
    ///
    /// # Errors
    /// Words, when the library fails.
    pub fn sign(&self, message: &[u8]) -> Result<Vec<u8>, String> {
        let mut sig = vec![0; self.0.algorithm().signature_len()];
        let length = self.0.sign(message, &mut sig).map_err(|_| "the library failed")?;
        sig.truncate(length);
        Ok(sig)
    }
}
