//! The options that put other networks, or the user's own files, in the place of the built-in networks.

use std::path::{Path, PathBuf};

use clap::Args;

use super::marking;
use crate::audit::statement::Input;
use crate::audit::{DataFolder, Marking, record};
use crate::models::engine::discovery::Search;
use crate::models::engine::{self, Choice, Engine, Provider, Rten};
use crate::models::registry::{Manifest, Registry, Stage};
use crate::models::sam;
use crate::models::zero123::{self, cache::Cache};
use crate::photo::{self, Photo};
use crate::sources::{self, Mask, Sources, Views};
use crate::views::tile;
use crate::{Error, Result};

/// How imported networks are run: the same wherever some are.
#[derive(Args, Clone, Debug, Default)]
pub struct EngineArgs {
    /// What runs imported networks.
    #[arg(long, value_enum, default_value = "auto", help_heading = "Networks")]
    pub engine: Choice,

    /// What ONNX Runtime computes on.
    #[arg(long, value_enum, default_value = "auto", help_heading = "Networks")]
    pub provider: Provider,

    /// The ONNX Runtime library, or a folder with it. Default: ORT_DYLIB_PATH, beside the program, the data folder's
    /// `runtime`, the system, an active Python environment.
    #[arg(long, value_name = "PATH", help_heading = "Networks")]
    pub onnxruntime: Option<PathBuf>,
}

impl EngineArgs {
    pub fn search(&self, data: &DataFolder) -> Search {
        Search::from_environment(self.onnxruntime.as_deref(), Some(data.path()), |name| std::env::var_os(name))
    }

    /// # Errors
    /// As [`engine::open`].
    pub fn open(&self, data: &DataFolder, say: &mut dyn FnMut(&str)) -> Result<Box<dyn Engine>> {
        engine::open(self.engine, self.provider, &self.search(data), say)
    }
}

#[derive(Args, Clone, Debug, Default)]
pub struct NetworkArgs {
    /// A mask of the subject, in place of a network's: white on it and black around it, or an alpha channel.
    #[arg(long, value_name = "FILE", help_heading = "Networks")]
    pub mask: Option<PathBuf>,

    /// A point on the subject, in pixels of the photo. An imported mask network takes several.
    #[arg(long, value_name = "X,Y", conflicts_with = "mask", help_heading = "Networks")]
    pub point: Vec<String>,

    /// A box around the subject, in pixels of the photo, for an imported mask network.
    #[arg(long = "box", value_name = "X0,Y0,X1,Y1", conflicts_with = "mask", help_heading = "Networks")]
    pub bounds: Option<String>,

    /// Six ready views: one picture of 640 × 960, two views across and three down, as Zero123++ v1.2 draws them.
    #[arg(long, value_name = "FILE", help_heading = "Networks")]
    pub views: Option<PathBuf>,

    /// Normals of the six views as a picture like --views: −1 to 1 as 0 to 255, x right, y up, z towards the camera.
    #[arg(long, value_name = "FILE", requires = "views", help_heading = "Networks")]
    pub normals: Option<PathBuf>,

    /// `auto`: all that were imported, six views only where a GPU draws them; `built-in`: none; or names of imported
    /// networks, separated by commas.
    #[arg(long, value_delimiter = ',', default_value = "auto", value_name = "NAMES", help_heading = "Networks")]
    pub networks: Vec<String>,

    /// Steps of the diffusion that draws six views: 28 for objects in general, 75 for fine detail.
    #[arg(long, value_name = "N", default_value_t = 28, value_parser = clap::value_parser!(u16).range(1..=1000), help_heading = "Networks")]
    pub diffusion_steps: u16,

    #[command(flatten)]
    pub engine: EngineArgs,
}

impl NetworkArgs {
    /// For several photos: the built-in networks alone.
    ///
    /// # Errors
    /// Usage, naming the option.
    pub fn check_built_in(&self) -> Result<()> {
        let given = [
            ("--mask", self.mask.is_some()),
            ("--point", !self.point.is_empty()),
            ("--box", self.bounds.is_some()),
            ("--views", self.views.is_some()),
            ("--networks", self.networks.iter().any(|n| n != "auto" && n != "built-in")),
        ];
        match given.iter().find(|(_, given)| *given) {
            Some((option, _)) => Err(Error::usage(*option)
                .expected("one photo")
                .found("a folder of photos")
                .advice("Several photos are masked by the built-in network, or by their own alpha channels.")),
            None => Ok(()),
        }
    }
}

/// Where imported networks lie: `ORB_MODELS_DIR`, else `models` in the data folder.
pub fn registry(data: &DataFolder) -> Registry {
    let own = std::env::var_os("ORB_MODELS_DIR").filter(|v| !v.is_empty()).map(PathBuf::from);
    Registry::at(own.unwrap_or_else(|| data.path().join("models")))
}

/// What a run uses, and the files that it was given, for the record.
pub struct Chosen {
    pub sources: Sources,
    pub inputs: Vec<Input>,
}

/// What the mask, the six views and their normals that are given are marked.
///
/// # Errors
/// As [`marking::carried`]; a file that cannot be read.
pub fn carried(args: &NetworkArgs) -> Result<Vec<Option<Marking>>> {
    let of = |path: &PathBuf| {
        let bytes = crate::audit::disk::read_limited(path, photo::Limits::default().file_bytes)?;
        marking::carried(&path.file_name().unwrap_or_default().to_string_lossy(), &bytes)
    };
    args.mask.iter().chain(&args.views).chain(&args.normals).map(of).collect()
}

/// Judges the options, hashes the networks that will run, opens the engine where there are any.
///
/// # Errors
/// Usage for options that do not fit together or a file that cannot be used; integrity for changed weights; environment
/// for an engine that is missing.
pub fn choose(
    args: &NetworkArgs,
    photo: &Photo,
    seed: u64,
    data: &DataFolder,
    say: &mut dyn FnMut(&str),
) -> Result<Chosen> {
    let size = photo.pixels.dimensions();
    let mut inputs = Vec::new();
    let mut read = |path: &Path, role: &str| -> Result<Photo> {
        let limits = photo::Limits::default();
        let bytes = crate::audit::disk::read_limited(path, limits.file_bytes)?;
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let picture = photo::decode(&name, &bytes, &limits)?;
        inputs.push(record::input(&name, &bytes, picture.media_type, role, marking::carried(&name, &bytes)?));
        Ok(picture)
    };
    let given_mask = match &args.mask {
        Some(path) => Some(sources::mask_from(&read(path, "mask")?, size)?),
        None => None,
    };
    let given_views = match &args.views {
        Some(path) => {
            let tile = sources::tile_from(&read(path, "six-views")?);
            // What is wrong with it is said before the work.
            tile::cut(&tile)?;
            Some(tile)
        }
        None => None,
    };
    let normals = match &args.normals {
        Some(path) => tile::normals(&read(path, "normals")?.pixels)?,
        None => Vec::new(),
    };
    let prompt = prompt(args)?.on(size.0, size.1)?;

    let registry = registry(data);
    let picked = Picked::of(&args.networks, &registry)?;
    let more = args.point.len() > 1 || args.bounds.is_some();
    if more && picked.mask.is_none() {
        return Err(Error::usage("--point or --box")
            .expected("one point, or an imported mask network, which takes several and boxes")
            .found("more, and none imported")
            .advice("Import SAM 2 or MobileSAM (`orb models import`), or bring a mask: --mask FILE."));
    }
    let point = (!args.point.is_empty()).then(|| prompt.points[0]);
    let wanted = |manifest: Option<Manifest>, taken: bool| match manifest {
        Some(m) if !taken => registry.verified(&m).map(Some),
        _ => Ok(None),
    };
    // A photo that is cut out says where its subject is; a network is asked all the same where the user points.
    let prompted = point.is_some() || args.bounds.is_some();
    let cut_out = photo.cutout.is_some() && !prompted && !picked.named;
    let mask = wanted(picked.mask, given_mask.is_some() || cut_out)?;
    let depth = wanted(picked.depth, false)?;
    let mut views = wanted(picked.views, given_views.is_some())?;
    let insists = args.engine.engine == Choice::Ort || args.engine.provider != Provider::Auto;
    let engine: Box<dyn Engine> = match mask.is_some() || depth.is_some() || views.is_some() || insists {
        true => args.engine.open(data, say)?,
        false => Box::new(Rten),
    };
    if let Some(network) = views.take_if(|_| !picked.named && !engine.on_gpu()) {
        say(&format!(
            "{} is not used: without a GPU it takes the better part of an hour; --networks {0} uses it all the same",
            network.manifest.id
        ));
    }
    for network in [&mask, &depth, &views].into_iter().flatten() {
        let m = &network.manifest;
        say(&format!(
            "{} {} for the {}{}",
            m.id,
            m.version,
            m.family.stage().name(),
            if m.pinned { "" } else { ", unverified" }
        ));
    }
    let settings = zero123::Settings { steps: args.diffusion_steps.into(), seed, ..zero123::Settings::default() };
    let sources = Sources {
        engine,
        mask: match (given_mask, mask) {
            (Some(given), _) => Mask::Given(given),
            (None, Some(network)) => Mask::Network(network, prompt),
            (None, None) => Mask::BuiltIn(point),
        },
        depth,
        views: match (given_views, views) {
            (Some(given), _) => Views::Given(given, normals),
            (None, Some(network)) => Views::Network(network, settings),
            (None, None) => Views::BuiltIn,
        },
        cache: Some(Cache::at(data.path().join("cache").join("views"))),
    };
    Ok(Chosen { sources, inputs })
}

/// A network a stage.
#[derive(Default)]
struct Picked {
    mask: Option<Manifest>,
    depth: Option<Manifest>,
    views: Option<Manifest>,
    /// By the user, not by Orb.
    named: bool,
}

impl Picked {
    fn of(names: &[String], registry: &Registry) -> Result<Picked> {
        let mut out = Picked::default();
        let all = match names {
            [one] if one == "built-in" => return Ok(out),
            [one] if one == "auto" => {
                let mut all = registry.list()?;
                // The largest of a stage.
                all.sort_by_key(|m| std::cmp::Reverse(m.bytes()));
                all
            }
            named => {
                out.named = true;
                named.iter().map(|id| registry.get(id)).collect::<Result<_>>()?
            }
        };
        for manifest in all {
            let place = match manifest.family.stage() {
                Stage::Mask => &mut out.mask,
                Stage::Depth => &mut out.depth,
                Stage::Views => &mut out.views,
            };
            match place {
                None => *place = Some(manifest),
                Some(first) if out.named => {
                    return Err(Error::usage("--networks").expected("one network a stage").found(format!(
                        "{} and {} for the {}",
                        first.id,
                        manifest.id,
                        manifest.family.stage().name()
                    )));
                }
                Some(_) => {}
            }
        }
        Ok(out)
    }
}

fn prompt(args: &NetworkArgs) -> Result<sam::Prompt> {
    let numbers = |text: &str, option: &str, form: &str| -> Result<Vec<f32>> {
        let all: Option<Vec<f32>> =
            text.split(',').map(|v| v.trim().parse().ok().filter(|v: &f32| v.is_finite())).collect();
        all.filter(|v| v.len() == form.split(',').count())
            .ok_or_else(|| Error::usage(option).expected(form).found(format!("`{text}`")))
    };
    let mut out = sam::Prompt::default();
    for text in &args.point {
        let v = numbers(text, "--point", "X,Y")?;
        out.points.push([v[0], v[1]]);
    }
    if let Some(text) = &args.bounds {
        let v = numbers(text, "--box", "X0,Y0,X1,Y1")?;
        out.bounds = Some([v[0], v[1], v[2], v[3]]);
    }
    Ok(out)
}
