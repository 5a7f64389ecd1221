//! KMZ (OGC KML 2.3, 12-007r2, annex C): a zip whose first entry is the KML document.

use std::io::{Cursor, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use crate::{Error, Result};

/// Packs `doc.kml` and the files that it names, in this order, stored, with one fixed time: same content, same bytes.
/// `marking` becomes the archive's comment.
///
/// # Errors
/// A name that a zip cannot hold.
pub fn write(document: &str, files: &[(String, Vec<u8>)], marking: &str) -> Result<Vec<u8>> {
    let fault = |e: &dyn std::fmt::Display| Error::Unsupported { format: "KMZ", what: e.to_string() };
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(DateTime::DEFAULT);
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let document = [("doc.kml", document.as_bytes())];
    for (name, bytes) in document.into_iter().chain(files.iter().map(|(n, b)| (n.as_str(), b.as_slice()))) {
        zip.start_file(name, options).map_err(|e| fault(&e))?;
        zip.write_all(bytes).map_err(|e| fault(&e))?;
    }
    zip.set_raw_comment(marking.as_bytes().into()).map_err(|e| fault(&e))?;
    Ok(zip.finish().map_err(|e| fault(&e))?.into_inner())
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    #[test]
    fn the_document_comes_first() {
        let bytes = super::write("<kml/>", &[("a/b.dae".into(), b"x".to_vec())], "CLASSIFICATION: CUI").unwrap();
        assert_eq!(bytes, super::write("<kml/>", &[("a/b.dae".into(), b"x".to_vec())], "CLASSIFICATION: CUI").unwrap());
        let mut zip = zip::ZipArchive::new(std::io::Cursor::new(bytes)).unwrap();
        assert_eq!(zip.comment(), b"CLASSIFICATION: CUI");
        assert_eq!(zip.by_index(0).unwrap().name().unwrap(), "doc.kml");
        let mut text = String::new();
        zip.by_name("a/b.dae").unwrap().read_to_string(&mut text).unwrap();
        assert_eq!(text, "x");
    }
}
