mod compressed;

use super::*;
use crate::asset::Asset;
use crate::asset::tests::{asset, label};
use crate::{Error, Label, Splats};
use serde_json::{Value, json};

fn splats(degree: usize) -> Splats {
    let bases = crate::splats::BASES[degree];
    let sh = |i: usize| {
        std::array::from_fn(|b| if b < bases { [0.1 * i as f32, b as f32 * 0.01 - 0.05, 0.2] } else { [0.0; 3] })
    };
    Splats {
        positions: vec![[0.0, 1.0, 2.0], [-1.0, 0.5, 0.25]],
        log_scales: vec![[-3.0, -4.0, -5.0], [0.5, -0.5, -9.0]],
        rotations: vec![[1.0, 0.0, 0.0, 0.0], [0.5, -0.5, 0.5, -0.5]],
        logit_opacities: vec![0.0, 3.0],
        sh: (0..2).map(sh).collect(),
    }
}

#[test]
fn what_is_written_reads_back_equal() {
    let asset = asset();
    assert_eq!(read(&write(&asset).unwrap()).unwrap(), asset);
    let unlabelled = Asset { label: Label::default(), ..asset };
    assert_eq!(read(&write(&unlabelled).unwrap()).unwrap(), unlabelled);
}

#[test]
fn splats_read_back_within_a_float() {
    for degree in 0..4 {
        let written = Asset { splats: Some(splats(degree)), label: label(), ..Asset::default() };
        let bytes = write(&written).unwrap();
        let (json, _) = container::split(&bytes).unwrap();
        let root: Value = serde_json::from_slice(json).unwrap();
        let primitive = &root["meshes"][0]["primitives"][0];
        let coefficients = primitive["attributes"].as_object().unwrap().keys().filter(|k| k.contains("_COEF_")).count();
        assert_eq!(coefficients, crate::splats::BASES[degree]);
        assert_eq!(root["extensionsUsed"], json!(["KHR_gaussian_splatting", "KHR_xmp_json_ld"]));
        let back = read(&bytes).unwrap().splats.unwrap();
        let original = written.splats.unwrap();
        assert_eq!(
            (&back.positions, &back.sh, &back.rotations),
            (&original.positions, &original.sh, &original.rotations)
        );
        for (a, b) in back.log_scales.iter().flatten().zip(original.log_scales.iter().flatten()) {
            assert!((a - b).abs() < 1e-5, "{a} {b}");
        }
        for (a, b) in back.logit_opacities.iter().zip(&original.logit_opacities) {
            assert!((a - b).abs() < 1e-5, "{a} {b}");
        }
    }
}

#[test]
fn the_file_is_y_up_and_its_textures_hang_down() {
    let bytes = write(&asset()).unwrap();
    let (json, bin) = container::split(&bytes).unwrap();
    let root: Value = serde_json::from_slice(json).unwrap();
    let float = |at: usize| f32::from_le_bytes(bin[at..at + 4].try_into().unwrap());
    let start = |accessor: usize| root["bufferViews"][accessor]["byteOffset"].as_u64().unwrap() as usize;
    // The vertex (1, 0.25, 2): 2 m up, in front of the viewer on −Z.
    assert_eq!([0, 4, 8].map(|i| float(start(0) + 24 + i)), [1.0, 2.0, -0.25]);
    // Its normal −Y faces the camera, +Z.
    assert_eq!([0, 4, 8].map(|i| float(start(1) + 24 + i)), [0.0, 0.0, 1.0]);
    assert_eq!([0, 4].map(|i| float(start(2) + 16 + i)), [1.0, 0.0]);
    assert_eq!(root["accessors"][0]["max"], json!([1.0, 2.0, -0.25]));
}

#[test]
fn the_marking_stands_three_times() {
    let bytes = write(&asset()).unwrap();
    let (json, _) = container::split(&bytes).unwrap();
    let root: Value = serde_json::from_slice(json).unwrap();
    let line = "CLASSIFICATION: UNCLASSIFIED";
    assert_eq!(root["asset"]["copyright"], line);
    assert_eq!(root["asset"]["extras"]["orb"]["marking"], line);
    assert_eq!(root["extensions"]["KHR_xmp_json_ld"]["packets"][0]["dc:rights"]["rdf:_1"]["@value"], line);
    assert_eq!(root["asset"]["extensions"]["KHR_xmp_json_ld"]["packet"], 0);
    assert!(root.get("extensionsRequired").is_none());
}

/// A file by hand: a strip in signed bytes, under a node that mirrors, scales, turns and moves.
fn foreign(change: impl FnOnce(&mut Value)) -> Vec<u8> {
    let corners: [[i8; 4]; 4] = [[0, 0, 0, 0], [127, 0, 0, 0], [0, 127, 0, 0], [127, 127, 0, 0]];
    let bin: Vec<u8> = corners.iter().flatten().map(|&b| b as u8).collect();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let mut root = json!({
        "asset": { "version": "2.0" },
        "nodes": [
            { "children": [1], "translation": [10.0, 0.0, 0.0] },
            { "mesh": 0, "name": "strip", "rotation": [0.0, 0.0, half, half], "scale": [2.0, -3.0, 1.0] },
        ],
        "scenes": [{ "nodes": [0] }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "mode": 5 }] }],
        "accessors": [{ "bufferView": 0, "componentType": 5120, "normalized": true, "count": 4, "type": "VEC3" }],
        "bufferViews": [{ "buffer": 0, "byteLength": 16, "byteStride": 4 }],
        "buffers": [{ "byteLength": 16 }],
    });
    change(&mut root);
    container::join(root.to_string().as_bytes(), &bin).unwrap()
}

#[test]
fn nodes_strips_and_integers_are_understood() {
    let asset = read(&foreign(|_| {})).unwrap();
    assert_eq!((asset.name.as_str(), asset.parts.len()), ("strip", 1));
    let mesh = &asset.parts[0].mesh;
    // x → 2x, y → −3y, a quarter turn about z, 10 along x; then (x, y, z) → (x, −z, y).
    let expected = [[10.0, 0.0, 0.0], [10.0, 0.0, 2.0], [13.0, 0.0, 0.0], [13.0, 0.0, 2.0]];
    for (p, e) in mesh.positions.iter().zip(expected) {
        assert!((0..3).all(|i| (p[i] - e[i]).abs() < 1e-9), "{p:?} {e:?}");
    }
    assert_eq!(mesh.triangles, [[0, 2, 1], [2, 3, 1]], "turned, because the node mirrors");
    for t in &mesh.triangles {
        let n = crate::mesh::face_normal(t.map(|v| mesh.positions[v as usize]));
        assert!(n[1] < 0.0 && mesh.normals[0][1] < -0.99, "{n:?}");
    }
}

#[test]
fn broken_files_are_refused() {
    type Change = fn(&mut Value);
    let table: [(Change, &str); 18] = [
        (|r| r["accessors"][0]["count"] = 0.into(), "at least one element of accessor 0"),
        (|r| r["extensionsRequired"] = json!(["KHR_texture_transform", "KHR_texture_basisu"]), "KHR_texture_basisu"),
        (|r| r["accessors"][0]["count"] = 5.into(), "accessor 0 inside its view"),
        (|r| r["accessors"][0]["count"] = u64::MAX.into(), "too often"),
        (|r| r["accessors"][0]["byteOffset"] = 8.into(), "accessor 0 inside its view"),
        (|r| r["accessors"][0]["componentType"] = 5124.into(), "component type"),
        (|r| r["accessors"][0]["type"] = "VEC2".into(), "accessor 0 of VEC3"),
        (|r| r["accessors"][0]["sparse"] = json!({}), "sparse"),
        (|r| r["bufferViews"][0]["byteLength"] = 17.into(), "buffer view 0 inside 16 bytes"),
        (|r| r["bufferViews"][0]["byteOffset"] = u64::MAX.into(), "buffer view 0 inside 16 bytes"),
        (|r| r["bufferViews"][0]["byteStride"] = 2.into(), "accessor 0 inside its view"),
        (|r| r["buffers"][0]["uri"] = "a.bin".into(), "outside the file"),
        (|r| r["nodes"][1]["mesh"] = 1.into(), "the mesh 1"),
        (|r| r["nodes"][1]["children"] = json!([0]), "at most 64 levels"),
        (|r| r["nodes"][0]["children"] = json!([1, 1, 1, 1, 1, 1, 1, 1, 1, 7]), "the node 7"),
        (|r| r["meshes"][0]["primitives"][0]["material"] = 0.into(), "the material 0"),
        (|r| r["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]), "KHR_draco_mesh_compression"),
        (|r| r["meshes"][0]["primitives"][0]["extensions"] = json!({ "KHR_gaussian_splatting": {} }), "ROTATION"),
    ];
    for (change, says) in table {
        let error = read(&foreign(change)).unwrap_err().to_string();
        assert!(error.contains(says), "{error:?} should say {says:?}");
    }
    let instances = foreign(|r| r["nodes"][0]["children"] = vec![1; 4000].into());
    assert!(read(&instances).is_ok(), "4000 nodes of 4 vertices cost 20 000 of 4 · 9000 bytes");
    let bomb = foreign(|r| {
        r["nodes"][0]["children"] = vec![1; 1000].into();
        r["nodes"][1]["children"] = vec![2; 1000].into();
        r["nodes"].as_array_mut().unwrap().push(json!({ "mesh": 0 }));
    });
    assert!(read(&bomb).unwrap_err().to_string().contains("too often"));
    let parts = |parts: usize, nodes: usize| {
        foreign(|r| {
            r["accessors"][0]["count"] = 1.into();
            r["meshes"][0]["primitives"] = vec![json!({ "attributes": { "POSITION": 0 } }); parts].into();
            r["nodes"][0]["children"] = vec![1; nodes].into();
        })
    };
    assert_eq!(read(&parts(10, 10)).unwrap().parts.len(), 100);
    assert!(read(&parts(2000, 2000)).unwrap_err().to_string().contains("too often"));
    assert!(read(&parts(10, 1000)).unwrap_err().to_string().contains("too often"), "a part takes more than its vertex");
    let cloud = Asset { splats: Some(splats(0)), ..Asset::default() };
    let again = |times: usize| {
        let bytes = write(&cloud).unwrap();
        let (json, bin) = container::split(&bytes).unwrap();
        let mut root: Value = serde_json::from_slice(json).unwrap();
        root["scenes"][0]["nodes"] = vec![0; times].into();
        read(&container::join(root.to_string().as_bytes(), bin).unwrap())
    };
    assert_eq!(again(100).unwrap().splats.unwrap().positions.len(), 200);
    assert!(again(8000).unwrap_err().to_string().contains("too often"), "a splat takes more than a vertex");
    let good = write(&asset()).unwrap();
    for (at, value, says) in
        [(0, b'x', "expected glTF"), (4, 1, "container version 2"), (9, 0xff, "bytes"), (16, b'X', "JSON chunk")]
    {
        let mut bad = good.clone();
        bad[at] = value;
        let error = read(&bad).unwrap_err().to_string();
        assert!(error.contains(says), "{error:?} should say {says:?}");
    }
    assert!((0..good.len()).all(|n| read(&good[..n]).is_err()));
}

/// The texture coordinates of a square whose own are its corners', under a base colour of such a texture.
fn square(texture: Value) -> Vec<[f32; 2]> {
    let bytes = foreign(|r| {
        r["extensionsRequired"] = json!(["KHR_texture_transform", "KHR_mesh_quantization", "KHR_materials_specular"]);
        r["materials"] = json!([{ "pbrMetallicRoughness": { "baseColorTexture": texture } }]);
        r["textures"] = json!([{}]);
        let (positions, mut corners) = (r["accessors"][0].clone(), r["accessors"][0].clone());
        corners["type"] = "VEC2".into();
        r["accessors"] = json!([positions, corners]);
        let primitive = &mut r["meshes"][0]["primitives"][0];
        primitive["attributes"]["TEXCOORD_1"] = 1.into();
        primitive["material"] = 0.into();
    });
    read(&bytes).unwrap().parts[0].mesh.uvs.iter().map(|&[u, v]| [u, 1.0 - v]).collect()
}

#[test]
fn texture_coordinates_are_the_material_s() {
    let near = |found: &[[f32; 2]], expected: [[f32; 2]; 4]| {
        let far = found.as_flattened().iter().zip(expected.as_flattened()).any(|(a, b)| (a - b).abs() > 1e-6);
        assert!(found.len() == 4 && !far, "{found:?} {expected:?}");
    };
    let with = |shift: Value| json!({ "index": 0, "texCoord": 1, "extensions": { "KHR_texture_transform": shift } });
    near(&square(json!({ "index": 0 })), [[0.0; 2]; 4]);
    near(&square(json!({ "index": 0, "texCoord": 1 })), [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
    let moved = [[0.25, 0.0], [0.75, 0.0], [0.25, 0.5], [0.75, 0.5]];
    near(&square(with(json!({ "scale": [0.5, 0.5], "offset": [0.25, 0.0] }))), moved);
    let own = json!({ "scale": [0.5, 0.5], "offset": [0.25, 0.0], "texCoord": 1 });
    near(&square(json!({ "index": 0, "extensions": { "KHR_texture_transform": own } })), moved);
    // The extension's own example: the lower left quarter of the picture, turned.
    let quarter = json!({ "offset": [0.0, 1.0], "rotation": std::f64::consts::FRAC_PI_2, "scale": [0.5, 0.5] });
    near(&square(with(quarter)), [[0.0, 1.0], [0.0, 0.5], [0.5, 1.0], [0.5, 0.5]]);
}

#[test]
fn what_does_not_fit_is_refused() {
    type Change = fn(&mut Asset);
    let table: [(Change, &str); 8] = [
        (|a| a.parts.clear(), "a mesh or splats"),
        (|a| a.parts[0].material = Some(2), "names material"),
        (|a| a.materials[0].image = Some(3), "names image 3 of 3"),
        (|a| a.images[0].media_type = "image/webp".into(), "image/webp"),
        (|a| a.materials[1].roughness = f32::NAN, "0..1"),
        (|a| a.parts[1].mesh.triangles = vec![[0, 0, 1]], "part 1"),
        (|a| a.parts[0].mesh.positions[0][0] = f64::NAN, "not finite"),
        (|a| a.splats = Some(Splats { log_scales: vec![[100.0; 3]; 2], ..splats(0) }), "splat 0"),
    ];
    for (change, says) in table {
        let mut bad = asset();
        change(&mut bad);
        match write(&bad) {
            Err(Error::Unsupported { what, .. }) => assert!(what.contains(says), "{what:?} should say {says:?}"),
            other => panic!("{says}: {other:?}"),
        }
    }
}
