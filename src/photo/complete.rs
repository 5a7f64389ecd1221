//! Is the file all there? Decoders fill what is missing with grey; a photo cut short must be refused instead.

/// A JPEG ends in EOI: markers are walked segment by segment, so that an EOI inside a thumbnail does not count.
/// ITU-T T.81 §B.1.
pub(super) fn jpeg_reaches_its_end(bytes: &[u8]) -> bool {
    let mut at = 2;
    let mut scans = 0;
    loop {
        // To the next marker: entropy-coded data holds FF only as FF00 or FF RSTn.
        let Some(skip) = bytes.get(at..).and_then(|rest| rest.iter().position(|&b| b == 0xff)) else { return false };
        at += skip + 1;
        let Some(&marker) = bytes.get(at) else { return false };
        match marker {
            0x00 | 0x01 | 0xd0..=0xd7 => at += 1,
            0xff => {} // a fill byte
            0xd8 => at += 1,
            0xd9 => return scans > 0,
            _ => {
                let Some(length) = bytes.get(at + 1..at + 3) else { return false };
                scans += usize::from(marker == 0xda);
                at += 1 + usize::from(u16::from_be_bytes([length[0], length[1]])).max(2);
            }
        }
    }
}

/// A RIFF container is as long as its header says.
pub(super) fn webp_reaches_its_end(bytes: &[u8]) -> bool {
    bytes
        .get(4..8)
        .and_then(|size| size.try_into().ok())
        .is_some_and(|size| u64::from(u32::from_le_bytes(size)) + 8 <= bytes.len() as u64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{ImageFormat, RgbImage};

    fn encode(format: ImageFormat) -> Vec<u8> {
        let mut out = std::io::Cursor::new(Vec::new());
        let picture = RgbImage::from_fn(96, 80, |x, y| image::Rgb([(x * 7) as u8, (y * 5) as u8, (x * y) as u8]));
        picture.write_to(&mut out, format).unwrap();
        out.into_inner()
    }

    #[test]
    fn every_cut_of_a_jpeg_is_seen() {
        let whole = encode(ImageFormat::Jpeg);
        assert!(jpeg_reaches_its_end(&whole));
        for length in 0..whole.len() {
            assert!(!jpeg_reaches_its_end(&whole[..length]), "cut at {length} of {}", whole.len());
        }
    }

    #[test]
    fn a_thumbnail_does_not_end_the_photo() {
        let whole = encode(ImageFormat::Jpeg);
        let mut outer = vec![0xff, 0xd8, 0xff, 0xe1];
        outer.extend_from_slice(&(whole.len() as u16 + 2).to_be_bytes());
        outer.extend_from_slice(&whole);
        outer.extend_from_slice(&whole[2..]);
        assert!(jpeg_reaches_its_end(&outer));
        assert!(!jpeg_reaches_its_end(&outer[..outer.len() - 40]));
    }

    #[test]
    fn every_cut_of_a_webp_is_seen() {
        let whole = encode(ImageFormat::WebP);
        assert!(webp_reaches_its_end(&whole));
        assert!((0..whole.len()).all(|length| !webp_reaches_its_end(&whole[..length])));
    }
}
