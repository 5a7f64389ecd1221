//! One Gaussian onto the picture plane and back: EWA splatting (Zwicker et al. 2001) as in Kerbl et al. 2023, §4, and
//! the hand-derived vector–Jacobian product of the same.

use super::sh;
use crate::splat::Camera;
use crate::splat::packed::{Core, OPACITY, POSITION, ROTATION, SCALE, Sh};

/// Nearer than this in front of the camera nothing is drawn.
pub const NEAR: f32 = 0.01;
/// Added to both diagonals of the projected covariance, in pixels²: a splat is never thinner than about a pixel.
pub const LOW_PASS: f32 = 0.3;
/// Fainter contributions are skipped.
pub const MIN_ALPHA: f32 = 1.0 / 255.0;
/// One splat hides at most this share of what is behind.
pub const MAX_ALPHA: f32 = 0.99;
/// A pixel is finished before the splat that would bring its transmittance to this.
pub const MIN_TRANSMITTANCE: f32 = 1e-4;

type V3 = [f32; 3];
type M3 = [[f32; 3]; 3];

/// [f(0), f(1), f(2)]. Not `array::from_fn`, which is not always inlined and then loses the wide instructions.
#[inline(always)]
fn three<T>(f: impl Fn(usize) -> T) -> [T; 3] {
    [f(0), f(1), f(2)]
}
#[inline(always)]
fn dot(a: V3, b: V3) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
#[inline(always)]
fn apply(m: &M3, v: V3) -> V3 {
    [dot(m[0], v), dot(m[1], v), dot(m[2], v)]
}
#[inline(always)]
fn apply_transposed(m: &M3, v: V3) -> V3 {
    three(|j| m[0][j] * v[0] + m[1][j] * v[1] + m[2][j] * v[2])
}
#[inline(always)]
fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A camera as the kernels read it.
#[derive(Clone, Copy, Debug)]
pub struct View {
    pub width: usize,
    pub height: usize,
    pub fx: f32,
    pub fy: f32,
    pub cx: f32,
    pub cy: f32,
    /// Rows of the world→camera rotation.
    pub rotation: M3,
    pub translation: V3,
    pub eye: V3,
    /// x/z and y/z are held inside these for the Jacobian alone: the picture widened by 0.3 of its half-angle a side.
    pub limit_x: [f32; 2],
    pub limit_y: [f32; 2],
    pub shown: Shown,
}

/// What a picture is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shown {
    #[default]
    Color,
    /// Of the surface that the Gaussians stand for, in camera space (x right, y down, z forward), towards the camera:
    /// each Gaussian's shortest axis.
    Normals,
}

impl View {
    pub fn new(c: &Camera) -> Self {
        let (w, h) = (c.width as f32, c.height as f32);
        let (mx, my) = (0.15 * w / c.fx, 0.15 * h / c.fy);
        let r = c.rotation;
        View {
            width: c.width as usize,
            height: c.height as usize,
            fx: c.fx,
            fy: c.fy,
            cx: c.cx,
            cy: c.cy,
            rotation: [r.row(0).to_array(), r.row(1).to_array(), r.row(2).to_array()],
            translation: c.translation.to_array(),
            eye: c.position().to_array(),
            limit_x: [-c.cx / c.fx - mx, (w - c.cx) / c.fx + mx],
            limit_y: [-c.cy / c.fy - my, (h - c.cy) / c.fy + my],
            shown: Shown::Color,
        }
    }
}

/// Everything between the parameters and the splat that the way back needs too.
pub struct Geometry {
    point: V3,
    rotation: M3,
    scale: V3,
    /// world→camera rotation · rotation · diag(scale)
    axes: M3,
    /// x/z and y/z after the clamp, and whether the clamp left them alone.
    tan: [f32; 2],
    inside: [bool; 2],
    /// J · axes: the covariance is N Nᵀ + low-pass.
    n: [V3; 2],
    pub mean: [f32; 2],
    pub covariance: [f32; 3],
    pub conic: [f32; 3],
    pub opacity: f32,
    quaternion: [f32; 4],
    inverse_norm: f32,
}

impl Geometry {
    /// None for a Gaussian that cannot be seen: behind, too faint, or not finite. NaN fails every comparison.
    #[inline(always)]
    pub fn new(core: &Core, view: &View) -> Option<Self> {
        let p: V3 = three(|i| core[POSITION + i]);
        let c = apply(&view.rotation, p);
        let point: V3 = three(|i| c[i] + view.translation[i]);
        let z = point[2];
        let opacity = 1.0 / (1.0 + (-core[OPACITY]).exp());
        if !(z > NEAR && z < 1e10 && opacity >= MIN_ALPHA) {
            return None;
        }
        let q = [core[ROTATION], core[ROTATION + 1], core[ROTATION + 2], core[ROTATION + 3]];
        let inverse_norm = 1.0 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]).sqrt();
        let [w, x, y, zq] = [q[0] * inverse_norm, q[1] * inverse_norm, q[2] * inverse_norm, q[3] * inverse_norm];
        let quaternion = [w, x, y, zq];
        let rotation = [
            [1.0 - 2.0 * (y * y + zq * zq), 2.0 * (x * y - w * zq), 2.0 * (x * zq + w * y)],
            [2.0 * (x * y + w * zq), 1.0 - 2.0 * (x * x + zq * zq), 2.0 * (y * zq - w * x)],
            [2.0 * (x * zq - w * y), 2.0 * (y * zq + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ];
        let scale: V3 = three(|i| core[SCALE + i].exp());
        let m: M3 = three(|i| three(|j| rotation[i][j] * scale[j]));
        let axes: M3 = three(|i| {
            let r = view.rotation[i];
            three(|j| r[0] * m[0][j] + r[1] * m[1][j] + r[2] * m[2][j])
        });
        let iz = 1.0 / z;
        let raw = [point[0] * iz, point[1] * iz];
        let tan = [raw[0].max(view.limit_x[0]).min(view.limit_x[1]), raw[1].max(view.limit_y[0]).min(view.limit_y[1])];
        let (jx, jy) = (view.fx * iz, view.fy * iz);
        let n: [V3; 2] =
            [three(|j| jx * (axes[0][j] - tan[0] * axes[2][j])), three(|j| jy * (axes[1][j] - tan[1] * axes[2][j]))];
        let (xx, xy, yy) = (dot(n[0], n[0]), dot(n[0], n[1]), dot(n[1], n[1]));
        // det(N Nᵀ + ε I) = |n₀ × n₁|² + ε (|n₀|² + |n₁|²) + ε²: nothing cancels, however long and thin.
        let area = cross(n[0], n[1]);
        let det = dot(area, area) + LOW_PASS * (xx + yy) + LOW_PASS * LOW_PASS;
        let covariance = [xx + LOW_PASS, xy, yy + LOW_PASS];
        let inverse = 1.0 / det;
        let conic = [covariance[2] * inverse, -xy * inverse, covariance[0] * inverse];
        let mean = [view.fx * raw[0] + view.cx, view.fy * raw[1] + view.cy];
        let finite = det < 1e36 && inverse > 0.0 && (mean[0] + mean[1]).abs() < 1e9 && inverse_norm < 1e18;
        if !finite {
            return None;
        }
        Some(Geometry {
            point,
            rotation,
            scale,
            axes,
            tan,
            inside: [tan[0] == raw[0], tan[1] == raw[1]],
            n,
            mean,
            covariance,
            conic,
            opacity,
            quaternion,
            inverse_norm,
        })
    }

    pub fn depth(&self) -> f32 {
        self.point[2]
    }

    /// The Gaussian's shortest axis (of equally short ones the first) in camera space, a unit vector towards the camera;
    /// which axis it is, and 1, or −1 where it was turned round.
    #[inline(always)]
    pub fn normal(&self, core: &Core, view: &View) -> (V3, usize, f32) {
        let s = &core[SCALE..SCALE + 3];
        let k = if s[1] < s[0] { 1 } else { 0 };
        let k = if s[2] < s[k] { 2 } else { k };
        let n = apply(&view.rotation, three(|i| self.rotation[i][k]));
        let sign = if dot(n, self.point) > 0.0 { -1.0 } else { 1.0 };
        (three(|i| sign * n[i]), k, sign)
    }

    /// Half the width and height of the ellipse on which alpha falls to [`MIN_ALPHA`], and its level 2 ln(255 o).
    #[inline(always)]
    pub fn extent(&self) -> ([f32; 2], f32) {
        let level = (2.0 * (self.opacity / MIN_ALPHA).ln()).max(0.0);
        ([(level * self.covariance[0]).sqrt(), (level * self.covariance[2]).sqrt()], level)
    }
}

/// Colour before the clamp at 0, the unit direction and 1 / distance.
#[inline(always)]
pub fn color(core: &Core, coefficients: &Sh, view: &View, degree: usize) -> (V3, V3, f32, [f32; 16]) {
    let d: V3 = three(|i| core[POSITION + i] - view.eye[i]);
    let inverse = 1.0 / dot(d, d).sqrt().max(1e-20);
    let d = three(|i| d[i] * inverse);
    let b = sh::basis(d, degree);
    let rgb = three(|c| {
        let k = &coefficients[c * 16..c * 16 + 16];
        let mut lanes = [0.0f32; 4];
        for i in 0..16 {
            lanes[i % 4] += b[i] * k[i];
        }
        (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]) + 0.5
    });
    (rgb, d, inverse, b)
}

/// Gradients that arrive from the rasteriser, summed over the pixels of one splat. g = ∂L/∂(ln α) a pixel,
/// (dx, dy) = pixel − mean.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct SplatGradient {
    /// Σ g
    pub g: f32,
    /// Σ g·dx, Σ g·dy
    pub x: f32,
    pub y: f32,
    /// Σ g·dx², Σ g·dx·dy, Σ g·dy²
    pub xx: f32,
    pub xy: f32,
    pub yy: f32,
    /// ∂L/∂rgb
    pub color: [f32; 3],
}

/// Gradients of one Gaussian's parameters.
pub struct Gradient {
    pub core: Core,
    pub sh: Sh,
    /// ∂L/∂(mean in pixels), for density control.
    pub mean: [f32; 2],
    /// Of a left-multiplied increment of the world→camera pose: translation, then rotation vector.
    pub pose: [f32; 6],
}

/// The way back of [`Geometry::new`] and [`color`].
#[inline(always)]
pub fn backward(core: &Core, coefficients: &Sh, view: &View, degree: usize, up: &SplatGradient) -> Option<Gradient> {
    let g = Geometry::new(core, view)?;
    let mut out = Gradient { core: [0.0; 16], sh: [0.0; 48], mean: [0.0; 2], pose: [0.0; 6] };

    // Colour: the clamp at 0 lets no gradient through below it.
    let (rgb, d, inverse_distance, b) = color(core, coefficients, view, degree);
    let mut weights = [0.0; 16];
    for c in 0..3 {
        let v = if rgb[c] > 0.0 && view.shown == Shown::Color { up.color[c] } else { 0.0 };
        for k in 0..16 {
            out.sh[c * 16 + k] = v * b[k];
            weights[k] += v * coefficients[c * 16 + k];
        }
    }
    let along = sh::weighted_gradient(d, &weights, degree);
    let radial = dot(along, d);
    let direction: V3 = three(|i| (along[i] - radial * d[i]) * inverse_distance);

    // Alpha = o · exp(−½ (a dx² + 2 b dx dy + c dy²)).
    out.core[OPACITY] = up.g * (1.0 - g.opacity);
    let [a, b, c] = g.conic;
    out.mean = [a * up.x + b * up.y, b * up.x + c * up.y];
    // ∂L/∂conic as a symmetric matrix: the stored off-diagonal counts twice in the form, so half of it each side.
    let (va, vb, vc) = (-0.5 * up.xx, -0.5 * up.xy, -0.5 * up.yy);
    // ∂L/∂covariance = −P V P.
    let (ta, tb, tc, td) = (a * va + b * vb, a * vb + b * vc, b * va + c * vb, b * vb + c * vc);
    let (ga, gb, gc) = (-(ta * a + tb * b), -(ta * b + tb * c), -(tc * b + td * c));
    let dn: [V3; 2] =
        [three(|j| 2.0 * (ga * g.n[0][j] + gb * g.n[1][j])), three(|j| 2.0 * (gb * g.n[0][j] + gc * g.n[1][j]))];

    // N = J · axes with J = [[jx, 0, −jx·tan₀], [0, jy, −jy·tan₁]].
    let iz = 1.0 / g.point[2];
    let (jx, jy) = (view.fx * iz, view.fy * iz);
    let daxes: M3 = [
        three(|j| jx * dn[0][j]),
        three(|j| jy * dn[1][j]),
        three(|j| -jx * g.tan[0] * dn[0][j] - jy * g.tan[1] * dn[1][j]),
    ];
    let dj00 = dot(dn[0], g.axes[0]);
    let dj02 = dot(dn[0], g.axes[2]);
    let dj11 = dot(dn[1], g.axes[1]);
    let dj12 = dot(dn[1], g.axes[2]);
    let mut dp: V3 = [0.0; 3];
    // The mean is never clamped.
    let raw = [g.point[0] * iz, g.point[1] * iz];
    dp[0] += jx * out.mean[0];
    dp[1] += jy * out.mean[1];
    dp[2] -= jx * raw[0] * out.mean[0] + jy * raw[1] * out.mean[1];
    dp[2] -= (jx * dj00 + jy * dj11) * iz;
    // J02 = −fx·tan/z: with tan = x/z inside, a constant outside.
    if g.inside[0] {
        dp[0] -= jx * iz * dj02;
        dp[2] += 2.0 * jx * iz * g.tan[0] * dj02;
    } else {
        dp[2] += jx * iz * g.tan[0] * dj02;
    }
    if g.inside[1] {
        dp[1] -= jy * iz * dj12;
        dp[2] += 2.0 * jy * iz * g.tan[1] * dj12;
    } else {
        dp[2] += jy * iz * g.tan[1] * dj12;
    }

    let position = apply_transposed(&view.rotation, dp);
    for i in 0..3 {
        out.core[POSITION + i] = position[i] + direction[i];
    }

    // axes = W · R · diag(s)
    let dm: M3 = three(|i| {
        three(|j| {
            view.rotation[0][i] * daxes[0][j] + view.rotation[1][i] * daxes[1][j] + view.rotation[2][i] * daxes[2][j]
        })
    });
    let mut dr: M3 = [[0.0; 3]; 3];
    for j in 0..3 {
        let mut ds = 0.0;
        for i in 0..3 {
            ds += g.rotation[i][j] * dm[i][j];
            dr[i][j] = dm[i][j] * g.scale[j];
        }
        out.core[SCALE + j] = ds * g.scale[j];
    }
    let mut normal = [0.0; 3];
    if view.shown == Shown::Normals {
        // n = ± W · R's column.
        let (n, axis, sign) = g.normal(core, view);
        normal = n;
        let world = apply_transposed(&view.rotation, up.color);
        for i in 0..3 {
            dr[i][axis] += sign * world[i];
        }
    }
    let q = quaternion_gradient(g.quaternion, &dr);
    let along = q[0] * g.quaternion[0] + q[1] * g.quaternion[1] + q[2] * g.quaternion[2] + q[3] * g.quaternion[3];
    for i in 0..4 {
        out.core[ROTATION + i] = (q[i] - along * g.quaternion[i]) * g.inverse_norm;
    }

    // Pose: p' = ω × p + v, axes' = ω × axes, n' = ω × n, and the eye moves by −Wᵀ v.
    let (mut turn, of_normal) = (cross(g.point, dp), cross(normal, up.color));
    for i in 0..3 {
        turn[i] += of_normal[i];
    }
    for j in 0..3 {
        let t = cross([g.axes[0][j], g.axes[1][j], g.axes[2][j]], [daxes[0][j], daxes[1][j], daxes[2][j]]);
        for i in 0..3 {
            turn[i] += t[i];
        }
    }
    let eye = apply(&view.rotation, direction);
    for i in 0..3 {
        out.pose[i] = dp[i] + eye[i];
        out.pose[3 + i] = turn[i];
    }
    Some(out)
}

/// ∂L/∂(unit quaternion) from ∂L/∂R.
#[inline(always)]
fn quaternion_gradient([w, x, y, z]: [f32; 4], g: &M3) -> [f32; 4] {
    [
        2.0 * (z * (g[1][0] - g[0][1]) + y * (g[0][2] - g[2][0]) + x * (g[2][1] - g[1][2])),
        2.0 * (y * (g[0][1] + g[1][0]) + z * (g[0][2] + g[2][0]) - 2.0 * x * (g[1][1] + g[2][2])
            + w * (g[2][1] - g[1][2])),
        2.0 * (x * (g[0][1] + g[1][0]) + z * (g[1][2] + g[2][1]) - 2.0 * y * (g[0][0] + g[2][2])
            + w * (g[0][2] - g[2][0])),
        2.0 * (x * (g[0][2] + g[2][0]) + y * (g[1][2] + g[2][1]) - 2.0 * z * (g[0][0] + g[1][1])
            + w * (g[1][0] - g[0][1])),
    ]
}
