//! A camera's pose as something to be learnt: p' = exp(ω)·p + v on the left of world→camera.

use glam::{Mat3, Quat, Vec3};

use super::adam::{BETA1, BETA2};
use crate::splat::{Camera, Gaussians, render};

/// Adam's memory for one camera.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pose {
    moments: [[f32; 6]; 2],
    steps: i32,
}

impl Pose {
    /// One step against `gradient` (translation, rotation vector). `rate` is in radians; translations take `rate` times
    /// `distance`, so that both move the picture alike. A gradient that is not finite changes nothing.
    pub fn step(&mut self, camera: &mut Camera, gradient: [f32; 6], rate: f32, distance: f32) {
        if !gradient.iter().sum::<f32>().is_finite() {
            return;
        }
        self.steps += 1;
        let corrections = [1.0 - BETA1.powi(self.steps), 1.0 - BETA2.powi(self.steps)];
        let mut change = [0.0; 6];
        for (i, change) in change.iter_mut().enumerate() {
            let unit = if i < 3 { distance } else { 1.0 };
            let g = gradient[i] * unit;
            self.moments[0][i] = BETA1 * self.moments[0][i] + (1.0 - BETA1) * g;
            self.moments[1][i] = BETA2 * self.moments[1][i] + (1.0 - BETA2) * g * g;
            let size = (self.moments[1][i] / corrections[1]).sqrt() + 1e-15;
            *change = -rate * unit * self.moments[0][i] / corrections[0] / size;
        }
        *camera = moved(camera, change);
    }
}

/// The camera after a left-multiplied increment: translation, rotation vector.
pub fn moved(camera: &Camera, by: [f32; 6]) -> Camera {
    let turn = Mat3::from_quat(Quat::from_scaled_axis(Vec3::new(by[3], by[4], by[5])));
    // Through a quaternion and back: many small steps must not wear the rotation off orthonormal.
    let rotation = Mat3::from_quat(Quat::from_mat3(&(turn * camera.rotation)).normalize());
    Camera { rotation, translation: turn * camera.translation + Vec3::new(by[0], by[1], by[2]), ..*camera }
}

/// The camera of a crop: `camera` with focal length and principal point such that the silhouette of `g` has the centre
/// and the spread of the mask `alpha` (of the camera's size). A crop around a subject is no view of the canonical
/// camera, only a scaled and shifted part of it. Gives `camera` back when either silhouette is empty.
pub fn fit_crop(g: &Gaussians, camera: &Camera, alpha: &[f32]) -> Camera {
    let width = camera.width as usize;
    // Centre, spread in pixels.
    let moments = |alpha: &[f32]| -> Option<([f64; 2], f64)> {
        let (mut sum, mut x, mut y, mut square) = (0.0, 0.0, 0.0, 0.0);
        for (i, a) in alpha.iter().enumerate() {
            let (a, px, py) = (*a as f64, (i % width) as f64 + 0.5, (i / width) as f64 + 0.5);
            sum += a;
            x += a * px;
            y += a * py;
            square += a * (px * px + py * py);
        }
        let (cx, cy) = (x / sum, y / sum);
        let spread = (square / sum - cx * cx - cy * cy).sqrt();
        (sum > 1.0 && spread > 0.0).then_some(([cx, cy], spread))
    };
    let Some((center, spread)) = moments(alpha) else { return *camera };
    let mut fitted = *camera;
    // A silhouette that leaves the picture at first is measured too small: a few rounds settle it.
    for _ in 0..4 {
        let Some((c, s)) = moments(&render(g, &fitted, [0.0; 3]).alpha) else { return *camera };
        let zoom = (spread / s).clamp(0.5, 2.0);
        fitted.cx = (center[0] + (fitted.cx as f64 - c[0]) * zoom) as f32;
        fitted.cy = (center[1] + (fitted.cy as f64 - c[1]) * zoom) as f32;
        fitted.fx *= zoom as f32;
        fitted.fy *= zoom as f32;
    }
    fitted
}
