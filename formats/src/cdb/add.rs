//! Adding a model to a store, new or existing.
//!
//! Only what stands at the model's place is read and written: the feature tiles along the quadtree, the archives of the
//! model's levels and textures, the geocell's material table. What is there is kept; what cannot be kept is refused.

use std::collections::BTreeMap;

use super::attributes;
use super::entries::{Archives, Entries};
use super::features::{FeatureTile, POINTS};
use super::geocell::{LODS, Tile};
use super::lod;
use super::material;
use super::metadata::{self, VERSION_XML};
use super::model::{self, GsModel, Prepared};
use super::names::{self, GS_FEATURE, VECTOR_MATERIAL};
use super::shapefile::PointZ;
use super::store::{self, Store};
use super::xml;
use crate::{Error, File, Result};

/// Most models of one name in one tile.
const MAX_NAMESAKES: usize = 9999;

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
    /// Significant size that each level's LOD node says, metres.
    pub significant_sizes: Vec<f64>,
    /// Geometry archive and entry of each level.
    pub geometry: Vec<(String, String)>,
    /// Attributes that were measured: height above ground, bounding sphere, metres; AO1, degrees.
    pub height: f64,
    pub bounding_sphere: f64,
    pub heading: f64,
    /// The base material of the model: assumed from the feature code, not measured.
    pub assumed_material: String,
    /// Features of others in the tiles that are rewritten: all kept.
    pub features_kept: usize,
    /// The store holds this very model at this place already.
    pub already_present: bool,
    /// What the user should know, as sentences.
    pub notes: Vec<String>,
}

/// Adds a model to a store.
///
/// MODL follows from [`GsModel::name`]. In a geocell that holds features already it gets the code of its tile as a suffix,
/// so that it is unique there without reading the geocell's other tiles; a namesake at the same place gets `_2`, `_3`, ….
/// The very same model at the same place is not added again.
///
/// # Errors
/// [`Error::Unsupported`] for a model that breaks a content rule, for a full tile, and for what cannot be kept: unreadable
/// files, other shape types, stores whose features lie in an older version's folder or in a GeoPackage.
pub fn add_model(store: &dyn Store, model: &GsModel) -> Result<Added> {
    let mut prepared = model::prepare(model)?;
    let mut files = Vec::new();
    let mut notes = std::mem::take(&mut prepared.notes);
    let new_store = metadata_files(store, model, &mut files, &mut notes)?;

    let chain = FeatureChain::read(store, model, &prepared)?;
    let archives = Archives::read(store, model, &prepared)?;
    let (name, mut entries, already_present) = chain.choose_name(model, &prepared, &archives)?;
    notes.append(&mut entries.notes);

    if already_present {
        notes.push(format!("The store holds this very model at this place already, as {name}: nothing was added."));
        files.clear();
    } else {
        let material = material_files(store, model, chain.tiles[&0], &mut files)?;
        chain.add(model, &prepared, &name, material, &mut files)?;
        for (path, bytes) in archives.with(&entries, &model.marking)? {
            files.push(File { path, bytes, media_type: "application/zip" });
        }
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));

    let code = names::feature_code(&model.facc, model.fsc);
    let geometry = prepared.levels.iter().map(|l| {
        let dataset = names::GS_MODEL_GEOMETRY;
        let entry = super::entries::entry_name(l.tile, dataset, &code, &name, "flt");
        (names::path(l.tile, dataset, super::entries::SELECTOR, "zip"), entry)
    });
    let cell = chain.tiles[&0].cell;
    Ok(Added {
        files,
        folders: if new_store { metadata::EMPTY_FOLDERS.map(String::from).to_vec() } else { Vec::new() },
        class_name: names::class_name(&model.facc, model.fsc, &name),
        geocell: cell.latitude_name() + &cell.longitude_name(),
        lods: prepared.levels.iter().map(|l| l.placed.lod).collect(),
        significant_sizes: prepared.levels.iter().map(|l| l.placed.significant_size).collect(),
        geometry: geometry.collect(),
        height: prepared.size.height,
        bounding_sphere: prepared.size.sphere,
        heading: prepared.heading,
        assumed_material: material::assumed(&model.facc).into(),
        features_kept: if already_present { 0 } else { chain.kept(&prepared) },
        model_name: name,
        already_present,
        notes,
    })
}

/// The Metadata of a new store; that of an existing one is left as it is. Returns whether the store is new.
fn metadata_files(store: &dyn Store, model: &GsModel, files: &mut Vec<File>, notes: &mut Vec<String>) -> Result<bool> {
    let refuse = |what: &str| Err(Error::Unsupported { format: "CDB store", what: what.into() });
    if store::exists(store, "Metadata/Configuration.xml")? {
        return refuse("Metadata/Configuration.xml joins several versions; add the model to a store of one version");
    }
    let Some(text) = store::read_text(store, VERSION_XML)? else {
        let version = metadata::version_xml(&model.marking, &model.comment);
        files.push(File { path: VERSION_XML.into(), bytes: version.into_bytes(), media_type: "application/xml" });
        for file in metadata::schemas(&model.marking) {
            if !store::exists(store, &file.path)? {
                files.push(file);
            }
        }
        return Ok(true);
    };
    let version = xml::parse(&text).map_err(|e| store::unreadable(VERSION_XML, &e))?;
    if let Some(previous) = version.child("PreviousIncrementalRootDirectory") {
        return refuse(&format!(
            "{VERSION_XML} continues the version {}, whose tiles would be hidden; add the model to a store of one version",
            previous.attribute("name").unwrap_or_default()
        ));
    }
    let said = version.child_text("Comment").unwrap_or_default();
    if !said.contains(&model.marking) {
        notes.push(format!("{VERSION_XML} of the store does not say {}: it is left as it is.", model.marking));
    }
    Ok(false)
}

/// The geocell's material table with the model's material; returns the index.
fn material_files(store: &dyn Store, model: &GsModel, tile: Tile, files: &mut Vec<File>) -> Result<u32> {
    let path = names::path(tile, VECTOR_MATERIAL, (1, 1), "xml");
    let existing = store::read_text(store, &path)?;
    let (text, index) = material::table_with(existing.as_deref(), material::assumed(&model.facc), &model.marking)
        .map_err(|e| store::unreadable(&path, &e))?;
    files.extend(text.map(|t| File { path, bytes: t.into_bytes(), media_type: "application/xml" }));
    Ok(index)
}

/// The feature tiles along the quadtree at the model's place.
struct FeatureChain {
    tiles: BTreeMap<i8, Tile>,
    /// The features of each tile that will be written, without the new one: read, or inherited from the parent tile.
    contents: BTreeMap<i8, FeatureTile>,
    /// Whether the geocell holds feature tiles.
    populated: bool,
}

impl FeatureChain {
    fn read(store: &dyn Store, model: &GsModel, prepared: &Prepared) -> Result<FeatureChain> {
        let (coarsest, finest) = (prepared.coarsest(), prepared.finest());
        let mut tiles = BTreeMap::new();
        for lod in LODS {
            tiles.insert(lod, Tile::containing(model.latitude, model.longitude, lod)?);
        }
        let exists = |tile: &Tile, extension| store::exists(store, &names::path(*tile, GS_FEATURE, POINTS, extension));
        if exists(&tiles[&-10], "gpkg")? {
            return Err(Error::Unsupported {
                format: "CDB store",
                what: format!(
                    "{} keeps its features in GeoPackages; expected shapefiles",
                    names::folder(tiles[&-10], GS_FEATURE)
                ),
            });
        }
        let mut there = BTreeMap::new();
        for (&lod, tile) in &tiles {
            there.insert(lod, exists(tile, "shp")?);
        }
        let mut contents: BTreeMap<i8, FeatureTile> = BTreeMap::new();
        let mut coarser: Option<FeatureTile> = None;
        for (&lod, &tile) in &tiles {
            let next_inherits = lod < finest && !there[&(lod + 1)];
            let read = match there[&lod] && (lod >= coarsest || next_inherits) {
                true => FeatureTile::read(store, tile, model.dbf_date)?,
                false => None,
            };
            // A file of no bytes counts as none, so a tile may be absent although its file is there.
            let absent = read.is_none() && lod <= finest && (!there[&lod] || lod >= coarsest || next_inherits);
            let written = absent || (read.is_some() && lod >= coarsest);
            let content = match (read, &coarser) {
                (None, Some(parent)) if absent => Some(parent.inherited(store, tiles[&(lod - 1)], tile)?),
                (None, None) if absent => Some(FeatureTile::new(model.dbf_date)),
                (read, _) => read,
            };
            if let (true, Some(content)) = (written, &content) {
                contents.insert(lod, content.clone());
            }
            coarser = content;
        }
        Ok(FeatureChain { populated: there.values().any(|&t| t), tiles, contents })
    }

    /// The first free name, its entries, and whether the very model is there under it.
    fn choose_name(
        &self,
        model: &GsModel,
        prepared: &Prepared,
        archives: &Archives,
    ) -> Result<(String, Entries, bool)> {
        let finest = prepared.finest();
        let plain = &prepared.name;
        // Without features in the geocell the plain name is free. It is also the one to number from where the model that
        // took it stands in the same tile; anywhere else the tile's code keeps apart what cannot be seen from here.
        let namesake = self.contents[&finest]
            .rows_of(plain)
            .any(|r| self.contents[&finest].number(r, "MLOD") == Some(f64::from(finest)));
        let code = names::tile_code(self.tiles[&finest]);
        let coded = self.populated && !namesake;
        for n in 1..=MAX_NAMESAKES {
            let name = match (coded, n) {
                (false, 1) => plain.clone(),
                (false, n) => names::with_suffix(plain, &n.to_string()),
                (true, 1) => names::with_suffix(plain, &code),
                (true, n) => names::with_suffix(plain, &format!("{code}_{n}")),
            };
            let class = names::class_name(&model.facc, model.fsc, &name);
            let taken = self.contents.values().any(|c| c.uses(&name, &class));
            let here = self.stands_here(model, prepared, &name);
            if taken && !here {
                continue;
            }
            let entries = Entries::build(model, prepared, archives, &name)?;
            if here && archives.hold(&entries) {
                return Ok((name, entries, true));
            }
            if !taken && !archives.collide(&entries) {
                return Ok((name, entries, false));
            }
        }
        Err(Error::Unsupported {
            format: "CDB model",
            what: format!("more than {MAX_NAMESAKES} models named {plain} stand in one tile; choose another name"),
        })
    }

    fn stands_here(&self, model: &GsModel, prepared: &Prepared, name: &str) -> bool {
        let content = &self.contents[&prepared.finest()];
        content.rows_of(name).any(|r| {
            content.number(r, "AO1") == Some(prepared.heading)
                && content.points[r].is_some_and(|p| (p.x, p.y, p.z) == (model.longitude, model.latitude, model.height))
        })
    }

    /// Others' features in the tiles that get the new one, each counted once.
    fn kept(&self, prepared: &Prepared) -> usize {
        self.contents.get(&prepared.coarsest()).map_or(0, |c| c.points.len())
    }

    fn add(
        &self,
        model: &GsModel,
        prepared: &Prepared,
        name: &str,
        material: u32,
        files: &mut Vec<File>,
    ) -> Result<()> {
        let point = PointZ { x: model.longitude, y: model.latitude, z: model.height, m: 0.0 };
        for (&lod, content) in &self.contents {
            let tile = self.tiles[&lod];
            let mut content = content.clone();
            if lod >= prepared.coarsest() {
                let best = lod.min(prepared.finest());
                let value = |a: &str| attributes::value(a, model, prepared, name, material, best);
                content.add(point, &value, model.dbf_date)?;
            }
            let (count, limit) = (content.points.len(), lod::max_points(lod));
            if count > limit && lod >= prepared.coarsest() {
                return Err(Error::Unsupported {
                    format: "CDB features",
                    what: format!(
                        "{} is full: it would hold {count} points, LOD {lod} takes {limit}",
                        names::path(tile, GS_FEATURE, POINTS, "shp")
                    ),
                });
            }
            files.extend(content.files(tile)?);
        }
        Ok(())
    }
}

impl FeatureTile {
    /// The records of a model, whatever the case of its letters.
    fn rows_of<'a>(&'a self, model_name: &'a str) -> impl Iterator<Item = usize> {
        (0..self.points.len())
            .filter(move |&r| self.text(r, "MODL").is_some_and(|m| m.eq_ignore_ascii_case(model_name)))
    }
}
