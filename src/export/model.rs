//! Textured levels to files: GLB, USDZ, 3D Tiles.

use orb_formats::asset::{EncodedImage, Material, Part};
use orb_formats::tiles3d::{self, Tile, Tileset, Volume};
use orb_formats::{Asset, File, glb, usdz};

use super::scene::{splat_asset, y_up};
use super::{Labels, PlacedLevel, format_error, label, marked_png};
use crate::geo::{Enu, Placement};
use crate::mesh::Details;
use crate::splat::Gaussians;
use crate::{Error, Result};

/// One file a level, the finest under the model's own name (`orb_formats::glb` says why).
pub fn glb(
    levels: &[PlacedLevel],
    compression: glb::Compression,
    placement: &Placement,
    labels: &Labels,
) -> Result<Vec<File>> {
    let one = |(i, level): (usize, &PlacedLevel)| {
        let path = if i == 0 { format!("{}.glb", labels.stem) } else { format!("{}_lod{i}.glb", labels.stem) };
        let bytes = glb::write_as(&asset(level, placement, labels)?, compression).map_err(format_error)?;
        Ok(File { path, bytes, media_type: "model/gltf-binary" })
    };
    levels.iter().enumerate().map(one).collect()
}

/// The finest level, since viewers of USDZ have no levels of detail; beside it the Gaussians, where they are wanted.
pub fn usdz(
    levels: &[PlacedLevel],
    gaussians: Option<&Gaussians>,
    placement: &Placement,
    labels: &Labels,
) -> Result<File> {
    let finest = levels.first().ok_or_else(|| Error::usage("usdz").found("no surface"))?;
    let splats = gaussians.and_then(|g| splat_asset(&y_up(g), placement, labels).splats);
    let whole = Asset { splats, ..asset(finest, placement, labels)? };
    let bytes = usdz::write(&whole).map_err(format_error)?;
    Ok(File { path: format!("{}.usdz", labels.stem), bytes, media_type: "model/vnd.usdz+zip" })
}

/// `tiles3d/tileset.json` and a GLB a level, coarse ones refined by finer ones, at their place on the Earth.
pub fn tiles3d(levels: &[PlacedLevel], placement: &Placement, labels: &Labels) -> Result<Vec<File>> {
    let mut files = Vec::new();
    let mut tree: Option<Tile> = None;
    let mut size = 0.0f64;
    for (i, level) in levels.iter().enumerate() {
        let (low, high) =
            level.mesh.bounds().ok_or_else(|| Error::usage("tiles3d").found("a level without a vertex"))?;
        size = size.max((0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt());
        let name = format!("lod{i}.glb");
        let bytes = glb::write(&asset(level, placement, labels)?).map_err(format_error)?;
        files.push(File { path: format!("tiles3d/{name}"), bytes, media_type: "model/gltf-binary" });
        // Nothing is finer than the finest, so nothing is missing when it is drawn; no level is worse than a coarser.
        let finer = tree.as_ref().map_or(0.0, |t| t.geometric_error);
        tree = Some(Tile {
            volume: around_all(levels, i + 1)?,
            geometric_error: if i == 0 { 0.0 } else { level.error.max(finer) },
            content: Some(name),
            children: tree.into_iter().collect(),
            transform: None,
        });
    }
    let mut root = tree.ok_or_else(|| Error::usage("tiles3d").found("no surface"))?;
    root.transform = Some(to_earth(placement));
    let tileset = Tileset {
        geometric_error: size.max(root.geometric_error),
        root,
        gltf_extensions: Vec::new(),
        label: label(placement, labels),
    };
    let bytes = tiles3d::write(&tileset).map_err(format_error)?;
    files.insert(0, File { path: "tiles3d/tileset.json".into(), bytes, media_type: "application/json" });
    Ok(files)
}

/// A tile's volume holds its children's: the first levels together.
fn around_all(levels: &[PlacedLevel], count: usize) -> Result<Volume> {
    let boxes = levels[..count].iter().filter_map(|l| l.mesh.bounds());
    let whole = boxes.reduce(|(low, high), (l, h)| {
        (std::array::from_fn(|i| low[i].min(l[i])), std::array::from_fn(|i| high[i].max(h[i])))
    });
    let (low, high) = whole.ok_or_else(|| Error::usage("tiles3d").found("levels without a vertex"))?;
    Ok(Volume::around(low, high))
}

/// Subject frame → earth-centred, earth-fixed: the columns of the matrix.
pub(super) fn to_earth(placement: &Placement) -> [f64; 16] {
    let axes = placement.origin.axes();
    let column = |direction: [f64; 3]| {
        let Enu { east, north, up } = placement.to_enu(direction);
        std::array::from_fn::<f64, 3, _>(|i| axes[0][i] * east + axes[1][i] * north + axes[2][i] * up)
    };
    let origin = placement.origin.to_ecef();
    let columns = [column([1.0, 0.0, 0.0]), column([0.0, 1.0, 0.0]), column([0.0, 0.0, 1.0])];
    let mut out = [0.0; 16];
    for (i, c) in columns.iter().chain([&[origin.x, origin.y, origin.z]]).enumerate() {
        out[4 * i..4 * i + 3].copy_from_slice(c);
    }
    out[15] = 1.0;
    out
}

fn asset(level: &PlacedLevel, placement: &Placement, labels: &Labels) -> Result<Asset> {
    let mut images = Vec::new();
    let mut add = |picture: image::DynamicImage| -> Result<usize> {
        images.push(EncodedImage { media_type: "image/png".into(), bytes: marked_png(&picture, &labels.marking)? });
        Ok(images.len() - 1)
    };
    let Details { normals, occlusion } = level.details.clone();
    let material = Material {
        name: labels.stem.clone(),
        image: Some(add(level.texture.clone().into())?),
        normal_image: normals.map(|n| add(n.into())).transpose()?,
        occlusion_image: occlusion.map(|o| add(o.into())).transpose()?,
        ..Material::default()
    };
    Ok(Asset {
        name: labels.stem.clone(),
        parts: vec![Part { mesh: level.mesh.clone(), material: Some(0) }],
        materials: vec![material],
        images,
        splats: None,
        label: label(placement, labels),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::{Marking, inband};
    use crate::geo::{Ecef, Geodetic, HeadingSource};
    use image::RgbImage;

    fn level(size: f64, error: f64) -> PlacedLevel {
        let corner = |x: f64, y: f64, z: f64| [x * size, y * size, z * size];
        PlacedLevel {
            mesh: orb_formats::Mesh {
                positions: vec![corner(-1.0, -1.0, 0.0), corner(1.0, -1.0, 0.0), corner(0.0, 1.0, 2.0)],
                normals: vec![[0.0, -0.6, 0.8]; 3],
                uvs: vec![[0.0, 0.0], [1.0, 0.0], [0.5, 1.0]],
                triangles: vec![[0, 1, 2]],
            },
            texture: RgbImage::from_pixel(2, 2, image::Rgb([9, 99, 199])),
            details: Details {
                normals: Some(RgbImage::from_pixel(2, 2, image::Rgb([128, 128, 255]))),
                occlusion: Some(image::GrayImage::from_pixel(2, 2, image::Luma([200]))),
            },
            error,
            significant_size: error,
        }
    }

    fn placement() -> Placement {
        Placement {
            origin: Geodetic { latitude: -54.8019, longitude: -68.303, height: 12.5 },
            heading: 200.0,
            heading_source: HeadingSource::Given,
        }
    }

    fn labels() -> Labels {
        Labels {
            stem: "car".into(),
            marking: Marking::CUI,
            utc: "2026-11-21T04:05:06.789Z".into(),
            heading_source: "given",
            scale_source: "given",
        }
    }

    #[test]
    fn the_root_transform_is_the_placement() {
        let files = tiles3d(&[level(1.0, 0.0), level(1.01, 0.1)], &placement(), &labels()).unwrap();
        let names: Vec<&str> = files.iter().map(|f| f.path.as_str()).collect();
        assert_eq!(names, ["tiles3d/tileset.json", "tiles3d/lod0.glb", "tiles3d/lod1.glb"]);
        let tileset = tiles3d::read(&files[0].bytes).unwrap();
        let t = tileset.root.transform.unwrap();
        for p in [[0.0, 0.0, 0.0], [3.0, -2.0, 1.0], [-40.0, 11.0, 7.0]] {
            let at = |i: usize| t[i] * p[0] + t[4 + i] * p[1] + t[8 + i] * p[2] + t[12 + i];
            let Ecef { x, y, z } = placement().to_ecef(p);
            let off = (at(0) - x).hypot(at(1) - y).hypot(at(2) - z);
            assert!(off < 1e-7, "{off} m at {p:?}");
        }
        assert_eq!((tileset.root.geometric_error, tileset.root.children[0].geometric_error), (0.1, 0.0));
        assert_eq!(tileset.root.content.as_deref(), Some("lod1.glb"));
        assert_eq!(tileset.label.marking, "CLASSIFICATION: CUI");
        for file in &files {
            assert_eq!(inband::mismatch(&file.path, &file.bytes, &Marking::CUI), None, "{}", file.path);
            assert!(inband::mismatch(&file.path, &file.bytes, &Marking::SECRET).is_some(), "{}", file.path);
        }
    }

    #[test]
    fn levels_keep_their_geometry() {
        let levels = [level(1.0, 0.0), level(1.01, 0.1)];
        let files = glb(&levels, glb::Compression::None, &placement(), &labels()).unwrap();
        assert_eq!([files[0].path.as_str(), files[1].path.as_str()], ["car.glb", "car_lod1.glb"]);
        let back = glb::read(&files[1].bytes).unwrap();
        for (a, b) in back.parts[0].mesh.positions.iter().flatten().zip(levels[1].mesh.positions.iter().flatten()) {
            assert!((a - b).abs() < 1e-6);
        }
        let packed = glb(&levels, glb::Compression::Meshopt, &placement(), &labels()).unwrap();
        let unfolded = glb::read(&packed[1].bytes).unwrap();
        assert_eq!(unfolded.parts[0].mesh.triangles.len(), back.parts[0].mesh.triangles.len());
        let (a, b) = (unfolded.parts[0].mesh.bounds().unwrap(), back.parts[0].mesh.bounds().unwrap());
        assert!([a.0, a.1].iter().flatten().zip([b.0, b.1].iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-4));
        assert_eq!(inband::mismatch(&packed[1].path, &packed[1].bytes, &Marking::CUI), None);
        assert!(inband::mismatch(&packed[1].path, &packed[1].bytes, &Marking::SECRET).is_some());
        let looks = &back.materials[0];
        assert_eq!([looks.image, looks.normal_image, looks.occlusion_image], [Some(0), Some(1), Some(2)]);
        let package = usdz(&levels, None, &placement(), &labels()).unwrap();
        assert_eq!(usdz::read(&package.bytes).unwrap().parts[0].mesh.uvs, levels[0].mesh.uvs);
        assert_eq!(inband::mismatch(&package.path, &package.bytes, &Marking::CUI), None);
        assert!(inband::mismatch(&package.path, &package.bytes, &Marking::UNCLASSIFIED).is_some());
    }
}
