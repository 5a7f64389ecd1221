//! Reads a model: faces over the vertex palette, and meshes with local pools.

use super::geometry::{PoolLayout, Transform, Vertex, mesh, primitive, triangulate, vertex};
use super::record::{Record, opcode};
use super::tree::{Node, Tree};
use super::{FORMAT, Level, Model, Point, header};
use crate::{Error, Result};
use std::collections::{BTreeSet, HashMap};

/// Faces and meshes that are not drawn (the hidden flag, bit 5).
pub const HIDDEN: u32 = 0x0400_0000;

/// Reads a model back.
///
/// What [`write`](super::write()) wrote comes back equal, with these exceptions: vertices that no triangle uses are
/// gone, identical vertices are one (so indices may differ), the vertices come in the palette's order, triangles with
/// two corners at one position are gone, texture coordinates of a level without texture are 0, and a level or root
/// without a name has its record's ID.
///
/// Of other files: polygons become fans, lengths metres, matrices are applied, missing normals computed. Geometry
/// outside any LOD record makes a level with all distances 0; an LOD with several textures makes a level for each; an
/// LOD without geometry of its own makes none. Hidden faces, colours, and external references are left out; all
/// children of a switch are kept; unknown records are skipped.
///
/// # Errors
/// [`Error::Malformed`] with the byte offset where the file breaks the format; [`Error::Unsupported`] for instances.
pub fn read(bytes: &[u8]) -> Result<Model> {
    let tree = Tree::of(bytes);
    if let Some(fault) = tree.faults.into_iter().next() {
        return Err(fault);
    }
    let tree = Tree { faults: Vec::new(), ..tree };
    let Some(head) = &tree.header else {
        return Err(malformed(0, "a header record".into(), "none".into()));
    };
    let head = header::read(head)?;
    let root = tree.nodes.iter().find(|n| n.parent.is_none() && n.record.opcode == opcode::GROUP);
    let comment = |record: Option<&Record>| record.map(|r| r.string(4));
    let mut textures = Vec::new();
    let mut patterns = HashMap::new();
    for record in tree.palettes.iter().filter(|r| r.opcode == opcode::TEXTURE) {
        patterns.entry(record.i32(204)?).or_insert(textures.len());
        textures.push(record.text(4, 200));
    }
    Ok(Model {
        name: root.map(Node::name).unwrap_or_default(),
        date: head.date,
        origin: head.origin,
        header_comment: comment(tree.palettes.iter().find(|r| r.opcode == opcode::COMMENT)),
        zone_comment: comment(root.and_then(|n| n.ancillary(opcode::COMMENT))),
        textures,
        levels: Geometry::of(&tree, &patterns)?.levels(head.metres)?,
        points: points(&tree, head.metres)?,
    })
}

/// Groups that have a comment, a matrix and nothing below them.
fn points(tree: &Tree, metres: f64) -> Result<Vec<Point>> {
    let parents: BTreeSet<usize> = tree.nodes.iter().filter_map(|n| n.parent).collect();
    let mut points = Vec::new();
    for (index, node) in tree.nodes.iter().enumerate() {
        let (Some(comment), Some(matrix)) = (node.ancillary(opcode::COMMENT), node.ancillary(opcode::MATRIX)) else {
            continue;
        };
        if node.record.opcode != opcode::GROUP || parents.contains(&index) {
            continue;
        }
        let mut point = Point { comment: comment.string(4), ..Point::default() };
        for (i, value) in point.matrix.iter_mut().flatten().enumerate() {
            *value = matrix.f32(4 + 4 * i)?;
        }
        point.matrix[3][..3].iter_mut().for_each(|x| *x = (f64::from(*x) * metres) as f32);
        points.push(point);
    }
    Ok(points)
}

/// What a node hands down to its children.
#[derive(Clone, Copy, Default)]
struct Context {
    /// The node index of the innermost LOD.
    lod: Option<usize>,
    /// Index into the list of transformations.
    transform: Option<usize>,
    /// Inside a face or mesh: its texture, an index into the model's; `None` outside or when hidden.
    surface: Option<Option<usize>>,
    /// Inside a mesh: its pool's first vertex and their number.
    pool: Option<(usize, usize)>,
}

/// All triangles, each corner a vertex under a transformation, sorted into batches of one LOD and texture.
struct Geometry<'a> {
    tree: &'a Tree<'a>,
    vertices: Vec<Vertex>,
    transforms: Vec<Transform>,
    contexts: Vec<Context>,
    batches: Vec<Batch>,
    batch_of: HashMap<(Option<usize>, Option<usize>), usize>,
}

struct Batch {
    lod: Option<usize>,
    texture: Option<usize>,
    triangles: Vec<[Corner; 3]>,
}

/// A vertex and the transformation that it is under, 0 for none.
type Corner = (u32, u32);

impl<'a> Geometry<'a> {
    fn of(tree: &'a Tree<'a>, patterns: &HashMap<i32, usize>) -> Result<Self> {
        let vertices = tree.vertices.iter().map(vertex).collect::<Result<_>>()?;
        let mut all = Self {
            tree,
            vertices,
            transforms: Vec::new(),
            contexts: Vec::with_capacity(tree.nodes.len()),
            batches: Vec::new(),
            batch_of: HashMap::new(),
        };
        let start = tree.vertex_palette.as_ref().map_or(0, |r| r.offset);
        for (index, node) in tree.nodes.iter().enumerate() {
            let mut context = node.parent.map(|p| all.contexts[p]).unwrap_or_default();
            if let Some(matrix) = node.ancillary(opcode::MATRIX) {
                let own = Transform::of(matrix)?;
                let whole = context.transform.map_or(own, |outer| own.then(&all.transforms[outer]));
                context.transform = Some(all.transforms.len());
                all.transforms.push(whole);
            }
            match node.record.opcode {
                opcode::LOD => context.lod = Some(index),
                opcode::FACE => context.surface = surface(&node.record, 28, 44, patterns)?,
                opcode::MESH => {
                    context.surface = surface(&node.record, 32, 48, patterns)?;
                    context.pool = node.ancillary(opcode::LOCAL_VERTEX_POOL).map(|r| all.add_pool(r)).transpose()?;
                }
                opcode::VERTEX_LIST => all.add_vertex_list(&node.record, &context, start)?,
                opcode::MESH_PRIMITIVE => all.add_primitive(&node.record, &context)?,
                opcode::INSTANCE_DEFINITION | opcode::INSTANCE_REFERENCE => {
                    let what = format!("the instance at byte {}; expand instances first", node.record.offset);
                    return Err(Error::Unsupported { format: FORMAT, what });
                }
                _ => {}
            }
            all.contexts.push(context);
        }
        Ok(all)
    }

    fn add_pool(&mut self, record: &Record) -> Result<(usize, usize)> {
        let layout = PoolLayout::of(record)?;
        let first = self.vertices.len();
        for index in 0..layout.count {
            self.vertices.push(layout.vertex(record, index)?);
        }
        Ok((first, layout.count))
    }

    fn add_vertex_list(&mut self, record: &Record, context: &Context, palette: usize) -> Result<()> {
        let Some(texture) = context.surface else { return Ok(()) };
        let count = (record.bytes.len() - 4) / 4;
        let mut polygon = Vec::with_capacity(count);
        for entry in 0..count {
            let at = 4 + entry * 4;
            let offset = record.u32(at)? as usize;
            let found = self.tree.vertices.binary_search_by_key(&palette.saturating_add(offset), |v| v.offset);
            polygon.push(found.map_err(|_| {
                let place = record.offset + at;
                malformed(place, "the palette offset of a vertex record".into(), offset.to_string())
            })?);
        }
        self.add(&polygon, 4, texture, context);
        Ok(())
    }

    fn add_primitive(&mut self, record: &Record, context: &Context) -> Result<()> {
        let (kind, mut corners) = primitive(record)?;
        let Some(texture) = context.surface else { return Ok(()) };
        let Some((first, count)) = context.pool else {
            return Err(malformed(record.offset, "a vertex pool before this primitive".into(), "none".into()));
        };
        if let Some(&index) = corners.iter().find(|&&i| i >= count) {
            return Err(malformed(record.offset, format!("indices below {count}"), index.to_string()));
        }
        corners.iter_mut().for_each(|c| *c += first);
        self.add(&corners, kind, texture, context);
        Ok(())
    }

    fn add(&mut self, corners: &[usize], kind: i16, texture: Option<usize>, context: &Context) {
        let mirrored = context.transform.is_some_and(|t| self.transforms[t].mirrors());
        let transform = context.transform.map_or(0, |t| t as u32 + 1);
        let batch = *self.batch_of.entry((context.lod, texture)).or_insert_with(|| {
            self.batches.push(Batch { lod: context.lod, texture, triangles: Vec::new() });
            self.batches.len() - 1
        });
        for triangle in triangulate(kind, corners.len()) {
            let [a, b, c] = triangle.map(|i| (corners[i] as u32, transform));
            if a != b && b != c && c != a {
                self.batches[batch].triangles.push(if mirrored { [a, c, b] } else { [a, b, c] });
            }
        }
    }

    /// The levels in file order, lengths in metres.
    fn levels(mut self, metres: f64) -> Result<Vec<Level>> {
        let mut batches = std::mem::take(&mut self.batches);
        batches.retain(|b| !b.triangles.is_empty());
        batches.sort_by_key(|b| b.lod);
        let mut levels: Vec<Level> = Vec::with_capacity(batches.len());
        let mut part = 1;
        for (index, batch) in batches.iter().enumerate() {
            let mut level = match batch.lod {
                Some(lod) => self.level(lod)?,
                None => Level::default(),
            };
            part = if index > 0 && batches[index - 1].lod == batch.lod { part + 1 } else { 1 };
            if part > 1 {
                level.name = format!("{}_{part}", level.name);
            }
            level.texture = batch.texture;
            level.mesh = self.mesh(&batch.triangles);
            scale(&mut level, metres);
            levels.push(level);
        }
        Ok(levels)
    }

    fn level(&self, lod: usize) -> Result<Level> {
        let record = &self.tree.nodes[lod].record;
        let center = record.vec3(40)?;
        Ok(Level {
            name: self.tree.nodes[lod].name(),
            switch_in: record.f64(16)?,
            switch_out: record.f64(24)?,
            center: self.contexts[lod].transform.map_or(center, |t| self.transforms[t].point(center)),
            // Absent before revision 15.8.
            transition: record.f64(64).unwrap_or(0.0),
            significant_size: record.f64(72).unwrap_or(0.0),
            ..Level::default()
        })
    }

    /// The used vertices in the palette's order.
    fn mesh(&self, triangles: &[[Corner; 3]]) -> crate::Mesh {
        let mut used: Vec<Corner> = triangles.iter().flatten().copied().collect();
        used.sort_unstable();
        used.dedup();
        let local = |corner: &Corner| used.partition_point(|c| c < corner) as u32;
        let indices = triangles.iter().map(|t| [local(&t[0]), local(&t[1]), local(&t[2])]).collect();
        let place = |&(v, t): &Corner| {
            let vertex = self.vertices[v as usize];
            if t == 0 { vertex } else { self.transforms[t as usize - 1].vertex(&vertex) }
        };
        let vertices: Vec<Vertex> = used.iter().map(place).collect();
        mesh(&vertices, indices)
    }
}

/// The texture of a face or mesh, from its fields at the given offsets; the outer `None` for a hidden one.
fn surface(
    record: &Record,
    texture: usize,
    flags: usize,
    patterns: &HashMap<i32, usize>,
) -> Result<Option<Option<usize>>> {
    if record.u32(flags)? & HIDDEN != 0 {
        return Ok(None);
    }
    let index = record.i16(texture)?;
    if index < 0 {
        return Ok(Some(None));
    }
    let found = patterns.get(&i32::from(index)).copied();
    let missing = || malformed(record.offset + texture, "the index of a texture record".into(), index.to_string());
    Ok(Some(Some(found.ok_or_else(missing)?)))
}

fn scale(level: &mut Level, metres: f64) {
    if metres == 1.0 {
        return;
    }
    for length in [&mut level.switch_in, &mut level.switch_out, &mut level.transition, &mut level.significant_size] {
        *length *= metres;
    }
    level.center.iter_mut().chain(level.mesh.positions.iter_mut().flatten()).for_each(|x| *x *= metres);
}

fn malformed(offset: usize, expected: String, found: String) -> Error {
    Error::Malformed { format: FORMAT, offset: offset as u64, expected, found }
}
