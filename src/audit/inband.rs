//! The marking inside files: where each format carries it, and how to read it back.
//!
//! | Format | Carrier |
//! | --- | --- |
//! | PLY | a header line `comment CLASSIFICATION: …` |
//! | PNG | an iTXt chunk with the keyword `Classification` (PNG third edition §11.3.3.4) |
//! | OpenFlight | a Comment record (opcode 31) of the Header, before the first push |
//! | XML | `CLASSIFICATION: …` in any text, such as the `Comment` of a CDB's Version.xml |
//! | SGI image | the image name of its header |
//! | OpenFlight texture attributes | the comment |
//! | ZIP | the archive comment |
//! | GLB | `CLASSIFICATION: …` in the JSON chunk: copyright, extras and the XMP packet (`KHR_xmp_json_ld`) |
//! | USDZ | the root layer's `customLayerData["orb:marking"]` |
//! | 3D Tiles | `CLASSIFICATION: …` in tileset.json's `asset.extras` |
//! | SPZ | the comment of the gzip header, or an extension record (version 4) |
//! | GeoTIFF | the image's description |
//! | JPEG 2000 | `CLASSIFICATION: …` in an XML box |
//! | HTML | the banners at its top and bottom, as reports have them |
//! | `orb-marking.json` | its `banner` |
//! | JPEG, TIFF, PNG, WebP as photos (read only) | `CLASSIFICATION: …` in comments, EXIF and XMP; SecurityClassification (TIFF/EP, 0x9212) |
//!
//! What Orb writes has the carrier of its name; what it reads as a photo has that of its contents, as the decoder goes by them.
//!
//! Metadata is easily stripped: the digest in the record is the proof, the marking inside is for the reader.

use std::io::Cursor;

use image::{ImageDecoder as _, ImageFormat, ImageReader};

use super::canonical::Json;
use super::marking::{LINE_PREFIX, MAX_BANNER, Marking};
use crate::Result;

/// The keyword of the PNG chunk.
const PNG_KEYWORD: &str = "Classification";
const PNG_SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// What a file says about its marking.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Carried {
    /// Every banner found, as text, at least one.
    Banners(Vec<String>),
    /// The format has a carrier, and it is empty.
    Nothing {
        /// Orb always fills this carrier.
        required: bool,
    },
    /// No carrier in this format, or none that is read here.
    NoCarrier,
}

/// Reads the marking of a file by its name's ending.
pub fn read(name: &str, bytes: &[u8]) -> Carried {
    let file = name.rsplit('/').next().unwrap_or(name);
    let ending = file.rsplit_once('.').map_or("", |(_, e)| e).to_ascii_lowercase();
    let (found, required) = match ending.as_str() {
        "ply" => (ply(bytes), true),
        "png" => (png(bytes), true),
        "flt" => (openflight(bytes), true),
        "xml" => (lines_in(bytes), file == "Version.xml"),
        "jpg" | "jpeg" => (jpeg(bytes), false),
        "tif" | "tiff" => (tiff(bytes), false),
        "rgb" | "sgi" => (words_in(bytes.get(24..104).unwrap_or_default()), false),
        "attr" => (lines_in(bytes.get(1024..1536).unwrap_or_default()), false),
        "zip" => (words_in(zip_comment(bytes)), false),
        "glb" => (lines_in(glb_json(bytes)), true),
        "usdz" => (lines_in(orb_formats::usdz::marking(bytes).unwrap_or_default().as_bytes()), true),
        "spz" => (lines_in(orb_formats::spz::comment(bytes).as_bytes()), true),
        "jp2" => (jp2(bytes), false),
        "html" => (html(bytes), false),
        "json" if file == "tileset.json" => (lines_in(bytes), true),
        "json" if file == super::publication::MARKING_SIDECAR => (sidecar(bytes), true),
        _ => return Carried::NoCarrier,
    };
    if found.is_empty() { Carried::Nothing { required } } else { Carried::Banners(found) }
}

/// What a file is marked: the join of every banner in it, none where there is none. Photos are known by their contents, other
/// files by their name's ending.
///
/// # Errors
/// As [`Marking::parse`].
pub fn marking(name: &str, bytes: &[u8]) -> Result<Option<Marking>> {
    let banners = photo(bytes).unwrap_or_else(|| match read(name, bytes) {
        Carried::Banners(banners) => banners,
        Carried::Nothing { .. } | Carried::NoCarrier => Vec::new(),
    });
    let all = banners.iter().map(|b| Marking::read(b)).collect::<Result<Vec<_>>>()?;
    Ok((!all.is_empty()).then(|| Marking::join_all(&all)))
}

/// True for names whose files are worth reading for a marking.
pub fn has_carrier(name: &str) -> bool {
    read(name, &[]) != Carried::NoCarrier
}

/// Compares a file with the marking that it must carry. `Some` says what is there instead.
pub fn mismatch(name: &str, bytes: &[u8], marking: &Marking) -> Option<String> {
    match read(name, bytes) {
        Carried::Banners(banners) => {
            let banner = carried_as(name, marking);
            let wrong = banners.iter().find(|b| **b != banner)?;
            Some(format!("{LINE_PREFIX}{wrong}"))
        }
        Carried::Nothing { required: true } => Some("no marking inside".into()),
        Carried::Nothing { required: false } | Carried::NoCarrier => None,
    }
}

/// The same for a file that others share, such as an archive of a store, which gathers the markings of all that was
/// ever put into it: this one must be among them.
pub fn mismatch_in_store(name: &str, bytes: &[u8], marking: &Marking) -> Option<String> {
    match read(name, bytes) {
        Carried::Banners(banners) if !banners.contains(&carried_as(name, marking)) => {
            Some(format!("{LINE_PREFIX}{}", banners.join(", ")))
        }
        _ => None,
    }
}

/// The banner as the carrier holds it: the name of an SGI image ends after 79 characters.
fn carried_as(name: &str, marking: &Marking) -> String {
    let mut banner = marking.banner();
    let ending = name.rsplit('.').next().unwrap_or_default();
    if ending.eq_ignore_ascii_case("rgb") || ending.eq_ignore_ascii_case("sgi") {
        banner.truncate(79 - LINE_PREFIX.len());
        banner.truncate(banner.trim_end_matches(TRAILING).len());
    }
    banner
}

fn sidecar(bytes: &[u8]) -> Vec<String> {
    match super::canonical::parse(bytes) {
        Ok(Json::Map(map)) => match map.get("banner") {
            Some(Json::Text(banner)) => vec![banner.clone()],
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

/// What stands between the tags of a banner. Other words cannot look like one: in them `<` is escaped.
fn html(bytes: &[u8]) -> Vec<String> {
    let text = String::from_utf8_lossy(bytes);
    let banners =
        text.split("<div class=\"banner ").skip(1).filter_map(|rest| rest.split_once('>')?.1.split_once("</div>"));
    banners.map(|(banner, _)| banner.to_owned()).collect()
}

/// The XML boxes before the picture.
fn jp2(bytes: &[u8]) -> Vec<String> {
    let texts = orb_formats::jp2::header(bytes).map(|h| h.texts).unwrap_or_default();
    texts.iter().flat_map(|t| lines_in(t.as_bytes())).collect()
}

/// Comment lines of a PLY header.
fn ply(bytes: &[u8]) -> Vec<String> {
    bytes
        .split(|b| *b == b'\n')
        .take_while(|line| line.trim_ascii() != b"end_header")
        .take(10_000)
        .filter_map(|line| line.trim_ascii().strip_prefix(b"comment "))
        .filter_map(|text| text.strip_prefix(LINE_PREFIX.as_bytes()))
        .map(|text| String::from_utf8_lossy(text).trim().to_owned())
        .collect()
}

/// iTXt chunks: keyword, NUL, compression flag and method, language, NUL, translated keyword, NUL, UTF-8 text.
fn png(bytes: &[u8]) -> Vec<String> {
    let mut found = Vec::new();
    for (kind, data) in png_chunks(bytes) {
        if kind == b"iTXt"
            && let Some(text) = data.strip_prefix(PNG_KEYWORD.as_bytes()).and_then(|d| d.strip_prefix(&[0, 0, 0]))
        {
            let text = text.splitn(3, |b| *b == 0).nth(2).unwrap_or_default();
            found.push(String::from_utf8_lossy(text).into_owned());
        }
    }
    found
}

/// Type and data of each chunk: length, type, data, check sum.
fn png_chunks(bytes: &[u8]) -> Vec<(&[u8], &[u8])> {
    let mut chunks = Vec::new();
    let mut rest = bytes.strip_prefix(PNG_SIGNATURE).unwrap_or_default();
    while let Some((head, tail)) = rest.split_at_checked(8) {
        let length = u32::from_be_bytes([head[0], head[1], head[2], head[3]]) as usize;
        let Some(data) = tail.get(..length) else { break };
        chunks.push((&head[4..8], data));
        rest = tail.get(length + 4..).unwrap_or_default();
    }
    chunks
}

/// Every banner in a photo, whatever its file is called; `None` for what is none.
fn photo(bytes: &[u8]) -> Option<Vec<String>> {
    let format = image::guess_format(bytes).ok()?;
    let mut found = match format {
        ImageFormat::Jpeg => jpeg(bytes),
        ImageFormat::Png => png(bytes),
        ImageFormat::Tiff => tiff(bytes),
        ImageFormat::WebP => Vec::new(),
        _ => return None,
    };
    if format == ImageFormat::Png {
        // Also behind the pixels, where the decoder does not look.
        found.extend(png_chunks(bytes).into_iter().flat_map(|(kind, data)| match kind {
            b"tEXt" | b"iTXt" => lines_in(data),
            b"eXIf" => exif_block(data),
            _ => Vec::new(),
        }));
    }
    // The chunks of WebP, and XMP that is packed in PNG; the others were read whole.
    if matches!(format, ImageFormat::Png | ImageFormat::WebP)
        && let Ok(mut decoder) = ImageReader::with_format(Cursor::new(bytes), format).into_decoder()
    {
        found.extend(decoder.exif_metadata().ok().flatten().iter().flat_map(|block| exif_block(block)));
        found.extend(decoder.xmp_metadata().ok().flatten().iter().flat_map(|packet| lines_in(packet)));
    }
    Some(found)
}

/// Texts and SecurityClassification of an EXIF block, with or without the words that JPEG has before it.
fn exif_block(block: &[u8]) -> Vec<String> {
    let tags = block.strip_prefix(b"Exif\0\0").unwrap_or(block).to_vec();
    let mut found = lines_in(block);
    found.extend(security_classification(exif::Reader::new().read_raw(tags).ok()));
    found
}

/// Big-endian records (u16 opcode, u16 length): the comments between the header (1) and the first push (10).
fn openflight(bytes: &[u8]) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = bytes;
    let mut first = true;
    while let [a, b, c, d, ..] = *rest {
        let (opcode, length) = (u16::from_be_bytes([a, b]), usize::from(u16::from_be_bytes([c, d])));
        if opcode == 10 || (first && opcode != 1) || length < 4 {
            break;
        }
        let Some(record) = rest.get(..length) else { break };
        if opcode == 31 {
            found.extend(words_in(&record[4..]));
        }
        first = false;
        rest = &rest[length..];
    }
    found
}

/// The first chunk of a GLB container: length, `JSON`, text (glTF 2.0 §4.4).
fn glb_json(bytes: &[u8]) -> &[u8] {
    match bytes {
        [b'g', b'l', b'T', b'F', _, _, _, _, _, _, _, _, a, b, c, d, b'J', b'S', b'O', b'N', rest @ ..] => {
            let length = u32::from_le_bytes([*a, *b, *c, *d]) as usize;
            &rest[..length.min(rest.len())]
        }
        _ => &[],
    }
}

/// The end-of-central-directory record's comment (ZIP application note 6.3, §4.3.16).
fn zip_comment(bytes: &[u8]) -> &[u8] {
    let window = &bytes[bytes.len().saturating_sub(22 + 0xffff)..];
    let end = window.windows(22).rposition(|w| w.starts_with(b"PK\x05\x06"));
    end.map_or(&[], |at| &window[at + 22..])
}

/// Markings in a short field: whole lines or element texts that are a banner, and every `CLASSIFICATION: …`.
fn words_in(bytes: &[u8]) -> Vec<String> {
    let text = bytes.split(|b| *b == 0).next().unwrap_or_default();
    let plain = text.split(|b| b"\n\r<>".contains(b)).filter_map(|word| {
        let word = std::str::from_utf8(word).ok()?.trim();
        Marking::read(word).is_ok().then(|| word.to_owned())
    });
    plain.chain(lines_in(text)).collect()
}

/// What follows every `CLASSIFICATION: `, as far as a banner's own characters go.
fn lines_in(bytes: &[u8]) -> Vec<String> {
    let prefix = LINE_PREFIX.as_bytes();
    let mut found = Vec::new();
    let mut rest = bytes;
    while let Some(at) = rest.windows(prefix.len()).position(|w| w == prefix) {
        rest = &rest[at + prefix.len()..];
        let in_banner = |b: &u8| b.is_ascii_uppercase() || b.is_ascii_digit() || b" /,-".contains(b);
        let banner: Vec<u8> = rest.iter().copied().take(MAX_BANNER).take_while(in_banner).collect();
        found.push(String::from_utf8_lossy(&banner).trim_end_matches(TRAILING).to_owned());
    }
    found
}

/// Ends of words and comments around a banner, never its own.
const TRAILING: [char; 3] = [' ', ',', '-'];

/// Segments up to the picture's data: comments and applications' (ITU-T T.81, annex B).
fn jpeg(bytes: &[u8]) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = bytes.strip_prefix(&[0xff, 0xd8]).unwrap_or_default();
    // Any number of 0xFF may stand before a marker (B.1.1.2), and decoders pass over other bytes there too.
    while let Some(at) = rest.windows(2).position(|w| w[0] == 0xff && !matches!(w[1], 0x00 | 0xff)) {
        let kind = rest[at + 1];
        rest = &rest[at + 2..];
        match kind {
            // Start of scan, after which there are pixels, or the end.
            0xda | 0xd9 => break,
            // These stand alone (B.1.1.3).
            0x01 | 0xd0..=0xd8 => continue,
            _ => {}
        }
        let [a, b, ..] = *rest else { break };
        let length = usize::from(u16::from_be_bytes([a, b])).max(2);
        let Some(body) = rest.get(2..length) else { break };
        match kind {
            0xe0..=0xef | 0xfe if body.starts_with(b"Exif\0\0") => found.extend(exif_block(body)),
            0xe0..=0xef | 0xfe => found.extend(lines_in(body)),
            _ => {}
        }
        rest = &rest[length..];
    }
    found
}

/// ImageDescription, XMP, GDAL's metadata and SecurityClassification.
fn tiff(bytes: &[u8]) -> Vec<String> {
    let tags = exif::Reader::new().read_from_container(&mut std::io::Cursor::new(bytes)).ok();
    let texts = [0x010e, 0x02bc, 0xa480].map(|number| exif::Tag(exif::Context::Tiff, number));
    let words = |field: &exif::Field| match &field.value {
        exif::Value::Ascii(lines) => lines.concat(),
        exif::Value::Byte(bytes) | exif::Value::Undefined(bytes, _) => bytes.clone(),
        _ => Vec::new(),
    };
    let fields = tags.iter().flat_map(|t| t.fields()).filter(|f| texts.contains(&f.tag));
    let mut found: Vec<String> = fields.flat_map(|f| lines_in(&words(f))).collect();
    found.extend(security_classification(tags));
    found
}

/// TIFF/EP's one letter as the banner that it stands for; `R` has none that is supported.
fn security_classification(tags: Option<exif::Exif>) -> Option<String> {
    let number = 0x9212;
    let tags = tags?;
    let field = tags.fields().find(|f| f.tag.number() == number)?;
    let exif::Value::Ascii(lines) = &field.value else { return None };
    let letter = lines.first()?.first()?;
    Some(match letter.to_ascii_uppercase() {
        b'U' => "UNCLASSIFIED".into(),
        b'C' => "CONFIDENTIAL".into(),
        b'S' => "SECRET".into(),
        b'T' => "TOP SECRET".into(),
        b'R' => "RESTRICTED".into(),
        other => char::from(other).to_string(),
    })
}

/// Puts the marking into a PNG, right after its header chunk. Bytes that are no PNG come back as they are.
pub fn mark_png(png: &[u8], marking: &Marking) -> Vec<u8> {
    // Signature, then IHDR: length 13, type, data, check sum.
    let head = PNG_SIGNATURE.len() + 8 + 13 + 4;
    if !png.starts_with(PNG_SIGNATURE) || png.len() < head {
        return png.to_vec();
    }
    let mut chunk = b"iTXt".to_vec();
    chunk.extend_from_slice(PNG_KEYWORD.as_bytes());
    chunk.extend_from_slice(&[0, 0, 0, 0, 0]); // end of keyword, not compressed, method 0, no language, no translation
    chunk.extend_from_slice(marking.banner().as_bytes());
    let mut out = Vec::with_capacity(png.len() + chunk.len() + 8);
    out.extend_from_slice(&png[..head]);
    out.extend_from_slice(&((chunk.len() - 4) as u32).to_be_bytes());
    out.extend_from_slice(&chunk);
    out.extend_from_slice(&crc32(&chunk).to_be_bytes());
    out.extend_from_slice(&png[head..]);
    out
}

/// The check sum of PNG chunks: CRC-32, polynomial 0xEDB88320 reflected (PNG third edition, annex D).
fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0u32, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |c, _| if c & 1 == 1 { 0xEDB8_8320 ^ (c >> 1) } else { c >> 1 })
    })
}

#[cfg(test)]
mod tests;
