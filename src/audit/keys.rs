//! Signing keys: RSA, PKCS#1 v1.5, SHA-256 (RFC 8017 §8.2), made and used by aws-lc-rs.
//!
//! A first run makes a key of 3072 bits in the user's data folder, readable by that user only. Such a key gives
//! integrity; it does not bind a person, and anything above UNCLASSIFIED asks for a key that was named on purpose.

mod encrypted;
mod second;
mod token;

use std::fs::{self, File, OpenOptions};
use std::io::Write as _;
use std::path::Path;

use aws_lc_rs::encoding::{AsDer, Pkcs8V1Der, PublicKeyX509Der};
use aws_lc_rs::rand::SystemRandom;
use aws_lc_rs::rsa::{KeyPair, KeySize};
use aws_lc_rs::signature::{self, KeyPair as _, ParsedPublicKey, RsaParameters, RsaSignatureEncoding};
use serde::{Deserialize, Serialize};
use zeroize::Zeroizing;

use super::canonical::sha256_hex;
use super::data_folder::DataFolder;
use super::disk::{self, Disk};
use super::marking::Marking;
use super::pem;
use super::time;
use super::trust::{self, CertChain, Signed, TrustStore};
use crate::{Error, Kind, Result};
use second::Second;
use token::Token;

/// A signature algorithm: RSASSA-PKCS1-v1_5 and a digest, by its name in RFC 7518 §3.3.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
pub enum Algorithm {
    /// With SHA-256.
    #[default]
    #[serde(rename = "RS256")]
    #[value(name = "RS256", alias = "rs256")]
    Rs256,
    /// With SHA-384, as CNSA 1.0 asks for together with 3072 bits or more.
    #[serde(rename = "RS384")]
    #[value(name = "RS384", alias = "rs384")]
    Rs384,
}

impl Algorithm {
    /// All of them, strongest last.
    pub const ALL: [Algorithm; 2] = [Algorithm::Rs256, Algorithm::Rs384];

    pub fn name(self) -> &'static str {
        match self {
            Algorithm::Rs256 => "RS256",
            Algorithm::Rs384 => "RS384",
        }
    }

    /// Records signed so state SHA-384 beside SHA-256 of every output.
    pub fn with_sha384(self) -> bool {
        self == Algorithm::Rs384
    }

    fn encoding(self) -> &'static RsaSignatureEncoding {
        match self {
            Algorithm::Rs256 => &signature::RSA_PKCS1_SHA256,
            Algorithm::Rs384 => &signature::RSA_PKCS1_SHA384,
        }
    }

    fn verification(self) -> &'static RsaParameters {
        match self {
            Algorithm::Rs256 => &signature::RSA_PKCS1_2048_8192_SHA256,
            Algorithm::Rs384 => &signature::RSA_PKCS1_2048_8192_SHA384,
        }
    }
}

/// The user's own key, in the data folder's `keys`.
const OWN_KEY: &str = "orb-signing.pem";
const PRIVATE_LABEL: &str = "PRIVATE KEY";
const PUBLIC_LABEL: &str = "PUBLIC KEY";
/// Accepted sizes of the modulus, bits.
const MIN_BITS: usize = 2048;
const MAX_BITS: usize = 4096;
const MIN_EXPONENT: u64 = 65_537;
/// Below this a key works, with a warning.
pub const ADVISED_BITS: usize = 3072;

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

/// Sizes of keys that Orb makes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Bits {
    #[default]
    #[value(name = "3072")]
    B3072,
    #[value(name = "4096")]
    B4096,
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

/// A public key, as SubjectPublicKeyInfo (RFC 5280 §4.1.2.7).
#[derive(Clone, Debug)]
pub struct PublicKey {
    spki: Vec<u8>,
    /// The key as aws-lc-rs reads it, for each of [`Algorithm::ALL`].
    first: [ParsedPublicKey; 2],
    /// The same key as the second implementation reads it.
    second: Second,
    fingerprint: String,
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
    /// Words saying why the key is refused: not RSA, outside 2048..=4096 bits, or a public exponent below 65537.
    pub fn from_spki(spki: &[u8]) -> Result<PublicKey, String> {
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
            ParsedPublicKey::new(algorithm.verification(), spki).map_err(|e| format!("not an RSA public key ({e})"))
        };
        let first = [parse(Algorithm::Rs256)?, parse(Algorithm::Rs384)?];
        Ok(PublicKey { spki: spki.to_vec(), first, second, fingerprint: sha256_hex(spki) })
    }

    pub fn from_pem(text: &str) -> Result<PublicKey, String> {
        PublicKey::from_spki(&pem::decode(PUBLIC_LABEL, text)?)
    }

    pub fn to_pem(&self) -> String {
        pem::encode(PUBLIC_LABEL, &self.spki)
    }

    /// SHA-256 of the SubjectPublicKeyInfo, lower-case hexadecimal; what `openssl pkey -pubin -outform DER | sha256sum`
    /// prints.
    pub fn fingerprint(&self) -> &str {
        &self.fingerprint
    }

    pub fn bits(&self) -> usize {
        self.second.bits()
    }

    /// True only when two independent implementations, aws-lc-rs and [`second`], both accept the signature.
    /// `Err` when they disagree, which must never happen.
    pub fn verify_by(&self, algorithm: Algorithm, message: &[u8], sig: &[u8]) -> Result<bool, String> {
        let first = self.first[algorithm as usize].verify_sig(message, sig).is_ok();
        let second = self.second.verify(algorithm, message, sig);
        if first == second {
            Ok(first)
        } else {
            Err(format!("aws-lc-rs says {first}, the second implementation says {second}"))
        }
    }

    /// The algorithm by which [`PublicKey::verify_by`] accepts the signature: a DSSE envelope does not name it.
    pub fn verify(&self, message: &[u8], sig: &[u8]) -> Result<Option<Algorithm>, String> {
        for algorithm in Algorithm::ALL {
            if self.verify_by(algorithm, message, sig)? {
                return Ok(Some(algorithm));
            }
        }
        Ok(None)
    }
}

impl PublicKey {
    /// The algorithm of a signature that is good, but by one that proves nothing here: `None` for a bad signature. Only for
    /// words in a finding.
    pub fn refused_algorithm(&self, message: &[u8], sig: &[u8]) -> Option<&'static str> {
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

/// Where the private half is.
enum Holder {
    Memory(KeyPair),
    Token(Token),
}

/// A key pair that can sign.
pub struct SigningKey {
    holder: Holder,
    public: PublicKey,
    source: KeySource,
    algorithm: Algorithm,
    chain: Option<CertChain>,
}

impl std::fmt::Debug for SigningKey {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SigningKey").field("fingerprint", &self.public.fingerprint).finish_non_exhaustive()
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
    pub algorithm: Algorithm,
    /// The key's certificates.
    pub chain: Option<&'a Path>,
}

impl<'a> From<&'a Path> for Named<'a> {
    fn from(path: &'a Path) -> Self {
        Named { path, passphrase: None, algorithm: Algorithm::default(), chain: None }
    }
}

impl<'a> From<&'a std::path::PathBuf> for Named<'a> {
    fn from(path: &'a std::path::PathBuf) -> Self {
        Named::from(path.as_path())
    }
}

/// The first line of a file that only its owner can read.
///
/// # Errors
/// [`Kind::Policy`], `KEY_PERMISSIONS`; [`Kind::Environment`] when it cannot be read; [`Kind::Usage`] when it is no text.
pub fn passphrase_file(path: &Path) -> Result<Zeroizing<String>> {
    let metadata = fs::metadata(path).map_err(|e| Error::io(path, &e))?;
    check_private(path, &metadata)?;
    let bytes = Zeroizing::new(disk::read_limited(path, pem::MAX_BYTES)?);
    let text = std::str::from_utf8(&bytes).map_err(|_| Error::usage(path.display().to_string()).expected("text"))?;
    Ok(Zeroizing::new(text.lines().next().unwrap_or_default().to_owned()))
}

/// A key for a run, and what the user should be told about it.
#[derive(Debug)]
pub struct KeyForRun {
    pub key: SigningKey,
    /// This run made it.
    pub created: bool,
    /// It was in no trust store of this user before.
    pub newly_trusted: bool,
    pub warning: Option<String>,
}

impl SigningKey {
    /// A new RSA key of so many bits, 3072 or 4096; takes about a third of a second.
    ///
    /// # Errors
    /// [`Kind::Environment`] when the system gives no randomness.
    pub fn generate(source: KeySource, bits: Bits) -> Result<SigningKey> {
        let size = match bits {
            Bits::B3072 => KeySize::Rsa3072,
            Bits::B4096 => KeySize::Rsa4096,
        };
        let pair = KeyPair::generate(size)
            .map_err(|_| Error::environment("key generation").found("the cryptographic library failed"))?;
        SigningKey::from_pair(pair, source).map_err(|found| Error::environment("key generation").found(found))
    }

    fn from_pair(pair: KeyPair, source: KeySource) -> Result<SigningKey, String> {
        let spki: PublicKeyX509Der<'_> =
            pair.public_key().as_der().map_err(|_| "the public key cannot be encoded".to_owned())?;
        let public = PublicKey::from_spki(spki.as_ref())?;
        Ok(SigningKey { holder: Holder::Memory(pair), public, source, algorithm: Algorithm::default(), chain: None })
    }

    /// Reads a PKCS#8 PEM file, encrypted or not, that only its owner can read; or finds a key in a PKCS#11 token, by a
    /// URI of RFC 7512 that says where its module is: `pkcs11:token=NAME;object=NAME?module-path=/path/to/module.so`.
    ///
    /// # Errors
    /// [`Kind::Environment`] when the file cannot be read; [`Kind::Policy`] when others may read it or the key is too
    /// weak; [`Kind::Usage`] when it is not a key.
    pub fn load<'a>(named: impl Into<Named<'a>>, source: KeySource) -> Result<SigningKey> {
        let Named { path, passphrase, algorithm, chain } = named.into();
        let key = match path.to_str().filter(|name| name.starts_with(token::SCHEME)) {
            Some(uri) => SigningKey::from_token(Token::open(uri, passphrase)?)?,
            None => SigningKey::from_file(path, passphrase, source)?,
        };
        let key = key.with_algorithm(algorithm)?;
        match chain {
            None => Ok(key),
            Some(chain) => key.with_chain(chain),
        }
    }

    fn from_token(token: Token) -> Result<SigningKey> {
        let public = PublicKey::from_spki(token.spki())
            .map_err(|found| Error::policy("--key").found(format!("ALG_REFUSED: {found}")))?;
        let (source, algorithm) = (KeySource::Token, Algorithm::default());
        Ok(SigningKey { holder: Holder::Token(token), public, source, algorithm, chain: None })
    }

    fn from_file(path: &Path, passphrase: Option<&dyn Passphrase>, source: KeySource) -> Result<SigningKey> {
        let subject = path.display().to_string();
        let metadata = fs::metadata(path).map_err(|e| {
            Error::io(path, &e).advice("`orb audit keygen -o FILE` makes a key; name it with --key FILE.")
        })?;
        if !metadata.is_file() {
            return Err(Error::usage(subject).expected("a PEM file").found("something else"));
        }
        check_private(path, &metadata)?;
        let bytes = Zeroizing::new(disk::read_limited(path, pem::MAX_BYTES)?);
        let not_a_key = |found: String| {
            Error::usage(path.display().to_string())
                .expected("an RSA private key in PKCS#8 PEM form")
                .found(found)
                .advice("`openssl pkcs8 -topk8 -v2 aes-256-cbc -in OLD.pem -out NEW.pem` converts other forms.")
        };
        let text = std::str::from_utf8(&bytes).map_err(|_| not_a_key("bytes that are not text".into()))?;
        let der = if text.contains(encrypted::LABEL) {
            let sealed = pem::decode(encrypted::LABEL, text).map_err(not_a_key)?;
            let passphrase = passphrase.ok_or_else(|| {
                Error::policy(path.display().to_string())
                    .expected("a passphrase for an encrypted key")
                    .found("PASSPHRASE_REQUIRED: none")
                    .advice("Say where it is with --key-passphrase file:PATH, env:NAME or prompt.")
            })?;
            let opened = encrypted::decrypt(&sealed, &passphrase.read()?).map_err(|found| {
                Error::policy(path.display().to_string())
                    .expected("the passphrase that opens the key")
                    .found(format!("PASSPHRASE_REFUSED: {found}"))
            })?;
            Zeroizing::new(opened.as_bytes().to_vec())
        } else {
            Zeroizing::new(pem::decode(PRIVATE_LABEL, text).map_err(not_a_key)?)
        };
        let pair = KeyPair::from_pkcs8(&der).map_err(|e| {
            Error::policy(path.display().to_string())
                .expected(format!("an RSA key of {MIN_BITS} to {MAX_BITS} bits"))
                .found(format!("ALG_REFUSED: {e}"))
        })?;
        SigningKey::from_pair(pair, source)
            .map_err(|found| Error::policy(path.display().to_string()).found(format!("ALG_REFUSED: {found}")))
    }

    /// Writes the private key (mode 0600 from its creation), under a passphrase if one is given, and beside it
    /// `FILE.pub.pem`. Never over a file.
    ///
    /// # Errors
    /// [`Kind::Usage`] when one of them exists; [`Kind::Environment`] when they cannot be written.
    pub fn save(&self, path: &Path, passphrase: Option<&str>) -> Result<()> {
        let public_path = public_path(path);
        for path in [path, &public_path] {
            if fs::symlink_metadata(path).is_ok() {
                return Err(Error::usage(path.display().to_string())
                    .expected("a new file")
                    .found("an existing one")
                    .advice("A key is never overwritten: what it signed could no longer be verified."));
            }
        }
        let Holder::Memory(pair) = &self.holder else {
            return Err(Error::usage(path.display().to_string()).expected("a key that is in no token"));
        };
        let der: Pkcs8V1Der<'_> = pair
            .as_der()
            .map_err(|_| Error::environment(path.display().to_string()).found("the key cannot be encoded"))?;
        let text = match passphrase {
            None => pem::encode(PRIVATE_LABEL, der.as_ref()),
            Some(words) => pem::encode(encrypted::LABEL, encrypted::encrypt(der.as_ref(), words)?.as_bytes()),
        };
        write_private(path, Zeroizing::new(text).as_bytes())?;
        let written = Disk::default().write_new(&public_path, self.public.to_pem().as_bytes());
        if let Err(error) = written {
            // Half a key pair would stand in the way of the next attempt.
            let _ = fs::remove_file(path);
            return Err(error);
        }
        Ok(())
    }

    /// The signature, as long as the modulus. The same message gives the same signature.
    ///
    /// # Errors
    /// [`Kind::Environment`] when the library fails.
    pub fn sign(&self, message: &[u8]) -> Result<Vec<u8>> {
        let pair = match &self.holder {
            Holder::Memory(pair) => pair,
            Holder::Token(token) => return token.sign(self.algorithm, message),
        };
        let mut sig = vec![0; pair.public_modulus_len()];
        pair.sign(self.algorithm.encoding(), &SystemRandom::new(), message, &mut sig)
            .map_err(|_| Error::environment("signing").found("the cryptographic library failed"))?;
        Ok(sig)
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

    /// The same key, signing by `algorithm`.
    ///
    /// # Errors
    /// [`Kind::Policy`], `ALG_REFUSED`, where the profile that the algorithm belongs to wants a longer key.
    pub fn with_algorithm(self, algorithm: Algorithm) -> Result<SigningKey> {
        let bits = self.public.bits();
        if algorithm == Algorithm::Rs384 && bits < ADVISED_BITS {
            return Err(Error::policy("--algorithm RS384")
                .expected(format!("an RSA key of {ADVISED_BITS} bits or more"))
                .found(format!("ALG_REFUSED: {bits} bits")));
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
    /// [`Kind::Policy`], `CERT_REFUSED`, for a file that holds none, or another key's; [`Kind::Environment`] when it
    /// cannot be read.
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

/// The key for a product of this marking: the named file, or below CUI the user's own, made on the first run.
///
/// Its public half is trusted from then on by this user, unless certificates came with it: then their authority has to be.
/// Two first runs at once make one key.
///
/// # Errors
/// [`Kind::Policy`], `KEY_REQUIRED`, for CUI and above without a named key, `KEY_REVOKED`, `KEY_EXPIRED`, `KEY_SCOPE`,
/// `CERT_EXPIRED`, `CERT_REVOKED` for one that this user's trust store objects to; else as [`SigningKey::load`].
pub fn for_marking(data: &DataFolder, marking: &Marking, named: Option<Named<'_>>) -> Result<KeyForRun> {
    let (key, created) = match named {
        Some(named) => (SigningKey::load(named, KeySource::NamedFile)?, false),
        None if marking.needs_named_key() => {
            return Err(Error::policy("--key")
                .expected(format!("a signing key named for a product marked {marking}"))
                .found("KEY_REQUIRED: none")
                .advice("Name one with --key FILE; `orb audit keygen -o FILE` makes one."));
        }
        None => own_key(data)?,
    };
    let newly_trusted = key.chain().is_none() && trust::add(data, key.public())?;
    check_standing(data, &key, marking)?;
    let warning = (key.public.bits() < ADVISED_BITS)
        .then(|| format!("the signing key has {} bits; {ADVISED_BITS} or more are advised", key.public.bits()));
    Ok(KeyForRun { key, created, newly_trusted, warning })
}

/// A key that this user's own trust store objects to signs nothing.
fn check_standing(data: &DataFolder, key: &SigningKey, marking: &Marking) -> Result<()> {
    let signed = Signed { stated_ms: time::now()?.unix_ms, proven_ms: None };
    let mut store = TrustStore::load(data, &[])?;
    if let Some(chain) = key.chain() {
        // Where no authority is trusted, others judge.
        let _ = store.present(chain.clone());
    }
    let objections = store.judge(key.public().fingerprint(), signed, Some(marking));
    match objections.into_iter().find(|o| !o.code.ends_with("_LATER")) {
        None => Ok(()),
        Some(o) => Err(Error::policy("--key")
            .expected(o.expected)
            .found(format!("{}: {}", o.code, o.actual))
            .advice("Sign with another key; `orb audit key trust list` says what is said of each.")),
    }
}

/// The user's own key, made and trusted if there is none; true when it was made.
///
/// # Errors
/// As [`SigningKey::load`].
pub(super) fn own(data: &DataFolder) -> Result<(SigningKey, bool)> {
    let (key, created) = own_key(data)?;
    if created {
        trust::add(data, key.public())?;
    }
    Ok((key, created))
}

/// Whether the user has an own key already.
pub(super) fn has_own(data: &DataFolder) -> bool {
    data.path().join("keys").join(OWN_KEY).is_file()
}

fn own_key(data: &DataFolder) -> Result<(SigningKey, bool)> {
    let folder = data.subfolder("keys")?;
    let path = folder.join(OWN_KEY);
    let lock_path = folder.join("lock");
    let lock = OpenOptions::new().create(true).append(true).open(&lock_path).map_err(|e| Error::io(&lock_path, &e))?;
    // Held until the file is closed: a second first run waits here and then finds the key.
    lock.lock().map_err(|e| Error::io(&lock_path, &e))?;
    if fs::symlink_metadata(&path).is_ok() {
        return Ok((SigningKey::load(&path, KeySource::UserData)?, false));
    }
    let key = SigningKey::generate(KeySource::UserData, Bits::default())?;
    // A kill between the two files leaves a public key without its private half: it is worth nothing.
    let _ = fs::remove_file(public_path(&path));
    key.save(&path, None)?;
    Disk::default().sync_dir(&folder)?;
    Ok((key, true))
}

fn public_path(path: &Path) -> std::path::PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    path.with_file_name(format!("{stem}.pub.pem"))
}

/// The file has its mode from its creation: there is no moment in which others could open it.
fn write_private(path: &Path, bytes: &[u8]) -> Result<()> {
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt as _;
        options.mode(0o600);
    }
    let write = |file: &mut File| file.write_all(bytes).and_then(|()| file.sync_all());
    let mut file = options.open(path).map_err(|e| disk::write_error(path, bytes.len(), &e))?;
    write(&mut file).map_err(|e| {
        let _ = fs::remove_file(path);
        disk::write_error(path, bytes.len(), &e)
    })
}

#[cfg(unix)]
fn check_private(path: &Path, metadata: &fs::Metadata) -> Result<()> {
    use std::os::unix::fs::PermissionsExt as _;
    let mode = metadata.permissions().mode() & 0o777;
    if mode & 0o077 == 0 {
        return Ok(());
    }
    Err(Error::policy(path.display().to_string())
        .expected("a private key that only its owner can read (mode 0600)")
        .found(format!("KEY_PERMISSIONS: mode {mode:04o}"))
        .advice(format!("If nobody else has read it: chmod 600 {}. Otherwise make a new key.", path.display())))
}

/// Elsewhere the profile folder's own access rules apply; they cannot be read without more libraries.
#[cfg(not(unix))]
fn check_private(_: &Path, _: &fs::Metadata) -> Result<()> {
    Ok(())
}

/// Makes a key file on request.
///
/// # Errors
/// As [`SigningKey::save`].
pub fn keygen(path: &Path, bits: Bits, passphrase: Option<&str>) -> Result<SigningKey> {
    if path.file_name().is_none() {
        return Err(Error::new(Kind::Usage, path.display().to_string()).expected("the name of a new file"));
    }
    let key = SigningKey::generate(KeySource::NamedFile, bits)?;
    key.save(path, passphrase)?;
    Ok(key)
}

#[cfg(test)]
pub(crate) mod tests;
