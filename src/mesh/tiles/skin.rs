//! A tile's texture: what the scene looks like from the cameras, in the colour that they see on average.
//!
//! All tiles take their colours from the same pictures, which look alike from all sides, and each goes on a little beyond its
//! border as the border's triangles do: so what lies on both sides of a border has one colour.

use glam::{Vec2, Vec3};
use rayon::prelude::*;

use super::super::bake::texels_beyond;
use super::super::color::{Linear, to_byte};
use super::super::fill::{Surroundings, pad};
use super::super::source::{Source, view_source};
use super::super::unwrap::{FLAT, assemble, charts};
use super::super::{AT_A_TIME, Mesh, Surface, View, pack, rendered, seams};
use super::cache::Cache;
use super::field::smaller;
use crate::Result;
use crate::progress::Progress;
use crate::splat::Camera;
use image::{Rgb, RgbImage};

/// Pictures that a tile takes its colours from, at most.
const PICTURES: usize = 24;
/// Memory for pictures that may be wanted again.
const KEPT: usize = 512 << 20;
/// Texels beyond a chart's edge that have colours of their own.
const BEYOND: f32 = 1.5;
/// Share of a texture that charts fill, as the packer mostly manages.
const FILLED: f32 = 0.65;
/// Sides of textures.
const SIDES: [u32; 2] = [64, 2048];
/// Places of a tile that cameras are asked for.
const ASKED: usize = 64;

/// The pictures of one level.
pub struct Pictures<'a> {
    render: &'a (dyn Fn(&Camera) -> View + Sync),
    cameras: Vec<Camera>,
    kept: Cache<Source>,
    slack: f32,
    linear: Linear,
}

/// A tile with its texture.
pub struct Skinned {
    pub mesh: Mesh,
    pub texture: RgbImage,
    /// Edge of a texel on the surface, in the mean.
    pub texel: f32,
}

impl<'a> Pictures<'a> {
    /// `by`: width of pictures in parts of the cameras'; `slack`: how far surface and Gaussians may lie apart.
    pub fn new(render: &'a (dyn Fn(&Camera) -> View + Sync), cameras: &[Camera], by: f32, slack: f32) -> Pictures<'a> {
        let cameras = cameras.iter().map(|c| smaller(c, by)).collect();
        Pictures { render, cameras, kept: Cache::new(KEPT), slack, linear: Linear::default() }
    }

    /// Lays a texture over a tile. `texel`: the edge of a texel on the surface that is aimed at.
    pub fn skin(&self, surface: &Surface, texel: f32, progress: &dyn Progress) -> Result<Skinned> {
        let area = surface.area() as f32;
        let wanted = (area / FILLED).sqrt() / texel.max(1e-9);
        // The next power of two, unless the one below is nearly enough.
        let size = ((0.8 * wanted) as u32).next_power_of_two().clamp(SIDES[0], SIDES[1]);
        let charts = charts(surface, &FLAT, FILLED * (size as f32).powi(2));
        let mesh = assemble(surface, &charts, &pack::pack(&charts, size)?.uv);
        progress.check()?;
        let size = size as usize;
        let texels = texels_beyond(&mesh, size, BEYOND);
        let mut sums = vec![[0f32; 4]; texels.len()];
        for some in self.chosen(surface).chunks(AT_A_TIME) {
            progress.check()?;
            let source = |i: &usize| {
                self.kept.get(*i, || {
                    let source =
                        view_source(&rendered(self.render, &self.cameras[*i])?, [0.0; 3], self.slack, &self.linear);
                    let bytes = source.bytes();
                    Ok((source, bytes))
                })
            };
            let sources = some.par_iter().map(source).collect::<Result<Vec<_>>>()?;
            sums.par_iter_mut().zip(&texels).for_each(|(sum, texel)| {
                for source in &sources {
                    if let Some((at, straight)) = source.sees(texel) {
                        let (color, trust) = source.at(at);
                        let weight = trust * straight.powi(4) / source.distance(texel.position).powi(2).max(1e-6);
                        (0..3).for_each(|k| sum[k] += weight * color[k]);
                        sum[3] += weight;
                    }
                }
            });
        }
        let mean = |s: &[f32; 4]| (s[3] > 1e-4).then(|| [s[0] / s[3], s[1] / s[3], s[2] / s[3]]);
        // Colours of what is around, in a frame that the tile fills.
        let (low, high) = surface.bounds();
        let (middle, half) = ((low + high) / 2.0, ((high - low).max_element() / 2.0).max(1e-9));
        let within = |p: Vec3| (p - middle) / half;
        let known = texels.iter().zip(&sums).filter_map(|(t, s)| Some((within(t.position), mean(s)?)));
        let around = Surroundings::new(known, 1.0);
        let mut color = vec![[0f32; 3]; size * size];
        let mut covered = vec![false; size * size];
        for (texel, sum) in texels.iter().zip(&sums) {
            color[texel.index as usize] = mean(sum).unwrap_or_else(|| around.at(within(texel.position)));
            covered[texel.index as usize] = true;
        }
        pad(&mut color, |i| covered[i], size);
        seams::closed(&mesh, &mut color, size);
        let texture =
            RgbImage::from_fn(size as u32, size as u32, |x, y| Rgb(color[y as usize * size + x as usize].map(to_byte)));
        let flat: f32 = mesh
            .triangles
            .iter()
            .map(|t| t.map(|i| mesh.uvs[i as usize]))
            .map(|[a, b, c]: [Vec2; 3]| (b - a).perp_dot(c - a).abs() / 2.0)
            .sum();
        let texel = (area / (flat * (size * size) as f32).max(1e-9)).sqrt();
        Ok(Skinned { mesh, texture, texel })
    }

    /// Those that show most of a tile, nearer ones before others.
    fn chosen(&self, surface: &Surface) -> Vec<usize> {
        let step = surface.positions.len().div_ceil(ASKED).max(1);
        let places: Vec<Vec3> = surface.positions.iter().step_by(step).copied().collect();
        let worth = |c: &Camera| -> f32 {
            let eye = c.position();
            let shown = places.iter().filter(|p| {
                let q = c.rotation * **p + c.translation;
                let (x, y) = (c.fx * q.x / q.z + c.cx, c.fy * q.y / q.z + c.cy);
                q.z > 0.01 && (0.0..c.width as f32).contains(&x) && (0.0..c.height as f32).contains(&y)
            });
            shown.map(|p| (c.fx / p.distance(eye).max(1e-3)).powi(2)).sum()
        };
        let mut all: Vec<(f32, usize)> = self.cameras.iter().map(worth).zip(0..).filter(|w| w.0 > 0.0).collect();
        all.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        all.truncate(PICTURES);
        let mut chosen: Vec<usize> = all.into_iter().map(|w| w.1).collect();
        chosen.sort_unstable();
        chosen
    }
}
