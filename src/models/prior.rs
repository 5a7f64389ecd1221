//! The weights in the binary: the project's own networks, trained on procedural scenes only.

use super::{Engine, Graph};
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
    version: "0.6",
    sha256: "fbf24657b6946483f2fb1b358f3dc157547ecc0af258ed4495c61020441cbbb7",
    onnx: include_bytes!("../../prior/scene.onnx"),
};

/// The photo around its subject and a rough mask → the mask finely drawn, inverse depth.
pub static DETAIL: Weights = Weights {
    id: "orb-detail-net",
    version: "0.6",
    sha256: "cbb54b9775e5f9f50869036a13ae817fe8499c06b7133fe9e6aab99c4bd125ee",
    onnx: include_bytes!("../../prior/detail.onnx"),
};

/// Cropped subject → Gaussians, the camera's elevation and where the crop's camera stands.
pub static SPLAT: Weights = Weights {
    id: "orb-splat-net",
    version: "0.26",
    sha256: "81850ea232b9ddbc8d840d2380bb4083e8487cc65771bba49270f84707f28f3d",
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

    /// The network: read while its bytes are hashed, and there only where they are the pinned ones.
    ///
    /// # Errors
    /// As [`Weights::verified`] and the engine.
    pub fn loaded(&self, engine: &dyn Engine) -> Result<Box<dyn Graph>> {
        let (verified, graph) = rayon::join(|| self.verified(), || engine.load_static(self.onnx));
        verified.and(graph)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::Rten;

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
        // Whatever the engine says of them; and where it would run them.
        let another = Weights { sha256: DETAIL.sha256, ..SCENE };
        for weights in [altered, another] {
            assert_eq!(weights.loaded(&Rten).err().map(|e| e.kind), Some(crate::Kind::Integrity));
        }
    }
}
