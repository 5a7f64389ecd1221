//! EXIF and XMP: what a reconstruction can use of what the camera wrote beside the picture.

use exif::{In, Reader, Tag, Value};
use glam::DVec3;

use super::gps::{self, Position};
use super::maker_note;
use super::xmp::{self, Gimbal};

/// What the camera wrote beside the picture; absent tags stay `None`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exif {
    /// Focal length in 35 mm equivalent, millimetres; of the whole picture that the camera took.
    pub focal_35mm: Option<f64>,
    /// Somebody said that in place of the file.
    pub focal_given: bool,
    /// Pixels of that picture, as written.
    pub taken: Option<(u32, u32)>,
    /// Bearing of the optical axis, degrees clockwise from true north, [0, 360).
    pub image_direction: Option<f64>,
    /// The direction was relative to magnetic north (then `image_direction` is as written, uncorrected).
    pub direction_is_magnetic: bool,
    /// The camera's place.
    pub position: Option<Position>,
    /// The name of a datum other than WGS84, for which the position was left out.
    pub foreign_datum: Option<String>,
    /// Metres to what the camera focused on.
    pub subject_distance: Option<f64>,
    /// Year, month, day of the picture.
    pub date: Option<(i64, i64, i64)>,
    /// From XMP.
    pub gimbal: Option<Gimbal>,
    /// Where down is for the camera, in its axes (right, down, forward) as the picture is seen upright, where it measured that.
    pub down: Option<DVec3>,
}

impl Exif {
    /// Adds what an XMP packet says where EXIF is silent; a drone's receiver knows its own accuracy best.
    pub(super) fn with_xmp(mut self, packet: &[u8]) -> Self {
        let xmp = xmp::read(packet);
        if self.image_direction.is_none() {
            self.image_direction = xmp.image_direction;
            self.direction_is_magnetic = xmp.direction_is_magnetic;
        }
        self.focal_35mm = self.focal_35mm.or(xmp.focal_35mm);
        self.gimbal = xmp.gimbal;
        if self.foreign_datum.is_none() {
            self.position = self.position.or(xmp.position).map(|p| Position {
                accuracy: xmp.accuracy.or(p.accuracy),
                vertical_accuracy: xmp.vertical_accuracy.or(p.vertical_accuracy),
                ..p
            });
        }
        self
    }

    /// Of a camera whose focal length somebody says.
    pub fn with_focal(self, given: Option<f64>) -> Self {
        match given {
            Some(_) => Exif { focal_35mm: given, focal_given: true, ..self },
            None => self,
        }
    }

    /// Of a picture of `width` by `height`: where it has another shape than what the camera took, somebody cut it, and of what is left
    /// nobody knows the focal length, nor where the optical axis was.
    pub(super) fn of_picture(mut self, width: u32, height: u32) -> Self {
        let shape = |(w, h): (u32, u32)| f64::from(w.max(h)) / f64::from(w.min(h).max(1));
        if self.taken.is_some_and(|taken| (shape(taken) / shape((width, height)) - 1.0).abs() > 0.02) {
            self.focal_35mm = None;
            self.down = None;
        }
        self
    }
}

/// EXIF tag 0x0112: what must be done to the stored rows to see the picture upright.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Orientation {
    #[default]
    Upright,
    FlipHorizontal,
    Rotate180,
    FlipVertical,
    /// Mirrored about the main diagonal.
    Transpose,
    /// Clockwise.
    Rotate90,
    /// Mirrored about the other diagonal.
    Transverse,
    Rotate270,
}

impl Orientation {
    /// Values outside 1–8 mean upright, as viewers do.
    pub fn from_tag(value: u32) -> Self {
        match value {
            2 => Self::FlipHorizontal,
            3 => Self::Rotate180,
            4 => Self::FlipVertical,
            5 => Self::Transpose,
            6 => Self::Rotate90,
            7 => Self::Transverse,
            8 => Self::Rotate270,
            _ => Self::Upright,
        }
    }
}

/// The diagonal of a 36 × 24 mm frame.
pub const DIAGONAL_35MM: f64 = 43.266_615_305_567_87;

/// Pixels of a photo of this size, of a focal length that is said for a frame of 36 × 24 mm: by both diagonals.
pub fn focal_in_pixels(focal_35mm: f64, width: u32, height: u32) -> f64 {
    focal_35mm * f64::from(width).hypot(f64::from(height)) / DIAGONAL_35MM
}

/// Reads a raw EXIF block (a TIFF structure). Damaged tags are skipped: a photo is not refused for its metadata.
pub(super) fn read(block: Vec<u8>) -> (Exif, Orientation) {
    let Ok(tags) =
        Reader::new().continue_on_error(true).read_raw(block).or_else(|error| error.distill_partial_result(|_| ()))
    else {
        return Default::default();
    };
    let uint = |tag| tags.get_field(tag, In::PRIMARY).and_then(|f| f.value.get_uint(0));
    let real = |tag| tags.get_field(tag, In::PRIMARY).and_then(|f| real(&f.value));
    let taken = uint(Tag::PixelXDimension).zip(uint(Tag::PixelYDimension)).filter(|(w, h)| *w.min(h) > 0);
    let focal_35mm = uint(Tag::FocalLengthIn35mmFilm)
        .filter(|&focal| focal > 0)
        .map(f64::from)
        .or_else(|| {
            let pixels = taken.map(|(w, h)| (f64::from(w), f64::from(h)))?;
            let per_unit = (real(Tag::FocalPlaneXResolution)?, real(Tag::FocalPlaneYResolution)?);
            let unit_mm = match uint(Tag::FocalPlaneResolutionUnit).unwrap_or(2) {
                2 => 25.4,
                3 => 10.0,
                _ => return None,
            };
            let diagonal = (pixels.0 / per_unit.0).hypot(pixels.1 / per_unit.1) * unit_mm;
            Some(real(Tag::FocalLength)? * DIAGONAL_35MM / diagonal)
        })
        .filter(|f| (4.0..=3000.0).contains(f));
    let image_direction =
        real(Tag::GPSImgDirection).filter(|d| (0.0..=360.0).contains(d)).map(|d| if d == 360.0 { 0.0 } else { d });
    let direction_is_magnetic = image_direction.is_some()
        && tags.get_field(Tag::GPSImgDirectionRef, In::PRIMARY).is_some_and(
            |f| matches!(&f.value, Value::Ascii(text) if text.first().is_some_and(|t| t.starts_with(b"M"))),
        );
    let orientation = uint(Tag::Orientation).map(Orientation::from_tag).unwrap_or_default();
    let exif = Exif {
        focal_35mm,
        focal_given: false,
        taken,
        image_direction,
        direction_is_magnetic,
        position: gps::position(&tags),
        foreign_datum: gps::foreign_datum(&tags),
        // EXIF 3.0, section 4.6.5.1: 0 is unknown, all ones is infinity.
        subject_distance: real(Tag::SubjectDistance).filter(|d| (0.05..10_000.0).contains(d)),
        date: gps::date(&tags),
        gimbal: None,
        down: maker_note::down(&tags, orientation),
    };
    (exif, orientation)
}

pub(super) fn real(value: &Value) -> Option<f64> {
    let number = match value {
        Value::Rational(v) => v.first()?.to_f64(),
        Value::SRational(v) => v.first()?.to_f64(),
        Value::Float(v) => f64::from(*v.first()?),
        Value::Double(v) => *v.first()?,
        other => f64::from(other.get_uint(0)?),
    };
    number.is_finite().then_some(number)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::photo::tests::exif_block;

    fn rational(numerator: u32, denominator: u32) -> Vec<exif::Rational> {
        vec![exif::Rational { num: numerator, denom: denominator }]
    }

    #[test]
    fn focal_length_in_35_mm_is_taken_as_written() {
        let (exif, _) = read(exif_block(&[
            (Tag::FocalLengthIn35mmFilm, Value::Short(vec![28])),
            (Tag::FocalLength, Value::Rational(rational(50, 10))),
        ]));
        assert_eq!(exif.focal_35mm, Some(28.0));
    }

    #[test]
    fn what_somebody_cut_from_a_picture_has_no_known_focal_length() {
        let (exif, _) = read(exif_block(&[
            (Tag::FocalLengthIn35mmFilm, Value::Short(vec![28])),
            (Tag::PixelXDimension, Value::Long(vec![4000])),
            (Tag::PixelYDimension, Value::Long(vec![3000])),
        ]));
        let of = |width, height| exif.clone().of_picture(width, height).focal_35mm;
        // Made smaller, to whole pixels; stood upright.
        assert_eq!([of(4000, 3000), of(1333, 1000), of(768, 1024)], [Some(28.0); 3]);
        assert_eq!([of(3000, 3000), of(4000, 2250)], [None; 2]);
        let silent = Exif { taken: None, ..exif.clone() };
        assert_eq!(silent.of_picture(3000, 3000).focal_35mm, Some(28.0));
    }

    #[test]
    fn focal_length_is_scaled_by_the_sensor_where_its_pitch_is_known() {
        // 6000 × 4000 pixels at 2540 a centimetre: 23.62 × 15.75 mm, crop factor 1.524.
        let tags = [
            (Tag::FocalLengthIn35mmFilm, Value::Short(vec![0])),
            (Tag::FocalLength, Value::Rational(rational(20, 1))),
            (Tag::PixelXDimension, Value::Long(vec![6000])),
            (Tag::PixelYDimension, Value::Long(vec![4000])),
            (Tag::FocalPlaneXResolution, Value::Rational(rational(2540, 1))),
            (Tag::FocalPlaneYResolution, Value::Rational(rational(2540, 1))),
            (Tag::FocalPlaneResolutionUnit, Value::Short(vec![3])),
        ];
        // A zero in the 35 mm tag means unknown (EXIF 2.32 §4.6.5).
        let focal = read(exif_block(&tags)).0.focal_35mm.unwrap();
        assert!((focal - 20.0 * 1.524).abs() < 0.01, "{focal}");
        assert_eq!(read(exif_block(&tags[1..2])).0.focal_35mm, None, "no sensor size, no guess");
    }

    #[test]
    fn direction_with_its_reference() {
        let tags = |reference: &str, degrees: Vec<exif::Rational>| {
            exif_block(&[
                (Tag::GPSImgDirectionRef, Value::Ascii(vec![reference.into()])),
                (Tag::GPSImgDirection, Value::Rational(degrees)),
            ])
        };
        let (exif, _) = read(tags("M", rational(12345, 100)));
        assert_eq!((exif.image_direction, exif.direction_is_magnetic), (Some(123.45), true));
        let (exif, _) = read(tags("T", rational(360, 1)));
        assert_eq!((exif.image_direction, exif.direction_is_magnetic), (Some(0.0), false));
        assert_eq!(read(tags("T", rational(1, 0))).0.image_direction, None);
        assert_eq!(read(tags("M", rational(999, 1))).0, Exif::default());
    }

    #[test]
    fn garbage_is_no_exif() {
        for block in [vec![], b"II*\0".to_vec(), vec![0xff; 300], b"MM\0*\0\0\0\x08\xff\xff".to_vec()] {
            assert_eq!(read(block), Default::default());
        }
    }
}
