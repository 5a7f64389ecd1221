//! `orb bench make`: scenes whose truth is known, from a seed. Vehicles, buildings and other things out of plain parts,
//! with painted textures, on simple ground under a plain sky; drawn by Orb's own rasteriser. Same seed, same bytes.

mod nerf;
mod parts;
pub mod photos;
pub mod site;
mod surroundings;
mod things;

use glam::Vec3;
use image::{RgbImage, RgbaImage};
use orb_formats::asset::{EncodedImage, Material, Part};
use orb_formats::{Asset, File, Label, glb};
use serde_json::{Value, json};

use super::submission::straight;
use crate::audit::{Marking, inband};
use crate::export::format_error;
use crate::mesh::Mesh;
use crate::splat::Camera;
use crate::splat::train::random::Random;
use crate::{Error, Result, views};

pub use things::KINDS;

/// What is made.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    pub seed: u64,
    /// Pixels across the photo.
    pub photo: u32,
    /// Held-back views, and pixels across each.
    pub views: usize,
    pub view: u32,
}

impl Default for Options {
    fn default() -> Self {
        Options { seed: 0, photo: 512, views: 12, view: 256 }
    }
}

/// Scene number `index` of a benchmark: its name, and its files relative to the benchmark's folder.
///
/// # Errors
/// None in practice: what is made fits its formats.
pub fn scene(index: usize, options: &Options, marking: &Marking) -> Result<(String, Vec<File>)> {
    let mut random = Random::new(options.seed.wrapping_mul(1_000_003).wrapping_add(index as u64));
    let kind = &KINDS[index % KINDS.len()];
    let name = format!("{index:02}_{}", kind.name);
    let (mesh, texture) = things::build(kind, &mut random);
    let (low, high) = mesh.bounds();
    let middle = (low + high) / 2.0;
    let radius = low.distance(high) / 2.0;
    // The subject frame: the photo's camera stands on −Y.
    let at = |azimuth: f32, elevation: f32, fov: f32, size: u32| {
        let distance = 1.12 * radius / (fov / 2.0).sin();
        Camera::look_at(middle + views::eye(azimuth, elevation, distance), middle, fov, size)
    };
    let photo = at(0.0, 8.0 + 14.0 * random.uniform(), 40f32.to_radians(), options.photo);
    let mut files = Vec::new();
    let mut listed = Vec::new();
    let png = |image: image::DynamicImage| -> Result<Vec<u8>> {
        let mut bytes = std::io::Cursor::new(Vec::new());
        image
            .write_to(&mut bytes, image::ImageFormat::Png)
            .map_err(|e| Error::environment("PNG").found(e.to_string()))?;
        Ok(inband::mark_png(&bytes.into_inner(), marking))
    };
    let mut put = |path: String, bytes: Vec<u8>, media_type| {
        files.push(File { path: format!("{name}/{path}"), bytes, media_type });
    };
    let cut = rgba(&mesh, &texture, &photo);
    let outdoor = surroundings::behind(&cut, &photo, &mesh, &mut random, 0.0);
    put("photo.png".into(), png(outdoor.into())?, "image/png");
    put("mask.png".into(), png(mask(&cut).into())?, "image/png");
    listed.push(entry("mask", "photo", "mask.png", &photo));
    listed.push(entry("photo", "photo", "photo.png", &photo));
    for k in 0..options.views {
        let elevation = [5.0, 25.0, 45.0, 15.0][k % 4];
        let azimuth = 360.0 * k as f32 / options.views as f32;
        let camera = at(azimuth, elevation, 30f32.to_radians(), options.view);
        let file = format!("views/{k:02}.png");
        put(file.clone(), png(rgba(&mesh, &texture, &camera).into())?, "image/png");
        listed.push(entry(&format!("{k:02}"), "test", &file, &camera));
    }
    put("mesh.glb".into(), model(&name, &mesh, &texture, marking)?, "model/gltf-binary");
    let size = high - low;
    let facts = json!({
        "name": name, "class": kind.name, "world": "metres, Z up, +Y where the photo's camera looks; the ground is Z = 0",
        "mesh": "mesh.glb", "ground": 0.0, "size_m": size.to_array(), "size_range_m": kind.sizes, "seed": options.seed,
        "views": listed,
    });
    let mut text =
        serde_json::to_vec_pretty(&facts).map_err(|e| Error::environment("scene.json").found(e.to_string()))?;
    text.push(b'\n');
    put("scene.json".into(), text, "application/json");
    Ok((name, files))
}

fn entry(name: &str, group: &str, file: &str, c: &Camera) -> Value {
    let row = |i: usize| c.rotation.row(i).extend(c.translation[i]).to_array();
    json!({
        "name": name, "group": group, "file": file, "width": c.width, "height": c.height,
        "fx": c.fx, "fy": c.fy, "cx": c.cx, "cy": c.cy, "w2c_opencv": [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]],
    })
}

/// A picture of a mesh with what is around it left clear.
pub fn rgba(mesh: &Mesh, texture: &RgbImage, camera: &Camera) -> RgbaImage {
    let (color, alpha) = straight(mesh, texture, camera);
    let byte = |v: f32| (v.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
    RgbaImage::from_fn(camera.width, camera.height, |x, y| {
        let i = (y * camera.width + x) as usize;
        let [r, g, b] = color[i].map(byte);
        image::Rgba([r, g, b, byte(alpha[i])])
    })
}

fn mask(cut: &RgbaImage) -> image::GrayImage {
    image::GrayImage::from_fn(cut.width(), cut.height(), |x, y| image::Luma([cut.get_pixel(x, y).0[3]]))
}

/// The mesh as GLB, marked.
///
/// # Errors
/// Usage where the writer refuses.
pub fn model(name: &str, mesh: &Mesh, texture: &RgbImage, marking: &Marking) -> Result<Vec<u8>> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    texture
        .write_to(&mut bytes, image::ImageFormat::Png)
        .map_err(|e| Error::environment("PNG").found(e.to_string()))?;
    let plain = orb_formats::Mesh {
        positions: mesh.positions.iter().map(|p| p.as_dvec3().to_array()).collect(),
        normals: mesh.normals.iter().map(Vec3::to_array).collect(),
        uvs: mesh.uvs.iter().map(|t| t.to_array()).collect(),
        triangles: mesh.triangles.clone(),
    };
    let asset = Asset {
        name: name.to_owned(),
        parts: vec![Part { mesh: plain, material: Some(0) }],
        materials: vec![Material { name: "paint".into(), image: Some(0), ..Material::default() }],
        images: vec![EncodedImage { media_type: "image/png".into(), bytes: bytes.into_inner() }],
        splats: None,
        label: Label { marking: marking.line(), place: None },
    };
    glb::write(&asset).map_err(format_error)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::physics;
    use crate::mesh::Surface;

    #[test]
    fn every_kind_is_closed_stands_on_the_ground_and_has_its_size() {
        for (i, kind) in KINDS.iter().enumerate() {
            let (mesh, texture) = things::build(kind, &mut Random::new(40 + i as u64));
            let s = Surface { positions: mesh.positions.clone(), triangles: mesh.triangles.clone() };
            let (low, high) = s.bounds();
            assert_eq!(physics::watertightness(&s), Some(1.0), "{}", kind.name);
            assert!(low.z.abs() < 1e-5 && s.volume() > 0.0, "{}: {low}", kind.name);
            assert!((low + high).truncate().abs().max_element() < 1e-4, "{}", kind.name);
            let longest = f64::from((high - low).max_element());
            assert_eq!(physics::plausible_scale(longest, kind.sizes), 0.0, "{}: {longest}", kind.name);
            assert!(mesh.uvs.iter().all(|t| t.min_element() > 0.0 && t.max_element() < 1.0), "{}", kind.name);
            assert!(texture.pixels().any(|p| p.0.iter().any(|c| *c > 60)));
            // Triangles are wound as their normals point.
            for t in &mesh.triangles {
                let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
                let along = (b - a).cross(c - a).dot(mesh.normals[t[0] as usize]);
                assert!(along > 0.0, "{}", kind.name);
            }
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_bytes() {
        let small = Options { photo: 48, views: 2, view: 32, ..Options::default() };
        let bytes = |seed: u64| scene(3, &Options { seed, ..small }, &Marking::UNCLASSIFIED).unwrap().1;
        assert!(bytes(5) == bytes(5) && bytes(5) != bytes(6));
        assert_eq!(bytes(5).len(), 2 + 2 + 2);
    }
}
