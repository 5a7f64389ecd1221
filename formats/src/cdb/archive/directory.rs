//! The records of a zip archive, byte for byte.
//!
//! Source: PKWARE APPNOTE 6.3: local file header (4.3.7), central directory (4.3.12), its end (4.3.16).

use std::ops::Range;

/// Fixed part of a local header, of a central header, of the end record; bytes.
pub const LOCAL: usize = 30;
pub const CENTRAL: usize = 46;
pub const END: usize = 22;

const LOCAL_MARK: [u8; 4] = *b"PK\x03\x04";
const CENTRAL_MARK: [u8; 4] = *b"PK\x01\x02";
const END_MARK: [u8; 4] = *b"PK\x05\x06";
/// Flags of the entries that are understood: encryption, which is said, the deflater's choice, UTF-8.
const ENCRYPTED: u16 = 1;
const KNOWN: u16 = ENCRYPTED | 0b110 | 1 << 11;
/// Version 1.0 to extract; made by 1.0 on Unix.
const VERSION: u16 = 10;
const MADE_BY: u16 = 3 << 8 | VERSION;
/// The earliest date of a zip: 1 January 1980.
const DATE: u16 = 1 << 5 | 1;
/// A file that all may read, as Unix keeps it.
const ATTRIBUTES: u32 = 0o100_644 << 16;

/// Where the parts of an entry are in the archive.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Local header and data.
    pub local: Range<usize>,
    pub data: Range<usize>,
    /// The record of the directory, and the name in it.
    pub central: Range<usize>,
    pub name: Range<usize>,
    pub crc32: u32,
    pub stored: bool,
    pub encrypted: bool,
}

/// The entries by name, and the archive's comment.
#[derive(Clone, Debug, Default)]
pub struct Directory {
    pub entries: Vec<Entry>,
    pub comment: Range<usize>,
}

impl Directory {
    /// Reads the directory of a plain archive: of one disk, without zip64 and data descriptors, whose entries have names of
    /// their own and do not lie on each other. `None` for every other file.
    pub fn read(bytes: &[u8]) -> Option<Directory> {
        let end = end_record(bytes)?;
        let count = short(bytes, end + 10)?;
        let (size, start) = (long(bytes, end + 12)?, long(bytes, end + 16)?);
        let one_disk = short(bytes, end + 4)? == 0 && short(bytes, end + 6)? == 0 && short(bytes, end + 8)? == count;
        if !one_disk || count == u16::MAX || start.checked_add(size)? != end {
            return None;
        }
        let mut entries = Vec::with_capacity(usize::from(count).min(size / CENTRAL));
        let mut at = start;
        for _ in 0..count {
            let entry = entry(bytes, at, start)?;
            at = entry.central.end;
            entries.push(entry);
        }
        if at != end {
            return None;
        }
        let name = |e: &Entry| &bytes[e.name.clone()];
        if !entries.is_sorted_by_key(name) {
            entries.sort_by(|a, b| name(a).cmp(name(b)));
        }
        let mut places: Vec<_> = entries.iter().map(|e| (e.local.start, e.local.end)).collect();
        if !places.is_sorted() {
            places.sort_unstable();
        }
        let apart = places.windows(2).all(|w| w[0].1 <= w[1].0);
        let unique = entries.windows(2).all(|w| name(&w[0]) != name(&w[1]));
        (apart && unique).then_some(Directory { entries, comment: end + END..bytes.len() })
    }
}

/// Where the end record begins: its comment goes to the end of the file.
fn end_record(bytes: &[u8]) -> Option<usize> {
    let last = bytes.len().checked_sub(END)?;
    let first = last.saturating_sub(usize::from(u16::MAX));
    let fits = |&at: &usize| {
        bytes[at..].starts_with(&END_MARK)
            && short(bytes, at + 20).is_some_and(|n| at + END + usize::from(n) == bytes.len())
    };
    (first..=last).rev().find(fits)
}

/// The entry whose central record is at `at`; local records end before the directory at `limit`.
fn entry(bytes: &[u8], at: usize, limit: usize) -> Option<Entry> {
    let header = bytes.get(at..at + CENTRAL)?;
    let (flags, method) = (short(header, 8)?, short(header, 10)?);
    let (packed, whole) = (long(header, 20)?, long(header, 24)?);
    let lengths = [28, 30, 32].map(|i| short(header, i).map_or(0, usize::from));
    let offset = long(header, 42)?;
    let zip64 = [packed, whole, offset].contains(&(u32::MAX as usize));
    if !header.starts_with(&CENTRAL_MARK) || flags & !KNOWN != 0 || zip64 || short(header, 34)? != 0 {
        return None;
    }
    let central = at..at + CENTRAL + lengths.iter().sum::<usize>();
    let name = at + CENTRAL..at + CENTRAL + lengths[0];
    bytes.get(central.clone())?;
    let local = bytes.get(offset..offset.checked_add(LOCAL)?)?;
    // What the local header says twice must be the same, or readers would disagree about the entry.
    let same = local[6..10] == header[8..12] && local[14..26] == header[16..28];
    let start = offset + LOCAL + lengths[0] + usize::from(short(local, 28)?);
    let data = start..start.checked_add(packed)?;
    let named = bytes.get(offset + LOCAL..offset + LOCAL + lengths[0])? == &bytes[name.clone()];
    if !local.starts_with(&LOCAL_MARK)
        || !same
        || !named
        || usize::from(short(local, 26)?) != lengths[0]
        || data.end > limit
    {
        return None;
    }
    let stored = method == 0 && packed == whole;
    let crc32 = long(header, 16)? as u32;
    Some(Entry { local: offset..data.end, data, central, name, crc32, stored, encrypted: flags & ENCRYPTED != 0 })
}

fn short(bytes: &[u8], at: usize) -> Option<u16> {
    bytes.get(at..)?.first_chunk().map(|b| u16::from_le_bytes(*b))
}

fn long(bytes: &[u8], at: usize) -> Option<usize> {
    bytes.get(at..)?.first_chunk().map(|b| u32::from_le_bytes(*b) as usize)
}

/// The check sum of zip.
pub fn crc32(data: &[u8]) -> u32 {
    let mut crc = flate2::Crc::new();
    crc.update(data);
    crc.sum()
}

/// Writes a stored entry: its local record to `out`, its central one to `central`. Name and data are small enough for a zip:
/// the archive's limit has been looked at.
pub fn push(name: &str, data: &[u8], out: &mut Vec<u8>, central: &mut Vec<u8>) {
    let offset = out.len() as u32;
    // What both headers have in common: from the version to extract to the length of the extra field.
    let mut common = Vec::with_capacity(26);
    common.extend(VERSION.to_le_bytes());
    // Flags (UTF-8 where there is more than ASCII), method, time.
    common.extend((if name.is_ascii() { 0u16 } else { 1 << 11 }).to_le_bytes());
    common.extend([0; 4]);
    common.extend(DATE.to_le_bytes());
    common.extend(crc32(data).to_le_bytes());
    common.extend([data.len() as u32; 2].iter().flat_map(|n| n.to_le_bytes()));
    common.extend((name.len() as u16).to_le_bytes());
    common.extend([0; 2]);

    out.extend(LOCAL_MARK);
    out.extend(&common);
    out.extend(name.as_bytes());
    out.extend(data);

    central.extend(CENTRAL_MARK);
    central.extend(MADE_BY.to_le_bytes());
    central.extend(&common);
    // No comment, the first disk, no attribute of text.
    central.extend([0; 6]);
    central.extend(ATTRIBUTES.to_le_bytes());
    central.extend(offset.to_le_bytes());
    central.extend(name.as_bytes());
}

/// A record of a directory whose entry now begins at `offset`.
pub fn push_moved(record: &[u8], offset: usize, central: &mut Vec<u8>) {
    let start = central.len();
    central.extend_from_slice(record);
    if let Some(place) = central.get_mut(start + 42..start + 46) {
        place.copy_from_slice(&(offset as u32).to_le_bytes());
    }
}

/// Writes the directory and the end of an archive.
pub fn end(count: u16, central: &[u8], comment: &[u8], out: &mut Vec<u8>) {
    let start = out.len() as u32;
    out.extend_from_slice(central);
    out.extend(END_MARK);
    out.extend([0; 4]);
    out.extend([count; 2].iter().flat_map(|n| n.to_le_bytes()));
    out.extend([central.len() as u32, start].iter().flat_map(|n| n.to_le_bytes()));
    out.extend((comment.len() as u16).to_le_bytes());
    out.extend_from_slice(comment);
}
