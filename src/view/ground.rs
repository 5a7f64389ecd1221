//! The ground under the subject: a map grid that runs north and east, an arrow to where the photo's camera looked.

use glam::{Vec2, Vec3};

use crate::splat::Camera;

/// Lines either side of the origin.
const HALF: f32 = 10.0;
/// Steps from the origin to the arrow's tip.
const ARROW: f32 = 8.0;

/// A grid on the plane z = 0.
#[derive(Clone, Copy, Debug)]
pub struct Ground {
    /// Between two lines.
    pub step: f32,
    /// Sine and cosine of the bearing of +Y.
    heading: [f32; 2],
    lines: [f32; 3],
    arrow: [f32; 3],
    north: [f32; 3],
}

/// 1, 2 or 5 times a power of ten: about a third of the radius.
pub fn step(radius: f32) -> f32 {
    let power = 10f32.powf((radius / 3.0).log10().floor());
    let times = radius / 3.0 / power;
    power
        * if times < 1.5 {
            1.0
        } else if times < 3.5 {
            2.0
        } else if times < 7.5 {
            5.0
        } else {
            10.0
        }
}

impl Ground {
    pub fn new(radius: f32, heading: f64, dark: bool) -> Ground {
        let (lines, arrow, north) = if dark {
            ([0.45; 3], [0.95, 0.65, 0.15], [0.35, 0.65, 1.0])
        } else {
            ([0.62; 3], [0.80, 0.42, 0.0], [0.0, 0.35, 0.75])
        };
        Ground {
            step: step(radius),
            heading: [heading.to_radians().sin() as f32, heading.to_radians().cos() as f32],
            lines,
            arrow,
            north,
        }
    }

    /// What a pixel shows of the ground over `background`.
    #[inline]
    pub fn over(&self, rays: &Rays, x: usize, y: usize, background: [f32; 3]) -> [f32; 3] {
        let Some((at, pixel)) = rays.meet(x as f32 + 0.5, y as f32 + 0.5) else { return background };
        // East and north of the origin, in steps.
        let [sin, cos] = self.heading;
        let p = Vec2::new(at.x * cos + at.y * sin, at.y * cos - at.x * sin) / self.step;
        let width = pixel / self.step;
        let edge = p.abs().max_element();
        if edge > HALF + 0.5 * width {
            return background;
        }
        // Lines closer than two pixels would flicker: they fade.
        let fade = (2.0 - 4.0 * width).clamp(0.0, 1.0) * (1.5 - edge / HALF).clamp(0.0, 1.0);
        let near = |v: f32| (v - v.round()).abs();
        let thin = |distance: f32, half: f32| (half + 0.5 - distance / width).clamp(0.0, 1.0);
        let mut color = mix(background, self.lines, 0.6 * fade * thin(near(p.x).min(near(p.y)), 0.5));
        if p.x.abs() < 0.5 && (0.0..=HALF).contains(&p.y) {
            color = mix(color, self.north, thin(p.x.abs(), 1.0));
        }
        // In the subject's own axes, where the arrow points to +Y.
        let q = Vec2::new(at.x, at.y) / self.step;
        mix(color, self.arrow, (0.5 - arrow(q) / width).clamp(0.0, 1.0))
    }
}

/// Distance to an arrow along +Y, in steps; negative inside. It is longer than the subject, which would hide it.
fn arrow(p: Vec2) -> f32 {
    let shaft = (p.x.abs() - 0.06).max(-p.y).max(p.y - (ARROW - 0.6));
    let head = (ARROW - 0.7 - p.y).max((p.x.abs() - (ARROW - p.y) * 0.5) * 0.894);
    shaft.min(head)
}

fn mix(a: [f32; 3], b: [f32; 3], t: f32) -> [f32; 3] {
    std::array::from_fn(|c| a[c] + (b[c] - a[c]) * t)
}

/// The rays through a picture's pixels: from the eye along `corner + x · right + y · down`, of length 1 along the axis.
#[derive(Clone, Copy, Debug)]
pub struct Rays {
    eye: Vec3,
    corner: Vec3,
    right: Vec3,
    down: Vec3,
    /// Radians, or so, that a pixel takes.
    pixel: f32,
}

impl Rays {
    pub fn new(camera: &Camera) -> Rays {
        let to_world = camera.rotation.transpose();
        Rays {
            eye: camera.position(),
            corner: to_world * Vec3::new(-camera.cx / camera.fx, -camera.cy / camera.fy, 1.0),
            right: to_world.x_axis / camera.fx,
            down: to_world.y_axis / camera.fy,
            pixel: 1.0 / camera.fx,
        }
    }

    /// Where the ray of the point (x, y) of the picture, in pixels, stands at this depth.
    pub fn at(&self, x: f32, y: f32, depth: f32) -> Vec3 {
        self.eye + depth * (self.corner + x * self.right + y * self.down)
    }

    /// Where it meets the plane z = 0, and how long a pixel is there.
    #[inline]
    pub fn meet(&self, x: f32, y: f32) -> Option<(Vec3, f32)> {
        let direction = self.corner + x * self.right + y * self.down;
        let t = -self.eye.z / direction.z;
        if !(t.is_finite() && t > 0.0) {
            return None;
        }
        // Along the ground a pixel is longer the flatter it is looked at; between the two directions, their mean.
        let slant = (direction.z.abs() / direction.length()).max(1e-3);
        Some((self.eye + t * direction, t * self.pixel / slant.sqrt()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From straight above, +Y up in the picture, a pixel 0.1 units long.
    fn above() -> Camera {
        let square = Camera::look_at(Vec3::new(0.0, -1e-4, 10.0), Vec3::ZERO, 1.0, 100);
        Camera { fx: 100.0, fy: 100.0, ..square }
    }

    #[test]
    fn a_ray_meets_the_ground_where_it_should() {
        let rays = Rays::new(&above());
        let (at, pixel) = rays.meet(50.0 + 20.0, 50.0 - 30.0).unwrap();
        assert!((rays.at(70.0, 20.0, 10.0) - at).length() < 1e-3);
        assert!((at - Vec3::new(2.0, 3.0, 0.0)).length() < 1e-3, "{at}");
        assert!((pixel - 0.1).abs() < 0.01);
        let level = Camera::look_at(Vec3::new(0.0, -5.0, 1.0), Vec3::new(0.0, 0.0, 1.0), 1.0, 100);
        let level = Rays::new(&level);
        assert!(level.meet(50.0, 10.0).is_none() && level.meet(50.0, 90.0).is_some());
    }

    #[test]
    fn steps_are_round() {
        for (radius, expected) in [(3.0, 1.0), (1.8, 0.5), (6.1, 2.0), (30.0, 10.0), (0.031, 0.01), (27.0, 10.0)] {
            assert!((step(radius) / expected - 1.0).abs() < 1e-5, "{radius}: {}", step(radius));
        }
    }

    #[test]
    fn north_and_the_arrow_part_by_the_heading() {
        let rays = Rays::new(&above());
        let ground = Ground { step: 4.0, ..Ground::new(3.0, 90.0, false) };
        let at =
            |x: f32, y: f32| ground.over(&rays, (50.0 + 10.0 * x) as usize, (50.0 - 10.0 * y - 0.5) as usize, [1.0; 3]);
        let close = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 0.2);
        // Wide lines: what is looked at is no edge. The camera looked east: the arrow goes up in the picture, north is to the left.
        assert!(close(at(0.0, 3.0), ground.arrow), "{:?}", at(0.0, 3.0));
        assert!(close(at(-3.0, 0.0), ground.north), "{:?}", at(-3.0, 0.0));
        assert_eq!(at(2.45, 2.45), [1.0; 3]);
    }
}
