//! Known answer, round trips, foreign structures, hostile bytes.

use super::header::Header;
use super::record::{Writer, opcode};
use super::write::{drawn, write_with};
use super::{Level, Model, check, read, write};
use crate::{Error, Mesh};
use proptest::prelude::*;
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
    assert_eq!([52, 54, 56, 58].map(i16_at), [2, 3, 3, 25]);
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

/// A file with a quad, a scaled and mirrored group, a mesh with continued records, a hidden face, feet.
fn foreign() -> Vec<u8> {
    let mut out = Writer::with_capacity(0);
    Header { date: "d".into(), ..Header::of(&Model::default(), 0) }.write(&mut out);
    out.bytes[62] = 4; // feet
    out.begin(9999); // unknown
    out.u32(7);
    out.end();
    let square = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
    out.begin(opcode::VERTEX_PALETTE);
    out.i32(8 + 4 * 40);
    out.end();
    for p in square {
        out.begin(opcode::VERTEX_C); // without normal
        out.u32(0);
        out.f64s(&p);
        out.u32(u32::MAX);
        out.u32(0);
        out.end();
    }
    let node = |out: &mut Writer, code: u16, id: &str, rest: usize| {
        out.begin(code);
        out.text(id, 8);
        out.zeros(rest);
        out.end();
    };
    let face = |out: &mut Writer, id: &str, flags: u32, offsets: &[i32]| {
        out.begin(opcode::FACE);
        out.text(id, 8);
        out.zeros(16);
        out.i16(-1);
        out.i16(-1);
        out.zeros(12);
        out.u32(flags);
        out.zeros(32);
        out.end();
        out.control(opcode::PUSH);
        out.begin(opcode::VERTEX_LIST);
        offsets.iter().for_each(|&o| out.i32(o));
        out.end();
        out.control(opcode::POP);
    };
    out.control(opcode::PUSH);
    node(&mut out, opcode::GROUP, "root", 32);
    out.control(opcode::PUSH);
    node(&mut out, opcode::GROUP, "moved", 32);
    out.begin(opcode::MATRIX); // mirrored in x, moved by 10 in y
    out.f32s(&[-1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 10.0, 0.0, 1.0]);
    out.end();
    out.control(opcode::PUSH);
    node(&mut out, opcode::OBJECT, "o1", 16);
    out.control(opcode::PUSH);
    face(&mut out, "p1", 0, &[8, 48, 88, 128]);
    face(&mut out, "p2", super::read::HIDDEN, &[8, 48, 88]);
    out.control(opcode::POP);
    out.control(opcode::POP);
    // An LOD of revision 15.7, 72 bytes, with a mesh of three kinds of primitives.
    out.begin(opcode::LOD);
    out.text("l1", 8);
    out.zeros(4);
    out.f64s(&[100.0, 10.0]);
    out.zeros(8);
    out.f64s(&[1.0, 2.0, 3.0, 0.0]);
    out.end();
    out.control(opcode::PUSH);
    out.begin(opcode::MESH);
    out.text("m1", 8);
    out.zeros(20);
    out.i16(-1);
    out.i16(-1);
    out.zeros(48);
    out.end();
    out.begin(opcode::LOCAL_VERTEX_POOL);
    out.u32(5);
    out.u32(0xD800_0000); // position, colour index, normal, texture coordinate
    let vertex = |out: &mut Writer, p: [f64; 3]| {
        out.f64s(&p);
        out.u32(0);
        out.f32s(&[0.0, 0.0, 1.0, p[0] as f32, p[1] as f32]);
    };
    vertex(&mut out, [0.0, 0.0, 1.0]);
    vertex(&mut out, [1.0, 0.0, 1.0]);
    out.end();
    out.begin(opcode::CONTINUATION);
    vertex(&mut out, [0.0, 1.0, 1.0]);
    out.end();
    out.begin(opcode::CONTINUATION);
    vertex(&mut out, [1.0, 1.0, 1.0]);
    vertex(&mut out, [0.0, 2.0, 1.0]);
    out.end();
    out.control(opcode::PUSH);
    let primitive = |out: &mut Writer, kind: i16, size: u16, indices: &[u32]| {
        out.begin(opcode::MESH_PRIMITIVE);
        out.i16(kind);
        out.u16(size);
        out.u32(indices.len() as u32);
        for i in indices {
            out.bytes.extend_from_slice(&i.to_be_bytes()[4 - usize::from(size)..]);
        }
        out.end();
    };
    primitive(&mut out, 1, 1, &[0, 1, 2, 3, 4]); // strip
    primitive(&mut out, 2, 2, &[0, 1, 3, 2]); // fan
    primitive(&mut out, 3, 4, &[0, 1, 2, 3]); // quad strip
    primitive(&mut out, 4, 2, &[0, 1, 2]); // polygon
    (0..4).for_each(|_| out.control(opcode::POP));
    out.bytes
}

#[test]
fn foreign_structures_are_understood() {
    let model = read(&foreign()).unwrap();
    assert_eq!((model.name.as_str(), model.date.as_str(), model.origin), ("root", "d", None));
    let [loose, lod] = &model.levels[..] else { panic!("{:?}", model.levels) };
    // The quad: mirrored, so its fan is turned to stay counter-clockwise; moved; feet; normals computed.
    let feet = 0.3048;
    assert_eq!(loose.mesh.positions.len(), 4);
    assert_eq!(loose.mesh.triangles, [[0, 2, 1], [0, 3, 2]]);
    assert_eq!(loose.mesh.bounds(), Some(([-2.0 * feet, 10.0 * feet, 0.0], [0.0, 12.0 * feet, 0.0])));
    assert_eq!(loose.mesh.normals, [[0.0, 0.0, 1.0]; 4]);
    assert_eq!((lod.name.as_str(), lod.switch_in, lod.switch_out), ("l1", 100.0 * feet, 10.0 * feet));
    assert_eq!((lod.significant_size, lod.center), (0.0, [feet, 2.0 * feet, 3.0 * feet]));
    let strip = [[0, 1, 2], [2, 1, 3], [2, 3, 4]];
    let fan_quads_polygon = [[0, 1, 3], [0, 3, 2], [0, 1, 3], [0, 3, 2], [0, 1, 2]];
    assert_eq!(lod.mesh.triangles, [&strip[..], &fan_quads_polygon].concat());
    assert_eq!(lod.mesh.uvs[4], [0.0, 2.0]);
    let findings = check(&foreign());
    assert!(findings.iter().any(|f| f.contains("coordinate unit is 4 instead of 0")), "{findings:?}");
    assert!(findings.iter().any(|f| f.contains("72 bytes instead of 80")), "{findings:?}");
    assert_eq!(findings.len(), 2, "{findings:?}");
}

#[test]
fn checks_find_what_is_broken() {
    // Offsets of the known-answer file's records.
    let table: &[(usize, &[u8], &str)] = &[
        (0, &[0, 2], "At byte 0: expected a header record"),
        (12, &[0, 0, 6, 0x4a], "format revision is 1610 instead of 1600"),
        (62, &[1], "coordinate unit is 1 instead of 0"),
        (268, &[0, 0, 0, 4], "ellipsoid is 4"),
        (292, &[0x7f, 0xf8], "At byte 292: a header number is not finite"),
        (4554, &[0, 82], "expected a length of at least 4"),
        (4556, &[0, 0, 0, 1], "At byte 5358: the palettes have no material 0"),
        (4640, b"/", "\"/ri.rgb\" is not relative"),
        (4641, b"\\", "backslashes"),
        (4640, &[0xe9], "texture path is not ASCII"),
        (4840, &[0, 0, 0, 9], "At byte 5356: the palettes have no texture 0"),
        (4856, &[0, 0, 0, 199], "says 199 bytes but has 200"),
        (4892, &[0x3f, 0x80], "At byte 4860: a normal has length 1.414"),
        (4868, &[0x7f, 0xf0], "At byte 4860: a vertex has a number that is not finite"),
        (4932, &[0xbf], "At byte 5152: the bounding box"),
        (4852, &[0, 68], "At byte 4860: expected vertex records right after the palette"),
        (4924, &[0, 67], "At byte 4988: expected vertex records right after the palette"),
        (5052, &[0, 11], "expected a push before this pop"),
        (5184, &[0x3f, 0xe0], "At byte 5152: the bounding box"),
        (5228, &[0; 8], "leave no distance"),
        (5284, &[0xbf], "the significant size is -1.414"),
        (5216, b"o", "the ID \"o1\" is used twice"),
        (5416, &[0, 0, 0, 9], "At byte 5416: no vertex record begins at palette offset 9"),
        (5416, &[0, 0, 0, 72], "two corners at one position"),
        (5418, &[0, 72, 0, 0, 0, 8], "1 of 1 triangles are wound against"),
        (5444, &[0, 10], "expected a pop for every push"),
    ];
    let good = write(&triangle()).unwrap();
    for (at, bytes, says) in table {
        let mut bad = good.clone();
        bad[*at..at + bytes.len()].copy_from_slice(bytes);
        let findings = check(&bad);
        assert!(findings.iter().any(|f| f.contains(says)), "{at}: {findings:?} should say {says:?}");
    }
    let longer = [&good[..], &[0; 4]].concat();
    assert_eq!(check(&longer), ["At byte 5448: 4 bytes follow the last pop, and readers will not see them."]);
    assert!(check(&[])[0].contains("an empty file"));
}

#[test]
fn checks_compare_sibling_levels() {
    type Change = fn(&mut Model);
    let table: [(Change, &str); 4] = [
        (|m| m.levels[1].center[0] = 1.0, "differs from the sibling's"),
        (|m| m.levels[1].switch_in = 299.0, "does not meet the coarser sibling's switch-out 300"),
        (|m| m.levels[1].significant_size = 3.4, "is not below the coarser sibling's 3.4"),
        (|m| m.levels.swap(0, 1), "is not below the coarser sibling's 0.1"),
    ];
    for (change, says) in table {
        let mut model = two_levels();
        change(&mut model);
        let findings = check(&write(&model).unwrap());
        assert!(findings.iter().any(|f| f.contains(says)), "{findings:?} should say {says:?}");
    }
}

fn any_level(textures: usize) -> impl Strategy<Value = Level> {
    // Few values, so that identical vertices and degenerate triangles happen.
    let coordinate = prop_oneof![Just(0.0), Just(-0.0), Just(1.0), -1e4..1e4f64];
    let vertex =
        (prop::array::uniform3(coordinate), prop::array::uniform3(-1.0..1f32), prop::array::uniform2(0.0..2f32));
    (prop::collection::vec(vertex, 3..30), 0..=textures, 0.0..1e3f64, 1e-3..1e3f64).prop_flat_map(
        move |(vertices, texture, near, size)| {
            let count = vertices.len() as u32;
            prop::collection::vec(prop::array::uniform3(0..count), 1..40).prop_map(move |triangles| Level {
                switch_in: near + size,
                switch_out: near,
                significant_size: size,
                texture: (texture < textures).then_some(texture),
                mesh: Mesh {
                    positions: vertices.iter().map(|v| v.0).collect(),
                    normals: vertices.iter().map(|v| v.1).collect(),
                    uvs: vertices.iter().map(|v| v.2).collect(),
                    triangles,
                },
                ..Level::default()
            })
        },
    )
}

fn any_model() -> impl Strategy<Value = Model> {
    let levels = prop::collection::vec(any_level(3), 1..4);
    (levels, "[ -~]{0,40}", prop::option::of((-90.0..90.0f64, -180.0..180.0f64)), prop::option::of("[ -~]{0,70}"))
        .prop_map(|(mut levels, name, origin, comment)| {
            levels.retain(|l| drawn(l).next().is_some());
            for (index, level) in levels.iter_mut().enumerate() {
                level.name = format!("level number {}", index + 1);
            }
            Model {
                name: format!("N{name}"),
                date: "2024".into(),
                origin,
                header_comment: comment.clone(),
                zone_comment: comment,
                textures: (0..3).map(|i| format!("t/{i}.rgb")).collect(),
                levels,
            }
        })
        .prop_filter("a level", |m| !m.levels.is_empty())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn any_model_reads_back_equal(model in any_model()) {
        let bytes = write(&model).unwrap();
        let back = read(&bytes).unwrap();
        prop_assert_eq!(frame(&back), frame(&model));
        for (b, m) in back.levels.iter().zip(&model.levels) {
            prop_assert_eq!(corners(b), corners(m));
        }
        // Once read, nothing changes any more.
        prop_assert_eq!(write(&back).unwrap().len(), bytes.len());
        let again = read(&write(&back).unwrap()).unwrap();
        assert_equal(&again, &back);
    }

    #[test]
    fn damaged_files_are_refused_or_read_but_never_panic(
        model in any_model(),
        foreign_file in any::<bool>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        cut in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let mut bytes = if foreign_file { foreign() } else { write(&model).unwrap() };
        for (at, value) in changes {
            let at = at.index(bytes.len());
            bytes[at] = value;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        let _ = check(&bytes);
        if let Ok(model) = read(&bytes) {
            for level in &model.levels {
                prop_assert_eq!(level.mesh.positions.len(), level.mesh.normals.len());
                let count = level.mesh.positions.len() as u32;
                prop_assert!(level.mesh.triangles.iter().flatten().all(|&v| v < count));
            }
        }
    }

    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let _ = (read(&bytes), check(&bytes));
        let header = write(&triangle()).unwrap();
        let after = [&header[..5056], &bytes].concat();
        let _ = (read(&after), check(&after));
    }
}

#[test]
fn every_cut_of_a_file_is_refused() {
    for bytes in [write(&two_levels()).unwrap(), foreign()] {
        // The last byte that matters is the last pop's.
        for end in (0..bytes.len()).step_by(7).chain([bytes.len() - 4, bytes.len() - 1]) {
            // Without any push there is no level to be left open.
            let whole_palettes = end >= 324 && read(&bytes[..end]).is_ok_and(|m| m.levels.is_empty());
            assert!(whole_palettes || read(&bytes[..end]).is_err(), "{end}");
        }
    }
}
