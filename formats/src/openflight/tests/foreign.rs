//! A file of another program's making.

use crate::openflight::header::Header;
use crate::openflight::record::{Writer, opcode};
use crate::openflight::{Model, check, read};

/// A file with a quad, a scaled and mirrored group, a mesh with continued records, a hidden face, feet.
pub fn foreign() -> Vec<u8> {
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
    face(&mut out, "p2", crate::openflight::read::HIDDEN, &[8, 48, 88]);
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
