//! Private keys under a passphrase: PKCS#8 EncryptedPrivateKeyInfo (RFC 5958 §3), PBES2 (RFC 8018 §6.2). Written with PBKDF2,
//! HMAC-SHA-256 and AES-256-CBC, which FIPS 140 modules know; read also with scrypt.

use pkcs8::pkcs5::pbes2;
use pkcs8::{EncryptedPrivateKeyInfo, PrivateKeyInfo, SecretDocument};

use crate::{Error, Result};

/// Of the PEM block.
pub(super) const LABEL: &str = "ENCRYPTED PRIVATE KEY";
/// Rounds of PBKDF2: a third of a second of a processor for every guess.
const ROUNDS: u32 = 600_000;
/// More than anybody writes; a file that asks for more would only hold the machine up.
const MAX_ROUNDS: u32 = 20_000_000;

/// The PKCS#8 document inside; `Err` in words.
pub(super) fn decrypt(der: &[u8], passphrase: &str) -> std::result::Result<SecretDocument, String> {
    let sealed = EncryptedPrivateKeyInfo::try_from(der).map_err(|e| format!("a damaged encrypted key ({e})"))?;
    let rounds = sealed.encryption_algorithm.pbes2().and_then(|p| p.kdf.pbkdf2()).map(|p| p.iteration_count);
    if rounds.is_some_and(|n| n > MAX_ROUNDS) {
        return Err(format!("{} rounds of PBKDF2; at most {MAX_ROUNDS} are done", rounds.unwrap_or_default()));
    }
    sealed.decrypt(passphrase).map_err(|_| "another passphrase, or an encryption that is not supported".to_owned())
}

/// `pkcs8` under `passphrase`, with fresh salt and initialisation vector.
pub(super) fn encrypt(pkcs8: &[u8], passphrase: &str) -> Result<SecretDocument> {
    let failed = |e: String| Error::environment("encrypting the key").found(e);
    if passphrase.is_empty() {
        return Err(Error::usage("passphrase").expected("at least one character").found("none"));
    }
    let (mut salt, mut iv) = ([0; 16], [0; 16]);
    getrandom::fill(&mut salt).and_then(|()| getrandom::fill(&mut iv)).map_err(|e| failed(e.to_string()))?;
    let parameters =
        pbes2::Parameters::pbkdf2_sha256_aes256cbc(ROUNDS, &salt, &iv).map_err(|e| failed(e.to_string()))?;
    let key = PrivateKeyInfo::try_from(pkcs8).map_err(|e| failed(e.to_string()))?;
    key.encrypt_with_params(parameters, passphrase).map_err(|e| failed(e.to_string()))
}
