//! One file a verb.

pub mod bench;
mod cameras;
pub mod device;
pub mod render;
