//! Several photos of one thing.

pub mod colmap;
