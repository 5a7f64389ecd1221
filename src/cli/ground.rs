//! The ground under a model in a CDB store.

use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use clap::Args;
use orb_formats::cdb::{self, AddedGround, Ground};

use super::marking;
use crate::audit::statement::Input;
use crate::audit::{Marking, record};
use crate::export;
use crate::geo::AltDatum;
use crate::geo::dem::Dem;
use crate::geo::ortho::Ortho;
use crate::{Error, Result};

/// What the ground is made of.
#[derive(Args, Clone, Debug, Default)]
pub struct GroundArgs {
    /// Write terrain and imagery under the model into the CDB store, level where the model stands.
    #[arg(long)]
    pub ground: bool,

    /// Terrain around the model, a GeoTIFF of heights. Default: the store's own, else level (invented).
    #[arg(long, value_name = "FILE", requires = "ground")]
    pub ground_dem: Option<PathBuf>,

    /// Picture of the ground, a GeoTIFF of colours. Default: grey.
    #[arg(long, value_name = "FILE", requires = "ground")]
    pub ground_image: Option<PathBuf>,
}

/// The files of the ground, read.
pub struct GroundFiles {
    dem: Option<Dem<BufReader<File>>>,
    image: Option<Ortho>,
    /// For the record.
    pub inputs: Vec<Input>,
}

impl GroundArgs {
    /// Opens what was named; `None` where no ground was asked for. `datum` overrides what the terrain says its heights are
    /// above.
    ///
    /// # Errors
    /// Usage for files that are no GeoTIFF of their kind, and for ground without a CDB store.
    pub fn open(&self, has_store: bool, datum: Option<AltDatum>) -> Result<Option<GroundFiles>> {
        if !self.ground {
            return Ok(None);
        }
        if !has_store {
            return Err(Error::usage("--ground").expected("--format cdb beside it").found("other formats only"));
        }
        let (mut dem, mut image, mut inputs) = (None, None, Vec::new());
        if let Some(path) = &self.ground_dem {
            let (open, input) = open_dem(path, datum)?;
            dem = Some(open);
            inputs.push(input);
        }
        if let Some(path) = &self.ground_image {
            let (input, bytes) = geotiff(path, "imagery")?;
            image = Some(Ortho::read(&input.name, &bytes)?);
            inputs.push(input);
        }
        Ok(Some(GroundFiles { dem, image, inputs }))
    }
}

/// A GeoTIFF for the record, and its bytes.
fn geotiff(path: &Path, role: &str) -> Result<(Input, Vec<u8>)> {
    let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let bytes = std::fs::read(path).map_err(|e| Error::io(path, &e).advice("Check the path."))?;
    Ok((record::input(&name, &bytes, "image/tiff", role, marking::carried(&name, &bytes)?), bytes))
}

/// Terrain, opened to be read chunk by chunk, and what the record says of it. `datum`: instead of what the file says.
///
/// # Errors
/// Usage for what is no GeoTIFF of heights, and environment where it cannot be read.
pub fn open_dem(path: &Path, datum: Option<AltDatum>) -> Result<(Dem<BufReader<File>>, Input)> {
    let (input, bytes) = geotiff(path, "terrain")?;
    drop(bytes);
    let file = File::open(path).map_err(|e| Error::io(path, &e))?;
    Ok((Dem::open(&input.name, BufReader::new(file), datum)?, input))
}

impl GroundFiles {
    /// The markings that the files carry.
    ///
    /// # Errors
    /// Policy for one that is not understood.
    pub fn carried(&self) -> Result<Vec<Option<Marking>>> {
        self.inputs.iter().map(|i| i.marking.as_deref().map(Marking::parse).transpose()).collect()
    }

    /// The tiles under a model.
    ///
    /// # Errors
    /// What [`cdb::add_ground`] refuses.
    pub fn under(&mut self, store: &dyn cdb::Store, model: &cdb::Model) -> Result<AddedGround> {
        let reach = |level: &cdb::Level| level.mesh.positions.iter().map(|p| p[0].hypot(p[1])).fold(0.0, f64::max);
        let (has_terrain, has_colors) = (self.dem.is_some(), self.image.is_some());
        let mut heights = |latitude: f64, longitude: f64| {
            let dem = self.dem.as_mut()?;
            if dem.covers(latitude, longitude) {
                dem.ground(latitude, longitude).ok().map(|h| h.ellipsoidal)
            } else {
                None
            }
        };
        let mut colors = |latitude: f64, longitude: f64| self.image.as_ref()?.color(latitude, longitude);
        let ground = Ground {
            latitude: model.latitude,
            longitude: model.longitude,
            height: model.height,
            // A little more than the model covers.
            radius: 1.2 * model.levels.iter().map(reach).fold(0.1, f64::max),
            terrain: None,
            colors: None,
            marking: &model.marking,
        };
        let ground = Ground {
            terrain: if has_terrain { Some(&mut heights) } else { None },
            colors: if has_colors { Some(&mut colors) } else { None },
            ..ground
        };
        cdb::add_ground(store, ground).map_err(export::format_error)
    }
}
