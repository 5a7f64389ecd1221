//! Layout, round trips, hostile tables.

use super::*;
use proptest::prelude::*;

/// 2×2 RGB: red, green over blue, white.
fn small() -> Image {
    Image { width: 2, height: 2, channels: 3, pixels: vec![255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255] }
}

fn put32(bytes: &mut [u8], at: usize, value: u32) {
    bytes[at..at + 4].copy_from_slice(&value.to_be_bytes());
}

#[test]
fn verbatim_is_planar_from_the_bottom() {
    let bytes = write(&small(), "UNCLASSIFIED", false).unwrap();
    assert_eq!(bytes[..12], [0x01, 0xda, 0, 1, 0, 3, 0, 2, 0, 2, 0, 3]);
    assert_eq!(bytes[12..20], [0, 0, 0, 0, 0, 0, 0, 255]);
    assert_eq!(&bytes[24..37], b"UNCLASSIFIED\0");
    assert!(bytes[37..512].iter().all(|&b| b == 0));
    // Red of blue, white, red, green; then green; then blue.
    assert_eq!(bytes[512..], [0, 255, 255, 0, 0, 255, 0, 255, 255, 255, 0, 0]);
}

#[test]
fn rows_are_coded_as_runs_and_literals() {
    let code = |row: &[u8]| {
        let mut out = Vec::new();
        encode_row(row, &mut out);
        out
    };
    assert_eq!(code(&[7; 5]), [5, 7, 0]);
    assert_eq!(code(&[1, 2, 2, 3]), [0x84, 1, 2, 2, 3, 0]);
    assert_eq!(code(&[1, 2, 2, 2]), [0x81, 1, 3, 2, 0]);
    assert_eq!(code(&[9; 300]), [127, 9, 127, 9, 46, 9, 0]);
    assert_eq!(code(&(0..200).collect::<Vec<u8>>()).len(), 200 + 2 + 1);
}

#[test]
fn runs_shrink_a_plain_image() {
    let image = Image { width: 512, height: 512, channels: 3, pixels: vec![200; 512 * 512 * 3] };
    let bytes = write(&image, "", true).unwrap();
    assert_eq!(bytes.len(), 512 + 512 * 3 * (8 + 11)); // five runs and the end a row
    assert_eq!(read(&bytes).unwrap().0, image);
}

#[test]
fn what_does_not_fit_is_refused() {
    let bad = |change: fn(&mut Image)| {
        let mut image = small();
        change(&mut image);
        write(&image, "", false).unwrap_err().to_string()
    };
    assert!(bad(|i| i.width = 0).contains("sides must be 1 to 65535"));
    assert!(bad(|i| i.height = 65536).contains("sides must be 1 to 65535"));
    assert!(bad(|i| i.channels = 5).contains("1 to 4 channels"));
    assert!(bad(|i| i.pixels.truncate(11)).contains("needs 12 pixel bytes, found 11"));
    assert!(write(&small(), &"x".repeat(80), false).is_err());
    assert!(write(&small(), &"x".repeat(79), false).is_ok());
    assert!(write(&small(), "é", false).is_err());
}

#[test]
fn hostile_headers_and_tables_are_refused() {
    type Change = fn(&mut Vec<u8>);
    // Two by two, three channels: six row offsets at 512, six lengths at 536, rows of 4 or 5 bytes from 560.
    let table: [(Change, &str); 18] = [
        (|b| b.truncate(511), "at byte 511: expected a header of 512 bytes"),
        (|b| b[0] = 2, "at byte 0: expected the magic number 474"),
        (|b| b[2] = 2, "at byte 2: expected storage"),
        (|b| b[3] = 2, "16 bits a channel"),
        (|b| b[3] = 0, "at byte 3: expected 1 or 2 bytes"),
        (|b| b[5] = 4, "at byte 4: expected 1, 2 or 3 dimensions"),
        (|b| b[7] = 0, "at byte 6: expected a width and height"),
        (|b| b[11] = 5, "at byte 10: expected 1 to 4 channels"),
        (|b| b[107] = 1, "colour-mapped"),
        (|b| b.truncate(559), "expected row tables up to byte 560"),
        (|b| put32(b, 512, u32::MAX), "at byte 512: expected row 0 inside"),
        (|b| put32(b, 512, 100), "at byte 512: expected row 0 inside"),
        (|b| put32(b, 536 + 8, u32::MAX), "at byte 520: expected row 2 inside"),
        (|b| put32(b, 536, 0), "expected 2 samples, found the end of the row after 0"),
        (|b| put32(b, 536, 2), "expected 2 more samples, found the end of the row"),
        (|b| b[560] = 0x83, "expected 2 samples, found 3 or more"),
        (|b| b[560] = 0, "expected 2 samples, found the end of the row after 0"),
        (|b| b[6..10].fill(0xff), "expected row tables"),
    ];
    let good = write(&small(), "", true).unwrap();
    assert_eq!(read(&good).unwrap().0, small());
    for (change, says) in table {
        let mut bad = good.clone();
        change(&mut bad);
        let error = read(&bad).unwrap_err().to_string();
        assert!(error.contains(says), "{error:?} should say {says:?}");
    }
    // A table with room for all rows of 65535 samples, and nothing behind it: refused before 4 GiB are made room for.
    let mut wide = write(&Image { width: 1, height: 65535, channels: 1, pixels: vec![0; 65535] }, "", true).unwrap();
    wide[6..8].fill(0xff);
    assert!(read(&wide).unwrap_err().to_string().contains("pixel bytes from a file of"));
    let verbatim = write(&small(), "", false).unwrap();
    assert!(read(&verbatim[..523]).unwrap_err().to_string().contains("expected pixels up to byte 524"));
}

#[test]
fn rows_may_share_bytes_and_lack_their_end() {
    let image = Image { width: 4, height: 3, channels: 1, pixels: vec![6; 12] };
    let mut bytes = write(&image, "", true).unwrap();
    let first = 512 + 3 * 8;
    for row in 0..3 {
        put32(&mut bytes, 512 + row * 4, first as u32);
        put32(&mut bytes, 512 + 12 + row * 4, 2);
    }
    bytes.truncate(first + 2);
    assert_eq!(read(&bytes).unwrap().0, image);
}

fn any_image() -> impl Strategy<Value = Image> {
    (1..300u32, 1..6u32, 1..=4u8).prop_flat_map(|(width, height, channels)| {
        let count = (width * height) as usize * usize::from(channels);
        // Few values make runs, many make literals.
        let pixels = prop_oneof![
            prop::collection::vec(any::<u8>(), count),
            prop::collection::vec(prop_oneof![8 => Just(0u8), 1 => any::<u8>()], count),
        ];
        pixels.prop_map(move |pixels| Image { width, height, channels, pixels })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn what_is_written_reads_back_equal(image in any_image(), name in "[ -~]{0,79}", rle in any::<bool>()) {
        let bytes = write(&image, &name, rle).unwrap();
        prop_assert_eq!(read(&bytes).unwrap(), (image, name));
    }

    #[test]
    fn damaged_files_never_panic(
        image in any_image(),
        rle in any::<bool>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        header_change in (0..560usize, any::<u8>()),
        cut in any::<prop::sample::Index>(),
    ) {
        let mut bytes = write(&image, "n", rle).unwrap();
        for (at, value) in changes {
            let at = at.index(bytes.len());
            bytes[at] = value;
        }
        bytes[header_change.0 % 512] = header_change.1;
        let _ = read(&bytes);
        bytes.truncate(cut.index(bytes.len()));
        let _ = read(&bytes);
    }
}
