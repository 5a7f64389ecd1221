//! Rules 2, 5, 6, 7, 9, 10 and 12 for the archives of models, and the facts that the features are held against.

use std::collections::{BTreeMap, BTreeSet};

use super::Findings;
use crate::cdb::archive::{Archive, MAX_BYTES};
use crate::cdb::descriptor;
use crate::cdb::entries::{SELECTOR, texture_entry_name, vertex_records};
use crate::cdb::geocell::Tile;
use crate::cdb::lod;
use crate::cdb::model::Size;
use crate::cdb::names::{self, GS_MODEL_DESCRIPTOR, GS_MODEL_GEOMETRY, GS_MODEL_TEXTURE, TileFile};
use crate::cdb::store::{ListableStore, read};
use crate::cdb::texture::filing;
use crate::cdb::xml;
use crate::{Image, Result, openflight, sgi};

/// What the geometry of one level says.
#[derive(Clone, Debug)]
pub struct LevelFacts {
    pub size: Size,
    pub significant_size: f64,
    pub vertices: usize,
    /// Centre of the XY bounding rectangle.
    pub centre: [f64; 2],
    /// The archive, for messages.
    pub path: String,
}

/// The models of a store, by tile and `FACC_FSC_MODL`.
#[derive(Debug, Default)]
pub struct Models {
    pub levels: BTreeMap<(Tile, String), LevelFacts>,
    pub descriptors: BTreeSet<(Tile, String)>,
}

/// The texture entries of a store.
#[derive(Default)]
struct Textures {
    entries: BTreeSet<String>,
    /// The tiles of each LOD that hold a TNAM.
    tiles: BTreeMap<(i8, String), Vec<Tile>>,
}

impl Textures {
    fn add(&mut self, entry: String) {
        if let Some((tile, name)) = texture_name(&entry) {
            self.tiles.entry((tile.lod, name.into())).or_default().push(tile);
        }
        self.entries.insert(entry);
    }

    fn contains(&self, entry: &str) -> bool {
        self.entries.contains(entry)
    }

    /// Whether a mip is there: in the tile of its LOD that holds `tile`, or in a finer one inside it.
    fn has_mip(&self, tile: Tile, lod: i8, name: &str) -> bool {
        let related = |other: &Tile| {
            let (mut finer, coarser) = if other.lod > tile.lod { (*other, tile) } else { (tile, *other) };
            while let Some(parent) = finer.parent().filter(|_| finer.lod > coarser.lod) {
                finer = parent;
            }
            finer == coarser
        };
        self.tiles.get(&(lod, name.to_string())).is_some_and(|tiles| tiles.iter().any(related))
    }
}

pub fn check(store: &dyn ListableStore, files: &[(String, TileFile)], findings: &mut Findings) -> Result<Models> {
    let archives = |code: u16| files.iter().filter(move |(_, f)| f.dataset.code == code && f.extension == "zip");
    let mut textures = Textures::default();
    for (path, file) in archives(GS_MODEL_TEXTURE.code) {
        for (name, bytes) in open(store, path, file, "rgb", findings)? {
            check_image(path, &name, &bytes, findings);
            textures.add(name);
        }
    }
    let mut models = Models::default();
    for (path, file) in archives(GS_MODEL_GEOMETRY.code) {
        for (name, bytes) in open(store, path, file, "flt", findings)? {
            let key = model_key(&name, file, "flt");
            if let (Some(key), Some(facts)) = (key, check_flt(path, file, &name, &bytes, &textures, findings)) {
                models.levels.insert((file.tile, key), facts);
            }
        }
    }
    for (path, file) in archives(GS_MODEL_DESCRIPTOR.code) {
        for (name, bytes) in open(store, path, file, "xml", findings)? {
            check_descriptor(path, file, &name, &bytes, &textures, findings);
            models.descriptors.extend(model_key(&name, file, "xml").map(|key| (file.tile, key)));
        }
    }
    Ok(models)
}

/// `FACC_FSC_MODL` of an entry name.
fn model_key(name: &str, file: &TileFile, extension: &str) -> Option<String> {
    let prefix = names::base(file.tile, file.dataset, SELECTOR) + "_";
    Some(name.strip_prefix(&prefix)?.strip_suffix(extension)?.strip_suffix('.')?.to_string())
}

/// Rule 10; returns the entries that can be read.
fn open(
    store: &dyn ListableStore,
    path: &str,
    file: &TileFile,
    extension: &str,
    findings: &mut Findings,
) -> Result<Vec<(String, Vec<u8>)>> {
    let Some(bytes) = read(store, path)? else { return Ok(Vec::new()) };
    if bytes.len() > MAX_BYTES {
        findings.add(10, path, format!("{} bytes, an archive takes at most {MAX_BYTES}", bytes.len()));
    }
    let mut archive = match Archive::read(bytes, path) {
        Ok(archive) => archive,
        Err(e) => {
            findings.add(10, path, e.to_string());
            return Ok(Vec::new());
        }
    };
    let names: Vec<String> = archive.names().map(String::from).collect();
    let mut out = Vec::new();
    for name in names {
        let prefix = names::base(file.tile, file.dataset, file.selector) + "_";
        if name.contains('/') || !name.starts_with(&prefix) || !name.ends_with(&format!(".{extension}")) {
            findings.add(10, path, format!("the entry {name} should be named {prefix}….{extension}, without folders"));
        }
        if !archive.is_stored(&name) {
            findings.add(10, path, format!("the entry {name} is compressed, CDB 1.0 stores"));
            continue;
        }
        match archive.get(&name) {
            Some(bytes) => out.push((name, bytes)),
            None => findings.add(10, path, format!("the entry {name} does not match its checksum")),
        }
    }
    Ok(out)
}

fn check_image(path: &str, name: &str, bytes: &[u8], findings: &mut Findings) {
    match sgi::read(bytes) {
        Err(e) => findings.add(2, path, format!("{name} is no SGI image: {e}")),
        Ok((Image { width, height, .. }, _)) if !width.is_power_of_two() || !height.is_power_of_two() => {
            findings.add(2, path, format!("{name} has {width} × {height} texels, expected powers of two"));
        }
        Ok(_) => {}
    }
}

fn check_flt(
    path: &str,
    file: &TileFile,
    name: &str,
    bytes: &[u8],
    textures: &Textures,
    findings: &mut Findings,
) -> Option<LevelFacts> {
    let model = match openflight::read(bytes) {
        Ok(model) => model,
        Err(e) => {
            findings.add(6, path, format!("{name} is no OpenFlight file: {e}"));
            return None;
        }
    };
    let mut add = |rule: u8, text: String| findings.add(rule, path, format!("{name}: {text}"));
    for texture in &model.textures {
        let entry = texture.rsplit('/').next().unwrap_or_default();
        if !textures.contains(entry) {
            add(2, format!("the texture {texture} is in no archive of dataset 301"));
        }
        if let Some(expected) = expected_texture_path(entry).filter(|e| e != texture) {
            add(2, format!("the texture path {texture} should be {expected}"));
        }
    }
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
    match zone_name(model.zone_comment.as_deref().unwrap_or_default()) {
        Err(text) => add(6, text),
        Ok(zone) if !name.ends_with(&format!("_{zone}.flt")) => {
            add(6, format!("the zone is named {zone}, not as the model"))
        }
        Ok(_) => {}
    }
    check_bounding_box(bytes, &model, &mut add);

    let [level] = &model.levels[..] else {
        add(5, format!("{} levels of detail in one file, expected one", model.levels.len()));
        return None;
    };
    if lod::of_size(level.significant_size) > file.tile.lod {
        let belongs = lod::of_size(level.significant_size);
        add(
            5,
            format!("significant size {} m belongs to LOD {belongs}, not {}", level.significant_size, file.tile.lod),
        );
    }
    let size = Size::of([&level.mesh]);
    if size.depth > 1e-3 {
        add(7, format!("{:.3} m lie below the ground, which is a basement", size.depth));
    }
    let (lo, hi) = level.mesh.bounds()?;
    Some(LevelFacts {
        size,
        significant_size: level.significant_size,
        vertices: vertex_records(bytes),
        centre: [0, 1].map(|a| 0.5 * (lo[a] + hi[a])),
        path: path.into(),
    })
}

/// The path of a texture from the folder of a geometry archive; `None` when its name says no tile.
fn expected_texture_path(entry: &str) -> Option<String> {
    let (tile, _) = texture_name(entry)?;
    let folder = names::folder(tile, GS_MODEL_TEXTURE);
    let from_cell = folder.splitn(4, '/').nth(3)?;
    Some(format!("../../../{from_cell}/{entry}"))
}

/// The tile and the TNAM of a texture's entry name: `N34W119_D301_S001_T001_L07_U70_R67_Name.rgb`.
fn texture_name(entry: &str) -> Option<(Tile, &str)> {
    let end = entry.match_indices('_').nth(6)?.0;
    let (base, name) = (&entry[..end], entry[end + 1..].strip_suffix(".rgb")?);
    let fields: Vec<&str> = base.split('_').collect();
    let (south, west) = fields[0].split_at_checked(3)?;
    let folder = if fields[4].starts_with("LC") { "LC" } else { fields[4] };
    let dataset = GS_MODEL_TEXTURE.name;
    let file = names::parse(&format!("Tiles/{south}/{west}/{dataset}/{folder}/{}/{base}.zip", fields[5]))?;
    Some((file.tile, name))
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

fn check_bounding_box(bytes: &[u8], model: &openflight::Model, add: &mut dyn FnMut(u8, String)) {
    let Some(b) = bounding_box(bytes) else { return add(6, "the zone has no bounding box".into()) };
    let outside = |p: &[f64; 3]| (0..3).any(|a| p[a] < b[a] - 1e-6 || p[a] > b[a + 3] + 1e-6);
    if model.levels.iter().flat_map(|l| &l.mesh.positions).any(outside) {
        add(6, "the zone's bounding box does not enclose all vertices".into());
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

fn check_descriptor(
    path: &str,
    file: &TileFile,
    name: &str,
    bytes: &[u8],
    textures: &Textures,
    findings: &mut Findings,
) {
    let mut add = |rule: u8, text: String| findings.add(rule, path, format!("{name}: {text}"));
    let text = String::from_utf8_lossy(bytes);
    let d = match descriptor::read(&text) {
        Ok(d) => d,
        Err(e) => return add(12, e.to_string()),
    };
    let code = names::feature_code(&d.facc, d.fsc) + "_";
    if !model_key(name, file, "xml").is_some_and(|key| key.starts_with(&code)) {
        add(12, format!("the feature code {}/{} is not that of the name", d.facc, d.fsc));
    }
    if d.materials.is_empty() || d.materials.iter().any(|(i, _)| *i == 0) {
        add(9, "expected composite materials of index 1 and more".into());
    }
    for (index, bases) in &d.materials {
        if bases.is_empty() || bases.iter().any(|b| !b.starts_with("BM_") || b.len() > 32) {
            add(9, format!("composite material {index} names {bases:?}, expected base materials BM_…"));
        }
    }
    for texture in &d.textures {
        let (low, high) = texture.mipmap;
        if low > high || high > 15 || !(texture.resolution > 0.0 && texture.resolution.is_finite()) {
            add(
                2,
                format!(
                    "texture {}: mip levels {low} to {high} at {} texels a metre",
                    texture.name, texture.resolution
                ),
            );
            continue;
        }
        // A single file may stand beside the geometry; a chain is filed by texel size, each mip one LOD coarser.
        let beside = texture_entry_name(file.tile, &texture.name);
        if low == high && textures.contains(&beside) {
            continue;
        }
        let lods = filing(texture.resolution).map(Some).chain(std::iter::repeat(None));
        for (power, lod) in (low..=high).rev().zip(lods) {
            let mip = format!("texture {}: the mip of {} texels", texture.name, 1 << power);
            match lod {
                Some(lod) if textures.has_mip(file.tile, lod, &texture.name) => {}
                Some(lod) => add(2, format!("{mip} is missing at {}", names::lod_name(lod))),
                None => add(2, format!("{mip} is coarser than LOD -10")),
            }
        }
    }
}
