//! From the camera's place to the subject's: direction, elevation, distance.

use glam::{DVec2, DVec3};

use super::{Enu, Extents, Geodetic, Scale, Uncertainty, View};
use crate::photo::down;

/// How the camera stood to the subject, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// Over the ground, camera to the subject's middle.
    pub across: f64,
    pub across_sigma: f64,
    /// Camera above the ground under the subject.
    pub above: f64,
    pub above_sigma: f64,
}

/// From the scale and the view that it was measured in.
pub fn stand(view: &View, extents: &Extents, scale: &Scale) -> Stand {
    let (sin, cos) = f64::from(view.elevation).sin_cos();
    let slant = view.distance() * scale.metres_per_unit;
    let standing = if scale.source.by_camera_height() { view.standing_above_ground(extents) } else { None };
    let above = standing.map_or(view.camera_above_ground(extents), |s| s.median) * scale.metres_per_unit;
    let (_, focal, _) = view.focal();
    // A known camera height fixes `above`, a known dimension does not: the larger of both is said.
    Stand {
        across: slant * cos,
        across_sigma: slant * (cos * scale.sigma.hypot(focal)).hypot(sin * view.elevation_sigma),
        above,
        above_sigma: (above * scale.sigma).hypot(slant * cos * view.elevation_sigma).min(above.abs().max(slant)),
    }
}

/// The bearing of the subject frame's +Y, degrees: that of the optical axis and the angle by which the camera that the subject was seen
/// with was turned aside of it, seen from above. `right`: of that camera; `down`: where down is; both in the axes of the photo's camera
/// (right, down, forward). By its right, since a camera may look straight down.
pub fn bearing_of_subject(axis: f64, right: DVec3, down: DVec3) -> f64 {
    (axis + down::bearing(down, right).to_degrees() - 90.0).rem_euclid(360.0)
}

/// Of a gimbal's pitch, degrees.
pub const PITCH_SIGMA: f64 = 1.5;
/// Of what a phone's accelerometer says in a hand, degrees.
pub const PHONE_PITCH_SIGMA: f64 = 2.0;
/// Of a pitch that somebody says, degrees.
pub const GIVEN_PITCH_SIGMA: f64 = 3.0;

/// The camera's elevation over the subject, radians, from the pitch of the optical axis (degrees above the horizon) and what of the
/// photo is in the crop's middle, pixels.
pub fn elevation_by_pitch(pitch: f64, middle: DVec2, view: &View) -> f64 {
    down::elevation(down::by_pitch(pitch.to_radians()), view.pinhole().ray(middle))
}

/// The ground point under a subject that the camera sees along `bearing` (degrees from true north).
pub fn subject_point(camera: Geodetic, bearing: f64, stand: &Stand) -> Geodetic {
    let (sin, cos) = bearing.to_radians().sin_cos();
    camera.offset(Enu { east: stand.across * sin, north: stand.across * cos, up: -stand.above })
}

/// Of that point: the camera's own deviation, the distance's along the line, the bearing's across it (the larger of the
/// two); vertically the camera's and its height's.
pub fn subject_uncertainty(camera: Uncertainty, stand: &Stand) -> Uncertainty {
    // A bearing that is not known at all puts the subject anywhere on the circle, not further.
    let turned = stand.across * camera.heading.to_radians().min(std::f64::consts::SQRT_2);
    Uncertainty {
        horizontal: camera.horizontal.hypot(turned.max(stand.across_sigma)),
        vertical: camera.vertical.hypot(stand.above_sigma),
        ..camera
    }
}

#[cfg(test)]
mod tests {
    use super::super::scale::{ASSUMED_CAMERA_HEIGHT, By, Hints, Measured, metres_per_unit};
    use super::*;

    fn view() -> View {
        View {
            elevation: 20f32.to_radians(),
            elevation_sigma: 0.02,
            crop_side: 400.0,
            photo_width: 4000,
            photo_height: 3000,
            canonical_distance: 3.9,
            canonical_fov: 30f32.to_radians(),
            focal_35mm: Some(28.0),
            focal_given: false,
            posed_focal: None,
        }
    }

    #[test]
    fn the_subject_lies_where_the_camera_looks() {
        let extents = Extents { height: 1.0, length: 1.0, width: 1.0, centre_above_ground: 0.5 };
        let hints = Hints {
            known: vec![],
            camera_height: ASSUMED_CAMERA_HEIGHT,
            distance: Some(Measured { metres: 50.0, sigma: 0.5, by: By::Operator }),
            front: None,
            registered: None,
        };
        let scale = metres_per_unit(&hints, &extents, &view()).unwrap();
        let s = stand(&view(), &extents, &scale);
        assert!((s.across - 50.0 * 20f64.to_radians().cos()).abs() < 1e-4, "{s:?}");
        assert!((s.above - 50.0 * 20f64.to_radians().sin() - 0.5 * scale.metres_per_unit).abs() < 1e-4);
        let camera = Geodetic { latitude: 34.5523, longitude: -118.4712, height: 800.0 };
        for bearing in [0.0, 90.0, 200.0] {
            let at = subject_point(camera, bearing, &s);
            let from = camera.local(at.to_ecef());
            let off = super::super::normalised_longitude(from.east.atan2(from.north).to_degrees() - bearing);
            assert!(off.abs() < 1e-6);
            assert!((from.east.hypot(from.north) - s.across).abs() < 1e-6 && (from.up + s.above).abs() < 1e-6);
        }
        let u = subject_uncertainty(Uncertainty { horizontal: 5.0, vertical: 8.0, heading: 5.0, scale: 0.0 }, &s);
        assert!(u.horizontal > 6.4 && u.horizontal < 6.7 && u.vertical > 8.0, "{u:?}");
    }

    #[test]
    fn a_subject_beside_the_axis() {
        let v = View { elevation: 0.0, ..view() };
        let f = v.focal().0;
        let at = |across: f64, below: f64| DVec2::new(2000.0 + across, 1500.0 + below);
        // A camera that looks at it and is level, so that its right is: across the way down and the way there.
        let bears = |axis: f64, middle: DVec2, v: &View| {
            let ray = v.pinhole().ray(middle);
            let down = down::by_elevation(f64::from(v.elevation), ray);
            bearing_of_subject(axis, down.cross(ray).normalize(), down)
        };
        assert!((bears(350.0, at(f, 0.0), &v) - 35.0).abs() < 1e-9);
        assert!((bears(10.0, at(-f, 0.0), &v) - 325.0).abs() < 1e-9);
        assert!((elevation_by_pitch(-30.0, at(0.0, 0.0), &v).to_degrees() - 30.0).abs() < 1e-9);
        assert!((elevation_by_pitch(-30.0, at(0.0, f), &v).to_degrees() - 75.0).abs() < 1e-9);
        // A camera that looks down by 60° and sees the subject a quarter of its focal length aside: twice as far on the ground, and
        // less far below.
        let aside = at(0.25 * f, 0.0);
        let elevation = elevation_by_pitch(-60.0, aside, &v);
        assert!((elevation.sin() - 60f64.to_radians().sin() / 1.0625f64.sqrt()).abs() < 1e-9);
        let v = View { elevation: elevation as f32, ..v };
        assert!((bears(0.0, aside, &v) - 0.5f64.atan().to_degrees()).abs() < 1e-4);
        // Straight down the picture's top bears where the axis is said to, and what is beside the middle turns nothing that was not turned.
        let v = View { elevation: 89f32.to_radians(), ..v };
        for (across, below) in [(0.0, 0.0), (0.03, 0.05), (-0.05, -0.06), (0.02, -0.08)] {
            let ray = v.pinhole().ray(at(across * f, below * f));
            let bearing = bearing_of_subject(90.0, DVec3::X, down::by_elevation(f64::from(v.elevation), ray));
            assert!((bearing - 90.0).abs() < 1.0, "{bearing}");
        }
    }
}
