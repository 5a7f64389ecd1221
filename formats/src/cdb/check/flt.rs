//! Rules 2, 6, 9 and 12 for a model's file, wherever it lies: OpenFlight as CDB wants it, images, descriptors.

use super::Findings;
use crate::cdb::descriptor::{self, Descriptor, TextureEntry};
use crate::cdb::entries::vertex_records;
use crate::cdb::lod;
use crate::cdb::material::is_base_name;
use crate::cdb::model::Size;
use crate::cdb::xml;
use crate::{Image, openflight, sgi};

/// What the geometry of one level says.
#[derive(Clone, Debug)]
pub struct LevelFacts {
    pub size: Size,
    pub significant_size: f64,
    pub vertices: usize,
    /// Centre of the XY bounding rectangle.
    pub centre: [f64; 2],
    /// The file or archive, for messages.
    pub path: String,
}

impl LevelFacts {
    /// `vertices` is the number of vertex records, which a file of several levels does not tell apart.
    pub fn of(level: &openflight::Level, vertices: usize, path: &str) -> Option<LevelFacts> {
        let (lo, hi) = level.mesh.bounds()?;
        Some(LevelFacts {
            size: Size::of([&level.mesh]),
            significant_size: level.significant_size,
            vertices,
            centre: [0, 1].map(|a| 0.5 * (lo[a] + hi[a])),
            path: path.into(),
        })
    }
}

/// Rule 6: sound records, the header's fields, the zone, the bounding box. Returns the model.
pub fn check_model(name: &str, bytes: &[u8], zone: Zone, add: &mut dyn FnMut(u8, String)) -> Option<openflight::Model> {
    let model = match openflight::read(bytes) {
        Ok(model) => model,
        Err(e) => {
            add(6, format!("it is no OpenFlight file: {e}"));
            return None;
        }
    };
    check_frame(name, bytes, zone, model.zone_comment.as_deref(), add);
    let Some(b) = bounding_box(bytes) else {
        add(6, "the zone has no bounding box".into());
        return Some(model);
    };
    let outside = |p: &[f64; 3]| (0..3).any(|a| p[a] < b[a] - 1e-6 || p[a] > b[a + 3] + 1e-6);
    if model.levels.iter().flat_map(|l| &l.mesh.positions).any(outside) {
        add(6, "the zone's bounding box does not enclose all vertices".into());
    }
    Some(model)
}

/// How the root's zone is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Zone {
    /// As the file's name ends.
    AsFile,
    Any,
}

/// Rule 6 without the geometry.
pub fn check_frame(name: &str, bytes: &[u8], zone: Zone, comment: Option<&str>, add: &mut dyn FnMut(u8, String)) {
    for finding in openflight::check(bytes) {
        add(6, finding);
    }
    // Volume 6, Requirement 1, and the header fields of its §6.1.
    let field = |at: usize| bytes.get(at..at + 4).and_then(|b| b.first_chunk().copied()).map(i32::from_be_bytes);
    for (at, expected, what) in [(12, 1600, "format revision"), (92, 0, "projection"), (268, 0, "ellipsoid")] {
        if field(at) != Some(expected) {
            add(6, format!("the header's {what} is {:?}, expected {expected}", field(at)));
        }
    }
    if bytes.get(62) != Some(&0) {
        add(6, "the header's unit is not metres".into());
    }
    match zone_name(comment.unwrap_or_default()) {
        Err(text) => add(6, text),
        Ok(found) if zone == Zone::AsFile && !name.ends_with(&format!("_{found}.flt")) => {
            add(6, format!("the zone is named {found}, not as the model"))
        }
        Ok(_) => {}
    }
}

/// The facts of a file that holds one level, which must be of the level of detail that the file is filed under.
pub fn one_level(
    model: &openflight::Model,
    bytes: &[u8],
    filed: i8,
    path: &str,
    add: &mut dyn FnMut(u8, String),
) -> Option<LevelFacts> {
    let [level] = &model.levels[..] else {
        add(5, format!("{} levels of detail in one file, expected one", model.levels.len()));
        return None;
    };
    if lod::of_size(level.significant_size) > filed {
        let belongs = lod::of_size(level.significant_size);
        add(5, format!("significant size {} m belongs to LOD {belongs}, not {filed}", level.significant_size));
    }
    let facts = LevelFacts::of(level, vertex_records(bytes), path)?;
    check_ground(&facts, add);
    Some(facts)
}

/// Rule 7.
pub fn check_ground(facts: &LevelFacts, add: &mut dyn FnMut(u8, String)) {
    if facts.size.depth > 1e-3 {
        add(7, format!("{:.3} m lie below the ground, which is a basement", facts.size.depth));
    }
}

/// Rule 7 for the finest level.
pub fn check_centre(facts: &LevelFacts, key: &str, findings: &mut Findings) {
    if facts.centre.iter().any(|c| c.abs() > 1e-3) {
        let [cx, cy] = facts.centre;
        let text = format!("{key}: the centre of the bounding rectangle is ({cx:.4}, {cy:.4}) m, not the origin");
        findings.add(7, &facts.path, text);
    }
}

/// Rule 5 over the levels of a model, coarsest first, each with its steps above the coarsest.
pub fn check_levels<'a>(key: &str, levels: impl IntoIterator<Item = (usize, &'a LevelFacts)>, findings: &mut Findings) {
    let mut coarser: Option<f64> = None;
    for (steps, facts) in levels {
        let limit = lod::max_vertices(steps);
        if facts.vertices > limit {
            findings.add(5, &facts.path, format!("{key} has {} vertices, this LOD takes {limit}", facts.vertices));
        }
        if coarser.is_some_and(|c| facts.significant_size >= c) {
            let text = format!("{key}: the significant size does not decrease from the coarser level");
            findings.add(5, &facts.path, text);
        }
        coarser = Some(facts.significant_size);
    }
}

/// Rule 2: an SGI image of powers of two. Returns the power of two of the larger side.
pub fn check_image(path: &str, name: &str, bytes: &[u8], findings: &mut Findings) -> Option<u32> {
    match sgi::read(bytes) {
        Err(e) => findings.add(2, path, format!("{name} is no SGI image: {e}")),
        Ok((Image { width, height, .. }, _)) if !width.is_power_of_two() || !height.is_power_of_two() => {
            findings.add(2, path, format!("{name} has {width} × {height} texels, expected powers of two"));
        }
        Ok((image, _)) => return Some(crate::cdb::texture::log2(&image)),
    }
    None
}

/// Rules 2, 9 and 12 inside a descriptor. Returns it with those of its textures whose numbers make sense.
pub fn check_descriptor(bytes: &[u8], add: &mut dyn FnMut(u8, String)) -> Option<Descriptor> {
    let mut d = match descriptor::read(&String::from_utf8_lossy(bytes)) {
        Ok(d) => d,
        Err(e) => {
            add(12, e.to_string());
            return None;
        }
    };
    if d.materials.is_empty() || d.materials.iter().any(|(i, _)| *i == 0) {
        add(9, "expected composite materials of index 1 and more".into());
    }
    for (index, bases) in &d.materials {
        if bases.is_empty() || !bases.iter().all(|b| is_base_name(b)) {
            add(9, format!("composite material {index} names {bases:?}, expected base materials BM_…"));
        }
    }
    d.textures.retain(|texture| {
        let (low, high) = texture.mipmap;
        let sensible = low <= high && high <= 15 && texture.resolution > 0.0 && texture.resolution.is_finite();
        if !sensible {
            let TextureEntry { name, resolution, .. } = texture;
            add(2, format!("texture {name}: mip levels {low} to {high} at {resolution} texels a metre"));
        }
        sensible
    });
    Some(d)
}

/// The name of the global zone in the comment of the root group (Volume 6, §6.5).
fn zone_name(comment: &str) -> Result<String, String> {
    // The prefix is used without being declared.
    let bound = comment.replacen("<CDB:Zone", "<CDB:Zone xmlns:CDB=\"CDB\"", 1);
    let zone = xml::parse(&bound).map_err(|e| format!("the comment of the root group is no XML: {e}"))?;
    match zone.attribute("name") {
        Some(name) if zone.name == "CDB:Zone" && !name.is_empty() => Ok(name.into()),
        _ => Err(format!("the comment of the root group should hold a named CDB:Zone, found {comment:?}")),
    }
}

/// The first bounding box record (74): lowest x, y, z, highest x, y, z.
fn bounding_box(flt: &[u8]) -> Option<[f64; 6]> {
    let mut at = 0;
    loop {
        let &[a, b, c, d] = flt.get(at..)?.first_chunk()?;
        if u16::from_be_bytes([a, b]) == 74 {
            let mut out = [0.0; 6];
            for (i, value) in out.iter_mut().enumerate() {
                *value = f64::from_be_bytes(*flt.get(at + 8 + 8 * i..)?.first_chunk()?);
            }
            return Some(out);
        }
        at += usize::from(u16::from_be_bytes([c, d])).max(4);
    }
}
