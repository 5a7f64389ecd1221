//! The photo among six views that others drew: a body that fits all seven, and the camera that took the photo.

use super::consistency;
use super::hull::{Hull, pixel};
use super::six_views;
use super::tile::View;
use crate::models::scene::Angle;
use crate::models::splat_prior::OneView;
use crate::progress::Progress;
use crate::splat::render::Shown;
use crate::splat::{self, Camera, Gaussians, Target};
use crate::{Error, Result};

/// Steps of the fit to the views.
const FITTING: usize = 150;

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Of the photo's camera, radians above the horizon.
    pub elevation: f32,
    /// Share of the photo's silhouette that a body of the six views fills.
    pub filled: f32,
    /// Share of the six silhouettes that this body, cut to the photo's, still fills.
    pub kept: f32,
}

/// Of the elevation at which the photo's silhouette fits the six views', radians: taken, not measured.
const ELEVATION_ERROR: f32 = 0.05;

/// Brings the prior into the frame of the six views: a model fitted to them takes its Gaussians' place, and the camera from
/// which the photo's silhouette is consistent with theirs takes its camera's.
///
/// # Errors
/// A usage error when the six views show no common body, `Cancelled`.
pub fn settle(view: &mut OneView, views: &[View], seed: u64, progress: &dyn Progress) -> Result<Found> {
    let hull = Hull::of(views);
    let consistent = consistency::find(&hull, &view.mask, view.elevation).filter(|c| c.filled > 0.3 && c.kept > 0.3);
    let Some(c) = consistent else {
        return Err(Error::usage("six views")
            .expected("six views of the photo's subject")
            .found("silhouettes that have no body in common with the photo's")
            .advice("Views must stand at azimuths 30°, 90°, … 330° and elevations 20°, −10°, … (Zero123++ v1.2)."));
    };
    // The photo's silhouette carves too, with a pixel to spare.
    let seen = crate::models::region::dilated(view.mask.width, view.mask.height, 2, |i| view.mask.data[i] > 0.5);
    let carved = hull.carved(|p| pixel(&c.camera, p).is_none_or(|(x, y)| seen[y * view.mask.width + x]));
    view.camera = c.camera;
    view.elevation = c.elevation;
    view.seen_from = Angle { mean: c.elevation, spread: ELEVATION_ERROR };
    view.silhouette_iou = c.filled;
    // What the network expected of its own Gaussians says nothing of these.
    view.expected_errors = None;
    view.gaussians = fitted(carved.surface(views), view, views, seed, progress)?;
    Ok(Found { elevation: c.elevation, filled: c.filled, kept: c.kept })
}

/// A short optimisation on the six views and the photo takes off what their colours contradict.
fn fitted(start: Gaussians, photo: &OneView, views: &[View], seed: u64, progress: &dyn Progress) -> Result<Gaussians> {
    let size = views.first().map_or(1, |v| v.alpha.width as u32);
    let target = |camera: Camera, colour: &[[f32; 3]], alpha: &[f32], name: String| Target {
        camera,
        color: colour.to_vec(),
        alpha: alpha.to_vec(),
        weight: 1.0,
        refine_pose: None,
        fit_exposure: false,
        held_back: None,
        confidence: None,
        shown: Shown::Color,
        name,
    };
    let mut targets = vec![target(photo.camera, &photo.colour, &photo.mask.data, "photo".into())];
    for (i, (camera, view)) in six_views(size).into_iter().zip(views).enumerate() {
        targets.push(target(camera, &view.colour, &view.alpha.data, format!("view {}", i + 1)));
    }
    let options = splat::Options { seed, ..splat::Options::scaled(FITTING) };
    Ok(splat::train(splat::Engine::Cpu, start, &targets, &options, progress)?.gaussians.pruned(0.02))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::splat_prior::canonical_camera;
    use crate::photo::{Plane, Rect};
    use crate::progress::Silent;
    use crate::views::tile;
    use glam::{Mat3, Vec3};

    /// A little truck: a long box, a cab at one end, four colours.
    fn truck() -> Gaussians {
        let mut g = Gaussians::default();
        let mut block = |low: [f32; 3], high: [f32; 3], colour: [f32; 3]| {
            let n = 13;
            for i in 0..n * n * n {
                let k = [i % n, i / n % n, i / n / n];
                if !k.iter().any(|v| *v == 0 || *v == n - 1) {
                    continue;
                }
                let at = |a: usize| low[a] + (high[a] - low[a]) * k[a] as f32 / (n - 1) as f32;
                g.positions.push(Vec3::new(at(0), at(1), at(2)));
                g.log_scales.push(Vec3::splat(0.045f32.ln()));
                g.rotations.push([1.0, 0.0, 0.0, 0.0]);
                g.logit_opacities.push(5.0);
                let mut sh = [[0.0; 3]; 16];
                sh[0] = colour.map(|v| (v - 0.5) / splat::SH_C0);
                g.sh.push(sh);
            }
        };
        block([-0.3, -0.7, -0.35], [0.3, 0.7, -0.1], [0.8, 0.2, 0.1]);
        block([-0.3, 0.3, -0.1], [0.3, 0.7, 0.4], [0.1, 0.3, 0.8]);
        g
    }

    fn views_of(g: &Gaussians) -> Vec<View> {
        let seen = six_views(320).map(|c| splat::render(g, &c, [0.5; 3]));
        seen.iter()
            .map(|f| View {
                colour: f
                    .color
                    .iter()
                    .zip(&f.alpha)
                    .map(
                        |(c, a)| {
                            if *a < 0.01 { [0.5; 3] } else { c.map(|v| ((v - 0.5 * (1.0 - a)) / a).clamp(0.0, 1.0)) }
                        },
                    )
                    .collect(),
                alpha: Plane { width: 320, height: 320, data: f.alpha.clone() },
            })
            .collect()
    }

    fn photo_of(g: &Gaussians, degrees: f32, guess: f32) -> OneView {
        let camera = canonical_camera(degrees.to_radians(), 160);
        let seen = splat::render(g, &camera, [0.0; 3]);
        OneView {
            expected_errors: None,
            // The prior guessed another elevation, and so another body.
            gaussians: g.transformed(Mat3::from_rotation_x((degrees - guess).to_radians()), 0.9, Vec3::ZERO),
            elevation: guess.to_radians(),
            camera: canonical_camera(guess.to_radians(), 160),
            seen_from: Angle { mean: 0.0, spread: 0.05 },
            silhouette_iou: 0.0,
            crop: crate::models::splat_prior::Window {
                rect: Rect { x: 0.0, y: 0.0, width: 160.0, height: 160.0 },
                turned: None,
            },
            colour: seen
                .color
                .iter()
                .zip(&seen.alpha)
                .map(|(c, a)| c.map(|v| (v / a.max(1e-3)).clamp(0.0, 1.0)))
                .collect(),
            mask: Plane { width: 160, height: 160, data: seen.alpha },
        }
    }

    fn alike(a: &Plane, b: &[f32]) -> f32 {
        let (mut both, mut either) = (0, 0);
        for (x, y) in a.data.iter().zip(b) {
            both += usize::from(*x > 0.5 && *y > 0.5);
            either += usize::from(*x > 0.5 || *y > 0.5);
        }
        both as f32 / either as f32
    }

    #[test]
    fn the_hull_holds_the_body_and_shows_its_silhouettes() {
        let (g, views) = (truck(), views_of(&truck()));
        let body = Hull::of(&views).surface(&views);
        let corner = |g: &Gaussians, pick: fn(Vec3, Vec3) -> Vec3| g.positions.iter().copied().reduce(pick).unwrap();
        assert!((corner(&body, Vec3::min) - corner(&g, Vec3::min)).max_element() < 0.05);
        assert!((corner(&g, Vec3::max) - corner(&body, Vec3::max)).max_element() < 0.05);
        for (camera, view) in six_views(320).iter().zip(&views) {
            let share = alike(&crate::models::align::silhouette(&body, camera), &view.alpha.data);
            assert!(share > 0.85, "{share}");
        }
    }

    #[test]
    fn the_photos_elevation_is_found_and_the_body_is_the_views() {
        let g = truck();
        let views = views_of(&g);
        for (degrees, guess) in [(8.0, 25.0), (32.0, 10.0)] {
            let mut view = photo_of(&g, degrees, guess);
            let found = settle(&mut view, &views, 1, &Silent).unwrap();
            assert!(
                (found.elevation.to_degrees() - degrees).abs() <= 8.0,
                "{degrees}: {}",
                found.elevation.to_degrees()
            );
            assert!(found.filled > 0.9 && found.kept > 0.9 && view.elevation == found.elevation, "{found:?}");
            for (camera, seen) in six_views(320).iter().zip(&views) {
                let share = alike(&crate::models::align::silhouette(&view.gaussians, camera), &seen.alpha.data);
                assert!(share > 0.85, "{share}");
            }
        }
    }

    #[test]
    fn views_without_a_common_body_are_refused() {
        let mut views = views_of(&truck());
        let empty = Plane::new(320, 320, 0.0);
        views[2].alpha = empty;
        let mut view = photo_of(&truck(), 8.0, 8.0);
        assert_eq!(settle(&mut view, &views, 1, &Silent).unwrap_err().kind, crate::Kind::Usage);
        assert_eq!(tile::SIZE, crate::models::zero123::TILE);
    }
}
