//! Camera rigs around a subject in its unit frame: right-handed, Z up, +Y where the photo's camera pointed.
//!
//! An azimuth is relative to the photo (0: the photo's own side) and grows as the camera walks to its own right,
//! counter-clockwise seen from above, as Zero123++ and InstantMesh count it. At azimuth 90° the camera stands on +X.

mod consistency;
pub mod hull;
pub mod pose;
pub mod tile;

use crate::splat::Camera;
use glam::Vec3;

/// Of the six views and the rigs like them, radians.
pub const FOV: f32 = std::f32::consts::PI / 6.0;
/// Eye to origin in bounding-sphere radii: the sphere just fits the 30° frame (4 · tan 15° = 1.07).
pub const DISTANCE: f32 = 4.0;
/// Degrees relative to the photo: the paper's Eq. 2, θᵢ = 30° + 60° i.
pub const SIX_AZIMUTHS: [f32; 6] = [30.0, 90.0, 150.0, 210.0, 270.0, 330.0];
/// Degrees above the horizon, absolute: the paper's Eq. 3.
pub const SIX_ELEVATIONS: [f32; 6] = [20.0, -10.0, 20.0, -10.0, 20.0, -10.0];

/// Where a camera stands: degrees relative to the photo and above the horizon.
pub fn eye(azimuth: f32, elevation: f32, distance: f32) -> Vec3 {
    let (a, e) = (azimuth.to_radians(), elevation.to_radians());
    distance * Vec3::new(e.cos() * a.sin(), -e.cos() * a.cos(), e.sin())
}

/// A square camera at azimuth and elevation (degrees) that looks at the origin.
pub fn orbit(azimuth: f32, elevation: f32, distance: f32, size: u32) -> Camera {
    Camera::look_at(eye(azimuth, elevation, distance), Vec3::ZERO, FOV, size)
}

/// Square cameras that look at the middle of `points` from azimuths and elevations (degrees), all from as far and with one
/// focal length: the longest under which every picture holds every point, a fortieth of its side left free.
pub fn framed(points: &[Vec3], from: &[[f32; 2]], size: u32) -> Vec<Camera> {
    let low = points.iter().copied().reduce(Vec3::min).unwrap_or_default();
    let high = points.iter().copied().reduce(Vec3::max).unwrap_or_default();
    let middle = (low + high) / 2.0;
    let distance = DISTANCE * ((high - low).length() / 2.0).max(1e-3);
    let look = |[azimuth, elevation]: &[f32; 2]| {
        Camera::look_at(middle + eye(*azimuth, *elevation, distance), middle, FOV, size)
    };
    let mut all: Vec<Camera> = from.iter().map(look).collect();
    let off_axis = |camera: &Camera, p: &Vec3| {
        let q = camera.rotation * *p + camera.translation;
        q.x.abs().max(q.y.abs()) / q.z
    };
    let widest = all.iter().flat_map(|c| points.iter().map(|p| off_axis(c, p))).fold(1e-3, f32::max);
    for camera in &mut all {
        camera.fx = 0.475 * size as f32 / widest;
        camera.fy = camera.fx;
    }
    all
}

/// The paper's six views.
pub fn six_views(size: u32) -> [Camera; 6] {
    std::array::from_fn(|i| orbit(SIX_AZIMUTHS[i], SIX_ELEVATIONS[i], DISTANCE, size))
}

/// Views that training never sees: midway between the six, higher and lower than they are.
pub fn held_back(size: u32) -> [Camera; 6] {
    const ELEVATIONS: [f32; 6] = [5.0, 35.0, 5.0, 35.0, 5.0, 35.0];
    std::array::from_fn(|i| orbit(60.0 * i as f32, ELEVATIONS[i], DISTANCE, size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn azimuth_zero_is_the_photo_and_ninety_its_right() {
        let front = orbit(0.0, 0.0, 4.0, 100);
        assert!((front.position() - Vec3::new(0.0, -4.0, 0.0)).length() < 1e-5);
        assert!((front.rotation.row(2) - Vec3::Y).length() < 1e-6 && (front.rotation.row(0) - Vec3::X).length() < 1e-6);
        let side = orbit(90.0, 0.0, 4.0, 100);
        assert!((side.position() - Vec3::new(4.0, 0.0, 0.0)).length() < 1e-5);
        // A step to the camera's own right.
        let step = orbit(1.0, 0.0, 4.0, 100).position() - front.position();
        assert!(step.dot(front.rotation.row(0)) > 0.0);
    }

    #[test]
    fn six_views_stand_at_the_papers_poses() {
        for (i, camera) in six_views(320).iter().enumerate() {
            let p = camera.position();
            let azimuth = p.x.atan2(-p.y).to_degrees().rem_euclid(360.0);
            let elevation = (p.z / p.length()).asin().to_degrees();
            assert!((azimuth - (30 + 60 * i) as f32).abs() < 1e-3, "{azimuth}");
            assert!((elevation - if i % 2 == 0 { 20.0 } else { -10.0 }).abs() < 1e-3, "{elevation}");
            assert!((p.length() - 4.0).abs() < 1e-5 && (camera.fx - 160.0 / 15f32.to_radians().tan()).abs() < 1e-2);
        }
    }

    #[test]
    fn every_rig_looks_at_the_origin_upright() {
        let rigs = [six_views(64), held_back(64)];
        for camera in rigs.iter().flatten() {
            let centre = camera.translation;
            assert!(centre.x.abs() < 1e-5 && centre.y.abs() < 1e-5 && (centre.z - 4.0).abs() < 1e-4);
            assert!(camera.rotation.row(0).z.abs() < 1e-5, "no roll");
            assert!(camera.rotation.row(1).z < 1e-6, "down is down");
            assert!((camera.rotation.determinant() - 1.0).abs() < 1e-5);
        }
    }

    #[test]
    fn framed_cameras_hold_every_point_and_fill_one_picture() {
        let points = [Vec3::new(0.2, 0.1, 0.0), Vec3::new(1.0, 0.3, 0.1), Vec3::new(0.4, -0.2, 2.0)];
        let cameras = framed(&points, &[[0.0, 15.0], [130.0, -60.0], [0.0, 89.0]], 100);
        let mut furthest = 0f32;
        for (camera, p) in cameras.iter().flat_map(|c| points.iter().map(move |p| (c, *p))) {
            let q = camera.rotation * p + camera.translation;
            let (x, y) = (camera.fx * q.x / q.z, camera.fy * q.y / q.z);
            furthest = furthest.max(x.abs()).max(y.abs());
        }
        assert!((furthest - 47.5).abs() < 1e-3, "{furthest}");
        assert_eq!(framed(&[], &[[0.0, 0.0]], 8).len(), 1);
    }

    #[test]
    fn held_back_views_are_no_training_views() {
        for held in held_back(64) {
            for used in six_views(64) {
                assert!(held.position().angle_between(used.position()).to_degrees() > 20.0);
            }
        }
    }
}
