//! Gaussians, cameras, rendering and training (3D Gaussian Splatting, Kerbl et al. 2023).

mod camera;
mod gaussians;

pub use camera::Camera;
pub use gaussians::Gaussians;
