//! `orb geo`: one photo becomes a placed, marked, sealed model.

pub mod manifest;
pub mod options;
mod place;
pub mod recorded;
mod sidecars;
pub mod tools;

pub use place::Placed;

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use clap::{Args, ValueEnum};

use super::bar::{Bar, Say};
use super::checkpoint::CheckpointArgs;
use super::device::Device;
use super::effort::EffortArgs;
use super::format::{self, Content, Format, WriteArgs, safe_stem};
use super::networks::{self, NetworkArgs};
use super::photos::{Front, PhotosArgs};
use super::sealed::{Evidence, PublishArgs, SealedRun};
use super::summary::{self, Summary};
use crate::audit::{DataFolder, time};
use crate::export::{self, Catalogue, Labels};
use crate::geo::magnetic;
use crate::pipeline::{self, Settings};
use crate::progress::Progress;
use crate::sources::Sources;
use crate::{Error, Result, splat, symmetry};

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Symmetry {
    /// As `evident`; else one plane that nothing speaks against, as of most that is photographed from the side
    Auto,
    /// One plane or two, where the photo shows that the subject meets its mirror image
    Evident,
    /// The best plane, however well it fits
    On,
    /// It and a second one at right angles: the back is made the front's mirror image, as of towers, bunkers and many houses
    Two,
    Off,
}

impl From<Symmetry> for symmetry::Use {
    fn from(choice: Symmetry) -> Self {
        match choice {
            Symmetry::Auto => symmetry::Use::Auto,
            Symmetry::Evident => symmetry::Use::Evident,
            Symmetry::On => symmetry::Use::On,
            Symmetry::Two => symmetry::Use::Two,
            Symmetry::Off => symmetry::Use::Off,
        }
    }
}

/// An option given twice takes its last value, as people expect who add to a command.
#[derive(Args, Clone, Debug)]
#[command(args_override_self = true, subcommand_negates_reqs = true, args_conflicts_with_subcommands = true)]
pub struct GeoArgs {
    #[command(subcommand)]
    pub tool: Option<tools::Tool>,

    /// The photo: JPEG, HEIC, PNG, WebP or TIFF, the subject in the middle; or a folder of photos of one subject.
    #[arg(required_unless_present = "manifest")]
    pub photo: Option<PathBuf>,

    /// Many photos into one store: a CSV file whose first line names its columns (photo, name, origin, heading, length, …).
    #[arg(long, value_name = "FILE", conflicts_with = "photo")]
    pub manifest: Option<PathBuf>,

    #[command(flatten)]
    pub place: options::PlaceArgs,

    #[command(flatten)]
    pub size: options::SizeArgs,

    #[command(flatten)]
    pub photos: PhotosArgs,

    /// Name of the model, in place of the photo's.
    #[arg(skip)]
    pub stem: Option<String>,

    /// Formats to publish, separated by commas; scene.ply, preview.png and the record always are.
    #[arg(long, value_delimiter = ',', value_enum, default_value = "cdb")]
    pub format: Vec<Format>,

    /// Folder to publish; must not exist yet. Default: the photo's name without its extension.
    #[arg(short = 'o', long, value_name = "DIR")]
    pub output: Option<PathBuf>,

    #[command(flatten)]
    pub publish: PublishArgs,

    #[command(flatten)]
    pub write: WriteArgs,

    #[command(flatten)]
    pub effort: EffortArgs,

    #[arg(long, value_enum, default_value = "auto")]
    pub device: Device,

    /// Same photo, options, seed and machine: same bytes.
    #[arg(long, default_value_t = 0)]
    pub seed: u64,

    /// Which planes of symmetry give the unseen side from the seen one.
    #[arg(long, value_enum, default_value = "auto")]
    pub symmetry: Symmetry,

    /// The time that files carry, such as 2026-01-31T12:00:00.000Z, in place of now: the same bytes at another time. The record
    /// says when the run was.
    #[arg(long, value_name = "UTC", value_parser = utc)]
    pub as_of: Option<String>,

    /// Levels of detail, 1 to 4. A CDB store gets four whatever is said here: its coarsest must have 128 vertices at most.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u8).range(1..=4))]
    pub lods: u8,

    /// Most triangles of the finest level. Default: what 8,192 vertices hold, more than which a CDB model's finest never has.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(64..=200_000))]
    pub triangles: Option<u32>,

    /// Width and height of the finest level's texture: 256, 512, 1024 or 2048; each coarser level has half.
    #[arg(long, value_name = "PIXELS", default_value = "1024", value_parser = texture_size)]
    pub texture: u32,

    /// Give GLB, USDZ and 3D Tiles a normal map of the surface before simplification.
    #[arg(long)]
    pub normal_map: bool,

    /// Give GLB, USDZ and 3D Tiles an ambient occlusion map.
    #[arg(long)]
    pub ao: bool,

    /// Also publish what the stages handed on: mask.png and network.ply, the Gaussians before the optimisation.
    #[arg(long)]
    pub stages: bool,

    #[command(flatten)]
    pub networks: NetworkArgs,

    #[command(flatten)]
    pub kept: CheckpointArgs,

    /// One JSON object on standard output.
    #[arg(long)]
    pub json: bool,

    /// How progress is said on standard error.
    #[arg(long, value_enum, default_value = "bar")]
    pub progress: Say,

    /// Stop, as Ctrl-C does, when standard input ends: a program that started this run may be killed at any time.
    #[arg(long, hide = true)]
    pub stop_with_stdin: bool,

    /// Memory stage by stage, the engine, and what the networks said.
    #[arg(short, long, conflicts_with = "quiet")]
    pub verbose: bool,
}

/// Arguments that need no photo to be judged.
struct Plan {
    wanted: options::Wanted,
    catalogue: Catalogue,
    photo: PathBuf,
    stem: String,
    output: PathBuf,
}

fn plan(args: &GeoArgs) -> Result<Plan> {
    let photo = args.photo.clone().ok_or_else(|| Error::usage("photo").expected("a file").found("none"))?;
    let catalogue = args.write.catalogue()?;
    let stem = args.stem.clone().unwrap_or_else(|| stem_of(&photo));
    let output = args.output.clone().unwrap_or_else(|| default_output(&photo, &stem));
    Ok(Plan { wanted: options::wanted(&args.place, &args.size)?, catalogue, photo, stem, output })
}

/// Of a photo its name; of a folder its own, or of the folder that `images` lies in.
pub(super) fn stem_of(path: &Path) -> String {
    let whole = if path.is_dir() { path.canonicalize().unwrap_or_else(|_| path.to_owned()) } else { path.to_owned() };
    let plain = |p: &Path| p.file_name().is_some_and(|n| n == "images" || n == "photos");
    match whole.parent() {
        Some(above) if path.is_dir() && plain(&whole) => safe_stem(above),
        _ => safe_stem(&whole),
    }
}

/// The folder of photos has the model's name already.
pub(super) fn default_output(path: &Path, stem: &str) -> PathBuf {
    PathBuf::from(if path.is_dir() { format!("{stem}_model") } else { stem.to_owned() })
}

fn utc(text: &str) -> std::result::Result<String, String> {
    time::parse_utc(text).map(|_| text.to_owned()).ok_or_else(|| "expected a time as 2026-01-31T12:00:00.000Z".into())
}

fn texture_size(text: &str) -> std::result::Result<u32, String> {
    match text.parse() {
        Ok(size) if [256, 512, 1024, 2048].contains(&size) => Ok(size),
        _ => Err("expected 256, 512, 1024 or 2048".into()),
    }
}

/// Runs the verb. `stop` is set by the interrupt handler.
pub fn run(args: &GeoArgs, stop: &AtomicBool) -> Result<u8> {
    match (&args.tool, &args.manifest) {
        (Some(tool), _) => {
            crate::cli::write_out(&tools::run(tool, decimal_year(&time::now()?.utc()))?);
            Ok(0)
        }
        (None, Some(_)) if args.kept.checkpoint.is_some() || args.kept.resume.is_some() => {
            Err(Error::usage("--manifest")
                .expected("no --checkpoint and no --resume")
                .found("one file for many photos"))
        }
        (None, Some(manifest)) => manifest::run(args, manifest, stop),
        (None, None) => publish_one(args, stop, None),
    }
}

fn decimal_year(utc: &str) -> f64 {
    let part = |range: std::ops::Range<usize>| utc.get(range).and_then(|t| t.parse().ok()).unwrap_or(0);
    magnetic::decimal_year(part(0..4), part(5..7), part(8..10)).unwrap_or(2025.0)
}

/// One photo into one folder. `line` is the key of a manifest's line, for the record.
fn publish_one(args: &GeoArgs, stop: &AtomicBool, line: Option<&str>) -> Result<u8> {
    let started = Instant::now();
    let mut plan = plan(args)?;
    let mut front = Front::open(&plan.photo, &args.photos)?;
    let several = front.one().is_none();
    if several {
        args.networks.check_built_in()?;
    }
    let by_control = plan.wanted.origin.is_none() && front.has_control();
    if !by_control {
        plan.wanted.check(front.exif())?;
    }
    // The terrain that the model stands on lies under it in the store too.
    let mut ground_args = args.write.ground.clone();
    let mut datum = None;
    if ground_args.ground && ground_args.ground_dem.is_none() {
        ground_args.ground_dem.clone_from(&args.place.dem);
        datum = args.place.dem_datum.map(options::DemDatum::plain);
    }
    let ground = ground_args.open(args.format.contains(&Format::Cdb), datum)?;
    let ground_carried = ground.as_ref().map_or(Ok(Vec::new()), |g| g.carried())?;
    let ground_inputs = ground.as_ref().map_or(Vec::new(), |g| g.inputs.clone());
    let inputs =
        [front.carried().to_vec(), plan.wanted.terrain_marking()?, networks::carried(&args.networks)?, ground_carried]
            .concat();
    let handling = args.publish.marking.decide(&inputs, &time::now()?.utc())?;
    let product = handling.marking.clone();

    let mut run = SealedRun::begin("orb geo", &plan.output, handling, &args.publish)?;
    let target = args.write.target(&plan.output, &plan.stem)?;

    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut say = |line: &str| {
        if !args.publish.quiet {
            eprintln!("orb: {line}");
        }
    };
    let gpu = args.device.open_quietly(&mut say)?;
    let fitter = gpu.as_ref().map_or(splat::Engine::Cpu, splat::Engine::Gpu);
    let limits = args.effort.limits(started);
    let settings = Settings {
        iterations: args.effort.steps(several, threads, gpu.is_some()),
        optimise_within: limits.map(|l| l.optimise),
        deadline: limits.map(|l| l.deadline),
        seed: args.seed,
        pitch: args.photos.pitch,
        levels: Format::levels_made(&args.format, args.lods.into()),
        triangles: args.triangles.map(|t| t as usize),
        in_store: args.format.contains(&Format::Cdb),
        texture: args.texture,
        normal_map: args.normal_map,
        occlusion: args.ao,
        symmetry: args.symmetry.into(),
        kept: args.kept.open()?,
    };
    let bar = Bar::saying(args.progress, stop, args.publish.quiet || args.json);
    let data = DataFolder::from_environment(|name| std::env::var_os(name))?;
    front.pose(&args.photos, &bar)?;
    let chosen = match front.one() {
        Some(photo) => networks::choose(&args.networks, photo, args.seed, &data, &mut say)?,
        None => networks::Chosen { sources: Sources::default(), inputs: Vec::new() },
    };
    let fixes = front.fixes(plan.wanted.datum)?;
    if by_control {
        plan.wanted.check_control(&fixes, args.seed)?;
    }
    let (photo, fitted) = front.fit(&chosen.sources, &args.photos, &fixes, fitter, &settings, &bar)?;
    if let Some(iou) = fitted.doubtful_mask() {
        eprintln!(
            "orb: warning: the mask is doubtful: by the network's own probabilities an IoU of {iou:.2} with the subject is to be \
             expected. Look at preview.png; a photo with less around the subject, a point on it (--point x,y) or a photo cut \
             out around it helps."
        );
    }
    let mut done = pipeline::finish(fitted, fitter, &settings, &bar)?;
    bar.begin("writing and sealing", 0);

    let writing = Instant::now();
    let reading = time::now()?;
    let utc = args.as_of.clone().unwrap_or_else(|| reading.utc());
    let placed = place::place(plan.wanted, &photo, &mut done, &fixes, args.seed, decimal_year(&utc))?;
    let (placement, scale, to_metres) = (&placed.placement, &placed.scale, &placed.to_metres);
    placed.warnings.iter().for_each(|w| eprintln!("orb: warning: {w}"));
    let labels = Labels {
        stem: plan.stem.clone(),
        marking: product.clone(),
        utc,
        heading_source: placement.heading_source.label(),
        scale_source: scale.source.label(),
    };

    let scene = export::gaussians_ply("scene.ply", &done.gaussians, to_metres, placement, &labels)?;
    run.publication.add(&scene.path, &scene.bytes, scene.media_type, "gaussians")?;
    if args.stages {
        for file in export::stage_files(&done, to_metres, placement, &labels)? {
            run.publication.add(&file.path, &file.bytes, file.media_type, "stage")?;
        }
    }
    let levels = to_metres.levels(&done.model.levels);
    let gaussians = to_metres.gaussians(&done.gaussians);
    let content = Content {
        levels: &levels,
        shown: args.lods.into(),
        gaussians: Some(&gaussians),
        placement,
        labels: &labels,
        catalogue: &plan.catalogue,
        spz: args.write.spz_version.into(),
        flt_geometry: args.write.flt_geometry.into(),
        usdz_splats: args.write.usdz_splats,
        compression: args.write.compression(),
        tiles: args.write.tiles,
    };
    // The sidecars write the scene's place into the KMZ; the PLY is there.
    let formats: Vec<Format> =
        args.format.iter().copied().filter(|f| !matches!(f, Format::Kmz | Format::Ply)).collect();
    let store_model = format::publish(&formats, &content, target, ground, &mut run.publication)?;
    bar.check()?;
    if formats.iter().any(|f| f.has_levels(args.write.tiles)) {
        let picture = export::provenance_png(&done.model, &product)?;
        run.publication.add(export::PROVENANCE, &picture, "image/png", "provenance")?;
        if let Some(expected) = &done.expected_error {
            let picture = export::expected_error_png(expected, &product)?;
            run.publication.add(export::EXPECTED_ERROR, &picture, "image/png", "expected error")?;
        }
    }
    let preview = export::preview_png(&photo.pixels, &done, &product)?;
    run.publication.add("preview.png", &preview, "image/png", "preview")?;
    sidecars::publish(&mut run.publication, &labels, &placed, &done, args.format.contains(&Format::Kmz))?;
    bar.check()?;

    let mut inputs = [front.inputs().to_vec(), chosen.inputs, placed.inputs.clone()].concat();
    // The terrain that placed the model may be the ground's as well.
    let ground_inputs: Vec<_> = ground_inputs.into_iter().filter(|i| !inputs.contains(i)).collect();
    inputs.extend(ground_inputs);
    let published = run.seal(Evidence {
        event_type: "scene.generate",
        time: reading,
        inputs,
        models: recorded::models(&done.sources, &done.report.device, front.colmap()),
        params: {
            let mut all = recorded::params(args, &settings, &done, &placed, &plan.catalogue, line);
            all.extend(front.params(done.several.as_ref()));
            all
        },
    })?;
    bar.finish();

    let summary = Summary {
        published: &published,
        done: &done,
        writing: writing.elapsed(),
        total: started.elapsed(),
        placed: &placed,
        marking: &product,
        store_model: store_model.as_deref(),
        steps_planned: settings.iterations,
        verbose: args.verbose,
        photos: front.lines(done.several.as_ref()),
    };
    if args.json {
        crate::cli::write_out(&format!("{}\n", summary::json(&summary)?));
    } else if !args.publish.quiet {
        crate::cli::write_out(&summary::text(&summary));
    }
    Ok(0)
}

/// Judges a run by what can be known of it before it: its options, and the photo or photos without their pixels. Returns
/// what the product would be marked; networks and terrain may raise it.
///
/// # Errors
/// What the run itself would begin with.
#[cfg(feature = "serve")]
pub(crate) fn judge(args: &GeoArgs, utc: &str) -> Result<crate::audit::Marking> {
    let mut plan = plan(args)?;
    if plan.photo.is_dir() {
        let front = Front::open(&plan.photo, &args.photos)?;
        args.networks.check_built_in()?;
        if plan.wanted.origin.is_some() || !front.has_control() {
            plan.wanted.check(front.exif())?;
        }
        return Ok(args.publish.marking.decide(front.carried(), utc)?.marking);
    }
    args.photos.check(false)?;
    let limits = crate::photo::Limits::default();
    let photo = read_photo(&plan.photo, limits.file_bytes)?;
    let (exif, _) = crate::photo::metadata(&plan.stem, &photo, &limits)?;
    plan.wanted.check(&exif)?;
    let carried = super::marking::carried(&super::photos::name_of(&plan.photo), &photo)?;
    Ok(args.publish.marking.decide(&[carried], utc)?.marking)
}

/// The whole file, its size looked at first.
pub(super) fn read_photo(path: &Path, limit: u64) -> Result<Vec<u8>> {
    let size = std::fs::metadata(path).map_err(|e| Error::io(path, &e).advice("Check the photo's path."))?.len();
    if size > limit {
        return Err(Error::usage(path.display().to_string())
            .expected(format!("a photo of at most {} MiB", limit >> 20))
            .found(format!("{} MiB", size >> 20)));
    }
    std::fs::read(path).map_err(|e| Error::io(path, &e))
}
