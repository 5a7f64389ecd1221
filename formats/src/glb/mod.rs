//! Binary glTF 2.0 (`.glb`): textured meshes with PBR materials, and Gaussian splats.
//!
//! Sources: Khronos glTF 2.0 specification (ISO/IEC 12113:2022); `KHR_xmp_json_ld` for the marking;
//! `KHR_gaussian_splatting` (ratified 2026) for splats. glTF is Y up and its texture coordinates begin at the upper-left
//! corner: (x, y, z) → (x, z, −y) and v → 1 − v on the way out, the reverse on the way in. Splats are handed over Y up.
//!
//! A level of detail is a file of its own. `MSFT_lod` would put them all into one, but it is a vendor's extension that
//! common readers (three.js, Cesium, Blender) skip: they would load every level to draw one. 3D Tiles want a file a
//! level in any case.

mod accessors;
mod container;
mod json;
mod meshopt;
mod read;
mod splats;
#[cfg(test)]
mod tests;
mod transform;
mod write;

pub use read::read;
pub use write::{Compression, write, write_as};

const FORMAT: &str = "GLB";
/// Name of the extension for splats.
const SPLATTING: &str = "KHR_gaussian_splatting";
const UNLIT: &str = "KHR_materials_unlit";
/// Name of the extension for metadata.
const XMP: &str = "KHR_xmp_json_ld";
/// Name of the extension for texture coordinates that a material changes.
const TEXTURE_TRANSFORM: &str = "KHR_texture_transform";
