//! From options and photo to a place, a heading and a size, each with what it is known to.

use std::f64::consts::SQRT_2;
use std::fs::File;
use std::io::BufReader;

use glam::DVec3;

use super::manifest::LINE_KEY;
use super::options::{OriginIs, Wanted};
use crate::audit::record;
use crate::audit::statement::{Input, Param};
use crate::export::ToMetres;
use crate::geo::dem::{Dem, Fit};
use crate::geo::scale::{ASSUMED_CAMERA_HEIGHT, By, Estimate, Hints, Measured};
use crate::geo::similarity::Similarity;
use crate::geo::{
    self, AltDatum, Extents, Geodetic, HeadingSource, Height, Placement, Scale, ScaleSource, Uncertainty, View,
    footprint, magnetic, sight,
};
use crate::models::depth::fit::Front;
use crate::photo::{AltitudeAbove, Exif, Photo};
use crate::photos::register::{self, Fix, Registration, Residual};
use crate::pipeline::Reconstruction;
use crate::{Error, Result};

/// A position to start from.
struct Anchor {
    latitude: f64,
    longitude: f64,
    height: Option<f64>,
    datum: AltDatum,
    horizontal: f64,
    vertical: f64,
    is: OriginIs,
    words: String,
}

/// Deviation of the scale's logarithm from which on the user is told.
const HARDLY_KNOWN: f64 = 0.5;
/// What a phone's receiver is good to under open sky.
const GNSS_SIGMA: f64 = 5.0;
/// Bearings: typed in, of a gimbal, of a hand-held compass, of nobody (uniform).
const GIVEN_HEADING_SIGMA: f64 = 1.0;
const GIMBAL_SIGMA: f64 = 3.0;
const COMPASS_SIGMA: f64 = 5.0;
const UNKNOWN_HEADING_SIGMA: f64 = 103.9;
/// Of the networks' elevation, at least, degrees: below this their errors were not told apart.
const LEAST_ELEVATION_SIGMA: f64 = 1.0;
/// Of a posed camera's over the ground that the photos or their points show.
const POSED_ELEVATION_SIGMA: f64 = 1.0;
/// Of a metric depth network's distances, relative: assumed, for photos unlike those that it was trained on.
const METRIC_DEPTH_SIGMA: f64 = 0.25;

impl Wanted {
    fn anchor(&self, exif: &Exif) -> Result<Anchor> {
        if let Some(o) = &self.origin {
            let horizontal = self.accuracy.or(o.sigma).unwrap_or(o.rounding / 3f64.sqrt());
            let datum = o.height_datum.or(self.datum).unwrap_or(AltDatum::Ellipsoid);
            return Ok(Anchor {
                latitude: o.latitude,
                longitude: o.longitude,
                height: o.height,
                datum,
                horizontal,
                vertical: o.sigma.unwrap_or(o.height_rounding / 3f64.sqrt()),
                is: self.origin_is.unwrap_or(OriginIs::Subject),
                words: format!("given as {}", o.read_as()),
            });
        }
        let Some(p) = exif.position else {
            let found = match &exif.foreign_datum {
                Some(datum) => format!("a photo whose position is on the datum {datum}"),
                None => "no --origin and a photo without a GPS position".into(),
            };
            return Err(Error::usage("--origin")
                .expected("a place")
                .found(found)
                .advice("Write latitude,longitude,height, for example --origin 34.5523,-118.4712,740"));
        };
        let horizontal = self.accuracy.or(p.accuracy).unwrap_or(GNSS_SIGMA);
        let own = if p.altitude_above == AltitudeAbove::Ellipsoid { AltDatum::Ellipsoid } else { AltDatum::Msl };
        if p.altitude.is_none() && self.terrain.is_none() {
            return Err(Error::usage("--origin")
                .expected("a height")
                .found("a photo with a position but no altitude")
                .advice("Give --origin with a height, or --dem FILE."));
        }
        Ok(Anchor {
            latitude: p.latitude,
            longitude: p.longitude,
            height: p.altitude,
            datum: self.datum.filter(|d| *d != AltDatum::Ground).unwrap_or(own),
            horizontal,
            // Satellites fix heights about half as well as positions.
            vertical: p.vertical_accuracy.unwrap_or(2.0 * horizontal),
            is: self.origin_is.unwrap_or(OriginIs::Camera),
            words: "from the photo's GPS position".into(),
        })
    }

    /// About where the model will stand, WGS 84 degrees, and whether that is where the camera stood.
    ///
    /// # Errors
    /// As [`Wanted::check`].
    pub fn roughly(&self, exif: &Exif) -> Result<(f64, f64, bool)> {
        let anchor = self.anchor(exif)?;
        Ok((anchor.latitude, anchor.longitude, anchor.is == OriginIs::Camera))
    }

    /// What can be known before the work: that there is a place, and that the terrain reaches it.
    ///
    /// # Errors
    /// No origin and a photo without a position; a position without a height, or beside the terrain.
    pub fn check(&mut self, exif: &Exif) -> Result<()> {
        let anchor = self.anchor(exif)?;
        self.check_terrain(anchor.latitude, anchor.longitude)
    }

    /// As [`Wanted::check`], where control points say the place in the origin's stead.
    ///
    /// # Errors
    /// Points that give no place; points beside the terrain.
    pub fn check_control(&mut self, fixes: &[Fix], seed: u64) -> Result<()> {
        let points: Vec<&Fix> = fixes.iter().filter(|f| f.control).collect();
        match points.first().filter(|_| register::register(fixes, &Similarity::IDENTITY, seed).is_some()) {
            Some(point) => self.check_terrain(point.place.latitude, point.place.longitude),
            None => Err(Error::usage("--gcp")
                .expected("two control points or more, apart and not above each other")
                .found(format!("{}", points.len()))
                .advice("Add points, or give the place: --origin.")),
        }
    }

    fn check_terrain(&mut self, latitude: f64, longitude: f64) -> Result<()> {
        match &mut self.terrain {
            Some(t) => t.dem.ground(latitude, longitude).map(drop),
            None => Ok(()),
        }
    }
}

/// A placed model.
pub struct Placed {
    pub placement: Placement,
    pub uncertainty: Uncertainty,
    pub scale: Scale,
    pub to_metres: ToMetres,
    /// How position, heading and scale were found, a sentence each.
    pub lineage: Vec<String>,
    pub warnings: Vec<String>,
    /// The terrain, for the record.
    pub inputs: Vec<Input>,
    /// Of several photos, from the unit frame.
    pub registration: Option<Registration>,
}

impl Placed {
    /// For the record. `line` is the key of a manifest's line.
    pub fn params(&self, line: Option<&str>) -> Vec<(String, Param)> {
        let (o, u) = (&self.placement.origin, &self.uncertainty);
        let mut all = vec![
            ("latitude", o.latitude.to_string()),
            ("longitude", o.longitude.to_string()),
            ("ellipsoidal_height_m", o.height.to_string()),
            ("geoid_egm96_m", format!("{:.3}", geo::geoid::undulation(o.latitude, o.longitude))),
            ("heading_deg", self.placement.heading.to_string()),
            ("heading_source", self.placement.heading_source.label().into()),
            ("metres_per_unit", self.scale.metres_per_unit.to_string()),
            ("scale_source", self.scale.source.label().into()),
            ("horizontal_sigma_m", format!("{:.4}", u.horizontal)),
            ("vertical_sigma_m", format!("{:.4}", u.vertical)),
            ("heading_sigma_deg", format!("{:.3}", u.heading)),
            ("scale_sigma_percent", format!("{:.3}", u.scale * 100.0)),
            ("georeference", record::printable(&self.lineage.join(" "))),
        ];
        if let Some(r) = &self.registration {
            let [across, up] = r.rms();
            all.push(("georegistration_rms_m", format!("{across:.4} across, {up:.4} up")));
            let one = |x: &Residual| {
                let [e, n, u] = x.enu.to_array();
                format!("{} {e:.3} {n:.3} {u:.3}{}", x.name, if x.outlier { " outlier" } else { "" })
            };
            let residuals: Vec<String> = r.residuals.iter().map(one).collect();
            all.push(("georegistration_residuals_enu_m", record::printable(&residuals.join("; "))));
            let o = &r.origin;
            let about = format!("{} about {} {} {}", r.to_enu, o.latitude, o.longitude, o.height);
            all.push(("unit_to_enu", about));
        }
        all.extend(line.map(|key| (LINE_KEY, key.to_owned())));
        all.into_iter().map(|(name, value)| (name.to_owned(), Param::Text(value))).collect()
    }
}

/// Places a reconstruction; with a terrain that the base conforms to, bends its meshes and Gaussians. `year` is the
/// decimal year for the magnetic model where the photo has no date.
///
/// # Errors
/// No usable scale; a terrain that does not cover the footprint.
pub fn place(
    mut wanted: Wanted,
    photo: &Photo,
    done: &mut Reconstruction,
    fixes: &[Fix],
    seed: u64,
    year: f64,
) -> Result<Placed> {
    let registration = done.several.as_ref().and_then(|s| register::register(fixes, &s.to_unit, seed));
    let exif = &photo.exif;
    let finest = done.model.levels.first().ok_or_else(|| Error::usage(&photo.name).found("no surface"))?;
    let extents = Extents::of(finest.mesh.positions.iter().map(|p| p.as_dvec3().to_array()))
        .ok_or_else(|| Error::usage(&photo.name).found("no surface to measure"))?;
    let mut warnings = Vec::new();
    let view = view(photo, done);
    let registered = registration.as_ref().map(|r| Estimate {
        metres_per_unit: r.to_enu.scale,
        sigma: r.scale_sigma,
        source: ScaleSource::Georegistration,
        words: registration_words(r),
    });
    let hints = Hints { registered, ..hints(&wanted, exif, done.sources.front) };
    let scale = geo::metres_per_unit(&hints, &extents, &view)?;
    if scale.contradictory {
        warnings.push(format!("what gives the scale contradicts itself: {}", scale.words()));
    }
    warnings.extend(scale.doubt_from_the_air(&hints, &view));
    if scale.sigma > HARDLY_KNOWN {
        warnings.push(format!(
            "the size is known to a factor of {:.1} alone, one standard deviation: the photo looks level or up at the subject, and \
             its ground says little. Give --height, --length or --width of the subject in metres.",
            scale.sigma.exp()
        ));
    }
    let to_metres = ToMetres::new(&finest.mesh, scale.metres_per_unit);
    let registered = registration.as_ref().filter(|_| wanted.origin.is_none());
    let anchor = match registered {
        Some(r) => registered_anchor(r, to_metres.base.as_dvec3()),
        None => wanted.anchor(exif)?,
    };
    let (crop, lens) = (&done.prior.crop, view.pinhole());
    let (right, down) = (crop.right(&lens), crop.down(&lens, f64::from(view.elevation)));
    let heading = match registration.as_ref().filter(|_| wanted.heading.is_none()) {
        Some(r) => Heading {
            degrees: r.heading(),
            sigma: r.heading_sigma,
            source: HeadingSource::Georegistration,
            words: format!("Heading {}.", registration_words(r)),
        },
        None => {
            heading(&wanted, exif, &anchor, year, |axis| sight::bearing_of_subject(axis, right, down), &mut warnings)
        }
    };
    if let Some(r) = &registration {
        warnings.extend(r.contradiction(fixes));
        warnings.extend(r.outliers().map(|o| {
            format!(
                "{} lies {:.1} m from where the others put it and is not used for the place",
                o.name,
                o.enu.length()
            )
        }));
    }
    let known = Uncertainty {
        horizontal: anchor.horizontal,
        vertical: anchor.vertical,
        heading: heading.sigma,
        scale: scale.sigma,
    };

    // The anchor above the ellipsoid; a height above ground waits for the terrain.
    let anchored = match (anchor.height, anchor.datum) {
        (Some(h), AltDatum::Ground) => Height { ellipsoidal: h, sigma: anchor.vertical },
        (Some(h), datum) => geo::to_ellipsoid((anchor.latitude, anchor.longitude), h, anchor.vertical, datum, None)?,
        (None, _) => Height { ellipsoidal: 0.0, sigma: 0.0 },
    };
    let at = Geodetic { latitude: anchor.latitude, longitude: anchor.longitude, height: anchored.ellipsoidal };
    let known = Uncertainty { vertical: anchored.sigma, ..known };
    let mut lineage = vec![];
    let (mut origin, mut uncertainty) = match anchor.is {
        OriginIs::Subject => {
            lineage.push(format!("Position of the subject {}, height above {}.", anchor.words, anchor.datum.words()));
            (at, known)
        }
        OriginIs::Camera => {
            let stand = sight::stand(&view, &extents, &scale);
            if heading.source == HeadingSource::Assumed {
                warnings.push(format!(
                    "no direction is known: the subject is placed {:.1} m north of the camera; give --heading",
                    stand.across
                ));
            }
            lineage.push(format!(
                "Position of the camera {}, height above {}; the subject computed {:.1} m away on a bearing of {:.1} degrees, \
                 {:.1} m below.",
                anchor.words, anchor.datum.words(), stand.across, heading.degrees, stand.above
            ));
            let point = sight::subject_point(at, heading.degrees, &stand);
            (point, sight::subject_uncertainty(known, &stand))
        }
    };
    let mut inputs = Vec::new();
    let placement =
        |origin| Placement { origin, heading: heading.degrees.rem_euclid(360.0), heading_source: heading.source };
    if let Some(mut t) = wanted.terrain.take() {
        let outline = outline(done, &to_metres, &placement(origin));
        let ground = t.dem.under(&outline.samples(), t.fit)?;
        let above = if anchor.is == OriginIs::Subject && anchor.datum == AltDatum::Ground {
            anchor.height.unwrap_or(0.0)
        } else {
            0.0
        };
        origin.height = ground.ellipsoidal + above;
        uncertainty.vertical = ground.sigma.hypot(if above == 0.0 { 0.0 } else { anchor.vertical });
        lineage.push(format!(
            "Height from the terrain {} ({} under the footprint, above {}).",
            t.name,
            t.fit.label(),
            t.dem.datum.words()
        ));
        if t.fit == Fit::Conform {
            conform(&mut t.dem, &placement(origin), ground.ellipsoidal, &to_metres, done)?;
        }
        inputs.push(t.input);
    }
    lineage.push(heading.words);
    lineage.push(format!("Scale: {}.", scale.words()));
    Ok(Placed { placement: placement(origin), uncertainty, scale, to_metres, lineage, warnings, inputs, registration })
}

/// The footprint of the finest level.
pub fn outline(done: &Reconstruction, to_metres: &ToMetres, placement: &Placement) -> footprint::Footprint {
    let points = done.model.levels.first().map(|l| l.mesh.positions.as_slice()).unwrap_or_default();
    footprint::of(points.iter().map(|p| to_metres.point(*p)), placement)
}

fn view(photo: &Photo, done: &Reconstruction) -> View {
    // The camera that the subject's silhouette fits, not the network's nominal one: they differ by a zoom.
    let camera = &done.prior.camera;
    let crop = &done.prior.crop;
    let view = View {
        elevation: done.prior.seen_from.mean,
        // Of a Laplace distribution whose mean error is the expected one.
        elevation_sigma: (SQRT_2 * f64::from(done.prior.seen_from.spread)).max(LEAST_ELEVATION_SIGMA.to_radians()),
        crop_side: crop.rect.width,
        photo_width: photo.pixels.width(),
        photo_height: photo.pixels.height(),
        canonical_distance: camera.position().length(),
        canonical_fov: 2.0 * (camera.width as f32 / 2.0 / camera.fx).atan(),
        focal_35mm: photo.exif.focal_35mm,
        focal_given: photo.exif.focal_given,
        posed_focal: None,
    };
    if let Some(focal) = done.several.as_ref().and_then(|s| s.reference_focal) {
        let elevation_sigma = POSED_ELEVATION_SIGMA.to_radians();
        return View { posed_focal: Some(focal), elevation_sigma, ..view };
    }
    // Of one photo the network was told, and `seen_from` says it.
    match photo.exif.gimbal.and_then(|g| g.pitch).filter(|_| done.several.is_some()) {
        Some(pitch) => View {
            elevation: sight::elevation_by_pitch(pitch, crop.middle(), &view) as f32,
            elevation_sigma: sight::PITCH_SIGMA.to_radians(),
            ..view
        },
        None => view,
    }
}

/// A length that somebody paced, taped or read off: three hundredths, five centimetres at least.
fn measured(metres: f64) -> Measured {
    Measured { metres, sigma: (0.03 * metres).max(0.05), by: By::Operator }
}

fn hints(wanted: &Wanted, exif: &Exif, front: Option<Front>) -> Hints {
    // A height above take-off is one above the subject's ground as far as the terrain is level.
    let flown = exif.gimbal.and_then(|g| g.above_takeoff).filter(|h| *h > 2.0);
    let by_drone = flown.map(|h| Measured { metres: h, sigma: 2.0 + 0.02 * h, by: By::Drone });
    let by_exif = exif.subject_distance.map(|d| Measured { metres: d, sigma: 0.3 * d, by: By::Exif });
    Hints {
        known: wanted.known.clone(),
        camera_height: wanted.camera_height.map(measured).or(by_drone).unwrap_or(ASSUMED_CAMERA_HEIGHT),
        distance: wanted.distance.map(measured).or(by_exif),
        front: front.map(|f| {
            let sigma = METRIC_DEPTH_SIGMA * f.metres;
            (Measured { metres: f.metres, sigma, by: By::Network }, f.before_middle)
        }),
        registered: None,
    }
}

/// The point of the unit frame, by the registration.
fn registered_anchor(r: &Registration, at: DVec3) -> Anchor {
    let place = r.place(at);
    let [horizontal, vertical] = r.sigma(at);
    Anchor {
        latitude: place.latitude,
        longitude: place.longitude,
        height: Some(place.height),
        datum: AltDatum::Ellipsoid,
        horizontal,
        vertical,
        is: OriginIs::Subject,
        words: registration_words(r),
    }
}

/// `from 7 cameras on the Earth, residuals 1.2 m across, 2.3 m up (rms)`.
fn registration_words(r: &Registration) -> String {
    let used = |control: bool| r.residuals.iter().filter(|x| !x.outlier && x.control == control).count();
    let [across, up] = r.rms();
    let what = match (used(false), used(true)) {
        (cameras, 0) => format!("{cameras} cameras"),
        (0, points) => format!("{points} control points"),
        (cameras, points) => format!("{cameras} cameras and {points} control points"),
    };
    format!("from {what} on the Earth, residuals {across:.2} m across, {up:.2} m up")
}

struct Heading {
    degrees: f64,
    sigma: f64,
    source: HeadingSource,
    words: String,
}

/// Given; else the gimbal's yaw; else EXIF's direction, made true where it is magnetic; else north. The photo's own
/// bearings are those of the optical axis, `beside` makes them the subject's.
fn heading(
    wanted: &Wanted,
    exif: &Exif,
    anchor: &Anchor,
    year: f64,
    beside: impl Fn(f64) -> f64,
    warnings: &mut Vec<String>,
) -> Heading {
    let heading = |degrees: f64, sigma, source, words: String| Heading { degrees, sigma, source, words };
    if let Some(h) = wanted.heading {
        return heading(h, GIVEN_HEADING_SIGMA, HeadingSource::Given, "Heading given.".into());
    }
    if let Some(yaw) = exif.gimbal.and_then(|g| g.yaw) {
        return heading(
            beside(yaw),
            GIMBAL_SIGMA,
            HeadingSource::Gimbal,
            format!("Heading from the gimbal's yaw of {yaw} degrees."),
        );
    }
    let Some(written) = exif.image_direction else {
        return heading(0.0, UNKNOWN_HEADING_SIGMA, HeadingSource::Assumed, "Heading not known, assumed 0.".into());
    };
    if !exif.direction_is_magnetic {
        let words = format!("Heading from the photo's true direction of {written} degrees.");
        return heading(beside(written), COMPASS_SIGMA, HeadingSource::ExifTrue, words);
    }
    let year = exif.date.and_then(|(y, m, d)| magnetic::decimal_year(y, m, d)).unwrap_or(year);
    let at = Geodetic { latitude: anchor.latitude, longitude: anchor.longitude, height: 0.0 };
    let field = magnetic::field(at, year);
    let mut sigma = COMPASS_SIGMA.hypot(field.sigma);
    if field.out_of_date {
        // Declination drifts by a fifth of a degree a year in most places.
        let years = (2025.0 - year).max(year - 2030.0);
        sigma = sigma.hypot(0.2 * years);
        warnings.push(format!("the photo is of {year:.1}; the magnetic model holds for 2025 to 2030"));
    }
    if field.horizontal < 2000.0 {
        sigma = UNKNOWN_HEADING_SIGMA;
        warnings.push("the photo's magnetic direction means nothing so near the magnetic pole; give --heading".into());
    }
    let words = format!(
        "Heading from the photo's magnetic direction of {written} degrees and a declination of {:.2} degrees (WMM2025).",
        field.declination
    );
    heading(beside(written + field.declination), sigma, HeadingSource::ExifMagnetic, words)
}

/// Moves every vertex and Gaussian by the ground's deviation from `level` below it, the less the higher it is.
fn conform(
    dem: &mut Dem<BufReader<File>>,
    placement: &Placement,
    level: f64,
    to_metres: &ToMetres,
    done: &mut Reconstruction,
) -> Result<()> {
    let top = done.model.levels.first().map_or(0.0, |l| to_metres.point(l.mesh.bounds().1)[2]).max(1e-6);
    let meshes = done.model.levels.iter_mut().flat_map(|l| l.mesh.positions.iter_mut());
    for p in meshes.chain(done.gaussians.positions.iter_mut()) {
        let [x, y, z] = to_metres.point(*p);
        let below = placement.to_geodetic([x, y, 0.0]);
        let ground = dem.ground(below.latitude, below.longitude)?.ellipsoidal;
        let share = (1.0 - z / top).clamp(0.0, 1.0);
        p.z += ((ground - level) * share) as f32 / to_metres.scale;
    }
    Ok(())
}

#[cfg(test)]
mod tests;
