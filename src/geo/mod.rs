//! WGS84, local frames, scale and placement; everything on the Earth in f64.

mod origin;
mod placement;
mod scale;
mod wgs84;

pub use origin::parse_origin;
pub use placement::{HeadingSource, Placement};
pub use scale::{Extents, Known, Scale, ScaleSource, View, metres_per_unit};
pub use wgs84::{Ecef, Enu, Geodetic};
