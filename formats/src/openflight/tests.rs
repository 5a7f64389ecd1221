//! Known answer, round trips, what is refused.

mod checks;
mod foreign;
mod properties;

use super::header::Header;
use super::record::opcode;
use super::write::{drawn, write_with};
use super::{Geometry, Level, Model, Point, check, read, write, write_as};
use crate::{Error, Mesh};
use sha2::{Digest, Sha256};

/// One textured triangle.
#[allow(clippy::approx_constant)] // the known answer has these digits
fn triangle() -> Model {
    Model {
        name: "KatTriangle".into(),
        date: "Mon Jan  1 00:00:00 2024".into(),
        origin: Some((34.5523, -118.4712)),
        header_comment: None,
        zone_comment: Some("<CDB:Zone name=\"KatTriangle\"/>".into()),
        textures: vec!["tri.rgb".into()],
        levels: vec![Level {
            name: "l1".into(),
            switch_in: 1000.0,
            switch_out: 0.0,
            transition: 0.0,
            significant_size: 1.4142135,
            center: [0.5, 0.5, 0.0],
            texture: Some(0),
            mesh: Mesh {
                positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
                normals: vec![[0.0, 0.0, 1.0]; 3],
                uvs: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
                triangles: vec![[0, 1, 2]],
            },
        }],
        points: vec![],
    }
}

/// A box of six sides with a normal each, from `lo` to `hi`.
fn cuboid(lo: [f64; 3], hi: [f64; 3]) -> Mesh {
    let mut mesh = Mesh::default();
    for axis in 0..3 {
        for (side, end) in [(-1.0f32, lo[axis]), (1.0, hi[axis])] {
            let (u, v) = if side > 0.0 { ((axis + 1) % 3, (axis + 2) % 3) } else { ((axis + 2) % 3, (axis + 1) % 3) };
            let first = mesh.positions.len() as u32;
            for (s, t) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
                let mut p = [end; 3];
                p[u] = [lo[u], hi[u]][s];
                p[v] = [lo[v], hi[v]][t];
                let mut n = [0.0; 3];
                n[axis] = side;
                mesh.positions.push(p);
                mesh.normals.push(n);
                mesh.uvs.push([s as f32, t as f32]);
            }
            mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        }
    }
    mesh
}

/// Two levels: a cube, and before it a coarser one without texture.
fn two_levels() -> Model {
    let level = |name: &str, switch_in, switch_out, significant_size, texture, size: f64| Level {
        name: name.into(),
        switch_in,
        switch_out,
        transition: 1.5,
        significant_size,
        center: [0.0, 0.0, 1.0],
        texture,
        mesh: cuboid([-size, -size, 0.0], [size, size, 2.0 * size]),
    };
    let mut far = level("a far level with a long name", 10_000.0, 300.0, 3.4, None, 0.9);
    far.mesh.uvs.fill([0.0, 0.0]); // what a level without texture reads back
    Model {
        name: "Crate".into(),
        date: "Tue Feb  6 12:34:56 2024".into(),
        origin: Some((-33.9, 151.2)),
        header_comment: Some("UNCLASSIFIED//invented for a test".into()),
        zone_comment: Some("<CDB:Zone name=\"Crate\">\n  <Material>1</Material>\n</CDB:Zone>".into()),
        textures: vec!["tex/crate_a.rgb".into(), "../../b/crate.rgb".into()],
        levels: vec![far, level("near", 300.0, 0.0, 0.1, Some(1), 1.0)],
        points: vec![Point {
            comment: "<CDB:Point name=\"DIS_Origin\"/>".into(),
            matrix: [[0.0, 1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0], [0.25, -0.5, 1.0, 1.0]],
        }],
    }
}

/// What a reader may not change: the drawn corners in order, bit for bit; texture coordinates only where textured.
type Corners = Vec<([u64; 3], [u32; 3], [u32; 2])>;

fn corners(level: &Level) -> Corners {
    let m = &level.mesh;
    let corner = |v: u32| {
        let v = v as usize;
        let uv = level.texture.map(|_| m.uvs[v]).unwrap_or_default();
        (m.positions[v].map(f64::to_bits), m.normals[v].map(f32::to_bits), uv.map(f32::to_bits))
    };
    drawn(level).flatten().map(corner).collect()
}

/// The model without its meshes.
fn frame(model: &Model) -> Model {
    let mut frame = model.clone();
    frame.levels.iter_mut().for_each(|l| l.mesh = Mesh::default());
    frame
}

fn assert_equal(read: &Model, written: &Model) {
    assert_eq!(frame(read), frame(written));
    for (r, w) in read.levels.iter().zip(&written.levels) {
        assert_eq!(corners(r), corners(w));
    }
}

#[test]
fn known_answer_file() {
    // The known answer has every free-ID field 1 and a north-east corner at the origin: a header of its own.
    let model = triangle();
    let at = (34.5523, -118.4712);
    let header = Header {
        date: model.date.clone(),
        next_ids: [1; 4],
        next_mesh: 1,
        southwest: [0.0; 2],
        corners: [at; 2],
        origin: at,
        radius: 1.0,
    };
    let known = write_with(&model, &header, 1).unwrap();
    assert_eq!(known.len(), 5448);
    let digest: String = Sha256::digest(&known).iter().map(|b| format!("{b:02x}")).collect();
    assert_eq!(digest, "637f58d254275efc5c24032a18ff264bbcb5cb3d3e6a9503149c10341f3a88d6");
    // The writer's own header differs in just those fields.
    let own = write(&model).unwrap();
    let differing: Vec<usize> = (0..known.len()).filter(|&i| known[i] != own[i]).collect();
    assert!(differing.iter().all(|i| (52..60).contains(i) || (204..220).contains(i)), "{differing:?}");
    assert_eq!(own[52..60], [0, 2, 0, 2, 0, 2, 0, 2]);
}

#[test]
fn what_is_written_reads_back_equal() {
    for model in [triangle(), two_levels()] {
        let bytes = write(&model).unwrap();
        assert_eq!(read(&bytes).unwrap(), model, "all vertices used once and distinct: equal to the index");
        assert_eq!(check(&bytes), Vec::<String>::new());
    }
    let bare = Model { origin: None, zone_comment: None, ..triangle() };
    assert_eq!(read(&write(&bare).unwrap()).unwrap(), bare);
    let equator = Model { origin: Some((0.0, 0.0)), ..triangle() };
    assert_eq!(read(&write(&equator).unwrap()).unwrap(), equator);
}

#[test]
fn identical_vertices_are_written_once() {
    let mut model = two_levels();
    model.levels[0] = Level { texture: Some(1), mesh: model.levels[1].mesh.clone(), ..model.levels[0].clone() };
    let count = |bytes: &[u8]| super::tree::Tree::of(bytes).vertices.len();
    let bytes = write(&model).unwrap();
    assert_eq!(count(&bytes), 24);
    assert_equal(&read(&bytes).unwrap(), &model);
    // Triangles without shared corners say the same.
    let mesh = &mut model.levels[1].mesh;
    let order: Vec<usize> = mesh.triangles.iter().flatten().map(|&v| v as usize).collect();
    *mesh = Mesh {
        positions: order.iter().map(|&v| mesh.positions[v]).collect(),
        normals: order.iter().map(|&v| mesh.normals[v]).collect(),
        uvs: order.iter().map(|&v| mesh.uvs[v]).collect(),
        triangles: (0..order.len() as u32 / 3).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect(),
    };
    assert_eq!(write(&model).unwrap(), bytes);
}

#[test]
fn triangles_that_cover_nothing_are_left_out() {
    let mut model = triangle();
    let mesh = &mut model.levels[0].mesh;
    mesh.positions.push([0.0, 0.0, 0.0]);
    mesh.normals.push([0.0, 0.0, 1.0]);
    mesh.uvs.push([0.5, 0.5]);
    mesh.triangles.extend([[0, 3, 1], [2, 2, 1]]);
    let bytes = write(&model).unwrap();
    assert_eq!(bytes, write(&triangle()).unwrap());
    mesh_only(&mut model, vec![[0, 3, 1]]);
    assert!(write(&model).unwrap_err().to_string().contains("no triangle to draw"));
}

fn mesh_only(model: &mut Model, triangles: Vec<[u32; 3]>) {
    model.levels[0].mesh.triangles = triangles;
}

#[test]
fn the_header_counts_and_measures() {
    let bytes = write(&two_levels()).unwrap();
    let i16_at = |at: usize| i16::from_be_bytes([bytes[at], bytes[at + 1]]);
    assert_eq!([52, 54, 56, 58].map(i16_at), [3, 3, 3, 25]); // the root and a point are groups
    let f64_at = |at: usize| f64::from_be_bytes(bytes[at..at + 8].try_into().unwrap());
    assert_eq!((f64_at(132), f64_at(140)), (-1.0, -1.0));
    assert_eq!(f64_at(292), 6.0f64.sqrt()); // the corner (1, 1, 2)
    assert!(f64_at(188) < -33.9 && f64_at(204) > -33.9 && f64_at(196) < 151.2 && f64_at(212) > 151.2);
}

#[test]
fn what_does_not_fit_is_refused() {
    type Change = fn(&mut Model);
    let table: [(Change, &str); 18] = [
        (|m| m.name = "Größe".into(), "printable ASCII"),
        (|m| m.date = "x".repeat(32), "32 bytes, at most 31 fit"),
        (|m| m.header_comment = Some("y".repeat(65528)), "at most 65527 fit"),
        (|m| m.zone_comment = Some("\0".into()), "printable ASCII"),
        (|m| m.origin = Some((91.0, 0.0)), "±90"),
        (|m| m.origin = Some((0.0, f64::NAN)), "±180"),
        (|m| m.textures[0] = "/tmp/a.rgb".into(), "relative"),
        (|m| m.textures[0] = "a\\b.rgb".into(), "relative"),
        (|m| m.textures[0] = "t".repeat(200), "at most 199 fit"),
        (|m| m.levels.clear(), "at least one level"),
        (|m| m.levels[0].name = "p1".into(), "unique"),
        (|m| m.levels[0].name = m.name.clone(), "unique"),
        (|m| m.levels[0].switch_in = 0.0, "never drawn"),
        (|m| m.levels[0].significant_size = f64::INFINITY, "finite"),
        (|m| m.levels[0].center[2] = f64::NAN, "finite"),
        (|m| m.levels[0].texture = Some(1), "does not exist"),
        (|m| m.levels[0].mesh.triangles.clear(), "no triangle"),
        (|m| m.levels[0].mesh.triangles[0][2] = 3, "names vertices"),
    ];
    for (change, says) in table {
        let mut model = triangle();
        change(&mut model);
        match write(&model) {
            Err(Error::Unsupported { what, .. }) => assert!(what.contains(says), "{what:?} should say {says:?}"),
            other => panic!("{says}: {other:?}"),
        }
    }
}

#[test]
fn face_numbers_past_seven_characters_have_long_ids() {
    // A million faces of three vertices: p1000000 needs eight characters.
    let mut model = triangle();
    model.levels[0].mesh.triangles = vec![[0, 1, 2]; 1_000_001];
    let bytes = write(&model).unwrap();
    let tree = super::tree::Tree::of(&bytes);
    let last: Vec<String> =
        tree.nodes.iter().rev().filter(|n| n.record.opcode == opcode::FACE).take(3).map(|n| n.name()).collect();
    assert_eq!(last, ["p1000001", "p1000000", "p999999"]);
}

#[test]
fn meshes_read_back_equal() {
    for model in [triangle(), two_levels()] {
        let bytes = write_as(&model, Geometry::Meshes).unwrap();
        assert_eq!(read(&bytes).unwrap(), model);
        assert_eq!(check(&bytes), Vec::<String>::new());
        assert!(bytes.len() < write(&model).unwrap().len());
    }
}

/// Pools of 2,000 and 70,000 vertices: two and four bytes an index, continuation records.
#[test]
fn long_pools_are_continued() {
    for columns in [1000u32, 35_000] {
        let mut model = triangle();
        let mesh = &mut model.levels[0].mesh;
        *mesh = Mesh::default();
        for i in 0..columns {
            for y in [0.0, 1.0] {
                mesh.positions.push([f64::from(i) * 0.01, y, 0.0]);
                mesh.normals.push([0.0, 0.0, 1.0]);
                mesh.uvs.push([i as f32 / columns as f32, y as f32]);
            }
        }
        mesh.triangles =
            (1..columns).flat_map(|i| [[2 * i - 2, 2 * i, 2 * i + 1], [2 * i - 2, 2 * i + 1, 2 * i - 1]]).collect();
        let bytes = write_as(&model, Geometry::Meshes).unwrap();
        assert_eq!(read(&bytes).unwrap(), model);
        assert_eq!(check(&bytes), Vec::<String>::new());
        let mut at = 0;
        let mut pieces = Vec::new();
        while at < bytes.len() {
            let word = |i: usize| usize::from(u16::from_be_bytes([bytes[at + i], bytes[at + i + 1]]));
            if [opcode::LOCAL_VERTEX_POOL, opcode::CONTINUATION].contains(&(word(0) as u16)) {
                pieces.push((word(2) - if pieces.is_empty() { 12 } else { 4 }) % 48);
            }
            at += word(2);
        }
        assert_eq!(pieces, vec![0; (columns as usize * 2 * 48).div_ceil(65_520)]);
    }
}
