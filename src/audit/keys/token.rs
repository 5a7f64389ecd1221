//! Keys in a PKCS#11 token (a smart card, an HSM, SoftHSM): named by a URI of RFC 7512, used for signing and nothing else.
//! The private key never leaves the token; the module is a library that the user names.

use std::fmt;
use std::path::PathBuf;
use std::sync::Mutex;

use cryptoki::context::{CInitializeArgs, CInitializeFlags, Pkcs11};
use cryptoki::error::{Error as Error11, RvError};
use cryptoki::mechanism::{Mechanism, MechanismType};
use cryptoki::object::{Attribute, AttributeType, KeyType, ObjectClass, ObjectHandle};
use cryptoki::session::{Session, UserType};
use cryptoki::slot::Slot;
use cryptoki::types::AuthPin;
use pkcs8::der::asn1::{BitStringRef, UintRef};
use pkcs8::der::{self, Encode as _};
use pkcs8::spki::SubjectPublicKeyInfoRef;

use super::{Algorithm, Passphrase, second};
use crate::{Error, Result};

/// What to do about a key that is none of RSA.
pub(super) const NOT_IN_TOKENS: &str = "Orb signs in a token with RSA keys only. For ML-DSA-87, alone or together with RSA, sign with a key \
     file, encrypted: `orb audit keygen --profile cnsa2|hybrid --passphrase SOURCE -o FILE`.";

/// Begins the name of such a key.
pub const SCHEME: &str = "pkcs11:";

/// The parts of a URI that say which key: `pkcs11:token=T;object=O;id=%01?module-path=/path/to/module.so`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Name {
    module: PathBuf,
    token: Option<String>,
    serial: Option<String>,
    object: Option<String>,
    id: Option<Vec<u8>>,
}

/// A key in a token, logged in.
pub(super) struct Token {
    /// PKCS#11 sessions are used by one thread at a time.
    session: Mutex<Session>,
    key: ObjectHandle,
    spki: Vec<u8>,
    mechanisms: Vec<MechanismType>,
    /// Closes the module after the session.
    _module: Pkcs11,
}

impl fmt::Debug for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Token").finish_non_exhaustive()
    }
}

impl Token {
    /// Opens the token, logs in and finds the one RSA key of that name.
    ///
    /// # Errors
    /// [`crate::Kind::Usage`] for a URI that does not name a key; [`crate::Kind::Policy`] without the PIN, or where the
    /// name fits no key or several; [`crate::Kind::Environment`] when the module or the token fails.
    pub fn open(uri: &str, pin: Option<&dyn Passphrase>) -> Result<Token> {
        let name = parse(uri).map_err(|found| {
            Error::usage("--key")
                .expected("pkcs11:token=NAME;object=NAME?module-path=/path/to/module.so (RFC 7512)")
                .found(found)
        })?;
        let failed = |what: &str, e: cryptoki::error::Error| {
            Error::environment(format!("PKCS#11 module {}", name.module.display())).found(format!("{what}: {e}"))
        };
        let refused = |found: &str| {
            Error::policy("--key").expected("the name of one RSA key that signs, in one token").found(found.to_owned())
        };
        let module = Pkcs11::new(&name.module).map_err(|e| failed("loading", e))?;
        match module.initialize(CInitializeArgs::new(CInitializeFlags::OS_LOCKING_OK)) {
            // Another key of this process is in a token of the same module.
            Ok(()) | Err(Error11::Pkcs11(RvError::CryptokiAlreadyInitialized, _)) => {}
            Err(e) => return Err(failed("initialising", e)),
        }
        let slot = find_slot(&module, &name).map_err(|e| failed("listing tokens", e))?;
        let slot = slot.ok_or_else(|| refused("TOKEN_NOT_FOUND: no token, or several, of that name"))?;
        let session = module.open_ro_session(slot).map_err(|e| failed("opening a session", e))?;
        let pin = pin.ok_or_else(|| {
            Error::policy("--key")
                .expected("the token's PIN")
                .found("PASSPHRASE_REQUIRED: none")
                .advice("Say where it is with --key-passphrase file:PATH, env:NAME or prompt.")
        })?;
        let pin = AuthPin::new(pin.read()?.as_str().into());
        session.login(UserType::User, Some(&pin)).map_err(|e| {
            Error::policy("--key")
                .expected("the token's PIN")
                .found(format!("PASSPHRASE_REFUSED: {e}"))
                .advice("A token locks itself after a few wrong PINs: do not just try again.")
        })?;
        let mut named = vec![Attribute::Class(ObjectClass::PRIVATE_KEY)];
        named.extend(name.object.as_ref().map(|label| Attribute::Label(label.clone().into_bytes())));
        named.extend(name.id.clone().map(Attribute::Id));
        let find = |wanted: &[Attribute]| session.find_objects(wanted).map_err(|e| failed("looking for the key", e));
        let keys = find(&[&named[..], &[Attribute::KeyType(KeyType::RSA)]].concat())?;
        let [key] = keys[..] else {
            let others = if keys.is_empty() { find(&named)? } else { Vec::new() };
            let kind = |key| match session.get_attributes(key, &[AttributeType::KeyType]).as_deref() {
                Ok([Attribute::KeyType(kind)]) => kind.to_string(),
                _ => "key of another kind".into(),
            };
            return Err(match others.first() {
                None => refused(&format!("KEY_NOT_FOUND: {} keys of that name", keys.len())),
                Some(other) => refused(&format!("ALG_REFUSED: a {}", kind(*other))).advice(NOT_IN_TOKENS),
            });
        };
        let values = session
            .get_attributes(key, &[AttributeType::Modulus, AttributeType::PublicExponent])
            .map_err(|e| failed("reading the public key", e))?;
        let (mut n, mut e) = (Vec::new(), Vec::new());
        for value in values {
            match value {
                Attribute::Modulus(bytes) => n = bytes,
                Attribute::PublicExponent(bytes) => e = bytes,
                _ => {}
            }
        }
        let spki = spki(&n, &e).map_err(|e| refused(&format!("ALG_REFUSED: no RSA public key ({e})")))?;
        let mechanisms = module.get_mechanism_list(slot).map_err(|e| failed("listing mechanisms", e))?;
        Ok(Token { session: Mutex::new(session), key, spki, mechanisms, _module: module })
    }

    /// SubjectPublicKeyInfo, DER.
    pub fn spki(&self) -> &[u8] {
        &self.spki
    }

    /// # Errors
    /// [`crate::Kind::Environment`] when the token does not sign.
    pub fn sign(&self, algorithm: Algorithm, message: &[u8]) -> Result<Vec<u8>> {
        let none = || Error::environment("signing in the token").found(format!("{}, of RSA keys", algorithm.name()));
        let (whole, mechanism) = match algorithm {
            Algorithm::Rs256 => (MechanismType::SHA256_RSA_PKCS, Mechanism::Sha256RsaPkcs),
            Algorithm::Rs384 => (MechanismType::SHA384_RSA_PKCS, Mechanism::Sha384RsaPkcs),
            Algorithm::MlDsa87 => return Err(none().advice(NOT_IN_TOKENS)),
        };
        let session = self.session.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let signed = if self.mechanisms.contains(&whole) {
            session.sign(&mechanism, self.key, message)
        } else {
            // Many cards pad, but do not hash.
            let info = second::digest_info(algorithm, message).ok_or_else(none)?;
            session.sign(&Mechanism::RsaPkcs, self.key, &info)
        };
        signed.map_err(|e| Error::environment("signing in the token").found(e.to_string()))
    }
}

fn find_slot(module: &Pkcs11, name: &Name) -> cryptoki::error::Result<Option<Slot>> {
    let mut found = Vec::new();
    for slot in module.get_slots_with_initialized_token()? {
        let info = module.get_token_info(slot)?;
        let fits = |wanted: &Option<String>, is: &str| wanted.as_deref().is_none_or(|w| w == is.trim_end());
        if fits(&name.token, info.label()) && fits(&name.serial, info.serial_number()) {
            found.push(slot);
        }
    }
    Ok(if let [slot] = found[..] { Some(slot) } else { None })
}

fn spki(n: &[u8], e: &[u8]) -> der::Result<Vec<u8>> {
    let key = pkcs1::RsaPublicKey { modulus: UintRef::new(n)?, public_exponent: UintRef::new(e)? }.to_der()?;
    SubjectPublicKeyInfoRef { algorithm: pkcs1::ALGORITHM_ID, subject_public_key: BitStringRef::from_bytes(&key)? }
        .to_der()
}

/// Attributes of RFC 7512 that Orb does not know are refused: one that is passed over could have named another key.
fn parse(uri: &str) -> std::result::Result<Name, String> {
    let rest = uri.strip_prefix(SCHEME).ok_or("no pkcs11: URI")?;
    let (path, query) = rest.split_once('?').unwrap_or((rest, ""));
    let mut name = Name::default();
    for part in path.split(';').filter(|p| !p.is_empty()) {
        let (key, value) = part.split_once('=').ok_or_else(|| format!("{part:?} without a value"))?;
        let bytes = percent_decoded(value)?;
        let text = || String::from_utf8(bytes.clone()).map_err(|_| format!("{key} is no text"));
        match key {
            "token" => name.token = Some(text()?),
            "serial" => name.serial = Some(text()?),
            "object" => name.object = Some(text()?),
            "id" => name.id = Some(bytes),
            "type" if value == "private" => {}
            _ => return Err(format!("the attribute {part:?}")),
        }
    }
    for part in query.split('&').filter(|p| !p.is_empty()) {
        match part.split_once('=') {
            Some(("module-path", value)) => {
                name.module = String::from_utf8(percent_decoded(value)?).map_err(|_| "a path that is no text")?.into();
            }
            Some(("pin-value", _)) => return Err("a PIN on the command line, where others see it".into()),
            _ => return Err(format!("the attribute {part:?}")),
        }
    }
    if name.module.as_os_str().is_empty() {
        return Err("no module-path".into());
    }
    Ok(name)
}

fn percent_decoded(text: &str) -> std::result::Result<Vec<u8>, String> {
    let mut out = Vec::new();
    let mut rest = text.as_bytes();
    while let [first, tail @ ..] = rest {
        rest = tail;
        if *first == b'%' {
            let digits = rest.get(..2).ok_or("a % without two digits")?;
            out.extend(hex::decode(digits).map_err(|_| "a % without two digits")?);
            rest = &rest[2..];
        } else {
            out.push(*first);
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use std::process::Command;

    use zeroize::Zeroizing;

    use super::*;
    use crate::audit::keys::{KeySource, Named, SigningKey};

    #[test]
    fn uris() {
        let name = parse("pkcs11:token=My%20card;object=sign;id=%01%ff?module-path=/usr/lib/m.so").unwrap();
        assert_eq!((name.token.as_deref(), name.object.as_deref()), (Some("My card"), Some("sign")));
        assert_eq!((name.id, name.module), (Some(vec![1, 255]), "/usr/lib/m.so".into()));
        for wrong in [
            "file:/x",
            "pkcs11:token=a",
            "pkcs11:token?module-path=/m",
            "pkcs11:colour=red?module-path=/m",
            "pkcs11:token=%4?module-path=/m",
            "pkcs11:token=a?module-path=/m&pin-value=1234",
        ] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
    }

    struct Pin(&'static str);

    impl Passphrase for Pin {
        fn read(&self) -> Result<Zeroizing<String>> {
            Ok(Zeroizing::new(self.0.to_owned()))
        }
    }

    /// Set by the test below for the process in which it runs itself again: SoftHSM finds its tokens by the environment.
    const MODULE: &str = "ORB_TEST_SOFTHSM_MODULE";

    #[test]
    fn a_key_in_softhsm() {
        let Ok(module) = std::env::var(MODULE) else { return run_with_softhsm() };
        let uri = |what: &str| PathBuf::from(format!("pkcs11:{what}?module-path={module}"));
        let load = |what: &str, pin: Option<&dyn Passphrase>, algorithm| {
            let path = uri(what);
            SigningKey::load(
                Named { passphrase: pin, algorithm: Some(algorithm), ..Named::from(&path) },
                KeySource::NamedFile,
            )
        };
        let right = Some(&Pin("1234") as &dyn Passphrase);
        for algorithm in Algorithm::RSA {
            let key = load("token=orb;object=signer", right, algorithm).unwrap();
            assert_eq!((key.public().rsa_bits(), key.source()), (Some(3072), KeySource::Token));
            let sig = key.sign(b"message").unwrap();
            assert_eq!(key.public().verify(b"message", &sig), Ok(Some(algorithm)));
        }
        // A card that only pads.
        let mut bare = Token::open(uri("token=orb;id=%01").to_str().unwrap(), right).unwrap();
        let whole = bare.sign(Algorithm::Rs256, b"message").unwrap();
        bare.mechanisms.clear();
        assert_eq!(bare.sign(Algorithm::Rs256, b"message").unwrap(), whole);
        drop(bare);
        // SoftHSM 2 has no ML-DSA: a key on a curve stands for every key that is not RSA's.
        let error = load("token=orb;object=curve", right, Algorithm::Rs256).unwrap_err();
        assert!(error.found == "ALG_REFUSED: a CKK_EC" && error.advice.contains("--profile cnsa2"), "{error}");
        let error = load("token=orb;object=signer", right, Algorithm::MlDsa87).unwrap_err();
        assert!(error.to_string().contains("ALG_REFUSED") && error.advice.contains("--profile cnsa2"), "{error}");
        for (what, pin, code) in [
            ("token=orb;object=signer", None, "PASSPHRASE_REQUIRED"),
            ("token=orb;object=nobody", right, "KEY_NOT_FOUND"),
            ("token=other;object=signer", right, "TOKEN_NOT_FOUND"),
            ("token=orb;object=signer", Some(&Pin("9999") as &dyn Passphrase), "PASSPHRASE_REFUSED"),
        ] {
            let error = load(what, pin, Algorithm::Rs256).unwrap_err();
            assert!(error.found.contains(code), "{what}: {error}");
        }
    }

    fn run_with_softhsm() {
        let modules = ["/usr/lib/softhsm/libsofthsm2.so", "/usr/lib64/pkcs11/libsofthsm2.so"];
        let module = modules.into_iter().find(|m| std::path::Path::new(m).exists());
        let Some(module) = module.filter(|_| Command::new("softhsm2-util").arg("--version").output().is_ok()) else {
            assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "cannot run: softhsm2 is not installed");
            eprintln!("skipped: softhsm2 is not installed");
            return;
        };
        let dir = tempfile::tempdir().unwrap();
        let config = dir.path().join("softhsm2.conf");
        std::fs::write(&config, format!("directories.tokendir = {}\n", dir.path().display())).unwrap();
        let run = |program: &std::ffi::OsStr, args: &[&str]| {
            let done = Command::new(program)
                .args(args)
                .current_dir(dir.path())
                .env("SOFTHSM2_CONF", &config)
                .env(MODULE, module)
                .output()
                .unwrap();
            let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
            assert!(done.status.success(), "{program:?} {args:?}: {}{}", text(&done.stdout), text(&done.stderr));
        };
        let tool = "softhsm2-util".as_ref();
        run(tool, &["--init-token", "--free", "--label", "orb", "--so-pin", "0000", "--pin", "1234"]);
        run("openssl".as_ref(), &["genpkey", "-algorithm", "RSA", "-pkeyopt", "rsa_keygen_bits:3072", "-out", "k.pem"]);
        let import = ["--import", "k.pem", "--token", "orb", "--label", "signer", "--id", "01", "--pin", "1234"];
        run(tool, &import);
        run(
            "openssl".as_ref(),
            &["genpkey", "-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:P-256", "-out", "e.pem"],
        );
        run(tool, &["--import", "e.pem", "--token", "orb", "--label", "curve", "--id", "02", "--pin", "1234"]);
        let test = "audit::keys::token::tests::a_key_in_softhsm";
        run(std::env::current_exe().unwrap().as_os_str(), &["--exact", test, "--nocapture"]);
    }
}
