//! Where down is for a camera, as a unit vector in its axes (right, down, forward), and what follows for what lies on a ray.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;

/// Of a camera that is not rolled, its optical axis `pitch` radians above the horizon.
pub fn by_pitch(pitch: f64) -> DVec3 {
    DVec3::new(0.0, pitch.cos(), -pitch.sin())
}

/// Of a camera that is not rolled and looks down on what lies on `ray` by `elevation` radians; beside the axis there may be no such
/// camera, and then the nearest. None looks further down than straight down.
///
/// By sin(elevation) = (y cos q + sin q) / |ray|, q the optical axis' angle below the horizon.
pub fn by_elevation(elevation: f64, ray: DVec3) -> DVec3 {
    let y = ray.y / ray.z;
    let sine = elevation.sin() * ray.length() / ray.z / 1f64.hypot(y);
    by_pitch((y.atan() - sine.clamp(-1.0, 1.0).asin()).max(-FRAC_PI_2))
}

/// What lies along `v`, or is down, for a camera that is rolled by `roll` radians more: by so much the lower ends of plumb lines that the axis
/// meets lean further to the right.
pub fn rolled(v: DVec3, roll: f64) -> DVec3 {
    let (sin, cos) = roll.sin_cos();
    DVec3::new(cos * v.x + sin * v.y, cos * v.y - sin * v.x, v.z)
}

/// How far above what lies on `ray` the camera stands, radians above the horizon there.
pub fn elevation(down: DVec3, ray: DVec3) -> f64 {
    (down.dot(ray) / ray.length()).clamp(-1.0, 1.0).asin()
}

/// By how much what lies on `ray` bears to the right of the optical axis, radians, seen from above; of an axis straight down, to the right
/// of the picture's top.
pub fn bearing(down: DVec3, ray: DVec3) -> f64 {
    let level = |v: DVec3| v - v.dot(down) * down;
    let (axis, ray) = (level(DVec3::Z), level(ray));
    axis.cross(ray).dot(down).atan2(axis.dot(ray))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use glam::DMat3;

    /// East, north, up → right, down, forward of a camera by heading, pitch and roll, clockwise, degrees.
    pub(crate) fn camera(heading: f64, pitch: f64, roll: f64) -> DMat3 {
        let level = DMat3::from_cols(DVec3::X, DVec3::Z, -DVec3::Y);
        let [heading, pitch, roll] = [heading, pitch, roll].map(f64::to_radians);
        DMat3::from_rotation_z(-roll) * DMat3::from_rotation_x(-pitch) * DMat3::from_rotation_y(-heading) * level
    }

    #[test]
    fn what_lies_beside_the_axis_of_a_pitched_camera() {
        for (heading, pitch, roll) in [(0.0, 0.0, 0.0), (30.0, -40.0, 0.0), (200.0, 25.0, 0.0), (310.0, -70.0, 12.0)] {
            let camera = camera(heading, pitch, roll);
            let down = camera * -DVec3::Z;
            assert!((elevation(down, DVec3::Z).to_degrees() + pitch).abs() < 1e-9);
            for (bears, above) in [(0.0, 10.0), (20.0, 35.0), (-25.0, 60.0), (12.0, -15.0)] {
                let (sin, cos) = f64::to_radians(heading + bears).sin_cos();
                let below = f64::to_radians(above);
                let ray = camera * DVec3::new(sin * below.cos(), cos * below.cos(), -below.sin());
                assert!((elevation(down, ray).to_degrees() - above).abs() < 1e-9);
                assert!((bearing(down, ray).to_degrees() - bears).abs() < 1e-9, "{pitch} {bears}");
                // Who turns the camera clockwise sees plumb lines turn the other way.
                let lean = roll.to_radians();
                assert!((rolled(by_pitch(pitch.to_radians()), lean) - down).length() < 1e-9);
                if ray.z > 0.0 {
                    let level = by_elevation(below, 3.0 * rolled(ray, -lean));
                    assert!((rolled(level, lean) - down).length() < 1e-9, "{pitch} {above}");
                }
            }
        }
    }

    #[test]
    fn where_no_level_camera_looks_down_so_far_the_nearest_counts() {
        let ray = DVec3::new(0.5, 0.0, 1.0);
        assert!((by_elevation(1.5, ray) - DVec3::Z).length() < 1e-9);
    }
}
