//! Simulation formats: bytes ↔ plain structs. No GPU, no network, no clock.
//!
//! Writers return bytes or [`File`]s; nothing here touches a disk.

pub mod cdb;
pub mod collada;
pub mod kmz;
pub mod mesh;
pub mod openflight;
pub mod ply;
pub mod sgi;
pub mod xml;

pub use mesh::Mesh;
pub use sgi::Image;

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

pub type Result<T, E = Error> = std::result::Result<T, E>;
