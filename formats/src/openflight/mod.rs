//! OpenFlight 16.0 (`.flt`): models with levels of detail for image generators.
//!
//! Source: OpenFlight 16.0 record descriptions as published in OGC CDB Volume 6 (OGC 16-009), Annex B. A file is a run
//! of big-endian records (u16 opcode, u16 length); palettes come first, then the node tree between push and pop
//! records. Bit 0 of a flag word is its most significant bit.
//!
//! [`write()`] makes faces over a vertex palette, [`write_as`] also meshes; [`read`] takes both; [`check`] looks a file over. What is
//! written reads back equal but for the vertices' sharing: see [`read`]. [`write_master`] makes a file that refers to others.

pub mod attributes;
mod check;
mod geometry;
mod header;
mod master;
mod mesh;
mod palette;
mod read;
mod record;
#[cfg(test)]
mod tests;
mod tree;
mod write;

pub use check::check;
pub use master::{Master, Reference, read_master, write_master};
pub use read::read;
pub use write::{write, write_as};

use crate::Mesh;

const FORMAT: &str = "OpenFlight";

/// The records that hold triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Geometry {
    /// A face record a triangle over one vertex palette: every tested reader shows it.
    #[default]
    Faces,
    /// A mesh a level with a pool of its own: a third of the size. Some readers (Cognitics) build nothing from it.
    Meshes,
}

/// One model: a root group (the CDB global zone) with sibling levels of detail.
///
/// All text is ASCII. Lengths are metres in the model's own frame: X right or east, Y forward or north, Z up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// The root group's name, its Long ID; the zone name in a CDB.
    pub name: String,
    /// The header's date of last revision, at most 31 characters, e.g. `Mon Jan  1 00:00:00 2024`.
    pub date: String,
    /// Latitude and longitude of the model's origin, WGS 84 degrees, flat earth around it.
    pub origin: Option<(f64, f64)>,
    /// The comment of the header: the marking.
    pub header_comment: Option<String>,
    /// The comment of the root group: the CDB zone XML.
    pub zone_comment: Option<String>,
    /// Texture files relative to the model file, `/` between folders, at most 199 characters.
    pub textures: Vec<String>,
    /// Siblings under the root group, in file order: coarsest first, by decreasing significant size.
    pub levels: Vec<Level>,
    /// Named frames beside the levels.
    pub points: Vec<Point>,
}

/// A place with axes: a group that has a comment, a matrix and nothing below it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Point {
    /// What it is for: a CDB point's XML.
    pub comment: String,
    /// From the point's own axes to the model's; row vectors, the place in the last row.
    pub matrix: [[f32; 4]; 4],
}

/// The distance up to which a level of this significant size is needed, metres: where the size covers one of 1080 lines
/// with a vertical field of view of 60° (distance = size · lines / (2 · tan(field / 2))).
pub fn switch_distance(significant_size: f64) -> f64 {
    significant_size * 1080.0 / (2.0 * 0.577_350_269_189_625_8)
}

/// One level of detail: a LOD record with one object below it.
///
/// It is drawn while switch-out ≤ distance to `center` < switch-in.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Level {
    /// Its name, a Long ID. Without one the record's ID is its name.
    pub name: String,
    /// The far limit, metres.
    pub switch_in: f64,
    /// The near limit, metres.
    pub switch_out: f64,
    /// Width of the blending band below the far limit, metres.
    pub transition: f64,
    /// Largest geometric difference to the next coarser level; the model's size for the coarsest, metres.
    pub significant_size: f64,
    /// Where distances are measured from; the same for all levels.
    pub center: [f64; 3],
    /// Index into [`Model::textures`].
    pub texture: Option<usize>,
    pub mesh: Mesh,
}
