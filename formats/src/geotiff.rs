//! GeoTIFF: heights of terrain in WGS 84 degrees, one band of floats, not compressed.
//!
//! Sources: TIFF 6.0; OGC 19-008r4 (GeoTIFF 1.1). Read is any kind of sample that the `tiff` crate unpacks.

use std::io::Cursor;

use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;

use crate::{Error, Result};

const FORMAT: &str = "GeoTIFF";
/// Larger images are refused.
const MAX_SIDE: u32 = 2048;

/// How pixels lie on the Earth, WGS 84 degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Of the first pixel: its post where pixels are posts, else its north-west corner.
    pub west: f64,
    pub north: f64,
    /// Degrees from pixel to pixel, both positive: rows go south.
    pub step_x: f64,
    pub step_y: f64,
    /// Pixels stand for points and not for areas.
    pub posts: bool,
}

/// Numbers, row by row from the north-west.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    pub width: u32,
    pub height: u32,
    /// Bands that stand beside one another in a pixel.
    pub bands: usize,
    pub samples: Samples,
    pub grid: Option<Grid>,
}

/// The kinds that terrain and imagery come in.
#[derive(Clone, Debug, PartialEq)]
pub enum Samples {
    Floats(Vec<f32>),
    /// Signed.
    Integers(Vec<i32>),
    Bytes(Vec<u8>),
}

#[derive(Default)]
struct Directory {
    /// Tag, type, count, value or the bytes elsewhere.
    entries: Vec<(u16, u16, u32, Vec<u8>)>,
}

impl Directory {
    fn shorts(&mut self, tag: u16, values: &[u16]) {
        self.entries.push((tag, 3, values.len() as u32, values.iter().flat_map(|v| v.to_le_bytes()).collect()));
    }

    fn long(&mut self, tag: u16, value: u32) {
        self.entries.push((tag, 4, 1, value.to_le_bytes().to_vec()));
    }

    fn doubles(&mut self, tag: u16, values: &[f64]) {
        self.entries.push((tag, 12, values.len() as u32, values.iter().flat_map(|v| v.to_le_bytes()).collect()));
    }

    fn text(&mut self, tag: u16, text: &str) {
        let bytes: Vec<u8> = text.bytes().chain([0]).collect();
        self.entries.push((tag, 2, bytes.len() as u32, bytes));
    }

    /// Place and coordinate system.
    fn grid(&mut self, grid: &Grid) {
        self.doubles(33_550, &[grid.step_x, grid.step_y, 0.0]);
        self.doubles(33_922, &[0.0, 0.0, 0.0, grid.west, grid.north, 0.0]);
        // Geographic, area or point, WGS 84, degrees.
        let kind = if grid.posts { 2 } else { 1 };
        self.shorts(34_735, &[1, 1, 0, 4, 1024, 0, 1, 2, 1025, 0, 1, kind, 2048, 0, 1, 4326, 2054, 0, 1, 9102]);
    }

    /// The file: header, directory, what the directory refers to, the pixels.
    fn file(mut self, pixels: &[u8]) -> Vec<u8> {
        self.entries.sort_by_key(|e| e.0);
        let mut free = 8 + 2 + 12 * self.entries.len() + 4;
        let strip =
            free + self.entries.iter().filter(|e| e.3.len() > 4).map(|e| e.3.len().next_multiple_of(8)).sum::<usize>();
        let mut out = b"II*\0\x08\0\0\0".to_vec();
        out.extend_from_slice(&(self.entries.len() as u16).to_le_bytes());
        let mut behind = Vec::new();
        for (tag, kind, count, mut bytes) in self.entries {
            if tag == 273 {
                bytes = (strip as u32).to_le_bytes().to_vec();
            }
            out.extend_from_slice(&tag.to_le_bytes());
            out.extend_from_slice(&kind.to_le_bytes());
            out.extend_from_slice(&count.to_le_bytes());
            if bytes.len() > 4 {
                out.extend_from_slice(&(free as u32).to_le_bytes());
                bytes.resize(bytes.len().next_multiple_of(8), 0);
                free += bytes.len();
                behind.append(&mut bytes);
            } else {
                bytes.resize(4, 0);
                out.append(&mut bytes);
            }
        }
        out.extend_from_slice(&[0; 4]);
        out.append(&mut behind);
        out.extend_from_slice(pixels);
        out
    }
}

/// Writes heights; `text` becomes the image's description.
///
/// # Errors
/// [`Error::Unsupported`] for a wrong number of heights, some that are not finite, and sides of 0 or above 2048.
pub fn write(width: u32, height: u32, heights: &[f32], grid: &Grid, text: &str) -> Result<Vec<u8>> {
    let sides = 1..=MAX_SIDE;
    if !sides.contains(&width)
        || !sides.contains(&height)
        || heights.len() as u64 != u64::from(width) * u64::from(height)
    {
        return Err(Error::unsupported(FORMAT, format!("{} heights of {width} × {height}", heights.len())));
    }
    if let Some(i) = heights.iter().position(|h| !h.is_finite()) {
        return Err(Error::unsupported(FORMAT, format!("heights are numbers, found {} at {i}", heights[i])));
    }
    let pixels: Vec<u8> = heights.iter().flat_map(|h| h.to_le_bytes()).collect();
    let mut directory = image(width, height, 32, pixels.len());
    directory.shorts(339, &[3]);
    if !text.is_empty() {
        directory.text(270, text);
    }
    directory.grid(grid);
    Ok(directory.file(&pixels))
}

/// The GeoTIFF of one black pixel that tells where an image of another format lies.
pub fn degenerate(grid: &Grid) -> Vec<u8> {
    let mut directory = image(1, 1, 8, 1);
    directory.grid(grid);
    directory.file(&[0])
}

fn image(width: u32, height: u32, bits: u16, bytes: usize) -> Directory {
    let mut directory = Directory::default();
    directory.long(256, width);
    directory.long(257, height);
    directory.shorts(258, &[bits]);
    // Not compressed, black is zero, one strip of one sample a pixel.
    directory.shorts(259, &[1]);
    directory.shorts(262, &[1]);
    directory.long(273, 0);
    directory.shorts(277, &[1]);
    directory.long(278, height);
    directory.long(279, bytes as u32);
    directory
}

/// Refuses a first directory that promises more values than the file holds: the decoder makes room for them before its
/// limits can be set.
fn check_directory(bytes: &[u8]) -> Result<()> {
    let refuse = |at: usize, expected: &str| Error::malformed(FORMAT, at, expected, "another");
    let big = match bytes.get(..4) {
        Some(b"II*\0") => false,
        Some(b"MM\0*") => true,
        _ => return Err(refuse(0, "the signature of a TIFF file below 4 GiB")),
    };
    let word = |at: usize| -> Result<usize> {
        let b: [u8; 4] =
            bytes.get(at..).and_then(|b| b.first_chunk()).copied().ok_or_else(|| refuse(at, "four bytes"))?;
        Ok(if big { u32::from_be_bytes(b) } else { u32::from_le_bytes(b) } as usize)
    };
    let short = |at: usize| -> Result<usize> {
        let b: [u8; 2] =
            bytes.get(at..).and_then(|b| b.first_chunk()).copied().ok_or_else(|| refuse(at, "two bytes"))?;
        Ok(if big { u16::from_be_bytes(b) } else { u16::from_le_bytes(b) }.into())
    };
    let start = word(4)?;
    for i in 0..short(start)? {
        let at = start + 2 + 12 * i;
        let size = match short(at + 2)? {
            3 | 8 => 2,
            4 | 9 | 11 | 13 => 4,
            5 | 10 | 12 | 16..=18 => 8,
            _ => 1,
        };
        let length = word(at + 4)?.saturating_mul(size);
        if length > 4 && word(at + 8)?.saturating_add(length) > bytes.len() {
            return Err(refuse(at, "values inside the file"));
        }
    }
    Ok(())
}

fn open(bytes: &[u8]) -> Result<Decoder<Cursor<&[u8]>>> {
    check_directory(bytes)?;
    let mut limits = Limits::default();
    limits.decoding_buffer_size = 24 << 20;
    limits.intermediate_buffer_size = limits.decoding_buffer_size;
    limits.ifd_value_size = 1 << 20;
    Ok(Decoder::new(Cursor::new(bytes)).map_err(damaged)?.with_limits(limits))
}

fn damaged(e: tiff::TiffError) -> Error {
    Error::malformed(FORMAT, 0, "a TIFF image", e.to_string())
}

/// Where a GeoTIFF lies, if it says so by a tie point and a scale.
///
/// # Errors
/// [`Error::Malformed`] for what is no TIFF file.
pub fn grid(bytes: &[u8]) -> Result<Option<Grid>> {
    Ok(grid_of(&mut open(bytes)?))
}

fn grid_of(decoder: &mut Decoder<Cursor<&[u8]>>) -> Option<Grid> {
    let scale = decoder.get_tag_f64_vec(Tag::ModelPixelScaleTag).ok()?;
    let tie = decoder.get_tag_f64_vec(Tag::ModelTiepointTag).ok()?;
    let keys = decoder.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).unwrap_or_default();
    let kind = keys.chunks_exact(4).skip(1).find(|k| k[0] == 1025 && k[1] == 0).map(|k| k[3]);
    let (&[step_x, step_y, ..], &[i, j, _, x, y, ..]) = (&scale[..], &tie[..]) else { return None };
    Some(Grid { west: x - i * step_x, north: y + j * step_y, step_x, step_y, posts: kind == Some(2) })
}

/// Reads the first image.
///
/// # Errors
/// [`Error::Malformed`] for what the `tiff` crate cannot unpack; [`Error::Unsupported`] for sides above 2048 and other
/// samples than [`Samples`]'.
pub fn read(bytes: &[u8]) -> Result<Raster> {
    let mut decoder = open(bytes)?;
    let (width, height) = decoder.dimensions().map_err(damaged)?;
    if width == 0 || height == 0 || width > MAX_SIDE || height > MAX_SIDE {
        return Err(Error::unsupported(FORMAT, format!("sides of 1 to {MAX_SIDE} are read, found {width} × {height}")));
    }
    let grid = grid_of(&mut decoder);
    let samples = match decoder.read_image().map_err(damaged)? {
        DecodingResult::F32(v) => Samples::Floats(v),
        DecodingResult::I8(v) => Samples::Integers(v.into_iter().map(i32::from).collect()),
        DecodingResult::I16(v) => Samples::Integers(v.into_iter().map(i32::from).collect()),
        DecodingResult::I32(v) => Samples::Integers(v),
        DecodingResult::U8(v) => Samples::Bytes(v),
        _ => return Err(Error::unsupported(FORMAT, "samples that are no floats, bytes or signed integers")),
    };
    let count = match &samples {
        Samples::Floats(v) => v.len(),
        Samples::Integers(v) => v.len(),
        Samples::Bytes(v) => v.len(),
    };
    let pixels = width as usize * height as usize;
    if count == 0 || !count.is_multiple_of(pixels) {
        return Err(Error::malformed(FORMAT, 0, format!("{pixels} pixels"), format!("{count} samples")));
    }
    Ok(Raster { width, height, bands: count / pixels, samples, grid })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_read_back() {
        let grid = Grid { west: -119.0, north: 34.875, step_x: 0.5, step_y: 0.25, posts: true };
        let heights = [1.5f32, -2.0, 3.25, 0.0, 8000.5, -400.0];
        let bytes = write(3, 2, &heights, &grid, "CLASSIFICATION: X").unwrap();
        let read = read(&bytes).unwrap();
        let samples = Samples::Floats(heights.to_vec());
        assert_eq!(read, Raster { width: 3, height: 2, bands: 1, samples, grid: Some(grid) });
        assert!(String::from_utf8_lossy(&bytes).contains("CLASSIFICATION: X"));
        assert_eq!(
            super::grid(&degenerate(&Grid { posts: false, ..grid })).unwrap(),
            Some(Grid { posts: false, ..grid })
        );
        assert!(write(3, 3, &heights, &grid, "").is_err());
        assert!(write(1, 1, &[f32::NAN], &grid, "").is_err());
        for end in 0..bytes.len() {
            assert!(super::read(&bytes[..end]).is_err(), "cut at {end}");
        }
    }
}
