//! The renderer as its definition reads, for tests: f64, every pixel against every Gaussian, no tiles, no lanes, nothing
//! shared with the real one. A parameter is a plain number, so any of them can be nudged for a finite difference.

use super::projection::Shown;
use crate::splat::{Camera, Gaussians};

/// One Gaussian: position 3, logit opacity, quaternion 4, log scales 3, then 48 colour coefficients channel-major.
pub type Parameters = [f64; 59];

pub fn parameters(g: &Gaussians) -> Vec<Parameters> {
    (0..g.len())
        .map(|i| {
            let (p, s, q) = (g.positions[i], g.log_scales[i], g.rotations[i]);
            let core = [p.x, p.y, p.z, g.logit_opacities[i], q[0], q[1], q[2], q[3], s.x, s.y, s.z];
            std::array::from_fn(|k| if k < 11 { core[k] } else { g.sh[i][(k - 11) % 16][(k - 11) / 16] } as f64)
        })
        .collect()
}

/// World→camera in f64 with a left-multiplied increment: translation, rotation vector.
pub struct Pose {
    r: [[f64; 3]; 3],
    t: [f64; 3],
}

impl Pose {
    pub fn new(c: &Camera, by: [f64; 6]) -> Self {
        let r: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| c.rotation.row(i)[j] as f64));
        let t = c.translation.to_array().map(f64::from);
        // Rodrigues.
        let w = [by[3], by[4], by[5]];
        let angle = (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]).sqrt();
        let k = [[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]];
        let (a, b) =
            if angle < 1e-12 { (1.0, 0.5) } else { (angle.sin() / angle, (1.0 - angle.cos()) / (angle * angle)) };
        let e: [[f64; 3]; 3] = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let kk: f64 = (0..3).map(|m| k[i][m] * k[m][j]).sum();
                (if i == j { 1.0 } else { 0.0 }) + a * k[i][j] + b * kk
            })
        });
        Pose {
            r: std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|m| e[i][m] * r[m][j]).sum())),
            t: std::array::from_fn(|i| (0..3).map(|m| e[i][m] * t[m]).sum::<f64>() + by[i]),
        }
    }
}

/// One pixel of the reference.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pixel {
    /// Σ w·rgb, without background.
    pub color: [f64; 3],
    pub transmittance: f64,
    /// Σ w·z
    pub depth: f64,
    pub median: f64,
    /// Some comparison was so close that f32 may decide it the other way.
    pub doubtful: bool,
}

struct Flat {
    z: f64,
    mean: [f64; 2],
    conic: [f64; 3],
    opacity: f64,
    rgb: [f64; 3],
}

fn basis([x, y, z]: [f64; 3]) -> [f64; 16] {
    let pi = std::f64::consts::PI;
    let c1 = (3.0 / (4.0 * pi)).sqrt();
    let c2 = (15.0 / (4.0 * pi)).sqrt();
    let (a, b, c) = ((35.0 / (32.0 * pi)).sqrt(), (105.0 / (4.0 * pi)).sqrt(), (21.0 / (32.0 * pi)).sqrt());
    [
        (1.0 / (4.0 * pi)).sqrt(),
        -c1 * y,
        c1 * z,
        -c1 * x,
        c2 * x * y,
        -c2 * y * z,
        (5.0 / (16.0 * pi)).sqrt() * (3.0 * z * z - 1.0),
        -c2 * x * z,
        c2 / 2.0 * (x * x - y * y),
        -a * y * (3.0 * x * x - y * y),
        b * x * y * z,
        -c * y * (5.0 * z * z - 1.0),
        (7.0 / (16.0 * pi)).sqrt() * z * (5.0 * z * z - 3.0),
        -c * x * (5.0 * z * z - 1.0),
        b / 2.0 * z * (x * x - y * y),
        -a * x * (x * x - 3.0 * y * y),
    ]
}

fn flatten(g: &Parameters, c: &Camera, pose: &Pose, shown: Shown) -> Option<Flat> {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let p = [g[0], g[1], g[2]];
    let q: [f64; 3] = std::array::from_fn(|i| dot(pose.r[i], p) + pose.t[i]);
    let opacity = 1.0 / (1.0 + (-g[3]).exp());
    if !(q[2] > 0.01 && opacity >= 1.0 / 255.0) || g.iter().any(|v| !v.is_finite()) {
        return None;
    }
    let n = (4..8).map(|i| g[i] * g[i]).sum::<f64>().sqrt();
    let [w, x, y, z] = [4, 5, 6, 7].map(|i| g[i] / n);
    let r = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ];
    let sigma: [[f64; 3]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| (0..3).map(|k| r[i][k] * r[j][k] * (2.0 * g[8 + k]).exp()).sum())
    });
    let (fx, fy, cx, cy) = (c.fx as f64, c.fy as f64, c.cx as f64, c.cy as f64);
    let (wide, high) = (c.width as f64, c.height as f64);
    let tx = (q[0] / q[2]).clamp(-cx / fx - 0.15 * wide / fx, (wide - cx) / fx + 0.15 * wide / fx) * q[2];
    let ty = (q[1] / q[2]).clamp(-cy / fy - 0.15 * high / fy, (high - cy) / fy + 0.15 * high / fy) * q[2];
    let j = [[fx / q[2], 0.0, -fx * tx / (q[2] * q[2])], [0.0, fy / q[2], -fy * ty / (q[2] * q[2])]];
    let t: [[f64; 3]; 2] =
        std::array::from_fn(|a| std::array::from_fn(|b| (0..3).map(|k| j[a][k] * pose.r[k][b]).sum()));
    let s = |a: usize, b: usize| -> f64 {
        (0..3).map(|k| (0..3).map(|l| t[a][k] * sigma[k][l] * t[b][l]).sum::<f64>()).sum()
    };
    let (xx, xy, yy) = (s(0, 0) + 0.3, s(0, 1), s(1, 1) + 0.3);
    let det = xx * yy - xy * xy;
    let eye: [f64; 3] = std::array::from_fn(|i| -(0..3).map(|k| pose.r[k][i] * pose.t[k]).sum::<f64>());
    let d: [f64; 3] = std::array::from_fn(|i| p[i] - eye[i]);
    let length = dot(d, d).sqrt();
    let b = basis(d.map(|v| v / length));
    let rgb = std::array::from_fn(|ch| ((0..16).map(|k| b[k] * g[11 + ch * 16 + k]).sum::<f64>() + 0.5).max(0.0));
    // The shortest axis in camera space, towards the camera.
    let axis = (0..3).fold(0, |least, k| if g[8 + k] < g[8 + least] { k } else { least });
    let n: [f64; 3] = std::array::from_fn(|i| (0..3).map(|k| pose.r[i][k] * r[k][axis]).sum());
    let normal = if dot(n, q) > 0.0 { n.map(|v| -v) } else { n };
    let rgb = if shown == Shown::Normals { normal } else { rgb };
    Some(Flat {
        z: q[2],
        mean: [fx * q[0] / q[2] + cx, fy * q[1] / q[2] + cy],
        conic: [yy / det, -xy / det, xx / det],
        opacity,
        rgb,
    })
}

pub fn render(gaussians: &[Parameters], camera: &Camera, pose: &Pose) -> Vec<Pixel> {
    render_shown(gaussians, camera, pose, Shown::Color)
}

/// Colours, or normals in their place.
pub fn render_shown(gaussians: &[Parameters], camera: &Camera, pose: &Pose, shown: Shown) -> Vec<Pixel> {
    let mut flat: Vec<Flat> = gaussians.iter().filter_map(|g| flatten(g, camera, pose, shown)).collect();
    flat.sort_by(|a, b| a.z.total_cmp(&b.z));
    let mut out = Vec::new();
    for y in 0..camera.height {
        for x in 0..camera.width {
            let mut pixel = Pixel { transmittance: 1.0, ..Default::default() };
            for g in &flat {
                let (dx, dy) = (x as f64 + 0.5 - g.mean[0], y as f64 + 0.5 - g.mean[1]);
                let power = 0.5 * (g.conic[0] * dx * dx + 2.0 * g.conic[1] * dx * dy + g.conic[2] * dy * dy);
                let alpha = (g.opacity * (-power).exp()).min(0.99);
                pixel.doubtful |= (alpha * 255.0 - 1.0).abs() < 1e-3;
                if alpha < 1.0 / 255.0 {
                    continue;
                }
                let next = pixel.transmittance * (1.0 - alpha);
                pixel.doubtful |= (next * 1e4 - 1.0).abs() < 1e-2;
                if next <= 1e-4 {
                    break;
                }
                let w = pixel.transmittance * alpha;
                for c in 0..3 {
                    pixel.color[c] += w * g.rgb[c];
                }
                pixel.depth += w * g.z;
                if pixel.transmittance > 0.5 && next <= 0.5 {
                    pixel.median = g.z;
                }
                pixel.transmittance = next;
            }
            out.push(pixel);
        }
    }
    out
}
