//! Texture from rendered views and the photo.
//!
//! Each texel of the finest level collects colour, in linear light, from the views that see its point, weighted by how
//! straight they look at it; the photo's own pixels win where the photo sees it well. Coarser levels take their texels
//! from the finest one's texture at the closest point of its surface, so that levels do not differ in colour.

use super::color::{Linear, to_byte};
use super::distance::{Bvh, barycentric};
use super::raster::{Seen, visibility};
use super::unwrap::cells_inside;
use super::{Mesh, Options, PhotoView, VIEW_DISTANCE, VIEW_FOV, View, cross, fibonacci_sphere, rendered};
use crate::Result;
use crate::progress::Progress;
use crate::splat::Camera;
use glam::{Vec2, Vec3};
use image::{Rgb, RgbImage};
use rayon::prelude::*;

/// One texel that a triangle covers.
struct Texel {
    index: u32,
    position: Vec3,
    /// Smooth normal.
    normal: Vec3,
    /// The triangle's own.
    face: Vec3,
}

/// A texture in linear light, with what is known of each texel.
pub struct Baked {
    pub size: usize,
    /// Linear RGB; meaningful everywhere after padding.
    pub color: Vec<[f32; 3]>,
    /// Share of the photo in the colour, 0..1; negative where no triangle covers the texel.
    pub from_photo: Vec<f32>,
}

impl Baked {
    /// Share of covered texels that are mostly the photo's.
    pub fn seen(&self) -> f32 {
        let covered = self.from_photo.iter().filter(|s| **s >= 0.0).count();
        let seen = self.from_photo.iter().filter(|s| **s >= 0.5).count();
        seen as f32 / covered.max(1) as f32
    }

    pub fn image(&self) -> RgbImage {
        let size = self.size as u32;
        RgbImage::from_fn(size, size, |x, y| Rgb(self.color[y as usize * self.size + x as usize].map(to_byte)))
    }
}

fn texels(mesh: &Mesh, size: usize) -> Vec<Texel> {
    let mut owner = vec![u32::MAX; size * size];
    let flat: Vec<[Vec2; 3]> =
        mesh.triangles.iter().map(|t| t.map(|i| texel_place(mesh.uvs[i as usize], size))).collect();
    for (f, t) in flat.iter().enumerate() {
        cells_inside(*t, size, size, -1e-3, |x, y| owner[y * size + x] = f as u32);
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
                position: mesh.positions[a] * w[0] + mesh.positions[b] * w[1] + mesh.positions[c] * w[2],
                normal: normal.try_normalize().unwrap_or(face),
                face,
            })
        })
        .collect()
}

fn texel_place(uv: Vec2, size: usize) -> Vec2 {
    Vec2::new(uv.x, 1.0 - uv.y) * size as f32
}

/// A picture to take colours from, ready to be asked.
struct Source {
    camera: Camera,
    eye: Vec3,
    /// Linear light.
    color: Vec<[f32; 3]>,
    /// How far each pixel may be trusted, 0..1.
    trust: Vec<f32>,
    /// The nearest surface around each pixel.
    nearest: Vec<f32>,
    /// How far behind it a point may lie and still be seen, beside what pixels and slopes make.
    slack: f32,
}

impl Source {
    /// Position in the picture, camera z and cosine of the view on `texel`; None when it is hidden or looks away.
    fn sees(&self, texel: &Texel) -> Option<(Vec2, f32)> {
        let c = &self.camera;
        let p = c.rotation * texel.position + c.translation;
        let to_eye = (self.eye - texel.position).normalize_or_zero();
        let straight = texel.face.dot(to_eye).min(texel.normal.dot(to_eye).max(0.5 * texel.face.dot(to_eye)));
        if straight < 0.1 || p.z <= 0.01 {
            return None;
        }
        let at = Vec2::new(c.fx * p.x / p.z + c.cx, c.fy * p.y / p.z + c.cy);
        if !(at.x >= 1.0 && at.y >= 1.0 && at.x < c.width as f32 - 1.0 && at.y < c.height as f32 - 1.0) {
            return None;
        }
        let nearest = self.nearest[at.y as usize * c.width as usize + at.x as usize];
        let pixel = p.z / c.fx;
        let slope = (1.0 - straight * straight).sqrt() / straight;
        let tolerance = 2.5 * pixel * (1.0 + slope.min(5.0)) + self.slack;
        (nearest > 0.0 && p.z <= nearest + tolerance).then_some((at, straight))
    }

    /// Bilinear colour and trust.
    fn at(&self, at: Vec2) -> ([f32; 3], f32) {
        let w = self.camera.width as usize;
        let q = at - Vec2::splat(0.5);
        let (x, y) = (q.x as usize, q.y as usize);
        let (tx, ty) = (q.x - x as f32, q.y - y as f32);
        let i = y * w + x;
        let mut color = [0f32; 3];
        let (mut sum, mut trust) = (0f32, 0f32);
        for (j, share) in
            [(i, (1.0 - tx) * (1.0 - ty)), (i + 1, tx * (1.0 - ty)), (i + w, (1.0 - tx) * ty), (i + w + 1, tx * ty)]
        {
            // What is not trusted gives no colour.
            let k = share * (self.trust[j] + 1e-6);
            for (c, v) in color.iter_mut().zip(self.color[j]) {
                *c += k * v;
            }
            sum += k;
            trust += share * self.trust[j];
        }
        (color.map(|c| c / sum.max(1e-12)), trust)
    }
}

/// The least of what is there (> 0) in the square of `reach` pixels around each pixel.
fn nearest_around(depth: &[f32], width: usize, height: usize, reach: usize) -> Vec<f32> {
    let least = |values: &mut dyn Iterator<Item = f32>| {
        let m = values.filter(|d| *d > 0.0).fold(f32::INFINITY, f32::min);
        if m.is_finite() { m } else { 0.0 }
    };
    let mut rows = vec![0f32; depth.len()];
    rows.par_chunks_mut(width.max(1)).zip(depth.par_chunks(width.max(1))).for_each(|(out, row)| {
        for (x, out) in out.iter_mut().enumerate() {
            let window = &row[x.saturating_sub(reach)..(x + reach + 1).min(width)];
            *out = least(&mut window.iter().copied());
        }
    });
    let mut result = vec![0f32; depth.len()];
    result.par_chunks_mut(width.max(1)).enumerate().for_each(|(y, out)| {
        let (from, to) = (y.saturating_sub(reach), (y + reach + 1).min(height));
        for (x, out) in out.iter_mut().enumerate() {
            *out = least(&mut (from..to).map(|y| rows[y * width + x]));
        }
    });
    result
}

fn rendered_source(view: &View, mesh_seen: &Seen, background: [f32; 3], linear: &Linear) -> Source {
    let (w, h) = (mesh_seen.width, mesh_seen.height);
    let solid = |i: usize| view.alpha[i] >= 0.5 && view.depth[i] > 0.0;
    // Both the mesh and what was rendered may hide a point.
    let depth: Vec<f32> = (0..w * h)
        .map(|i| match (mesh_seen.depth[i], solid(i)) {
            (m, true) if m > 0.0 => m.min(view.depth[i]),
            (m, _) => m,
        })
        .collect();
    let trust = (0..w * h)
        .map(|i| {
            if !solid(i) || mesh_seen.depth[i] <= 0.0 {
                return 0.0;
            }
            let behind = (view.depth[i] - mesh_seen.depth[i]) / 0.08;
            ((view.alpha[i] - 0.5) / 0.45).clamp(0.0, 1.0).powi(2) * (1.0 - behind).clamp(0.02, 1.0)
        })
        .collect();
    let color = (0..w * h)
        .map(|i| {
            let a = view.alpha[i].clamp(0.5, 1.0);
            std::array::from_fn(|k| linear.of((view.color[i][k] - (1.0 - a) * background[k]) / a))
        })
        .collect();
    let eye = view.camera.position();
    Source { camera: view.camera, eye, color, trust, nearest: nearest_around(&depth, w, h, 1), slack: 0.006 }
}

fn photo_source(photo: &PhotoView, mesh_seen: &Seen, linear: &Linear) -> Source {
    let (w, h) = (mesh_seen.width, mesh_seen.height);
    let reach = (w / 170).max(1);
    // Inside the mask by `reach` pixels or more: full trust; none at its edge.
    let off: Vec<f32> = photo.mask.iter().map(|m| (1.0 - m).clamp(0.0, 1.0) + 1e-3).collect();
    let inverse: Vec<f32> = off.iter().map(|m| 1.002 - m).map(|m| m.max(1e-3)).collect();
    let eroded = nearest_around(&inverse, w, h, reach);
    let trust = box_mean(&eroded, w, h, reach).iter().map(|m| ((m - 0.5) * 2.0).clamp(0.0, 1.0)).collect();
    let color = photo.color.iter().map(|c| c.map(|v| linear.of(v))).collect();
    Source {
        camera: photo.camera,
        eye: photo.camera.position(),
        color,
        trust,
        nearest: nearest_around(&mesh_seen.depth, w, h, reach),
        // What hides so little is a bump that should not be there.
        slack: 0.03,
    }
}

fn box_mean(values: &[f32], width: usize, height: usize, reach: usize) -> Vec<f32> {
    (0..width * height)
        .into_par_iter()
        .map(|i| {
            let (x, y) = (i % width, i / width);
            let (mut sum, mut count) = (0.0, 0);
            for y in y.saturating_sub(reach)..(y + reach + 1).min(height) {
                for x in x.saturating_sub(reach)..(x + reach + 1).min(width) {
                    sum += values[y * width + x];
                    count += 1;
                }
            }
            sum / count as f32
        })
        .collect()
}

/// The cameras that colours come from.
pub fn color_cameras(count: usize, size: u32) -> Vec<Camera> {
    fibonacci_sphere(count).iter().map(|d| Camera::look_at(*d * VIEW_DISTANCE, Vec3::ZERO, VIEW_FOV, size)).collect()
}

/// Bakes the finest level.
pub fn bake(
    mesh: &Mesh,
    size: u32,
    render: &(dyn Fn(&Camera) -> View + Sync),
    photo: Option<&PhotoView>,
    options: &Options,
    progress: &dyn Progress,
) -> Result<Baked> {
    let size = size as usize;
    let texels = texels(mesh, size);
    let linear = Linear::new();
    let mut sums = vec![[0f32; 4]; texels.len()];
    let cameras = color_cameras(options.color_views, options.color_size);
    for (done, camera) in cameras.iter().enumerate() {
        progress.check()?;
        let view = rendered(render, camera)?;
        let seen = visibility(&mesh.positions, &mesh.triangles, &view.camera);
        let source = rendered_source(&view, &seen, options.background, &linear);
        sums.par_iter_mut().zip(&texels).for_each(|(sum, texel)| {
            if let Some((at, straight)) = source.sees(texel) {
                let (color, trust) = source.at(at);
                let weight = straight.powi(4) * trust;
                for (sum, c) in sum.iter_mut().zip(color) {
                    *sum += weight * c;
                }
                sum[3] += weight;
            }
        });
        progress.step(done as u64 + 1);
    }
    let known = |sum: &[f32; 4]| sum[3] > 1e-4;
    let unseen = Surroundings::new(
        texels
            .iter()
            .zip(&sums)
            .filter(|(_, s)| known(s))
            .map(|(t, s)| (t.position, [s[0] / s[3], s[1] / s[3], s[2] / s[3]])),
    );
    let photo = photo.filter(|p| p.camera.width > 0 && p.camera.height > 0).map(|photo| {
        let seen = visibility(&mesh.positions, &mesh.triangles, &photo.camera);
        photo_source(photo, &seen, &linear)
    });
    let colors: Vec<([f32; 3], f32)> = texels
        .par_iter()
        .zip(&sums)
        .map(|(texel, sum)| {
            let around = if known(sum) {
                [sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]]
            } else {
                unseen.at(texel.position)
            };
            let Some((source, (at, straight))) = photo.as_ref().and_then(|s| Some((s, s.sees(texel)?))) else {
                return (around, 0.0);
            };
            let (color, trust) = source.at(at);
            let share = trust * smoothstep(0.2, 0.45, straight);
            (std::array::from_fn(|k| around[k] + share * (color[k] - around[k])), share)
        })
        .collect();
    let mut baked = Baked { size, color: vec![[0.0; 3]; size * size], from_photo: vec![-1.0; size * size] };
    for (texel, (color, share)) in texels.iter().zip(colors) {
        baked.color[texel.index as usize] = color;
        baked.from_photo[texel.index as usize] = share;
    }
    pad(&mut baked.color, &baked.from_photo, size);
    Ok(baked)
}

/// A coarser level's texture out of the finest one's, by closest points that look the same way.
pub fn transfer(mesh: &Mesh, size: u32, fine: &Mesh, fine_bvh: &Bvh, fine_baked: &Baked) -> Baked {
    /// Each texel is the mean of this many samples squared.
    const FINER: usize = 2;
    let size = size as usize;
    let samples: Vec<(u32, [f32; 3], f32)> = texels(mesh, size * FINER)
        .par_iter()
        .filter_map(|texel| {
            let looks_alike = |t: u32| cross(&fine.positions, &fine.triangles[t as usize]).dot(texel.normal) > 0.0;
            let found = fine_bvh
                .closest(texel.position, 0.3, looks_alike)
                .or_else(|| fine_bvh.closest(texel.position, 100.0, |_| true))?;
            let t = fine.triangles[found.triangle as usize].map(|i| i as usize);
            let w = barycentric_3d(found.point, t.map(|i| fine.positions[i]));
            let uv = fine.uvs[t[0]] * w.x + fine.uvs[t[1]] * w.y + fine.uvs[t[2]] * w.z;
            let (color, share) = bilinear(fine_baked, uv);
            let (x, y) = (texel.index as usize % (size * FINER) / FINER, texel.index as usize / (size * FINER) / FINER);
            Some(((y * size + x) as u32, color, share))
        })
        .collect();
    let mut sums = vec![([0f32; 3], 0f32, 0f32); size * size];
    for (i, color, share) in samples {
        let sum = &mut sums[i as usize];
        for (s, c) in sum.0.iter_mut().zip(color) {
            *s += c;
        }
        sum.1 += share;
        sum.2 += 1.0;
    }
    let mut color: Vec<[f32; 3]> = sums.iter().map(|s| s.0.map(|c| c / s.2.max(1.0))).collect();
    let from_photo: Vec<f32> = sums.iter().map(|s| if s.2 > 0.0 { s.1 / s.2 } else { -1.0 }).collect();
    pad(&mut color, &from_photo, size);
    Baked { size, color, from_photo }
}

fn barycentric_3d(p: Vec3, [a, b, c]: [Vec3; 3]) -> Vec3 {
    let n = (b - a).cross(c - a);
    let area = n.length_squared();
    if area <= 1e-30 {
        return Vec3::X;
    }
    let v = (p - a).cross(c - a).dot(n) / area;
    let w = (b - a).cross(p - a).dot(n) / area;
    Vec3::new(1.0 - v - w, v, w)
}

fn bilinear(baked: &Baked, uv: Vec2) -> ([f32; 3], f32) {
    let n = baked.size;
    let q = (texel_place(uv, n) - Vec2::splat(0.5)).clamp(Vec2::ZERO, Vec2::splat((n - 1) as f32 - 1e-3));
    let (x, y) = (q.x as usize, q.y as usize);
    let (tx, ty) = (q.x - x as f32, q.y - y as f32);
    let i = y * n + x;
    let corners =
        [(i, (1.0 - tx) * (1.0 - ty)), (i + 1, tx * (1.0 - ty)), (i + n, (1.0 - tx) * ty), (i + n + 1, tx * ty)];
    let mut color = [0f32; 3];
    let (mut photo, mut covered) = (0f32, 0f32);
    for (j, share) in corners {
        for (c, v) in color.iter_mut().zip(baked.color[j]) {
            *c += share * v;
        }
        if baked.from_photo[j] >= 0.0 {
            photo += share * baked.from_photo[j];
            covered += share;
        }
    }
    (color, if covered > 0.0 { photo / covered } else { 0.0 })
}

fn smoothstep(from: f32, to: f32, x: f32) -> f32 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Colours of a surface's neighbourhood, for points that no view sees: a coarse grid, filled outward from what is known.
struct Surroundings {
    cells: Vec<[f32; 3]>,
}

impl Surroundings {
    const N: usize = 40;
    const HALF: f32 = 1.1;

    fn cell(p: Vec3) -> usize {
        let q = ((p + Vec3::splat(Self::HALF)) / (2.0 * Self::HALF) * Self::N as f32)
            .clamp(Vec3::ZERO, Vec3::splat(Self::N as f32 - 1.0));
        (q.z as usize * Self::N + q.y as usize) * Self::N + q.x as usize
    }

    fn new(known: impl Iterator<Item = (Vec3, [f32; 3])>) -> Self {
        let n = Self::N;
        let mut sums = vec![[0f64; 4]; n * n * n];
        for (p, color) in known {
            let sum = &mut sums[Self::cell(p)];
            for (s, c) in sum.iter_mut().zip(color) {
                *s += c as f64;
            }
            sum[3] += 1.0;
        }
        let mut cells: Vec<Option<[f32; 3]>> =
            sums.iter().map(|s| (s[3] > 0.0).then(|| [s[0], s[1], s[2]].map(|c| (c / s[3]) as f32))).collect();
        let mut front: Vec<usize> = (0..cells.len()).filter(|&i| cells[i].is_some()).collect();
        while !front.is_empty() {
            let mut next = std::collections::BTreeMap::<usize, ([f32; 3], f32)>::new();
            for &i in &front {
                let Some(color) = cells[i] else { continue };
                let at = [i % n, i / n % n, i / (n * n)];
                for (axis, stride) in [(0, 1), (1, n), (2, n * n)] {
                    let below = (at[axis] > 0).then(|| i - stride);
                    let above = (at[axis] + 1 < n).then_some(i + stride);
                    for j in [below, above].into_iter().flatten().filter(|&j| cells[j].is_none()) {
                        let sum = next.entry(j).or_default();
                        for (s, c) in sum.0.iter_mut().zip(color) {
                            *s += c;
                        }
                        sum.1 += 1.0;
                    }
                }
            }
            front = next.keys().copied().collect();
            for (i, (color, count)) in next {
                cells[i] = Some(color.map(|c| c / count));
            }
        }
        Surroundings { cells: cells.into_iter().map(|c| c.unwrap_or([0.2; 3])).collect() }
    }

    fn at(&self, p: Vec3) -> [f32; 3] {
        self.cells[Self::cell(p)]
    }
}

/// Colours for texels that no triangle covers (`covered` < 0): neighbours first, then ever larger blocks' means, so that
/// neither bilinear lookups nor smaller pictures of the texture pick up anything foreign.
fn pad(color: &mut [[f32; 3]], covered: &[f32], size: usize) {
    let mut known: Vec<bool> = covered.iter().map(|c| *c >= 0.0).collect();
    for _ in 0..3 {
        let fresh: Vec<(usize, [f32; 3])> = (0..size * size)
            .into_par_iter()
            .filter(|&i| !known[i])
            .filter_map(|i| {
                let (x, y) = (i % size, i / size);
                let (mut sum, mut count) = ([0f32; 3], 0f32);
                for y in y.saturating_sub(1)..(y + 2).min(size) {
                    for x in x.saturating_sub(1)..(x + 2).min(size) {
                        if known[y * size + x] {
                            for (s, c) in sum.iter_mut().zip(color[y * size + x]) {
                                *s += c;
                            }
                            count += 1.0;
                        }
                    }
                }
                (count > 0.0).then(|| (i, sum.map(|s| s / count)))
            })
            .collect();
        for (i, c) in fresh {
            color[i] = c;
            known[i] = true;
        }
    }
    fill_from_blocks(color, &known, size);
}

fn fill_from_blocks(color: &mut [[f32; 3]], known: &[bool], size: usize) {
    if size < 2 || known.iter().all(|k| *k) {
        return;
    }
    let half = size / 2;
    let mut small = vec![[0f32; 3]; half * half];
    let mut small_known = vec![false; half * half];
    for i in 0..half * half {
        let (x, y) = (i % half * 2, i / half * 2);
        let mut count = 0.0;
        for j in [y * size + x, y * size + x + 1, (y + 1) * size + x, (y + 1) * size + x + 1] {
            if known[j] {
                for (s, c) in small[i].iter_mut().zip(color[j]) {
                    *s += c;
                }
                count += 1.0;
            }
        }
        if count > 0.0 {
            small[i] = small[i].map(|s| s / count);
            small_known[i] = true;
        }
    }
    fill_from_blocks(&mut small, &small_known, half);
    for (i, c) in color.iter_mut().enumerate() {
        if !known[i] {
            *c = small[i / size / 2 * half + i % size / 2];
        }
    }
}
