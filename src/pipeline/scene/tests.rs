//! Scenes of made places, briefly trained on the CPU.

mod cut;
mod ground;
mod poses;
mod terrain;

use std::sync::LazyLock;

use super::*;
use crate::audit::Marking;
use crate::bench::make::site;
use crate::photo;
use crate::photos::dataset;
use crate::progress::Silent;
use crate::splat::train::exposure::{NONE, applied};

struct Made {
    folder: tempfile::TempDir,
    at: std::path::PathBuf,
}

fn made(o: &site::Options) -> Made {
    let folder = tempfile::tempdir().unwrap();
    let (name, files) = site::set(0, o, &Marking::UNCLASSIFIED).unwrap();
    for f in files {
        let path = folder.path().join(&f.path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, f.bytes).unwrap();
    }
    let at = folder.path().join(name);
    Made { folder, at }
}

const PLAIN: site::Options =
    site::Options { seed: 1, count: 24, width: 96, gps_noise: 0.3, exposure_drift: 0.0, moving: false, nerf: false };

/// Photos held out as the layout says; `masked`: with masks.
fn with_source<T>(made: &Made, masked: bool, run: impl FnOnce(&Source) -> T) -> T {
    let found = dataset::find(&made.at, None).unwrap().unwrap();
    let names: Vec<String> = found.poses.photos.iter().map(|p| p.name.clone()).collect();
    let masks = dataset::masks(&made.at, None, &names).unwrap();
    let held_out = dataset::split(found.held_out.as_deref(), names.len(), dataset::EVERY);
    let open = |p: &Posed| -> Result<Photo> {
        let bytes = std::fs::read(&p.file).unwrap();
        Ok(photo::decode_as_stored(&p.name, &bytes, &photo::Limits::default())?.0)
    };
    let mask = |i: usize| -> Result<Option<image::GrayImage>> {
        Ok(masks[i].as_ref().filter(|_| masked).map(|f| image::open(f).unwrap().into_luma8()))
    };
    run(&Source { poses: &found.poses, held_out: &held_out, open: &open, mask: &mask })
}

fn trained(made: &Made, options: &Options, masked: bool) -> Scene {
    with_source(made, masked, |source| fit(source, splat::Engine::Cpu, options, None, &Silent).unwrap())
}

fn brief() -> Options {
    Options { iterations: 500, max_gaussians: 12_000, random_points: 6000, ..Options::default() }
}

/// Mean PSNR of held-out views against the photos as a camera of fixed exposure takes them, nothing moving; the whole
/// picture's colours fitted first, where `fitted`.
fn against_truth(made: &Made, s: &Scene, fitted: bool) -> f64 {
    let one = |v: &View| {
        let truth = image::open(made.at.join("truth/images").join(&v.name)).unwrap().into_rgb8();
        let truth = crate::bench::Picture::of_rgb(&truth).pixels;
        let map = if fitted { score::affine(&v.found.pixels, &truth) } else { NONE };
        let found: Vec<[f32; 3]> =
            v.found.pixels.iter().map(|x| applied(&map, *x).map(|v| v.clamp(0.0, 1.0))).collect();
        crate::bench::perception::psnr(&found, &truth)
    };
    let all: Vec<f64> = s.views.iter().filter(|v| v.role == Role::HeldOut).map(one).collect();
    all.iter().sum::<f64>() / all.len() as f64
}

static SITE: LazyLock<Made> = LazyLock::new(|| made(&PLAIN));
static BRIEF: LazyLock<Scene> = LazyLock::new(|| trained(&SITE, &brief(), false));

/// As sets come whose photos were halved after their cameras were found.
#[test]
fn photos_smaller_than_their_cameras_are_trained_on_at_their_own_size() {
    with_source(&SITE, false, |source| {
        let half = |p: &Posed| -> Result<Photo> {
            let photo = (source.open)(p)?;
            let (w, h) = photo.pixels.dimensions();
            Ok(Photo { pixels: image::imageops::thumbnail(&photo.pixels, w / 2, h / 2), ..photo })
        };
        let halved = Source { poses: source.poses, held_out: source.held_out, open: &half, mask: source.mask };
        let options = Options { iterations: 60, sky: Sky::On, ..brief() };
        let scene = fit(&halved, splat::Engine::Cpu, &options, None, &Silent).unwrap();
        let held_out: Vec<&View> = scene.views.iter().filter(|v| v.role == Role::HeldOut).collect();
        assert!(!held_out.is_empty() && held_out.iter().all(|v| v.truth.width == PLAIN.width as usize / 2));
        let psnr = held_out.iter().map(|v| crate::bench::perception::psnr(&v.found.pixels, &v.truth.pixels));
        let mean = psnr.sum::<f64>() / held_out.len() as f64;
        assert!(mean > 15.0, "{mean} dB: the cameras see what the photos show");
    });
}

#[test]
fn a_place_is_learnt_from_photos_and_met_from_where_none_was_taken() {
    let s = &*BRIEF;
    assert_eq!((s.held_out.photos, s.trained.photos), (3, 21));
    assert!(matches!(s.begun_from, From::Points(n) if n > 6000), "{:?}", s.begun_from);
    assert!(s.held_out.psnr > 22.5 && s.trained.psnr > 25.0, "{:?} {:?}", s.held_out, s.trained);
    assert!(s.held_out.ssim.unwrap() > 0.65, "{:?}", s.held_out);
    assert!(s.held_out.psnr_fitted.is_none() && s.held_out.lpips.is_none());
    // The sky is there, far outside, and last; as it was at the start: no more than a tenth of all, at its distance.
    assert!(s.sky > 500 && s.sky <= brief().max_gaussians / 10, "{} of {}", s.sky, s.gaussians.len());
    let first = s.gaussians.len() - s.sky;
    let far = sky::beyond(extent(s.cameras.iter().map(Camera::position)));
    assert!(s.gaussians.positions[first..].iter().all(|p| p.length() > 1.9 * far));
    assert!(s.gaussians.positions[..first].iter().all(|p| p.length() < 40.0));
    // Up is up: the ground's points say so.
    assert!(s.ground.is_some() && s.up_by == UpBy::Ground);
    let eye = s.cameras[0].position();
    assert!(eye.y < -0.5 && eye.z > 0.0, "{eye}");
    let without = trained(&SITE, &Options { sky: Sky::Off, ..brief() }, false);
    assert_eq!(without.sky, 0);
    assert!(s.held_out.psnr > without.held_out.psnr + 1.0, "{:?} {:?}", s.held_out, without.held_out);
}

#[test]
fn the_cap_holds_under_both_strategies_and_mcmc_fills_it() {
    let o = Options { iterations: 400, max_gaussians: 2500, ..brief() };
    for strategy in [Strategy::Paper, Strategy::Mcmc] {
        let s = trained(&SITE, &Options { strategy, ..o.clone() }, false);
        assert!(s.gaussians.len() <= 2500 && s.report.gaussians_before <= 2500, "{}", s.gaussians.len());
        // The sky is at most a tenth.
        assert!(
            s.sky > 50 && s.sky <= 250 && s.report.gaussians_before > 2000,
            "{} {}",
            s.sky,
            s.report.gaussians_before
        );
        match strategy {
            Strategy::Paper => assert!(s.held_out.psnr > 18.0, "{:?}", s.held_out),
            // It begins with points a tenth as wide, and 400 steps are few to fill what is between them.
            Strategy::Mcmc => {
                assert_eq!(s.gaussians.len(), 2500);
                let mean = |of: fn(&crate::splat::train::TargetReport) -> f32| {
                    s.report.targets.iter().map(of).sum::<f32>() / s.report.targets.len() as f32
                };
                let (before, after) = (mean(|t| t.before.picture), mean(|t| t.after.picture));
                assert!(after > before + 1.0, "{before} {after}");
            }
        }
    }
}

#[test]
fn exposures_are_compensated() {
    let drifting = made(&site::Options { exposure_drift: 0.35, ..PLAIN });
    let short = Options { iterations: 300, ..brief() };
    let with = trained(&drifting, &Options { exposure: true, ..short.clone() }, false);
    let without = trained(&drifting, &short, false);
    // Whatever the photo's own exposure, and as a camera of fixed exposure sees it.
    let own = with.held_out.psnr_fitted.unwrap();
    assert!(own > without.held_out.psnr + 3.0, "{own} {:?}", without.held_out);
    let (a, b) = (against_truth(&drifting, &with, true), against_truth(&drifting, &without, true));
    assert!(a > b + 0.3, "{a} {b}");
    assert!(with.trained.psnr > without.trained.psnr + 2.5, "{:?} {:?}", with.trained, without.trained);
    // What is learnt follows the truth: brighter photos have larger maps.
    let facts: serde_json::Value =
        serde_json::from_slice(&std::fs::read(drifting.at.join("truth/cameras.json")).unwrap()).unwrap();
    let mut pairs: Vec<(f64, f64)> = Vec::new();
    for (i, v) in with.views.iter().enumerate().filter(|(_, v)| v.role == Role::Trained) {
        let gain = facts["views"][i]["exposure_gain"][1].as_f64().unwrap().ln();
        let m = with.exposures[i][1];
        assert!(v.camera == with.cameras[i]);
        // What becomes of grey.
        pairs.push((gain, f64::from(0.5 * (m[0] + m[1] + m[2]) + m[3]).ln()));
    }
    let mean = |of: fn(&(f64, f64)) -> f64| pairs.iter().map(of).sum::<f64>() / pairs.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let sum = |of: &dyn Fn(&(f64, f64)) -> f64| pairs.iter().map(of).sum::<f64>();
    let correlation =
        sum(&|p| (p.0 - x) * (p.1 - y)) / (sum(&|p| (p.0 - x).powi(2)) * sum(&|p| (p.1 - y).powi(2))).sqrt();
    assert!(correlation > 0.95, "{correlation} {pairs:?}");
}

#[test]
fn a_mask_hides_what_moves() {
    let moving = made(&site::Options { moving: true, ..PLAIN });
    let short = Options { iterations: 300, ..brief() };
    let (with, without) = (trained(&moving, &short, true), trained(&moving, &short, false));
    // Where the van stands in the photos trained on, the scene shows what is behind it, not the van.
    let hidden = |s: &Scene| -> f64 {
        let (mut found, mut truth) = (Vec::new(), Vec::new());
        for v in s.views.iter().filter(|v| v.role == Role::Trained) {
            let open = |folder: &str| image::open(moving.at.join(folder).join(&v.name)).unwrap();
            let (clean, mask) = (open("truth/images").into_rgb8(), open("masks").into_luma8());
            let drawn = splat::render(&s.gaussians, &v.camera, s.behind);
            for ((color, clean), mask) in drawn.color.iter().zip(clean.pixels()).zip(mask.pixels()) {
                if mask.0[0] == 0 {
                    found.push(color.map(|c| c.clamp(0.0, 1.0)));
                    truth.push(clean.0.map(|c| f32::from(c) / 255.0));
                }
            }
        }
        crate::bench::perception::psnr(&found, &truth)
    };
    let (a, b) = (hidden(&with), hidden(&without));
    assert!(a > b + 2.0, "{a} with masks, {b} without");
    assert!(moving.folder.path().is_dir());
}

#[test]
fn nerfs_layout_is_trained_over_white_from_random_places() {
    let thing = made(&site::Options { nerf: true, count: 20, width: 64, ..PLAIN });
    let s = trained(&thing, &Options { iterations: 400, ..brief() }, false);
    assert!(matches!(s.begun_from, From::Random(n) if n > 3000), "{:?}", s.begun_from);
    assert_eq!((s.held_out.photos, s.trained.photos, s.sky, s.behind), (5, 20, 0, [1.0; 3]));
    assert!(s.held_out.psnr > 17.5, "{:?}", s.held_out);
    // Changing backgrounds leave the surroundings empty.
    let clear = trained(&thing, &Options { iterations: 400, background: Background::Changing, ..brief() }, false);
    let frame = crate::splat::render(&clear.gaussians, &clear.cameras[0], [0.0; 3]);
    assert!(
        frame.alpha[0] < 0.05 && frame.alpha[32 * 64 + 32] > 0.8,
        "{} {}",
        frame.alpha[0],
        frame.alpha[32 * 64 + 32]
    );
}

#[test]
fn the_same_seed_gives_the_same_scene_and_poses_are_refined_where_asked() {
    let o = Options { iterations: 60, max_gaussians: 3000, ..brief() };
    let run = |seed| trained(&SITE, &Options { seed, ..o.clone() }, false);
    let (a, b, c) = (run(1), run(1), run(2));
    assert!(a.gaussians == b.gaussians && a.gaussians != c.gaussians);
    let refined = |refine_untried| trained(&SITE, &Options { refine_poses: true, refine_untried, ..o.clone() }, false);
    let untried = refined(true);
    assert!(untried.cameras[1] != a.cameras[1] && untried.cameras[0] == a.cameras[0], "the first is held out");
    // The poses are the true ones: a trial finds nothing to gain.
    assert!(refined(false).cameras == a.cameras);
}

#[test]
fn what_cannot_be_trained_on_is_refused() {
    let found = dataset::find(&SITE.at, None).unwrap().unwrap();
    let open = |p: &Posed| -> Result<Photo> {
        let bytes = std::fs::read(&p.file).unwrap();
        Ok(photo::decode_as_stored(&p.name, &bytes, &photo::Limits::default())?.0)
    };
    let all = vec![true; found.poses.photos.len()];
    let source = |held_out, mask| Source { poses: &found.poses, held_out, open: &open, mask };
    let o = Options { iterations: 1, ..brief() };
    let fit = |s: Source| fit(&s, splat::Engine::Cpu, &o, None, &Silent).map(|_| ()).unwrap_err().to_string();
    assert!(fit(source(&all, &|_| Ok(None))).contains("--test-every"));
    let small = |_| Ok(Some(image::GrayImage::new(5, 5)));
    assert!(fit(source(&[], &small)).contains("the mask of 000.png"));
    let at_one_place = Poses {
        photos: found.poses.photos.iter().map(|p| Posed { translation: DVec3::ZERO, ..p.clone() }).collect(),
        ..found.poses.clone()
    };
    assert!(unit_frame(&at_one_place, None, 0).unwrap_err().to_string().contains("one place"));
}
