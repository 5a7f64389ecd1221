//! Geometry as mesh records: a pool of vertices and its triangles, a fifth of the size of faces.

use super::palette::written_vertex;
use super::record::{Writer, opcode};
use super::write::{drawn, id, surface_tail, write_id, write_long_id};
use super::{FORMAT, Level};
use crate::{Error, Result};

/// The longest record, a multiple of 4.
const LONGEST: usize = 65532;
/// Position, packed colour, normal; and texture coordinates.
const PLAIN: u32 = 0xb000_0000;
const TEXTURED: u32 = 0xb800_0000;
/// A primitive that is a polygon with indices.
const POLYGON: i16 = 4;

/// Writes a level's triangles as one mesh node with its pool and primitives.
///
/// # Errors
/// [`Error::Unsupported`] for more vertices than a pool counts.
pub fn write(out: &mut Writer, level: &Level, number: usize) -> Result<()> {
    let id = id('m', number);
    out.begin(opcode::MESH);
    write_id(out, &id);
    out.zeros(4);
    surface_tail(out, level.texture.map_or(-1, |t| t as i16));
    out.end();
    write_long_id(out, &id, "");
    let used = used(level);
    write_pool(out, level, &used)?;
    out.control(opcode::PUSH);
    let index = |v: u32| used.partition_point(|u| *u < v);
    let size: u16 = match used.len() {
        0..=0x100 => 1,
        0x101..=0x1_0000 => 2,
        _ => 4,
    };
    for triangle in drawn(level) {
        out.begin(opcode::MESH_PRIMITIVE);
        out.i16(POLYGON);
        out.u16(size);
        out.u32(3);
        for i in triangle.map(index) {
            match size {
                1 => out.u8(i as u8),
                2 => out.u16(i as u16),
                _ => out.u32(i as u32),
            }
        }
        out.end();
    }
    out.control(opcode::POP);
    Ok(())
}

/// The vertices that triangles use, in order.
fn used(level: &Level) -> Vec<u32> {
    let mut used: Vec<u32> = drawn(level).flatten().collect();
    used.sort_unstable();
    used.dedup();
    used
}

/// The pool, continued where it is longer than a record: every piece ends with a whole vertex.
fn write_pool(out: &mut Writer, level: &Level, used: &[u32]) -> Result<()> {
    let Ok(count) = u32::try_from(used.len()) else {
        return Err(Error::unsupported(FORMAT, format!("{} vertices in one pool", used.len())));
    };
    let textured = level.texture.is_some();
    let stride = if textured { 48 } else { 40 };
    let first = (LONGEST - 12) / stride;
    let (head, tail) = used.split_at(first.min(used.len()));
    out.begin(opcode::LOCAL_VERTEX_POOL);
    out.u32(count);
    out.u32(if textured { TEXTURED } else { PLAIN });
    head.iter().for_each(|v| written_vertex(out, &level.mesh, *v as usize, textured));
    out.end();
    for piece in tail.chunks((LONGEST - 4) / stride) {
        out.begin(opcode::CONTINUATION);
        piece.iter().for_each(|v| written_vertex(out, &level.mesh, *v as usize, textured));
        out.end();
    }
    Ok(())
}
