//! A result brought to its unit frame, and where the truth lies in it.

use glam::{Mat3, Vec3};
use image::RgbImage;

use super::scene::Scene;
use super::submission::{Appearance, Frame, Submission};
use super::surfaces::{self, Shape, Similarity};
use crate::mesh::{self, Surface};
use crate::splat::Gaussians;
use crate::{Error, Result};

/// Samples along an axis when splats alone have to be made a surface.
const VOXELS: usize = 96;

/// A result in its unit frame: p_unit = (p − centre) / radius.
pub struct Unit {
    pub splats: Option<Gaussians>,
    pub mesh: Option<(mesh::Mesh, RgbImage)>,
    /// Of the model, else made of the splats; none for surroundings.
    pub surface: Option<Surface>,
    pub shape: Option<Shape>,
    pub centre: Vec3,
    pub radius: f32,
}

impl Unit {
    /// # Errors
    /// Usage where the result has no size.
    pub fn new(s: &Submission, is_object: bool) -> Result<Unit> {
        let points: Vec<Vec3> = match (&s.mesh, &s.splats) {
            (Some((m, _)), _) => m.positions.clone(),
            (None, Some(g)) => solid(g),
            (None, None) => Vec::new(),
        };
        let low = points.iter().fold(Vec3::INFINITY, |a, p| a.min(*p));
        let high = points.iter().fold(Vec3::NEG_INFINITY, |a, p| a.max(*p));
        let (centre, radius) =
            if is_object { ((low + high) / 2.0, low.distance(high) / 2.0) } else { (Vec3::ZERO, 1.0) };
        if !(points.is_empty() || centre.is_finite() && radius > 0.0) {
            return Err(Error::usage("a result")
                .expected("something with a size")
                .found(format!("a radius of {radius}")));
        }
        let (centre, radius) = if points.is_empty() { (Vec3::ZERO, 1.0) } else { (centre, radius) };
        let splats = s.splats.as_ref().map(|g| g.transformed(Mat3::IDENTITY, 1.0 / radius, -centre / radius));
        let mesh = s.mesh.as_ref().map(|(m, texture)| {
            let positions = m.positions.iter().map(|p| (*p - centre) / radius).collect();
            (mesh::Mesh { positions, ..m.clone() }, texture.clone())
        });
        let surface = match (&mesh, &splats) {
            (Some((m, _)), _) => Some(Surface { positions: m.positions.clone(), triangles: m.triangles.clone() }),
            (None, Some(g)) if is_object => Some(mesh::opacity::surface(g, VOXELS, mesh::opacity::LEVEL)),
            _ => None,
        };
        let surface = surface.filter(|s| is_object && !s.triangles.is_empty());
        let shape = surface.as_ref().map(Shape::of_surface);
        Ok(Unit { splats, mesh, surface, shape, centre, radius })
    }

    /// Splats where there are some: they are what a viewer shows.
    pub fn appearance(&self) -> Option<Appearance<'_>> {
        match (&self.splats, &self.mesh) {
            (Some(g), _) => Some(Appearance::Splats(g)),
            (None, Some((m, texture))) => Some(Appearance::Mesh(m, texture)),
            (None, None) => None,
        }
    }

    fn stays(&self) -> Similarity {
        Similarity::new(Mat3::IDENTITY, 1.0 / self.radius, -self.centre / self.radius)
    }
}

/// Where the truth lies in the result's unit frame, and the best similarity, if it was looked for.
pub fn placed(scene: &Scene, result: &Submission, unit: &Unit) -> (Similarity, Option<Similarity>) {
    let stays = unit.stays();
    let (Some(truth), Some(shape)) = (&scene.surface, &unit.shape) else { return (stays, None) };
    let forward = scene.photo.as_ref().map_or(Vec3::Y, |p| p.camera.rotation.row(2));
    let forward = Vec3::new(forward.x, forward.y, 0.0).normalize_or(Vec3::Y);
    let from = |forward: Vec3| surfaces::aligned(truth, forward, shape);
    match result.frame {
        // The subject frame's +Y is where the camera looked; in the scene's own frame nothing is turned.
        Frame::Scene => (stays, Some(from(Vec3::Y))),
        Frame::Subject => {
            let found = from(forward);
            (found, Some(found))
        }
        Frame::Free => {
            let headings = (0..8).map(|k| Mat3::from_rotation_z(std::f32::consts::TAU * k as f32 / 8.0) * forward);
            let score = |s: Similarity| {
                let moved = s.surface(truth);
                let (low, high) = moved.bounds();
                (surfaces::scores(shape, &Shape::of_surface(&moved), low.distance(high)).chamfer, s)
            };
            let best = headings.map(from).map(score).min_by(|a, b| a.0.total_cmp(&b.0));
            best.map_or((stays, None), |(_, s)| (s, Some(s)))
        }
    }
}

/// Places of splats that can be seen; the outermost hundredth along each axis left out.
fn solid(g: &Gaussians) -> Vec<Vec3> {
    let seen = g.pruned(0.1).positions;
    let limits: Vec<(f32, f32)> = (0..3)
        .map(|k| {
            let mut v: Vec<f32> = seen.iter().map(|p| p[k]).collect();
            v.sort_by(f32::total_cmp);
            let n = v.len();
            if n == 0 { (0.0, 0.0) } else { (v[n / 200], v[n - 1 - n / 200]) }
        })
        .collect();
    seen.into_iter().filter(|p| (0..3).all(|k| p[k] >= limits[k].0 && p[k] <= limits[k].1)).collect()
}
