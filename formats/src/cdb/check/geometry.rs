//! Rules 2, 5, 6, 7, 9, 10 and 12 for the archives of models, and the facts that the features are held against.

use std::collections::{BTreeMap, BTreeSet};

use super::Findings;
use super::flt::{self, LevelFacts, Zone};
use crate::Result;
use crate::cdb::archive::{Archive, MAX_BYTES};
use crate::cdb::descriptor::Identification;
use crate::cdb::entries::{SELECTOR, texture_entry_name};
use crate::cdb::geocell::Tile;
use crate::cdb::names::{self, GS_MODEL_DESCRIPTOR, GS_MODEL_GEOMETRY, GS_MODEL_TEXTURE, TileFile};
use crate::cdb::store::{ListableStore, read};
use crate::cdb::texture::filing;

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
            flt::check_image(path, &name, &bytes, findings);
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
    let archive = match Archive::read(bytes, path) {
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

fn check_flt(
    path: &str,
    file: &TileFile,
    name: &str,
    bytes: &[u8],
    textures: &Textures,
    findings: &mut Findings,
) -> Option<LevelFacts> {
    let mut add = |rule: u8, text: String| findings.add(rule, path, format!("{name}: {text}"));
    let model = flt::check_model(name, bytes, Zone::AsFile, &mut add)?;
    for texture in &model.textures {
        let entry = texture.rsplit('/').next().unwrap_or_default();
        if !textures.contains(entry) {
            add(2, format!("the texture {texture} is in no archive of dataset 301"));
        }
        if let Some(expected) = expected_texture_path(entry).filter(|e| e != texture) {
            add(2, format!("the texture path {texture} should be {expected}"));
        }
    }
    flt::one_level(&model, bytes, file.tile.lod, path, &mut add)
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

fn check_descriptor(
    path: &str,
    file: &TileFile,
    name: &str,
    bytes: &[u8],
    textures: &Textures,
    findings: &mut Findings,
) {
    let mut add = |rule: u8, text: String| findings.add(rule, path, format!("{name}: {text}"));
    let Some(d) = flt::check_descriptor(bytes, &mut add) else { return };
    let code = match &d.identification {
        Identification::Feature { facc, fsc } => names::feature_code(facc, *fsc),
        Identification::Entity(e) => e.to_string(),
    };
    if !model_key(name, file, "xml").is_some_and(|key| key.starts_with(&format!("{code}_"))) {
        add(12, format!("the feature code {code} is not that of the name"));
    }
    for texture in &d.textures {
        let (low, high) = texture.mipmap;
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
