//! OGC CDB 1.x data stores.

pub mod dbf;
pub mod geocell;
pub mod lod;
pub mod names;
pub mod shapefile;
