//! `orb view`: one scene on a page of a local port, drawn by Orb's own renderer.
//!
//! The way of a picture: [`server`] checks who asks, [`query`] reads what for, [`worker`] is the one thread that draws,
//! [`draw`] makes the pixels of a [`subject`]. The browser asks for the next picture when it has the last one, so none
//! ever waits in a queue, and a page at rest costs nothing.

pub mod draw;
mod ground;
mod levels;
pub mod open;
pub mod query;
pub mod server;
pub mod subject;
pub mod webgl;
pub mod worker;
