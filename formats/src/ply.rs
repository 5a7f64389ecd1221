//! Gaussian splats as PLY: the layout of the 3DGS reference implementation.
//!
//! Sources: the PLY format (Greg Turk, "The PLY Polygon File Format", 1994); Kerbl et al., "3D Gaussian Splatting for
//! Real-Time Radiance Field Rendering", 2023, whose property names have become the custom. Readers go by name, so the
//! order is free; the colour coefficients past the first are channel-major in files and basis-major in memory.

use std::sync::atomic::{AtomicBool, Ordering};

mod compressed;
mod header;
mod points;
mod values;

pub use crate::Splats;
use crate::splats::whole;
use crate::{Error, Result, threads};
use header::{Element, Header};
pub use points::{Point, points};
use values::Source;

const FORMAT: &str = "PLY";
/// Spherical-harmonic coefficients of degree 3, for each of three channels.
const BASES: usize = 16;
const REST: usize = (BASES - 1) * 3;
/// Floats of one splat as written: position, normal, colour, opacity, scale, rotation.
const COLUMNS: usize = 3 + 3 + 3 + REST + 1 + 3 + 4;

/// Writes splats as binary little-endian PLY of degree 3 in the customary order, normals 0. Comments come first in the
/// header, a line each.
///
/// # Errors
/// [`Error::Unsupported`] for arrays of different lengths, a value that is not finite, a comment that is not one line
/// of printable ASCII.
pub fn write(splats: &Splats, comments: &[String]) -> Result<Vec<u8>> {
    splats.check_lengths(FORMAT)?;
    if let Some(bad) = comments.iter().find(|c| !c.bytes().all(|b| (0x20..0x7f).contains(&b))) {
        return refuse(format!("a comment must be one line of printable ASCII, found {bad:?}"));
    }
    let count = splats.positions.len();
    let head = header::of_splats(count, comments);
    // Zeros that the system brings page by page, when the rows are written.
    let mut out = vec![0; head.len() + count * COLUMNS * 4];
    let (start, rows) = out.split_at_mut(head.len());
    start.copy_from_slice(head.as_bytes());
    let finite = AtomicBool::new(true);
    threads::on_rows(rows, COLUMNS * 4, |first, rows| {
        let mut all = true;
        for (i, bytes) in (first..).zip(rows.chunks_exact_mut(COLUMNS * 4)) {
            let mut row = [0.0f32; COLUMNS]; // normals stay 0
            let sh = &splats.sh[i];
            row[0..3].copy_from_slice(&splats.positions[i]);
            row[6..9].copy_from_slice(&sh[0]);
            for basis in 1..BASES {
                for channel in 0..3 {
                    row[9 + channel * (BASES - 1) + basis - 1] = sh[basis][channel];
                }
            }
            row[54] = splats.logit_opacities[i];
            row[55..58].copy_from_slice(&splats.log_scales[i]);
            row[58..62].copy_from_slice(&splats.rotations[i]);
            all &= whole(&row);
            bytes.chunks_exact_mut(4).zip(&row).for_each(|(to, value)| to.copy_from_slice(&value.to_le_bytes()));
        }
        if !all {
            finite.store(false, Ordering::Relaxed);
        }
    });
    if !finite.into_inner() {
        splats.check_finite(FORMAT)?; // names the splat
    }
    Ok(out)
}

/// Reads splats and the header's comments: ASCII or binary of either byte order, properties in any order, of any
/// number type, degree 0 to 3 by the number of `f_rest_` properties. Normals, other properties and other elements are
/// skipped; missing coefficients are 0. The compressed layout of PlayCanvas is told by its properties and read too.
///
/// # Errors
/// [`Error::Malformed`] with the byte offset for a broken header, a missing property or a cut file;
/// [`Error::Unsupported`] for other numbers of coefficients. Memory is bounded by the size of the file: no splat is
/// made room for whose bytes are not there.
pub fn read(bytes: &[u8]) -> Result<(Splats, Vec<String>)> {
    let header = Header::parse(bytes)?;
    let mut source = Source { bytes, at: header.end, encoding: header.encoding };
    if compressed::is_compressed(&header) {
        return Ok((compressed::read(&mut source, &header)?, header.comments));
    }
    for element in &header.elements {
        if element.name == "vertex" {
            return Ok((read_vertices(&mut source, element)?, header.comments));
        }
        source.skip(element)?;
    }
    malformed(header.end, "an element called vertex".into(), "none".into())
}

/// Where a property of a vertex goes.
#[derive(Clone, Copy)]
enum Target {
    Position(usize),
    Colour(usize),
    Rest { basis: usize, channel: usize },
    Opacity,
    Scale(usize),
    Rotation(usize),
    Nowhere,
}

fn read_vertices(source: &mut Source, element: &Element) -> Result<Splats> {
    let targets = targets(element)?;
    source.check_room(element)?;
    let count = element.count;
    if let Some(rows) = source.float_rows(element) {
        return Ok(from_rows(rows, element, &targets));
    }
    let mut splats = Splats {
        positions: Vec::with_capacity(count),
        log_scales: Vec::with_capacity(count),
        rotations: Vec::with_capacity(count),
        logit_opacities: Vec::with_capacity(count),
        sh: Vec::with_capacity(count),
    };
    for _ in 0..count {
        let (mut position, mut scale, mut rotation, mut opacity) = ([0.0; 3], [0.0; 3], [0.0; 4], 0.0);
        let mut sh = [[0.0; 3]; BASES];
        for (property, target) in element.properties.iter().zip(&targets) {
            if property.list.is_some() {
                source.skip_property(property)?;
                continue;
            }
            let value = source.number(property.kind)? as f32;
            match *target {
                Target::Position(axis) => position[axis] = value,
                Target::Colour(channel) => sh[0][channel] = value,
                Target::Rest { basis, channel } => sh[basis][channel] = value,
                Target::Opacity => opacity = value,
                Target::Scale(axis) => scale[axis] = value,
                Target::Rotation(part) => rotation[part] = value,
                Target::Nowhere => {}
            }
        }
        splats.positions.push(position);
        splats.log_scales.push(scale);
        splats.rotations.push(rotation);
        splats.logit_opacities.push(opacity);
        splats.sh.push(sh);
    }
    Ok(splats)
}

/// Splats of rows that are little-endian floats and nothing else, as nearly every file has them.
fn from_rows(rows: &[u8], element: &Element, targets: &[Target]) -> Splats {
    let width = 4 * element.properties.len();
    // Where the values of a splat stand in its row: the last of a name counts, missing ones stay 0.
    let (mut shape, mut colours) = ([None; 11], [None; 3 * BASES]);
    for (at, target) in (0..width).step_by(4).zip(targets) {
        match *target {
            Target::Position(axis) => shape[axis] = Some(at),
            Target::Scale(axis) => shape[3 + axis] = Some(at),
            Target::Rotation(part) => shape[6 + part] = Some(at),
            Target::Opacity => shape[10] = Some(at),
            Target::Colour(channel) => colours[channel] = Some(at),
            Target::Rest { basis, channel } => colours[3 * basis + channel] = Some(at),
            Target::Nowhere => {}
        }
    }
    let shape = shape.map(|at| at.unwrap_or(0)); // all are there, by `targets`
    let colours: Vec<(usize, usize)> = colours.iter().enumerate().filter_map(|(i, at)| Some((i, (*at)?))).collect();
    threads::splats(element.count, |part| {
        let rows = rows[part.first * width..].chunks_exact(width);
        for (i, row) in rows.take(part.positions.len()).enumerate() {
            let value = |at: usize| f32::from_le_bytes([row[at], row[at + 1], row[at + 2], row[at + 3]]);
            let [x, y, z, a, b, c, q @ .., opacity] = shape.map(value);
            (part.positions[i], part.log_scales[i]) = ([x, y, z], [a, b, c]);
            (part.rotations[i], part.logit_opacities[i]) = (q, opacity);
            let sh = part.sh[i].as_flattened_mut();
            colours.iter().for_each(|&(to, at)| sh[to] = value(at));
        }
    })
}

/// Sorts the properties by name; all but the higher coefficients must be there.
fn targets(element: &Element) -> Result<Vec<Target>> {
    let scalar = |name: &str| element.properties.iter().any(|p| p.name == name && p.list.is_none());
    let rest = (0..REST).take_while(|i| scalar(&format!("f_rest_{i}"))).count();
    let all = element.properties.iter().filter(|p| p.name.starts_with("f_rest_")).count();
    let bases = rest_bases(rest, all)?;
    type Group = (&'static [&'static str], fn(usize) -> Target);
    let groups: [Group; 5] = [
        (&["x", "y", "z"], Target::Position),
        (&["f_dc_0", "f_dc_1", "f_dc_2"], Target::Colour),
        (&["opacity"], |_| Target::Opacity),
        (&["scale_0", "scale_1", "scale_2"], Target::Scale),
        (&["rot_0", "rot_1", "rot_2", "rot_3"], Target::Rotation),
    ];
    for name in groups.iter().flat_map(|(names, _)| *names) {
        if !scalar(name) {
            return malformed(element.offset, format!("a vertex property {name}"), "none: no file of splats".into());
        }
    }
    let target = |name: &str| {
        for (names, make) in &groups {
            if let Some(index) = names.iter().position(|n| *n == name) {
                return make(index);
            }
        }
        match name.strip_prefix("f_rest_").and_then(|n| n.parse::<usize>().ok()) {
            Some(i) if i < rest => Target::Rest { basis: 1 + i % (bases - 1), channel: i / (bases - 1) },
            _ => Target::Nowhere,
        }
    };
    Ok(element.properties.iter().map(|p| target(&p.name)).collect())
}

/// Coefficients of a channel where there are `rest` numbered ones above degree 0, of `all` of that name.
fn rest_bases(rest: usize, all: usize) -> Result<usize> {
    match rest {
        _ if rest != all => {}
        0 => return Ok(1),
        9 => return Ok(4),
        24 => return Ok(9),
        45 => return Ok(16),
        _ => {}
    }
    refuse(format!("f_rest_ properties for degree 0 to 3 number 0, 9, 24 or 45 from f_rest_0, found {all}"))
}

fn malformed<T>(offset: usize, expected: String, found: String) -> Result<T> {
    Err(Error::Malformed { format: FORMAT, offset: offset as u64, expected, found })
}

fn refuse<T>(what: String) -> Result<T> {
    Err(Error::Unsupported { format: FORMAT, what })
}

#[cfg(test)]
mod tests;
