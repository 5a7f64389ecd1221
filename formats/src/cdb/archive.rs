//! Zip archives of a tile: read, extended, written reproducibly.
//!
//! Source: OGC CDB 1.x Volume 1, "Archive names" (Requirements 68–72) and §5.8.1 (32 MB). Entries that Orb adds are
//! stored, not compressed, as CDB 1.0 has it; entries that are there already are copied as they are, compressed or not.
//! Entries are sorted by name and carry the earliest zip date, so the same content gives the same bytes.

use std::collections::BTreeMap;
use std::io::{Cursor, Read, Write};
use std::sync::Arc;

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipArchive, ZipWriter};

use crate::{Error, Result};

const FORMAT: &str = "CDB archive";
/// Largest archive, bytes.
pub const MAX_BYTES: usize = 32_000_000;

/// An archive, or none yet.
#[derive(Clone, Debug, Default)]
pub struct Archive {
    zip: Option<ZipArchive<Cursor<Arc<[u8]>>>>,
    /// Entry names and their places in the archive.
    entries: BTreeMap<String, usize>,
    length: usize,
}

impl Archive {
    /// Opens an archive; `name` is for messages.
    ///
    /// # Errors
    /// [`Error::Unsupported`] when it is no readable zip, or encrypted or not UTF-8 in a name.
    pub fn read(bytes: Vec<u8>, name: &str) -> Result<Archive> {
        let length = bytes.len();
        let mut zip = ZipArchive::new(Cursor::new(Arc::from(bytes))).map_err(|e| unreadable(name, &e))?;
        let mut entries = BTreeMap::new();
        for i in 0..zip.len() {
            let entry = zip.by_index_raw(i).map_err(|e| unreadable(name, &e))?;
            let text = std::str::from_utf8(entry.name_raw()).map_err(|e| unreadable(name, &e))?;
            if entry.encrypted() {
                return Err(unreadable(name, &format!("entry {text} is encrypted")));
            }
            entries.insert(text.to_string(), i);
        }
        Ok(Archive { zip: Some(zip), entries, length })
    }

    /// Entry names in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.entries.keys().map(String::as_str)
    }

    /// Whether there is an entry of this name, whatever the case of its letters.
    pub fn contains(&self, name: &str) -> bool {
        self.entries.keys().any(|n| n.eq_ignore_ascii_case(name))
    }

    /// Bytes of the archive.
    pub fn length(&self) -> usize {
        self.length
    }

    /// The archive comment.
    pub fn comment(&self) -> &[u8] {
        self.zip.as_ref().map_or(&[], |z| z.comment())
    }

    /// An entry's bytes; `None` when it is not there, compressed, or its checksum is wrong.
    pub fn get(&self, name: &str) -> Option<Vec<u8>> {
        let mut zip = self.zip.clone()?;
        let mut entry = zip.by_index(*self.entries.get(name)?).ok()?;
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).ok()?;
        Some(bytes)
    }

    /// Whether an entry is stored, not compressed.
    pub fn is_stored(&mut self, name: &str) -> bool {
        let (Some(zip), Some(&i)) = (self.zip.as_mut(), self.entries.get(name)) else { return false };
        zip.by_index_raw(i).is_ok_and(|e| e.compression() == CompressionMethod::Stored)
    }

    /// The bytes that an entry adds to an archive: its data, name twice, local and central header.
    pub fn cost(name: &str, data: &[u8]) -> usize {
        data.len() + 2 * name.len() + 30 + 46
    }

    /// Writes the archive with more entries, and with `marking` as a line of its comment.
    ///
    /// # Errors
    /// [`Error::Unsupported`] when an entry is there already, or the archive would exceed [`MAX_BYTES`].
    pub fn with(&self, new: &[(String, Vec<u8>)], marking: &str, name: &str) -> Result<Vec<u8>> {
        let fail = |e: zip::result::ZipError| unreadable(name, &e);
        let mut old = self.zip.clone();
        let mut order: BTreeMap<&str, Option<&[u8]>> = self.names().map(|n| (n, None)).collect();
        for (entry, data) in new {
            if self.contains(entry) || order.insert(entry, Some(data)).is_some() {
                return Err(Error::Unsupported { format: FORMAT, what: format!("{name} already holds {entry}") });
            }
        }
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .last_modified_time(DateTime::DEFAULT)
            .unix_permissions(0o644);
        for (entry, data) in order {
            match (data, &mut old) {
                (Some(data), _) => {
                    writer.start_file(entry, options).map_err(fail)?;
                    writer.write_all(data).map_err(|e| unreadable(name, &e))?;
                }
                (None, Some(zip)) => {
                    let index = self.entries.get(entry).copied().unwrap_or(usize::MAX);
                    writer.raw_copy_file(zip.by_index_raw(index).map_err(fail)?).map_err(fail)?;
                }
                (None, None) => {}
            }
        }
        writer.set_raw_comment(joined(self.comment(), marking.as_bytes()).into()).map_err(fail)?;
        let bytes = writer.finish().map_err(fail)?.into_inner();
        if bytes.len() > MAX_BYTES {
            return Err(too_large(name, bytes.len()));
        }
        Ok(bytes)
    }
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
        let mut back = Archive::read(bytes, "x.zip").unwrap();
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
        let mut old = Archive::read(bytes, "x").unwrap();
        assert!(!old.is_stored("a"));
        let grown = old.with(&[entry("b", b"new")], "", "x").unwrap();
        assert!(grown.windows(data.len()).any(|w| w == data), "the compressed bytes are carried over");
        let mut back = Archive::read(grown, "x").unwrap();
        assert!(!back.is_stored("a") && back.is_stored("b"));
        assert_eq!(back.zip.as_mut().unwrap().by_index_raw(0).unwrap().crc32(), 0x1234_5678);
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
