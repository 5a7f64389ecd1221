//! Terrain from a GeoTIFF (OGC 19-008r4): heights at points, read chunk by chunk.

pub(super) mod keys;

use std::collections::HashMap;
use std::io::{Read, Seek};

use tiff::decoder::{Decoder, DecodingResult};
use tiff::tags::Tag;

use super::datum::{AltDatum, Height, to_ellipsoid};
use super::{Enu, Geodetic};
use crate::{Error, Result};
use keys::Keys;

/// How the ground under a footprint becomes one height.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    Mean,
    /// The lowest point: nothing floats.
    Min,
    /// The mean, and the model's base follows the ground.
    Conform,
}

impl Fit {
    pub fn label(self) -> &'static str {
        match self {
            Fit::Mean => "mean",
            Fit::Min => "min",
            Fit::Conform => "conform",
        }
    }
}

/// An open terrain.
pub struct Dem<R: Read + Seek> {
    name: String,
    decoder: Decoder<R>,
    keys: Keys,
    size: (u32, u32),
    chunk: (u32, u32),
    no_data: Option<f64>,
    chunks: HashMap<u32, Vec<f64>>,
    /// What its heights are above.
    pub datum: AltDatum,
}

/// Absolute error of a terrain model where its maker says nothing: SRTM, Copernicus and national ones lie below it.
const SIGMA: f64 = 3.0;
/// Chunks kept in memory.
const CHUNKS: usize = 16;

impl<R: Read + Seek> Dem<R> {
    /// Reads the header. `datum` overrides what the file says its heights are above (nothing said: the sea).
    ///
    /// # Errors
    /// Usage errors that name the file: no TIFF, no georeference, a coordinate system that is not WGS84's (or one that
    /// lies within metres of it), more than one band.
    pub fn open(name: &str, reader: R, datum: Option<AltDatum>) -> Result<Self> {
        let damaged = |e: tiff::TiffError| Error::usage(name).expected("a GeoTIFF of heights").found(e.to_string());
        let mut decoder = Decoder::new(reader).map_err(damaged)?;
        let size = decoder.dimensions().map_err(damaged)?;
        let bands = decoder.find_tag_unsigned::<u32>(Tag::SamplesPerPixel).map_err(damaged)?.unwrap_or(1);
        if bands != 1 {
            return Err(Error::usage(name).expected("one band of heights").found(format!("{bands} bands")));
        }
        let keys =
            Keys::read(&mut decoder).map_err(|(expected, found)| Error::usage(name).expected(expected).found(found))?;
        let no_data =
            decoder.get_tag_ascii_string(Tag::GdalNodata).ok().and_then(|t| t.trim_matches(['\0', ' ']).parse().ok());
        let datum = datum.unwrap_or(keys.datum);
        let chunk = decoder.chunk_dimensions();
        Ok(Dem { name: name.to_owned(), decoder, keys, size, chunk, no_data, chunks: HashMap::new(), datum })
    }

    /// Height of the ground above the ellipsoid, bilinear between the four posts around the point.
    ///
    /// # Errors
    /// A usage error for a point outside the terrain, or one where it has no data.
    pub fn ground(&mut self, latitude: f64, longitude: f64) -> Result<Height> {
        let outside = |name: &str| {
            Error::usage(name)
                .expected(format!("terrain at {latitude:.6}, {longitude:.6}"))
                .found("a file that does not cover the point")
                .advice("Give a terrain that covers the whole footprint, or a height with --origin.")
        };
        let (x, y) = self.keys.pixel(latitude, longitude).ok_or_else(|| outside(&self.name))?;
        let (w, h) = (f64::from(self.size.0), f64::from(self.size.1));
        // The outermost half pixel has no second post: the nearest one counts.
        if !(-0.5..=w - 0.5).contains(&x) || !(-0.5..=h - 0.5).contains(&y) {
            return Err(outside(&self.name));
        }
        let (x, y) = (x.clamp(0.0, w - 1.0), y.clamp(0.0, h - 1.0));
        let (x0, y0) = (x.floor().min((w - 2.0).max(0.0)), y.floor().min((h - 2.0).max(0.0)));
        let mut sum = 0.0;
        for (dx, dy) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
            let share = (1.0 - (x - x0 - dx).abs()) * (1.0 - (y - y0 - dy).abs());
            if share <= 0.0 {
                continue;
            }
            let value = self.post((x0 + dx) as u32, (y0 + dy) as u32)?;
            if !value.is_finite() || self.no_data.is_some_and(|n| (value - n).abs() <= n.abs() * 1e-6) {
                return Err(outside(&self.name).found("a hole in the data there"));
            }
            sum += share * value;
        }
        to_ellipsoid((latitude, longitude), sum * self.keys.metres_per_unit, SIGMA, self.datum, None)
    }

    /// Whether a point lies on the file; it may have a hole there all the same.
    pub fn covers(&self, latitude: f64, longitude: f64) -> bool {
        let (w, h) = (f64::from(self.size.0), f64::from(self.size.1));
        let inside = |(x, y)| (-0.5..=w - 0.5).contains(&x) && (-0.5..=h - 0.5).contains(&y);
        self.keys.pixel(latitude, longitude).is_some_and(inside)
    }

    /// How many posts a point lies inside the file's nearest edges, along its rows and its columns; less than nothing outside,
    /// where in degrees what lies west of the file counts as far in the east. `None`
    /// where its coordinates say nothing.
    pub fn margin(&self, latitude: f64, longitude: f64) -> Option<[f64; 2]> {
        let (x, y) = self.keys.pixel(latitude, longitude)?;
        let within = |v: f64, n: u32| (v + 0.5).min(f64::from(n) - 0.5 - v);
        Some([within(x, self.size.0), within(y, self.size.1)])
    }

    /// Metres between posts along rows and along columns, about a point.
    pub fn spacing(&self, latitude: f64, longitude: f64) -> Option<[f64; 2]> {
        /// Metres on the ground between the points that are compared.
        const STEP: f64 = 1.0;
        let here = Geodetic { latitude, longitude, height: 0.0 };
        let at = |east: f64, north: f64| {
            let there = here.offset(Enu { east, north, up: 0.0 });
            self.keys.pixel(there.latitude, there.longitude)
        };
        let (a, b, c) = (at(0.0, 0.0)?, at(STEP, 0.0)?, at(0.0, STEP)?);
        let posts = [(b.0 - a.0).hypot(c.0 - a.0), (b.1 - a.1).hypot(c.1 - a.1)];
        Some(posts.map(|n| STEP / n))
    }

    /// Mean or lowest ground over points of a footprint, and its spread.
    ///
    /// # Errors
    /// As [`Dem::ground`], for any of the points; no points.
    pub fn under(&mut self, points: &[(f64, f64)], fit: Fit) -> Result<Height> {
        let mut heights = Vec::with_capacity(points.len());
        for &(latitude, longitude) in points {
            heights.push(self.ground(latitude, longitude)?.ellipsoidal);
        }
        let Some(lowest) = heights.iter().copied().reduce(f64::min) else {
            return Err(Error::usage(&self.name).expected("a footprint").found("no points"));
        };
        let mean = heights.iter().sum::<f64>() / heights.len() as f64;
        let spread = (heights.iter().map(|h| (h - mean).powi(2)).sum::<f64>() / heights.len() as f64).sqrt();
        let ellipsoidal = if fit == Fit::Min { lowest } else { mean };
        Ok(Height { ellipsoidal, sigma: SIGMA.hypot(spread) })
    }

    fn post(&mut self, x: u32, y: u32) -> Result<f64> {
        let across = self.size.0.div_ceil(self.chunk.0);
        let index = y / self.chunk.1 * across + x / self.chunk.0;
        if !self.chunks.contains_key(&index) {
            if self.chunks.len() >= CHUNKS {
                self.chunks.clear();
            }
            let read = self
                .decoder
                .read_chunk(index)
                .map_err(|e| Error::usage(&self.name).expected("readable heights").found(e.to_string()))?;
            let values = numbers(read).ok_or_else(|| {
                Error::usage(&self.name)
                    .expected("heights as integers or floating-point numbers")
                    .found("another kind of sample")
            })?;
            self.chunks.insert(index, values);
        }
        let width = self.decoder.chunk_data_dimensions(index).0;
        let at = (y % self.chunk.1) as usize * width as usize + (x % self.chunk.0) as usize;
        let value = self.chunks.get(&index).and_then(|c| c.get(at)).copied();
        value.ok_or_else(|| Error::usage(&self.name).expected("a whole file").found("a chunk that is cut short"))
    }
}

fn numbers(read: DecodingResult) -> Option<Vec<f64>> {
    fn all<T: Into<f64>>(v: Vec<T>) -> Option<Vec<f64>> {
        Some(v.into_iter().map(Into::into).collect())
    }
    match read {
        DecodingResult::U8(v) => all(v),
        DecodingResult::U16(v) => all(v),
        DecodingResult::U32(v) => all(v),
        DecodingResult::I8(v) => all(v),
        DecodingResult::I16(v) => all(v),
        DecodingResult::I32(v) => all(v),
        DecodingResult::F32(v) => all(v),
        DecodingResult::F64(v) => Some(v),
        _ => None,
    }
}

#[cfg(test)]
mod tests;
