//! The feature tiles along the quadtree at a model's place.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::attributes::{self, Layer};
use super::features::FeatureTile;
use super::geocell::{LODS, Tile};
use super::lod;
use super::model::{Kind, Model, Prepared};
use super::names;
use super::shapefile::PointZ;
use super::store::{self, Store};
use crate::{Error, File, Result};

/// The tiles and what they hold.
pub struct FeatureChain {
    layer: &'static Layer,
    pub tiles: BTreeMap<i8, Tile>,
    /// The features of each tile that will be written, without the new one: read, or inherited from the parent tile.
    pub contents: BTreeMap<i8, Rc<FeatureTile>>,
    /// The finest tile that is made for the model.
    pub reach: i8,
    /// Whether the geocell holds feature tiles.
    pub populated: bool,
}

impl FeatureChain {
    pub fn read(store: &dyn Store, model: &Model, prepared: &Prepared) -> Result<FeatureChain> {
        let layer = Layer::of(&model.kind);
        // A model of a library brings its levels along: its feature stands where the coarsest is seen first.
        let reach = if model.kind == Kind::Geospecific { prepared.finest() } else { prepared.coarsest() };
        let coarsest = prepared.coarsest();
        let mut tiles = BTreeMap::new();
        for lod in LODS {
            tiles.insert(lod, Tile::containing(model.latitude, model.longitude, lod)?);
        }
        let exists = |tile: &Tile, extension| {
            store::exists(store, &names::path(*tile, layer.dataset, layer.points(), extension))
        };
        if exists(&tiles[&-10], "gpkg")? {
            return Err(Error::Unsupported {
                format: "CDB store",
                what: format!(
                    "{} keeps its features in GeoPackages; expected shapefiles",
                    names::folder(tiles[&-10], layer.dataset)
                ),
            });
        }
        let mut there = BTreeMap::new();
        for (&lod, tile) in &tiles {
            there.insert(lod, exists(tile, "shp")?);
        }
        let mut contents: BTreeMap<i8, Rc<FeatureTile>> = BTreeMap::new();
        let mut coarser: Option<Rc<FeatureTile>> = None;
        for (&lod, &tile) in &tiles {
            let next_inherits = lod < reach && !there[&(lod + 1)];
            let read = match there[&lod] && (lod >= coarsest || next_inherits) {
                true => FeatureTile::read(store, layer, tile, model.dbf_date)?,
                false => None,
            };
            let absent = lod <= reach && !there[&lod];
            let written = absent || (read.is_some() && lod >= coarsest);
            let content = match (read, &coarser) {
                (None, Some(parent)) if absent => Some(parent.inherited(store, tiles[&(lod - 1)], tile)?),
                (None, None) if absent => Some(FeatureTile::new(layer, model.dbf_date)),
                (read, _) => read,
            };
            let content = content.map(Rc::new);
            if let (true, Some(content)) = (written, &content) {
                contents.insert(lod, content.clone());
            }
            coarser = content;
        }
        Ok(FeatureChain { layer, reach, populated: there.values().any(|&t| t), tiles, contents })
    }

    /// Whether this very feature stands here: the same model, place and heading.
    pub fn stands_here(&self, model: &Model, prepared: &Prepared, name: &str) -> bool {
        let content = &self.contents[&self.reach];
        content.rows_of(name).any(|r| {
            content.number(r, "AO1") == Some(prepared.heading)
                && content.points[r].is_some_and(|p| (p.x, p.y, p.z) == (model.longitude, model.latitude, model.height))
        })
    }

    /// Others' features in the tiles that get the new one, each counted once.
    pub fn kept(&self, prepared: &Prepared) -> usize {
        self.contents.get(&prepared.coarsest()).map_or(0, |c| c.points.len())
    }

    /// The files of the tiles with the model's feature added; `material` is its index in the geocell's table.
    ///
    /// # Errors
    /// When a tile is full, or a table cannot hold a value.
    pub fn add(
        self,
        model: &Model,
        prepared: &Prepared,
        name: &str,
        material: u32,
        files: &mut Vec<File>,
    ) -> Result<()> {
        let point = PointZ { x: model.longitude, y: model.latitude, z: model.height, m: 0.0 };
        for (lod, content) in self.contents {
            let tile = self.tiles[&lod];
            let mut content = Rc::unwrap_or_clone(content);
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
                        names::path(tile, self.layer.dataset, self.layer.points(), "shp")
                    ),
                });
            }
            files.extend(content.files(tile)?);
        }
        Ok(())
    }
}
