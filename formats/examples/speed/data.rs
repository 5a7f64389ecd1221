//! What is written and read: made, the same at every run.

use orb_formats::cdb::dbf::{Column, Table, Value};
use orb_formats::cdb::shapefile::{NO_MEASURE, PointZ};
use orb_formats::tiles3d::{Tile, Tileset, Volume};
use orb_formats::{Image, Mesh, Result, Splats};

pub const SPLATS: usize = 300_000;
/// Quads along each side of a field: 100,352 triangles.
const SIDE: u32 = 224;
/// A tile of CDB's features holds no more.
const POINTS: usize = 16_384;
/// A tree of four children each, eight levels deep.
pub const TILES: usize = (4usize.pow(8) - 1) / 3;

/// One grey pixel.
pub const PNG: [u8; 67] = [
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00, 0x00,
    0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3a, 0x7e, 0x9b, 0x55, 0x00, 0x00, 0x00, 0x0a, 0x49,
    0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x68, 0x00, 0x00, 0x00, 0x82, 0x00, 0x81, 0xda, 0x45, 0x08, 0x3b, 0x00, 0x00,
    0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82,
];

/// Positions on shells, as surfaces have them; the rest as trained scenes spread.
pub fn splats() -> Splats {
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
        let q = [0; 4].map(|_| normal());
        let length = q.iter().map(|x| x * x).sum::<f32>().sqrt().max(1e-3);
        out.rotations.push(q.map(|x| x / length));
        out.logit_opacities.push(2.0 + 3.0 * normal());
        out.sh.push(std::array::from_fn(|b| [0; 3].map(|_| normal() * if b == 0 { 1.5 } else { 0.15 })));
    }
    out
}

/// A rolling field.
pub fn field() -> Mesh {
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

/// Slopes of colour with a little grain, as photos have it.
pub fn image(side: u32) -> Image {
    let mut pixels = Vec::with_capacity((side * side * 3) as usize);
    for i in 0..side * side {
        let (x, y) = (i % side, i / side);
        let grain = (i.wrapping_mul(2_654_435_761) >> 30) as u8;
        pixels.extend([(x / 8) as u8 ^ grain, (y / 8) as u8, 90 + grain]);
    }
    Image { width: side, height: side, channels: 3, pixels }
}

pub fn heights(side: usize) -> Vec<f32> {
    let at = |i: usize| ((i % side) as f32 * 0.01).sin() * 40.0 + ((i / side) as f32 * 0.007).cos() * 25.0 + 700.0;
    (0..side * side).map(at).collect()
}

pub fn points() -> Vec<Option<PointZ>> {
    let at = |i: usize| PointZ {
        x: -119.0 + (i % 128) as f64 / 128.0,
        y: 34.0 + (i / 128) as f64 / 128.0,
        z: i as f64 / 100.0,
        m: NO_MEASURE,
    };
    (0..POINTS).map(|i| Some(at(i))).collect()
}

pub fn table() -> Result<Table> {
    let columns = vec![
        Column::new("MODL", b'C', 32, 0),
        Column::new("HGT", b'N', 12, 3),
        Column::new("BSR", b'N', 12, 3),
        Column::new("AO1", b'N', 7, 3),
    ];
    let mut table = Table::new(columns, (2026, 1, 1));
    for i in 0..POINTS {
        let record = table.push();
        table.set(record, 0, &Value::Text(format!("model_{i}")))?;
        for (column, value) in [(1, 3.5), (2, i as f64 / 1000.0), (3, (i % 360) as f64)] {
            table.set(record, column, &Value::Number(value))?;
        }
    }
    Ok(table)
}

pub fn tileset() -> Tileset {
    fn tile(level: u32, number: &mut u32) -> Tile {
        *number += 1;
        let name = format!("tile{number}.glb");
        let children = if level == 7 { Vec::new() } else { (0..4).map(|_| tile(level + 1, number)).collect() };
        Tile {
            volume: Volume::around([-1.0, -2.0, 0.0], [1.5, 2.5, f64::from(*number)]),
            geometric_error: 100.0 / f64::from(1 << level),
            content: Some(name),
            children,
            transform: None,
        }
    }
    let mut number = 0;
    Tileset { geometric_error: 200.0, root: tile(0, &mut number), ..Tileset::default() }
}
