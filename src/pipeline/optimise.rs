//! What the optimisation is given: the photo, its mirror images, six views and those between them.

use super::{GREY, HELD_BACK, MIRRORED, NORMALS, PHOTO, Settings, VIEW, confidence};
use crate::Result;
use crate::models::splat_prior::OneView;
use crate::progress::Progress;
use crate::splat::render::Shown;
use crate::splat::{self, Camera, Frame, Gaussians, Target};
use crate::symmetry::MirroredPhoto;

/// What was drawn of the subject.
pub(super) struct Shot<'a> {
    pub six: &'a [(Camera, Frame)],
    /// Of the six, or none.
    pub normals: &'a [Vec<[f32; 3]>],
    pub between: &'a [(Camera, Frame)],
    /// Of the six, where the network says it.
    pub expected: Option<&'a [confidence::Expected]>,
}

/// Targets: the photo (heaviest, pose refined, some pixels held back), the photo mirrored, the six views, their normals
/// where there are any, and views between them that are measured but never trained on.
pub(super) fn optimise(
    fitter: splat::Engine,
    prior: &OneView,
    mirrored: &[MirroredPhoto],
    views: &Shot,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<splat::Trained> {
    let mut targets = vec![photo(prior, prior.camera, settings.seed)];
    targets.extend(mirrored.iter().enumerate().map(|(i, m)| Target {
        camera: m.camera,
        color: m.color.clone(),
        alpha: m.mask.clone(),
        weight: 0.6,
        refine_pose: Some(0.0),
        fit_exposure: false,
        held_back: Some(m.seen_directly.clone()),
        confidence: None,
        shown: Shown::Color,
        name: if i == 0 { MIRRORED.into() } else { format!("{MIRRORED} {}", i + 1) },
    }));
    let view = |name: String, (camera, frame): &(Camera, Frame), weight: f32| Target {
        camera: *camera,
        color: uncomposited(frame),
        alpha: frame.alpha.clone(),
        weight,
        refine_pose: None,
        fit_exposure: false,
        held_back: None,
        confidence: None,
        shown: Shown::Color,
        name,
    };
    let mut weights = views.expected.map(confidence::weights).unwrap_or_default().into_iter();
    targets.extend(
        views
            .six
            .iter()
            .enumerate()
            .map(|(i, v)| Target { confidence: weights.next(), ..view(format!("{VIEW} {}", i + 1), v, 0.3) }),
    );
    targets.extend(views.six.iter().zip(views.normals).enumerate().map(|(i, (v, normals))| Target {
        color: normals.clone(),
        shown: Shown::Normals,
        ..view(format!("{NORMALS} {}", i + 1), v, 0.1)
    }));
    targets.extend(views.between.iter().enumerate().map(|(i, v)| view(format!("{HELD_BACK} {}", i + 1), v, 0.0)));
    trained(fitter, &prior.gaussians, &targets, settings, None, progress)
}

/// The photo to train on, some of its pixels held back.
pub(super) fn photo(prior: &OneView, camera: Camera, seed: u64) -> Target {
    Target {
        camera,
        color: prior.colour.clone(),
        alpha: prior.mask.data.clone(),
        weight: 1.0,
        refine_pose: Some(0.0),
        fit_exposure: false,
        held_back: Some(held_back(prior.mask.width, seed)),
        confidence: None,
        shown: Shown::Color,
        name: PHOTO.into(),
    }
}

/// The optimisation, in as many steps as the settings and the time allow. `pose_rate`: how fast poses are learnt, radians a step,
/// where not as usual.
pub(super) fn trained(
    fitter: splat::Engine,
    start: &Gaussians,
    targets: &[Target],
    settings: &Settings,
    pose_rate: Option<f32>,
    progress: &dyn Progress,
) -> Result<splat::Trained> {
    progress.begin("optimisation", 0);
    let wanted = settings.iterations as usize;
    let iterations = match (&settings.kept.from, settings.optimise_within) {
        // As many as the stopped run had before it, whatever this machine would do now.
        (Some(saved), _) => saved.iterations,
        (None, Some(limit)) => {
            let seconds = limit.as_secs_f64();
            wanted.min(splat::train::iterations_within(fitter, start, targets, seconds, progress)?)
        }
        (None, None) => wanted,
    };
    let mut options =
        splat::Options { seed: settings.seed, deadline: settings.deadline, ..splat::Options::scaled(iterations) };
    options.rates.pose = pose_rate.unwrap_or(options.rates.pose);
    splat::train::train_kept(fitter, start.clone(), targets, &options, &settings.kept, progress)
}

/// About 3% of the pixels in 4 × 4 blocks, from the seed: never trained on, so that they can be measured.
fn held_back(size: usize, seed: u64) -> Vec<bool> {
    let blocks = size.div_ceil(4);
    (0..size * size)
        .map(|i| {
            let block = (i / size / 4 * blocks + i % size / 4) as u64;
            // SplitMix64 (Steele, Lea and Flood 2014).
            let mut z = (block ^ seed.rotate_left(32)).wrapping_add(0x9E37_79B9_7F4A_7C15);
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            (z ^ (z >> 31)).is_multiple_of(32)
        })
        .collect()
}

/// A frame's own colours, the grey behind them taken out where there is enough of the subject to tell.
pub(super) fn uncomposited(frame: &Frame) -> Vec<[f32; 3]> {
    let own = |(c, &a): (&[f32; 3], &f32)| {
        if a < 1.0 / 255.0 { GREY } else { std::array::from_fn(|k| ((c[k] - (1.0 - a) * GREY[k]) / a).clamp(0.0, 1.0)) }
    };
    frame.color.iter().zip(&frame.alpha).map(own).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn held_back_pixels_are_few_in_blocks_and_from_the_seed() {
        let a = held_back(512, 7);
        let share = a.iter().filter(|&&h| h).count() as f64 / a.len() as f64;
        assert!((0.025..0.038).contains(&share), "{share}");
        assert!((0..128 * 128).all(|b| (1..16).all(|k| {
            let at = |k: usize| (b / 128 * 4 + k / 4) * 512 + b % 128 * 4 + k % 4;
            a[at(0)] == a[at(k)]
        })));
        assert_ne!(a, held_back(512, 8));
    }
}
