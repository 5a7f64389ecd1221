//! Triangles to pixels: z-buffer, perspective-correct.

use super::Mesh;
use super::color::{Linear, to_byte, to_linear, to_srgb};
use crate::splat::Camera;
use glam::{Vec2, Vec3};
use image::{Rgb, RgbImage};
use rayon::prelude::*;
use std::ops::Range;

/// Nothing is drawn nearer than this, scene units; a triangle that reaches nearer is left out.
const NEAR: f32 = 0.01;
/// Rows that one thread draws.
const BAND: usize = 32;

/// What a camera sees of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    pub width: usize,
    pub height: usize,
    /// Camera z; 0 where nothing is.
    pub depth: Vec<f32>,
    /// Triangle number; `u32::MAX` where nothing is.
    pub triangle: Vec<u32>,
}

/// Corners in pixels, and 1/z of each.
type Projected = ([Vec2; 3], Vec3);

fn project(positions: &[Vec3], triangles: &[[u32; 3]], camera: &Camera) -> Vec<Option<Projected>> {
    let points: Vec<Vec3> = positions.iter().map(|p| camera.rotation * *p + camera.translation).collect();
    triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|i| points[i as usize]);
            if !(a.z > NEAR && b.z > NEAR && c.z > NEAR) {
                return None;
            }
            let pixel = |p: Vec3| Vec2::new(camera.fx * p.x / p.z + camera.cx, camera.fy * p.y / p.z + camera.cy);
            Some(([pixel(a), pixel(b), pixel(c)], Vec3::new(1.0 / a.z, 1.0 / b.z, 1.0 / c.z)))
        })
        .collect()
}

/// Barycentric coordinates on the screen; None outside.
fn weights([a, b, c]: &[Vec2; 3], p: Vec2) -> Option<Vec3> {
    let area = (*b - *a).perp_dot(*c - *a);
    let v = (p - *a).perp_dot(*c - *a) / area;
    let w = (*b - *a).perp_dot(p - *a) / area;
    let u = 1.0 - v - w;
    (u >= -1e-5 && v >= -1e-5 && w >= -1e-5).then_some(Vec3::new(u, v, w))
}

/// Whether [`weights`] are sure to say that a point lies outside: without its divisions, and a little more strictly than they
/// could be rounded.
fn beside([a, b, c]: &[Vec2; 3], p: Vec2) -> bool {
    let area = (*b - *a).perp_dot(*c - *a);
    let v = (p - *a).perp_dot(*c - *a);
    let w = (*b - *a).perp_dot(p - *a);
    let (size, v, w) = if area < 0.0 { (-area, -v, -w) } else { (area, v, w) };
    let least = -2e-5 * size;
    v < least || w < least || v + w > 1.001 * size
}

/// A triangle and the box of pixels whose middles it may hold.
struct Drawn {
    triangle: u32,
    columns: Range<usize>,
    rows: Range<usize>,
}

/// Of triangles, in their order, what there is to draw in each band of rows.
fn bands(projected: &[Option<Projected>], width: usize, height: usize) -> Vec<Vec<Drawn>> {
    // Casts, not ceil() and floor(): those are calls on plain x86-64.
    let first = |v: f32| {
        let at = (v - 0.5).max(0.0);
        let whole = at as usize;
        whole.saturating_add(usize::from((whole as f32) < at))
    };
    let end = |v: f32, n: usize| if v >= 0.5 { ((v - 0.5) as usize).saturating_add(1).min(n) } else { 0 };
    let mut bands: Vec<Vec<Drawn>> = Vec::new();
    bands.resize_with(height.div_ceil(BAND), Vec::new);
    for (t, corners) in projected.iter().enumerate() {
        let Some((corners, _)) = corners else { continue };
        let lo = corners[0].min(corners[1]).min(corners[2]);
        let hi = corners[0].max(corners[1]).max(corners[2]);
        let (columns, rows) = (first(lo.x)..end(hi.x, width), first(lo.y)..end(hi.y, height));
        if columns.is_empty() || rows.is_empty() {
            continue;
        }
        for (band, drawn) in bands.iter_mut().enumerate().take(rows.end.div_ceil(BAND)).skip(rows.start / BAND) {
            let top = band * BAND;
            let rows = rows.start.max(top)..rows.end.min(top + BAND);
            drawn.push(Drawn { triangle: t as u32, columns: columns.clone(), rows });
        }
    }
    bands
}

/// The z-buffer of a mesh, both sides of every triangle.
pub fn visibility(positions: &[Vec3], triangles: &[[u32; 3]], camera: &Camera) -> Seen {
    let projected = project(positions, triangles, camera);
    let (width, height) = (camera.width as usize, camera.height as usize);
    let mut depth = vec![0f32; width * height];
    let mut triangle = vec![u32::MAX; width * height];
    if width > 0 {
        let bands = bands(&projected, width, height);
        let pixels = depth.par_chunks_mut(BAND * width).zip(triangle.par_chunks_mut(BAND * width));
        pixels.zip(&bands).enumerate().for_each(|(band, ((depth, triangle), drawn))| {
            let top = band * BAND;
            for Drawn { triangle: t, columns, rows } in drawn {
                let Some((corners, inverse_z)) = &projected[*t as usize] else { continue };
                for y in rows.clone() {
                    for x in columns.clone() {
                        let p = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                        if beside(corners, p) {
                            continue;
                        }
                        let Some(w) = weights(corners, p) else { continue };
                        let z = 1.0 / w.dot(*inverse_z);
                        let i = (y - top) * width + x;
                        if triangle[i] == u32::MAX || z < depth[i] {
                            depth[i] = z;
                            triangle[i] = *t;
                        }
                    }
                }
            }
        });
    }
    Seen { width, height, depth, triangle }
}

/// Bilinear, clamped at the rim; `uv` has its origin lower left.
pub fn texture_at(texture: &RgbImage, uv: Vec2) -> [f32; 3] {
    let (w, h) = texture.dimensions();
    if w == 0 || h == 0 {
        return [0.0; 3];
    }
    let x = (uv.x * w as f32 - 0.5).clamp(0.0, (w - 1) as f32);
    let y = ((1.0 - uv.y) * h as f32 - 0.5).clamp(0.0, (h - 1) as f32);
    let (x0, y0) = (x as u32, y as u32);
    let (x1, y1) = ((x0 + 1).min(w - 1), (y0 + 1).min(h - 1));
    let (tx, ty) = (x - x0 as f32, y - y0 as f32);
    let [a, b, c, d] = [(x0, y0), (x1, y0), (x0, y1), (x1, y1)].map(|(x, y)| texture.get_pixel(x, y).0.map(f32::from));
    std::array::from_fn(|k| {
        let top = a[k] * (1.0 - tx) + b[k] * tx;
        let bottom = c[k] * (1.0 - tx) + d[k] * tx;
        top * (1.0 - ty) + bottom * ty
    })
}

/// A picture of a mesh: its texture as it is, or grey under a lamp at the camera when there is none.
///
/// Each pixel is the mean (in linear light) of `supersample`² samples. Triangles that reach behind the camera are left out.
pub fn raster(
    mesh: &Mesh,
    texture: Option<&RgbImage>,
    camera: &Camera,
    background: [u8; 3],
    supersample: u32,
) -> RgbImage {
    let [picture] = match texture {
        Some(texture) => rasters(mesh, [texture], camera, background, supersample),
        None => composed(&covered(mesh, camera, supersample, lamp(mesh, camera)), camera, background),
    };
    picture
}

/// [`raster`] of one mesh in several textures: what is seen where is found once.
pub fn rasters<const N: usize>(
    mesh: &Mesh,
    textures: [&RgbImage; N],
    camera: &Camera,
    background: [u8; 3],
    supersample: u32,
) -> [RgbImage; N] {
    composed(&covered(mesh, camera, supersample, painted(mesh, textures)), camera, background)
}

/// Pictures of what [`covered`] found, before a background.
fn composed<const N: usize>(pixels: &[([[f32; 3]; N], f32)], camera: &Camera, background: [u8; 3]) -> [RgbImage; N] {
    let linear = background.map(|c| to_linear(c as f32 / 255.0));
    let nothing = [linear.map(to_byte); N];
    let bytes: Vec<[[u8; 3]; N]> = pixels
        .par_iter()
        .map(|(own, share)| match *share > 0.0 {
            true => own.map(|own| std::array::from_fn(|k| to_byte(own[k] + (1.0 - share) * linear[k]))),
            false => nothing,
        })
        .collect();
    std::array::from_fn(|n| {
        let at = |x: u32, y: u32| bytes[(y * camera.width + x) as usize][n];
        RgbImage::from_fn(camera.width, camera.height, |x, y| Rgb(at(x, y)))
    })
}

/// A mesh without what is behind it: straight colours (sRGB 0..1, `nothing` where there is none) and the share of each pixel
/// that it covers, rows from the top.
pub fn cut_out(
    mesh: &Mesh,
    texture: &RgbImage,
    camera: &Camera,
    supersample: u32,
    nothing: [f32; 3],
) -> (Vec<[f32; 3]>, Vec<f32>) {
    let straight = |([own], share): ([[f32; 3]; 1], f32)| {
        let color = if share > 0.0 { own.map(|c| to_srgb((c / share).clamp(0.0, 1.0))) } else { nothing };
        (color, share)
    };
    covered(mesh, camera, supersample, painted(mesh, [texture])).into_par_iter().map(straight).unzip()
}

/// The colour of a point of a mesh in each texture, linear light: of a triangle's number and barycentric coordinates.
fn painted<const N: usize>(mesh: &Mesh, textures: [&RgbImage; N]) -> impl Fn(usize, Vec3) -> [[f32; 3]; N] {
    let table = Linear::default();
    move |t, w| {
        let [a, b, c] = mesh.triangles[t].map(|v| v as usize);
        let uv = mesh.uvs[a] * w.x + mesh.uvs[b] * w.y + mesh.uvs[c] * w.z;
        textures.map(|texture| texture_at(texture, uv).map(|v| table.of(v / 255.0)))
    }
}

/// The same of grey under a lamp at the camera.
fn lamp(mesh: &Mesh, camera: &Camera) -> impl Fn(usize, Vec3) -> [[f32; 3]; 1] {
    let eye = camera.position();
    move |t, w| {
        let [a, b, c] = mesh.triangles[t].map(|v| v as usize);
        let n = mesh.normals[a] * w.x + mesh.normals[b] * w.y + mesh.normals[c] * w.z;
        let p = mesh.positions[a] * w.x + mesh.positions[b] * w.y + mesh.positions[c] * w.z;
        let lit = n.normalize_or_zero().dot((eye - p).normalize_or_zero()).max(0.0);
        [[0.05 + 0.65 * lit; 3]]
    }
}

/// Of each pixel the mean over its samples: what they are coloured, 0 beside the mesh, and the share of samples on it.
fn covered<const N: usize>(
    mesh: &Mesh,
    camera: &Camera,
    supersample: u32,
    color: impl Fn(usize, Vec3) -> [[f32; 3]; N] + Sync,
) -> Vec<([[f32; 3]; N], f32)> {
    let s = supersample.clamp(1, 8);
    let fine = camera.resized(camera.width * s, camera.height * s);
    let seen = visibility(&mesh.positions, &mesh.triangles, &fine);
    let projected = project(&mesh.positions, &mesh.triangles, &fine);
    let sample = |i: usize| -> Option<[[f32; 3]; N]> {
        let t = seen.triangle[i] as usize;
        let (corners, inverse_z) = projected.get(t)?.as_ref()?;
        let p = Vec2::new((i % seen.width) as f32 + 0.5, (i / seen.width) as f32 + 0.5);
        let w = weights(corners, p)? * *inverse_z * seen.depth[i];
        Some(color(t, w))
    };
    let (width, height) = (camera.width as usize, camera.height as usize);
    let s = s as usize;
    let mean = |v: f32| v / (s * s) as f32;
    (0..width * height)
        .into_par_iter()
        .map(|i| {
            let (x, y) = (i % width, i / width);
            let (mut sums, mut share) = ([[0f32; 3]; N], 0f32);
            for k in 0..s * s {
                if let Some(colors) = sample((y * s + k / s) * seen.width + x * s + k % s) {
                    for (sum, v) in sums.as_flattened_mut().iter_mut().zip(colors.as_flattened()) {
                        *sum += v;
                    }
                    share += 1.0;
                }
            }
            (sums.map(|sum| sum.map(mean)), mean(share))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square from (−1, −1) to (1, 1) in the plane y = `y`, seen from −y, upright.
    fn square(y: f32) -> Mesh {
        let at = |x: f32, z: f32| Vec3::new(x, y, z);
        Mesh {
            positions: vec![at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)],
            normals: vec![-Vec3::Y; 4],
            uvs: vec![Vec2::new(0.0, 0.0), Vec2::new(1.0, 0.0), Vec2::new(1.0, 1.0), Vec2::new(0.0, 1.0)],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
        }
    }

    #[test]
    fn a_texture_comes_out_upright_and_in_place() {
        let texture = RgbImage::from_fn(64, 64, |x, y| Rgb([4 * x as u8, 4 * y as u8, 0]));
        // The square fills the picture exactly.
        let camera = Camera::look_at(Vec3::new(0.0, -4.0, 0.0), Vec3::ZERO, 2.0 * (0.25f32).atan(), 64);
        let picture = raster(&square(0.0), Some(&texture), &camera, [255; 3], 1);
        for (x, y, p) in picture.enumerate_pixels() {
            let expected = texture.get_pixel(x, y);
            assert!(p.0.iter().zip(expected.0).all(|(a, b)| a.abs_diff(b) <= 1), "{x} {y} {p:?} {expected:?}");
        }
    }

    #[test]
    fn uv_is_perspective_correct() {
        let texture = RgbImage::from_fn(256, 4, |x, _| Rgb([x as u8, 0, 0]));
        let mut mesh = square(0.0);
        // Left side two units nearer than the right.
        for p in &mut mesh.positions {
            p.y = p.x;
        }
        let camera = Camera::look_at(Vec3::new(0.0, -4.0, 0.0), Vec3::ZERO, 0.9, 200);
        let picture = raster(&mesh, Some(&texture), &camera, [0, 255, 0], 1);
        let mut covered = 0;
        for x in 0..200 {
            let p = picture.get_pixel(x, 100).0;
            if p[1] == 255 {
                continue;
            }
            covered += 1;
            // Ray x = k·(y + 4) meets y = x.
            let k = (x as f32 + 0.5 - camera.cx) / camera.fx;
            let hit = 4.0 * k / (1.0 - k);
            assert!((p[0] as f32 - ((hit + 1.0) * 128.0 - 0.5)).abs() < 2.0, "{x}: {p:?} for {hit}");
        }
        assert!(covered > 80, "{covered}");
    }

    #[test]
    fn the_nearer_surface_wins_whatever_the_order() {
        let (near, far) = (square(-1.0), square(1.0));
        let camera = Camera::look_at(Vec3::new(0.0, -4.0, 0.0), Vec3::ZERO, 0.5, 32);
        for flip in [false, true] {
            let (a, b) = if flip { (&near, &far) } else { (&far, &near) };
            let positions: Vec<Vec3> = a.positions.iter().chain(&b.positions).copied().collect();
            let triangles = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
            let seen = visibility(&positions, &triangles, &camera);
            assert!(seen.depth.iter().all(|z| (z - 3.0).abs() < 1e-3));
            assert!(seen.triangle.iter().all(|t| (*t < 2) == flip));
        }
    }

    #[test]
    fn nothing_and_behind_are_background() {
        let camera = Camera::look_at(Vec3::new(0.0, -4.0, 0.0), Vec3::ZERO, 0.5, 8);
        for mesh in [Mesh::default(), square(-5.0), square(-4.0)] {
            assert!(raster(&mesh, None, &camera, [9, 8, 7], 2).pixels().all(|p| p.0 == [9, 8, 7]));
        }
        let lit = raster(&square(0.0), None, &camera, [0; 3], 2);
        assert!(lit.get_pixel(4, 4).0[0] > 200);
    }
}
