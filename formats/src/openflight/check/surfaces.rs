//! Faces, meshes and the boxes around them.

use super::palettes::{Palettes, check_vertex};
use super::{Findings, check_text};
use crate::mesh::{dot, face_normal};
use crate::openflight::geometry::{PoolLayout, Vertex, primitive, triangulate};
use crate::openflight::header::union;
use crate::openflight::record::{Record, opcode};
use crate::openflight::tree::{Node, Tree};
use std::collections::BTreeMap;

pub type Box3 = ([f64; 3], [f64; 3]);

/// Checks faces, meshes and what they draw; gives the box of the geometry right below each node.
pub fn check(
    tree: &Tree,
    palettes: &Palettes,
    vertices: &[(usize, Vertex)],
    findings: &mut Findings,
) -> Vec<Option<Box3>> {
    let mut boxes = vec![None; tree.nodes.len()];
    let mut pools: BTreeMap<usize, Vec<Vertex>> = BTreeMap::new();
    let mut winding = Winding::default();
    for (index, node) in tree.nodes.iter().enumerate() {
        let record = &node.record;
        match record.opcode {
            opcode::FACE => check_surface(record, [28, 30], palettes, findings),
            opcode::MESH => {
                check_surface(record, [32, 34], palettes, findings);
                if let Some(pool) = check_pool(node, findings) {
                    pools.insert(index, pool);
                }
            }
            opcode::VERTEX_LIST => {
                let start = tree.vertex_palette.as_ref().map_or(0, |p| p.offset);
                let corners = palette_corners(record, start, vertices, findings);
                if let Some(corners) = corners {
                    boxes[index] = check_polygon(record, &corners, 4, &mut winding, findings);
                }
            }
            opcode::MESH_PRIMITIVE => {
                let pool = node.parent.and_then(|p| pools.get(&p)).map_or(&[][..], Vec::as_slice);
                match primitive(record) {
                    Ok((kind, indices)) => {
                        if let Some(bad) = indices.iter().find(|&&i| i >= pool.len()) {
                            let what = format!("index {bad} exceeds the pool of {} vertices", pool.len());
                            findings.at(record.offset + 12, what);
                        } else {
                            let corners: Vec<Vertex> = indices.iter().map(|&i| pool[i]).collect();
                            boxes[index] = check_polygon(record, &corners, kind, &mut winding, findings);
                        }
                    }
                    Err(error) => findings.error(&error),
                }
            }
            _ => {}
        }
    }
    if let Some(first) = winding.first {
        let what = "triangles are wound against their vertices' normals, the first one here";
        findings.at(first, format!("{} of {} {what}", winding.against, winding.all));
    }
    boxes
}

/// How many triangles turn their backs to their own normals.
#[derive(Default)]
struct Winding {
    all: usize,
    against: usize,
    first: Option<usize>,
}

/// Texture and material index of a face or mesh, at the given offsets.
fn check_surface(record: &Record, [texture, material]: [usize; 2], palettes: &Palettes, findings: &mut Findings) {
    check_text(record, 4, 8, "ID", findings);
    for (at, what, known) in [(texture, "texture", &palettes.textures), (material, "material", &palettes.materials)] {
        match record.i16(at) {
            Ok(index) if index >= 0 && !known.contains(&i32::from(index)) => {
                findings.at(record.offset + at, format!("the palettes have no {what} {index}"));
            }
            Ok(_) => {}
            Err(error) => findings.error(&error),
        }
    }
}

fn check_pool(node: &Node, findings: &mut Findings) -> Option<Vec<Vertex>> {
    let Some(record) = node.ancillary(opcode::LOCAL_VERTEX_POOL) else {
        findings.at(node.record.offset, "a mesh has no local vertex pool".into());
        return None;
    };
    let layout = PoolLayout::of(record).map_err(|error| findings.error(&error)).ok()?;
    let (body, needed) = (record.bytes.len() - PoolLayout::DATA, layout.count * layout.stride);
    if body != needed {
        findings.at(record.offset, format!("the vertex pool has {body} bytes of vertices instead of {needed}"));
    }
    let mut pool = Vec::with_capacity(layout.count);
    for index in 0..layout.count {
        let vertex = layout.vertex(record, index).ok()?;
        check_vertex(record.offset, &vertex, findings);
        pool.push(vertex);
    }
    Some(pool)
}

/// The vertices that a vertex list names, `None` after a finding.
fn palette_corners(
    record: &Record,
    start: usize,
    vertices: &[(usize, Vertex)],
    findings: &mut Findings,
) -> Option<Vec<Vertex>> {
    let mut corners = Vec::new();
    for at in (4..record.bytes.len().saturating_sub(3)).step_by(4) {
        let offset = record.u32(at).ok()? as usize;
        let Ok(found) = vertices.binary_search_by_key(&start.saturating_add(offset), |(o, _)| *o) else {
            findings.at(record.offset + at, format!("no vertex record begins at palette offset {offset}"));
            return None;
        };
        corners.push(vertices[found].1);
    }
    Some(corners)
}

fn check_polygon(
    record: &Record,
    corners: &[Vertex],
    kind: i16,
    winding: &mut Winding,
    findings: &mut Findings,
) -> Option<Box3> {
    if corners.len() < 3 {
        findings.at(record.offset, format!("a polygon has {} corners instead of at least 3", corners.len()));
    }
    for triangle in triangulate(kind, corners.len()) {
        let [a, b, c] = triangle.map(|i| corners[i]);
        let positions = [a.position, b.position, c.position];
        if positions[0] == positions[1] || positions[1] == positions[2] || positions[2] == positions[0] {
            // Strips turn corners with such triangles.
            if kind == 4 {
                findings.at(record.offset, "a polygon has two corners at one position".into());
            }
            continue;
        }
        if let (Some(a), Some(b), Some(c)) = (a.normal, b.normal, c.normal) {
            let sum = std::array::from_fn(|i| f64::from(a[i]) + f64::from(b[i]) + f64::from(c[i]));
            winding.all += 1;
            if dot(face_normal(positions), sum) < 0.0 {
                winding.against += 1;
                winding.first.get_or_insert(record.offset);
            }
        }
    }
    corners.iter().map(|v| (v.position, v.position)).reduce(union)
}

/// Whether each bounding box holds the geometry below its group; not judged below matrices.
pub fn check_boxes(tree: &Tree, mut boxes: Vec<Option<Box3>>, findings: &mut Findings) {
    let mut moved = vec![false; tree.nodes.len()];
    for (index, node) in tree.nodes.iter().enumerate().rev() {
        moved[index] |= node.ancillary(opcode::MATRIX).is_some();
        if let (Some(stored), Some((lo, hi)), false) =
            (node.ancillary(opcode::BOUNDING_BOX), boxes[index], moved[index])
        {
            let (Ok(low), Ok(high)) = (stored.vec3(8), stored.vec3(32)) else {
                findings.at(stored.offset, "a bounding box is too short".into());
                continue;
            };
            let slack = 1e-9 * (0..3).map(|a| (hi[a] - lo[a]).abs()).fold(0.0, f64::max);
            // Also true of NaN.
            if !(0..3).all(|a| low[a] <= lo[a] + slack && high[a] >= hi[a] - slack) {
                findings.at(
                    stored.offset,
                    format!("the bounding box {low:?} to {high:?} does not hold the geometry {lo:?} to {hi:?}"),
                );
            }
        }
        if let Some(parent) = node.parent {
            moved[parent] |= moved[index];
            boxes[parent] = boxes[parent].into_iter().chain(boxes[index]).reduce(union);
        }
    }
}
