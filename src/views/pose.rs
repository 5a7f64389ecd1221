//! Where the photo was taken from, found by what six views allow: elevation, zoom and shift that show the photo again.

use super::tile::View;
use super::{hull, six_views};
use crate::models::align::fit_intrinsics;
use crate::models::splat_prior::{OneView, canonical_camera};
use crate::progress::Progress;
use crate::splat::{self, Camera, Gaussians, Target};
use crate::{Error, Result};

/// Degrees that are searched, and the first step.
const RANGE: (f32, f32) = (-20.0, 60.0);
const STEP: f32 = 8.0;
/// Side of the pictures that are compared.
const GRID: u32 = 96;
/// Steps of the fit to the six views.
const FITTING: usize = 150;
/// Weight of the colours beside the silhouette.
const COLOUR: f32 = 0.7;

/// What the search found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Radians above the horizon.
    pub elevation: f32,
    /// Of the hull's silhouette and the photo's mask.
    pub iou: f32,
}

/// Brings the prior into the frame of the six views: a model fitted to them takes its Gaussians' place, and the camera that shows
/// the photo's mask and colours on that model takes its camera's.
///
/// # Errors
/// A usage error when the six views show no common body, `Cancelled`.
pub fn settle(view: &mut OneView, views: &[View], seed: u64, progress: &dyn Progress) -> Result<Found> {
    let hull = hull::hull(views);
    if hull.len() < 200 {
        return Err(Error::usage("six views")
            .expected("six views of one subject")
            .found("silhouettes that have no body in common")
            .advice("Views must stand at azimuths 30°, 90°, … 330° and elevations 20°, −10°, … (Zero123++ v1.2)."));
    }
    let body = fitted(hull, views, seed, progress)?;
    let (camera, found) = photo_camera(view, &body);
    view.camera = camera;
    view.elevation = found.elevation;
    view.silhouette_iou = found.iou;
    view.gaussians = body;
    Ok(found)
}

/// The hull is wider than the body between the views: a short optimisation on the views takes off what their colours contradict.
fn fitted(hull: Gaussians, views: &[View], seed: u64, progress: &dyn Progress) -> Result<Gaussians> {
    let size = views.first().map_or(1, |v| v.alpha.width as u32);
    let target = |(i, (camera, view)): (usize, (Camera, &View))| Target {
        camera,
        color: view.colour.clone(),
        alpha: view.alpha.data.clone(),
        weight: 1.0,
        refine_pose: false,
        held_back: None,
        name: format!("view {}", i + 1),
    };
    let targets: Vec<Target> = six_views(size).into_iter().zip(views).enumerate().map(target).collect();
    let options = splat::Options { seed, ..splat::Options::scaled(FITTING) };
    Ok(splat::train(hull, &targets, &options, progress)?.gaussians.pruned(0.02))
}

/// A coarse search over the elevation, then halved steps around the best.
fn photo_camera(view: &OneView, body: &Gaussians) -> (Camera, Found) {
    let size = view.camera.width;
    let (photo, mask) = shrunk(view);
    let judge = |degrees: f32| {
        let start = canonical_camera(degrees.to_radians(), size);
        let (camera, iou) = fit_intrinsics(body, &start, &view.mask);
        let seen = splat::render(body, &camera.resized(GRID, GRID), [0.0; 3]);
        let (mut sum, mut n) = (0.0, 0.0);
        for ((c, &a), (p, &m)) in seen.color.iter().zip(&seen.alpha).zip(photo.iter().zip(&mask)) {
            if a > 0.5 && m > 0.5 {
                sum += (0..3).map(|k| (c[k] / a - p[k]).abs()).sum::<f32>() / 3.0;
                n += 1.0;
            }
        }
        let colour = if n > 0.0 { sum / n } else { 1.0 };
        ((1.0 - iou) + COLOUR * colour, camera, iou)
    };
    let mut best = (RANGE.0, judge(RANGE.0));
    let consider = |degrees: f32, best: &mut (f32, (f32, Camera, f32))| {
        if (RANGE.0..=RANGE.1).contains(&degrees) {
            let judged = judge(degrees);
            if judged.0 < best.1.0 {
                *best = (degrees, judged);
            }
        }
    };
    let steps = ((RANGE.1 - RANGE.0) / STEP) as usize;
    (1..=steps).for_each(|i| consider(RANGE.0 + STEP * i as f32, &mut best));
    let mut step = STEP / 2.0;
    while step >= 1.0 {
        let around = best.0;
        consider(around - step, &mut best);
        consider(around + step, &mut best);
        step /= 2.0;
    }
    let (degrees, (_, camera, iou)) = best;
    (camera, Found { elevation: degrees.to_radians(), iou })
}

/// The photo's crop at the grid's size.
fn shrunk(view: &OneView) -> (Vec<[f32; 3]>, Vec<f32>) {
    let (from, to) = (view.mask.width, GRID as usize);
    let at = |i: usize| ((i / to * 2 + 1) * from / (2 * to)) * from + (i % to * 2 + 1) * from / (2 * to);
    (0..to * to).map(|i| (view.colour[at(i)], view.mask.data[at(i)])).unzip()
}

#[cfg(test)]
mod tests {
    use super::*;
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
            // The prior guessed another elevation, and so another body.
            gaussians: g.transformed(Mat3::from_rotation_x((degrees - guess).to_radians()), 0.9, Vec3::ZERO),
            elevation: guess.to_radians(),
            camera: canonical_camera(guess.to_radians(), 160),
            silhouette_iou: 0.0,
            crop: Rect { x: 0.0, y: 0.0, width: 160.0, height: 160.0 },
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
        let body = hull::hull(&views);
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
                (found.elevation.to_degrees() - degrees).abs() <= 6.0,
                "{degrees}: {}",
                found.elevation.to_degrees()
            );
            assert!(found.iou > 0.8 && view.elevation == found.elevation, "{found:?}");
            for (camera, seen) in six_views(320).iter().zip(&views) {
                let share = alike(&crate::models::align::silhouette(&view.gaussians, camera), &seen.alpha.data);
                assert!(share > 0.9, "{share}");
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
