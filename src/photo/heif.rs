//! HEIF photos of phones (ISO/IEC 23008-12): the container's items → tiles coded by HEVC → upright RGB, or RGBA where there is an
//! alpha plane.
//!
//! What the file says of turning and cutting is done; an EXIF orientation beside it says the same once more and is not looked at
//! (ISO/IEC 23008-12, section 6.5.10).

use heic_rs::context::Context;
use heic_rs::hevc::{self, Frame};
use heic_rs::meta::iinf::ItemInfo;
use heic_rs::props::ItemProps;
use heic_rs::props::colr::{MatrixCoefficients, Nclx, Range};
use heic_rs::{Error, Image, PixelLayout, color, grid, transform};
use image::error::{
    DecodingError, ImageFormatHint, LimitError, LimitErrorKind, UnsupportedError, UnsupportedErrorKind,
};
use image::{ColorType, ImageDecoder, ImageError, ImageResult};
use moxcms::ColorProfile;
use rayon::prelude::*;

use super::hevc_colour::{self, Said};

/// Whether a file begins as HEIF coded by HEVC does.
pub(super) fn is_heif(bytes: &[u8]) -> bool {
    let brands = bytes.get(..4).and_then(|length| bytes.get(8..u32::from_be_bytes(length.try_into().ok()?) as usize));
    let named = |name: &[u8]| brands.is_some_and(|b| b.chunks_exact(4).any(|brand| brand == name));
    bytes.get(4..8) == Some(b"ftyp") && [b"heic", b"heix"].iter().any(|name| named(*name))
}

/// A file whose pixels are still to come.
pub(super) struct Heif<'a> {
    file: Context<'a>,
    item: u32,
    props: ItemProps<'a>,
    alpha: Option<u32>,
    /// Width and height as it is seen.
    shown: (u32, u32),
    max_pixels: u64,
}

impl<'a> Heif<'a> {
    /// # Errors
    /// Of the container, and for what is not decoded here.
    pub(super) fn open(bytes: &'a [u8], max_pixels: u64) -> ImageResult<Self> {
        let opened = || {
            let file = Context::open(bytes)?;
            // Whatever of a file that breaks off is missing.
            let cut = |item: &ItemInfo| file.item_data(item.id).err().filter(|e| matches!(e, Error::Truncated(_)));
            if let Some(error) = file.meta.items.iter().find_map(cut) {
                return Err(error);
            }
            let item = file.meta.primary;
            let props = file.props(item)?;
            let (width, height) = file.coded_size(item, &props)?;
            let shown = transform::transformed_size(width, height, &props.transforms)?;
            let alpha = file.alpha_item(item)?;
            Ok(Heif { item, alpha, shown, max_pixels, props, file })
        };
        opened().map_err(refused)
    }

    /// The picture that an item is, or is made of.
    fn frame(&self, item: u32, props: &ItemProps) -> heic_rs::Result<Frame> {
        match self.file.grid(item)? {
            None => coded(&self.file, item, props),
            Some((layout, tiles)) => {
                let tile = |id: &u32| coded(&self.file, *id, &self.file.props(*id)?);
                let tiles = tiles.par_iter().map(tile).collect::<heic_rs::Result<Vec<Frame>>>()?;
                grid::compose(&layout, &tiles, self.max_pixels)
            }
        }
    }

    fn decoded(&self) -> heic_rs::Result<Image> {
        let frame = self.frame(self.item, &self.props)?;
        let alpha = match self.alpha {
            Some(item) => Some(self.frame(item, &self.file.props(item)?)?),
            None => None,
        };
        let nclx = self.nclx()?;
        let image = color::convert(&frame, alpha.as_ref(), nclx, self.layout(), self.max_pixels, None)?;
        drop((frame, alpha));
        transform::apply_all(image, &self.props.transforms)
    }

    fn layout(&self) -> PixelLayout {
        if self.alpha.is_some() { PixelLayout::Rgba8 } else { PixelLayout::Rgb8 }
    }

    /// Of the coded picture, or of the first of those that the picture is made of.
    fn coded_props(&self) -> heic_rs::Result<ItemProps<'a>> {
        match self.file.grid(self.item)? {
            Some((_, tiles)) => tiles.first().map_or_else(|| Ok(self.props.clone()), |tile| self.file.props(*tile)),
            None => Ok(self.props.clone()),
        }
    }

    /// How samples are to be taken for colours: by the container, else by the stream (ISO/IEC 23008-12, section 6.5.5), and by the
    /// rules for files that do not say it (ISO/IEC 23000-22, section 7.3.6.4).
    fn nclx(&self) -> heic_rs::Result<Nclx> {
        let coded = self.coded_props()?;
        let by_stream = || {
            let said = coded.hvcc.as_ref().map(|c| hevc_colour::said(&c.parameter_sets())).unwrap_or_default();
            let Said { full_range, primaries, transfer, matrix } = said;
            let range = if full_range { Range::Full } else { Range::Limited };
            Nclx { primaries, transfer, matrix: MatrixCoefficients::from_code(matrix), matrix_code: matrix, range }
        };
        let said = self.props.nclx.or(coded.nclx).unwrap_or_else(by_stream);
        Ok(match said.matrix {
            MatrixCoefficients::Unspecified => Nclx { matrix: MatrixCoefficients::Bt601, ..said },
            _ => said,
        })
    }
}

/// One coded picture.
fn coded(file: &Context, item: u32, props: &ItemProps) -> heic_rs::Result<Frame> {
    let config = props.hvcc.as_ref().ok_or(Error::Unsupported("a picture that is not coded by HEVC"))?;
    // heic-rs 0.1.4 loses its place in what x265 writes of these, and would not always notice.
    if config.chroma_format > 1 {
        return Err(Error::Unsupported("colours of 4:2:2 or 4:4:4; phones write 4:2:0"));
    }
    let data = file.item_data(item)?;
    let frame = hevc::decode_still(&config.parameter_sets(), &config.split_nals(&data)?)?;
    frame.validate()?;
    Ok(frame)
}

/// What the rest of the program understands.
fn refused(error: Error) -> ImageError {
    let hint = ImageFormatHint::Name("HEIF".into());
    match error {
        Error::Truncated(_) => ImageError::IoError(std::io::ErrorKind::UnexpectedEof.into()),
        Error::PixelLimit { .. } => ImageError::Limits(LimitError::from_kind(LimitErrorKind::DimensionError)),
        Error::Unsupported(what) => {
            let kind = UnsupportedErrorKind::GenericFeature(what.into());
            ImageError::Unsupported(UnsupportedError::from_format_and_kind(hint, kind))
        }
        other => ImageError::Decoding(DecodingError::new(hint, other)),
    }
}

impl ImageDecoder for Heif<'_> {
    fn dimensions(&self) -> (u32, u32) {
        self.shown
    }

    fn color_type(&self) -> ColorType {
        if self.layout().has_alpha() { ColorType::Rgba8 } else { ColorType::Rgb8 }
    }

    fn icc_profile(&mut self) -> ImageResult<Option<Vec<u8>>> {
        // ISO/IEC 23091-2, section 8.1: 12 is Display P3, which phones without a profile in their files write.
        let of_primaries = || match self.nclx().ok()?.primaries {
            12 => ColorProfile::new_display_p3().encode().ok(),
            _ => None,
        };
        let profile = self.props.icc.or_else(|| self.coded_props().ok()?.icc);
        Ok(profile.map(<[u8]>::to_vec).or_else(of_primaries))
    }

    fn exif_metadata(&mut self) -> ImageResult<Option<Vec<u8>>> {
        Ok(self.file.exif(self.item).ok().flatten().map(<[u8]>::to_vec))
    }

    fn xmp_metadata(&mut self) -> ImageResult<Option<Vec<u8>>> {
        let packet = self.file.xmp_item(self.item).map(|item| self.file.item_data(item));
        Ok(packet.and_then(Result::ok).map(|data| data.into_owned()))
    }

    fn read_image(self, out: &mut [u8]) -> ImageResult<()> {
        let image = self.decoded().map_err(refused)?;
        if image.data.len() != out.len() {
            return Err(refused(Error::Malformed("a picture of another size than the file says")));
        }
        out.copy_from_slice(&image.data);
        Ok(())
    }

    fn read_image_boxed(self: Box<Self>, out: &mut [u8]) -> ImageResult<()> {
        (*self).read_image(out)
    }
}
