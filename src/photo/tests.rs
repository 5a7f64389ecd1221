//! Decoding: formats, orientations, limits, damage.

use super::*;
use crate::Kind;
use ::exif::{Field, In, Tag, Value, experimental::Writer};
use image::{DynamicImage, ImageFormat, RgbImage};
use std::io::Cursor;

/// A raw EXIF block with these tags.
pub(super) fn exif_block(tags: &[(Tag, Value)]) -> Vec<u8> {
    let fields: Vec<Field> =
        tags.iter().map(|(tag, value)| Field { tag: *tag, ifd_num: In::PRIMARY, value: value.clone() }).collect();
    let mut writer = Writer::new();
    fields.iter().for_each(|field| writer.push_field(field));
    let mut out = Cursor::new(Vec::new());
    writer.write(&mut out, true).unwrap();
    out.into_inner()
}

/// Red top left, green top right, blue bottom left, grey bottom right.
pub(super) fn quarters(width: u32, height: u32) -> RgbImage {
    RgbImage::from_fn(width, height, |x, y| {
        image::Rgb(match (x < width / 2, y < height / 2) {
            (true, true) => [250, 0, 0],
            (false, true) => [0, 250, 0],
            (true, false) => [0, 0, 250],
            (false, false) => [128, 128, 128],
        })
    })
}

fn encode(picture: &DynamicImage, format: ImageFormat) -> Vec<u8> {
    let mut out = Cursor::new(Vec::new());
    picture.write_to(&mut out, format).unwrap();
    out.into_inner()
}

pub(super) fn jpeg_with(block: &[u8], picture: &RgbImage) -> Vec<u8> {
    let mut out = Vec::new();
    let mut encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut out, 95);
    encoder.encode_image(picture).unwrap();
    let mut segment = vec![0xff, 0xe1];
    segment.extend_from_slice(&(block.len() as u16 + 8).to_be_bytes());
    segment.extend_from_slice(b"Exif\0\0");
    segment.extend_from_slice(block);
    out.splice(2..2, segment);
    out
}

fn failure(name: &str, bytes: &[u8]) -> crate::Error {
    let error = decode(name, bytes, &Limits::default()).expect_err(name);
    assert_eq!((error.kind, error.subject.as_str()), (Kind::Usage, name));
    error
}

#[test]
fn formats_are_known_by_content() {
    let picture = DynamicImage::ImageRgb8(quarters(96, 64));
    for (format, media_type) in [
        (ImageFormat::Jpeg, "image/jpeg"),
        (ImageFormat::Png, "image/png"),
        (ImageFormat::WebP, "image/webp"),
        (ImageFormat::Tiff, "image/tiff"),
    ] {
        let bytes = encode(&picture, format);
        let photo = decode("photo.gif", &bytes, &Limits::default()).unwrap();
        assert_eq!((photo.media_type, photo.byte_len), (media_type, bytes.len() as u64));
        assert_eq!(photo.pixels.dimensions(), (96, 64));
        assert!(photo.pixels.get_pixel(10, 10)[0] > 230 && photo.pixels.get_pixel(80, 10)[1] > 230);
        assert!(photo.cutout.is_none());
    }
}

#[test]
fn other_sample_formats_become_rgb() {
    let rgb = DynamicImage::ImageRgb8(quarters(64, 64));
    for picture in [
        DynamicImage::ImageLuma8(rgb.to_luma8()),
        DynamicImage::ImageLuma16(rgb.to_luma16()),
        DynamicImage::ImageRgb16(rgb.to_rgb16()),
    ] {
        for format in [ImageFormat::Png, ImageFormat::Tiff] {
            let photo = decode("a", &encode(&picture, format), &Limits::default()).unwrap();
            let want = picture.to_rgb8();
            let pairs = photo.pixels.iter().zip(want.iter());
            assert!(pairs.clone().all(|(a, b)| a.abs_diff(*b) <= 1), "{:?} {format:?}", picture.color());
        }
    }
}

#[test]
fn a_palette_png_becomes_rgb() {
    // Two entries, 64 × 64, one bit a pixel, all of the second: written by hand since encoders here write no palettes.
    let mut out = Vec::new();
    {
        let mut encoder = PngParts::new(&mut out);
        encoder.header(64, 64, 1, 3);
        encoder.chunk(b"PLTE", &[1, 2, 3, 200, 100, 50]);
        let mut rows = Vec::new();
        (0..64).for_each(|_| rows.extend_from_slice(&[0, 255, 255, 255, 255, 255, 255, 255, 255]));
        encoder.chunk(b"IDAT", &stored_zlib(&rows));
        encoder.chunk(b"IEND", &[]);
    }
    let photo = decode("palette.png", &out, &Limits::default()).unwrap();
    assert!(photo.pixels.pixels().all(|p| p.0 == [200, 100, 50]));
}

#[test]
fn alpha_is_composited_over_white_and_kept_as_a_hint() {
    let picture = image::RgbaImage::from_fn(80, 80, |x, _| image::Rgba([200, 0, 0, if x < 40 { 255 } else { 0 }]));
    let photo =
        decode("a.png", &encode(&DynamicImage::ImageRgba8(picture), ImageFormat::Png), &Limits::default()).unwrap();
    assert_eq!(photo.pixels.get_pixel(10, 10).0, [200, 0, 0]);
    assert_eq!(photo.pixels.get_pixel(70, 10).0, [255, 255, 255]);
    assert_eq!(photo.cutout.unwrap().get_pixel(10, 10).0, [255]);
    let solid = image::RgbaImage::from_pixel(80, 80, image::Rgba([9, 9, 9, 255]));
    let photo =
        decode("b.png", &encode(&DynamicImage::ImageRgba8(solid), ImageFormat::Png), &Limits::default()).unwrap();
    assert!(photo.cutout.is_none());
}

#[test]
fn all_eight_orientations_come_out_upright() {
    use image::imageops::{flip_horizontal, flip_vertical, rotate90, rotate180, rotate270};
    let upright = quarters(96, 64);
    // What a camera stores so that the tag's operation restores the picture.
    let stored: [RgbImage; 8] = [
        upright.clone(),
        flip_horizontal(&upright),
        rotate180(&upright),
        flip_vertical(&upright),
        flip_horizontal(&rotate90(&upright)),
        rotate270(&upright),
        flip_horizontal(&rotate270(&upright)),
        rotate90(&upright),
    ];
    for (tag, picture) in (1u16..).zip(&stored) {
        let block = exif_block(&[(Tag::Orientation, Value::Short(vec![tag]))]);
        let photo = decode("turned.jpg", &jpeg_with(&block, picture), &Limits::default()).unwrap();
        assert_eq!(photo.pixels.dimensions(), (96, 64), "orientation {tag}");
        for (x, y) in [(20, 16), (76, 16), (20, 48), (76, 48)] {
            let (got, want) = (photo.pixels.get_pixel(x, y), upright.get_pixel(x, y));
            let near = got.0.iter().zip(want.0).all(|(a, b)| a.abs_diff(b) < 12);
            assert!(near, "orientation {tag} at {x},{y}: {got:?} for {want:?}");
        }
    }
}

#[test]
fn damaged_exif_does_not_refuse_a_photo() {
    let mut block = exif_block(&[(Tag::FocalLengthIn35mmFilm, Value::Short(vec![35]))]);
    block[4..8].copy_from_slice(&[0xff; 4]);
    let photo = decode("a.jpg", &jpeg_with(&block, &quarters(64, 64)), &Limits::default()).unwrap();
    assert_eq!(photo.exif, Exif::default());
}

#[test]
fn what_is_no_photo_is_named() {
    assert!(failure("a.jpg", b"").to_string().contains("an empty file"));
    assert!(failure("a.jpg", b"hello").to_string().contains("a text file"));
    assert!(failure("a.jpg", b"%PDF-1.7").to_string().contains("PDF"));
    assert!(failure("a.jpg", b"\0\0\0\x14ftypmif1\0\0\0\0miaf").to_string().contains("HEIF file without"));
    assert!(failure("a.jpg", b"\0\0\0\x14ftypavif\0\0\0\0mif1").to_string().contains("Avif"));
    assert!(failure("a.gif", b"GIF89a\x01\0\x01\0\0\0\0;").to_string().contains("Gif"));
    assert!(failure("a.bin", &[0x80; 40]).to_string().contains("unknown"));
}

/// A photo as phones write it (`tests/data/phone_heic.py`).
fn phone() -> Vec<u8> {
    std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/phone.heic")).unwrap()
}

#[test]
fn a_photo_of_a_phone_is_upright_and_has_its_colours() {
    let photo = decode("IMG_0001.JPG", &phone(), &Limits::default()).unwrap();
    assert_eq!((photo.media_type, photo.pixels.dimensions(), photo.cutout), ("image/heic", (200, 240), None));
    assert_eq!((photo.exif.focal_35mm, photo.exif.taken), (Some(26.0), Some((240, 200))));
    let mut drawn = RgbImage::from_fn(200, 240, |x, y| {
        let (x, y) = (f64::from(x), f64::from(y));
        image::Rgb([90.0 + 0.4 * x, 80.0 + 0.4 * y, 170.0 - 0.3 * x - 0.2 * y].map(|v| v.round() as u8))
    });
    super::colour::to_srgb(&mut drawn, &moxcms::ColorProfile::new_display_p3().encode().unwrap());
    let apart = |a: &RgbImage| a.iter().zip(drawn.iter()).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
    // As coded, in Display P3, libheif has it 3.2 levels off at most; blues of 0 to 40 lie four times as far apart in sRGB.
    assert!(apart(&photo.pixels) <= 8, "{}", apart(&photo.pixels));
    // Cameras that were calibrated on such a photo saw it upright, too.
    let (stored, orientation) = decode_as_stored("IMG_0001.HEIC", &phone(), &Limits::default()).unwrap();
    assert_eq!((stored.pixels, orientation), (photo.pixels, Orientation::Upright));
}

#[test]
fn a_phones_photo_that_is_cut_or_damaged_is_an_error_or_a_picture() {
    let whole = phone();
    for length in (1..whole.len()).step_by(whole.len() / 60).chain([whole.len() - 1]) {
        failure("cut", &whole[..length]);
    }
    let mut state = 7u32;
    let mut random = |below: usize| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as usize % below
    };
    for _ in 0..1000 {
        let mut bytes = whole.clone();
        // Half of them in the boxes.
        let within = if random(2) == 0 { 1200 } else { bytes.len() };
        for _ in 0..=random(4) {
            bytes[random(within)] = random(256) as u8;
        }
        if let Ok(photo) = decode("damaged", &bytes, &Limits::default()) {
            assert!(photo.pixels.width() >= 64);
        }
    }
}

#[test]
fn one_pixel_is_too_small() {
    for format in [ImageFormat::Jpeg, ImageFormat::Png, ImageFormat::WebP, ImageFormat::Tiff] {
        let bytes = encode(&DynamicImage::ImageRgb8(quarters(1, 1)), format);
        let text = failure("dot", &bytes).to_string();
        assert!(text.contains("64 × 64") && text.contains("1 × 1"), "{text}");
    }
}

#[test]
fn every_cut_is_an_error() {
    let picture = DynamicImage::ImageRgb8(quarters(96, 80));
    for format in [ImageFormat::Jpeg, ImageFormat::Png, ImageFormat::WebP, ImageFormat::Tiff] {
        let bytes = encode(&picture, format);
        // PNG may lose its last, empty chunk (12 bytes); the pixels are all there then.
        let longest = if format == ImageFormat::Png { bytes.len() - 17 } else { bytes.len() - 1 };
        let step = (longest / 40).max(1);
        for length in (1..longest).step_by(step).chain([longest]) {
            failure("cut", &bytes[..length]);
        }
    }
}

#[test]
fn bombs_are_refused_by_their_header() {
    let mut png = Vec::new();
    {
        let mut parts = PngParts::new(&mut png);
        parts.header(60_000, 60_000, 8, 2);
        parts.chunk(b"IDAT", &stored_zlib(&[0; 64]));
        parts.chunk(b"IEND", &[]);
    }
    failure("bomb.png", &png);

    // 20 000 × 20 000 passes the side limit, not the pixel limit.
    let mut png = Vec::new();
    {
        let mut parts = PngParts::new(&mut png);
        parts.header(20_000, 20_000, 8, 2);
        parts.chunk(b"IDAT", &stored_zlib(&[0; 64]));
    }
    let text = failure("wide.png", &png).to_string();
    assert!(text.contains("100 megapixels"), "{text}");

    failure("bomb.tif", &tiff_header(60_000, 60_000, 4));
    failure("strips.tif", &tiff_header(9_000, 9_000, 0xffff_fff0));
    let mut jpeg = encode(&DynamicImage::ImageRgb8(quarters(64, 64)), ImageFormat::Jpeg);
    let frame = jpeg.windows(2).position(|w| w == [0xff, 0xc0]).unwrap();
    jpeg[frame + 5..frame + 9].copy_from_slice(&[0xff, 0xff, 0xff, 0xff]);
    failure("bomb.jpg", &jpeg);
}

#[test]
fn a_file_over_the_size_limit_is_refused() {
    let bytes = encode(&DynamicImage::ImageRgb8(quarters(96, 64)), ImageFormat::Png);
    let limits = Limits { file_bytes: 100, ..Limits::default() };
    assert_eq!(decode("big.png", &bytes, &limits).unwrap_err().kind, Kind::Usage);
}

/// Enough of a PNG writer for headers that no encoder would write.
struct PngParts<'a>(&'a mut Vec<u8>);

impl<'a> PngParts<'a> {
    fn new(out: &'a mut Vec<u8>) -> Self {
        out.extend_from_slice(b"\x89PNG\r\n\x1a\n");
        PngParts(out)
    }
    fn header(&mut self, width: u32, height: u32, depth: u8, colour: u8) {
        let mut data = Vec::from(width.to_be_bytes());
        data.extend_from_slice(&height.to_be_bytes());
        data.extend_from_slice(&[depth, colour, 0, 0, 0]);
        self.chunk(b"IHDR", &data);
    }
    fn chunk(&mut self, kind: &[u8; 4], data: &[u8]) {
        self.0.extend_from_slice(&(data.len() as u32).to_be_bytes());
        let from = self.0.len();
        self.0.extend_from_slice(kind);
        self.0.extend_from_slice(data);
        let crc = crc32(&self.0[from..]);
        self.0.extend_from_slice(&crc.to_be_bytes());
    }
}

fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0u32, |crc, &b| {
        (0..8).fold(crc ^ u32::from(b), |c, _| if c & 1 == 1 { (c >> 1) ^ 0xedb8_8320 } else { c >> 1 })
    })
}

/// One stored deflate block (RFC 1950, 1951).
fn stored_zlib(data: &[u8]) -> Vec<u8> {
    let mut out = vec![0x78, 0x01, 1];
    out.extend_from_slice(&(data.len() as u16).to_le_bytes());
    out.extend_from_slice(&(!(data.len() as u16)).to_le_bytes());
    out.extend_from_slice(data);
    let (a, b) = data.iter().fold((1u32, 0u32), |(a, b), &v| {
        let a = (a + u32::from(v)) % 65_521;
        (a, (b + a) % 65_521)
    });
    out.extend_from_slice(&((b << 16) | a).to_be_bytes());
    out
}

/// A little-endian TIFF whose header promises one RGB strip of `strip_bytes`.
fn tiff_header(width: u32, height: u32, strip_bytes: u32) -> Vec<u8> {
    let entries: [(u16, u32); 8] =
        [(256, width), (257, height), (258, 8), (259, 1), (262, 2), (273, 200), (277, 3), (279, strip_bytes)];
    let mut out = b"II*\0\x08\0\0\0".to_vec();
    out.extend_from_slice(&(entries.len() as u16).to_le_bytes());
    for (tag, value) in entries {
        out.extend_from_slice(&tag.to_le_bytes());
        out.extend_from_slice(&4u16.to_le_bytes());
        out.extend_from_slice(&1u32.to_le_bytes());
        out.extend_from_slice(&value.to_le_bytes());
    }
    out.resize(256, 0);
    out
}

#[test]
fn a_profile_in_the_file_says_what_its_colours_are() {
    use image::ImageEncoder;
    use moxcms::ColorProfile;
    let plain = RgbImage::from_pixel(96, 64, image::Rgb([100, 150, 80]));
    let decoded = |profile: ColorProfile| {
        let mut bytes = Vec::new();
        let mut encoder = image::codecs::png::PngEncoder::new(&mut bytes);
        encoder.set_icc_profile(profile.encode().unwrap()).unwrap();
        encoder.write_image(&plain, 96, 64, image::ExtendedColorType::Rgb8).unwrap();
        decode("wide.png", &bytes, &Limits::default()).unwrap().pixels[(5, 7)].0
    };
    assert_eq!(decoded(ColorProfile::new_srgb()), [100, 150, 80]);
    let turned = decoded(ColorProfile::new_adobe_rgb());
    assert!(turned.iter().zip([66u8, 151, 74]).all(|(a, b)| a.abs_diff(b) <= 1), "{turned:?}");
}
