//! Rotation of spherical harmonics. A band maps to itself under rotation, so its matrix is fixed by the values at enough
//! directions: B(R d)·c' = B(d)·c for all d, solved in f64.

use glam::{Mat3, Vec3};

use super::gaussians::SH_COEFFICIENTS;
use super::render::sh::basis;

/// The matrices of bands 1, 2 and 3 for one rotation.
pub struct Bands {
    /// Row-major, (2l + 1)² each.
    matrices: [Vec<f64>; 3],
}

impl Bands {
    pub fn new(rotation: Mat3) -> Self {
        Bands { matrices: [1, 2, 3].map(|l| band(rotation, l)) }
    }

    /// The coefficients of the turned function f'(d) = f(Rᵀ d).
    pub fn turn(&self, sh: &mut [[f32; 3]; SH_COEFFICIENTS]) {
        for (l, matrix) in (1..).zip(&self.matrices) {
            let (first, n) = (l * l, 2 * l + 1);
            let old: Vec<[f32; 3]> = sh[first..first + n].to_vec();
            for i in 0..n {
                sh[first + i] =
                    std::array::from_fn(|c| (0..n).map(|j| matrix[i * n + j] * old[j][c] as f64).sum::<f64>() as f32);
            }
        }
    }
}

/// M = (AᵀA)⁻¹ Aᵀ B with A = basis at turned directions, B = basis at the directions.
fn band(rotation: Mat3, l: usize) -> Vec<f64> {
    const DIRECTIONS: usize = 64;
    let (first, n) = (l * l, 2 * l + 1);
    // Left n columns: AᵀA; right n: AᵀB.
    let mut system = vec![0.0f64; n * 2 * n];
    for i in 0..DIRECTIONS {
        // Fibonacci points on the sphere.
        let z = 1.0 - (2 * i + 1) as f32 / DIRECTIONS as f32;
        let (r, phi) = ((1.0 - z * z).sqrt(), i as f32 * 2.399_963_3);
        let d = Vec3::new(r * phi.cos(), r * phi.sin(), z);
        let (a, b) = (basis((rotation * d).to_array(), 3), basis(d.to_array(), 3));
        for j in 0..n {
            for k in 0..n {
                system[j * 2 * n + k] += (a[first + j] * a[first + k]) as f64;
                system[j * 2 * n + n + k] += (a[first + j] * b[first + k]) as f64;
            }
        }
    }
    // Gauss–Jordan without pivoting: AᵀA is close to a multiple of the identity.
    for p in 0..n {
        let pivot = system[p * 2 * n + p];
        for k in 0..2 * n {
            system[p * 2 * n + k] /= pivot;
        }
        for j in (0..n).filter(|j| *j != p) {
            let factor = system[j * 2 * n + p];
            for k in 0..2 * n {
                system[j * 2 * n + k] -= factor * system[p * 2 * n + k];
            }
        }
    }
    (0..n * n).map(|i| system[i / n * 2 * n + n + i % n]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Quat;

    #[test]
    fn colour_from_a_turned_direction_is_the_colour_before() {
        let rotation = Mat3::from_quat(Quat::from_euler(glam::EulerRot::XYZ, 0.4, 2.0, -0.9));
        let sh: [[f32; 3]; 16] = std::array::from_fn(|k| [(k as f32 * 1.7).sin(), (k as f32).cos(), 0.3]);
        let mut turned = sh;
        Bands::new(rotation).turn(&mut turned);
        let value = |sh: &[[f32; 3]; 16], d: Vec3, c: usize| -> f32 {
            basis(d.to_array(), 3).iter().zip(sh).map(|(b, s)| b * s[c]).sum()
        };
        for i in 0..50 {
            let d = Vec3::new((i as f32).sin(), (i as f32 * 2.3).cos(), (i as f32 * 0.7).sin() + 0.01).normalize();
            for c in 0..3 {
                let (a, b) = (value(&sh, d, c), value(&turned, rotation * d, c));
                assert!((a - b).abs() < 1e-5, "{a} {b}");
            }
        }
        // Lengths of a band are kept: the matrices are rotations.
        for l in 1..4usize {
            let length = |sh: &[[f32; 3]; 16]| (l * l..(l + 1) * (l + 1)).map(|k| sh[k][0] * sh[k][0]).sum::<f32>();
            assert!((length(&sh) - length(&turned)).abs() < 1e-5);
        }
    }
}
