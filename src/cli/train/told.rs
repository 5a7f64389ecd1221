//! What `orb train` tells: the record's parameters, lines for people, one JSON object for programs.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde_json::{Value, json};

use super::poses;
use super::store::Stored;
use super::tiles::Tiled;
use super::{Placed, StrategyName, Train};
use crate::audit::statement::{Model, Param};
use crate::audit::{Published, record};
use crate::cli::photos::Set;
use crate::photos::reprojection::Reprojection;
use crate::pipeline::scene::{Cost, Errors, From, Options, Scene, Scores};

/// What ran: the optimisation; COLMAP, where it did.
pub fn models(device: &str, colmap: Option<&str>) -> Vec<Model> {
    let program = |id: &str, version: &str, runtime: &str, source: &str| Model {
        status: None,
        version: Some(version.into()),
        runtime: Some(runtime.into()),
        pin_source: Some(source.into()),
        ..record::model_not_used(id)
    };
    let own = program("orb-splat-core", env!("CARGO_PKG_VERSION"), device, "built-in");
    let colmap = match colmap {
        None => record::model_not_used("colmap"),
        Some(version) => program("colmap", version, "cpu", "program of this machine"),
    };
    vec![own, record::model_not_used("gsplat"), colmap]
}

fn strategy(args: &Train) -> &'static str {
    match args.strategy {
        StrategyName::Default => "default",
        StrategyName::Mcmc => "mcmc",
    }
}

fn begun(done: &Scene) -> String {
    match done.begun_from {
        From::Points(n) => format!("{n} sparse points"),
        From::Random(n) => format!("{n} random places"),
    }
}

/// For the record: what the user asked for.
pub fn settings(args: &Train, options: &Options, set: &Set) -> BTreeMap<String, Param> {
    let text = |v: String| Param::Text(v);
    let mut all = BTreeMap::from([
        ("seed".into(), text(args.seed.to_string())),
        ("strategy".into(), text(strategy(args).into())),
        ("iterations_planned".into(), Param::Int(options.iterations as i64)),
        ("max_gaussians".into(), Param::Int(options.max_gaussians as i64)),
        ("longest_side_px".into(), Param::Int(options.longest_side.into())),
        ("exposure_compensated".into(), Param::Bool(options.exposure)),
        ("photos_masked".into(), Param::Int(set.mask_count() as i64)),
        ("split".into(), text(set.split_words(args.test_every as usize))),
    ]);
    all.extend(set.params());
    all
}

/// For the record.
pub fn params(
    args: &Train,
    options: &Options,
    set: &Set,
    done: &Scene,
    placed: Option<&Placed>,
) -> BTreeMap<String, Param> {
    let text = |v: String| Param::Text(v);
    let r = &done.report;
    let mut all = settings(args, options, set);
    all.extend([
        ("device".into(), text(r.device.clone())),
        ("iterations_run".into(), Param::Int(r.iterations as i64)),
        ("gaussians".into(), Param::Int(done.gaussians.len() as i64)),
        ("gaussians_of_the_sky".into(), Param::Int(done.sky as i64)),
        ("begun_from".into(), text(begun(done))),
        ("poses_refined".into(), Param::Bool(done.refined.is_some())),
        ("background".into(), text(format!("{:?}", done.behind))),
        ("photos_trained_on".into(), Param::Int(done.trained.photos as i64)),
        ("photos_held_out".into(), Param::Int(done.held_out.photos as i64)),
        ("up_from".into(), text(done.up_by.label().into())),
        ("world_to_unit".into(), text(done.to_unit.to_string())),
    ]);
    for (when, e) in [("before", done.reprojection.before), ("after", done.reprojection.after)] {
        if let Some(e) = e {
            all.insert(format!("reprojection_rms_px_{when}"), text(format!("{:.4}", e.rms)));
            all.insert(format!("reprojection_median_px_{when}"), text(format!("{:.4}", e.median)));
            all.insert("reprojection_observations".into(), Param::Int(e.observations as i64));
        }
    }
    all.extend(poses::params(done));
    let fitted = done.held_out_fitted.unwrap_or_default();
    for (name, s) in [("trained", &done.trained), ("held_out", &done.held_out), ("held_out_poses_fitted", &fitted)] {
        let mut add = |what: &str, v: Option<f64>, places: usize| {
            if let Some(v) = v {
                all.insert(format!("{name}_{what}"), text(format!("{v:.places$}")));
            }
        };
        add("psnr_db", (s.photos > 0).then_some(s.psnr), 3);
        add("ssim", s.ssim, 4);
        add("lpips", s.lpips, 4);
        add("psnr_fitted_db", s.psnr_fitted, 3);
    }
    if let Some(p) = placed {
        let (o, r) = (&p.placement.origin, &p.registration);
        let [across, up] = r.rms();
        let [horizontal, vertical] = r.sigma(p.base.as_dvec3());
        let at = &r.origin;
        let more = [
            ("latitude", o.latitude.to_string()),
            ("longitude", o.longitude.to_string()),
            ("ellipsoidal_height_m", o.height.to_string()),
            ("heading_deg", p.placement.heading.to_string()),
            ("metres_per_unit", r.to_enu.scale.to_string()),
            ("horizontal_sigma_m", format!("{horizontal:.4}")),
            ("vertical_sigma_m", format!("{vertical:.4}")),
            ("heading_sigma_deg", format!("{:.3}", r.heading_sigma)),
            ("scale_sigma_percent", format!("{:.3}", r.scale_sigma * 100.0)),
            ("georegistration_rms_m", format!("{across:.4} across, {up:.4} up")),
            ("georegistration_outliers", r.outliers().map(|o| o.name.clone()).collect::<Vec<_>>().join(", ")),
            ("unit_to_enu", format!("{} about {} {} {}", r.to_enu, at.latitude, at.longitude, at.height)),
        ];
        let receivers =
            r.receivers_off.map(|d| ("receivers_off_m", format!("{:.3} east, {:.3} north, {:.3} up", d.x, d.y, d.z)));
        let more = more.into_iter().chain(receivers);
        all.extend(more.map(|(k, v)| (k.to_owned(), text(record::printable(&v)))));
    }
    all
}

/// Everything that is told at the end.
pub struct Told<'a> {
    pub args: &'a Train,
    pub set: &'a Set,
    pub options: &'a Options,
    pub cost: &'a Cost,
    pub done: &'a Scene,
    pub placed: Option<&'a Placed>,
    pub stored: Option<&'a Stored>,
    pub tiled: Option<&'a Tiled>,
    pub published: &'a Published,
    pub banner: String,
    pub seconds: f64,
}

impl Told<'_> {
    /// Lines for a person.
    pub fn text(&self) -> String {
        let (done, r) = (self.done, &self.done.report);
        let mut out = String::new();
        let mut line = |name: &str, words: String| {
            // Writing to a string cannot fail.
            let _ = writeln!(out, "{name:<12} {words}");
        };
        line("marking", self.banner.clone());
        line("published", self.published.folder.display().to_string());
        if let Ok(p) = self.set.poses() {
            line("poses", std::iter::once(&p.source).chain(&p.notes).cloned().collect::<Vec<_>>().join("; "));
        }
        if let Some(words) = reprojection(&done.reprojection) {
            line("reprojection", words);
        }
        for words in poses::lines(done) {
            line("refined", words);
        }
        line("begun from", begun(done));
        let sky = if done.sky > 0 { format!(", {} of them the sky", done.sky) } else { String::new() };
        line(
            "Gaussians",
            format!(
                "{}{sky}, at most {} allowed{}; after {} steps ({}) on {}",
                done.gaussians.len(),
                self.options.max_gaussians,
                if self.args.large.blocks.is_some() { " in a block" } else { "" },
                r.iterations,
                strategy(self.args),
                r.device
            ),
        );
        if let Some(p) = self.placed {
            let o = &p.placement.origin;
            line("place", format!("{:.9}, {:.9}, {:.3} m above the ellipsoid", o.latitude, o.longitude, o.height));
            let [across, up] = p.registration.rms();
            line(
                "scale",
                format!(
                    "{:.4} m a unit ± {:.2} %, heading {:.2}°; residuals {across:.2} m across, {up:.2} m up",
                    p.scale,
                    100.0 * p.registration.scale_sigma,
                    p.placement.heading
                ),
            );
            for o in p.registration.outliers() {
                line("outlier", format!("{} lies {:.1} m from where the others put it", o.name, o.enu.length()));
            }
        }
        if let Some(s) = self.stored {
            line("store", s.words());
        }
        if let Some(t) = self.tiled {
            line("meshes", t.words());
        }
        let training =
            format!("{:.1} s, {:.1} a second", r.seconds.train, r.iterations as f64 / r.seconds.train.max(1e-9));
        line("training", training);
        let stages: Vec<String> =
            done.timings.iter().map(|t| format!("{} {:.1} s", t.stage, t.time.as_secs_f64())).collect();
        line("stages", stages.join(", "));
        let peak = done.timings.iter().filter_map(|t| t.memory).max();
        let memory = peak.map_or("peak memory unknown".into(), |b| format!("peak memory {} MiB", b >> 20));
        let gpu = if r.peak_bytes > 0 { format!(", GPU memory {} MiB", r.peak_bytes >> 20) } else { String::new() };
        line("used", format!("{:.1} s, {memory}{gpu}", self.seconds));
        out + "\n" + &table(&done.held_out, done.held_out_fitted.as_ref(), &done.trained, self.options.exposure)
    }

    /// The object of `--json`.
    pub fn json(&self) -> String {
        let (done, r) = (self.done, &self.done.report);
        let outputs: Vec<Value> = self
            .published
            .outputs
            .iter()
            .map(|o| json!({"path": o.path, "media_type": o.media_type, "bytes": o.bytes, "sha256": o.sha256}))
            .collect();
        let stages: Vec<Value> = done
            .timings
            .iter()
            .map(|t| json!({"name": t.stage, "seconds": t.time.as_secs_f64(), "peak_memory_bytes": t.memory}))
            .collect();
        let photos: Vec<Value> = done
            .views
            .iter()
            .zip(&done.exposures)
            .map(|(v, e)| {
                let exposure = v.scores.photos > 0 && self.options.exposure;
                json!({
                    "name": v.name, "held_out": v.role == crate::pipeline::scene::Role::HeldOut,
                    "scores": scores(&v.scores), "exposure": exposure.then_some(e),
                })
            })
            .collect();
        let georeference = self.placed.map(|p| {
            let (o, r) = (&p.placement.origin, &p.registration);
            let [horizontal, vertical] = r.sigma(p.base.as_dvec3());
            json!({
                "latitude": o.latitude, "longitude": o.longitude, "ellipsoidal_height_m": o.height,
                "heading_deg": p.placement.heading, "metres_per_unit": r.to_enu.scale,
                "horizontal_sigma_m": horizontal, "vertical_sigma_m": vertical,
                "heading_sigma_deg": r.heading_sigma, "scale_sigma": r.scale_sigma,
                "world_to_enu": r.matrix(&done.to_unit),
            })
        });
        json!({
            "folder": self.published.folder.display().to_string(),
            "outputs": outputs,
            "stages": stages,
            "seconds": self.seconds,
            "train_seconds": r.seconds.train,
            "setup_seconds": r.seconds.setup,
            "iterations": r.iterations,
            "strategy": strategy(self.args),
            "device": r.device,
            "peak_gpu_memory_bytes": r.peak_bytes,
            "predicted_memory_bytes": self.cost.of_photos() + self.cost.of_gaussians(done.gaussians.len()),
            "gaussians": {
                "begun": r.gaussians_before, "end": done.gaussians.len(), "sky": done.sky,
                "most": self.options.max_gaussians, "begun_from": begun(done),
            },
            "held_out": scores(&done.held_out),
            "held_out_poses_fitted": done.held_out_fitted.as_ref().map(scores),
            "reprojection": {
                "before": done.reprojection.before.map(error), "after": done.reprojection.after.map(error),
            },
            "refining": poses::json(done),
            "trained_on": scores(&done.trained),
            "photos": photos,
            "up_from": done.up_by.label(),
            "world_to_unit": done.to_unit.to_string(),
            "georeference": georeference,
            "store": self.stored.map(Stored::json),
            "meshes": self.tiled.map(Tiled::json),
            "marking": self.banner,
            "record": {
                "ledger_id": self.published.ledger_id, "seq": self.published.seq,
                "trail_hash": self.published.trail_hash, "signed_by": self.published.signed_by,
                "time": self.published.time.utc(),
            },
        })
        .to_string()
    }
}

fn scores(s: &Scores) -> Value {
    match s.photos {
        0 => Value::Null,
        n => json!({
            "photos": n, "psnr_db": s.psnr, "ssim": s.ssim, "lpips": s.lpips, "psnr_fitted_db": s.psnr_fitted,
        }),
    }
}

fn error(e: Reprojection) -> Value {
    json!({"observations": e.observations, "points": e.points, "rms_px": e.rms, "median_px": e.median})
}

/// For a person; `None` where nothing is known.
fn reprojection(e: &Errors) -> Option<String> {
    let words = |e: &Reprojection| format!("{:.3} pixels (median {:.3})", e.rms, e.median);
    let before = e.before?;
    let after = e.after.map_or(String::new(), |after| format!(", refined {}", words(&after)));
    Some(format!("{}{after} over {} observations of {} points", words(&before), before.observations, before.points))
}

/// PSNR, SSIM and LPIPS of the photos held out and trained on.
fn table(held_out: &Scores, posed: Option<&Scores>, trained: &Scores, exposure: bool) -> String {
    let number = |v: Option<f64>, places: usize| v.map_or("–".to_owned(), |v| format!("{v:.places$}"));
    let mut out = format!("{:<13} {:>6} {:>9} {:>7} {:>7}\n", "", "photos", "PSNR dB", "SSIM", "LPIPS");
    let rows = [("held out", Some(held_out)), (" poses fitted", posed), ("trained on", Some(trained))];
    for (name, s) in rows.into_iter().filter_map(|(name, s)| Some((name, s?))) {
        if s.photos > 0 {
            let _ = writeln!(
                out,
                "{name:<13} {:>6} {:>9.2} {:>7} {:>7}",
                s.photos,
                s.psnr,
                number(s.ssim, 4),
                number(s.lpips, 4)
            );
        }
    }
    if let (true, Some(fitted)) = (exposure, held_out.psnr_fitted) {
        let _ = writeln!(
            out,
            "held out with colours fitted on one half and measured on the other: {fitted:.2} dB; trained on: under each \
             photo's own exposure"
        );
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_has_what_was_measured() {
        let s = Scores { photos: 3, psnr: 27.126, ssim: Some(0.91), lpips: None, psnr_fitted: Some(28.0) };
        let t = table(&s, None, &Scores { photos: 0, ..s }, true);
        assert!(
            t.contains("27.13") && t.contains("0.9100") && t.contains("28.00") && !t.contains("trained on  "),
            "{t}"
        );
        let posed = Scores { psnr: 31.0, ..s };
        let t = table(&s, Some(&posed), &s, false);
        assert!(t.contains("poses fitted") && t.contains("31.00") && t.contains("27.13"), "{t}");
        let lines: Vec<usize> = t.lines().map(|l| l.chars().count()).collect();
        assert!(lines.iter().all(|l| *l == lines[0]), "{t}");
        let e = Reprojection { observations: 90, points: 30, rms: 1.5, median: 0.5 };
        let both = Errors { before: Some(e), after: Some(Reprojection { rms: 0.75, ..e }) };
        let words = reprojection(&both).unwrap();
        assert!(words.contains("1.500") && words.contains("0.750") && words.contains("30 points"), "{words}");
        assert_eq!(reprojection(&Errors::default()), None);
        assert!(scores(&Scores::default()).is_null());
    }
}
