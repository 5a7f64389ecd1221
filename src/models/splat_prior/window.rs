//! The square picture of the subject that the network is given.
//!
//! It learned from cameras that are level and look straight at their subject. What lies beside a photo's optical axis is drawn out by
//! the lens and leans where the camera is pitched, and all of it where it is rolled: so it is drawn anew, as a camera at the same place
//! sees it that looks straight at it. No ray becomes another one by that.

use glam::{DMat3, DQuat, DVec2, DVec3};
use image::RgbImage;

use super::FILL;
use crate::models::scene::Subject;
use crate::photo::{Edge, Pinhole, Plane, Rect, down, sample_colour, sample_plane, sampled_at};

/// What is seen of a subject that a camera looks straight at has its middle within so much of the axis, radians; of a tall one close by
/// it is 5° above.
const ASIDE: f64 = 0.105;
/// Further than that from where a camera looks the network has to say that the subject's own middle is, radians, to be believed: where
/// the photo's camera may have looked straight at it, and where the camera was turned by what is seen of the subject.
const BELIEVED: [f64; 2] = [0.052, 0.017];
/// Further off than that it is taken for a mistake.
const TOO_FAR: f64 = 0.2;
/// Sine of how far down a camera looks at most of which nobody says it: there a small error of the elevation turns all.
const STEEPEST: f64 = 0.95;
/// What turns the picture by less is not worth drawing it anew, radians.
const HARDLY_TURNED: f64 = 0.0087;

/// The photo's camera, as far as it is needed to turn it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    pub lens: Pinhole,
    /// Nobody said what lens it was.
    pub lens_assumed: bool,
    /// Where down is, in its axes (right, down, forward), where somebody says it.
    pub down: Option<DVec3>,
    /// Where nobody does, its roll as the photo's surroundings tell it, radians ([`Subject::roll`]).
    pub roll: f64,
}

/// A square of the photo, or of the picture that a camera turned straight at the subject takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Pixels of that picture.
    pub rect: Rect,
    /// Where it is not the photo.
    pub turned: Option<Turned>,
}

/// Another camera at the photo's place, with the same lens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turned {
    pub lens: Pinhole,
    pub lens_assumed: bool,
    /// From its axes to those of the photo's camera.
    pub to_photo: DMat3,
}

impl Turned {
    /// It looks along `ray`, in the axes of the photo's camera, from `elevation` above, radians, and is level.
    fn towards(ray: DVec3, elevation: f32, &Aim { lens, lens_assumed, down, roll }: &Aim) -> Turned {
        let down = down.unwrap_or_else(|| {
            let level = down::rolled(ray, -roll);
            let steepest = (STEEPEST * 1f64.hypot(level.y / level.z) * level.z / level.length()).asin();
            down::rolled(down::by_elevation(f64::from(elevation).min(steepest), level), roll)
        });
        let forward = ray.normalize();
        let across = down.cross(forward);
        // Straight down there is no telling, and the photo's own right counts.
        let across = if across.length() > 0.05 { across } else { DVec3::X.reject_from_normalized(forward) };
        let right = across.normalize();
        Turned { lens, lens_assumed, to_photo: DMat3::from_cols(right, forward.cross(right), forward) }
    }

    /// By how much it is turned from the photo's, radians.
    pub fn angle(&self) -> f64 {
        turn(self.to_photo)
    }

    /// Where the photo shows what this camera's picture shows there.
    fn in_photo(&self, pixel: DVec2) -> Option<DVec2> {
        self.lens.pixel(self.to_photo * self.lens.ray(pixel))
    }

    fn of_photo(&self, pixel: DVec2) -> Option<DVec2> {
        self.lens.pixel(self.to_photo.transpose() * self.lens.ray(pixel))
    }
}

impl Window {
    /// Of the photo as it is: the square that the subject's box fills to [`FILL`]; it may reach outside.
    pub fn around(subject: &Subject) -> Window {
        let [x0, y0, x1, y1] = subject.bounds.map(|v| v as f32);
        let (sx, sy) = subject.scale;
        Window { rect: filled([x0 * sx, y0 * sy, x1 * sx, y1 * sy]), turned: None }
    }

    /// As a level camera sees the subject that looks straight at the middle of what is seen of it, where that is aside; else one that looks
    /// where the photo's camera does. `elevation`, radians, counts where nobody says where down is.
    pub fn straight(subject: &Subject, aim: &Aim, elevation: f32) -> Window {
        let ray = aim.lens.ray(Window::around(subject).middle());
        Window::towards(subject, aim, elevation, if ray.angle_between(DVec3::Z) > ASIDE { ray } else { DVec3::Z })
    }

    fn towards(subject: &Subject, aim: &Aim, elevation: f32, ray: DVec3) -> Window {
        let turned = Turned::towards(ray, elevation, aim);
        let seen = Some(turned).filter(|t| t.angle() > HARDLY_TURNED).and_then(|t| Some((t, bounds(subject, &t)?)));
        match seen {
            Some((turned, bounds)) => Window { rect: filled(bounds), turned: Some(turned) },
            None => Window::around(subject),
        }
    }

    /// From the window's axes to those of the photo's camera.
    fn to_photo(self) -> DMat3 {
        self.turned.map_or(DMat3::IDENTITY, |t| t.to_photo)
    }

    /// One that looks at the subject's own middle, by what the network says of this one: `elevation`, and `middle`, right and down of the
    /// window's in halves of its side. `None` where this one does, or the network is not to be believed.
    pub fn corrected(&self, subject: &Subject, aim: &Aim, elevation: f32, middle: [f32; 2]) -> Option<Window> {
        let Rect { x, y, width, height } = self.rect;
        let at =
            DVec2::new(f64::from(x + width / 2.0 * (1.0 + middle[0])), f64::from(y + height / 2.0 * (1.0 + middle[1])));
        let (axis, ray) = (self.to_photo().z_axis, self.to_photo() * aim.lens.ray(at));
        let aside = axis.angle_between(DVec3::Z) > 1e-6;
        let off = ray.angle_between(axis);
        let believed = off > BELIEVED[usize::from(aside)] && off < TOO_FAR;
        let other = Window::towards(subject, aim, elevation, if believed { ray } else { axis });
        (turn(self.to_photo().transpose() * other.to_photo()) > HARDLY_TURNED).then_some(other)
    }

    /// What of the photo is in its middle, pixels.
    pub fn middle(&self) -> DVec2 {
        let middle = self.rect_middle();
        self.turned.as_ref().and_then(|t| t.in_photo(middle)).unwrap_or(middle)
    }

    fn rect_middle(&self) -> DVec2 {
        let Rect { x, y, width, height } = self.rect;
        DVec2::new(f64::from(x + width / 2.0), f64::from(y + height / 2.0))
    }

    /// Where down is for the photo's camera, in its axes, if it sees the window's middle from `elevation` above, radians.
    pub fn down(&self, lens: &Pinhole, elevation: f64) -> DVec3 {
        let lens = self.turned.map_or(*lens, |t| t.lens);
        self.to_photo() * down::by_elevation(elevation, lens.ray(self.rect_middle()))
    }

    /// Right of the camera that it is seen with, in the axes of the photo's, as little turned as it can be where the photo was left as it is.
    pub fn right(&self, lens: &Pinhole) -> DVec3 {
        match self.turned {
            Some(turned) => turned.to_photo.x_axis,
            None => DQuat::from_rotation_arc(DVec3::Z, lens.ray(self.middle()).normalize()) * DVec3::X,
        }
    }

    /// Tangent of half the angle that it spans, with the photo's lens.
    ///
    /// Beside the optical axis a pixel spans less: across the way there the cosine, along it the cosine squared of what it does on the
    /// axis; the (geometric) mean of both counts.
    pub fn half_angle(&self, lens: &Pinhole) -> f32 {
        let (width, ray) = (self.rect.width, lens.ray(self.rect_middle()));
        let focal = (lens.focal.x * lens.focal.y).sqrt();
        (f64::from(width) / 2.0 / focal * ray.length().powf(-1.5)) as f32
    }

    /// Depth along the photo's optical axis over that along the crop's own, of what lies on the ray through a pixel of `size` × `size`.
    pub fn deeper(&self, x: usize, y: usize, size: usize) -> f32 {
        self.turned.map_or(1.0, |t| (t.to_photo * t.lens.ray(self.pixel(x, y, size))).z as f32)
    }

    /// `size` × `size` colours, sRGB 0..1, row-major.
    pub fn colour(&self, photo: &RgbImage, size: usize) -> Vec<[f32; 3]> {
        let Some(turned) = self.turned else { return sample_colour(photo, self.rect, size, size, Edge::Clamp) };
        let (rect, width, height) = self.source(&turned, (1.0, 1.0), size);
        let drawn = sample_colour(photo, rect, width, height, Edge::Clamp);
        let mut out =
            sampled_at(&drawn, (width, height), size, self.within(&turned, (1.0, 1.0), size, rect, (width, height)));
        out.iter_mut().flatten().for_each(|v| *v = v.clamp(0.0, 1.0));
        out
    }

    /// `size` × `size` of a plane over the whole photo, `scale` of whose pixels are one of its, across and down. Values 0..1.
    pub fn plane(&self, plane: &Plane, scale: (f32, f32), size: usize, edge: Edge) -> Plane {
        let Some(turned) = self.turned else {
            let Rect { x, y, width, height } = self.rect;
            let rect = Rect { x: x / scale.0, y: y / scale.1, width: width / scale.0, height: height / scale.1 };
            return sample_plane(plane, rect, size, size, edge);
        };
        let (rect, width, height) = self.source(&turned, scale, size);
        let drawn: Vec<[f32; 1]> = sample_plane(plane, rect, width, height, edge).data.iter().map(|v| [*v]).collect();
        let out = sampled_at(&drawn, (width, height), size, self.within(&turned, scale, size, rect, (width, height)));
        Plane { width: size, height: size, data: out.iter().map(|[v]| v.clamp(0.0, 1.0)).collect() }
    }

    /// The middle of one of `size` × `size` pixels.
    fn pixel(&self, x: usize, y: usize, size: usize) -> DVec2 {
        let Rect { x: left, y: top, width, height } = self.rect;
        let at = DVec2::new(x as f64 + 0.5, y as f64 + 0.5) / size as f64;
        DVec2::new(f64::from(left), f64::from(top)) + at * DVec2::new(f64::from(width), f64::from(height))
    }

    /// The part of a picture over the photo that the crop shows, and how many samples of it are about as fine as the crop's.
    fn source(&self, turned: &Turned, scale: (f32, f32), size: usize) -> (Rect, usize, usize) {
        let ends = [0, size / 2, size - 1];
        let seen = ends.iter().flat_map(|y| ends.iter().map(move |x| (*x, *y)));
        let seen = seen.filter_map(|(x, y)| turned.in_photo(self.pixel(x, y, size)));
        let [x0, y0, x1, y1] = boxed(seen.map(|p| p.as_vec2())).unwrap_or([0.0, 0.0, 1.0, 1.0]);
        let step = (self.rect.width / size as f32 * 0.8).max(scale.0.min(scale.1));
        // So that the kernel has what it needs at the border.
        let (x0, y0, x1, y1) = (x0 - 4.0 * step, y0 - 4.0 * step, x1 + 4.0 * step, y1 + 4.0 * step);
        let rect = Rect { x: x0 / scale.0, y: y0 / scale.1, width: (x1 - x0) / scale.0, height: (y1 - y0) / scale.1 };
        let count = |extent: f32| ((extent / step).ceil() as usize).clamp(1, 8 * size);
        (rect, count(x1 - x0), count(y1 - y0))
    }

    /// For each pixel of the crop where it lies in those samples, middles at halves.
    fn within(
        &self,
        turned: &Turned,
        scale: (f32, f32),
        size: usize,
        rect: Rect,
        (width, height): (usize, usize),
    ) -> impl Fn(usize, usize) -> [f32; 2] + Sync {
        let (window, turned) = (*self, *turned);
        move |x, y| match turned.in_photo(window.pixel(x, y, size)) {
            Some(at) => [
                (at.x as f32 / scale.0 - rect.x) / rect.width * width as f32,
                (at.y as f32 / scale.1 - rect.y) / rect.height * height as f32,
            ],
            None => [-1e9; 2],
        }
    }
}

/// The angle of a rotation, radians.
fn turn(rotation: DMat3) -> f64 {
    let DMat3 { x_axis, y_axis, z_axis } = rotation;
    ((x_axis.x + y_axis.y + z_axis.z - 1.0) / 2.0).clamp(-1.0, 1.0).acos()
}

/// The square that a box, left, top, right, bottom, fills to [`FILL`].
fn filled([x0, y0, x1, y1]: [f32; 4]) -> Rect {
    let side = (x1 - x0).max(y1 - y0) / FILL;
    Rect { x: (x0 + x1) / 2.0 - side / 2.0, y: (y0 + y1) / 2.0 - side / 2.0, width: side, height: side }
}

fn boxed(points: impl Iterator<Item = glam::Vec2>) -> Option<[f32; 4]> {
    points.fold(None, |found, p| {
        let [x0, y0, x1, y1] = found.unwrap_or([p.x, p.y, p.x, p.y]);
        Some([x0.min(p.x), y0.min(p.y), x1.max(p.x), y1.max(p.y)])
    })
}

/// The box of the subject as the turned camera sees it. `None` where not all of it lies before that camera.
fn bounds(subject: &Subject, turned: &Turned) -> Option<[f32; 4]> {
    let [x0, y0, x1, y1] = subject.bounds;
    let (sx, sy) = subject.scale;
    let on = |x: &usize, y: usize| subject.mask.at(*x, y) > 0.5;
    // Of each row both ends.
    let ends = (y0..y1).filter_map(|y| Some((y, (x0..x1).find(|x| on(x, y))?, (x0..x1).rfind(|x| on(x, y))? + 1)));
    let corners = ends.flat_map(|(y, first, last)| [(first, y), (last, y), (first, y + 1), (last, y + 1)]);
    let seen = corners.map(|(x, y)| turned.of_photo(DVec2::new(x as f64 * f64::from(sx), y as f64 * f64::from(sy))));
    boxed(seen.map(|p| p.map(|p| p.as_vec2())).collect::<Option<Vec<_>>>()?.into_iter())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::scene::Angle;
    use crate::photo::down::tests::camera;

    const LENS: Pinhole = Pinhole { focal: DVec2::splat(400.0), middle: DVec2::new(320.0, 240.0) };

    /// What is on a ray of the world, by east, north and up: rings and spokes, so that any turn shows.
    fn shade(ray: DVec3) -> [f32; 3] {
        let (bears, above) = (ray.x.atan2(ray.y), ray.z.atan2(ray.x.hypot(ray.y)));
        [0.5 + 0.4 * (9.0 * bears).sin(), 0.5 + 0.4 * (11.0 * above).cos(), 0.5 + 0.3 * (7.0 * (bears + above)).sin()]
            .map(|v| v as f32)
    }

    fn photo(camera: DMat3) -> RgbImage {
        RgbImage::from_fn(640, 480, |x, y| {
            let ray = LENS.ray(DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5));
            image::Rgb(shade(camera.transpose() * ray).map(|v| (255.0 * v).round() as u8))
        })
    }

    /// A disc of the mask, whose pixels are two of the photo's.
    fn subject(at: (f32, f32), radius: f32) -> Subject {
        let inside =
            |i: usize| ((i % 320) as f32 + 0.5 - at.0 / 2.0).hypot((i / 320) as f32 + 0.5 - at.1 / 2.0) < radius / 2.0;
        let data: Vec<f32> = (0..320 * 240).map(|i| f32::from(u8::from(inside(i)))).collect();
        let on: Vec<(usize, usize)> = (0..data.len()).filter(|i| data[*i] > 0.5).map(|i| (i % 320, i / 320)).collect();
        let (xs, ys) = (on.iter().map(|p| p.0), on.iter().map(|p| p.1));
        let bounds =
            [xs.clone().min().unwrap(), ys.clone().min().unwrap(), xs.max().unwrap() + 1, ys.max().unwrap() + 1];
        Subject {
            mask: Plane { width: 320, height: 240, data },
            depth: Plane::new(320, 240, 0.0),
            bounds,
            scale: (2.0, 2.0),
            from_cutout: false,
            expected_iou: None,
            elevation: Angle { mean: 0.0, spread: 0.1 },
            roll: 0.0,
        }
    }

    #[test]
    fn what_lies_aside_is_seen_as_by_a_level_camera_that_looks_at_it() {
        for (heading, pitch, roll, at) in [
            (40.0, -30.0, 0.0, (520.0, 150.0)),
            (120.0, -60.0, 0.0, (150.0, 300.0)),
            (300.0, 10.0, 6.0, (330.0, 250.0)),
        ] {
            let (from, subject) = (camera(heading, pitch, roll), subject(at, 60.0));
            let below = from * -DVec3::Z;
            let window = Window::straight(&subject, &Aim { down: Some(below), ..level(LENS) }, 0.0);
            let at = DVec2::new(at.0.into(), at.1.into());
            assert!((window.middle() - at).length() < 6.0, "{:?}", window.middle());
            // A camera that is turned so in the world.
            let ray = from.transpose() * LENS.ray(at);
            let aim = if roll == 0.0 { ray } else { from.transpose() * DVec3::Z };
            let (bears, above) = (aim.x.atan2(aim.y), aim.z.atan2(aim.x.hypot(aim.y)));
            let straight = camera(bears.to_degrees(), above.to_degrees(), 0.0);
            let (colour, size) = (window.colour(&photo(from), 96), 96);
            let mut worst = 0.0f32;
            for (i, seen) in colour.iter().enumerate() {
                let wanted = shade(straight.transpose() * LENS.ray(window.pixel(i % size, i / size, size)));
                (0..3).for_each(|c| worst = worst.max((seen[c] - wanted[c]).abs()));
            }
            assert!(worst < 0.03, "{worst} at {at:?}");
            // The disc fills the window.
            let mask = window.plane(&subject.mask, subject.scale, size, Edge::Zero);
            let across = (0..size).filter(|x| mask.at(*x, size / 2) > 0.5).count() as f32 / size as f32;
            assert!((across / FILL - 1.0).abs() < 0.12, "{across}");
            assert!(
                (window.deeper(size / 2, size / 2, size) - LENS.ray(window.middle()).length().recip() as f32).abs()
                    < 0.03
                    || roll != 0.0
            );
        }
    }

    /// A camera of which nobody says how it was held.
    fn level(lens: Pinhole) -> Aim {
        Aim { lens, lens_assumed: true, down: None, roll: 0.0 }
    }

    #[test]
    fn a_level_photo_of_what_it_looks_at_is_left_as_it_is() {
        let subject = subject((336.0, 222.0), 80.0);
        let window = Window::straight(&subject, &level(LENS), 0.5);
        assert_eq!(window, Window::around(&subject));
        // What the network says counts from 3° on, and no more where it cannot be.
        let seen = |aside: f64| [(aside * 400.0 / f64::from(window.rect.width) * 2.0) as f32 - 0.2, 0.2];
        assert_eq!(window.corrected(&subject, &level(LENS), 0.5, seen(0.03)), None);
        assert_eq!(window.corrected(&subject, &level(LENS), 0.5, seen(0.5)), None);
        let turned = window.corrected(&subject, &level(LENS), 0.5, seen(0.1)).and_then(|w| w.turned).unwrap();
        assert!((turned.angle() - 0.1).abs() < 0.03, "{}", turned.angle());
    }

    #[test]
    fn a_rolled_photo_is_drawn_upright() {
        let subject = subject((500.0, 300.0), 60.0);
        for roll in [0.08, -0.05] {
            let aim = Aim { roll, ..level(LENS) };
            let window = Window::straight(&subject, &aim, 0.4);
            let down = window.down(&LENS, 0.4);
            assert!((down.x.atan2(down.y) - roll).abs() < 0.01, "{roll}: {down}");
            assert!((down::elevation(down, LENS.ray(window.middle())) - 0.4).abs() < 1e-6);
            // The same as by a word on where down is.
            let told = Window::straight(&subject, &Aim { down: Some(down), ..level(LENS) }, 0.0).turned.unwrap();
            assert!(turn(told.to_photo.transpose() * window.turned.unwrap().to_photo) < 0.01);
        }
    }

    #[test]
    fn a_turned_camera_looks_where_the_network_says() {
        let subject = subject((500.0, 240.0), 60.0);
        let window = Window::straight(&subject, &level(LENS), 0.5);
        let turned = window.turned.unwrap();
        assert!(turned.lens_assumed && (turned.to_photo.z_axis.x / turned.to_photo.z_axis.z - 0.45).abs() < 0.02);
        assert_eq!(window.corrected(&subject, &level(LENS), 0.5, [0.0; 2]), None);
        // Its own middle to the right of what is seen of it by a quarter of the window, 0.05 radians.
        let corrected = window.corrected(&subject, &level(LENS), 0.5, [0.25, 0.0]).unwrap();
        let (from, to) = (turned.to_photo.z_axis, corrected.turned.unwrap().to_photo.z_axis);
        let asked = f64::from(window.rect.width) / 8.0 / 400.0;
        assert!((from.angle_between(to) - asked).abs() < 0.01 && to.x > from.x, "{} {asked}", from.angle_between(to));
    }

    #[test]
    fn nobodys_word_never_lays_a_subject_on_its_side() {
        let subject = subject((560.0, 240.0), 50.0);
        for elevation in [1.0, 1.2, 1.5] {
            let turned = Window::straight(&subject, &level(LENS), elevation).turned.unwrap();
            let right = turned.to_photo.x_axis;
            assert!(right.y.atan2(right.x).abs() < 1.1, "{elevation}: {right}");
        }
    }

    #[test]
    fn what_reaches_behind_the_other_camera_is_left_as_it_is() {
        let wide = Pinhole { focal: DVec2::splat(60.0), ..LENS };
        let subject = subject((380.0, 240.0), 225.0);
        assert_eq!(Window::straight(&subject, &level(wide), 0.5).turned, None);
    }
}
