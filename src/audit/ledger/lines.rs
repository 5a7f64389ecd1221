//! The lines of a ledger's file: one envelope each.

use std::fs::{File, OpenOptions};
use std::io::{BufRead as _, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::Path;

use crate::audit::dsse::MAX_ENVELOPE_BYTES;
use crate::{Error, Result};

/// Reads one line with its line feed into `line`; false at the end of the file. A line longer than any record ends at
/// that length, so that it is found to be none.
pub(in crate::audit) fn read_line_limited(
    reader: &mut impl std::io::BufRead,
    line: &mut Vec<u8>,
) -> std::io::Result<bool> {
    line.clear();
    reader.take(MAX_ENVELOPE_BYTES as u64 + 2).read_until(b'\n', line)?;
    Ok(!line.is_empty())
}

/// The line that ends just before `end`.
pub(super) fn line_before(file: &mut File, end: u64) -> std::io::Result<Vec<u8>> {
    let bytes = tail(file, end)?;
    let body = bytes.strip_suffix(b"\n").unwrap_or(&bytes);
    let start = body.iter().rposition(|b| *b == b'\n').map_or(0, |i| i + 1);
    Ok(bytes[start..].to_vec())
}

/// A line without its end was never acknowledged and nothing was published with it: a crash, not tampering. It is
/// moved to `orb-ledger.incomplete`, not thrown away.
pub(super) fn set_partial_line_aside(file: &mut File, path: &Path) -> Result<()> {
    let io = |e: std::io::Error| Error::io(path, &e);
    let length = file.metadata().map_err(io)?.len();
    let tail = tail(file, length).map_err(io)?;
    let keep = tail.iter().rposition(|b| *b == b'\n').map_or(0, |i| i + 1);
    let partial = &tail[keep..];
    if partial.is_empty() {
        return Ok(());
    }
    if keep == 0 && length > tail.len() as u64 {
        return Err(Error::integrity(path.display().to_string()).found("LIMIT_EXCEEDED: a line longer than any record"));
    }
    let aside_path = path.with_extension("incomplete");
    let mut aside =
        OpenOptions::new().create(true).append(true).open(&aside_path).map_err(|e| Error::io(&aside_path, &e))?;
    aside
        .write_all(partial)
        .and_then(|()| aside.write_all(b"\n"))
        .and_then(|()| aside.sync_all())
        .map_err(|e| Error::io(&aside_path, &e))?;
    file.set_len(length - partial.len() as u64).and_then(|()| file.sync_all()).map_err(io)
}

/// The last bytes of the file: enough for the longest line, the end of the one before, and a partial one.
fn tail(file: &mut File, length: u64) -> std::io::Result<Vec<u8>> {
    let window = (MAX_ENVELOPE_BYTES as u64 + 2).min(length);
    file.seek(SeekFrom::Start(length - window))?;
    let mut bytes = Vec::new();
    (&mut *file).take(window).read_to_end(&mut bytes)?;
    Ok(bytes)
}
