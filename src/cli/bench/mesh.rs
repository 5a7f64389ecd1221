//! `orb bench mesh`: how true the model of a photo is, where the truth is known.

use std::path::PathBuf;

use serde_json::{Value, json};

use crate::bench::surfaces::{self as compare, Shape, Similarity};
use crate::bench::truth::{self, Truth};
use crate::mesh::{self, Level, Surface};
use crate::models::Rten;
use crate::photo;
use crate::pipeline::{self, Settings};
use crate::progress::{Progress, Silent};
use crate::sources::Sources;
use crate::splat::train::Kept;
use crate::splat::{self, Camera, Gaussians};
use crate::symmetry::{Basis, Found, Use};
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
    Ok(table(&rows))
}

/// What a column shows: title, where in a row, times what, decimals.
const COLUMNS: [(&str, &str, f64, usize); 22] = [
    ("seconds", "/mesh_seconds", 1.0, 1),
    ("mesh Ch%", "/mesh/chamfer", 100.0, 2),
    ("F1%", "/mesh/f1", 1.0, 3),
    ("F2%", "/mesh/f2", 1.0, 3),
    ("splats Ch%", "/gaussians/chamfer", 100.0, 2),
    ("F1%", "/gaussians/f1", 1.0, 3),
    ("F2%", "/gaussians/f2", 1.0, 3),
    ("level set Ch%", "/opacity_level_set/chamfer", 100.0, 2),
    ("F1%", "/opacity_level_set/f1", 1.0, 3),
    ("F2%", "/opacity_level_set/f2", 1.0, 3),
    ("near dB", "/views/near_db", 1.0, 2),
    ("far dB", "/views/back_db", 1.0, 2),
    ("IoU", "/views/iou", 1.0, 3),
    ("finest dB", "/finest_db", 1.0, 1),
    ("own dB", "/finest_own_colours_db", 1.0, 1),
    ("inside dB", "/finest_inside_db", 1.0, 1),
    ("coarsest dB", "/coarsest_db", 1.0, 1),
    ("atlas", "/levels/0/atlas_use", 1.0, 2),
    ("seams", "/levels/0/seams/mean", 1.0, 2),
    ("seen", "/texture/seen", 1.0, 2),
    ("mirrored", "/texture/mirrored", 1.0, 2),
    ("invented", "/texture/invented", 1.0, 2),
];

/// Pixels across the pictures that levels are compared in.
const LARGE: u32 = 256;

fn table(rows: &[Value]) -> String {
    let titles: Vec<&str> = COLUMNS.iter().map(|c| c.0).collect();
    let mut out = format!("{:<20}  {}\n", "subject", titles.join("  "));
    for r in rows {
        out += &format!("{:<20}", r["name"].as_str().unwrap_or(""));
        for (title, path, factor, decimals) in COLUMNS {
            let width = title.len() + 2;
            match r.pointer(path).and_then(Value::as_f64) {
                Some(v) => out += &format!("{:>width$.decimals$}", v * factor),
                None => out += &format!("{:>width$}", "-"),
            }
        }
        out.push('\n');
    }
    out
}

fn measure(truth: &Truth, args: &MeshBench, progress: &dyn Progress) -> Result<Value> {
    let bytes = std::fs::read(&truth.photo).map_err(|e| Error::io(&truth.photo, &e))?;
    let photo = photo::decode(&truth.name, &bytes, &photo::Limits::default())?;
    let settings = Settings {
        iterations: args.iterations,
        optimise_within: None,
        deadline: None,
        seed: 0,
        pitch: None,
        levels: 4,
        triangles: None,
        in_store: false,
        texture: 1024,
        normal_map: false,
        occlusion: false,
        symmetry: Use::from(args.symmetry),
        kept: Kept::default(),
    };
    let done = pipeline::reconstruct(&photo, &Rten, &Sources::default(), splat::Engine::Cpu, &settings, progress)?;
    let finest = &done.model.levels[0];
    let own = Surface { positions: finest.mesh.positions.clone(), triangles: finest.mesh.triangles.clone() };
    let shape = Shape::of_surface(&own);
    let place = compare::aligned(&truth.surface, truth.forward, &shape);
    let moved = place.surface(&truth.surface);
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
    let opacity = mesh::opacity::surface(&done.gaussians, mesh::Options::default().voxels, mesh::opacity::LEVEL);
    let last = &done.model.levels[done.model.levels.len() - 1];
    // From where the next finer level takes over: one pixel is then as large as what the two differ by.
    let switch = done.model.levels.iter().rev().nth(1).map_or(0.01, |l| l.error_to_coarser);
    let far = (2.0 * views::DISTANCE * (views::FOV / 2.0).tan() / switch).clamp(8.0, LARGE as f32) as u32;
    let mesh_seconds: f64 =
        done.timings.iter().filter(|t| t.stage.starts_with("mesh")).map(|t| t.time.as_secs_f64()).sum();
    let levels: Vec<Value> = done
        .model
        .levels
        .iter()
        .map(|l| {
            json!({
                "vertices": l.mesh.positions.len(), "triangles": l.mesh.triangles.len(),
                "error": l.error, "mean_error": l.mean_error, "error_to_coarser": l.error_to_coarser, "atlas_use": atlas_use(l),
                "seams": seam_steps(l),
            })
        })
        .collect();
    Ok(json!({
        "name": truth.name,
        "mesh_seconds": mesh_seconds,
        "symmetry": done.symmetry.iter().map(|found @ Found { fit: f, plane, basis }| json!({
            "used": found.used(), "basis": basis.map(Basis::label), "normal": plane.normal.to_array(), "offset": plane.offset,
            "offset_by_shape": f.plane.offset, "shape": f.shape,
            "contradicted": f.contradicted, "color": f.color, "pairs": f.pairs, "hidden": f.hidden,
            "silhouette": f.silhouette, "elongation": f.elongation, "stray": f.stray })).collect::<Vec<_>>(),
        "mesh": scores(&shape),
        "gaussians": scores(&gaussians),
        "opacity_level_set": scores(&Shape::of_surface(&opacity)),
        "views": against_views(truth, &place, finest)?,
        "finest_db": psnr(&done.gaussians, finest, LARGE, 0.0),
        "finest_own_colours_db": psnr(&done.gaussians, &own_colors(&done.gaussians, finest)?, LARGE, 0.0),
        "finest_inside_db": psnr(&done.gaussians, finest, LARGE, 0.98),
        "coarsest_db": psnr(&done.gaussians, last, far, 0.0),
        "coarsest_pixels": far,
        "texture": { "seen": finest.seen, "mirrored": finest.mirrored, "invented": 1.0 - finest.seen - finest.mirrored },
        "levels": levels,
    }))
}

/// The finest level against true pictures, over white: PSNR of whole pictures (dB) within 60° of the photo and beyond, of
/// the colours alone where both show the subject, and the silhouettes' mean intersection over union.
fn against_views(truth: &Truth, place: &Similarity, level: &Level) -> Result<Value> {
    const SIZE: u32 = 128;
    let (mut near, mut back, mut colors, mut ious) = (Vec::new(), Vec::new(), [0.0, 0.0], Vec::new());
    for view in &truth.views {
        let picture = image::open(&view.file)
            .map_err(|e| Error::usage(view.file.display().to_string()).expected("a picture").found(e.to_string()))?;
        let rgba = image::imageops::thumbnail(&picture.into_rgba8(), SIZE, SIZE);
        let camera = place.camera(&view.camera.resized(SIZE, SIZE));
        let white = mesh::raster(&level.mesh, Some(&level.texture), &camera, [255; 3], 2);
        let black = mesh::raster(&level.mesh, Some(&level.texture), &camera, [0; 3], 2);
        let (mut sum, mut both, mut either) = (0.0, 0u32, 0u32);
        for ((t, w), b) in rgba.pixels().zip(white.pixels()).zip(black.pixels()) {
            let alpha = f64::from(t.0[3]) / 255.0;
            let error: f64 = (0..3)
                .map(|k| {
                    let shown = f64::from(t.0[k]) / 255.0 * alpha + 1.0 - alpha;
                    (shown - f64::from(w.0[k]) / 255.0).powi(2)
                })
                .sum();
            sum += error;
            // Covered: what is behind does not show through.
            let (own, true_one) = (w.0[0].abs_diff(b.0[0]) < 64, alpha > 0.5);
            both += u32::from(own && true_one);
            either += u32::from(own || true_one);
            if own && alpha > 0.99 {
                colors[0] += error;
                colors[1] += 3.0;
            }
        }
        let db = -10.0 * (sum / f64::from(3 * SIZE * SIZE)).max(1e-10).log10();
        if view.away <= 60.0 {
            near.push(db)
        } else {
            back.push(db)
        }
        ious.push(f64::from(both) / f64::from(either.max(1)));
    }
    let mean = |v: &[f64]| (!v.is_empty()).then(|| v.iter().sum::<f64>() / v.len() as f64);
    let color = (colors[1] > 0.0).then(|| -10.0 * (colors[0] / colors[1]).log10());
    Ok(json!({ "near_db": mean(&near), "back_db": mean(&back), "color_db": color, "iou": mean(&ious) }))
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

/// How far the colours of neighbouring charts are apart, in steps of 255.
fn seam_steps(level: &Level) -> Value {
    let s = mesh::seams::seams(&level.mesh, &level.texture);
    json!({ "mean": s.mean, "most": s.most, "length": s.length })
}

/// The level with nothing but the Gaussians' colours. Where the photo's own pixels are in the texture, the model shows what
/// the Gaussians themselves show from the photo's side alone, and differs from their other pictures for that.
fn own_colors(g: &Gaussians, level: &Level) -> Result<Level> {
    let drawers = splat::render::Drawers::with_surface(g, mesh::FIRM);
    let render = |camera: &Camera| mesh::View::drawn(&drawers, camera, [0.5; 3]);
    let options = mesh::Options { background: [0.5; 3], ..mesh::Options::default() };
    let baked = mesh::bake::bake(&level.mesh, level.texture.width(), &render, &[], &options, &Silent)?;
    Ok(Level { texture: baked.image(), ..level.clone() })
}

/// A level against the Gaussians, both drawn on grey `size` pixels across from 12 sides: PSNR (dB) of the pixels at least so
/// opaque. Small pictures are means of large ones: a renderer of Gaussians widens each to a pixel at least, so that its own
/// small pictures show a fatter subject.
fn psnr(g: &Gaussians, level: &Level, size: u32, opaque: f32) -> f64 {
    let finer = LARGE.div_ceil(size);
    let camera = |k: usize| views::orbit(30.0 * k as f32, [20.0, -10.0, 40.0][k % 3], views::DISTANCE, size * finer);
    let (mut sum, mut count) = (0.0, 0.0);
    for camera in (0..12).map(camera) {
        let frame = splat::render(g, &camera, [0.5; 3]);
        let drawn = mesh::raster(&level.mesh, Some(&level.texture), &camera, [128; 3], 3);
        let shown: Vec<[f32; 4]> = frame
            .color
            .iter()
            .zip(&frame.alpha)
            .map(|(c, a)| [c[0], c[1], c[2], *a].map(|v| v.clamp(0.0, 1.0)))
            .collect();
        let own: Vec<[f32; 4]> =
            drawn.pixels().map(|p| [p.0[0], p.0[1], p.0[2], 255].map(|v| f32::from(v) / 255.0)).collect();
        for (a, b) in shrunk(&own, size, finer).iter().zip(shrunk(&shown, size, finer)) {
            if b[3] >= opaque {
                sum += (0..3).map(|k| f64::from(a[k] - b[k]).powi(2)).sum::<f64>();
                count += 3.0;
            }
        }
    }
    -10.0 * (sum / f64::max(count, 1.0)).max(1e-12).log10()
}

/// Means of `by` × `by` pixels of a square picture; `size` across is what is left.
fn shrunk(picture: &[[f32; 4]], size: u32, by: u32) -> Vec<[f32; 4]> {
    let (size, by) = (size as usize, by as usize);
    let mut small = vec![[0.0; 4]; size * size];
    for (i, pixel) in picture.iter().enumerate() {
        let (x, y) = (i % (size * by) / by, i / (size * by) / by);
        small[y * size + x].iter_mut().zip(pixel).for_each(|(sum, v)| *sum += v / (by * by) as f32);
    }
    small
}
