//! Typed access to the binary chunk: nothing is made room for that is not there.

use std::cell::{Cell, OnceCell};

use super::FORMAT;
use super::json::{Accessor, Primitive, Root};
use super::meshopt::Packed;
use super::read::missing;
use crate::splats::whole;
use crate::{Error, Result};

/// Typed access to the binary chunk.
pub struct Accessors<'a> {
    pub root: &'a Root,
    pub bin: &'a [u8],
    /// What compressed views hold, once they are asked for.
    unfolded: Vec<OnceCell<Vec<u8>>>,
    /// Bytes that they may still unfold to.
    left: Cell<usize>,
}

/// Bytes that compressed views may unfold to, for each of the binary chunk and besides.
const UNFOLDED: usize = 24;
const UNFOLDED_BESIDES: usize = 1 << 20;

/// The rows of an accessor, all of them inside the file.
pub struct Rows<'a> {
    bytes: &'a [u8],
    stride: usize,
    pub count: usize,
    component_type: u32,
    normalized: bool,
}

const FLOAT: u32 = 5126;

impl<'a> Accessors<'a> {
    pub fn new(root: &'a Root, bin: &'a [u8]) -> Self {
        let unfolded = root.buffer_views.iter().map(|_| OnceCell::new()).collect();
        let left = bin.len().saturating_mul(UNFOLDED).saturating_add(UNFOLDED_BESIDES);
        Accessors { root, bin, unfolded, left: Cell::new(left) }
    }

    pub fn view(&self, index: usize) -> Result<(&[u8], Option<usize>)> {
        let view = self.root.buffer_views.get(index).ok_or_else(|| missing("buffer view", index))?;
        if let (Some(packed), Some(cell)) = (&view.extensions.packed, self.unfolded.get(index)) {
            return Ok((self.unfolded(packed, cell)?, view.byte_stride));
        }
        let embedded = view.buffer == 0 && self.root.buffers.first().is_some_and(|b| b.uri.is_none());
        if !embedded {
            return Err(Error::unsupported(FORMAT, "a buffer outside the file; pack it into the GLB"));
        }
        let bytes = self.bin.get(view.byte_offset..).and_then(|rest| rest.get(..view.byte_length));
        let bytes = bytes.ok_or_else(|| {
            let expected = format!("buffer view {index} inside {} bytes", self.bin.len());
            Error::malformed(FORMAT, 20, expected, format!("{} bytes at {}", view.byte_length, view.byte_offset))
        })?;
        Ok((bytes, view.byte_stride))
    }

    fn unfolded<'s>(&'s self, packed: &Packed, cell: &'s OnceCell<Vec<u8>>) -> Result<&'s [u8]> {
        if let Some(bytes) = cell.get() {
            return Ok(bytes);
        }
        if packed.buffer != 0 || self.root.buffers.first().is_none_or(|b| b.uri.is_some()) {
            return Err(Error::unsupported(FORMAT, "a buffer outside the file; pack it into the GLB"));
        }
        let bytes = packed.unpack(self.bin, self.left.get())?;
        self.left.set(self.left.get().saturating_sub(bytes.len()));
        Ok(cell.get_or_init(|| bytes))
    }

    fn accessor(&self, index: usize) -> Result<&Accessor> {
        let accessor = self.root.accessors.get(index).ok_or_else(|| missing("accessor", index))?;
        // The format's least: what is empty would cost nothing, however often it is repeated.
        if accessor.count == 0 {
            return Err(Error::malformed(FORMAT, 20, format!("at least one element of accessor {index}"), "none"));
        }
        Ok(accessor)
    }

    /// Vertices of a primitive, at most its corners.
    pub fn vertices(&self, primitive: &Primitive) -> Result<usize> {
        let count = |index: &usize| self.accessor(*index).map(|a| a.count);
        let positions = primitive.attributes.get("POSITION").map(count).transpose()?.unwrap_or(0);
        let corners = primitive.indices.as_ref().map(count).transpose()?.unwrap_or(0);
        Ok(positions.max(corners / 3))
    }

    /// The rows of so many components; those of vectors of four may be taken for three.
    pub fn rows(&self, index: usize, width: usize) -> Result<Rows<'_>> {
        let accessor = self.accessor(index)?;
        let expected = ["", "SCALAR", "VEC2", "VEC3", "VEC4"][width];
        if accessor.kind != expected && !(width == 3 && accessor.kind == "VEC4") {
            return Err(Error::malformed(
                FORMAT,
                20,
                format!("accessor {index} of {expected}"),
                accessor.kind.as_str(),
            ));
        }
        let stored = if accessor.kind == "VEC4" { 4 } else { width };
        if accessor.sparse.is_some() {
            return Err(Error::unsupported(FORMAT, format!("accessor {index} is sparse; store it in full")));
        }
        let Some(view) = accessor.buffer_view else {
            return Err(Error::unsupported(FORMAT, format!("accessor {index} has no data")));
        };
        let row = size(accessor.component_type)? * stored;
        let (bytes, stride) = self.view(view)?;
        let stride = stride.unwrap_or(row);
        let rows = bytes.get(accessor.byte_offset..);
        let needed = accessor.count.checked_sub(1).map(|n| n.checked_mul(stride).and_then(|n| n.checked_add(row)));
        let rows = rows.filter(|rows| needed.is_none_or(|n| n.is_some_and(|n| n <= rows.len())));
        let Some(rows) = rows.filter(|_| stride >= row) else {
            let expected = format!("accessor {index} inside its view of {} bytes", bytes.len());
            let found = format!("{} rows of {row} every {stride} from {}", accessor.count, accessor.byte_offset);
            return Err(Error::malformed(FORMAT, 20, expected, found));
        };
        Ok(Rows {
            bytes: rows,
            stride,
            count: accessor.count,
            component_type: accessor.component_type,
            normalized: accessor.normalized,
        })
    }

    /// Rows of finite floats.
    pub fn vectors<const N: usize>(&self, index: usize) -> Result<Vec<[f32; N]>> {
        let rows = self.rows(index, N)?;
        let values: Vec<[f32; N]> = (0..rows.count).map(|i| rows.row(i)).collect();
        if !whole(values.as_flattened()) {
            return Err(Error::malformed(FORMAT, 20, format!("finite numbers in accessor {index}"), "others"));
        }
        Ok(values)
    }

    /// Numbers of vertices: unsigned integers of any size (glTF 2.0 §3.7.2.1).
    pub fn indices(&self, index: usize) -> Result<Vec<u32>> {
        let rows = self.rows(index, 1)?;
        let at = |i: usize| &rows.bytes[i * rows.stride..];
        Ok(match rows.component_type {
            5121 => (0..rows.count).map(|i| at(i)[0].into()).collect(),
            5123 => (0..rows.count).map(|i| u16::from_le_bytes([at(i)[0], at(i)[1]]).into()).collect(),
            5125 if rows.stride == 4 => {
                let words = rows.bytes[..4 * rows.count].chunks_exact(4);
                words.map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
            }
            5125 => {
                let word = |b: &[u8]| u32::from_le_bytes([b[0], b[1], b[2], b[3]]);
                (0..rows.count).map(|i| word(at(i))).collect()
            }
            other => {
                let expected = format!("unsigned integers in accessor {index}");
                return Err(Error::malformed(FORMAT, 20, expected, format!("component type {other}")));
            }
        })
    }
}

impl Rows<'_> {
    /// A row as floats: integers as they are, or as −1..1 and 0..1 where normalised (glTF 2.0 §3.6.2.2).
    #[inline]
    pub fn row<const N: usize>(&self, i: usize) -> [f32; N] {
        let row = &self.bytes[i * self.stride..];
        if self.component_type == FLOAT {
            let row = &row[..4 * N];
            return std::array::from_fn(|c| {
                f32::from_le_bytes([row[4 * c], row[4 * c + 1], row[4 * c + 2], row[4 * c + 3]])
            });
        }
        let size = size(self.component_type).unwrap_or(1);
        std::array::from_fn(|c| number(&row[c * size..(c + 1) * size], self.component_type, self.normalized) as f32)
    }
}

/// Bytes of a component.
fn size(component_type: u32) -> Result<usize> {
    match component_type {
        5120 | 5121 => Ok(1),
        5122 | 5123 => Ok(2),
        5125 | FLOAT => Ok(4),
        other => Err(Error::malformed(FORMAT, 20, "component type 5120 to 5126 without 5124", other.to_string())),
    }
}

fn number(cell: &[u8], kind: u32, normalized: bool) -> f64 {
    let (value, most) = match (kind, cell) {
        (5120, &[a]) => (f64::from(a as i8), 127.0),
        (5121, &[a]) => (f64::from(a), 255.0),
        (5122, &[a, b]) => (f64::from(i16::from_le_bytes([a, b])), 32_767.0),
        (5123, &[a, b]) => (f64::from(u16::from_le_bytes([a, b])), 65_535.0),
        (5125, &[a, b, c, d]) => (f64::from(u32::from_le_bytes([a, b, c, d])), 4_294_967_295.0),
        (_, &[a, b, c, d]) => return f64::from(f32::from_le_bytes([a, b, c, d])),
        _ => return 0.0,
    };
    if normalized { (value / most).max(-1.0) } else { value }
}
