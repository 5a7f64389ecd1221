//! The names of what signs: algorithms, the suites that ask for them, lengths of keys.

use aws_lc_rs::signature::{self, RsaParameters, RsaSignatureEncoding};
use serde::{Deserialize, Serialize};

/// A signature algorithm by its registered JOSE name: RSASSA-PKCS1-v1_5 with a digest (RFC 7518 §3.3), or ML-DSA (FIPS 204).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
pub enum Algorithm {
    /// RSA with SHA-256.
    #[default]
    #[serde(rename = "RS256")]
    #[value(name = "RS256", alias = "rs256")]
    Rs256,
    /// RSA with SHA-384, as CNSA 1.0 asks for together with 3072 bits or more.
    #[serde(rename = "RS384")]
    #[value(name = "RS384", alias = "rs384")]
    Rs384,
    /// ML-DSA-87 (FIPS 204) without a context, as CNSA 2.0 asks for.
    #[serde(rename = "ML-DSA-87")]
    #[value(name = "ML-DSA-87", alias = "ml-dsa-87")]
    MlDsa87,
}

impl Algorithm {
    pub const ALL: [Algorithm; 3] = [Algorithm::Rs256, Algorithm::Rs384, Algorithm::MlDsa87];
    /// What an RSA key can do, strongest last.
    pub(super) const RSA: [Algorithm; 2] = [Algorithm::Rs256, Algorithm::Rs384];

    pub fn name(self) -> &'static str {
        match self {
            Algorithm::Rs256 => "RS256",
            Algorithm::Rs384 => "RS384",
            Algorithm::MlDsa87 => "ML-DSA-87",
        }
    }

    /// Records signed so state SHA-384 beside SHA-256 of every output.
    pub fn with_sha384(self) -> bool {
        self != Algorithm::Rs256
    }

    /// How RSA signs; `None` for what is not RSA.
    pub(super) fn rsa_encoding(self) -> Option<&'static RsaSignatureEncoding> {
        match self {
            Algorithm::Rs256 => Some(&signature::RSA_PKCS1_SHA256),
            Algorithm::Rs384 => Some(&signature::RSA_PKCS1_SHA384),
            Algorithm::MlDsa87 => None,
        }
    }

    /// How RSA verifies; `None` for what is not RSA.
    pub(super) fn rsa_verification(self) -> Option<&'static RsaParameters> {
        match self {
            Algorithm::Rs256 => Some(&signature::RSA_PKCS1_2048_8192_SHA256),
            Algorithm::Rs384 => Some(&signature::RSA_PKCS1_2048_8192_SHA384),
            Algorithm::MlDsa87 => None,
        }
    }
}

/// What a new key is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Suite {
    /// RSA, SHA-256.
    #[default]
    Default,
    /// CNSA 1.0: RSA of 3072 bits or more, SHA-384.
    #[value(name = "cnsa1")]
    Cnsa1,
    /// CNSA 2.0: ML-DSA-87.
    #[value(name = "cnsa2")]
    Cnsa2,
    /// An RSA key and an ML-DSA-87 key in one file. Both sign, and both signatures are required.
    Hybrid,
}

impl Suite {
    pub fn has_rsa(self) -> bool {
        self != Suite::Cnsa2
    }
}

/// Lengths of RSA keys that Orb makes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Bits {
    #[default]
    #[value(name = "3072")]
    B3072,
    #[value(name = "4096")]
    B4096,
}
