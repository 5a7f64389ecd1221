//! `orb bench`: how fast this machine is at it.

mod scene;
pub mod speed;
