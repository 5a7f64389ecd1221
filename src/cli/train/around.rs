//! `--ground-dem`: terrain that is known around a scene, for a CDB store.

use std::cell::RefCell;
use std::fs::File;
use std::io::BufReader;
use std::path::PathBuf;

use crate::audit::Marking;
use crate::audit::statement::Input;
use crate::cli::geo::options::DemDatum;
use crate::cli::ground::open_dem;
use crate::geo::Geodetic;
use crate::geo::dem::Dem;
use crate::{Error, Result};

#[derive(Clone, Debug, Default, clap::Args)]
pub struct AroundArgs {
    /// Terrain around the scene in a CDB store, a GeoTIFF of heights: the scene's ground goes over into it, and it says what lies
    /// where no photo saw the ground. Default: the store's own, else level (invented).
    #[arg(long, value_name = "FILE")]
    pub ground_dem: Option<PathBuf>,
    /// What its heights are above. Default: what the file says, else the sea.
    #[arg(long, value_enum, requires = "ground_dem")]
    pub ground_dem_datum: Option<DemDatum>,
}

/// The terrain, opened.
pub struct Around {
    pub name: String,
    /// For the record.
    pub input: Input,
    dem: RefCell<Dem<BufReader<File>>>,
}

impl AroundArgs {
    /// # Errors
    /// Usage for a file that is no GeoTIFF of heights, and where no store is written.
    pub fn open(&self, has_store: bool) -> Result<Option<Around>> {
        let Some(path) = &self.ground_dem else { return Ok(None) };
        if !has_store {
            return Err(Error::usage("--ground-dem").expected("--format cdb beside it").found("other formats only"));
        }
        let (dem, input) = open_dem(path, self.ground_dem_datum.map(DemDatum::plain))?;
        Ok(Some(Around { name: input.name.clone(), input, dem: RefCell::new(dem) }))
    }
}

impl Around {
    /// Metres above the ellipsoid; `None` beside the file and in its holes.
    pub fn height(&self, latitude: f64, longitude: f64) -> Option<f64> {
        let mut dem = self.dem.borrow_mut();
        let covered = dem.covers(latitude, longitude);
        if covered { dem.ground(latitude, longitude).ok().map(|h| h.ellipsoidal) } else { None }
    }

    /// Metres that a place lies inside the file's edge, less than nothing outside. `metres`: between posts, as [`Around::spacing`]
    /// has them.
    pub fn depth(&self, latitude: f64, longitude: f64, metres: [f64; 2]) -> f64 {
        let margin = self.dem.borrow().margin(latitude, longitude);
        margin.map_or(f64::NEG_INFINITY, |[x, y]| (x * metres[0]).min(y * metres[1]))
    }

    /// Metres between posts along rows and columns about the scene's place.
    pub fn spacing(&self, place: Geodetic) -> [f64; 2] {
        self.dem.borrow().spacing(place.latitude, place.longitude).unwrap_or([1.0; 2])
    }

    /// # Errors
    /// Usage where the file has no height at the scene's place: it is of another place, or damaged.
    pub fn check(&self, place: Geodetic) -> Result<()> {
        self.dem
            .borrow_mut()
            .ground(place.latitude, place.longitude)
            .map(drop)
            .map_err(|e| Error { advice: "Give terrain of the scene's place, or leave --ground-dem out.".into(), ..e })
    }

    /// The marking that the file carries.
    ///
    /// # Errors
    /// Policy for one that is not understood.
    pub fn carried(&self) -> Result<Option<Marking>> {
        self.input.marking.as_deref().map(Marking::parse).transpose()
    }
}
