//! The stages in order: photo (or [`several`]) → subject → Gaussians → six views → optimisation → mesh → place → files.
//!
//! Values in, values out; nothing here touches a disk, but for the checkpoint that the user asks for.

pub mod confidence;
pub mod held;
mod optimise;
pub mod scene;
pub mod settled;
pub mod several;
pub mod unposed;

use std::time::{Duration, Instant};

use image::GrayImage;
use optimise::{Shot, optimise, photo};

use crate::mesh::{self, Level, Model};
use crate::models::scene::Subject;
use crate::models::splat_prior::{self, OneView, Window};
use crate::models::{self, Engine, prior};
use crate::photo::Photo;
use crate::photos::crops::Crop;
use crate::progress::Progress;
use crate::sources::{self, Sources};
use crate::splat::train::Kept;
use crate::splat::{self, Camera, Frame, Gaussians, Report, Target};
use crate::symmetry::{self, Completed, Found, MirroredPhoto, Use};
use crate::{Result, memory, views};

/// Pixels across each of the six views.
const VIEW_SIZE: u32 = 256;
/// Names of the optimisation's targets in its report.
pub const PHOTO: &str = "photo";
pub const MIRRORED: &str = "mirrored photo";
pub const VIEW: &str = "view";
pub const NORMALS: &str = "normals";
pub const HELD_BACK: &str = "held back";

const GREY: [f32; 3] = [0.5; 3];

/// What decides a reconstruction, besides the photo.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Optimisation steps.
    pub iterations: u32,
    /// Fewer steps where this machine, by a short trial, would need longer for them. `None`: all of them.
    pub optimise_within: Option<Duration>,
    /// The optimisation ends early past this point, and says so.
    pub deadline: Option<Instant>,
    pub seed: u64,
    /// How far the camera looked up, degrees above the horizon, where somebody says it.
    pub pitch: Option<f64>,
    pub symmetry: Use,
    /// 1 to 4.
    pub levels: usize,
    /// Most triangles of the finest level.
    pub triangles: Option<usize>,
    /// Whether the finest level has no more vertices than the chain of a CDB model takes, however many triangles are asked for.
    pub in_store: bool,
    /// Width and height of the finest level's texture: a power of two.
    pub texture: u32,
    /// Whether every level gets a normal map, and an ambient occlusion map.
    pub normal_map: bool,
    pub occlusion: bool,
    /// How the optimisation is kept in a file, and what it goes on from.
    pub kept: Kept,
}

/// What a stage took.
#[derive(Clone, Copy, Debug)]
pub struct Timing {
    pub stage: &'static str,
    pub time: Duration,
    /// Highest resident memory in it, bytes, where the system says.
    pub memory: Option<u64>,
}

/// Everything that came of one photo, in the unit frame (subject's bounding sphere of radius 1, Z up).
pub struct Reconstruction {
    pub subject: Subject,
    pub prior: OneView,
    /// At most two planes, the best first.
    pub symmetry: Vec<Found>,
    pub six: Vec<(Camera, Frame)>,
    pub gaussians: Gaussians,
    /// Of the optimisation that the mesh was made after.
    pub report: Report,
    /// Of the short one after it, on pictures of the model, where there was one.
    pub settled: Option<Report>,
    pub model: Model,
    /// Where the network says it.
    pub expected_error: Option<ExpectedError>,
    pub timings: Vec<Timing>,
    /// What took the built-in networks' place.
    pub sources: sources::Outcome,
    /// Where there was more than one photo.
    pub several: Option<several::Several>,
}

/// How far the network expected the colours of its own Gaussians to be off, sRGB 0..1; not how far the model's are, which
/// has the photo's pixels where the photo shows it.
pub struct ExpectedError {
    /// By the finest level's texture coordinates.
    pub texture: GrayImage,
    /// Over what the six views show.
    pub mean: f32,
}

/// What stages 2 to 4 make of one photo, in the unit frame.
pub struct Fitted {
    pub subject: Subject,
    pub prior: OneView,
    /// At most two planes, the best first.
    pub symmetry: Vec<Found>,
    pub six: Vec<(Camera, Frame)>,
    pub gaussians: Gaussians,
    pub report: Report,
    /// The mean colour error, sRGB 0..1, that the network expected of what the six views show; where it says so.
    pub expected_error: Option<f32>,
    /// What took the built-in networks' place.
    pub sources: sources::Outcome,
    /// One a target: the photo's, then those of the mirrored photos.
    cameras: Vec<Camera>,
    mirrored: Vec<MirroredPhoto>,
    /// Of several photos those that colour comes from, and their cameras.
    painting: Vec<(Camera, Crop)>,
    /// Where there was more than one photo.
    pub several: Option<several::Several>,
    clock: Clock,
}

impl Fitted {
    pub fn timings(&self) -> &[Timing] {
        &self.clock.timings
    }

    /// The expected IoU of a single photo's mask, where it is doubtful.
    pub fn doubtful_mask(&self) -> Option<f32> {
        self.subject.expected_iou.filter(|iou| self.several.is_none() && *iou < models::scene::DOUBTFUL)
    }
}

/// Stages 2 to 5. `sources` says what takes the place of the built-in networks, which run on `engine`; `fitter` is where
/// the Gaussians are optimised.
///
/// # Errors
/// `Usage` for a photo without a subject, `Cancelled`.
pub fn reconstruct(
    photo: &Photo,
    engine: &dyn Engine,
    sources: &Sources,
    fitter: splat::Engine,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Reconstruction> {
    finish(fit(photo, engine, sources, fitter, settings, progress)?, fitter, settings, progress)
}

/// Stage 5: the mesh, which the Gaussians of a single photo then settle on.
///
/// # Errors
/// As [`reconstruct`].
pub fn finish(
    mut fitted: Fitted,
    fitter: splat::Engine,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Reconstruction> {
    let Fitted { gaussians, prior, mirrored, cameras, painting, .. } = &fitted;
    let view = |camera, color, mask| mesh::PhotoView { mirrored: false, camera, color, mask };
    let mut photos: Vec<mesh::PhotoView> = match painting.is_empty() {
        true => vec![view(cameras[0], &prior.colour, &prior.mask.data)],
        false => painting.iter().map(|(camera, crop)| view(*camera, &crop.colour, &crop.mask.data)).collect(),
    };
    photos.extend(mirrored.iter().zip(cameras.iter().skip(1)).map(|(m, camera)| mesh::PhotoView {
        mirrored: true,
        camera: *camera,
        color: &m.color,
        mask: &m.mask,
    }));
    // Of several photos others may show what one cuts off.
    let cut_off_below = painting.is_empty() && fitted.subject.cut_off_below();
    let model = meshed(gaussians, &photos, cut_off_below, settings, progress)?;
    let expected_error = match (&fitted.prior.expected_errors, fitted.expected_error) {
        (Some(errors), Some(mean)) => {
            let texture = expected_texture(&fitted.prior.gaussians, errors, &model.levels[0], progress)?;
            Some(ExpectedError { texture, mean })
        }
        _ => None,
    };
    fitted.clock.lap("mesh and texture");
    let mut settled = None;
    let options = splat::Options { seed: settings.seed, ..settled::options(fitted.report.iterations) };
    // Several photos show more sides themselves. All its steps or none, so that two runs are alike.
    if fitted.painting.is_empty() && options.iterations > 0 && !fitted.report.stopped_by_deadline {
        let photo = Target { refine_pose: None, ..photo(&fitted.prior, fitted.cameras[0], settings.seed) };
        let gaussians = std::mem::take(&mut fitted.gaussians);
        let trained = settled::settle(gaussians, photo, &model.levels[0], fitter, &options, progress)?;
        (fitted.gaussians, settled) = (trained.gaussians, Some(trained.report));
        fitted.clock.lap("settling");
    }
    Ok(Reconstruction {
        subject: fitted.subject,
        symmetry: fitted.symmetry,
        six: fitted.six,
        gaussians: fitted.gaussians,
        report: fitted.report,
        settled,
        model,
        expected_error,
        timings: fitted.clock.timings,
        prior: fitted.prior,
        sources: fitted.sources,
        several: fitted.several,
    })
}

/// The textured model.
fn meshed(
    gaussians: &Gaussians,
    photos: &[mesh::PhotoView],
    cut_off_below: bool,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Model> {
    let drawers = splat::render::Drawers::with_surface(gaussians, mesh::FIRM);
    let render = |camera: &Camera| mesh::View::drawn(&drawers, camera, GREY);
    let sized = mesh::Options::sized(settings.triangles, settings.texture);
    let vertex_caps = if settings.in_store { mesh::Options::default().vertex_caps } else { sized.vertex_caps };
    let options = mesh::Options {
        levels: settings.levels,
        vertex_caps,
        cut_off_below,
        normal_map: settings.normal_map,
        occlusion: settings.occlusion,
        background: GREY,
        ..sized
    };
    mesh::build(&render, photos, &options, progress)
}

/// Expected errors of Gaussians on the model.
fn expected_texture(g: &Gaussians, errors: &[f32], finest: &Level, progress: &dyn Progress) -> Result<GrayImage> {
    progress.begin("expected error", 0);
    let drawers = splat::render::Drawers::with_surface(&confidence::as_greys(g, errors), mesh::FIRM);
    let render = |camera: &Camera| mesh::View::drawn(&drawers, camera, [0.0; 3]);
    mesh::expected_error::texture(finest, &render, progress)
}

/// Stages 2 to 4: Gaussians, no mesh.
///
/// # Errors
/// As [`reconstruct`].
pub fn fit(
    photo: &Photo,
    engine: &dyn Engine,
    sources: &Sources,
    fitter: splat::Engine,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Fitted> {
    let mut clock = Clock::new();
    let mut outcome = sources::Outcome::default();
    // Each network is loaded when its turn comes and gone before the next runs.
    progress.begin("mask", 0);
    let mask = sources.mask(photo, &mut outcome, progress)?;
    if mask.is_some() {
        clock.lap("mask");
    }
    progress.begin("mask and depth", 0);
    let cutout = mask.as_ref().or(photo.cutout.as_ref());
    let networks = models::scene::Networks::built_in(engine)?;
    let looked = models::scene::looked(&photo.pixels, cutout, sources.point(), &networks)?;
    // What is left to do with the mask keeps one core busy: another one loads the next network, where no other has its turn before.
    let next = || {
        drop(networks);
        sources.depth.is_none().then(|| prior::SPLAT.loaded(engine))
    };
    let (subject, splat) = rayon::join(|| looked.subject(), next);
    let mut subject = subject?;
    let roll = held::roll(photo, &subject);
    let held = held::held(settings.pitch, photo, Window::around(&subject).middle(), roll);
    let aim = Some(held::aim(photo, held.as_ref(), roll));
    let taken = splat_prior::Taken { elevation: held.map(|h| h.elevation), lens: photo.pinhole(), aim };
    clock.lap("mask and depth");
    progress.check()?;
    progress.begin("depth", 0);
    let mut depth = sources.depth(photo, &subject, &mut outcome)?;
    if depth.is_some() {
        clock.lap("depth");
    }
    progress.check()?;

    progress.begin("3D from one view", 0);
    let splat = splat.unwrap_or_else(|| prior::SPLAT.loaded(engine))?;
    let mut one_view = splat_prior::one_view(&photo.pixels, &subject, &taken, &*splat)?;
    drop(splat);
    // Before the prior's views are drawn; views drawn by others replace its surface, so then after them.
    if let Some(seen) = depth.take_if(|_| sources.views_are_the_priors()) {
        sources::fit_depth(&mut one_view, &mut subject, seen, &mut outcome);
    }
    clock.lap("3D from one view");
    progress.check()?;

    let seen = symmetry::Seen { camera: one_view.camera, color: &one_view.colour, mask: &one_view.mask.data };
    // Views drawn by others show the far side themselves, and stand in another frame than the prior.
    let wanted = match settings.symmetry {
        _ if !sources.views_are_the_priors() => Use::Off,
        Use::Auto if subject.seen_in_part() => Use::Evident,
        asked => asked,
    };
    let found = symmetry::find(&one_view.gaussians, &seen, wanted);
    let Completed { gaussians, origins, photos: mirrored } =
        symmetry::complete(&one_view.gaussians, &seen, &symmetry::used(&found));
    one_view.gaussians = gaussians;
    one_view.expected_errors = one_view.expected_errors.map(|errors| confidence::carried(&errors, &origins));
    clock.lap("symmetry");
    progress.check()?;

    progress.begin("six views", 6);
    let (six, normals) = match sources.six_views(&mut one_view, settings.seed, &mut outcome, progress)? {
        Some(drawn) => (views::tile::framed(&drawn.views, GREY), drawn.normals),
        None => (render_all(&one_view.gaussians, &views::six_views(VIEW_SIZE), progress)?, Vec::new()),
    };
    // Views between the six are the prior's own; where others draw the six there is nothing to hold back.
    if let Some(seen) = depth {
        sources::fit_depth(&mut one_view, &mut subject, seen, &mut outcome);
    }
    let between = match sources.views_are_the_priors() {
        true => render_all(&one_view.gaussians, &views::held_back(VIEW_SIZE), progress)?,
        false => Vec::new(),
    };
    clock.lap("six views");

    // Views drawn by others come without.
    let cameras: Vec<Camera> = six.iter().map(|(camera, _)| *camera).collect();
    let errors = one_view.expected_errors.as_ref();
    let expected = errors.map(|errors| confidence::drawn(&one_view.gaussians, errors, &cameras));
    let views = Shot { six: &six, normals: &normals, between: &between, expected: expected.as_deref() };
    let trained = optimise(fitter, &one_view, &mirrored, &views, settings, progress)?;
    clock.lap("optimisation");

    Ok(Fitted {
        subject,
        symmetry: found,
        six,
        gaussians: trained.gaussians,
        report: trained.report,
        expected_error: expected.as_deref().map(confidence::mean),
        sources: outcome,
        cameras: trained.cameras,
        mirrored,
        prior: one_view,
        painting: Vec::new(),
        several: None,
        clock,
    })
}

fn render_all(g: &Gaussians, cameras: &[Camera], progress: &dyn Progress) -> Result<Vec<(Camera, Frame)>> {
    let mut out = Vec::with_capacity(cameras.len());
    let mut drawer = splat::render::Drawer::new(g);
    for camera in cameras {
        progress.check()?;
        out.push((*camera, drawer.render(camera, GREY)));
        progress.step(out.len() as u64);
    }
    Ok(out)
}

/// Laps of a stopwatch.
struct Clock {
    last: Instant,
    timings: Vec<Timing>,
}

impl Clock {
    fn new() -> Self {
        memory::reset_peak();
        Clock { last: Instant::now(), timings: Vec::new() }
    }

    fn lap(&mut self, stage: &'static str) {
        let now = Instant::now();
        self.timings.push(Timing { stage, time: now - self.last, memory: memory::peak() });
        memory::reset_peak();
        self.last = now;
    }
}
