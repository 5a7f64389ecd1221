//! How far the colours of a surface are expected to be off, as a picture in its texture's layout.

use image::{GrayImage, Luma};

use super::bake::bake;
use super::color::to_srgb;
use super::{Level, Options, View};
use crate::Result;
use crate::progress::Progress;
use crate::splat::Camera;

/// Pictures from around that the errors are taken from, and pixels across each.
const VIEWS: usize = 24;
const VIEW_SIZE: u32 = 256;
/// Texels across, at most: what is expected has no detail.
const LARGEST: u32 = 512;

/// Errors by the texture coordinates of `level`, 0..1 in eight bits.
///
/// `render` draws the errors as greys over black.
///
/// # Errors
/// `Usage` for pictures that do not fit their cameras, `Cancelled`.
pub fn texture(level: &Level, render: &(dyn Fn(&Camera) -> View + Sync), progress: &dyn Progress) -> Result<GrayImage> {
    // Baking takes means in linear light: what it finds there are the errors themselves.
    let lit = |camera: &Camera| {
        let mut view = render(camera);
        for (c, &a) in view.color.iter_mut().zip(&view.alpha) {
            *c = [a * to_srgb((c[0] / a.max(1e-6)).clamp(0.0, 1.0)); 3];
        }
        view
    };
    let options = Options { color_views: VIEWS, color_size: VIEW_SIZE, background: [0.0; 3], ..Options::default() };
    let size = level.texture.width().min(LARGEST);
    let baked = bake(&level.mesh, size, &lit, &[], &options, progress)?;
    let byte = |x: u32, y: u32| (baked.color[y as usize * baked.size + x as usize][0].clamp(0.0, 1.0) * 255.0).round();
    Ok(GrayImage::from_fn(size, size, |x, y| Luma([byte(x, y) as u8])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::raster::visibility;
    use crate::mesh::{Details, MEDIAN, Mesh, fibonacci_sphere};
    use crate::progress::Silent;
    use glam::{Vec2, Vec3};
    use image::RgbImage;

    /// Two squares back to back, each with half of the texture.
    fn board() -> Level {
        let mut mesh = Mesh::default();
        for (side, v) in [(-1.0f32, 0.0f32), (1.0, 0.5)] {
            let first = mesh.positions.len() as u32;
            for (x, z) in [(-0.5f32, -0.5f32), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)] {
                mesh.positions.push(Vec3::new(-side * x, 0.02 * side, z));
                mesh.normals.push(Vec3::Y * side);
                mesh.uvs.push(Vec2::new(0.1 + 0.8 * (x + 0.5), v + 0.05 + 0.4 * (z + 0.5)));
            }
            mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        }
        Level {
            mesh,
            texture: RgbImage::new(64, 64),
            details: Details::default(),
            error: 0.0,
            mean_error: 0.0,
            error_to_coarser: 1.0,
            seen: 0.0,
            mirrored: 0.0,
        }
    }

    #[test]
    fn errors_lie_where_they_are_seen() {
        let level = board();
        // 20 levels in front, 80 behind; edges half covered.
        let render = |camera: &Camera| {
            let seen = visibility(&level.mesh.positions, &level.mesh.triangles, camera);
            let error = |t: u32| if t < 2 { 20.0 / 255.0 } else { 80.0 / 255.0 };
            let one = |t: &u32| if *t == u32::MAX { ([0.0; 3], 0.0) } else { ([0.9 * error(*t); 3], 0.9) };
            let (color, alpha) = seen.triangle.iter().map(one).unzip();
            View { camera: *camera, color, alpha, depth: seen.depth, passing: MEDIAN }
        };
        assert!(fibonacci_sphere(VIEWS).iter().any(|d| d.y < -0.5));
        let picture = texture(&level, &render, &Silent).unwrap();
        let at = |u: f32, v: f32| picture.get_pixel((u * 64.0) as u32, ((1.0 - v) * 64.0) as u32).0[0];
        assert!(
            at(0.5, 0.25).abs_diff(20) <= 1 && at(0.5, 0.75).abs_diff(80) <= 1,
            "{} {}",
            at(0.5, 0.25),
            at(0.5, 0.75)
        );
    }
}
