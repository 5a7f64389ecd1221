//! What meshes of a whole scene take: from the ground that photos will show, told from their poses.

use glam::{DVec3, Vec3};

use super::{DRAWN, Speed};
use crate::Result;
use crate::geo::similarity::Similarity;
use crate::mesh::tiles;
use crate::photos::Poses;
use crate::pipeline::scene::ground::{Expected, expected};
use crate::pipeline::scene::{pictures, unit_frame};
use crate::splat::Camera;

/// The samples' distance in the photos' pixels; that the scene's own scatter may make it wider is not known before.
const PIXELS: f64 = 2.0;
/// Samples beyond a tile on each side.
const BESIDE: f64 = 8.0;
/// Above and below what stands on the ground, in the unit frame: ten cells of the ground's surface, as they mostly are.
const MARGIN: f64 = 0.2;
/// Bytes of a sample while a tile is made.
const SAMPLE: f64 = 20.0;
/// Pictures that are kept, and bytes of a pixel in them.
const PICTURES: f64 = (512u64 << 20) as f64;
const PICTURE_PIXEL: f64 = 20.0;
/// Triangles a cell of the ground before simplification (measured: 2.9 to 3.3, walls and the scene's scatter with it), and the part
/// of them that it leaves (measured: 0.02; assumed: twice that at most).
const TRIANGLES: f64 = 3.3;
const LEFT: f64 = 0.04;
/// Bytes of a vertex that is left while the levels are made (measured, by the difference of 10,600 and 43,500 vertices: 208), and of the
/// places of a tile that its error is measured to.
const VERTEX: f64 = 210.0;
const PLACES: f64 = 12.0 * 6000.0;
/// Bytes of a Gaussian beside the scene's own: in the colours that cameras see on average, and packed for drawing.
const GAUSSIAN: f64 = 3.0 * 256.0;
/// Of the training's memory, what the system has not been given back (measured: half).
const UNRETURNED: f64 = 0.5;
/// Bytes in the files: of a triangle, and of a texel of the ground (PNG). Coarser levels add a third.
const TRIANGLE_FILE: f64 = 30.0;
const TEXEL_FILE: f64 = 1.6;
/// Where not all pictures are kept, each is drawn so many times for every level (assumed).
const AGAIN: f64 = 4.0;
/// Seconds of one core: a sample for each photo, a triangle before simplification, a texel.
const OF_SAMPLE: f64 = 1.1e-8;
const OF_TRIANGLE: f64 = 1e-6;
const OF_TEXEL: f64 = 8e-6;

/// What is to be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meshes {
    pub ground: Expected,
    /// Distance of samples in the unit frame, where the user names one.
    pub sample: Option<f32>,
}

/// The ground that the photos trained on, at most so many pixels a side, will show, and the unit frame; `up` as for
/// [`unit_frame`]. `None` where three of them see none.
///
/// # Errors
/// As [`unit_frame`].
pub fn ground(
    poses: &Poses,
    held_out: &[bool],
    up: Option<DVec3>,
    seed: u64,
    longest: u32,
) -> Result<(Option<Expected>, Similarity)> {
    let (to_unit, _, ground) = unit_frame(poses, up, seed)?;
    let is_held_out = |i: usize| held_out.get(i).copied().unwrap_or(false);
    let photos = poses.photos.iter().enumerate().filter(|(i, _)| !is_held_out(*i));
    let cameras: Vec<Camera> = photos.map(|(_, p)| pictures::camera_of(p, &to_unit, longest)).collect();
    let points: Vec<Vec3> = poses.points.iter().map(|(p, _)| to_unit.apply(*p).as_vec3()).collect();
    let level = ground.map_or(0.0, |g| to_unit.apply(g.normal * g.height).z as f32);
    Ok((expected(&cameras, &points, level), to_unit))
}

/// What it takes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Taken {
    /// Tiles of the finest level.
    pub tiles: usize,
    /// Bytes.
    pub memory: u64,
    pub disk: u64,
    pub seconds: f64,
}

impl Meshes {
    /// For so many photos, pixels in each, and Gaussians, after a training that took so many bytes.
    pub fn taken(&self, photos: usize, pixels: f64, gaussians: usize, training: u64, speed: &Speed) -> Taken {
        let Expected { area, size, pixel, heights } = self.ground;
        let (photos, area, pixel) = (photos as f64, f64::from(area), f64::from(pixel));
        let sample = self.sample.map_or(PIXELS * pixel, f64::from);
        let side = tiles::Options::default().tile as f64;
        let [columns, rows] = size.to_array().map(|v| (f64::from(v) / sample / side).ceil().max(1.0));
        let tiles = columns * rows;
        let high = (f64::from(heights[1] - heights[0]) + MARGIN) / sample + 4.0;
        let one = (side + 2.0 * BESIDE).powi(2) * high;
        let triangles = TRIANGLES * area / (sample * sample);
        let texels = area / (pixel * pixel);
        let seen = PICTURE_PIXEL * photos * pixels;
        let memory = UNRETURNED * training as f64
            + GAUSSIAN * gaussians as f64
            + SAMPLE * one
            + seen.min(PICTURES)
            + VERTEX * LEFT * triangles / 2.0
            + PLACES * tiles;
        let disk = 4.0 / 3.0 * (TEXEL_FILE * texels + TRIANGLE_FILE * LEFT * triangles);
        // A photo is drawn to say how far views disagree, for its depths, and for the colours of the levels, which are smaller.
        let drawn = photos * (1.0 + 2.0 * if seen > PICTURES { AGAIN } else { 1.0 });
        let drawing = DRAWN * drawn * (speed.pixel * pixels + speed.gaussian * gaussians as f64);
        let work = one * tiles * photos * OF_SAMPLE + triangles * OF_TRIANGLE + texels * OF_TEXEL;
        Taken {
            tiles: tiles as usize,
            memory: memory as u64,
            disk: disk as u64,
            seconds: drawing + work / speed.cores.max(1) as f64,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::photos::Posed;
    use crate::photos::colmap::{Camera as Inside, Lens};
    use glam::{DMat3, DQuat};

    const SPEED: Speed = Speed { step: 1e-3, pixel: 1e-7, gaussian: 3e-7, read: 3.6e-8, cores: 2 };

    /// Cameras on a ring of 20 m, 12 m high, that look at the middle; points on the ground and on a house of 6 m.
    fn ring(count: usize, side: u32) -> Poses {
        let camera = Inside {
            lens: Lens::Pinhole,
            width: side,
            height: side,
            parameters: vec![f64::from(side), f64::from(side), f64::from(side) / 2.0, f64::from(side) / 2.0],
        };
        let photos = (0..count).map(|k| {
            let (sin, cos) = (k as f64 * std::f64::consts::TAU / count as f64).sin_cos();
            let eye = DVec3::new(20.0 * cos, 20.0 * sin, 12.0);
            let forward = -eye.normalize();
            let right = forward.cross(DVec3::Z).normalize();
            let rows = DMat3::from_cols(right, forward.cross(right), forward).transpose();
            let rotation = DQuat::from_mat3(&rows);
            let (name, file) = (format!("{k}"), Default::default());
            Posed { name, file, camera: camera.clone(), rotation, translation: -(rotation * eye) }
        });
        let grid = |k: usize| DVec3::new((k % 40) as f64 - 20.0, (k / 40) as f64 - 20.0, 0.0);
        let house = (0..200).map(|k| DVec3::new((k % 10) as f64 - 5.0, 2.0, (k / 10) as f64 * 0.3));
        let points = (0..1600).map(grid).chain(house).map(|p| (p, [128; 3])).collect();
        let photos = photos.collect();
        Poses { photos, points, observations: Vec::new(), source: String::new(), files: Vec::new(), notes: Vec::new() }
    }

    #[test]
    fn the_ground_that_poses_will_show_is_told() {
        let poses = ring(24, 400);
        let (found, to_unit) = ground(&poses, &[], Some(DVec3::Z), 1, 400).unwrap();
        let found = found.unwrap();
        let metres = 1.0 / to_unit.scale as f32;
        // The circle that all of them look at: they see about 13 m around the middle, three of them farther.
        let radius = (found.area / std::f32::consts::PI).sqrt() * metres;
        assert!((12.0..40.0).contains(&radius), "{radius}");
        // 23 m away a pixel of a focal length of 400 is 0.058 m wide; nearer ones are smaller.
        assert!((0.03..0.06).contains(&(found.pixel * metres)), "{}", found.pixel * metres);
        let high = (found.heights[1] - found.heights[0]) * metres;
        assert!((4.5..6.5).contains(&high), "{high}");
        assert!(found.size.min_element() * metres > 1.5 * radius && found.size.max_element() * metres < 2.5 * radius);
        // Two photos are not enough, nor are those held out counted.
        let held_out: Vec<bool> = (0..24).map(|k| k > 1).collect();
        assert!(ground(&poses, &held_out, Some(DVec3::Z), 1, 400).unwrap().0.is_none());
    }

    #[test]
    fn what_meshes_take_grows_with_ground_and_finer_samples() {
        let (found, to_unit) = ground(&ring(24, 400), &[], Some(DVec3::Z), 1, 400).unwrap();
        let found = found.unwrap();
        let taken = |metres: f64, ground: Expected| {
            let sample = Some((metres * to_unit.scale) as f32);
            Meshes { ground, sample }.taken(24, 160_000.0, 50_000, 1 << 28, &SPEED)
        };
        // Many tiles, so that whole ones say little.
        let [coarse, fine] = [taken(0.02, found), taken(0.01, found)];
        assert!(fine.tiles > 3 * coarse.tiles && fine.tiles < 5 * coarse.tiles, "{coarse:?} {fine:?}");
        // Eight times the samples; twice the samples of a tile, and the surface that is left.
        assert!((4.0..10.0).contains(&(fine.seconds / coarse.seconds)), "{coarse:?} {fine:?}");
        assert!(fine.memory > coarse.memory && fine.memory < 3 * coarse.memory, "{coarse:?} {fine:?}");
        // Four times the ground: time and disk with it, memory hardly.
        let wide = taken(0.02, Expected { area: 4.0 * found.area, size: 2.0 * found.size, ..found });
        assert!((3.0..5.0).contains(&(wide.disk as f64 / coarse.disk as f64)), "{coarse:?} {wide:?}");
        assert!(wide.memory < 2 * coarse.memory && wide.tiles >= 3 * coarse.tiles, "{coarse:?} {wide:?}");
        let own = Meshes { ground: found, sample: None }.taken(24, 160_000.0, 50_000, 1 << 28, &SPEED);
        // Two pixels are about a decimetre here.
        assert!((2..coarse.tiles).contains(&own.tiles), "{own:?} {coarse:?} {fine:?}");
    }
}
