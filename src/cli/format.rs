//! The formats to publish, and one way to publish them: for photos and for files.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use orb_formats::{File, cdb, openflight, spz};

use crate::audit::{Publication, StoreLock, lock_store, merge_into_store};
use crate::export::{self, Labels, PlacedLevel};
use crate::geo::Placement;
use crate::splat::Gaussians;
use crate::{Error, Result};

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
    /// Formats that hold a surface in levels of detail.
    pub fn has_levels(self) -> bool {
        matches!(self, Format::Cdb | Format::Flt | Format::Glb | Format::Tiles3d)
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

/// What there is to write.
pub struct Content<'a> {
    /// Finest first; needed where a format has a surface.
    pub levels: &'a [PlacedLevel],
    pub gaussians: Option<&'a Gaussians>,
    pub placement: &'a Placement,
    pub labels: &'a Labels,
    pub spz: spz::Version,
    pub flt_geometry: openflight::Geometry,
}

/// Writes every format that was asked for, each once. Returns the model's name in the CDB store, if one was written.
///
/// # Errors
/// Usage where the content has nothing for a format; what a writer or the publication refuses.
pub fn publish(
    formats: &[Format],
    content: &Content,
    mut store: Option<OpenStore>,
    publication: &mut Publication,
) -> Result<Option<String>> {
    let mut model_name = None;
    let mut once = formats.to_vec();
    once.sort_unstable();
    once.dedup();
    let Content { levels, placement, labels, .. } = *content;
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
                let model = export::gs_model(levels, placement, labels);
                model_name = Some(write_cdb(&model, &labels.stem, store.take(), publication)?);
                continue;
            }
            Format::Flt => ("model", export::flt(levels, content.flt_geometry, placement, labels)?),
            Format::Glb => ("model", export::glb(levels, placement, labels)?),
            Format::Usdz => ("model", vec![export::usdz(levels, placement, labels)?]),
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

/// A store on disk, locked for this run.
pub struct OpenStore {
    lock: StoreLock,
    root: PathBuf,
}

impl OpenStore {
    /// # Errors
    /// As [`lock_store`].
    pub fn open(root: &Path) -> Result<OpenStore> {
        let lock = lock_store(root)?;
        Ok(OpenStore { lock, root: root.to_owned() })
    }
}

impl cdb::Store for OpenStore {
    fn read(&self, path: &str) -> std::io::Result<Option<Vec<u8>>> {
        match std::fs::read(self.root.join(path)) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(e) => Err(e),
        }
    }
}

/// Into the published folder as a store of its own, or into the store that was named. Returns the model's name there.
fn write_cdb(
    model: &cdb::GsModel,
    stem: &str,
    store: Option<OpenStore>,
    publication: &mut Publication,
) -> Result<String> {
    match store {
        None => {
            let added = cdb::add_model(&cdb::Empty, model).map_err(export::format_error)?;
            for folder in &added.folders {
                publication.add_folder(&format!("{stem}.cdb/{folder}"))?;
            }
            for file in &added.files {
                publication.add(&format!("{stem}.cdb/{}", file.path), &file.bytes, file.media_type, "cdb")?;
            }
            Ok(added.model_name)
        }
        Some(store) => {
            let added = cdb::add_model(&store, model).map_err(export::format_error)?;
            publication.merge(merge_into_store(store.lock, &added.files, &added.folders)?)?;
            Ok(added.model_name)
        }
    }
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
