//! A made scene for speed measurements: Gaussians on the surfaces of 40 ellipsoids and of a ground plane, flat along
//! the normal, log-normal sizes, two kinds of opacity, degree-3 harmonics; and 24 cameras on a ring around it.

use glam::{Quat, Vec3};

use crate::splat::{Camera, Gaussians};

/// SplitMix64 (Steele et al. 2014), then Box and Muller's normal numbers.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed)
    }
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    fn uniform(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.bits() >> 40) as f32 / (1u64 << 24) as f32
    }
    pub fn normal(&mut self, mean: f32, deviation: f32) -> f32 {
        let radius = (-2.0 * self.uniform(1e-7, 1.0).ln()).sqrt();
        mean + deviation * radius * (std::f32::consts::TAU * self.uniform(0.0, 1.0)).cos()
    }
}

/// `n` Gaussians, the same for the same `n`.
pub fn gaussians(n: usize) -> Gaussians {
    let mut r = Random(7);
    let balls: Vec<(Vec3, Vec3)> = (0..40)
        .map(|_| {
            let centre = Vec3::new(r.uniform(-3.0, 3.0), r.uniform(-3.0, 3.0), r.uniform(0.3, 1.6));
            (centre, Vec3::from_array(std::array::from_fn(|_| r.uniform(0.2, 0.7))))
        })
        .collect();
    let surface = balls.iter().map(|b| 4.0 * std::f32::consts::PI * b.1.length_squared() / 3.0).sum::<f32>() + 100.0;
    let size = ((surface / n.max(1) as f32).sqrt() * 0.6).ln();
    let mut g = Gaussians::default();
    for i in 0..n {
        let (position, normal) = if i < n - n / 4 {
            let u = Vec3::from_array(std::array::from_fn(|_| r.normal(0.0, 1.0))).normalize_or(Vec3::Z);
            let (centre, radius) = balls[r.bits() as usize % balls.len()];
            (centre + u * radius, (u / radius).normalize())
        } else {
            (Vec3::new(r.uniform(-5.0, 5.0), r.uniform(-5.0, 5.0), 0.0), Vec3::Z)
        };
        g.positions.push(position);
        let mut scale: [f32; 3] = std::array::from_fn(|_| size + r.normal(0.0, 0.45));
        scale[2] -= 1.6;
        g.log_scales.push(Vec3::from_array(scale));
        let q = Quat::from_rotation_arc(Vec3::Z, normal);
        g.rotations.push([q.w, q.x, q.y, q.z]);
        g.logit_opacities.push(if r.uniform(0.0, 1.0) < 0.7 { r.normal(3.0, 1.5) } else { r.normal(-2.0, 1.0) });
        g.sh.push(std::array::from_fn(|k| {
            std::array::from_fn(|_| match k {
                0 => (r.uniform(0.1, 0.9) - 0.5) / crate::splat::SH_C0,
                _ => r.normal(0.0, 0.05),
            })
        }));
    }
    g
}

/// 1920×1080, 50° from top to bottom, 7.5 from the middle and 3 above the ground.
pub fn cameras() -> Vec<Camera> {
    (0..24)
        .map(|i| {
            let turn = std::f32::consts::TAU * i as f32 / 24.0;
            let eye = Vec3::new(7.5 * turn.cos(), 7.5 * turn.sin(), 3.0);
            let square = Camera::look_at(eye, Vec3::ZERO, 50f32.to_radians(), 1080);
            Camera { width: 1920, cx: 960.0, ..square }
        })
        .collect()
}
