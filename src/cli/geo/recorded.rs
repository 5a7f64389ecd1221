//! What the record says of a run: the networks that ran, the parameters that were used.

use std::collections::BTreeMap;

use clap::ValueEnum;

use super::{GeoArgs, place};
use crate::audit::record;
use crate::audit::statement::{Model, Param};
use crate::cli::format::Format;
use crate::export::Catalogue;
use crate::models::{Engine, Rten, prior};
use crate::pipeline::{Reconstruction, Settings};
use crate::sources::Outcome;
use crate::symmetry::{self, Found};

/// What ran, pinned by the weights' SHA-256, and what the paper names and this run did without.
/// `device`: where the Gaussians were optimised.
/// `colmap`: its version, where it ran.
pub fn models(outcome: &Outcome, device: &str, colmap: Option<&str>) -> Vec<Model> {
    let mut all = Vec::from(
        [&prior::SCENE, &prior::DETAIL, &prior::SPLAT]
            .map(|p| record::model(p.id, p.version, p.sha256, p.onnx.len() as u64, Rten.name())),
    );
    all.extend(
        outcome
            .ran()
            .map(|ran| Model { runtime: Some(ran.runtime.clone()), ..crate::cli::models::recorded(&ran.manifest) }),
    );
    // The optimisation: a program, no weights; its version is the program's.
    all.push(Model {
        status: None,
        version: Some(env!("CARGO_PKG_VERSION").into()),
        runtime: Some(device.into()),
        pin_source: Some("built-in".into()),
        ..record::model_not_used("orb-splat-core")
    });
    let papers = [("sam2", &outcome.mask), ("depth-anything-v2", &outcome.depth), ("zero123pp", &outcome.views)];
    all.extend(papers.iter().filter(|(_, ran)| ran.is_none()).map(|(id, _)| record::model_not_used(id)));
    all.push(record::model_not_used("gsplat"));
    all.push(match colmap {
        None => record::model_not_used("colmap"),
        Some(version) => Model {
            status: None,
            version: Some(version.into()),
            runtime: Some("cpu".into()),
            pin_source: Some("program of this machine".into()),
            ..record::model_not_used("colmap")
        },
    });
    all
}

/// Parameters of the predicate.
pub fn params(
    args: &GeoArgs,
    settings: &Settings,
    done: &Reconstruction,
    placed: &place::Placed,
    catalogue: &Catalogue,
    line: Option<&str>,
) -> BTreeMap<String, Param> {
    let text = |v: String| Param::Text(v);
    let mut all = BTreeMap::from([
        ("seed".into(), text(args.seed.to_string())),
        ("formats".into(), text(Format::names(&args.format))),
        ("device".into(), text(done.report.device.clone())),
        ("lods".into(), Param::Int(args.lods.into())),
        ("levels_made".into(), Param::Int(done.model.levels.len() as i64)),
        ("iterations_planned".into(), Param::Int(settings.iterations.into())),
        ("iterations_run".into(), Param::Int(done.report.iterations as i64)),
        ("stopped_by_time".into(), Param::Bool(done.report.stopped_by_deadline)),
        ("elevation_deg".into(), text(format!("{:.2}", done.prior.seen_from.mean.to_degrees()))),
        ("elevation_expected_error_deg".into(), text(format!("{:.2}", done.prior.seen_from.spread.to_degrees()))),
    ]);
    all.extend(args.write.params(catalogue));
    all.extend(placed.params(line));
    all.extend(done.settled.iter().map(|r| ("settling_iterations_run".into(), Param::Int(r.iterations as i64))));
    all.extend(args.photos.params());
    let sources = &done.sources;
    let mut add = |name: &str, value: Option<Param>| {
        if let Some(value) = value {
            all.insert(name.to_owned(), value);
        }
    };
    for (i, level) in done.model.levels.iter().enumerate() {
        let metres = |v: f32| Some(text(format!("{:.5}", f64::from(v) * placed.scale.metres_per_unit)));
        add(&format!("level_{i}_vertices"), Some(Param::Int(level.mesh.positions.len() as i64)));
        add(&format!("level_{i}_triangles"), Some(Param::Int(level.mesh.triangles.len() as i64)));
        add(&format!("level_{i}_largest_error_m"), metres(level.error));
        add(&format!("level_{i}_mean_error_m"), metres(level.mean_error));
    }
    let share = |v: f32| Some(text(format!("{v:.4}")));
    if let Some(finest) = done.model.levels.first() {
        add("texture_seen", share(finest.seen));
        add("texture_mirrored", share(finest.mirrored));
        add("texture_invented", share(1.0 - finest.seen - finest.mirrored));
    }
    let roll = done.subject.roll.to_degrees();
    add("camera_roll_by_surroundings_deg", Some(text(format!("{roll:.2}"))));
    if let Some(turned) = done.prior.crop.turned {
        add("camera_turned_deg", Some(text(format!("{:.2}", turned.angle().to_degrees()))));
        add("camera_turned_by_assumed_lens", Some(Param::Bool(turned.lens_assumed)));
    }
    add("files_as_of", args.as_of.clone().map(text));
    add("symmetry", args.symmetry.to_possible_value().map(|v| text(v.get_name().to_owned())));
    let planes = symmetry::used(&done.symmetry).len();
    add("symmetry_applied", Some(Param::Bool(planes > 0)));
    add("symmetry_planes_used", Some(Param::Int(planes as i64)));
    for (Found { fit, plane, basis }, which) in done.symmetry.iter().zip(["symmetry", "symmetry_second"]) {
        let n = fit.plane.normal;
        add(&format!("{which}_basis"), basis.map(|b| text(b.label().to_owned())));
        let bearing = f64::from(n.x.atan2(n.y)).to_degrees() + placed.placement.heading;
        let distance = f64::from(fit.shape) * placed.scale.metres_per_unit;
        add(&format!("{which}_plane_normal_bearing_deg"), Some(text(format!("{:.1}", bearing.rem_euclid(360.0)))));
        add(&format!("{which}_shape_distance_m"), Some(text(format!("{distance:.4}"))));
        // Against the shape's choice; away from the photo's camera is below 0.
        let moved = f64::from(plane.offset - fit.plane.offset) * placed.scale.metres_per_unit;
        add(&format!("{which}_moved_m"), basis.map(|_| text(format!("{moved:.4}"))));
        add(&format!("{which}_contradicted"), share(fit.contradicted));
        add(&format!("{which}_colour_difference"), share(fit.color));
        add(&format!("{which}_silhouette_iou"), share(fit.silhouette));
        add(&format!("{which}_extent_across_over_along"), share(fit.elongation));
        add(&format!("{which}_far_from_its_image"), share(fit.stray));
    }
    add("expected_colour_error", done.expected_error.as_ref().and_then(|e| share(e.mean)));
    add("mask_expected_iou", done.subject.expected_iou.and_then(share));
    add("mask_score", sources.mask_score.map(|(score, _)| text(format!("{score:.4}"))));
    add("mask_refined", sources.mask_score.map(|(_, refined)| Param::Bool(refined)));
    add("depth_used", sources.depth.as_ref().map(|_| Param::Bool(sources.depth_fit.is_some())));
    add("six_views_sha256", sources.tile_sha256.clone().map(text));
    add("six_views_from_cache", sources.views.as_ref().map(|_| Param::Bool(sources.tile_from_cache)));
    add("six_normals_sha256", sources.normals_sha256.clone().map(text));
    add("diffusion_steps", sources.views.as_ref().map(|_| Param::Int(args.networks.diffusion_steps.into())));
    for timing in &done.timings {
        let name = format!("peak_memory_mib_{}", timing.stage.replace(' ', "_").to_lowercase());
        add(&name, timing.memory.map(|bytes| Param::Int((bytes >> 20) as i64)));
    }
    let on_gpu = Some(done.report.peak_bytes).filter(|bytes| *bytes > 0);
    add("peak_gpu_memory_mib_optimisation", on_gpu.map(|bytes| Param::Int((bytes >> 20) as i64)));
    all
}
