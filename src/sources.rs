//! What takes the place of the built-in networks in a run: files that the user brings, networks that the user imported.

use image::{GrayImage, Rgb, RgbImage, RgbaImage};

use crate::audit::canonical::sha256_hex;
use crate::models::depth::{self, fit};
use crate::models::registry::catalogue::DepthKind;
use crate::models::registry::{Manifest, Network, Role};
use crate::models::scene::Subject;
use crate::models::splat_prior::OneView;
use crate::models::zero123::{self, Prompt, cache::Cache};
use crate::models::{Engine, Graph, Rten, sam};
use crate::photo::{Edge, Photo, Plane, Rect, sample_plane};
use crate::progress::Progress;
use crate::views::pose;
use crate::views::tile::{self, View};
use crate::{Error, Result};

/// Where the mask comes from.
pub enum Mask {
    /// The built-in network's, of what this point of the photo (pixels) lies on, or of what stands in the middle.
    BuiltIn(Option<[f32; 2]>),
    /// 0..255; any size, laid over the whole photo.
    Given(GrayImage),
    Network(Network, sam::Prompt),
}

/// Where the six views come from.
pub enum Views {
    BuiltIn,
    /// A ready tile, and its normals as [`tile::normals`] reads them, where they were given too.
    Given(RgbaImage, Vec<Vec<[f32; 3]>>),
    Network(Network, zero123::Settings),
}

/// Of one run.
pub struct Sources {
    /// Runs imported networks.
    pub engine: Box<dyn Engine>,
    pub mask: Mask,
    pub depth: Option<Network>,
    pub views: Views,
    /// Tiles made earlier.
    pub cache: Option<Cache>,
}

impl Default for Sources {
    fn default() -> Self {
        Sources { engine: Box::new(Rten), mask: Mask::BuiltIn(None), depth: None, views: Views::BuiltIn, cache: None }
    }
}

/// A network that ran.
#[derive(Clone, Debug, PartialEq)]
pub struct Ran {
    pub manifest: Manifest,
    /// The engine's name.
    pub runtime: String,
}

/// What really happened.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    pub mask: Option<Ran>,
    /// The mask network's own score, and whether a second pass refined it.
    pub mask_score: Option<(f32, bool)>,
    pub mask_given: bool,
    pub depth: Option<Ran>,
    /// None where no depth network ran, or where its depth did not agree with the prior's at all.
    pub depth_fit: Option<fit::Fit>,
    /// Of a metric depth network.
    pub front: Option<fit::Front>,
    pub views: Option<Ran>,
    /// SHA-256 of the tile's pixels, where one was drawn or given.
    pub tile_sha256: Option<String>,
    pub tile_from_cache: bool,
    /// SHA-256 of the pixels of the normals that a ControlNet drew.
    pub normals_sha256: Option<String>,
    /// The photo's pose among the six views.
    pub pose: Option<pose::Found>,
}

impl Outcome {
    pub fn views_are_the_priors(&self) -> bool {
        self.tile_sha256.is_none()
    }

    /// In the order of the pipeline.
    pub fn ran(&self) -> impl Iterator<Item = &Ran> {
        [&self.mask, &self.depth, &self.views].into_iter().flatten()
    }
}

impl Sources {
    fn ran(&self, network: &Network) -> Ran {
        Ran { manifest: network.manifest.clone(), runtime: self.engine.name().to_owned() }
    }

    fn open(&self, network: &Network, role: Role) -> Result<Box<dyn Graph>> {
        self.engine.load_file(&network.path(role)?)
    }

    /// Nothing takes the place of the prior's own views.
    pub fn views_are_the_priors(&self) -> bool {
        matches!(self.views, Views::BuiltIn)
    }

    /// A mask in place of the built-in network's, of the photo's size.
    ///
    /// # Errors
    /// As [`sam::segment`].
    pub fn mask(&self, photo: &Photo, outcome: &mut Outcome, progress: &dyn Progress) -> Result<Option<GrayImage>> {
        let (w, h) = photo.pixels.dimensions();
        match &self.mask {
            Mask::BuiltIn(_) => Ok(None),
            Mask::Given(mask) => {
                outcome.mask_given = true;
                Ok(Some(stretched(mask, w, h)))
            }
            Mask::Network(network, prompt) => {
                let mut open = |role| self.open(network, role);
                let found = sam::segment(&photo.pixels, prompt, network.manifest.family, &mut open, progress)?;
                outcome.mask = Some(self.ran(network));
                outcome.mask_score = Some((found.score, found.refined));
                Ok(Some(found.mask))
            }
        }
    }

    /// The point of the photo that tells the built-in network what the subject is.
    pub fn point(&self) -> Option<[f32; 2]> {
        match self.mask {
            Mask::BuiltIn(point) => point,
            Mask::Given(_) | Mask::Network(..) => None,
        }
    }

    /// Normalised inverse depth of the size of the subject's planes.
    ///
    /// # Errors
    /// As [`depth::inverse_depth`].
    pub fn depth(&self, photo: &Photo, subject: &Subject, outcome: &mut Outcome) -> Result<Option<depth::Seen>> {
        let Some(network) = &self.depth else { return Ok(None) };
        let kind = network.manifest.depth_kind.unwrap_or(DepthKind::Disparity);
        let size = (subject.depth.width, subject.depth.height);
        let seen = depth::inverse_depth(&photo.pixels, kind, &*self.open(network, Role::Depth)?, size)?;
        outcome.depth = Some(self.ran(network));
        Ok(Some(seen))
    }

    /// Six views drawn by others, and the prior settled among them.
    ///
    /// # Errors
    /// As [`zero123::six_views`], [`tile::cut`], [`tile::normals`] and [`pose::settle`].
    pub fn six_views(
        &self,
        prior: &mut OneView,
        seed: u64,
        outcome: &mut Outcome,
        progress: &dyn Progress,
    ) -> Result<Option<SixViews>> {
        let (tile, normals) = match &self.views {
            Views::BuiltIn => return Ok(None),
            Views::Given(tile, normals) => (tile.clone(), normals.clone()),
            Views::Network(network, settings) => {
                outcome.views = Some(self.ran(network));
                let (colours, normals) = self.drawn(network, settings, &on_grey(prior), outcome, progress)?;
                outcome.normals_sha256 = normals.as_ref().map(|n| sha256_hex(n.as_raw()));
                let normals = normals.map_or(Ok(Vec::new()), |n| tile::normals(&n))?;
                (tile::with_alpha(&colours), normals)
            }
        };
        outcome.tile_sha256 = Some(sha256_hex(tile.as_raw()));
        let views = tile::cut(&tile)?;
        outcome.pose = Some(pose::settle(prior, &views, seed, progress)?);
        Ok(Some(SixViews { views, normals }))
    }

    /// A tile of colours, and one of normals where the network has a ControlNet.
    fn drawn(
        &self,
        network: &Network,
        settings: &zero123::Settings,
        picture: &RgbImage,
        outcome: &mut Outcome,
        progress: &dyn Progress,
    ) -> Result<(RgbImage, Option<RgbImage>)> {
        let key = zero123::cache::key(picture, &network.manifest.weights_sha256(), self.engine.name(), settings);
        let normals_key = sha256_hex(format!("orb.six-normals/v1\n{key}\n").as_bytes());
        let kept = |key: &str| self.cache.as_ref().and_then(|c| c.get(key));
        let keep = |key: &str, tile: &RgbImage| self.cache.as_ref().map_or(Ok(()), |c| c.put(key, tile));
        let prompt = || Prompt::read(&network.path(Role::Prompt)?);
        let mut open = |role| self.open(network, role);
        let tile = kept(&key);
        outcome.tile_from_cache = tile.is_some();
        let tile = match tile {
            Some(tile) => tile,
            None => {
                let tile = zero123::six_views(picture, None, &prompt()?, &mut open, settings, progress)?;
                keep(&key, &tile)?;
                tile
            }
        };
        if !network.has(Role::ControlNet) {
            return Ok((tile, None));
        }
        let normals = match kept(&normals_key) {
            Some(normals) => normals,
            None => {
                let normals = zero123::six_views(picture, Some(&tile), &prompt()?, &mut open, settings, progress)?;
                keep(&normals_key, &normals)?;
                normals
            }
        };
        Ok((tile, Some(normals)))
    }
}

/// Drawn by others.
pub struct SixViews {
    pub views: Vec<View>,
    /// Of each view as [`tile::normals`] reads them, or none at all.
    pub normals: Vec<Vec<[f32; 3]>>,
}

/// The depth network's surface in the prior; its plane in the subject.
pub fn fit_depth(prior: &mut OneView, subject: &mut Subject, depth: depth::Seen, outcome: &mut Outcome) {
    outcome.front = depth.metric.and_then(|range| fit::front(prior, &depth.inverse, subject.scale, range));
    outcome.depth_fit = fit::move_front(prior, &depth.inverse, subject.scale);
    subject.depth = depth.inverse;
}

/// The subject alone on mid-grey, as Zero123++ was trained: a square of at least 320 pixels.
fn on_grey(prior: &OneView) -> RgbImage {
    let side = prior.mask.width;
    let blended = |i: usize| {
        let a = prior.mask.data[i];
        prior.colour[i].map(|v| (v * 255.0 * a + 127.0 * (1.0 - a)).round() as u8)
    };
    let picture = RgbImage::from_fn(side as u32, side as u32, |x, y| Rgb(blended(y as usize * side + x as usize)));
    match side < 320 {
        true => image::imageops::resize(&picture, 320, 320, image::imageops::FilterType::CatmullRom),
        false => picture,
    }
}

fn stretched(mask: &GrayImage, width: u32, height: u32) -> GrayImage {
    if mask.dimensions() == (width, height) {
        return mask.clone();
    }
    let (w, h) = (mask.width() as usize, mask.height() as usize);
    let plane = Plane { width: w, height: h, data: mask.as_raw().iter().map(|v| f32::from(*v)).collect() };
    let whole = Rect { x: 0.0, y: 0.0, width: w as f32, height: h as f32 };
    let out = sample_plane(&plane, whole, width as usize, height as usize, Edge::Clamp);
    GrayImage::from_fn(width, height, |x, y| image::Luma([out.at(x as usize, y as usize).round() as u8]))
}

/// A mask from a picture: its alpha where it has one that cuts something out, else its brightness.
///
/// # Errors
/// A usage error when nothing, or everything, is masked, or the shape is not the photo's.
pub fn mask_from(picture: &Photo, photo: (u32, u32)) -> Result<GrayImage> {
    let brightness = || image::DynamicImage::from(picture.pixels.clone()).into_luma8();
    let mask = picture.cutout.clone().unwrap_or_else(brightness);
    let aspect = |(w, h): (u32, u32)| f64::from(w) / f64::from(h);
    if (aspect(mask.dimensions()) / aspect(photo) - 1.0).abs() > 0.02 {
        return Err(Error::usage("--mask")
            .expected(format!("a picture of the photo's shape, {} × {}", photo.0, photo.1))
            .found(format!("{} × {}", mask.width(), mask.height())));
    }
    let inside = mask.iter().filter(|v| **v > 127).count();
    if inside == 0 || inside == (mask.width() * mask.height()) as usize {
        return Err(Error::usage("--mask")
            .expected("white on the subject, black around it, or an alpha channel")
            .found(if inside == 0 { "nothing white" } else { "nothing black" }));
    }
    Ok(mask)
}

/// A tile from a picture, straight colours; decoding laid what was transparent over white.
pub fn tile_from(picture: &Photo) -> RgbaImage {
    RgbaImage::from_fn(picture.pixels.width(), picture.pixels.height(), |x, y| {
        let alpha = picture.cutout.as_ref().map_or(255, |c| c.get_pixel(x, y).0[0]);
        let a = f32::from(alpha.max(1)) / 255.0;
        let own = picture.pixels.get_pixel(x, y).0.map(|v| ((f32::from(v) - 255.0 * (1.0 - a)) / a).round() as u8);
        image::Rgba([own[0], own[1], own[2], alpha])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(pixels: RgbImage, cutout: Option<GrayImage>) -> Photo {
        Photo {
            name: "mask.png".into(),
            media_type: "image/png",
            sha256: [0; 32],
            byte_len: 0,
            pixels,
            cutout,
            exif: Default::default(),
        }
    }

    #[test]
    fn masks_come_from_alpha_or_brightness_and_must_fit() {
        let half = RgbImage::from_fn(40, 30, |x, _| Rgb([if x < 20 { 255 } else { 0 }; 3]));
        let mask = mask_from(&picture(half.clone(), None), (400, 300)).unwrap();
        let large = stretched(&mask, 400, 300);
        assert!(large.get_pixel(100, 5).0[0] == 255 && large.get_pixel(300, 290).0[0] == 0);
        let cut = GrayImage::from_fn(40, 30, |x, _| image::Luma([if x < 10 { 255 } else { 0 }]));
        assert_eq!(mask_from(&picture(half, Some(cut)), (40, 30)).unwrap().get_pixel(15, 3).0[0], 0);
        for (pixels, words) in [
            (RgbImage::new(40, 30), "nothing white"),
            (RgbImage::from_pixel(40, 30, Rgb([255; 3])), "nothing black"),
            (RgbImage::new(30, 40), "30 × 40"),
        ] {
            assert!(mask_from(&picture(pixels, None), (400, 300)).unwrap_err().found.contains(words));
        }
    }

    #[test]
    fn a_controlnet_draws_normals_once() {
        use crate::models::registry::{Import, Registry, import, tests::zero123};
        use crate::progress::Silent;
        let folder = tempfile::tempdir().unwrap();
        let registry = Registry::at(folder.path().join("models"));
        let stubs = zero123(&folder.path().join("stubs"), "unet_read_controlled", true);
        let request = Import { sources: vec![stubs], allow_unpinned: true, accept_licence: true, ..Import::default() };
        let network = registry.verified(&import(&registry, &request, &Rten, &mut |_| {}).unwrap()).unwrap();
        let sources = Sources { cache: Some(Cache::at(folder.path().join("cache"))), ..Sources::default() };
        let settings = zero123::Settings { steps: 1, ..zero123::Settings::default() };
        let picture = RgbImage::from_fn(320, 320, |x, y| Rgb([x as u8, y as u8, 60]));
        let drawn = || {
            let mut outcome = Outcome::default();
            let made = sources.drawn(&network, &settings, &picture, &mut outcome, &Silent).unwrap();
            (made, outcome.tile_from_cache)
        };
        let ((colours, normals), kept) = drawn();
        assert!(!kept && normals.as_ref().is_some_and(|n| *n != colours));
        assert!(drawn() == ((colours, normals), true));
    }

    #[test]
    fn a_tiles_white_comes_out_of_its_colours() {
        // Red at half opacity over white.
        let tile = tile_from(&picture(
            RgbImage::from_pixel(2, 2, Rgb([255, 127, 127])),
            Some(GrayImage::from_pixel(2, 2, image::Luma([128]))),
        ));
        let p = tile.get_pixel(1, 1).0;
        assert!(p[0] == 255 && p[1] < 3 && p[3] == 128, "{p:?}");
        let opaque = tile_from(&picture(RgbImage::from_pixel(2, 2, Rgb([9, 8, 7])), None));
        assert_eq!(opaque.get_pixel(0, 0).0, [9, 8, 7, 255]);
    }
}
