//! How many metres a unit of the reconstruction is.

use crate::{Error, Result};

/// A dimension the operator knows.
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
    /// Side of the square crop, pixels of the photo.
    pub crop_side: f32,
    pub photo_width: u32,
    pub photo_height: u32,
    /// Distance and field of view (radians) of the canonical camera that sees exactly the crop, units.
    pub canonical_distance: f32,
    pub canonical_fov: f32,
    /// From EXIF.
    pub focal_35mm: Option<f64>,
}

/// Extents of the reconstruction in its own units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extents {
    pub height: f64,
    pub length: f64,
    pub width: f64,
    /// Height of the frame's centre above the ground contact.
    pub centre_above_ground: f64,
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
}

impl ScaleSource {
    pub fn label(self) -> &'static str {
        match self {
            ScaleSource::KnownHeight => "known-height",
            ScaleSource::KnownLength => "known-length",
            ScaleSource::KnownWidth => "known-width",
            ScaleSource::CameraHeightExifFocal => "camera-height-exif-focal",
            ScaleSource::CameraHeightAssumedFocal => "camera-height-assumed-focal",
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    pub metres_per_unit: f64,
    pub source: ScaleSource,
}

/// Of a phone's main camera, where EXIF is silent.
pub const ASSUMED_FOCAL_35MM: f64 = 28.0;
/// Diagonal of a 36 × 24 mm frame.
const DIAGONAL_35MM: f64 = 43.266_615;

/// A known dimension decides; else the camera stands `camera_height` metres over the ground plane:
/// D = d·2·tan(fov/2)·f/s (distance at which the subject fills the crop with the photo's focal length f in pixels),
/// metres a unit = camera height / (D·sin(elevation) + centre above ground).
pub fn metres_per_unit(known: Option<Known>, extents: &Extents, view: &View, camera_height: f64) -> Result<Scale> {
    let ratio = |metres: f64, units: f64, source: ScaleSource, name: &str| {
        if units < 1e-6 {
            return Err(Error::usage(name)
                .found("the reconstruction has no extent in that direction")
                .advice("Give another dimension of the subject."));
        }
        Ok(Scale { metres_per_unit: metres / units, source })
    };
    match known {
        Some(Known::Height(m)) => return ratio(m, extents.height, ScaleSource::KnownHeight, "--height"),
        Some(Known::Length(m)) => return ratio(m, extents.length, ScaleSource::KnownLength, "--length"),
        Some(Known::Width(m)) => return ratio(m, extents.width, ScaleSource::KnownWidth, "--width"),
        None => {}
    }
    let (focal_35mm, source) = match view.focal_35mm {
        Some(f) => (f, ScaleSource::CameraHeightExifFocal),
        None => (ASSUMED_FOCAL_35MM, ScaleSource::CameraHeightAssumedFocal),
    };
    let focal = focal_35mm * f64::from(view.photo_width).hypot(f64::from(view.photo_height)) / DIAGONAL_35MM;
    let spread = 2.0 * f64::from(view.canonical_fov / 2.0).tan();
    let distance = f64::from(view.canonical_distance) * spread * focal / f64::from(view.crop_side);
    let units = distance * f64::from(view.elevation).sin() + extents.centre_above_ground;
    // Below a tenth of a unit the camera would lie on the ground: the elevation is not believable.
    if units < 0.1 {
        return Err(Error::usage("scale")
            .expected("a camera above the ground")
            .found(format!("an estimated elevation of {:.1}°", view.elevation.to_degrees()))
            .advice("The photo seems to look up at the subject: give --height, --length or --width in metres."));
    }
    Ok(Scale { metres_per_unit: camera_height / units, source })
}

impl Extents {
    /// Of points in the unit frame (Z up). The footprint's rectangle is the one of smallest area.
    pub fn of(points: impl Iterator<Item = [f64; 3]>) -> Option<Self> {
        let (mut low, mut high, mut flat) = (f64::INFINITY, f64::NEG_INFINITY, Vec::new());
        for [x, y, z] in points {
            low = low.min(z);
            high = high.max(z);
            flat.push([x, y]);
        }
        let hull = convex_hull(flat);
        if hull.is_empty() {
            return None;
        }
        let (length, width) = smallest_rectangle(&hull);
        Some(Extents { height: high - low, length, width, centre_above_ground: -low })
    }
}

/// Andrew's monotone chain, counter-clockwise.
fn convex_hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let turn = |o: [f64; 2], a: [f64; 2], b: [f64; 2]| (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    let mut hull: Vec<[f64; 2]> = Vec::new();
    for pass in 0..2 {
        let base = hull.len();
        let step = |hull: &mut Vec<[f64; 2]>, p: [f64; 2]| {
            while hull.len() >= base + 2 && turn(hull[hull.len() - 2], hull[hull.len() - 1], p) <= 0.0 {
                hull.pop();
            }
            hull.push(p);
        };
        if pass == 0 {
            points.iter().for_each(|&p| step(&mut hull, p));
        } else {
            points.iter().rev().for_each(|&p| step(&mut hull, p));
        }
        hull.pop();
    }
    hull
}

/// The smallest enclosing rectangle has a side along a hull edge (Freeman and Shapira 1975): (longer, shorter).
fn smallest_rectangle(hull: &[[f64; 2]]) -> (f64, f64) {
    let extent = |ux: f64, uy: f64| {
        let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
        for p in hull {
            let d = p[0] * ux + p[1] * uy;
            lo = lo.min(d);
            hi = hi.max(d);
        }
        hi - lo
    };
    let mut best = (f64::INFINITY, 0.0, 0.0);
    for i in 0..hull.len() {
        let (a, b) = (hull[i], hull[(i + 1) % hull.len()]);
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let l = dx.hypot(dy);
        let (ux, uy) = if l > 0.0 { (dx / l, dy / l) } else { (1.0, 0.0) };
        let (along, across) = (extent(ux, uy), extent(-uy, ux));
        if along * across < best.0 {
            best = (along * across, along.max(across), along.min(across));
        }
    }
    (best.1, best.2)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turned_box(degrees: f64) -> Vec<[f64; 3]> {
        let (s, c) = degrees.to_radians().sin_cos();
        let mut v = Vec::new();
        for x in [-1.0, 1.0] {
            for y in [-0.4, 0.4] {
                for z in [-0.3, 0.5] {
                    v.push([x * c - y * s, x * s + y * c, z]);
                }
            }
        }
        v
    }

    #[test]
    fn extents_do_not_depend_on_heading() {
        for d in [0.0, 17.0, 45.0, 80.0, 133.0] {
            let e = Extents::of(turned_box(d).into_iter()).unwrap();
            assert!((e.length - 2.0).abs() < 1e-12 && (e.width - 0.8).abs() < 1e-12 && (e.height - 0.8).abs() < 1e-12);
            assert!((e.centre_above_ground - 0.3).abs() < 1e-12);
        }
        assert!(Extents::of(std::iter::empty()).is_none());
    }

    fn view(elevation_deg: f32) -> View {
        View {
            elevation: elevation_deg.to_radians(),
            crop_side: 400.0,
            photo_width: 512,
            photo_height: 512,
            canonical_distance: 3.9,
            canonical_fov: 30f32.to_radians(),
            focal_35mm: Some(50.0),
        }
    }

    #[test]
    fn a_known_dimension_decides() {
        let e = Extents { height: 0.8, length: 2.0, width: 0.8, centre_above_ground: 0.3 };
        let s = metres_per_unit(Some(Known::Length(4.6)), &e, &view(10.0), 1.6).unwrap();
        assert_eq!((s.metres_per_unit, s.source), (2.3, ScaleSource::KnownLength));
    }

    /// A camera built from the formula's own geometry, seen from 3 m up, gives its scale back.
    #[test]
    fn camera_height_gives_the_scale_of_a_known_scene() {
        let (metres_a_unit, elevation) = (2.0f64, 15f64.to_radians());
        let v = view(15.0);
        let focal = 50.0 * 512f64.hypot(512.0) / DIAGONAL_35MM;
        let distance = 3.9 * 2.0 * 15f64.to_radians().tan() * focal / 400.0;
        let e = Extents { height: 0.8, length: 2.0, width: 0.8, centre_above_ground: 0.35 };
        let height = metres_a_unit * (distance * elevation.sin() + 0.35);
        let s = metres_per_unit(None, &e, &v, height).unwrap();
        assert!((s.metres_per_unit - metres_a_unit).abs() < 1e-6);
        assert_eq!(s.source, ScaleSource::CameraHeightExifFocal);
        assert!(metres_per_unit(None, &e, &view(-30.0), 1.6).is_err());
    }
}
