//! COLMAP's sparse models (Schönberger and Frahm 2016), as text and as binary: `cameras`, `images` and `points3D`, each
//! `.bin` or `.txt`, the binary one where both are there.
//!
//! COLMAP's world has no up of its own. Image points are in pixels, the first pixel's centre at (0.5, 0.5), as here.

mod binary;
mod lens;
mod text;
mod write;

use std::collections::BTreeMap;
use std::path::Path;

use glam::{DQuat, DVec3, Mat3};

use crate::{Error, Result};

pub use lens::Lens;
pub use write::text as written;

/// A sparse model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    pub cameras: BTreeMap<u32, Camera>,
    /// By name.
    pub images: Vec<Image>,
    pub points: Vec<Point>,
}

/// A camera's inside.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    pub lens: Lens,
    pub width: u32,
    pub height: u32,
    /// As many as [`Lens::parameters`] names, in that order; focal lengths and centres in pixels.
    pub parameters: Vec<f64>,
}

/// A posed picture: p_camera = rotation · p_world + translation, OpenCV axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    pub id: u32,
    pub rotation: DQuat,
    pub translation: DVec3,
    pub camera: u32,
    /// Its path relative to the folder of pictures.
    pub name: String,
    /// Where it shows something, in pixels, and which point that is.
    pub observations: Vec<([f64; 2], Option<u64>)>,
}

/// A triangulated point.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub id: u64,
    pub position: DVec3,
    pub color: [u8; 3],
    /// Mean reprojection error, pixels; negative where it is not known.
    pub error: f64,
    /// Image id and index of its observation there.
    pub track: Vec<(u32, u32)>,
}

/// Reads the model of a folder such as `sparse/0`.
///
/// # Errors
/// Usage, naming the file and the line or byte, for a missing or broken file, and for an image whose camera is missing.
pub fn read(folder: &Path) -> Result<Model> {
    let file = |stem: &str| -> Result<(String, Vec<u8>, bool)> {
        for (ending, binary) in [("bin", true), ("txt", false)] {
            let path = folder.join(format!("{stem}.{ending}"));
            match std::fs::read(&path) {
                Ok(bytes) => return Ok((path.display().to_string(), bytes, binary)),
                Err(e) if e.kind() == std::io::ErrorKind::NotFound => {}
                Err(e) => return Err(Error::io(&path, &e)),
            }
        }
        Err(Error::usage(folder.display().to_string())
            .expected(format!("{stem}.bin or {stem}.txt of COLMAP"))
            .found("neither")
            .advice("Name the folder of one model, such as sparse/0."))
    };
    let (name, bytes, is_binary) = file("cameras")?;
    let cameras = if is_binary { binary::cameras(&name, &bytes) } else { text::cameras(&name, &bytes) }?;
    let (name, bytes, is_binary) = file("images")?;
    let mut images = if is_binary { binary::images(&name, &bytes) } else { text::images(&name, &bytes) }?;
    if let Some(lost) = images.iter().find(|i| !cameras.contains_key(&i.camera)) {
        return Err(Error::usage(name)
            .expected(format!("cameras that are listed, for {}", lost.name))
            .found(format!("camera {}", lost.camera)));
    }
    images.sort_by(|a, b| a.name.cmp(&b.name));
    let (name, bytes, is_binary) = file("points3D")?;
    let points = if is_binary { binary::points(&name, &bytes) } else { text::points(&name, &bytes) }?;
    Ok(Model { cameras, images, points })
}

/// Whether the picture of this place in the list, sorted by name, is held back: every eighth, beginning with the first
/// (Barron et al. 2022; Kerbl et al. 2023).
pub fn is_test(index: usize) -> bool {
    index.is_multiple_of(8)
}

impl Image {
    /// This picture's camera without its distortion.
    pub fn pinhole(&self, camera: &Camera) -> crate::splat::Camera {
        camera.posed(self.rotation, self.translation)
    }
}

impl Camera {
    /// Without its distortion, at a pose: world→camera.
    pub fn posed(&self, rotation: DQuat, translation: DVec3) -> crate::splat::Camera {
        let [fx, fy, cx, cy] = self.pinhole().map(|v| v as f32);
        crate::splat::Camera {
            width: self.width,
            height: self.height,
            fx,
            fy,
            cx,
            cy,
            rotation: Mat3::from_quat(rotation.as_quat()),
            translation: translation.as_vec3(),
        }
    }

    /// Focal lengths and centre, pixels.
    pub fn pinhole(&self) -> [f64; 4] {
        let p = &self.parameters;
        if self.lens.has_one_focal_length() { [p[0], p[0], p[1], p[2]] } else { [p[0], p[1], p[2], p[3]] }
    }

    /// Where a point in front of the camera (x/z, y/z) falls, pixels.
    pub fn project(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let [fx, fy, cx, cy] = self.pinhole();
        let [x, y] = self.lens.distort(&self.parameters, [u, v]);
        [fx * x + cx, fy * y + cy]
    }

    /// The ray through a pixel: (x/z, y/z, 1). The inverse of [`Camera::project`], by steps towards it.
    pub fn ray(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let [fx, fy, cx, cy] = self.pinhole();
        let (mut u, mut v) = ((x - cx) / fx, (y - cy) / fy);
        for _ in 0..100 {
            let seen = self.project([u, v]);
            let (du, dv) = ((x - seen[0]) / fx, (y - seen[1]) / fy);
            (u, v) = (u + du, v + dv);
            if du.hypot(dv) < 1e-12 {
                break;
            }
        }
        [u, v, 1.0]
    }

    /// The picture that the same camera would take without its distortion; black where the given one shows nothing.
    pub fn undistorted(&self, picture: &image::RgbImage) -> image::RgbImage {
        if self.lens.is_pinhole() {
            return picture.clone();
        }
        let [fx, fy, cx, cy] = self.pinhole();
        // Pictures may be smaller than what was reconstructed, as those of Mip-NeRF 360 are.
        let (w, h) = picture.dimensions();
        let scale = [f64::from(w) / f64::from(self.width), f64::from(h) / f64::from(self.height)];
        image::RgbImage::from_fn(w, h, |x, y| {
            let u = [(f64::from(x) + 0.5) / scale[0], (f64::from(y) + 0.5) / scale[1]];
            let at = self.project([(u[0] - cx) / fx, (u[1] - cy) / fy]);
            bilinear(picture, [at[0] * scale[0] - 0.5, at[1] * scale[1] - 0.5])
        })
    }
}

fn bilinear(picture: &image::RgbImage, [x, y]: [f64; 2]) -> image::Rgb<u8> {
    let (w, h) = (f64::from(picture.width()), f64::from(picture.height()));
    if !(x > -0.5 && y > -0.5 && x < w - 0.5 && y < h - 0.5) {
        return image::Rgb([0; 3]);
    }
    let (x, y) = (x.clamp(0.0, w - 1.0), y.clamp(0.0, h - 1.0));
    let (left, top) = (x as u32, y as u32);
    let (right, bottom) = ((left + 1).min(picture.width() - 1), (top + 1).min(picture.height() - 1));
    let (u, v) = (x - f64::from(left), y - f64::from(top));
    image::Rgb(std::array::from_fn(|k| {
        let at = |x, y| f64::from(picture.get_pixel(x, y).0[k]);
        let row = |y| at(left, y) * (1.0 - u) + at(right, y) * u;
        (row(top) * (1.0 - v) + row(bottom) * v + 0.5) as u8
    }))
}

/// What both readers check alike.
fn camera(at: &str, model: Lens, width: u64, height: u64, parameters: Vec<f64>) -> Result<Camera> {
    let wrong = |expected: &str, found: String| Err(Error::usage(at).expected(expected).found(found));
    let side = |v: u64| u32::try_from(v).ok().filter(|v| (1..=65_535).contains(v));
    let (Some(width), Some(height)) = (side(width), side(height)) else {
        return wrong("width and height from 1 to 65535", format!("{width} × {height}"));
    };
    let focal = if model.has_one_focal_length() { 1 } else { 2 };
    if parameters.iter().any(|p| !p.is_finite()) || parameters[..focal].iter().any(|f| *f <= 0.0) {
        return wrong("finite parameters, focal lengths above 0", format!("{parameters:?}"));
    }
    Ok(Camera { lens: model, width, height, parameters })
}

fn pose(at: &str, q: [f64; 4], t: [f64; 3]) -> Result<(DQuat, DVec3)> {
    let rotation = DQuat::from_xyzw(q[1], q[2], q[3], q[0]);
    if !(q.iter().chain(&t).all(|v| v.is_finite()) && (rotation.length() - 1.0).abs() < 0.01) {
        return Err(Error::usage(at)
            .expected("a unit quaternion (w, x, y, z) and a translation")
            .found(format!("{q:?} and {t:?}")));
    }
    Ok((rotation.normalize(), DVec3::from_array(t)))
}

#[cfg(test)]
mod tests;
