//! How many metres a unit of the reconstruction is, and how well that is known.
//!
//! Every measurement gives an estimate with a standard deviation; they are combined by inverse variance of their
//! logarithms, since a scale is a ratio. What is assumed counts only where nothing was measured.

use super::Extents;
use super::positive::Positive;
use crate::photo::{Pinhole, focal_in_pixels};
use crate::{Error, Result};

/// A dimension the operator knows, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Known {
    Height(f64),
    /// The longer side of the smallest rectangle around the footprint.
    Length(f64),
    /// Its shorter side.
    Width(f64),
}

/// What the photo says about the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Angle of the line from the subject's centre to the camera above the horizontal, radians.
    pub elevation: f32,
    /// Its standard deviation, radians.
    pub elevation_sigma: f64,
    /// Side of the square crop, pixels of the photo.
    pub crop_side: f32,
    pub photo_width: u32,
    pub photo_height: u32,
    /// Distance and field of view (radians) of the canonical camera that sees exactly the crop, units.
    pub canonical_distance: f32,
    pub canonical_fov: f32,
    /// From EXIF, or as it is given.
    pub focal_35mm: Option<f64>,
    pub focal_given: bool,
    /// In pixels of the photo, from the camera's model that came with its pose: wins over EXIF's.
    pub posed_focal: Option<f64>,
}

/// Who says the focal length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FocalBy {
    Poses,
    Operator,
    Exif,
    Assumption,
}

/// A length in metres with its standard deviation, and who says so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    pub metres: f64,
    pub sigma: f64,
    pub by: By,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    Operator,
    Exif,
    /// A drone's height above its point of take-off.
    Drone,
    /// A metric depth network.
    Network,
    Assumption,
}

impl FocalBy {
    /// Of what holds for poses, an operator's word, EXIF and the assumption.
    fn pick<T: Copy>(self, [poses, given, exif, assumed]: [T; 4]) -> T {
        match self {
            FocalBy::Poses => poses,
            FocalBy::Operator => given,
            FocalBy::Exif => exif,
            FocalBy::Assumption => assumed,
        }
    }
}

/// Everything that can give a scale.
#[derive(Clone, Debug, PartialEq)]
pub struct Hints {
    pub known: Vec<Known>,
    /// Camera above the ground under the subject.
    pub camera_height: Measured,
    /// Camera to the subject's middle.
    pub distance: Option<Measured>,
    /// Camera to the subject's front, by a metric depth network, and how many units the front lies before the middle.
    pub front: Option<(Measured, f64)>,
    /// By cameras or points whose places on the Earth are known.
    pub registered: Option<Estimate>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScaleSource {
    KnownHeight,
    KnownLength,
    KnownWidth,
    /// Camera height over the ground, focal length from EXIF.
    CameraHeightExifFocal,
    /// Camera height over the ground, focal length assumed.
    CameraHeightAssumedFocal,
    DistanceExifFocal,
    DistanceAssumedFocal,
    /// Distance to the front by a metric depth network.
    MetricDepthExifFocal,
    MetricDepthAssumedFocal,
    /// Camera height over the ground, focal length of the posed camera.
    CameraHeightPosedFocal,
    DistancePosedFocal,
    MetricDepthPosedFocal,
    /// Camera height over the ground, focal length given.
    CameraHeightGivenFocal,
    DistanceGivenFocal,
    MetricDepthGivenFocal,
    /// The cameras' positions on the Earth, or ground control points.
    Georegistration,
}

impl ScaleSource {
    /// The camera stands on the ground under the subject.
    pub fn by_camera_height(self) -> bool {
        use ScaleSource::{
            CameraHeightAssumedFocal, CameraHeightExifFocal, CameraHeightGivenFocal, CameraHeightPosedFocal,
        };
        matches!(
            self,
            CameraHeightExifFocal | CameraHeightGivenFocal | CameraHeightAssumedFocal | CameraHeightPosedFocal
        )
    }

    pub fn label(self) -> &'static str {
        match self {
            ScaleSource::KnownHeight => "known-height",
            ScaleSource::KnownLength => "known-length",
            ScaleSource::KnownWidth => "known-width",
            ScaleSource::CameraHeightExifFocal => "camera-height-exif-focal",
            ScaleSource::CameraHeightAssumedFocal => "camera-height-assumed-focal",
            ScaleSource::DistanceExifFocal => "distance-exif-focal",
            ScaleSource::DistanceAssumedFocal => "distance-assumed-focal",
            ScaleSource::MetricDepthExifFocal => "metric-depth-exif-focal",
            ScaleSource::MetricDepthAssumedFocal => "metric-depth-assumed-focal",
            ScaleSource::CameraHeightPosedFocal => "camera-height-posed-focal",
            ScaleSource::DistancePosedFocal => "distance-posed-focal",
            ScaleSource::MetricDepthPosedFocal => "metric-depth-posed-focal",
            ScaleSource::CameraHeightGivenFocal => "camera-height-given-focal",
            ScaleSource::DistanceGivenFocal => "distance-given-focal",
            ScaleSource::MetricDepthGivenFocal => "metric-depth-given-focal",
            ScaleSource::Georegistration => "georegistration",
        }
    }
}

/// One way to the scale.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    pub metres_per_unit: f64,
    /// Of the logarithm.
    pub sigma: f64,
    pub source: ScaleSource,
    /// `camera height assumed 1.6 m, focal length assumed 28 mm`.
    pub words: String,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    pub metres_per_unit: f64,
    /// Relative standard deviation.
    pub sigma: f64,
    /// Of the best estimate.
    pub source: ScaleSource,
    /// What was combined, best first.
    pub estimates: Vec<Estimate>,
    /// Two estimates lie more than three of their standard deviations apart.
    pub contradictory: bool,
}

impl Scale {
    /// `height 1.45 m given; distance 6.2 m from EXIF`.
    pub fn words(&self) -> String {
        self.estimates.iter().map(|e| e.words.as_str()).collect::<Vec<_>>().join("; ")
    }

    /// What is to be said against a scale that rests on an eye's height where the photo looks down as from the air.
    pub fn doubt_from_the_air(&self, hints: &Hints, view: &View) -> Option<String> {
        let assumed = self.source.by_camera_height() && hints.camera_height.by == By::Assumption;
        (assumed && view.elevation > LOOKS_DOWN).then(|| {
            format!(
                "the photo looks down at the subject by {:.0}°, as from the air, and the size is that of one seen from {} m above its \
                 ground, which is assumed. Give --camera-height, or --height, --length or --width of the subject, in metres.",
                view.elevation.to_degrees(),
                hints.camera_height.metres
            )
        })
    }
}

/// Of a phone's main camera, where EXIF is silent.
pub const ASSUMED_FOCAL_35MM: f64 = 28.0;
/// A camera held at a standing person's eye.
pub const ASSUMED_CAMERA_HEIGHT: Measured = Measured { metres: 1.6, sigma: 0.2, by: By::Assumption };
/// From here on down, radians, nobody who stands there took the photo; what is small and near aside.
const LOOKS_DOWN: f32 = 0.7;
/// Phones have 24 to 28 mm, their other cameras and other people's zooms anything: a quarter.
pub const ASSUMED_FOCAL_SIGMA: f64 = 0.25;
/// The tag is a whole number of millimetres of a nominal lens.
const EXIF_FOCAL_SIGMA: f64 = 0.03;
/// Of a camera that was calibrated with its pose.
const POSED_FOCAL_SIGMA: f64 = 0.01;
/// How far a mesh's box is from its subject's: a voxel's width on each side.
const EXTENT_SIGMA: f64 = 0.02;
/// A dimension that somebody measured or looked up.
const KNOWN_SIGMA: f64 = 0.01;

impl View {
    /// Focal length in pixels of the photo, its relative standard deviation, and who says it.
    pub fn focal(&self) -> (f64, f64, FocalBy) {
        if let Some(pixels) = self.posed_focal {
            return (pixels, POSED_FOCAL_SIGMA, FocalBy::Poses);
        }
        let (focal_35mm, sigma, by) = match self.focal_35mm {
            Some(f) if self.focal_given => (f, EXIF_FOCAL_SIGMA, FocalBy::Operator),
            Some(f) => (f, EXIF_FOCAL_SIGMA, FocalBy::Exif),
            None => (ASSUMED_FOCAL_35MM, ASSUMED_FOCAL_SIGMA, FocalBy::Assumption),
        };
        (focal_in_pixels(focal_35mm, self.photo_width, self.photo_height), sigma, by)
    }

    /// By that focal length.
    pub fn pinhole(&self) -> Pinhole {
        Pinhole::centred(self.focal().0, (self.photo_width, self.photo_height))
    }

    /// Units from the camera to the subject's middle: D = d · 2 tan(fov / 2) · f / s, where the subject fills the crop
    /// with the photo's own focal length.
    pub fn distance(&self) -> f64 {
        let spread = 2.0 * f64::from(self.canonical_fov / 2.0).tan();
        f64::from(self.canonical_distance) * spread * self.focal().0 / f64::from(self.crop_side)
    }

    /// Units from the ground under the subject up to the camera: D sin(elevation) + centre above ground. Negative for a camera
    /// that looks up from below that ground.
    pub fn camera_above_ground(&self, extents: &Extents) -> f64 {
        self.distance() * f64::from(self.elevation).sin() + extents.centre_above_ground
    }

    /// The same of a camera that stands on that ground. `None` where that is not to be believed.
    pub fn standing_above_ground(&self, extents: &Extents) -> Option<Positive> {
        let (sin, cos) = f64::from(self.elevation).sin_cos();
        let by_elevation = cos * self.elevation_sigma;
        let sigma = self.distance() * (sin * self.focal().1).hypot(by_elevation);
        Positive::measured(self.camera_above_ground(extents), sigma)
    }

    fn focal_words(&self) -> String {
        match (self.posed_focal, self.focal_35mm) {
            (Some(f), _) => format!("focal length {f:.1} pixels of the posed camera"),
            (None, Some(f)) if self.focal_given => format!("focal length {f} mm given"),
            (None, Some(f)) => format!("focal length {f} mm from EXIF"),
            (None, None) => format!("focal length assumed {ASSUMED_FOCAL_35MM} mm"),
        }
    }
}

/// Combines what is known.
///
/// # Errors
/// A subject without extent where its dimension is known; nothing usable.
pub fn metres_per_unit(hints: &Hints, extents: &Extents, view: &View) -> Result<Scale> {
    let mut estimates = Vec::new();
    for known in &hints.known {
        estimates.push(from_dimension(*known, extents)?);
    }
    estimates.extend(hints.registered.clone());
    estimates.extend(hints.distance.map(|d| from_distance(d, view)));
    estimates.extend(hints.front.and_then(|(m, before)| from_front(m, before, view)));
    let assumed = hints.camera_height.by == By::Assumption;
    if !assumed || estimates.is_empty() {
        match from_camera_height(hints.camera_height, extents, view) {
            Some(e) => estimates.push(e),
            None if estimates.is_empty() => {
                return Err(Error::usage("scale")
                    .expected("a camera above the ground on which the subject stands")
                    .found(format!("one that looks up at the subject's middle by {:.1}°", -view.elevation.to_degrees()))
                    .advice("Give --height, --length or --width of the subject in metres."));
            }
            None => {}
        }
    }
    Ok(combine(estimates))
}

fn from_dimension(known: Known, extents: &Extents) -> Result<Estimate> {
    let (metres, units, source, name) = match known {
        Known::Height(m) => (m, extents.height, ScaleSource::KnownHeight, "height"),
        Known::Length(m) => (m, extents.length, ScaleSource::KnownLength, "length"),
        Known::Width(m) => (m, extents.width, ScaleSource::KnownWidth, "width"),
    };
    if units < 1e-6 {
        return Err(Error::usage(format!("--{name}"))
            .found("the reconstruction has no extent in that direction")
            .advice("Give another dimension of the subject."));
    }
    let sigma = KNOWN_SIGMA.hypot(EXTENT_SIGMA);
    Ok(Estimate { metres_per_unit: metres / units, sigma, source, words: format!("{name} {metres} m given") })
}

fn said(what: &str, m: Measured) -> String {
    match m.by {
        By::Operator => format!("{what} {} m given", m.metres),
        By::Exif => format!("{what} {} m from EXIF", m.metres),
        By::Drone => format!("{what} {} m above take-off", m.metres),
        By::Network => format!("{what} {:.2} m by a metric depth network", m.metres),
        By::Assumption => format!("{what} assumed {} m", m.metres),
    }
}

fn from_distance(distance: Measured, view: &View) -> Estimate {
    let (_, focal_sigma, by) = view.focal();
    Estimate {
        metres_per_unit: distance.metres / view.distance(),
        sigma: (distance.sigma / distance.metres).hypot(focal_sigma),
        source: by.pick([
            ScaleSource::DistancePosedFocal,
            ScaleSource::DistanceGivenFocal,
            ScaleSource::DistanceExifFocal,
            ScaleSource::DistanceAssumedFocal,
        ]),
        words: format!("{}, {}", said("distance", distance), view.focal_words()),
    }
}

/// The front lies that far: metres a unit = metres / (D − the front's distance before the middle). `None` where it would lie
/// behind the camera, or closer than a tenth of a unit.
fn from_front(front: Measured, before_middle: f64, view: &View) -> Option<Estimate> {
    let units = view.distance() - before_middle;
    if units < 0.1 {
        return None;
    }
    let (_, focal_sigma, by) = view.focal();
    let by_focal = view.distance() * focal_sigma / units;
    Some(Estimate {
        metres_per_unit: front.metres / units,
        sigma: (front.sigma / front.metres).hypot(by_focal),
        source: by.pick([
            ScaleSource::MetricDepthPosedFocal,
            ScaleSource::MetricDepthGivenFocal,
            ScaleSource::MetricDepthExifFocal,
            ScaleSource::MetricDepthAssumedFocal,
        ]),
        words: format!("{}, {}", said("front", front), view.focal_words()),
    })
}

/// The camera stands that high over the ground plane: metres a unit = height / (D sin(elevation) + centre above ground).
/// `None` where it looks up from so far below that no error of the elevation explains it.
fn from_camera_height(height: Measured, extents: &Extents, view: &View) -> Option<Estimate> {
    let units = view.standing_above_ground(extents)?;
    Some(Estimate {
        metres_per_unit: height.metres / units.median,
        sigma: (height.sigma / height.metres).hypot(units.sigma),
        source: view.focal().2.pick([
            ScaleSource::CameraHeightPosedFocal,
            ScaleSource::CameraHeightGivenFocal,
            ScaleSource::CameraHeightExifFocal,
            ScaleSource::CameraHeightAssumedFocal,
        ]),
        words: format!("{}, {}", said("camera height", height), view.focal_words()),
    })
}

/// Weighted mean of the logarithms; where they scatter more than they may, the deviation grows with them.
fn combine(mut estimates: Vec<Estimate>) -> Scale {
    estimates.sort_by(|a, b| a.sigma.total_cmp(&b.sigma));
    let weight: f64 = estimates.iter().map(|e| e.sigma.powi(-2)).sum();
    let mean = estimates.iter().map(|e| e.metres_per_unit.ln() * e.sigma.powi(-2)).sum::<f64>() / weight;
    let apart = |e: &Estimate| ((e.metres_per_unit.ln() - mean) / e.sigma).powi(2);
    let scatter = estimates.iter().map(apart).sum::<f64>() / (estimates.len() - 1).max(1) as f64;
    let contradictory = estimates.iter().enumerate().any(|(i, a)| {
        estimates[..i].iter().any(|b| (a.metres_per_unit / b.metres_per_unit).ln().abs() > 3.0 * a.sigma.hypot(b.sigma))
    });
    let metres_per_unit = if let [only] = &estimates[..] { only.metres_per_unit } else { mean.exp() };
    Scale {
        metres_per_unit,
        sigma: weight.sqrt().recip() * scatter.sqrt().max(1.0),
        source: estimates[0].source,
        estimates,
        contradictory,
    }
}

/// `4.6 m ± 0.5`: as many places as the deviation bears.
pub fn with_deviation(value: f64, sigma: f64, unit: &str) -> String {
    if !(sigma.is_finite() && sigma > 0.0) {
        return format!("{value}{unit}");
    }
    let first = sigma.log10().floor();
    // One digit of the deviation, two where it is a 1.
    let places = if sigma / 10f64.powf(first) < 1.95 { 1.0 - first } else { -first }.clamp(0.0, 9.0) as usize;
    format!("{value:.places$}{unit} ± {sigma:.places$}")
}

#[cfg(test)]
mod tests;
