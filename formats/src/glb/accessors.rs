//! Typed access to the binary chunk: nothing is made room for that is not there.

use super::FORMAT;
use super::json::{Accessor, Primitive, Root};
use super::read::missing;
use crate::{Error, Result};

/// Typed access to the binary chunk.
pub struct Accessors<'a> {
    pub root: &'a Root,
    pub bin: &'a [u8],
}

impl Accessors<'_> {
    pub fn view(&self, index: usize) -> Result<(&[u8], Option<usize>)> {
        let view = self.root.buffer_views.get(index).ok_or_else(|| missing("buffer view", index))?;
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

    fn accessor(&self, index: usize) -> Result<&Accessor> {
        self.root.accessors.get(index).ok_or_else(|| missing("accessor", index))
    }

    /// Vertices of a primitive, at most its corners.
    pub fn vertices(&self, primitive: &Primitive) -> Result<usize> {
        let count = |index: &usize| self.accessor(*index).map(|a| a.count);
        let positions = primitive.attributes.get("POSITION").map(count).transpose()?.unwrap_or(0);
        let corners = primitive.indices.as_ref().map(count).transpose()?.unwrap_or(0);
        Ok(positions.max(corners / 3))
    }

    /// Every component, row by row; integers as they are, or as −1..1 and 0..1 where normalised (glTF 2.0 §3.6.2.2).
    pub fn values(&self, index: usize, width: usize) -> Result<Vec<f64>> {
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
        let size = match accessor.component_type {
            5120 | 5121 => 1,
            5122 | 5123 => 2,
            5125 | 5126 => 4,
            other => {
                return Err(Error::malformed(
                    FORMAT,
                    20,
                    "component type 5120 to 5126 without 5124",
                    other.to_string(),
                ));
            }
        };
        let (bytes, stride) = self.view(view)?;
        let row = size * stored;
        let stride = stride.unwrap_or(row);
        let room = bytes.len().checked_sub(accessor.byte_offset);
        let needed = accessor.count.checked_sub(1).map(|n| n.checked_mul(stride).and_then(|n| n.checked_add(row)));
        let fits = match (room, needed) {
            (Some(_), None) => true,
            (Some(room), Some(Some(needed))) => needed <= room,
            _ => false,
        };
        if stride < row || !fits {
            let expected = format!("accessor {index} inside its view of {} bytes", bytes.len());
            let found = format!("{} rows of {row} every {stride} from {}", accessor.count, accessor.byte_offset);
            return Err(Error::malformed(FORMAT, 20, expected, found));
        }
        let mut out = Vec::with_capacity(accessor.count * width);
        for i in 0..accessor.count {
            let at = accessor.byte_offset + i * stride;
            for cell in bytes[at..at + size * width].chunks_exact(size) {
                out.push(number(cell, accessor.component_type, accessor.normalized));
            }
        }
        Ok(out)
    }

    /// Rows of finite floats.
    pub fn vectors<const N: usize>(&self, index: usize) -> Result<Vec<[f32; N]>> {
        let values = self.values(index, N)?;
        if values.iter().any(|v| !(*v as f32).is_finite()) {
            return Err(Error::malformed(FORMAT, 20, format!("finite numbers in accessor {index}"), "others"));
        }
        Ok(values.chunks_exact(N).map(|row| std::array::from_fn(|i| row[i] as f32)).collect())
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
