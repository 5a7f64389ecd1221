//! Pixels and rays of a camera without distortion.

use glam::{DVec2, DVec3};

/// What a pinhole camera makes of rays: pixel = focal · (x, y) / z + middle. Camera axes are right, down, forward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinhole {
    /// Pixels, across and down.
    pub focal: DVec2,
    /// Where the optical axis meets the picture, pixels from its upper left corner.
    pub middle: DVec2,
}

impl Pinhole {
    /// Of one focal length in pixels, the axis in the picture's middle.
    pub fn centred(focal: f64, (width, height): (u32, u32)) -> Pinhole {
        Pinhole { focal: DVec2::splat(focal), middle: DVec2::new(f64::from(width), f64::from(height)) / 2.0 }
    }

    /// To what a pixel shows, one unit forward.
    pub fn ray(&self, pixel: DVec2) -> DVec3 {
        ((pixel - self.middle) / self.focal).extend(1.0)
    }

    /// Where a ray meets the picture. `None` behind the camera, or beside it by more than 80°.
    pub fn pixel(&self, ray: DVec3) -> Option<DVec2> {
        (ray.z > 0.17 * ray.length()).then(|| self.focal * ray.truncate() / ray.z + self.middle)
    }
}
