//! `orb bench mesh`: how true the model of a photo is, where the truth is known.

use std::path::PathBuf;

use serde_json::{Value, json};

use super::compare::{self, Shape};
use super::truth::{self, Truth};
use crate::mesh::{self, Level, Surface};
use crate::models::Rten;
use crate::photo;
use crate::pipeline::{self, Settings};
use crate::progress::Progress;
use crate::sources::Sources;
use crate::splat::{self, Camera, Gaussians};
use crate::symmetry::Use;
use crate::{Error, Result, views};

/// Compare models of photos with the meshes that the photos were made from.
#[derive(Clone, Debug, clap::Args)]
pub struct MeshBench {
    /// Folders with `mesh.glb` and `cameras.json`, such as samples/truth/smart_car.
    #[arg(required = true)]
    pub truths: Vec<PathBuf>,
    /// Optimisation steps.
    #[arg(long, default_value_t = 600)]
    pub iterations: u32,
    /// Only with or only without the plane of symmetry; default: as `orb geo` decides.
    #[arg(long, value_enum, default_value = "auto")]
    pub symmetry: crate::cli::geo::Symmetry,
    /// One JSON object instead of a table.
    #[arg(long)]
    pub json: bool,
}

/// Measures every subject; what is to be printed on stdout.
///
/// Errors: usage for truths or photos that cannot be read, and what the reconstruction says.
pub fn run(args: &MeshBench, progress: &dyn Progress) -> Result<String> {
    let mut rows = Vec::new();
    for folder in &args.truths {
        progress.check()?;
        rows.push(measure(&truth::read(folder)?, args, progress)?);
    }
    if args.json {
        return Ok(format!("{}\n", json!({ "subjects": rows })));
    }
    let mut out = String::from(
        "subject               symmetry  mesh s  Chamfer %  F 1%   F 2%   | Gaussians: Chamfer %  F 1%   F 2%   | finest dB  coarsest dB | seen mirrored invented\n",
    );
    for r in &rows {
        let n = |path: &str| r.pointer(path).and_then(Value::as_f64).unwrap_or(f64::NAN);
        out += &format!(
            "{:<21} {:<8} {:>7.1} {:>10.2} {:>6.3} {:>6.3} | {:>20.2} {:>6.3} {:>6.3} | {:>9.1} {:>12.1} | {:>4.2} {:>8.2} {:>8.2}\n",
            r["name"].as_str().unwrap_or(""),
            r["symmetry"]["applied"].to_string(),
            n("/mesh_seconds"),
            n("/mesh/chamfer") * 100.0,
            n("/mesh/f1"),
            n("/mesh/f2"),
            n("/gaussians/chamfer") * 100.0,
            n("/gaussians/f1"),
            n("/gaussians/f2"),
            n("/finest_db"),
            n("/coarsest_db"),
            n("/texture/seen"),
            n("/texture/mirrored"),
            n("/texture/invented"),
        );
    }
    Ok(out)
}

fn measure(truth: &Truth, args: &MeshBench, progress: &dyn Progress) -> Result<Value> {
    let bytes = std::fs::read(&truth.photo).map_err(|e| Error::io(&truth.photo, &e))?;
    let photo = photo::decode(&truth.name, &bytes, &photo::Limits::default())?;
    let settings = Settings {
        iterations: args.iterations,
        optimise_within: None,
        deadline: None,
        seed: 0,
        levels: 4,
        symmetry: Use::from(args.symmetry),
    };
    let done = pipeline::reconstruct(&photo, &Rten, &Sources::default(), &settings, progress)?;
    let finest = &done.model.levels[0];
    let own = Surface { positions: finest.mesh.positions.clone(), triangles: finest.mesh.triangles.clone() };
    let shape = Shape::of_surface(&own);
    let moved = compare::aligned(&truth.surface, truth.forward, &shape);
    let true_shape = Shape::of_surface(&moved);
    let (low, high) = moved.bounds();
    let scores = |found: &Shape| {
        let s = compare::scores(found, &true_shape, low.distance(high));
        json!({ "chamfer": s.chamfer, "f1": s.f[0], "f2": s.f[1] })
    };
    let gaussians = Shape::of_depth(|camera| {
        let frame = splat::render(&done.gaussians, camera, [0.5; 3]);
        frame.alpha.iter().zip(&frame.median_depth).map(|(a, z)| if *a > 0.5 { *z } else { 0.0 }).collect()
    });
    let levels_of: Vec<Value> = std::env::var("LEVELS").unwrap_or_default().split(',').filter_map(|v| v.parse::<f32>().ok()).map(|level| {
        let start = std::time::Instant::now();
        let s = mesh::opacity::surface(&done.gaussians, 144, level);
        let seconds = start.elapsed().as_secs_f64();
        let mut v = scores(&Shape::of_surface(&s));
        v["level"] = level.into();
        v["seconds"] = seconds.into();
        v
    }).collect();
    let raw = scores(&Shape::of_surface(&done.model.surface));
    let last = &done.model.levels[done.model.levels.len() - 1];
    // From where the next finer level takes over: one pixel is then as large as what the two differ by.
    let switch = done.model.levels.iter().rev().nth(1).map_or(0.01, |l| l.error_to_coarser);
    let far = (2.0 * views::DISTANCE * (views::FOV / 2.0).tan() / switch).clamp(8.0, 256.0) as u32;
    let mesh_seconds: f64 =
        done.timings.iter().filter(|t| t.stage.starts_with("mesh")).map(|t| t.time.as_secs_f64()).sum();
    let levels: Vec<Value> = done
        .model
        .levels
        .iter()
        .map(|l| {
            json!({
                "vertices": l.mesh.positions.len(), "triangles": l.mesh.triangles.len(),
                "error": l.error, "error_to_coarser": l.error_to_coarser, "atlas_use": atlas_use(l),
            })
        })
        .collect();
    Ok(json!({
        "name": truth.name,
        "mesh_seconds": mesh_seconds,
        "symmetry": { "applied": done.symmetry.applied, "fit": done.symmetry.fit.map(|f| json!({
            "normal": f.plane.normal.to_array(), "offset": f.plane.offset, "shape": f.shape, "contradicted": f.contradicted,
            "color": f.color, "pairs": f.pairs, "hidden": f.hidden, "silhouette": f.silhouette })) },
        "mesh": scores(&shape),
        "gaussians": scores(&gaussians),
        "opacity": levels_of, "raw": raw,
        "finest_db": psnr(&done.gaussians, finest, 256),
        "coarsest_db": psnr(&done.gaussians, last, far),
        "coarsest_pixels": far,
        "texture": { "seen": finest.seen, "mirrored": finest.mirrored, "invented": 1.0 - finest.seen - finest.mirrored },
        "levels": levels,
    }))
}

/// Share of the texture under triangles.
fn atlas_use(level: &Level) -> f32 {
    let uv = &level.mesh.uvs;
    let twice = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| uv[i as usize]);
        (b - a).perp_dot(c - a).abs()
    };
    level.mesh.triangles.iter().map(twice).sum::<f32>() / 2.0
}

/// A level against the Gaussians, drawn on grey `size` pixels across from 12 sides: the mean picture's PSNR, dB.
fn psnr(g: &Gaussians, level: &Level, size: u32) -> f64 {
    let cameras: Vec<Camera> =
        (0..12).map(|k| views::orbit(30.0 * k as f32, [20.0, -10.0, 40.0][k % 3], views::DISTANCE, size)).collect();
    let error: f64 = cameras
        .iter()
        .map(|camera| {
            let frame = splat::render(g, camera, [0.5; 3]);
            let drawn = mesh::raster(&level.mesh, Some(&level.texture), camera, [128; 3], 3);
            let pixels = drawn.pixels().zip(&frame.color);
            let sum: f64 = pixels
                .flat_map(|(a, b)| {
                    (0..3).map(move |k| f64::from(f32::from(a.0[k]) / 255.0 - b[k].clamp(0.0, 1.0)).powi(2))
                })
                .sum();
            sum / (3 * size * size) as f64
        })
        .sum();
    -10.0 * (error / cameras.len() as f64).max(1e-12).log10()
}
