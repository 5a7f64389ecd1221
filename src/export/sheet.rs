//! `preview.png` of a scene: photos that it never saw beside what it shows there, and the scene from around.

use image::RgbImage;

use super::marked_png;
use crate::audit::Marking;
use crate::bench::Picture;
use crate::pipeline::scene::{Role, Scene, View};
use crate::preview::{self, Tile};
use crate::splat::render::Drawer;
use crate::{Result, views};

/// Photos on the sheet.
const PHOTOS: usize = 3;
/// Differences are shown so many times as large.
const LOUDER: f32 = 4.0;

/// Held-out photos, else ones trained on: photo, Gaussians, difference; then the scene from four sides.
pub fn scene_png(scene: &Scene, marking: &Marking) -> Result<Vec<u8>> {
    let of = |role: Role| scene.views.iter().filter(|v| v.role == role).collect::<Vec<&View>>();
    let held_out = of(Role::HeldOut);
    let shown = if held_out.is_empty() { of(Role::Trained) } else { held_out };
    let step = shown.len().div_ceil(PHOTOS).max(1);
    let small = |p: &Picture| -> RgbImage {
        let image = p.to_rgb();
        let scale = (768.0 / f64::from(image.width().max(image.height()))).min(1.0);
        let side = |v: u32| ((f64::from(v) * scale).round() as u32).max(1);
        image::imageops::thumbnail(&image, side(image.width()), side(image.height()))
    };
    let mut rows: Vec<Vec<Tile>> = shown
        .iter()
        .step_by(step)
        .map(|v| {
            let pairs = v.truth.pixels.iter().zip(&v.found.pixels);
            let off = pairs.map(|(a, b)| [0, 1, 2].map(|k| (LOUDER * (a[k] - b[k]).abs()).min(1.0))).collect();
            let difference = Picture { pixels: off, ..v.truth };
            let what = if v.role == Role::HeldOut { "held out" } else { "trained on" };
            vec![
                Tile { image: small(&v.truth), caption: format!("{} ({what})", v.name) },
                Tile { image: small(&v.found), caption: format!("Gaussians, {:.1} dB", v.scores.psnr) },
                Tile { image: small(&difference), caption: format!("difference x {LOUDER}") },
            ]
        })
        .collect();
    let mut drawer = Drawer::new(&scene.gaussians);
    drawer.depth = false;
    rows.push(
        [0.0, 90.0, 180.0, 270.0]
            .into_iter()
            .map(|azimuth| {
                let frame = drawer.render(&views::orbit(azimuth, 25.0, 2.2, 384), scene.behind);
                let image = preview::from_floats(frame.width, frame.height, &frame.color);
                Tile { image, caption: format!("from {azimuth}") }
            })
            .collect(),
    );
    marked_png(&preview::sheet(&rows, &marking.banner()).into(), marking)
}
