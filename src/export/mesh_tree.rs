//! A scene's meshes as 3D Tiles: a quadtree of squares of the ground, four finer ones in place of each, one GLB a tile.
//!
//! All tiles lie in one frame, so that vertices which two of them have are the same f32 in both files; compression, which rounds
//! each file by its own bounds, would tear them apart. A tile's geometric
//! error is how far its surface lies from the finest one, or sixteen of its texels where that is more: viewers refine what
//! is off by sixteen pixels (CesiumJS's default), so a texel is drawn no wider than a pixel. A leaf's is none.

use std::collections::BTreeMap;

use orb_formats::asset::{EncodedImage, Material, Part};
use orb_formats::tiles3d::{self, Tileset, Volume};
use orb_formats::{Asset, File, glb};

use super::model::to_earth;
use super::{Labels, format_error, label, marked_png};
use crate::geo::Placement;
use crate::mesh::tiles::{At, Tile};
use crate::{Error, Result};

/// The folder.
pub const FOLDER: &str = "tiles3d-mesh";
/// Texels that count as error.
const TEXELS: f64 = 16.0;

/// What is known of the tiles written so far.
pub struct MeshTree<'a> {
    placement: &'a Placement,
    labels: &'a Labels,
    /// From the tiles' unit to metres about the placement's origin.
    to_metres: &'a dyn Fn(glam::Vec3) -> [f64; 3],
    /// By level, finest 0.
    tiles: BTreeMap<(usize, At), Known>,
}

/// Bounds and geometric error of a tile, metres.
type Known = ([f64; 3], [f64; 3], f64);

impl<'a> MeshTree<'a> {
    pub fn new(placement: &'a Placement, labels: &'a Labels, to_metres: &'a dyn Fn(glam::Vec3) -> [f64; 3]) -> Self {
        MeshTree { placement, labels, to_metres, tiles: BTreeMap::new() }
    }

    /// A tile as a file. `scale`: metres a unit.
    ///
    /// # Errors
    /// As the writer.
    pub fn add(&mut self, level: usize, at: At, tile: &Tile, scale: f64) -> Result<File> {
        let mesh = orb_formats::Mesh {
            positions: tile.mesh.positions.iter().map(|p| (self.to_metres)(*p)).collect(),
            normals: tile.mesh.normals.iter().map(|n| n.to_array()).collect(),
            uvs: tile.mesh.uvs.iter().map(|t| t.to_array()).collect(),
            triangles: tile.mesh.triangles.clone(),
        };
        let (low, high) = mesh.bounds().ok_or_else(|| Error::usage(FOLDER).found("a tile without a vertex"))?;
        let own = scale * f64::from(tile.error).max(TEXELS * f64::from(tile.texel));
        self.tiles.insert((level, at), (low, high, if level == 0 { 0.0 } else { own }));
        let image = marked_png(&tile.texture.clone().into(), &self.labels.marking)?;
        let asset = Asset {
            name: self.labels.stem.clone(),
            parts: vec![Part { mesh, material: Some(0) }],
            materials: vec![Material {
                name: self.labels.stem.clone(),
                image: Some(0),
                unlit: true,
                ..Material::default()
            }],
            images: vec![EncodedImage { media_type: "image/png".into(), bytes: image }],
            splats: None,
            label: label(self.placement, self.labels),
        };
        let bytes = glb::write(&asset).map_err(format_error)?;
        Ok(File { path: format!("{FOLDER}/{}", name(level, at)), bytes, media_type: "model/gltf-binary" })
    }

    /// `tileset.json` of all that was added.
    ///
    /// # Errors
    /// Where nothing was; as the writer.
    pub fn tileset(&self) -> Result<File> {
        let root = self.tiles.keys().next_back().copied();
        let (level, at) = root.ok_or_else(|| Error::usage(FOLDER).found("no tile"))?;
        let (mut root, low, high) = self.tile(level, at);
        root.transform = Some(to_earth(self.placement));
        let size = (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt();
        let gltf_extensions = vec!["KHR_materials_unlit".into(), "KHR_xmp_json_ld".into()];
        let tileset = Tileset {
            geometric_error: size.max(root.geometric_error),
            root,
            gltf_extensions,
            label: label(self.placement, self.labels),
        };
        let bytes = tiles3d::write(&tileset).map_err(format_error)?;
        Ok(File { path: format!("{FOLDER}/tileset.json"), bytes, media_type: "application/json" })
    }

    /// With what is below it; its bounds hold theirs, and it is worse than they are.
    fn tile(&self, level: usize, at: At) -> (tiles3d::Tile, [f64; 3], [f64; 3]) {
        let (mut low, mut high, mut error) = self.tiles.get(&(level, at)).copied().unwrap_or(([0.0; 3], [0.0; 3], 0.0));
        let mut children = Vec::new();
        if level > 0 {
            for k in 0..4 {
                let child = (level - 1, [2 * at[0] + (k & 1), 2 * at[1] + (k >> 1)]);
                if self.tiles.contains_key(&child) {
                    let (tile, l, h) = self.tile(child.0, child.1);
                    (0..3).for_each(|i| (low[i], high[i]) = (low[i].min(l[i]), high[i].max(h[i])));
                    error = error.max(1.01 * tile.geometric_error);
                    children.push(tile);
                }
            }
        }
        let tile = tiles3d::Tile {
            transform: None,
            volume: Volume::around(low, high),
            geometric_error: error,
            content: Some(name(level, at)),
            children,
        };
        (tile, low, high)
    }
}

fn name(level: usize, [x, y]: At) -> String {
    format!("l{level}_{x}_{y}.glb")
}
