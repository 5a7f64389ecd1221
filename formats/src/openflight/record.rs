//! Records: opcode, length, body; all numbers big-endian.

use super::FORMAT;
use crate::{Error, Result};
use std::borrow::Cow;

/// Record opcodes that are written or understood.
pub mod opcode {
    pub const HEADER: u16 = 1;
    pub const GROUP: u16 = 2;
    pub const OBJECT: u16 = 4;
    pub const FACE: u16 = 5;
    pub const PUSH: u16 = 10;
    pub const POP: u16 = 11;
    pub const PUSH_SUBFACE: u16 = 19;
    pub const POP_SUBFACE: u16 = 20;
    pub const CONTINUATION: u16 = 23;
    pub const COMMENT: u16 = 31;
    pub const COLOR_PALETTE: u16 = 32;
    pub const LONG_ID: u16 = 33;
    pub const MATRIX: u16 = 49;
    pub const INSTANCE_REFERENCE: u16 = 61;
    pub const INSTANCE_DEFINITION: u16 = 62;
    pub const EXTERNAL_REFERENCE: u16 = 63;
    pub const TEXTURE: u16 = 64;
    pub const VERTEX_PALETTE: u16 = 67;
    /// Vertex with colour.
    pub const VERTEX_C: u16 = 68;
    /// Vertex with colour and normal.
    pub const VERTEX_CN: u16 = 69;
    /// Vertex with colour, normal and texture coordinate.
    pub const VERTEX_CNUV: u16 = 70;
    /// Vertex with colour and texture coordinate.
    pub const VERTEX_CUV: u16 = 71;
    pub const VERTEX_LIST: u16 = 72;
    pub const LOD: u16 = 73;
    pub const BOUNDING_BOX: u16 = 74;
    pub const MESH: u16 = 84;
    pub const LOCAL_VERTEX_POOL: u16 = 85;
    pub const MESH_PRIMITIVE: u16 = 86;
    pub const EXTENSION: u16 = 100;
    pub const MATERIAL: u16 = 113;
    pub const NAME_TABLE: u16 = 114;

    /// Primary records of nodes: what may own ancillary records and children.
    pub fn is_node(opcode: u16) -> bool {
        matches!(
            opcode,
            GROUP | OBJECT | FACE | VERTEX_LIST | LOD | MESH | MESH_PRIMITIVE
                | 14 // degree of freedom
                | 55 // binary separating plane
                | INSTANCE_REFERENCE | INSTANCE_DEFINITION
                | EXTERNAL_REFERENCE
                | 87 | 91 | 92 | 95 | 98 // road segment, sound, road path, text, clip region
                | 89 // morph vertex list
                | 96 // switch
                | 101 | 111 | 130 // light source, light point, light point system
                | 115 | 126 // continuously adaptive terrain, curve
        )
    }
}

/// One logical record: its bytes from the opcode on, continuation records already joined.
#[derive(Clone, Debug)]
pub struct Record<'a> {
    pub opcode: u16,
    /// Where it begins in the file.
    pub offset: usize,
    pub bytes: Cow<'a, [u8]>,
}

impl Record<'_> {
    fn array<const N: usize>(&self, at: usize) -> Result<[u8; N]> {
        let field = at.checked_add(N).and_then(|end| self.bytes.get(at..end));
        field.and_then(|f| f.try_into().ok()).ok_or_else(|| Error::Malformed {
            format: FORMAT,
            offset: self.offset as u64,
            expected: format!("record {} with a field of {N} bytes at {at}", self.opcode),
            found: format!("a length of {}", self.bytes.len()),
        })
    }

    pub fn u16(&self, at: usize) -> Result<u16> {
        self.array(at).map(u16::from_be_bytes)
    }

    pub fn i16(&self, at: usize) -> Result<i16> {
        self.array(at).map(i16::from_be_bytes)
    }

    pub fn u32(&self, at: usize) -> Result<u32> {
        self.array(at).map(u32::from_be_bytes)
    }

    pub fn i32(&self, at: usize) -> Result<i32> {
        self.array(at).map(i32::from_be_bytes)
    }

    pub fn f32(&self, at: usize) -> Result<f32> {
        self.array(at).map(f32::from_be_bytes)
    }

    pub fn f64(&self, at: usize) -> Result<f64> {
        self.array(at).map(f64::from_be_bytes)
    }

    pub fn vec3(&self, at: usize) -> Result<[f64; 3]> {
        Ok([self.f64(at)?, self.f64(at + 8)?, self.f64(at + 16)?])
    }

    pub fn vec3_f32(&self, at: usize) -> Result<[f32; 3]> {
        Ok([self.f32(at)?, self.f32(at + 4)?, self.f32(at + 8)?])
    }

    pub fn vec2_f32(&self, at: usize) -> Result<[f32; 2]> {
        Ok([self.f32(at)?, self.f32(at + 4)?])
    }

    /// The bytes of a text field of at most `length` bytes, without NUL and what follows, and whether a NUL was there.
    pub fn text_bytes(&self, at: usize, length: usize) -> (&[u8], bool) {
        let rest = self.bytes.get(at..).unwrap_or_default();
        let field = &rest[..length.min(rest.len())];
        match field.iter().position(|&b| b == 0) {
            Some(end) => (&field[..end], true),
            None => (field, false),
        }
    }

    /// A text field. Bytes past ASCII, which the format does not define, are taken as Latin-1.
    pub fn text(&self, at: usize, length: usize) -> String {
        self.text_bytes(at, length).0.iter().map(|&b| char::from(b)).collect()
    }

    /// A text that fills the rest of the record.
    pub fn string(&self, at: usize) -> String {
        self.text(at, usize::MAX)
    }
}

/// Splits bytes into logical records; an error ends the sequence.
pub fn records(bytes: &[u8]) -> impl Iterator<Item = Result<Record<'_>>> {
    let mut at = 0;
    let mut broken = false;
    std::iter::from_fn(move || {
        if broken || at == bytes.len() {
            return None;
        }
        let record = physical(bytes, at).and_then(|first| {
            at += first.bytes.len();
            join_continuations(bytes, first, &mut at)
        });
        broken = record.is_err();
        Some(record)
    })
}

fn physical(bytes: &[u8], offset: usize) -> Result<Record<'_>> {
    let malformed =
        |expected: String, found: String| Error::Malformed { format: FORMAT, offset: offset as u64, expected, found };
    let rest = &bytes[offset..];
    let [a, b, c, d, ..] = *rest else {
        return Err(malformed("a record of at least 4 bytes".into(), format!("{} bytes to the end", rest.len())));
    };
    let (opcode, length) = (u16::from_be_bytes([a, b]), usize::from(u16::from_be_bytes([c, d])));
    if length < 4 {
        return Err(malformed(format!("a length of at least 4 in record {opcode}"), length.to_string()));
    }
    let Some(body) = rest.get(..length) else {
        let expected = format!("{length} bytes of record {opcode}");
        return Err(malformed(expected, format!("{} bytes to the end of the file", rest.len())));
    };
    Ok(Record { opcode, offset, bytes: Cow::Borrowed(body) })
}

/// Appends the bodies of the continuation records that follow; only these four opcodes may be continued.
fn join_continuations<'a>(bytes: &'a [u8], mut record: Record<'a>, at: &mut usize) -> Result<Record<'a>> {
    use opcode::*;
    if matches!(record.opcode, EXTENSION | NAME_TABLE | LOCAL_VERTEX_POOL | MESH_PRIMITIVE) {
        while bytes[*at..].starts_with(&CONTINUATION.to_be_bytes()) {
            let next = physical(bytes, *at)?;
            *at += next.bytes.len();
            record.bytes.to_mut().extend_from_slice(&next.bytes[4..]);
        }
    }
    Ok(record)
}

/// Appends records: `begin`, the fields in order, `end`.
pub struct Writer {
    pub bytes: Vec<u8>,
    start: usize,
}

impl Writer {
    pub fn with_capacity(capacity: usize) -> Self {
        Self { bytes: Vec::with_capacity(capacity), start: 0 }
    }

    pub fn begin(&mut self, opcode: u16) {
        self.start = self.bytes.len();
        self.u16(opcode);
        self.u16(0); // the length, set by `end`
    }

    /// Pads the record to a multiple of 4 and sets its length. Callers keep bodies under 64 KiB.
    pub fn end(&mut self) {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let length = self.bytes.len() - self.start;
        debug_assert!(length <= 65532, "a record of {length} bytes needs continuation");
        self.bytes[self.start + 2..self.start + 4].copy_from_slice(&(length as u16).to_be_bytes());
    }

    /// A record without a body: push and pop.
    pub fn control(&mut self, opcode: u16) {
        self.begin(opcode);
        self.end();
    }

    /// A record that holds one string: comment and long ID.
    pub fn string_record(&mut self, opcode: u16, text: &str) {
        self.begin(opcode);
        self.bytes.extend_from_slice(text.as_bytes());
        self.u8(0);
        self.end();
    }

    pub fn u8(&mut self, value: u8) {
        self.bytes.push(value);
    }

    pub fn u16(&mut self, value: u16) {
        self.bytes.extend_from_slice(&value.to_be_bytes());
    }

    pub fn i16(&mut self, value: i16) {
        self.bytes.extend_from_slice(&value.to_be_bytes());
    }

    pub fn u32(&mut self, value: u32) {
        self.bytes.extend_from_slice(&value.to_be_bytes());
    }

    pub fn i32(&mut self, value: i32) {
        self.bytes.extend_from_slice(&value.to_be_bytes());
    }

    pub fn f32s(&mut self, values: &[f32]) {
        values.iter().for_each(|v| self.bytes.extend_from_slice(&v.to_be_bytes()));
    }

    pub fn f64s(&mut self, values: &[f64]) {
        values.iter().for_each(|v| self.bytes.extend_from_slice(&v.to_be_bytes()));
    }

    pub fn zeros(&mut self, count: usize) {
        self.bytes.resize(self.bytes.len() + count, 0);
    }

    /// A fixed text field, zero-filled. Callers keep the text shorter than the field.
    pub fn text(&mut self, text: &str, length: usize) {
        debug_assert!(text.len() < length, "{text:?} does not fit {length} bytes");
        let end = self.bytes.len() + length;
        self.bytes.extend_from_slice(text.as_bytes());
        self.bytes.resize(end, 0);
    }
}
