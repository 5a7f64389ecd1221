//! SPZ: quantised Gaussian splats, versions 2, 3 and 4.
//!
//! Source: the format's description and reference implementation (Niantic Labs, `nianticlabs/spz`). Versions 2 and 3 are
//! one gzip stream: a header of 16 bytes, then positions, opacities, colours, scales, rotations and harmonics, attribute
//! by attribute. Version 4 (`NGSP`) has a bare header of 32 bytes, extension records, a table of contents and one
//! Zstandard stream an attribute.
//!
//! The file is RUB: x right, y up, z back, as OpenGL has it. Splats in other axes say so ([`Axes`]) and are flipped,
//! harmonics with them. Turning them (from Z up, say) is the caller's to do.
//!
//! What is kept, the largest error of a value in range:
//!
//! | attribute | stored as | error |
//! | --- | --- | --- |
//! | position | 24-bit fixed point, 12 fractional bits (fewer beyond 2048 m) | 1/8192 m |
//! | scale | 8 bits of the logarithm, −10 … 5.9375 | 1/32, that is 3.2 % |
//! | rotation, version 2 | x, y, z in 8 bits each, w follows | 1/255 in x, y, z; w worse as it nears 0 |
//! | rotation, versions 3 and 4 | the smallest three in 10 bits each | 0.0007 each, 0.0022 in the largest |
//! | opacity (0 … 1) | 8 bits | 1/510 |
//! | colour, degree 0 | 8 bits of coefficients −3.33 … 3.33 | 1/76.5 |
//! | degree 1 | 5 bits of −1 … 1 | 1/32 and rounding, 0.036 |
//! | degrees 2 and 3 | 4 bits of −1 … 1 | 1/16 and rounding, 0.067 |
//!
//! Values out of range go to its end.

mod axes;
mod container;
mod huffman;
mod pack;
#[cfg(test)]
mod tests;

pub use axes::Axes;

use crate::splats::BASES;
use crate::{Error, Result, Splats};

const FORMAT: &str = "SPZ";

/// How the streams are laid out and compressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Version {
    /// gzip; rotations in three bytes. The oldest that is still read everywhere.
    V2 = 2,
    /// gzip; rotations in four bytes.
    V3 = 3,
    /// Zstandard, a stream an attribute.
    V4 = 4,
}

impl Version {
    fn of(number: u32) -> Option<Self> {
        [Version::V2, Version::V3, Version::V4].into_iter().find(|v| *v as u32 == number)
    }
}

/// How to write.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    pub version: Version,
    /// Harmonics up to this degree, 0 to 3; `None` for the lowest that keeps all that are not 0.
    pub degree: Option<usize>,
    /// The splats' own axes.
    pub axes: Axes,
    /// A line of printable ASCII for the marking: the comment of the gzip header, or an extension record (version 4).
    /// Readers that know neither skip it.
    pub comment: String,
}

impl Default for Options {
    fn default() -> Self {
        Options { version: Version::V3, degree: None, axes: Axes::RUB, comment: String::new() }
    }
}

/// What a file says beside the splats.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Info {
    pub version: Version,
    pub degree: usize,
    /// Trained with the anti-aliasing of Mip-Splatting.
    pub antialiased: bool,
    pub comment: String,
}

/// The header's numbers, of any version.
#[derive(Clone, Copy, Debug)]
struct Header {
    version: Version,
    count: usize,
    degree: usize,
    fractional_bits: u32,
    antialiased: bool,
}

impl Header {
    /// Bytes of each attribute of a splat, in file order.
    fn widths(&self) -> [usize; 6] {
        let rotation = if self.version == Version::V2 { 3 } else { 4 };
        [9, 1, 3, 3, rotation, 3 * (BASES[self.degree] - 1)]
    }

    /// Bytes of each attribute, in file order.
    fn sizes(&self) -> [usize; 6] {
        self.widths().map(|each| each * self.count)
    }
}

/// Writes splats.
///
/// # Errors
/// [`Error::Unsupported`] for arrays of different lengths, values that are not finite, positions beyond 4,194 km, more
/// than 4 billion splats, a comment that is not printable ASCII.
pub fn write(splats: &Splats, options: &Options) -> Result<Vec<u8>> {
    splats.validate(FORMAT)?;
    if !options.comment.bytes().all(|b| (0x20..0x7f).contains(&b)) {
        return Err(Error::unsupported(
            FORMAT,
            format!("a comment must be printable ASCII, found {:?}", options.comment),
        ));
    }
    let count = splats.positions.len();
    if u32::try_from(count).is_err() {
        return Err(Error::unsupported(FORMAT, format!("{count} splats, a file counts to 4294967295")));
    }
    let header = Header {
        version: options.version,
        count,
        degree: options.degree.unwrap_or_else(|| splats.degree()).min(3),
        fractional_bits: pack::fractional_bits(&splats.positions)?,
        antialiased: false,
    };
    container::join(&header, &pack::pack(splats, &header, options.axes), &options.comment)
}

/// Reads splats into the given axes.
///
/// # Errors
/// [`Error::Malformed`] where the file breaks the format; [`Error::Unsupported`] for other versions, degree 4, and a
/// file that would unfold to more than 200 times its size: its streams (1 MiB is always allowed) or the splats in memory (16 MiB).
pub fn read(bytes: &[u8], axes: Axes) -> Result<(Splats, Info)> {
    let (header, streams, comment) = container::split(bytes)?;
    let info = Info { version: header.version, degree: header.degree, antialiased: header.antialiased, comment };
    Ok((pack::unpack(&header, &streams, axes), info))
}

/// The comment alone, without unfolding anything; empty without one.
pub fn comment(bytes: &[u8]) -> String {
    container::comment(bytes)
}

/// The same splats in other axes: flipped, not turned.
pub fn flipped(splats: &Splats, from: Axes, to: Axes) -> Splats {
    let flip = axes::Flip::between(from, to);
    let mut out = splats.clone();
    for p in &mut out.positions {
        *p = std::array::from_fn(|i| p[i] * flip.position[i]);
    }
    for [_, vector @ ..] in &mut out.rotations {
        *vector = std::array::from_fn(|i| vector[i] * flip.rotation[i]);
    }
    for sh in &mut out.sh {
        sh.iter_mut().zip(flip.sh).for_each(|(rgb, sign)| *rgb = rgb.map(|c| c * sign));
    }
    out
}
