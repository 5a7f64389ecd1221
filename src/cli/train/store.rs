//! `--format cdb`: the scene as a CDB store of its own or in one that is there: the ground as terrain and imagery, what stands on
//! it as models.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use orb_formats::File;
use orb_formats::cdb::{self, Memory, Store};

use super::Placed;
use super::around::Around;
use super::ground::Ground;
use crate::audit::Publication;
use crate::audit::statement::Param;
use crate::cli::format::OpenStore;
use crate::export::{self, Catalogue, Labels, OnEarth};
use crate::pipeline::scene::Scene;
use crate::pipeline::scene::bodies::{self, Body};
use crate::pipeline::scene::ground::Surface;
use crate::pipeline::scene::nadir::{self, Nadir};
use crate::progress::Progress;
use crate::splat::Gaussians;
use crate::{Error, Result};

/// What the store holds, for who is told.
pub struct Stored {
    /// The published store, or the one that was there.
    pub place: String,
    pub lods: [i8; 2],
    /// Square metres inside the outline, and the share of its cells that have Gaussians of their own.
    pub area: f64,
    pub measured: f64,
    /// Metres: a cell of the surface, a pixel of the photos on it, the width of the band around it, the height around.
    pub cell: f64,
    pub pixel: f64,
    pub band: f64,
    pub level: f64,
    /// The terrain around it, and by how much the ground lies above it where photos saw it, metres: median, quartiles.
    pub against: Option<(String, f64, [f64; 2])>,
    /// Models, and bodies that none was made of.
    pub models: usize,
    pub left: usize,
}

/// Lower bodies are left in the imagery, metres.
const LEAST_HEIGHT: f64 = 1.0;

/// What is added to a store, in memory, over what is there; knows the kinds of its files.
#[derive(Default)]
struct Growing {
    there: Option<OpenStore>,
    store: Memory,
    kinds: BTreeMap<String, &'static str>,
}

impl Growing {
    fn take(&mut self, files: Vec<File>) {
        self.kinds.extend(files.iter().map(|f| (f.path.clone(), f.media_type)));
        self.store.write(files);
    }

    /// Into the publication, or into the store that is there.
    fn publish(self, stem: &str, folders: &[String], publication: &mut Publication) -> Result<()> {
        let kinds = self.kinds;
        let kind = |path: &str| kinds.get(path).copied().unwrap_or("application/octet-stream");
        if let Some(there) = self.there {
            let file = |(path, bytes): (String, Vec<u8>)| File { media_type: kind(&path), path, bytes };
            let files: Vec<File> = self.store.files.into_iter().map(file).collect();
            return there.merge(&files, folders, publication);
        }
        for folder in folders {
            publication.add_folder(&format!("{stem}.cdb/{folder}"))?;
        }
        for (path, bytes) in &self.store.files {
            publication.add(&format!("{stem}.cdb/{path}"), bytes, kind(path), "cdb")?;
        }
        Ok(())
    }
}

impl Store for Growing {
    fn read(&self, path: &str) -> std::io::Result<Option<Vec<u8>>> {
        match (self.store.files.get(path), &self.there) {
            (Some(bytes), _) => Ok(Some(bytes.clone())),
            (None, Some(there)) => there.read(path),
            (None, None) => Ok(None),
        }
    }

    fn exists(&self, path: &str) -> std::io::Result<bool> {
        match &self.there {
            Some(there) if !self.store.files.contains_key(path) => there.exists(path),
            _ => Ok(self.store.files.contains_key(path)),
        }
    }

    fn size(&self, path: &str) -> std::io::Result<Option<u64>> {
        match (self.store.files.get(path), &self.there) {
            (Some(bytes), _) => Ok(Some(bytes.len() as u64)),
            (None, Some(there)) => there.size(path),
            (None, None) => Ok(None),
        }
    }
}

/// How it is made.
pub struct How<'a> {
    /// Models, at most.
    pub most: usize,
    /// The store to add to; a new one where there is none.
    pub into: Option<&'a Path>,
    /// Terrain around it.
    pub around: Option<&'a Around>,
    pub progress: &'a dyn Progress,
    pub say: &'a dyn Fn(&str),
}

/// Puts `scene.cdb` into the publication, or its files into the store that was named.
///
/// # Errors
/// Usage where there is no ground to speak of; what the writer and the publication refuse.
pub fn publish(
    done: &Scene,
    ground: &Ground,
    placed: &Placed,
    labels: &Labels,
    publication: &mut Publication,
    &How { most, into, around, progress, say }: &How,
) -> Result<Stored> {
    let Ground { near, is_ground, cameras, .. } = ground;
    let surface = ground.surface(done, is_ground)?;
    let scale = placed.registration.to_enu.scale;
    let all = bodies::of(&done.gaussians, *near, is_ground, &surface, (LEAST_HEIGHT / scale) as f32);
    let chosen = &all[..all.len().min(most)];
    let mut surface = ground.surface(done, &bodies::cleared(is_ground, chosen))?;
    let earth = OnEarth::new(&placed.registration);
    let height = |latitude: f64, longitude: f64| around.and_then(|a| a.height(latitude, longitude));
    let spacing = around.map_or([1.0; 2], |a| a.spacing(placed.registration.origin));
    let depth =
        |latitude: f64, longitude: f64| around.map_or(f64::NEG_INFINITY, |a| a.depth(latitude, longitude, spacing));
    let known = around.map(|_| export::Around::new(&surface, &earth, &height, &depth));
    let against = around.zip(known.as_ref()).and_then(|(a, known)| {
        if known.ends {
            say(&format!(
                "{} ends within the scene's terrain, or has a hole there: over {:.1} m before it goes over into what is around without it",
                a.name,
                f64::from(surface.band) * scale
            ));
        }
        let found = export::fill_from(&mut surface, &earth, known)?;
        let metres = |v: f32| f64::from(v) * scale;
        Some((a.name.clone(), metres(found.median), found.quartiles.map(metres)))
    });
    let lods = export::levels(&surface, &earth)?;
    let pixel = (export::pixel_of(lods[1]) / scale) as f32;
    let marking = labels.marking.line();
    let mut grown = Growing { there: into.map(OpenStore::open).transpose()?, ..Growing::default() };
    let (mut files, mut folders) = cdb::new_store(&marking, "made by Orb");
    if let Some(there) = &grown.there {
        // What a store has of its own stays.
        let has =
            |f: &File| there.exists(&f.path).map_err(|e| Error::environment(f.path.as_str()).found(e.to_string()));
        let kept = files.iter().map(has).collect::<Result<Vec<bool>>>()?;
        if kept.contains(&true) {
            folders.clear();
        }
        let mut kept = kept.into_iter();
        files.retain(|_| kept.next() != Some(true));
    }
    grown.take(files);

    let seen = nadir::as_seen(&done.gaussians, cameras);
    progress.begin("models", chosen.len() as u64);
    let mut modelled: BTreeSet<usize> = BTreeSet::new();
    let mut models = 0;
    for (k, body) in chosen.iter().enumerate() {
        match model(&seen, body, &surface, &earth, &format!("{}_{:02}", labels.stem, k + 1), labels, (&grown, progress))
        {
            Ok(added) => {
                grown.take(added.files);
                modelled.extend(body.members.iter().chain(&body.feet));
                models += 1;
            }
            Err(e) => {
                progress.check()?;
                say(&format!("no model of what stands at {}: {e}", body.middle));
            }
        }
        progress.step(k as u64 + 1);
    }
    // What has become a model is not in the imagery below it, all else is.
    let ceiling = ground.ceiling();
    let drawn = seen.filtered(|i| i < *near && seen.positions[i].z < ceiling && !modelled.contains(&i));
    let picture = Nadir::of(&drawn, surface.bounds(), pixel);
    let patch = export::add_terrain(&grown, &surface, &picture, &earth, known.as_ref(), lods, labels)?;
    patch.notes.iter().for_each(|n| say(n));
    grown.take(patch.files);
    grown.publish(&labels.stem, &folders, publication)?;
    let metres = |v: f32| f64::from(v) * scale;
    Ok(Stored {
        place: into.map_or_else(|| format!("{}.cdb", labels.stem), |p| p.display().to_string()),
        lods,
        area: f64::from(surface.area()) * scale * scale,
        measured: surface.measured as f64 / surface.inside.max(1) as f64,
        cell: metres(surface.cell),
        pixel: metres(surface.pixel),
        band: metres(surface.band),
        level: patch.level,
        against,
        models,
        left: all.len() - models,
    })
}

/// Stops with another, and says nothing of its own stages.
struct Within<'a>(&'a dyn Progress);

impl Progress for Within<'_> {
    fn begin(&self, _: &'static str, _: u64) {}
    fn step(&self, _: u64) {}
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}

/// A body as a model of the store, standing on the terrain.
fn model(
    seen: &Gaussians,
    body: &Body,
    surface: &Surface,
    earth: &OnEarth,
    name: &str,
    labels: &Labels,
    (store, progress): (&dyn Store, &dyn Progress),
) -> Result<cdb::Added> {
    let (levels, placement) = export::standing(seen, body, surface, earth, &Within(progress))?;
    let labels = Labels { stem: name.into(), ..labels.clone() };
    let model = export::cdb_model(&levels, &placement, &labels, &Catalogue::default());
    cdb::add_model(store, &model).map_err(export::format_error)
}

impl Stored {
    /// For a person.
    pub fn words(&self) -> String {
        let [terrain, imagery] = self.lods;
        format!(
            "{}: {} models{}; {:.0} m² of ground seen, {:.0} % of it measured, the rest filled in; terrain to LOD {terrain} ({:.2} m), \
             imagery to LOD {imagery} ({:.2} m); over {:.1} m around it into {}{:.2} m above the ellipsoid (invented)",
            self.place,
            self.models,
            if self.left > 0 { format!(", {} more bodies left in the imagery", self.left) } else { String::new() },
            self.area,
            100.0 * self.measured,
            export::pixel_of(terrain),
            export::pixel_of(imagery),
            self.band,
            self.against_words(),
            self.level
        )
    }

    fn against_words(&self) -> String {
        match &self.against {
            None => String::new(),
            Some((name, median, [low, high])) => format!(
                "{name}, which lies {:.2} m {} the ground that was seen (median; its quarters {low:.2} to {high:.2}), and where that \
                 ends ",
                median.abs(),
                if *median < 0.0 { "above" } else { "below" },
            ),
        }
    }

    /// For the record.
    pub fn params(&self) -> Vec<(String, Param)> {
        let text = |v: String| Param::Text(v);
        vec![
            ("store".into(), text(crate::audit::record::printable(&self.place))),
            ("terrain_lod".into(), Param::Int(self.lods[0].into())),
            ("imagery_lod".into(), Param::Int(self.lods[1].into())),
            ("terrain_area_m2".into(), text(format!("{:.1}", self.area))),
            ("terrain_measured_share".into(), text(format!("{:.3}", self.measured))),
            ("terrain_cell_m".into(), text(format!("{:.4}", self.cell))),
            ("terrain_band_m".into(), text(format!("{:.3}", self.band))),
            ("terrain_around_m".into(), text(format!("{:.3} (invented)", self.level))),
            (
                "terrain_around_from".into(),
                text(match &self.against {
                    None => "nothing".into(),
                    Some((name, ..)) => crate::audit::record::printable(name),
                }),
            ),
            (
                "terrain_above_around_m".into(),
                text(match &self.against {
                    None => "unknown".into(),
                    Some((_, median, [low, high])) => format!("{median:.3} (quarters {low:.3} to {high:.3})"),
                }),
            ),
            ("models".into(), Param::Int(self.models as i64)),
            ("bodies_left_in_imagery".into(), Param::Int(self.left as i64)),
            ("photo_pixel_on_ground_m".into(), text(format!("{:.4}", self.pixel))),
        ]
    }

    /// For programs.
    pub fn json(&self) -> serde_json::Value {
        serde_json::json!({
            "place": self.place, "terrain_lod": self.lods[0], "imagery_lod": self.lods[1], "area_m2": self.area, "measured_share": self.measured,
            "models": self.models, "bodies_left_in_imagery": self.left, "cell_m": self.cell, "photo_pixel_m": self.pixel, "band_m": self.band, "around_ellipsoidal_height_m": self.level,
            "around": self.against.as_ref().map(|(name, median, quartiles)| serde_json::json!({"file": name, "ground_above_it_m": median, "quartiles_m": quartiles})),
        })
    }
}
