//! Training on the GPU: the same schedule as on the CPU, many iterations a submission, nothing read back in between.
//!
//! [`model`] holds what changes, [`table`] the schedule, [`iteration`] one iteration's kernels bound to their buffers,
//! [`run`] submits and watches, [`density`] and [`mcmc`] decide how many
//! there are.
//!
//! No sum is taken atomically but of whole numbers: pairs of tile and Gaussian leave their gradients each at a place of
//! their own, and a Gaussian's are added in a fixed order. So the same input gives the same bytes on one adapter.

mod density;
mod iteration;
mod kernels;
mod mcmc;
pub mod measure;
mod model;
mod run;
mod table;
#[cfg(test)]
mod tests;

pub use run::advance;
