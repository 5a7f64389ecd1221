//! Two to five photos whose cameras nobody knows: each further photo's pose is searched against the Gaussians that the network
//! makes of the best one.

use std::path::PathBuf;

use glam::{DMat3, DQuat, Mat3, Quat, Vec3};
use rayon::prelude::*;

use super::GREY;
use crate::models::pattern_search::pattern_search;
use crate::models::scene;
use crate::models::splat_prior::{self, OneView, Taken};
use crate::models::{Engine, prior};
use crate::photo::{Edge, Photo, Plane, Rect, sample_plane};
use crate::photos::colmap::{self, Lens};
use crate::photos::{Posed, Poses};
use crate::progress::Progress;
use crate::splat::{self, Camera, Gaussians};
use crate::{Error, Kind, Result, symmetry, views};

/// More photos want a program that matches them.
pub const MOST: usize = 5;
/// Pixels across the pictures that are compared.
const SIDE: usize = 64;
/// Degrees between the first guesses, and how far the network's own elevation is doubted.
const AZIMUTH_STEP: f32 = 10.0;
const ELEVATIONS: [f32; 3] = [-10.0, 0.0, 10.0];
/// As many of the best guesses are refined.
const REFINED: usize = 6;
/// What a colour's difference (0..1) counts beside the silhouettes' overlap (0..1).
const COLOUR: f32 = 1.5;
/// A photo whose best pose scores less is not used.
const CONVINCES: f32 = 0.45;

/// What the network made of a photo, and the photo's size.
struct Seen {
    name: String,
    file: PathBuf,
    size: (u32, u32),
    view: OneView,
    fitness: f32,
}

/// A photo's crop, small.
struct Small {
    mask: Plane,
    colour: Vec<[f32; 3]>,
    bounds: [f32; 4],
}

/// Poses in the frame of the best photo's Gaussians. Focal lengths are those under which the silhouettes meet: they stand for
/// no lens, and the distances with them for no length.
///
/// # Errors
/// Usage where fewer than two photos can be placed; as the networks.
pub fn search(
    files: &[PathBuf],
    open: &dyn Fn(&PathBuf) -> Result<Photo>,
    engine: &dyn Engine,
    progress: &dyn Progress,
) -> Result<Poses> {
    let (networks, splat_graph) = (scene::Networks::built_in(engine)?, prior::SPLAT.loaded(engine)?);
    let (mut all, mut notes) = (Vec::new(), Vec::new());
    progress.begin("pose search", 2 * files.len() as u64);
    for (i, file) in files.iter().enumerate() {
        progress.check()?;
        let photo = open(file)?;
        let made = scene::subject(&photo.pixels, photo.cutout.as_ref(), None, &networks).and_then(|s| {
            // As it is: the pose that is searched is that of the photo.
            let taken = Taken { lens: photo.pinhole(), elevation: None, aim: None };
            splat_prior::one_view(&photo.pixels, &s, &taken, &*splat_graph)
        });
        match made {
            Err(e) if e.kind == Kind::Usage => notes.push(format!("{} is not used: {}", photo.name, e.found)),
            Err(e) => return Err(e),
            Ok(view) => {
                let off = (view.elevation.to_degrees() - 15.0) / 25.0;
                let fitness = view.silhouette_iou * (-off * off).exp();
                let size = photo.pixels.dimensions();
                all.push(Seen { name: photo.name, file: file.clone(), size, view, fitness });
            }
        }
        progress.step(i as u64 + 1);
    }
    let Some(best) = (0..all.len()).max_by(|a, b| all[*a].fitness.total_cmp(&all[*b].fitness)) else {
        return Err(too_few(0, &notes));
    };
    let reference = &all[best].view;
    // The far side is the near one's mirror image where the subject has a plane of symmetry: better than the network's guess.
    let seen = symmetry::Seen { camera: reference.camera, color: &reference.colour, mask: &reference.mask.data };
    let found = symmetry::find(&reference.gaussians, &seen, symmetry::Use::Evident);
    let body = symmetry::complete(&reference.gaussians, &seen, &symmetry::used(&found)).gaussians;
    let mut photos = Vec::new();
    for (i, seen) in all.iter().enumerate() {
        progress.check()?;
        if i == best {
            photos.push(posed(seen, &seen.view.camera));
            continue;
        }
        let (camera, score) = place(&body, &seen.view);
        if score >= CONVINCES {
            photos.push(posed(seen, &camera));
        } else {
            notes.push(format!("{} is not used: no pose of it convinces ({score:.2})", seen.name));
        }
        progress.step((files.len() + i + 1) as u64);
    }
    if photos.len() < 2 {
        return Err(too_few(photos.len(), &notes));
    }
    photos.sort_by(|a, b| a.name.cmp(&b.name));
    let source = format!("searched by silhouettes and colours against the network's Gaussians of {}", all[best].name);
    Ok(Poses { photos, points: Vec::new(), observations: Vec::new(), source, files: Vec::new(), notes })
}

fn too_few(found: usize, notes: &[String]) -> Error {
    Error::usage("photos")
        .expected("at least two photos of one subject whose poses can be found")
        .found(format!("{found}; {}", notes.join("; ")))
        .advice("Give --poses, or more photos and --sfm colmap.")
}

/// The camera of the crop as one of the whole photo.
fn posed(seen: &Seen, crop: &Camera) -> Posed {
    let k = f64::from(seen.view.crop.rect.width) / f64::from(crop.width);
    let at = |c: f32, from: f32| f64::from(from) + f64::from(c) * k;
    let parameters = vec![
        f64::from(crop.fx) * k,
        f64::from(crop.fy) * k,
        at(crop.cx, seen.view.crop.rect.x),
        at(crop.cy, seen.view.crop.rect.y),
    ];
    let turn = DMat3::from_cols_array(&crop.rotation.to_cols_array().map(f64::from));
    Posed {
        name: seen.name.clone(),
        file: seen.file.clone(),
        camera: colmap::Camera { lens: Lens::Pinhole, width: seen.size.0, height: seen.size.1, parameters },
        rotation: DQuat::from_mat3(&turn).normalize(),
        translation: crop.translation.as_dvec3(),
    }
}

impl Small {
    fn of(view: &OneView) -> Small {
        let side = view.mask.width;
        let whole = Rect { x: 0.0, y: 0.0, width: side as f32, height: side as f32 };
        let channel = |k: usize| {
            let data = view.colour.iter().map(|c| c[k]).collect();
            sample_plane(&Plane { width: side, height: side, data }, whole, SIDE, SIDE, Edge::Clamp)
        };
        let planes = [channel(0), channel(1), channel(2)];
        let mask = sample_plane(&view.mask, whole, SIDE, SIDE, Edge::Clamp);
        let colour = (0..SIDE * SIDE).map(|i| std::array::from_fn(|k| planes[k].data[i])).collect();
        let bounds = bounds(&mask.data).unwrap_or([0.0, 0.0, SIDE as f32, SIDE as f32]);
        Small { mask, colour, bounds }
    }
}

/// Left, top, right, bottom of what is above one half.
fn bounds(mask: &[f32]) -> Option<[f32; 4]> {
    let mut b = [f32::INFINITY, f32::INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY];
    for (i, _) in mask.iter().enumerate().filter(|(_, v)| **v > 0.5) {
        let (x, y) = ((i % SIDE) as f32, (i / SIDE) as f32);
        b = [b[0].min(x), b[1].min(y), b[2].max(x + 1.0), b[3].max(y + 1.0)];
    }
    b[0].is_finite().then_some(b)
}

/// Azimuth and elevation, degrees, and roll.
type Guess = [f32; 3];

/// A camera as far away as the network had the photo's, zoomed and shifted until the boxes of silhouette and mask meet, and how
/// well the pictures then agree: silhouettes' intersection over union less the colours' difference where both are.
fn judged(body: &Gaussians, view: &OneView, small: &Small, [azimuth, elevation, roll]: Guess) -> (Camera, f32) {
    let own = view.camera.resized(SIDE as u32, SIDE as u32);
    let eye = views::eye(azimuth, elevation, own.position().length());
    let look = Camera::look_at(eye, Vec3::ZERO, views::FOV, SIDE as u32);
    let turn = Mat3::from_quat(Quat::from_rotation_z(roll.to_radians()));
    let camera = Camera { rotation: turn * look.rotation, translation: turn * look.translation, ..own };
    let seen = splat::render(body, &camera, GREY);
    let Some(found) = bounds(&seen.alpha) else { return (camera, 0.0) };
    let size = |b: &[f32; 4]| (b[2] - b[0]).hypot(b[3] - b[1]);
    let zoom = size(&small.bounds) / size(&found);
    let shifted =
        |k: usize, c: f32| (small.bounds[k] + small.bounds[k + 2]) / 2.0 - ((found[k] + found[k + 2]) / 2.0 - c) * zoom;
    let camera = Camera {
        fx: camera.fx * zoom,
        fy: camera.fy * zoom,
        cx: shifted(0, camera.cx),
        cy: shifted(1, camera.cy),
        ..camera
    };
    let seen = splat::render(body, &camera, GREY);
    let (mut both, mut either, mut apart) = (0.0f32, 0.0f32, 0.0f32);
    for i in 0..SIDE * SIDE {
        let (a, b) = (seen.alpha[i] > 0.5, small.mask.data[i] > 0.5);
        either += f32::from(u8::from(a || b));
        if a && b {
            both += 1.0;
            apart += (0..3).map(|k| (seen.color[i][k] - small.colour[i][k]).abs()).sum::<f32>() / 3.0;
        }
    }
    (camera, both / either.max(1.0) - COLOUR * apart / both.max(1.0))
}

/// The best pose of a photo before a body: guesses all around, the best of them refined by a [`pattern_search`].
fn place(body: &Gaussians, view: &OneView) -> (Camera, f32) {
    let small = Small::of(view);
    let own = view.elevation.to_degrees();
    let around = (360.0 / AZIMUTH_STEP) as usize;
    let guesses: Vec<Guess> = (0..around)
        .flat_map(|i| ELEVATIONS.map(|e| [i as f32 * AZIMUTH_STEP, (own + e).clamp(-20.0, 80.0), 0.0]))
        .collect();
    let mut scored: Vec<(f32, Guess)> = guesses.into_par_iter().map(|g| (judged(body, view, &small, g).1, g)).collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0));
    let cost = |g: Guess| match g[2].abs() < 20.0 && (-30.0..85.0).contains(&g[1]) {
        true => -f64::from(judged(body, view, &small, g).1),
        false => f64::INFINITY,
    };
    let refined = scored.into_iter().take(REFINED).map(|(_, g)| pattern_search(g, [5.0, 4.0, 3.0], 0.12, cost));
    let (guess, _) = refined.fold(([0.0; 3], f64::INFINITY), |a, b| if b.1 < a.1 { b } else { a });
    judged(body, view, &small, guess)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::splat_prior::{Window, canonical_camera};
    use crate::photos::start::of_points;

    /// A truck of two colours: a long box and a cab at one end.
    fn truck() -> Gaussians {
        let mut points = Vec::new();
        let mut block = |low: [f32; 3], high: [f32; 3], color: [u8; 3]| {
            for i in 0..13 * 13 * 13 {
                let k = [i % 13, i / 13 % 13, i / 169];
                if k.iter().any(|v| *v == 0 || *v == 12) {
                    points.push((
                        Vec3::from_array(std::array::from_fn(|a| low[a] + (high[a] - low[a]) * k[a] as f32 / 12.0)),
                        color,
                    ));
                }
            }
        };
        block([-0.3, -0.7, -0.35], [0.3, 0.7, 0.0], [200, 60, 40]);
        block([-0.3, 0.3, 0.0], [0.3, 0.7, 0.4], [40, 80, 200]);
        let mut g = of_points(&points);
        g.log_scales.iter_mut().for_each(|s| *s = Vec3::splat(0.045f32.ln()));
        g.logit_opacities.iter_mut().for_each(|o| *o = 5.0);
        g
    }

    #[test]
    fn a_photo_is_placed_before_a_body() {
        let g = truck();
        for (azimuth, elevation) in [(70.0, 12.0), (200.0, 25.0), (305.0, 8.0)] {
            // Another lens from another place than the guess: nearer, the subject off the middle.
            let truth = Camera::look_at(views::eye(azimuth, elevation, 3.5), Vec3::ZERO, 0.7, 128);
            let truth = Camera { cx: truth.cx + 6.0, ..truth };
            let seen = splat::render(&g, &truth, [0.0; 3]);
            let straight = |(c, a): (&[f32; 3], &f32)| c.map(|v| (v / a.max(1e-3)).clamp(0.0, 1.0));
            let view = OneView {
                expected_errors: None,
                gaussians: Gaussians::default(),
                elevation: (elevation + 6.0f32).to_radians(),
                camera: canonical_camera(0.3, 128),
                seen_from: crate::models::scene::Angle { mean: 0.0, spread: 0.05 },
                silhouette_iou: 1.0,
                crop: Window { rect: Rect { x: 10.0, y: 20.0, width: 256.0, height: 256.0 }, turned: None },
                colour: seen.color.iter().zip(&seen.alpha).map(straight).collect(),
                mask: Plane { width: 128, height: 128, data: seen.alpha.clone() },
            };
            let (camera, score) = place(&g, &view);
            let off = camera.position().angle_between(truth.position()).to_degrees();
            assert!(off < 6.0 && score > 0.75, "{azimuth}: {off}° off, score {score}");
        }
    }
}
