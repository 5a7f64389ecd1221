use super::*;

fn png_of(width: u32) -> Vec<u8> {
    let mut out = std::io::Cursor::new(Vec::new());
    image::RgbImage::from_pixel(width, 2, image::Rgb([1, 2, 3])).write_to(&mut out, image::ImageFormat::Png).unwrap();
    out.into_inner()
}

fn record(opcode: u16, body: &[u8]) -> Vec<u8> {
    let length = (4 + body.len()) as u16;
    [&opcode.to_be_bytes()[..], &length.to_be_bytes(), body].concat()
}

#[test]
fn a_marked_png_is_still_a_png() {
    assert_eq!(crc32(b"123456789"), 0xCBF4_3926, "the check value of CRC-32");
    let plain = png_of(3);
    assert_eq!(mismatch("a.png", &plain, &Marking::CUI), Some("no marking inside".into()));
    for banner in ["UNCLASSIFIED", "CUI//SP-CTI//NOFORN", "TOP SECRET//ORCON/REL TO USA, AUS, GBR"] {
        let marked = mark_png(&plain, &Marking::parse(banner).unwrap());
        assert_eq!(read("p/a.png", &marked), Carried::Banners(vec![banner.into()]));
        let image = image::load_from_memory(&marked).unwrap();
        assert_eq!(image, image::load_from_memory(&plain).unwrap());
    }
    assert_eq!(mark_png(b"no PNG", &Marking::CUI), b"no PNG");
}

#[test]
fn carriers() {
    let line = Marking::SECRET.line();
    let ply = format!("ply\nformat ascii 1.0\ncomment {line}\nend_header\ncomment CLASSIFICATION: CUI\n");
    let version = format!("<Version><Comment>{line}. Made by Orb</Comment></Version>");
    let mut sgi = vec![0; 600];
    sgi[24..24 + line.len()].copy_from_slice(line.as_bytes());
    let flt = |comment: &str| {
        [
            record(1, &[0; 100]),
            record(31, format!("{comment}\0\0").as_bytes()),
            record(10, &[]),
            record(31, b"CLASSIFICATION: CUI\0"),
        ]
        .concat()
    };
    let xml_comment = flt("<orb:Marking xmlns:orb=\"urn:orb:marking\" comment=\"van\">SECRET</orb:Marking>");
    let mut zip = b"PK\x05\x06".to_vec();
    zip.extend([0; 18]);
    zip.extend(line.as_bytes());
    for (name, bytes) in [
        ("s.ply", ply.as_bytes()),
        ("X.cdb/Metadata/Version.xml", version.as_bytes()),
        ("s.xsd.xml", format!("<!-- {line} --><x/>").as_bytes()),
        ("t.rgb", &sgi),
        ("t.zip", &zip),
        ("m.flt", &flt(&line)),
        ("m.flt", &flt("SECRET")),
        ("m.FLT", &xml_comment),
    ] {
        assert_eq!(read(name, bytes), Carried::Banners(vec!["SECRET".into()]), "{name}");
        assert_eq!(mismatch(name, bytes, &Marking::SECRET), None);
        assert_eq!(mismatch(name, bytes, &Marking::CUI), Some("CLASSIFICATION: SECRET".into()));
    }
    assert!(mismatch("Version.xml", b"<Version/>", &Marking::CUI).is_some());
    assert_eq!(mismatch("Other.xml", b"<Other/>", &Marking::CUI), None);
    assert_eq!(read("a.dbf", line.as_bytes()), Carried::NoCarrier);
}

#[test]
fn a_second_lower_banner_does_not_hide() {
    let text = "<a>CLASSIFICATION: SECRET</a><b>CLASSIFICATION: UNCLASSIFIED</b>";
    assert!(mismatch("Version.xml", text.as_bytes(), &Marking::SECRET).is_some());
}

#[test]
fn a_shared_archive_gathers_markings() {
    let mut zip = b"PK\x05\x06".to_vec();
    zip.extend([0; 18]);
    zip.extend(b"CLASSIFICATION: CUI\nUNCLASSIFIED");
    assert!(mismatch("a.zip", &zip, &Marking::CUI).is_some());
    assert_eq!(mismatch_in_store("a.zip", &zip, &Marking::CUI), None);
    assert_eq!(mismatch_in_store("a.zip", &zip, &Marking::UNCLASSIFIED), None);
    assert!(mismatch_in_store("a.zip", &zip, &Marking::SECRET).is_some());
}

/// An EXIF block of one text.
fn block(tag: u16, text: &str) -> Vec<u8> {
    use exif::{Context, Field, In, Tag, Value, experimental::Writer};
    let field = Field {
        tag: Tag(Context::Tiff, tag),
        ifd_num: In::PRIMARY,
        value: Value::Ascii(vec![text.as_bytes().to_vec()]),
    };
    let (mut writer, mut out) = (Writer::new(), std::io::Cursor::new(Vec::new()));
    writer.push_field(&field);
    writer.write(&mut out, true).unwrap();
    out.into_inner()
}

/// A photo is decoded by what stands in it, so its marking is looked for there, and not where its name says.
#[test]
fn a_photo_has_the_carriers_of_its_contents() {
    use image::ImageEncoder as _;
    let of = |name: &str, bytes: &[u8]| marking(name, bytes).unwrap().map(|m| m.banner());
    let segment = |kind: u8, body: &[u8]| [&[0xff, kind][..], &((body.len() + 2) as u16).to_be_bytes(), body].concat();
    let pixels = image::RgbImage::from_pixel(8, 8, image::Rgb([1, 2, 3]));
    let mut plain = Vec::new();
    image::codecs::jpeg::JpegEncoder::new(&mut plain).encode_image(&pixels).unwrap();
    let with = |more: &[u8]| [&plain[..2], more, &plain[2..]].concat();
    let comment = segment(0xfe, b"CLASSIFICATION: SECRET");
    for name in ["x.jpg", "x.jfif", "x.png", "x.ply", "x", ""] {
        assert_eq!(of(name, &with(&comment)).as_deref(), Some("SECRET"), "{name:?}");
        assert_eq!(of(name, &plain), None, "{name:?}");
    }
    // What may stand before a segment, or is passed over there.
    for before in [&[0xff; 3][..], &[0xff, 0x01], &[0xff, 0xd0], b"\0\0x"] {
        let bytes = with(&[before, &segment(0xe1, b"x"), before, &comment].concat());
        assert_eq!(of("x.jpg", &bytes).as_deref(), Some("SECRET"), "{before:x?}");
    }

    let (exif, xmp) = (block(0x9212, "S"), b"<x>CLASSIFICATION: CUI</x>");
    let mut png = Vec::new();
    let mut encoder = image::codecs::png::PngEncoder::new(&mut png);
    encoder.set_exif_metadata(exif.clone()).unwrap();
    encoder.write_image(&pixels, 8, 8, image::ExtendedColorType::Rgb8).unwrap();
    assert_eq!(of("x.jpg", &png).as_deref(), Some("SECRET"));
    let chunk = [&b"iTXtXML:com.adobe.xmp\0\0\0\0\0"[..], xmp].concat();
    let length = (chunk.len() as u32 - 4).to_be_bytes();
    let plain = png_of(8);
    // After the header: signature, length, type, 13 bytes, check sum.
    let png = [&plain[..33], &length, &chunk, &crc32(&chunk).to_be_bytes(), &plain[33..]].concat();
    assert_eq!((of("x.png", &png).as_deref(), of("x.png", &plain)), (Some("CUI"), None));

    let mut webp = Vec::new();
    let mut encoder = image::codecs::webp::WebPEncoder::new_lossless(&mut webp);
    encoder.set_exif_metadata(exif).unwrap();
    encoder.write_image(&pixels, 8, 8, image::ExtendedColorType::Rgb8).unwrap();
    assert_eq!(of("x.webp", &webp).as_deref(), Some("SECRET"));
    assert_eq!(of("x.tiff", &block(0x9212, "C")).as_deref(), Some("CONFIDENTIAL"));
    assert_eq!(of("x", &block(0x9212, "C")).as_deref(), Some("CONFIDENTIAL"));
}

#[test]
fn photos_and_terrains_are_read() {
    let segment = |kind: u8, body: &[u8]| [&[0xff, kind][..], &((body.len() + 2) as u16).to_be_bytes(), body].concat();
    let jpeg = |segments: &[Vec<u8>]| [&[0xff, 0xd8][..], &segments.concat(), &[0xff, 0xda, 0, 2, 1, 2, 3]].concat();
    let exif = |tag, text: &str| segment(0xe1, &[b"Exif\0\0", &block(tag, text)[..]].concat());
    let of = |name: &str, bytes: &[u8]| marking(name, bytes).unwrap().map(|m| m.banner());
    let comment = segment(0xfe, b"CLASSIFICATION: SECRET//NOFORN. A site.");
    assert_eq!(of("a.jpg", &jpeg(&[])), None);
    assert_eq!(of("a.JPG", &jpeg(std::slice::from_ref(&comment))).as_deref(), Some("SECRET//NOFORN"));
    assert_eq!(of("a.jpg", &jpeg(&[exif(0x9212, "S")])).as_deref(), Some("SECRET"));
    assert_eq!(of("a.jpg", &jpeg(&[exif(0x9212, "T"), comment])).as_deref(), Some("TOP SECRET//NOFORN"));
    assert_eq!(of("a.jpg", &jpeg(&[exif(0x010e, "CLASSIFICATION: CUI")])).as_deref(), Some("CUI"));
    assert!(marking("a.jpg", &jpeg(&[exif(0x9212, "R")])).unwrap_err().found.contains("RESTRICTED"));
    assert_eq!(of("a.tif", &block(0x010e, "CLASSIFICATION: CUI//SP-CTI")).as_deref(), Some("CUI//SP-CTI"));
    assert_eq!(of("a.tif", &block(0x9212, "C")).as_deref(), Some("CONFIDENTIAL"));
}

#[test]
fn a_short_carrier_holds_the_beginning_of_a_long_banner() {
    let long = "TOP SECRET//ORCON/REL TO USA, AUS, CAN, DEU, ESP, FRA, GBR, ITA, JPN, NLD, NOR, NZL, POL, PRT, SWE";
    let long = Marking::parse(long).unwrap();
    let mut sgi = vec![0; 600];
    let line = &long.line().into_bytes()[..79];
    sgi[24..103].copy_from_slice(line);
    assert_eq!(mismatch("t.rgb", &sgi, &long), None);
    assert!(mismatch("t.rgb", &sgi, &Marking::TOP_SECRET).is_some());
}

#[test]
fn nothing_but_bytes() {
    for bytes in [&b""[..], b"\x89PNG\r\n\x1a\n\xff\xff\xff\xff", &[0, 1, 0, 2], &[0, 1, 255, 255], &[0xff; 64]] {
        for name in ["a.png", "a.flt", "a.ply", "a.xml", "a.rgb", "a.zip", "a.glb", "a.usdz", "a.spz", "tileset.json"] {
            assert!(matches!(read(name, bytes), Carried::Nothing { .. }), "{name}");
        }
    }
}
