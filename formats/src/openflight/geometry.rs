//! Geometry in files: vertices, vertex lists, mesh primitives, transformations.

use super::FORMAT;
use super::record::{Record, opcode};
use crate::mesh::{cross, dot, smooth_normals, unit};
use crate::{Error, Mesh, Result};

/// A vertex as stored; records 68 and 71 and some pools have no normal.
#[derive(Clone, Copy, Debug)]
pub struct Vertex {
    pub position: [f64; 3],
    pub normal: Option<[f32; 3]>,
    pub uv: [f32; 2],
}

/// Reads a vertex record of the palette (68–71).
pub fn vertex(record: &Record) -> Result<Vertex> {
    let position = record.vec3(8)?;
    let (normal, uv) = match record.opcode {
        opcode::VERTEX_CN => (Some(record.vec3_f32(32)?), None),
        opcode::VERTEX_CNUV => (Some(record.vec3_f32(32)?), Some(record.vec2_f32(44)?)),
        opcode::VERTEX_CUV => (None, Some(record.vec2_f32(32)?)),
        _ => (None, None),
    };
    Ok(Vertex { position, normal, uv: uv.unwrap_or_default() })
}

/// Where the attributes of a local vertex pool lie within one vertex.
pub struct PoolLayout {
    pub count: usize,
    pub stride: usize,
    normal: Option<usize>,
    uv: Option<usize>,
}

impl PoolLayout {
    /// Offset of the first vertex in the record.
    pub const DATA: usize = 12;

    pub fn of(record: &Record) -> Result<Self> {
        let count = record.u32(4)? as usize;
        let mask = record.u32(8)?;
        let has = |bit: u32| mask & (0x8000_0000 >> bit) != 0;
        let malformed = |expected: &str, found: String| {
            let (offset, expected) = (record.offset as u64, expected.into());
            Err(Error::Malformed { format: FORMAT, offset, expected, found })
        };
        if !has(0) {
            return malformed("a vertex pool with positions", format!("attribute mask {mask:#010x}"));
        }
        let mut stride = 24;
        let mut field = |present: bool, size: usize| {
            let at = stride;
            stride += if present { size } else { 0 };
            present.then_some(at)
        };
        field(has(1) || has(2), 4); // colour
        let normal = field(has(3), 12);
        let uv = field(has(4), 8);
        for layer in 5..12 {
            field(has(layer), 8);
        }
        let room = record.bytes.len().saturating_sub(Self::DATA);
        if count > room / stride {
            return malformed("room for the pool's vertices", format!("{count} of {stride} bytes in {room} bytes"));
        }
        Ok(Self { count, stride, normal, uv })
    }

    pub fn vertex(&self, record: &Record, index: usize) -> Result<Vertex> {
        let at = Self::DATA + index * self.stride;
        Ok(Vertex {
            position: record.vec3(at)?,
            normal: self.normal.map(|n| record.vec3_f32(at + n)).transpose()?,
            uv: self.uv.map(|uv| record.vec2_f32(at + uv)).transpose()?.unwrap_or_default(),
        })
    }
}

/// The indices of a mesh primitive (86) and its type.
pub fn primitive(record: &Record) -> Result<(i16, Vec<usize>)> {
    let kind = record.i16(4)?;
    let size = usize::from(record.u16(6)?);
    let count = record.u32(8)? as usize;
    let data = record.bytes.get(12..).unwrap_or_default();
    let malformed = |expected: &str, found: String| {
        let (offset, expected) = (record.offset as u64, expected.into());
        Err(Error::Malformed { format: FORMAT, offset, expected, found })
    };
    if !matches!(size, 1 | 2 | 4) {
        return malformed("indices of 1, 2 or 4 bytes", size.to_string());
    }
    if !(1..=4).contains(&kind) {
        return malformed("mesh primitive type 1 to 4", kind.to_string());
    }
    if count > data.len() / size {
        return malformed("room for the primitive's indices", format!("{count} of {size} bytes in {}", data.len()));
    }
    let index = |bytes: &[u8]| bytes.iter().fold(0, |value, &b| value << 8 | usize::from(b));
    Ok((kind, data.chunks_exact(size).take(count).map(index).collect()))
}

/// The triangles of a primitive of `count` corners, as corner numbers: a polygon or fan from its first corner, strips
/// with every other triangle turned.
pub fn triangulate(kind: i16, count: usize) -> Vec<[usize; 3]> {
    match kind {
        1 => (2..count).map(|i| if i % 2 == 0 { [i - 2, i - 1, i] } else { [i - 1, i - 2, i] }).collect(),
        3 => (3..count).step_by(2).flat_map(|i| [[i - 3, i - 2, i], [i - 3, i, i - 1]]).collect(),
        _ => (2..count).map(|i| [0, i - 1, i]).collect(),
    }
}

/// A transformation in OpenFlight's order: rows, vectors from the left, translation in the last row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform(pub [[f64; 3]; 4]);

impl Transform {
    pub fn of(record: &Record) -> Result<Self> {
        let mut m = [[0.0; 3]; 4];
        for (r, row) in m.iter_mut().enumerate() {
            *row = record.vec3_f32(4 + r * 16)?.map(f64::from);
        }
        Ok(Self(m))
    }

    /// This one first, then `outer`.
    pub fn then(&self, outer: &Self) -> Self {
        let [x, y, z, t] = self.0;
        Self([outer.vector(x), outer.vector(y), outer.vector(z), outer.point(t)])
    }

    pub fn point(&self, p: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|c| self.vector(p)[c] + self.0[3][c])
    }

    fn vector(&self, p: [f64; 3]) -> [f64; 3] {
        let m = &self.0;
        std::array::from_fn(|c| p[0] * m[0][c] + p[1] * m[1][c] + p[2] * m[2][c])
    }

    /// Normals go through the cofactors (the inverse transpose up to its determinant).
    fn normal(&self, n: [f32; 3]) -> [f32; 3] {
        let [x, y, z, _] = self.0;
        let n = n.map(f64::from);
        let cofactors = [cross(y, z), cross(z, x), cross(x, y)];
        let sign = if self.mirrors() { -1.0 } else { 1.0 };
        unit(std::array::from_fn(|c| sign * (n[0] * cofactors[0][c] + n[1] * cofactors[1][c] + n[2] * cofactors[2][c])))
    }

    /// Whether it turns counter-clockwise into clockwise.
    pub fn mirrors(&self) -> bool {
        let [x, y, z, _] = self.0;
        dot(cross(x, y), z) < 0.0
    }

    pub fn vertex(&self, v: &Vertex) -> Vertex {
        Vertex { position: self.point(v.position), normal: v.normal.map(|n| self.normal(n)), uv: v.uv }
    }
}

/// Makes a mesh of vertices and triangles; vertices without a normal get the area-weighted mean of their triangles'.
pub fn mesh(vertices: &[Vertex], triangles: Vec<[u32; 3]>) -> Mesh {
    let positions: Vec<[f64; 3]> = vertices.iter().map(|v| v.position).collect();
    let smooth =
        if vertices.iter().any(|v| v.normal.is_none()) { smooth_normals(&positions, &triangles) } else { Vec::new() };
    Mesh {
        normals: vertices.iter().enumerate().map(|(i, v)| v.normal.unwrap_or_else(|| smooth[i])).collect(),
        uvs: vertices.iter().map(|v| v.uv).collect(),
        positions,
        triangles,
    }
}
