//! Where the camera of a Gaussian set stands to a picture of it: zoom and shift, from silhouettes.

use super::pattern_search::pattern_search;
use crate::photo::{Plane, silhouette_iou};
use crate::splat::{Camera, Gaussians};
use glam::{Mat3, Quat, Vec2};

/// Opacity of each pixel, 0..1: 1 − Π (1 − αᵢ). The order of the Gaussians does not matter.
///
/// EWA projection as in Kerbl et al. 2023, Eq. 5, with the same 0.3 px² dilation and the cut at α < 1/255.
pub fn silhouette(gaussians: &Gaussians, camera: &Camera) -> Plane {
    let (w, h) = (camera.width as usize, camera.height as usize);
    let mut clear = vec![1.0f32; w * h];
    for i in 0..gaussians.len() {
        let p = camera.rotation * gaussians.positions[i] + camera.translation;
        if p.z < 0.05 {
            continue;
        }
        let opacity = 1.0 / (1.0 + (-gaussians.logit_opacities[i]).exp());
        if opacity < 1.0 / 255.0 {
            continue;
        }
        let [qw, qx, qy, qz] = gaussians.rotations[i];
        let local = Mat3::from_quat(Quat::from_xyzw(qx, qy, qz, qw).normalize());
        let axes = camera.rotation * local * Mat3::from_diagonal(gaussians.log_scales[i].exp());
        // Rows of the Jacobian of the projection, through the axes.
        let row = |f: f32, c: f32| f / p.z * Vec2::new(1.0, -c / p.z);
        let (jx, jy) = (row(camera.fx, p.x), row(camera.fy, p.y));
        let (mut a, mut b, mut d) = (0.3f32, 0.0f32, 0.3f32);
        for k in 0..3 {
            let axis = axes.col(k);
            let (u, v) = (jx.x * axis.x + jx.y * axis.z, jy.x * axis.y + jy.y * axis.z);
            (a, b, d) = (a + u * u, b + u * v, d + v * v);
        }
        let determinant = a * d - b * b;
        if determinant.is_nan() || determinant <= 0.0 {
            continue;
        }
        let conic = (d / determinant, -b / determinant, a / determinant);
        let (x, y) = (camera.fx * p.x / p.z + camera.cx, camera.fy * p.y / p.z + camera.cy);
        // α falls to 1/255 at this squared distance; the box of that ellipse.
        let cut = 2.0 * (255.0 * opacity).ln();
        let (rx, ry) = ((cut * a).sqrt(), (cut * d).sqrt());
        let range = |centre: f32, reach: f32, size: usize| {
            let low = (centre - reach - 0.5).ceil().clamp(0.0, size as f32) as usize;
            let high = (centre + reach + 0.5).floor().clamp(0.0, size as f32) as usize;
            low..high.max(low)
        };
        for py in range(y, ry, h) {
            let dy = py as f32 + 0.5 - y;
            for px in range(x, rx, w) {
                let dx = px as f32 + 0.5 - x;
                let power = conic.0 * dx * dx + 2.0 * conic.1 * dx * dy + conic.2 * dy * dy;
                if power < cut {
                    clear[py * w + px] *= 1.0 - (opacity * (-0.5 * power).exp()).min(0.99);
                }
            }
        }
    }
    Plane { width: w, height: h, data: clear.into_iter().map(|v| 1.0 - v).collect() }
}

/// Changes a camera's focal length and principal point, not its pose, until the silhouette meets the mask.
///
/// `mask` is what the camera's picture shows, at any resolution. A zoom and a shift of the intrinsics move the picture
/// as a whole, so one wide rendering serves every trial: a [`pattern_search`] over log zoom and
/// shift for the least squared difference. Returns the camera and the intersection over union it reaches.
pub fn fit_intrinsics(gaussians: &Gaussians, camera: &Camera, mask: &Plane) -> (Camera, f32) {
    const GRID: usize = 128;
    const MARGIN: f32 = 1.5;
    let target = crate::photo::sample_plane(
        mask,
        crate::photo::Rect { x: 0.0, y: 0.0, width: mask.width as f32, height: mask.height as f32 },
        GRID,
        GRID,
        crate::photo::Edge::Clamp,
    );
    let base = camera.resized(GRID as u32, GRID as u32);
    // The same focal length on a larger sheet.
    let sheet = (GRID as f32 * MARGIN) as u32;
    let offset = (sheet as f32 - GRID as f32) / 2.0;
    let wide = Camera { width: sheet, height: sheet, cx: base.cx + offset, cy: base.cy + offset, ..base };
    let seen = silhouette(gaussians, &wide);
    let value = |x: f32, y: f32| {
        let inside = x >= 0.0 && y >= 0.0 && x < sheet as f32 && y < sheet as f32;
        if inside { seen.at(x as usize, y as usize) } else { 0.0 }
    };
    // trial = [log zoom, right, down]: what the sheet shows where the target's pixels lie.
    let warped = |trial: [f32; 3]| -> Vec<f32> {
        let zoom = trial[0].exp();
        // Of the target's columns or rows the sheet's before them, and how far they lie from it.
        let places = |shift: f32, from: f32, to: f32| -> [(f32, f32); GRID] {
            std::array::from_fn(|i| {
                let at = (i as f32 + 0.5 - shift - from) / zoom + to - 0.5;
                (at.floor(), at - at.floor())
            })
        };
        let (columns, rows) = (places(trial[1], base.cx, wide.cx), places(trial[2], base.cy, wide.cy));
        let at = |(y, ty): (f32, f32), (x, tx): (f32, f32)| {
            (1.0 - ty) * ((1.0 - tx) * value(x, y) + tx * value(x + 1.0, y))
                + ty * ((1.0 - tx) * value(x, y + 1.0) + tx * value(x + 1.0, y + 1.0))
        };
        rows.iter().flat_map(|row| columns.iter().map(|column| at(*row, *column))).collect()
    };
    let cost = |trial: [f32; 3]| match trial[0].abs() < 0.8 {
        true => warped(trial).iter().zip(&target.data).map(|(a, b)| f64::from(a - b).powi(2)).sum(),
        false => f64::INFINITY,
    };
    let (best, _) = pattern_search([0.0; 3], [0.08, 6.0, 6.0], 0.05 / 6.0, cost);
    let iou = silhouette_iou(&warped(best), &target.data).unwrap_or(0.0) as f32;
    let zoom = best[0].exp();
    let fitted =
        Camera { fx: base.fx * zoom, fy: base.fy * zoom, cx: base.cx + best[1], cy: base.cy + best[2], ..base };
    (fitted.resized(camera.width, camera.height), iou)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    /// A few blobs, no symmetry.
    fn blobs() -> Gaussians {
        let mut g = Gaussians::default();
        for (p, s) in
            [([0.0, 0.0, 0.0], 0.2), ([0.5, 0.1, 0.2], 0.1), ([-0.3, 0.0, -0.5], 0.12), ([0.1, 0.3, 0.5], 0.1)]
        {
            g.positions.push(Vec3::from_array(p));
            g.log_scales.push(Vec3::new(s, s * 0.6, s).map(f32::ln));
            g.rotations.push([0.9, 0.1, 0.3, 0.2]);
            g.logit_opacities.push(4.0);
            g.sh.push(Default::default());
        }
        g
    }

    fn camera(size: u32) -> Camera {
        Camera::look_at(Vec3::new(0.0, -3.9, 0.8), Vec3::ZERO, 30f32.to_radians(), size)
    }

    #[test]
    fn a_round_gaussian_has_a_round_silhouette_of_its_size() {
        let g = Gaussians {
            positions: vec![Vec3::ZERO],
            log_scales: vec![Vec3::splat(0.1f32.ln())],
            rotations: vec![[1.0, 0.0, 0.0, 0.0]],
            logit_opacities: vec![10.0],
            sh: vec![Default::default()],
        };
        let c = Camera::look_at(Vec3::new(0.0, -4.0, 0.0), Vec3::ZERO, 30f32.to_radians(), 128);
        let seen = silhouette(&g, &c);
        // σ in pixels: f · 0.1 / 4, and the dilation.
        let sigma = ((c.fx * 0.1 / 4.0).powi(2) + 0.3).sqrt();
        let want = (-0.5 * ((10.5 / sigma).powi(2) + (0.5 / sigma).powi(2))).exp();
        assert!((seen.at(74, 64) - want).abs() < 0.01, "{} {want}", seen.at(74, 64));
        assert!((seen.at(64, 74) - seen.at(74, 64)).abs() < 1e-3 && seen.at(5, 5) == 0.0);
    }

    #[test]
    fn zoom_and_shift_are_found_again() {
        let (g, c) = (blobs(), camera(256));
        let truth = Camera { fx: c.fx * 1.2, fy: c.fy * 1.2, cx: c.cx + 13.0, cy: c.cy - 9.0, ..c };
        let (found, iou) = fit_intrinsics(&g, &c, &silhouette(&g, &truth));
        assert!(iou > 0.95, "{iou}");
        assert!((found.fx / truth.fx - 1.0).abs() < 0.01, "{} {}", found.fx, truth.fx);
        assert!((found.cx - truth.cx).abs() < 1.0 && (found.cy - truth.cy).abs() < 1.0, "{found:?}");
        assert_eq!((found.rotation, found.translation), (c.rotation, c.translation));
    }
}
