//! From rendered depth to a textured mesh in levels of detail.
//!
//! depth from all sides → [`fuse`] (signed distance) → [`thin`] (what the photo shows) → [`clean`] (one solid) → [`extract`] (closed surface)
//! → [`smooth`] → [`simplify`] → [`unwrap`] and [`pack`] (charts, atlas) → [`bake`] (texture) → [`Model`].
//! [`levels`] reads like that line.
//!
//! Frame: the unit frame, subject inside the unit sphere about the origin, Z up.

pub mod bake;
pub mod clean;
pub mod color;
pub mod depth_map;
pub mod detail;
pub mod distance;
pub mod expected_error;
pub mod extract;
pub mod fill;
pub mod flatten;
pub mod fuse;
pub mod levels;
pub mod opacity;
pub mod pack;
pub mod provenance;
pub mod raster;
pub mod relax;
pub mod seams;
pub mod simplify;
pub mod smooth;
pub mod source;
pub mod thin;
pub mod tiles;
pub mod unwrap;

#[cfg(test)]
mod scenes;

use crate::models::region::{dilated, eroded};
use crate::progress::Progress;
use crate::splat::Camera;
use crate::splat::render::{Drawers, Frame, SurfaceDepth};
use crate::{Error, Result};
use glam::{Vec2, Vec3};
use image::{GrayImage, RgbImage};

pub use crate::splat::render::MEDIAN;
pub use raster::{raster, rasters};

/// What a renderer sees from one camera; row-major, top row first, `camera.width · camera.height` entries each.
#[derive(Clone, Debug)]
pub struct View {
    pub camera: Camera,
    /// sRGB 0..1, composited over the background.
    pub color: Vec<[f32; 3]>,
    /// Share of light stopped, 0..1.
    pub alpha: Vec<f32>,
    /// Camera z of the surface; 0 where the ray meets none.
    pub depth: Vec<f32>,
    /// A ray meets a surface where no more than this share of its light goes on: [`MEDIAN`], or [`FIRM`]'s.
    pub passing: f32,
}

/// The surface is met where half the light would have been stopped if every Gaussian lay there twice, and is where half of it is
/// stopped if that is near.
///
/// What a network is unsure of it makes faint: a head that may look here or there is half there in either place, and where half
/// the light is asked for, a ray goes on through the one that the photo shows to the neck behind. What is sure is as thick as
/// its median depths say: those within a twentieth of the subject's radius (measured in `docs/model.md`, Surface).
pub const FIRM: SurfaceDepth = SurfaceDepth { passing: std::f32::consts::FRAC_1_SQRT_2, settling: 0.05 };
/// Pixels on all sides that a faint part has somewhere. Narrower ones are the soft rims of what is not faint.
const BROAD: usize = 1;

impl View {
    /// What `drawers` show; they say where surfaces are. Rims of what stops half the light, fainter than that, are left out.
    pub fn drawn(drawers: &Drawers, camera: &Camera, background: [f32; 3]) -> Self {
        let Frame { width, height, color, alpha, median_depth: mut depth, .. } = drawers.render(camera, background);
        let passing = drawers.surface.passing;
        if passing > MEDIAN {
            let faint = |i: usize| depth[i] > 0.0 && alpha[i] < 1.0 - MEDIAN;
            let core = eroded(width, height, BROAD, faint);
            let broad = dilated(width, height, BROAD, |i| core[i]);
            let rim: Vec<usize> = (0..depth.len()).filter(|&i| faint(i) && !broad[i]).collect();
            rim.into_iter().for_each(|i| depth[i] = 0.0);
        }
        View { camera: *camera, color, alpha, depth, passing }
    }

    /// Share of light stopped, 0..1, scaled so that a surface is met from ½ on; 1 where the alpha is not finite.
    fn firmness(&self, pixel: usize) -> f32 {
        let alpha = if self.alpha[pixel].is_finite() { self.alpha[pixel] } else { 1.0 };
        // Most of a picture is nothing.
        if alpha == 0.0 {
            return 0.0;
        }
        1.0 - (1.0 - alpha).max(0.0).powf(MEDIAN.ln() / self.passing.ln())
    }

    /// Whether a ray meets a surface.
    fn solid(&self, pixel: usize) -> bool {
        let (alpha, depth) = (self.alpha[pixel], self.depth[pixel]);
        alpha >= 1.0 - self.passing && depth > 0.0 && depth.is_finite()
    }
}

/// The photo's crop: where it sees the surface its pixels win over rendered views.
#[derive(Clone, Copy, Debug)]
pub struct PhotoView<'a> {
    /// Not the photo itself but its mirror image from the other side of a plane of symmetry: photos win over it, and so do
    /// mirror images before it.
    pub mirrored: bool,
    pub camera: Camera,
    /// sRGB 0..1.
    pub color: &'a [[f32; 3]],
    /// 1 on the subject, 0 off it.
    pub mask: &'a [f32],
}

/// How a model is made. `Options::default()` is the main job's.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The distance volume holds at most about `voxels`³ samples, spent on the subject's bounding box.
    pub voxels: usize,
    /// Levels of detail, 1 to 4.
    pub levels: usize,
    /// Most vertices a level, finest first: unique (position, normal, uv) tuples, as a vertex palette counts them.
    pub vertex_caps: [usize; 4],
    /// Most triangles of the finest level; each coarser one gets a quarter, and there are fewer levels where that is next to
    /// nothing. `None`: the vertex caps decide.
    pub triangles: Option<usize>,
    /// Texture width and height a level, finest first: powers of two, at most 2048.
    pub texture_size: [u32; 4],
    /// Cameras around the subject for depth.
    pub views: usize,
    /// Pixels across a depth view.
    pub view_size: u32,
    /// Cameras around the subject for colour.
    pub color_views: usize,
    /// Pixels across a colour view.
    pub color_size: u32,
    /// What the renderer composites on, sRGB 0..1; taken out again at soft edges.
    pub background: [f32; 3],
    /// The photo cuts the subject off below: its foot is made straight.
    pub cut_off_below: bool,
    /// Whether each level gets a tangent-space normal map of the surface before simplification.
    pub normal_map: bool,
    /// Whether each level gets an ambient occlusion map.
    pub occlusion: bool,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            voxels: 144,
            levels: 4,
            vertex_caps: [8192, 2048, 512, 128],
            triangles: None,
            texture_size: [1024, 512, 256, 128],
            views: 48,
            view_size: 256,
            color_views: 32,
            color_size: 448,
            background: [0.5; 3],
            cut_off_below: false,
            normal_map: false,
            occlusion: false,
        }
    }
}

impl Options {
    /// Of triangles that can be asked for.
    pub const FEWEST: usize = 64;
    pub const MOST: usize = 200_000;

    /// The default with another finest level: its triangles, and its texture's width and height.
    pub fn sized(triangles: Option<usize>, texture: u32) -> Self {
        let mut options = Options { triangles, ..Options::default() };
        // A closed surface has half as many vertices as triangles, and seams split some.
        if let Some(most) = triangles {
            options.vertex_caps[0] = options.vertex_caps[0].max(most * 3 / 4);
        }
        options.texture_size = [texture, texture / 2, texture / 4, texture / 8].map(|s| s.max(32));
        options
    }

    /// Vertices of a level's closed surface, seams not counted.
    fn target(&self, level: usize) -> usize {
        let by_cap = self.vertex_caps[level] * 9 / 10;
        self.triangles.map_or(by_cap, |t| by_cap.min((t >> (2 * level)) / 2)).max(4)
    }

    fn check(&self) -> Result<()> {
        let bad = |what: &str, expected: &str, found: String| Err(Error::usage(what).expected(expected).found(found));
        if !(1..=4).contains(&self.levels) {
            return bad("levels of detail", "1 to 4", self.levels.to_string());
        }
        if !(16..=512).contains(&self.voxels) {
            return bad("mesh voxels", "16 to 512 along an axis", self.voxels.to_string());
        }
        if self.views < 6 || self.views > 4096 || self.color_views < 1 || self.color_views > 4096 {
            let found = format!("{} and {}", self.views, self.color_views);
            return bad("mesh views", "6 to 4096 for depth, 1 to 4096 for colour", found);
        }
        if !(16..=2048).contains(&self.view_size) || !(16..=2048).contains(&self.color_size) {
            let found = format!("{} and {}", self.view_size, self.color_size);
            return bad("mesh view size", "16 to 2048 pixels", found);
        }
        if let Some(most) = self.triangles.filter(|t| !(Self::FEWEST..=Self::MOST).contains(t)) {
            let expected = format!("{} to {}", Self::FEWEST, Self::MOST);
            return bad("triangles of the finest level", &expected, most.to_string());
        }
        for level in 0..self.levels {
            let (cap, size) = (self.vertex_caps[level], self.texture_size[level]);
            if cap < 32 {
                return bad("vertex cap", "at least 32", cap.to_string());
            }
            if level > 0 && cap >= self.vertex_caps[level - 1] {
                return bad("vertex caps", "finest first, each smaller than the one before", cap.to_string());
            }
            if !size.is_power_of_two() || !(16..=2048).contains(&size) {
                return bad("texture size", "a power of two, 16 to 2048", size.to_string());
            }
        }
        Ok(())
    }
}

/// A closed triangle mesh without texture; counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    pub positions: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
}

impl Surface {
    /// Volume enclosed: Σ a · (b × c) / 6; positive when wound outward.
    pub fn volume(&self) -> f64 {
        let six: f64 = self
            .triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|i| self.positions[i as usize].as_dvec3());
                a.dot(b.cross(c))
            })
            .sum();
        six / 6.0
    }

    pub fn area(&self) -> f64 {
        self.triangles.iter().map(|t| (cross(&self.positions, t).length() as f64) / 2.0).sum()
    }

    /// Lowest and highest corner of the bounding box; zeros when empty.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        bounds(&self.positions)
    }
}

/// A textured triangle mesh, counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    pub positions: Vec<Vec3>,
    /// Unit length.
    pub normals: Vec<Vec3>,
    /// 0..1, origin lower left, v up.
    pub uvs: Vec<Vec2>,
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// Lowest and highest corner of the bounding box; zeros when empty.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        bounds(&self.positions)
    }
}

/// Textures beside the colours, as large as they; `None` where nobody asked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Details {
    /// Tangent space (`orb_formats::Mesh::tangents`), +X right and +Y up in the image, −1..1 as 0..1.
    pub normals: Option<RgbImage>,
    /// The share of light from all around that arrives.
    pub occlusion: Option<GrayImage>,
}

/// One level of detail.
#[derive(Clone, Debug)]
pub struct Level {
    pub mesh: Mesh,
    pub texture: RgbImage,
    pub details: Details,
    /// Largest distance, either way, between this level and the surface before simplification; scene units.
    pub error: f32,
    /// Mean of both directions' mean distances between the same two; scene units.
    pub mean_error: f32,
    /// Largest distance, either way, to the next coarser level; for the coarsest, its bounding-box diagonal.
    /// Together they are the significant sizes of OGC CDB 1.x Volume 6 §6.8.3; strictly larger for each coarser level.
    pub error_to_coarser: f32,
    /// Share of texels coloured from the photo.
    pub seen: f32,
    /// Share of texels coloured from mirror images of the photo.
    pub mirrored: f32,
}

/// The textured model.
#[derive(Clone, Debug)]
pub struct Model {
    /// Finest first.
    pub levels: Vec<Level>,
    /// Where the finest level's texture comes from, as large as it: [`provenance::shares`].
    pub provenance: RgbImage,
    /// The surface before simplification.
    pub surface: Surface,
}

/// Gaussians (or anything that renders) to a textured mesh in levels of detail.
///
/// `render` draws the subject from a camera; the views must hold `camera.width · camera.height` entries.
/// Errors: `Usage` for options out of range and for a scene without a solid subject, `Cancelled`.
pub fn build(
    render: &(dyn Fn(&Camera) -> View + Sync),
    photos: &[PhotoView],
    options: &Options,
    progress: &dyn Progress,
) -> Result<Model> {
    options.check()?;
    for photo in photos {
        let expected = photo.camera.width as usize * photo.camera.height as usize;
        if photo.color.len() != expected || photo.mask.len() != expected {
            return Err(Error::usage("photo for the texture")
                .expected(format!("{expected} pixels and mask values"))
                .found(format!("{} and {}", photo.color.len(), photo.mask.len())));
        }
    }
    levels::build(render, photos, options, progress)
}

/// Renders and checks that the arrays fit the camera.
pub(crate) fn rendered(render: &(dyn Fn(&Camera) -> View + Sync), camera: &Camera) -> Result<View> {
    let view = render(camera);
    let expected = view.camera.width as usize * view.camera.height as usize;
    let found = [view.color.len(), view.alpha.len(), view.depth.len()];
    if found != [expected; 3] {
        return Err(Error::usage("rendered view")
            .expected(format!("{expected} colours, alphas and depths"))
            .found(format!("{found:?}")));
    }
    Ok(view)
}

/// `count` directions spread evenly over the sphere by the golden angle (Fibonacci lattice).
pub fn fibonacci_sphere(count: usize) -> Vec<Vec3> {
    // Of f32, as directions have always been; multiplied in f64, since f32 knows the angle of the hundred-thousandth to a degree.
    let golden = f64::from(std::f32::consts::PI * (3.0 - 5f32.sqrt()));
    (0..count)
        .map(|i| {
            let z = 1.0 - (2.0 * i as f32 + 1.0) / count as f32;
            let r = (1.0 - z * z).max(0.0).sqrt();
            let (s, c) = (golden * i as f64).sin_cos();
            Vec3::new(r * c as f32, r * s as f32, z)
        })
        .collect()
}

/// Cameras evenly around the subject, above and below, that depth and colours come from.
pub(crate) fn surrounding_cameras(count: usize, size: u32) -> Vec<Camera> {
    fibonacci_sphere(count).iter().map(|d| Camera::look_at(*d * VIEW_DISTANCE, Vec3::ZERO, VIEW_FOV, size)).collect()
}

/// Pictures that are drawn side by side: each may need as much memory as a large scene itself.
pub(crate) const AT_A_TIME: usize = 4;

/// Distance of the cameras around the subject: a sphere of radius [`SUBJECT_RADIUS`] fills [`VIEW_FOV`].
pub(crate) const VIEW_DISTANCE: f32 = 4.1;
pub(crate) const VIEW_FOV: f32 = 30.0 * std::f32::consts::PI / 180.0;
/// sin(15°) · 4.1: what every camera has whole in its picture.
pub(crate) const SUBJECT_RADIUS: f32 = 1.06;

pub(crate) fn cross(positions: &[Vec3], t: &[u32; 3]) -> Vec3 {
    let [a, b, c] = t.map(|i| positions[i as usize]);
    (b - a).cross(c - a)
}

fn bounds(positions: &[Vec3]) -> (Vec3, Vec3) {
    if positions.is_empty() {
        return (Vec3::ZERO, Vec3::ZERO);
    }
    positions.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(lo, hi), &p| (lo.min(p), hi.max(p)))
}
