//! `orb bench run`: scores results, Orb's own or anyone's, over a folder of scenes.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use sha2::{Digest, Sha256};

use super::reconstruct;
use crate::audit::statement::{Input, Model, Param};
use crate::audit::{DataFolder, Marking, Publication, record, time};
use crate::bench::efficiency::Finding;
use crate::bench::evaluate::{Evaluation, Tools, evaluate};
use crate::bench::report::{self, Run as Told};
use crate::bench::scene::{self, Scene};
use crate::bench::score::{self, Values};
use crate::bench::submission::{self, FileFact};
use crate::cli::bar::Bar;
use crate::cli::marking;
use crate::cli::networks::{EngineArgs, registry};
use crate::cli::sealed::{Evidence, PublishArgs, SealedRun};
use crate::models::Graph;
use crate::progress::{Progress, Silent};
use crate::{Error, Result};

/// Score results over scenes: Orb's own, made now from each photo, or anyone's in a folder.
#[derive(Clone, Debug, clap::Args)]
pub struct Run {
    /// Scenes, or folders of scenes: of `orb bench make`, samples/truth, NeRF's transforms.json, COLMAP's sparse/0.
    #[arg(required = true, value_name = "SCENES")]
    pub scenes: Vec<PathBuf>,
    /// Results to be scored: NAME/, NAME.ply, NAME.spz or NAME.glb for every scene NAME. Without it, Orb reconstructs each
    /// scene's photo first, with the network removed.
    #[arg(long, value_name = "DIR")]
    pub results: Option<PathBuf>,
    /// Folder for the report: report.html, scores.json, scores.csv, marked and sealed.
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Whose results these are, for the report.
    #[arg(long, value_name = "NAME")]
    pub system: Option<String>,
    /// LPIPS as ONNX: inputs `ref` and `dist`, 1×3×H×W, normalised as for ImageNet; output the distance.
    #[arg(long, value_name = "FILE.onnx")]
    pub lpips: Option<PathBuf>,
    /// CLIP's image encoder as ONNX: 1×3×224×224 to `image_embeds`.
    #[arg(long, value_name = "FILE.onnx")]
    pub clip: Option<PathBuf>,
    /// Most pixels a side of the true pictures; larger ones are made smaller.
    #[arg(long, default_value_t = 800, value_parser = clap::value_parser!(u32).range(64..=8192))]
    pub pixels: u32,
    /// Quality of Orb's own reconstructions.
    #[arg(long, value_name = "QUALITY", default_value = "draft", value_parser = ["draft", "standard", "high"], conflicts_with = "results")]
    pub quality: String,
    /// Where to keep Orb's own results; must not exist yet. Default: they are removed in the end.
    #[arg(long, value_name = "DIR", conflicts_with = "results")]
    pub keep: Option<PathBuf>,
    /// Do not measure how fast results are drawn: then the same inputs give the same scores to the last digit.
    #[arg(long)]
    pub no_speed: bool,
    /// One JSON object instead of the table.
    #[arg(long, conflicts_with = "csv")]
    pub json: bool,
    /// Rows instead of the table.
    #[arg(long)]
    pub csv: bool,
    #[command(flatten)]
    pub engine: EngineArgs,
    #[command(flatten)]
    pub publish: PublishArgs,
}

/// A folder of this process that is gone when it is dropped.
struct Scratch(PathBuf);

impl Drop for Scratch {
    fn drop(&mut self) {
        // What cannot be removed lies in the system's folder for such things.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Where the results lie, and what Orb needs to make its own.
struct Results {
    folder: PathBuf,
    /// Only where Orb makes them.
    own: Option<Own>,
}

struct Own {
    scratch: Scratch,
    models: PathBuf,
    options: [String; 2],
}

/// What was read, and how it was marked.
#[derive(Default)]
struct Inputs {
    records: Vec<Input>,
    markings: Vec<Option<Marking>>,
}

impl Inputs {
    fn add(&mut self, name: &str, bytes: &[u8], role: &str) -> Result<()> {
        let own = marking::carried(name, bytes)?;
        self.records.push(record::input(name, bytes, media_type(name), role, own.clone()));
        self.markings.push(own);
        Ok(())
    }
}

/// Scores, prints and, with -o, publishes. `stop` is set by the interrupt handler.
///
/// # Errors
/// Usage for scenes, results and networks that cannot be used; policy for markings; `Cancelled`.
pub fn publish(args: &Run, stop: &AtomicBool) -> Result<u8> {
    if let Some(output) = &args.output {
        // The marking, and with it the publication, is known only when all inputs have been read.
        Publication::check(output, args.publish.replace)?;
    }
    let folders = scenes(&args.scenes)?;
    let data = DataFolder::from_environment(|name| std::env::var_os(name))?;
    let results = results(args, &data)?;
    let (lpips, clip) = (network(args, &data, &args.lpips)?, network(args, &data, &args.clip)?);
    let models: Vec<Model> = [("lpips", &lpips), ("clip", &clip)]
        .into_iter()
        .filter_map(|(id, n)| n.as_ref().map(|n| record::model(id, "", &n.sha256, n.size, &n.engine)))
        .collect();
    let tools = Tools {
        lpips: lpips.as_ref().map(|n| &*n.graph),
        clip: clip.as_ref().map(|n| &*n.graph),
        most_pixels: args.pixels,
        draw_for: (!args.no_speed).then_some(Duration::from_secs(1)),
    };
    let bar = Bar::new(stop, args.publish.quiet || args.json || args.csv);
    bar.begin("scenes", folders.len() as u64);
    let mut inputs = Inputs::default();
    let mut done: Vec<Evaluation> = Vec::new();
    for (i, folder) in folders.iter().enumerate() {
        bar.check()?;
        done.push(score_scene(&scene::read(folder)?, &results, &tools, &mut inputs)?);
        bar.step(i as u64 + 1);
    }
    bar.finish();
    let values: Vec<Values> = done.iter().map(|e| e.values.clone()).collect();
    let scores = score::add_up(&values);
    let handling = args.publish.marking.decide(&inputs.markings, &time::now()?.utc())?;
    let banner = handling.marking.banner();
    let system = match (&args.system, &results.own) {
        (Some(name), _) => name.clone(),
        (None, Some(_)) => format!("Orb {}, quality {}", env!("CARGO_PKG_VERSION"), args.quality),
        (None, None) => results.folder.file_name().unwrap_or_default().to_string_lossy().into_owned(),
    };
    let told = Told { scores: &scores, scenes: &done, system: &system, marking: &banner };
    let json = serde_json::to_string_pretty(&report::json(&told));
    let json = json.map_err(|e| Error::environment("--json").found(e.to_string()))? + "\n";
    if let Some(output) = &args.output {
        let mut sealed = SealedRun::begin("orb bench run", output, handling, &args.publish)?;
        sealed.publication.add("report.html", report::page(&told).as_bytes(), "text/html", "report")?;
        sealed.publication.add("scores.json", json.as_bytes(), "application/json", "scores")?;
        sealed.publication.add("scores.csv", report::csv(&told).as_bytes(), "text/csv", "scores")?;
        sealed.seal(Evidence {
            event_type: "bench.run",
            time: time::now()?,
            inputs: inputs.records,
            models,
            params: BTreeMap::from([
                ("system".into(), Param::Text(record::printable(&system))),
                ("scenes".into(), Param::Int(done.len() as i64)),
                ("pixels".into(), Param::Int(args.pixels.into())),
            ]),
        })?;
    }
    match (args.json, args.csv) {
        (true, _) => crate::cli::write_out(&json),
        (_, true) => crate::cli::write_out(&report::csv(&told)),
        _ => {
            crate::cli::write_out(&report::table(&told));
            if let Some(output) = &args.output {
                println!("report       {}", output.join("report.html").display());
            }
        }
    }
    Ok(0)
}

/// Anyone's results, or an empty folder for Orb's own.
fn results(args: &Run, data: &DataFolder) -> Result<Results> {
    if let Some(folder) = &args.results {
        return Ok(Results { folder: folder.clone(), own: None });
    }
    let scratch = Scratch(fresh_folder()?);
    let folder = args.keep.clone().unwrap_or_else(|| scratch.0.join("results"));
    std::fs::create_dir(&folder).map_err(|e| Error::io(&folder, &e).expected("a folder that does not exist yet"))?;
    let options = ["--quality".to_owned(), args.quality.clone()];
    Ok(Results { folder, own: Some(Own { scratch, models: registry(data).root().to_owned(), options }) })
}

/// One scene's metrics; what was read for them is added to `inputs`.
fn score_scene(scene: &Scene, results: &Results, tools: &Tools, inputs: &mut Inputs) -> Result<Evaluation> {
    for file in given(scene) {
        let bytes = std::fs::read(&file).map_err(|e| Error::io(&file, &e))?;
        let name = format!("{}/{}", scene.name, file.file_name().unwrap_or_default().to_string_lossy());
        inputs.add(&name, &bytes, "truth")?;
    }
    let mut cost = None;
    let mut failure = String::new();
    if let (Some(own), Some(photo)) = (&results.own, &scene.photo) {
        let (to, keys) = (results.folder.join(&scene.name), own.scratch.0.join("data"));
        match reconstruct::run(&photo.file, &to, &keys, &own.models, &own.options) {
            Ok(c) => cost = Some(c),
            Err(e) if e.kind == crate::Kind::Cancelled => return Err(Error::cancelled()),
            // A system that gives nothing gets nothing: the scene stays, without a value.
            Err(e) => failure = e.to_string(),
        }
    }
    let Some(path) = submission::find(&results.folder, &scene.name) else {
        return Ok(without_result(scene, &failure));
    };
    let mut result = submission::read(&path)?;
    if let Some(cost) = cost {
        (result.seconds, result.peak_memory_bytes) = (cost.seconds, cost.peak_memory_bytes);
        result.offline = cost.offline;
        result.files.extend(store_fact(&path));
    }
    for (name, bytes) in &result.inputs {
        inputs.add(&format!("{}/{name}", scene.name), bytes, "result")?;
    }
    evaluate(scene, &result, tools, &Silent)
}

/// Scenes as given, and the scenes inside of folders that are none, by name.
fn scenes(given: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let is_scene = |p: &Path| {
        ["scene.json", "cameras.json", "transforms.json", "transforms_test.json", "sparse"]
            .iter()
            .any(|f| p.join(f).exists())
    };
    let mut out = Vec::new();
    for folder in given {
        if is_scene(folder) {
            out.push(folder.clone());
            continue;
        }
        let entries = std::fs::read_dir(folder).map_err(|e| Error::io(folder, &e))?;
        let mut inside: Vec<PathBuf> = entries.filter_map(|e| Some(e.ok()?.path())).filter(|p| is_scene(p)).collect();
        inside.sort();
        if inside.is_empty() {
            return Err(Error::usage(folder.display().to_string())
                .expected("a scene or a folder of scenes")
                .found("none")
                .advice("`orb bench make -o DIR` makes some; docs/orb-bench.md has the layouts."));
        }
        out.extend(inside);
    }
    Ok(out)
}

/// The files of the truth that go into the record.
fn given(scene: &Scene) -> Vec<PathBuf> {
    let list = ["scene.json", "cameras.json", "transforms_test.json", "transforms.json"];
    let list = list.iter().map(|f| scene.folder.join(f)).find(|p| p.is_file());
    let mesh = Some(scene.folder.join("mesh.glb")).filter(|p| scene.surface.is_some() && p.is_file());
    let photo = scene.photo.as_ref().map(|p| p.file.clone());
    list.into_iter().chain(photo).chain(mesh).chain(scene.tests.iter().map(|v| v.file.clone())).collect()
}

fn without_result(scene: &Scene, failure: &str) -> Evaluation {
    let why = match (failure, &scene.photo) {
        ("", None) => "no photo to reconstruct: name results with --results".to_owned(),
        ("", Some(_)) => "no result for this scene".to_owned(),
        (said, _) => format!("no result: {said}"),
    };
    let missing = crate::bench::catalogue::METRICS.iter().map(|m| (m.id, why.clone())).collect();
    Evaluation { scene: scene.name.clone(), missing, ..Evaluation::default() }
}

/// The CDB store beside Orb's other files: one more deliverable.
fn store_fact(folder: &Path) -> Option<FileFact> {
    let entries = std::fs::read_dir(folder).ok()?;
    let store = entries.filter_map(|e| Some(e.ok()?.path())).find(|p| p.extension().is_some_and(|e| e == "cdb"))?;
    let args = crate::cli::cdb::CdbArgs {
        verb: crate::cli::cdb::CdbVerb::Check(crate::cli::cdb::CheckArgs { root: store.clone(), json: false }),
    };
    let finding = match crate::cli::cdb::run(&args) {
        Ok(outcome) if outcome.exit_code == 0 => Finding::Sound,
        Ok(outcome) => Finding::Broken(outcome.text),
        Err(e) => Finding::Broken(e.to_string()),
    };
    let name = store.file_name()?.to_string_lossy().into_owned();
    Some(FileFact { name, bytes: size(&store), finding: Some(finding) })
}

fn size(path: &Path) -> u64 {
    let Ok(entries) = std::fs::read_dir(path) else { return path.metadata().map_or(0, |m| m.len()) };
    entries.filter_map(|e| Some(size(&e.ok()?.path()))).sum()
}

fn media_type(name: &str) -> &'static str {
    match name.rsplit('.').next().unwrap_or_default() {
        "json" => "application/json",
        "png" => "image/png",
        "jpg" | "jpeg" => "image/jpeg",
        "ply" => "application/ply",
        "glb" => "model/gltf-binary",
        _ => "application/octet-stream",
    }
}

struct Network {
    graph: Box<dyn Graph>,
    sha256: String,
    size: u64,
    engine: String,
}

fn network(args: &Run, data: &DataFolder, file: &Option<PathBuf>) -> Result<Option<Network>> {
    let Some(file) = file else { return Ok(None) };
    let bytes = std::fs::read(file).map_err(|e| Error::io(file, &e))?;
    let engine = args.engine.open(data, &mut |_| {})?;
    let sha256 = hex::encode(Sha256::digest(&bytes));
    let graph = engine.load(&bytes)?;
    Ok(Some(Network { graph, sha256, size: bytes.len() as u64, engine: engine.name().to_owned() }))
}

/// A new folder in the system's place for such, unlike any other's.
fn fresh_folder() -> Result<PathBuf> {
    let mut random = [0; 8];
    getrandom::fill(&mut random).map_err(|e| Error::environment("random numbers").found(e.to_string()))?;
    let folder = std::env::temp_dir().join(format!("orb-bench-{}", hex::encode(random)));
    std::fs::create_dir(&folder).map_err(|e| Error::io(&folder, &e))?;
    Ok(folder)
}
