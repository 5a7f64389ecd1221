//! Zip archives of a tile: read, extended, written reproducibly.
//!
//! Source: OGC CDB 1.x Volume 1, "Archive names" (Requirements 68–72) and §5.8.1 (32 MB). Entries that Orb adds are
//! stored, not compressed, as CDB 1.0 has it; entries that are there already are copied as they are, compressed or not.
//! Entries are sorted by name and carry the earliest zip date, so the same content gives the same bytes.
//!
//! An archive is extended at the speed of memory: the records of its entries are copied in runs, as they are, and only the
//! offsets in its directory change. What is no plain archive (data descriptors, zip64, gaps in front) is made one by the zip
//! crate first.

mod directory;

use std::io::Cursor;
use std::ops::Range;

use zip::{ZipArchive, ZipWriter};

use crate::{Error, Result};
use directory::{Directory, Entry};

const FORMAT: &str = "CDB archive";
/// Largest archive, bytes.
pub const MAX_BYTES: usize = 32_000_000;

/// An archive, or none yet.
#[derive(Clone, Debug, Default)]
pub struct Archive {
    bytes: Vec<u8>,
    directory: Directory,
}

impl Archive {
    /// Opens an archive; `name` is for messages.
    ///
    /// # Errors
    /// [`Error::Unsupported`] when it is no readable zip, or encrypted or not UTF-8 in a name.
    pub fn read(bytes: Vec<u8>, name: &str) -> Result<Archive> {
        let (bytes, directory) = match Directory::read(&bytes) {
            Some(directory) => (bytes, directory),
            None => {
                let plain = plain(&bytes, name)?;
                let directory =
                    Directory::read(&plain).ok_or_else(|| unreadable(name, &"its directory is not plain"))?;
                (plain, directory)
            }
        };
        for entry in &directory.entries {
            let text = std::str::from_utf8(&bytes[entry.name.clone()]).map_err(|e| unreadable(name, &e))?;
            if entry.encrypted {
                return Err(unreadable(name, &format!("entry {text} is encrypted")));
            }
        }
        Ok(Archive { bytes, directory })
    }

    /// Entry names in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        // Looked at when the archive was opened.
        self.raw_names().map(|n| std::str::from_utf8(n).unwrap_or_default())
    }

    fn raw_names(&self) -> impl Iterator<Item = &[u8]> {
        self.directory.entries.iter().map(|e| &self.bytes[e.name.clone()])
    }

    fn entry(&self, name: &str) -> Option<&Entry> {
        let entries = &self.directory.entries;
        let at = entries.binary_search_by(|e| self.bytes[e.name.clone()].cmp(name.as_bytes())).ok()?;
        entries.get(at)
    }

    /// Whether there is an entry of this name, whatever the case of its letters.
    pub fn contains(&self, name: &str) -> bool {
        self.raw_names().any(|n| n.eq_ignore_ascii_case(name.as_bytes()))
    }

    /// Bytes of the archive.
    pub fn length(&self) -> usize {
        self.bytes.len()
    }

    /// The archive comment.
    pub fn comment(&self) -> &[u8] {
        &self.bytes[self.directory.comment.clone()]
    }

    /// An entry's bytes; `None` when it is not there, compressed, or its checksum is wrong.
    pub fn get(&self, name: &str) -> Option<Vec<u8>> {
        let entry = self.entry(name).filter(|e| e.stored)?;
        let data = &self.bytes[entry.data.clone()];
        (directory::crc32(data) == entry.crc32).then(|| data.to_vec())
    }

    /// Whether an entry is stored, not compressed.
    pub fn is_stored(&self, name: &str) -> bool {
        self.entry(name).is_some_and(|e| e.stored)
    }

    /// The bytes that an entry adds to an archive: its data, name twice, local and central header.
    pub fn cost(name: &str, data: &[u8]) -> usize {
        data.len() + 2 * name.len() + directory::LOCAL + directory::CENTRAL
    }

    /// Writes the archive with more entries, and with `marking` as a line of its comment.
    ///
    /// # Errors
    /// [`Error::Unsupported`] when an entry is there already, or the archive would exceed [`MAX_BYTES`].
    pub fn with(&self, new: &[(String, Vec<u8>)], marking: &str, name: &str) -> Result<Vec<u8>> {
        let mut new: Vec<(&str, &[u8])> = new.iter().map(|(n, d)| (n.as_str(), d.as_slice())).collect();
        new.sort_unstable_by_key(|(n, _)| *n);
        let twice = new.windows(2).find(|w| w[0].0 == w[1].0).map(|w| w[0].0);
        if let Some(entry) = twice.or_else(|| new.iter().map(|(n, _)| *n).find(|n| self.contains(n))) {
            return Err(Error::Unsupported { format: FORMAT, what: format!("{name} already holds {entry}") });
        }
        let old = &self.directory.entries;
        let comment = joined(self.comment(), marking.as_bytes());
        let kept: usize = old.iter().map(|e| e.local.len() + e.central.len()).sum();
        let added: usize = new.iter().map(|(n, d)| Archive::cost(n, d)).sum();
        let total = kept + added + directory::END + comment.len();
        if total > MAX_BYTES {
            return Err(too_large(name, total));
        }
        let Ok(count) = u16::try_from(old.len() + new.len()) else {
            let what = format!("{name} would have {} entries, a zip takes {}", old.len() + new.len(), u16::MAX);
            return Err(Error::Unsupported { format: FORMAT, what });
        };
        let mut out = Vec::with_capacity(total);
        let mut central = Vec::with_capacity(total.saturating_sub(added));
        let mut from = 0;
        for (entry, data) in new {
            let to = from + old[from..].partition_point(|e| self.bytes[e.name.clone()] < *entry.as_bytes());
            self.copy(from..to, &mut out, &mut central);
            from = to;
            directory::push(entry, data, &mut out, &mut central);
        }
        self.copy(from..old.len(), &mut out, &mut central);
        directory::end(count, &central, &comment, &mut out);
        Ok(out)
    }

    /// Copies entries as they are, neighbours in one piece; in the directory their offsets change.
    fn copy(&self, entries: Range<usize>, out: &mut Vec<u8>, central: &mut Vec<u8>) {
        let mut run = 0..0;
        for entry in &self.directory.entries[entries] {
            if entry.local.start != run.end {
                out.extend_from_slice(&self.bytes[run]);
                run = entry.local.start..entry.local.start;
            }
            let offset = out.len() + run.len();
            run.end = entry.local.end;
            directory::push_moved(&self.bytes[entry.central.clone()], offset, central);
        }
        out.extend_from_slice(&self.bytes[run]);
    }
}

/// The same entries, sorted, in a plain archive.
fn plain(bytes: &[u8], name: &str) -> Result<Vec<u8>> {
    let fail = |e: zip::result::ZipError| unreadable(name, &e);
    let mut zip = ZipArchive::new(Cursor::new(bytes)).map_err(fail)?;
    let mut order = Vec::new();
    // Entries that lie on each other would be copied more than once.
    let mut left = bytes.len() as u64;
    for i in 0..zip.len() {
        let entry = zip.by_index_raw(i).map_err(fail)?;
        left = left
            .checked_sub(entry.compressed_size())
            .ok_or_else(|| unreadable(name, &"its entries lie on each other"))?;
        if entry.encrypted() {
            return Err(unreadable(name, &format!("entry {} is encrypted", String::from_utf8_lossy(entry.name_raw()))));
        }
        order.push((entry.name_raw().to_vec(), i));
    }
    order.sort_unstable();
    let mut writer = ZipWriter::new(Cursor::new(Vec::with_capacity(bytes.len())));
    for (_, i) in order {
        writer.raw_copy_file(zip.by_index_raw(i).map_err(fail)?).map_err(fail)?;
    }
    writer.set_raw_comment(zip.comment().into()).map_err(fail)?;
    Ok(writer.finish().map_err(fail)?.into_inner())
}

/// The refusal of an archive past the limit.
pub fn too_large(name: &str, bytes: usize) -> Error {
    Error::Unsupported {
        format: FORMAT,
        what: format!(
            "{name} would take {bytes} bytes, a CDB archive at most {MAX_BYTES}: the tile is full; use smaller textures \
             or another store"
        ),
    }
}

/// A comment with one more line, unless it has it already; without it when the zip format has no more room.
fn joined(comment: &[u8], line: &[u8]) -> Vec<u8> {
    let there = comment.split(|&b| b == b'\n').any(|l| l.trim_ascii_end() == line);
    if line.is_empty() || there || comment.len() + line.len() + 1 > 65_535 {
        return comment.into();
    }
    if comment.is_empty() { line.into() } else { [comment, line].join(&b'\n') }
}

fn unreadable(name: &str, reason: &dyn std::fmt::Display) -> Error {
    Error::Unsupported { format: FORMAT, what: format!("{name} cannot be kept: {reason}") }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use zip::write::SimpleFileOptions;
    use zip::{CompressionMethod, DateTime};

    use super::*;

    fn entry(name: &str, data: &[u8]) -> (String, Vec<u8>) {
        (name.into(), data.to_vec())
    }

    #[test]
    fn entries_are_stored_sorted_and_reproducible() {
        let new = [entry("b.flt", b"second"), entry("a.flt", b"first")];
        let bytes = Archive::default().with(&new, "CUI", "x.zip").unwrap();
        let swapped = [new[1].clone(), new[0].clone()];
        assert_eq!(bytes, Archive::default().with(&swapped, "CUI", "x.zip").unwrap());
        let cost: usize = new.iter().map(|(n, d)| Archive::cost(n, d)).sum();
        assert_eq!(bytes.len(), 22 + "CUI".len() + cost, "plain zip: no descriptors, no extra fields");
        assert_eq!(&bytes[..8], [b'P', b'K', 3, 4, 10, 0, 0, 0]);
        let back = Archive::read(bytes, "x.zip").unwrap();
        assert_eq!(back.names().collect::<Vec<_>>(), ["a.flt", "b.flt"]);
        assert_eq!(back.get("b.flt").as_deref(), Some(&b"second"[..]));
        assert!(back.is_stored("a.flt") && back.contains("A.FLT") && !back.contains("c.flt"));
        assert_eq!(back.comment(), b"CUI");
    }

    #[test]
    fn growing_an_archive_equals_writing_it_at_once() {
        let (a, b) = (entry("a", b"first"), entry("b", b"second"));
        let first = Archive::default().with(std::slice::from_ref(&b), "CUI", "x.zip").unwrap();
        let grown = Archive::read(first, "x.zip").unwrap().with(std::slice::from_ref(&a), "CUI", "x.zip").unwrap();
        assert_eq!(grown, Archive::default().with(&[a, b], "CUI", "x.zip").unwrap());
    }

    #[test]
    fn markings_gather_in_the_comment() {
        let first = Archive::default().with(&[entry("a", b"1")], "UNCLASSIFIED", "x").unwrap();
        let second = Archive::read(first, "x").unwrap().with(&[entry("b", b"2")], "SECRET", "x").unwrap();
        let third = Archive::read(second, "x").unwrap().with(&[entry("c", b"3")], "SECRET", "x").unwrap();
        assert_eq!(Archive::read(third, "x").unwrap().comment(), b"UNCLASSIFIED\nSECRET");
    }

    #[test]
    fn a_compressed_entry_is_copied_as_it_is() {
        // `a` holding 40 times "x", deflated, as Python's zipfile writes it.
        let data = [0xABu8, 0xA8, 0x20, 0x0E, 0x00, 0x00];
        let head = |offset: bool| {
            let mut h = vec![];
            h.extend(if offset { &b"PK\x01\x02\x14\x03\x14\x00"[..] } else { &b"PK\x03\x04\x14\x00"[..] });
            h.extend(b"\x00\x00\x08\x00\x00\x00\x21\x00");
            h.extend(0x1234_5678u32.to_le_bytes());
            h.extend((data.len() as u32).to_le_bytes());
            h.extend(40u32.to_le_bytes());
            h.extend(b"\x01\x00\x00\x00");
            if offset {
                h.extend([0; 14]);
            }
            h.push(b'a');
            h
        };
        let mut bytes = head(false);
        bytes.extend(data);
        let (start, central) = (bytes.len() as u32, head(true));
        bytes.extend(&central);
        bytes.extend(b"PK\x05\x06\0\0\0\0\x01\0\x01\0");
        bytes.extend((central.len() as u32).to_le_bytes());
        bytes.extend(start.to_le_bytes());
        bytes.extend([0, 0]);
        let old = Archive::read(bytes, "x").unwrap();
        assert!(!old.is_stored("a"));
        let grown = old.with(&[entry("b", b"new")], "", "x").unwrap();
        assert!(grown.windows(data.len()).any(|w| w == data), "the compressed bytes are carried over");
        let back = Archive::read(grown, "x").unwrap();
        assert!(!back.is_stored("a") && back.is_stored("b"));
        assert_eq!(back.entry("a").unwrap().crc32, 0x1234_5678);
    }

    #[test]
    fn the_zip_crate_writes_the_same_bytes() {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .last_modified_time(DateTime::DEFAULT)
            .unix_permissions(0o644);
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        let new = [entry("a.flt", b"first"), entry("b/ü.rgb", b""), entry("c.xml", &[7; 1000])];
        for (name, data) in &new {
            writer.start_file(name.as_str(), options).unwrap();
            writer.write_all(data).unwrap();
        }
        writer.set_comment("CUI").unwrap();
        assert_eq!(Archive::default().with(&new, "CUI", "x").unwrap(), writer.finish().unwrap().into_inner());
    }

    /// An archive as streams are packed: sizes and check sum behind the data.
    fn streamed(names: &[&str]) -> Vec<u8> {
        let mut writer = ZipWriter::new_stream(Vec::new());
        for name in names {
            writer
                .start_file(*name, SimpleFileOptions::default().compression_method(CompressionMethod::Stored))
                .unwrap();
            writer.write_all(name.as_bytes()).unwrap();
        }
        writer.finish().unwrap().into_inner()
    }

    #[test]
    fn what_is_not_plain_is_made_plain() {
        let bytes = streamed(&["b", "a"]);
        assert!(Directory::read(&bytes).is_none());
        let prefixed = [&b"a program that unpacks itself"[..], &streamed(&["b", "a"])].concat();
        for bytes in [bytes, prefixed] {
            let archive = Archive::read(bytes, "x").unwrap();
            assert_eq!(archive.names().collect::<Vec<_>>(), ["a", "b"]);
            let grown = Archive::read(archive.with(&[entry("aa", b"new")], "", "x").unwrap(), "x").unwrap();
            let contents: Vec<_> = ["a", "aa", "b"].map(|n| grown.get(n).unwrap()).concat();
            assert_eq!(contents, b"anewb");
        }
    }

    #[test]
    fn a_directory_that_contradicts_itself_is_not_plain() {
        let good = Archive::default().with(&[entry("a", b"first"), entry("b", b"second")], "CUI", "x").unwrap();
        assert_eq!(Directory::read(&good).unwrap().entries.len(), 2);
        let second = good.windows(4).rposition(|w| w == b"PK\x01\x02").unwrap();
        let end = good.windows(4).rposition(|w| w == b"PK\x05\x06").unwrap();
        // Offset, name, size, check sum and flags of the second entry; count, size and place of the directory.
        for at in [second + 42, second + 46, second + 20, second + 16, second + 8, end + 10, end + 12, end + 16] {
            let mut bad = good.clone();
            bad[at] ^= 8;
            assert!(Directory::read(&bad).is_none(), "byte {at}");
        }
        // Both entries at one place.
        let mut twice = good.clone();
        twice[second + 42..second + 46].fill(0);
        assert!(Directory::read(&twice).is_none());
    }

    #[test]
    fn what_cannot_be_kept_is_refused() {
        assert!(Archive::read(b"not a zip".to_vec(), "x").is_err());
        let one = Archive::default().with(&[entry("a", b"1")], "", "x").unwrap();
        for end in 0..one.len() {
            assert!(Archive::read(one[..end].to_vec(), "x").is_err(), "cut at {end}");
        }
        let one = Archive::read(one, "x").unwrap();
        assert!(one.with(&[entry("A", b"2")], "", "x").is_err(), "same name but for the case");
        let big = vec![0; MAX_BYTES];
        assert!(one.with(&[("b".into(), big)], "", "x").unwrap_err().to_string().contains("at most 32000000"));
    }
}
