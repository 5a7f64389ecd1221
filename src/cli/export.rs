//! `orb export`: splats and models of others, or of Orb, into every format that Orb writes.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::{Args, ValueEnum};

use super::bar::Bar;
use super::format::{self, Content, Format, WriteArgs, safe_stem};
use super::marking;
use super::sealed::{Evidence, PublishArgs, SealedRun};
use crate::audit::statement::Param;
use crate::audit::{record, time};
use crate::export::import::{self, Imported, SplatAxes};
use crate::export::{Catalogue, Labels};
use crate::geo::{Geodetic, HeadingSource, Placement, parse_point};
use crate::progress::Progress;
use crate::{Error, Result};

/// Which way the axes of splats in a PLY point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum AxesArg {
    /// x right, y forward, z up.
    ZUp,
    /// x right, y up, z back.
    YUp,
    /// x right, y down, z forward: the custom of 3D Gaussian Splatting.
    YDown,
}

impl From<AxesArg> for SplatAxes {
    fn from(axes: AxesArg) -> Self {
        match axes {
            AxesArg::ZUp => SplatAxes::ZUp,
            AxesArg::YUp => SplatAxes::YUp,
            AxesArg::YDown => SplatAxes::YDown,
        }
    }
}

/// An option given twice takes its last value, as people expect who add to a command.
#[derive(Args, Clone, Debug)]
#[command(args_override_self = true)]
pub struct ExportArgs {
    /// Splats in PLY, SPZ or GLB, or a textured model in GLB.
    pub input: PathBuf,

    /// Formats to write, separated by commas.
    #[arg(long, value_delimiter = ',', value_enum, required = true)]
    pub format: Vec<Format>,

    /// The ground point under the subject: latitude and longitude in degrees, height in metres above the WGS84 ellipsoid.
    /// Default: where the input says that it stands.
    #[arg(long, value_name = "LAT,LON,ALT", allow_hyphen_values = true)]
    pub origin: Option<String>,

    /// Bearing of the model's forward axis (+Y where Z is up, −Z where Y is up), degrees clockwise from true north.
    /// Default: the input's own, else 0.
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub heading: Option<f64>,

    /// Folder to publish; must not exist yet. Default: the input's name without its extension.
    #[arg(short = 'o', long, value_name = "DIR")]
    pub output: Option<PathBuf>,

    /// Metres in one unit of the input.
    #[arg(long, value_name = "METRES", default_value_t = 1.0, allow_negative_numbers = true)]
    pub scale: f64,

    /// Keep the input's own origin. Without it a file that Orb did not write is moved: the centre of its footprint at
    /// its lowest point comes to the origin.
    #[arg(long)]
    pub keep_origin: bool,

    /// Axes of splats in a PLY. Default: z-up where Orb wrote it, else y-down.
    #[arg(long, value_enum)]
    pub axes: Option<AxesArg>,

    /// Levels of detail to make, 0 to 4: all of them from splats, coarser ones for a model, which itself stays as it is.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u8).range(0..=4))]
    pub lods: u8,

    #[command(flatten)]
    pub write: WriteArgs,

    #[command(flatten)]
    pub publish: PublishArgs,
}

/// Converts and publishes. `stop` is set by the interrupt handler.
///
/// # Errors
/// Usage for an input or options that cannot be used; policy for a marking below the input's; environment for the disk.
pub fn run(args: &ExportArgs, stop: &AtomicBool) -> Result<u8> {
    let catalogue = args.write.catalogue()?;
    if !(args.scale.is_finite() && args.scale > 0.0) {
        return Err(Error::usage("--scale").expected("metres above 0").found(args.scale.to_string()));
    }
    if let Some(h) = args.heading.filter(|h| !(h.is_finite() && (-360.0..=360.0).contains(h))) {
        return Err(Error::usage("--heading").expected("degrees between -360 and 360").found(h.to_string()));
    }
    let origin = args.origin.as_deref().map(origin_of).transpose()?;
    let bytes = std::fs::read(&args.input).map_err(|e| Error::io(&args.input, &e))?;
    let name = args.input.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let stem = safe_stem(&args.input);
    let own = marking::carried(&name, &bytes)?;
    let ground = args.write.ground.open(args.format.contains(&Format::Cdb), None)?;
    let mut carried = vec![own.clone()];
    let mut inputs = Vec::new();
    if let Some(files) = &ground {
        carried.extend(files.carried()?);
        inputs.clone_from(&files.inputs);
    }
    let handling = args.publish.marking.decide(&carried, &time::now()?.utc())?;
    let product = handling.marking.clone();
    let output = args.output.clone().unwrap_or_else(|| PathBuf::from(&stem));
    let mut run = SealedRun::begin("orb export", &output, handling, &args.publish)?;
    let target = args.write.target(&output, &stem)?;
    let bar = Bar::new(stop, args.publish.quiet);

    bar.begin("reading", 0);
    let mut imported = import::read(&name, &bytes, args.axes.map(Into::into))?.scaled(args.scale);
    let placement = place(&imported, origin, args.heading)?;
    let recentred = !args.keep_origin && !imported.is_orbs;
    let has_levels = args.format.iter().any(|f| f.has_levels(args.write.tiles));
    if has_levels || (imported.levels.is_empty() && args.format.contains(&Format::Usdz)) {
        imported = imported.with_levels(Format::levels_made(&args.format, args.lods.into()), &bar)?;
    }
    // The surface, where there is one, knows better than the splats' centres what stands on the ground.
    let imported = if recentred { imported.recentred() } else { imported };
    bar.check()?;
    bar.begin("writing and sealing", 0);
    let reading = time::now()?;
    let labels = Labels {
        stem,
        marking: product.clone(),
        utc: reading.utc(),
        heading_source: placement.heading_source.label(),
        scale_source: "input",
    };
    let content = Content {
        levels: &imported.levels,
        // A model is a level itself, beside the coarser ones.
        shown: usize::from(args.lods) + usize::from(imported.gaussians.is_none()),
        gaussians: imported.gaussians.as_ref(),
        placement: &placement,
        labels: &labels,
        catalogue: &catalogue,
        spz: args.write.spz_version.into(),
        flt_geometry: args.write.flt_geometry.into(),
        usdz_splats: args.write.usdz_splats,
        compression: args.write.compression(),
        tiles: args.write.tiles,
    };
    let model = format::publish(&args.format, &content, target, ground, &mut run.publication)?;
    let role = if imported.gaussians.is_some() { "scene" } else { "model" };
    inputs.insert(0, record::input(&name, &bytes, media_type(&bytes), role, own));
    let published = run.seal(Evidence {
        event_type: "scene.export",
        time: reading,
        inputs,
        models: Vec::new(),
        params: params(args, &placement, &catalogue, recentred),
    })?;
    bar.finish();
    if !args.publish.quiet {
        let o = &placement.origin;
        println!("{}\n{} files in {}", product.banner(), published.outputs.len(), published.folder.display());
        println!("at {}, {}, {} m, heading {}°", o.latitude, o.longitude, o.height, placement.heading);
        let sizes: Vec<String> = imported.levels.iter().map(|l| l.mesh.triangles.len().to_string()).collect();
        if !sizes.is_empty() {
            println!("levels of {} triangles", sizes.join(", "));
        }
        if let Some(g) = &imported.gaussians {
            println!("{} Gaussians", g.len());
        }
        if let Some(model) = model {
            println!("model {model} in the CDB store");
        }
    }
    Ok(0)
}

/// Any way of writing a point that `orb geo` takes, with a height above the ellipsoid.
fn origin_of(text: &str) -> Result<Geodetic> {
    let point = parse_point("--origin", text)?;
    let height = point.height.ok_or_else(|| {
        Error::usage("--origin").expected("a height in metres above the ellipsoid").found(format!("`{text}`"))
    })?;
    Ok(Geodetic { latitude: point.latitude, longitude: point.longitude, height })
}

/// What was given, else what the input says.
fn place(imported: &Imported, origin: Option<Geodetic>, heading: Option<f64>) -> Result<Placement> {
    let own = imported.place;
    let Some(origin) = origin.or(own.map(|p| p.origin)) else {
        return Err(Error::usage("--origin")
            .expected("a place: the input does not say where it stands")
            .advice("Write latitude,longitude,height, for example --origin 34.5523,-118.4712,740"));
    };
    let (heading, heading_source) = match (heading, own) {
        (Some(h), _) => (h, HeadingSource::Given),
        (None, Some(p)) => (p.heading, p.heading_source),
        (None, None) => (0.0, HeadingSource::Assumed),
    };
    Ok(Placement { origin, heading: heading.rem_euclid(360.0), heading_source })
}

fn media_type(bytes: &[u8]) -> &'static str {
    match bytes {
        [b'p', b'l', b'y', ..] => "application/ply",
        [b'g', b'l', b'T', b'F', ..] => "model/gltf-binary",
        _ => "model/x-spz",
    }
}

fn params(args: &ExportArgs, placement: &Placement, catalogue: &Catalogue, recentred: bool) -> BTreeMap<String, Param> {
    let text = |v: String| Param::Text(v);
    let mut all = BTreeMap::from([
        ("formats".into(), text(Format::names(&args.format))),
        ("latitude".into(), text(placement.origin.latitude.to_string())),
        ("longitude".into(), text(placement.origin.longitude.to_string())),
        ("ellipsoidal_height_m".into(), text(placement.origin.height.to_string())),
        ("heading_deg".into(), text(placement.heading.to_string())),
        ("heading_source".into(), text(placement.heading_source.label().into())),
        ("metres_per_unit".into(), text(args.scale.to_string())),
        ("recentred".into(), Param::Bool(recentred)),
        ("lods".into(), Param::Int(args.lods.into())),
    ]);
    all.extend(args.write.params(catalogue));
    all
}
