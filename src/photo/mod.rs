//! Photo in: decoding within limits, orientation, EXIF, planes of floats, resampling.

mod colour;
mod complete;
mod decode;
mod gps;
mod heif;
mod hevc_colour;
mod metadata;
mod plane;
mod resample;
#[cfg(test)]
mod tag_tests;
#[cfg(test)]
mod tests;
mod xmp;

pub use decode::{Limits, decode, decode_as_stored, metadata};
pub use gps::{AltitudeAbove, Position};
pub use metadata::{DIAGONAL_35MM, Exif, Orientation, focal_in_pixels};
pub use plane::{Plane, silhouette_iou};
pub use resample::{Edge, Rect, sample_colour, sample_plane};
pub use xmp::Gimbal;

/// A decoded photo: sRGB, upright.
#[derive(Clone, Debug)]
pub struct Photo {
    /// File name without folders.
    pub name: String,
    pub media_type: &'static str,
    /// Of the file as read.
    pub sha256: [u8; 32],
    pub byte_len: u64,
    /// Full resolution. Transparent pixels are composited over white.
    pub pixels: image::RgbImage,
    /// The file's alpha channel where it really cuts something out: a hint at the subject. Same size as `pixels`.
    pub cutout: Option<image::GrayImage>,
    pub exif: Exif,
}

impl Photo {
    /// Focal length in pixels, where the file says it.
    pub fn focal(&self) -> Option<f64> {
        let (width, height) = self.pixels.dimensions();
        self.exif.focal_35mm.map(|mm| focal_in_pixels(mm, width, height))
    }
}
