//! Orb: one photo becomes a georeferenced, marked and sealed simulation asset, offline.
//!
//! The way of the data, one direction, no way back:
//! [`photo`] → [`models`] → [`views`] → [`splat`] → [`mesh`] → [`geo`] → `orb_formats` → [`audit`] → published folder.
//! [`pipeline`] reads like that line.

// A panic on input is a fault of the program: what can fail says so.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::unreachable,
        clippy::todo,
        clippy::unimplemented
    )
)]

pub mod audit;
pub mod bench;
pub mod cli;
pub mod error;
pub mod export;
pub mod geo;
pub mod memory;
pub mod mesh;
pub mod models;
pub mod photo;
pub mod photos;
pub mod pipeline;
pub mod preview;
pub mod progress;
#[cfg(feature = "serve")]
pub mod serve;
pub mod sources;
pub mod splat;
pub mod symmetry;
#[cfg(feature = "view")]
pub mod view;
pub mod views;
#[cfg(feature = "view")]
pub mod web;
mod whole_file;

pub use error::{Error, Kind, Result};
