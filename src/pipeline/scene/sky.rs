//! The sky as Gaussians far outside of everything: where photos from different places see the same plain colour in the same
//! direction, nothing that is near can stand.

use glam::{Quat, Vec3};
use rayon::prelude::*;

use super::begin::{flat, pixel};
use crate::mesh::fibonacci_sphere;
use crate::splat::{Gaussians, Target};

/// Distance of the sky, in extents of the scene.
const FAR: f32 = 200.0;
/// Beyond this part of that distance Gaussians are the sky's: they keep their number and places.
const BEYOND: f32 = 0.5;
/// The sky takes at most this part of the Gaussians, and no more than so many.
const SHARE: usize = 10;
const MOST: usize = 60_000;
/// Of those, the part that stands behind all others over the whole dome, seen or not.
const DOME_SHARE: usize = 10;
const DOME_MOST: usize = 1000;
/// The dome stands so many times farther out: it closes what is between the others.
const DOME: f32 = 1.25;
/// Directions by which it is found out how much of the sphere is sky.
const PROBED: usize = 4096;
/// No finer than so many pixels of the photos.
const PIXELS: f32 = 1.5;
/// Standard deviations in mean distances of neighbours, of the discs and of the dome, and logit of the opacity: with these
/// 98.4 and 99.9 % are covered at the worst place of a hexagonal lattice.
const WIDTH: f32 = 0.7;
const DOME_WIDTH: f32 = 0.9;
const LOGIT: f32 = 3.0;
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

/// How far from the origin everything is the sky's.
pub fn beyond(extent: f32) -> f32 {
    BEYOND * FAR * extent
}

/// The mean angle between neighbours of `n` directions.
fn spacing(n: usize) -> f32 {
    (4.0 * std::f32::consts::PI / n as f32).sqrt()
}

/// Discs side by side on a sphere where photos see the sky, of the colour that they see, and wide ones behind them over all
/// that is above the horizon. `None` where no photo sees any. `most`: of all Gaussians of the scene.
pub fn seen(targets: &[Target], extent: f32, most: usize) -> Option<Seen> {
    let radius = FAR * extent;
    let photos: Vec<&Target> = targets.iter().filter(|t| t.weight > 0.0).collect();
    let looks = |n: usize| -> Vec<(Vec3, Look)> {
        let above: Vec<Vec3> = fibonacci_sphere(n).into_iter().filter(|d| d.z > LOWEST).collect();
        above.into_par_iter().map(|d| (d, look(&photos, d * radius))).collect()
    };
    let probed = looks(PROBED);
    let asked = probed.iter().filter(|(_, l)| matches!(l, Look::Sky(_) | Look::Other)).count();
    let sure: Vec<(Vec3, [f32; 3])> = probed.iter().filter_map(|(d, l)| Some((*d, l.sky()?))).collect();
    if sure.is_empty() {
        return None;
    }
    let shown = probed.iter().filter(|(d, l)| l.shown(*d).is_some()).count().max(1);
    let all = (most / SHARE).clamp(30, MOST);
    let dome = (all / DOME_SHARE).clamp(20, DOME_MOST);
    // So many over the whole sphere that those where sky is seen are what is left.
    let finest = photos.iter().map(|t| t.camera.fx.max(t.camera.fy)).fold(1.0, f32::max);
    let pixels = 4.0 * std::f32::consts::PI * (finest / PIXELS).powi(2);
    // Twice as many over the sphere as are above the horizon.
    let behind: Vec<Vec3> = fibonacci_sphere(2 * dome).into_iter().filter(|d| d.z > LOWEST).collect();
    let left = all.saturating_sub(behind.len()).max(1);
    let mut fine = (left * PROBED / shown).min(pixels as usize).max(64);
    let discs = |n: usize| -> Vec<(Vec3, [f32; 3])> {
        looks(n).into_iter().filter_map(|(d, l)| Some((d, l.shown(d)?))).collect()
    };
    let mut before = discs(fine);
    // The probe's share is not exact.
    while before.len() > left && fine > 64 {
        fine = (fine * left / before.len()).min(fine - fine / 100 - 1).max(64);
        before = discs(fine);
    }
    let mut g = Gaussians::default();
    let mut disc = |d: Vec3, color: [f32; 3], radius: f32, width: f32| {
        let q = Quat::from_rotation_arc(Vec3::Z, d);
        let wide = width * radius;
        g.positions.push(d * radius);
        g.log_scales.push(Vec3::new(wide, wide, 0.1 * wide).map(f32::ln));
        g.rotations.push([q.w, q.x, q.y, q.z]);
        g.logit_opacities.push(LOGIT);
        g.sh.push(flat(color));
    };
    before.into_iter().for_each(|(d, c)| disc(d, c, radius, WIDTH * spacing(fine)));
    let colors: Vec<[f32; 3]> = behind.par_iter().map(|d| around(*d, &sure)).collect();
    behind.into_iter().zip(colors).for_each(|(d, c)| disc(d, c, DOME * radius, DOME_WIDTH * spacing(2 * dome)));
    Some(Seen { share: sure.len() as f32 / asked.max(1) as f32, gaussians: g })
}

/// What photos say of a direction.
#[derive(Clone, Copy)]
enum Look {
    /// Several see the same plain colour.
    Sky([f32; 3]),
    /// One sees a plain colour.
    Once([f32; 3]),
    /// Several see the same plain colour, others something before it.
    Some([f32; 3]),
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

    /// The colour where a disc of its own is worth having. Near the horizon something may stand that no photo shows.
    fn shown(&self, d: Vec3) -> Option<[f32; 3]> {
        match self {
            Look::Sky(color) => Some(*color),
            Look::Once(color) | Look::Some(color) if d.z > LOWEST_ALONE => Some(*color),
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
    let mut plain: Vec<[f32; 3]> = Vec::new();
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
        if !beside.into_iter().any(differs) {
            plain.push(t.color[i]);
        }
    }
    match (colors.len(), plain.len()) {
        (0, _) => return Look::Unseen,
        (1, 1) => return Look::Once(colors[0]),
        (1, _) => return Look::Other,
        _ => {}
    }
    if 4 * plain.len() >= 3 * colors.len() && alike(&colors) {
        return Look::Sky(mean(&colors));
    }
    // Something stands before it in some: what most of the others agree on, the median's neighbours.
    let median: [f32; 3] = std::array::from_fn(|c| {
        let mut of: Vec<f32> = plain.iter().map(|v| v[c]).collect();
        of.sort_by(f32::total_cmp);
        of.get(of.len() / 2).copied().unwrap_or(0.0)
    });
    let near = |v: &&[f32; 3]| (0..3).all(|c| (v[c] - median[c]).abs() < 2.0 * ALIKE);
    let agreed: Vec<[f32; 3]> = plain.iter().filter(near).copied().collect();
    if agreed.len() >= 2 && 2 * agreed.len() >= colors.len() && alike(&agreed) {
        return Look::Some(mean(&agreed));
    }
    Look::Other
}

fn mean(colors: &[[f32; 3]]) -> [f32; 3] {
    std::array::from_fn(|c| colors.iter().map(|v| v[c]).sum::<f32>() / colors.len().max(1) as f32)
}

/// Whether photos see the same.
fn alike(colors: &[[f32; 3]]) -> bool {
    let spread = |of: &dyn Fn(&[f32; 3]) -> f32| {
        let n = colors.len().max(1) as f32;
        let m = colors.iter().map(of).sum::<f32>() / n;
        (colors.iter().map(|v| (of(v) - m).powi(2)).sum::<f32>() / n).sqrt()
    };
    let deviation = |c: usize| spread(&|v| v[c]);
    // Exposures that differ change all channels alike: compared once more with brightness taken out.
    let tint = |c: usize| spread(&|v| v[c] / (v[0] + v[1] + v[2]).max(1e-3));
    (0..3).all(|c| deviation(c) < ALIKE) || (0..3).all(|c| deviation(c) < 3.0 * ALIKE && tint(c) < 0.3 * ALIKE)
}

/// The Gaussians with the sky's at the end, and how many those are.
pub fn last(g: Gaussians, extent: f32) -> (Gaussians, usize) {
    let far = beyond(extent);
    let is_sky = |i: usize| g.positions[i].length() > far;
    let count = (0..g.len()).filter(|i| is_sky(*i)).count();
    if count == 0 {
        return (g, 0);
    }
    let mut out = g.filtered(|i| !is_sky(i));
    out.extend(&g.filtered(is_sky));
    (out, count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splat::render::Shown;
    use crate::splat::{Camera, render};

    /// Blue above, white at the horizon.
    fn blue(d: Vec3) -> [f32; 3] {
        [0.8 - 0.5 * d.z.max(0.0), 0.85 - 0.3 * d.z.max(0.0), 0.9]
    }

    /// From eight places around, a little upwards: sky, ground below it, and before the sky a wall seen from half of them.
    fn photos() -> Vec<Target> {
        (0..8)
            .map(|k| {
                let (sin, cos) = (k as f32 * 0.785).sin_cos();
                let eye = Vec3::new(cos, sin, 0.3);
                let square = Camera::look_at(eye, Vec3::new(-cos, -sin, 0.6), 1.1, 80);
                let camera = Camera { height: 60, cy: 30.0, ..square };
                let back = camera.rotation.transpose();
                let color = |i: usize| {
                    let (x, y) = ((i % 80) as f32 + 0.5, (i / 80) as f32 + 0.5);
                    let d = back * Vec3::new((x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, 1.0);
                    let d = d.normalize();
                    let wall = k % 2 == 0 && d.z < 0.2 && x < 30.0;
                    if d.z < 0.0 || wall { [0.2, 0.1 + 0.3 * (i % 2) as f32, 0.1] } else { blue(d) }
                };
                Target {
                    camera,
                    color: (0..80 * 60).map(color).collect(),
                    alpha: vec![1.0; 80 * 60],
                    weight: 1.0,
                    refine_pose: None,
                    fit_exposure: false,
                    held_back: None,
                    confidence: None,
                    shown: Shown::Color,
                    name: String::new(),
                }
            })
            .collect()
    }

    #[test]
    fn the_dome_is_closed_and_has_the_photos_colours() {
        let targets = photos();
        let s = seen(&targets, 1.0, 20_000).unwrap();
        assert!(is_plain(&s) && s.gaussians.len() <= 2000, "{} {}", s.share, s.gaussians.len());
        assert!(s.gaussians.positions.iter().all(|p| p.length() > 0.99 * FAR));
        // From anywhere near, in any direction above the horizon, seen or not: opaque, and the sky's colour.
        for (k, t) in targets.iter().enumerate() {
            let back = t.camera.rotation.transpose();
            let up = Camera::look_at(
                t.camera.position(),
                t.camera.position() + Vec3::new(0.3, k as f32 - 4.0, 4.0),
                1.0,
                40,
            );
            let overhead = render(&s.gaussians, &up, [0.0; 3]);
            assert!(overhead.alpha.iter().all(|a| *a > 0.98), "{:?}", overhead.alpha.iter().copied().reduce(f32::min));
            let frame = render(&s.gaussians, &t.camera, [0.0; 3]);
            for i in 0..frame.color.len() {
                let (x, y) = ((i % 80) as f32 + 0.5, (i / 80) as f32 + 0.5);
                let d = (back * Vec3::new((x - t.camera.cx) / t.camera.fx, (y - t.camera.cy) / t.camera.fy, 1.0))
                    .normalize();
                if d.z > 0.1 {
                    assert!(frame.alpha[i] > 0.98, "{d} {}", frame.alpha[i]);
                }
                // Lower, half of the photos see the wall: there it is the colour of the sky around.
                if d.z > 0.3 {
                    let off = (0..3).map(|c| (frame.color[i][c] - blue(d)[c]).abs()).fold(0.0, f32::max);
                    assert!(off < 0.1, "{d} {:?} {:?}", frame.color[i], blue(d));
                }
            }
        }
    }

    #[test]
    fn where_nothing_is_alike_there_is_no_sky() {
        let mut targets = photos();
        for (k, t) in targets.iter_mut().enumerate() {
            let n = t.color.len();
            t.color = (0..n).map(|i| [((i * 7 + k * 13) % 10) as f32 / 10.0; 3]).collect();
        }
        assert!(seen(&targets, 1.0, 20_000).is_none_or(|s| !is_plain(&s)));
    }
}
