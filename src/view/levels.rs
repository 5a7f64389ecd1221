//! The levels of detail of a published folder: those of its CDB store, else those of its GLB files.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use glam::{Vec2, Vec3};
use image::{Rgb, RgbImage};
use orb_formats::cdb::Archive;
use orb_formats::{openflight, sgi};

use super::subject::Level;
use crate::audit::disk;
use crate::export::import;
use crate::mesh::Mesh;
use crate::{Error, Result};

/// Most bytes of a store's archive that are read.
const MOST_BYTES: u64 = 256 << 20;

/// The levels of the one model in the folder's store, finest first; where there is no store, those of its GLB files.
///
/// # Errors
/// Usage for a store of several models, and for files that cannot be read.
pub fn of_folder(folder: &Path) -> Result<Vec<Level>> {
    let mut levels = of_store(folder)?;
    if levels.is_empty() {
        levels = of_glb_files(folder)?;
    }
    levels.sort_by_key(|l| std::cmp::Reverse(l.mesh.triangles.len()));
    Ok(levels)
}

/// One level a file, as `orb geo` writes them; files of Gaussians have none.
fn of_glb_files(folder: &Path) -> Result<Vec<Level>> {
    let entries = std::fs::read_dir(folder).map_err(|e| Error::io(folder, &e))?;
    let mut files: Vec<_> = entries.filter_map(|e| Some(e.ok()?.path())).collect();
    files.retain(|p| p.is_file() && p.extension().is_some_and(|e| e.eq_ignore_ascii_case("glb")));
    files.sort();
    let mut levels = Vec::new();
    for path in files {
        let bytes = disk::read_limited(&path, MOST_BYTES)?;
        let found = import::read(&path.display().to_string(), &bytes, None)?.levels;
        levels.extend(found.iter().map(|l| level(&l.mesh, l.texture.clone())));
    }
    Ok(levels)
}

fn of_store(folder: &Path) -> Result<Vec<Level>> {
    let (mut models, mut pictures) = (Vec::new(), Vec::new());
    for entry in disk::walk(folder)? {
        let wanted = entry.name.ends_with(".zip") && entry.name.contains(".cdb/Tiles/");
        if wanted && entry.name.contains("/300_GSModelGeometry/") {
            models.push(archive(&entry.path)?);
        } else if wanted && entry.name.contains("/301_GSModelTexture/") {
            pictures.push(archive(&entry.path)?);
        }
    }
    let names: BTreeSet<String> = models.iter().flat_map(|a| a.names().map(model_name)).collect();
    if names.len() > 1 {
        return Err(Error::usage("the CDB store").expected("one model").found(format!("{}", names.len())));
    }
    let mut textures = BTreeMap::new();
    let mut levels = Vec::new();
    for archive in &models {
        let files = archive.names().filter(|n| n.ends_with(".flt")).filter_map(|n| archive.get(n));
        for bytes in files {
            let model = openflight::read(&bytes).map_err(|e| Error::usage("the CDB store").found(e.to_string()))?;
            for level in &model.levels {
                let path = level.texture.and_then(|t| model.textures.get(t)).map(String::as_str);
                let name = path.map(|p| p.rsplit('/').next().unwrap_or(p).to_owned()).unwrap_or_default();
                let texture = textures.entry(name).or_insert_with_key(|name| {
                    let bytes = pictures.iter().find_map(|a| a.get(name))?;
                    sgi::read(&bytes).ok().and_then(|(image, _)| rgb(&image))
                });
                let white = || RgbImage::from_pixel(1, 1, Rgb([200; 3]));
                levels.push(self::level(&level.mesh, texture.clone().unwrap_or_else(white)));
            }
        }
    }
    Ok(levels)
}

/// A file's mesh as the renderer takes it.
pub fn level(mesh: &orb_formats::Mesh, texture: RgbImage) -> Level {
    let mesh = Mesh {
        positions: mesh.positions.iter().map(|p| Vec3::from_array(p.map(|x| x as f32))).collect(),
        normals: mesh.normals.iter().map(|n| Vec3::from_array(*n)).collect(),
        uvs: mesh.uvs.iter().map(|t| Vec2::from_array(*t)).collect(),
        triangles: mesh.triangles.clone(),
    };
    Level { mesh, texture }
}

fn archive(path: &Path) -> Result<Archive> {
    let bytes = disk::read_limited(path, MOST_BYTES)?;
    let name = path.display().to_string();
    Archive::read(bytes, &name).map_err(|e| Error::usage(name).found(e.to_string()))
}

/// `N34W119_D300_S001_T001_L04_U8_R8_UA005_000_smart_car.flt` without its tile: one name for all levels.
fn model_name(entry: &str) -> String {
    entry.splitn(8, '_').last().unwrap_or(entry).to_owned()
}

fn rgb(image: &sgi::Image) -> Option<RgbImage> {
    let channels = usize::from(image.channels);
    let pixels = image.pixels.chunks_exact(channels.max(1));
    let three = pixels.flat_map(|p| if channels < 3 { [p[0]; 3] } else { [p[0], p[1], p[2]] }).collect();
    RgbImage::from_raw(image.width, image.height, three)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_of_one_model_share_a_name() {
        assert_eq!(model_name("N34W119_D300_S001_T001_L04_U8_R8_UA005_000_smart_car.flt"), "UA005_000_smart_car.flt");
        assert_eq!(model_name("x.flt"), "x.flt");
    }

    #[test]
    fn grey_pictures_become_colours() {
        let grey = sgi::Image { width: 2, height: 1, channels: 1, pixels: vec![7, 9] };
        assert_eq!(rgb(&grey).unwrap().into_raw(), [7, 7, 7, 9, 9, 9]);
        let alpha = sgi::Image { width: 1, height: 1, channels: 4, pixels: vec![1, 2, 3, 4] };
        assert_eq!(rgb(&alpha).unwrap().into_raw(), [1, 2, 3]);
    }
}
