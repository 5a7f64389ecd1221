//! The CPU renderer: one picture from a set of Gaussians.

use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};

use rayon::prelude::*;

use super::binning::{Bins, TILE};
use super::projection::{Shown, SplatGradient, View};
use super::raster_backward::{Backward, TileLoss};
use super::raster_forward::{Forward, SurfaceDepth, TileDepth, TilePixels};
use crate::splat::packed::Packed;
use crate::splat::simd::dispatch;
use crate::splat::{Camera, Gaussians};

/// A rendered picture, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    pub width: usize,
    pub height: usize,
    /// Composited over the background; not clamped at 1.
    pub color: Vec<[f32; 3]>,
    /// 1 − final transmittance.
    pub alpha: Vec<f32>,
    /// Σ w·z / Σ w with z the Gaussians' camera-space depth; 0 where alpha < 1/255.
    pub depth: Vec<f32>,
    /// z of the Gaussian at which the transmittance passes ½, or where [`Drawer::surface`] says; 0 where it does not.
    pub median_depth: Vec<f32>,
}

/// A picture's colours and its α as bytes, ⌊256 v⌋ and 255 at most: the same as `shaders/bytes.wgsl` makes.
pub fn to_bytes(color: &[[f32; 3]], alpha: &[f32]) -> Vec<[u8; 4]> {
    let byte = |v: f32| (v.clamp(0.0, 1.0) * 256.0).min(255.0) as u8;
    color.par_iter().zip(alpha.par_iter()).map(|(c, a)| [byte(c[0]), byte(c[1]), byte(c[2]), byte(*a)]).collect()
}

/// Draws one set of Gaussians from many cameras: what does not depend on the camera is kept from picture to picture.
pub struct Drawer {
    gaussians: Arc<Packed>,
    raster: Raster,
    depths: Vec<TileDepth>,
    /// False leaves a picture's depths empty.
    pub depth: bool,
    /// Where `median_depth` is taken.
    pub surface: SurfaceDepth,
}

impl Drawer {
    pub fn new(g: &Gaussians) -> Self {
        Drawer::of(Arc::new(Packed::pack(g)))
    }

    fn of(gaussians: Arc<Packed>) -> Self {
        Drawer { gaussians, raster: Raster::default(), depths: Vec::new(), depth: true, surface: SurfaceDepth::MEDIAN }
    }

    /// Renders with the full harmonics. A Gaussian that is not finite or lies behind the camera is left out.
    ///
    /// α = min(0.99, o·e^−σ), contributions below 1/255 skipped, a pixel finished before its transmittance falls to 1e-4;
    /// low-pass of 0.3 pixel² (Kerbl et al. 2023; constants as in gsplat 1.6).
    pub fn render(&mut self, camera: &Camera, background: [f32; 3]) -> Frame {
        self.draw(&View::new(camera), background, self.depth)
    }

    /// The normal of the surface at every pixel; see [`normals`].
    pub fn normals(&mut self, camera: &Camera) -> Vec<[f32; 3]> {
        let frame = self.draw(&View { shown: Shown::Normals, ..View::new(camera) }, [0.0; 3], false);
        unit(&frame.color, &frame.alpha)
    }

    fn draw(&mut self, view: &View, background: [f32; 3], depth: bool) -> Frame {
        self.raster.bins.build(&self.gaussians, view, 3);
        self.raster.forward(view, depth.then_some((&mut self.depths, self.surface)));
        self.raster.frame(view, background, depth.then_some(self.depths.as_slice()))
    }
}

/// [`Drawer`]s of one set of Gaussians, as many as threads draw at a time.
pub struct Drawers {
    gaussians: Arc<Packed>,
    idle: Mutex<Vec<Drawer>>,
    /// See [`Drawer::surface`].
    pub surface: SurfaceDepth,
}

impl Drawers {
    pub fn new(g: &Gaussians) -> Self {
        Drawers::with_surface(g, SurfaceDepth::MEDIAN)
    }

    /// See [`Drawer::surface`].
    pub fn with_surface(g: &Gaussians, surface: SurfaceDepth) -> Self {
        Drawers { gaussians: Arc::new(Packed::pack(g)), idle: Mutex::default(), surface }
    }

    /// As [`Drawer::render`].
    pub fn render(&self, camera: &Camera, background: [f32; 3]) -> Frame {
        let idle = || self.idle.lock().unwrap_or_else(PoisonError::into_inner);
        let free = idle().pop();
        let new = || Drawer { surface: self.surface, ..Drawer::of(self.gaussians.clone()) };
        let mut drawer = free.unwrap_or_else(new);
        let frame = drawer.render(camera, background);
        idle().push(drawer);
        frame
    }
}

/// One picture; see [`Drawer::render`].
pub fn render(g: &Gaussians, camera: &Camera, background: [f32; 3]) -> Frame {
    Drawer::new(g).render(camera, background)
}

/// The normal of the surface at every pixel, rows from the top: a unit vector in camera space (x right, y down,
/// z forward), towards the camera; 0 where alpha < 1/255.
///
/// Σ w·n over the Gaussians, normalised, with n the shortest axis of each: of a round one it means nothing.
pub fn normals(g: &Gaussians, camera: &Camera) -> Vec<[f32; 3]> {
    Drawer::new(g).normals(camera)
}

/// Of length one, where anything is drawn.
pub(super) fn unit(sums: &[[f32; 3]], alpha: &[f32]) -> Vec<[f32; 3]> {
    let one = |(n, a): (&[f32; 3], &f32)| {
        let n = glam::Vec3::from_array(*n);
        if *a < 1.0 / 255.0 { [0.0; 3] } else { n.normalize_or_zero().to_array() }
    };
    sums.iter().zip(alpha).map(one).collect()
}

/// Bins and tiles, kept from picture to picture.
#[derive(Default)]
pub(crate) struct Raster {
    pub bins: Bins,
    pub tiles: Vec<TilePixels>,
    gradients: Vec<SplatGradient>,
    /// By depth rank, of pictures in several bands: what their intersections come to.
    sums: Vec<[f32; 9]>,
}

impl Raster {
    /// Draws what [`Bins::build`] sorted.
    pub fn forward(&mut self, view: &View, mut depths: Option<(&mut Vec<TileDepth>, SurfaceDepth)>) {
        debug_assert_eq!(view.width.div_ceil(TILE), self.bins.tiles_x);
        let count = self.bins.tiles_x * self.bins.tiles_y;
        self.tiles.resize(count, TilePixels::default());
        if let Some((depths, _)) = &mut depths {
            depths.resize(count, TileDepth::default());
        }
        let bands = self.bins.bands();
        for band in 0..bands {
            if bands > 1 {
                self.bins.place(band);
            }
            let depths = depths.as_mut().map(|(depths, surface)| (depths.as_mut_slice(), *surface));
            self.forward_band(self.bins.band(band), depths);
        }
        if bands > 1 {
            self.bins.mark();
        }
    }

    /// Draws the tiles of a band whose lists are there.
    fn forward_band(&mut self, band: Range<usize>, depths: Option<(&mut [TileDepth], SurfaceDepth)>) {
        let bins = &self.bins;
        let one = |t: usize, pixels: &mut TilePixels, depth: Option<(&mut TileDepth, SurfaceDepth)>| {
            let list = &bins.list[bins.starts[t] as usize..bins.starts[t + 1] as usize];
            let (x0, y0) = (t % bins.tiles_x * TILE, t / bins.tiles_x * TILE);
            dispatch(Forward { splats: &bins.splats, list, x0, y0, pixels, depth });
        };
        let first = band.start;
        let tiles = &mut self.tiles[band.clone()];
        match depths {
            None => tiles.par_iter_mut().enumerate().for_each(|(t, p)| one(first + t, p, None)),
            Some((depths, surface)) => {
                let pairs = tiles.par_iter_mut().zip(depths[band].par_iter_mut());
                pairs.enumerate().for_each(|(t, (p, d))| one(first + t, p, Some((d, surface))));
            }
        }
    }

    /// The gradient of every intersection, from the loss's gradient of every tile.
    pub fn backward(&mut self, loss: &[TileLoss]) {
        self.sums.clear();
        let bands = self.bins.bands();
        if bands == 1 {
            return self.backward_band(loss);
        }
        self.sums.resize(self.bins.splats.len(), [0.0; 9]);
        for band in 0..bands {
            self.bins.place(band);
            self.backward_band(loss);
            let (bins, gradients) = (&self.bins, &self.gradients);
            // Bands follow one another as a Gaussian's tiles do: the same terms in the same order as of one band.
            self.sums.par_iter_mut().enumerate().for_each(|(rank, sum)| add(sum, bins.places_of(rank), gradients));
        }
    }

    /// The same of the tiles whose lists are there.
    fn backward_band(&mut self, loss: &[TileLoss]) {
        let bins = &self.bins;
        self.gradients.resize(bins.list.len(), SplatGradient::default());
        let mut rest = self.gradients.as_mut_slice();
        let mut work = Vec::with_capacity(loss.len());
        for (t, (loss, pixels)) in loss.iter().zip(&self.tiles).enumerate() {
            let (start, end) = (bins.starts[t] as usize, bins.starts[t + 1] as usize);
            let (out, later) = rest.split_at_mut(end - start);
            rest = later;
            if !out.is_empty() {
                let (x0, y0) = (t % bins.tiles_x * TILE, t / bins.tiles_x * TILE);
                work.push(Backward { splats: &bins.splats, list: &bins.list[start..end], x0, y0, pixels, loss, out });
            }
        }
        work.into_par_iter().for_each(dispatch);
    }

    /// One Gaussian's gradient: its tiles added in a fixed order. None where no pixel depends on it.
    #[inline(always)]
    pub fn gradient_of(&self, gaussian: usize) -> Option<SplatGradient> {
        let rank = self.bins.rank_of(gaussian)?;
        let mut sum = [0.0f32; 9];
        match self.sums.get(rank) {
            Some(whole) => sum = *whole,
            None => add(&mut sum, self.bins.places_of(rank), &self.gradients),
        }
        let [g, x, y, xx, xy, yy, r, gr, b] = sum;
        (sum != [0.0; 9]).then_some(SplatGradient { g, x, y, xx, xy, yy, color: [r, gr, b] })
    }

    /// The tiles as a picture; without `depths`, one without.
    fn frame(&self, view: &View, background: [f32; 3], depths: Option<&[TileDepth]>) -> Frame {
        let (width, height) = (view.width, view.height);
        let mut color = vec![[0.0; 3]; width * height];
        let mut alpha = vec![0.0; width * height];
        let deep = if depths.is_some() { width * height } else { 0 };
        let (mut depth, mut median_depth) = (vec![0.0; deep], vec![0.0; deep]);
        let across = self.bins.tiles_x;
        // A row of tiles is one job.
        let band = (TILE * width).max(1);
        let paint = |row: usize, color: &mut [[f32; 3]], alpha: &mut [f32]| {
            for (t, pixels) in self.tiles[row * across..][..across].iter().enumerate() {
                inside(t * TILE, width, color.len() / width, |i, at| {
                    let through = pixels.transmittance[i].abs();
                    color[at] = std::array::from_fn(|c| pixels.color[c][i] + through * background[c]);
                    alpha[at] = 1.0 - through;
                });
            }
        };
        color.par_chunks_mut(band).zip(alpha.par_chunks_mut(band)).enumerate().for_each(|(r, (c, a))| paint(r, c, a));
        if let Some(depths) = depths {
            let measure = |row: usize, depth: &mut [f32], median: &mut [f32], alpha: &[f32]| {
                for (t, z) in depths[row * across..][..across].iter().enumerate() {
                    inside(t * TILE, width, depth.len() / width, |i, at| {
                        if alpha[at] >= 1.0 / 255.0 {
                            depth[at] = z.expected[i] / alpha[at];
                        }
                        median[at] = z.surface[i];
                    });
                }
            };
            let rows = depth.par_chunks_mut(band).zip(median_depth.par_chunks_mut(band)).zip(alpha.par_chunks(band));
            rows.enumerate().for_each(|(r, ((d, m), a))| measure(r, d, m, a));
        }
        Frame { width, height, color, alpha, depth, median_depth }
    }
}

/// Adds the gradients of some intersections.
#[inline(always)]
fn add(sum: &mut [f32; 9], places: &[u32], gradients: &[SplatGradient]) {
    for place in places {
        let g = &gradients[*place as usize];
        let terms = [g.g, g.x, g.y, g.xx, g.xy, g.yy, g.color[0], g.color[1], g.color[2]];
        for (s, t) in sum.iter_mut().zip(terms) {
            *s += t;
        }
    }
}

/// Every pixel of the tile at column `x0` that lies within `width` and `height`: its place in the tile and in the rows.
#[inline(always)]
fn inside(x0: usize, width: usize, height: usize, mut visit: impl FnMut(usize, usize)) {
    for y in 0..height.min(TILE) {
        for x in 0..TILE.min(width.saturating_sub(x0)) {
            visit(y * TILE + x, y * width + x0 + x);
        }
    }
}
