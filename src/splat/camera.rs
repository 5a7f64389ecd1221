//! Pinhole camera, OpenCV axes.

use glam::{Mat3, Vec3};

/// x right, y down, z forward; pixel centres at +0.5; p_camera = rotation · p_world + translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pub width: u32,
    pub height: u32,
    pub fx: f32,
    pub fy: f32,
    pub cx: f32,
    pub cy: f32,
    pub rotation: Mat3,
    pub translation: Vec3,
}

impl Camera {
    /// The eye in world coordinates.
    pub fn position(&self) -> Vec3 {
        -(self.rotation.transpose() * self.translation)
    }

    /// A square camera at `eye` looking at `target`, world Z up, `fov` (radians) across `size` pixels.
    pub fn look_at(eye: Vec3, target: Vec3, fov: f32, size: u32) -> Self {
        let forward = (target - eye).normalize();
        let up = if forward.cross(Vec3::Z).length_squared() < 1e-8 { Vec3::Y } else { Vec3::Z };
        let right = forward.cross(up).normalize();
        let down = forward.cross(right);
        let rotation = Mat3::from_cols(right, down, forward).transpose();
        let focal = size as f32 / 2.0 / (fov / 2.0).tan();
        Camera {
            width: size,
            height: size,
            fx: focal,
            fy: focal,
            cx: size as f32 / 2.0,
            cy: size as f32 / 2.0,
            rotation,
            translation: -(rotation * eye),
        }
    }

    /// The same view with `size` pixels across a square picture.
    pub fn resized(&self, width: u32, height: u32) -> Self {
        let (sx, sy) = (width as f32 / self.width as f32, height as f32 / self.height as f32);
        Camera { width, height, fx: self.fx * sx, fy: self.fy * sy, cx: self.cx * sx, cy: self.cy * sy, ..*self }
    }
}
