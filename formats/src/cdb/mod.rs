//! OGC CDB 1.x data stores: placing a model, and checking a store.
//!
//! A model is geospecific (GSModel), geotypical (GTModel) or moving (MModel): [`Kind`].
//!
//! [`add_model`] turns a model and a store into the files that are new or change, [`add_version`] into a new version of the
//! store, which leaves the old one as it is; [`check`] reads a store and says what
//! breaks the standard. Written is CDB 1.0 with Shapefile, SGI, OpenFlight and stored zips, which readers of every version
//! from 3.x to 1.3 take.
//!
//! The marking stands inside every file that has room for text: `Version.xml` (Comment), the other XML files (a comment),
//! zip archives (the archive comment), `.flt` (the header's comment), `.rgb` (the image name). The fixed fields of
//! `.shp`, `.shx` and `.dbf` have none.

mod add;
mod archive;
mod attributes;
mod chain;
mod check;
mod codes;
pub mod dbf;
mod descriptor;
mod dis;
mod entries;
mod features;
pub mod geocell;
pub mod ground;
mod library;
mod library_model;
pub mod lod;
mod material;
mod metadata;
mod model;
pub mod names;
pub mod shapefile;
mod store;
#[cfg(test)]
mod tests;
mod texture;

use crate::xml;

pub use add::{Added, add_model, add_version};
pub use archive::Archive;
pub use check::{Finding, Report, RuleReport, Verdict, check, report};
pub use dis::EntityType;
pub use ground::{AddedGround, Ground, add_ground};
pub use material::{Base, Material};
pub use metadata::{MAX_VERSIONS, new_store, previous_version};
pub use model::{Kind, Level, Model};
pub use store::{Empty, ListableStore, Memory, Store, Versions};
