//! Layout, round trips, foreign files, hostile bytes.

use super::*;
use proptest::prelude::*;

fn any_splats() -> impl Strategy<Value = Splats> {
    let number = || -1e3..1e3f32;
    let splat = (
        prop::array::uniform3(number()),
        prop::array::uniform3(number()),
        prop::array::uniform4(number()),
        number(),
        prop::array::uniform16(prop::array::uniform3(number())),
    );
    prop::collection::vec(splat, 0..8).prop_map(|splats| Splats {
        positions: splats.iter().map(|s| s.0).collect(),
        log_scales: splats.iter().map(|s| s.1).collect(),
        rotations: splats.iter().map(|s| s.2).collect(),
        logit_opacities: splats.iter().map(|s| s.3).collect(),
        sh: splats.iter().map(|s| s.4).collect(),
    })
}

/// One splat whose values tell where they belong.
fn one() -> Splats {
    Splats {
        positions: vec![[1.0, 2.0, 3.0]],
        log_scales: vec![[-1.0, -2.0, -3.0]],
        rotations: vec![[0.5, -0.5, 0.25, 0.75]],
        logit_opacities: vec![4.5],
        sh: vec![std::array::from_fn(|basis| std::array::from_fn(|channel| (basis * 10 + channel) as f32))],
    }
}

#[test]
fn columns_stand_in_the_customary_order() {
    let bytes = write(&one(), &["UNCLASSIFIED".into(), "origin 1 2 3".into()]).unwrap();
    let end = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    let head = std::str::from_utf8(&bytes[..end]).unwrap();
    let start = "ply\nformat binary_little_endian 1.0\ncomment UNCLASSIFIED\ncomment origin 1 2 3\nelement vertex 1\n";
    assert!(head.starts_with(start), "{head}");
    let names: Vec<&str> = head.lines().filter_map(|l| l.strip_prefix("property float ")).collect();
    let floats: Vec<f32> = bytes[end..].chunks(4).map(|b| f32::from_le_bytes(b.try_into().unwrap())).collect();
    assert_eq!((names.len(), floats.len()), (62, 62));
    let value = |name: &str| floats[names.iter().position(|n| *n == name).unwrap()];
    assert_eq!(names[..7], ["x", "y", "z", "nx", "ny", "nz", "f_dc_0"]);
    assert_eq!(
        names[53..],
        ["f_rest_44", "opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"]
    );
    assert_eq!([value("z"), value("nx"), value("f_dc_2"), value("opacity")], [3.0, 0.0, 2.0, 4.5]);
    // Channel-major: all of red, then green, then blue.
    assert_eq!([value("f_rest_0"), value("f_rest_1"), value("f_rest_14")], [10.0, 20.0, 150.0]);
    assert_eq!([value("f_rest_15"), value("f_rest_30"), value("f_rest_44")], [11.0, 12.0, 152.0]);
    assert_eq!([value("scale_1"), value("rot_0"), value("rot_3")], [-2.0, 0.5, 0.75]);
}

/// The same splat as other programs may write it: names sorted backwards, degree 1, an element before with lists, a
/// list in the vertex, number types mixed.
fn foreign(format: &str) -> Vec<u8> {
    let splat = one();
    let mut fields: Vec<(String, f32)> = Vec::new();
    let mut group = |prefix: &str, values: &[f32]| {
        fields.extend(values.iter().enumerate().map(|(i, v)| (format!("{prefix}{i}"), *v)));
    };
    group("rot_", &splat.rotations[0]);
    group("scale_", &splat.log_scales[0]);
    group("f_dc_", &splat.sh[0][0]);
    let rest: Vec<f32> = (0..3).flat_map(|c| (1..4).map(move |b| (b * 10 + c) as f32)).collect();
    group("f_rest_", &rest);
    fields.extend([("opacity".into(), 4.5), ("y".into(), 2.0), ("x".into(), 1.0), ("z".into(), 3.0)]);
    fields.reverse();
    let mut out =
        format!("ply\r\nformat {format} 1.0\r\ncomment  two spaces\r\nobj_info x\r\ncomment\r\n").into_bytes();
    out.extend(b"element face 2\r\nproperty list uchar int vertex_indices\r\nproperty short flags\r\n");
    out.extend(b"element empty 1000000000000\r\nelement vertex 1\r\nproperty list ushort double extra\r\n");
    for (index, (name, _)) in fields.iter().enumerate() {
        let kind = if index % 2 == 0 { "float64" } else { "float" };
        out.extend(format!("property {kind} {name}\r\n").bytes());
    }
    out.extend(b"property uint8 flag\r\nelement after 9\r\nproperty int n\r\nend_header\r\n");
    let big = format == "binary_big_endian";
    let ascii = format == "ascii";
    let mut put = |value: f64, size: usize, float: bool| {
        if ascii {
            out.extend(format!("{value} ").bytes());
            return;
        }
        let mut bytes = match (size, float) {
            (8, _) => value.to_le_bytes().to_vec(),
            (4, true) => (value as f32).to_le_bytes().to_vec(),
            _ => (value as i64).to_le_bytes()[..size].to_vec(),
        };
        if big {
            bytes.reverse();
        }
        out.extend(bytes);
    };
    for face in [&[3.0, 0.0, 1.0, 2.0][..], &[0.0]] {
        put(face[0], 1, false);
        face[1..].iter().for_each(|&v| put(v, 4, false));
        put(-7.0, 2, false);
    }
    put(2.0, 2, false);
    put(0.5, 8, true);
    put(0.25, 8, true);
    for (index, (_, value)) in fields.iter().enumerate() {
        put(f64::from(*value), if index % 2 == 0 { 8 } else { 4 }, true);
    }
    put(255.0, 1, false);
    out // the element after is cut off, and not needed
}

#[test]
fn foreign_files_read_by_name() {
    let mut expected = one();
    expected.sh[0][4..].fill([0.0; 3]);
    for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
        let (splats, comments) = read(&foreign(format)).unwrap();
        assert_eq!(splats, expected, "{format}");
        assert_eq!(comments, [" two spaces", ""]);
    }
}

#[test]
fn degrees_follow_from_the_number_of_coefficients() {
    let text = |rest: usize| {
        let mut names: Vec<String> = ["x", "y", "z", "opacity"].map(String::from).into();
        names.extend((0..3).flat_map(|i| [format!("f_dc_{i}"), format!("scale_{i}")]));
        names.extend((0..4).map(|i| format!("rot_{i}")).chain((0..rest).map(|i| format!("f_rest_{i}"))));
        let properties: String = names.iter().map(|n| format!("property float {n}\n")).collect();
        let values: String = (0..names.len()).map(|i| format!("{}\n", i.saturating_sub(13))).collect();
        format!("ply\nformat ascii 1.0\nelement vertex 1\n{properties}end_header\n{values}")
    };
    for (rest, per_channel) in [(0, 0), (9, 3), (24, 8), (45, 15)] {
        let (splats, _) = read(text(rest).as_bytes()).unwrap();
        for (basis, rgb) in splats.sh[0].iter().enumerate().skip(1) {
            let value = |c: usize| if basis <= per_channel { (c * per_channel + basis) as f32 } else { 0.0 };
            assert_eq!(*rgb, [value(0), value(1), value(2)], "{rest} {basis}");
        }
    }
    for rest in [1, 8, 27, 46, 72] {
        assert!(matches!(read(text(rest).as_bytes()), Err(Error::Unsupported { .. })), "{rest}");
    }
}

#[test]
fn broken_files_are_refused() {
    let good = write(&one(), &[]).unwrap();
    let with = |from: &str, to: &str| {
        let at = good.windows(from.len()).position(|w| w == from.as_bytes()).unwrap();
        [&good[..at], to.as_bytes(), &good[at + from.len()..]].concat()
    };
    let table = [
        (Vec::new(), "a header line, found the end"),
        (with("ply", "plx"), "at byte 0: expected the first line to be ply"),
        (with("binary_little", "binary_middle"), "expected format ascii"),
        (with("format binary_little_endian 1.0\n", ""), "a format line"),
        (with("element vertex 1", "element vertex -1"), "the number of elements"),
        (with("element vertex 1", "element vertex 2"), "2 vertex elements of at least 248 bytes, found 248 bytes"),
        (with("element vertex 1", "element vertex 18446744073709551615"), "of at least 248 bytes"),
        (with("element vertex 1", "element points 1"), "an element called vertex"),
        (with("element vertex 1\n", ""), "an element before this property"),
        (with("float opacity", "float opacitx"), "a vertex property opacity"),
        (with("float x", "real x"), "the type of a property"),
        (with("end_header", "end header"), "format, comment, element, property or end_header"),
        (good[..good.len() - 1].to_vec(), "of at least 248 bytes"),
    ];
    for (bytes, says) in table {
        let error = read(&bytes).unwrap_err().to_string();
        assert!(error.contains(says), "{error:?} should say {says:?}");
    }
    let list = b"ply\nformat ascii 1.0\nelement a 1\nproperty list int int l\nelement vertex 0\nend_header\n-5\n";
    assert!(read(list).unwrap_err().to_string().contains("the length of a list"));
}

#[test]
fn what_cannot_be_written_is_refused() {
    let mut splats = one();
    splats.sh[0][7][1] = f32::NAN;
    assert!(write(&splats, &[]).unwrap_err().to_string().contains("splat 0 of 1"));
    let mut splats = one();
    splats.rotations.clear();
    assert!(write(&splats, &[]).unwrap_err().to_string().contains("0 rotations"));
    for comment in ["two\nlines", "Größe", "end\r"] {
        assert!(write(&one(), &[comment.into()]).is_err(), "{comment:?}");
    }
}

proptest! {
    #[test]
    fn what_is_written_reads_back_equal(splats in any_splats(), comments in prop::collection::vec("[ -~]{0,60}", 0..4)) {
        let bytes = write(&splats, &comments).unwrap();
        prop_assert_eq!(read(&bytes).unwrap(), (splats, comments));
    }

    #[test]
    fn damaged_files_never_panic(
        which in 0..4usize,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6),
        cut in any::<prop::sample::Index>(),
    ) {
        let mut bytes = match which {
            0 => write(&one(), &["a".into()]).unwrap(),
            n => foreign(["ascii", "binary_little_endian", "binary_big_endian"][n - 1]),
        };
        for (at, value) in changes {
            let at = at.index(bytes.len());
            bytes[at] = value;
        }
        let _ = read(&bytes);
        bytes.truncate(cut.index(bytes.len()));
        let _ = read(&bytes);
    }
}
