//! `orb bench`: how fast this machine is at it, and how true what comes out.

mod compare;
pub mod mesh;
mod nerf;
mod scene;
pub mod speed;
pub mod train;
mod truth;
