//! The formats to publish, and one way to publish them: for photos and for files.

mod target;

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use orb_formats::{File, cdb, glb, openflight, spz};

use super::ground::{GroundArgs, GroundFiles};
use crate::audit::Publication;
use crate::audit::statement::Param;
use crate::export::{self, Catalogue, Labels, PlacedLevel};
use crate::geo::Placement;
use crate::splat::Gaussians;
use crate::{Error, Result};

use target::write_cdb;
pub use target::{OldVersion, OpenStore, Target};

/// What to publish.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub enum Format {
    /// OGC CDB store.
    Cdb,
    /// OpenFlight 16.0, all levels in one file.
    Flt,
    /// glTF, one binary file a level.
    Glb,
    /// USD package of the finest level, for AR viewers.
    Usdz,
    /// OGC 3D Tiles 1.1: tileset.json and a GLB a level.
    Tiles3d,
    /// The finest level for Google Earth: KML with a COLLADA model; from photos only.
    Kmz,
    /// Gaussians, uncompressed.
    Ply,
    /// Gaussians, quantised.
    Spz,
    /// Gaussians in glTF (KHR_gaussian_splatting).
    SplatGlb,
}

impl Format {
    /// How many levels to make where `asked` for so many: a CDB model's coarsest level has at most 128 vertices, each finer
    /// one at most four times as many, and clients look for the next finer level at the next LOD (OGC CDB 1.x Volume 6, table
    /// 6-25), so that a store gets all four.
    pub fn levels_made(formats: &[Format], asked: usize) -> usize {
        if formats.contains(&Format::Cdb) { asked.max(4) } else { asked }
    }

    /// Formats that hold a surface in levels of detail.
    pub fn has_levels(self, tiles: TileContent) -> bool {
        let tiled = self == Format::Tiles3d && tiles == TileContent::Mesh;
        tiled || matches!(self, Format::Cdb | Format::Flt | Format::Glb)
    }

    /// The names of a list, for the record.
    pub fn names(formats: &[Format]) -> String {
        let names = formats.iter().filter_map(|f| f.to_possible_value()).map(|v| v.get_name().to_owned());
        names.collect::<Vec<_>>().join(",")
    }
}

/// Versions of SPZ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum SpzVersion {
    #[value(name = "2")]
    V2,
    /// Read by the most programs that keep rotations well.
    #[default]
    #[value(name = "3")]
    V3,
    #[value(name = "4")]
    V4,
}

impl From<SpzVersion> for spz::Version {
    fn from(version: SpzVersion) -> Self {
        match version {
            SpzVersion::V2 => spz::Version::V2,
            SpzVersion::V3 => spz::Version::V3,
            SpzVersion::V4 => spz::Version::V4,
        }
    }
}

/// Records that hold the triangles of an OpenFlight file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum FltGeometry {
    /// A face a triangle: every reader shows it.
    #[default]
    Faces,
    /// A mesh a level: a third of the size, but some readers draw nothing.
    Meshes,
}

impl From<FltGeometry> for openflight::Geometry {
    fn from(geometry: FltGeometry) -> Self {
        match geometry {
            FltGeometry::Faces => openflight::Geometry::Faces,
            FltGeometry::Meshes => openflight::Geometry::Meshes,
        }
    }
}

/// What is drawn where 3D Tiles are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum TileContent {
    /// The surface, in levels of detail.
    #[default]
    Mesh,
    /// The Gaussians (KHR_gaussian_splatting); of one subject in one tile.
    Splats,
}

/// Where a CDB store keeps the model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum StoreKind {
    /// One of its kind, in the tiles of its place (GSModel).
    #[default]
    Gs,
    /// One of the library, which any number of features may show (GTModel).
    Gt,
    /// One that simulations move, under its DIS entity type (MModel).
    Moving,
}

/// How the formats are written: the same for photos and for files.
#[derive(Args, Clone, Debug)]
pub struct WriteArgs {
    /// Version of SPZ files.
    #[arg(long, value_enum, default_value_t)]
    pub spz_version: SpzVersion,

    /// Records for the triangles of an OpenFlight file.
    #[arg(long, value_enum, default_value_t)]
    pub flt_geometry: FltGeometry,

    /// Add the model to this existing CDB store, in place of a new store in the published folder.
    #[arg(long, value_name = "STORE")]
    pub cdb: Option<PathBuf>,

    /// Leave this CDB store as it is, and make a new version of it that adds the model: the published store names the old
    /// one by a relative path, so the two are moved together.
    #[arg(long, value_name = "STORE", conflicts_with = "cdb")]
    pub cdb_version_of: Option<PathBuf>,

    /// What a CDB store takes the model for. Its place becomes a feature in any case.
    #[arg(long = "as", value_enum, default_value_t)]
    pub kind: StoreKind,

    /// DIS entity type of a moving model: kind.domain.country.category, and subcategory.specific.extra where they are not 0.
    #[arg(long, value_name = "TYPE")]
    pub dis: Option<String>,

    /// Feature code of the model in a CDB store: two letters and three digits, then the subcode.
    #[arg(long, value_name = "FACC[/FSC]", default_value = "UA005/000")]
    pub facc: String,

    /// What the model is made of: base materials of CDB such as metal-steel, brick:70+glass:30, or layers from the
    /// surface inwards, paint/metal-steel. Default: assumed from the feature code.
    #[arg(long, value_name = "MATERIAL")]
    pub material: Option<String>,

    #[command(flatten)]
    pub ground: GroundArgs,

    /// What the tiles of 3D Tiles hold.
    #[arg(long, value_enum, default_value_t)]
    pub tiles: TileContent,

    /// Put the Gaussians beside the mesh of a USDZ, as OpenUSD's ParticleField3DGaussianSplat (26.03 and later).
    #[arg(long)]
    pub usdz_splats: bool,

    /// Compress the meshes of GLB files (EXT_meshopt_compression, KHR_mesh_quantization): a fraction of the geometry's size,
    /// for readers that know both.
    #[arg(long)]
    pub meshopt: bool,
}

impl WriteArgs {
    /// How the meshes of GLB files are stored.
    pub fn compression(&self) -> glb::Compression {
        if self.meshopt { glb::Compression::Meshopt } else { glb::Compression::None }
    }

    /// What a store files the model under.
    ///
    /// # Errors
    /// Usage for codes and materials that are none, and for an entity type beside or without `--as moving`.
    pub fn catalogue(&self) -> Result<Catalogue> {
        let (facc, fsc) = feature_code(&self.facc)?;
        let wrong = |option: &str, e: orb_formats::Error| Error::usage(option).found(e.to_string());
        let kind = match (self.kind, &self.dis) {
            (StoreKind::Gs, None) => cdb::Kind::Geospecific,
            (StoreKind::Gt, None) => cdb::Kind::Geotypical,
            (StoreKind::Moving, Some(text)) => {
                cdb::Kind::Moving(cdb::EntityType::parse(text).map_err(|e| wrong("--dis", e))?)
            }
            (StoreKind::Moving, None) => {
                return Err(Error::usage("--dis")
                    .expected("the DIS entity type of a moving model")
                    .found("none")
                    .advice("A car of the United States is --dis 1.1.225.27."));
            }
            (_, Some(text)) => {
                return Err(Error::usage("--dis")
                    .expected("--as moving beside it")
                    .found(format!("`{text}` for a model that does not move")));
            }
        };
        let material = match &self.material {
            Some(text) => cdb::Material::parse(text).map_err(|e| wrong("--material", e))?,
            None => cdb::Material::assumed(&facc),
        };
        Ok(Catalogue { kind, facc, fsc, material })
    }

    /// Where a CDB store is written; `output` is the folder to be published.
    ///
    /// # Errors
    /// As [`lock_store`] and [`OldVersion::open`].
    pub fn target(&self, output: &Path, stem: &str) -> Result<Target> {
        match (&self.cdb, &self.cdb_version_of) {
            (Some(root), _) => OpenStore::open(root).map(Target::Into),
            (None, Some(old)) => OldVersion::open(old, &output.join(format!("{stem}.cdb"))).map(Target::VersionOf),
            (None, None) => Ok(Target::New),
        }
    }

    /// What the record tells of it.
    pub fn params(&self, catalogue: &Catalogue) -> Vec<(String, Param)> {
        let mut all = vec![
            ("feature_code".into(), Param::Text(self.facc.clone())),
            ("material".into(), Param::Text(catalogue.material.summary())),
            ("material_source".into(), Param::Text(catalogue.material.name.to_lowercase())),
        ];
        if self.ground.ground {
            all.push(("ground".into(), Param::Bool(true)));
        }
        let kind = self.kind.to_possible_value().map(|v| Param::Text(v.get_name().into()));
        all.extend(kind.map(|k| ("store_kind".into(), k)));
        if let cdb::Kind::Moving(entity) = &catalogue.kind {
            all.push(("dis_entity_type".into(), Param::Text(entity.to_string())));
        }
        all
    }
}

/// What there is to write.
pub struct Content<'a> {
    /// Finest first; needed where a format has a surface.
    pub levels: &'a [PlacedLevel],
    /// How many of them are written, but into a CDB store, which gets all ([`Format::levels_made`]).
    pub shown: usize,
    pub gaussians: Option<&'a Gaussians>,
    pub placement: &'a Placement,
    pub labels: &'a Labels,
    pub catalogue: &'a Catalogue,
    pub spz: spz::Version,
    pub flt_geometry: openflight::Geometry,
    pub tiles: TileContent,
    pub usdz_splats: bool,
    /// How the meshes of GLB files are stored.
    pub compression: glb::Compression,
}

/// Writes every format that was asked for, each once. Returns the model's name in the CDB store, if one was written.
///
/// # Errors
/// Usage where the content has nothing for a format; what a writer or the publication refuses.
pub fn publish(
    formats: &[Format],
    content: &Content,
    mut target: Target,
    mut ground: Option<GroundFiles>,
    publication: &mut Publication,
) -> Result<Option<String>> {
    let mut model_name = None;
    let mut once = formats.to_vec();
    once.sort_unstable();
    once.dedup();
    let Content { placement, labels, catalogue, .. } = *content;
    let levels = &content.levels[..content.levels.len().min(content.shown.max(1))];
    for format in once {
        let gaussians = || {
            content.gaussians.ok_or_else(|| {
                Error::usage("--format")
                    .expected("a format with a surface: cdb, flt, glb, usdz or tiles3d")
                    .found(format!("{}, and an input without Gaussians", Format::names(&[format])))
            })
        };
        let (role, files): (&str, Vec<File>) = match format {
            Format::Cdb => {
                let model = export::cdb_model(content.levels, placement, labels, catalogue);
                model_name =
                    Some(write_cdb(&model, &labels.stem, std::mem::take(&mut target), ground.take(), publication)?);
                continue;
            }
            Format::Flt => ("model", export::flt(levels, content.flt_geometry, placement, labels)?),
            Format::Glb => ("model", export::glb(levels, content.compression, placement, labels)?),
            Format::Usdz => {
                let field = content.usdz_splats.then(gaussians).transpose()?;
                ("model", vec![export::usdz(levels, field, placement, labels)?])
            }
            Format::Tiles3d if content.tiles == TileContent::Splats => {
                ("gaussians", export::splat_tiles3d(gaussians()?, placement, labels)?)
            }
            Format::Tiles3d => ("model", export::tiles3d(levels, placement, labels)?),
            Format::Kmz => {
                return Err(Error::usage("--format")
                    .expected("a format that files are exported to")
                    .found("kmz")
                    .advice("It is written from photos, by orb geo."));
            }
            Format::Ply => ("gaussians", vec![export::scene_ply(gaussians()?, placement, labels)?]),
            Format::Spz => ("gaussians", vec![export::spz(gaussians()?, labels, content.spz)?]),
            Format::SplatGlb => ("gaussians", vec![export::splat_glb(gaussians()?, placement, labels)?]),
        };
        for file in files {
            publication.add(&file.path, &file.bytes, file.media_type, role)?;
        }
    }
    Ok(model_name)
}

/// `AL015`, `AL015/004`: two capital letters, three digits, a subcode from 0 to 999.
///
/// # Errors
/// Usage for anything else.
pub fn feature_code(text: &str) -> Result<(String, u16)> {
    let (code, sub) = text.split_once('/').unwrap_or((text, "0"));
    let good = code.len() == 5
        && code[..].bytes().take(2).all(|b| b.is_ascii_uppercase())
        && code.bytes().skip(2).all(|b| b.is_ascii_digit());
    match sub.parse::<u16>() {
        Ok(sub) if good && sub <= 999 => Ok((code.to_owned(), sub)),
        _ => {
            Err(Error::usage("--facc").expected("a feature code such as UA005 or AL015/016").found(format!("`{text}`")))
        }
    }
}

/// A file's name without its extension: letters, digits, `_` and `-`, 24 at most, first two alphanumeric.
pub fn safe_stem(file: &Path) -> String {
    let name = file.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let keep = |c: char| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' };
    let safe: String = name.chars().map(keep).take(24).collect();
    let head = safe.bytes().take(2).filter(u8::is_ascii_alphanumeric).count();
    if head == 2 { safe } else { format!("m0{safe}").chars().take(24).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stems_are_safe_names() {
        for (path, stem) in [
            ("a/smart_car.jpg", "smart_car"),
            ("IMG 0012 (3).JPG", "IMG_0012__3_"),
            ("_x.png", "m0_x"),
            ("é.png", "m0_"),
            ("a-very-long-name-of-a-photo-indeed.tif", "m0a-very-long-name-of-a-"),
        ] {
            assert_eq!(safe_stem(Path::new(path)), stem);
        }
    }

    #[test]
    fn feature_codes() {
        assert_eq!(feature_code("AL015/016").unwrap(), ("AL015".into(), 16));
        assert_eq!(feature_code("UA005").unwrap(), ("UA005".into(), 0));
        for bad in ["al015", "AL15", "AL015/1000", "AL015/x", "ÄA005", ""] {
            assert!(feature_code(bad).is_err(), "{bad}");
        }
    }
}
