//! File names of a CDB: each follows from the tile, the dataset and the model, and from nothing else.
//!
//! Source: OGC CDB 1.x Volume 1, "CDB Directory Structure and Naming" (Requirements 42, 65–72).

use super::geocell::{Geocell, LODS, Tile};
use crate::{Error, Result};

/// A tiled dataset: its code and the name of its folder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dataset {
    pub code: u16,
    pub name: &'static str,
}

pub const ELEVATION: Dataset = Dataset { code: 1, name: "001_Elevation" };
pub const MIN_MAX_ELEVATION: Dataset = Dataset { code: 2, name: "002_MinMaxElevation" };
pub const IMAGERY: Dataset = Dataset { code: 4, name: "004_Imagery" };
pub const GS_FEATURE: Dataset = Dataset { code: 100, name: "100_GSFeature" };
pub const GT_FEATURE: Dataset = Dataset { code: 101, name: "101_GTFeature" };
pub const VECTOR_MATERIAL: Dataset = Dataset { code: 200, name: "200_VectorMaterial" };
pub const GS_MODEL_GEOMETRY: Dataset = Dataset { code: 300, name: "300_GSModelGeometry" };
pub const GS_MODEL_TEXTURE: Dataset = Dataset { code: 301, name: "301_GSModelTexture" };
pub const GS_MODEL_DESCRIPTOR: Dataset = Dataset { code: 303, name: "303_GSModelDescriptor" };

/// The datasets that this crate reads and writes.
pub const DATASETS: [Dataset; 9] = [
    ELEVATION,
    MIN_MAX_ELEVATION,
    IMAGERY,
    GS_FEATURE,
    GT_FEATURE,
    VECTOR_MATERIAL,
    GS_MODEL_GEOMETRY,
    GS_MODEL_TEXTURE,
    GS_MODEL_DESCRIPTOR,
];

/// Longest MODL: CNAM joins FACC (5), FSC (3) and MODL in 32 characters.
pub const MAX_MODEL_NAME: usize = 24;

/// A level as file names spell it: `LC10` … `LC01`, `L00` … `L23`.
pub fn lod_name(lod: i8) -> String {
    if lod < 0 { format!("LC{:02}", -i16::from(lod)) } else { format!("L{lod:02}") }
}

/// A level as folders spell it: all negative ones share `LC`.
pub fn lod_folder(lod: i8) -> String {
    if lod < 0 { "LC".into() } else { lod_name(lod) }
}

pub fn lod_from_name(name: &str) -> Option<i8> {
    LODS.into_iter().find(|&lod| lod_name(lod) == name)
}

/// The name of a tile's file without extension: `N34W119_D300_S001_T001_L07_U70_R67`.
pub fn base(tile: Tile, dataset: Dataset, selector: (u16, u16)) -> String {
    format!(
        "{}{}_D{:03}_S{:03}_T{:03}_{}_U{}_R{}",
        tile.cell.latitude_name(),
        tile.cell.longitude_name(),
        dataset.code,
        selector.0,
        selector.1,
        lod_name(tile.lod),
        tile.up,
        tile.right
    )
}

/// The folder of a tile's files, relative to the CDB root: `Tiles/N34/W119/300_GSModelGeometry/L07/U70`.
pub fn folder(tile: Tile, dataset: Dataset) -> String {
    let (latitude, longitude) = (tile.cell.latitude_name(), tile.cell.longitude_name());
    format!("Tiles/{latitude}/{longitude}/{}/{}/U{}", dataset.name, lod_folder(tile.lod), tile.up)
}

/// The path of a tile's file, relative to the CDB root.
pub fn path(tile: Tile, dataset: Dataset, selector: (u16, u16), extension: &str) -> String {
    format!("{}/{}.{extension}", folder(tile, dataset), base(tile, dataset, selector))
}

/// What the path of a tiled file says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TileFile {
    pub tile: Tile,
    pub dataset: Dataset,
    pub selector: (u16, u16),
    pub extension: String,
}

/// Reads a path; `None` unless it is exactly what [`path`] writes for a dataset of [`DATASETS`].
pub fn parse(path_text: &str) -> Option<TileFile> {
    let parts: Vec<&str> = path_text.split('/').collect();
    let ["Tiles", latitude, longitude, dataset, _, _, file] = parts[..] else { return None };
    let cell = Geocell::from_names(latitude, longitude)?;
    let dataset = DATASETS.into_iter().find(|d| d.name == dataset)?;
    let (stem, extension) = file.split_once('.')?;
    let fields: Vec<&str> = stem.split('_').collect();
    let [_, _, s, t, lod, up, right] = fields[..] else { return None };
    let selector = (s.strip_prefix('S')?.parse().ok()?, t.strip_prefix('T')?.parse().ok()?);
    let (up, right) = (up.strip_prefix('U')?.parse().ok()?, right.strip_prefix('R')?.parse().ok()?);
    let lod = lod_from_name(lod)?;
    let tile = Tile { cell, lod, up, right };
    let rows = super::geocell::rows(lod);
    let exact = up < rows && right < rows && path(tile, dataset, selector, extension) == path_text;
    exact.then(|| TileFile { tile, dataset, selector, extension: extension.into() })
}

/// The feature code of a model as file names spell it: `UA005_000`.
pub fn feature_code(facc: &str, fsc: u16) -> String {
    format!("{facc}_{fsc:03}")
}

/// CNAM, the key of the class table: FACC, FSC and MODL joined, as clients that inflate it expect.
pub fn class_name(facc: &str, fsc: u16, model: &str) -> String {
    format!("{facc}{fsc:03}{model}")
}

/// Checks a feature code: two capital letters and three digits, subcode at most 999.
///
/// # Errors
/// [`Error::Unsupported`] with what was found.
pub fn check_feature_code(facc: &str, fsc: u16) -> Result<()> {
    let bytes = facc.as_bytes();
    let shaped = bytes.len() == 5
        && bytes[..2].iter().all(u8::is_ascii_uppercase)
        && bytes[2..].iter().all(u8::is_ascii_digit)
        && fsc <= 999;
    if shaped {
        return Ok(());
    }
    Err(Error::Unsupported {
        format: "CDB feature code",
        what: format!("expected two letters and three digits (UA005) and a subcode of 0-999, found {facc:?} and {fsc}"),
    })
}

/// Makes a model name of any text: letters, digits, `_` and `-`, the first two letters or digits, at most
/// [`MAX_MODEL_NAME`]. Other characters become `_`; a text without two usable characters becomes `Model`.
pub fn model_name(text: &str) -> String {
    let mut name = String::new();
    for c in text.chars() {
        let c = if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' };
        let leading = name.len() < 2 && !c.is_ascii_alphanumeric();
        let doubled = c == '_' && name.ends_with('_');
        if !leading && !doubled && name.len() < MAX_MODEL_NAME {
            name.push(c);
        }
    }
    let name = name.trim_end_matches('_');
    if name.len() < 2 { "Model".into() } else { name.into() }
}

/// A model name with a suffix, the name cut where both would exceed [`MAX_MODEL_NAME`].
pub fn with_suffix(name: &str, suffix: &str) -> String {
    let room = MAX_MODEL_NAME.saturating_sub(suffix.len() + 1);
    format!("{}_{suffix}", &name[..name.len().min(room)])
}

/// A short text that names a tile within its geocell: the place along the quadtree in base 36, `C07` at level −7.
pub fn tile_code(tile: Tile) -> String {
    if tile.lod < 0 {
        return format!("C{:02}", -i16::from(tile.lod));
    }
    // The leading 1 keeps levels apart.
    let mut n = (1u64 << (2 * tile.lod)) | (u64::from(tile.up) << tile.lod) | u64::from(tile.right);
    let mut code = Vec::new();
    while n > 0 {
        code.push(char::from_digit((n % 36) as u32, 36).unwrap_or('0'));
        n /= 36;
    }
    code.iter().rev().collect()
}

/// TNAM of a level's texture filed by texel size (with its mip chain).
pub fn texture_name(model: &str, level: usize) -> String {
    format!("{model}_{level}")
}

/// TNAM of a level's texture filed beside its geometry. Another name, because a mip of the first may fall into the same
/// archive.
pub fn tile_texture_name(model: &str, level: usize) -> String {
    format!("{model}_{level}_tile")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_the_standard_s_examples() {
        let fine = Tile::containing(34.5523, -118.4712, 7).unwrap();
        let coarse = Tile::containing(34.5523, -118.4712, -10).unwrap();
        assert_eq!(
            path(fine, GS_FEATURE, (1, 1), "shp"),
            "Tiles/N34/W119/100_GSFeature/L07/U70/N34W119_D100_S001_T001_L07_U70_R67.shp"
        );
        assert_eq!(
            path(coarse, GS_FEATURE, (1, 1), "shp"),
            "Tiles/N34/W119/100_GSFeature/LC/U0/N34W119_D100_S001_T001_LC10_U0_R0.shp"
        );
    }

    #[test]
    fn paths_read_back_and_others_do_not() {
        for (latitude, longitude) in [(34.5523, -118.4712), (62.3, -160.4), (-33.9, 151.2)] {
            for lod in LODS {
                let tile = Tile::containing(latitude, longitude, lod).unwrap();
                let text = path(tile, GS_MODEL_TEXTURE, (1, 1), "zip");
                let file = TileFile { tile, dataset: GS_MODEL_TEXTURE, selector: (1, 1), extension: "zip".into() };
                assert_eq!(parse(&text), Some(file));
            }
        }
        for wrong in [
            "Tiles/N34/W119/100_GSFeature/L07/U71/N34W119_D100_S001_T001_L07_U70_R67.shp",
            "Tiles/N34/W119/100_GSFeature/L07/U70/N34W119_D300_S001_T001_L07_U70_R67.shp",
            "Tiles/N34/W119/100_GSFeature/L07/U170/N34W119_D100_S001_T001_L07_U170_R67.shp",
            "Tiles/N34/W119/100_GSFeature/L07/U70/N34W119_D100_S001_T001_L07_U70_R067.shp",
            "Tiles/N34/W119/100_GSFeature/L07/U70/N34W118_D100_S001_T001_L07_U70_R67.shp",
            "Tiles/N34/W119/100_GSFeature/L07/U70/notes.txt",
            "Metadata/Version.xml",
        ] {
            assert_eq!(parse(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn model_names_keep_to_the_alphabet() {
        for (text, name) in [
            ("OrbVan", "OrbVan"),
            ("red van (2).jpg", "red_van_2_jpg"),
            ("_a-b", "ab"),
            ("a_b", "ab"),
            ("Überführung", "berf_hrung"),
            ("", "Model"),
            ("写真", "Model"),
            ("x", "Model"),
            ("abcdefghijklmnopqrstuvwxyz", "abcdefghijklmnopqrstuvwx"),
        ] {
            assert_eq!(model_name(text), name, "{text}");
        }
        assert_eq!(with_suffix("OrbVan", "2"), "OrbVan_2");
        assert_eq!(with_suffix("abcdefghijklmnopqrstuvwx", "12"), "abcdefghijklmnopqrstu_12");
        let longest = with_suffix(&model_name(&"x".repeat(40)), "9999");
        assert!(tile_texture_name(&longest, 7).len() <= 32);
        assert_eq!(class_name("UA005", 0, &longest).len(), 32);
    }

    #[test]
    fn tile_codes_tell_tiles_apart() {
        let mut seen = std::collections::BTreeSet::new();
        let cell = Geocell { south: 1, west: 2 };
        for lod in LODS.filter(|&l| l <= 4) {
            let n = super::super::geocell::rows(lod);
            for up in 0..n {
                for right in 0..n {
                    assert!(seen.insert(tile_code(Tile { cell, lod, up, right })));
                }
            }
        }
        let last = (1 << 23) - 1;
        assert!(tile_code(Tile { cell, lod: 23, up: last, right: last }).len() <= 10);
    }

    #[test]
    fn feature_codes_are_checked() {
        assert_eq!(check_feature_code("UA005", 0), Ok(()));
        for (facc, fsc) in
            [("ua005", 0), ("UA05", 0), ("UA0055", 0), ("U0055", 0), ("UA005", 1000), ("", 0), ("Ü005", 1)]
        {
            assert!(check_feature_code(facc, fsc).is_err(), "{facc}/{fsc}");
        }
    }
}
