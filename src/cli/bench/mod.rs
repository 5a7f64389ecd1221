//! `orb bench`: how fast this machine is at it, and how true what comes out.

mod compare;
pub mod mesh;
mod scene;
pub mod speed;
mod truth;
