//! Rules 1, 3, 4, 5, 7, 8 and 9 for the features, held against the models.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

use super::Findings;
use super::geometry::{LevelFacts, Models};
use crate::Result;
use crate::cdb::features::{CLASSES, FeatureTile, POINTS};
use crate::cdb::geocell::{Geocell, LODS, Tile};
use crate::cdb::lod;
use crate::cdb::model::Size;
use crate::cdb::names::{self, GS_FEATURE, TileFile, VECTOR_MATERIAL};
use crate::cdb::shapefile::PointZ;
use crate::cdb::store::{ListableStore, exists, read_text};
use crate::cdb::{material, xml};

/// Sizes are stored to a millimetre, HGT to a centimetre.
const MILLIMETRE: f64 = 1.1e-3;
const CENTIMETRE: f64 = 0.0101;

/// One placed model: point (bits of longitude, latitude) and `FACC_FSC_MODL`.
type Placed = (Geocell, u64, u64, String);

pub fn check(
    store: &dyn ListableStore,
    files: &[(String, TileFile)],
    models: &Models,
    findings: &mut Findings,
) -> Result<()> {
    let is_points = |f: &TileFile| f.dataset == GS_FEATURE && f.selector == POINTS && f.extension == "shp";
    let tiles: BTreeSet<Tile> = files.iter().filter(|(_, f)| is_points(f)).map(|(_, f)| f.tile).collect();
    let mut rows: BTreeMap<Placed, BTreeMap<i8, i8>> = BTreeMap::new();
    let mut used = BTreeSet::new();
    let mut materials = BTreeMap::new();
    let mut classes: BTreeMap<(Geocell, String), String> = BTreeMap::new();
    for &tile in &tiles {
        let path = names::path(tile, GS_FEATURE, POINTS, "shp");
        check_files(store, tile, &tiles, &path, findings)?;
        let content = match FeatureTile::read(store, tile, (1900, 1, 1)) {
            Ok(Some(content)) => content,
            Ok(None) => continue,
            Err(e) => {
                findings.add(3, &path, e.to_string());
                continue;
            }
        };
        if content.points.len() > lod::max_points(tile.lod) {
            findings.add(
                3,
                &path,
                format!("{} points, at most {} are allowed", content.points.len(), lod::max_points(tile.lod)),
            );
        }
        let materials = match materials.entry(tile.cell) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(new) => new.insert(material_indices(store, tile.cell, findings)?),
        };
        for (r, point) in content.points.iter().enumerate() {
            let Some(p) = point.filter(|_| !content.instances.is_deleted(r)) else { continue };
            let mut row = Row { tile, path: &path, number: r, point: p, content: &content, findings };
            row.check_place();
            row.check_material(materials);
            let Some((key, mlod)) = row.check_model(models, &mut used) else { continue };
            rows.entry((tile.cell, p.x.to_bits(), p.y.to_bits(), key)).or_default().insert(tile.lod, mlod);
        }
        for c in 0..content.classes.len() {
            let text = |name| content.classes.text(c, name).unwrap_or_default();
            let class = [text("FACC"), text("FSC"), text("MODL")].join("/");
            let known = classes.entry((tile.cell, text("CNAM"))).or_insert_with(|| class.clone());
            if *known != class {
                findings.add(1, &path, format!("the class {} is {class} here and {known} elsewhere", text("CNAM")));
            }
        }
    }
    check_repeats(&rows, &tiles, models, findings);
    check_uniqueness(&rows, findings);
    for ((tile, key), facts) in &models.levels {
        if !used.contains(&(*tile, key.clone())) {
            findings.add(1, &facts.path, format!("no feature places the model {key} of this tile"));
        }
    }
    Ok(())
}

/// Rule 3: the files of a tile, and the tile above it.
fn check_files(
    store: &dyn ListableStore,
    tile: Tile,
    tiles: &BTreeSet<Tile>,
    path: &str,
    findings: &mut Findings,
) -> Result<()> {
    for (selector, extension) in [(POINTS, "shx"), (POINTS, "dbf"), (CLASSES, "dbf")] {
        let beside = names::path(tile, GS_FEATURE, selector, extension);
        if !exists(store, &beside)? {
            findings.add(3, path, format!("{beside} is missing"));
        }
    }
    if let Some(parent) = tile.parent().filter(|p| !tiles.contains(p)) {
        let above = names::path(parent, GS_FEATURE, POINTS, "shp");
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
    fn check_model(&mut self, models: &Models, used: &mut BTreeSet<(Tile, String)>) -> Option<(String, i8)> {
        let text = |name| self.content.text(self.number, name);
        let model_name = text("MODL")?;
        if text("MODT").is_some_and(|t| t == "T") {
            return None;
        }
        let (facc, fsc) = (text("FACC").unwrap_or_default(), self.number_of("FSC").unwrap_or(-1.0));
        let key = names::feature_code(&facc, fsc as u16) + "_" + &model_name;
        if names::check_feature_code(&facc, fsc as u16).is_err() || fsc < 0.0 {
            self.add(1, format!("the feature code {facc}/{fsc} is none"));
        }
        if self.content.class_of(self.number).is_none() {
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
            let path = names::path(tile, GS_FEATURE, POINTS, "shp");
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
            let path = names::path(tile, GS_FEATURE, POINTS, "shp");
            findings.add(4, &path, format!("{key} stands here, but its coarsest level is of LOD {coarsest}"));
        }
        let mut coarser: Option<f64> = None;
        for (lod, facts) in &levels {
            let limit = lod::max_vertices((lod - coarsest).unsigned_abs().into());
            if facts.vertices > limit {
                findings.add(5, &facts.path, format!("{key} has {} vertices, this LOD takes {limit}", facts.vertices));
            }
            if coarser.is_some_and(|c| facts.significant_size >= c) {
                findings.add(
                    5,
                    &facts.path,
                    format!("{key}: the significant size does not decrease from the coarser level"),
                );
            }
            coarser = Some(facts.significant_size);
        }
        if finest_facts.centre.iter().any(|c| c.abs() > 1e-3) {
            let [cx, cy] = finest_facts.centre;
            let text = format!("{key}: the centre of the bounding rectangle is ({cx:.4}, {cy:.4}) m, not the origin");
            findings.add(7, &finest_facts.path, text);
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
