//! Signing keys: RSA, PKCS#1 v1.5 (RFC 8017 §8.2), and ML-DSA-87 (FIPS 204), made and used by aws-lc-rs.
//!
//! A first run makes an RSA key of 3072 bits in the user's data folder, readable by that user only. Such a key gives
//! integrity; it does not bind a person, and anything above UNCLASSIFIED asks for a key that was named on purpose.

mod algorithm;
mod encrypted;
mod file;
mod for_run;
#[cfg(not(feature = "fips"))]
mod ml_dsa;
#[cfg(feature = "fips")]
mod no_ml_dsa;
mod public;
mod second;
mod token;

use std::path::{Path, PathBuf};

use aws_lc_rs::encoding::{AsDer as _, PublicKeyX509Der};
use aws_lc_rs::rand::SystemRandom;
use aws_lc_rs::rsa::{KeyPair, KeySize};
use aws_lc_rs::signature::KeyPair as _;
use zeroize::Zeroizing;

use super::disk;
use super::dsse::Signature;
use super::pem;
use super::trust::CertChain;
use crate::{Error, Result};
pub use algorithm::{Algorithm, Bits, Suite};
pub use file::{passphrase_file, private_file};
pub use for_run::{KeyForRun, for_marking, keygen};
pub(super) use for_run::{has_own, own};
#[cfg(feature = "fips")]
use no_ml_dsa as ml_dsa;
pub use public::{ADVISED_BITS, PublicKey};
use token::Token;

/// Where a signing key came from: `actor.key_source` of the record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KeySource {
    /// Made by Orb in the user's data folder on the first run.
    UserData,
    /// Named by `--key`.
    NamedFile,
    /// In a PKCS#11 token, which it never leaves.
    Token,
}

impl KeySource {
    pub fn name(self) -> &'static str {
        match self {
            KeySource::UserData => "user-data-file",
            KeySource::NamedFile => "named-file",
            KeySource::Token => "pkcs11",
        }
    }
}

/// Where the private half is.
enum Holder {
    Rsa(KeyPair),
    MlDsa87(ml_dsa::Pair),
    Token(Token),
}

impl Holder {
    fn spki(&self) -> Result<Vec<u8>, String> {
        match self {
            Holder::Rsa(pair) => {
                let der: PublicKeyX509Der<'_> =
                    pair.public_key().as_der().map_err(|_| "the public key cannot be encoded")?;
                Ok(der.as_ref().to_vec())
            }
            Holder::MlDsa87(pair) => pair.spki(),
            Holder::Token(token) => Ok(token.spki().to_vec()),
        }
    }
}

/// A key pair that can sign, or the two of a hybrid signer.
pub struct SigningKey {
    holder: Holder,
    public: PublicKey,
    source: KeySource,
    algorithm: Algorithm,
    chain: Option<CertChain>,
    /// The ML-DSA key of a hybrid signer: both sign everything.
    partner: Option<Box<SigningKey>>,
}

impl std::fmt::Debug for SigningKey {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SigningKey").field("fingerprint", &self.public.fingerprint()).finish_non_exhaustive()
    }
}

/// Where a passphrase comes from; read only when a key needs it.
pub trait Passphrase {
    /// # Errors
    /// When there is none.
    fn read(&self) -> Result<Zeroizing<String>>;
}

/// A key file that was named, and what opens it.
#[derive(Clone, Copy)]
pub struct Named<'a> {
    pub path: &'a Path,
    pub passphrase: Option<&'a dyn Passphrase>,
    /// How RSA signs; else as the key suggests.
    pub algorithm: Option<Algorithm>,
    /// The key's certificates.
    pub chain: Option<&'a Path>,
}

impl<'a> From<&'a Path> for Named<'a> {
    fn from(path: &'a Path) -> Self {
        Named { path, passphrase: None, algorithm: None, chain: None }
    }
}

impl<'a> From<&'a PathBuf> for Named<'a> {
    fn from(path: &'a PathBuf) -> Self {
        Named::from(path.as_path())
    }
}

impl SigningKey {
    /// A new RSA key of so many bits, 3072 or 4096; takes about a third of a second.
    ///
    /// # Errors
    /// [`crate::Kind::Environment`] when the system gives no randomness.
    pub fn generate(source: KeySource, bits: Bits) -> Result<SigningKey> {
        let size = match bits {
            Bits::B3072 => KeySize::Rsa3072,
            Bits::B4096 => KeySize::Rsa4096,
        };
        let failed = |found: String| Error::environment("key generation").found(found);
        let pair = KeyPair::generate(size).map_err(|_| failed("the cryptographic library failed".into()))?;
        SigningKey::new(Holder::Rsa(pair), source).map_err(failed)
    }

    /// A new key, or two, as a suite asks for.
    ///
    /// # Errors
    /// As [`SigningKey::generate`]; [`crate::Kind::Policy`], `ALG_REFUSED`, for ML-DSA in a build without it.
    pub fn generate_for(suite: Suite, source: KeySource, bits: Bits) -> Result<SigningKey> {
        let refused = |found: String| Error::policy("--profile").found(format!("ALG_REFUSED: {found}"));
        let ml_dsa = || SigningKey::new(Holder::MlDsa87(ml_dsa::Pair::generate()?), source);
        match suite {
            Suite::Default => SigningKey::generate(source, bits),
            Suite::Cnsa1 => SigningKey::generate(source, bits)?.with_algorithm(Algorithm::Rs384),
            Suite::Cnsa2 => ml_dsa().map_err(refused),
            Suite::Hybrid => {
                let second = ml_dsa().map_err(refused)?;
                let first = SigningKey::generate(source, bits)?;
                SigningKey::of_one_or_two(vec![first, second]).map_err(refused)?.with_algorithm(Algorithm::Rs384)
            }
        }
    }

    fn new(holder: Holder, source: KeySource) -> Result<SigningKey, String> {
        let public = PublicKey::from_spki(&holder.spki()?)?;
        let algorithm = public.algorithms().first().copied().unwrap_or_default();
        Ok(SigningKey { holder, public, source, algorithm, chain: None, partner: None })
    }

    /// One key, or an RSA and an ML-DSA key that sign together.
    fn of_one_or_two(keys: Vec<SigningKey>) -> Result<SigningKey, String> {
        let mut keys = keys.into_iter();
        match (keys.next(), keys.next(), keys.next()) {
            (Some(key), None, None) => Ok(key),
            (Some(first), Some(second), None)
                if first.public.rsa_bits().is_some() && second.public.rsa_bits().is_none() =>
            {
                Ok(SigningKey { partner: Some(Box::new(second)), ..first })
            }
            _ => Err(public::NO_PAIR.into()),
        }
    }

    /// Reads a PKCS#8 PEM file, encrypted or not, that only its owner can read; or finds a key in a PKCS#11 token, by a
    /// URI of RFC 7512 that says where its module is: `pkcs11:token=NAME;object=NAME?module-path=/path/to/module.so`.
    ///
    /// # Errors
    /// [`crate::Kind::Environment`] when the file cannot be read; [`crate::Kind::Policy`] when others may read it or the
    /// key is too weak; [`crate::Kind::Usage`] when it is not a key.
    pub fn load<'a>(named: impl Into<Named<'a>>, source: KeySource) -> Result<SigningKey> {
        let Named { path, passphrase, algorithm, chain } = named.into();
        let key = match path.to_str().filter(|name| name.starts_with(token::SCHEME)) {
            Some(uri) => SigningKey::new(Holder::Token(Token::open(uri, passphrase)?), KeySource::Token)
                .map_err(|found| Error::policy("--key").found(format!("ALG_REFUSED: {found}")))?,
            None => file::load(path, passphrase, source)?,
        };
        // Beside ML-DSA, RSA keeps to SHA-384 too.
        let suggested = if key.partner.is_some() { Algorithm::Rs384 } else { key.algorithm };
        let key = key.with_algorithm(algorithm.unwrap_or(suggested))?;
        match chain {
            None => Ok(key),
            Some(chain) => key.with_chain(chain),
        }
    }

    /// Writes the private key (mode 0600 from its creation), under a passphrase if one is given, and beside it
    /// `FILE.pub.pem`. Never over a file.
    ///
    /// # Errors
    /// [`crate::Kind::Usage`] when one of them exists; [`crate::Kind::Environment`] when they cannot be written.
    pub fn save(&self, path: &Path, passphrase: Option<&str>) -> Result<()> {
        file::save(self, path, passphrase)
    }

    /// This key's own signature. By RSA, which is as long as the modulus, the same message gives the same signature; by
    /// ML-DSA another each time.
    ///
    /// # Errors
    /// [`crate::Kind::Environment`] when the library fails.
    pub fn sign(&self, message: &[u8]) -> Result<Vec<u8>> {
        let failed = || Error::environment("signing").found("the cryptographic library failed");
        match &self.holder {
            Holder::Token(token) => token.sign(self.algorithm, message),
            Holder::MlDsa87(pair) => pair.sign(message).map_err(|_| failed()),
            Holder::Rsa(pair) => {
                let mut sig = vec![0; pair.public_modulus_len()];
                let encoding = self.algorithm.rsa_encoding().ok_or_else(failed)?;
                pair.sign(encoding, &SystemRandom::new(), message, &mut sig).map_err(|_| failed())?;
                Ok(sig)
            }
        }
    }

    /// The signatures of an envelope over `pae`: one, or both of a hybrid signer.
    ///
    /// # Errors
    /// As [`SigningKey::sign`].
    pub fn signatures(&self, pae: &[u8]) -> Result<Vec<Signature>> {
        self.all().map(|k| Ok(Signature { keyid: k.public.fingerprint().to_owned(), sig: k.sign(pae)? })).collect()
    }

    /// The key and, of a hybrid signer, the other one.
    pub fn all(&self) -> impl Iterator<Item = &SigningKey> {
        std::iter::once(self).chain(self.partner())
    }

    /// The ML-DSA key of a hybrid signer.
    pub fn partner(&self) -> Option<&SigningKey> {
        self.partner.as_deref()
    }

    pub fn public(&self) -> &PublicKey {
        &self.public
    }

    pub fn source(&self) -> KeySource {
        self.source
    }

    pub fn algorithm(&self) -> Algorithm {
        self.algorithm
    }

    /// The same key, signing by `algorithm`; of a hybrid signer the RSA key.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `ALG_REFUSED`, where the profile that the algorithm belongs to wants a longer key, or
    /// another one.
    pub fn with_algorithm(self, algorithm: Algorithm) -> Result<SigningKey> {
        let refused = |expected: String| {
            Error::policy(format!("--sign-algorithm {}", algorithm.name()))
                .expected(expected)
                .found(format!("ALG_REFUSED: a key of {}", self.public.kind()))
        };
        if !self.public.algorithms().contains(&algorithm) {
            let names: Vec<&str> = self.public.algorithms().iter().map(|a| a.name()).collect();
            let advice = if self.source == KeySource::Token { token::NOT_IN_TOKENS } else { "" };
            return Err(refused(names.join(" or ")).advice(advice));
        }
        if algorithm == Algorithm::Rs384 && self.public.short_bits().is_some() {
            return Err(refused(format!("an RSA key of {ADVISED_BITS} bits or more")));
        }
        Ok(SigningKey { algorithm, ..self })
    }

    /// The certificates that say whose key it is.
    pub fn chain(&self) -> Option<&CertChain> {
        self.chain.as_ref()
    }

    /// The same key with the certificates of a PEM file, the signer's own first.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `CERT_REFUSED`, for a file that holds none, or another key's;
    /// [`crate::Kind::Environment`] when it cannot be read.
    pub fn with_chain(self, path: &Path) -> Result<SigningKey> {
        let refused = |found: String| {
            Error::policy(path.display().to_string())
                .expected("the certificate of the signing key, then those up to an authority, in PEM form")
                .found(format!("CERT_REFUSED: {found}"))
        };
        let bytes = disk::read_limited(path, pem::MAX_BYTES)?;
        let chain = CertChain::from_pem(&String::from_utf8_lossy(&bytes)).map_err(refused)?;
        if *chain.key() != self.public {
            return Err(refused(format!("a certificate of the key {}", chain.key().fingerprint())));
        }
        Ok(SigningKey { chain: Some(chain), ..self })
    }
}

#[cfg(test)]
pub(crate) mod suite_tests;
#[cfg(test)]
pub(crate) mod tests;
