//! Palettes: colours, materials, textures and vertices.

use super::record::{Writer, opcode};
use super::{FORMAT, Level};
use crate::{Error, Mesh, Result};
use std::collections::HashMap;

/// The colour palette, all white: this writer gives packed colours, but readers look for the palette.
pub fn write_colors(out: &mut Writer) {
    out.begin(opcode::COLOR_PALETTE);
    out.zeros(128);
    out.bytes.resize(out.bytes.len() + 1024 * 4, 0xff);
    out.end();
}

/// A matt white material: what is shown is the texture and the light.
pub fn write_material(out: &mut Writer, index: i32, name: &str) {
    out.begin(opcode::MATERIAL);
    out.i32(index);
    out.text(name, 12);
    out.u32(0x8000_0000); // used
    out.f32s(&[1.0; 3]); // ambient
    out.f32s(&[1.0; 3]); // diffuse
    out.f32s(&[0.0; 3]); // specular
    out.f32s(&[0.0; 3]); // emissive
    out.f32s(&[0.0, 1.0]); // shininess, alpha
    out.zeros(4);
    out.end();
}

pub fn write_texture(out: &mut Writer, index: i32, path: &str) {
    out.begin(opcode::TEXTURE);
    out.text(path, 200);
    out.i32(index);
    out.zeros(8); // place in the palette window
    out.end();
}

/// The vertex palette while it is written: identical vertices, of any level, share one record.
pub struct VertexPalette {
    start: usize,
    known: HashMap<[u64; 6], i32>,
}

impl VertexPalette {
    pub fn begin(out: &mut Writer) -> Self {
        let start = out.bytes.len();
        out.begin(opcode::VERTEX_PALETTE);
        out.i32(0); // set by `end`
        out.end();
        Self { start, known: HashMap::new() }
    }

    /// Adds the vertices that a level's triangles use. The result has each vertex's offset in the palette, 0 for unused
    /// ones (no vertex begins there).
    pub fn add(
        &mut self,
        out: &mut Writer,
        level: &Level,
        triangles: impl Iterator<Item = [u32; 3]>,
    ) -> Result<Vec<i32>> {
        let mesh = &level.mesh;
        let mut offsets = vec![0; mesh.positions.len()];
        triangles.flatten().for_each(|v| offsets[v as usize] = 1);
        for (v, offset) in offsets.iter_mut().enumerate().filter(|(_, used)| **used != 0) {
            let (p, n) = (mesh.positions[v], mesh.normals[v]);
            let uv = level.texture.map(|_| mesh.uvs[v]);
            let next = out.bytes.len() - self.start;
            *offset = *self.known.entry(key(p, n, uv)).or_insert_with(|| {
                write_vertex(out, p, n, uv);
                i32::try_from(next).unwrap_or(i32::MAX) // `end` refuses such a palette
            });
        }
        Ok(offsets)
    }

    /// Sets the palette's length.
    pub fn end(self, out: &mut Writer) -> Result<()> {
        let length = out.bytes.len() - self.start;
        let Ok(stored) = i32::try_from(length) else {
            let what = format!("the vertices need {length} bytes, a palette holds 2 GiB; simplify the mesh");
            return Err(Error::Unsupported { format: FORMAT, what });
        };
        out.bytes[self.start + 4..self.start + 8].copy_from_slice(&stored.to_be_bytes());
        Ok(())
    }
}

/// The bits that tell two vertices apart: −0 and 0 differ, so what is read back is what was written.
fn key(p: [f64; 3], n: [f32; 3], uv: Option<[f32; 2]>) -> [u64; 6] {
    let pair = |a: f32, b: f32| u64::from(a.to_bits()) << 32 | u64::from(b.to_bits());
    let [u, v] = uv.unwrap_or_default();
    let kind = u64::from(uv.is_some()) << 32;
    [p[0].to_bits(), p[1].to_bits(), p[2].to_bits(), pair(n[0], n[1]), pair(n[2], u), kind | u64::from(v.to_bits())]
}

fn write_vertex(out: &mut Writer, position: [f64; 3], normal: [f32; 3], uv: Option<[f32; 2]>) {
    out.begin(if uv.is_some() { opcode::VERTEX_CNUV } else { opcode::VERTEX_CN });
    out.u16(0xffff); // no colour name
    out.u16(0x1000); // packed colour
    out.f64s(&position);
    out.f32s(&normal);
    uv.iter().for_each(|uv| out.f32s(uv));
    out.u32(0xffff_ffff); // white
    out.u32(0xffff_ffff); // no colour index
    out.zeros(4);
    out.end();
}

/// A vertex of a local pool: position, packed white, normal, texture coordinates where textured.
pub fn written_vertex(out: &mut Writer, mesh: &Mesh, v: usize, textured: bool) {
    out.f64s(&mesh.positions[v]);
    out.u32(0xffff_ffff);
    out.f32s(&mesh.normals[v]);
    if textured {
        out.f32s(&mesh.uvs[v]);
    }
}
