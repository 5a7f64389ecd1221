//! Several photos of one thing: where their cameras stood, what of each is the subject, and in which frame all agree.
//!
//! [`poses`] (COLMAP's model or a list) → [`crops`] (the subject of each photo) → [`frame`] (up, middle, size) → [`start`]
//! (Gaussians to begin with). `pipeline::several` reads like this line.

pub mod adjust;
pub mod colmap;
pub mod control;
pub mod crops;
pub mod dataset;
pub mod frame;
pub mod poses;
pub mod register;
pub mod reprojection;
pub mod sfm;
pub mod start;
pub mod transforms;

pub use poses::{Observation, Posed, Poses};
