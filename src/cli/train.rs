//! `orb train`: a folder of posed photos becomes the Gaussians of a whole scene, measured on photos held out, marked and sealed.

mod around;
mod blocks;
mod ground;
mod parts;
mod plan;
mod poses;
mod store;
mod tiles;
mod told;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use clap::ValueEnum;
use glam::Vec3;
use sha2::{Digest, Sha256};

use super::bar::{Bar, Say};
use super::checkpoint::CheckpointArgs;
use super::device::Device;
use super::format::{OpenStore, TileContent};
use super::geo;
use super::networks::EngineArgs;
use super::photos::{PhotosArgs, Set};
use super::sealed::{Evidence, PublishArgs, SealedRun};
use crate::audit::{DataFolder, record, time};
use crate::export::{self, Labels};
use crate::geo::{HeadingSource, Placement, ScaleSource};
use crate::models::Graph;
use crate::photos::register::{self, Registration};
use crate::photos::{colmap, dataset};
use crate::pipeline::scene::{self, Background, Cost, Scene, Sky, Source, Strategy};
use crate::progress::Progress;
use crate::{Error, Result, memory, splat};
use ground::Ground;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum StrategyName {
    /// Clone, split and prune (Kerbl et al. 2023)
    #[default]
    Default,
    /// Move the dead and add a few up to the cap (Kheradmand et al. 2024)
    Mcmc,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum SkyName {
    /// Where the photos show one
    #[default]
    Auto,
    On,
    Off,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SceneFormat {
    /// Quantised
    Spz,
    /// 3D Tiles in levels of detail, without the sky, of what --tiles says; for photos with a place on the Earth
    Tiles3d,
    /// OGC CDB store: the ground as terrain and imagery, what stands on it as models; for photos with a place on the Earth
    Cdb,
    /// None besides
    Ply,
}

impl SceneFormat {
    fn needs_place(self) -> bool {
        matches!(self, SceneFormat::Tiles3d | SceneFormat::Cdb)
    }
}

/// Train a scene of Gaussians on a folder of posed photos.
#[derive(Clone, Debug, clap::Args)]
pub struct Train {
    /// The folder: COLMAP's images and sparse/0, Nerfstudio's transforms.json, or NeRF's transforms_train.json.
    pub data: PathBuf,
    #[command(flatten)]
    pub photos: PhotosArgs,
    /// Folder to publish; must not exist yet. Default: the folder's name and _scene.
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub publish: PublishArgs,
    /// Optimisation steps.
    #[arg(long, value_name = "N", default_value_t = 30_000, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub iterations: u32,
    /// How the number of Gaussians is controlled.
    #[arg(long, value_enum, default_value_t)]
    pub strategy: StrategyName,
    /// Never more Gaussians. Default: what the free memory holds; a million with --strategy mcmc, if it holds that.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(100..=100_000_000))]
    pub max_gaussians: Option<u32>,
    /// Gaussians to begin with at random places, where there are no points.
    #[arg(long, value_name = "N", default_value_t = 100_000, value_parser = clap::value_parser!(u32).range(100..=10_000_000))]
    pub init_points: u32,
    /// Every so-many-th photo by name is held out and measured; 0: none. A layout's own test photos go before.
    #[arg(long, value_name = "N", default_value_t = dataset::EVERY as u32)]
    pub test_every: u32,
    /// Longer side of the photos in training, pixels; larger ones are made smaller.
    #[arg(long, value_name = "PIXELS", default_value_t = 1600, value_parser = clap::value_parser!(u32).range(16..=16_384))]
    pub size: u32,
    /// Folder of masks by the photos' names, black where a photo is not to be looked at. Default: `masks` beside the photos.
    #[arg(long, value_name = "DIR")]
    pub masks: Option<PathBuf>,
    /// Learn each photo's exposure: an affine change of its colours.
    #[arg(long)]
    pub exposure: bool,
    /// What stands behind everything: auto (white where photos have alpha, else black), black, white, R,G,B of 0 to 1, or
    /// random: another at every step, so that the Gaussians learn the photos' alpha.
    #[arg(long, value_name = "COLOUR", default_value = "auto", value_parser = background)]
    pub background: Background,
    /// Whether far Gaussians stand for the sky.
    #[arg(long, value_enum, default_value_t)]
    pub sky: SkyName,
    /// Also publish ground.ply and objects.ply: the Gaussians of the ground, and those of what stands on it.
    #[arg(long)]
    pub split_ground: bool,
    /// Of what stands on the ground, make at most so many models in a CDB store, largest first; what none is made of stays in the
    /// imagery.
    #[arg(long, value_name = "N", default_value_t = 32, value_parser = clap::value_parser!(u32).range(..=10_000))]
    pub models: u32,
    /// Add terrain, imagery and models to this existing CDB store, in place of a new store in the published folder; with
    /// --format cdb.
    #[arg(long, value_name = "STORE")]
    pub cdb: Option<PathBuf>,
    #[command(flatten)]
    pub around: around::AroundArgs,
    /// What 3D Tiles hold, separated by commas: the Gaussians in tiles3d, textured meshes of the whole scene in tiles3d-mesh.
    #[arg(long, value_delimiter = ',', value_enum, default_value = "splats")]
    pub tiles: Vec<TileContent>,
    /// Distance of the samples that the meshes of --tiles mesh are made from, metres. Default: two of the photos' pixels on the
    /// ground, more where the scene is less sure.
    #[arg(long, value_name = "METRES", value_parser = metres)]
    pub mesh_sample: Option<f64>,
    /// With --refine-poses: where photos have too few points in common, refine poses by the photos alone without trying first whether
    /// that gains anything.
    #[arg(long, requires = "refine_poses")]
    pub refine_untried: bool,
    /// Measure photos held out a second time, their poses fitted to the finished Gaussians; with --refine-poses always.
    #[arg(long)]
    pub fit_held_out: bool,
    /// LPIPS as ONNX, to measure that too: inputs `ref` and `dist`, 1×3×H×W, normalised as for ImageNet; output the distance.
    #[arg(long, value_name = "FILE.onnx")]
    pub lpips: Option<PathBuf>,
    /// Formats to publish beside scene.ply, preview.png and the record, separated by commas.
    #[arg(long, value_delimiter = ',', value_enum, default_value = "spz")]
    pub format: Vec<SceneFormat>,
    #[arg(long, value_enum, default_value_t)]
    pub device: Device,
    /// Same photos, options, seed and machine: same bytes.
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
    #[command(flatten)]
    pub large: blocks::BlocksArgs,
    #[command(flatten)]
    pub kept: CheckpointArgs,
    #[command(flatten)]
    pub engine: EngineArgs,
    /// One JSON object on standard output.
    #[arg(long)]
    pub json: bool,
    /// How progress is said on standard error.
    #[arg(long, value_enum, default_value = "bar")]
    pub progress: Say,
}

fn background(text: &str) -> std::result::Result<Background, String> {
    match text {
        "auto" => Ok(Background::Auto),
        "black" => Ok(Background::Color([0.0; 3])),
        "white" => Ok(Background::Color([1.0; 3])),
        "random" => Ok(Background::Changing),
        other => {
            let parts: Vec<f32> = other.split(',').filter_map(|p| p.trim().parse().ok()).collect();
            match <[f32; 3]>::try_from(parts) {
                Ok(c) if c.iter().all(|v| (0.0..=1.0).contains(v)) => Ok(Background::Color(c)),
                _ => Err("expected auto, black, white, random, or three numbers of 0 to 1 such as 0.5,0.5,0.5".into()),
            }
        }
    }
}

fn metres(text: &str) -> std::result::Result<f64, String> {
    let number = text.parse().ok().filter(|v: &f64| v.is_finite() && *v > 0.0);
    number.ok_or_else(|| "expected a length in metres above 0, such as 0.1".into())
}

/// A measure's network.
struct Network {
    graph: Box<dyn Graph>,
    sha256: String,
    size: u64,
    engine: String,
}

impl Network {
    fn open(args: &Train) -> Result<Option<Network>> {
        let Some(file) = &args.lpips else { return Ok(None) };
        let data = DataFolder::from_environment(|name| std::env::var_os(name))?;
        let bytes = std::fs::read(file).map_err(|e| Error::io(file, &e))?;
        let engine = args.engine.open(&data, &mut |_| {})?;
        let sha256 = hex::encode(Sha256::digest(&bytes));
        let graph = engine.load(&bytes)?;
        Ok(Some(Network { graph, sha256, size: bytes.len() as u64, engine: engine.name().to_owned() }))
    }
}

/// A scene on the Earth: metres, +Y at the heading.
pub struct Placed {
    pub registration: Registration,
    pub placement: Placement,
    /// Metres a unit.
    pub scale: f32,
    /// The origin in the unit frame.
    pub base: Vec3,
}

/// Runs the verb. `stop` is set by the interrupt handler.
///
/// # Errors
/// Usage for photos, poses, masks and options that cannot be used; policy for markings; as [`scene::fit`].
pub fn run(args: &Train, stop: &AtomicBool) -> Result<u8> {
    let started = Instant::now();
    if let Some(store) = &args.cdb {
        if !args.format.contains(&SceneFormat::Cdb) {
            return Err(Error::usage("--cdb").expected("--format cdb, which writes a store").found("other formats"));
        }
        // A folder that is none is refused now, not after training; nobody is kept from it meanwhile.
        OpenStore::open(store)?;
    }
    let around = args.around.open(args.format.contains(&SceneFormat::Cdb))?;
    let mut set = Set::open(&args.data, &args.photos, args.masks.as_deref())?;
    let kept = args.kept.open()?;
    let network = Network::open(args)?;
    let stem = geo::stem_of(&args.data);
    let output = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{stem}_scene")));
    let standing = args.large.standing(&output)?;
    for words in standing.iter().filter_map(|p| p.doubt.as_ref()) {
        eprintln!("orb: warning: {words}");
    }
    let mut carried: Vec<_> = set.carried().to_vec();
    carried.extend(standing.iter().map(|p| p.marking.clone()));
    carried.extend(around.iter().map(around::Around::carried).collect::<Result<Vec<_>>>()?);
    let handling = args.publish.marking.decide(&carried, &time::now()?.utc())?;
    let product = handling.marking.clone();
    // A plan publishes nothing; a block of several has its record where it is kept.
    let (sealed, sealing) = match args.large.block {
        _ if args.large.plan => (None, None),
        None => (Some(SealedRun::begin("orb train", &output, handling, &args.publish)?), None),
        Some(i) => {
            let folder = args.large.folder(&output);
            (None, Some(parts::Sealing::begin(args, &folder, i as usize - 1, &standing, &handling)?))
        }
    };
    let say = |line: &str| {
        if !args.publish.quiet {
            eprintln!("orb: {line}");
        }
    };
    let gpu = args.device.open_quietly(&mut |line| say(line))?;
    let fitter = gpu.as_ref().map_or(splat::Engine::Cpu, splat::Engine::Gpu);
    let bar = Bar::saying(args.progress, stop, args.publish.quiet);
    set.pose(&bar)?;
    let fixes = set.fixes()?;
    let held_out = set.held_out(args.test_every as usize)?;
    let cost = Cost {
        photos: set.poses()?.photos.len(),
        pixels: set.pixels(args.size)?,
        on_gpu: gpu.is_some(),
        free: memory::available(),
    };
    let strategy = match args.strategy {
        StrategyName::Default => Strategy::Paper,
        StrategyName::Mcmc => Strategy::Mcmc,
    };
    let most = match args.max_gaussians {
        Some(n) => n as usize,
        None if strategy == Strategy::Mcmc => cost.cap().min(scene::cost::MCMC),
        None => cost.cap(),
    };
    if args.large.plan {
        return plan::said(args, &set, &held_out, &cost, most, fitter);
    }
    say(&cost.words(most));
    let options = scene::Options {
        iterations: args.iterations as usize,
        strategy,
        max_gaussians: most,
        longest_side: args.size,
        random_points: args.init_points as usize,
        exposure: args.exposure,
        refine_poses: args.photos.refine_poses,
        refine_untried: args.refine_untried,
        fit_held_out: args.fit_held_out,
        background: args.background,
        sky: match args.sky {
            SkyName::Auto => Sky::Auto,
            SkyName::On => Sky::On,
            SkyName::Off => Sky::Off,
        },
        up: Set::up(&fixes, args.seed),
        seed: args.seed,
        kept,
    };
    let photos = &set.poses()?.photos;
    if let Some(format) = args.format.iter().find(|f| f.needs_place()).and_then(ValueEnum::to_possible_value) {
        let (to_unit, ..) = scene::unit_frame(set.poses()?, options.up, args.seed)?;
        let placed = register::register(&fixes, &to_unit, args.seed).ok_or_else(|| {
            Error::usage(format!("--format {}", format.get_name()))
                .expected("photos that know their place on the Earth: three with GPS, or --gcp")
                .found("none that say it")
        })?;
        around.iter().try_for_each(|a| a.check(placed.place(glam::DVec3::ZERO)))?;
    }
    let source = Source {
        poses: set.poses()?,
        held_out: &held_out,
        open: &|posed| set.photo(posed),
        mask: &|i| set.mask(&photos[i]),
    };
    let lpips = network.as_ref().map(|n| &*n.graph);
    let cut = args.large.open(&set, &options, &held_out, &output)?;
    let done = match &cut {
        None => Some(scene::fit(&source, fitter, &options, lpips, &bar)?),
        Some(blocks) => {
            let mut tell = |line: String| say(&line);
            let (done, made) = scene::blocks::fit(&source, fitter, &options, blocks, lpips, &bar, &mut tell)?;
            let parts = blocks.folder.display();
            say(&format!("{} parts trained, {} found in {parts}", made.trained, made.found));
            done
        }
    };
    if let (Some(sealing), Some(cut)) = (sealing, &cut) {
        for folder in sealing.seal(args, &set, &options, cut, &fitter.name())? {
            say(&format!("sealed {}", folder.display()));
        }
    }
    let (Some(done), Some(mut sealed)) = (done, sealed) else { return Ok(0) };

    if let Some(r) = done.refining.as_ref().filter(|r| !r.moved()) {
        eprintln!("orb: warning: --refine-poses: {}", r.words());
    }
    bar.begin("writing and sealing", 0);
    let placed = register::register(&fixes, &done.to_unit, args.seed).map(|r| placed(r, &done));
    if let Some(words) = placed.as_ref().and_then(|p| p.registration.contradiction(&fixes)) {
        eprintln!("orb: warning: {words}");
    }
    let reading = time::now()?;
    let labels = Labels {
        stem: "scene".into(),
        marking: product.clone(),
        utc: reading.utc(),
        heading_source: HeadingSource::Georegistration.label(),
        scale_source: ScaleSource::Georegistration.label(),
    };
    let ply = |g: &splat::Gaussians| match &placed {
        Some(p) => export::scene_ply(&p.gaussians(g), &p.placement, &labels),
        None => export::posed_ply(g, &done.to_unit, &product),
    };
    let whole = ply(&done.gaussians)?;
    sealed.publication.add(&whole.path, &whole.bytes, whole.media_type, "gaussians")?;
    let tiled = |content| args.format.contains(&SceneFormat::Tiles3d) && args.tiles.contains(&content);
    let for_ground = [
        (args.split_ground, "--split-ground"),
        (args.format.contains(&SceneFormat::Cdb), "--format cdb"),
        (tiled(TileContent::Mesh), "--tiles mesh"),
    ];
    let asked = for_ground.iter().find(|(asked, _)| *asked);
    let ground = asked.map(|(_, option)| Ground::of(&done, option)).transpose()?;
    if let (true, Some(ground)) = (args.split_ground, &ground) {
        for (name, g) in ground_and_objects(&done, ground) {
            let file = ply(&g)?;
            sealed.publication.add(name, &file.bytes, file.media_type, "gaussians")?;
        }
    }
    let in_metres = placed.as_ref().map(|p| p.gaussians(&done.gaussians));
    if args.format.contains(&SceneFormat::Spz) {
        let g = in_metres.as_ref().unwrap_or(&done.gaussians);
        let spz = export::spz(g, &labels, orb_formats::spz::Version::V3)?;
        sealed.publication.add(&spz.path, &spz.bytes, spz.media_type, "gaussians")?;
    }
    if let (true, Some(p), Some(g)) = (tiled(TileContent::Splats), &placed, &in_metres) {
        let near = g.filtered(|i| i < g.len() - done.sky);
        for file in export::splat_tree(&near, export::TILE_OF_SPLATS, &p.placement, &labels)? {
            sealed.publication.add(&file.path, &file.bytes, file.media_type, "gaussians")?;
        }
    }
    if let Some(refined) = &done.refined {
        for (name, text) in colmap::written(set.poses()?, &refined.poses, &refined.points) {
            sealed.publication.add(&format!("sparse/0/{name}"), text.as_bytes(), "text/plain", "poses")?;
        }
    }
    let stored = match placed.as_ref().zip(ground.as_ref()) {
        Some((p, ground)) if args.format.contains(&SceneFormat::Cdb) => {
            let (most, into, around) = (args.models as usize, args.cdb.as_deref(), around.as_ref());
            let how = store::How { most, into, around, progress: &bar, say: &say };
            Some(store::publish(&done, ground, p, &labels, &mut sealed.publication, &how)?)
        }
        _ => None,
    };
    let meshed = match placed.as_ref().zip(ground.as_ref()) {
        Some((p, ground)) if tiled(TileContent::Mesh) => {
            Some(tiles::publish(&done, ground, p, &labels, &mut sealed.publication, args.mesh_sample, &bar)?)
        }
        _ => None,
    };
    let preview = export::scene_png(&done, &product)?;
    sealed.publication.add("preview.png", &preview, "image/png", "preview")?;
    bar.check()?;
    let measure = network.as_ref().map(|n| record::model("lpips", "", &n.sha256, n.size, &n.engine));
    let beside = standing.iter().flat_map(|p| &p.inputs).chain(around.iter().map(|a| &a.input));
    let inputs = set.inputs().iter().chain(beside);
    let published = sealed.seal(Evidence {
        event_type: "scene.train",
        time: reading,
        inputs: inputs.cloned().collect(),
        models: told::models(&done.report.device, set.colmap()).into_iter().chain(measure).collect(),
        params: told::params(args, &options, &set, &done, placed.as_ref())
            .into_iter()
            .chain(cut.iter().flat_map(parts::of_run))
            .chain(cut.iter().flat_map(|_| parts::verified(&standing)))
            .chain(stored.iter().flat_map(store::Stored::params))
            .chain(meshed.iter().flat_map(tiles::Tiled::params))
            .collect(),
    })?;
    bar.finish();
    let told = told::Told {
        args,
        set: &set,
        options: &options,
        cost: &cost,
        done: &done,
        placed: placed.as_ref(),
        stored: stored.as_ref(),
        tiled: meshed.as_ref(),
        published: &published,
        banner: product.banner(),
        seconds: started.elapsed().as_secs_f64(),
    };
    match (args.json, args.publish.quiet) {
        (true, _) => super::write_out(&(told.json() + "\n")),
        (false, true) => {}
        (false, false) => super::write_out(&told.text()),
    }
    Ok(0)
}

/// The ground's Gaussians and those of what stands on it, in the unit frame, without the sky.
fn ground_and_objects(done: &Scene, ground: &Ground) -> [(&'static str, splat::Gaussians); 2] {
    let of = |wanted: bool| done.gaussians.filtered(|i| i < ground.near && ground.is_ground[i] == wanted);
    [("ground.ply", of(true)), ("objects.ply", of(false))]
}

impl Placed {
    pub fn gaussians(&self, g: &splat::Gaussians) -> splat::Gaussians {
        g.transformed(glam::Mat3::IDENTITY, self.scale, -self.scale * self.base)
    }
}

/// The origin lies on the ground below what the photos look at; without a ground, there itself.
fn placed(registration: Registration, done: &Scene) -> Placed {
    let ground = done.ground.as_ref().map(|g| {
        let on_it = done.to_unit.apply(g.normal * g.height);
        on_it.z as f32
    });
    let base = Vec3::new(0.0, 0.0, ground.unwrap_or(0.0));
    let placement = Placement {
        origin: registration.place(base.as_dvec3()),
        heading: registration.heading(),
        heading_source: HeadingSource::Georegistration,
    };
    Placed { scale: registration.to_enu.scale as f32, registration, placement, base }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn backgrounds_are_named_or_numbers() {
        assert_eq!(background("white"), Ok(Background::Color([1.0; 3])));
        assert_eq!(background("0.1, 0.2,0.3"), Ok(Background::Color([0.1, 0.2, 0.3])));
        assert_eq!(background("random"), Ok(Background::Changing));
        for wrong in ["", "0.1,0.2", "0.1,0.2,1.3", "1,1,1,1", "green", "NaN,0,0"] {
            assert!(background(wrong).is_err(), "{wrong}");
        }
    }
}
