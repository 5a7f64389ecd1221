//! Accounts and their tokens.
//!
//! A token is `orb_NAME_SECRET`, the secret 256 random bits. What is kept is the secret's SHA-256: there is nothing to guess
//! in 256 bits that a slow hash would have to protect, and a slow one would let whoever sends tokens keep the server busy.
//! People choose no secrets here, so there are no passwords to be hashed.

use std::str::FromStr;

use aws_lc_rs::constant_time::verify_slices_are_equal;
use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use serde::Serialize;
use sha2::{Digest as _, Sha256};
use utoipa::ToSchema;
use zeroize::Zeroizing;

use super::role::{Role, Roles};
use crate::audit::Marking;
use crate::audit::time::format_utc;
use crate::{Error, Result};

/// Wrong tokens in a row that lock an account, and for how long, milliseconds (NIST SP 800-53 AC-7).
pub const MOST_FAILURES: u32 = 10;
pub const LOCKED_FOR: u64 = 15 * 60 * 1000;
/// Longest name, bytes.
const LONGEST_NAME: usize = 32;

#[derive(Clone, Debug)]
pub struct Account {
    pub name: String,
    pub roles: Roles,
    pub ceiling: Marking,
    pub token_sha256: Vec<u8>,
    /// All times in milliseconds since 1970.
    pub token_expires: u64,
    pub made: u64,
    pub disabled: bool,
    pub failures: u32,
    pub locked_until: u64,
    pub last_used: Option<u64>,
}

/// The SHA-256 of a client's certificate, as it was sent (DER): of all that a certificate says of itself the one thing that no
/// other has, whatever an authority writes into it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fingerprint([u8; 32]);

impl Fingerprint {
    pub fn new(sha256: [u8; 32]) -> Fingerprint {
        Fingerprint(sha256)
    }

    pub fn of(der: &[u8]) -> Fingerprint {
        Fingerprint(Sha256::digest(der).into())
    }

    pub fn bytes(&self) -> &[u8] {
        &self.0
    }
}

impl std::fmt::Display for Fingerprint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&hex::encode(self.0))
    }
}

impl FromStr for Fingerprint {
    type Err = Error;

    /// 64 hexadecimal digits, with colons between them or not, as `openssl x509 -fingerprint -sha256` prints them.
    fn from_str(text: &str) -> Result<Fingerprint> {
        let digits: String = text.chars().filter(|c| *c != ':').collect();
        let bytes = hex::decode(digits).ok().and_then(|bytes| bytes.try_into().ok());
        bytes.map(Fingerprint).ok_or_else(|| {
            Error::usage("certificate")
                .expected("the SHA-256 of a certificate, 64 hexadecimal digits")
                .found(format!("{:?}", text.chars().take(80).collect::<String>()))
                .advice("`openssl x509 -in FILE -noout -fingerprint -sha256` prints it.")
        })
    }
}

/// An account as it is told to administrators: nothing of its token.
#[derive(Clone, Debug, Serialize, ToSchema)]
#[schema(as = Account)]
pub struct Told {
    pub name: String,
    pub roles: Vec<Role>,
    /// Highest marking that it takes part in.
    pub ceiling: String,
    /// UTC, as all times.
    pub made: String,
    pub token_expires: String,
    pub last_used: Option<String>,
    pub disabled: bool,
    pub locked: bool,
    /// SHA-256 of the client certificates that are bound to it, hexadecimal.
    pub certificates: Vec<String>,
}

impl Account {
    pub fn told(&self, certificates: &[Fingerprint], now: u64) -> Told {
        Told {
            name: self.name.clone(),
            roles: self.roles.iter().collect(),
            ceiling: self.ceiling.banner(),
            made: format_utc(self.made),
            token_expires: format_utc(self.token_expires),
            last_used: self.last_used.map(format_utc),
            disabled: self.disabled,
            locked: self.locked_until > now,
            certificates: certificates.iter().map(Fingerprint::to_string).collect(),
        }
    }
}

/// A name that may stand in a token, a record and a command: lower case letters, digits and hyphens, a letter first.
///
/// # Errors
/// Usage.
pub fn check_name(name: &str) -> Result<()> {
    let fits = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-';
    if name.len() > LONGEST_NAME || !name.starts_with(|c: char| c.is_ascii_lowercase()) || !name.bytes().all(fits) {
        return Err(Error::usage("account")
            .expected("a name of at most 32 lower case letters, digits and hyphens, a letter first")
            .found(format!("{name:?}")));
    }
    Ok(())
}

/// A token for an account, to be shown once, and what is kept of it.
///
/// # Errors
/// Environment, without random numbers.
pub fn new_token(name: &str) -> Result<(Zeroizing<String>, Vec<u8>)> {
    let secret = Zeroizing::new(super::random::<32>()?);
    let text = Zeroizing::new(format!("orb_{name}_{}", URL_SAFE_NO_PAD.encode(*secret)));
    Ok((text, Sha256::digest(*secret).to_vec()))
}

/// The name in a token, and the SHA-256 of its secret. `None` for what is no token at all.
pub fn read_token(text: &str) -> Option<(&str, Vec<u8>)> {
    let (name, secret) = text.strip_prefix("orb_")?.split_once('_')?;
    check_name(name).ok()?;
    let secret = Zeroizing::new(URL_SAFE_NO_PAD.decode(secret).ok().filter(|s| s.len() == 32)?);
    Some((name, Sha256::digest(&*secret).to_vec()))
}

/// In constant time.
pub fn is_same(a: &[u8], b: &[u8]) -> bool {
    verify_slices_are_equal(a, b).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens() {
        let (text, kept) = new_token("jane-2").unwrap();
        assert_eq!(text.len(), "orb_jane-2_".len() + 43);
        assert_eq!(read_token(&text), Some(("jane-2", kept.clone())));
        assert!(!kept.windows(8).any(|w| text.as_bytes().windows(8).any(|t| t == w)));
        assert_ne!(new_token("jane-2").unwrap().1, kept);
        for wrong in ["", "orb_", "orb_jane", "orb_jane_", "orb_Jane_AAAA", "orb__AAAA", &text[..text.len() - 1]] {
            assert_eq!(read_token(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn names() {
        for (name, sound) in [
            ("jane", true),
            ("j-2", true),
            ("", false),
            ("2j", false),
            ("Jane", false),
            ("a_b", false),
            ("../x", false),
            (&"x".repeat(33), false),
        ] {
            assert_eq!(check_name(name).is_ok(), sound, "{name}");
        }
    }
}
