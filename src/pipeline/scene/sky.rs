//! The sky as Gaussians far outside of everything: where photos from different places see the same plain colour in the same
//! direction, nothing that is near can stand.

use glam::{Quat, Vec3};
use rayon::prelude::*;

use super::begin::{flat, pixel};
use crate::splat::{Gaussians, Target};

/// Distance of the sky, in extents of the scene.
const FAR: f32 = 60.0;
/// Directions over the whole sphere, where the cap allows it.
const DIRECTIONS: usize = 24_000;
/// The sky begins with at most this part of the Gaussians.
const SHARE: usize = 10;
/// Colours of one direction that differ more (standard deviation of a channel, sRGB) are of something near.
const ALIKE: f32 = 0.05;
/// Nor is a direction sky where the photo itself changes so much around it.
const PLAIN: f32 = 0.04;
/// Below this the ground is expected: sine of the elevation. And where not several photos say that it is sky.
const LOWEST: f32 = -0.03;
const LOWEST_ALONE: f32 = 0.05;

/// Sky that photos see.
pub struct Seen {
    pub gaussians: Gaussians,
    /// Of the directions above the horizon that at least two photos see, the share that is sky.
    pub share: f32,
}

/// Whether it is worth having: a tenth of what is seen above the horizon, and enough of it.
pub fn is_plain(s: &Seen) -> bool {
    s.share > 0.1 && s.gaussians.len() >= 30
}

/// Discs side by side on a sphere, of the colour that the photos see there. `None` where they see none. `most`: of all
/// Gaussians of the scene.
pub fn seen(targets: &[Target], extent: f32, most: usize) -> Option<Seen> {
    let directions = DIRECTIONS.min(2 * most / SHARE).max(64);
    let radius = FAR * extent;
    let photos: Vec<&Target> = targets.iter().filter(|t| t.weight > 0.0).collect();
    // Fibonacci's lattice: all as far apart.
    let golden = std::f32::consts::PI * (3.0 - 5f32.sqrt());
    let direction = |i: usize| {
        let z = 1.0 - 2.0 * (i as f32 + 0.5) / directions as f32;
        let (sin, cos) = (golden * i as f32).sin_cos();
        Vec3::new((1.0 - z * z).sqrt() * cos, (1.0 - z * z).sqrt() * sin, z)
    };
    let above: Vec<Vec3> = (0..directions).map(direction).filter(|d| d.z > LOWEST).collect();
    let looks: Vec<Look> = above.par_iter().map(|d| look(&photos, *d * radius)).collect();
    let asked = looks.iter().filter(|l| matches!(l, Look::Sky(_) | Look::Other)).count();
    let sure: Vec<(Vec3, [f32; 3])> = above.iter().zip(&looks).filter_map(|(d, l)| Some((*d, l.sky()?))).collect();
    if sure.is_empty() {
        return None;
    }
    let colors: Vec<Option<[f32; 3]>> = above
        .par_iter()
        .zip(&looks)
        .map(|(d, l)| match l {
            Look::Other => None,
            Look::Sky(color) => Some(*color),
            // Near the horizon something may stand that no photo shows.
            Look::Once(color) => (d.z > LOWEST_ALONE).then_some(*color),
            Look::Unseen => (d.z > LOWEST_ALONE).then(|| around(*d, &sure)),
        })
        .collect();
    let mut g = Gaussians::default();
    // The mean distance of neighbours on the sphere.
    let spacing = radius * (4.0 * std::f32::consts::PI / directions as f32).sqrt();
    for (d, color) in above.iter().zip(colors).filter_map(|(d, c)| Some((d, c?))) {
        let q = Quat::from_rotation_arc(Vec3::Z, *d);
        g.positions.push(*d * radius);
        g.log_scales.push(Vec3::new(0.6 * spacing, 0.6 * spacing, 0.1 * spacing).map(f32::ln));
        g.rotations.push([q.w, q.x, q.y, q.z]);
        g.logit_opacities.push(2.0);
        g.sh.push(flat(color));
    }
    Some(Seen { share: sure.len() as f32 / asked.max(1) as f32, gaussians: g })
}

/// What photos say of a direction.
#[derive(Clone, Copy)]
enum Look {
    /// Several see the same plain colour.
    Sky([f32; 3]),
    /// One sees a plain colour.
    Once([f32; 3]),
    /// Something is there.
    Other,
    Unseen,
}

impl Look {
    fn sky(&self) -> Option<[f32; 3]> {
        match self {
            Look::Sky(color) => Some(*color),
            _ => None,
        }
    }
}

/// The colour of the sky that is seen around a direction: a mean, the nearer the heavier.
fn around(d: Vec3, sure: &[(Vec3, [f32; 3])]) -> [f32; 3] {
    let (mut sum, mut total) = ([0.0f32; 3], 1e-30f32);
    for (e, color) in sure {
        // Half of it at some ten degrees; as far as it goes where nothing is nearer.
        let w = (1.0 - d.dot(*e) + 0.01).powi(-3);
        total += w;
        (0..3).for_each(|k| sum[k] += w * color[k]);
    }
    sum.map(|v| v / total)
}

fn look(photos: &[&Target], at: Vec3) -> Look {
    let mut colors: Vec<[f32; 3]> = Vec::new();
    let mut plain = 0usize;
    for t in photos {
        let Some([x, y]) = pixel(&t.camera, at) else { continue };
        let (w, h) = (t.camera.width as usize, t.camera.height as usize);
        let (x, y) = ((x as usize).min(w - 1), (y as usize).min(h - 1));
        let i = y * w + x;
        if t.held_back.as_ref().is_some_and(|held| held[i]) || t.alpha[i] < 1.0 {
            continue;
        }
        colors.push(t.color[i]);
        let reach = (w.max(h) / 200).max(1);
        let beside = [
            (x.saturating_sub(reach), y),
            ((x + reach).min(w - 1), y),
            (x, y.saturating_sub(reach)),
            (x, (y + reach).min(h - 1)),
        ];
        let differs = |(u, v): (usize, usize)| (0..3).any(|c| (t.color[v * w + u][c] - t.color[i][c]).abs() > PLAIN);
        plain += usize::from(!beside.into_iter().any(differs));
    }
    let n = colors.len();
    match n {
        0 => return Look::Unseen,
        1 if plain == 1 => return Look::Once(colors[0]),
        1 => return Look::Other,
        _ => {}
    }
    let mean: [f32; 3] = std::array::from_fn(|c| colors.iter().map(|v| v[c]).sum::<f32>() / n as f32);
    let deviation = |c: usize| (colors.iter().map(|v| (v[c] - mean[c]).powi(2)).sum::<f32>() / n as f32).sqrt();
    // Exposures that differ change all channels alike: compared once more with brightness taken out.
    let tint = |c: usize| {
        let share = |v: &[f32; 3]| v[c] / (v[0] + v[1] + v[2]).max(1e-3);
        let m = colors.iter().map(share).sum::<f32>() / n as f32;
        (colors.iter().map(|v| (share(v) - m).powi(2)).sum::<f32>() / n as f32).sqrt()
    };
    let alike = (0..3).all(|c| deviation(c) < ALIKE);
    let alike = alike || (0..3).all(|c| deviation(c) < 3.0 * ALIKE && tint(c) < 0.3 * ALIKE);
    if alike && 4 * plain >= 3 * n { Look::Sky(mean) } else { Look::Other }
}

/// The Gaussians with the sky's at the end, and how many those are.
pub fn last(g: Gaussians, extent: f32) -> (Gaussians, usize) {
    let far = 0.5 * FAR * extent;
    let is_sky = |i: usize| g.positions[i].length() > far;
    let count = (0..g.len()).filter(|i| is_sky(*i)).count();
    if count == 0 {
        return (g, 0);
    }
    let mut out = g.filtered(|i| !is_sky(i));
    out.extend(&g.filtered(is_sky));
    (out, count)
}
