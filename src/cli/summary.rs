//! What a run tells the user: lines for people, one JSON object for programs.

use std::fmt::Write;
use std::time::Duration;

use super::geo::Placed;
use crate::audit::marking::Marking;
use crate::audit::publication::Published;
use crate::geo::scale::with_deviation;
use crate::models::prior;
use crate::pipeline::held::STRAIGHTENED_BY_35MM;
use crate::pipeline::several::Role;
use crate::pipeline::{self, Reconstruction};
use crate::splat::train::{Quality, TargetReport};
use crate::{Error, Result, memory, splat, symmetry};

pub struct Summary<'a> {
    pub published: &'a Published,
    pub done: &'a Reconstruction,
    pub writing: Duration,
    pub total: Duration,
    pub placed: &'a Placed,
    pub marking: &'a Marking,
    /// Name of the model in the CDB store.
    pub store_model: Option<&'a str>,
    pub steps_planned: u32,
    /// Also what each stage used and what the networks said.
    pub verbose: bool,
    /// Of several photos: name and words of each line.
    pub photos: Vec<(&'static str, String)>,
}

/// Lines for a person.
pub fn text(s: &Summary) -> String {
    let mut out = String::new();
    let report = &s.done.report;
    let finest = &s.done.model.levels[0];
    let (low, high) = finest.mesh.bounds();
    let size = (high - low) * s.placed.to_metres.scale;
    let (placement, scale, known) = (&s.placed.placement, &s.placed.scale, &s.placed.uncertainty);
    let o = &placement.origin;
    let mut line = |name: &str, words: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{name:<12} {words}");
    };
    line("marking", s.marking.banner());
    line("published", s.published.folder.display().to_string());
    if let Some(model) = s.store_model {
        line("model", format!("{model} in the CDB store"));
    }
    let place = [short(o.latitude, 9), short(o.longitude, 9), short(o.height, 3)];
    line("place", format!("{} m above the ellipsoid", place.join(", ")));
    line(
        "known to",
        format!("± {} across, ± {} up, one standard deviation", metres(known.horizontal), metres(known.vertical)),
    );
    let heading = with_deviation(placement.heading, known.heading, "°");
    line("heading", format!("{heading} ({})", placement.heading_source.label()));
    let [across, deep, high] = size.to_array().map(|v| with_deviation(v.into(), f64::from(v) * scale.sigma, " m"));
    line("size", format!("{across} across, {deep} deep, {high} high ({})", scale.words()));
    if let Some(iou) = s.done.subject.expected_iou {
        line("mask", format!("IoU of {iou:.2} with the subject to be expected"));
    }
    if let Some(turned) = &s.done.prior.crop.turned {
        let angle = turned.angle().to_degrees();
        let lens = match turned.lens_assumed {
            true => format!(", its lens assumed to be one of {STRAIGHTENED_BY_35MM} mm"),
            false => String::new(),
        };
        line("turned", format!("by {angle:.1}°, to a level camera that looks straight at the subject{lens}"));
    }
    let vertices: Vec<String> = s.done.model.levels.iter().map(|l| l.mesh.positions.len().to_string()).collect();
    line("levels", format!("{} vertices", vertices.join(", ")));
    let assumed = if symmetry::assumed(&s.done.symmetry) { " (assumed)" } else { "" };
    let mirrored = match symmetry::used(&s.done.symmetry).len() {
        0 => String::new(),
        1 => format!("{:.0}% from the photo mirrored{assumed}, ", finest.mirrored * 100.0),
        _ => format!("{:.0}% from the photo mirrored at two planes{assumed}, ", finest.mirrored * 100.0),
    };
    line("texture", format!("{:.0}% from the photo, {mirrored}the rest invented", finest.seen * 100.0));
    if let Some(expected) = &s.done.expected_error {
        let levels = 255.0 * expected.mean;
        line(
            "expected",
            format!("colours of the network's own model off by {levels:.0} of 255 in the mean, from all sides"),
        );
    }
    let steps = match report.iterations {
        run if run < s.steps_planned as usize => format!("{run} of {} steps, for lack of time", s.steps_planned),
        run => format!("{run} steps"),
    };
    match s.done.several {
        None => line("optimised", format!("{steps}; {}", quality(s.done))),
        Some(_) => line("optimised", steps),
    }
    if let Some(settled) = &s.done.settled {
        let [before, after] = agreement(settled);
        let steps = settled.iterations;
        line(
            "settled",
            format!("{steps} steps on the model; its pictures and the Gaussians' {before:.1} → {after:.1} dB"),
        );
    }
    for (name, words) in &s.photos {
        line(name, words.clone());
    }
    line("time", s.published.time.describe());
    line("record", format!("{} of ledger {}", s.published.seq, s.published.ledger_id));
    line("trail hash", s.published.trail_hash.clone());
    line("signed by", s.published.signed_by.clone());
    for also in &s.published.also_signed_by {
        line("and by", also.clone());
    }
    let stages: Vec<String> = s
        .done
        .timings
        .iter()
        .map(|t| format!("{} {:.1} s", t.stage, t.time.as_secs_f64()))
        .chain([format!("writing and sealing {:.1} s", s.writing.as_secs_f64())])
        .collect();
    line("stages", stages.join(", "));
    let networks = networks(s);
    if !networks.is_empty() {
        line("networks", networks);
    }
    if s.verbose {
        for t in &s.done.timings {
            let memory = t.memory.map_or("unknown".into(), |b| format!("{} MiB", b >> 20));
            line("memory", format!("{memory} at most during {}", t.stage));
        }
        if report.peak_bytes > 0 {
            line("GPU memory", format!("{} MiB at most during optimisation", report.peak_bytes >> 20));
        }
    }
    let memory = peak_memory(s).map_or("peak memory unknown".into(), |b| format!("peak memory {} MiB", b >> 20));
    line("used", format!("{:.1} s, {memory}", s.total.as_secs_f64()));
    out
}

/// At most so many places, no zeros at the end.
fn short(v: f64, places: usize) -> String {
    let text = format!("{v:.places$}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Two significant digits at least; millimetres at most.
fn metres(v: f64) -> String {
    let places = if v >= 10.0 {
        0
    } else if v >= 1.0 {
        1
    } else if v >= 0.1 {
        2
    } else {
        3
    };
    format!("{v:.places$} m")
}

/// PSNR before and after the optimisation, dB.
type Pair = (f32, f32);

/// Of the photo inside its mask, of the photo's held-back pixels, of the six views trained on, of the held-back views
/// between them (means).
fn qualities(done: &Reconstruction) -> [(&'static str, Pair); 4] {
    let of = |select: &dyn Fn(&TargetReport) -> bool, value: &dyn Fn(&Quality) -> Option<f32>| {
        let mean = |pick: &dyn Fn(&TargetReport) -> Quality| {
            let all: Vec<f32> =
                done.report.targets.iter().filter(|t| select(t)).filter_map(|t| value(&pick(t))).collect();
            all.iter().sum::<f32>() / all.len().max(1) as f32
        };
        (mean(&|t| t.before), mean(&|t| t.after))
    };
    let photo = |t: &TargetReport| t.name == pipeline::PHOTO;
    [
        ("photo", of(&photo, &|q| Some(q.subject))),
        ("photo_held_back", of(&photo, &|q| q.held_back)),
        ("six_views", of(&|t| t.name.starts_with(pipeline::VIEW), &|q| Some(q.picture))),
        ("held_back_views", of(&|t| t.name.starts_with(pipeline::HELD_BACK), &|q| Some(q.picture))),
    ]
}

/// How alike the model's pictures and the Gaussians' are, before and after the Gaussians were trained on them: mean PSNR.
fn agreement(settled: &splat::Report) -> [f32; 2] {
    let pictures = || settled.targets.iter().filter(|t| t.name.starts_with(pipeline::settled::MODEL));
    let count = pictures().count().max(1) as f32;
    [
        pictures().map(|t| t.before.picture).sum::<f32>() / count,
        pictures().map(|t| t.after.picture).sum::<f32>() / count,
    ]
}

/// PSNR before → after on the photo; on the network's own views, which were exact before, how much is kept.
fn quality(done: &Reconstruction) -> String {
    let [photo, photo_held_back, six, held_back] = qualities(done).map(|(_, pair)| pair);
    let photo = format!(
        "photo {:.1} → {:.1} dB, its held-back pixels {:.1} → {:.1} dB",
        photo.0, photo.1, photo_held_back.0, photo_held_back.1
    );
    // Views that others drew were not exact before, and have none between them.
    match done.sources.views_are_the_priors() {
        true => format!("{photo}; six views kept to {:.1} dB, held-back views to {:.1} dB", six.1, held_back.1),
        false => format!("{photo}; six views {:.1} → {:.1} dB", six.0, six.1),
    }
}

/// The object of `--json`.
///
/// # Errors
/// None in practice: every value is plain.
pub fn json(s: &Summary) -> Result<String> {
    let outputs: Vec<_> = s
        .published
        .outputs
        .iter()
        .map(|o| serde_json::json!({"path": o.path, "media_type": o.media_type, "bytes": o.bytes, "sha256": o.sha256}))
        .collect();
    let stages: Vec<_> = s
        .done
        .timings
        .iter()
        .map(|t| serde_json::json!({"name": t.stage, "seconds": t.time.as_secs_f64(), "peak_memory_bytes": t.memory}))
        .chain([serde_json::json!({"name": "writing and sealing", "seconds": s.writing.as_secs_f64()})])
        .collect();
    let (placement, scale, known) = (&s.placed.placement, &s.placed.scale, &s.placed.uncertainty);
    let o = &placement.origin;
    let finest = &s.done.model.levels[0];
    let metres = |v: f32| f64::from(v) * scale.metres_per_unit;
    let levels: Vec<_> = s
        .done
        .model
        .levels
        .iter()
        .map(|l| {
            serde_json::json!({
                "vertices": l.mesh.positions.len(), "triangles": l.mesh.triangles.len(),
                "largest_error_m": metres(l.error), "mean_error_m": metres(l.mean_error),
                "significant_size_m": metres(l.error_to_coarser),
            })
        })
        .collect();
    let planes = symmetry::used(&s.done.symmetry).len();
    let basis: Vec<_> = s.done.symmetry.iter().filter_map(|f| f.basis).map(symmetry::Basis::label).collect();
    let settled = s.done.settled.iter().map(|r| ("model_pictures", agreement(r).into()));
    let psnr: serde_json::Map<String, serde_json::Value> = qualities(s.done)
        .into_iter()
        .filter(|(name, _)| *name != "held_back_views" || s.done.sources.views_are_the_priors())
        .filter(|_| s.done.several.is_none())
        .chain(settled)
        .map(|(name, (before, after))| (name.to_owned(), serde_json::json!({"before": before, "after": after})))
        .collect();
    let built_in =
        [&prior::SCENE, &prior::DETAIL, &prior::SPLAT].map(|p| serde_json::json!({"id": p.id, "sha256": p.sha256}));
    let imported = s.done.sources.ran().map(|r| {
        let m = &r.manifest;
        serde_json::json!({"id": m.id, "sha256": m.weights_sha256(), "runtime": r.runtime, "pinned": m.pinned})
    });
    let models: Vec<_> = built_in.into_iter().chain(imported).collect();
    let scores = |v: &crate::pipeline::several::Scores| {
        serde_json::json!({
            "photos": v.photos, "psnr_db": v.psnr, "ssim": v.ssim, "silhouette_iou": v.silhouette_iou,
        })
    };
    let several = s.done.several.as_ref().map(|v| {
        serde_json::json!({
            "trained_on": scores(&v.trained), "held_out": (v.held_out.photos > 0).then(|| scores(&v.held_out)),
            "left_out": v.photos.iter().filter_map(|p| match &p.role {
                Role::LeftOut(why) => Some(serde_json::json!({"photo": p.name, "why": why})),
                _ => None,
            }).collect::<Vec<_>>(),
            "up_from": v.up_by.label(), "network_silhouette_iou": v.network_iou,
            "started_from": {"network": v.started_from[0], "masks": v.started_from[1], "points": v.started_from[2]},
            "refined": v.refined.map(|(turn, shift)| serde_json::json!({"most_deg": turn, "most_shift": shift})),
        })
    });
    let object = serde_json::json!({
        "several_photos": several,
        "folder": s.published.folder.display().to_string(),
        "outputs": outputs,
        "stages": stages,
        "seconds": s.total.as_secs_f64(),
        "peak_memory_bytes": peak_memory(s),
        "models": models,
        "device": s.done.report.device,
        "peak_gpu_memory_bytes": s.done.report.peak_bytes,
        "georeference": {
            "latitude": o.latitude, "longitude": o.longitude, "ellipsoidal_height_m": o.height,
            "heading_deg": placement.heading, "heading_source": placement.heading_source.label(),
            "horizontal_sigma_m": known.horizontal, "vertical_sigma_m": known.vertical,
            "heading_sigma_deg": known.heading, "lineage": s.placed.lineage,
        },
        "scale": {
            "metres_per_unit": scale.metres_per_unit, "source": scale.source.label(), "relative_sigma": scale.sigma,
            "words": scale.words(),
        },
        "levels": levels,
        "texture": {"seen": finest.seen, "mirrored": finest.mirrored, "invented": 1.0 - finest.seen - finest.mirrored},
        "symmetry": {"applied": planes > 0, "planes": planes, "basis": basis},
        "mask": {"expected_iou": s.done.subject.expected_iou},
        "expected_colour_error": s.done.expected_error.as_ref().map(|e| e.mean),
        "psnr_db": psnr,
        "cdb_model": s.store_model,
        "marking": s.marking.banner(),
        "record": {
            "ledger_id": s.published.ledger_id, "seq": s.published.seq,
            "trail_hash": s.published.trail_hash, "signed_by": s.published.signed_by,
            "also_signed_by": s.published.also_signed_by, "time": s.published.time.utc(),
        },
    });
    serde_json::to_string(&object).map_err(|e| Error::environment("--json").found(e.to_string()))
}

/// Highest resident memory of this run, bytes; `None` where the system does not say.
fn peak_memory(s: &Summary) -> Option<u64> {
    s.done.timings.iter().map(|t| t.memory).chain([memory::peak()]).flatten().max()
}

/// What took the built-in networks' place, and what came of it.
fn networks(s: &Summary) -> String {
    let o = &s.done.sources;
    let mut words: Vec<String> = o.ran().map(|r| format!("{} ({})", r.manifest.id, r.runtime)).collect();
    if let Some((score, refined)) = o.mask_score {
        words.push(format!("mask score {score:.2}{}", if refined { ", refined" } else { "" }));
    }
    if o.mask_given {
        words.push("mask from a file".into());
    }
    match (&o.depth, o.depth_fit) {
        (Some(_), Some(fit)) => words.push(format!(
            "depth fits the surface at {:.0}% of its pixels, correlation {:.2}",
            fit.inliers * 100.0,
            fit.correlation
        )),
        (Some(_), None) => words.push("depth contradicts the surface and moved nothing".into()),
        _ => {}
    }
    if let Some(pose) = o.pose {
        let from = match (&o.views, o.tile_from_cache) {
            (None, _) => " from a file",
            (Some(_), true) => " kept from an earlier run",
            _ => "",
        };
        let normals = if o.normals_sha256.is_some() { " and their normals" } else { "" };
        let degrees = pose.elevation.to_degrees();
        words.push(format!(
            "six views{from}{normals}, the photo's camera {degrees:.0}° above the horizon, silhouettes consistent to {:.0}%",
            50.0 * (pose.filled + pose.kept)
        ));
    }
    words.join("; ")
}
