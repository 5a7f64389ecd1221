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
