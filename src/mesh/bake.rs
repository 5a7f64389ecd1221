//! Texture from rendered views and the photo.
//!
//! Each texel of the finest level collects colour, in linear light, from the views that see its point, weighted by how
//! straight they look at it; the photo's own pixels win where the photo sees it well. Coarser levels take their texels
//! from the finest one's texture at the closest point of its surface, so that levels do not differ in colour.

use super::color::{Linear, to_byte};
use super::distance::{Bvh, Closest, barycentric, barycentric_3d, within};
use super::fill::{Surroundings, pad};
use super::raster::visibility;
use super::source::{Source, photo_source, rendered_source};
use super::unwrap::cells_inside;
use super::{AT_A_TIME, Mesh, Options, PhotoView, View, cross, rendered, seams, surrounding_cameras};
use crate::Result;
use crate::progress::Progress;
use crate::splat::Camera;
use glam::{Vec2, Vec3};
use image::{Rgb, RgbImage};
use rayon::prelude::*;

/// One texel that a triangle covers.
pub struct Texel {
    pub index: u32,
    pub triangle: u32,
    /// Barycentric.
    pub weights: [f32; 3],
    pub position: Vec3,
    /// Smooth normal.
    pub normal: Vec3,
    /// The triangle's own.
    pub face: Vec3,
}

/// A texture in linear light, with what is known of each texel.
pub struct Baked {
    pub size: usize,
    /// Linear RGB; meaningful everywhere after padding.
    pub color: Vec<[f32; 3]>,
    /// Shares of the photo and of the mirrored photo in the colour, 0..1; negative where no triangle covers the texel.
    pub from: Vec<[f32; 2]>,
}

impl Baked {
    /// Shares of covered texels that are mostly the photo's, and mostly the mirrored photo's.
    pub fn shares(&self) -> [f32; 2] {
        let covered = self.from.iter().filter(|s| s[0] >= 0.0).count();
        let of = |k: usize| self.from.iter().filter(|s| s[k] >= 0.5).count() as f32 / covered.max(1) as f32;
        [of(0), of(1)]
    }

    pub fn image(&self) -> RgbImage {
        let size = self.size as u32;
        RgbImage::from_fn(size, size, |x, y| Rgb(self.color[y as usize * self.size + x as usize].map(to_byte)))
    }
}

pub fn texels(mesh: &Mesh, size: usize) -> Vec<Texel> {
    texels_beyond(mesh, size, 0.0)
}

/// With those that lie up to `beyond` texels outside every triangle, each as if its nearest one went on.
pub fn texels_beyond(mesh: &Mesh, size: usize, beyond: f32) -> Vec<Texel> {
    let mut owner = vec![u32::MAX; size * size];
    let flat: Vec<[Vec2; 3]> =
        mesh.triangles.iter().map(|t| t.map(|i| texel_place(mesh.uvs[i as usize], size))).collect();
    for (f, t) in flat.iter().enumerate() {
        cells_inside(*t, size, size, -1e-3, |x, y| owner[y * size + x] = f as u32);
    }
    if beyond > 0.0 {
        let inside: Vec<bool> = owner.iter().map(|o| *o != u32::MAX).collect();
        let mut off = vec![f32::INFINITY; size * size];
        for (f, t) in flat.iter().enumerate() {
            cells_inside(*t, size, size, -beyond, |x, y| {
                let i = y * size + x;
                let far = distance_to(*t, Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
                if !inside[i] && far <= beyond && far < off[i] {
                    (owner[i], off[i]) = (f as u32, far);
                }
            });
        }
    }
    (0..size * size)
        .into_par_iter()
        .filter_map(|i| {
            let triangle = mesh.triangles.get(owner[i] as usize)?;
            let p = Vec2::new((i % size) as f32 + 0.5, (i / size) as f32 + 0.5);
            let w = barycentric(p, flat[owner[i] as usize])?;
            let [a, b, c] = triangle.map(|v| v as usize);
            let normal = mesh.normals[a] * w[0] + mesh.normals[b] * w[1] + mesh.normals[c] * w[2];
            let face = cross(&mesh.positions, triangle).normalize_or_zero();
            Some(Texel {
                index: i as u32,
                triangle: owner[i],
                weights: w,
                position: mesh.positions[a] * w[0] + mesh.positions[b] * w[1] + mesh.positions[c] * w[2],
                normal: normal.try_normalize().unwrap_or(face),
                face,
            })
        })
        .collect()
}

/// From a point outside a triangle to its nearest edge.
fn distance_to(t: [Vec2; 3], p: Vec2) -> f32 {
    let edge = |k: usize| {
        let (a, d) = (t[k], t[(k + 1) % 3] - t[k]);
        let along = ((p - a).dot(d) / d.length_squared().max(1e-20)).clamp(0.0, 1.0);
        p.distance(a + along * d)
    };
    (0..3).map(edge).fold(f32::INFINITY, f32::min)
}

fn texel_place(uv: Vec2, size: usize) -> Vec2 {
    Vec2::new(uv.x, 1.0 - uv.y) * size as f32
}

/// Bakes the finest level.
pub fn bake(
    mesh: &Mesh,
    size: u32,
    render: &(dyn Fn(&Camera) -> View + Sync),
    photos: &[PhotoView],
    options: &Options,
    progress: &dyn Progress,
) -> Result<Baked> {
    let size = size as usize;
    let texels = texels(mesh, size);
    let linear = Linear::default();
    let mut sums = vec![[0f32; 4]; texels.len()];
    let cameras = surrounding_cameras(options.color_views, options.color_size);
    for (done, cameras) in cameras.chunks(AT_A_TIME).enumerate() {
        progress.check()?;
        let source = |camera: &Camera| {
            let view = rendered(render, camera)?;
            let seen = visibility(&mesh.positions, &mesh.triangles, &view.camera);
            Ok(rendered_source(&view, &seen, options.background, &linear))
        };
        let sources = cameras.par_iter().map(source).collect::<Result<Vec<Source>>>()?;
        sums.par_iter_mut().zip(&texels).for_each(|(sum, texel)| {
            for source in &sources {
                if let Some((at, straight)) = source.sees(texel) {
                    let (color, trust) = source.at(at);
                    let weight = straight.powi(4) * trust;
                    for (sum, c) in sum.iter_mut().zip(color) {
                        *sum += weight * c;
                    }
                    sum[3] += weight;
                }
            }
        });
        progress.step((done * AT_A_TIME + cameras.len()) as u64);
    }
    let mut colors = from_views(&texels, &sums);
    let mut from = vec![[0.0; 2]; texels.len()];
    // What is laid on later wins: photos over their mirror images, and of these an earlier one over a later one.
    let photos = photos.iter().filter(|p| p.camera.width > 0 && p.camera.height > 0);
    let (images, own): (Vec<&PhotoView>, Vec<&PhotoView>) = photos.partition(|p| p.mirrored);
    let layers = images.into_iter().rev().map(|p| (true, vec![p])).chain([(false, own)]);
    for (mirrored, shown) in layers {
        let source = |p: &PhotoView| photo_source(p, &visibility(&mesh.positions, &mesh.triangles, &p.camera), &linear);
        let sources: Vec<Source> = shown.into_iter().map(source).collect();
        if sources.is_empty() {
            continue;
        }
        let laid = with_photos(&texels, &colors, &sources);
        for ((color, from), (new, share)) in colors.iter_mut().zip(&mut from).zip(laid) {
            *color = new;
            *from = from.map(|f| f * (1.0 - share));
            from[usize::from(mirrored)] += share;
        }
    }
    let mut baked = Baked { size, color: vec![[0.0; 3]; size * size], from: vec![[-1.0; 2]; size * size] };
    for (texel, (color, from)) in texels.iter().zip(colors.into_iter().zip(from)) {
        baked.color[texel.index as usize] = color;
        baked.from[texel.index as usize] = from;
    }
    pad(&mut baked.color, |i| baked.from[i][0] >= 0.0, size);
    seams::closed(mesh, &mut baked.color, size);
    Ok(baked)
}

/// The views' weighted mean; where no view sees a texel, what is around it.
fn from_views(texels: &[Texel], sums: &[[f32; 4]]) -> Vec<[f32; 3]> {
    let mean = |s: &[f32; 4]| (s[3] > 1e-4).then(|| [s[0] / s[3], s[1] / s[3], s[2] / s[3]]);
    let known = texels.iter().zip(sums).filter_map(|(t, s)| Some((t.position, mean(s)?)));
    let unseen = Surroundings::new(known, 1.0);
    texels.par_iter().zip(sums).map(|(t, s)| mean(s).unwrap_or_else(|| unseen.at(t.position))).collect()
}

/// What photos show of a texel and how far it may be trusted. Of several, the one that looks at it most squarely all but
/// decides.
fn shown(texel: &Texel, sources: &[Source]) -> ([f32; 3], f32) {
    let one = |source: &Source| {
        let (at, straight) = source.sees(texel)?;
        let (color, trust) = source.at(at);
        Some((color, trust * smoothstep(0.15, 0.38, straight), straight))
    };
    let mut all = sources.iter().filter_map(one).filter(|(_, share, _)| *share > 0.0);
    let Some((first, mut most, straight)) = all.next() else { return ([0.0; 3], 0.0) };
    let (mut color, mut sum, mut only) = (first.map(|c| c * most * straight.powi(8)), most * straight.powi(8), true);
    for (c, share, straight) in all {
        let weight = share * straight.powi(8);
        color = std::array::from_fn(|k| color[k] + weight * c[k]);
        (sum, most, only) = (sum + weight, most.max(share), false);
    }
    if only { (first, most) } else { (color.map(|c| c / sum.max(1e-12)), most) }
}

/// Colours and the photos' share in them. Where the photos end, their ratio to the views fades out over the
/// neighbourhood (a few twentieths of the unit), so that no edge shows.
fn with_photos(texels: &[Texel], around: &[[f32; 3]], sources: &[Source]) -> Vec<([f32; 3], f32)> {
    let seen: Vec<([f32; 3], f32)> = texels.par_iter().map(|texel| shown(texel, sources)).collect();
    let known = texels.iter().zip(around).zip(&seen).filter(|(_, (_, share))| *share > 0.8);
    /// Beside black, ratios say little.
    const DARK: f32 = 0.02;
    /// The logarithm of half and double.
    const MOST: f32 = 0.7;
    /// So far one channel's may lie from the three's mean: further on, grey would turn into colours that are nowhere.
    const TINT: f32 = 0.2;
    let ratio = |photo: &[f32; 3], views: &[f32; 3]| {
        let each: [f32; 3] = std::array::from_fn(|k| ((photo[k] + DARK) / (views[k] + DARK)).ln());
        let mean = each.iter().sum::<f32>() / 3.0;
        each.map(|r| mean.clamp(-MOST, MOST) + (r - mean).clamp(-TINT, TINT))
    };
    let ratios = Surroundings::new(known.map(|((t, views), (photo, _))| (t.position, ratio(photo, views))), 0.7);
    texels
        .par_iter()
        .zip(around)
        .zip(&seen)
        .map(|((texel, views), &(photo, share))| {
            let ratio = ratios.at(texel.position);
            let color = std::array::from_fn(|k| {
                let near = ((views[k] + DARK) * ratio[k].exp() - DARK).clamp(0.0, 1.0);
                near + share * (photo[k] - near)
            });
            (color, share)
        })
        .collect()
}

/// A coarser level's texture out of the finest one's, by closest points that look the same way.
pub fn transfer(mesh: &Mesh, size: u32, fine: &Mesh, fine_bvh: &Bvh, fine_baked: &Baked) -> Baked {
    /// Each texel is the mean of this many samples squared.
    const FINER: usize = 2;
    /// Texels that one thread asks about in turn.
    const RUN: usize = 256;
    /// What lies further away and looks the same way is another side.
    const FAR: f32 = 0.3;
    let size = size as usize;
    let sample = |texel: &Texel, last: &mut Option<Closest>| {
        let looks_alike = |t: u32| cross(&fine.positions, &fine.triangles[t as usize]).dot(texel.normal) > 0.0;
        // The one before lies beside it.
        let near = within(texel.position, &last.filter(|c| looks_alike(c.triangle)), FAR);
        *last = fine_bvh.closest(texel.position, near, looks_alike);
        let found = last.or_else(|| fine_bvh.closest(texel.position, 100.0, |_| true))?;
        let t = fine.triangles[found.triangle as usize].map(|i| i as usize);
        let w = barycentric_3d(found.point, t.map(|i| fine.positions[i]));
        let uv = fine.uvs[t[0]] * w.x + fine.uvs[t[1]] * w.y + fine.uvs[t[2]] * w.z;
        let (color, shares) = bilinear(fine_baked, uv);
        let (x, y) = (texel.index as usize % (size * FINER) / FINER, texel.index as usize / (size * FINER) / FINER);
        Some(((y * size + x) as u32, color, shares))
    };
    let samples: Vec<(u32, [f32; 3], [f32; 2])> = texels(mesh, size * FINER)
        .par_chunks(RUN)
        .flat_map_iter(|texels| {
            let mut last = None;
            texels.iter().filter_map(move |texel| sample(texel, &mut last))
        })
        .collect();
    let mut sums = vec![([0f32; 3], [0f32; 2], 0f32); size * size];
    for (i, color, shares) in samples {
        let sum = &mut sums[i as usize];
        for (s, c) in sum.0.iter_mut().zip(color) {
            *s += c;
        }
        sum.1.iter_mut().zip(shares).for_each(|(s, v)| *s += v);
        sum.2 += 1.0;
    }
    let mut color: Vec<[f32; 3]> = sums.iter().map(|s| s.0.map(|c| c / s.2.max(1.0))).collect();
    let from: Vec<[f32; 2]> = sums.iter().map(|s| if s.2 > 0.0 { s.1.map(|v| v / s.2) } else { [-1.0; 2] }).collect();
    pad(&mut color, |i| from[i][0] >= 0.0, size);
    seams::closed(mesh, &mut color, size);
    Baked { size, color, from }
}

fn bilinear(baked: &Baked, uv: Vec2) -> ([f32; 3], [f32; 2]) {
    let n = baked.size;
    let q = (texel_place(uv, n) - Vec2::splat(0.5)).clamp(Vec2::ZERO, Vec2::splat((n - 1) as f32 - 1e-3));
    let (x, y) = (q.x as usize, q.y as usize);
    let (tx, ty) = (q.x - x as f32, q.y - y as f32);
    let i = y * n + x;
    let corners =
        [(i, (1.0 - tx) * (1.0 - ty)), (i + 1, tx * (1.0 - ty)), (i + n, (1.0 - tx) * ty), (i + n + 1, tx * ty)];
    let mut color = [0f32; 3];
    let (mut shares, mut covered) = ([0f32; 2], 0f32);
    for (j, share) in corners {
        for (c, v) in color.iter_mut().zip(baked.color[j]) {
            *c += share * v;
        }
        if baked.from[j][0] >= 0.0 {
            shares.iter_mut().zip(baked.from[j]).for_each(|(s, v)| *s += share * v);
            covered += share;
        }
    }
    (color, shares.map(|s| if covered > 0.0 { s / covered } else { 0.0 }))
}

fn smoothstep(from: f32, to: f32, x: f32) -> f32 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
