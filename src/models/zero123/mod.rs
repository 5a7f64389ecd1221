//! Zero123++ 1.1 and 1.2: six views of the subject from one, by diffusion.
//!
//! R. Shi et al., "Zero123++: a single image to consistent multi-view diffusion base model", arXiv:2310.15110.

mod prompt;

pub use prompt::Prompt;
