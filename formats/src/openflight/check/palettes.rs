//! Palettes: indices, texture paths, vertices.

use super::{Findings, check_text, near};
use crate::mesh::dot;
use crate::openflight::geometry::{Vertex, vertex};
use crate::openflight::record::opcode;
use crate::openflight::tree::Tree;
use std::collections::BTreeSet;

/// The indices that surfaces may use.
pub struct Palettes {
    pub textures: BTreeSet<i32>,
    pub materials: BTreeSet<i32>,
}

pub fn check(tree: &Tree, findings: &mut Findings) -> Palettes {
    let mut palettes = Palettes { textures: BTreeSet::new(), materials: BTreeSet::new() };
    for record in &tree.palettes {
        let (known, index) = match record.opcode {
            opcode::TEXTURE => (&mut palettes.textures, record.i32(204)),
            opcode::MATERIAL => (&mut palettes.materials, record.i32(4)),
            _ => continue,
        };
        match index {
            Ok(index) if !known.insert(index) => {
                findings.at(record.offset, format!("palette index {index} is used twice"));
            }
            Ok(_) => {}
            Err(error) => findings.error(&error),
        }
        if record.opcode == opcode::MATERIAL {
            check_text(record, 8, 12, "material name", findings);
            continue;
        }
        check_text(record, 4, 200, "texture path", findings);
        let path = record.text(4, 200);
        if path.is_empty() || path.starts_with('/') || path.contains(':') {
            findings.at(record.offset + 4, format!("the texture path {path:?} is not relative"));
        }
        if path.contains('\\') {
            findings.at(record.offset + 4, format!("the texture path {path:?} has backslashes instead of /"));
        }
    }
    palettes
}

/// The palette's vertices in file order with their offsets in the file.
pub fn check_vertices(tree: &Tree, findings: &mut Findings) -> Vec<(usize, Vertex)> {
    if let Some(palette) = &tree.vertex_palette {
        let end = tree.vertices.last().map_or(palette.offset + palette.bytes.len(), |v| v.offset + v.bytes.len());
        match palette.i32(4) {
            Ok(length) if usize::try_from(length) != Ok(end - palette.offset) => {
                let real = end - palette.offset;
                findings.at(palette.offset + 4, format!("the vertex palette says {length} bytes but has {real}"));
            }
            Ok(_) => {}
            Err(error) => findings.error(&error),
        }
    }
    let mut vertices = Vec::with_capacity(tree.vertices.len());
    for record in &tree.vertices {
        match vertex(record) {
            Ok(vertex) => {
                check_vertex(record.offset, &vertex, findings);
                vertices.push((record.offset, vertex));
            }
            Err(error) => findings.error(&error),
        }
    }
    vertices
}

pub fn check_vertex(offset: usize, vertex: &Vertex, findings: &mut Findings) {
    let finite = vertex.position.iter().all(|x| x.is_finite()) && vertex.uv.iter().all(|x| x.is_finite());
    if !finite {
        findings.at(offset, "a vertex has a number that is not finite".into());
    }
    if let Some(n) = vertex.normal {
        let length = dot(n.map(f64::from), n.map(f64::from)).sqrt();
        if !near(length, 1.0, 1e-3) {
            findings.at(offset, format!("a normal has length {length} instead of 1"));
        }
    }
}
