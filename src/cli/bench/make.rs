//! `orb bench make`: a benchmark of made scenes, marked and sealed.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use crate::Result;
use crate::audit::statement::Param;
use crate::audit::time;
use crate::bench::make::{self, Options};
use crate::cli::bar::Bar;
use crate::cli::sealed::{Evidence, PublishArgs, SealedRun};
use crate::progress::Progress;

/// Make scenes whose truth is known: photo, mask, held-back views, cameras, mesh.
#[derive(Clone, Debug, clap::Args)]
pub struct Make {
    /// Folder for the scenes; must not exist yet.
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// How many: ten kinds, one after the other.
    #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub scenes: u32,
    /// Same seed: same bytes.
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
    /// Pixels across a photo.
    #[arg(long, default_value_t = 512, value_parser = clap::value_parser!(u32).range(64..=2048))]
    pub size: u32,
    /// Held-back views of each scene.
    #[arg(long, default_value_t = 12, value_parser = clap::value_parser!(u32).range(1..=200))]
    pub views: u32,
    /// Pixels across a held-back view.
    #[arg(long, default_value_t = 256, value_parser = clap::value_parser!(u32).range(32..=2048))]
    pub view_size: u32,
    /// In place of a photo and held-back views of each: so many photos all around it, with GPS, and COLMAP's model of them.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=500))]
    pub photos: Option<u32>,
    /// Standard deviation of the photos' GPS across, metres; twice that up.
    #[arg(long, value_name = "METRES", default_value_t = 1.5, requires = "photos", value_parser = gps_noise)]
    pub gps_noise: f64,
    /// Leave COLMAP's model out.
    #[arg(long, requires = "photos")]
    pub no_poses: bool,
    /// With --photos: whole places to train scenes on, with COLMAP's model and its points, in place of one thing each.
    #[arg(long, requires = "photos", conflicts_with_all = ["no_poses", "nerf"])]
    pub site: bool,
    /// With --photos: one thing each, with alpha, in the layout of NeRF's synthetic sets.
    #[arg(long, requires = "photos", conflicts_with = "no_poses")]
    pub nerf: bool,
    /// With --site: how much the photos' brightness differs, a standard deviation of its natural logarithm.
    #[arg(long, value_name = "SIGMA", default_value_t = 0.0, requires = "site", value_parser = exposure_drift)]
    pub exposure_drift: f32,
    /// With --site: a van that stands elsewhere in each photo, and masks of it.
    #[arg(long, requires = "site")]
    pub moving: bool,
    #[command(flatten)]
    pub publish: PublishArgs,
}

fn gps_noise(text: &str) -> std::result::Result<f64, String> {
    let number = text.parse().ok().filter(|v: &f64| (0.0..=1000.0).contains(v));
    number.ok_or_else(|| "expected metres from 0 to 1000, such as 1.5".into())
}

fn exposure_drift(text: &str) -> std::result::Result<f32, String> {
    let number = text.parse().ok().filter(|v: &f32| (0.0..=1.0).contains(v));
    number.ok_or_else(|| "expected a number from 0 to 1, such as 0.35".into())
}

/// Makes and publishes. `stop` is set by the interrupt handler.
///
/// # Errors
/// As [`SealedRun`]; `Cancelled`.
pub fn publish(args: &Make, stop: &AtomicBool) -> Result<u8> {
    let handling = args.publish.marking.decide(&[], &time::now()?.utc())?;
    let marking = handling.marking.clone();
    let mut sealed = SealedRun::begin("orb bench make", &args.output, handling, &args.publish)?;
    let options = Options { seed: args.seed, photo: args.size, views: args.views as usize, view: args.view_size };
    let bar = Bar::new(stop, args.publish.quiet);
    bar.begin("making scenes", args.scenes.into());
    for i in 0..args.scenes as usize {
        bar.check()?;
        let files = match args.photos {
            None => make::scene(i, &options, &marking)?.1,
            Some(count) if args.site || args.nerf => {
                let whole = make::site::Options {
                    seed: args.seed,
                    count: count as usize,
                    width: args.size,
                    gps_noise: args.gps_noise,
                    exposure_drift: args.exposure_drift,
                    moving: args.moving,
                    nerf: args.nerf,
                };
                make::site::set(i, &whole, &marking)?.1
            }
            Some(count) => {
                let several = make::photos::Options {
                    seed: args.seed,
                    count: count as usize,
                    width: args.size,
                    gps_noise: args.gps_noise,
                    poses: !args.no_poses,
                };
                make::photos::set(i, &several, &marking)?.1
            }
        };
        for file in files {
            let role = if file.media_type == "application/json" { "scene" } else { "truth" };
            sealed.publication.add(&file.path, &file.bytes, file.media_type, role)?;
        }
        bar.step(i as u64 + 1);
    }
    let published = sealed.seal(Evidence {
        event_type: "bench.make",
        time: time::now()?,
        inputs: Vec::new(),
        models: Vec::new(),
        params: BTreeMap::from([
            ("seed".into(), Param::Text(args.seed.to_string())),
            ("scenes".into(), Param::Int(args.scenes.into())),
        ]),
    })?;
    bar.finish();
    if !args.publish.quiet {
        println!("{}\n{} scenes in {}", marking.banner(), args.scenes, published.folder.display());
    }
    Ok(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_and_drift_are_numbers_within_their_range() {
        for wrong in ["nan", "NaN", "inf", "-inf", "-0.1", "1000.5", "1e999", "x", ""] {
            assert!(gps_noise(wrong).is_err_and(|e| e.contains("0 to 1000")), "{wrong}");
            assert!(exposure_drift(wrong).is_err_and(|e| e.contains("0 to 1,")), "{wrong}");
        }
        assert!(exposure_drift("1.5").is_err());
        assert_eq!((gps_noise("1000"), gps_noise("0"), exposure_drift("0.35")), (Ok(1000.0), Ok(0.0), Ok(0.35)));
    }
}
