//! In place of ML-DSA where the build signs by AWS-LC's certificated FIPS module: it has none, and Orb does not sign or
//! verify outside of it then.

use zeroize::Zeroizing;

const WHY: &str = "ML-DSA-87: this build signs and verifies inside AWS-LC's certificated FIPS module, which has no ML-DSA; \
                   the ordinary build has it";

/// No key is one.
#[derive(Clone, Debug)]
pub(super) enum Public {}

impl Public {
    pub fn from_spki(_: &[u8]) -> Result<Public, String> {
        Err(WHY.into())
    }

    pub fn verify(&self, _: &[u8], _: &[u8]) -> (bool, bool) {
        match *self {}
    }
}

/// No key pair is one.
pub(super) enum Pair {}

impl Pair {
    pub fn generate() -> Result<Pair, String> {
        Err(WHY.into())
    }

    pub fn from_pkcs8(_: &[u8]) -> Result<Pair, String> {
        Err(WHY.into())
    }

    pub fn to_pkcs8(&self) -> Result<Zeroizing<Vec<u8>>, String> {
        match *self {}
    }

    pub fn spki(&self) -> Result<Vec<u8>, String> {
        match *self {}
    }

    pub fn sign(&self, _: &[u8]) -> Result<Vec<u8>, String> {
        match *self {}
    }
}
