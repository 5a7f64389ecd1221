//! A last, short training of the Gaussians on pictures of the model.
//!
//! A network's pictures, which Gaussians are trained on, are blurred, and their far sides half transparent. The model has the
//! photo's own pixels wherever the photo or its mirror image shows the surface, and nothing transparent. Trained on its pictures
//! for a while, the Gaussians show the same from all sides, and `scene.ply` and the model agree.

use super::{GREY, VIEW_SIZE};
use crate::mesh::{Level, raster};
use crate::progress::Progress;
use crate::splat::render::Shown;
use crate::splat::{self, Camera, Gaussians, Options, Target, Trained};
use crate::{Result, views};

/// What the model's pictures are called in the report, each with its number.
pub const MODEL: &str = "model";
/// Steps at most, and of the optimisation's steps one in so many at most.
const STEPS: usize = 100;
const ONE_IN: usize = 3;
/// Of all the model's pictures together, beside the photo's 1.
const WEIGHT: f32 = 1.8;
/// Samples along a pixel's side.
const FINER: u32 = 3;

/// How Gaussians settle that were optimised in so many steps.
pub fn options(optimised: usize) -> Options {
    let mut options = Options::scaled(STEPS.min(optimised / ONE_IN));
    // All harmonics are there already, and as many Gaussians as are wanted.
    options.first_degree = 3;
    options.density.until = 0;
    options
}

/// Trains `gaussians` on the `photo` and on pictures of `finest` from around it, [`MODEL`] in the report.
///
/// # Errors
/// As [`splat::train`].
pub fn settle(
    gaussians: Gaussians,
    photo: Target,
    finest: &Level,
    fitter: splat::Engine,
    options: &Options,
    progress: &dyn Progress,
) -> Result<Trained> {
    let mut targets = vec![photo];
    let cameras: Vec<Camera> = views::six_views(VIEW_SIZE).into_iter().chain(views::held_back(VIEW_SIZE)).collect();
    let weight = WEIGHT / cameras.len() as f32;
    targets.extend(cameras.into_iter().enumerate().map(|(i, camera)| {
        let (color, alpha) = raster::cut_out(&finest.mesh, &finest.texture, &camera, FINER, GREY);
        Target {
            camera,
            color,
            alpha,
            weight,
            refine_pose: None,
            fit_exposure: false,
            held_back: None,
            confidence: None,
            shown: Shown::Color,
            name: format!("{MODEL} {}", i + 1),
        }
    }));
    splat::train(fitter, gaussians, &targets, options, progress)
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use image::{Rgb, RgbImage};

    use super::super::PHOTO;
    use super::*;
    use crate::mesh::{Details, Mesh, fibonacci_sphere};
    use crate::progress::Silent;
    use crate::splat::{SH_C0, SH_COEFFICIENTS};

    /// A blue octahedron.
    fn octahedron() -> Level {
        let corner = |i: usize| [Vec3::X, Vec3::Y, Vec3::NEG_X, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z][i] * 0.8;
        let positions: Vec<Vec3> = (0..6).map(corner).collect();
        let sides = |i: u32| [[i, (i + 1) % 4, 4], [(i + 1) % 4, i, 5]];
        Level {
            mesh: Mesh {
                normals: positions.iter().map(|p| p.normalize()).collect(),
                uvs: vec![glam::Vec2::splat(0.5); 6],
                positions,
                triangles: (0..4).flat_map(sides).collect(),
            },
            texture: RgbImage::from_pixel(16, 16, Rgb([40, 80, 200])),
            details: Details::default(),
            error: 0.0,
            mean_error: 0.0,
            error_to_coarser: 1.0,
            seen: 0.0,
            mirrored: 0.0,
        }
    }

    /// Half transparent balls on its faces, of about its colour.
    fn fog() -> Gaussians {
        let on_faces = |p: Vec3| p * (0.8 / p.abs().element_sum());
        let positions: Vec<Vec3> = fibonacci_sphere(600).into_iter().map(on_faces).collect();
        let n = positions.len();
        let mut sh = [[0.0; 3]; SH_COEFFICIENTS];
        sh[0] = [0.25, 0.35, 0.65].map(|c| (c - 0.5) / SH_C0);
        Gaussians {
            positions,
            log_scales: vec![Vec3::splat(0.05f32.ln()); n],
            rotations: vec![[1.0, 0.0, 0.0, 0.0]; n],
            logit_opacities: vec![0.0; n],
            sh: vec![sh; n],
        }
    }

    #[test]
    fn gaussians_come_closer_to_the_model_and_the_photo_the_same_way_each_time() {
        let finest = octahedron();
        let camera = views::orbit(0.0, 10.0, views::DISTANCE, 64);
        let (color, alpha) = raster::cut_out(&finest.mesh, &finest.texture, &camera, 2, GREY);
        let photo = Target {
            camera,
            color,
            alpha,
            weight: 1.0,
            refine_pose: None,
            fit_exposure: false,
            held_back: None,
            confidence: None,
            shown: Shown::Color,
            name: PHOTO.into(),
        };
        let options = options(300);
        assert_eq!(options.iterations, STEPS);
        let once = || settle(fog(), photo.clone(), &finest, splat::Engine::Cpu, &options, &Silent).unwrap();
        let (a, b) = (once(), once());
        assert_eq!(a.gaussians, b.gaussians);
        assert_eq!(a.gaussians.len(), fog().len());
        assert_eq!(a.report.targets.iter().filter(|t| t.name.starts_with(MODEL)).count(), 12);
        for t in &a.report.targets {
            assert!(t.after.picture > t.before.picture + 2.0, "{t:?}");
        }
    }

    #[test]
    fn a_run_of_few_steps_settles_in_fewer() {
        assert_eq!([0, 2, 5, 300, 7000].map(|n| options(n).iterations), [0, 0, 1, 100, 100]);
    }
}
