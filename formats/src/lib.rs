//! Simulation formats: bytes ↔ plain structs. No GPU, no network, no clock.
//!
//! Writers return bytes or [`File`]s; nothing here touches a disk.

// A panic on input is a fault of the program: what can fail says so.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::unreachable,
        clippy::todo,
        clippy::unimplemented
    )
)]

pub mod asset;
pub mod cdb;
pub mod collada;
pub mod geotiff;
pub mod glb;
pub mod jp2;
pub mod kmz;
pub mod label;
pub mod mesh;
pub mod openflight;
pub mod ply;
pub mod sgi;
pub mod splats;
pub mod spz;
mod threads;
pub mod tiles3d;
pub mod usdz;
pub mod xml;

pub use asset::Asset;
pub use label::{Label, Place};
pub use mesh::Mesh;
pub use sgi::Image;
pub use splats::Splats;

/// One file of an export, relative to the export's root, `/` between folders.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    pub path: String,
    pub bytes: Vec<u8>,
    pub media_type: &'static str,
}

/// Why bytes could not be read or a structure not be written.
#[derive(Debug, thiserror::Error, PartialEq)]
pub enum Error {
    /// The bytes break the format's rules.
    #[error("{format} at byte {offset}: expected {expected}, found {found}")]
    Malformed { format: &'static str, offset: u64, expected: String, found: String },
    /// A value does not fit the format.
    #[error("{format}: {what}")]
    Unsupported { format: &'static str, what: String },
}

impl Error {
    pub(crate) fn malformed(
        format: &'static str,
        offset: usize,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> Self {
        Error::Malformed { format, offset: offset as u64, expected: expected.into(), found: found.into() }
    }

    pub(crate) fn unsupported(format: &'static str, what: impl Into<String>) -> Self {
        Error::Unsupported { format, what: what.into() }
    }
}

pub type Result<T, E = Error> = std::result::Result<T, E>;
