//! Networks: engines that run graphs, one file or folder a family, and the registry of weights that a user imported.
//!
//! A stage names the tensors it wants; which engine runs the graph is no concern of it.

// The built-in networks, in the order of the pipeline.
pub mod prior;
pub mod scene;
pub mod splat_prior;

// The networks of the paper, for who imports them.
pub mod depth;
pub mod sam;
pub mod zero123;

// What a user imports, and what runs a graph.
pub mod engine;
pub mod onnx;
pub mod registry;
mod tensor;

// What the stages share.
pub mod align;
pub mod colour_model;
pub mod graph_cut;
pub mod guided;
mod mixture;
pub mod pattern_search;
pub mod picture;
pub mod region;

pub use engine::{Engine, Graph, Rten};
pub(crate) use tensor::take;
pub use tensor::{Element, Port, Tensor, check_contract, difference};
