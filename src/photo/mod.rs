//! Photo in: decoding within limits, orientation, EXIF, planes of floats, resampling.

mod colour;
mod complete;
mod decode;
pub mod down;
mod gps;
mod heif;
mod hevc_colour;
mod maker_note;
mod metadata;
mod pinhole;
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
pub use pinhole::Pinhole;
pub use plane::{Plane, silhouette_iou};
pub use resample::{Edge, Rect, sample_colour, sample_plane, sampled_at};
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
    /// Its camera, where the file says its focal length.
    pub fn pinhole(&self) -> Option<Pinhole> {
        self.exif.focal_35mm.map(|mm| self.pinhole_of(mm))
    }

    /// The same with a focal length that is said for a frame of 36 × 24 mm.
    pub fn pinhole_of(&self, focal_35mm: f64) -> Pinhole {
        let size = self.pixels.dimensions();
        Pinhole::centred(focal_in_pixels(focal_35mm, size.0, size.1), size)
    }
}
