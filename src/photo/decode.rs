//! Bytes → upright sRGB pixels, within limits that hold before anything large is allocated.

use super::colour::to_srgb;
use super::complete::{jpeg_reaches_its_end, webp_reaches_its_end};
use super::heif::{Heif, is_heif};
use super::metadata::{self, Orientation};
use super::{Exif, Photo};
use crate::{Error, Result};
use image::error::UnsupportedErrorKind;
use image::{DynamicImage, GrayImage, ImageDecoder, ImageFormat, ImageReader, RgbImage};
use sha2::{Digest, Sha256};
use std::io::Cursor;

/// What a photo may cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    pub file_bytes: u64,
    pub pixels: u64,
    /// Of the decoder's output in the file's own sample format.
    pub decoded_bytes: u64,
    /// The shorter side, pixels.
    pub shortest_side: u32,
    /// The longer side, pixels.
    pub longest_side: u32,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            file_bytes: 256 << 20,
            pixels: 100_000_000,
            decoded_bytes: 640 << 20,
            shortest_side: 64,
            longest_side: 32_768,
        }
    }
}

/// The kind of a file, known by its content.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Jpeg,
    Png,
    WebP,
    Tiff,
    Heif,
}

/// What is read, in words.
const FORMATS: &str = "JPEG, HEIC, PNG, WebP or TIFF";

/// Decodes JPEG, HEIC (HEIF coded by HEVC, 4:2:0 or grey), PNG, WebP or TIFF, known by content, not by name.
///
/// EXIF orientation is applied, of HEIC the container's. 16-bit samples are reduced to 8 by rounding, grey and palette become RGB, CMYK JPEG is
/// converted without its ICC profile. Colours are taken as sRGB, and turned to it where the ICC profile is of another RGB. Alpha is
/// composited over white and kept as [`Photo::cutout`] where it cuts something out. Of several frames or pages the first is read.
///
/// # Errors
/// Usage errors that name the file: empty, not one of the formats, cut short or damaged, too small, over a limit.
pub fn decode(name: &str, bytes: &[u8], limits: &Limits) -> Result<Photo> {
    let (photo, orientation) = decode_as_stored(name, bytes, limits)?;
    let pixels = upright(DynamicImage::ImageRgb8(photo.pixels), orientation).into_rgb8();
    let cutout = photo.cutout.map(|alpha| upright(DynamicImage::ImageLuma8(alpha), orientation).into_luma8());
    Ok(Photo { pixels, cutout, ..photo })
}

/// As [`decode`], rows as the file has them, and how they would have to be turned: for cameras that were calibrated on
/// them as they are.
///
/// # Errors
/// As [`decode`].
pub fn decode_as_stored(name: &str, bytes: &[u8], limits: &Limits) -> Result<(Photo, Orientation)> {
    let Opened { mut decoder, format, media_type, exif, orientation } = open(name, bytes, limits)?;
    let damaged = |error: image::ImageError| refuse(name, bytes.len(), limits, &error);
    if (format == Format::Jpeg && !jpeg_reaches_its_end(bytes))
        || (format == Format::WebP && !webp_reaches_its_end(bytes))
    {
        return Err(cut_short(name, bytes.len()));
    }
    let profile = decoder.icc_profile().ok().flatten();
    let (mut pixels, cutout) = flatten(DynamicImage::from_decoder(decoder).map_err(damaged)?);
    if let Some(profile) = profile {
        to_srgb(&mut pixels, &profile);
    }
    let photo = Photo {
        name: name.to_owned(),
        media_type,
        sha256: Sha256::digest(bytes).into(),
        byte_len: bytes.len() as u64,
        pixels,
        cutout,
        exif,
    };
    Ok((photo, orientation))
}

/// What the camera wrote beside the picture, and the kind of file; no pixel is decoded.
///
/// # Errors
/// As [`decode`], but for damage to the pixels.
pub fn metadata(name: &str, bytes: &[u8], limits: &Limits) -> Result<(Exif, &'static str)> {
    open(name, bytes, limits).map(|o| (o.exif, o.media_type))
}

/// A photo whose pixels are still to come.
struct Opened<'a> {
    decoder: Box<dyn ImageDecoder + 'a>,
    format: Format,
    media_type: &'static str,
    exif: Exif,
    orientation: Orientation,
}

fn open<'a>(name: &str, bytes: &'a [u8], limits: &Limits) -> Result<Opened<'a>> {
    let problem = |found: String| Error::usage(name).expected(format!("a {FORMATS} photo")).found(found);
    if bytes.is_empty() {
        return Err(problem("an empty file".into()));
    }
    if bytes.len() as u64 > limits.file_bytes {
        return Err(Error::usage(name)
            .expected(format!("at most {} MiB", limits.file_bytes >> 20))
            .found(format!("a file of {} MiB", bytes.len() >> 20))
            .advice("Save the photo as a JPEG."));
    }
    let (format, media_type) = match image::guess_format(bytes) {
        Ok(ImageFormat::Jpeg) => (Format::Jpeg, "image/jpeg"),
        Ok(ImageFormat::Png) => (Format::Png, "image/png"),
        Ok(ImageFormat::WebP) => (Format::WebP, "image/webp"),
        Ok(ImageFormat::Tiff) => (Format::Tiff, "image/tiff"),
        _ if is_heif(bytes) => (Format::Heif, "image/heic"),
        Ok(other) => return Err(problem(format!("{other:?}")).advice("Convert the file to JPEG or PNG.")),
        Err(_) => return Err(problem(describe(bytes)).advice("Convert the file to JPEG or PNG.")),
    };
    let damaged = |error: image::ImageError| refuse(name, bytes.len(), limits, &error);
    let decoder = |format: ImageFormat| -> image::ImageResult<Box<dyn ImageDecoder + 'a>> {
        let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
        reader.limits(decoder_limits(limits));
        Ok(Box::new(reader.into_decoder()?))
    };
    let mut decoder = match format {
        Format::Jpeg => decoder(ImageFormat::Jpeg),
        Format::Png => decoder(ImageFormat::Png),
        Format::WebP => decoder(ImageFormat::WebP),
        Format::Tiff => decoder(ImageFormat::Tiff),
        Format::Heif => Heif::open(bytes, limits.pixels).map(|heif| Box::new(heif) as Box<dyn ImageDecoder + 'a>),
    }
    .map_err(damaged)?;
    let (width, height) = decoder.dimensions();
    check_size(name, width, height, decoder.total_bytes(), limits)?;
    let block = match format {
        Format::Tiff => Some(bytes.to_vec()), // A TIFF file is an EXIF block.
        _ => decoder.exif_metadata().ok().flatten(),
    };
    let (exif, orientation): (Exif, Orientation) = block.map(metadata::read).unwrap_or_default();
    // Its decoder turns the picture.
    let orientation = if format == Format::Heif { Orientation::Upright } else { orientation };
    let exif = match decoder.xmp_metadata() {
        Ok(Some(packet)) => exif.with_xmp(&packet),
        _ => exif,
    };
    let exif = exif.of_picture(width, height);
    Ok(Opened { decoder, format, media_type, exif, orientation })
}

fn decoder_limits(limits: &Limits) -> image::Limits {
    let mut out = image::Limits::no_limits();
    out.max_image_width = Some(limits.longest_side);
    out.max_image_height = Some(limits.longest_side);
    out.max_alloc = Some(limits.decoded_bytes);
    out
}

fn check_size(name: &str, width: u32, height: u32, decoded_bytes: u64, limits: &Limits) -> Result<()> {
    let found = format!("{width} × {height} pixels");
    if width.min(height) < limits.shortest_side {
        return Err(Error::usage(name)
            .expected(format!("at least {0} × {0} pixels", limits.shortest_side))
            .found(found)
            .advice("Use the photo as the camera made it."));
    }
    if width.max(height) > limits.longest_side
        || u64::from(width) * u64::from(height) > limits.pixels
        || decoded_bytes > limits.decoded_bytes
    {
        return Err(too_large(name, limits).found(found));
    }
    Ok(())
}

fn too_large(name: &str, limits: &Limits) -> Error {
    Error::usage(name)
        .expected(format!(
            "at most {} megapixels, {} pixels a side and {} MiB when decoded",
            limits.pixels as f64 / 1e6,
            limits.longest_side,
            limits.decoded_bytes >> 20
        ))
        .advice("Scale the photo down; 40 megapixels are plenty.")
}

fn cut_short(name: &str, length: usize) -> Error {
    Error::usage(name)
        .expected("a whole photo")
        .found(format!("a file that breaks off after {length} bytes"))
        .advice("Copy the photo again from the camera.")
}

fn refuse(name: &str, length: usize, limits: &Limits, error: &image::ImageError) -> Error {
    match error {
        image::ImageError::Limits(_) => too_large(name, limits).found(error.to_string()),
        image::ImageError::IoError(io) if io.kind() == std::io::ErrorKind::UnexpectedEof => cut_short(name, length),
        image::ImageError::Unsupported(what) => Error::usage(name)
            .expected(format!("a common kind of {FORMATS}"))
            .found(match what.kind() {
                UnsupportedErrorKind::GenericFeature(feature) => feature.clone(),
                _ => error.to_string(),
            })
            .advice("Convert the file to an ordinary JPEG or PNG."),
        _ => Error::usage(name)
            .expected("a readable photo")
            .found(error.to_string())
            .advice("The file is damaged; copy it again from the camera."),
    }
}

/// Names what the user probably has.
fn describe(bytes: &[u8]) -> String {
    let brand = bytes.get(4..12).unwrap_or_default();
    let kind = match brand {
        b"ftypmif1" | b"ftypmsf1" | b"ftyphevc" | b"ftyphevx" => "an HEIF file without a picture coded by HEVC",
        _ if bytes.starts_with(b"%PDF") => "a PDF file",
        _ if bytes.starts_with(b"PK\x03\x04") => "a ZIP file",
        _ if std::str::from_utf8(&bytes[..bytes.len().min(512)]).is_ok() => "a text file",
        _ => "a file of an unknown kind",
    };
    kind.to_owned()
}

/// To 8-bit RGB over white, and the alpha where it tells subject from ground.
fn flatten(decoded: DynamicImage) -> (RgbImage, Option<GrayImage>) {
    if !decoded.color().has_alpha() {
        return (decoded.into_rgb8(), None);
    }
    let rgba = decoded.into_rgba8();
    let mut alpha = GrayImage::new(rgba.width(), rgba.height());
    let mut rgb = RgbImage::new(rgba.width(), rgba.height());
    let mut opaque = 0u64;
    for ((from, to), a) in rgba.pixels().zip(rgb.pixels_mut()).zip(alpha.pixels_mut()) {
        let weight = u32::from(from[3]);
        for c in 0..3 {
            to[c] = ((u32::from(from[c]) * weight + 255 * (255 - weight) + 127) / 255) as u8;
        }
        a[0] = from[3];
        opaque += u64::from(from[3] > 127);
    }
    // A watermark's hole or a rounded corner is no cut-out.
    let share = opaque as f64 / (f64::from(rgba.width()) * f64::from(rgba.height()));
    let cutout = (0.005..0.9).contains(&share).then_some(alpha);
    (rgb, cutout)
}

fn upright(picture: DynamicImage, orientation: Orientation) -> DynamicImage {
    match orientation {
        Orientation::Upright => picture,
        Orientation::FlipHorizontal => picture.fliph(),
        Orientation::Rotate180 => picture.rotate180(),
        Orientation::FlipVertical => picture.flipv(),
        Orientation::Transpose => picture.rotate90().fliph(),
        Orientation::Rotate90 => picture.rotate90(),
        Orientation::Transverse => picture.rotate270().fliph(),
        Orientation::Rotate270 => picture.rotate270(),
    }
}
