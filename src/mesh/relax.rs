//! Less stretch in a flat picture: as rigid as possible (Liu et al., "A Local/Global Approach to Mesh Parameterization",
//! 2008), started from a projection, by Gauss-Seidel sweeps.

use super::Surface;
use glam::Vec2;

const SWEEPS: usize = 60;

/// The faces' corners after relaxation; None when a face would turn over.
///
/// `flat`: the corners of each of `faces` before, all turning one way.
pub fn relax(surface: &Surface, faces: &[u32], flat: &[[Vec2; 3]]) -> Option<Vec<[Vec2; 3]>> {
    let total: f32 = flat.iter().map(signed_area).sum();
    let sense = total.signum();
    let mut used: Vec<u32> = faces.iter().flat_map(|&f| surface.triangles[f as usize]).collect();
    used.sort_unstable();
    used.dedup();
    let local = |i: u32| used.binary_search(&i).unwrap_or(0);
    let corners: Vec<[usize; 3]> = faces.iter().map(|&f| surface.triangles[f as usize].map(local)).collect();
    let mut at = vec![Vec2::ZERO; used.len()];
    for (c, t) in corners.iter().zip(flat) {
        for k in 0..3 {
            at[c[k]] = t[k];
        }
    }
    // Each face as it is in space, laid flat without stretch.
    let rest: Vec<[Vec2; 3]> = faces
        .iter()
        .map(|&f| {
            let [a, b, c] = surface.triangles[f as usize].map(|i| surface.positions[i as usize]);
            let (u, v) = (b - a, c - a);
            let length = u.length().max(1e-12);
            let x = u.dot(v) / length;
            [Vec2::ZERO, Vec2::new(length, 0.0), Vec2::new(x, sense * u.cross(v).length() / length)]
        })
        .collect();
    // Cotangent of the angle opposite each edge k → k + 1, kept positive.
    let weights: Vec<[f32; 3]> = rest
        .iter()
        .map(|t| {
            std::array::from_fn(|k| {
                let (u, v) = (t[k] - t[(k + 2) % 3], t[(k + 1) % 3] - t[(k + 2) % 3]);
                (u.dot(v) / u.perp_dot(v).abs().max(1e-12)).clamp(0.02, 20.0)
            })
        })
        .collect();
    let mut faces_of = vec![Vec::new(); used.len()];
    for (f, c) in corners.iter().enumerate() {
        for (k, &v) in c.iter().enumerate() {
            faces_of[v].push((f, k));
        }
    }
    for _ in 0..SWEEPS {
        let turns: Vec<Vec2> =
            corners.iter().zip(&rest).zip(&weights).map(|((c, r), w)| best_turn(c.map(|v| at[v]), r, w)).collect();
        for v in 0..used.len() {
            let (mut sum, mut weight) = (Vec2::ZERO, 0.0);
            for &(f, k) in &faces_of[v] {
                for (j, w) in [((k + 1) % 3, weights[f][k]), ((k + 2) % 3, weights[f][(k + 2) % 3])] {
                    sum += w * (at[corners[f][j]] + turns[f].rotate(rest[f][k] - rest[f][j]));
                    weight += w;
                }
            }
            if weight > 0.0 {
                at[v] = sum / weight;
            }
        }
    }
    let result: Vec<[Vec2; 3]> = corners.iter().map(|c| c.map(|v| at[v])).collect();
    let upright = result.iter().zip(&rest).all(|(t, r)| {
        let (now, truth) = (signed_area(t) * sense, signed_area(r) * sense);
        now.is_finite() && (now > 0.1 * truth || truth < 1e-10)
    });
    upright.then_some(result)
}

fn signed_area(t: &[Vec2; 3]) -> f32 {
    (t[1] - t[0]).perp_dot(t[2] - t[0]) / 2.0
}

/// The turn (as a unit complex number) that brings a face at rest closest to where it is.
fn best_turn(at: [Vec2; 3], rest: &[Vec2; 3], weights: &[f32; 3]) -> Vec2 {
    let mut sum = Vec2::ZERO;
    for k in 0..3 {
        let (u, v) = (at[(k + 1) % 3] - at[k], rest[(k + 1) % 3] - rest[k]);
        sum += weights[k] * Vec2::new(u.dot(v), v.perp_dot(u));
    }
    sum.try_normalize().unwrap_or(Vec2::X)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn a_bent_strip_becomes_flat_without_stretch() {
        // A quarter of a cylinder seen from one side: developable, so nothing need stretch.
        let (n, mut surface) = (12u32, Surface::default());
        for i in 0..=n {
            let (s, c) = (i as f32 / n as f32 * 1.4).sin_cos();
            for y in 0..3 {
                surface.positions.push(Vec3::new(s, y as f32 * 0.3, c));
            }
        }
        for i in 0..n {
            for y in 0..2 {
                let a = i * 3 + y;
                surface.triangles.push([a, a + 3, a + 4]);
                surface.triangles.push([a, a + 4, a + 1]);
            }
        }
        let faces: Vec<u32> = (0..surface.triangles.len() as u32).collect();
        let flat: Vec<[Vec2; 3]> =
            surface.triangles.iter().map(|t| t.map(|i| surface.positions[i as usize].truncate())).collect();
        let relaxed = relax(&surface, &faces, &flat).unwrap();
        for (t, flat) in surface.triangles.iter().zip(&relaxed) {
            for k in 0..3 {
                let truth = surface.positions[t[k] as usize].distance(surface.positions[t[(k + 1) % 3] as usize]);
                let found = flat[k].distance(flat[(k + 1) % 3]);
                assert!((found - truth).abs() < 0.08 * truth, "{found} for {truth}");
            }
        }
    }
}
