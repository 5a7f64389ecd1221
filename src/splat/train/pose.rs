//! A camera's pose as something to be learnt: p' = exp(ω)·p + v on the left of world→camera.

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
