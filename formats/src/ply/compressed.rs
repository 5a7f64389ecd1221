//! The compressed layout of PlayCanvas: 16 bytes a splat, ranges for every 256.
//!
//! Source: the writer and reader of `playcanvas/splat-transform`. An element `chunk` has the smallest and largest
//! position, logarithmic scale and (in later files) colour of 256 splats; `vertex` packs each splat into four 32-bit
//! words; an optional `sh` has a byte for every coefficient above degree 0.

use super::header::{Element, Header};
use super::values::Source;
use super::{FORMAT, REST, malformed, rest_bases};
use crate::splats::logit;
use crate::{Error, Result, Splats};

const CHUNK: usize = 256;
const SH_C0: f32 = 0.282_094_8;
/// Opacity 0 and 255 of 255 read as ± this: half a step from the end.
const MAX_LOGIT: f32 = 6.232_448; // ln(509)
/// Coefficients run from −4 to 4.
const SH_RANGE: f32 = 8.0;

/// Whether a header announces this layout.
pub fn is_compressed(header: &Header) -> bool {
    let packed = |e: &Element| e.name == "vertex" && e.properties.iter().any(|p| p.name == "packed_position");
    header.elements.iter().any(|e| e.name == "chunk") && header.elements.iter().any(packed)
}

/// Reads the elements `chunk`, `vertex` and `sh`, in this order.
pub fn read(source: &mut Source, header: &Header) -> Result<Splats> {
    let mut chunks = Columns::default();
    let mut out = Splats::default();
    for element in &header.elements {
        match element.name.as_str() {
            "chunk" => chunks = Columns::read(source, element)?,
            "vertex" => out = vertices(source, element, &chunks)?,
            "sh" => harmonics(source, element, &mut out)?,
            _ => source.skip(element)?,
        }
    }
    Ok(out)
}

/// An element's scalars by name; lists are skipped.
#[derive(Default)]
struct Columns {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Columns {
    fn read(source: &mut Source, element: &Element) -> Result<Self> {
        source.check_room(element)?;
        let scalars = || element.properties.iter().filter(|p| p.list.is_none());
        let mut rows = Vec::with_capacity(element.count);
        if element.properties.is_empty() {
            return Ok(Self::default());
        }
        for _ in 0..element.count {
            let mut row = Vec::with_capacity(element.properties.len());
            for property in &element.properties {
                match property.list {
                    Some(_) => source.skip_property(property)?,
                    None => row.push(source.number(property.kind)?),
                }
            }
            rows.push(row);
        }
        Ok(Columns { names: scalars().map(|p| p.name.clone()).collect(), rows })
    }

    fn column(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|n| n == name)
    }

    /// The places of columns that must be there.
    fn columns<const N: usize>(&self, names: [&str; N], element: &str) -> Result<[usize; N]> {
        let mut out = [0; N];
        for (place, name) in out.iter_mut().zip(names) {
            *place = self.column(name).ok_or_else(|| {
                Error::malformed(FORMAT, 0, format!("a property {name} of the element {element}"), "none")
            })?;
        }
        Ok(out)
    }
}

/// `bits` bits from `shift` on as 0..1.
fn part(word: u32, shift: u32, bits: u32) -> f32 {
    let most = (1u32 << bits) - 1;
    (word >> shift & most) as f32 / most as f32
}

fn thirds(word: u32) -> [f32; 3] {
    [part(word, 21, 11), part(word, 11, 10), part(word, 0, 11)]
}

fn vertices(source: &mut Source, element: &Element, chunks: &Columns) -> Result<Splats> {
    let lows = chunks.columns(["min_x", "min_y", "min_z", "min_scale_x", "min_scale_y", "min_scale_z"], "chunk")?;
    let highs = chunks.columns(["max_x", "max_y", "max_z", "max_scale_x", "max_scale_y", "max_scale_z"], "chunk")?;
    let color_lows = chunks.columns(["min_r", "min_g", "min_b"], "chunk").ok();
    let color_highs = chunks.columns(["max_r", "max_g", "max_b"], "chunk").ok();
    if element.count.div_ceil(CHUNK) > chunks.rows.len() {
        let expected = format!("a chunk for every {CHUNK} of {} splats", element.count);
        return malformed(element.offset, expected, chunks.rows.len().to_string());
    }
    let packed = Columns::read(source, element)?;
    let places = packed.columns(["packed_position", "packed_rotation", "packed_scale", "packed_color"], "vertex")?;
    let mut out = Splats::default();
    for (i, row) in packed.rows.iter().enumerate() {
        let chunk = &chunks.rows[i / CHUNK];
        let [position, rotation, scale, color] = places.map(|p| row[p] as u32);
        let between = |t: f32, low: usize, high: usize| chunk[low] as f32 * (1.0 - t) + chunk[high] as f32 * t;
        let range = |t: [f32; 3], first: usize| -> [f32; 3] {
            std::array::from_fn(|k| between(t[k], lows[first + k], highs[first + k]))
        };
        out.positions.push(range(thirds(position), 0));
        out.log_scales.push(range(thirds(scale), 3));
        out.rotations.push(rotation_of(rotation));
        let mut rgb: [f32; 3] = std::array::from_fn(|k| part(color, 24 - 8 * k as u32, 8));
        if let (Some(low), Some(high)) = (color_lows, color_highs) {
            rgb = std::array::from_fn(|k| between(rgb[k], low[k], high[k]));
        }
        let mut sh = [[0.0; 3]; 16];
        sh[0] = rgb.map(|c| (c - 0.5) / SH_C0);
        out.sh.push(sh);
        out.logit_opacities.push(logit(part(color, 0, 8), MAX_LOGIT));
    }
    // A range that is not finite would spoil its splats.
    out.validate(FORMAT)?;
    Ok(out)
}

/// The index of the largest component in 2 bits, w first; the others in 10 bits of −√½..√½.
fn rotation_of(word: u32) -> [f32; 4] {
    let small = [20, 10, 0].map(|shift| (part(word, shift, 10) - 0.5) * std::f32::consts::SQRT_2);
    let largest = (word >> 30) as usize;
    let mut q = [0.0; 4];
    let mut rest = small.into_iter();
    for (i, c) in q.iter_mut().enumerate() {
        *c = if i == largest { 0.0 } else { rest.next().unwrap_or_default() };
    }
    q[largest] = (1.0 - small.iter().map(|c| c * c).sum::<f32>()).max(0.0).sqrt();
    q
}

fn harmonics(source: &mut Source, element: &Element, out: &mut Splats) -> Result<()> {
    let columns = Columns::read(source, element)?;
    if columns.rows.len() != out.sh.len() {
        let expected = format!("{} rows of sh behind as many splats", out.sh.len());
        return malformed(element.offset, expected, columns.rows.len().to_string());
    }
    let count = (0..REST).take_while(|i| columns.column(&format!("f_rest_{i}")).is_some()).count();
    let bases = rest_bases(count, count)?;
    let places: Vec<usize> = (0..count).filter_map(|i| columns.column(&format!("f_rest_{i}"))).collect();
    for (sh, row) in out.sh.iter_mut().zip(&columns.rows) {
        for (i, &place) in places.iter().enumerate() {
            let byte = row[place] as f32;
            // Bytes 0 and 255 are the ends, the others the middles of their steps.
            let t = if byte <= 0.0 {
                0.0
            } else if byte >= 255.0 {
                1.0
            } else {
                (byte + 0.5) / 256.0
            };
            sh[1 + i % (bases - 1)][i / (bases - 1)] = (t - 0.5) * SH_RANGE;
        }
    }
    Ok(())
}
