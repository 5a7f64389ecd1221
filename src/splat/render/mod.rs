//! Rendering on the CPU: projection → binning → raster_forward, and raster_backward → projection on the way back.

// Matrices are written with their indices, as in the papers.
#![allow(clippy::needless_range_loop)]

pub(crate) mod binning;
mod cpu;
pub mod gpu;
pub(crate) mod projection;
pub(crate) mod raster_backward;
pub(crate) mod raster_forward;
#[cfg(test)]
pub(crate) mod reference;
pub(crate) mod sh;
#[cfg(test)]
pub(crate) mod tests;

pub(crate) use cpu::Raster;
use cpu::unit;
pub use cpu::{Drawer, Drawers, Frame, normals, render, to_bytes};
pub use projection::Shown;
pub use raster_forward::{MEDIAN, SurfaceDepth};
