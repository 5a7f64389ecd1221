//! Apple's maker note: how the phone was held, by its accelerometer.

use exif::Exif;
use exif::{In, Tag, Value};
use glam::DVec3;

use super::Orientation;

/// Of the note's directory: gravity in units of g, by the phone's axes: right, to its top, out of its face.
const ACCELERATION_VECTOR: u16 = 8;
/// A hand that shakes adds so much.
const STILL: std::ops::RangeInclusive<f64> = 0.9..=1.1;

/// Where down is for the camera, in its axes (right, down, forward) as the picture is seen upright. `None` where nothing says it, of
/// cameras beside the display, and where picture and phone contradict each other on what is up.
pub(super) fn down(tags: &Exif, orientation: Orientation) -> Option<DVec3> {
    let front = tags
        .get_field(Tag::LensModel, In::PRIMARY)
        .is_some_and(|f| f.display_value().to_string().to_ascii_lowercase().contains("front"));
    // Some programs that save a photo again write it as plain bytes.
    let (Value::Undefined(note, _) | Value::Byte(note)) = &tags.get_field(Tag::MakerNote, In::PRIMARY)?.value else {
        return None;
    };
    let [x, y, z] = acceleration(note).filter(|_| !front)?;
    let g = DVec3::new(x, y, z);
    if !STILL.contains(&g.length()) {
        return None;
    }
    // The sensor's rows run from the phone's top to its bottom, its columns from right to left.
    let (across, below) = match orientation {
        Orientation::Upright => (-y, -x),
        Orientation::FlipHorizontal => (y, -x),
        Orientation::Rotate180 => (y, x),
        Orientation::FlipVertical => (-y, x),
        Orientation::Transpose => (-x, -y),
        Orientation::Rotate90 => (x, -y),
        Orientation::Transverse => (x, y),
        Orientation::Rotate270 => (-x, y),
    };
    let down = DVec3::new(across, below, -z).normalize();
    // Nobody holds a camera that far askew; somebody has turned the picture. Looking straight down or up there is no telling.
    let aside = across.hypot(below);
    (aside < 0.3 || below > 0.85 * aside).then_some(down)
}

/// The note is a TIFF directory, big-endian, after 14 bytes; offsets count from the note's beginning.
fn acceleration(note: &[u8]) -> Option<[f64; 3]> {
    let half = |at: usize| Some(u16::from_be_bytes(note.get(at..at + 2)?.try_into().ok()?));
    let word = |at: usize| Some(i32::from_be_bytes(note.get(at..at.checked_add(4)?)?.try_into().ok()?));
    if !note.starts_with(b"Apple iOS\0") || note.get(12..14) != Some(b"MM") {
        return None;
    }
    // Tag, kind 10 of signed fractions, three of them, where they stand.
    let entry = (0..usize::from(half(14)?)).map(|i| 16 + 12 * i).find(|at| half(*at) == Some(ACCELERATION_VECTOR))?;
    if half(entry + 2)? != 10 || word(entry + 4)? != 3 {
        return None;
    }
    let from = usize::try_from(word(entry + 8)?).ok()?;
    let fraction = |i: usize| {
        let at = from.checked_add(8 * i)?;
        let value = f64::from(word(at)?) / f64::from(word(at.checked_add(4)?)?);
        value.is_finite().then_some(value)
    };
    Some([fraction(0)?, fraction(1)?, fraction(2)?])
}

#[cfg(test)]
mod tests {
    use super::super::tests::exif_block;
    use super::*;

    /// A note as phones write it, with this vector.
    fn note(vector: [f64; 3]) -> Vec<u8> {
        let mut out = b"Apple iOS\0\0\x01MM\0\x02".to_vec();
        // The note's version, then the vector at 44.
        out.extend([0, 1, 0, 9, 0, 0, 0, 1, 0, 0, 0, 14]);
        out.extend([0, 8, 0, 10, 0, 0, 0, 3, 0, 0, 0, 44]);
        out.extend([0; 4]);
        vector.iter().for_each(|v| {
            out.extend(((v * 1e4) as i32).to_be_bytes());
            out.extend(10_000i32.to_be_bytes());
        });
        out
    }

    fn read(vector: [f64; 3], orientation: u16, lens: &str) -> Option<DVec3> {
        let fields = [
            (Tag::Orientation, Value::Short(vec![orientation])),
            (Tag::LensModel, Value::Ascii(vec![lens.into()])),
            (Tag::MakerNote, Value::Undefined(note(vector), 0)),
        ];
        super::super::metadata::read(exif_block(&fields)).0.down
    }

    #[test]
    fn a_phone_knows_how_it_was_held() {
        let back = "back dual wide camera 4.25mm f/1.6";
        let near = |a: Option<DVec3>, b: [f64; 3]| a.is_some_and(|a| (a - DVec3::from(b)).length() < 1e-3);
        // On its side, its top to the left, looking up by 20°: gravity to its left, and into its back.
        let (sin, cos) = 20f64.to_radians().sin_cos();
        assert!(near(read([-cos, 0.0, sin], 1, back), [0.0, cos, -sin]));
        // Upright, looking down by 20°.
        assert!(near(read([0.0, -cos, -sin], 6, back), [0.0, cos, sin]));
        // On its other side; on its head.
        assert!(near(read([cos, 0.0, 0.0].map(|v| v / cos), 3, back), [0.0, 1.0, 0.0]));
        assert!(near(read([0.0, 1.0, 0.0], 8, back), [0.0, 1.0, 0.0]));
        // Leant to the right by 5°, as it is held: down lies to the picture's left.
        let (s5, c5) = 5f64.to_radians().sin_cos();
        assert!(near(read([-s5, -c5, 0.0], 6, back), [-s5, c5, 0.0]));
        // Flat, looking straight down.
        assert!(near(read([0.0, 0.0, -1.0], 6, back), [0.0, 0.0, 1.0]));
    }

    #[test]
    fn what_is_not_to_be_believed_is_left_out() {
        let back = "back camera";
        assert_eq!(read([0.0, -1.0, 0.0], 1, back), None, "turned by somebody");
        assert_eq!(read([0.0, -1.4, 0.0], 6, back), None, "shaken");
        assert_eq!(read([0.0, -1.0, 0.0], 6, "iPhone 12 front camera 2.71mm f/2.2"), None);
        let whole = note([0.0, -1.0, 0.0]);
        assert_eq!(acceleration(&whole), Some([0.0, -1.0, 0.0]));
        for length in 0..whole.len() {
            assert_eq!(acceleration(&whole[..length]), None, "{length}");
        }
        for at in 0..whole.len() {
            for value in [0, 0x7f, 0xff] {
                let mut damaged = whole.clone();
                damaged[at] = value;
                acceleration(&damaged);
            }
        }
    }
}
