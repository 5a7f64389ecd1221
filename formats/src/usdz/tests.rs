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
