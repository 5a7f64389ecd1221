//! RSASSA-PKCS1-v1_5 verification (RFC 8017 §8.2.2) for the second time: the modular arithmetic of `crypto-bigint`, the
//! digests of `sha2`; nothing is shared with aws-lc-rs. Public values only, so nothing here needs constant time.
//!
//! The encoded message is built and compared, never parsed.

use crypto_bigint::modular::{BoxedMontyForm, BoxedMontyParams};
use crypto_bigint::{BoxedUint, Odd};
use pkcs8::der::Decode as _;
use pkcs8::spki::SubjectPublicKeyInfoRef;
use sha2::{Digest as _, Sha256, Sha384};

use super::Algorithm;
use super::public::RSA_ENCRYPTION;

/// DER of DigestInfo up to the digest, RFC 8017 §9.2, note 1.
const SHA256_INFO: [u8; 19] = *b"\x30\x31\x30\x0d\x06\x09\x60\x86\x48\x01\x65\x03\x04\x02\x01\x05\x00\x04\x20";
const SHA384_INFO: [u8; 19] = *b"\x30\x41\x30\x0d\x06\x09\x60\x86\x48\x01\x65\x03\x04\x02\x02\x05\x00\x04\x30";

/// A modulus, ready for arithmetic, and a public exponent.
#[derive(Clone, Debug)]
pub(super) struct Second {
    modulus: BoxedMontyParams,
    exponent: u64,
    bits: usize,
}

impl Second {
    /// # Errors
    /// Words saying why the bytes are no RSA key that can be used: the caller judges its strength.
    pub fn from_spki(der: &[u8]) -> Result<Second, String> {
        let none = |e: &dyn std::fmt::Display| format!("not an RSA public key ({e})");
        let info = SubjectPublicKeyInfoRef::from_der(der).map_err(|e| none(&e))?;
        if info.algorithm.oid != RSA_ENCRYPTION || !info.algorithm.parameters.is_some_and(|p| p.is_null()) {
            return Err(none(&format!("algorithm {}", info.algorithm.oid)));
        }
        let key = info.subject_public_key.as_bytes().ok_or_else(|| none(&"bits that are no bytes"))?;
        let key = pkcs1::RsaPublicKey::from_der(key).map_err(|e| none(&e))?;
        let (n, e) = (key.modulus.as_bytes(), key.public_exponent.as_bytes());
        // RFC 8017 leaves the exponent open; eight bytes hold every one in use, and bound the work of verifying.
        let exponent = (e.len() <= 8).then(|| e.iter().fold(0, |all, b| all << 8 | u64::from(*b)));
        let exponent = exponent.ok_or_else(|| none(&"a public exponent beyond 64 bits"))?;
        let modulus = Option::from(Odd::new(integer(n)?)).ok_or_else(|| none(&"an even modulus"))?;
        let bits = n.len() * 8 - n.first().map_or(0, |b| b.leading_zeros() as usize);
        Ok(Second { modulus: BoxedMontyParams::new_vartime(modulus), exponent, bits })
    }

    pub fn bits(&self) -> usize {
        self.bits
    }

    pub fn exponent(&self) -> u64 {
        self.exponent
    }

    pub fn verify(&self, algorithm: Algorithm, message: &[u8], sig: &[u8]) -> bool {
        let length = self.bits.div_ceil(8);
        let modulus = self.modulus.modulus().as_ref();
        let Some(s) = (sig.len() == length).then(|| integer(sig).ok()).flatten().filter(|s| s < modulus) else {
            return false;
        };
        let encoded = digest_info(algorithm, message).and_then(|info| encode(&info, length));
        let recovered = self.power(&s).to_be_bytes_trimmed_vartime();
        // The encoded message begins with a zero, which an integer does not show.
        encoded.is_some_and(|encoded| encoded[1..] == *recovered)
    }

    /// s^e mod n.
    fn power(&self, s: &BoxedUint) -> BoxedUint {
        let base = BoxedMontyForm::new(s.clone(), &self.modulus);
        let mut power = base.clone();
        // Square and multiply, from the bit after the exponent's highest.
        for bit in (0..self.exponent.max(1).ilog2()).rev() {
            power = power.square();
            if self.exponent >> bit & 1 == 1 {
                power = power.mul(&base);
            }
        }
        power.retrieve()
    }
}

fn integer(bytes: &[u8]) -> Result<BoxedUint, String> {
    let bits = u32::try_from(bytes.len() * 8).map_err(|e| e.to_string())?;
    BoxedUint::from_be_slice(bytes, bits).map_err(|e| e.to_string())
}

/// DigestInfo of a message, DER (RFC 8017 §9.2, steps 1 and 2); `None` for what is not RSA.
pub(super) fn digest_info(algorithm: Algorithm, message: &[u8]) -> Option<Vec<u8>> {
    match algorithm {
        Algorithm::Rs256 => Some([&SHA256_INFO[..], &Sha256::digest(message)].concat()),
        Algorithm::Rs384 => Some([&SHA384_INFO[..], &Sha384::digest(message)].concat()),
        Algorithm::MlDsa87 => None,
    }
}

/// EMSA-PKCS1-v1_5 (RFC 8017 §9.2) of so many bytes; `None` when they are too few.
fn encode(info: &[u8], length: usize) -> Option<Vec<u8>> {
    let padding = length.checked_sub(info.len() + 3).filter(|n| *n >= 8)?;
    Some([&[0, 1], &vec![0xff; padding][..], &[0], info].concat())
}
