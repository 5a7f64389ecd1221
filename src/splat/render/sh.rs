//! Real spherical harmonics to degree 3 as 3D Gaussian Splatting stores them (Kerbl et al. 2023; the signs include the
//! Condon–Shortley phase): colour = Σ b_k(d) · sh_k + 0.5 for the unit direction d from the eye to the Gaussian.

pub const C0: f32 = 0.282_094_79;
const C1: f32 = 0.488_602_5;
const C2: [f32; 3] = [1.092_548_4, 0.315_391_57, 0.546_274_2];
const C3: [f32; 5] = [0.590_043_6, 2.890_611_4, 0.457_045_8, 0.373_176_33, 1.445_305_7];

/// The 16 basis functions; those above `degree` are 0.
#[inline(always)]
pub fn basis(d: [f32; 3], degree: usize) -> [f32; 16] {
    let [x, y, z] = d;
    let mut b = [0.0; 16];
    b[0] = C0;
    if degree == 0 {
        return b;
    }
    b[1] = -C1 * y;
    b[2] = C1 * z;
    b[3] = -C1 * x;
    if degree == 1 {
        return b;
    }
    let (xx, yy, zz) = (x * x, y * y, z * z);
    b[4] = C2[0] * x * y;
    b[5] = -C2[0] * y * z;
    b[6] = C2[1] * (2.0 * zz - xx - yy);
    b[7] = -C2[0] * x * z;
    b[8] = C2[2] * (xx - yy);
    if degree == 2 {
        return b;
    }
    b[9] = -C3[0] * y * (3.0 * xx - yy);
    b[10] = C3[1] * x * y * z;
    b[11] = -C3[2] * y * (4.0 * zz - xx - yy);
    b[12] = C3[3] * z * (2.0 * zz - 3.0 * xx - 3.0 * yy);
    b[13] = -C3[2] * x * (4.0 * zz - xx - yy);
    b[14] = C3[4] * z * (xx - yy);
    b[15] = -C3[0] * x * (xx - 3.0 * yy);
    b
}

/// ∂b_k/∂d dotted with weights: Σ_k weights[k] · ∇b_k(d), for the same polynomials as [`basis`].
#[inline(always)]
pub fn weighted_gradient(d: [f32; 3], w: &[f32; 16], degree: usize) -> [f32; 3] {
    let [x, y, z] = d;
    if degree == 0 {
        return [0.0; 3];
    }
    let mut g = [-C1 * w[3], -C1 * w[1], C1 * w[2]];
    if degree == 1 {
        return g;
    }
    g[0] += C2[0] * (y * w[4] - z * w[7]) - 2.0 * C2[1] * x * w[6] + 2.0 * C2[2] * x * w[8];
    g[1] += C2[0] * (x * w[4] - z * w[5]) - 2.0 * C2[1] * y * w[6] - 2.0 * C2[2] * y * w[8];
    g[2] += -C2[0] * (y * w[5] + x * w[7]) + 4.0 * C2[1] * z * w[6];
    if degree == 2 {
        return g;
    }
    let (xx, yy, zz, xy, xz, yz) = (x * x, y * y, z * z, x * y, x * z, y * z);
    g[0] += -6.0 * C3[0] * xy * w[9] + C3[1] * yz * w[10] + 2.0 * C3[2] * xy * w[11]
        - 6.0 * C3[3] * xz * w[12]
        - C3[2] * (4.0 * zz - 3.0 * xx - yy) * w[13]
        + 2.0 * C3[4] * xz * w[14]
        - 3.0 * C3[0] * (xx - yy) * w[15];
    g[1] += -3.0 * C3[0] * (xx - yy) * w[9] + C3[1] * xz * w[10]
        - C3[2] * (4.0 * zz - xx - 3.0 * yy) * w[11]
        - 6.0 * C3[3] * yz * w[12]
        + 2.0 * C3[2] * xy * w[13]
        - 2.0 * C3[4] * yz * w[14]
        + 6.0 * C3[0] * xy * w[15];
    g[2] += C3[1] * xy * w[10] - 8.0 * C3[2] * yz * w[11] + C3[3] * (6.0 * zz - 3.0 * xx - 3.0 * yy) * w[12]
        - 8.0 * C3[2] * xz * w[13]
        + C3[4] * (xx - yy) * w[14];
    g
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gradient_is_the_derivative_of_every_basis_function() {
        let d = [0.31, -0.52, 0.79];
        for k in 0..16 {
            let mut w = [0.0; 16];
            w[k] = 1.0;
            let g = weighted_gradient(d, &w, 3);
            for axis in 0..3 {
                let (mut up, mut down) = (d, d);
                up[axis] += 1e-2;
                down[axis] -= 1e-2;
                // Cubic polynomials: the central difference is off by h²·f'''/6 ≤ 1e-4·3.
                let difference = (basis(up, 3)[k] - basis(down, 3)[k]) / 2e-2;
                assert!((difference - g[axis]).abs() < 4e-4, "b{k} axis {axis}: {difference} {}", g[axis]);
            }
        }
    }

    #[test]
    fn basis_is_orthonormal_on_the_sphere() {
        // Fibonacci points: equal areas, so the mean is the integral over 4π.
        let n = 20_000;
        let mut gram = [[0f64; 16]; 16];
        for i in 0..n {
            let z = 1.0 - (2 * i + 1) as f64 / n as f64;
            let (r, phi) = ((1.0 - z * z).sqrt(), i as f64 * 2.399_963_229_728_653);
            let b = basis([(r * phi.cos()) as f32, (r * phi.sin()) as f32, z as f32], 3);
            for j in 0..16 {
                for k in 0..16 {
                    gram[j][k] += (b[j] * b[k]) as f64 * 4.0 * std::f64::consts::PI / n as f64;
                }
            }
        }
        for j in 0..16 {
            for k in 0..16 {
                let expected = if j == k { 1.0 } else { 0.0 };
                assert!((gram[j][k] - expected).abs() < 1e-3, "{j} {k}: {}", gram[j][k]);
            }
        }
    }
}
