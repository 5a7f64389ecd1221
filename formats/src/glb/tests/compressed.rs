//! `EXT_meshopt_compression`.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::super::{Compression, container, read, write, write_as};
use crate::asset::tests::asset;
use crate::{Asset, Mesh};

/// A bowl of so many rings, with a vertex that no triangle names.
fn bowl(rings: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let side = rings * 4;
    for ring in 0..=rings {
        for i in 0..=side {
            let (out, turn) = (f64::from(ring) / f64::from(rings), f64::from(i) / f64::from(side));
            let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
            mesh.positions.push([3.0 * out * cos, 2.0 * out * sin, 0.5 * out * out]);
            mesh.normals.push(crate::mesh::unit([-0.3 * out * cos, -0.4 * out * sin, 1.0]));
            mesh.uvs.push([turn as f32, out as f32]);
        }
    }
    let at = |ring: u32, i: u32| ring * (side + 1) + i;
    for ring in 0..rings {
        for i in 0..side {
            mesh.triangles.push([at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)]);
            mesh.triangles.push([at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)]);
        }
    }
    mesh.positions.push([9.0, 9.0, 9.0]);
    mesh.normals.push([0.0, 0.0, 1.0]);
    mesh.uvs.push([0.5; 2]);
    mesh
}

fn of_bowl(rings: u32) -> Asset {
    let mut whole = asset();
    whole.parts[0].mesh = bowl(rings);
    whole
}

/// Each triangle's corners, as the order of vertices and triangles does not tell: by their texture coordinates, which a bowl
/// of so many rings has once each, in whole steps.
fn corners(mesh: &Mesh, rings: u32) -> BTreeMap<Vec<[i32; 2]>, Vec<usize>> {
    let key = |v: usize| mesh.uvs[v].map(|x| (x * 4.0 * rings as f32).round() as i32);
    let one = |t: &[u32; 3]| {
        let mut at: Vec<usize> = t.map(|v| v as usize).to_vec();
        // The codec may begin with another corner; it keeps the side.
        let first = (0..3).min_by_key(|&i| key(at[i])).unwrap();
        at.rotate_left(first);
        (at.iter().map(|&v| key(v)).collect(), at)
    };
    mesh.triangles.iter().map(one).collect()
}

#[test]
fn triangles_come_back_within_what_is_said() {
    let whole = of_bowl(30);
    let back = read(&write_as(&whole, Compression::Meshopt).unwrap()).unwrap();
    assert_eq!((&back.materials, &back.images, &back.label), (&whole.materials, &whole.images, &whole.label));
    let (old, new) = (&whole.parts[0].mesh, &back.parts[0].mesh);
    assert_eq!(new.positions.len(), old.positions.len() - 1, "the vertex of no triangle is gone");
    let (a, b) = (corners(old, 30), corners(new, 30));
    assert_eq!(a.len(), old.triangles.len());
    assert!(a.keys().eq(b.keys()));
    let mut worst = [0.0f64; 3];
    for (from, to) in a.values().zip(b.values()).flat_map(|(a, b)| a.iter().zip(b)) {
        for axis in 0..3 {
            worst[0] = worst[0].max((old.positions[*from][axis] - new.positions[*to][axis]).abs());
        }
        let (n, m) = (old.normals[*from].map(f64::from), new.normals[*to].map(f64::from));
        worst[1] = worst[1].max(crate::mesh::dot(crate::mesh::cross(n, m), crate::mesh::cross(n, m)).sqrt());
        for axis in 0..2 {
            worst[2] = worst[2].max(f64::from((old.uvs[*from][axis] - new.uvs[*to][axis]).abs()));
        }
    }
    // 2⁻¹⁸ of 4 m, the power of two above 3, after the rounding to f32; the sine of 0.06°; 2⁻¹⁶ of 2, the one above 1.
    assert!(
        worst[0] <= 4.0 / f64::from(1 << 18) + 4.0 / f64::from(1 << 25)
            && worst[1] < 0.06f64.to_radians()
            && worst[2] <= 2.0 / 65536.0,
        "{worst:?}"
    );
    assert!(worst.iter().all(|w| *w > 0.0), "rounded, not copied: {worst:?}");
}

#[test]
fn the_file_is_small_and_says_what_it_needs() {
    let whole = of_bowl(64);
    let (plain, packed) = (write(&whole).unwrap(), write_as(&whole, Compression::Meshopt).unwrap());
    assert!(packed.len() * 4 < plain.len(), "{} of {}", packed.len(), plain.len());
    let root: Value = serde_json::from_slice(container::split(&packed).unwrap().0).unwrap();
    assert_eq!(root["extensionsRequired"], json!(["EXT_meshopt_compression", "KHR_mesh_quantization"]));
    assert_eq!(root["buffers"][1]["extensions"]["EXT_meshopt_compression"]["fallback"], true);
    let view = &root["bufferViews"][0];
    assert_eq!(
        (&view["buffer"], &view["extensions"]["EXT_meshopt_compression"]["mode"]),
        (&json!(1), &json!("ATTRIBUTES"))
    );
    // Larger meshes have indices of four bytes.
    let long = of_bowl(130);
    let back = read(&write_as(&long, Compression::Meshopt).unwrap()).unwrap();
    assert!(back.parts[0].mesh.positions.len() > 65_536);
    assert!(corners(&long.parts[0].mesh, 130).keys().eq(corners(&back.parts[0].mesh, 130).keys()));
}

#[test]
fn broken_views_are_refused() {
    let good = write_as(&asset(), Compression::Meshopt).unwrap();
    let (json, bin) = container::split(&good).unwrap();
    let root: Value = serde_json::from_slice(json).unwrap();
    type Change = fn(&mut Value);
    let table: [(Change, &str); 8] = [
        (|v| v["count"] = 5_000_000.into(), "many times"),
        (|v| v["count"] = 3.into(), "inside its view"),
        (|v| v["byteStride"] = 6.into(), "packed"),
        (|v| v["byteLength"] = 5.into(), "packed"),
        (|v| v["byteOffset"] = u32::MAX.into(), "packed bytes inside"),
        (|v| v["mode"] = "LINES".into(), "the mode LINES"),
        (|v| v["filter"] = "COLOR".into(), "the filter COLOR"),
        (|v| v["buffer"] = 1.into(), "outside the file"),
    ];
    for (change, says) in table {
        let mut root = root.clone();
        change(&mut root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]);
        let error = read(&container::join(root.to_string().as_bytes(), bin).unwrap()).unwrap_err().to_string();
        assert!(error.contains(says), "{error:?} should say {says:?}");
    }
    // The successor has the same JSON.
    let renamed = root.to_string().replace("EXT_meshopt_compression", "KHR_meshopt_compression");
    assert_eq!(read(&container::join(renamed.as_bytes(), bin).unwrap()).unwrap(), read(&good).unwrap());
}
