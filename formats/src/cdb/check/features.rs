//! Rules 1, 3, 4, 5, 7, 8 and 9 for the features, held against the models.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

use super::Findings;
use super::flt::{self, LevelFacts};
use super::geometry::Models;
use super::library::{Library, LibraryModel};
use crate::Result;
use crate::cdb::attributes::{GEOSPECIFIC, GEOTYPICAL, Layer, MOVING};
use crate::cdb::dis::EntityType;
use crate::cdb::features::FeatureTile;
use crate::cdb::geocell::{Geocell, LODS, Tile};
use crate::cdb::lod;
use crate::cdb::model::Size;
use crate::cdb::names::{self, TileFile, VECTOR_MATERIAL};
use crate::cdb::shapefile::PointZ;
use crate::cdb::store::{ListableStore, exists, read_text};
use crate::cdb::{material, xml};

/// Sizes are stored to a millimetre, HGT to a centimetre.
const MILLIMETRE: f64 = 1.1e-3;
const CENTIMETRE: f64 = 0.0101;

/// One placed model: point (bits of longitude, latitude) and `FACC_FSC_MODL`.
type Placed = (Geocell, u64, u64, String);

/// Checks the features of every layer.
pub fn check(
    store: &dyn ListableStore,
    files: &[(String, TileFile)],
    models: &Models,
    library: &Library,
    findings: &mut Findings,
) -> Result<()> {
    let mut materials = BTreeMap::new();
    for layer in Layer::all() {
        let is_points =
            |f: &TileFile| f.dataset == layer.dataset && f.selector == layer.points() && f.extension == "shp";
        let tiles: BTreeSet<Tile> = files.iter().filter(|(_, f)| is_points(f)).map(|(_, f)| f.tile).collect();
        let mut all = Features { layer, tiles, rows: BTreeMap::new(), used: BTreeSet::new() };
        all.check(store, models, library, &mut materials, findings)?;
        if *layer == GEOSPECIFIC {
            check_repeats(&all.rows, &all.tiles, models, findings);
            check_uniqueness(&all.rows, findings);
            for ((tile, key), facts) in &models.levels {
                if !all.used.contains(&(*tile, key.clone())) {
                    findings.add(1, &facts.path, format!("no feature places the model {key} of this tile"));
                }
            }
        } else {
            check_inherited(layer, &all.rows, &all.tiles, findings);
        }
    }
    Ok(())
}

/// What is known of each geocell's material table.
type Materials = BTreeMap<Geocell, Option<BTreeSet<u32>>>;

/// The features of a layer.
struct Features {
    layer: &'static Layer,
    tiles: BTreeSet<Tile>,
    /// MLOD in each tile that shows the feature; of moving models the tile's own level.
    rows: BTreeMap<Placed, BTreeMap<i8, i8>>,
    /// Models in tiles that some feature places.
    used: BTreeSet<(Tile, String)>,
}

impl Features {
    fn check(
        &mut self,
        store: &dyn ListableStore,
        models: &Models,
        library: &Library,
        materials: &mut Materials,
        findings: &mut Findings,
    ) -> Result<()> {
        let layer = self.layer;
        let mut classes: BTreeMap<(Geocell, String), String> = BTreeMap::new();
        for &tile in &self.tiles {
            let path = names::path(tile, layer.dataset, layer.points(), "shp");
            // A tile that was deleted has no other files.
            if !exists(store, &path)? {
                continue;
            }
            check_files(store, layer, tile, &self.tiles, &path, findings)?;
            let content = match FeatureTile::read(store, layer, tile, (1900, 1, 1)) {
                Ok(Some(content)) => content,
                Ok(None) => continue,
                Err(e) => {
                    findings.add(3, &path, e.to_string());
                    continue;
                }
            };
            let (count, limit) = (content.points.len(), lod::max_points(tile.lod));
            if count > limit {
                findings.add(3, &path, format!("{count} points, at most {limit} are allowed"));
            }
            let materials = match materials.entry(tile.cell) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(new) => new.insert(material_indices(store, tile.cell, findings)?),
            };
            for (r, point) in content.points.iter().enumerate() {
                let Some(p) = point.filter(|_| !content.instances.is_deleted(r)) else { continue };
                let mut row = Row { layer, tile, path: &path, number: r, point: p, content: &content, findings };
                row.check_place();
                if *layer != MOVING {
                    row.check_material(materials);
                }
                let Some((key, mlod)) = row.check_model(models, library, &mut self.used) else { continue };
                let placed = (tile.cell, p.x.to_bits(), p.y.to_bits(), key);
                self.rows.entry(placed).or_default().insert(tile.lod, mlod);
            }
            for c in 0..content.classes.len() {
                let text = |name| content.classes.text(c, name).unwrap_or_default();
                let class = [text("FACC"), text("FSC"), text(layer.model_name())].join("/");
                let known = classes.entry((tile.cell, text("CNAM"))).or_insert_with(|| class.clone());
                if *known != class {
                    let cnam = text("CNAM");
                    findings.add(1, &path, format!("the class {cnam} is {class} here and {known} elsewhere"));
                }
            }
        }
        Ok(())
    }
}

/// Rule 3: the files of a tile, and the tile above it.
fn check_files(
    store: &dyn ListableStore,
    layer: &Layer,
    tile: Tile,
    tiles: &BTreeSet<Tile>,
    path: &str,
    findings: &mut Findings,
) -> Result<()> {
    for (selector, extension) in [(layer.points(), "shx"), (layer.points(), "dbf"), (layer.classes(), "dbf")] {
        let beside = names::path(tile, layer.dataset, selector, extension);
        if !exists(store, &beside)? {
            findings.add(3, path, format!("{beside} is missing"));
        }
    }
    if let Some(parent) = tile.parent().filter(|p| !tiles.contains(p)) {
        let above = names::path(parent, layer.dataset, layer.points(), "shp");
        findings.add(3, path, format!("the pyramid has a gap: {above} is missing"));
    }
    Ok(())
}

/// Rule 9: the indices of a geocell's material table; `None` without a table.
fn material_indices(
    store: &dyn ListableStore,
    cell: Geocell,
    findings: &mut Findings,
) -> Result<Option<BTreeSet<u32>>> {
    let tile = Tile { cell, lod: 0, up: 0, right: 0 };
    let path = names::path(tile, VECTOR_MATERIAL, (1, 1), "xml");
    let Some(text) = read_text(store, &path)? else { return Ok(None) };
    let root = match xml::parse(&text) {
        Ok(root) if root.local_name() == "Composite_Material_Table" => root,
        Ok(root) => {
            findings.add(12, &path, format!("expected the root Composite_Material_Table, found {}", root.name));
            return Ok(None);
        }
        Err(e) => {
            findings.add(12, &path, e.to_string());
            return Ok(None);
        }
    };
    let mut indices = BTreeSet::new();
    for m in root.children_named("Composite_Material") {
        let index = m.attribute("index").and_then(|i| i.trim().parse().ok());
        if !index.is_some_and(|i| indices.insert(i)) {
            findings.add(9, &path, format!("an index is missing, no number or used twice: {:?}", m.attribute("index")));
        }
        if material::base_names(m).next().is_none() || material::base_names(m).any(|b| !b.starts_with("BM_")) {
            findings.add(9, &path, format!("composite material {index:?} names no base material BM_…"));
        }
    }
    Ok(Some(indices))
}

/// One feature of a tile.
struct Row<'a> {
    layer: &'static Layer,
    tile: Tile,
    path: &'a str,
    number: usize,
    point: PointZ,
    content: &'a FeatureTile,
    findings: &'a mut Findings,
}

impl Row<'_> {
    fn add(&mut self, rule: u8, text: String) {
        self.findings.add(rule, self.path, format!("feature {}: {text}", self.number + 1));
    }

    fn number_of(&self, name: &str) -> Option<f64> {
        self.content.number(self.number, name)
    }

    fn check_place(&mut self) {
        let PointZ { x, y, .. } = self.point;
        if !self.tile.contains(y, x) {
            self.add(3, format!("the point {y}, {x} does not lie in the tile"));
        }
        if let Some(a) = self.number_of("AO1").filter(|a| !(0.0..360.0).contains(a)) {
            self.add(8, format!("AO1 is {a}, expected 0 ≤ AO1 < 360"));
        }
    }

    fn check_material(&mut self, indices: &Option<BTreeSet<u32>>) {
        match (self.number_of("CMIX"), indices) {
            (None, _) => self.add(9, "CMIX is missing".into()),
            (Some(_), None) => self.add(9, "the geocell has no table for CMIX".into()),
            (Some(i), Some(known)) if !known.contains(&(i as u32)) || i.fract() != 0.0 => {
                self.add(9, format!("CMIX {i} is not in the geocell's material table"));
            }
            _ => {}
        }
    }

    /// Rules 1, 4 and 8; returns the model's key and its MLOD.
    fn check_model(
        &mut self,
        models: &Models,
        library: &Library,
        used: &mut BTreeSet<(Tile, String)>,
    ) -> Option<(String, i8)> {
        let text = |name| self.content.text(self.number, name);
        let model_name = text(self.layer.model_name())?;
        let has_class = self.content.class_of(self.number).is_some();
        if *self.layer == MOVING {
            if !has_class {
                self.add(1, "its CNAM names no class of the tile".into());
            }
            let entity = EntityType::parse(&model_name).ok().filter(|e| e.code() == model_name);
            match entity {
                None => self.add(1, format!("MMDC {model_name} is no code of seven numbers")),
                Some(entity) => self.check_library(library.moving.get(&entity), &model_name),
            }
            return Some((model_name, self.tile.lod));
        }
        let (facc, fsc) = (text("FACC").unwrap_or_default(), self.number_of("FSC").unwrap_or(-1.0));
        let typical = text("MODT").map_or(*self.layer == GEOTYPICAL, |t| t == "T");
        let key = names::feature_code(&facc, fsc as u16) + "_" + &model_name;
        if names::check_feature_code(&facc, fsc as u16).is_err() || fsc < 0.0 {
            self.add(1, format!("the feature code {facc}/{fsc} is none"));
        }
        if !has_class {
            self.add(1, "its CNAM names no class of the tile".into());
        }
        let mlod = self.number_of("MLOD").filter(|m| LODS.contains(&(*m as i8)) && m.fract() == 0.0);
        let Some(mlod) = mlod.map(|m| m as i8) else {
            self.add(4, "MLOD is missing or no level of detail".into());
            return None;
        };
        if mlod > self.tile.lod {
            self.add(4, format!("MLOD {mlod} is finer than the tile"));
        }
        if typical {
            let model = library.typical.get(&key);
            self.check_library(model, &key);
            if model.is_some_and(|m| !m.levels.contains_key(&i32::from(mlod))) {
                self.add(4, format!("the model {key} has no level of LOD {mlod}"));
            }
            // A feature among the geospecific ones is not held against the tiles of models.
            return (*self.layer == GEOTYPICAL).then_some((key, mlod));
        }
        let Ok(tile) = Tile::containing(self.point.y, self.point.x, mlod) else { return None };
        if !models.levels.contains_key(&(tile, key.clone())) {
            self.add(
                1,
                format!("the model {key} is not in {}", names::path(tile, names::GS_MODEL_GEOMETRY, (1, 1), "zip")),
            );
        }
        if !models.descriptors.contains(&(tile, key.clone())) {
            self.add(
                1,
                format!(
                    "the descriptor {key} is not in {}",
                    names::path(tile, names::GS_MODEL_DESCRIPTOR, (1, 1), "zip")
                ),
            );
        }
        let levels = levels_of(models, self.point.y, self.point.x, &key);
        let size = levels.iter().fold(Size::default(), |s, (_, f)| s.max(f.size));
        if !levels.is_empty() {
            self.check_sizes(size);
        }
        used.extend(
            levels
                .keys()
                .filter_map(|&l| Tile::containing(self.point.y, self.point.x, l).ok())
                .map(|t| (t, key.clone())),
        );
        Some((key, mlod))
    }

    /// Rules 1 and 8 for a model of a library.
    fn check_library(&mut self, model: Option<&LibraryModel>, key: &str) {
        match model {
            Some(model) if model.has_geometry => self.check_sizes(model.size()),
            _ => self.add(1, format!("the model {key} is not in the library")),
        }
    }

    fn check_sizes(&mut self, size: Size) {
        for (name, is, tolerance, needed) in [
            ("BSR", size.sphere, MILLIMETRE, true),
            ("HGT", size.height, CENTIMETRE, true),
            ("BBH", size.height, MILLIMETRE, false),
            ("BBL", size.length, MILLIMETRE, false),
            ("BBW", size.width, MILLIMETRE, false),
        ] {
            match self.number_of(name) {
                Some(said) if (said - is).abs() > tolerance => {
                    self.add(8, format!("{name} is {said}, the geometry's is {is:.3}"));
                }
                None if needed => self.add(8, format!("{name} is missing")),
                _ => {}
            }
        }
    }
}

fn levels_of<'a>(models: &'a Models, latitude: f64, longitude: f64, key: &str) -> BTreeMap<i8, &'a LevelFacts> {
    let level = |lod| {
        let tile = Tile::containing(latitude, longitude, lod).ok()?;
        Some((lod, models.levels.get(&(tile, key.to_string()))?))
    };
    LODS.filter_map(level).collect()
}

/// Rules 4, 5 and 7 over all levels of each model, and its features in all tiles.
fn check_repeats(
    rows: &BTreeMap<Placed, BTreeMap<i8, i8>>,
    tiles: &BTreeSet<Tile>,
    models: &Models,
    findings: &mut Findings,
) {
    for ((_, x, y, key), mlods) in rows {
        let (longitude, latitude) = (f64::from_bits(*x), f64::from_bits(*y));
        let levels = levels_of(models, latitude, longitude, key);
        let (Some((&coarsest, _)), Some((_, finest_facts))) = (levels.first_key_value(), levels.last_key_value())
        else {
            continue;
        };
        for lod in coarsest..=23 {
            let Ok(tile) = Tile::containing(latitude, longitude, lod) else { continue };
            let best = levels.range(..=lod).next_back().map(|(l, _)| *l);
            let path = names::path(tile, GEOSPECIFIC.dataset, GEOSPECIFIC.points(), "shp");
            match mlods.get(&lod) {
                None if tiles.contains(&tile) || levels.contains_key(&lod) => {
                    findings.add(4, &path, format!("the feature of {key} should stand here"))
                }
                Some(mlod) if Some(*mlod) != best => {
                    findings.add(4, &path, format!("MLOD of {key} is {mlod}, its best level here is {best:?}"));
                }
                _ => {}
            }
        }
        if let Some(early) = mlods.keys().find(|l| **l < coarsest)
            && let Ok(tile) = Tile::containing(latitude, longitude, *early)
        {
            let path = names::path(tile, GEOSPECIFIC.dataset, GEOSPECIFIC.points(), "shp");
            findings.add(4, &path, format!("{key} stands here, but its coarsest level is of LOD {coarsest}"));
        }
        let steps = levels.iter().map(|(lod, facts)| ((lod - coarsest).unsigned_abs().into(), *facts));
        flt::check_levels(key, steps, findings);
        flt::check_centre(finest_facts, key, findings);
    }
}

/// Rule 4 for features of library models: a finer tile that is there repeats what the coarser one shows.
fn check_inherited(
    layer: &Layer,
    rows: &BTreeMap<Placed, BTreeMap<i8, i8>>,
    tiles: &BTreeSet<Tile>,
    findings: &mut Findings,
) {
    for ((_, x, y, key), shown) in rows {
        let first = shown.keys().next().copied().unwrap_or(23);
        for lod in first..=23 {
            let Ok(tile) = Tile::containing(f64::from_bits(*y), f64::from_bits(*x), lod) else { continue };
            if tiles.contains(&tile) && !shown.contains_key(&lod) {
                let path = names::path(tile, layer.dataset, layer.points(), "shp");
                findings.add(4, &path, format!("the feature of {key} should stand here"));
            }
        }
    }
}

/// Rule 11: a model's name belongs to one model of its geocell.
fn check_uniqueness(rows: &BTreeMap<Placed, BTreeMap<i8, i8>>, findings: &mut Findings) {
    let mut places: BTreeMap<(Geocell, String), Tile> = BTreeMap::new();
    for ((cell, x, y, key), mlods) in rows {
        let finest = mlods.values().max().copied().unwrap_or(0);
        let Ok(tile) = Tile::containing(f64::from_bits(*y), f64::from_bits(*x), finest) else { continue };
        let other = *places.entry((*cell, key.to_lowercase())).or_insert(tile);
        if other != tile {
            let path = names::path(tile, names::GS_MODEL_GEOMETRY, (1, 1), "zip");
            findings.add(
                11,
                &path,
                format!(
                    "{key} is also the name of a model in {}",
                    names::base(other, names::GS_MODEL_GEOMETRY, (1, 1))
                ),
            );
        }
    }
}
