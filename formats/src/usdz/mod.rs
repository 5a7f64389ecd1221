//! USDZ: a textured mesh for AR viewers and USD tools.
//!
//! Sources: OpenUSD's specification of the USDZ package (stored ZIP entries whose data begin at multiples of 64, the
//! root layer first), its UsdPreviewSurface specification, and the crate format of its binary layers (`.usdc`), which
//! ARKit wants as the root. Layers are written in version 0.8.0 of that format; 0.4 to 0.13 are read.
//!
//! The stage is in metres and Y up: (x, y, z) → (x, z, −y), the reverse on the way in. The marking stands in the layer's
//! `customLayerData` under `orb:marking` and in its documentation.

mod decode;
mod encode;
mod layer;
mod packing;
mod read;
mod splats;
#[cfg(test)]
mod tests;
mod write;

pub use read::{marking, read};
pub use write::write;

const FORMAT: &str = "USDZ";
/// Where data begin in a package, bytes.
const ALIGNMENT: u64 = 64;
