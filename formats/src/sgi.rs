//! SGI image files (`.rgb`), version 1.00: the texture format of OpenFlight and CDB.
//!
//! Source: "The SGI Image File Format", Paul Haeberli, version 1.00. Everything is big-endian; channels are planar and
//! rows go from bottom to top. [`Image`] holds the usual order instead (interleaved, top row first).

use crate::{Error, Result};

const FORMAT: &str = "SGI image";
const MAGIC: u16 = 474;
/// The fixed header; the row tables or the pixels follow it.
const HEADER: usize = 512;
/// The image name field: 80 bytes at 24, NUL-terminated.
const NAME: std::ops::Range<usize> = 24..104;
/// The longest run or literal of one control byte.
const MAX_RUN: usize = 127;

/// Eight-bit pixels, channels interleaved, top row first.
///
/// Channels: 1 luminance, 2 luminance and alpha, 3 RGB, 4 RGBA. `pixels` holds width × height × channels bytes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Image {
    pub width: u32,
    pub height: u32,
    pub channels: u8,
    pub pixels: Vec<u8>,
}

/// Writes an image, verbatim or run-length coded. `name` goes into the header's image name (ASCII, at most 79 bytes).
///
/// # Errors
/// [`Error::Unsupported`] for an empty image, sides over 65535, other than 1–4 channels, a wrong number of pixel bytes,
/// a name that does not fit, or coded data past the 4 GiB that the row table can address.
pub fn write(image: &Image, name: &str, rle: bool) -> Result<Vec<u8>> {
    let shape = Shape::of(image)?;
    if name.len() >= NAME.len() || !name.bytes().all(|b| (0x20..0x7f).contains(&b)) {
        return refuse(format!(
            "the image name must be printable ASCII of at most {} bytes, found {name:?}; shorten it",
            NAME.len() - 1
        ));
    }
    let mut out = Vec::with_capacity(HEADER + shape.pixels() + if rle { shape.rows() * 8 } else { 0 });
    out.extend(MAGIC.to_be_bytes());
    out.push(u8::from(rle));
    out.push(1); // bytes a channel
    out.extend(if shape.channels == 1 { 2u16 } else { 3 }.to_be_bytes());
    out.extend((shape.width as u16).to_be_bytes());
    out.extend((shape.height as u16).to_be_bytes());
    out.extend((shape.channels as u16).to_be_bytes());
    out.extend(0u32.to_be_bytes()); // smallest value
    out.extend(255u32.to_be_bytes()); // largest value
    out.resize(NAME.start, 0);
    out.extend(name.as_bytes());
    out.resize(HEADER, 0); // colormap 0: normal
    let mut row = vec![0; shape.width];
    if !rle {
        for index in 0..shape.rows() {
            shape.gather(image, index, &mut row);
            out.extend_from_slice(&row);
        }
        return Ok(out);
    }
    let lengths = HEADER + shape.rows() * 4;
    out.resize(HEADER + shape.rows() * 8, 0);
    for index in 0..shape.rows() {
        shape.gather(image, index, &mut row);
        let start = out.len();
        encode_row(&row, &mut out);
        let Ok(offset) = u32::try_from(start) else {
            return refuse("the run-length coded data exceeds 4 GiB; write it verbatim".into());
        };
        out[HEADER + index * 4..][..4].copy_from_slice(&offset.to_be_bytes());
        let length = (out.len() - start) as u32; // at most 65535 · 128 / 127 + 2
        out[lengths + index * 4..][..4].copy_from_slice(&length.to_be_bytes());
    }
    Ok(out)
}

/// Reads an SGI image of one byte a channel, verbatim or run-length coded, and its image name.
///
/// # Errors
/// [`Error::Malformed`] with the byte offset where the file breaks the format; [`Error::Unsupported`] for 16-bit
/// channels and colour-mapped images. Memory is bounded by 64 times the size of the file, plus 64 MiB for files whose
/// rows share their coding.
pub fn read(bytes: &[u8]) -> Result<(Image, String)> {
    if bytes.len() < HEADER {
        return malformed(bytes.len(), format!("a header of {HEADER} bytes"), "the end of the file".into());
    }
    let u16_at = |at: usize| u16::from_be_bytes([bytes[at], bytes[at + 1]]);
    if u16_at(0) != MAGIC {
        return malformed(0, format!("the magic number {MAGIC}"), u16_at(0).to_string());
    }
    let rle = match bytes[2] {
        0 => false,
        1 => true,
        other => return malformed(2, "storage 0 (verbatim) or 1 (run-length coded)".into(), other.to_string()),
    };
    if bytes[3] == 2 {
        return refuse("16 bits a channel; convert the image to 8 bits a channel".into());
    } else if bytes[3] != 1 {
        return malformed(3, "1 or 2 bytes a channel".into(), bytes[3].to_string());
    }
    let (height, channels) = match u16_at(4) {
        1 => (1, 1),
        2 => (u16_at(8), 1),
        3 => (u16_at(8), u16_at(10)),
        other => return malformed(4, "1, 2 or 3 dimensions".into(), other.to_string()),
    };
    let shape = Shape { width: u16_at(6).into(), height: height.into(), channels: channels.into() };
    if shape.width == 0 || shape.height == 0 {
        return malformed(6, "a width and height of at least 1".into(), format!("{}x{}", shape.width, shape.height));
    }
    if !(1..=4).contains(&shape.channels) {
        return malformed(10, "1 to 4 channels".into(), shape.channels.to_string());
    }
    if bytes[104..108] != [0; 4] {
        return refuse("a colour-mapped image; convert it to RGB".into());
    }
    let name = &bytes[NAME];
    let name = &name[..name.iter().position(|&b| b == 0).unwrap_or(name.len())];
    // Latin-1: every byte is a character, so no name is refused and ASCII comes back as it was written.
    let name = name.iter().map(|&b| char::from(b)).collect();
    let pixels = if rle { read_coded(bytes, &shape)? } else { read_verbatim(bytes, &shape)? };
    let image =
        Image { width: shape.width as u32, height: shape.height as u32, channels: shape.channels as u8, pixels };
    Ok((image, name))
}

/// Sizes of an image whose sides fit u16 and whose channels are 1–4.
struct Shape {
    width: usize,
    height: usize,
    channels: usize,
}

impl Shape {
    fn of(image: &Image) -> Result<Self> {
        let side = 1..=u32::from(u16::MAX);
        if !side.contains(&image.width) || !side.contains(&image.height) {
            return refuse(format!("sides must be 1 to 65535, found {}x{}", image.width, image.height));
        }
        if !(1..=4).contains(&image.channels) {
            return refuse(format!("1 to 4 channels are needed, found {}", image.channels));
        }
        let shape =
            Shape { width: image.width as usize, height: image.height as usize, channels: image.channels.into() };
        if image.pixels.len() != shape.pixels() {
            return refuse(format!(
                "{}x{} with {} channels needs {} pixel bytes, found {}",
                image.width,
                image.height,
                image.channels,
                shape.pixels(),
                image.pixels.len()
            ));
        }
        Ok(shape)
    }

    /// Pixel bytes; saturates where memory cannot hold them anyway.
    fn pixels(&self) -> usize {
        (self.width * self.channels).saturating_mul(self.height)
    }

    /// Rows of all channels, in file order: channel by channel, bottom to top.
    fn rows(&self) -> usize {
        self.height * self.channels
    }

    /// Where file row `index` begins in the interleaved pixels.
    fn start(&self, index: usize) -> usize {
        let (channel, up) = (index / self.height, index % self.height);
        (self.height - 1 - up) * self.width * self.channels + channel
    }

    fn gather(&self, image: &Image, index: usize, row: &mut [u8]) {
        let samples = image.pixels[self.start(index)..].iter().step_by(self.channels);
        row.iter_mut().zip(samples).for_each(|(to, &from)| *to = from);
    }

    fn scatter(&self, pixels: &mut [u8], index: usize, row: &[u8]) {
        let samples = pixels[self.start(index)..].iter_mut().step_by(self.channels);
        samples.zip(row).for_each(|(to, &from)| *to = from);
    }
}

fn read_verbatim(bytes: &[u8], shape: &Shape) -> Result<Vec<u8>> {
    let end = shape.pixels().saturating_add(HEADER);
    let Some(data) = bytes.get(HEADER..end) else {
        return malformed(bytes.len(), format!("pixels up to byte {end}"), "the end of the file".into());
    };
    let mut pixels = vec![0; shape.pixels()];
    for (index, row) in data.chunks_exact(shape.width).enumerate() {
        shape.scatter(&mut pixels, index, row);
    }
    Ok(pixels)
}

fn read_coded(bytes: &[u8], shape: &Shape) -> Result<Vec<u8>> {
    let tables = HEADER + shape.rows() * 8;
    if bytes.len() < tables {
        return malformed(bytes.len(), format!("row tables up to byte {tables}"), "the end of the file".into());
    }
    // Two coded bytes make at most 127 pixels, but rows may share their bytes: bound what a small file can ask for.
    let limit = bytes.len().saturating_mul(64).saturating_add(64 << 20);
    if shape.pixels() > limit {
        return malformed(
            6,
            format!("at most {limit} pixel bytes from a file of {} bytes", bytes.len()),
            format!("{}x{} with {} channels", shape.width, shape.height, shape.channels),
        );
    }
    let entry = |at: usize| u32::from_be_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]) as usize;
    let mut pixels = vec![0; shape.pixels()];
    let mut row = Vec::with_capacity(shape.width);
    for index in 0..shape.rows() {
        let at = HEADER + index * 4;
        let (start, length) = (entry(at), entry(at + shape.rows() * 4));
        let coded = start.checked_add(length).and_then(|end| bytes.get(start..end)).filter(|_| start >= tables);
        let Some(coded) = coded else {
            let found = format!("offset {start}, length {length}");
            return malformed(at, format!("row {index} inside bytes {tables} to {}", bytes.len()), found);
        };
        row.clear();
        decode_row(coded, start, shape.width, &mut row)?;
        shape.scatter(&mut pixels, index, &row);
    }
    Ok(pixels)
}

/// Codes a row: a control byte's low seven bits count, its top bit tells literals from a run; a zero ends the row.
fn encode_row(row: &[u8], out: &mut Vec<u8>) {
    let mut at = 0;
    while at < row.len() {
        let value = row[at];
        let run = row[at..].iter().take(MAX_RUN).take_while(|&&b| b == value).count();
        if run >= 3 {
            out.extend([run as u8, value]);
            at += run;
            continue;
        }
        // Literals last until three equal bytes begin: a shorter run costs more than it saves.
        let rest = &row[at..row.len().min(at + MAX_RUN)];
        let literals = rest.windows(3).position(|w| w[0] == w[1] && w[1] == w[2]).unwrap_or(rest.len());
        out.push(0x80 | literals as u8);
        out.extend_from_slice(&rest[..literals]);
        at += literals;
    }
    out.push(0);
}

/// Decodes exactly `width` samples; `start` is the file offset of `coded`, for messages. The final zero may be missing.
fn decode_row(coded: &[u8], start: usize, width: usize, row: &mut Vec<u8>) -> Result<()> {
    let mut at = 0;
    while row.len() < width {
        let control = coded.get(at).copied().unwrap_or(0);
        let count = usize::from(control & 0x7f);
        if count == 0 {
            return malformed(
                start + at,
                format!("{width} samples"),
                format!("the end of the row after {}", row.len()),
            );
        }
        if row.len() + count > width {
            return malformed(start + at, format!("{width} samples"), format!("{} or more", row.len() + count));
        }
        let cut = || malformed(start + coded.len(), format!("{count} more samples"), "the end of the row".into());
        if control & 0x80 != 0 {
            match coded.get(at + 1..at + 1 + count) {
                Some(literals) => row.extend_from_slice(literals),
                None => return cut(),
            }
            at += 1 + count;
        } else {
            match coded.get(at + 1) {
                Some(&value) => row.resize(row.len() + count, value),
                None => return cut(),
            }
            at += 2;
        }
    }
    Ok(())
}

fn malformed<T>(offset: usize, expected: String, found: String) -> Result<T> {
    Err(Error::Malformed { format: FORMAT, offset: offset as u64, expected, found })
}

fn refuse<T>(what: String) -> Result<T> {
    Err(Error::Unsupported { format: FORMAT, what })
}

#[cfg(test)]
mod tests;
