//! What a browser may ask for: a camera around the subject and what it shows, each number within bounds.

use glam::Vec3;
use serde::Deserialize;

use crate::splat::Camera;
use crate::views;

/// Pixels of the largest picture: 4K.
const MOST_PIXELS: u32 = 3840 * 2160;
const SIDES: std::ops::RangeInclusive<u32> = 16..=3840;
/// Degrees up and down that a camera sees.
pub const FIELD: f32 = 40.0;
/// Straight up and down have no bearing: nearly there is near enough.
const STEEPEST: f32 = 89.9;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Show {
    #[default]
    Colour,
    Depth,
    Normals,
    /// Where the finest level's texture comes from.
    Provenance,
    /// How far the network expected the finest level's colours to be off.
    Error,
}

/// One picture. Angles in degrees, lengths in the scene's units; azimuth as in [`views::eye`].
#[derive(Clone, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Query {
    pub az: f32,
    pub el: f32,
    /// Eye to target.
    pub dist: f32,
    /// The target, from the middle of the subject.
    pub tx: f32,
    pub ty: f32,
    pub tz: f32,
    pub w: u32,
    pub h: u32,
    pub show: Show,
    /// 0: the Gaussians, where there are some; n: the n-th level of detail, the finest is 1.
    pub level: usize,
    pub grid: bool,
    /// On black instead of white.
    pub dark: bool,
    /// The camera rests: a picture to look at, not to steer by.
    pub rest: bool,
    /// The pixel that is pointed at.
    pub x: u32,
    pub y: u32,
}

impl Default for Query {
    fn default() -> Self {
        Query {
            az: 30.0,
            el: 20.0,
            dist: 0.0,
            tx: 0.0,
            ty: 0.0,
            tz: 0.0,
            w: 960,
            h: 540,
            show: Show::Colour,
            level: 0,
            grid: true,
            dark: false,
            rest: true,
            x: 0,
            y: 0,
        }
    }
}

/// From how far a ball of this radius fills the picture.
pub fn fitting(radius: f32, width: u32, height: u32) -> f32 {
    let up = (FIELD / 2.0).to_radians();
    let across = (up.tan() * width as f32 / height.max(1) as f32).atan();
    1.05 * radius / up.min(across).sin()
}

impl Query {
    /// The camera around a subject with this middle and radius.
    ///
    /// Errors: the first number that is out of bounds, in words.
    pub fn camera(&self, centre: Vec3, radius: f32) -> Result<Camera, String> {
        let (w, h) = (self.w, self.h);
        if !(SIDES.contains(&w) && SIDES.contains(&h) && w * h <= MOST_PIXELS) {
            return Err(format!("w, h: expected 16 to 3840 pixels a side and at most {MOST_PIXELS}, found {w} × {h}"));
        }
        let within = |name: &str, value: f32, most: f32| {
            let fits = value.is_finite() && value.abs() <= most;
            if fits { Ok(value) } else { Err(format!("{name}: expected at most {most} either way, found {value}")) }
        };
        let azimuth = within("az", self.az, 3600.0)?;
        let elevation = within("el", self.el, 90.0)?.clamp(-STEEPEST, STEEPEST);
        let far = 100.0 * radius;
        let target =
            centre + Vec3::new(within("tx", self.tx, far)?, within("ty", self.ty, far)?, within("tz", self.tz, far)?);
        let distance = match within("dist", self.dist, far)? {
            d if d > 0.0 => d.max(0.01 * radius),
            _ => fitting(radius, w, h),
        };
        let eye = target + views::eye(azimuth, elevation, distance);
        let square = Camera::look_at(eye, target, FIELD.to_radians(), h);
        Ok(Camera { width: w, cx: w as f32 / 2.0, ..square })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_whole_ball_is_in_the_picture() {
        let (centre, radius) = (Vec3::new(1.0, -2.0, 0.5), 3.0);
        for (w, h) in [(960, 540), (390, 700), (16, 3840)] {
            for (az, el) in [(0.0, 0.0), (123.0, 89.9), (300.0, -90.0)] {
                let camera = Query { az, el, w, h, ..Query::default() }.camera(centre, radius).unwrap();
                let middle = camera.rotation * centre + camera.translation;
                assert!(middle.truncate().length() < 1e-4, "the middle is in the middle");
                let distance = middle.z;
                // The half angle that the ball takes, and the half angles of the picture.
                let ball = (radius / distance).asin();
                let across = (w as f32 / 2.0 / camera.fx).atan();
                let up = (h as f32 / 2.0 / camera.fy).atan();
                assert!(ball < across.min(up), "{w} {h}: {ball} {across} {up}");
            }
        }
    }

    #[test]
    fn what_is_out_of_bounds_is_refused_by_name() {
        let bad = |q: Query| q.camera(Vec3::ZERO, 1.0).unwrap_err();
        let plain = Query::default();
        for (query, name) in [
            (Query { w: 0, ..plain.clone() }, "w, h"),
            (Query { h: 4000, ..plain.clone() }, "w, h"),
            (Query { w: 3840, h: 3840, ..plain.clone() }, "w, h"),
            (Query { az: f32::NAN, ..plain.clone() }, "az"),
            (Query { el: 91.0, ..plain.clone() }, "el"),
            (Query { dist: f32::INFINITY, ..plain.clone() }, "dist"),
            (Query { tz: 101.0, ..plain.clone() }, "tz"),
        ] {
            assert!(bad(query).starts_with(name));
        }
    }
}
