//! How well the Gaussians meet the photos: PSNR, SSIM and, where its network is there, LPIPS.

use glam::DMat4;
use glam::DVec4;
use rayon::prelude::*;

use crate::Result;
use crate::bench::{Picture, perception};
use crate::models::Graph;
use crate::progress::Progress;
use crate::splat::render::Drawers;
use crate::splat::train::exposure::{Change, NONE, applied};
use crate::splat::{Camera, Target};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    Trained,
    HeldOut,
}

/// One photo beside what the Gaussians show there.
#[derive(Clone, Debug)]
pub struct View {
    pub name: String,
    pub role: Role,
    pub camera: Camera,
    pub truth: Picture,
    pub found: Picture,
    pub scores: Scores,
}

/// Of one photo, or means over several. Masked pixels do not count; in SSIM and LPIPS both pictures are the same there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scores {
    pub photos: usize,
    /// dB. A photo trained on with an exposure of its own is compared under that.
    pub psnr: f64,
    pub ssim: Option<f64>,
    pub lpips: Option<f64>,
    /// PSNR where an affine map of colours is fitted to one half of the photo and measured on the other, both ways.
    pub psnr_fitted: Option<f64>,
}

impl Scores {
    /// Means of each over those that have it.
    pub fn mean<'a>(all: impl Iterator<Item = &'a Scores>) -> Scores {
        let all: Vec<&Scores> = all.collect();
        let of = |pick: fn(&Scores) -> Option<f64>| {
            let values: Vec<f64> = all.iter().filter_map(|s| pick(s)).collect();
            (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
        };
        Scores {
            photos: all.len(),
            psnr: of(|s| Some(s.psnr)).unwrap_or(0.0),
            ssim: of(|s| s.ssim),
            lpips: of(|s| s.lpips),
            psnr_fitted: of(|s| s.psnr_fitted),
        }
    }
}

/// Every photo and its picture of the Gaussians. The targets are used up: their colours are not needed any more. `cameras` and
/// `exposures`: one a target.
///
/// # Errors
/// As [`perception::lpips`]; the user's interrupt.
pub fn views(
    targets: Vec<Target>,
    drawers: &Drawers,
    cameras: &[Camera],
    exposures: &[Change],
    behind: [f32; 3],
    lpips: Option<&dyn Graph>,
    progress: &dyn Progress,
) -> Result<Vec<View>> {
    let any_exposure = targets.iter().any(|t| t.fit_exposure);
    let all: Vec<(Target, Camera, Change)> =
        targets.into_iter().zip(cameras).zip(exposures).map(|((t, c), e)| (t, *c, *e)).collect();
    let mut views: Vec<View> = all
        .into_par_iter()
        .map(|(target, camera, exposure)| {
            let frame = drawers.render(&camera, behind);
            let found = Picture::new(frame.width, frame.height, frame.color);
            view(&target, camera, found, &exposure, behind, any_exposure)
        })
        .collect();
    progress.check()?;
    if let Some(graph) = lpips {
        for (i, v) in views.iter_mut().enumerate() {
            progress.check()?;
            v.scores.lpips = Some(perception::lpips(&v.found, &v.truth, graph)?);
            progress.step(i as u64 + 1);
        }
    }
    Ok(views)
}

fn view(t: &Target, camera: Camera, found: Picture, exposure: &Change, behind: [f32; 3], fitted: bool) -> View {
    let role = if t.weight > 0.0 { Role::Trained } else { Role::HeldOut };
    let over = |(c, a): (&[f32; 3], &f32)| std::array::from_fn(|k| c[k] * a + behind[k] * (1.0 - a));
    let truth = Picture::new(found.width, found.height, t.color.iter().zip(&t.alpha).map(over).collect());
    let counted: Vec<bool> = (0..truth.pixels.len()).map(|i| !t.held_back.as_ref().is_some_and(|h| h[i])).collect();
    let shown = |pixels: Vec<[f32; 3]>| Picture {
        pixels: pixels
            .into_iter()
            .zip(&truth.pixels)
            .zip(&counted)
            .map(|((f, t), counted)| if *counted { f.map(|v| v.clamp(0.0, 1.0)) } else { *t })
            .collect(),
        ..truth
    };
    let under = |m: &Change| shown(found.pixels.iter().map(|x| applied(m, *x)).collect());
    let compared = if *exposure == NONE { shown(found.pixels.clone()) } else { under(exposure) };
    let only = |p: &Picture, keep: &dyn Fn(usize) -> bool| -> Vec<[f32; 3]> {
        p.pixels.iter().enumerate().filter(|(i, _)| counted[*i] && keep(*i)).map(|(_, v)| *v).collect()
    };
    let psnr = |p: &Picture, keep: &dyn Fn(usize) -> bool| perception::psnr(&only(p, keep), &only(&truth, keep));
    let everywhere = |_: usize| true;
    let left = |i: usize| i % truth.width < truth.width / 2;
    let psnr_fitted = (fitted && role == Role::HeldOut).then(|| {
        // Learnt on one half, measured on the other: the mean of both squared errors.
        let halves = [false, true].map(|side| {
            let learnt = affine(&only(&found, &|i| left(i) == side), &only(&truth, &|i| left(i) == side));
            10f64.powf(-psnr(&under(&learnt), &|i| left(i) != side) / 10.0)
        });
        -10.0 * ((halves[0] + halves[1]) / 2.0).log10()
    });
    let scores = Scores {
        photos: 1,
        psnr: psnr(&compared, &everywhere),
        ssim: perception::ssim(&compared, &truth),
        lpips: None,
        psnr_fitted,
    };
    View { name: t.name.clone(), role, camera, truth, found: compared, scores }
}

/// The affine map of the least squares from `x` to `y`; none where they do not say.
pub(super) fn affine(x: &[[f32; 3]], y: &[[f32; 3]]) -> Change {
    let mut normal = DMat4::ZERO;
    let mut right = [DVec4::ZERO; 3];
    for (x, y) in x.iter().zip(y) {
        let v = DVec4::new(x[0].into(), x[1].into(), x[2].into(), 1.0);
        normal += DMat4::from_cols(v * v.x, v * v.y, v * v.z, v);
        for (sum, y) in right.iter_mut().zip(y) {
            *sum += v * f64::from(*y);
        }
    }
    // Grey pictures leave the tint open: a little of what holds it at none.
    let hold = 1e-3 * x.len() as f64;
    normal += DMat4::from_diagonal(DVec4::splat(hold));
    let inverse = normal.inverse();
    std::array::from_fn(|i| {
        let none = DVec4::from_array(NONE[i].map(f64::from));
        let row = inverse * (right[i] + none * hold);
        if row.is_finite() { row.as_vec4().to_array() } else { NONE[i] }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splat::train::random::Random;

    #[test]
    fn an_affine_map_is_found_and_nothing_is_made_up_of_nothing() {
        let truth: Change = [[1.2, 0.1, 0.0, 0.05], [0.0, 0.7, 0.0, 0.1], [0.05, 0.0, 1.0, -0.1]];
        let mut random = Random::new(2);
        let x: Vec<[f32; 3]> = (0..500).map(|_| std::array::from_fn(|_| random.uniform())).collect();
        let y: Vec<[f32; 3]> = x.iter().map(|x| applied(&truth, *x)).collect();
        let found = affine(&x, &y);
        for (a, b) in found.as_flattened().iter().zip(truth.as_flattened()) {
            assert!((a - b).abs() < 0.03, "{found:?}");
        }
        assert_eq!(affine(&[], &[]), NONE);
    }
}
