//! WGS84, local frames, heights, terrain, scale and placement; everything on the Earth in f64.

mod angle;
mod datum;
pub mod dem;
mod epsg;
mod extents;
pub mod footprint;
pub mod geoid;
pub mod magnetic;
pub mod mgrs;
pub mod ortho;
mod placement;
mod positive;
mod proj;
pub mod scale;
pub mod sidecar;
pub mod sight;
pub mod similarity;
mod transverse_mercator;
mod utm;
mod wgs84;
mod written;

pub use datum::{AltDatum, Height, to_ellipsoid};
pub use extents::{Extents, convex_hull};
pub use placement::{HeadingSource, Placement, Uncertainty};
pub use proj::version as proj_version;
pub use scale::{Known, Scale, ScaleSource, View, metres_per_unit};
pub use utm::{Utm, normalised_longitude, standard_zone};
pub use wgs84::{Ecef, Enu, Geodetic, LocalFrame};
pub use written::{Written, parse_point};
