//! One file a verb.

pub mod audit;
