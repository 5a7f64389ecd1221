//! Poses by the `colmap` program of this machine (Schönberger and Frahm 2016): features, matches, sparse model, on the CPU and
//! without a display.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::progress::Progress;
use crate::{Error, Result};

/// As many photos are matched each with each; more, each with its neighbours in the order of their names.
const EACH_WITH_EACH: usize = 200;

/// What ran.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// `COLMAP 3.8`.
    pub version: String,
    /// The commands, with the work folder as `WORK`.
    pub commands: Vec<String>,
    /// The folder of its models.
    pub models: PathBuf,
}

/// A folder that is gone when this is.
struct Work(PathBuf);

impl Work {
    /// Makes it, for this user alone: what it is given are photos, and what is read of it becomes poses. One that is there
    /// is somebody else's.
    fn make(path: &Path) -> Result<Work> {
        #[cfg_attr(not(unix), allow(unused_mut))]
        let mut folder = std::fs::DirBuilder::new();
        #[cfg(unix)]
        std::os::unix::fs::DirBuilderExt::mode(&mut folder, 0o700);
        match folder.create(path) {
            Ok(()) => Ok(Work(path.to_owned())),
            Err(e) => Err(Error::io(path, &e)
                .expected("a work folder that is not there yet")
                .advice("Set TMPDIR to a folder where this user may write.")),
        }
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        // Nothing depends on it any more; what cannot be removed stays for the system to clear.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// One camera for all photos: width, height, focal length in pixels where it is known.
pub type Shared = Option<(u32, u32, Option<f64>)>;

/// What the program calls itself.
///
/// # Errors
/// Environment where it cannot be started.
pub fn version(program: &Path) -> Result<String> {
    let told = command(program).arg("help").output().map_err(|e| {
        Error::environment("--sfm colmap")
            .expected(format!("the program {}", program.display()))
            .found(e.to_string())
            .advice("Install COLMAP (Debian: apt-get install --no-install-recommends colmap), or give --poses.")
    })?;
    let text = String::from_utf8_lossy(&told.stdout).into_owned();
    let line = text.lines().find(|l| l.contains("COLMAP")).unwrap_or("COLMAP");
    Ok(line.split(" -- ").next().unwrap_or(line).trim().to_owned())
}

fn command(program: &Path) -> Command {
    let mut c = Command::new(program);
    // It links Qt and would look for a display.
    c.env("QT_QPA_PLATFORM", "offscreen").stdin(Stdio::null());
    c
}

/// Runs the program on photos in a folder `work` of its own, which must not exist and is removed afterwards; `read` is given
/// what came of it before that.
///
/// # Errors
/// Environment where the program is missing or fails, with its last words, or `work` exists; usage where it finds no model; `Cancelled`.
pub fn run<T>(
    program: &Path,
    photos: &[PathBuf],
    shared: Shared,
    work: &Path,
    progress: &dyn Progress,
    read: impl FnOnce(&Run) -> Result<T>,
) -> Result<T> {
    let version = version(program)?;
    let held = Work::make(work)?;
    let images = work.join("images");
    std::fs::create_dir(&images).map_err(|e| Error::io(&images, &e))?;
    for photo in photos {
        let name = photo.file_name().unwrap_or_default();
        let whole = photo.canonicalize().map_err(|e| Error::io(photo, &e))?;
        std::fs::copy(&whole, images.join(name)).map_err(|e| Error::io(photo, &e))?;
    }
    let models = work.join("sparse");
    std::fs::create_dir_all(&models).map_err(|e| Error::io(&models, &e))?;
    let at = |name: &str| work.join(name).to_string_lossy().into_owned();
    let threads = std::thread::available_parallelism().map_or(1, usize::from).to_string();
    let mut features: Vec<String> =
        ["feature_extractor", "--database_path", &at("database.db"), "--image_path", &at("images")]
            .map(str::to_owned)
            .to_vec();
    features.extend(["--SiftExtraction.use_gpu", "0", "--SiftExtraction.num_threads", &threads].map(str::to_owned));
    features.extend(["--ImageReader.camera_model", "SIMPLE_RADIAL"].map(str::to_owned));
    if let Some((width, height, focal)) = shared {
        features.extend(["--ImageReader.single_camera", "1"].map(str::to_owned));
        if let Some(f) = focal {
            let inside = format!("{f},{},{},0", f64::from(width) / 2.0, f64::from(height) / 2.0);
            features.extend(["--ImageReader.camera_params".to_owned(), inside]);
        }
    }
    let matcher = if photos.len() <= EACH_WITH_EACH { "exhaustive_matcher" } else { "sequential_matcher" };
    let matches = [
        matcher,
        "--database_path",
        &at("database.db"),
        "--SiftMatching.use_gpu",
        "0",
        "--SiftMatching.num_threads",
        &threads,
    ]
    .map(str::to_owned)
    .to_vec();
    let mapper = [
        "mapper",
        "--database_path",
        &at("database.db"),
        "--image_path",
        &at("images"),
        "--output_path",
        &at("sparse"),
    ];
    let mapper = [&mapper[..], &["--Mapper.num_threads", &threads]].concat().into_iter().map(str::to_owned).collect();
    let shown = work.to_string_lossy().into_owned();
    let mut commands = Vec::new();
    for arguments in [features, matches, mapper] {
        one(program, &arguments, work, progress)?;
        commands.push(format!("colmap {}", arguments.join(" ").replace(&shown, "WORK")));
    }
    let any = std::fs::read_dir(&models).map_err(|e| Error::io(&models, &e))?.next().is_some();
    if !any {
        return Err(Error::usage("--sfm colmap")
            .expected("photos that overlap, with texture to hold on to")
            .found(format!("no two of {} that {version} could place", photos.len()))
            .advice("Take photos at most 20° apart, sharp, with textured ground around the subject."));
    }
    let out = read(&Run { version, commands, models });
    drop(held);
    out
}

/// One command, its words kept in a file; killed where the user stops.
fn one(program: &Path, arguments: &[String], work: &Path, progress: &dyn Progress) -> Result<()> {
    progress.begin("COLMAP", 0);
    let step = &arguments[0];
    let log = work.join(format!("{step}.log"));
    let file = File::create(&log).map_err(|e| Error::io(&log, &e))?;
    let both = file.try_clone().map_err(|e| Error::io(&log, &e))?;
    let mut child = command(program)
        .args(arguments)
        .stdout(file)
        .stderr(both)
        .spawn()
        .map_err(|e| Error::environment(format!("colmap {step}")).found(e.to_string()))?;
    let status = loop {
        match child.try_wait().map_err(|e| Error::environment(format!("colmap {step}")).found(e.to_string()))? {
            Some(status) => break status,
            None if progress.cancelled() => {
                // It may have ended by itself meanwhile.
                let _ = child.kill();
                let _ = child.wait();
                return Err(Error::cancelled());
            }
            None => std::thread::sleep(Duration::from_millis(50)),
        }
    };
    if status.success() {
        return Ok(());
    }
    let said = std::fs::read(&log).unwrap_or_default();
    let said = String::from_utf8_lossy(&said).into_owned();
    let last: Vec<&str> = said.lines().map(str::trim).filter(|l| !l.is_empty()).rev().take(3).collect();
    // The mapper ends so where it finds no pair to begin with.
    let none = ["No good initial image pair", "No images with matches", "failed to create sparse model"];
    let nothing = step == "mapper" && none.iter().any(|n| said.contains(n));
    let e = if nothing { Error::usage("--sfm colmap") } else { Error::environment(format!("colmap {step}")) };
    Err(e
        .expected(if nothing { "photos that overlap" } else { "an end without errors" })
        .found(format!("{status}; it says: {}", last.into_iter().rev().collect::<Vec<_>>().join(" / ")))
        .advice("The same command by hand says more; --poses takes a model that was made elsewhere."))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::Marking;
    use crate::bench::make;
    use crate::geo::similarity::{Pair, Turn, fit};
    use crate::photos::poses;
    use crate::progress::Silent;
    use crate::splat::cameras;

    /// Photos of a made van with COLMAP: poses against the truth, by the similarity between both worlds.
    #[test]
    fn colmap_finds_the_true_poses() {
        let program = Path::new("colmap");
        if version(program).is_err() {
            let needed = std::env::var_os("ORB_REQUIRE_CLIENTS").is_some();
            assert!(!needed, "colmap is missing: apt-get install --no-install-recommends colmap");
            eprintln!("skipped: no colmap on this machine");
            return;
        }
        let folder = tempfile::tempdir().unwrap();
        let options = make::photos::Options { seed: 0, count: 16, width: 400, gps_noise: 0.0, poses: false };
        let (name, files) = make::photos::set(1, &options, &Marking::UNCLASSIFIED).unwrap();
        for f in files {
            let path = folder.path().join(&f.path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, f.bytes).unwrap();
        }
        let photos = poses::photos_in(&folder.path().join(&name).join("photos")).unwrap();
        let list = folder.path().join(&name).join("truth/cameras.json");
        let truth = cameras::parse(&list, &std::fs::read(&list).unwrap()).unwrap();
        let focal = f64::from(truth[0].1.fx);
        let work = folder.path().join("work");
        let shared = Some((400, 300, Some(focal)));
        // Its mapper draws at random, and about one run in twenty on these photos ends in a wrong model: up to three runs.
        let mut said = Vec::new();
        let is_right = (0..3).any(|_| {
            let (found, ran) = run(program, &photos, shared, &work, &Silent, |r| {
                Ok((poses::of_model(&r.models.join("0"))?, r.clone()))
            })
            .unwrap();
            assert!(
                ran.version.starts_with("COLMAP")
                    && ran.commands[2].contains("mapper --database_path WORK/database.db")
            );
            assert!(!work.exists() && found.points.len() > 200);
            let pairs: Vec<Pair> = found
                .photos
                .iter()
                .map(|p| {
                    let (_, camera) = truth.iter().find(|(n, _)| p.name.starts_with(n.as_str())).unwrap();
                    Pair { from: p.centre(), to: camera.position().as_dvec3(), sigma: 1.0 }
                })
                .collect();
            let s = fit(&pairs, Turn::Free).unwrap();
            let away = pairs.iter().map(|p| p.to.length()).sum::<f64>() / pairs.len() as f64;
            let worst = pairs.iter().map(|p| s.apply(p.from).distance(p.to)).fold(0.0, f64::max);
            said.push(format!("{} placed, {worst} m of {away}", pairs.len()));
            pairs.len() >= 12 && worst < 0.02 * away
        });
        assert!(is_right, "{said:?}");

        // Two photos of an even wall share nothing.
        let walls: Vec<PathBuf> = ["a.png", "b.png"].map(|n| folder.path().join(n)).to_vec();
        for wall in &walls {
            image::RgbImage::from_pixel(128, 96, image::Rgb([90; 3])).save(wall).unwrap();
        }
        let e = run(program, &walls, None, &work, &Silent, |_| Ok(())).unwrap_err();
        assert!(e.kind == crate::Kind::Usage && e.expected.contains("overlap") && !work.exists(), "{e}");
    }

    #[test]
    fn a_missing_or_failing_program_is_explained() {
        let e = version(Path::new("/nowhere/colmap")).unwrap_err();
        assert!(e.to_string().contains("/nowhere/colmap") && e.advice.contains("apt-get"), "{e}");
        let folder = tempfile::tempdir().unwrap();
        let photo = folder.path().join("a.png");
        image::RgbImage::new(4, 4).save(&photo).unwrap();
        let work = folder.path().join("work");
        // It ends with an error and says nothing.
        let e = run(Path::new("/bin/false"), &[photo], None, &work, &Silent, |_| Ok(())).unwrap_err();
        assert!(e.subject.contains("feature_extractor") && e.found.contains("exit status: 1"), "{e}");
        assert!(!work.exists(), "the work folder stayed");
    }

    #[test]
    fn the_work_folder_is_new_and_this_users_alone() {
        let folder = tempfile::tempdir().unwrap();
        let (work, photo) = (folder.path().join("work"), folder.path().join("a.png"));
        image::RgbImage::new(4, 4).save(&photo).unwrap();
        std::fs::create_dir(&work).unwrap();
        let e = run(Path::new("/bin/false"), &[photo], None, &work, &Silent, |_| Ok(())).unwrap_err();
        assert!(e.kind == crate::Kind::Environment && e.expected.contains("not there yet"), "{e}");
        assert_eq!(std::fs::read_dir(&work).unwrap().count(), 0, "it is another's: nothing goes in, and it stays");
        std::fs::remove_dir(&work).unwrap();
        let held = Work::make(&work).unwrap();
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            assert_eq!(std::fs::metadata(&work).unwrap().permissions().mode() & 0o777, 0o700);
        }
        drop(held);
        assert!(!work.exists());
    }
}
