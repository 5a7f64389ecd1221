//! Zero123++ 1.1 and 1.2: six views of the subject from one, by diffusion, from five graphs and a prompt;
//! their normals, where there is a sixth.
//!
//! R. Shi et al., "Zero123++: a single image to consistent multi-view diffusion base model", arXiv:2310.15110. The sampler
//! runs here; the graphs are the picture encoder of CLIP, the two halves of the VAE, and the UNet twice: as it writes what its
//! self-attentions see of the photo, and as it reads that while it works on the views. The sixth
//! is the ControlNet that leads the UNet from the views' colours to their normals.

pub mod cache;
mod condition;
mod prompt;
mod sampler;
mod scheduler;

pub use prompt::Prompt;
#[cfg(test)]
pub(crate) use prompt::tests::file as prompt_file;
pub use sampler::{Settings, TILE, six_views};
