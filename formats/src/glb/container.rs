//! The container: a header of 12 bytes, a JSON chunk, a binary chunk (glTF 2.0 §4).

use super::FORMAT;
use crate::{Error, Result};

const MAGIC: &[u8; 4] = b"glTF";
const JSON: &[u8; 4] = b"JSON";
const BIN: &[u8; 4] = b"BIN\0";

/// The JSON text and the binary chunk, empty where there is none.
pub fn split(bytes: &[u8]) -> Result<(&[u8], &[u8])> {
    if !bytes.starts_with(MAGIC) {
        let found = format!("{:?}", String::from_utf8_lossy(&bytes[..bytes.len().min(4)]));
        return Err(Error::malformed(FORMAT, 0, "glTF", found));
    }
    let version = u32_at(bytes, 4)?;
    if version != 2 {
        return Err(Error::malformed(FORMAT, 4, "container version 2", version.to_string()));
    }
    let length = u32_at(bytes, 8)? as usize;
    if length > bytes.len() {
        return Err(Error::malformed(FORMAT, 8, format!("{length} bytes"), bytes.len().to_string()));
    }
    let bytes = &bytes[..length];
    let (kind, json, next) = chunk(bytes, 12)?;
    if kind != JSON {
        return Err(Error::malformed(FORMAT, 16, "a JSON chunk first", format!("{kind:?}")));
    }
    let mut at = next;
    while at < bytes.len() {
        let (kind, data, next) = chunk(bytes, at)?;
        if kind == BIN {
            return Ok((json, data));
        }
        at = next;
    }
    Ok((json, &[]))
}

/// Type, content and end of the chunk at a place.
fn chunk(bytes: &[u8], at: usize) -> Result<(&[u8], &[u8], usize)> {
    let length = u32_at(bytes, at)? as usize;
    let kind = bytes.get(at + 4..at + 8);
    let data = bytes.get(at + 8..).and_then(|rest| rest.get(..length));
    match (kind, data) {
        (Some(kind), Some(data)) => Ok((kind, data, at + 8 + length)),
        _ => {
            let left = bytes.len().saturating_sub(at + 8);
            Err(Error::malformed(FORMAT, at, format!("a chunk of {length} bytes"), format!("{left} to the end")))
        }
    }
}

fn u32_at(bytes: &[u8], at: usize) -> Result<u32> {
    match bytes.get(at..at + 4) {
        Some(&[a, b, c, d]) => Ok(u32::from_le_bytes([a, b, c, d])),
        _ => Err(Error::malformed(FORMAT, bytes.len(), "four more bytes", "the end of the file")),
    }
}

/// Puts the two together, each padded to 4 bytes, JSON with spaces.
///
/// # Errors
/// [`Error::Unsupported`] from 4 GiB.
pub fn join(json: &[u8], bin: &[u8]) -> Result<Vec<u8>> {
    let (json_size, bin_size) = (json.len().next_multiple_of(4), bin.len().next_multiple_of(4));
    let total = 12 + 8 + json_size + if bin.is_empty() { 0 } else { 8 + bin_size };
    if u32::try_from(total).is_err() {
        return Err(Error::unsupported(FORMAT, format!("a file holds 4 GiB, this one would have {total} bytes")));
    }
    let mut out = Vec::with_capacity(total);
    let word = |out: &mut Vec<u8>, value: usize| out.extend_from_slice(&(value as u32).to_le_bytes());
    out.extend_from_slice(MAGIC);
    word(&mut out, 2);
    word(&mut out, total);
    word(&mut out, json_size);
    out.extend_from_slice(JSON);
    out.extend_from_slice(json);
    out.resize(20 + json_size, b' ');
    if !bin.is_empty() {
        word(&mut out, bin_size);
        out.extend_from_slice(BIN);
        out.extend_from_slice(bin);
        out.resize(total, 0);
    }
    Ok(out)
}
