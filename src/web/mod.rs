//! What every page of Orb's on a port has alike: how connections are kept, who is answered, what a browser is told it may do.

pub mod guard;
pub mod listen;
