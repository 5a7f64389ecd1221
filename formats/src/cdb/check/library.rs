//! Rules 1, 2, 5, 6, 7, 9, 11 and 12 for the model libraries: GTModel and MModel.

use std::collections::{BTreeMap, BTreeSet};

use super::Findings;
use super::flt::{self, LevelFacts, Zone};
use crate::cdb::codes::Labels;
use crate::cdb::descriptor::{Descriptor, Identification};
use crate::cdb::dis::EntityType;
use crate::cdb::library::{self, LibraryFile};
use crate::cdb::model::Size;
use crate::cdb::names;
use crate::cdb::store::{ListableStore, read};
use crate::cdb::texture::filing;
use crate::{Result, openflight};

/// A geotypical or a moving model.
#[derive(Debug, Default)]
pub struct LibraryModel {
    pub has_geometry: bool,
    pub has_descriptor: bool,
    /// By level of detail; of a moving model by its place in the file.
    pub levels: BTreeMap<i32, LevelFacts>,
}

impl LibraryModel {
    /// The largest of all levels.
    pub fn size(&self) -> Size {
        self.levels.values().fold(Size::default(), |s, f| s.max(f.size))
    }
}

/// The models of a store's libraries.
#[derive(Debug, Default)]
pub struct Library {
    /// By `FACC_FSC_MODL`.
    pub typical: BTreeMap<String, LibraryModel>,
    pub moving: BTreeMap<EntityType, LibraryModel>,
}

/// The textures of a library: level of detail or power of two, and TNAM.
#[derive(Default)]
struct Textures {
    paths: BTreeMap<String, String>,
    typical: BTreeSet<(i8, String)>,
    moving: BTreeSet<(u32, String)>,
}

pub fn check(store: &dyn ListableStore, paths: &[String], findings: &mut Findings) -> Result<Library> {
    // Rule 12 speaks of broken lists.
    let labels = Labels::read(store).unwrap_or_default();
    let mut files = Vec::new();
    for path in paths.iter().filter(|p| p.starts_with("GTModel/") || p.starts_with("MModel/")) {
        match library::parse(path, &labels) {
            Ok(Some(file)) => files.push((path, file)),
            Ok(None) => {}
            Err(text) => findings.add(11, path, text),
        }
    }
    let mut textures = Textures::default();
    for (path, file) in &files {
        let (Some(bytes), LibraryFile::TypicalTexture { .. } | LibraryFile::MovingTexture { .. }) =
            (read(store, path)?, file)
        else {
            continue;
        };
        let found = flt::check_image(path, "it", &bytes, findings);
        textures.paths.insert(file_name(path).into(), (*path).clone());
        match file {
            LibraryFile::MovingTexture { power, name } => {
                if let Some(found) = found.filter(|f| f != power) {
                    findings.add(2, path, format!("W{power:02} should be W{found:02}, that of the larger side"));
                }
                textures.moving.insert((*power, name.clone()));
            }
            LibraryFile::TypicalTexture { lod, name } => {
                textures.typical.insert((*lod, name.clone()));
            }
            _ => {}
        }
    }
    let mut all = Library::default();
    for (path, file) in &files {
        let Some(bytes) = read(store, path)? else { continue };
        let mut add = |rule: u8, text: String| findings.add(rule, path, text);
        match file {
            LibraryFile::TypicalEntry { key } => {
                all.typical.entry(key.clone()).or_default().has_geometry = true;
                check_entry(path, &bytes, paths, &mut add);
            }
            LibraryFile::TypicalLevel { lod, key } => {
                let Some(model) = flt::check_model(file_name(path), &bytes, Zone::AsFile, &mut add) else { continue };
                check_textures(path, &model, &textures, &mut add);
                if let Some(facts) = flt::one_level(&model, &bytes, *lod, path, &mut add) {
                    all.typical.entry(key.clone()).or_default().levels.insert((*lod).into(), facts);
                }
            }
            LibraryFile::TypicalDescriptor { key } => {
                all.typical.entry(key.clone()).or_default().has_descriptor = true;
                if let Some(d) = flt::check_descriptor(&bytes, &mut add) {
                    check_typical_descriptor(key, &d, &textures, &mut add);
                }
            }
            LibraryFile::MovingGeometry { entity, part } => {
                let Some(model) = flt::check_model(file_name(path), &bytes, Zone::Any, &mut add) else { continue };
                check_textures(path, &model, &textures, &mut add);
                // Further parts are placed by the first.
                if *part == 1 {
                    let known = all.moving.entry(*entity).or_default();
                    known.has_geometry = true;
                    for (i, level) in (0..).zip(&model.levels) {
                        let Some(facts) = LevelFacts::of(level, level.mesh.positions.len(), path) else { continue };
                        flt::check_ground(&facts, &mut add);
                        known.levels.insert(i, facts);
                    }
                }
            }
            LibraryFile::MovingDescriptor { entity } => {
                all.moving.entry(*entity).or_default().has_descriptor = true;
                if let Some(d) = flt::check_descriptor(&bytes, &mut add) {
                    check_moving_descriptor(entity, &d, &textures, &mut add);
                }
            }
            LibraryFile::TypicalTexture { .. } | LibraryFile::MovingTexture { .. } => {}
        }
    }
    for (key, model) in &all.typical {
        check_whole(key, model, library::TYPICAL_GEOMETRY, findings);
    }
    for (entity, model) in &all.moving {
        check_whole(&entity.to_string(), model, library::MOVING_GEOMETRY, findings);
    }
    Ok(all)
}

fn file_name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or_default()
}

/// Rules 1, 5 and 7 over a whole model.
fn check_whole(key: &str, model: &LibraryModel, dataset: &str, findings: &mut Findings) {
    let path = model.levels.values().next().map_or(dataset, |f| &f.path).to_string();
    for (there, what) in [(model.has_geometry, "entry file of geometry"), (model.has_descriptor, "descriptor")] {
        if !there {
            findings.add(1, &path, format!("the model {key} has no {what}"));
        }
    }
    let coarsest = model.levels.keys().next().copied().unwrap_or(0);
    let steps = model.levels.iter().map(|(lod, facts)| ((lod - coarsest).unsigned_abs() as usize, facts));
    flt::check_levels(key, steps, findings);
    if let Some(finest) = model.levels.values().next_back() {
        flt::check_centre(finest, key, findings);
    }
}

/// Rules 1 and 6 for the file that refers to a geotypical model's levels.
fn check_entry(path: &str, bytes: &[u8], paths: &[String], add: &mut dyn FnMut(u8, String)) {
    let master = match openflight::read_master(bytes) {
        Ok(master) => master,
        Err(e) => return add(6, format!("it is no OpenFlight file: {e}")),
    };
    flt::check_frame(file_name(path), bytes, Zone::AsFile, master.zone_comment.as_deref(), add);
    if master.levels.is_empty() {
        add(1, "it refers to no level of detail".into());
    }
    for level in &master.levels {
        let target = resolved(path, &level.path);
        if target.is_none_or(|t| paths.binary_search(&t).is_err()) {
            add(1, format!("the level {} is not there", level.path));
        }
    }
}

/// Rule 2: what the palette names is there, at the end of the path.
fn check_textures(path: &str, model: &openflight::Model, textures: &Textures, add: &mut dyn FnMut(u8, String)) {
    for texture in &model.textures {
        match textures.paths.get(file_name(texture)) {
            None => add(2, format!("the texture {texture} is not in the library")),
            Some(there) if resolved(path, texture).as_ref() != Some(there) => {
                add(2, format!("the texture path {texture} should lead to {there}"));
            }
            Some(_) => {}
        }
    }
}

/// A path from a file's folder, without `.` and `..`; `None` where it leaves the store.
fn resolved(from: &str, path: &str) -> Option<String> {
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in path.split(['/', '\\']) {
        match part {
            "" | "." => {}
            ".." => drop(parts.pop()?),
            name => parts.push(name),
        }
    }
    Some(parts.join("/"))
}

fn check_typical_descriptor(key: &str, d: &Descriptor, textures: &Textures, add: &mut dyn FnMut(u8, String)) {
    match &d.identification {
        Identification::Feature { facc, fsc } if key.starts_with(&(names::feature_code(facc, *fsc) + "_")) => {}
        other => add(12, format!("it identifies {other:?}, not the code of its name")),
    }
    for texture in &d.textures {
        let (low, high) = texture.mipmap;
        let lods = filing(texture.resolution).map(Some).chain(std::iter::repeat(None));
        for (power, lod) in (low..=high).rev().zip(lods) {
            if !lod.is_some_and(|lod| textures.typical.contains(&(lod, texture.name.clone()))) {
                let at = lod.map_or("LOD -11".into(), names::lod_name);
                add(2, format!("texture {}: the mip of {} texels is missing at {at}", texture.name, 1 << power));
            }
        }
    }
}

fn check_moving_descriptor(entity: &EntityType, d: &Descriptor, textures: &Textures, add: &mut dyn FnMut(u8, String)) {
    if d.identification != Identification::Entity(*entity) {
        add(12, format!("it identifies {:?}, not the entity type of its name", d.identification));
    }
    for texture in &d.textures {
        for power in texture.mipmap.0..=texture.mipmap.1 {
            if !textures.moving.contains(&(power, texture.name.clone())) {
                add(2, format!("texture {}: the mip of {} texels is missing", texture.name, 1 << power));
            }
        }
    }
}
