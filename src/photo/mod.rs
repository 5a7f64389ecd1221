//! Photo in: decoding within limits, orientation, EXIF, planes of floats.

mod plane;

pub use plane::Plane;

/// What the camera wrote beside the picture; absent tags stay `None`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exif {
    /// Focal length in 35 mm equivalent, millimetres.
    pub focal_35mm: Option<f64>,
    /// Bearing of the optical axis, degrees clockwise from true north, [0, 360).
    pub image_direction: Option<f64>,
    /// The direction was relative to magnetic north (then `image_direction` is as written, uncorrected).
    pub direction_is_magnetic: bool,
}

/// A decoded photo: sRGB, upright.
#[derive(Clone, Debug)]
pub struct Photo {
    /// File name without folders.
    pub name: String,
    pub media_type: &'static str,
    /// Of the file as read.
    pub sha256: [u8; 32],
    pub byte_len: u64,
    pub pixels: image::RgbImage,
    pub exif: Exif,
}
