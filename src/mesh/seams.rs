//! Where charts meet: how much their colours differ there, and how to make them agree.

use super::Mesh;
use glam::Vec2;
use image::RgbImage;

/// Differences along all seams, in steps of 255 of sRGB, the mean of the three channels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seams {
    /// Over the seams' length.
    pub mean: f32,
    /// What 95 % of the length stays below.
    pub most: f32,
    /// Length of all seams, each counted once, scene units.
    pub length: f32,
}

/// How far a texture's colours on both sides of the seams are apart, with bilinear filtering.
pub fn seams(mesh: &Mesh, texture: &RgbImage) -> Seams {
    let bytes: Vec<[f32; 3]> = texture.pixels().map(|p| p.0.map(f32::from)).collect();
    let mut found: Vec<(f32, f32)> = samples(mesh, texture.width() as usize)
        .iter()
        .map(|s| (s.step(&bytes).iter().map(|d| d.abs()).sum::<f32>() / 3.0, s.length))
        .collect();
    found.sort_by(|x, y| x.0.total_cmp(&y.0));
    let length: f32 = found.iter().map(|f| f.1).sum();
    let mean = found.iter().map(|f| f.0 * f.1).sum::<f32>() / length.max(1e-12);
    let mut below = 0.0;
    let most = found.iter().find(|f| {
        below += f.1;
        below >= 0.95 * length
    });
    Seams { mean, most: most.map_or(0.0, |f| f.0), length }
}

/// Moves colours as little as makes both sides of every seam filter to the same: the projection onto each sample's equation
/// in turn, over and over (Kaczmarz 1937). `color`: `size`² texels, rows from the top.
pub fn closed(mesh: &Mesh, color: &mut [[f32; 3]], size: usize) {
    const ROUNDS: usize = 24;
    let samples = samples(mesh, size);
    for _ in 0..ROUNDS {
        for s in &samples {
            let step = s.step(color);
            let norm: f32 = s.sides.iter().flatten().map(|(_, w)| w * w).sum();
            for (side, sign) in s.sides.iter().zip([-1.0, 1.0]) {
                for (i, w) in side {
                    for (c, d) in color[*i as usize].iter_mut().zip(step) {
                        *c = (*c + sign * d * w / norm).clamp(0.0, 1.0);
                    }
                }
            }
        }
    }
}

/// One point of a seam: the texels that it is filtered from in either chart, with their weights.
struct Sample {
    sides: [[(u32, f32); 4]; 2],
    /// Of the seam that it stands for, scene units.
    length: f32,
}

impl Sample {
    /// The first side's colour less the second's.
    fn step(&self, color: &[[f32; 3]]) -> [f32; 3] {
        let mut sum = [0.0; 3];
        for (side, sign) in self.sides.iter().zip([1.0, -1.0]) {
            for (i, w) in side {
                for (s, c) in sum.iter_mut().zip(color[*i as usize]) {
                    *s += sign * w * c;
                }
            }
        }
        sum
    }
}

/// Points along each edge that two charts share, about a texel apart.
fn samples(mesh: &Mesh, size: usize) -> Vec<Sample> {
    let mut edges: Vec<([[u32; 3]; 2], [u32; 2])> = Vec::with_capacity(mesh.triangles.len() * 3);
    for t in &mesh.triangles {
        for k in 0..3 {
            let (a, b) = (t[k], t[(k + 1) % 3]);
            let (pa, pb) = (place(mesh, a), place(mesh, b));
            // The same way round on either side.
            edges.push(if pa <= pb { ([pa, pb], [a, b]) } else { ([pb, pa], [b, a]) });
        }
    }
    edges.sort_unstable();
    let mut found = Vec::new();
    for pair in edges.chunk_by(|x, y| x.0 == y.0) {
        let [(_, [a, b]), (_, [c, d])] = pair else { continue };
        if a == c && b == d {
            continue;
        }
        let uv = [a, b, c, d].map(|i| mesh.uvs[*i as usize]);
        let texels = (uv[1] - uv[0]).length().max((uv[3] - uv[2]).length()) * size as f32;
        let count = (texels.ceil() as usize).clamp(1, 4096);
        let length = mesh.positions[*a as usize].distance(mesh.positions[*b as usize]) / count as f32;
        found.extend((0..count).map(|k| {
            let along = (k as f32 + 0.5) / count as f32;
            let sides = [uv[0].lerp(uv[1], along), uv[2].lerp(uv[3], along)].map(|uv| bilinear(uv, size));
            Sample { sides, length }
        }));
    }
    found
}

fn place(mesh: &Mesh, vertex: u32) -> [u32; 3] {
    mesh.positions[vertex as usize].to_array().map(f32::to_bits)
}

/// The four texels around a place, and their weights.
fn bilinear(uv: Vec2, size: usize) -> [(u32, f32); 4] {
    let last = size as u32 - 1;
    let at = (Vec2::new(uv.x, 1.0 - uv.y) * size as f32 - 0.5).clamp(Vec2::ZERO, Vec2::splat(last as f32));
    let (left, top) = (at.x as u32, at.y as u32);
    let f = at - at.floor();
    [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(x, y)| {
        let weight = if x == 0 { 1.0 - f.x } else { f.x } * if y == 0 { 1.0 - f.y } else { f.y };
        ((top + y).min(last) * size as u32 + (left + x).min(last), weight)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    /// Two triangles of a square whose halves lie apart in the texture: the left quarter and the right one.
    fn square() -> Mesh {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
        let uvs = [(0.1, 0.1), (0.2, 0.1), (0.1, 0.2), (0.9, 0.1), (0.9, 0.2), (0.8, 0.2)];
        Mesh {
            positions: corners.to_vec(),
            normals: vec![Vec3::Z; 6],
            uvs: uvs.map(|(x, y)| Vec2::new(x, y)).to_vec(),
            triangles: vec![[0, 1, 2], [3, 4, 5]],
        }
    }

    #[test]
    fn the_step_between_two_charts_is_measured_along_their_edge() {
        let even = RgbImage::from_pixel(64, 64, image::Rgb([90, 90, 90]));
        let seen = seams(&square(), &even);
        assert!((seen.length - 2f32.sqrt()).abs() < 1e-5);
        assert!(seen.mean < 1e-4 && seen.most < 1e-4, "{seen:?}");
        let step =
            RgbImage::from_fn(
                64,
                64,
                |x, _| if x < 32 { image::Rgb([90, 90, 90]) } else { image::Rgb([100, 90, 110]) },
            );
        let seen = seams(&square(), &step);
        assert!((seen.mean - 10.0).abs() < 1e-4 && (seen.most - 10.0).abs() < 1e-4, "{seen:?}");
    }

    #[test]
    fn faces_of_one_chart_have_no_seam() {
        let mut mesh = square();
        mesh.triangles[1] = [1, 4, 2];
        assert_eq!(seams(&mesh, &RgbImage::new(8, 8)), Seams::default());
    }

    #[test]
    fn closed_seams_show_no_step_and_little_else_moves() {
        let mesh = square();
        let size = 64;
        let before: Vec<[f32; 3]> =
            (0..size * size).map(|i| if i % size < size / 2 { [0.2, 0.4, 0.5] } else { [0.3, 0.4, 0.1] }).collect();
        let mut color = before.clone();
        closed(&mesh, &mut color, size);
        for s in samples(&mesh, size) {
            assert!(s.step(&color).iter().all(|d| d.abs() < 2e-3), "{:?}", s.step(&color));
        }
        let moved = before.iter().zip(&color).filter(|(a, b)| (0..3).any(|k| (a[k] - b[k]).abs() > 1e-6)).count();
        assert!(moved < 60, "{moved} texels");
        let furthest =
            before.iter().zip(&color).flat_map(|(a, b)| (0..3).map(|k| (a[k] - b[k]).abs())).fold(0.0, f32::max);
        assert!(furthest < 0.45, "{furthest}");
    }
}
