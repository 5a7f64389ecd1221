//! Gaussians, cameras, rendering and training (3D Gaussian Splatting, Kerbl et al. 2023).

mod camera;
pub mod cameras;
mod gaussians;
pub(crate) mod packed;
pub mod render;
mod sh_rotation;
pub(crate) mod simd;
pub mod train;

pub use camera::Camera;
pub use gaussians::{Gaussians, SH_C0, SH_COEFFICIENTS};
pub use render::{Frame, render};
pub use train::{Engine, Options, Report, Target, Trained, train};
