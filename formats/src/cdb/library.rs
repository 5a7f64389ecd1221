//! File names of the model libraries: geotypical models (GTModel) and moving models (MModel).
//!
//! Source: OGC CDB 1.x Volume 1, "GTModel library datasets" (Requirements 45–56) and "MModel library datasets". Nothing is
//! archived here: every file stands by itself, in folders named by codes and their labels.

use super::codes::{self, Labels};
use super::dis::EntityType;
use super::names;
use crate::Result;

pub const TYPICAL_GEOMETRY: &str = "GTModel/500_GTModelGeometry";
pub const TYPICAL_TEXTURE: &str = "GTModel/501_GTModelTexture";
pub const MOVING_GEOMETRY: &str = "MModel/600_MModelGeometry";
pub const MOVING_TEXTURE: &str = "MModel/601_MModelTexture";

/// The folder of a geotypical model, by its feature code: `…/A_Culture/L_Misc_Feature/015_Building`.
///
/// # Errors
/// [`Error::Unsupported`](crate::Error::Unsupported) for a code without labels.
pub fn typical_folder(labels: &Labels, facc: &str) -> Result<String> {
    names::check_feature_code(facc, 0)?;
    match labels.feature(facc) {
        [Some(category), Some(subcategory), Some(kind)] => Ok(format!(
            "{TYPICAL_GEOMETRY}/{}_{category}/{}_{subcategory}/{}_{kind}",
            &facc[..1],
            &facc[1..2],
            &facc[2..]
        )),
        _ => Err(codes::unknown("the feature code", facc, "Feature_Data_Dictionary")),
    }
}

/// The folder of a moving model: `…/1_Platform/1_Land/225_United_States/1_Tank/1_1_225_1_1_8_0`.
///
/// # Errors
/// [`Error::Unsupported`](crate::Error::Unsupported) for a code without a name.
pub fn moving_folder(labels: &Labels, entity: &EntityType) -> Result<String> {
    let code = entity.to_string();
    match labels.entity(entity) {
        [Some(kind), Some(domain), Some(country), Some(category)] => Ok(format!(
            "{MOVING_GEOMETRY}/{}_{kind}/{}_{domain}/{}_{country}/{}_{category}/{}",
            entity.kind,
            entity.domain,
            entity.country,
            entity.category,
            entity.code()
        )),
        [_, _, None, _] => Err(codes::unknown("the country of", &code, "DIS_Country_Codes")),
        _ => Err(codes::unknown("the DIS entity type", &code, "Moving_Model_Codes")),
    }
}

/// The folder of a texture: the first two characters of its name in upper case, then the name.
pub fn texture_folder(dataset: &str, texture: &str) -> String {
    let letter = |i: usize| texture.get(i..=i).unwrap_or("_").to_ascii_uppercase();
    format!("{dataset}/{}/{}/{texture}", letter(0), letter(1))
}

/// `D500_S001_T001_AL015_000_House.flt`: what refers to the levels.
pub fn typical_entry(key: &str) -> String {
    format!("D500_S001_T001_{key}.flt")
}

/// `D503_S001_T001_AL015_000_House.xml`.
pub fn typical_descriptor(key: &str) -> String {
    format!("D503_S001_T001_{key}.xml")
}

/// `L04/D510_S001_T001_L04_AL015_000_House.flt`, below the folder of the entry file.
pub fn typical_level(lod: i8, key: &str) -> String {
    format!("{}/D510_S001_T001_{}_{key}.flt", names::lod_folder(lod), names::lod_name(lod))
}

/// `D511_S001_T001_L06_House_0.rgb`.
pub fn typical_texture(lod: i8, texture: &str) -> String {
    format!("D511_S001_T001_{}_{texture}.rgb", names::lod_name(lod))
}

/// `D600_S001_T001_1_1_225_1_1_8_0.flt`.
pub fn moving_geometry(code: &str) -> String {
    format!("D600_S001_T001_{code}.flt")
}

/// `D603_S001_T001_1_1_225_1_1_8_0.xml`.
pub fn moving_descriptor(code: &str) -> String {
    format!("D603_S001_T001_{code}.xml")
}

/// `D601_S001_T001_W10_M1A2.rgb`; `power` is that of two of the larger side.
pub fn moving_texture(power: u32, texture: &str) -> String {
    format!("D601_S001_T001_W{power:02}_{texture}.rgb")
}

/// What the path of a library's file says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LibraryFile {
    /// `FACC_FSC_MODL`.
    TypicalEntry {
        key: String,
    },
    TypicalDescriptor {
        key: String,
    },
    TypicalLevel {
        lod: i8,
        key: String,
    },
    TypicalTexture {
        lod: i8,
        name: String,
    },
    /// `part`: 1 for the model itself.
    MovingGeometry {
        entity: EntityType,
        part: u16,
    },
    MovingDescriptor {
        entity: EntityType,
    },
    MovingTexture {
        power: u32,
        name: String,
    },
}

/// Reads a path.
///
/// # Errors
/// What is wrong with the path of a library's geometry, descriptor or texture. `Ok(None)` for other files.
pub fn parse(path: &str, labels: &Labels) -> Result<Option<LibraryFile>, String> {
    let (folder, file) = path.rsplit_once('/').unwrap_or_default();
    let Some((dataset, rest)) = file.split_once('_').filter(|_| is_model_folder(folder)) else { return Ok(None) };
    let shape = |text: &str| format!("the name should be {text}");
    match dataset {
        "D500" | "D503" => {
            let (_, name) = selectors(rest).ok_or_else(|| shape("Dnnn_Snnn_Tnnn_FACC_FSC_MODL"))?;
            let (key, extension) = split_extension(name);
            check_typical(folder, key, labels)?;
            check_extension(extension, if dataset == "D500" { "flt" } else { "xml" })?;
            let key = key.to_string();
            Ok(Some(match dataset {
                "D500" => LibraryFile::TypicalEntry { key },
                _ => LibraryFile::TypicalDescriptor { key },
            }))
        }
        "D510" => {
            let (lod, name) = leveled(rest).ok_or_else(|| shape("D510_Snnn_Tnnn_Lnn_FACC_FSC_MODL.flt"))?;
            let (key, extension) = split_extension(name);
            check_extension(extension, "flt")?;
            let (above, last) = folder.rsplit_once('/').unwrap_or_default();
            if last != names::lod_folder(lod) {
                return Err(format!("a file of {} lies in {last}", names::lod_name(lod)));
            }
            check_typical(above, key, labels)?;
            Ok(Some(LibraryFile::TypicalLevel { lod, key: key.into() }))
        }
        "D511" => {
            let (lod, name) = leveled(rest).ok_or_else(|| shape("D511_Snnn_Tnnn_Lnn_TNAM.rgb"))?;
            let name = check_texture(folder, TYPICAL_TEXTURE, name)?;
            Ok(Some(LibraryFile::TypicalTexture { lod, name }))
        }
        "D600" | "D603" => {
            let (part, name) = selectors(rest).ok_or_else(|| shape("Dnnn_Snnn_Tnnn_MMDC"))?;
            let (code, extension) = split_extension(name);
            check_extension(extension, if dataset == "D600" { "flt" } else { "xml" })?;
            let entity = EntityType::parse(code).ok().filter(|e| e.code() == code);
            let entity = entity.ok_or_else(|| format!("{code} is no code of seven numbers"))?;
            check_moving(folder, &entity, labels)?;
            Ok(Some(match dataset {
                "D600" => LibraryFile::MovingGeometry { entity, part },
                _ => LibraryFile::MovingDescriptor { entity },
            }))
        }
        "D601" => {
            let wrong = || shape("D601_Snnn_Tnnn_Wnn_TNAM.rgb");
            let (_, name) = selectors(rest).ok_or_else(wrong)?;
            let (power, name) = name.split_once('_').ok_or_else(wrong)?;
            let power = power.strip_prefix('W').filter(|p| p.len() == 2).and_then(|p| p.parse().ok());
            let name = check_texture(folder, MOVING_TEXTURE, name)?;
            Ok(Some(LibraryFile::MovingTexture { power: power.ok_or_else(wrong)?, name }))
        }
        _ => Ok(None),
    }
}

fn is_model_folder(folder: &str) -> bool {
    [TYPICAL_GEOMETRY, TYPICAL_TEXTURE, MOVING_GEOMETRY, MOVING_TEXTURE].iter().any(|d| folder.starts_with(d))
}

/// `S001_T002_rest`: the second number and the rest.
fn selectors(text: &str) -> Option<(u16, &str)> {
    let mut parts = text.splitn(3, '_');
    let number = |part: Option<&str>, letter: char| {
        let digits = part?.strip_prefix(letter).filter(|d| d.len() == 3)?;
        digits.parse::<u16>().ok()
    };
    number(parts.next(), 'S')?;
    Some((number(parts.next(), 'T')?, parts.next()?))
}

/// `S001_T001_L06_rest`: the level and the rest.
fn leveled(text: &str) -> Option<(i8, &str)> {
    let (lod, name) = selectors(text)?.1.split_once('_')?;
    Some((names::lod_from_name(lod)?, name))
}

fn split_extension(name: &str) -> (&str, &str) {
    name.rsplit_once('.').unwrap_or((name, ""))
}

fn check_extension(found: &str, expected: &str) -> Result<(), String> {
    if found == expected { Ok(()) } else { Err(format!("the extension should be {expected}, found {found:?}")) }
}

/// Whether the folders are those of the feature code, as far as its labels are known.
fn check_typical(folder: &str, key: &str, labels: &Labels) -> Result<(), String> {
    let (facc, rest) = key.split_once('_').unwrap_or((key, ""));
    let (fsc, model) = rest.split_once('_').unwrap_or((rest, ""));
    let fsc = fsc.parse().ok().filter(|_| fsc.len() == 3).unwrap_or(u16::MAX);
    if names::check_feature_code(facc, fsc).is_err() || model.is_empty() {
        return Err(format!("{key} should be a feature code, a subcode of three digits and the model's name"));
    }
    let parts: Vec<&str> = folder.split('/').collect();
    let codes = [&facc[..1], &facc[1..2], &facc[2..]];
    let [_, _, labeled @ ..] = &parts[..] else { return Err("it lies in no folder of a feature code".into()) };
    if parts[..2].join("/") != TYPICAL_GEOMETRY || labeled.len() != 3 {
        return Err(format!("expected {TYPICAL_GEOMETRY} and a folder each for category, subcategory and type"));
    }
    let labels = labels.feature(facc);
    labeled
        .iter()
        .zip(codes)
        .zip(&labels)
        .try_for_each(|((found, code), label)| check_label(found, code, label.as_deref()))
}

fn check_moving(folder: &str, entity: &EntityType, labels: &Labels) -> Result<(), String> {
    let parts: Vec<&str> = folder.split('/').collect();
    let [_, _, labeled @ .., last] = &parts[..] else { return Err("it lies in no folder of an entity type".into()) };
    if parts[..2].join("/") != MOVING_GEOMETRY || labeled.len() != 4 {
        return Err(format!(
            "expected {MOVING_GEOMETRY} and a folder each for kind, domain, country, category and type"
        ));
    }
    if *last != entity.code() {
        return Err(format!("the last folder should be {}, found {last}", entity.code()));
    }
    let codes =
        [entity.kind.into(), entity.domain.into(), entity.country, entity.category.into()].map(|n| n.to_string());
    let labels = labels.entity(entity);
    labeled
        .iter()
        .zip(&codes)
        .zip(&labels)
        .try_for_each(|((found, code), label)| check_label(found, code, label.as_deref()))
}

fn check_label(found: &str, code: &str, label: Option<&str>) -> Result<(), String> {
    let expected = format!("{code}_{}", label.unwrap_or("…"));
    match found.strip_prefix(code).and_then(|f| f.strip_prefix('_')) {
        Some(name) if label.is_none_or(|l| l == name) => Ok(()),
        _ => Err(format!("the folder {found} should be {expected}")),
    }
}

fn check_texture(folder: &str, dataset: &str, name: &str) -> Result<String, String> {
    let (texture, extension) = split_extension(name);
    check_extension(extension, "rgb")?;
    let expected = texture_folder(dataset, texture);
    if folder == expected { Ok(texture.into()) } else { Err(format!("the folder should be {expected}")) }
}

#[cfg(test)]
mod tests {
    use super::super::store::Empty;
    use super::*;

    #[test]
    fn paths_are_the_standard_s_examples_and_read_back() {
        let labels = Labels::read(&Empty).unwrap();
        let house = "AL015_050_Church-Gothic";
        let folder = typical_folder(&labels, "AL015").unwrap();
        assert_eq!(folder, "GTModel/500_GTModelGeometry/A_Culture/L_Misc_Feature/015_Building");
        let tank = EntityType::parse("1.1.225.1.1.8.0").unwrap();
        let moving = moving_folder(&labels, &tank).unwrap();
        assert_eq!(moving, "MModel/600_MModelGeometry/1_Platform/1_Land/225_United_States/1_Tank/1_1_225_1_1_8_0");
        let key = house.to_string();
        let textures = texture_folder(TYPICAL_TEXTURE, "name");
        assert_eq!(textures, "GTModel/501_GTModelTexture/N/A/name");
        for (path, file) in [
            (format!("{folder}/{}", typical_entry(house)), LibraryFile::TypicalEntry { key: key.clone() }),
            (format!("{folder}/{}", typical_descriptor(house)), LibraryFile::TypicalDescriptor { key: key.clone() }),
            (format!("{folder}/{}", typical_level(4, house)), LibraryFile::TypicalLevel { lod: 4, key: key.clone() }),
            (format!("{folder}/{}", typical_level(-3, house)), LibraryFile::TypicalLevel { lod: -3, key }),
            (
                format!("{textures}/{}", typical_texture(6, "name")),
                LibraryFile::TypicalTexture { lod: 6, name: "name".into() },
            ),
            (
                format!("{moving}/{}", moving_geometry(&tank.code())),
                LibraryFile::MovingGeometry { entity: tank, part: 1 },
            ),
            (format!("{moving}/{}", moving_descriptor(&tank.code())), LibraryFile::MovingDescriptor { entity: tank }),
            (
                "MModel/601_MModelTexture/M/1/M1A2/D601_S005_T001_W11_M1A2.rgb".into(),
                LibraryFile::MovingTexture { power: 11, name: "M1A2".into() },
            ),
        ] {
            assert_eq!(parse(&path, &labels), Ok(Some(file)), "{path}");
        }
        for other in ["Tiles/a.flt", "GTModel/501_GTModelTexture/N/A/name/D504_S001_T001_L06_name.tif", "MModel/x"] {
            assert_eq!(parse(other, &labels), Ok(None), "{other}");
        }
        for wrong in [
            format!("{folder}/D500_S001_T001_AL016_050_Church.flt"),
            format!("{folder}/D500_S001_T001_AL015_50_Church.flt"),
            format!("{folder}/D500_AL015_050_Church.flt"),
            format!("{folder}/D500_S001_T001_AL015_050_Church.FLT"),
            format!("{folder}/L05/D510_S001_T001_L04_{house}.flt"),
            folder.replace("015_Building", "015_House") + "/D500_S001_T001_AL015_050_Church.flt",
            format!("{moving}/D600_S001_T001_1_1_225_1_1_8_1.flt"),
            moving.replace("1_Land", "1_Air") + "/D600_S001_T001_1_1_225_1_1_8_0.flt",
            "MModel/601_MModelTexture/M/2/M1A2/D601_S005_T001_W11_M1A2.rgb".into(),
            "MModel/601_MModelTexture/M/1/M1A2/D601_S005_T001_W1_M1A2.rgb".into(),
        ] {
            assert!(parse(&wrong, &labels).is_err(), "{wrong}");
        }
    }

    #[test]
    fn codes_without_labels_are_refused() {
        let labels = Labels::read(&Empty).unwrap();
        let refused = |e: crate::Error| e.to_string();
        assert!(refused(typical_folder(&labels, "ZZ999").unwrap_err()).contains("Feature_Data_Dictionary.xml"));
        let moving = |text: &str| refused(moving_folder(&labels, &EntityType::parse(text).unwrap()).unwrap_err());
        assert!(moving("1.1.225.99").contains("Moving_Model_Codes.xml"));
        assert!(moving("1.1.999.1").contains("DIS_Country_Codes.xml"));
    }
}
