//! A camera's pose as something to be learnt: p' = exp(ω)·(p − c) + c + v on the left of world→camera, with c before the camera.
//!
//! Seen from the eye, c = 0, a turn and a shift across move the picture nearly alike, and what tells them apart is lost in the step
//! that Adam takes for either. About what the camera looks at a turn moves the picture only where it is nearer or farther than that,
//! and a shift all of it: each has its own step (preconditioning, as Park et al. 2023 do it for whole cameras).

use glam::{Mat3, Quat, Vec3};

use super::adam::{BETA1, BETA2};
use crate::splat::Camera;

/// Adam's memory for one camera.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    moments: [[f32; 6]; 2],
    steps: i32,
}

impl Pose {
    /// As shaders/end.wgsl has it: first moments of translation (then the steps) and rotation, then second ones.
    pub fn words(&self) -> [f32; 16] {
        std::array::from_fn(|k| match (k / 4, k % 4) {
            (0, 3) => self.steps as f32,
            (_, 3) => 0.0,
            (row, k) => self.moments[row / 2][row % 2 * 3 + k],
        })
    }

    pub fn from_words(words: &[f32; 16]) -> Pose {
        let moments = std::array::from_fn(|m| std::array::from_fn(|k| words[8 * m + k / 3 * 4 + k % 3]));
        Pose { moments, steps: words[3] as i32 }
    }

    /// One step against `gradient` (translation, rotation vector about the eye). `rate` is in radians; translations take `rate` times
    /// the depth of the pivot, so that both move the picture alike; times the distance of the origin where the pivot is the eye. A
    /// gradient that is not finite changes nothing.
    pub fn step(&mut self, camera: &mut Camera, gradient: [f32; 6], rate: f32, pivot: f32) {
        if !gradient.iter().sum::<f32>().is_finite() {
            return;
        }
        let distance = if pivot > 0.0 { pivot } else { camera.translation.length() };
        // c × ∂L/∂v is what a turn about the eye has of the shift that it brings with it.
        let [vx, vy, ..] = gradient;
        let gradient = {
            let mut about = gradient;
            about[3] += pivot * vy;
            about[4] -= pivot * vx;
            about
        };
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
        *camera = moved(camera, change, pivot);
    }
}

/// The camera after a left-multiplied increment: translation, rotation vector about a point so far before it.
pub fn moved(camera: &Camera, by: [f32; 6], pivot: f32) -> Camera {
    let c = Vec3::new(0.0, 0.0, pivot);
    let turn = Mat3::from_quat(Quat::from_scaled_axis(Vec3::new(by[3], by[4], by[5])));
    // Through a quaternion and back: many small steps must not wear the rotation off orthonormal.
    let rotation = Mat3::from_quat(Quat::from_mat3(&(turn * camera.rotation)).normalize());
    Camera { rotation, translation: turn * (camera.translation - c) + c + Vec3::new(by[0], by[1], by[2]), ..*camera }
}
