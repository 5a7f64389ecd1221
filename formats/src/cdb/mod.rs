//! cdb/mod
