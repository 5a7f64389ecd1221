//! The point features of one tile and [`Layer`]: points with instance attributes, and the table of their classes.
//!
//! Source: OGC CDB 1.x Volume 1, "Tiled vector datasets" (Requirements 64, 107).

use std::cell::OnceCell;
use std::collections::{HashMap, HashSet};

use super::attributes::{Attribute, Layer};
use super::dbf::{Table, Value};
use super::geocell::Tile;
use super::names;
use super::shapefile::{self, PointZ};
use super::store::{self, Store};
use crate::{Error, File, Result};

/// The features of a tile.
#[derive(Clone, Debug)]
pub struct FeatureTile {
    layer: &'static Layer,
    pub points: Vec<Option<PointZ>>,
    /// One record a point.
    pub instances: Table,
    pub classes: Table,
    /// The first record of each class, once it is asked for: most tiles are read to add one feature.
    class_records: OnceCell<HashMap<Vec<u8>, usize>>,
    /// Files beside the tables that a new tile needs as its parent has them: extended attributes, memos.
    companions: Vec<((u16, u16), &'static str, Vec<u8>)>,
}

impl FeatureTile {
    /// A tile without features.
    pub fn new(layer: &'static Layer, date: (u16, u8, u8)) -> FeatureTile {
        let table = |wanted: fn(&Attribute) -> bool| {
            Table::new(layer.attributes.iter().filter(|a| wanted(a)).map(Attribute::column).collect(), date)
        };
        let (instances, classes) = (table(|a| a.instance), table(|a| a.class));
        let (points, companions) = (Vec::new(), Vec::new());
        FeatureTile { layer, points, instances, classes, class_records: OnceCell::new(), companions }
    }

    /// Reads the features of a tile; `None` when it has no shapefile.
    ///
    /// # Errors
    /// What stands in the way of keeping the features: unreadable or inconsistent files.
    pub fn read(
        store: &dyn Store,
        layer: &'static Layer,
        tile: Tile,
        date: (u16, u8, u8),
    ) -> Result<Option<FeatureTile>> {
        let path = names::path(tile, layer.dataset, layer.points(), "shp");
        let Some(shp) = store::read(store, &path)? else { return Ok(None) };
        let points = shapefile::read(&shp).map_err(|e| store::unreadable(&path, &e))?;
        let path = names::path(tile, layer.dataset, layer.points(), "dbf");
        let Some(instances) = read_table(store, &path)? else {
            return Err(store::unreadable(&path, &"the table of the shapefile is missing"));
        };
        if instances.len() != points.len() {
            let what = format!("{} records for {} points", instances.len(), points.len());
            return Err(store::unreadable(&path, &what));
        }
        let classes = read_table(store, &names::path(tile, layer.dataset, layer.classes(), "dbf"))?;
        let classes = classes.unwrap_or_else(|| FeatureTile::new(layer, date).classes);
        let class_records = OnceCell::new();
        Ok(Some(FeatureTile { layer, points, instances, classes, class_records, companions: Vec::new() }))
    }

    /// The features that lie in a tile one level finer, as that tile must repeat them when it comes into being.
    ///
    /// `tile` is this one. Their attributes stay: the best model level that was there is still the best.
    ///
    /// # Errors
    /// When a file beside the tables cannot be read.
    pub fn inherited(&self, store: &dyn Store, tile: Tile, finer: Tile) -> Result<FeatureTile> {
        let layer = self.layer;
        let mut out = FeatureTile {
            layer,
            points: Vec::new(),
            instances: self.instances.emptied(),
            classes: self.classes.emptied(),
            class_records: OnceCell::new(),
            companions: self.companions.clone(),
        };
        for (i, point) in self.points.iter().enumerate() {
            if point.is_some_and(|p| finer.contains(p.y, p.x)) && !self.instances.is_deleted(i) {
                out.points.push(*point);
                out.instances.push_from(&self.instances, i);
            }
        }
        let (instance, class) = (out.instances.field("CNAM"), self.classes.field("CNAM"));
        let instance = |r| out.instances.bytes(r, instance.as_ref()?);
        let class = |c| self.classes.bytes(c, class.as_ref()?);
        let used: HashSet<_> = (0..out.instances.len()).map(instance).collect();
        for i in (0..self.classes.len()).filter(|&i| used.contains(&class(i)) && !self.classes.is_deleted(i)) {
            out.classes.push_from(&self.classes, i);
        }
        if out.companions.is_empty() && !out.points.is_empty() {
            let mut wanted = vec![(layer.extended(), "dbf"), (layer.extended(), "dbt")];
            wanted.extend(self.instances.has_memo().then_some((layer.points(), "dbt")));
            wanted.extend(self.classes.has_memo().then_some((layer.classes(), "dbt")));
            for (selector, extension) in wanted {
                let bytes = store::read(store, &names::path(tile, layer.dataset, selector, extension))?;
                out.companions.extend(bytes.map(|b| (selector, extension, b)));
            }
        }
        Ok(out)
    }

    /// Adds a point and, unless it is there, its class.
    ///
    /// # Errors
    /// When a table has a column that cannot hold its value.
    pub fn add(&mut self, point: PointZ, value: &dyn Fn(&str) -> Value, date: (u16, u8, u8)) -> Result<()> {
        for a in self.layer.attributes.iter().filter(|a| a.needed) {
            if self.instances.column(a.name).is_none() && (a.name == "CNAM" || self.classes.column(a.name).is_none()) {
                insert(&mut self.instances, a)?;
            }
            let in_instances = a.name != "CNAM" && self.instances.column(a.name).is_some();
            if a.class && self.classes.column(a.name).is_none() && (self.classes.is_empty() || !in_instances) {
                insert(&mut self.classes, a)?;
            }
        }
        self.points.push(Some(point));
        let record = self.instances.push();
        fill(&mut self.instances, record, self.layer, value)?;
        if !self.has_class(record) {
            let class = self.classes.push();
            fill(&mut self.classes, class, self.layer, value)?;
            self.class_records = OnceCell::new();
        }
        self.instances.set_date(date);
        self.classes.set_date(date);
        Ok(())
    }

    /// An attribute of a feature: its own, else that of its class.
    pub fn text(&self, record: usize, name: &str) -> Option<String> {
        self.instances.text(record, name).or_else(|| self.classes.text(self.class_of(record)?, name))
    }

    pub fn number(&self, record: usize, name: &str) -> Option<f64> {
        self.instances.number(record, name).or_else(|| self.classes.number(self.class_of(record)?, name))
    }

    /// The record of a feature's class.
    pub fn class_of(&self, record: usize) -> Option<usize> {
        let records = self.class_records.get_or_init(|| index(&self.classes));
        records.get(self.instances.bytes(record, &self.instances.field("CNAM")?)?).copied()
    }

    /// Whether a feature's class is there: one look through the table, where [`FeatureTile::class_of`] makes an index.
    fn has_class(&self, record: usize) -> bool {
        let fields = (self.instances.field("CNAM"), self.classes.field("CNAM"));
        let (Some(instance), Some(class)) = fields else { return false };
        let name = self.instances.bytes(record, &instance);
        name.is_some() && (0..self.classes.len()).any(|c| self.classes.bytes(c, &class) == name)
    }

    /// Whether a model name or class name is in use here, whatever the case of its letters.
    pub fn uses(&self, model_name: &str, class_name: &str) -> bool {
        [&self.instances, &self.classes].into_iter().any(|t| {
            [(self.layer.model_name(), model_name), ("CNAM", class_name)].into_iter().any(|(column, name)| {
                let same = |b: &[u8]| b.eq_ignore_ascii_case(name.as_bytes());
                t.field(column).is_some_and(|f| (0..t.len()).any(|r| t.bytes(r, &f).is_some_and(same)))
            })
        })
    }

    /// The records of a model, whatever the case of its letters.
    pub fn rows_of<'a>(&'a self, model_name: &'a str) -> impl Iterator<Item = usize> {
        let column = self.layer.model_name();
        let (instance, class) = (self.instances.field(column), self.classes.field(column));
        (0..self.points.len()).filter(move |&r| {
            // Its own, else that of its class.
            let own = instance.as_ref().and_then(|f| self.instances.bytes(r, f));
            let name = own.or_else(|| self.classes.bytes(self.class_of(r)?, class.as_ref()?));
            name.is_some_and(|n| n.eq_ignore_ascii_case(model_name.as_bytes()))
        })
    }

    /// The tile's files.
    ///
    /// # Errors
    /// When a table has grown past its format.
    pub fn files(&self, tile: Tile) -> Result<Vec<File>> {
        let layer = self.layer;
        let file = |selector, extension, bytes, media_type| File {
            path: names::path(tile, layer.dataset, selector, extension),
            bytes,
            media_type,
        };
        let (shp, shx) = shapefile::write(&self.points);
        let mut files = vec![
            file(layer.points(), "shp", shp, "application/vnd.shp"),
            file(layer.points(), "shx", shx, "application/vnd.shx"),
            file(layer.points(), "dbf", self.instances.write()?, "application/vnd.dbf"),
            file(layer.classes(), "dbf", self.classes.write()?, "application/vnd.dbf"),
        ];
        for (selector, extension, bytes) in &self.companions {
            files.push(file(*selector, extension, bytes.clone(), "application/vnd.dbf"));
        }
        Ok(files)
    }
}

/// The first record of each class.
fn index(classes: &Table) -> HashMap<Vec<u8>, usize> {
    let Some(field) = classes.field("CNAM") else { return HashMap::new() };
    (0..classes.len()).rev().filter_map(|c| Some((classes.bytes(c, &field)?.to_vec(), c))).collect()
}

fn read_table(store: &dyn Store, path: &str) -> Result<Option<Table>> {
    let Some(bytes) = store::read(store, path)? else { return Ok(None) };
    Table::read(&bytes).map(Some).map_err(|e| store::unreadable(path, &e))
}

fn insert(table: &mut Table, attribute: &Attribute) -> Result<()> {
    // CNAM is the first column, the others follow what is there.
    let index = if attribute.name == "CNAM" { 0 } else { table.columns().len() };
    table.insert_column(index, attribute.column(), attribute.older().as_ref())
}

fn fill(table: &mut Table, record: usize, layer: &Layer, value: &dyn Fn(&str) -> Value) -> Result<()> {
    for a in layer.attributes {
        if let Some(column) = table.column(a.name) {
            table.set(record, column, &value(a.name)).map_err(|e| Error::Unsupported {
                format: "CDB features",
                what: format!("the attribute {} cannot be added: {e}", a.name),
            })?;
        }
    }
    Ok(())
}
