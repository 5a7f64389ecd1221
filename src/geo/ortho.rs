//! Colours of the ground from a georeferenced picture: a GeoTIFF of three bands (OGC 19-008r4).

use std::io::Cursor;

use tiff::decoder::{Decoder, DecodingResult};

use super::dem::keys::Keys;
use crate::{Error, Result};

/// An orthophoto in memory.
pub struct Ortho {
    keys: Keys,
    size: (u32, u32),
    bands: usize,
    pixels: Vec<u8>,
}

impl Ortho {
    /// Reads a picture of 8-bit red, green and blue; a fourth band is left out.
    ///
    /// # Errors
    /// Usage errors that name the file: no TIFF, no georeference, other samples.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self> {
        let damaged = |e: tiff::TiffError| Error::usage(name).expected("a GeoTIFF of colours").found(e.to_string());
        let mut decoder = Decoder::new(Cursor::new(bytes)).map_err(damaged)?;
        let size = decoder.dimensions().map_err(damaged)?;
        let keys =
            Keys::read(&mut decoder).map_err(|(expected, found)| Error::usage(name).expected(expected).found(found))?;
        let count = size.0 as usize * size.1 as usize;
        match decoder.read_image().map_err(damaged)? {
            DecodingResult::U8(pixels) if count > 0 && [3, 4].map(|b| b * count).contains(&pixels.len()) => {
                Ok(Ortho { keys, size, bands: pixels.len() / count, pixels })
            }
            _ => Err(Error::usage(name)
                .expected("red, green and blue of 8 bits, pixel by pixel")
                .found("other samples")
                .advice("gdal_translate -ot Byte -co INTERLEAVE=PIXEL writes such a file.")),
        }
    }

    /// The colour of the pixel that holds a point; `None` beyond the picture.
    pub fn color(&self, latitude: f64, longitude: f64) -> Option<[u8; 3]> {
        let (x, y) = self.keys.pixel(latitude, longitude)?;
        let (x, y) = (x.round(), y.round());
        let inside = (0.0..f64::from(self.size.0)).contains(&x) && (0.0..f64::from(self.size.1)).contains(&y);
        if !inside {
            return None;
        }
        let at = (y as usize * self.size.0 as usize + x as usize) * self.bands;
        self.pixels.get(at..at + 3)?.try_into().ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use orb_formats::{Image, geotiff, jp2};
    use tiff::encoder::{TiffEncoder, colortype::RGB8};
    use tiff::tags::Tag;

    #[test]
    fn pixels_are_found_by_their_place() {
        let mut out = Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut out).unwrap();
        let image = {
            let mut image = encoder.new_image::<RGB8>(4, 2).unwrap();
            let d = image.encoder();
            d.write_tag(Tag::GeoKeyDirectoryTag, &[1u16, 1, 0, 3, 1024, 0, 1, 2, 1025, 0, 1, 1, 2048, 0, 1, 4326][..])
                .unwrap();
            d.write_tag(Tag::ModelPixelScaleTag, &[0.5, 0.25, 0.0][..]).unwrap();
            d.write_tag(Tag::ModelTiepointTag, &[0.0, 0.0, 0.0, 10.0, 50.0, 0.0][..]).unwrap();
            image
        };
        let pixels: Vec<u8> = (0..24).collect();
        image.write_data(&pixels).unwrap();
        let ortho = Ortho::read("a.tif", &out.into_inner()).unwrap();
        assert_eq!(ortho.color(49.99, 10.01), Some([0, 1, 2]));
        assert_eq!(ortho.color(49.6, 11.9), Some([21, 22, 23]));
        assert_eq!(ortho.color(49.6, 10.6), Some([15, 16, 17]));
        assert_eq!((ortho.color(50.1, 10.1), ortho.color(49.9, 12.1)), (None, None));
        // What has no colours is refused.
        let grid = geotiff::Grid { west: 10.0, north: 50.0, step_x: 1.0, step_y: 1.0, posts: false };
        let heights = geotiff::write(1, 1, &[1.0], &grid, "").unwrap();
        assert!(Ortho::read("b.tif", &heights).is_err());
        let jp2 = jp2::write(&Image { width: 1, height: 1, channels: 1, pixels: vec![1] }, None, "").unwrap();
        assert!(Ortho::read("c.tif", &jp2).is_err());
    }
}
