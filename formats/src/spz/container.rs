//! Headers, compression, the comment.

use std::io::Read;
use std::sync::atomic::{AtomicUsize, Ordering};

use flate2::bufread::GzDecoder;
use flate2::{Compress, Compression, Crc, FlushCompress, Status};

use super::{FORMAT, Header, Version, huffman};
use crate::{Error, Result};

const MAGIC: &[u8; 4] = b"NGSP";
const GZIP: [u8; 2] = [0x1f, 0x8b];
/// Bytes of the header before version 4, and of version 4.
const SHORT: usize = 16;
const LONG: usize = 32;
const ANTIALIASED: u8 = 1;
const EXTENSIONS: u8 = 2;
/// The extension record of the comment: vendor `OR`, number 1.
const COMMENT: u32 = 0x4f52_0001;
/// Of Zstandard: 12 takes nearly three times as long for one part in a hundred.
const LEVEL: i32 = 8;
/// The flag of a gzip header that a comment follows.
const GZIP_COMMENT: u8 = 1 << 4;
/// What one core deflates at a time, bytes: a fixed size, so that the file does not depend on their number.
const PIECE: usize = 1 << 20;
/// What is tried of a piece, bytes.
const SAMPLE: usize = 1 << 15;
/// Extensions behind the streams of a gzip file, bytes.
const MAX_EXTENSIONS: u64 = 1 << 20;
/// What may always be unfolded, and how many times its own size a file may unfold to beyond that.
const ALWAYS: usize = 1 << 20;
const RATIO: usize = 200;
/// The same of what the splats take in memory, which is twelve times as much and more. Real scans have five bytes a splat and
/// more, as the low bits of positions are noise: they unfold to 50 times their size at most.
const ALWAYS_HELD: usize = 16 << 20;
/// Bytes of a splat in memory: position, scales, rotation, opacity, harmonics.
const HELD: usize = 4 * (3 + 3 + 4 + 1 + 48);

/// A file of streams.
pub fn join(header: &Header, streams: &[Vec<u8>; 6], comment: &str) -> Result<Vec<u8>> {
    match header.version {
        Version::V4 => join_streams(header, streams, comment),
        _ => join_gzip(header, streams, comment),
    }
}

/// The first 14 bytes, the flags and one more.
fn head(header: &Header, flags: u8, last: u8) -> Vec<u8> {
    let mut out = MAGIC.to_vec();
    out.extend((header.version as u32).to_le_bytes());
    out.extend((header.count as u32).to_le_bytes());
    out.extend([header.degree as u8, header.fractional_bits as u8, flags, last]);
    out
}

/// One gzip stream, its deflate blocks compressed side by side.
fn join_gzip(header: &Header, streams: &[Vec<u8>; 6], comment: &str) -> Result<Vec<u8>> {
    let flags = if header.antialiased { ANTIALIASED } else { 0 };
    let mut whole = head(header, flags, 0);
    streams.iter().for_each(|s| whole.extend_from_slice(s));
    let pieces: Vec<&[u8]> = whole.chunks(PIECE).collect();
    // RFC 1952: no time stamp and no name of a system, so that the same splats give the same bytes.
    let mut out = vec![GZIP[0], GZIP[1], 8, if comment.is_empty() { 0 } else { GZIP_COMMENT }, 0, 0, 0, 0, 0, 255];
    if !comment.is_empty() {
        out.extend(comment.bytes().chain([0]));
    }
    let last = pieces.len() - 1;
    let deflated = side_by_side(&pieces, |i, piece| {
        if is_noise(piece) {
            return Ok(huffman::block(piece, i == last));
        }
        // A flush ends a piece at a whole byte, so that the next can follow (RFC 1951, §3.2.4).
        let flush = if i == last { FlushCompress::Finish } else { FlushCompress::Sync };
        let mut state = Compress::new(Compression::default(), false);
        let mut bytes = Vec::with_capacity(piece.len() + piece.len() / 1000 + 64);
        loop {
            let done = state.total_in() as usize;
            let status = state.compress_vec(&piece[done..], &mut bytes, flush).map_err(|e| e.to_string())?;
            let taken = state.total_in() as usize == piece.len();
            if status == Status::StreamEnd || (i != last && taken && bytes.len() < bytes.capacity()) {
                return Ok(bytes);
            }
            bytes.reserve(bytes.len().max(64));
        }
    })?;
    deflated.iter().for_each(|d| out.extend_from_slice(d));
    let mut sum = Crc::new();
    sum.update(&whole);
    out.extend(sum.sum().to_le_bytes());
    out.extend(sum.amount().to_le_bytes());
    Ok(out)
}

/// Whether matches would not make a piece smaller, told by a part in its middle.
fn is_noise(piece: &[u8]) -> bool {
    let middle = &piece[(piece.len().saturating_sub(SAMPLE)) / 2..];
    let sample = &middle[..middle.len().min(SAMPLE)];
    let mut state = Compress::new(Compression::default(), false);
    let mut packed = Vec::with_capacity(huffman::size(sample));
    // What does not fit there is no smaller.
    !matches!(state.compress_vec(sample, &mut packed, FlushCompress::Finish), Ok(Status::StreamEnd))
}

/// Works on all pieces with the machine's cores; the results in order.
fn side_by_side<T: Sync, F>(pieces: &[T], work: F) -> Result<Vec<Vec<u8>>>
where
    F: Fn(usize, &T) -> std::result::Result<Vec<u8>, String> + Sync,
{
    let next = AtomicUsize::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from).min(pieces.len()).max(1);
    let done = std::thread::scope(|scope| {
        let worker = || {
            let mut own = Vec::new();
            loop {
                let i = next.fetch_add(1, Ordering::Relaxed);
                let Some(piece) = pieces.get(i) else { return own };
                own.push((i, work(i, piece)));
            }
        };
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(worker)).collect();
        let mut all = worker();
        for other in others {
            match other.join() {
                Ok(own) => all.extend(own),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        all
    });
    let mut sorted = done;
    sorted.sort_by_key(|(i, _)| *i);
    sorted.into_iter().map(|(_, d)| d.map_err(|e| Error::unsupported(FORMAT, e))).collect()
}

fn join_streams(header: &Header, streams: &[Vec<u8>; 6], comment: &str) -> Result<Vec<u8>> {
    let kept: Vec<&Vec<u8>> = streams.iter().filter(|s| !s.is_empty()).collect();
    let mut flags = if header.antialiased { ANTIALIASED } else { 0 };
    let mut extension = Vec::new();
    if !comment.is_empty() {
        flags |= EXTENSIONS;
        extension.extend(COMMENT.to_le_bytes());
        extension.extend((comment.len() as u32).to_le_bytes());
        extension.extend(comment.as_bytes());
    }
    let mut out = head(header, flags, kept.len() as u8);
    out.extend(((LONG + extension.len()) as u32).to_le_bytes());
    out.resize(LONG, 0);
    out.extend(extension);
    let packed = side_by_side(&kept, |_, s| zstandard(s).map_err(|e| format!("Zstandard: {e}")))?;
    for (stream, packed) in kept.iter().zip(&packed) {
        out.extend((packed.len() as u64).to_le_bytes());
        out.extend((stream.len() as u64).to_le_bytes());
    }
    packed.iter().for_each(|p| out.extend_from_slice(p));
    Ok(out)
}

/// One frame, a long stream in pieces that threads compress side by side. What they find does not depend on their number.
fn zstandard(stream: &[u8]) -> std::io::Result<Vec<u8>> {
    let mut compressor = zstd::bulk::Compressor::new(LEVEL)?;
    if stream.len() > PIECE {
        let workers = std::thread::available_parallelism().map_or(1, usize::from).min(64);
        compressor.set_parameter(zstd::zstd_safe::CParameter::NbWorkers(workers as u32))?;
        compressor.set_parameter(zstd::zstd_safe::CParameter::JobSize(PIECE as u32))?;
    }
    compressor.compress(stream)
}

/// Header, streams and comment of a file; the streams have the lengths that the header asks for.
pub fn split(bytes: &[u8]) -> Result<(Header, [Vec<u8>; 6], String)> {
    if bytes.starts_with(&GZIP) {
        split_gzip(bytes)
    } else if bytes.starts_with(MAGIC) {
        split_streams(bytes)
    } else {
        let found = format!("{:02x?}", &bytes[..bytes.len().min(4)]);
        Err(Error::malformed(FORMAT, 0, "a gzip stream or NGSP", found))
    }
}

pub fn comment(bytes: &[u8]) -> String {
    if bytes.starts_with(&GZIP) {
        GzDecoder::new(bytes).header().map(gzip_comment).unwrap_or_default()
    } else if bytes.starts_with(MAGIC) {
        extension_comment(bytes).unwrap_or_default()
    } else {
        String::new()
    }
}

fn gzip_comment(header: &flate2::GzHeader) -> String {
    String::from_utf8_lossy(header.comment().unwrap_or_default()).into_owned()
}

fn split_gzip(bytes: &[u8]) -> Result<(Header, [Vec<u8>; 6], String)> {
    let mut gzip = GzDecoder::new(bytes);
    let comment = gzip.header().map(gzip_comment).unwrap_or_default();
    let mut first = [0; SHORT];
    let broken = |e: std::io::Error| Error::malformed(FORMAT, 0, "a whole gzip stream", e.to_string());
    gzip.read_exact(&mut first).map_err(broken)?;
    let (header, _) = read_head(&first)?;
    if header.version == Version::V4 {
        return Err(Error::malformed(FORMAT, 4, "version 2 or 3 inside gzip", "4"));
    }
    check_ratio(&header, bytes.len())?;
    let mut streams: [Vec<u8>; 6] = Default::default();
    for (stream, size) in streams.iter_mut().zip(header.sizes()) {
        // Grows with what is really there.
        gzip.by_ref().take(size as u64).read_to_end(stream).map_err(broken)?;
        if stream.len() != size {
            let found = format!("{} bytes", stream.len());
            return Err(Error::malformed(FORMAT, bytes.len(), format!("a stream of {size} bytes"), found));
        }
    }
    // What follows are extensions, then the check sum, which must be read to be checked.
    let rest = std::io::copy(&mut gzip.by_ref().take(MAX_EXTENSIONS), &mut std::io::sink()).map_err(broken)?;
    if rest == MAX_EXTENSIONS {
        return Err(Error::unsupported(FORMAT, format!("more than {MAX_EXTENSIONS} bytes of extensions")));
    }
    Ok((header, streams, comment))
}

fn split_streams(bytes: &[u8]) -> Result<(Header, [Vec<u8>; 6], String)> {
    let (header, streams) = read_head(bytes)?;
    if header.version != Version::V4 {
        return Err(Error::malformed(FORMAT, 4, "version 4 outside gzip", (header.version as u32).to_string()));
    }
    check_ratio(&header, bytes.len())?;
    let sizes = header.sizes();
    let expected = sizes.iter().filter(|s| **s > 0).count();
    if usize::from(streams) != expected {
        return Err(Error::malformed(FORMAT, 15, format!("{expected} streams"), streams.to_string()));
    }
    let short = |at: usize| Error::malformed(FORMAT, at, "a table of contents inside the file", "its end");
    let contents = u32_at(bytes, SHORT).ok_or_else(|| short(SHORT))? as usize;
    let mut at = contents.checked_add(16 * expected).filter(|end| contents >= LONG && *end <= bytes.len());
    let mut out: [Vec<u8>; 6] = Default::default();
    for (index, (stream, size)) in out.iter_mut().zip(sizes).filter(|(_, size)| *size > 0).enumerate() {
        let start = at.ok_or_else(|| short(contents))?;
        let entry = contents + 16 * index;
        let (packed, full) = (u64_at(bytes, entry), u64_at(bytes, entry + 8));
        if full != Some(size as u64) {
            let found = format!("{}", full.unwrap_or_default());
            return Err(Error::malformed(FORMAT, entry + 8, format!("a stream of {size} bytes"), found));
        }
        let end = packed.and_then(|p| usize::try_from(p).ok()).and_then(|p| start.checked_add(p));
        let Some(packed) = end.and_then(|end| bytes.get(start..end)) else {
            return Err(Error::malformed(
                FORMAT,
                entry,
                format!("a stream inside {} bytes", bytes.len()),
                "a longer one",
            ));
        };
        let broken = |e: std::io::Error| Error::malformed(FORMAT, start, "a Zstandard stream", e.to_string());
        let decoder = zstd::stream::read::Decoder::with_buffer(packed).map_err(broken)?;
        decoder.take(size as u64 + 1).read_to_end(stream).map_err(broken)?;
        if stream.len() != size {
            let found = format!("{} or more", stream.len());
            return Err(Error::malformed(FORMAT, start, format!("{size} bytes unfolded"), found));
        }
        at = end;
    }
    Ok((header, out, extension_comment(bytes).unwrap_or_default()))
}

/// The header and its last byte, the number of streams of version 4.
fn read_head(bytes: &[u8]) -> Result<(Header, u8)> {
    let Some(&[degree, fractional_bits, flags, last]) = bytes.get(12..16) else {
        return Err(Error::malformed(FORMAT, bytes.len(), "a header of 16 bytes", "the end"));
    };
    if !bytes.starts_with(MAGIC) {
        return Err(Error::malformed(FORMAT, 0, "NGSP", format!("{:02x?}", &bytes[..4])));
    }
    let (version, count) = (u32_at(bytes, 4).unwrap_or(0), u32_at(bytes, 8).unwrap_or(0));
    let Some(version) = Version::of(version) else {
        return Err(Error::unsupported(FORMAT, format!("version {version}; 2, 3 and 4 are read")));
    };
    if degree > 3 {
        return Err(Error::unsupported(FORMAT, format!("harmonics of degree {degree}; 0 to 3 are read")));
    }
    if fractional_bits > 24 {
        return Err(Error::malformed(FORMAT, 13, "at most 24 fractional bits", fractional_bits.to_string()));
    }
    let header = Header {
        version,
        count: count as usize,
        degree: degree.into(),
        fractional_bits: fractional_bits.into(),
        antialiased: flags & ANTIALIASED != 0,
    };
    Ok((header, last))
}

fn check_ratio(header: &Header, size: usize) -> Result<()> {
    let streams = header.sizes().iter().sum::<usize>();
    let held = header.count.saturating_mul(HELD);
    let over = |unfolded: usize, always: usize| unfolded > always && unfolded / RATIO > size;
    if over(streams, ALWAYS) || over(held, ALWAYS_HELD) {
        let unfolded = streams.max(held);
        let what = format!("{} splats would unfold to {unfolded} bytes, from a file of {size}", header.count);
        return Err(Error::unsupported(FORMAT, what));
    }
    Ok(())
}

/// Extension records stand between header and table of contents: type, length, content.
fn extension_comment(bytes: &[u8]) -> Option<String> {
    let contents = u32_at(bytes, SHORT)? as usize;
    let mut records = bytes.get(LONG..contents)?;
    if bytes[14] & EXTENSIONS == 0 {
        return None;
    }
    loop {
        let (kind, length) = (u32_at(records, 0)?, u32_at(records, 4)? as usize);
        let content = records.get(8..)?.get(..length)?;
        if kind == COMMENT {
            return Some(String::from_utf8_lossy(content).into_owned());
        }
        records = &records[8 + length..];
    }
}

fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    let b = bytes.get(at..at + 4)?;
    Some(u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
}

fn u64_at(bytes: &[u8], at: usize) -> Option<u64> {
    let (low, high) = (u32_at(bytes, at)?, u32_at(bytes, at + 4)?);
    Some(u64::from(high) << 32 | u64::from(low))
}
