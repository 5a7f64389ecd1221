//! Adding a model to a store, new or existing.
//!
//! Only what stands at the model's place is read and written: the feature tiles along the quadtree, the archives of the
//! model's levels and textures, the geocell's material table. What is there is kept; what cannot be kept is refused.

use super::attributes;
use super::chain::FeatureChain;
use super::entries::{Archives, Entries};
use super::geocell::Tile;
use super::library_model;
use super::material;
use super::metadata::{self, VERSION_XML};
use super::model::{self, Kind, Model, Prepared};
use super::names::{self, VECTOR_MATERIAL};
use super::store::{self, Store};
use super::xml;
use crate::{Error, File, Result};

/// Most models of one name in one tile, or in one library.
pub const MAX_NAMESAKES: usize = 9999;

/// What adding a model comes to.
#[derive(Clone, Debug, PartialEq)]
pub struct Added {
    /// New or replaced files, paths relative to the CDB root, sorted. None when the same model is there already.
    pub files: Vec<File>,
    /// Folders that a new store has besides.
    pub folders: Vec<String>,
    /// MODL, unique in its geocell.
    pub model_name: String,
    /// CNAM.
    pub class_name: String,
    /// `N34W119`.
    pub geocell: String,
    /// Level of detail of each level, coarsest first.
    pub lods: Vec<i8>,
    /// Features of others in the tiles that are rewritten: all kept.
    pub features_kept: usize,
    /// The store holds this very model at this place already.
    pub already_present: bool,
    /// What the user should know, as sentences.
    pub notes: Vec<String>,
}

/// Adds a model to a store.
///
/// MODL follows from [`Model::name`]. In a geocell that holds features already it gets the code of its tile as a suffix,
/// so that it is unique there without reading the geocell's other tiles; a namesake at the same place gets `_2`, `_3`, ….
/// The very same model at the same place is not added again.
///
/// Models of libraries are told apart over the whole store: the very same one is used again, and only a feature added; a
/// namesake gets a number; a moving model whose entity type is taken by another is refused.
///
/// # Errors
/// [`Error::Unsupported`] for a model that breaks a content rule, for a full tile, and for what cannot be kept: unreadable
/// files, other shape types, stores whose features lie in an older version's folder or in a GeoPackage.
pub fn add_model(store: &dyn Store, model: &Model) -> Result<Added> {
    let mut files = Vec::new();
    let mut notes = Vec::new();
    let new_store = metadata_files(store, model, &mut files, &mut notes)?;
    add(store, model, files, notes, new_store)
}

/// Makes a new version of a store that adds a model to it: the files of the new version's own root, with what the tiles
/// held before. `old` is the old version with those that it continues ([`Versions`](super::Versions)), and `previous` its
/// root as seen from the new one's.
///
/// # Errors
/// As [`add_model`].
pub fn add_version(old: &dyn Store, previous: &str, model: &Model) -> Result<Added> {
    let version = metadata::version_xml(&model.marking, &model.comment, Some(previous));
    let mut files = vec![File { path: VERSION_XML.into(), bytes: version.into_bytes(), media_type: "application/xml" }];
    files.extend(metadata::schemas(&model.marking));
    add(old, model, files, Vec::new(), true)
}

/// Adds a model with the Metadata that come with it.
fn add(
    store: &dyn Store,
    model: &Model,
    mut files: Vec<File>,
    mut notes: Vec<String>,
    new_store: bool,
) -> Result<Added> {
    let mut prepared = model::prepare(model)?;
    notes.append(&mut prepared.notes);

    let chain = FeatureChain::read(store, model, &prepared)?;
    let mut chosen = match model.kind {
        Kind::Geospecific => choose_archived(store, &chain, model, &prepared)?,
        Kind::Geotypical | Kind::Moving(_) => library_model::choose(store, &chain, model, &prepared)?,
    };
    notes.append(&mut chosen.notes);
    let name = chosen.name;
    let cell = chain.tiles[&0].cell;
    let features_kept = if chosen.already_present { 0 } else { chain.kept(&prepared) };

    if chosen.already_present {
        notes.push(format!("The store holds this very model at this place already, as {name}: nothing was added."));
        files.clear();
    } else {
        let material = match model.kind {
            // Their features have no CMIX.
            Kind::Moving(_) => 0,
            _ => material_files(store, model, chain.tiles[&0], &mut files)?,
        };
        chain.add(model, &prepared, &name, material, &mut files)?;
        files.append(&mut chosen.files);
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(Added {
        files,
        folders: if new_store { metadata::EMPTY_FOLDERS.map(String::from).to_vec() } else { Vec::new() },
        class_name: attributes::class_name(model, &name),
        geocell: cell.latitude_name() + &cell.longitude_name(),
        lods: prepared.levels.iter().map(|l| l.placed.lod).collect(),
        features_kept,
        model_name: name,
        already_present: chosen.already_present,
        notes,
    })
}

/// A name with the model's own files under it.
pub struct Chosen {
    /// MODL or MMDC.
    pub name: String,
    pub files: Vec<File>,
    /// The feature and the model are there under this name.
    pub already_present: bool,
    pub notes: Vec<String>,
}

/// The first free name of a geospecific model, its archives, and whether the very model is there under it.
fn choose_archived(store: &dyn Store, chain: &FeatureChain, model: &Model, prepared: &Prepared) -> Result<Chosen> {
    let archives = Archives::read(store, model, prepared)?;
    let finest = prepared.finest();
    let content = &chain.contents[&finest];
    let plain = &prepared.name;
    // Without features in the geocell the plain name is free. It is also the one to number from where the model that
    // took it stands in the same tile; anywhere else the tile's code keeps apart what cannot be seen from here.
    let namesake = content.rows_of(plain).any(|r| content.number(r, "MLOD") == Some(f64::from(finest)));
    let code = names::tile_code(chain.tiles[&finest]);
    let coded = chain.populated && !namesake;
    for n in 1..=MAX_NAMESAKES {
        let name = match (coded, n) {
            (false, 1) => plain.clone(),
            (false, n) => names::with_suffix(plain, &n.to_string()),
            (true, 1) => names::with_suffix(plain, &code),
            (true, n) => names::with_suffix(plain, &format!("{code}_{n}")),
        };
        let class = attributes::class_name(model, &name);
        let taken = chain.contents.values().any(|c| c.uses(&name, &class));
        let here = chain.stands_here(model, prepared, &name);
        if taken && !here {
            continue;
        }
        let mut entries = Entries::build(model, prepared, &archives, &name)?;
        let notes = std::mem::take(&mut entries.notes);
        if here && archives.hold(&entries) {
            return Ok(Chosen { name, files: Vec::new(), already_present: true, notes });
        }
        if !taken && !archives.collide(&entries) {
            let zips = archives.with(&entries, &model.marking)?.into_iter();
            let files = zips.map(|(path, bytes)| File { path, bytes, media_type: "application/zip" }).collect();
            return Ok(Chosen { name, files, already_present: false, notes });
        }
    }
    Err(too_many(plain))
}

/// The refusal of yet another model of a name.
pub fn too_many(plain: &str) -> Error {
    Error::Unsupported {
        format: "CDB model",
        what: format!("more than {MAX_NAMESAKES} models are named {plain}; choose another name"),
    }
}

/// The Metadata of a new store; that of an existing one is left as it is. Returns whether the store is new.
fn metadata_files(store: &dyn Store, model: &Model, files: &mut Vec<File>, notes: &mut Vec<String>) -> Result<bool> {
    let refuse = |what: String| Err(Error::Unsupported { format: "CDB store", what });
    if let Some(previous) = metadata::previous_version(store)? {
        return refuse(format!(
            "{VERSION_XML} continues the version {previous}, whose tiles would be hidden; make a further version of it"
        ));
    }
    let Some(text) = store::read_text(store, VERSION_XML)? else {
        let version = metadata::version_xml(&model.marking, &model.comment, None);
        files.push(File { path: VERSION_XML.into(), bytes: version.into_bytes(), media_type: "application/xml" });
        for file in metadata::schemas(&model.marking) {
            if !store::exists(store, &file.path)? {
                files.push(file);
            }
        }
        return Ok(true);
    };
    let version = xml::parse(&text).map_err(|e| store::unreadable(VERSION_XML, &e))?;
    let said = version.child_text("Comment").unwrap_or_default();
    if !said.contains(&model.marking) {
        notes.push(format!("{VERSION_XML} of the store does not say {}: it is left as it is.", model.marking));
    }
    Ok(false)
}

/// The geocell's material table with the model's material; returns the index.
fn material_files(store: &dyn Store, model: &Model, tile: Tile, files: &mut Vec<File>) -> Result<u32> {
    let path = names::path(tile, VECTOR_MATERIAL, (1, 1), "xml");
    let existing = store::read_text(store, &path)?;
    let (text, index) = material::table_with(existing.as_deref(), &model.material, &model.marking)
        .map_err(|e| store::unreadable(&path, &e))?;
    files.extend(text.map(|t| File { path, bytes: t.into_bytes(), media_type: "application/xml" }));
    Ok(index)
}
