//! What of each photo is the subject: a piece of the photo, its mask, and the camera that took this piece.

use glam::{DQuat, DVec3, Mat3};

use super::Posed;
use crate::geo::similarity::Similarity;
use crate::models::scene::Subject;
use crate::photo::{Edge, Plane, Rect, sample_colour, sample_plane};
use crate::splat::Camera;
use crate::views::hull::Silhouette;

/// Room around the subject's box, in its longer side.
const MARGIN: f32 = 0.12;

/// A piece of a photo without distortion, shown with square steps.
#[derive(Clone, Debug)]
pub struct Crop {
    pub name: String,
    /// sRGB 0..1, row-major, the size of `mask`.
    pub colour: Vec<[f32; 3]>,
    /// Subject, 0..1.
    pub mask: Plane,
    /// fx, fy, cx, cy in pixels of the crop.
    pub inside: [f64; 4],
    /// World→camera.
    pub rotation: DQuat,
    pub translation: DVec3,
    /// Left, top, right, bottom of the photo in the crop's pixels.
    pub photo: [f32; 4],
    /// Of the subject, in the crop's pixels.
    pub bounds: [f64; 4],
    /// The subject reaches the photo's border.
    pub cut_off: bool,
}

impl Crop {
    /// The subject's piece of a photo, at most `most` pixels a side. `pixels` may be larger or smaller than what the camera was
    /// calibrated on.
    pub fn new(posed: &Posed, pixels: &image::RgbImage, subject: &Subject, most: usize) -> Crop {
        let (width, height) = (pixels.width() as f32, pixels.height() as f32);
        let (sx, sy) = subject.scale;
        let [x0, y0, x1, y1] = subject.bounds.map(|v| v as f32);
        let [x0, y0, x1, y1] = [x0 * sx, y0 * sy, x1 * sx, y1 * sy];
        let margin = (MARGIN * (x1 - x0).max(y1 - y0)).max(4.0);
        let (left, top) = ((x0 - margin).max(0.0).floor(), (y0 - margin).max(0.0).floor());
        let (right, bottom) = ((x1 + margin).min(width).ceil(), (y1 + margin).min(height).ceil());
        let rect = Rect { x: left, y: top, width: right - left, height: bottom - top };
        let shrink = (most as f32 / rect.width.max(rect.height)).min(1.0);
        let size = |v: f32| ((v * shrink).round() as usize).max(1);
        let (w, h) = (size(rect.width), size(rect.height));
        let on_mask = Rect { x: rect.x / sx, y: rect.y / sy, width: rect.width / sx, height: rect.height / sy };
        // Pixels of the crop for one of the photo, and of the photo for one of the camera.
        let (kx, ky) = (w as f32 / rect.width, h as f32 / rect.height);
        let [fx, fy, cx, cy] = posed.camera.pinhole();
        let (gx, gy) =
            (f64::from(width) / f64::from(posed.camera.width), f64::from(height) / f64::from(posed.camera.height));
        let (dx, dy) = (f64::from(kx), f64::from(ky));
        let inside =
            [fx * gx * dx, fy * gy * dy, (cx * gx - f64::from(rect.x)) * dx, (cy * gy - f64::from(rect.y)) * dy];
        let near = |v: f32, edge: f32| (v - edge).abs() < 2.5 * sx.max(sy);
        Crop {
            name: posed.name.clone(),
            colour: sample_colour(pixels, rect, w, h, Edge::Clamp),
            mask: sample_plane(&subject.mask, on_mask, w, h, Edge::Clamp),
            inside,
            rotation: posed.rotation,
            translation: posed.translation,
            photo: [-rect.x * kx, -rect.y * ky, (width - rect.x) * kx, (height - rect.y) * ky],
            bounds: [(x0 - rect.x) * kx, (y0 - rect.y) * ky, (x1 - rect.x) * kx, (y1 - rect.y) * ky].map(f64::from),
            cut_off: near(x0, 0.0) || near(y0, 0.0) || near(x1, width) || near(y1, height),
        }
    }

    /// The eye in world coordinates.
    pub fn centre(&self) -> DVec3 {
        -(self.rotation.inverse() * self.translation)
    }

    /// The direction in the world of a point of the crop: unit length.
    pub fn ray(&self, [x, y]: [f64; 2]) -> DVec3 {
        let [fx, fy, cx, cy] = self.inside;
        self.rotation.inverse() * DVec3::new((x - cx) / fx, (y - cy) / fy, 1.0).normalize()
    }

    /// The camera of the crop in another frame. Cameras see directions: lengths grow with the frame's.
    pub fn camera(&self, to: &Similarity) -> Camera {
        camera(self.inside, (self.mask.width, self.mask.height), self.rotation, self.translation, to)
    }

    pub fn silhouette(&self, camera: Camera) -> Silhouette<'_> {
        Silhouette { camera, colour: &self.colour, mask: &self.mask, known: self.photo }
    }
}

/// A camera of the world in another frame: p' = s R p + t, so p_camera' = s (W Rᵀ (p' − t) / s + w) with W, w the pose.
pub fn camera(inside: [f64; 4], size: (usize, usize), rotation: DQuat, translation: DVec3, to: &Similarity) -> Camera {
    let turned = rotation * to.rotation.inverse();
    let moved = to.scale * translation - turned * to.translation;
    let [fx, fy, cx, cy] = inside.map(|v| v as f32);
    Camera {
        width: size.0 as u32,
        height: size.1 as u32,
        fx,
        fy,
        cx,
        cy,
        rotation: Mat3::from_quat(turned.as_quat().normalize()),
        translation: moved.as_vec3(),
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;
    use crate::models::scene::Angle;
    use crate::photos::colmap::{self, Lens};

    /// A white disc's photo and mask, posed.
    pub fn disc(size: (u32, u32), at: [f32; 2], radius: f32) -> (Posed, image::RgbImage, Subject) {
        let inside = |x: u32, y: u32| (x as f32 + 0.5 - at[0]).hypot(y as f32 + 0.5 - at[1]) < radius;
        let pixels =
            image::RgbImage::from_fn(size.0, size.1, |x, y| image::Rgb([if inside(x, y) { 255 } else { 0 }; 3]));
        let data: Vec<f32> = pixels.pixels().map(|p| f32::from(p.0[0]) / 255.0).collect();
        let mask = Plane { width: size.0 as usize, height: size.1 as usize, data };
        let bounds = crate::models::region::bounds(&mask, 0.5).unwrap();
        let camera = colmap::Camera {
            lens: Lens::Pinhole,
            width: 2 * size.0,
            height: 2 * size.1,
            parameters: vec![800.0, 800.0, f64::from(size.0), f64::from(size.1)],
        };
        let rotation = DQuat::from_euler(glam::EulerRot::XYZ, 0.4, -0.2, 0.1);
        let posed =
            Posed { name: "a".into(), file: "a".into(), camera, rotation, translation: DVec3::new(0.1, -0.2, 5.0) };
        let elevation = Angle { mean: 0.0, spread: 0.1 };
        let subject = Subject {
            depth: mask.clone(),
            mask,
            bounds,
            scale: (1.0, 1.0),
            from_cutout: false,
            expected_iou: None,
            elevation,
            roll: 0.0,
        };
        (posed, pixels, subject)
    }

    #[test]
    fn a_crop_sees_what_the_photo_sees_there() {
        let (posed, pixels, subject) = disc((300, 200), [120.0, 90.0], 40.0);
        let crop = Crop::new(&posed, &pixels, &subject, 60);
        assert!(crop.mask.width.max(crop.mask.height) == 60 && !crop.cut_off);
        // A point of the world on the ray through the disc's middle.
        let middle = [(crop.bounds[0] + crop.bounds[2]) / 2.0, (crop.bounds[1] + crop.bounds[3]) / 2.0];
        let p = crop.centre() + 7.0 * crop.ray(middle);
        let on_photo = posed.pixel(p).unwrap();
        assert!((on_photo[0] / 2.0 - 120.0).abs() < 0.6 && (on_photo[1] / 2.0 - 90.0).abs() < 0.6, "{on_photo:?}");
        let to = Similarity {
            scale: 0.3,
            rotation: DQuat::from_euler(glam::EulerRot::XYZ, 1.0, 2.0, -0.5),
            translation: DVec3::new(3.0, 4.0, 5.0),
        };
        let c = crop.camera(&to);
        let q = c.rotation * to.apply(p).as_vec3() + c.translation;
        let seen = [c.fx * q.x / q.z + c.cx, c.fy * q.y / q.z + c.cy];
        assert!(
            (f64::from(seen[0]) - middle[0]).abs() < 1e-2 && (f64::from(seen[1]) - middle[1]).abs() < 1e-2,
            "{seen:?}"
        );
        assert_eq!(crop.silhouette(c).allows(to.apply(p).as_vec3()), Some(true));
        let beside = crop.centre() + 7.0 * crop.ray([-8.0, 5.0]);
        assert_eq!(crop.silhouette(c).allows(to.apply(beside).as_vec3()), Some(false));
        let outside = crop.centre() + 7.0 * crop.ray([-500.0, 5.0]);
        assert_eq!(crop.silhouette(c).allows(to.apply(outside).as_vec3()), None);
        let (posed, pixels, subject) = disc((300, 200), [30.0, 90.0], 40.0);
        assert!(Crop::new(&posed, &pixels, &subject, 512).cut_off);
    }
}
