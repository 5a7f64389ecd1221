//! The files of a model in a library: geotypical and moving models.
//!
//! Source: OGC CDB 1.x Volume 6, §6.2.4 (a geotypical model's entry file refers to a file a level; a moving model has all
//! levels in one), §6.13 (textures), Requirements 23, 24 (DIS_Origin).

use super::add::{Chosen, MAX_NAMESAKES, too_many};
use super::chain::FeatureChain;
use super::codes::Labels;
use super::descriptor::{self, Identification, TextureEntry};
use super::dis::EntityType;
use super::entries::{FAR, check_vertices, frame, image_name, level, level_file, vertex_records};
use super::library;
use super::model::{Kind, Model, Prepared};
use super::names;
use super::store::{self, Store};
use super::texture::{self, Texture};
use crate::{Error, File, Result, openflight, sgi};

/// Datasets of textures as descriptors name them.
pub const TYPICAL_TEXTURES: u16 = 511;
pub const MOVING_TEXTURES: u16 = 601;

/// The name under which the model stands, or can stand, in the library of a store, and the files that are missing there.
///
/// # Errors
/// What the writers refuse; codes without labels; an entity type that another model has.
pub fn choose(store: &dyn Store, chain: &FeatureChain, model: &Model, prepared: &Prepared) -> Result<Chosen> {
    let labels = Labels::read(store)?;
    for n in 1..=MAX_NAMESAKES {
        let own = match n {
            1 => prepared.name.clone(),
            n => names::with_suffix(&prepared.name, &n.to_string()),
        };
        let (name, built) = match &model.kind {
            Kind::Moving(entity) => (entity.code(), moving(&labels, model, prepared, entity, &own)?),
            _ => (own.clone(), typical(&labels, model, prepared, &own)?),
        };
        let here = chain.stands_here(model, prepared, &name);
        if built.is_held(store)? {
            let notes =
                vec![format!("The library holds this very model already, as {name}: its files are used again.")];
            return Ok(Chosen { name, files: Vec::new(), already_present: here, notes });
        }
        if built.textures_collide(store)? {
            continue;
        }
        if built.geometry_collides(store)? {
            if let Kind::Moving(entity) = &model.kind {
                return Err(Error::Unsupported {
                    format: "CDB model",
                    what: format!(
                        "the store has another model of the DIS entity type {entity}; choose another specific or extra number"
                    ),
                });
            }
            continue;
        }
        let files = [built.geometry, built.textures].concat();
        return Ok(Chosen { name, files, already_present: false, notes: Vec::new() });
    }
    Err(too_many(&prepared.name))
}

/// The files of a model under one name.
struct Built {
    /// OpenFlight files and the descriptor.
    geometry: Vec<File>,
    textures: Vec<File>,
}

impl Built {
    /// Whether all files are there, but for the dates of the OpenFlight files.
    fn is_held(&self, store: &dyn Store) -> Result<bool> {
        for file in self.geometry.iter().chain(&self.textures) {
            let Some(there) = store::read(store, &file.path)? else { return Ok(false) };
            let undated = |bytes: &[u8]| match file.path.ends_with(".flt") && bytes.len() > 52 {
                true => [&bytes[..20], &bytes[52..]].concat(),
                false => bytes.to_vec(),
            };
            if undated(&there) != undated(&file.bytes) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn textures_collide(&self, store: &dyn Store) -> Result<bool> {
        any_exists(store, &self.textures)
    }

    fn geometry_collides(&self, store: &dyn Store) -> Result<bool> {
        any_exists(store, &self.geometry)
    }
}

fn any_exists(store: &dyn Store, files: &[File]) -> Result<bool> {
    for file in files {
        if store::exists(store, &file.path)? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// A geotypical model: entry file, a file a level, descriptor, textures by their texel size.
fn typical(labels: &Labels, model: &Model, prepared: &Prepared, name: &str) -> Result<Built> {
    let folder = library::typical_folder(labels, &model.facc)?;
    let key = format!("{}_{name}", names::feature_code(&model.facc, model.fsc));
    let mut built = Built { geometry: Vec::new(), textures: Vec::new() };
    let mut entries = Vec::new();
    let mut references = Vec::new();
    for (i, prepared_level) in prepared.levels.iter().enumerate() {
        let texture_name = names::texture_name(name, i);
        let textures = library::texture_folder(library::TYPICAL_TEXTURE, &texture_name);
        for (lod, mip) in prepared_level.texture.filed() {
            built.textures.push(image(
                format!("{textures}/{}", library::typical_texture(lod, &texture_name)),
                mip,
                &model.marking,
            )?);
        }
        entries.push(entry(&texture_name, &prepared_level.texture, prepared_level.texture.mipmap()));
        let finest = prepared_level.texture.filed().next().map_or(0, |(lod, _)| lod);
        // From 500_GTModelGeometry/A_Culture/L_Misc_Feature/015_Building/L04 up to the library: five levels.
        let texture = up(5, &format!("{textures}/{}", library::typical_texture(finest, &texture_name)));
        let path = library::typical_level(prepared_level.placed.lod, &key);
        built.geometry.push(flt(format!("{folder}/{path}"), level_file(model, prepared, name, i, texture)?));
        let level = with_distances(prepared, i, level(model, prepared, name, i));
        references.push(openflight::Reference {
            name: level.name,
            switch_in: level.switch_in,
            switch_out: level.switch_out,
            transition: level.transition,
            significant_size: level.significant_size,
            center: level.center,
            path: format!("./{path}"),
        });
    }
    let around = frame(model, name);
    let master = openflight::write_master(&openflight::Master {
        name: around.name,
        date: around.date,
        header_comment: around.header_comment,
        zone_comment: around.zone_comment,
        bounds: bounds(model, prepared),
        levels: references,
    })?;
    built.geometry.push(flt(format!("{folder}/{}", library::typical_entry(&key)), master));
    let feature = Identification::Feature { facc: model.facc.clone(), fsc: model.fsc };
    let text = descriptor::write(name, &feature, (TYPICAL_TEXTURES, &entries), &model.material, &model.marking);
    built.geometry.push(xml(format!("{folder}/{}", library::typical_descriptor(&key)), text));
    Ok(built)
}

/// A moving model: one file of all levels, descriptor, textures by the size of their mips.
fn moving(labels: &Labels, model: &Model, prepared: &Prepared, entity: &EntityType, name: &str) -> Result<Built> {
    let folder = library::moving_folder(labels, entity)?;
    let code = entity.code();
    let mut built = Built { geometry: Vec::new(), textures: Vec::new() };
    let mut entries = Vec::new();
    let mut whole = frame(model, name);
    for (i, prepared_level) in prepared.levels.iter().enumerate() {
        let texture_name = names::texture_name(name, i);
        let textures = library::texture_folder(library::MOVING_TEXTURE, &texture_name);
        let mips = &prepared_level.texture.mips;
        for mip in mips {
            let path = format!("{textures}/{}", library::moving_texture(texture::log2(mip), &texture_name));
            built.textures.push(image(path, mip, &model.marking)?);
        }
        entries.push(entry(&texture_name, &prepared_level.texture, (0, texture::log2(&mips[0]))));
        // From the folder of the entity type up to the library: six levels.
        let finest = library::moving_texture(texture::log2(&mips[0]), &texture_name);
        whole.textures.push(up(6, &format!("{textures}/{finest}")));
        let level = with_distances(prepared, i, level(model, prepared, name, i));
        let alone = openflight::Model { levels: vec![level.clone()], ..frame(model, name) };
        check_vertices(vertex_records(&openflight::write(&alone)?), &prepared_level.placed, i)?;
        whole.levels.push(openflight::Level { texture: Some(i), ..level });
    }
    // DIS counts from the middle of the body, X forward, Y to the right, Z down.
    let (low, high) = bounds(model, prepared);
    let [x, y, z] = std::array::from_fn(|a| (0.5 * (low[a] + high[a])) as f32);
    whole.points.push(openflight::Point {
        comment: "<CDB:Point name=\"DIS_Origin\"/>".into(),
        matrix: [[0.0, 1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0], [x, y, z, 1.0]],
    });
    let path = |file: String| format!("{folder}/{file}");
    built.geometry.push(flt(path(library::moving_geometry(&code)), openflight::write(&whole)?));
    let identification = Identification::Entity(*entity);
    let text = descriptor::write(name, &identification, (MOVING_TEXTURES, &entries), &model.material, &model.marking);
    built.geometry.push(xml(path(library::moving_descriptor(&code)), text));
    Ok(built)
}

/// The distances between which a level is seen, blending over the last tenth.
fn with_distances(prepared: &Prepared, i: usize, level: openflight::Level) -> openflight::Level {
    let distance = |i: usize| openflight::switch_distance(prepared.levels[i].placed.significant_size);
    let switch_in = if i == 0 { FAR } else { distance(i) };
    let switch_out = if i + 1 == prepared.levels.len() { 0.0 } else { distance(i + 1) };
    let transition = if i == 0 { 0.0 } else { (switch_in - switch_out) / 10.0 };
    openflight::Level { switch_in, switch_out, transition, ..level }
}

/// The box around all levels that are kept.
fn bounds(model: &Model, prepared: &Prepared) -> ([f64; 3], [f64; 3]) {
    let levels = model.levels.iter().take(prepared.levels.len());
    let boxes = levels.filter_map(|l| l.mesh.bounds());
    boxes
        .reduce(|(low, high), (l, h)| {
            (std::array::from_fn(|a| low[a].min(l[a])), std::array::from_fn(|a| high[a].max(h[a])))
        })
        .unwrap_or_default()
}

/// A library's file from a folder so many levels below the library: without the library's own name.
fn up(levels: usize, path: &str) -> String {
    "../".repeat(levels) + path.split_once('/').map_or(path, |(_, rest)| rest)
}

fn entry(name: &str, texture: &Texture, mipmap: (u32, u32)) -> TextureEntry {
    TextureEntry { name: name.into(), mipmap, resolution: texture.resolution }
}

fn image(path: String, mip: &crate::Image, marking: &str) -> Result<File> {
    Ok(File { path, bytes: sgi::write(mip, &image_name(marking), false)?, media_type: "image/x-sgi" })
}

fn flt(path: String, bytes: Vec<u8>) -> File {
    File { path, bytes, media_type: "application/x-openflight" }
}

fn xml(path: String, text: String) -> File {
    File { path, bytes: text.into_bytes(), media_type: "application/xml" }
}
