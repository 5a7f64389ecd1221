//! The options of place and size, judged without the photo.

use std::fs::File;
use std::io::BufReader;
use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::audit::Marking;
use crate::audit::statement::Input;
use crate::cli::ground::open_dem;
use crate::geo::dem::{Dem, Fit};
use crate::geo::{self, AltDatum, Known, Written};
use crate::{Error, Result};

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum OriginIs {
    /// The ground point under the subject.
    Subject,
    /// The camera; the subject's point is computed from direction, elevation and distance.
    Camera,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Datum {
    /// The WGS84 ellipsoid.
    Ellipsoid,
    /// Mean sea level (EGM96).
    Msl,
    /// The terrain of --dem.
    Ground,
}

impl Datum {
    pub(super) fn plain(self) -> AltDatum {
        match self {
            Datum::Ellipsoid => AltDatum::Ellipsoid,
            Datum::Msl => AltDatum::Msl,
            Datum::Ground => AltDatum::Ground,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DemFit {
    /// The mean ground under the footprint.
    Mean,
    /// The lowest ground: nothing floats.
    Min,
    /// The mean, and the model's base follows the ground.
    Conform,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DemDatum {
    Ellipsoid,
    Msl,
}

impl DemDatum {
    pub fn plain(self) -> AltDatum {
        match self {
            DemDatum::Ellipsoid => AltDatum::Ellipsoid,
            DemDatum::Msl => AltDatum::Msl,
        }
    }
}

/// Where and which way.
#[derive(Args, Clone, Debug)]
pub struct PlaceArgs {
    /// The subject's place: decimal degrees, degrees-minutes-seconds, MGRS, UTM, `EPSG:code x,y[,z]` or a geo: URI, with a
    /// height in metres. Default: computed from the camera's position in the photo.
    #[arg(long, value_name = "LAT,LON,ALT", allow_hyphen_values = true)]
    pub origin: Option<String>,

    /// What the origin is a point of. Default: the subject where --origin is given, the camera where the photo says it.
    #[arg(long, value_enum)]
    pub origin_is: Option<OriginIs>,

    /// What the height is above. Default: the ellipsoid; for a photo's own altitude what it says, else the sea.
    #[arg(long, value_enum)]
    pub alt_datum: Option<Datum>,

    /// How well the origin is known across the ground (one standard deviation). Default: its last written place.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    pub origin_accuracy: Option<f64>,

    /// Bearing in which the camera looked, degrees clockwise from true north. Default: the photo's EXIF or XMP, else 0.
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub heading: Option<f64>,

    /// Terrain (GeoTIFF in degrees, UTM or UPS) that the model stands on.
    #[arg(long, value_name = "FILE")]
    pub dem: Option<PathBuf>,

    /// How the terrain under the footprint becomes the model's height.
    #[arg(long, value_enum, default_value = "mean", requires = "dem")]
    pub dem_fit: DemFit,

    /// What the terrain's heights are above. Default: what the file says, else the sea.
    #[arg(long, value_enum, requires = "dem")]
    pub dem_datum: Option<DemDatum>,
}

/// What is known of the subject's size.
#[derive(Args, Clone, Debug)]
pub struct SizeArgs {
    /// The subject's true height.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    pub height: Option<f64>,

    /// The subject's true length: the longer side of its footprint.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    pub length: Option<f64>,

    /// The subject's true width: the shorter side of its footprint.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    pub width: Option<f64>,

    /// Height of the camera above the ground; assumed 1.6 m where nothing else gives the scale.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    pub camera_height: Option<f64>,

    /// Distance from the camera to the subject.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    pub distance: Option<f64>,
}

/// The options, judged without the photo.
pub struct Wanted {
    pub origin: Option<Written>,
    pub(super) origin_is: Option<OriginIs>,
    pub(super) datum: Option<AltDatum>,
    pub(super) accuracy: Option<f64>,
    pub(super) heading: Option<f64>,
    pub(super) terrain: Option<Terrain>,
    pub(super) known: Vec<Known>,
    pub(super) camera_height: Option<f64>,
    pub(super) distance: Option<f64>,
}

pub(super) struct Terrain {
    pub(super) name: String,
    pub(super) dem: Dem<BufReader<File>>,
    pub(super) fit: Fit,
    pub(super) input: Input,
}

impl Wanted {
    /// What the terrain is marked.
    ///
    /// # Errors
    /// As [`Marking::parse`].
    pub fn terrain_marking(&self) -> Result<Vec<Option<Marking>>> {
        let banner = |t: &Terrain| t.input.marking.as_deref().map(Marking::parse).transpose();
        self.terrain.iter().map(banner).collect()
    }
}

/// Reads and checks every option, opens the terrain.
///
/// # Errors
/// Usage errors that name the option and the wrong part.
pub fn wanted(place: &PlaceArgs, size: &SizeArgs) -> Result<Wanted> {
    let positive = |value: Option<f64>, name: &str| match value {
        Some(v) if !(v.is_finite() && v > 0.0 && v < 10_000.0) => {
            Err(Error::usage(name).expected("metres between 0 and 10,000").found(format!("{v}")))
        }
        other => Ok(other),
    };
    let known = [
        positive(size.height, "--height")?.map(Known::Height),
        positive(size.length, "--length")?.map(Known::Length),
        positive(size.width, "--width")?.map(Known::Width),
    ];
    if let Some(h) = place.heading.filter(|h| !(h.is_finite() && (-360.0..=360.0).contains(h))) {
        return Err(Error::usage("--heading").expected("degrees between -360 and 360").found(h.to_string()));
    }
    let origin = place.origin.as_deref().map(|text| geo::parse_point("--origin", text)).transpose()?;
    let datum = place.alt_datum.map(Datum::plain);
    if let Some(o) = &origin {
        check_height(o, datum, place)?;
    }
    if datum == Some(AltDatum::Ground) && place.dem.is_none() {
        return Err(Error::usage("--alt-datum ground")
            .expected("a terrain that the height is above")
            .found("no --dem")
            .advice("Give --dem FILE, or a height above the ellipsoid or the sea."));
    }
    Ok(Wanted {
        origin,
        origin_is: place.origin_is,
        datum,
        accuracy: positive(place.origin_accuracy, "--origin-accuracy")?,
        heading: place.heading,
        terrain: terrain(place)?,
        known: known.into_iter().flatten().collect(),
        camera_height: positive(size.camera_height, "--camera-height")?,
        distance: positive(size.distance, "--distance")?,
    })
}

/// A subject stands either at its written height or on the terrain.
fn check_height(o: &Written, datum: Option<AltDatum>, place: &PlaceArgs) -> Result<()> {
    let of_subject = place.origin_is != Some(OriginIs::Camera);
    match (o.height, &place.dem) {
        (None, None) => Err(Error::usage("--origin")
            .expected("a height behind the position, or --dem")
            .found(format!("`{}`", place.origin.as_deref().unwrap_or_default()))
            .advice("Write latitude,longitude,height, for example --origin 34.5523,-118.4712,740")),
        (Some(h), Some(_)) if of_subject && datum != Some(AltDatum::Ground) => Err(Error::usage("--origin")
            .expected("no height beside --dem, or one above the ground (--alt-datum ground)")
            .found(format!("a height of {h} m"))
            .advice("The terrain decides the height: leave one of the two out.")),
        _ => Ok(()),
    }
}

fn terrain(place: &PlaceArgs) -> Result<Option<Terrain>> {
    let Some(path) = &place.dem else { return Ok(None) };
    let (dem, input) = open_dem(path, place.dem_datum.map(DemDatum::plain))?;
    let fit = match place.dem_fit {
        DemFit::Mean => Fit::Mean,
        DemFit::Min => Fit::Min,
        DemFit::Conform => Fit::Conform,
    };
    Ok(Some(Terrain { name: input.name.clone(), dem, fit, input }))
}
