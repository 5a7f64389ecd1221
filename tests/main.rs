//! Orb from outside, as one program: linked once, and what waits in one file leaves the processor to another.
//! One file alone: `cargo test --release --test all geo::`.

mod audit;
mod batch;
mod bench;
mod certificate_page;
mod clients;
mod drawn;
mod export;
mod geo;
mod geodesy;
mod globe;
mod gpu;
mod models;
mod networks;
mod photos;
mod place;
mod placed;
mod revocation;
mod scene;
mod serve;
mod serve_postgres;
mod textures;
mod tls;
mod view;
mod webgl;

// What several of them start, drive and read.
#[cfg(feature = "view")]
mod browser;
#[cfg(feature = "serve")]
mod certified;
#[cfg(all(feature = "serve", target_os = "linux"))]
mod cluster;
#[cfg(feature = "serve")]
mod served;
mod sets;
#[cfg(feature = "view")]
mod viewed;

/// A small model, without a search for planes of symmetry: where it is put, who signs it and what networks it takes depend on neither.
const SMALL: [&str; 8] = ["--lods", "1", "--triangles", "1000", "--texture", "256", "--symmetry", "off"];
