//! Rendering on the GPU: WGSL compute kernels on Vulkan, Metal or DX12.
//!
//! [`device`] chooses an adapter and tests it, [`buffers`] uploads a scene, [`sort`] is a stable radix sort with its
//! count on the GPU, [`forward`] draws: project → depth order → (tile, Gaussian) pairs → tile order → ranges → raster.
//! The pictures are those of the CPU renderer, [`super::render`].

mod buffers;
mod bytes;
mod cache;
mod device;
mod forward;
pub(in crate::splat) mod kernel;
pub(in crate::splat) mod plan;
pub(in crate::splat) mod sort;

pub use buffers::Scene;
pub(in crate::splat) use buffers::{MOST_GROUPS, PARTS};
pub use device::{Abilities, Adapter, Gpu, adapters};
pub use forward::{Renderer, STAGES, Timing};
pub(in crate::splat) use plan::SCAN_BLOCK;
pub use sort::sort_pairs;
