//! The options that name a signing key, and where its passphrase comes from.

use std::path::PathBuf;
use std::str::FromStr;

use clap::Args;
use zeroize::Zeroizing;

use crate::audit::keys::{self, Algorithm, Named, Passphrase};
use crate::{Error, Result};

/// The key that signs.
#[derive(Args, Clone, Debug, Default)]
pub struct KeyArgs {
    /// Signing key (PKCS#8 PEM, encrypted or not), or one in a PKCS#11 token:
    /// pkcs11:token=NAME;object=NAME?module-path=/path/to/module.so. Needed above UNCLASSIFIED; else the user's own, made on the first run.
    #[arg(long, value_name = "FILE")]
    pub key: Option<PathBuf>,

    /// Where the key's passphrase or the token's PIN is: file:PATH (its first line), env:NAME, or prompt.
    #[arg(long, value_name = "SOURCE", requires = "key")]
    pub key_passphrase: Option<PassphraseSource>,

    /// How to sign. An RSA key signs by RS256, or by RS384 (3072 bits or more) where CNSA 1.0 is asked for; an ML-DSA-87 key
    /// only by ML-DSA-87. A file with both keys signs by RS384 and ML-DSA-87.
    #[arg(long = "sign-algorithm", value_name = "NAME", value_enum, requires = "key")]
    pub algorithm: Option<Algorithm>,

    /// Certificates of the signing key (PEM, the signer's own first, without the root): they travel with the record.
    #[arg(long, value_name = "FILE", requires = "key")]
    pub cert_chain: Option<PathBuf>,

    /// Ask this time server (HOST or HOST:PORT) when the record is made. Without this Orb uses no network.
    #[arg(long, value_name = "HOST")]
    pub ntp_server: Option<String>,
}

impl KeyArgs {
    pub fn named(&self) -> Option<Named<'_>> {
        let passphrase = self.key_passphrase.as_ref().map(|source| source as &dyn Passphrase);
        let (algorithm, chain) = (self.algorithm, self.cert_chain.as_deref());
        self.key.as_deref().map(|path| Named { path, passphrase, algorithm, chain })
    }
}

/// Asked only when a key needs it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PassphraseSource {
    File(PathBuf),
    Variable(String),
    Prompt,
}

impl FromStr for PassphraseSource {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        match text.split_once(':') {
            Some(("file", path)) if !path.is_empty() => Ok(PassphraseSource::File(path.into())),
            Some(("env", name)) if !name.is_empty() => Ok(PassphraseSource::Variable(name.into())),
            None if text == "prompt" => Ok(PassphraseSource::Prompt),
            _ => Err("expected file:PATH, env:NAME or prompt".into()),
        }
    }
}

impl Passphrase for PassphraseSource {
    fn read(&self) -> Result<Zeroizing<String>> {
        match self {
            PassphraseSource::File(path) => keys::passphrase_file(path),
            PassphraseSource::Variable(name) => std::env::var(name).map(Zeroizing::new).map_err(|e| {
                Error::usage(name).expected("a passphrase in this environment variable").found(e.to_string())
            }),
            PassphraseSource::Prompt => rpassword::prompt_password("Passphrase of the signing key: ")
                .map(Zeroizing::new)
                .map_err(|e| Error::environment("passphrase").expected("a terminal to ask on").found(e.to_string())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources() {
        assert_eq!("file:/a:b".parse(), Ok(PassphraseSource::File("/a:b".into())));
        assert_eq!("env:ORB_PASS".parse(), Ok(PassphraseSource::Variable("ORB_PASS".into())));
        assert_eq!("prompt".parse(), Ok(PassphraseSource::Prompt));
        for wrong in ["", "secret", "file:", "env:", "pass:secret"] {
            assert!(wrong.parse::<PassphraseSource>().is_err(), "{wrong}");
        }
    }
}
