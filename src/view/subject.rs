//! What is shown: Gaussians or levels of a mesh, and what is known about them.

use std::fs;
use std::path::{Path, PathBuf};

use glam::Vec3;
use image::{DynamicImage, RgbImage};

use super::{draw, levels};
use crate::audit::marking::Level as Classification;
use crate::audit::statement::Param;
use crate::audit::{Marking, inband, publication, verify};
use crate::export;
use crate::export::import::{self, Imported, SplatAxes};
use crate::geo::Placement;
use crate::mesh::{self, Mesh};
use crate::preview;
use crate::splat::{Gaussians, cameras};
use crate::symmetry::Basis;
use crate::{Error, Result};

/// Files that are shown, the first that is there.
const SCENES: [&str; 3] = ["ply", "spz", "glb"];
/// Sharpest pictures that a preview's first tile is cut out as.
const JPEG_QUALITY: u8 = 90;

/// A level of detail.
#[derive(Clone, Debug)]
pub struct Level {
    pub mesh: Mesh,
    pub texture: RgbImage,
}

/// One scene in the subject frame: Z up, +Y where the photo's camera pointed.
#[derive(Clone, Debug)]
pub struct Subject {
    pub name: String,
    /// `None` where no file says one.
    pub marking: Option<Marking>,
    pub gaussians: Option<Gaussians>,
    /// Finest first.
    pub levels: Vec<Level>,
    /// The finest level in the colours of where its texture comes from.
    pub provenance: Option<Level>,
    /// The finest level in the colours of how far the network expected its colours to be off.
    pub expected_error: Option<Level>,
    /// A plane of symmetry that it was mirrored at was assumed, by the record.
    pub assumed: bool,
    pub place: Option<Placement>,
    /// Lengths are metres.
    pub metric: bool,
    /// Around everything that is shown.
    pub centre: Vec3,
    pub radius: f32,
    /// The photo, a JPEG.
    pub photo: Option<Vec<u8>>,
    /// Degrees above the horizon that the photo was taken from, by the record.
    pub photo_elevation: Option<f32>,
    /// Where the heading comes from and its standard deviation in degrees, in the record's words.
    pub heading_known: Option<(String, String)>,
    /// Where the scale comes from and its standard deviation in percent, in the record's words.
    pub scale_known: Option<(String, String)>,
    /// What could not be shown, a sentence each.
    pub notes: Vec<String>,
}

impl Subject {
    /// Reads a published folder, or one file of splats or triangles.
    ///
    /// # Errors
    /// Usage for what is no scene; as [`inband::marking`] for a marking that is not understood.
    pub fn load(path: &Path) -> Result<Subject> {
        let metadata = fs::metadata(path).map_err(|e| Error::io(path, &e))?;
        if !metadata.is_dir() {
            return Subject::of_file(path, &read(path)?);
        }
        let scene = scene_in(path)?;
        let mut subject = Subject::of_file(&scene, &read(&scene)?)?;
        subject.name = file_name(&fs::canonicalize(path).unwrap_or_else(|_| path.to_owned()));
        let mut markings: Vec<Marking> = subject.marking.take().into_iter().collect();
        let sidecar = path.join(publication::MARKING_SIDECAR);
        if sidecar.is_file() {
            markings.extend(inband::marking(publication::MARKING_SIDECAR, &read(&sidecar)?)?);
        }
        match verify::read_record(path) {
            Ok((_, statement)) => {
                markings.extend(statement.marking());
                let text = |name: &str| match statement.predicate.params.get(name) {
                    Some(Param::Text(text)) => Some(text.clone()),
                    _ => None,
                };
                subject.photo_elevation =
                    text("elevation_deg").and_then(|e| e.parse().ok()).filter(|e: &f32| e.abs() <= 90.0);
                let assumed = |name| text(name).is_some_and(|basis| basis == Basis::Assumed.label());
                subject.assumed = assumed("symmetry_basis") || assumed("symmetry_second_basis");
                subject.heading_known = text("heading_source").zip(text("heading_sigma_deg"));
                subject.scale_known = text("scale_source").zip(text("scale_sigma_percent"));
            }
            Err(e) => subject.notes.push(format!("No record is shown: {e}.")),
        }
        let preview = path.join("preview.png");
        if preview.is_file() {
            let bytes = read(&preview)?;
            markings.extend(inband::marking("preview.png", &bytes)?);
            subject.photo = photo_of(&bytes);
        }
        if subject.levels.is_empty() {
            match levels::of_folder(path) {
                Ok(found) => subject.levels = found,
                Err(e) => subject.notes.push(format!("Levels of detail are not shown: {e}.")),
            }
        }
        let finest = subject.levels.first().cloned();
        let mut of_finest =
            |name: &str, what: &str, shown: &dyn Fn(DynamicImage, &Level) -> RgbImage| -> Result<Option<Level>> {
                let file = path.join(name);
                let (true, Some(finest)) = (file.is_file(), &finest) else { return Ok(None) };
                let bytes = read(&file)?;
                markings.extend(inband::marking(name, &bytes)?);
                match image::load_from_memory(&bytes) {
                    Ok(picture) => Ok(Some(Level { mesh: finest.mesh.clone(), texture: shown(picture, finest) })),
                    Err(e) => {
                        subject.notes.push(format!("{what} is not shown: {e}."));
                        Ok(None)
                    }
                }
            };
        let sources =
            |shares: DynamicImage, finest: &Level| mesh::provenance::shown(&shares.into_rgb8(), &finest.texture);
        let errors = |errors: DynamicImage, _: &Level| preview::error_colours(&errors.into_luma8());
        let provenance = of_finest(export::PROVENANCE, "Where the texture comes from", &sources)?;
        let expected_error = of_finest(export::EXPECTED_ERROR, "The expected error", &errors)?;
        (subject.provenance, subject.expected_error) = (provenance, expected_error);
        subject.marking = (!markings.is_empty()).then(|| Marking::join_all(&markings));
        Ok(subject)
    }

    fn of_file(path: &Path, bytes: &[u8]) -> Result<Subject> {
        let name = file_name(path);
        let marking = inband::marking(&name, bytes).map_err(|e| Error { subject: name.clone(), ..e })?;
        // Of a photo that was neither placed nor scaled.
        let head = &bytes[..bytes.len().min(4096)];
        let unit = head.windows(UNIT_FRAME.len()).any(|w| w == UNIT_FRAME.as_bytes());
        let Imported { gaussians, levels, place, is_orbs } =
            import::read(&name, bytes, unit.then_some(SplatAxes::ZUp))?;
        let metric = is_orbs || !levels.is_empty();
        let levels: Vec<Level> = levels.iter().map(|l| levels::level(&l.mesh, l.texture.clone())).collect();
        let around = match (&gaussians, levels.first()) {
            (Some(g), _) if !g.positions.is_empty() => Some(cameras::ball(g)),
            (_, Some(level)) => {
                let (low, high) = level.mesh.bounds();
                Some(((low + high) / 2.0, (high - low).length() / 2.0))
            }
            _ => None,
        };
        let Some((centre, radius)) = around.filter(|(c, r)| c.is_finite() && r.is_finite() && *r > 0.0) else {
            return Err(Error::usage(name).expected("a scene that can be seen").found("nothing in it"));
        };
        Ok(Subject {
            name,
            marking,
            gaussians,
            levels,
            provenance: None,
            expected_error: None,
            assumed: false,
            place,
            metric,
            centre,
            radius,
            photo: None,
            photo_elevation: None,
            heading_known: None,
            scale_known: None,
            notes: Vec::new(),
        })
    }

    /// What stands above and below every picture: never nothing.
    pub fn banner(&self) -> String {
        self.marking.as_ref().map_or_else(|| "UNMARKED".into(), Marking::banner)
    }

    /// A word for the banner's colour.
    pub fn colour(&self) -> &'static str {
        match self.marking.as_ref().map(Marking::level) {
            None => "unmarked",
            Some(Classification::Unclassified) => "unclassified",
            Some(Classification::Cui) => "cui",
            Some(Classification::Confidential) => "confidential",
            Some(Classification::Secret) => "secret",
            Some(Classification::TopSecret) => "top-secret",
        }
    }
}

/// How the header of a scene begins that was neither placed nor scaled.
const UNIT_FRAME: &str = "comment frame: unit, right-handed, Z up";

fn read(path: &Path) -> Result<Vec<u8>> {
    fs::read(path).map_err(|e| Error::io(path, &e))
}

fn file_name(path: &Path) -> String {
    path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default()
}

/// `scene.ply`, else the first by name of the best kind.
fn scene_in(folder: &Path) -> Result<PathBuf> {
    let own = folder.join("scene.ply");
    if own.is_file() {
        return Ok(own);
    }
    let entries = fs::read_dir(folder).map_err(|e| Error::io(folder, &e))?;
    let mut files: Vec<PathBuf> = entries.filter_map(|e| Some(e.ok()?.path())).filter(|p| p.is_file()).collect();
    files.sort();
    let kind = |p: &PathBuf| {
        let ending = p.extension()?.to_string_lossy().to_ascii_lowercase();
        SCENES.iter().position(|s| *s == ending)
    };
    files.into_iter().filter(|p| kind(p).is_some()).min_by_key(kind).ok_or_else(|| {
        Error::usage(folder.display().to_string())
            .expected("scene.ply, or a .ply, .spz or .glb file")
            .found("none")
            .advice("Name a folder that `orb geo`, `orb reconstruct` or `orb export` published.")
    })
}

/// The first tile of a preview, without the paper around it.
fn photo_of(sheet: &[u8]) -> Option<Vec<u8>> {
    let sheet = image::load_from_memory(sheet).ok()?.into_rgb8();
    let photo = preview::first_tile(&sheet)?;
    draw::jpeg(photo.as_raw(), photo.width(), photo.height(), JPEG_QUALITY).ok()
}
