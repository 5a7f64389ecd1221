//! JPEG 2000 (`.jp2`): imagery of terrain, without loss.
//!
//! Sources: ITU-T T.800, Annex A (the codestream's SIZ marker) and Annex I (the boxes); GeoJP2, which puts a degenerate
//! GeoTIFF into a UUID box. The codestream itself comes from OpenJPEG.

mod codestream;

use crate::geotiff::{self, Grid};
use crate::xml::escape;
use crate::{Error, Image, Result};

const FORMAT: &str = "JPEG 2000";
const SIGNATURE: [u8; 12] = [0, 0, 0, 12, b'j', b'P', b' ', b' ', 0x0d, 0x0a, 0x87, 0x0a];
/// Of the box that holds a GeoTIFF.
const GEO_UUID: [u8; 16] =
    [0xb1, 0x4b, 0xf8, 0xbd, 0x08, 0x3d, 0x4b, 0x43, 0xa5, 0xae, 0x8c, 0xd7, 0xd5, 0xa6, 0xce, 0x03];

/// Writes an image of one or three channels, sRGB, so that it comes back bit for bit. `text` goes into an XML box;
/// without `grid` the image has no place.
///
/// # Errors
/// [`Error::Unsupported`] for other channels, a wrong number of pixels, and sides of 0 or more than 65,535.
pub fn write(image: &Image, grid: Option<&Grid>, text: &str) -> Result<Vec<u8>> {
    let (w, h, c) = (image.width, image.height, image.channels);
    let sides = 1..=65_535;
    let pixels = u64::from(w) * u64::from(h) * u64::from(c);
    if !matches!(c, 1 | 3) || !sides.contains(&w) || !sides.contains(&h) || image.pixels.len() as u64 != pixels {
        return Err(Error::unsupported(
            FORMAT,
            format!("1 or 3 channels of 1 to 65,535 by as many pixels are written, found {w} × {h} × {c}"),
        ));
    }
    let stream = codestream::encode(image)?;
    let mut out = SIGNATURE.to_vec();
    add(&mut out, b"ftyp", &[b"jp2 ", &[0; 4][..], b"jp2 "].concat());
    let mut header = Vec::new();
    // Height, width, components; 8 bits unsigned, compressed, a known colour space, no rights.
    let size = [&h.to_be_bytes()[..], &w.to_be_bytes(), &u16::from(c).to_be_bytes(), &[7, 7, 0, 0]];
    add(&mut header, b"ihdr", &size.concat());
    // Enumerated: 16 is sRGB, 17 its grey.
    add(&mut header, b"colr", &[&[1, 0, 0][..], &(if c == 3 { 16u32 } else { 17 }).to_be_bytes()].concat());
    add(&mut out, b"jp2h", &header);
    if !text.is_empty() {
        add(&mut out, b"xml ", format!("<?xml version=\"1.0\"?>\n<Comment>{}</Comment>\n", escape(text)).as_bytes());
    }
    if let Some(grid) = grid {
        add(&mut out, b"uuid", &[&GEO_UUID[..], &geotiff::degenerate(grid)].concat());
    }
    add(&mut out, b"jp2c", &stream);
    Ok(out)
}

/// A box: length, type, content.
fn add(out: &mut Vec<u8>, kind: &[u8; 4], content: &[u8]) {
    out.extend_from_slice(&(content.len() as u32 + 8).to_be_bytes());
    out.extend_from_slice(kind);
    out.extend_from_slice(content);
}

/// What a file says of its image before its data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header {
    pub width: u32,
    pub height: u32,
    /// Bits of each component, negative for signed ones.
    pub bits: Vec<i16>,
    /// The texts of its XML boxes.
    pub texts: Vec<String>,
    /// The GeoTIFF in its UUID box.
    pub geotiff: Option<Vec<u8>>,
}

/// Reads the boxes and the codestream's size; the picture stays packed.
///
/// # Errors
/// [`Error::Malformed`] for what is no JP2 file, or one that is cut short before its data.
pub fn header(bytes: &[u8]) -> Result<Header> {
    if !bytes.starts_with(&SIGNATURE) {
        return Err(Error::malformed(FORMAT, 0, "the signature box", "another beginning"));
    }
    let (mut at, mut texts, mut geotiff) = (SIGNATURE.len(), Vec::new(), None);
    loop {
        let Some((kind, start, end)) = next(bytes, at) else {
            return Err(Error::malformed(FORMAT, at, "a box, and a codestream among them", "the end of the file"));
        };
        let content = &bytes[start..end];
        match kind {
            b"xml " => texts.push(String::from_utf8_lossy(content).into_owned()),
            b"uuid" => geotiff = content.strip_prefix(&GEO_UUID).map(<[u8]>::to_vec).or(geotiff),
            b"jp2c" => {
                let (width, height, bits) = size(content, start)?;
                return Ok(Header { width, height, bits, texts, geotiff });
            }
            _ => {}
        }
        at = end;
    }
}

/// Type, start and end of the content of the box at a place; a length of 0 reaches to the end, 1 is followed by a long one.
fn next(bytes: &[u8], at: usize) -> Option<(&[u8; 4], usize, usize)> {
    let rest = bytes.get(at..)?;
    let (length, tail) = rest.split_first_chunk::<4>()?;
    let (kind, tail) = tail.split_first_chunk::<4>()?;
    let (head, length) = match u32::from_be_bytes(*length) {
        0 => (8, rest.len()),
        1 => (16, usize::try_from(u64::from_be_bytes(*tail.first_chunk()?)).ok()?),
        n => (8, n as usize),
    };
    (length >= head && length <= rest.len()).then_some((kind, at + head, at + length))
}

/// The SIZ marker, which is a codestream's first after SOC (Table A.9).
fn size(stream: &[u8], offset: usize) -> Result<(u32, u32, Vec<i16>)> {
    let refuse = |found: &str| Error::malformed(FORMAT, offset, "a codestream that begins with its size", found);
    if !stream.starts_with(&[0xff, 0x4f, 0xff, 0x51]) {
        return Err(refuse("other markers"));
    }
    let long = |at: usize| {
        stream.get(at..at + 4).map(|b| u32::from_be_bytes([b[0], b[1], b[2], b[3]])).ok_or_else(|| refuse("its end"))
    };
    // Behind length and capabilities: the grid's extent, then the image's offset in it.
    let (width, height) = (long(8)?.checked_sub(long(16)?), long(12)?.checked_sub(long(20)?));
    let (Some(width), Some(height)) = (width, height) else { return Err(refuse("an offset outside the image")) };
    let count = stream.get(40..42).map(|b| u16::from_be_bytes([b[0], b[1]])).ok_or_else(|| refuse("its end"))?;
    let components = stream.get(42..42 + 3 * usize::from(count)).ok_or_else(|| refuse("its end"))?;
    let bits = components.chunks_exact(3).map(|c| {
        let bits = i16::from(c[0] & 0x7f) + 1;
        if c[0] & 0x80 == 0 { bits } else { -bits }
    });
    Ok((width, height, bits.collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_read_back() {
        let grid = Grid { west: -118.5, north: 34.5, step_x: 0.25, step_y: 0.125, posts: false };
        for channels in [1u8, 3] {
            let pixels = (0..33 * 7 * u32::from(channels)).map(|i| (i * 37) as u8).collect();
            let image = Image { width: 33, height: 7, channels, pixels };
            let bytes = write(&image, Some(&grid), "CLASSIFICATION: A & B").unwrap();
            let read = header(&bytes).unwrap();
            assert_eq!((read.width, read.height, read.bits), (33, 7, vec![8; channels.into()]));
            assert!(read.texts[0].contains("CLASSIFICATION: A &amp; B"));
            assert_eq!(geotiff::grid(&read.geotiff.unwrap()).unwrap(), Some(grid));
            for end in [0, 11, 12, 40, 100, bytes.len() - image.pixels.len() / 2] {
                let _ = header(&bytes[..end]);
            }
        }
        let wrong = Image { width: 3, height: 7, channels: 2, pixels: vec![0; 42] };
        assert!(write(&wrong, None, "").is_err());
    }
}
