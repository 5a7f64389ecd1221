//! What a reconstruction begins with: one photo, or a folder of them with its options, its poses, its places on the Earth.

mod options;
mod set;

pub use options::{PhotosArgs, Sfm};
pub use set::{Set, line_of};

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use glam::DVec3;

use super::marking;
use crate::audit::statement::{Input, Param};
use crate::audit::{Marking, record};
use crate::geo::{AltDatum, Geodetic, to_ellipsoid};
use crate::models::Rten;
use crate::photo::{self, AltitudeAbove, Exif, Photo, focal_in_pixels};
use crate::photos::register::{self, Fix};
use crate::photos::{Posed, Poses, control, poses, sfm};
use crate::pipeline::several::{self, Options, Role, Scores, Several};
use crate::pipeline::{self, Fitted, Settings, unposed};
use crate::progress::Progress;
use crate::sources::Sources;
use crate::{Error, Result, splat};

/// What a receiver in a camera or drone is good to where the photo does not say.
const GNSS_SIGMA: f64 = 5.0;
/// Found on the path.
const COLMAP: &str = "colmap";
/// Up is taken from the Earth where it is known as well as this, degrees; else from the photos.
const UP_SIGMA: f64 = 1.0;

/// One photo, or a folder of them: read, but nothing made of it yet.
pub enum Front {
    One { photo: Box<Photo>, inputs: Vec<Input>, carried: Vec<Option<Marking>> },
    Several(Box<Folder>),
}

impl Front {
    /// # Errors
    /// As [`photo::decode`] and [`open`]; an option that the other kind has.
    pub fn open(path: &Path, args: &PhotosArgs) -> Result<Front> {
        let several = path.is_dir();
        args.check(several)?;
        if several {
            return Ok(Front::Several(Box::new(open(path, args)?)));
        }
        let limits = photo::Limits::default();
        let bytes = super::geo::read_photo(path, limits.file_bytes)?;
        let name = name_of(path);
        let mut photo = photo::decode(&name, &bytes, &limits)?;
        photo.exif = photo.exif.with_focal(args.focal);
        let carried = marking::carried(&name, &bytes)?;
        let input = record::input(&name, &bytes, photo.media_type, "photo", carried.clone());
        Ok(Front::One { photo: Box::new(photo), inputs: vec![input], carried: vec![carried] })
    }

    pub fn one(&self) -> Option<&Photo> {
        match self {
            Front::One { photo, .. } => Some(photo),
            Front::Several(_) => None,
        }
    }

    /// Of the photo; of several, of one that has a place, if any has.
    pub fn exif(&self) -> &Exif {
        match self {
            Front::One { photo, .. } => &photo.exif,
            Front::Several(f) => {
                let mut all = f.exif.values();
                let placed = |e: &&Exif| e.position.is_some_and(|p| p.altitude.is_some());
                all.clone().find(placed).or(all.next()).unwrap_or(&f.nothing)
            }
        }
    }

    pub fn inputs(&self) -> &[Input] {
        match self {
            Front::One { inputs, .. } => inputs,
            Front::Several(folder) => &folder.inputs,
        }
    }

    /// What the inputs are marked.
    pub fn carried(&self) -> &[Option<Marking>] {
        match self {
            Front::One { carried, .. } => carried,
            Front::Several(folder) => &folder.carried,
        }
    }

    /// Finds the poses where nobody gave them. Takes its time: the output folder was looked at before.
    ///
    /// # Errors
    /// As [`sfm::run`] and [`unposed::search`].
    pub fn pose(&mut self, args: &PhotosArgs, progress: &dyn Progress) -> Result<()> {
        match (self, args.sfm) {
            (Front::Several(folder), Some(Sfm::Colmap)) => folder.run_colmap(progress),
            (Front::Several(folder), None) if folder.poses.is_none() => folder.search(progress),
            _ => Ok(()),
        }
    }

    /// Whether there are control points: then no photo needs a place of its own.
    pub fn has_control(&self) -> bool {
        matches!(self, Front::Several(folder) if folder.control.is_some())
    }

    /// The version of COLMAP, where it ran.
    pub fn colmap(&self) -> Option<&str> {
        match self {
            Front::One { .. } => None,
            Front::Several(folder) => folder.ran.as_ref().map(|r| r.version.as_str()),
        }
    }

    /// What is known of the photos' places together; nothing of one.
    ///
    /// # Errors
    /// As [`Folder::fixes`].
    pub fn fixes(&self, datum: Option<AltDatum>) -> Result<Vec<Fix>> {
        match self {
            Front::One { .. } => Ok(Vec::new()),
            Front::Several(folder) => folder.fixes(datum),
        }
    }

    /// The Gaussians, and the photo that their frame is of. `sources` are for one photo.
    ///
    /// # Errors
    /// As [`pipeline::fit`] and [`several::fit`].
    pub fn fit(
        &self,
        sources: &Sources,
        args: &PhotosArgs,
        fixes: &[Fix],
        fitter: splat::Engine,
        settings: &Settings,
        progress: &dyn Progress,
    ) -> Result<(Photo, Fitted)> {
        match self {
            Front::One { photo, .. } => {
                let fitted = pipeline::fit(photo, &Rten, sources, fitter, settings, progress)?;
                Ok(((**photo).clone(), fitted))
            }
            Front::Several(folder) => {
                let options = Options { searched: folder.searched, ..options(args, fixes, settings.seed) };
                let options = Options { refine_poses: options.refine_poses || folder.searched, ..options };
                let photo = |posed: &Posed| folder.recorded(&posed.file);
                several::fit(folder.posed()?, &photo, &Rten, fitter, settings, &options, progress)
            }
        }
    }

    /// For the record.
    pub fn params(&self, done: Option<&Several>) -> Vec<(String, Param)> {
        match (self, done) {
            (Front::Several(folder), Some(s)) => folder.params(s),
            _ => Vec::new(),
        }
    }

    /// For a person.
    pub fn lines(&self, done: Option<&Several>) -> Vec<(&'static str, String)> {
        match (self, done) {
            (Front::Several(folder), Some(s)) => folder.poses.as_ref().map(|p| lines(p, s)).unwrap_or_default(),
            _ => Vec::new(),
        }
    }
}

/// The file's own name, without its folder.
pub(super) fn name_of(path: &Path) -> String {
    path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default()
}

/// Photos that were read once, for the record, and their poses.
pub struct Folder {
    files: Vec<PathBuf>,
    /// By the photos' names.
    exif: BTreeMap<String, Exif>,
    nothing: Exif,
    /// Every photo that goes in, and the files that say poses and control points.
    inputs: Vec<Input>,
    carried: Vec<Option<Marking>>,
    poses: Option<Poses>,
    ran: Option<sfm::Run>,
    /// The poses were searched, and say nothing of lenses and lengths.
    searched: bool,
    /// Name and text of the control points.
    control: Option<(String, String)>,
}

/// Reads every file that goes in, and the poses where somebody gave them.
///
/// # Errors
/// As [`poses::find`]; a photo or marking that cannot be read.
fn open(folder: &Path, args: &PhotosArgs) -> Result<Folder> {
    let (poses, files) = match args.sfm {
        Some(Sfm::Colmap) => {
            sfm::version(Path::new(COLMAP))?;
            (None, poses::photos_in(folder)?)
        }
        None => {
            let files = poses::photos_in(folder)?;
            match poses::find(folder, args.poses.as_deref())? {
                Some(found) => {
                    let files = found.photos.iter().map(|p| p.file.clone()).collect();
                    (Some(found), files)
                }
                None if files.len() <= unposed::MOST => (None, files),
                None => return Err(Error::usage(folder.display().to_string())
                    .expected(
                        "poses of the photos: a COLMAP model (sparse/0) or transforms.json in the folder or beside it",
                    )
                    .found("none")
                    .advice("Give --poses PATH, or let COLMAP compute them: --sfm colmap.")),
            }
        }
    };
    let files = files.into_iter().map(|f| (name_of(&f), f)).collect();
    Folder::read(files, poses, args)
}

impl Folder {
    /// Reads files by their names for the record.
    fn read(files: Vec<(String, PathBuf)>, poses: Option<Poses>, args: &PhotosArgs) -> Result<Folder> {
        let limits = photo::Limits::default();
        let (mut inputs, mut carried, mut exif) = (Vec::new(), Vec::new(), BTreeMap::new());
        for (name, file) in &files {
            let name = name.clone();
            let bytes = super::geo::read_photo(file, limits.file_bytes)?;
            let (tags, media_type) = photo::metadata(&name, &bytes, &limits)?;
            let marked = marking::carried(&name, &bytes)?;
            inputs.push(record::input(&name, &bytes, media_type, "photo", marked.clone()));
            carried.push(marked);
            exif.insert(name, tags);
        }
        if let Some(p) = &poses {
            inputs.extend(pose_inputs(&p.files)?);
        }
        let control = match &args.gcp {
            None => None,
            Some(path) => {
                let bytes =
                    std::fs::read(path).map_err(|e| Error::io(path, &e).advice("Check the control points' path."))?;
                let name = name_of(path);
                inputs.push(record::input(&name, &bytes, "text/csv", "control-points", None));
                let text = String::from_utf8(bytes)
                    .map_err(|e| Error::usage(&name).expected("UTF-8 text").found(e.utf8_error().to_string()))?;
                Some((name, text))
            }
        };
        let files = files.into_iter().map(|f| f.1).collect();
        Ok(Folder {
            files,
            exif,
            nothing: Exif::default(),
            inputs,
            carried,
            poses,
            ran: None,
            searched: false,
            control,
        })
    }
}

fn pose_inputs(files: &[PathBuf]) -> Result<Vec<Input>> {
    let of = |file: &PathBuf| {
        let bytes = std::fs::read(file).map_err(|e| Error::io(file, &e))?;
        let name = name_of(file);
        let media_type = if name.ends_with(".json") { "application/json" } else { "application/octet-stream" };
        Ok(record::input(&name, &bytes, media_type, "poses", None))
    };
    files.iter().map(of).collect()
}

impl Folder {
    /// The poses.
    ///
    /// # Errors
    /// Environment where nobody has found any yet.
    fn posed(&self) -> Result<&Poses> {
        self.poses.as_ref().ok_or_else(|| Error::environment("photos").expected("poses").found("none"))
    }

    fn run_colmap(&mut self, progress: &dyn Progress) -> Result<()> {
        // Nobody else can have made a folder of this name, and no run that was killed has left it.
        let mut own = [0; 16];
        getrandom::fill(&mut own).map_err(|e| Error::environment("random numbers").found(e.to_string()))?;
        let work = std::env::temp_dir().join(format!("orb-colmap-{}", hex::encode(own)));
        let folder = self.files.first().and_then(|f| f.parent()).unwrap_or(Path::new(".")).to_owned();
        let shared = self.shared()?;
        let (poses, inputs, ran) = sfm::run(Path::new(COLMAP), &self.files, shared, &work, progress, |run| {
            let found = poses::find(&folder, Some(&run.models))?
                .ok_or_else(|| Error::usage("--sfm colmap").expected("a model").found("none"))?;
            let inputs = pose_inputs(&found.files)?;
            Ok((Poses { source: format!("{}, run on the photos", run.version), ..found }, inputs, run.clone()))
        })?;
        self.inputs.extend(inputs);
        (self.poses, self.ran) = (Some(poses), Some(ran));
        Ok(())
    }

    fn search(&mut self, progress: &dyn Progress) -> Result<()> {
        let photo = |file: &PathBuf| self.recorded(file);
        let found = unposed::search(&self.files, &photo, &Rten, progress)?;
        (self.poses, self.searched) = (Some(found), true);
        Ok(())
    }

    /// Whether one camera took all photos, with one zoom.
    fn shared(&self) -> Result<sfm::Shared> {
        let mut all = Vec::new();
        for file in &self.files {
            let size = image::image_dimensions(file)
                .map_err(|e| Error::usage(file.display().to_string()).expected("a photo").found(e.to_string()))?;
            all.push((size, self.exif.get(&name_of(file)).and_then(|e| e.focal_35mm)));
        }
        let Some(&((w, h), focal)) = all.first() else { return Ok(None) };
        let pixels = focal.map(|f| focal_in_pixels(f, w, h));
        Ok(all.iter().all(|a| *a == all[0]).then_some((w, h, pixels)))
    }

    /// For the record.
    fn params(&self, s: &Several) -> Vec<(String, Param)> {
        let mut all = self.poses.as_ref().map(|p| params(p, s)).unwrap_or_default();
        all.extend(self.ran_params());
        all
    }

    /// What COLMAP did, where it ran.
    fn ran_params(&self) -> Vec<(String, Param)> {
        let text = |name: &str, words: &str| (name.to_owned(), Param::Text(record::printable(words)));
        let ran = self.ran.iter();
        ran.flat_map(|r| [text("sfm_program", &r.version), text("sfm_commands", &r.commands.join("; "))]).collect()
    }

    /// The photo of a file, its rows as the file has them.
    ///
    /// # Errors
    /// As [`photo::decode_as_stored`]; integrity where the file is another than the one that was recorded.
    fn recorded(&self, file: &Path) -> Result<Photo> {
        let limits = photo::Limits::default();
        let posed = self.poses.iter().flat_map(|p| &p.photos).find(|p| p.file == file);
        let name = posed.map_or_else(|| name_of(file), |p| p.name.clone());
        let bytes = super::geo::read_photo(file, limits.file_bytes)?;
        let (photo, _) = photo::decode_as_stored(&name, &bytes, &limits)?;
        let recorded = self.inputs.iter().find(|i| i.role == "photo" && i.name == record::printable(&name));
        match recorded {
            Some(i) if i.sha256 == hex::encode(photo.sha256) => Ok(photo),
            _ => Err(Error::new(crate::Kind::Integrity, file.display().to_string())
                .expected("the photo as it was when the run began")
                .found("another")),
        }
    }

    /// The photos' places on the Earth, as their receivers wrote them, and the control points. `datum` is what altitudes are above where the photo
    /// does not say it.
    ///
    /// # Errors
    /// As [`to_ellipsoid`].
    pub fn fixes(&self, datum: Option<AltDatum>) -> Result<Vec<Fix>> {
        let mut out = Vec::new();
        let photos = &self.posed()?.photos;
        if self.searched {
            return Ok(out);
        }
        for posed in photos {
            let Some(p) = self.exif.get(&posed.name).and_then(|e| e.position) else { continue };
            let Some(altitude) = p.altitude else { continue };
            let own = if p.altitude_above == AltitudeAbove::Ellipsoid { AltDatum::Ellipsoid } else { AltDatum::Msl };
            let datum = datum.filter(|d| *d != AltDatum::Ground).unwrap_or(own);
            let horizontal = p.accuracy.unwrap_or(GNSS_SIGMA);
            let vertical = p.vertical_accuracy.unwrap_or(2.0 * horizontal);
            let height = to_ellipsoid((p.latitude, p.longitude), altitude, vertical, datum, None)?;
            out.push(Fix {
                name: posed.name.clone(),
                at: posed.centre(),
                place: Geodetic { latitude: p.latitude, longitude: p.longitude, height: height.ellipsoidal },
                horizontal,
                vertical: height.sigma,
                control: false,
            });
        }
        if let Some((name, text)) = &self.control {
            let datum = datum.filter(|d| *d != AltDatum::Ground).unwrap_or(AltDatum::Ellipsoid);
            out.extend(control::read(name, text, photos, datum)?);
        }
        Ok(out)
    }
}

/// What the pipeline is told.
fn options(args: &PhotosArgs, fixes: &[Fix], seed: u64) -> Options {
    let up: Option<DVec3> = register::up(fixes, seed).filter(|(_, sigma)| *sigma < UP_SIGMA).map(|(up, _)| up);
    Options { refine_poses: args.refine_poses, up, searched: false }
}

fn params(poses: &Poses, s: &Several) -> Vec<(String, Param)> {
    let text = |v: String| Param::Text(v);
    let with = |role: fn(&Role) -> bool| s.photos.iter().filter(|p| role(&p.role)).count() as i64;
    let mut all = vec![
        ("poses".into(), text(record::printable(&poses.source))),
        ("photos_posed".into(), Param::Int(poses.photos.len() as i64)),
        ("photos_trained_on".into(), Param::Int(with(|r| *r == Role::Trained))),
        ("photos_held_out".into(), Param::Int(with(|r| *r == Role::HeldOut))),
        ("photos_left_out".into(), Param::Int(with(|r| matches!(r, Role::LeftOut(_))))),
        ("reference_photo".into(), text(record::printable(&poses.photos[s.reference].name))),
        ("up_from".into(), text(s.up_by.label().into())),
        ("network_silhouette_iou".into(), text(format!("{:.4}", s.network_iou))),
        ("trained_psnr_db".into(), text(format!("{:.3}", s.trained.psnr))),
        ("trained_ssim".into(), text(format!("{:.4}", s.trained.ssim))),
        ("world_to_unit".into(), text(s.to_unit.to_string())),
    ];
    if s.held_out.photos > 0 {
        all.push(("held_out_psnr_db".into(), text(format!("{:.3}", s.held_out.psnr))));
        all.push(("held_out_ssim".into(), text(format!("{:.4}", s.held_out.ssim))));
        all.push(("held_out_silhouette_iou".into(), text(format!("{:.4}", s.held_out.silhouette_iou))));
    }
    if let Some(g) = &s.ground {
        all.push(("ground_points".into(), text(format!("{} of {}", g.on_it, g.of))));
    }
    if let Some((turn, shift)) = s.refined {
        all.push(("poses_refined_most_deg".into(), text(format!("{turn:.4}"))));
        all.push(("poses_refined_most_shift".into(), text(format!("{shift:.5}"))));
    }
    all
}

/// What was used, and how well the result meets photos that it never saw.
fn lines(poses: &Poses, s: &Several) -> Vec<(&'static str, String)> {
    let with = |role: fn(&Role) -> bool| s.photos.iter().filter(|p| role(&p.role)).count();
    let trained = with(|r| *r == Role::Trained);
    let mut out = vec![(
        "poses",
        std::iter::once(poses.source.clone()).chain(poses.notes.clone()).collect::<Vec<_>>().join("; "),
    )];
    let scores = |n: usize, s: &Scores| {
        format!("{n}, PSNR {:.1} dB, SSIM {:.3}, silhouettes {:.3}", s.psnr, s.ssim, s.silhouette_iou)
    };
    out.push(("trained on", scores(trained, &s.trained)));
    if s.held_out.photos > 0 {
        out.push(("held out", scores(s.held_out.photos, &s.held_out)));
    }
    for p in &s.photos {
        if let Role::LeftOut(why) = &p.role {
            out.push(("left out", format!("{}: {why}", p.name)));
        }
    }
    out
}
