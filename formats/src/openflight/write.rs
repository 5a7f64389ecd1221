//! Writes a model as faces over a vertex palette: the geometry that every tested reader shows.

use super::header::{Header, union};
use super::palette::{self, VertexPalette};
use super::record::{Writer, opcode};
use super::{FORMAT, Geometry, Level, Model, Point, mesh};
use crate::{Error, Result};

/// The longest text of a comment or long ID: a record of 65532 bytes less its header and NUL.
pub const MAX_STRING: usize = 65527;

/// Writes a model as OpenFlight 16.0.
///
/// Triangles are faces with packed white vertex colours, lit by material 0, vertices shared through one palette. Those
/// with two corners at one position cover nothing and are left out.
///
/// # Errors
/// [`Error::Unsupported`] for what the format cannot hold: text that is not ASCII or too long, a texture path that is
/// absolute or has backslashes, two names alike, a mesh that is not valid or has no triangle, numbers that are not
/// finite, a level whose far limit is not beyond its near limit, a vertex palette over 2 GiB.
pub fn write(model: &Model) -> Result<Vec<u8>> {
    write_as(model, Geometry::Faces)
}

/// Writes a model as [`write`] does, its triangles in the records that are asked for.
///
/// # Errors
/// As [`write`].
pub fn write_as(model: &Model, geometry: Geometry) -> Result<Vec<u8>> {
    let faces = model.levels.iter().map(|l| drawn(l).count()).sum();
    match geometry {
        Geometry::Faces => write_with(model, &Header::of(model, faces), faces),
        Geometry::Meshes => write_meshes(model, faces),
    }
}

fn write_meshes(model: &Model, faces: usize) -> Result<Vec<u8>> {
    validate(model, 0)?;
    let corners: usize = model.levels.iter().map(|l| l.mesh.positions.len()).sum();
    let mut out = Writer::with_capacity(6000 + 216 * model.textures.len() + 48 * corners + 24 * faces);
    write_palettes(&mut out, model, &Header::of_meshes(model));
    out.control(opcode::PUSH);
    write_group(&mut out, model);
    out.control(opcode::PUSH);
    for (index, level) in model.levels.iter().enumerate() {
        write_lod(&mut out, level, index + 1);
        out.control(opcode::PUSH);
        write_object(&mut out, index + 1);
        out.control(opcode::PUSH);
        mesh::write(&mut out, level, index + 1)?;
        out.control(opcode::POP);
        out.control(opcode::POP);
    }
    write_points(&mut out, &model.points);
    out.control(opcode::POP);
    out.control(opcode::POP);
    Ok(out.bytes)
}

/// Everything before the vertices.
fn write_palettes(out: &mut Writer, model: &Model, header: &Header) {
    header.write(out);
    if let Some(comment) = &model.header_comment {
        out.string_record(opcode::COMMENT, comment);
    }
    palette::write_colors(out);
    palette::write_material(out, 0, "mat0");
    for (index, path) in model.textures.iter().enumerate() {
        palette::write_texture(out, index as i32, path);
    }
}

/// Writes a model under a given header.
pub fn write_with(model: &Model, header: &Header, faces: usize) -> Result<Vec<u8>> {
    validate(model, faces)?;
    let corners: usize = model.levels.iter().map(|l| l.mesh.positions.len()).sum();
    let mut out = Writer::with_capacity(6000 + 216 * model.textures.len() + 64 * corners + 104 * faces);
    write_palettes(&mut out, model, header);
    let mut vertices = VertexPalette::begin(&mut out);
    let mut offsets = Vec::with_capacity(model.levels.len());
    for level in &model.levels {
        offsets.push(vertices.add(&mut out, level, drawn(level))?);
    }
    vertices.end(&mut out)?;

    out.control(opcode::PUSH);
    write_group(&mut out, model);
    out.control(opcode::PUSH);
    let mut face = 1;
    for (index, level) in model.levels.iter().enumerate() {
        write_lod(&mut out, level, index + 1);
        out.control(opcode::PUSH);
        write_object(&mut out, index + 1);
        out.control(opcode::PUSH);
        let texture = level.texture.map_or(-1, |t| t as i16);
        for triangle in drawn(level) {
            write_face(&mut out, face, texture);
            out.control(opcode::PUSH);
            out.begin(opcode::VERTEX_LIST);
            triangle.iter().for_each(|&v| out.i32(offsets[index][v as usize]));
            out.end();
            out.control(opcode::POP);
            face += 1;
        }
        out.control(opcode::POP);
        out.control(opcode::POP);
    }
    write_points(&mut out, &model.points);
    out.control(opcode::POP);
    out.control(opcode::POP);
    Ok(out.bytes)
}

/// The triangles of a level whose corners lie at three positions.
pub fn drawn(level: &Level) -> impl Iterator<Item = [u32; 3]> {
    let at = |v: u32| level.mesh.positions.get(v as usize);
    level.mesh.triangles.iter().copied().filter(move |&[a, b, c]| at(a) != at(b) && at(b) != at(c) && at(c) != at(a))
}

/// Node IDs: a letter and a number, seven characters at most.
pub fn id(letter: char, number: usize) -> String {
    format!("{letter}{number}")
}

/// The ID field, cut to the seven characters it holds.
pub fn write_id(out: &mut Writer, id: &str) {
    out.text(&id[..id.len().min(7)], 8);
}

/// The long ID that must follow when the name is another than the ID, or the ID was cut.
pub fn write_long_id(out: &mut Writer, id: &str, name: &str) {
    if !name.is_empty() && name != id {
        out.string_record(opcode::LONG_ID, name);
    } else if id.len() > 7 {
        out.string_record(opcode::LONG_ID, id);
    }
}

fn write_group(out: &mut Writer, model: &Model) {
    let bounds = model.levels.iter().filter_map(|l| l.mesh.bounds()).reduce(union).unwrap_or_default();
    write_zone(out, &model.name, model.zone_comment.as_deref(), bounds);
}

/// The root group with its name, comment and box.
pub fn write_zone(out: &mut Writer, name: &str, comment: Option<&str>, (lo, hi): ([f64; 3], [f64; 3])) {
    let id = id('g', 1);
    write_group_record(out, &id);
    write_long_id(out, &id, name);
    if let Some(comment) = comment {
        out.string_record(opcode::COMMENT, comment);
    }
    out.begin(opcode::BOUNDING_BOX);
    out.zeros(4);
    out.f64s(&lo);
    out.f64s(&hi);
    out.end();
}

fn write_group_record(out: &mut Writer, id: &str) {
    out.begin(opcode::GROUP);
    write_id(out, id);
    out.zeros(32); // priority, flags, effects, significance, layer and animation: all none
    out.end();
}

fn write_points(out: &mut Writer, points: &[Point]) {
    for (index, point) in points.iter().enumerate() {
        // The root has the first number.
        write_group_record(out, &id('g', index + 2));
        out.begin(opcode::MATRIX);
        point.matrix.iter().for_each(|row| out.f32s(row));
        out.end();
        out.string_record(opcode::COMMENT, &point.comment);
    }
}

fn write_lod(out: &mut Writer, level: &Level, number: usize) {
    let range = [level.switch_in, level.switch_out, level.transition, level.significant_size];
    write_lod_record(out, &level.name, number, range, &level.center);
}

/// A LOD record: switch-in, switch-out, transition and significant size, metres.
pub fn write_lod_record(out: &mut Writer, name: &str, number: usize, range: [f64; 4], center: &[f64; 3]) {
    let id = id('l', number);
    let [switch_in, switch_out, transition, significant_size] = range;
    out.begin(opcode::LOD);
    write_id(out, &id);
    out.zeros(4);
    out.f64s(&[switch_in, switch_out]);
    out.zeros(4); // special effects
    out.u32(0x2000_0000); // the centre is frozen
    out.f64s(center);
    out.f64s(&[transition, significant_size]);
    out.end();
    write_long_id(out, &id, name);
}

fn write_object(out: &mut Writer, number: usize) {
    let id = id('o', number);
    out.begin(opcode::OBJECT);
    write_id(out, &id);
    out.zeros(16); // flags, priority, transparency, effects, significance: all none
    out.end();
    write_long_id(out, &id, "");
}

fn write_face(out: &mut Writer, number: usize, texture: i16) {
    let id = id('p', number);
    out.begin(opcode::FACE);
    write_id(out, &id);
    surface_tail(out, texture);
    out.end();
    write_long_id(out, &id, "");
}

/// What faces and meshes have behind their IDs.
pub fn surface_tail(out: &mut Writer, texture: i16) {
    out.zeros(6); // infrared colour, priority
    out.u8(0); // solid, back faces culled
    out.u8(0); // not white
    out.u16(0xffff); // no colour name
    out.u16(0xffff); // no alternate colour name
    out.u8(0);
    out.u8(0); // fixed, no alpha blending
    out.i16(-1); // no detail texture
    out.i16(texture);
    out.i16(0); // material
    out.zeros(8); // surface material, feature, infrared material
    out.u16(0); // opaque
    out.u8(0); // no LOD generation control
    out.u8(0); // line style
    out.u32(0x1000_0000); // packed colour
    out.u8(3); // vertex colours and vertex normals
    out.zeros(7);
    out.u32(0xffff_ffff); // white
    out.u32(0xffff_ffff); // alternate white
    out.i16(-1); // no texture mapping
    out.zeros(2);
    out.u32(0xffff_ffff); // no colour index
    out.u32(0xffff_ffff); // no alternate colour index
    out.zeros(2);
    out.i16(-1); // no shader
}

fn validate(model: &Model, faces: usize) -> Result<()> {
    text("the root group's name", &model.name, MAX_STRING)?;
    text("the date", &model.date, 31)?;
    model.header_comment.iter().try_for_each(|c| text("the header comment", c, MAX_STRING))?;
    model.zone_comment.iter().try_for_each(|c| text("the zone comment", c, MAX_STRING))?;
    for point in &model.points {
        text("a point's comment", &point.comment, MAX_STRING)?;
        if !point.matrix.iter().flatten().all(|x| x.is_finite()) {
            return refuse(format!("the matrix of {:?} is not finite", point.comment));
        }
    }
    if let Some((latitude, longitude)) = model.origin
        && !((-90.0..=90.0).contains(&latitude) && (-180.0..=180.0).contains(&longitude))
    {
        return refuse(format!("the origin must lie in ±90, ±180 degrees, found {latitude}, {longitude}"));
    }
    if model.textures.len() > i16::MAX as usize {
        return refuse(format!("at most 32767 textures can be indexed, found {}", model.textures.len()));
    }
    model.textures.iter().try_for_each(|path| relative("a texture path", path))?;
    if model.levels.is_empty() {
        return refuse("a model needs at least one level of detail".into());
    }
    let mut names = std::collections::BTreeSet::new();
    let mut unique = |name: &str, own: String| {
        let taken = name != own
            && (is_numbered(name, 'g', 1 + model.points.len())
                || is_numbered(name, 'l', model.levels.len())
                || is_numbered(name, 'o', model.levels.len())
                || is_numbered(name, 'm', model.levels.len())
                || is_numbered(name, 'p', faces));
        if taken || (!name.is_empty() && !names.insert(name.to_owned())) {
            return refuse(format!("node names must be unique, {name:?} is taken by another node; rename it"));
        }
        Ok(())
    };
    unique(&model.name, id('g', 1))?;
    for (index, level) in model.levels.iter().enumerate() {
        unique(&level.name, id('l', index + 1))?;
        validate_level(model, level, index)?;
    }
    Ok(())
}

/// Whether a name is `letter` and a number from 1 to `count`, as the writer hands out.
fn is_numbered(name: &str, letter: char, count: usize) -> bool {
    let number = name.strip_prefix(letter).and_then(|n| n.parse::<usize>().ok());
    number.is_some_and(|n| (1..=count).contains(&n) && name == id(letter, n))
}

fn validate_level(model: &Model, level: &Level, index: usize) -> Result<()> {
    let which = format!("level {} {:?}", index + 1, level.name);
    text("a level's name", &level.name, MAX_STRING)?;
    check_range(&which, [level.switch_in, level.switch_out, level.transition, level.significant_size], &level.center)?;
    if level.texture.is_some_and(|t| t >= model.textures.len()) {
        return refuse(format!("{which}: texture {:?} of {} does not exist", level.texture, model.textures.len()));
    }
    level.mesh.validate().map_err(|e| Error::Unsupported { format: FORMAT, what: format!("{which}: {e}") })?;
    if drawn(level).next().is_none() {
        return refuse(format!("{which}: no triangle to draw"));
    }
    Ok(())
}

/// Whether a LOD record may have these distances and sizes, as [`write_lod_record`] takes them.
pub fn check_range(which: &str, range: [f64; 4], center: &[f64; 3]) -> Result<()> {
    if !range.iter().chain(center).all(|x| x.is_finite()) || range.iter().any(|&x| x < 0.0) {
        return refuse(format!("{which}: distances and sizes must be finite and not negative"));
    }
    if range[0] <= range[1] {
        return refuse(format!(
            "{which}: switch-in {} must exceed switch-out {}, or it is never drawn",
            range[0], range[1]
        ));
    }
    Ok(())
}

/// Whether a text is a path that a reader finds from the file's own folder.
pub fn relative(what: &str, path: &str) -> Result<()> {
    text(what, path, 199)?;
    if path.is_empty() || path.starts_with('/') || path.contains(['\\', ':']) {
        return refuse(format!("{what} is relative with / between folders, found {path:?}"));
    }
    Ok(())
}

pub fn text(what: &str, text: &str, longest: usize) -> Result<()> {
    // Zone XML may have line ends.
    let printable = |b: u8| (0x20..0x7f).contains(&b) || matches!(b, b'\n' | b'\r' | b'\t');
    if text.len() > longest {
        return refuse(format!("{what} has {} bytes, at most {longest} fit", text.len()));
    }
    if !text.bytes().all(printable) {
        return refuse(format!("{what} must be printable ASCII, found {text:?}"));
    }
    Ok(())
}

pub fn refuse<T>(what: String) -> Result<T> {
    Err(Error::Unsupported { format: FORMAT, what })
}
