//! How fast each format is written and read, and how large it is. Writes the splats' files into the folder that is
//! named, for other programs to be timed on (`tests/clients/splat_speed.py`).
//!
//! cargo run --release -p orb-formats --example speed -- FOLDER

use std::path::PathBuf;
use std::time::Instant;

use orb_formats::asset::{EncodedImage, Material, Part};
use orb_formats::openflight::{self, Geometry, Level, Model};
use orb_formats::spz::{self, Axes, Version};
use orb_formats::{Asset, Image, Mesh, Splats, glb, ply, sgi, usdz};

const SPLATS: usize = 300_000;
/// Quads along each side of a field: 100,352 triangles.
const SIDE: u32 = 224;
const ROUNDS: usize = 5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("name a folder for the files")?);
    std::fs::create_dir_all(&folder)?;
    let splats = splats();
    println!("{SPLATS} splats of degree 3, the best of {ROUNDS} rounds");
    let bytes = line("ply", SPLATS, || ply::write(&splats, &[]), |b| ply::read(b).map(drop))?;
    std::fs::write(folder.join("scene.ply"), bytes)?;
    for version in [Version::V2, Version::V3, Version::V4] {
        let options = spz::Options { version, ..spz::Options::default() };
        let name = format!("spz {}", version as u32);
        let read = |b: &[u8]| spz::read(b, Axes::RUB).map(drop);
        let bytes = line(&name, SPLATS, || spz::write(&splats, &options), read)?;
        std::fs::write(folder.join(format!("scene.v{}.spz", version as u32)), bytes)?;
    }
    let asset = Asset { splats: Some(splats), ..Asset::default() };
    line("splat-glb", SPLATS, || glb::write(&asset), |b| glb::read(b).map(drop))?;

    let mesh = field();
    let triangles = mesh.triangles.len();
    println!("{triangles} triangles, {} vertices", mesh.positions.len());
    let asset = Asset {
        name: "field".into(),
        parts: vec![Part { mesh: mesh.clone(), material: Some(0) }],
        materials: vec![Material { image: Some(0), ..Material::default() }],
        images: vec![EncodedImage { media_type: "image/png".into(), bytes: vec![0; 16] }],
        ..Asset::default()
    };
    let bytes = line("glb", triangles, || glb::write(&asset), |b| glb::read(b).map(drop))?;
    std::fs::write(folder.join("field.glb"), bytes)?;
    line("usdz", triangles, || usdz::write(&asset), |b| usdz::read(b).map(drop))?;
    let level = Level { switch_in: 1000.0, significant_size: 1.0, texture: Some(0), mesh, ..Level::default() };
    let model = Model { name: "field".into(), textures: vec!["a.rgb".into()], levels: vec![level], ..Model::default() };
    let read = |b: &[u8]| openflight::read(b).map(drop);
    let bytes = line("flt faces", triangles, || openflight::write_as(&model, Geometry::Faces), read)?;
    std::fs::write(folder.join("field.flt"), bytes)?;
    line("flt meshes", triangles, || openflight::write_as(&model, Geometry::Meshes), read)?;
    let pixels = (0..2048u32 * 2048).flat_map(|i| [(i / 16) as u8, (i / 4096) as u8, 90]).collect();
    let image = Image { width: 2048, height: 2048, channels: 3, pixels };
    println!("a texture of 2048 x 2048");
    line("rgb", 2048 * 2048, || sgi::write(&image, "", true), |b| sgi::read(b).map(drop))?;
    Ok(())
}

/// Times a writer and a reader; prints a line; the file.
fn line(
    name: &str,
    count: usize,
    write: impl Fn() -> orb_formats::Result<Vec<u8>>,
    read: impl Fn(&[u8]) -> orb_formats::Result<()>,
) -> orb_formats::Result<Vec<u8>> {
    let mut best = [f64::INFINITY; 2];
    let mut bytes = Vec::new();
    for _ in 0..ROUNDS {
        let start = Instant::now();
        bytes = write()?;
        best[0] = best[0].min(start.elapsed().as_secs_f64());
        let start = Instant::now();
        read(&bytes)?;
        best[1] = best[1].min(start.elapsed().as_secs_f64());
    }
    let mega = bytes.len() as f64 / 1e6;
    let [write, read] = best.map(|s| format!("{:6.3} s {:6.0} MB/s {:6.2} M/s", s, mega / s, count as f64 / s / 1e6));
    println!("{name:10} {mega:7.2} MB  write {write}  read {read}");
    Ok(bytes)
}

/// Positions on shells, as surfaces have them; the rest as trained scenes spread.
fn splats() -> Splats {
    let mut state = 1u64;
    let mut next = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1u64 << 24) as f32
    };
    // Sums of uniform numbers are nearly normal.
    let mut normal = move || (0..4).map(|_| next()).sum::<f32>() - 2.0;
    let mut out = Splats::default();
    for _ in 0..SPLATS {
        let v = [0; 3].map(|_| normal());
        let length = v.iter().map(|x| x * x).sum::<f32>().sqrt().max(1e-3);
        out.positions.push(v.map(|x| x / length * (2.0 + 0.02 * normal())));
        out.log_scales.push([0; 3].map(|_| -5.0 + normal()));
        out.rotations.push([0; 4].map(|_| normal()));
        out.logit_opacities.push(2.0 + 3.0 * normal());
        out.sh.push(std::array::from_fn(|b| [0; 3].map(|_| normal() * if b == 0 { 1.5 } else { 0.15 })));
    }
    out
}

fn field() -> Mesh {
    let mut mesh = Mesh::default();
    for y in 0..=SIDE {
        for x in 0..=SIDE {
            let (u, v) = (f64::from(x) / f64::from(SIDE), f64::from(y) / f64::from(SIDE));
            mesh.positions.push([u * 10.0, v * 10.0, (u * 20.0).sin() * (v * 20.0).cos() * 0.1]);
            mesh.normals.push([0.0, 0.0, 1.0]);
            mesh.uvs.push([u as f32, v as f32]);
        }
    }
    let at = |x: u32, y: u32| y * (SIDE + 1) + x;
    for y in 0..SIDE {
        for x in 0..SIDE {
            mesh.triangles.push([at(x, y), at(x + 1, y), at(x + 1, y + 1)]);
            mesh.triangles.push([at(x, y), at(x + 1, y + 1), at(x, y + 1)]);
        }
    }
    mesh
}
