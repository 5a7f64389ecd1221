//! Gaussians to begin with: those that the network makes of the best view, turned and moved until their silhouette meets the
//! masks of the other photos and cut where those refuse them, and the skin of what all masks allow.

use std::collections::HashSet;

use glam::{Mat3, Quat, Vec3};
use rayon::prelude::*;

use crate::models::align;
use crate::models::pattern_search::pattern_search;
use crate::models::splat_prior::OneView;
use crate::photo::{self, Edge, Plane, Rect, sample_plane};
use crate::splat::{Camera, Gaussians, SH_C0};
use crate::views::hull::{CELL, Silhouette};

/// p → scale · rotation · p + translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Move {
    pub rotation: Mat3,
    pub scale: f32,
    pub translation: Vec3,
}

/// Longer side of the silhouettes that are compared, and how many Gaussians draw them.
const SIDE: f32 = 72.0;
const DRAWN: usize = 5000;
/// More photos than this say the same.
const COMPARED: usize = 10;

/// From the network's frame to the posed one, by the camera of the same crop in both: the ray to the middle stays where it is,
/// and so does the size in the picture.
pub fn by_camera(prior: &Camera, posed: &Camera) -> Move {
    let (from, to) = (prior.translation, posed.translation);
    // The middle is seen off the axis, at another angle under another focal length.
    let at = |c: &Camera, p: Vec3| [c.fx * p.x / p.z + c.cx, c.fy * p.y / p.z + c.cy];
    let [x, y] = at(prior, from);
    let ray = Vec3::new((x - prior.cx) / prior.fx, (y - prior.cy) / prior.fy, 1.0).normalize();
    let turn = Mat3::from_quat(Quat::from_rotation_arc(ray, to.normalize()));
    let scale = prior.fx / from.z * to.z / posed.fx;
    Move { rotation: posed.rotation.transpose() * turn * prior.rotation, scale, translation: Vec3::ZERO }
}

/// A mask at the size at which silhouettes are compared.
struct Small {
    camera: Camera,
    mask: Plane,
}

impl Small {
    fn of(s: &Silhouette) -> Small {
        let k = (SIDE / s.mask.width.max(s.mask.height) as f32).min(1.0);
        let size = |v: usize| ((v as f32 * k).round() as usize).max(4);
        let (w, h) = (size(s.mask.width), size(s.mask.height));
        let whole = Rect { x: 0.0, y: 0.0, width: s.mask.width as f32, height: s.mask.height as f32 };
        Small { camera: s.camera.resized(w as u32, h as u32), mask: sample_plane(s.mask, whole, w, h, Edge::Clamp) }
    }

    fn cost(&self, g: &Gaussians) -> f64 {
        let seen = align::silhouette(g, &self.camera);
        let square: f64 = seen.data.iter().zip(&self.mask.data).map(|(a, b)| f64::from(a - b).powi(2)).sum();
        square / self.mask.data.iter().map(|v| f64::from(*v)).sum::<f64>().max(1.0)
    }
}

/// Intersection over union of a silhouette of Gaussians and a mask.
pub fn silhouette_iou(g: &Gaussians, s: &Silhouette) -> f32 {
    let small = Small::of(s);
    let seen = align::silhouette(g, &small.camera);
    photo::silhouette_iou(&seen.data, &small.mask.data).unwrap_or(0.0) as f32
}

/// Every so manieth Gaussian, larger for those left out.
fn thinned(g: &Gaussians) -> Gaussians {
    let step = g.len().div_ceil(DRAWN).max(1);
    let mut out = g.filtered(|i| i % step == 0);
    out.log_scales.iter_mut().for_each(|s| *s += Vec3::splat(0.5 * (step as f32).ln()));
    out
}

/// Turns, moves and scales Gaussians until their silhouettes meet the masks: a [`pattern_search`] over the
/// seven numbers of a similarity, from `first`.
pub fn settle(g: &Gaussians, first: Move, silhouettes: &[Silhouette]) -> Move {
    let step = silhouettes.len().div_ceil(COMPARED).max(1);
    let small: Vec<Small> = silhouettes.iter().step_by(step).map(Small::of).collect();
    let thin = thinned(g);
    let of = |t: &[f32; 7]| {
        let turn = Mat3::from_quat(Quat::from_scaled_axis(Vec3::new(t[0], t[1], t[2])));
        Move {
            rotation: turn * first.rotation,
            scale: first.scale * t[3].exp(),
            translation: turn * first.translation + Vec3::new(t[4], t[5], t[6]),
        }
    };
    let cost = |t: [f32; 7]| -> f64 {
        let m = of(&t);
        let moved = Gaussians {
            // Colours are not looked at: turning them would take longer than the rest.
            sh: Vec::new(),
            ..turned(&thin, &m)
        };
        small.par_iter().map(|s| s.cost(&moved)).collect::<Vec<f64>>().iter().sum()
    };
    let (best, _) = pattern_search([0.0; 7], [0.12, 0.12, 0.12, 0.08, 0.08, 0.08, 0.08], 1.0 / 30.0, cost);
    of(&best)
}

/// Moved, without their harmonics.
fn turned(g: &Gaussians, m: &Move) -> Gaussians {
    let turn = Quat::from_mat3(&m.rotation);
    let rotation = |q: &[f32; 4]| {
        let r = turn * Quat::from_xyzw(q[1], q[2], q[3], q[0]);
        [r.w, r.x, r.y, r.z]
    };
    Gaussians {
        positions: g.positions.iter().map(|p| m.scale * (m.rotation * *p) + m.translation).collect(),
        log_scales: g.log_scales.iter().map(|s| *s + Vec3::splat(m.scale.ln())).collect(),
        rotations: g.rotations.iter().map(rotation).collect(),
        logit_opacities: g.logit_opacities.clone(),
        sh: Vec::new(),
    }
}

/// Without what all but `tolerated` of the silhouettes refuse.
pub fn carved(g: &Gaussians, silhouettes: &[Silhouette], tolerated: f32) -> Gaussians {
    let kept: Vec<bool> = g
        .positions
        .par_iter()
        .map(|p| {
            let said: Vec<bool> = silhouettes.iter().filter_map(|s| s.allows(*p)).collect();
            said.iter().filter(|allowed| !**allowed).count() as f32 <= tolerated * said.len() as f32
        })
        .collect();
    g.filtered(|i| kept[i])
}

/// Those of `more` that have none of `g` near them.
pub fn missing(g: &Gaussians, more: &Gaussians) -> Gaussians {
    let cell = |p: Vec3| (p / CELL).floor().to_array().map(|v| v as i32);
    let filled: HashSet<[i32; 3]> = g.positions.iter().map(|p| cell(*p)).collect();
    let near = |p: Vec3| {
        let [x, y, z] = cell(p);
        (-1..=1).any(|i| (-1..=1).any(|j| (-1..=1).any(|k| filled.contains(&[x + i, y + j, z + k]))))
    };
    more.filtered(|i| !near(more.positions[i]))
}

/// Points as small round Gaussians.
pub fn of_points(points: &[(Vec3, [u8; 3])]) -> Gaussians {
    let mut g = Gaussians::default();
    for (p, color) in points {
        g.positions.push(*p);
        g.log_scales.push(Vec3::splat((0.4 * CELL).ln()));
        g.rotations.push([1.0, 0.0, 0.0, 0.0]);
        g.logit_opacities.push(1.0);
        let mut sh = [[0.0; 3]; 16];
        sh[0] = color.map(|v| (f32::from(v) / 255.0 - 0.5) / SH_C0);
        g.sh.push(sh);
    }
    g
}

/// The network's view in the posed frame.
pub fn moved(view: &mut OneView, m: &Move, camera: Camera, elevation: f32) {
    view.gaussians = view.gaussians.transformed(m.rotation, m.scale, m.translation);
    view.camera = camera;
    view.elevation = elevation;
    view.seen_from.mean = elevation;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box without symmetry.
    fn body() -> Gaussians {
        let mut points = Vec::new();
        for i in 0..12 {
            for j in 0..20 {
                for k in 0..9 {
                    let p = Vec3::new(i as f32 / 11.0 - 0.5, j as f32 / 12.0 - 0.8, k as f32 / 12.0 - 0.3);
                    // A step at one end.
                    if !(j > 12 && k > 4) {
                        points.push((0.8 * p, [200, 100, 50]));
                    }
                }
            }
        }
        of_points(&points)
    }

    fn cameras() -> Vec<Camera> {
        let eye = |i: usize| {
            let a = i as f32 * 0.9;
            4.0 * Vec3::new(a.sin(), -a.cos(), 0.2 + 0.15 * (i % 3) as f32)
        };
        (0..6).map(|i| Camera::look_at(eye(i), Vec3::ZERO, 0.6, 96)).collect()
    }

    #[test]
    fn a_body_is_turned_and_scaled_back_to_its_masks() {
        let truth = body();
        let masks: Vec<Plane> = cameras().iter().map(|c| align::silhouette(&truth, c)).collect();
        let colour = vec![[0.5; 3]; 96 * 96];
        let known = [-500.0, -500.0, 500.0, 500.0];
        let all: Vec<Silhouette> = cameras()
            .into_iter()
            .zip(&masks)
            .map(|(camera, mask)| Silhouette { camera, colour: &colour, mask, known })
            .collect();
        let wrong = Move {
            rotation: Mat3::from_quat(Quat::from_scaled_axis(Vec3::new(0.15, -0.1, 0.2))),
            scale: 1.2,
            translation: Vec3::new(0.1, -0.08, 0.05),
        };
        let g = truth.transformed(wrong.rotation, wrong.scale, wrong.translation);
        let first = Move { rotation: Mat3::IDENTITY, scale: 1.0, translation: Vec3::ZERO };
        let before: f32 = all.iter().map(|s| silhouette_iou(&g, s)).sum::<f32>() / 6.0;
        let m = settle(&g, first, &all);
        let back = g.transformed(m.rotation, m.scale, m.translation);
        let after: f32 = all.iter().map(|s| silhouette_iou(&back, s)).sum::<f32>() / 6.0;
        assert!(before < 0.85 && after > 0.93, "{before} → {after}");
        assert!((m.scale * wrong.scale - 1.0).abs() < 0.03, "{m:?}");
        assert!(carved(&truth, &all, 0.0).len() as f32 > 0.9 * truth.len() as f32);
        assert!(carved(&g, &all, 0.0).len() as f32 <= 0.8 * g.len() as f32);
        assert!(missing(&truth, &truth).is_empty());
    }

    #[test]
    fn a_camera_of_the_same_crop_says_where_the_network_stands() {
        // The network saw it from 3.9 at 30°; in truth from 6 with a longer lens, off the axis.
        let prior = Camera::look_at(Vec3::new(0.0, -3.9, 0.0), Vec3::ZERO, 30f32.to_radians(), 100);
        let posed =
            Camera { cx: 250.0, ..Camera::look_at(Vec3::new(2.0, -6.0, 1.0), Vec3::new(1.0, 0.0, 0.0), 0.4, 300) };
        let m = by_camera(&prior, &posed);
        let p = m.scale * (m.rotation * Vec3::Z) + m.translation;
        let at = |c: &Camera, p: Vec3| {
            let q = c.rotation * p + c.translation;
            Vec3::new(c.fx * q.x / q.z, c.fy * q.y / q.z, 1.0)
        };
        let tall = at(&prior, Vec3::Z).distance(at(&prior, Vec3::ZERO)) / 100.0;
        let seen = at(&posed, p).distance(at(&posed, Vec3::ZERO)) / 100.0;
        assert!((seen / tall - 1.0).abs() < 0.05, "{seen} {tall}");
    }
}
