//! Broken files and what `check` says of them.

use super::{triangle, two_levels};
use crate::openflight::{Model, check, write};

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
