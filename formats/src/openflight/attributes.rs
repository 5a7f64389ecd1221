//! Attribute files of textures (`tex.rgb.attr`): how an image is filtered and wrapped. CDB readers ignore them.
//!
//! Source: the attribute file of OpenFlight 16.0 as authoring tools write it, 1604 bytes without control points: from
//! byte 100 on 4 bytes farther than the published table says, which leaves out a filler.

use super::FORMAT;
use crate::{Error, Result};

/// Bytes of a file without control points and subtextures.
const LENGTH: usize = 1604;
const COMMENT: usize = 1024;
const COMMENT_LENGTH: usize = 512;

/// What a file says of its image.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attributes {
    pub width: u32,
    pub height: u32,
    /// Red, green, blue and opacity, and not the first three alone.
    pub alpha: bool,
    /// The border's colour goes on outside, and does not begin again on the other side.
    pub clamp: bool,
    /// Printable ASCII, at most 511 characters: the marking.
    pub comment: String,
}

/// Writes an attribute file: trilinear where the image shrinks, bilinear where it grows, modulated by the light.
///
/// # Errors
/// [`Error::Unsupported`] for a comment that is too long or not ASCII.
pub fn write(attributes: &Attributes) -> Result<Vec<u8>> {
    let Attributes { width, height, alpha, clamp, comment } = attributes;
    if comment.len() >= COMMENT_LENGTH || !comment.bytes().all(|b| (0x20..0x7f).contains(&b)) {
        let what = format!("a comment is printable ASCII of at most {} bytes, found {comment:?}", COMMENT_LENGTH - 1);
        return Err(Error::unsupported(FORMAT, what));
    }
    let mut out = vec![0; LENGTH];
    let wrap = u32::from(*clamp);
    let fields = [
        (0, *width),
        (4, *height),
        (20, 1), // up is +v
        (24, if *alpha { 5 } else { 4 }),
        (28, 6), // trilinear
        (32, 1), // bilinear
        (36, wrap),
        (40, wrap),
        (44, wrap),
        (244, 2), // no filter of its own for opacity when it grows
        (248, 2), // nor for colour
        (1592, 1600),
    ];
    for (at, value) in fields {
        out[at..at + 4].copy_from_slice(&value.to_be_bytes());
    }
    out[COMMENT..COMMENT + comment.len()].copy_from_slice(comment.as_bytes());
    Ok(out)
}

/// Reads an attribute file.
///
/// # Errors
/// [`Error::Malformed`] for a file that is too short or of another format.
pub fn read(bytes: &[u8]) -> Result<Attributes> {
    let word = |at: usize| match bytes.get(at..at + 4) {
        Some(&[a, b, c, d]) => Ok(u32::from_be_bytes([a, b, c, d])),
        _ => Err(Error::malformed(FORMAT, bytes.len(), "an attribute file of 1596 bytes and more", "its end")),
    };
    word(1592)?; // old files of other lengths have the rest at other places
    let comment = &bytes[COMMENT..COMMENT + COMMENT_LENGTH];
    let comment = comment.split(|b| *b == 0).next().unwrap_or_default();
    // 3 takes the value for both directions.
    let wrap = match word(40)? {
        3 => word(36)?,
        own => own,
    };
    Ok(Attributes {
        width: word(0)?,
        height: word(4)?,
        alpha: word(24)? == 5,
        clamp: wrap == 1,
        comment: comment.iter().map(|&b| char::from(b)).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back_equal() {
        for (alpha, clamp) in [(false, true), (true, false)] {
            let comment = "CLASSIFICATION: CUI".to_owned();
            let a = Attributes { width: 512, height: 256, alpha, clamp, comment };
            let bytes = write(&a).unwrap();
            assert_eq!(bytes.len(), 1604);
            assert_eq!(read(&bytes).unwrap(), a);
            assert!((0..1596).all(|n| read(&bytes[..n]).is_err()));
        }
        let long = Attributes { width: 1, height: 1, alpha: false, clamp: true, comment: "x".repeat(512) };
        assert!(write(&long).is_err());
    }
}
