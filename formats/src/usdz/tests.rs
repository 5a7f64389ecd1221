use super::*;
use crate::asset::tests::asset;
use crate::{Asset, Label};

#[test]
fn what_is_written_reads_back_equal() {
    let asset = asset();
    assert_eq!(read(&write(&asset).unwrap()).unwrap(), asset);
    assert_eq!(marking(&write(&asset).unwrap()).unwrap(), asset.label.marking);
    let unlabelled = Asset { label: Label::default(), ..asset };
    assert_eq!(read(&write(&unlabelled).unwrap()).unwrap(), unlabelled);
    assert_eq!(marking(&write(&unlabelled).unwrap()).unwrap(), "");
}

#[test]
fn files_are_stored_at_multiples_of_64() {
    let bytes = write(&asset()).unwrap();
    let mut at = 0;
    let mut names = Vec::new();
    let word = |at: usize, size: usize| bytes[at..at + size].iter().rev().fold(0usize, |v, b| v << 8 | usize::from(*b));
    while bytes[at..].starts_with(b"PK\x03\x04") {
        let (flags, method, size) = (word(at + 6, 2), word(at + 8, 2), word(at + 18, 4));
        let (name, extra) = (word(at + 26, 2), word(at + 28, 2));
        let data = at + 30 + name + extra;
        assert_eq!((flags & 8, method, data % 64), (0, 0, 0));
        names.push(String::from_utf8(bytes[at + 30..at + 30 + name].to_vec()).unwrap());
        at = data + size;
    }
    assert_eq!(names, ["model.usdc", "textures/image0.png", "textures/image1.png", "textures/image2.png"]);
}

#[test]
fn broken_packages_are_refused() {
    let good = write(&asset()).unwrap();
    assert!((0..good.len()).step_by(7).all(|n| read(&good[..n]).is_err()));
    let at = |text: &[u8]| good.windows(text.len()).position(|w| w == text).unwrap();
    let with = |at: usize, value: u8| {
        let mut bad = good.clone();
        bad[at] = value;
        bad
    };
    let layer = at(b"PXR-USDC");
    let table = [(with(layer, b'x'), "the content of model.usdc"), (with(at(b"PK\x05\x06"), b'x'), "a ZIP archive")];
    for (bytes, says) in table {
        let error = read(&bytes).unwrap_err().to_string();
        assert!(error.contains(says), "{error:?} should say {says:?}");
    }
    let layer = encode::encode(&layer::Spec::new("", layer::Kind::Root));
    let changed = |at: usize, value: u8| {
        let mut bad = layer.clone();
        bad[at] = value;
        bad
    };
    assert!(decode::decode(&layer).is_ok());
    for (bytes, says) in [
        (changed(0, b'x'), "PXR-USDC"),
        (changed(9, 3), "crate version 0.3.0"),
        (changed(9, 14), "crate version 0.14.0"),
        (changed(23, 1), "at most"),
        (changed(88, 3), "3 tokens"),
    ] {
        let error = decode::decode(&bytes).unwrap_err().to_string();
        assert!(error.contains(says), "{error:?} should say {says:?}");
    }
    let splats = Asset { splats: Some(crate::Splats::default()), ..asset() };
    assert!(write(&splats).unwrap_err().to_string().contains("splats"));
}

/// A layer of so many specs that share one set of so many fields, none of which has a text.
fn sharing(specs: usize, fields: usize) -> Vec<u8> {
    let numbers = |n: usize| -> Vec<i32> { (0..n as i32).collect() };
    let column = |values: &[i32]| {
        let packed = packing::pack_ints(values);
        [&(packed.len() as u64).to_le_bytes()[..], &packed].concat()
    };
    let count = |n: usize| (n as u64).to_le_bytes().to_vec();
    let packed = |bytes: &[u8]| {
        let packed = packing::pack(bytes);
        [count(packed.len()), packed].concat()
    };
    let yes = encode::INLINED | u64::from(encode::code::BOOL) << 48;
    let set: Vec<i32> = numbers(fields).into_iter().chain([-1]).collect();
    let first_and = |first: i32, rest: i32| [vec![first], vec![rest; specs - 1]].concat();
    let mut jumps = first_and(-1, 0);
    jumps[specs - 1] = -2;
    let sections = [
        [count(1), count(1), packed(b"\0")].concat(),
        count(0),
        [count(fields), column(&vec![0; fields]), packed(&yes.to_le_bytes().repeat(fields))].concat(),
        [count(set.len()), column(&set)].concat(),
        [count(specs), count(specs), column(&numbers(specs)), column(&vec![0; specs]), column(&jumps)].concat(),
        [count(specs), column(&numbers(specs)), column(&vec![0; specs]), column(&first_and(7, 6))].concat(),
    ];
    let mut bytes = vec![0; 88];
    let mut contents = count(sections.len());
    for (name, section) in encode::SECTIONS.iter().zip(sections) {
        let mut field = [0; 16];
        field[..name.len()].copy_from_slice(name.as_bytes());
        contents.extend([&field[..], &count(bytes.len()), &count(section.len())].concat());
        bytes.extend(section);
    }
    let header = [&encode::MAGIC[..], &[0, 8, 0, 0, 0, 0, 0, 0], &count(bytes.len())].concat();
    bytes[..header.len()].copy_from_slice(&header);
    [bytes, contents].concat()
}

#[test]
fn sets_of_fields_may_be_shared_but_not_for_ever() {
    let root = decode::decode(&sharing(3, 5)).unwrap();
    assert_eq!((root.fields.len(), root.children.len(), root.children[1].fields.len()), (5, 2, 5));
    let error = decode::decode(&sharing(2000, 2000)).unwrap_err().to_string();
    assert!(error.contains("unfolds to many times its size"), "{error}");
}

fn field(bases: usize) -> crate::Splats {
    let mut sh = [[0.0; 3]; 16];
    (0..bases).for_each(|b| sh[b] = [0.1 + b as f32, -0.5, 0.25 * b as f32]);
    crate::Splats {
        positions: vec![[0.5, 1.0, -2.0], [4.0, 0.0, 0.125]],
        log_scales: vec![[-1.0, -2.0, -3.0], [0.5, -4.0, -4.0]],
        rotations: vec![[1.0, 0.0, 0.0, 0.0], [0.5, -0.5, 0.5, 0.5]],
        logit_opacities: vec![0.0, 3.0],
        sh: vec![sh, [[0.0; 3]; 16]],
    }
}

#[test]
fn gaussians_stand_beside_the_mesh() {
    for bases in [1, 4, 9, 16] {
        let whole = Asset { splats: Some(field(bases)), ..asset() };
        let read = read(&write(&whole).unwrap()).unwrap();
        let (found, expected) = (read.splats.clone().unwrap(), field(bases));
        assert_eq!(
            (&found.positions, &found.rotations, &found.sh),
            (&expected.positions, &expected.rotations, &expected.sh)
        );
        let near = |a: &[f32], b: &[f32]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-5);
        assert!(near(found.log_scales.as_flattened(), expected.log_scales.as_flattened()));
        assert!(near(&found.logit_opacities, &expected.logit_opacities));
        assert_eq!(Asset { splats: None, ..read }, asset());
    }
}

#[test]
fn fields_with_arrays_that_do_not_match_are_refused() {
    let prim = splats::write(&field(4)).unwrap();
    assert!(splats::read(&prim).is_ok());
    for (i, attribute) in prim.children.iter().enumerate().filter(|(_, c)| c.name != "extent") {
        let mut without = prim.clone();
        without.children.remove(i);
        // Degree 3, which the schema falls back to, has other harmonics.
        assert!(splats::read(&without).is_err(), "{}", attribute.name);
    }
    let mut short = prim;
    let at = short.children.iter().position(|c| c.name == "opacities").unwrap();
    short.children[at] = layer::Spec::attribute("opacities", "float[]", layer::Value::Floats(vec![0.5]));
    assert!(splats::read(&short).unwrap_err().to_string().contains("arrays for 2 splats"));
}
