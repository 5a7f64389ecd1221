//! The weights in the binary: the project's own networks, trained on procedural scenes only.

use crate::{Error, Result};
use sha2::{Digest, Sha256};

/// A pinned set of weights.
#[derive(Clone, Copy, Debug)]
pub struct Weights {
    /// As records name it.
    pub id: &'static str,
    pub version: &'static str,
    /// Lower-case hexadecimal.
    pub sha256: &'static str,
    pub onnx: &'static [u8],
}

/// Photo → subject mask, inverse depth and the camera's elevation.
pub static SCENE: Weights = Weights {
    id: "orb-scene-net",
    version: "0.5",
    sha256: "e16a1da76f9e21334095990a1ba7cc57fe4a079c0cbdda76861dfc7b06f630a7",
    onnx: include_bytes!("../../prior/scene.onnx"),
};

/// The photo around its subject and a rough mask → the mask finely drawn, inverse depth.
pub static DETAIL: Weights = Weights {
    id: "orb-detail-net",
    version: "0.3",
    sha256: "07f6767fe0d7b992bd8ecfc31112f7e8fbfc0db83e0bd3bb22a3e03f9494138a",
    onnx: include_bytes!("../../prior/detail.onnx"),
};

/// Cropped subject → Gaussians, the camera's elevation and where the crop's camera stands.
pub static SPLAT: Weights = Weights {
    id: "orb-splat-net",
    version: "0.15",
    sha256: "4ccba10327aff30e3173925e08b94ee789d540b62e3cb6799cbbc3cecd8fa040",
    onnx: include_bytes!("../../prior/splat.onnx"),
};

impl Weights {
    /// Hashes the bytes that will be run.
    ///
    /// # Errors
    /// An integrity error when they are not the pinned ones.
    pub fn verified(&self) -> Result<&'static [u8]> {
        let found = hex::encode(Sha256::digest(self.onnx));
        if found != self.sha256 {
            return Err(Error::integrity(format!("built-in weights {} {}", self.id, self.version))
                .expected(format!("SHA-256 {}", self.sha256))
                .found(found)
                .advice("The program file is damaged or was altered; install it again."));
        }
        Ok(self.onnx)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pins_hold() {
        for weights in [&SCENE, &DETAIL, &SPLAT] {
            assert_eq!(weights.verified().unwrap().len(), weights.onnx.len());
        }
    }

    #[test]
    fn altered_weights_are_refused() {
        let altered = Weights { onnx: &SCENE.onnx[1..], ..SCENE };
        assert_eq!(altered.verified().unwrap_err().kind, crate::Kind::Integrity);
    }
}
