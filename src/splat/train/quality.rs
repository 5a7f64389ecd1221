//! How near the render comes to a target, in decibels.

use super::exposure::{NONE, applied};
use super::{Behind, Checkpoint, Target};
use crate::splat::render::Raster;
use crate::splat::render::binning::TILE;
use crate::splat::render::projection::{Shown, View};

/// PSNR in dB, both pictures over mid-grey or the fixed background, the render clamped to 0..1; of normals, over
/// nothing and clamped to −1..1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Over pixels trained on, inside the mask (alpha > ½).
    pub subject: f32,
    /// Over all pixels trained on.
    pub picture: f32,
    /// Over the held-back pixels, inside the mask.
    pub held_back: Option<f32>,
}

/// Of every target, under its exposure.
pub fn measure(raster: &mut Raster, at: &Checkpoint, targets: &[Target], behind: Behind) -> Vec<Quality> {
    let behind = match behind {
        Behind::Changing => [0.5; 3],
        Behind::Fixed(color) => color,
    };
    at.cameras
        .iter()
        .zip(&at.exposures)
        .zip(targets)
        .map(|((camera, exposure), target)| {
            let view = View { shown: target.shown, ..View::new(camera) };
            let (behind, least) = match target.shown {
                Shown::Color => (behind, 0.0),
                Shown::Normals => ([0.0; 3], -1.0),
            };
            raster.bins.build(&at.gaussians, &view, 3);
            raster.forward(&view, None);
            // Σ of squares and their number: subject, picture, held back.
            let mut sums = [[0.0f64; 2]; 3];
            for (i, (wanted, alpha)) in target.color.iter().zip(&target.alpha).enumerate() {
                let (x, y) = (i % view.width, i / view.width);
                let tile = &raster.tiles[y / TILE * raster.bins.tiles_x + x / TILE];
                let at = y % TILE * TILE + x % TILE;
                let through = tile.transmittance[at].abs();
                let mut square = 0.0;
                let mut drawn = [0, 1, 2].map(|c| tile.color[c][at] + behind[c] * through);
                if exposure.change != NONE {
                    drawn = applied(&exposure.change, drawn);
                }
                for ((wanted, drawn), behind) in wanted.iter().zip(drawn).zip(behind) {
                    let e = (drawn.clamp(least, 1.0) - (wanted * alpha + behind * (1.0 - alpha))) as f64;
                    square += e * e / 3.0;
                }
                let held = target.held_back.as_ref().is_some_and(|h| h[i]);
                let subject = *alpha > 0.5;
                for (sum, counted) in sums.iter_mut().zip([subject && !held, !held, subject && held]) {
                    if counted {
                        sum[0] += square;
                        sum[1] += 1.0;
                    }
                }
            }
            let [subject, picture, held] = sums.map(|[s, n]| decibels(s / n.max(1.0)));
            Quality { subject, picture, held_back: (sums[2][1] > 0.0).then_some(held) }
        })
        .collect()
}

/// At most 100: equal pictures have no finite PSNR.
fn decibels(mean_square: f64) -> f32 {
    (-10.0 * mean_square.max(1e-10).log10()) as f32
}
