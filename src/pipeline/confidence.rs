//! How wrong the network's pictures are to be expected, pixel by pixel, and how much each pixel counts therefore.
//!
//! The network says of each of its Gaussians the colour error that is to be expected where a view from anywhere shows it. It
//! learned these numbers as blended along each pixel's ray like colours, so that a picture of expected error is what the
//! rasteriser makes of them in colours' place, over coverage.

use crate::splat::render::Drawer;
use crate::splat::{Camera, Gaussians, SH_C0, SH_COEFFICIENTS};
use crate::symmetry::Origin;

/// Steps of drawn errors, a quarter of those of eight bits: what rounding does to sums of equal numbers must not tell them apart.
const STEPS: f32 = 1024.0;
/// Added to every error, sRGB 0..1, squares to squares: the views hold shapes as well as colours, and where they hold too
/// little, shapes come apart. 0.02, about what the network expects where it is surest, cost the play house of `samples/truth` 0.2 %
/// of its diagonal; this next to nothing.
const FLOOR: f64 = 0.1;

/// A picture of expected error.
#[derive(Clone, Debug, PartialEq)]
pub struct Expected {
    /// sRGB 0..1, the mean absolute difference of the channels; 0 where nothing is.
    pub error: Vec<f32>,
    /// 0..1.
    pub coverage: Vec<f32>,
}

/// Expected errors of a completed subject's Gaussians, from those of the Gaussians that it was completed from.
///
/// A mirror image is expected to be off as far as its original, and no less than what it stands in the place of was in the mean: that the
/// far side is like the near one is not known either.
pub fn carried(errors: &[f32], origins: &[Origin]) -> Vec<f32> {
    let mut replaced = vec![true; errors.len()];
    origins.iter().filter(|o| !o.mirrored).for_each(|o| replaced[o.of] = false);
    let of_replaced = || errors.iter().zip(&replaced).filter(|(_, r)| **r).map(|(e, _)| f64::from(*e));
    let least = (of_replaced().sum::<f64>() / of_replaced().count().max(1) as f64) as f32;
    origins.iter().map(|o| if o.mirrored { errors[o.of].max(least) } else { errors[o.of] }).collect()
}

/// The Gaussians with their errors, one each, for colours.
pub fn as_greys(g: &Gaussians, errors: &[f32]) -> Gaussians {
    let grey = |e: &f32| {
        let mut sh = [[0.0; 3]; SH_COEFFICIENTS];
        sh[0] = [(e - 0.5) / SH_C0; 3];
        sh
    };
    Gaussians { sh: errors.iter().map(grey).collect(), ..g.clone() }
}

/// What `cameras` see of the expected errors, one a Gaussian.
pub fn drawn(g: &Gaussians, errors: &[f32], cameras: &[Camera]) -> Vec<Expected> {
    let mut drawer = Drawer::new(&as_greys(g, errors));
    let one = |camera: &Camera| {
        let frame = drawer.render(camera, [0.0; 3]);
        let of = |(c, a): (&[f32; 3], &f32)| if *a < 1.0 / 255.0 { 0.0 } else { (c[0] / a * STEPS).round() / STEPS };
        Expected { error: frame.color.iter().zip(&frame.alpha).map(of).collect(), coverage: frame.alpha }
    };
    cameras.iter().map(one).collect()
}

/// Mean over all that the pictures cover, sRGB 0..1.
pub fn mean(expected: &[Expected]) -> f32 {
    let pixels = || expected.iter().flat_map(|e| e.error.iter().zip(&e.coverage));
    let covered: f64 = pixels().map(|(_, a)| f64::from(*a)).sum();
    (pixels().map(|(e, a)| f64::from(e * a)).sum::<f64>() / covered.max(1e-6)) as f32
}

/// How much each pixel of the pictures counts, 1 in the mean over all of them and where nothing is.
///
/// Of pictures whose pixels are off by errors of different widths b (Laplace), the most likely original is the one with the least
/// Σ |difference| / b, and b is the mean absolute error: what the network expects. For squared differences it would be 1 / b². What is
/// drawn half transparent counts half as such.
pub fn weights(expected: &[Expected]) -> Vec<Vec<f32>> {
    let trust = |e: f32| (f64::from(e).powi(2) + FLOOR * FLOOR).sqrt().recip();
    let pixels = || expected.iter().flat_map(|e| e.error.iter().zip(&e.coverage)).filter(|(_, a)| **a > 0.0);
    // The mean from the first one's: of equal numbers it is that number to the last bit, and every weight 1.
    let first = pixels().next().map_or(1.0, |(e, _)| trust(*e));
    let covered: f64 = pixels().map(|(_, a)| f64::from(*a)).sum();
    let mean = first + pixels().map(|(e, a)| f64::from(*a) * (trust(*e) - first)).sum::<f64>() / covered.max(1e-6);
    let weight = |(e, a): (&f32, &f32)| (1.0 + f64::from(*a) * (trust(*e) / mean - 1.0)) as f32;
    expected.iter().map(|e| e.error.iter().zip(&e.coverage).map(weight).collect()).collect()
}

#[cfg(test)]
mod tests {
    use glam::{Mat3, Vec3};

    use super::*;
    use crate::models::splat_prior::OneView;
    use crate::models::splat_prior::Window;
    use crate::photo::{Plane, Rect};
    use crate::pipeline::optimise::{Shot, optimise};
    use crate::pipeline::{GREY, Settings};
    use crate::progress::Silent;
    use crate::splat::{self, Frame, train::Kept};
    use crate::symmetry::Use;
    use crate::views;

    /// Small balls on a sphere's surface.
    fn ball() -> Gaussians {
        let positions: Vec<Vec3> = crate::mesh::fibonacci_sphere(500).into_iter().map(|d| 0.7 * d).collect();
        let n = positions.len();
        let colour = |p: &Vec3| {
            let mut sh = [[0.0; 3]; SH_COEFFICIENTS];
            sh[0] = (*p * 0.8).to_array();
            sh
        };
        Gaussians {
            log_scales: vec![Vec3::splat(0.08f32.ln()); n],
            rotations: vec![[1.0, 0.0, 0.0, 0.0]; n],
            logit_opacities: vec![3.0; n],
            sh: positions.iter().map(colour).collect(),
            positions,
        }
    }

    fn cameras() -> [Camera; 6] {
        views::six_views(48)
    }

    #[test]
    fn drawn_errors_are_those_of_what_is_seen() {
        let g = ball();
        // Above the middle 0.2, below 0.05.
        let errors: Vec<f32> = g.positions.iter().map(|p| if p.z > 0.0 { 0.2 } else { 0.05 }).collect();
        let above = views::orbit(0.0, 80.0, views::DISTANCE, 48);
        let below = views::orbit(0.0, -80.0, views::DISTANCE, 48);
        let seen = drawn(&g, &errors, &[above, below]);
        let middle = 24 * 48 + 24;
        let [top, bottom] = [&seen[0], &seen[1]].map(|s| s.error[middle]);
        assert!((top - 0.2).abs() < 0.02 && (bottom - 0.05).abs() < 0.02, "{top} {bottom}");
        assert!(seen[0].coverage[middle] > 0.8 && seen[0].coverage[0] == 0.0 && seen[0].error[0] == 0.0);
        let all = mean(&drawn(&g, &errors, &cameras()));
        assert!(all > 0.08 && all < 0.17, "{all}");
    }

    #[test]
    fn weights_fall_with_the_error_and_are_1_in_the_mean() {
        let error: Vec<f32> = (0..400).map(|i| i as f32 / 400.0).collect();
        let half = Expected { error: error.clone(), coverage: vec![0.5; 400] };
        let full = Expected { error, coverage: vec![1.0; 400] };
        let empty = Expected { error: vec![0.0; 100], coverage: vec![0.0; 100] };
        let found = weights(&[full, half, empty]);
        assert!(found.iter().flatten().all(|w| w.is_finite() && *w > 0.0));
        assert!(found[0].windows(2).all(|w| w[1] < w[0]) && found[1].windows(2).all(|w| w[1] < w[0]));
        assert!(found[2].iter().all(|w| *w == 1.0), "where nothing is, nothing is expected to be wrong");
        let sum: f64 = found.iter().flatten().map(|w| f64::from(*w)).sum();
        assert!((sum / 900.0 - 1.0).abs() < 1e-6, "{sum}");
        assert!(weights(&[]).is_empty());
    }

    #[test]
    fn a_picture_that_is_expected_to_be_worse_counts_less() {
        let flat = |e: f32| Expected { error: vec![e; 64], coverage: vec![1.0; 64] };
        let found = weights(&[flat(0.05), flat(0.2)]);
        assert!(found[0][0] > 1.2 && found[1][63] < 0.8, "{} {}", found[0][0], found[1][63]);
    }

    #[test]
    fn mirror_images_are_trusted_no_more_than_their_originals_or_what_they_replace() {
        let own = |of| Origin { of, mirrored: false };
        let image = |of| Origin { of, mirrored: true };
        // 2 and 3 gave way.
        let found = carried(&[0.1, 0.4, 0.2, 0.3], &[own(0), own(1), image(0), image(1)]);
        assert_eq!(found, [0.1, 0.4, 0.25, 0.4]);
        assert_eq!(carried(&[0.1, 0.4], &[own(1), own(0)]), [0.4, 0.1]);
    }

    fn prior(errors: Option<Vec<f32>>) -> OneView {
        let camera = views::orbit(0.0, 15.0, views::DISTANCE, 64);
        let seen = splat::render(&ball(), &camera, GREY);
        OneView {
            // Not quite what the photo shows.
            gaussians: ball().transformed(Mat3::from_rotation_z(0.1), 1.02, Vec3::ZERO),
            expected_errors: errors,
            elevation: 0.26,
            camera,
            seen_from: crate::models::scene::Angle { mean: 0.0, spread: 0.05 },
            silhouette_iou: 1.0,
            crop: Window { rect: Rect { x: 0.0, y: 0.0, width: 64.0, height: 64.0 }, turned: None },
            colour: seen.color,
            mask: Plane { width: 64, height: 64, data: seen.alpha },
        }
    }

    fn optimised(errors: Option<Vec<f32>>) -> Gaussians {
        let prior = prior(errors);
        let six: Vec<(Camera, Frame)> = cameras().map(|c| (c, splat::render(&prior.gaussians, &c, GREY))).to_vec();
        let expected = prior.expected_errors.as_ref().map(|e| drawn(&prior.gaussians, e, &cameras()));
        let shot = Shot { six: &six, normals: &[], between: &[], expected: expected.as_deref() };
        let settings = Settings {
            iterations: 30,
            optimise_within: None,
            deadline: None,
            seed: 3,
            pitch: None,
            symmetry: Use::Off,
            levels: 1,
            triangles: None,
            in_store: false,
            texture: 64,
            normal_map: false,
            occlusion: false,
            kept: Kept::default(),
        };
        optimise(splat::Engine::Cpu, &prior, &[], &shot, &settings, &Silent).unwrap().gaussians
    }

    #[test]
    fn equal_errors_change_no_bit_of_the_optimisation() {
        let plain = optimised(None);
        for e in [0.0, 0.07, 0.3] {
            assert_eq!(optimised(Some(vec![e; 500])), plain, "{e}");
        }
        let uneven = ball().positions.iter().map(|p| if p.y > 0.0 { 0.3 } else { 0.02 }).collect();
        assert_ne!(optimised(Some(uneven)), plain);
    }
}
