//! Pixels of a subject: Gaussians on the GPU or the CPU, or a level of its mesh, over the ground.

use rayon::prelude::*;
use serde::Serialize;

use super::ground::{Ground, Rays};
use super::query::{Query, Show};
use super::subject::{Level, Subject};
use crate::mesh::raster::{raster, visibility};
use crate::preview::ramp;
use crate::splat::render::{self, Frame, gpu, to_bytes};
use crate::splat::{Camera, Gaussians};
use crate::{Error, Result};

const MOVING: u8 = 75;
const AT_REST: u8 = 90;
/// Less than this much of a pixel's light from the subject: the pixel shows none of it.
const SEEN: f32 = 0.5;

/// A point that was pointed at.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Point {
    /// In the subject frame.
    pub at: [f32; 3],
    /// On the ground, beside the subject.
    pub ground: bool,
}

/// Who draws Gaussians.
pub enum Splats<'a> {
    Gpu { scene: gpu::Scene, renderer: Box<gpu::Renderer<'a>> },
    Cpu(Box<render::Drawer>),
}

impl<'a> Splats<'a> {
    /// Errors: environment, from the GPU.
    pub fn new(gaussians: &Gaussians, gpu: Option<&'a gpu::Gpu>) -> Result<Splats<'a>> {
        Ok(match gpu {
            Some(gpu) => {
                Splats::Gpu { scene: gpu::Scene::upload(gpu, gaussians)?, renderer: Box::new(gpu::Renderer::new(gpu)?) }
            }
            None => Splats::Cpu(Box::new(render::Drawer::new(gaussians))),
        })
    }

    /// With depths.
    fn render(&mut self, camera: &Camera) -> Result<Frame> {
        match self {
            Splats::Gpu { scene, renderer } => {
                renderer.depth = true;
                renderer.render(scene, camera, [0.0; 3])
            }
            Splats::Cpu(drawer) => {
                drawer.depth = true;
                Ok(drawer.render(camera, [0.0; 3]))
            }
        }
    }

    /// Colours alone, as bytes: from a GPU they come so.
    fn colours(&mut self, camera: &Camera) -> Result<Layer> {
        match self {
            Splats::Gpu { scene, renderer } => {
                renderer.depth = false;
                renderer.render_bytes(scene, camera)
            }
            Splats::Cpu(drawer) => {
                drawer.depth = false;
                let frame = drawer.render(camera, [0.0; 3]);
                Ok(to_bytes(&frame.color, &frame.alpha))
            }
        }
    }

    fn normals(&mut self, camera: &Camera) -> Result<Vec<[f32; 3]>> {
        match self {
            Splats::Gpu { scene, renderer } => {
                renderer.depth = true;
                renderer.normals(scene, camera)
            }
            Splats::Cpu(drawer) => Ok(drawer.normals(camera)),
        }
    }
}

/// Colours times how much of the pixel is the subject's, and how much that is; as [`to_bytes`] makes them.
type Layer = Vec<[u8; 4]>;

pub struct Draw<'a> {
    subject: &'a Subject,
    splats: Option<Splats<'a>>,
}

impl<'a> Draw<'a> {
    pub fn new(subject: &'a Subject, splats: Option<Splats<'a>>) -> Draw<'a> {
        Draw { subject, splats }
    }

    /// One picture, a JPEG.
    ///
    /// Errors: environment, from the GPU or the encoder.
    pub fn picture(&mut self, query: &Query, camera: &Camera) -> Result<Vec<u8>> {
        let (width, height) = (camera.width as usize, camera.height as usize);
        let background = if query.dark { [0.09; 3] } else { [0.97; 3] };
        let layer = match (&mut self.splats, level(self.subject, query)) {
            (_, Some(level)) => of_mesh(self.subject, level, query, camera, background),
            (Some(splats), None) if matches!(query.show, Show::Colour | Show::Provenance | Show::Error) => {
                splats.colours(camera)?
            }
            (Some(splats), None) => of_splats(self.subject, splats, query.show, camera)?,
            (None, None) => vec![[0; 4]; width * height],
        };
        let heading = self.subject.place.map_or(0.0, |p| p.heading);
        let ground = query.grid.then(|| Ground::new(self.subject.radius, heading, query.dark));
        let rays = Rays::new(camera);
        let mut pixels = vec![0u8; 3 * width * height];
        pixels.par_chunks_mut(3 * width).zip(layer.par_chunks(width)).enumerate().for_each(|(y, (row, layer))| {
            for (x, (out, [r, g, b, alpha])) in row.chunks_exact_mut(3).zip(layer).enumerate() {
                let own = [*r, *g, *b];
                if *alpha == u8::MAX {
                    out.copy_from_slice(&own);
                    continue;
                }
                let through = 1.0 - f32::from(*alpha) / 255.0;
                let behind = ground.as_ref().map_or(background, |ground| ground.over(&rays, x, y, background));
                for ((out, own), behind) in out.iter_mut().zip(own).zip(behind) {
                    *out = (f32::from(own) + 255.0 * through * behind + 0.5).clamp(0.0, 255.0) as u8;
                }
            }
        });
        jpeg(&pixels, camera.width, camera.height, if query.rest { AT_REST } else { MOVING })
    }

    /// What stands at the pixel that is pointed at: the subject, else the ground where it is drawn.
    ///
    /// Errors: environment, from the GPU.
    pub fn point(&mut self, query: &Query, camera: &Camera) -> Result<Option<Point>> {
        let (x, y) = (query.x, query.y);
        let at = (y.min(camera.height - 1) * camera.width + x.min(camera.width - 1)) as usize;
        let depth = match (&mut self.splats, level(self.subject, query)) {
            (_, Some(level)) => visibility(&level.mesh.positions, &level.mesh.triangles, camera).depth[at],
            (Some(splats), None) => splats.render(camera)?.median_depth[at],
            (None, None) => 0.0,
        };
        let (px, py) = (x as f32 + 0.5, y as f32 + 0.5);
        if depth > 0.0 {
            let at = Rays::new(camera).at(px, py, depth);
            return Ok(Some(Point { at: at.to_array(), ground: false }));
        }
        let met = Rays::new(camera).meet(px, py).filter(|_| query.grid);
        Ok(met.map(|(at, _)| Point { at: at.to_array(), ground: true }))
    }
}

/// Rows of red, green and blue as a JPEG.
///
/// Errors: environment, from the encoder: no pixels, or more than 65,535 a side.
pub fn jpeg(pixels: &[u8], width: u32, height: u32, quality: u8) -> Result<Vec<u8>> {
    let mut out = Vec::with_capacity(pixels.len() / 8);
    let side = |v: u32| u16::try_from(v).unwrap_or(u16::MAX);
    jpeg_encoder::Encoder::new(&mut out, quality)
        .encode(pixels, side(width), side(height), jpeg_encoder::ColorType::Rgb)
        .map_err(|e| Error::environment("JPEG").found(e.to_string()))?;
    Ok(out)
}

/// The level that a query asks for; the finest where there are no Gaussians to show instead.
fn level<'a>(subject: &'a Subject, query: &Query) -> Option<&'a Level> {
    if let (Show::Provenance, Some(level), _) | (Show::Error, _, Some(level)) =
        (query.show, &subject.provenance, &subject.expected_error)
    {
        return Some(level);
    }
    let number = query.level;
    let number = if number == 0 && subject.gaussians.is_none() { 1 } else { number };
    (number > 0).then(|| subject.levels.get(number - 1).or(subject.levels.last())).flatten()
}

/// Near is bright: the whole subject lies between a radius before the middle and one behind it.
fn shade_of_depth(subject: &Subject, camera: &Camera, z: f32) -> [f32; 3] {
    let middle = (camera.rotation * subject.centre + camera.translation).z;
    ramp((middle + subject.radius - z) / (2.0 * subject.radius)).map(|c| c / 255.0)
}

/// x right, y up, z towards the camera, −1 to 1 as 0 to 1.
fn shade_of_normal(n: [f32; 3]) -> [f32; 3] {
    [n[0], -n[1], -n[2]].map(|v| 0.5 + 0.5 * v)
}

/// Depths or normals.
fn of_splats(subject: &Subject, splats: &mut Splats, show: Show, camera: &Camera) -> Result<Layer> {
    let frame = splats.render(camera)?;
    let normals = if show == Show::Normals { Some(splats.normals(camera)?) } else { None };
    let shade = |i: usize| match &normals {
        Some(normals) => shade_of_normal(normals[i]),
        None => shade_of_depth(subject, camera, frame.median_depth[i]),
    };
    let seen = |i: usize| frame.alpha[i] >= SEEN && frame.median_depth[i] > 0.0;
    let shaded = |i: usize| if seen(i) { (shade(i), 1.0) } else { ([0.0; 3], 0.0) };
    let (color, alpha): (Vec<_>, Vec<_>) = (0..frame.alpha.len()).into_par_iter().map(shaded).unzip();
    Ok(to_bytes(&color, &alpha))
}

fn of_mesh(subject: &Subject, level: &Level, query: &Query, camera: &Camera, background: [f32; 3]) -> Layer {
    let mesh = &level.mesh;
    let seen = visibility(&mesh.positions, &mesh.triangles, camera);
    let drawn = |i: usize| seen.triangle[i] != u32::MAX;
    let alpha: Vec<f32> = (0..seen.depth.len()).map(|i| if drawn(i) { 1.0 } else { 0.0 }).collect();
    let color: Vec<[f32; 3]> = match query.show {
        // A level that provenance or expected error is shown of has it for a texture.
        Show::Colour | Show::Provenance | Show::Error => {
            let background = background.map(|c| (c * 255.0) as u8);
            let image = raster(mesh, Some(&level.texture), camera, background, if query.rest { 2 } else { 1 });
            let pixels = image.pixels().zip(&alpha);
            pixels.map(|(p, a)| p.0.map(|c| a * f32::from(c) / 255.0)).collect()
        }
        Show::Depth => {
            (0..alpha.len()).map(|i| shade_of_depth(subject, camera, seen.depth[i]).map(|c| c * alpha[i])).collect()
        }
        Show::Normals => {
            let flat: Vec<[f32; 3]> = mesh
                .triangles
                .iter()
                .map(|t| {
                    let [a, b, c] = t.map(|v| camera.rotation * mesh.positions[v as usize] + camera.translation);
                    let n = (b - a).cross(c - a).normalize_or_zero();
                    // Both sides are drawn: the one that is seen.
                    shade_of_normal(if n.dot(a) > 0.0 { -n } else { n }.to_array())
                })
                .collect();
            (0..alpha.len()).map(|i| if drawn(i) { flat[seen.triangle[i] as usize] } else { [0.0; 3] }).collect()
        }
    };
    to_bytes(&color, &alpha)
}
